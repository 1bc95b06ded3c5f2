"""Formulas of the shipped papers, as programs have them."""

from math import comb

import numpy as np
from sympy import Rational, cos, diff, pi, sin, symbols

t = symbols("t")


def curve(x, m, P):
    return sum(comb(m, i)*x**i*(1 - x)**(m - i)*P[i] for i in range(m + 1))


def casteljau(x, P):
    q = list(P)
    for k in range(1, len(q)):
        for i in range(len(q) - k):
            q[i] = (1 - x)*q[i] + x*q[i + 1]
    return q[0]


def hodograph(x, P):
    d = [3*(P[i + 1] - P[i]) for i in range(3)]
    return (1 - x)**2*d[0] + 2*x*(1 - x)*d[1] + x**2*d[2]


def last_tangent(m, P):
    return m*(P[m] - P[m - 1])


def second_derivative(m, P):
    return m*(m - 1)*(P[0] - 2*P[1] + P[2])


def middle(P):
    total = 0
    for i, weight in enumerate([1, 3, 3, 1]):
        total += weight*P[i]
    return total/8


def first(z, mu):
    s = np.sin(np.pi/2*z)
    return (1 - s)*(1 - mu*s)


def third(z, ν):
    c = np.cos(0.5*np.pi*z)
    return (1 - c)*(1 - ν*c)


def basis(k, m, z, mu, nu):
    """The functions of order m, by the recursion."""
    if k < 0 or k > m:
        return 0
    if m == 2:
        f0 = first(z, mu)
        f2 = third(z, nu)
        return [f0, 1 - f0 - f2, f2][k]
    return (1 - z)*basis(k, m - 1, z, mu, nu) + z*basis(k - 1, m - 1, z, mu, nu)


def cubic(u, p0, p1, p0u, p1u):
    a = 2*p0 - 2*p1 + p0u + p1u
    b = -3*p0 + 3*p1 - 2*p0u - p1u
    return ((a*u + b)*u + p0u)*u + p0


def quartic(u, p0, pm, p1, p0u, p1u):
    a = -8*p1 - 8*p0 + 16*pm + 2*p1u - 2*p0u
    b = 14*p1 + 18*p0 - 32*pm - 3*p1u + 5*p0u
    c = -5*p1 - 11*p0 + 16*pm + p1u - 4*p0u
    return a*u**4 + b*u**3 + c*u**2 + p0u*u + p0


def uniform(s):
    return np.array([(1 - s)**3, 3*s**3 - 6*s**2 + 4, -3*s**3 + 3*s**2 + 3*s + 1, s**3])/6


def inner(t, lamda, mu):
    return (1 + lamda)*sin(t) + (1 + mu)*cos(t) - lamda*sin(t)**2 - mu*cos(t)**2 - 1


def tangent(lamda, mu, P):
    a = (1 - sin(t))*(1 - lamda*sin(t))
    c = (1 - cos(t))*(1 - mu*cos(t))
    F = a*P[0] + (1 - a - c)*P[1] + c*P[2]
    return diff(F, t).subs(t, 0)
