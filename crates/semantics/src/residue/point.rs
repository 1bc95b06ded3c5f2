//! Points modulo the prime: numbers drawn as they always are, and residues for those that equations determine.

use super::{Residue, Residues};
use crate::domain::draft::Draft;
use crate::domain::newton::{changes, expanded};
use crate::domain::point::check_sets;
use crate::domain::solve::{equations, is_equations, unknowns};
use crate::gap::{Unknown, Work};
use crate::judgement::Judgement;
use crate::name::Name;
use crate::real::Real;
use crate::residue::judge::Judge;
use std::cell::RefCell;
use std::collections::BTreeMap;
use torse_language::core::{Claim, Set};

/// Rounds until equations hold that can be solved one after the other.
const ROUNDS: usize = 5;

/// A point: the residues of what was solved for, and the draft that has all other numbers.
pub(crate) struct Point<'d, 'a> {
    draft: &'d Draft<'a>,
    solved: RefCell<BTreeMap<Name, u64>>,
}

/// What came of drawing a point.
pub(crate) enum Drawn<'d, 'a> {
    /// A point of the domain.
    Inside(Point<'d, 'a>),
    /// No point of the domain.
    Outside,
    /// Whether it is one cannot be told by residues.
    Unknown(Unknown),
}

impl Point<'_, '_> {
    /// The residue of this number.
    pub fn residue(&self, name: &Name) -> Option<Residue> {
        if let Some(solved) = self.solved.borrow().get(name) {
            return Some(Residue::Class(*solved));
        }
        Some(Residue::from(&self.draft.value(name)?))
    }

    /// The number itself, unless it was solved for.
    pub fn number(&self, name: &Name) -> Option<Real> {
        let solved = self.solved.borrow().contains_key(name);
        (!solved).then(|| self.draft.value(name)).flatten()
    }

    /// Solves the equations of the domain: whether they hold now; `None` if that is not known.
    fn solve(&self, claim: &Claim, work: &Work) -> Option<()> {
        let equations = equations(claim);
        if equations.is_empty() {
            return Some(());
        }
        let a = Residues { work };
        let unknowns = unknowns(claim, self.draft, work)?;
        let value = |name: &Name| self.residue(name);
        for _ in 0..ROUNDS {
            let expanded =
                |moves: &dyn Fn(&Name) -> bool| expanded(&equations, a, &value, moves).ok();
            let holds = |gap: &Residue| *gap == Residue::Class(0);
            let some = expanded(&|name| unknowns.contains(name))?;
            if some.gaps.iter().all(|gap| holds(&gap.value)) {
                return Some(());
            }
            let changes = |expanded| {
                let stream = self.draft.stream();
                changes(claim, expanded, stream, &unknowns, &a, &holds)
            };
            let changes = match changes(&some) {
                Some(changes) => changes,
                None => changes(&expanded(&|_| true)?)?,
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
        }
        None
    }

    /// Whether the numbers that were solved for may be any numbers: what a bounded one is worth is not seen.
    fn is_free(&self, claim: &Claim) -> bool {
        let solved = self.solved.borrow();
        solved
            .keys()
            .all(|name| match claim.symbols.get(name.declared()) {
                Some(Set::Real(interval)) => interval.lower.is_none() && interval.upper.is_none(),
                Some(Set::Vector(_) | Set::Family { .. }) => true,
                Some(Set::Integer { .. }) | None => false,
            })
    }
}

/// Completes a draft to a point of the domain.
pub(crate) fn drawn<'d, 'a>(claim: &Claim, draft: &'d Draft<'a>, work: &Work) -> Drawn<'d, 'a> {
    let not_covered = || {
        let what = "equations that residues do not solve";
        Drawn::Unknown(match work.left() {
            0 => Unknown::Work,
            _ => Unknown::NotCovered { what },
        })
    };
    let point = Point {
        draft,
        solved: RefCell::default(),
    };
    if point.solve(claim, work).is_none() || !point.is_free(claim) {
        return not_covered();
    }
    // The sets first: they cost nothing.
    if check_sets(claim, &draft.values()).is_err() {
        return Drawn::Outside;
    }
    let judge = Judge {
        claim,
        point: &point,
        denied: &BTreeMap::new(),
        work,
    };
    let hypotheses = claim.hypotheses.iter().map(|h| &h.statement);
    for hypothesis in hypotheses.filter(|h| !is_equations(h)) {
        match judge.hypothesis(hypothesis) {
            Judgement::True => {}
            Judgement::False | Judgement::Undefined(_) => return Drawn::Outside,
            Judgement::Undecided => return not_covered(),
            Judgement::Unknown(why) => return Drawn::Unknown(why),
        }
    }
    if check_sets(claim, &draft.values()).is_err() || draft.empty.get() {
        return Drawn::Outside;
    }
    Drawn::Inside(point)
}
