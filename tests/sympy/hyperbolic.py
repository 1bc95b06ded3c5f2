"""The statements of derivations/hyperbolic, worked out by SymPy.

Every claim is stated here a second time, by hand and in SymPy's own terms, and compared with what the derivation
files expect. Equations are decided symbolically, or refuted at a point; inequalities are evaluated on a grid of the domain,
which refutes but does not prove. Statements about every degree are looked at for degrees 2 to 6.

    python3 tests/sympy/hyperbolic.py
"""

import itertools

from sympy import (Abs, E as e, Matrix, Rational, S, cos, cosh, diff, exp, expand, integrate, lambdify, simplify, sin, sinh, solve, sqrt,
                   symbols, tanh, together)

from expected import compare

y, z, c, r, d, u, v = symbols("y z c r d u v", real=True)
t, a, b, w, w2 = symbols("t a b omega omega2", positive=True)
P = symbols("P0:3")
R = symbols("R0:3")


def equal(left, right):
    """Whether two expressions are equal as functions."""
    difference = S(left) - S(right)
    free = sorted(difference.free_symbols, key=str)
    for shift in range(3):
        point = {s: Rational(3 + 2 * n + shift, 7 + n) for n, s in enumerate(free)}
        if abs(difference.subs(point).evalf(40)) > 1e-20:
            return False
    # As a quotient of sums of exponentials, which SymPy multiplies by adding exponents.
    above = together(difference.rewrite(exp)).as_numer_denom()[0]
    return expand(above, power_exp=False) == 0 or simplify(difference) == 0


def agree(left, right):
    """Whether two expressions have the same values at points of either sign."""
    points = [Rational(n, 5) for n in (-9, -4, -1, 2, 7, 11)]
    return all(abs((left - right).subs(y, point).evalf(40)) < 1e-20 for point in points)


def on_grid(value, relation, inside=lambda *point: True, **ranges):
    """Whether a relation with zero holds at all points of a grid, closed at both ends, that lie inside."""
    names = list(ranges)
    by_name = {str(s): s for s in value.free_symbols}
    evaluate = lambdify([by_name.get(n, symbols(n)) for n in names], value)
    steps = 400 if len(names) == 1 else 40

    def points(low, high):
        return [float(low) + (float(high) - float(low)) * k / steps for k in range(steps + 1)]

    for point in itertools.product(*(points(*ranges[n]) for n in names)):
        if not inside(*point):
            continue
        number = evaluate(*point)
        if relation == ">=" and number < -1e-9 or relation == ">" and number <= 0:
            return False
    return True


def functions(t, a):
    below = sinh(a / 2) ** 2
    return [sinh((a - t) / 2) ** 2 / below, 2 * cosh(a / 2) * sinh((a - t) / 2) * sinh(t / 2) / below,
            sinh(t / 2) ** 2 / below]


def curve(t, a, points):
    return sum((f * p for f, p in zip(functions(t, a), points)), S(0))


def basis(degree, u, w):
    """The functions of a degree on [0, 1], by the recursion."""
    row = functions(w * u, w)
    for _ in range(2, degree):
        row = [(1 - u) * x + u * p for x, p in zip([*row, 0], [0, *row])]
    return row


def shaped(degree, name, u, w):
    points = symbols(f"{name}0:{degree + 1}")
    return points, sum(f * p for f, p in zip(basis(degree, u, w), points))


def slope(w):
    return w * cosh(w / 2) / sinh(w / 2)


def ends_of_degree(degree, addend):
    points, shape = shaped(degree, "P", u, w)
    rate = diff(shape, u)
    return equal(rate.subs(u, 0), (degree + addend + slope(w)) * (points[1] - points[0]))


def both_ends(degree):
    points, shape = shaped(degree, "P", u, w)
    return ends_of_degree(degree, -2) and equal(
        diff(shape, u).subs(u, 1), (degree - 2 + slope(w)) * (points[-1] - points[-2]))


def join_of_degree(m, n):
    points, first = shaped(m, "P", u, w)
    others, second = shaped(n, "R", u, w2)
    equations = [second.subs(u, 0) - first.subs(u, 1), diff(second, u).subs(u, 0) - diff(first, u).subs(u, 1)]
    solution = solve(equations, others[:2])
    return equal(solution[others[1]],
                 points[-1] + (m - 2 + slope(w)) / (n - 2 + slope(w2)) * (points[-1] - points[-2]))


F = curve(t, a, P)
G = curve(t, b, R)
A = Matrix([curve(t, a, (1, 1, cosh(a))), curve(t, a, (0, tanh(a / 2), sinh(a)))])


def joined(order, index, right):
    equations = [diff(G, t, n).subs(t, 0) - diff(F, t, n).subs(t, a) for n in range(order + 1)]
    return equal(solve(equations, R[:order + 1])[R[index]], right)


K = Matrix([y, cosh(y)])
X = Matrix([cosh(v) * cos(u), cosh(v) * sin(u), v])
T = Matrix([y - tanh(y), 1 / cosh(y)])
L2 = Matrix([exp(r * y) * cos(y), exp(r * y) * sin(y)])
L = Matrix([exp(r * y) * cos(y), exp(r * y) * sin(y), d * exp(r * y)])
dK, dT, dS, dL = (curve.diff(y) for curve in (K, T, L2, L))
Xu, Xv = X.diff(u), X.diff(v)


def square(vector):
    return vector.dot(vector)


def det(*rows):
    return Matrix.vstack(*(row.T for row in rows)).det()


def curvature(curve):
    return det(curve.diff(y), curve.diff(y, 2)) ** 2 / square(curve.diff(y)) ** 3


def below(t, a):
    return t <= a


strip = {"t": (0, 4), "a": (0.05, 4)}
f, g, h = functions(t, a)
CHECKS = {
    "fn.pythagoras": lambda: equal(cosh(y) ** 2 - sinh(y) ** 2, 1),
    "fn.pythagoras.slip": lambda: equal(cosh(y) ** 2 + sinh(y) ** 2, 1),
    "fn.sum": lambda: equal(cosh(y + z), cosh(y) * cosh(z) + sinh(y) * sinh(z)),
    "fn.difference": lambda: equal(sinh(y - z), sinh(y) * cosh(z) - cosh(y) * sinh(z)),
    "fn.half": lambda: equal(cosh(y), 1 + 2 * sinh(y / 2) ** 2),
    "fn.half.slip": lambda: equal(cosh(y), 1 - 2 * sinh(y / 2) ** 2),
    "fn.third": lambda: equal(sinh(y), 3 * sinh(y / 3) + 4 * sinh(y / 3) ** 3),
    "fn.tangent": lambda: equal(tanh(y / 2), sinh(y) / (1 + cosh(y))),
    "fn.rate": lambda: equal(diff(tanh(y), y), 1 - tanh(y) ** 2),
    "fn.growth": lambda: equal(diff(exp(c * y), y, 2), c**2 * exp(c * y))
    and equal(diff(exp(c * y), c), y * exp(c * y)),
    "fn.bell": lambda: equal(diff(exp(-(y**2) / 2), y, 2), (y**2 - 1) * exp(-(y**2) / 2)),
    "fn.damped": lambda: equal(diff(exp(-y) * sin(y), y, 2), -2 * exp(-y) * cos(y)),
    "fn.damped.slip": lambda: equal(diff(exp(-y) * sin(y), y, 2), -2 * exp(-y) * sin(y)),
    "fn.positive": lambda: on_grid(exp(y), ">", y=(-9, 9)) and on_grid(cosh(y) - 1, ">=", y=(-9, 9)),
    "fn.strict.slip": lambda: on_grid(cosh(y) - 1, ">", y=(-9, 9)),
    "fn.bounded": lambda: on_grid(1 - tanh(y), ">", y=(-9, 9)) and on_grid(1 + tanh(y), ">", y=(-9, 9)),
    "fn.tangent.line": lambda: on_grid(exp(y) - 1 - y, ">=", y=(-9, 9)),
    "fn.unit": lambda: on_grid(exp(y) - 1, ">=", y=(0, 1)) and on_grid(e.evalf() - exp(y), ">=", y=(0, 1)),
    "fn.number": lambda: exp(S(1) / 2) ** 2 == e and abs(e.evalf(30) - Rational("2.71828")) < Rational("1e-5"),
    "fn.value": lambda: abs(cosh(1).evalf(30) - Rational("1.54308")) < Rational("1e-5"),
    "quadratic.unity": lambda: equal(f + g + h, 1),
    "quadratic.symmetry": lambda: equal(f.subs(t, a - t), h) and equal(g.subs(t, a - t), g),
    "quadratic.ends": lambda: [x.subs(t, 0) for x in (f, g, h)] == [1, 0, 0],
    "quadratic.nonnegative": lambda: all(on_grid(x, ">=", below, **strip) for x in (f, g, h)),
    "quadratic.nonnegative.slip": lambda: on_grid(g, ">=", **strip),
    "quadratic.decreasing": lambda: on_grid(-diff(f, t), ">=", below, **strip),
    "quadratic.largest": lambda: on_grid(1 - h, ">=", below, **strip),
    "quadratic.space": lambda: all(equal(diff(x, t, 3), diff(x, t)) for x in (f, g, h)),
    "curve.ends": lambda: equal(F.subs(t, 0), P[0]) and equal(F.subs(t, a), P[2]),
    "curve.d1": lambda: equal(diff(F, t).subs(t, 0), (P[1] - P[0]) / tanh(a / 2))
    and equal(diff(F, t).subs(t, a), (P[2] - P[1]) / tanh(a / 2)),
    "curve.d1.slip": lambda: equal(diff(F, t).subs(t, 0), tanh(a / 2) * (P[1] - P[0])),
    "curve.d2": lambda: equal(
        diff(F, t, 2).subs(t, 0), (cosh(a) * (P[0] - P[1]) + P[2] - P[1]) / (2 * sinh(a / 2) ** 2)),
    "curve.middle": lambda: equal(F.subs(t, a / 2), (P[0] + 2 * cosh(a / 2) * P[1] + P[2]) / (2 + 2 * cosh(a / 2))),
    "curve.middle.slip": lambda: equal(F.subs(t, a / 2), (P[0] + 2 * cosh(a) * P[1] + P[2]) / (2 + 2 * cosh(a))),
    "curve.hyperbola": lambda: equal(A[0], cosh(t)) and equal(A[1], sinh(t)),
    "curve.hyperbola.implicit": lambda: equal(A[0], cosh(t)) and equal(A[1], sinh(t))
    and equal(cosh(t) ** 2 - sinh(t) ** 2, 1),
    "curve.hyperbola.tangent": lambda: equal(
        det(A.diff(t).subs(t, a), A.subs(t, a) - Matrix([1, tanh(a / 2)])), 0),
    "join.C1": lambda: joined(1, 1, P[2] + tanh(b / 2) / tanh(a / 2) * (P[2] - P[1])),
    "join.C1.slip": lambda: joined(1, 1, P[2] + tanh(a / 2) / tanh(b / 2) * (P[2] - P[1])),
    "join.C2": lambda: joined(2, 2, (lambda r1: r1 + cosh(b) * (r1 - P[2]) + sinh(b / 2) ** 2 / sinh(a / 2) ** 2 * (
        P[0] - P[1] + cosh(a) * (P[2] - P[1])))(P[2] + tanh(b / 2) / tanh(a / 2) * (P[2] - P[1]))),
    "shape.unity": lambda: all(equal(sum(basis(k, u, w)), 1) for k in range(2, 7)),
    "shape.symmetry": lambda: all(equal(x.subs(u, 1 - u), z) for x, z in zip(basis(4, u, w), basis(4, u, w)[::-1])),
    "shape.nonnegative": lambda: all(
        on_grid(x, ">=", u=(0, 1), omega=(0.05, 9)) for k in range(2, 5) for x in basis(k, u, w)),
    "shape.ends": lambda: all(
        equal(shaped(k, "P", u, w)[1].subs(u, end), shaped(k, "P", u, w)[0][place])
        for k in range(2, 5) for end, place in ((0, 0), (1, -1))),
    "shape.d1": lambda: all(both_ends(k) for k in range(2, 6)),
    "shape.d1.slip": lambda: ends_of_degree(3, 0),
    "shape.slope": lambda: on_grid(slope(w), ">", omega=(0.01, 9)),
    "shape.join": lambda: all(join_of_degree(m, n) for m, n in ((2, 2), (3, 2), (2, 4))),
    "catenary.speed": lambda: equal(square(dK), cosh(y) ** 2),
    "catenary.length": lambda: equal(diff(sinh(y), y) ** 2, square(dK)),
    "catenary.curvature": lambda: equal(curvature(K), 1 / cosh(y) ** 4),
    "catenary.curvature.slip": lambda: equal(curvature(K), 1 / cosh(y) ** 2),
    # Both sides are positive, or of one sign, where their squares are equal and they agree at points of either sign.
    "catenary.norm": lambda: equal(square(dK), cosh(y) ** 2) and agree(sqrt(square(dK)), cosh(y)),
    "catenary.bend": lambda: equal(curvature(K), 1 / cosh(y) ** 4)
    and agree(dK[0] * K[1].diff(y, 2) / sqrt(square(dK)) ** 3, 1 / cosh(y) ** 2),
    "catenary.bend.slip": lambda: agree(dK[0] * K[1].diff(y, 2) / sqrt(square(dK)) ** 3, 1 / cosh(y)),
    "tractrix.norm": lambda: equal(square(dT), tanh(y) ** 2) and agree(sqrt(square(dT)), Abs(tanh(y))),
    "catenary.load": lambda: equal(diff(cosh(y), y, 2) ** 2, 1 + diff(cosh(y), y) ** 2),
    "catenoid.conformal": lambda: equal(square(Xu), square(Xv)) and equal(Xu.dot(Xv), 0),
    "catenoid.minimal": lambda: all(equal(x, 0) for x in X.diff(u, 2) + X.diff(v, 2)),
    "catenoid.gauss": lambda: equal(
        det(Xu, Xv, X.diff(u, 2)) * det(Xu, Xv, X.diff(v, 2)) - det(Xu, Xv, Xu.diff(v)) ** 2, -cosh(v) ** 4),
    "catenoid.regular": lambda: on_grid(simplify(square(Xu.cross(Xv))), ">", u=(-4, 4), v=(-4, 4)),
    "tractrix.pull": lambda: equal(T[1] ** 2 / dT[1] ** 2 * square(dT), 1),
    "tractrix.speed": lambda: equal(square(dT), tanh(y) ** 2),
    "spiral.angle": lambda: equal((1 + r**2) * L2.dot(dS) ** 2, r**2 * square(L2) * square(dS)),
    "spiral.angle.slip": lambda: equal(L2.dot(dS) ** 2, r**2 * square(L2) * square(dS)),
    "spiral.regular": lambda: on_grid(simplify(square(dS)), ">", y=(-4, 4), r=(-2, 2)),
    "spiral.curvature": lambda: equal(curvature(L2), exp(-2 * r * y) / (1 + r**2)),
    "cone.slope": lambda: equal(L[0] ** 2 + L[1] ** 2, L[2] ** 2 / d**2)
    and equal(dL[2] ** 2 * (1 + r**2 + d**2 * r**2), d**2 * r**2 * square(dL)),
    "cone.torsion": lambda: equal(det(dL, L.diff(y, 2), L.diff(y, 3)), d * r * (1 + r**2) * exp(3 * r * y)),
    "cone.torse": lambda: equal(det(dL, dL, L.diff(y, 2)), 0),
}

# Integrals, of the functions of derivations/hyperbolic/integrals.toml; q is the variable, s the upper end, k not zero.
q, s = symbols("q s", real=True)
k = symbols("k", positive=True)
H = Matrix([q, cosh(q)])
CHECKS |= {
    "integral.exponential": lambda: equal(integrate(exp(k * q), (q, 0, s)), (exp(k * s) - 1) / k)
    and equal(integrate(exp(-k * q), (q, 0, s)), (exp(-k * s) - 1) / -k),
    "integral.damped": lambda: equal(
        integrate(exp(-q) * sin(q), (q, 0, s)), (1 - exp(-s) * (sin(s) + cos(s))) / 2),
    "integral.parts": lambda: equal(integrate(q * exp(-q), (q, 0, s)), 1 - (s + 1) * exp(-s)),
    "integral.parts.slip": lambda: equal(integrate(q * exp(-q), (q, 0, s)), 1 - s * exp(-s)),
    "integral.catenary": lambda: equal(square(H.diff(q)), cosh(q) ** 2)
    and equal(integrate(cosh(q), (q, 0, s)), sinh(s)),
    "integral.basis": lambda: equal(integrate(sinh(q), (q, 0, s)), cosh(s) - 1)
    and equal(integrate(cosh(q) - 1, (q, 0, s)), sinh(s) - s),
}


if __name__ == "__main__":
    compare("hyperbolic", CHECKS)
