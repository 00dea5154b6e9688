"""The copy of the sources, its build by ninja, and one change of it at a time."""
from __future__ import annotations

import errno
import hashlib
import io
import os
import re
import subprocess
import tarfile
from collections import defaultdict
from pathlib import Path

from mutation.changes import Change, room_of
from mutation.programs import Job, Process, Program

SOURCES = re.compile(r"src/.*\.(cpp|h)|include/twrench/.*\.h")
INCLUDE = re.compile(r'^#include (?:"|<twrench/)((?:\w+/)+)\w+\.h[">]', re.MULTILINE)

# Options of the compiler for trace.c and for finding the functions. The many small functions of other libraries
# would cost time and are never changed. A column would change the objects of a change that does not change the
# code. addr2line 2.40 gives wrong files for inlined functions in DWARF 5.
RECORDING = ("-finstrument-functions -finstrument-functions-exclude-file-list=/usr/include,/usr/lib/gcc "
             "-g1 -gdwarf-4 -gno-column-info")


class BuildError(Exception):
    """The sources do not build; the message is the path of the log."""


class Tree:
    """build/mutate: `source` is a copy of the committed sources, `build` its build."""

    def __init__(self, project: Path, lock: int) -> None:
        self.project, self.home = project, project / "build/mutate"
        self.source, self.build, self.logs = (self.home / name for name in ("source", "build", "logs"))
        self.kept_open = (lock,)
        self.digests: dict[str, bytes] = {}
        self.objects: dict[str, set[str]] = {}
        self.outputs: list[str] = []

    def copy_sources(self) -> None:
        """Makes `source` equal to the commit. Writes only files that differ, so that little is rebuilt."""
        archive = subprocess.run(["git", "archive", "HEAD"], cwd=self.project, capture_output=True, check=True)
        wanted = set()
        with tarfile.open(fileobj=io.BytesIO(archive.stdout)) as tar:
            for member in tar:
                path = self.source / member.name
                wanted.add(path)
                content = tar.extractfile(member) if member.isfile() else None
                if content is None:
                    if not os.path.lexists(path):
                        tar.extract(member, self.source)
                elif not path.is_file() or path.read_bytes() != content.read():
                    tar.extract(member, self.source)
                    os.utime(path)
        for folder, _, names in os.walk(self.source):
            for name in names:
                if (path := Path(folder, name)) not in wanted:
                    path.unlink()

    def configure(self, linker: str | None) -> None:
        trace = self.build / "trace.o"
        source = self.source / "scripts/maintain/mutation/trace.c"
        self._run(["cc", "-O2", "-fPIC", "-c", str(source), "-o", str(trace)], "configure")
        flags = f"-O1 -D_GLIBCXX_ASSERTIONS {RECORDING}"  # bounds are checked
        options = ["-DCMAKE_BUILD_TYPE=Release", f"-DCMAKE_CXX_FLAGS_RELEASE={flags}", "-DBUILD_TESTING=ON",
                   "-DTWRENCH_PYTHON=ON", "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_UNITY_BUILD_BATCH_SIZE=4",
                   "-DCMAKE_GTEST_DISCOVER_TESTS_DISCOVERY_MODE=PRE_TEST"]
        linked = f"{trace} -fuse-ld={linker}" if linker else str(trace)
        options += [f"-DCMAKE_{kind}_LINKER_FLAGS={linked}" for kind in ("EXE", "SHARED", "MODULE")]
        self._run(["cmake", "-G", "Ninja", "-S", str(self.source), "-B", str(self.build), *options], "configure")

    def make(self, *targets: str) -> None:
        # A changed program that writes files for the build may never end.
        self._run(["ninja", "-C", str(self.build), *targets], "build", *([1800] if targets else []))

    def _run(self, command: list[str], name: str, seconds: float = 3 * 3600) -> None:
        log = self.logs / f"{name}.log"
        process = Process(Job(name, command, {}, str(self.home)), log, self.kept_open)
        try:
            code = process.child.wait(seconds)
        except subprocess.TimeoutExpired:
            raise BuildError(str(log)) from None
        finally:
            process.kill()
        if code != 0:
            if "No space left on device" in process.output():
                raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(self.build))
            raise BuildError(str(log))

    def _query(self, *words: str) -> str:
        command = ["ninja", "-C", str(self.build), "-t", *words]
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout

    def read_graph(self, programs: list[Program]) -> None:
        """Records, for the unchanged build, the objects of each source and the parts of each program."""
        self.outputs = [line.rsplit(": ", 1)[0] for line in self._query("targets", "all").splitlines()]
        known, self.objects, current = set(self.outputs), defaultdict(set), ""
        for line in self._query("deps").splitlines():
            if not line.startswith(" "):
                current = line.split(": #deps")[0]
            elif line.strip().startswith(f"{self.source}/"):
                self.objects[line.strip().removeprefix(f"{self.source}/")].add(current)
        for file in {o for some in self.objects.values() for o in some}:
            self.digests[file] = self.digest(file)
        for program in programs:
            program.targets = self._targets(program, known)
            inputs = set(self._query("inputs", *program.targets).split("\n")) if program.targets else set()
            program.objects = {file for file in inputs if file.endswith(".o")}
            files = [f for f in inputs | program.targets if f.startswith(("bin/", "python/twrench/"))]
            program.binaries = {file: self.digest(file) for file in files if (self.build / file).is_file()}

    def _targets(self, program: Program, known: set[str]) -> set[str]:
        """The ninja targets among the files and folders that the commands and their environment name."""
        targets = set()
        for job in [case.job for case in program.cases]:
            for name in re.findall(rf"{re.escape(str(self.build))}/([\w./-]+)",
                                   "\n".join([*job.command, *job.environment.values()])):
                inside = (self.build / name).rglob("*.so") if (self.build / name).is_dir() else []
                targets |= {name, *(str(file.relative_to(self.build)) for file in inside)} & known
        return targets

    def digest(self, file: str) -> bytes:
        return hashlib.blake2b((self.build / file).read_bytes()).digest()

    def is_unchanged(self, program: Program) -> bool:
        return all(self.digest(file) == digest for file, digest in program.binaries.items())

    def read_sources(self) -> dict[str, str]:
        files = sorted(p.relative_to(self.source).as_posix() for p in self.source.rglob("*.*"))
        return {file: (self.source / file).read_text() for file in files if SOURCES.fullmatch(file)}


class AppliedChange:
    """A context in which the copy is changed. At its end the source and its objects are restored, and
    files linked from the changed objects are removed, so that nothing need be compiled again."""

    def __init__(self, tree: Tree, change: Change) -> None:
        self.tree, self.path = tree, tree.source / change.file
        self.source = self.path.read_bytes()
        text = self.source.decode()
        self.changed = (text[: change.start] + change.new + text[change.end :]).encode()
        self.time = self.path.stat().st_mtime_ns
        files = [tree.build / name for name in tree.objects[change.file]]
        self.objects = {file: (file.read_bytes(), file.stat().st_mtime_ns) for file in files}

    def __enter__(self) -> None:
        self._write(self.changed)
        self.begin = self.path.stat().st_mtime_ns

    def __exit__(self, *_: object) -> None:
        # The source is restored last, because until then its new time causes a complete rebuild
        # after a crash.
        for name in self.tree.outputs:
            file = self.tree.build / name
            if file in self.objects or name == "build.ninja" or name.startswith("CMakeFiles/"):
                continue
            if file.is_file() and file.stat().st_mtime_ns >= self.begin:
                file.unlink()
        for file, (content, time) in self.objects.items():
            # ninja compares this time with the one that it recorded when it compiled the object.
            if file.exists():
                time = file.stat().st_mtime_ns
            file.write_bytes(content)
            os.utime(file, ns=(time, time))
        self._write(self.source, self.time)

    def _write(self, content: bytes, time: int | None = None) -> None:
        temporary = self.path.with_name(f".{self.path.name}")
        temporary.write_bytes(content)
        if time is not None:
            os.utime(temporary, ns=(time, time))
        temporary.replace(self.path)


def rooms_above(sources: dict[str, str]) -> dict[str, dict[str, int]]:
    """Returns for each room the rooms that include it, directly or not, and how many steps away they are.
    The room itself is 0 steps away."""
    includers = defaultdict(set)
    for file, text in sources.items():
        for room in INCLUDE.findall(text):
            includers[room.rstrip("/")].add(room_of(file))
    above = {}
    for start in {room_of(file) for file in sources}:
        distance, reached = {start: 0}, [start]
        for room in reached:
            new = sorted(includers[room] - distance.keys())
            distance |= {other: distance[room] + 1 for other in new}
            reached += new
        above[start] = distance
    return above
