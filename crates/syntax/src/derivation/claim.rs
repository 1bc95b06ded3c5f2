//! A claim of a derivation file: its formulas are parsed and its fields are checked against one another.

use super::author_note::{AuthorNote, author_note};
use super::declarations::Declarations;
use super::definitions::add_definitions;
use super::error::{DerivationError, LoadError};
use super::existential::{Existential, existentials};
use super::figure::{Figure, figure};
use super::folder;
use super::latex_formula::latex_written;
use super::provenance::{Hypothesis, Provenance, Quote, provenance};
use super::schema::hypothesis::HypothesisEntry;
use super::schema::{AnswerEntry, ClaimEntry, ReadingEntry};
use super::source::{Origin, Source, whole};
use super::table::Errors;
use super::written::{Written, written};
use crate::formula::Expr;
use crate::notation::text;
use crate::taxonomy::{Flag, Kind};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use toml::Spanned;
use torse_numbers::fault_injection::{InjectedFault, injected};

/// The largest number of readings of a sentence; each is decided as a claim of its own.
const MAX_READINGS: usize = 16;

/// A claim, parsed but not decided.
#[derive(Debug, Clone)]
pub struct Claim {
    /// The fields of the claim in the file.
    pub entry: ClaimEntry,
    /// The place of the claim's id, for errors about the claim as a whole.
    pub origin: Origin,
    /// The symbols, bases and definitions that it may use: its own, those of its file and those of its paper.
    pub declarations: Arc<Declarations>,
    /// The given equations.
    pub given: Vec<Hypothesis>,
    /// The unknowns.
    pub unknowns: Vec<Written>,
    /// The existential symbols: numbers that the claim says to exist.
    pub existentials: Vec<Existential>,
    /// The assumptions.
    pub assumptions: Vec<Hypothesis>,
    /// The statement, if it has one.
    pub statement: Option<Written>,
    /// The possible readings of the sentence; empty if there is only one, the statement.
    pub readings: Vec<Reading>,
    /// The author's note about the finding.
    pub author_note: Option<AuthorNote>,
    /// The answers to signs that the statement is not what the paper prints.
    pub answers: Vec<Answer>,
    /// The ids of the claims that it depends on; if one of them is split into parts, the ids of all parts.
    pub uses: Vec<String>,
    /// All printed values of the same example, this one included: the values of the file whose ids agree up to the
    /// first point. Empty in the members of the list itself.
    pub example: Arc<[Claim]>,
    /// The drawing of a figure.
    pub figure: Option<Figure>,
}

/// One possible reading of a sentence.
#[derive(Debug, Clone)]
pub struct Reading {
    /// A short name of the reading.
    pub name: String,
    /// The sentence in words, as this reading understands it.
    pub says: String,
    /// The claim in this reading: the fields of the sentence together with those of the reading; it has no readings
    /// itself.
    pub claim: Claim,
}

/// An answer to a sign (flag) that the statement is not what the paper prints.
#[derive(Debug, Clone)]
pub struct Answer {
    /// The flag.
    pub flag: Flag,
    /// Words of the paper.
    pub quote: Quote,
    /// Why the words answer the flag, where that is not plain.
    pub says: Option<String>,
    /// Where the flag stands in the file.
    pub origin: Origin,
}

impl Claim {
    /// The id in the inventory of the sentence of which this claim is a part.
    #[must_use]
    pub fn sentence_id(&self) -> Option<&String> {
        self.entry.part_of.as_ref().map(Spanned::get_ref)
    }

    /// The quotations that hypotheses and ranges refer to, including those of its readings.
    #[must_use]
    pub fn quotes(&self) -> Vec<&Quote> {
        let hypotheses = self.assumptions.iter().chain(&self.given);
        let from = hypotheses.map(|hypothesis| &hypothesis.provenance);
        let ranges = self.declarations.ranges();
        let from = from.chain(ranges.map(|(_, range)| &range.provenance));
        let mut quotes: Vec<&Quote> = from.filter_map(Provenance::quote).collect();
        quotes.extend(self.readings.iter().flat_map(|r| r.claim.quotes()));
        quotes
    }

    /// All formulas of the claim itself, without those of its readings.
    fn formulas(&self) -> impl Iterator<Item = &Expr> {
        let hypotheses = self.given.iter().chain(&self.assumptions);
        let formulas = hypotheses.map(|h| &h.formula).chain(&self.unknowns);
        let holes = self.author_note.iter().flat_map(AuthorNote::holes);
        let witnesses = self.existentials.iter().filter_map(|s| s.witness.as_ref());
        let formulas = formulas
            .chain(&self.statement)
            .chain(holes)
            .chain(witnesses);
        formulas.map(|w| &w.expr)
    }

    /// Whether a formula of the claim or of a reading uses one of these names, directly or through definitions.
    pub(super) fn uses_names(&self, names: &BTreeSet<&str>) -> bool {
        let wanted = |name: &str| names.contains(name);
        self.declarations.depends_on(self.formulas(), wanted)
            || self.readings.iter().any(|r| r.claim.uses_names(names))
    }

    /// Whether a formula of the claim uses an invalid declaration, directly or through definitions.
    pub(super) fn uses_invalid_declaration(&self) -> bool {
        let figure = self.figure.as_ref();
        self.declarations.depends_on_invalid(self.formulas())
            || figure.is_some_and(|figure| figure.declarations.any_invalid())
            || self
                .readings
                .iter()
                .any(|r| r.claim.uses_invalid_declaration())
    }
}

/// Gives every printed value the list of all values of its example.
pub(super) fn gather_examples(claims: &mut [Claim]) {
    let mut examples: BTreeMap<String, Vec<Claim>> = BTreeMap::new();
    for value in claims.iter().filter(|c| c.entry.kind == Kind::Value) {
        let values = examples.entry(example(value).to_owned()).or_default();
        values.push(value.clone());
    }
    for (name, values) in examples {
        let values: Arc<[Claim]> = values.into();
        for value in claims.iter_mut().filter(|c| example(c) == name) {
            value.example = Arc::clone(&values);
        }
    }
}

/// The id up to the first point: `hermite-developable/ex-4` for `hermite-developable/ex-4.r0u`.
fn example(claim: &Claim) -> &str {
    let id = claim.entry.id.get_ref();
    id.split_once('.')
        .map_or(id.as_str(), |(example, _)| example)
}

/// Parses a claim; its ill-formed formulas are reported and left out.
pub(super) fn claim(
    source: &Arc<Source>,
    shared: &Arc<Declarations>,
    slug: &str,
    entry: ClaimEntry,
    errors: &mut Errors,
) -> Claim {
    errors.keep(folder::check_id(source, &entry.id, slug));
    check_fields(source, &entry, errors);
    let readings = entry
        .readings
        .iter()
        .take(MAX_READINGS)
        .map(|reading| Reading {
            name: reading.name.get_ref().clone(),
            says: reading.says.get_ref().clone(),
            claim: formulas(source, shared, read_as(&entry, reading), errors),
        })
        .collect();
    let answer = |answer: &AnswerEntry| Answer {
        flag: *answer.flag.get_ref(),
        quote: Quote::new(
            source,
            &answer.quote,
            answer.within.as_ref(),
            entry.id.get_ref(),
        ),
        says: answer.says.clone(),
        origin: Origin::range(source, answer.flag.span().start, answer.flag.span().end),
    };
    let answers = entry.answers.iter().map(answer).collect();
    let note = entry.finding.as_ref().map(|text| author_note(source, text));
    let mut claim = formulas(source, shared, entry, errors);
    claim.readings = readings;
    claim.answers = answers;
    claim.author_note = note.and_then(|note| errors.keep(note));
    claim.figure = claim.entry.figure.clone().map(|drawn| {
        let id = claim.entry.id.get_ref().clone();
        let (origin, claims) = (claim.origin.clone(), vec![id.clone()]);
        let shared = &claim.declarations;
        figure(source, origin, shared, id, claims, *drawn, errors)
    });
    claim
}

/// Parses the formulas of a claim under its own declarations.
fn formulas(
    source: &Arc<Source>,
    shared: &Arc<Declarations>,
    mut entry: ClaimEntry,
    errors: &mut Errors,
) -> Claim {
    let id = &entry.id.get_ref().clone();
    let own = [entry.symbols.len(), entry.local.len(), entry.display.len()];
    let declarations = if own == [0; 3] {
        Arc::clone(shared)
    } else {
        let mut own = (**shared).clone();
        own.add_symbols(source, &entry.symbols, Some(id), errors);
        add_definitions(&mut own, source, &entry.local, errors);
        own.add_displays(source, &entry.display, errors);
        Arc::new(own)
    };
    let mut all = |texts: &[Spanned<String>]| -> Vec<Written> {
        let parsed = texts.iter().map(|text| written(source, text));
        parsed.filter_map(|result| errors.keep(result)).collect()
    };
    let mut statement = all(entry.states.as_slice()).pop();
    let unknowns = all(&entry.solve_for);
    if let (Some(latex), None) = (&entry.latex, &entry.states) {
        statement = errors.keep(latex_written(source, latex, &declarations));
        let read = statement.as_ref().map(|written| text(&written.expr));
        entry.states = read.map(|read| Spanned::new(latex.span(), read));
    }
    let existentials = existentials(source, &declarations, &entry.exists, errors);
    Claim {
        existentials,
        given: hypotheses(source, &entry.given, id, errors),
        assumptions: hypotheses(source, &entry.assume, id, errors),
        unknowns,
        statement,
        readings: vec![],
        author_note: None,
        answers: vec![],
        uses: vec![],
        figure: None,
        declarations,
        origin: Origin::from_spanned(source, &entry.id),
        entry,
        example: Arc::new([]),
    }
}

fn hypotheses(
    source: &Arc<Source>,
    entries: &[HypothesisEntry],
    own: &str,
    errors: &mut Errors,
) -> Vec<Hypothesis> {
    let mut found = vec![];
    for entry in entries {
        let Some(formula) = errors.keep(written(source, &entry.states)) else {
            continue;
        };
        let provenance = match &entry.from {
            None => Provenance::Stated,
            Some(from) => provenance(source, from, Some(own), entry.states.span(), errors),
        };
        found.push(Hypothesis {
            formula,
            provenance,
        });
    }
    if injected(InjectedFault::HypothesisLeftOut) {
        found.pop();
    }
    found
}

/// The entry of the claim that results from one reading of a sentence.
fn read_as(entry: &ClaimEntry, reading: &ReadingEntry) -> ClaimEntry {
    let mut entry = entry.clone();
    let more = reading.clone();
    entry.readings.clear();
    entry.states = Some(more.states);
    entry.latex = None;
    entry.reading = Some(more.says.into_inner());
    entry.symbols.extend(more.symbols);
    entry.local.extend(more.local);
    entry.given.extend(more.given);
    entry.solve_for.extend(more.solve_for);
    entry.assume.extend(more.assume);
    entry
}

/// Checks fields that require or exclude one another.
fn check_fields(source: &Arc<Source>, entry: &ClaimEntry, errors: &mut Errors) {
    let mut wrong = |text: &Spanned<String>, message: &str, help: &str| {
        let origin = Origin::from_spanned(source, text);
        let error = DerivationError::at(&origin, whole(text), message).with_help(help);
        errors.0.push(LoadError::Derivation(Box::new(error)));
    };
    let reasons = [&entry.underspecified, &entry.out_of_scope, &entry.unstated];
    let undecidable = reasons.into_iter().any(Option::is_some);
    let optional = matches!(entry.kind, Kind::Definition | Kind::Figure) || undecidable;
    let stated = entry.states.as_ref().or(entry.latex.as_ref());
    if let (Some(stated), Some(_)) = (stated, &entry.unstated) {
        let message = "a claim with a statement is not `unstated`";
        wrong(stated, message, "leave one of them out");
    }
    if let (Some(latex), true) = (
        &entry.latex,
        entry.states.is_some() || !entry.readings.is_empty(),
    ) {
        let message =
            "a claim has its statement in LaTeX, or in `states` or `readings`, but not both";
        wrong(latex, message, "leave one of them out");
    }
    let nothing = entry.states.is_none() && entry.latex.is_none();
    if !optional && nothing && entry.readings.is_empty() {
        let message = "this claim states nothing: the field `states` is missing";
        let help = "add `states = '...'`, or say why not with `unstated`, `underspecified` or `out_of_scope`";
        wrong(&entry.id, message, help);
    }
    let pairs = |given: usize, solve_for: usize| (given == 0) == (solve_for == 0);
    let (given, unknowns) = (entry.given.len(), entry.solve_for.len());
    let in_readings = |r: &ReadingEntry| pairs(given + r.given.len(), unknowns + r.solve_for.len());
    let paired = match entry.readings.as_slice() {
        [] => pairs(given, unknowns),
        readings => readings.iter().all(in_readings),
    };
    if !paired {
        let help = "equations of `given` are solved for the unknowns of `solve_for`";
        wrong(&entry.id, "`given` and `solve_for` go together", help);
    }
    let help = "`readings` has the name, the words and the statement of each reading, two or more";
    let mut names = BTreeSet::new();
    for reading in &entry.readings {
        let name = reading.name.get_ref();
        if name.trim().is_empty() || !names.insert(name) {
            wrong(&reading.name, "each reading has a name of its own", help);
        }
        if reading.says.get_ref().trim().is_empty() {
            let message = "each reading says in words how it reads the sentence";
            wrong(&reading.says, message, help);
        }
    }
    if let Some(first_above) = entry.readings.get(MAX_READINGS) {
        let all = entry.readings.len();
        let message = format!("a sentence has {MAX_READINGS} readings at most, and this has {all}");
        wrong(&first_above.name, &message, help);
    }
    match (entry.readings.as_slice(), &entry.states) {
        ([only], _) => wrong(&only.name, "a single reading belongs in `states`", help),
        ([_, ..], Some(states)) => {
            let message = "a sentence with `readings` has no `states` of its own";
            wrong(states, message, help);
        }
        ([first, ..], None) if undecidable => {
            let message =
                "a sentence with `readings` is not `unstated`, `underspecified` or `out_of_scope`";
            wrong(&first.name, message, help);
        }
        _ => {}
    }
    let empty = entry.garbled.iter().chain(&entry.finding);
    for text in empty.filter(|text| text.get_ref().trim().is_empty()) {
        wrong(text, "this says nothing", "leave the field out");
    }
}
