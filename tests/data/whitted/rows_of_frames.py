#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints what frames.tsv holds: the CRC-32 of every row of reference pictures (binary PPM, plain or gzip).

Usage: rows_of_frames.py NAME=PICTURE...
"""

import gzip
import sys
import zlib
from pathlib import Path


def rows(picture: Path) -> list[int]:
    data = picture.read_bytes()
    if picture.suffix == ".gz":
        data = gzip.decompress(data)
    magic, width, height, largest = data.split(maxsplit=4)[:4]
    assert magic == b"P6" and largest == b"255"
    row_bytes = 3 * int(width)
    pixels = data[-row_bytes * int(height) :]
    return [zlib.crc32(pixels[at : at + row_bytes]) for at in range(0, len(pixels), row_bytes)]


def main() -> None:
    print("frame\ty\tcrc32")
    for argument in sys.argv[1:]:
        name, _, picture = argument.partition("=")
        for y, crc in enumerate(rows(Path(picture))):
            print(f"{name}\t{y}\t{crc:08X}")


if __name__ == "__main__":
    main()
