// SPDX-License-Identifier: MIT
/// @file
/// Maps a register window into memory: a UIO device, or an ordinary file in its place.
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
    std::string node;          ///< `/dev/uio0`
    std::string name;          ///< its name in the device tree
    std::uint64_t address = 0; ///< the physical address of the region
    std::size_t size = 0;      ///< the size of the region in bytes
    std::size_t offset = 0;    ///< the offset of the region in its first page
};

/// An open, mapped window owns its descriptor and its mapping.
///
/// Each access is one aligned 32-bit load or store in program order; nothing is cached or retried.
/// If the memory goes away (a truncated file, an unbound device), loads return zeros and lost()
/// returns true. lost() is also true if the name leads to another file or to none, or if the file
/// is too short. The file or device is locked while the window is open. The class is not
/// thread-safe. At most eight windows can be open.
class MappedWindow final : public RegisterBus
{
  public:
    /// Maps the first region of a UIO device, and unmasks its interrupt if it has one. Errors:
    /// Unavailable (the region is smaller than `bytes`, there is no device, or another process has
    /// it, as held_by_another() tells), InputOutput.
    [[nodiscard]] static Result<std::unique_ptr<MappedWindow>> open_uio(const UioDevice& device,
                                                                        std::size_t bytes);

    /// Maps an ordinary file. It is made if it does not exist, and extended with zeros to `bytes`.
    /// Errors: Unavailable (also if another process has it, as held_by_another() tells),
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
        void* base;         ///< page-aligned
        std::size_t length; ///< a multiple of the page size
        std::size_t offset; ///< the offset of register 0 from the base
        std::size_t bytes;  ///< the size of all registers
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
