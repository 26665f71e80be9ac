# SPDX-License-Identifier: MIT
"""The fixture of all trials: the machine with its memory, the programs of the host, and waiting."""

import re
import subprocess
import time
from collections.abc import Callable
from pathlib import Path

from machine import PATIENCE_S, Failed, Machine, Memory, Player, check

# Word numbers of extended registers (docs/registers.md).
ID_WORD, CAPABILITY_WORD, STATUS_WORD = 8, 10, 14
BUSY = 1  # a bit of STATUS


def wait_until(condition: Callable[[], bool], what: Callable[[], str], pause_s: float = 0.05) -> None:
    """Polls the condition. Raises Failed with what() after the timeout."""
    end = time.monotonic() + PATIENCE_S
    while not condition():
        if time.monotonic() > end:
            raise Failed(what())
        time.sleep(pause_s)


class Board:
    def __init__(self, machine: Machine, memory: Memory, package: Path, programs: Path, cuts: int):
        self.machine = machine
        self.memory = memory
        self.package = package
        self.programs = programs
        self.cuts = cuts
        self.picture = machine.folder / "picture.png"
        self.player: Player | None = None

    def tool(self, *arguments: str) -> str:
        return subprocess.run([self.programs / "raymarchctl", *arguments], check=True, text=True,
                              capture_output=True).stdout

    def words_of(self, line: str) -> list[int]:
        reply = self.tool("encode", line).split()
        return [int(word, 16) for word in reply if re.fullmatch("[0-9A-F]{8}", word)]

    def play(self, *options: str) -> Player:
        self.player = Player(self.programs / "board_player", self.memory, self.machine,
                             "--picture", str(self.picture), *options)
        return self.player

    def stop_playing(self) -> None:
        if self.player:
            self.player.close()
            self.player = None

    def play_again(self, *options: str) -> None:
        """Replaces the logic. At the next update the service finds that its words are gone, and at the
        one after it writes all words."""
        self.stop_playing()
        self.play(*options)
        wait_until(lambda: all(self.machine.ask(line).startswith("OK") for line in ("SET ZM=1", "RESET")),
                   lambda: f"STATUS: {self.status()}")
        self.wait_for_status("hardware", "ok")

    def restart(self) -> None:
        """Cuts the power and starts the board again, after a failed trial."""
        self.stop_playing()
        if self.machine.process:
            self.machine.cut()
        self.memory.clear()
        self.play()
        self.machine.start()
        self.machine.wait_for_service()
        self.machine.log_in()
        self.wait_for_status("hardware", "ok")

    def status(self) -> dict[str, str]:
        reply = self.machine.ask("STATUS")
        check(reply.startswith("OK"), f"STATUS: {reply}")
        return dict(item.split("=", 1) for item in reply.split()[1:] if "=" in item)

    def wait_for_status(self, key: str, value: str) -> None:
        wait_until(lambda: self.status().get(key) == value, lambda: f"{key}={value} did not come: {self.status()}")

    def present(self) -> dict[str, str]:
        """Returns the present state, by key."""
        reply = self.machine.ask("GET")
        check(reply.startswith("OK "), f"GET: {reply}")
        return dict(pair.split("=", 1) for pair in reply.removeprefix("OK ").split(","))

    def interrupt(self) -> tuple[str, int]:
        """Returns the file that raises the accelerator's interrupt, and how often it came."""
        number, count = self.machine.run("grep -w raymarch /proc/interrupts").split()[:2]
        return f"/sys/kernel/debug/irq/irqs/{number.rstrip(':')}", int(count)

    def pid(self) -> int:
        return int(self.machine.run("systemctl show -p MainPID --value raymarchd"))

    def wait_for_restart(self, before: int) -> int:
        """Waits until systemd says that another process is ready."""
        self.machine.run(
            f"until [ $(systemctl show -p MainPID --value raymarchd) != {before} ] && "
            "systemctl is-active -q raymarchd; do sleep 0.2; done")
        return self.pid()


def wait_for_words(board: Board, wanted: list[int]) -> None:
    """Waits for the words. They may come after the reply if a commit was pending."""
    def words(values: list[int]) -> str:
        return " ".join(f"{value:08X}" for value in values)

    def there() -> list[int]:
        return list(board.memory.words[:len(wanted)])
    wait_until(lambda: there() == wanted, lambda: f"{words(there())} in place of {words(wanted)}", 0.01)
