// SPDX-License-Identifier: MIT
/// @file
/// Reads the GIFs of the tests, from the format's description alone and sharing nothing with the
/// writer. It knows what a film uses; anything else is an error.
#pragma once

#include "engine/image.hpp"

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace raymarch::test
{

struct Gif
{
    std::vector<engine::Image> frames{};
    std::vector<unsigned> delays{}; ///< hundredths of a second, one a frame
    bool for_ever = false;
};

class GifReader
{
  public:
    explicit GifReader(std::string_view bytes) : bytes_(bytes) {}

    Gif read()
    {
        require(take(6) == "GIF89a", "signature");
        size_.width = word();
        size_.height = word();
        require((byte() & 0x80) == 0, "no palette for all frames");
        byte(); // background
        byte(); // aspect
        for (;;) {
            const std::uint8_t kind = byte();
            if (kind == 0x3B)
                break;
            if (kind == 0x21)
                read_extension();
            else if (kind == 0x2C)
                read_frame();
            else
                require(false, "block");
        }
        require(at_ == bytes_.size(), "nothing after the end");
        require(gif_.delays.size() == gif_.frames.size(), "a delay for each frame");
        return gif_;
    }

  private:
    static void require(bool condition, const char* what)
    {
        if (!condition)
            throw std::runtime_error(std::string("gif: ") + what);
    }

    std::string_view take(std::size_t count)
    {
        require(at_ + count <= bytes_.size(), "too short");
        at_ += count;
        return bytes_.substr(at_ - count, count);
    }
    std::uint8_t byte() { return static_cast<std::uint8_t>(take(1)[0]); }
    std::uint16_t word()
    {
        const unsigned low = byte();
        return static_cast<std::uint16_t>(low | unsigned{byte()} << 8);
    }

    std::string blocks()
    {
        std::string all;
        while (const std::size_t count = byte())
            all += take(count);
        return all;
    }

    void read_extension()
    {
        const std::uint8_t label = byte();
        const std::string content = blocks();
        if (label == 0xF9) {
            require(content.size() == 4 && (content[0] & 1) == 0, "nothing transparent");
            gif_.delays.push_back(static_cast<std::uint8_t>(content[1]) |
                                  unsigned{static_cast<std::uint8_t>(content[2])} << 8);
        } else {
            require(label == 0xFF && content == std::string("NETSCAPE2.0\1\0\0", 14), "extension");
            gif_.for_ever = true;
        }
    }

    void read_frame()
    {
        require(word() == 0 && word() == 0, "frames at the corner");
        require(word() == size_.width && word() == size_.height, "frames as large as the film");
        const unsigned flags = byte();
        require((flags & 0xC0) == 0x80, "a palette of its own, not interlaced");
        const std::string_view palette = take(3 * (std::size_t{2} << (flags & 7)));
        const unsigned bits = byte();
        const std::vector<std::uint8_t> indices = decompress(blocks(), bits);
        engine::Image image(size_);
        require(indices.size() * 3 == image.rgb.size(), "as many indices as pixels");
        for (std::size_t i = 0; i < image.rgb.size(); ++i) {
            const std::size_t place = std::size_t{indices[i / 3]} * 3 + i % 3;
            require(place < palette.size(), "indices inside the palette");
            image.rgb[i] = static_cast<std::uint8_t>(palette[place]);
        }
        gif_.frames.push_back(image);
    }

    /// LZW with growing codes, the lowest bits first.
    static std::vector<std::uint8_t> decompress(std::string_view bytes, unsigned bits)
    {
        const std::size_t clear = std::size_t{1} << bits;
        std::vector<std::string> table;
        std::string last;
        std::string out;
        std::size_t bit = 0;
        unsigned width = bits + 1;
        for (;;) {
            std::size_t code = 0;
            for (unsigned i = 0; i < width; ++i, ++bit) {
                require(bit / 8 < bytes.size(), "an end code");
                code |= std::size_t{static_cast<std::uint8_t>(bytes[bit / 8]) >> bit % 8 & 1U} << i;
            }
            if (code == clear) {
                table.clear();
                for (std::size_t i = 0; i < clear + 2; ++i)
                    table.emplace_back(i < clear ? 1 : 0, static_cast<char>(i));
                width = bits + 1;
                last.clear();
                continue;
            }
            if (code == clear + 1)
                break;
            require(code < table.size() || (code == table.size() && !last.empty()), "codes");
            const std::string text = code < table.size() ? table[code] : last + last[0];
            if (!last.empty() && table.size() < 4096)
                table.push_back(last + text[0]);
            if (table.size() == std::size_t{1} << width && width < 12)
                ++width;
            out += text;
            last = text;
        }
        return {out.begin(), out.end()};
    }

    std::string_view bytes_;
    std::size_t at_ = 0;
    engine::PictureSize size_{};
    Gif gif_;
};

} // namespace raymarch::test
