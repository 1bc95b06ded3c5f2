//! A claim in its effective form: every name with its set or formula, every hypothesis with where it is from, after the
//! declarations of paper, file, claim and reading are merged.

use super::tree;
use serde_json::{Map, Value, json};
use std::collections::BTreeSet;
use torse_numbers::Affine;
use torse_syntax::derivation::declarations::{
    Basis, Bound, Constant, Declarations, End, Interval, SymbolKind,
};
use torse_syntax::derivation::{Claim, Hypothesis, Provenance, Written};
use torse_syntax::formula::parse;

/// The claims that a claim makes: one for each reading, or itself.
#[must_use]
pub fn claims(claim: &Claim) -> Vec<Value> {
    let of = |claim: &Claim, reading: Option<&str>| {
        let mut all = effective(claim);
        all.insert("reading".to_owned(), json!(reading));
        Value::Object(all)
    };
    match claim.readings.as_slice() {
        [] => vec![of(claim, None)],
        readings => readings
            .iter()
            .map(|reading| of(&reading.claim, Some(&reading.name)))
            .collect(),
    }
}

fn effective(claim: &Claim) -> Map<String, Value> {
    let all = &claim.declarations;
    let symbols: Map<String, Value> = all
        .symbols()
        .map(|(name, kind)| (name.to_owned(), set(kind)))
        .collect();
    let ranges: Map<String, Value> = all
        .ranges()
        .map(|(name, range)| {
            let outer = range.outer.as_ref().map(set);
            let from = from(&range.provenance);
            (name.to_owned(), json!({ "from": from, "outer": outer }))
        })
        .collect();
    let bases: Map<String, Value> = all
        .bases()
        .map(|(name, family)| (name.to_owned(), basis(family)))
        .collect();
    let definitions: Map<String, Value> = all
        .definitions()
        .map(|(name, definition)| {
            let value = json!({
                "parameters": definition.parameters,
                "indexed": definition.indexed,
                "body": tree(&definition.body.expr),
            });
            (name.to_owned(), value)
        })
        .collect();
    let sought = claim.existentials.iter().map(|s| {
        let witness = s.witness.as_ref().map(|w| tree(&w.expr));
        json!([s.name, witness])
    });
    let mut found = Map::new();
    let mut add = |key: &str, value: Value| found.insert(key.to_owned(), value);
    add("id", json!(claim.entry.id.get_ref()));
    add("symbols", Value::Object(symbols));
    add("ranges", Value::Object(ranges));
    add("bases", Value::Object(bases));
    add("definitions", Value::Object(definitions));
    add("given", hypotheses(&claim.given));
    add("assume", hypotheses(&claim.assumptions));
    add("solve_for", trees(&claim.unknowns));
    add("exists", sought.collect());
    add(
        "states",
        json!(claim.statement.as_ref().map(|w| tree(&w.expr))),
    );
    add("domain", domain(claim, all));
    found
}

/// The declared symbols in reach of the claim, those at which functions are taken too, and how many hypotheses it has, those
/// that ends of intervals say too.
fn domain(claim: &Claim, all: &Declarations) -> Value {
    let Some(statement) = &claim.statement else {
        return Value::Null;
    };
    let Ok(core) = torse_elaborate::elaborate(claim, statement) else {
        return Value::Null;
    };
    let declared = |name: &&str| all.symbols().any(|(own, _)| own == *name);
    let mut symbols: BTreeSet<String> = BTreeSet::new();
    for name in core.symbols.keys() {
        // The derivatives of a function at a place are symbols that no file declares.
        let place = parse(name).ok().filter(|_| name.contains('('));
        let names = place.as_ref().map_or(vec![&**name], |place| place.names());
        symbols.extend(names.into_iter().filter(declared).map(str::to_owned));
    }
    let bounded = symbols.iter().filter_map(|name| match all.symbol(name) {
        Some(SymbolKind::Real(interval)) => Some(interval.formulas().count()),
        _ => None,
    });
    json!({
        "symbols": symbols,
        "hypotheses": core.hypotheses.len(),
        "ends": bounded.sum::<usize>(),
    })
}

fn trees(written: &[Written]) -> Value {
    written.iter().map(|w| tree(&w.expr)).collect()
}

fn hypotheses(all: &[Hypothesis]) -> Value {
    all.iter()
        .map(|h| json!([tree(&h.formula.expr), from(&h.provenance)]))
        .collect()
}

fn from(provenance: &Provenance) -> Value {
    match provenance {
        Provenance::Stated => Value::Null,
        Provenance::Printed(quote) => json!(["printed", quote.words, quote.claim]),
        Provenance::Ours { reason } => json!(["ours", reason]),
    }
}

/// A set of values.
fn set(kind: &SymbolKind) -> Value {
    match kind {
        SymbolKind::Real(interval) => json!({ "real": ends(interval) }),
        SymbolKind::Integer { least, most } => {
            json!({ "integer": [least.as_ref().map(affine), most.as_ref().map(affine)] })
        }
        SymbolKind::Vector(dimension) => json!({ "vector": dimension }),
        SymbolKind::Family { dimension, ranges } => {
            let ranges = ranges.iter().map(|(low, high)| [affine(low), affine(high)]);
            json!({ "family": dimension, "indices": ranges.collect::<Vec<_>>() })
        }
    }
}

/// Both ends: nothing for infinity, or whether it is closed, and its value.
fn ends(interval: &Interval) -> Value {
    let end = |number: &Option<Bound>, formula: &Option<End>| match (number, formula) {
        (Some(bound), None) => json!([bound.closed, constant(&bound.value)]),
        (None, Some(end)) => json!([end.closed, tree(&end.formula.expr)]),
        (None, None) => Value::Null,
        (Some(_), Some(_)) => json!("two ends on one side"),
    };
    json!([
        end(&interval.lower, &interval.above),
        end(&interval.upper, &interval.below)
    ])
}

fn constant(value: &Constant) -> Value {
    json!([value.rational.to_string(), value.turns.to_string()])
}

fn affine(form: &Affine) -> Value {
    let multiples: Map<String, Value> = form
        .multiples()
        .map(|(name, multiple)| (name.to_owned(), json!(multiple)))
        .collect();
    json!([form.constant(), multiples])
}

fn basis(family: &Basis) -> Value {
    json!({
        "variable": family.variable,
        "parameters": family.parameters,
        "degree": family.degree,
        "seeds": trees(&family.seeds),
        "step": if family.is_list { vec![] } else { vec![tree(&family.step.0.expr), tree(&family.step.1.expr)] },
        "counters": family.counters,
    })
}
