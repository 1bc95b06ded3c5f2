//! Ruled surfaces between two rails.

use super::{EndKinds, Partials, Surface, TensorSurface};
use crate::basis::{Basis, Bernstein};
use crate::coordinate::Coordinate;
use crate::curve::{Curve, SpaceCurve, derivatives_of, first_two};
use crate::error::{GeometryError, Result};
use crate::vector::{lerp, sub};
use torse_algebra::Jet;

/// Two rails `P, Q` with a common parameter; the surface between them is
/// `T(u, v) = (1 - v) P(u) + v Q(u)`; [`partials_between`] makes a [`Surface`] of it.
pub trait Rails<S: Coordinate>: Sync {
    /// The Taylor series of both rails at `x`.
    ///
    /// # Errors
    /// [`GeometryError`] where a rail has no point or derivative.
    fn rail_jets(&self, x: &S, order: usize) -> Result<[[Jet<S>; 3]; 2]>;

    /// The end points `[P(x), Q(x)]` of the ruling at `x`.
    ///
    /// # Errors
    /// As [`Rails::rail_jets`].
    fn ruling_ends(&self, x: &S) -> Result<[[S; 3]; 2]> {
        let rails = self.rail_jets(x, 0)?;
        Ok(rails.map(|rail| rail.map(|s| s.value().clone())))
    }

    /// The points `P(x)` and `Q(x)` of the two rails, each with its first derivative.
    ///
    /// # Errors
    /// As [`Rails::rail_jets`]; [`GeometryError::LengthMismatch`] where a series is too short.
    fn ends_and_slopes(&self, x: &S) -> Result<[[[S; 3]; 2]; 2]> {
        let [p, q] = self.rail_jets(x, 1)?;
        Ok([first_two(&p)?, first_two(&q)?])
    }

    /// Whether one plane touches the surface along each ruling by the way it is made, so that
    /// `det(P', Q', Q - P)` vanishes identically. Other developables have to be measured, or proved.
    fn is_developable_by_construction(&self) -> bool {
        false
    }

    /// What is special about the rails and about the first and the last ruling, as far as the control data tell:
    /// nothing, where a patch does not say.
    fn end_kinds(&self) -> EndKinds {
        EndKinds::default()
    }
}

/// The partial derivatives of the surface between two rails, for implementing [`Surface`].
///
/// # Errors
/// As [`Rails::rail_jets`].
pub fn partials_between<S: Coordinate>(
    rails: &(impl Rails<S> + ?Sized),
    u: &S,
    v: &S,
    order: usize,
) -> Result<Partials<S>> {
    let [p, q] = rails.rail_jets(u, order)?;
    let (p, q) = (derivatives_of(&p, order)?, derivatives_of(&q, order)?);
    let at = |rail: &[[S; 3]], i: usize| -> [S; 3] {
        rail.get(i)
            .cloned()
            .unwrap_or_else(|| std::array::from_fn(|_| u.zero()))
    };
    Ok(Partials::from_fn(order, |i, j| match j {
        0 => lerp(&at(&p, i), &at(&q, i), v),
        1 => sub(&at(&q, i), &at(&p, i)),
        _ => std::array::from_fn(|_| u.zero()),
    }))
}

/// The ruled surface between two guide curves of any kind: different degrees, bases and shape
/// parameters are admitted (gbt-surfaces eq. (17) allows different shape parameters on the guide
/// curves but eq. (18) writes one tensor product; that is exact for equal ones only, see
/// [`RuledSurface::tensor`]).
///
/// ```
/// use torse_geometry::{Curve, Gbt, RuledSurface, Surface};
/// // gbt-surfaces Example 3.3; the first printed name of each list ("Q1,0", "Q0,1") is read Q0,0, Q1,0.
/// let first = [[1, 0, 4], [2, 0, 8], [4, 0, 8], [5, 0, 4], [6, 0, 8]];
/// let second = [[1, 6, 4], [2, 6, 0], [4, 6, 0], [6, 6, 4], [7, 6, 2]];
/// let points = |list: [[i32; 3]; 5]| list.map(|p| p.map(f64::from)).to_vec();
/// let p = Curve::new(Gbt::new(0.9, 0.25)?, points(first))?;
/// let q = Curve::new(Gbt::new(-0.25, -0.9)?, points(second))?;
/// let surface = RuledSurface::new(p.clone(), q.clone());
/// assert_eq!(surface.point(&0.3, &0.0)?, p.point(&0.3)?);
/// assert_eq!(surface.point(&0.3, &1.0)?, q.point(&0.3)?);
/// // The guide curves have different shape parameters: no tensor product.
/// assert!(surface.tensor().is_err());
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct RuledSurface<P, Q> {
    first: P,
    second: Q,
}

impl<P, Q> RuledSurface<P, Q> {
    /// The surface between the guide curves `first` (at `v = 0`) and `second` (at `v = 1`).
    #[must_use]
    pub fn new(first: P, second: Q) -> Self {
        Self { first, second }
    }

    /// The guide curve at `v = 0`.
    #[must_use]
    pub fn first(&self) -> &P {
        &self.first
    }

    /// The guide curve at `v = 1`.
    #[must_use]
    pub fn second(&self) -> &Q {
        &self.second
    }
}

impl<S: Coordinate, P: SpaceCurve<S>, Q: SpaceCurve<S>> Rails<S> for RuledSurface<P, Q> {
    fn rail_jets(&self, x: &S, order: usize) -> Result<[[Jet<S>; 3]; 2]> {
        Ok([
            self.first.space_jet(x, order)?,
            self.second.space_jet(x, order)?,
        ])
    }

    fn ruling_ends(&self, x: &S) -> Result<[[S; 3]; 2]> {
        Ok([self.first.space_point(x)?, self.second.space_point(x)?])
    }

    fn ends_and_slopes(&self, x: &S) -> Result<[[[S; 3]; 2]; 2]> {
        Ok([
            self.first.point_and_slope(x)?,
            self.second.point_and_slope(x)?,
        ])
    }
}

impl<S: Coordinate, P: SpaceCurve<S>, Q: SpaceCurve<S>> Surface<S> for RuledSurface<P, Q> {
    fn partials(&self, u: &S, v: &S, order: usize) -> Result<Partials<S>> {
        partials_between(self, u, v, order)
    }
}

impl<S: Coordinate, B: Basis<S> + PartialEq> RuledSurface<Curve<B, S, 3>, Curve<B, S, 3>> {
    /// The same surface as a tensor product of degree `(m, 1)` (gbt-surfaces eq. (18), Algorithm 3).
    ///
    /// # Errors
    /// [`GeometryError::LengthMismatch`] when the degrees differ, [`GeometryError::DifferentBases`] when
    /// the bases (shape parameters) differ: then the surface is no tensor product of this kind.
    pub fn tensor(&self) -> Result<TensorSurface<B, Bernstein, S>> {
        let (p, q) = (self.first.points(), self.second.points());
        if p.len() != q.len() {
            let what = "control points of a guide curve";
            return Err(GeometryError::LengthMismatch {
                what,
                index: 1,
                expected: p.len(),
                given: q.len(),
            });
        }
        if self.first.basis() != self.second.basis() {
            return Err(GeometryError::DifferentBases {
                what: "tensor form of a ruled surface",
                first: format!("{:?}", self.first.basis()),
                second: format!("{:?}", self.second.basis()),
            });
        }
        let net = p
            .iter()
            .zip(q)
            .map(|(a, b)| vec![a.clone(), b.clone()])
            .collect();
        TensorSurface::new(self.first.basis().clone(), Bernstein, net)
    }
}
