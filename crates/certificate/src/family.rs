//! Proofs of properties of a basis family at every degree.

use crate::sign::Sign;
use serde::Serialize;

/// A basis is nonnegative because its seeds and step factors are: the step adds products of nonnegative functions, so
/// by induction the functions of every degree are nonnegative.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Nonnegative<P> {
    /// The two factors of the step, then the seeds; for a quotient its numerator, then those factors of its
    /// denominator that affect its sign.
    pub parts: Vec<Part<P>>,
}

/// A factor of the step, or a seed.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Part<P> {
    /// Whether it is a seed.
    pub is_seed: bool,
    /// The function.
    pub function: P,
    /// Why it is nonnegative; the zero function needs no proof.
    pub sign: Option<Sign<P>>,
}

/// A basis diminishes variation because the functions of each degree are a common function times powers of the
/// quotient of the step factors, with positive coefficients, where the quotient is monotone and no factor is
/// negative. So the minors of the collocation matrices are those of generalised Vandermonde matrices, and functions
/// with this property that sum to one diminish variation (Schoenberg 1930).
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Powers<P> {
    /// The two factors a, b of the step, then the seeds; all are nonnegative.
    pub parts: Vec<Part<P>>,
    /// The numerator `b'a - ba'` of the derivative of b/a, or its negative if the quotient decreases.
    pub slope: Box<Part<P>>,
}

impl<P> Part<P> {
    fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Part<Q> {
        Part {
            is_seed: self.is_seed,
            function: change(&self.function),
            sign: self.sign.as_ref().map(|sign| sign.map(change)),
        }
    }
}

impl<P> Nonnegative<P> {
    /// Converts every polynomial.
    pub fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Nonnegative<Q> {
        Nonnegative {
            parts: self.parts.iter().map(|part| part.map(change)).collect(),
        }
    }
}

impl<P> Powers<P> {
    /// Converts every polynomial.
    pub fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Powers<Q> {
        Powers {
            parts: self.parts.iter().map(|part| part.map(change)).collect(),
            slope: Box::new(self.slope.map(change)),
        }
    }
}
