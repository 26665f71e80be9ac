#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the measurements of this folder once and prints one table a section.

    bench/run.py --build DIR [--only SECTION]... [--quick] [--json FILE]

A section is a file: NAME_section.py, whose rows() measures and says what it is compared with.
"""
import argparse
import json
from collections.abc import Callable
from dataclasses import asdict
from pathlib import Path
from typing import Any

import board_section
import command_section
import engine_section
import hosts_section
import terminal_section
from report import Row, load, print_rows, processor

SECTIONS: dict[str, Callable[[Path, bool], list[Row]]] = {
    "engine": engine_section.rows,
    "command": command_section.rows,
    "terminal": terminal_section.rows,
    "hosts": hosts_section.rows,
    "board": board_section.rows,
}


def main() -> None:
    parser = argparse.ArgumentParser(description="runs every measurement once")
    parser.add_argument("--build", type=Path, required=True, help="build folder, preset release")
    parser.add_argument("--only", action="append", choices=SECTIONS,
                        help="this section; may be given more than once")
    parser.add_argument("--quick", action="store_true", help="fewer and shorter runs")
    parser.add_argument("--json", type=Path, help="also write the rows here")
    options = parser.parse_args()

    report: dict[str, Any] = {"processor": processor(), "quick": options.quick,
                              "load_before": load()}
    print(f"{processor()}; load before {load()}")
    print("ratio above 1: better than what it is compared with; wanted: the least ratio")
    rows: list[dict[str, Any]] = []
    for name, measure in SECTIONS.items():
        if options.only and name not in options.only:
            continue
        found = measure(options.build.resolve(), options.quick)
        print(f"\n{name}")
        print_rows(found)
        rows += [{"section": name, **asdict(row), "ratio": row.ratio} for row in found]
    print(f"\nload after {load()}")
    if options.json:
        report |= {"load_after": load(), "rows": rows}
        options.json.write_text(json.dumps(report, indent=2) + "\n")


if __name__ == "__main__":
    main()
