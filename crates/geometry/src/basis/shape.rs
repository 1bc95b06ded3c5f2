//! A basis chosen when the program runs.

use super::{Basis, Bernstein, Gbt};
use crate::coordinate::Coordinate;
use crate::error::Result;
use torse_algebra::{ExactError, Jet};

/// One of the families of this library, so that curves of different kinds have one type.
///
/// ```
/// use torse_geometry::basis::BasisShape;
/// use torse_geometry::{Basis, Gbt};
/// let shapes = [BasisShape::Bernstein, BasisShape::gbt(0.5, -0.25)?];
/// let rows = shapes.map(|shape| shape.row(3, &0.3).unwrap());
/// assert_eq!(rows[1], Gbt::new(0.5, -0.25)?.row(3, &0.3)?);
/// assert!(rows.iter().all(|row| (row.iter().sum::<f64>() - 1.0).abs() < 1e-15));
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BasisShape<S> {
    /// The Bernstein polynomials: Bezier curves.
    Bernstein,
    /// Generalized blended trigonometric functions with two shape parameters.
    Gbt(Gbt<S>),
}

impl<S: Coordinate> BasisShape<S> {
    /// The family with these shape parameters, both in [-1, 1].
    ///
    /// # Errors
    /// As [`Gbt::new`].
    pub fn gbt(mu: S, nu: S) -> Result<Self> {
        Gbt::new(mu, nu).map(Self::Gbt)
    }
}

impl<S> From<Bernstein> for BasisShape<S> {
    fn from(_: Bernstein) -> Self {
        Self::Bernstein
    }
}

impl<S> From<Gbt<S>> for BasisShape<S> {
    fn from(basis: Gbt<S>) -> Self {
        Self::Gbt(basis)
    }
}

impl<S: Coordinate> Basis<S> for BasisShape<S> {
    fn seeds(&self, x: &S) -> Result<[S; 3], ExactError> {
        match self {
            Self::Bernstein => Bernstein.seeds(x),
            Self::Gbt(basis) => basis.seeds(x),
        }
    }

    #[inline(always)]
    fn seed_columns(&self, xs: &[S], columns: [&mut [S]; 3]) -> Result<(), ExactError> {
        match self {
            Self::Bernstein => Bernstein.seed_columns(xs, columns),
            Self::Gbt(basis) => basis.seed_columns(xs, columns),
        }
    }

    #[inline(always)]
    fn seed_and_slope_columns(
        &self,
        xs: &[S],
        columns: [&mut [S]; 3],
        slopes: [&mut [S]; 3],
    ) -> Result<()> {
        match self {
            Self::Bernstein => Bernstein.seed_and_slope_columns(xs, columns, slopes),
            Self::Gbt(basis) => basis.seed_and_slope_columns(xs, columns, slopes),
        }
    }

    fn seed_slopes(&self, x: &S) -> Result<[S; 3]> {
        match self {
            Self::Bernstein => Bernstein.seed_slopes(x),
            Self::Gbt(basis) => basis.seed_slopes(x),
        }
    }

    fn seed_jets(&self, x: &S, order: usize) -> Result<[Jet<S>; 3], ExactError> {
        match self {
            Self::Bernstein => Bernstein.seed_jets(x, order),
            Self::Gbt(basis) => basis.seed_jets(x, order),
        }
    }

    fn is_bernstein(&self) -> bool {
        matches!(self, Self::Bernstein)
    }

    fn reversed(&self) -> Self {
        match self {
            Self::Bernstein => Self::Bernstein,
            Self::Gbt(basis) => Self::Gbt(Basis::<S>::reversed(basis)),
        }
    }
}
