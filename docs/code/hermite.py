"""A cubic Hermite curve, by Horner's rule."""


def cubic(u, p0, p1, p0u, p1u):
    a = 2*(p0 - p1) + p0u + p1u
    b = 3*(p1 - p0) - 2*p0u - p1u
    return ((a*u + b)*u + p0u)*u + p0
