"""A phone's gyroscope during a toss: toss.csv, as a real one might record it.

A hand starts the phone about its middle axis, lets it go, and catches it after 1.2 s. The rates have
the noise of a phone's gyroscope. The numbers are the same on every run.
"""

import sys

import numpy as np

import twrench

length, width, depth = 15.0, 7.2, 0.8  # cm, along the phone's y, x and z
moments = [length**2 + depth**2, width**2 + depth**2, width**2 + length**2]
rate, release, catch, end = 200, 0.8, 2.0, 2.6  # Hz, s

t = np.arange(round(end * rate)) / rate
flight = twrench.exact(twrench.Body(moments=moments), [7, 0.3, 0.2])
omega = flight.at(np.clip(t - release, 0, catch - release)).omega
hand = np.clip(np.minimum(t / release, (end - t) / (end - catch)), 0, 1)
random = np.random.default_rng(2020)
omega = omega * hand[:, None] + random.normal(0, 0.02, omega.shape)

names = ["Time (s)", *(f"Gyroscope {axis} (rad/s)" for axis in "xyz")]
path = sys.argv[1] if len(sys.argv) > 1 else "toss.csv"
rows = np.column_stack([t, omega])
np.savetxt(path, rows, "%.6f", ",", header=",".join(f'"{name}"' for name in names), comments="")
ratios = np.sort(moments) / min(moments)
print(f"{path}: {len(t)} rows; the phone flies from {release} to {catch} s")
print(f"its moments are in the ratio 1 : {ratios[1]:.4f} : {ratios[2]:.4f}")
