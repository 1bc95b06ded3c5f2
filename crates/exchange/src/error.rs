//! Why a file cannot be written.

use crate::read::error::ReadError;
use std::path::PathBuf;
use torse_geometry::GeometryError;

/// The result of making or writing a file.
pub type Result<T, E = ExchangeError> = std::result::Result<T, E>;

/// What is wrong with the data of a file, or with its writing.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ExchangeError {
    /// The geometry itself refuses.
    #[error(transparent)]
    Geometry(#[from] GeometryError),
    /// A number is NaN or infinite.
    #[error("{what} {index}: {value} is not a finite number")]
    NotFinite {
        /// What the number belongs to, for instance "vertex".
        what: &'static str,
        /// The index of the vertex, path or text.
        index: usize,
        /// The number.
        value: f64,
    },
    /// A number is too large for the single precision of the format.
    #[error("vertex {index}: {value} does not fit single precision")]
    SinglePrecision {
        /// The index of the vertex.
        index: usize,
        /// The number.
        value: f64,
    },
    /// There is nothing to write: formats differ in what they make of an empty list.
    #[error("nothing to write: no {what}")]
    Empty {
        /// What is missing.
        what: &'static str,
    },
    /// A list has another length than the construction needs.
    #[error("{what}: {given} given, {expected} needed")]
    Length {
        /// What the list holds.
        what: &'static str,
        /// How many are needed.
        expected: usize,
        /// How many were given.
        given: usize,
    },
    /// A triangle names a vertex that does not exist.
    #[error("triangle {triangle}: there is no vertex {index}")]
    NoVertex {
        /// The index of the triangle.
        triangle: usize,
        /// The vertex it names.
        index: u32,
    },
    /// A number lies outside the range that the construction admits.
    #[error("{name} = {value} is outside {range}")]
    OutOfRange {
        /// The name of the number.
        name: &'static str,
        /// Its value.
        value: f64,
        /// The admitted range in mathematical notation.
        range: &'static str,
    },
    /// More than the format, or the bound on work, admits.
    #[error("{what}: {given}, at most {most}")]
    TooMany {
        /// What there is too much of.
        what: &'static str,
        /// How many there are; the largest number where counting them overflows.
        given: usize,
        /// How many are admitted.
        most: usize,
    },
    /// The surface has no exact form of the wanted kind.
    #[error("no exact rational form: {why}")]
    NotRational {
        /// What stands against it.
        why: &'static str,
    },
    /// The demanded distance is out of reach.
    #[error("approximation: {demanded} is out of reach on [{from}, {to}]")]
    NotReached {
        /// The demanded distance.
        demanded: f64,
        /// Where the parameter interval ends that cannot be divided further.
        from: f64,
        /// Its other end.
        to: f64,
    },
    /// A text has a character that the format cannot hold.
    #[error("text {text:?} has a control character")]
    BadText {
        /// The text.
        text: String,
    },
    /// A file is not of the expected form.
    #[error("line {line}: {what}")]
    Unreadable {
        /// The line, counted from one.
        line: usize,
        /// What is wrong there.
        what: &'static str,
    },
    /// A file of another program cannot be read.
    #[error(transparent)]
    Read(#[from] ReadError),
    /// The operating system refuses.
    #[error("cannot write {}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
}
