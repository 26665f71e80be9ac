// SPDX-License-Identifier: MIT
#include "board/flat_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace raymarch::board
{
namespace
{

constexpr std::uint32_t tree_magic = 0xD00D'FEED;
constexpr std::size_t cell_bytes = sizeof(std::uint32_t);

/// The header's cells, by number.
enum HeaderCell : std::uint8_t { magic, total_bytes, structure_at, strings_at, header_cells = 10 };

enum Token : std::uint32_t { begin_node = 1, end_node = 2, property = 3, nop = 4, end = 9 };

/// Reads cell by cell. A function returns nothing if too few bytes are left.
class Reader
{
  public:
    explicit Reader(TreeBytes bytes) : bytes_(bytes), rest_(bytes) {}
    [[nodiscard]] std::size_t at() const { return bytes_.size() - rest_.size(); }
    [[nodiscard]] std::optional<std::uint32_t> cell()
    {
        const auto value = bytes(cell_bytes);
        return value ? std::optional(cells_of(*value).front()) : std::nullopt;
    }
    /// Also skips the padding up to the next cell.
    [[nodiscard]] std::optional<TreeBytes> bytes(std::size_t count)
    {
        if (count > rest_.size())
            return std::nullopt;
        const TreeBytes taken = rest_.first(count);
        const std::size_t filled = (count + cell_bytes - 1) / cell_bytes * cell_bytes;
        rest_ = rest_.subspan(std::min(filled, rest_.size()));
        return taken;
    }
    /// Takes a string with its NUL.
    [[nodiscard]] std::optional<TreeBytes> text()
    {
        const auto nul = std::ranges::find(rest_, 0);
        return bytes(static_cast<std::size_t>(nul - rest_.begin()) + 1);
    }

  private:
    TreeBytes bytes_;
    TreeBytes rest_;
};

/// Returns whether the string at `at` is `name`.
bool is_named(TreeBytes strings, std::uint32_t at, std::string_view name)
{
    return at < strings.size() && name.size() < strings.size() - at &&
           std::ranges::equal(strings.subspan(at, name.size()), name) &&
           strings[at + name.size()] == 0;
}

/// Adds the values to `found`. Returns false if the structure ends too early, has an unknown token,
/// or is not a tree with one root, in which every property has a name and is inside a node.
bool walk(Reader& structure, TreeBytes strings, std::string_view name,
          std::vector<TreeBytes>& found)
{
    std::size_t depth = 0;
    bool any_root = false;
    for (;;) {
        switch (structure.cell().value_or(0)) {
        case begin_node:
            if (!structure.text() || (depth == 0 && std::exchange(any_root, true)))
                return false;
            ++depth;
            break;
        case property: {
            const auto length = structure.cell();
            const auto name_at = structure.cell();
            const auto value = length && name_at ? structure.bytes(*length) : std::nullopt;
            if (!value || *name_at >= strings.size() || depth == 0)
                return false;
            if (is_named(strings, *name_at, name))
                found.push_back(*value);
            break;
        }
        case end_node:
            if (depth-- == 0)
                return false;
            break;
        case nop:
            break;
        case end:
            return any_root && depth == 0;
        default:
            return false;
        }
    }
}

} // namespace

std::vector<std::uint32_t> cells_of(TreeBytes value)
{
    std::vector<std::uint32_t> cells(value.size() / cell_bytes);
    for (std::size_t i = 0; i < cells.size() * cell_bytes; ++i)
        cells[i / cell_bytes] = cells[i / cell_bytes] << 8 | value[i];
    return cells;
}

Result<void> check_tree_header(TreeBytes blob, const std::string& file)
{
    const auto bad = [&](const std::string& what) {
        return fail(plain_error(ErrorKind::BadData, file + ": " + what));
    };
    if (blob.size() < header_cells * cell_bytes || Reader(blob).cell() != tree_magic)
        return bad("it is not a compiled device tree (dtc -@ -I dts -O dtb makes one)");
    const auto header = cells_of(blob.first(header_cells * cell_bytes));
    if (header[total_bytes] != blob.size())
        return bad(fmt::format("its header says {} bytes, and there are {}", header[total_bytes],
                               blob.size()));
    for (const HeaderCell part : {structure_at, strings_at})
        if (header[part] > blob.size())
            return bad(fmt::format("its header says that a part begins at byte {}, after its end",
                                   header[part]));
    return {};
}

Result<std::vector<TreeBytes>> values_of(TreeBytes blob, std::string_view name,
                                         const std::string& file)
{
    if (auto begins = check_tree_header(blob, file); !begins)
        return fail(begins.error());
    const auto header = cells_of(blob.first(header_cells * cell_bytes));
    Reader structure(blob.subspan(header[structure_at]));
    std::vector<TreeBytes> found;
    if (walk(structure, blob.subspan(header[strings_at]), name, found))
        return found;
    return fail(plain_error(
        ErrorKind::BadData,
        fmt::format("{}: its nodes are cut or damaged before byte {}; compile or copy it again",
                    file, header[structure_at] + structure.at())));
}

} // namespace raymarch::board
