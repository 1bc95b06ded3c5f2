//! Decides claims: verdicts first, corrections of refuted claims after them.

use crate::error::Error;
use crate::progress::{Event, Observer, Pass, unobserved};
use rayon::prelude::*;
use serde::ser::{Error as _, Serialize, Serializer};
use serde_json::Value;
use std::fmt;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use torse_numbers::work::{Spent, spent, stoppable};
use torse_report::verdicts_json;
use torse_syntax::derivation::{Claim, DerivationError, Paper};
use torse_verdicts::engine::{STANDARD_WORK, decide_claim_within};
use torse_verdicts::faults::faults;
use torse_verdicts::outcome::{Outcome, PaperOutcome};
use torse_verdicts::pending_claim::PendingClaim;
use torse_verdicts::restore::restore;

/// Maximum work on a claim, in products of coefficients. A claim that needs more is undecided, with that reason: a
/// verdict is the same on every machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, serde::Serialize)]
pub struct WorkBudget(u64);

impl WorkBudget {
    /// Many times what the hardest claims of the papers take.
    pub const STANDARD: Self = Self(STANDARD_WORK);

    /// Makes a budget of this many units.
    #[must_use]
    pub const fn new(units: u64) -> Self {
        Self(units)
    }

    /// Returns the number of units.
    #[must_use]
    pub const fn units(self) -> u64 {
        self.0
    }
}

impl Default for WorkBudget {
    fn default() -> Self {
        Self::STANDARD
    }
}

/// Decides claims with a budget, and reports to an observer.
///
/// ```
/// use std::ops::ControlFlow;
/// use std::sync::atomic::{AtomicUsize, Ordering};
/// use torse::{Error, Event, Paper, Verifier, WorkBudget};
///
/// let paper = Paper::read(|name| match name {
///     "paper.toml" => Some("[paper]\nid = 'p'\ntitle = ''\nauthors = ''\nvenue = ''\nclaims = ['c.toml']".to_owned()),
///     "c.toml" => Some("[[claim]]\nid = 'p/1'\nat = ''\nkind = 'identity'\nprinted = '2 + 2 = 4'\nstates = '2 + 2 == 4'".to_owned()),
///     _ => None,
/// })?;
/// let done = AtomicUsize::new(0);
/// let count = |event: Event<'_>| {
///     if matches!(event, Event::ClaimEnds { .. }) {
///         done.fetch_add(1, Ordering::Relaxed);
///     }
///     ControlFlow::Continue(())
/// };
/// let verifier = Verifier::new().with_budget(WorkBudget::new(1_000_000)).observed_by(&count);
/// assert!(paper.verify_by(&verifier)?.mistakes.is_empty());
/// assert_eq!(done.into_inner(), 1);
///
/// let stop = |_: Event<'_>| ControlFlow::Break(());
/// let ended = paper.verify_by(&Verifier::new().observed_by(&stop));
/// assert!(matches!(ended, Err(Error::Cancelled)));
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy)]
pub struct Verifier<'o> {
    budget: WorkBudget,
    observer: Observer<'o>,
    stop: Option<&'o Arc<AtomicBool>>,
}

impl fmt::Debug for Verifier<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut shown = formatter.debug_struct("Verifier");
        shown.field("budget", &self.budget).finish_non_exhaustive()
    }
}

impl Default for Verifier<'_> {
    fn default() -> Self {
        Self::new()
    }
}

/// The results for papers.
#[derive(Debug, Clone, Default)]
#[non_exhaustive]
pub struct Verification {
    /// The papers with their decided claims, in file order.
    pub papers: Vec<PaperOutcome>,
    /// Formulas that make no sense, in file order: their claims have no outcome.
    pub mistakes: Vec<DerivationError>,
}

/// As `torse verify --format json`.
impl Serialize for Verification {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let text = verdicts_json(self.outcomes()).map_err(S::Error::custom)?;
        let value: Value = serde_json::from_str(&text).map_err(S::Error::custom)?;
        value.serialize(serializer)
    }
}

impl Verification {
    /// Returns all outcomes, in file order.
    pub fn outcomes(&self) -> impl Iterator<Item = &Outcome> {
        self.papers.iter().flat_map(|paper| &paper.claims)
    }
}

impl<'o> Verifier<'o> {
    /// Makes a verifier with [`WorkBudget::STANDARD`] and no observer.
    #[must_use]
    pub fn new() -> Self {
        Self {
            budget: WorkBudget::STANDARD,
            observer: &unobserved,
            stop: None,
        }
    }

    /// Sets the budget.
    #[must_use]
    pub fn with_budget(self, budget: WorkBudget) -> Self {
        Self { budget, ..self }
    }

    /// Sets the observer, which may end the work.
    #[must_use]
    pub fn observed_by<'n>(self, observer: Observer<'n>) -> Verifier<'n>
    where
        'o: 'n,
    {
        Verifier { observer, ..self }
    }

    /// Ends the work soon after `stop` is set, also in the middle of a claim.
    ///
    /// ```
    /// use std::sync::{Arc, atomic::AtomicBool};
    /// use torse::{Error, Verifier};
    /// let stop = Arc::new(AtomicBool::new(true));
    /// let ended = Verifier::new().stopped_by(&stop).decide("(a + b + c)^60 == 1", "");
    /// assert!(matches!(ended, Err(Error::Cancelled)));
    /// ```
    #[must_use]
    pub fn stopped_by<'n>(self, stop: &'n Arc<AtomicBool>) -> Verifier<'n>
    where
        'o: 'n,
    {
        Verifier {
            stop: Some(stop),
            ..self
        }
    }

    /// The budget.
    #[must_use]
    pub fn budget(&self) -> WorkBudget {
        self.budget
    }

    /// Does the work of a claim.
    pub(crate) fn work<T>(&self, job: impl FnOnce() -> T) -> Result<T, Error> {
        match self.stop {
            // What comes of work that was stopped is no finding.
            Some(stop) => stoppable(stop, job).map_err(|_: Spent| Error::Cancelled),
            None => Ok(job()),
        }
    }

    /// Decides one claim of the paper with this slug, on the calling thread.
    ///
    /// # Errors
    /// [`Error::Formula`] where a formula makes no sense, [`Error::Cancelled`].
    pub fn claim(&self, slug: &str, claim: &Claim) -> Result<Outcome, Error> {
        let watch = Watch::new(self.observer);
        let pass = Pass::Deciding;
        let id = claim.entry.id.get_ref();
        watch.tell(Event::ClaimBegins { pass, id });
        watch.go_on()?;
        let before = spent();
        let outcome = self.work(|| decide_claim_within(self.budget.units(), slug, claim))??;
        let work = spent().saturating_sub(before);
        watch.tell(Event::ClaimEnds { pass, id, work });
        Ok(outcome)
    }

    /// Decides all claims of `papers`, of all papers at once and on all threads, and then searches for corrections of
    /// refuted ones.
    ///
    /// # Errors
    /// [`Error::Cancelled`] alone: formulas that make no sense are [`Verification::mistakes`].
    pub fn verify(&self, papers: &[Paper]) -> Result<Verification, Error> {
        let watch = Watch::new(self.observer);
        let claims: Vec<(&str, &Claim)> = papers
            .iter()
            .flat_map(|paper| {
                paper
                    .claims
                    .iter()
                    .map(|claim| (paper.head.id.as_str(), claim))
            })
            .collect();
        let pass = Pass::Deciding;
        watch.tell(Event::Begins {
            pass,
            claims: claims.len(),
        });
        let stages: Vec<Option<Result<PendingClaim<'_>, _>>> = claims
            .par_iter()
            // A claim takes from microseconds to a second: any free thread takes the next.
            .with_max_len(1)
            .map(|(slug, claim)| {
                watch.claim(pass, claim, || {
                    self.work(|| PendingClaim::verdict(self.budget.units(), slug, claim))
                })
            })
            .collect();
        watch.tell(Event::Ends { pass });
        watch.go_on()?;
        let refuted = |stage: &Option<Result<PendingClaim<'_>, _>>| matches!(stage, Some(Ok(stage)) if stage.seeks_correction());
        let pass = Pass::Correcting;
        watch.tell(Event::Begins {
            pass,
            claims: stages.iter().filter(|stage| refuted(stage)).count(),
        });
        let decided: Vec<Option<Result<Outcome, _>>> = claims
            .par_iter()
            .zip(stages)
            .with_max_len(1)
            .map(|((_, claim), stage)| {
                let seeks = refuted(&stage);
                let complete = || stage.map(|stage| self.work(|| stage?.complete()));
                match seeks {
                    true => watch
                        .claim(pass, claim, || complete().transpose())
                        .flatten(),
                    false => complete().and_then(|done| watch.kept(done)),
                }
            })
            .collect();
        watch.tell(Event::Ends { pass });
        watch.go_on()?;
        Ok(verification(papers, decided))
    }

    /// Decides the claims in which faults show and those that rest on them once more, with all corrections of their paper
    /// in force: [`PaperOutcome::restored`]. Returns the formulas that make no sense then.
    pub fn restore(&self, papers: &[Paper], outcomes: &mut [PaperOutcome]) -> Vec<DerivationError> {
        let mut mistakes = vec![];
        for (paper, outcome) in papers.iter().zip(outcomes) {
            match restore(self.budget.units(), paper, outcome) {
                Ok(restored) => outcome.restored = Some(restored),
                Err(error) => mistakes.push(*error),
            }
        }
        mistakes
    }
}

/// Puts outcomes, in file order, into their papers.
fn verification(
    papers: &[Paper],
    decided: Vec<Option<Result<Outcome, Box<DerivationError>>>>,
) -> Verification {
    let mut decided = decided.into_iter().flatten();
    let mut made = Verification::default();
    for paper in papers {
        let mut outcomes = Vec::with_capacity(paper.claims.len());
        for decision in decided.by_ref().take(paper.claims.len()) {
            match decision {
                Ok(outcome) => outcomes.push(outcome),
                Err(error) => made.mistakes.push(*error),
            }
        }
        let faults = faults(paper, &outcomes).unwrap_or_else(|error| {
            made.mistakes.push(*error);
            vec![]
        });
        made.papers.push(PaperOutcome {
            slug: paper.head.id.clone(),
            title: paper.head.title.clone(),
            authors: paper.head.authors.clone(),
            venue: paper.head.venue.clone(),
            claims: outcomes,
            faults,
            restored: None,
        });
    }
    made
}

/// The observer, and whether it has ended the work.
struct Watch<'o> {
    observer: Observer<'o>,
    ended: AtomicBool,
}

impl<'o> Watch<'o> {
    fn new(observer: Observer<'o>) -> Self {
        Self {
            observer,
            ended: AtomicBool::new(false),
        }
    }

    fn tell(&self, event: Event<'_>) {
        if (self.observer)(event) == ControlFlow::Break(()) {
            self.ended.store(true, Ordering::Relaxed);
        }
    }

    /// Fails once the work was ended.
    fn go_on(&self) -> Result<(), Error> {
        match self.ended.load(Ordering::Relaxed) {
            true => Err(Error::Cancelled),
            false => Ok(()),
        }
    }

    /// Works on a claim, unless the work was ended.
    fn claim<T>(
        &self,
        pass: Pass,
        claim: &Claim,
        job: impl FnOnce() -> Result<T, Error>,
    ) -> Option<T> {
        let id = claim.entry.id.get_ref();
        self.go_on().ok()?;
        self.tell(Event::ClaimBegins { pass, id });
        self.go_on().ok()?;
        let before = spent();
        let done = self.kept(job())?;
        let work = spent().saturating_sub(before);
        self.tell(Event::ClaimEnds { pass, id, work });
        Some(done)
    }

    /// What was done; nothing where it was stopped, which ends the work.
    fn kept<T>(&self, done: Result<T, Error>) -> Option<T> {
        done.map_err(|_| self.ended.store(true, Ordering::Relaxed))
            .ok()
    }
}
