# SPDX-License-Identifier: MIT
"""Controls the virtual board from outside: QEMU, its console, its second serial port, its memory.

All waits are for an event (a line, the end of a process). The timeout is so long that only a machine
that hangs reaches it."""

import itertools
import mmap
import os
import re
import select
import socket
import subprocess
import sys
import threading
import time
from pathlib import Path

PATIENCE_S = 1800
MEMORY_BYTES = 2 << 30
LINUX_MEMORY = "512M"
PAGE_BYTES = 4096


class Failed(Exception):
    """A trial has failed."""


def check(condition: bool, what: str) -> None:
    if not condition:
        raise Failed(what)


class Stream:
    """A socket of QEMU."""

    def __init__(self, path: Path):
        self._seen = b""
        for patience in range(500, -1, -1):
            self._socket = socket.socket(socket.AF_UNIX)
            try:
                self._socket.connect(str(path))
                return
            except ConnectionRefusedError:  # QEMU has bound it, but does not listen yet
                self._socket.close()
                check(patience > 0, f"{path}: nobody listens")
                time.sleep(0.01)

    def send(self, data: bytes) -> None:
        self._socket.sendall(data)

    def close(self) -> None:
        self._socket.close()

    def fileno(self) -> int:
        return self._socket.fileno()

    def receive(self) -> bytes:
        return self._socket.recv(65536)

    def until(self, pattern: bytes, patience_s: float = PATIENCE_S) -> re.Match[bytes]:
        """Takes all bytes up to the first match. Raises TimeoutError, or Failed if QEMU has ended."""
        end = time.monotonic() + patience_s
        while not (match := re.search(pattern, self._seen, re.DOTALL)):
            ready = select.select([self], [], [], max(0.0, end - time.monotonic()))[0]
            if not ready:
                raise TimeoutError(f"{pattern!r} did not come in {patience_s} s")
            data = self.receive()
            if not data:
                raise Failed("the machine has ended")
            self._seen += data
        self._seen = self._seen[match.end():]
        return match

    def forget(self) -> None:
        """Drops all received bytes."""
        while select.select([self], [], [], 0)[0] and self.receive():
            pass
        self._seen = b""


class Machine:
    """One power-on: from start() to a clean end, or to cut()."""

    def __init__(self, kernel: Path, tree: Path, disk: Path, folder: Path):
        self.folder = folder
        # QEMU ends with this program, even after SIGKILL.
        self._command = [
            "setpriv", "--pdeathsig", "KILL", "qemu-system-arm", "-M", "xilinx-zynq-a9,memory-backend=ram", "-smp", "1",
            "-m", str(MEMORY_BYTES >> 20), "-object",
            f"memory-backend-file,id=ram,size={MEMORY_BYTES},mem-path={folder / 'memory'},share=on",
            "-kernel", str(kernel), "-dtb", str(tree),
            "-drive", f"if=sd,format=raw,file={disk}",
            "-display", "none", "-nic", "none", "-no-reboot", "-monitor", "none",
        ]
        for name in ("console", "serial"):
            self._command += ["-chardev", f"socket,id={name},path={folder / name},server=on,wait=off,"
                              f"logfile={folder / name}.log,logappend=on",
                              "-serial", f"chardev:{name}"]
        self._numbers = itertools.count(1)
        self._console_lock = threading.Lock()
        self.process: subprocess.Popen[bytes] | None = None

    def start(self, arguments: str = "uio_pdrv_genirq.of_id=generic-uio") -> None:
        for name in ("console", "serial"):
            (self.folder / name).unlink(missing_ok=True)
        boot = (f"console=ttyPS0,115200 root=/dev/mmcblk0 rw rootwait mem={LINUX_MEMORY} panic=-1 quiet "
                f"systemd.show_status=false systemd.default_timeout_start_sec={PATIENCE_S} {arguments}")
        self.started = time.monotonic()
        with (self.folder / "qemu.log").open("ab") as log:
            self.process = subprocess.Popen([*self._command, "-append", boot],
                                            stdin=subprocess.DEVNULL, stderr=log)
        while not all((self.folder / name).exists() for name in ("console", "serial")):
            check(self.process.poll() is None, "QEMU did not start")
            time.sleep(0.01)
        self.console = Stream(self.folder / "console")
        self.serial = Stream(self.folder / "serial")

    def cut(self) -> None:
        """Cuts the power."""
        assert self.process
        self.process.kill()
        self._ended()

    def shut_down(self) -> None:
        """Shuts down the system; QEMU ends at the reset."""
        assert self.process
        self.console.send(b"systemctl reboot\n")
        self.process.wait(PATIENCE_S)
        self._ended()

    def _ended(self) -> None:
        assert self.process
        self.process.wait()
        self.process = None
        self.console.close()
        self.serial.close()

    # --- console ---

    def log_in(self) -> None:
        """Waits for root's automatic login, and turns off the echo and the prompts of the shell."""
        self.console.until(rb"root@[^\n]*# ")
        self.console.send(b"exec sh\n")
        self.console.until(rb"\n# ")
        self.console.send(b"stty -echo; PS1=; PS2=; dmesg -n 1; echo quiet\\ now\n")
        self.console.until(rb"quiet now\r?\n")

    def run(self, command: str, patience_s: float = PATIENCE_S) -> str:
        """Returns the output of the command. Raises Failed if its status is not 0."""
        status, text = self.try_run(command, patience_s)
        check(status == 0, f"on the board: {command}: status {status}: {text}")
        return text

    def try_run(self, command: str, patience_s: float = PATIENCE_S) -> tuple[int, str]:
        with self._console_lock:
            number = next(self._numbers)
            self.console.send(f"echo '<<'{number}; {{ {command}\n}} 2>&1; echo '>>'{number} $?\n".encode())
            self.console.until(rb"<<%d\r?\n" % number)
            match = self.console.until(rb"(.*?)>>%d (\d+)\r?\n" % number, patience_s)
        return int(match[2]), match[1].decode(errors="replace").replace("\r\n", "\n").strip()

    # --- the protocol, on the second serial port ---

    def ask(self, line: str, patience_s: float = PATIENCE_S) -> str:
        """Sends a line and returns its reply."""
        self.serial.forget()
        self.serial.send(line.encode() + b"\r\n")
        return self.serial.until(rb"((?:OK|ERR)[^\r\n]*)\r?\n", patience_s)[1].decode()

    def wait_for_service(self) -> float:
        """Waits for the first reply. Returns the seconds since the power-on. Before the service opens the
        port, lines are lost or cut."""
        end = time.monotonic() + PATIENCE_S
        while True:
            check(self.process is not None and self.process.poll() is None, "QEMU has ended")
            check(time.monotonic() < end, "the service does not answer")
            try:
                self.ask("PING", 1)
                break
            except TimeoutError:
                continue
        took = time.monotonic() - self.started
        # Replies come in order, so after this one all earlier replies have come.
        self.serial.send(b"STATUS\r\n")
        self.serial.until(rb"OK accelerator=[^\r\n]*\r?\n")
        return took


class Memory:
    """The register page of the programmable logic, in the file that is the machine's memory."""

    def __init__(self, path: Path, address: int):
        with path.open("wb") as file:
            file.truncate(MEMORY_BYTES)
        self.path = path
        self.address = address
        with path.open("r+b") as file:
            self._map = mmap.mmap(file.fileno(), PAGE_BYTES, offset=address)
        self.words = memoryview(self._map).cast("I")

    def clear(self) -> None:
        self._map[:] = bytes(PAGE_BYTES)


class Player:
    """Runs board_player and raises the interrupt through the console."""

    def __init__(self, program: Path, memory: Memory, machine: Machine, *options: str):
        self._process = subprocess.Popen(
            [program, "--memory", memory.path, "--address", str(memory.address), *options],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        assert self._process.stdout
        self._machine = machine
        self._changed = threading.Condition()
        self.words: list[str] = []
        self.interrupts = 0
        self._trigger = ""  # a file on the board; if it is empty, no interrupt is raised
        line = self._process.stdout.readline()
        check(line == "ready\n", f"board_player says {line!r}")
        self._thread = threading.Thread(target=self._listen, daemon=True)
        self._thread.start()

    def _listen(self) -> None:
        assert self._process.stdout
        for line in self._process.stdout:
            kind, _, rest = line.strip().partition(" ")
            with self._changed:
                if kind == "words":
                    self.words = rest.split()
                elif kind == "interrupt":
                    self.interrupts = int(rest)
                self._changed.notify_all()
            if kind == "interrupt":
                self._raise()

    def _raise(self) -> None:
        if self._trigger:
            try:
                self._machine.try_run(f"echo trigger > {self._trigger}")
            except (Failed, OSError, TimeoutError, ValueError):
                self._trigger = ""  # the machine has ended

    def raise_through(self, trigger: str) -> None:
        """Raises interrupts through this file on the board. The line is level-triggered, so an earlier
        interrupt is raised, too."""
        self._trigger = trigger
        if self.interrupts:
            self._raise()

    def wait(self, what: str, condition) -> None:
        with self._changed:
            check(self._changed.wait_for(condition, PATIENCE_S), f"{what}: did not come")

    def close(self) -> None:
        assert self._process.stdin and self._process.stdout
        self._process.stdin.close()
        self._process.wait()
        self._thread.join()
        self._process.stdout.close()


def shell(machine: Machine) -> None:
    """Connects the terminal to the console until the machine ends or Ctrl-]."""
    import termios
    import tty
    before = termios.tcgetattr(sys.stdin)
    tty.setraw(sys.stdin)
    try:
        while machine.process and machine.process.poll() is None:
            ready = select.select([sys.stdin, machine.console], [], [], 0.5)[0]
            if machine.console in ready:
                os.write(sys.stdout.fileno(), machine.console.receive())
            if sys.stdin in ready:
                typed = os.read(sys.stdin.fileno(), 1024)
                if b"\x1d" in typed or not typed:
                    return
                machine.console.send(typed)
    finally:
        termios.tcsetattr(sys.stdin, termios.TCSADRAIN, before)
