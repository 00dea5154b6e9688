"""Lettering and line drawings: polygons in a plane.

A drawing is a list of polygons (x, y), counter-clockwise. A polygon may be concave, but has no holes: a shape with
a hole is made of polygons that share edges.
"""
import math

from surfaces import add, closed, tangents


def moved(drawing, x, y, scale=1.0):
    return [[(x + scale * u, y + scale * v) for u, v in polygon] for polygon in drawing]


def sides(path, width):
    """The left and the right side of a line of that width along a path."""
    flat = [(x, y, 0.0) for x, y in path]
    offsets = [(-v, u, 0.0) for u, v, _ in tangents(flat)]
    return ([add(p, o, side * width / 2.0)[:2] for p, o in zip(flat, offsets)] for side in (1.0, -1.0))


def line(path, width):
    left, right = sides(path, width)
    return [right + left[::-1]]


def hoop(outer, inner):
    """The area between two closed curves of equally many points, cut into two halves."""
    half = len(outer) // 2
    outer, inner = closed(outer), closed(inner)
    return [outer[:half + 1] + inner[half::-1], outer[half:] + inner[:half - 1:-1]]


def arc(x, y, radius, first, last, steps):
    """Points on a circle, from one angle to another in degrees."""
    angles = [math.radians(first + (last - first) * i / steps) for i in range(steps + 1)]
    return [(x + radius * math.cos(a), y + radius * math.sin(a)) for a in angles]


def oval(u, v, steps):
    return [(u * x, v * y) for x, y in arc(0.0, 0.0, 1.0, 0.0, 360.0, steps)[:-1]]


def rectangle(u, v):
    return [(u, v), (-u, v), (-u, -v), (u, -v)]


def bowl(stroke, low, width, steps):
    """The right part of a P, from its stem to the right: a band round a half circle of height 1 - low."""
    high, radius = 1.0, (1.0 - low) / 2.0
    middle = width - radius
    outer = arc(middle, low + radius, radius, -90.0, 90.0, 2 * steps)
    inner = arc(middle, low + radius, radius - stroke, -90.0, 90.0, 2 * steps)
    return [(stroke, low), *outer, (0.5 * stroke, high), (stroke, high - stroke), *inner[::-1], (stroke, low + stroke)]


def letters(steps):
    """Capitals and digits 1 high, as (width, drawing), those that are printed; `steps` segments in an eighth of an O."""
    s, low = 0.17, 0.44  # the width of the strokes, and where the bowls of P and R begin
    stem = [(0.0, 0.0), (s, 0.0), (s, low), (s, low + s), (s, 1.0 - s), (0.5 * s, 1.0), (0.0, 1.0)]
    radius = (1.0 - s) / 4.0
    spine = arc(0.3, 1.0 - s / 2.0 - radius, radius, 40.0, 270.0, 3 * steps) + \
        arc(0.3, s / 2.0 + radius, radius, 90.0, -140.0, 3 * steps)[1:]
    foot, top, bar = 0.4, 0.1, 0.22  # half an A: the outside of its leg, the end of that, the crossbar
    slope = foot - top
    def leg(side):
        inside = foot - s * 1.12
        def at(y):
            return inside - slope * y
        half = [(foot, 0.0), (top, 1.0), (0.0, 1.0), (0.0, inside / slope), (at(bar + s), bar + s), (0.0, bar + s),
                (0.0, bar), (at(bar), bar), (inside, 0.0)]
        return [(foot + side * x, y) for x, y in half][::int(side)]
    return {
        "A": (2.0 * foot, [leg(1.0), leg(-1.0)]),
        "I": (s, [[(0.0, 0.0), (s, 0.0), (s, 1.0), (0.0, 1.0)]]),
        "L": (0.5, [[(0.0, 0.0), (0.5, 0.0), (0.5, s), (s, s), (s, 1.0), (0.0, 1.0)]]),
        "N": (0.76, [[(0.0, 0.0), (s, 0.0), (s, 0.72), (0.76 - s, 0.0), (0.76, 0.0), (0.76, 1.0), (0.76 - s, 1.0),
                      (0.76 - s, 0.28), (s, 1.0), (0.0, 1.0)]]),
        "O": (1.0, moved(hoop(oval(0.5, 0.52, 8 * steps), oval(0.5 - s, 0.52 - s, 8 * steps)), 0.5, 0.5)),
        "P": (0.62, [stem, bowl(s, low, 0.62, steps)]),
        "R": (0.68, [stem, [(s, low), (0.18, low), (0.34, low), *bowl(s, low, 0.62, steps)[2:]],
                     [(0.34, low), (0.18, low), (0.46, 0.0), (0.66, 0.0)]]),
        "S": (0.6, line(spine[::-1], s)),
        "T": (0.7, [[(0.0, 1.0 - s), (0.35 - s / 2.0, 1.0 - s), (0.35 - s / 2.0, 0.0), (0.35 + s / 2.0, 0.0),
                     (0.35 + s / 2.0, 1.0 - s), (0.7, 1.0 - s), (0.7, 1.0), (0.0, 1.0)]]),
        "0": (0.66, moved(hoop(oval(0.33, 0.52, 8 * steps), oval(0.33 - s, 0.52 - s, 8 * steps)), 0.33, 0.5)),
        "1": (0.36, [[(0.36 - s, 0.0), (0.36, 0.0), (0.36, 1.0), (0.36 - s, 1.0), (0.0, 0.82), (0.0, 0.66),
                      (0.36 - s, 0.8)]]),
        "7": (0.6, [[(0.12, 0.0), (0.12 + s * 1.1, 0.0), (0.6, 1.0 - s), (0.6, 1.0), (0.0, 1.0), (0.0, 1.0 - s),
                     (0.6 - s * 1.1, 1.0 - s)]]),
        ":": (s, [[(0.0, y), (s, y), (s, y + s), (0.0, y + s)] for y in (0.2, 0.65)]),
        ".": (s, [[(0.0, 0.0), (s, 0.0), (s, s), (0.0, s)]]),
        " ": (0.2, []),
    }


def lettering(text, height, steps):
    """Returns the drawing of each letter in a centred line of that height."""
    alphabet, gap = letters(steps), 0.16
    width = sum(alphabet[c][0] + gap for c in text) - gap
    at, drawings = -width / 2.0, []
    for c in text:
        advance, drawing = alphabet[c]
        if drawing:
            drawings.append(moved(drawing, height * at, -height / 2.0, height))
        at += advance + gap
    return drawings


def polhodes(u, v, width, levels, steps):
    """An ellipsoid with semi-axes u and v in the plane, seen along its intermediate axis, with polhodes.

    `levels` are their least distances from that axis, and `steps` is the number of segments of a whole polhode.
    """
    def within(curve, most=0.93):
        inside = [(x, y) for x, y in curve if math.hypot(x, y) < most]
        return [(u * x, v * y) for x, y in inside]
    drawings = [hoop(oval(u, v, 4 * steps), oval(u - 1.4 * width, v - 1.4 * width, 4 * steps)),
                [oval(1.3 * width, 1.3 * width, 8)]]
    rates = [-1.5 + 3.0 * i / steps for i in range(steps + 1)]
    for level in levels:
        for side in (-1.0, 1.0):
            across = [(side * level * math.cosh(t), 1.1 * level * math.sinh(t)) for t in rates]
            along = [(level * math.sinh(t), side * 1.1 * level * math.cosh(t)) for t in rates]
            drawings += [line(within(across), width), line(within(along), width)]
    for angle in (1, 3, 5, 7):  # the separatrix
        x, y = (math.copysign(1.0, f(math.pi / 4.0 * angle)) for f in (math.cos, math.sin))
        arm = [(x * t, 1.1 * y * t) for t in (0.13 + 0.51 * i / 4 for i in (0, 4))]
        drawings.append(line([(u * a, v * b) for a, b in arm], width))
    return drawings
