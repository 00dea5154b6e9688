"""The Python code of docs/python.md runs completely and prints the output shown there, and the
reference pages document all public names."""

from __future__ import annotations

import contextlib
import doctest
import inspect
import io
import re
import sys
import types
import typing
from pathlib import Path
from typing import Any, Callable, Iterator

import pytest

import twrench

PROJECT = Path(__file__).parents[2]


def blocks(page: str, language: str) -> list[str]:
    """The fenced blocks of a page in a language."""
    text = (PROJECT / "docs" / page).read_text()
    return re.findall(rf"^```{language}\n(.*?)^```", text, re.MULTILINE | re.DOTALL)


def test_the_tour_runs_and_prints_what_the_page_says(tmp_path, monkeypatch):
    pytest.importorskip("scipy")
    pytest.importorskip("matplotlib")
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {}
    printed = []
    for block in blocks("python.md", "python"):
        output = io.StringIO()
        with contextlib.redirect_stdout(output):
            exec(block, names)
        printed.append(output.getvalue())
    assert printed == blocks("python.md", "text")
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        "sphere.png",
        "wrench.chapters.vtt",
        "wrench.mp4",
    ]


def test_the_session_of_the_readme(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (session,) = blocks("../README.md", "pycon")
    (tmp_path / "session").write_text(session)
    failed, tried = doctest.testfile(str(tmp_path / "session"), module_relative=False)
    assert (failed, tried) == (0, 9)


def test_the_tour_has_twenty_lines():
    lines = blocks("python.md", "python")[0].splitlines()
    assert len([line for line in lines if line]) == 20
    assert max(map(len, lines)) <= 100


def test_the_page_of_the_library_shows_the_example():
    (shown,) = blocks("library.md", "cpp")
    example = (PROJECT / "examples/cpp/flip_time.cpp").read_text()
    assert shown in example


def test_the_reference_has_every_public_name():
    page = (PROJECT / "docs/reference/python-reference.rst").read_text()
    listed = re.findall(r"^\.\. (?:auto\w+|data):: twrench\.(\w+)", page, re.MULTILINE)
    assert sorted(listed) == sorted(set(twrench.__all__) - {"__version__"})


def test_the_page_and_the_reference_name_each_solid():
    solids = [each.__name__ for each in typing.get_args(twrench.Part)]
    assert "Mesh" in solids
    page = (PROJECT / "docs/python.md").read_text()
    reference = (PROJECT / "docs/reference/python-reference.rst").read_text()
    for name in solids:
        assert f"`{name}`" in page
        assert f":class:`{name}`" in reference


def public_functions() -> Iterator[tuple[str, Callable[..., Any], str]]:
    """Name, function and docstring of each function and method."""
    for name in twrench.__all__:
        value = getattr(twrench, name)
        if inspect.isfunction(value):
            yield name, value, value.__doc__ or ""
        elif inspect.isclass(value):
            for key, method in vars(value).items():
                function = method.__func__ if isinstance(method, classmethod) else method
                if inspect.isfunction(function) and not key.startswith("_"):
                    yield f"{name}.{key}", function, function.__doc__ or ""


def test_every_docstring_tells_of_every_parameter():
    functions = list(public_functions())
    assert len(functions) > 15
    for name, function, doc in functions:
        for parameter in inspect.signature(function).parameters.values():
            if parameter.name not in ("self", "cls"):
                assert re.search(rf"\b{parameter.name}\b", doc), f"{name}: {parameter.name}"


def test_the_test_of_the_check_runs(monkeypatch):
    def simulate(moments, omega, duration):
        body = twrench.Body(moments=moments)
        motion = twrench.exact(body, omega).at(span=(0, duration), fps=10)
        return motion.t, motion.omega * (1 + error)

    module = types.ModuleType("my_simulator")
    module.simulate = simulate
    monkeypatch.setitem(sys.modules, "my_simulator", module)
    (block,) = blocks("check.md", "python")
    names: dict[str, Any] = {}
    exec(block, names)
    error = 0.0
    names["test_a_free_body_follows_the_exact_motion"]()
    error = 1e-3
    with pytest.raises(AssertionError):
        names["test_a_free_body_follows_the_exact_motion"]()
