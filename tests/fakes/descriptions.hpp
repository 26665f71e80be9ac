// SPDX-License-Identifier: MIT
/// @file
/// Tests of what holds for every accelerator of the registry, whatever its table says: derive a
/// fixture from EveryAccelerator and instantiate it over protocol::accelerators.
#pragma once

#include "protocol/accelerators.hpp"
#include "tests/fakes/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <ostream>
#include <set>
#include <span>
#include <string>
#include <string_view>

namespace raymarch::protocol
{

/// A description's name stands for it in the output of GoogleTest.
inline void PrintTo(const Accelerator* description, std::ostream* stream)
{
    *stream << (description != nullptr ? description->name : "none");
}

} // namespace raymarch::protocol

namespace raymarch::test
{

class EveryAccelerator : public testing::TestWithParam<const protocol::Accelerator*>
{
  protected:
    /// The groups of parameters that RESET and RANDOM take.
    [[nodiscard]] std::set<std::string_view> groups() const
    {
        std::set<std::string_view> names;
        for (const protocol::Parameter& parameter : table)
            names.insert(parameter.group);
        return names;
    }

    const protocol::Accelerator& accelerator = *GetParam();
    std::span<const protocol::Parameter> table = accelerator.parameters;
};

/// The end of an instance's name.
inline std::string accelerator_name(const testing::TestParamInfo<const protocol::Accelerator*>& it)
{
    return std::string(it.param->name);
}

/// The largest code of a row's range. Of a number with a tail, the largest with any tail.
[[nodiscard]] inline std::int64_t largest_in_range(const protocol::Parameter& parameter)
{
    return std::min(parameter.max_scaled - (parameter.tail_bits > 0 ? 1 : 0),
                    parameter.largest_code);
}

/// Every parameter anywhere in its range.
[[nodiscard]] inline protocol::State random_state(const protocol::Accelerator& accelerator,
                                                  std::mt19937_64& random)
{
    protocol::State state(accelerator.parameters.size());
    for (std::size_t i = 0; i < accelerator.parameters.size(); ++i) {
        const protocol::Parameter& parameter = accelerator.parameters[i];
        state.codes[i] = pick(random, parameter.min_scaled, largest_in_range(parameter));
    }
    return state;
}

/// The default of a parameter as a host writes it.
[[nodiscard]] inline std::string default_pair(const protocol::Parameter& parameter)
{
    return std::string(parameter.key) + "=" + std::string(parameter.initial);
}

/// A complete frame of defaults, without the pair of the parameter `left_out`.
[[nodiscard]] inline std::string default_frame(const protocol::Accelerator& accelerator,
                                               std::size_t left_out = SIZE_MAX)
{
    std::string text;
    for (std::size_t i = 0; i < accelerator.parameters.size(); ++i)
        if (accelerator.frame[i] && i != left_out)
            text += (text.empty() ? "" : ",") + default_pair(accelerator.parameters[i]);
    return text;
}

} // namespace raymarch::test
