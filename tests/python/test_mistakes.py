"""The table of docs/check.md of what simulators get wrong and what the check says.

Each motion is integrated here, without the library, by a simulator with one mistake.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Callable

import numpy as np
import pytest

import twrench

ROOT = Path(__file__).parents[2]
MOMENTS = np.diag([2.0, 3.0, 4.5])
OMEGA = np.array([0.4, 1.5, 0.3])
STEP, ROWS = 0.05, 201

Vector = np.ndarray
Rate = Callable[[Vector, Vector], Vector]


def cross(a: Vector, b: Vector) -> Vector:
    """As np.cross, which takes ten times as long for single vectors."""
    (ax, ay, az), (bx, by, bz) = a, b
    return np.array([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx])


def product(a: Vector, b: Vector) -> Vector:
    """The product of two quaternions (w, x, y, z)."""
    w, v = a[0] * b[0] - a[1:] @ b[1:], a[0] * b[1:] + b[0] * a[1:] + cross(a[1:], b[1:])
    return np.array([w, *v])


def pure(w: Vector) -> Vector:
    return np.array([0.0, *w])


def in_body(v: Vector, q: Vector) -> Vector:
    """The components in the body's axes of a vector in space."""
    return product(product(q * [1, -1, -1, -1], pure(v)), q)[1:] / (q @ q)


def euler(w: Vector, inertia: Vector = MOMENTS, factor: float = 1.0) -> Vector:
    return factor * np.linalg.solve(inertia, cross(inertia @ w, w))


def body_rates(w: Vector, q: Vector) -> Vector:
    return 0.5 * product(q, pure(w))


def simulated(
    acceleration: Rate = lambda w, q: euler(w),
    turn: Rate = body_rates,
    limit: float = np.inf,
    start: Vector = OMEGA,
    substeps: int = 4,
) -> dict[str, Vector]:
    """The motion by the Runge-Kutta method of order 4."""

    def rate(at: Vector) -> Vector:
        return np.concatenate([acceleration(at[:3], at[3:]), turn(at[:3], at[3:])])

    at = np.array([*start, 1.0, 0.0, 0.0, 0.0])
    rows = []
    h = STEP / substeps
    for _ in range(ROWS):
        rows.append(at)
        for _ in range(substeps):
            a = rate(at)
            b = rate(at + h / 2 * a)
            c = rate(at + h / 2 * b)
            at = at + h / 6 * (a + 2 * b + 2 * c + rate(at + h * c))
            at[3:] /= np.linalg.norm(at[3:])
            at[:3] *= min(1.0, limit / np.linalg.norm(at[:3]))
    table = np.array(rows)
    return {"t": STEP * np.arange(ROWS), "omega": table[:, :3], "quaternion_wxyz": table[:, 3:]}


def with_gyroscopic(factor: float) -> dict[str, Vector]:
    return simulated(lambda w, q: euler(w, factor=factor))


def of_other_body(inertia: Vector) -> dict[str, Vector]:
    return simulated(lambda w, q: euler(w, inertia))


def with_torque(torque: Rate) -> dict[str, Vector]:
    return simulated(lambda w, q: euler(w) + np.linalg.solve(MOMENTS, torque(w, q)))


def turned(factor: float) -> dict[str, Vector]:
    return simulated(turn=lambda w, q: factor * body_rates(w, q))


def delayed() -> dict[str, Vector]:
    """Rates that are recorded half an interval later than the attitudes."""
    motion = simulated()
    later = simulated(start=twrench.exact(twrench.Body(inertia=MOMENTS), OMEGA).at(STEP / 2).omega)
    return motion | {"omega": later["omega"]}


def integrated_angles() -> dict[str, Vector]:
    motion = simulated()
    exact = twrench.exact(twrench.Body(inertia=MOMENTS), OMEGA)
    fine = exact.at(np.linspace(0, STEP * (ROWS - 1), 20 * (ROWS - 1) + 1)).omega
    simpson = (fine[:-1:2] + 4 * fine[1::2] + fine[2::2]) * STEP / 60
    angles = np.vstack([np.zeros(3), np.cumsum(simpson, axis=0)[9::10]])
    quaternions = []
    for x, y, z in angles / 2:
        about_z, about_y = np.array([np.cos(z), 0, 0, np.sin(z)]), np.array([np.cos(y), 0, np.sin(y), 0])
        about_x = np.array([np.cos(x), np.sin(x), 0, 0])
        quaternions.append(product(product(about_z, about_y), about_x))
    return motion | {"quaternion_wxyz": np.array(quaternions)}


SKEW = MOMENTS + np.array([[0, 0.3, -0.2], [0.3, 0, 0.1], [-0.2, 0.1, 0]])

#: The motion of each row of the table, by the mistake in words, and the inertia that is given.
MOTIONS: dict[str, tuple[Callable[[], dict[str, Vector]], Vector]] = {
    "no gyroscopic term": (lambda: with_gyroscopic(0), MOMENTS),
    "its other sign": (lambda: with_gyroscopic(-1), MOMENTS),
    "half of it": (lambda: with_gyroscopic(0.5), MOMENTS),
    "twice of it": (lambda: with_gyroscopic(2), MOMENTS),
    "another multiple of it": (lambda: with_gyroscopic(0.8), MOMENTS),
    "not divided by the moments": (
        lambda: simulated(lambda w, q: cross(MOMENTS @ w, w)),
        MOMENTS,
    ),
    "multiplied by them": (
        lambda: simulated(lambda w, q: MOMENTS @ cross(MOMENTS @ w, w)),
        MOMENTS,
    ),
    "a forgotten torque of the body": (
        lambda: with_torque(lambda w, q: np.array([0.1, 0, 0])),
        MOMENTS,
    ),
    "one from outside": (lambda: with_torque(lambda w, q: in_body(np.array([0, 0, 0.2]), q)), MOMENTS),
    "damping by default": (lambda: simulated(lambda w, q: euler(w) - 0.05 * w), MOMENTS),
    "drag": (lambda: simulated(lambda w, q: euler(w) - 0.02 * np.linalg.norm(w) * w), MOMENTS),
    "a limit of the speed": (lambda: simulated(limit=1.55, substeps=16), MOMENTS),
    "a wrong moment": (lambda: of_other_body(np.diag([2.0, 3.3, 4.5])), MOMENTS),
    "the inverse of the inertia": (lambda: of_other_body(np.linalg.inv(MOMENTS)), MOMENTS),
    "products with the other sign": (
        lambda: of_other_body(2 * np.diag(np.diag(SKEW)) - SKEW),
        SKEW,
    ),
    "no 1/2 in the quaternion's equation": (lambda: turned(2), MOMENTS),
    "1/2 twice": (lambda: turned(0.5), MOMENTS),
    "a conjugate on one side": (lambda: turned(-1), MOMENTS),
    "swapped factors": (
        lambda: simulated(turn=lambda w, q: 0.5 * product(pure(w), q)),
        MOMENTS,
    ),
    "rates of half an interval later": (delayed, MOMENTS),
    "angles that integrate the rates": (integrated_angles, MOMENTS),
}


def table() -> list[list[str]]:
    """The mistake, the sentence and the name in the JSON of each row."""
    text = (ROOT / "docs/check.md").read_text()
    section = text[text.index("### Wrong laws") :]
    rows = re.findall(r"^\| (.+?) \| (.+?) \| `(\w+)` \|$", section, re.MULTILINE)
    return [list(row) for row in rows]


def test_the_table_has_every_motion_and_every_mistake() -> None:
    assert [row[0] for row in table()] == list(MOTIONS)
    assert len({row[2] for row in table()}) == 15


@pytest.mark.parametrize("mistake", MOTIONS)
def test_the_check_says_what_the_table_says(mistake: str) -> None:
    ((_, sentence, name),) = [row for row in table() if row[0] == mistake]
    make, inertia = MOTIONS[mistake]
    found = twrench.check(make(), twrench.Body(inertia=inertia))
    assert not found.passes
    assert sentence in found.verdict
    assert [one["mistake"] for one in found.details["mistakes"]] == [name]


OF_RATES = [row[0] for row in table() if row[2] != "attitude_factor"][:15]


@pytest.mark.parametrize("mistake", OF_RATES)
def test_attitudes_alone_show_mistakes_in_the_law_of_the_rates(mistake: str) -> None:
    ((_, sentence, name),) = [row for row in table() if row[0] == mistake]
    make, inertia = MOTIONS[mistake]
    motion = make()
    del motion["omega"]
    found = twrench.check(motion, twrench.Body(inertia=inertia))
    assert sentence.removesuffix(" rad/s") in found.verdict
    assert [one["mistake"] for one in found.details["mistakes"]] == [name]


@pytest.mark.parametrize("factor", [2, 0.5, -1])
def test_attitudes_alone_do_not_distinguish_two_factors(factor: float) -> None:
    motion = turned(factor)
    del motion["omega"]
    verdict = twrench.check(motion, twrench.Body(inertia=MOMENTS)).verdict
    assert "the gyroscopic term" in verdict
    assert f"or, which is the same motion, the attitude turns {factor:g} times as fast" in verdict


@pytest.mark.parametrize("has_rates", [True, False])
def test_the_right_motion_has_no_mistake(has_rates: bool) -> None:
    motion = simulated()
    if not has_rates:
        del motion["omega"]
    found = twrench.check(motion, twrench.Body(inertia=MOMENTS))
    assert found.finding == "integration" and not found.details["mistakes"], found.verdict
