from __future__ import annotations

import copy
import json
import math
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import twrench

OMEGA = (1.0, 0.05, 0.0)


@pytest.fixture(scope="module")
def body() -> twrench.Body:
    return twrench.Scene().body


def solved_by_scipy(inertia: np.ndarray, times: np.ndarray) -> np.ndarray:
    """X from Euler's equations with the attitude as a quaternion, by an independent integrator."""
    integrate = pytest.importorskip("scipy.integrate")
    Rotation = pytest.importorskip("scipy.spatial.transform").Rotation
    inverse = np.linalg.inv(inertia)

    def rate(_: float, y: np.ndarray) -> np.ndarray:
        q, w = y[:4], y[4:]
        turn = 0.5 * np.concatenate([q[3] * w + np.cross(q[:3], w), [-q[:3] @ w]])
        return np.concatenate([turn, inverse @ np.cross(inertia @ w, w)])

    start = np.concatenate([[0, 0, 0, 1], OMEGA])
    solution = integrate.solve_ivp(
        rate, (0, times[-1]), start, "DOP853", times, rtol=1e-12, atol=1e-12
    )
    return Rotation.from_quat(solution.y[:4].T).as_matrix()


def test_the_exact_motion_is_that_of_scipy(body):
    times = np.linspace(0, 30, 61)
    motion = twrench.simulate(body, OMEGA, times)
    assert motion.X.shape == (61, 3, 3) and motion.omega.shape == (61, 3)
    assert np.abs(motion.X - solved_by_scipy(body.inertia, times)).max() < 1e-8
    assert np.abs(twrench.exact(body, OMEGA).at(times).X - motion.X).max() < 1e-14


@pytest.mark.parametrize("method", [m.name for m in twrench.methods()])
def test_every_method_gives_the_motion_that_the_program_gives(body, method, program):
    text = program("simulate", "--method", method, "--times", "0,0.5,2", "--format", "json")
    rows = json.loads(text)["samples"]
    scene = twrench.Scene()
    motion = twrench.simulate(
        body, OMEGA, [0, 0.5, 2], method, step=scene.step, tolerance=scene.tolerance
    )
    np.testing.assert_array_equal(motion.X, [np.reshape(row["X"], (3, 3)) for row in rows])
    np.testing.assert_array_equal(motion.omega, [row["omega"] for row in rows])


def test_times_may_come_in_any_order_and_a_sample_depends_on_its_own_alone(body):
    times = [3.0, -1.5, 0.0, 7.25]
    for method in ("exact", "rkmk4", "rkmk45"):
        together = twrench.simulate(body, OMEGA, times, method)
        for i, t in enumerate(times):
            alone = twrench.simulate(body, OMEGA, [t], method)
            np.testing.assert_array_equal(together.X[i], alone.X[0])
    assert len(twrench.simulate(body, OMEGA, [])) == 0
    assert twrench.simulate(body, OMEGA, [], "rkmk4").X.shape == (0, 3, 3)
    assert twrench.exact(body, OMEGA).at([]).quaternion_xyzw.shape == (0, 4)


@pytest.mark.parametrize("method", ["euler", "rk4"])
def test_what_is_conserved(body, method):
    motion = twrench.simulate(body, OMEGA, np.linspace(0, 5, 20), method, step=0.01)
    inertia = body.inertia
    energy = 0.5 * np.einsum("ni,ij,nj->n", motion.omega, inertia, motion.omega)
    np.testing.assert_allclose(motion.energy, energy, rtol=1e-13)
    start = 0.5 * np.array(OMEGA) @ inertia @ np.array(OMEGA)
    np.testing.assert_allclose(motion.energy_drift, energy / start - 1, atol=1e-13)
    gram = np.einsum("nji,njk->nik", motion.X, motion.X) - np.eye(3)
    np.testing.assert_allclose(
        motion.orthogonality_error, np.linalg.norm(gram, axis=(1, 2)), atol=1e-13
    )
    L = inertia @ np.array(OMEGA)
    np.testing.assert_allclose(motion.momentum, L)
    error = motion.X @ (inertia @ motion.omega[:, :, None]) - L[:, None]
    np.testing.assert_allclose(
        motion.momentum_error, np.linalg.norm(error[:, :, 0], axis=1) / np.linalg.norm(L), atol=1e-13
    )
    # The errors are measurable: Euler's method leaves SO(3), and both methods change the energy.
    assert (motion.orthogonality_error.max() > 1e-3) == (method == "euler")
    assert np.abs(motion.energy_drift).max() > 1e-12


def test_quaternions_say_their_order(body):
    Rotation = pytest.importorskip("scipy.spatial.transform").Rotation
    motion = twrench.simulate(body, OMEGA, np.linspace(0, 60, 601))
    q = motion.quaternion_xyzw
    np.testing.assert_allclose(Rotation.from_quat(q).as_matrix(), motion.X, atol=1e-14)
    np.testing.assert_array_equal(motion.quaternion_wxyz[:, 0], q[:, 3])
    np.testing.assert_array_equal(motion.quaternion_wxyz[:, 1:], q[:, :3])
    assert (np.sum(q[1:] * q[:-1], axis=1) > 0.9).all()  # no sign jumps
    np.testing.assert_allclose(np.linalg.norm(q, axis=1), 1, atol=1e-15)


def test_flips(body):
    exact = twrench.exact(body, OMEGA)
    flips = exact.flip_times(96)
    assert exact.kind == "about_least" and exact.turns_over
    assert flips[0] == exact.first_flip
    np.testing.assert_allclose(np.diff(flips), exact.flip_interval, rtol=1e-13)
    component = exact.at(np.concatenate([flips - 1e-6, flips + 1e-6])).omega @ body.principal_axes[:, 1]
    assert (component[: len(flips)] * component[len(flips) :] < 0).all()
    steady = twrench.exact(body, [0, 0, 0])
    assert math.isnan(steady.flip_interval) and math.isnan(steady.first_flip)
    assert steady.kind == "steady" and steady.swing == 0 and not steady.turns_over
    assert len(steady.flip_times(10)) == 0


def test_phase(body):
    L, moments = np.array([0, 2, 0.01]), np.array([3, 5, 9])
    known = twrench.Body(moments=moments)
    phase = twrench.exact(known, L / moments).phase()
    assert phase.period == pytest.approx(118.1109, abs=5e-5)
    assert phase.dynamic == pytest.approx(47.2444204, abs=5e-8)
    assert phase.geometric == pytest.approx(-2.7385939, abs=5e-8)
    assert phase.total == pytest.approx(44.5058265, abs=5e-8)
    assert twrench.exact(body, [0, 0, 1]).phase() is None


def test_phase_of_a_body_with_a_wheel():
    body, omega, wheel = twrench.Body(moments=(3, 5, 9)), [0.2, 1, 0.02], [0.5, 0.2, -0.3]
    phase = twrench.simulate(body, omega, [0], wheel=wheel).phase()
    assert phase.total == pytest.approx(phase.dynamic + phase.geometric)
    there = twrench.simulate(body, omega, [phase.period], wheel=wheel, tolerance=1e-15)
    axis = there.momentum / np.linalg.norm(there.momentum)
    turn = there.X[0] @ axis - axis
    assert np.linalg.norm(turn) < 1e-10
    cosine = (np.trace(there.X[0]) - 1) / 2
    assert cosine == pytest.approx(math.cos(phase.total), abs=1e-10)
    assert twrench.simulate(body, omega, [0], wheel=wheel, energy_loss_time=50).phase() is None


def test_a_wheel_and_energy_loss(body, program, tmp_path):
    wheel, times = [40, -30, 20], np.linspace(0, 30, 61)
    motion = twrench.simulate(body, OMEGA, times, wheel=wheel, energy_loss_time=20)
    assert motion.method == "taylor"
    np.testing.assert_allclose(motion.momentum, body.inertia @ OMEGA + wheel, rtol=1e-15)
    assert motion.momentum_error.max() < 1e-13
    assert (np.diff(motion.energy) < 0).all()
    kept = twrench.simulate(body, OMEGA, times, wheel=wheel)
    assert np.abs(kept.energy_drift).max() < 1e-10
    other = twrench.simulate(body, OMEGA, times, "rkmk45", wheel=wheel, tolerance=1e-12)
    np.testing.assert_allclose(other.X, kept.X, atol=1e-8)
    assert twrench.simulate(body, OMEGA, times).method == "exact"
    motion.save(tmp_path / "run.csv")
    assert "energy_drift" not in (tmp_path / "run.csv").read_text()
    for arguments, message in [
        ({"wheel": [1, 2]}, "wheel: must be three numbers"),
        ({"wheel": [1e300, 0, 0]}, "wheel: the energy exceeds"),
        ({"energy_loss_time": 0}, "energy_loss_time: must be greater than 0"),
        ({"energy_loss_time": 0.01}, "energy_loss_time: is 0.01 s, but must be above"),
        ({"wheel": wheel, "method": "exact"}, "method exact: there is no closed form"),
    ]:
        with pytest.raises(twrench.UsageError, match=message):
            twrench.simulate(body, OMEGA, times, **arguments)


@pytest.mark.filterwarnings("ignore:.*no real body has them")
def test_many_bodies_at_once_move_as_one_by_one():
    random = np.random.default_rng(1)
    inertia = random.uniform(1, 10, (40, 3))
    omega = random.normal(size=(40, 3))
    inertia[0], omega[1], inertia[2, 1] = 2.0, 0.0, inertia[2, 0]  # a sphere, rest, a symmetric body
    times = random.uniform(-50, 50, 30)
    many = twrench.exact_many(inertia, omega, times)
    assert many.X.shape == (40, 30, 3, 3) and many.omega.shape == (40, 30, 3) and len(many) == 40
    first = twrench.first_flip_times(inertia, omega)
    for i in range(40):
        exact = twrench.exact(twrench.Body(moments=inertia[i]), omega[i])
        alone = exact.at(times)
        np.testing.assert_array_equal(many.X[i], alone.X)
        np.testing.assert_array_equal(many.omega[i], alone.omega)
        expected = math.inf if math.isnan(exact.first_flip) else exact.first_flip
        assert first[i] == pytest.approx(expected, rel=1e-13)
    alike = twrench.exact_many([1, 2, 3], omega, times)
    np.testing.assert_array_equal(alike.X, twrench.exact_many([[1, 2, 3]] * 40, omega, times).X)
    assert twrench.exact_many(np.ones((0, 3)), np.ones((0, 3)), times).X.shape == (0, 30, 3, 3)
    assert twrench.exact_many([1, 2, 3], omega, []).X.shape == (40, 0, 3, 3)


@pytest.mark.parametrize(
    ("inertia", "omega", "message"),
    [
        ([1, 2], np.ones((2, 3)), "inertia: must be three numbers"),
        (np.ones((2, 2)), np.ones((2, 3)), r"inertia: must be an array of shape \(n, 3\)"),
        (np.ones((3, 3)), np.ones((2, 3)), "inertia: must have as many rows as omega, 2, not 3"),
        (np.ones((2, 3)), np.ones(3), r"omega: must be an array of shape \(n, 3\)"),
        ([[1, 2, 3], [1, -2, 3]], np.ones((2, 3)), r"inertia\[1, 1\]"),
        ([1, 2, 3], [[1, 2, math.nan]], "omega: must be finite"),
        (None, np.ones((2, 3)), "inertia: must be"),
        ([1, 2, 3], None, "omega: must be"),
    ],
)
def test_wrong_bodies_of_many(inertia, omega, message):
    with pytest.raises(twrench.UsageError, match=message):
        twrench.exact_many(inertia, omega, [0])
    with pytest.raises(twrench.UsageError, match=message):
        twrench.first_flip_times(inertia, omega)


def test_arrays_outlive_what_they_came_from(body):
    X = twrench.simulate(body, OMEGA, np.linspace(0, 1, 100_000), "rkmk4").X
    copy = X.copy()
    for _ in range(5):
        twrench.simulate(body, OMEGA, np.linspace(0, 1, 100_000), "rkmk4", step=0.02)
    np.testing.assert_array_equal(X, copy)


def test_to_dataframe(body):
    pytest.importorskip("pandas")
    frame = twrench.simulate(body, OMEGA, [0, 1]).to_dataframe()
    assert list(frame.columns[:2]) == ["t", "X11"] and frame.shape == (2, 17)
    assert frame["X11"][0] == 1 and frame["omega_y"][0] == 0.05


def test_a_study_measures_the_orders(body):
    study = twrench.study(body, OMEGA, ["rkmk4", "rkmk45"], duration=24)
    assert study.methods["rkmk4"].order == pytest.approx(4, abs=0.2)
    assert [run.step for run in study.methods["rkmk4"].runs] == [0.08, 0.04, 0.02, 0.01]
    assert study.methods["rkmk45"].runs[-1].tolerance == 1e-10
    assert study.methods["rkmk45"].runs[-1].error < 1e-6
    np.testing.assert_allclose(study.flip_times, twrench.exact(body, OMEGA).flip_times(24))
    assert study.reference == "exact"
    with_wheel = twrench.study(body, OMEGA, ["rkmk4"], duration=24, wheel=[40, -30, 20])
    assert with_wheel.reference == "taylor"
    assert with_wheel.methods["rkmk4"].order == pytest.approx(4, abs=0.2)
    lossy = twrench.study(body, OMEGA, ["rkmk4"], duration=24, energy_loss_time=20)
    assert lossy.methods["rkmk4"].runs[-1].energy_drift < 1e-6 and not lossy.flip_times.size
    pytest.importorskip("pandas")
    assert len(study.to_dataframe()) == 8
    failed = twrench.study(body, [100, 5, 0], ["rk4"], duration=1, steps=[1.0])
    assert "longer than a turn" in failed.methods["rk4"].runs[0].failure


NOT_TIMES = [None, "abc", True, [[0.0]], [0.0, math.nan], [math.inf], [None], [1j], {}, [[1], [2, 3]]]


@pytest.mark.parametrize("times", NOT_TIMES)
def test_wrong_times(body, times):
    with pytest.raises(twrench.UsageError, match="^times: must be"):
        twrench.simulate(body, OMEGA, times)
    with pytest.raises(twrench.UsageError, match="^times: must be"):
        twrench.exact(body, OMEGA).at(times)


@pytest.mark.parametrize("omega", [None, 1.0, [1, 2], [1, 2, math.nan], "x", np.ones((3, 1)), ["1"] * 3])
def test_wrong_omega(body, omega):
    for call in (
        lambda: twrench.simulate(body, omega, [0]),
        lambda: twrench.exact(body, omega),
        lambda: twrench.study(body, omega, ["rk4"], duration=1),
    ):
        with pytest.raises(twrench.UsageError, match="^omega: must be"):
            call()


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ({"body": None}, twrench.UsageError, "body: must be a twrench.Body"),
        ({"method": "rkmk5"}, twrench.UsageError, "rkmk5.*did you mean"),
        ({"method": 4}, twrench.UsageError, "method: must be a string"),
        ({"step": 0}, twrench.UsageError, "step: must be greater than 0"),
        ({"step": "0.1"}, twrench.UsageError, "step: must be a number"),
        ({"step": math.nan}, twrench.UsageError, "step: must be finite"),
        ({"tolerance": -1}, twrench.UsageError, "tolerance: must be greater than 0"),
        ({"tolerance": 1e-20, "method": "rkmk45"}, twrench.UsageError, "tolerance"),
        ({"max_steps": 0}, twrench.UsageError, "max_steps: must be from 1"),
        ({"max_steps": 1.5}, twrench.UsageError, "max_steps: must be an integer"),
        ({"max_steps": 10, "method": "rk4"}, twrench.MotionError, "take a longer step"),
        ({"step": 20, "method": "rk4"}, twrench.MotionError, "take a shorter step"),
    ],
)
def test_other_wrong_arguments(body, arguments, error, message):
    with pytest.raises(error, match=message) as raised:
        twrench.simulate(**({"body": body, "omega": OMEGA, "times": [0, 50]} | arguments))
    assert "--" not in str(raised.value) and "\n" not in str(raised.value)


def test_wrong_studies(body):
    for methods in ("rk4", [4], ["rk5"]):
        with pytest.raises(twrench.UsageError, match="methods"):
            twrench.study(body, OMEGA, methods, duration=1)
    with pytest.raises(twrench.UsageError, match="duration"):
        twrench.study(body, OMEGA, ["rk4"], duration=0)
    with pytest.raises(twrench.UsageError, match="steps"):
        twrench.study(body, OMEGA, ["rk4"], duration=1, steps=[])
    with pytest.raises(twrench.UsageError, match="^steps: is 0"):
        twrench.study(body, OMEGA, ["rk4"], duration=1, steps=[0.0])


def test_more_than_doubles_or_memory_hold(body):
    with pytest.raises(twrench.UsageError, match="omega: the energy exceeds"):
        twrench.simulate(body, [1e200, 1, 0], [0, 1])
    assert np.isfinite(twrench.simulate(body, [1e150, 1, 0], [0, 1]).X).all()
    with pytest.raises(MemoryError):
        twrench.exact_many([1, 2, 3], np.ones((10**6, 3)), np.zeros(10**6))


def test_errors_survive_pickling():
    import pickle

    error = twrench.MotionError("a: b", "do c")
    copy = pickle.loads(pickle.dumps(error))
    assert (str(copy), copy.remedy) == ("a: b; do c", "do c")
    assert isinstance(twrench.FileError("a"), OSError)
    assert isinstance(twrench.SceneError("a"), ValueError)


def test_eight_threads_get_what_one_gets(body):
    times = np.linspace(0, 20, 2000)
    methods = ["exact", "rkmk4", "rkmk45", "taylor"]
    wanted = {m: twrench.simulate(body, OMEGA, times, m).X.copy() for m in methods}

    def work(i: int) -> bool:
        method = methods[i % len(methods)]
        return bool((twrench.simulate(body, OMEGA, times, method).X == wanted[method]).all())

    with ThreadPoolExecutor(8) as pool:
        assert all(pool.map(work, range(64)))


def test_other_threads_run_while_a_motion_is_integrated(body):
    turns = 0
    done = threading.Event()

    def integrate() -> None:
        twrench.simulate(body, OMEGA, [96], "suzuki4", step=2e-4)
        done.set()

    thread = threading.Thread(target=integrate)
    thread.start()
    while not done.wait(0.001):
        turns += 1
    thread.join()
    assert turns > 10


INTERRUPTED = """
import sys, time, twrench
body = twrench.Scene().body
def work():
    if sys.argv[1] == "simulate":
        twrench.simulate(body, (1, 0.05, 0), [9.6], "suzuki4", step=2e-7, max_steps=10**9)
    elif sys.argv[1] == "study":
        twrench.study(body, (1, 0.05, 0), ["suzuki4"], duration=9.6, steps=[2e-6])
try:
    print("begun", flush=True)
    work()
except KeyboardInterrupt:
    print("interrupted", flush=True)
twrench.simulate(body, (1, 0.05, 0), [1], "rkmk4")  # and all goes on
print("fine", flush=True)
"""


@pytest.mark.parametrize("work", ["simulate", "study"])
@pytest.mark.parametrize("delay", [0.0, 0.05, 0.3])
def test_control_c_ends_the_work(work, delay):
    child = subprocess.Popen(
        [sys.executable, "-c", INTERRUPTED, work], stdout=subprocess.PIPE, text=True
    )
    assert child.stdout is not None
    assert child.stdout.readline() == "begun\n"
    time.sleep(delay + 0.05)
    os.kill(child.pid, signal.SIGINT)
    out, _ = child.communicate(timeout=60)
    assert out == "interrupted\nfine\n" and child.returncode == 0


def test_motions_are_copied_and_pickled_bit_for_bit(body):
    attitude = [0.1, -0.7, 0.5, 0.3]
    exact = twrench.exact(body, OMEGA, attitude=attitude)
    wheel = twrench.simulate(body, OMEGA, [0, 3, -2], attitude=attitude, wheel=[1, 2, 3])
    damped = twrench.simulate(body, OMEGA, [0, 3, 20], energy_loss_time=100)
    for motion in (exact.at([0, 3, 1e9]), wheel, damped):
        for same in (copy.deepcopy(motion), pickle.loads(pickle.dumps(motion))):
            for name in ("t", "X", "omega", "energy", "momentum_error", "momentum"):
                np.testing.assert_array_equal(getattr(same, name), getattr(motion, name))
            assert (same.method, same.steps) == (motion.method, motion.steps)
    for same in (copy.copy(exact), copy.deepcopy(exact), pickle.loads(pickle.dumps(exact))):
        np.testing.assert_array_equal(same.at([0.3, 1e9]).X, exact.at([0.3, 1e9]).X)
        assert same.first_flip == exact.first_flip


def test_damaged_pickles_of_motions_are_refused(body):
    free_body = twrench.exact(body, OMEGA)._free_body
    inertia, *others = free_body.__getstate__()
    native = type(free_body)
    for state in (None, (), (inertia,), (-inertia, *others), (inertia[:2], *others), ("x", *others)):
        with pytest.raises(twrench.UsageError, match="the pickled motion: is damaged"):
            native.__new__(native).__setstate__(state)
    for state in (None, {}, {"_free_body": 3}):
        exact = twrench.ExactMotion.__new__(twrench.ExactMotion)
        with pytest.raises(twrench.UsageError, match="the pickled motion: is damaged"):
            exact.__setstate__(state)


def test_arrays_of_a_motion_that_were_replaced_by_others_are_refused(body, tmp_path):
    for name, value in (
        ("X", np.eye(3)), ("X", np.zeros((3, 2))), ("X", "abc"), ("X", np.zeros((2, 3, 3))),
        ("omega", np.zeros((3, 1))), ("omega", np.zeros((10**6, 3))), ("t", np.arange(10**6)),
    ):  # fmt: skip
        motion = twrench.exact(body, OMEGA).at([0, 1, 2])
        setattr(motion, name, value)
        for use in (
            lambda: motion.energy,
            lambda: motion.quaternion_xyzw,
            lambda: motion.save(tmp_path / "a.csv"),
        ):
            with pytest.raises(twrench.UsageError, match="^(X|omega): must"):
                use()
    assert not list(tmp_path.iterdir())
    motion = twrench.exact(body, OMEGA).at([0, 1, 2])
    motion.X = motion.X.astype(np.float32)  # less exact, but valid
    assert motion.orthogonality_error.max() < 1e-6


def test_an_infinite_time_of_the_energy_loss_is_none(body):
    motion = twrench.simulate(body, OMEGA, [0, 1], energy_loss_time=math.inf)
    assert motion.method == "exact"
    study = twrench.study(body, OMEGA, ["rk4"], duration=1, energy_loss_time=math.inf)
    assert study.reference == "exact"
    for time in (-math.inf, math.nan, [1.0, math.inf]):
        with pytest.raises(twrench.UsageError, match="^energy_loss_time"):
            twrench.simulate(body, OMEGA, [0, 1], energy_loss_time=time)


def test_samples_of_a_motion_are_those_of_its_arrays(body):
    motion = twrench.simulate(body, OMEGA, np.linspace(0, 3, 7), "rkmk4", step=0.1)
    assert motion.X.flags.c_contiguous and motion.omega.flags.c_contiguous
    mask = motion.t > 1
    for index in (0, -1, np.int64(3), slice(2, 5), slice(None, None, -2), [1, 4], mask, slice(9, 9)):
        some = motion[index]
        for name in ("t", "X", "omega", "energy", "energy_drift", "momentum_error"):
            np.testing.assert_array_equal(getattr(some, name), getattr(motion, name)[index])
        assert some.quaternion_wxyz.shape == (*np.shape(some.t), 4)
        assert (some.method, some.steps) == (motion.method, motion.steps)
    assert [float(sample.t) for sample in motion] == motion.t.tolist()
    for index in (7, -8, None, "a", (0, 1)):
        with pytest.raises(IndexError):
            motion[index]


def test_a_single_time_has_arrays_without_that_dimension(body, tmp_path):
    exact = twrench.exact(body, OMEGA)
    for single in (exact.at(2), twrench.simulate(body, OMEGA, np.float64(2)), exact.at(np.array(2.0))):
        (one,) = exact.at([2])
        for name in ("t", "X", "omega", "energy", "orthogonality_error", "quaternion_xyzw"):
            np.testing.assert_array_equal(getattr(single, name), getattr(one, name))
        assert single.X.shape == (3, 3) and single.omega.shape == (3,) and single.t.shape == ()
        assert repr(single) == "<twrench.Motion: one sample at 2 s, exact>"
        with pytest.raises(TypeError):
            len(single)
    many = twrench.exact_many([1, 2, 3], [OMEGA, OMEGA], 2)
    assert many.X.shape == (2, 3, 3) and repr(many) == "<twrench.ManyMotions: 2 bodies at one time>"
    single, one = exact.at(2), exact.at([2])
    assert single.save(tmp_path / "a.csv").read_bytes() == one.save(tmp_path / "b.csv").read_bytes()
    for wrong in (True, "2", math.nan):
        with pytest.raises(twrench.UsageError, match="^times: must be"):
            exact.at(wrong)
