//! Finds the claims that rest on a claim, and decides what becomes of them when it is wrong.
//!
//! A claim names the claims that it `uses`. The engine decides every claim from the definitions alone, never from other
//! claims. So a claim that rests on a wrong one in the paper and still holds is not affected by the error (the wrong
//! term vanishes there, for example), and one that falls does so by itself.

use crate::outcome::Outcome;
use std::collections::{BTreeMap, BTreeSet, VecDeque};
use torse_syntax::notation::Formula;
use torse_syntax::taxonomy::Verdict;

/// What becomes of a claim that rests on a refuted one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fate {
    /// It is true all the same.
    Survives,
    /// It is true under a condition of its own.
    SurvivesIf,
    /// It is false as printed, and true with a correction of its own.
    Corrected,
    /// It is false.
    Falls,
    /// Nothing is decided about it.
    Open,
}

impl Fate {
    /// Returns the fate that a verdict means.
    #[must_use]
    pub fn from_verdict(verdict: Verdict) -> Self {
        match verdict {
            Verdict::Holds | Verdict::Definition | Verdict::Reproduced => Self::Survives,
            Verdict::Conditional => Self::SurvivesIf,
            Verdict::Misprint => Self::Corrected,
            Verdict::False => Self::Falls,
            Verdict::Undecided
            | Verdict::Vacuous
            | Verdict::Depends
            | Verdict::Underspecified
            | Verdict::OutOfScope
            | Verdict::Partial => Self::Open,
        }
    }

    /// Whether it stays true, possibly under a condition.
    #[must_use]
    pub fn survives(self) -> bool {
        matches!(self, Self::Survives | Self::SurvivesIf)
    }
}

/// A claim that rests on another.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Consequence {
    /// The id of the claim.
    pub id: String,
    /// The intermediate claims, nearest to the refuted one first; empty if it is used directly.
    pub through: Vec<String>,
    /// What becomes of it.
    pub fate: Fate,
    /// Its verdict.
    pub verdict: Verdict,
    /// The conditions under which it survives.
    pub conditions: Vec<Formula>,
}

/// Returns the claims that use each claim, by its id, in the order of the outcomes.
#[must_use]
pub fn users<'a>(
    claims: impl IntoIterator<Item = (&'a str, &'a [String])>,
) -> BTreeMap<&'a str, Vec<&'a str>> {
    let mut users: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for (id, uses) in claims {
        for used in uses {
            users.entry(used).or_default().push(id);
        }
    }
    users
}

/// Returns the ids of all claims that rest on `id`, directly or through others, nearest first, each with the claims
/// between.
#[must_use]
pub fn resting<'a>(
    id: &'a str,
    users: &BTreeMap<&'a str, Vec<&'a str>>,
) -> Vec<(&'a str, Vec<&'a str>)> {
    let mut found = vec![];
    let mut seen = BTreeSet::from([id]);
    let mut pending = VecDeque::from([(id, vec![])]);
    while let Some((current, through)) = pending.pop_front() {
        for &user in users.get(current).into_iter().flatten() {
            if seen.insert(user) {
                let mut further = through.clone();
                found.push((user, through.clone()));
                further.push(user);
                pending.push_back((user, further));
            }
        }
    }
    found
}

/// Returns what rests on the claim `id` among these outcomes, and what becomes of it.
#[must_use]
pub fn consequences(id: &str, outcomes: &[&Outcome]) -> Vec<Consequence> {
    let users = users(
        outcomes
            .iter()
            .map(|o| (o.claim.id.as_str(), o.claim.uses.as_slice())),
    );
    let by_id: BTreeMap<&str, &Outcome> = outcomes
        .iter()
        .map(|outcome| (outcome.claim.id.as_str(), *outcome))
        .collect();
    resting(id, &users)
        .into_iter()
        .filter_map(|(user, through)| {
            let outcome = by_id.get(user)?;
            let fate = Fate::from_verdict(outcome.verdict());
            let conditions = match fate {
                Fate::SurvivesIf => outcome.conditions().to_vec(),
                _ => vec![],
            };
            Some(Consequence {
                id: user.to_owned(),
                through: through.into_iter().map(str::to_owned).collect(),
                fate,
                verdict: outcome.verdict(),
                conditions,
            })
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_rests_on_a_claim_is_found_nearest_first_and_once() {
        let uses: [(&str, &[String]); 4] = [
            ("a", &[]),
            ("b", &["a".to_owned()]),
            ("c", &["b".to_owned(), "a".to_owned()]),
            ("d", &["c".to_owned()]),
        ];
        let users = users(uses);
        let resting = resting("a", &users);
        assert_eq!(resting, [("b", vec![]), ("c", vec![]), ("d", vec!["c"])]);
    }

    #[test]
    fn claims_that_use_each_other_end_the_search() {
        let uses: [(&str, &[String]); 2] = [("a", &["b".to_owned()]), ("b", &["a".to_owned()])];
        assert_eq!(resting("a", &users(uses)), [("b", vec![])]);
    }
}
