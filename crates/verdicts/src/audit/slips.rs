//! A statement in which no slip would be noticed says little.

use super::{Sign, Subject, sign};
use crate::conjunction::conjuncts;
use crate::mutants::survivors;
use torse_algebra::work;
use torse_syntax::formula::Node;
use torse_syntax::taxonomy::{Flag, Verdict};

/// The changed statements that are tried at first, and where all of those survive.
const TRIED: [usize; 2] = [4, 40];
/// The work for them.
const WORK: u64 = 20_000_000;

/// A proved equation of which no changed form is refuted.
pub(super) fn none_is_noticed(subject: &Subject<'_>) -> Vec<Sign> {
    let proved = matches!(
        subject.outcome.verdict(),
        Verdict::Holds | Verdict::Conditional
    );
    let statement = subject.claim.statement.as_ref();
    // What is denied is so at one point at least: a slip leaves that true nearly always.
    let equation = statement.is_some_and(|w| {
        let mut parts = conjuncts(&w.expr).into_iter();
        parts.any(|part| matches!(part.node, Node::Compare(..)) && super::parts::has_equation(part))
    });
    if !proved || !equation {
        return vec![];
    }
    let mut decided = 0;
    for most in TRIED {
        match work::within(WORK, || survivors(subject.claim, most)) {
            Ok((survivors, tried)) if survivors.len() == tried => decided = tried,
            // One was refuted, or there was too much to do.
            _ => return vec![],
        }
    }
    let seen = format!("none of {decided} changed statements is refuted");
    vec![sign(Flag::NoMutant, seen)]
}
