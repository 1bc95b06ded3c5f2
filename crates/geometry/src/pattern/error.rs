//! Why a patch has no flat pattern, with the numbers.

use crate::error::GeometryError;

/// The result of unrolling, joining or folding.
pub type PatternResult<T> = Result<T, PatternError>;

/// Why a patch cannot be unrolled, a pattern not joined or not folded. Numbers are numbers.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PatternError {
    /// The patch cannot be evaluated.
    #[error(transparent)]
    Geometry(#[from] GeometryError),
    /// A demand is out of its range.
    #[error("{name} = {value} is outside {range}")]
    OutOfRange {
        /// What was demanded.
        name: &'static str,
        /// Its value, possibly NaN.
        value: f64,
        /// The admitted range in mathematical notation.
        range: &'static str,
    },
    /// A point or a tangent of the patch is NaN or infinite.
    #[error("the patch is not finite at x = {x}")]
    NotFinite {
        /// The parameter of the ruling.
        x: f64,
    },
    /// A ruling has no length: it has no direction in the plane.
    #[error("the ruling at x = {x} has no length")]
    NoRuling {
        /// The parameter of the ruling.
        x: f64,
    },
    /// The patch has no tangent plane along a ruling, or it turns over there: both rails stand still or run
    /// along the ruling.
    #[error("the patch has no tangent plane at x = {x}")]
    NoTangentPlane {
        /// The parameter of the ruling.
        x: f64,
    },
    /// The patch is not developable: flattening it takes more strain than allowed.
    #[error(
        "not developable: flattening it takes a strain of up to {strain:.3e}, and {limit:e} is allowed; \
         near the ruling at parameter {x:.6} the tangent plane turns by up to {:.6} degrees along a ruling",
        twist.to_degrees()
    )]
    NotDevelopable {
        /// A bound of the strain: with so much allowed it is flattened.
        strain: f64,
        /// The strain allowed.
        limit: f64,
        /// A bound of the angle between the tangent planes at the ends of a ruling, in radians, on an interval of rulings.
        twist: f64,
        /// The parameter in the middle of that interval.
        x: f64,
    },
    /// The edge of regression runs inside the patch: it folds back on itself there.
    #[error(
        "the edge of regression crosses the ruling at x = {x}, v = {v}, {depth} inside the patch"
    )]
    Regression {
        /// The parameter of the ruling.
        x: f64,
        /// The place on the ruling, between 0 and 1.
        v: f64,
        /// The distance from the edge of regression to the border that it cut off, in units of length.
        depth: f64,
    },
    /// The outline of the flat pattern meets itself: the part cannot be cut from one sheet.
    #[error("the outline crosses itself near ({:.3}, {:.3})", at[0], at[1])]
    CrossesItself {
        /// A point near the crossing.
        at: [f64; 2],
        /// The two segments of the outline that meet.
        segments: [usize; 2],
    },
    /// The accuracy was not reached.
    #[error("reached {reached:e} at x = {x}, demanded {demanded:e}")]
    NotReached {
        /// The bound that was reached.
        reached: f64,
        /// The bound demanded.
        demanded: f64,
        /// Where the work was given up.
        x: f64,
    },
    /// Two patches have no end ruling in common.
    #[error("no common end ruling: the nearest ends are {distance} apart, {limit} allowed")]
    NoCommonRuling {
        /// The least distance between free end rulings.
        distance: f64,
        /// The distance allowed.
        limit: f64,
    },
    /// A list of rulings, bends or points has the wrong length.
    #[error("{what}: {given} given, {needed} needed")]
    Count {
        /// What was counted.
        what: &'static str,
        /// How many were given.
        given: usize,
        /// How many are needed.
        needed: usize,
    },
}

/// Refuses a demand that is not positive, or not finite.
pub(super) fn positive(name: &'static str, value: f64) -> PatternResult<()> {
    if value > 0.0 && value.is_finite() {
        return Ok(());
    }
    let range = "(0, infinity)";
    Err(PatternError::OutOfRange { name, value, range })
}
