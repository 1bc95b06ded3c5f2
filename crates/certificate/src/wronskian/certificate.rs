//! What a proof by Wronskians carries: where to evaluate, and nothing that would have to be believed.

use serde::{Serialize, Serializer};
use torse_numbers::Rational;

/// Total positivity at several degrees.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Wronskians {
    /// How the mirrored family is the family itself, if it is.
    pub exchange: Option<Exchange>,
    /// Degree by degree, ascending.
    pub degrees: Vec<AtDegree>,
}

/// A symmetry of the box of shape parameters, each of which lives in [0, 1].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Exchange {
    /// Whether the two parameters change places.
    pub swapped: bool,
    /// Which of them, in their new places, are subtracted from one.
    pub turned: [bool; 2],
}

/// One degree.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct AtDegree {
    /// The degree.
    pub degree: u8,
    /// On [0, 1/2].
    pub front: Half,
    /// The mirrored family on [0, 1/2]; not there where an exchange makes it that of the front.
    pub back: Option<Half>,
}

/// Half of the interval.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Half {
    /// The sizes of the determinants that are multiplied out, since some coefficient is zero.
    pub exact: Vec<u8>,
    /// From 0 to 1/2.
    pub cells: Vec<Cell>,
}

/// A part of the interval of the variable.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Cell {
    /// Its end; it begins where the one before ends.
    #[serde(serialize_with = "as_text")]
    pub until: Rational,
    /// At how many places the determinants are evaluated.
    pub nodes: u16,
    /// The radius of the disc about the middle of the cell on which they are bounded.
    #[serde(serialize_with = "as_text")]
    pub radius: Rational,
}

fn as_text<S: Serializer>(value: &Rational, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(value)
}

impl Wronskians {
    /// The steps in words.
    #[must_use]
    pub fn steps(&self) -> Vec<String> {
        let cells = |half: &Half| half.cells.len();
        let step = |at: &AtDegree| {
            let front = cells(&at.front);
            let other = match &at.back {
                Some(back) => format!("{} from the other end", cells(back)),
                None => "the other half by symmetry".to_owned(),
            };
            format!(
                "degree {k}: the Wronskians of L[1], L[x], ..., L[x^r], r = 1..{k}, are positive, by their Bernstein \
                 coefficients in the shape parameters on {front} cells of x, {other}",
                k = at.degree
            )
        };
        let operator = "a curve is an operator L applied to the Bézier curve of the same control values; positive \
                        Wronskians and the orders at the ends make the functions totally positive, and they sum to one";
        let first = std::iter::once(operator.to_owned());
        first.chain(self.degrees.iter().map(step)).collect()
    }
}
