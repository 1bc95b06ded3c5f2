//! The seeds of a family with shape parameters in [0, 1], and the mirrored family.

use super::certificate::Exchange;
use super::{SHAPES, Unfit};
use crate::polynomial::Polynomial;
use crate::symbol::{Angle, Symbol, Unit};
use std::sync::Arc;
use torse_core::Set;
use torse_numbers::Rational;
use torse_numbers::rational::integer;
use torse_syntax::derivation::declarations::Bound;

/// Seeds as polynomials in the variable, the sine and cosine of its quarter turn, pi, and parameters that range over
/// [0, 1].
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Seeds {
    pub(super) functions: Vec<Polynomial>,
    pub(super) variable: Arc<str>,
    pub(super) shapes: Vec<Arc<str>>,
}

/// The quarter turn of the variable.
const TURN: Angle = Angle {
    unit: Unit::QuarterTurn,
    parts: 1,
};

impl Seeds {
    /// The seeds of a family whose symbols have these sets; the range of the variable must lie in [0, 1].
    ///
    /// # Errors
    /// [`Unfit::Make`] if the family does not have the required form.
    pub fn declared<'s>(
        functions: &[Polynomial],
        variable: &str,
        set: &dyn Fn(&str) -> Option<&'s Set>,
    ) -> Result<Self, Unfit> {
        let range = |name: &str| range(set(name)?);
        let (low, high) = range(variable).ok_or(Unfit::Make("a variable without finite range"))?;
        if low < integer(0) || high > integer(1) {
            return Err(Unfit::Make("a variable outside of [0, 1]"));
        }
        Self::new(functions, variable, &range)
    }

    /// The seeds, with every other symbol mapped from its range to [0, 1].
    ///
    /// # Errors
    /// [`Unfit::Make`] for a symbol without a finite range, or more than two parameters.
    pub fn new(
        functions: &[Polynomial],
        variable: &str,
        range: &dyn Fn(&str) -> Option<(Rational, Rational)>,
    ) -> Result<Self, Unfit> {
        let mut shapes: Vec<Arc<str>> = vec![];
        for symbol in functions.iter().flat_map(Polynomial::symbols) {
            match symbol {
                Symbol::Named(name) if **name != *variable && !shapes.contains(name) => {
                    shapes.push(Arc::clone(name));
                }
                _ => {}
            }
        }
        shapes.sort();
        if shapes.len() > SHAPES {
            return Err(Unfit::Make("more shape parameters than two"));
        }
        let mut mapped = functions.to_vec();
        for name in &shapes {
            let (low, high) = range(name).ok_or(Unfit::Make("a parameter without finite range"))?;
            if low >= high {
                return Err(Unfit::Make("a parameter without a range"));
            }
            let own = Polynomial::symbol(Symbol::Named(Arc::clone(name)));
            let value = own.scaled(&(&high - &low)).plus(&Polynomial::constant(low));
            mapped = replaced(&mapped, &|symbol| {
                matches!(symbol, Symbol::Named(n) if n == name).then(|| value.clone())
            });
        }
        Ok(Self {
            functions: mapped,
            variable: variable.into(),
            shapes,
        })
    }

    /// The symbol of the variable.
    pub(super) fn x(&self) -> Symbol {
        Symbol::Named(Arc::clone(&self.variable))
    }

    /// The sine and cosine of its quarter turn.
    pub(super) fn turn(&self) -> [Symbol; 2] {
        let name = || Arc::clone(&self.variable);
        [Symbol::Sine(name(), TURN), Symbol::Cosine(name(), TURN)]
    }

    /// The mirrored family: the seeds at `1 - x`, in reverse order.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let x = self.x();
        let back = Polynomial::one().minus(&Polynomial::symbol(x.clone()));
        let [sine, cosine] = self.turn();
        let image = |symbol: &Symbol| match symbol {
            symbol if *symbol == x => Some(back.clone()),
            symbol if *symbol == sine => Some(Polynomial::symbol(cosine.clone())),
            symbol if *symbol == cosine => Some(Polynomial::symbol(sine.clone())),
            _ => None,
        };
        let mut functions = replaced(&self.functions, &image);
        functions.reverse();
        Self {
            functions,
            ..self.clone()
        }
    }

    /// The seeds after a symmetry of the parameters.
    #[must_use]
    pub fn exchanged(&self, exchange: Exchange) -> Self {
        let image = |symbol: &Symbol| {
            let place = self
                .shapes
                .iter()
                .position(|name| matches!(symbol, Symbol::Named(n) if n == name))?;
            let other = if exchange.swapped && self.shapes.len() == SHAPES {
                SHAPES - 1 - place
            } else {
                place
            };
            let value = Polynomial::symbol(Symbol::Named(self.shapes.get(other)?.clone()));
            Some(match exchange.turned.get(other) {
                Some(true) => Polynomial::one().minus(&value),
                _ => value,
            })
        };
        Self {
            functions: replaced(&self.functions, &image),
            ..self.clone()
        }
    }

    /// A symmetry of the parameters that maps the mirrored family to the family itself.
    #[must_use]
    pub fn symmetry(&self) -> Option<Exchange> {
        let mirrored = self.mirrored();
        let all = (0..8_u8).map(|n| Exchange {
            swapped: n & 1 != 0,
            turned: [n & 2 != 0, n & 4 != 0],
        });
        all.into_iter()
            .find(|exchange| self.exchanged(*exchange) == mirrored)
    }
}

/// The two ends of an interval, if both are rational.
fn range(set: &Set) -> Option<(Rational, Rational)> {
    let Set::Real(interval) = set else {
        return None;
    };
    let end = |bound: &Option<Bound>| bound.as_ref()?.value.as_rational().cloned();
    Some((end(&interval.lower)?, end(&interval.upper)?))
}

/// Replaces symbols in polynomials.
fn replaced(
    functions: &[Polynomial],
    image: &dyn Fn(&Symbol) -> Option<Polynomial>,
) -> Vec<Polynomial> {
    let one = |function: &Polynomial| {
        let mut result = Polynomial::zero();
        for (monomial, coefficient) in function.terms() {
            let mut term = Polynomial::constant(coefficient.clone());
            for (symbol, exponent) in monomial {
                let factor = image(symbol).unwrap_or_else(|| Polynomial::symbol(symbol.clone()));
                term = term.times(&factor.power(*exponent));
            }
            result.add(&term);
        }
        result
    };
    functions.iter().map(one).collect()
}
