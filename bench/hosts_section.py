# SPDX-License-Identifier: MIT
"""How long a host waits beside fifteen others that do their worst, with a disk that takes 100 ms to
write: the answer to PING over the control socket and over the serial terminal."""
import os
import re
import socket
import subprocess
import tempfile
import threading
import time
import tty
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from report import Row

HOSTILE = 15
SYNC_SECONDS = 0.1
GOAL_MS = 20.0
SECONDS, QUICK_SECONDS = 10.0, 3.0

# One write of what takes the service longest, again and again.
LOADS = {
    "STATUS": ("marcher", b"STATUS\n" * 1000),
    "PRESET": ("marcher", b"PRESET tunnel\nPRESET lattice\n" * 500),
    "SAVE": ("marcher", b"HUE 0.1\nSAVE\nHUE 0.2\nSAVE\n" * 500),
    "LOAD": ("marcher", b"LOAD\n" * 1000),
    "GET": ("whitted", b"GET\n" * 1000),
    "WALK 1000": ("mandelbulb", b"WALK forward 1000\n" * 500),
    "ACCELERATOR": ("mandelbulb", b"ACCELERATOR fractal\nACCELERATOR mandelbulb\n" * 300),
}


def slow_disk(folder: Path) -> dict[str, str]:
    """The environment of a program whose fsync takes SYNC_SECONDS longer."""
    source, library = folder / "slow_disk.c", folder / "slow_disk.so"
    source.write_text(f"""
        #include <time.h>
        int fsync(int fd) {{
            (void)fd;
            struct timespec time = {{0, {int(SYNC_SECONDS * 1e9)}}};
            return nanosleep(&time, 0);
        }}
        """)
    subprocess.run(["cc", "-shared", "-fPIC", "-o", library, source], check=True)
    return {**os.environ, "LD_PRELOAD": str(library)}


def raise_priority() -> None:
    """Takes the priority that the systemd unit gives the service; only root may do that. The hosts
    that are measured take it too, because they stand for other machines, which do not share a
    processor with the hostile ones."""
    unit = Path(__file__).parent.parent / "systemd" / "raymarchd.service"
    nice = re.search(r"^Nice=(-?\d+)$", unit.read_text(), re.MULTILINE)
    assert nice, f"{unit} has no Nice="
    if os.geteuid() == 0:
        os.setpriority(os.PRIO_PROCESS, 0, int(nice[1]))


@contextmanager
def service(build: Path, folder: Path) -> Iterator[tuple[str, str]]:
    """A service on the emulated block: its control socket and its terminal."""
    control, terminal = str(folder / "control"), str(folder / "tty")
    command = [build / "raymarchd", "--registers=emulated", f"--serial=pty:{terminal}",
               f"--control={control}", f"--state={folder}/state", "--gpio=none", "--log-level=error"]
    process = subprocess.Popen(command, env=slow_disk(folder), preexec_fn=raise_priority)
    try:
        while not answers(control):
            time.sleep(0.01)
            assert process.poll() is None, "the service has ended"
        yield control, terminal
    finally:
        process.terminate()
        process.wait()


def connect(control: str) -> socket.socket:
    host = socket.socket(socket.AF_UNIX)
    host.connect(control)
    return host


def answers(control: str) -> bool:
    try:
        connect(control).close()
    except OSError:
        return False
    return True


def ask(control: str, line: str) -> None:
    with connect(control) as host, host.makefile("rwb") as lines:
        lines.write(line.encode() + b"\n")
        lines.flush()
        reply = lines.readline()
        assert reply.startswith(b"OK"), reply


def flood(control: str, load: bytes, until: float) -> None:
    """Sends and reads as fast as the service lets it."""
    with connect(control) as host:
        host.setblocking(False)
        rest = load
        while time.monotonic() < until:
            try:
                rest = rest[host.send(rest):] or load
            except BlockingIOError:
                pass
            try:
                while host.recv(65536):
                    pass
            except BlockingIOError:
                time.sleep(0.001)


def waits(write, read, until: float) -> list[float]:
    """The milliseconds that each PING waited."""
    found = []
    while time.monotonic() < until:
        begin = time.monotonic()
        write(b"PING\n")
        reply = b""
        while not reply.endswith(b"\n"):
            reply += read(64)
        assert reply == b"OK\r\n", reply
        found.append((time.monotonic() - begin) * 1000)
        time.sleep(0.002)
    return found


def bare_terminal(until: float) -> float:
    """The longest that a byte takes through a pseudo-terminal without any service: what the kernel adds."""
    master, slave = os.openpty()
    tty.setraw(slave)
    longest = 0.0
    while time.monotonic() < until:
        begin = time.monotonic()
        os.write(slave, b"x")
        os.read(master, 1)
        longest = max(longest, time.monotonic() - begin)
        time.sleep(0.002)
    return longest * 1000


def measure(build: Path, name: str, seconds: float) -> list[Row]:
    accelerator, load = LOADS[name]
    with tempfile.TemporaryDirectory() as folder, service(build, Path(folder)) as (control, terminal):
        ask(control, f"ACCELERATOR {accelerator}")
        if accelerator == "mandelbulb":
            ask(control, "PRESET deep58")
            ask(control, "SET N=64,K=64,I=64")
        until = time.monotonic() + seconds
        # Threads of one process would wait for one another.
        hostile = []
        for _ in range(HOSTILE):
            if (child := os.fork()) == 0:
                try:
                    flood(control, load, until)
                finally:
                    os._exit(0)
            hostile.append(child)
        result, bare = os.pipe()
        if (child := os.fork()) == 0:
            try:
                os.write(bare, str(bare_terminal(until)).encode())
            finally:
                os._exit(0)
        hostile.append(child)
        found: dict[str, list[float]] = {}
        line = os.open(terminal, os.O_RDWR | os.O_NOCTTY)
        host = connect(control)

        def ask_until_the_end(port: str, write, read) -> None:
            raise_priority()  # of this thread alone
            found[port] = waits(write, read, until)

        threads = [threading.Thread(target=ask_until_the_end, args=measured) for measured in (
            ("socket", host.sendall, host.recv),
            ("terminal", lambda b: os.write(line, b), lambda n: os.read(line, n)))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        host.close()
        os.close(line)
        for child in hostile:
            os.waitpid(child, 0)
        longest_bare = float(os.read(result, 64))
        os.close(result)
        os.close(bare)
    beside = f"beside {HOSTILE} x {name}"
    return [Row(f"longest PING {beside}, {port}", max(times), "ms", "the goal", GOAL_MS, wanted=1)
            for port, times in found.items()] + [
        Row(f"longest PING {beside}, terminal", max(found["terminal"]), "ms",
            "a bare pseudo-terminal", longest_bare)]


def rows(build: Path, quick: bool) -> list[Row]:
    seconds = QUICK_SECONDS if quick else SECONDS
    return [row for name in LOADS for row in measure(build, name, seconds)]
