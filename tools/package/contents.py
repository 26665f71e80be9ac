#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks Debian packages: required files, owners and modes, stripped programs, no paths of the build
machine, and that the board's package runs on the releases of releases.py.

Usage: contents.py [--made-in FOLDER]... [--board] PACKAGE.deb...

No file may contain a FOLDER: that of the sources, the build or the sysroot. --board checks a package of any
architecture like the board's package.
"""

import argparse
import fnmatch
import gzip
import io
import re
import subprocess
import sys
import tarfile
import tempfile
from pathlib import Path

from releases import depends_faults, newest, symbol_faults

# The files of each package; * is the architecture in Debian's folder names.
REQUIRED = {
    "raymarchd": [
        "etc/raymarchd.toml",
        "usr/bin/raymarchctl",
        "usr/lib/firmware/raymarch.dtbo",
        "usr/lib/firmware/raymarch_clock.dtbo",
        "usr/lib/modprobe.d/raymarchd.conf",
        "usr/lib/systemd/system/bootpy.service.d/raymarchd.conf",
        "usr/lib/systemd/system/raymarch-overlay.service",
        "usr/lib/systemd/system/raymarchd.service",
        "usr/lib/systemd/system/raymarchd.service.d/console.conf",
        "usr/lib/sysusers.d/raymarchd.conf",
        "usr/lib/udev/rules.d/60-raymarchd.rules",
        "usr/sbin/raymarchd",
        "usr/share/bash-completion/completions/raymarchctl",
        "usr/share/bash-completion/completions/raymarchd",
        "usr/share/doc/raymarchd/changelog.gz",
        "usr/share/doc/raymarchd/copyright",
        "usr/share/man/man1/raymarchctl.1.gz",
        "usr/share/man/man8/raymarchd.8.gz",
    ],
    "raymarchd-pictures": [
        "usr/lib/*/raymarchd/libraymarch_pictures.so",
        "usr/share/doc/raymarchd-pictures/changelog.gz",
        "usr/share/doc/raymarchd-pictures/copyright",
    ],
}
MAY_BE_MORE = {"raymarchd-pictures": ["usr/lib/*/raymarchd/libraymarch_video.so"]}


def output(*command: str, data: bytes | None = None) -> bytes:
    return subprocess.run(command, input=data, check=True, stdout=subprocess.PIPE).stdout


def field(package: Path, name: str) -> str:
    return output("dpkg-deb", "-f", str(package), name).decode().strip()


def entry_faults(entry: tarfile.TarInfo) -> list[str]:
    """Returns the faults of owner, kind and mode."""
    path = entry.name.removeprefix("./")
    program = re.fullmatch(r"usr/s?bin/[^/]+", path) is not None
    wanted = 0o755 if entry.isdir() or program else 0o644
    faults = []
    if (entry.uid, entry.gid) != (0, 0):
        faults.append(f"belongs to {entry.uid}:{entry.gid}")
    if not (entry.isdir() or entry.isreg()):
        faults.append("is neither file nor folder")
    if entry.mode != wanted:
        faults.append(f"has mode {entry.mode:o}, not {wanted:o}")
    return faults


def content_faults(content: bytes, folders: list[str]) -> list[str]:
    """Returns the faults of a file's content."""
    faults = []
    if content.startswith(b"\x7fELF"):
        if b"not stripped" in output("file", "-b", "-", data=content):
            faults.append("is not stripped")
    if content.startswith(b"\x1f\x8b"):
        content = gzip.decompress(content)
    return faults + [f"names {folder}" for folder in folders if folder.encode() in content]


def versions_needed(program: bytes) -> list[str]:
    """Returns the symbol versions that a program needs from libraries, such as GLIBC_2.34."""
    with tempfile.NamedTemporaryFile() as file:
        file.write(program)
        file.flush()
        _, _, needs = output("readelf", "-W", "-V", file.name).decode().partition("Version needs section")
    return re.findall(r"Name: (\S+)\s+Flags:", needs)


def package_faults(package: Path, folders: list[str], board: bool) -> list[str]:
    faults = []
    name = field(package, "Package")
    depends = field(package, "Depends")
    board = name == "raymarchd" and (board or field(package, "Architecture") == "armhf")
    files = []
    needed = []
    with tarfile.open(fileobj=io.BytesIO(output("dpkg-deb", "--fsys-tarfile", str(package)))) as tree:
        for entry in tree:
            found = entry_faults(entry)
            if entry.isreg():
                files.append(entry.name.removeprefix("./"))
                content = tree.extractfile(entry)
                assert content is not None
                data = content.read()
                found += content_faults(data, folders)
                if board and data.startswith(b"\x7fELF"):
                    versions = versions_needed(data)
                    needed += versions
                    found += symbol_faults(versions)
            faults += [f"{entry.name} {fault}" for fault in found]
    faults += [f"lacks {path}" for path in REQUIRED[name] if not fnmatch.filter(files, path)]
    allowed = REQUIRED[name] + MAY_BE_MORE.get(name, [])
    expected = {file for path in allowed for file in fnmatch.filter(files, path)}
    faults += [f"{file} is not expected" for file in files if file not in expected]
    # These names differ between releases.
    faults += [f"depends on {library}" for library in re.findall(r"libfmt\d+", depends)]
    if name == "raymarchd-pictures":
        has_video = any(file.endswith("/libraymarch_video.so") for file in files)
        says_video = "and MP4 for" in field(package, "Description")
        if has_video != says_video:
            faults.append(f"its description {'says' if says_video else 'does not say'} that it writes MP4")
    if name == "raymarchd" and "opencv" in depends:
        faults.append("depends on OpenCV")
    if board:
        faults += depends_faults(depends)
        print(f"{package.name}: {depends}; {newest(needed)}")
    return [f"{package.name}: {fault}" for fault in faults]


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--made-in", action="append", default=[], metavar="FOLDER")
    parser.add_argument("--board", action="store_true")
    parser.add_argument("packages", nargs="+", type=Path, metavar="PACKAGE")
    options = parser.parse_args()
    faults = [
        fault
        for package in options.packages
        for fault in package_faults(package, options.made_in, options.board)
    ]
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
