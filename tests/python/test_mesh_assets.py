"""The meshes of the built-in scenes equal the output of their script, and are closed and small."""

import pathlib
import shutil
import subprocess
import sys
from collections import Counter

import pytest

MESHES = pathlib.Path(__file__).resolve().parents[2] / "assets" / "meshes"
OPEN = {"book-print", "phone-print"}  # foil
MADE = sorted(path for path in MESHES.glob("*.obj") if path.name != "toutatis.obj")


def check(folder):
    script = folder / "make_meshes.py"
    return subprocess.run([sys.executable, script, "--check"], capture_output=True, text=True)


def test_meshes_are_what_the_script_makes():
    result = check(MESHES)
    assert result.returncode == 0, result.stderr


def test_a_mesh_that_was_changed_by_hand_is_named(tmp_path):
    folder = shutil.copytree(MESHES, tmp_path / "meshes", ignore=shutil.ignore_patterns("toutatis.obj"))
    with open(folder / "phone.obj", "a") as file:
        file.write("v 0 0 0\n")
    result = check(folder)
    assert result.returncode == 1
    assert "error: phone.obj: not what this script makes" in result.stderr


def test_the_script_refuses_a_solid_that_is_open(monkeypatch):
    monkeypatch.syspath_prepend(MESHES)
    import surfaces

    ring = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)]
    prism = surfaces.loft([ring, [(x, y, 1.0) for x, y, _ in ring]])
    vertices, faces = surfaces.indexed(prism)
    assert surfaces.volume(vertices, faces) == pytest.approx(0.5)
    with pytest.raises(ValueError, match="not closed"):
        surfaces.indexed(prism[1:])
    assert len(surfaces.indexed(prism[1:], is_open=True)[1]) == len(faces) - 1
    with pytest.raises(ValueError, match="not a manifold"):
        surfaces.indexed(prism + prism[:1], is_open=True)


@pytest.mark.parametrize("path", MADE, ids=lambda path: path.stem)
def test_each_edge_has_two_faces_which_agree(path):
    edges = Counter()
    for line in path.read_text().splitlines():
        if line.startswith("f "):
            face = line.split()[1:]
            edges.update(zip(face, face[1:] + face[:1]))
    assert edges
    least = 0 if path.stem in OPEN else 1
    assert all(count == 1 and least <= edges[b, a] <= 1 for (a, b), count in edges.items())


def test_meshes_are_small():
    assert sum(path.stat().st_size for path in MESHES.glob("*.obj")) < 3_000_000


@pytest.mark.parametrize("name, start, end, pitch", [("t-handle-shaft", 39.5, 69.0, 1.5),
                                                     ("wing-nut-hub", 0.6, 9.4, 1.25)])
def test_a_thread_has_no_step(name, start, end, pitch):
    """Each turn of the thread begins where the one before it ends: no face extends over half a pitch."""
    lines = (MESHES / f"{name}.obj").read_text().splitlines()
    along = [float(line.split()[1]) for line in lines if line.startswith("v ")]
    faces = [[along[int(i) - 1] for i in line.split()[1:]] for line in lines if line.startswith("f ")]
    thread = [face for face in faces if start + pitch < min(face) and max(face) < end - pitch]
    assert len(thread) > 500
    assert max(max(face) - min(face) for face in thread) < 0.5 * pitch
