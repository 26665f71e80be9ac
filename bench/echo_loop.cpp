// SPDX-License-Identifier: MIT
/// @file
/// The floor of bench_latency: what the kernel alone takes to bring a byte to a waiting process.
///
///     bench_echo_loop REGISTERS LINK
///
/// Looks at nothing that it reads: each LF stores a higher count to register word 7.
#include "drivers/mapped_window.hpp"
#include "drivers/pseudo_terminal.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <span>

namespace
{

using namespace raymarch; // NOLINT(google-build-using-namespace)

constexpr std::size_t page_bytes = 4096;
constexpr drivers::RegOffset last_word{4 * 7};

int complain(const Error& error)
{
    static_cast<void>(std::fprintf(stderr, "bench_echo_loop: %s\n", error.message.c_str()));
    return exit_status(error.kind);
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 3)
        return complain(plain_error(ErrorKind::Usage, "bench_echo_loop REGISTERS LINK"));
    const auto page = drivers::MappedWindow::open_file(argv[1], page_bytes);
    if (!page)
        return complain(page.error());
    const auto terminal = drivers::PseudoTerminal::open(argv[2]);
    if (!terminal)
        return complain(terminal.error());
    // Held open, so that a read without a host waits; and waiting is what is measured.
    const UniqueFd other_end(::open((*terminal)->name().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC));
    const int fd = (*terminal)->fd();
    if (!other_end || ::fcntl(fd, F_SETFL, O_RDWR) != 0)
        return complain(errno_error(ErrorKind::InputOutput, "open", (*terminal)->name()));

    std::uint32_t count = 0;
    std::array<char, 4096> bytes; // NOLINT(*-member-init): read before use
    for (ssize_t size = 0; (size = ::read(fd, bytes.data(), bytes.size())) > 0;)
        for (const char c : std::span(bytes).first(static_cast<std::size_t>(size)))
            if (c == '\n')
                (*page)->write(last_word, ++count);
    return 0;
}
