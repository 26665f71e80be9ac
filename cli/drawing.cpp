// SPDX-License-Identifier: MIT
#include "cli/drawing.hpp"

#include "cli/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <vector>

namespace raymarch::cli
{
namespace
{

using Milliseconds = std::chrono::duration<double, std::milli>;

constexpr unsigned most_threads = 256;
constexpr unsigned most_repetitions = 1'000'000;

/// Returns the names that --isa accepts here: the reference, and the kernels of this processor.
std::string names_here(const engine::Model& model)
{
    std::string names;
    for (const engine::IsaRow& row : engine::isa_rows)
        if (row.isa == engine::Isa::Scalar || engine::kernel_of(model, row.isa) != nullptr)
            names += fmt::format("{}{}", names.empty() ? "" : ", ", row.name);
    return names;
}

Result<const engine::Kernel*> kernel_for(const engine::Model& model, const DrawOptions& options)
{
    if (options.reference)
        return nullptr;
    if (options.isa.empty())
        return engine::kernel_of(model);
    const auto isa = engine::find_isa(options.isa);
    if (isa == engine::Isa::Scalar)
        return nullptr;
    const engine::Kernel* const kernel = isa ? engine::kernel_of(model, isa) : nullptr;
    if (kernel == nullptr)
        return fail(
            plain_error(ErrorKind::Usage,
                        fmt::format("'{}' does not draw {} on this machine; use one of {}",
                                    options.isa, model.description->name, names_here(model))));
    return kernel;
}

void print_times(std::vector<Milliseconds> times, const engine::Drawing& drawing, unsigned threads)
{
    std::ranges::sort(times);
    const Milliseconds median = (times[times.size() / 2] + times[(times.size() - 1) / 2]) / 2;
    fmt::print(stderr, "{} pictures: median {:.3f} ms, least {:.3f} ms; {}, {} thread{}\n",
               times.size(), median.count(), times.front().count(),
               drawing.kernel == nullptr ? "reference" : engine::name_of(drawing.kernel->isa),
               threads, threads == 1 ? "" : "s");
}

/// Shows the progress of a still, which is one frame or several.
class PictureProgress
{
  public:
    PictureProgress(engine::Painter& painter, unsigned rows, unsigned frames)
        : painter_(painter)
        , rows_(rows)
        , progress_(rows * frames, "rows", quiet)
    {
        painter.listen([this](unsigned taken, unsigned parts) {
            frame_ += taken <= taken_ ? 1 : 0; // it rises within a frame
            taken_ = taken;
            progress_.show(frame_ * rows_ + taken * rows_ / parts);
        });
    }
    PictureProgress(const PictureProgress&) = delete;
    PictureProgress& operator=(const PictureProgress&) = delete;
    ~PictureProgress() { painter_.listen({}); }

  private:
    static constexpr std::chrono::milliseconds quiet{300};

    engine::Painter& painter_;
    unsigned rows_;
    unsigned frame_ = 0;
    unsigned taken_ = 0;
    Progress progress_;
};

} // namespace

CLI::Option* add_threads_option(CLI::App& command, unsigned& threads)
{
    return command
        .add_option("--threads", threads,
                    "number of threads that draw; 0, the default, is one for each processor")
        ->check(CLI::Range(0U, most_threads))
        ->type_name("N");
}

void add_draw_options(CLI::App& command, DrawOptions& options)
{
    std::string names;
    for (const engine::IsaRow& row : engine::isa_rows)
        names += fmt::format("{}{}", names.empty() ? "" : ", ", row.name);
    add_threads_option(command, options.threads);
    CLI::Option* const isa = command.add_option(
        "--isa", options.isa,
        fmt::format("instruction set to draw with: {} (default: the fastest that this machine has)",
                    names));
    isa->type_name("NAME");
    command
        .add_flag("--reference", options.reference,
                  "draw with the scalar model, which defines the exact result")
        ->excludes(isa);
    command
        .add_option("--repeat", options.repeat,
                    "number of times to draw; the time of one picture is printed on standard error")
        ->check(CLI::Range(1U, most_repetitions))
        ->type_name("N");
}

void draw_fastest(const engine::Model& model, engine::WordSpan words, unsigned threads,
                  engine::Image& image)
{
    engine::Painter painter(threads);
    engine::draw_still(painter, {model, words, engine::kernel_of(model)}, image);
}

Result<void> draw_picture(const engine::Model& model, engine::WordSpan words,
                          const DrawOptions& options, const engine::Region& tile,
                          engine::Image& image)
{
    const auto kernel = kernel_for(model, options);
    if (!kernel)
        return fail(kernel.error());
    const engine::Drawing drawing{model, words, *kernel};
    engine::Painter painter(options.threads);
    std::optional<PictureProgress> progress; // none if pictures are timed
    if (options.repeat == 0)
        progress.emplace(painter, tile.height, engine::frames_of_a_still(model, words));
    std::vector<Milliseconds> times;
    for (unsigned i = 0; i < std::max(options.repeat, 1U); ++i) {
        const auto start = std::chrono::steady_clock::now();
        engine::draw_still(painter, drawing, tile, image);
        times.emplace_back(std::chrono::steady_clock::now() - start);
    }
    if (options.repeat > 0)
        print_times(std::move(times), drawing, painter.threads());
    return {};
}

} // namespace raymarch::cli
