// SPDX-License-Identifier: MIT
#include "drivers/unix_socket.hpp"

#include "tests/fakes/other_process.hpp"
#include "tests/fakes/temporary_folder.hpp"
#include "tests/fakes/waiting.hpp"

#include <gtest/gtest.h>

#include <sys/socket.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <latch>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace raymarch::drivers
{
namespace
{

namespace fs = std::filesystem;

class Socket : public testing::Test
{
  protected:
    test::TemporaryFolder folder;
    std::string path = folder / "control";
};

TEST_F(Socket, BytesGoBothWays)
{
    auto listener = SocketListener::open(path);
    ASSERT_TRUE(listener) << listener.error().message;
    EXPECT_EQ(listener->accept(), nullptr); // there is no client, and it does not wait
    const auto client = SocketPort::connect(path);
    ASSERT_TRUE(client) << client.error().message;
    const auto server = listener->accept().value();
    ASSERT_NE(server, nullptr);

    std::array<char, 16> bytes{};
    EXPECT_EQ(server->read(bytes).status, ReadStatus::Empty);
    EXPECT_EQ((*client)->write("PING\n"), 5U);
    ASSERT_TRUE(test::readable(server->fd()));
    EXPECT_EQ(server->read(bytes).size, 5U);
    EXPECT_EQ(server->write("OK\r\n"), 4U);
    ASSERT_TRUE(test::readable((*client)->fd()));
    EXPECT_EQ((*client)->read(bytes).size, 4U);
}

TEST_F(Socket, AClientThatLeavesIsGone)
{
    auto listener = SocketListener::open(path);
    ASSERT_TRUE(listener);
    auto client = SocketPort::connect(path);
    ASSERT_TRUE(client);
    const auto server = listener->accept().value();
    ASSERT_NE(server, nullptr);
    client->reset();
    std::array<char, 16> bytes{};
    EXPECT_EQ(server->read(bytes).status, ReadStatus::Gone);
    EXPECT_EQ(server->write("OK\r\n"), 0U); // SIGPIPE is not raised
}

TEST_F(Socket, AClientThatDoesNotReadFillsUp)
{
    auto listener = SocketListener::open(path);
    ASSERT_TRUE(listener);
    const auto client = SocketPort::connect(path);
    ASSERT_TRUE(client);
    const auto server = listener->accept().value();
    ASSERT_NE(server, nullptr);
    const std::string much(1 << 16, 'x');
    for (int i = 0; server->write(much) > 0; ++i)
        ASSERT_LT(i, 1000);
}

TEST_F(Socket, ASocketThatWasLeftBehindIsReplaced)
{
    {
        auto killed = SocketListener::open(path);
        ASSERT_TRUE(killed);
        fs::create_hard_link(path, folder / "kept"); // the socket stays, as after a kill
    }
    fs::rename(folder / "kept", path);
    EXPECT_FALSE(fs::exists(path + ".lock"));
    ASSERT_TRUE(fs::is_socket(path));
    EXPECT_FALSE(SocketPort::connect(path));
    EXPECT_TRUE(SocketListener::open(path));
}

TEST_F(Socket, ALiveOneIsRefused)
{
    const auto first = SocketListener::open(path);
    ASSERT_TRUE(first);
    const auto second = SocketListener::open(path);
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().kind, ErrorKind::Unavailable);
    EXPECT_NE(second.error().message.find(path), std::string::npos);
    EXPECT_TRUE(SocketPort::connect(path)); // the first one still listens
}

TEST_F(Socket, TheSecondHearsWhoListens)
{
    test::OtherProcess other([&] { return SocketListener::open(path); });
    ASSERT_TRUE(other.has_it());
    const auto second = SocketListener::open(path);
    ASSERT_FALSE(second);
    EXPECT_NE(second.error().message.find("process " + std::to_string(other.pid())),
              std::string::npos)
        << second.error().message;
    other.kill();
    EXPECT_TRUE(SocketListener::open(path));
}

/// The other program does not use our locks.
TEST_F(Socket, AStrangerThatListensIsNotReplaced)
{
    const UniqueFd stranger(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
    sockaddr_un address = {};
    address.sun_family = AF_UNIX;
    std::copy(path.begin(), path.end(), address.sun_path);
    ASSERT_EQ(::bind(stranger.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address),
              0);
    ASSERT_EQ(::listen(stranger.get(), 1), 0);
    const auto listener = SocketListener::open(path);
    ASSERT_FALSE(listener);
    EXPECT_NE(listener.error().message.find("another process listens on it"), std::string::npos);
    EXPECT_TRUE(SocketPort::connect(path));
}

/// Two services start at once and find an old socket. Exactly one of them listens.
TEST_F(Socket, OfManyStartsAtOnceOneListens)
{
    for (int round = 0; round < 20; ++round) {
        {
            auto killed = SocketListener::open(path);
            ASSERT_TRUE(killed);
            fs::create_hard_link(path, folder / "kept");
        }
        fs::rename(folder / "kept", path);
        std::vector<std::optional<SocketListener>> listeners(4);
        std::latch together(static_cast<std::ptrdiff_t>(listeners.size()));
        std::vector<std::jthread> starts;
        for (auto& listener : listeners)
            starts.emplace_back([&] {
                together.arrive_and_wait();
                if (auto opened = SocketListener::open(path))
                    listener.emplace(std::move(*opened));
            });
        starts.clear();
        const auto open = std::ranges::count_if(listeners, [](auto& l) { return l.has_value(); });
        ASSERT_EQ(open, 1) << "round " << round;
        ASSERT_TRUE(SocketPort::connect(path));
    }
}

TEST_F(Socket, OneThatWasReplacedIsNotRemovedByTheOldOne)
{
    std::optional<SocketListener> first;
    {
        auto opened = SocketListener::open(path);
        ASSERT_TRUE(opened);
        first.emplace(std::move(*opened));
    }
    EXPECT_TRUE(first->in_place());
    fs::rename(path, folder / "away"); // the inode number of the old socket stays in use
    EXPECT_FALSE(first->in_place());
    test::write_text(path, "somebody else's");
    EXPECT_FALSE(first->in_place());
    first.reset();
    EXPECT_EQ(test::read_text(path), "somebody else's");
}

TEST_F(Socket, SomethingElseOfThatNameStays)
{
    test::write_text(path, "precious");
    const auto listener = SocketListener::open(path);
    ASSERT_FALSE(listener);
    EXPECT_EQ(listener.error().kind, ErrorKind::Unavailable);
    EXPECT_EQ(test::read_text(path), "precious");
}

TEST_F(Socket, IsForItsOwnerAndGroup)
{
    const auto listener = SocketListener::open(path);
    ASSERT_TRUE(listener);
    struct stat info = {};
    ASSERT_EQ(::stat(path.c_str(), &info), 0);
    EXPECT_EQ(info.st_mode & 07777U, 0660U);
}

TEST_F(Socket, IsRemovedOnceByItsOwner)
{
    std::optional<SocketListener> kept;
    {
        auto listener = SocketListener::open(path);
        ASSERT_TRUE(listener);
        kept.emplace(std::move(*listener));
    }
    EXPECT_TRUE(fs::exists(path)); // the moved-from listener does not remove it
    kept.reset();
    EXPECT_FALSE(fs::exists(path));
}

TEST_F(Socket, APathThatIsTooLongIsRefused)
{
    const std::string longest(200, 'x');
    const auto listener = SocketListener::open(folder / longest);
    ASSERT_FALSE(listener);
    EXPECT_EQ(listener.error().kind, ErrorKind::Usage);
    EXPECT_NE(listener.error().message.find("107"), std::string::npos) << listener.error().message;
    EXPECT_FALSE(SocketPort::connect(folder / longest));
}

TEST_F(Socket, WithoutAListenerThereIsNoConnection)
{
    const auto client = SocketPort::connect(path);
    ASSERT_FALSE(client);
    EXPECT_EQ(client.error().kind, ErrorKind::Unavailable);
    EXPECT_NE(client.error().message.find(path), std::string::npos);
}

} // namespace
} // namespace raymarch::drivers
