// SPDX-License-Identifier: MIT
/// @file
/// This file compiles fmt's functions from its headers. They replace libfmt.so, so that no program
/// needs the library of one release.
///
/// `format-inl.h` defines all functions except a few templates; those are instantiated here.
#include <fmt/format-inl.h>

FMT_BEGIN_NAMESPACE
namespace detail
{

template auto thousands_sep_impl(locale_ref) -> thousands_sep_result<char>;
template auto decimal_point_impl(locale_ref) -> char;
template void vformat_to(buffer<char>&, string_view, format_args, locale_ref);
template auto locale_ref::get<std::locale>() const -> std::locale; // dates need it

} // namespace detail
FMT_END_NAMESPACE
