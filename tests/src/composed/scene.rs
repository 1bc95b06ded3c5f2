//! What the names of a composed statement mean, and points of its domain.

use super::statement::Statement;
use super::term::Part;
use super::value::Evaluator;
use crate::random::seed::Stream;
use std::collections::BTreeMap;

/// A declared interval: what is written, and some of its numbers, ends and zeros first.
#[derive(Debug)]
pub struct Range {
    /// What stands after the name.
    pub written: &'static str,
    numbers: &'static [f64],
    low: f64,
    high: f64,
}

/// The intervals that occur.
pub static RANGES: [Range; 6] = [
    Range {
        written: "{}",
        numbers: &[
            0.0,
            1.0,
            -1.0,
            2.0,
            std::f64::consts::SQRT_2,
            0.5,
            -0.75,
            1.3125,
            -2.1875,
            0.8125,
        ],
        low: f64::NEG_INFINITY,
        high: f64::INFINITY,
    },
    Range {
        written: "{ in = '[0, 1]' }",
        numbers: &[0.0, 1.0, 0.5, 0.25, 0.8125, 0.3125],
        low: 0.0,
        high: 1.0,
    },
    Range {
        written: "{ in = '[0, inf)' }",
        numbers: &[0.0, 1.0, 2.0, 0.5, 1.6875, 0.3125],
        low: 0.0,
        high: f64::INFINITY,
    },
    Range {
        written: "{ in = '[1/4, inf)' }",
        numbers: &[0.25, 1.0, 2.0, 0.5, 1.6875, 0.8125],
        low: 0.25,
        high: f64::INFINITY,
    },
    Range {
        written: "{ in = '[-1, 2]' }",
        numbers: &[-1.0, 0.0, 2.0, 1.0, 0.5, -0.3125, 1.1875],
        low: -1.0,
        high: 2.0,
    },
    Range {
        written: "{ in = '[1/2, 3/2]' }",
        numbers: &[0.5, 1.5, 1.0, 0.8125, 1.1875],
        low: 0.5,
        high: 1.5,
    },
];

/// A named formula with parameters.
#[derive(Debug, Clone)]
pub struct Definition {
    /// The name.
    pub name: String,
    /// Its parameters.
    pub parameters: Vec<String>,
    /// What it is.
    pub body: Part,
}

/// A basis by seeds and step.
#[derive(Debug, Clone)]
pub struct Family {
    /// The name.
    pub name: String,
    /// The variable, then the shape parameters.
    pub variables: Vec<String>,
    /// The functions of the lowest degree.
    pub seeds: Vec<Part>,
    /// The two factors.
    pub step: [Part; 2],
}

impl Family {
    /// The degree of the seeds.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.seeds.len() - 1
    }
}

/// A hypothesis, and how a point is made that satisfies it: one of these symbols gets a value.
#[derive(Debug, Clone)]
pub struct Hypothesis {
    /// What is assumed.
    pub statement: Statement,
    /// Symbols with the value that each may get.
    pub solved: Vec<(String, Part)>,
    /// The unknown, if it stands in `given`.
    pub unknown: Option<String>,
}

/// Everything that is declared.
#[derive(Debug, Clone, Default)]
pub struct Scene {
    /// Real numbers with their ranges.
    pub reals: Vec<(String, &'static Range)>,
    /// Integers with least and greatest value, and whether the greatest is declared.
    pub integers: Vec<(String, i64, i64, bool)>,
    /// Smooth functions.
    pub functions: Vec<String>,
    /// Families of numbers with indices from 0 to an integer symbol.
    pub families: Vec<(String, String)>,
    /// Definitions, none of which uses a later one.
    pub definitions: Vec<Definition>,
    /// Bases.
    pub bases: Vec<Family>,
    /// Hypotheses.
    pub hypotheses: Vec<Hypothesis>,
}

/// A smooth function: `c_0 + c_1 t + ... + a exp(b t)`.
#[derive(Debug, Clone)]
pub struct Smooth {
    polynomial: Vec<f64>,
    factor: f64,
    rate: f64,
}

impl Smooth {
    /// The k-th derivative at t.
    #[must_use]
    pub fn at(&self, k: usize, t: f64) -> f64 {
        let polynomial = self.polynomial.iter().enumerate().skip(k).rev();
        let polynomial = polynomial.fold(0.0, |sum, (n, c)| {
            let falling = ((n + 1 - k)..=n).map(|j| j as f64).product::<f64>();
            sum * t + c * falling
        });
        let power = i32::try_from(k).map_or(0.0, |k| self.rate.powi(k));
        polynomial + self.factor * power * (self.rate * t).exp()
    }
}

/// Values of all that is declared.
#[derive(Debug, Clone, Default)]
pub struct Point {
    /// Numbers and integers by name.
    pub numbers: BTreeMap<String, f64>,
    /// Functions by name.
    pub functions: BTreeMap<String, Smooth>,
    /// Members of families.
    pub members: BTreeMap<(String, i64), f64>,
}

impl Scene {
    /// What a name of a definition stands for.
    #[must_use]
    pub fn definition(&self, name: &str) -> Option<&Definition> {
        self.definitions.iter().find(|d| d.name == name)
    }

    /// A basis.
    #[must_use]
    pub fn basis(&self, name: &str) -> Option<&Family> {
        self.bases.iter().find(|b| b.name == name)
    }

    /// Whether a name is that of a declared number.
    #[must_use]
    pub fn declares(&self, name: &str) -> bool {
        self.reals.iter().any(|(own, _)| own == name)
            || self.integers.iter().any(|(own, ..)| own == name)
    }

    /// A point of the domain. Every second is degenerate: ends, zeros, equal numbers.
    pub fn point(&self, stream: &mut Stream) -> Option<Point> {
        let degenerate = stream.once_in(2);
        let mut point = Point::default();
        let mut before = 0.0;
        for (name, range) in &self.reals {
            let drawn = match (degenerate, stream.below(4)) {
                (true, 0) if (range.low..=range.high).contains(&before) => before,
                (true, _) => stream.pick(&range.numbers[..range.numbers.len().min(5)]),
                (false, _) => stream.pick(range.numbers) * (1.0 - stream.below(5) as f64 / 64.0),
            };
            before = drawn;
            point.numbers.insert(name.clone(), drawn);
        }
        for (name, low, high, _) in &self.integers {
            let drawn = stream.integer(i128::from(*low), i128::from(*high));
            point.numbers.insert(name.clone(), drawn as f64);
        }
        for name in &self.functions {
            let flat = degenerate && stream.once_in(2);
            let mut coefficient = || match flat && stream.once_in(2) {
                true => 0.0,
                false => stream.integer(-8, 8) as f64 / 4.0,
            };
            let polynomial = (0..6).map(|_| coefficient()).collect();
            let (factor, rate) = (coefficient(), coefficient() / 2.0);
            let smooth = Smooth {
                polynomial,
                factor,
                rate,
            };
            point.functions.insert(name.clone(), smooth);
        }
        for (name, high) in &self.families {
            for index in 0..=point.numbers.get(high).map_or(0, |m| *m as i64) {
                let value = stream.integer(-9, 9) as f64 / 4.0;
                point.members.insert((name.clone(), index), value);
            }
        }
        for hypothesis in &self.hypotheses {
            let solved = &hypothesis.solved;
            if let Some((name, value)) = solved.get(stream.below(solved.len())) {
                let value = Evaluator::new(self, &point).term(value);
                if let Some(value) = value {
                    point.numbers.insert(name.clone(), value);
                }
            }
        }
        let evaluator = Evaluator::new(self, &point);
        let inside = |(name, range): &(String, &Range)| {
            let value = point.numbers.get(name);
            value.is_some_and(|x| (range.low..=range.high).contains(x))
        };
        let satisfied = |h: &Hypothesis| evaluator.statement(&h.statement) == Some(true);
        let found = self.reals.iter().all(inside) && self.hypotheses.iter().all(satisfied);
        found.then_some(point)
    }
}
