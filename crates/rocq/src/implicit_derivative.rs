//! Coefficients along `given` equations.
//!
//! The unknowns of a claim are functions of the other symbols. If a form has unknowns, its coefficient of a symbol is
//! the derivative along the solutions (`derivations/SEMANTICS.md`). So a statement with the coefficient of `p0` in a
//! form with the unknown `A` is about every function `A_of_p0` whose values are solutions: it has the value `A` at the
//! symbol's own value, and satisfies, `forall p0, ...`, the equations with `A_of_p0 p0` for `A`. The coefficient is
//! `Derive_n (fun p0 => form with A_of_p0 p0) 1 p0`. If the symbol is a member `Q k` of a family, it is a variable t
//! and `update1 Q k t` stands for the family; if an unknown is a member `P 0`, `update1 P 0 (P_0_of_t t)` does.

use crate::binder::Binder;
use crate::code::{Code, Level};
use crate::context::Context;
use crate::defined::mentions;
use crate::gap::Untranslatable;
use crate::unknowns::{Along, FUNCTION, Function};
use std::sync::Arc;
use torse_core::{Claim, Set, Source, Statement, Term};
use torse_syntax::formula::{Connective, Relation};

/// The additional parts of a statement with such functions.
#[derive(Debug, Clone, Default)]
pub struct Functions {
    /// The functions, bound.
    pub binders: Vec<Binder>,
    /// The premises that their values are solutions.
    pub premises: Vec<Code>,
}

impl Context<'_> {
    /// Introduces the unknowns as functions of `symbol`, reusing earlier names.
    ///
    /// # Errors
    /// [`Untranslatable`] for unknowns that are not plain numbers.
    pub(crate) fn along(
        &mut self,
        symbol: &Term,
        unknowns: &[Term],
    ) -> Result<Along, Untranslatable> {
        let place = self.place(symbol)?;
        let own = place.own();
        if let Some(known) = self.alongs().iter().find(|along| along.own == own) {
            return Ok(known.clone());
        }
        let (family, is_member) = (Arc::clone(&place.declared), place.is_member());
        let variable = match is_member {
            true => self.fresh("t"),
            false => place.name.clone(),
        };
        let mut along = Along {
            symbol: Arc::clone(&family),
            own,
            moved: vec![],
            functions: vec![],
            has_members: is_member,
            variable,
        };
        if is_member {
            let changed = place.with(&place.name, &Code::atom(&along.variable))?;
            along.moved.push((Arc::clone(&family), changed.argument()));
        }
        for unknown in unknowns {
            let place = self.place(unknown)?;
            let like = match place.label() {
                Some(label) => format!("{}_{label}_of_{}", place.name, along.variable),
                None => format!("{}_of_{}", place.name, along.variable),
            };
            let name = self.fresh(&like);
            let value = Code::apply(&name, &[Code::atom(&along.variable)]);
            // Members of one family are replaced one after the other.
            let known = along
                .moved
                .iter()
                .position(|(own, _)| *own == place.declared);
            let before = known.map(|known| along.moved.swap_remove(known).1);
            let changed = place.with(&before.unwrap_or_else(|| place.name.clone()), &value)?;
            along
                .moved
                .push((Arc::clone(&place.declared), changed.argument()));
            along.has_members |= place.is_member();
            along.functions.push(Function {
                unknown: Arc::clone(&place.declared),
                name,
                own: place.own(),
            });
        }
        self.add_along(along.clone());
        Ok(along)
    }
}

/// Returns the functions that a statement needs, and the premises that their values solve the equations.
///
/// # Errors
/// [`Untranslatable`] for equations that are not defined for every value of the symbol.
pub fn functions(context: &mut Context<'_>, claim: &Claim) -> Result<Functions, Untranslatable> {
    let mut all = Functions::default();
    for along in context.alongs().to_vec() {
        for function in &along.functions {
            all.binders.push(Binder {
                symbol: Arc::clone(&function.unknown),
                names: vec![function.name.clone()],
                rocq_type: FUNCTION.to_owned(),
                together: None,
            });
            let value = Code::apply(&function.name, std::slice::from_ref(&along.own));
            let premise = Code::infix(&value, "=", &function.own, Level::Relation);
            all.premises.push(premise);
        }
        // The symbol takes every value here, so its set must be the line.
        let is_line = match context.symbols.get(&along.symbol) {
            Some(Set::Real(interval)) => interval.lower.is_none() && interval.upper.is_none(),
            Some(Set::Vector(None) | Set::Family { .. }) => true,
            _ => false,
        };
        if !is_line {
            return Err(Untranslatable::Theory(
                "coefficients of symbols of an interval along equations",
            ));
        }
        let given = claim
            .hypotheses
            .iter()
            .filter(|h| h.source == Source::Given);
        for hypothesis in given {
            if !is_equation(&hypothesis.statement) {
                return Err(Untranslatable::Theory(
                    "coefficients along what is more than equations",
                ));
            }
            let defined = crate::translation::defined(context, [&hypothesis.statement])?;
            let moves = |text: &str| {
                let moving = along.moved.iter().map(|(declared, _)| declared);
                moving.chain([&along.symbol]).any(|declared| {
                    let name = context.symbol(declared);
                    name.is_ok_and(|name| mentions(text, name))
                })
            };
            if defined.iter().any(|premise| moves(premise.text())) {
                return Err(Untranslatable::Theory(
                    "equations that divide by what moves along them",
                ));
            }
            let before = context.moved(along.moved.clone());
            let equations =
                crate::translation::translate_statement(context, &hypothesis.statement, claim);
            context.moved(before);
            let text = format!("forall {} : R, {}", along.variable, equations?.text());
            all.premises.push(Code::new(text, Level::Open));
        }
    }
    Ok(all)
}

/// Whether a statement consists of equations: only these hold for every value of the symbol.
fn is_equation(statement: &Statement) -> bool {
    match statement {
        Statement::Join(Connective::And, a, b) => is_equation(a) && is_equation(b),
        Statement::Compare { relation, .. } => *relation == Relation::Equal,
        _ => false,
    }
}
