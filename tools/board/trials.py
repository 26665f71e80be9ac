# SPDX-License-Identifier: MIT
"""The trials on the virtual board. Each function is a row of the table TRIALS.

A trial takes the Board, raises Failed if something is wrong, and returns the remark for its row."""

import random
import re
import time

import panel_trials
from fixture import CAPABILITY_WORD, ID_WORD, Board, wait_for_words, wait_until
from machine import Failed, check

PROTOCOL_ID = 0x524D4152
STORM = 20  # the number of interrupts that the service must take
DRIVER = "/sys/bus/platform/drivers/uio_pdrv_genirq"

FRAMES = [
    "FX=0,FY=0,FZ=1,RX=1,RY=0,RZ=0,UX=0,UY=1,UZ=0,ZM=3,LX=3,LY=2,LZ=5,R=1,G=1,B=1,OBJ=sphere",
    "FX=0,FY=0.342,FZ=0.940,RX=1,RY=0,RZ=0,UX=0,UY=0.940,UZ=-0.342,ZM=2.5,LX=3,LY=2,LZ=5,R=1,G=0.498,B=0,OBJ=cube",
    "FX=0.866,FY=0,FZ=0.5,RX=0.5,RY=0,RZ=-0.866,UX=0,UY=1,UZ=0,ZM=10,LX=-63,LY=63,LZ=0.125,R=0,G=0.25,B=1,"
    "OBJ=infinite_cube",
    "FX=0,FY=0,FZ=-1,RX=-1,RY=0,RZ=0,UX=0,UY=1,UZ=0,ZM=0,LX=0,LY=0,LZ=-4,R=0.2,G=0.4,B=0.6,OBJ=tunnel",
]


def install(board: Board) -> str:
    """Installs the package on a new card. The service starts at the next boot."""
    machine = board.machine
    machine.start()
    machine.log_in()
    machine.run("dpkg -i /root/raymarchd.deb")
    check(machine.try_run("systemctl is-enabled raymarchd")[1] == "enabled", "the service is not enabled")
    check(machine.try_run("systemctl is-active raymarchd")[1] == "inactive", "the service was started")
    check(machine.run("stat -c %a:%U /usr/sbin/raymarchd") == "755:root", "raymarchd is not root's")
    # Here the console keeps its login, and the service uses the other port.
    machine.run("mkdir -p /etc/systemd/system/raymarchd.service.d && "
                "ln -s /dev/null /etc/systemd/system/raymarchd.service.d/console.conf")
    machine.run("echo 'serial = \"/dev/ttyPS1@115200\"' >> /etc/raymarchd.toml && raymarchd --check-config")
    machine.shut_down()
    return board.package.name


def power_on(board: Board) -> str:
    board.memory.clear()
    board.play()
    board.machine.start()
    took = board.machine.wait_for_service()
    board.machine.log_in()
    ready = int(board.machine.run("systemctl show -p ActiveEnterTimestampMonotonic --value raymarchd")) / 1e6
    # The machine's clock is slower or faster than real time.
    uptime, on = float(board.machine.run("cut -d' ' -f1 /proc/uptime")), time.monotonic() - board.machine.started
    status = board.status()
    check(status["gpio"] == "up", f"the lines: {status}")
    check(status["hardware"] == "ok" and status["block"] == "extended", f"the registers: {status}")
    check(board.machine.run("systemctl show -p User --value raymarchd") == "raymarchd", "not its own user")
    link = board.machine.run("readlink -f /dev/raymarch")
    check(re.fullmatch(r"/dev/uio\d+", link) is not None, f"/dev/raymarch is {link}")
    return f"READY {ready * on / uptime:.1f} s, first answer {took:.1f} s after power-on"


def resident(board: Board) -> str:
    fields = board.machine.run(f"grep -E 'VmHWM|VmRSS|RssAnon' /proc/{board.pid()}/status").split()
    sizes = dict(zip((f.rstrip(":") for f in fields[0::3]), map(int, fields[1::3])))
    check(sizes["VmRSS"] <= 6144, f"more than 6 MB resident: {sizes}")
    return ", ".join(f"{key} {value} kB" for key, value in sizes.items())


def overlay(board: Board) -> str:
    """`overlay status` on a real kernel that cannot load logic while it runs."""
    rows = board.machine.run("raymarchctl overlay status")
    for wanted in (r"registers +/dev/uio\d+, 4096 bytes at 0x43C00000", r"clock +kept", r"missing +\S*/fpga_manager/",
                   r"missing +\S*/device-tree/overlays"):
        check(re.search(wanted, rows) is not None, f"{wanted} is not in: {rows}")
    return "registers and clock found, the two features named that this kernel lacks"


def frames(board: Board) -> str:
    generator = random.Random(1)
    lines = list(FRAMES)
    for _ in range(30):
        values = [f"{generator.uniform(-1, 1):.4f}" for _ in range(9)]
        names = ("FX", "FY", "FZ", "RX", "RY", "RZ", "UX", "UY", "UZ")
        lines.append(",".join(f"{name}={value}" for name, value in zip(names, values)) +
                     f",ZM={generator.uniform(0, 10):.5f},LX={generator.uniform(-60, 60):.2f},LY=1,LZ=2,"
                     f"R={generator.random():.3f},G={generator.random():.3f},B={generator.random():.3f},"
                     f"OBJ={generator.choice(['sphere', 'cube', 'infinite_cube', 'tunnel'])}")
    for line in lines:
        reply = board.machine.ask(line)
        check(reply.startswith("OK"), f"{line}: {reply}")
        wanted = board.words_of(line)
        check(len(wanted) == 8, f"{line}: encode says {wanted}")
        wait_for_words(board, wanted)
    return f"{len(lines)} frames, {8 * len(lines)} words at 0x{board.memory.address:08X}"


def show(board: Board, line: str) -> None:
    """Sends a line and waits for its picture."""
    player = board.player
    assert player
    wanted = [f"{word:08X}" for word in board.words_of(line)]
    reply = board.machine.ask(line)
    check(reply.startswith("OK"), f"{line}: {reply}")
    player.wait("the words", lambda: player.words == wanted)
    rendered = board.machine.folder / "rendered.png"
    board.tool("render", "--registers", *wanted, "--size", "160x120", "-o", str(rendered))
    wait_until(lambda: board.picture.exists() and board.picture.read_bytes() == rendered.read_bytes(),
               lambda: f"{line}: the picture is another one")


def pictures(board: Board) -> str:
    """Text on a UART becomes a picture, through a real kernel."""
    assert board.player
    trigger, before = board.interrupt()
    board.player.raise_through(trigger)
    show(board, FRAMES[-1])  # so that each of the next frames is a new one
    drawn_before = int(board.status()["frames"])
    for line in FRAMES:
        show(board, line)
    wait_until(lambda: int(board.status()["frames"]) >= drawn_before + len(FRAMES),
               lambda: f"FRAMES are {board.status()['frames']}, before {drawn_before}")
    drawn = int(board.status()["frames"]) - drawn_before
    after = board.interrupt()[1]
    check(after > before, "no interrupt came")
    return f"{len(FRAMES)} pictures as raymarchctl draws them, FRAMES {drawn}, interrupts {after - before}"


def mismatch(board: Board) -> str:
    """One bit of the logic is stuck. The service detects it by its read-back."""
    errors = int(board.status()["readback_errors"])
    board.stop_playing()
    word = board.memory.words
    tries = 0
    stuck = word[1] ^ 1
    for tries in range(1, 201):
        board.machine.serial.forget()
        board.machine.serial.send(f"SET ZM={tries % 9 + 0.5}\r\n".encode())
        end = time.monotonic() + 5
        while time.monotonic() < end:
            for _ in range(20000):
                word[1] = stuck
            try:
                reply = board.machine.serial.until(rb"((?:OK|ERR)[^\r\n]*)\r?\n", 0)[1]
                break
            except TimeoutError:
                continue
        else:
            raise Failed("no reply")
        if reply.startswith(b"ERR HARDWARE"):
            break
    else:
        raise Failed("never ERR HARDWARE")
    status = board.status()
    check(status["hardware"] == "fault", f"STATUS: {status}")
    check(int(status["readback_errors"]) > errors, f"STATUS: {status}")
    board.play_again()
    check(board.machine.ask(FRAMES[0]).startswith("OK"), "a frame afterwards")
    wait_for_words(board, board.words_of(FRAMES[0]))
    return f"ERR HARDWARE at try {tries}, hardware=fault, then ok again"


def storm(board: Board) -> str:
    """The interrupt is raised as fast as possible. The service arms it only while a commit is pending, so
    the pictures are large, and frames come faster than pictures."""
    board.play_again("--width", "1280", "--height", "720")
    errors = board.status()["readback_errors"]
    trigger = board.interrupt()[0]

    def taken() -> int:
        return int(board.status()["interrupts"])
    before = taken()
    board.machine.run("rm -f /run/calm; (n=0; while [ ! -e /run/calm ]; do echo trigger; n=$((n+1)); "
                      f"echo $n > /run/raised; done > {trigger}) & true")
    sent = 0
    try:
        while taken() < before + STORM:
            line = FRAMES[sent % len(FRAMES)]
            reply = board.machine.ask(line)
            check(reply.startswith("OK"), f"{line}: {reply}")
            sent += 1
        wait_for_words(board, board.words_of(line))
    finally:
        raised = board.machine.run("touch /run/calm; wait; cat /run/raised").split()[-1]
    status = board.status()
    check(status["hardware"] == "ok" and status["readback_errors"] == errors, f"the registers: {status}")
    count = taken() - before
    board.play_again()
    return f"raised {raised} times, {count} taken among {sent} frames, all answered, the last one's words there"


PROBES = {
    "a socket of the network": "perl -MSocket -e 'socket(S, PF_INET, SOCK_STREAM, 0) or exit 1'",
    "another device, /dev/mem": "true < /dev/mem",
    "another device, the card": "true < /dev/mmcblk0",
    "a home directory": "ls /root",
    "a file in /etc": "touch /etc/probe",
    "the configuration": "echo >> /etc/raymarchd.toml",
    "a setting of the kernel": "echo 1 > /proc/sys/vm/swappiness",
    "a file that runs as its owner": "cp /bin/true /tmp/t && chmod u+s /tmp/t",
    "a mount": "mount -t tmpfs none /tmp && umount /tmp",
    "a namespace": "unshare -U true",
    "the clock": "date -s \"$(date)\"",
    "the host's name": "hostname \"$(hostname)\"",
    "the kernel's log": "dmesg",
    "a control group": "mkdir /sys/fs/cgroup/probe && rmdir /sys/fs/cgroup/probe",
    "a priority of real time": "chrt -f 1 true",
    "a socket of netlink": "perl -MSocket -e 'socket(S, 16, SOCK_RAW, 0) or exit 1'",
    "memory to write and run": "perl -e 'exit(syscall(192, 0, 4096, 7, 34, -1, 0) == -1)'",
    "another personality": "perl -e 'exit(syscall(136, 8) == -1)'",
}
# Nothing is hidden from root's group.
PROBES_OF_USER = {"another's process": "test -e /proc/1/status"}
ALLOWED = {
    "the registers": "true <> /dev/raymarch",
    "the GPIO chips": "for c in /dev/gpiochip*; do true <> $c || exit 1; done",
    "its state": "touch /var/lib/raymarchd/probe && rm /var/lib/raymarchd/probe",
    "the device tree": "grep -q zynq /sys/firmware/devicetree/base/compatible",
}
ALLOWED_TO_LOAD = {
    "the firmware folder": "touch /lib/firmware/probe && rm /lib/firmware/probe",
    "configfs": "mkdir /sys/kernel/config/gpio-sim/probe && rmdir /sys/kernel/config/gpio-sim/probe",
    "udev's devices": "udevadm settle --timeout=60",
    # The shell's status is 2 if it may not open the file, and 1 if the driver knows no such device.
    "the driver's devices": f"echo none > {DRIVER}/unbind; [ $? -eq 1 ]",
}


def unit_of_probe(unit: str, user: str) -> str:
    """Makes a unit that runs a script with the restrictions of another unit. As root, a refusal comes from
    the restrictions and not from permissions. The service's folders keep their owner."""
    drop = "WatchdogSec|Restart|RemainAfter|Condition|Exec|RuntimeDirectory"
    if user == "root":
        drop += "|User|Group|Supp|StateDir"
    return (f"sed -E -e 's/^Type=.*/Type=oneshot/; /^({drop})/d' "
            f"-e 's|^\\[Service\\]|&\\nExecStart=/bin/sh /run/probe.sh|' /lib/systemd/system/{unit} "
            "> /run/systemd/system/probe.service && systemctl daemon-reload")


def sandbox(board: Board) -> str:
    """Probes the restrictions of the units. Each probe works without them."""
    machine = board.machine
    for unit, user, allowed, table in (("raymarchd.service", "root", False, PROBES),
                                       ("raymarchd.service", "raymarchd", False, PROBES_OF_USER),
                                       ("raymarchd.service", "raymarchd", True, ALLOWED),
                                       ("raymarch-overlay.service", "root", True, ALLOWED_TO_LOAD)):
        machine.run(unit_of_probe(unit, user))
        machine.run("echo true > /run/probe.sh && systemctl start probe.service")
        for name, command in table.items():
            machine.run(f"cat > /run/probe.sh <<'END'\n{command}\nEND")
            check(machine.try_run("sh /run/probe.sh")[0] == 0, f"{name}: refused without restrictions, too")
            machine.try_run("systemctl start probe.service")
            status = int(machine.run("systemctl show -p ExecMainStatus --value probe.service"))
            result = machine.run("systemctl show -p Result --value probe.service")
            wanted = result == "success" if allowed else result == "exit-code" and 0 < status < 200
            check(wanted, f"{unit}, {name}: {result}, status {status}")
    refused = PROBES | PROBES_OF_USER
    return f"{len(refused)} refused: {'; '.join(refused)}. {len(ALLOWED) + len(ALLOWED_TO_LOAD)} needed and allowed"


def kill(board: Board) -> str:
    before = board.pid()
    board.machine.ask(FRAMES[1])
    check(board.machine.ask("SAVE").startswith("OK"), "SAVE")
    board.stop_playing()
    board.play()  # with its initial words, so that the service must write the words again
    check(list(board.memory.words[:8]) != board.words_of(FRAMES[1]), "the words are there already")
    board.machine.run(f"kill -9 {before}")
    board.wait_for_restart(before)
    board.machine.wait_for_service()
    wait_for_words(board, board.words_of(FRAMES[1]))
    return "restarted, the saved state in the registers"


def watchdog(board: Board) -> str:
    before = board.pid()
    begun = time.monotonic()
    board.machine.run(f"kill -STOP {before}")
    board.wait_for_restart(before)
    took = time.monotonic() - begun
    board.machine.wait_for_service()
    check("watchdog" in board.machine.run("journalctl -u raymarchd -n 50 --no-pager").lower(),
          "the journal does not say watchdog")
    return f"stopped process replaced after {took:.0f} s"


def hang_up(board: Board) -> str:
    machine = board.machine
    zoom = board.present()["ZM"]
    machine.serial.send(b"SET ZM=")  # half a line before the hang-up
    machine.run("perl -e 'open(F, \"+<\", \"/dev/ttyPS1\") and ioctl(F, 0x5437, 0) or exit 1'")  # TIOCVHANGUP
    machine.run("until journalctl -u raymarchd -n 20 --no-pager | grep -q 'serial port has gone'; do sleep 0.2; done")
    machine.run("until raymarchctl status | grep -q 'serial *up'; do sleep 0.2; done")
    machine.serial.forget()
    reply = machine.ask("9.5")  # the other half
    check(reply.startswith("ERR"), f"two halves of a line were joined: {reply}")
    check(board.present()["ZM"] == zoom, "two halves of a line were joined")
    return "in the middle of a line, which is dropped; noticed, opened again, answered"


def absent(board: Board) -> str:
    """Boots without the accelerator. Its driver comes first, then its logic."""
    machine = board.machine
    machine.shut_down()
    board.stop_playing()
    board.memory.clear()
    board.memory.words[ID_WORD] = PROTOCOL_ID
    board.memory.words[CAPABILITY_WORD] = 0xEE000000  # an unknown kind
    machine.start(arguments="")
    machine.wait_for_service()
    machine.log_in()
    check(board.status()["hardware"] == "absent", "there is hardware")
    panel_trials.Lines(board).wait("led2", True)
    reply = machine.ask(FRAMES[2])
    check(reply.startswith("ERR HARDWARE"), f"a frame without hardware: {reply}")
    device = f"{board.memory.address:x}.raymarch"
    machine.run(f"echo uio_pdrv_genirq > /sys/bus/platform/devices/{device}/driver_override && "
                f"echo {device} > {DRIVER}/bind")
    machine.run("until journalctl -u raymarchd -b --no-pager | grep -q 'accelerator kind 238'; do sleep 0.2; done")
    check(board.status()["hardware"] == "absent", "an unknown kind is taken")
    board.play()
    board.wait_for_status("hardware", "ok")
    present = board.machine.ask("GET").removeprefix("OK ")
    wait_for_words(board, board.words_of(present))
    check(machine.ask(FRAMES[2]).startswith("OK"), "a frame")  # the last one was refused
    panel_trials.Lines(board).wait("led2", False)
    return "absent, LD2 lit; then of an unknown kind; then there: the present state in the registers"


def power_cuts(board: Board) -> str:
    """The power is cut during writes of the state. Afterwards the last saved state is there, or the one
    that was being saved."""
    machine = board.machine
    generator = random.Random(2)
    writes = within = 0
    check(machine.ask("SET ZM=0").startswith("OK") and machine.ask("SAVE").startswith("OK"), "SAVE")
    saved = 0
    for cut in range(board.cuts):
        # The cut comes during the write after a few others. Each takes some ten milliseconds.
        number, delay = generator.randrange(1, 6), generator.uniform(0, 0.1)
        for _ in range(number):
            saved = (saved + 1) % 1000
            for line in (f"SET ZM={saved / 128:.7f}", "SAVE"):
                reply = machine.ask(line)
                check(reply.startswith("OK"), f"{line}: {reply}")
            writes += 1
        sent = (saved + 1) % 1000
        reply = machine.ask(f"SET ZM={sent / 128:.7f}")
        check(reply.startswith("OK"), f"SET: {reply}")
        machine.serial.send(b"SAVE\r\n")
        try:
            machine.serial.until(rb"OK[^\r\n]*\r?\n", delay)
            saved = sent
        except TimeoutError:
            within += 1
        machine.cut()
        machine.start()
        machine.wait_for_service()
        board.wait_for_status("hardware", "ok")
        found = round(float(board.present()["ZM"]) * 128)
        check(found in (saved, sent), f"cut {cut + 1}: {found}/128, saved was {saved}, sent {sent}")
        wait_for_words(board, board.words_of(machine.ask("GET").removeprefix("OK ")))
        machine.log_in()
        log = machine.run("journalctl -u raymarchd -b --no-pager -q")
        check("starting from the defaults" not in log, f"cut {cut + 1}: a state file was refused")
        saved = found
    check(within > 0, "no cut came within a write")
    return (f"{board.cuts} cuts among {writes} writes of the state, {within} before the write was answered; "
            "each state found whole, and no older than what was saved")


def life(board: Board) -> str:
    """Upgrades, removes and purges the package on a running system."""
    machine = board.machine
    before = board.pid()
    machine.run("dpkg -i /root/raymarchd.deb")
    board.wait_for_restart(before)
    machine.wait_for_service()
    check("ttyPS1" in machine.run("cat /etc/raymarchd.toml"), "the upgrade took the configuration")
    machine.run("dpkg -r raymarchd")
    check(machine.try_run("pgrep -x raymarchd")[0] != 0, "removed, and still running")
    machine.run("test -e /etc/raymarchd.toml && test -d /var/lib/raymarchd")
    machine.run("rm -r /etc/systemd/system/raymarchd.service.d && dpkg -P raymarchd")
    left = machine.run("find /etc /lib /usr /var /run/raymarchd* -xdev -iname '*raymarch*' "
                       "-not -path '/var/log/*' 2> /dev/null; true")
    check(left == "", f"purge left: {left}")
    check(machine.try_run("systemctl status raymarchd")[0] == 4, "systemd still knows the service")
    return "an upgrade restarts the service and keeps its configuration; purge leaves nothing"


def login(board: Board) -> str:
    """Tests console.conf of the package, with the port that the service uses here."""
    machine = board.machine
    drop = "/etc/systemd/system/raymarchd.service.d/console.conf"
    machine.run(f"rm {drop} && sed s/ttyPS0/ttyPS1/ /lib/systemd/system/raymarchd.service.d/console.conf > {drop} && "
                "systemctl enable serial-getty@ttyPS1")
    machine.shut_down()
    machine.start()
    machine.wait_for_service()
    machine.log_in()
    getty = "systemctl is-active serial-getty@ttyPS1"
    check(machine.try_run(getty)[1] == "inactive", "the login has the port at the start")
    machine.run("systemctl start serial-getty@ttyPS1")
    check(machine.try_run("systemctl is-active raymarchd")[1] != "active", "both have the port")
    machine.serial.until(rb"login: ")
    machine.run("systemctl start raymarchd")
    check(machine.try_run(getty)[1] == "inactive", "both have the port")
    machine.wait_for_service()
    board.wait_for_status("serial", "up")
    machine.run("systemctl disable serial-getty@ttyPS1; "
                f"rm {drop} && ln -s /dev/null {drop} && systemctl daemon-reload")
    return "it gives way at the start; each takes the port from the other when asked to"


TRIALS = {
    "package installed with dpkg": install,
    "power-on to READY": power_on,
    "resident memory": resident,
    "overlay status": overlay,
    "frames become words": frames,
    "words become pictures": pictures,
    **panel_trials.TRIALS,
    "read-back mismatch": mismatch,
    "interrupt storm": storm,
    "restrictions bite": sandbox,
    "kill -9": kill,
    "watchdog": watchdog,
    "serial port hangs up": hang_up,
    "accelerator absent, then there": absent,
    "login on the service's port": login,
    "power cuts": power_cuts,
    "package upgraded, removed, purged": life,
}

# The short trials of one boot.
SHORT = ["resident memory", "overlay status", "frames become words", "words become pictures",
         *panel_trials.TRIALS, "kill -9"]
