//! Corrections of refuted formulas.
//!
//! The printed side of a refuted equality ([`subject`]) is edited, first once, then twice; candidates are filtered at a
//! sample point ([`target`]) and the survivors **proved** like any statement. The smallest number of edits wins; the
//! result says whether another correction with as few edits exists. Between one edit and two, one slip that shows in
//! several places is tried ([`repeated`], [`names`], [`arguments`]), in a definition of the printed side ([`subject`])
//! or beside the formula ([`move_factor`]). A wrong value may be the right value of other data, and a wrong determinant
//! that of another matrix: see [`data`] and [`entries`].

pub(crate) mod alphabet;
pub mod ansatz;
pub mod arguments;
pub mod canonical;
pub mod data;
pub mod edit;
pub mod edits;
pub mod entries;
pub mod global_edits;
pub mod insertions;
pub mod move_factor;
pub mod names;
pub mod one_side;
mod operands;
mod points;
mod rates;
pub mod repeated;
mod residue;
mod retyped;
pub mod slips;
mod solved;
pub mod subject;
pub mod target;
mod terms;

use crate::condition::nonzero;
use crate::correction::Correction;
use alphabet::Alphabet;
use edit::{Edit, placed};
use std::cmp::Reverse;
use std::collections::BTreeSet;
use subject::Subject;
use target::Target;
use torse_algebra::fault_injection::{InjectedFault, injected};
use torse_prove::decide_statement;
use torse_syntax::derivation::{Claim, Written};
use torse_syntax::formula::{Expr, Node, Relation};
use torse_syntax::notation::{self, Formula};
use torse_syntax::taxonomy::Kind;

/// Maximum number of candidates evaluated with one edit.
const MAX_SINGLE: usize = 6_000;
/// Maximum number of first edits that are combined with a second one.
const MAX_FIRST: usize = 150;
/// Maximum number of candidates evaluated with two edits.
const MAX_DOUBLE: usize = 12_000;
/// Maximum work for slips that show in several places, in the units of [`target`].
const MAX_ELSEWHERE: u64 = 300_000;
/// The work for numbers that are solved for, for what was left out, and for the other side.
const MAX_APART: u64 = 800_000;
/// Maximum number of survivors of the sample point that are proved.
const MAX_PROOFS: usize = 8;
/// The side that was not taken for the printed one is left as it is if it has more nodes than this.
const MAX_OTHER_SIDE: usize = 500;
/// If the left side of a comparison has at most so many nodes and both sides become equal, it is a tautology.
const MAX_TAUTOLOGY: usize = 5;
/// Formulas larger than this are corrected with one edit at most.
const MAX_SIZE_DOUBLE: usize = 60;

/// Whether to search for a correction of statements of this kind. In the other kinds the formula is ours, not the
/// paper's: correcting it would say nothing, and a step of an argument that does not follow is no misprint.
#[must_use]
pub fn is_sought(kind: Kind) -> bool {
    matches!(
        kind,
        Kind::Identity | Kind::Value | Kind::Construction | Kind::Definition
    )
}

/// What a search for a correction came to.
#[derive(Debug, Default)]
pub struct Search {
    /// The correction, if one was found.
    pub correction: Option<Correction>,
    /// Whether the work was used up before all small edits were tried.
    pub ended_early: bool,
}

/// Searches for a correction of a refuted statement.
#[must_use]
pub fn search(claim: &Claim, statement: &Written) -> Search {
    let mut ended_early = false;
    let correction = corrected(claim, statement, &mut ended_early);
    Search {
        correction,
        ended_early,
    }
}

fn corrected(claim: &Claim, statement: &Written, ended_early: &mut bool) -> Option<Correction> {
    let subject = Subject::from_claim(claim, statement)?;
    let printed = &subject.formula;
    let Some(target) = Target::new(claim, statement, &subject) else {
        return beside_roots((claim, statement), &subject, ended_early);
    };
    let alphabet = alphabet::alphabet(claim, &statement.expr, printed);
    let mut singles = vec![];
    let mut once = vec![];
    for edit in edits::single(printed, &alphabet)
        .into_iter()
        .take(MAX_SINGLE)
        .take_while(|_| target.within_budget())
    {
        let agreement = target.agreement(&subject.side(&edit.expr));
        if agreement.everywhere || injected(InjectedFault::CorrectionUnproved) {
            once.push(edit.clone().described());
        }
        singles.push((agreement.entries, edit));
    }
    *ended_early = !target.within_budget();
    // An inserted factor explains least, so it comes last. A factor 1 in the place of another factor is the same as leaving
    // that one out: drop it.
    let is_idle = |expr: &Expr| !retyped::has_idle_one(printed) && retyped::has_idle_one(expr);
    once.retain(|(edit, _)| !is_idle(&edit.expr));
    once.sort_by_key(|(edit, _)| edit.change.is_factor_inserted());
    let says_little = once
        .iter()
        .all(|(edit, _)| edit.change.is_factor_inserted());
    let found = proved(claim, statement, &subject, once);
    if found.is_some() && !says_little {
        return found;
    }
    let search = (claim, statement);
    if let Some(found) = retyped(search, &subject, &target) {
        return Some(found);
    }
    // Where names in the place of others used up the work, the edits without them have some of their own.
    let likely = || apart(search, &subject, &target, cautious(printed));
    if let Some(found) = solved(search, &subject, &target)
        .or(found)
        .or_else(|| ended_early.then(likely).flatten())
        .or_else(|| inserted(search, &subject, &target))
        .or_else(|| across(search, &subject))
    {
        return Some(found);
    }
    if let Some(found) = elsewhere(claim, statement, &subject, &target, &alphabet) {
        return Some(found);
    }
    if printed.size() > MAX_SIZE_DOUBLE || is_of_numbers(claim, &statement.expr) {
        return None;
    }
    // First edits that make an entry of a vector right come first.
    singles.sort_by_key(|(entries, _)| Reverse(*entries));
    let second_alphabet = alphabet.without_names();
    let mut twice = vec![];
    let mut budget = MAX_DOUBLE;
    'firsts: for (_, first) in singles.iter().take(MAX_FIRST) {
        for second in edits::single(&first.expr, &second_alphabet) {
            budget = budget.saturating_sub(1);
            if budget == 0 || twice.len() >= MAX_PROOFS || !target.within_budget() {
                break 'firsts;
            }
            let agrees = second.expr != *printed && target.agrees(&subject.side(&second.expr));
            if agrees && says_something(claim, &subject, [&first.expr, &second.expr]) {
                let changes = [&first.change, &second.change];
                let changes = changes.map(ToString::to_string).to_vec();
                twice.push((second, changes));
            }
        }
    }
    proved(claim, statement, &subject, twice)
}

/// Returns whether every operand beside the two edits still matters after the first and after the second (see
/// [`operands`]).
fn says_something(claim: &Claim, subject: &Subject, [first, second]: [&Expr; 2]) -> bool {
    let mut once = subject.clone();
    once.formula = first.clone();
    !operands::one_ceases_to_matter(claim, subject, first)
        && !operands::one_ceases_to_matter(claim, &once, second)
}

/// The search where a side has no value at the sample point: all edits that are tried once, on either side, at points of the
/// domain.
fn beside_roots(
    (claim, statement): (&Claim, &Written),
    subject: &Subject,
    ended_early: &mut bool,
) -> Option<Correction> {
    let mut search = |subject: &Subject, mut edits: Vec<Edit>| {
        edits.extend(insertions::edits(&subject.formula));
        if has_symbol(claim, &statement.expr) {
            edits.extend(points::numbers(&subject.formula));
        }
        *ended_early |= edits.len() > points::MAX_CANDIDATES;
        let found = points::agreeing(claim, statement, subject, edits);
        let described = found.into_iter().map(Edit::described).collect();
        proved(claim, statement, subject, described)
    };
    let alphabet = alphabet::alphabet(claim, &statement.expr, &subject.formula);
    let first = search(subject, edits::single(&subject.formula, &alphabet));
    first.or_else(|| {
        let other = subject.across(&statement.expr)?;
        search(&other, cautious(&other.formula))
    })
}

/// The edits of a side that was not taken for the printed one: those that change no name and leave out nothing.
fn cautious(formula: &Expr) -> Vec<Edit> {
    let size = formula.size();
    if size > MAX_OTHER_SIDE {
        return vec![];
    }
    let names = |expr: &Expr| -> Vec<String> {
        let mut names: Vec<_> = expr.names().into_iter().map(str::to_owned).collect();
        names.sort_unstable();
        names
    };
    let printed = names(formula);
    let mut edits = edits::single(formula, &Alphabet::default());
    edits.retain(|edit| {
        let keeps = edit.expr.size() >= size && names(&edit.expr) == printed;
        keeps && !edit.change.is_factor_inserted()
    });
    edits
}

/// A number that is solved for. Where no side depends on a symbol some number always fits: that is a coincidence.
fn solved(
    (claim, statement): (&Claim, &Written),
    subject: &Subject,
    target: &Target<'_>,
) -> Option<Correction> {
    if !has_symbol(claim, &statement.expr) {
        return None;
    }
    let edits = target.apart(MAX_APART, || {
        solved::edits(&subject.formula, subject, target)
    });
    let described = edits.into_iter().map(Edit::described).collect();
    proved(claim, statement, subject, described)
}

/// Whether a declared symbol stands in a formula. What is about numbers alone becomes true by many a number, which says
/// nothing.
fn has_symbol(claim: &Claim, expr: &Expr) -> bool {
    let declared = |name: &str| {
        let base = name.trim_end_matches('\'');
        claim.declarations.symbol(base).is_some()
    };
    expr.names().into_iter().any(declared)
}

/// Whether a formula is about numbers alone: nothing in it is declared or defined.
fn is_of_numbers(claim: &Claim, expr: &Expr) -> bool {
    let own = &claim.declarations;
    let has_meaning = |name: &str| {
        let base = name.trim_end_matches('\'');
        let stands_for_something = own.definition(base).is_some() || own.function(base).is_some();
        stands_for_something || own.basis(base).is_some()
    };
    !has_symbol(claim, expr) && !expr.names().into_iter().any(has_meaning)
}

/// An operator for another one, or brackets that were misplaced.
fn retyped(
    (claim, statement): (&Claim, &Written),
    subject: &Subject,
    target: &Target<'_>,
) -> Option<Correction> {
    if is_of_numbers(claim, &statement.expr) {
        return None;
    }
    let edits = retyped::edits(&subject.formula);
    apart((claim, statement), subject, target, edits)
}

/// An exponent or a shift that was left out.
fn inserted(
    search: (&Claim, &Written),
    subject: &Subject,
    target: &Target<'_>,
) -> Option<Correction> {
    let edits = insertions::edits(&subject.formula);
    apart(search, subject, target, edits)
}

/// An edit of the side that was not taken for the printed one.
fn across(search: (&Claim, &Written), printed: &Subject) -> Option<Correction> {
    let (claim, statement) = search;
    let subject = printed.across(&statement.expr)?;
    if !(MAX_TAUTOLOGY + 1..=MAX_OTHER_SIDE).contains(&subject.formula.size()) {
        return None;
    }
    let target = Target::new(claim, statement, &subject)?;
    let edits = cautious(&subject.formula);
    apart(search, &subject, &target, edits)
        .or_else(|| retyped(search, &subject, &target))
        .or_else(|| solved(search, &subject, &target))
        .or_else(|| inserted(search, &subject, &target))
}

/// The correction among some edits, found with work of its own.
fn apart(
    (claim, statement): (&Claim, &Written),
    subject: &Subject,
    target: &Target<'_>,
    edits: Vec<Edit>,
) -> Option<Correction> {
    let found = agreeing(subject, target, MAX_APART, edits);
    proved(claim, statement, subject, found)
}

/// The edits with which the sides agree at the sample point, with their changes in words.
fn agreeing(
    subject: &Subject,
    target: &Target<'_>,
    work: u64,
    edits: Vec<Edit>,
) -> Vec<(Edit, Vec<String>)> {
    target.apart(work, || {
        let agree = |edit: &Edit| target.agrees(&subject.side(&edit.expr));
        let found = edits.into_iter().filter(agree);
        found.map(Edit::described).collect()
    })
}

/// Tries one slip that shows in several places, in a definition of the printed side, or beside it.
fn elsewhere(
    claim: &Claim,
    statement: &Written,
    subject: &Subject,
    target: &Target<'_>,
    alphabet: &Alphabet,
) -> Option<Correction> {
    let spread = |formula: &Expr, alphabet: &Alphabet| {
        let mut edits = repeated::edits(formula, alphabet);
        edits.extend(names::edits(formula, alphabet));
        edits.extend(arguments::edits(formula, alphabet));
        edits
    };
    let search = |work: u64, subject: &Subject, edits: Vec<Edit>| {
        let found = agreeing(subject, target, work, edits);
        proved(claim, statement, subject, found)
    };
    search(
        MAX_ELSEWHERE / 3,
        subject,
        spread(&subject.formula, alphabet),
    )
    .or_else(|| moved(claim, statement, subject, target))
    .or_else(|| {
        let definitions = subject.definitions(claim, statement);
        let each = 2 * MAX_ELSEWHERE / 3 / (definitions.len().max(1) as u64);
        definitions.iter().find_map(|inner| {
            let alphabet = alphabet::alphabet(claim, &statement.expr, &inner.formula);
            let mut edits = edits::single(&inner.formula, &alphabet);
            edits.extend(spread(&inner.formula, &alphabet));
            search(each, inner, edits)
        })
    })
}

/// A factor moved across the relation.
fn moved(
    claim: &Claim,
    statement: &Written,
    subject: &Subject,
    target: &Target<'_>,
) -> Option<Correction> {
    let (_, parent) = subject.path.split_last()?;
    let comparison = parent.iter().try_fold(&statement.expr, |e, position| {
        e.parts().into_iter().nth(*position)
    })?;
    let (left, right) = move_factor::sides(comparison)?;
    let candidates = target.apart(MAX_ELSEWHERE / 3, || {
        move_factor::moved(left, right, target)
    });
    let mut found = candidates.into_iter().filter_map(|moved| {
        let equation = Node::Compare(moved.left.into(), vec![(Relation::Equal, moved.right)]);
        let expr = placed(&statement.expr, parent, Expr::made(equation));
        if is_assumed(claim, &expr) {
            return None;
        }
        let conditions = provable(claim, statement, &expr)?;
        Some(Correction {
            statement: notation::formula(&expr),
            conditions,
            edits: vec![moved.change],
            unique: true,
        })
    });
    let mut first = found.next()?;
    first.unique = found.next().is_none();
    Some(first)
}

/// Returns the conditions under which a corrected statement is proved, if it is.
fn provable(claim: &Claim, statement: &Written, expr: &Expr) -> Option<Vec<Formula>> {
    let trial = Written {
        expr: expr.clone(),
        origin: statement.origin.clone(),
    };
    let decided = decide_statement(claim, &trial).ok();
    match decided.and_then(|decision| decision.conditions()) {
        Some(conditions) => Some(conditions.iter().map(nonzero).collect()),
        None if injected(InjectedFault::CorrectionUnproved) => Some(vec![]),
        None => None,
    }
}

/// Proves candidates; the first proved one is the correction, and a second, essentially different one makes it not
/// unique.
fn proved(
    claim: &Claim,
    statement: &Written,
    subject: &Subject,
    candidates: Vec<(Edit, Vec<String>)>,
) -> Option<Correction> {
    let mut seen = BTreeSet::new();
    let mut found: Option<Correction> = None;
    for (edit, changes) in candidates {
        if seen.len() >= MAX_PROOFS {
            break;
        }
        let key = canonical::canonical(&edit.expr);
        if !seen.insert(key) {
            continue;
        }
        let expr = subject.statement(&statement.expr, &edit.expr);
        if is_tautology(claim, &expr, subject)
            || is_assumed(claim, &expr)
            || operands::one_ceases_to_matter(claim, subject, &edit.expr)
        {
            continue;
        }
        let Some(conditions) = provable(claim, statement, &expr) else {
            continue;
        };
        if let Some(first) = &mut found {
            first.unique = false;
            return found;
        }
        let mut edits = changes;
        if let Some(name) = subject.defined_as() {
            edits.push(format!("`{name}` then is `{}`", notation::text(&edit.expr)));
        }
        found = Some(Correction {
            statement: notation::formula(&expr),
            conditions,
            edits,
            unique: true,
        });
    }
    found
}

/// Whether a corrected statement is one of the hypotheses: no correction.
fn is_assumed(claim: &Claim, expr: &Expr) -> bool {
    let own = canonical::canonical(expr);
    let mut hypotheses = claim.assumptions.iter().chain(&claim.given);
    hypotheses.any(|hypothesis| canonical::canonical(&hypothesis.formula.expr) == own)
}

/// Whether both sides of the comparison at the end of the path are the same: no correction.
fn is_tautology(claim: &Claim, expr: &Expr, subject: &Subject) -> bool {
    let path = subject.path.as_slice();
    let parent = path.split_last().map_or(path, |(_, parent)| parent);
    let is_left = path.last() == Some(&0) && subject.defined_as().is_none();
    let comparison = parent
        .iter()
        .try_fold(expr, |e, position| e.parts().into_iter().nth(*position));
    match comparison.map(|e| &e.node) {
        // A long formula that becomes the left side is a corrected restatement; a short one says nothing, nor does one
        // of numbers, nor a left side that becomes what is printed.
        Some(Node::Compare(left, _))
            if left.size() > MAX_TAUTOLOGY && !is_left && !is_of_numbers(claim, expr) =>
        {
            false
        }
        Some(Node::Compare(left, rest)) => rest
            .iter()
            .any(|(_, right)| canonical::canonical(left) == canonical::canonical(right)),
        _ => false,
    }
}
