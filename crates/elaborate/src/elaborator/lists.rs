//! Properties of lists of functions, and of what a property is about.
//!
//! `nonnegative(f)` says something of all values of the variable of f. Of a list it is opened to the inequalities of its functions at
//! the symbol of that name: so does a statement say it that holds for all values of its symbols, as long as nothing else in it
//! chooses the symbol. Where something does, and where the property is a premise or a hypothesis, it is refused.

use super::binders::Scope;
use super::{Elaborator, Outcome};
use torse_core::{Family, Statement};
use torse_syntax::fault::Fault;
use torse_syntax::formula::{Connective, Expr, Place};

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
                let shared = connective != Connective::And
                    && (self.is_chosen_by(&a, &b) || self.is_chosen_by(&b, &a));
                if shared {
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

    /// Fails if a hypothesis says something of the variable of a list of which the statement says a property.
    pub(crate) fn lists_are_free<'h>(
        &self,
        expr: &Expr,
        hypotheses: impl Iterator<Item = &'h Statement>,
    ) -> Outcome<()> {
        let mut hypotheses = hypotheses.peekable();
        if hypotheses.peek().is_none() || !self.declarations.bases().any(|(_, basis)| basis.is_list)
        {
            return Ok(());
        }
        let statement = self.unopened(expr)?;
        match hypotheses.any(|hypothesis| self.is_chosen_by(&statement, hypothesis)) {
            true => Err(refused(
                expr.place,
                "where a hypothesis is about its variable",
            )),
            false => Ok(()),
        }
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

/// Fails if the functions of a family have, besides their variable, the symbol of the same name: a property is about all values of
/// the one and about the point's value of the other.
pub(super) fn not_captured(family: &Family, place: Place) -> Outcome<()> {
    let mut captured = false;
    for part in family.formulas() {
        part.declared_names(&mut |name| captured |= family.variable() == &**name);
    }
    match captured {
        true => Err(Fault::limit(
            place,
            format!(
                "a property of functions in which `{0}` is the variable and, by a definition, the symbol `{0}`",
                family.variable()
            ),
        )),
        false => Ok(()),
    }
}

fn refused(place: Place, how: &str) -> Fault {
    Fault::limit(place, format!("a property of a list of functions {how}"))
}
