"""Accepted arguments, and the errors for others."""

from __future__ import annotations

import shutil
import signal
import subprocess
import sys
import time
import typing
import warnings
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

import twrench
from twrench import Box, Scene, _native, names

BODY = twrench.Body(moments=[1, 2, 3])


def test_the_names_are_those_of_the_program():
    for name, values in _native.names().items():
        assert list(typing.get_args(getattr(names, name))) == values, name
    assert list(typing.get_args(names.ContainerName)) == _native.container_names()
    assert list(typing.get_args(names.EffortName)) == _native.effort_names()


@pytest.mark.parametrize("call", [twrench.exact(BODY, [1, 0, 0]).at,
                                  lambda times: twrench.simulate(BODY, [1, 0, 0], times)])  # fmt: skip
def test_a_tuple_of_two_times_is_refused_with_both_spellings(call):
    with pytest.raises(twrench.UsageError) as raised:
        call((0, 10))
    assert "np.linspace(0, 10, n)" in str(raised.value)
    assert "span=(0, 10), fps=60" in str(raised.value)
    assert len(call([0, 10])) == 2 and len(call((0, 5, 10))) == 3


def test_a_span():
    exact = twrench.exact(BODY, [0.1, 1, 0.2])
    np.testing.assert_array_equal(exact.at(span=(1, 3), fps=4).t, np.arange(1, 3.25, 0.25))
    assert twrench.simulate(BODY, [1, 0, 0], span=(0, 10)).t.size == 601
    assert exact.at(span=[0, 0.35], fps=10).t.tolist() == [0, 0.1, 0.2, 3 / 10, 0.35]
    assert exact.at(span=(0, 0.7), fps=10).t.size == 8  # 0.7 * 10 is less than 7
    for rate in ("30000/1001", Fraction(30000, 1001), 30000 / 1001):
        assert exact.at(span=(0, 1.001), fps=rate).t[1] == 1 / (30000 / 1001)
    for scale in (1e-6, 1e6):
        assert exact.at(span=(0, scale), fps=60 / scale).t.size == 61
    assert twrench.exact_many([1, 2, 3], [[1, 0, 0]], span=(0, 1), fps=2).X.shape == (1, 3, 3, 3)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({}, "times: must be given, or a span: np.linspace"),
        ({"times": [0], "span": (0, 1)}, "span: cannot be combined with times"),
        ({"times": [0], "fps": 3}, "fps: is for span"),
        ({"span": (1, 0)}, "span: must end after it starts"),
        ({"span": 3}, "span: must be two times"),
        ({"span": (0, 1e9), "fps": 1e9}, "span: has more than"),
        ({"span": (0, 1), "fps": 0}, "fps: must be greater than 0"),
        ({"span": (0, 1), "fps": "30/0"}, "fps: must be a number or a fraction"),
        ({"span": (0, 1), "fps": "fast"}, "fps: must be a number or a fraction"),
        ({"times": [0], "attitude": [1, 0]}, "attitude: must be a quaternion"),
        ({"times": [0], "attitude": [2, 0, 0, 0]}, "attitude: has the length 2"),
        ({"times": [0], "attitude": np.full((3, 3), np.nan)}, "attitude: must be finite"),
        ({"times": [0], "attitude": np.diag([1, 1, -1])}, "attitude: "),
        ({"times": [0], "attitude": "up"}, "attitude: must be a quaternion"),
    ],
)
def test_wrong_times_and_attitudes(arguments, message):
    with pytest.raises(twrench.UsageError, match=message):
        twrench.simulate(BODY, [1, 0, 0], **arguments)


def test_misspelt_names_are_guessed():
    with pytest.raises(twrench.UsageError, match="did you mean 'rk4'"):
        twrench.simulate(BODY, [1, 0, 0], [0], "RK4")
    with pytest.raises(twrench.UsageError, match="did you mean 'rk4'"):
        twrench.study(BODY, [1, 0, 0], ["RK4"], duration=1)
    with pytest.raises(twrench.SceneError, match="did you mean 'studio'"):
        Scene(theme="Studio")
    with pytest.raises(twrench.SceneError, match="did you mean 'size'"):
        Scene(sise=(640, 360))


def test_a_solid_is_refused_where_it_is_made_by_its_name():
    for make, message in (
        (lambda: Box(size="hello", density=1), "^Box: size: must be three numbers, not 'hello'"),
        (lambda: Box(size=[1, 2, -3], density=1, name="leg"), "^Box 'leg': .*size"),
        (lambda: twrench.Sphere(radius=-1, density=1), "^Sphere: radius: must be greater"),
        (lambda: Box(size=[1, 2, 3], density=-1), "^Box: density: must be greater than 0"),
        (lambda: Box(size=[1, 2, 3]), "^Box: density: give exactly one of density and mass"),
        (lambda: Box(size=[1, 2, 3], density=1, material="bras"), "^Box: .*did you mean 'brass'"),
        (lambda: twrench.Torus(radius=1, tube_radius=2, density=1), "^Torus: .*tube_radius"),
    ):
        with pytest.raises(twrench.UsageError, match=message):
            make()
    with pytest.raises(twrench.UsageError, match="^Mesh: vertices: give either file"):
        twrench.Body([twrench.Mesh(density=1)])
    with pytest.raises(TypeError, match="positional"):
        Box([1, 2, 3], 1)


@pytest.mark.parametrize("scale", [1e-6, 1, 1e6])
def test_arrays_may_be_read_only_and_strided(scale):
    times = np.linspace(0, 5, 41)[::-2]
    times.flags.writeable = False
    omega = np.array([[0.1, 9], [1, 9], [0.2, 9]])[:, 0]
    body = twrench.Body(moments=scale**5 * np.array([3.0, 2, 1])[::-1])
    motion = twrench.simulate(body, omega, times)
    again = twrench.simulate(body, omega.tolist(), times.tolist())
    np.testing.assert_array_equal(motion.X, again.X)
    attitude = np.asfortranarray(motion.X[3])
    attitude.flags.writeable = False
    turned = twrench.simulate(body, omega, times, attitude=attitude)
    np.testing.assert_allclose(turned.X, attitude @ motion.X, atol=1e-13)


def test_a_tilted_motion_is_the_attitude_times_the_motion_from_the_identity(tmp_path):
    Rotation = pytest.importorskip("scipy.spatial.transform").Rotation
    turn = Rotation.from_euler("zyx", [0.3, -0.7, 1.1])
    x, y, z, w = turn.as_quat()
    times, omega = np.linspace(0, 20, 81), [0.1, 1, 0.2]
    for method in ("exact", "rk4", "rkmk45", "euler", "taylor"):
        plain = twrench.simulate(BODY, omega, times, method)
        for attitude in (turn, turn.as_matrix(), [w, x, y, z], -np.array([w, x, y, z])):
            tilted = twrench.simulate(BODY, omega, times, method, attitude=attitude)
            np.testing.assert_allclose(tilted.X, turn.as_matrix() @ plain.X, atol=1e-8)
            np.testing.assert_allclose(tilted.omega, plain.omega, atol=1e-8)
            np.testing.assert_allclose(tilted.momentum, turn.as_matrix() @ plain.momentum)
            assert np.abs(tilted.momentum_error).max() < max(
                1e-12, 2 * np.abs(plain.momentum_error).max()
            )


def test_a_scene_with_an_attitude(program, tmp_path):
    attitude = (0.5, 0.5, -0.5, 0.5)
    scene = Scene("stable-y", attitude=attitude, size=(160, 90), duration=5, fps=6, speed=1)
    assert scene.attitude == attitude and Scene().attitude is None
    assert scene.to_dict()["motion"]["attitude"] == list(attitude)
    X = twrench.exact(scene.body, scene.omega, attitude=attitude).at([0]).X[0]
    np.testing.assert_allclose(X, [[0, -1, 0], [0, 0, -1], [1, 0, 0]], atol=1e-15)
    np.testing.assert_allclose(scene.simulate().X[0], X, atol=1e-15)
    options = ["stable-y", "--attitude", "0.5,0.5,-0.5,0.5", "--duration", 5, "--fps", 6]
    scene.export(tmp_path / "a.csv")
    assert (tmp_path / "a.csv").read_text() == program("simulate", *options)
    assert (scene.frame(0) != Scene("stable-y", size=(160, 90)).frame(0)).any()
    again = Scene.from_toml(
        "[body]\nmoments = [1, 2, 3]\n[motion]\nattitude = [0.5, 0.5, -0.5, 0.5]\n"
    )
    assert again.attitude == attitude
    again.attitude = None
    assert again.attitude is None and "attitude" not in again.to_dict()["motion"]
    with pytest.raises(twrench.SceneError, match="attitude: has the length 0"):
        scene.attitude = (0, 0, 0, 0)
    with pytest.raises(twrench.SceneError, match="attitude: must be a quaternion"):
        scene.attitude = (1, 0)


def test_rotations_angles_and_files(tmp_path):
    pytest.importorskip("scipy")
    motion = twrench.simulate(BODY, [0.1, 1, 0.2], np.linspace(0, 5, 11))
    np.testing.assert_allclose(motion.rotation.as_matrix(), motion.X, atol=1e-14)
    yaw, pitch, roll = motion.euler("ZYX").T
    np.testing.assert_allclose(-np.sin(pitch), motion.X[:, 2, 0], atol=1e-14)
    np.testing.assert_allclose(np.tan(roll), motion.X[:, 2, 1] / motion.X[:, 2, 2], atol=1e-10)
    np.testing.assert_allclose(np.rad2deg(yaw), motion.euler("ZYX", degrees=True)[:, 0])
    with pytest.raises(twrench.UsageError, match="sequence: must be three axes"):
        motion.euler("abc")
    saved = np.load(motion.save(tmp_path / "a.npz"))
    for name in ("t", "X", "omega", "energy", "momentum_error"):
        np.testing.assert_array_equal(saved[name], getattr(motion, name))
    table = np.genfromtxt(motion.save(str(tmp_path / "a.csv")), delimiter=",", names=True)
    np.testing.assert_array_equal(table["x32"], motion.X[:, 2, 1])
    np.testing.assert_array_equal(table["wz"], motion.omega[:, 2])
    with pytest.raises(twrench.UsageError, match="must end in .csv or .npz"):
        motion.save("a.txt")
    for name in ("a.csv", "a.npz"):
        with pytest.raises(twrench.FileError):
            motion.save(tmp_path / "none" / name)


def test_the_exact_motion_says_what_it_is():
    assert repr(twrench.exact(BODY, [0.1, 1, 0.2])).startswith("<twrench.ExactMotion: about_")
    assert "flips every" in repr(twrench.exact(twrench.Scene().body, [1, 0.05, 0]))
    assert repr(twrench.exact(BODY, [1, 0, 0])) == "<twrench.ExactMotion: steady, without flips>"
    sphere = twrench.Body(moments=[1, 1, 1])
    assert "without flips" in repr(twrench.exact(sphere, [1, 2, 3]))


GOOD = {"t": [0, 1, 2, 3], "wx": 4 * [1], "wy": 4 * [0], "wz": 4 * [0]}


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: twrench.Scene("\ud800"), "^source: must be a path in UTF-8"),
        (lambda: twrench.check("\udcff.csv", BODY), "^data: must be a path in UTF-8"),
        (lambda: twrench.case("\ud800"), "^name: has half of a surrogate pair"),
        (lambda: twrench.case(3), "^name: must be a string"),
        (lambda: twrench.study(BODY, [1, 0, 0], 3, duration=1), "^methods: must be a list of names"),
        (lambda: twrench.study(BODY, [1, 0, 0], [3], duration=1), "^methods: must be a string"),
        (lambda: twrench.check(GOOD, BODY, columns=[1]), "^columns: must be a mapping"),
        (lambda: twrench.check({}, BODY), "^data: must have columns"),
        (lambda: twrench.check(GOOD, BODY, omega_at=np.array(["a"])), "^omega_at: must be a number"),
        (lambda: twrench.compare("a.png", "b.png", ignore=3), "^ignore: must be a list of rectangles"),
        (lambda: twrench.exact(BODY, np.ma.array([1, 0, 0], mask=[0, 1, 0])), "^omega: has masked"),
        (lambda: Scene().frame(time=1e308), "^time: must be from 0 to"),
        (lambda: Scene().frame(time=-1e308), "^time: must be from 0 to"),
        (lambda: Scene().render("a.mp4", frames="\ud800"), "^frames: has half of a surrogate pair"),
    ],
)
def test_wrong_types_are_told_by_argument(call, message):
    with pytest.raises(twrench.UsageError, match=message):
        call()


def test_times_beyond_the_memory_are_refused_before_they_are_copied():
    times = np.broadcast_to(1.0, 2**31)
    for call in (
        lambda: twrench.exact(BODY, [1, 0, 0]).at(times),
        lambda: twrench.simulate(BODY, [1, 0, 0], times, "rk4"),
        lambda: twrench.exact_many([1, 2, 3], [[1, 0, 0]], times),
        lambda: twrench.exact_many([1, 2, 3], np.broadcast_to(1.0, (2**31, 3)), [0]),
        lambda: twrench.check({"t": times}, BODY),
    ):
        with pytest.raises(twrench.UsageError, match="numbers, the limit is 300000000"):
            call()
    with pytest.raises(MemoryError):  # times within the limit, for a million bodies
        twrench.exact_many([1, 2, 3], np.ones((10**6, 3)), np.broadcast_to(1.0, 10**7))


def test_arrays_of_any_layout_are_read():
    times, omega = np.linspace(0, 5, 11), np.array([0.1, 1, 0.2])
    expected = twrench.exact(BODY, omega).at(times)
    read_only = times.copy()
    read_only.flags.writeable = False
    for same in (read_only, np.repeat(times, 2)[::2], times[::-1][::-1], times.astype(">f8")):
        motion = twrench.exact(BODY, omega[::-1].copy()[::-1]).at(same)
        np.testing.assert_array_equal(motion.X, expected.X)
        assert motion.X.flags.writeable and motion.t is not same
    columns = np.asfortranarray(np.tile(omega, (4, 1)))
    many = twrench.exact_many(np.broadcast_to([1.0, 2, 3], (4, 3)), columns, times)
    np.testing.assert_array_equal(many.X[3], expected.X)


def test_threads_call_at_once(tmp_path):
    motion = twrench.simulate(BODY, [0.1, 1, 0.2], np.linspace(0, 5, 50))
    scene = Scene("stable-y")

    def work(i: int) -> bool:
        scene.export(tmp_path / f"{i}.aem")
        return twrench.check(motion, BODY).finding == "exact" and bool(
            motion.save(tmp_path / f"{i}.csv")
        )

    with ThreadPoolExecutor(4) as pool:
        assert all(pool.map(work, range(12)))
    assert len({(tmp_path / f"{i}.aem").read_bytes() for i in range(12)}) == 1


@pytest.mark.parametrize(
    ("function", "call"),
    [
        ("page", lambda scene: scene.page("a.html")),
        ("report", lambda scene: scene.report("a.md")),
        ("export_motion", lambda scene: scene.export("a.glb")),
        ("draw_plot", lambda scene: scene.plot("a.svg")),
        ("attitude_curves", lambda scene: scene.plot()),
        ("render", lambda scene: scene.render("a.mp4")),
        ("FrameDrawer", lambda scene: scene.frame(0)),
    ],
)
def test_other_threads_may_change_a_scene_while_it_is_used(monkeypatch, function, call):
    """Without Python's global lock, the module reads only a copy of the scene."""
    pytest.importorskip("matplotlib")
    used = []

    def record(given: Any, *_: object) -> None:
        while isinstance(given, (list, tuple)):  # of scenes, or of scenes with their sources
            given = given[0]
        used.append(given)
        raise InterruptedError

    scene = Scene()
    monkeypatch.setattr(_native, function, record)
    with pytest.raises(InterruptedError):
        call(scene)
    assert used[0].json() == scene._native.json() and used[0] is not scene._native


@pytest.mark.parametrize(
    "call",
    [
        "twrench.Scene(method='rk4', step=2.5e-6, fps=1000).export(folder + '/a.csv')",
        "twrench.Scene(method='rk4', step=2.5e-6).plot(folder + '/a.svg')",
        "twrench.Scene(duration=6e4).report(folder + '/a.md')",
        "twrench.Scene(duration=4000).export(folder + '/a.glb', max_angle=1.1e-6)",
        "twrench.check(10_000 * [recording], body)",
        "twrench.check(10_000 * [recording], body, fit=True)",
        "twrench.pages(folder, template=template)",
        "twrench.Scene(duration=4e4, speed=500, method='suzuki4', step=1e-3).frame(-1)",
    ],
)
def test_ctrl_c_ends_a_long_call_and_leaves_nothing(tmp_path, template, call):
    others = tmp_path / "others"
    others.mkdir()
    shutil.move(template, others / "template.html")
    motion = twrench.simulate(BODY, [0.1, 1, 0.2], np.linspace(0, 9, 20_000), "rk4", step=0.1)
    motion.save(others / "motion.csv")
    code = (
        "import sys, twrench\nfolder, others = sys.argv[1:]\n"
        "recording, template = others + '/motion.csv', others + '/template.html'\n"
        "body = twrench.Body(moments=[1, 2, 3])\nprint('begins', flush=True)\n"
        f"try:\n    {call}\nexcept KeyboardInterrupt:\n    print('ended')\n"
    )
    folder = tmp_path / "folder"
    folder.mkdir()
    child = subprocess.Popen(
        [sys.executable, "-c", code, str(folder), str(others)], stdout=subprocess.PIPE, text=True
    )
    assert child.stdout is not None and child.stdout.readline() == "begins\n"
    time.sleep(0.5)
    child.send_signal(signal.SIGINT)
    assert child.communicate(timeout=60)[0] == "ended\n"
    assert list(folder.iterdir()) == []


def test_numbers_beyond_those_of_double_precision_are_refused_without_a_warning():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(twrench.UsageError, match="^span: has more than"):
            twrench.simulate(BODY, [1, 0, 0], span=(-1e308, 1e308), fps=1)
        if np.finfo(np.longdouble).max > np.finfo(float).max:
            huge = np.array([np.finfo(np.longdouble).max])
            with pytest.raises(twrench.UsageError, match="^times: must be finite"):
                twrench.simulate(BODY, [1, 0, 0], huge)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"methods": []}, "^methods: there must be one at least"),
        ({"steps": []}, "^steps: there must be one at least"),
        ({"steps": [0.1, -1]}, "^steps: is -1"),
        ({"steps": [1e-300]}, "^steps: is 1e-300"),
        ({"tolerances": [0]}, "^tolerances: is 0"),
        ({"methods": ["rkf45"], "tolerances": []}, "^tolerances: there must be one at least"),
    ],
)
def test_the_errors_of_a_study_name_its_lists(arguments, message):
    with pytest.raises(twrench.UsageError, match=message):
        twrench.study(BODY, [0.1, 1, 0.2], **{"methods": ["rk4"], "duration": 1, **arguments})


def test_the_text_of_an_error_is_one_line(tmp_path):
    with pytest.raises(twrench.UsageError, match=r"^epoch: is 2026\\nX\\x1b, but") as raised:
        Scene().export(tmp_path / "a.aem", epoch="2026\nX\x1b")
    assert str(raised.value).isprintable()
