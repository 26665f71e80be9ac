#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Question: how much processor time does a frame cost the whole program behind a terminal?

    processor_time.py [--quick] -- NAME COMMAND... [-- NAME COMMAND...]...

COMMAND serves a pseudo-terminal at {link} and writes {registers}, both replaced by paths. The time
is that of all the program's threads, in the kernel and outside, as the scheduler counts it. Flat
out: frames as fast as the terminal takes them. Paced: one frame at a time, 68 a second, which is
what a UART of 115200 baud brings. The programs take turns; the medians of the turns are printed.
"""
import json
import select
import sys
import time
from itertools import cycle, islice
from statistics import median

from frame_path import read_frames
from terminal_program import TerminalProgram, wait_until

FRAMES_A_SECOND = 68
# Blue tells these apart from every frame before them, and from each other.
ENDS = [(b"FX=0,FY=0,FZ=1,RX=1,RY=0,RZ=0,UX=0,UY=1,UZ=0,ZM=3,LX=3,LY=2,LZ=5,R=1,G=1,B=%b,OBJ=sphere"
         b"\r\n") % blue for blue in (b"0.987", b"0.123")]


def finish(program: TerminalProgram) -> None:
    """Two frames, the second after the first has been written: then all before them are done."""
    for end in ENDS:
        before = program.last_word()
        send(program, end)
        wait_until(lambda: program.last_word() != before, "the last frame")


def send(program: TerminalProgram, data: bytes) -> None:
    rest = memoryview(data)
    while rest:
        select.select([program.terminal], [program.terminal], [])
        program.drain()
        rest = rest[program.write_some(rest[:4096]):]


def flat_out(program: TerminalProgram, frames: int) -> float:
    data = b"".join(islice(cycle(read_frames()), frames))
    before = program.processor_ns()
    send(program, data)
    finish(program)
    return (program.processor_ns() - before) / (frames + len(ENDS)) / 1000


def paced(program: TerminalProgram, frames: int) -> float:
    before = program.processor_ns()
    due = time.monotonic()
    for frame in islice(cycle(read_frames()), frames):
        due += 1 / FRAMES_A_SECOND
        time.sleep(max(0.0, due - time.monotonic()))
        program.drain()
        program.write_some(frame)
    finish(program)
    return (program.processor_ns() - before) / (frames + len(ENDS)) / 1000


def contestants(words: list[str]) -> dict[str, list[str]]:
    found: dict[str, list[str]] = {}
    for word in words:
        if word == "--":
            found[""] = []
        elif "" in found:
            found[word] = found.pop("")
        else:
            list(found.values())[-1].append(word)
    return found


def main() -> None:
    words = sys.argv[1:]
    quick = words[:1] == ["--quick"]
    turns, frames, paced_frames = (3, 2000, 68) if quick else (7, 10000, 4 * 68)
    times: dict[str, dict[str, list[float]]] = {}
    commands = contestants(words[1:] if quick else words)
    for _ in range(turns):
        for name, command in commands.items():
            own = times.setdefault(name, {"flat_out_us": [], "paced_us": []})
            with TerminalProgram(command) as program:
                flat_out(program, 500)  # warm
                own["flat_out_us"].append(flat_out(program, frames))
                own["paced_us"].append(paced(program, paced_frames))
    print(json.dumps({name: {key: median(found) for key, found in own.items()}
                      for name, own in times.items()}))


if __name__ == "__main__":
    main()
