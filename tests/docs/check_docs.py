#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Holds the documents to the programs: options, synopses, settings, links and the verbs of ./dev.

Usage: check_docs.py --build DIR, the folder of raymarchd and raymarchctl.
"""

import argparse
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def run(*command: str | Path) -> str:
    """What the command prints."""
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def option_names(help_text: str) -> set[str]:
    """The long options that a --help prints, one a line."""
    return set(re.findall(r"^ +(?:-\w,)?(--[a-z][a-z-]*)", help_text, re.MULTILINE))


def manual_text(path: Path) -> str:
    """The page's source with dashes as dashes and without font changes."""
    text = re.sub(r"\\f[A-Z]|\\&", "", path.read_text())
    return text.replace("\\-", "-")


def manual_options(text: str) -> set[str]:
    return set(re.findall(r"(?<![\w-])--[a-z][a-z-]*", text))


def compare(page: str, documented: set[str], printed: set[str]) -> list[str]:
    return [f"{page}: {name} is not in the page" for name in sorted(printed - documented)] + [
        f"{page}: no program has {name}" for name in sorted(documented - printed)
    ]


def check_service(build: Path) -> list[str]:
    """Options of raymarchd, and its settings with the defaults that the example file shows."""
    page = ROOT / "docs/man/raymarchd.8"
    text = manual_text(page)
    found = compare(page.name, manual_options(text), option_names(run(build / "raymarchd", "--help")))
    example = (ROOT / "systemd/raymarchd.toml").read_text()
    example = example.split("\n#[")[0]  # the tables have parts of their own, printed by dump_tables
    for name, default in re.findall(r'^#(\w+) = "?([^"\n]+)"?$', example, re.MULTILINE):
        head = rf'^\.BR {name} ", " --{name.replace("_", "-")} .*?'
        entry = re.search(head + r'(?=^\.BR \w+ ", " --|^\.SH)', text, re.MULTILINE | re.DOTALL)
        if entry is None:
            found.append(f"{page.name}: the setting {name} has no entry")
        elif not re.search(rf"^Default:\n\.\w+ {re.escape(default)} ?\.$", entry[0], re.MULTILINE):
            found.append(f"{page.name}: the default of {name} is {default}")
    return found


def subcommand_names(help_text: str) -> list[str]:
    """The subcommands that a --help prints, if it has any."""
    return re.findall(r"^  ([a-z]+) ", help_text.partition("Subcommands:")[2], re.MULTILINE)


def synopses(text: str) -> dict[str, list[str]]:
    """The lines of a page's SYNOPSIS by subcommand, as a reader sees them; each should have one."""
    part = text.split(".SH SYNOPSIS\n")[1].split(".SH ")[0]
    found: dict[str, list[str]] = {}
    entry = r"^\.B raymarchctl (\w+)\n(.*?)(?=^\.br|\Z)"
    for name, rest in re.findall(entry, part, re.MULTILINE | re.DOTALL):
        words = re.sub(r"^\.[A-Z]+ ", "", rest, flags=re.MULTILINE).replace("\\|", "").split()
        found.setdefault(name, []).append(" ".join(words))
    return found


def check_synopsis(line: str, help_text: str, common: set[str]) -> list[str]:
    """What is wrong with one subcommand's line, by its --help; `common` are the endpoint's options."""
    named = set(re.findall(r"(?<![\w-])--?[a-zA-Z][a-z-]*", line))
    found = [f"there is no {name}" for name in sorted(named)
             if not re.search(rf"^ +(-\w,)?{name}\b", help_text, re.MULTILINE)]
    rest = option_names(help_text) - {"--help"} - named
    if "ENDPOINT" in line:
        rest -= common
    for names in re.findall(r"^ +((?:-\w,)?--[a-z-]+) .*REQUIRED", help_text, re.MULTILINE):
        rest -= set(names.split(","))
        if not re.search(rf"(?<!\[ )(?:{names.replace(',', '|')}) [A-Z]", line):
            found.append(f"{names} is required")
    if rest and not re.search(r"\[ OPTION\b", line):
        found.append(f"OPTION stands for {', '.join(sorted(rest))}")

    usage = re.search(r"^Usage: raymarchctl \w+ \[OPTIONS\](.*)$", help_text, re.MULTILINE)
    for positional in usage[1].split() if usage else []:
        name = positional.strip("[].")
        if name == "SUBCOMMAND":
            found += [f"{verb} is missing" for verb in subcommand_names(help_text)
                      if not re.search(rf"\b{verb}\b", line)]
        elif not re.search(rf"\b{name}\b", line):
            found.append(f"{name} is missing")
        elif positional.startswith("[") != bool(re.search(rf"\[ {name}\b", line)):
            found.append(f"{name} is {'optional' if positional.startswith('[') else 'required'}")
    return found


def check_tool(build: Path) -> list[str]:
    """Options of raymarchctl and of its subcommands, each in the subcommand's own part of the page."""
    page = ROOT / "docs/man/raymarchctl.1"
    text = manual_text(page)
    program = build / "raymarchctl"
    general = run(program, "--help")
    subcommands = subcommand_names(general)
    parts = dict(re.findall(r"^\.SS (\w+)\n(.*?)(?=^\.S[SH]|\Z)", text, re.MULTILINE | re.DOTALL))
    common = manual_options(text.split(".SH SUBCOMMANDS")[0].split(".SH OPTIONS")[1])

    found: list[str] = []
    printed = option_names(general)
    lines = synopses(text)
    found += [f"{page.name}: SYNOPSIS: there is no subcommand {name}"
              for name in lines if name not in subcommands]
    for name in subcommands:
        help_text = run(program, name, "--help")
        own = lines.get(name, [])
        if len(own) != 1:
            found.append(f"{page.name}: SYNOPSIS: {name} has {len(own)} lines of its own, not 1")
        for line in own:
            found += [f"{page.name}: SYNOPSIS of {name}: {fault}"
                      for fault in check_synopsis(line, help_text, common)]
        options = option_names(help_text)
        for verb in subcommand_names(help_text):
            options |= option_names(run(program, name, verb, "--help"))
        printed |= options
        if name not in parts:
            found.append(f"{page.name}: the subcommand {name} has no part")
        else:
            found += compare(f"{page.name} ({name})", manual_options(parts[name]), options - common)
    return found + compare(page.name, manual_options(text), printed)


def anchor(heading: str) -> str:
    """The anchor that a heading gets."""
    return re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-")


def check_links() -> list[str]:
    """Relative links of the pages, with their anchors."""
    found: list[str] = []
    for page in [ROOT / "README.md", *sorted(ROOT.glob("docs/**/*.md")), *ROOT.glob("overlay/*.md")]:
        for target in re.findall(r"\]\(([^)\s]+)\)", page.read_text()):
            if re.match(r"[a-z]+:", target):
                continue
            path, _, part = target.partition("#")
            goal = (page.parent / path) if path else page
            where = f"{page.relative_to(ROOT)}: {target}"
            if not goal.exists():
                found.append(f"{where} does not exist")
            elif part and part not in map(anchor, re.findall(r"^#+ (.*)$", goal.read_text(), re.M)):
                found.append(f"{where} has no such heading")
    return found


def check_verbs() -> list[str]:
    """Each verb that ./dev help prints stands somewhere in the pages."""
    pages = [ROOT / "README.md", *ROOT.glob("docs/*.md")]
    text = "\n".join(page.read_text() for page in pages)
    verbs = re.findall(r"^\./dev ([a-z]+)(?: \| ([a-z]+))?", run(ROOT / "dev", "help"), re.MULTILINE)
    return [f"./dev {verb} is in no page" for pair in verbs for verb in pair
            if verb and not re.search(rf"\./dev {verb}\b", text)]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=Path, required=True, help="folder of the programs")
    build = parser.parse_args().build.resolve()
    found = check_service(build) + check_tool(build) + check_links() + check_verbs()
    print("\n".join(found) if found else "documents: in step with the programs")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
