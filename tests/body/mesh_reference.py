#!/usr/bin/python3
"""Computes the exact integrals for triangle_mesh_test.cpp: mesh_reference.py.

Makes the same bodies as sample_meshes.h, coordinate by coordinate, integrates over them in rational
arithmetic, rounds once, and prints the lines of mesh_reference.inc. This takes a minute.
"""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

Point = tuple[float, float, float]
Mesh = tuple[list[Point], list[tuple[int, int, int]]]


class Random:
    """Knuth's linear congruential generator for 64 bits."""

    def __init__(self, seed: int) -> None:
        self.state = seed

    def uniform(self) -> float:
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) % 2**64
        return (self.state >> 11) * 2.0**-53


def tetrahedron(seed: int, flatness: float) -> Mesh:
    random = Random(seed)
    points = []
    for _ in range(4):
        x, y, z = (random.uniform() - 0.5 for _ in range(3))
        points.append((x, y, (x + y) / 2 + z * flatness))
    faces = [(0, 1, 2), (0, 3, 1), (1, 3, 2), (0, 2, 3)]
    if integrals(points, faces)[0] < 0:
        faces = [(a, c, b) for a, b, c in faces]
    return points, faces


def lumpy_cube(n: int) -> Mesh:
    """Returns a cube's surface as a grid of n x n squares per side, each point moved radially."""
    index: dict[tuple[int, int, int], int] = {}
    points: list[Point] = []
    faces = []

    def point(i: int, j: int, k: int) -> int:
        if (i, j, k) not in index:
            index[i, j, k] = len(points)
            stretch = 1 + Random((i * 1009 + j) * 1009 + k).uniform() / 8
            points.append(tuple((2 * c / n - 1) * stretch for c in (i, j, k)))
        return index[i, j, k]

    for side in range(6):
        axis, end = side // 2, side % 2
        for u in range(n):
            for v in range(n):
                corners = []
                for du, dv in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    place = [0, 0, 0]
                    place[axis] = n * end
                    place[(axis + 1) % 3] = u + du
                    place[(axis + 2) % 3] = v + dv
                    corners.append(point(*place))
                a, b, c, d = corners if end else corners[::-1]
                faces += [(a, b, c), (a, c, d)]
    return points, faces


def hollow(outside: Mesh, thinness: float) -> Mesh:
    """Returns a body with a cavity of the same shape, so that only a thin layer remains."""
    points, faces = outside
    inside = [tuple(c * (1 - thinness) for c in p) for p in points]
    n = len(points)
    return points + inside, faces + [(a + n, c + n, b + n) for a, b, c in faces]


def moved(mesh: Mesh, shift: Point) -> Mesh:
    return [tuple(c + s for c, s in zip(p, shift)) for p in mesh[0]], mesh[1]


def toutatis() -> Mesh:
    points, faces = [], []
    file = Path(__file__).parents[2] / "assets/meshes/toutatis.obj"
    for words in map(str.split, file.read_text().splitlines()):
        if words[0] == "v":
            points.append(tuple(map(float, words[1:])))
        if words[0] == "f":
            faces.append(tuple(int(w) - 1 for w in words[1:]))
    return points, faces


def integrals(points: list[Point], faces: list[tuple[int, int, int]]) -> list[Fraction]:
    """Returns the volume, centroid, and inertia (xx, yy, zz, yz, xz, xy) for density 1."""
    exact = [tuple(map(Fraction, p)) for p in points]
    pairs = [(0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1)]
    volume, first, second = Fraction(0), [Fraction(0)] * 3, [Fraction(0)] * 6
    for face in faces:
        a, b, c = (exact[i] for i in face)
        det = (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
               + a[2] * (b[0] * c[1] - b[1] * c[0]))
        s = [sum(x) for x in zip(a, b, c)]
        volume += det / 6
        first = [f + det * x / 24 for f, x in zip(first, s)]
        second = [m + det * (a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + s[i] * s[j]) / 120
                  for m, (i, j) in zip(second, pairs)]
    if volume <= 0:
        return [volume]
    centre = [f / volume for f in first]
    xx, yy, zz, yz, xz, xy = (m - volume * centre[i] * centre[j]
                              for m, (i, j) in zip(second, pairs))
    return [volume, *centre, yy + zz, xx + zz, xx + yy, -yz, -xz, -xy]


def main() -> None:
    shift = (1e4, -2e4, 3e4)
    bodies = {f"tetrahedron {seed}": tetrahedron(seed, 1.0) for seed in range(4)}
    bodies["flat tetrahedron"] = tetrahedron(4, 2.0**-20)
    bodies["lumps"] = lumpy_cube(92)
    bodies["hollow"] = hollow(lumpy_cube(16), 2.0**-12)
    bodies["toutatis"] = toutatis()
    bodies |= {f"{name}, far away": moved(mesh, shift) for name, mesh in list(bodies.items())[3:]}
    for name, mesh in bodies.items():
        numbers = ", ".join(repr(float(x)) for x in integrals(*mesh))
        print(f'{{"{name}", {len(mesh[1])}, {{{numbers}}}}},')


if __name__ == "__main__":
    main()
