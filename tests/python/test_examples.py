"""Each example of examples/python runs in a folder of its own, and prints what is right."""

from __future__ import annotations

import json
import math
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import twrench

PROJECT = Path(__file__).parents[2]
EXAMPLES = PROJECT / "examples/python"


def run(name: str, folder: Path, *arguments: str) -> str:
    """The output of an example."""
    command = [sys.executable, str(EXAMPLES / name), *arguments]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def numbers(line: str) -> list[float]:
    return [float(number) for number in re.findall(r"-?\d+(?:\.\d+)?(?:e[-+]\d+)?", line)]


def files(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


def test_from_a_body_to_a_film(tmp_path):
    mass, flips, film = run("body_to_film.py", tmp_path).splitlines()
    grams = 0.5 * math.pi * 7.5**2 * 0.8 + 0.6 * 10 * 2.8 * 2.2
    assert numbers(mass)[0] == pytest.approx(grams, abs=0.05)
    first, interval = numbers(flips)
    assert interval == pytest.approx(2 * first, abs=2e-3)  # it starts midway between two flips
    assert film == "bat.mp4: 48 frames"
    assert files(tmp_path) == ["bat.chapters.vtt", "bat.mp4"]


def test_comparison_with_scipy(tmp_path):
    pytest.importorskip("scipy")
    _, difference, quaternions = run("compare_with_scipy.py", tmp_path).splitlines()
    assert 0 < numbers(difference)[0] < 1e-9
    xyzw, wxyz = numbers(quaternions)
    assert xyzw < 1e-14 and wxyz > 1
    assert files(tmp_path) == []


def test_energy_drift(tmp_path):
    rows = run("energy_drift.py", tmp_path).splitlines()[1:]
    table = {row.split()[0]: [float(value) for value in row.split()[1:]] for row in rows}
    assert len(table) == 7
    drift = {name: abs(values[-2]) for name, values in table.items()}
    assert drift["lie-euler"] > 1e-2 > drift["rk4"] > drift["strang"] > drift["rkmk4"] > 1e-12
    assert max(drift["suzuki4"], drift["exact"]) < 1e-13
    off_the_group = {name for name, values in table.items() if values[-1] > 1e-12}
    assert off_the_group == {"euler"}


def test_parameter_sweep(tmp_path):
    *waits, slope = run("parameter_sweep.py", tmp_path).splitlines()
    # From 1e-12 to 1e-6 rad there are six factors of ten.
    (_, longest), (_, middle), _ = map(numbers, waits)
    measured, theory = numbers(slope)
    assert measured == pytest.approx(theory, abs=2e-6)
    assert longest - middle == pytest.approx(6 * theory, abs=2e-3)
    assert len((tmp_path / "sweep.csv").read_text().splitlines()) == 1 + 101


def test_map_of_flips(tmp_path):
    image = pytest.importorskip("PIL.Image")
    starts, _, earliest = numbers(run("flip_map.py", tmp_path, "40"))
    assert starts == pytest.approx(math.pi * 20**2, rel=0.02)
    assert image.open(tmp_path / "flip_map.png").size == (40, 40)
    # The same starts one at a time.
    across = (np.arange(40) + 0.5) / 20 - 1
    body = twrench.Body(moments=[1, 2, 3])
    waits = [
        twrench.exact(body, [x, math.sqrt(1 - x * x - z * z) / 2, z / 3]).first_flip
        for x in across
        for z in across
        if x * x + z * z < 1
    ]
    assert starts == len(waits) and earliest == pytest.approx(min(waits), abs=1e-4)


def cells() -> list[dict[str, Any]]:
    return json.loads((EXAMPLES / "dzhanibekov.ipynb").read_text())["cells"]


def test_the_cells_of_the_notebook(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {}
    for cell in cells():
        if cell["cell_type"] == "code":
            assert cell["outputs"] == [] and cell["execution_count"] is None
            exec("".join(cell["source"]), names)
    assert names["flips"][0] == pytest.approx(11.81536262, abs=5e-9)
    assert names["exact"].flip_interval == pytest.approx(23.630725246, abs=5e-10)
    orders = {name: of.order for name, of in names["study"].methods.items()}
    assert orders == pytest.approx({"lie-euler": 1, "rk4": 2, "rkmk4": 4}, abs=0.05)
    assert names["scene"]._repr_png_() and names["film"]._repr_html_()
    assert files(tmp_path) == ["dzhanibekov.chapters.vtt", "dzhanibekov.mp4"]


def test_the_notebook_in_a_kernel(tmp_path):
    nbclient = pytest.importorskip("nbclient")
    pytest.importorskip("ipykernel")
    nbformat = pytest.importorskip("nbformat")
    notebook = nbformat.read(EXAMPLES / "dzhanibekov.ipynb", as_version=4)
    resources = {"metadata": {"path": str(tmp_path)}}
    nbclient.NotebookClient(notebook, kernel_name="python3", resources=resources).execute()
    shown = [output.data for cell in notebook.cells for output in cell.get("outputs", [])
             if output.output_type == "execute_result"]  # fmt: skip
    assert ["image/png" in data for data in shown] == [True, False]
    assert shown[1]["text/html"].startswith("<video")


def test_each_example_is_tested():
    tests = Path(__file__).read_text()
    for example in filter(Path.is_file, EXAMPLES.iterdir()):
        assert f'"{example.name}"' in tests, f"no test runs {example.name}"
