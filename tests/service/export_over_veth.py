#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""raymarchctl export and receive over a veth pair, in a user and network namespace of its own.

Usage: export_over_veth.py PROGRAM. Ends with 77, and says why, where such namespaces, veth pairs or
raw sockets are not permitted."""

import os
import random
import shutil
import socket
import subprocess
import sys
import tempfile
import time
import zlib
from pathlib import Path

SKIPPED = 77
PATIENCE = 60.0
INSIDE = "RAYMARCH_INSIDE_NAMESPACE"
WIDTH, HEIGHT = 400, 300
ADDRESSES = bytes.fromhex("88665a0348b0 111111111111")


def skip(why: str) -> None:
    print(f"skipped: {why}")
    sys.exit(SKIPPED)


def run(*command: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE)


def enter_namespaces() -> None:
    """Starts this script again where it is root of a network of its own."""
    for tool in ("unshare", "ip"):
        if shutil.which(tool) is None:
            skip(f"there is no {tool}")
    probe = run("unshare", "--user", "--map-root-user", "--net", "true")
    if probe.returncode != 0:
        skip(f"no namespaces: {probe.stderr.strip()}")
    os.environ[INSIDE] = "1"
    os.execvp("unshare", ["unshare", "--user", "--map-root-user", "--net", sys.executable, *sys.argv])


def make_pair(*names: str) -> None:
    made = run("ip", "link", "add", "name", names[0], "type", "veth", "peer", "name", names[1])
    if made.returncode != 0:
        skip(f"no veth pair: {made.stderr.strip()}")
    try:
        socket.socket(socket.AF_PACKET, socket.SOCK_RAW, 0).close()
    except OSError as error:
        skip(f"no raw sockets: {error}")


def frames_of(levels: bytes) -> list[bytes]:
    """The format stated a second time."""
    frames = [ADDRESSES + b"\0" + b"\xff" * 50]
    for row in range(WIDTH):
        pixels = levels[WIDTH * row : WIDTH * (row + 1)] or bytes(WIDTH)
        packed = bytes(left << 4 | right for left, right in zip(pixels[::2], pixels[1::2]))
        frames.append(ADDRESSES + b"\0" + row.to_bytes(4, "big") + packed)
    return frames


def as_ppm(levels: bytes) -> bytes:
    return b"P6\n400 300\n255\n" + bytes(17 * level for level in levels for _ in range(3))


class Receiver:
    """A raymarchctl receive that is known to listen."""

    def __init__(self, program: str, interface: str, *options: str) -> None:
        self.process = subprocess.Popen(
            [program, "receive", "--interface", interface, *options], stderr=subprocess.PIPE, text=True
        )
        deadline = time.monotonic() + PATIENCE
        while not self.listens() and self.process.poll() is None and time.monotonic() < deadline:
            time.sleep(0.005)

    @staticmethod
    def listens() -> bool:
        # A line of titles, then one a packet socket: type, protocol 3 (ETH_P_ALL), interface.
        return any(" 0003 " in line for line in Path("/proc/net/packet").read_text().splitlines()[1:])

    def end(self) -> tuple[int, str]:
        errors = self.process.communicate(timeout=PATIENCE)[1]
        return self.process.returncode, errors


def check(what: str, holds: object) -> None:
    print(f"{'ok  ' if holds else 'FAIL'} {what}")
    if not holds:
        sys.exit(1)


def check_errors(program: str, picture: Path, folder: Path) -> None:
    """What is in the way is named: the interface is down, or nothing is permitted."""
    export = (program, "export", "--input", str(picture), "--interface")
    result = run(*export, "sender")
    check("an interface that is down", result.returncode == 69 and "sender: the interface is down" in result.stderr)
    result = run("unshare", "--user", *export, "sender")  # without rights on this network
    check("CAP_NET_RAW is named", result.returncode == 69 and "CAP_NET_RAW" in result.stderr)
    result = run(*export, "nosuch0")
    check("the interfaces are named", result.returncode == 69 and "lo, " in result.stderr)
    result = run(program, "receive", "--interface", "receiver", "-o", str(folder / "none.ppm"))
    check("a receiver's interface that is down", result.returncode == 69 and "is down" in result.stderr)


def check_pictures(program: str, levels: bytes, picture: Path, folder: Path) -> None:
    """From one end of the pair to the other, at both paces."""
    for options in ([], ["--fast"]):
        output = folder / f"out{len(options)}.ppm"
        receiver = Receiver(program, "receiver", "--timeout", "30", "-o", str(output))
        sent = run(program, "export", "--input", str(picture), "--interface", "sender", *options)
        check(f"sent {options}: {sent.stderr}", sent.returncode == 0)
        status, errors = receiver.end()
        check(f"received: {errors}", status == 0 and errors == "")
        check("the picture is the same", output.read_bytes() == as_ppm(levels))


def check_frames(program: str, levels: bytes, picture: Path) -> None:
    """What a receiver of another make sees on the other end."""
    with socket.socket(socket.AF_PACKET, socket.SOCK_RAW, socket.htons(3)) as port:
        port.bind(("receiver", 3))
        port.settimeout(PATIENCE)
        started = time.monotonic()
        with subprocess.Popen([program, "export", "--input", str(picture), "--interface", "sender"]) as sender:
            seen: list[bytes] = []
            while len(seen) < 401:
                frame = port.recv(4096)
                if frame.startswith(ADDRESSES):  # the kernel says things of its own on a new link
                    seen.append(frame)
            check("sent", sender.wait(PATIENCE) == 0)
        seconds = time.monotonic() - started
    check("the frames to the byte", seen == frames_of(levels))
    check("not faster than the source's hardware", seconds >= 400 * 981 * 20e-9)


def check_other_senders(program: str, levels: bytes, folder: Path) -> None:
    """Frames made here: in disorder, with a check sequence, damaged, foreign, and too few."""
    frames = frames_of(levels)
    output = folder / "made.ppm"

    def send_to_receiver(frames: list[bytes], *options: str) -> tuple[int, str]:
        receiver = Receiver(program, "receiver", "-o", str(output), *options)
        with socket.socket(socket.AF_PACKET, socket.SOCK_RAW, 0) as port:
            port.bind(("sender", 0))
            for frame in frames:
                port.send(frame)
                time.sleep(20e-6)
        return receiver.end()

    checked = [frame + zlib.crc32(frame).to_bytes(4, "little") for frame in frames[:301]]
    damaged = bytearray(checked[7])
    damaged[100] ^= 1
    foreign = bytes(6) + frames[9][6:]
    mixed = [checked[0], bytes(damaged), foreign, *reversed(checked[1:])]
    status, errors = send_to_receiver(mixed, "--timeout", "30")
    check("foreign ones ignored, a damaged one counted", status == 0 and "damaged frames: 1, doubled rows: 0" in errors)
    check("the picture is the same", output.read_bytes() == as_ppm(levels))

    for tags in ("81000005", "88a80064 81000005"):  # of the first the kernel itself takes care
        output.unlink()
        tagged = [frame[:12] + bytes.fromhex(tags) + frame[12:] for frame in frames]
        status, errors = send_to_receiver(tagged, "--timeout", "30")
        check(f"frames with the tags {tags}: {errors}", status == 0 and errors == "")
        check("the picture is the same", output.read_bytes() == as_ppm(levels))

    output.unlink()
    few = [frame for row, frame in enumerate(frames, -1) if row not in (0, 5, 6, 7, 299)]
    status, errors = send_to_receiver(few, "--timeout", "1")
    check(f"missing rows are named: {errors}", status == 74 and "missing rows of the picture: 0, 5-7, 299" in errors)
    check("and nothing is written", not output.exists())
    status, errors = send_to_receiver(few, "--timeout", "1", "--partial")
    rows = [bytes(WIDTH) if y in (0, 5, 6, 7, 299) else levels[WIDTH * y : WIDTH * (y + 1)] for y in range(HEIGHT)]
    check("but with --partial", status == 74 and output.read_bytes() == as_ppm(b"".join(rows)))


def main() -> int:
    if INSIDE not in os.environ:
        enter_namespaces()
    program = str(Path(sys.argv[1]).resolve())
    make_pair("sender", "receiver")
    chance = random.Random(1)
    levels = bytes(chance.randrange(16) for _ in range(WIDTH * HEIGHT))
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        picture = folder / "in.pgm"
        picture.write_bytes(b"P5\n400 300\n15\n" + levels)
        check_errors(program, picture, folder)
        for interface in ("sender", "receiver"):
            run("ip", "link", "set", interface, "up")
        check_pictures(program, levels, picture, folder)
        check_frames(program, levels, picture)
        check_other_senders(program, levels, folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
