#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The fractal marcher of docs/engine/fractal.md, written a second time, in plain Python, with its sections' names.

    fractal_model.py golden > tests/golden/fractal.tsv      the frames that the engine must match
"""
import random
import sys
import zlib

SEED = 20260730
MASK = (1 << 22) - 1
HALF, QUARTER, SIXTEENTH, THIRD, TENTH, FIVE = 32768, 16384, 4096, 21845, 6553, 327680
MENGER, CUBES, CUBE, MAZE = range(4)


def word(a):
    a &= MASK
    return a - (1 << 22) if a >> 21 else a


def mul(a, b):
    return word((a * b) >> 16)


def absolute(a):
    return word(-a) if a < 0 else a


def fract(a):
    return a & 0xFFFF


def shifted(a, n):
    return (a & MASK) >> n


def rsqrt(a):
    k = shifted(a, 16).bit_length()
    m = word(shifted(a, k))
    r = word(92681 - mul(54291, word(m - HALF)))
    for _ in range(2):
        r = mul(r, word(98304 - mul(m >> 1, mul(r, r))))
    r = word(shifted(r, k // 2))
    return mul(r, 46340) if k % 2 else r


def ray_generator(f, x, y, width, height):
    fx, fy, fz = f
    step = 131072 // height
    px = word(-65536 * width // height + x * step)
    py = word(-65536 + y * step)
    right = (fz, 0, word(-fx))
    up = (mul(fy, word(-fx)), word(mul(fz, fz) + mul(fx, fx)), word(-mul(fy, fz)))
    vx, vy, vz = (word(mul(r, px) + mul(u, py) + c) for r, u, c in zip(right, up, f))
    n = rsqrt(word(mul(vx, vx) + mul(vy, vy) + mul(vz, vz)))
    return mul(vx, n), word(-mul(vy, n)), mul(vz, n)


def menger(p):
    terms = []
    for mask, middle, offset in ((0x1FFFE, 65536, -29492), (0xFFFF, 32768, -18569), (0x7FFF, 16384, -11906),
                                 (0x1FFF, 4096, -3277)):
        terms.append(sorted(absolute(word((c & mask) - middle)) for c in p)[1] + offset)
    return max(terms)


def cubes(p):
    return max(abs(fract(c + HALF) - HALF) for c in p) - QUARTER


def cube(p):
    return word(max(absolute(c) for c in p) - HALF)


def maze(p):
    q = [fract(c) - HALF for c in p]
    a = [abs(c) for c in q]
    w = [0 if d == 0 or e < max(a) else HALF if d > 0 else -HALF for d, e in zip(q, a)]
    x, y, z = (word(c - fract(c) + HALF + v) for c, v in zip(p, w))
    number = fract(mul(x, 98304) + mul(y, THIRD) + mul(z, QUARTER))
    if number <= THIRD:
        return max(a[0], a[1]) - SIXTEENTH
    return max(a[1], a[2]) - SIXTEENTH if number <= HALF else max(a[0], a[2]) - SIXTEENTH


def ray_marcher(p, d, dist):
    depth = 0
    while True:
        s = dist(p)
        if s < 327 or s > FIVE or depth == 31:
            return s < 327, depth, p
        p = tuple(word(c + mul(e, s)) for c, e in zip(p, d))
        depth += 1


def brick(p, depth):
    px, py, pz = (word(16 * c) for c in p)
    o = HALF if (py - HALF) & 0x10000 else 0
    u = fract(shifted(px, 1) + shifted(pz, 1)) + o
    v = fract(py)
    return (depth - 2) & 31 if min(abs(u - HALF), abs(v - HALF)) > TENTH else depth


def display(g, hue, coloured):
    l = 16 * g
    c = (2 * (l + 1) if l + 1 < 128 else 512 - 2 * (l + 1)) * (165 if coloured else 0) // 256
    m = l - c // 2
    t = 6 * hue
    k, f = t // 256 % 4, t % 256 + 1
    x = (256 - f if t & 256 else f) * c // 256
    blue, green, red = c if k == 0 else 0, (0, c, x, 0)[k], c if k == 3 else x
    return bytes((channel + m) % 256 // 16 * 17 for channel in (red, green, blue))


def draw(words, width, height):
    """Frame number 0 onto black."""
    position, forward = (tuple(word(w) for w in words[i:i + 3]) for i in (0, 3))
    last = words[6]
    dither, texture, checker, coloured = (last >> bit & 1 for bit in (4, 5, 6, 7))
    dist = (menger, cubes, cube, maze)[last & 3]
    colours = [display(g, last >> 8 & 255, coloured) for g in range(16)]
    picture = []
    for y in range(height):
        for x in range(width):
            odd = (x + y) & 1
            if checker and not odd:
                picture.append(bytes(3))
                continue
            hit, depth, p = ray_marcher(position, ray_generator(forward, x, y, width, height), dist)
            k = brick(p, depth) if texture else depth
            grey = 15 - (k >> 1) - (dither and k & 1 and k >> 1 != 15 and odd) if hit else 0
            picture.append(colours[grey])
    return b"".join(picture)


def rows():
    rng = random.Random(SEED)
    start = [0, 65536, -98304, 0, 0, 65536]
    for scene, name in enumerate(("menger", "cubes", "cube", "maze")):
        yield (80, 60), start + [scene], f"{name} from the start"
        yield (80, 60), start + [scene | 0x30], f"{name} with dither and bricks"
        yield (61, 40), start + [scene | 0x70], f"{name} as a checkerboard, odd width"
        for i in range(6):
            place = [rng.randint(-1 << 21, (1 << 21) - 1) for _ in range(3)]
            if scene == CUBE:
                place = [rng.choice((-1, 1)) * rng.randint(33500, 110000) for _ in range(3)]
            view = [rng.randint(-65536, 65536) for _ in range(3)]
            if scene == CUBE:
                view = [-place[0] // 2, place[1] // 2, -place[2] // 2]  # up is negative
            yield (40, 30), place + view + [scene | rng.getrandbits(16) & 0xFFB0], f"{name}, any camera, {i}"
        for i in range(6):
            yield (16, 12), [rng.getrandbits(32) for _ in range(6)] + [scene | rng.getrandbits(30) << 2], \
                f"{name}, any words at all, {i}"
    for hue in range(0, 256, 37):
        yield (24, 18), start + [MAZE | 0xB0 | hue << 8], f"hue {hue}"
    for size in ((1, 1), (1, 40), (64, 1), (70, 2), (33, 47)):
        yield size, start + [MAZE | 0x30], "sizes, the widest wraps"
    for forward in ((0, 0, 0), (1, 0, 0), (0, 65536, 0), (-1 << 21, -1 << 21, -1 << 21), (3, -5, 7)):
        yield (20, 15), start[:3] + list(forward) + [CUBES | 0x30], "forwards that are no direction"
    for place in ((0, 0, 0), (-1, -1, -1), (32768, 32768, 32768), (-1 << 21,) * 3, ((1 << 21) - 1,) * 3):
        for scene in range(4):
            yield (20, 15), list(place) + [20000, -9000, 61000, scene | 0x30], "places on borders of cells and numbers"


def golden():
    print(f"# made by tests/model/fractal_model.py golden (seed {SEED}), not by an engine;"
          " size<TAB>seven words<TAB>crc32 of the RGB bytes<TAB>why")
    for (width, height), words, why in rows():
        text = " ".join(f"{w & 0xFFFFFFFF:08X}" for w in words)
        print(f"{width}x{height}\t{text}\t{zlib.crc32(draw(words, width, height)):08X}\t{why}")


if __name__ == "__main__":
    if sys.argv[1:] != ["golden"]:
        sys.exit(__doc__)
    golden()
