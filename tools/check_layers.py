#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the layers: prints every include of a folder that the including folder may not use.

The include root is the root of the repository, so linking alone does not stop a wrong include.
The link lines in the folders' CMakeLists.txt have the same dependencies."""

import re
import sys
from pathlib import Path

# folder -> folders whose headers it may include besides its own
LAYERS: dict[str, set[str]] = {
    "base": set(),
    "command_line": {"base"},
    "protocol": {"base"},
    "drivers": {"base"},
    "board": {"base", "drivers"},
    "engine": {"base", "protocol"},
    "motion": {"base", "engine", "protocol"},
    "pictures": {"base", "engine"},
    "emulation": {"base", "drivers", "engine", "protocol"},
    "conformance": {"base", "protocol"},
    "daemon": {
        "base",
        "board",
        "command_line",
        "drivers",
        "emulation",
        "engine",
        "motion",
        "pictures",
        "protocol",
    },
    "cli": {
        "base",
        "board",
        "command_line",
        "conformance",
        "drivers",
        "engine",
        "motion",
        "pictures",
        "protocol",
    },
    "tools": {"base", "cli", "command_line", "daemon", "drivers", "emulation", "engine", "motion", "pictures", "protocol"},
}

# The engine uses only the parameters, the registers and the descriptions of the protocol.
ENGINE_MAY_INCLUDE = re.compile(r"protocol/(parameters|registers|accelerators|accelerators/\w+)\.hpp")

# System headers that only some folders may use.
RESTRICTED: dict[str, set[str]] = {
    "systemd/": {"daemon"},
    "gpiod": {"drivers"},
    "opencv2/": {"pictures"},
    "png.h": {"pictures"},
    "CLI/": {"command_line", "daemon", "cli", "tools"},
    "thread": {"base", "engine", "emulation", "daemon", "cli"},
}

# Words that must not occur: these folders have no I/O and no clock, and the engine has no floating point
# outside its kernels.
FORBIDDEN: dict[str, re.Pattern[str]] = {
    "protocol": re.compile(r"#include <(unistd|fcntl|chrono|iostream|fstream|thread|cstdio)"),
    "engine": re.compile(r"\b(float|double)\b|#include <(unistd|fcntl|chrono|iostream|fstream|cstdio|cmath)"),
}


def problems(root: Path) -> list[str]:
    found: list[str] = []
    for folder, allowed in LAYERS.items():
        for path in sorted((root / folder).rglob("*.[ch]pp")):
            for number, line in enumerate(path.read_text().splitlines(), 1):
                where = f"{path.relative_to(root)}:{number}"
                code = line.split("//")[0]
                if match := re.match(r'#include "(\w+)/([^"]+)"', code):
                    target = match[1]
                    if target != folder and target not in allowed:
                        found.append(f"{where}: {folder}/ may not include {target}/")
                    if folder == "engine" and target == "protocol" and not ENGINE_MAY_INCLUDE.search(code):
                        found.append(f"{where}: engine/ may not include this of protocol/")
                for header, folders in RESTRICTED.items():
                    if code.startswith(f"#include <{header}") and folder not in folders:
                        found.append(f"{where}: {folder}/ may not include <{header}…>")
                if folder in FORBIDDEN and "fast" not in path.parts and FORBIDDEN[folder].search(code):
                    found.append(f"{where}: not in {folder}/: {code.strip()}")
    return found


def main() -> int:
    root = Path(__file__).resolve().parent.parent
    found = problems(root)
    print("\n".join(found) if found else "layers: clean")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
