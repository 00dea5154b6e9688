from __future__ import annotations

import json
import os
import signal
import stat
import subprocess
import sys
import time
from pathlib import Path

import pytest

import twrench


def frame_names(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.glob("frame_*.png"))


def recorded(folder: Path) -> list[str]:
    manifest = json.loads((folder / "manifest.json").read_text())
    return sorted(frame["file"] for frame in manifest["frames"])


def probed_frames(film: Path) -> int:
    command = ["ffprobe", "-v", "error", "-select_streams", "v:0", "-count_frames",
               "-show_entries", "stream=nb_read_frames", "-of", "csv=p=0", str(film)]  # fmt: skip
    return int(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


def test_a_film_and_its_frames(small, program, tmp_path):
    told: list[tuple[int, int]] = []
    film = small.render(
        tmp_path / "a.mp4", frames_dir=tmp_path / "a", progress=lambda *done: told.append(done)
    )
    assert told == [(i, 24) for i in range(1, 25)]
    assert film.frame_count == 24 and film.path == tmp_path / "a.mp4"
    assert probed_frames(tmp_path / "a.mp4") == 24
    size = ["--size", "160x90", "--duration", 24, "--fps", 6, "--speed", 6, "--progress", "none"]
    program("render", *size, "-o", tmp_path / "b.mp4", "--frames-dir", tmp_path / "b")
    assert (tmp_path / "a.mp4").read_bytes() == (tmp_path / "b.mp4").read_bytes()
    for name in [*frame_names(tmp_path / "b"), "manifest.json"]:
        assert (tmp_path / "a" / name).read_bytes() == (tmp_path / "b" / name).read_bytes()
    assert json.loads((tmp_path / "a/manifest.json").read_text())["version"] == twrench.__version__
    html = film._repr_html_()
    assert html is not None and html.startswith("<video controls") and "data:video/mp4" in html


def test_parts_of_a_film(small, tmp_path):
    assert small.render(frames_dir=tmp_path / "f", frames=[3, 5]).frame_count == 2
    assert frame_names(tmp_path / "f") == ["frame_000003.png", "frame_000005.png"]
    small.render(frames_dir=tmp_path / "f", frames="4-6", resume=True)
    assert recorded(tmp_path / "f") == [f"frame_00000{i}.png" for i in (3, 4, 5, 6)]
    film = small.render(tmp_path / "f.webm", frames="0-3", jobs=1, backend="auto")
    assert film.frames_dir is None and "data:video/webm" in (film._repr_html_() or "")
    assert twrench.Film(None, tmp_path, 1)._repr_html_() is None
    small.render(tmp_path / "no-ending", container="mkv", frames=range(2))
    assert probed_frames(tmp_path / "no-ending") == 2


def test_a_film_has_chapters_unless_it_should_not(small, tmp_path):
    small.render(tmp_path / "f.mp4")
    assert "flip 1 at 11.8 s" in (tmp_path / "f.chapters.vtt").read_text()
    small.render(tmp_path / "f.mp4", chapters=False)
    assert not (tmp_path / "f.chapters.vtt").exists()


def test_a_film_in_a_chosen_quality(small, tmp_path):
    sizes = {}
    for effort in twrench._native.effort_names():
        small.render(tmp_path / f"{effort}.mp4", frames_dir=tmp_path / "f", encode=effort)
        sizes[effort] = (tmp_path / f"{effort}.mp4").stat().st_size
        manifest = json.loads((tmp_path / "f/manifest.json").read_text())
        assert manifest["encode"] == effort
    assert sizes["small"] < sizes["balanced"] < sizes["fast"]
    twrench.encode(tmp_path / "f", tmp_path / "again.mp4", encode="small")
    assert (tmp_path / "again.mp4").read_bytes() == (tmp_path / "small.mp4").read_bytes()
    twrench.encode(tmp_path / "f", tmp_path / "rough.mp4", encode="small", crf=40)
    assert (tmp_path / "rough.mp4").stat().st_size < sizes["small"]
    with pytest.raises(twrench.UsageError, match="crf 40: the encoder gif"):
        twrench.encode(tmp_path / "f", tmp_path / "rough.gif", crf=40)


def test_the_document_names_each_container():
    names = twrench._native.container_names()
    assert "mp4" in names
    document = twrench.Scene.render.__doc__ or ""
    for name in names:
        assert f".{name}" in document and f" {name}" in document, name


def test_an_animated_image(small, tmp_path):
    for name in ("f.gif", "f.webp"):
        film = small.render(tmp_path / name, frames="0-3")
        assert name == "f.webp" or probed_frames(tmp_path / name) == 4
        kind = name[2:]
        assert (film._repr_html_() or "").startswith("<img ") and f"image/{kind}" in film._repr_html_()
    assert sorted(path.name for path in tmp_path.iterdir()) == ["f.gif", "f.webp"]


def test_a_transparent_film_needs_a_container_that_keeps_alpha(small, tmp_path):
    small.background = "transparent"
    for name in ("f.mp4", "f.mkv"):
        with pytest.raises(twrench.UsageError, match="cannot keep a transparent background") as error:
            small.render(tmp_path / name, frames_dir=tmp_path / "f", frames="0-1")
        assert ".mov or .webm" in str(error.value)
    assert list(tmp_path.iterdir()) == []
    small.render(tmp_path / "f.webm", frames="0-1")
    assert probed_frames(tmp_path / "f.webm") == 2


def test_nothing_of_another_film_is_overwritten(small, tmp_path):
    small.render(tmp_path / "f.mp4", frames_dir=tmp_path / "f", frames="0-1")
    before = (tmp_path / "f.mp4").read_bytes(), (tmp_path / "f/frame_000000.png").read_bytes()
    small.theme = "paper"
    for where in ({"path": tmp_path / "f.mp4"}, {"frames_dir": tmp_path / "f"}):
        for resume in (False, True):
            instead = " instead of resume=True" if resume and "path" in where else ""
            with pytest.raises(twrench.OverwriteError, match="overwrite=True" + instead):
                small.render(**where, frames="0-1", resume=resume)
    after = (tmp_path / "f.mp4").read_bytes(), (tmp_path / "f/frame_000000.png").read_bytes()
    assert before == after
    small.render(tmp_path / "f.mp4", frames_dir=tmp_path / "f", frames="0-1", overwrite=True)
    assert (tmp_path / "f/frame_000000.png").read_bytes() != before[1]


def test_an_input_is_no_output(tmp_path):
    file = tmp_path / "mine.mp4"  # under any name
    file.write_text("[body]\nmoments = [1, 2, 3]\n[film]\nsize = [64, 48]\n")
    (tmp_path / "mine.toml").symlink_to(file)
    scene = twrench.Scene(tmp_path / "mine.toml")
    with pytest.raises(twrench.OverwriteError):
        scene.render(file, overwrite=True)
    assert file.read_text().startswith("[body]")


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ({}, twrench.UsageError, "path, frames_dir or both"),
        ({"path": 3}, twrench.UsageError, "path: must be a path"),
        ({"path": b"f.mp4"}, twrench.UsageError, "path: must be a path"),
        ({"path": "f.apng"}, twrench.UsageError, "apng"),
        ({"path": "f"}, twrench.UsageError, "f"),
        ({"path": "f.mp4", "container": "xyz"}, twrench.UsageError, "xyz"),
        ({"path": "f.mp4", "container": 3}, twrench.UsageError, "container: must be a string"),
        ({"path": "f.mp4", "encode": "smal"}, twrench.UsageError, "did you mean 'small'"),
        ({"path": "f.mp4", "encode": 3}, twrench.UsageError, "encode: must be a string"),
        ({"path": "f.mp4", "crf": 52}, twrench.UsageError, "crf 52: .* accepts 0 to 51"),
        ({"path": "f.mp4", "crf": -1}, twrench.UsageError, "crf: must be from 0"),
        ({"path": "f.mp4", "crf": 17.5}, twrench.UsageError, "crf: must be an integer"),
        ({"path": "f.gif", "crf": 20}, twrench.UsageError, "gif has no such setting"),
        ({"frames_dir": "f", "encode": "fast"}, twrench.UsageError, "no video is written"),
        ({"path": "f.mp4", "frames": "9-"}, twrench.UsageError, "9-"),
        ({"path": "f.mp4", "frames": "0-24"}, twrench.UsageError, "24"),
        ({"path": "f.mp4", "frames": ""}, twrench.UsageError, "frames: must be a range"),
        ({"path": "f.mp4", "frames": []}, twrench.UsageError, "frames: must name"),
        ({"path": "f.mp4", "frames": [1.5]}, twrench.UsageError, "frames: must be an integer"),
        ({"path": "f.mp4", "frames": 3}, twrench.UsageError, "frames: must be integers"),
        ({"path": "f.mp4", "frames": [-1]}, twrench.UsageError, "frames: must be from 0"),
        ({"path": "f.mp4", "jobs": 0}, twrench.UsageError, "jobs: must be from 1 to 256"),
        ({"path": "f.mp4", "jobs": "2"}, twrench.UsageError, "jobs: must be an integer"),
        ({"path": "f.mp4", "backend": "vulkan"}, twrench.UsageError, "backend: 'vulkan'"),
        ({"path": "f.mp4", "progress": 3}, twrench.UsageError, "progress: must be a function"),
        ({"path": "f.mp4", "resume": True, "overwrite": True}, twrench.UsageError, "give one"),
        ({"frames_dir": "/proc/twrench"}, twrench.FileError, "/proc/twrench"),
        ({"path": "/proc/twrench/f.mp4"}, twrench.FileError, "/proc/twrench"),
    ],
)
def test_wrong_arguments_leave_nothing_behind(small, tmp_path, monkeypatch, arguments, error, message):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(error, match=message) as raised:
        small.render(**arguments)
    assert "--" not in str(raised.value)
    assert list(tmp_path.iterdir()) == []


def test_odd_sizes_have_frames_but_no_video(tmp_path):
    scene = twrench.Scene(size=(161, 91), duration=1, speed=6, fps=6)
    with pytest.raises(twrench.SceneError, match=r"size=\(162, 92\)"):
        scene.render(tmp_path / "f.mp4")
    scene.render(frames_dir=tmp_path / "f")


def test_without_ffmpeg(small, tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(twrench.EncoderError, match="ffmpeg"):
        small.render(tmp_path / "f.mp4")
    assert list(tmp_path.iterdir()) == []
    small.render(frames_dir=tmp_path / "f", frames="0")  # frames alone need no ffmpeg


def test_without_opengl(tmp_path):
    """Both libraries are hidden, in a separate process, because they stay loaded."""
    code = (
        "import twrench\n"
        "try: twrench.Scene(size=(64, 48)).frame(0)\n"
        "except twrench.GlError as error: print(error)\n"
    )
    # Mesa cannot draw at all if it cannot load a driver.
    hidden = {"EGL_PLATFORM": "none", "__EGL_VENDOR_LIBRARY_FILENAMES": "/dev/null",
              "LIBGL_DRIVERS_PATH": "/nonexistent", "GALLIUM_DRIVER": "none"}  # fmt: skip
    command = [sys.executable, "-c", code.replace("frame(0)", "render(frames_dir='f', backend='egl')")]
    result = subprocess.run(
        command, env=os.environ | hidden, cwd=tmp_path, capture_output=True, text=True
    )
    assert result.returncode == 0 and "EGL" in result.stdout
    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write anywhere")
def test_a_folder_that_cannot_be_written(small, tmp_path):
    tmp_path.chmod(stat.S_IRUSR | stat.S_IXUSR)
    with pytest.raises(twrench.FileError):
        small.render(tmp_path / "f.mp4")


def test_a_deleted_working_folder(small, tmp_path, monkeypatch):
    gone = tmp_path / "gone"
    gone.mkdir()
    monkeypatch.chdir(gone)
    gone.rmdir()
    with pytest.raises(twrench.FileError):
        small.render("f.mp4", frames="0-1")
    with pytest.raises(twrench.FileError):
        small.render(frames_dir="f", frames="0-1")


class Enough(Exception):
    pass


def test_an_exception_of_the_callback_ends_the_run_whole(small, tmp_path):
    def progress(done: int, total: int) -> None:
        if done == 5:
            raise Enough(f"{done} of {total}")

    with pytest.raises(Enough, match="5 of 24"):
        small.render(tmp_path / "f.mp4", frames_dir=tmp_path / "f", progress=progress)
    assert not (tmp_path / "f.mp4").exists() and len(list(tmp_path.iterdir())) == 1
    assert recorded(tmp_path / "f") == frame_names(tmp_path / "f") != []
    small.render(tmp_path / "f.mp4", frames_dir=tmp_path / "f", resume=True)
    assert len(frame_names(tmp_path / "f")) == 24 and probed_frames(tmp_path / "f.mp4") == 24


INTERRUPTED = """
import twrench
scene = twrench.Scene(size=(320, 180), duration=960)  # longer than the longest delay
try:
    print("begun", flush=True)
    scene.render("f.mp4", frames_dir="f")
except KeyboardInterrupt:
    print("interrupted", flush=True)
print(scene.frame(0).shape, flush=True)  # and all goes on
"""


@pytest.mark.parametrize("delay", [0, 0.02, 0.05, 0.1, 0.2, 0.4, 0.6, 0.8, 1.2, 1.6])
def test_control_c_leaves_whole_frames(tmp_path, delay):
    child = subprocess.Popen(
        [sys.executable, "-c", INTERRUPTED], cwd=tmp_path, stdout=subprocess.PIPE, text=True
    )
    assert child.stdout is not None and child.stdout.readline() == "begun\n"
    time.sleep(delay + 0.02)
    os.kill(child.pid, signal.SIGINT)
    out, _ = child.communicate(timeout=60)
    assert out == "interrupted\n(180, 320, 3)\n" and child.returncode == 0
    left = {path.name for path in tmp_path.iterdir()}
    assert left <= {"f"}
    if (tmp_path / "f" / "manifest.json").exists():
        assert recorded(tmp_path / "f") == frame_names(tmp_path / "f")
    elif left:
        assert frame_names(tmp_path / "f") == []


HANGING_FFMPEG = """#!/bin/sh
case "$*" in
  *"-f null"*) cat >/dev/null ;;
  *) sleep 1000 ;;
esac
"""


def test_control_c_is_heard_while_ffmpeg_hangs(tmp_path):
    stub = tmp_path / "bin" / "ffmpeg"
    stub.parent.mkdir()
    stub.write_text(HANGING_FFMPEG)
    stub.chmod(0o755)
    child = subprocess.Popen(
        [sys.executable, "-c", INTERRUPTED],
        cwd=tmp_path,
        env=os.environ | {"PATH": f"{stub.parent}:{os.environ['PATH']}"},
        stdout=subprocess.PIPE,
        text=True,
    )
    assert child.stdout is not None and child.stdout.readline() == "begun\n"
    frames = -1  # the number of frames grows until the pipe to ffmpeg is full
    while (now := len(list(tmp_path.glob("f/*.png")))) == 0 or now != frames:
        frames = now
        time.sleep(1)
    os.kill(child.pid, signal.SIGINT)
    out, _ = child.communicate(timeout=40)  # the program waits up to 60 s for ffmpeg
    assert out == "interrupted\n(180, 320, 3)\n" and child.returncode == 0
    assert recorded(tmp_path / "f") == frame_names(tmp_path / "f") != []
    assert {path.name for path in tmp_path.iterdir()} == {"bin", "f"}


def test_two_films_at_once_in_two_threads(tmp_path):
    from concurrent.futures import ThreadPoolExecutor

    def render(name: str) -> int:
        scene = twrench.Scene(size=(160, 90), duration=24, fps=6, speed=6)
        return scene.render(tmp_path / f"{name}.mp4", frames_dir=tmp_path / name).frame_count

    with ThreadPoolExecutor(2) as pool:
        assert list(pool.map(render, ["a", "b"])) == [24, 24]
    assert (tmp_path / "a.mp4").read_bytes() == (tmp_path / "b.mp4").read_bytes()
    with ThreadPoolExecutor(2) as pool:
        # Both use one folder at once: one of them is rejected, or waits until the other has ended.
        results = [pool.submit(render, "c") for _ in range(2)]
        failures = [result.exception() for result in results if result.exception()]
    assert all(isinstance(failure, twrench.FileError) for failure in failures)
    assert len(failures) < 2 and probed_frames(tmp_path / "c.mp4") == 24


def test_shards_draw_the_film_together(small, tmp_path):
    folder = tmp_path / "frames"
    for i in (1, 2, 3):
        assert small.render(frames_dir=folder, shard=(i, 3)).frame_count == 8
    assert twrench.encode(folder, tmp_path / "parts.mp4").frame_count == 24
    small.render(tmp_path / "whole.mp4")
    assert (tmp_path / "parts.mp4").read_bytes() == (tmp_path / "whole.mp4").read_bytes()
    for shard in ((0, 3), (4, 3), (1, 2, 3), "1/3", 1, (1.0, 3), (1, 10**6)):
        with pytest.raises(twrench.UsageError, match="^shard"):
            small.render(frames_dir=tmp_path / "no", shard=shard)
    with pytest.raises(twrench.UsageError, match="^shard: .* leave out path"):
        small.render(tmp_path / "no.mp4", frames_dir=tmp_path / "no", shard=(1, 2))
    assert not (tmp_path / "no").exists()


def test_an_egl_device_is_chosen_by_its_number_or_as_software(small, tmp_path):
    for device in (-1, 1.5, True):
        with pytest.raises(twrench.UsageError, match="^egl_device"):
            small.render(frames_dir=tmp_path / "no", egl_device=device)
    with pytest.raises(twrench.UsageError, match="^egl_device: OSMesa has none"):
        small.render(frames_dir=tmp_path / "no", backend="osmesa", egl_device=0)
    with pytest.raises(twrench.Error, match="99"):
        small.render(frames_dir=tmp_path / "no", frames=[0], egl_device=99)
    try:
        film = small.render(frames_dir=tmp_path / "software", frames=[0], egl_device="software")
    except twrench.GlError:
        return  # this machine has no EGL in software
    assert film.frame_count == 1
