//! Flags: signs that a statement is not what the paper prints.
//!
//! No program can decide whether a formula says what a sentence says. But where it does not, there is often a sign: a
//! side that is compared with itself, a number that the print has and the statement lacks, one degree for all. Each
//! family of signs has a file here. A flag is not a verdict: either the statement is changed, or the file of the claim
//! answers the flag with words of the paper. An answer to a flag that does not exist is an error.

mod accusations;
mod conclusion;
mod corrected_words;
mod formulas;
mod garbled;
mod hypotheses;
mod instance;
mod occurrences;
mod paper_names;
mod parts;
mod passages;
mod print;
mod quotes;
mod reads;
mod same_print;
mod setting;
mod sides;
mod slips;
mod sources;
mod subject;
mod unstated;

pub use corrected_words::{CorrectedWords, FormulasOfWords};
pub use passages::is_formula;
pub(crate) use sides::compares;

use crate::outcome::Outcome;
use formulas::Formulas;
use print::Print;
use rayon::prelude::*;
use same_print::Sentences;
use setting::Setting;
use std::collections::BTreeMap;
use torse_core::stack;
use torse_syntax::derivation::{Answer, Claim, Paper};
use torse_syntax::taxonomy::{Flag, Kind};

/// A flag at a claim.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct RaisedFlag {
    /// The kind of flag.
    pub flag: Flag,
    /// What raised it, in words.
    pub evidence: String,
}

/// The flags at one claim, and the answers of its file.
#[derive(Debug)]
pub struct Audited<'a> {
    /// The claim.
    pub claim: &'a Claim,
    /// Flags without an answer.
    pub open: Vec<RaisedFlag>,
    /// Flags with their answers.
    pub answered: Vec<(RaisedFlag, &'a Answer)>,
    /// Answers to flags that do not exist.
    pub stale: Vec<&'a Answer>,
}

/// The input of the families of flags.
struct Subject<'a> {
    claim: &'a Claim,
    outcome: &'a Outcome,
    formulas: Formulas<'a>,
    print: Print,
    /// The print of this claim and of those that it rests on: what it uses or quotes, and the other parts of its
    /// sentence.
    context: Print,
    /// The claims that it rests on, directly or through others.
    rests_on: Vec<&'a Claim>,
    /// The relations that all parts of the sentence state together.
    relations_of_all_parts: usize,
    /// Whether it stands in a worked folder of ours, and in no paper.
    is_worked: bool,
}

/// Looks for flags at the claims of these papers, and calls `done` after each. Parts of a sentence are counted together
/// if all of them are present.
#[must_use]
pub fn audit<'a>(
    papers: &'a [Paper],
    claims: &[(&'a Claim, &'a Outcome)],
    done: impl Fn() + Sync,
) -> Vec<Audited<'a>> {
    let mut together: BTreeMap<&str, usize> = BTreeMap::new();
    for (claim, _) in claims {
        if let Some(whole) = claim.sentence_id() {
            *together.entry(whole).or_default() += parts::relations_of(claim);
        }
    }
    let setting = Setting::new(papers);
    let sentences = Sentences::new(claims);
    let audited = |(claim, outcome): &(&'a Claim, &'a Outcome)| {
        let whole = claim.sentence_id().and_then(|id| together.get(id.as_str()));
        let mut flags = stack::deep(|| flags(claim, outcome, &setting, whole.copied()));
        flags.extend(sentences.other_verdicts(claim));
        done();
        answered(claim, flags)
    };
    // Mutants of a statement are decided like claims; any free thread takes one.
    let each = claims.par_iter().with_max_len(1);
    each.map(audited).collect()
}

/// The words of the correction of a claim, ready to be compared with what is decided; none where there are no words.
#[must_use]
pub fn corrected_words(
    papers: &[Paper],
    claim: &Claim,
    outcome: &Outcome,
) -> Option<CorrectedWords> {
    reads::corrected_words(claim, outcome, &Setting::new(papers))
}

/// Returns the flags at a claim and at its readings, in the order of their declaration.
fn flags<'a>(
    claim: &'a Claim,
    outcome: &Outcome,
    setting: &Setting<'a>,
    of_all_parts: Option<usize>,
) -> Vec<RaisedFlag> {
    let printed = subject(claim, claim, outcome, setting, of_all_parts);
    let mut flags = match claim.readings.is_empty() {
        true => flags_of_reading(&printed),
        false => vec![],
    };
    flags.extend(reads::differing_corrections(
        claim, outcome, setting, &printed,
    ));
    flags.extend(accusations::without_verdict(claim, outcome, setting));
    flags.extend(accusations::corrected_readings(claim, outcome, setting));
    for (reading, found) in claim.readings.iter().zip(outcome.readings()) {
        let read = subject(&reading.claim, claim, &found.outcome, setting, of_all_parts);
        for raised in flags_of_reading(&read) {
            let evidence = format!("read as `{}`: {}", reading.name, raised.evidence);
            flags.push(RaisedFlag { evidence, ..raised });
        }
    }
    flags.sort();
    flags.dedup();
    flags
}

/// What is looked at: a claim, or a reading of it.
fn subject<'s>(
    claim: &'s Claim,
    whole: &'s Claim,
    outcome: &'s Outcome,
    setting: &Setting<'s>,
    of_all_parts: Option<usize>,
) -> Subject<'s> {
    Subject {
        claim,
        outcome,
        formulas: Formulas::new(claim),
        print: Print::from_text(&claim.entry.printed),
        context: Print::from_text(&setting.prints(whole)),
        rests_on: setting.rests_on(whole),
        relations_of_all_parts: of_all_parts.unwrap_or_else(|| parts::relations_of(claim)),
        is_worked: setting.is_worked(whole.entry.id.get_ref()),
    }
}

/// Returns the flags at a claim, or at a reading of it.
fn flags_of_reading(subject: &Subject<'_>) -> Vec<RaisedFlag> {
    let claim = subject.claim;
    if claim.entry.kind == Kind::Figure {
        return vec![];
    }
    let mut flags = vec![];
    let mut add = |found: Vec<RaisedFlag>| flags.extend(found);
    add(unstated::unstated_relations(subject));
    add(garbled::unfounded_excuses(subject));
    if claim.statement.is_none() {
        return flags;
    }
    add(sides::equations_with_equal_sides(subject));
    add(subject::nothing_of_the_paper(subject));
    add(conclusion::assumed(subject));
    add(slips::unfalsifiable_equations(subject));
    add(hypotheses::unneeded(subject));
    // The words of a remark are ours, so there is no print to differ from.
    if claim.entry.kind != Kind::Remark {
        add(occurrences::numbers(subject));
        add(occurrences::names(subject));
        add(occurrences::relations(subject));
        add(parts::missing_relations(subject));
        add(instance::fixed_degrees(subject));
        add(instance::single_coordinates(subject));
        add(instance::fixed_values(subject));
        add(unstated::unstated_names_of_reading(subject));
        add(quotes::mismatched_quotations(subject));
        add(sources::missing_sources(subject));
    }
    flags
}

/// Matches flags with the answers of the file; one answer covers all flags of its kind.
fn answered(claim: &Claim, flags: Vec<RaisedFlag>) -> Audited<'_> {
    let answer = |flag: Flag| claim.answers.iter().find(|answer| answer.flag == flag);
    let stale = claim.answers.iter();
    let stale = stale.filter(|answer| !flags.iter().any(|raised| raised.flag == answer.flag));
    let stale = stale.collect();
    let (mut open, mut found) = (vec![], vec![]);
    for raised in flags {
        match answer(raised.flag) {
            Some(answer) => found.push((raised, answer)),
            None => open.push(raised),
        }
    }
    Audited {
        claim,
        open,
        answered: found,
        stale,
    }
}

/// Makes a flag.
fn raised(flag: Flag, evidence: impl Into<String>) -> RaisedFlag {
    RaisedFlag {
        flag,
        evidence: evidence.into(),
    }
}

/// Makes one flag for several things; none for an empty list.
fn one_flag_for(flag: Flag, what: &str, things: Vec<String>) -> Vec<RaisedFlag> {
    match things.is_empty() {
        true => vec![],
        false => vec![raised(flag, format!("{what}: {}", things.join(", ")))],
    }
}
