#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Boots the virtual board and runs the trials in TRIALS; ./dev board makes the needed files.

It ends with a table. --shell opens the board's console instead, with the package installed and the
logic emulated."""

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
CARD_BYTES = 1 << 30  # QEMU needs a power of two


def register_address() -> int:
    match = re.search(r"raymarch@([0-9a-f]+)", (HERE / "pynq-z1-virtual.dts").read_text())
    assert match
    return int(match[1], 16)


def memory_folder() -> str | None:
    """Returns the folder for the machine's memory. Its Linux uses a quarter of that."""
    shared = Path("/dev/shm")
    return str(shared) if shared.is_dir() and shutil.disk_usage(shared).free > CARD_BYTES else None


def device_tree(kernel: Path, folder: Path) -> Path:
    """Compiles the board's device tree, which includes the kernel's tree of the processor."""
    source = subprocess.run(["cpp", "-nostdinc", "-undef", "-x", "assembler-with-cpp",
                             "-I", kernel / "dts", HERE / "pynq-z1-virtual.dts"],
                            check=True, capture_output=True).stdout
    blob = folder / "board.dtb"
    subprocess.run(["dtc", "-q", "-I", "dts", "-O", "dtb", "-o", blob, "-"], input=source, check=True)
    return blob


def card(rootfs: Path, package: Path, folder: Path) -> Path:
    """Copies Debian's card and writes the package to it without a mount."""
    disk = folder / "card.ext4"
    subprocess.run(["cp", "--sparse=always", rootfs, disk], check=True)
    with disk.open("r+b") as file:
        file.truncate(CARD_BYTES)
    subprocess.run(["debugfs", "-w", "-f", "-", disk], input=f"write {package} /root/raymarchd.deb\n",
                   text=True, check=True, capture_output=True)
    return disk


def restarts(board: Board) -> bool:
    """Returns whether the board starts again for the next trial."""
    try:
        board.restart()
        return True
    except Exception as error:
        print(f"   the board does not start again: {error}", flush=True)
        return False


def try_all(board: Board, names: list[str]) -> bool:
    rows: list[tuple[str, str, float, str]] = []
    for name in names:
        print(f"== {name}", flush=True)
        begun = time.monotonic()
        try:
            result, note = "passed", TRIALS[name](board)
        except Exception as error:  # the table is printed after any error
            result, note = "FAILED", f"{type(error).__name__}: {error}"
        rows.append((name, result, time.monotonic() - begun, note))
        print(f"   {result}, {rows[-1][2]:.1f} s: {note}", flush=True)
        if result != "passed" and (TRIALS[name] in (install, power_on) or not restarts(board)):
            break  # the other trials need a running board
    width = max(map(len, names))
    print(f"\n{'trial':{width}}  result  seconds")
    for name, result, seconds, note in rows:
        print(f"{name:{width}}  {result:6}  {seconds:7.1f}  {note}")
    passed = sum(row[1] == "passed" for row in rows)
    print(f"\n{passed} passed, {len(names) - passed} failed")
    return passed == len(names)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kernel", type=Path, required=True, help="folder that kernel.sh prints")
    parser.add_argument("--rootfs", type=Path, required=True, help="image that rootfs.sh prints")
    parser.add_argument("--package", type=Path, required=True, help="armhf package")
    parser.add_argument("--programs", type=Path, required=True, help="build folder of the host")
    parser.add_argument("--folder", type=Path, required=True, help="folder for card, logs and the picture")
    parser.add_argument("--cuts", type=int, default=20, help="number of power cuts (default: 20)")
    parser.add_argument("--only", action="append", choices=list(TRIALS), metavar="TRIAL",
                        help="run this trial and the first two (repeatable)")
    parser.add_argument("--short", action="store_true", help="run only the trials that need one boot")
    parser.add_argument("--shell", action="store_true", help="open a console in place of the trials")
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
                machine.serial.close()  # QEMU accepts one client at a time
                print(f"This is root's console; Ctrl-] ends it. The second serial port: raymarchctl console --socket "
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
