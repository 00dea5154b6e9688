"""A folder with the pages of all built-in scenes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from . import _arguments, _native
from .names import StrPath
from .scene import Scene, scenes

__all__ = ["pages"]


def pages(
    folder: StrPath,
    *,
    template: StrPath | None = None,
    overwrite: bool = False,
    **values: Any,
) -> Path:
    """Writes the pages of all built-in scenes and an index, as ``twrench page --all`` does.

    :param folder: the folder of the files, which is created if it is missing.
    :param template: the page without a scene, as in :meth:`Scene.page`.
    :param overwrite: replace existing files that twrench did not write, or that are of another kind.
    :param values: values that replace those of each scene, as in :class:`Scene`.
    :returns: the path of the index, ``index.html`` in the folder.
    :raises UsageError: for values that a page cannot show; then nothing is written.
    :raises FileError: if a file cannot be written, or this build has no page.
    :raises OverwriteError: if another file would be replaced.
    """
    place = Path(_arguments.path("folder", folder))
    source = "" if template is None else _arguments.path("template", template)
    inputs = [Path(source)] if source else []

    def output(kind: str, name: str) -> _native.Output:
        return _native.Output(kind, place / name, inputs, bool(overwrite), "")

    index = output("index", "index.html")
    outputs, entries = [], []
    for name in scenes():
        scene = Scene(name, **values)
        file = output("page", f"{name}.html")
        page = scene._page(source, has_article=True)
        outputs.append((file, page.html))
        native = scene._native
        entries.append((file.path.name, native.shown_title, page.summary, page.poster))
    outputs.append((index, _native.site_html(entries)))
    _native.make_folder(place)
    for file, text in outputs:
        _native.write_output(file, text.encode("utf-8"))
    return index.path
