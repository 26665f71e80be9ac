// SPDX-License-Identifier: MIT
/// @file
/// An array with room for the largest table. It copies and compares only the items in use, so a
/// state of 17 numbers costs 17 numbers, whatever the largest accelerator needs.
#pragma once

#include <algorithm>
#include <cstddef>

namespace raymarch::protocol
{

template <typename T, std::size_t Capacity>
class Counted
{
  public:
    /// Makes an array of all items, each zero.
    constexpr Counted() noexcept : Counted(Capacity) {}
    /// Makes an array of `size` items, each zero.
    constexpr explicit Counted(std::size_t size) noexcept : size_(size)
    {
        std::fill_n(items_, size, T{});
    }
    constexpr Counted(const Counted& other) noexcept : size_(other.size_)
    {
        std::copy_n(other.items_, size_, items_);
    }
    constexpr Counted& operator=(const Counted& other) noexcept
    {
        if (this != &other)
            std::copy_n(other.items_, size_ = other.size_, items_);
        return *this;
    }
    ~Counted() = default;

    /// Adds an item at the end. Precondition: there is room.
    constexpr void push_back(const T& item) noexcept { items_[size_++] = item; }

    [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }
    [[nodiscard]] constexpr T& operator[](std::size_t i) noexcept { return items_[i]; }
    [[nodiscard]] constexpr const T& operator[](std::size_t i) const noexcept { return items_[i]; }
    [[nodiscard]] constexpr T* data() noexcept { return items_; }
    [[nodiscard]] constexpr const T* data() const noexcept { return items_; }
    [[nodiscard]] constexpr T* begin() noexcept { return items_; }
    [[nodiscard]] constexpr const T* begin() const noexcept { return items_; }
    [[nodiscard]] constexpr T* end() noexcept { return items_ + size_; }
    [[nodiscard]] constexpr const T* end() const noexcept { return items_ + size_; }

    /// Compares two arrays. If one is longer, its remaining items must be zero.
    [[nodiscard]] friend constexpr bool operator==(const Counted& a, const Counted& b) noexcept
    {
        const Counted& longer = a.size_ > b.size_ ? a : b;
        const std::size_t common = std::min(a.size_, b.size_);
        return std::equal(a.begin(), a.begin() + common, b.begin()) &&
               std::all_of(longer.begin() + common, longer.end(),
                           [](T item) { return item == T{}; });
    }

  private:
    std::size_t size_;
    T items_[Capacity]; // NOLINT(*-avoid-c-arrays): items from `size_` on are not initialised
};

} // namespace raymarch::protocol
