//! The signs that formulas have by the way they are written, wherever the terms without existential numbers have values.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use torse_core::{BuiltIn, Node, Statement, Term};
use torse_numbers::rational::{Rational, integer};
use torse_syntax::derivation::declarations::{Declarations, SymbolKind};
use torse_syntax::formula::{Connective, Operator, Relation};

/// The least part of the numbers in which a value lies, wherever the terms without existential numbers have one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Sign {
    /// A number, or a vector.
    Any,
    /// At least zero.
    Nonnegative,
    /// More than zero.
    Positive,
}

/// The value of a bound variable: its sign, `None` if it may have no value; and whether an existential number stands in it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bound {
    pub sign: Option<Sign>,
    pub is_existential: bool,
}

/// The variables of the enclosing binders, by their numbers.
pub(super) type Scope = BTreeMap<u32, Bound>;

/// What is given about single symbols.
pub(crate) struct Signs<'d> {
    declarations: &'d Declarations,
    stated: BTreeMap<Arc<str>, Sign>,
}

impl<'d> Signs<'d> {
    /// The signs of the symbols by their declared sets, and by those parts of the hypotheses that compare one with a number.
    pub(crate) fn new<'s>(
        declarations: &'d Declarations,
        hypotheses: impl IntoIterator<Item = &'s Statement>,
    ) -> Self {
        let mut signs = Self {
            declarations,
            stated: BTreeMap::new(),
        };
        hypotheses.into_iter().for_each(|own| signs.note(own));
        signs
    }

    /// The same with the premise of an implication.
    pub(crate) fn with(mut self, premise: &Statement) -> Self {
        self.note(premise);
        self
    }

    fn note(&mut self, hypothesis: &Statement) {
        match hypothesis {
            Statement::Join(Connective::And, a, b) => {
                self.note(a);
                self.note(b);
            }
            Statement::Compare {
                relation,
                left,
                right,
            } => {
                let (symbol, number, strict) = match (&*left.node, relation, &*right.node) {
                    (Node::Symbol(s), Relation::Greater, Node::Number(n))
                    | (Node::Number(n), Relation::Less, Node::Symbol(s)) => (s, n, true),
                    (Node::Symbol(s), Relation::AtLeast, Node::Number(n))
                    | (Node::Number(n), Relation::AtMost, Node::Symbol(s)) => (s, n, false),
                    _ => return,
                };
                if let Some(sign) = above(number, strict) {
                    let stated = self.stated.entry(Arc::clone(symbol)).or_insert(sign);
                    *stated = sign.max(*stated);
                }
            }
            _ => {}
        }
    }

    /// The sign of a term; `None` if it may have no value where the terms without existential numbers have one. All of a witness is
    /// put in for an existential number, so nothing in it has a value for that reason.
    pub(super) fn sign(&self, term: &Term, scope: &Scope, is_witness: bool) -> Option<Sign> {
        let is_excused = !is_witness && !has_existential(term, scope);
        let sign = self.written_sign(term, scope, is_witness);
        match is_excused {
            true => Some(sign.unwrap_or(Sign::Any)),
            false => sign,
        }
    }

    fn written_sign(&self, term: &Term, scope: &Scope, is_witness: bool) -> Option<Sign> {
        let sign = |part: &Term| self.sign(part, scope, is_witness);
        match &*term.node {
            Node::Number(number) => Some(above(number, false).unwrap_or(Sign::Any)),
            Node::Pi => Some(Sign::Positive),
            Node::Symbol(name) => Some(self.symbol(name)),
            Node::Variable(variable) => match scope.get(&variable.number()) {
                Some(bound) => bound.sign,
                None => None,
            },
            Node::Vector(..) => Some(Sign::Any),
            Node::Negative(inner) => sign(inner).map(|_| Sign::Any),
            Node::Binary(operator, a, b) => {
                let is_square = Arc::ptr_eq(&a.node, &b.node);
                match operator {
                    Operator::Power => self.power(a, b, &sign),
                    Operator::Divide => {
                        let (above, below) = (sign(a)?, sign(b)?);
                        (below == Sign::Positive).then_some(above)
                    }
                    Operator::Add => {
                        let (a, b) = (sign(a)?, sign(b)?);
                        Some(if a.min(b) == Sign::Any {
                            Sign::Any
                        } else {
                            a.max(b)
                        })
                    }
                    Operator::Multiply => {
                        let product = sign(a)?.min(sign(b)?);
                        Some(if is_square {
                            product.max(Sign::Nonnegative)
                        } else {
                            product
                        })
                    }
                    Operator::Subtract => {
                        sign(a)?;
                        sign(b)?;
                        Some(Sign::Any)
                    }
                }
            }
            Node::List(items) => items
                .iter()
                .try_fold(Sign::Any, |any, item| sign(item).map(|_| any)),
            Node::Let {
                variable,
                value,
                body,
            } => {
                // A value that is not used has to be one, too.
                let mut inside = scope.clone();
                let bound = Bound {
                    sign: Some(sign(value)?),
                    is_existential: is_witness || has_existential(value, scope),
                };
                inside.insert(variable.number(), bound);
                self.sign(body, &inside, is_witness)
            }
            Node::Opened { body, .. } => sign(body),
            Node::Apply(function, arguments) => {
                let arguments = arguments.iter().map(sign).collect::<Option<Vec<Sign>>>()?;
                match (function, arguments.as_slice()) {
                    (BuiltIn::Exponential, [_]) => Some(Sign::Positive),
                    (BuiltIn::Norm, [_]) => Some(Sign::Nonnegative),
                    (BuiltIn::SquareRoot, [radicand]) if *radicand >= Sign::Nonnegative => {
                        Some(*radicand)
                    }
                    (BuiltIn::Logarithm, [Sign::Positive]) => Some(Sign::Any),
                    // An arc tangent has the sign of its argument.
                    (BuiltIn::ArcTangent, [argument]) => Some(*argument),
                    (
                        BuiltIn::Sine
                        | BuiltIn::Cosine
                        | BuiltIn::Dot
                        | BuiltIn::Cross
                        | BuiltIn::Determinant,
                        _,
                    ) => Some(Sign::Any),
                    _ => None,
                }
            }
            Node::Member(..)
            | Node::Basis { .. }
            | Node::Entry(..)
            | Node::Sum { .. }
            | Node::Product { .. }
            | Node::Integral { .. }
            | Node::Derivative { .. } => None,
        }
    }

    /// The sign of a power with a number as exponent.
    fn power(
        &self,
        base: &Term,
        exponent: &Term,
        sign: &impl Fn(&Term) -> Option<Sign>,
    ) -> Option<Sign> {
        let base = sign(base)?;
        let Node::Number(exponent) = &*exponent.node else {
            return None;
        };
        let is_even = (exponent / integer(2)).is_integer();
        match base {
            _ if !exponent.is_integer() => None,
            Sign::Positive => Some(Sign::Positive),
            _ if *exponent < integer(0) => None,
            _ if is_even => Some(Sign::Nonnegative),
            base => Some(base),
        }
    }

    fn symbol(&self, name: &Arc<str>) -> Sign {
        let stated = self.stated.get(name).copied().unwrap_or(Sign::Any);
        let declared = match self.declarations.symbol(name) {
            Some(SymbolKind::Real(interval)) => (interval.lower.as_ref())
                .and_then(|end| above(end.value.as_rational()?, !end.closed)),
            Some(SymbolKind::Integer {
                least: Some(least), ..
            }) => least
                .as_number()
                .and_then(|least| above(&integer(least), false)),
            _ => None,
        };
        stated.max(declared.unwrap_or(Sign::Any))
    }
}

/// The sign of all numbers above this one, or from it on.
fn above(number: &Rational, strict: bool) -> Option<Sign> {
    let zero = integer(0);
    if *number > zero || (strict && *number == zero) {
        Some(Sign::Positive)
    } else if *number == zero {
        Some(Sign::Nonnegative)
    } else {
        None
    }
}

/// Whether an existential number stands in a term, directly or in what is bound to a variable in it. Shared parts are visited once.
pub(super) fn has_existential(term: &Term, scope: &Scope) -> bool {
    let mut seen: BTreeSet<usize> = BTreeSet::new();
    let mut pending = vec![term];
    while let Some(term) = pending.pop() {
        if let Node::Variable(variable) = &*term.node
            && scope
                .get(&variable.number())
                .is_some_and(|bound| bound.is_existential)
        {
            return true;
        }
        if seen.insert(Arc::as_ptr(&term.node).addr()) {
            pending.extend(term.parts());
            // Seeds and step may name the number themselves.
            if let Node::Basis { family, .. } = &*term.node {
                pending.extend(family.formulas());
            }
        }
    }
    false
}
