// SPDX-License-Identifier: MIT
/// @file
/// Sends and receives raw Ethernet frames (packet(7)). This needs CAP_NET_RAW, but not libpcap.
#pragma once

#include "base/result.hpp"
#include "base/unique_fd.hpp"
#include "drivers/ports.hpp"

#include <memory>
#include <string>

namespace raymarch::drivers
{

/// While it is open, the interface is in promiscuous mode, because no machine has the address that
/// the frames go to.
class PacketSocket final : public FramePort
{
  public:
    /// Errors: Unavailable (there is no such interface, it is down or not Ethernet, or the user has
    /// no permission).
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
