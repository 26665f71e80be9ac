# SPDX-License-Identifier: MIT
"""The terminal path: the service behind a pseudo-terminal, beside the source's script as a loop and
beside a loop that reads bytes and looks at nothing."""
import json
import sys
from pathlib import Path

from report import HERE, Row, output

PYTHON = "Python's reader loop"
PYTHON_LOOP = [sys.executable, str(HERE / "serial_loop.py"), "{registers}", "{link}"]


def service(build: Path) -> list[str]:
    return [str(build / "raymarchd"), "--registers", "file:{registers}", "--serial", "pty:{link}",
            "--state", "none", "--control", "none", "--log-level", "warning"]


def echo_loop(build: Path) -> list[str]:
    return [str(build / "bench_echo_loop"), "{registers}", "{link}"]


def latency(build: Path, quick: bool) -> list[Row]:
    text = output(build / "bench_latency", "--frames", "300" if quick else "3000",
                  "--", "floor", *echo_loop(build), "--", "service", *service(build),
                  "--", "python", *PYTHON_LOOP)
    found: dict[str, dict[str, float]] = {}
    for line in text.splitlines():
        name, *pairs = line.split()
        found[name] = {key: float(value) for key, value in (pair.split("=") for pair in pairs)}
    wanted = {("median_us", "floor"): 1 / 1.15}
    return [Row(f"last byte to register, {label}", found["service"][key], "us", other,
                found[name][key], wanted=wanted.get((key, name)))
            for label, key in (("least", "min_us"), ("median", "median_us"),
                               ("99th percentile", "p99_us"))
            for name, other in (("floor", "bare C loop"), ("python", PYTHON))]


def processor_time(build: Path, quick: bool) -> list[Row]:
    """The Python loop does not answer, so the like of it is the service that does not either."""
    words = ["--quick"] if quick else []
    for name, command in (("floor", echo_loop(build)), ("service", service(build)),
                          ("silent", [*service(build), "--replies", "none"]),
                          ("python", PYTHON_LOOP)):
        words += ["--", name, *command]
    found = json.loads(output(sys.executable, HERE / "processor_time.py", *words))
    return [Row(f"processor time a frame, {label}{answers}", found[name][key], "us", label_of_other,
                found[other][key], wanted=wanted if (name, other) == ("silent", "python") else None)
            for label, key, wanted in (("flat out", "flat_out_us", 20),
                                       ("68 a second", "paced_us", 5))
            for name, answers in (("silent", ""), ("service", ", with replies"))
            for other, label_of_other in (("floor", "bare C loop"), ("python", PYTHON))]


def footprint(build: Path, quick: bool) -> list[Row]:
    seconds = "2" if quick else "10"
    ours, python = (json.loads(output(sys.executable, HERE / "footprint.py", "--seconds", seconds,
                                      *command)) for command in (service(build), PYTHON_LOOP))
    return [
        Row("resident memory", ours["resident_kb"], "kB", PYTHON, python["resident_kb"]),
        Row("proportional share of memory", ours["proportional_kb"], "kB", PYTHON,
            python["proportional_kb"]),
        Row(f"wake-ups in {seconds} idle seconds", ours["wake_ups"], "", PYTHON,
            python["wake_ups"]),
    ]


def rows(build: Path, quick: bool) -> list[Row]:
    return processor_time(build, quick) + latency(build, quick) + footprint(build, quick)
