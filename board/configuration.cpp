// SPDX-License-Identifier: MIT
#include "board/configuration.hpp"

#include "board/configuration_crc.hpp"

#include <fmt/format.h>

namespace raymarch::board
{
namespace
{

constexpr std::uint32_t sync_word = 0xAA99'5566;
constexpr std::uint32_t sync_word_swapped = 0x6655'99AA;
constexpr std::uint32_t revision_mask = 0xF000'0000;

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

/// Follows the words from the sync word to the command that ends the configuration. It does what
/// the configuration logic does with them, as far as that tells whether they are right.
class Configuration
{
  public:
    Configuration(const ConfigurationWords& words, const std::string& name, Bitstream& bitstream)
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
        return fail(bad_bitstream(name_, what));
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
    /// packet of type 1 names the register, `target`. A packet of type 2 can be longer; it uses
    /// the register of the packet before it. Only the registers for frames take more than one word.
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

    /// `after_end` is the first word after the end.
    Result<void> finish(std::size_t after_end)
    {
        if (!idcode_)
            return refuse("it names no device (IDCODE); encrypted bitstreams are not taken");
        if (any_check_ && last_write_) // the packet of the last check sequence is damaged
            return damaged(words_[*last_write_], *last_write_,
                           "is not covered by a check sequence");
        // A damaged word may look like the command that ends the configuration.
        for (std::size_t at = after_end; at < words_.size(); ++at)
            if (!is_idle(words_[at]))
                return damaged(words_[at], at, "follows the command that ends the configuration");
        bitstream_.idcode = *idcode_;
        bitstream_.checked = any_check_ && !frames_unchecked_;
        return {};
    }

    const ConfigurationWords& words_;
    const std::string& name_;
    Bitstream& bitstream_;
    ConfigurationCrc crc_;
    std::optional<std::uint32_t> idcode_;
    std::optional<std::size_t>
        last_write_;              ///< not of IDCODE or a command; since the check sequence started
    bool frames_pending_ = false; ///< frame data has been written since then
    bool frames_unchecked_ = false;
    bool any_check_ = false;
    bool ended_ = false;
};

} // namespace

Result<void> read_configuration(const ConfigurationWords& words, const std::string& name,
                                Bitstream& bitstream)
{
    const auto sync = words.find(sync_word);
    if (sync)
        return Configuration(words, name, bitstream).run(*sync + 1);
    if (!words.find(sync_word_swapped))
        return fail(bad_bitstream(name, "there is no sync word: no bitstream"));
    return fail(bad_bitstream(
        name, bitstream.form == BitstreamForm::Bin
                  ? "the bytes of its words are not swapped, as a .bin for the Zynq's "
                    "are: give the .bit"
                  : "the bytes of its words are swapped, which those of a .bit are "
                    "not"));
}

} // namespace raymarch::board
