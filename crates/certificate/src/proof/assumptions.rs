//! The assumptions of a proof: the hypotheses as constraints, the symbols that equations eliminated, and the
//! remaining conditions.

use crate::proof::Proof;
use crate::ratio::{Constraint, Ratio};
use crate::sign::Sign;
use crate::symbol::Symbol;
use crate::text;
use serde::Serialize;
use torse_numbers::Rational;

/// A proof on the domain of a claim, with eliminated symbols replaced by their values.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Assumptions<P> {
    /// The symbols that equations determine, in the order of their elimination.
    pub eliminated: Vec<Elimination<P>>,
    /// The hypotheses that were not used to eliminate a symbol, and the declared ranges of eliminated symbols.
    pub constraints: Vec<Constraint<P>>,
    /// The proof.
    pub proof: Proof<P>,
    /// Polynomials that must not vanish, and of which neither the hypotheses nor the domain ensure that they do not.
    pub conditions: Vec<P>,
    /// Polynomials that never vanish on the declared sets, by their signs, without any hypothesis.
    pub nonzero: Vec<Sign<P>>,
    /// Polynomials that never vanish under all hypotheses, by their signs, after eliminated symbols are replaced. No
    /// elimination may depend on these.
    pub apart: Vec<Sign<P>>,
    /// Additional results about the ranges of parameters.
    pub ranges: Vec<Sharpness<P>>,
}

/// Symbols that are determined together by equations.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Elimination<P> {
    /// The symbols with their values, in terms of symbols that were not eliminated at that time.
    pub values: Vec<Determined<P>>,
    /// The equations, and why they determine the symbols.
    pub by: Determining<P>,
}

/// A symbol with the value that equations determine.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Determined<P> {
    /// The symbol.
    pub symbol: Symbol,
    /// The value.
    pub value: Ratio<P>,
}

/// How equations determine symbols.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Determining<P> {
    /// An assumed equation that is linear in a single symbol.
    Assumed {
        /// The factors of its coefficient whose being nonzero follows from no number, hypothesis or condition of the
        /// proof, but from their signs before the elimination.
        nonzero: Vec<Signed<P>>,
    },
    /// As many `given` equations as symbols, linear in the symbols, with a nonzero determinant.
    Given {
        /// The positions of these equations among all entries of the given equations.
        places: Vec<usize>,
        /// Factors of the determinant, as for an assumed equation.
        nonzero: Vec<Signed<P>>,
    },
    /// The symbol is a root, and the square of the value is its radicand. The product of numerator and denominator of
    /// the value is nonnegative, so the value is the root and not its negative.
    Root(Box<Signed<P>>),
    /// The same, where the square is the radicand but for multiples of equations.
    RootAlong(Box<RootAlong<P>>),
    /// The symbol is an arc, and the value is an angle with its tangent or sine. By these signs the value lies where the arc does:
    /// those of the gaps to both ends of its set; or of the gaps to `-3 pi/2` and `3 pi/2`, and of the cosine.
    Arc(Vec<Signed<P>>),
}

/// Why a root has its value where equations hold.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct RootAlong<P> {
    /// The sign of the value, with the constraints.
    pub root: Signed<P>,
    /// Multiples of equations, which with the square of the value make the radicand.
    pub multiples: Vec<EquationMultiple<P>>,
}

/// A multiple of an equation.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct EquationMultiple<P> {
    /// The place of the equation among the constraints; its numerator is what is zero.
    pub equation: usize,
    /// What it is multiplied with.
    pub multiple: P,
}

/// A sign under the assumptions that were available before an elimination.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Signed<P> {
    /// The sign.
    pub sign: Sign<P>,
    /// The constraints to which the sign refers by position.
    pub constraints: Vec<Constraint<P>>,
}

/// Whether the range of a parameter is the largest possible.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Sharpness<P> {
    /// Slightly beyond an end of the range the statement fails at a point.
    Fails {
        /// The parameter.
        name: String,
        /// The distance beyond the end.
        #[serde(serialize_with = "text::number")]
        by: Rational,
        /// The value of the parameter there.
        #[serde(serialize_with = "text::number")]
        at: Rational,
        /// The other coordinates of the point.
        others: Vec<(String, Ratio<P>)>,
    },
    /// The statement is also proved slightly beyond the range.
    Wider {
        /// The parameter.
        name: String,
        /// The new end of the range.
        #[serde(serialize_with = "text::number")]
        to: Rational,
    },
}

impl<P> Assumptions<P> {
    /// Converts every polynomial.
    pub fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Assumptions<Q> {
        Assumptions {
            eliminated: self.eliminated.iter().map(|e| e.map(change)).collect(),
            constraints: self.constraints.iter().map(|c| c.map(change)).collect(),
            proof: self.proof.map(change),
            conditions: self.conditions.iter().map(change).collect(),
            nonzero: self.nonzero.iter().map(|sign| sign.map(change)).collect(),
            apart: self.apart.iter().map(|sign| sign.map(change)).collect(),
            ranges: self.ranges.iter().map(|range| range.map(change)).collect(),
        }
    }
}

impl<P> Elimination<P> {
    fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Elimination<Q> {
        let value = |own: &Determined<P>| Determined {
            symbol: own.symbol.clone(),
            value: own.value.map(change),
        };
        let signed = |own: &Signed<P>| Signed {
            sign: own.sign.map(change),
            constraints: own.constraints.iter().map(|c| c.map(change)).collect(),
        };
        Elimination {
            values: self.values.iter().map(value).collect(),
            by: match &self.by {
                Determining::Assumed { nonzero } => Determining::Assumed {
                    nonzero: nonzero.iter().map(signed).collect(),
                },
                Determining::Given { places, nonzero } => Determining::Given {
                    places: places.clone(),
                    nonzero: nonzero.iter().map(signed).collect(),
                },
                Determining::Root(own) => Determining::Root(Box::new(signed(own))),
                Determining::Arc(signs) => Determining::Arc(signs.iter().map(signed).collect()),
                Determining::RootAlong(own) => {
                    let multiples = own.multiples.iter().map(|own| EquationMultiple {
                        equation: own.equation,
                        multiple: change(&own.multiple),
                    });
                    Determining::RootAlong(Box::new(RootAlong {
                        root: signed(&own.root),
                        multiples: multiples.collect(),
                    }))
                }
            },
        }
    }
}

impl<P> Sharpness<P> {
    /// Converts every polynomial.
    pub fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Sharpness<Q> {
        match self {
            Self::Fails {
                name,
                by,
                at,
                others,
            } => Sharpness::Fails {
                name: name.clone(),
                by: by.clone(),
                at: at.clone(),
                others: others
                    .iter()
                    .map(|(text, value)| (text.clone(), value.map(change)))
                    .collect(),
            },
            Self::Wider { name, to } => Sharpness::Wider {
                name: name.clone(),
                to: to.clone(),
            },
        }
    }
}
