//! Integers: conversions, ranges, quotients and remainders, each exact or refused.

use super::Runner;
use super::value::{Shape, Term, Value};
use crate::grammar::Read;
use crate::program::{CodeLanguage, Kind, operation};
use torse_numbers::Rational;
use torse_numbers::rational::integer;
use torse_syntax::formula::Place;

impl Runner<'_> {
    /// A number as an integer of a type.
    pub(super) fn integer(&mut self, kind: &str, values: &[Value], place: Place) -> Read<Value> {
        let [Value::Term(term)] = values else {
            let message = "the conversion of this into an integer is not read";
            return Err(self.refused(place, message, "numbers are converted"));
        };
        let bits = |kind: &str| match kind {
            "size" => Some(64),
            other => other.parse::<u32>().ok().filter(|bits| *bits <= 128),
        };
        let ends = match kind.split_at_checked(1) {
            Some(("u", size)) => bits(size).map(|bits| (integer(0), integer(2).pow(bits as i32))),
            Some(("i", size)) => bits(size).map(|bits| {
                let end = integer(2).pow(bits as i32 - 1);
                (-end.clone(), end)
            }),
            _ => None,
        };
        let fits = |value: &Rational| {
            let ends = ends.as_ref();
            value.is_integer() && ends.is_none_or(|(low, end)| low <= value && value < end)
        };
        // What needs more than 63 bits is the overflow that is out of scope.
        let is_wide = matches!(
            kind,
            "usize" | "isize" | "u64" | "i64" | "u128" | "i128" | ""
        );
        let is_exact = match &term.constant {
            Some(value) => fits(value),
            None if !term.kind.is_integer() => false,
            None => {
                let is_signed = !kind.starts_with('u');
                let least = self.least(term);
                let greatest = self.greatest(term);
                let fits = |end: Option<i64>| end.is_some_and(|end| fits(&integer(end)));
                (fits(least) || (is_wide && is_signed)) && (fits(greatest) || is_wide)
            }
        };
        if !is_exact || term.is_point {
            let message = match &term.constant {
                Some(value) if value.is_integer() => format!("{value} is no value of `{kind}`"),
                None if term.kind.is_integer() => {
                    format!("this may be no value of `{kind}`, and is cut off then")
                }
                _ => "this conversion rounds".to_owned(),
            };
            let help = match term.kind {
                Kind::Whole | Kind::Natural => {
                    "declare the integers such that it is one, or fix them: `--where 'n == 3'`"
                }
                _ => "code is read as exact mathematics: leave it out",
            };
            return Err(self.refused(place, message, help));
        }
        Ok(Value::Term(Term {
            kind: match kind.starts_with('u') {
                true => Kind::Natural,
                false => Kind::Whole,
            },
            ..term.clone()
        }))
    }

    /// Integers from low to below high.
    pub(super) fn range(&mut self, low: i64, high: i64, step: i64, place: Place) -> Read<Value> {
        if step == 0 {
            let message = "a range has no step of zero";
            return Err(self.refused(place, message, "leave the step out"));
        }
        let mut all = vec![];
        let mut here = low;
        while (step > 0 && here < high) || (step < 0 && here > high) {
            self.spend(place)?;
            all.push(Value::Term(Term::number(integer(here), true)));
            let Some(next) = here.checked_add(step) else {
                break;
            };
            here = next;
        }
        Ok(self.list(Shape::List, all))
    }

    /// A quotient or remainder of integers that are constants, which is exact.
    pub(super) fn whole(&mut self, name: &str, a: &Term, b: &Term, place: Place) -> Read<Value> {
        let help = "fix the integers that it depends on, `--where 'n == 3'`, or divide with `/`";
        let (Some(a), Some(b)) = (a.integer(), b.integer()) else {
            let message = "this division of integers depends on the value of a symbol";
            return Err(self.refused(place, message, help));
        };
        if b == 0 {
            let message = "this divides by zero";
            return Err(self.refused(place, message, "give a divisor that is not zero"));
        }
        let (above, below) = (i128::from(a), i128::from(b));
        let remainder = match self.program.language {
            CodeLanguage::Python => (above % below + below) % below,
            CodeLanguage::Rust => above % below,
        };
        let remainder = i64::try_from(remainder).unwrap_or(0);
        if name == operation::REMAINDER {
            return Ok(Value::Term(Term::number(integer(remainder), true)));
        }
        if remainder != 0 {
            let message = format!("this division rounds: {a} is no multiple of {b}");
            return Err(self.refused(place, message, help));
        }
        let Some(quotient) = a.checked_div(b) else {
            let message = "this division overflows";
            return Err(self.refused(place, message, help));
        };
        Ok(Value::Term(Term::number(integer(quotient), true)))
    }
}
