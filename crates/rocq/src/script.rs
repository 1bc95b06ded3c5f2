//! Proof scripts: which tactic of `Torse.Tactics` proves a goal, and with which numbers.
//!
//! | verdict rests on | emitter | what the tactic does |
//! |---|---|---|
//! | identity | `stage`, `identity` | computes sums, bases and matrices, derivatives and special angles; then `field`, modulo s^2 + c^2 = 1 |
//! | `given` equations | `prepared`, `unknown` | the same in the equations, which are solved for the unknowns one after the other |
//! | induction | `symbolic` | reads a curve of symbolic degree as ((1 - x) + x E)^n of its seeds: end values, recursion, unity |
//! | inequality, enclosure | `ordered` | enclosures of closed numbers by rational arithmetic; linear and polynomial arithmetic |
//! | witness | `refuting` | the statement at the witness, which computes to something false |
//!
//! Every theorem with premises has a second one, `met`: values at which all premises are true.

use crate::task::{Evidence, Goal, Role};
use std::collections::BTreeMap;
use std::sync::Arc;
use torse_language::core::Set;
use torse_language::derivation::declarations::{Bound, Interval};
use torse_numbers::{Rational, rational};

/// A theorem with its script.
#[derive(Debug, Clone)]
pub struct Script {
    /// Its name in the module.
    pub name: &'static str,
    /// What it says.
    pub says: &'static str,
    /// The tactics, without the point at the end.
    pub tactics: String,
}

/// The theorems of a goal with their scripts.
#[must_use]
pub fn scripts(goal: &Goal) -> Vec<Script> {
    let names: Vec<&str> = goal
        .proposition
        .definitions
        .iter()
        .map(|(name, _)| name.as_str())
        .collect();
    let open = |what: &str| match names.is_empty() {
        true => format!("cbv beta zeta delta [{what}]"),
        false => format!("cbv beta zeta delta [{what} {}]", names.join(" ")),
    };
    let Some(tactic) = emitter(goal) else {
        let tactics = format!("intro no; {} in no; {}", open("statement"), refuting(goal));
        return vec![Script {
            name: "refuted",
            says: "~ statement",
            tactics,
        }];
    };
    let unknowns = goal
        .proposition
        .unknowns
        .iter()
        .map(|unknown| format!("unknown {unknown}; "));
    let tactics = match goal.given {
        0 => match staged(goal).filter(|_| tactic == "identity") {
            Some(stages) => format!("cbv beta zeta delta [statement]; {stages}{tactic}"),
            None => format!("{}; {tactic}", open("statement")),
        },
        _ => format!(
            "{}; prepared; {}finished",
            open("statement"),
            unknowns.collect::<String>()
        ),
    };
    let mut scripts = vec![Script {
        name: "proved",
        says: "statement",
        tactics,
    }];
    if !goal.proposition.premises.is_empty() {
        let points: Vec<String> = [Choice::Generic, Choice::Zero]
            .iter()
            .map(|choice| format!("({}met)", exists(&point(goal, *choice))))
            .collect();
        let tactics = format!("{}; first [{}]", open("instance"), points.join(" | "));
        scripts.push(Script {
            name: "met",
            says: "instance",
            tactics,
        });
    }
    scripts
}

/// What is costly to compute as often as a definition occurs.
const COSTLY: [&str; 3] = ["Derive", "inverse ", "solve "];

/// The definitions computed one after the other, and the last one where it stands; none where nothing in them is costly.
fn staged(goal: &Goal) -> Option<String> {
    let definitions = &goal.proposition.definitions;
    let costly = |(_, text): &(String, String)| COSTLY.iter().any(|word| text.contains(word));
    let ((last, _), others) = definitions.split_last()?;
    if others.is_empty() || !definitions.iter().any(costly) {
        return None;
    }
    let stages = others.iter().map(|(name, _)| format!("stage {name}; "));
    Some(format!(
        "{}staged_goal {last}; ",
        stages.collect::<String>()
    ))
}

/// The tactic that proves a statement; none for a refutation.
fn emitter(goal: &Goal) -> Option<&'static str> {
    let integers = goal
        .symbols
        .values()
        .any(|set| matches!(set, Set::Integer { .. }));
    match (goal.role, goal.evidence) {
        (Role::Refuted, _) => None,
        (_, Evidence::Inequality | Evidence::Enclosure) => Some("ordered"),
        (_, Evidence::Induction) => Some("symbolic"),
        _ if integers => Some("symbolic"),
        _ => Some("identity"),
    }
}

/// The module of proofs of a goal.
#[must_use]
pub fn module(folder: &str, section: &str, goal: &Goal) -> String {
    let module = &goal.module;
    let mut text = format!("\nModule {module}.\nImport {folder}.{section}.{module}.\n");
    for Script {
        name,
        says,
        tactics,
    } in scripts(goal)
    {
        text.push_str(&format!(
            "Theorem {name} : {says}.\nProof. {tactics}. Qed.\n"
        ));
    }
    text.push_str(&format!("End {module}.\n"));
    text
}

/// Which values are tried where nothing tells one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Choice {
    /// Different ones.
    Generic,
    /// Zero, which satisfies homogeneous equations.
    Zero,
}

/// Values for the bound names, in order.
fn point(goal: &Goal, choice: Choice) -> Vec<String> {
    let mut integers: BTreeMap<Arc<str>, i64> = BTreeMap::new();
    let mut values = vec![];
    let mut count = 1;
    for binder in &goal.proposition.binders {
        let set = goal.symbols.get(&binder.symbol);
        for _ in &binder.names {
            count += 1;
            let number = match choice {
                Choice::Generic => format!("{count}"),
                Choice::Zero => "0".to_owned(),
            };
            values.push(match set {
                Some(Set::Integer { least, most }) => {
                    let end = |form: &torse_numbers::Affine| {
                        let rest = form
                            .multiples()
                            .map(|(name, multiple)| Some(multiple * integers.get(name)?));
                        Some(rest.sum::<Option<i64>>()? + form.constant())
                    };
                    let value = least.as_ref().and_then(end).or(most.as_ref().and_then(end));
                    let value = value.unwrap_or(3);
                    integers.insert(Arc::clone(&binder.symbol), value);
                    format!("({value})%Z")
                }
                Some(Set::Real(interval)) => match binder.names.first() {
                    Some(name) => {
                        fixed(goal, name).unwrap_or_else(|| within(interval, choice, count))
                    }
                    None => within(interval, choice, count),
                },
                Some(Set::Family { ranges, .. }) => {
                    format!("(fun{} => {number})", " _".repeat(ranges.len().max(1)))
                }
                _ => number,
            });
        }
    }
    values
}

/// The closed number that a premise `name = number` says a symbol is.
fn fixed(goal: &Goal, name: &str) -> Option<String> {
    let premises = goal.proposition.premises.iter();
    let mut values = premises.filter_map(|premise| {
        let (left, right) = premise.text().split_once(" = ")?;
        let words = right.split(|c: char| !c.is_ascii_alphanumeric() && c != '_' && c != '\'');
        let mut names = words.filter(|word| word.starts_with(|c: char| c.is_ascii_alphabetic()));
        (left == name && names.all(|word| word == "PI" || word == "sqrt"))
            .then(|| format!("({right})"))
    });
    values.next()
}

/// A number of an interval.
fn within(interval: &Interval, choice: Choice, count: i64) -> String {
    let end = |bound: &Option<Bound>| bound.as_ref().and_then(|b| b.value.as_rational().cloned());
    let one = rational::integer(1);
    let closed = |bound: &Option<Bound>| bound.as_ref().is_some_and(|b| b.closed);
    let value: Rational = match (end(&interval.lower), end(&interval.upper)) {
        (Some(low), Some(high)) => {
            let third = rational::ratio(1, 3).unwrap_or_default();
            low.clone() + (high - low) * third
        }
        (Some(low), None) if choice == Choice::Zero && closed(&interval.lower) => low,
        (Some(low), None) => low + one,
        (None, Some(high)) => high - one,
        (None, None) if choice == Choice::Zero => rational::integer(0),
        (None, None) => rational::integer(count),
    };
    format!("({})", crate::code::Code::rational(&value).text())
}

/// `exists a, b; `
fn exists(values: &[String]) -> String {
    match values.is_empty() {
        true => String::new(),
        false => format!("exists {}; ", values.join(", ")),
    }
}

/// The script of a refutation: the statement at the witness.
fn refuting(goal: &Goal) -> String {
    let mut arguments = vec![];
    for (binder, fallback) in goal.proposition.binders.iter().zip(first_values(goal)) {
        for place in 0..binder.names.len() {
            arguments.push(value_at(goal, binder, place).unwrap_or_else(|| fallback.clone()));
        }
    }
    format!("refuting (no {})", arguments.join(" "))
}

/// One fallback value a binder.
fn first_values(goal: &Goal) -> Vec<String> {
    let mut values = point(goal, Choice::Zero).into_iter();
    let mut first = vec![];
    for binder in &goal.proposition.binders {
        first.push(values.next().unwrap_or_default());
        for _ in binder.names.iter().skip(1) {
            values.next();
        }
    }
    first
}

/// What the witness says of a bound name: the value of a symbol, or those of the members of a family.
fn value_at(goal: &Goal, binder: &crate::statement::Binder, place: usize) -> Option<String> {
    let symbol = &*binder.symbol;
    let set = goal.symbols.get(&binder.symbol)?;
    let at = |wanted: &str| {
        let found = goal.witness.iter().find(|(name, _)| name == wanted);
        found.map(|(_, value)| rocq_number(value))
    };
    match set {
        Set::Integer { .. } => at(symbol).map(|value| format!("({value})%Z")),
        Set::Real(_) => at(symbol),
        Set::Vector(None) => at(&format!("{symbol}[]")).or_else(|| at(symbol)),
        Set::Vector(Some(_)) => at(&format!("{symbol}[{}]", place + 1)),
        Set::Family { ranges, dimension } => {
            // Members by their indices: `P[0]` and `P[0,1]`, with the coordinate last where there are several.
            let indices = ranges.len().max(1);
            let prefix = format!("{symbol}[");
            let mut cases = vec![];
            for (name, value) in &goal.witness {
                let Some(inner) = name
                    .strip_prefix(&prefix)
                    .and_then(|rest| rest.strip_suffix(']'))
                else {
                    continue;
                };
                let numbers: Vec<&str> = inner
                    .split([',', ']'])
                    .map(|n| n.trim_start_matches('['))
                    .collect();
                let own = dimension.is_none_or(|n| n == 1)
                    || numbers
                        .get(indices)
                        .is_some_and(|n| n.parse() == Ok(place + 1));
                let Some(indices) = numbers.get(..indices).filter(|_| own) else {
                    continue;
                };
                let tests: Vec<String> = indices
                    .iter()
                    .enumerate()
                    .map(|(i, n)| format!("Z.eqb i{i} ({n})"))
                    .collect();
                let test = tests.join(" && ");
                cases.push(format!(
                    "if ({test})%bool then {} else ",
                    rocq_number(value)
                ));
            }
            let bound: String = (0..indices).map(|i| format!(" i{i}")).collect();
            Some(format!("(fun{bound} => {}0)", cases.concat()))
        }
    }
}

/// A value of a witness in Rocq: the notation is the same, save that pi has another name.
fn rocq_number(value: &str) -> String {
    let words = value.split_inclusive(|c: char| !c.is_ascii_alphanumeric());
    let text: String = words
        .map(|word| match word.strip_prefix("pi") {
            Some(rest) if !rest.starts_with(|c: char| c.is_ascii_alphanumeric()) => {
                format!("PI{rest}")
            }
            _ => word.to_owned(),
        })
        .collect();
    format!("({text})")
}
