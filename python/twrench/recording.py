"""The sources of recorded motions: files, arrays and data frames, and their conventions."""

from __future__ import annotations

from typing import Any, Literal, Mapping, Protocol, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from . import _arguments, _native
from ._arguments import Array
from .body import Body
from .errors import UsageError
from .motion import Motion
from .names import Numbers, StrPath

RateAxes = Literal["body", "space"]
TimeUnit = Literal["s", "ms", "us", "ns", "min", "h", "d", "0.1ms"]
RateUnit = Literal["rad", "deg", "rev", "rpm"]
AngleUnit = Literal["rad", "deg"]


class DataFrame(Protocol):
    """A table with named columns, such as a DataFrame of pandas."""

    @property
    def columns(self) -> Any: ...
    def __getitem__(self, name: Any, /) -> Any: ...


#: A file, a motion, an array (n, k), or columns with names.
Data = Union[StrPath, Motion, Mapping[str, Numbers], DataFrame, NDArray[Any]]
#: The path of a file, or the name and the columns of a table.
Source = Union[str, tuple[str, list[tuple[str, Array]]]]
#: The fields of a convention by their names.
Convention = dict[str, Union[str, bool, Array]]


def convention_of(
    columns: Mapping[str, str] | Sequence[str] | None,
    time_unit: TimeUnit | None,
    units: RateUnit | None,
    angle_units: AngleUnit | None,
    sequence: str | None,
    inverse: bool,
    rates: RateAxes,
    axes: str | None,
    offset: Numbers | None,
) -> tuple[Convention, list[Any] | None]:
    """The fields that are given, and the names of the columns of an array."""
    convention: Convention = {}
    of_array = None
    if isinstance(columns, Mapping):
        convention["columns"] = _columns_text(columns)
    elif columns is not None:
        of_array = _arguments.sequence("columns", columns, "a mapping or a list of names")
    if inverse:
        convention["inverse"] = True
    words = {
        "time_unit": time_unit,
        "units": units,
        "angle_units": angle_units,
        "rates": None if rates == "body" else rates,
        "axes": axes,
    }
    for name, word in words.items():
        if word is not None:
            convention[name] = _arguments.text(name, word)
    if sequence is not None:
        convention["sequence"] = _sequence_of_program(sequence)
    if offset is not None:
        convention["offset"] = _arguments.array("offset", offset, (4,), "a quaternion (w, x, y, z)")
    return convention, of_array


def _sequence_of_program(sequence: str) -> str:
    """The sequence of the program, whose axes turn with the body."""
    axes = _arguments.euler_sequence("sequence", sequence)
    if axes.isupper():
        return axes.lower()
    # Rotations about fixed axes are the reverse ones about axes that turn with the body. Each axis
    # keeps its angle, unless two angles are about the same axis.
    if axes[0] == axes[2]:
        raise UsageError(
            f"sequence: cannot be {axes!r}, with fixed axes",
            f"exchange the first and the third angle, and use {axes.upper()!r}",
        )
    return axes[::-1]


def _columns_text(columns: Mapping[str, str]) -> str:
    quoted = {
        _arguments.text("columns", ours): _arguments.text("columns", theirs).replace('"', '""')
        for ours, theirs in columns.items()
    }
    return ",".join(f'{ours}="{theirs}"' for ours, theirs in quoted.items())


def source_of(name: str, data: Any, of_array: list[Any] | None = None) -> Source:
    """A path, or the name and the columns of a table. `of_array` are the names of an array's columns."""
    is_array = isinstance(data, np.ndarray) and data.dtype.names is None
    if of_array is not None and not is_array:
        raise UsageError(
            f"columns: must be a mapping of our names to those of {name}, "
            f"not {_arguments.brief(of_array)}"
        )
    if is_array:
        columns = _columns_of_array(name, data, of_array)
    elif isinstance(data, np.ndarray):
        columns = _columns_of_mapping(name, {key: data[key] for key in data.dtype.names})
    elif isinstance(data, Mapping):
        columns = _columns_of_mapping(name, data)
    elif isinstance(data, Motion):
        columns = _columns_of_motion(name, data)
    elif hasattr(data, "columns"):
        columns = _columns_of_frame(name, data)
    else:
        return _arguments.path(name, data)
    if not columns:
        raise UsageError(f"{name}: must have columns")
    if "" in columns:
        raise UsageError(f"{name}: has a column without a name")
    if len({len(column) for column in columns.values()}) != 1:
        raise UsageError(f"{name}: must have columns of the same length")
    return name, list(columns.items())


def _columns_of_motion(name: str, motion: Motion) -> dict[str, Array]:
    if not motion._free_body.is_rigid:
        raise UsageError(
            f"{name}: a check needs the closed form of a rigid body's motion",
            "use a body without a wheel and energy loss",
        )
    t, X, omega = motion._samples()
    columns = {"t": t}
    for i in range(3):
        columns |= {f"x{i + 1}{j + 1}": X[:, i, j] for j in range(3)}
    return columns | {f"w{axis}": omega[:, i] for i, axis in enumerate("xyz")}


def _columns_of_mapping(name: str, data: Mapping[Any, Any]) -> dict[str, Array]:
    """Each number of a row is a column: ``omega[0]``, ``X[0][2]``."""
    columns: dict[str, Array] = {}
    for key, value in data.items():
        label = _arguments.text(name, key)
        shape: tuple[int, ...] = value.shape if isinstance(value, np.ndarray) else ()
        wanted = (None,) * len(shape) if len(shape) in (2, 3) and shape[1] > 1 else (None,)
        form = "a one-dimensional array of numbers, or one of vectors or matrices"
        numbers = _arguments.array(f"{name}[{key!r}]", value, wanted, form)
        each_row = list(np.ndindex(numbers.shape[1:]))
        flat = numbers.reshape(len(numbers), len(each_row))
        for column, indices in enumerate(each_row):
            columns[label + "".join(f"[{i}]" for i in indices)] = flat[:, column]
    return columns


def _columns_of_array(name: str, data: Any, names: list[Any] | None) -> dict[str, Array]:
    """Without names they are those of a file without names: #1, #2 ..."""
    numbers = _arguments.array(name, data, (None, None), "an array of numbers of shape (n, k)")
    count = numbers.shape[1]
    if names is None:
        names = [f"#{i + 1}" for i in range(count)]
    if len(names) != count or len(set(map(str, names))) != count:
        raise UsageError(
            f"columns: must be {count} different names for the columns of {name}, "
            f"not {_arguments.brief(names)}"
        )
    return {_arguments.text("columns", key): numbers[:, i] for i, key in enumerate(names)}


def _columns_of_frame(name: str, data: Any) -> dict[str, Array]:
    """The columns of numbers. Those that the check does not use may have any values."""
    columns = {
        _arguments.text(name, str(label)): np.asarray(data[label]) for label in data.columns
    }
    return {
        label: np.array(column, dtype=np.float64)
        for label, column in columns.items()
        if column.dtype.kind in "fiu" and column.ndim == 1
    }
