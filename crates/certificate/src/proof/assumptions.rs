//! What a proof stands on: the hypotheses as constraints, the symbols that equations eliminated, and the conditions that
//! remain.

use crate::polynomial::Polynomial;
use crate::proof::Proof;
use crate::ratio::{Constraint, Ratio};
use crate::sign::Sign;
use crate::symbol::Symbol;
use crate::text;
use serde::Serialize;
use torse_numbers::Rational;

/// A proof on the domain of a claim, where eliminated symbols have their values.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Assumptions<P> {
    /// The symbols that equations determine, in the order in which they were eliminated.
    pub eliminated: Vec<Elimination<P>>,
    /// All hypotheses that eliminated nothing, and what eliminated symbols left behind: their ranges.
    pub constraints: Vec<Constraint<P>>,
    /// The proof.
    pub proof: Proof<P>,
    /// What must not vanish, and neither the hypotheses nor the domain excludes.
    pub conditions: Vec<P>,
    /// What never vanishes on the declared sets, whatever is assumed: by its sign.
    pub nonzero: Vec<Sign<P>>,
    /// What never vanishes under all assumptions, eliminated symbols replaced: by its sign. No elimination may rest on this.
    pub apart: Vec<Sign<P>>,
    /// What is known about the ranges of parameters besides.
    pub ranges: Vec<Sharpness<P>>,
}

/// Symbols that equations determine together.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Elimination<P> {
    /// The symbols with their values, in terms of those that were not eliminated then.
    pub values: Vec<Determined<P>>,
    /// Which equations, and why they determine the symbols.
    pub by: Determining<P>,
}

/// A symbol with the value that equations give it.
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
    /// An assumed equation, linear in the one symbol.
    Assumed {
        /// Of the factors of its coefficient those that differ from zero by no number, hypothesis or condition of the proof,
        /// but by their signs before the elimination.
        nonzero: Vec<Signed<P>>,
    },
    /// As many of the `given` equations: linear in the symbols, with a determinant that is not zero.
    Given {
        /// Their places among all entries of these.
        places: Vec<usize>,
        /// Factors of the determinant, as for an assumed equation.
        nonzero: Vec<Signed<P>>,
    },
    /// The symbol is a root, and the square of the value is its radicand: numerator times denominator of the value, which is
    /// not negative, make it the root and not its negative.
    Root(Box<Signed<P>>),
}

/// A sign under what was assumed before an elimination.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Signed<P> {
    /// The sign.
    pub sign: Sign<P>,
    /// The constraints that the sign names by their places.
    pub constraints: Vec<Constraint<P>>,
}

/// Whether the range of a parameter is the largest one.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Sharpness<P> {
    /// A little beyond an end the relation fails at a point.
    Fails {
        /// The parameter.
        name: String,
        /// How far beyond.
        #[serde(serialize_with = "text::number")]
        by: Rational,
        /// Its value there.
        #[serde(serialize_with = "text::number")]
        at: Rational,
        /// The other coordinates of the point.
        others: Vec<(String, Ratio<P>)>,
    },
    /// It is proved a little beyond.
    Wider {
        /// The parameter.
        name: String,
        /// Up to where.
        #[serde(serialize_with = "text::number")]
        to: Rational,
    },
}

impl<P> Assumptions<P> {
    /// The same in other polynomials.
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
            },
        }
    }
}

impl Elimination<Polynomial> {
    /// The value of a root in words; nothing for other symbols.
    pub(crate) fn step(&self) -> Option<String> {
        let (Determining::Root(_), [own]) = (&self.by, self.values.as_slice()) else {
            return None;
        };
        let (root, value) = (&own.symbol, &own.value);
        Some(format!(
            "{root} is {value}: the square is the radicand, and this is nowhere negative"
        ))
    }
}

impl<P> Sharpness<P> {
    fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Sharpness<Q> {
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

impl<P> Sharpness<P>
where
    Ratio<P>: std::fmt::Display,
{
    /// It in words.
    #[must_use]
    pub fn text(&self) -> String {
        match self {
            Self::Fails {
                name,
                by,
                at,
                others,
            } => {
                let others = others
                    .iter()
                    .map(|(text, value)| format!(", {text} = {value}"));
                let others: String = others.collect();
                format!(
                    "outside of the range of {name}, by {by}, it fails: at {name} = {at}{others}"
                )
            }
            Self::Wider { name, to } => {
                format!("the range of {name} may be widened to {to}: it is proved there too")
            }
        }
    }
}
