#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Why this file exists: C++ tests read no gzip. It turns the hardware's frames in
tests/data/fractal/*.pgm.gz into rows.tsv: the CRC-32 of every row of greys, one byte a pixel.

    fractal_rows.py make     writes rows.tsv
    fractal_rows.py check    exits 1 where rows.tsv is not what make would write
"""
import gzip
import pathlib
import sys
import zlib

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "data" / "fractal"
TABLE = FOLDER / "rows.tsv"


def rows_of(path):
    magic, size, deepest, pixels = gzip.decompress(path.read_bytes()).split(b"\n", 3)
    width, height = map(int, size.split())
    assert (magic, deepest, len(pixels)) == (b"P5", b"15", width * height), path
    return [zlib.crc32(pixels[y * width:(y + 1) * width]) for y in range(height)]


def table():
    lines = ["# made by tests/model/fractal_rows.py: file<TAB>CRC-32 of each row, from the top"]
    for path in sorted(FOLDER.glob("*.pgm.gz")):
        lines.append(path.stem + "\t" + " ".join(f"{crc:08x}" for crc in rows_of(path)))
    return "\n".join(lines) + "\n"


def main():
    match sys.argv[1:]:
        case ["make"]:
            TABLE.write_text(table())
        case ["check"]:
            if TABLE.read_text() != table():
                sys.exit(f"{TABLE} is not what its pictures say")
        case _:
            sys.exit(__doc__)


if __name__ == "__main__":
    main()
