// SPDX-License-Identifier: MIT
/// Takes the place of the virtual board's programmable logic: shows the emulated accelerator in the
/// file that is the machine's memory. It prints one line for each event:
///
///     words WORD…     the parameter words have changed
///     interrupt N     the reader must raise the interrupt for the Nth time
///
/// It ends when its standard input ends.
#include "drivers/atomic_file.hpp"
#include "emulation/block_in_memory.hpp"
#include "emulation/emulated_block.hpp"
#include "engine/models.hpp"
#include "pictures/picture_file.hpp"

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sysexits.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <string>

namespace raymarch
{
namespace
{

constexpr std::size_t page_words = protocol::register_page_bytes / sizeof(std::uint32_t);
/// The pause between two steps; a register access of the machine takes about as long.
constexpr std::chrono::milliseconds pause{1};

struct Options
{
    std::string memory;
    std::uint64_t address = 0; ///< the offset of the register page in the file
    std::string accelerator = "marcher";
    std::string picture;
    unsigned width = 160;
    unsigned height = 120;
};

int report(const Error& error, int status)
{
    fmt::print(stderr, "board_player: {}\n", error.message);
    return status;
}

emulation::FrameSink picture_to(const std::string& path)
{
    if (path.empty())
        return {};
    return [path](const engine::Image& image) {
        const auto bytes = pictures::encode(image, pictures::PictureFormat::Png);
        const auto written =
            bytes ? drivers::replace_file(path, *bytes, drivers::Durability::BestEffort)
                  : Result<void>(fail(bytes.error()));
        if (!written)
            report(written.error(), EX_IOERR);
    };
}

std::string words_line(drivers::RegisterBus& block, const protocol::Accelerator& accelerator)
{
    std::string line = "words";
    for (std::size_t i = 0; i < accelerator.word_count; ++i)
        line += fmt::format(
            " {:08X}",
            block.read({static_cast<std::uint16_t>(accelerator.first_word_offset + 4 * i)}));
    return line;
}

int play(const Options& options)
{
    const protocol::Accelerator* const accelerator =
        protocol::find_accelerator(std::string_view(options.accelerator));
    if (accelerator == nullptr)
        return report(
            plain_error(ErrorKind::Usage, "no accelerator is called " + options.accelerator),
            EX_USAGE);
    const UniqueFd file(::open(options.memory.c_str(), O_RDWR | O_CLOEXEC));
    if (!file)
        return report(errno_error(ErrorKind::InputOutput, "open", options.memory), EX_IOERR);
    void* const base = ::mmap(nullptr, protocol::register_page_bytes, PROT_READ | PROT_WRITE,
                              MAP_SHARED, file.get(), static_cast<off_t>(options.address));
    if (base == MAP_FAILED)
        return report(errno_error(ErrorKind::InputOutput, "map", options.memory), EX_IOERR);

    const protocol::PictureSize size{static_cast<std::uint16_t>(options.width),
                                     static_cast<std::uint16_t>(options.height)};
    auto block = emulation::EmulatedBlock::open(engine::model_of(*accelerator), {.size = size},
                                                picture_to(options.picture));
    if (!block)
        return report(block.error(), EX_UNAVAILABLE);
    emulation::BlockInMemory memory({static_cast<std::uint32_t*>(base), page_words}, **block,
                                    *accelerator);
    fmt::print("ready\n");
    for (;;) {
        if (memory.step())
            fmt::print("{}\n", words_line(**block, *accelerator));
        static_cast<void>(std::fflush(stdout));
        std::array waits = {pollfd{STDIN_FILENO, POLLIN, 0},
                            pollfd{(*block)->interrupt_fd(), POLLIN, 0}};
        ::poll(waits.data(), waits.size(), static_cast<int>(pause.count()));
        if (waits[0].revents != 0)
            return EX_OK;
        if (waits[1].revents == 0)
            continue;
        if (const auto count = (*block)->take_interrupt(); count)
            fmt::print("interrupt {}\n", *count);
    }
}

} // namespace
} // namespace raymarch

// Only a lack of memory throws here. NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv)
{
    raymarch::Options options;
    CLI::App app("board_player: emulates the virtual board's programmable logic", "board_player");
    app.add_option("--memory", options.memory, "file that is the machine's memory")->required();
    app.add_option("--address", options.address, "offset of the register page in that file")
        ->required();
    app.add_option("--accelerator", options.accelerator, "name of the emulated accelerator");
    app.add_option("--picture", options.picture, "PNG file that each frame replaces");
    app.add_option("--width", options.width, "width of the picture")->check(CLI::Range(1, 1920));
    app.add_option("--height", options.height, "height of the picture")->check(CLI::Range(1, 1080));
    CLI11_PARSE(app, argc, argv);
    return raymarch::play(options);
}
