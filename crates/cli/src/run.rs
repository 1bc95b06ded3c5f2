//! Deciding claims, with progress on the terminal.

use crate::guard;
use crate::mistakes::Mistakes;
use crate::terminal::Progress;
use rayon::prelude::*;
use std::time::{Duration, Instant};
use torse_language::derivation::Paper;
use torse_verdicts::engine::{STANDARD_WORK, decide_claim_within};
use torse_verdicts::outcome::{Outcome, PaperOutcome};

/// The option that bounds the work on a claim.
#[derive(Debug, Clone, Copy, clap::Args)]
pub struct Budget {
    /// The most work on a claim, in units of one product of coefficients; what needs more is undecided
    #[arg(long = "budget", value_name = "UNITS", default_value_t = STANDARD_WORK)]
    units: u64,
}

/// The outcomes of a run, and how long each claim took.
pub struct Run {
    /// The papers with their decided claims, in file order.
    pub papers: Vec<PaperOutcome>,
    /// Ids and times, in file order.
    pub timings: Vec<(String, Duration)>,
}

impl Run {
    /// Decides all claims of `papers`, of all papers at once. Claims whose formulas make no sense are mistakes of theirs,
    /// and have no outcome.
    pub fn of(papers: &[Paper], budget: Budget, mistakes: &mut Mistakes) -> Self {
        let claims: Vec<_> = papers
            .iter()
            .flat_map(|paper| paper.claims.iter().map(|claim| (&paper.head.id, claim)))
            .collect();
        let progress = Progress::new("deciding", claims.len());
        let decided: Vec<_> = claims
            .par_iter()
            // A claim takes from microseconds to a second: each may go to whoever is free.
            .with_max_len(1)
            .map(|(slug, claim)| {
                let start = Instant::now();
                let outcome = guard::named(claim.entry.id.get_ref(), || {
                    decide_claim_within(budget.units, slug, claim)
                });
                progress.step();
                outcome.map(|outcome| (outcome, start.elapsed()))
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
                        run.timings.push((outcome.id.clone(), time));
                        outcomes.push(outcome);
                    }
                    Err(error) => mistakes.add(error),
                }
            }
            run.papers.push(PaperOutcome {
                slug: paper.head.id.clone(),
                title: paper.head.title.clone(),
                authors: paper.head.authors.clone(),
                venue: paper.head.venue.clone(),
                claims: outcomes,
            });
        }
        run
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
