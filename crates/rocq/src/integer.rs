//! Integer terms: indices, degrees, bounds of sums, exponents.

use crate::code::{Code, Level};
use crate::context::{Context, Kind};
use crate::gap::Untranslatable;
use std::sync::Arc;
use torse_core::{Node, Set, Term};
use torse_numbers::{Affine, rational};
use torse_syntax::formula::Operator;

/// A literal integer, through definitions.
#[must_use]
pub fn literal(term: &Term) -> Option<i64> {
    match &*term.node {
        Node::Number(value) => value
            .is_integer()
            .then(|| value.numer().to_string().parse().ok())?,
        Node::Negative(inner) => literal(inner)?.checked_neg(),
        Node::Opened { body, .. } => literal(body),
        Node::Binary(operator, a, b) => {
            let (a, b) = (literal(a)?, literal(b)?);
            match operator {
                Operator::Add => a.checked_add(b),
                Operator::Subtract => a.checked_sub(b),
                Operator::Multiply => a.checked_mul(b),
                _ => None,
            }
        }
        _ => None,
    }
}

/// Writes an integer-affine form in the scope of integers.
///
/// # Errors
/// [`Untranslatable::Unread`] for a symbol that the claim does not declare.
pub fn affine(context: &Context<'_>, form: &Affine) -> Result<String, Untranslatable> {
    let mut text = String::new();
    for (symbol, multiple) in form.multiples() {
        let name = context.symbol(&Arc::from(symbol))?;
        let sign = match (multiple < 0, text.is_empty()) {
            (true, true) => "- ",
            (true, false) => " - ",
            (false, true) => "",
            (false, false) => " + ",
        };
        text.push_str(sign);
        match multiple.unsigned_abs() {
            1 => text.push_str(name),
            n => text.push_str(&format!("{n} * {name}")),
        }
    }
    let constant = form.constant();
    Ok(match (text.is_empty(), constant) {
        (true, constant) => constant.to_string(),
        (false, 0) => text,
        (false, ..0) => format!("{text} - {}", constant.unsigned_abs()),
        (false, _) => format!("{text} + {constant}"),
    })
}

/// Whether a term is literally the number 0, which fits every shape.
#[must_use]
pub fn is_zero(term: &Term) -> bool {
    match &*term.node {
        Node::Number(value) => *value == rational::integer(0),
        Node::Opened { body, .. } => is_zero(body),
        _ => false,
    }
}

impl Context<'_> {
    /// Writes the term in the scope of integers, if it is built of integers by sums, differences and products.
    #[must_use]
    pub fn integer(&self, term: &Term) -> Option<Code> {
        match &*term.node {
            Node::Number(value) if value.is_integer() => Some(Code::rational(value)),
            Node::Symbol(name) => match self.symbols.get(name)? {
                Set::Integer { .. } => Some(Code::atom(self.symbol(name).ok()?)),
                _ => None,
            },
            Node::Variable(variable) => {
                if let Some(number) = self.constant_value(term) {
                    return Some(Code::rational(&rational::integer(number)));
                }
                let local = self.local(variable).ok()?;
                (local.kind == Kind::Integer).then(|| local.code.clone())
            }
            Node::Negative(inner) => {
                let inner = self.integer(inner)?;
                Some(Code::new(
                    format!("- {}", inner.within(Level::Negative)),
                    Level::Negative,
                ))
            }
            Node::Opened { body, .. } => self.integer(body),
            Node::Binary(operator, a, b) => {
                // Variables that stand for literal integers are computed; printed integers are not.
                if let (Some(number), None) = (self.constant_value(term), literal(term)) {
                    return Some(Code::rational(&rational::integer(number)));
                }
                let (a, b) = (self.integer(a)?, self.integer(b)?);
                let (sign, level) = match operator {
                    Operator::Add => ("+", Level::Sum),
                    Operator::Subtract => ("-", Level::Sum),
                    Operator::Multiply => ("*", Level::Product),
                    Operator::Divide | Operator::Power => return None,
                };
                Some(Code::infix(&a, sign, &b, level))
            }
            _ => None,
        }
    }
}
