"""Plays a .glb, or the script of a .py, in Blender at 1000 random times and compares it with the motion.

Usage: blender --background --python-exit-code 1 --python blender_test.py -- FILE BOUND DURATION option of simulate ...

Blender's importer turns the scene so that z is up, keeps key times in frames and interpolates the
four components of a quaternion one by one: nlerp, in float32.
"""

import json
import math
import os
import random
import runpy
import subprocess
import sys

import bpy
import numpy
from mathutils import Matrix

# Debian 12's Blender 3.4 uses a name that its NumPy 1.24 no longer has.
if "bool" not in vars(numpy):
    numpy.bool = bool

path, bound, duration, *options = sys.argv[sys.argv.index("--") + 1:]
bound, duration = float(bound), float(duration)

bpy.ops.wm.read_factory_settings(use_empty=True)
if path.endswith(".py"):
    runpy.run_path(path)
    body = bpy.data.objects["twrench"]
    turn = Matrix.Identity(3)
else:
    bpy.ops.import_scene.gltf(filepath=path)
    body = bpy.data.objects["body"]
    turn = Matrix(((1, 0, 0), (0, 0, -1), (0, 1, 0)))  # from glTF's axes to Blender's
scene = bpy.context.scene
fps = scene.render.fps / scene.render.fps_base

dice = random.Random(2026)
# Frames and fractions of a frame are float32 numbers, which represent multiples of 1/1024 exactly.
frames = [dice.randrange(int(duration * fps * 1024)) / 1024 for _ in range(1000)]
exact = []
for i in range(0, len(frames), 500):
    times = ",".join(repr(frame / fps) for frame in frames[i:i + 500])
    text = subprocess.run([os.environ["TWRENCH"], "simulate", *options, "--format", "json", "--times", times], capture_output=True, check=True, text=True).stdout
    exact += [sample["X"] for sample in json.loads(text)["samples"]]

worst = 0.0
for frame, X in zip(frames, exact):
    scene.frame_set(math.floor(frame), subframe=frame - math.floor(frame))
    shown = turn.transposed() @ body.matrix_world.to_3x3().normalized() @ turn
    off = shown.transposed() @ Matrix((X[0:3], X[3:6], X[6:9]))
    skew = (off[2][1] - off[1][2], off[0][2] - off[2][0], off[1][0] - off[0][1])
    worst = max(worst, math.asin(min(1.0, 0.5 * math.sqrt(sum(s * s for s in skew)))))
print(f"{path}: Blender {bpy.app.version_string} is off by at most {worst:.2e} rad; bound {bound}")
sys.exit(0 if worst <= bound else 1)
