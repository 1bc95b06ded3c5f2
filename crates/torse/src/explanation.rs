//! A claim like a referee's note: labels and texts in groups.

use crate::error::Error;
use crate::selection;
use crate::verifier::Verifier;
use serde::Serialize;
use torse_prove::evidence::Witness;
use torse_report::{counted, dependency_groups, difference, glossary, point};
use torse_syntax::derivation::{DerivationError, Paper};
use torse_syntax::notation::Formula;
use torse_syntax::taxonomy::Verdict;
use torse_verdicts::claim_record::Role;
use torse_verdicts::consequences::{consequences, resting, users};
use torse_verdicts::correction::Correction;
use torse_verdicts::outcome::{FaultChange, Outcome, PaperFault, PaperOutcome};
use torse_verdicts::words;

/// The meaning of the level *kernel*.
const ACCEPTED: &str = "accepted: Rocq has proofs of the statements of this verdict (`torse prove --check` asks it again).";

/// What is known of a claim, ready to be set: labels on the left, plain texts on the right, in groups.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize)]
#[non_exhaustive]
pub struct Explanation {
    /// The groups; none is empty.
    pub groups: Vec<Vec<ExplanationLine>>,
}

/// A line of an [`Explanation`].
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[non_exhaustive]
pub struct ExplanationLine {
    /// What it says; empty where it goes on with the label above.
    pub label: String,
    /// The text. That of a `verdict` begins with the label of the verdict.
    pub text: String,
}

impl Explanation {
    /// The first text under a label.
    #[must_use]
    pub fn text(&self, label: &str) -> Option<&str> {
        let mut lines = self.groups.iter().flatten();
        let line = lines.find(|line| line.label == label)?;
        Some(&line.text)
    }
}

/// An explanation that is being written.
#[derive(Default)]
struct Note {
    groups: Vec<Vec<ExplanationLine>>,
    current: Vec<ExplanationLine>,
}

impl Note {
    fn add(&mut self, label: &str, text: &str) {
        self.current.push(ExplanationLine {
            label: label.to_owned(),
            text: text.to_owned(),
        });
    }

    fn option(&mut self, label: &str, text: Option<impl AsRef<str>>) {
        if let Some(text) = text {
            self.add(label, text.as_ref());
        }
    }

    fn list(&mut self, label: &str, texts: impl Iterator<Item = String>) {
        for (position, text) in texts.enumerate() {
            let label = if position == 0 { label } else { "" };
            self.add(label, &text);
        }
    }

    /// Begins a group, unless the one before has nothing in it.
    fn gap(&mut self) {
        let group = std::mem::take(&mut self.current);
        if !group.is_empty() {
            self.groups.push(group);
        }
    }

    fn whole(mut self) -> Explanation {
        self.gap();
        Explanation {
            groups: self.groups,
        }
    }
}

/// The explanation of a claim of a paper, formulas cut after so many characters. `kernel` says whether the kernel accepted
/// its proofs.
pub fn full(
    paper: &PaperOutcome,
    outcome: &Outcome,
    resting: Resting,
    kernel: bool,
    longest: usize,
) -> Explanation {
    Cut(longest).note(paper, outcome, resting, kernel)
}

/// How many characters of a formula are shown.
#[derive(Clone, Copy)]
struct Cut(usize);

impl Cut {
    fn note(
        &self,
        paper: &PaperOutcome,
        outcome: &Outcome,
        resting: Resting,
        kernel: bool,
    ) -> Explanation {
        let mut note = Note::default();
        note.add("verdict", &verdict(outcome));
        let each = outcome.readings().iter().map(|reading| {
            let verdict = glossary::verdict(reading.outcome.verdict()).label;
            format!("{} if read as {}", verdict, reading.name)
        });
        note.list("namely", each);
        let found = found(paper, outcome);
        let short = found.as_deref().map(torse_report::sentence_in_short);
        note.option("found", short.clone());
        self.difference(&mut note, paper, outcome);
        note.list("on condition", self.formulas(outcome.conditions()));
        self.readings(&mut note, outcome);
        note.list("true form", true_forms(paper, outcome).into_iter());
        note.gap();
        let length = |text: &str| text.trim_end_matches('.').chars().count();
        let shown = short.as_deref().map_or(0, length);
        note.option("in full", found.filter(|whole| length(whole) > shown));
        note.gap();
        add_witness(&mut note, outcome);
        let part = derived_part(outcome);
        let derived = |formula| Some(self.formula(formula)? + &part);
        note.option("left - right", derived(outcome.difference()));
        note.option("derived", derived(outcome.derived()));
        if let Some(data) = outcome.data() {
            note.gap();
            note.list("right if", words::data_correction(data).into_iter());
        }
        note.gap();
        note.list(resting.label, resting.rows.into_iter());
        note.gap();
        let title = [paper.title.trim(), paper.venue.trim()];
        let title: Vec<&str> = title.into_iter().filter(|part| !part.is_empty()).collect();
        note.add("paper", &title.join(", "));
        note.add("place", &outcome.claim.at);
        note.option("our reading", outcome.claim.reading.as_deref());
        let assumed = outcome.claim.assumed.iter();
        let assumed = assumed.filter(|hypothesis| hypothesis.role == Role::Assume);
        note.list("assuming", assumed.map(|h| self.cut(&h.formula.text)));
        self.dependency_groups(&mut note, outcome);
        note.option("copy at hand", outcome.claim.garbled.as_deref());
        note.option(
            "note",
            outcome.claim.note.as_deref().filter(|own| {
                let own = torse_report::plain(own);
                short != Some(torse_report::sentence_in_short(&own))
            }),
        );
        note.list("uses", outcome.claim.uses.iter().cloned());
        note.gap();
        note.option(
            "evidence",
            glossary::evidence_on(outcome).map(|own| format!("{}. {}", own.label, own.meaning)),
        );
        note.option("replayed", replayed(outcome));
        let unvisited = outcome.net().map(|net| net.unvisited.iter());
        let unvisited = unvisited.into_iter().flatten();
        note.list("not tried where", unvisited.map(|part| self.cut(part)));
        note.option("kernel", kernel.then_some(ACCEPTED));
        let own = torse_report::own_steps(outcome);
        note.list("steps", counted(&own).into_iter());
        note.whole()
    }

    /// Adds the print and its correction, or how the print was understood, with differences marked.
    fn difference(&self, note: &mut Note, paper: &PaperOutcome, outcome: &Outcome) {
        note.gap();
        let mut changes = paper.faults.iter().flat_map(|fault| &fault.changes);
        match changes.find(|change| change.claim == outcome.claim.id) {
            Some(change) => {
                let [printed, reads] = difference(&change.printed, &change.reads);
                note.add("printed", &printed);
                note.add("should read", &reads);
                if change.printed != outcome.claim.printed {
                    note.add("in", &outcome.claim.printed);
                }
            }
            None => note.add(
                glossary::words_of(outcome.claim.kind),
                &outcome.claim.printed,
            ),
        }
        add_statement(note, "understood", outcome, |text| self.cut(text));
    }

    fn dependency_groups(&self, note: &mut Note, outcome: &Outcome) {
        for group in dependency_groups(outcome) {
            note.list(group.label, group.lines.iter().map(|line| self.cut(line)));
        }
    }

    /// Each reading like a small note.
    fn readings(&self, note: &mut Note, outcome: &Outcome) {
        for reading in outcome.readings() {
            let of = &reading.outcome;
            note.gap();
            note.add("read as", &format!("{}: {}", reading.name, reading.says));
            note.add("verdict", &verdict(of));
            note.option("understood", self.formula(of.parsed()));
            let assumed = of.claim.assumed.iter();
            let assumed = assumed.filter(|hypothesis| hypothesis.role == Role::Assume);
            note.list("assuming", assumed.map(|h| self.cut(&h.formula.text)));
            self.dependency_groups(note, of);
            note.list("on condition", self.formulas(of.conditions()));
            note.list("steps", counted(&words::steps(of)).into_iter());
            add_witness(note, of);
        }
    }

    fn formula(&self, formula: Option<&Formula>) -> Option<String> {
        // A vector of any dimension is its own coordinate.
        formula.map(|formula| self.cut(&formula.text.replace("[]", "")))
    }

    fn formulas(&self, formulas: &[Formula]) -> impl Iterator<Item = String> {
        formulas.iter().map(|formula| self.cut(&formula.text))
    }

    fn cut(&self, formula: &str) -> String {
        match formula.char_indices().nth(self.0) {
            Some((end, _)) => {
                let (shown, rest) = formula.split_at(end);
                format!(
                    "{shown} ... (and {} characters: --longest)",
                    rest.chars().count()
                )
            }
            None => formula.to_owned(),
        }
    }
}

/// The explanation of a claim that has nothing printed: what is true of it, where it fails, what would be right, and
/// what that rests on.
pub fn short(outcome: &Outcome) -> Explanation {
    let mut note = Note::default();
    note.add("verdict", glossary::verdict(outcome.verdict()).label);
    let texts = |formulas: &[Formula]| -> Vec<String> {
        formulas
            .iter()
            .map(|formula| formula.text.clone())
            .collect()
    };
    add_statement(&mut note, "stated", outcome, str::to_owned);
    note.list("on condition", texts(outcome.conditions()).into_iter());
    note.gap();
    add_witness(&mut note, outcome);
    note.gap();
    let assumed = outcome.claim.assumed.iter();
    let assumed = assumed.filter(|hypothesis| hypothesis.role == Role::Assume);
    note.list("assuming", assumed.map(|h| h.formula.text.clone()));
    for group in dependency_groups(outcome) {
        note.list(group.label, group.lines.into_iter());
    }
    note.gap();
    note.option(
        "evidence",
        glossary::evidence_on(outcome).map(|own| own.label.to_owned()),
    );
    note.option("replayed", replayed(outcome));
    note.list("steps", counted(&words::steps(outcome)).into_iter());
    note.whole()
}

/// The statement as it is understood, and what corrects it, what differs marked.
fn add_statement(
    note: &mut Note,
    label: &'static str,
    outcome: &Outcome,
    shown: impl Fn(&str) -> String,
) {
    // A vector of any dimension is its own coordinate.
    let plain = |formula: &Formula| formula.text.replace("[]", "");
    match (outcome.parsed(), outcome.correction()) {
        (Some(parsed), Some(correction)) => {
            let [stated, corrected] = difference(&plain(parsed), &plain(&correction.statement));
            note.add(label, &shown(&stated));
            note.add("corrected", &shown(&corrected));
            note.list("by", edits(correction));
        }
        (parsed, _) => note.option(label, parsed.map(|formula| shown(&plain(formula)))),
    }
}

/// The one sentence that matters: the fault of which the authors are told, what the file found, or where the statement
/// fails.
fn found(paper: &PaperOutcome, outcome: &Outcome) -> Option<String> {
    let note = outcome
        .claim
        .author_note
        .as_deref()
        .map(torse_report::plain);
    let shows = |fault: &&PaperFault| fault.shows_in(&outcome.claim.id);
    let fault = paper
        .faults
        .iter()
        .find(shows)
        .filter(|fault| !fault.says.is_empty());
    note.or_else(|| fault.map(|fault| torse_report::plain(&fault.says)))
        .or_else(|| {
            let refuted = matches!(outcome.verdict(), Verdict::False | Verdict::Misprint);
            let in_words = || torse_report::finding_in_words(outcome, &[]);
            match outcome.verdict() {
                Verdict::Depends => return outcome.claim.note.clone().or_else(in_words),
                Verdict::Conditional => return in_words(),
                _ => {}
            }
            let fails = || {
                outcome
                    .claim
                    .note
                    .clone()
                    .or_else(|| torse_report::failure_in_full(outcome))
            };
            refuted.then(fails).flatten()
        })
        .map(|text| torse_report::plain(&text))
}

/// Returns the remarks that state the true form.
fn true_forms(paper: &PaperOutcome, outcome: &Outcome) -> Vec<String> {
    let shows = |fault: &&PaperFault| fault.shows_in(&outcome.claim.id);
    let changes = paper
        .faults
        .iter()
        .filter(shows)
        .flat_map(|fault| &fault.changes);
    let changes: Vec<&FaultChange> = changes.collect();
    let (own, others): (Vec<&FaultChange>, Vec<&FaultChange>) = changes
        .into_iter()
        .partition(|change| change.claim == outcome.claim.id);
    let remarks = |of: &[&FaultChange]| -> Vec<String> {
        let mut remarks: Vec<String> = of.iter().filter_map(|c| c.remark.clone()).collect();
        remarks.dedup();
        remarks
    };
    let refuted = matches!(outcome.verdict(), Verdict::False | Verdict::Misprint);
    let is_corrected = outcome.correction().is_some() || !own.is_empty() || !refuted;
    match (remarks(&own), remarks(&others)) {
        (own, _) if is_corrected || !own.is_empty() => own,
        (_, of_fault) if !of_fault.is_empty() => of_fault,
        // Where the text is corrected by which this one holds: what it uses, or else the first correction.
        _ => {
            let is_used = |change: &&&FaultChange| outcome.claim.uses.contains(&change.claim);
            let used: Vec<&&FaultChange> = others.iter().filter(is_used).collect();
            let first = others.iter().take(1).collect();
            let corrected: Vec<&&FaultChange> = if used.is_empty() { first } else { used };
            let reads = corrected.iter().map(|change| {
                let reads = torse_report::plain(&change.reads);
                format!("{} should read {reads}", change.claim)
            });
            reads.collect()
        }
    }
}

/// Describes the result of the checker of proofs.
fn replayed(outcome: &Outcome) -> Option<String> {
    let replay = outcome.replay()?;
    let correction = replay.correction.as_ref();
    let failing = [
        ("the proof", replay.why.as_ref()),
        (
            "the proof of the correction",
            correction.and_then(|own| own.why.as_ref()),
        ),
    ];
    let failing: Vec<String> = failing
        .into_iter()
        .filter_map(|(subject, why)| Some(format!("the checker cannot follow {subject}: {}", why?)))
        .collect();
    Some(match (replay.is_whole(), correction) {
        (true, None) => "yes".to_owned(),
        (true, Some(_)) => "yes, and so is the proof of the correction".to_owned(),
        (false, _) => format!("no: {}", failing.join("; ")),
    })
}

fn verdict(outcome: &Outcome) -> String {
    let found = glossary::verdict(outcome.verdict()).label;
    let meaning = glossary::verdict_on(outcome).meaning;
    match outcome.claim.expect {
        Some(expected) if expected != outcome.verdict() => {
            let expected = glossary::verdict(expected).label;
            format!("{found} (the derivation file expects {expected}). {meaning}")
        }
        _ => format!("{found}. {meaning}"),
    }
}

/// Adds the point at which a statement fails, with its sides there; for a refuted denial, what is proved.
fn add_witness(note: &mut Note, outcome: &Outcome) {
    let Some(witness) = outcome.witness() else {
        return;
    };
    if glossary::denied(outcome) {
        note.option("proved", torse_report::failure_in_full(outcome));
        return;
    }
    let values =
        point(witness).map(|(name, value)| format!("{} = {value}", name.trim_end_matches("[]")));
    let point: Vec<String> = values.collect();
    if !point.is_empty() {
        note.add("fails at", &point.join(", "));
    }
    let coordinates = of_one_coordinate(outcome, witness);
    if !coordinates.is_empty() {
        let of = coordinates.join(", ");
        note.add("", &format!("(one coordinate of {of})"));
    }
    if witness.left == witness.right {
        note.option("namely", torse_report::failure_in_full(outcome));
        return;
    }
    note.add("left side", &side(&witness.left, &witness.left_decimal));
    note.add("right side", &side(&witness.right, &witness.right_decimal));
}

/// Describes which part the derived formulas of a refutation cover: one entry, or one instance of small degrees.
fn derived_part(outcome: &Outcome) -> String {
    let Some(refuted) = outcome.refuted() else {
        return String::new();
    };
    let entries = refuted.differing_entries();
    let entries: Vec<String> = entries.iter().map(usize::to_string).collect();
    let mut part = vec![];
    if !entries.is_empty() {
        part.push(match entries.as_slice() {
            [one] => format!("entry {one}"),
            _ => format!("entries {}", entries.join(", ")),
        });
    }
    if let Some(integers) = refuted.instance() {
        part.push(format!("for {}", words::certificate::values(integers)));
    }
    if part.is_empty() {
        String::new()
    } else {
        format!(" ({})", part.join(" "))
    }
}

/// Returns the points of any dimension that a counterexample gives one coordinate of.
fn of_one_coordinate<'o>(outcome: &'o Outcome, witness: &Witness) -> Vec<&'o str> {
    let symbols = outcome.claim.table.symbols.iter();
    let of_any = symbols.filter(|symbol| symbol.set.ends_with("of any dimension"));
    let names = of_any.map(|symbol| symbol.name.as_str());
    let is_given = |name: &str| {
        let mut members = witness.at.iter().map(|(of, _)| of.split('[').next());
        members.any(|own| own == Some(name))
    };
    names.filter(|name| is_given(name)).collect()
}

fn side(exact: &str, decimal: &str) -> String {
    match decimal.is_empty() || exact == decimal {
        true => exact.to_owned(),
        false => format!("{exact} = {decimal}"),
    }
}

fn edits(correction: &Correction) -> impl Iterator<Item = String> {
    let unique = match correction.unique {
        true => "no other correction with as few edits was found",
        false => "other corrections with as few edits exist",
    };
    words::correction(correction)
        .into_iter()
        .chain([unique.to_owned()])
}

/// The claims that depend on the explained one, as rows of the note.
pub struct Resting {
    label: &'static str,
    rows: Vec<String>,
}

impl Resting {
    /// For a refuted claim, returns all claims that depend on it, each decided to see whether it survives; for any
    /// other claim, the claims that use it. Also returns errors of their formulas.
    pub fn on(
        outcome: &Outcome,
        papers: &[Paper],
        verifier: &Verifier<'_>,
    ) -> Result<(Self, Vec<DerivationError>), Error> {
        let claims = papers.iter().flat_map(|paper| &paper.claims);
        let uses: Vec<(&str, Vec<String>)> = claims
            .map(|claim| (claim.entry.id.get_ref().as_str(), claim.uses.clone()))
            .collect();
        let users = users(uses.iter().map(|(id, uses)| (*id, uses.as_slice())));
        if !matches!(outcome.verdict(), Verdict::False | Verdict::Misprint) {
            let direct = users.get(outcome.claim.id.as_str());
            let own = Self {
                label: "used by",
                rows: direct
                    .into_iter()
                    .flatten()
                    .map(|id| (*id).to_owned())
                    .collect(),
            };
            return Ok((own, vec![]));
        }
        let ids = resting(&outcome.claim.id, &users);
        let ids: Vec<&str> = ids.into_iter().map(|(id, _)| id).collect();
        let verified = verifier.verify(&selection::only(papers, &ids))?;
        let all: Vec<&Outcome> = std::iter::once(outcome)
            .chain(verified.outcomes())
            .collect();
        let rows = consequences(&outcome.claim.id, &all)
            .into_iter()
            .map(|consequence| {
                let fate = glossary::consequence(&consequence);
                match consequence.through.last() {
                    Some(nearest) => format!("{}: {fate} (rests on {nearest})", consequence.id),
                    None => format!("{}: {fate}", consequence.id),
                }
            });
        let own = Self {
            label: "depends on it",
            rows: rows.collect(),
        };
        Ok((own, verified.mistakes))
    }
}
