# SPDX-License-Identifier: MIT
"""A program under measurement: it serves a pseudo-terminal at {link} and writes the register file
{registers}, words of its command that are replaced by paths."""
import os
import re
import subprocess
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

PAGE_BYTES = 4096


def wait_until(done: Callable[[], bool], what: str, limit: float = 20.0) -> None:
    end = time.monotonic() + limit
    while not done():
        if time.monotonic() > end:
            raise TimeoutError(what)
        time.sleep(0.0002)


class TerminalProgram:
    """Runs from `with` to its end. The terminal is open, and does not block."""

    def __init__(self, command: list[str]) -> None:
        self._folder = tempfile.TemporaryDirectory(prefix="raymarch-bench-")
        self.registers = Path(self._folder.name, "registers")
        self.registers.write_bytes(bytes(PAGE_BYTES))
        self._link = Path(self._folder.name, "terminal")
        self._command = [word.replace("{registers}", str(self.registers))
                         .replace("{link}", str(self._link)) for word in command]

    def __enter__(self) -> "TerminalProgram":
        self._child = subprocess.Popen(self._command, stdin=subprocess.DEVNULL,
                                       stdout=subprocess.DEVNULL)
        try:
            wait_until(lambda: self._link.exists() or self._child.poll() is not None, "terminal")
            self.terminal = os.open(self._link, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
        except BaseException:
            self._end()
            raise
        self.process = Path("/proc", str(self._child.pid))
        return self

    def __exit__(self, *_: object) -> None:
        os.close(self.terminal)
        self._end()

    def _end(self) -> None:
        self._child.terminate()
        try:
            self._child.wait(2)
        except subprocess.TimeoutExpired:
            self._child.kill()
            self._child.wait()
        self._folder.cleanup()

    def last_word(self) -> bytes:
        """Register word 7, the last one that a frame writes."""
        return self.registers.read_bytes()[28:32]

    def write_some(self, data: bytes) -> int:
        """How many bytes the terminal takes now."""
        try:
            return os.write(self.terminal, data)
        except BlockingIOError:
            return 0

    def drain(self) -> None:
        """Throws away what the program has sent."""
        try:
            while os.read(self.terminal, 65536):
                pass
        except BlockingIOError:
            pass

    def processor_ns(self) -> int:
        """Of all its threads, since its start."""
        return sum(int(task.read_text().split()[0]) for task in self.process.glob("task/*/schedstat"))

    def context_switches(self) -> int:
        return sum(int(count)
                   for status in self.process.glob("task/*/status")
                   for count in re.findall(r"ctxt_switches:\s+(\d+)", status.read_text()))

    def kilobytes(self, file: str, key: str) -> int:
        found = re.search(rf"^{key}:\s+(\d+) kB", (self.process / file).read_text(), re.MULTILINE)
        return int(found[1]) if found else 0
