#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A second, independent statement of the serial protocol (docs/protocol.md).

The service reads numbers with hand-made integer arithmetic, without allocating, and packs them by a
generated table. A test that asked the same code for its expectations would only prove that the code
agrees with itself. This model is therefore written from the contract alone, with exact fractions
and no regard for speed; where the two differ, one of them has misread the contract.

    wire_model.py check FILE.tsv...                       the table files agree with the model
    wire_model.py fuzz --program PATH --rows N --seed S   `PATH encode` agrees with the model

A reply is a string without its line ending. The sentence after ` : ` is free text, so the model
leaves it out; the checksum of an ERR reply covers that sentence and is therefore written `*??`.
"""

from __future__ import annotations

import argparse
import math
import random
import re
import subprocess
import sys
from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import reduce
from operator import xor
from pathlib import Path
from typing import NamedTuple

MAX_LINE = 1024
MAX_NUMBER = 32
BLANKS = " \t"
WORD = re.compile(r"[^ \t]+")
NUMBER = re.compile(r"([+-]?)(?:([0-9]+)(?:\.([0-9]*))?|\.([0-9]+))(?:[eE]([+-]?[0-9]{1,3}))?")


class Field(NamedTuple):
    """One numeric parameter: its range in exact decimals and its fixed-point format."""

    low: Fraction
    high: Fraction
    bits: int
    fraction: int
    default: int
    group: str

    @property
    def largest(self) -> int:
        return 2 ** (self.bits - (1 if self.low < 0 else 0)) - 1


def basis(default: int) -> Field:
    return Field(Fraction(-1), Fraction(1), 18, 17, default, "CAMERA")


def light(default: int) -> Field:
    return Field(Fraction(-64), Fraction("63.875"), 10, 3, default * 8, "LIGHT")


ONE = 131071
COLOUR = Field(Fraction(0), Fraction(1), 10, 10, 1023, "COLOUR")
ZOOM = Field(Fraction(0), Fraction(10), 32, 24, 3 << 24, "CAMERA")
FIELDS = {
    "FX": basis(0), "FY": basis(0), "FZ": basis(ONE),
    "RX": basis(ONE), "RY": basis(0), "RZ": basis(0),
    "UX": basis(0), "UY": basis(ONE), "UZ": basis(0),
    "ZM": ZOOM, "LX": light(3), "LY": light(2), "LZ": light(5),
    "R": COLOUR, "G": COLOUR, "B": COLOUR,
}  # fmt: skip
KEYS = [*FIELDS, "OBJ"]
OBJECTS = ["SPHERE", "CUBE", "INFINITE_CUBE", "TUNNEL"]
GROUPS = {key: field.group for key, field in FIELDS.items()} | {"OBJ": "OBJECT"}
DEFAULTS = {key: field.default for key, field in FIELDS.items()} | {"OBJ": 0}
State = dict[str, int]


class Fault(Exception):
    def __init__(self, code: str, col: int | None = None, key: str | None = None) -> None:
        place = "" if col is None else f" col={col}"
        super().__init__(f"ERR {code}{place}" + ("" if key is None else f" key={key}"))


# Lines -----------------------------------------------------------------------------------------


class LineSplitter:
    """Cuts a byte stream at LF, CR and CR LF. Of an over-long line it keeps enough to show that it is one."""

    def __init__(self) -> None:
        self.pending = b""
        self.after_cr = False

    def feed(self, chunk: bytes) -> Iterator[bytes]:
        for byte in chunk:
            after_cr, self.after_cr = self.after_cr, byte == 0x0D
            if byte == 0x0A and after_cr:
                continue
            if byte in b"\r\n":
                yield self.pending
                self.pending = b""
            else:
                self.pending = (self.pending + bytes([byte]))[: MAX_LINE + 1]


def checksum(data: bytes) -> str:
    return f"*{reduce(xor, data, 0):02X}"


def check_bytes(line: bytes) -> None:
    for index, byte in enumerate(line):
        if not (0x20 <= byte <= 0x7E or byte == 0x09):
            raise Fault("BAD_BYTE", index + 1)


def check_mark(body: bytes) -> None:
    if body[-3:].decode("ascii").upper() != checksum(body[:-3]):
        raise Fault("CHECKSUM", len(body) - 1)


def respond(line: bytes, act: Callable[[str], str], require_checksum: bool = False) -> str | None:
    """Judges a line up to its text, lets `act` answer the text; None for a line without a reply."""
    if line.lstrip(BLANKS.encode()).startswith((b"OK", b"ERR", b"#")):
        return None  # a reply that came back
    marked = False
    try:
        if len(line) > MAX_LINE:
            raise Fault("TOO_LONG")
        check_bytes(line)
        body = line.rstrip(BLANKS.encode())
        if not body:
            return None
        marked = body[-3:-2] == b"*"
        if marked:
            check_mark(body)
            body = body[:-3]
        elif require_checksum:
            raise Fault("CHECKSUM")
        reply = act(body.decode("ascii").rstrip(BLANKS))
    except Fault as fault:
        return f"{fault}*??" if marked else str(fault)
    return reply + checksum(reply.encode()) if marked else reply


# Text -> codes -----------------------------------------------------------------------------------


class Piece(NamedTuple):
    text: str
    col: int
    end: int


def take(text: str, start: int, stops: str) -> Piece:
    """The trimmed text up to one of `stops`; an empty piece stands where its end was found."""
    end = start
    while end < len(text) and text[end] not in stops:
        end += 1
    raw = text[start:end]
    piece = raw.strip(BLANKS)
    at = start + len(raw) - len(raw.lstrip(BLANKS))
    return Piece(piece, (at if piece else end) + 1, end)


def parse_number(text: str) -> Fraction | None:
    match = NUMBER.fullmatch(text)
    if match is None or len(text) > MAX_NUMBER:
        return None
    sign, whole, digits, bare_digits, exponent = match.groups()
    after_point = digits or bare_digits or ""
    scale = int(exponent or 0) - len(after_point)
    value = int((whole or "") + after_point) * Fraction(10) ** scale
    return -value if sign == "-" else value


def quantise(value: Fraction, field: Field) -> int:
    # round() of a Fraction takes ties to even.
    return min(round(value * 2**field.fraction), field.largest)


def convert(key: str, piece: Piece) -> int:
    if key == "OBJ":
        name = piece.text.upper()
        if name in OBJECTS:
            return OBJECTS.index(name)
        if re.fullmatch("[0-3]", name):
            return int(name)
        raise Fault("OBJECT", piece.col, key)
    value = parse_number(piece.text)
    if value is None:
        raise Fault("NUMBER", piece.col, key)
    if not FIELDS[key].low <= value <= FIELDS[key].high:
        raise Fault("RANGE", piece.col, key)
    return quantise(value, FIELDS[key])


def check_key(piece: Piece, seen: State) -> str:
    key = piece.text.upper()
    if key not in KEYS:
        raise Fault("UNKNOWN_KEY", piece.col, key if len(key) <= 32 else None)
    if key in seen:
        raise Fault("DUPLICATE_KEY", piece.col, key)
    return key


def read_pairs(text: str, start: int) -> State:
    codes: State = {}
    while True:
        piece = take(text, start, ",=")
        if not re.fullmatch("[A-Za-z]+", piece.text) or text[piece.end : piece.end + 1] != "=":
            raise Fault("SYNTAX", piece.col)
        key = check_key(piece, codes)
        value = take(text, piece.end + 1, ",")
        codes[key] = convert(key, value)
        if value.end == len(text):
            return codes
        start = value.end + 1


def read_frame(text: str) -> State:
    codes = read_pairs(text, 0)
    missing = [key for key in KEYS if key not in codes]
    if missing:
        raise Fault("MISSING_KEY", key=",".join(missing))
    return codes


def split_command(text: str) -> tuple[Piece, bool]:
    """The first word, and whether the line is a frame and not a command."""
    start = len(text) - len(text.lstrip(BLANKS))
    word = take(text, start, BLANKS + ",=")
    is_frame = word.text == "" or text[word.end :].lstrip(BLANKS).startswith("=")
    return word, is_frame


# Codes -> words and text -------------------------------------------------------------------------


def pack(state: State) -> list[int]:
    def field(key: str) -> int:
        return state[key] & (2**18 - 1)

    def vector(letter: str, colour: str) -> list[int]:
        x, y, z = (field(letter + axis) for axis in "XYZ")
        return [x << 14 | y >> 4, (y & 15) << 28 | z << 10 | state[colour]]

    lights = [state[key] & 1023 for key in ("LX", "LY", "LZ")]
    first = state["OBJ"] << 30 | lights[0] << 20 | lights[1] << 10 | lights[2]
    return [first, state["ZM"], *vector("F", "R"), *vector("R", "G"), *vector("U", "B")]


def hex_words(state: State) -> str:
    return " ".join(f"{word:08X}" for word in pack(state))


def is_camera(state: State) -> bool:
    """All three lengths within 0.01 of 1 and all three products within 0.01 of 0, on the codes."""
    vectors = [[Fraction(state[v + axis], 2**17) for axis in "XYZ"] for v in "FRU"]
    for index, a in enumerate(vectors):
        b = vectors[(index + 1) % 3]
        if not Fraction("0.99") ** 2 <= sum(x * x for x in a) <= Fraction("1.01") ** 2:
            return False
        if abs(sum(x * y for x, y in zip(a, b))) > Fraction("0.01"):
            return False
    return True


def plain_decimal(value: Fraction, places: int) -> str:
    """Without an exponent; digits beyond `places` are cut off."""
    scaled = abs(value) * 10**places
    digits = str(scaled.numerator // scaled.denominator).rjust(places + 1, "0")
    sign = "-" if value < 0 else ""
    return sign + digits[: len(digits) - places] + ("." + digits[-places:] if places else "")


def nearest(value: Fraction) -> int:
    """The nearest integer, ties away from zero."""
    size = math.floor(abs(value) + Fraction(1, 2))
    return -size if value < 0 else size


def shortest_decimal(code: int, field: Field) -> str:
    """With the fewest places whose nearest decimal a host may send back for this code.

    A decimal that only the hold at the largest code brings back (1 for 0.999992) does not count,
    and one outside the range (63.9 and 63.88 for 63.875) would be refused.
    """
    exact = Fraction(code, 2**field.fraction)
    places = 0
    while True:
        decimal = Fraction(nearest(exact * 10**places), 10**places)
        if field.low <= decimal <= field.high and round(decimal * 2**field.fraction) == code:
            return plain_decimal(decimal, places)
        places += 1


def show(key: str, state: State) -> str:
    if key == "OBJ":
        return f"OBJ={OBJECTS[state[key]].lower()}"
    return f"{key}={shortest_decimal(state[key], FIELDS[key])}"


def encode(line: bytes) -> str | None:
    """What `raymarchctl encode` answers to one line (without its LF)."""

    def act(text: str) -> str:
        word, is_frame = split_command(text)
        if not is_frame:
            raise Fault("UNKNOWN_COMMAND", word.col)
        return f"OK {hex_words(read_frame(text))}"

    return respond(line, act)


# Commands ----------------------------------------------------------------------------------------


class Limits(NamedTuple):
    """The range of one of a command's numbers, and its key if it is a parameter."""

    low: str
    high: str
    key: str | None = None


def read_numbers(text: str, start: int, limits: list[Limits]) -> list[Fraction]:
    values = []
    piece = Piece("", start + 1, start)
    for low, high, key in limits:
        piece = take(text, start, ",")
        value = parse_number(piece.text)
        if value is None or not Fraction(low) <= value <= Fraction(high):
            raise Fault("ARGUMENT", piece.col, key)
        values.append(value)
        start = min(piece.end + 1, len(text))
    if piece.end < len(text):
        raise Fault("ARGUMENT", take(text, start, ",").col)
    return values


def orbit(yaw: Fraction, pitch: Fraction, zoom: Fraction) -> State:
    a, p = math.radians(float(yaw)), math.radians(float(pitch))
    f = (math.cos(p) * math.sin(a), math.sin(p), math.cos(p) * math.cos(a))
    length = math.hypot(f[2], f[0])
    r = (f[2] / length, 0.0, -f[0] / length)
    u = (f[1] * r[2] - f[2] * r[1], f[2] * r[0] - f[0] * r[2], f[0] * r[1] - f[1] * r[0])
    names = [v + axis for v in "FRU" for axis in "XYZ"]
    codes = {key: min(round(x * 2**17), ONE) for key, x in zip(names, f + r + u)}
    return codes | {"ZM": quantise(zoom, ZOOM)}


def hue_colour(hue: Fraction) -> State:
    sextant, f = divmod(6 * hue, 1)
    one, none = Fraction(1), Fraction(0)
    wheel = [(one, f, none), (1 - f, one, none), (none, one, f),
             (none, 1 - f, one), (f, none, one), (one, none, 1 - f)]  # fmt: skip
    return {key: quantise(x, COLOUR) for key, x in zip("RGB", wheel[int(sextant) % 6])}


class Session:
    """One host's view of the service: the state, and a reply for each line."""

    def __init__(self, basis_check: str = "warn", require_checksum: bool = False) -> None:
        self.basis_check = basis_check
        self.require_checksum = require_checksum
        self.state = dict(DEFAULTS)
        self.seq = 0
        self.splitter = LineSplitter()

    def feed(self, data: bytes) -> list[str]:
        replies = [self.line(line) for line in self.splitter.feed(data)]
        return [reply for reply in replies if reply is not None]

    def line(self, line: bytes) -> str | None:
        return respond(line, self.act, self.require_checksum)

    def act(self, text: str) -> str:
        word, is_frame = split_command(text)
        if is_frame:
            return self.apply(read_frame(text), may_reject=True)
        command = {
            "SET": self.set, "VIEW": self.view, "HUE": self.hue, "GET": self.get,
            "RESET": self.reset, "ECHO": self.echo, "REGS": self.regs, "PING": self.plain,
            "VERSION": self.told, "STATUS": self.told, "RANDOM": self.faulty,
            "PRESET": self.faulty, "SAVE": self.faulty, "LOAD": self.faulty,
        }.get(word.text.upper())  # fmt: skip
        if command is None:
            raise Fault("UNKNOWN_COMMAND", word.col)
        return command(text, word.end)

    def apply(self, codes: State, may_reject: bool = False) -> str:
        state = self.state | codes
        warn = self.basis_check != "off" and not is_camera(state)
        if warn and may_reject and self.basis_check == "reject":
            raise Fault("BASIS")
        changed = sum(old != new for old, new in zip(pack(self.state), pack(state)))
        self.state = state
        self.seq += 1
        return f"OK seq={self.seq} changed={changed}" + (" warn=BASIS" if warn else "")

    @staticmethod
    def choice(text: str, start: int, allowed: list[str], least: int = 0) -> str | None:
        """The one word a command may take; with nothing allowed, none at all."""
        found = list(WORD.finditer(text, start))
        if len(found) < least:
            raise Fault("ARGUMENT", len(text) + 1)
        if found and found[0][0].upper() not in allowed:
            raise Fault("ARGUMENT", found[0].start() + 1)
        if len(found) > 1:
            raise Fault("ARGUMENT", found[1].start() + 1)
        return found[0][0].upper() if found else None

    def set(self, text: str, start: int) -> str:
        if not text[start:]:
            raise Fault("ARGUMENT", len(text) + 1)
        return self.apply(read_pairs(text, start), may_reject=True)

    def view(self, text: str, start: int) -> str:
        limits = [Limits("-1000000", "1000000"), Limits("-89.9", "89.9"), Limits("0", "10", "ZM")]
        return self.apply(orbit(*read_numbers(text, start, limits)))

    def hue(self, text: str, start: int) -> str:
        return self.apply(hue_colour(*read_numbers(text, start, [Limits("0", "1")])))

    def get(self, text: str, start: int) -> str:
        asked: list[str] = []
        while start < len(text):
            piece = take(text, start, ",")
            key = piece.text.upper()
            if key not in KEYS or key in asked:
                named = re.fullmatch("[A-Z]{1,32}", key)
                raise Fault("ARGUMENT", piece.col, key if named else None)
            asked.append(key)
            start = piece.end + 1
            if start == len(text):
                raise Fault("ARGUMENT", start + 1)
        return "OK " + ",".join(show(key, self.state) for key in asked or KEYS)

    def reset(self, text: str, start: int) -> str:
        group = self.choice(text, start, list(GROUPS.values()))
        return self.apply({k: v for k, v in DEFAULTS.items() if group in (None, GROUPS[k])})

    def echo(self, text: str, start: int) -> str:
        self.choice(text, start, ["ON", "OFF"], least=1)
        return "OK"

    def regs(self, text: str, start: int) -> str:
        self.choice(text, start, [])
        return f"OK {hex_words(self.state)}"

    def plain(self, text: str, start: int) -> str:
        self.choice(text, start, [])
        return "OK"

    def told(self, text: str, start: int) -> str:
        """What these answer is about the program and its surroundings, not about the state."""
        return self.plain(text, start) + " model"

    def faulty(self, text: str, start: int) -> str:
        """Of these only the faults are modelled: every word that follows counts as a wrong one."""
        assert text[start:], "this command's good replies are not modelled"
        return self.plain(text, start)


# The table files ---------------------------------------------------------------------------------

ESCAPE = re.compile(r"\\(?:\((\d+)\*([^)]*)\)|x([0-9A-Fa-f]{2})|([rnt\\]))")


def unescape(column: str) -> bytes:
    def one(match: re.Match[str]) -> str:
        count, repeated, code, letter = match.groups()
        if count:
            return int(count) * str(repeated)
        return chr(int(code, 16)) if code else {"r": "\r", "n": "\n", "t": "\t"}.get(letter, "\\")

    data = ESCAPE.sub(one, column).encode("latin-1")
    return data if r"\n" in column else data + b"\n"


def matches(pattern: str, reply: str) -> bool:
    prefix = pattern.endswith("...")
    parts = (re.escape(part) for part in pattern.removesuffix("...").split("#"))
    expression = "[0-9]+".join(parts)
    if pattern.endswith("*??") and reply.startswith("OK"):
        expression = expression.removesuffix(re.escape("*??")) + r"\*[0-9A-F]{2}"
    return re.fullmatch(expression + (".*" if prefix else ""), reply) is not None


def check_row(session: Session, columns: list[str]) -> str | None:
    """Plays one row; returns what is wrong with it."""
    if len(columns) != 4 or not all(columns):
        return "a row has four columns, none of them empty"
    send, expect, words, _ = columns
    before = hex_words(session.state)
    replies = session.feed(unescape(send))
    patterns = [] if expect == "-" else expect.split(" | ")
    if len(replies) != len(patterns) or not all(map(matches, patterns, replies)):
        return f"expected {expect!r}, the model says {' | '.join(replies) or '-'!r}"
    after = hex_words(session.state)
    if words != "-" and after != (before if words == "=" else words):
        return f"expected the words {words}, the model has {after}"
    if encode((session.line(b"GET") or "")[3:].encode()) != f"OK {after}":
        return "what GET says does not lead back to the same words"
    return None


def check_table(path: str) -> tuple[int, int]:
    session, passed, failed = Session(), 0, 0
    for number, line in enumerate(Path(path).read_text(encoding="ascii").splitlines(), 1):
        if not line or line.startswith("#"):
            continue
        problem = check_row(session, line.split("\t"))
        if problem:
            print(f"{path}:{number}: {problem}")
        passed, failed = passed + (not problem), failed + bool(problem)
    return passed, failed


# Random lines ------------------------------------------------------------------------------------


def with_exponent(rng: random.Random, text: str) -> str:
    """The same digits with the point moved, and an exponent that moves it back (or does not)."""
    sign, digits = ("-", text[1:]) if text.startswith("-") else (rng.choice(["", "+"]), text)
    whole, _, fraction = digits.partition(".")
    joined = whole + fraction
    point = rng.randint(0, len(joined))
    power = len(whole) - point + (rng.choice([0, 0, 0, 1, -1, rng.randint(-999, 999)]))
    mark = f"{rng.choice('eE')}{rng.choice(['', '+']) if power >= 0 else '-'}{abs(power):d}"
    return f"{sign}{joined[:point]}.{joined[point:]}{mark}"


def tie(rng: random.Random, field: Field) -> str:
    span = 2**field.fraction
    code = rng.randint(int(field.low * span), int(field.high * span) - 1)
    middle = Fraction(2 * code + 1, 2 * span)
    nudge = rng.choice([0, 0, 1, -1]) * Fraction(1, 10 ** rng.randint(field.fraction + 2, 29))
    return plain_decimal(middle + nudge, 29).rstrip("0")


def bound(rng: random.Random, field: Field) -> str:
    edge = rng.choice([field.low, field.high, Fraction(0)])
    places = rng.randint(20, 30)
    return plain_decimal(edge + rng.choice([-1, 0, 1]) * Fraction(1, 10**places), places)


def good_number(rng: random.Random, field: Field) -> str:
    share = Fraction(rng.randint(0, 10**9), 10**9)
    text = plain_decimal(field.low + share * (field.high - field.low), rng.randint(0, 12))
    return rng.choice([text, text, "+" + text if text[0] != "-" else text, text + "e0"])


def padded_number(rng: random.Random, field: Field) -> str:
    text = plain_decimal(field.high * Fraction(rng.randint(0, 99), 100), 4)
    return text.rjust(rng.randint(31, 34), "0") if rng.random() < 0.5 else text.ljust(33, "0")


def odd_number(rng: random.Random, field: Field) -> str:
    if rng.random() < 0.5:
        return "".join(rng.choice("0123456789.eE+- x") for _ in range(rng.randint(0, 9)))
    return rng.choice([
        ".", "+", "-.", "-0.0", "-0", "1.", ".5", "+.5", "5.e-1", "1e", "1e+", "0e999", "0e-999",
        "1e-999", "-1e-999", "1e999", "1e0001", "-1e-01", "0x1", "inf", "nan", "1=1", "1 0", "1,",
        "00", "0.", "--1", "1..0", "1e1.0", "*", "1*00", "1f", "\t1", "1_0", "",
    ])  # fmt: skip


def value_text(rng: random.Random, key: str) -> str:
    if key == "OBJ":
        names = ["sphere", "CUBE", "Infinite_Cube", "tunnel", "0", "1", "2", "3"]
        return rng.choice(names * 4 + ["4", "00", "+1", "1.0", "cub", "cubes", "infinite cube", ""])
    field = FIELDS[key]
    kind = rng.choices([good_number, tie, bound, padded_number, odd_number], [40, 20, 8, 2, 2])[0]
    text = kind(rng, field)
    if re.fullmatch(r"-?\d+\.\d+", text) and rng.random() < 0.2:
        return with_exponent(rng, text)
    return text


def accepted_by(judge: Callable[[Piece], object], text: str) -> bool:
    """Whether `text` is one value, and one without a fault."""
    try:
        judge(take(text, 0, ","))
    except Fault:
        return False
    return "," not in text and text == text.strip(BLANKS)


def accepted(rng: random.Random, key: str) -> str:
    """A value without a fault, so that the frame's other values are looked at too."""
    while True:
        text = value_text(rng, key)
        if accepted_by(lambda piece: convert(key, piece), text):
            return text


def random_frame(rng: random.Random) -> str:
    keys = rng.sample(KEYS, len(KEYS)) if rng.random() < 0.5 else KEYS
    wrong = rng.choice(KEYS) if rng.random() < 0.5 else None
    gap = ["", "", "", " ", "\t", "  "] if rng.random() < 0.3 else [""]
    pairs = []
    for key in keys:
        name = rng.choice([key, key, key.lower(), key.title()])
        value = value_text(rng, key) if key == wrong else accepted(rng, key)
        pairs.append("".join([rng.choice(gap), name, rng.choice(gap), "=", rng.choice(gap), value]))
    return (rng.choice(gap) + ",").join(pairs) + rng.choice(gap)


def mutate(rng: random.Random, text: str) -> str:
    at = rng.randrange(len(text))
    head, tail = text[:at], text[at:]
    pairs = text.split(",")
    one = rng.randrange(len(pairs))
    letter = chr(rng.choice([*b",= \t.eE+-*?_0aZ\x01\x7f\xff\r\0", *range(0x20, 0x7F)]))
    unknown = "Q" * rng.randint(1, 40) + "=1"
    return rng.choice([
        head, head + tail[1:], head + letter + tail, head + letter + tail[1:],
        text + ",", "," + text, text + "," + pairs[one],
        ",".join(pairs[:one] + pairs[one + 1 :]), ",".join([*pairs[:one], unknown, *pairs[one:]]),
        text.replace("=", rng.choice(["", "==", ":", " "]), 1),
        text.replace(",", rng.choice([",,", ";"]), 1),
    ])  # fmt: skip


def with_checksum(rng: random.Random, text: str) -> str:
    mark = checksum(text.encode("latin-1"))
    wrong = "*" + "".join(rng.choice("0123456789abcdefABCDEFgG *") for _ in range(2))
    return text + rng.choice([mark, mark, mark, mark.lower(), wrong, mark + " ", mark[:2]])


def ending(rng: random.Random) -> bytes:
    return rng.choices([b"\n", b"\r\n", b"\r", b"\r\r\n", b"\n\r"], [56, 30, 10, 2, 2])[0]


def random_line(rng: random.Random) -> bytes:
    """A line with its ending, or sometimes a few."""
    kind = rng.choices(["frame", "mutant", "command", "garbage"], [60, 30, 5, 5])[0]
    if kind == "garbage":
        return bytes(rng.choice(range(256)) for _ in range(rng.randint(0, 40))) + ending(rng)
    text = random_frame(rng)
    if kind == "mutant":
        text = mutate(rng, text)
    elif kind == "command":
        text = rng.choice(["SET ", "get", " PING ", "FX", "FX,", "fx 1,", "", " ", "?"])
        text += rng.choice(["", " ", "FX=1", "1", "=", "\t=1"])
    if rng.random() < 0.02:
        text = rng.choice(["OK ", "OK", "ERR ", "# ", "#", "ok ", "O", "\tERR"]) + text
    if rng.random() < 0.03:
        text = rng.choice([text.ljust, text.rjust])(rng.randint(1022, 1027))
    if rng.random() < 0.25:
        text = with_checksum(rng, text)
    return text.encode("latin-1") + ending(rng)


def agrees(expected: str, reply: str) -> bool:
    """Compares up to the sentence; a checksum that covers a sentence is computed from the reply."""
    if expected.startswith("OK"):
        return reply == expected
    if " : " not in reply:
        return False
    if expected.endswith("*??") and checksum(reply[:-3].encode("latin-1")) != reply[-3:]:
        return False
    return reply.split(" : ")[0] == expected.removesuffix("*??")


def fuzz(program: str, rows: int, seed: int) -> tuple[int, int]:
    rng = random.Random(seed)
    data = b"".join(random_line(rng) for _ in range(rows)) + b"\n"
    lines = list(LineSplitter().feed(data))
    cases = [(line, reply) for line in lines if (reply := encode(line)) is not None]
    output = subprocess.run([program, "encode"], input=data, stdout=subprocess.PIPE).stdout
    replies = [reply.removesuffix("\r") for reply in output.decode("latin-1").split("\n")[:-1]]
    print(f"seed {seed}: {rows} lines, {len(cases)} with a reply, {len(replies)} replies came")
    failed = abs(len(cases) - len(replies))
    for (line, expected), reply in zip(cases, replies):
        if not agrees(expected, reply):
            if failed == abs(len(cases) - len(replies)):
                print(f"line     {line!r}\nexpected {expected}\ngot      {reply}")
            failed += 1
    return max(len(cases) - failed, 0), failed


def main() -> int:
    parser = argparse.ArgumentParser(description="An independent model of the serial protocol.")
    commands = parser.add_subparsers(dest="command", required=True)
    checking = commands.add_parser("check", help="compare table files with the model")
    checking.add_argument("file", nargs="+")
    fuzzing = commands.add_parser("fuzz", help="compare a program with the model on random lines")
    fuzzing.add_argument("--program", required=True)
    fuzzing.add_argument("--rows", type=int, default=10000)
    fuzzing.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    if options.command == "fuzz":
        results = [fuzz(options.program, options.rows, options.seed)]
    else:
        results = [check_table(path) for path in options.file]
    passed, failed = (sum(column) for column in zip(*results))
    print(f"{passed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
