#!/usr/bin/env python3
"""Makes the meshes of the built-in scenes, beside this file; with --check, says whether they are what it makes.

toutatis.obj is not made here: it is from radar (THIRD-PARTY.md). All others are in mm. Each solid in them is closed;
where two touch, one ends just inside the other, so that there is no gap and hardly any overlap.
"""
import math
import pathlib
import sys

sys.dont_write_bytecode = True  # no __pycache__ beside the meshes
from prints import arc, hoop, lettering, moved, polhodes, rectangle
from surfaces import (add, cap, closed, ellipse, grid, loft, mix, obj, painted, revolved, round_rows, rounded_rectangle,
                      smooth, sweep, thread_rows, unit)

FOLDER = pathlib.Path(__file__).resolve().parent


def t_handle_shaft():
    """The shaft of a T-handle: collar, shank and M10 thread. It begins on a bar of radius 8 along y."""
    count, collar = 72, 7.5
    saddle = [(math.sqrt(64.0 - (collar * math.cos(a)) ** 2) - 0.2, collar * math.cos(a), collar * math.sin(a))
              for a in (2.0 * math.pi * (i % count) / count for i in range(count + 1))]
    rows = [saddle] + round_rows([(17.0, 7.5), (18.0, 6.5), (38.0, 6.5), (39.5, 5.0)], count)
    rows += thread_rows(39.5, 69.0, 5.0, 0.92, 1.5, count)
    rows += round_rows([(69.0, 5.0), (70.5, 3.8)], count)
    return [revolved(rows)]


NUT = [(0.0, 7.2), (0.8, 8.0), (2.0, 8.0), (9.4, 6.4), (10.0, 5.8)]  # the outside of the wing nut's hub


def wing_nut_hub():
    """The hub of a wing nut after DIN 315, M8, along x from 0, with a thread inside."""
    count = 72
    inside = thread_rows(0.6, 9.4, 4.0, 0.68, 1.25, count)
    ends = round_rows([(10.0, 4.5)], count), round_rows([(0.0, 4.5)], count)
    return [grid(round_rows(NUT, count) + ends[0] + inside[::-1] + ends[1] + round_rows(NUT[:1], count))]


def wing_nut_wings():
    """Its wings, along y, which begin on the hub: thick and low there, thin and high at the round end."""
    return [wing(1.0), wing(-1.0)]


def on_nut(x, z):
    """How far from the axis the hub is in the direction of a wing, 0.2 mm inside."""
    (x0, r0), (x1, r1) = next(pair for pair in zip(NUT, NUT[1:]) if x <= pair[1][0])
    return math.sqrt(mix(r0, r1, (x - x0) / (x1 - x0)) ** 2 - z * z) - 0.2


def wing(side):
    """A wing on the side of y that `side` has the sign of."""
    rings, reach, steps = [], 19.5, 28
    for i in range(steps + 1):
        s = 1.0 - (1.0 - i / steps) ** 1.6 if i < steps else 0.999
        y = mix(5.6, reach, s)
        rise = smooth((y - 6.0) / 9.0)
        round_end = math.sqrt(max(1.0 - max((y - 11.5) / (reach - 11.5), 0.0) ** 2, 0.0))
        middle, half = mix(5.2, 13.0, rise), mix(4.2, 7.0, rise) * max(round_end, 0.06)
        thick = mix(1.5, 1.15, rise) + 2.2 * math.exp(-(y - 5.6) / 1.6)
        thick *= 0.35 + 0.65 * round_end
        section = [(middle + u, v) for u, v in ellipse(half, thick, 32, 2.6)]
        near = 1.0 - smooth(s / 0.35)  # only near the hub do the sections follow it
        starts = [on_nut(min(max(x, 1.0), 9.4), v) for x, v in section]
        rings.append([(x, side * (y + near * (start - 5.6)), v) for (x, v), start in zip(section, starts)])
    return loft(rings)


HEAD_CENTRE, HEAD_X, HEAD_Y = 509.0, 132.0, 170.0  # the ellipse in the middle of a racket's frame


def on_head(angle):
    return (HEAD_X * math.cos(angle), HEAD_CENTRE + HEAD_Y * math.sin(angle), 0.0)


def throat_arm():
    """The points of the right arm of a racket's throat, from the handle up to where it meets the head."""
    joint = math.radians(-52.0)
    ends = (13.0, 200.0, 0.0), on_head(joint)
    leaving = unit((0.16, 1.0, 0.0))
    meeting = unit((-HEAD_X * math.sin(joint), HEAD_Y * math.cos(joint), 0.0))
    controls = [ends[0], add(ends[0], leaving, 85.0), add(ends[1], meeting, -75.0), ends[1]]
    points = []
    for i in range(20):
        t = i / 20.0
        weights = [(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3]
        points.append(tuple(sum(w * c[k] for w, c in zip(weights, controls)) for k in range(3)))
    return points


def racket_frame():
    """The frame of a racket in the xy plane, its handle along y from 0: throat and head."""
    arm = throat_arm()
    around = [on_head(math.radians(-52.0 + 284.0 * i / 108)) for i in range(109)]
    hoop = arm + around + [(-x, y, z) for x, y, z in arm[::-1]]
    beam = ellipse(6.0, 11.5, 20, 2.8)
    return [sweep(hoop, lambda i: beam)]


def racket_bridge():
    """The bridge of its throat, which completes the head."""
    bridge = [on_head(math.radians(-54.0 - 72.0 * i / 28)) for i in range(29)]
    return [sweep(bridge, lambda i: ellipse(4.0, 8.5, 16, 2.8))]


def racket_handle():
    """The handle of a racket along y from 0: butt cap, eight-sided grip, and the collar from which the throat grows."""
    def octagon(u, v, y):
        cut = 0.42
        corners = [(1, cut), (cut, 1), (-cut, 1), (-1, cut), (-1, -cut), (-cut, -1), (cut, -1), (1, -cut)]
        return [(u * a, y, v * b) for a, b in corners]
    sizes = [(0.0, 17.5, 15.5), (2.0, 19.5, 17.5), (9.0, 19.5, 17.5), (24.0, 16.5, 14.5), (186.0, 15.5, 13.5),
             (187.0, 16.3, 14.3), (193.0, 16.3, 14.3), (194.0, 15.5, 13.3), (222.0, 20.3, 12.6), (226.0, 19.6, 11.9)]
    return [loft([octagon(u, v, y) for y, u, v in sizes])]


def racket_sleeve():
    """The sleeve over the ends of its throat."""
    sizes = [(172.0, 17.0, 15.4), (186.0, 19.0, 16.6), (230.0, 26.0, 15.6), (232.0, 24.8, 14.4)]
    return [loft([[(x, y, z) for x, z in rounded_rectangle(u, v, 4.0, 4)] for y, u, v in sizes])]


def racket_strings():
    """The strings of a racket, 16 by 19, woven, and ending inside the frame."""
    half_width, half_length, lift = HEAD_X - 4.0, HEAD_Y - 4.0, 0.66
    mains = [-97.5 + 13.0 * i for i in range(16)]
    crosses = [15.4 * (j - 9) for j in range(19)]
    def half(offset, reach, other_reach):
        return other_reach * math.sqrt(1.0 - (offset / reach) ** 2)
    def along(crossings, end):
        """Points (position, z) of a string, which keeps its height from the last crossing to the end."""
        inner = [(at, z) for at, z in crossings if abs(at) < end]
        return [(-end, inner[0][1]), *inner, (end, inner[-1][1])]
    wires = []
    for i, x in enumerate(mains):
        woven = along([(y, lift * (-1) ** (i + j)) for j, y in enumerate(crosses)], half(x, half_width, half_length))
        wires.append([(x, HEAD_CENTRE + y, z) for y, z in woven])
    for j, y in enumerate(crosses):
        woven = along([(x, -lift * (-1) ** (i + j)) for i, x in enumerate(mains)], half(y, half_length, half_width))
        wires.append([(x, HEAD_CENTRE + y, z) for x, z in woven])
    return [sweep(wire, lambda i: ellipse(0.65, 0.65, 6)) for wire in wires]


def hammer_head():
    """The head of a claw hammer of 16 ounces, along x, with its eye at y = 318, without claws."""
    poll = [(-15.0, 12.8, 11.6, 5.0), (-10.0, 14.4, 13.0, 5.0), (12.0, 14.4, 13.0, 5.0), (20.0, 11.5, 11.5, 2.6),
            (25.0, 10.4, 10.4, 2.0), (33.0, 10.4, 10.4, 2.0), (38.0, 13.9, 13.9, 2.0), (54.0, 14.3, 14.3, 2.0),
            (55.5, 13.3, 13.3, 2.0)]
    return [loft([[(x, 318.0 + y, z) for y, z in ellipse(u, v, 48, p)] for x, u, v, p in finer(poll, 4)])]


def hammer_claws():
    """Its two claws, curved towards -y, with a slot between them."""
    return [claw(1.0), claw(-1.0)]


def finer(stations, steps):
    """Stations (position, values...) with smooth steps between each two."""
    fine = []
    for a, b in zip(stations, stations[1:]):
        sharp = b[0] - a[0] < 2.0
        for i in range(1 if sharp else steps):
            t = i / steps
            fine.append((mix(a[0], b[0], t), *(mix(p, q, smooth(t)) for p, q in zip(a[1:], b[1:]))))
    return fine + [stations[-1]]


def claw(side):
    """A claw: a wedge along an arc in the xy plane."""
    steps, radius = 24, 82.0
    path = [(-14.7 - radius * math.sin(a), 320.0 - radius * (1.0 - math.cos(a)), 0.0)
            for a in (0.92 * i / steps for i in range(steps + 1))]
    def section(i):
        t = i / steps
        inner, outer = mix(0.5, 5.4, t), mix(11.4, 13.0, t)
        half = mix(11.5, 1.2, t ** 0.75)
        return [(u, side * (inner + outer) / 2.0 + v) for u, v in ellipse(half, (outer - inner) / 2.0, 24, 5.0)]
    return sweep(path, section)


def hammer_handle():
    """The handle of a claw hammer along y from 0 at its butt: oval, thick at the grip, through the head at 318."""
    sizes = [(0.0, 9.0, 6.5), (1.2, 12.5, 9.5), (4.0, 15.0, 11.5), (12.0, 15.6, 12.0), (30.0, 14.0, 11.0),
             (95.0, 14.8, 11.4), (150.0, 14.0, 11.0), (215.0, 10.6, 8.8), (270.0, 10.2, 8.4), (300.0, 11.0, 8.8),
             (334.0, 10.6, 8.4), (335.0, 9.8, 7.6)]
    return [loft([[(x, y, z) for x, z in ellipse(u, v, 36, 2.3)] for y, u, v in finer(sizes, 5)])]


PHONE_X, PHONE_Y, PHONE_Z = 36.0, 75.0, 4.0  # half the sizes of a phone


def phone_outline(inset):
    return rounded_rectangle(PHONE_X - inset, PHONE_Y - inset, 11.0 - inset, 10)


def phone():
    """A phone, 72 by 150 by 8 mm, with round corners and edges, and a picture on the side of +z."""
    edge, steps = 2.2, 5
    def ring(inset, z):
        return [(x, y, z) for x, y in phone_outline(inset)]
    rings = []
    for i in range(-steps, steps + 1):
        a = math.pi / 2.0 * i / steps
        sides = (-1.0, 1.0) if i == 0 else (math.copysign(1.0, i),)
        rings += [ring(edge * (1.0 - math.cos(a)), edge * math.sin(a) + side * (PHONE_Z - edge)) for side in sides]
    rim, screen = ring(2.6, PHONE_Z), ring(2.65, PHONE_Z)
    body = painted("#8fa6b8", cap(rings[0][::-1]) + grid([closed(r) for r in [*rings, rim]]))
    def on_screen(x, y, z):
        height = 0.5 + 0.5 * y / PHONE_Y
        return x, y, z, mix(0.03, 0.16, height), mix(0.10, 0.34, height), mix(0.30, 0.62, height)
    picture = [[on_screen(*p) if p in screen else (*p, 0.30, 0.22, 0.56) for p in polygon] for polygon in cap(screen)]
    between = [[a, b, on_screen(*d), on_screen(*c)] for (a, b), (c, d) in
               zip(painted("#8fa6b8", zip(rim, closed(rim)[1:])), zip(screen, closed(screen)[1:]))]
    return [body + between + picture]


LENSES = (22.0, 60.0), (22.0, 42.0)  # on the back of the phone


def phone_details():
    """The lenses and the buttons of the phone."""
    def lens(x, y):
        metal, glass = "#a9b1b9", "#0b0d12"
        profile = [(7.6, 3.9), (7.6, 5.1), (7.4, 5.5), (7.0, 5.7), (6.0, 5.7), (5.95, 5.7)]
        *rings, inside = [[(u, v, -z) for u, v in arc(x, y, r, 360.0, 0.0, 48)[:-1]] for r, z in profile]
        step = [[*edge, *within[::-1]] for edge, within in zip(painted(metal, zip(rings[-1], closed(rings[-1])[1:])),
                                                                painted(glass, zip(inside, closed(inside)[1:])))]
        return painted(metal, cap(rings[0][::-1]) + grid([closed(r) for r in rings])) + step + painted(glass, cap(inside))
    def button(side, y, half):
        return loft([[(side * x, y + u, v) for u, v in rounded_rectangle(half - inset, 1.1 - inset, 1.0 - inset, 4)]
                     for x, inset in ((35.8, 0.0), (36.5, 0.0), (36.8, 0.3))])
    buttons = [painted("#7f95a6", button(*each)) for each in ((1.0, 22.0, 8.0), (-1.0, 32.0, 7.0), (-1.0, 14.0, 7.0))]
    return [lens(*centre) for centre in LENSES] + buttons


def phone_print():
    """The edges of its lenses, a lamp, and a border and a lock screen on its picture: open surfaces, 0.1 mm above it."""
    def circle(x, y, radius, steps):
        return arc(x, y, radius, 0.0, 360.0, steps)[:-1]
    def on_back(color, drawing, z):
        return painted(color, [[(x, y, -z) for x, y in polygon[::-1]] for polygon in drawing])
    back = [on_back("#f3ead0", [circle(9.0, 60.0, 2.4, 24)], 4.1)]
    for x, y in LENSES:
        back.append(on_back("#0b0d12", hoop(circle(x, y, 6.2, 40), circle(x, y, 5.4, 40)), 5.8))
        back.append(on_back("#34425c", hoop(circle(x, y, 3.6, 32), circle(x, y, 2.9, 32)), 5.8))
    clock = [moved(digit, 0.0, 42.0) for digit in lettering("17:10", 17.0, 3)]
    white = [*clock, moved([rectangle(13.0, 1.1)], 0.0, 26.5)]
    white += [moved(drawing, 0.0, -12.0) for drawing in polhodes(25.0, 23.0, 0.9, (0.28, 0.52, 0.76), 12)]
    white += [moved([rectangle(13.0, 0.8)], 0.0, -67.0)]
    white += [hoop(circle(x, -53.0, 6.0, 32), circle(x, -53.0, 5.0, 32)) for x in (-22.0, 22.0)]
    black = [hoop(phone_outline(2.2), phone_outline(4.6)), [circle(0.0, 64.0, 2.3, 24)]]
    def on_front(color, drawings):
        return [painted(color, [[(x, y, 4.1) for x, y in polygon] for polygon in drawing]) for drawing in drawings]
    return back + on_front("#f4f6fb", white) + on_front("#050608", black)


CLOTH = "#7c2529"


def book():
    """A book of 154 by 210 by 31 mm: pages and case."""
    return [book_pages(), painted(CLOTH, book_case())]


def book_print():
    """The print on its case, in gold: open surfaces, 0.1 mm above the cloth."""
    front = [[ring(56.0, 97.0, 1.6), ring(52.6, 93.6, 0.8)], lettering("ROTATION", 14.0, 3), polhodes(44.0, 40.0, 1.0, (0.28, 0.52, 0.76), 12),
             lettering("L. POINSOT", 8.0, 2)]
    heights = 0.0, 65.0, -4.0, -73.0
    front = [moved(drawing, 14.0, y) for drawings, y in zip(front, heights) for drawing in drawings]
    back = [moved(drawing, 14.0, 0.0) for drawing in [ring(56.0, 97.0, 1.6), *polhodes(22.0, 20.0, 0.9, (0.4, 0.75), 8)]]
    sheets = [[[(x, y, 15.5) for x, y in polygon] for polygon in drawing] for drawing in front]
    sheets += [[[(x, -y, -15.5) for x, y in polygon] for polygon in drawing] for drawing in back]
    return sheets + book_bands()


def ring(u, v, width):
    """A frame with half sides u and v outside."""
    return hoop(rectangle(u, v), rectangle(u - width, v - width))


def book_pages():
    """The pages, 142 by 204 by 24 mm, with a round back at -x and a hollow fore edge, in sheets of various shades."""
    rings, steps = [], 24
    for i in range(steps + 1):
        w = 2.0 * i / steps - 1.0
        bulge = 4.4 * (1.0 - w * w)
        left, right = -69.5 - bulge, 72.5 - bulge
        shade = 1.0 - 0.2 * (0.618034 * i * i % 1.0)
        rings.append([(x, y, 12.0 * w, 0.94 * shade, 0.91 * shade, 0.85 * shade)
                      for x, y in [(left, -102.0), (right, -102.0), (right, 102.0), (left, 102.0)]])
    return loft(rings)


def book_bands():
    """Bands across the spine."""
    angles = [math.pi / 2.0 * (1.0 - i / 12) for i in range(1, 24)]
    normals = [unit((-14.1 * math.cos(a), 0.0, 11.5 * math.sin(a))) for a in angles]
    path = [add((-67.5 - 11.5 * math.cos(a), 0.0, 14.1 * math.sin(a)), n, 1.4) for a, n in zip(angles, normals)]
    bands = (94.0, 1.6), (89.5, 0.6), (62.0, 0.6), (57.5, 1.6), (22.5, 1.6), (18.0, 0.6), (-62.0, 0.6), (-66.5, 1.6), \
        (-89.5, 0.6), (-94.0, 1.6)
    return [grid([[(x, y + side * half, z) for x, _, z in path] for side in (1.0, -1.0)]) for y, half in bands]


def book_case():
    """Two boards of 2.6 mm, joints, and a round spine, 210 mm high."""
    board = [(76.0 - 126.0 * i / 2, 14.1) for i in range(3)]
    joint = [(-50.0 - 2.0 * i, 14.1 - 0.7 * math.sin(math.pi * i / 8) ** 2) for i in range(1, 9)]
    angles = [math.pi / 2.0 * (1.0 - i / 12) for i in range(1, 13)]
    spine = [(-67.5 - 11.5 * math.cos(a), 14.1 * math.sin(a)) for a in angles]
    half = board + joint + spine
    path = [(x, 0.0, z) for x, z in half + [(x, -z) for x, z in half[-2::-1]]]
    section = [(1.3, 105.0), (-1.3, 105.0), (-1.3, -105.0), (1.3, -105.0)]
    return sweep(path, lambda i: section, (0.0, 1.0, 0.0))


def satellite_payload():
    """The front of Explorer 1, along x: a round nose and the instruments, and the gaps of two antennas."""
    nose = [(1016.0 - 300.0 * (1.0 - math.cos(a)), 2.0 + 74.2 * math.sin(a))
            for a in (math.pi / 2.0 * i / 20 for i in range(21))]
    gaps = [(x + dx, r) for x in (690.0, 330.0) for dx, r in ((8.0, 76.2), (7.0, 74.0), (-7.0, 74.0), (-8.0, 76.2))]
    return [revolved(round_rows(nose + gaps + [(70.0, 76.2)], 96))]


def satellite_stage():
    """The last stage of Explorer 1, along x: case, dome and nozzle."""
    angles = [math.pi / 2.2 * i / 10 for i in range(11)]
    dome = [(-850.0 - 60.0 * math.sin(a), 20.0 + 56.2 * math.cos(a)) for a in angles]
    nozzle = [(-925.0, 21.0), (-1016.0, 50.0), (-1016.0, 47.0), (-930.0, 18.0)]
    return [revolved(round_rows([(70.0, 75.0), (60.0, 76.2), *dome, *nozzle], 96))]


def satellite_stripes():
    """The dark stripes on its payload, and 1.5 mm above it, so that a simplified payload stays below them."""
    def stripe(first, start, end):
        corners = ((start, 77.7), (end, 77.7), (end, 74.68), (start, 74.68))
        angles = [first + math.pi / 4.0 * i / 12 for i in range(13)]
        return loft([[(x, r * math.cos(a), r * math.sin(a)) for x, r in corners] for a in angles])
    return [stripe(math.pi / 2.0 * (i + 0.25), *ends) for ends in ((110.0, 310.0), (350.0, 670.0)) for i in range(4)]


def satellite_whips():
    """Its four whip antennas, 560 mm long, and tapered."""
    def whip(y, z):
        stations = [(72.0, 3.2), (350.0, 2.6), (632.0, 1.6)]
        return loft([[(90.0 + u, y * r - z * v, z * r + y * v) for u, v in ellipse(thick, thick, 10)]
                     for r, thick in stations])
    return [whip(y, z) for y, z in ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))]


SOLIDS = [
    t_handle_shaft, wing_nut_hub, wing_nut_wings, racket_frame, racket_bridge, racket_handle, racket_sleeve,
    racket_strings, phone, phone_details,
    book, hammer_head, hammer_claws, hammer_handle, satellite_payload, satellite_stage, satellite_stripes,
    satellite_whips,
]
SHEETS = [book_print, phone_print]  # open surfaces


def main():
    check = sys.argv[1:] == ["--check"]
    stale = []
    for make in SOLIDS + SHEETS:
        path = FOLDER / f"{make.__name__.replace('_', '-')}.obj"
        text = obj(f"In mm. Made by make_meshes.py: {' '.join(make.__doc__.split())}", make(), make in SHEETS)
        if not check:
            path.write_text(text)
        elif not path.exists() or path.read_text() != text:
            stale.append(path.name)
    if stale:
        sys.exit(f"make_meshes.py: error: {', '.join(stale)}: not what this script makes: run it without --check")


if __name__ == "__main__":
    main()
