//! The verdicts as JSON: the interface that other programs read.
//!
//! One object with `totals` and `claims`, a list in the order of the files; every claim has the same fields in
//! the same order, each a string or null, except `witness`, `net` and `replay`, objects or null. Nothing in it depends on
//! a clock, a path, a locale or the order of a hash table, so a run's bytes can be compared.

use crate::tally::{Remarks, Tally};
use crate::{ReportError, glossary};
use serde::{Serialize, Serializer, ser::SerializeMap};
use std::collections::BTreeSet;
use torse_prove::evidence::Witness;
use torse_syntax::notation::Formula;
use torse_verdicts::claim_record::{HypothesisSource, Role};
use torse_verdicts::judged::{Net, Replay};
use torse_verdicts::outcome::Outcome;

/// Writes the verdicts of `outcomes` as pretty-printed JSON, ending in a newline.
///
/// The fields of a claim are `id`, `kind`, `verdict`, `evidence`, `printed`, `parsed`, `corrected`,
/// `corrected_condition` and `condition` (several are joined by ` and `), `witness` (`at`, an object from names to
/// exact values, `left`, `right`, `left_decimal`, `right_decimal`), `note`, `net`, `replay` and `contradiction`; then
/// what the statement rests on: `hypotheses` (`role`, `formula`, `from` with the `quote` and the `claim` in whose print
/// it stands or the `reason`, and for those of ours whether they are `needed`), `symbols` with their sets,
/// `definitions`, `bases` and `unknowns`, each in the order of use. `readings` has a `name`, what it `says` and the
/// fields of a claim for each reading of the sentence. `part_of`, `reading` and `garbled` are those of the file;
/// `finding` is the sentence of the file with its numbers computed, its mathematics between dollar signs.
///
/// `totals` counts: the `claims`, remarks of ours left out, by their `verdicts`; and the `remarks` (`total`, `proved`, and of these
/// `conditional`).
///
/// `net` says what was tried: whether the verdict is `netted`, the points that were `tried` and those at which it was
/// `decided`, what is true on the thin parts of its domain that are `unvisited`, the `instances` that are identities,
/// `why` it is not netted, and for each of the `conditions` what the statement is where it fails: the points `tried`,
/// how many are `holding`, `failing` and `undefined`, and a point at which the condition is needed, `needed_at`. The
/// net of a `correction` has the same fields.
///
/// `replay` says whether the checker of proofs accepted the proof, `replayed`, and `why` it could not follow it; that of a
/// `correction` has the same fields.
///
/// # Errors
///
/// [`ReportError::Json`] when the serialiser fails, which plain strings give it no reason to.
///
/// ```
/// let none: [torse_verdicts::outcome::Outcome; 0] = [];
/// assert!(torse_report::verdicts_json(&none)?.starts_with("{\n  \"claims\": [],\n  \"totals\": {"));
/// # Ok::<(), torse_report::ReportError>(())
/// ```
pub fn verdicts_json<'a>(
    outcomes: impl IntoIterator<Item = &'a Outcome>,
) -> Result<String, ReportError> {
    verdicts_json_with_kernel(outcomes, &BTreeSet::new())
}

/// The same, where claims whose ids are in the set have the field `kernel` with the value `accepted`: the kernel of the
/// proof assistant accepted proofs of their verdicts.
///
/// # Errors
///
/// As [`verdicts_json`].
pub fn verdicts_json_with_kernel<'a>(
    outcomes: impl IntoIterator<Item = &'a Outcome>,
    accepted: &BTreeSet<String>,
) -> Result<String, ReportError> {
    let outcomes: Vec<&Outcome> = outcomes.into_iter().collect();
    let tally = Tally::new(outcomes.iter().copied());
    let list = List {
        totals: Totals {
            claims: tally.total,
            verdicts: Counts(
                tally
                    .rows
                    .iter()
                    .map(|row| (row.verdict.key, row.count))
                    .collect(),
            ),
            remarks: tally.remarks,
        },
        claims: outcomes
            .into_iter()
            .map(|outcome| entry(outcome, accepted))
            .collect(),
    };
    let mut text = serde_json::to_string_pretty(&list)?;
    text.push('\n');
    Ok(text)
}

/// Writes one claim as in [`verdicts_json`], on a line of its own with a newline.
///
/// # Errors
///
/// As [`verdicts_json`].
pub fn finding_json(outcome: &Outcome) -> Result<String, ReportError> {
    finding_json_with_kernel(outcome, &BTreeSet::new())
}

/// The same for a claim of a run with these accepted claims: [`verdicts_json_with_kernel`].
///
/// # Errors
///
/// As [`verdicts_json`].
pub fn finding_json_with_kernel(
    outcome: &Outcome,
    accepted: &BTreeSet<String>,
) -> Result<String, ReportError> {
    let mut text = serde_json::to_string(&entry(outcome, accepted))?;
    text.push('\n');
    Ok(text)
}

fn entry<'a>(outcome: &'a Outcome, accepted: &BTreeSet<String>) -> Entry<'a> {
    Entry {
        kernel: accepted.contains(&outcome.claim.id).then_some("accepted"),
        ..Entry::from(outcome)
    }
}

#[derive(Serialize)]
struct List<'a> {
    claims: Vec<Entry<'a>>,
    totals: Totals,
}

#[derive(Serialize)]
struct Totals {
    claims: usize,
    verdicts: Counts,
    remarks: Remarks,
}

/// Writes verdicts and how many claims have them, as an object in the order of the tables.
struct Counts(Vec<(&'static str, usize)>);

impl Serialize for Counts {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for (verdict, count) in &self.0 {
            map.serialize_entry(verdict, count)?;
        }
        map.end()
    }
}

#[derive(Serialize)]
struct Entry<'a> {
    id: &'a str,
    kind: &'static str,
    verdict: &'static str,
    evidence: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    kernel: Option<&'static str>,
    part_of: Option<&'a str>,
    printed: &'a str,
    reading: Option<&'a str>,
    garbled: Option<&'a str>,
    finding: Option<&'a str>,
    parsed: Option<&'a str>,
    corrected: Option<&'a str>,
    corrected_condition: Option<String>,
    condition: Option<String>,
    witness: Option<WitnessEntry<'a>>,
    note: Option<&'a str>,
    net: Option<&'a Net>,
    replay: Option<&'a Replay>,
    contradiction: Option<&'a str>,
    hypotheses: Vec<HypothesisEntry<'a>>,
    symbols: Vec<SymbolEntry<'a>>,
    definitions: Vec<DefinitionEntry<'a>>,
    bases: Vec<BasisEntry<'a>>,
    unknowns: Vec<&'a str>,
    readings: Vec<ReadingEntry<'a>>,
}

#[derive(Serialize)]
struct HypothesisEntry<'a> {
    role: Role,
    formula: &'a str,
    #[serde(flatten)]
    from: &'a HypothesisSource,
    needed: Option<bool>,
}

#[derive(Serialize)]
struct SymbolEntry<'a> {
    name: &'a str,
    set: &'a str,
    display: Option<&'a str>,
}

#[derive(Serialize)]
struct DefinitionEntry<'a> {
    head: &'a str,
    body: &'a str,
    own: bool,
    display: Option<&'a str>,
}

#[derive(Serialize)]
struct BasisEntry<'a> {
    head: &'a str,
    degree: u8,
    seeds: Vec<&'a str>,
    step: [&'a str; 2],
    display: Option<&'a str>,
}

#[derive(Serialize)]
struct ReadingEntry<'a> {
    name: &'a str,
    says: &'a str,
    #[serde(flatten)]
    claim: Entry<'a>,
}

impl<'a> From<&'a Outcome> for Entry<'a> {
    fn from(outcome: &'a Outcome) -> Self {
        let joined = |conditions: &[Formula]| {
            let texts: Vec<&str> = conditions.iter().map(text).collect();
            (!texts.is_empty()).then(|| texts.join(" and "))
        };
        let correction = outcome.correction();
        let table = &outcome.claim.table;
        Entry {
            id: &outcome.claim.id,
            kind: glossary::kind(outcome.claim.kind).key,
            verdict: glossary::verdict(outcome.verdict()).key,
            evidence: outcome.evidence().map(|own| glossary::evidence(own).key),
            kernel: None,
            part_of: outcome.claim.part_of.as_deref(),
            printed: &outcome.claim.printed,
            reading: outcome.claim.reading.as_deref(),
            garbled: outcome.claim.garbled.as_deref(),
            finding: outcome.claim.author_note.as_deref(),
            parsed: outcome.parsed().map(text),
            corrected: correction.map(|repair| text(&repair.statement)),
            corrected_condition: correction.and_then(|repair| joined(&repair.conditions)),
            condition: joined(outcome.conditions()),
            witness: outcome.witness().map(WitnessEntry::from),
            note: outcome.claim.note.as_deref(),
            net: outcome.net(),
            replay: outcome.replay(),
            contradiction: outcome.contradiction(),
            hypotheses: (outcome.claim.assumed.iter().map(|h| HypothesisEntry {
                role: h.role,
                formula: text(&h.formula),
                from: &h.from,
                needed: h.needed,
            }))
            .collect(),
            symbols: (table.symbols.iter().map(|s| SymbolEntry {
                name: &s.name,
                set: &s.set,
                display: s.display.as_deref(),
            }))
            .collect(),
            definitions: (table.definitions.iter().map(|d| DefinitionEntry {
                head: text(&d.head),
                body: text(&d.body),
                own: d.own,
                display: d.display.as_deref(),
            }))
            .collect(),
            bases: (table.bases.iter().map(|b| BasisEntry {
                head: text(&b.head),
                degree: b.degree,
                seeds: b.seeds.iter().map(text).collect(),
                step: [text(&b.step[0]), text(&b.step[1])],
                display: b.display.as_deref(),
            }))
            .collect(),
            unknowns: table.unknowns.iter().map(text).collect(),
            readings: (outcome.readings().iter().map(|r| ReadingEntry {
                name: &r.name,
                says: &r.says,
                claim: Entry::from(&r.outcome),
            }))
            .collect(),
        }
    }
}

fn text(formula: &Formula) -> &str {
    &formula.text
}

#[derive(Serialize)]
struct WitnessEntry<'a> {
    at: Point<'a>,
    left: &'a str,
    right: &'a str,
    left_decimal: &'a str,
    right_decimal: &'a str,
}

impl<'a> From<&'a Witness> for WitnessEntry<'a> {
    fn from(witness: &'a Witness) -> Self {
        WitnessEntry {
            at: Point(&witness.at),
            left: &witness.left,
            right: &witness.right,
            left_decimal: &witness.left_decimal,
            right_decimal: &witness.right_decimal,
        }
    }
}

/// Writes the values of the symbols as an object whose members keep the order of the file.
struct Point<'a>(&'a [(String, String)]);

impl Serialize for Point<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut members = serializer.serialize_map(Some(self.0.len()))?;
        for (name, value) in self.0 {
            members.serialize_entry(name, value)?;
        }
        members.end()
    }
}
