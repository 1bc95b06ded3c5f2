"""The statements of derivations/trigonometric, worked out by SymPy.

Every claim is stated here a second time, by hand and in SymPy's own terms, and compared with what the derivation
files expect. Equations are decided symbolically, or refuted at a point; inequalities are evaluated on a grid of the domain,
which refutes but does not prove.

    python3 tests/sympy/trigonometric.py
"""

import itertools

from sympy import (Matrix, Rational, cos, diff, exp, expand, integrate, lambdify, pi, simplify, sin, solve, sqrt, symbols, tan)

from expected import compare

t, y, z, r, h, v = symbols("t y z r h v", real=True)
lam, mu, lam2, mu2 = symbols("lambda mu lambda2 mu2", real=True)
P = symbols("P0:3")
R = symbols("R0:3")


def equal(left, right):
    """Whether two expressions are equal as functions."""
    difference = left - right
    free = sorted(difference.free_symbols, key=str)
    for shift in range(3):
        point = {s: Rational(3 + 2 * n + shift, 7 + n) for n, s in enumerate(free)}
        if abs(difference.subs(point).evalf(40)) > 1e-20:
            return False
    return simplify(difference) == 0 or simplify(expand(difference.rewrite(exp))) == 0


def same(left, right):
    """Whether two expressions with roots are equal for positive symbols: their squares as functions, their signs at points."""
    positive = {s: symbols(str(s), positive=True) for s in (left - right).free_symbols}
    left, right = left.subs(positive), right.subs(positive)
    for shift in range(4):
        point = {s: Rational(3 + 2 * n + 5 * shift, 7 + n) for n, s in enumerate(sorted(positive.values(), key=str))}
        if abs((left - right).subs(point).evalf(40)) > 1e-20:
            return False
    return simplify(left ** 2 - right ** 2) == 0


def unit(p):
    return p / sqrt(simplify(square(p)))


def on_grid(value, relation, **ranges):
    """Whether a relation with zero holds at all points of a grid, closed at both ends."""
    names = list(ranges)
    evaluate = lambdify([symbols(n, real=True) for n in names], value)
    steps = 400 if len(names) == 1 else 24

    def points(low, high):
        return [float(low) + (float(high) - float(low)) * k / steps for k in range(steps + 1)]

    for point in itertools.product(*(points(*ranges[n]) for n in names)):
        number = evaluate(*point)
        if relation == ">=" and number < -1e-12 or relation == ">" and number < 1e-12:
            return False
    return True


def a(t, lam):
    return (1 - sin(t)) * (1 - lam * sin(t))


def c(t, mu):
    return (1 - cos(t)) * (1 - mu * cos(t))


def b(t, lam, mu):
    return 1 - a(t, lam) - c(t, mu)


def curve(t, points, lam, mu):
    return a(t, lam) * points[0] + b(t, lam, mu) * points[1] + c(t, mu) * points[2]


F = curve(t, P, lam, mu)
G = curve(t, R, lam2, mu2)
E = cos(t / 2) ** 4 * P[0] + 2 * sin(t / 2) ** 2 * cos(t / 2) ** 2 * P[1] + sin(t / 2) ** 4 * P[2]
dE = sin(t) * (cos(t / 2) ** 2 * (P[1] - P[0]) + sin(t / 2) ** 2 * (P[2] - P[1]))
first_quarter = {"t": (0, pi / 2)}
shape = {"lambda": (-1, 1), "mu": (-1, 1)}
near = 1e-3


def joined(right):
    """Whether R_1 of a C1 join is this."""
    start = {t: 0}
    end = {t: pi / 2}
    equations = [G.subs(start) - F.subs(end), diff(G, t).subs(start) - diff(F, t).subs(end)]
    return equal(solve(equations, [R[0], R[1]])[R[1]], right)


cycloid = Matrix([t - sin(t), 1 - cos(t)])
cardioid = Matrix([(1 + cos(t)) * cos(t), (1 + cos(t)) * sin(t)])
helix = Matrix([r * cos(t), r * sin(t), h * t])
normal = Matrix([cos(t), sin(t), 0])
cylinder = Matrix([r * cos(t), r * sin(t), v])
round_normal = cylinder.diff(t).cross(cylinder.diff(v))
D1, D2, D3 = (helix.diff(t, n) for n in (1, 2, 3))


def square(vector):
    return vector.dot(vector)


def bend(curve):
    return Matrix.hstack(curve.diff(t), curve.diff(t, 2)).T.det()


def curvature(curve):
    return bend(curve) ** 2 / square(curve.diff(t)) ** 3


def det(*rows):
    return Matrix.vstack(*(row.T for row in rows)).det()


CHECKS = {
    "angle.half.sine": lambda: equal(sin(y / 2) ** 2, (1 - cos(y)) / 2),
    "angle.half.cosine": lambda: equal(cos(y), 2 * cos(y / 2) ** 2 - 1),
    "angle.half.slip": lambda: equal(1 - cos(y), sin(y / 2) ** 2),
    "angle.third": lambda: equal(sin(y), 3 * sin(y / 3) - 4 * sin(y / 3) ** 3),
    "angle.parts": lambda: equal(2 * sin(y / 2 + z / 3) * cos(y / 2 - z / 3), sin(y) + sin(2 * z / 3)),
    "angle.rate": lambda: equal(diff(sin(y / 2), y, 2), -sin(y / 2) / 4),
    "angle.known": lambda: equal(sin(pi / 12), (sqrt(6) - sqrt(2)) / 4),
    "angle.tangent": lambda: equal(tan(y / 2), sin(y) / (1 + cos(y))),
    "angle.tangent.closed": lambda: equal(tan(y / 2), sin(y) / (1 + cos(y))),
    "angle.first": lambda: on_grid(sin(t) + cos(t) - 1, ">=", **first_quarter),
    "angle.first.turned": lambda: on_grid(sin(pi / 2 * t) + cos(pi / 2 * t) - 1, ">=", t=(0, 1)),
    "angle.symmetric": lambda: on_grid(cos(t) - Rational(1, 2), ">=", t=(-pi / 3, pi / 3)),
    "angle.symmetric.slip": lambda: on_grid(cos(t) - Rational(1, 2), ">=", t=(-pi / 2, pi / 2)),
    "angle.turn": lambda: on_grid(3 + sin(t) + 2 * cos(t), ">", t=(0, 2 * pi)),
    "quadratic.middle": lambda: equal(
        b(t, lam, mu), (1 + lam) * sin(t) + (1 + mu) * cos(t) - lam * sin(t) ** 2 - mu * cos(t) ** 2 - 1),
    "quadratic.nonnegative": lambda: all(
        on_grid(f, ">=", **first_quarter, **shape)
        for f in (a(t, lam) + 0 * mu, b(t, lam, mu), c(t, mu) + 0 * lam)),
    "quadratic.nonnegative.slip": lambda: on_grid(a(t, lam), ">=", t=(0, pi / 2), **{"lambda": (-1, 2)}),
    "quadratic.symmetry": lambda: equal(c(pi / 2 - t, lam), a(t, lam)),
    "quadratic.decreasing": lambda: on_grid(-diff(a(t, lam), t), ">=", t=(0, pi / 2), **{"lambda": (-1, 1)}),
    "quadratic.ends": lambda: equal(F.subs(t, 0), P[0]) and equal(F.subs(t, pi / 2), P[2]),
    "quadratic.d1": lambda: equal(diff(F, t).subs(t, 0), (1 + lam) * (P[1] - P[0]))
    and equal(diff(F, t).subs(t, pi / 2), (1 + mu) * (P[2] - P[1])),
    "quadratic.d2": lambda: equal(
        diff(F, t, 2).subs(t, 0), 2 * lam * (P[0] - P[1]) + (1 - mu) * (P[2] - P[1])),
    "quadratic.d1.slip": lambda: equal(diff(F, t).subs(t, 0), pi / 2 * (1 + lam) * (P[1] - P[0])),
    "quadratic.join": lambda: joined(P[2] + (1 + mu) / (1 + lam2) * (P[2] - P[1])),
    "quadratic.join.slip": lambda: joined(P[2] + (1 + lam2) / (1 + mu) * (P[2] - P[1])),
    "quadratic.circle": lambda: equal(
        square(Matrix([curve(t, (1, 1, 0), 0, 0), curve(t, (0, 1, 1), 0, 0)])), 1 + 0 * t),
    "half.unity": lambda: equal(
        cos(t / 2) ** 4 + 2 * sin(t / 2) ** 2 * cos(t / 2) ** 2 + sin(t / 2) ** 4, 1 + 0 * t),
    "half.middle": lambda: equal(2 * sin(t / 2) ** 2 * cos(t / 2) ** 2, sin(t) ** 2 / 2),
    "half.sine": lambda: on_grid(2 * sin(t / 2) - sin(t), ">=", t=(0, pi)),
    "half.cosine": lambda: on_grid(cos(t / 2), ">=", t=(0, pi)),
    "half.cosine.slip": lambda: on_grid(cos(t / 2), ">", t=(0, pi)),
    "half.powers": lambda: equal(
        E, (P[0] + 2 * P[1] + P[2]) / 4 + cos(t) / 2 * (P[0] - P[2])
        + cos(t) ** 2 / 4 * (P[0] - 2 * P[1] + P[2])),
    "half.d1": lambda: equal(diff(E, t), dE),
    "half.d1.slip": lambda: equal(diff(E, t), 2 * dE),
    "cycloid.speed": lambda: equal(square(cycloid.diff(t)), 4 * sin(t / 2) ** 2),
    "cycloid.regular": lambda: on_grid(square(cycloid.diff(t)), ">", t=(near, 2 * pi - near)),
    "cycloid.slope": lambda: equal(cycloid.diff(t)[1] / cycloid.diff(t)[0], cos(t / 2) / sin(t / 2)),
    "cycloid.slope.slip": lambda: equal(cycloid.diff(t)[1] / cycloid.diff(t)[0], sin(t / 2) / cos(t / 2)),
    "cycloid.bend": lambda: on_grid(-bend(cycloid), ">", t=(near, 2 * pi - near)),
    "cycloid.curvature": lambda: equal(curvature(cycloid), 1 / (16 * sin(t / 2) ** 2)),
    "cardioid.speed": lambda: equal(square(cardioid.diff(t)), 4 * cos(t / 2) ** 2),
    "cardioid.cusp": lambda: cardioid.diff(t).subs(t, pi) == Matrix([0, 0]),
    "cardioid.curvature": lambda: equal(curvature(cardioid), 9 / (16 * cos(t / 2) ** 2)),
    "helix.speed": lambda: equal(square(D1), r ** 2 + h ** 2),
    "helix.torsion": lambda: equal(det(D1, D2, D3), r ** 2 * h),
    "helix.curvature": lambda: equal(
        square(D1.cross(D2)) / square(D1) ** 3, r ** 2 / (r ** 2 + h ** 2) ** 2),
    "helix.torse": lambda: equal(det(D1, D1, D2), 0 * t),
    "helix.normal": lambda: all(
        equal(x, w) for x, w in zip((D1 + v * D2).cross(D1), v * D2.cross(D1))),
    "helix.regular": lambda: on_grid(simplify(square(D2.cross(D1))), ">", r=(near, 3), h=(near, 3)),
    "helix.length": lambda: same(sqrt(square(D1)), sqrt(r ** 2 + h ** 2)),
    "helix.bend": lambda: same(sqrt(square(D1.cross(D2))) / sqrt(square(D1)) ** 3, r / (r ** 2 + h ** 2)),
    "helix.bend.slip": lambda: same(
        sqrt(square(D1.cross(D2))) / sqrt(square(D1)) ** 3, r ** 2 / (r ** 2 + h ** 2) ** 2),
    "helix.bend.turn": lambda: same(
        sqrt(square(unit(D1).diff(t))) / sqrt(square(D1)), r / (r ** 2 + h ** 2)),
    "helix.principal": lambda: all(same(x, w) for x, w in zip(unit(unit(D1).diff(t)), -normal)),
    "helix.principal.slip": lambda: all(same(x, w) for x, w in zip(unit(unit(D1).diff(t)), normal)),
    "cylinder.normal": lambda: all(same(x, w) for x, w in zip(unit(round_normal), normal)),
    "cylinder.offset": lambda: all(
        same(x, w) for x, w in zip(
            cylinder + h * unit(round_normal), [(r + h) * cos(t), (r + h) * sin(t), v])),
    "helicoid.skew": lambda: equal(det(D1, normal, normal.diff(t)), h),
    "helicoid.skew.slip": lambda: equal(det(D1, normal, normal.diff(t)), 0 * t),
}

# Integrals, of the functions of derivations/trigonometric/integrals.toml; q is the variable, s the upper end.
q, s = symbols("q s", real=True)
ring = Matrix([r * cos(q), r * sin(q)])
roll = Matrix([r * (q - sin(q)), r * (1 - cos(q))])
turn = (q, 0, 2 * pi)
CHECKS |= {
    "integral.sine": lambda: equal(integrate(sin(q), (q, 0, s)), 1 - cos(s)),
    "integral.square": lambda: equal(integrate(cos(q) ** 2, (q, 0, s)), s / 2 + sin(2 * s) / 4),
    "integral.parts": lambda: equal(integrate(q * sin(q), (q, 0, s)), sin(s) - s * cos(s)),
    "integral.parts.slip": lambda: equal(integrate(q * sin(q), (q, 0, s)), sin(s) + s * cos(s)),
    "integral.orthogonal": lambda: integrate(sin(2 * q) * cos(3 * q), turn) == 0
    and integrate(sin(2 * q) * sin(3 * q), turn) == 0,
    "integral.circle": lambda: same(sqrt(square(ring.diff(q))), r) and equal(integrate(r, turn), 2 * pi * r),
    "integral.circle.area": lambda: equal(
        integrate(simplify(Matrix.hstack(ring, ring.diff(q)).det()), turn) / 2, pi * r ** 2),
    "integral.cycloid.area": lambda: equal(integrate(expand(roll[1] * roll[0].diff(q)), turn), 3 * pi * r ** 2),
    "integral.cycloid.length": lambda: equal(square(roll.diff(q)), (2 * r * sin(q / 2)) ** 2)
    and equal(integrate(2 * r * sin(q / 2), turn), 8 * r),
    "integral.mean.slip": lambda: equal(integrate(sin(q) ** 2, turn) / (2 * pi), 1 + 0 * q),
}


if __name__ == "__main__":
    compare("trigonometric", CHECKS)
