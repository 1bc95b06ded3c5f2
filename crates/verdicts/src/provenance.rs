//! Finds which hypotheses a proof needs, and their sources.
//!
//! A verdict `holds` says that the paper is right, so it may rest on printed hypotheses only. A hypothesis or a range
//! that is ours is therefore tried: it is dropped and the claim decided again, one at a time, in the order of the file.
//! If the proof is lost, or holds only where some long polynomial does not vanish, the hypothesis is needed, and
//! becomes a condition of the verdict; otherwise it stays dropped. The result is a set of hypotheses none of which can
//! be dropped, though another order might give another set.
//!
//! A symbol whose range is dropped keeps the range that it narrows, or the whole line.

use crate::claim_record::{Assumed, HypothesisSource, Role};
use std::sync::Arc;
use torse_algebra::Polynomial;
use torse_algebra::work::Allowance;
use torse_prove::decide::Decision;
use torse_prove::decide_statement;
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::derivation::{Claim, Hypothesis, Origin, Provenance, Written};
use torse_syntax::formula::{Connective, Expr, Node, Place, Relation};
use torse_syntax::notation::{self, Formula, domain};

/// A hypothesis of a claim, by its place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum HypothesisRef {
    /// The declared range of a symbol.
    Range(String),
    /// An entry of `assume`.
    Assume(usize),
    /// An entry of `given`.
    Given(usize),
}

/// Returns all hypotheses of a claim: the ranges with a stated source, then `assume` and `given`, those of one file in
/// the order in which they stand there.
#[must_use]
pub fn slots(claim: &Claim) -> Vec<HypothesisRef> {
    let names = claim.declarations.ranges();
    let mut found: Vec<(HypothesisRef, &Origin)> = names
        .map(|(name, range)| (HypothesisRef::Range(name.to_owned()), &range.origin))
        .collect();
    let written = placed(&claim.assumptions, HypothesisRef::Assume)
        .chain(placed(&claim.given, HypothesisRef::Given));
    found.extend(written.map(|(slot, hypothesis)| (slot, &hypothesis.formula.origin)));
    // The statements of other files come first: they precede the claim.
    found.sort_by_key(|(_, origin)| {
        let elsewhere = origin.source.name != claim.origin.source.name;
        (!elsewhere, origin.span(Place::default()).offset())
    });
    found.into_iter().map(|(slot, _)| slot).collect()
}

/// Returns the entries of a list with their places.
fn placed(
    list: &[Hypothesis],
    slot: fn(usize) -> HypothesisRef,
) -> impl Iterator<Item = (HypothesisRef, &Hypothesis)> {
    let numbered = list.iter().enumerate();
    numbered.map(move |(i, hypothesis)| (slot(i), hypothesis))
}

/// Returns the hypotheses of a claim, in the order of [`slots`], each with whether it is needed, if known.
#[must_use]
pub fn assumed(claim: &Claim, needed: &[Option<bool>]) -> Vec<Assumed> {
    let needed = needed.iter().copied().chain(std::iter::repeat(None));
    let all = hypotheses(claim).into_iter().zip(needed);
    all.map(|((_, hypothesis), needed)| Assumed {
        needed,
        ..hypothesis
    })
    .collect()
}

/// Returns the hypotheses with their places.
fn hypotheses(claim: &Claim) -> Vec<(HypothesisRef, Assumed)> {
    let entry = |slot: &HypothesisRef| {
        let listed = |role, list: &[Hypothesis], i: usize| {
            list.get(i).map(|h| {
                (
                    role,
                    notation::formula(&h.formula.expr),
                    h.provenance.clone(),
                )
            })
        };
        let (role, formula, provenance) = match slot {
            HypothesisRef::Assume(i) => listed(Role::Assume, &claim.assumptions, *i)?,
            HypothesisRef::Given(i) => listed(Role::Given, &claim.given, *i)?,
            HypothesisRef::Range(name) => {
                let range = claim.declarations.range(name)?;
                let kind = claim.declarations.symbol(name)?;
                let formula = match domain::statement(name, kind) {
                    Some(range) => notation::formula(&range),
                    None => Formula {
                        text: domain::words(name, kind),
                    },
                };
                (Role::Range, formula, range.provenance.clone())
            }
        };
        Some(Assumed {
            role,
            formula,
            from: match provenance {
                Provenance::Stated => HypothesisSource::Stated,
                Provenance::Printed(quote) => HypothesisSource::Printed {
                    quote: quote.words,
                    claim: quote.claim,
                },
                Provenance::Ours { reason } => HypothesisSource::Ours { reason },
            },
            needed: None,
        })
    };
    let paired = slots(claim).into_iter();
    paired
        .filter_map(|slot| entry(&slot).map(|hypothesis| (slot, hypothesis)))
        .collect()
}

/// Returns the claim without some of its hypotheses.
#[must_use]
pub fn without(claim: &Claim, dropped: &[HypothesisRef]) -> Claim {
    let mut fewer = claim.clone();
    let kept = |list: &[Hypothesis], slot: fn(usize) -> HypothesisRef| -> Vec<Hypothesis> {
        let kept = placed(list, slot).filter(|(slot, _)| !dropped.contains(slot));
        kept.map(|(_, hypothesis)| hypothesis.clone()).collect()
    };
    fewer.assumptions = kept(&claim.assumptions, HypothesisRef::Assume);
    fewer.given = kept(&claim.given, HypothesisRef::Given);
    for slot in dropped {
        let HypothesisRef::Range(name) = slot else {
            continue;
        };
        let outer = fewer.declarations.range(name).map(|r| r.outer.clone());
        let wider = match (outer.flatten(), claim.declarations.symbol(name)) {
            (Some(outer), _) => outer,
            (None, Some(SymbolKind::Integer { .. })) => SymbolKind::Integer {
                least: None,
                most: None,
            },
            (None, _) => SymbolKind::Real(Box::default()),
        };
        fewer.declarations = Arc::new(fewer.declarations.with_symbol(name, wider));
    }
    fewer
}

/// The hypotheses of ours that a proof needs.
#[derive(Debug)]
pub struct MinimizedProof {
    /// The proof without the hypotheses that it does not need.
    pub decision: Decision,
    /// The hypotheses that were tried, and whether they are needed.
    pub needed: Vec<(HypothesisRef, bool)>,
}

/// Up to so many hypotheses of ours may each take the full work; more of them share it.
const MAX_HYPOTHESES_WITH_FULL_WORK: u64 = 5;

/// Tries to drop each hypothesis of ours, with this work for each, and `MAX_HYPOTHESES_WITH_FULL_WORK` times as much
/// for all. A hypothesis that cannot be tried within it counts as needed.
#[must_use]
pub fn minimize_hypotheses(
    claim: &Claim,
    statement: &Written,
    decision: Decision,
    budget: u64,
) -> MinimizedProof {
    let mut minimized = MinimizedProof {
        decision,
        needed: vec![],
    };
    if !minimized.decision.is_proven() {
        return minimized;
    }
    let mut allowance =
        Allowance::new(budget, budget.saturating_mul(MAX_HYPOTHESES_WITH_FULL_WORK));
    let mut dropped = vec![];
    for slot in slots(claim) {
        if !can_be_dropped(claim, &slot) {
            continue;
        }
        dropped.push(slot.clone());
        let fewer = without(claim, &dropped);
        // If the claim makes no sense without the hypothesis, it is needed.
        let found = allowance.within(|| decide_statement(&fewer, statement));
        match found.ok().and_then(Result::ok) {
            Some(decision) if stands_for(&decision, &minimized.decision, stated(claim, &slot)) => {
                minimized.decision = decision;
                minimized.needed.push((slot, false));
            }
            _ => {
                dropped.pop();
                minimized.needed.push((slot, true));
            }
        }
    }
    minimized
}

/// Maximum number of terms of a condition that replaces a hypothesis.
const MAX_TERMS: usize = 12;

/// Whether a proof without a hypothesis can replace the one with it. A proof that holds only if more does not vanish
/// has weaker conditions than the hypothesis; but only short ones tell a reader more than the words of the file, and a
/// hypothesis that itself says that something does not vanish is such a condition already.
fn stands_for(without: &Decision, with: &Decision, hypothesis: Option<&Expr>) -> bool {
    let (Some(conditions), Some(known)) = (without.conditions(), with.conditions()) else {
        return false;
    };
    let denies_zeros = hypothesis.is_some_and(denies_zeros);
    let short = |condition: &Polynomial| !denies_zeros && condition.len() <= MAX_TERMS;
    conditions
        .iter()
        .all(|condition| known.contains(condition) || short(condition))
}

/// Whether a hypothesis says that quantities do not vanish.
fn denies_zeros(hypothesis: &Expr) -> bool {
    match &hypothesis.node {
        Node::Join(Connective::And, a, b) => denies_zeros(a) && denies_zeros(b),
        Node::Compare(_, links) => links.iter().all(|(r, _)| *r == Relation::Different),
        _ => false,
    }
}

/// Returns the formula of a hypothesis, if it has one.
fn stated<'c>(claim: &'c Claim, slot: &HypothesisRef) -> Option<&'c Expr> {
    let hypothesis = match slot {
        HypothesisRef::Assume(i) => claim.assumptions.get(*i),
        HypothesisRef::Given(i) => claim.given.get(*i),
        HypothesisRef::Range(_) => None,
    };
    hypothesis.map(|hypothesis| &hypothesis.formula.expr)
}

/// Whether a hypothesis is ours, and a formula can state it as a condition.
fn can_be_dropped(claim: &Claim, slot: &HypothesisRef) -> bool {
    let listed =
        |list: &[Hypothesis], i: usize| list.get(i).is_some_and(|h| h.provenance.is_ours());
    match slot {
        HypothesisRef::Assume(i) => listed(&claim.assumptions, *i),
        HypothesisRef::Given(i) => listed(&claim.given, *i),
        HypothesisRef::Range(name) => {
            let range = claim.declarations.range(name);
            let kind = claim.declarations.symbol(name);
            range.is_some_and(|range| range.provenance.is_ours())
                && kind.is_some_and(|kind| domain::statement(name, kind).is_some())
        }
    }
}

/// Returns for each hypothesis, in the order of [`assumed`], whether it is needed; none for those that were not tried.
#[must_use]
pub fn by_hypothesis(claim: &Claim, needed: &[(HypothesisRef, bool)]) -> Vec<Option<bool>> {
    let tried = |slot: &HypothesisRef| needed.iter().find(|(tried, _)| tried == slot);
    let slots = slots(claim);
    slots
        .iter()
        .map(|slot| tried(slot).map(|(_, needed)| *needed))
        .collect()
}

/// Returns the hypotheses that were found not to be needed.
#[must_use]
pub fn unneeded(claim: &Claim, needed: &[Option<bool>]) -> Vec<HypothesisRef> {
    let slots = slots(claim).into_iter().zip(needed);
    let unneeded = slots.filter(|(_, needed)| **needed == Some(false));
    unneeded.map(|(slot, _)| slot).collect()
}

/// Whether some hypothesis is ours.
#[must_use]
pub fn has_ours(claim: &Claim) -> bool {
    assumed(claim, &[])
        .iter()
        .any(|hypothesis| matches!(hypothesis.from, HypothesisSource::Ours { .. }))
}

/// Returns the needed hypotheses, as conditions.
#[must_use]
pub fn conditions(claim: &Claim, needed: &[(HypothesisRef, bool)]) -> Vec<Formula> {
    let is_needed = |slot: &HypothesisRef| {
        needed
            .iter()
            .any(|(tried, needed)| tried == slot && *needed)
    };
    let kept = hypotheses(claim)
        .into_iter()
        .filter(|(slot, _)| is_needed(slot));
    kept.map(|(_, hypothesis)| hypothesis.formula).collect()
}

/// Returns the hypothesis of ours that a condition stands for, by its formula.
#[must_use]
pub fn slot_of(claim: &Claim, condition: &Formula) -> Option<HypothesisRef> {
    let mut paired = hypotheses(claim).into_iter();
    let found = paired.find(|(slot, h)| h.formula == *condition && can_be_dropped(claim, slot));
    found.map(|(slot, _)| slot)
}
