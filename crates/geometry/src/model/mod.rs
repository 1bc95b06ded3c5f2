//! Functions on an interval with a proved bound: Chebyshev models.
//!
//! A [`ChebyshevModel`] is a polynomial of degree 16 in `t`, where `t` runs over [-1, 1] while the parameter runs over
//! an interval, and a *radius*: it stands for every function that differs from the polynomial by no more than the
//! radius anywhere on the interval. Sums and products of models hold the sums and products of all functions that they
//! stand for: what exceeds degree 16 and all rounding goes into the radius. Quotients and square roots are
//! interpolated, and then proved by the residual of a polynomial identity (module `residual`), so no sample is ever
//! trusted (Joldes, *Rigorous polynomial approximations and applications*, 2011; Brisebarre and Joldes 2010).
//!
//! A model is a scalar like any other: curves, plane families and patches over models give models of their points and
//! derivatives over a whole interval.
//!
//! Rounding: with `u = 2^-53` a sum of `k` products of f64 is off by at most `k u/(1 - k u)` times the sum of the
//! absolute products, in whatever order it is added (Higham, *Accuracy and Stability*, section 3.1).

mod residual;

use crate::chebyshev::{DEGREE, Interpolant, NODES, Row, basis, node_rows};
use crate::coordinate::Coordinate;
use std::cmp::Ordering;
use std::f64::consts::PI;
use std::ops::{Add, Mul, Neg, Sub};
use torse_algebra::{ExactError, Rational, Scalar, rational::to_f64};

/// All functions on an interval within a radius of a polynomial of degree 16.
///
/// ```
/// use torse_geometry::{Coordinate, ChebyshevModel};
/// use torse_geometry::prelude::*;
/// // The parameter on [1/4, 1/2], and 1/(1 + x^2) there.
/// let x = ChebyshevModel::identity(0.25, 0.5);
/// let f = x.one().quotient(&(x.one() + x.clone() * x.clone())).ok_or("no zero there")?;
/// let [low, high] = f.range();
/// assert!(low <= 0.8 && 1.0 / 1.0625 <= high && high - low < 0.2);
/// assert!(f.radius() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChebyshevModel {
    /// Of `T_0`, ..., `T_16`.
    coefficients: Row,
    /// All coefficients above are zero.
    degree: usize,
    radius: f64,
}

/// Bounds are rounded upwards by a few units in the last place, and by what underflow may have taken.
fn up(bound: f64) -> f64 {
    bound * (1.0 + 4.0 * f64::EPSILON) + f64::MIN_POSITIVE
}

/// The rounding of sums of `terms` products, relative to the sum of their absolute values.
#[allow(clippy::cast_precision_loss)]
fn rounding(terms: usize) -> f64 {
    // u = EPSILON/2; twice that covers the denominator 1 - k u.
    (terms as f64 + 2.0) * f64::EPSILON
}

impl ChebyshevModel {
    /// The constant function.
    #[must_use]
    pub fn exact(value: f64) -> Self {
        let mut coefficients = [0.0; NODES];
        coefficients[0] = value;
        Self {
            coefficients,
            degree: 0,
            radius: 0.0,
        }
    }

    /// The parameter itself on `[from, to]`.
    #[must_use]
    pub fn identity(from: f64, to: f64) -> Self {
        let mut model = Self::exact(0.5 * (from + to));
        model.coefficients[1] = 0.5 * (to - from);
        model.degree = 1;
        // Of dyadic ends nothing is rounded.
        let rounded = from + to - to != from || 2.0 * model.coefficients[1] + from != to;
        if rounded {
            model.radius = up(2.0 * f64::EPSILON * from.abs().max(to.abs()));
        }
        model
    }

    /// A polynomial with these coefficients and a radius.
    fn with_radius(coefficients: Row, radius: f64) -> Self {
        let degree = coefficients.iter().rposition(|c| *c != 0.0).unwrap_or(0);
        Self {
            coefficients,
            degree,
            radius,
        }
    }

    /// The polynomial through these values at the nodes, as a function of its own.
    pub(crate) fn through(values: &Row) -> Self {
        Self::with_radius(*Interpolant::through(values).coefficients(), 0.0)
    }

    /// How far a function that the model stands for may be from the polynomial.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The same polynomial with more room about it.
    pub(crate) fn widened(&self, by: f64) -> Self {
        Self {
            radius: up(self.radius + by),
            ..*self
        }
    }

    /// The polynomial alone.
    pub(crate) fn polynomial(&self) -> Self {
        Self {
            radius: 0.0,
            ..*self
        }
    }

    pub(crate) fn interpolant(&self) -> Interpolant {
        Interpolant::from_coefficients(self.coefficients)
    }

    fn active(&self) -> &[f64] {
        self.coefficients.get(..=self.degree).unwrap_or(&[])
    }

    /// The sum of the absolute coefficients: the polynomial is nowhere larger.
    fn size(&self) -> f64 {
        up(self.active().iter().map(|c| c.abs()).sum::<f64>())
    }

    /// An upper bound of the absolute values.
    #[must_use]
    pub fn largest(&self) -> f64 {
        let [low, high] = self.range();
        low.abs().max(high.abs())
    }

    /// Bounds of the values: the first coefficient and the sum of the others, or what the values at the nodes leave
    /// where that is better.
    #[must_use]
    pub fn range(&self) -> [f64; 2] {
        let Some((first, rest)) = self.active().split_first() else {
            return [0.0; 2];
        };
        let reach = up(rest.iter().map(|c| c.abs()).sum::<f64>() + self.radius);
        let slack = f64::EPSILON * first.abs();
        if reach == f64::MIN_POSITIVE && self.radius == 0.0 {
            return [*first; 2];
        }
        [
            (first - reach) - slack - f64::EPSILON * reach,
            (first + reach) + slack + f64::EPSILON * reach,
        ]
    }

    /// An upper bound of the absolute values that is at most a twelfth too high: a polynomial of degree 16 is nowhere
    /// larger than `1/cos(16 pi/128)` times the largest of its values at the 65 points `cos(pi k/64)` (Ehlich and
    /// Zeller 1964).
    pub(crate) fn sharply_largest(&self) -> f64 {
        const POINTS: u32 = 64;
        /// `1/cos(pi/8)`, rounded upwards.
        const FACTOR: f64 = 1.082_392_200_293;
        let largest = (0..=POINTS)
            .map(|k| {
                self.at(libm::cos(PI * f64::from(k) / f64::from(POINTS)))
                    .abs()
            })
            .fold(0.0, f64::max);
        let rounded = rounding(NODES + 2) * self.size();
        self.largest()
            .min(up(FACTOR * (largest + rounded) + self.radius))
    }

    /// An upper bound of the length of a vector: that of the largest coordinates, or of its square as one polynomial, which
    /// does not take the largest of each at different places.
    pub(crate) fn largest_length(vector: &[Self; 3]) -> f64 {
        let squares = vector.map(|c| c.sharply_largest().powi(2));
        let apart = squares.iter().sum::<f64>();
        let square = crate::vector::dot(vector, vector).sharply_largest();
        apart.min(square).sqrt() * (1.0 + 1e-12)
    }

    /// A lower bound of the absolute values; zero where the sign is not known.
    #[must_use]
    pub fn least(&self) -> f64 {
        let [low, high] = self.range();
        low.max(-high).max(0.0)
    }

    /// The values of the linear part at both ends, and how far any function may be from the line between them.
    pub(crate) fn chord(&self) -> ([f64; 2], f64) {
        let [middle, slope] = [self.coefficients[0], self.coefficients[1]];
        let rest = self.active().iter().skip(2).map(|c| c.abs()).sum::<f64>();
        let rounded = 2.0 * f64::EPSILON * (middle.abs() + slope.abs());
        (
            [middle - slope, middle + slope],
            up(up(rest) + self.radius + rounded),
        )
    }

    /// The values of the polynomial at the nodes.
    pub(crate) fn at_nodes(&self) -> Row {
        if self.degree == 0 {
            return [self.coefficients[0]; NODES];
        }
        let f = self.interpolant();
        node_rows().each_ref().map(|row| f.at(row))
    }

    /// The value of the polynomial at `t` in [-1, 1].
    pub(crate) fn at(&self, t: f64) -> f64 {
        self.interpolant().at(&basis(t))
    }

    /// The integral from the left end of an interval of this half width.
    pub(crate) fn integral(&self, half: f64) -> Self {
        let whole = self.interpolant().integral(half, 0.0);
        // The part of degree 17, and twice its half for the constant; rounding; and the radius over the width.
        #[allow(clippy::cast_precision_loss)]
        let dropped = if self.degree == DEGREE {
            self.coefficients[DEGREE].abs() * half / NODES as f64
        } else {
            0.0
        };
        let rounded = rounding(NODES + 4) * half * (2.0 * self.size());
        Self::with_radius(
            *whole.coefficients(),
            up(dropped + rounded + 2.0 * half * self.radius),
        )
    }

    /// Bounds of the integral over the whole of an interval of this half width.
    pub(crate) fn total(&self, half: f64) -> [f64; 2] {
        let value = self.interpolant().total(half);
        let off = up(half * (rounding(NODES + 4) * 2.0 * self.size() + 2.0 * self.radius));
        [value, off]
    }

    /// The derivative of the polynomial on an interval of this half width, with its rounding.
    pub(crate) fn slope_of_polynomial(&self, half: f64) -> Self {
        let slope = self.interpolant().derivative(half);
        #[allow(clippy::cast_precision_loss)]
        let terms = self
            .active()
            .iter()
            .enumerate()
            .map(|(j, c)| (j * j) as f64 * c.abs());
        let rounded = rounding(NODES + 6) * terms.sum::<f64>() / half;
        Self::with_radius(*slope.coefficients(), up(rounded))
    }

    /// The same functions on a part of the interval, `t` from `from` to `to`, as an interpolant of the polynomial:
    /// exact but for rounding.
    fn scaled_by(&self, factor: f64) -> Self {
        let coefficients = self.coefficients.map(|c| c * factor);
        let rounded = f64::EPSILON * self.size() * factor.abs();
        Self::with_radius(coefficients, up(self.radius * factor.abs() + rounded))
    }
}

impl Add for ChebyshevModel {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let coefficients: Row =
            std::array::from_fn(|k| self.coefficients[k] + other.coefficients[k]);
        let sum = Self::with_radius(coefficients, 0.0);
        if self.is_exact_zero() {
            return other;
        }
        if other.is_exact_zero() {
            return self;
        }
        let rounded = f64::EPSILON * sum.size();
        Self {
            radius: up(self.radius + other.radius + rounded),
            ..sum
        }
    }
}

impl Neg for ChebyshevModel {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            coefficients: self.coefficients.map(|c| 0.0 - c),
            ..self
        }
    }
}

impl Sub for ChebyshevModel {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        if self.radius == 0.0 && other.radius == 0.0 && self.degree + other.degree == 0 {
            let difference = self.coefficients[0] - other.coefficients[0];
            // Of neighbours the difference is exact.
            let [a, b] = [self.coefficients[0], other.coefficients[0]];
            if difference == 0.0 || (0.5 * a <= b && b <= 2.0 * a) || (2.0 * a <= b && b <= 0.5 * a)
            {
                return Self::exact(difference);
            }
        }
        self + -other
    }
}

impl Mul for ChebyshevModel {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let (long, short) = if self.degree < other.degree {
            (other, self)
        } else {
            (self, other)
        };
        if long.is_exact_zero() || short.is_exact_zero() {
            return Self::exact(0.0);
        }
        let radii = |product: f64| {
            let (a, b) = (long.size(), short.size());
            up(a * short.radius + b * long.radius + long.radius * short.radius + product * a * b)
        };
        if short.degree == 0 {
            let factor = short.coefficients[0];
            let exact = factor.abs() == 1.0;
            let coefficients = long.coefficients.map(|c| c * factor);
            let product = if exact { 0.0 } else { f64::EPSILON };
            let radius = if exact && short.radius == 0.0 {
                long.radius
            } else {
                radii(product)
            };
            return Self::with_radius(coefficients, radius);
        }
        // T_i T_j = (T_(i+j) + T_|i-j|)/2.
        let mut sum = [0.0; 2 * NODES];
        let (a, b) = (long.active(), short.active());
        for (j, y) in b.iter().enumerate() {
            let y = 0.5 * y;
            for (slot, x) in sum.iter_mut().skip(j).zip(a) {
                *slot += x * y;
            }
            // |i - j| from j down to 0, and up from 1.
            let (below, above) = a.split_at((j + 1).min(a.len()));
            for (slot, x) in sum.iter_mut().take(j + 1).rev().zip(below) {
                *slot += x * y;
            }
            for (slot, x) in sum.iter_mut().skip(1).zip(above) {
                *slot += x * y;
            }
        }
        let mut coefficients = [0.0; NODES];
        coefficients.copy_from_slice(sum.get(..NODES).unwrap_or(&[0.0; NODES]));
        let tail: f64 = sum.iter().skip(NODES).map(|c| c.abs()).sum();
        let radius = up(radii(rounding(2 * short.degree + 4)) + tail);
        Self::with_radius(coefficients, radius)
    }
}

impl ChebyshevModel {
    fn is_exact_zero(&self) -> bool {
        self.degree == 0 && self.coefficients[0] == 0.0 && self.radius == 0.0
    }
}

impl Scalar for ChebyshevModel {
    fn constant(&self, q: &Rational) -> Self {
        let value = to_f64(q);
        let model = Self::exact(value);
        if crate::exact(value) == *q {
            return model;
        }
        model.widened(f64::EPSILON * value.abs())
    }

    fn zero_like(&self) -> Self {
        Self::exact(0.0)
    }

    fn one_like(&self) -> Self {
        Self::exact(1.0)
    }

    fn divided_by(&self, divisor: &Self) -> Result<Self, ExactError> {
        self.quotient(divisor)
            .ok_or_else(|| ExactError::DivisionByZero {
                divisor: format!("{:?}", divisor.range()),
            })
    }

    /// Of a linear function `m + h t`: the interpolant, which is off by at most the 17th derivative over `17! 2^16`,
    /// and the rounding of its values. Of any other by its residual.
    fn quarter_turn(&self) -> Result<(Self, Self), ExactError> {
        let none = || ExactError::NoExactTurn {
            argument: format!("{:?}", self.range()),
        };
        let step = self.coefficients[1].abs();
        if self.degree > 1 || !(step <= 0.5 && self.coefficients[0].abs() <= 2.0) {
            return self.turn_of_any_degree().ok_or_else(none);
        }
        // (pi/4)^17/(17! 2^16) < 1e-21; values within two units in the last place; 17 coefficients, each a sum of
        // differences of values times weights, of which the absolute ones add up to two.
        let spread = (PI * step).min(1.0);
        let transformed = 34.0 * rounding(12) * spread;
        let radius = up(1e-21 + 16.0 * f64::EPSILON + transformed + 0.5 * PI * self.radius);
        let mut values = [[0.0; NODES]; 2];
        for (k, x) in self.at_nodes().into_iter().enumerate() {
            let (s, c) = if (0.0..=1.0).contains(&x) {
                crate::turn::of_unit(x)
            } else {
                let (s, c) = libm::sincos(0.5 * PI * x);
                (s, c)
            };
            (values[0][k], values[1][k]) = (s, c);
        }
        let [s, c] = values
            .each_ref()
            .map(|row| Self::through(row).widened(radius));
        Ok((s, c))
    }

    fn pi_like(&self) -> Result<Self, ExactError> {
        Ok(Self::exact(PI).widened(2.0 * f64::EPSILON))
    }
}

impl Coordinate for ChebyshevModel {
    fn is_finite(&self) -> bool {
        self.radius.is_finite() && self.active().iter().all(|c| c.is_finite())
    }

    fn sign(&self) -> Option<Ordering> {
        let [low, high] = self.range();
        if low > 0.0 {
            Some(Ordering::Greater)
        } else if high < 0.0 {
            Some(Ordering::Less)
        } else if low == 0.0 && high == 0.0 {
            Some(Ordering::Equal)
        } else {
            None
        }
    }

    /// The value in the middle of the interval.
    fn approximate(&self) -> f64 {
        self.at(0.0)
    }

    fn times_two_to(&self, power: i32) -> Self {
        Self {
            coefficients: self.coefficients.map(|c| c.times_two_to(power)),
            radius: if self.radius == 0.0 {
                0.0
            } else {
                up(self.radius.times_two_to(power))
            },
            ..*self
        }
    }

    fn half_pi(&self) -> Result<Self, ExactError> {
        Ok(Self::exact(0.5 * PI).widened(f64::EPSILON))
    }

    fn zero(&self) -> Self {
        Self::exact(0.0)
    }

    fn one(&self) -> Self {
        Self::exact(1.0)
    }

    #[allow(clippy::cast_precision_loss)]
    fn natural(&self, n: usize) -> Self {
        Self::exact(n as f64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::prelude::*;
    use crate::surface::Rails;
    use crate::{Over, exact_ball};
    use torse_algebra::Ball;

    /// Whether the exact value, in a ball, is where the model says.
    fn holds(model: &ChebyshevModel, t: f64, value: &Ball) -> bool {
        let (low, high) = value.to_f64_bounds();
        let at = model.at(t);
        let off = (at - low).abs().max((at - high).abs());
        off <= model.radius() + 1e-15 * (1.0 + at.abs())
    }

    #[test]
    fn quotients_roots_and_quarter_turns_stay_within_their_radius() {
        for (from, to) in [(0.0, 1.0), (0.25, 0.5), (0.75, 1.0)] {
            let x = ChebyshevModel::identity(from, to);
            let two = ChebyshevModel::exact(2.0);
            let f = (x * x - two).quotient(&(x + two)).unwrap();
            let g = (x * x + two).root().unwrap();
            let (sine, cosine) = x.quarter_turn().unwrap();
            assert!([f, g, sine, cosine].iter().all(|m| m.radius() < 1e-10));
            for k in 0..=16 {
                let t = f64::from(k) / 8.0 - 1.0;
                let at = exact_ball(0.5 * (from + to) + 0.5 * (to - from) * t, 200);
                let ball = |v: f64| exact_ball(v, 200);
                let square = at.clone() * at.clone();
                let quotient = (square.clone() - ball(2.0)).divided_by(&(at.clone() + ball(2.0)));
                assert!(holds(&f, t, &quotient.unwrap()));
                assert!(holds(&g, t, &(square + ball(2.0)).sqrt().unwrap()));
                let (s, c) = at.quarter_turn().unwrap();
                assert!(holds(&sine, t, &s) && holds(&cosine, t, &c));
            }
        }
        let x = ChebyshevModel::identity(0.0, 1.0);
        assert!(x.one().quotient(&x).is_none() && (x - x.one()).root().is_none());
    }

    #[test]
    fn models_of_rails_hold_the_rails_of_every_construction() {
        let planes = [
            [7., -7., 5., 125.],
            [-7., -7., 5., 120.],
            [-7., 7., 5., 130.],
            [7., 7., 5., 125.],
        ];
        let planes = Planes::gbt(0.5, 0.25, &planes).unwrap();
        let cut = Cut::between([0., 0., 1., 0.], [0., 0., 1., 3.]);
        let chine = Rail::bezier(&[[0.0, 0.0, 0.0], [2.0, 3.0, 0.0], [6.0, 0.0, 0.0]]).unwrap();
        let deck = Rail::bezier(&[[0.5, 0.0, 2.0], [3.0, 2.0, 3.0], [6.0, -1.0, 2.0]]).unwrap();
        let sheets = [
            Sheet::envelope(&planes, cut).unwrap(),
            Sheet::between(&chine, &deck).unwrap().sheet.unwrap(),
            Sheet::ruled(chine.clone(), deck.clone()),
            Sheet::ruled(chine, deck).part(0.25, 0.75).unwrap(),
        ];
        for sheet in &sheets {
            let models = sheet.over(&|x| ChebyshevModel::exact(*x)).unwrap();
            let balls = sheet.over(&|x| exact_ball(*x, 160)).unwrap();
            for (from, to) in [(0.25, 0.375), (0.5, 0.75)] {
                let strip = models
                    .ends_and_slopes(&ChebyshevModel::identity(from, to))
                    .unwrap();
                for k in 0..=6 {
                    let t = f64::from(k) / 3.0 - 1.0;
                    // A dyadic parameter, which both know exactly.
                    let t = (t * 64.0).round() / 64.0;
                    let x = exact_ball(0.5 * (from + to) + 0.5 * (to - from) * t, 160);
                    let exact = balls.ends_and_slopes(&x).unwrap();
                    let pairs = strip.as_flattened().iter().zip(exact.as_flattened());
                    for (models, values) in pairs {
                        for (model, value) in models.iter().zip(values) {
                            assert!(model.radius() < 1e-7, "{}", model.radius());
                            assert!(holds(model, t, value));
                        }
                    }
                }
            }
        }
    }
}
