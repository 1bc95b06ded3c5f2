//! A part of a ruled patch: the rulings of a parameter interval.

use super::{EndKinds, Partials, Rails, Surface, partials_between};
use crate::coordinate::{Coordinate, check_finite, is_zero};
use crate::error::{GeometryError, Result};
use crate::vector::scale;
use torse_algebra::Jet;

/// The rulings of another patch from `from` to `to`, with a parameter of their own in [0, 1].
///
/// ```
/// use torse_geometry::surface::PatchPart;
/// use torse_geometry::{Bernstein, Curve, Rails, RuledSurface};
/// let rail = |z: f64| Curve::new(Bernstein, vec![[0.0, 0.0, z], [1.0, 2.0, z], [4.0, 0.0, z]]);
/// let whole = RuledSurface::new(rail(0.0)?, rail(3.0)?);
/// let part = PatchPart::new(whole.clone(), 0.25, 0.75)?;
/// assert_eq!(part.ruling_ends(&0.5)?, whole.ruling_ends(&0.5)?);
/// assert_eq!(part.ruling_ends(&0.0)?, whole.ruling_ends(&0.25)?);
/// assert!(PatchPart::new(whole, 0.75, 0.25).is_err());
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct PatchPart<P, S> {
    pub(crate) whole: P,
    pub(crate) range: [S; 2],
}

impl<P, S: Coordinate> PatchPart<P, S> {
    /// The part between these parameters of the whole.
    ///
    /// # Errors
    /// [`GeometryError::NotFinite`], and [`GeometryError::OutOfRange`] unless `0 <= from < to <= 1`.
    pub fn new(whole: P, from: S, to: S) -> Result<Self> {
        let range = [from, to];
        check_finite("part of a patch", &range)?;
        let [low, high] = range.each_ref().map(Coordinate::approximate);
        for (name, value, inside) in [
            ("start of the part", low, (0.0..1.0).contains(&low)),
            ("end of the part", high, high > low && high <= 1.0),
        ] {
            if !inside {
                let range = "0 <= start < end <= 1";
                return Err(GeometryError::OutOfRange { name, value, range });
            }
        }
        Ok(Self { whole, range })
    }

    /// The patch that it is a part of.
    #[must_use]
    pub fn whole(&self) -> &P {
        &self.whole
    }

    /// The parameters of the first and the last ruling.
    #[must_use]
    pub fn range(&self) -> &[S; 2] {
        &self.range
    }

    fn width(&self) -> S {
        self.range[1].clone() - self.range[0].clone()
    }

    fn at(&self, x: &S) -> S {
        self.range[0].clone() + self.width() * x.clone()
    }
}

impl<S: Coordinate, P: Rails<S>> Rails<S> for PatchPart<P, S> {
    fn rail_jets(&self, x: &S, order: usize) -> Result<[[Jet<S>; 3]; 2]> {
        let jets = self.whole.rail_jets(&self.at(x), order)?;
        let width = self.width();
        // Of f(a + w x) the n-th coefficient is that of f times w^n.
        let slower = |jet: Jet<S>| {
            let mut power = width.one();
            let scaled = jet.coefficients().iter().skip(1).map(|c| {
                power = power.clone() * width.clone();
                c.clone() * power.clone()
            });
            Jet::from_coefficients(jet.value().clone(), scaled.collect::<Vec<_>>())
        };
        Ok(jets.map(|rail| rail.map(slower)))
    }

    fn ends_and_slopes(&self, x: &S) -> Result<[[[S; 3]; 2]; 2]> {
        let rails = self.whole.ends_and_slopes(&self.at(x))?;
        Ok(rails.map(|[end, slope]| [end, scale(&self.width(), &slope)]))
    }

    fn ruling_ends(&self, x: &S) -> Result<[[S; 3]; 2]> {
        self.whole.ruling_ends(&self.at(x))
    }

    fn is_developable_by_construction(&self) -> bool {
        self.whole.is_developable_by_construction()
    }

    fn end_kinds(&self) -> EndKinds {
        let [from, to] = &self.range;
        let kept = [is_zero(from), is_zero(&(to.clone() - to.one()))];
        self.whole.end_kinds().part(kept)
    }
}

impl<S: Coordinate, P: Rails<S>> Surface<S> for PatchPart<P, S> {
    fn partials(&self, u: &S, v: &S, order: usize) -> Result<Partials<S>> {
        partials_between(self, u, v, order)
    }
}
