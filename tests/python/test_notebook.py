"""Scenes and films in notebooks."""

from __future__ import annotations

import html
import re
import sys
import types

import pytest

import twrench
from twrench import Scene


def test_a_scene_shows_its_page_in_a_sandboxed_frame(small, monkeypatch):
    page = "<html><p>\"Turn\" & <b>scrub</b></p></html>"
    monkeypatch.setattr(Scene, "_page", lambda scene, template, has_article: types.SimpleNamespace(html=page))
    shown = small._repr_html_()
    assert re.match(r'<iframe sandbox="allow-scripts" allow="clipboard-write" ', shown)
    assert html.unescape(re.search('srcdoc="([^"]*)"', shown)[1]) == page
    assert "allow-same-origin" not in shown
    page = "x" * 1_000_001
    assert small._repr_html_() is None


@pytest.fixture(scope="module")
def _page(tmp_path_factory):
    try:
        Scene().page(tmp_path_factory.mktemp("page") / "page.html")
    except twrench.FileError:
        pytest.skip("this build has no page")


@pytest.mark.parametrize("name", twrench.scenes())
@pytest.mark.usefixtures("_page")
def test_the_page_of_a_notebook_is_offline_and_small(name):
    shown = Scene(name)._repr_html_()
    if shown is None:
        pytest.fail(f"{name} is shown as a picture")
    assert len(shown) < 1_000_000
    assert "default-src 'none'" in html.unescape(shown)


def test_a_scene_is_also_a_picture(small):
    assert small._repr_png_().startswith(b"\x89PNG")


def test_a_picture_of_a_time(small):
    picture = small.picture(7.1)
    assert isinstance(picture, twrench.Picture)
    assert picture.png == picture._repr_png_() == small.png(7)


class Bar:
    """A substitute for the bar of tqdm that records its updates."""

    last: Bar

    def __init__(self, unit: str) -> None:
        self.total, self.n, self.is_closed, self.unit = 0, 0, False, unit
        Bar.last = self

    def update(self, more: int) -> None:
        self.n += more

    def __enter__(self) -> Bar:
        return self

    def __exit__(self, *_: object) -> None:
        self.is_closed = True


def test_a_render_shows_a_bar_of_tqdm(small, monkeypatch, tmp_path):
    monkeypatch.setitem(sys.modules, "tqdm", types.ModuleType("tqdm"))
    monkeypatch.setitem(sys.modules, "tqdm.auto", types.SimpleNamespace(tqdm=Bar))
    small.render(frames_dir=tmp_path / "a", frames="0-3")
    bar = Bar.last
    assert (bar.total, bar.n, bar.is_closed, bar.unit) == (4, 4, True, "frame")
    small.render(frames_dir=tmp_path / "b", frames="0-3", progress=False)
    assert Bar.last is bar
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    small.render(frames_dir=tmp_path / "c", frames="0-3")


def test_motions_bodies_and_studies_are_tables():
    body = twrench.Body([twrench.Sphere(radius=1, mass=3)])
    assert "<th" in body._repr_html_() and ">3 g<" in body._repr_html_()
    assert "mass" not in twrench.Body(moments=[1, 2, 3])._repr_html_()
    motion = twrench.simulate(body, [1, 0, 0], [0, 2], "rk4", step=0.1)
    assert ">2 samples from 0 to 2 s<" in motion._repr_html_() and ">rk4<" in motion._repr_html_()
    assert ">one sample at 2 s<" in motion[1]._repr_html_()
    assert ">no samples<" in motion[:0]._repr_html_()
    result = twrench.study(twrench.Body(moments=[1, 2, 3]), [0.1, 1, 0], ["rk4", "exact"], duration=2)
    shown = result._repr_html_()
    assert shown.count("<tr>") == 3 and ">rk4<" in shown
    assert f">{result.methods['rk4'].order:.2f}<" in shown
    for table in (body, motion, result):
        assert re.fullmatch(r"<table>.*</table>", table._repr_html_())


def test_a_table_shows_the_failure_of_a_method():
    result = twrench.study(
        twrench.Body(moments=[1, 2, 3]), [0.1, 1, 0], ["rk4"], duration=100, steps=[50, 25]
    )
    assert html.escape(result.methods["rk4"].runs[0].failure) in result._repr_html_()
