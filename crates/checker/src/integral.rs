//! Integrals of functions that are polynomials in the variable and in the sine and cosine of one fraction of it.
//!
//! An antiderivative is constructed by rules, without search, and then **differentiated**. Only if the derivative
//! equals the integrand, as quotients, is the difference of the antiderivative at the limits the integral
//! (fundamental theorem; the integrand is continuous, because its denominator does not depend on the variable). The
//! rules, with s and c for sine and cosine of the angle w x, where s has degree at most one:
//!
//! * `x^j` has the antiderivative `x^(j+1)/(j+1)`;
//! * `s c^b` has `-c^(b+1)/(w (b+1))`;
//! * `c^b` has `s c^(b-1)/(w b) + (b-1)/b C`, where C is the antiderivative of `c^(b-2)`;
//! * `x^j g` has `x^j G - j H`, where G is the antiderivative of g, and H that of `x^(j-1) G`.

use super::gap::{Unsupported, Work};
use super::quotient::{Quotient, rate};
use torse_certificate::polynomial::Polynomial;
use torse_certificate::symbol::{Angle, Symbol};
use torse_numbers::Rational;
use torse_numbers::rational::integer;

/// The largest power.
const MAX_POWER: u32 = 64;

/// The integral of a function of the variable between two limits.
pub fn between(
    function: &Quotient,
    variable: &Symbol,
    [low, high]: &[Quotient; 2],
    work: &Work,
) -> Result<Quotient, Unsupported> {
    let primitive = antiderivative(function, variable, work)?;
    if !primitive
        .derivative(variable, work)?
        .equals(function, work)?
    {
        return Err(Unsupported::Construct(
            "an integral without such an antiderivative",
        ));
    }
    let at = |end: &Quotient| {
        let value_of = |symbol: &Symbol| (symbol == variable).then(|| end.clone());
        primitive.replaced(&value_of, work)
    };
    at(high)?.minus(&at(low)?, work)
}

fn changes(p: &Polynomial, variable: &Symbol) -> bool {
    p.symbols().any(|s| s.variable() == variable.variable())
}

/// A candidate for the antiderivative.
fn antiderivative(
    function: &Quotient,
    variable: &Symbol,
    work: &Work,
) -> Result<Quotient, Unsupported> {
    if function.below.keys().any(|p| changes(p, variable)) {
        return Err(Unsupported::Construct("an integral of such a quotient"));
    }
    let mut sum = Quotient::default();
    for (monomial, coefficient) in function.above.terms() {
        work.spend(1)?;
        let (mut power, mut sine, mut cosine) = (0, 0, 0);
        let mut angle: Option<Angle> = None;
        let mut rest = Polynomial::constant(coefficient.clone());
        for (symbol, exponent) in monomial {
            let of_variable = symbol.variable() == variable.variable();
            match symbol {
                own if own == variable => power = *exponent,
                Symbol::Sine(_, own) | Symbol::Cosine(_, own) if of_variable => {
                    if angle.is_some_and(|angle| angle != *own) {
                        return Err(Unsupported::Construct("an integral with several angles"));
                    }
                    angle = Some(*own);
                    match symbol {
                        Symbol::Sine(..) => sine = *exponent,
                        _ => cosine = *exponent,
                    }
                }
                other => {
                    for _ in 0..*exponent {
                        rest = work.times(&rest, &Polynomial::symbol(other.clone()))?;
                    }
                }
            }
        }
        if power.max(sine).max(cosine) > MAX_POWER {
            return Err(Unsupported::Large);
        }
        let x = Quotient::from(Polynomial::symbol(variable.clone()));
        let part = match angle {
            None => {
                let term = x.power(power + 1, work)?;
                term.times(&fraction(1, power + 1), work)?
            }
            Some(angle) => {
                let turn = Turn::new(variable, angle);
                let term = turn.antiderivative(sine, cosine, work)?;
                match power {
                    0 => term,
                    _ => {
                        let inner = x.power(power - 1, work)?.times(&term, work)?;
                        let inner = antiderivative(&inner, variable, work)?;
                        let inner = inner.times(&fraction(power, 1), work)?;
                        let outer = x.power(power, work)?.times(&term, work)?;
                        outer.minus(&inner, work)?
                    }
                }
            }
        };
        sum = sum.plus(&part.times(&rest.into(), work)?, work)?;
    }
    let below = Quotient {
        above: Polynomial::one(),
        below: function.below.clone(),
    };
    sum.times(&below, work)
}

fn fraction(above: u32, below: u32) -> Quotient {
    let number = Rational::new(i64::from(above).into(), i64::from(below.max(1)).into());
    Quotient::number(number)
}

/// The sine and cosine of a fraction of the variable.
struct Turn {
    variable: Quotient,
    sine: Quotient,
    cosine: Quotient,
    rate: Quotient,
}

impl Turn {
    fn new(variable: &Symbol, angle: Angle) -> Self {
        let name = || std::sync::Arc::from(variable.variable().unwrap_or_default());
        let symbol = |symbol: Symbol| Quotient::from(Polynomial::symbol(symbol));
        Self {
            variable: symbol(variable.clone()),
            sine: symbol(Symbol::Sine(name(), angle)),
            cosine: symbol(Symbol::Cosine(name(), angle)),
            rate: rate(angle),
        }
    }

    /// The antiderivative of `s^a c^b`, for a up to 1.
    fn antiderivative(&self, a: u32, b: u32, work: &Work) -> Result<Quotient, Unsupported> {
        let over = |value: Quotient, n: u32| {
            let below = self.rate.times(&fraction(n, 1), work)?;
            value.over(&below, work)
        };
        match (a, b) {
            (0, 0) => Ok(self.variable.clone()),
            (0, b) => {
                let power = self.cosine.power(b - 1, work)?;
                let first = over(self.sine.times(&power, work)?, b)?;
                if b == 1 {
                    return Ok(first);
                }
                let rest = self.antiderivative(0, b - 2, work)?;
                let rest = rest.times(&Quotient::number(integer(i64::from(b) - 1)), work)?;
                first.plus(&rest.times(&fraction(1, b), work)?, work)
            }
            (1, b) => over(self.cosine.power(b + 1, work)?.negated(), b + 1),
            _ => Err(Unsupported::Construct("a square of a sine")),
        }
    }
}
