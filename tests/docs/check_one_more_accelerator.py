#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares the files that docs/design.md lists for one more accelerator with those that name all
accelerators there are.

Usage: check_one_more_accelerator.py. The list is every path in backticks in the section "One more
accelerator" that names no NAME.
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]
SKIPPED = {"build", "out", ".git"}


def accelerators() -> list[str]:
    return sorted(path.stem for path in (ROOT / "protocol" / "accelerators").glob("*.hpp"))


def files_that_name_all() -> set[str]:
    words = [re.compile(rf"\b{name}\b") for name in accelerators()]
    found = set()
    for path in ROOT.rglob("*"):
        inside = path.relative_to(ROOT)
        if inside.parts[0] in SKIPPED or not path.is_file():
            continue
        text = path.read_text(errors="replace")
        if all(word.search(text) for word in words):
            found.add(str(inside))
    return found


def listed_files() -> set[str]:
    page = (ROOT / "docs" / "design.md").read_text()
    section = page.split("\n## One more accelerator\n")[1].split("\n## ")[0]
    paths = re.findall(r"`([\w./-]+)`", section)
    return {path for path in paths if "NAME" not in path and (ROOT / path).is_file()}


def main() -> int:
    named, listed = files_that_name_all(), listed_files()
    for path in sorted(named - listed):
        print(f"{path} names every accelerator and is not in the section 'One more accelerator'")
    for path in sorted(listed - named):
        print(f"{path} is in the section 'One more accelerator' and does not name every accelerator")
    return 1 if named != listed else 0


if __name__ == "__main__":
    sys.exit(main())
