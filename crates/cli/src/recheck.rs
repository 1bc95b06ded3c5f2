//! `torse recheck`: outcomes replayed by the naive evaluator.

use crate::derivations::{Derivations, Found};
use crate::exit::{Exit, Failure};
use crate::run::{Budget, Run};
use crate::terminal::Progress;
use crate::{guard, selection, terminal};
use clap::Args;
use rayon::prelude::*;
use std::collections::BTreeMap;
use torse_language::derivation::{Claim, Paper};
use torse_verdicts::outcome::{Outcome, PaperOutcome};
use torse_verdicts::recheck::{self, Recheck};

/// Decide claims and replay the outcomes with a second, naive evaluator.
///
/// The second evaluator shares the parser and the rational numbers with the engine and nothing else: maps
/// for polynomials, families by their recursion, sums term by term. An identity must vanish at small
/// degrees, a refuted statement must not, and its correction must. The exit code is 6 when an outcome is
/// contradicted.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct Replay {
    /// Papers, claims, or beginnings of ids
    #[arg(value_name = "PAPER|ID")]
    names: Vec<String>,
    /// List every claim with the instances at which it was replayed, or why it was not
    #[arg(long)]
    verbose: bool,
    #[command(flatten)]
    budget: Budget,
    #[command(flatten)]
    derivations: Derivations,
}

const EXAMPLES: &str = "\
Examples:
  torse recheck
  torse recheck gbt-surfaces/thm-2 --verbose";

impl Replay {
    /// Decides, replays, prints the counts and every contradiction.
    pub fn run(&self) -> Result<Exit, Failure> {
        let Found {
            papers,
            left_out,
            mut mistakes,
        } = self.derivations.load()?;
        let papers = selection::select(papers, &self.names, &left_out)?;
        let run = Run::of(&papers, self.budget, &mut mistakes);
        let replayed = replay(&papers, &run.papers);
        guard::finished();
        let mut counts = [0_usize; 3];
        let mut rows = terminal::table();
        for (id, result) in &replayed {
            let (place, word, detail) = told(result);
            if let Some(count) = counts.get_mut(place) {
                *count += 1;
            }
            if self.verbose || matches!(result, Recheck::Contradicted { .. }) {
                rows.add_row([id.as_str(), word, detail.as_str()]);
            }
        }
        let [confirmed, contradicted, rest] = counts;
        let mut text = String::new();
        if !rows.is_empty() {
            text.push_str(&terminal::lines(&rows));
            text.push('\n');
        }
        text.push_str(&format!(
            "{confirmed} confirmed, {contradicted} contradicted, {rest} not of a kind that can be replayed\n"
        ));
        terminal::print(&text)?;
        Ok(mistakes.tell(match contradicted {
            0 => Exit::AsExpected,
            _ => Exit::Contradiction,
        }))
    }
}

/// The replayed claims with their ids, in file order.
fn replay(papers: &[Paper], decided: &[PaperOutcome]) -> Vec<(String, Recheck)> {
    let claims = papers.iter().flat_map(|paper| &paper.claims);
    let outcomes = decided.iter().flat_map(|paper| &paper.claims);
    let outcomes: BTreeMap<&str, &Outcome> = outcomes.map(|o| (o.id.as_str(), o)).collect();
    let pairs: Vec<(&Claim, &Outcome)> = claims
        .filter_map(|claim| Some((claim, *outcomes.get(claim.entry.id.get_ref().as_str())?)))
        .collect();
    let progress = Progress::new("replaying", pairs.len());
    let replayed = pairs.par_iter().map(|(claim, outcome)| {
        let result = guard::named(&outcome.id, || recheck::claim(claim, outcome));
        progress.step();
        (outcome.id.clone(), result)
    });
    let replayed = replayed.collect();
    progress.finish();
    replayed
}

/// The place of the count, the word, and the details of a result.
fn told(result: &Recheck) -> (usize, &'static str, String) {
    match result {
        Recheck::Confirmed { instances } => (0, "confirmed", instances.join("; ")),
        Recheck::Contradicted { instance, found } => {
            let place = match instance.as_str() {
                "" => String::new(),
                instance => format!("at {instance}: "),
            };
            (1, "contradicted", format!("{place}{found}"))
        }
        Recheck::NotReplayable { reason } => (2, "not replayed", reason.clone()),
    }
}
