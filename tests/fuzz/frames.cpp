// SPDX-License-Identifier: MIT
/// @file
/// Of every accelerator: what is accepted is representable, as pack and unpack keep it, and its
/// text reads back as the same. The fast path of pairs and the rules give the same. A faulty
/// line leaves its state alone in the caller's hands; a column lies inside the line.
#include "protocol/accelerators.hpp"
#include "protocol/assignments.hpp"
#include "protocol/registers.hpp"
#include "protocol/reply.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

using namespace raymarch::protocol; // NOLINT(google-build-using-namespace)

namespace
{

std::string blank_before_pairs(std::string_view text)
{
    std::string result = " ";
    for (const char c : text) {
        result += c;
        if (c == ',')
            result += ' ';
    }
    return result;
}

void check(const Accelerator& accelerator, std::string_view text)
{
    State state = initial_state(accelerator);
    State spaced = state;
    State frame = state;
    // A blank before each pair keeps the fast path out, and changes nothing else.
    const std::string with_blanks = blank_before_pairs(text);
    const auto spaced_fault = read_frame(accelerator, {.bytes = with_blanks}, spaced);
    const auto frame_fault = read_frame(accelerator, {.bytes = text}, frame);
    if (spaced_fault.has_value() != frame_fault.has_value() || (!frame_fault && !(frame == spaced)))
        std::abort();
    ParameterSet given;
    if (const auto fault = read_assignments(accelerator, {.bytes = text}, state, given)) {
        if (fault->column < 1 || fault->column > text.size() + 1)
            std::abort();
        ReplyWriter reply;
        write_fault(reply, accelerator, *fault);
        if (reply.overflowed())
            std::abort();
        return;
    }
    if (!(unpack(accelerator, pack(accelerator, state)) == state))
        std::abort();
    ReplyWriter reply;
    write_state(reply, accelerator, state);
    State again = initial_state(accelerator);
    if (read_frame(accelerator, {.bytes = reply.text()}, again) || !(again == state))
        std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    for (const Accelerator* const accelerator : accelerators)
        check(*accelerator, {reinterpret_cast<const char*>(data), size});
    return 0;
}
