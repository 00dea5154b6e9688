"""How integration methods drift: the energy of a free body is constant, but that of a numerical
solution need not be.

Prints the relative drift of the kinetic energy at four times for several methods with the same step,
and how far the matrix X has left SO(3) by then. Euler's method on the matrix leaves the group; its
form on the group stays there but gains energy; methods of higher order drift less; and those that
conserve the energy do so to round-off.
"""

import numpy as np

import twrench

scene = twrench.Scene("dzhanibekov")
times = np.array([24.0, 48.0, 72.0, 96.0])
print("method (h = 0.02 s)   drift at" + "".join(f"{t:>8g} s " for t in times) + "  |X'X - Id|")
for name in ["euler", "lie-euler", "rk4", "strang", "rkmk4", "suzuki4", "exact"]:
    try:
        motion = twrench.simulate(scene.body, scene.omega, times, name, step=0.02)
    except twrench.MotionError as error:
        print(f"{name:29s} {error}")
        continue
    drifts = " ".join(f"{drift:9.1e}" for drift in motion.energy_drift)
    print(f"{name:29s} {drifts} {motion.orthogonality_error[-1]:11.1e}")
