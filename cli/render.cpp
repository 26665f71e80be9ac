// SPDX-License-Identifier: MIT
/// @file
/// `raymarchctl render`: draws the accelerator's picture of a view.
#include "cli/drawing.hpp"
#include "cli/picture_output.hpp"
#include "cli/subcommands.hpp"
#include "cli/view_options.hpp"
#include "cli/words.hpp"
#include "engine/models.hpp"
#include "protocol/picture_size.hpp"

#include <fmt/format.h>
#include <sysexits.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>

namespace raymarch::cli
{
namespace
{

struct RenderOptions
{
    ViewOptions view;
    DrawOptions drawing;
    std::optional<std::string> tile;
    std::string output;
};

/// Returns the part of the picture that --tile names.
Result<protocol::Tile> tile_of(const RenderOptions& options, protocol::PictureSize size)
{
    if (!options.tile)
        return protocol::Tile{.size = size};
    if (const auto tile = protocol::parse_tile(*options.tile, size))
        return *tile;
    return fail(plain_error(ErrorKind::Usage,
                            fmt::format("'{}' is not a tile of a picture of {}x{}, as in {}x{}+0+0",
                                        *options.tile, size.width, size.height,
                                        (size.width + 1) / 2, (size.height + 1) / 2)));
}

engine::Image cut(engine::Image& image, const protocol::Tile& tile)
{
    engine::Image part(tile.size);
    for (std::size_t y = 0; y < tile.size.height; ++y)
        std::ranges::copy(image.row(tile.y + y)
                              .subspan(engine::bytes_per_pixel * tile.x,
                                       engine::bytes_per_pixel * tile.size.width),
                          part.row(y).begin());
    return part;
}

Result<void> render(const RenderOptions& options)
{
    const auto accelerator = accelerator_named(options.view.accelerator);
    if (!accelerator)
        return fail(accelerator.error());
    if (auto possible = check_picture_output(options.output); !possible)
        return possible;
    const auto size = size_of(**accelerator, options.view);
    if (!size)
        return fail(size.error());
    const auto tile = tile_of(options, *size);
    if (!tile)
        return fail(tile.error());
    const auto words = words_of(**accelerator, options.view);
    if (!words)
        return fail(words.error());
    engine::Image image(*size);
    const engine::Region region{.size = *size,
                                .x = tile->x,
                                .y = tile->y,
                                .width = tile->size.width,
                                .height = tile->size.height};
    if (auto drawn =
            draw_picture(engine::model_of(**accelerator), *words, options.drawing, region, image);
        !drawn)
        return drawn;
    return write_picture(options.tile ? cut(image, *tile) : image, options.output);
}

} // namespace

void add_render(CLI::App& app, Run& run)
{
    CLI::App* const command = app.add_subcommand(
        "render", "draws the accelerator's picture of a view, by its exact model");
    const auto options = std::make_shared<RenderOptions>();
    add_view_options(*command, options->view);
    add_draw_options(*command, options->drawing);
    command
        ->add_option("--tile", options->tile,
                     "part of the picture to draw: its size, the number of columns left of it, the "
                     "number of rows above it")
        ->type_name("WxH+X+Y");
    add_picture_output_option(*command, options->output);
    command->callback([options, &run] {
        run = [options] {
            const auto result = render(*options);
            return result ? EX_OK : report(result.error());
        };
    });
}

} // namespace raymarch::cli
