// SPDX-License-Identifier: MIT
/// @file
/// Raw Ethernet frames on a network interface (packet(7)). Needs CAP_NET_RAW, nothing of libpcap.
#pragma once

#include "base/result.hpp"
#include "base/unique_fd.hpp"
#include "drivers/ports.hpp"

#include <memory>
#include <string>

namespace raymarch::drivers
{

/// One interface. While it is open the interface takes frames to any address (promiscuous), as the
/// frames that are of interest here go to an address of nobody's.
class PacketSocket final : public FramePort
{
  public:
    /// Errors: Unavailable (no such interface, not permitted, down, or not Ethernet).
    [[nodiscard]] static Result<std::unique_ptr<PacketSocket>> open(const std::string& interface);

    [[nodiscard]] Result<void> send(std::span<const std::uint8_t> frame) override;
    [[nodiscard]] Result<std::optional<std::size_t>>
    receive(std::span<std::uint8_t> into, std::chrono::milliseconds timeout) override;

  private:
    PacketSocket(UniqueFd fd, std::string interface) noexcept
        : fd_(std::move(fd))
        , interface_(std::move(interface))
    {}
    UniqueFd fd_;
    std::string interface_;
};

} // namespace raymarch::drivers
