// SPDX-License-Identifier: MIT
/// @file
/// Pictures that must not change: golden/<accelerator>.tsv holds, separated by tabs, the size, the
/// parameter words in hex, the CRC-32 of the RGB bytes, and why the row is there.
#include "base/crc32.hpp"
#include "engine/draw.hpp"
#include "engine/models.hpp"
#include "protocol/picture_size.hpp"
#include "protocol/registers.hpp"
#include "tests/fakes/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>

namespace raymarch::engine
{
namespace
{

struct Golden
{
    PictureSize size;
    protocol::Words words{};
    std::uint32_t crc = 0;
    std::string why;
};

Golden parse(const protocol::Accelerator& accelerator, const std::string& line)
{
    std::istringstream columns(line);
    std::string size;
    Golden row;
    columns >> size >> std::hex;
    row.size = protocol::parse_size(size, accelerator.max_size).value_or(PictureSize{});
    for (std::size_t i = 0; i < accelerator.word_count; ++i)
        columns >> row.words[i];
    columns >> row.crc;
    std::getline(columns >> std::ws, row.why);
    EXPECT_TRUE(columns && row.size.width > 0) << "size, words, crc, why: " << line;
    return row;
}

std::uint32_t crc_of(const Model& model, const Golden& row)
{
    Image image(row.size);
    draw(model, row.words, image, 0);
    return crc32({reinterpret_cast<const char*>(image.rgb.data()), image.rgb.size()});
}

TEST(Golden, PicturesAreWhatTheyWere)
{
    bool any = false;
    for (const Model& model : models) {
        const std::string path = std::string(RAYMARCH_TEST_DATA "/golden/") +
                                 std::string(model.description->name) + ".tsv";
        if (!std::filesystem::exists(path))
            continue;
        any = true;
        std::istringstream lines(test::read_text(path));
        int number = 0;
        for (std::string line; std::getline(lines, line);) {
            ++number;
            if (line.empty() || line.starts_with('#'))
                continue;
            const Golden row = parse(*model.description, line);
            const testing::ScopedTrace trace(path.c_str(), number, row.why);
            EXPECT_EQ(testing::PrintToString(crc_of(model, row)), testing::PrintToString(row.crc));
        }
    }
    if (!any)
        FAIL() << "there are no golden pictures";
}

} // namespace
} // namespace raymarch::engine
