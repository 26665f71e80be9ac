// SPDX-License-Identifier: MIT
#include "drivers/mapped_window.hpp"

#include "base/file_target.hpp"
#include "drivers/bus_fault.hpp"
#include "drivers/lock_file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cassert>
#include <cerrno>

namespace raymarch::drivers
{
namespace
{

std::size_t page_size() noexcept
{
    return static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

/// Returns false if the UIO device has no interrupt.
bool unmask_interrupt(int fd) noexcept
{
    const std::uint32_t on = 1;
    return ::write(fd, &on, sizeof on) == static_cast<ssize_t>(sizeof on);
}

/// Locks the window, because two services would overwrite each other's words. On a file system
/// without locks the window is used without one.
Result<void> claim(int fd, const std::string& name)
{
    auto locked = lock_descriptor(fd, name);
    if (!locked && !held_by_another(locked.error()))
        return {};
    return locked;
}

} // namespace

MappedWindow::MappedWindow(UniqueFd fd, std::string name, Mapping mapping,
                           bool has_interrupt) noexcept
    : fd_(std::move(fd))
    , name_(std::move(name))
    , mapping_(mapping)
    , has_interrupt_(has_interrupt)
{}

MappedWindow::~MappedWindow()
{
    unwatch_mapping(mapping_.base);
    ::munmap(mapping_.base, mapping_.length);
}

Result<std::unique_ptr<MappedWindow>>
MappedWindow::map(UniqueFd fd, std::string name, std::size_t bytes, std::size_t offset, bool is_uio)
{
    const std::size_t page = page_size();
    const std::size_t length = (offset + bytes + page - 1) / page * page;
    void* const base = ::mmap(nullptr, length, PROT_READ | PROT_WRITE, MAP_SHARED, fd.get(), 0);
    if (base == MAP_FAILED)
        return fail(errno_error(ErrorKind::InputOutput, "map", name));
    if (!watch_mapping(base, length)) {
        ::munmap(base, length);
        return fail(plain_error(ErrorKind::Unavailable, "map " + name + ": too many windows"));
    }
    const bool has_interrupt = is_uio && unmask_interrupt(fd.get());
    return std::unique_ptr<MappedWindow>(new MappedWindow(
        std::move(fd), std::move(name), {base, length, offset, bytes}, has_interrupt));
}

Result<std::unique_ptr<MappedWindow>> MappedWindow::open_uio(const UioDevice& device,
                                                             std::size_t bytes)
{
    if (device.size < bytes)
        return fail(plain_error(ErrorKind::Unavailable,
                                device.node + " has " + std::to_string(device.size) +
                                    " bytes of registers (maps/map0/size), not the " +
                                    std::to_string(bytes) + " that the block takes"));
    if (device.offset >= page_size())
        return fail(plain_error(ErrorKind::Unavailable,
                                device.node + ": maps/map0/offset must lie within one page"));
    UniqueFd fd(::open(device.node.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK | O_SYNC));
    if (!fd)
        return fail(errno_error(ErrorKind::Unavailable, "open", device.node));
    if (auto claimed = claim(fd.get(), device.node); !claimed)
        return fail(claimed.error());
    return map(std::move(fd), device.node, bytes, device.offset, true);
}

Result<std::unique_ptr<MappedWindow>> MappedWindow::open_file(const std::string& path,
                                                              std::size_t bytes)
{
    struct stat info = {}; // checked before open(), because opening a device may start it
    if (::stat(path.c_str(), &info) == 0 && !S_ISREG(info.st_mode))
        return fail(plain_error(ErrorKind::Unavailable, not_a_file(path, info.st_mode).message));
    UniqueFd fd(::open(path.c_str(), O_RDWR | O_CREAT | O_NONBLOCK | O_NOCTTY | O_CLOEXEC, 0644));
    if (!fd)
        return fail(errno_error(ErrorKind::Unavailable, "open", path));
    if (::fstat(fd.get(), &info) != 0)
        return fail(errno_error(ErrorKind::InputOutput, "stat", path));
    if (!S_ISREG(info.st_mode))
        return fail(plain_error(ErrorKind::Unavailable, not_a_file(path, info.st_mode).message));
    if (auto claimed = claim(fd.get(), path); !claimed) // before the file changes
        return fail(claimed.error());
    if (info.st_size < static_cast<off_t>(bytes) &&
        ::ftruncate(fd.get(), static_cast<off_t>(bytes)) != 0)
        return fail(errno_error(ErrorKind::InputOutput, "extend", path));
    return map(std::move(fd), path, bytes, 0, false);
}

std::uint32_t MappedWindow::read(RegOffset at) noexcept
{
    assert(at.bytes % 4 == 0 && mapping_.offset + at.bytes + 4 <= mapping_.length);
    const auto* const bytes = static_cast<const std::byte*>(mapping_.base);
    const auto* const word =
        reinterpret_cast<const volatile std::uint32_t*>(bytes + mapping_.offset + at.bytes);
    return *word;
}

void MappedWindow::write(RegOffset at, std::uint32_t word) noexcept
{
    assert(at.bytes % 4 == 0 && mapping_.offset + at.bytes + 4 <= mapping_.length);
    auto* const bytes = static_cast<std::byte*>(mapping_.base);
    // Release order: hardware or a process that sees this word also sees all words written before
    // it. COMMIT relies on that.
    __atomic_store_n(reinterpret_cast<volatile std::uint32_t*>(bytes + mapping_.offset + at.bytes),
                     word, __ATOMIC_RELEASE);
}

int MappedWindow::interrupt_fd() const noexcept
{
    return has_interrupt_ ? fd_.get() : -1;
}

void MappedWindow::arm_interrupt() noexcept
{
    // If the device has lost its interrupt, the next read reports it.
    if (has_interrupt_)
        static_cast<void>(unmask_interrupt(fd_.get()));
}

Result<std::uint32_t> MappedWindow::take_interrupt()
{
    std::uint32_t count = 0;
    if (::read(fd_.get(), &count, sizeof count) != static_cast<ssize_t>(sizeof count))
        return fail(errno_error(ErrorKind::InputOutput, "read the interrupt count of", name_));
    return count;
}

bool MappedWindow::lost() const noexcept
{
    return mapping_faulted(mapping_.base) || !still_there();
}

/// A mapping keeps a removed file alive. If a file is truncated in the middle of a page, the rest
/// of the page reads as zeros without a fault. So the name and the size are checked.
bool MappedWindow::still_there() const noexcept
{
    struct stat opened = {};
    struct stat named = {};
    if (::fstat(fd_.get(), &opened) != 0)
        return false;
    if (::stat(name_.c_str(), &named) != 0)
        return errno != ENOENT && errno != ENOTDIR; // EACCES, for example, tells nothing
    if (opened.st_dev != named.st_dev || opened.st_ino != named.st_ino)
        return false;
    return !S_ISREG(opened.st_mode) ||
           opened.st_size >= static_cast<off_t>(mapping_.offset + mapping_.bytes);
}

} // namespace raymarch::drivers
