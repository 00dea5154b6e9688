"""Closed surfaces made of polygons, and their OBJ files. Lengths in mm.

A surface is a list of solids; a solid is a list of polygons, each a list of points (x, y, z) or, if it is
painted, (x, y, z, red, green, blue). Points that agree to 0.01 mm are one vertex, so that solids are closed
by points that coincide; `indexed` checks that they are.
"""
import math

DIGITS = 2  # of the coordinates in a file


def smooth(x):
    """Rises from 0 at 0 to 1 at 1 without kinks, constant outside."""
    x = min(max(x, 0.0), 1.0)
    return x * x * (3.0 - 2.0 * x)


def mix(a, b, x):
    return a + (b - a) * x


def add(a, b, factor=1.0):
    return tuple(x + factor * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = math.sqrt(sum(x * x for x in a))
    return tuple(x / length for x in a)


def grid(rows):
    """The quadrilaterals between rows of equally many points."""
    return [[a[i], a[i + 1], b[i + 1], b[i]] for a, b in zip(rows, rows[1:]) for i in range(len(a) - 1)]


def closed(ring):
    return [*ring, ring[0]]


def cap(ring):
    """A fan of triangles from the centre of a ring."""
    centre = tuple(sum(c) / len(ring) for c in zip(*ring))
    return [[a, b, centre] for a, b in zip(ring, closed(ring)[1:])]


def loft(rings):
    """The solid through rings of equally many points, with a fan at either end."""
    return grid([closed(ring) for ring in rings]) + cap(rings[0][::-1]) + cap(rings[-1])


def tangents(path):
    """The directions of a path of points, by central differences; one-sided at the ends."""
    last = len(path) - 1
    return [unit(add(path[min(i + 1, last)], path[max(i - 1, 0)], -1.0)) for i in range(len(path))]


def sweep(path, section, side=(0.0, 0.0, 1.0)):
    """The solid that a section sweeps along a path.

    `section(i)` gives points (u, v) at point i of the path: u across both the path and `side`, v along `side`, which
    is a unit vector not parallel to the path.
    """
    rings = []
    for i, (point, along) in enumerate(zip(path, tangents(path))):
        across = unit(cross(side, along))
        rings.append([add(add(point, across, u), side, v) for u, v in section(i)])
    return loft(rings)


def ellipse(u, v, count, power=2.0):
    """Points of the ellipse with semi-axes u and v; a higher power squares it up."""
    def bent(x):
        return math.copysign(abs(x) ** (2.0 / power), x)
    angles = [2.0 * math.pi * (i + 0.5) / count for i in range(count)]
    return [(u * bent(math.cos(a)), v * bent(math.sin(a))) for a in angles]


def rounded_rectangle(u, v, radius, steps):
    """Points of the rectangle with half sides u and v, whose corners are arcs of `steps` segments."""
    points = []
    for corner, (su, sv) in enumerate([(1, 1), (-1, 1), (-1, -1), (1, -1)]):
        for i in range(steps + 1):
            a = math.pi / 2.0 * (corner + i / steps)
            points.append((su * (u - radius) + radius * math.cos(a), sv * (v - radius) + radius * math.sin(a)))
    return points




def round_rows(profile, count):
    """Rows of points of a surface of revolution about x, for pairs (x, radius)."""
    angles = [2.0 * math.pi * (i % count) / count for i in range(count + 1)]
    return [[(x, r * math.cos(a), r * math.sin(a)) for a in angles] for x, r in profile]


def thread_rows(start, end, radius, depth, pitch, count):
    """Rows of points of a metric thread about x, which runs out at both ends.

    `radius` is that of the ends, and the thread is cut `depth` into them (outwards if negative). The rows follow its
    helix, so that its edges are sharp; where they would leave [start, end] they lie on its ends.
    """
    offsets = [(0.0, 0.0), (0.125, 0.0), (0.4375, 1.0), (0.6875, 1.0)]  # crest, flank, root, flank, in pitches
    turns = [n + o for n in range(-2, math.ceil((end - start) / pitch) + 1) for o, _ in offsets]
    cuts = [c for _, c in offsets] * (len(turns) // len(offsets))
    rows = []
    for turn, cut in zip(turns, cuts):
        row = []
        for i in range(count + 1):
            x = min(max(start + pitch * (turn + i / count), start), end)
            r = radius - depth * cut * smooth((x - start) / pitch) * smooth((end - x) / pitch)
            a = 2.0 * math.pi * (i % count) / count
            row.append((x, r * math.cos(a), r * math.sin(a)))
        rows.append(row)
    return rows


def revolved(rows):
    """The solid about x through rows of points, with a fan at either end.

    The rows at the ends are closed. A row of a thread ends where a later row begins.
    """
    return grid(rows) + cap(rows[0][:-1][::-1]) + cap(rows[-1][:-1])


def painted(color, polygons):
    """Polygons in a colour "#rrggbb"."""
    channels = tuple(int(color[i:i + 2], 16) / 255.0 for i in (1, 3, 5))
    return [[point + channels for point in polygon] for polygon in polygons]


def indexed(solid, is_open=False):
    """The vertices and the faces of a solid, outward, or of an open surface.

    Raises ValueError unless it is a manifold, and closed if it is a solid.
    """
    numbers, faces = {}, []
    for polygon in solid:
        ids = [numbers.setdefault(tuple(round(c, DIGITS) + 0.0 for c in p), len(numbers)) for p in polygon]
        face = [v for i, v in enumerate(ids) if v != ids[i - 1]]
        if len(set(face)) > 2:
            faces.append(face)
    edges = [(a, b) for f in faces for a, b in zip(f, f[1:] + f[:1])]
    once = set(edges)
    if len(once) < len(edges) or not is_open and any((b, a) not in once for a, b in once):
        raise ValueError("the solid is not closed, or not a manifold")
    vertices = list(numbers)
    if not is_open and volume(vertices, faces) < 0.0:
        faces = [face[::-1] for face in faces]
    return vertices, faces


def volume(vertices, faces):
    """The volume in mm^3 inside closed faces, by the divergence theorem; negative if they face inwards."""
    total = 0.0
    for face in faces:
        a = vertices[face[0]]
        for b, c in zip(face[1:], face[2:]):
            total += sum(x * y for x, y in zip(a, cross(vertices[b], vertices[c]))) / 6.0
    return total


def obj(comment, solids, is_open=False):
    """The text of an OBJ file of solids, or of open surfaces; colours, if any, follow the coordinates."""
    lines, faces_text, first = [f"# {comment}"], [], 1
    for solid in solids:
        vertices, faces = indexed(solid, is_open)
        lines += ["v " + " ".join(f"{c:.{DIGITS}f}".rstrip("0").rstrip(".") for c in v) for v in vertices]
        faces_text += ["f " + " ".join(str(first + i) for i in face) for face in faces]
        first += len(vertices)
    return "\n".join(lines + faces_text) + "\n"
