#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Dependencies point down: says which folder includes what it may not.

The include root is the root of the repository, so linking alone does not stop a wrong include.
The same table stands in the link lines of the folders' CMakeLists.txt."""

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

# The engine knows of the protocol what parameters and registers are, and the descriptions.
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

# Words that must not occur: the pure folders have no I/O and no clock, the engine no floating point, but
# for its kernels, which prove where they use it.
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
