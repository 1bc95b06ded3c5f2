//! Properties of lists of functions, and of what a property is about.
//!
//! `nonnegative(f)` says something of all values of the variable of f. Of a list it is opened to the inequalities of its functions at
//! the symbol of that name: so does a statement say it that holds for all values of its symbols, as long as nothing else in it
//! chooses the symbol. Where something does, and where the property is a premise or a hypothesis, it is refused.

use super::binders::Scope;
use super::{Elaborator, Outcome};
use num_traits::Signed as _;
use std::collections::BTreeSet;
use std::sync::Arc;
use torse_core::{BuiltIn, Family, Node, Statement, Visited};
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::fault::Fault;
use torse_syntax::formula::{Connective, Expr, Operator, Place};

impl Elaborator<'_> {
    /// A statement in which properties of lists are inequalities.
    pub(super) fn with_lists_opened(
        &self,
        statement: Statement,
        place: Place,
    ) -> Outcome<Statement> {
        let lists = self.lists(&statement);
        if lists.is_empty() {
            return Ok(statement);
        }
        match statement {
            Statement::Family(..) if !is_total(&statement) => {
                Err(refused(place, "of which one may have no value somewhere"))
            }
            Statement::Family(_, family) => match self.declarations.basis(&family.name) {
                Some(basis) if family.closed => {
                    self.all_nonnegative(&family.name, basis, place, &Scope::default())
                }
                _ => Err(refused(place, "below `at` or in a claim with `exists`")),
            },
            Statement::Join(connective, a, b) => {
                if connective == Connective::Implies && !self.lists(&a).is_empty() {
                    return Err(refused(place, "as a premise"));
                }
                // A part without a value somewhere says nothing of the others there.
                let chosen = |list: &Statement, other: &Statement| {
                    (connective != Connective::And || !is_total(other))
                        && self.is_chosen_by(list, other)
                };
                if chosen(&a, &b) || chosen(&b, &a) {
                    return Err(refused(place, "beside something about its variable"));
                }
                let a = self.with_lists_opened(*a, place)?;
                let b = self.with_lists_opened(*b, place)?;
                Ok(Statement::Join(connective, Box::new(a), Box::new(b)))
            }
            Statement::Not(inner) => {
                let inner = self.with_lists_opened(*inner, place)?;
                Ok(Statement::Not(Box::new(inner)))
            }
            other => Ok(other),
        }
    }

    /// Elaborates a hypothesis.
    ///
    /// # Errors
    /// As [`Elaborator::meaning`], and for a property of a list.
    pub fn hypothesis(&self, expr: &Expr) -> Outcome<Statement> {
        let statement = self.unopened(expr)?;
        match self.lists(&statement).is_empty() {
            true => self.statement_in_jets(statement),
            false => Err(refused(expr.place, "as a hypothesis")),
        }
    }

    /// Fails if something chooses the variable of a list of which the statement says a property: a hypothesis, or the set of a
    /// symbol of the claim.
    pub(crate) fn lists_are_free<'h>(
        &self,
        expr: &Expr,
        mut hypotheses: impl Iterator<Item = &'h Statement> + Clone,
    ) -> Outcome<()> {
        if !self.declarations.bases().any(|(_, basis)| basis.is_list) {
            return Ok(());
        }
        let statement = self.unopened(expr)?;
        let variables: Vec<&str> = self
            .lists(&statement)
            .iter()
            .map(|list| list.variable())
            .collect();
        if variables.is_empty() {
            return Ok(());
        }
        let mut names = vec![];
        let mut add = |name: &Arc<str>| names.push(Arc::clone(name));
        statement.declared_names(&mut add);
        hypotheses
            .clone()
            .for_each(|hypothesis| hypothesis.declared_names(&mut add));
        if hypotheses.any(|hypothesis| self.is_chosen_by(&statement, hypothesis)) {
            return Err(refused(
                expr.place,
                "where a hypothesis is about its variable",
            ));
        }
        match self.sets_speak_of(names, &variables)? {
            true => Err(refused(
                expr.place,
                "where the set of a symbol is about its variable",
            )),
            false => Ok(()),
        }
    }

    /// Whether the set of one of these symbols, or of one that such a set speaks of, speaks of one of the variables.
    fn sets_speak_of(&self, names: Vec<Arc<str>>, variables: &[&str]) -> Outcome<bool> {
        let mut seen: BTreeSet<Arc<str>> = BTreeSet::new();
        let mut pending = names;
        while let Some(name) = pending.pop() {
            if !seen.insert(Arc::clone(&name)) {
                continue;
            }
            let mut found: Vec<Arc<str>> = vec![];
            // Integers, and the indices of families, have the symbols of their bounds beside them.
            let sets = self.symbols_of(vec![Arc::clone(&name)]);
            found.extend(sets.keys().filter(|own| **own != name).cloned());
            if let Some(SymbolKind::Real(interval)) = sets.get(&name) {
                for relation in interval.relations(&name) {
                    let ends = self.unopened(&relation.expr)?;
                    ends.declared_names(&mut |end| {
                        if *end != name {
                            found.push(Arc::clone(end));
                        }
                    });
                }
            }
            if found.iter().any(|end| variables.contains(&&**end)) {
                return Ok(true);
            }
            pending.extend(found);
        }
        Ok(false)
    }

    /// The lists of which the statement says a property.
    fn lists<'s>(&self, statement: &'s Statement) -> Vec<&'s Family> {
        let families = statement.families().into_iter();
        let is_list = |family: &&Family| {
            let basis = self.declarations.basis(&family.name);
            basis.is_some_and(|basis| basis.is_list)
        };
        families.map(|family| &**family).filter(is_list).collect()
    }

    /// Whether the second statement speaks of the variable of a list of the first.
    fn is_chosen_by(&self, statement: &Statement, other: &Statement) -> bool {
        let lists = self.lists(statement);
        let mut found = false;
        other.declared_names(&mut |name| {
            found |= lists.iter().any(|list| list.variable() == &**name);
        });
        found
    }
}

/// Whether a statement has a value everywhere, as far as its terms show: nothing in them divides, and no function is partial.
fn is_total(statement: &Statement) -> bool {
    let mut partial = false;
    let families = statement.families().into_iter();
    let formulas = families.flat_map(|family| family.formulas());
    for term in formulas.chain(statement.terms()) {
        let mut seen = Visited::default();
        let mut pending = vec![term];
        while let Some(term) = pending.pop() {
            if !seen.is_new(term) {
                continue;
            }
            partial |= match &*term.node {
                Node::Binary(Operator::Divide, _, below) => !matches!(*below.node, Node::Number(_)),
                Node::Binary(Operator::Power, _, exponent) => {
                    !matches!(&*exponent.node, Node::Number(n) if !n.is_negative())
                }
                Node::Apply(function, _) => !matches!(
                    function,
                    BuiltIn::Sine | BuiltIn::Cosine | BuiltIn::Exponential | BuiltIn::Binomial
                ),
                Node::Basis { family, .. } => {
                    pending.extend(family.formulas());
                    false
                }
                _ => false,
            };
            pending.extend(term.parts());
        }
    }
    !partial
}

impl Elaborator<'_> {
    /// Fails unless the variable and the shape parameters of a family are names of its own: a property is about all values of the
    /// variable and about the point's values of everything else, so its functions have no symbol of that name by a definition,
    /// the variable is no symbol but for real numbers, and no name is a definition.
    pub(super) fn has_own_names(&self, family: &Family, place: Place) -> Outcome<()> {
        let limit = |what: String| Err(Fault::limit(place, what));
        let variable = family.variable();
        let mut captured = false;
        for part in family.formulas() {
            part.declared_names(&mut |name| captured |= variable == &**name);
        }
        if captured {
            return limit(format!(
                "a property of functions in which `{variable}` is the variable and, by a definition, the symbol `{variable}`"
            ));
        }
        let is_defined = |name| self.declarations.definition(name).is_some();
        let is_real = match self.declarations.symbol(variable) {
            Some(set) => matches!(set, SymbolKind::Real(_)),
            None => !is_defined(variable),
        };
        if !is_real {
            return limit(format!(
                "a property of functions whose variable `{variable}` is no real symbol"
            ));
        }
        match family.parameters().any(is_defined) {
            true => {
                limit("a property of a basis of which a shape parameter is a definition".into())
            }
            false => Ok(()),
        }
    }
}

fn refused(place: Place, how: &str) -> Fault {
    Fault::limit(place, format!("a property of a list of functions {how}"))
}
