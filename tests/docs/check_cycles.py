#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Holds the tables of docs/cycles.md to what cycle_tables prints.

Usage: check_cycles.py [--write] CYCLE_TABLES [ACCELERATOR...]; without names every section.
"""

import argparse
import re
import subprocess
import sys
from pathlib import Path

PAGE = Path(__file__).resolve().parents[2] / "docs/cycles.md"
SECTION = r"(<!-- begin {0} -->\n)(.*?)(<!-- end {0} -->)"


def table(program: Path, accelerator: str) -> str:
    command = [program, "--accelerator", accelerator]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--write", action="store_true", help="write the sections again")
    parser.add_argument("program", type=Path)
    parser.add_argument("accelerator", nargs="*")
    arguments = parser.parse_args()
    present = PAGE.read_text()
    text = present
    missing = False
    for name in arguments.accelerator or re.findall(r"<!-- begin (\w+) -->", present):
        wanted = table(arguments.program, name)
        pattern = re.compile(SECTION.format(name), re.DOTALL)
        missing |= not pattern.search(text)
        text = pattern.sub(lambda found: found[1] + wanted + found[3], text)
        if text != present and not arguments.write:
            print(f"{PAGE.name}: the section {name} is stale; {Path(__file__).name} --write")
    if missing:
        print(f"{PAGE.name}: the markers of a section are missing")
    if arguments.write:
        PAGE.write_text(text)
        return 0
    return 1 if missing or text != present else 0


if __name__ == "__main__":
    sys.exit(main())
