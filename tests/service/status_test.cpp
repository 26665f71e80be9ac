// SPDX-License-Identifier: MIT
/// @file
/// The replies of a running service to STATUS against the table of its keys, and the tool's JSON.
#include "protocol/status.hpp"
#include "service/support.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace raymarch::tests
{
namespace
{

using protocol::StatusKey;
using protocol::StatusKind;
using protocol::StatusRow;

/// The names and the values of a reply, in its order.
std::vector<std::pair<std::string, std::string>> fields_of(const std::string& reply)
{
    std::vector<std::pair<std::string, std::string>> fields;
    std::istringstream words(reply);
    for (std::string word; words >> word;)
        if (const std::size_t equals = word.find('='); equals != std::string::npos)
            fields.emplace_back(word.substr(0, equals), word.substr(equals + 1));
    return fields;
}

/// Whether `value` is a number, or one of the words of the row.
bool takes(const StatusRow& row, const std::string& value)
{
    if (row.kind == StatusKind::Number)
        return !value.empty() && value.find_first_not_of("0123456789.") == std::string::npos;
    const std::string words = "|" + std::string(row.value) + "|";
    return row.value.empty() || words.find("|" + value + "|") != std::string::npos;
}

/// Holds a reply to the table. Apart from `optional`, it is to have the keys that are always there.
void expect_rows(const std::string& reply, const std::vector<StatusKey>& optional)
{
    std::vector<StatusKey> present;
    for (const auto& [name, value] : fields_of(reply)) {
        const StatusRow* const row = protocol::find_status_row(name);
        ASSERT_NE(row, nullptr) << name << " is no row";
        EXPECT_TRUE(takes(*row, value)) << name << '=' << value;
        present.push_back(row->key);
    }
    std::vector<StatusKey> expected = optional;
    for (const StatusRow& row : protocol::status_rows)
        if (row.present == protocol::always_present)
            expected.push_back(row.key);
    std::ranges::sort(expected); // the order of the table
    EXPECT_EQ(present, expected) << reply;
}

TEST(Status, AnEmulatedBlockHasEveryKey)
{
    const TemporaryFolder folder;
    const Service service(folder, {"--registers", "emulated"});
    ASSERT_TRUE(service.ready());
    Host host = Host::on_socket(service.control());
    EXPECT_EQ(host.ask("SET").substr(0, 4), "ERR ");
    ASSERT_TRUE(eventually([&] { return !service.status("fps").empty(); }));
    expect_rows(host.ask("STATUS"),
                {StatusKey::HangUps, StatusKey::Block, StatusKey::ReadbackErrors, StatusKey::Frames,
                 StatusKey::Fps, StatusKey::Interrupts, StatusKey::InterruptsMissed,
                 StatusKey::RejectedCode});
}

TEST(Status, WithoutBlockAndTerminalTheirKeysAreLeftOut)
{
    const TemporaryFolder folder;
    const Service service(folder, {"--registers", "uio:" + folder / "uio0", "--serial", "none"});
    ASSERT_TRUE(service.ready());
    expect_rows(Host::on_socket(service.control()).ask("STATUS"), {});
}

TEST(Status, JsonHasNumbersAsNumbersAndWordsAsStrings)
{
    const TemporaryFolder folder;
    const Service service(folder);
    ASSERT_TRUE(service.ready());
    const Finished json = run_tool(folder, {"status", "--json", "--socket", service.control()});
    const auto object = nlohmann::json::parse(json.output, nullptr, false);
    ASSERT_TRUE(object.is_object()) << json.output;
    for (const auto& [name, value] : object.items()) {
        const StatusRow* const row = protocol::find_status_row(name);
        ASSERT_NE(row, nullptr) << name;
        EXPECT_EQ(value.is_number(), row->kind == StatusKind::Number) << name << ": " << value;
        EXPECT_EQ(value.is_string(), row->kind == StatusKind::Word) << name << ": " << value;
    }
}

} // namespace
} // namespace raymarch::tests
