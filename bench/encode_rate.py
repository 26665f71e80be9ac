#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Question: how many frames a second does `raymarchctl encode` turn into words?

    encode_rate.py RAYMARCHCTL [LINES]
"""
import json
import subprocess
import sys
import tempfile
import time
from itertools import cycle, islice
from pathlib import Path

from frame_path import read_frames


def main() -> None:
    program = Path(sys.argv[1])
    lines = int(sys.argv[2]) if len(sys.argv) > 2 else 200_000
    if not program.is_file():
        print(f"encode_rate: skipped, {program.name} has not been built", file=sys.stderr)
        return
    with tempfile.TemporaryFile() as frames, tempfile.TemporaryFile() as replies:
        frames.writelines(islice(cycle(read_frames()), lines))
        frames.seek(0)
        begin = time.perf_counter()
        done = subprocess.run([program, "encode"], stdin=frames, stdout=replies, check=False)
        seconds = time.perf_counter() - begin
        replies.seek(0)
        answered = sum(line.startswith(b"OK") for line in replies)
    print(json.dumps({"frames_per_second": lines / seconds, "lines": lines, "answered": answered,
                      "status": done.returncode}))


if __name__ == "__main__":
    main()
