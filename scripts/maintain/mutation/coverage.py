"""Finds the functions of the sources that a test runs, in the records of trace.c."""
from __future__ import annotations

import os
import re
import subprocess
from array import array
from bisect import bisect_right
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

RECORD = re.compile(b"\1")
PLACE = re.compile(r"(.+):(\d+)")
# A definition at namespace scope begins in the first column with anything but these.
INSIDE = re.compile(r"[\s}#/)]|(?:public|private|protected):")
COMPILE_TIME = re.compile(r"\b(?:constexpr|consteval|class|struct|enum|union|namespace)\b")


@dataclass(frozen=True)
class Definition:
    """A definition at namespace scope, by the line where it begins."""

    file: str
    line: int


class Definitions:
    """The definitions of one source as clang-format sets them."""

    def __init__(self, file: str, text: str) -> None:
        self.file = file
        lines = text.splitlines()
        self.begins = [i for i, line in enumerate(lines, 1) if line and not INSIDE.match(line)] or [1]
        ends = [*self.begins[1:], len(lines) + 1]
        self.runs = [self._runs("\n".join(lines[a - 1 : b - 1])) for a, b in zip(self.begins, ends)]

    def _runs(self, text: str) -> bool:
        head = re.split(r"[{;]", text, maxsplit=1)
        return len(head) > 1 and text[len(head[0])] == "{" and "(" in head[0] and not COMPILE_TIME.search(head[0])

    def _index(self, line: int) -> int:
        return max(0, bisect_right(self.begins, line) - 1)

    def at(self, line: int) -> Definition:
        return Definition(self.file, self.begins[self._index(line)])

    def is_function_at(self, line: int) -> bool:
        """Whether the definition is code that runs only at run time."""
        return self.runs[self._index(line)]


class Module:
    """A program or library. Knows which definitions contain the code at its addresses."""

    def __init__(self, path: Path, source: Path, definitions: dict[str, Definitions]) -> None:
        self.path, self.source, self.definitions = path, source, definitions
        self.known: dict[int, frozenset[Definition]] = {}

    def definitions_at(self, addresses: Iterable[int]) -> set[Definition]:
        return set().union(*(self.known[a] for a in addresses))

    def learn(self, addresses: set[int]) -> None:
        """Must contain all addresses before definitions_at() is called. addr2line takes long to start."""
        if new := sorted(addresses - self.known.keys()):
            self.known.update(zip(new, self._find(new)))

    def _find(self, addresses: list[int]) -> Iterator[frozenset[Definition]]:
        # The recorded addresses are those to which the functions' calls return.
        output = subprocess.run(["addr2line", "--addresses", "--inlines", f"--exe={self.path}"],
                                input="\n".join(f"{a - 1:#x}" for a in addresses), text=True,
                                capture_output=True, check=True).stdout
        for places in re.split(r"^0x[\da-f]+\n", output, flags=re.MULTILINE)[1:]:
            found = set()
            for match in PLACE.finditer(places):
                file = os.path.relpath(match[1], self.source)
                if file in self.definitions:
                    found.add(self.definitions[file].at(int(match[2])))
            yield frozenset(found)


# The addresses of the code that one process and its children run.
Addresses = dict[Module, "array[int]"]


class Recorder:
    """A folder for the records of one process and its children."""

    def __init__(self, folder: Path, modules: list[Module]) -> None:
        self.folder, self.modules = folder, modules
        folder.mkdir(parents=True, exist_ok=True)
        self.environment = {"TWRENCH_TRACE": str(folder)}

    def begin(self) -> None:
        for module in self.modules:
            file = self.folder / module.path.name
            file.unlink(missing_ok=True)  # a process that was left over may still write to it
            with file.open("wb") as record:
                record.truncate(module.path.stat().st_size)

    def end(self) -> Addresses:
        found = {}
        for module in self.modules:
            file = self.folder / module.path.name
            found[module] = array("L", recorded_addresses(file))
            file.unlink()
        return found


def definitions_of(records: list[Addresses]) -> list[set[Definition]]:
    """Returns for each record the definitions that contain its addresses."""
    for module in {module for record in records for module in record}:
        module.learn(set().union(*(record[module] for record in records)))
    return [set().union(*(module.definitions_at(found) for module, found in record.items())) for record in records]


def recorded_addresses(file: Path) -> Iterator[int]:
    with file.open("rb") as record:
        begin, size = 0, os.fstat(record.fileno()).st_size
        while begin < size:
            try:
                begin = os.lseek(record.fileno(), begin, os.SEEK_DATA)
            except OSError:  # only a hole is left
                return
            end = os.lseek(record.fileno(), begin, os.SEEK_HOLE)
            for match in RECORD.finditer(os.pread(record.fileno(), end - begin, begin)):
                yield begin + match.start()
            begin = end
