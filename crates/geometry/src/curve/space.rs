//! Curves as surfaces see them: points, derivatives, Taylor series.

use super::{Curve, RationalCurve};
use crate::basis::Basis;
use crate::coordinate::Coordinate;
use crate::error::{GeometryError, Result};
use crate::vector::blended;
use torse_algebra::Jet;

/// A curve in space (or in another dimension), known by its Taylor series.
pub trait SpaceCurve<S: Coordinate, const D: usize = 3>: Sync {
    /// The Taylor series of the coordinates at `x`.
    ///
    /// # Errors
    /// [`GeometryError`] where the curve has no point or derivative.
    fn space_jet(&self, x: &S, order: usize) -> Result<[Jet<S>; D]>;

    /// The point at `x`.
    ///
    /// # Errors
    /// As [`SpaceCurve::space_jet`].
    fn space_point(&self, x: &S) -> Result<[S; D]> {
        Ok(self.space_jet(x, 0)?.map(|jet| jet.value().clone()))
    }

    /// The point at `x` and the first derivative there: what certificates and patterns ask for, many times.
    ///
    /// # Errors
    /// As [`SpaceCurve::space_jet`].
    fn point_and_slope(&self, x: &S) -> Result<[[S; D]; 2]> {
        first_two(&self.space_jet(x, 1)?)
    }
}

impl<S: Coordinate, B: Basis<S>, const D: usize> SpaceCurve<S, D> for Curve<B, S, D> {
    fn space_jet(&self, x: &S, order: usize) -> Result<[Jet<S>; D]> {
        self.jet(x, order)
    }

    fn space_point(&self, x: &S) -> Result<[S; D]> {
        match x.centred() {
            Some(_) => Ok(self.jet(x, 0)?.map(|jet| jet.value().clone())),
            None => self.point(x),
        }
    }

    fn point_and_slope(&self, x: &S) -> Result<[[S; D]; 2]> {
        if x.centred().is_some() {
            return first_two(&self.jet(x, 1)?);
        }
        let row = self.basis().row(self.degree(), x)?;
        Ok([blended(&row, self.points())?, self.slope(x)?])
    }
}

impl<S: Coordinate, B: Basis<S>, const D: usize> SpaceCurve<S, D> for RationalCurve<B, S, D> {
    fn space_jet(&self, x: &S, order: usize) -> Result<[Jet<S>; D]> {
        self.jet(x, order)
    }
}

/// Value and first derivative; refuses series that are shorter, as a curve of somebody else may give them.
pub(crate) fn first_two<S: Coordinate, const D: usize>(jets: &[Jet<S>; D]) -> Result<[[S; D]; 2]> {
    let mut short = false;
    let slopes = jets.each_ref().map(|jet| {
        let slope = jet.coefficients().get(1);
        short |= slope.is_none();
        slope.unwrap_or(jet.value()).clone()
    });
    if short {
        return Err(too_short(jets));
    }
    Ok([jets.each_ref().map(|jet| jet.value().clone()), slopes])
}

pub(crate) fn too_short<S, const D: usize>(jets: &[Jet<S>; D]) -> GeometryError {
    let orders = jets.each_ref().map(Jet::order);
    GeometryError::LengthMismatch {
        what: "Taylor coefficients of a rail",
        index: 0,
        expected: 2,
        given: orders.into_iter().min().map_or(0, |order| order + 1),
    }
}
