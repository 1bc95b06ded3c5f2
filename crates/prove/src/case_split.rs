//! Hypotheses with alternatives, and statements that are decided under one of their own parts.
//!
//! A statement about the points of `A or B` is true if it is true at the points of each. The parts are cut so that every
//! one of them names all comparisons: `A or B` is `A and B`, `A and not B`, or `not A and B`. So a point lies in one part
//! only, and at a point of any of them every comparison of the hypothesis is defined, as the meaning of the whole asks.
//! In the same way `A implies B` is B at the points of A, and `A or B` is B at the points at which A fails; a statement of
//! many parts is a conjunction of such alternatives.

use std::ops::Range;
use torse_algebra::work::{self, Spent};
use torse_core::{Claim, Hypothesis, Source, Statement};
use torse_syntax::derivation::Origin;
use torse_syntax::formula::Connective;

/// The most parts a domain is cut into, and a statement.
const MAX_PARTS: usize = 32;

/// What it costs to compare two hypotheses of a domain, in units of [`work`].
const PAIR_WORK: u64 = 16;

/// Comparisons that all hold.
type Part = Vec<Statement>;

/// The claim on each part of its domain, such that no assumption has alternatives any more; the claim itself where there
/// are none, or too many.
pub fn parts(claim: &Claim) -> Vec<Claim> {
    let mut parts = vec![claim.clone()];
    for (place, hypothesis) in claim.hypotheses.iter().enumerate().rev() {
        if hypothesis.source == Source::Given || !has_alternatives(&hypothesis.statement) {
            continue;
        }
        let cut = cut(&hypothesis.statement, true);
        let divided =
            cut.and_then(|cut| divided(&parts, &cut, place..place + 1, &hypothesis.origin));
        let Some(divided) = divided else {
            return vec![claim.clone()];
        };
        parts = divided;
    }
    parts
}

/// The claim at the points at which every one of these statements is true, or at which every one is false, on each part of
/// them; `None` if one is of no kind that can be assumed.
pub fn under(
    claim: &Claim,
    statements: &[&Statement],
    truth: bool,
    origin: &Origin,
) -> Option<Vec<Claim>> {
    let mut parts = vec![claim.clone()];
    for statement in statements {
        // Behind all that is assumed already.
        let end = parts.first()?.hypotheses.len();
        parts = divided(&parts, &cut(statement, truth)?, end..end, origin)?;
    }
    Some(parts)
}

/// A statement as a conjunction of alternatives; `None` if there are too many.
pub fn clauses(statement: &Statement) -> Option<Vec<Vec<&Statement>>> {
    let Statement::Join(connective, a, b) = statement else {
        return Some(vec![vec![statement]]);
    };
    match connective {
        Connective::And => Some([clauses(a)?, clauses(b)?].concat()),
        Connective::Or => {
            let (first, second) = (clauses(a)?, clauses(b)?);
            if first.len() * second.len() > MAX_PARTS {
                return None;
            }
            let pairs = first
                .iter()
                .flat_map(|x| second.iter().map(move |y| (x, y)));
            Some(pairs.map(|(x, y)| [x.as_slice(), y].concat()).collect())
        }
        Connective::Implies => Some(vec![vec![statement]]),
    }
}

/// Spends what a domain with so many hypotheses costs: each is compared with those before it.
///
/// # Errors
/// The limit that the job met.
pub fn spend_on_domain(hypotheses: usize) -> Result<(), Spent> {
    let pairs = hypotheses.saturating_mul(hypotheses);
    work::spend(PAIR_WORK.saturating_mul(u64::try_from(pairs).unwrap_or(u64::MAX)))
}

/// Each of these claims with each part in this place of its hypotheses; `None` if there are too many, or no work is left.
fn divided(
    claims: &[Claim],
    cut: &[Part],
    place: Range<usize>,
    origin: &Origin,
) -> Option<Vec<Claim>> {
    let assumed = |statement: &Statement| Hypothesis {
        statement: statement.clone(),
        source: Source::Assume,
        origin: origin.clone(),
    };
    let with = |claim: &Claim, part: &Part| {
        let mut claim = claim.clone();
        let all = part.iter().map(assumed);
        claim.hypotheses.splice(place.clone(), all);
        claim
    };
    if claims.len() * cut.len() > MAX_PARTS {
        return None;
    }
    let mut made = vec![];
    for claim in claims {
        for part in cut {
            spend_on_domain(claim.hypotheses.len() + part.len()).ok()?;
            made.push(with(claim, part));
        }
    }
    Some(made)
}

/// Whether the statement is more than a conjunction of comparisons and denials of such.
fn has_alternatives(statement: &Statement) -> bool {
    match statement {
        Statement::Join(Connective::And, a, b) => has_alternatives(a) || has_alternatives(b),
        Statement::Join(..) => true,
        Statement::Not(inner) => matches!(**inner, Statement::Join(..) | Statement::Not(_)),
        Statement::Compare { .. } | Statement::Agrees { .. } | Statement::Family(..) => false,
    }
}

/// The parts on which a statement is true, or false, each a list of comparisons.
fn cut(statement: &Statement, truth: bool) -> Option<Vec<Part>> {
    let both = |a: &Statement, with_a: bool, b: &Statement, with_b: bool| -> Option<Vec<Part>> {
        let (first, second) = (cut(a, with_a)?, cut(b, with_b)?);
        let joined = |x: &Part| {
            let x = x.clone();
            second.iter().map(move |y| [x.clone(), y.clone()].concat())
        };
        (first.len() * second.len() <= MAX_PARTS).then(|| first.iter().flat_map(joined).collect())
    };
    let any = |choices: &[(bool, bool)], a: &Statement, b: &Statement| -> Option<Vec<Part>> {
        let all = choices
            .iter()
            .map(|(with_a, with_b)| both(a, *with_a, b, *with_b));
        Some(all.collect::<Option<Vec<_>>>()?.concat())
    };
    match (statement, truth) {
        (Statement::Not(inner), _) => cut(inner, !truth),
        (Statement::Compare { .. }, true) => Some(vec![vec![statement.clone()]]),
        (
            Statement::Compare {
                relation,
                left,
                right,
            },
            false,
        ) => Some(vec![vec![Statement::Compare {
            relation: relation.opposite(),
            left: left.clone(),
            right: right.clone(),
        }]]),
        (Statement::Join(connective, a, b), _) => {
            let choices: &[(bool, bool)] = match (connective, truth) {
                (Connective::And, true) => &[(true, true)],
                (Connective::And, false) => &[(false, true), (true, false), (false, false)],
                (Connective::Or, true) => &[(true, true), (true, false), (false, true)],
                (Connective::Or, false) => &[(false, false)],
                (Connective::Implies, true) => &[(true, true), (false, true), (false, false)],
                (Connective::Implies, false) => &[(true, false)],
            };
            any(choices, a, b)
        }
        (Statement::Agrees { .. } | Statement::Family(..), _) => None,
    }
}
