"""The statements of derivations/torses, worked out by SymPy.

Every claim is stated here a second time, by hand and in SymPy's own terms, and compared with what the derivation files
expect. The functions are polynomials: a statement sees of each no more than four derivatives at one place, and these may
be any numbers for polynomials of degree four. So equations are decided for polynomials whose coefficients are symbols, after
u = 0 has been put in; slips are refuted for polynomials with random coefficients. Under a hypothesis the functions are made
such that it holds.

    python3 tests/sympy/torses.py
"""

import random

from sympy import Matrix, Poly, Rational, S, cos, diff, expand, sin, sqrt, symbols, together

from expected import compare

u, v, v1, v2, h = symbols("u v v1 v2 h", real=True)
x = Matrix(symbols("x1:4", real=True))
ZERO = Matrix([0, 0, 0])


def number(name, degree=4):
    """Any function near u = 0, up to the order of its degree."""
    return sum(s * u ** k for k, s in enumerate(symbols(f"{name}0:{degree + 1}", real=True)))


def vector(name, degree=4):
    """Any function with three values near u = 0."""
    return Matrix([number(f"{name}{i}_", degree) for i in range(3)])


c, r, b, n = (vector(name, 3) for name in "crbn")
a, d, w = (number(name, 3) for name in "adw")


def D(value, order=1):
    return diff(value, u, order)


def det(*rows):
    return rows[0].dot(rows[1].cross(rows[2]))


def square(p):
    return p.dot(p)


def zero(value):
    """Whether an expression, or every entry of a vector, is zero at u = 0 for all functions."""
    if isinstance(value, Matrix):
        return all(zero(entry) for entry in value)
    value = S(value).subs(u, 0)
    for seed in range(3):
        chosen = random.Random(seed)
        free = sorted(value.free_symbols, key=str)
        found = value.subs({s: Rational(chosen.randint(-9, 9), chosen.randint(1, 9)) for s in free})
        if found != 0 and found.is_finite:
            return False
    return expand(together(value).as_numer_denom()[0]) == 0


def equal(left, right):
    return zero(left - right)


def agree(left, right):
    """Whether two expressions with roots have the same values at u = 0, for functions with random coefficients."""
    difference = S(left - right).subs(u, 0)
    free = sorted(difference.free_symbols, key=str)
    for seed in range(5):
        chosen = random.Random(seed)
        point = {s: Rational(chosen.randint(-9, 9), chosen.randint(1, 9)) for s in free}
        if abs(difference.subs(point).evalf(40)) > 1e-20:
            return False
    return True


tangent = D(c) / sqrt(square(D(c)))


def normal(c, r):
    X = c + v * r
    return diff(X, u).cross(diff(X, v))


def delta(c, r):
    return det(D(c), r, D(r))


def at(value, place):
    return value.subs(v, place)


N = normal(c, r)
X = c + v * r
FIRST = [square(D(X)), D(X).dot(diff(X, v)), square(diff(X, v))]
SECOND = [D(X, 2).dot(N), diff(X, u, v).dot(N), diff(X, v, 2).dot(N)]
TURN = at(N, v1).cross(at(N, v2))


# A torse in its general form where r × r' is not zero: c' is a combination of r and r', so that δ = 0. At u = 0 the
# derivatives of c are those of an antiderivative.
def integral(p):
    return Matrix([Poly(expand(entry), u).integrate(u).as_expr() for entry in p])


f, g = number("f", 2), number("g", 2)
rt = vector("r", 3)
ct = integral(f * rt + g * D(rt))


def central(c, r):
    return -D(c).cross(r).dot(D(r).cross(r)) / square(D(r).cross(r))


def distribution(c, r):
    return square(r) * delta(c, r) / square(D(r).cross(r))


# A ruling of length one at u = 0 alone; by turning the axes it is any such.
once = Matrix([1, 0, 0]) + r - r.subs(u, 0)
# One with r' at right angles to r.
q1, q2, q3 = symbols("q1:4", real=True)
upright = Matrix([q1, u * q2, u * q3]) + r - r.subs(u, 0) - u * D(r).subs(u, 0)

# A change of the parameter that keeps u = 0 where it is, which is no loss: any other place is like it.
PHI = sum(s * u ** k for k, s in enumerate(symbols("phi1:4", real=True), start=1))
FACTOR = D(PHI)


def changed(value):
    return value.subs(u, PHI)


cubic = vector("c", 3)
C = changed(cubic)
T = c + v * D(c)
NT = D(T).cross(diff(T, v))
H = D(c).cross(D(c, 2)).cross(D(c))


def curvature(c):
    return square(D(c).cross(D(c, 2))) / square(D(c)) ** 3


def torsion(c):
    return det(D(c), D(c, 2), D(c, 3)) / square(D(c).cross(D(c, 2)))


# Derivatives of a curve with its arc length at one place: c' = (1, 0, 0), c'' at right angles to it. By turning the axes this is
# any such curve.
s2, s3 = symbols("s2 s3", real=True)
arc = Matrix([u, s2 * u ** 2 / 2, s3 * u ** 2 / 2])
TA = arc + v * D(arc)


def at_start(value):
    return value.subs(u, 0)


# A curve with c' × c'' = 0 at u = 0.
k0 = symbols("k0", real=True)
m1, m3 = (Matrix(symbols(f"{name}_1:4", real=True)) for name in ("m", "l"))
inflection = m1 * u + k0 * m1 * u ** 2 / 2 + m3 * u ** 3 / 6
# One with c''' = k c' + l c'', so that det(c', c'', c''') = 0.
l0 = symbols("l0", real=True)
m2 = Matrix(symbols("j_1:4", real=True))
flat = m1 * u + m2 * u ** 2 / 2 + (k0 * m1 + l0 * m2) * u ** 3 / 6

# Rulings with r' = k r at u = 0.
parallel = m1 * (1 + k0 * u)

# Planes, those through one point, and those with n'' = k n + l n'.
W = det(n, D(n), D(n, 2))


def edge(n, d):
    above = d * D(n).cross(D(n, 2)) + D(d) * D(n, 2).cross(n) + D(d, 2) * n.cross(D(n))
    return above / det(n, D(n), D(n, 2))


n4, d4 = vector("n", 4), number("d", 4)
flatter = m1 + m2 * u + (k0 * m1 + l0 * m2) * u ** 2 / 2


def taylor(value, order):
    """The derivative of a quotient at u = 0."""
    return at_start(diff(value, u, order))


def rotated(r):
    return r.cross(D(r))


apex = x + a * r
Y = apex + v * r
NY = D(Y).cross(diff(Y, v))
x4, y4 = number("x", 3), number("y", 3)
# With w² (x'² + y'²) constant to first order: w' is what makes it so.
speed = D(x4) ** 2 + D(y4) ** 2
w0 = symbols("w0", real=True)
w1 = at_start(-w0 * D(speed) / (2 * speed))
slope_w = w0 + w1 * u
slope_r = Matrix([-D(y4) * slope_w, D(x4) * slope_w, h])
conoid = (Matrix([0, 0, D(a)]), Matrix([cos(u), sin(u), 0]), Matrix([-sin(u), cos(u), 0]))

CHECKS = {
    "ruled.normal": lambda: equal(N, D(c).cross(r) + v * D(r).cross(r)),
    "ruled.turn": lambda: equal(TURN, (v1 - v2) * delta(c, r) * r),
    "ruled.turn.slip": lambda: equal(TURN, (v1 + v2) * delta(c, r) * r),
    "ruled.chasles": lambda: equal(square(TURN), (v1 - v2) ** 2 * delta(c, r) ** 2 * square(r)),
    "ruled.torse.sufficient": lambda: zero(delta(ct, rt)) and zero(
        at(normal(ct, rt), v1).cross(at(normal(ct, rt), v2))),
    # The product of the normals with r is what is stated to be zero.
    "ruled.torse.necessary": lambda: equal(TURN.dot(r), (v1 - v2) * delta(c, r) * square(r)),
    "ruled.rodrigues": lambda: equal(diff(N, v).cross(N), delta(c, r) * r),
    "ruled.asymptotic": lambda: zero(SECOND[2]),
    "ruled.mixed": lambda: equal(SECOND[1], delta(c, r)),
    "ruled.lagrange": lambda: equal(FIRST[0] * FIRST[2] - FIRST[1] ** 2, square(N)),
    "ruled.gauss": lambda: equal(SECOND[0] * SECOND[2] - SECOND[1] ** 2, -delta(c, r) ** 2),
    "ruled.gauss.curvature": lambda: equal(FIRST[0] * FIRST[2] - FIRST[1] ** 2, square(N)) and equal(
        SECOND[0] * SECOND[2] - SECOND[1] ** 2, -delta(c, r) ** 2),
    "ruled.gauss.sign": lambda: equal(SECOND[0] * SECOND[2] - SECOND[1] ** 2, -delta(c, r) ** 2),
    "ruled.gauss.slip": lambda: equal(SECOND[0] * SECOND[2] - SECOND[1] ** 2, delta(c, r) ** 2),
    "ruled.directrix": lambda: equal(delta(c + a * r, r), delta(c, r)),
    "ruled.scaled": lambda: equal(delta(c, a * r), a ** 2 * delta(c, r)),
    "ruled.parameter": lambda: equal(delta(changed(c), changed(r)), FACTOR ** 2 * changed(delta(c, r))),
    "ruled.parameter.slip": lambda: equal(delta(changed(c), changed(r)), FACTOR * changed(delta(c, r))),
    "ruled.ends": lambda: equal(delta(c, b - c), det(D(c), b - c, D(b))),
    "ruled.start": lambda: zero(at_start(D(c.dot(r))) - at_start(D(c)).dot(at_start(r)) - at_start(c).dot(at_start(D(r)))),
    # Any other surface with the same ruling differs by what is zero at u = 0.
    "ruled.touch": lambda: equal(
        diff(N.cross(normal(c + u * b, r + u * n)), v, 2), 2 * rotated(r).cross(rotated(r + u * n))),
    "striction.shortest": lambda: zero(at(diff(square(N), v), central(c, r))),
    "striction.growth": lambda: equal(diff(square(N), v, 2), 2 * square(D(r).cross(r))),
    "striction.length": lambda: equal(at(square(N), central(c, r)) * square(D(r).cross(r)), delta(c, r) ** 2 * square(r)),
    "striction.scaled": lambda: equal(a * central(c, a * r), central(c, r)),
    "striction.unit": lambda: zero(D(c + (-D(c).dot(D(upright)) / square(D(upright))) * upright).dot(D(upright))),
    "striction.unit.slip": lambda: zero(D(c + (-D(c).dot(D(r)) / square(D(r))) * r).dot(D(r))),
    "striction.parameter": lambda: equal(distribution(c, a * r), distribution(c, r)),
    "striction.curvature": lambda: equal(
        at(square(normal(c, once)), central(c, once)), distribution(c, once) ** 2 * square(D(once).cross(once))),
    "regression.singular": lambda: zero(at(normal(ct, rt), central(ct, rt))),
    "regression.tangent": lambda: zero(D(ct + central(ct, rt) * rt).cross(rt)),
    "regression.tangent.slip": lambda: zero(D(c + central(c, r) * r).cross(r)),
    "tangents.torse": lambda: zero(det(D(c), D(c), D(c, 2))),
    "tangents.normal": lambda: equal(NT, v * D(c, 2).cross(D(c))),
    "tangents.edge": lambda: zero(at(NT, 0)),
    "tangents.osculating": lambda: zero(NT.cross(D(c).cross(D(c, 2)))),
    "tangents.metric": lambda: equal(square(D(TA)), 1 + v ** 2 * square(D(arc, 2))),
    "tangents.metric.slip": lambda: equal(square(D(T)), square(D(c)) + v ** 2 * square(D(c, 2))),
    "curve.chain": lambda: equal(D(C, 2), changed(D(cubic, 2)) * FACTOR ** 2 + changed(D(cubic)) * D(FACTOR)),
    "curve.chain.slip": lambda: equal(D(C, 2), changed(D(cubic, 2)) * FACTOR + changed(D(cubic)) * D(FACTOR)),
    "curve.curvature": lambda: equal(curvature(C), changed(curvature(cubic))),
    "curve.torsion": lambda: equal(torsion(C), changed(torsion(cubic))),
    "curve.straight": lambda: zero(det(D(inflection), D(inflection, 2), D(inflection, 3))),
    "rectifying.contains": lambda: equal(D(H.dot(c)), D(H).dot(c)),
    "rectifying.geodesic": lambda: zero(det(D(c), D(c, 2), H)),
    "polar.first": lambda: equal(D(D(c).dot(x - c)), D(c, 2).dot(x - c) - square(D(c))),
    "polar.second": lambda: equal(D(D(c).dot(x - c), 2), D(c, 3).dot(x - c) - 3 * D(c).dot(D(c, 2))),
    "polar.second.slip": lambda: equal(D(D(c).dot(x - c), 2), D(c, 3).dot(x - c) - 2 * D(c).dot(D(c, 2))),
    "cylinder.torse": lambda: zero(delta(c, parallel)),
    "cylinder.normal": lambda: equal(at(normal(c, m1), v1), at(normal(c, m1), v2)),
    "cylinder.converse.slip": lambda: zero(rt.cross(D(rt))),
    "cone.torse": lambda: zero(delta(apex, r)),
    "cone.apex": lambda: zero(at(NY, -a)),
    "cone.apex.slip": lambda: zero(at(NY, a)),
    "binormals.skew": lambda: zero(delta(flat, D(flat).cross(D(flat, 2)))),
    "conoid.skew": lambda: equal(det(*conoid), D(a)),
    "slope.torse": lambda: zero(det(Matrix([D(x4), D(y4), 0]), slope_r, D(slope_r))),
    # Squared; the sides of the first and the last have one sign.
    "unit.speed": lambda: agree(D(sqrt(square(D(c)))), D(c).dot(D(c, 2)) / sqrt(square(D(c)))),
    "unit.speed.slip": lambda: agree(D(sqrt(square(D(c)))), sqrt(square(D(c, 2)))),
    "unit.orthogonal": lambda: agree(tangent.dot(D(tangent)), 0),
    "unit.turn": lambda: agree(
        sqrt(square(D(tangent))) / sqrt(square(D(c))),
        sqrt(square(D(c).cross(D(c, 2)))) / sqrt(square(D(c))) ** 3),
    "planes.ruling": lambda: zero(n.dot(rotated(n))) and zero(D(n).dot(rotated(n))),
    "planes.turn": lambda: equal(rotated(rotated(n)), W * n),
    "planes.turn.slip": lambda: equal(rotated(rotated(n)), W * D(n)),
    "planes.cylinder": lambda: zero(rotated(rotated(flatter))),
    # The solution solves, and there is one only.
    "planes.edge": lambda: all(zero(D(n, k).dot(edge(n, d)) - D(d, k)) for k in range(3)),
    "planes.edge.in": lambda: zero(n.dot(edge(n, d)) - d) and zero(D(n).dot(edge(n, d)) - D(d)),
    "planes.edge.tangent": lambda: all(zero(D(n, k).dot(taylor(edge(n, d), 1))) for k in range(2)),
    "planes.edge.osculating": lambda: zero(n4.dot(taylor(edge(n4, d4), 2))),
    "planes.cone": lambda: equal(edge(n, n.dot(x)), x),
    "planes.scaled": lambda: equal(det(a * n, D(a * n), D(a * n, 2)), a ** 3 * W),
    "planes.scaled.slip": lambda: equal(det(a * n, D(a * n), D(a * n, 2)), a ** 2 * W),
    "planes.dual": lambda: zero(D(ct).cross(rt).dot(D(ct + v * rt))),
}

if __name__ == "__main__":
    compare("torses", CHECKS)
