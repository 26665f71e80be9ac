// SPDX-License-Identifier: MIT
/// @file
/// This file compiles fmt's functions from its headers. They stand in for libfmt.so, so that no
/// program needs the library of one release.
///
/// `format-inl.h` defines all of them but a few templates, which the other headers take to be
/// elsewhere.
#include <fmt/format-inl.h>

FMT_BEGIN_NAMESPACE
namespace detail
{

template auto thousands_sep_impl(locale_ref) -> thousands_sep_result<char>;
template auto decimal_point_impl(locale_ref) -> char;
template void vformat_to(buffer<char>&, string_view, format_args, locale_ref);
template auto locale_ref::get<std::locale>() const -> std::locale; // dates, too, need it

} // namespace detail
FMT_END_NAMESPACE
