#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The frames of board_frames.cpp the way of the source's script: its reader loop, over bytes in memory.

    board_frames.py COUNT

First each frame of frames.txt, whose words it prints as the registers hold them; then COUNT frames
more, in turns, and prints nothing.
"""
import io
import mmap
import struct
import sys
from itertools import cycle, islice

from frame_path import PAGE_BYTES, apply, read_frames


def main() -> None:
    count = int(sys.argv[1])
    frames = read_frames()
    page = mmap.mmap(-1, PAGE_BYTES)
    for frame in frames:
        apply(frame, page)
        print(*(f"{word:08X}" for word in struct.unpack_from("8I", page)))
    sys.stdout.flush()
    with io.BufferedReader(io.BytesIO(b"".join(islice(cycle(frames), count)))) as port:
        while line := port.readline():
            apply(line, page)


if __name__ == "__main__":
    main()
