//! `torse explain`: one claim like a referee's note.

use crate::derivations::Derivations;
use crate::exit::{Exit, Failure};
use crate::run::Run;
use crate::{selection, terminal};
use clap::Args;
use comfy_table::ColumnConstraint;
use torse_claims::derivation::Paper;
use torse_claims::{Correction, Formula, Outcome, PaperOutcome, Witness};
use torse_report::words;

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
    derivations: Derivations,
}

const EXAMPLES: &str = "\
Examples:
  torse explain gbt-developable/thm-4.c
  torse explain gbt-surfaces/thm-4 --longest 100000";

impl Explain {
    /// Decides the claim and prints the note.
    pub fn run(&self) -> Result<Exit, Failure> {
        let papers = self.derivations.load()?;
        let users = Users::of(&papers);
        let paper = selection::select_one(papers, &self.name)?;
        let run = Run::of(std::slice::from_ref(&paper))?;
        for paper in &run.papers {
            for outcome in &paper.claims {
                terminal::print(&self.note(paper, outcome, &users))?;
            }
        }
        Ok(Exit::AsExpected)
    }

    fn note(&self, paper: &PaperOutcome, outcome: &Outcome, users: &Users) -> String {
        let mut note = Note::default();
        note.add("paper", &format!("{}, {}", paper.title, paper.venue));
        note.add("where", &outcome.at);
        note.add("printed", &outcome.printed);
        note.option("our reading", outcome.reading.as_deref());
        note.option("understood", self.formula(outcome.parsed.as_ref()));
        note.list("assuming", self.formulas(&outcome.assumed));
        note.gap();
        note.add("verdict", &verdict(outcome));
        note.option(
            "evidence",
            outcome.evidence.map(|of| {
                let of = words::evidence(of);
                format!("{}. {}", of.label, of.meaning)
            }),
        );
        let condition = match outcome.evidence {
            Some(_) => "on condition",
            None => "condition",
        };
        note.list(condition, self.formulas(&outcome.conditions));
        note.list("steps", outcome.steps.iter().cloned());
        note.gap();
        if let Some(witness) = &outcome.witness {
            add_witness(&mut note, witness);
        }
        note.option("left - right", self.formula(outcome.difference.as_ref()));
        note.option("derived right", self.formula(outcome.derived.as_ref()));
        if let Some(correction) = &outcome.correction {
            note.gap();
            note.add("corrected", &self.cut(&correction.statement.text));
            note.list("by", edits(correction));
        }
        note.gap();
        note.option("note", outcome.note.as_deref());
        note.list("uses", outcome.uses.iter().cloned());
        note.list("used by", users.of_claim(&outcome.id));
        format!("{}\n\n{}", terminal::heading(&outcome.id), note.text())
    }

    fn formula(&self, formula: Option<&Formula>) -> Option<String> {
        formula.map(|formula| self.cut(&formula.text))
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

fn verdict(outcome: &Outcome) -> String {
    let found = terminal::verdict(outcome.verdict);
    let meaning = words::verdict(outcome.verdict).meaning;
    match outcome.expect {
        Some(expected) if expected != outcome.verdict => {
            let expected = words::verdict(expected).label;
            format!("{found} (the derivation file expects {expected}). {meaning}")
        }
        _ => format!("{found}. {meaning}"),
    }
}

fn add_witness(note: &mut Note, witness: &Witness) {
    let values = witness
        .at
        .iter()
        .map(|(name, value)| format!("{name} = {value}"));
    let point: Vec<String> = values.collect();
    if !point.is_empty() {
        note.add("fails at", &point.join(", "));
    }
    note.add("left there", &side(&witness.left, &witness.left_decimal));
    note.add("right there", &side(&witness.right, &witness.right_decimal));
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
    correction.edits.iter().cloned().chain([unique.to_owned()])
}

/// Which claims rest on which, over all papers.
struct Users(Vec<(String, Vec<String>)>);

impl Users {
    fn of(papers: &[Paper]) -> Self {
        let claims = papers.iter().flat_map(|paper| &paper.claims);
        let uses = claims.map(|claim| (claim.entry.id.get_ref().clone(), claim.entry.uses.clone()));
        Users(uses.collect())
    }

    fn of_claim(&self, id: &str) -> impl Iterator<Item = String> {
        let users = self
            .0
            .iter()
            .filter(move |(_, uses)| uses.iter().any(|used| used == id));
        users.map(|(user, _)| user.clone())
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
