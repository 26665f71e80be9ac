// SPDX-License-Identifier: MIT
/// @file
/// These tests need no permission. tests/service/export_over_veth.py tests frames over a veth pair.
#include "drivers/packet_socket.hpp"

#include <gtest/gtest.h>

namespace raymarch::drivers
{
namespace
{

TEST(PacketSocket, AnInterfaceThatIsNotThereIsNamed)
{
    for (const char* const name : {"nosuch0", "", "a name that is far too long for an interface"}) {
        const auto port = PacketSocket::open(name);
        ASSERT_FALSE(port) << name;
        EXPECT_EQ(port.error().kind, ErrorKind::Unavailable);
        EXPECT_TRUE(
            port.error().message.starts_with(std::string(name) + ": there is no such interface"))
            << port.error().message;
    }
}

} // namespace
} // namespace raymarch::drivers
