"""Whole panels between random rails, by brute force: is there one?

Not the way of the library: F(s, t) = det(a', b', b - a) on a grid of the square; where it changes its sign along a side of a cell
there is a node; nodes of one cell that rise are joined; fans run along grid lines from node to node. Reachability is by
dynamic programming. Writes `brute.csv`: for each pair of hull curves 1 or 0.

    python3 brute.py > brute.csv
"""

import numpy as np

N = 160
PAIRS = 60


class Random:
    """The generator of Lehmer with the multiplier 48271: numbers in [-1, 1]."""

    def __init__(self, seed):
        self.state = seed

    def next(self):
        self.state = self.state * 48271 % 2147483647
        return 2.0 * self.state / 2147483647.0 - 1.0


def rail(random, y, z, by):
    points = [[0, 0.3 * y, z], [1000, y - 100, z + 20], [2000, y - 150, z + 30], [3000, y, z]]
    return np.array([[c + by * random.next() for c in p] for p in points], float)


def at(points, x):
    """Point and derivative of a cubic."""
    x = np.asarray(x)[..., None]
    p = points
    b = [(1 - x) ** 3, 3 * x * (1 - x) ** 2, 3 * x**2 * (1 - x), x**3]
    d = [(1 - x) ** 2, 2 * x * (1 - x), x**2]
    point = sum(w * q for w, q in zip(b, p))
    slope = 3 * sum(w * (r - q) for w, q, r in zip(d, p, p[1:]))
    return point, slope


def fields(a, b, s, t):
    (p, dp), (q, dq) = at(a, s), at(b, t)
    r = q - p
    n0, n1 = np.cross(dp, r), np.cross(dq, r)
    return np.sum(np.cross(dp, dq) * r, -1), np.sum(n0 * n1, -1)


def exists(a, b):
    x = np.linspace(0, 1, N + 1)
    f, _ = fields(a, b, x[:, None], x[None, :])
    nodes = []  # (s, t)
    on_s = [[] for _ in x]  # nodes on the line s = x[i]
    on_t = [[] for _ in x]
    sides = {}

    def root(i, j, k, l):
        share = f[i, j] / (f[i, j] - f[k, l])
        return x[i] + share * (x[k] - x[i]), x[j] + share * (x[l] - x[j])

    def node(place, lines, i, key):
        if fields(a, b, *place)[1] > 0:
            nodes.append(place)
            lines[i].append(len(nodes) - 1)
            sides[key] = len(nodes) - 1

    for i in range(N + 1):
        for j in np.nonzero((f[i, :-1] < 0) != (f[i, 1:] < 0))[0]:
            node(root(i, j, i, j + 1), on_s, i, ("s", i, j))
        for j in np.nonzero((f[:-1, i] < 0) != (f[1:, i] < 0))[0]:
            node(root(j, i, j + 1, i), on_t, i, ("t", i, j))
    steps = [[] for _ in nodes]
    for i in range(N):
        for j in range(N):
            keys = [("s", i, j), ("t", j, i), ("s", i + 1, j), ("t", j + 1, i)]
            inside = [sides[k] for k in keys if k in sides]
            for one in inside:
                for other in inside:
                    rises = all(nodes[one][k] < nodes[other][k] for k in (0, 1))
                    if rises and len(inside) == 2:
                        steps[one].append(other)

    def fan(still, value, low, high):
        """Whether the cone from a point of a rail over a part of the other has a normal everywhere."""
        moving, fixed = (b, a) if still == 0 else (a, b)
        apex, _ = at(fixed, value)
        q, dq = at(moving, np.linspace(low, high, 65))
        n = np.cross(dq, q - apex)
        return bool(np.all(np.sum(n[1:] * n[:-1], -1) > 0))

    for still, lines in ((0, on_s), (1, on_t)):
        for i, list_ in enumerate(lines):
            for one in list_:
                for other in list_:
                    low, high = nodes[one][1 - still], nodes[other][1 - still]
                    if low < high and fan(still, x[i], low, high):
                        steps[one].append(other)
    reached = set()
    open_ = []
    for still, lines in ((0, on_s), (1, on_t)):
        for k in lines[0]:
            if fan(still, 0.0, 0.0, nodes[k][1 - still]):
                open_.append(k)
    goal = set()
    for still, lines in ((0, on_s), (1, on_t)):
        for k in lines[N]:
            if fan(still, 1.0, nodes[k][1 - still], 1.0):
                goal.add(k)
    while open_:
        k = open_.pop()
        if k in reached:
            continue
        reached.add(k)
        open_.extend(steps[k])
    return bool(reached & goal)


def main():
    random = Random(1234567)
    for k in range(PAIRS):
        by = 60.0 * (1, 2, 4)[k % 3]
        a, b = rail(random, -100.0, 0.0, by), rail(random, -200.0, 550.0, by)
        reversed_ = b[::-1].copy()
        print(int(exists(a, b) or exists(a, reversed_)))


main()
