#!/usr/bin/env bash
# mesh.sh [SQUARES]: times `twrench inertia` on a binary STL file of 12 SQUARES^2 triangles (default
# 289, for 10^6) and ADMesh, then prints the errors of the asteroid Toutatis's volume and moments, near
# and far from the origin, of twrench and of MuJoCo. Installs missing dependencies.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/maintain/setup.sh foreign
twrench=$PWD/build/release/bin/twrench
squares=${1:-289}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
g++ -std=c++20 -O2 bench/mesh_mujoco.cpp -lmujoco -o "$folder/mujoco"

# A cube from -10 to 10 whose points are moved a little, so that no two normals are equal.
python3 - "$squares" "$folder/cube.stl" <<'END'
import random, struct, sys

n = int(sys.argv[1])
random.seed(1)
points = {}


def point(place):
    if place not in points:
        stretch = 10 * (1 + random.random() / (8 * n))
        points[place] = struct.pack("<3f", *((2 * c / n - 1) * stretch for c in place))
    return points[place]


triangles = []
for side in range(6):
    axis, end = side // 2, side % 2
    for u in range(n):
        for v in range(n):
            corners = []
            for du, dv in ((0, 0), (1, 0), (1, 1), (0, 1)):
                place = [0, 0, 0]
                place[axis], place[(axis + 1) % 3], place[(axis + 2) % 3] = n * end, u + du, v + dv
                corners.append(point(tuple(place)))
            a, b, c, d = corners if end else corners[::-1]
            triangles += [a + b + c, a + c + d]
with open(sys.argv[2], "wb") as file:
    file.write(b" " * 80 + struct.pack("<I", len(triangles)))
    for triangle in triangles:
        file.write(bytes(12) + triangle + bytes(2))
END

# timed NAME COMMAND...: the best of five.
timed() {
  for _ in 1 2 3 4 5; do
    /usr/bin/env time -f '%e %U %M' -o "$folder/time" "${@:2}" >/dev/null
    cat "$folder/time"
  done | sort -n | head -n 1 |
    awk -v name="$1" '{ printf "%-24s %8.2f %8.2f %8.0f\n", name, $1, $2, $3 / 1024 }'
}

printf '%-24s %8s %8s %8s\n' "$((12 * squares * squares)) triangles" s "s (CPU)" MB
timed "twrench inertia" "$twrench" inertia "$folder/cube.stl" --unit mm
timed ADMesh admesh "$folder/cube.stl"

# errors DISTANCE: prints the errors for a body at that distance from the origin, in km.
errors() {
  python3 - "$1" "$folder" "$twrench" <<'END'
import json, pathlib, subprocess, sys

distance, folder, twrench = float(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]
# Exact values by rational arithmetic. Far away the coordinates themselves are rounded, by 1e-16 of
# the distance.
exact_volume, exact_moments = 7.6988168847477665, (2.861959401240807, 8.623292414962608,
                                                   9.129415281983114)
lines = []
for line in pathlib.Path("assets/meshes/toutatis.obj").read_text().splitlines():
    words = line.split()
    if words[0] == "v":
        line = "v " + " ".join(repr(float(w) + distance) for w in words[1:])
    lines.append(line)
(folder / "body.obj").write_text("\n".join(lines) + "\n")
(folder / "body.xml").write_text(
    '<mujoco><compiler exactmeshinertia="true"/><asset><mesh name="a" file="body.obj"/></asset>'
    '<worldbody><body><freejoint/><geom type="mesh" mesh="a" density="1"/></body></worldbody>'
    "</mujoco>")
found = json.loads(subprocess.check_output(
    [twrench, "inertia", folder / "body.obj", "--unit", "cm", "--format", "json"]))
ours = [found["volume"], *found["principal_moments"]]
theirs = sorted(map(float, subprocess.check_output([folder / "mujoco", folder / "body.xml"]).split()))
theirs = [theirs[1], theirs[0], *theirs[2:]]  # put the mass between two moments
for name, values in (("twrench", ours), ("MuJoCo", theirs)):
    volume = abs(values[0] / exact_volume - 1)
    moments = max(abs(a - b) for a, b in zip(values[1:], exact_moments)) / exact_moments[2]
    print(f"{name:<10} {distance:>10g} {volume:>10.1e} {moments:>10.1e}")
END
}

printf '\n%-10s %10s %10s %10s\n' Toutatis "km away" volume moments
for distance in 0 10 1000 100000; do errors "$distance"; done
