#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The sphere tracer once more, from docs/engine/sphere.md alone.

Usage: sphere_model.py golden > golden/sphere.tsv   pictures of scenes of every MODEL and FAULTS
       sphere_model.py check                        its own claims: the rounded root, the frames' edges

The prototype's root goes through a float here; the engine has none."""

import math
import random
import sys
import zlib
from dataclasses import dataclass, field
from typing import Optional

MODELS = ("rtl", "rtl_top", "rtl_timed", "c")
FAULTS = ("kept", "repaired", "corrected")
SEED = 20260802

Triple = tuple[int, int, int]


def low(value: int, bits: int) -> int:
    return value & ((1 << bits) - 1)


def signed(value: int, bits: int) -> int:
    value = low(value, bits)
    return value - (1 << bits) if value >> (bits - 1) else value


def divide(a: int, b: int) -> int:
    """Towards zero."""
    return -(-a // b) if (a < 0) != (b < 0) else a // b


@dataclass
class Scene:
    model: str = "rtl"
    faults: str = "kept"
    grey: bool = False
    eye: Triple = (320, 240, 0)
    f: int = 1000
    k: int = 200
    d: int = 75
    cutoff: int = 2
    n: int = 1
    m: int = 1
    spheres: list[tuple[int, int, int, int]] = field(
        default_factory=lambda: [(320, 240, 1100, 100), (180, 160, 1000, 60), (460, 330, 1200, 80)]
    )
    lights: list[tuple[int, int, int, int]] = field(
        default_factory=lambda: [(50, 50, 1000, 4095)] + [(50, 50, 1000, 0)] * 7
    )

    @property
    def hardware(self) -> bool:
        return self.model != "c"

    @property
    def corrected(self) -> bool:
        return self.faults == "corrected"

    def words(self) -> list[int]:
        words = [
            MODELS.index(self.model) | FAULTS.index(self.faults) << 2 | self.grey << 4
            | self.n << 8 | self.m << 12 | self.cutoff << 16,
            self.d << 16 | self.k,
            *(low(value, 17) for value in (*self.eye, self.f)),
        ]
        for row in (*self.spheres, *self.lights):
            words += [low(row[0], 17), low(row[1], 17), low(row[2], 17), row[3]]
        return words

    def registers(self) -> "Scene":
        """Section 1: as the hardware holds it."""
        if not self.hardware or self.corrected:
            return self
        word = lambda row: tuple(low(value, 16) for value in row)
        return Scene(self.model, self.faults, self.grey, word(self.eye), low(self.f, 16), low(self.k, 10), self.d,
                     low(self.cutoff, 4), 1, 1, [word(s) for s in self.spheres], [word(l) for l in self.lights])


def unit(scene: Scene, p0: Triple, p1: Triple, sphere, segment: bool) -> tuple[str, int, Optional[Triple]]:
    """Section 3: how it ends, T, the point."""
    hardware, corrected = scene.hardware, scene.corrected
    kept_rtl = hardware and scene.faults == "kept"
    d = [p1[i] - p0[i] for i in range(3)]
    m = [p0[i] - sphere[i] for i in range(3)]
    dot = lambda u, v: sum(x * y for x, y in zip(u, v))
    a, b, c = dot(d, d), 2 * dot(d, m), dot(m, m) - sphere[3] ** 2
    if not hardware and not corrected:
        a, b, c = (signed(value, 32) for value in (a, b, c))
    q = b * b - 4 * a * c
    if q < 0 or (q == 0 and hardware and not corrected):
        return "missed", 0, None
    s = int(math.sqrt(float(q))) if not hardware and not corrected else math.isqrt(q)
    g = divide(a, scene.d) if scene.d else 0
    t1, t2 = -b + s - g, -b - s - g
    if a == 0:
        return "rejected", 0, None
    h = 10 if segment else 0
    below = lambda t: (low(t, 64) if kept_rtl else t) < h
    above = lambda t: segment and t > 2 * a
    t = t2
    if corrected:
        counting = [root for root in (t2, t1) if not below(root) and not above(root)]
        if not counting:
            return "rejected", 0, None
        t = counting[0]
    elif (below(t1) and below(t2)) or (above(t1) and above(t2)):
        return "rejected", 0, None
    point = []
    for k in range(3):
        first = t1 if kept_rtl and k == 0 else t
        numerator = first * p1[k] + (2 * a - t) * p0[k]
        v = divide(signed(numerator, 64), 2 * a)
        if corrected:
            v = max(-131072, min(131071, v))
        else:
            v = low(v, 16) if hardware else signed(v, 32)
        point.append(v)
    return "hit", t, tuple(point)


def squared(p: Triple, light) -> int:
    return sum((light[i] - p[i]) ** 2 for i in range(3))


PERIODS = {"missed": (1004, 1008), "behind": (2504, 2508), "clear": (4605, 4608), "rejected": (6105, 6108),
           "shadowed": (7009, 7012)}


def hardware_pixel(scene: Scene, x: int, y: int) -> tuple[int, str]:
    """Section 4."""
    end, _, point = unit(scene, scene.eye, (x, y, scene.f), scene.spheres[0], False)
    if end != "hit":
        return 0, "missed" if end == "missed" else "behind"
    light = scene.lights[0]
    end, _, _ = unit(scene, point, light[:3], scene.spheres[0], True)
    if end == "hit":
        return min(scene.cutoff, 15), "shadowed"
    d2 = squared(point, light)
    v = light[3] * scene.k // d2 if d2 else (15 if scene.corrected else 0)
    if scene.corrected:
        v = max(v, scene.cutoff)
    return min(v, 15), "clear" if end == "missed" else "rejected"


def prototype_pixel(scene: Scene, x: int, y: int) -> bytes:
    """Section 5."""
    hits = []
    for i in range(scene.n):
        end, t, point = unit(scene, scene.eye, (x, y, scene.f), scene.spheres[i], False)
        if end == "hit":
            hits.append((t, i, point))
    if not hits:
        return bytes(3)
    if scene.corrected:
        _, colour, point = min(hits, key=lambda hit: hit[0])
    else:
        colour, point = hits[0][1], hits[-1][2]
    brightness = 0
    for light in scene.lights[: scene.m]:
        if any(unit(scene, point, light[:3], s, True)[0] == "hit" for s in scene.spheres[: scene.n]):
            continue
        d2 = squared(point, light)
        power = light[3] * scene.k
        if not scene.corrected:
            power = signed(power, 32)
        added = divide(power, d2) if d2 else (255 if scene.corrected else 0)
        brightness = low(min(255, brightness + added), 8)
    channels = [scene.cutoff] * 3
    channels[colour] = max(brightness, scene.cutoff)
    return bytes(channels)


def picture(scene: Scene, width: int, height: int) -> tuple[bytes, int]:
    """The RGB bytes, and the hardware's edges."""
    pixels = [(x, y) for y in range(height) for x in range(width)]
    if not scene.hardware:
        return b"".join(prototype_pixel(scene, x, y) for x, y in pixels), 0
    scene = scene.registers()
    drawn = [hardware_pixel(scene, x, y) for x, y in pixels]
    edges = sum(PERIODS[outcome][1] for _, outcome in drawn)
    values = [value for value, _ in drawn]
    if scene.model == "rtl_timed" and not scene.corrected:
        enable, quotient = 4, 0
        for i, (value, outcome) in enumerate(drawn):
            ready, period = PERIODS[outcome]
            if outcome in ("clear", "rejected"):
                if not 1 <= (enable + ready - 64) % 128 <= 64:
                    values[i] = quotient
                quotient = value
            enable += period
    if scene.model in ("rtl_top", "rtl_timed") and not scene.corrected:
        values = [0, *values[:-1]]
    return b"".join(bytes((17 * v, 17 * v, 17 * v if scene.grey else 0)) for v in values), edges


def random_scene(rng: random.Random, model: str, faults: str, width: int, height: int) -> Scene:
    """Spheres on the lines of pixels, some of them behind the camera or around it, some lights far away."""
    eye = (rng.randint(0, width), rng.randint(0, height), rng.randint(-20, 40))
    f = rng.randint(60, 200)

    def sphere() -> tuple[int, int, int, int]:
        radius = rng.randint(8, 60)
        if rng.random() < 0.1:
            return (*eye, rng.randint(100, 500))
        z = rng.randint(f // 2, 3 * f) * (-1 if rng.random() < 0.15 else 1)
        pixel = rng.randint(0, width), rng.randint(0, height)
        return *(eye[i] + (pixel[i] - eye[i]) * (z - eye[2]) // (f - eye[2]) for i in range(2)), z, radius

    spread = rng.choice((100, 400, 30000))
    light = lambda: (*(rng.randint(-spread, spread) for _ in range(3)), rng.randint(100, 60000))
    return Scene(model, faults, rng.random() < 0.3, eye, f, rng.choice((75, 200, 1023, 1025)),
                 rng.choice((0, 7, 25, 75, 300)), rng.choice((0, 2, 25)), rng.randint(1, 3), rng.randint(1, 8),
                 [sphere() for _ in range(3)], [light() for _ in range(8)])


def golden() -> None:
    print("# made by tests/model/sphere_model.py golden, not by an engine; size<TAB>fifty words<TAB>crc32 of the RGB bytes<TAB>why")

    def row(scene: Scene, width: int, height: int, why: str) -> bool:
        rgb, _ = picture(scene, width, height)
        if len(set(zip(*[iter(rgb)] * 3))) < 3:  # black and one shade prove little
            return False
        words = " ".join(f"{word:08X}" for word in scene.words())
        print(f"{width}x{height}\t{words}\t{zlib.crc32(rgb):08X}\t{why}")
        return True

    demo = [(325, 240, 1100, 100), (180, 160, 1000, 60), (460, 330, 1200, 80)]
    row(Scene("rtl_timed", spheres=demo), 640, 480, "rtl_timed: the first frame of the hardware")
    rng = random.Random(SEED)
    for model in MODELS:
        for faults in FAULTS:
            for number in range(1, 7):
                why = f"{model} {faults}, scene {number}"
                while not row(random_scene(rng, model, faults, 80, 60), 80, 60, why):
                    pass


def check() -> None:
    rng = random.Random(SEED)
    for _ in range(200000):  # section 3: rroot in integers is that of a float
        q = rng.getrandbits(rng.randint(1, 64))
        if rng.random() < 0.5:
            n = rng.getrandbits(rng.randint(20, 32)) + 1
            q = max(0, n * n - rng.randint(1, 1 + (n >> 19)))
        surplus = max(0, q.bit_length() - 53)
        v = q >> surplus
        rest, half = low(q, surplus), (1 << surplus) >> 1
        v = (v + (surplus > 0 and (rest > half or (rest == half and v & 1)))) << surplus
        n = math.isqrt(v)
        root = n + 1 if n > 0 and (n + 1) ** 2 - v <= n >> max(0, 53 - n.bit_length()) else n
        assert root == int(math.sqrt(float(q))), q
    scene = Scene("rtl", spheres=[(325, 240, 1100, 100)])
    _, edges = picture(scene, 640, 480)
    assert edges == 439568928, edges
    print("sphere_model: the page's claims hold")


if __name__ == "__main__":
    {"golden": golden, "check": check}[sys.argv[1]]()
