"""The exact motion against SciPy's solve_ivp, and the trap of quaternions.

The usual script integrates Euler's equations together with a quaternion. Libraries disagree on the
order of its components: SciPy, ROS and Eigen's memory have (x, y, z, w), most papers (w, x, y, z).
Four numbers in the wrong order are another valid rotation, and nothing raises an error. So twrench
has no attribute `quaternion`: the order is part of the name.
"""

import time

import numpy as np
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

import twrench

scene = twrench.Scene("dzhanibekov")
inertia, omega = scene.body.inertia, scene.omega
times = np.linspace(0, 96, 5761)


def derivative(t, state):
    w, v, omega = state[0], state[1:4], state[4:]
    torque = -np.cross(omega, inertia @ omega)
    return [-v @ omega / 2, *(w * omega + np.cross(v, omega)) / 2, *np.linalg.solve(inertia, torque)]


begin = time.perf_counter()
numeric = solve_ivp(derivative, (0, 96), [1, 0, 0, 0, *omega], "DOP853", times, rtol=1e-12, atol=1e-12)
middle = time.perf_counter()
motion = twrench.exact(scene.body, omega).at(times)
end = time.perf_counter()
print(f"solve_ivp {middle - begin:.3f} s, exact {1e3 * (end - middle):.3f} ms")

xyzw = numeric.y[[1, 2, 3, 0]].T
error = np.abs(Rotation.from_quat(xyzw).as_matrix() - motion.X).max()
print(f"largest difference of X: {error:.1e}")
same = np.abs(Rotation.from_quat(motion.quaternion_xyzw).as_matrix() - motion.X).max()
trap = np.abs(Rotation.from_quat(motion.quaternion_wxyz).as_matrix() - motion.X).max()
print(f"twrench's own quaternions, as SciPy reads them: xyzw {same:.0e}, wxyz {trap:.1f}")
