//! The data of a proof by Wronskians: where to evaluate. The checker computes everything else itself.

use serde::{Serialize, Serializer};
use torse_numbers::Rational;

/// A proof of total positivity at several degrees.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Wronskians {
    /// The symmetry that maps the mirrored family to the family itself, if there is one.
    pub exchange: Option<Exchange>,
    /// The degrees in ascending order.
    pub degrees: Vec<AtDegree>,
}

/// A symmetry of the box of shape parameters, all of which range over [0, 1].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Exchange {
    /// Whether the two parameters are exchanged.
    pub swapped: bool,
    /// Which parameters, after the exchange, are replaced by one minus the parameter.
    pub turned: [bool; 2],
}

/// The data of one degree.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct AtDegree {
    /// The degree.
    pub degree: u8,
    /// The data on [0, 1/2].
    pub front: Half,
    /// The data of the mirrored family on [0, 1/2]; `None` if a symmetry makes it equal to the front.
    pub back: Option<Half>,
}

/// The data of one half of the interval.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Half {
    /// The sizes of the determinants that are expanded symbolically because some of their coefficients are zero.
    pub exact: Vec<u8>,
    /// The cells from 0 to 1/2.
    pub cells: Vec<Cell>,
}

/// A subinterval of the variable.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Cell {
    /// Its end; it begins at the end of the previous cell.
    #[serde(serialize_with = "as_text")]
    pub until: Rational,
    /// The number of places at which the determinants are evaluated.
    pub nodes: u16,
    /// The radius of the disc about the midpoint of the cell on which the determinants are bounded.
    #[serde(serialize_with = "as_text")]
    pub radius: Rational,
}

fn as_text<S: Serializer>(value: &Rational, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(value)
}
