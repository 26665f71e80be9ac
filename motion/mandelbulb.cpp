// SPDX-License-Identifier: MIT
#include "motion/mandelbulb.hpp"

#include "engine/mandelbulb/distance.hpp"
#include "engine/mandelbulb/ray_generator.hpp"
#include "engine/mandelbulb/ray_marcher.hpp"
#include "protocol/accelerators/mandelbulb.hpp"
#include "protocol/registers.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace raymarch::motion::mandelbulb
{
namespace
{

using namespace engine::mandelbulb;
using Wide = Q64<Int128>;
using Vector = engine::Vec3<double>;

template <typename Format>
Int128 distance_in(const Position& position, const Arithmetic& arithmetic) noexcept
{
    return Int128(estimate<Format>(position_in<Format>(position), arithmetic).distance)
           << (position_bits - Format::fraction_bits);
}

/// The distance of a position as a frame's arithmetic estimates it, Q8.64.
Int128 distance_at(const Frame& frame, const Position& position) noexcept
{
    Arithmetic with = frame.arithmetic;
    with.scale = 0;
    return frame.form == Form::Q8_57 ? distance_in<Q57<Int128>>(position, with)
                                     : distance_in<Wide>(position, with);
}

/// log2(720 / distance), rounded up.
int zoom_of(Int128 distance) noexcept
{
    constexpr int height_bits = std::bit_width(unsigned{zoom_height}) - 1;
    return position_bits + height_bits - leading_one(distance);
}

/// Whether a position is within 4 units of the origin.
bool within_reach(const Position& position) noexcept
{
    const auto square = [](Int128 component) {
        constexpr int dropped = 32; // the remaining bits fit a double
        const auto upper = static_cast<std::int64_t>(component >> dropped);
        const double value = std::ldexp(static_cast<double>(upper), dropped - position_bits);
        return value * value;
    };
    return square(position.x) + square(position.y) + square(position.z) <= 16;
}

enum class Into : bool { FreeSpace, Anything };

/// Adds `way` to the position if the new position is allowed.
void move(Frame& frame, const Position& way, Into into) noexcept
{
    const Position there = frame.position + way;
    if (!within_reach(there))
        return;
    const Int128 distance = distance_at(frame, there);
    if (distance == 0 && into == Into::FreeSpace)
        return;
    frame.position = there;
    if (distance > 0)
        frame.arithmetic.scale = scale_at(frame.form, zoom_of(distance));
}

/// The vector along `direction` whose length is the distance divided by 2^shift, in the frame's
/// coordinates. The product is rounded down, and so is the quotient.
Position part_of(const Frame& frame, Int128 distance, const Direction& direction,
                 int shift) noexcept
{
    const int spare = frame.form == Form::Q8_57 ? position_bits - Q57<Int128>::fraction_bits : 0;
    const Position whole = point_at<Wide>({}, direction, distance >> spare, 0);
    return map(whole, [&](Int128 component) { return (component >> shift) << spare; });
}

Position negative(const Position& way) noexcept
{
    return Position{} - way;
}

constexpr int quarter = 2;
constexpr int dive = 4; ///< Animate dives by 1/2^4 of the distance

void walk(Frame& frame, Inputs inputs) noexcept
{
    const auto by = [&](Input plus, Input minus, const Direction& along) {
        if (inputs.has(plus) == inputs.has(minus))
            return;
        const Position way = part_of(frame, distance_at(frame, frame.position), along, quarter);
        move(frame, inputs.has(plus) ? way : negative(way), Into::FreeSpace);
    };
    by(Input::StrafeRight, Input::StrafeLeft, frame.right);
    by(Input::Up, Input::Down, frame.up);
    if (inputs.has(Input::Forward) == inputs.has(Input::Back))
        return;
    Int128 distance = distance_at(frame, frame.position);
    if (inputs.has(Input::Forward)) {
        move(frame, part_of(frame, distance, frame.forward, quarter), Into::FreeSpace);
    } else {
        if (distance == 0) // the camera is inside the set, and leaves it by 1/64 a step
            distance = Int128(1) << (position_bits - 4);
        move(frame, negative(part_of(frame, distance, frame.forward, quarter)), Into::Anything);
    }
}

Vector to_double(const Direction& direction) noexcept
{
    return map(direction, [](std::int64_t word) {
        return std::ldexp(static_cast<double>(word), -direction_bits);
    });
}

Direction to_words(const Vector& v) noexcept
{
    return map(v, [](double component) {
        const double word = std::ldexp(std::clamp(component, -1.0, 1.0), direction_bits);
        return static_cast<std::int64_t>(std::llround(word));
    });
}

Vector cross(const Vector& a, const Vector& b) noexcept
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Vector normalised(const Vector& v) noexcept
{
    const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    return length > 0 ? map(v, [&](double c) { return c / length; }) : v;
}

/// a cos + b sin, for vectors a and b.
Vector turned(const Vector& a, const Vector& b, double degrees) noexcept
{
    const double angle = degrees * (std::numbers::pi / 180);
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {a.x * c + b.x * s, a.y * c + b.y * s, a.z * c + b.z * s};
}

/// Makes right and up perpendicular to `forward` and to each other. Up stays as near as possible to
/// the old one.
void set_sides(Frame& frame, const Vector& forward, const Vector& up) noexcept
{
    const Vector right = normalised(cross(forward, up));
    frame.right = to_words(right);
    frame.up = to_words(cross(right, forward));
}

/// A rotation in degrees: to the right, upwards and clockwise.
struct Turn
{
    double right = 0;
    double up = 0;
    double roll = 0;
};

void turn(Frame& frame, const Turn& by) noexcept
{
    if (by.right == 0 && by.up == 0 && by.roll == 0) // the words stay exactly as they are
        return;
    Vector forward = to_double(frame.forward);
    Vector right = to_double(frame.right);
    Vector up = to_double(frame.up);
    const Vector ahead = turned(forward, right, by.right);
    right = turned(right, forward, -by.right);
    forward = turned(ahead, up, by.up);
    up = turned(up, ahead, -by.up);
    up = turned(up, right, by.roll);
    forward = normalised(forward);
    frame.forward = to_words(forward);
    set_sides(frame, forward, up);
}

/// Dives into the picture until the error of N steps is as large as a pixel.
void animate(Frame& frame) noexcept
{
    const int deepest = std::min(frame.arithmetic.steps - 3, frame.form == Form::Q8_57 ? 50 : 56);
    const Int128 distance = distance_at(frame, frame.position);
    if (distance > 0 && zoom_of(distance) <= deepest)
        move(frame, part_of(frame, distance, frame.forward, dive), Into::FreeSpace);
    turn(frame, {.roll = 0.5});
}

} // namespace

int scale_at(Form form, int zoom) noexcept
{
    const int enough = form == Form::Q8_57 ? 44 : 51; // the size of a distance takes 13 bits
    return zoom <= enough ? 0 : std::min(zoom - 12, 60);
}

World step(const World& world, Inputs inputs) noexcept
{
    World next = world;
    walk(next.frame, inputs);
    const auto degree = [&](Input plus, Input minus) {
        return (inputs.has(plus) ? 1.0 : 0.0) - (inputs.has(minus) ? 1.0 : 0.0);
    };
    turn(next.frame, {.right = degree(Input::TurnRight, Input::TurnLeft),
                      .up = degree(Input::TurnUp, Input::TurnDown),
                      .roll = degree(Input::RollRight, Input::RollLeft)});
    if (inputs.has(Input::Animate))
        animate(next.frame);
    return next;
}

std::optional<Frame> approach(const Frame& view, engine::PictureSize size, std::uint16_t x,
                              std::uint16_t y, int zoom) noexcept
{
    // The search uses the finest arithmetic on the same set, whatever the view is drawn with.
    Arithmetic exact = view.arithmetic;
    exact.steps = max_steps;
    exact.kept_bits = all_bits;
    exact.derivative = DerivativeForm::Sliding;
    exact.scale = 0;
    constexpr int patience = 4000; // each of the last bits takes a step
    const Direction ray = ray_direction(view, size, x, y);
    const March<Wide> way =
        march<Wide>(view.position, ray, exact, {.epsilon_shift = 127, .evaluations = patience});
    if (way.outcome != Outcome::Hit)
        return std::nullopt;

    const int level = std::clamp(zoom, min_zoom, max_zoom);
    const Int128 before = Int128(zoom_height) << (position_bits - level);
    // The position is rounded to float (24 bits) or double (53), so that pictures drawn with these
    // can be compared. A deeper view needs all bits.
    const int grid = level <= 26 ? 23 : level <= 54 ? 52 : position_bits;
    const Int128 half = (Int128(1) << (position_bits - grid)) >> 1;
    Frame near = view;
    near.position = map(point_at<Wide>(view.position, ray, way.t - before, 0), [&](Int128 c) {
        return ((c + half) >> (position_bits - grid)) << (position_bits - grid);
    });
    near.forward = ray;
    set_sides(near, normalised(to_double(ray)), to_double(view.up));
    near.arithmetic.scale = scale_at(view.form, level);
    return near;
}

World enter(const protocol::State& state) noexcept
{
    const auto& description = protocol::mandelbulb::description;
    return {latch(protocol::pack(description, state))};
}

void leave(const World& world, protocol::State& state) noexcept
{
    namespace table = protocol::mandelbulb;
    const auto position = [&](table::Index at, Int128 value) {
        state.codes[at] = static_cast<std::int64_t>(value >> 32);
        state.codes[static_cast<std::size_t>(at) + 1] =
            static_cast<std::int64_t>(static_cast<std::uint64_t>(value) & 0xFFFF'FFFF);
    };
    const auto direction = [&](table::Index at, const Direction& words) {
        state.codes[at] = words.x;
        state.codes[static_cast<std::size_t>(at) + 1] = words.y;
        state.codes[static_cast<std::size_t>(at) + 2] = words.z;
    };
    position(table::X, world.frame.position.x);
    position(table::Y, world.frame.position.y);
    position(table::Z, world.frame.position.z);
    direction(table::FX, world.frame.forward);
    direction(table::RX, world.frame.right);
    direction(table::UX, world.frame.up);
    state.codes[table::SCALE] = world.frame.arithmetic.scale;
}

std::optional<protocol::State> state_near(const protocol::State& state, std::uint16_t x,
                                          std::uint16_t y, int zoom) noexcept
{
    const auto near =
        approach(enter(state).frame, protocol::mandelbulb::description.size, x, y, zoom);
    if (!near)
        return std::nullopt;
    protocol::State changed = state;
    leave({*near}, changed);
    return changed;
}

} // namespace raymarch::motion::mandelbulb
