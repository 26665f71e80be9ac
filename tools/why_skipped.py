#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints why tests were skipped, which ctest does not, and then ctest's summary again.

Usage: why_skipped.py BUILD OUTPUT    OUTPUT is the output of ctest. Prints nothing if no test was skipped.
"""

import re
import sys
from pathlib import Path

# GoogleTest and our scripts print these texts before they skip a test.
REASONS = (
    re.compile(r": Skipped\n(?P<reason>(?:(?!\[).+\n)+)"),
    re.compile(r"skipped: (?P<reason>.+)\n"),
)


def reason_of(output: str) -> str:
    for pattern in REASONS:
        if match := pattern.search(output):
            return " ".join(match["reason"].split())
    return "it does not say why"


def main() -> int:
    build, printed = Path(sys.argv[1]), Path(sys.argv[2]).read_text(errors="replace")
    log = (build / "Testing/Temporary/LastTest.log").read_text(errors="replace")
    outputs = dict(re.findall(r"^\d+/\d+ Test: (.+)\n((?:.*\n)*?)<end of output>", log, re.M))
    skipped = re.findall(r"^\s*\d+ - (.+) \(Skipped\)$", printed, re.M)
    if not skipped:
        return 0
    print("\n== why tests were skipped")
    for name in skipped:
        print(f"{name}: {reason_of(outputs.get(name, ''))}")
    summary = printed.rfind("\n", 0, printed.find("tests passed"))
    print(printed[summary:].rstrip())
    return 0


if __name__ == "__main__":
    sys.exit(main())
