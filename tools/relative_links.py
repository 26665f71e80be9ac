#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the absolute symbolic links of an extracted root file system relative, so that a cross
linker that looks into it does not leave it."""

import os
import sys
from pathlib import Path


def main() -> int:
    root = Path(sys.argv[1]).resolve()
    for folder, folders, files in os.walk(root):
        for name in folders + files:
            link = Path(folder) / name
            if not link.is_symlink() or not os.readlink(link).startswith("/"):
                continue
            target = root / os.readlink(link).lstrip("/")
            link.unlink()
            link.symlink_to(os.path.relpath(target, link.parent))
    return 0


if __name__ == "__main__":
    sys.exit(main())
