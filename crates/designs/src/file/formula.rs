//! Formulas without unknowns, in the language of the claims: `sqrt(2)/2`, `pi/4`, `2*r + 1`.
//!
//! A value is a rational number as long as it can be, then a ball of [`BITS`] bits; what goes into a design is the
//! double next to it.

use num_traits::{Signed, ToPrimitive, Zero};
use torse_numbers::rational::{Rational, to_f64};
use torse_numbers::{Ball, ExactError, Scalar};
use torse_syntax::fault::{Fault, Problem};
use torse_syntax::formula::ast::{Expr, Node, Operator, Place};
use torse_syntax::similar::similar;

/// Bits after the point of what is not rational.
const BITS: usize = 320;
/// What is smaller than this and not rational is zero up to rounding: `cos(pi/2)`.
const NOTHING: f64 = 1e-80;
/// The greatest exponent of a number that is not rational.
const MAX_POWER: u32 = 1024;
/// The functions of the language that take a number to a number.
pub const FUNCTIONS: [&str; 11] = [
    "sqrt", "exp", "log", "sin", "cos", "tan", "asin", "acos", "atan", "radians", "degrees",
];

/// The value of a formula.
#[derive(Debug, Clone)]
pub enum FormulaValue {
    /// A rational number.
    Exact(Rational),
    /// A number between bounds.
    Near(Ball),
}

impl FormulaValue {
    fn ball(&self) -> Ball {
        match self {
            Self::Exact(value) => Ball::from_rational(value, BITS),
            Self::Near(ball) => ball.clone(),
        }
    }

    /// Returns the value times a rational number.
    pub fn times(&self, factor: &Rational) -> Self {
        match self {
            Self::Exact(value) => Self::Exact(value.clone() * factor.clone()),
            Self::Near(ball) => Self::Near(ball.clone() * Ball::from_rational(factor, BITS)),
        }
    }

    /// Returns the nearest double, up to the last place; `None` when it is not finite or not known so well.
    pub fn to_f64(&self) -> Option<f64> {
        let value = match self {
            Self::Exact(value) => to_f64(value),
            Self::Near(ball) => {
                let (low, high) = ball.to_f64_bounds();
                if low.abs().max(high.abs()) < NOTHING {
                    return Some(0.0);
                }
                // The bounds of a double are its neighbours.
                if low.next_up().next_up() < high {
                    return None;
                }
                to_f64(&ball.midpoint())
            }
        };
        value.is_finite().then_some(value)
    }
}

/// The value of a name at a place: `None` for one that has none, and the error for one whose own formula is wrong.
pub type Lookup<'l> = dyn FnMut(&str, Place) -> Result<Option<FormulaValue>, Fault> + 'l;

/// Returns the value of a formula, with the values of names from `lookup`.
pub fn evaluate(
    formula: &Expr,
    lookup: &mut Lookup<'_>,
    names: &[&str],
) -> Result<FormulaValue, Fault> {
    let place = formula.place;
    match &formula.node {
        Node::Number { value, .. } => Ok(FormulaValue::Exact(value.clone())),
        Node::Name(name) if name == "pi" => Ok(FormulaValue::Near(Ball::pi(BITS))),
        Node::Name(name) => match lookup(name, place)? {
            Some(value) => Ok(value),
            None => Err(unknown(name, place, names)),
        },
        Node::Negative(inner) => Ok(match evaluate(inner, lookup, names)? {
            FormulaValue::Exact(value) => FormulaValue::Exact(-value),
            FormulaValue::Near(ball) => FormulaValue::Near(-ball),
        }),
        Node::Binary(operator, left, right) => {
            let base = evaluate(left, lookup, names)?;
            let other = evaluate(right, lookup, names)?;
            let value = match operator {
                Operator::Power => match (whole(&other), other) {
                    (Some(exponent), _) => power(base, exponent),
                    (None, FormulaValue::Exact(exponent)) => root_power(&base, &exponent),
                    (None, FormulaValue::Near(_)) => {
                        return Err(wrong(right.place, "another exponent", "a rational number"));
                    }
                },
                _ => combined(*operator, base, other),
            };
            value.map_err(|error| Fault::exact(place, error))
        }
        Node::Call(head, arguments) => {
            let (Node::Name(name), [argument]) = (&head.node, arguments.as_slice()) else {
                return Err(wrong(
                    place,
                    "a call",
                    "a function of one number, as sqrt or sin",
                ));
            };
            if !FUNCTIONS.contains(&name.as_str()) {
                return Err(unknown(name, head.place, &FUNCTIONS));
            }
            let argument = evaluate(argument, lookup, names)?;
            applied(name, &argument).map_err(|error| Fault::exact(place, error))
        }
        Node::Index(..) => Err(wrong(place, "an index", "a number")),
        Node::List(_) => Err(wrong(place, "a list", "a number")),
        Node::Compare(..) | Node::Join(..) | Node::Not(_) => {
            Err(wrong(place, "a statement", "a number"))
        }
    }
}

fn wrong(place: Place, what: &'static str, wanted: &'static str) -> Fault {
    Fault::at(place, Problem::WrongType { what, wanted })
}

fn unknown(name: &str, place: Place, names: &[&str]) -> Fault {
    let similar = similar(name, names.iter().copied()).map(str::to_owned);
    let name = name.to_owned();
    Fault::at(place, Problem::UnknownName { name, similar })
}

fn applied(function: &str, argument: &FormulaValue) -> Result<FormulaValue, ExactError> {
    let is_zero = matches!(argument, FormulaValue::Exact(value) if value.is_zero());
    let one = Rational::from_integer(1.into());
    match function {
        "sin" | "tan" | "asin" | "atan" | "radians" | "degrees" if is_zero => {
            return Ok(FormulaValue::Exact(Rational::zero()));
        }
        "cos" | "exp" if is_zero => return Ok(FormulaValue::Exact(one)),
        _ => {}
    }
    // The root of a square is rational.
    if let ("sqrt", Some(root)) = (function, exact_root(argument)) {
        return Ok(FormulaValue::Exact(root));
    }
    let ball = argument.ball();
    let number = |n: i64| Ball::from_rational(&Rational::from_integer(n.into()), BITS);
    Ok(FormulaValue::Near(match function {
        "sqrt" => ball.sqrt()?,
        "exp" => ball.exp()?,
        "log" => ball.ln()?,
        "sin" => ball.sin_cos().0,
        "cos" => ball.sin_cos().1,
        "tan" => {
            let (sine, cosine) = ball.sin_cos();
            sine.divided_by(&cosine)?
        }
        "asin" => ball.asin()?,
        "acos" => Ball::pi(BITS).divided_by(&number(2))? - ball.asin()?,
        "atan" => ball.atan()?,
        "radians" => (ball * Ball::pi(BITS)).divided_by(&number(180))?,
        _ => (ball * number(180)).divided_by(&Ball::pi(BITS))?,
    }))
}

/// A power of a positive number whose exponent is no integer, and zero to a positive one.
fn root_power(base: &FormulaValue, exponent: &Rational) -> Result<FormulaValue, ExactError> {
    if let FormulaValue::Exact(value) = base
        && value.is_zero()
        && exponent.is_positive()
    {
        return Ok(FormulaValue::Exact(Rational::zero()));
    }
    let half = Rational::new(1.into(), 2.into());
    if *exponent == half {
        return applied("sqrt", base);
    }
    let logarithm = base.ball().ln()? * Ball::from_rational(exponent, BITS);
    logarithm.exp().map(FormulaValue::Near)
}

fn exact_root(argument: &FormulaValue) -> Option<Rational> {
    let FormulaValue::Exact(value) = argument else {
        return None;
    };
    if value.is_negative() {
        return None;
    }
    // A root of 320 bits after the point that is rational with so few digits is found by its double.
    let root = Rational::from_integer(to_f64(value).sqrt().round().to_i64()?.into());
    (root.clone() * root.clone() == *value).then_some(root)
}

fn combined(
    operator: Operator,
    left: FormulaValue,
    right: FormulaValue,
) -> Result<FormulaValue, ExactError> {
    if let (FormulaValue::Exact(a), FormulaValue::Exact(b)) = (&left, &right) {
        let (a, b) = (a.clone(), b.clone());
        let value = match operator {
            Operator::Add => a + b,
            Operator::Subtract => a - b,
            Operator::Multiply => a * b,
            _ => a.divided_by(&b)?,
        };
        return value.bounded().map(FormulaValue::Exact);
    }
    let (a, b) = (left.ball(), right.ball());
    Ok(FormulaValue::Near(match operator {
        Operator::Add => a + b,
        Operator::Subtract => a - b,
        Operator::Multiply => a * b,
        _ => a.divided_by(&b)?,
    }))
}

fn whole(exponent: &FormulaValue) -> Option<i32> {
    match exponent {
        FormulaValue::Exact(q) if q.is_integer() => q.numer().to_i32(),
        _ => None,
    }
}

fn power(base: FormulaValue, exponent: i32) -> Result<FormulaValue, ExactError> {
    let ball = match base {
        FormulaValue::Exact(value) => return value.checked_pow(exponent).map(FormulaValue::Exact),
        FormulaValue::Near(ball) => ball,
    };
    let size = exponent.unsigned_abs();
    if size > MAX_POWER {
        let bits = BITS.saturating_mul(usize::try_from(size).unwrap_or(usize::MAX));
        let limit = BITS * 1024;
        return Err(ExactError::TooLarge { bits, limit });
    }
    let power = ball.powi(size);
    if exponent < 0 {
        let one = Ball::from_rational(&Rational::from_integer(1.into()), BITS);
        return one.divided_by(&power).map(FormulaValue::Near);
    }
    Ok(FormulaValue::Near(power))
}

#[cfg(test)]
mod tests {
    use super::*;
    use torse_syntax::formula::parse;

    fn value(text: &str) -> Option<f64> {
        let formula = parse(text).unwrap();
        let mut two = |name: &str, _| Ok((name == "two").then(|| FormulaValue::Exact(2.into())));
        evaluate(&formula, &mut two, &["two"]).ok()?.to_f64()
    }

    #[test]
    fn formulas_have_the_nearest_doubles() {
        assert_eq!(value("sqrt(2)/2"), Some(0.5_f64.sqrt()));
        assert_eq!(value("pi/4"), Some(std::f64::consts::FRAC_PI_4));
        assert_eq!(value("two^-3 - 1/8"), Some(0.0));
        assert_eq!(value("sqrt(9)"), Some(3.0));
        assert_eq!(value("cos(pi/3)"), Some(0.5));
        assert_eq!(value("0.1"), Some(0.1));
        assert_eq!(value("20*cos(pi/2)"), Some(0.0));
        assert_eq!(value("sqrt(2)^2"), Some(2.0));
        assert_eq!(value("cos(0) + sin(0)"), Some(1.0));
        assert_eq!(value("tan(pi/8)"), Some(0.414_213_562_373_095_03));
        assert_eq!(value("sin(radians(30))"), Some(0.5));
        assert_eq!(value("degrees(atan(1))"), Some(45.0));
        assert_eq!(value("degrees(asin(1/2) + acos(1/2))"), Some(90.0));
        assert_eq!(value("tan(0) + asin(0) + radians(0)"), Some(0.0));
        assert_eq!(value("2^0.5"), Some(2.0_f64.sqrt()));
        assert_eq!(value("9^0.5 + 0^(1/3)"), Some(3.0));
        assert_eq!(value("8^(-1/3)"), Some(0.5));
        assert_eq!(value("pi^(1/2) - sqrt(pi)"), Some(0.0));
        assert_eq!(value("log(exp(two))"), Some(2.0));
    }

    #[test]
    fn what_is_no_number_is_refused() {
        for text in [
            "three",
            "sqrt(-1)",
            "1/0",
            "1/(two - 2)",
            "[1, 2]",
            "1 < 2",
            "cot(1)",
            "tan(pi/2)",
            "asin(2)",
            "log(0)",
            "(-8)^(1/3)",
            "0^(-1/2)",
            "det(1)",
            "pi^5000",
            "10^99999999",
            "sin(1, 2)",
            "pi^pi",
            "1/(pi - pi)",
        ] {
            assert_eq!(value(text), None, "{text}");
        }
        // A product of a sum that cancels has no digits left.
        assert_eq!(value("(sqrt(2)^2 - 2)*10^100"), None);
    }
}
