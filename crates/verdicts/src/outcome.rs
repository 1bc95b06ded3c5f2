//! What the engine found out about one claim: plain data, handed to the report and the command.
//!
//! Verdict and evidence are two axes and never merged: the verdict says what is true of the printed
//! statement, the evidence says what the answer rests on.

use crate::grounds::Grounds;
use crate::table::Table;
use serde::Serialize;
use std::sync::Arc;
use torse_prove::evidence::{Evidence, Witness};
use torse_syntax::notation::Formula;
use torse_syntax::words::{Kind, Verdict};

/// A corrected form of a refuted formula, itself proved.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Correction {
    /// The corrected statement.
    pub statement: Formula,
    /// The conditions under which it is true, as those of a verdict.
    pub conditions: Vec<Formula>,
    /// What was changed, in words, one entry an edit ("the factor 4 added", "k replaced by l").
    pub edits: Vec<String>,
    /// Whether no other repair with as few edits was found.
    pub unique: bool,
}

impl Correction {
    /// What was changed and under which conditions the statement is true then, a line each.
    #[must_use]
    pub fn in_words(&self) -> Vec<String> {
        let conditions = self.conditions.iter();
        let conditions = conditions.map(|condition| format!("true if `{}`", condition.text));
        self.edits.iter().cloned().chain(conditions).collect()
    }
}

/// A change of printed data that explains a printed value: the value is wrong for the data as printed and
/// right for the changed ones.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct DataCorrection {
    /// The changed data.
    pub changes: Vec<DataChange>,
    /// How the printed value agrees then, in words.
    pub steps: Vec<String>,
    /// Whether no other change of as few numbers, as near to the print, was found that explains as much.
    pub unique: bool,
    /// The ids of the refuted values of the same example that this change explains, this one included.
    pub explains: Vec<String>,
    /// The ids of the values of the same example that hold for the data as printed and no longer do.
    pub contradicts: Vec<String>,
    /// Whether all refuted values of the example are explained, and none contradicted.
    pub explains_example: bool,
}

impl DataCorrection {
    /// What to change and what it explains, a line each.
    #[must_use]
    pub fn in_words(&self) -> Vec<String> {
        let change = |c: &DataChange| {
            format!(
                "`{}` reads `{}` instead of `{}`",
                c.name, c.new.text, c.old.text
            )
        };
        let mut lines: Vec<String> = self.changes.iter().map(change).collect();
        lines.extend(self.steps.iter().cloned());
        lines.push(match (self.explains_example, self.explains.as_slice()) {
            (true, [_, _, ..]) => {
                "this one change explains every wrong value of the example".to_owned()
            }
            (_, [_, _, ..]) => format!("it explains {}", self.explains.join(", ")),
            _ => "it explains this value alone".to_owned(),
        });
        if !self.contradicts.is_empty() {
            lines.push(format!("it contradicts {}", self.contradicts.join(", ")));
        }
        lines.push(match self.unique {
            true => "no other change of as few numbers, as near to the print, was found".to_owned(),
            false => {
                "other changes of as few numbers, as near to the print, explain it too".to_owned()
            }
        });
        lines
    }
}

/// One datum as printed and as it should read.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct DataChange {
    /// The name of the datum.
    pub name: String,
    /// As printed.
    pub old: Formula,
    /// As it should read.
    pub new: Formula,
}

/// What the semantics, an evaluator that shares nothing with the prover, found of a verdict.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Net {
    /// Whether the verdict is netted: a proof was decided at as many points as are wanted, each of its conditions is
    /// needed at a point at which it fails, a refutation fails at a point, and its correction is netted.
    pub netted: bool,
    /// Points that were drawn.
    pub tried: u64,
    /// Points of the domain at which the statement was decided as the verdict says.
    pub decided: u64,
    /// Small instances that are identities; they are looked for by `torse recheck` alone.
    pub instances: u64,
    /// Why it is not netted.
    pub why: Option<String>,
    /// The statement where its conditions fail.
    pub conditions: Vec<Sides>,
    /// The correction of a refuted statement, judged like a proof.
    pub correction: Option<Box<Net>>,
}

impl Net {
    /// Nothing was tried.
    #[must_use]
    pub fn uncovered(why: &str) -> Self {
        Self {
            netted: false,
            tried: 0,
            decided: 0,
            instances: 0,
            why: Some(why.to_owned()),
            conditions: vec![],
            correction: None,
        }
    }

    /// A point at which the statement is false, after so many.
    #[must_use]
    pub fn refuted(tried: u64) -> Self {
        Self {
            netted: true,
            tried,
            decided: 1,
            instances: 0,
            why: None,
            conditions: vec![],
            correction: None,
        }
    }
}

/// What a checker without search found of the proof of a verdict.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Replay {
    /// Whether it accepted the proof, as a proof of the core claim.
    pub replayed: bool,
    /// What it could not follow, if it did not.
    pub why: Option<String>,
    /// The proof of the correction of a refuted statement.
    pub correction: Option<Box<Replay>>,
}

impl Replay {
    /// Accepted.
    #[must_use]
    pub fn done() -> Self {
        Self {
            replayed: true,
            why: None,
            correction: None,
        }
    }

    /// Out of the checker's reach.
    #[must_use]
    pub fn beyond(why: &str) -> Self {
        Self {
            replayed: false,
            why: Some(why.to_owned()),
            correction: None,
        }
    }

    /// Whether the proof was accepted, and that of the correction as well if there is one.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.replayed && self.correction.as_ref().is_none_or(|own| own.is_whole())
    }
}

/// How many points are wanted at which a condition fails.
pub const BEYOND: u64 = 10;

/// A statement at points of its domain at which a condition fails. The other side are the decided points of the [`Net`]:
/// all conditions are true there.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Sides {
    /// The condition.
    pub condition: String,
    /// Points that were drawn.
    pub tried: u64,
    /// Points at which the condition fails and the statement is true all the same.
    pub holding: u64,
    /// Those at which the statement is false.
    pub failing: u64,
    /// Those at which it is undefined.
    pub undefined: u64,
    /// A point at which the statement is false without the condition, or undefined.
    pub needed_at: Option<String>,
}

impl Sides {
    /// Whether the statement is false, or undefined, somewhere without the condition.
    #[must_use]
    pub fn seen_needed(&self) -> bool {
        self.needed_at.is_some()
    }

    /// Whether the statement was judged without the condition as often as is wanted, and was true every time. A few
    /// points, at which everything else is zero as well, say nothing.
    #[must_use]
    pub fn is_suspicious(&self) -> bool {
        self.holding >= BEYOND && !self.seen_needed()
    }
}

/// A hypothesis, and whose it is.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Assumed {
    /// In what form it stands in the file.
    pub role: Role,
    /// What is assumed, as understood; a set that is no range of numbers in words.
    pub formula: Formula,
    /// Where it is from.
    pub from: SaidBy,
    /// Whether the proof needs it, if it is ours and was tried.
    pub needed: Option<bool>,
}

/// The form of a hypothesis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Role {
    /// The declared set of a symbol.
    Range,
    /// An assumption.
    Assume,
    /// An equation that determines unknowns.
    Given,
}

/// Where a hypothesis is from.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "from")]
pub enum SaidBy {
    /// It is part of the statement as the file states it; nothing is said of the print.
    Stated,
    /// The paper says it.
    Printed {
        /// In these words.
        quote: String,
        /// The id of the claim in whose print they stand.
        claim: String,
    },
    /// The paper does not say it.
    Ours {
        /// Why it is assumed.
        reason: String,
    },
}

/// One reading of a sentence, decided.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ReadingOutcome {
    /// A word for it.
    pub name: String,
    /// The sentence as it is read here, in words.
    pub says: String,
    /// What is true of it.
    pub outcome: Outcome,
}

/// Everything known about one claim after a run.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Outcome {
    /// The id of the inventory, `paper/name`.
    pub id: String,
    /// The paper's slug.
    pub paper: String,
    /// Where the paper says it.
    pub at: String,
    /// What kind of statement it is.
    pub kind: Kind,
    /// What is true of it.
    pub verdict: Verdict,
    /// What that rests on; none for definitions and figures.
    pub evidence: Option<Evidence>,
    /// The statement as printed, verbatim.
    pub printed: String,
    /// The id in the inventory of the sentence of which this is a part.
    pub part_of: Option<String>,
    /// How our copy of the text was read, where it is garbled or unclear.
    pub reading: Option<String>,
    /// What in the finding may be a confusion of the copy at hand.
    pub garbled: Option<String>,
    /// The statement as the engine understood it.
    pub parsed: Option<Formula>,
    /// The hypotheses under which it was decided: ranges of which the files say where they are from, assumptions, given
    /// equations.
    pub assumed: Vec<Assumed>,
    /// What the statement rests on besides: declared sets, definitions, unknowns.
    pub table: Table,
    /// Of a sentence with more than one reading: each of them, decided like a claim.
    pub readings: Vec<ReadingOutcome>,
    /// A proved correction, for a refuted claim.
    pub correction: Option<Correction>,
    /// A change of the data that explains a refuted value.
    pub data: Option<DataCorrection>,
    /// The derived right side in the paper's own shape, for a refuted claim.
    pub derived: Option<Formula>,
    /// Left side minus right side in normal form, for a refuted claim.
    pub difference: Option<Formula>,
    /// The extra conditions of a `conditional` verdict, and divisors that must not vanish.
    pub conditions: Vec<Formula>,
    /// A counterexample, for a refuted claim.
    pub witness: Option<Witness>,
    /// What the net found; none where nothing was decided.
    pub net: Option<Net>,
    /// What the checker of proofs found; none where there is no proof.
    pub replay: Option<Replay>,
    /// What the verdict rests on, as data.
    #[serde(skip)]
    pub grounds: Option<Arc<Grounds>>,
    /// What contradicts the verdict that the prover would have given: the claim is undecided then.
    pub contradiction: Option<String>,
    /// The steps of the decision, in words, in order.
    pub steps: Vec<String>,
    /// What was found, as the file tells it, with the numbers computed.
    pub finding: Option<String>,
    /// Anything a reader should know.
    pub note: Option<String>,
    /// Claims this one rests on.
    pub uses: Vec<String>,
    /// The verdict the derivation file expects, if it states one.
    pub expect: Option<Verdict>,
}

impl Outcome {
    /// Whether the computed verdict is the expected one (true where none is stated).
    #[must_use]
    pub fn as_expected(&self) -> bool {
        self.expect.is_none_or(|expected| expected == self.verdict)
    }
}

/// A paper and its decided claims, in file order.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct PaperOutcome {
    /// The paper's slug, for instance `gbt-developable`.
    pub slug: String,
    /// The title.
    pub title: String,
    /// The authors, one line.
    pub authors: String,
    /// Where it appeared.
    pub venue: String,
    /// The outcomes.
    pub claims: Vec<Outcome>,
    /// The faults of which the authors are told.
    pub faults: Vec<PaperFault>,
    /// What the claims are with all corrections in force; empty where nobody asked.
    pub restored: Vec<Restored>,
}

/// A fault of a paper, wherever it shows.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct PaperFault {
    /// Its id.
    pub id: String,
    /// Where the paper has it, if that is not the place of the first claim.
    pub at: Option<String>,
    /// What is wrong, in one sentence.
    pub says: String,
    /// The ids of the claims in which it shows.
    pub shows: Vec<String>,
    /// What is to be read instead.
    pub changes: Vec<FaultChange>,
}

/// Words of a paper, and what is to be read instead.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct FaultChange {
    /// The id of the claim in whose print they stand.
    pub claim: String,
    /// The words.
    pub printed: String,
    /// What is to be read instead.
    pub reads: String,
    /// The id of the remark that states it.
    pub remark: Option<String>,
}

/// A claim decided again, with all corrections of its paper in force.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Restored {
    /// The id of the claim.
    pub claim: String,
    /// What is true of the corrected statement.
    pub verdict: Verdict,
    /// What that rests on.
    pub evidence: Option<Evidence>,
    /// Its conditions.
    pub conditions: Vec<Formula>,
}
