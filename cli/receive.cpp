// SPDX-License-Identifier: MIT
/// @file
/// `raymarchctl receive`: assembles an exported picture from an interface or a capture file.
#include "cli/grey_picture.hpp"
#include "cli/picture_output.hpp"
#include "cli/subcommands.hpp"
#include "drivers/atomic_file.hpp"
#include "drivers/packet_socket.hpp"
#include "drivers/pcap_file.hpp"
#include "drivers/user_file.hpp"
#include "protocol/picture_frames.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace raymarch::cli
{
namespace
{

using protocol::FrameFate;
using protocol::PictureAssembler;

struct ReceiveOptions
{
    std::string interface;
    std::string capture;
    std::string output;
    double seconds = 5;
    bool partial = false;
};

/// Reads up to the first whole picture, or to the end of the file. `cut` counts the damaged frames
/// of which the capture has only a part.
Result<void> take_capture(PictureAssembler& assembler, const std::string& path, std::size_t& cut)
{
    constexpr std::size_t most_bytes = 64 << 20;
    const auto bytes = drivers::read_input(path, most_bytes);
    if (!bytes)
        return fail(bytes.error());
    auto reader = drivers::PcapReader::open(drivers::as_bytes(*bytes), drivers::input_name(path));
    if (!reader)
        return fail(reader.error());
    while (!assembler.settled()) {
        const auto record = reader->next();
        if (!record)
            return fail(record.error());
        if (!*record)
            break;
        const FrameFate fate = assembler.take((*record)->frame);
        cut += fate == FrameFate::Damaged && (*record)->cut ? 1 : 0;
    }
    return {};
}

/// Reads up to the first whole picture, or until the timeout.
Result<void> take_from(PictureAssembler& assembler, drivers::FramePort& port,
                       std::chrono::milliseconds timeout)
{
    using Clock = std::chrono::steady_clock;
    const auto deadline = Clock::now() + timeout;
    std::array<std::uint8_t, 2048>
        frame{}; // longer than our frames, so that a longer frame is detected
    while (!assembler.settled()) {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
        if (left.count() <= 0) // other frames may come without end
            break;
        const auto size = port.receive(frame, left);
        if (!size)
            return fail(size.error());
        if (*size)
            assembler.take(std::span(frame).first(**size));
    }
    return {};
}

Result<void> take_picture(PictureAssembler& assembler, const ReceiveOptions& options,
                          std::size_t& cut)
{
    if (!options.capture.empty())
        return take_capture(assembler, options.capture, cut);
    auto port = drivers::PacketSocket::open(options.interface);
    if (!port)
        return fail(port.error());
    const std::chrono::duration<double> seconds(options.seconds);
    return take_from(assembler, **port, std::chrono::ceil<std::chrono::milliseconds>(seconds));
}

/// Writes `3, 17-20, 299`.
std::string as_ranges(const std::vector<std::size_t>& rising)
{
    std::string text;
    for (std::size_t i = 0; i < rising.size();) {
        const std::size_t first = rising[i];
        while (i + 1 < rising.size() && rising[i + 1] == rising[i] + 1)
            ++i;
        const std::size_t last = rising[i++];
        text += fmt::format("{}{}", text.empty() ? "" : ", ", first);
        if (last != first)
            text += fmt::format("-{}", last);
    }
    return text;
}

Error incomplete(const PictureAssembler& assembler, const ReceiveOptions& options, std::size_t cut)
{
    const bool from_file = !options.capture.empty();
    const auto missing = assembler.missing_rows();
    std::string text =
        from_file ? drivers::input_name(options.capture)
                  : fmt::format("{}: within {} seconds", options.interface, options.seconds);
    text += missing.size() == protocol::export_size.height
                ? std::string(": no row of a picture came")
                : fmt::format(": missing rows of the picture: {}", as_ranges(missing));
    if (const std::size_t damaged = assembler.count(FrameFate::Damaged); damaged > 0)
        text += fmt::format("; damaged frames: {}", damaged);
    if (cut > 0)
        text += fmt::format(", {} of them because the capture kept only their beginning (its snap "
                            "length is too small)",
                            cut);
    return plain_error(from_file ? ErrorKind::BadData : ErrorKind::InputOutput, std::move(text));
}

/// Warns of problems although the picture is complete.
void print_notes(const PictureAssembler& assembler)
{
    const std::size_t damaged = assembler.count(FrameFate::Damaged);
    const std::size_t doubled = assembler.count(FrameFate::Doubled);
    if (damaged > 0 || doubled > 0)
        fmt::print(stderr, "raymarchctl: damaged frames: {}, doubled rows: {}\n", damaged, doubled);
    if (!assembler.settled())
        fmt::print(stderr, "raymarchctl: rows that came before the start frame may belong to an "
                           "earlier picture\n");
}

Result<void> receive(const ReceiveOptions& options)
{
    if (auto possible = check_picture_output(options.output); !possible)
        return possible;
    PictureAssembler assembler;
    std::size_t cut = 0;
    const auto taken = take_picture(assembler, options, cut);
    if (assembler.complete()) {
        print_notes(assembler);
        return write_picture(image_of(assembler.picture()), options.output);
    }
    const bool any = assembler.missing_rows().size() < protocol::export_size.height;
    if (options.partial && any)
        if (auto written = write_picture(image_of(assembler.picture()), options.output); !written)
            return written;
    return fail(taken ? incomplete(assembler, options, cut) : taken.error());
}

} // namespace

void add_receive(CLI::App& app, Run& run)
{
    CLI::App* const command =
        app.add_subcommand("receive", "assembles an exported picture from its Ethernet frames");
    const auto options = std::make_shared<ReceiveOptions>();
    CLI::Option_group* const where = command->add_option_group("input of the frames");
    CLI::Option* const interface =
        where
            ->add_option("--interface", options->interface,
                         "network interface to listen on; needs CAP_NET_RAW")
            ->type_name("IF");
    where->add_option("--pcap", options->capture, "capture file to read; - is standard input")
        ->type_name("FILE");
    where->require_option(1);
    add_picture_output_option(*command, options->output);
    command
        ->add_option("--timeout", options->seconds,
                     "longest time to wait for the whole picture, in seconds (default: 5)")
        ->check(CLI::Range(0.01, 3600.0))
        ->type_name("SECONDS")
        ->needs(interface);
    command->add_flag(
        "--partial", options->partial,
        "also write an incomplete picture, with the missing rows black; it is still an error");
    command->callback([options, &run] {
        run = [options] {
            const auto result = receive(*options);
            return result ? EX_OK : report(result.error());
        };
    });
}

} // namespace raymarch::cli
