//! Sums and products of lists, and those of ranges whose ends are not fixed.

use super::bounds::Index;
use super::value::{Shape, Term, Value};
use super::{Frame, Runner, one};
use crate::grammar::Read;
use crate::program::{CodeLanguage, Kind, operation};
use std::sync::Arc;
use torse_numbers::Affine;
use torse_numbers::rational::integer;
use torse_syntax::derivation::DerivationError;
use torse_syntax::formula::{Expr, Node, Operator, Place};

impl Runner<'_> {
    /// The sum or the product of a list; of a range whose ends are not fixed, one of the language.
    pub(super) fn folded(
        &mut self,
        name: &str,
        list: &Expr,
        place: Place,
        frame: &mut Frame,
    ) -> Read<Value> {
        let operator = match name {
            operation::SUM | operation::TOTAL => Operator::Add,
            _ => Operator::Multiply,
        };
        let is_total = matches!(name, operation::TOTAL | operation::TOTAL_PRODUCT);
        if let Some(parts) = series(list) {
            let bounds = [parts.low, parts.high, parts.step];
            let mut values = vec![];
            for bound in bounds {
                values.push(self.value(bound, frame)?);
            }
            let is_fixed =
                |value: &Value| matches!(value, Value::Term(term) if term.constant.is_some());
            if let [Value::Term(low), Value::Term(high), Value::Term(step)] = values.as_slice()
                && !values.iter().all(is_fixed)
                && step.integer() == Some(1)
            {
                let (low, high) = (low.clone(), last(high.clone()));
                let value = self.series(operator, &parts, [low, high], place, frame)?;
                return match &value {
                    Value::Term(term) if term.is_point && is_total => Err(self.total(place)),
                    _ => Ok(value),
                };
            }
        }
        let values = self.value(list, frame)?;
        let is_iterator = matches!(&values, Value::List(list) if list.shape == Shape::Iterator);
        if name == operation::TOTAL_PRODUCT && is_iterator {
            let message = "NumPy makes no product of what is gone through once";
            return Err(self.refused(place, message, "give it a list"));
        }
        let mut all = self.items(values, place)?;
        if is_total {
            all = self.numbers(all, place)?;
        }
        let is_python = self.program.language == CodeLanguage::Python;
        let is_added =
            |value: &Value| !matches!(value, Value::List(list) if list.shape != Shape::Vector);
        if is_python && !all.iter().all(is_added) {
            let message = "a sum of lists is not read";
            return Err(self.refused(place, message, "numbers and arrays are added"));
        }
        let mut items = all.into_iter();
        let neutral = i64::from(operator == Operator::Multiply);
        let Some(first) = items.next() else {
            return Ok(Value::Term(Term::number(integer(neutral), true)));
        };
        let first = self.copied(first);
        items.try_fold(first, |sum, item| {
            self.spend(place)?;
            self.combined(operator, sum, item, place)
        })
    }

    /// All numbers of nested lists.
    fn numbers(&mut self, values: Vec<Value>, place: Place) -> Read<Vec<Value>> {
        let mut found = vec![];
        for value in values {
            self.spend(place)?;
            match value {
                Value::Term(term) if !term.is_point => found.push(Value::Term(term)),
                Value::List(list) if !matches!(list.shape, Shape::Iterator | Shape::Matrix) => {
                    found.extend(self.numbers(list.values, place)?);
                }
                _ => return Err(self.total(place)),
            }
        }
        Ok(found)
    }

    /// Refuses the sum of the coordinates of points.
    fn total(&self, place: Place) -> Box<DerivationError> {
        let message = "NumPy adds up all coordinates of points here";
        self.refused(place, message, "Python's own `sum` adds points")
    }

    /// `sum(i, low, high, body)`.
    fn series(
        &mut self,
        operator: Operator,
        parts: &Series<'_>,
        [low, high]: [Term; 2],
        place: Place,
        frame: &mut Frame,
    ) -> Read<Value> {
        let Node::Name(name) = &parts.variable.node else {
            let message = "a sum has one index";
            return Err(self.refused(parts.variable.place, message, "write `for i in range(n)`"));
        };
        // A name that a change of the program has put in may be none of the language.
        let mut index = name.trim_matches('_').to_owned();
        if !torse_syntax::formula::is_name(&index) {
            index = "i".to_owned();
        }
        while self.setting.is_declared(&index)
            || self.bound.iter().any(|own| own.name == index)
            || !self.symbols.is_index(&index)
        {
            index = format!("i{index}");
        }
        let outer = frame.hidden.len();
        let variable = Term::formula(Expr::name(&index), Kind::Whole);
        frame.hide(name, Value::Term(variable));
        self.bound.push(Index::new(&index, &low.expr, &high.expr));
        let body = self.value(parts.body, frame);
        self.bound.pop();
        frame.restore(outer);
        let Value::Term(body) = body? else {
            let message = "the terms of a sum whose ends are not fixed are numbers or points";
            return Err(self.refused(
                parts.body.place,
                message,
                "fix its ends: `--where 'n == 3'`",
            ));
        };
        let name = if operator == Operator::Add {
            "sum"
        } else {
            "product"
        };
        let index = Term::formula(Expr::name(&index), Kind::Whole);
        let (kind, is_point) = (body.kind, body.is_point);
        if is_point && operator == Operator::Multiply {
            let message = "a product of points is not read";
            return Err(self.refused(place, message, "points are added"));
        }
        let term = Term {
            kind,
            is_point,
            ..Term::call(name, vec![index, low, high, body])
        };
        self.bounded(term, place)
    }

    /// Whether a sum has terms, or just none, for all values of the symbols.
    pub(super) fn runs_upwards(&self, low: &Term, high: &Term) -> bool {
        let (Some(low), Some(high)) = (low.expr.affine(), high.expr.affine()) else {
            return false;
        };
        let count = high - low + Affine::number(1);
        let least = self.setting.declarations.least(&count);
        least.is_some_and(|least| least >= 0)
    }
}

/// A sum over a range.
struct Series<'e> {
    body: &'e Expr,
    variable: &'e Expr,
    low: &'e Expr,
    high: &'e Expr,
    step: &'e Expr,
}

/// A list made by a comprehension over a range.
fn series(list: &Expr) -> Option<Series<'_>> {
    let Node::Call(head, arguments) = &list.node else {
        return None;
    };
    let is = |head: &Arc<Expr>, name: &str| matches!(&head.node, Node::Name(own) if own == name);
    let [body, variable, values] = arguments.as_slice() else {
        return None;
    };
    let Node::Call(inner, bounds) = &values.node else {
        return None;
    };
    let [low, high, step] = bounds.as_slice() else {
        return None;
    };
    let is_list = is(head, operation::FOR) || is(head, operation::GENERATE);
    (is_list && is(inner, operation::RANGE)).then_some(Series {
        body,
        variable,
        low,
        high,
        step,
    })
}

/// The last integer below an end.
fn last(high: Term) -> Term {
    if let Some(value) = &high.constant {
        return Term::number(value - integer(1), true);
    }
    if let Node::Binary(Operator::Add, below, more) = &high.expr.node
        && matches!(&more.node, Node::Number { value, .. } if *value == integer(1))
    {
        return Term::formula((**below).clone(), high.kind);
    }
    high.joined(Operator::Subtract, one())
}
