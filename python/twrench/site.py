"""A folder with the pages of all built-in scenes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from . import _arguments, _native
from .names import StrPath
from .scene import Scene, scenes

__all__ = ["pages"]


def pages(folder: StrPath, *, template: StrPath | None = None, **values: Any) -> Path:
    """Writes the pages of all built-in scenes and an index, as ``twrench page --all`` does.

    :param folder: the folder of the files, which is created if it is missing.
    :param template: the page without a scene, as in :meth:`Scene.page`.
    :param values: values that replace those of each scene, as in :class:`Scene`.
    :returns: the path of the index, ``index.html`` in the folder.
    :raises UsageError: for values that a page cannot show; then nothing is written.
    :raises FileError: if a file cannot be written, or this build has no page.
    """
    place = Path(_arguments.path("folder", folder))
    source = "" if template is None else _arguments.path("template", template)
    index, texts, entries = place / "index.html", {}, []
    for name in scenes():
        scene = Scene(name, **values)
        page = scene._page(source, has_article=True)
        file = place / f"{name}.html"
        texts[file] = page.html
        native = scene._native
        entries.append((file.name, native.shown_title, page.summary, page.poster))
    texts[index] = _native.site_html(entries)
    _native.make_folder(place)
    for file, text in texts.items():
        if source:
            _native.require_not_input(file, Path(source))
        _native.write_file(file, text.encode("utf-8"))
    return index
