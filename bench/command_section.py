# SPDX-License-Identifier: MIT
"""The command path: the text of a frame to register words, and what other ways take for the same."""
import json
import sys
from pathlib import Path

from report import HERE, Row, output

SOURCE = "the source's way in Python"


def python_frame_ns(rounds: str) -> float:
    return float(json.loads(output(sys.executable, HERE / "frame_path.py", rounds))["median_ns"])


def medians(program: Path, repetitions: int, quick: bool) -> dict[str, float]:
    """Of processor time; the benchmarks take turns, so that all see the same machine."""
    report = json.loads(output(
        program, "--benchmark_format=json", f"--benchmark_repetitions={repetitions}",
        "--benchmark_enable_random_interleaving=true", "--benchmark_report_aggregates_only=true",
        f"--benchmark_min_time={0.02 if quick else 0.2}"))
    return {run["run_name"]: run["cpu_time"] for run in report["benchmarks"]
            if run["aggregate_name"] == "median"}


def text_to_words(build: Path, quick: bool, python: float) -> list[Row]:
    ns = medians(build / "bench_command_path", 5 if quick else 9, quick)
    ours = ns["original/raymarch"]
    shuffled, mixed = ns["original_shuffled/raymarch"], ns["mixed/raymarch"]
    return [
        Row("the original frame to words", ours, "ns", "sscanf, one call", ns["original/sscanf"]),
        Row("", ours, "ns", "sscanf, a call a pair", ns["original/sscanf_by_pair"]),
        Row("", ours, "ns", "std::from_chars", ns["original/from_chars"]),
        Row("", ours, "ns", "fast_float", ns["original/fast_float"]),
        Row("", ours, "ns", SOURCE, python),
        Row("its pairs in another order", shuffled, "ns", "table order", ours, wanted=0.5),
        Row("", shuffled, "ns", "sscanf, a call a pair", ns["original_shuffled/sscanf"]),
        Row("", shuffled, "ns", "std::from_chars", ns["original_shuffled/from_chars"]),
        Row("", shuffled, "ns", "fast_float", ns["original_shuffled/fast_float"]),
        Row("64 different frames to words", mixed, "ns", "sscanf, one call",
            ns["mixed/sscanf"]),
        Row("", mixed, "ns", "std::from_chars", ns["mixed/from_chars"]),
        Row("", mixed, "ns", "fast_float", ns["mixed/fast_float"]),
        Row("each in an order of its own", ns["mixed_shuffled/raymarch"], "ns", "table order",
            mixed),
    ]


def bytes_to_registers(build: Path, quick: bool, python: float) -> list[Row]:
    ns = medians(build / "bench_frame_path", 5, quick)
    mixed = ns["frame/mixed"]
    return [
        Row("bytes of a frame to registers", mixed, "ns", SOURCE, python),
        Row("session: frame, check, read-back, reply", ns["session/mixed"], "ns", SOURCE, python),
        Row("the same line again and again", ns["frame/one"], "ns", "64 different", mixed),
        Row("pairs in any order", ns["frame/any_order"], "ns", "table order", mixed),
        Row("in chunks of 16 bytes", ns["frame/chunks_of_16"], "ns", "whole line", mixed),
        Row("the eight stores alone", ns["stores"], "ns", "whole frame", mixed),
        Row("a number of 32 characters", ns["number/longest"], "ns", "of 4", ns["number/source"]),
        Row("answer to GET", ns["get"], "ns", "frame to registers", mixed),
    ]


def encode_rate(build: Path, quick: bool, python: float) -> list[Row]:
    text = output(sys.executable, HERE / "encode_rate.py", build / "raymarchctl",
                  "20000" if quick else "200000")
    if not text:
        return []
    rate = json.loads(text)
    if rate["answered"] != rate["lines"]:
        print(f"run: encode said OK to {rate['answered']} of {rate['lines']} lines, and ended with "
              f"{rate['status']}", file=sys.stderr)
    return [Row("raymarchctl encode", rate["frames_per_second"], "frames/s", SOURCE, 1e9 / python,
                more_is_better=True)]


def rows(build: Path, quick: bool) -> list[Row]:
    rounds = "50" if quick else "500"
    python = python_frame_ns(rounds)
    python = min(python, python_frame_ns(rounds))  # its better one
    return (text_to_words(build, quick, python) + bytes_to_registers(build, quick, python) +
            encode_rate(build, quick, python))
