# SPDX-License-Identifier: MIT
"""The board's processor: how many instructions a frame takes there, from its first byte to its last
word in the registers, counted in qemu-user for both programs. Counts, not times."""
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from statistics import median

from command_section import SOURCE
from frame_path import read_frames, words
from report import HERE, Row
from terminal_program import TerminalProgram, wait_until
from terminal_section import PYTHON, service

TREES = ("RAYMARCH_ARMHF_SYSROOT", "RAYMARCH_ARMHF_PYTHON")  # ./dev bench makes and exports them
WHOLE_FRAME, UART_FIFO = "1024", "16"
SAME_HASHES = ("-E", "PYTHONHASHSEED=0")  # the same dictionaries in each run


@dataclass
class Processor:
    """qemu-user with the plugin of count_instructions.cpp, which counts in a file."""
    qemu: str
    plugin: Path
    counter: Path

    def command(self, tree: str, program: str | Path, *arguments: str | Path) -> list[str]:
        command = [self.qemu, "-seed", "1", *SAME_HASHES, "-L", tree,
                   "-plugin", f"{self.plugin},counter={self.counter}", program, *arguments]
        return [str(word) for word in command]

    def instructions(self) -> int:
        return int(struct.unpack("Q", self.counter.read_bytes())[0])

    def run(self, command: list[str]) -> tuple[int, str]:
        """Its instructions, and what it prints."""
        self.counter.write_bytes(bytes(8))
        done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True, env={})
        return self.instructions(), done.stdout


def pages(code: Callable[[float], int]) -> list[tuple[int, ...]]:
    """The words of each frame, by this machine's Python."""
    found = [words(frame, code) for frame in read_frames()]
    return [page for page in found if page is not None]


def in_memory(processor: Processor, command: list[str], frames: int,
              code: Callable[[float], int]) -> float:
    """Instructions a frame. What is counted is frames and the program's end, which is in both runs
    and so not in their difference. Each run is made twice, and has to give the same number; and the
    words that it prints have to be those of the frames."""
    lines = [" ".join(f"{word:08X}" for word in page) for page in pages(code)]
    found = []
    for count in (frames, 2 * frames):
        runs = [processor.run([*command, str(count)]) for _ in range(2)]
        # Names of temporary files and times are other ones in each run: that is a few instructions.
        if abs(runs[0][0] - runs[1][0]) > count / 10 or runs[0][1] != runs[1][1]:
            sys.exit(f"board: two runs of {count} frames differ, {runs[0][0]} and {runs[1][0]} "
                     f"instructions: {command}")
        instructions, printed = runs[0]
        if printed.splitlines() != lines:
            sys.exit(f"board: wrong words: {command}")
        found.append(instructions)
    return (found[1] - found[0]) / frames


def asleep(program: TerminalProgram) -> bool:
    states = [task.read_text().rpartition(")")[2].split()[0]
              for task in program.process.glob("task/*/stat")]
    return all(state == "S" for state in states)


def wait_for_quiet(processor: Processor, program: TerminalProgram) -> int:
    """The count once the program waits for more: asleep at two looks, and nothing counted between
    them."""
    seen = -1

    def quiet() -> bool:
        nonlocal seen
        before, seen = seen, processor.instructions()
        time.sleep(0.002)
        return before == seen and asleep(program)

    wait_until(quiet, "the program to wait for more")
    return seen


def behind_terminal(processor: Processor, command: list[str], rounds: int,
                    code: Callable[[float], int]) -> float:
    """Instructions a frame outside the kernel, of a whole program, one frame at a time: from one
    wait for bytes to the next, all frames `rounds` times after once to warm up. The median: what
    falls between two waits by the clock is no frame's."""
    processor.counter.write_bytes(bytes(8))
    frames = read_frames()
    expected = [struct.pack("8I", *page) for page in pages(code)]
    counts = []
    with TerminalProgram(command) as program:
        before = wait_for_quiet(processor, program)
        for _ in range(rounds + 1):
            for frame, page in zip(frames, expected):
                program.write_some(frame)
                wait_until(lambda: program.registers.read_bytes()[:len(page)] == page,
                           f"the words of {frame.decode().strip()}")
                after = wait_for_quiet(processor, program)
                program.drain()
                counts.append(after - before)
                before = after
    return median(counts[len(frames):])


def missing(build: Path) -> str | None:
    """What keeps the section from being run."""
    if shutil.which("qemu-arm") is None:
        return "there is no qemu-arm (Debian: qemu-user) here"
    for tree in TREES:
        if not os.environ.get(tree):
            return f"{tree} names no armhf tree; ./dev bench makes it where mmdebstrap is installed"
    for file in programs(build):
        if not file.exists():
            return f"{file} has not been built"
    return None


def programs(build: Path) -> tuple[Path, ...]:
    board = build.parent / "armhf"
    return build / "libcount_instructions.so", board / "board_frames", board / "raymarchd"


def counted(build: Path, processor: Processor, quick: bool) -> list[Row]:
    sysroot, python_tree = (os.environ[tree] for tree in TREES)
    _, board_frames, raymarchd = programs(build)
    python = (python_tree, f"{python_tree}/usr/bin/python3", "-B")
    frames = (5 if quick else 50) * len(read_frames())
    whole, pieces = (in_memory(processor, processor.command(sysroot, board_frames, size), frames,
                               round) for size in (WHOLE_FRAME, UART_FIFO))
    source = in_memory(processor, processor.command(*python, HERE / "board_frames.py"), frames,
                       int)
    rounds = 1 if quick else 5
    program = behind_terminal(processor, processor.command(sysroot, *service(raymarchd.parent)),
                              rounds, round)
    loop = behind_terminal(
        processor, processor.command(*python, HERE / "serial_loop.py", "{registers}", "{link}"),
        rounds, int)
    return [
        Row("bytes to registers and reply", whole, "instr.", SOURCE, source),
        Row(f"the same, {UART_FIFO} bytes at a time", pieces, "instr.", SOURCE, source),
        Row("the whole program behind a terminal", program, "instr.", PYTHON, loop),
    ]


def rows(build: Path, quick: bool) -> list[Row]:
    if why := missing(build):
        print(f"board: skipped, {why}", file=sys.stderr)
        return []
    with tempfile.TemporaryDirectory(prefix="raymarch-bench-") as folder:
        processor = Processor(str(shutil.which("qemu-arm")), programs(build)[0],
                              Path(folder, "counter"))
        return counted(build, processor, quick)
