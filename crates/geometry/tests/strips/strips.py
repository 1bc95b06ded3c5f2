#!/usr/bin/env python3
"""Developments of random twisted strips with 40 digits, independent of the library.

Writes strips.csv (`strips.py > strips.csv`), or recomputes some rows of it (`strips.py --check N`). A strip is ruled
between two cubic Bezier curves. Its four named developments obey

    theta' = (a1 - a0)/L,   p' = (P' . r) e(theta) + a0 e_perp(theta),   q = p + L e(theta),

with the unit ruling r, its length L, and the speeds a0, a1 across the ruling that the name stands for; see the module
`flattening` of the library. They are integrated here by Chebyshev interpolation with 40 digits on eight intervals; the
same with a third of the nodes more agrees in 25 digits, or the program stops.

Columns: the 24 coordinates of the control points as f64, the largest twist in degrees, then for each of edges, edge-1,
edge-2, between and each of x = 1/4, 1/2, 3/4, 1: p and q, then the flat lengths of both edges.
"""

import random
import sys
from mpmath import mp, mpf, sqrt, cos, sin, pi, tan, radians, degrees

mp.dps = 40
CELLS = 8
NAMES = ["edges", "edge-1", "edge-2", "between"]


def strip(number):
    """Control points of both rails, as f64."""
    rng = random.Random(f"twisted strip {number}")
    twist = 10 ** rng.uniform(-9, 1.3) if number % 2 else 10 ** rng.uniform(-3, 1.3)
    length = 10 ** rng.uniform(1, 3.7)
    width = length * 10 ** rng.uniform(-1.7, 0)
    bend = rng.uniform(0, 0.6) * length
    flare = rng.uniform(0.7, 1.4)
    p = [[length * k / 3 * rng.uniform(0.9, 1.1), 0.0, bend * rng.uniform(-1, 1)] for k in range(4)]
    q = []
    for k, (x, _, z) in enumerate(p):
        rise = float(tan(radians(twist))) * length / 6 * rng.uniform(-1, 1)
        q.append([x * flare + width * 0.1 * rng.uniform(-1, 1) * min(1.0, twist), width, z * flare + rise])
    return p, q


def bezier(points, x):
    y = 1 - x
    b = [y**3, 3 * x * y**2, 3 * x**2 * y, x**3]
    d = [3 * y**2, 6 * x * y, 3 * x**2]
    at = [sum(w * c[i] for w, c in zip(b, points)) for i in range(3)]
    slope = [sum(w * (c[i] - a[i]) for w, a, c in zip(d, points, points[1:])) for i in range(3)]
    return at, slope


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def ruling(p, q, x):
    """Length, twist, speeds along the ruling, and (a0, a1) of each name."""
    (a, da), (b, db) = bezier(p, x), bezier(q, x)
    r = [y - z for y, z in zip(b, a)]
    length = sqrt(dot(r, r))
    r = [c / length for c in r]
    along = [dot(da, r), dot(db, r)]
    across = [[c - s * e for c, e in zip(d, r)] for d, s in zip((da, db), along)]
    s0, s1 = (sqrt(dot(t, t)) for t in across)
    mixed = dot(*across)
    turned = cross(*across)
    sine = sqrt(dot(turned, turned)) / (s0 * s1)
    twist = mp.atan2(sine, mixed / (s0 * s1))
    mean = [c + d for c, d in zip(*across)]
    size = sqrt(dot(mean, mean))
    speeds = {
        "edges": (s0, s1),
        "edge-1": (s0, mixed / s0),
        "edge-2": (mixed / s1, s1),
        "between": tuple(dot(t, mean) / size for t in across),
    }
    return length, twist, along, speeds


class Chebyshev:
    """Nodes on [-1, 1], the first one on the right, and integration of the polynomial through values there."""

    def __init__(self, n):
        self.t = [cos(pi * k / n) for k in range(n + 1)]
        at = [[cos(pi * ((j * k) % (2 * n)) / n) for k in range(n + 1)] for j in range(n + 2)]
        half = [mpf(1) / 2 if k in (0, n) else mpf(1) for k in range(n + 1)]
        # Row j: the coefficient of T_j from the values; then the integral of T_j from -1 to the node k.
        weights = [[2 * half[j] * half[m] * at[j][m] / n for m in range(n + 1)] for j in range(n + 1)]

        def antiderivative(j, k):
            if j == 0:
                return self.t[k] + 1
            if j == 1:
                return (self.t[k] ** 2 - 1) / 2
            value = (at[j + 1][k] / (j + 1) - at[j - 1][k] / (j - 1)) / 2
            return value + mpf((-1) ** j) / (j * j - 1) * -1

        self.rows = []
        for k in range(n + 1):
            powers = [antiderivative(j, k) for j in range(n + 1)]
            self.rows.append([sum(p * w[m] for p, w in zip(powers, weights)) for m in range(n + 1)])

    def integral(self, values, width):
        """The integral from the left end, at the nodes."""
        return [mp.fdot(row, values) * width / 2 for row in self.rows]

    def total(self, values, width):
        return mp.fdot(self.rows[0], values) * width / 2


def developed(p, q, scheme):
    """For each name the flat rails at the quarters and the lengths of both; and the largest twist."""
    p = [[mpf(c) for c in point] for point in p]
    q = [[mpf(c) for c in point] for point in q]
    width = mpf(1) / CELLS
    state = {name: [mpf(0)] * 5 for name in NAMES}
    found = {name: [] for name in NAMES}
    twist = mpf(0)
    for cell in range(CELLS):
        nodes = [ruling(p, q, width * (cell + (1 + t) / 2)) for t in scheme.t]
        twist = max([twist] + [node[1] for node in nodes])
        for name in NAMES:
            theta, x, y, first, second = state[name]
            turns = [(speeds[name][1] - speeds[name][0]) / length for length, _, _, speeds in nodes]
            angles = [theta + part for part in scheme.integral(turns, width)]
            velocity = [
                (a[0] * cos(g) - s[name][0] * sin(g), a[0] * sin(g) + s[name][0] * cos(g))
                for (_, _, a, s), g in zip(nodes, angles)
            ]
            xs = [x + part for part in scheme.integral([v[0] for v in velocity], width)]
            ys = [y + part for part in scheme.integral([v[1] for v in velocity], width)]
            lengths = [
                scheme.total([sqrt(a[i] ** 2 + s[name][i] ** 2) for _, _, a, s in nodes], width) for i in (0, 1)
            ]
            # The first node is the right end.
            state[name] = [angles[0], xs[0], ys[0], first + lengths[0], second + lengths[1]]
            if cell % 2:
                long = nodes[0][0]
                far = (xs[0] + long * cos(angles[0]), ys[0] + long * sin(angles[0]))
                found[name] += [xs[0], ys[0], *far]
    for name in NAMES:
        found[name] += state[name][3:]
    return found, degrees(twist)


COARSE, FINE = Chebyshev(24), Chebyshev(32)


def row(number, check):
    p, q = strip(number)
    found, twist = developed(p, q, COARSE)
    if check:
        finer, _ = developed(p, q, FINE)
        size = max(abs(c) for c in finer["edges"])
        worst = max(abs(a - b) for name in NAMES for a, b in zip(found[name], finer[name]))
        if worst > size * mpf(10) ** -22:
            sys.exit(f"strip {number} is not resolved: {mp.nstr(worst / size, 3)}")
    numbers = [repr(float(c)) for c in sum(p + q, [])] + [mp.nstr(twist, 20)]
    numbers += [mp.nstr(c, 22) for name in NAMES for c in found[name]]
    return ",".join(numbers)


def main():
    if sys.argv[1:2] == ["--check"]:
        lines = open(sys.argv[2]).read().split()
        for number in range(0, len(lines), max(1, len(lines) // int(sys.argv[3]))):
            if lines[number] != row(number, True):
                sys.exit(f"strip {number} differs")
        print("as written")
        return
    for number in range(int(sys.argv[1]), int(sys.argv[2])):
        print(row(number, number % 20 == 0), flush=True)


if __name__ == "__main__":
    main()
