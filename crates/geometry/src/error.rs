//! What can be wrong with geometric input or with a result, each with the offending place and number.

use std::fmt;
use torse_algebra::ExactError;

/// The result of a geometric construction.
pub type Result<T, E = GeometryError> = std::result::Result<T, E>;

/// Where something is wrong.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// At the object as a whole.
    Whole,
    /// At this entry of a list.
    Index(usize),
    /// At this parameter.
    Parameter(f64),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Whole => Ok(()),
            Self::Index(index) => write!(f, " (entry {index})"),
            Self::Parameter(x) => write!(f, " (at {})", number(*x)),
        }
    }
}

/// Returns a count as `f64`; exact up to 2^53.
#[allow(clippy::cast_precision_loss, reason = "nobody counts beyond 2^53")]
pub(crate) fn count(n: usize) -> f64 {
    n as f64
}

/// A number as people write it: neither `0.0` for a count nor three hundred digits.
fn number(value: f64) -> String {
    if value == 0.0 || (1e-5..1e16).contains(&value.abs()) || !value.is_finite() {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}

/// Why a construction, an evaluation or a join is impossible.
///
/// Numbers are kept as f64: exact scalars rounded to nearest, balls by their middle, and NaN for a formal
/// expression that is no number.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GeometryError {
    /// The scalar cannot carry out an operation (division by zero, no exact sine).
    #[error(transparent)]
    Exact(#[from] ExactError),
    /// A number is NaN or infinite.
    #[error("{what}, entry {index}: {} is not a finite number", number(*value))]
    NotFinite {
        /// What the number belongs to, for instance "control point".
        what: &'static str,
        /// Its index there (coordinates are counted through: point index times dimension plus axis).
        index: usize,
        /// The number.
        value: f64,
    },
    /// A result left the range of f64, or has no value.
    #[error("{what} is not a finite number{at}")]
    NoValue {
        /// What was computed.
        what: &'static str,
        /// Where.
        at: Place,
    },
    /// A number lies outside the range that the construction admits.
    #[error("{name} = {} is outside {range}", number(*value))]
    OutOfRange {
        /// The name of the parameter.
        name: &'static str,
        /// Its value.
        value: f64,
        /// The admitted range in mathematical notation.
        range: &'static str,
    },
    /// A list is shorter than the construction needs.
    #[error("{what}: {given} given, at least {needed} needed")]
    TooFew {
        /// What the list holds.
        what: &'static str,
        /// How many are needed.
        needed: usize,
        /// How many were given.
        given: usize,
    },
    /// Two lists that belong together have different lengths.
    #[error("{what}: entry {index} has {given} elements, expected {expected}")]
    LengthMismatch {
        /// What was compared.
        what: &'static str,
        /// The index of the offending list.
        index: usize,
        /// The expected length.
        expected: usize,
        /// The given length.
        given: usize,
    },
    /// A weight is zero (or not positive where it must be).
    #[error("weight {index} is {}, a positive number is needed", number(*value))]
    BadWeight {
        /// The index of the weight.
        index: usize,
        /// The weight.
        value: f64,
    },
    /// Points that must differ coincide, or a vector that must not vanish is zero.
    #[error("degenerate: {what}{at}")]
    Degenerate {
        /// What collapses.
        what: &'static str,
        /// Where.
        at: Place,
    },
    /// Two objects have different bases where one is needed.
    #[error("{what}: the bases are {first} and {second}")]
    DifferentBases {
        /// What needs them to be equal.
        what: &'static str,
        /// The first basis with its shape parameters.
        first: String,
        /// The second.
        second: String,
    },
    /// Two planes are parallel or coincide where a line of intersection is needed.
    #[error("planes {first} and {second} are parallel or coincide")]
    ParallelPlanes {
        /// The index of the first plane.
        first: usize,
        /// The index of the second plane.
        second: usize,
    },
    /// All control planes pass through one line, that of the two named planes.
    #[error("all control planes pass through the line of planes {first} and {second}: no surface")]
    Pencil {
        /// The index of the first plane.
        first: usize,
        /// The index of the first plane that is not parallel to it.
        second: usize,
    },
    /// Neighbouring planes of a family have no common line at this parameter.
    #[error("the planes of the family have no ruling at x = {}: a x a' vanishes", number(*parameter))]
    NoRuling {
        /// The family parameter.
        parameter: f64,
    },
    /// Three neighbouring planes of a family have no common point at this parameter.
    #[error("no point of the edge of regression at x = {}: det(a, a', a'') vanishes", number(*parameter))]
    NoCharacteristicPoint {
        /// The family parameter.
        parameter: f64,
    },
    /// A ruling is parallel to the plane that should cut it.
    #[error("the ruling at x = {} is parallel to the cutting plane", number(*parameter))]
    RulingParallelToPlane {
        /// The family parameter.
        parameter: f64,
    },
    /// A point of a cone is not seen from the apex in the direction of the cutting plane.
    #[error("{what} {index} of the cone does not lie on the side of the apex where the plane is")]
    BehindApex {
        /// What kind of point.
        what: &'static str,
        /// Its index.
        index: usize,
    },
    /// The next control point is not determined by the joint: its coefficient vanishes.
    #[error(
        "the order-{order} condition does not determine control element {order} of degree {degree}: \
         its coefficient vanishes for {parameters}"
    )]
    SingularJoin {
        /// The order of the condition.
        order: usize,
        /// The degree of the piece to be found.
        degree: usize,
        /// The basis with its shape parameters, as text.
        parameters: String,
    },
    /// A linear system of a construction is singular.
    #[error("the linear system of {what} is singular{at}")]
    SingularSystem {
        /// Which construction.
        what: &'static str,
        /// The column without pivot, or the parameter that makes it singular.
        at: Place,
    },
    /// A numerical process did not reach the demanded accuracy within its budget.
    #[error("{what}: reached {}, demanded {}", number(*reached), number(*demanded))]
    NotConverged {
        /// Which process.
        what: &'static str,
        /// The accuracy reached.
        reached: f64,
        /// The accuracy demanded.
        demanded: f64,
    },
}
