# SPDX-License-Identifier: MIT
"""The packages and symbols of the two releases that the board's package must run on: Ubuntu 22.04 (jammy),
which PYNQ's image uses, and Debian 12 (bookworm). The versions are those of the day of the release.
"""

import re
import subprocess

# Each package has its version in jammy and in bookworm, for armhf.
PACKAGES = {
    "libc6": ("2.35-0ubuntu3", "2.36-9"),
    "libedit2": ("3.1-20210910-1build1", "3.1-20221030-2"),
    "libgcc-s1": ("12-20220319-1ubuntu1", "12.2.0-14"),
    "libgpiod2": ("1.6.3-1build1", "1.6.3-1+b3"),
    "libpng16-16": ("1.6.37-3build5", "1.6.39-2"),
    "libstdc++6": ("12-20220319-1ubuntu1", "12.2.0-14"),
    "libsystemd0": ("249.11-0ubuntu3", "252.6-1"),
    "systemd": ("249.11-0ubuntu3", "252.6-1"),
    "udev": ("249.11-0ubuntu3", "252.6-1"),
}

# The newest symbol version of each library in the older release.
SYMBOLS = {
    "GLIBC": (2, 35),
    "GLIBCXX": (3, 4, 30),
    "CXXABI": (1, 3, 13),
    "CXXABI_ARM": (1, 3, 3),
    "GCC": (12, 0, 0),
    "LIBSYSTEMD": (249,),
    "PNG16": (0,),
}


def is_at_least(version: str, wanted: str) -> bool:
    return subprocess.run(["dpkg", "--compare-versions", version, "ge", wanted]).returncode == 0


def depends_faults(depends: str) -> list[str]:
    """Returns the packages of a Depends line, or their versions, that one of the releases lacks."""
    faults = []
    for clause in filter(None, (part.strip() for part in depends.split(","))):
        form = re.fullmatch(r"([a-z0-9][a-z0-9+.-]+)(?: \(>= (\S+)\))?", clause)
        if form is None:
            faults.append(f"depends on '{clause}', which is not of the form 'package (>= version)'")
            continue
        name, wanted = form.groups()
        if name not in PACKAGES:
            faults.append(f"depends on {name}, which tools/package/releases.py does not know in both releases")
        elif wanted is not None and not all(is_at_least(version, wanted) for version in PACKAGES[name]):
            faults.append(f"depends on {clause}; the two releases have {' and '.join(PACKAGES[name])}")
    return faults


def symbol_faults(needed: list[str]) -> list[str]:
    """Returns the needed symbol versions that the older release lacks."""
    faults = []
    for version in sorted(set(needed)):
        library, _, number = version.rpartition("_")
        if library not in SYMBOLS or re.fullmatch(r"\d+(\.\d+)*", number) is None:
            faults.append(f"needs symbols of {version}, which tools/package/releases.py does not know")
        elif tuple(map(int, number.split("."))) > SYMBOLS[library]:
            newest = ".".join(map(str, SYMBOLS[library]))
            faults.append(f"needs symbols of {version}; the older release has {library}_{newest}")
    return faults


def newest(needed: list[str]) -> str:
    """Returns the newest symbol version of each library, for the output."""
    best: dict[str, tuple[int, ...]] = {}
    for version in needed:
        library, _, number = version.rpartition("_")
        best[library] = max(best.get(library, ()), tuple(int(part) for part in re.findall(r"\d+", number)))
    return ", ".join(f"{library}_{'.'.join(map(str, number))}" for library, number in sorted(best.items()))
