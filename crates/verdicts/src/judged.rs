//! What those who did not prove a statement found of it: the net of points, and the checker of proofs.

use serde::Serialize;

/// Something that the prover says, with what its two judges found of it. Neither contradicts it: what is contradicted has no
/// value of this type.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Judged<T> {
    /// What the prover says.
    pub statement: T,
    /// What the semantics found at points.
    pub net: Net,
    /// What the checker of proofs found; none where there is no proof.
    pub replay: Option<Replay>,
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
    /// What is true on thin parts of the domain that the text shows and on which no point was decided.
    pub unvisited: Vec<String>,
    /// Small instances that are identities; they are looked for by `torse recheck` alone.
    pub instances: u64,
    /// Why it is not netted.
    pub why: Option<String>,
    /// The statement where its conditions fail.
    pub conditions: Vec<ConditionCheck>,
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
            unvisited: vec![],
            instances: 0,
            why: Some(why.to_owned()),
            conditions: vec![],
            correction: None,
        }
    }

    /// The same, not netted where core terms could not be compared with the text, for this reason.
    #[must_use]
    pub fn unless(self, uncompared: Option<String>) -> Self {
        let Some(why) = uncompared else {
            return self;
        };
        let why = format!("its core terms are not compared with the text: {why}");
        Self {
            netted: false,
            why: Some(self.why.unwrap_or(why)),
            ..self
        }
    }

    /// A point at which the statement is false, after so many.
    #[must_use]
    pub fn refuted(tried: u64) -> Self {
        Self {
            netted: true,
            tried,
            decided: 1,
            unvisited: vec![],
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
pub const MIN_VIOLATING_POINTS: u64 = 10;

/// A statement at points of its domain at which a condition fails. The other side are the decided points of the [`Net`]:
/// all conditions are true there.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ConditionCheck {
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

impl ConditionCheck {
    /// Whether the statement is false, or undefined, somewhere without the condition.
    #[must_use]
    pub fn seen_needed(&self) -> bool {
        self.needed_at.is_some()
    }

    /// Whether the statement was judged without the condition as often as is wanted, and was true every time. A few
    /// points, at which everything else is zero as well, say nothing.
    #[must_use]
    pub fn is_suspicious(&self) -> bool {
        self.holding >= MIN_VIOLATING_POINTS && !self.seen_needed()
    }
}
