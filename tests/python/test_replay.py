"""Scenes that show recordings."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

import twrench
from twrench import Body, Recording, Scene, SceneError, UsageError

BODY = Body(moments=[2, 3, 4.5])
START = (0.3, 2, 0.4)
SIZE = (160, 90)


def recorded(count: int = 401) -> Recording:
    motion = twrench.simulate(BODY, START, np.linspace(0, 20, count), "exact")
    return Recording(motion.t, motion.omega, motion.X)


def test_frames_show_the_recording():
    scene = Scene(body=BODY, motion=recorded(), size=SIZE)
    free = Scene(body=BODY, omega=START, method="exact", size=SIZE, duration=20, speed=1)
    free.title = scene.title
    assert scene.duration == 20 and scene.speed == 1
    for index in (0, 300, 900):
        difference = scene.frame(index).astype(int) - free.frame(index)
        # The reading and the interpolation are not exact, and the count of flips is the same.
        assert np.abs(difference).max() <= 16


def test_the_program_draws_the_same_frames(program, tmp_path):
    file = tmp_path / "run.csv"
    motion = twrench.simulate(BODY, START, np.linspace(0, 20, 401), "exact")
    motion.save(file)
    scene = Scene(body=BODY, motion=Recording.read(file), size=SIZE, compare=["exact"])
    scene.render(frames_dir=tmp_path / "python", frames="0-900:300", progress=False)
    options = ["--inertia", "2,3,4.5", "--motion", file, "--compare", "exact", "--size", "160x90"]
    program("render", *options, "--no-video", "--frames-dir", tmp_path / "program", "--frames", "0-900:300")
    for name in ("frame_000000.png", "frame_000300.png", "frame_000900.png"):
        assert (tmp_path / "python" / name).read_bytes() == (tmp_path / "program" / name).read_bytes()


def test_what_needs_a_free_motion_is_left_out_with_a_warning():
    motion = recorded()
    wrong = Recording(motion.t, np.tile(START, (len(motion), 1)), motion.X)
    with pytest.warns(UserWarning, match="left out: momentum, sphere"):
        scene = Scene(body=BODY, motion=wrong, size=SIZE)
    assert "momentum" not in scene.show and "omega" in scene.show


def test_noise_is_named_and_removed():
    motion = recorded()
    noise = np.random.default_rng(1).normal(scale=0.05, size=motion.omega.shape)
    noisy = Recording(motion.t, motion.omega + noise, motion.X)
    with pytest.warns(UserWarning, match="can be seen: smooth removes it"):
        Scene(body=BODY, motion=noisy, size=SIZE)
    with pytest.warns(UserWarning, match="is smoothed within its noise: 0.05 rad/s"):
        Scene(body=BODY, motion=noisy, smooth=True, size=SIZE)
    for values, complaint in (
        ({"smooth": True}, "smooth: it applies to the recording given as motion"),
        ({"motion": noisy, "smooth": 1}, "smooth: must be True or False, not 1"),
    ):
        with pytest.raises((SceneError, UsageError), match=complaint):
            Scene(body=BODY, size=SIZE, **values)


def test_results_of_the_free_motion_are_refused(tmp_path):
    scene = Scene(body=BODY, motion=recorded(), size=SIZE)
    for refused in (scene.simulate, lambda: scene.report(tmp_path / "a.html")):
        with pytest.raises(UsageError, match="the scene shows a recording|recording that the scene"):
            refused()
    assert list(tmp_path.iterdir()) == []


def test_a_scene_that_shows_a_recording_survives_pickling(toss):
    in_memory = Scene(body=BODY, motion=recorded(), size=SIZE, compare=["exact"])
    for scene in (in_memory, Scene(toss)):
        twin = pickle.loads(pickle.dumps(scene))
        assert twin.to_dict() == scene.to_dict() and twin.duration == scene.duration
        assert (twin.frame(300) == scene.frame(300)).all()
        with pytest.raises(UsageError, match="the scene shows"):
            twin.simulate()
        assert pickle.dumps(twin) == pickle.dumps(pickle.loads(pickle.dumps(twin)))
    (toss.parent / "run.csv").unlink()
    assert pickle.loads(pickle.dumps(twin)).export(toss.parent / "a.csv").exists(), "it has the rows"


TOSS = """title = "A toss"
[body]
moments = [2, 3, 4.5]
[motion]
file = "run.csv"
from = 2
[film]
size = [160, 90]
"""


@pytest.fixture
def toss(tmp_path):
    """A scene file that names a recording beside it."""
    motion = twrench.simulate(BODY, START, np.linspace(0, 20, 401), "exact")
    motion.save(tmp_path / "run.csv")
    (tmp_path / "toss.toml").write_text(TOSS)
    return tmp_path / "toss.toml"


def test_a_scene_file_names_its_recording(toss, program, tmp_path, monkeypatch):
    scene = Scene(toss)
    assert scene.title == "A toss" and scene.duration == 18 and scene.speed == 1
    recording = scene.to_dict()["motion"]["recording"]
    assert recording["file"] == "run.csv" and recording["from"] == 2
    scene.render(frames_dir=tmp_path / "python", frames="300", progress=False)
    options = ["--no-video", "--frames-dir", tmp_path / "program", "--frames", "300"]
    program("render", toss, *options)
    frame = "frame_000300.png"
    assert (tmp_path / "python" / frame).read_bytes() == (tmp_path / "program" / frame).read_bytes()
    with pytest.raises(twrench.OverwriteError, match="is an input"):
        scene.export(tmp_path / "run.csv", overwrite=True)
    monkeypatch.chdir(tmp_path)
    text = Scene.from_toml(TOSS)
    assert text.to_dict() == scene.to_dict()
    assert Scene(toss, duration=3).duration == 3
    other = Scene(toss, motion=recorded())
    assert other.duration == 20 and "from" not in other.to_dict()["motion"]["recording"]


@pytest.mark.parametrize("value", [{"omega": START}, {"method": "exact"}])
def test_a_recording_excludes_what_computes_a_motion(toss, value):
    for make in (lambda: Scene(toss, **value), lambda: Scene(body=BODY, motion=recorded(), **value)):
        with pytest.raises(UsageError, match=f"^{next(iter(value))}: the motion of the scene is recorded"):
            make()
    for scene in (Scene(toss), Scene(body=BODY, motion=recorded())):
        before = scene.to_dict()
        with pytest.raises(UsageError, match=f"^{next(iter(value))}: the motion of the scene is recorded"):
            setattr(scene, *next(iter(value.items())))
        assert scene.to_dict() == before


def test_results_of_a_recording_that_a_file_names_are_refused(toss, tmp_path):
    for refused in (Scene(toss).simulate, lambda: twrench.report(tmp_path / "a.md", [toss])):
        with pytest.raises(UsageError, match="recording that the scene shows"):
            refused()
    (tmp_path / "run.csv").unlink()
    with pytest.raises(twrench.FileError, match="run.csv: No such file"):
        Scene(toss)


def test_exports_for_numpy_are_those_of_python(toss, program, tmp_path):
    program("simulate", "tennis-racket", "--method", "rk4", "--fps", "50", "-o", tmp_path / "a.npz")
    racket = Scene("tennis-racket", method="rk4")
    motion = racket.simulate(span=(0, racket.duration), fps=50)
    motion.save(tmp_path / "b.npz")
    with np.load(tmp_path / "a.npz") as ours, np.load(tmp_path / "b.npz") as theirs:
        assert ours.files == theirs.files
        for name in ours.files:
            assert ours[name].shape == theirs[name].shape and ours[name].dtype == theirs[name].dtype
            np.testing.assert_allclose(ours[name], theirs[name], rtol=0, atol=1e-9, err_msg=name)
    program("export", toss, "--fps", "20", "-o", tmp_path / "c.npz")
    file = Scene(toss).export(tmp_path / "d.npz")
    with np.load(tmp_path / "c.npz") as rows:
        assert rows["X"].shape == (361, 3, 3) and rows["t"][-1] == 18
        sample = twrench.exact(BODY, START).at(2 + rows["t"])
        # The first attitude of the film is the recorded one, and so are the others.
        np.testing.assert_allclose(rows["X"], sample.X, rtol=0, atol=1e-6)
    assert twrench.check(file, BODY).verdict.startswith(("follows", "has no detectable", "off by up"))


ROWS = np.array([[0, 0, 0, 0, 1, 1, 0, 0], [1, 0, 0, 0, 1, 1, 0, 0]], dtype=float)


@pytest.mark.parametrize(
    ("index", "value"),
    [
        (2, ROWS[:1]),
        (2, ROWS[::-1]),
        (2, ROWS + [0, 0, 0, 0, 1e-3, 0, 0, 0]),
        (2, ROWS + [0, 0, 0, 0, 0, 0, 0, np.inf]),
        (2, ROWS[:, :7]),
        (3, 0.0),
        (3, np.nan),
        (4, "flips"),
        (9, None),
    ],
)
def test_a_hostile_pickle_of_a_recording_is_refused(index, value):
    state = Scene(body=BODY, motion=recorded()).__getstate__()["_native"]
    scene, original = state
    shown = list(scene[8])
    shown[index] = value
    damaged = (*scene[:8], tuple(shown), scene[9])
    with pytest.raises(UsageError, match="the pickled scene: is damaged"):
        Scene().__setstate__({"_native": (damaged, original)})
    for named in ((b"[]", "a"), (b'{"file": 1}', "a"), (b'{"file": "a", "from": "b"}', "a"), ("", "")):
        damaged = (*scene[:9], named)
        with pytest.raises(UsageError, match="the pickled scene: is damaged"):
            Scene().__setstate__({"_native": (damaged, original)})


def test_pages_and_plots_show_the_exact_motion_beside_it(tmp_path):
    scene = Scene(body=BODY, motion=recorded(), size=SIZE)
    template = tmp_path / "t.html"
    template.write_text("{{title}}{{title}}<!-- twrench:poster --><!-- twrench:scene -->")
    html = scene.page(tmp_path / "a.html", lab=True, template=template).read_text()
    assert '"recording":{"file":' in html
    pytest.importorskip("matplotlib")
    panels = scene.plot().axes
    assert len(panels) == 9
    for panel in panels:
        shown, exact = (line for line in panel.lines if len(line.get_xdata()) > 2)
        assert exact.get_linestyle() == "--"
        assert np.abs(shown.get_ydata() - exact.get_ydata()).max() < 1e-6


def test_a_film_may_not_be_longer_than_the_recording():
    scene = Scene(body=BODY, motion=recorded(), size=SIZE)
    scene.duration = 21
    with pytest.raises(UsageError, match="it lasts 20 s, but 21 s are to be shown"):
        scene.frame(0)
    with pytest.raises(UsageError, match="motion: must be a"):
        Scene(body=BODY, motion="run.csv")


def test_export_is_a_converter(tmp_path):
    scene = Scene(body=BODY, motion=recorded())
    for name in ("a.csv", "a.json", "a.aem"):
        file = scene.export(tmp_path / name)
        assert twrench.check(file, BODY).verdict.startswith(("follows", "has no detectable", "off by up"))
    assert scene.export(tmp_path / "a.glb").stat().st_size > 1000
