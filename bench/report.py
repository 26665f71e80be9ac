# SPDX-License-Identifier: MIT
"""What the sections of run.py are made of: rows of one table, and how the programs are run."""
import os
import platform
import re
import subprocess
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent


@dataclass
class Row:
    question: str
    value: float
    unit: str
    other: str  # what it is compared with
    other_value: float
    more_is_better: bool = False
    wanted: float | None = None  # the least ratio

    @property
    def ratio(self) -> float | None:
        """Above 1: better than what it is compared with."""
        better, worse = self.other_value, self.value
        if self.more_is_better:
            better, worse = worse, better
        return better / worse if worse else None


def processor() -> str:
    info = Path("/proc/cpuinfo").read_text()
    found = re.search(r"^(?:model name|Processor)\s*:\s*(.+)$", info, re.MULTILINE)
    return f"{found[1] if found else platform.machine()}, {os.cpu_count()} processors"


def load() -> str:
    return " ".join(f"{load:.2f}" for load in os.getloadavg())


def output(*command: str | Path) -> str:
    """What a measurement prints; its complaints go where ours go."""
    return subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, text=True,
                          check=True).stdout


def number(value: float) -> str:
    return f"{value:,.{0 if value >= 1000 else 1 if value >= 10 else 3}f}"


def print_rows(rows: list[Row]) -> None:
    print(f"{'question':<48}{'value':>17}  {'compared with':<28}{'':>10}{'ratio':>9}{'wanted':>9}")
    for row in rows:
        ratio = "-" if row.ratio is None else f"{row.ratio:.2f}"
        wanted = "" if row.wanted is None else f"{row.wanted:.2f}"
        print(f"{row.question:<48}{number(row.value):>9} {row.unit:<7}  {row.other:<28}"
              f"{number(row.other_value):>10}{ratio:>9}{wanted:>9}")
