//! Functions of formulas, applied to values.

use super::value::{Shape, Term, Value};
use super::{Obligation, Runner};
use crate::grammar::Read;
use crate::program::{CodeLanguage, Kind};
use num_traits::Signed;
use std::sync::Arc;
use torse_numbers::rational::integer;
use torse_syntax::formula::functions::{ELEMENTARY, is_function};
use torse_syntax::formula::{Expr, Node, Operator, Place, Relation};

impl Runner<'_> {
    /// A function of formulas.
    pub(super) fn function(&mut self, name: &str, values: Vec<Value>, place: Place) -> Read<Value> {
        let count = values.len();
        if ELEMENTARY.contains(&name)
            && let [Value::List(list)] = values.as_slice()
            && list.shape == Shape::Vector
        {
            let list = list.clone();
            return self.each(list, |runner, item| {
                runner.function(name, vec![item], place)
            });
        }
        if matches!(name, "min" | "max") {
            return self.extremum(name, values, place);
        }
        let counts: &[usize] = match name {
            "abs" | "factorial" => &[1],
            "dot" | "cross" | "binom" => &[2],
            "at" => &[3],
            "D" => &[2, 3],
            "sum" | "product" | "integral" => &[4],
            _ if ELEMENTARY.contains(&name) => &[1],
            _ => &[],
        };
        if self.program.language == CodeLanguage::Rust
            && ELEMENTARY.contains(&name)
            && name != "abs"
            && let [Value::Term(term)] = values.as_slice()
            && term.kind.is_integer()
        {
            let message = format!("an integer has no `{name}` in Rust");
            return Err(self.refused(place, message, "convert it before: `n as f64`"));
        }
        if !is_function(name) || !counts.contains(&count) {
            let message = format!("`{name}` of {count} arguments is not read");
            return Err(self.refused(place, message, "give as many arguments as it has"));
        }
        if matches!(name, "dot" | "cross") {
            self.are_points(name, &values, place)?;
        }
        // A list is a point for these alone, and a point may stand in them.
        let takes_lists = matches!(name, "dot" | "cross");
        let takes_points = takes_lists || matches!(name, "D" | "at" | "integral" | "sum");
        let is_python = self.program.language == CodeLanguage::Python;
        let kinds = values.iter().map(Value::number_kind);
        let of_all = kinds.reduce(Kind::joined).unwrap_or(Kind::Unknown);
        let mut terms = vec![];
        for value in values {
            let kind = value.kind();
            let term = match value {
                Value::Term(term) if takes_points || !term.is_point => Some(term),
                list if takes_lists => list.formula(),
                _ => None,
            };
            terms.push(term.ok_or_else(|| {
                let message = format!("`{name}` of {kind} is not read");
                self.refused(place, message, "give a number")
            })?);
        }
        if name == "D"
            && let [_, _, times] = terms.as_slice()
            && times.integer().is_none()
        {
            let message = "how many times this is differentiated is a constant";
            let help = "differentiate by one symbol after the other: `diff(diff(f, x), y)`";
            return Err(self.refused(place, message, help));
        }
        let bound = match name {
            "at" | "D" | "integral" => terms.get(1),
            "sum" | "product" => terms.first(),
            _ => None,
        };
        if bound.is_some_and(|bound| !matches!(bound.expr.node, Node::Name(_))) {
            let message = format!("the variable of `{name}` has to be a symbol");
            return Err(self.refused(place, message, "let it stand for a symbol of the claim"));
        }
        if name == "factorial"
            && let Some(n) = terms.first().and_then(Term::integer)
            && (0..=20).contains(&n)
        {
            let product = (1..=n)
                .map(integer)
                .fold(integer(1), |product, n| product * n);
            return Ok(Value::Term(Term::number(product, true)));
        }
        if name == "abs"
            && let Some(value) = terms.first().and_then(|term| term.constant.clone())
        {
            let kind = terms.first().map_or(Kind::Unknown, |term| term.kind);
            let is_rounded = terms.first().is_some_and(|term| term.is_rounded);
            return Ok(Value::Term(Term {
                kind,
                is_rounded,
                ..Term::number(value.abs(), false)
            }));
        }
        let kind = match name {
            "abs" => terms.first().map_or(Kind::Unknown, |term| term.kind),
            "binom" | "factorial" => Kind::Whole,
            "dot" | "cross" => of_all,
            // The functions of the language of a program are those of floating-point numbers.
            _ if ELEMENTARY.contains(&name) => Kind::Float,
            _ if is_python => Kind::Float,
            _ => Kind::Unknown,
        };
        let is_point = match name {
            "dot" => false,
            "cross" => true,
            _ => terms.iter().any(|term| term.is_point),
        };
        let term = Term {
            kind,
            is_point,
            ..Term::call(name, terms)
        };
        self.bounded(term, place)
    }

    /// A function of numbers that has complex values elsewhere: where it is real is to be shown.
    pub(super) fn real(&mut self, name: &str, values: Vec<Value>, place: Place) -> Read<Value> {
        let one = Expr::number(&integer(1));
        for value in &values {
            let Value::Term(term) = value else {
                let message = format!("`{name}` of {} is not read", value.kind());
                return Err(self.refused(place, message, "give a number"));
            };
            match name {
                "asin" | "acos" => {
                    let above = one.clone().with(Operator::Add, term.expr.clone());
                    let below = one.clone().with(Operator::Subtract, term.expr.clone());
                    self.oblige(above, Relation::AtLeast, place);
                    self.oblige(below, Relation::AtLeast, place);
                }
                // At zero SymPy has a value of its own.
                "log" => self.oblige(term.expr.clone(), Relation::Greater, place),
                _ => self.oblige(term.expr.clone(), Relation::AtLeast, place),
            }
        }
        self.function(name, values, place)
    }

    /// Notes that a formula has to be greater than zero, or at least zero.
    pub(super) fn oblige(&mut self, expr: Expr, relation: Relation, place: Place) {
        if matches!(&expr.node, Node::Number { value, .. } if value.is_positive()) {
            return;
        }
        let relation = vec![(relation, Expr::number(&integer(0)))];
        let condition = Expr::made(Node::Compare(Arc::new(expr), relation));
        let obligation = Obligation { condition, place };
        if !self.obligations.contains(&obligation) {
            self.obligations.push(obligation);
        }
    }

    /// Fails unless both are points, or lists of numbers that are as long.
    fn are_points(&self, name: &str, values: &[Value], place: Place) -> Read<()> {
        let mut lengths = vec![];
        for value in values {
            lengths.push(match value {
                Value::Term(term) if term.is_point => {
                    let dimension = self.setting.dimension(&term.expr);
                    Some(dimension.map(usize::from))
                }
                Value::List(list) if list.shape != Shape::Iterator && !list.is_nested() => {
                    Some(Some(list.values.len()))
                }
                _ => None,
            });
        }
        let (known, all) = match lengths.as_slice() {
            [Some(one), Some(other)] => (
                one.or(*other),
                one.is_none_or(|one| other.is_none_or(|o| o == one)),
            ),
            _ => (None, false),
        };
        if !all || (name == "cross" && known.is_some_and(|length| length != 3)) {
            let message = format!("this `{name}` is not read");
            let help = "it is read of two points, or of two lists of numbers of one length";
            return Err(self.refused(place, message, help));
        }
        Ok(())
    }

    /// The smallest or the greatest of several numbers, or of those of one list.
    fn extremum(&mut self, name: &str, values: Vec<Value>, place: Place) -> Read<Value> {
        let values = match <[Value; 1]>::try_from(values) {
            Ok([Value::List(list)]) if !list.has_rows() => list.values,
            Ok([one]) => {
                let message = format!("`{name}` of {} is not read", one.kind());
                return Err(self.refused(place, message, "give several numbers, or a list"));
            }
            Err(several) => several,
        };
        let mut found: Option<Term> = None;
        for value in values {
            let kind = value.kind();
            let next = match value {
                Value::Term(next) if !next.is_point => next,
                _ => {
                    let message = format!("`{name}` of {kind} is not read");
                    return Err(self.refused(place, message, "give numbers"));
                }
            };
            found = Some(match found {
                None => next,
                Some(before) => match (&before.constant, &next.constant) {
                    // The first of equal ones, as languages have it.
                    (Some(a), Some(b)) if a == b => before,
                    (Some(a), Some(b)) if (a > b) == (name == "max") => before,
                    (Some(_), Some(_)) => next,
                    _ => Term {
                        // It has the type of the one that it is.
                        kind: match before.kind == next.kind {
                            true => before.kind,
                            false => Kind::Unknown,
                        },
                        ..Term::call(name, vec![before, next])
                    },
                },
            });
        }
        match found {
            Some(found) => self.bounded(found, place),
            None => {
                let message = format!("`{name}` of nothing is not read");
                Err(self.refused(place, message, "give numbers"))
            }
        }
    }
}
