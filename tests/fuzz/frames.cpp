// SPDX-License-Identifier: MIT
/// @file
/// Of every accelerator: what is accepted is representable, as pack and unpack keep it, and its
/// text reads back as the same. The short way of frames and the long one give the same. A faulty
/// line leaves its state alone in the caller's hands; a column lies inside the line.
#include "protocol/accelerators.hpp"
#include "protocol/assignments.hpp"
#include "protocol/registers.hpp"
#include "protocol/reply.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

using namespace raymarch::protocol; // NOLINT(google-build-using-namespace)

namespace
{

void check(const Accelerator& accelerator, std::string_view text)
{
    State state = initial_state(accelerator);
    State by_pairs = state;
    State either = state;
    const auto long_fault = read_frame_by_pairs(accelerator, {.bytes = text}, by_pairs);
    const auto any_fault = read_frame(accelerator, {.bytes = text}, either);
    if (long_fault.has_value() != any_fault.has_value() || (!any_fault && !(either == by_pairs)))
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
