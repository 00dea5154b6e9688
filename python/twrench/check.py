"""Comparison of a recorded motion with the exact one."""

from __future__ import annotations

import json
import tempfile
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal, Mapping, Union

import numpy as np
from numpy.typing import NDArray

from . import _arguments, _native
from ._arguments import Array
from .body import Body
from .errors import Error, UsageError, argument_names
from .motion import Motion
from .names import Numbers, StrPath
from .published import case as published_case

__all__ = ["Check", "ErrorSize", "check"]

FrameSource = Literal["first", "momentum"]
RateAxes = Literal["body", "space"]
TimeUnit = Literal["s", "ms", "us", "min"]
RateUnit = Literal["rad", "deg", "rev", "rpm"]
AngleUnit = Literal["rad", "deg", "rev"]
Finding = Literal[
    "exact", "noise", "convention", "start", "body", "law", "inconsistent", "integration"
]
#: A file, a motion, or a mapping of names to columns.
Recording = Union[StrPath, Motion, Mapping[str, Numbers]]


@dataclass(frozen=True)
class ErrorSize:
    """The errors of a quantity against the exact motion."""

    #: The unit of both errors.
    unit: str
    #: The largest error.
    max_error: float
    #: The time of the largest error in s.
    max_error_at: float
    #: The root mean square of the errors.
    rms_error: float


@dataclass(frozen=True)
class Check:
    """The result of :func:`check`."""

    #: Whether the data follow the exact motion within their digits and noise, or within the bounds.
    passes: bool
    #: The kind of the verdict.
    finding: Finding
    #: The verdict in one line. Options such as ``--units deg`` are arguments of the same names.
    verdict: str
    #: The number of rows.
    rows: int
    #: The errors of the rates; None if there are no rates.
    rates: ErrorSize | None
    #: The errors of the attitude; None if there is no attitude.
    attitude: ErrorSize | None
    #: Largest relative drift of the energy.
    energy_drift: float
    #: Largest relative drift of the angular momentum; None if there is no attitude.
    momentum_drift: float | None
    #: Largest deviation of the attitude from a rotation; None if there is no attitude.
    orthogonality_error: float | None
    #: Pairs of flip times in s: in the data and in the exact motion; None for a missing flip.
    flips: list[tuple[float | None, float | None]]
    #: The factor by which the motion amplifies an error of its start.
    condition: float
    #: The complete output of ``twrench check --format json``.
    details: dict[str, Any] = field(repr=False)


def check(
    data: Recording,
    body: Body | None = None,
    *,
    case: str | None = None,
    omega: Numbers | None = None,
    omega_at: float | Literal["first"] = 0.0,
    fit: bool = False,
    frame: FrameSource = "first",
    columns: Mapping[str, str] | None = None,
    time_unit: TimeUnit | None = None,
    units: RateUnit | None = None,
    angle_units: AngleUnit | None = None,
    sequence: str | None = None,
    inverse: bool = False,
    rates: RateAxes = "body",
    axes: str | None = None,
    offset: Numbers | None = None,
    max_attitude_error: float | None = None,
    max_rate_error: float | None = None,
    max_energy_drift: float | None = None,
) -> Check:
    """Compares a motion that another program computed with the exact one, as ``twrench check`` does.

    :param data: a CSV, TSV, JSON or .npy file; a :class:`Motion`; or a mapping of names to columns,
        each (n,), such as ``{"t": t, "wx": wx, "wy": wy, "wz": wz}``: times, and rates, attitudes or
        both.
    :param body: the body, unless ``case`` gives it.
    :param case: name of a published case, which gives the body and the initial rates.
    :param omega: angular velocity at ``omega_at`` in body axes in rad/s, (3,); None for that of the
        first row.
    :param omega_at: the time in s at which ``omega`` holds, or "first" for that of the first row.
    :param fit: fit the initial state to all rows by least squares.
    :param frame: how to determine the space frame of the data: from the first row, or from the mean
        direction of the momentum.
    :param columns: the columns of the data for our names: t, wx to wz, x11 to x33, qw to qz, yaw,
        pitch and roll; None to detect them by their names.
    :param time_unit: unit of the times; None for the unit stated in the data, or s.
    :param units: unit of angles and, per second, of rates; None for the unit stated in the data, or
        rad.
    :param angle_units: unit of Euler angles alone.
    :param sequence: axes of Euler angles in the order of the rotations, such as "zyx".
    :param inverse: whether the attitude is body_from_space.
    :param rates: the axes along which the rates are given.
    :param axes: the body's axes along which the data's x, y and z point, such as "x,-z,y".
    :param offset: if the data have the attitude of a part, the quaternion (w, x, y, z) that takes
        the axes of the part to those of the body, (4,).
    :param max_attitude_error: bound for the error of the attitude in degrees. If bounds are given,
        they alone determine the verdict.
    :param max_rate_error: bound for the error of the rates in the unit of the data.
    :param max_energy_drift: bound for the relative drift of the energy.
    :raises UsageError: for a wrong argument, or data that can be read in several ways.
    :raises FileError: if a file cannot be read or is not a table.
    """
    inertia, start = _problem(body, case, omega)
    turn = None
    if offset is not None:
        turn = _arguments.array("offset", offset, (4,), "a quaternion (w, x, y, z)")
    options = {
        "columns": "" if columns is None else _columns_text(columns),
        "time_unit": _name("time_unit", time_unit),
        "units": _name("units", units),
        "angle_units": _name("angle_units", angle_units),
        "sequence": _name("sequence", sequence),
        "rates": _arguments.text("rates", rates),
        "axes": _name("axes", axes),
        "frame": _arguments.text("frame", frame),
    }
    at = None if omega_at == "first" else _arguments.number("omega_at", omega_at)
    bounds = {
        "max_attitude_error": max_attitude_error,
        "max_rate_error": max_rate_error,
        "max_energy_drift": max_energy_drift,
    }
    given = {
        key: _arguments.number(key, value) for key, value in bounds.items() if value is not None
    }

    def judge(file: str) -> Check:
        with argument_names():
            text = _native.check(
                file, inertia, start, at, bool(fit), options, bool(inverse), turn, given
            )
        return _result(json.loads(text))

    if not isinstance(data, (Motion, Mapping)):
        return judge(_arguments.path("data", data))
    with tempfile.TemporaryDirectory(prefix="twrench-") as folder:
        file = Path(folder) / "data.npy"
        np.save(file, _table_of(data))
        try:
            found = judge(str(file))
        except Error as error:
            message = error.message.replace(str(file), "data")
            raise type(error)(message, error.remedy.replace(str(file), "data")) from None
    found.details["file"] = "data"
    return found


def _problem(
    body: Body | None, case: str | None, omega: Numbers | None
) -> tuple[Array, Array | None]:
    """The inertia matrix, in any unit, and the angular velocity, if given."""
    if case is not None:
        if body is not None or omega is not None:
            raise UsageError("case: gives the body and omega; leave them out")
        published = published_case(case)
        return np.diag(published["inertia"]), _arguments.vector("omega", published["omega"])
    given = _arguments.instance("body", body, Body)
    return given.inertia, None if omega is None else _arguments.vector("omega", omega)


def _name(name: str, value: str | None) -> str:
    return "" if value is None else _arguments.text(name, value)


def _columns_text(columns: Mapping[str, str]) -> str:
    return ",".join(
        f'{_arguments.text("columns", ours)}="{_arguments.text("columns", theirs)}"'
        for ours, theirs in columns.items()
    )


def _table_of(data: Motion | Mapping[str, Numbers]) -> NDArray[np.void]:
    """The columns as a structured array of NumPy."""
    if isinstance(data, Motion):
        columns = {"t": data.t}
        for i in range(3):
            columns |= {f"x{i + 1}{j + 1}": data.X[:, i, j] for j in range(3)}
        columns |= {f"w{axis}": data.omega[:, i] for i, axis in enumerate("xyz")}
    else:
        form = "a one-dimensional array of numbers"
        columns = {
            _arguments.text("data", name): _arguments.array(f"data[{name!r}]", value, (None,), form)
            for name, value in data.items()
        }
    lengths = {len(column) for column in columns.values()}
    if len(lengths) != 1:
        raise UsageError("data: must have columns of the same length")
    table = np.empty(lengths.pop(), dtype=[(name, np.float64) for name in columns])
    for name, column in columns.items():
        table[name] = column
    return table


def _result(found: dict[str, Any]) -> Check:
    def size(key: str) -> ErrorSize | None:
        return None if found[key] is None else ErrorSize(**found[key])

    return Check(
        passes=found["passes"],
        finding=found["finding"],
        verdict=found["verdict"],
        rows=found["rows"],
        rates=size("rates"),
        attitude=size("attitude"),
        energy_drift=found["energy_drift"],
        momentum_drift=found["momentum_drift"],
        orthogonality_error=found["orthogonality_error"],
        flips=[(flip["t"], flip["exact"]) for flip in found["flips"]],
        condition=found["condition"],
        details=found,
    )
