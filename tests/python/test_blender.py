"""The scripts of ``Scene.export`` for Blender, run with a stand-in for its module ``bpy``."""

import runpy
import sys
import types

import numpy as np
import pytest

import twrench
from twrench import Body, Recording, Scene

BODY = Body(moments=(2, 3, 4.5))


class Point:
    def __init__(self, frame=0.0, value=0.0):
        self.co = [frame, value]
        self.interpolation = "BEZIER"


class Points(list):
    def add(self, count):
        self.extend(Point() for _ in range(count))

    def foreach_set(self, name, numbers):
        assert name == "co" and len(numbers) == 2 * len(self)
        for point, frame, value in zip(self, numbers[::2], numbers[1::2]):
            point.co = [frame, value]


class Curve:
    def __init__(self, data_path, array_index, points):
        self.data_path, self.array_index, self.keyframe_points = data_path, array_index, Points(points)
        self.is_current = False

    def update(self):
        self.is_current = True


class Object:
    """An object whose animation is in a slot of its action, as since Blender 4.4, or not."""

    def __init__(self, name, has_slots):
        self.name, self.has_slots, self.animation_data = name, has_slots, None

    @property
    def curves(self):
        action = self.animation_data.action
        return action.layers[0].strips[0].channelbag("slot").fcurves if self.has_slots else action.fcurves

    def keyframe_insert(self, data_path, frame):
        if self.animation_data is None:
            curves = []
            if self.has_slots:
                bag = types.SimpleNamespace(fcurves=curves)
                strip = types.SimpleNamespace(channelbag={"slot": bag}.get)
                action = types.SimpleNamespace(layers=[types.SimpleNamespace(strips=[strip])])
                self.animation_data = types.SimpleNamespace(action=action, action_slot="slot")
            else:
                self.animation_data = types.SimpleNamespace(action=types.SimpleNamespace(fcurves=curves))
        for index in range(4):
            self.curves.append(Curve(data_path, index, [Point(frame, float(index == 0))]))


class Objects(dict):
    def __init__(self, has_slots):
        super().__init__()
        self.has_slots = has_slots

    def new(self, name, data):
        assert data is None
        self[name] = Object(name, self.has_slots)
        return self[name]


def blender(has_slots=False):
    """Returns a stand-in for ``bpy`` with an empty scene."""
    linked = []
    render = types.SimpleNamespace(fps=24, fps_base=1.0)
    scene = types.SimpleNamespace(
        render=render, frame_start=1, frame_end=250, frame_set=lambda frame: None,
        collection=types.SimpleNamespace(objects=types.SimpleNamespace(link=linked.append)), linked=linked,
    )  # fmt: skip
    bpy = types.ModuleType("bpy")
    bpy.data = types.SimpleNamespace(objects=Objects(has_slots))
    bpy.context = types.SimpleNamespace(scene=scene)
    return bpy


def run(script, bpy, monkeypatch):
    monkeypatch.setitem(sys.modules, "bpy", bpy)
    runpy.run_path(str(script))
    return bpy.data.objects["twrench"]


def attitudes(body, frames):
    """The rotations at some frames: Blender interpolates the components of the quaternion one by one."""
    curves = sorted(body.curves, key=lambda curve: curve.array_index)
    components = []
    for curve in curves:
        assert curve.is_current and {point.interpolation for point in curve.keyframe_points} == {"LINEAR"}
        times, values = np.transpose([point.co for point in curve.keyframe_points])
        assert (np.diff(times) > 0).all()
        components.append(np.interp(frames, times, values))
    w, x, y, z = np.array(components) / np.linalg.norm(components, axis=0)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    ).transpose(2, 0, 1)


def angles(a, b):
    return 2 * np.arcsin(np.linalg.norm(a - b, axis=(1, 2)) / np.sqrt(8))


@pytest.mark.parametrize("has_slots", [False, True])
@pytest.mark.parametrize(("fps", "speed"), [(60, 1), ("30000/1001", 3)])
def test_the_attitude_in_blender_is_exact(tmp_path, monkeypatch, has_slots, fps, speed):
    scene = Scene(body=BODY, omega=(0.3, 2, 0.1), duration=12, fps=fps)
    bpy = blender(has_slots)
    body = run(scene.export(tmp_path / "a.py", max_angle=1e-3, speed=speed), bpy, monkeypatch)
    assert bpy.context.scene.linked == [body] and body.rotation_mode == "QUATERNION"
    render = bpy.context.scene.render
    rate = render.fps / render.fps_base
    assert isinstance(render.fps, int) and rate == pytest.approx(scene.fps, rel=1e-12)
    assert (bpy.context.scene.frame_start, bpy.context.scene.frame_end) == (0, round(12 / speed * rate))
    frames = np.random.default_rng(2026).uniform(0, 12 / speed * rate, 300)
    exact = twrench.simulate(BODY, (0.3, 2, 0.1), np.sort(frames) * speed / rate, "exact").X
    off = angles(attitudes(body, np.sort(frames)), exact)
    assert off.max() < 1e-3
    assert off.max() > 1e-4, "and there are no more keys than needed"


def test_a_recorded_motion_goes_to_blender(tmp_path, monkeypatch):
    motion = twrench.simulate(BODY, (0.3, 2, 0.1), np.linspace(0, 5, 501), "exact")
    scene = Scene(body=BODY, motion=Recording(motion.t, motion.omega, motion.X))
    body = run(scene.export(tmp_path / "a.py"), blender(), monkeypatch)
    assert angles(attitudes(body, 60 * motion.t), motion.X).max() < 1.1e-4


def test_the_named_object_is_taken_and_its_other_curves_stay(tmp_path, monkeypatch):
    bpy = blender()
    body = bpy.data.objects.new("twrench", None)
    script = Scene(body=BODY, omega=(0, 2, 0.1), duration=2).export(tmp_path / "a.py")
    run(script, bpy, monkeypatch)
    moved = Curve("location", 0, [Point(1, 2)])
    body.curves.append(moved)
    assert run(script, bpy, monkeypatch) is body and bpy.context.scene.linked == []
    assert moved in body.curves and len(body.curves) == 5


@pytest.mark.parametrize("name", ["a\nimport os", 'quote " \\', "blå"])
def test_a_name_stays_in_its_comment(tmp_path, monkeypatch, name):
    script = Scene.from_toml('[body]\nmoments = [1, 2, 3]\n', name).export(tmp_path / "a.py", max_angle=0.1)
    run(script, blender(), monkeypatch)
    assert script.read_bytes().isascii()


def test_more_frames_than_blender_has_are_refused(tmp_path):
    with pytest.raises(twrench.UsageError, match="but Blender has at most 1048574"):
        Scene("stable-y", duration=20000).export(tmp_path / "a.py")
    assert list(tmp_path.iterdir()) == []


def test_the_name_of_a_scene_is_no_coding(tmp_path):
    script = tmp_path / "a.py"
    scene = Scene.from_toml("[body]\nmoments = [2, 3, 4]\n", "coding: nonsense.toml")
    scene.export(script)
    compile(script.read_bytes(), "a.py", "exec")
    assert b"coding: nonsense" in script.read_bytes()
