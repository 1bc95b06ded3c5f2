//! Deciding claims, verdicts first and corrections after them, with progress on the terminal.

use crate::diagnostics::Diagnostics;
use crate::terminal::Progress;
use crate::watchdog;
use rayon::prelude::*;
use std::time::{Duration, Instant};
use torse_syntax::derivation::{Claim, DerivationError, Paper};
use torse_verdicts::engine::STANDARD_WORK;
use torse_verdicts::faults::faults;
use torse_verdicts::outcome::{Outcome, PaperOutcome};
use torse_verdicts::pending_claim::PendingClaim;
use torse_verdicts::restore::restore;

/// The option that bounds the work on a claim.
#[derive(Debug, Clone, Copy, clap::Args)]
pub struct Budget {
    /// The most work on a claim, in units of one product of coefficients; what needs more is undecided
    #[arg(long = "budget", value_name = "UNITS", default_value_t = STANDARD_WORK)]
    units: u64,
}

impl Budget {
    /// The most work on a claim.
    pub fn units(self) -> u64 {
        self.units
    }
}

/// The outcomes of a run, and how long each claim took.
pub struct Run {
    /// The papers with their decided claims, in file order.
    pub papers: Vec<PaperOutcome>,
    /// Ids and times, in file order.
    pub timings: Vec<(String, Duration)>,
}

impl Run {
    /// Decides all claims of `papers`, of all papers at once, and then seeks corrections of those that are refuted. Claims whose formulas make no sense are mistakes of theirs,
    /// and have no outcome.
    pub fn new(papers: &[Paper], budget: Budget, mistakes: &mut Diagnostics) -> Self {
        let claims: Vec<_> = papers
            .iter()
            .flat_map(|paper| paper.claims.iter().map(|claim| (&paper.head.id, claim)))
            .collect();
        let progress = Progress::new("deciding", claims.len());
        let stages: Vec<_> = claims
            .par_iter()
            // A claim takes from microseconds to a second: each may go to whoever is free.
            .with_max_len(1)
            .map(|(slug, claim)| {
                let decided = timed(claim, || PendingClaim::verdict(budget.units, slug, claim));
                progress.step();
                decided
            })
            .collect();
        progress.finish();
        let sought =
            |(stage, _): &Decided<'_>| stage.as_ref().is_ok_and(PendingClaim::seeks_correction);
        let progress = Progress::new("correcting", stages.iter().filter(|of| sought(of)).count());
        let decided: Vec<_> = claims
            .par_iter()
            .zip(stages)
            .with_max_len(1)
            .map(|((_, claim), decided)| {
                let (seeks, (stage, before)) = (sought(&decided), decided);
                let (outcome, after) = timed(claim, || stage.and_then(PendingClaim::complete));
                if seeks {
                    progress.step();
                }
                outcome.map(|outcome| (outcome, before + after))
            })
            .collect();
        progress.finish();
        // Collected first and looked at in file order, so that mistakes are always told in the same order.
        let mut decided = decided.into_iter();
        let mut run = Run {
            papers: Vec::with_capacity(papers.len()),
            timings: Vec::with_capacity(claims.len()),
        };
        for paper in papers {
            let mut outcomes = Vec::with_capacity(paper.claims.len());
            for decision in decided.by_ref().take(paper.claims.len()) {
                match decision {
                    Ok((outcome, time)) => {
                        run.timings.push((outcome.claim.id.clone(), time));
                        outcomes.push(outcome);
                    }
                    Err(error) => mistakes.add(error),
                }
            }
            let faults = faults(paper, &outcomes).unwrap_or_else(|error| {
                mistakes.add(error);
                vec![]
            });
            run.papers.push(PaperOutcome {
                slug: paper.head.id.clone(),
                title: paper.head.title.clone(),
                authors: paper.head.authors.clone(),
                venue: paper.head.venue.clone(),
                claims: outcomes,
                faults,
                restored: vec![],
            });
        }
        run
    }

    /// Decides the claims in which faults show once more, with all corrections of their paper in force.
    pub fn restore(&mut self, papers: &[Paper], budget: Budget, mistakes: &mut Diagnostics) {
        for (paper, outcome) in papers.iter().zip(&mut self.papers) {
            match restore(budget.units, paper, outcome) {
                Ok(restored) => outcome.restored = restored,
                Err(error) => mistakes.add(error),
            }
        }
    }

    /// All outcomes, in file order.
    pub fn outcomes(&self) -> impl Iterator<Item = &Outcome> {
        self.papers.iter().flat_map(|paper| &paper.claims)
    }

    /// The slowest claims, slowest first.
    pub fn slowest(&self, count: usize) -> Vec<(&str, Duration)> {
        let mut slowest: Vec<_> = self
            .timings
            .iter()
            .map(|(id, time)| (id.as_str(), *time))
            .collect();
        slowest.sort_by_key(|(_, time)| std::cmp::Reverse(*time));
        slowest.truncate(count);
        slowest
    }
}

/// What the first stage of a claim found, and how long it took.
type Decided<'c> = (Result<PendingClaim<'c>, Box<DerivationError>>, Duration);

/// Does something for a claim under the eyes of the guard, and says how long it took.
fn timed<T>(claim: &Claim, job: impl FnOnce() -> T) -> (T, Duration) {
    let start = Instant::now();
    let done = watchdog::named(claim.entry.id.get_ref(), job);
    (done, start.elapsed())
}
