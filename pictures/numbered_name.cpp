// SPDX-License-Identifier: MIT
#include "pictures/numbered_name.hpp"

#include <algorithm>
#include <string_view>

namespace raymarch::pictures
{
namespace
{

constexpr std::size_t usual_digits = 4;

/// The number of digits of `%d` or `%0Nd` at the start of `text`, and where the rest begins; 0
/// digits when it is neither.
struct Pattern
{
    std::size_t digits = 0;
    std::size_t length = 0;
};

Pattern pattern_at(std::string_view text)
{
    if (text.starts_with("%d"))
        return {.digits = 1, .length = 2};
    if (text.size() >= 4 && text.starts_with("%0") && text[2] >= '1' && text[2] <= '9' &&
        text[3] == 'd')
        return {.digits = static_cast<std::size_t>(text[2] - '0'), .length = 4};
    return {};
}

} // namespace

std::string NumberedName::at(std::size_t number) const
{
    const std::string text = std::to_string(number);
    return before + std::string(digits - std::min(digits, text.size()), '0') + text + after;
}

Result<NumberedName> numbered_name(const std::string& path)
{
    const std::size_t slash = path.rfind('/');
    const std::size_t name = slash == std::string::npos ? 0 : slash + 1;
    const std::size_t percent = path.find('%', name);
    if (percent == std::string::npos) {
        const std::size_t dot = std::min(path.rfind('.'), path.size());
        return NumberedName{path.substr(0, dot) + '_', usual_digits, path.substr(dot)};
    }
    const Pattern pattern = pattern_at(std::string_view(path).substr(percent));
    const std::size_t rest = percent + pattern.length;
    if (pattern.digits == 0 || path.find('%', rest) != std::string::npos)
        return fail(plain_error(ErrorKind::Usage,
                                path + ": the name of a sequence has one pattern, %d or %01d to "
                                       "%09d, or none, which is _%04d before the ending"));
    return NumberedName{path.substr(0, percent), pattern.digits, path.substr(rest)};
}

} // namespace raymarch::pictures
