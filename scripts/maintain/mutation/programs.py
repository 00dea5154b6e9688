"""The test programs: their list, their commands from ctest, and running them within limits."""
from __future__ import annotations

import json
import os
import re
import resource
import signal
import subprocess
import time
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from mutation.coverage import Addresses, Definition, Recorder, definitions_of

FAILED = re.compile(r"^(?:\[  FAILED  \]|FAILED|ERROR) (\S+)", re.MULTILINE)
STARTED = re.compile(r"^\[ RUN      \] (\S+)", re.MULTILINE)
LISTED = re.compile(r"^( *)(\S+)", re.MULTILINE)  # a suite, or a case of it
MAX_DATA = 6 << 30  # bytes of each process
MAX_FILE = 8 << 30  # because a test makes a sparse file of 6 GiB
MAX_SILENCE = 120.0  # seconds without output; no test takes as long


@dataclass
class Job:
    """One command of a test program."""

    name: str
    command: list[str]
    environment: dict[str, str]
    folder: str
    expected: str | None = None  # a regular expression that the output must match


@dataclass
class Case:
    """A case of GoogleTest, or another test that ctest lists."""

    name: str
    job: Job
    seconds: float = 0.0  # when unchanged
    definitions: set[Definition] = field(default_factory=set)  # that it runs


@dataclass
class Program:
    """A test program, or the tests of one kind that have no program, such as those of pytest."""

    name: str
    folder: str  # of tests: "base", "cli"
    is_gtest: bool
    cases: list[Case] = field(default_factory=list)
    targets: set[str] = field(default_factory=set)  # of ninja
    binaries: dict[str, bytes] = field(default_factory=dict)  # file -> digest when unchanged
    objects: set[str] = field(default_factory=set)

    @property
    def seconds(self) -> float:
        return sum(case.seconds for case in self.cases)

    def jobs(self, cases: list[Case]) -> list[Job]:
        """The commands that run the cases: for GoogleTest one per processor."""
        if not self.is_gtest:
            return [case.job for case in cases]
        count = min(os.cpu_count() or 1, len(cases))
        return [replace(cases[0].job, name=f"{self.name}-{k}", environment=cases[0].job.environment | {
                    "GTEST_FAIL_FAST": "1", "GTEST_FILTER": ":".join(c.name for c in cases[k::count])})
                for k in range(count)]


def list_programs(build: Path) -> list[Program]:
    """Reads the tests from ctest, and the cases from each program of GoogleTest."""
    text = subprocess.run(["ctest", "--test-dir", str(build), "--show-only=json-v1"],
                          capture_output=True, text=True, check=True).stdout
    programs: dict[str, Program] = {}
    for test in json.loads(text)["tests"]:
        command = test.get("command") or [""]
        is_gtest = Path(command[0]).name.endswith("_test")
        name = Path(command[0]).name if is_gtest else test["name"].split(".")[0]
        job = _job(test, command[:1] if is_gtest else command)
        program = programs.setdefault(name, Program(name, Path(job.folder).name, is_gtest))
        if not is_gtest:
            program.cases.append(Case(job.name, job))
        elif not program.cases:
            program.cases = [_gtest_case(job, case) for case in _gtest_cases(job)]
    return list(programs.values())


def _gtest_cases(job: Job) -> list[str]:
    """The names of the cases, such as "Suite.Case/0"."""
    text = subprocess.run([*job.command, "--gtest_list_tests"], cwd=job.folder, capture_output=True, text=True,
                          check=True).stdout
    cases, suite = list[str](), ""
    for indent, word in LISTED.findall(text):
        if indent:
            cases.append(suite + word)
        elif word.endswith("."):  # not the greeting of main()
            suite = word
    return cases


def _gtest_case(job: Job, name: str) -> Case:
    return Case(name, replace(job, name=name, environment=job.environment | {"GTEST_FILTER": name}))


def _job(test: dict[str, Any], command: list[str]) -> Job:
    properties = {p["name"]: p["value"] for p in test.get("properties", [])}
    environment = dict(word.split("=", 1) for word in properties.get("ENVIRONMENT", []))
    if "pytest" in command:
        command = [*command, "--exitfirst"]
        environment["PYTHONUNBUFFERED"] = "1"  # is_silent() needs the output at once
    return Job(test["name"], command, environment, properties["WORKING_DIRECTORY"],
               "|".join(properties.get("PASS_REGULAR_EXPRESSION", [])) or None)


class Process:
    """A child in a process group that is killed at the end. Its output goes to a file."""

    def __init__(self, job: Job, log: Path, kept_open: Sequence[int]) -> None:
        self.job, self.log, self.is_late = job, log, False
        with log.open("wb") as output:
            self.child = subprocess.Popen(
                job.command, cwd=job.folder, env=os.environ | job.environment, stdin=subprocess.DEVNULL,
                stdout=output, stderr=subprocess.STDOUT, start_new_session=True, pass_fds=kept_open,
                preexec_fn=_limit)

    def output(self) -> str:
        return self.log.read_text(errors="replace")

    def last_test(self) -> str:
        started: list[str] = STARTED.findall(self.output())
        return started[-1] if started else self.job.name

    def is_silent(self) -> bool:
        return time.time() - self.log.stat().st_mtime > MAX_SILENCE

    def failure(self) -> str:
        """Describes the failing test after the process has ended; "" if it passed."""
        if self.is_late:
            return f"{self.last_test()} (timeout)"
        code, output = self.child.returncode, self.output()
        if code == 0 and self.job.expected is None:
            return ""
        if self.job.expected is not None:
            return "" if re.search(self.job.expected, output, re.DOTALL) else self.job.name
        if code < 0:
            return f"{self.last_test()} ({signal.Signals(-code).name})"
        failed = FAILED.search(output)
        return failed[1] if failed else f"{self.job.name} (exit code {code})"

    def kill(self) -> None:
        """Ends the group, first with SIGTERM, so that ninja ends the groups of its compilers."""
        for number in (signal.SIGTERM, signal.SIGKILL):
            try:
                os.killpg(self.child.pid, number)
                self.child.wait(2)
            except (ProcessLookupError, subprocess.TimeoutExpired):
                pass


def _limit() -> None:
    for what, most in [(resource.RLIMIT_DATA, MAX_DATA), (resource.RLIMIT_FSIZE, MAX_FILE),
                       (resource.RLIMIT_CORE, 0)]:
        hard = resource.getrlimit(what)[1]
        resource.setrlimit(what, (most if hard == resource.RLIM_INFINITY else min(most, hard), hard))


def finished(jobs: Iterable[Job], logs: Path, kept_open: Sequence[int], seconds: float) -> Iterator[Process]:
    """Runs the jobs, as many at a time as there are processors. Yields each process when it has ended, or
    when it was killed because it is silent or the time is over. Kills the others if the caller stops."""
    waiting, running, begin = iter(jobs), list[Process](), time.monotonic()
    try:
        while True:
            while len(running) < (os.cpu_count() or 1) and (job := next(waiting, None)):
                running.append(Process(job, logs / f"{job.name.replace('/', '_')}.txt", kept_open))
            if not running:
                return
            for process in list(running):
                has_ended = process.child.poll() is not None
                process.is_late = not has_ended and (time.monotonic() - begin > seconds or process.is_silent())
                if has_ended or process.is_late:
                    running.remove(process)
                    process.kill()  # also the rest of its group
                    yield process
            time.sleep(0.02)
    finally:
        for process in running:
            process.kill()


def run_jobs(jobs: list[Job], logs: Path, kept_open: Sequence[int], seconds: float) -> str:
    """Runs the jobs until one fails. Returns the first failing test; "" if all pass."""
    return next(filter(None, (p.failure() for p in finished(jobs, logs, kept_open, seconds))), "")


def record(cases: list[Case], recorders: list[Recorder], logs: Path, kept_open: Sequence[int]) -> list[str]:
    """Runs each case in a process of its own; sets how long it takes, and the definitions that it runs.
    Returns the cases that fail."""
    free, failures = list(recorders), list[str]()
    running: dict[str, tuple[Case, Recorder, float]] = {}
    records = list[tuple[Case, Addresses]]()

    def start() -> Iterator[Job]:
        for case in cases:
            recorder = free.pop()
            recorder.begin()
            running[case.job.name] = case, recorder, time.monotonic()
            yield replace(case.job, environment=case.job.environment | recorder.environment)

    for process in finished(start(), logs, kept_open, float("inf")):
        case, recorder, begin = running.pop(process.job.name)
        case.seconds = time.monotonic() - begin
        records.append((case, recorder.end()))
        free.append(recorder)
        if failure := process.failure():
            failures.append(failure)
    for (case, _), definitions in zip(records, definitions_of([addresses for _, addresses in records])):
        case.definitions = definitions
    return failures
