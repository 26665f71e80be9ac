#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Finds parametrised tests whose names or parameters say nothing to a reader.

Usage: check_test_names.py PROGRAM..., each a program of GoogleTest. An instance has a name, not a
number, and its parameter is printed as neither bytes nor an address.
"""

import re
import subprocess
import sys


def faults(listing: str) -> list[str]:
    """What is wrong with the output of --gtest_list_tests."""
    found = []
    suite = ""
    for line in listing.splitlines():
        if not line.startswith(" "):
            suite = line.split("#")[0].strip()
            continue
        name, _, parameter = line.strip().partition("#")
        full = suite + name.strip()
        if "byte object" in parameter:
            found.append(f"{full}: the parameter has no printer, so it is printed as bytes")
        if re.search(r"= \(?0x[0-9a-fA-F]{6,}", parameter):
            found.append(f"{full}: the parameter is printed as an address, another in every run")
        if re.search(r"/\d+$", name.strip()):
            found.append(f"{full}: the instance has a number; INSTANTIATE_TEST_SUITE_P takes names")
    return found


def main() -> int:
    programs = sys.argv[1:]
    if not programs:
        print(__doc__, file=sys.stderr)
        return 64
    found = []
    for program in programs:
        listing = subprocess.run([program, "--gtest_list_tests"], check=True, capture_output=True,
                                 text=True).stdout
        found += faults(listing)
    print("\n".join(found) or f"{len(programs)} programs, every instance has a name")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
