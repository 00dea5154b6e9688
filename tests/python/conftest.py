"""Shared fixtures: scenes that are drawn quickly, and the program to compare with."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path
from typing import Any, Callable

import pytest

import twrench


@pytest.fixture
def small() -> twrench.Scene:
    """24 frames of 160x90."""
    return twrench.Scene(size=(160, 90), duration=24, fps=6, speed=6)


@pytest.fixture
def program() -> Callable[..., str]:
    """Runs the program ``twrench`` and returns its standard output."""

    def run(*arguments: Any) -> str:
        command = [os.environ["TWRENCH_PROGRAM"], *map(str, arguments)]
        return subprocess.run(command, check=True, capture_output=True, text=True).stdout

    return run


@pytest.fixture
def template(tmp_path) -> Path:
    """A page without a scene. scripts/maintain/page.sh builds the real one."""
    file = tmp_path / "template.html"
    file.write_text(
        '<!doctype html>\n<meta name="generator" content="twrench">\n'
        "<title>{{title}}</title><h1>{{title}}</h1>\n"
        "<!-- twrench:poster -->\n<!-- twrench:scene -->\n"
    )
    return file
