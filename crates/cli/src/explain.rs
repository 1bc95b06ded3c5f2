//! `torse explain`: one claim like a referee's note.

use crate::derivations::{Derivations, Found};
use crate::diagnostics::Diagnostics;
use crate::exit::{Exit, Failure};
use crate::kernel::Kernel;
use crate::run::{Budget, Run};
use crate::{selection, terminal, watchdog};
use clap::Args;
use comfy_table::ColumnConstraint;
use torse_prove::evidence::Witness;
use torse_report::{counted, dependency_groups, difference, glossary, point};
use torse_syntax::derivation::Paper;
use torse_syntax::notation::Formula;
use torse_syntax::taxonomy::Verdict;
use torse_verdicts::claim_record::Role;
use torse_verdicts::consequences::{consequences, resting, users};
use torse_verdicts::correction::Correction;
use torse_verdicts::outcome::{Outcome, PaperFault, PaperOutcome};

/// Explain one claim: what is printed, how it was understood, what is true, and why.
///
/// A refuted claim comes with an exact counterexample, the difference of both sides, and the derived right
/// side; where a small correction was proved, with that. Explaining is no judging: the exit code is 0
/// whatever the verdict.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct Explain {
    /// The claim's id, or the beginning of one id only
    #[arg(value_name = "ID")]
    name: String,
    /// The most characters of a formula to show
    #[arg(long, value_name = "CHARACTERS", default_value_t = 2000)]
    longest: usize,
    #[command(flatten)]
    kernel: Kernel,
    #[command(flatten)]
    budget: Budget,
    #[command(flatten)]
    derivations: Derivations,
}

/// What the level *kernel* means.
const ACCEPTED: &str = "accepted: Rocq has proofs of the statements of this verdict (`torse prove --check` asks it again).";

const EXAMPLES: &str = "\
Examples:
  torse explain gbt-developable/thm-4.c
  torse explain gbt-surfaces/thm-4 --longest 100000";

impl Explain {
    /// Decides the claim and prints the note.
    pub fn run(&self) -> Result<Exit, Failure> {
        let Found {
            papers,
            left_out,
            mut mistakes,
        } = self.derivations.load()?;
        if left_out.contains(&self.name) {
            return Ok(mistakes.tell(Exit::BadData));
        }
        let paper = selection::select_one(&papers, &self.name)?;
        let run = Run::new(std::slice::from_ref(&paper), self.budget, &mut mistakes);
        let kernel = self.kernel.accepted(std::slice::from_ref(&paper), &run);
        for paper in &run.papers {
            for outcome in &paper.claims {
                let resting = Resting::on(outcome, &papers, self.budget, &mut mistakes);
                watchdog::finished();
                let kernel = kernel.contains(&outcome.claim.id);
                terminal::print(&self.note(paper, outcome, resting, kernel))?;
            }
        }
        Ok(mistakes.tell(Exit::AsExpected))
    }

    fn note(
        &self,
        paper: &PaperOutcome,
        outcome: &Outcome,
        resting: Resting,
        kernel: bool,
    ) -> String {
        let mut note = Note::default();
        note.add("verdict", &verdict(outcome));
        let each = outcome.readings().iter().map(|reading| {
            let verdict = glossary::verdict(reading.outcome.verdict()).label;
            format!("{} if read as {}", verdict, reading.name)
        });
        note.list("namely", each);
        note.option("found", found(paper, outcome));
        self.difference(&mut note, paper, outcome);
        note.list("on condition", self.formulas(outcome.conditions()));
        self.readings(&mut note, outcome);
        note.list("true form", true_forms(paper, outcome).into_iter());
        note.gap();
        add_witness(&mut note, outcome);
        let part = derived_part(outcome);
        let derived = |formula| Some(self.formula(formula)? + &part);
        note.option("left - right", derived(outcome.difference()));
        note.option("derived", derived(outcome.derived()));
        if let Some(data) = outcome.data() {
            note.gap();
            note.list("right if", data.in_words().into_iter());
        }
        note.gap();
        note.list(resting.label, resting.rows.into_iter());
        note.gap();
        note.add("paper", &format!("{}, {}", paper.title, paper.venue));
        note.add("where", &outcome.claim.at);
        note.option("our reading", outcome.claim.reading.as_deref());
        let assumed = outcome.claim.assumed.iter();
        let assumed = assumed.filter(|hypothesis| hypothesis.role == Role::Assume);
        note.list("assuming", assumed.map(|h| self.cut(&h.formula.text)));
        self.dependency_groups(&mut note, outcome);
        note.option("copy at hand", outcome.claim.garbled.as_deref());
        note.option("note", outcome.claim.note.as_deref());
        note.list("uses", outcome.claim.uses.iter().cloned());
        note.gap();
        note.option(
            "evidence",
            glossary::evidence_on(outcome).map(|of| format!("{}. {}", of.label, of.meaning)),
        );
        note.option("replayed", replayed(outcome));
        note.option("kernel", kernel.then_some(ACCEPTED));
        note.list("steps", counted(&outcome.steps()).into_iter());
        format!(
            "{}\n\n{}",
            terminal::heading(&outcome.claim.id),
            note.text()
        )
    }

    /// What is printed and what is to be read, or how the print was understood, what differs marked.
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
            None => note.add("printed", &outcome.claim.printed),
        }
        match (outcome.parsed(), outcome.correction()) {
            (Some(parsed), Some(correction)) => {
                let [understood, corrected] = difference(
                    &parsed.text.replace("[]", ""),
                    &correction.statement.text.replace("[]", ""),
                );
                note.add("understood", &self.cut(&understood));
                note.add("corrected", &self.cut(&corrected));
                note.list("by", edits(correction));
            }
            (parsed, _) => note.option("understood", self.formula(parsed)),
        }
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
            note.list("steps", counted(&of.steps()).into_iter());
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
        match formula.char_indices().nth(self.longest) {
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

/// A claim that has nothing printed: what is true of it, where it fails, what would be right, and what that rests on.
pub fn short_note(outcome: &Outcome) -> String {
    let mut note = Note::default();
    note.add("verdict", &terminal::verdict(outcome.verdict()));
    let texts = |formulas: &[Formula]| -> Vec<String> {
        formulas
            .iter()
            .map(|formula| formula.text.clone())
            .collect()
    };
    match (outcome.parsed(), outcome.correction()) {
        (Some(parsed), Some(correction)) => {
            let [stated, corrected] = difference(&parsed.text, &correction.statement.text);
            note.add("stated", &stated);
            note.add("corrected", &corrected);
            note.list("by", edits(correction));
        }
        (parsed, _) => note.option("stated", parsed.map(|formula| formula.text.clone())),
    }
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
        glossary::evidence_on(outcome).map(|of| of.label.to_owned()),
    );
    note.option("replayed", replayed(outcome));
    note.list("steps", counted(&outcome.steps()).into_iter());
    note.text()
}

/// The one sentence that matters: the fault of which the authors are told, what the file found, or where the statement fails.
fn found(paper: &PaperOutcome, outcome: &Outcome) -> Option<String> {
    let told = outcome
        .claim
        .author_note
        .as_deref()
        .map(torse_report::plain);
    let shows = |fault: &&PaperFault| fault.shows.contains(&outcome.claim.id);
    let fault = paper
        .faults
        .iter()
        .find(shows)
        .filter(|fault| !fault.says.is_empty());
    told.or_else(|| fault.map(|fault| torse_report::plain(&fault.says)))
        .or_else(|| {
            let refuted = matches!(outcome.verdict(), Verdict::False | Verdict::Misprint);
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

/// The remarks that state what is true instead.
fn true_forms(paper: &PaperOutcome, outcome: &Outcome) -> Vec<String> {
    let shows = |fault: &&PaperFault| fault.shows.contains(&outcome.claim.id);
    let changes = paper
        .faults
        .iter()
        .filter(shows)
        .flat_map(|fault| &fault.changes);
    let own = changes.filter(|change| change.claim == outcome.claim.id);
    own.filter_map(|change| change.remark.clone()).collect()
}

/// What the checker of proofs found.
fn replayed(outcome: &Outcome) -> Option<String> {
    let replay = outcome.replay()?;
    let correction = replay.correction.as_ref();
    let correction = correction.map(|own| match &own.why {
        None => "; the proof of the correction too".to_owned(),
        Some(why) => format!("; the proof of the correction is not: {why}"),
    });
    Some(match &replay.why {
        None => {
            let done = "yes: a checker without search accepts the proof";
            format!("{done}{}", correction.unwrap_or_default())
        }
        Some(why) => format!("no: {why}{}", correction.unwrap_or_default()),
    })
}

fn verdict(outcome: &Outcome) -> String {
    let found = terminal::verdict(outcome.verdict());
    let meaning = glossary::verdict_on(outcome).meaning;
    match outcome.claim.expect {
        Some(expected) if expected != outcome.verdict() => {
            let expected = glossary::verdict(expected).label;
            format!("{found} (the derivation file expects {expected}). {meaning}")
        }
        _ => format!("{found}. {meaning}"),
    }
}

/// The point at which a statement fails, with its sides there; of one that is refuted by a proof, what is proved.
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
    note.add("left there", &side(&witness.left, &witness.left_decimal));
    note.add("right there", &side(&witness.right, &witness.right_decimal));
}

/// Of what the derived formulas of a refutation are a part: one entry, or one instance of small degrees.
fn derived_part(outcome: &Outcome) -> String {
    let steps = outcome.steps();
    let instance = steps
        .iter()
        .find_map(|step| step.strip_prefix("the instance "));
    let entry = steps
        .iter()
        .find_map(|step| step.strip_prefix("entr"))
        .and_then(|step| step.split_once(' '))
        .map(|(_, list)| {
            list.trim_end_matches(" differs")
                .trim_end_matches(" differ")
        });
    let mut of = vec![];
    of.extend(entry.map(|place| format!("entry {place}")));
    of.extend(instance.map(|values| format!("at {values}")));
    match of.is_empty() {
        true => String::new(),
        false => format!(" ({})", of.join(", ")),
    }
}

/// The points of any dimension of which a witness has a coordinate.
fn of_one_coordinate<'o>(outcome: &'o Outcome, witness: &Witness) -> Vec<&'o str> {
    let symbols = outcome.claim.table.symbols.iter();
    let of_any = symbols.filter(|symbol| symbol.set.ends_with("of any dimension"));
    let names = of_any.map(|symbol| symbol.name.as_str());
    let told = |name: &str| {
        let mut members = witness.at.iter().map(|(of, _)| of.split('[').next());
        members.any(|of| of == Some(name))
    };
    names.filter(|name| told(name)).collect()
}

fn side(exact: &str, decimal: &str) -> String {
    match decimal.is_empty() || exact == decimal {
        true => exact.to_owned(),
        false => format!("{exact} = {decimal}"),
    }
}

fn edits(correction: &Correction) -> impl Iterator<Item = String> {
    let unique = match correction.unique {
        true => "no other repair with as few edits was found",
        false => "other repairs with as few edits exist",
    };
    correction.in_words().into_iter().chain([unique.to_owned()])
}

/// The claims that rest on the explained one, as rows of the note.
struct Resting {
    label: &'static str,
    rows: Vec<String>,
}

impl Resting {
    /// For a refuted claim, all that rests on it, each decided to see whether it survives; for any other
    /// the claims that use it.
    fn on(outcome: &Outcome, papers: &[Paper], budget: Budget, mistakes: &mut Diagnostics) -> Self {
        let claims = papers.iter().flat_map(|paper| &paper.claims);
        let uses: Vec<(&str, Vec<String>)> = claims
            .map(|claim| (claim.entry.id.get_ref().as_str(), claim.uses.clone()))
            .collect();
        let users = users(uses.iter().map(|(id, uses)| (*id, uses.as_slice())));
        if !matches!(outcome.verdict(), Verdict::False | Verdict::Misprint) {
            let direct = users.get(outcome.claim.id.as_str());
            return Self {
                label: "used by",
                rows: direct
                    .into_iter()
                    .flatten()
                    .map(|id| (*id).to_owned())
                    .collect(),
            };
        }
        let ids = resting(&outcome.claim.id, &users);
        let ids: Vec<&str> = ids.into_iter().map(|(id, _)| id).collect();
        let run = Run::new(&selection::only(papers, &ids), budget, mistakes);
        let all: Vec<&Outcome> = std::iter::once(outcome).chain(run.outcomes()).collect();
        let rows = consequences(&outcome.claim.id, &all)
            .into_iter()
            .map(|consequence| {
                let fate = glossary::consequence(&consequence);
                match consequence.through.last() {
                    Some(nearest) => format!("{}: {fate} (rests on {nearest})", consequence.id),
                    None => format!("{}: {fate}", consequence.id),
                }
            });
        Self {
            label: "rests on it",
            rows: rows.collect(),
        }
    }
}

/// A note: labels on the left, texts on the right, in groups.
#[derive(Default)]
struct Note {
    groups: Vec<Vec<[String; 2]>>,
    current: Vec<[String; 2]>,
}

impl Note {
    fn add(&mut self, label: &str, text: &str) {
        self.current.push([label.to_owned(), text.to_owned()]);
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

    /// Begins a group, after an empty line unless the one before has nothing in it.
    fn gap(&mut self) {
        let group = std::mem::take(&mut self.current);
        if !group.is_empty() {
            self.groups.push(group);
        }
    }

    fn text(mut self) -> String {
        self.gap();
        let mut table = terminal::table();
        let groups = self.groups.len();
        for (position, group) in self.groups.into_iter().enumerate() {
            table.add_rows(group);
            if position + 1 < groups {
                table.add_row(["", ""]);
            }
        }
        if let Some(labels) = table.column_mut(0) {
            labels.set_constraint(ColumnConstraint::ContentWidth);
        }
        terminal::lines(&table)
    }
}
