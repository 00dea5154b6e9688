"""Films with shots."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import twrench
from twrench import Scene, SceneError

STORY = """
[body]
moments = [3, 4, 5]
[motion]
omega = [0.05, 1, 0]
method = "exact"
duration = 4
[film]
size = [192, 168]
fps = 5
speed = 2
[[shot]]
length = 1
caption = "One"
[[shot]]
length = 2
fade = 0.6
caption = "Two"
speed = [[0, 2], [1, 0]]
[shot.overlay]
show = ["omega"]
"""


def test_a_built_in_story_has_captions_in_another_language():
    assert Scene("explain", language="nb").title == Scene("explain-nb").title == "Hvorfor det snur"
    assert Scene("explain-nb", language="en").name == "explain"
    assert Scene("explain", language="nb").language == "nb"
    with pytest.raises(SceneError, match="^language: explain is not told in 'de'"):
        Scene("explain", language="de")
    with pytest.raises(SceneError, match="^language: 'deutsch' is not the tag of a language"):
        Scene("dzhanibekov", language="deutsch")
    assert Scene("dzhanibekov", language="pt-BR").language == "pt-BR"
    with pytest.raises(SceneError, match="^language: explain-short is not told in 'nb'"):
        Scene("explain-short", language="nb")
    with pytest.raises(twrench.UsageError, match="language: must be a string"):
        Scene("explain", language=1)  # type: ignore[arg-type]


def test_the_words_of_the_picture_are_in_the_language_of_the_scene():
    scene = Scene("dzhanibekov", size=(640, 360))
    english = scene.frame(0)
    scene.language = "nb"
    assert (scene.frame(0) != english).any()
    assert scene.language == "nb"


@pytest.fixture
def story() -> Scene:
    return Scene.from_toml(STORY, "story")


def test_times_are_those_that_the_frames_show(story):
    assert story.frame_count == 15
    np.testing.assert_allclose(story.times[:6], [0, 0.4, 0.8, 1.2, 1.6, 2], atol=1e-15)
    assert (story.times[10:] == 3).all()
    np.testing.assert_array_equal(story.simulate().t, np.arange(10) * 2 / 5)


def test_frames_are_those_of_the_program(story, program, tmp_path):
    Image = pytest.importorskip("PIL.Image")
    file = tmp_path / "story.toml"
    file.write_text(STORY)
    program("render", file, "--no-video", "--frames-dir", tmp_path / "f", "--progress", "none")
    for index in (0, 6, 14, 7, 1):
        png = tmp_path / "f" / f"frame_{index:06d}.png"
        np.testing.assert_array_equal(story.frame(index), np.asarray(Image.open(png)))
    with pytest.raises(twrench.UsageError, match="time: a film with shots may show it twice"):
        story.frame(time=1)


def test_values_are_set_in_all_shots(story):
    before = story.frame(12)
    story.theme = "paper"
    assert (story.frame(12) != before).mean() > 0.5
    assert "look" not in story.to_dict()["shot"][1]
    for key, value in {"omega": (1, 2, 3), "duration": 3, "speed": 2}.items():
        with pytest.raises(SceneError, match="each shot of story has its own"):
            setattr(story, key, value)
    with pytest.raises(SceneError, match="each shot of story has its own"):
        story.body = twrench.Body(moments=(1, 2, 3))


def test_captions_are_written_beside_the_film(story, tmp_path: Path):
    story.render(tmp_path / "film.mp4")
    text = (tmp_path / "film.vtt").read_text()
    assert "00:00:00.000 --> 00:00:01.000\nOne\n" in text
    assert "00:00:01.000 --> 00:00:03.000\nTwo\n" in text
    (tmp_path / "film.vtt").write_text("WEBVTT\n\nanother\n")
    with pytest.raises(twrench.OverwriteError, match="film.vtt"):
        story.render(tmp_path / "film.mp4")


def test_mistakes_name_the_shot():
    with pytest.raises(SceneError, match=r"story:13: shot\[0\].length: is 0"):
        Scene.from_toml(STORY.replace("length = 1", "length = 0"), "story")
