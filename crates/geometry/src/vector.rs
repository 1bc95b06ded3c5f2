//! Points and vectors as plain arrays over any scalar.

use crate::coordinate::Coordinate;
use crate::error::{GeometryError, Result};
use torse_algebra::Scalar;

/// `a + b`.
#[must_use]
#[inline]
pub fn add<S: Scalar, const D: usize>(a: &[S; D], b: &[S; D]) -> [S; D] {
    std::array::from_fn(|i| a[i].clone() + b[i].clone())
}

/// `a - b`.
#[must_use]
#[inline]
pub fn sub<S: Scalar, const D: usize>(a: &[S; D], b: &[S; D]) -> [S; D] {
    std::array::from_fn(|i| a[i].clone() - b[i].clone())
}

/// `factor * a`.
#[must_use]
#[inline]
pub fn scale<S: Scalar, const D: usize>(factor: &S, a: &[S; D]) -> [S; D] {
    std::array::from_fn(|i| factor.clone() * a[i].clone())
}

/// `2^power * a`.
#[inline(always)]
pub(crate) fn times_two_to<S: Coordinate>(a: &[S; 3], power: i32) -> [S; 3] {
    let [x, y, z] = a;
    [
        x.times_two_to(power),
        y.times_two_to(power),
        z.times_two_to(power),
    ]
}

/// The scalar product of two vectors of the space.
#[must_use]
#[inline]
pub fn dot<S: Scalar>(a: &[S; 3], b: &[S; 3]) -> S {
    a[0].clone() * b[0].clone() + a[1].clone() * b[1].clone() + a[2].clone() * b[2].clone()
}

/// The vector product.
#[must_use]
#[inline]
pub fn cross<S: Scalar>(a: &[S; 3], b: &[S; 3]) -> [S; 3] {
    let minor = |i: usize, j: usize| a[i].clone() * b[j].clone() - a[j].clone() * b[i].clone();
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// The determinant of three vectors, `a . (b x c)`.
#[must_use]
pub fn det<S: Scalar>(a: &[S; 3], b: &[S; 3], c: &[S; 3]) -> S {
    dot(a, &cross(b, c))
}

/// The determinant of four vectors with four coordinates, by Laplace's expansion along two of them.
#[must_use]
pub(crate) fn det4<S: Scalar>(a: &[S; 4], b: &[S; 4], c: &[S; 4], d: &[S; 4]) -> S {
    let minor = |x: &[S; 4], y: &[S; 4], i: usize, j: usize| {
        x[i].clone() * y[j].clone() - x[j].clone() * y[i].clone()
    };
    let even = |i, j, k, l| minor(a, b, i, j) * minor(c, d, k, l);
    even(0, 1, 2, 3) - even(0, 2, 1, 3) + even(0, 3, 1, 2) + even(1, 2, 0, 3) - even(1, 3, 0, 2)
        + even(2, 3, 0, 1)
}

/// `(1 - t) a + t b`, exact at both ends.
#[must_use]
pub fn lerp<S: Scalar, const D: usize>(a: &[S; D], b: &[S; D], t: &S) -> [S; D] {
    let s = t.one_like() - t.clone();
    std::array::from_fn(|i| s.clone() * a[i].clone() + t.clone() * b[i].clone())
}

/// The Euclidean length of an f64 vector.
#[must_use]
pub fn norm<const D: usize>(a: &[f64; D]) -> f64 {
    a.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// `a / |a|`, or `None` where the length is zero or not finite.
#[must_use]
pub fn unit<const D: usize>(a: &[f64; D]) -> Option<[f64; D]> {
    let length = norm(a);
    (length > 0.0 && length.is_finite()).then(|| a.map(|x| x / length))
}

/// `sum_i weights[i] * points[i]` over the shorter of both lists, `None` when it is empty.
#[inline(always)]
pub(crate) fn combine<S: Scalar, const D: usize>(
    weights: &[S],
    points: &[[S; D]],
) -> Option<[S; D]> {
    let mut terms = weights.iter().zip(points).map(|(w, p)| scale(w, p));
    let first = terms.next()?;
    Some(terms.fold(first, |sum, term| add(&sum, &term)))
}

/// `sum_i row[i] * points[i]`; refuses a row that has not one basis function for each control point, as a family of
/// somebody else may give it: the points that are left out would count as zero.
#[inline(always)]
pub(crate) fn blended<S: Scalar, const D: usize>(row: &[S], points: &[[S; D]]) -> Result<[S; D]> {
    match combine(row, points) {
        Some(sum) if row.len() == points.len() => Ok(sum),
        _ => Err(GeometryError::LengthMismatch {
            what: "basis functions",
            index: 0,
            expected: points.len(),
            given: row.len(),
        }),
    }
}
