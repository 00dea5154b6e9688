"""The time to the first flip, over all starts on one side of the momentum sphere.

A body whose principal moments are 1, 2 and 3 starts with momenta of the same magnitude in a million
directions. The picture shows the sphere along the intermediate axis. The longest times lie along the
branch of the separatrix that leads to that axis, on which the first flip never comes.
"""

import sys
import time

import numpy as np
from PIL import Image

import twrench

SIZE = int(sys.argv[1]) if len(sys.argv) > 1 else 1000
MOMENTS = np.array([1.0, 2.0, 3.0])

start = time.perf_counter()
across = (np.arange(SIZE) + 0.5) / SIZE * 2 - 1
x, z = np.meshgrid(across, -across)
on_sphere = x**2 + z**2 < 1
y = np.sqrt(1 - x[on_sphere] ** 2 - z[on_sphere] ** 2)
momentum = np.column_stack([x[on_sphere], y, z[on_sphere]])
wait = twrench.first_flip_times(MOMENTS, momentum / MOMENTS)

# Dark blue for an early flip, through red and orange to white for one that never comes.
shade = 1 - np.exp(-wait / 5)
stops = np.array([[10, 18, 60], [70, 40, 120], [200, 70, 80], [250, 170, 70], [255, 255, 240]])
picture = np.full((SIZE, SIZE, 3), 255, np.uint8)
for channel in range(3):
    picture[on_sphere, channel] = np.interp(shade * (len(stops) - 1), range(5), stops[:, channel])
seconds = time.perf_counter() - start

Image.fromarray(picture).save("flip_map.png")
print(f"{wait.size} starts in {seconds:.2f} s; the earliest flip after {wait.min():.4f} s")
