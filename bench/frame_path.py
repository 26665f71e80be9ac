#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Question: what does a frame cost the processor, done in Python as the source's script does it?

Split at the commas and equals signs, float(), scale, pack with shifts, store to a mapped page. The
frames are those of frame_path.cpp. It checks no more than that every key is there.
"""
import io
import json
import mmap
import struct
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from statistics import median

KEYS = frozenset("FX FY FZ RX RY RZ UX UY UZ ZM LX LY LZ R G B OBJ".split())
SCENES = {"sphere": 0, "cube": 1, "infinite_cube": 2, "tunnel": 3}
PAGE_BYTES = 4096


def words(line: bytes, code: Callable[[float], int] = int) -> tuple[int, ...] | None:
    """The eight words of a frame; None for anything else. The source's script cuts codes off, with
    `int`; the service rounds them, like `round`."""
    values = dict(pair.split("=") for pair in line.decode("ascii").strip().split(","))
    if values.keys() != KEYS:
        return None

    def direction(key: str) -> int:
        return min(code(float(values[key]) * 131072), 131071) & 0x3FFFF

    def light(key: str) -> int:
        return code(float(values[key]) * 8) & 0x3FF

    def colour(key: str) -> int:
        return min(code(float(values[key]) * 1024), 1023)

    def vector(name: str, channel: str) -> tuple[int, int]:
        x, y, z = direction(name + "X"), direction(name + "Y"), direction(name + "Z")
        return x << 14 | y >> 4, (y & 0xF) << 28 | z << 10 | colour(channel)

    return (SCENES[values["OBJ"]] << 30 | light("LX") << 20 | light("LY") << 10 | light("LZ"),
            code(float(values["ZM"]) * 16777216),
            *vector("F", "R"), *vector("R", "G"), *vector("U", "B"))


def apply(line: bytes, page: mmap.mmap) -> None:
    """One frame to the page; native order, so that each word is one store."""
    packed = words(line)
    if packed is not None:
        struct.pack_into("8I", page, 0, *packed)


def read_frames() -> list[bytes]:
    text = Path(__file__).with_name("frames.txt").read_bytes()
    return [line + b"\r\n" for line in text.splitlines() if not line.startswith(b"#")]


def main() -> None:
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 500
    frames = read_frames()
    stream = b"".join(frames)
    times = []
    with tempfile.TemporaryFile() as file:
        file.truncate(PAGE_BYTES)
        page = mmap.mmap(file.fileno(), PAGE_BYTES)
        for _ in range(rounds):
            port = io.BufferedReader(io.BytesIO(stream))  # type: ignore[arg-type]
            begin = time.thread_time_ns()
            while line := port.readline():
                apply(line, page)
            times.append((time.thread_time_ns() - begin) / len(frames))
    print(json.dumps({"median_ns": median(times), "min_ns": min(times), "frames": len(frames)}))


if __name__ == "__main__":
    main()
