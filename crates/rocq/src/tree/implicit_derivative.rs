//! Coefficients along `given` equations: the unknowns are functions of the symbol whose coefficient is asked for.
//!
//! A statement with the coefficient of `p0` in a form with the unknown `A` is about every function `A_of_p0` with
//! `A_of_p0 p0 = A` whose values solve the equations for every `p0`.

use super::forms::derivative;
use super::moving::Along;
use super::scope::{Scope, words};
use super::writer::{Writer, fresh};
use crate::binder::Binder;
use crate::code::{Code, Level};
use crate::gap::Untranslatable;
use crate::place::Place;
use std::collections::BTreeSet;
use std::sync::Arc;
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::formula::{Connective, Expr, Node, Relation};

impl Writer<'_> {
    /// The declared names of what equations determine.
    pub fn unknown_names(&self) -> BTreeSet<String> {
        let reach = self.unknowns.iter().map(|unknown| {
            let head = match &unknown.node {
                Node::Index(head, _) => head,
                _ => unknown,
            };
            self.reach(head, &Scope::default()).symbols
        });
        reach.flatten().collect()
    }

    /// The coefficient of a symbol along the equations.
    ///
    /// # Errors
    /// [`Untranslatable`] for unknowns that are no plain numbers.
    pub fn coefficient_along(
        &mut self,
        form: &Expr,
        scope: &Scope,
        place: &Place,
    ) -> Result<Code, Untranslatable> {
        let along = self.along(place)?;
        let body = self.number(form, &along.scope(scope))?;
        Ok(derivative(&along.variable, &body, &along.place.own()))
    }

    fn along(&mut self, place: &Place) -> Result<Along, Untranslatable> {
        let known = |along: &&Along| along.place.own() == place.own();
        if let Some(known) = self.alongs.iter().find(known) {
            return Ok(known.clone());
        }
        let mut taken = self.all_symbols();
        let functions = self.alongs.iter().flat_map(|along| &along.functions);
        taken.extend(functions.map(|(name, _)| name.clone()));
        let variable = match place.is_member() {
            true => fresh("t", &taken),
            false => place.name.clone(),
        };
        let moving = Code::atom(&variable);
        let mut along = Along {
            moved: vec![(place.declared.clone(), place.with(&place.name, &moving)?)],
            place: place.clone(),
            variable,
            functions: vec![],
        };
        for unknown in self.unknowns.clone() {
            let place = self.place(&unknown, &Scope::default())?;
            let like = match place.label() {
                Some(label) => format!("{}_{label}_of_{}", place.name, along.variable),
                None => format!("{}_of_{}", place.name, along.variable),
            };
            let name = fresh(&like, &taken);
            taken.insert(name.clone());
            let value = Code::apply(&name, std::slice::from_ref(&moving));
            // Members of one family are replaced one after the other.
            let known = along
                .moved
                .iter()
                .position(|(own, _)| *own == place.declared);
            let before = known.map(|known| along.moved.swap_remove(known).1);
            let before = before.map_or_else(|| place.name.clone(), |code| code.argument());
            let changed = place.with(&before, &value)?;
            along.moved.push((place.declared.clone(), changed));
            along.functions.push((name, place));
        }
        self.alongs.push(along.clone());
        Ok(along)
    }

    /// The functions that a statement needs, and that their values solve the equations.
    ///
    /// # Errors
    /// [`Untranslatable`] for equations that are not defined for every value of the symbol.
    pub fn along_functions(
        &mut self,
        given: &[Expr],
    ) -> Result<(Vec<Binder>, Vec<Code>), Untranslatable> {
        let (mut binders, mut premises) = (vec![], vec![]);
        for along in self.alongs.clone() {
            for (name, unknown) in &along.functions {
                binders.push(Binder {
                    symbol: Arc::clone(&unknown.declared),
                    names: vec![name.clone()],
                    rocq_type: "R -> R".to_owned(),
                    together: None,
                });
                let value = Code::apply(name, &[along.place.own()]);
                premises.push(Code::infix(&value, "=", &unknown.own(), Level::Relation));
            }
            // The symbol takes every value here, so its set is to be the line.
            let is_line = match self.names.declarations.symbol(&along.place.declared) {
                Some(SymbolKind::Real(interval)) => {
                    interval.lower.is_none() && interval.upper.is_none()
                }
                Some(SymbolKind::Vector(None) | SymbolKind::Family { .. }) => true,
                _ => false,
            };
            if !is_line {
                return Err(Untranslatable::Theory(
                    "coefficients of symbols of an interval along equations",
                ));
            }
            for equation in given {
                if !self.is_equation(equation) {
                    return Err(Untranslatable::Theory(
                        "coefficients along what is more than equations",
                    ));
                }
                let mut needed = super::premises::Premises::default();
                self.statement_defined(equation, &Scope::default(), &mut needed)?;
                let moving = along.moved.iter().map(|(declared, _)| &**declared);
                let moving = moving.filter_map(|declared| self.symbol(declared).ok());
                let moving: BTreeSet<&str> = moving.collect();
                let mut needed = needed.into_vec().into_iter();
                if needed.any(|p| words(p.text()).any(|word| moving.contains(word.as_str()))) {
                    return Err(Untranslatable::Theory(
                        "equations that divide by what moves along them",
                    ));
                }
                let equations =
                    self.translate_statement(equation, &along.scope(&Scope::default()), None)?;
                let text = format!("forall {} : R, {}", along.variable, equations.text());
                premises.push(Code::new(text, Level::Open));
            }
        }
        Ok((binders, premises))
    }

    /// Whether a statement says equations and nothing else: only these hold for every value of a symbol.
    fn is_equation(&self, expr: &Expr) -> bool {
        match &expr.node {
            Node::Join(Connective::And, a, b) => self.is_equation(a) && self.is_equation(b),
            Node::Compare(_, rest) => rest.iter().all(|(sign, _)| *sign == Relation::Equal),
            Node::Name(name) => {
                let definition = self.names.declarations.definition(name);
                definition.is_some_and(|definition| self.is_equation(&definition.body.expr))
            }
            _ => false,
        }
    }
}
