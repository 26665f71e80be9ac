// SPDX-License-Identifier: MIT
/// @file
/// A configuration that is refused is refused in words that name the place, and one that is taken
/// is taken again. The place of a line, as it is written in messages, reads as the same place.
#include "daemon/actions.hpp"
#include "daemon/config.hpp"
#include "drivers/line_spec.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

using namespace raymarch; // NOLINT(google-build-using-namespace)

namespace
{

void require(bool holds)
{
    if (!holds)
        std::abort();
}

void check_refusal(const Result<void>& result, std::string_view begins)
{
    require(result || (result.error().kind == ErrorKind::Config &&
                       result.error().message.starts_with(begins) &&
                       result.error().message.size() > begins.size()));
}

void check_line(const drivers::LineSpec& spec)
{
    require(!spec.places.empty());
    for (const drivers::LinePlace& place : spec.places) {
        const auto again = drivers::parse_line_spec(to_string(place));
        require(again && again->places == std::vector{place});
    }
}

void check_file(std::string_view text)
{
    daemon::Config config = daemon::default_config();
    const auto read = daemon::read_config_text(config, text, "any");
    check_refusal(read, "any:");
    if (!read)
        return;
    require(daemon::read_config_text(config, text, "any").has_value());
    static_cast<void>(daemon::validate(config));
    require(config.accelerator != nullptr);
    for (const auto& spec : config.gpio.lines)
        if (spec)
            check_line(*spec);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    check_file(text);
    daemon::Config config = daemon::default_config();
    for (const daemon::Setting& setting : daemon::settings())
        check_refusal(daemon::set(config, setting.name, text), std::string(setting.name) + ": ");
    for (const daemon::Action& action : daemon::actions())
        check_refusal(daemon::set_line(config, action.name, text),
                      std::string(daemon::lines_table) + '.' + std::string(action.name) + ": ");
    if (const auto spec = drivers::parse_line_spec(text))
        check_line(*spec);
    return 0;
}
