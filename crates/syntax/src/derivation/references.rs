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

/// Resolves all ids and quotations. A claim that uses a sentence split into parts uses all of the parts. `ids` are
/// the ids of all claims and figures, `sentences` those of sentences in parts; both include entries that were left
/// out, which are not reported again.
pub(super) fn resolve(
    papers: &mut [Paper],
    ids: &BTreeSet<String>,
    sentences: &BTreeSet<String>,
    errors: &mut Errors,
) {
    let mut prints: BTreeMap<String, Vec<String>> = BTreeMap::new();
    let mut parts: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for claim in papers.iter().flat_map(|paper| &paper.claims) {
        let id = claim.entry.id.get_ref();
        for id in std::iter::once(id).chain(claim.sentence_id()) {
            let printed = claim.entry.printed.clone();
            prints.entry(id.clone()).or_default().push(printed);
        }
        if let Some(whole) = claim.sentence_id() {
            parts.entry(whole.clone()).or_default().push(id.clone());
        }
    }
    let known = |id: &String| ids.contains(id) || sentences.contains(id);
    for claim in papers.iter_mut().flat_map(|paper| &mut paper.claims) {
        let mut uses = vec![];
        for used in &claim.entry.uses {
            let id = used.get_ref();
            if !known(id) {
                let help = "`uses` takes full ids, such as `gbt-developable/eq-2.2`";
                let origin = Origin::from_spanned(&claim.origin.source, used);
                let message = format!("no claim has the id `{id}`");
                errors.0.push(wrong(&origin, whole(used), message, help));
            }
            match parts.get(id) {
                Some(parts) => uses.extend(parts.iter().cloned()),
                None => uses.push(id.clone()),
            }
        }
        claim.uses = uses;
        part(claim, ids, errors);
    }
    let mut checked = BTreeSet::new();
    let papers = papers.iter();
    let quotes = papers.flat_map(|paper| {
        let own = paper.declarations.ranges();
        let own = own.filter_map(|(_, range)| range.provenance.quote());
        let answers = paper.claims.iter().flat_map(|claim| &claim.answers);
        let answers = answers.map(|answer| &answer.quote);
        own.chain(paper.claims.iter().flat_map(Claim::quotes))
            .chain(answers)
    });
    for quote in quotes {
        let place = quote.origin.span(Place::default());
        if checked.insert((quote.origin.source.name.clone(), place.offset())) {
            errors.0.extend(quoted(quote, &prints, known(&quote.claim)));
        }
    }
}

/// Checks that the id of a part begins with the id of its sentence, and that the sentence is not also a claim.
fn part(claim: &Claim, ids: &BTreeSet<String>, errors: &mut Errors) {
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
    if ids.contains(name) {
        let message = format!("`{name}` is a claim itself");
        let help = "a sentence is one claim, or parts that are claims";
        errors
            .0
            .push(wrong(&origin, whole(sentence), message, help));
    }
}

/// Checks that the quoted words occur in the printed text of the named claim.
fn quoted(quote: &Quote, prints: &BTreeMap<String, Vec<String>>, known: bool) -> Option<LoadError> {
    let place = Place {
        start: 0,
        end: quote.words.len(),
    };
    let Quote {
        words,
        claim,
        origin,
    } = quote;
    match prints.get(claim) {
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
