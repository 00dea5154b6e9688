"""The names that arguments accept, as types, so that a type checker rejects every other name."""

from __future__ import annotations

from fractions import Fraction
from os import PathLike
from typing import Any, Literal, Protocol, Sequence, Union

import numpy as np
from numpy.typing import NDArray

MethodName = Literal[
    "euler",
    "lie-euler",
    "midpoint",
    "trapezoid",
    "rk4",
    "rkf45",
    "implicit-trapezoid",
    "strang",
    "rkmk4",
    "rkmk45",
    "cf4",
    "suzuki4",
    "taylor",
    "exact",
]
LanguageName = Literal["en", "nb"]
SoundName = Literal["none", "motion"]
ThemeName = Literal["studio", "paper", "space"]
MaterialName = Literal["steel", "brass", "wood", "plastic", "rubber", "rock", "paper"]
FrameName = Literal["space", "body", "rotating"]
ViewName = Literal["wrench", "momentum", "poinsot", "quad"]
FeatureName = Literal[
    "floor",
    "shadow",
    "axes",
    "momentum",
    "omega",
    "trail",
    "plane",
    "labels",
    "hud",
    "components",
    "sphere",
    "poinsot",
    "phase",
    "curve",
    "method",
    "drift",
    "forces",
    "torques",
    "tip",
    "tilt",
    "moments",
    "inertia",
]
ForceName = Literal["centrifugal", "coriolis", "euler", "constraint", "sum"]
#: A rate: a number, or a fraction such as ``"30000/1001"``.
Rate = Union[float, str, Fraction]
ShapeName = Literal["box", "ellipsoid", "cross"]
UnitName = Literal["mm", "cm", "m", "inch", "km"]
ContainerName = Literal["mp4", "mov", "mkv", "webm", "gif", "webp"]
EffortName = Literal["fast", "balanced", "small"]
BackendName = Literal["auto", "osmesa", "egl"]
ExportFormat = Literal["glb", "py", "aem", "csv", "json", "npz"]

#: Numbers in Python's or NumPy's types. Unlike NumPy's ``ArrayLike`` it excludes text.
Numbers = Union[Sequence[float], NDArray[np.floating[Any]], NDArray[np.integer[Any]]]
#: Rows of numbers.
Rows = Union[
    Sequence[Sequence[float]],
    Sequence[NDArray[np.floating[Any]]],
    NDArray[np.floating[Any]],
    NDArray[np.integer[Any]],
]


class HasMatrix(Protocol):
    """A rotation such as SciPy's ``Rotation``."""

    def as_matrix(self) -> Any: ...


#: A quaternion (w, x, y, z), a rotation matrix (3, 3) or a SciPy ``Rotation``.
Attitude = Union[Numbers, Rows, HasMatrix]
StrPath = Union[str, "PathLike[str]"]
