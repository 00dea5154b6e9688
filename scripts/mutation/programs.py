"""The test programs: their list, their commands from ctest, and running them within limits."""
from __future__ import annotations

import json
import os
import re
import resource
import signal
import subprocess
import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

FAILED = re.compile(r"^(?:\[  FAILED  \]|FAILED|ERROR) (\S+)", re.MULTILINE)
STARTED = re.compile(r"^\[ RUN      \] (\S+)", re.MULTILINE)
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
class Program:
    """A test program, or the tests of one kind that have no program, such as those of pytest."""

    name: str
    folder: str  # of tests: "base", "cli"
    jobs: list[Job] = field(default_factory=list)
    targets: set[str] = field(default_factory=set)  # of ninja
    binaries: dict[str, bytes] = field(default_factory=dict)  # file -> digest when unchanged
    objects: set[str] = field(default_factory=set)
    seconds: float = 0.0  # when unchanged


@dataclass
class Outcome:
    """`failure` describes the first failing test; it is empty if all passed."""

    failure: str
    seconds: float


def list_programs(build: Path) -> list[Program]:
    """Reads the tests from ctest. The cases of a GoogleTest program are run by one process per processor,
    whether ctest lists the program or its cases."""
    text = subprocess.run(["ctest", "--test-dir", str(build), "--show-only=json-v1"],
                          capture_output=True, text=True, check=True).stdout
    programs: dict[str, Program] = {}
    for test in json.loads(text)["tests"]:
        command = test.get("command") or [""]
        is_gtest = Path(command[0]).name.endswith("_test")
        name = Path(command[0]).name if is_gtest else test["name"].split(".")[0]
        job = _job(test, command[:1] if is_gtest else command)
        program = programs.setdefault(name, Program(name, Path(job.folder).name))
        if not is_gtest:
            program.jobs.append(job)
        elif not program.jobs:
            program.jobs = [_shard(job, k, os.cpu_count() or 1) for k in range(os.cpu_count() or 1)]
    return list(programs.values())


def _job(test: dict[str, Any], command: list[str]) -> Job:
    properties = {p["name"]: p["value"] for p in test.get("properties", [])}
    environment = dict(word.split("=", 1) for word in properties.get("ENVIRONMENT", []))
    if "pytest" in command:
        command = [*command, "--exitfirst"]
        environment["PYTHONUNBUFFERED"] = "1"  # is_silent() needs the output at once
    return Job(test["name"], command, environment, properties["WORKING_DIRECTORY"],
               "|".join(properties.get("PASS_REGULAR_EXPRESSION", [])) or None)


def _shard(job: Job, index: int, count: int) -> Job:
    sharding = {"GTEST_FAIL_FAST": "1", "GTEST_TOTAL_SHARDS": str(count), "GTEST_SHARD_INDEX": str(index)}
    return Job(f"{Path(job.command[0]).name}-{index}", job.command, job.environment | sharding, job.folder)


class Process:
    """A child in a process group that is killed at the end. Its output goes to a file."""

    def __init__(self, job: Job, log: Path, kept_open: Sequence[int]) -> None:
        self.job, self.log = job, log
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


def run_program(program: Program, logs: Path, kept_open: Sequence[int], seconds: float) -> Outcome:
    """Runs the jobs, as many at a time as there are processors, until one fails or the time is over."""
    waiting, running, begin = list(program.jobs), list[Process](), time.monotonic()
    try:
        while waiting or running:
            while waiting and len(running) < (os.cpu_count() or 1):
                job = waiting.pop(0)
                running.append(Process(job, logs / f"{job.name}.txt", kept_open))
            for process in list(running):
                if process.child.poll() is not None:
                    process.kill()  # the rest of its group
                    running.remove(process)
                    if failure := process.failure():
                        return Outcome(failure, time.monotonic() - begin)
                elif time.monotonic() - begin > seconds or process.is_silent():
                    return Outcome(f"{process.last_test()} (timeout)", time.monotonic() - begin)
            time.sleep(0.02)
        return Outcome("", time.monotonic() - begin)
    finally:
        for process in running:
            process.kill()
