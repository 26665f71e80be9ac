#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Frames of every accelerator, by the tables of the documents.

wire_model.py states the protocol with the marcher's table typed by hand. The other accelerators
have tables of up to two hundred keys; here they are read from the pages that a host's author would
read: keys, ranges and formats from docs/protocol.md, the place of every bit and the words of the
defaults from docs/registers.md. The arithmetic is the model's, exact and independent.

    wire_tables.py fuzz --program PATH --docs FOLDER --rows N --seed S
                        `PATH encode --accelerator NAME` agrees with the pages, N lines each
"""

from __future__ import annotations

import argparse
import random
import re
import subprocess
import sys
from fractions import Fraction
from pathlib import Path
from typing import NamedTuple

from wire_model import (
    Fault, LineSplitter, Piece, accepted_by, agrees, bound, good_number, mutate, odd_number,
    padded_number, parse_number, respond, split_command, take, tie, with_checksum, with_exponent,
)  # fmt: skip

FIRST_KEY_BYTE = "[A-Za-z]"


class Number(NamedTuple):
    """Range and format; the generators of wire_model take it for one of their fields."""

    low: Fraction
    high: Fraction
    signed: bool
    bits: int
    fraction: int

    @property
    def largest(self) -> int:
        return 2 ** (self.bits - self.signed) - 1


class Choice(NamedTuple):
    names: list[str]


class Place(NamedTuple):
    """Bits [msb:lsb] of a word, which hold bits `first` and up of the code."""

    word: int
    msb: int
    lsb: int
    first: int


class Accelerator(NamedTuple):
    name: str
    values: dict[str, Number | Choice]  # in table order; rows column by column
    places: dict[str, list[Place]]
    initial: list[int]
    defaults: dict[str, str]  # of what a frame names

    @property
    def has_rows(self) -> bool:
        return any("." in key for key in self.values)


# The pages ---------------------------------------------------------------------------------------


def table_rows(text: str) -> list[list[str]]:
    """The cells of a table, without its head."""
    lines = [line for line in text.splitlines() if line.startswith("|")]
    cells = (re.split(r" *(?<!\\)\| *", line) for line in lines[2:])
    return [row[1:-1] for row in cells]


def value_of(allowed: str, form: str) -> Number | Choice:
    if allowed.startswith("`"):
        names = re.findall(r"`([^`]+)` (\d+)", allowed)
        assert [int(code) for _, code in names] == list(range(len(names)))
        return Choice([name.upper() for name, _ in names])
    low, high = allowed.split(" .. ")
    match = re.match(r"(?:Q(\d+)\.(\d+) )?(signed|unsigned), (\d+)", form)
    assert match, form
    whole, fraction, sign, bits = match.groups()
    assert whole is None or int(whole) + int(fraction) == int(bits)
    signed = sign == "signed"
    return Number(Fraction(low), Fraction(high), signed, int(bits), int(fraction or 0))


def keys_of(cell: str) -> list[str]:
    match = re.fullmatch(r"([A-Z]+)1(\.\w+) to \1(\d+)\2", cell)
    if match is None:
        return [cell]
    table, column, last = match.groups()
    return [f"{table}{row}{column}" for row in range(1, int(last) + 1)]


def sections(text: str, head: str) -> dict[str, str]:
    parts = re.split(head, text)
    return dict(zip(parts[1::2], parts[2::2]))


def read_pages(docs: Path) -> list[Accelerator]:
    protocol = (docs / "protocol.md").read_text(encoding="utf-8")
    protocol = protocol.split("<!-- begin parameters -->")[1].split("<!-- end parameters -->")[0]
    registers = (docs / "registers.md").read_text(encoding="utf-8").split("## Extended")[0]
    words = sections(registers, r"## Parameter words of `(\w+)`\n")
    accelerators = []
    for name, text in sections(protocol, r"Parameters of `(\w+)`:\n").items():
        values: dict[str, Number | Choice] = {}
        defaults = {}
        unplaced = set()
        for key_cell, _, _, allowed, form, _, default in table_rows(text):
            for key in keys_of(key_cell):
                values[key] = value_of(allowed, form)
                if "in no register" in form:
                    unplaced.add(key)
                if "." not in key:
                    defaults[key] = default
        places: dict[str, list[Place]] = {key: [] for key in values}
        for word, _, fields in table_rows(words[name]):
            for key, first, msb, lsb in re.findall(
                r"([A-Z][A-Z0-9.]*)(?:\{\d+:(\d+)\})?\[(\d+):(\d+)\]", fields
            ):
                places[key].append(Place(int(word), int(msb), int(lsb), int(first or 0)))
        assert {key for key, where in places.items() if not where} == unplaced, name
        initial = [int(word, 16) for word in re.findall(r"\n    ([0-9A-F ]+)", words[name])[0].split()]
        accelerators.append(Accelerator(name, values, places, initial, defaults))
    return accelerators


# The model ---------------------------------------------------------------------------------------


def convert(accelerator: Accelerator, key: str, piece: Piece) -> int:
    value = accelerator.values[key]
    if isinstance(value, Choice):
        name = piece.text.upper()
        if name in value.names:
            return value.names.index(name)
        if re.fullmatch("[0-9]", name) and int(name) < len(value.names):
            return int(name)
        raise Fault("OBJECT", piece.col, key)
    number = parse_number(piece.text)
    if number is None:
        raise Fault("NUMBER", piece.col, key)
    if not value.low <= number <= value.high:
        raise Fault("RANGE", piece.col, key)
    return min(round(number * 2**value.fraction), value.largest)


def read_frame(accelerator: Accelerator, text: str) -> dict[str, int]:
    codes: dict[str, int] = {}
    key_form = FIRST_KEY_BYTE + ("[A-Za-z0-9.]*" if accelerator.has_rows else "[A-Za-z]*")
    start = 0
    while start <= len(text):
        piece = take(text, start, ",=")
        if not re.fullmatch(key_form, piece.text) or text[piece.end : piece.end + 1] != "=":
            raise Fault("SYNTAX", piece.col)
        key = piece.text.upper()
        if key not in accelerator.values:
            raise Fault("UNKNOWN_KEY", piece.col, key if len(key) <= 32 else None)
        if key in codes:
            raise Fault("DUPLICATE_KEY", piece.col, key)
        value = take(text, piece.end + 1, ",")
        codes[key] = convert(accelerator, key, value)
        start = value.end + 1
    missing = [key for key in accelerator.values if "." not in key and key not in codes]
    if missing:
        raise Fault("MISSING_KEY", key=",".join(missing))
    return codes


def pack(accelerator: Accelerator, codes: dict[str, int]) -> list[int]:
    """The words of the defaults with the bits of `codes` put in."""
    words = list(accelerator.initial)
    for key, code in codes.items():
        for word, msb, lsb, first in accelerator.places[key]:
            mask = (1 << (msb - lsb + 1)) - 1
            words[word] = words[word] & ~(mask << lsb) | (code >> first & mask) << lsb
    return words


def encode(accelerator: Accelerator, line: bytes) -> str | None:
    def act(text: str) -> str:
        word, is_frame = split_command(text)
        if not is_frame:
            raise Fault("UNKNOWN_COMMAND", word.col)
        words = pack(accelerator, read_frame(accelerator, text))
        return "OK " + " ".join(f"{word:08X}" for word in words)

    return respond(line, act)


# Random lines ------------------------------------------------------------------------------------


def value_text(rng: random.Random, value: Number | Choice) -> str:
    if isinstance(value, Choice):
        digits = [str(code) for code in range(len(value.names))]
        good = [*value.names, *(name.lower() for name in value.names), *digits]
        return rng.choice(good * 4 + [str(len(digits)), "00", "+1", "1.0", value.names[0] + "S", ""])
    ties = 20 if value.fraction < 28 else 0  # of finer formats no tie has 32 characters
    kinds = [good_number, tie, bound, padded_number, odd_number]
    kind = rng.choices(kinds, [40, ties, 8, 2, 2])[0]
    text = kind(rng, value)
    if re.fullmatch(r"-?\d+\.\d+", text) and rng.random() < 0.2:
        return with_exponent(rng, text)
    return text


def random_frame(rng: random.Random, accelerator: Accelerator) -> str:
    rows = [key for key in accelerator.values if "." in key]
    keys = [key for key in accelerator.values if "." not in key]
    keys += rng.sample(rows, min(len(rows), rng.randint(0, 12)))
    if rng.random() < 0.5:
        rng.shuffle(keys)
    wrong = rng.choice(keys) if rng.random() < 0.4 else None
    gap = ["", "", "", " ", "\t", "  "] if rng.random() < 0.2 else [""]
    pairs = []
    for key in keys:
        value = accelerator.values[key]
        text = value_text(rng, value)
        while key != wrong and not accepted_by(lambda piece: convert(accelerator, key, piece), text):
            text = value_text(rng, value)
        name = rng.choice([key, key, key.lower(), key.title()])
        pairs.append("".join([rng.choice(gap), name, rng.choice(gap), "=", rng.choice(gap), text]))
    return (rng.choice(gap) + ",").join(pairs) + rng.choice(gap)


def random_line(rng: random.Random, accelerator: Accelerator) -> bytes:
    text = random_frame(rng, accelerator)
    if rng.random() < 0.3:
        text = mutate(rng, text)
    if rng.random() < 0.2:
        text = with_checksum(rng, text)
    return (text + rng.choice(["", "", "\r"])).encode("latin-1")


def fuzz(program: str, accelerator: Accelerator, rows: int, seed: int) -> int:
    """How many of the lines the program answers otherwise."""
    rng = random.Random(f"{accelerator.name} {seed}")
    first = ",".join(f"{key}={text}" for key, text in accelerator.defaults.items()).encode()
    assert encode(accelerator, first) == "OK " + " ".join(f"{w:08X}" for w in accelerator.initial)
    random_lines = [random_line(rng, accelerator) for _ in range(rows)]
    data = b"".join(line + b"\n" for line in [first, *random_lines])
    lines = list(LineSplitter().feed(data))
    cases = [(line, reply) for line in lines if (reply := encode(accelerator, line)) is not None]
    command = [program, "encode", "--accelerator", accelerator.name]
    output = subprocess.run(command, input=data, stdout=subprocess.PIPE).stdout.decode("latin-1")
    replies = [reply.removesuffix("\r") for reply in output.split("\n")[:-1]]
    good = sum(expected.startswith("OK") for _, expected in cases)
    print(f"{accelerator.name}: {len(cases)} lines with a reply, {good} of them OK")
    differ = [case for case in zip(cases, replies) if not agrees(case[0][1], case[1])]
    for (line, expected), reply in differ[:1]:
        print(f"line     {line!r}\nexpected {expected}\ngot      {reply}")
    assert good > rows // 4, "the random lines have become useless"
    return len(differ) + abs(len(cases) - len(replies))


def main() -> int:
    parser = argparse.ArgumentParser(description="The protocol's tables against a program.")
    commands = parser.add_subparsers(dest="command", required=True)
    fuzzing = commands.add_parser("fuzz", help="compare a program with the pages on random lines")
    fuzzing.add_argument("--program", required=True)
    fuzzing.add_argument("--docs", type=Path, required=True)
    fuzzing.add_argument("--rows", type=int, default=2000)
    fuzzing.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    accelerators = read_pages(options.docs)
    assert len(accelerators) > 1
    failed = sum(fuzz(options.program, each, options.rows, options.seed) for each in accelerators)
    print(f"{failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
