# SPDX-License-Identifier: MIT
"""Tests buttons, switches and LEDs through the kernel's simulated lines and libgpiod."""

import math
import re

from fixture import BUSY, STATUS_WORD, Board, wait_until
from machine import check


class Lines:
    """Sets and reads the simulated chip's lines by name."""

    def __init__(self, board: Board):
        self._machine = board.machine
        chip = self._machine.run("dirname $(find /sys/devices -name sim_gpio0)")
        names = re.findall(r'line\s+(\d+):\s+"([a-z0-9_]+)"', self._machine.run("gpioinfo $(basename " + chip + ")"))
        self.folder = {name: f"{chip}/sim_gpio{offset}" for offset, name in names}
        check(len(self.folder) == 16, f"the chip's lines: {names}")

    def set(self, name: str, level: bool) -> None:
        self._machine.run(f"echo pull-{'up' if level else 'down'} > {self.folder[name]}/pull")

    def press(self, name: str) -> None:
        """Presses a button for longer than the debounce time."""
        self._machine.run(f"echo pull-up > {self.folder[name]}/pull; sleep 0.3; "
                          f"echo pull-down > {self.folder[name]}/pull")

    def value(self, name: str) -> bool:
        return self._machine.run(f"cat {self.folder[name]}/value") == "1"

    def wait(self, name: str, level: bool) -> None:
        """Waits on the board, because a blink may end before a reply comes here."""
        self._machine.run(self._until(name, level))

    def _until(self, name: str, level: bool) -> str:
        """Returns a command that only uses the shell, because starting a program takes longer than a blink."""
        return f"until read v < {self.folder[name]}/value && [ $v = {int(level)} ]; do :; done"

    def watch(self, name: str, mark: str) -> str:
        """Watches a line in the background. The returned command waits until the line was high."""
        self._machine.run(f"rm -f /run/{mark}; ({self._until(name, True)}; touch /run/{mark}) > /dev/null 2>&1 & true")
        return f"until [ -e /run/{mark} ]; do sleep 0.05; done"


def heading(board: Board) -> float:
    """Returns the camera's angle about the vertical axis, in degrees."""
    state = board.present()
    return math.degrees(math.atan2(float(state["FX"]), float(state["FZ"])))


def total_turn(headings: list[float]) -> float:
    """Returns the whole turn in degrees. Neighbouring headings are less than 180 degrees apart."""
    return sum((after - before + 180) % 360 - 180 for before, after in zip(headings, headings[1:]))


def turned(board: Board, lines: Lines, name: str) -> float:
    """Returns how far the camera turns from the defaults while the line is high. Checks that it rests before
    and after."""
    board.machine.ask("RESET")
    board.wait_for_status("gpio", "up")
    seen = [heading(board), heading(board)]
    check(seen[0] == seen[1], "the camera turns by itself")
    lines.set(name, True)

    def sample() -> None:
        seen.append(heading(board))

    def three_more() -> bool:
        sample()
        return len(set(seen)) > 3
    wait_until(three_more, lambda: f"{name}: headings {seen}")
    lines.set(name, False)

    def rests() -> bool:
        sample()
        return len(set(seen[-5:])) == 1
    wait_until(rests, lambda: f"{name} is let go: headings {seen}")
    return total_turn(seen)


def turn_of(board: Board, side: str) -> float:
    """Returns how far one TURN of the protocol turns the camera from the defaults."""
    board.machine.ask("RESET")
    before = heading(board)
    check(board.machine.ask(f"TURN {side}").startswith("OK"), f"TURN {side}")
    return total_turn([before, heading(board)])


def buttons(board: Board) -> str:
    lines = Lines(board)
    board.wait_for_status("gpio", "up")
    check(board.machine.ask("RESET").startswith("OK"), "RESET")
    defaults = board.present()
    lines.press("btn1")
    wait_until(lambda: board.present()["OBJ"] != defaults["OBJ"], lambda: "BTN1: the same scene")
    check(board.machine.ask("SET ZM=5").startswith("OK"), "SET")
    lines.press("btn0")
    wait_until(lambda: board.present() == defaults, lambda: f"BTN0: {board.present()}")
    left, right = turned(board, lines, "btn2"), turned(board, lines, "btn3")
    check(left * turn_of(board, "left") > 0 and right * turn_of(board, "right") > 0,
          f"not as TURN left and TURN right: {left}, {right}")
    board.machine.ask("RESET")
    return f"BTN0 defaults, BTN1 next scene, BTN2 held {left:+.0f} degrees, BTN3 held {right:+.0f}"


def switches(board: Board) -> str:
    lines = Lines(board)
    lines.set("sw0", True)
    wait_until(lambda: board.machine.ask("SET ZM=5").startswith("ERR LOCKED"), lambda: "SW0 does not lock")
    before = board.present()
    check(board.machine.ask("OBJ=cube").startswith("ERR LOCKED"), "a frame is taken while locked")
    check(board.present() == before, "a refused frame changed the state")
    lines.set("sw0", False)
    wait_until(lambda: board.machine.ask("SET ZM=5").startswith("OK"), lambda: "SW0 does not unlock")
    return f"SW0 locks writes and not reads; SW1 turns the camera, {turned(board, lines, 'sw1'):+.0f} degrees"


def leds(board: Board) -> str:
    machine = board.machine
    lines = Lines(board)
    for level in (True, False, True):
        lines.wait("led0", level)
    lines.wait("led1", False)
    seen = lines.watch("led1", "accepted")
    check(machine.ask("SET R=1,G=0,B=1").startswith("OK"), "SET")
    machine.run(seen)
    for channel in range(8):
        red, green, blue = (channel >> 2 & 1, channel >> 1 & 1, channel & 1)
        check(machine.ask(f"SET R={red},G={green},B={blue}").startswith("OK"), "SET")
        for name, level in (("led4_r", red), ("led4_g", green), ("led4_b", blue)):
            lines.wait(name, bool(level))
    check(machine.ask("SET ZM=77").startswith("ERR RANGE"), "a zoom of 77 is taken")
    lines.wait("led2", True)
    check(machine.ask("SET ZM=7").startswith("OK"), "SET")
    lines.wait("led2", False)
    # The test itself sets the busy bit.
    board.stop_playing()
    board.memory.words[STATUS_WORD] |= BUSY
    lines.wait("led3", True)
    board.memory.words[STATUS_WORD] &= ~BUSY
    lines.wait("led3", False)
    board.play_again()
    for name in ("led5_r", "led5_g", "led5_b"):
        check(not lines.value(name), f"{name} is lit")
    return "LD0 beats, LD1 blinks, LD2 refused, LD3 running, LD4 the eight colours, LD5 dark"


def taken(board: Board) -> str:
    """Another program has a line when the service starts, and releases it later."""
    machine = board.machine
    lines = Lines(board)
    machine.run("systemctl stop raymarchd")
    for line in ("led0)=1", "btn1)=0"):
        machine.run("gpioset --mode=signal --background $(gpiofind " + line)
    check(lines.value("led0"), "gpioset has not taken the line")
    machine.run("systemctl start raymarchd")
    machine.wait_for_service()
    check(board.status()["gpio"] == "partial", f"STATUS: {board.status()}")
    said = machine.run("journalctl -u raymarchd -b --no-pager | grep -E 'led0|btn1' | tail -n 2")
    check("led0" in said and "btn1" in said, f"the journal: {said}")
    machine.run("pkill gpioset")
    board.wait_for_status("gpio", "up")
    for level in (True, False):
        lines.wait("led0", level)
    return "reported: " + "; ".join(re.sub(r".*raymarchd\[\d+\]: ", "", line) for line in said.splitlines())


TRIALS = {
    "buttons": buttons,
    "switches": switches,
    "LEDs": leds,
    "lines that another has": taken,
}
