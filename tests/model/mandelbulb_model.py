#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""docs/engine/mandelbulb.md written a second time, in plain Python: integers without a width.

    mandelbulb_model.py check FOLDER    every vector of FOLDER (tests/data/mandelbulb), both forms
    mandelbulb_model.py wide > tests/data/mandelbulb/wide.tsv     the vectors of the wide form
    mandelbulb_model.py golden ROWS > tests/golden/mandelbulb.tsv
        ROWS are lines of that file whose CRC-32 may be anything: it is computed again
    mandelbulb_model.py draw SIZE WORD x27 > FILE.ppm

It shares no code and no tables with the engine: angles, logarithms and gains are computed here from
series, in 320-bit fixed point."""

import random
import sys
import zlib
from math import isqrt
from pathlib import Path

TURN = 1 << 64
PREC = 320
ONE = 1 << PREC


def atan_inverse_power(i: int) -> int:
    """atan(2^-i) * 2^PREC for i > 0."""
    total, k = 0, 0
    while (term := (ONE >> (i * (2 * k + 1))) // (2 * k + 1)) != 0:
        total += -term if k % 2 else term
        k += 1
    return total


def atan_reciprocal(n: int) -> int:
    total, k, power = 0, 0, ONE // n
    while power:
        total += -(power // (2 * k + 1)) if k % 2 else power // (2 * k + 1)
        power //= n * n
        k += 1
    return total


PI = 16 * atan_reciprocal(5) - 4 * atan_reciprocal(239)
ANGLES = [TURN // 8] + [(atan_inverse_power(i) * TURN + PI) // (2 * PI) for i in range(1, 64)]


def logarithm_table(fraction: int) -> list[int]:
    table = []
    for j in range(64):
        if j == 0:  # ln 2 = sum of 1 / (k 2^k)
            value = sum((ONE >> k) // k for k in range(1, PREC))
        else:
            value = sum((-1) ** (k + 1) * ((ONE >> (j * k)) // k) for k in range(1, PREC // j + 1))
        table.append((value + (1 << (PREC - fraction - 1))) >> (PREC - fraction))
    return table


def gain(steps: int) -> int:
    """round(2^63 / sqrt(product of 1 + 4^-i)), by an exact square root."""
    numerator, denominator = 1, 1
    for i in range(steps):
        numerator *= 4**i
        denominator *= 4**i + 1
    return (isqrt((numerator << 128) // denominator) + 1) // 2


LOGARITHMS = {f: logarithm_table(f) for f in (57, 64)}
GAINS = {n: gain(n) for n in range(8, 65)}


def keep(a: int, k: int) -> int:
    cleared = max(a.bit_length() - k, 0) if k < 64 else 0
    return a >> cleared << cleared


class Model:
    """One form (fraction bits), and what a frame sets."""

    def __init__(self, fraction: int, steps: int, kept: int, power: int = 8, slide: bool = True, scale: int = 0,
                 iterations: int = 25) -> None:
        self.f, self.n, self.k, self.d, self.slide, self.ts, self.i = (
            fraction, steps, kept, power, slide, scale, iterations)

    def scaled(self, v: int) -> int:
        return (v * GAINS[self.n]) >> 63

    def polar(self, x: int, y: int) -> tuple[int, int]:
        a = 0
        if x < 0:
            x, y, a = -x, -y, TURN // 2
        for i in range(self.n):
            s = 1 if y >= 0 else -1
            x, y, a = x + s * (y >> i), y - s * (x >> i), a + s * ANGLES[i]
        return self.scaled(x), a % TURN

    def cartesian(self, r: int, a: int) -> tuple[int, int]:
        x, y = self.scaled(r), 0
        if TURN // 4 <= a < 3 * TURN // 4:
            a, x = (a + TURN // 2) % TURN, -x
        if a >= TURN // 2:
            a -= TURN
        for i in range(self.n):
            s = 1 if a >= 0 else -1
            x, y, a = x - s * (y >> i), y + s * (x >> i), a - s * ANGLES[i]
        return x, y

    def amul(self, a: int, b: int) -> int:
        return (keep(a, self.k) * keep(b, self.k)) >> self.f

    def log(self, r: int) -> int:
        e = r.bit_length() - 1 - self.f
        m = r >> e if e >= 0 else r << -e
        x, y = 1 << self.f, 0
        for j in range(self.n):
            z = x + (x >> j)
            if z <= m:
                x, y = z, y + LOGARITHMS[self.f][j]
        return y + e * LOGARITHMS[self.f][0]

    def divide(self, num: int, dr: int, fd: int) -> int:
        a, b = num.bit_length() - 1, dr.bit_length() - 1
        y = num >> (a - self.f) if a >= self.f else num << (self.f - a)
        v = dr >> (b - self.f) if b >= self.f else dr << (self.f - b)
        z = 0
        for i in range(self.n):
            s = 1 if y >= 0 else -1
            y, z = y - s * (v >> i), z + s * ((1 << self.f) >> i)
        shift = a - b + fd - self.f + self.ts
        if self.ts > 0 and shift > 3:
            return 1 << (self.f + 4)
        return z << shift if shift >= 0 else z >> -shift

    def escaped(self, r: int) -> bool:
        return 16 * r > (32 if self.d == 2 else 24 if self.d <= 8 else 19) << self.f

    def core(self, w: tuple, c: tuple, dr: int, fd: int, last: bool) -> tuple:
        rho, phi = self.polar(w[0], w[1])
        r, theta = self.polar(w[2], rho)
        if self.escaped(r) or last:
            return True, r, w, dr, fd
        p, s, n = None, r, self.d - 1
        while n:
            if n & 1:
                p = s if p is None else self.amul(p, s)
            n >>= 1
            if n:
                s = self.amul(s, s)
        dr = self.d * ((keep(p, self.k) * keep(dr, self.k)) >> self.f) + (1 << fd if fd >= 0 else 0)
        if self.slide:
            over = max(dr.bit_length() - 64, 0)
            dr, fd = dr >> over, fd - over
        dr = min(dr, TURN - 1)
        z, q = self.cartesian(self.amul(p, r), theta * self.d % TURN)
        x, y = self.cartesian(q, phi * self.d % TURN)
        return False, r, (x + c[0], y + c[1], z + c[2]), dr, fd

    def evaluate(self, c: tuple) -> tuple:
        w, dr, fd, index = c, 1 << 32, 32, 0
        for n in range(self.i):
            hold, r, w, dr, fd = self.core(w, c, dr, fd, n == self.i - 1)
            if hold:
                break
            index += 1
        dst = 0
        if r > 1 << self.f and (l := self.log(r)) > 0:
            num = (keep(l, self.k) * keep(r, self.k)) >> (self.f + 1)
            dst = self.divide(num, dr, fd) if num else 0
        return index, r, dr, fd, dst

    def march(self, s: tuple, rd: tuple, b: int, most: int) -> tuple:
        t, eps = 0, 1
        for n in range(most):
            p = tuple(s[a] + ((t * rd[a]) >> (57 + self.ts)) for a in range(3))
            index, _, _, _, dst = self.evaluate(p)
            if n == 0:
                eps = max(1, dst >> b)
            t += dst
            if dst <= eps:
                return "hit", n + 1, index, t
            if t > 1 << (self.f + 3):
                return "miss", n + 1, index, t
        return "limit", most, index, t


STEPS = bytes.fromhex(
    "05070c181048171e5a162e6e163f83154d95145da9146ebe1a7cba218bb7289bb42ea9b035b8ad3cc8aa59cb9d7ace8f"
    "9bd282b8d575d9d867fadc5af6c750f3b146f09b3cec8632e97028e65a1ee9723eee8c61f2a784f6bfa4fadac7fff5eb")
INDEX = bytes.fromhex(
    "05070c18104817235f163779154c931460ad1775bc1f88b8289cb331b0af3ac3aa5ccb9c86cf8aacd37ad6d869f9d758"
    "f5bb4bf09f3dec8230e76623e96d37ee8f64f4b191f9d3befff5eb")


def draw(words: list[int], width: int, height: int) -> bytes:
    """A picture from 27 words, laid out as docs/registers.md says."""

    def bits(word: int, msb: int, lsb: int) -> int:
        return words[word] >> lsb & ((1 << (msb - lsb + 1)) - 1)

    def sign(value: int, width: int) -> int:
        return value - (1 << width) if value >> (width - 1) else value

    def clamp(value: int, low: int, high: int) -> int:
        return min(max(value, low), high)

    n, kept = clamp(bits(0, 14, 8), 8, 64), clamp(bits(0, 22, 16), 0, 64)
    kept = max(kept, 8) if kept else min(64, max(17, n + 4))
    m = Model(64 if bits(0, 0, 0) else 57, n, kept, clamp(bits(0, 28, 24), 2, 16), not bits(0, 1, 1),
              clamp(bits(1, 29, 24), 0, 60), clamp(bits(1, 6, 0), 1, 64))
    b, most = clamp(bits(1, 12, 8), 4, 16), clamp(bits(1, 23, 16), 1, 200)
    s = []
    for axis in range(3):
        code = sign(bits(2, 8 * axis + 7, 8 * axis) << 64 | words[3 + 2 * axis] << 32 | words[4 + 2 * axis], 72)
        s.append(clamp(code, -4 << 64, 4 << 64) >> (64 - m.f))
    basis = [sign(bits(9 + 2 * i, 26, 0) << 32 | words[10 + 2 * i], 59) for i in range(9)]
    forward, right, up = basis[:3], basis[3:6], basis[6:]
    picture = bytearray()
    for j in range(height):
        for i in range(width):
            u, v, f = 2 * i + 1 - width, height - 1 - 2 * j, 2 * height
            if bits(0, 3, 3):
                u = u * height // width if u >= 0 else -(-u * height // width)
            q = [(u * right[a] + v * up[a] + f * forward[a]) >> 12 for a in range(3)]
            length = isqrt(sum(a * a for a in q))
            rd = [((abs(a) << 57) // length) * (1 if a >= 0 else -1) if length else 0 for a in q]
            outcome, steps, index, _ = m.march(tuple(s), tuple(rd), b, most)
            table, entry = (INDEX, 1 + (index - 1) % 24 if index else 1) if bits(0, 2, 2) else (
                STEPS, min(31, max(1, steps >> 1)))
            entry = 0 if outcome == "miss" else entry
            picture += table[3 * entry:3 * entry + 3]
    return bytes(picture)


def golden(path: Path) -> None:
    for line in path.read_text().splitlines():
        if line.startswith("#"):
            print(line)
            continue
        size, words, _, why = line.split("\t")
        picture = draw([int(word, 16) for word in words.split()], *map(int, size.split("x")))
        print(size, words, format(zlib.crc32(picture), "08X"), why, sep="\t", flush=True)


def signed(text: str) -> int:
    value = int(text, 16)
    return value - (1 << 4 * len(text)) if value >> (4 * len(text) - 1) else value


def hexed(value: int) -> str:
    return format(value & ((1 << 72) - 1), "018x")


WIDE = "f N k d slide ts I x y z rdx rdy rdz b most outcome steps last_k t r dr fd dst".split()


def wide_row(given: dict[str, str]) -> dict[str, str]:
    number = {name: int(given[name]) for name in "f N k d slide ts I b most".split()}
    m = Model(number["f"], number["N"], number["k"], number["d"], bool(number["slide"]), number["ts"], number["I"])
    c = tuple(signed(given[a]) >> (64 - m.f) for a in "xyz")
    rd = tuple(signed(given["rd" + a]) for a in "xyz")
    _, r, dr, fd, dst = m.evaluate(c)
    outcome, steps, index, t = m.march(c, rd, number["b"], number["most"])
    return given | dict(outcome=outcome, steps=str(steps), last_k=str(index), t=hexed(t), r=hexed(r),
                        dr=format(dr, "016x"), fd=str(fd), dst=hexed(dst))


def approach(rng: random.Random, bits: int) -> tuple[list[int], list[int]]:
    """A point some 2^-bits before a surface, in Q8.64, and a ray (Q1.57) that goes on towards it."""
    exact = Model(64, 64, 64)
    while True:
        start = [rng.randrange(-3 << 64, 3 << 64) for _ in range(3)]
        aim = [rng.randrange(-(3 << 62), 3 << 62) - a for a in start]
        length = isqrt(sum(a * a for a in aim))
        ray = [(a << 57) // length for a in aim]
        t = 0
        for _ in range(150):
            point = [a + ((t * r) >> 57) for a, r in zip(start, ray)]
            dst = exact.evaluate(tuple(point))[-1]
            if 0 < dst < 1 << (64 - bits):
                return point, ray
            if dst == 0 or t > 8 << 64:
                break
            t += dst


def wide() -> None:
    rng = random.Random(3)
    print("\t".join(WIDE))
    for _ in range(100):
        n = rng.choice([8, 9, 16, 24, 31, 32, 33, 48, 57, 58, 60, 63, 64])
        bits = rng.choice([0, 1, 5, 12, 25, 40, 50, 55])
        point, ray = approach(rng, bits)
        given = dict(f=rng.choice([57, 64, 64]), N=n, k=rng.choice([min(64, max(17, n + 4)), 64, rng.randint(8, 64)]),
                     d=rng.choice([8, 8, 8, rng.randint(2, 16)]), slide=rng.randint(0, 1),
                     ts=rng.choice([0, bits, max(bits - 3, 0), min(bits + 5, 60)]),
                     I=rng.choice([25, 25, 25, 1, 2, 40, 64]), b=rng.choice([12, 12, 4, 16]),
                     most=rng.choice([200, 60, 60, 1]))
        given = {name: str(value) for name, value in given.items()}
        given |= {"xyz"[a]: hexed(point[a]) for a in range(3)}
        given |= {"rd" + "xyz"[a]: hexed(ray[a]) for a in range(3)}
        done = wide_row(given)
        print("\t".join(done[name] for name in WIDE))


def block(name: str, v: dict[str, str]) -> dict[str, str]:
    """What a row of a block's vectors must hold, from its inputs; N stands in the file's name."""
    what, n = name.split("_N")
    m = Model(57, int(n), int(v.get("k", 64)), int(v.get("d", 8)), v.get("slide") == "1", int(v.get("ts", 0)))
    word = lambda a: format(a % TURN, "016x")
    if what == "amul":
        return dict(product=word(m.amul(signed(v["a"]), signed(v["b"]))))
    if what == "divide":
        return dict(quot=word(m.divide(int(v["num"], 16), int(v["dr"], 16), int(v["fd"]))))
    if what == "ln":
        return dict(ln_r=word(m.log(signed(v["r"]))))
    if what == "rotation":
        return dict(zip(("r_cos", "r_sin"), map(word, m.cartesian(signed(v["r"]), int(v["angle"], 16)))))
    if what == "vectoring":
        return dict(zip(("mag", "angle"), map(word, m.polar(signed(v["x"]), signed(v["y"])))))
    if what == "iteration":
        w, c = (tuple(signed(v[p + a]) for a in "xyz") for p in ("", "c"))
        hold, r, w, dr, fd = m.core(w, c, int(v["dr"], 16), int(v["fd"]), False)
        return dict(hold=str(int(hold)), r=word(r), x1=word(w[0]), y1=word(w[1]), z1=word(w[2]), dr1=word(dr), fd1=str(fd))
    index, r, dr, fd, dst = m.evaluate(tuple(signed(v["c" + a]) for a in "xyz"))
    return dict(last_k=str(index), r=word(r), dr=word(dr), fd=str(fd), dst=word(dst))


def check(folder: Path) -> int:
    rows = wrong = 0
    for path in sorted(folder.glob("*_N*.tsv")) + [folder / "wide.tsv"]:
        lines = [line.split("\t") for line in path.read_text().splitlines()]
        for number, line in enumerate(lines[1:], 2):
            row = dict(zip(lines[0], line))
            expected = wide_row(dict(row)) if path.stem == "wide" else block(path.stem, row)
            rows += 1
            if any(row[name] != value for name, value in expected.items()):
                wrong += 1
                print(f"{path.name}:{number}: {expected}")
    print(f"{rows} rows, {wrong} wrong")
    return wrong != 0


if __name__ == "__main__":
    if sys.argv[1:] == ["wide"]:
        wide()
    elif sys.argv[1] == "golden":
        golden(Path(sys.argv[2]))
    elif sys.argv[1] == "draw":
        size = tuple(map(int, sys.argv[2].split("x")))
        sys.stdout.buffer.write(b"P6 %d %d 255\n" % size + draw([int(w, 16) for w in sys.argv[3:]], *size))
    else:
        sys.exit(check(Path(sys.argv[2])))
