//! Roots and logarithms that are not there.
//!
//! That a radicand is not negative, and that the argument of a logarithm has a value and is positive, is part of what a
//! statement means: no verdict says so, and where it is not so the statement says nothing. That a divisor is zero is of interest only elsewhere. So where a
//! part of a statement divides by zero its roots and logarithms are asked as well, wherever they stand in it; those with
//! the index of a sum or the variable of an integral are left out.

use super::environment::Environment;
use super::evaluate::Evaluator;
use crate::arithmetic::Arithmetic;
use crate::no_value::{NoValue, Undefined};
use torse_syntax::formula::{Expr, Node};

/// The most parts that are visited.
const MAX_PARTS: usize = 400;

impl<'a, A: Arithmetic> Evaluator<'a, '_, A> {
    /// Why a statement that divides by zero says nothing here: a root or a logarithm in it is undefined, or it is not known
    /// whether one is, or else the division.
    pub(super) fn divides_by_zero(
        &self,
        tree: &'a Expr,
        place: &Environment<'a, A::Number>,
    ) -> NoValue {
        let mut parts = 0;
        let mut open = None;
        match self.outside(tree, place, &mut parts, &mut open) {
            Some(why) => why.into(),
            None => open.unwrap_or(NoValue::Undefined(Undefined::ZeroDivisor)),
        }
    }

    fn outside(
        &self,
        tree: &'a Expr,
        place: &Environment<'a, A::Number>,
        parts: &mut usize,
        open: &mut Option<NoValue>,
    ) -> Option<Undefined> {
        *parts += 1;
        if *parts > MAX_PARTS {
            return None;
        }
        let mut within = |tree: &'a Expr| self.outside(tree, place, parts, open);
        match &tree.node {
            Node::Number { .. } => None,
            Node::Name(name) => {
                let definition = self.declarations.definition(name);
                let hidden = place.local(name).is_some();
                let definition = definition.filter(|own| !hidden && own.parameters.is_empty())?;
                let outside = place.outside();
                self.outside(&definition.body.expr, &outside, parts, open)
            }
            Node::Negative(inner) | Node::Not(inner) => within(inner),
            Node::Binary(_, a, b) | Node::Join(_, a, b) => within(a).or_else(|| within(b)),
            Node::List(items) => items.iter().find_map(within),
            Node::Index(head, _) => within(head),
            Node::Compare(first, rest) => {
                within(first).or_else(|| rest.iter().find_map(|(_, side)| within(side)))
            }
            Node::Call(head, arguments) => {
                let name = match &head.node {
                    Node::Name(name) => self.built_in(name, place),
                    _ => None,
                };
                match (name, arguments.as_slice()) {
                    (Some("sum" | "product" | "integral" | "fails"), _) => None,
                    (Some("at"), [inner, name, point]) => {
                        let bound = self.bind_at(name, point, place).ok()?;
                        self.outside(inner, &bound, parts, open)
                    }
                    (Some(name @ ("sqrt" | "log" | "atan" | "asin" | "acos")), [inner]) => {
                        let found = within(inner);
                        found.or_else(|| match self.value(tree, place) {
                            // The argument of a logarithm has a value, and that is positive.
                            Err(NoValue::Undefined(_)) if name == "log" => {
                                Some(Undefined::NoLogarithm)
                            }
                            // That of an arc has a value.
                            Err(NoValue::Undefined(_)) if name != "sqrt" => Some(Undefined::NoArc),
                            Err(NoValue::Undefined(why @ Undefined::NegativeRoot)) => Some(why),
                            Err(gap @ NoValue::Unknown(_)) => {
                                open.get_or_insert(gap);
                                None
                            }
                            _ => None,
                        })
                    }
                    _ => arguments.iter().find_map(within),
                }
            }
        }
    }
}
