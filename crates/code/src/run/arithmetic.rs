//! Arithmetic of values, and their entries.

use super::value::{Family, Term, Value};
use super::{Runner, position};
use crate::grammar::{Read, small};
use crate::program::{CodeLanguage, NOWHERE};
use num_traits::Zero;
use std::sync::Arc;
use torse_numbers::rational::{integer, ratio};
use torse_numbers::{Affine, Rational};
use torse_syntax::formula::{Expr, Node, Operator, Place, parse};

/// The largest exponent of a power of two numbers that is carried out.
const MAX_EXPONENT: i64 = 64;
/// The largest numerator or denominator, in bits.
const MAX_BITS: usize = 4_096;

impl Runner<'_> {
    pub(super) fn negative(&mut self, value: Value, place: Place) -> Read<Value> {
        match value {
            Value::Term(term) => self.bounded(term.negative(), place),
            Value::Vector(items) => {
                let items = items.into_iter().map(|item| self.negative(item, place));
                Ok(Value::Vector(items.collect::<Read<_>>()?))
            }
            other => {
                let message = format!("{} has no sign", other.kind());
                Err(self.refused(
                    place,
                    message,
                    "numbers and vectors have one: `array([1, 2])`",
                ))
            }
        }
    }

    /// `left operator right`.
    pub(super) fn combined(
        &mut self,
        operator: Operator,
        left: Value,
        right: Value,
        place: Place,
    ) -> Read<Value> {
        use Operator::{Add, Divide, Multiply, Power, Subtract};
        let is_python = self.program.language == CodeLanguage::Python;
        match (operator, left, right) {
            (_, Value::Term(left), Value::Term(right)) => {
                let term = self.terms(operator, left, right, place)?;
                self.bounded(term, place)
            }
            (Add | Subtract, Value::Vector(a), Value::Vector(b)) if a.len() == b.len() => {
                let pairs = a.into_iter().zip(b);
                let joined = pairs.map(|(a, b)| self.combined(operator, a, b, place));
                Ok(Value::Vector(joined.collect::<Read<_>>()?))
            }
            (Multiply, Value::Term(factor), Value::Vector(items)) => {
                let scaled = items.into_iter();
                let scaled = scaled
                    .map(|item| self.combined(operator, Value::Term(factor.clone()), item, place));
                Ok(Value::Vector(scaled.collect::<Read<_>>()?))
            }
            (Multiply | Divide, Value::Vector(items), Value::Term(factor)) => {
                let scaled = items.into_iter();
                let scaled = scaled
                    .map(|item| self.combined(operator, item, Value::Term(factor.clone()), place));
                Ok(Value::Vector(scaled.collect::<Read<_>>()?))
            }
            (Add, Value::List(mut a), Value::List(b)) if is_python => {
                if a.iter().chain(&b).any(Value::is_list) {
                    self.escapes += 1;
                }
                a.extend(b);
                Ok(Value::List(a))
            }
            (Multiply, Value::List(items), Value::Term(count))
            | (Multiply, Value::Term(count), Value::List(items))
                if is_python =>
            {
                let count = self.constant(&Value::Term(count), place)?;
                self.repeated(items, count, place)
            }
            (Power, left, right) => {
                let message = format!("{} to the power of {}", left.kind(), right.kind());
                Err(self.refused(place, message, "powers of numbers are read"))
            }
            (_, left, right) => {
                let (left, right) = (left.kind(), right.kind());
                let message = format!("`{}` of {left} and {right} is not read", operator.sign());
                let help = "numbers are combined, and vectors with vectors of the same length: `array([1, 2])`; an entry of a list has its index";
                Err(self.refused(place, message, help))
            }
        }
    }

    /// A list of several copies of a list.
    pub(super) fn repeated(&mut self, items: Vec<Value>, count: i64, place: Place) -> Read<Value> {
        if self.program.language == CodeLanguage::Python && items.iter().any(Value::is_list) {
            let message = "all of these entries are one list in Python";
            let help = "write a comprehension: `[[0]*n for _ in range(n)]`";
            return Err(self.refused(place, message, help));
        }
        let mut all = vec![];
        for _ in 0..count.max(0) {
            self.spend(place)?;
            all.extend(items.iter().cloned());
            self.steps += items.len();
        }
        Ok(Value::List(all))
    }

    fn terms(&mut self, operator: Operator, left: Term, right: Term, place: Place) -> Read<Term> {
        let truncates = operator == Operator::Divide
            && self.program.language == CodeLanguage::Rust
            && left.is_whole
            && right.is_whole
            // A quotient that a correction puts in is one of real numbers.
            && place != NOWHERE;
        if operator == Operator::Divide && right.is_zero() {
            let message = "this divides by zero";
            return Err(self.refused(place, message, "give a divisor that is not zero"));
        }
        let folded = match (&left.constant, &right.constant) {
            (Some(a), Some(b)) => folded(operator, a, b),
            _ => None,
        };
        if truncates && !folded.as_ref().is_some_and(Rational::is_integer) {
            let message = "this division of integers rounds";
            let help = "divide numbers with a point, `1.0/2.0`, or convert before: `n as f64`";
            return Err(self.refused(place, message, help));
        }
        if let Some(value) = folded {
            let is_whole = left.is_whole && right.is_whole && value.is_integer();
            return Ok(Term::number(value, is_whole));
        }
        if operator == Operator::Power
            && let Some(exponent) = &right.constant
            && !exponent.is_integer()
        {
            return self.root(left, exponent, place);
        }
        Ok(left.joined(operator, right))
    }

    /// A power with an exponent of one half.
    fn root(&mut self, base: Term, exponent: &Rational, place: Place) -> Read<Term> {
        let root = Term::call("sqrt", vec![base]);
        if Some(exponent) == ratio(1, 2).as_ref() {
            return Ok(root);
        }
        if Some(exponent) == ratio(-1, 2).as_ref() {
            return Ok(Term::number(integer(1), false).joined(Operator::Divide, root));
        }
        let message = "a power with this exponent is not read";
        Err(self.refused(place, message, "integers are read, and one half: `sqrt(x)`"))
    }

    /// An entry of a list, a point, or a family.
    pub(super) fn entry(&mut self, list: Value, index: Value, place: Place) -> Read<Value> {
        match list {
            Value::List(items) | Value::Vector(items) => {
                let index = self.constant(&index, place)?;
                let count = items.len();
                let is_python = self.program.language == CodeLanguage::Python;
                let position = position(index, count, is_python);
                let entry = position.and_then(|position| items.into_iter().nth(position));
                entry.ok_or_else(|| {
                    let message = format!("there is no entry {index} among {count}");
                    self.refused(place, message, "entries are counted from 0")
                })
            }
            Value::Family(family) => self.member(family, index, place),
            Value::Term(term) => {
                let Some(dimension) = self.setting.dimension(&term.expr) else {
                    let message =
                        "this is a number, or a point of any dimension, and has no entries";
                    let help = "let the name stand for a list: `--map 'P=[a, b, c]'`";
                    return Err(self.refused(place, message, help));
                };
                let index = self.constant(&index, place)?;
                // Programs count from 0, the language from 1.
                let position = position(index, usize::from(dimension), false);
                let Some(position) = position else {
                    let message = format!("there is no entry {index} among {dimension}");
                    return Err(self.refused(place, message, "entries are counted from 0"));
                };
                let position = i64::try_from(position).unwrap_or(0) + 1;
                let indices = vec![Expr::number(&integer(position))];
                let expr = Expr::made(Node::Index(Arc::new(term.expr), indices));
                self.bounded(Term::formula(expr, false), place)
            }
            Value::Truth(_) => Err(self.refused(place, "this has no entries", "name a list")),
        }
    }

    /// A family with one index more: a member, if it has all of them.
    fn member(&mut self, mut family: Family, index: Value, place: Place) -> Read<Value> {
        let Value::Term(index) = index else {
            let message = "an index is an integer";
            return Err(self.refused(place, message, "write `P[i]`"));
        };
        let range = family.ranges.get(family.given.len());
        let ends = range.and_then(|(low, high)| Some((low.as_number()?, high.as_number()?)));
        let mut index = index;
        if let (Some(value), Some((low, high))) = (index.integer(), ends) {
            let is_python = self.program.language == CodeLanguage::Python;
            // The last entry of a list that is counted from 0.
            let value = match value {
                negative if negative < 0 && is_python && low == 0 => {
                    index = Term::number(integer(negative + high + 1), true);
                    negative + high + 1
                }
                other => other,
            };
            if !(low..=high).contains(&value) {
                let name = &family.name;
                let message =
                    format!("`{name}` has the indices {low} to {high}, and this is {value}");
                let help = format!("let the name stand for a list: `--map '{name}=[...]'`");
                return Err(self.refused(place, message, help));
            }
        } else if index.integer().is_some_and(|value| value < 0) {
            let message = "an index from the end of a list whose length is not fixed";
            return Err(self.refused(place, message, "fix its length: `--where 'n == 3'`"));
        }
        family.given.push(index.expr);
        if family.given.len() < family.ranges.len() {
            return Ok(Value::Family(family));
        }
        let head = Arc::new(Expr::name(&family.name));
        let expr = Expr::made(Node::Index(head, family.given));
        self.bounded(Term::formula(expr, false), place)
    }

    /// All members of a family whose last range is fixed.
    pub(super) fn members(&mut self, family: &Family, place: Place) -> Read<Vec<Value>> {
        let range = family.ranges.get(family.given.len());
        let ends = range.and_then(|(low, high)| Some((low.as_number()?, high.as_number()?)));
        let Some((low, high)) = ends else {
            let message = format!("how many members `{}` has is not fixed", family.name);
            let help = "fix the integer that ends its range: `--where 'n == 3'`";
            return Err(self.refused(place, message, help));
        };
        let mut all = vec![];
        for index in low..=high {
            self.spend(place)?;
            let index = Value::Term(Term::number(integer(index), true));
            all.push(self.member(family.clone(), index, place)?);
        }
        Ok(all)
    }

    /// The number of members of a family.
    pub(super) fn count(&mut self, family: &Family, place: Place) -> Read<Value> {
        let range = family.ranges.get(family.given.len());
        let count = range.map(|(low, high)| high.clone() - low.clone() + Affine::number(1));
        match count
            .as_ref()
            .map(|count| (count.as_number(), parse(&count.to_string())))
        {
            Some((Some(count), _)) => Ok(Value::Term(Term::number(integer(count), true))),
            Some((None, Ok(count))) => Ok(Value::Term(Term::formula(count.placeless(), true))),
            _ => {
                let message = format!("how many members `{}` has is not declared", family.name);
                Err(self.refused(place, message, "pass the number as a parameter"))
            }
        }
    }
}

/// The value of an operation on two numbers; none where it is no rational number, or a large one.
fn folded(operator: Operator, a: &Rational, b: &Rational) -> Option<Rational> {
    let value = match operator {
        Operator::Add => a + b,
        Operator::Subtract => a - b,
        Operator::Multiply => a * b,
        Operator::Divide => a / b,
        Operator::Power => {
            let exponent = small(b).filter(|n| (-MAX_EXPONENT..=MAX_EXPONENT).contains(n))?;
            if a.is_zero() && exponent < 0 {
                return None;
            }
            a.pow(i32::try_from(exponent).ok()?)
        }
    };
    let is_small = [value.numer(), value.denom()]
        .into_iter()
        .all(|n| n.bits() <= MAX_BITS);
    is_small.then_some(value)
}

/// How many bits an integer has.
trait Bits {
    fn bits(&self) -> usize;
}

impl Bits for torse_numbers::Integer {
    fn bits(&self) -> usize {
        // An upper bound: three bits and a third a digit.
        self.to_string().len() * 10 / 3
    }
}
