//! From a patch to its flat pattern.

use super::development::{Development, Wanted};
use super::error::{PatternError, PatternResult, positive};
use super::fit::{Fitted, fit};
use super::flat::FlatPattern;
use super::flattening::Flattening;
use super::piece::Piece;
use super::source::{Enclosed, Sampled, Source};
use crate::model::ChebyshevModel;
use crate::over::Over;
use crate::surface::Rails;

/// The strain below which a patch counts as developable: a micrometre for each metre, as little as steel
/// stretches at a thousandth of its yield stress; the tangent planes at the ends of a ruling then differ by
/// less than 0.17 degrees.
pub const DEVELOPABLE_STRAIN: f64 = 1e-6;

/// The most rulings shown in a pattern.
pub const MAX_RULINGS: usize = 1 << 16;

/// The coarsest tolerance, as a share of the size of the pattern: within one as large as the pattern a line would
/// do for all of it, and nothing would be seen of how it winds.
const COARSEST: f64 = 0.01;

/// What is asked of a flat pattern.
///
/// ```
/// use torse_geometry::pattern::{PatternError, Unrolling};
/// use torse_geometry::{Bernstein, Curve, RuledSurface};
/// let rail = |points: [[f64; 3]; 2]| Curve::new(Bernstein, points.to_vec());
/// // A slightly twisted strip is refused, with the numbers,
/// let strip = RuledSurface::new(
///     rail([[0.0, 0.0, 0.0], [100.0, 0.0, 0.0]])?,
///     rail([[0.0, 10.0, 0.0], [100.0, 10.0, 5.0]])?,
/// );
/// let Err(PatternError::NotDevelopable { strain, limit, .. }) = Unrolling::within(0.01).unroll(&strip) else {
///     panic!("a twisted strip");
/// };
/// assert!(strain > 1e-4 && limit == 1e-6);
/// // unless strain is allowed; then the pattern says so, and how far other developments of it lie.
/// let flat = Unrolling::within(0.01).allow_strain(strain).unroll(&strip)?;
/// assert!(flat.is_strained() && flat.strain() == strain && flat.errors().ambiguity > 0.0);
/// // The usual one keeps the lengths of both edges.
/// assert_eq!(flat.shortened(0), Some([0.0, 0.0]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unrolling {
    tolerance: f64,
    rulings: usize,
    developable: f64,
    allowed: f64,
    flattening: Flattening,
}

impl Unrolling {
    /// Demands that the cut outline is nowhere farther than `tolerance` (a length) from the exact one, nor than a
    /// hundredth of the size of the pattern; with 33 rulings, and strain up to [`DEVELOPABLE_STRAIN`].
    #[must_use]
    pub fn within(tolerance: f64) -> Self {
        Self {
            tolerance,
            rulings: 33,
            developable: DEVELOPABLE_STRAIN,
            allowed: 0.0,
            flattening: Flattening::default(),
        }
    }

    /// The same with another tolerance.
    #[must_use]
    pub fn within_tolerance(mut self, tolerance: f64) -> Self {
        self.tolerance = tolerance;
        self
    }

    /// Shows this many rulings, both ends included: 2 at least, [`MAX_RULINGS`] at most, at equal steps of the
    /// parameter. The patch is sampled a sixth as densely
    /// at least, and wherever that does not resolve it as densely as it takes.
    #[must_use]
    pub fn rulings(mut self, count: usize) -> Self {
        self.rulings = count.clamp(2, MAX_RULINGS);
        self
    }

    /// Which development is made of a patch that is not exactly developable.
    #[must_use]
    pub fn flattening(mut self, flattening: Flattening) -> Self {
        self.flattening = flattening;
        self
    }

    /// What counts as developable: flattening changes no line by more than this share of its length.
    #[must_use]
    pub fn developable_within(mut self, strain: f64) -> Self {
        self.developable = strain;
        self
    }

    /// Flattens a patch that is not developable too, as long as no line is stretched or shortened by more than this
    /// share of its length. Such a pattern says [`FlatPattern::is_strained`].
    #[must_use]
    pub fn allow_strain(mut self, strain: f64) -> Self {
        self.allowed = strain;
        self
    }

    /// Unrolls a patch, with bounds that are proved over whole intervals ([`ChebyshevModel`]) for the exact numbers of
    /// its control data. Where the tolerance is out of their reach it is measured, as [`FlatPattern::evidence`] then
    /// says.
    ///
    /// The first rail starts at the origin, the first ruling points along the first axis, and the patch
    /// proceeds along the second axis; the side that its normal `R x (P' + Q')` points to is seen.
    ///
    /// # Errors
    /// [`PatternError::OutOfRange`] unless the tolerance is positive and the strains are in [0, 1);
    /// [`PatternError::NotFinite`], [`PatternError::NoRuling`], [`PatternError::NoTangentPlane`] where the
    /// patch is not a sheet; [`PatternError::NotDevelopable`], [`PatternError::Regression`],
    /// [`PatternError::CrossesItself`] when it cannot be cut from one;
    /// [`PatternError::NotReached`] for a tolerance out of reach of f64; [`PatternError::Geometry`] from
    /// the evaluation of the patch.
    pub fn unroll<P>(&self, patch: &P) -> PatternResult<FlatPattern>
    where
        P: Rails<f64> + Over<f64, ChebyshevModel, Object: Rails<ChebyshevModel>>,
    {
        match self.from(patch, &Enclosed::new(patch)?) {
            Err(PatternError::NotReached { .. }) => self.measured(patch),
            found => found,
        }
    }

    /// Unrolls a patch that can be evaluated at parameters alone: its rails are interpolated and looked at in finitely
    /// many, so the bounds are estimates ([`PatternEvidence::Measured`](super::PatternEvidence::Measured)).
    ///
    /// # Errors
    /// As [`Unrolling::unroll`].
    pub fn measured(&self, patch: &(impl Rails<f64> + ?Sized)) -> PatternResult<FlatPattern> {
        self.from(patch, &Sampled(patch))
    }

    fn from(
        &self,
        patch: &(impl Rails<f64> + ?Sized),
        source: &dyn Source,
    ) -> PatternResult<FlatPattern> {
        positive("tolerance", self.tolerance)?;
        for (name, value) in [
            ("strain of a developable", self.developable),
            ("allowed strain", self.allowed),
        ] {
            if !(0.0..1.0).contains(&value) {
                let range = "[0, 1)";
                return Err(PatternError::OutOfRange { name, value, range });
            }
        }
        // Half of the tolerance is for the arcs, the rest for the development.
        let wanted = Wanted {
            panels: self.rulings.div_ceil(128).max(2),
            allowed: 0.25 * self.tolerance,
            strain: self.developable.max(self.allowed),
            flattening: self.flattening,
        };
        let development = Development::new(patch, source, wanted)?;
        let tolerance = self.tolerance.min(COARSEST * development.size);
        // A rail that is a point is one in the plane, whatever rounding makes of it.
        let apexes = patch.end_kinds().apexes();
        let side = |side: usize| match apexes[side] {
            true => Ok(Fitted::point()),
            false => fit(&development, side, 0.5 * tolerance),
        };
        let (first, second) = crate::parallel::join(|| side(0), || side(1));
        let fitted = [first?, second?];
        let distance = fitted[0].distance.max(fitted[1].distance);
        #[allow(clippy::cast_precision_loss)]
        let last = (self.rulings - 1) as f64;
        #[allow(clippy::cast_precision_loss)]
        let stations = (0..self.rulings).map(|i| i as f64 / last).collect();
        let piece = Piece::new(development, fitted.map(|f| f.segments), distance, stations);
        FlatPattern::from_pieces(vec![piece], self.developable, tolerance)
    }
}

/// Unrolls a patch within `tolerance` (a length), showing `rulings` rulings: [`Unrolling`] with what is usual
/// otherwise.
///
/// # Errors
/// As [`Unrolling::unroll`].
///
/// ```
/// use torse_geometry::pattern::unroll;
/// use torse_geometry::{RuledSurface, curve::ellipse_arc};
/// // A quarter of a circular cylinder of radius 2 and height 3: a rectangle 3 x pi.
/// let ring = |z: f64| ellipse_arc(&[0.0, 0.0, z], &[2.0, 0.0, z], &[0.0, 2.0, z]);
/// let flat = unroll(&RuledSurface::new(ring(0.0)?, ring(3.0)?), 17, 1e-10)?;
/// assert_eq!(flat.outline().segments().len(), 4);
/// assert!((flat.area() - 3.0 * std::f64::consts::PI).abs() < 1e-13);
/// // The bounds are proved. A model of an arc allows for the rounding of 17 coefficients of 17 products each, 1e-13 of its
/// // size, and some twenty of these add up; of the strain it is the square.
/// assert!(flat.errors().outline < 1e-11 && flat.strain() < 1e-24, "{:?} {}", flat.errors(), flat.strain());
/// // Every ruling is bent by the same angle, and its radius is that of the cylinder.
/// let ruling = flat.rulings()[5];
/// assert!((ruling.bend.abs() - std::f64::consts::FRAC_PI_2 / 16.0).abs() < 1e-9);
/// assert!((ruling.radius - 2.0).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn unroll<P>(patch: &P, rulings: usize, tolerance: f64) -> PatternResult<FlatPattern>
where
    P: Rails<f64> + Over<f64, ChebyshevModel, Object: Rails<ChebyshevModel>>,
{
    Unrolling::within(tolerance).rulings(rulings).unroll(patch)
}
