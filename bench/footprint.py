#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Question: what does the service hold in memory, and how often does it wake while idle?

    footprint.py [--seconds N] COMMAND...

COMMAND serves a pseudo-terminal at {link} and writes {registers}, both replaced by paths. Measured
after 1000 frames; a wake-up is a context switch of any of its threads, wanted or not.
"""
import argparse
import json
import os
import time

from terminal_program import TerminalProgram, wait_until

FRAMES = 1000
FRAME = ("FX=0,FY=0,FZ=1,RX=1,RY=0,RZ=0,UX=0,UY=1,UZ=0,ZM=3.00,LX=3,LY=2,LZ=5,"
         "R=1.000,G=1.000,B={:.3f},OBJ=sphere\r\n")


def send_frames(program: TerminalProgram) -> None:
    """Each frame when the one before has reached word 7; what comes back is thrown away."""
    for index in range(FRAMES):
        before = program.last_word()
        os.write(program.terminal, FRAME.format(index / 1000).encode())
        wait_until(lambda: program.last_word() != before, f"frame {index}")
        program.drain()


def measure(command: list[str], seconds: float) -> dict[str, float]:
    with TerminalProgram(command) as program:
        send_frames(program)
        before = program.context_switches()
        time.sleep(seconds)
        return {"resident_kb": program.kilobytes("status", "VmRSS"),
                "proportional_kb": program.kilobytes("smaps_rollup", "Pss"),
                "wake_ups": program.context_switches() - before, "seconds": seconds}


def main() -> None:
    parser = argparse.ArgumentParser(description="resident memory and idle wake-ups")
    parser.add_argument("--seconds", type=float, default=10.0)
    parser.add_argument("command", nargs=argparse.REMAINDER)
    options = parser.parse_args()
    print(json.dumps(measure(options.command, options.seconds)))


if __name__ == "__main__":
    main()
