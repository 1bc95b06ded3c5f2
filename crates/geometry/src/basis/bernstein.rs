//! The classical Bernstein basis as a seeded family.

use super::Basis;
use crate::coordinate::Coordinate;
use crate::error::Result;
use torse_algebra::{ExactError, Jet};

/// The Bernstein basis: seeds `(1-x)^2, 2x(1-x), x^2`.
///
/// ```
/// use torse_algebra::rational::ratio;
/// use torse_geometry::{Basis, Bernstein};
/// let third = ratio(1, 3).unwrap();
/// let row = Bernstein.row(3, &third)?;
/// assert_eq!(row, [8, 12, 6, 1].map(|n| ratio(n, 27).unwrap()));
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Bernstein;

impl<S: Coordinate> Basis<S> for Bernstein {
    #[inline(always)]
    fn seeds(&self, x: &S) -> Result<[S; 3], ExactError> {
        let y = x.one() - x.clone();
        let mixed = x.clone() * y.clone();
        Ok([y.clone() * y, mixed.clone() + mixed, x.clone() * x.clone()])
    }

    #[inline(always)]
    fn seed_slopes(&self, x: &S) -> Result<[S; 3]> {
        let (up, down) = (x.clone() + x.clone(), x.one() - x.clone());
        let down = down.clone() + down;
        Ok([-down.clone(), down - up.clone(), up])
    }

    fn seed_jets(&self, x: &S, order: usize) -> Result<[Jet<S>; 3], ExactError> {
        let t = Jet::variable(x.clone(), order);
        let u = t.constant_like(x.one()) - t.clone();
        let mixed = t.clone() * u.clone();
        Ok([u.clone() * u, mixed.clone() + mixed, t.clone() * t])
    }

    fn is_bernstein(&self) -> bool {
        true
    }

    fn reversed(&self) -> Self {
        *self
    }
}
