#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The sphere and plane ray tracer once more, from docs/engine/whitted.md alone.

Usage: whitted_model.py golden > golden/whitted.tsv   pictures of scenes of both profiles
       whitted_model.py cycles PROGRAM                rays and cycles of raymarchctl against its own"""

import math
import random
import subprocess
import sys
import zlib
from dataclasses import dataclass, field

SEED = 20260922
MEASURED, REPAIRED = 0, 1
WORD, WIDE = 24, 48
Vector = tuple[int, int, int]


def wrap(value: int, bits: int = WORD) -> int:
    value &= (1 << bits) - 1
    return value - (1 << bits) if value >> (bits - 1) else value


def q(p: int) -> int:
    return wrap(p >> 12)


def dot(a: Vector, b: Vector) -> int:
    return wrap(sum(x * y for x, y in zip(a, b)), WIDE)


def root(m: int) -> int:
    return math.isqrt(((m >> 12) & 0xFFFFFF) * 4096)


def div(n: int, d: int) -> int:
    """The remainder is never negative, whatever the divisor's sign."""
    if d == 0:
        return 0
    quotient, _ = divmod(n * 4096, abs(d))
    return wrap(quotient if d > 0 else -quotient)


def normalise(v: Vector) -> Vector:
    n = wrap(root(dot(v, v)))
    return tuple(div(c, n) for c in v)


def minus(a: Vector, b: Vector) -> Vector:
    return tuple(wrap(x - y) for x, y in zip(a, b))


def plus(a: Vector, b: Vector) -> Vector:
    return tuple(wrap(x + y) for x, y in zip(a, b))


def scaled(v: Vector, k: int) -> Vector:
    return tuple(q(c * k) for c in v)


@dataclass
class Sphere:
    centre: Vector
    radius: int
    colour: Vector = (31, 31, 31)
    reflect: int = 0

    def __post_init__(self) -> None:
        self.r = self.radius or 1
        self.r2 = wrap(self.r * self.r << 24, WIDE)
        self.inverse = 4096 // self.r
        self.channels = tuple(32 * c for c in self.colour)


@dataclass
class Plane:
    normal: Vector
    offset: int
    colour: Vector = (31, 31, 31)
    reflect: int = 0
    checker: int = 0
    bounded: bool = False
    limits: Vector = (0, 0, 0)


@dataclass
class Scene:
    profile: int = REPAIRED
    planes_on: bool = True
    reflections: int = 3
    aa: int = 0
    eye: Vector = (0, 0, -32 * 4096)
    light: Vector = (0, 0, 0)
    light_radius: int = 2
    screen: int = 0x8000
    spheres: list[Sphere] = field(default_factory=list)
    planes: list[Plane] = field(default_factory=list)

    def words(self) -> list[int]:
        word = lambda c: (c & 0xFFFFFF) << 8
        words = [self.profile << 31 | self.planes_on << 30 | self.reflections << 27 | self.aa << 25
                 | len(self.spheres) << 21 | self.light_radius]
        words += [word(c) for c in (*self.eye, *self.light, self.screen)]
        for i in range(14):
            s = self.spheres[i] if i < len(self.spheres) else Sphere((0, 0, 0), 0, (0, 0, 0))
            words += [word(c) | colour for c, colour in zip(s.centre, s.colour)]
            words.append(s.radius << 12 | s.reflect)
        for p in self.planes:
            words += [word(c) | colour for c, colour in zip(p.normal, p.colour)]
            words += [word(p.offset) | p.bounded << 4 | p.checker, p.limits[0] << 12 | p.reflect,
                      p.limits[1] << 16 | p.limits[2]]
        return words


class Machine:
    """One frame: the pixels, and what they cost."""

    def __init__(self, scene: Scene, width: int, height: int) -> None:
        self.scene, self.width, self.height = scene, width, height
        self.measured = scene.profile == MEASURED
        spheres = scene.spheres[:14] or [Sphere((0, 0, 0), 0, (0, 0, 0))]
        light = Sphere(scene.light, scene.light_radius)
        light.channels = (1023, 1023, 1023)
        self.spheres = [*spheres, light]
        self.last = len(spheres)
        self.cycles = 0
        self.rays = 0

    def primary(self, x: int, y: int, dx: int, dy: int) -> Vector:
        def across(pixel: int, half: int, size: int, eye: int) -> int:
            at = 4096 * pixel + 2048 * half
            if self.measured:
                at &= 0xFFFFFF  # R6
            return wrap((at >> 5) - 64 * size - (eye >> 5))

        ex, ey, ez = self.scene.eye
        depth = self.scene.screen - (ez >> 5)
        if self.measured:
            depth = self.scene.screen + 524288 - ((ez & 0xFFFFFF) >> 5)  # R7
        return normalise((across(x, dx, self.width, ex), across(y, dy, self.height, ey), wrap(depth)))

    def nearest(self, o: Vector, d: Vector, reflected: bool, leaves: int | None):
        """('sphere' or 'plane', index, point), or None."""
        test, best, taken = o, None, None
        for i, sphere in enumerate(self.spheres):
            oc = minus(sphere.centre, test)
            squared = dot(oc, oc)
            if not reflected and squared < sphere.r2:
                self.cycles += 2
                return None
            m = dot(d, oc)
            if m < 0 or (not self.measured and reflected and i == leaves):
                self.cycles += 3
                continue
            tca = q(m)
            h = wrap(tca * tca - squared + sphere.r2, WIDE)
            if h < 0:
                self.cycles += 4
                continue
            self.cycles += 11
            k = root(h)
            t = wrap(tca - k if squared >= sphere.r2 else tca + k)
            if self.measured:  # R3
                takes = best is None or (t & 0xFFFFFF) < (best & 0xFFFFFF)
            else:
                takes = t > 0 and (best is None or t < best)
            if takes:
                best, taken = t, ("sphere", i, plus(o, scaled(d, t)))
                if self.measured and reflected:
                    test = taken[2]  # R1
        if taken:
            self.cycles += 1
            return taken
        if not self.scene.planes_on:
            return None
        for i, plane in enumerate(self.scene.planes):
            m = dot(d, plane.normal)
            if m >= 0:
                self.cycles += 1
                continue
            self.cycles += 8
            vo = wrap(q(wrap(-dot(test, plane.normal), WIDE)) - plane.offset)
            t = div(vo, q(m))
            if t <= 1024 or (best is not None and t >= best):
                continue
            p = plus(o, scaled(d, t))
            if self.measured and reflected:
                test = p  # R1
            if plane.bounded and not all(abs(c) >> 12 < limit for c, limit in zip(p, plane.limits)):
                continue
            best, taken = t, ("plane", i, p)
        return taken

    def blocked(self, p: Vector, s: Vector, dl: int, dl2: int, own: int | None) -> bool:
        for i, sphere in enumerate(self.spheres[:-1]):
            oc = minus(sphere.centre, p)
            squared = dot(oc, oc)
            m = dot(s, oc)
            tca = q(m)
            h = wrap(tca * tca - squared + sphere.r2, WIDE)
            if self.measured:
                if wrap(squared - (sphere.r << 24), WIDE) > dl2:  # R5
                    self.cycles += 2 if i == self.last - 1 else 1
                elif m < 0:
                    self.cycles += 3
                elif i == own or squared < sphere.r2:  # R2
                    self.cycles += 3
                    return True
                elif h < 0:
                    self.cycles += 4
                else:
                    self.cycles += 4
                    return True
                continue
            if m < 0 or i == own:
                self.cycles += 3
                continue
            self.cycles += 4
            if h < 0:
                continue
            beyond = wrap(tca - dl)
            if tca <= dl or beyond * beyond < h:
                return True
        return False

    def way_to_light(self, p: Vector) -> tuple[Vector, int, int]:
        way = tuple(c >> 4 for c in minus(self.scene.light, p))
        squared = dot(way, way)
        n = wrap(root(squared))
        return tuple(div(c, n) for c in way), wrap(16 * n), wrap(256 * squared, WIDE)

    def lit(self, kind: str, i: int, p: Vector, stale: int) -> tuple[Vector, Vector, int]:
        """The normal, the colour, the share that is reflected."""
        s, dl, dl2 = self.way_to_light(p)
        self.cycles += 14 + 1 + 1
        if kind == "sphere":
            self.cycles += 1
            sphere = self.spheres[i]
            normal = scaled(minus(p, sphere.centre), sphere.inverse)
            f = dot(s, normal)
            dark = tuple(c >> 1 for c in sphere.channels)
            if f < 0 or self.blocked(p, s, dl, dl2, i):
                return normal, dark, sphere.reflect
            k = f >> 12 & 4095 if self.measured else min(f >> 12, 4095)  # R4
            return normal, tuple((k * c >> 12) + (c >> 1) for c in sphere.channels), sphere.reflect
        plane = self.scene.planes[i]
        colour = tuple(32 * c for c in plane.colour)
        if ((p[0] >> 12) ^ (p[2] >> 12)) & plane.checker:
            colour = tuple(c >> 2 for c in colour)
        if self.blocked(p, s, dl, dl2, stale if self.measured else None):
            colour = tuple(c >> 1 for c in colour)
        return plane.normal, colour, plane.reflect

    def sample(self, d: Vector) -> tuple[Vector, bool, bool]:
        """The colour; whether the primary ray, and whether the last ray, meets the light."""
        self.cycles += 14 + 1
        self.rays += 1
        total, weight, o, stale, leaves = (0, 0, 0), 4095, self.scene.eye, 0, None
        for bounce in range(4):
            hit = self.nearest(o, d, bounce > 0, leaves)
            if hit is None:
                break
            self.cycles += 1
            kind, i, p = hit
            light = kind == "sphere" and i == self.last
            if light:
                normal, colour, reflect = (0, 0, 0), self.spheres[i].channels, 0
            else:
                if kind == "sphere":
                    stale = i
                self.rays += 1
                normal, colour, reflect = self.lit(kind, i, p, stale)
            total = tuple(min(t + (c * weight >> 12), 1023) for t, c in zip(total, colour))
            if light:
                return total, bounce == 0, True
            weight = weight * reflect >> 12
            if bounce == self.scene.reflections or weight < 40:
                break
            self.cycles += 2 + 14
            self.rays += 1
            g = wrap(dot(d, normal) >> 11)
            o, d = p, normalise(minus(d, scaled(normal, g)))
            leaves = i if kind == "sphere" else None
        return total, False, False

    def pixel(self, x: int, y: int) -> bytes:
        corners = [(-1, -1), (-1, 1), (1, -1), (1, 1)]
        edges = [(-1, 0), (0, 1), (0, -1), (1, 0)]
        places = [((0, 0), 0)]
        if self.scene.aa == 1:
            places = [((0, 0), 1), *((c, 3) for c in corners)]
        elif self.scene.aa > 1:
            places = [((0, 0), 2), *((c, 4) for c in corners), *((e, 3) for e in edges)]
        total, flag = [0, 0, 0], False
        for number, ((dx, dy), shift) in enumerate(places):
            colour, sees, ends = self.sample(self.primary(x, y, dx, dy))
            total = [t + (c >> shift) for t, c in zip(total, colour)]
            if self.measured:
                flag = ends  # R8
            elif number == 0:
                flag = sees
        if self.measured and y == 0:
            return bytes(3)  # R6
        return bytes((t >> 5) << 3 | (7 if flag else 0) for t in total)

    def picture(self) -> bytes:
        return b"".join(self.pixel(x, y) for y in range(self.height) for x in range(self.width))

    def finish(self) -> None:
        """What a frame costs besides its picture."""
        if self.measured:  # R9
            for x in range(self.width + 1):
                self.pixel(x, self.height)
            for y in range(self.height):
                self.pixel(self.width, y)
        self.cycles += 1


def fixed(value: float) -> int:
    return wrap(round(value * 4096))


def random_scene(rng: random.Random, profile: int) -> Scene:
    def point(spread: float) -> Vector:
        return tuple(fixed(rng.uniform(-spread, spread)) for _ in range(3))

    def colour() -> Vector:
        return tuple(rng.randint(0, 31) for _ in range(3))

    def sphere() -> Sphere:
        radius = rng.choice((0, 1, 2, 3, 5, 5, 9, 15, 40, 300, 2047))
        return Sphere(point(rng.choice((12, 25, 60))), radius, colour(), rng.choice((0, 300, 2048, 3500, 4095)))

    def plane() -> Plane:
        axis, sign = rng.randrange(3), rng.choice((-1, 1))
        normal = tuple(sign * 4096 if i == axis else 0 for i in range(3))
        if rng.random() < 0.4:
            direction = [rng.uniform(-1, 1) for _ in range(3)]
            length = math.hypot(*direction)
            normal = tuple(fixed(c / length) for c in direction)
        return Plane(normal, fixed(rng.uniform(-5, 60)), colour(), rng.choice((0, 400, 2048, 4000)),
                     rng.choice((0, 0, 1, 6, 8, 15)), rng.random() < 0.4,
                     tuple(rng.choice((5, 20, 60, 4095)) for _ in range(3)))

    eye = (fixed(rng.uniform(-8, 8)), fixed(rng.uniform(-8, 8)), fixed(rng.uniform(-70, -15)))
    if rng.random() < 0.1:
        eye = point(2000)
    return Scene(profile, rng.random() < 0.7, rng.randrange(4), rng.choice((0, 0, 1, 2)), eye,
                 point(rng.choice((20, 40, 900))), rng.choice((1, 2, 3, 20)),
                 fixed(rng.choice((0.125, 1.0, 4.0, -1.0))), [sphere() for _ in range(rng.randint(1, 14))],
                 [plane() for _ in range(4)])


def random_words(rng: random.Random) -> tuple[Scene, list[int]]:
    """Any bits at all, but for the fields whose odd codes the page folds together."""
    word = lambda: wrap(rng.getrandbits(24))
    vector = lambda: (word(), word(), word())
    colour = lambda: tuple(rng.randrange(32) for _ in range(3))
    spheres = [Sphere(vector(), rng.randrange(2048), colour(), rng.randrange(4096))
               for _ in range(rng.randint(1, 14))]
    planes = [Plane(vector(), word(), colour(), rng.randrange(4096), rng.randrange(16), rng.random() < 0.5,
                    tuple(rng.randrange(4096) for _ in range(3))) for _ in range(4)]
    scene = Scene(rng.randrange(2), rng.random() < 0.8, rng.randrange(4), rng.randrange(4), vector(), vector(),
                  rng.randrange(2048), word(), spheres, planes)
    return scene, scene.words()


def golden() -> None:
    print("# made by tests/model/whitted_model.py golden, not by an engine; size<TAB>88 words<TAB>crc32 of the RGB bytes<TAB>why")
    rng = random.Random(SEED)

    def row(scene: Scene, width: int, height: int, why: str, least: int) -> bool:
        rgb = Machine(scene, width, height).picture()
        if len(set(zip(*[iter(rgb)] * 3))) < least:  # few colours prove little
            return False
        words = " ".join(f"{word:08X}" for word in scene.words())
        print(f"{width}x{height}\t{words}\t{zlib.crc32(rgb):08X}\t{why}")
        return True

    for profile, name in ((REPAIRED, "repaired"), (MEASURED, "measured")):
        for number in range(1, 25):
            width, height = rng.choice(((48, 36), (63, 21), (17, 50), (80, 60)))
            while not row(random_scene(rng, profile), width, height, f"{name}, scene {number}", 12):
                pass
    for number in range(1, 25):
        while not row(random_words(rng)[0], 31, 19, f"any bits {number}", 2):
            pass


def cycles(program: str) -> None:
    rng = random.Random(SEED)
    width, height = 23, 14
    for number in range(24):
        scene = random_words(rng)[0] if number % 3 == 0 else random_scene(rng, number % 2)
        machine = Machine(scene, width, height)
        machine.picture()
        machine.finish()
        words = [f"{word:X}" for word in scene.words()]
        printed = subprocess.run([program, "cycles", "--accelerator", "whitted", "--size", f"{width}x{height}",
                                  "--registers", *words], stdout=subprocess.PIPE, text=True, check=True).stdout
        values = dict(line.split()[:2] for line in printed.splitlines())
        assert values["rays"] == str(machine.rays), (number, values, machine.rays)
        assert values["cycles"] == str(machine.cycles), (number, values, machine.cycles)
    print("whitted_model: rays and cycles are the same")


if __name__ == "__main__":
    {"golden": golden, "cycles": cycles}[sys.argv[1]](*sys.argv[2:])
