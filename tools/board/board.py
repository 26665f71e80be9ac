#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Boots the virtual board and tries what TRIALS lists; ./dev board makes what it takes.

Ends with a table. --shell is for a person: the board with the package installed, its console here,
and the logic played beside it."""

import argparse
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from fixture import Board
from machine import Machine, Memory, shell
from trials import SHORT, TRIALS, install, power_on

HERE = Path(__file__).resolve().parent
CARD_BYTES = 1 << 30  # QEMU's cards have a power of two


def register_address() -> int:
    match = re.search(r"raymarch@([0-9a-f]+)", (HERE / "pynq-z1-virtual.dts").read_text())
    assert match
    return int(match[1], 16)


def memory_folder() -> str | None:
    """For the machine's memory, of which Linux there uses a quarter."""
    shared = Path("/dev/shm")
    return str(shared) if shared.is_dir() and shutil.disk_usage(shared).free > CARD_BYTES else None


def device_tree(kernel: Path, folder: Path) -> Path:
    """The board's tree on top of the kernel's own for the processor."""
    source = subprocess.run(["cpp", "-nostdinc", "-undef", "-x", "assembler-with-cpp",
                             "-I", kernel / "dts", HERE / "pynq-z1-virtual.dts"],
                            check=True, capture_output=True).stdout
    blob = folder / "board.dtb"
    subprocess.run(["dtc", "-q", "-I", "dts", "-O", "dtb", "-o", blob, "-"], input=source, check=True)
    return blob


def card(rootfs: Path, package: Path, folder: Path) -> Path:
    """Debian's card with the package copied to it, without mounting anything."""
    disk = folder / "card.ext4"
    subprocess.run(["cp", "--sparse=always", rootfs, disk], check=True)
    with disk.open("r+b") as file:
        file.truncate(CARD_BYTES)
    subprocess.run(["debugfs", "-w", "-f", "-", disk], input=f"write {package} /root/raymarchd.deb\n",
                   text=True, check=True, capture_output=True)
    return disk


def is_afresh(board: Board) -> bool:
    """Whether the next trial finds what a power-on leaves."""
    try:
        board.afresh()
        return True
    except Exception as error:
        print(f"   it does not come up again: {error}", flush=True)
        return False


def try_all(board: Board, names: list[str]) -> bool:
    rows: list[tuple[str, str, float, str]] = []
    for name in names:
        print(f"== {name}", flush=True)
        begun = time.monotonic()
        try:
            result, note = "passed", TRIALS[name](board)
        except Exception as error:  # whatever it is, the table comes
            result, note = "FAILED", f"{type(error).__name__}: {error}"
        rows.append((name, result, time.monotonic() - begun, note))
        print(f"   {result}, {rows[-1][2]:.1f} s: {note}", flush=True)
        if result != "passed" and (TRIALS[name] in (install, power_on) or not is_afresh(board)):
            break  # nothing runs that the others could try
    width = max(map(len, names))
    print(f"\n{'trial':{width}}  result  seconds")
    for name, result, seconds, note in rows:
        print(f"{name:{width}}  {result:6}  {seconds:7.1f}  {note}")
    passed = sum(row[1] == "passed" for row in rows)
    print(f"\n{passed} passed, {len(names) - passed} failed")
    return passed == len(names)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kernel", type=Path, required=True, help="what kernel.sh prints")
    parser.add_argument("--rootfs", type=Path, required=True, help="what rootfs.sh prints")
    parser.add_argument("--package", type=Path, required=True, help="the armhf package")
    parser.add_argument("--programs", type=Path, required=True, help="the host's build folder")
    parser.add_argument("--folder", type=Path, required=True, help="for card, logs and the picture")
    parser.add_argument("--cuts", type=int, default=20, help="how often the power goes (default: 20)")
    parser.add_argument("--only", action="append", choices=list(TRIALS), metavar="TRIAL",
                        help="this trial, and the first two (repeatable)")
    parser.add_argument("--short", action="store_true", help="the trials that one boot takes")
    parser.add_argument("--shell", action="store_true", help="a console in place of the trials")
    options = parser.parse_args()

    folder = options.folder.resolve()
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    tree = device_tree(options.kernel, folder)
    disk = card(options.rootfs, options.package.resolve(), folder)
    with tempfile.TemporaryDirectory(dir=memory_folder()) as shared:
        (folder / "memory").symlink_to(Path(shared) / "memory")
        memory = Memory(folder / "memory", register_address())
        machine = Machine(options.kernel / "zImage", tree, disk, folder)
        board = Board(machine, memory, options.package, options.programs, options.cuts)
        try:
            if options.shell:
                install(board)
                board.play()
                machine.start()
                machine.serial.close()  # QEMU's end takes one at a time
                print(f"root's console; Ctrl-] ends. The second serial port: raymarchctl console --socket "
                      f"{folder / 'serial'}\nThe picture: {board.picture}", flush=True)
                shell(machine)
                return 0
            names = list(TRIALS)
            wanted = SHORT if options.short else options.only
            if wanted:
                names = [name for name in names if name in names[:2] or name in wanted]
            return 0 if try_all(board, names) else 1
        finally:
            board.stop_playing()
            if machine.process:
                machine.cut()


if __name__ == "__main__":
    sys.exit(main())
