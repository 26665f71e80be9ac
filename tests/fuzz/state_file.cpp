// SPDX-License-Identifier: MIT
/// @file
/// A state file that is accepted is written again as a file that reads as the same state.
#include "daemon/state_file.hpp"
#include "base/crc32.hpp"
#include "protocol/accelerators.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>

using namespace raymarch; // NOLINT(google-build-using-namespace)

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    // With a header and a right checksum, or the fuzzer would never get past them.
    std::string text =
        "raymarch-state 1\n" + std::string(reinterpret_cast<const char*>(data), size);
    text += fmt::format("crc32 {:08X}\n", crc32(text));
    const auto state = daemon::parse_state_file(text);
    if (!state)
        return 0;
    const auto again = daemon::parse_state_file(daemon::format_state_file(*state));
    if (!again || !(*again == *state))
        std::abort();
    return 0;
}
