//! The Taylor polynomials of roots and logarithms around the point of a derivative.
//!
//! With `r_k` the k-th derivative of the argument at u over k!, the coefficients follow from the function's equation:
//!
//! - the square of a root is r, so `c_0 = w = sqrt(r(u))` and `c_k = (r_k - sum of c_j c_(k-j) for 0 < j < k)/(2 c_0)`;
//! - the derivative of a logarithm c times r is that of r, so `c_0 = w = log(r(u))` and
//!   `c_k = (r_k - sum of j/k c_j r_(k-j) for 0 < j < k)/r_0`;
//! - the derivative of an arc times q is that of r, where q is `1 + r^2` or the cosine of the arc, see `arc`.
//!
//! The first two are defined where r(u) > 0, an arc sine where r(u) is between -1 and 1.

use super::arc::arc_series;
use super::{Around, Implicit, Work, binary, made, nothing, replaced};
use crate::{Node, Term, Variable};
use std::sync::Arc;
use torse_numbers::fault_injection::{InjectedFault, injected};
use torse_numbers::rational::integer;
use torse_syntax::fault::Fault;
use torse_syntax::formula::Operator;

/// The number of the first variable made here; the variables of texts have smaller numbers.
const FIRST_VARIABLE: u32 = u32::MAX / 2;
/// The largest order of a derivative.
const MAX_ORDER: u32 = 4;

impl Work {
    /// The Taylor polynomial; `expanded` is the argument with its own roots and logarithms expanded.
    pub(super) fn series(
        &mut self,
        function: Implicit,
        argument: &Term,
        expanded: &Term,
        around: &Around<'_>,
    ) -> Result<Term, Fault> {
        let place = argument.place;
        let order = around.order.filter(|order| *order <= MAX_ORDER);
        let order = order.ok_or_else(|| {
            let noun = function.noun();
            let what =
                format!("{noun} under a derivative that is not of an order up to {MAX_ORDER}");
            Fault::limit(place, what)
        })?;
        let number = |n: u32| made(Node::Number(integer(i64::from(n))), place);
        let at_point = replaced(argument, around.variable.number(), around.at);
        let at_point = self.term(&at_point, around.scope)?;
        let first = self.symbol(function, at_point.clone(), place, around.scope)?;
        let mut factorial = 1;
        let mut rates = vec![at_point];
        for k in 1..=order {
            factorial *= k;
            let rate = self.rate(expanded, k, around);
            rates.push(binary(Operator::Divide, rate, number(factorial)));
        }
        let coefficients = match function {
            Implicit::Root => root_series(first, &rates),
            Implicit::Logarithm => logarithm_series(first, &rates),
            Implicit::Arc(function) => arc_series(function, first, &rates),
        };
        let variable = made(Node::Variable(around.variable.clone()), place);
        let step = binary(Operator::Subtract, variable, around.at.clone());
        let mut terms = coefficients.into_iter().zip(0..);
        let first = terms.next().ok_or_else(|| nothing(place))?.0;
        Ok(terms.fold(first, |sum, (coefficient, k)| {
            let power = binary(Operator::Power, step.clone(), number(k));
            let product = binary(Operator::Multiply, coefficient, power);
            binary(Operator::Add, sum, product)
        }))
    }

    /// The derivative of the argument of the given order at the point.
    fn rate(&mut self, argument: &Term, order: u32, around: &Around<'_>) -> Term {
        let place = argument.place;
        let variable = Variable {
            number: FIRST_VARIABLE.saturating_add(self.variables),
            name: Arc::clone(&around.variable.name),
        };
        self.variables += 1;
        let own = made(Node::Variable(variable.clone()), place);
        let body = replaced(argument, around.variable.number(), &own);
        let node = Node::Derivative {
            order: made(Node::Number(integer(i64::from(order))), place),
            closed: body.is_closed_but_for(variable.number()),
            variable,
            body,
            at: around.at.clone(),
        };
        made(node, place)
    }
}

/// The coefficients of a root with this value, of a radicand with these coefficients.
fn root_series(first: Term, rates: &[Term]) -> Vec<Term> {
    let two = made(Node::Number(integer(2)), first.place);
    let twice = binary(Operator::Multiply, two, first.clone());
    let mut coefficients = vec![first];
    for rate in rates.iter().skip(1) {
        let mut left = rate.clone();
        let before = coefficients.iter().skip(1);
        for (a, b) in before.clone().zip(before.rev()) {
            let product = binary(Operator::Multiply, a.clone(), b.clone());
            left = binary(Operator::Subtract, left, product);
        }
        coefficients.push(binary(Operator::Divide, left, twice.clone()));
    }
    coefficients
}

/// The coefficients of a logarithm with this value, of an argument with these coefficients.
fn logarithm_series(first: Term, rates: &[Term]) -> Vec<Term> {
    let place = first.place;
    let mut coefficients = vec![first];
    let Some(value) = rates.first() else {
        return coefficients;
    };
    for (rate, k) in rates.iter().zip(0_i64..).skip(1) {
        let mut left = rate.clone();
        let before = coefficients.iter().zip(0_i64..).skip(1);
        // c_j beside r_(k-j)
        for ((own, j), other) in before.zip(rates.iter().skip(1).take(coefficients.len() - 1).rev())
        {
            if injected(InjectedFault::LogarithmWithoutEarlier) {
                continue;
            }
            let share = made(
                Node::Number(torse_numbers::Rational::new(j.into(), k.into())),
                place,
            );
            let product = binary(Operator::Multiply, own.clone(), other.clone());
            let product = binary(Operator::Multiply, share, product);
            left = binary(Operator::Subtract, left, product);
        }
        coefficients.push(binary(Operator::Divide, left, value.clone()));
    }
    coefficients
}
