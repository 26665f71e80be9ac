#!/usr/bin/env python3
"""The marcher of docs/engine.md, written a second time, in plain Python, from that page alone.

Why it exists: the page claims to be complete, that is, that an implementation made from it draws identical frames.
This file is the proof. It was written without sight of the C++ engine; it shares no code, no tables and no tricks with
it. What both agree on, bit for bit, follows from the page. The functions bear the names of the page's sections and
follow its formulas literally; speed comes second.

    marcher_model.py draw WORD x8 --size WxH -o FILE.ppm    one frame, words in hexadecimal
    marcher_model.py golden > tests/golden/marcher.tsv      the table of frames that every engine must match
    marcher_model.py check                                  the page's claims, recomputed with exact integers

Python integers have no width, so nothing here wraps; `check` shows that nothing had to.
"""

import argparse
import random
import sys
import time
import zlib
from dataclasses import dataclass
from fractions import Fraction
from math import isqrt
from typing import Callable, Iterator, NamedTuple, Optional, Sequence

Vector = tuple[int, int, int]
Distance = Callable[[Vector], int]

ONE = 1 << 24
SURFACE_DIST = 167772
MAX_DIST = 335544320
H = 167772
MAX_STEPS = 100

SPHERE, CUBE, INFINITE_CUBE, TUNNEL = range(4)
SCENE_NAMES = ("sphere", "cube", "infinite_cube", "tunnel")


def mul(a: int, b: int) -> int:
    return (a * b) >> 24


# --- 1. The frame's words -------------------------------------------------------------------------------------------


class Frame(NamedTuple):
    forward: Vector
    right: Vector
    up: Vector
    eye: Vector
    light: Vector
    colour: Vector
    scene: int


def signed(code: int, width: int) -> int:
    return code - (1 << width) if code >> (width - 1) else code


def basis_vector(high: int, low: int) -> Vector:
    """Three signed 18-bit codes from a pair of words: x[31:14] y.hi[13:0], y.lo[31:28] z[27:10]."""
    mask = (1 << 18) - 1
    return (
        signed(high >> 14, 18),
        signed(((high & 0x3FFF) << 4) | (low >> 28), 18),
        signed((low >> 10) & mask, 18),
    )


def frame_words(words: Sequence[int]) -> Frame:
    if len(words) != 8 or any(not 0 <= word < 1 << 32 for word in words):
        raise ValueError("a frame is eight 32-bit words")
    forward = basis_vector(words[2], words[3])
    zoom = min(words[1], 16 << 24)
    fx, fy, fz = forward
    return Frame(
        forward=forward,
        right=basis_vector(words[4], words[5]),
        up=basis_vector(words[6], words[7]),
        eye=((zoom * fx) >> 17, (zoom * fy) >> 17, (zoom * fz) >> 17),
        light=(
            signed((words[0] >> 20) & 1023, 10) << 21,
            signed((words[0] >> 10) & 1023, 10) << 21,
            signed(words[0] & 1023, 10) << 21,
        ),
        colour=(words[3] & 1023, words[5] & 1023, words[7] & 1023),
        scene=words[0] >> 30,
    )


# --- 2. Inverse square root -----------------------------------------------------------------------------------------

T = [(isqrt((1 << 75) // (4096 + i)) + 1) >> 1 for i in range(4097)]


def rsqrt(square: int) -> tuple[int, int]:
    """Mantissa M and shift s: (v * M) >> s is v / sqrt(square) in Q8.24."""
    z = 64 - square.bit_length()
    n = square << z
    i = (n >> 51) & 4095
    g = (n >> 37) & 16383
    mantissa = T[i] - (((T[i] - T[i + 1]) * g) >> 14)
    if z & 1:
        mantissa = (mantissa * 3037000500) >> 32
    return mantissa, 30 - (z - 15) // 2


def normalise(v: Vector) -> Vector:
    x, y, z = v
    square = x * x + y * y + z * z
    if square == 0:
        return 0, 0, 0
    mantissa, shift = rsqrt(square)
    return (x * mantissa) >> shift, (y * mantissa) >> shift, (z * mantissa) >> shift


def length(p: Vector) -> int:
    x, y, z = p
    square = x * x + y * y + z * z
    if square == 0:
        return 0
    mantissa, shift = rsqrt(square)
    zeros = 64 - square.bit_length()
    m = (square << zeros) >> 32
    return (m * mantissa) >> (shift + zeros - 8)


# --- 3. Ray generator -----------------------------------------------------------------------------------------------


def ray_vector(frame: Frame, x: int, y: int, width: int, height: int) -> Vector:
    """The page's d, before it is normalised."""
    u = 2 * x + 1 - width
    v = height - 1 - 2 * y
    (fx, fy, fz), (rx, ry, rz), (ux, uy, uz) = frame.forward, frame.right, frame.up
    return u * rx + v * ux - height * fx, u * ry + v * uy - height * fy, u * rz + v * uz - height * fz


def ray_generator(frame: Frame, x: int, y: int, width: int, height: int) -> Vector:
    return normalise(ray_vector(frame, x, y, width, height))


# --- 4. Scene query -------------------------------------------------------------------------------------------------


def sphere(p: Vector) -> int:
    return length(p) - ONE


def cube(p: Vector) -> int:
    x, y, z = p
    return max(abs(x), abs(y), abs(z)) - (1 << 23)


def infinite_cube(p: Vector) -> int:
    half, mask = 1 << 23, (1 << 24) - 1
    x, y, z = p
    return max(abs(((x + half) & mask) - half), abs(((y + half) & mask) - half), abs(((z + half) & mask) - half)) - (
        1 << 22
    )


TUNNEL_ROWS = ((1 << 24, 7549747), (1 << 23, 4753489), (1 << 22, 3047917), (1 << 20, 838861))


def tunnel_term(p: Vector, m: int, b: int) -> int:
    mask = 2 * m - 1
    x, y, z = p
    return sorted((abs((x & mask) - m), abs((y & mask) - m), abs((z & mask) - m)))[1] - b


def tunnel(p: Vector) -> int:
    return max([tunnel_term(p, m, b) for m, b in TUNNEL_ROWS])


SCENES: tuple[Distance, ...] = (sphere, cube, infinite_cube, tunnel)


# --- 5. Ray marcher -------------------------------------------------------------------------------------------------


class Ray(NamedTuple):
    hit: bool
    p: Vector  # position of the last query
    d: int  # its distance
    t: int  # after the distance was added
    queries: int


def ray_marcher(eye: Vector, direction: Vector, dist: Distance) -> Ray:
    (ex, ey, ez), (dx, dy, dz) = eye, direction
    t = 0
    queries = 0
    while True:
        p = (ex + ((dx * t) >> 24), ey + ((dy * t) >> 24), ez + ((dz * t) >> 24))
        d = dist(p)
        queries += 1
        t += d
        if t > MAX_DIST or queries >= MAX_STEPS:
            return Ray(False, p, d, t, queries)
        if d < SURFACE_DIST:
            return Ray(True, p, d, t, queries)


# --- 6. Surface vectors ---------------------------------------------------------------------------------------------

CORNERS = ((1, -1, -1), (-1, -1, 1), (-1, 1, -1), (1, 1, 1))


def surface_vectors(p: Vector, light: Vector, dist: Distance) -> tuple[Vector, Vector]:
    x, y, z = p
    nx = ny = nz = 0
    for kx, ky, kz in CORNERS:
        d = dist((x + kx * H, y + ky * H, z + kz * H))
        nx += kx * d
        ny += ky * d
        nz += kz * d
    return normalise((nx, ny, nz)), normalise((light[0] - x, light[1] - y, light[2] - z))


# --- 7. Shading -----------------------------------------------------------------------------------------------------


def brightness(normal: Vector, light: Vector) -> int:
    (nx, ny, nz), (lx, ly, lz) = normal, light
    diffuse = max((nx * lx + ny * ly + nz * lz) >> 24, 0)
    sky = max(ny, 0)
    return (1 << 21) + (sky >> 3) + ((3 * diffuse) >> 2)


def shading(normal: Vector, light: Vector, colour: Vector) -> bytes:
    b = brightness(normal, light)
    return bytes([min((c * b) >> 26, 255) for c in colour])


# --- The picture ----------------------------------------------------------------------------------------------------


@dataclass
class Census:
    """What became of a frame's rays; the golden table's reasons are asserted on it."""

    rays: int = 0
    hits: int = 0
    hits_at_first_query: int = 0
    misses_by_distance: int = 0
    misses_by_queries: int = 0
    near_misses_by_distance: int = 0  # d below SURFACE_DIST, but t beyond MAX_DIST
    near_misses_by_queries: int = 0  # d below SURFACE_DIST, but at the hundredth query
    queries: int = 0
    brightest: int = 0
    last: Optional[Ray] = None

    def count(self, ray: Ray) -> None:
        near = ray.d < SURFACE_DIST
        self.rays += 1
        self.queries += ray.queries
        self.last = ray
        if ray.hit:
            self.hits += 1
            self.hits_at_first_query += ray.queries == 1
        elif ray.t > MAX_DIST:
            self.misses_by_distance += 1
            self.near_misses_by_distance += near
        else:
            self.misses_by_queries += 1
            self.near_misses_by_queries += near


def render(words: Sequence[int], width: int, height: int) -> tuple[bytes, Census]:
    frame = frame_words(words)
    dist = SCENES[frame.scene]
    census = Census()
    picture = bytearray()
    for y in range(height):
        for x in range(width):
            ray = ray_marcher(frame.eye, ray_generator(frame, x, y, width, height), dist)
            census.count(ray)
            if ray.hit:
                picture += shading(*surface_vectors(ray.p, frame.light, dist), frame.colour)
            else:
                picture += b"\0\0\0"
    census.brightest = max(picture)
    return bytes(picture), census


def draw(words: Sequence[int], width: int, height: int) -> bytes:
    """The frame as RGB bytes, rows from the top."""
    return render(words, width, height)[0]


def cycles(words: Sequence[int], width: int, height: int, units: int = 4) -> int:
    clocks = (5, 1, 2, 8)[words[0] >> 30]
    return -(-render(words, width, height)[1].queries * clocks // units)


# --- The golden table -----------------------------------------------------------------------------------------------

SEED = 20260729
FULL = 131071  # the largest Q1.17 code, just below 1


def pack(scene: int, zoom: int, forward: Vector, right: Vector, up: Vector, light: Vector, colour: Vector) -> list[int]:
    """The inverse of frame_words; light as Q7.3 codes, zoom as the Q8.24 code."""
    lx, ly, lz = (c & 1023 for c in light)
    words = [(scene << 30) | (lx << 20) | (ly << 10) | lz, zoom]
    for vector, c in ((forward, colour[0]), (right, colour[1]), (up, colour[2])):
        x, y, z = (code & 0x3FFFF for code in vector)
        words += [(x << 14) | (y >> 4), ((y & 15) << 28) | (z << 10) | c]
    return words


def q824(value: str) -> int:
    return round(Fraction(value) * ONE)


def rotation(rng: random.Random) -> tuple[Vector, Vector, Vector]:
    """A random orthonormal basis (forward, right, up), by an integer quaternion: no floating point anywhere."""
    while True:
        a, b, c, d = (rng.getrandbits(12) - 2048 for _ in range(4))
        n = a * a + b * b + c * c + d * d
        if n > 1 << 20:
            break
    right = (a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c))
    up = (2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b))
    forward = (2 * (b * d + a * c), 2 * (c * d - a * b), a * a - b * b - c * c + d * d)

    def codes(v: Vector) -> Vector:
        x, y, z = (min((2 * c * (1 << 17) + n) // (2 * n), FULL) for c in v)
        return x, y, z

    return codes(forward), codes(right), codes(up)


def turned(yaw: Vector, pitch: Vector) -> tuple[Vector, Vector, Vector]:
    """Basis from two Pythagorean angles (cosine, sine, radius): exact fractions."""
    cy, sy, ry = yaw
    cp, sp, rp = pitch

    def code(top: int, bottom: int) -> int:
        return min((2 * top * (1 << 17) + bottom) // (2 * bottom), FULL)

    forward = (code(sy * cp, ry * rp), code(sp, rp), code(cy * cp, ry * rp))
    right = (code(cy, ry), 0, code(-sy, ry))
    up = (code(-sy * sp, ry * rp), code(cp, rp), code(-cy * sp, ry * rp))
    return forward, right, up


def open_rotation(rng: random.Random, scene: int, zoom: int) -> tuple[Vector, Vector, Vector]:
    """A random basis whose eye is outside matter."""
    while True:
        basis = rotation(rng)
        fx, fy, fz = basis[0]
        if SCENES[scene](((zoom * fx) >> 17, (zoom * fy) >> 17, (zoom * fz) >> 17)) > ONE // 16:
            return basis


AXES = ((0, 0, FULL), (FULL, 0, 0), (0, FULL, 0))
TILTED = turned((4, 3, 5), (12, 5, 13))
WHITE = (1023, 1023, 1023)
LIGHT = (16, 24, 32)  # (2, 3, 4)


class Row(NamedTuple):
    width: int
    height: int
    words: Sequence[int]
    why: str
    holds: Callable[[Census], bool] = lambda census: True


def mixed(census: Census) -> bool:
    return 0 < census.hits < census.rays


def all_hit(census: Census) -> bool:
    return census.hits == census.rays


def all_hit_at_once(census: Census) -> bool:
    return census.hits_at_first_query == census.rays


def all_missed(census: Census) -> bool:
    return census.hits == 0


def some_hit(census: Census) -> bool:
    return census.hits > 0


def seen(census: Census) -> bool:
    """Surfaces are seen from the open."""
    return census.hits > 0 and census.hits_at_first_query == 0


def plain_rows() -> Iterator[Row]:
    """The four scenes as a user sees them first."""
    for scene, name in enumerate(SCENE_NAMES):
        zoom = "3" if scene == TUNNEL else "2.25"  # in the open
        yield Row(
            64, 48, pack(scene, q824("2.5"), *AXES, LIGHT, WHITE), f"{name}: camera on the z axis at 2.5, white", seen
        )
        yield Row(
            160,
            120,
            pack(scene, q824(zoom), *TILTED, LIGHT, (1023, 600, 200)),
            f"{name}: camera turned by exact angles, at {zoom}, orange; middle size",
            seen,
        )
        yield Row(
            640,
            480,
            pack(scene, q824(zoom), *TILTED, (-20, 40, 10), (300, 700, 1000)),
            f"{name}: a full frame of 640x480, camera turned by exact angles, at {zoom}, blue, light from elsewhere",
            seen,
        )


def random_light(rng: random.Random, forward: Vector) -> Vector:
    """A light on the camera's side, so that the picture shows more than its ambient part."""
    while True:
        light = (rng.getrandbits(7) - 64, rng.getrandbits(7) - 64, rng.getrandbits(7) - 64)
        if sum(a * b for a, b in zip(light, forward)) > 24 << 17:
            return light


def random_colour(rng: random.Random) -> Vector:
    return 1023 - rng.getrandbits(9), 1023 - rng.getrandbits(9), 1023 - rng.getrandbits(9)


def camera_rows(rng: random.Random) -> Iterator[Row]:
    """Random orthonormal cameras with the zoom that the protocol can set, 0 to 10."""
    sizes = ((64, 48), (65, 33), (17, 13), (48, 64), (33, 21))
    ranges = ((1, 2), (2, 3), (3, 5), (5, 8), (8, 10))
    for scene, name in enumerate(SCENE_NAMES):
        for (width, height), (low, high) in zip(sizes, ranges):
            zoom = (low << 24) + ((rng.getrandbits(24) * (high - low)))
            basis = open_rotation(rng, scene, zoom)
            words = pack(scene, zoom, *basis, random_light(rng, basis[0]), random_colour(rng))
            yield Row(width, height, words, f"{name}: random orthonormal camera in the open, zoom {low} to {high}", seen)
        for zoom in (0, 10):
            basis = open_rotation(rng, scene, zoom << 24) if zoom else rotation(rng)
            words = pack(scene, zoom << 24, *basis, random_light(rng, basis[0]), WHITE)
            end = "upper" if zoom else "lower"
            yield Row(33, 25, words, f"{name}: random orthonormal camera, zoom {zoom}, the {end} end of the protocol")


def inside_rows(rng: random.Random) -> Iterator[Row]:
    for scene, zoom in ((SPHERE, "0.7"), (CUBE, "0.3"), (INFINITE_CUBE, "0.2")):
        words = pack(scene, q824(zoom), *rotation(rng), LIGHT, WHITE)
        yield Row(
            17, 13, words, f"{SCENE_NAMES[scene]}: camera inside matter, every ray hits at its first query", all_hit_at_once
        )
    _, right, up = AXES
    words = pack(TUNNEL, q824("0.6"), (FULL, FULL, FULL), right, up, LIGHT, WHITE)
    yield Row(
        17, 13, words, "tunnel: camera inside matter near (0.6, 0.6, 0.6), every ray hits at its first query", all_hit_at_once
    )


def arbitrary_words(rng: random.Random, scene: int, zoom_bits: int) -> list[int]:
    """Random bits but for the scene, with the eye in the open."""
    while True:
        words = [rng.getrandbits(32) for _ in range(8)]
        words[0] = (words[0] & 0x3FFFFFFF) | (scene << 30)
        words[1] &= (1 << zoom_bits) - 1
        if SCENES[scene](frame_words(words).eye) > ONE // 16:
            return words


def arbitrary_rows(rng: random.Random) -> Iterator[Row]:
    """Words that no protocol sets: every bit random, the basis neither unit nor orthogonal."""
    for scene, name in enumerate(SCENE_NAMES):
        for width, height in ((64, 48), (17, 13), (65, 33)):
            words = arbitrary_words(rng, scene, 32)
            yield Row(width, height, words, f"{name}: all bits random but the object's, zoom register {words[1] >> 24}")
    for scene, name in enumerate(SCENE_NAMES):
        words = arbitrary_words(rng, scene, 25)
        yield Row(33, 33, words, f"{name}: random bits with a zoom below 2, the object is near the camera", seen)


def degenerate_rows() -> Iterator[Row]:
    zero = (0, 0, 0)
    for scene, name in enumerate(SCENE_NAMES):
        told = "every direction is zero, t grows until MAX_DIST" if scene == TUNNEL else "hit at once, the normal is zero"
        holds = all_missed if scene == TUNNEL else all_hit_at_once
        yield Row(3, 5, pack(scene, 3 << 24, zero, zero, zero, LIGHT, WHITE), f"{name}: zero basis: {told}", holds)
    forward, right, up = AXES
    yield Row(
        33, 25, pack(CUBE, 2 << 24, forward, right, right, LIGHT, WHITE), "cube: right and up equal, the picture repeats on diagonals"
    )
    yield Row(33, 25, pack(SPHERE, 3 << 24, forward, (-FULL, 0, 0), up, LIGHT, WHITE), "sphere: left-handed basis", mixed)
    yield Row(
        33,
        25,
        pack(INFINITE_CUBE, q824("2.5"), (0, 0, 1), (1, 0, 0), (0, 1, 0), LIGHT, WHITE),
        "infinite_cube: basis codes of 1, the shortest rays; all start in the cube at the origin",
        all_hit_at_once,
    )
    yield Row(
        33,
        25,
        pack(TUNNEL, 16 << 24, (0, 1, 3), (2, 0, 0), (0, 2, -1), LIGHT, WHITE),
        "tunnel: basis codes of 1 to 3, small odd and even squared lengths",
        some_hit,
    )
    yield Row(
        33,
        25,
        pack(TUNNEL, q824("0.7"), (0, 0, -131072), (-131072, 0, 0), (0, -131072, 0), LIGHT, WHITE),
        "tunnel: basis of exactly -1, powers of two for the inverse root",
        some_hit,
    )
    yield Row(
        65,
        33,
        pack(INFINITE_CUBE, q824("0.45"), (-131072,) * 3, (-131072,) * 3, (FULL, -131072, FULL), (-9, 5, 3), WHITE),
        "infinite_cube: every basis code at an end of its range, longest ray vectors of this size",
        some_hit,
    )
    same = (30000, 50000, -70000)
    yield Row(
        2,
        1,
        pack(INFINITE_CUBE, ONE, same, same, up, LIGHT, WHITE),
        "infinite_cube: right equals forward, so the right pixel's ray stands still away from the origin",
        lambda census: census.last is not None and not census.last.hit and census.last.p == frame_words(
            pack(INFINITE_CUBE, ONE, same, same, up, LIGHT, WHITE)).eye,
    )


def light_and_colour_rows() -> Iterator[Row]:
    low, high = -512, 511
    for light, told in (
        ((low, 0, 0), "x at its lower end"),
        ((high, 0, 0), "x at its upper end"),
        ((0, low, 0), "y at its lower end"),
        ((0, high, 0), "y at its upper end"),
        ((low, low, low), "three components at their lower end"),
        ((high, high, high), "three components at their upper end"),
    ):
        scene = SPHERE if light[0] else CUBE
        yield Row(
            33, 25, pack(scene, q824("1.75"), *TILTED, light, WHITE), f"{SCENE_NAMES[scene]}: light's {told}", mixed
        )
    forward, right, up = turned((4, 3, 5), (4, 3, 5))
    yield Row(
        33,
        25,
        pack(TUNNEL, 16 << 24, forward, right, up, (low, low, low), WHITE),
        "tunnel: far camera and light at its lower end, a long way from light to surface",
        some_hit,
    )
    yield Row(33, 25, pack(INFINITE_CUBE, q824("1.6"), *TILTED, (0, 0, 0), WHITE), "infinite_cube: light at the origin", some_hit)
    yield Row(17, 13, pack(SPHERE, 2 << 24, *TILTED, LIGHT, (0, 0, 0)), "sphere: colour 0, all black", lambda c: c.brightest == 0)
    for index, name in enumerate(("red", "green", "blue")):
        colour = tuple(1023 if index == i else 0 for i in range(3))
        yield Row(17, 13, pack(CUBE, 2 << 24, *TILTED, LIGHT, colour), f"cube: full {name} alone, the order of the channels", mixed)
    yield Row(17, 13, pack(CUBE, 2 << 24, *TILTED, LIGHT, (1, 4, 32)), "cube: the smallest colours, rounded down", mixed)
    yield Row(
        1,
        1,
        pack(CUBE, 2 << 24, (0, FULL, 0), (FULL, 0, 0), (0, 0, -FULL), (0, 80, 0), WHITE),
        "cube: from above, light above: sky and diffuse both full, channel 255",
        lambda c: c.brightest == 255,
    )
    yield Row(
        1,
        1,
        pack(CUBE, 1 << 23, (-131072, 0, 0), (0, 0, FULL), (0, FULL, 0), (-4, 0, 0), WHITE),
        "cube: eye, surface and light are one point, so the light vector is zero",
        lambda c: all_hit_at_once(c) and c.last is not None and c.last.p == (-(1 << 23), 0, 0),
    )


def size_rows(rng: random.Random) -> Iterator[Row]:
    sizes = ((1, 1), (2, 1), (1, 2), (3, 5), (17, 13), (65, 33))
    for index, (width, height) in enumerate(sizes):
        scene = (index + 1) % 4
        words = pack(scene, q824("1.6"), *rotation(rng), LIGHT, (1023, 512, 256))
        odd = f"{'odd' if width % 2 else 'even'} width, {'odd' if height % 2 else 'even'} height"
        yield Row(width, height, words, f"{SCENE_NAMES[scene]}: size {width}x{height}, {odd}")
    yield Row(
        1920, 1, pack(TUNNEL, 3 << 24, *TILTED, LIGHT, WHITE), "tunnel: one row, W/H of 1920: rays nearly along right", seen
    )
    yield Row(1920, 1, pack(INFINITE_CUBE, q824("2.6"), *TILTED, LIGHT, WHITE), "infinite_cube: one row of 1920 pixels", some_hit)
    yield Row(1, 1080, pack(CUBE, q824("1.2"), *TILTED, LIGHT, WHITE), "cube: one column of 1080 pixels", mixed)
    yield Row(1, 1080, pack(SPHERE, q824("1.5"), *TILTED, LIGHT, WHITE), "sphere: one column of 1080 pixels", mixed)


def zoom_limit_rows() -> Iterator[Row]:
    for scene in (INFINITE_CUBE, TUNNEL):
        for zoom, told in (
            (16 << 24, "register at the limit 16"),
            ((16 << 24) - 1, "register one raw below the limit 16"),
            (0xFFFFFFFF, "register all ones, draws the frame of 16"),
        ):
            # half-length basis: the eye is at 8, all rays are the same as with a whole one
            words = pack(scene, zoom, *(tuple(c // 2 for c in v) for v in TILTED), LIGHT, WHITE)
            yield Row(33, 25, words, f"{SCENE_NAMES[scene]}: zoom {told}; basis of half length", some_hit)


def one_ray(zoom: int, *, scene: int, forward: Vector, light: Vector = LIGHT) -> list[int]:
    return pack(scene, zoom, forward, (FULL, 0, 0), (0, FULL, 0), light, WHITE)


def boundary_rows() -> Iterator[Row]:
    """Single rays placed on the comparisons of the marcher, and frames that meet its limits."""
    axis = (-131072, 0, 0)
    light = (-5, 1, 0)
    for d, queries, told in (
        (SURFACE_DIST, 2, "exactly SURFACE_DIST: no hit, one more query"),
        (SURFACE_DIST - 1, 1, "one raw below SURFACE_DIST: a hit at the first query"),
    ):
        yield Row(
            1,
            1,
            one_ray((1 << 23) + d, scene=CUBE, forward=axis, light=light),
            f"cube: first distance {told}",
            lambda c, queries=queries: all_hit(c) and c.queries == queries,
        )
    corner = (-131072, -131072, -131072)
    for vector, zoom, beyond, told in (
        (corner, 203412930, 0, "exactly MAX_DIST: a hit"),
        ((-120849, -122569, -121854), 218970720, 1, "one raw beyond MAX_DIST: a miss although the point is at the surface"),
    ):
        # zooms found by search
        yield Row(
            1,
            1,
            one_ray(zoom, scene=SPHERE, forward=vector, light=(-300, -200, -100)),
            f"sphere: t at the surface is {told}",
            lambda c, beyond=beyond: c.last is not None
            and c.last.t == MAX_DIST + beyond
            and (c.near_misses_by_distance if beyond else c.hits) == 1,
        )
    a, b = 47186, 13107  # 0.36, 0.1: between the rows of cubes, the ray runs along z
    yield Row(
        2,
        1,
        pack(INFINITE_CUBE, ONE, (a, b, 0), (a, b, 65536), (0, FULL, 0), LIGHT, WHITE),
        "infinite_cube: the right pixel's ray runs along a gap and ends at the hundredth query before MAX_DIST",
        lambda c: c.last is not None and not c.last.hit and c.last.queries == 100 and c.last.t <= MAX_DIST,
    )
    yield Row(
        64,
        48,
        pack(INFINITE_CUBE, q824("2.25"), *TILTED, LIGHT, WHITE),
        "infinite_cube: two rays come within SURFACE_DIST at the hundredth query, before MAX_DIST, and are misses",
        lambda c: c.near_misses_by_queries == 2,
    )
    yield Row(
        17,
        13,
        pack(INFINITE_CUBE, 16 << 24, (FULL,) * 3, (FULL, FULL, FULL // 2), (-FULL, FULL // 2, FULL), (-512,) * 3, WHITE),
        "infinite_cube: rays from (16, 16, 16) outwards, light at (-64, -64, -64): squared lengths from 2^62 on",
        some_hit,
    )
    yield Row(
        2,
        1,
        parse_words("01006020 02373710 C9853355 AC4DDBFF 930AE6AB B89BCFFF 00000000 000003FF"),
        "sphere: the right pixel's direction is longer than 1, rounded down in three negative components; t comes near 20",
    )


def parse_words(text: str) -> list[int]:
    return [int(word, 16) for word in text.split()]


# Found by search among random frames of 11x9: at least one channel of one pixel depends on what is named.
LOW_BIT_FRAMES = (
    ("3D2F0C07 01830736 3077E2C5 0ECEABFF AF38F413 45715B83 A957BAC4 6A426F08", "the constant 3037000500 (not one less)"),
    ("3CD0F820 017312F6 80A2FD55 A06FB7FF 079C2208 6D3C1F97 0A397519 177E8757", "the constant 3037000500 (not one more)"),
    ("BC1F7417 02D23123 A847B055 B45033FF 5BEC7564 84E51FED F08959CF 04A14360", "the table, rounded and not cut"),
    ("FC100C3A 02E7D374 FEB4B370 175B7BFF 7C27B8B9 0F4F0BCB 1F1CDC84 63108F0A", "the lowest bit of g"),
    ("012F0C17 017CBABF 778734EC 40B92BFF FE8BB6FF E852D3B5 2DC5DCA4 0DDE0B66", "the lowest bit of m in length"),
    ("03F0E827 01581BB6 7E7DBB41 BFB137FF 13831DB1 B2B89785 FE1DF50E 87844B43", "the bits of n that m leaves out in length"),
    ("3C003BD8 014E99E8 A012B1B2 3C17C7FF 3DE4240C C075AFE8 C61C39D2 46F74346", "length cut and not rounded"),
    ("81407BE7 10000000 8CB25328 462D07FF EE209475 02B74397 197FF4E0 05FEEB76", "the zoom limit of exactly 16"),
    ("C30F1BC8 01B3766F 776D7AC5 D2909BFF 11C72AED CA1527C2 2A7D1782 5B443F5F", "mul rounding to minus infinity in p"),
    ("C1B0CFF2 01D56307 45ED90FA FAD0C7FF 15892585 5BB6E3B0 96F985E0 5BAB5F4A", "the tunnel's b of cell 1 (not one more)"),
    ("FCA07413 020AB12C 947D02CB DBB713FF 02872098 9E78B37F BA94FA86 B6949F46", "the tunnel's b of cell 1 (not one less)"),
    ("C32F37CE 01AE5F06 35F422FD 1FD7AFFF 389CC72F 190DAF85 6554CB6E F3F70323", "the tunnel's b of cell 1/2 (not one more)"),
    ("C0A0F42A 02946E0D 4D0ECCB1 558B47FF CF8F6C14 857AFB92 59FFAA69 2E33F32B", "the tunnel's b of cell 1/2 (not one less)"),
    ("C32F1C0C 014CBC38 00472000 100493FF 842FBFF3 720773E3 DF897FE9 D842FB0F", "the tunnel's b of cell 1/8 (not one more)"),
    ("FC1FBC23 020E2BF7 F3B2A07D 812A03FF 168AFADB 983B0FD5 7D65FDD5 4182CB0A", "the tunnel's b of cell 1/8 (not one less)"),
    ("C3A0801C 0249962B 7902C635 EDE7CBFF EEA3F01F 0923C7A1 DA111B14 5C75275E", "the one shift after the sum of dot"),
    ("80AF3819 01848DAC 091CA0A9 6183CBFF 179D4662 27B2F787 82873EED 018F1B29", "3 * diffuse before the shift"),
    ("0320D7D2 01873972 E7AA5EB2 7E5433FF 4888C8FD C6324BBB 669E80EC 9B395357", "sky and diffuse shifted apart"),
)


def low_bit_rows() -> Iterator[Row]:
    for text, told in LOW_BIT_FRAMES:
        words = parse_words(text)
        yield Row(11, 9, words, f"{SCENE_NAMES[words[0] >> 30]}: a pixel's channel depends on {told}", some_hit)


def golden_rows() -> Iterator[Row]:
    rng = random.Random(SEED)
    yield from plain_rows()
    yield from camera_rows(rng)
    yield from inside_rows(rng)
    yield from arbitrary_rows(rng)
    yield from degenerate_rows()
    yield from light_and_colour_rows()
    yield from size_rows(rng)
    yield from zoom_limit_rows()
    yield from boundary_rows()
    yield from low_bit_rows()


def golden() -> None:
    print(
        f"# made by tests/model/marcher_model.py golden (seed {SEED}), not by an engine;"
        " size<TAB>eight words<TAB>crc32 of the RGB bytes<TAB>why"
    )
    for row in golden_rows():
        started = time.monotonic()
        picture, census = render(row.words, row.width, row.height)
        if not row.holds(census):
            raise SystemExit(f"the reason does not hold: {row.why}: {census}")
        words = " ".join(f"{word:08X}" for word in row.words)
        print(f"{row.width}x{row.height}\t{words}\t{zlib.crc32(picture):08X}\t{row.why}", flush=True)
        taken = time.monotonic() - started
        if taken > 5:
            print(f"{row.width}x{row.height} {row.why}: {taken:.0f} s", file=sys.stderr)


# --- The page's claims, recomputed ----------------------------------------------------------------------------------

PAGE_REACH = Fraction(1, 1 << 18)  # section "Ranges": |p| is at most |E| + t + this
PROVED_REACH = Fraction(1, 1 << 18)

def nearest(decimal: str, scale: int = ONE) -> int:
    return (2 * Fraction(decimal) * scale + 1).__floor__() // 2


def report(claim: str, holds: bool, detail: object = "") -> None:
    print(f"{'holds' if holds else 'FALSE'}  {claim}{f': {detail}' if detail != '' else ''}")


def check_constants() -> None:
    stated = (("1", ONE), ("0.01", SURFACE_DIST), ("20", MAX_DIST), ("0.01", H))
    report("constants: the nearest raws", all(nearest(value) == raw for value, raw in stated))
    decimals = ("0.45", "0.28333", "0.18167", "0.05")
    report("tunnel: b is the nearest raw of its decimal", all(nearest(d) == b for d, (_, b) in zip(decimals, TUNNEL_ROWS)))
    k = 3037000500
    report("3037000500 is round(2^32 / sqrt 2)", (2 * k - 1) ** 2 < 1 << 65 < (2 * k + 1) ** 2)


def check_table() -> None:
    # T = round(x) with x^2 = 2^73 / (4096 + i), compared as squares: (2T - 1)^2 <= 4 x^2 < (2T + 1)^2
    rounded = all((2 * t - 1) ** 2 * (4096 + i) <= 1 << 75 < (2 * t + 1) ** 2 * (4096 + i) for i, t in enumerate(T))
    report("the isqrt formula gives round(2^30 / sqrt(1/2 + i/8192)) for all i", rounded)
    report("T[0], T[1], T[4096]", (T[0], T[1], T[4096]) == (1518500250, 1518314920, 1073741824))
    report("T falls everywhere", all(a > b for a, b in zip(T, T[1:])))
    largest = max(T[i] * ((((4096 + i + 1) << 51) - 1) >> 32) for i in range(4096))
    report("length: m * M is below 2^63", largest < 1 << 63, f"at most 2^63 * {Fraction(largest, 1 << 63).__float__():.4f}")
    step = max(a - b for a, b in zip(T, T[1:]))
    report(
        "rsqrt has no steps above 2^-26 (n is cut to 27 bits)",
        Fraction(step, 16384) + 2 < Fraction(T[4096], 1 << 26),
        f"M changes by at most {step // 16384 + 2} of at least {T[4096]} from one g to the next",
    )


def rsqrt_error(square: int, bits: int = 90) -> Fraction:
    """(M / 2^s) / (2^24 / sqrt(square)) - 1, from an exact integer root."""
    mantissa, shift = rsqrt(square)
    scaled = isqrt((mantissa * mantissa * square << (2 * bits)) >> (48 + 2 * shift))
    return Fraction(scaled, 1 << bits) - 1


def check_rsqrt() -> None:
    rng = random.Random(SEED)
    sampled = [(1 << (k % 64)) | rng.getrandbits(k % 64) if k % 64 else 1 for k in range(200000)]
    aimed = [
        (n >> z)
        for z in (0, 1, 2, 3, 20, 21)
        for i in range(4096)
        for g in (0, 8191, 16383)
        for n in (((4096 + i) << 51) | (g << 37), ((4096 + i) << 51) | (g << 37) | ((1 << 37) - 1))
    ]
    for told, squares in (("200000 random S of all bit lengths", sampled), ("147456 S aimed at the worst places", aimed)):
        errors = [rsqrt_error(square) for square in squares]
        low, high = min(errors), max(errors)
        worst = max(-low, high)
        report(
            f"rsqrt: relative error below 2^-25, {told}",
            worst < Fraction(1, 1 << 25),
            f"{float(low):.4e} to {float(high):.4e}, that is 2^-25 * {float(worst * (1 << 25)):.4f}",
        )


def norm_ceiling(v: Vector, bits: int = 40) -> Fraction:
    """The norm of a Q8.24 vector in units, rounded up by less than 2^-(24 + bits)."""
    square = sum(c * c for c in v)
    return Fraction(isqrt(square << (2 * bits)) + 1, 1 << (24 + bits))


def check_words_and_rays() -> None:
    product = max(abs(z * f) for z in (0, 16 << 24) for f in (-131072, FULL))
    report("eye: the product has up to 47 bits", product < 1 << 46, f"magnitude {product:#x}, {product.bit_length()} bits")
    sizes = ((640, 480), (1920, 1080), (1920, 1), (1, 1080))
    largest = [131072 * (width - 1 + height - 1 + height) for width, height in sizes]
    report("d is below 2^29 up to 1920x1080", max(largest) < 1 << 29, f"{max(largest) / (1 << 29):.4f} * 2^29")
    report("d is below 2^29 as long as W + 2H is at most 4097", 131072 * (4097 - 2) < 1 << 29)


def check_reach() -> None:
    """|D| and |p| against the bound of "Ranges", by sampling; then one frame that shows it."""
    rng = random.Random(SEED)
    worst, at = Fraction(0), (0, 0, 0)
    for k in range(200000):
        bits = 4 + k % 26
        least = 0 if k % 2 else 1 << bits
        v = tuple(-(least + rng.getrandbits(bits if k % 2 else bits - 2)) for _ in range(3))
        d = normalise((v[0], v[1], v[2]))
        norm = norm_ceiling(d)
        if norm > worst:
            worst, at = norm, (v[0], v[1], v[2])
    excess = worst - 1
    told = "a direction is longer than 1 by less than a 20th of the page's bound"
    report(told, 20 * excess < PAGE_REACH, f"|D| reaches 1 + {float(excess):.3e} for d = {at}")
    bound = Fraction(1) + Fraction(1, 1 << 25)
    # |D| <= (1 + 2^-25) + sqrt(3) * 2^-24, the floor of mul adds sqrt(3) * 2^-24 once more; 1.7321 > sqrt(3)
    reach = 20 * (bound + Fraction(17321, 10000) / ONE) + Fraction(17321, 10000) / ONE - 20
    report("|p| at most |E| + t + 2^-18, proved", reach < PROVED_REACH, f"excess at most {float(reach):.3e}")
    eye = Fraction(16) * Fraction(17320509, 10000000)
    report("|p| below 48", eye + 20 + reach + Fraction(1, 50) < 48, f"at most {float(eye + 20 + reach):.5f}")
    report("t below 68", 20 + 48 <= 68)
    component = 64 + 16 + 20 + reach
    report("light - p below 112 in each component", component < 112, f"at most {float(component):.5f}")
    report("squared lengths below 3 * 2^62 for components below 128", 3 * (112 * ONE) ** 2 < 3 << 62)


def reach_excess(words: Sequence[int], width: int, height: int) -> tuple[Fraction, Vector]:
    """The largest |p| - |E| - t over a frame's last queries, and where it is."""
    frame = frame_words(words)
    best, where = Fraction(-100), (0, 0, 0)
    eye = norm_ceiling(frame.eye)
    for y in range(height):
        for x in range(width):
            ray = ray_marcher(frame.eye, ray_generator(frame, x, y, width, height), SCENES[frame.scene])
            over = norm_ceiling(ray.p) - eye - Fraction(ray.t - ray.d, ONE)
            if over > best:
                best, where = over, (x, y, ray.t - ray.d)
    return best, where


def check_reach_frames() -> None:
    best, at, found = Fraction(-100), (0, 0, 0), [0] * 8
    rng = random.Random(SEED)
    for _ in range(300):
        forward = tuple(rng.getrandbits(14) - 65536 for _ in range(3))
        right = tuple(2 * c + rng.getrandbits(3) for c in forward)
        norm = isqrt(sum(c * c for c in forward))
        # from |E| = e the steps away from the sphere reach t = (e - 1) (2^k - 1); just below 20
        zoom = ((1 << 17) + 20 * (1 << 17) // 31) * ONE // norm - rng.getrandbits(12)
        words = pack(SPHERE, zoom, forward, right, (0, 0, 0), LIGHT, WHITE)
        over, where = reach_excess(words, 2, 1)
        if over > best:
            best, at, found = over, where, words
    report(
        f"|p| at most |E| + t + {PAGE_REACH}, on frames of 2x1",
        best < PAGE_REACH,
        f"excess {float(best):.3e} at pixel {at[:2]}, t raw {at[2]}, words "
        + " ".join(f"{word:08X}" for word in found),
    )


def check_traced_ranges(frames: int = 400) -> None:
    """March extreme and random frames with a query that records what it sees."""
    rng = random.Random(SEED)
    far = longest = deepest = brightest = 0

    for k in range(frames):
        words = [rng.getrandbits(32) for _ in range(8)]
        words[1] |= 0x10000000
        if k % 2:
            codes = [rng.choice((-131072, FULL, 0, -131071)) for _ in range(9)]
            ends = [rng.choice((-512, 511)) for _ in range(3)]
            words = pack(k // 2 % 4, 16 << 24, tuple(codes[:3]), tuple(codes[3:6]), tuple(codes[6:]), tuple(ends), WHITE)
        frame = frame_words(words)
        scene = SCENES[frame.scene]

        def watched(p: Vector) -> int:
            nonlocal far, longest, deepest
            d = scene(p)
            far = max(far, p[0] * p[0] + p[1] * p[1] + p[2] * p[2])
            longest = max(longest, d)
            deepest = min(deepest, d)
            return d

        for y in range(5):
            for x in range(7):
                ray = ray_marcher(frame.eye, ray_generator(frame, x, y, 7, 5), watched)
                if ray.hit:
                    normal, light = surface_vectors(ray.p, frame.light, watched)
                    brightest = max(brightest, brightness(normal, light))
    report("positions below 48 in length, traced", far < (48 * ONE) ** 2, f"{isqrt(far) / ONE:.4f}")
    report("distances below 48, traced", longest < 48 * ONE, f"{deepest / ONE:.4f} to {longest / ONE:.4f}")
    # |N|, |L| <= 1 + 2^-25 + sqrt(3) 2^-24
    one = Fraction(ONE) * (1 + Fraction(1, 1 << 25)) + Fraction(17321, 10000)
    top = (1 << 21) + one / 8 + Fraction(3, 4) * one * one / ONE
    report("colour times B has up to 35 bits", 1023 * top < 1 << 35, f"B at most 2^24 + {float(top - ONE):.2f}")
    unheld = int(1023 * top) >> 26 <= 255
    report("the channel never needs to be held at 255", unheld, f"largest B traced 2^24 * {brightest / ONE:.6f}")


def check() -> None:
    check_constants()
    check_table()
    check_rsqrt()
    check_words_and_rays()
    check_reach()
    check_reach_frames()
    check_traced_ranges()


# --- Command line ---------------------------------------------------------------------------------------------------


def size(text: str) -> tuple[int, int]:
    width, _, height = text.partition("x")
    return int(width), int(height)


def main() -> None:
    parser = argparse.ArgumentParser(description="the marcher of docs/engine.md, in plain Python")
    commands = parser.add_subparsers(dest="command", required=True)
    one = commands.add_parser("draw", help="draw one frame")
    one.add_argument("words", nargs=8, metavar="WORD", type=lambda text: int(text, 16), help="a register word in hexadecimal")
    one.add_argument("--size", type=size, default=(640, 480), metavar="WxH")
    one.add_argument("-o", dest="file", required=True, metavar="FILE.ppm")
    commands.add_parser("golden", help="print the golden table")
    commands.add_parser("check", help="recompute the page's claims")
    arguments = parser.parse_args()
    if arguments.command == "golden":
        golden()
    elif arguments.command == "check":
        check()
    else:
        width, height = arguments.size
        with open(arguments.file, "wb") as file:
            file.write(b"P6\n%d %d\n255\n" % (width, height) + draw(arguments.words, width, height))


if __name__ == "__main__":
    main()
