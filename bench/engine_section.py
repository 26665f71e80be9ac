# SPDX-License-Identifier: MIT
"""The engines: the marcher beside what it is compared with, the other accelerators beside their
scalar models. A model draws on one thread, a kernel on two unless a row says otherwise."""
import json
import re
import subprocess
from pathlib import Path

from report import Row, output

# What each view is to reach, at least: over the student's loop, over the model, over floats.
MARCHER = {
    "sphere": (130, 200),
    "cube": (130, 170),
    "lattice": (150, 80),
    "tunnel": (130, 60),
}
FLOAT_WANTED = 1 / 1.3  # what exactness may cost

Key = tuple[str, int, str, str, int]  # view, width, engine, isa, threads


def timed(build: Path, seconds: float, sizes: list[str], *more: str) -> dict[Key, float]:
    """Medians in milliseconds, all engines in turns."""
    lines = output(build / "bench_engine", "--seconds", str(seconds), "--sizes", *sizes, *more)
    rows = [json.loads(line) for line in lines.splitlines()]
    return {(r["view"], r["width"], r["engine"], r["isa"], r["threads"]): r["median_ms"] for r in rows}


def marcher(build: Path, quick: bool) -> list[Row]:
    ms = timed(build, 1 if quick else 8, ["640x480"], "--views", *MARCHER)
    isas = [isa for isa in ("avx512", "avx2", "sse4", "neon")
            if ("sphere", 640, "kernel", isa, 2) in ms]
    rows = []
    for view, (over_student, over_model) in MARCHER.items():
        def of(engine: str, isa: str, threads: int) -> float:
            return ms[view, 640, engine, isa, threads]
        for isa in isas:
            ours = of("kernel", isa, 2)
            best = isa == isas[0]
            rows += [
                Row(f"{view}, {isa}", ours, "ms", "student's loop, -O2", of("student -O2", "scalar", 1),
                    wanted=over_student if best else None),
                Row("", ours, "ms", "student's, -O3 native",
                    of("student -O3 -march=native", "native", 1)),
                Row("", ours, "ms", "the model", of("model", "scalar", 1),
                    wanted=over_model if best else None),
                Row("", ours, "ms", "floats, without the bits", of("float", isa, 2),
                    wanted=FLOAT_WANTED if best else None),
                Row("", ours, "ms", "one thread", of("kernel", isa, 1),
                    wanted=1.9 if best else None),
            ]
    return rows


def pixels(build: Path, quick: bool) -> list[Row]:
    """From 640x480 to 1920x1080, by the pixel: 1 is linear."""
    small, large = 640 * 480, 1920 * 1080
    ms = timed(build, 1 if quick else 5, ["640x480", "1920x1080"], "--views", *MARCHER,
               "--engines", "kernel")
    isa = max((key for key in ms), key=lambda key: ["sse4", "neon", "avx2", "avx512"].index(key[3]))[3]
    return [Row(f"{view}: 1920x1080, a pixel", ms[view, 1920, "kernel", isa, 2] * 1e6 / large, "ns",
                "640x480, a pixel", ms[view, 640, "kernel", isa, 2] * 1e6 / small, wanted=0.95)
            for view in MARCHER]


def rendered(build: Path, repeat: int, *more: str) -> float:
    """Median milliseconds of raymarchctl render."""
    done = subprocess.run([build / "raymarchctl", "render", "-o", "-", "--repeat", str(repeat), *more],
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=True)
    found = re.search(r"median ([\d.]+) ms", done.stderr)
    if not found:
        raise RuntimeError(f"no median in: {done.stderr}")
    return float(found[1])


def counted(build: Path, key: str, *view: str) -> float:
    """A value that raymarchctl cycles prints."""
    found = re.search(rf"^{key}\s+([\d.]+)", output(build / "raymarchctl", "cycles", *view), re.MULTILINE)
    if not found:
        raise RuntimeError(f"no {key} of {view}")
    return float(found[1])


# Accelerator, view, size, the least ratio.
OTHERS: list[tuple[str, list[str], str | None, float | None]] = [
    ("fractal", ["--preset", "start"], None, None),
    ("fractal", ["--preset", "cubes"], None, None),
    ("fractal", ["--preset", "cube"], None, None),
    ("fractal", ["--preset", "maze"], None, None),
    ("sphere", ["--preset", "core"], None, None),
    ("sphere", ["--preset", "trio"], None, None),
    ("mandelbulb", ["--set", "N=57"], "320x180", 16),
    ("mandelbulb", ["--preset", "deep26"], "160x90", None),
    ("whitted", ["--preset", "image1"], None, None),
    ("whitted", ["--preset", "fourteen"], None, None),
]


def others(build: Path, quick: bool) -> list[Row]:
    rows = []
    for accelerator, what, size, wanted in OTHERS:
        view = ["--accelerator", accelerator, *what, *(["--size", size] if size else [])]
        kernel, model = [], []
        for _ in range(1 if quick else 3):  # in turns
            model.append(rendered(build, 1, *view, "--reference", "--threads", "1"))
            kernel.append(rendered(build, 3 if quick else 11, *view, "--threads", "2"))
        ours = sorted(kernel)[len(kernel) // 2]
        name = f"{accelerator} {what[-1]}{' ' + size if size else ''}"
        rows.append(Row(name, ours, "ms", "the model", sorted(model)[len(model) // 2], wanted=wanted))
        if not size:
            rows.append(Row("", 1000 / ours, "/s", "the hardware, by its cycles",
                            counted(build, "fps", *view), more_is_better=True))
    return rows


def rays(build: Path, quick: bool) -> list[Row]:
    """The ray tracer: eight spheres, four planes, three reflections, nine samples a pixel."""
    lines = output(build / "bench_whitted", "--seconds", str(4 if quick else 20))
    found = [json.loads(line) for line in lines.splitlines()]
    rate = {(r["engine"], r["isa"], r["threads"]): r["rays_per_second"] / 1e6 for r in found}
    rows = []
    for isa in ("avx512", "avx2", "sse4", "neon"):
        ours = rate.get(("kernel", isa, 2))
        if not ours:
            continue
        best = not rows
        rows += [
            Row(f"whitted, 9 rays a pixel, {isa}: rays", ours, "M/s", "the source's hardware", 0.55,
                more_is_better=True, wanted=400 / 0.55 if best else None),
            Row("", ours, "M/s", "scalar floats, -O2", rate["float -O2", "scalar", 1], more_is_better=True),
            Row("", ours, "M/s", "the model", rate["model", "scalar", 1], more_is_better=True),
            Row("", ours, "M/s", "one thread", rate["kernel", isa, 1], more_is_better=True,
                wanted=1.9 if best else None),
        ]
    return rows


def rows(build: Path, quick: bool) -> list[Row]:
    return marcher(build, quick) + pixels(build, quick) + others(build, quick) + rays(build, quick)
