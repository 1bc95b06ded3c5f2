//! The equation of a connecting developable and its derivatives.

use crate::coordinate::Coordinate;
use crate::curve::SpaceCurve;
use crate::error::{GeometryError, Result};
use crate::vector::{det, sub};
use torse_algebra::Jet;

/// `F(s, t) = det(c1'(s), c2'(t), c2(t) - c1(s))` with its first derivatives. The derivative of the
/// difference drops out of both, as it repeats a column.
#[derive(Debug, Clone)]
pub(super) struct Equation<S> {
    /// `F`.
    pub value: S,
    /// `F_s = det(c1'', c2', c2 - c1)`.
    pub by_s: S,
    /// `F_t = det(c1', c2'', c2 - c1)`.
    pub by_t: S,
}

/// Point, first and second derivative of a curve.
#[derive(Debug, Clone)]
pub(super) struct Contact<S> {
    pub point: [S; 3],
    pub first: [S; 3],
    pub second: [S; 3],
}

impl<S: Coordinate> Contact<S> {
    pub(super) fn at<C: SpaceCurve<S>>(curve: &C, at: &S) -> Result<Self> {
        let jets = curve.space_jet(at, 2)?;
        let derivative = |n: usize| {
            let all = jets.each_ref().map(|jet| jet.derivative(n));
            match all {
                [Some(x), Some(y), Some(z)] => Ok([x, y, z]),
                _ => Err(too_short()),
            }
        };
        Ok(Self {
            point: derivative(0)?,
            first: derivative(1)?,
            second: derivative(2)?,
        })
    }
}

impl<S: Coordinate> Equation<S> {
    pub(super) fn from_contacts(one: &Contact<S>, two: &Contact<S>) -> Self {
        let ruling = sub(&two.point, &one.point);
        Self {
            value: det(&one.first, &two.first, &ruling),
            by_s: det(&one.second, &two.first, &ruling),
            by_t: det(&one.first, &two.second, &ruling),
        }
    }

    pub(super) fn at<P: SpaceCurve<S>, Q: SpaceCurve<S>>(
        rails: (&P, &Q),
        s: &S,
        t: &S,
    ) -> Result<Self> {
        Ok(Self::from_contacts(
            &Contact::at(rails.0, s)?,
            &Contact::at(rails.1, t)?,
        ))
    }
}

/// A curve and its derivative as series of their own parameter, to be run through as a series of another.
pub(super) struct Expansion<S> {
    point: [Jet<S>; 3],
    slope: [Jet<S>; 3],
}

impl<S: Coordinate> Expansion<S> {
    /// About `at`, good for series of this order.
    pub(super) fn about<C: SpaceCurve<S>>(curve: &C, at: &S, order: usize) -> Result<Self> {
        let point = curve.space_jet(at, order.saturating_add(1))?;
        let slope = point.each_ref().map(Jet::differentiated);
        match slope {
            [Some(x), Some(y), Some(z)] => Ok(Self {
                slope: [x, y, z],
                point,
            }),
            _ => Err(too_short()),
        }
    }

    pub(super) fn points(&self, parameter: &Jet<S>) -> [Jet<S>; 3] {
        self.point.each_ref().map(|axis| composed(axis, parameter))
    }

    pub(super) fn slopes(&self, parameter: &Jet<S>) -> [Jet<S>; 3] {
        self.slope.each_ref().map(|axis| composed(axis, parameter))
    }
}

/// `f(parameter(x))` for the series `f` about the value of the parameter, by Horner's rule.
fn composed<S: Coordinate>(f: &Jet<S>, parameter: &Jet<S>) -> Jet<S> {
    let shift = parameter.clone() - parameter.constant_like(parameter.value().clone());
    let zero = shift.constant_like(parameter.value().zero());
    let known = f.coefficients().iter().take(shift.order() + 1).rev();
    known.fold(zero, |sum, c| {
        sum * shift.clone() + shift.constant_like(c.clone())
    })
}

fn too_short() -> GeometryError {
    GeometryError::LengthMismatch {
        what: "Taylor coefficients of a rail",
        index: 0,
        expected: 3,
        given: 1,
    }
}
