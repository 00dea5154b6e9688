"""Comparison of methods with the exact solution."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Sequence

import numpy as np

from . import _arguments, _native, _tables
from ._arguments import Array
from .body import Body
from .motion import _free_body
from .names import Attitude, MethodName, Numbers, StrPath

if TYPE_CHECKING:
    import pandas

__all__ = ["MethodStudy", "Study", "StudyRun", "study"]


@dataclass(frozen=True)
class StudyRun:
    """One run of a method, compared with the exact solution."""

    #: Name of the method.
    method: str
    #: Step size in s; for an adaptive method, the mean of the accepted steps.
    step: float
    #: Tolerance of an adaptive method; otherwise None.
    tolerance: float | None
    #: Why the method failed; if not empty, the errors below are 0.
    failure: str
    #: Frobenius norm of X - X_exact at the end.
    error: float
    #: The same norm at :attr:`Study.early`.
    early_error: float
    #: Largest relative energy drift of all steps.
    energy_drift: float
    #: Largest Frobenius norm of X^T X - Id of all steps.
    orthogonality_error: float
    #: Largest relative error of the angular momentum of all steps.
    momentum_error: float
    #: Largest error of a flip time in s; NaN if there are no flips.
    flip_error: float
    #: Times in s of the flips in the method's own solution.
    flip_times: Array
    #: Number of steps, including rejected ones.
    steps: int
    #: Number of evaluations of omega.
    evaluations: int
    #: Processor time in s for computing the state at the end.
    cpu_seconds: float


@dataclass(frozen=True)
class MethodStudy:
    """All runs of a method."""

    #: Name of the method.
    method: str
    #: Slope of the early error over the step size in logarithms; None if it cannot be measured.
    order: float | None
    #: The runs, in the order of the steps or tolerances.
    runs: list[StudyRun]


@dataclass(frozen=True)
class Study:
    """The results of :func:`study`."""

    #: Duration of the motion in s.
    duration: float
    #: Time in s at which orders are measured: after about 10 rad of rotation.
    early: float
    #: The method with which the others are compared: ``exact``, or ``taylor`` at its tightest
    #: tolerance if the motion has no closed form.
    reference: str
    #: Times in s of the flips of the reference; none if energy is lost.
    flip_times: Array
    #: Results by the name of the method.
    methods: dict[str, MethodStudy]

    def to_dataframe(self) -> pandas.DataFrame:
        """A pandas DataFrame with a row for each run, and the fields of :class:`StudyRun`.

        Raises ImportError if pandas is not installed.
        """
        import pandas

        return pandas.DataFrame([vars(run) for of in self.methods.values() for run in of.runs])


    def _repr_html_(self) -> str:
        """A table for notebooks: the order of each method, and its most accurate run."""
        return _tables.of_rows(
            ("method", "order", "step", "error", "energy drift", "evaluations"),
            [_row(of) for of in self.methods.values()],
        )


def _row(of: MethodStudy) -> list[str]:
    order = "" if of.order is None else f"{of.order:.2f}"
    succeeded = [run for run in of.runs if not run.failure]
    if not succeeded:
        return [of.method, order, *(run.failure for run in of.runs[:1])]
    best = min(succeeded, key=lambda run: run.error)
    return [
        of.method,
        order,
        f"{best.step:.3g} s",
        f"{best.error:.1e}",
        f"{best.energy_drift:.1e}",
        str(best.evaluations),
    ]


def _run(method: str, run: _native.StudyRun) -> StudyRun:
    return StudyRun(
        method=method,
        step=run.step,
        tolerance=run.tolerance,
        failure=run.failure,
        error=run.error,
        early_error=run.early_error,
        energy_drift=run.energy_drift,
        orthogonality_error=run.orthogonality_error,
        momentum_error=run.momentum_error,
        flip_error=run.flip_error,
        flip_times=np.array(run.flip_times),
        steps=run.steps,
        evaluations=run.evaluations,
        cpu_seconds=run.cpu_seconds,
    )


def study(
    body: Body,
    omega: Numbers,
    methods: Sequence[MethodName] | None = None,
    *,
    duration: float,
    steps: Numbers = (0.08, 0.04, 0.02, 0.01),
    tolerances: Numbers = (1e-4, 1e-6, 1e-8, 1e-10),
    attitude: Attitude | None = None,
    wheel: Numbers | None = None,
    energy_loss_time: float | None = None,
    plot: StrPath | None = None,
    overwrite: bool = False,
) -> Study:
    """Runs methods over a ladder of step sizes, or tolerances, and compares them with the exact motion.

    Where there is no closed form, ``taylor`` at its tightest tolerance replaces the exact motion.

    :param body: the body.
    :param omega: angular velocity at t = 0 in body axes in rad/s, (3,).
    :param methods: names of methods; None for all that can compute the motion.
    :param duration: duration of the motion in s.
    :param steps: step sizes in s of the methods with fixed steps, (n,).
    :param tolerances: error tolerances of the adaptive methods, (m,).
    :param attitude: X(0), in any form that :func:`simulate` accepts; None for the identity.
    :param wheel: angular momentum of a wheel relative to the body, in body axes in g cm^2/s, (3,).
    :param energy_loss_time: time constant in s with which internal friction damps a small wobble
        about the axis of greatest moment; None or infinity if no energy is lost.
    :param plot: a file, .svg, .pdf or .png, for a plot of order, work-precision and energy drift,
        which gnuplot draws; None for no plot. :func:`plots.study` draws with Matplotlib.
    :param overwrite: let ``plot`` replace a file that twrench did not write, or that is of another
        kind.
    :raises UsageError: for a wrong argument. If a method fails, its run has a ``failure`` instead.
    :raises FileError: if the plot cannot be written.
    :raises OverwriteError: if another file would be replaced.
    :raises Error: if gnuplot is needed, but is missing or fails.
    """
    free_body = _free_body(body, omega, attitude, wheel, energy_loss_time)
    if methods is None:
        all_names = [of.name for of in _native.methods()]
        names = [name for name in all_names if free_body.has_closed_form or name != "exact"]
    else:
        names = _arguments.sequence("methods", methods, "a list of names")
    output = None
    if plot is not None:
        file = Path(_arguments.path("plot", plot))
        output = _native.Output("plot", file, [], bool(overwrite), "")
    result = _native.study(
        free_body,
        [_arguments.text("methods", name) for name in names],
        list(_arguments.array("steps", steps, (None,), "a one-dimensional array of steps in s")),
        list(_arguments.array("tolerances", tolerances, (None,), "a one-dimensional array")),
        _arguments.positive("duration", duration),
        output,
    )
    by_method = {
        of.method: MethodStudy(of.method, of.order, [_run(of.method, run) for run in of.runs])
        for of in result.methods
    }
    return Study(
        result.duration, result.early, result.reference, np.array(result.flip_times), by_method
    )
