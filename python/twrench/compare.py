"""Comparison of pictures with expected ones."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import Literal, Sequence

from . import _arguments, _native
from .errors import UsageError
from .names import StrPath

__all__ = ["Comparison", "FrameComparison", "compare"]

Metric = Literal["share", "ssim"]
Outcome = Literal[
    "identical", "alike", "different", "other_format", "missing", "extra", "unreadable"
]


@dataclass(frozen=True)
class FrameComparison:
    """How a picture differs from the expected one."""

    #: The name of the file.
    name: str
    #: The result for this picture.
    outcome: Outcome
    #: Largest difference of a channel, 0 to 255; None if the pictures were not compared.
    max_difference: float | None
    #: Mean difference of the channels, 0 to 255; None if the pictures were not compared.
    mean_difference: float | None
    #: Fraction of the pixels that differ by more than the threshold; None as above.
    share: float | None
    #: Structural similarity; None unless it is the metric.
    ssim: float | None
    #: How the files differ without making the pictures different, such as an alpha channel that is
    #: opaque everywhere.
    notes: list[str] = field(default_factory=list)


@dataclass(frozen=True)
class Comparison:
    """The result of :func:`compare`; true if all pictures are as expected."""

    #: Whether every picture is identical or alike.
    passed: bool
    #: The pictures in the order of their names.
    frames: list[FrameComparison]
    #: The report for people, as ``twrench compare`` prints it.
    text: str = field(repr=False)
    #: The report in JUnit's XML, with a test case for each picture, for continuous integration.
    junit: str = field(repr=False)

    def __bool__(self) -> bool:
        return self.passed


def compare(
    expected: StrPath,
    actual: StrPath,
    *,
    metric: Metric = "share",
    threshold: int = 0,
    share: float = 0.0,
    min_ssim: float = 1.0,
    edges: int = 0,
    ignore: Sequence[tuple[int, int, int, int]] = (),
    diff: StrPath | None = None,
    report: StrPath | None = None,
    update: bool = False,
    overwrite: bool = False,
) -> Comparison:
    """Compares two PNG files, or two folders of them, as ``twrench compare`` does.

    :param expected: the expected file, or the folder of the expected files.
    :param actual: the actual file or folder. Files of two folders are paired by name.
    :param metric: the metric that decides: the share of pixels that differ, or the structural
        similarity.
    :param threshold: largest difference of a channel, 0 to 255, at which pixels count as equal.
    :param share: fraction of pixels that may differ, 0 to 1.
    :param min_ssim: least structural similarity, up to 1.
    :param edges: number of pixels by which edges may be displaced, 0 to 16.
    :param ignore: rectangles (x, y, width, height) in pixels that count as equal.
    :param diff: for two files, a ``.png`` file for the amplified difference.
    :param report: an ``.html`` file for a page that shows the differences.
    :param update: replace the expected files with the actual ones that differ, and add extra ones.
    :param overwrite: let ``diff`` and ``report`` replace a file that twrench did not write, or that is
        of another kind.
    :returns: the result, before any update.
    :raises UsageError: for a wrong argument, or a file compared with a folder.
    :raises FileError: if a picture cannot be read, or a file cannot be written.
    :raises OverwriteError: if an output would replace another file.
    """
    if metric == "ssim" and share != 0:
        raise UsageError("share: bounds the metric 'share', but 'ssim' decides; use min_ssim")
    if metric == "share" and min_ssim != 1:
        raise UsageError("min_ssim: bounds the metric 'ssim', but 'share' decides; use share")
    areas = []
    for area in _arguments.sequence("ignore", ignore, "a list of rectangles"):
        if not isinstance(area, (tuple, list)) or len(area) != 4:
            raise UsageError(
                f"ignore: must be rectangles (x, y, width, height), not {_arguments.brief(area)}"
            )
        areas.append([_arguments.whole("ignore", number, 0, 2**31 - 1) for number in area])
    document, text, junit = _native.compare(
        _arguments.path("expected", expected),
        _arguments.path("actual", actual),
        _arguments.text("metric", metric),
        _arguments.whole("threshold", threshold, 0, 255),
        _arguments.within("share", share, 0, 1),
        _arguments.within("min_ssim", min_ssim, -1, 1),
        _arguments.whole("edges", edges, 0, 16),
        areas,
        "" if diff is None else _arguments.path("diff", diff),
        "" if report is None else _arguments.path("report", report),
        bool(update),
        bool(overwrite),
    )
    frames = [
        FrameComparison(
            name=frame["file"],
            outcome=frame["outcome"],
            max_difference=frame.get("max"),
            mean_difference=frame.get("mean"),
            share=frame.get("share"),
            ssim=frame.get("ssim"),
            notes=frame.get("notes", []),
        )
        for frame in json.loads(document)["frames"]
    ]
    passed = all(frame.outcome in ("identical", "alike") for frame in frames)
    return Comparison(passed, frames, text, junit)
