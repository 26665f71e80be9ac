// SPDX-License-Identifier: MIT
/// @file
/// What a capture holds of a picture is a picture that is exported: its frames give it again.
/// A picture file that is read is written as a file that reads as the same picture.
#include "drivers/pcap_file.hpp"
#include "pictures/netpbm.hpp"
#include "pictures/picture_file.hpp"
#include "protocol/picture_frames.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

using namespace raymarch; // NOLINT(google-build-using-namespace)

namespace
{

constexpr std::array<std::uint8_t, 24> capture_header = {
    0xD4, 0xC3, 0xB2, 0xA1, 2, 0, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xFF, 0xFF, 0, 0, 1, 0, 0, 0};

/// With a right header, or the fuzzer would hardly get past it.
void check_capture(std::span<const std::uint8_t> records)
{
    std::vector<std::uint8_t> bytes(capture_header.begin(), capture_header.end());
    bytes.insert(bytes.end(), records.begin(), records.end());
    auto reader = drivers::PcapReader::open(bytes, "capture");
    if (!reader)
        std::abort();
    protocol::PictureAssembler assembler;
    for (auto record = reader->next(); record && *record; record = reader->next()) {
        const auto frame = (*record)->frame;
        assembler.take(frame);
        // Few frames have our addresses by chance, so the bytes are also taken as a row's data.
        auto row = protocol::frame_of(assembler.picture(), 1);
        for (std::size_t i = 0; i < frame.size() && 12 + i < row.size; ++i)
            row.storage[12 + i] = frame[i];
        assembler.take(row.bytes());
    }
    if (assembler.count(protocol::FrameFate::Row) == 0)
        return;
    protocol::PictureAssembler again;
    for (std::size_t i = 0; i < protocol::export_frames; ++i)
        again.take(protocol::frame_of(assembler.picture(), i).bytes());
    if (!again.settled() || again.picture() != assembler.picture())
        std::abort();
}

void check_picture(std::string_view bytes)
{
    const auto image = pictures::decode_netpbm(bytes);
    if (!image)
        return;
    const auto written = pictures::encode(*image, pictures::PictureFormat::Ppm);
    const auto again = pictures::decode_netpbm(std::string(written->begin(), written->end()));
    if (!again || again->size != image->size || again->rgb != image->rgb)
        std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    check_capture({data, size});
    check_picture({reinterpret_cast<const char*>(data), size});
    static_cast<void>(drivers::PcapReader::open({data, size}, "any"));
    return 0;
}
