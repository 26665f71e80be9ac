// SPDX-License-Identifier: MIT
#include "cli/typed_lines.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <utility>

namespace raymarch::cli
{
namespace
{

class PlainLines final : public TypedLines
{
  public:
    PlainLines(int stop_fd, std::string prompt) : stop_fd_(stop_fd), prompt_(std::move(prompt)) {}

    Result<std::optional<std::string>> next() override
    {
        fmt::print("{}", prompt_);
        static_cast<void>(std::fflush(stdout)); // main reports an error
        for (std::size_t searched = 0;;) {
            if (const std::size_t end = bytes_.find('\n', searched); end != std::string::npos) {
                std::string line = bytes_.substr(0, end);
                bytes_.erase(0, end + 1);
                return line;
            }
            searched = bytes_.size();
            std::array<pollfd, 2> waiting = {
                pollfd{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0},
                pollfd{.fd = stop_fd_, .events = POLLIN, .revents = 0},
            };
            if (::poll(waiting.data(), waiting.size(), -1) < 0)
                continue; // a signal
            if (waiting[1].revents != 0)
                return std::nullopt;
            std::array<char, 65'536> chunk; // NOLINT(*-member-init): read before use
            const ssize_t size = ::read(STDIN_FILENO, chunk.data(), chunk.size());
            if (size < 0 && (errno == EINTR || errno == EAGAIN))
                continue;
            if (size < 0)
                return fail(errno_error(ErrorKind::InputOutput, "read", "standard input"));
            if (size == 0)
                return bytes_.empty() ? std::nullopt
                                      : std::optional(std::exchange(bytes_, std::string()));
            bytes_.append(chunk.data(), static_cast<std::size_t>(size));
        }
    }

  private:
    int stop_fd_;
    std::string prompt_;
    std::string bytes_;
};

} // namespace

std::unique_ptr<TypedLines> plain_lines(int stop_fd, std::string prompt)
{
    return std::make_unique<PlainLines>(stop_fd, std::move(prompt));
}

} // namespace raymarch::cli
