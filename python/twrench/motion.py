"""The torque-free motion of a rigid body: integrated by a method, or exact."""

from __future__ import annotations

import io
import math
import warnings
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import numpy as np
from . import _arguments, _native, _tables
from ._arguments import Array
from .body import Body
from .errors import UsageError
from .names import Attitude, MethodName, Numbers, Rate, Rows, StrPath

if TYPE_CHECKING:
    import pandas
    from scipy.spatial.transform import Rotation

__all__ = [
    "ExactMotion",
    "ManyMotions",
    "Method",
    "Motion",
    "Phase",
    "exact",
    "exact_many",
    "first_flip_times",
    "methods",
    "simulate",
]


@dataclass(frozen=True)
class Method:
    """An integration method."""

    #: Name, for :func:`simulate` and scenes.
    name: MethodName
    #: Observed order on SO(3); None for the exact solution.
    order: int | None
    #: Whether it chooses its own step sizes.
    adaptive: bool
    #: Whether it conserves the energy to round-off for every step size.
    conserves_energy: bool
    #: Whether a step of -h reverses a step of h, to round-off.
    reversible: bool
    #: Its definition in the specification or the literature.
    source: str
    #: Its description, in one line.
    summary: str


def methods() -> list[Method]:
    """All integration methods: those of the specification in its order, then the others by order."""
    return [
        Method(cast(MethodName, m.name), m.order, m.adaptive, m.conserves_energy, m.reversible, m.source, m.summary)
        for m in _native.methods()
    ]


_DIAGNOSTICS = ("energy", "energy_drift", "orthogonality_error", "momentum_error")


class Motion:
    """A motion at n times, as NumPy arrays, with the given attitude and angular velocity at t = 0.

    ``motion[i]`` is the sample i, and ``motion[a:b]`` the motion at some of the times. The arrays of
    a single sample, also of the motion at a single time, lack the dimension n.
    """

    def __init__(
        self,
        free_body: _native.FreeBody,
        t: Array,
        X: Array,
        omega: Array,
        method: str,
        steps: int = 0,
        evaluations: int = 0,
    ) -> None:
        self._free_body = free_body
        #: Times in s, (n,).
        self.t = t
        #: Attitudes space_from_body, (n, 3, 3): column j of ``X[i]`` is body axis j in space.
        self.X = X
        #: Angular velocity in body axes in rad/s, (n, 3).
        self.omega = omega
        #: Name of the method.
        self.method = method
        #: Number of steps, including rejected ones; 0 for the exact solution.
        self.steps = steps
        #: Number of evaluations of omega; 0 for the exact solution.
        self.evaluations = evaluations

    def __len__(self) -> int:
        return len(self.t)

    def __getitem__(self, index: Any) -> Motion:
        """The motion at some of its times.

        :param index: an integer, a slice, an array of integers, or a mask (n,), as in NumPy.
        :raises IndexError: for an index that an array of n numbers does not have.
        """
        t = np.asarray(np.asarray(self.t)[index], dtype=np.float64)
        if t.ndim > 1:
            raise IndexError("a motion has one dimension")
        X, omega = (np.asarray(array[index], dtype=np.float64) for array in (self.X, self.omega))
        return Motion(self._free_body, t, X, omega, self.method, self.steps, self.evaluations)

    def _summary(self) -> str:
        """The number of samples and their times, such as "61 samples from 0 to 1 s"."""
        if np.ndim(self.t) == 0:
            return f"one sample at {self.t:g} s"
        if len(self) == 0:
            return "no samples"
        return f"{len(self)} samples from {self.t.min():g} to {self.t.max():g} s"

    def __repr__(self) -> str:
        return f"<twrench.Motion: {self._summary()}, {self.method}>"

    def _repr_html_(self) -> str:
        """A table of its properties for notebooks."""
        return _tables.of_properties(
            {
                "motion": self._summary(),
                "method": self.method,
                "largest energy drift": _largest(self.energy_drift),
                "largest momentum error": _largest(self.momentum_error),
                "largest orthogonality error": _largest(self.orthogonality_error),
            }
        )

    def _samples(self) -> tuple[Array, Array, Array]:
        """t, X and omega for native functions, which rely on their shapes: (n,), (n, 3, 3) and
        (n, 3), n = 1 for a single sample. A caller may have replaced them."""
        shape = np.shape(self.t)
        return (
            _contiguous("t", self.t, shape).reshape(-1),
            _contiguous("X", self.X, (*shape, 3, 3)).reshape(-1, 3, 3),
            _contiguous("omega", self.omega, (*shape, 3)).reshape(-1, 3),
        )

    @cached_property
    def _diagnostics(self) -> tuple[Array, ...]:
        _, X, omega = self._samples()
        shape = np.shape(self.t)
        return tuple(each.reshape(shape) for each in _native.diagnose(self._free_body, X, omega))

    @property
    def energy(self) -> Array:
        """Kinetic energy in g cm^2/s^2, (n,)."""
        return self._diagnostics[0]

    @property
    def energy_drift(self) -> Array:
        """Relative drift energy / energy(0) - 1, (n,). If energy is lost, it is no error."""
        return self._diagnostics[1]

    @property
    def orthogonality_error(self) -> Array:
        """Frobenius norm of X^T X - Id, (n,)."""
        return self._diagnostics[2]

    @property
    def momentum_error(self) -> Array:
        """Relative error of the angular momentum, ``|X I omega - L| / |L|`` for a rigid body, (n,)."""
        return self._diagnostics[3]

    @property
    def momentum(self) -> Array:
        """The angular momentum L in space axes in g cm^2/s, (3,), which is constant."""
        return self._free_body.momentum

    def phase(self) -> Phase | None:
        """The rotation about L in one period of the true motion, also of a body with a wheel.

        None if there is no period: for steady motion, on the separatrix, and with energy loss.
        """
        return _phase(self._free_body)

    @cached_property
    def quaternion_xyzw(self) -> Array:
        """X as unit quaternions (x, y, z, w), (n, 4): the order of SciPy, ROS and Eigen's memory.

        The sign of each quaternion is the one nearer to the previous sample.
        """
        return _native.quaternions(self._samples()[1]).reshape(*np.shape(self.t), 4)

    @property
    def quaternion_wxyz(self) -> Array:
        """X as unit quaternions (w, x, y, z), (n, 4): the order of most of the literature."""
        return np.roll(self.quaternion_xyzw, 1, axis=-1)

    @property
    def rotation(self) -> Rotation:
        """X as n rotations of SciPy. Raises ImportError if SciPy is not installed."""
        from scipy.spatial.transform import Rotation

        return Rotation.from_quat(self.quaternion_xyzw)

    def euler(self, sequence: str, degrees: bool = False) -> Array:
        """X as Euler angles in rad, (n, 3), by SciPy's ``Rotation.as_euler``.

        :param sequence: three axes: in capital letters, such as ``"ZYX"``, they turn with the body;
            in lower case, such as ``"zyx"``, they are the fixed axes of space.
        :param degrees: whether the angles are in degrees.
        :raises UsageError: for an invalid ``sequence``.

        Raises ImportError if SciPy is not installed.
        """
        axes = _arguments.euler_sequence("sequence", sequence)
        return np.asarray(self.rotation.as_euler(axes, bool(degrees)), dtype=np.float64)

    def save(self, path: StrPath, *, overwrite: bool = False) -> Path:
        """Writes the motion to a file, complete or not at all, and returns its path.

        :param path: ``.csv`` as ``twrench simulate`` writes it, or ``.npz`` with the arrays ``t``,
            ``X``, ``omega``, ``energy``, ``energy_drift``, ``orthogonality_error`` and
            ``momentum_error``.
        :param overwrite: replace an existing file that twrench did not write, or that is of another kind.
        :raises UsageError: for another ending.
        :raises FileError: if the file cannot be written.
        :raises OverwriteError: if another file would be replaced.
        """
        file = Path(_arguments.path("path", path))
        output = _native.Output("motion", file, [], bool(overwrite), "")
        if output.format == "csv":
            _native.write_samples(output, self._free_body, *self._samples())
        else:
            bytes_of_file = io.BytesIO()
            diagnostics = {name: getattr(self, name) for name in _DIAGNOSTICS}
            np.savez(bytes_of_file, t=self.t, X=self.X, omega=self.omega, **diagnostics)
            _native.write_output(output, bytes_of_file.getvalue())
        return file

    def to_dataframe(self) -> pandas.DataFrame:
        """A pandas DataFrame: t, X11 to X33, omega_x to omega_z, energy and the three errors.

        Columns have the units of the attributes. Raises ImportError if pandas is not installed.
        """
        import pandas

        t, X, omega = self._samples()
        columns: dict[str, Any] = {"t": t}
        for i in range(3):
            for j in range(3):
                columns[f"X{i + 1}{j + 1}"] = X[:, i, j]
        for i, axis in enumerate("xyz"):
            columns[f"omega_{axis}"] = omega[:, i]
        for name in _DIAGNOSTICS:
            columns[name] = getattr(self, name).reshape(-1)
        return pandas.DataFrame(columns)


def _largest(errors: Array) -> str:
    return f"{np.abs(errors).max():.1e}" if errors.size else "none"


def _contiguous(name: str, value: Any, shape: tuple[int, ...]) -> Array:
    try:
        array = np.asarray(value, dtype=np.float64, order="C")
    except (TypeError, ValueError) as error:
        raise UsageError(f"{name}: must be an array, not {_arguments.brief(value)}") from error
    if array.shape != shape:
        raise UsageError(f"{name}: must have the shape {shape}, not {array.shape}")
    return array


def _free_body(
    body: Body,
    omega: Numbers,
    attitude: Attitude | None = None,
    wheel: Numbers | None = None,
    energy_loss_time: float | None = None,
) -> _native.FreeBody:
    _arguments.instance("body", body, Body)
    loses_none = isinstance(energy_loss_time, float) and energy_loss_time == math.inf
    return _native.FreeBody(
        body.inertia,
        _arguments.vector("omega", omega),
        np.eye(3) if attitude is None else _arguments.attitude("attitude", attitude),
        np.zeros(3) if wheel is None else _arguments.vector("wheel", wheel),
        math.inf
        if energy_loss_time is None or loses_none
        else _arguments.positive("energy_loss_time", energy_loss_time),
    )


def simulate(
    body: Body,
    omega: Numbers,
    times: Numbers | float | None = None,
    method: MethodName | None = None,
    *,
    span: Numbers | None = None,
    fps: Rate | None = None,
    attitude: Attitude | None = None,
    wheel: Numbers | None = None,
    energy_loss_time: float | None = None,
    step: float = 0.01,
    tolerance: float = 1e-10,
    max_steps: int = 50_000_000,
) -> Motion:
    """The free motion of a body, sampled at exactly the given times.

    :param body: the body.
    :param omega: angular velocity at t = 0 in body axes in rad/s, (3,).
    :param times: times in s, (n,), in any order and of either sign; or a single one.
    :param method: name of one of :func:`methods`; None for ``exact``, or ``taylor`` for a body with
        a wheel or energy loss.
    :param span: in place of ``times``, (start, end) in s, both of which are sampled.
    :param fps: samples per second of ``span``, also as a fraction; 60 unless given.
    :param attitude: X(0), space_from_body: a quaternion (w, x, y, z), a matrix (3, 3) or a SciPy
        ``Rotation``; None for the identity.
    :param wheel: angular momentum of a wheel relative to the body, in body axes in g cm^2/s, (3,).
    :param energy_loss_time: time constant in s with which internal friction damps a small wobble
        about the axis of greatest moment; None or infinity if no energy is lost.
    :param step: step size in s of a method with fixed steps; the first step of an adaptive one.
    :param tolerance: error tolerance of an adaptive method, per step.
    :param max_steps: maximum number of steps.
    :raises UsageError: for a wrong argument.
    :raises MotionError: if the method fails, for example because the step is too long.

    Each sample depends only on its own time, bit for bit, and not on the other times. The function
    runs without Python's global lock, and Ctrl-C interrupts it at once.
    """
    free_body = _free_body(body, omega, attitude, wheel, energy_loss_time)
    t = _arguments.times(times, span, fps)
    own = "exact" if free_body.is_rigid else "taylor"
    name = own if method is None else _arguments.text("method", method)
    X, velocity, steps, evaluations, note = _native.integrate(
        free_body,
        name,
        _arguments.positive("step", step),
        _arguments.positive("tolerance", tolerance),
        _arguments.whole("max_steps", max_steps, 1, 2**62),
        t.reshape(-1),
    )
    X, velocity = X.reshape(*t.shape, 3, 3), velocity.reshape(*t.shape, 3)
    if note:
        warnings.warn(note, stacklevel=2)
    return Motion(free_body, t, X, velocity, name, steps, evaluations)


@dataclass(frozen=True)
class Phase:
    """The rotation of a body about L in one period of its momentum in body axes.

    ``X(period) X(0)^T`` is a rotation about L by ``total``, which is not reduced modulo 2 pi.
    """

    #: Period T of the momentum in body axes, in s.
    period: float
    #: Angle about L in rad.
    total: float
    #: The integral of omega . m / \|m\| in rad: 2 E T / \|L\| for a rigid body.
    dynamic: float

    @property
    def geometric(self) -> float:
        """``total - dynamic`` in rad, which depends only on the path of the momentum: minus the area
        on the unit sphere that the path of its direction encloses."""
        return self.total - self.dynamic


def _phase(free_body: _native.FreeBody) -> Phase | None:
    phase = free_body.phase()
    return Phase(phase.period, phase.total, phase.dynamic) if phase else None


class ExactMotion:
    """The free motion of a body in closed form, at a cost that does not depend on t.

    :param body: the body; it may be symmetric or a sphere.
    :param omega: angular velocity at t = 0 in body axes in rad/s, (3,).
    :param attitude: X(0), in any form that :func:`simulate` accepts; None for the identity.
    :raises UsageError: for a wrong argument.

    The error of X grows as 1e-16 ``|omega| t``, and beyond that only as fast as the motion itself
    amplifies such an error of its start. ``docs/exact.md`` derives the closed form, with its sources.
    """

    def __init__(self, body: Body, omega: Numbers, *, attitude: Attitude | None = None) -> None:
        self._free_body = _free_body(body, omega, attitude)
        self._native = _native.ExactMotion(self._free_body)

    def __getstate__(self) -> dict[str, Any]:
        return {"_free_body": self._free_body}

    def __setstate__(self, state: dict[str, Any]) -> None:
        free_body = state.get("_free_body") if isinstance(state, dict) else None
        if not isinstance(free_body, _native.FreeBody):
            raise UsageError("the pickled motion: is damaged", "pickle the object again")
        self._free_body, self._native = free_body, _native.ExactMotion(free_body)

    def __repr__(self) -> str:
        if math.isnan(self.first_flip):
            return f"<twrench.ExactMotion: {self.kind}, without flips>"
        what = "flips" if self.turns_over else "wobbles through the plane normal to L"
        if not math.isfinite(self.flip_interval):
            return f"<twrench.ExactMotion: {self.kind}, {what} once, at {self.first_flip:.6g} s>"
        return (
            f"<twrench.ExactMotion: {self.kind}, {what} every {self.flip_interval:.6g} s, "
            f"first at {self.first_flip:.6g} s>"
        )

    def at(
        self,
        times: Numbers | float | None = None,
        *,
        span: Numbers | None = None,
        fps: Rate | None = None,
    ) -> Motion:
        """The motion at given times, in any order and of either sign.

        :param times: times in s, (n,); or a single one, whose arrays lack that dimension.
        :param span: instead of ``times``, (start, end) in s, both of which are sampled.
        :param fps: samples per second of ``span``, also as a fraction; 60 unless given.
        :raises UsageError: for times of another shape, or times that are not finite.
        """
        t = _arguments.times(times, span, fps)
        X, omega = self._native.at(t.reshape(-1))
        X, omega = X.reshape(*t.shape, 3, 3), omega.reshape(*t.shape, 3)
        return Motion(self._free_body, t, X, omega, "exact")

    def flip_times(self, t_end: float) -> Array:
        """The times in s, ascending, of all flips with 0 < t <= ``t_end``.

        At a flip the component of omega along the intermediate axis changes its sign.

        :raises UsageError: for a ``t_end`` that is not finite.
        :raises MotionError: if there are more than 10^7.
        """
        return self._native.flip_times(_arguments.number("t_end", t_end))

    @property
    def kind(self) -> str:
        """How the momentum moves in the body.

        ``about_least`` or ``about_greatest``: it circles the axis of the least or greatest moment.
        ``separatrix``: it tends to the intermediate axis. ``steady``: it does not move.
        """
        return self._native.kind

    @property
    def flip_interval(self) -> float:
        """Time between flips in s; infinite on the separatrix, NaN if there are no flips.

        A steady motion has no flips, nor does a body with two moments that are equal to 1e-4,
        which has no intermediate axis.
        """
        flips = self._native.flips
        return flips.interval if flips else math.nan

    @property
    def first_flip(self) -> float:
        """Time of the first flip after t = 0 in s; infinite if none comes, NaN as above."""
        flips = self._native.flips
        return flips.first if flips else math.nan

    @property
    def swing(self) -> float:
        """The angle in rad through which the intermediate axis swings; 0 if there are no flips.

        Near pi the body turns over, as the T-handle does; near 0 it wobbles about a stable axis.
        """
        flips = self._native.flips
        return flips.swing if flips else 0.0

    @property
    def turns_over(self) -> bool:
        """Whether the intermediate axis swings through at least 120 degrees."""
        flips = self._native.flips
        return flips is not None and flips.turns_over

    def phase(self) -> Phase | None:
        """The rotation about L in one period; None for steady motion and on the separatrix."""
        return _phase(self._free_body)


def exact(body: Body, omega: Numbers, *, attitude: Attitude | None = None) -> ExactMotion:
    """The exact motion of ``body``, whose angular velocity at t = 0 is ``omega``.

    The arguments, including ``attitude``, and the errors are those of :class:`ExactMotion`.
    """
    return ExactMotion(body, omega, attitude=attitude)


class ManyMotions:
    """The exact motions of n bodies at m times. See :func:`exact_many`."""

    def __init__(self, t: Array, X: Array, omega: Array) -> None:
        #: Times in s, (m,).
        self.t = t
        #: Attitudes space_from_body, (n, m, 3, 3).
        self.X = X
        #: Angular velocities in principal axes in rad/s, (n, m, 3).
        self.omega = omega

    def __len__(self) -> int:
        return len(self.X)

    def __repr__(self) -> str:
        times = "one time" if self.t.ndim == 0 else f"{len(self.t)} times"
        return f"<twrench.ManyMotions: {len(self)} bodies at {times}>"


def _many(inertia: Numbers | Rows, omega: Rows) -> tuple[Array, Array]:
    velocities = _arguments.vectors("omega", omega)
    if np.ndim(inertia) == 1:
        return _arguments.vector("inertia", inertia), velocities
    moments = _arguments.vectors("inertia", inertia)
    if len(moments) != len(velocities):
        raise UsageError(
            f"inertia: must have as many rows as omega, {len(velocities)}, not {len(moments)}"
        )
    return moments, velocities


def exact_many(
    inertia: Numbers | Rows,
    omega: Rows,
    times: Numbers | float | None = None,
    *,
    span: Numbers | None = None,
    fps: Rate | None = None,
) -> ManyMotions:
    """The exact motions of many bodies at once, on all processors.

    :param inertia: principal moments in g cm^2, (n, 3), or (3,) if all n bodies have the same. The
        body axes are the principal axes.
    :param omega: angular velocities at t = 0 in body axes in rad/s, (n, 3).
    :param times: times in s, (m,), in any order and of either sign; or a single one, whose arrays
        lack that dimension.
    :param span: in place of ``times``, (start, end) in s, both of which are sampled.
    :param fps: samples per second of ``span``, also as a fraction; 60 unless given.
    :raises UsageError: for a wrong argument; the message names the argument and its row.

    Each sample is bit-identical to that of ``exact(body, omega).at(times)``.
    """
    moments, velocities = _many(inertia, omega)
    t = _arguments.times(times, span, fps)
    X, result = _native.exact_many(moments, velocities, t.reshape(-1))
    n = len(velocities)
    return ManyMotions(t, X.reshape(n, *t.shape, 3, 3), result.reshape(n, *t.shape, 3))


def first_flip_times(inertia: Numbers | Rows, omega: Rows) -> Array:
    """The time in s of each body's first flip after t = 0, (n,); infinite if there is none.

    The arguments, ``inertia`` and ``omega``, and the errors are those of :func:`exact_many`.
    """
    return _native.first_flip_times(*_many(inertia, omega))
