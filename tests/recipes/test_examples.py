"""The example of each recipe of CONTRIBUTING.md, in a scene file, a film, Python and a page.

scripts/maintain/recipes.sh runs this in a copy of the sources to which the patches beside this file have been
applied; TWRENCH is the program that was built there.
"""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

import twrench

SCENE = Path(__file__).with_name("examples.toml")


def run(*words: str | Path) -> str:
    return subprocess.run([os.environ["TWRENCH"], *words], check=True, capture_output=True, text=True).stdout


def scene(**values: object) -> twrench.Scene:
    return twrench.Scene.from_toml(SCENE.read_text(), **values)


@pytest.fixture(scope="module")
def film(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("film")
    run("render", SCENE, "--frames", "0-9", "--progress", "none", "-o", folder / "film.avi")
    return folder


def test_the_format_holds_the_film(film: Path) -> None:
    entries = "format=format_name:stream=width,height,nb_read_packets"
    said = subprocess.run(
        ["ffprobe", "-v", "error", "-count_packets", "-show_entries", entries, "-of", "json", film / "film.avi"],
        check=True, capture_output=True, text=True)  # fmt: skip
    properties = json.loads(said.stdout)
    assert properties["format"]["format_name"] == "avi"
    (stream,) = properties["streams"]
    assert (stream["width"], stream["height"], int(stream["nb_read_packets"])) == (320, 180, 10)


def test_the_film_is_of_the_scene(film: Path) -> None:
    manifest = json.loads((film / "film/manifest.json").read_text())
    said = manifest["scene"]
    assert said["part"][0]["shape"] == "hemisphere"
    assert said["motion"]["method"] == "ralston3"
    assert said["look"]["theme"] == "night"
    assert "spin" in said["overlay"]["show"]
    assert len({frame["sha256"] for frame in manifest["frames"]}) == 10, "the body turns"


@pytest.mark.parametrize(
    "values",
    [
        {"theme": "studio"},
        {"show": ["floor", "momentum"]},
        {"view": "rates"},
        {"show": ["floor", "momentum", "spin", "rates"]},
        {"body": twrench.Body([twrench.Sphere(radius=2, density=2)])},
    ],
    ids=["theme", "overlay", "view", "inset", "shape"],
)
def test_each_example_changes_the_picture(values: dict[str, object]) -> None:
    picture, other = scene().frame(5), scene(**values).frame(5)
    assert picture.std() > 5, "it is of one colour"
    assert np.abs(picture.astype(int) - other).max() > 30


def test_the_shape_has_its_integrals() -> None:
    body = twrench.Body([twrench.Hemisphere(radius=2, density=3)])
    mass = 3 * 2 / 3 * np.pi * 2**3
    assert body.mass == pytest.approx(mass)
    assert body.centre_of_mass == pytest.approx([0, 0, 3 / 8 * 2])
    moments = sorted(mass * 2**2 * share for share in (83 / 320, 83 / 320, 2 / 5))
    assert sorted(body.principal_moments) == pytest.approx(moments)


def test_the_method_has_its_order() -> None:
    (method,) = (each for each in twrench.methods() if each.name == "ralston3")
    assert method.order == 3
    omega = [0.1, 0.2, 1]
    body = scene().body
    end = twrench.exact(body, omega).at([10]).X[0]
    errors = [
        np.linalg.norm(twrench.simulate(body, omega, [10], "ralston3", step=step).X[0] - end)
        for step in (0.02, 0.01)
    ]
    assert np.log2(errors[0] / errors[1]) == pytest.approx(3, abs=0.2)


def test_the_scene_is_listed_after_its_neighbour_and_drawn(tmp_path: Path) -> None:
    names = [line.split()[0] for line in run("scenes").splitlines()]
    assert names[names.index("book") + 1] == "pencil"
    assert twrench.scenes() == names
    folder = tmp_path / "frames"
    run("render", "pencil", "--frames", "1", "--size", "64x36", "--no-video", "--frames-dir", folder)
    assert (folder / "frame_000001.png").exists()


def test_a_page_has_them_all(tmp_path: Path) -> None:
    run("page", SCENE, "-o", tmp_path / "page.html")
    subprocess.run(["node", SCENE.with_name("page.mjs"), tmp_path / "page.html"], check=True)


def test_a_convention_is_read_in_python_and_by_the_program(tmp_path: Path) -> None:
    angles = 0.5 * np.linspace(0, 3, 31)  # half of those of a turn about z with 1 rad/s
    zeros = np.zeros_like(angles)
    data = {"t": 2 * angles, "rvx": zeros, "rvy": zeros, "rvz": angles}
    body = twrench.Body(moments=[2, 3, 4])
    assert twrench.check(data, body, half_angles=True, omega=[0, 0, 1]).passes
    assert not twrench.check(data, body, omega=[0, 0, 1]).passes
    file = tmp_path / "run.csv"
    np.savetxt(file, np.stack(list(data.values()), axis=1), delimiter=",", header=",".join(data), comments="")
    assert "half of the angles" in run("check", file, "--inertia", "2,3,4", "--omega", "0,0,1", "--half-angles")
