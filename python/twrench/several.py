"""Plots and reports of several scenes."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Sequence

from . import _arguments, _native
from .errors import UsageError
from .names import LanguageName, StrPath
from .scene import UNSET, Scene, output_of_all, write_report

__all__ = ["plot", "report"]


def plot(
    path: StrPath,
    scenes: Sequence[StrPath | Scene],
    *,
    overlay: bool = False,
    overwrite: bool = False,
) -> Path:
    """Plots the nine components of X of several scenes against time, as ``twrench plot`` does.

    :param path: a file for gnuplot to draw, .svg, .pdf or .png.
    :param scenes: the scenes: names, files, or objects.
    :param overlay: one panel per column of X, and one row of panels per scene.
    :param overwrite: replace an existing file that twrench did not write, or that is of another kind.
    :returns: the path.
    :raises UsageError: for another ending, or no scene.
    :raises MotionError: if the method of a scene cannot compute its motion.
    :raises FileError: if the file cannot be written.
    :raises OverwriteError: if another file would be replaced.
    :raises Error: if gnuplot is missing or fails.
    """
    drawn = _scenes(scenes)
    output = output_of_all("plot", drawn, path, overwrite)
    _native.draw_plot([scene._snapshot() for scene in drawn], output, bool(overlay))
    return output.path


def report(
    path: StrPath,
    scenes: Sequence[StrPath] | None = None,
    *,
    author: str = "",
    date: str = "",
    language: LanguageName | str = UNSET,
    static: bool = False,
    overwrite: bool = False,
    **values: Any,
) -> Path:
    """Writes a report on several motions, or on the tasks of the course, as ``twrench report`` does.

    :param path: the file, .html or .md; the figures of a Markdown report are files beside it.
    :param scenes: names or files of scenes; None for the tasks of the course, which have their own.
    :param author: name of the author, shown below the title.
    :param date: date below the title, in any form.
    :param language: language of the report, en or nb; that of the first scene unless given.
    :param static: leave out the interactive page, which is that of the first scene.
    :param overwrite: replace an existing file that twrench did not write, or that is of another kind.
    :param values: values that replace those of each scene, as in :class:`Scene`.
    :returns: the path.
    :raises UsageError: for another ending or no scene, or for values without ``scenes``.
    :raises MotionError: if the method of a scene cannot compute its motion.
    :raises FileError: if a file cannot be written.
    :raises OverwriteError: if another file would be replaced.
    :raises Error: if gnuplot, which draws the figures, is missing or fails.
    """
    if scenes is None and values:
        raise UsageError(f"{next(iter(values))}: is for scenes, and the tasks have their own")
    names = _TASKS if scenes is None else _arguments.sequence("scenes", scenes, _NAMES)
    reported = [
        Scene(_arguments.path("scenes", name), language=language, **values) for name in names
    ]
    if not reported:
        raise UsageError("scenes: must have at least one scene")
    return write_report(
        reported, path, author, date, static, overwrite, solves_tasks=scenes is None
    )


_NAMES = "a list of names of scenes"
#: The scenes of the tasks.
_TASKS = ("dzhanibekov", "stable-y", "stable-z")


def _scenes(scenes: Sequence[StrPath | Scene]) -> list[Scene]:
    given = _arguments.sequence("scenes", scenes, "a list of scenes")
    if not given:
        raise UsageError("scenes: must have at least one scene")
    return [
        each if isinstance(each, Scene) else Scene(_arguments.path("scenes", each))
        for each in given
    ]
