"""Films with sound."""

from __future__ import annotations

import copy
import pickle
import subprocess

import pytest

import twrench
from sound_files import write_sound
from twrench import FileError, Scene, UsageError

SMALL = {"size": (32, 32), "fps": 10, "speed": 1, "duration": 2}


def stream_of(video, properties):
    return subprocess.run(
        ["ffprobe", "-v", "error", "-select_streams", "a", "-of", "csv=p=0"]
        + ["-show_entries", f"stream={properties}", str(video)],
        check=True,
        capture_output=True,
        text=True,
    ).stdout.strip()


def test_a_scene_has_the_sound_of_its_motion(tmp_path):
    scene = Scene(sound="motion", **SMALL)
    assert scene.sound == "motion" and scene.audio is None
    scene.render(tmp_path / "film.mp4", progress=False)
    assert stream_of(tmp_path / "film.mp4", "codec_name,channels") == "aac,2"
    scene.sound = "none"
    scene.render(tmp_path / "silent.mp4", progress=False)
    assert stream_of(tmp_path / "silent.mp4", "codec_name") == ""


def test_a_scene_has_a_sound_file(tmp_path):
    write_sound(tmp_path / "tone.wav", 1)
    scene = Scene(audio=tmp_path / "tone.wav", **SMALL)
    assert scene.audio == str(tmp_path / "tone.wav")
    for same in (pickle.loads(pickle.dumps(scene)), copy.deepcopy(scene)):
        same.render(tmp_path / "film.webm", overwrite=True, progress=False)
        assert stream_of(tmp_path / "film.webm", "codec_name") == "opus"
    with pytest.raises(UsageError, match="GIF has no sound"):
        scene.render(tmp_path / "film.gif", progress=False)
    with pytest.raises(twrench.OverwriteError, match="input of this command"):
        scene.render(tmp_path / "tone.wav", container="mp4", progress=False)
    scene.audio = None
    assert scene.audio is None
    with pytest.raises(FileError, match="No such file"):
        Scene(audio="none.wav", **SMALL).render(tmp_path / "none.mp4", progress=False)


def test_the_files_of_a_scene_are_beside_it(tmp_path):
    write_sound(tmp_path / "1.wav", 1.5)
    (tmp_path / "scene.toml").write_text(
        '[body]\nmoments = [3, 5, 7]\n[film]\naudio = "1.wav"\nsize = [32, 32]\nfps = 10\n'
        '[[shot]]\nlength = 1\nnarration = "1.wav"\n[[shot]]\nlength = 1\n'
    )
    scene = pickle.loads(pickle.dumps(Scene(tmp_path / "scene.toml")))
    with pytest.warns(UserWarning, match=r"shot\[0\].narration: 1.wav lasts 1.50 s"):
        scene.render(tmp_path / "film.mp4", progress=False)
    assert stream_of(tmp_path / "film.mp4", "codec_name") == "aac"


def test_frames_are_encoded_with_a_sound_file(tmp_path):
    write_sound(tmp_path / "tone.wav", 1)
    Scene(sound="motion", **SMALL).render(frames_dir=tmp_path / "frames", progress=False)
    film = tmp_path / "film.mp4"
    with pytest.raises(UsageError, match="the scene has sound"):
        twrench.encode(tmp_path / "frames", film, progress=False)
    with pytest.raises(UsageError, match="sound: must be 'none' or None"):
        twrench.encode(tmp_path / "frames", film, sound="motion", progress=False)
    twrench.encode(tmp_path / "frames", film, sound="none", progress=False)
    assert stream_of(film, "codec_name") == ""
    twrench.encode(
        tmp_path / "frames", film, audio=tmp_path / "tone.wav", overwrite=True, progress=False
    )
    assert stream_of(film, "codec_name") == "aac"
