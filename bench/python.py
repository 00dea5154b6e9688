#!/usr/bin/python3
"""Compares the time of the Python module with that of C++ and of SciPy.

bench/python.py [C++ PROGRAM]: needs the module in PYTHONPATH, and SciPy. The C++ program is that of
bench/motion/exact_samples.cpp, which makes the same arrays without Python.
"""

from __future__ import annotations

import subprocess
import sys
import time
from typing import Callable

import numpy as np
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

import twrench

SCENE = twrench.Scene("dzhanibekov")
BODY, OMEGA = SCENE.body, np.array(SCENE.omega)


def median_seconds(work: Callable[[], object], repeats: int) -> float:
    seconds = []
    for _ in range(repeats):
        start = time.perf_counter()
        work()
        seconds.append(time.perf_counter() - start)
    return float(np.median(seconds))


def usual_script(times: np.ndarray) -> np.ndarray:
    """X by DOP853 with a quaternion for the attitude, as a user of SciPy would write it."""
    inertia = BODY.inertia
    inverse = np.linalg.inv(inertia)

    def rate(_: float, y: np.ndarray) -> np.ndarray:
        q, w = y[:4], y[4:]
        turn = 0.5 * np.concatenate([q[3] * w + np.cross(q[:3], w), [-q[:3] @ w]])
        return np.concatenate([turn, inverse @ np.cross(inertia @ w, w)])

    start = np.concatenate([[0, 0, 0, 1], OMEGA])
    y = solve_ivp(rate, (0, times[-1]), start, "DOP853", times, rtol=1e-12, atol=1e-12).y
    return Rotation.from_quat(y[:4].T).as_matrix()


def compare_with_scipy() -> None:
    times = np.linspace(0, 96, 5761)
    ours = median_seconds(lambda: twrench.simulate(BODY, OMEGA, times), 21)
    theirs = median_seconds(lambda: usual_script(times), 5)
    # The reference for both errors: the Taylor series with the finest tolerance, an independent
    # method.
    truth = twrench.simulate(BODY, OMEGA, times, "taylor", tolerance=1e-15).X
    our_error = np.abs(twrench.simulate(BODY, OMEGA, times).X - truth).max()
    their_error = np.abs(usual_script(times) - truth).max()
    print(f"T-wrench, 96 s, {len(times)} samples")
    print(f"  twrench.simulate     {1e3 * ours:9.3f} ms, error {our_error:.1e}")
    print(f"  SciPy, DOP853, 1e-12 {1e3 * theirs:9.3f} ms, error {their_error:.1e}")
    print(f"  {theirs / ours:.0f} times faster, error {their_error / our_error:.0f} times smaller")


def compare_with_cpp(program: str) -> None:
    count = 1_000_000
    times = np.linspace(0, 96, count)
    motion = twrench.exact(BODY, OMEGA)
    pairs = []
    for _ in range(9):
        cpp = float(subprocess.run([program, str(count)], check=True, capture_output=True).stdout)
        pairs.append((median_seconds(lambda: motion.at(times), 1), cpp))
    python, cpp = np.median(pairs, axis=0)
    print(f"{count} exact samples as arrays")
    print(f"  Python {1e3 * python:.1f} ms, C++ {1e3 * cpp:.1f} ms: {python / cpp:.2f} times")


if __name__ == "__main__":
    compare_with_scipy()
    if len(sys.argv) > 1:
        compare_with_cpp(sys.argv[1])
