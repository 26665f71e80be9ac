// SPDX-License-Identifier: MIT
/// @file
/// The threads that draw: started once, they wait between pictures.
#pragma once

#include "engine/model.hpp"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

namespace raymarch::engine
{

/// Names what is drawn, and which of the ways to the same bytes draws it.
struct Drawing
{
    const Model& model;
    WordSpan words;
    const Kernel* kernel = nullptr; ///< nullptr: the reference
    std::unique_ptr<const Picture> picture = model.latch(words);
};

/// Draws one picture at a time; used from one thread.
class Painter
{
  public:
    /// `threads` from 1, the caller's among them; 0 means one for each processor.
    explicit Painter(unsigned threads = 0);
    ~Painter();
    Painter(const Painter&) = delete;
    Painter& operator=(const Painter&) = delete;

    [[nodiscard]] unsigned threads() const noexcept
    {
        return static_cast<unsigned>(helpers_.size()) + 1;
    }

    /// Draws the region's pixels: the same bytes for any number of threads. When a stop is
    /// requested the picture is left unfinished, at the latest one band of rows a thread later.
    /// Picture::complete is the caller's.
    void draw(const Drawing& drawing, const Region& region, const Canvas& canvas,
              const std::stop_token& stop = {});

    /// Hears, on the thread that draws, how many of the parts of a picture have been taken, each
    /// time that this thread has done one.
    using Listener = std::function<void(unsigned taken, unsigned parts)>;
    void listen(Listener listener) { listener_ = std::move(listener); }

  private:
    static constexpr unsigned shut = 1U << 31;

    /// Calls work(0) to work(parts - 1), each once, from all threads that are awake in time.
    void share(unsigned parts, const std::function<void(unsigned)>& work);
    void take_parts(const Listener& listener);
    void help();

    Listener listener_;
    std::vector<PixelCost> unwanted_; ///< costs of the reference that nobody asked for

    // One job: set before it is opened, kept until it is shut and no helper is in it.
    const std::function<void(unsigned)>* work_ = nullptr;
    unsigned parts_ = 0;
    std::atomic<unsigned> next_ = 0;
    std::atomic<unsigned> inside_ = shut; ///< helpers in the job; with `shut`: nobody may enter
    std::atomic<unsigned> round_ = 0;     ///< counts jobs: what helpers wait for
    std::atomic<bool> closing_ = false;
    std::vector<std::jthread> helpers_; ///< last: they use all of the above
};

} // namespace raymarch::engine
