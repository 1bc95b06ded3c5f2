//! What recurs in the claims of a report, said once: the sources of hypotheses and the steps of proofs. Claims refer to them
//! by number.

use crate::text::visible;
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};
use torse_typography::{PrintedNames, Prose, spans};

/// A step that so many claims share has an entry of its own.
const MIN_CLAIMS: usize = 3;

/// A step of a proof, and how often the proof takes it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ProofStep {
    /// The number of its entry among the recurring steps, from 1 on.
    pub recurring: Option<usize>,
    /// The step itself, if it has no entry.
    pub words: Option<Prose>,
    /// How often the proof takes it.
    pub times: usize,
}

/// A list without repetitions, whose entries are numbered from 1 on in the order of their first use.
#[derive(Debug, Default)]
pub(super) struct Entries {
    list: Vec<Prose>,
}

impl Entries {
    /// Returns the number of an entry, which is added if it is new.
    pub(super) fn number(&mut self, entry: Prose) -> usize {
        match self.list.iter().position(|known| *known == entry) {
            Some(position) => position + 1,
            None => {
                self.list.push(entry);
                self.list.len()
            }
        }
    }

    /// Returns the entries.
    pub(super) fn into_list(self) -> Vec<Prose> {
        self.list
    }
}

/// Returns the steps that many of these proofs take.
pub(super) fn shared_steps<'a>(proofs: impl Iterator<Item = &'a [String]>) -> BTreeSet<String> {
    let mut claims: BTreeMap<&str, usize> = BTreeMap::new();
    for proof in proofs {
        let steps: BTreeSet<&str> = proof.iter().map(|step| bare(step)).collect();
        for step in steps {
            *claims.entry(step).or_default() += 1;
        }
    }
    let shared = claims.into_iter().filter(|(_, count)| *count >= MIN_CLAIMS);
    shared.map(|(step, _)| step.to_owned()).collect()
}

/// Returns the steps of a proof, each once; those that are `shared` become entries of the list.
pub(super) fn proof(
    steps: &[String],
    shared: &BTreeSet<String>,
    entries: &mut Entries,
    names: &PrintedNames,
) -> Vec<ProofStep> {
    let mut distinct: Vec<(&str, usize)> = Vec::new();
    for step in steps.iter().map(|step| bare(step)) {
        match distinct.iter_mut().find(|(known, _)| *known == step) {
            Some((_, times)) => *times += 1,
            None => distinct.push((step, 1)),
        }
    }
    let view = |(step, times)| {
        let words = spans(&visible(step), names);
        let recurring = shared.contains(step).then(|| entries.number(words.clone()));
        ProofStep {
            words: recurring.is_none().then_some(words),
            recurring,
            times,
        }
    };
    distinct.into_iter().map(view).collect()
}

fn bare(step: &str) -> &str {
    step.trim_end_matches('.')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_step_of_many_proofs_is_an_entry_and_is_counted_in_each() {
        let proof_of = |steps: &[&str]| steps.iter().map(|step| (*step).to_owned()).collect();
        let proofs: [Vec<String>; 3] = [
            proof_of(&["by the rule", "own", "by the rule."]),
            proof_of(&["by the rule"]),
            proof_of(&["other", "by the rule", "other"]),
        ];
        let shared = shared_steps(proofs.iter().map(Vec::as_slice));
        assert_eq!(shared.iter().collect::<Vec<_>>(), ["by the rule"]);
        let mut entries = Entries::default();
        let names = PrintedNames::default();
        let shown = proof(&proofs[0], &shared, &mut entries, &names);
        let counts: Vec<_> = shown
            .iter()
            .map(|step| (step.recurring, step.times))
            .collect();
        assert_eq!(counts, [(Some(1), 2), (None, 1)]);
        assert!(shown[0].words.is_none() && shown[1].words.is_some());
        assert_eq!(entries.into_list().len(), 1);
    }
}
