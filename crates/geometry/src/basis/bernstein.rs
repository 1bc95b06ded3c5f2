//! The classical Bernstein basis as a seeded family.

use super::Basis;
use crate::coordinate::Coordinate;
use torse_algebra::ExactError;

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
    fn seeds(&self, x: &S) -> Result<[S; 3], ExactError> {
        let y = x.one() - x.clone();
        let mixed = x.clone() * y.clone();
        Ok([y.clone() * y, mixed.clone() + mixed, x.clone() * x.clone()])
    }

    fn seed_series(&self, x: &S, order: usize) -> Result<[Vec<S>; 3], ExactError> {
        let [g0, g1, g2] = <Self as Basis<S>>::seeds(self, x)?;
        let (one, two) = (x.one(), x.natural(2));
        let y = one.clone() - x.clone();
        let series = |value: S, slope: S, half_second: S| {
            let mut list = vec![value, slope, half_second];
            list.resize(order.max(2) + 1, x.zero());
            list.truncate(order + 1);
            list
        };
        Ok([
            series(g0, -(two.clone() * y.clone()), one.clone()),
            series(g1, two.clone() * (y - x.clone()), -two.clone()),
            series(g2, two * x.clone(), one),
        ])
    }

    fn reversed(&self) -> Self {
        *self
    }
}
