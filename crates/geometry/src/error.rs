//! What can be wrong with geometric input, each with the offending index and value.

use torse_algebra::ExactError;

/// The result of a geometric construction.
pub type Result<T, E = GeometryError> = std::result::Result<T, E>;

/// Why a construction, an evaluation or a join is impossible.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum GeometryError {
    /// The scalar cannot carry out an operation (division by zero, no exact sine).
    #[error(transparent)]
    Exact(#[from] ExactError),
    /// A number is NaN or infinite.
    #[error("{what}, entry {index}: {value} is not a finite number")]
    NotFinite {
        /// What the number belongs to, for instance "control point".
        what: &'static str,
        /// Its index there (coordinates are counted through: point index times dimension plus axis).
        index: usize,
        /// The number as text.
        value: String,
    },
    /// A number lies outside the range that the construction admits.
    #[error("{name} = {value} is outside {range}")]
    OutOfRange {
        /// The name of the parameter.
        name: &'static str,
        /// Its value as text.
        value: String,
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
    #[error("weight {index} is {value}, a positive number is needed")]
    BadWeight {
        /// The index of the weight.
        index: usize,
        /// The weight as text.
        value: String,
    },
    /// Points that must differ coincide, or a vector that must not vanish is zero.
    #[error("degenerate: {what} (at {at})")]
    Degenerate {
        /// What collapses.
        what: &'static str,
        /// Where: an index or a parameter value as text.
        at: String,
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
    #[error("the planes of the family have no ruling at x = {parameter}: a x a' vanishes")]
    NoRuling {
        /// The family parameter as text.
        parameter: String,
    },
    /// Three neighbouring planes of a family have no common point at this parameter.
    #[error("no point of the edge of regression at x = {parameter}: det(a, a', a'') vanishes")]
    NoCharacteristicPoint {
        /// The family parameter as text.
        parameter: String,
    },
    /// A ruling is parallel to the plane that should cut it.
    #[error("the ruling at x = {parameter} is parallel to the cutting plane")]
    RulingParallelToPlane {
        /// The family parameter as text.
        parameter: String,
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
    #[error("the linear system of {what} is singular for {parameters}")]
    SingularSystem {
        /// Which construction.
        what: &'static str,
        /// The parameters that make it singular, as text.
        parameters: String,
    },
    /// A numerical process did not reach the demanded accuracy within its budget.
    #[error("{what}: reached {reached}, demanded {demanded}")]
    NotConverged {
        /// Which process.
        what: &'static str,
        /// The accuracy reached, as text.
        reached: String,
        /// The accuracy demanded, as text.
        demanded: String,
    },
}
