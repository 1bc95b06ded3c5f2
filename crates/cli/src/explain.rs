//! `torse explain`: one claim, as in a referee's report.

use crate::derivations::{Derivations, LoadedDerivations};
use crate::exit::{Exit, Failure};
use crate::format::{Format, json_line};
use crate::kernel::Kernel;
use crate::run::{Budget, Run};
use crate::{terminal, watchdog};
use clap::Args;
use comfy_table::ColumnConstraint;
use serde::Serialize;
use torse::explanation::{Resting, full};
use torse::report::glossary::{VERDICTS, verdict};
use torse::{Explanation, selection};

/// Explain one claim, or all of a paper: what is printed, how it was understood, what is true, and why.
///
/// For a refuted claim, torse shows an exact counterexample, the difference of both sides, the derived right side, and
/// a small correction if one was proved. The exit code is 0 for every verdict.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct Explain {
    /// The claim's id, a prefix of only one id, or a paper
    #[arg(value_name = "PAPER|ID")]
    name: String,
    /// Show at most this many characters of a formula
    #[arg(long, value_name = "CHARACTERS", default_value_t = 2000)]
    longest: usize,
    /// Print text, or a line of JSON for each claim: its id, and groups of labels and texts
    #[arg(long, value_name = "FORMAT", default_value = "text")]
    format: Format,
    #[command(flatten)]
    kernel: Kernel,
    #[command(flatten)]
    budget: Budget,
    #[command(flatten)]
    derivations: Derivations,
}

const EXAMPLES: &str = "\
Examples:
  torse explain gbt-developable/thm-4.c
  torse explain bezier
  torse explain bezier --format json
  torse explain gbt-surfaces/thm-4 --longest 100000";

impl Explain {
    /// Decides the claim and prints the note.
    pub fn run(&self) -> Result<Exit, Failure> {
        let LoadedDerivations {
            papers,
            left_out,
            mut mistakes,
        } = self.derivations.load()?;
        if left_out.contains(&self.name) {
            return Ok(mistakes.tell(Exit::BadData));
        }
        let paper = match papers.iter().find(|paper| paper.head.id == self.name) {
            Some(whole) => whole.clone(),
            None => selection::select_one(&papers, &self.name)?,
        };
        let run = Run::new(std::slice::from_ref(&paper), self.budget, &mut mistakes);
        let kernel = self.kernel.accepted(std::slice::from_ref(&paper), &run);
        for paper in &run.papers {
            for (position, outcome) in paper.claims.iter().enumerate() {
                let before = if position > 0 { "\n" } else { "" };
                let (resting, wrong) = Resting::on(outcome, &papers, &self.budget.verifier())?;
                wrong
                    .into_iter()
                    .for_each(|error| mistakes.add(Box::new(error)));
                watchdog::finished();
                let kernel = kernel.contains(&outcome.claim.id);
                let note = full(paper, outcome, resting, kernel, self.longest);
                let id = &outcome.claim.id;
                terminal::print(&match self.format {
                    Format::Text => format!("{before}{}\n\n{}", terminal::heading(id), text(&note)),
                    Format::Json => json_line(&ExplainedClaim { id, note: &note })?,
                })?;
            }
        }
        Ok(mistakes.tell(Exit::AsExpected))
    }
}

/// A line of JSON about a claim.
#[derive(Serialize)]
struct ExplainedClaim<'a> {
    id: &'a str,
    #[serde(flatten)]
    note: &'a Explanation,
}

/// An explanation as a text for the terminal: verdicts in their colours.
pub fn text(explanation: &Explanation) -> String {
    let mut table = terminal::table();
    for (position, group) in explanation.groups.iter().enumerate() {
        if position > 0 {
            table.add_row(["", ""]);
        }
        for line in group {
            let text = match line.label.as_str() {
                "verdict" => coloured(&line.text),
                _ => line.text.clone(),
            };
            table.add_row([line.label.clone(), text]);
        }
    }
    if let Some(labels) = table.column_mut(0) {
        labels.set_constraint(ColumnConstraint::ContentWidth);
    }
    terminal::lines(&table)
}

/// A text that begins with the label of a verdict.
fn coloured(text: &str) -> String {
    let found = VERDICTS.iter().find_map(|listed| {
        let rest = text.strip_prefix(verdict(*listed).label)?;
        let whole = !rest.starts_with(char::is_alphabetic);
        whole.then(|| format!("{}{rest}", terminal::verdict(*listed)))
    });
    found.unwrap_or_else(|| text.to_owned())
}
