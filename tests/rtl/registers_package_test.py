#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The package of registers for the hardware: yosys and Verilator read it, and each of its functions
takes from random words the bits that docs/registers.md gives to the parameter.

    registers_package_test.py PACKAGE DOCS       status 77: neither program is here
"""

import random
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "model"))

import wire_tables  # noqa: E402

ROUNDS = 8
FUNCTION = re.compile(r"function automatic logic (signed )?\[(\d+):0\] (\w+)\(input logic \[32\*(\w+)_WORDS-1:0\] words\);")


def module_of(name: str, package: str) -> tuple[str, dict[str, int]]:
    """A module whose outputs are all parameters of an accelerator, and the width of each."""
    widths = {}
    outputs, assigns = [], []
    for signed, msb, function, prefix in FUNCTION.findall(package):
        if prefix != name.upper():
            continue
        key = function.removeprefix(name + "_")
        widths[key] = int(msb) + 1
        outputs.append(f"output logic {signed}[{msb}:0] {key}")
        assigns.append(f"  assign {key} = raymarch_registers_pkg::{function}(words);")
    words = f"input logic [32*raymarch_registers_pkg::{name.upper()}_WORDS-1:0] words"
    return f"module {name} (\n  " + ",\n  ".join([words, *outputs]) + "\n);\n" + "\n".join(assigns) + "\nendmodule\n", widths


def expected(places: list[wire_tables.Place], words: list[int]) -> int:
    value = 0
    for word, msb, lsb, first in places:
        value |= (words[word] >> lsb & (1 << msb - lsb + 1) - 1) << first
    return value


def evaluated(yosys: str, files: list[Path], name: str, rounds: list[list[int]], keys: list[str]) -> list[dict[str, int]]:
    """What the module's outputs are for each list of words."""
    commands = [f"read_verilog -sv {' '.join(map(str, files))}", f"prep -top {name}"]
    show = " ".join(f"-show {key}" for key in keys)
    for words in rounds:
        vector = "".join(f"{word:08x}" for word in reversed(words))
        commands.append(f"eval -set words {32 * len(words)}'h{vector} {show}")
    output = subprocess.run([yosys, "-p", "; ".join(commands)], stdout=subprocess.PIPE, text=True, check=True).stdout
    results: list[dict[str, int]] = []
    # 18'01..., but a constant of 32 bits may be shown as a decimal number.
    for key, bits, number in re.findall(r"Eval result: \\(\w+) = (?:\d+'([01]+)|(-?\d+))", output):
        if not results or key in results[-1]:
            results.append({})
        results[-1][key] = int(bits, 2) if bits else int(number) & 0xFFFF_FFFF
    return results


def main() -> int:
    package, docs = map(Path, sys.argv[1:])
    yosys, verilator = shutil.which("yosys"), shutil.which("verilator")
    if yosys is None and verilator is None:
        print("skipped: there is neither yosys nor verilator here")
        return 77
    faults = 0
    rng = random.Random(1)
    for accelerator in wire_tables.read_pages(docs):
        name = accelerator.name
        text, widths = module_of(name, package.read_text())
        with tempfile.TemporaryDirectory() as folder:
            files = [package, Path(folder, f"{name}.sv")]
            files[1].write_text(text)
            if verilator is not None:
                subprocess.run([verilator, "--lint-only", "-Wall", "--top-module", name, *files], check=True)
            if yosys is None:
                continue
            rounds = [[rng.getrandbits(32) for _ in accelerator.initial] for _ in range(ROUNDS)]
            found = evaluated(yosys, files, name, rounds, list(widths))
        if len(found) != ROUNDS:
            sys.exit(f"{name}: yosys gave {len(found)} of {ROUNDS} results")
        for words, values in zip(rounds, found):
            for key, places in accelerator.places.items():
                if not places:
                    continue
                wanted = expected(places, words)
                if values.get(key.replace(".", "_")) != wanted:
                    print(f"{name}.{key}: {values.get(key.replace('.', '_'))}, not {wanted}", file=sys.stderr)
                    faults += 1
        print(f"{name}: {len(widths)} parameters")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
