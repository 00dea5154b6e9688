"""Writes tests/reference/cases.json: the motions of the published cases in assets/cases, to 25 digits.

A Taylor series of order 40 for omega and the quaternion, in mpmath with 40 digits, from the numbers of the case
files in double precision: their rounding, which a motion near the separatrix amplifies a thousandfold, is no error of
a program that reads them. Energy and angular momentum must hold to 1e-30, and half the step must give the same
digits. Only this script needs mpmath; the tests read its output.
"""
import json
import math
import pathlib
import tomllib

from mpmath import mp, mpf, nstr, sqrt

mp.dps = 40
ORDER = 40


def cauchy(a, b, n):
    """The n-th coefficient of the product of two series."""
    return sum(a[i] * b[n - i] for i in range(n + 1))


def value(series, h):
    return sum(c * h**n for n, c in enumerate(series))


def step(inertia, omega, q, h):
    """omega and q after the time h."""
    a, b, c = inertia
    factors = ((b - c) / a, (c - a) / b, (a - b) / c)
    w = [[x] for x in omega]
    p = [[x] for x in q]
    for n in range(ORDER):
        for i in range(3):
            j, k = (i + 1) % 3, (i + 2) % 3
            w[i].append(None)
            w[i][n + 1] = factors[i] * cauchy(w[j][:n + 1], w[k][:n + 1], n) / (n + 1)
        x, y, z = (v[:n + 1] for v in w)
        s, u, v, t = (list(series) for series in p)
        p[0].append(-(cauchy(u, x, n) + cauchy(v, y, n) + cauchy(t, z, n)) / 2 / (n + 1))
        p[1].append((cauchy(s, x, n) + cauchy(v, z, n) - cauchy(t, y, n)) / 2 / (n + 1))
        p[2].append((cauchy(s, y, n) + cauchy(t, x, n) - cauchy(u, z, n)) / 2 / (n + 1))
        p[3].append((cauchy(s, z, n) + cauchy(u, y, n) - cauchy(v, x, n)) / 2 / (n + 1))
    return [value(s, h) for s in w], [value(s, h) for s in p]


def rotated(q, v):
    """q v q*."""
    w, x, y, z = q
    a, b, c = v
    u = (y * c - z * b, z * a - x * c, x * b - y * a)
    return [v[0] + 2 * (w * u[0] + y * u[2] - z * u[1]),
            v[1] + 2 * (w * u[1] + z * u[0] - x * u[2]),
            v[2] + 2 * (w * u[2] + x * u[1] - y * u[0])]


def energy(inertia, omega):
    return sum(i * w * w for i, w in zip(inertia, omega)) / 2


def momentum(inertia, omega, q):
    return rotated(q, [i * w for i, w in zip(inertia, omega)])


def states(case, longest):
    """The states at the times of the case, with steps of at most `longest` rad of rotation."""
    inertia = [mpf(x) for x in case["inertia"]["moments"]]
    unit = {"rad/s": 1.0, "deg/s": math.pi / 180}[case["initial"]["unit"]]
    omega = [mpf(x * unit) for x in case["initial"]["omega"]]
    given = case["initial"].get("attitude", {"w": 1, "x": 0, "y": 0, "z": 0})
    q = [mpf(given[c]) for c in "wxyz"]
    speed = sqrt(2 * energy(inertia, omega) / min(inertia))
    times = {mpf(p["time"]) for p in case.get("published", [])} | {mpf(0), mpf(case["duration"])}
    start_energy, start_momentum = energy(inertia, omega), momentum(inertia, omega, q)
    now, found = mpf(0), []
    for t in sorted(times):
        steps = int((t - now) * speed / longest) + 1 if t > now else 0
        for _ in range(steps):
            omega, q = step(inertia, omega, q, (t - now) / steps)
        now = t
        error = max([abs(energy(inertia, omega) / start_energy - 1)] +
                    [abs(a - b) for a, b in zip(momentum(inertia, omega, q), start_momentum)])
        assert error < mpf("1e-30"), error
        found.append((t, omega, q, start_energy, start_momentum))
    return found


def digits(values):
    return [nstr(x, 25) for x in values]


def main():
    here = pathlib.Path(__file__).parent
    result = []
    for file in sorted((here.parent.parent / "assets/cases").glob("*.toml")):
        case = tomllib.loads(file.read_text())
        coarse, fine = states(case, mpf("0.5")), states(case, mpf("0.25"))
        samples = []
        for (t, omega, q, e, L), (_, omega2, q2, _, _) in zip(coarse, fine):
            assert max(abs(a - b) for a, b in zip(omega + q, omega2 + q2)) < mpf("1e-27")
            samples.append({"t": nstr(t, 25), "omega": digits(omega2), "quaternion": digits(q2), "energy": nstr(e, 25),
                            "momentum": digits(L)})
        result.append({"name": file.stem, "samples": samples})
    (here / "cases.json").write_text(json.dumps(result, indent=1) + "\n")


main()
