#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs every measurement of this folder once and prints one table.

    bench/run.py --build DIR [--quick] [--json FILE]
"""
import argparse
import json
import os
import platform
import re
import subprocess
import sys
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
SOURCE = "the source's way in Python"
PYTHON_LOOP = [sys.executable, str(HERE / "serial_loop.py"), "{registers}", "{link}"]


@dataclass
class Row:
    question: str
    value: float
    unit: str
    other: str  # what it is compared with
    other_value: float
    more_is_better: bool = False

    @property
    def ratio(self) -> float | None:
        """Above 1: better than what it is compared with."""
        better, worse = self.other_value, self.value
        if self.more_is_better:
            better, worse = worse, better
        return better / worse if worse else None


def processor() -> str:
    info = Path("/proc/cpuinfo").read_text()
    found = re.search(r"^(?:model name|Processor)\s*:\s*(.+)$", info, re.MULTILINE)
    return f"{found[1] if found else platform.machine()}, {os.cpu_count()} processors"


def output(*command: str | Path) -> str:
    """What a measurement prints; its complaints go where ours go."""
    return subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, text=True,
                          check=True).stdout


def python_frame_ns(rounds: str) -> float:
    return float(json.loads(output(sys.executable, HERE / "frame_path.py", rounds))["median_ns"])


def frame_path(build: Path, quick: bool) -> list[Row]:
    rounds = "50" if quick else "500"
    python = [python_frame_ns(rounds)]
    report = json.loads(output(
        build / "bench_frame_path", "--benchmark_format=json", "--benchmark_repetitions=5",
        "--benchmark_enable_random_interleaving=true", "--benchmark_report_aggregates_only=true",
        f"--benchmark_min_time={0.02 if quick else 0.2}"))
    ns = {run["run_name"]: run["cpu_time"] for run in report["benchmarks"]
          if run["aggregate_name"] == "median"}
    python.append(python_frame_ns(rounds))
    source = SOURCE, min(python)  # before and after: its better one
    mixed = ns["frame/mixed"]
    return [
        Row("frame to registers", mixed, "ns", *source),
        Row("session: frame, check, read-back, reply", ns["session/mixed"], "ns", *source),
        Row("the same line again and again", ns["frame/one"], "ns", "64 different", mixed),
        Row("pairs in any order", ns["frame/any_order"], "ns", "table order", mixed),
        Row("in chunks of 16 bytes", ns["frame/chunks_of_16"], "ns", "whole line", mixed),
        Row("the eight stores alone", ns["stores"], "ns", "whole frame", mixed),
        Row("a number of 32 characters", ns["number/longest"], "ns", "of 4", ns["number/source"]),
        Row("answer to GET", ns["get"], "ns", "frame to registers", mixed),
    ]


def service(build: Path) -> list[str]:
    return [str(build / "raymarchd"), "--registers", "file:{registers}", "--serial", "pty:{link}",
            "--state", "none", "--control", "none", "--log-level", "warning"]


def latency(build: Path, quick: bool) -> list[Row]:
    echo = [str(build / "bench_echo_loop"), "{registers}", "{link}"]
    text = output(build / "bench_latency", "--frames", "300" if quick else "3000",
                  "--", "floor", *echo, "--", "service", *service(build),
                  "--", "python", *PYTHON_LOOP)
    found: dict[str, dict[str, float]] = {}
    for line in text.splitlines():
        name, *pairs = line.split()
        found[name] = {key: float(value) for key, value in (pair.split("=") for pair in pairs)}
    return [Row(f"last byte to register, {label}", found["service"][key], "us", other,
                found[name][key])
            for label, key in (("least", "min_us"), ("median", "median_us"),
                               ("99th percentile", "p99_us"))
            for name, other in (("python", SOURCE), ("floor", "echo loop"))]


def footprint(build: Path, quick: bool) -> list[Row]:
    seconds = "2" if quick else "10"
    ours, python = (json.loads(output(sys.executable, HERE / "footprint.py", "--seconds", seconds,
                                      *command)) for command in (service(build), PYTHON_LOOP))
    return [
        Row("resident memory", ours["resident_kb"], "kB", SOURCE, python["resident_kb"]),
        Row("proportional share of memory", ours["proportional_kb"], "kB", SOURCE,
            python["proportional_kb"]),
        Row(f"wake-ups in {seconds} idle seconds", ours["wake_ups"], "", SOURCE,
            python["wake_ups"]),
    ]


def encode_rate(build: Path, quick: bool, python_ns: float) -> list[Row]:
    text = output(sys.executable, HERE / "encode_rate.py", build / "raymarchctl",
                  "20000" if quick else "200000")
    if not text:
        return []
    rate = json.loads(text)
    if rate["answered"] != rate["lines"]:
        print(f"run: encode said OK to {rate['answered']} of {rate['lines']} lines, and ended with "
              f"{rate['status']}", file=sys.stderr)
    return [Row("raymarchctl encode", rate["frames_per_second"], "frames/s",
                SOURCE, 1e9 / python_ns, more_is_better=True)]


def load() -> str:
    return " ".join(f"{load:.2f}" for load in os.getloadavg())


def print_table(rows: list[Row], load_before: str) -> None:
    print(f"{processor()}; load before {load_before}, after {load()}")
    print("ratio above 1: better than what it is compared with\n")
    print(f"{'question':<42}{'value':>18}  {'compared with':<28}{'':>10}{'ratio':>9}")
    for row in rows:
        digits = 1 if row.unit in ("ns", "us") else 0
        ratio = "-" if row.ratio is None else f"{row.ratio:.2f}"
        print(f"{row.question:<42}{row.value:>9,.{digits}f} {row.unit:<8}  {row.other:<28}"
              f"{row.other_value:>10,.{digits}f}{ratio:>9}")


def main() -> None:
    parser = argparse.ArgumentParser(description="runs every measurement once")
    parser.add_argument("--build", type=Path, required=True, help="build folder, preset release")
    parser.add_argument("--quick", action="store_true", help="fewer and shorter runs")
    parser.add_argument("--json", type=Path, help="also write the rows here")
    options = parser.parse_args()
    build: Path = options.build.resolve()
    quick: bool = options.quick

    load_before = load()
    rows = frame_path(build, quick)
    rows += latency(build, quick)
    rows += footprint(build, quick)
    rows += encode_rate(build, quick, rows[0].other_value)
    print_table(rows, load_before)
    if options.json:
        report: dict[str, Any] = {"processor": processor(), "quick": quick,
                                  "load_before": load_before, "load_after": load(),
                                  "rows": [asdict(row) | {"ratio": row.ratio} for row in rows]}
        options.json.write_text(json.dumps(report, indent=2) + "\n")


if __name__ == "__main__":
    main()
