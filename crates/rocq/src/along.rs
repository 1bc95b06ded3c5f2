//! Coefficients along `given` equations.
//!
//! The unknowns of a claim are functions of the other symbols. Where a form has unknowns, its coefficient of a symbol is
//! the derivative along the solutions (`derivations/SEMANTICS.md`). So a statement with the coefficient of `p0` in a form
//! with the unknown `A` is about every function `A_of_p0` whose values are solutions: it has the value `A` at the symbol's
//! own value, and `forall p0, ...` the equations with `A_of_p0 p0` for `A`. The coefficient is
//! `Derive_n (fun p0 => form with A_of_p0 p0) 1 p0`.

use crate::binder::Binder;
use crate::code::{Code, Level};
use crate::context::Context;
use crate::defined::mentions;
use crate::gap::Gap;
use crate::unknowns::{Along, FUNCTION};
use std::sync::Arc;
use torse_language::core::{Claim, Node, Set, Source, Statement, Term};
use torse_language::syntax::{Connective, Relation};

/// What a statement with such functions has besides.
#[derive(Debug, Clone, Default)]
pub struct Functions {
    /// The functions, bound.
    pub binders: Vec<Binder>,
    /// That their values are solutions.
    pub premises: Vec<Code>,
}

impl Context<'_> {
    /// The unknowns as functions of this symbol, named where it is met first.
    ///
    /// # Errors
    /// [`Gap`] for unknowns that are no plain numbers.
    pub(crate) fn along(&mut self, symbol: &Arc<str>, unknowns: &[Term]) -> Result<Along, Gap> {
        if let Some(known) = self.alongs().iter().find(|along| along.symbol == *symbol) {
            return Ok(known.clone());
        }
        let name = self.symbol(symbol)?.to_owned();
        let mut functions = vec![];
        for unknown in unknowns {
            let (Node::Symbol(declared) | Node::Vector(declared, None)) = &*unknown.node else {
                return Err(Gap::Theory(
                    "coefficients along equations for members or coordinates",
                ));
            };
            let own = self.symbol(declared)?.to_owned();
            functions.push((
                Arc::clone(declared),
                self.fresh(&format!("{own}_of_{name}")),
            ));
        }
        let along = Along {
            symbol: Arc::clone(symbol),
            name,
            functions,
        };
        self.add_along(along.clone());
        Ok(along)
    }
}

/// The functions that a statement needs, and that their values solve the equations.
///
/// # Errors
/// [`Gap`] for equations that are not defined for every value of the symbol.
pub fn functions(context: &mut Context<'_>, claim: &Claim) -> Result<Functions, Gap> {
    let mut all = Functions::default();
    for along in context.alongs().to_vec() {
        for (unknown, function) in &along.functions {
            all.binders.push(Binder {
                symbol: Arc::clone(unknown),
                names: vec![function.clone()],
                rocq_type: FUNCTION.to_owned(),
                together: None,
            });
            let value = Code::apply(function, &[Code::atom(&along.name)]);
            let here = Code::atom(context.symbol(unknown)?);
            all.premises
                .push(Code::infix(&value, "=", &here, Level::Relation));
        }
        // The symbol takes every value here, so its set is to be the line.
        if !matches!(context.symbols.get(&along.symbol), Some(Set::Real(interval)) if interval.lower.is_none() && interval.upper.is_none())
            && !matches!(context.symbols.get(&along.symbol), Some(Set::Vector(None)))
        {
            return Err(Gap::Theory(
                "coefficients of symbols of an interval along equations",
            ));
        }
        let given = claim
            .hypotheses
            .iter()
            .filter(|h| h.source == Source::Given);
        for hypothesis in given {
            if !is_equation(&hypothesis.statement) {
                return Err(Gap::Theory(
                    "coefficients along what is more than equations",
                ));
            }
            let defined = crate::said::defined(context, [&hypothesis.statement])?;
            let moves = |text: &str| {
                mentions(text, &along.name)
                    || along.functions.iter().any(|(unknown, _)| {
                        context
                            .symbol(unknown)
                            .is_ok_and(|name| mentions(text, name))
                    })
            };
            if defined.iter().any(|premise| moves(premise.text())) {
                return Err(Gap::Theory(
                    "equations that divide by what moves along them",
                ));
            }
            let before = context.moved(along.values());
            let equations = crate::said::said(context, &hypothesis.statement, claim);
            context.moved(before);
            let text = format!("forall {} : R, {}", along.name, equations?.text());
            all.premises.push(Code::new(text, Level::Open));
        }
    }
    Ok(all)
}

/// Whether a statement says equations and nothing else: only these hold for every value of the symbol.
fn is_equation(statement: &Statement) -> bool {
    match statement {
        Statement::Join(Connective::And, a, b) => is_equation(a) && is_equation(b),
        Statement::Compare { relation, .. } => *relation == Relation::Equal,
        _ => false,
    }
}
