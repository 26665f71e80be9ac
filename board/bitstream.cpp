// SPDX-License-Identifier: MIT
#include "board/bitstream.hpp"

#include "board/configuration_crc.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

namespace raymarch::board
{
namespace
{

using Bytes = std::span<const std::uint8_t>;

constexpr std::uint32_t sync_word = 0xAA99'5566;
constexpr std::uint32_t sync_word_swapped = 0x6655'99AA;
constexpr std::uint32_t revision_mask = 0xF000'0000;

/// A `.bit` begins with a field of 9 bytes, and the 16-bit number 1 before the lettered fields.
constexpr std::array<std::uint8_t, 13> bit_magic = {0x00, 0x09, 0x0F, 0xF0, 0x0F, 0xF0, 0x0F,
                                                    0xF0, 0x0F, 0xF0, 0x00, 0x00, 0x01};

/// These are registers of the configuration logic, and commands of the command register.
constexpr std::uint32_t crc_register = 0;
constexpr std::uint32_t frame_data_register = 2;
constexpr std::uint32_t command_register = 4;
constexpr std::uint32_t multiple_frame_register = 10;
constexpr std::uint32_t idcode_register = 12;
constexpr std::uint32_t register_count = 32;
constexpr std::uint32_t reset_crc_command = 7;
constexpr std::uint32_t desync_command = 13;
constexpr std::uint32_t command_count = 32;

/// Some tools write this in place of a check sequence when they are told to compute none. Others
/// reset the sequence instead.
constexpr std::uint32_t no_crc = 0x0000'DEFC;
constexpr std::uint32_t no_operation = 0x2000'0000;

Error bad(const std::string& name, std::string_view what)
{
    return plain_error(ErrorKind::BadData, fmt::format("{}: {}", name, what));
}

/// Reads a big-endian number of `count` bytes. Precondition: they are there.
std::uint32_t number(Bytes bytes, std::size_t at, std::size_t count)
{
    std::uint32_t value = 0;
    for (const std::uint8_t byte : bytes.subspan(at, count))
        value = value << 8 | byte;
    return value;
}

/// Configuration words, in either byte order.
class Words
{
  public:
    Words(Bytes data, BitstreamForm form) : data_(data), form_(form) {}
    [[nodiscard]] std::size_t size() const { return data_.size() / 4; }
    [[nodiscard]] std::uint32_t operator[](std::size_t index) const
    {
        const std::uint32_t word = number(data_, 4 * index, 4);
        return form_ == BitstreamForm::Bit ? word : __builtin_bswap32(word);
    }
    [[nodiscard]] std::optional<std::size_t> find(std::uint32_t wanted) const
    {
        for (std::size_t i = 0; i < size(); ++i)
            if ((*this)[i] == wanted)
                return i;
        return std::nullopt;
    }

  private:
    Bytes data_;
    BitstreamForm form_;
};

/// Reads the header of a `.bit`, up to its data.
Result<void> read_header(Bytes bytes, const std::string& name, Bitstream& bitstream)
{
    struct Field
    {
        char letter;
        std::string Bitstream::*text;
    };
    constexpr std::array fields = {Field{'a', &Bitstream::design}, Field{'b', &Bitstream::part},
                                   Field{'c', &Bitstream::date}, Field{'d', &Bitstream::time}};
    const Error cut = bad(name, "the header of the .bit is cut or damaged");
    std::size_t at = bit_magic.size();
    for (const auto& [letter, text] : fields) {
        if (bytes.size() < at + 3 || bytes[at] != static_cast<std::uint8_t>(letter))
            return fail(cut);
        const std::size_t length = number(bytes, at + 1, 2);
        at += 3;
        if (bytes.size() < at + length)
            return fail(cut);
        const Bytes value = bytes.subspan(at, length);
        (bitstream.*text).assign(value.begin(), std::find(value.begin(), value.end(), 0));
        at += length;
    }
    if (bytes.size() < at + 5 || bytes[at] != 'e')
        return fail(cut);
    const std::size_t length = number(bytes, at + 1, 4);
    bitstream.data = bytes.subspan(at + 5);
    if (bitstream.data.size() != length)
        return fail(bad(name, fmt::format("the header says {} bytes of data, and there are {}",
                                          length, bitstream.data.size())));
    return {};
}

/// Follows the words from the sync word to the command that ends the configuration. It does what
/// the configuration logic does with them, as far as that tells whether they are right.
class Configuration
{
  public:
    Configuration(const Words& words, const std::string& name, Bitstream& bitstream)
        : words_(words)
        , name_(name)
        , bitstream_(bitstream)
    {}

    Result<void> run(std::size_t at)
    {
        std::optional<std::uint32_t> target; // the register of the packet just before
        while (at < words_.size()) {
            const std::size_t start = at++;
            const std::uint32_t header = words_[start];
            if (is_idle(header)) {
                target.reset();
                continue;
            }
            const auto count = word_count(header, target);
            if (!count)
                return damaged(header, start, "is no packet of a write");
            if (*count > words_.size() - at)
                break;
            for (const std::size_t end = at + *count; at < end; ++at) {
                if (auto written = write(*target, at); !written)
                    return written;
                if (ended_)
                    return finish(at + 1);
            }
            bitstream_.repeated_frames += *target == multiple_frame_register && *count > 0 ? 1 : 0;
        }
        return refuse("it is cut: the command that ends the configuration is missing");
    }

  private:
    [[nodiscard]] Result<void> refuse(std::string_view what) const
    {
        return fail(bad(name_, what));
    }
    [[nodiscard]] Result<void> damaged(std::uint32_t word, std::size_t at,
                                       std::string_view what) const
    {
        return refuse(fmt::format("damaged: {:08X} at byte {} of the data {}", word, 4 * at, what));
    }

    static bool is_idle(std::uint32_t word)
    {
        return word == no_operation || word == 0 || word == 0xFFFF'FFFF;
    }

    /// Returns how many words follow the header of a write, and nothing for another header. A
    /// packet of type 1 names the register, `target`. A packet of type 2 can be longer; it follows
    /// one of type 1 at once. Only the registers for frames take more than one word.
    static std::optional<std::size_t> word_count(std::uint32_t header,
                                                 std::optional<std::uint32_t>& target)
    {
        constexpr std::uint32_t write_1 = 0x3000'0000;
        constexpr std::uint32_t write_2 = 0x5000'0000;
        const auto takes_more = [](std::uint32_t address) {
            return address == frame_data_register || address == multiple_frame_register;
        };
        if ((header & 0xF800'0000) == write_2 && takes_more(target.value_or(register_count)))
            return header & 0x07FF'FFFF;
        const std::uint32_t address = header >> 13 & 0x3FFF;
        const std::size_t count = header & 0x7FF;
        if ((header & 0xF800'1800) != write_1 || address >= register_count ||
            (count != 1 && !takes_more(address)))
            return std::nullopt;
        target = address;
        return count;
    }

    Result<void> write(std::uint32_t target, std::size_t at)
    {
        const std::uint32_t word = words_[at];
        if (target == crc_register)
            return compare(at);
        crc_.add(target, word);
        switch (target) {
        case frame_data_register:
            ++bitstream_.frame_words;
            frames_pending_ = true;
            break;
        case multiple_frame_register:
            bitstream_.compressed = true;
            break;
        case idcode_register:
            return take_idcode(word & ~revision_mask);
        case command_register:
            return take_command(at);
        default:
            break;
        }
        last_write_ = at;
        return {};
    }

    Result<void> compare(std::size_t at)
    {
        const std::uint32_t given = words_[at];
        if (given != no_crc && given != crc_.value())
            return damaged(
                given, at,
                fmt::format("is the check sequence of words that give {:08X}", crc_.value()));
        any_check_ = any_check_ || given != no_crc;
        start_check(given != no_crc);
        return {};
    }

    /// Starts the check sequence anew. `compared` says whether it was compared before.
    void start_check(bool compared)
    {
        frames_unchecked_ = frames_unchecked_ || (frames_pending_ && !compared);
        frames_pending_ = false;
        last_write_.reset();
        crc_.reset();
    }

    Result<void> take_idcode(std::uint32_t idcode)
    {
        if (idcode_ && *idcode_ != idcode)
            return refuse(fmt::format("it names two devices, with IDCODE {:08X} and {:08X}",
                                      *idcode_, idcode));
        idcode_ = idcode;
        return {};
    }

    Result<void> take_command(std::size_t at)
    {
        const std::uint32_t command = words_[at];
        if (command >= command_count)
            return damaged(command, at, "is no command");
        if (command == reset_crc_command)
            start_check(false);
        ended_ = command == desync_command;
        return {};
    }

    /// `behind` is the first word after the end.
    Result<void> finish(std::size_t behind)
    {
        if (!idcode_)
            return refuse("it names no device (IDCODE); encrypted bitstreams are not taken");
        if (any_check_ && last_write_) // the packet of the last check sequence is damaged
            return damaged(words_[*last_write_], *last_write_, "stands under no check sequence");
        // A damaged word may look like the command that ends the configuration.
        for (std::size_t at = behind; at < words_.size(); ++at)
            if (!is_idle(words_[at]))
                return damaged(words_[at], at, "follows the command that ends the configuration");
        bitstream_.idcode = *idcode_;
        bitstream_.checked = any_check_ && !frames_unchecked_;
        return {};
    }

    const Words& words_;
    const std::string& name_;
    Bitstream& bitstream_;
    ConfigurationCrc crc_;
    std::optional<std::uint32_t> idcode_;
    std::optional<std::size_t> last_write_; ///< since the check sequence last started
    bool frames_pending_ = false;           ///< frame data has been written since then
    bool frames_unchecked_ = false;
    bool any_check_ = false;
    bool ended_ = false;
};

/// Finds the sync word, and reads from there to the command that ends the configuration.
/// Errors: BadData.
Result<void> read_words(const Words& words, const std::string& name, Bitstream& bitstream)
{
    const auto sync = words.find(sync_word);
    if (sync)
        return Configuration(words, name, bitstream).run(*sync + 1);
    if (!words.find(sync_word_swapped))
        return fail(bad(name, "there is no sync word: no bitstream"));
    return fail(bad(name, bitstream.form == BitstreamForm::Bin
                              ? "the bytes of its words are not swapped, as a .bin for the Zynq's "
                                "are: give the .bit"
                              : "the bytes of its words are swapped, which those of a .bit are "
                                "not"));
}

char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Returns a part as Vivado's header has it: in small letters, without `xc`, and without the speed
/// grade and the range of temperatures (`-1`, `-2`, `-1LI`). Other text stays as it is.
std::string plain_part(std::string_view text)
{
    std::string part(text);
    std::ranges::transform(part, part.begin(), lower);
    if (part.starts_with("xc"))
        part.erase(0, 2);
    const std::size_t dash = part.find('-');
    if (dash == std::string::npos)
        return part;
    const std::string_view grade = std::string_view(part).substr(dash + 1);
    if (grade.empty() || grade.size() > 3 || grade[0] < '1' || grade[0] > '3' ||
        grade.find_first_not_of("ceilmq", 1) != std::string_view::npos)
        return std::string(text);
    part.resize(dash);
    return part;
}

Result<void> check_part(const std::string& part, const LogicDevice& device, const std::string& name)
{
    const std::string plain = plain_part(part);
    if (plain == device.part)
        return {};
    const std::string_view die = device.part.substr(0, device.part.find("clg"));
    return fail(bad(
        name,
        fmt::format("it is for part {}, the board's is {}{}", part, device.part,
                    plain.starts_with(die) ? ": the package, and so the pins, are others" : "")));
}

} // namespace

Result<Bitstream> parse_bitstream(Bytes bytes, const std::string& name)
{
    Bitstream bitstream;
    if (bytes.size() >= bit_magic.size() &&
        std::equal(bit_magic.begin(), bit_magic.end(), bytes.begin())) {
        bitstream.form = BitstreamForm::Bit;
        if (auto header = read_header(bytes, name, bitstream); !header)
            return fail(header.error());
    } else {
        bitstream.data = bytes;
    }
    if (bitstream.data.size() % 4 != 0)
        return fail(bad(
            name, fmt::format("{} bytes of data are no whole words of 4", bitstream.data.size())));
    if (auto read = read_words({bitstream.data, bitstream.form}, name, bitstream); !read)
        return fail(read.error());
    return bitstream;
}

Result<void> check_bitstream(const Bitstream& bitstream, const LogicDevice& device,
                             const std::string& name)
{
    constexpr std::size_t padding = 64; // what tools may add
    const std::size_t size = bitstream.data.size();
    if (bitstream.form == BitstreamForm::Bit)
        if (auto fits = check_part(bitstream.part, device, name); !fits)
            return fits;
    if (bitstream.idcode != device.idcode)
        return fail(bad(name, fmt::format("it is for the device with IDCODE {:08X}, the board's "
                                          "is {:08X}",
                                          bitstream.idcode, device.idcode)));
    if (bitstream.design.find("PARTIAL=TRUE") != std::string::npos)
        return fail(bad(name, "it configures only a part of the logic"));
    if (size > device.bitstream_bytes + padding ||
        (!bitstream.compressed && size < device.bitstream_bytes))
        return fail(bad(name, fmt::format("{} bytes of data; a whole bitstream of {} has {}{}",
                                          size, device.part, device.bitstream_bytes,
                                          bitstream.compressed ? " at most" : "")));
    const std::size_t frames = bitstream.frame_words / words_a_frame + bitstream.repeated_frames;
    const std::size_t whole = device.frames + (bitstream.compressed ? 0 : device.padding_frames);
    if (frames < whole)
        return fail(bad(name, fmt::format("it configures only a part of the logic: {} frames; a "
                                          "whole bitstream of {} has {}",
                                          frames, device.part, whole)));
    return {};
}

std::vector<std::uint8_t> bin_of(const Bitstream& bitstream)
{
    std::vector<std::uint8_t> bytes(bitstream.data.begin(), bitstream.data.end());
    if (bitstream.form == BitstreamForm::Bit)
        for (std::size_t i = 0; i + 4 <= bytes.size(); i += 4)
            std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(i),
                         bytes.begin() + static_cast<std::ptrdiff_t>(i + 4));
    return bytes;
}

} // namespace raymarch::board
