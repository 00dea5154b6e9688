#!/usr/bin/env python3
"""Mutation testing: makes small changes in the C++ sources and lists those that no test notices.

usage: mutate.py [--rooms ROOM,...] [--at FILE:LINE] N SEED

Makes N changes, one at a time, chosen by SEED among the committed sources: the same N and SEED choose
the same changes of the same sources. Runs the tests of the changed room, then those of the rooms above
it, then those of the program and of the Python module, until one fails. Leaves out the cases that do not
run the changed function when nothing is changed.

Changes are made only in a copy of the sources, build/mutate/source, which is built in
build/mutate/build. The results are also written to build/mutate/SEED.log and build/mutate/SEED.json.

  --rooms ROOM,...  change only these rooms (folders of src, such as motion or picture/body)
  --at FILE:LINE    change only this line, in at most N ways

Exit code: 0 if at most 10 % of the changes survive, 1 if more do, 2 for wrong usage, 3 if the changes
could not be tested, 130 if interrupted.
"""
from __future__ import annotations

import argparse
import errno
import fcntl
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from collections import Counter
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import NoReturn, TextIO

sys.dont_write_bytecode = True
from mutation.changes import Change, draw, possible_changes, room_of
from mutation.coverage import Definitions, Module, Recorder
from mutation.programs import Case, Program, list_programs, record, run_jobs
from mutation.tree import AppliedChange, BuildError, Tree, rooms_above

PROJECT = Path(__file__).resolve().parents[2]
ACCEPTED = 0.10  # share of survivors
NOT_COMPILED, SAME_CODE, SURVIVED, NOTICED = "did not compile", "same machine code", "survived", "noticed"
NEEDED_SPACE = 4 << 30  # bytes of the build, the logs and the files of the tests


class CannotRun(Exception):
    """The message describes the problem and the remedy."""


@dataclass
class Result:
    file: str
    line: int
    room: str
    kind: str
    before: str
    after: str
    verdict: str
    program: str
    test: str
    seconds: float


def lines_of(result: Result) -> str:
    return f"\n  - {result.before}\n  + {result.after}"


class Report:
    """Prints each result and writes it to the log; at the end survivors and counts."""

    def __init__(self, home: Path, count: int, seed: int) -> None:
        self.count, self.seed, self.results = count, seed, list[Result]()
        self.json = home / f"{seed}.json"
        self.log = (home / f"{seed}.log").open("w", buffering=1)

    def say(self, line: str) -> None:
        print(line, flush=True)
        print(line, file=self.log)

    def decided(self) -> list[Result]:
        return [r for r in self.results if r.verdict in (SURVIVED, NOTICED)]

    def survivors(self) -> list[Result]:
        return [r for r in self.results if r.verdict == SURVIVED]

    def add(self, result: Result) -> None:
        self.results.append(result)
        verdict = {SURVIVED: "SURVIVED", NOTICED: f"noticed by {result.program} {result.test}"}
        self.say(f"{len(self.decided())}/{self.count} {result.file}:{result.line} {result.kind}: "
                 f"{verdict.get(result.verdict, result.verdict)} in {result.seconds:.1f} s"
                 + (lines_of(result) if result.verdict == SURVIVED else ""))
        self.json.write_text(json.dumps({"n": self.count, "seed": self.seed,
                                         "changes": [asdict(r) for r in self.results]}, indent=1))

    def finish(self) -> float:
        """Prints the summary. Returns the share of survivors."""
        decided, survivors = self.decided(), self.survivors()
        for r in survivors:
            self.say(f"\n{r.file}:{r.line} {r.kind}{lines_of(r)}")
        self._count("kind", [r.kind for r in decided], [r.kind for r in survivors])
        self._count("room", [r.room for r in decided], [r.room for r in survivors])
        for verdict in (NOT_COMPILED, SAME_CODE):
            self.say(f"{verdict}: {sum(r.verdict == verdict for r in self.results)}")
        share = len(survivors) / max(1, len(decided))
        self.say(f"survived: {len(survivors)} of {len(decided)} changes, {100 * share:.1f} %")
        return share

    def _count(self, title: str, decided: list[str], survivors: list[str]) -> None:
        self.say(f"\n{title:<18} changes survived")
        for name, number in sorted(Counter(decided).items()):
            self.say(f"{name:<18} {number:>7} {Counter(survivors)[name]:>8}")
        self.say("")


class Tester:
    """Runs the test programs, unchanged at first, then for one change after another."""

    def __init__(self, tree: Tree, sources: dict[str, str]) -> None:
        self.tree, self.sources, self.above = tree, sources, rooms_above(sources)
        self.programs: list[Program] = []
        self.definitions = {file: Definitions(file, text) for file, text in sources.items()}

    def run_unchanged(self, report: Report, rooms: set[str]) -> None:
        """Records how long each case takes, and what it runs. Fails if one does not pass."""
        self.programs = list_programs(self.tree.build)
        self.tree.read_graph(self.programs)
        used = {id(p) for room in rooms for p in self.order(room)}
        files = {file for program in self.programs for file in program.binaries}
        modules = [Module(self.tree.build / file, self.tree.source, self.definitions) for file in sorted(files)]
        recorders = [Recorder(self.tree.logs / f"trace-{k}", modules) for k in range(os.cpu_count() or 1)]
        failing = []
        for program in [p for p in self.programs if id(p) in used]:
            begin = time.monotonic()
            failures = record(program.cases, recorders, self.tree.logs, self.tree.kept_open)
            report.say(f"unchanged: {program.name} {'fails' if failures else 'passes'} "
                       f"in {time.monotonic() - begin:.1f} s")
            failing += [f"{program.name} ({failure})" for failure in failures]
        if failing:
            raise CannotRun(f"{', '.join(failing)} fails without any change; make scripts/test.sh pass first")

    def cases(self, program: Program, change: Change) -> list[Case]:
        """The cases that may notice a change: those that run the changed function. Another definition, such
        as a constant, may be used anywhere in its source, and that of a header anywhere."""
        definitions = self.definitions[change.file]
        if definitions.is_function_at(change.line):
            return [c for c in program.cases if definitions.at(change.line) in c.definitions]
        if change.file.endswith(".cpp"):
            return [c for c in program.cases if any(d.file == change.file for d in c.definitions)]
        return program.cases

    def order(self, room: str) -> list[Program]:
        """The programs that may notice a change of a room: that of the room first, then those of the
        nearest rooms above it, the quick ones first, and last those that run the whole program."""
        distance: dict[str, int] = {}
        for name, steps in self.above[room].items():
            folder = name.split("/")[0]
            distance[folder] = min(steps, distance.get(folder, steps))
        rooms = {name.split("/")[0] for name in self.above}
        objects = {o for file in self.sources if room_of(file) == room for o in self.tree.objects[file]}
        programs = [p for p in self.programs
                    if p.objects & objects and (p.folder in distance or p.folder not in rooms)]
        return sorted(programs, key=lambda p: (distance.get(p.folder, len(self.above)), p.seconds, p.name))

    def test(self, change: Change) -> Result:
        begin = time.monotonic()
        with AppliedChange(self.tree, change):
            verdict, program, test = self._verdict(change)
        text = self.sources[change.file]
        first, last = text.rfind("\n", 0, change.start) + 1, text.find("\n", change.end)
        after = text[first : change.start] + change.new + text[change.end : last]
        return Result(change.file, change.line, room_of(change.file), change.kind, text[first:last].strip(),
                      after.strip(), verdict, program, test, round(time.monotonic() - begin, 1))

    def _verdict(self, change: Change) -> tuple[str, str, str]:
        compiled: set[str] = set()
        changed: set[str] = set()
        for program in self.order(room_of(change.file)):
            objects = program.objects & self.tree.objects[change.file]
            if new := objects - compiled:
                try:
                    self.tree.make(*sorted(new))
                except BuildError:
                    return NOT_COMPILED, "", ""
                compiled |= new
                changed |= {file for file in new if self.tree.digest(file) != self.tree.digests[file]}
            cases = self.cases(program, change) if objects & changed else []
            if not cases:
                continue
            try:
                self.tree.make(*sorted(program.targets))
            except BuildError:  # the build runs a changed program, which writes the manual pages
                return NOTICED, program.name, "(the build)"
            if self.tree.is_unchanged(program):
                continue
            limit = 10 * sum(case.seconds for case in cases) + 30
            if failure := run_jobs(program.jobs(cases), self.tree.logs, self.tree.kept_open, limit):
                return NOTICED, program.name, failure
        return (SURVIVED if changed else SAME_CODE), "", ""


def arguments() -> argparse.Namespace:
    summary, usage, description = (__doc__ or "").split("\n\n", 2)
    parser = argparse.ArgumentParser(usage=usage.removeprefix("usage: "), allow_abbrev=False,
                                     formatter_class=argparse.RawDescriptionHelpFormatter,
                                     description=f"{summary}\n\n{description}")
    for name in ("--rooms", "--at", "n", "seed"):
        parser.add_argument(name, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if not re.fullmatch(r"0*[1-9]\d{0,8}", options.n):
        usage_error(f"N is '{options.n}'; give the number of changes, such as 50")
    if not re.fullmatch(r"\d{1,18}", options.seed):
        usage_error(f"SEED is '{options.seed}'; give a whole number from 0, such as 2026")
    if options.at and not re.fullmatch(r".+:\d+", options.at):
        usage_error(f"--at is '{options.at}'; give a file and a line, such as src/motion/stepper.cpp:42")
    return options


def usage_error(message: str) -> NoReturn:
    print(f"mutate.py: error: {message}", file=sys.stderr)
    sys.exit(2)


def selected_changes(options: argparse.Namespace, sources: dict[str, str]) -> list[Change]:
    rooms = {room_of(file) for file in sources}
    wanted = set(options.rooms.split(",")) if options.rooms else rooms
    if unknown := sorted(wanted - rooms):
        usage_error(f"no room '{unknown[0]}'; the rooms are {', '.join(sorted(rooms))}")
    changes = [c for file, text in sources.items() if room_of(file) in wanted for c in possible_changes(file, text)]
    if options.at:
        file, line = options.at.rsplit(":", 1)
        if file not in sources:
            usage_error(f"no committed source '{file}'; give its path from the project's folder")
        changes = [c for c in changes if c.file == file and c.line == int(line)]
    if not changes:
        usage_error("nothing can be changed there; choose another line or room")
    return changes


def prepare(tree: Tree) -> None:
    """Copies the committed sources. Raises CannotRun if a requirement is missing."""
    if subprocess.run(["git", "rev-parse", "--verify", "--quiet", "HEAD"], cwd=PROJECT,
                      capture_output=True).returncode != 0 or not (PROJECT / ".git").exists():
        raise CannotRun(f"{PROJECT} is not a git checkout with a commit; clone the repository")
    if subprocess.run([PROJECT / "scripts/maintain/setup.sh", "test"], stdin=subprocess.DEVNULL).returncode != 0:
        raise CannotRun("packages are missing; install them as described above")
    is_built = (tree.build / ".ninja_deps").exists()
    if shutil.disk_usage(tree.home).free < NEEDED_SPACE // (4 if is_built else 1):
        raise CannotRun(f"the disk of {tree.home} is almost full; free {NEEDED_SPACE >> 30} GB")
    for folder in (tree.source, tree.build, tree.logs):
        folder.mkdir(exist_ok=True)
    tree.copy_sources()


def build_unchanged(tree: Tree, report: Report) -> None:
    begin = time.monotonic()
    try:
        tree.configure(next((name for name in ("mold", "lld") if shutil.which(f"ld.{name}")), None))
        tree.make()
    except BuildError as error:
        raise CannotRun(f"the committed sources do not build; see {error} and correct them") from None
    report.say(f"unchanged: built in {time.monotonic() - begin:.0f} s")


def run(options: argparse.Namespace, tree: Tree) -> int:
    prepare(tree)
    sources = tree.read_sources()
    changes = selected_changes(options, sources)
    count, seed = int(options.n), int(options.seed)
    report = Report(tree.home, count, seed)
    build_unchanged(tree, report)
    tester = Tester(tree, sources)
    try:
        tester.run_unchanged(report, {room_of(c.file) for c in changes})
        lines = Counter[str]()
        for file, text in sources.items():
            lines[room_of(file)] += text.count("\n")
        for change in draw(changes, lines, seed):
            report.add(tester.test(change))
            if len(report.decided()) == count:
                break
    except KeyboardInterrupt:
        report.finish()
        raise
    return 1 if report.finish() > ACCEPTED else 0


def take(lock: TextIO, seconds: int) -> None:
    """Locks the file. The children of a run also hold its lock, because those of a killed run may still
    be running."""
    for _ in range(10 * seconds):
        try:
            return fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            time.sleep(0.1)
    raise CannotRun(f"another run uses {Path(lock.name).parent}; wait for its end, then try again")


def interrupt(*_: object) -> NoReturn:
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_IGN)  # restoring the copy takes less than a second
    raise KeyboardInterrupt


def main() -> int:
    options = arguments()
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, interrupt)
    home = PROJECT / "build/mutate"
    try:
        home.mkdir(parents=True, exist_ok=True)
        with (home / "lock").open("w") as lock:
            take(lock, 10)
            return run(options, Tree(PROJECT, lock.fileno()))
    except KeyboardInterrupt:
        print("mutate.py: interrupted; your sources are unchanged", file=sys.stderr)
        return 130
    except CannotRun as error:
        print(f"mutate.py: error: {error}", file=sys.stderr)
    except OSError as error:
        place = f"{error.filename}: " if error.filename else ""
        remedy = "free some space" if error.errno == errno.ENOSPC else "correct that"
        print(f"mutate.py: error: {place}{error.strerror}; {remedy}, then try again", file=sys.stderr)
    return 3


if __name__ == "__main__":
    sys.exit(main())
