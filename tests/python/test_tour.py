"""The Python of docs/python.md runs from its first line to its last, and prints what the page says."""

from __future__ import annotations

import contextlib
import io
import re
from pathlib import Path
from typing import Any

import pytest

PROJECT = Path(__file__).parents[2]


def blocks(page: str, language: str) -> list[str]:
    """The fenced blocks of a page in a language."""
    text = (PROJECT / "docs" / page).read_text()
    return re.findall(rf"^```{language}\n(.*?)^```", text, re.MULTILINE | re.DOTALL)


def test_the_tour_runs_and_prints_what_the_page_says(tmp_path, monkeypatch):
    pytest.importorskip("scipy")
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {}
    printed = []
    for block in blocks("python.md", "python"):
        output = io.StringIO()
        with contextlib.redirect_stdout(output):
            exec(block, names)
        printed.append(output.getvalue())
    assert printed == blocks("python.md", "text")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["wrench.mp4"]


def test_the_tour_has_twenty_lines():
    lines = blocks("python.md", "python")[0].splitlines()
    assert len([line for line in lines if line]) == 20
    assert max(map(len, lines)) <= 100


def test_the_page_of_the_library_shows_the_example():
    (shown,) = blocks("library.md", "cpp")
    example = (PROJECT / "examples/cpp/flip_time.cpp").read_text()
    assert shown in example
