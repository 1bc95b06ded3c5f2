//! Counterexamples: points at which a statement fails.

use crate::enclosure::Enclosure;
use crate::polynomial::Polynomial;
use crate::ratio::Ratio;
use crate::symbol::Symbol;
use serde::Serialize;

/// The value of a symbol.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Value<P> {
    /// The symbol.
    pub symbol: Symbol,
    /// Its value, a constant.
    pub value: Ratio<P>,
}

/// A point of the domain, and how the statement fails there.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Counterexample<P> {
    /// The values of the symbols, including eliminated ones.
    pub at: Vec<Value<P>>,
    /// Values of symbols that do not affect the statement; any other values of their sets would do.
    pub others: Vec<Value<P>>,
    /// How the statement fails.
    pub failure: Failure<P>,
}

/// How a statement fails at a point.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Failure<P> {
    /// The sides of a comparison have these values.
    Sides {
        /// The kind of comparison.
        kind: Comparison,
        /// The left side, entry by entry.
        left: Vec<Ratio<P>>,
        /// The right side.
        right: Vec<Ratio<P>>,
    },
    /// Printed numbers do not agree with the values.
    Printed(Enclosure<P>),
    /// The functions of a family of this degree are dependent: this linear combination of them is zero.
    Dependent {
        /// The family.
        family: String,
        /// The degree.
        degree: u32,
        /// The coefficients.
        combination: Vec<Ratio<P>>,
    },
    /// A curve whose control values change sign once changes sign twice.
    Turning {
        /// The degree.
        degree: u32,
        /// The nonzero control values, by index.
        control: [(usize, Ratio<P>); 2],
        /// Three parameter values.
        places: [Ratio<P>; 3],
        /// The values of the curve there.
        values: [Ratio<P>; 3],
    },
    /// A curve crosses a level that its control polygon does not meet.
    Beyond {
        /// The degree.
        degree: u32,
        /// The index of the control value that is 1 while all others are 0; `None` if all are 1.
        control: Option<usize>,
        /// A parameter value, and the value of the curve there.
        low: (Ratio<P>, Ratio<P>),
        /// Another parameter value, with a greater value of the curve.
        high: (Ratio<P>, Ratio<P>),
        /// A level between the two values.
        level: Ratio<P>,
    },
}

/// The kind of comparison that fails.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Comparison {
    /// An equation.
    Equation {
        /// The entry, from 0, in which the sides differ.
        entry: usize,
        /// The number of terms of the difference in that entry.
        terms: usize,
    },
    /// A relation of order.
    Order,
    /// A seed of a basis family is not negative.
    Seed,
    /// No comparison: the point is a witness that the domain is not empty.
    Domain,
}

impl<P> Value<P> {
    /// Converts every polynomial.
    pub fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Value<Q> {
        Value {
            symbol: self.symbol.clone(),
            value: self.value.map(change),
        }
    }
}

impl<P> Counterexample<P> {
    /// Converts every polynomial.
    pub fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Counterexample<Q> {
        Counterexample {
            at: self.at.iter().map(|value| value.map(change)).collect(),
            others: self.others.iter().map(|value| value.map(change)).collect(),
            failure: self.failure.map(change),
        }
    }
}

impl<P> Failure<P> {
    /// Converts every polynomial.
    pub fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Failure<Q> {
        let all = |list: &[Ratio<P>]| list.iter().map(|ratio| ratio.map(change)).collect();
        let pair = |(a, b): &(Ratio<P>, Ratio<P>)| (a.map(change), b.map(change));
        match self {
            Self::Sides { kind, left, right } => Failure::Sides {
                kind: *kind,
                left: all(left),
                right: all(right),
            },
            Self::Printed(enclosure) => Failure::Printed(enclosure.map(change)),
            Self::Dependent {
                family,
                degree,
                combination,
            } => Failure::Dependent {
                family: family.clone(),
                degree: *degree,
                combination: all(combination),
            },
            Self::Turning {
                degree,
                control,
                places,
                values,
            } => Failure::Turning {
                degree: *degree,
                control: control.each_ref().map(|(place, c)| (*place, c.map(change))),
                places: places.each_ref().map(|x| x.map(change)),
                values: values.each_ref().map(|x| x.map(change)),
            },
            Self::Beyond {
                degree,
                control,
                low,
                high,
                level,
            } => Failure::Beyond {
                degree: *degree,
                control: *control,
                low: pair(low),
                high: pair(high),
                level: level.map(change),
            },
        }
    }
}

impl Value<Polynomial> {
    /// `x = 1/2`.
    #[must_use]
    pub fn text(&self) -> String {
        format!("{} = {}", self.symbol, self.value)
    }
}
