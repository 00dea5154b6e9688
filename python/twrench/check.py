"""Comparison of a recorded motion with the exact one."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal, Mapping, Sequence, TypeVar, Union, overload

import numpy as np
from numpy.typing import ArrayLike

from . import _arguments, _native
from ._arguments import Array
from .body import Body
from .errors import UsageError
from .names import Numbers, StrPath
from .published import case as published_case
from .recording import (
    AngleUnit,
    Convention,
    Data,
    RateAxes,
    RateUnit,
    Source,
    TimeUnit,
    convention_of,
    source_of,
)

__all__ = ["Check", "CheckOrder", "Checks", "ErrorSize", "FittedInertia", "Recording", "check"]

FrameSource = Literal["first", "momentum"]
Finding = Literal[
    "exact", "noise", "convention", "start", "body", "law", "inconsistent", "integration"
]


class Recording:
    """A recorded motion at n times: rates, attitudes or both.

    :meth:`read` makes one of a file or of columns in any convention; the constructor takes arrays in
    twrench's. :func:`check` and :meth:`check` judge it.

    :param t: times in s, (n,), ascending.
    :param omega: angular velocities in body axes in rad/s, (n, 3); None if there are none.
    :param X: attitudes space_from_body, (n, 3, 3); None if there are none.
    :param quaternion_wxyz: the attitudes as quaternions (w, x, y, z), (n, 4), instead of ``X``.
    :raises UsageError: for arrays of another shape, or a row that is no motion.
    """

    #: Times in s, (n,): as given to the constructor, or since the first row.
    t: Array
    #: Angular velocities in body axes in rad/s, (n, 3); None if there are none.
    omega: Array | None
    #: Attitudes space_from_body, (n, 3, 3); None if there are none. Quaternions are normalised.
    X: Array | None
    #: Time of the first row on the clock of a file in s; 0 for arrays.
    start: float

    def __init__(
        self,
        t: ArrayLike,
        omega: ArrayLike | None = None,
        X: ArrayLike | None = None,
        *,
        quaternion_wxyz: ArrayLike | None = None,
    ) -> None:
        if X is not None and quaternion_wxyz is not None:
            raise UsageError("quaternion_wxyz: X gives the attitudes already", "give one of the two")
        times = _arguments.array("t", t, (None,), "a one-dimensional array of times in s")
        if not len(times):
            raise UsageError("t: must have at least one time")
        columns: dict[str, Array] = {"t": times}
        parts: list[tuple[str, ArrayLike | None, tuple[int, ...], str]] = [
            ("omega", omega, (3,), "wx wy wz"),
            ("X", X, (3, 3), "x11 x12 x13 x21 x22 x23 x31 x32 x33"),
            ("quaternion_wxyz", quaternion_wxyz, (4,), "qw qx qy qz"),
        ]
        for name, value, shape, ours in parts:
            if value is None:
                continue
            form = f"an array of shape ({len(times)}, {', '.join(map(str, shape))})"
            rows = _arguments.array(name, value, (len(times), *shape), form)
            columns |= zip(ours.split(), rows.reshape(len(times), -1).T)
        if len(columns) == 1:
            raise UsageError("Recording: must have omega, X or quaternion_wxyz")
        self._source: Source = ("recording", list(columns.items()))
        self._convention: Convention = {}
        self._read(None)
        self.t, self.start = times, 0.0

    @classmethod
    def read(
        cls,
        data: Data,
        body: Body | None = None,
        *,
        columns: Mapping[str, str] | Sequence[str] | None = None,
        time_unit: TimeUnit | None = None,
        units: RateUnit | None = None,
        angle_units: AngleUnit | None = None,
        sequence: str | None = None,
        inverse: bool = False,
        rates: RateAxes = "body",
        axes: str | None = None,
        offset: Numbers | None = None,
    ) -> Recording:
        """Reads a file or columns.

        :param data: what :func:`check` takes: a file, a motion or columns. The arguments ``columns``,
            ``time_unit``, ``units``, ``angle_units``, ``sequence``, ``inverse``, ``rates``, ``axes``
            and ``offset`` are those of :func:`check`, too.
        :param body: the body. It decides where the names of columns leave several readings, and
            turns angular momentum into rates.
        :raises UsageError: for a wrong argument, or data that can be read in several ways.
        :raises FileError: if a file cannot be read or is not a table.
        """
        convention, of_array = convention_of(
            columns, time_unit, units, angle_units, sequence, inverse, rates, axes, offset
        )
        recording = cls.__new__(cls)
        recording._source = source_of("data", data, of_array)
        recording._convention = convention
        recording._read(None if body is None else _arguments.instance("body", body, Body))
        return recording

    def _read(self, body: Body | None) -> None:
        inertia = None if body is None else body.inertia
        self.start, self.t, omega, X = _native.read_recording(self._source, self._convention, inertia)
        self.omega = omega if len(omega) else None
        self.X = X.reshape(-1, 3, 3) if len(X) else None

    @property
    def _origin(self) -> tuple[Source, Convention]:
        """The data that it was read from, and their convention."""
        return self._source, self._convention

    @property
    def quaternion_wxyz(self) -> Array | None:
        """X as unit quaternions (w, x, y, z), (n, 4); None if there are no attitudes.

        The sign of each quaternion is the one nearer to the previous row.
        """
        return None if self.X is None else np.roll(_native.quaternions(self.X), 1, axis=-1)

    def check(self, body: Body | None = None, **options: Any) -> Check:
        """Compares it with the exact motion, with the digits of the data that it was read from.

        :param body: the body, unless ``case`` gives it.
        :param options: those of :func:`check` that are not about how data are read.
        """
        return check(self, body, **options)

    def __len__(self) -> int:
        return len(self.t)

    def __repr__(self) -> str:
        parts = [("rates", self.omega), ("attitudes", self.X)]
        names = " and ".join(name for name, part in parts if part is not None)
        return f"<twrench.Recording: {len(self)} rows of {names}, {np.ptp(self.t):g} s>"


#: What can be judged.
Recorded = Union[Recording, Data]
R = TypeVar("R", bound=Recorded)
#: Several recordings.
Recordings = Union["list[R]", "tuple[R, ...]"]


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


@dataclass(frozen=True, eq=False)
class FittedInertia:
    """An inertia that was fitted to rates, in units of its least principal moment."""

    #: The principal moments, ascending: 1 and two ratios, (3,).
    moments: Array
    #: Their standard errors, 0 first, (3,).
    deviations: Array
    #: The rotation body_from_principal, whose columns are the principal axes, (3, 3).
    axes: Array
    #: The inertia matrix about the axes of the data, (3, 3).
    matrix: Array


@dataclass(frozen=True)
class Check:
    """The result of :func:`check`."""

    #: Whether the data follow the exact motion within their digits and noise, or within the bounds.
    passes: bool
    #: The kind of the verdict.
    finding: Finding
    #: The verdict in one line, with the arguments that it recommends.
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
    #: The inertia that ``fit="inertia"`` found; None if it was not fitted.
    inertia: FittedInertia | None
    #: All results, as ``twrench check --format json`` prints them, with the names of arguments for
    #: those of options.
    details: dict[str, Any] = field(repr=False)
    #: The report for people, as ``twrench check`` prints it.
    text: str = field(repr=False)
    #: The report in JUnit's XML, as ``--format junit`` prints it, for continuous integration.
    junit: str = field(repr=False)


@dataclass(frozen=True)
class CheckOrder:
    """The exponents of the largest errors as functions of the step."""

    #: The order of the rates; None if the recordings do not determine it.
    rates: float | None
    #: The order of the attitude; None if the recordings do not determine it.
    attitude: float | None
    #: Why there is no order; None if there is one.
    why_not: str | None


@dataclass(frozen=True)
class Checks:
    """The result of :func:`check` for several recordings."""

    #: The results in the order of the recordings.
    files: list[Check]
    #: The order of the method that computed them.
    order: CheckOrder
    #: The report on all of them for people, as ``twrench check`` prints it.
    text: str = field(repr=False)
    #: The report in JUnit's XML, with a suite for each recording.
    junit: str = field(repr=False)

    @property
    def passes(self) -> bool:
        """Whether all of them pass."""
        return all(found.passes for found in self.files)


@overload
def check(
    data: Recorded,
    body: Body | None = None,
    *,
    steps: Numbers | None = ...,
    case: str | None = ...,
    omega: Numbers | None = ...,
    omega_at: float | Literal["first"] = ...,
    fit: bool | Literal["inertia"] = ...,
    frame: FrameSource = ...,
    from_time: float | None = ...,
    to_time: float | None = ...,
    columns: Mapping[str, str] | Sequence[str] | None = ...,
    time_unit: TimeUnit | None = ...,
    units: RateUnit | None = ...,
    angle_units: AngleUnit | None = ...,
    sequence: str | None = ...,
    inverse: bool = ...,
    rates: RateAxes = ...,
    axes: str | None = ...,
    offset: Numbers | None = ...,
    max_attitude_error: float | None = ...,
    max_rate_error: float | None = ...,
    max_energy_drift: float | None = ...,
    plot: StrPath | None = ...,
    overwrite: bool = ...,
) -> Check: ...


@overload
def check(
    data: Recordings[R],
    body: Body | None = None,
    *,
    steps: Numbers | None = ...,
    case: str | None = ...,
    omega: Numbers | None = ...,
    omega_at: float | Literal["first"] = ...,
    fit: bool | Literal["inertia"] = ...,
    frame: FrameSource = ...,
    from_time: float | None = ...,
    to_time: float | None = ...,
    columns: Mapping[str, str] | Sequence[str] | None = ...,
    time_unit: TimeUnit | None = ...,
    units: RateUnit | None = ...,
    angle_units: AngleUnit | None = ...,
    sequence: str | None = ...,
    inverse: bool = ...,
    rates: RateAxes = ...,
    axes: str | None = ...,
    offset: Numbers | None = ...,
    max_attitude_error: float | None = ...,
    max_rate_error: float | None = ...,
    max_energy_drift: float | None = ...,
    plot: StrPath | None = ...,
    overwrite: bool = ...,
) -> Checks: ...


def check(
    data: Recorded | Recordings[Any],
    body: Body | None = None,
    *,
    steps: Numbers | None = None,
    case: str | None = None,
    omega: Numbers | None = None,
    omega_at: float | Literal["first"] = 0.0,
    fit: bool | Literal["inertia"] = False,
    frame: FrameSource = "first",
    from_time: float | None = None,
    to_time: float | None = None,
    columns: Mapping[str, str] | Sequence[str] | None = None,
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
    plot: StrPath | None = None,
    overwrite: bool = False,
) -> Check | Checks:
    """Compares a motion that another program computed with the exact one, as ``twrench check`` does.

    :param data: a CSV, TSV, JSON, AEM, .npy or .npz file; a :class:`Motion` or a
        :class:`Recording`; or columns: a mapping of
        names to arrays (n,), (n, k) or (n, k, m), such as ``{"t": t, "omega": omega, "X": X}``, a data
        frame of pandas, or an array (n, k) whose columns ``columns`` names. The columns are times, and
        rates, attitudes or both. A list or tuple of such recordings gives a :class:`Checks`, with the
        order of the method.
    :param body: the body, unless ``case`` gives it or it is fitted.
    :param steps: step sizes of the recordings in s, (m,); None for the mean times between rows.
    :param case: name of a published case, which gives the body and the initial rates.
    :param omega: angular velocity at ``omega_at`` in body axes in rad/s, (3,); None for that of the
        first row, or for a fit if the data have no rates.
    :param omega_at: the time in s at which ``omega`` holds, or "first" for that of the first row.
    :param fit: fit the initial state to all rows by least squares; "inertia" also finds the ratios of
        the principal moments from the rates, as :attr:`Check.inertia`.
    :param frame: how to determine the space frame of the data: from the first row, or from the mean
        direction of the momentum.
    :param from_time: leave out the rows before this time in s since the first row.
    :param to_time: leave out the rows after this time in s since the first row.
    :param columns: the columns of the data for our names: t, wx to wz, lx to lz, x11 to x33, qw to qz,
        yaw, pitch and roll, rvx to rvz, axisx to axisz and angle, mrpx to mrpz, gibbsx to gibbsz; None
        to detect them by their names. For arrays, the names of all columns, (k,), such as
        ``["t", "wx", "wy", "wz"]``.
    :param time_unit: unit of the times; None for the unit stated in the data, or s.
    :param units: unit of angles and, per second, of rates; None for the unit stated in the data, or
        rad.
    :param angle_units: unit of Euler angles alone.
    :param sequence: axes of Euler angles in the order of the rotations, as in :meth:`Motion.euler`:
        in capital letters, such as "ZYX", they turn with the body; in lower case, such as "xyz", they
        are the fixed axes of space. The command line's ``zyx`` is "ZYX".
    :param inverse: whether the attitude is body_from_space.
    :param rates: the axes along which the rates are given.
    :param axes: the body's axes along which the data's x, y and z point, such as "x,-z,y".
    :param offset: if the data have the attitude of a part, the quaternion (w, x, y, z) that takes
        the axes of the part to those of the body, (4,).
    :param max_attitude_error: bound for the error of the attitude in degrees. If bounds are given,
        they alone determine the verdict.
    :param max_rate_error: bound for the error of the rates in the unit of the data.
    :param max_energy_drift: bound for the relative drift of the energy.
    :param plot: a file, .svg, .pdf or .png, for a plot of the errors and the resolution limits
        against time, which gnuplot draws; None for no plot.
    :param overwrite: let ``plot`` replace a file that twrench did not write, or that is of another
        kind.
    :raises UsageError: for a wrong argument, or data that can be read in several ways.
    :raises FileError: if a file cannot be read or is not a table, or the plot cannot be written.
    :raises Error: if gnuplot is needed, but is missing or fails.
    """
    is_inertia = isinstance(fit, str)
    if is_inertia and fit != "inertia":
        raise UsageError(f"fit: must be True, False or 'inertia', not {_arguments.brief(fit)}")
    if is_inertia and (body is not None or case is not None):
        raise UsageError("fit: 'inertia' finds the body; leave out body and case")
    inertia, start = (None, None) if is_inertia else _problem(body, case, omega)
    if is_inertia and omega is not None:
        start = _arguments.vector("omega", omega)
    convention, of_array = convention_of(
        columns, time_unit, units, angle_units, sequence, inverse, rates, axes, offset
    )
    is_first = isinstance(omega_at, str) and omega_at == "first"
    at = None if is_first else _arguments.number("omega_at", omega_at)
    bounds = {
        "max_attitude_error": max_attitude_error,
        "max_rate_error": max_rate_error,
        "max_energy_drift": max_energy_drift,
    }
    given = {
        key: _arguments.number(key, value) for key, value in bounds.items() if value is not None
    }
    if isinstance(data, (list, tuple)):
        recordings = list(data)
        names = [f"data[{i}]" for i in range(len(recordings))]
    else:
        recordings, names = [data], ["data"]
    if not recordings:
        raise UsageError("data: must have at least one recording")
    lengths = [] if steps is None else _step_sizes(steps, len(recordings))
    sources = [_source_of(*named, of_array) for named in zip(names, recordings)]
    if any(isinstance(recording, Recording) for recording in recordings):
        convention = _convention_of_read(recordings, convention)
    figure = None
    if plot is not None:
        path = Path(_arguments.path("plot", plot))
        inputs = [Path(source) for source in sources if isinstance(source, str)]
        figure = _native.Output("plot", path, inputs, bool(overwrite), "")
    of_all, of_each = _native.check(
        sources,
        lengths,
        inertia,
        start,
        at,
        bool(fit),
        _arguments.text("frame", frame),
        (
            -math.inf if from_time is None else _arguments.number("from_time", from_time),
            math.inf if to_time is None else _arguments.number("to_time", to_time),
        ),
        convention,
        given,
        figure,
    )
    results = [_result(reports) for reports in of_each]
    if not isinstance(data, (list, tuple)):
        return results[0]
    order = {"rates": None, "attitude": None, "why_not": None}
    if len(results) > 1:
        order = json.loads(of_all.json)["order"]
    return Checks(results, CheckOrder(**order), of_all.text, of_all.junit)


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


def _step_sizes(steps: Numbers, count: int) -> list[float]:
    sizes = [float(size) for size in _arguments.array("steps", steps, (None,), "step sizes in s")]
    if len(sizes) != count:
        raise UsageError(f"steps: has {len(sizes)} step sizes for {count} recordings")
    return sizes


def _source_of(name: str, data: Any, of_array: list[Any] | None) -> Source:
    return data._source if isinstance(data, Recording) else source_of(name, data, of_array)


def _convention_of_read(recordings: list[Any], given: Convention) -> Convention:
    """The convention of recordings of which some were read already."""
    if given:
        raise UsageError(f"{next(iter(given))}: the recording was read already", "leave it out")
    conventions = [
        recording._convention if isinstance(recording, Recording) else given
        for recording in recordings
    ]
    if len(set(map(repr, conventions))) != 1:
        raise UsageError("data: the recordings were read in different ways", "check each alone")
    found: Convention = conventions[0]
    return found


def _result(reports: _native.CheckReports) -> Check:
    found = json.loads(reports.json)

    def size(key: str) -> ErrorSize | None:
        return None if found[key] is None else ErrorSize(**found[key])

    fitted = found["inertia"]
    if fitted is not None:
        fitted = FittedInertia(**{key: np.array(value) for key, value in fitted.items()})
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
        inertia=fitted,
        details=found,
        text=reports.text,
        junit=reports.junit,
    )
