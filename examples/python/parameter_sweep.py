"""How long does a body spin before it turns over? A sweep over a hundred thousand starts.

The body spins about its intermediate axis at 1 rad/s, tilted away from it by an angle from 1e-12 to
0.1 rad. However small the tilt, the body flips; the time to the first flip grows only with the
logarithm of the tilt, by the same number of seconds for each factor of ten. The sweep measures that
number and compares it with ln(10) / lambda, where lambda is the growth rate of the linearised
equations. Some rows of the table go to sweep.csv.
"""

import numpy as np

import twrench

moments = np.array([722.671030, 982.271303, 1578.650308])  # g cm^2, ascending
tilts = np.logspace(-12, -1, 100_001)
omega = np.column_stack([np.sin(tilts), np.cos(tilts), np.zeros_like(tilts)])  # in principal axes
waits = twrench.first_flip_times(moments, omega)

table = np.column_stack([tilts, waits])
np.savetxt("sweep.csv", table[::1000], delimiter=",", header="tilt_rad,first_flip_s")
for tilt in [1e-12, 1e-6, 1e-1]:
    print(f"tilt {tilt:.0e} rad: the first flip after {np.interp(tilt, tilts, waits):.3f} s")

least, middle, greatest = moments
rate = np.sqrt((middle - least) * (greatest - middle) / (least * greatest))
small = tilts < 1e-6
slope = np.polyfit(np.log10(tilts[small]), waits[small], 1)[0]
print(f"a tenth of the tilt: {-slope:.6f} s longer; theory: {np.log(10) / rate:.6f} s")
