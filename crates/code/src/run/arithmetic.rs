//! Arithmetic of values, and their entries.

use super::value::{Family, List, Shape, Term, Value};
use super::{Runner, position};
use crate::grammar::{Read, small};
use crate::program::{CodeLanguage, Kind, NOWHERE};
use num_traits::{Signed, Zero};
use std::sync::Arc;
use torse_numbers::rational::{integer, ratio};
use torse_numbers::{Affine, Rational};
use torse_syntax::formula::{Expr, Node, Operator, Place, Relation, parse};

/// The largest exponent of a power of two numbers that is carried out.
const MAX_EXPONENT: i64 = 64;
/// The largest numerator or denominator, in bits.
const MAX_BITS: usize = 4_096;

impl Runner<'_> {
    pub(super) fn negative(&mut self, value: Value, place: Place) -> Read<Value> {
        match value {
            Value::Term(term) => self.bounded(term.negative(), place),
            Value::List(list) if matches!(list.shape, Shape::Vector | Shape::Matrix) => {
                self.each(list, |runner, value| runner.negative(value, place))
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

    /// A new list of what becomes of each value.
    pub(super) fn each(
        &mut self,
        list: List,
        mut change: impl FnMut(&mut Self, Value) -> Read<Value>,
    ) -> Read<Value> {
        let values = list.values.into_iter();
        let values = values.map(|value| change(self, value));
        let values = values.collect::<Read<_>>()?;
        Ok(self.list(list.shape, values))
    }

    /// `left operator right`.
    pub(super) fn combined(
        &mut self,
        operator: Operator,
        left: Value,
        right: Value,
        place: Place,
    ) -> Read<Value> {
        use Operator::{Add, Divide, Multiply, Subtract};
        use Shape::{List as Plain, Matrix, Vector};
        let is_python = self.program.language == CodeLanguage::Python;
        match (operator, left, right) {
            (_, Value::Term(left), Value::Term(right)) => {
                self.is_arithmetic(operator, &left, &right, place)?;
                let term = self.terms(operator, left, right, place)?;
                self.bounded(term, place)
            }
            (Add | Subtract, Value::List(a), Value::List(b))
                if a.shape == b.shape
                    && matches!(a.shape, Vector | Matrix)
                    && a.values.len() == b.values.len() =>
            {
                let shape = a.shape;
                let pairs = a.values.into_iter().zip(b.values);
                let joined = pairs.map(|(a, b)| self.combined(operator, a, b, place));
                let joined = joined.collect::<Read<_>>()?;
                Ok(self.list(shape, joined))
            }
            (Multiply, Value::Term(factor), Value::List(list))
                if !factor.is_point && matches!(list.shape, Vector | Matrix) =>
            {
                self.each(list, |runner, item| {
                    runner.combined(operator, Value::Term(factor.clone()), item, place)
                })
            }
            (Multiply | Divide, Value::List(list), Value::Term(factor))
                if !factor.is_point && matches!(list.shape, Vector | Matrix) =>
            {
                self.each(list, |runner, item| {
                    runner.combined(operator, item, Value::Term(factor.clone()), place)
                })
            }
            (Add, Value::List(a), Value::List(b))
                if is_python && a.shape == Plain && b.shape == Plain =>
            {
                let mut values = a.values;
                values.extend(b.values);
                Ok(self.list(Plain, values))
            }
            (Multiply, Value::List(list), Value::Term(count))
            | (Multiply, Value::Term(count), Value::List(list))
                if is_python && list.shape == Plain =>
            {
                let count = self.constant(&Value::Term(count), place)?;
                self.repeated(list.values, count, place)
            }
            (Operator::Power, left, right) => {
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

    /// Fails for what is done to points entry by entry, and has no meaning for points.
    fn is_arithmetic(
        &self,
        operator: Operator,
        left: &Term,
        right: &Term,
        place: Place,
    ) -> Read<()> {
        let is_read = match operator {
            Operator::Add | Operator::Subtract => {
                left.is_point == right.is_point || left.is_zero() || right.is_zero()
            }
            Operator::Multiply => !left.is_point || !right.is_point,
            Operator::Divide => !right.is_point,
            Operator::Power => !left.is_point && !right.is_point,
        };
        if is_read {
            return Ok(());
        }
        let kind = |term: &Term| if term.is_point { "a point" } else { "a number" };
        let (left, right) = (kind(left), kind(right));
        let message = format!("`{}` of {left} and {right} is not read", operator.sign());
        let help =
            "arrays are combined entry by entry here: points are added, and multiplied by numbers";
        Err(self.refused(place, message, help))
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
            for item in &items {
                self.spend_all(item.entries(super::MAX_CODE_STEPS), place)?;
            }
            all.extend(items.iter().cloned());
        }
        Ok(self.list(Shape::List, all))
    }

    fn terms(&mut self, operator: Operator, left: Term, right: Term, place: Place) -> Read<Term> {
        let is_division = operator == Operator::Divide;
        let has_types = self.program.language == CodeLanguage::Rust;
        let kind = left.kind.joined(right.kind);
        let kind = match operator {
            Operator::Divide if !has_types => Kind::Float,
            // The power of an integer to a negative one is no integer.
            Operator::Power if !has_types && right.integer().is_none_or(|n| n < 0) => {
                Kind::Unknown.joined(kind)
            }
            _ => kind,
        };
        // A quotient that a correction puts in is one of real numbers.
        let truncates = is_division && has_types && kind != Kind::Float && place != NOWHERE;
        if is_division && right.is_zero() {
            let message = "this divides by zero";
            return Err(self.refused(place, message, "give a divisor that is not zero"));
        }
        let is_negative = right.constant.as_ref().is_some_and(Rational::is_negative);
        let is_power = operator == Operator::Power && left.kind.is_integer();
        if is_power && is_negative && (left.is_of_array || right.is_of_array) {
            let message = "NumPy has no negative power of an integer of an array";
            let help = "write the entries of the array with a point";
            return Err(self.refused(place, message, help));
        }
        if kind == Kind::Natural && operator == Operator::Subtract && place != NOWHERE {
            let difference = left.clone().joined(Operator::Subtract, right.clone());
            let is_natural = match (&left.constant, &right.constant) {
                (Some(a), Some(b)) => a >= b,
                _ => self.is_natural(&difference),
            };
            if !is_natural {
                let message = "this may be below zero, and its type has no such integers";
                let help =
                    "declare the integers such that it is not, or convert them before: `n as i64`";
                return Err(self.refused(place, message, help));
            }
        }
        let folded = match (&left.constant, &right.constant) {
            (Some(a), Some(b)) => folded(operator, a, b),
            _ => None,
        };
        if truncates && !folded.as_ref().is_some_and(Rational::is_integer) {
            let message = match kind {
                Kind::Whole | Kind::Natural => "this division of integers rounds",
                _ => "this may be a division of integers, which rounds",
            };
            let help = "divide numbers with a point, `1.0/2.0`, or convert before: `n as f64`";
            return Err(self.refused(place, message, help));
        }
        if let Some(value) = folded {
            let are_dyadic = [&left.constant, &right.constant]
                .iter()
                .all(|own| own.as_ref().is_none_or(is_dyadic));
            let is_exact = kind.is_integer() || (are_dyadic && is_dyadic(&value));
            let is_rounded = left.is_rounded || right.is_rounded || !is_exact;
            return Ok(Term {
                kind,
                is_rounded,
                is_of_array: left.is_of_array || right.is_of_array,
                ..Term::number(value, false)
            });
        }
        if operator == Operator::Power
            && let Some(exponent) = &right.constant
            && !exponent.is_integer()
        {
            return self.root(left, exponent, place);
        }
        Ok(Term {
            kind,
            ..left.joined(operator, right)
        })
    }

    /// A power with an exponent of one half.
    fn root(&mut self, base: Term, exponent: &Rational, place: Place) -> Read<Term> {
        // The power of a negative number is complex in Python, and none in Rust.
        if self.program.language == CodeLanguage::Python {
            self.oblige(base.expr.clone(), Relation::AtLeast, place);
        }
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
            Value::List(list) if list.shape == Shape::Iterator => {
                let message = "an iterator has no entries, and is gone through once";
                Err(self.refused(place, message, "make a list of it: `q = list(p)`"))
            }
            Value::List(list) if list.has_rows() => {
                let message = "one index counts all entries of a matrix of SymPy, row by row";
                Err(self.refused(place, message, "write both indices: `M[i, j]`"))
            }
            Value::List(list) => {
                let items = list.values;
                let index = self.constant(&index, place)?;
                let count = items.len();
                let is_python = self.program.language == CodeLanguage::Python;
                let position = position(index, count, is_python);
                let entry = position.and_then(|position| items.into_iter().nth(position));
                let entry = entry.map(|entry| match entry {
                    Value::Term(term) if list.shape == Shape::Vector => Value::Term(Term {
                        is_of_array: is_python && term.kind.is_integer(),
                        ..term
                    }),
                    other => other,
                });
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
                let is_python = self.program.language == CodeLanguage::Python;
                let position = position(index, usize::from(dimension), is_python);
                let Some(position) = position else {
                    let message = format!("there is no entry {index} among {dimension}");
                    return Err(self.refused(place, message, "entries are counted from 0"));
                };
                let position = i64::try_from(position).unwrap_or(0) + 1;
                let indices = vec![Expr::number(&integer(position))];
                let expr = Expr::made(Node::Index(Arc::new(term.expr), indices));
                self.bounded(Term::formula(expr, term.kind), place)
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
        } else if self.program.language == CodeLanguage::Python && !self.is_natural(&index) {
            let message = "this index may be negative, and then counts from the end";
            let help = "declare the integers such that it is not negative, or fix them: `--where 'n == 3'`";
            return Err(self.refused(place, message, help));
        }
        family.given.push(index.expr);
        if family.given.len() < family.ranges.len() {
            return Ok(Value::Family(family));
        }
        let head = Arc::new(Expr::name(&family.name));
        let expr = Expr::made(Node::Index(head, family.given));
        let member = Term {
            is_point: family.is_of_points,
            ..Term::formula(expr, family.kind)
        };
        // The same array each time, which was made outside.
        Ok(self.bounded(member, place)?.foreign())
    }

    /// An entry with several indices in one pair of brackets.
    pub(super) fn entries(
        &mut self,
        value: Value,
        indices: Vec<(Value, Place)>,
        place: Place,
    ) -> Read<Value> {
        let several = indices.len() > 1 && self.program.language == CodeLanguage::Python;
        let mut value = match value {
            Value::List(list) if several && list.has_rows() && indices.len() == 2 => {
                Value::List(List {
                    shape: Shape::Vector,
                    ..list
                })
            }
            Value::List(list) if several && list.shape != Shape::Vector => {
                let message = "a list has one index in a pair of brackets";
                return Err(self.refused(place, message, "write `m[i][j]`"));
            }
            other => other,
        };
        for (index, place) in indices {
            if let Value::List(list) = &mut value
                && list.shape == Shape::Matrix
                && several
            {
                list.shape = Shape::Vector;
            }
            value = self.entry(value, index, place)?;
        }
        Ok(value)
    }

    /// Fails for a family whose first index is not 0: what list it is in a program is not known.
    fn begins_at_zero(&self, family: &Family, place: Place) -> Read<()> {
        match family.ranges.get(family.given.len()) {
            Some((low, _)) if low.as_number() != Some(0) => {
                let name = &family.name;
                let message = format!(
                    "the indices of `{name}` begin at {low} in the claim, and those of lists at 0"
                );
                let help =
                    format!("say which list it is: `--map '{name}=[0, {name}[1], {name}[2]]'`");
                Err(self.refused(place, message, help))
            }
            _ => Ok(()),
        }
    }

    /// All members of a family whose last range is fixed.
    pub(super) fn members(&mut self, family: &Family, place: Place) -> Read<Vec<Value>> {
        self.begins_at_zero(family, place)?;
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
        self.begins_at_zero(family, place)?;
        let range = family.ranges.get(family.given.len());
        let count = range.map(|(low, high)| high.clone() - low.clone() + Affine::number(1));
        match count
            .as_ref()
            .map(|count| (count.as_number(), parse(&count.to_string())))
        {
            Some((Some(count), _)) => Ok(Value::Term(Term::number(integer(count), true))),
            Some((None, Ok(count))) => {
                Ok(Value::Term(Term::formula(count.placeless(), Kind::Whole)))
            }
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

/// Whether floating-point numbers have this value exactly: its denominator is a power of two, and it is not large.
fn is_dyadic(value: &Rational) -> bool {
    let scale = integer(2).pow(50);
    (value * &scale).is_integer() && value.abs() < scale
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
