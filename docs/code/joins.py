"""Coefficients of C3 joins of GBT-Bézier curves."""

from math import pi


def b3(n, mu1, nu1):
    """Minus eight times the third derivative of the second segment at 0, as far as it depends on its third point."""
    lower = 2*(n - 3)*(n - 4) + 3*pi*(1 + mu1)*(n - 3)
    return 12*(n - 2)*(lower + pi**2*(1 + mu1 - nu1))
