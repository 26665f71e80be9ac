// SPDX-License-Identifier: MIT
/// @file
/// `raymarchctl film`: draws the accelerator's frames while its scene or its camera moves.
#include "cli/drawing.hpp"
#include "cli/interruption.hpp"
#include "cli/moves.hpp"
#include "cli/progress.hpp"
#include "cli/subcommands.hpp"
#include "cli/view_options.hpp"
#include "cli/words.hpp"
#include "engine/draw.hpp"
#include "engine/models.hpp"
#include "motion/movers.hpp"
#include "pictures/film_file.hpp"
#include "protocol/commands.hpp"
#include "protocol/registers.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <array>
#include <memory>
#include <stop_token>
#include <string>

namespace raymarch::cli
{
namespace
{

constexpr unsigned most_frames = 100'000;

struct FilmOptions
{
    ViewOptions view;
    unsigned frames = 0;
    unsigned frames_per_second = 25; ///< a GIF can express 4/100 s for each frame
    unsigned steps = 1;
    std::string moves = "animate";
    unsigned threads = 0;
    std::string output;
};

struct Scene
{
    const protocol::Accelerator& description;
    protocol::State state; ///< the state of the first frame
    protocol::PictureSize size;
    motion::Inputs inputs;
};

Result<Scene> scene_of(const FilmOptions& options)
{
    const auto accelerator = accelerator_named(options.view.accelerator);
    if (!accelerator)
        return fail(accelerator.error());
    const protocol::Accelerator& description = **accelerator;
    const auto size = size_of(description, options.view);
    if (!size)
        return fail(size.error());
    const auto state = state_of(description, options.view);
    if (!state)
        return fail(state.error());
    const auto inputs = parse_moves(options.moves);
    if (!inputs)
        return fail(inputs.error());
    return Scene{description, *state, *size, *inputs};
}

/// Adds the frames to the film until a stop is requested. Two buffers alternate as in the hardware,
/// so pixels that a frame does not draw show the frame before the last.
Result<void> add_frames(const Scene& scene, const FilmOptions& options, pictures::FilmWriter& film,
                        const std::stop_token& stop)
{
    const engine::Model& model = engine::model_of(scene.description);
    const auto mover = motion::mover_of(scene.description);
    std::array<engine::Image, 2> buffers = {engine::Image(scene.size), engine::Image(scene.size)};
    protocol::State state = scene.state;
    Progress progress(options.frames, "frames");
    engine::Painter painter(options.threads);
    for (unsigned frame = 0; frame < options.frames; ++frame) {
        engine::Image& image = buffers[frame % buffers.size()];
        const protocol::Words words = protocol::pack(scene.description, state);
        engine::draw_frame(painter, {model, words, engine::kernel_of(model)},
                           engine::whole(scene.size, frame), {image.rgb}, stop);
        if (stop.stop_requested())
            break;
        if (auto added = film.add(image); !added)
            return added;
        progress.show(frame + 1);
        for (unsigned step = 0; mover && step < options.steps; ++step)
            mover->step(state, scene.inputs);
    }
    return {};
}

/// Returns the exit status.
Result<int> make_film(const FilmOptions& options)
{
    const auto scene = scene_of(options);
    if (!scene)
        return fail(scene.error());
    const Interruption interruption; // declared before the film, whose destructor runs first
    const auto film = pictures::open_film(options.output, scene->size, options.frames_per_second);
    if (!film)
        return fail(film.error());
    if (auto added = add_frames(*scene, options, **film, interruption.token()); !added)
        return fail(added.error());
    if (const int status = interruption.status(); status != 0) {
        fmt::print(stderr, "raymarchctl: {}: abandoned after {} of {} frames\n", options.output,
                   (*film)->frames(), options.frames);
        return status;
    }
    if (auto finished = (*film)->finish(); !finished)
        return fail(finished.error());
    return EX_OK;
}

} // namespace

void add_film(CLI::App& app, Run& run)
{
    CLI::App* const command = app.add_subcommand(
        "film", "draws frames while the scene or the camera moves, and writes a film");
    const auto options = std::make_shared<FilmOptions>();
    add_view_options(*command, options->view);
    command->add_option("--frames", options->frames, "number of frames to draw")
        ->check(CLI::Range(1U, most_frames))
        ->type_name("N")
        ->required();
    command
        ->add_option("--fps", options->frames_per_second,
                     "number of frames a second, in the range of the format (default: 25)")
        ->type_name("F");
    command
        ->add_option("--move", options->moves,
                     "movements that last for the whole film, with commas between them: directions "
                     "of WALK, directions of TURN after turn-, animate (default: animate)")
        ->type_name("WORDS");
    command
        ->add_option("--steps", options->steps,
                     "number of steps of the movement from one frame to the next (default: 1)")
        ->check(CLI::Range(1U, protocol::most_steps))
        ->type_name("K");
    add_threads_option(*command, options->threads);
    command
        ->add_option(
            "-o,--output", options->output,
            "file for the film: .gif, .mp4, or one picture for each frame, as in name_%04d.png")
        ->type_name("FILE")
        ->required();
    command->callback([options, &run] {
        run = [options] {
            const auto status = make_film(*options);
            return status ? *status : report(status.error());
        };
    });
}

} // namespace raymarch::cli
