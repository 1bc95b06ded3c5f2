//! Surfaces: one trait for evaluation, the tensor product, and the engineering surfaces of
//! gbt-surfaces Sect. 3 as constructors.

mod engineering;
mod kinds;
mod net;
mod part;
mod partials;
mod principal;
mod rotation;
mod ruled;
mod tensor;

pub use kinds::{EndKinds, RailEnd, RailKind, RulingEnd};
pub use net::{BezierNet, CurvatureProof, CurvedPlace};
pub use part::PatchPart;
pub use partials::{Forms, Partials};
pub use principal::Principal;
pub use rotation::{HalfTurn, RotationSurface, rotation_parameter};
pub use ruled::{Rails, RuledSurface, partials_between};
pub use tensor::TensorSurface;

use crate::coordinate::Coordinate;
use crate::error::Result;

/// A parametric surface over the unit square.
pub trait Surface<S: Coordinate> {
    /// All partial derivatives of total order up to `order` at `(u, v)`.
    ///
    /// # Errors
    /// [`GeometryError`](crate::GeometryError) where the surface has no point or derivative there.
    fn partials(&self, u: &S, v: &S, order: usize) -> Result<Partials<S>>;

    /// The point at `(u, v)`.
    ///
    /// # Errors
    /// As [`Surface::partials`].
    fn point(&self, u: &S, v: &S) -> Result<[S; 3]> {
        Ok(self.partials(u, v, 0)?.point().clone())
    }

    /// First and second fundamental form at `(u, v)`, before any square root.
    ///
    /// # Errors
    /// As [`Surface::partials`].
    fn forms(&self, u: &S, v: &S) -> Result<Forms<S>> {
        Ok(Forms::from_partials(&self.partials(u, v, 2)?))
    }

    /// The Gaussian curvature at `(u, v)`; needs no square root, so it is exact on exact scalars.
    ///
    /// # Errors
    /// [`GeometryError::Degenerate`](crate::GeometryError::Degenerate) where the surface is not regular.
    fn gaussian_curvature(&self, u: &S, v: &S) -> Result<S> {
        self.forms(u, v)?.gaussian()
    }
}
