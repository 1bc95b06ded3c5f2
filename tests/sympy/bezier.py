"""Statements of derivations/bezier on numbers that there are, on integrals, powers, sums and products, worked out by SymPy.

Every claim of `exists.toml`, `integrals.toml` and `sums.toml` is stated here a second time, by hand and in SymPy's own terms, and compared
with what the derivation files expect. Where there is a number, it is solved for, or shown to be there; statements about every
degree are looked at for degrees 3 to 6, powers with a symbolic exponent.

    python3 tests/sympy/bezier.py
"""

from sympy import (Abs, Matrix, Rational, S, binomial, diff, expand, integrate, powsimp, prod, simplify, solve, solveset,
                   summation, symbols)

from expected import compare

x, a, b, r, s, t, u, v = symbols("x a b r s t u v", real=True)
m, k, j = symbols("m k j", integer=True, positive=True)
p1, p2, q1, q2 = symbols("p1 p2 q1 q2", real=True)
p, q = Matrix([p1, p2]), Matrix([q1, q2])
P = symbols("P0:9")
W = symbols("w0:9")
DEGREES = range(3, 7)


def equal(left, right):
    """Whether two expressions are equal as functions."""
    return simplify(expand(S(left) - S(right))) == 0


def B(i, n, x=x):
    """The Bernstein polynomial, zero for an index outside of its range."""
    return binomial(n, i) * x ** i * (1 - x) ** (n - i) if 0 <= i <= n else S(0)


def curve(n, points):
    return sum(B(i, n) * points[i] for i in range(n + 1))


def every(statement):
    return all(statement(n) for n in DEGREES)


def T(v):
    """The functions of the list."""
    return [(1 - x) ** 2 * (1 + v * x), 2 * x * (1 - x) - v * x * (1 - x), x ** 2 * (1 + v * (1 - x))]


def nonnegative(low, high):
    grid = [Rational(n, 12) for n in range(13)]
    tensions = [low + (high - low) * g for g in grid]
    return all(f.subs(x, g) >= 0 for tension in tensions for f in T(tension) for g in grid)


def corners(n, c):
    return [(1 - c) * P[i] + c * P[i + 1] for i in range(n + 1)]


def swapped(n, inner, outer):
    left = sum(inner(i, l) * P[l] for i in range(n + 1) for l in range(i + 1))
    return equal(left, sum(outer(n, i) * P[i] for i in range(n + 1)))


def in_unit(value):
    """Whether a function of x is between 0 and 1 at the points of a grid."""
    return all(0 <= value.subs(x, Rational(n, 40)) <= 1 for n in range(41))


CHECKS = {
    "exists.quotient": lambda: solve(r * a - b, r) == [b / a],
    "exists.quotient.any": lambda: solve(r * a - b, r) == [b / a],
    "exists.quotient.slip": lambda: solve(r * a - 1, r) == [1 / a],
    "exists.two": lambda: len(solve([r + s - a, r - s - b], [r, s])) == 2,
    "exists.between": lambda: in_unit(solve(2 * u - x ** 2 - x, u)[0]),
    "exists.between.slip": lambda: 0 < solve(2 * u - x ** 2 - x, u)[0].subs(x, 0) < 1,
    "exists.above": lambda: all((Abs(n) + 1 > n) and (Abs(n) + 1 > 0) for n in range(-9, 9)),
    "exists.root": lambda: equal(Abs(a) ** 2, a ** 2),
    "exists.none": lambda: not solveset(r ** 2 + 1, r, S.Reals).is_empty,
    # Linearly dependent of p, which is not zero, are the multiples of p.
    "exists.parallel": lambda: (q - p * p.dot(q) / p.dot(p)).subs({q1: t * p1, q2: t * p2}).applyfunc(simplify).is_zero_matrix,
    "exists.parallel.only": lambda: equal(p1 * r * p2, p2 * r * p1),
    "exists.plane": lambda: len(solve(list(r * p + s * q - Matrix([a, b])), [r, s])) == 2,
    "integral.bernstein": lambda: all(integrate(expand(B(i, 4)), (x, 0, 1)) == Rational(1, 5) for i in range(5)),
    "integral.bernstein.slip": lambda: all(integrate(expand(B(i, 4)), (x, 0, 1)) == Rational(1, 4) for i in range(5)),
    "integral.recursion": lambda: all(
        equal(B(i, 5), 5 * integrate(expand(B(i - 1, 4, t) - B(i, 4, t)), (t, 0, x))) for i in range(1, 5)),
    "integral.power": lambda: equal(integrate(expand((t - a) * (t - b)), (t, a, b)), -(b - a) ** 3 / 6),
    "integral.area": lambda: equal(
        integrate(expand(Matrix.hstack((1 - x) * p + x * q, q - p).det()), (x, 0, 1)) / 2, Matrix.hstack(p, q).det() / 2),
    "integral.rate": lambda: equal(diff(integrate(t ** 2 + a, (t, 0, b)), b), b ** 2 + a),
    "integral.order": lambda: all(
        integrate((t - Rational(n, 20)) ** 2, (t, 0, 1)) >= 0 for n in range(21)),
    "power.next": lambda: powsimp((1 - x) ** m * (1 - x)) == (1 - x) ** (m + 1),
    "power.rate": lambda: equal(diff((1 - x) ** m, x) / (1 - x) ** (m - 1), -m),
    "power.rate.slip": lambda: equal(diff((1 - x) ** m, x) / (1 - x) ** (m - 1), m),
    "power.product": lambda: every(lambda n: equal((a * b) ** n * a ** k, a ** (n + k) * b ** n)),
    "power.ends": lambda: every(lambda n: equal(B(0, n), (1 - x) ** n) and equal(B(n, n), x ** n)),
    "power.binomial": lambda: every(
        lambda n: equal(sum(binomial(n, i) * u ** (n - i) * v ** i for i in range(n + 1)), (u + v) ** n)),
    "sum.powers": lambda: equal(summation(j ** 3, (j, 1, m)), (m * (m + 1) / 2) ** 2),
    "sum.powers.slip": lambda: equal(summation(j ** 2, (j, 1, m)), m * (m + 1) * (2 * m + 1) / 3),
    "sum.swap": lambda: every(lambda n: swapped(n, lambda i, l: 1, lambda n, i: n + 1 - i)),
    "sum.swap.weighted": lambda: every(
        lambda n: swapped(n, lambda i, l: i - l, lambda n, i: Rational((n - i) * (n + 1 - i), 2))),
    "sum.swap.slip": lambda: every(lambda n: swapped(n, lambda i, l: 1, lambda n, i: n - i)),
    "product.numbers": lambda: equal(prod(a + i for i in range(1, 4)), a ** 3 + 6 * a ** 2 + 11 * a + 6),
    "product.telescope": lambda: every(
        lambda n: prod(Rational(i + 1, i) for i in range(1, n + 1)) == n + 1
        and prod(Rational(i, i + 2) for i in range(1, n + 1)) == Rational(2, (n + 1) * (n + 2))),
    "product.telescope.slip": lambda: every(lambda n: prod(Rational(i + 1, i) for i in range(1, n + 1)) == n),
    "family.corner": lambda: every(
        lambda n: equal(curve(n, corners(n, a)), (1 - a) * curve(n, P) + a * curve(n, P[1:]))),
    "family.casteljau": lambda: every(lambda n: equal(curve(n, corners(n, x)), curve(n + 1, P))),
    "family.casteljau.slip": lambda: every(lambda n: equal(curve(n, corners(n, a)), curve(n + 1, P))),
    "family.weights": lambda: all(
        equal(curve(n, [b * W[i] * P[i] for i in range(9)]) * curve(n, W),
              curve(n, [W[i] * P[i] for i in range(9)]) * curve(n, [b * W[i] for i in range(9)])) for n in (3, 4)),
    "list.unity": lambda: equal(sum(T(v)), 1),
    "list.nonnegative": lambda: nonnegative(S(-1), S(2)),
    "list.nonnegative.slip": lambda: nonnegative(S(-1), S(3)),
}


if __name__ == "__main__":
    compare("bezier", CHECKS, files=("exists", "integrals", "sums"))
