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
import re
import subprocess
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

FRAMES = 1000
PAGE_BYTES = 4096
FRAME = ("FX=0,FY=0,FZ=1,RX=1,RY=0,RZ=0,UX=0,UY=1,UZ=0,ZM=3.00,LX=3,LY=2,LZ=5,"
         "R=1.000,G=1.000,B={:.3f},OBJ=sphere\r\n")


def wait_until(done: Callable[[], bool], what: str, limit: float = 5.0) -> None:
    end = time.monotonic() + limit
    while not done():
        if time.monotonic() > end:
            raise TimeoutError(what)
        time.sleep(0.0002)


def kilobytes(text: str, key: str) -> int:
    found = re.search(rf"^{key}:\s+(\d+) kB", text, re.MULTILINE)
    return int(found[1]) if found else 0


def context_switches(process: Path) -> int:
    return sum(int(count)
               for status in process.glob("task/*/status")
               for count in re.findall(r"ctxt_switches:\s+(\d+)", status.read_text()))


def send_frames(terminal: int, registers: Path) -> None:
    """Each frame when the one before has reached word 7; what comes back is thrown away."""
    for index in range(FRAMES):
        before = registers.read_bytes()[28:32]
        os.write(terminal, FRAME.format(index / 1000).encode())
        wait_until(lambda: registers.read_bytes()[28:32] != before, f"frame {index}")
        try:
            os.read(terminal, 65536)
        except BlockingIOError:
            pass


def measure(command: list[str], seconds: float) -> dict[str, float]:
    with tempfile.TemporaryDirectory(prefix="raymarch-bench-") as folder:
        registers, link = Path(folder, "registers"), Path(folder, "terminal")
        registers.write_bytes(bytes(PAGE_BYTES))
        words = [word.replace("{registers}", str(registers)).replace("{link}", str(link))
                 for word in command]
        child = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
        try:
            wait_until(lambda: link.exists() or child.poll() is not None, "the terminal")
            terminal = os.open(link, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
            send_frames(terminal, registers)
            process = Path("/proc", str(child.pid))
            before = context_switches(process)
            time.sleep(seconds)
            after = context_switches(process)
            resident = kilobytes((process / "status").read_text(), "VmRSS")
            shared_out = kilobytes((process / "smaps_rollup").read_text(), "Pss")
            os.close(terminal)
        finally:
            child.terminate()
            try:
                child.wait(2)
            except subprocess.TimeoutExpired:
                child.kill()
                child.wait()
    return {"resident_kb": resident, "proportional_kb": shared_out, "wake_ups": after - before,
            "seconds": seconds}


def main() -> None:
    parser = argparse.ArgumentParser(description="resident memory and idle wake-ups")
    parser.add_argument("--seconds", type=float, default=10.0)
    parser.add_argument("command", nargs=argparse.REMAINDER)
    options = parser.parse_args()
    print(json.dumps(measure(options.command, options.seconds)))


if __name__ == "__main__":
    main()
