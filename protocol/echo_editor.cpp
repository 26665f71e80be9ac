// SPDX-License-Identifier: MIT
#include "protocol/echo_editor.hpp"

namespace raymarch::protocol
{

namespace
{

/// Whether a terminal shows the byte. Other bytes are kept too, so that the reply can name them.
bool is_visible(char c) noexcept
{
    return c >= 0x20 && c <= 0x7E;
}

} // namespace

Typed EchoEditor::type(char c) noexcept
{
    constexpr char backspace = '\b';
    constexpr char del = '\x7F';
    if (ended_) {
        size_ = 0;
        ended_ = false;
    }
    const bool lf_of_crlf = c == '\n' && after_cr_;
    after_cr_ = c == '\r';
    if (lf_of_crlf)
        return {};
    if (c == '\r' || c == '\n') {
        ended_ = true;
        return {.echo = "\r\n", .line_ended = true};
    }
    if (c == backspace || c == del) {
        if (size_ == 0)
            return {};
        --size_;
        return {.echo = is_visible(line_[size_]) ? "\b \b" : ""};
    }
    if (size_ == line_.size()) // the line is already too long, so the byte is dropped
        return {};
    line_[size_++] = c;
    echo_ = c;
    return {.echo = is_visible(c) ? std::string_view(&echo_, 1) : std::string_view()};
}

} // namespace raymarch::protocol
