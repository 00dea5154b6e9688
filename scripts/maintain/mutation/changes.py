"""Finds the possible changes of C++ sources and draws from them. Nothing here reads or writes files."""
from __future__ import annotations

import math
import random
import re
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import NamedTuple

COMPARISONS = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "=="}
SIGNS = {"+": "-", "-": "+", "+=": "-=", "-=": "+="}
LOGICAL = {"&&": "||", "||": "&&"}
EXTREMES = {a: b for low, high in [("min", "max"), ("fmin", "fmax"), ("min_element", "max_element"),
                                   ("minCoeff", "maxCoeff"), ("cwiseMin", "cwiseMax")]
            for a, b in [(low, high), (high, low)]}
ASSIGNMENTS = {"=", "+=", "-=", "*=", "/=", "%=", "|=", "&=", "<<", "<<=", ">>="}
# A statement that begins with one of these is not an expression whose removal compiles.
NO_EXPRESSION = set("""break case class const constexpr continue default delete do else enum explicit extern for
friend goto if inline namespace new private protected public return static struct switch template throw
typedef typename using virtual void while""".split())
# Declarations without run-time code.
DECLARATIONS = {"static_assert", "using", "typedef", "asm"}

TOKEN = re.compile(r"""
    (?P<skipped>//(?:\\\n|[^\n])*|/\*.*?\*/|^[ \t]*\#(?:\\\n|[^\n])*)
  | (?P<string>(?:u8|[uUL])?R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)"|(?:u8|[uUL])?"(?:\\.|[^"\\])*"
      |(?:u8|[uUL])?'(?:\\.|[^'\\])+')
  | (?P<number>\.?\d(?:[eEpP][+-]|'(?=\w)|[\w.])*)
  | (?P<word>[A-Za-z_]\w*)
  | (?P<operator><=>|<<=|->|\+\+|--|&&|\|\||::|[-+*/%<>=!&|^]=|<<|\.\.\.|[^\s\w])
    """, re.VERBOSE | re.DOTALL | re.MULTILINE)
FLOATING = re.compile(r"((?:\d[\d']*\.[\d']*|\.\d[\d']*)(?:[eE][+-]?\d+)?|\d+[eE][+-]?\d+)([A-Za-z_]*)")
INTEGER = re.compile(r"(0[xX][\da-fA-F']+|0[bB][01']+|[\d']+)([A-Za-z_]*)")


@dataclass(frozen=True)
class Change:
    """The characters from `start` to `end` of the file are replaced by `new`."""

    file: str
    line: int
    kind: str
    start: int
    end: int
    new: str


class Token(NamedTuple):
    text: str
    kind: str  # string, number, word or operator
    start: int
    end: int


class Code:
    """The tokens of a source text, without comments and preprocessor lines."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.tokens = [Token(m[0], m.lastgroup or "", m.start(), m.end()) for m in TOKEN.finditer(text)
                       if m.lastgroup != "skipped"]
        self.tokens = [Token(t.text, "string" if t.kind == "mark" else t.kind, t.start, t.end)
                       for t in self.tokens]
        self.fixed = self._fixed_tokens()

    def at(self, i: int) -> Token:
        end = len(self.text)
        return self.tokens[i] if 0 <= i < len(self.tokens) else Token("", "", end, end)

    def is_spaced(self, i: int) -> bool:
        """Whether blanks surround the token, as clang-format sets binary operators but not brackets."""
        t = self.tokens[i]
        return self.text[t.start - 1 : t.start].isspace() and self.text[t.end : t.end + 1].isspace()

    def _fixed_tokens(self) -> set[int]:
        """The indices of tokens in template brackets and in declarations without run-time code."""
        fixed, depth, declares = set(), 0, False
        for i, t in enumerate(self.tokens):
            before = self.at(i - 1)
            declares = (declares or t.text in DECLARATIONS) and before.text != ";"
            attached = before.end == t.start and (before.kind == "word" or before.text == "]")
            if t.text == "<" and before.text != "operator" and (attached or before.text == "template"):
                depth += 1
            if depth or declares:
                fixed.add(i)
            if t.text == ">" and depth and not self.is_spaced(i):
                depth -= 1
            elif t.text == ";":
                depth, declares = 0, False
        return fixed

    def end_of_operand(self, i: int) -> int:
        """The index after a simple operand at i: a number or a name with its members, calls and indices."""
        if self.at(i).kind == "number":
            return i + 1
        if self.at(i).kind != "word":
            return i
        i += 1
        while True:
            if i in self.fixed:
                i += 1
            elif self.at(i).text in ("::", ".", "->") and self.at(i + 1).kind == "word":
                i += 2
            elif self.at(i).text in ("(", "["):
                i = self._end_of_brackets(i)
            else:
                return i

    def _end_of_brackets(self, i: int) -> int:
        depth = 0
        while i < len(self.tokens):
            depth += (self.tokens[i].text in "([{") - (self.tokens[i].text in ")]}")
            i += 1
            if depth == 0:
                break
        return i


Edit = tuple[int, int, str]


def comparison(code: Code, i: int) -> Edit | None:
    t = code.tokens[i]
    return (t.start, t.end, COMPARISONS[t.text]) if t.text in COMPARISONS and code.is_spaced(i) else None


def sign(code: Code, i: int) -> Edit | None:
    t, before, after = code.tokens[i], code.at(i - 1), code.at(i + 1)
    if t.text in SIGNS and code.is_spaced(i):
        has_string = "string" in (before.kind, after.kind)
        return None if has_string else (t.start, t.end, SIGNS[t.text])
    ends_operand = before.kind in ("word", "number", "string") and before.text != "return"
    if t.text != "-" or after.start != t.end or ends_operand or before.text in (")", "]", "}", "operator"):
        return None
    return t.start, t.end, ""


def constant(code: Code, i: int) -> Edit | None:
    t = code.tokens[i]
    if t.kind != "number":
        return None
    if m := FLOATING.fullmatch(t.text):
        return _scaled(t, float(m[1].replace("'", "")), m[2])
    if m := INTEGER.fullmatch(t.text):
        digits = m[1].replace("'", "")
        is_octal = len(digits) > 1 and digits.isdigit() and digits[0] == "0"
        return (t.start, t.end, f"{int(digits, 8 if is_octal else 0) + 1}{m[2]}")
    return None


def _scaled(literal: Token, value: float, suffix: str) -> Edit | None:
    if value == 0 or suffix.lower() not in ("", "f", "l"):
        return None
    digits = f"{value * 1.01:.15g}"
    is_whole = not set(digits) & set(".e")
    return literal.start, literal.end, digits + (".0" if is_whole else "") + suffix


def extreme(code: Code, i: int) -> Edit | None:
    t = code.tokens[i]
    is_called = code.at(i + 1).text in ("(", "<")
    return (t.start, t.end, EXTREMES[t.text]) if t.text in EXTREMES and is_called else None


def term(code: Code, i: int) -> Edit | None:
    operator = code.tokens[i].text
    if operator not in ("+", "-", "*", "/") or not code.is_spaced(i):
        return None
    end = code.end_of_operand(i + 1)
    binds_tighter = operator in "+-" and code.at(end).text in ("*", "/", "%")
    if end == i + 1 or binds_tighter:
        return None
    return code.at(i - 1).end, code.tokens[end - 1].end, ""


def statement(code: Code, i: int) -> Edit | None:
    """A call or an assignment between ; { } and the semicolon at i, on one line."""
    if code.tokens[i].text != ";":
        return None
    first = i
    while code.at(first - 1).text not in (";", "{", "}", ""):
        first -= 1
    start, end = code.at(first).start, code.tokens[i].start
    while code.at(first).text in ("++", "--", "*"):
        first += 1
    after = code.end_of_operand(first)
    is_expression = code.at(after).text in ASSIGNMENTS or (
        after == i and code.at(i - 1).text == ")") or code.at(first - 1).text in ("++", "--")
    is_declaration = code.at(first).text in NO_EXPRESSION or code.at(i - 1).text in ("default", "delete")
    if after == first or is_declaration or not is_expression:
        return None
    return None if "\n" in code.text[start:end] else (start, end, "")


def logical(code: Code, i: int) -> Edit | None:
    t = code.tokens[i]
    if t.text in LOGICAL and code.is_spaced(i) and code.at(i + 1).text != "{":
        return t.start, t.end, LOGICAL[t.text]
    return (t.start, t.end, "") if t.text == "!" else None


KINDS: dict[str, Callable[[Code, int], Edit | None]] = {
    "comparison": comparison, "sign": sign, "constant": constant, "min/max": extreme,
    "dropped term": term, "dropped statement": statement, "logical": logical}


def possible_changes(file: str, text: str) -> list[Change]:
    """Returns every change of one source that mutate.py can make."""
    code, changes = Code(text), []
    for i, token in enumerate(code.tokens):
        for kind, edit_of in KINDS.items():
            if i not in code.fixed and (edit := edit_of(code, i)):
                changes.append(Change(file, text.count("\n", 0, token.start) + 1, kind, *edit))
    return changes


def room_of(file: str) -> str:
    """Returns the folder below src or include/twrench: "picture/body"."""
    parts = file.split("/")[:-1]
    return "/".join(parts[2:] if parts[0] == "include" else parts[1:])


def draw(changes: list[Change], lines: dict[str, int], seed: int) -> Iterator[Change]:
    """Yields each change once, in an order that depends on the seed. Each room gets a share in proportion
    to the square root of its lines, and each kind of change in a room is equally likely."""
    rng = random.Random(seed)
    pools: dict[str, dict[str, list[Change]]] = {}
    for change in changes:
        pools.setdefault(room_of(change.file), {}).setdefault(change.kind, []).append(change)
    first = {room: rng.random() for room in sorted(pools)}
    drawn: Counter[str] = Counter()
    while pools:
        room = min(sorted(pools), key=lambda r: (drawn[r] + first[r]) / math.sqrt(lines[r]))
        drawn[room] += 1
        pool = pools[room][kind := rng.choice(sorted(pools[room]))]
        yield pool.pop(rng.randrange(len(pool)))
        if not pool:
            del pools[room][kind]
        if not pools[room]:
            del pools[room]
