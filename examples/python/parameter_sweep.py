"""How long does a body spin before it turns over? A sweep over a thousand starts.

The body spins about its intermediate axis at 1 rad/s, tilted away from it by an angle from 1e-12 to
0.1 rad. However small the tilt, the body flips; the time to the next flip grows only with the
logarithm of the tilt, by the same number of seconds for each factor of ten. The sweep measures that
number and compares it with 2 ln(10) / lambda, where lambda is the growth rate of the linearised
equations. The table goes to sweep.csv.
"""

import numpy as np

import twrench

body = twrench.Scene("dzhanibekov").body
least, middle, greatest = body.principal_moments
axes = body.principal_axes

tilts = np.logspace(-12, -1, 1000)
directions = np.cos(tilts)[:, None] * axes[:, 1] + np.sin(tilts)[:, None] * axes[:, 0]
intervals = np.array([twrench.exact(body, omega).flip_interval for omega in directions])
np.savetxt("sweep.csv", np.column_stack([tilts, intervals]), delimiter=",", header="tilt_rad,interval_s")

slope = np.polyfit(np.log10(tilts[:500]), intervals[:500], 1)[0]
rate = np.sqrt((middle - least) * (greatest - middle) / (least * greatest))
for tilt in [1e-12, 1e-6, 1e-1]:
    print(f"tilt {tilt:.0e} rad: a flip every {np.interp(tilt, tilts, intervals):.3f} s")
print(f"a tenth of the tilt: {-slope:.6f} s longer; theory: {2 * np.log(10) / rate:.6f} s")
