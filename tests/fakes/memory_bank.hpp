// SPDX-License-Identifier: MIT
/// @file
/// GPIO lines without a board: pins by name, each of which can be missing or break.
#pragma once

#include "drivers/gpio_line.hpp"
#include "tests/fakes/memory_pin.hpp"

#include <cerrno>
#include <map>
#include <memory>
#include <set>
#include <string>

namespace raymarch::test
{

class MemoryBank
{
  public:
    /// The line of that name; it stays while lines are opened and closed.
    [[nodiscard]] MemoryPin& operator[](const std::string& name) { return pins_[name]; }

    /// As drivers::open_gpio_line, by name only; one opening at a time.
    [[nodiscard]] Result<std::unique_ptr<drivers::Pin>> open(const drivers::LineSpec& spec,
                                                             drivers::LineUse use)
    {
        ++attempts;
        const drivers::LinePlace& place = spec.places.front();
        if (no_chip && !place.chip.empty())
            return fail(Error{ErrorKind::Unavailable, ENOENT, "no " + place.chip});
        if (no_chip)
            return fail(Error{ErrorKind::Unavailable, ENODEV, "there is no GPIO chip"});
        const std::string& name = place.name;
        if (missing.contains(name) || open_.contains(name))
            return fail(plain_error(ErrorKind::Unavailable, "no GPIO line is named " + name));
        open_[name] = use;
        return std::make_unique<Handle>(*this, name);
    }
    [[nodiscard]] bool is_open(const std::string& name) const { return open_.contains(name); }
    [[nodiscard]] std::size_t open_count() const { return open_.size(); }
    [[nodiscard]] drivers::LineUse use(const std::string& name) const { return open_.at(name); }

    std::set<std::string> missing;
    std::set<std::string> broken;  ///< open, but every call fails
    std::set<std::string> unheard; ///< report no edges
    bool no_chip = false;
    int attempts = 0;

  private:
    class Handle final : public drivers::Pin
    {
      public:
        Handle(MemoryBank& bank, std::string name) : bank_(bank), name_(std::move(name)) {}
        ~Handle() override { bank_.open_.erase(name_); }
        [[nodiscard]] Result<bool> read() override
        {
            if (broken())
                return fail(gone());
            return bank_[name_].read();
        }
        [[nodiscard]] Result<void> write(bool on) override
        {
            if (broken())
                return fail(gone());
            return bank_[name_].write(on);
        }
        [[nodiscard]] int edge_fd() const noexcept override
        {
            return bank_.unheard.contains(name_) ? -1 : bank_[name_].edge_fd();
        }
        [[nodiscard]] Result<std::optional<drivers::Edge>> take_edge() override
        {
            if (broken())
                return fail(gone());
            return bank_[name_].take_edge();
        }

      private:
        [[nodiscard]] bool broken() const { return bank_.broken.contains(name_); }
        [[nodiscard]] Error gone() const
        {
            return plain_error(ErrorKind::InputOutput, name_ + ": No such device");
        }
        MemoryBank& bank_;
        std::string name_;
    };

    std::map<std::string, MemoryPin> pins_;
    std::map<std::string, drivers::LineUse> open_;
};

} // namespace raymarch::test
