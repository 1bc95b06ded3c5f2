//! What a smooth joint demands of the next piece's start jet.

use crate::coordinate::{Coordinate, check_finite, check_positive};
use crate::curve::derivatives_of;
use crate::error::Result;
use torse_algebra::Jet;

/// A continuity condition: the next piece is, up to the order, a reparametrization of the piece
/// before and (for planes, whose coordinates are homogeneous) a multiple of it,
///
/// ```text
/// right(t) = rho(t) left(1 + phi(t)) + o(t^n),
/// phi(t) = b1 t + b2 t^2/2! + ..,   rho(t) = r0 + r1 t + r2 t^2/2! + ..
/// ```
///
/// | papers | here |
/// |---|---|
/// | C1, C2, C3 (gbt-surfaces Theorem 2); Farin-Boehm G2 (gbt-developable Theorem 3) | [`Continuity::parametric`] |
/// | G1 with factor gamma (gbt-developable Theorem 2) | [`Continuity::beta`] `[gamma]` |
/// | G2-beta with gamma, lambda (gbt-developable Theorem 4) | [`Continuity::beta`] `[gamma, lambda]` |
///
/// The factor `rho` is what the papers' "necessary and sufficient" overlooks: multiples of a plane are
/// the same plane, so [`Continuity::scaled`] gives *all* joints of this order.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Continuity<S> {
    betas: Vec<S>,
    scale: Vec<S>,
    order: usize,
}

impl<S: Coordinate> Continuity<S> {
    /// Equal derivatives up to `order`: C^order. `like` gives the scalar its context (precision).
    ///
    /// ```
    /// use torse_geometry::Continuity;
    /// let c2 = Continuity::parametric(2, &0.0);
    /// assert_eq!(c2.start_jet(&[[1.0], [2.0], [3.0]])?, [[1.0], [2.0], [3.0]]);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    #[must_use]
    pub fn parametric(order: usize, like: &S) -> Self {
        let betas = (0..order)
            .map(|n| if n == 0 { like.one() } else { like.zero() })
            .collect();
        Self {
            betas,
            scale: Vec::new(),
            order,
        }
    }

    /// Equal points (or planes) and, up to the number of betas, the beta constraints
    /// `right' = b1 left'`, `right'' = b1^2 left'' + b2 left'`, ...
    ///
    /// # Errors
    /// [`GeometryError::OutOfRange`](crate::GeometryError::OutOfRange) when `b1` (gamma) is known not
    /// to be positive: the joint would have a cusp.
    ///
    /// ```
    /// use torse_geometry::Continuity;
    /// let g2 = Continuity::beta(vec![2.0, 5.0])?;
    /// assert_eq!(g2.start_jet(&[[1.0], [10.0], [100.0]])?, [[1.0], [20.0], [450.0]]);
    /// let error = Continuity::beta(vec![-1.0]).unwrap_err();
    /// assert_eq!(error.to_string(), "gamma = -1 is outside (0, infinity)");
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn beta(betas: Vec<S>) -> Result<Self> {
        check_finite("beta value", &betas)?;
        if let Some(gamma) = betas.first() {
            check_positive("gamma", gamma)?;
        }
        Ok(Self {
            order: betas.len(),
            betas,
            scale: Vec::new(),
        })
    }

    /// The same condition up to a factor with the derivatives `scale = [rho, rho', ..]` at the joint
    /// (missing ones are zero).
    ///
    /// # Errors
    /// [`GeometryError::OutOfRange`](crate::GeometryError::OutOfRange) when `rho` is known not to be
    /// positive.
    ///
    /// ```
    /// use torse_geometry::Continuity;
    /// let joint = Continuity::parametric(1, &0.0).scaled(vec![2.0, 3.0])?;
    /// assert_eq!(joint.start_jet(&[[1.0], [10.0]])?, [[2.0], [23.0]]);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn scaled(mut self, scale: Vec<S>) -> Result<Self> {
        check_finite("scale value", &scale)?;
        if let Some(rho) = scale.first() {
            check_positive("rho", rho)?;
        }
        self.scale = scale;
        Ok(self)
    }

    /// The order of contact.
    #[must_use]
    pub fn order(&self) -> usize {
        self.order
    }

    /// The start jet of the next piece, given the end jet of the piece before (derivatives
    /// `[H, H', ..]`, at least `order + 1` of them are used when present).
    ///
    /// # Errors
    /// [`GeometryError::Exact`](crate::GeometryError::Exact) never for fields of characteristic zero.
    pub fn start_jet<const D: usize>(&self, end: &[[S; D]]) -> Result<Vec<[S; D]>> {
        transform(end, &self.betas, &self.scale, self.order + 1)
    }
}

/// The first `length` derivatives of `rho(t) left(1 + phi(t))` at 0, given those of `left` at 1; missing
/// betas are zero, an empty scale is one.
pub(super) fn transform<S: Coordinate, const D: usize>(
    end: &[[S; D]],
    betas: &[S],
    scale: &[S],
    length: usize,
) -> Result<Vec<[S; D]>> {
    let Some(like) = end.iter().flatten().next() else {
        return Ok(Vec::new());
    };
    let length = end.len().min(length);
    let taylor = |derivatives: &[S]| -> Result<Jet<S>> {
        let mut factorial = like.one();
        let mut list = vec![like.zero(); length.saturating_sub(1)];
        for (n, (slot, value)) in (1..).zip(list.iter_mut().zip(derivatives.iter().skip(1))) {
            factorial = factorial * like.natural(n);
            *slot = value.divided_by(&factorial)?;
        }
        Ok(Jet::from_coefficients(
            derivatives.first().cloned().unwrap_or_else(|| like.zero()),
            list,
        ))
    };
    let mut shift = vec![like.zero()];
    shift.extend(betas.iter().cloned());
    let shift = taylor(&shift)?;
    let factor = match scale {
        [] => shift.constant_like(like.one()),
        scale => taylor(scale)?,
    };
    let mut axes: Vec<Jet<S>> = Vec::with_capacity(D);
    for axis in 0..D {
        let values: Vec<S> = end.iter().map(|p| p[axis].clone()).collect();
        axes.push(compose(&taylor(&values)?, &shift) * factor.clone());
    }
    let Ok(axes) = <[Jet<S>; D]>::try_from(axes) else {
        return Ok(Vec::new());
    };
    derivatives_of(&axes, length.saturating_sub(1))
}

/// `f(shift(t))` for a shift without constant term, by Horner's rule.
fn compose<S: Coordinate>(f: &Jet<S>, shift: &Jet<S>) -> Jet<S> {
    let zero = shift.constant_like(f.value().zero());
    f.coefficients().iter().rev().fold(zero, |sum, c| {
        sum * shift.clone() + shift.constant_like(c.clone())
    })
}
