//! Points modulo the prime: the numbers are drawn as usual, and those that equations determine are solved for as
//! residues.

use super::{Residue, Residues};
use crate::domain::Domain;
use crate::domain::draft::Draft;
use crate::domain::newton::{changes, differences, expanded};
use crate::domain::solve::unknowns;
use crate::name::Name;
use crate::no_value::Work;
use crate::real::Real;
use std::cell::RefCell;
use std::collections::BTreeMap;
use torse_syntax::derivation::declarations::SymbolKind;

/// The largest number of rounds in which equations are solved one after the other.
const ROUNDS: usize = 5;

/// A point: the residues that were solved for, and a draft with all other numbers.
pub(crate) struct Point<'d, 'a> {
    draft: &'d Draft<'a>,
    solved: RefCell<BTreeMap<Name, u64>>,
    /// The cached residues of numbers of the draft.
    drawn: RefCell<BTreeMap<Name, Residue>>,
}

impl<'d, 'a> Point<'d, 'a> {
    /// The point of a draft whose equations are not yet solved.
    pub fn new(draft: &'d Draft<'a>) -> Self {
        Self {
            draft,
            solved: RefCell::default(),
            drawn: RefCell::default(),
        }
    }

    /// The residue of a number.
    pub fn residue(&self, name: &Name) -> Option<Residue> {
        if let Some(solved) = self.solved.borrow().get(name) {
            return Some(Residue::Class(*solved));
        }
        if let Some(known) = self.drawn.borrow().get(name) {
            return Some(*known);
        }
        let residue = Residue::from(&self.draft.value(name)?);
        self.drawn.borrow_mut().insert(name.clone(), residue);
        Some(residue)
    }

    /// The number itself, unless it was solved for as a residue.
    pub fn number(&self, name: &Name) -> Option<Real> {
        let solved = self.solved.borrow().contains_key(name);
        (!solved).then(|| self.draft.value(name)).flatten()
    }

    /// Solves the equations of the domain; `None` if that fails.
    pub fn solve(&self, domain: &Domain<'_>, work: &Work) -> Option<()> {
        let equations = domain.equations();
        if equations.is_empty() {
            return Some(());
        }
        let a = Residues { work };
        let reading = domain.reading;
        let unknowns = unknowns(domain, self.draft, work);
        let value = |name: &Name| self.residue(name);
        let expanded =
            |moves: &dyn Fn(&Name) -> bool| expanded(reading, &equations, a, &value, moves).ok();
        let holds = |gap: &Residue| *gap == Residue::Class(0);
        for round in 0..ROUNDS {
            // Evaluating the equations costs a fraction of their derivatives. In the first round they do not hold,
            // since the numbers are random.
            if round > 0 {
                let values = differences(reading, &equations, &a, &value).ok()?;
                if values.iter().all(&holds) {
                    return Some(());
                }
            }
            let by_unknowns = expanded(&|name| unknowns.contains(name))?;
            if by_unknowns.gaps.iter().all(|gap| holds(&gap.value)) {
                return Some(());
            }
            let changes = |expanded| {
                let stream = self.draft.stream();
                changes(domain, expanded, stream, &unknowns, &a, &holds)
            };
            let (used, changes) = match changes(&by_unknowns) {
                Some(changes) => (by_unknowns, changes),
                None => {
                    let all = expanded(&|_| true)?;
                    let changes = changes(&all)?;
                    (all, changes)
                }
            };
            for (name, change) in changes {
                let (Residue::Class(before), Residue::Class(change)) =
                    (self.residue(&name)?, change)
                else {
                    return None;
                };
                let moved = super::field::sum(before, change);
                self.solved.borrow_mut().insert(name, moved);
            }
            // One step solves linear equations.
            if used.is_linear() {
                if round == 0 {
                    self.draft.determine(self.solved.borrow().keys().cloned());
                }
                return Some(());
            }
        }
        None
    }

    /// Whether the numbers that were solved for have unbounded sets. For a bounded one, residues cannot decide
    /// membership.
    pub fn is_free(&self, domain: &Domain<'_>) -> bool {
        let solved = self.solved.borrow();
        solved.keys().all(|name| match domain.set(name) {
            Some(SymbolKind::Real(interval)) => {
                interval.lower.is_none() && interval.upper.is_none()
            }
            Some(SymbolKind::Vector(_) | SymbolKind::Family { .. }) => true,
            Some(SymbolKind::Integer { .. }) | None => false,
        })
    }
}
