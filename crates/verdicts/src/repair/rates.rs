//! A printed value as a function of two data, in floating point: fast refutation of changed data.
//!
//! The functions are constructed exactly and only evaluated in floating point; what passes is proved exactly
//! afterwards. Only the four operations and square roots are used, which give the same results on every machine.

use std::f64::consts::PI;
use torse_algebra::rational::to_f64;
use torse_algebra::{Fraction, Polynomial, Rational, Symbol};
use torse_prove::evaluate::value::{Statement, Value};
use torse_syntax::formula::{Connective, Relation};

/// A printed number and its value as a function of two data.
#[derive(Debug)]
pub struct Rate {
    above: Terms,
    below: Terms,
    printed: f64,
    tolerance: f64,
}

/// Coefficient and exponents of the two data.
type Terms = Vec<(f64, u16, u16)>;

/// A printed number and its value as a function of one datum: coefficients, constant first.
#[derive(Debug)]
pub struct Line {
    above: Vec<f64>,
    below: Vec<f64>,
    printed: f64,
    tolerance: f64,
}

impl Line {
    /// Whether the value may agree with the print at this datum.
    #[must_use]
    pub fn agrees(&self, at: f64) -> bool {
        let total = |terms: &[f64]| terms.iter().rev().fold(0.0, |sum, c| sum * at + c);
        // A vanishing divisor gives an infinity or a NaN: neither agrees.
        (total(&self.above) / total(&self.below) - self.printed).abs() <= self.tolerance
    }
}

/// The relative error granted to floating point.
const ROUNDING: f64 = 1e-9;

/// Returns the printed numbers of a conjunction of values, as functions of the two data; none if it states anything
/// else or depends on other symbols.
#[must_use]
pub fn rates(statement: &Statement, data: [&Symbol; 2]) -> Option<Vec<Rate>> {
    match statement {
        Statement::Join(Connective::And, a, b) => {
            let mut all = rates(a, data)?;
            all.extend(rates(b, data)?);
            Some(all)
        }
        Statement::Agrees { values, printed } => {
            let most = printed.iter().filter_map(|p| p.decimals).max().unwrap_or(0);
            // A truncated number may be off by a whole unit of its last digit, an exact integer by nothing.
            let unit = |digits: u32| match i32::try_from(digits) {
                Ok(0) => 0.0,
                digits => power(0.1, digits.unwrap_or(i32::MAX)),
            };
            let pairs = values.iter().zip(printed);
            pairs
                .map(|(value, p)| {
                    Rate::new(value, &p.value, unit(p.decimals.unwrap_or(most)), data)
                })
                .collect()
        }
        Statement::Compare {
            relation: Relation::Equal,
            left,
            right,
        } => {
            let (left, right) = (plain(left)?, plain(right)?);
            let zero = Rational::default();
            left.iter()
                .zip(right)
                .map(|(x, y)| Rate::new(&(x.clone() - y), &zero, 0.0, data))
                .collect()
        }
        _ => None,
    }
}

fn plain(value: &Value) -> Option<Vec<Fraction>> {
    let entries = value.entries();
    entries
        .into_iter()
        .map(|q| q.as_fraction().cloned())
        .collect()
}

impl Rate {
    fn new(value: &Fraction, printed: &Rational, unit: f64, data: [&Symbol; 2]) -> Option<Self> {
        let printed = to_f64(printed);
        Some(Self {
            above: terms(value.numerator(), data)?,
            below: terms(&value.denominator(), data)?,
            printed,
            tolerance: unit + ROUNDING * (1.0 + printed.abs()),
        })
    }

    /// Returns the function of the second datum for this value of the first.
    #[must_use]
    pub fn at_first(&self, first: f64) -> Line {
        let at = |terms: &Terms| {
            let mut line = vec![];
            for (coefficient, i, j) in terms {
                let j = usize::from(*j);
                line.resize(line.len().max(j + 1), 0.0);
                if let Some(slot) = line.get_mut(j) {
                    *slot += coefficient * power(first, i32::from(*i));
                }
            }
            line
        };
        Line {
            above: at(&self.above),
            below: at(&self.below),
            printed: self.printed,
            tolerance: self.tolerance,
        }
    }

    /// Whether the value depends on the data.
    #[must_use]
    pub fn varies(&self) -> bool {
        let mut terms = self.above.iter().chain(&self.below);
        terms.any(|(_, s, t)| *s > 0 || *t > 0)
    }
}

fn terms(polynomial: &Polynomial, [s, t]: [&Symbol; 2]) -> Option<Terms> {
    let mut result = vec![];
    for term in polynomial.terms() {
        let mut entry = (to_f64(&term.coefficient), 0, 0);
        for (symbol, exponent) in term.powers {
            match symbol {
                symbol if symbol == s => entry.1 = exponent,
                symbol if symbol == t => entry.2 = exponent,
                Symbol::Pi => entry.0 *= power(PI, i32::from(exponent)),
                Symbol::Root(prime) => {
                    entry.0 *= power(f64::from(*prime).sqrt(), i32::from(exponent))
                }
                _ => return None,
            }
        }
        result.push(entry);
    }
    Some(result)
}

/// Repeated multiplication: `powi` may differ between machines.
fn power(base: f64, exponent: i32) -> f64 {
    (0..exponent).fold(1.0, |product, _| product * base)
}
