//! The result of deciding a claim: a value that is constructed once and never changed.
//!
//! Verdict and evidence are two axes and never merged: the verdict says what is true of the printed statement, the
//! evidence says what the answer rests on. Both follow from the [`Finding`], which has one constructor for each kind;
//! each holds what its kind has: a proof its conditions and its certificate, a refutation its counterexample, a
//! contradiction nothing of the answer that it contradicts. The prover's answer becomes a finding only together with
//! the results of its cross-checks ([`Judged`]).
//!
//! A sentence with several readings has an outcome for each ([`Readings`]). If all have the same verdict, the sentence
//! has it too; if they differ, it is `depends`, which accuses nobody.

use crate::certificate::DecisionCertificate;
use crate::claim_record::ClaimRecord;
use crate::correction::{Correction, DataCorrection};
use crate::judged::{Judged, Net, Replay};
use crate::statement::{
    Contradiction, EmptyDomain, FigureFinding, ProvedStatement, RefutedStatement,
    UndecidedStatement,
};
use serde::Serialize;
use torse_prove::evidence::{Evidence, Witness};
use torse_syntax::notation::Formula;
use torse_syntax::taxonomy::{Kind, Verdict};

/// A claim with its finding.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Outcome {
    /// The claim, as its file states it.
    pub claim: ClaimRecord,
    /// The finding.
    pub finding: Finding,
}

impl Outcome {
    /// Returns the verdict.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        self.finding.verdict(self.claim.kind)
    }

    /// Whether the verdict is the expected one; true if none is expected.
    #[must_use]
    pub fn as_expected(&self) -> bool {
        let expect = self.claim.expect;
        expect.is_none_or(|expected| expected == self.verdict())
    }

    /// What the verdict rests on; none for figures, and for definitions that are compared with nothing.
    #[must_use]
    pub fn evidence(&self) -> Option<Evidence> {
        let nothing = self.verdict() == Verdict::Definition && !self.claim.compared;
        self.finding.evidence().filter(|_| !nothing)
    }

    /// Returns the statement as the engine understood it; for readings that agree, the first one's.
    #[must_use]
    pub fn parsed(&self) -> Option<&Formula> {
        let first = self.finding.agreed().and_then(Self::parsed);
        first.or(self.claim.parsed.as_ref())
    }

    /// Returns the extra conditions of a `conditional` verdict, and divisors that must not vanish.
    #[must_use]
    pub fn conditions(&self) -> &[Formula] {
        self.finding.conditions()
    }

    /// Returns the readings of a sentence that has more than one.
    #[must_use]
    pub fn readings(&self) -> &[ReadingOutcome] {
        match &self.finding {
            Finding::Readings(readings) => readings.all(),
            _ => &[],
        }
    }

    /// Returns the refutation; for readings that agree, the first one's.
    #[must_use]
    pub fn refuted(&self) -> Option<&RefutedStatement> {
        self.finding.refuted()
    }

    /// Returns the counterexample.
    #[must_use]
    pub fn witness(&self) -> Option<&Witness> {
        self.refuted()?.witness.as_ref()
    }

    /// Returns the proved correction.
    #[must_use]
    pub fn correction(&self) -> Option<&Correction> {
        self.refuted()?.correction()
    }

    /// Whether the search for a small edit that repairs a refuted statement ended before all were tried.
    #[must_use]
    pub fn ended_early(&self) -> bool {
        self.refuted().is_some_and(|own| own.search_ended_early)
    }

    /// Returns the change of the data that explains a refuted value.
    #[must_use]
    pub fn data(&self) -> Option<&DataCorrection> {
        self.refuted()?.data.as_ref()
    }

    /// Returns the derived right side in the shape of the print.
    #[must_use]
    pub fn derived(&self) -> Option<&Formula> {
        self.refuted()?.derived.as_ref()
    }

    /// Returns left minus right side in normal form.
    #[must_use]
    pub fn difference(&self) -> Option<&Formula> {
        self.refuted()?.difference.as_ref()
    }

    /// Returns the result of the cross-check; none if nothing was decided.
    #[must_use]
    pub fn net(&self) -> Option<&Net> {
        self.finding.net()
    }

    /// Returns the result of the checker; none if there is no proof.
    #[must_use]
    pub fn replay(&self) -> Option<&Replay> {
        self.finding.replay()
    }

    /// Returns what contradicts the prover's verdict: the claim is then undecided.
    #[must_use]
    pub fn contradiction(&self) -> Option<&str> {
        self.finding.contradiction()
    }

    /// Whether the file states nothing yet.
    #[must_use]
    pub fn is_unstated(&self) -> bool {
        matches!(self.finding, Finding::Unstated(_))
    }
}

/// One reading of a sentence, decided.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ReadingOutcome {
    /// Its short name.
    pub name: String,
    /// The sentence in this reading, in words.
    pub says: String,
    /// Its finding.
    pub outcome: Outcome,
}

/// The result of deciding a claim.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Finding {
    /// The claim introduces notation: there is nothing to decide.
    Definition,
    /// The claim is a figure, drawn from the data of the paper or from replacements.
    Figure(FigureFinding),
    /// The paper does not print the data that are needed, named here.
    Underspecified(String),
    /// The claim is not a statement that can be decided here, for this reason.
    OutOfScope(String),
    /// Nothing is stated yet, and this is still to be done.
    Unstated(String),
    /// Undecided.
    Undecided(UndecidedStatement),
    /// The prover decided it, and a cross-check finds the opposite.
    Contradicted(Contradiction),
    /// Proved.
    Proved(Box<Judged<ProvedStatement>>),
    /// Refuted.
    Refuted(Box<Judged<RefutedStatement>>),
    /// No point satisfies the hypotheses.
    Vacuous(Box<Judged<EmptyDomain>>),
    /// The sentence has more than one reading.
    Readings(Readings),
}

impl Finding {
    /// Makes a finding that is undecided for this reason.
    pub fn undecided(why: impl Into<String>) -> Self {
        Self::Undecided(UndecidedStatement::because(why))
    }

    /// Returns the verdict for a claim of this kind.
    #[must_use]
    pub fn verdict(&self, kind: Kind) -> Verdict {
        match self {
            Self::Definition => Verdict::Definition,
            Self::Figure(figure) => figure.verdict,
            Self::Underspecified(_) => Verdict::Underspecified,
            Self::OutOfScope(_) => Verdict::OutOfScope,
            Self::Unstated(_) | Self::Undecided(_) | Self::Contradicted(_) => Verdict::Undecided,
            Self::Proved(proved) => proved.statement.verdict(kind),
            Self::Refuted(refuted) => refuted.statement.verdict(),
            Self::Vacuous(_) => Verdict::Vacuous,
            Self::Readings(readings) => readings.verdict(),
        }
    }

    /// Returns the evidence; none for definitions and figures.
    #[must_use]
    pub fn evidence(&self) -> Option<Evidence> {
        match self {
            Self::Proved(proved) => Some(proved.statement.evidence),
            Self::Refuted(refuted) => Some(refuted.statement.evidence),
            Self::Undecided(undecided) => undecided.evidence,
            Self::Readings(readings) => readings.evidence(),
            _ => None,
        }
    }

    /// Returns the conditions under which the statement is true.
    #[must_use]
    pub fn conditions(&self) -> &[Formula] {
        match self {
            Self::Proved(proved) => &proved.statement.conditions,
            Self::Readings(readings) => readings.conditions(),
            _ => &[],
        }
    }

    /// Returns for each hypothesis of the claim whether the proof needs it; empty if none was tried.
    #[must_use]
    pub fn needed(&self) -> &[Option<bool>] {
        match self {
            Self::Proved(proved) => &proved.statement.needed,
            _ => &[],
        }
    }

    /// Returns the refutation; for readings that agree, the first one's.
    #[must_use]
    pub fn refuted(&self) -> Option<&RefutedStatement> {
        match self {
            Self::Refuted(refuted) => Some(&refuted.statement),
            _ => self.agreed()?.refuted(),
        }
    }

    /// Returns the result of the cross-check; none if nothing was decided.
    #[must_use]
    pub fn net(&self) -> Option<&Net> {
        match self {
            Self::Proved(proved) => Some(&proved.net),
            Self::Refuted(refuted) => Some(&refuted.net),
            Self::Vacuous(vacuous) => Some(&vacuous.net),
            Self::Readings(readings) => readings.net(),
            _ => None,
        }
    }

    /// Returns the result of the checker; none if there is no proof.
    #[must_use]
    pub fn replay(&self) -> Option<&Replay> {
        match self {
            Self::Proved(proved) => proved.replay.as_ref(),
            Self::Refuted(refuted) => refuted.replay.as_ref(),
            Self::Readings(readings) => readings.replay(),
            _ => None,
        }
    }

    /// Returns the certificate; readings have their own.
    #[must_use]
    pub fn certificate(&self) -> Option<&DecisionCertificate> {
        match self {
            Self::Proved(proved) => Some(&proved.statement.certificate),
            Self::Refuted(refuted) => refuted.statement.certificate.as_deref(),
            _ => None,
        }
    }

    /// Returns what contradicts the prover's verdict; for a sentence, that of the first contradicted reading.
    #[must_use]
    pub fn contradiction(&self) -> Option<&str> {
        match self {
            Self::Contradicted(contradiction) => Some(&contradiction.found),
            Self::Readings(readings) => readings.contradiction(),
            _ => None,
        }
    }

    /// Returns the first reading if all readings have one verdict.
    #[must_use]
    pub fn agreed(&self) -> Option<&Outcome> {
        match self {
            Self::Readings(readings) => readings.agreed(),
            _ => None,
        }
    }
}

/// The readings of a sentence, each decided.
///
/// The result for the sentence follows from all of them. If they agree, it has the weakest evidence and the conditions
/// of all; if they differ, or one is contradicted, nothing of a single reading is used for the sentence.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(transparent)]
pub struct Readings {
    all: Vec<ReadingOutcome>,
    /// The conditions of all readings, each once, if they agree.
    #[serde(skip)]
    conditions: Vec<Formula>,
}

impl Readings {
    /// Makes the readings of a sentence.
    #[must_use]
    pub fn new(all: Vec<ReadingOutcome>) -> Self {
        let mut readings = Self {
            all,
            conditions: vec![],
        };
        if readings.agreed().is_some() {
            let mut conditions: Vec<Formula> = vec![];
            for condition in readings.outcomes().flat_map(Outcome::conditions) {
                if !conditions.contains(condition) {
                    conditions.push(condition.clone());
                }
            }
            readings.conditions = conditions;
        }
        readings
    }

    /// Returns the readings, in the order of the file.
    #[must_use]
    pub fn all(&self) -> &[ReadingOutcome] {
        &self.all
    }

    fn outcomes(&self) -> impl Iterator<Item = &Outcome> {
        self.all.iter().map(|reading| &reading.outcome)
    }

    /// Returns the first reading, if all have its verdict and none is contradicted.
    #[must_use]
    pub fn agreed(&self) -> Option<&Outcome> {
        let first = &self.all.first()?.outcome;
        let verdict = first.verdict();
        let agree = self.outcomes().all(|other| other.verdict() == verdict);
        (agree && self.contradiction().is_none()).then_some(first)
    }

    /// Returns the verdict of the sentence.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        match (self.contradiction(), self.agreed()) {
            (Some(_), _) => Verdict::Undecided,
            (None, Some(first)) => first.verdict(),
            (None, None) => Verdict::Depends,
        }
    }

    /// Returns the weakest evidence, if they agree.
    #[must_use]
    pub fn evidence(&self) -> Option<Evidence> {
        self.agreed()?;
        self.outcomes().map(Outcome::evidence).max().flatten()
    }

    /// Returns the conditions of all, each once, if they agree.
    #[must_use]
    pub fn conditions(&self) -> &[Formula] {
        &self.conditions
    }

    /// Returns the cross-check with the fewest points, if they agree and all have one.
    #[must_use]
    pub fn net(&self) -> Option<&Net> {
        self.agreed()?;
        let nets: Option<Vec<&Net>> = self.outcomes().map(Outcome::net).collect();
        nets?
            .into_iter()
            .min_by_key(|net| (net.netted, net.decided))
    }

    /// Returns the weakest replay, if they agree and all have one.
    #[must_use]
    pub fn replay(&self) -> Option<&Replay> {
        self.agreed()?;
        let replays: Option<Vec<&Replay>> = self.outcomes().map(Outcome::replay).collect();
        replays?
            .into_iter()
            .min_by_key(|replay| (replay.is_whole(), replay.replayed))
    }

    /// Returns what contradicts one of them.
    #[must_use]
    pub fn contradiction(&self) -> Option<&str> {
        self.outcomes().find_map(Outcome::contradiction)
    }
}
