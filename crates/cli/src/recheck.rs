//! `torse recheck`: repeats the checks of verdicts with more work.

use crate::derivations::Derivations;
use crate::exit::{Exit, Failure};
use crate::format::{Format, json_line};
use crate::run::{Budget, Run};
use crate::terminal::Progress;
use crate::{terminal, watchdog};
use clap::Args;
use rayon::prelude::*;
use serde::Serialize;
use std::collections::BTreeMap;
use torse_report::ReportError;
use torse_syntax::derivation::{Claim, Paper};
use torse_verdicts::judged::Net;
use torse_verdicts::outcome::{Outcome, PaperOutcome};
use torse_verdicts::recheck::{self, Recheck};

/// Decide claims, replay their proofs, and test every verdict again with more work.
///
/// A checker that does not search goes through the proofs; a rejected proof is a contradiction.
///
/// The second evaluator shares only parser, declarations and numbers with the prover. A proved statement must be true
/// at sixty points of its domain, and an identity at small degrees; where a condition fails, the statement must be
/// false or undefined somewhere; a correction is tested like a proof; a refuted statement must fail at its
/// counterexample. `verify` does the same with less work. The exit code is 6 if a verdict is contradicted.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct RecheckCommand {
    /// Papers, claims, or prefixes of ids
    #[arg(value_name = "PAPER|ID")]
    names: Vec<String>,
    /// List every claim with the tests made, or why it is not netted
    #[arg(long)]
    verbose: bool,
    /// Print text, or a line of JSON for each claim
    #[arg(long, value_name = "FORMAT", default_value = "text")]
    format: Format,
    #[command(flatten)]
    budget: Budget,
    #[command(flatten)]
    derivations: Derivations,
}

const EXAMPLES: &str = "\
Examples:
  torse recheck
  torse recheck gbt-surfaces/thm-2 --verbose";

impl RecheckCommand {
    /// Decides, checks again, and prints the counts and every contradiction.
    pub fn run(&self) -> Result<Exit, Failure> {
        let (papers, mut mistakes) = self.derivations.select(&self.names)?;
        let run = Run::new(&papers, self.budget, &mut mistakes);
        let judged = recheck_claims(&papers, &run.papers);
        watchdog::finished();
        if self.format == Format::Json {
            let lines: Result<String, ReportError> = judged.iter().map(claim_line).collect();
            terminal::print(&lines?)?;
            let all_agree = judged.iter().all(|(_, result)| !is_contradicted(result));
            return Ok(mistakes.tell(match all_agree {
                true => Exit::AsExpected,
                false => Exit::Contradiction,
            }));
        }
        let mut counts = [0_usize; 4];
        let mut rows = terminal::table();
        for (id, result) in &judged {
            let (place, word, detail) = describe(result);
            if let Some(count) = counts.get_mut(place) {
                *count += 1;
            }
            if self.verbose || is_contradicted(result) {
                rows.add_row([id.as_str(), word, detail.as_str()]);
            }
        }
        let [netted, contradicted, decided, nothing] = counts;
        let replayed = run.outcomes().filter_map(|outcome| outcome.replay());
        let (mut accepted, mut beyond) = (0_usize, 0_usize);
        for replay in replayed {
            match replay.is_whole() {
                true => accepted += 1,
                false => beyond += 1,
            }
        }
        let mut text = String::new();
        if !rows.is_empty() {
            text.push_str(&terminal::lines(&rows));
            text.push('\n');
        }
        text.push_str(&format!(
            "{netted} netted, {contradicted} contradicted, {decided} decided and not netted, {nothing} without a verdict to judge\n"
        ));
        text.push_str(&format!(
            "{accepted} proofs replayed by the checker, {beyond} out of its reach\n"
        ));
        terminal::print(&text)?;
        Ok(mistakes.tell(match contradicted {
            0 => Exit::AsExpected,
            _ => Exit::Contradiction,
        }))
    }
}

/// A line of JSON about a claim.
#[derive(Serialize)]
struct RecheckedClaim<'a> {
    id: &'a str,
    /// `netted`, `contradicted`, `not netted`, or `no verdict`.
    result: &'static str,
    /// The tests, or what contradicts the verdict.
    detail: &'a str,
}

fn claim_line((id, result): &(String, Recheck)) -> Result<String, ReportError> {
    let (_, result, detail) = describe(result);
    json_line(&RecheckedClaim {
        id,
        result,
        detail: &detail,
    })
}

fn is_contradicted(result: &Recheck) -> bool {
    matches!(result, Recheck::Contradicted { .. })
}

/// The checked claims with their ids, in file order.
fn recheck_claims(papers: &[Paper], decided: &[PaperOutcome]) -> Vec<(String, Recheck)> {
    let claims = papers.iter().flat_map(|paper| &paper.claims);
    let outcomes = decided.iter().flat_map(|paper| &paper.claims);
    let outcomes: BTreeMap<&str, &Outcome> = outcomes.map(|o| (o.claim.id.as_str(), o)).collect();
    let pairs: Vec<(&Claim, &Outcome)> = claims
        .filter_map(|claim| Some((claim, *outcomes.get(claim.entry.id.get_ref().as_str())?)))
        .collect();
    let progress = Progress::new("judging again", pairs.len());
    let judged = pairs.par_iter().map(|(claim, outcome)| {
        let result = watchdog::guarded(&outcome.claim.id, || recheck::claim(claim, outcome));
        progress.step();
        (outcome.claim.id.clone(), result)
    });
    let judged = judged.collect();
    progress.finish();
    judged
}

/// Returns the position of the count, the word, and the details of a result.
fn describe(result: &Recheck) -> (usize, &'static str, String) {
    match result {
        Recheck::Netted(net) => (0, "netted", tried(net)),
        Recheck::Contradicted { found } => (1, "contradicted", found.clone()),
        Recheck::Decided(net) => {
            let why = net.why.as_deref().unwrap_or("few points were decided");
            (2, "not netted", format!("{}: {why}", tried(net)))
        }
        Recheck::Nothing => (3, "no verdict", String::new()),
    }
}

/// Describes the tests, in words.
fn tried(net: &Net) -> String {
    let counted = |count: u64, one: &str, many: &str| match count {
        1 => format!("1 {one}"),
        _ => format!("{count} {many}"),
    };
    let points = |count: u64| counted(count, "point", "points");
    let mut parts = vec![points(net.decided)];
    if net.instances > 0 {
        parts.push(counted(net.instances, "identity", "identities"));
    }
    for sides in &net.conditions {
        let beyond = points(sides.failing + sides.undefined);
        parts.push(format!("{} needed at {beyond}", sides.condition));
    }
    if let Some(correction) = &net.correction {
        parts.push(format!("the correction at {}", tried(correction)));
    }
    parts.join(", ")
}
