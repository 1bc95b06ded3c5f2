//! Assertions: a function has a value only where they hold, so they are hypotheses of the comparison.

use super::conditions::holds;
use super::symbols::free_names;
use super::value::Value;
use super::{Frame, Runner};
use crate::grammar::Read;
use std::sync::Arc;
use torse_syntax::formula::{Connective, Expr, Node, Place};

/// What a condition demands.
enum Demand {
    /// Nothing, or what is never so.
    Constant(bool),
    /// This, of the symbols.
    Formula(Expr),
}

impl Runner<'_> {
    /// Notes what an assertion demands, or that it is not read.
    pub(super) fn assert(
        &mut self,
        condition: Option<&Expr>,
        place: Place,
        frame: &Frame,
    ) -> Read<()> {
        let calls = self.calls;
        // An index of a sum is no symbol outside of it.
        let condition = condition.filter(|_| self.bound.is_empty());
        let demand =
            condition.and_then(|condition| self.demand(condition, &mut frame.clone()).ok());
        self.calls = calls;
        match demand {
            Some(Demand::Constant(true)) => {}
            Some(Demand::Constant(false)) => {
                let message = "this assertion does not hold";
                let help = "give the function arguments for which it has a value";
                return Err(self.refused(place, message, help));
            }
            Some(Demand::Formula(formula)) if self.is_declared(&formula) => {
                self.demands.push(formula.placeless());
            }
            _ => {
                self.unread_demand.get_or_insert(place);
            }
        }
        Ok(())
    }

    fn is_declared(&self, formula: &Expr) -> bool {
        let names = free_names(formula);
        names.iter().all(|name| self.setting.is_declared(name))
    }

    fn demand(&mut self, condition: &Expr, frame: &mut Frame) -> Read<Demand> {
        match &condition.node {
            Node::Compare(first, rest) => {
                let mut left = self.value(first, frame)?;
                let mut all = Demand::Constant(true);
                for (relation, right) in rest {
                    let right = self.value(right, frame)?;
                    let (Value::Term(a), Value::Term(b)) = (&left, &right) else {
                        let message = format!("{} is compared with {}", left.kind(), right.kind());
                        return Err(self.refused(condition.place, message, "numbers are compared"));
                    };
                    if a.is_point || b.is_point {
                        let message = "arrays are compared entry by entry";
                        return Err(self.refused(condition.place, message, "numbers are compared"));
                    }
                    let one = match (&a.constant, &b.constant) {
                        (Some(a), Some(b)) => Demand::Constant(holds(*relation, a, b)),
                        _ => Demand::Formula(Expr::made(Node::Compare(
                            Arc::new(a.expr.clone()),
                            vec![(*relation, b.expr.clone())],
                        ))),
                    };
                    all = all.joined(Connective::And, one);
                    left = right;
                }
                Ok(all)
            }
            Node::Join(connective @ (Connective::And | Connective::Or), left, right) => {
                let left = self.demand(left, frame)?;
                Ok(left.joined(*connective, self.demand(right, frame)?))
            }
            Node::Not(inner) => Ok(match self.demand(inner, frame)? {
                Demand::Constant(is_true) => Demand::Constant(!is_true),
                Demand::Formula(formula) => {
                    Demand::Formula(Expr::made(Node::Not(Arc::new(formula))))
                }
            }),
            _ => self.truth(condition, frame).map(Demand::Constant),
        }
    }
}

impl Demand {
    /// Both, or one of both.
    fn joined(self, connective: Connective, other: Self) -> Self {
        // True decides an alternative, false a conjunction; the other constant says nothing.
        let decides = connective == Connective::Or;
        match (self, other) {
            (Self::Constant(is_true), other) | (other, Self::Constant(is_true)) => {
                match is_true == decides {
                    true => Self::Constant(is_true),
                    false => other,
                }
            }
            (Self::Formula(a), Self::Formula(b)) => {
                Self::Formula(Expr::made(Node::Join(connective, Arc::new(a), Arc::new(b))))
            }
        }
    }
}
