// SPDX-License-Identifier: MIT
/// @file
/// What is accepted is representable: pack and unpack keep it, and its text reads back as the same.
/// The short way of frames and the long one give the same. A faulty line leaves its state alone in
/// the caller's hands; a column lies inside the line.
#include "protocol/accelerators.hpp"
#include "protocol/assignments.hpp"
#include "protocol/registers.hpp"
#include "protocol/reply.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>

using namespace raymarch::protocol; // NOLINT(google-build-using-namespace)

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const Accelerator& accelerator = default_accelerator;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    State state = initial_state(accelerator);
    // The short way and the long one: the same answer.
    State by_pairs = state;
    State either = state;
    const auto long_fault = read_frame_by_pairs(accelerator, {.bytes = text}, by_pairs);
    const auto any_fault = read_frame(accelerator, {.bytes = text}, either);
    if (long_fault.has_value() != any_fault.has_value() || (!any_fault && !(either == by_pairs)))
        std::abort();
    ParameterSet given;
    if (const auto fault = read_assignments(accelerator, {.bytes = text}, state, given)) {
        if (fault->column < 1 || fault->column > size + 1)
            std::abort();
        ReplyWriter reply;
        write_fault(reply, accelerator, *fault);
        if (reply.overflowed())
            std::abort();
        return 0;
    }
    if (!(unpack(accelerator, pack(accelerator, state)) == state))
        std::abort();
    ReplyWriter reply;
    write_state(reply, accelerator, state);
    State again;
    if (read_frame(accelerator, {.bytes = reply.text()}, again) || !(again == state))
        std::abort();
    return 0;
}
