//! Corrigenda: the errors of a paper as they are reported to its authors, and the affected claims after all
//! corrections.
//!
//! The corrected definitions of all corrigenda apply together, so every claim about the corrected text is about the
//! paper with all corrections.

use super::author_note::{AuthorNote, author_note};
use super::claim::Claim;
use super::declarations::{Declarations, Definition};
use super::definitions::{add_definitions, name_of};
use super::error::{DerivationError, LoadError};
use super::provenance::{Hypothesis, Provenance, Quote};
use super::schema::corrigendum::{ChangeEntry, CorrigendumEntry, LetterPart};
use super::source::{Origin, Source, whole};
use super::table::Errors;
use super::written::written;
use crate::taxonomy::Kind;
use std::collections::BTreeSet;
use std::sync::Arc;
use toml::Spanned;

/// An error of a paper.
#[derive(Debug, Clone)]
pub struct Corrigendum {
    /// Its id: `paper/corrigendum.name`.
    pub id: String,
    /// Its place in the paper, if that is not the place of the first claim.
    pub at: Option<String>,
    /// The part of a letter that lists it, if not the one that the verdicts of its claims ask for.
    pub part: Option<LetterPart>,
    /// The error in one sentence; formulas in it are evaluated in the first claim.
    pub says: AuthorNote,
    /// The ids of the claims in which the error shows.
    pub shows: Vec<String>,
    /// Corrected definitions by name; in force for all claims.
    pub definitions: Vec<(String, Definition)>,
    /// The corrected wording.
    pub changes: Vec<Rewording>,
    /// The claims in which it shows, in the same order, and others whose words change, once the whole paper is corrected.
    pub corrected: Vec<CorrectedClaim>,
}

/// A passage of a paper and its corrected wording.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Rewording {
    /// The id of the claim whose printed text contains the passage.
    pub claim: String,
    /// The passage; it may be the whole printed text of the claim.
    pub printed: String,
    /// The corrected wording.
    pub reads: String,
    /// The id of the remark that states the correction.
    pub remark: Option<String>,
}

/// A claim with all corrections of its paper applied.
#[derive(Debug, Clone)]
pub struct CorrectedClaim {
    /// The claim.
    pub claim: Claim,
    /// Whether the file restates the claim; if not, a correction that was found replaces its statement.
    pub restated: bool,
}

impl Corrigendum {
    /// Returns the claim with the corrected definitions of all corrigenda; none if no formula of it uses them. A name
    /// that the claim itself declares is its own.
    #[must_use]
    pub fn redefined(corrigenda: &[Self], claim: &Claim) -> Option<Claim> {
        let own = claim.entry.local.keys().map(|head| name_of(head));
        let own: BTreeSet<String> = own.chain(claim.entry.symbols.keys().cloned()).collect();
        let definitions = corrigenda.iter().flat_map(|own| &own.definitions);
        let definitions: Vec<_> = definitions
            .filter(|(name, _)| !own.contains(name))
            .collect();
        let names = definitions.iter().map(|(name, _)| name.as_str()).collect();
        claim.uses_names(&names).then(|| {
            let mut corrected = claim.clone();
            corrected.author_note = None;
            redefine(&mut corrected, definitions.iter().copied());
            corrected
        })
    }
}

/// Puts definitions in the place of those that the claim and its readings have.
fn redefine<'d>(
    claim: &mut Claim,
    definitions: impl Iterator<Item = &'d (String, Definition)> + Clone,
) {
    let mut declarations = (*claim.declarations).clone();
    for (name, definition) in definitions.clone() {
        declarations.define(name.clone(), definition.clone());
    }
    claim.declarations = Arc::new(declarations);
    for reading in &mut claim.readings {
        redefine(&mut reading.claim, definitions.clone());
    }
}

/// Reads the corrigenda of a paper. Reports entries that name no claim of the paper, or quote words that are not
/// printed.
pub(super) fn corrigenda(
    entries: &[(Arc<Source>, CorrigendumEntry)],
    claims: &[Claim],
    left_out: &[String],
    errors: &mut Errors,
) -> Vec<Corrigendum> {
    let mut shown = BTreeSet::new();
    let mut definitions: Vec<Vec<(String, Definition)>> = vec![];
    for (source, entry) in entries {
        let mut own = Declarations::default();
        add_definitions(&mut own, source, &entry.define, errors);
        let own = own.definitions();
        definitions.push(
            own.map(|(name, of)| (name.to_owned(), of.clone()))
                .collect(),
        );
    }
    let made = |((source, entry), own): (&(Arc<Source>, CorrigendumEntry), &Vec<_>)| {
        let says = errors.keep(author_note(source, &entry.says));
        let mut wrong = |text: &Spanned<String>, message: String, help: &str| {
            let origin = Origin::from_spanned(source, text);
            let error = DerivationError::at(&origin, whole(text), message).with_help(help);
            errors.0.push(LoadError::Derivation(Box::new(error)));
        };
        if entry.says.get_ref().trim().is_empty() || entry.shows.is_empty() {
            let help = "`says` states the fault in one sentence, `shows` lists the claims in which it shows";
            wrong(
                &entry.id,
                "this corrigendum states no fault".to_owned(),
                help,
            );
        }
        let find =
            |id: &Spanned<String>| claims.iter().find(|c| c.entry.id.get_ref() == id.get_ref());
        for id in &entry.shows {
            if find(id).is_none() && !left_out.contains(id.get_ref()) {
                let message = format!("no claim has the id `{}`", id.get_ref());
                wrong(id, message, "a claim of this paper is named by its full id");
            }
            if !shown.insert(id.get_ref().clone()) {
                let message = format!("`{}` shows in two corrigenda", id.get_ref());
                wrong(
                    id,
                    message,
                    "a claim belongs to the fault that makes it false",
                );
            }
        }
        let mut changes = vec![];
        for change in &entry.changes {
            let Some(claim) = find(&change.claim) else {
                if !left_out.contains(change.claim.get_ref()) {
                    let message = format!("no claim has the id `{}`", change.claim.get_ref());
                    let help = "what is changed is the print of a claim of this paper";
                    wrong(&change.claim, message, help);
                }
                continue;
            };
            if let Some(id) = &change.remark
                && find(id).is_none_or(|remark| remark.entry.kind != Kind::Remark)
                && !left_out.contains(id.get_ref())
            {
                let message = format!("`{}` is not a remark", id.get_ref());
                wrong(id, message, "`remark` names a claim of the kind `remark`");
            }
            let printed = match &change.printed {
                None => claim.entry.printed.clone(),
                Some(words) => {
                    let quote = Quote::new(source, words, None, claim.entry.id.get_ref());
                    let print = &claim.entry.printed;
                    if !quote.stands_in(print) && !quote.fills(print) {
                        let message =
                            format!("these words are not in the print of `{}`", quote.claim);
                        let help = "a quote has the words of `printed` letter by letter; where that leaves words out (`...`), it may have them";
                        wrong(words, message, help);
                    }
                    words.get_ref().clone()
                }
            };
            changes.extend(change.reads.as_ref().map(|reads| Rewording {
                claim: change.claim.get_ref().clone(),
                printed,
                reads: reads.get_ref().clone(),
                remark: change.remark.as_ref().map(|id| id.get_ref().clone()),
            }));
        }
        // Data that are changed are told where they are printed, and the fault shows elsewhere.
        let is_shown = |id: &&Spanned<String>| {
            let mut shows = entry.shows.iter();
            shows.any(|shown| shown.get_ref() == id.get_ref())
        };
        let changed = entry.changes.iter().map(|change| &change.claim);
        let changed = changed.filter(|id| !is_shown(id));
        let corrected = entry.shows.iter().chain(changed).filter_map(find);
        let corrected: Vec<CorrectedClaim> = corrected
            .map(|claim| {
                let id = claim.entry.id.get_ref();
                let restates = |c: &&ChangeEntry| {
                    c.claim.get_ref() == id && (c.states.is_some() || c.remark.is_some())
                };
                let change = entry.changes.iter().find(restates);
                // A statement given with the change takes precedence over that of the remark.
                let stated = change.filter(|change| change.states.is_none());
                let remark = stated.and_then(|change| change.remark.as_ref());
                let remark = remark.and_then(find);
                correct(source, claim, remark, change, &definitions, errors)
            })
            .collect();
        Corrigendum {
            id: entry.id.get_ref().clone(),
            at: entry.at.clone(),
            part: entry.part,
            says: says.unwrap_or(AuthorNote { pieces: vec![] }),
            shows: entry.shows.iter().map(|id| id.get_ref().clone()).collect(),
            definitions: own.clone(),
            changes,
            corrected,
        }
    };
    entries.iter().zip(&definitions).map(made).collect()
}

/// Corrects a claim: applies the corrected definitions of all corrigenda, and takes the statement of the change or of
/// the remark.
fn correct(
    source: &Arc<Source>,
    claim: &Claim,
    remark: Option<&Claim>,
    change: Option<&ChangeEntry>,
    definitions: &[Vec<(String, Definition)>],
    errors: &mut Errors,
) -> CorrectedClaim {
    let mut corrected = remark.unwrap_or(claim).clone();
    corrected.entry.id = claim.entry.id.clone();
    corrected.author_note = None;
    redefine(&mut corrected, definitions.iter().flatten());
    if let Some(change) = change {
        let mut declarations = (*corrected.declarations).clone();
        add_definitions(&mut declarations, source, &change.local, errors);
        corrected.declarations = Arc::new(declarations);
        for text in &change.assume {
            if let Some(formula) = errors.keep(written(source, text)) {
                corrected.assumptions.push(Hypothesis {
                    formula,
                    provenance: Provenance::Stated,
                });
            }
        }
        let states = change
            .states
            .as_ref()
            .and_then(|text| errors.keep(written(source, text)));
        corrected.statement = states.or(corrected.statement);
        corrected.readings.clear();
    }
    CorrectedClaim {
        claim: corrected,
        restated: change.is_some(),
    }
}
