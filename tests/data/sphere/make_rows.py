#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes rows.tsv from whole pictures: the CRC-32 of every row as it is shown, red, green, blue.

Usage: make_rows.py PICTURE... > rows.tsv, each .pgm (hardware, 16 shades) or .tga (prototype),
plain or gzipped; a column is named after its file."""

import gzip
import sys
import zlib
from pathlib import Path

WIDTH, HEIGHT = 640, 480


def rows(path: Path) -> list[bytes]:
    data = path.read_bytes()
    if path.suffix == ".gz":
        data = gzip.decompress(data)
    if data[:2] == b"P5":
        values = data[-WIDTH * HEIGHT :]
        shown = b"".join(bytes((17 * v, 17 * v, 0)) for v in values)
    else:
        pixels = data[18:]
        shown = b"".join(pixels[i : i + 3][::-1] for i in range(0, len(pixels), 3))
    assert len(shown) == 3 * WIDTH * HEIGHT, path
    return [shown[3 * WIDTH * y : 3 * WIDTH * (y + 1)] for y in range(HEIGHT)]


def main() -> None:
    paths = [Path(name) for name in sys.argv[1:]]
    columns = [rows(path) for path in paths]
    print("# y", *(path.name.split(".")[0] for path in paths), sep="\t")
    for y in range(HEIGHT):
        print(y, *(f"{zlib.crc32(column[y]):08x}" for column in columns), sep="\t")


if __name__ == "__main__":
    main()
