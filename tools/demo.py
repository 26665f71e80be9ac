#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Shows the main use: text through a terminal becomes pictures of the emulated accelerators.

It starts the service with an emulated register block and a pseudo-terminal, sends the frames that the
original user interface sends, prints the register words, and keeps one picture for each scene. Then it
switches to each of the other accelerators and keeps a picture of it. Each picture is compared with that
of `raymarchctl render`. At the end it draws a contact sheet.
"""

import argparse
import math
import shutil
import subprocess
import sys
import time
from pathlib import Path
from typing import NamedTuple


class View(NamedTuple):
    """The positions of the user interface's sliders for one picture."""

    name: str
    scene: str
    yaw: float
    pitch: float
    zoom: float
    light: tuple[float, float, float]
    colour: tuple[float, float, float]


VIEWS = (
    View("sphere", "sphere", 0, 0, 2, (3, 2, 5), (1, 1, 1)),
    View("cube", "cube", 35, 30, 1.6, (2, 5, 3), (0.9, 0.75, 0.2)),
    View("lattice", "infinite_cube", 11.31, 11.095, 2.598, (0.5, 1.5, 2), (0.4, 0.9, 0.6)),
    View("tunnel", "tunnel", 0, 0, 2, (0.25, 0.5, 2), (0.5, 0.7, 1)),
)


def frame(view: View) -> str:
    """Returns the frame as the user interface writes it, with three decimals and without CR LF."""
    yaw, pitch = math.radians(view.yaw), math.radians(view.pitch)
    forward = (math.cos(pitch) * math.sin(yaw), math.sin(pitch), math.cos(pitch) * math.cos(yaw))
    right = (math.cos(yaw), 0.0, -math.sin(yaw))
    up = (
        forward[1] * right[2] - forward[2] * right[1],
        forward[2] * right[0] - forward[0] * right[2],
        forward[0] * right[1] - forward[1] * right[0],
    )
    pairs = [
        f"{vector}{axis}={value:.3f}"
        for vector, values in (("F", forward), ("R", right), ("U", up))
        for axis, value in zip("XYZ", values)
    ]
    pairs.append(f"ZM={view.zoom:.2f}")
    pairs += [f"L{axis}={value:.3f}" for axis, value in zip("XYZ", view.light)]
    pairs += [f"{channel}={value:.3f}" for channel, value in zip("RGB", view.colour)]
    return ",".join(pairs) + f",OBJ={view.scene}"


class Other(NamedTuple):
    """A picture of another accelerator. Without a preset it has the defaults."""

    accelerator: str
    preset: str


OTHERS = (
    Other("fractal", "maze"),
    Other("sphere", "trio"),
    Other("whitted", "mirrors"),
    Other("mandelbulb", ""),  # a picture takes seconds; switching already draws the defaults
)


NEXT = """
Made in {out}/: four pictures of the marcher (sphere, cube, lattice, tunnel), one of each other
accelerator, and sheet.png with all of them. The programs are {build}/raymarchd and
{build}/raymarchctl.

What to try next:
    {build}/raymarchctl render --accelerator fractal --preset maze -o {out}/maze.png
    {build}/raymarchctl film --preset lattice --size 320x240 --steps 4 --frames 90 -o {out}/lattice.gif
    "Five minutes" in README.md starts the service and talks to it.
    ./dev test runs every test."""


class Service:
    """raymarchd with all its files in one folder."""

    def __init__(self, build: Path, out: Path) -> None:
        self.control = build / "raymarchctl"
        self.terminal = out / "tty"
        self.preview = out / "preview.png"
        self.process = subprocess.Popen(
            [
                build / "raymarchd",
                "--registers", "emulated",
                "--serial", f"pty:{self.terminal}",
                "--preview", str(self.preview),
                "--state", "none",
                "--control", "none",
            ]
        )

    def ask(self, *lines: str) -> list[str]:
        """Sends `lines` through the terminal and returns the replies."""
        result = subprocess.run(
            [self.control, "send", "--port", str(self.terminal), *lines],
            check=True, capture_output=True, text=True,
        )
        return result.stdout.splitlines()

    def frames(self) -> int:
        """Returns the number of frames that the accelerator has finished."""
        words = dict(word.split("=", 1) for word in self.ask("STATUS")[0].split() if "=" in word)
        return int(words["frames"])

    def wait_for_frames(self, count: int) -> None:
        """Waits until so many frames are finished; the preview is then written, too."""
        for _ in range(2400):
            if self.terminal.is_symlink() and self.frames() >= count:
                return
            if self.process.poll() is not None:
                sys.exit("raymarchd ended")
            time.sleep(0.05)
        sys.exit("the accelerator finished no frame in time")

    def stop(self) -> None:
        self.process.terminate()
        self.process.wait()


def draw(service: Service, view: View, out: Path) -> bool:
    """Sends one frame and keeps the picture. Returns whether render draws the same."""
    line = frame(view)
    before = service.frames()
    accepted, registers = service.ask(line, "REGS")
    if "changed=0" not in accepted.split():
        service.wait_for_frames(before + 1)
    picture = out / f"{view.name}.png"
    shutil.copyfile(service.preview, picture)

    print(f"{view.name}\n  sent  {line}\n  reply {accepted}\n  words {registers.removeprefix('OK ')}")
    return equals_rendered(service, picture, "--line", line)


def draw_other(service: Service, other: Other, out: Path) -> bool:
    """Switches to another accelerator and keeps its picture. Returns whether render draws the same."""
    lines = [f"ACCELERATOR {other.accelerator}"]
    replies = service.ask(*lines)
    service.wait_for_frames(1)
    arguments = ["--accelerator", other.accelerator]
    if other.preset:
        before = service.frames()
        lines.append(f"PRESET {other.preset}")
        replies += service.ask(lines[-1])
        service.wait_for_frames(before + 1)
        arguments += ["--preset", other.preset]
    name = f"{other.accelerator}_{other.preset}" if other.preset else other.accelerator
    picture = out / f"{name}.png"
    shutil.copyfile(service.preview, picture)
    print(name)
    for line, reply in zip(lines, replies):
        print(f"  sent  {line}\n  reply {reply}")
    return equals_rendered(service, picture, *arguments)


def equals_rendered(service: Service, picture: Path, *arguments: str) -> bool:
    check = picture.with_name("check.png")
    subprocess.run([service.control, "render", *arguments, "-o", check], check=True)
    same = check.read_bytes() == picture.read_bytes()
    check.unlink()
    print(f"  {picture}: {'identical to' if same else 'DIFFERS from'} raymarchctl render")
    return same


def draw_sheet(service: Service, out: Path) -> None:
    """Draws all accelerators on one contact sheet."""
    views = [f"marcher:{preset}" for preset in ("sphere", "cube", "lattice", "tunnel")]
    views += ["fractal:maze", "fractal:menger_crossing", "fractal:cubes_street", "sphere:trio"]
    views += ["whitted:mirrors", "whitted:plate", "whitted:image2_room", "mandelbulb"]
    sheet = out / "sheet.png"
    subprocess.run([service.control, "sheet", *views, "--columns", "4", "-o", sheet], check=True)
    print(f"all\n  {sheet}: a contact sheet, by raymarchctl sheet")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=Path, required=True, help="folder of the programs")
    parser.add_argument("--out", type=Path, required=True, help="folder for the pictures")
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    service = Service(arguments.build, arguments.out)
    try:
        service.wait_for_frames(1)
        same = [draw(service, view, arguments.out) for view in VIEWS]
        same += [draw_other(service, other, arguments.out) for other in OTHERS]
        draw_sheet(service, arguments.out)
    finally:
        service.stop()
    service.preview.unlink(missing_ok=True)
    if not all(same):
        return 1
    print(NEXT.format(out=arguments.out, build=arguments.build))
    return 0


if __name__ == "__main__":
    sys.exit(main())
