"""Solids other than cylinders, boxes and ellipsoids, especially meshes, and the look of parts."""

from __future__ import annotations

import copy
import dataclasses
import math
import pickle
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import twrench
from twrench import Body, Box, Capsule, Cone, Cylinder, Mesh, Sphere, Torus, Tube, _native
from twrench.solids import Solid

CORNERS = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], dtype=float)
QUADS = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
TRIANGLES = np.array([[a, b, c] for a, b, c, _ in QUADS] + [[a, c, d] for a, _, c, d in QUADS])


def write_obj(path: Path, vertices: np.ndarray, triangles: np.ndarray) -> Path:
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in vertices.tolist()]
    lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in triangles.tolist()]
    path.write_text("\n".join(lines) + "\n")
    return path


def by_quadrature(inside, half):
    """Volume and mean squares of the coordinates, by a grid of cells."""
    n = 160
    axes = [(np.arange(n) + 0.5) / n * 2 * h - h for h in half]
    x, y, z = np.meshgrid(*axes, indexing="ij")
    mask = inside(x, y, z)
    return mask.mean() * 8 * np.prod(half), [float((q**2)[mask].mean()) for q in (x, y, z)]


def test_every_shape_is_a_class_with_its_dimensions():
    classes = {kind._name: kind for kind in Solid.__subclasses__() if kind is not Sphere}
    for name, dimensions in _native.shapes.items():
        assert classes[name].__name__ in twrench.__all__
        attributes = {attribute.name for attribute in dataclasses.fields(classes[name])}
        assert attributes >= {key for key, _ in dimensions}


@pytest.mark.parametrize(
    ("solid", "inside", "half"),
    [
        (Torus(radius=2, tube_radius=0.5, density=1),
         lambda x, y, z: (np.hypot(x, y) - 2) ** 2 + z**2 < 0.25, (2.5, 2.5, 0.5)),
        (Capsule(radius=1, length=2, density=1),
         lambda x, y, z: x**2 + y**2 + np.maximum(np.abs(z) - 1, 0) ** 2 < 1, (1, 1, 2)),
        (Tube(radius=2, inner_radius=1, length=3, density=1),
         lambda x, y, z: (np.hypot(x, y) < 2) & (np.hypot(x, y) > 1), (2, 2, 1.5)),
    ],
)  # fmt: skip
def test_solids_have_the_integrals_over_what_is_inside(solid, inside, half):
    body = Body([solid])
    volume, (xx, yy, zz) = by_quadrature(inside, half)
    assert body.mass == pytest.approx(volume, rel=0.01)
    expected = body.mass * np.array([yy + zz, xx + zz, xx + yy])
    np.testing.assert_allclose(np.diag(body.inertia), expected, rtol=0.01)


def test_a_cone_has_the_moments_of_the_formula():
    body = Body([Cone(radius=2, length=4, density=3)])
    mass = 3 * math.pi / 3 * 2**2 * 4
    assert body.mass == pytest.approx(mass, rel=1e-14)
    np.testing.assert_allclose(body.centre_of_mass, [0, 0, -2 + 4 / 4], atol=1e-14)
    across = 3 / 80 * mass * (4 * 2**2 + 4**2)
    np.testing.assert_allclose(
        body.inertia, np.diag([across, across, 0.3 * mass * 2**2]), rtol=1e-13, atol=1e-12
    )
    frustum = Body([Cone(radius=2, length=4, top_radius=2, mass=5)])
    np.testing.assert_allclose(
        frustum.inertia, Body([Cylinder(radius=2, length=4, mass=5)]).inertia, rtol=1e-13, atol=1e-12
    )


def test_mass_stands_for_density():
    assert Body([Sphere(radius=3, mass=7)]).mass == pytest.approx(7, rel=1e-15)
    assert Body([Sphere(density=2.0, radius=3)]).mass == pytest.approx(2 * 4 / 3 * math.pi * 27)


def test_a_mesh_of_arrays_is_the_solid_inside(tmp_path):
    size = np.array([1.0, 2, 4])
    box = Body([Box(size=size, density=3, position=size / 2)])
    for mesh in (
        Mesh(vertices=CORNERS * size, triangles=TRIANGLES, density=3),
        Mesh(vertices=CORNERS * size * 10, triangles=TRIANGLES, unit="mm", density=3),
        Mesh(vertices=(CORNERS * size / 2.54).tolist(), triangles=TRIANGLES.tolist(), scale=2.54,
             mass=24),
        Mesh(file=write_obj(tmp_path / "box.obj", CORNERS * size, TRIANGLES), unit="cm", density=3),
    ):  # fmt: skip
        body = Body([mesh])
        assert body.mass == pytest.approx(24, rel=1e-14)
        np.testing.assert_allclose(body.centre_of_mass, size / 2, rtol=1e-14)
        np.testing.assert_allclose(body.inertia, box.inertia, rtol=1e-13, atol=1e-12)


def test_the_asteroid_has_the_moments_of_exact_arithmetic():
    # From rational arithmetic over the same file, in km^5 at density 1.
    exact = np.array([2.861959401240807, 8.623292414962608, 9.129415281983114])
    body = Body([Mesh(file="toutatis.obj", unit="km", density=1)])
    assert body.mass == pytest.approx(7.6988168847477665e15, rel=1e-14)
    np.testing.assert_allclose(body.principal_moments, exact * 1e25, rtol=1e-14)
    np.testing.assert_allclose(
        body.centre_of_mass,
        np.array([0.0005132273515136949, -0.0026715321288648727, -0.002815705464920223]) * 1e5,
        rtol=1e-12,
    )


def test_an_open_surface_is_a_wall():
    lid = [4, 5, 7, 6]
    kept = [i for i, t in enumerate(TRIANGLES) if not set(t) <= set(lid)]
    bowl = {"vertices": CORNERS, "triangles": TRIANGLES[kept]}
    body = Body([Mesh(**bowl, shell=0.01, density=2)])
    assert body.mass == pytest.approx(2 * 0.01 * 5)
    with pytest.raises(twrench.UsageError, match="mesh: .*; .*shell"):
        Body([Mesh(**bowl, density=2)])
    # Vertices almost in one place are joined on request.
    apart = np.concatenate([CORNERS, CORNERS[:1] + 1e-7])
    triangles = TRIANGLES.copy()
    triangles[0, 0] = 8
    with pytest.raises(twrench.UsageError, match="mesh: the surface is open at 4 edges"):
        Body([Mesh(vertices=apart, triangles=triangles, density=1)])
    with pytest.warns(UserWarning, match="mesh: 1 vertices were joined"):
        welded = Body([Mesh(vertices=apart, triangles=triangles, density=1, weld=1e-6)])
    assert welded.mass == pytest.approx(1, rel=1e-6)


def test_a_mesh_is_shown_and_told_of(tmp_path, small):
    path = write_obj(tmp_path / "box.obj", CORNERS * [4, 2, 1], TRIANGLES)
    small.body = Body([Mesh(file=path, unit="cm", density=2, material="brass", name="it")])
    [part] = small.to_dict()["part"]
    assert part["shape"] == "mesh" and part["file"] == str(path) and len(part["sha256"]) == 64
    assert part["name"] == "it" and part["color"] == "#f4e4ad" and part["metallic"] == 1
    assert small.frame(3).shape == (90, 160, 3)
    small.body = Body([Mesh(vertices=CORNERS * [4, 2, 1], triangles=TRIANGLES, density=2)])
    assert "file" not in small.to_dict()["part"][0]
    assert small.frame(3).shape == (90, 160, 3)
    with pytest.raises(twrench.OverwriteError, match="input"):
        twrench.Scene(body=Body([Mesh(file=path, unit="cm", density=1)])).render(
            path, container="mp4", overwrite=True
        )


def test_what_was_put_right_in_the_mesh_of_a_scene_is_a_warning(tmp_path):
    apart = np.concatenate([CORNERS, CORNERS[:1] + 1e-7])
    triangles = TRIANGLES.copy()
    triangles[0, 0] = 8
    write_obj(tmp_path / "box.obj", apart, triangles)
    toml = '[[part]]\nshape="mesh"\nfile="box.obj"\nunit="cm"\nweld=1e-6\ndensity=1\n'
    (tmp_path / "some.toml").write_text(toml)
    with pytest.warns(UserWarning, match="box.obj: 1 vertices were joined"):
        twrench.Scene(tmp_path / "some.toml")
    with pytest.warns(UserWarning, match="box.obj: 1 vertices were joined"):
        scene = twrench.Scene.from_toml(toml, str(tmp_path / "any"))
    assert pickle.loads(pickle.dumps(scene)).to_dict() == scene.to_dict()


def test_moments_have_a_shape(small):
    frames = []
    for shape in ("box", "ellipsoid", "cross"):
        small.body = Body(moments=[3, 4, 5], shape=shape)
        assert small.to_dict()["body"]["shape"] == shape
        frames.append(small.frame(3))
    assert (frames[0] != frames[1]).any() and (frames[1] != frames[2]).any()


def bodies():
    return [
        Body(moments=[3, 4, 5], shape="cross"),
        Body(inertia=[[4, 0.5, 0], [0.5, 5, 0], [0, 0, 6]]),
        Body(inertia=[4, 5, 6, 0.5, 0, 0], shape="cross"),
        Body([Cone(radius=1, length=2, mass=3, axis=[1, 2, 3], position=[1, 2, 3])]),
        Body([Torus(radius=2, tube_radius=1, density=1, material="rock", name="ring")]),
        Body([Tube(radius=2, inner_radius=1, length=1, density=1, rotation=[0.1, 0.2, 0.3])]),
        Body([Mesh(vertices=CORNERS, triangles=TRIANGLES, colors=CORNERS, density=1, crease=0)]),
        Body([Mesh(file="toutatis.obj", unit="km", density=2, shell=10)]),
    ]


@pytest.mark.parametrize("index", range(len(bodies())))
def test_a_body_survives_pickling(index, small):
    body = bodies()[index]
    twin = pickle.loads(pickle.dumps(body))
    np.testing.assert_array_equal(twin.inertia, body.inertia)
    np.testing.assert_array_equal(twin.centre_of_mass, body.centre_of_mass)
    assert twin.mass == body.mass or math.isnan(body.mass)
    small.body = body
    before = small.to_dict()
    small.body = twin
    assert small.to_dict() == before


STORY = """
title = "Two"
[body]
moments = [3, 4, 5]
[film]
size = [96, 64]
fps = 4
[[shot]]
length = 1
caption = "One body"
[[shot]]
length = 2.5
fade = 0.5
speed = [[0, 1], [2, 3]]
[shot.look]
background = "#102030"
[[shot.part]]
shape = "mesh"
file = "toutatis.obj"
unit = "km"
density = 2
"""


def test_a_scene_survives_pickling(small):
    small.theme = "paper"
    small.background = "transparent"
    small.compare = ("rk4", "exact")
    for scene in (small, twrench.Scene.from_toml(STORY), twrench.Scene("tao-disk", size=(96, 64))):
        twin = pickle.loads(pickle.dumps(scene))
        assert twin.name == scene.name and twin.to_dict() == scene.to_dict()
        np.testing.assert_array_equal(twin.times, scene.times)
        np.testing.assert_array_equal(twin.frame(5), scene.frame(5))
        assert pickle.dumps(copy.copy(twin)) == pickle.dumps(twin)


def test_a_damaged_pickle_is_told_without_internals():
    whole = pickle.dumps(twrench.Scene(title="a wing nut"))
    for damaged in (whole.replace(b'"a wing nut"', b'"a wing nut '), whole.replace(b"mm", b"xx", 1)):
        try:
            pickle.loads(damaged)
        except twrench.UsageError as error:
            assert str(error).startswith("the pickled scene: is damaged")
    with pytest.raises(twrench.UsageError, match="the pickled scene: is damaged"):
        pickle.loads(whole.replace(b'"a wing nut"', b'"a wing nut '))


def test_other_threads_run_while_a_mesh_is_read(tmp_path):
    n = 200
    u, v = np.meshgrid(*2 * [2 * np.pi * np.arange(n) / n], indexing="ij")
    ring = 3 + np.cos(v)
    vertices = np.stack([ring * np.cos(u), ring * np.sin(u), np.sin(v)], axis=-1).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(n), np.arange(n), indexing="ij")
    a, b, c, d = (x % n * n + y % n for x, y in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)))
    triangles = np.concatenate([np.stack(t, axis=-1).reshape(-1, 3) for t in ((a, b, c), (a, c, d))])
    file = write_obj(tmp_path / "torus.obj", vertices, triangles)
    turns = 0
    with ThreadPoolExecutor(1) as pool:
        made = pool.submit(twrench.Scene, file, unit="cm")
        while not made.done():
            time.sleep(0.001)
            turns += 1
    assert made.result().body.mass > 0 and turns > 10


def with_value(state: Any, path: tuple[Any, ...], value: Any) -> Any:
    """The state with another value at the path."""
    if not path:
        return value
    if isinstance(state, dict):
        return {**state, path[0]: with_value(state[path[0]], path[1:], value)}
    items = list(state)
    items[path[0]] = with_value(items[path[0]], path[1:], value)
    return type(state)(items)


#: The rest of the state of a part, after its shape.
WHOLE = (1.0, np.zeros(3), np.eye(3), "", (None, None, None, 0.5), None)
#: Paths in the state of a scene whose body is a mesh, and values that Writer never writes.
HOSTILE = [
    ((), None),
    ((), 3),
    ((0,), ()),
    ((0, 1, "fps"), b"-1"),
    ((0, 1, "fps"), b"[["),
    ((0, 1, "size"), b"[1e9,1e9]"),
    ((0, 2, 0), []),
    ((0, 2, 0, 0, 1), [math.nan]),
    ((0, 2, 0, 0, 2, 0, 0), np.full((8, 3), 2.0)),
    ((0, 2, 0, 0, 2, 0, 0), np.full((8, 3), math.nan)),
    ((0, 2, 0, 0, 2, 0, 0), np.zeros((8, 2))),
    ((0, 2, 0, 0, 2, 0, 1), np.full((4, 3), 8, np.uint32)),
    ((0, 2, 0, 0, 2, 0, 1), np.zeros((0, 3), np.uint32)),
    ((0, 2, 0, 0, 2, 0, 2), np.zeros((3, 3), np.float32)),
    ((0, 2, 0, 0, 2, 1), math.inf),
    ((0, 2, 0, 0, 3), -1.0),
    ((0, 2, 0, 0, 4), np.full(3, 1e300)),
    ((0, 2, 0, 0, 5), np.zeros((3, 3))),
    ((0, 2, 0, 0, 7, 0), (0, 0, 256)),
    ((0, 2, 1), -np.eye(3)),
    ((0, 2, 2), 3),
    ((0, 2, 2), -1),
    ((0, 2), ([("box", [1e21, 1.0, 1.0], None, *WHOLE)], None, 0)),
    ((0, 2), ([("box", [1.0, 1.0], None, *WHOLE)], None, 0)),
    ((0, 4), -1.0),
    ((0, 6), (0, 0, 0, 0, 3)),
]


@pytest.mark.parametrize(("path", "value"), HOSTILE)
def test_a_hostile_pickle_is_refused(path, value):
    scene = twrench.Scene(body=Body([Mesh(vertices=CORNERS, triangles=TRIANGLES, density=1)]))
    state = scene.__getstate__()["_native"]
    assert len(_native.scenes_with(state)) == 2
    with pytest.raises(twrench.UsageError, match="the pickled scene: is damaged"):
        scene.__setstate__({"_native": with_value(state, path, value)})


def test_a_pickle_that_contains_itself_is_refused():
    state = list(twrench.Scene().__getstate__()["_native"][0])
    state[5] = shots = []
    shots.append((tuple(state), 0.0, 0.0, 0.0, [(0.0, 1.0)], "x"))
    for hostile in ({"_native": 2 * (tuple(state),)}, {"_native": ()}, {}, None):
        with pytest.raises(twrench.UsageError, match="the pickled scene: is damaged"):
            twrench.Scene().__setstate__(hostile)
    with pytest.raises(twrench.UsageError, match="the pickled body: is damaged"):
        _native.Body.__new__(_native.Body).__setstate__(None)


def test_parts_that_share_a_mesh_are_pickled_with_one():
    rock = {"file": "toutatis.obj", "unit": "km", "density": 2}
    one = len(pickle.dumps(Body([Mesh(**rock)])))
    scene = twrench.Scene.from_toml(STORY)
    assert len(pickle.dumps(scene)) < 1.1 * one


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Sphere(radius=1), "density: give exactly one of density and mass"),
        (lambda: Sphere(radius=1, density=1, mass=1), "density: give exactly one"),
        (lambda: Sphere(radius=1, mass=0), "mass: must be greater than 0"),
        (lambda: Sphere(radius=1, mass=1, material="stel"), "material: .*did you mean 'steel'"),
        (lambda: Sphere(radius=1, mass=1, color="pink"), "color: 'pink'"),
        (lambda: Sphere(radius=1, mass=1, metallic=2), "metallic: is 2"),
        (lambda: Sphere(radius=1, mass=1, roughness=0), "roughness: is 0"),
        (lambda: Torus(radius=1, tube_radius=1, mass=1), "tube_radius: is 1"),
        (lambda: Tube(radius=1, inner_radius=2, length=1, mass=1), "inner_radius: is 2"),
        (lambda: Cone(radius=1, length=1, top_radius=-1, mass=1), "top_radius"),
        (lambda: Capsule(radius=1, length=math.nan, mass=1), "length: must be finite"),
        (lambda: Mesh(mass=1), "Mesh: vertices: give either file, or vertices and triangles"),
        (lambda: Mesh(vertices=CORNERS, mass=1), "Mesh: vertices: give either file"),
        (lambda: Mesh(file="a.obj", vertices=CORNERS, mass=1), "file: cannot be combined"),
        (lambda: Mesh(file="a\0.obj", unit="cm", mass=1), "file: must be a path"),
        (lambda: Mesh(file=3, unit="cm", mass=1), "file: must be a path"),
        (lambda: Mesh(vertices=CORNERS, triangles=TRIANGLES, unit="cm", scale=1, mass=1),
         "scale: cannot be combined with unit"),
        (lambda: Mesh(vertices=CORNERS, triangles=TRIANGLES, unit="ft", mass=1), "unit: .*'ft'"),
        (lambda: Mesh(vertices=CORNERS, triangles=TRIANGLES, shell=-1, mass=1), "shell"),
        (lambda: Mesh(vertices=CORNERS, triangles=TRIANGLES, weld=-1, mass=1), "weld"),
        (lambda: Mesh(vertices=CORNERS, triangles=TRIANGLES, crease=4, mass=1), "crease: is 4"),
        (lambda: Mesh(vertices=CORNERS[:, :2], triangles=TRIANGLES, mass=1), "vertices: must be an"),
        (lambda: Mesh(vertices=CORNERS * math.nan, triangles=TRIANGLES, mass=1), "vertices: .*NaN"),
        (lambda: Mesh(vertices=CORNERS, triangles=TRIANGLES + 0.5, mass=1), "triangles: .*integers"),
        (lambda: Mesh(vertices=CORNERS, triangles=TRIANGLES[:, :2], mass=1), "triangles: .*shape"),
        (lambda: Mesh(vertices=CORNERS, triangles=[[0, 1], [2]], mass=1), "triangles: must be"),
        (lambda: Mesh(vertices=CORNERS, triangles=TRIANGLES + 1, mass=1), "triangles: .*0 to 7"),
        (lambda: Mesh(vertices=CORNERS, triangles=TRIANGLES - 1, mass=1), "triangles: .*0 to 7"),
        (lambda: Mesh(vertices=CORNERS, triangles=TRIANGLES[:0], mass=1), "no triangles"),
        (lambda: Mesh(vertices=CORNERS, triangles=TRIANGLES, colors=CORNERS * 2, mass=1),
         "colors: must be from 0 to 1"),
        (lambda: Mesh(vertices=CORNERS, triangles=TRIANGLES, colors=CORNERS[1:], mass=1),
         r"colors: must be an array of shape \(8, 3\)"),
        (lambda: Mesh(vertices=CORNERS * [1, 1, 0], triangles=TRIANGLES, mass=1), "mesh"),
    ],
)  # fmt: skip
def test_a_wrong_solid_is_refused_by_the_name_of_the_argument(make, message):
    with pytest.raises(twrench.UsageError, match=message):
        Body([make()])


def test_files_that_are_no_mesh(tmp_path):
    with pytest.raises(twrench.FileError, match="none.obj"):
        Body([Mesh(file=tmp_path / "none.obj", unit="cm", mass=1)])
    with pytest.raises(twrench.FileError, match="regular"):
        Body([Mesh(file=tmp_path, unit="cm", mass=1)])
    path = write_obj(tmp_path / "box.obj", CORNERS, TRIANGLES)
    with pytest.raises(twrench.UsageError, match="unit is not known"):
        Body([Mesh(file=path, mass=1)])
    with pytest.raises(twrench.UsageError, match="shape: is for a body given by moments"):
        Body([Sphere(radius=1, mass=1)], shape="cross")
    with pytest.raises(twrench.UsageError, match="shape: .*'ball'"):
        Body(moments=[1, 2, 3], shape="ball")
    large = Body([Mesh(vertices=CORNERS * 1e10, triangles=TRIANGLES, density=1)])
    with pytest.raises(twrench.SceneError, match="1.73205e.10 cm across"):
        twrench.Scene(body=large)
