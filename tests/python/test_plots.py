"""Figures for Matplotlib: the lines are right, whatever version draws them."""

from __future__ import annotations

import numpy as np
import pytest

import twrench
from twrench import plots

pytest.importorskip("matplotlib")
from matplotlib.figure import Figure  # noqa: E402


def sphere_lines(body, motion=None, **arguments):
    ax = Figure().add_subplot(projection="3d")
    plots.momentum_sphere(ax, body, motion, **arguments)
    return [np.array(line.get_data_3d()).T for line in ax.lines]


@pytest.mark.parametrize("scale", [1e-6, 1, 1e6])  # the size of the body
def test_the_curves_of_the_sphere_have_constant_energy(scale):
    moments = scale**5 * np.array([2, 3, 5])
    body = twrench.Body(moments=moments)
    motion = twrench.exact(body, [1, 0.3, 0.2]).at(np.linspace(0, 30, 400))
    lines = sphere_lines(body, motion, levels=3)
    assert len(lines) == 4 * 3 + 2 + 1 + 3  # curves, separatrix, path, axes
    for points in lines[:-3]:
        assert np.linalg.norm(points, axis=1) == pytest.approx(1, abs=1e-12)
        energies = (points**2 / moments).sum(axis=1) * moments[0]
        assert np.ptp(energies) < 1e-12
    for points in lines[12:14]:  # the separatrix has the energy of the intermediate axis
        assert (points[0] ** 2 / moments).sum() == pytest.approx(1 / moments[1], rel=1e-12)
        assert np.abs(points[:, 1]).max() == pytest.approx(1, abs=1e-12)


def test_the_path_is_in_principal_axes():
    body = twrench.Body(inertia=[3, 4, 5, 0.4, -0.2, 0.3])
    motion = twrench.exact(body, [1, 0.3, 0.2]).at(np.linspace(0, 30, 100))
    path = sphere_lines(body, motion, levels=0)[2]
    energies = (path**2 / body.principal_moments).sum(axis=1)
    assert np.ptp(energies) < 1e-12
    in_body = motion.omega @ body.inertia
    assert np.linalg.norm(in_body, axis=1) == pytest.approx(np.linalg.norm(motion.momentum))
    back = path @ body.principal_axes.T * np.linalg.norm(motion.momentum)
    assert back == pytest.approx(in_body, abs=1e-12)


@pytest.mark.parametrize("moments", [(1, 1, 1.5), (1, 1.5, 1.5), (1, 1, 1)])
def test_symmetric_bodies_have_no_separatrix(moments):
    lines = sphere_lines(twrench.Body(moments=moments), levels=2)
    assert len(lines) == (0 if len(set(moments)) == 1 else 4) + 3


def test_the_components_are_those_of_the_motion():
    body = twrench.Body(moments=[2, 3, 5])
    motion = twrench.exact(body, [1, 0.3, 0.2]).at(np.linspace(0, 30, 50))
    for shape in ((3, 3), (3,)):
        axes = Figure().subplots(*shape) if len(shape) == 2 else Figure().subplots(1, 3)
        plots.components(axes, motion)
        for j in range(3):
            lines = [line for panel in np.reshape(axes, (-1, 3))[:, j] for line in panel.lines]
            for i in range(3):
                assert (lines[i].get_ydata() == motion.X[:, i, j]).all()
                assert (lines[i].get_xdata() == motion.t).all()
                assert lines[i].get_label() == f"x{i + 1}{j + 1}"


def test_the_study_has_a_line_for_each_method():
    body = twrench.Body(moments=[2, 3, 5])
    result = twrench.study(body, [1, 0.3, 0.2], ["rk4", "rkmk4"], duration=10)
    ax = Figure().subplots()
    plots.study(ax, result)
    for line, (name, order) in zip(ax.lines, (("rk4", 2), ("rkmk4", 4))):
        slope = np.polyfit(np.log(line.get_xdata()), np.log(line.get_ydata()), 1)[0]
        assert slope == pytest.approx(order, abs=0.1)
        assert line.get_label().startswith(f"{name}: order ")


def test_wrong_arguments():
    body = twrench.Body(moments=[2, 3, 5])
    flat, deep = Figure().subplots(), Figure().add_subplot(projection="3d")
    motion = twrench.exact(body, [1, 0, 0]).at([0, 1])
    for draw, message in (
        (lambda: plots.momentum_sphere(flat, body), "ax: must be three-dimensional"),
        (lambda: plots.momentum_sphere(deep, [2, 3, 5]), "body: must be a twrench.Body"),
        (lambda: plots.momentum_sphere(deep, body, [1]), "motion: must be a twrench.Motion"),
        (lambda: plots.momentum_sphere(deep, body, levels=-1), "levels: must be from 0 to 100"),
        (lambda: plots.momentum_sphere(deep, body, theme="night"), "theme: unknown name 'night'"),
        (lambda: plots.components(flat, motion), "axes: must be an array of"),
        (lambda: plots.components(Figure().subplots(1, 3), body), "motion: must be a twrench.Mot"),
        (lambda: plots.study(flat, motion), "result: must be a twrench.Study"),
        (lambda: plots.momentum_sphere(deep, body, twrench.exact(body, [0, 0, 0]).at([0])), "rest"),
    ):
        with pytest.raises(twrench.UsageError, match=message):
            draw()
