//! Results of the two cross-checks of a statement: the second evaluator at points, and the checker of proofs.

use serde::Serialize;

/// An answer of the prover with the results of its two cross-checks. Neither contradicts it: a contradicted answer has
/// no value of this type.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Judged<T> {
    /// The prover's answer.
    pub statement: T,
    /// The result of the second evaluator at points.
    pub net: Net,
    /// The result of the checker; none if there is no proof.
    pub replay: Option<Replay>,
}

/// The result of the second evaluator for a verdict. That evaluator shares only the parser, the declarations and the
/// numbers with the prover.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Net {
    /// Whether the verdict is netted: a proof was confirmed at as many points as required, each of its conditions is
    /// needed at a point where it fails, a refutation fails at a point, and its correction is netted.
    pub netted: bool,
    /// Points that were drawn.
    pub tried: u64,
    /// Points of the domain at which the second evaluator confirmed the verdict.
    pub decided: u64,
    /// What is true on thin parts of the domain that the text shows and on which no point was decided.
    pub unvisited: Vec<String>,
    /// Small instances that are identities; they are looked for by `torse recheck` alone.
    pub instances: u64,
    /// Why it is not netted.
    pub why: Option<String>,
    /// The statement at points where its conditions fail.
    pub conditions: Vec<ConditionCheck>,
    /// The correction of a refuted statement, checked like a proof.
    pub correction: Option<Box<Net>>,
}

impl Net {
    /// Nothing was tried.
    #[must_use]
    pub fn without_points(why: &str) -> Self {
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

    /// The same, but not netted for this reason: core terms could not be compared with the text.
    #[must_use]
    pub fn not_netted_because(self, uncompared: Option<String>) -> Self {
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

    /// Returns the same for a statement in which a witness stands for a number that exists. Where a condition of the proof
    /// fails, this witness fails or has no value; another one may do, so nothing shows that the condition is needed.
    #[must_use]
    pub fn with_own_witness(self) -> Self {
        let Some(first) = self.conditions.first() else {
            return self;
        };
        let why = format!(
            "where the condition {} fails another witness may do",
            first.condition
        );
        let open = |own: ConditionCheck| ConditionCheck {
            failing: 0,
            undefined: 0,
            needed_at: None,
            ..own
        };
        Self {
            netted: false,
            why: Some(self.why.unwrap_or(why)),
            conditions: self.conditions.into_iter().map(open).collect(),
            ..self
        }
    }

    /// A point at which the statement is false, after so many points.
    #[must_use]
    pub fn with_refuting_point(tried: u64) -> Self {
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

/// The result of the checker for the proof of a verdict.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Replay {
    /// Whether it accepted the proof as one of the core claim.
    pub replayed: bool,
    /// Why it could not follow the proof.
    pub why: Option<String>,
    /// The proof of the correction of a refuted statement.
    pub correction: Option<Box<Replay>>,
}

impl Replay {
    /// Accepted.
    #[must_use]
    pub fn accepted() -> Self {
        Self {
            replayed: true,
            why: None,
            correction: None,
        }
    }

    /// Outside the checker's reach.
    #[must_use]
    pub fn out_of_reach(why: &str) -> Self {
        Self {
            replayed: false,
            why: Some(why.to_owned()),
            correction: None,
        }
    }

    /// Whether the proof was accepted, and that of the correction too if there is one.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.replayed && self.correction.as_ref().is_none_or(|own| own.is_whole())
    }
}

/// Required number of points at which a condition fails.
pub const MIN_VIOLATING_POINTS: u64 = 10;

/// The statement at points of its domain at which a condition fails. The decided points of the [`Net`] are the other
/// side: all conditions are true there.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ConditionCheck {
    /// The condition.
    pub condition: String,
    /// Points that were drawn.
    pub tried: u64,
    /// Points at which the condition fails and the statement is still true.
    pub holding: u64,
    /// Points at which the condition fails and the statement is false.
    pub failing: u64,
    /// Points at which the condition fails and the statement is undefined.
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

    /// Whether the statement was evaluated without the condition at as many points as required, and was true every
    /// time. A few points, at which everything else is zero as well, are no evidence.
    #[must_use]
    pub fn is_suspicious(&self) -> bool {
        self.holding >= MIN_VIOLATING_POINTS && !self.seen_needed()
    }
}
