from __future__ import annotations

import copy
import json
import math
import pickle
import os
import signal
import sys
import subprocess
import threading
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import twrench
from twrench import Scene, SceneError

Image = pytest.importorskip("PIL.Image")


def pixels(file: Path) -> np.ndarray:
    return np.asarray(Image.open(file))


def test_every_key_of_a_scene_file_is_an_attribute_and_can_be_set():
    from twrench import _native
    from twrench.scene import _Value

    keys = {field.key for field in _native.fields()}
    # The material follows from colour, metalness and roughness; see below.
    keys = keys - {"frame"} | {"camera_frame"}
    assert keys == {key for key, value in vars(Scene).items() if isinstance(value, _Value)}
    other = {
        "title": "Another", "language": "nb", "omega": (2.0, 0.1, 0.0),
        "attitude": (0.5, 0.5, -0.5, 0.5),
        "wheel": (1.0, 2.0, 3.0), "energy_loss_time": 500.0, "method": "rkmk4", "step": 0.02,
        "tolerance": 1e-8, "duration": 12.0, "size": (320, 200), "fps": 24.0, "speed": 2.0,
        "audio": "tone.wav", "sound": "motion", "text_fade": 0.5,
        "theme": "paper", "samples": 4, "motion_blur": 2, "background": "#102030",
        "color": "#ff8800", "metallic": 0.25, "roughness": 0.5, "azimuth": 0.5, "elevation": 0.1,
        "distance": 1.5, "orbit": 0.1, "field_of_view": 0.7, "view": "quad",
        "camera_frame": "body",
        "show": ("floor", "axes"), "stress": ("axes",), "forces": ("coriolis",), "compare": ("rk4", "exact"),
        "compare_omega": ((1.0, 0.0, 0.0), (0.0, 1.0, 0.5)),
        "compare_wheel": ((0.0, 0.0, 0.0), (0.0, 20.0, 0.0)), "trail_point": (1.0, 2.0, 3.0),
        "trail_length": 5.0, "star_trail": 1.5, "font": "mono",
    }  # fmt: skip
    assert other.keys() == keys - {"material"}
    scene = Scene()
    for key, value in other.items():
        assert getattr(scene, key) != value
        setattr(scene, key, value)
        assert getattr(scene, key) == value, key
    assert {key: getattr(Scene(**other), key) for key in other} == other


def test_a_page_begins_with_the_last_of_the_compared_wheels(template, tmp_path):
    Scene("dual-spin").page(tmp_path / "p.html", template=template)
    assert '"wheel":[40000000.0,0.0,0.0]' in (tmp_path / "p.html").read_text()


def test_a_scene_with_a_wheel_and_energy_loss(program, tmp_path):
    scene = Scene("t-handle", wheel=[100, 0, 0], duration=9)
    assert Scene("t-handle").method == "exact" and scene.method == "taylor"
    assert scene.energy_loss_time is None
    scene.energy_loss_time = 30
    assert scene.to_dict()["motion"]["wheel"] == [100, 0, 0]
    motion = scene.simulate()
    assert motion.method == "taylor" and motion.energy[-1] < motion.energy[0]
    scene.export(tmp_path / "a.csv")
    options = ["--wheel", "100,0,0", "--energy-loss-time", 30, "--duration", 9]
    program("simulate", "t-handle", *options, "-o", tmp_path / "b.csv")
    assert (tmp_path / "a.csv").read_bytes() == (tmp_path / "b.csv").read_bytes()
    scene.report(tmp_path / "r.md")
    report = (tmp_path / "r.md").read_text()
    assert "twrench study t-handle --wheel 100,0,0 --energy-loss-time 30" in report
    scene.export(tmp_path / "a.glb")
    program("export", "t-handle", *options, "-o", tmp_path / "b.glb")
    assert (tmp_path / "a.glb").read_bytes() == (tmp_path / "b.glb").read_bytes()
    before = sorted(file.name for file in tmp_path.iterdir())
    show = set(scene.show)
    scene.show = show | {"plane"}
    for drawn in (lambda: scene.frame(0), lambda: scene.render(tmp_path / "f.mp4")):
        with pytest.raises(twrench.UsageError, match="show: plane can be shown only of a rigid"):
            drawn()
    assert sorted(file.name for file in tmp_path.iterdir()) == before
    scene.show = show
    scene.size = (64, 48)
    assert (scene.frame(0) != scene.frame(100)).any()
    for value in (0.01, 0, -1, "soon", [1, 2]):
        with pytest.raises(SceneError, match="energy_loss_time: "):
            scene.energy_loss_time = value
        assert scene.energy_loss_time == 30
    with pytest.raises(SceneError, match="energy_loss_time: the body has no single axis"):
        scene.body = twrench.Body(moments=[2, 2, 2])
    for none in (None, float("inf")):
        scene.energy_loss_time = 30
        scene.energy_loss_time = none
        assert scene.energy_loss_time is None
    scene.wheel = None
    assert scene.wheel is None


def test_a_material_is_a_colour_a_metalness_and_a_roughness():
    scene = Scene(material="rubber", roughness=0.5)
    assert (scene.color, scene.metallic, scene.roughness) == ("#484644", 0, 0.5)
    assert scene.material is None
    scene.material = "brass"
    assert (scene.color, scene.metallic, scene.material) == ("#f4e4ad", 1, "brass")
    with pytest.raises(SceneError, match="material: .*did you mean 'brass'"):
        scene.material = "bras"


def test_a_scene_is_that_of_its_file(tmp_path):
    toml = '[motion]\nomega = [1, 0, 2]\n[film]\nsize = [64, 48]\n[body]\nmoments = [1, 2, 3]\n'
    file = tmp_path / "mine.toml"
    file.write_text(toml)
    for scene in (Scene(file), Scene(str(file)), Scene.from_toml(toml, "mine")):
        assert scene.name == "mine" and scene.omega == (1, 0, 2) and scene.size == (64, 48)
        assert scene.body.principal_moments.tolist() == [1, 2, 3]
    assert Scene(file, fps=30).fps == 30
    for rate in ("24000/1001", Fraction(24000, 1001)):
        assert Scene(file, fps=rate).fps == 24000 / 1001
    assert Scene().to_dict()["motion"]["omega"] == [1, 0.05, 0]
    assert json.dumps(Scene().to_dict())
    assert repr(Scene()) == "<twrench.Scene dzhanibekov: 960 frames of 1920x1080>"


def test_a_body_can_be_put_into_a_scene(small):
    small.body = twrench.Body([twrench.Box(size=[1, 2, 5], density=2)])
    assert small.body.mass == pytest.approx(20)
    first = small.frame(3)
    small.body = twrench.Body(moments=[1, 2, 3])
    assert (small.frame(3) != first).any()
    for body, message in [
        (None, "body: must be a twrench.Body"),
        (twrench.Body([twrench.Sphere(radius=1e7, density=1)]), "radii"),
        (twrench.Body(moments=[1, 2, 3e15]), "moments"),
        (twrench.Body(inertia=[1, 2, 3e15, 0, 0, 0.1]), "inertia"),
    ]:
        before = small.body.inertia
        with pytest.raises(SceneError, match=message):
            small.body = body
        np.testing.assert_array_equal(small.body.inertia, before)


def test_a_body_with_products_of_inertia_can_be_shown(small):
    inertia = [[3, 0.25, -0.1], [0.25, 4, 0.3], [-0.1, 0.3, 5]]
    small.body = twrench.Body(inertia=inertia, shape="cross")
    assert small.to_dict()["body"] == {"inertia": inertia, "shape": "cross"}
    again = Scene.from_toml(f"[body]\ninertia = {inertia}\nshape = 'cross'")
    assert again.to_dict()["body"] == small.to_dict()["body"]
    np.testing.assert_array_equal(again.body.inertia, inertia)
    assert again.body.principal_moments.tolist() == small.body.principal_moments.tolist()
    first = small.frame(3)
    small.body = twrench.Body(moments=small.body.principal_moments, shape="cross")
    assert (small.frame(3) != first).any()


def test_a_diagonal_inertia_is_the_same_as_moments(small):
    small.body = twrench.Body(moments=[3, 5, 4])
    first = small.frame(3)
    small.body = twrench.Body(inertia=np.diag([3, 5, 4]))
    assert small.to_dict()["body"] == {"moments": [3, 5, 4], "shape": "box"}
    assert (small.frame(3) == first).all()


def test_another_body_has_a_neutral_title_and_times_of_its_own():
    body = twrench.Body(moments=[3, 5, 7])
    scene = Scene(body=body, omega=[1e-6, 2e-5, 0])
    assert scene.title == "A free rigid body"
    assert (scene.step, scene.speed) == (500, 290000)
    assert twrench.exact(body, scene.omega).flip_times(scene.duration).size == 3
    scene.omega = [1e3, 2e4, 0]  # a billion times as fast
    assert (scene.step, scene.speed) == (5e-7, 2.9e-4)
    assert twrench.exact(body, scene.omega).flip_times(scene.duration).size == 3
    assert 500 <= scene.frame_count <= 4000


def test_values_that_the_caller_gave_stay_with_another_body():
    body = twrench.Body(moments=[3, 5, 7])
    own = {"title": "Mine", "step": 0.02, "duration": 12.0, "speed": 2.0}
    late = Scene(**own)
    late.body = body
    restored = pickle.loads(pickle.dumps(Scene(**own)))
    restored.body = body
    first = Scene(duration=12.0, body=body, title="Mine", step=0.02, speed=2.0)
    for scene in (first, late, restored):
        assert {key: getattr(scene, key) for key in own} == own
    fresh = pickle.loads(pickle.dumps(Scene()))
    fresh.body = body
    assert (fresh.title, fresh.duration) == (Scene(body=body).title, Scene(body=body).duration)


def test_the_length_of_the_video():
    scene = Scene("dzhanibekov")
    assert scene.length == 16
    scene.length = 4
    assert (scene.length, scene.duration, scene.speed) == (4, 24, 6)
    scene.speed = 2
    assert (scene.length, scene.duration) == (12, 24)
    assert Scene(length=4, speed=1).duration == 4
    assert Scene(length=4, duration=2).speed == 0.5
    with pytest.raises(SceneError, match="^length: duration and speed determine it"):
        Scene(length=4, duration=2, speed=0.5)
    for wrong in (0, -1, 1e7):
        with pytest.raises(SceneError, match="^length: is "):
            scene.length = wrong
    with pytest.raises(twrench.UsageError, match="^length: must be a number"):
        Scene(length="long")  # type: ignore[arg-type]
    with pytest.raises(SceneError, match="^length: each shot of explain has its own"):
        Scene("explain", length=4)
    assert scene.length == 12


@pytest.mark.parametrize(
    ("key", "value", "message"),
    [
        ("omega", [1, 2], "omega: must be an array of 3 numbers"),
        ("omega", "fast", "omega: must be an array of 3 numbers"),
        ("omega", [1, math.nan, 2], "omega: cannot be"),
        ("omega", None, "omega: must be"),
        ("size", (0, 0), "size"),
        ("size", (640.5, 360), "size"),
        ("size", [10**30, 10], "size"),
        ("fps", "30", "fps: '30' is not a fraction"),
        ("fps", 10**400, "fps"),
        ("fps", True, "fps: must be a number"),
        ("method", "rk5", "method: .*rk5"),
        ("theme", "dark", "theme: .*dark"),
        ("view", 3, "view: must be a string"),
        ("show", ["everything"], "everything"),
        ("show", "floor", "show: must be an array of strings"),
        ("color", "#12", "color"),
        ("compare", ["rk4"] * 5, "compare"),
        ("title", b"bytes", "title: cannot be"),
        ("title", object(), "title: cannot be"),
        ("title", "\ud800", "title: cannot be"),
        ("colour", "red", "colour.*did you mean 'color'"),
    ],
)
def test_a_wrong_value_is_refused_and_changes_nothing(key, value, message):
    scene = Scene()
    before = scene.to_dict()
    with pytest.raises(SceneError, match=message):
        setattr(scene, key, value)
    with pytest.raises(SceneError, match=message):
        Scene(**{key: value})
    assert scene.to_dict() == before


def test_mistakes_of_files(tmp_path):
    file = tmp_path / "mine.toml"
    file.write_text("[motion]\nomega = [1, 2]\n[body]\nmoments = [1, 2, 3]\n")
    with pytest.raises(SceneError, match="mine.toml:2: motion.omega"):
        Scene(file)
    with pytest.raises(SceneError, match="mine:1"):
        Scene.from_toml("omega =", "mine")
    with pytest.raises(twrench.UsageError, match="text: has half of a surrogate pair"):
        Scene.from_toml("\ud800")
    with pytest.raises(twrench.FileError, match="none.toml"):
        Scene(tmp_path / "none.toml")
    with pytest.raises(SceneError, match="dzhanibekof.*did you mean 'dzhanibekov'"):
        Scene("dzhanibekof")
    for source in (None, 3, b"sphere", "", "a\0b"):
        with pytest.raises(twrench.UsageError, match="source: must be a path"):
            Scene(source)


def test_a_frame_is_that_of_the_program_byte_for_byte(small, program, tmp_path):
    size = ["--size", "160x90", "--duration", 24, "--fps", 6, "--speed", 6]
    program("render", *size, "--no-video", "--frames-dir", tmp_path / "f", "--progress", "none")
    for index in (0, 7, 23, -1):
        file = tmp_path / "f" / f"frame_{index % 24:06d}.png"
        np.testing.assert_array_equal(small.frame(index), pixels(file))
        assert small.png(index) == file.read_bytes()
    np.testing.assert_array_equal(small.frame(time=7.1), small.frame(7))


def test_a_transparent_frame_has_alpha(small):
    assert small.frame(0).shape == (90, 160, 3)
    small.background = "transparent"
    small.show = ()
    frame = small.frame(0)
    assert frame.shape == (90, 160, 4) and frame.dtype == np.uint8
    assert frame[0, 0, 3] == 0 and frame[..., 3].max() == 255


def test_a_change_shows_at_once(small):
    before = small.frame(5)
    small.theme = "paper"
    assert (small.frame(5) != before).mean() > 0.5
    small.theme = "studio"
    np.testing.assert_array_equal(small.frame(5), before)


@pytest.mark.parametrize(
    "wrong",
    [{}, {"index": 1, "time": 2}, {"index": 24}, {"index": -25}, {"index": 1.5}, {"index": True},
     {"index": "1"}, {"time": 25}, {"time": -1}, {"time": math.nan}, {"time": "1"}],
)  # fmt: skip
def test_wrong_frames(small, wrong):
    with pytest.raises(twrench.UsageError, match="frame|index|time"):
        small.frame(**wrong)


def test_a_scene_shows_itself_in_a_notebook(small):
    assert small._repr_png_() == small.png(6)
    assert small._repr_png_().startswith(b"\x89PNG")


def test_a_copy_is_a_scene_of_its_own(small):
    for twin in (copy.copy(small), copy.deepcopy(small)):
        before = small.frame(3)
        np.testing.assert_array_equal(twin.frame(3), before)
        twin.theme = "paper"
        assert small.theme == "studio" and (twin.frame(3) != before).any()


def test_threads_draw_the_same_frames_as_one(small):
    """One scene is shared by all threads; each thread also has a scene, and so an OpenGL context."""
    wanted = [small.frame(i).copy() for i in range(6)]
    mine = threading.local()

    def draw(i: int) -> bool:
        if not hasattr(mine, "scene"):
            mine.scene = Scene(size=(160, 90), duration=24, fps=6, speed=6)
        scene = mine.scene if i % 2 else small
        return bool((scene.frame(i % 6) == wanted[i % 6]).all())

    with ThreadPoolExecutor(4) as pool:
        assert all(pool.map(draw, range(24)))


@pytest.mark.parametrize("is_new", [False, True])
def test_a_forked_process_cannot_draw(small, is_new):
    small.frame(0)
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            (Scene(size=(64, 48)) if is_new else small).frame(0)
            os.write(writer, b"drawn")
        except twrench.GlError as error:
            os.write(writer, str(error).encode())
        os._exit(0)
    os.close(writer)
    assert b"spawn" in os.read(reader, 1000)
    assert os.waitpid(child, 0)[1] == 0


def test_a_forked_process_may_drop_the_pictures_of_its_parent(small):
    small.frame(0)
    child = os.fork()
    if child == 0:
        signal.alarm(60)  # ends the process if it waits for the drawing thread, which it lacks
        small.theme = "paper"
        os._exit(0)
    assert os.waitpid(child, 0)[1] == 0
    assert small.frame(0).shape == (90, 160, 3)


def test_no_opengl_is_opened_before_a_picture_is_asked_for():
    code = (
        "import twrench; s = twrench.Scene(size=(64, 48)); s.simulate(); s.frame_count; repr(s); s.body\n"
        "maps = open('/proc/self/maps').read()\n"
        "assert 'libEGL' not in maps and 'OSMesa' not in maps\n"
        "s.frame(0); maps = open('/proc/self/maps').read()\n"
        "assert 'libEGL' in maps or 'OSMesa' in maps\n"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


def test_the_simulation_of_a_scene_is_at_its_frames(small):
    motion = small.simulate()
    np.testing.assert_array_equal(motion.t, np.arange(24) * 6 / 6)
    assert motion.method == small.method
    np.testing.assert_array_equal(small.times, motion.t)


def test_scenes_and_methods():
    assert twrench.scenes()[0] == "dzhanibekov"
    names = [method.name for method in twrench.methods()]
    assert {"rk4", "rkf45", "exact"} <= set(names) and len(names) == len(set(names))


BOX = """v 0 0 0
v 2 0 0
v 2 3 0
v 0 3 0
v 0 0 4
v 2 0 4
v 2 3 4
v 0 3 4
f 1 4 3 2
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
"""


def test_a_mesh_is_a_scene(program, tmp_path):
    file = tmp_path / "my box.obj"
    file.write_text(BOX)
    scene = Scene(file, unit="mm", mass=3, size=(160, 90))
    assert scene.title == scene.name == "my box"
    assert scene.body.mass == pytest.approx(3)
    assert len(twrench.exact(scene.body, scene.omega).flip_times(scene.duration)) == 3
    assert Scene(file, scale=0.1, density=2).body.mass == pytest.approx(0.048)
    assert Scene(file, unit="cm", shell=0.5).body.mass == pytest.approx(26)
    told = json.loads(program("inertia", file, "--unit", "mm", "--mass", 3, "--format", "json"))
    assert np.array_equal(scene.body.inertia, told["inertia"])
    with pytest.raises(twrench.OverwriteError, match="is an input"):
        scene.render(file, container="mp4", frames="0", overwrite=True)
    assert file.read_text() == BOX


def test_what_the_file_of_a_mesh_does_not_say(tmp_path):
    file = tmp_path / "box.obj"
    file.write_text(BOX)
    (tmp_path / "empty.stl").write_bytes(b"")
    for source, values, message in [
        (file, {}, "its unit is not known: the format has none; say unit"),
        (file, {"unit": "ft"}, "unit: unknown name 'ft'"),
        (file, {"unit": "mm", "scale": 2}, "scale: cannot be combined with unit"),
        (file, {"unit": "mm", "mass": 1, "density": 1}, "mass: density determines it"),
        (file, {"unit": "mm", "density": -1}, "density: is -1, but must be"),
        (file, {"unit": "mm", "weld": "1"}, "weld: must be a number"),
        (file, {"unit": "mm", "language": "d"}, "language: 'd' is not the tag of a language"),
        ("dzhanibekov", {"unit": "mm"}, "unit: is for a mesh"),
        (tmp_path / "empty.stl", {"unit": "mm"}, "it is empty"),
        (tmp_path / "none.stl", {"unit": "mm"}, "No such file"),
    ]:
        with pytest.raises(twrench.Error, match=message) as error:
            Scene(source, **values)
        assert "\n" not in str(error.value)


def test_a_scene_is_simulated_at_other_times():
    scene = Scene("stable-y", method="rkmk4", step=0.02)
    times = [3.0, -1.0, 0.5]
    motion = scene.simulate(times)
    same = twrench.simulate(scene.body, scene.omega, times, "rkmk4", step=0.02)
    assert motion.method == "rkmk4" and motion.t.tolist() == times
    assert (motion.X == same.X).all() and (motion.omega == same.omega).all()
    assert scene.simulate(span=(0, 1), fps=4).t.tolist() == [0, 0.25, 0.5, 0.75, 1]
    assert (scene.simulate().t == scene.times).all()
    with pytest.raises(twrench.UsageError, match="^times: must be given, or a span"):
        scene.simulate(fps=4)
    with pytest.raises(SceneError, match="film: it would have"):
        Scene(fps=1000, duration=1e12, speed=1e-3).simulate()
