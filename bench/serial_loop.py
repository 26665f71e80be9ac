#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What bench_latency and footprint.py compare the service with: the source's script as a loop.

    serial_loop.py REGISTERS LINK

Reads lines from a pseudo-terminal of its own, which LINK leads to, and writes the register file.
"""
import mmap
import os
import sys
import tty

from frame_path import PAGE_BYTES, apply


def main() -> None:
    registers, link = sys.argv[1:]
    master, other_end = os.openpty()  # both stay open: a read without a host waits
    tty.setraw(other_end)
    with open(registers, "r+b") as file:
        page = mmap.mmap(file.fileno(), PAGE_BYTES)
    with open(master, "rb") as port:
        os.symlink(os.ttyname(other_end), link)
        while line := port.readline():
            apply(line, page)


if __name__ == "__main__":
    main()
