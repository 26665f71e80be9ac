// SPDX-License-Identifier: MIT
#include "drivers/mapped_window.hpp"

#include "drivers/bus_fault.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <optional>
#include <vector>

namespace raymarch::drivers
{
namespace
{

namespace fs = std::filesystem;

std::string first_line(const fs::path& path)
{
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    return line;
}

/// sysfs prints sizes and offsets as 0x….
std::optional<std::size_t> hex_number(std::string_view text)
{
    if (text.starts_with("0x"))
        text.remove_prefix(2);
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
    if (error != std::errc{} || end != text.data() + text.size())
        return std::nullopt;
    return value;
}

std::size_t page_size() noexcept
{
    return static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

/// Whether a UIO device has an interrupt line: only then can it be unmasked.
bool unmask_interrupt(int fd) noexcept
{
    const std::uint32_t on = 1;
    return ::write(fd, &on, sizeof on) == static_cast<ssize_t>(sizeof on);
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
    return std::unique_ptr<MappedWindow>(
        new MappedWindow(std::move(fd), std::move(name), {base, length, offset}, has_interrupt));
}

Result<std::unique_ptr<MappedWindow>>
MappedWindow::open_uio(const std::string& device, std::size_t bytes, const std::string& sysfs_root)
{
    UniqueFd fd(::open(device.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK | O_SYNC));
    if (!fd)
        return fail(errno_error(ErrorKind::Unavailable, "open", device));
    const fs::path region =
        fs::path(sysfs_root) / "class/uio" / fs::path(device).filename() / "maps/map0";
    const auto size = hex_number(first_line(region / "size"));
    const auto offset = hex_number(first_line(region / "offset"));
    if (!size || *size < bytes)
        return fail(plain_error(ErrorKind::Unavailable, device + ": " + (region / "size").string() +
                                                            " must say at least " +
                                                            std::to_string(bytes) + " bytes"));
    if (offset.value_or(0) >= page_size())
        return fail(plain_error(ErrorKind::Unavailable,
                                (region / "offset").string() + " must lie within one page"));
    return map(std::move(fd), device, bytes, offset.value_or(0), true);
}

Result<std::unique_ptr<MappedWindow>> MappedWindow::open_file(const std::string& path,
                                                              std::size_t bytes)
{
    UniqueFd fd(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644));
    if (!fd)
        return fail(errno_error(ErrorKind::Unavailable, "open", path));
    struct stat info = {};
    if (::fstat(fd.get(), &info) != 0)
        return fail(errno_error(ErrorKind::InputOutput, "stat", path));
    if (!S_ISREG(info.st_mode))
        return fail(plain_error(ErrorKind::Unavailable, path + " is not an ordinary file"));
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
    // Released: whoever sees this word, hardware or a process at the same file, sees those written
    // before it. COMMIT relies on that.
    __atomic_store_n(reinterpret_cast<volatile std::uint32_t*>(bytes + mapping_.offset + at.bytes),
                     word, __ATOMIC_RELEASE);
}

int MappedWindow::interrupt_fd() const noexcept
{
    return has_interrupt_ ? fd_.get() : -1;
}

void MappedWindow::arm_interrupt() noexcept
{
    // A device that has lost its line reports that at the next read.
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
    return mapping_faulted(mapping_.base);
}

Result<std::string> find_uio(const std::string& name, const std::string& sysfs_root)
{
    const fs::path devices = fs::path(sysfs_root) / "class/uio";
    std::vector<std::string> found;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(devices, error))
        if (first_line(entry.path() / "name") == name)
            found.push_back("/dev/" + entry.path().filename().string());
    if (found.size() == 1)
        return found.front();
    if (found.empty())
        return fail(plain_error(ErrorKind::Unavailable, "no UIO device is named " + name + " (" +
                                                            devices.string() + "/*/name)"));
    return fail(plain_error(ErrorKind::Config,
                            std::to_string(found.size()) + " UIO devices are named " + name));
}

} // namespace raymarch::drivers
