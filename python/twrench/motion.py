"""The torque-free motion of a rigid body: integrated by a method, or exact."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from . import _arguments, _native
from ._arguments import Array
from .body import Body
from .errors import UsageError

if TYPE_CHECKING:
    import pandas

__all__ = [
    "ExactMotion",
    "ManyMotions",
    "Method",
    "Motion",
    "exact",
    "exact_many",
    "first_flip_times",
    "methods",
    "simulate",
]


@dataclass(frozen=True)
class Method:
    """An integration method."""

    #: Name, as :func:`simulate` and scenes take it.
    name: str
    #: Order that is observed on SO(3); None for the exact solution.
    order: int | None
    #: Whether it chooses its own step sizes.
    adaptive: bool
    #: Whether it conserves the energy to round-off for every step size.
    conserves_energy: bool
    #: Whether a step of -h undoes a step of h, to round-off.
    reversible: bool
    #: Where the specification or the literature defines it.
    source: str
    #: What it is, in a line.
    summary: str


def methods() -> list[Method]:
    """All integration methods: those of the specification in its order, then the others by order."""
    return [
        Method(m.name, m.order, m.adaptive, m.conserves_energy, m.reversible, m.source, m.summary)
        for m in _native.methods()
    ]


class Motion:
    """A motion at n times, as NumPy arrays, with X = Id and angular velocity ``omega`` at t = 0."""

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

    def __repr__(self) -> str:
        if len(self) == 0:
            return f"<twrench.Motion: no samples, {self.method}>"
        return (
            f"<twrench.Motion: {len(self)} samples from {self.t.min():g} to {self.t.max():g} s, "
            f"{self.method}>"
        )

    @cached_property
    def _diagnostics(self) -> tuple[Array, ...]:
        X, omega = np.ascontiguousarray(self.X), np.ascontiguousarray(self.omega)
        return tuple(_native.diagnose(self._free_body, X, omega))

    @property
    def energy(self) -> Array:
        """Kinetic energy in g cm^2/s^2, (n,)."""
        return self._diagnostics[0]

    @property
    def energy_drift(self) -> Array:
        """Relative drift energy / energy(0) - 1, (n,)."""
        return self._diagnostics[1]

    @property
    def orthogonality_error(self) -> Array:
        """Frobenius norm of X^T X - Id, (n,)."""
        return self._diagnostics[2]

    @property
    def momentum_error(self) -> Array:
        """Relative error ``|X I omega - L| / |L|`` of the angular momentum, (n,)."""
        return self._diagnostics[3]

    @property
    def momentum(self) -> Array:
        """The angular momentum L in space axes in g cm^2/s, (3,), which is constant."""
        return self._free_body.momentum

    @cached_property
    def quaternion_xyzw(self) -> Array:
        """X as unit quaternions (x, y, z, w), (n, 4): the order of SciPy, ROS and Eigen's memory.

        Of the two signs, each sample has the one nearer to the sample before.
        """
        return _native.quaternions(np.ascontiguousarray(self.X))

    @property
    def quaternion_wxyz(self) -> Array:
        """X as unit quaternions (w, x, y, z), (n, 4): the order of most of the literature."""
        return np.roll(self.quaternion_xyzw, 1, axis=1)

    def to_dataframe(self) -> pandas.DataFrame:
        """A pandas DataFrame: t, X11 to X33, omega_x to omega_z, energy and the three errors.

        Columns have the units of the attributes. Raises ImportError where there is no pandas.
        """
        import pandas

        columns: dict[str, Any] = {"t": self.t}
        for i in range(3):
            for j in range(3):
                columns[f"X{i + 1}{j + 1}"] = self.X[:, i, j]
        for i, axis in enumerate("xyz"):
            columns[f"omega_{axis}"] = self.omega[:, i]
        for name in ("energy", "energy_drift", "orthogonality_error", "momentum_error"):
            columns[name] = getattr(self, name)
        return pandas.DataFrame(columns)


def _free_body(body: Body, omega: ArrayLike) -> _native.FreeBody:
    if not isinstance(body, Body):
        raise UsageError(f"body: must be a twrench.Body, not {_arguments.brief(body)}")
    return _native.FreeBody(body.inertia, _arguments.vector("omega", omega))


def simulate(
    body: Body,
    omega: ArrayLike,
    times: ArrayLike,
    method: str = "exact",
    *,
    step: float = 0.01,
    tolerance: float = 1e-10,
    max_steps: int = 50_000_000,
) -> Motion:
    """The free motion of a body, sampled at exactly the given times.

    :param body: the body.
    :param omega: angular velocity at t = 0 in body axes in rad/s, (3,).
    :param times: times in s, (n,), in any order and of either sign.
    :param method: name of one of :func:`methods`.
    :param step: step size in s of a method of fixed steps; of an adaptive one, the first.
    :param tolerance: error tolerance of an adaptive method, per step.
    :param max_steps: number of steps after which it gives up.
    :raises UsageError: for a wrong argument.
    :raises MotionError: where the method fails, for a step that is too long, say.

    A sample depends on its own time alone, bit for bit, and not on the other times. Without Python's
    lock, and ends within a moment at Ctrl-C.
    """
    free_body = _free_body(body, omega)
    t = _arguments.times("times", times)
    name = _arguments.text("method", method)
    X, velocity, steps, evaluations = _native.integrate(
        free_body,
        name,
        _arguments.positive("step", step),
        _arguments.positive("tolerance", tolerance),
        _arguments.whole("max_steps", max_steps, 1, 2**62),
        t,
    )
    return Motion(free_body, t, X, velocity, name, steps, evaluations)


class ExactMotion:
    """The free motion of a body in closed form, at a cost that does not depend on t.

    :param body: the body; symmetric ones and spheres as well.
    :param omega: angular velocity at t = 0 in body axes in rad/s, (3,).
    :raises UsageError: for a wrong argument.

    The error of X grows as 1e-16 ``|omega| t``, and beyond that only as fast as the motion itself
    amplifies such an error of its start. ``docs/exact.md`` derives it, with its sources.
    """

    def __init__(self, body: Body, omega: ArrayLike) -> None:
        self._free_body = _free_body(body, omega)
        self._native = _native.ExactMotion(self._free_body)

    def at(self, times: ArrayLike) -> Motion:
        """The motion at ``times`` in s, (n,), in any order and of either sign.

        :raises UsageError: for times of another shape, or that are not finite.
        """
        t = _arguments.times("times", times)
        X, omega = self._native.at(t)
        return Motion(self._free_body, t, X, omega, "exact")

    def flip_times(self, t_end: float) -> Array:
        """The times in s, ascending, of all flips with 0 < t <= ``t_end``.

        At a flip the component of omega along the intermediate axis changes its sign.

        :raises UsageError: for a ``t_end`` that is not finite.
        :raises MotionError: where there are more than 10^7.
        """
        return self._native.flip_times(_arguments.number("t_end", t_end))

    @property
    def kind(self) -> str:
        """How the momentum moves in the body.

        It circles the axis of least or greatest moment: ``about_least`` or ``about_greatest``; or
        tends to the intermediate axis: ``separatrix``; or stays: ``steady``.
        """
        return self._native.kind

    @property
    def flip_interval(self) -> float:
        """Time between flips in s; infinite on the separatrix, NaN where there are no flips.

        Steady motion has none, nor has a symmetric body, which has no intermediate axis.
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
        """The angle in rad through which the intermediate axis swings; 0 where there are no flips.

        Near pi the body turns over, as the T-handle does; near 0 it wobbles about a stable axis.
        """
        flips = self._native.flips
        return flips.swing if flips else 0.0

    @property
    def turns_over(self) -> bool:
        """Whether the intermediate axis swings through at least a right angle."""
        flips = self._native.flips
        return flips is not None and flips.turns_over


def exact(body: Body, omega: ArrayLike) -> ExactMotion:
    """The exact motion of ``body``, whose angular velocity at t = 0 is ``omega``.

    The arguments and errors are those of :class:`ExactMotion`.
    """
    return ExactMotion(body, omega)


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
        return f"<twrench.ManyMotions: {len(self)} bodies at {len(self.t)} times>"


def _many(inertia: ArrayLike, omega: ArrayLike) -> tuple[Array, Array]:
    velocities = _arguments.vectors("omega", omega)
    if np.ndim(inertia) == 1:
        return _arguments.vector("inertia", inertia), velocities
    moments = _arguments.vectors("inertia", inertia)
    if len(moments) != len(velocities):
        raise UsageError(
            f"inertia: must have as many rows as omega, {len(velocities)}, not {len(moments)}"
        )
    return moments, velocities


def exact_many(inertia: ArrayLike, omega: ArrayLike, times: ArrayLike) -> ManyMotions:
    """The exact motions of many bodies at once, on all processors.

    :param inertia: principal moments in g cm^2, (n, 3), or (3,) for n bodies alike. The body axes
        are the principal axes.
    :param omega: angular velocities at t = 0 in body axes in rad/s, (n, 3).
    :param times: times in s, (m,), in any order and of either sign.
    :raises UsageError: for a wrong argument, which it names with its row.

    Each sample has the bits that ``exact(body, omega).at(times)`` gives.
    """
    moments, velocities = _many(inertia, omega)
    t = _arguments.times("times", times)
    X, result = _native.exact_many(moments, velocities, t)
    return ManyMotions(t, X, result)


def first_flip_times(inertia: ArrayLike, omega: ArrayLike) -> Array:
    """The time in s of each body's first flip after t = 0, (n,), infinite where there is none.

    The arguments, ``inertia`` and ``omega``, and the errors are those of :func:`exact_many`.
    """
    return _native.first_flip_times(*_many(inertia, omega))
