"""Conversion of arguments to arrays, with errors that name the argument."""

from __future__ import annotations

import os
import re
from fractions import Fraction
from typing import Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from .errors import UsageError
from .names import Rate

Array = NDArray[np.float64]
#: The most numbers of an array: 2.4 GB.
MOST_NUMBERS = 3 * 10**8
T = TypeVar("T")


def brief(value: Any) -> str:
    """A wrong value, shortened for a message."""
    if isinstance(value, np.ndarray):
        return f"an array of shape {value.shape} and type {value.dtype}"
    text = " ".join(repr(value).split())
    return text if len(text) <= 60 else text[:57] + "..."


def array(name: str, value: ArrayLike, shape: tuple[int | None, ...], form: str) -> Array:
    """A copy as a C-contiguous array of finite doubles, which later changes of `value` do not change.

    None in `shape` allows any length, `form` describes the array.
    """
    if isinstance(value, np.ma.MaskedArray) and np.any(value.mask):
        raise UsageError(f"{name}: has masked entries")
    refused = UsageError(f"{name}: must be {form}, not {brief(value)}")
    try:
        given = np.asarray(value)
    except (TypeError, ValueError) as error:
        raise refused from error
    if (
        given.dtype.kind not in "fiu"
        or given.ndim != len(shape)
        or any(wanted not in (None, length) for wanted, length in zip(shape, given.shape))
    ):
        raise refused
    if given.size > MOST_NUMBERS:  # before a copy of a repeated array fills the memory
        raise UsageError(f"{name}: has {given.size} numbers, the limit is {MOST_NUMBERS}")
    with np.errstate(over="ignore"):  # an infinity is refused below
        result = np.array(given, dtype=np.float64, order="C")
    if not np.isfinite(result).all():
        raise UsageError(f"{name}: must be finite, but has a NaN or an infinity")
    return result


def vector(name: str, value: ArrayLike) -> Array:
    return array(name, value, (3,), "three numbers")


def vectors(name: str, value: ArrayLike) -> Array:
    return array(name, value, (None, 3), "an array of shape (n, 3)")


def inertia(name: str, value: ArrayLike) -> Array:
    """An inertia matrix, given as a matrix or by its six different entries."""
    form = "an array of shape (3, 3), or Ixx, Iyy, Izz, Ixy, Ixz, Iyz"
    shape = (len(value),) if isinstance(value, (list, tuple)) else np.shape(value)
    if shape != (6,):
        return array(name, value, (3, 3), form)
    xx, yy, zz, xy, xz, yz = array(name, value, (6,), form)
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


SPELLINGS = "np.linspace(0, 10, n) for n times, or span=(0, 10), fps=60 for evenly spaced ones"


def times(value: ArrayLike | None, span: ArrayLike | None = None, fps: Rate | None = None) -> Array:
    """The times of samples: the given ones, or ``fps`` per second over a span with both ends.

    A single number is an array without dimensions."""
    if value is None and span is None:
        raise UsageError(f"times: must be given, or a span: {SPELLINGS}")
    if span is not None:
        if value is not None:
            raise UsageError("span: cannot be combined with times")
        return _span_times(span, 60.0 if fps is None else rate("fps", fps))
    if fps is not None:
        raise UsageError("fps: is for span, and times are given")
    if isinstance(value, tuple) and len(value) == 2:
        raise UsageError(
            f"times: {brief(value)} could be two times or a span; write {SPELLINGS}, "
            "or a list for exactly two times"
        )
    assert value is not None
    is_single = isinstance(value, (int, float, np.number)) or getattr(value, "ndim", None) == 0
    shape: tuple[int | None, ...] = () if is_single else (None,)
    return array("times", value, shape, "a time or a one-dimensional array of times in s")


def _span_times(span: ArrayLike, fps: float) -> Array:
    start, end = map(float, array("span", span, (2,), "two times in s, (start, end)"))
    if not start < end:
        raise UsageError(f"span: must end after it starts, not {brief(span)}")
    most = MOST_NUMBERS // 3
    if (end - start) * fps > most:
        raise UsageError(f"span: has more than {most} samples at fps={fps:g}")
    # Rounding must not leave two samples at nearly the same time at the end.
    count = int(np.ceil((end - start) * fps * (1 - 1e-12)))
    return np.append(start + np.arange(count) / fps, end)


def attitude(name: str, value: Any) -> Array:
    """The rotation matrix of a matrix, a quaternion (scalar first) or a SciPy ``Rotation``."""
    given = value.as_matrix() if hasattr(value, "as_matrix") else value
    form = "a quaternion (w, x, y, z), a rotation matrix (3, 3) or a SciPy Rotation"
    shape = (len(given),) if isinstance(given, (list, tuple)) else np.shape(given)
    if shape == (4,):
        return _native.rotation(array(name, given, (4,), form))
    return array(name, given, (3, 3), form)


def indices(name: str, value: ArrayLike, count: int) -> NDArray[np.uint32]:
    """Indices of `count` things, of shape (m, 3)."""
    refused = UsageError(f"{name}: must be an array of integers of shape (m, 3), not {brief(value)}")
    try:
        given = np.asarray(value)
    except ValueError as error:
        raise refused from error
    if given.dtype.kind not in "iu" or given.ndim != 2 or given.shape[1] != 3:
        raise refused
    if given.size and not 0 <= given.min() <= given.max() < count:
        raise UsageError(f"{name}: must be from 0 to {count - 1}, the last of the vertices")
    return np.ascontiguousarray(given, dtype=np.uint32)


def number(name: str, value: Any) -> float:
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, float, np.number)):
        raise UsageError(f"{name}: must be a number, not {brief(value)}")
    try:
        result = float(value)
    except (TypeError, ValueError, OverflowError) as error:
        raise UsageError(f"{name}: must be a number, not {brief(value)}") from error
    if not np.isfinite(result):
        raise UsageError(f"{name}: must be finite, not {result}")
    return result


def positive(name: str, value: Any) -> float:
    result = number(name, value)
    if result <= 0:
        raise UsageError(f"{name}: must be greater than 0, not {brief(value)}")
    return result


def rate(name: str, value: Any) -> float:
    """A number, or a fraction of whole numbers, also as text."""
    if isinstance(value, str):
        found = re.fullmatch(r"([0-9]{1,7})/([0-9]{1,7})", value)
        if found is None or int(found[2]) == 0:
            raise UsageError(f"{name}: must be a number or a fraction, 30000/1001, not {brief(value)}")
        value = int(found[1]) / int(found[2])
    return positive(name, float(value) if isinstance(value, Fraction) else value)


def within(name: str, value: Any, least: float, greatest: float) -> float:
    result = number(name, value)
    if not least <= result <= greatest:
        raise UsageError(f"{name}: must be from {least} to {greatest}, not {brief(value)}")
    return result


def whole(name: str, value: Any, least: int, greatest: int) -> int:
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, np.integer)):
        raise UsageError(f"{name}: must be an integer, not {brief(value)}")
    if not least <= int(value) <= greatest:
        raise UsageError(f"{name}: must be from {least} to {greatest}, not {int(value)}")
    return int(value)


def instance(name: str, value: Any, kind: type[T]) -> T:
    """Requires a value of one of the module's classes."""
    if not isinstance(value, kind):
        raise UsageError(f"{name}: must be a twrench.{kind.__name__}, not {brief(value)}")
    return value


def flag(name: str, value: Any) -> bool:
    if not isinstance(value, (bool, np.bool_)):
        raise UsageError(f"{name}: must be True or False, not {brief(value)}")
    return bool(value)


def text(name: str, value: Any) -> str:
    if not isinstance(value, str):
        raise UsageError(f"{name}: must be a string, not {brief(value)}")
    try:
        value.encode("utf-8")
    except UnicodeEncodeError as error:
        raise UsageError(f"{name}: has half of a surrogate pair: {brief(value)}") from error
    return value


def euler_sequence(name: str, value: Any) -> str:
    """Three axes of Euler angles, as in SciPy: x, y and z in the fixed axes of space, X, Y and Z in
    axes that turn with the body. The second differs from the two others."""
    axes = text(name, value)
    if re.fullmatch("[xyz]{3}|[XYZ]{3}", axes) is None or axes[1] in (axes[0], axes[2]):
        raise UsageError(f"{name}: must be three axes such as 'zyx' or 'ZYX', not {brief(axes)}")
    return axes


def path(name: str, value: Any) -> str:
    try:
        result = os.fspath(value)
    except TypeError as error:
        raise UsageError(f"{name}: must be a path, not {brief(value)}") from error
    if not isinstance(result, str):
        raise UsageError(f"{name}: must be a path of type str, not {brief(result)}")
    if not result or "\0" in result:
        raise UsageError(f"{name}: must be a path, not {brief(result)}")
    try:
        result.encode("utf-8")
    except UnicodeEncodeError as error:
        raise UsageError(f"{name}: must be a path in UTF-8, not {brief(result)}") from error
    return result


def sequence(name: str, value: Any, form: str) -> list[Any]:
    """The items of an iterable other than a string; `form` describes them."""
    refused = UsageError(f"{name}: must be {form}, not {brief(value)}")
    if isinstance(value, (str, bytes)):
        raise refused
    try:
        return list(value)
    except TypeError as error:
        raise refused from error
