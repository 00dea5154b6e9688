"""The commands of the pages run, and print what the pages show."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
from pathlib import Path

import pytest

from sound_files import write_sound

PROJECT = Path(__file__).parents[2]
PAGES = ["docs/tutorial.md", "docs/how-to.md", "README.md"]
WITHOUT_OUTPUT = [
    "docs/check.md", "docs/export.md", "docs/page.md", "docs/report.md", "docs/robots.md"
]
NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")


def sessions(page: str) -> list[tuple[str, list[str]]]:
    """The commands of a page after `$`, each with the lines that it prints; `...` stands for
    any lines, or for the rest of a line."""
    found: list[tuple[str, list[str]]] = []
    is_output = False
    for line in (PROJECT / page).read_text().splitlines():
        if line.startswith("    $ "):
            found.append((line[6:], []))
            is_output = True
        elif line.startswith("    ") and is_output:
            found[-1][1].append(line[4:])
        elif line:
            is_output = False
        elif is_output and found[-1][1]:
            found[-1][1].append("")
    return found


def pattern(shown: list[str]) -> str:
    """A regular expression of the output, which may have more lines at the end."""

    def part(line: str) -> str:
        if line == "...":
            return r"(?:.*\n)*?"
        end = r".*\n" if line.endswith("...") else r" *\n"
        return re.escape(line.removesuffix("...").rstrip()) + end

    return "".join(map(part, shown))


def is_near(shown: str, printed: str) -> bool:
    """Whether two lines differ only in rounding errors, and in the spaces beside them."""
    words = [re.sub(" +", "", "0".join(NUMBER.split(line))) for line in (shown, printed)]
    numbers = [[float(word) for word in NUMBER.findall(line)] for line in (shown, printed)]
    return words[0] == words[1] and all(
        abs(one - other) <= 1e-9 + 1e-6 * abs(one) for one, other in zip(*numbers)
    )


def with_program() -> dict[str, str]:
    """The environment in which `twrench` is the tested program."""
    folder = Path(os.environ["TWRENCH_PROGRAM"]).parent
    return os.environ | {"PATH": f"{folder}:{os.environ['PATH']}"}


def write_scenes(page: str, folder: Path) -> None:
    """Writes each TOML block of the page to the file that the sentence before it names."""
    text = (PROJECT / page).read_text()
    for name, scene in re.findall(r"`([\w-]+\.toml)`[^`]*```toml\n(.*?)^```", text, re.M | re.S):
        (folder / name).write_text(scene)


def write_stl(file: Path) -> None:
    """Writes a tetrahedron with three different moments of inertia."""
    corners = [(0, 0, 0), (80, 0, 0), (0, 50, 0), (0, 0, 20)]
    lines = ["solid bracket"]
    for triangle in ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)):
        vertices = [f"vertex {x} {y} {z}" for x, y, z in (corners[i] for i in triangle)]
        lines += ["facet normal 0 0 0", "outer loop", *vertices, "endloop", "endfacet"]
    file.write_text("\n".join([*lines, "endsolid bracket", ""]))


@pytest.mark.parametrize("page", PAGES)
def test_the_commands_of_a_page_run(page, tmp_path, template):
    write_scenes(page, tmp_path)
    shutil.copy(PROJECT / "assets/meshes/hammer-claws.obj", tmp_path / "bracket.obj")
    write_stl(tmp_path / "bracket.stl")
    write_sound(tmp_path / "music.wav", 1)
    shutil.copy(PROJECT / "examples/robot/arm.urdf", tmp_path)
    shutil.copytree(PROJECT / "examples/toss", tmp_path / "examples/toss")
    commands = sessions(page)
    assert len(commands) > 5
    for command, shown in commands:
        words = shlex.split(command)
        assert words[0] == "twrench"
        if words[1] == "render" and "--frames" not in words:
            words += ["--frames", "0-3"]  # the frames of a film differ in the pose alone
        if words[1] == "render" and "--size" not in words:
            words += ["--size", "320x180"]
        if words[1] == "page":
            words += ["--template", str(template)]  # the real one is built by scripts/maintain/page.sh
        run = subprocess.run(words, cwd=tmp_path, env=with_program(), capture_output=True, text=True)
        printed = run.stdout + run.stderr
        # The arm has a link that no body has.
        fails = any("error:" in line for line in shown) or "arm.urdf" in words
        assert (run.returncode != 0) == fails, f"{command}\n{printed}"
        while shown and not shown[-1]:
            shown = shown[:-1]
        assert re.match(pattern(shown), printed + "\n"), f"{command}\n{printed}"


def test_the_tasks_have_the_numbers_that_the_program_prints(tmp_path):
    commands = [found for found in sessions("docs/tasks.md") if "render" not in found[0]]
    assert len(commands) > 10
    for command, shown in commands:
        script = "set -o pipefail; " + command
        run = subprocess.run(
            ["bash", "-c", script], cwd=tmp_path, env=with_program(), capture_output=True, text=True
        )
        assert run.returncode == 0, f"{command}\n{run.stderr}"
        printed = run.stdout.splitlines()
        while shown and not shown[-1]:
            shown = shown[:-1]
        assert len(printed) >= len(shown), f"{command}\n{run.stdout}"
        for one, other in zip(shown, printed):
            assert is_near(one, other), f"{command}\n{one}\n{other}"


@pytest.mark.parametrize("page", WITHOUT_OUTPUT)
def test_the_commands_of_other_pages_run(page, tmp_path, template):
    text = (PROJECT / page).read_text()
    commands = re.findall(r"^    (twrench .*)$", text, re.M)
    assert len(commands) > 1
    shutil.copy(PROJECT / "examples/robot/arm.urdf", tmp_path)
    shutil.copytree(PROJECT / "examples/toss", tmp_path / "examples/toss")
    samples = "simulate tennis-racket --method exact --times 0,1,2 -o run.csv"
    for command in [f"twrench {samples}", *commands]:
        words = shlex.split(command, comments=True)
        if words[1] == "render":
            words += ["--frames", "0-3", "--size", "160x90"]
        if words[1] == "page":
            words += ["--template", str(template)]
            if "--size" not in words:
                words += ["--size", "160x90"]
        if words[1] == "report":
            words += ["--static"]  # without the page, which scripts/maintain/page.sh builds
        run = subprocess.run(words, cwd=tmp_path, env=with_program(), capture_output=True, text=True)
        # check has a negative verdict on a motion of another body, inertia on an impossible link.
        may_be_negative = words[1] in ("check", "inertia")
        assert run.returncode in ((0, 1) if may_be_negative else (0,)), f"{command}\n{run.stderr}"
