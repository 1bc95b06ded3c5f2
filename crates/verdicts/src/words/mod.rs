//! What is found, in words: findings are data, and these functions alone say what they show.

pub mod certificate;

use crate::certificate::DecisionCertificate;
use crate::correction::{Correction, DataChange, DataCorrection};
use crate::finding::{Finding, ReadingOutcome};
use crate::judged::Net;
use crate::outcome::Outcome;
use crate::statement::{
    Contradiction, EmptyDomain, FigureFinding, NoNumber, PartFinding, PartVerdict, ProvedStatement,
    RefutedStatement,
};
use torse_certificate::{Evidence, Proof};
use torse_prove::decide::Unsettled;
use torse_prove::decide::value::plain;
use torse_prove::existential::FoundWitness;
use torse_syntax::taxonomy::Verdict;

/// Describes the steps of a decision, in order.
#[must_use]
pub fn steps(outcome: &Outcome) -> Vec<String> {
    match &outcome.finding {
        Finding::Definition => vec![],
        Finding::Figure(figure) => figure_data(figure),
        Finding::Underspecified(why) | Finding::OutOfScope(why) => vec![why.clone()],
        Finding::Unstated(why) => vec![format!("not stated yet: {why}")],
        Finding::Undecided(undecided) => undecided.reasons.clone(),
        Finding::Contradicted(Contradiction { claimed, found }) => vec![
            format!("internal contradiction: the proof says {claimed:?}, but {found}"),
            "please report this claim".to_owned(),
        ],
        Finding::Proved(judged) => [proved(&judged.statement), notes(&judged.net)].concat(),
        Finding::Refuted(judged) => [refuted(&judged.statement), notes(&judged.net)].concat(),
        Finding::Vacuous(judged) => vacuous(&judged.statement),
        Finding::Readings(readings) => readings.all().iter().map(reading).collect(),
    }
}

/// Says why a statement is not settled, and what was tried.
#[must_use]
pub(crate) fn unsettled(own: &Unsettled) -> Vec<String> {
    let instances = Proof::Instances(own.instances.clone()).map(&plain);
    let instances = certificate::proof(&instances);
    [vec![own.reason.clone()], instances, own.tried.clone()].concat()
}

/// Describes a number that was found.
#[must_use]
pub(crate) fn found_witness(own: &FoundWitness) -> String {
    format!("there is {} = {}", own.name, own.value.text)
}

/// Describes the change and the conditions of a corrected statement, a line each.
#[must_use]
pub fn correction(own: &Correction) -> Vec<String> {
    let conditions = own.conditions.iter();
    let conditions = conditions.map(|condition| format!("true if `{}`", condition.text));
    own.edits.iter().cloned().chain(conditions).collect()
}

/// Describes which data to change and what that explains, a line each.
#[must_use]
pub fn data_correction(own: &DataCorrection) -> Vec<String> {
    let change = |c: &DataChange| {
        format!(
            "`{}` reads `{}` instead of `{}`",
            c.name, c.new.text, c.old.text
        )
    };
    let mut lines: Vec<String> = own.changes.iter().map(change).collect();
    if let DecisionCertificate::Proof { of, .. } = own.certificate.plain() {
        lines.extend(certificate::proof(&of));
    }
    lines.push(match (own.explains_example, own.explains.as_slice()) {
        (true, [_, _, ..]) => {
            "this one change explains every wrong value of the example".to_owned()
        }
        (_, [_, _, ..]) => format!("it explains {}", own.explains.join(", ")),
        _ => "it explains this value alone".to_owned(),
    });
    if !own.contradicts.is_empty() {
        lines.push(format!("it contradicts {}", own.contradicts.join(", ")));
    }
    lines.push(match own.unique {
        true => "no other change of as few numbers, as close to the print, was found".to_owned(),
        false => {
            "other changes of as few numbers, as close to the print, explain it too".to_owned()
        }
    });
    lines
}

fn figure_data(own: &FigureFinding) -> Vec<String> {
    let listed = |what: &'static str, list: &[String]| -> Vec<String> {
        list.iter().map(|item| format!("{what}: {item}")).collect()
    };
    let replaced = listed("our own in place of what is not printed", &own.replaced);
    let assumed = listed("assumed", &own.assumed);
    [own.missing.clone(), replaced, assumed].concat()
}

fn proved(own: &ProvedStatement) -> Vec<String> {
    let witnesses = own.witnesses.iter().map(found_witness);
    let ranges = own.ranges.iter();
    let ranges = ranges.map(|one| certificate::range(&one.map(&plain)));
    let reasons = match own.certificate.plain() {
        DecisionCertificate::Proof { of, .. } => certificate::reasons(&of),
        DecisionCertificate::Refutation(of) => certificate::refutation(&of),
    };
    witnesses.chain(reasons).chain(ranges).collect()
}

fn refuted(own: &RefutedStatement) -> Vec<String> {
    let steps = match own
        .certificate
        .as_ref()
        .map(|certificate| certificate.plain())
    {
        Some(DecisionCertificate::Refutation(of)) => certificate::refutation(&of),
        Some(DecisionCertificate::Proof { of, .. }) => certificate::proof(&of),
        None => vec![],
    };
    let no_number = own.no_number.iter().map(no_number);
    let parts = own.parts.iter().map(part);
    steps.into_iter().chain(no_number).chain(parts).collect()
}

fn vacuous(own: &EmptyDomain) -> Vec<String> {
    let witnesses = own.witnesses.iter().map(found_witness);
    let why = certificate::emptiness(&own.emptiness.map(&plain));
    witnesses.chain([why]).collect()
}

fn no_number(own: &NoNumber) -> String {
    let names = own.names.join(", ");
    let place = place(&own.at);
    let opposite = &own.opposite.text;
    format!("there is no {names} {place}: `{opposite}` holds there for all")
}

/// Names a point: `at x = 0, y = 1`.
#[must_use]
pub(crate) fn place(at: &[(String, String)]) -> String {
    let values = at.iter().map(|(name, value)| format!("{name} = {value}"));
    let values: Vec<String> = values.collect();
    if values.is_empty() {
        "everywhere".to_owned()
    } else {
        format!("at {}", values.join(", "))
    }
}

/// Describes what is found of a part of a conjunction.
fn part(own: &PartFinding) -> String {
    let found = match own.finding {
        PartVerdict::Holds(evidence) => format!("holds, by {}", means(evidence)),
        PartVerdict::Conditional(evidence) => {
            format!("holds under a condition, by {}", means(evidence))
        }
        PartVerdict::Fails => "fails".to_owned(),
        PartVerdict::Vacuous => "says nothing: no point satisfies the hypotheses".to_owned(),
        PartVerdict::Undecided => "is not decided".to_owned(),
    };
    format!("the part `{}` {found}", own.part.text)
}

fn means(evidence: Evidence) -> &'static str {
    match evidence {
        Evidence::Identity => "an identity",
        Evidence::Induction => "induction",
        Evidence::Inequality => "a certificate of sign",
        Evidence::Enclosure => "certified digits",
        Evidence::Witness => "an exact point",
        Evidence::CheckedRange | Evidence::Sampled => "instances that were tried",
    }
}

/// Names the conditions of a decision that were not seen to be needed.
fn notes(net: &Net) -> Vec<String> {
    let correction = net.correction.iter().flat_map(|net| &net.conditions);
    let sides = net.conditions.iter().chain(correction);
    let suspicious = sides.filter(|sides| sides.is_suspicious());
    let notes = suspicious.map(|sides| {
        format!(
            "the condition `{}` was not seen to be needed: the statement is true at {} points at which it fails",
            sides.condition, sides.holding
        )
    });
    notes.collect()
}

fn reading(own: &ReadingOutcome) -> String {
    let verdict = match own.outcome.verdict() {
        Verdict::Holds => "it holds",
        Verdict::Conditional => "it holds under a condition",
        Verdict::Misprint => "it is a misprint",
        Verdict::False => "it is false",
        Verdict::Undecided => "it is undecided",
        Verdict::Vacuous => "no point satisfies its hypotheses",
        Verdict::Definition => "it is a definition",
        Verdict::Depends
        | Verdict::Underspecified
        | Verdict::OutOfScope
        | Verdict::Reproduced
        | Verdict::Partial => "it is not decided",
    };
    format!("read as “{}” ({}): {verdict}", own.name, own.says)
}
