"""The time to the first flip, over all starts on one side of the momentum sphere.

A body whose principal moments are 3, 2 and 1 starts with a momentum of one size in a million
directions; the picture looks at the sphere along the intermediate axis. Starts near the axis wait
long for their first flip, and those on the two great circles through it, the separatrix, for ever.
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

# Dark blue for an early flip, through orange to white for a late one.
shade = np.clip((wait - wait.min()) / 8, 0, 1)[:, np.newaxis] ** 0.7
stops = np.array([[10, 18, 60], [70, 40, 120], [200, 70, 80], [250, 170, 70], [255, 255, 240]])
picture = np.full((SIZE, SIZE, 3), 255, np.uint8)
for channel in range(3):
    color = np.interp(shade[:, 0], np.linspace(0, 1, len(stops)), stops[:, channel])
    picture[on_sphere, channel] = color
seconds = time.perf_counter() - start

Image.fromarray(picture).save("flip_map.png")
print(f"{wait.size} starts in {seconds:.2f} s; the earliest flip after {wait.min():.4f} s")
