from __future__ import annotations

import json
import math
import warnings

import numpy as np
import pytest

import twrench
from twrench import Body, Box, Cylinder, Ellipsoid, Sphere


def test_a_cylinder_has_the_moments_of_the_formula():
    body = Body([Cylinder(radius=2, length=6, density=3)])
    mass = 3 * math.pi * 2**2 * 6
    assert body.mass == pytest.approx(mass, rel=1e-15)
    across = mass * (3 * 2**2 + 6**2) / 12
    np.testing.assert_allclose(body.inertia, np.diag([across, across, mass * 2**2 / 2]), rtol=1e-14)


def test_parts_are_placed_and_turned():
    box = Box(size=[1, 2, 3], density=1, position=[10, 0, 0], rotation=[0, 0, math.pi / 2])
    body = Body([box])
    np.testing.assert_allclose(body.centre_of_mass, [10, 0, 0])
    # A quarter turn about z exchanges the moments about x and y: m/12 (a^2 + b^2), m = 6.
    np.testing.assert_allclose(np.diag(body.inertia), [5, 6.5, 2.5], atol=1e-12)


def test_the_built_in_body_is_that_of_its_parts():
    scene = twrench.Scene("dzhanibekov")
    parts = [
        Cylinder(
            radius=part["radius"],
            length=part["length"],
            density=part["density"],
            position=part["position"],
            rotation=part["rotation"],
        )
        for part in scene.to_dict()["part"]
    ]
    np.testing.assert_allclose(Body(parts).inertia, scene.body.inertia, atol=1e-12)


def test_a_sphere_is_an_ellipsoid_of_equal_axes():
    assert Body([Sphere(radius=2, density=1)]).principal_moments == pytest.approx(
        Body([Ellipsoid(radii=[2, 2, 2], density=1)]).principal_moments
    )


def test_moments_and_inertia():
    assert Body(moments=[3, 1, 2]).principal_moments.tolist() == [1, 2, 3]
    inertia = np.array([[4.0, 1, 0], [1, 5, 0.5], [0, 0.5, 6]])
    body = Body(inertia=inertia)
    np.testing.assert_array_equal(body.inertia, inertia)
    np.testing.assert_array_equal(Body(inertia=[4, 5, 6, 1, 0, 0.5]).inertia, inertia)
    np.testing.assert_array_equal(Body(inertia=np.array([4, 5, 6, 1, 0, 0.5])).inertia, inertia)
    np.testing.assert_allclose(body.principal_moments, np.linalg.eigvalsh(inertia))
    axes = body.principal_axes
    np.testing.assert_allclose(axes.T @ inertia @ axes, np.diag(body.principal_moments), atol=1e-12)


def test_the_body_of_a_scene_by_name_by_file_and_by_scene(tmp_path):
    file = tmp_path / "mine.toml"
    file.write_text("[body]\nmoments = [1, 2, 3]\n")
    assert Body.from_scene("sphere").principal_moments.std() < 1e-9
    assert Body.from_scene(file).principal_moments.tolist() == [1, 2, 3]
    assert Body.from_scene(twrench.Scene(file)).principal_moments.tolist() == [1, 2, 3]


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Body(), "exactly one"),
        (lambda: Body([], moments=[1, 2, 3]), "exactly one"),
        (lambda: Body([]), "parts"),
        (lambda: Body(3), "parts: must be a sequence"),
        (lambda: Body([3]), "parts: must be a sequence"),
        (lambda: Body([Sphere(radius=-1, density=1)]), "radi"),
        (lambda: Body([Sphere(radius=1, density=0)]), "density"),
        (lambda: Body([Sphere(radius=math.nan, density=1)]), "radius: must be finite"),
        (lambda: Body([Sphere(radius="1", density=1)]), "radius: must be a number"),
        (lambda: Body([Sphere(radius=None, density=1)]), "radius: must be a number"),
        (lambda: Body([Box(size=[1, 2], density=1)]), "size: must be three numbers"),
        (lambda: Body([Box(size=[1, 2, 3], density=1, axis=[0, 0, 0])]), "axis: must not be zero"),
        (
            lambda: Body([Box(size=[1, 2, 3], density=1, axis=[0, 0, 1], rotation=[0, 0, 1])]),
            "rotation: cannot be combined",
        ),
        (lambda: Body(moments=[1, 2, -3]), "moments"),
        (lambda: Body(moments=[1, 2]), "moments: must be three numbers"),
        (lambda: Body(moments=[1, 2, math.inf]), "moments: must be finite"),
        (lambda: Body(moments="abc"), "moments: must be three numbers, not 'abc'"),
        (lambda: Body(moments=[[1, 2], [3]]), "moments: must be three numbers"),
        (lambda: Body(moments=[True, True, True]), "moments: must be three numbers"),
        (lambda: Body(inertia=np.eye(2)), r"inertia: must be an array of shape \(3, 3\)"),
        (lambda: Body(inertia=[1, 2, 3]), "inertia: must be an array of shape .*, or Ixx, Iyy"),
        (lambda: Body(inertia=[1, 2, 3, 0, 0, "x"]), "inertia: must be an array of shape"),
        (lambda: Body(inertia=[1, 2, 3, 0, 0, math.nan]), "inertia: must be finite"),
        (lambda: Body(inertia=[2, 2, 4, 3, 0, 0]), "inertia: must be positive definite"),
        (lambda: Body(inertia=np.eye(3), shape="ball"), "shape: unknown name 'ball'"),
        (lambda: Body(inertia=np.diag([1, 2, -3])), "inertia"),
        (lambda: Body(inertia=[[1, 2, 3], [4, 5, 6], [7, 8, 9]]), "inertia"),
        (lambda: Body(inertia=np.eye(3) * 1j), "inertia: must be an array"),
    ],
)
def test_a_wrong_body_is_refused_by_the_name_of_the_argument(make, message):
    with pytest.raises(twrench.UsageError, match=message):
        make()


def test_it_shows_what_it_is():
    assert repr(Body(moments=[1, 2, 3])) == "<twrench.Body: principal moments 1, 2, 3 g cm^2>"
    assert "mass 252.584 g" in repr(twrench.Scene().body)


def test_stability_is_that_of_the_command(program):
    body = Body.from_scene("t-handle")
    expected = json.loads(program("inertia", "t-handle", "--format", "json"))["stability"]
    for found, known in zip(body.stability(), expected):
        assert (found.kind, found.rate) == (known["kind"], known["rate"])
        assert found.doubling_time == known.get("doubling_time", math.inf)
        assert found.period == known.get("period", math.inf)
    middle = body.stability(-3)[1]
    assert middle.rate == pytest.approx(3 * expected[1]["rate"], rel=1e-15)
    assert body.stabilizing_wheel() == expected[1]["stabilizing_wheel"]
    assert [axis.kind for axis in Body(moments=[2, 2, 2]).stability()] == ["neutral"] * 3
    with pytest.raises(twrench.UsageError, match="omega"):
        body.stability(math.nan)


def test_the_inertia_about_a_corner_is_that_of_the_formula():
    body = Body([Box(size=[1, 2, 3], density=2, position=[0.5, 1, 1.5])])
    # m (b^2 + c^2) / 3 and -m a b / 4, with m = 12 g.
    corner = [[52, -6, -9], [-6, 40, -18], [-9, -18, 20]]
    np.testing.assert_allclose(body.inertia_about([0, 0, 0]), corner, rtol=1e-14)
    np.testing.assert_array_equal(body.inertia_about(body.centre_of_mass), body.inertia)
    with pytest.raises(twrench.UsageError, match="needs the mass"):
        Body(moments=[2, 3, 4]).inertia_about([0, 0, 0])
    with pytest.raises(twrench.UsageError, match="point"):
        body.inertia_about([0, 0])


def test_the_properties_in_si_units():
    body = Body([Box(size=[1, 2, 3], density=2, position=[0.5, 1, 1.5])])
    assert body.si.mass == pytest.approx(0.012, rel=1e-15)
    np.testing.assert_allclose(body.si.centre_of_mass, [0.005, 0.01, 0.015], rtol=1e-15)
    np.testing.assert_allclose(body.si.inertia, body.inertia * 1e-7, rtol=1e-15)
    np.testing.assert_allclose(body.si.principal_moments, body.principal_moments * 1e-7, rtol=1e-15)
    assert math.isnan(Body(moments=[2, 3, 4]).si.mass)


def test_moments_that_no_real_body_has_are_warned_of():
    text = "moments 1, 2 and 5: no real body has them"
    with pytest.warns(UserWarning, match=f"^Body: {text}"):
        Body(moments=[1, 2, 5])
    with pytest.warns(UserWarning, match=f"^Body: {text}"):
        Body(inertia=np.diag([5.0, 1, 2]))
    with pytest.warns(UserWarning, match=f"^mine: {text}"):
        twrench.Scene.from_toml("[body]\nmoments = [1, 2, 5]\n", "mine.toml")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        Body(moments=[1, 2, 3])
