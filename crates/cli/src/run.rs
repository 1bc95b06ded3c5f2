//! Decides claims, verdicts first and corrections after them, with progress on the terminal.

use crate::diagnostics::Diagnostics;
use crate::terminal::Progress;
use crate::watchdog;
use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};
use torse::syntax::derivation::Paper;
use torse::verdicts::outcome::{Outcome, PaperOutcome};
use torse::{Event, Pass, Verifier, WorkBudget};

/// The option that bounds the work on a claim.
#[derive(Debug, Clone, Copy, clap::Args)]
pub struct Budget {
    /// Limit the work on a claim, in products of coefficients; a claim that needs more is undecided
    #[arg(long = "budget", value_name = "UNITS", default_value_t = WorkBudget::STANDARD.units())]
    units: u64,
}

impl Budget {
    /// The largest work on a claim.
    pub fn units(self) -> u64 {
        self.units
    }

    /// Who decides with this budget.
    pub fn verifier(self) -> Verifier<'static> {
        Verifier::new().with_budget(WorkBudget::new(self.units))
    }
}

/// The outcomes of a run, and the time for each claim.
pub struct Run {
    /// The papers with their decided claims, in file order.
    pub papers: Vec<PaperOutcome>,
    /// Times by id.
    timings: BTreeMap<String, Duration>,
    /// Work by id.
    works: BTreeMap<String, u64>,
}

impl Run {
    /// Decides all claims of `papers`, of all papers at once, and then searches corrections of those that are refuted.
    /// Claims whose formulas make no sense are mistakes of theirs, and have no outcome.
    pub fn new(papers: &[Paper], budget: Budget, mistakes: &mut Diagnostics) -> Self {
        let watcher = Watcher::default();
        let watch = |event: Event<'_>| {
            watcher.see(event);
            ControlFlow::Continue(())
        };
        // The watcher ends nothing.
        let verified = budget.verifier().observed_by(&watch).verify(papers);
        let verified = verified.unwrap_or_default();
        let watched = watcher.into_watched();
        let run = Run {
            papers: verified.papers,
            timings: watched.timings,
            works: watched.works,
        };
        verified
            .mistakes
            .into_iter()
            .for_each(|error| mistakes.add(Box::new(error)));
        run
    }

    /// Decides the claims in which faults show once more, with all corrections of their paper in force.
    pub fn restore(&mut self, papers: &[Paper], budget: Budget, mistakes: &mut Diagnostics) {
        let found = budget.verifier().restore(papers, &mut self.papers);
        found
            .into_iter()
            .for_each(|error| mistakes.add(Box::new(error)));
    }

    /// Returns all outcomes, in file order.
    pub fn outcomes(&self) -> impl Iterator<Item = &Outcome> {
        self.papers.iter().flat_map(|paper| &paper.claims)
    }

    /// The work on a claim, in the units of the budget.
    pub fn work(&self, id: &str) -> u64 {
        self.works.get(id).copied().unwrap_or_default()
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

/// What is seen of a run: its progress, and how long each claim takes. The watchdog is told what is being decided.
#[derive(Default)]
struct Watcher {
    state: Mutex<Watched>,
}

#[derive(Default)]
struct Watched {
    progress: Option<Progress>,
    begun: BTreeMap<String, Instant>,
    timings: BTreeMap<String, Duration>,
    works: BTreeMap<String, u64>,
}

impl Watcher {
    fn see(&self, event: Event<'_>) {
        let mut watched = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        match event {
            Event::Begins { pass, claims } => {
                let what = match pass {
                    Pass::Correcting => "correcting",
                    _ => "deciding",
                };
                watched.progress = Some(Progress::new(what, claims));
            }
            Event::ClaimBegins { id, .. } => {
                watchdog::begin(id);
                if let Some(progress) = &watched.progress {
                    progress.doing(id);
                }
                watched.begun.insert(id.to_owned(), Instant::now());
            }
            Event::ClaimEnds { id, work, .. } => {
                watchdog::end(id);
                let time = watched.begun.remove(id).map(|start| start.elapsed());
                *watched.timings.entry(id.to_owned()).or_default() += time.unwrap_or_default();
                *watched.works.entry(id.to_owned()).or_default() += work;
                if let Some(progress) = &watched.progress {
                    progress.step();
                }
            }
            Event::Ends { .. } => {
                if let Some(progress) = watched.progress.take() {
                    progress.finish();
                }
            }
            _ => {}
        }
    }

    fn into_watched(self) -> Watched {
        let watched = self.state.into_inner();
        watched.unwrap_or_else(PoisonError::into_inner)
    }
}
