// SPDX-License-Identifier: MIT
/// @file
/// `raymarchctl export`: sends a picture as Ethernet frames, or writes them to a capture file.
#include "cli/drawing.hpp"
#include "cli/grey_picture.hpp"
#include "cli/subcommands.hpp"
#include "cli/view_options.hpp"
#include "cli/words.hpp"
#include "drivers/packet_socket.hpp"
#include "drivers/pcap_file.hpp"
#include "drivers/user_file.hpp"
#include "engine/draw.hpp"
#include "engine/models.hpp"
#include "pictures/netpbm.hpp"
#include "protocol/accelerators.hpp"
#include "protocol/picture_frames.hpp"

#include <sysexits.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <thread>

namespace raymarch::cli
{
namespace
{

/// The time between frames: that of the source's hardware, or as short as possible.
enum class Pace : std::uint8_t { Hardware, Fast };

struct ExportOptions
{
    std::string interface;
    std::string capture;
    std::optional<std::string> input; ///< without it, the view is drawn
    ViewOptions view;
    unsigned threads = 0;
    bool fast = false;
};

constexpr std::chrono::nanoseconds duration_of(std::uint32_t clocks) noexcept
{
    return std::chrono::nanoseconds(std::uint64_t{clocks} * protocol::nanoseconds_a_clock);
}

/// The times are those of the source's hardware after a trigger at 0, so the same picture gives the
/// same file.
Result<void> write_capture(const protocol::GreyPicture& picture, const std::string& path)
{
    drivers::PcapWriter writer;
    for (std::size_t i = 0; i < protocol::export_frames; ++i)
        writer.add(protocol::frame_of(picture, i).bytes(), duration_of(protocol::first_clock(i)));
    return drivers::write_output(path, writer.bytes());
}

Result<void> send_frames(const protocol::GreyPicture& picture, drivers::FramePort& port, Pace pace)
{
    using Clock = std::chrono::steady_clock;
    auto earliest = Clock::now();
    for (std::size_t i = 0; i < protocol::export_frames; ++i) {
        std::this_thread::sleep_until(earliest);
        // The time counts from this frame, so that a late frame is not followed by a burst.
        if (pace == Pace::Hardware)
            earliest = Clock::now() + duration_of(protocol::clocks_a_row);
        if (auto sent = port.send(protocol::frame_of(picture, i).bytes()); !sent)
            return sent;
    }
    return {};
}

Result<protocol::GreyPicture> read_picture(const std::string& path)
{
    constexpr std::size_t most_bytes = 64 << 20;
    const auto in_file = [&path](Error error) {
        error.message = drivers::input_name(path) + ": " + error.message;
        return fail(std::move(error));
    };
    const auto bytes = drivers::read_input(path, most_bytes);
    if (!bytes)
        return fail(bytes.error());
    const auto image = pictures::decode_netpbm(*bytes);
    if (!image)
        return in_file(image.error());
    auto picture = grey_of(*image);
    if (!picture)
        return in_file(picture.error());
    return picture;
}

Result<protocol::GreyPicture> draw_picture(const ExportOptions& options)
{
    const auto accelerator = accelerator_named(options.view.accelerator);
    if (!accelerator)
        return fail(accelerator.error());
    const auto size = size_of(**accelerator, options.view);
    if (!size)
        return fail(size.error());
    const auto words = words_of(**accelerator, options.view);
    if (!words)
        return fail(words.error());
    engine::Image image(*size);
    if (*size == protocol::export_size) // another size is refused below
        draw_fastest(engine::model_of(**accelerator), *words, options.threads, image);
    return grey_of(image);
}

Result<void> export_picture(const protocol::GreyPicture& picture, const ExportOptions& options)
{
    if (!options.capture.empty())
        return write_capture(picture, options.capture);
    auto port = drivers::PacketSocket::open(options.interface);
    if (!port)
        return fail(port.error());
    return send_frames(picture, **port, options.fast ? Pace::Fast : Pace::Hardware);
}

Result<void> run_export(const ExportOptions& options)
{
    if (!options.capture.empty())
        if (auto possible = drivers::check_output(options.capture); !possible)
            return possible; // checked before the picture is drawn
    const auto picture = options.input ? read_picture(*options.input) : draw_picture(options);
    if (!picture)
        return fail(picture.error());
    return export_picture(*picture, options);
}

} // namespace

void add_export(CLI::App& app, Run& run)
{
    CLI::App* const command = app.add_subcommand(
        "export",
        "sends a 400x300 picture in 16 greys as Ethernet frames, or writes them to a file");
    const auto options = std::make_shared<ExportOptions>();
    CLI::Option_group* const where = command->add_option_group("output of the frames");
    CLI::Option* const interface =
        where
            ->add_option("--interface", options->interface,
                         "network interface to send on; needs CAP_NET_RAW")
            ->type_name("IF");
    where->add_option("--pcap", options->capture, "capture file to write; - is standard output")
        ->type_name("FILE");
    where->require_option(1);
    options->view.accelerator =
        protocol::fractal::description.name; // the accelerator with this export
    CLI::Option_group& what = add_view_options(*command, options->view);
    what.description("(required: a view, which --set may change, or a picture)");
    what.require_option(1, 0); // the options exclude each other
    CLI::Option* const threads = add_threads_option(*command, options->threads);
    CLI::Option* const input =
        what.add_option(
                "--input", options->input,
                "pgm or ppm file of a picture in place of a view; its levels are 0 to 15 if its "
                "maximum is 15, or multiples of 17 if it is 255; - is standard input")
            ->type_name("FILE")
            ->excludes(command->get_option("--accelerator"), command->get_option("--size"),
                       threads);
    for (const char* const view : {"--registers", "--line", "--preset", "--scene", "--set"})
        input->excludes(what.get_option(view));
    command
        ->add_flag("--fast", options->fast,
                   "send the frames as fast as possible; without it, the time between frames is "
                   "that of the source's hardware")
        ->needs(interface);
    command->callback([options, &run] {
        run = [options] {
            const auto result = run_export(*options);
            return result ? EX_OK : report(result.error());
        };
    });
}

} // namespace raymarch::cli
