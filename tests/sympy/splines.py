"""The statements of derivations/splines, worked out by SymPy.

Every claim is stated here a second time, by hand and in SymPy's own terms, and compared with what the derivation
files expect. The functions come from the recursion as textbooks print it, over all indices of the knot vector, begun with the
indicator function of one span; the derivation files count the functions of a span instead. Equations are decided symbolically;
inequalities are evaluated at rational points of the domain, which refutes but does not prove.

    python3 tests/sympy/splines.py
"""

import itertools

from sympy import Rational, S, diff, expand, factorial, symbols, together

from expected import compare

s, x, y, m = symbols("s x y m")
T = symbols("t0:8")
P = symbols("P0:5")


def function(i, k, span, knots, at):
    """N_{i,k} on a span, by the recursion of Cox and de Boor."""
    if k == 0:
        return S(int(i == span))

    first, second = (function(n, k - 1, span, knots, at) for n in (i, i + 1))
    # A function that is zero counts nothing, whatever its factor.
    if first != 0:
        first *= (at - knots[i]) / (knots[i + k] - knots[i])
    if second != 0:
        second *= (knots[i + k + 1] - at) / (knots[i + k + 1] - knots[i + 1])
    return first + second


def on_span(k, span, knots=T, at=x):
    """The functions that are not zero on a span, in order."""
    return [function(i, k, span, knots, at) for i in range(span - k, span + 1)]


def equal(left, right):
    # The denominators are products of gaps between knots: the numerator alone decides.
    return expand(together(S(left) - S(right)).as_numer_denom()[0]) == 0


def uniform(k):
    """On the span from k to k + 1 of the integers, in the place on it."""
    return [expand(piece.subs(x, s + k)) for piece in on_span(k, k, range(3 * k + 3))]


U2, U3 = uniform(2), uniform(3)
A = sum(u * p for u, p in zip(U2, P))
B = sum(u * p for u, p in zip(U2, P[1:]))
F = sum(u * p for u, p in zip(U3, P))
G = sum(u * p for u, p in zip(U3, P[1:]))
unit = [Rational(n, 24) for n in range(25)]


def jets(first, second, order, variable=s, end=1, start=0):
    return all(equal(diff(first, variable, n).subs(variable, end), diff(second, variable, n).subs(variable, start))
               for n in range(order + 1))


def mixed(pieces, points):
    return sum(u * p for u, p in zip(pieces, points))


N1, N2, N3 = on_span(1, 2), on_span(2, 2), on_span(3, 3)
N2next, N3next = on_span(2, 3), on_span(3, 4)
FK, GK = mixed(N2, P), mixed(N2next, P[1:])
CK, EK = mixed(N3, P), mixed(N3next, P[1:])
vectors = [list(map(Rational, knots)) for knots in (
    (0, 1, 2, 3, 4, 5, 6, 7), (0, 2, 3, 7, 8, 9, 13, 14), (-3, -1, Rational(1, 2), 1, 6, 7, 8, 20))]


def at_points(value, low, high, holds):
    """Whether the value satisfies a relation between two knots of some vectors."""
    for knots, share in itertools.product(vectors, unit):
        place = knots[low] + share * (knots[high] - knots[low])
        if not holds(value.subs(dict(zip(T, knots))).subs(x, place)):
            return False
    return True


def nonnegative(number):
    return number >= 0


clamped = (0, 0, 0, m, 1, 1, 1)
first, second = on_span(2, 2, clamped), on_span(2, 3, clamped)
FC, GC = mixed(first, P), mixed(second, P[1:])
bezier = on_span(3, 3, (0, 0, 0, 0, 1, 1, 1, 1))


def cubic(points):
    return mixed(U3, points)


def quadratic(points):
    return mixed(U2, points)


CHECKS = {
    "uniform.quadratic": lambda: all(map(equal, U2, [(1 - s) ** 2 / 2, S(1) / 2 + s * (1 - s), s**2 / 2])),
    "uniform.cubic": lambda: all(map(equal, U3, [
        (1 - s) ** 3 / 6, (3 * s**3 - 6 * s**2 + 4) / 6, (-3 * s**3 + 3 * s**2 + 3 * s + 1) / 6, s**3 / 6])),
    "uniform.cubic.slip": lambda: equal(U3[1], (3 * s**3 - 6 * s**2 + 3) / 6),
    "uniform.unity": lambda: equal(sum(U2), 1) and equal(sum(U3), 1),
    "uniform.nonnegative": lambda: all(u.subs(s, q) >= 0 for u in U3 for q in unit),
    "uniform.bound": lambda: all(u.subs(s, q) <= Rational(2, 3) for u in U3 for q in unit),
    "uniform.bound.slip": lambda: all(u.subs(s, q) <= Rational(1, 2) for u in U3 for q in unit),
    "uniform.symmetry": lambda: all(equal(u.subs(s, 1 - s), v) for u, v in zip(U3, U3[::-1])),
    "uniform.greville": lambda: equal(sum(i * u for i, u in enumerate(U3)), s + 1),
    "uniform.marsden": lambda: equal(sum(((i - 1) ** 2 - Rational(1, 3)) * u for i, u in enumerate(U3)), s**2),
    "uniform.marsden.slip": lambda: equal(sum((i - 1) ** 2 * u for i, u in enumerate(U3)), s**2),
    "uniform.rate": lambda: equal(diff(U3[2], s), U2[1] - U2[2]),
    "uniform.C1": lambda: jets(A, B, 1),
    "uniform.C1.slip": lambda: equal(diff(A, s, 2), diff(B, s, 2)),
    "uniform.C2": lambda: jets(F, G, 2),
    "uniform.jump": lambda: equal(
        diff(G, s, 3) - diff(F, s, 3), P[0] - 4 * P[1] + 6 * P[2] - 4 * P[3] + P[4]),
    "uniform.knot": lambda: equal(F.subs(s, 0), (P[0] + 4 * P[1] + P[2]) / 6)
    and equal(diff(F, s).subs(s, 0), (P[2] - P[0]) / 2)
    and equal(diff(F, s, 2).subs(s, 0), P[0] - 2 * P[1] + P[2]),
    "uniform.knot.slip": lambda: equal(F.subs(s, 0), (P[0] + 2 * P[1] + P[2]) / 4),
    "uniform.bezier": lambda: equal(diff(F, s).subs(s, 0), 3 * ((2 * P[1] + P[2]) / 3 - F.subs(s, 0))),
    "uniform.two.scale.quadratic": lambda: equal(
        A.subs(s, s / 2), quadratic([(3 * P[0] + P[1]) / 4, (P[0] + 3 * P[1]) / 4, (3 * P[1] + P[2]) / 4])),
    "uniform.two.scale.cubic": lambda: equal(F.subs(s, s / 2), cubic([
        (P[0] + P[1]) / 2, (P[0] + 6 * P[1] + P[2]) / 8, (P[1] + P[2]) / 2, (P[1] + 6 * P[2] + P[3]) / 8])),
    "uniform.two.scale.slip": lambda: equal(
        A.subs(s, s / 2), quadratic([(2 * P[0] + P[1]) / 3, (P[0] + 2 * P[1]) / 3, (2 * P[1] + P[2]) / 3])),
    "uniform.line": lambda: equal(
        F.subs({P[2]: 2 * P[1] - P[0], P[3]: 3 * P[1] - 2 * P[0]}, simultaneous=True), P[1] + s * (P[1] - P[0])),
    "knots.linear": lambda: all(map(equal, N1, [(T[3] - x) / (T[3] - T[2]), (x - T[2]) / (T[3] - T[2])])),
    "knots.quadratic": lambda: equal(N2[0], (T[3] - x) ** 2 / ((T[3] - T[1]) * (T[3] - T[2]))),
    "knots.quadratic.slip": lambda: equal(N2[0], (T[3] - x) ** 2 / ((T[3] - T[1]) * (T[2] - T[1]))),
    "knots.unity.quadratic": lambda: equal(sum(N2), 1),
    "knots.unity.cubic": lambda: equal(sum(N3), 1),
    "knots.unity.equal": lambda: equal(sum(N2), 1),
    "knots.nonnegative.ends": lambda: all(at_points(f, 2, 3, nonnegative) for f in (N2[0], N2[2])),
    "knots.nonnegative.middle": lambda: at_points(N2[1], 2, 3, lambda number: number > 0),
    "knots.nonnegative.outside": lambda: at_points(N2[1], 1, 4, nonnegative),
    "knots.nonnegative.cubic": lambda: all(at_points(f, 3, 4, nonnegative) for f in (N3[0], N3[3])),
    "knots.C1": lambda: jets(FK, GK, 1, x, T[3], T[3]),
    "knots.C1.value": lambda: equal(diff(FK, x).subs(x, T[3]), 2 * (P[2] - P[1]) / (T[4] - T[2])),
    "knots.C1.value.slip": lambda: equal(diff(FK, x).subs(x, T[3]), 2 * (P[2] - P[1]) / (T[4] - T[3])),
    "knots.C2": lambda: jets(CK, EK, 2, x, T[4], T[4]),
    "knots.convex": lambda: equal(
        FK.subs(x, T[3]), ((T[4] - T[3]) * P[1] + (T[3] - T[2]) * P[2]) / (T[4] - T[2])),
    "knots.greville": lambda: equal(sum((T[i + 1] + T[i + 2]) / 2 * f for i, f in enumerate(N2)), x),
    "knots.marsden": lambda: equal(
        sum((y - T[i + 1]) * (y - T[i + 2]) * f for i, f in enumerate(N2)), (y - x) ** 2),
    "knots.marsden.cubic": lambda: equal(
        sum((y - T[i + 1]) * (y - T[i + 2]) * (y - T[i + 3]) * f for i, f in enumerate(N3)), (y - x) ** 3),
    "knots.rate": lambda: equal(
        diff(N2[1], x), 2 * (N1[0] / (T[3] - T[1]) - N1[1] / (T[4] - T[2]))),
    "knots.rate.slip": lambda: equal(
        diff(N2[1], x), 2 * (N1[0] / (T[3] - T[2]) - N1[1] / (T[4] - T[2]))),
    "knots.span": lambda: equal(sum(N2), 1) and equal(sum(N2next), 1),
    "clamped.bernstein": lambda: all(
        equal(f, factorial(3) / factorial(i) / factorial(3 - i) * x**i * (1 - x) ** (3 - i))
        for i, f in enumerate(bezier)),
    "clamped.unity": lambda: equal(sum(first), 1) and equal(sum(second), 1),
    "clamped.ends": lambda: equal(FC.subs(x, 0), P[0]) and equal(GC.subs(x, 1), P[3]),
    "clamped.tangents": lambda: equal(diff(FC, x).subs(x, 0), 2 * (P[1] - P[0]) / m)
    and equal(diff(GC, x).subs(x, 1), 2 * (P[3] - P[2]) / (1 - m)),
    "clamped.tangents.slip": lambda: equal(diff(FC, x).subs(x, 0), 2 * (P[1] - P[0])),
    "clamped.C1": lambda: jets(FC, GC, 1, x, m, m),
    "clamped.knot": lambda: equal(FC.subs(x, m), (1 - m) * P[1] + m * P[2]),
    "clamped.C2": lambda: equal(diff(FC, x, 2), diff(GC, x, 2)),
}


if __name__ == "__main__":
    compare("splines", CHECKS)
