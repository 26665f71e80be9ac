#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes what the fuzz targets begin with: FOLDER/TARGET/NAME.

Usage: seeds.py FOLDER. Lines and frames come from the tables in tests/data, the configuration from
systemd; captures, bitstreams, trees and state files are made here."""

import re
import struct
import sys
import zlib
from pathlib import Path

TESTS = Path(__file__).resolve().parents[1]
ESCAPES = {"r": "\r", "n": "\n", "t": "\t", "\\": "\\"}


def sent_bytes(text: str) -> bytes:
    """The column `send` of tests/data/*.tsv."""
    text = re.sub(r"\\\((\d+)\*(.*?)\)", lambda match: int(match[1]) * match[2], text)
    parts = re.split(r"\\(x[0-9A-Fa-f]{2}|.)", text)
    for at in range(1, len(parts), 2):
        escape = parts[at]
        parts[at] = chr(int(escape[1:], 16)) if escape[0] == "x" else ESCAPES.get(escape, escape)
    line = "".join(parts)
    return (line if line.endswith("\n") else line + "\n").encode("latin-1")


def table_lines() -> list[bytes]:
    lines = []
    for name in ("commands", "frames", "lines"):
        for row in (TESTS / f"data/{name}.tsv").read_text().splitlines():
            if row and not row.startswith("#"):
                lines.append(sent_bytes(row.split("\t")[0]))
    return lines


# A line of each other accelerator; the tables are of the marcher.
OTHERS = [
    b"ACCELERATOR fractal\nRANDOM\nSET SCENE=menger,DITHER=on\nWALK forward 3\nGET\n",
    b"ACCELERATOR sphere\nRANDOM\nGET\nSAVE\nRESET\nLOAD\n",
    b"ACCELERATOR mandelbulb\nPRESET whole\nSET N=57\nGET\nZOOM\n",
    b"ACCELERATOR whitted\nRANDOM\nGET\nWALK left 1\nACCELERATOR marcher\nRANDOM\n",
    b"ECHO on\nSET ZM\x7f\x7fZM=4\r\nANIMATE 3\nSTATUS\nREGS\n",
]


def capture(frames: list[bytes]) -> bytes:
    """The records only: the target puts the header before them."""
    return b"".join(struct.pack("<IIII", 0, 0, len(frame), len(frame)) + frame for frame in frames)


def captures() -> list[bytes]:
    addresses = bytes.fromhex("88665a0348b0111111111111")
    start = addresses + b"\0" + b"\xff" * 50
    row = addresses + b"\0" + struct.pack(">I", 7) + bytes(range(200))
    with_check = row + struct.pack("<I", zlib.crc32(row))
    tagged = row[:12] + bytes.fromhex("88a8006481000005") + row[12:]
    pictures = [b"P5\n# grey\n4 2\n255\n" + bytes(8), b"P6 2 2 15\n" + bytes(12)]
    return [capture([start, row]), capture([with_check, tagged]), *pictures]


def bitstream() -> list[int]:
    """Two frames, without a check sequence: so what is changed is looked at, not refused at once."""
    nop, command = 0x20000000, 0x30008001
    words = [0xFFFFFFFF, 0xBB, 0x11220044, 0xFFFFFFFF, 0xAA995566, nop, command, 7, nop]
    words += [0x30018001, 0x03727093, 0x30002001, 0, command, 1, nop, 0x30004000, 0x500000CA]
    words += range(202)
    words += [command, 2, 0x30002001, 9, 0x30014004, 0, 0, 0, 0]
    words += [command, 7, nop, command, 5, command, 13, nop, nop]
    return words


def bitstreams() -> list[bytes]:
    words = bitstream()
    data = struct.pack(f">{len(words)}I", *words)
    fields = zip(b"abcd", (b"top;Version=2020.1\0", b"7z020clg400\0", b"2025/06/01\0", b"12:34:56\0"))
    header = bytes.fromhex("00090ff00ff00ff00ff0000001")
    header += b"".join(bytes([letter]) + struct.pack(">H", len(text)) + text for letter, text in fields)
    # Structure of a tree: a node, a property of 4 bytes, its end, the end.
    tree = struct.pack(">I4xIIIIIII", 1, 3, 4, 0, 29, 4, 2, 9)
    return [struct.pack(f"<{len(words)}I", *words), header + b"e" + struct.pack(">I", len(data)) + data, tree]


def states() -> list[bytes]:
    frame = b"FX=0,FY=0,FZ=1,RX=1,RY=0,RZ=0,UX=0,UY=1,UZ=0,ZM=3,LX=3,LY=2,LZ=5,R=1,G=1,B=1,OBJ=sphere"
    return [b"last marcher " + frame + b"\nsaved marcher " + frame + b"\n", b"last sphere \n"]


def configurations() -> list[bytes]:
    shown = (TESTS.parent / "systemd/raymarchd.toml").read_bytes()
    settings = re.sub(rb"^#(?=[a-z_]+ = |\[)", b"", shown, flags=re.M)
    lines = b"[gpio_lines]\nlock = \"GPIO 17|'J8:3',active-low\"\nturn = \"/dev/gpiochip0:7,pull-up\"\n"
    values = [b"uio:/dev/uio0", b"file:/tmp/x", b"/dev/ttyPS0@115200", b"pty:/run/x", b"640x480", b"'a|b':3|x,no-pull"]
    return [settings, lines, *values]


def main() -> int:
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 64
    lines = table_lines()
    seeds = {
        "lines": lines,
        "frames": [line.rstrip(b"\r\n") for line in lines],
        "session": lines + OTHERS,
        "state_file": states(),
        "captures": captures(),
        "bitstreams": bitstreams(),
        "configuration": configurations(),
    }
    for target, contents in seeds.items():
        folder = Path(sys.argv[1]) / target
        folder.mkdir(parents=True, exist_ok=True)
        for number, content in enumerate(contents):
            (folder / f"{number:03}").write_bytes(content)
    return 0


if __name__ == "__main__":
    sys.exit(main())
