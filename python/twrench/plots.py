"""Figures of motions for Matplotlib. Each function draws into axes that the caller made.

The curves are those of the film, computed by the same code, and so are the colours.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from . import _arguments, _native
from ._arguments import Array
from .body import Body
from .errors import UsageError
from .motion import Motion
from .names import ThemeName
from .study import Study

__all__ = ["components", "momentum_sphere", "study"]


def momentum_sphere(
    ax: Any,
    body: Body,
    motion: Motion | None = None,
    *,
    levels: int = 4,
    theme: ThemeName = "paper",
) -> None:
    """Draws the sphere on which the direction of the angular momentum moves, seen from the body.

    The axes of the picture are the principal axes of ``body``, by ascending moment. The thin curves
    have constant energy; the bold curve is the separatrix, which leads through the intermediate axis.

    :param ax: three-dimensional axes, such as ``figure.add_subplot(projection="3d")``.
    :param body: the body.
    :param motion: a motion of ``body`` whose path is drawn; None draws the curves alone.
    :param levels: number of curves around each end of a stable axis, 0 to 100.
    :param theme: the theme whose colours are used.
    :raises UsageError: for ``ax`` with two dimensions, and for values of a wrong type or size.
    """
    if not hasattr(ax, "plot_wireframe"):
        raise UsageError('ax: must be three-dimensional; make it with projection="3d"')
    _arguments.instance("body", body, Body)
    moments = body.principal_moments
    colors = _native.theme_colors(_arguments.text("theme", theme))
    count = _arguments.whole("levels", levels, 0, 100)
    longitude, latitude = np.meshgrid(
        np.linspace(0, 2 * np.pi, 49), np.linspace(-np.pi / 2, np.pi / 2, 25), indexing="ij"
    )
    across = np.cos(latitude)
    ax.plot_surface(
        0.98 * across * np.cos(longitude),
        0.98 * across * np.sin(longitude),
        0.98 * np.sin(latitude),
        color=colors["plane"],
        alpha=0.15,
        linewidth=0,
    )
    for axis, points in _native.level_curves(moments, count):
        ax.plot(*points.T, color=colors["axes"][axis], linewidth=0.8)
    for points in _native.separatrix_curves(moments):
        ax.plot(*points.T, color=colors["text"], linewidth=1.4)
    if motion is not None:
        ax.plot(*_path(body, motion).T, color=colors["momentum"], linewidth=2)
    for i, name in enumerate(("least", "intermediate", "greatest")):
        end = 1.25 * np.eye(3)[i]
        ax.plot(*np.array([0.98 * np.eye(3)[i], end]).T, color=colors["axes"][i], linewidth=2)
        ax.text(*(1.1 * end), name, color=colors["axes"][i], ha="center", va="center")
    ax.set(xlim=(-1, 1), ylim=(-1, 1), zlim=(-1, 1))
    ax.set_box_aspect((1, 1, 1), zoom=1.4)
    ax.view_init(elev=20, azim=55)  # towards the saddle at the intermediate axis
    ax.set_axis_off()


def _path(body: Body, motion: Motion) -> Array:
    """The directions of the momentum in principal axes, (n, 3)."""
    _arguments.instance("motion", motion, Motion)
    momentum = motion.omega @ body.inertia @ body.principal_axes
    size = np.linalg.norm(momentum, axis=1, keepdims=True)
    if not (size > 0).all():
        raise UsageError("motion: is at rest, and its momentum has no direction")
    path: Array = momentum / size
    return path


def components(axes: Any, motion: Motion, *, theme: ThemeName = "paper") -> None:
    """Draws the nine components of X over time.

    :param axes: an array of axes: (3, 3), one for each component, or (3,), one for each column of X.
    :param motion: the motion.
    :param theme: the theme whose colours are used.
    :raises UsageError: for another number of axes, and for values of a wrong type.
    """
    panels = np.asarray(axes, dtype=object)
    if panels.shape not in ((3, 3), (3,)):
        raise UsageError("axes: must be an array of (3, 3) or (3,) axes, as plt.subplots makes them")
    _arguments.instance("motion", motion, Motion)
    draw_components(panels, motion.t, motion.X, _arguments.text("theme", theme))


def draw_components(panels: Any, t: Array, X: Array, theme: str, *, dashed: bool = False) -> None:
    """The same for times (n,) and attitudes (n, 3, 3). Dashed lines have no names."""
    colors = _native.theme_colors(theme)["components"]
    for i in range(3):
        for j in range(3):
            panel = panels[i, j] if panels.ndim == 2 else panels[j]
            label = None if dashed else f"x{i + 1}{j + 1}"
            line = "--" if dashed else "-"
            panel.plot(t, X[:, i, j], line, color=colors[3 * i + j], linewidth=1, label=label)
            panel.legend(loc="upper right", fontsize="small")
    for panel in panels.reshape(-1, 3)[-1]:
        panel.set_xlabel("t [s]")


def study(ax: Any, result: Study) -> None:
    """Draws the error of X at the end over the step size, in logarithms, a line for each method.

    The slope of a line is the order of its method. Runs that failed are left out.

    :param ax: axes.
    :param result: what :func:`twrench.study` returned.
    :raises UsageError: for values of a wrong type.
    """
    _arguments.instance("result", result, Study)
    for name, method in result.methods.items():
        runs = [run for run in method.runs if not run.failure and run.error > 0]
        label = name if method.order is None else f"{name}: order {method.order:.2f}"
        ax.loglog([run.step for run in runs], [run.error for run in runs], "o-", label=label)
    ax.set_xlabel("step [s]")
    ax.set_ylabel(f"error of X at {result.duration:g} s")
    ax.legend(fontsize="small")
