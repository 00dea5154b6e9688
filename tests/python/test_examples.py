"""Each example of examples/python runs in a separate folder and prints the right results."""

from __future__ import annotations

import json
import math
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import twrench

PROJECT = Path(__file__).parents[2]
EXAMPLES = PROJECT / "examples/python"
NOTEBOOKS = PROJECT / "examples/notebooks"


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


def test_toss(tmp_path):
    rows, ratios = run("toss.py", tmp_path, "toss.csv").splitlines()
    assert rows == "toss.csv: 520 rows; the phone flies from 0.8 to 2.0 s"
    found = twrench.check(tmp_path / "toss.csv", fit="inertia", from_time=0.8, to_time=2)
    assert found.finding == "noise"
    errors = np.abs(found.inertia.moments - numbers(ratios))
    assert np.all(errors <= 3 * found.inertia.deviations + 1e-4)
    assert np.all(found.inertia.deviations < 0.01)
    kept = PROJECT / "examples/toss/toss.csv"
    ours, theirs = (np.loadtxt(file, delimiter=",", skiprows=1) for file in (kept, tmp_path / "toss.csv"))
    np.testing.assert_allclose(ours, theirs, rtol=0, atol=2e-6)


def test_scene_of_a_toss():
    with pytest.warns(UserWarning, match="toss.csv has no attitude"):
        scene = twrench.Scene(PROJECT / "examples/toss/toss.toml")
    assert scene.title == "A phone, tossed" and scene.duration == pytest.approx(1.2)
    assert "momentum" in scene.show, "the recording follows a free motion"


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
    # The same starts, one at a time.
    across = (np.arange(40) + 0.5) / 20 - 1
    body = twrench.Body(moments=[1, 2, 3])
    waits = [
        twrench.exact(body, [x, math.sqrt(1 - x * x - z * z) / 2, z / 3]).first_flip
        for x in across
        for z in across
        if x * x + z * z < 1
    ]
    assert starts == len(waits) and earliest == pytest.approx(min(waits), abs=1e-4)


@pytest.fixture
def beside_robots(tmp_path: Path) -> Path:
    """A folder for notebooks beside that of the robots, as in the examples."""
    shutil.copytree(PROJECT / "examples/robot", tmp_path / "robot")
    folder = tmp_path / "notebooks"
    folder.mkdir()
    return folder


def names_after(notebook: str, folder: Path, monkeypatch: pytest.MonkeyPatch) -> dict[str, Any]:
    """The names that the cells of a notebook define. The cells are stored without outputs."""
    pytest.importorskip("matplotlib").use("agg")
    monkeypatch.chdir(folder)
    names: dict[str, Any] = {}
    for cell in json.loads((NOTEBOOKS / notebook).read_text())["cells"]:
        if cell["cell_type"] == "code":
            assert cell["outputs"] == [] and cell["execution_count"] is None
            exec("".join(cell["source"]), names)
    return names


def test_the_notebook_of_the_effect(tmp_path, monkeypatch):
    names = names_after("effect.ipynb", tmp_path, monkeypatch)
    assert names["flips"][0] == pytest.approx(11.81536262, abs=5e-9)
    assert names["exact"].flip_interval == pytest.approx(23.630725246, abs=5e-10)
    assert names["predicted"] == pytest.approx(np.diff(names["waits"])[-1], abs=1e-6)
    assert len(names["sphere"].lines) > 10
    assert names["scene"]._repr_png_() and names["film"]._repr_html_()
    assert files(tmp_path) == ["dzhanibekov.chapters.vtt", "dzhanibekov.mp4"]


def test_the_notebook_of_the_integrators(tmp_path, monkeypatch):
    names = names_after("integrators.ipynb", tmp_path, monkeypatch)
    orders = {name: of.order for name, of in names["study"].methods.items()}
    assert orders == pytest.approx({"lie-euler": 1, "rk4": 2, "rkmk4": 4, "cf4": 4}, abs=0.05)
    assert names["gain"] > 1e5 and names["longest"] == 0.02
    assert names["drift"]["implicit-trapezoid"] < 1e-12 < names["drift"]["rkmk4"]


def test_the_notebook_of_the_check(tmp_path, monkeypatch):
    names = names_after("check_your_simulator.ipynb", tmp_path, monkeypatch)
    assert names["found"].finding == "integration"
    assert names["checks"].order.rates == pytest.approx(4, abs=0.05)
    assert names["wrong"].finding == "convention" and not names["wrong"].passes
    assert names["right"].finding == "exact" and names["right"].passes


def test_the_notebook_of_a_toss(tmp_path, monkeypatch):
    names = names_after("toss.ipynb", tmp_path, monkeypatch)
    assert names["found"].finding == "noise"
    errors = np.abs(names["found"].inertia.moments - names["box"])
    assert np.all(errors <= 3 * names["found"].inertia.deviations) and errors.max() < 0.01
    theirs = np.loadtxt(PROJECT / "examples/toss/toss.csv", delimiter=",", skiprows=1)
    np.testing.assert_allclose(np.loadtxt("toss.csv", delimiter=",", skiprows=1), theirs, rtol=0, atol=2e-6)
    assert "momentum" in names["scene"].show, "the recording follows a free motion"
    assert names["scene"].picture(0.84).png.startswith(b"\x89PNG")


def test_the_notebook_of_the_robot(beside_robots, monkeypatch):
    names = names_after("robot.ipynb", beside_robots, monkeypatch)
    verdicts = {name: link.verdict for name, link in names["robot"].links.items()}
    assert list(verdicts.values()).count("good") == 1 and verdicts["finger"] == "impossible"
    assert all(link.verdict == "good" for link in names["after"].links.values())
    assert names["before"].png != names["after_repair"].png
    assert files(beside_robots) == ["repaired.urdf"]


@pytest.mark.parametrize("name", sorted(path.name for path in NOTEBOOKS.iterdir()))
def test_a_notebook_as_a_page(name, beside_robots, monkeypatch):
    """Runs a notebook in a kernel. Each scene, plot and film at the end of a cell is shown."""
    needed = "needs the packages jupyter-nbconvert and python3-ipykernel"
    nbconvert = pytest.importorskip("nbconvert", reason=needed)
    pytest.importorskip("ipykernel", reason=needed)
    nbformat = pytest.importorskip("nbformat", reason=needed)
    notebook = nbformat.read(NOTEBOOKS / name, as_version=4)
    # The kernel starts in another folder.
    monkeypatch.setenv("PYTHONPATH", str(Path(twrench.__file__).parents[1]))
    run = nbconvert.preprocessors.ExecutePreprocessor(kernel_name="python3")
    run.preprocess(notebook, {"metadata": {"path": str(beside_robots)}})
    shown = [output.data for cell in notebook.cells for output in cell.get("outputs", [])
             if output.output_type in ("execute_result", "display_data")]  # fmt: skip
    page, _ = nbconvert.HTMLExporter().from_notebook_node(notebook)
    pictures = {
        "effect.ipynb": 2,
        "integrators.ipynb": 1,
        "check_your_simulator.ipynb": 0,
        "toss.ipynb": 2,
        "robot.ipynb": 2,
    }[name]
    assert sum("image/png" in data for data in shown) == pictures
    assert page.count('src="data:image/png;base64,') >= pictures - ("<iframe" in page)
    if name == "effect.ipynb":
        assert shown[-1]["text/html"].startswith("<video") and "<video" in page
        # nbconvert sorts the attributes.
        is_embedded = re.search('<iframe( [a-z]+="[^"]*")* sandbox="allow-scripts"', page)
        assert ("text/html" in shown[0]) == (is_embedded is not None)


def test_each_example_is_tested():
    tests = Path(__file__).read_text()
    for example in filter(Path.is_file, [*EXAMPLES.iterdir(), *NOTEBOOKS.iterdir()]):
        assert f'"{example.name}"' in tests, f"no test runs {example.name}"
