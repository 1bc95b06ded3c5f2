//! Flags a statement in which no slip would be noticed.

use super::{RaisedFlag, Subject, raised};
use crate::conjunction::conjuncts;
use crate::mutants::one_is_refuted;
use torse_algebra::work;
use torse_syntax::formula::Node;
use torse_syntax::taxonomy::{Flag, Verdict};

/// How many mutants are tried at first, and how many if all of these survive.
const MAX_MUTANTS: [usize; 2] = [4, 40];
/// Maximum work for them.
const MAX_WORK: u64 = 20_000_000;

/// Returns a proved equation none of whose mutants is refuted.
pub(super) fn unfalsifiable_equations(subject: &Subject<'_>) -> Vec<RaisedFlag> {
    let proved = matches!(
        subject.outcome.verdict(),
        Verdict::Holds | Verdict::Conditional
    );
    let statement = subject.claim.statement.as_ref();
    // A negation only has to be true at one point, and nearly every slip leaves it true.
    let equation = statement.is_some_and(|w| {
        let mut parts = conjuncts(&w.expr).into_iter();
        parts.any(|part| matches!(part.node, Node::Compare(..)) && super::parts::has_equation(part))
    });
    if !proved || !equation {
        return vec![];
    }
    let mut decided = 0;
    for most in MAX_MUTANTS {
        match work::within(MAX_WORK, || one_is_refuted(subject.claim, most)) {
            Ok((false, tried)) => decided = tried,
            // Or there was too much to do.
            _ => return vec![],
        }
    }
    let evidence = format!("none of {decided} changed statements is refuted");
    vec![raised(Flag::NoMutant, evidence)]
}
