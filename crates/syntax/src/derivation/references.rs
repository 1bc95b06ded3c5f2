//! References between claims: the claims that they use, the sentences of which they are parts, and quotations from
//! other claims.

use super::claim::Claim;
use super::error::{DerivationError, LoadError};
use super::paper::Paper;
use super::provenance::Quote;
use super::source::{Origin, whole};
use super::table::Errors;
use crate::formula::Place;
use std::collections::{BTreeMap, BTreeSet};
use toml::Spanned;

/// What claims can refer to.
#[derive(Debug, Default)]
pub(super) struct Known {
    /// The ids of all claims and figures, also of those that were left out, which are not reported again.
    pub ids: BTreeSet<String>,
    /// The ids of sentences that are split into parts, also of those that were left out.
    pub sentences: BTreeSet<String>,
    /// The prints of claims and of sentences in parts, by id.
    prints: BTreeMap<String, Vec<String>>,
    /// The parts of sentences, by id.
    parts: BTreeMap<String, Vec<String>>,
}

impl Known {
    /// What papers have, with the ids of all claims and figures and those of sentences in parts.
    pub fn new(papers: &[Paper], ids: BTreeSet<String>, sentences: BTreeSet<String>) -> Self {
        let mut known = Self {
            ids,
            sentences,
            ..Self::default()
        };
        for claim in papers.iter().flat_map(|paper| &paper.claims) {
            let id = claim.entry.id.get_ref();
            for id in std::iter::once(id).chain(claim.sentence_id()) {
                let printed = claim.entry.printed.clone();
                known.prints.entry(id.clone()).or_default().push(printed);
            }
            if let Some(whole) = claim.sentence_id() {
                known
                    .parts
                    .entry(whole.clone())
                    .or_default()
                    .push(id.clone());
            }
        }
        known
    }

    fn has(&self, id: &String) -> bool {
        self.ids.contains(id) || self.sentences.contains(id)
    }
}

/// The ids that claims and declarations of a paper refer to.
pub(super) fn referred(paper: &Paper) -> impl Iterator<Item = &String> {
    let uses = paper.claims.iter().flat_map(|claim| &claim.entry.uses);
    uses.map(Spanned::get_ref)
        .chain(quotes(paper).map(|quote| &quote.claim))
}

fn quotes(paper: &Paper) -> impl Iterator<Item = &Quote> {
    let own = paper.declarations.ranges();
    let own = own.filter_map(|(_, range)| range.provenance.quote());
    let answers = paper.claims.iter().flat_map(|claim| &claim.answers);
    let answers = answers.map(|answer| &answer.quote);
    own.chain(paper.claims.iter().flat_map(Claim::quotes))
        .chain(answers)
}

/// Resolves all ids and quotations. A claim that uses a sentence split into parts uses all of the parts. `known` is what the
/// papers and all others that they refer to have, in any number of pieces.
pub(super) fn resolve(papers: &mut [Paper], known: &[&Known], errors: &mut Errors) {
    let is_known = |id: &String| known.iter().any(|known| known.has(id));
    let is_id = |id: &String| known.iter().any(|known| known.ids.contains(id));
    for claim in papers.iter_mut().flat_map(|paper| &mut paper.claims) {
        let mut uses = vec![];
        for used in &claim.entry.uses {
            let id = used.get_ref();
            if !is_known(id) {
                let help = "`uses` takes full ids, such as `gbt-developable/eq-2.2`";
                let origin = Origin::from_spanned(&claim.origin.source, used);
                let message = format!("no claim has the id `{id}`");
                errors.0.push(wrong(&origin, whole(used), message, help));
            }
            match known.iter().find_map(|known| known.parts.get(id)) {
                Some(parts) => uses.extend(parts.iter().cloned()),
                None => uses.push(id.clone()),
            }
        }
        claim.uses = uses;
        part(claim, is_id, errors);
    }
    let mut checked = BTreeSet::new();
    for quote in papers.iter().flat_map(quotes) {
        let place = quote.origin.span(Place::default());
        if checked.insert((quote.origin.source.name.clone(), place.offset())) {
            let prints = known
                .iter()
                .find_map(|known| known.prints.get(&quote.claim));
            let prints = prints.map(Vec::as_slice);
            errors
                .0
                .extend(quoted(quote, prints, is_known(&quote.claim)));
        }
    }
}

/// Checks that the id of a part begins with the id of its sentence, and that the sentence is not also a claim.
fn part(claim: &Claim, is_id: impl Fn(&String) -> bool, errors: &mut Errors) {
    let Some(sentence) = &claim.entry.part_of else {
        return;
    };
    let (id, origin) = (
        claim.entry.id.get_ref(),
        Origin::from_spanned(&claim.origin.source, sentence),
    );
    let name = sentence.get_ref();
    let rest = id.strip_prefix(name.as_str());
    if rest
        .and_then(|rest| rest.strip_prefix('.'))
        .is_none_or(str::is_empty)
    {
        let message = format!("`{id}` is no part of `{name}`");
        let help = format!("the parts of `{name}` are called `{name}.a`, `{name}.b` and so on");
        errors
            .0
            .push(wrong(&origin, whole(sentence), message, &help));
    }
    if is_id(name) {
        let message = format!("`{name}` is a claim itself");
        let help = "a sentence is one claim, or parts that are claims";
        errors
            .0
            .push(wrong(&origin, whole(sentence), message, help));
    }
}

/// Checks that the quoted words occur in the printed text of the named claim.
fn quoted(quote: &Quote, prints: Option<&[String]>, known: bool) -> Option<LoadError> {
    let place = Place {
        start: 0,
        end: quote.words.len(),
    };
    let Quote {
        words,
        claim,
        origin,
    } = quote;
    match prints {
        Some(prints) => {
            let found = prints.iter().any(|printed| quote.stands_in(printed));
            let message = format!("`{words}` is not in the print of `{claim}`");
            let help = "a quotation repeats the words of `printed` letter by letter; only blanks and line ends may differ";
            (!found).then(|| wrong(origin, place, message, help))
        }
        // The claim was left out because it is invalid itself.
        None if known => None,
        None => {
            let message = format!("no claim has the id `{claim}`, so these words are in no print");
            let help = "the claim is named by its full id, such as `gbt-developable/eq-2.2`";
            Some(wrong(origin, place, message, help))
        }
    }
}

fn wrong(origin: &Origin, place: Place, message: String, help: &str) -> LoadError {
    let error = DerivationError::at(origin, place, message).with_help(help);
    LoadError::Derivation(Box::new(error))
}
