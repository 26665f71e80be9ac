// SPDX-License-Identifier: MIT
/// @file
/// raymarchctl export and receive, over capture files. Over a network: export_over_veth.py.
#include "service/support.hpp"

#include "protocol/accelerators.hpp"
#include "protocol/picture_frames.hpp"
#include "tests/fakes/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <sysexits.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace raymarch::tests
{
namespace
{

constexpr std::size_t file_header = 24;
constexpr std::size_t record_header = 16;

void write(const std::string& path, std::string_view bytes)
{
    std::ofstream(path, std::ios::binary) << bytes;
}

/// Every level, and no row like another.
protocol::GreyPicture some_picture()
{
    protocol::GreyPicture picture;
    for (std::size_t y = 0; y < protocol::export_size.height; ++y)
        for (std::size_t x = 0; x < protocol::export_size.width; ++x)
            picture.row(y)[x] = static_cast<std::uint8_t>((x * (y + 1) / 7 + y / 16) % 16);
    return picture;
}

std::string as_pgm(const protocol::GreyPicture& picture)
{
    std::string bytes = "P5\n400 300\n15\n";
    bytes.append(picture.levels.begin(), picture.levels.end());
    return bytes;
}

std::string as_ppm(const protocol::GreyPicture& picture)
{
    std::string bytes = "P6\n400 300\n255\n";
    for (const std::uint8_t level : picture.levels)
        bytes.append(3, static_cast<char>(17 * level));
    return bytes;
}

/// The records of a capture as they stand in the file.
std::vector<std::string> records_of(const std::string& capture)
{
    std::vector<std::string> records;
    for (std::size_t at = file_header; at < capture.size();) {
        const std::size_t size = static_cast<std::uint8_t>(capture[at + 8]); // none is longer
        records.push_back(capture.substr(at, record_header + size));
        at += record_header + size;
    }
    return records;
}

class Export : public testing::Test
{
  protected:
    /// The records of an export of `some_picture`, and the header before them.
    std::vector<std::string> exported()
    {
        write(folder / "in.pgm", as_pgm(some_picture()));
        const Finished result =
            run_tool(folder, {"export", "--pcap", capture, "--input", folder / "in.pgm"});
        EXPECT_EQ(result.status, EX_OK) << result.errors;
        const std::string bytes = test::read_text(capture);
        header = bytes.substr(0, file_header);
        return records_of(bytes);
    }
    void write_capture(const std::vector<std::string>& records) const
    {
        std::string bytes = header;
        for (const std::string& record : records)
            bytes += record;
        write(capture, bytes);
    }
    Finished receive(std::vector<std::string> more = {}) const
    {
        std::vector<std::string> arguments = {"receive", "--pcap", capture, "-o", picture};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_tool(folder, arguments);
    }

    TemporaryFolder folder;
    std::string capture = folder / "export.pcap";
    std::string picture = folder / "out.ppm";
    std::string header;
};

TEST_F(Export, TheCaptureIsTheFramesAtTheirTimes)
{
    const auto records = exported();
    ASSERT_EQ(records.size(), protocol::export_frames);
    for (std::size_t i = 0; i < records.size(); ++i) {
        const auto frame = protocol::frame_of(some_picture(), i);
        const std::string bytes(frame.bytes().begin(), frame.bytes().end());
        ASSERT_EQ(records[i].substr(record_header), bytes) << i;
    }
    const auto microseconds = [&records](std::size_t i) {
        return static_cast<std::uint8_t>(records[i][4]) +
               256 * static_cast<std::uint8_t>(records[i][5]);
    };
    EXPECT_EQ(microseconds(0), 0);      // clock 5
    EXPECT_EQ(microseconds(1), 7);      // clock 370
    EXPECT_EQ(microseconds(400), 7835); // clock 391789
}

TEST_F(Export, ThePictureComesBack)
{
    const auto records = exported();
    const Finished result = receive();
    EXPECT_EQ(result.status, EX_OK) << result.errors;
    EXPECT_EQ(result.errors, "");
    EXPECT_EQ(test::read_text(picture), as_ppm(some_picture()));

    const std::string first = test::read_text(capture); // and from a PPM the same frames
    EXPECT_EQ(run_tool(folder, {"export", "--pcap", capture, "--input", picture}).status, EX_OK);
    EXPECT_EQ(test::read_text(capture), first);
    const Finished standard = run_tool(folder, {"receive", "--pcap", capture, "-o", "-"});
    EXPECT_EQ(standard.output, as_ppm(some_picture()));
}

TEST_F(Export, MissingRowsAreNamed)
{
    auto records = exported();
    records.erase(records.begin() + 18, records.begin() + 22);
    records.erase(records.begin() + 4);
    write_capture(records);
    const Finished result = receive();
    EXPECT_EQ(result.status, EX_DATAERR);
    EXPECT_EQ(result.errors,
              "raymarchctl: " + capture + ": missing rows of the picture: 3, 17-20\n");
    EXPECT_FALSE(std::filesystem::exists(picture));

    EXPECT_EQ(receive({"--partial"}).status, EX_DATAERR);
    protocol::GreyPicture wanted = some_picture();
    for (const std::size_t row : {3U, 17U, 18U, 19U, 20U})
        std::ranges::fill(wanted.row(row), std::uint8_t{0});
    EXPECT_EQ(test::read_text(picture), as_ppm(wanted));
}

TEST_F(Export, DamagedDoubledAndDisorderedFrames)
{
    auto records = exported();
    std::string damaged = records[9];
    damaged[record_header + 13] = 1; // a row number of 2^24 and more
    std::ranges::reverse(records);
    records.insert(records.begin(), {damaged, records[200]});
    write_capture(records);
    const Finished result = receive();
    EXPECT_EQ(result.status, EX_OK) << result.errors;
    EXPECT_EQ(result.errors, "raymarchctl: damaged frames: 1, doubled rows: 1\n");
    EXPECT_EQ(test::read_text(picture), as_ppm(some_picture()));
}

TEST_F(Export, TagsOfVirtualNetworksAreNoDamage)
{
    auto records = exported();
    for (std::string& record : records) {
        record.insert(record_header + 12, std::string("\x81\x00\x00\x05", 4));
        record[8] = record[12] = static_cast<char>(record[8] + 4); // captured, and on the wire
    }
    write_capture(records);
    const Finished result = receive();
    EXPECT_EQ(result.status, EX_OK);
    EXPECT_EQ(result.errors, "");
    EXPECT_EQ(test::read_text(picture), as_ppm(some_picture()));
}

/// As `tcpdump -s 96` leaves them: all start frames are there, and no row.
TEST_F(Export, ACaptureThatCutItsFramesIsToBlame)
{
    auto records = exported();
    for (std::string& record : records) {
        constexpr std::size_t kept = 96;
        record[8] = static_cast<char>(std::min(kept, record.size() - record_header));
        record.resize(std::min(record.size(), record_header + kept));
    }
    write_capture(records);
    const Finished result = receive();
    EXPECT_EQ(result.status, EX_DATAERR);
    EXPECT_NE(
        result.errors.find("no row of a picture came; damaged frames: 400, 400 of them because the "
                           "capture kept only their beginning"),
        std::string::npos)
        << result.errors;
}

TEST_F(Export, RowsBeforeTheStartFrameAreTakenWithANote)
{
    auto records = exported();
    std::ranges::rotate(records, records.begin() + 200);
    write_capture(records);
    const Finished result = receive();
    EXPECT_EQ(result.status, EX_OK);
    EXPECT_NE(result.errors.find("before the start frame"), std::string::npos) << result.errors;
    EXPECT_EQ(test::read_text(picture), as_ppm(some_picture()));
}

TEST_F(Export, ACaptureWithoutAPicture)
{
    const auto records = exported();
    write_capture({records[0]});
    const Finished nothing = receive({"--partial"});
    EXPECT_EQ(nothing.status, EX_DATAERR);
    EXPECT_NE(nothing.errors.find("no row of a picture"), std::string::npos) << nothing.errors;
    EXPECT_FALSE(std::filesystem::exists(picture));

    write(capture, header + records[0] + records[1].substr(0, 50));
    const Finished cut = receive();
    EXPECT_EQ(cut.status, EX_DATAERR);
    EXPECT_NE(cut.errors.find("is cut off"), std::string::npos) << cut.errors;
    write(capture, "no capture");
    EXPECT_EQ(receive().status, EX_DATAERR);
    std::filesystem::remove(capture);
    EXPECT_EQ(receive().status, EX_UNAVAILABLE);
}

TEST_F(Export, OnlyWhatTheFormatHoldsIsExported)
{
    const auto why = [this](const std::string& bytes) {
        write(folder / "in.ppm", bytes);
        const Finished result =
            run_tool(folder, {"export", "--pcap", capture, "--input", folder / "in.ppm"});
        EXPECT_EQ(result.status, EX_DATAERR);
        EXPECT_FALSE(std::filesystem::exists(capture));
        const std::string front = "raymarchctl: " + (folder / "in.ppm") + ": ";
        EXPECT_EQ(result.errors.substr(0, front.size()), front);
        return result.errors.substr(std::min(front.size(), result.errors.size()));
    };
    const std::string allowed = "; an export needs 400x300 pixels in 16 levels of grey, as the "
                                "accelerator fractal draws with COLOUR=off\n";
    const std::string whole = as_ppm(some_picture());
    const std::size_t pixels = whole.size() - std::size_t{3} * 400 * 300;
    const std::size_t pixel = pixels + 3 * (400 * 7 + 21);

    std::string coloured = whole;
    coloured.replace(pixel, 3, "\x11\x22\x11");
    EXPECT_EQ(why(coloured), "the pixel in column 21, row 7 is 17,34,17, not grey" + allowed);
    std::string between = whole;
    between.replace(pixel, 3, "\x12\x12\x12");
    EXPECT_EQ(why(between), "the pixel in column 21, row 7 is 18, not a multiple of 17" + allowed);
    EXPECT_EQ(why("P5 1 1 255 x"), "the picture is 1x1" + allowed);
    EXPECT_EQ(why("nothing"), "is no binary PGM or PPM picture (P5, P6)\n");
}

TEST_F(Export, AViewIsExportedAsItIsRendered)
{
    using Arguments = std::vector<std::string>;
    for (const Arguments& view : {
             Arguments{"--scene", "cube"},
             Arguments{"--accelerator", "sphere", "--size", "400x300", "--set", "TINT=grey"},
         }) {
        Arguments arguments = {"export", "--pcap", capture, "--threads", "2"};
        arguments.insert(arguments.end(), view.begin(), view.end());
        const Finished exported = run_tool(folder, arguments);
        ASSERT_EQ(exported.status, EX_OK) << exported.errors;
        ASSERT_EQ(receive().status, EX_OK);
        Arguments render = {"render", "-o", "-"};
        if (view[0] != "--accelerator") // the default of export alone
            render.insert(render.end(), {"--accelerator", "fractal"});
        render.insert(render.end(), view.begin(), view.end());
        const Finished rendered = run_tool(folder, render);
        ASSERT_EQ(rendered.status, EX_OK) << rendered.errors;
        EXPECT_TRUE(test::read_text(picture) == rendered.output) << view[1];
    }
}

/// `KEY=VALUE` that sets the accelerator's first parameter to its default.
std::string some_setting(const protocol::Accelerator& accelerator)
{
    const protocol::Parameter& first = accelerator.parameters.front();
    return std::string(first.key) + "=" + std::string(first.initial);
}

TEST_F(Export, EveryPresetCanBeChangedBySet)
{
    for (const protocol::Preset& preset : protocol::fractal::presets) {
        const std::vector<std::string> view = {"--preset", std::string(preset.name), "--set",
                                               "COLOUR=off"};
        std::vector<std::string> arguments = {"export", "--pcap", capture};
        arguments.insert(arguments.end(), view.begin(), view.end());
        const Finished exported = run_tool(folder, arguments);
        ASSERT_EQ(exported.status, EX_OK) << preset.name << exported.errors;
        ASSERT_EQ(receive().status, EX_OK);
        std::vector<std::string> render = {"render", "-o", "-", "--accelerator", "fractal"};
        render.insert(render.end(), view.begin(), view.end());
        EXPECT_TRUE(test::read_text(picture) == run_tool(folder, render).output) << preset.name;
        std::filesystem::remove(capture);
    }
    // Of the others every preset is taken, too; the size decides before anything is drawn.
    for (const protocol::Accelerator* accelerator : protocol::accelerators)
        for (const protocol::Preset& preset : accelerator->presets) {
            const Finished result = run_tool(
                folder, {"export", "--pcap", capture, "--accelerator",
                         std::string(accelerator->name), "--preset", std::string(preset.name),
                         "--set", some_setting(*accelerator), "--size", "40x30"});
            EXPECT_EQ(result.status, EX_DATAERR) << preset.name;
            EXPECT_NE(result.errors.find("the picture is 40x30; an export needs"),
                      std::string::npos)
                << preset.name << result.errors;
        }
    const Finished grey =
        run_tool(folder, {"export", "--pcap", capture, "--accelerator", "sphere", "--preset",
                          "trio", "--set", "TINT=grey,MODEL=rtl", "--size", "400x300"});
    EXPECT_EQ(grey.status, EX_OK) << grey.errors;
}

TEST_F(Export, AViewThatTheFormatDoesNotHold)
{
    const auto why = [this](std::vector<std::string> view, int status) {
        view.insert(view.begin(), {"export", "--pcap", capture});
        const Finished result = run_tool(folder, view);
        EXPECT_EQ(result.status, status);
        EXPECT_FALSE(std::filesystem::exists(capture));
        return result.errors;
    };
    const std::string allowed = "; an export needs 400x300 pixels in 16 levels of grey, as the "
                                "accelerator fractal draws with COLOUR=off\n";
    EXPECT_EQ(why({"--accelerator", "marcher", "--preset", "cube"}, EX_DATAERR),
              "raymarchctl: the picture is 640x480" + allowed);
    const std::string coloured = why({"--preset", "cube_side"}, EX_DATAERR);
    EXPECT_NE(coloured.find(", not grey" + allowed), std::string::npos) << coloured;
    EXPECT_EQ(why({"--preset", "lattice"}, EX_USAGE),
              "raymarchctl: 'lattice' is a preset of marcher, not of fractal\n");
    EXPECT_NE(why({"--preset", "none"}, EX_USAGE)
                  .find("there is no preset 'none'; the presets are start"),
              std::string::npos);
    EXPECT_NE(why({"--set", "HUE=256"}, EX_DATAERR).find("key=HUE"), std::string::npos);
}

TEST_F(Export, WrongCommandLines)
{
    write(folder / "in.pgm", as_pgm(some_picture()));
    const std::string input = folder / "in.pgm";
    const auto status = [this](const std::vector<std::string>& arguments) {
        return run_tool(folder, arguments).status;
    };
    EXPECT_EQ(status({"export", "--input", input}), EX_USAGE);
    EXPECT_EQ(status({"export", "--pcap", capture}), EX_USAGE);
    EXPECT_EQ(status({"export", "--pcap", capture, "--accelerator", "fractal"}), EX_USAGE);
    const std::vector<std::pair<std::string, std::string>> instead_of_a_preset = {
        {"--scene", "cube"}, {"--line", "X=1"}, {"--registers", "0"}};
    for (const auto& [option, value] : instead_of_a_preset) {
        EXPECT_EQ(status({"export", "--pcap", capture, "--input", input, option, value}), EX_USAGE)
            << option;
        EXPECT_EQ(status({"export", "--pcap", capture, "--preset", "start", option, value}),
                  EX_USAGE)
            << option;
    }
    EXPECT_EQ(status({"export", "--pcap", capture, "--input", input, "--preset", "start"}),
              EX_USAGE);
    EXPECT_EQ(status({"export", "--pcap", capture, "--input", input, "--set", "HUE=1"}), EX_USAGE);
    EXPECT_EQ(status({"export", "--pcap", capture, "--input", input, "--size", "400x300"}),
              EX_USAGE);
    EXPECT_EQ(status({"export", "--pcap", capture, "--input", input, "--threads", "1"}), EX_USAGE);
    EXPECT_EQ(status({"export", "--pcap", capture, "--interface", "lo", "--input", input}),
              EX_USAGE);
    EXPECT_EQ(status({"export", "--pcap", capture, "--fast", "--input", input}), EX_USAGE);
    EXPECT_EQ(status({"receive", "--pcap", capture}), EX_USAGE);
    EXPECT_EQ(status({"receive", "-o", picture}), EX_USAGE);
    EXPECT_EQ(status({"receive", "--pcap", capture, "-o", folder / "out.gif"}), EX_USAGE);
    EXPECT_EQ(status({"receive", "--pcap", capture, "--timeout", "1", "-o", picture}), EX_USAGE);
    EXPECT_EQ(status({"receive", "--interface", "lo", "--timeout", "0", "-o", picture}), EX_USAGE);
    EXPECT_EQ(status({"export", "--interface", "nosuch0", "--input", input}), EX_UNAVAILABLE);
    EXPECT_EQ(status({"export", "--pcap", folder / "no/such/file", "--input", input}), EX_IOERR);
    EXPECT_EQ(status({"export", "--pcap", capture, "--input", folder / "none"}), EX_UNAVAILABLE);
}

} // namespace
} // namespace raymarch::tests
