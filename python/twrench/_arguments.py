"""Conversion of arguments to arrays, with errors that name the argument."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .errors import UsageError

Array = NDArray[np.float64]


def brief(value: Any) -> str:
    """What a message shows of a wrong value."""
    if isinstance(value, np.ndarray):
        return f"an array of shape {value.shape} and type {value.dtype}"
    text = " ".join(repr(value).split())
    return text if len(text) <= 60 else text[:57] + "..."


def array(name: str, value: ArrayLike, shape: tuple[int | None, ...], form: str) -> Array:
    """A C-contiguous array of finite doubles; None in `shape` is any length, `form` describes it."""
    refused = UsageError(f"{name}: must be {form}, not {brief(value)}")
    try:
        given = np.asarray(value)
        if given.dtype.kind not in "fiu":
            raise refused
        result = np.ascontiguousarray(given, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise refused from error
    # ascontiguousarray makes a scalar one-dimensional.
    if given.ndim != len(shape) or any(
        wanted is not None and wanted != length for wanted, length in zip(shape, given.shape)
    ):
        raise refused
    if not np.isfinite(result).all():
        raise UsageError(f"{name}: must be finite, but has a NaN or an infinity")
    return result


def vector(name: str, value: ArrayLike) -> Array:
    return array(name, value, (3,), "three numbers")


def vectors(name: str, value: ArrayLike) -> Array:
    return array(name, value, (None, 3), "an array of shape (n, 3)")


def inertia(name: str, value: ArrayLike) -> Array:
    """An inertia matrix, also from its six different entries."""
    form = "an array of shape (3, 3), or Ixx, Iyy, Izz, Ixy, Ixz, Iyz"
    shape = (len(value),) if isinstance(value, (list, tuple)) else np.shape(value)
    if shape != (6,):
        return array(name, value, (3, 3), form)
    xx, yy, zz, xy, xz, yz = array(name, value, (6,), form)
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def times(name: str, value: ArrayLike) -> Array:
    return array(name, value, (None,), "a one-dimensional array of times in s")


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


def whole(name: str, value: Any, least: int, greatest: int) -> int:
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, np.integer)):
        raise UsageError(f"{name}: must be an integer, not {brief(value)}")
    if not least <= int(value) <= greatest:
        raise UsageError(f"{name}: must be from {least} to {greatest}, not {int(value)}")
    return int(value)


def text(name: str, value: Any) -> str:
    if not isinstance(value, str):
        raise UsageError(f"{name}: must be a string, not {brief(value)}")
    try:
        value.encode("utf-8")
    except UnicodeEncodeError as error:
        raise UsageError(f"{name}: has half of a surrogate pair: {brief(value)}") from error
    return value


def path(name: str, value: Any) -> str:
    try:
        result = os.fspath(value)
    except TypeError as error:
        raise UsageError(f"{name}: must be a path, not {brief(value)}") from error
    if not isinstance(result, str):
        raise UsageError(f"{name}: must be a path of type str, not {brief(result)}")
    if not result or "\0" in result:
        raise UsageError(f"{name}: must be a path, not {brief(result)}")
    return result
