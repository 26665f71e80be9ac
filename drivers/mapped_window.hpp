// SPDX-License-Identifier: MIT
/// @file
/// A register window mapped into memory: a UIO device, or an ordinary file through the same code.
#pragma once

#include "base/result.hpp"
#include "base/unique_fd.hpp"
#include "drivers/ports.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace raymarch::drivers
{

/// One UIO device and its first region, map0.
struct UioDevice
{
    std::string node;          ///< what is opened: `/dev/uio0`
    std::string name;          ///< what the device tree calls it
    std::uint64_t address = 0; ///< of the region, physical
    std::size_t size = 0;      ///< of the region in bytes
    std::size_t offset = 0;    ///< of the region within its first page
};

/// An open, mapped window; owns the descriptor and the mapping.
///
/// Each access is one aligned 32-bit load or store in program order; nothing is cached or retried.
/// When the memory behind it goes away (a truncated file, an unbound device) the access that finds
/// out reads zeros and lost() turns true, in place of SIGBUS ending the process. lost() is true
/// also when the name leads to something else now (removed, replaced), or the file has become too
/// short. The file or device is locked as long as the window is open. Not thread-safe: the event
/// loop is the only user. At most eight windows at a time.
class MappedWindow final : public RegisterBus
{
  public:
    /// Maps the first region of a UIO device, and lets its first interrupt through where it has a
    /// line. Errors: Unavailable (a region smaller than `bytes`, found before the device is opened;
    /// no device; another process has it, as held_by_another() tells), InputOutput.
    [[nodiscard]] static Result<std::unique_ptr<MappedWindow>> open_uio(const UioDevice& device,
                                                                        std::size_t bytes);

    /// Maps an ordinary file of at least `bytes`; made, and filled up with zeros, if need be.
    /// Errors: Unavailable (also when another process has it, as held_by_another() tells),
    /// InputOutput.
    [[nodiscard]] static Result<std::unique_ptr<MappedWindow>> open_file(const std::string& path,
                                                                         std::size_t bytes);

    ~MappedWindow() override;

    [[nodiscard]] std::uint32_t read(RegOffset at) noexcept override;
    void write(RegOffset at, std::uint32_t word) noexcept override;
    [[nodiscard]] int interrupt_fd() const noexcept override;
    void arm_interrupt() noexcept override;
    [[nodiscard]] Result<std::uint32_t> take_interrupt() override;
    [[nodiscard]] bool lost() const noexcept override;

  private:
    struct Mapping
    {
        void* base;         ///< page-aligned, as mmap gave it
        std::size_t length; ///< whole pages
        std::size_t offset; ///< of register 0 from the base
        std::size_t bytes;  ///< of registers
    };
    MappedWindow(UniqueFd fd, std::string name, Mapping mapping, bool has_interrupt) noexcept;
    [[nodiscard]] static Result<std::unique_ptr<MappedWindow>>
    map(UniqueFd fd, std::string name, std::size_t bytes, std::size_t offset, bool is_uio);

    [[nodiscard]] bool still_there() const noexcept;

    UniqueFd fd_;
    std::string name_;
    Mapping mapping_;
    bool has_interrupt_;
};

} // namespace raymarch::drivers
