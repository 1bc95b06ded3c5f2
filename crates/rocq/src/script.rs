//! Proof scripts: which tactic of `Torse.Tactics` proves a goal, and with which numbers.
//!
//! | verdict rests on | emitter | what the tactic does |
//! |---|---|---|
//! | identity | `stage`, `identity` | computes sums, bases and matrices, derivatives and special angles; then `field`, modulo s^2 + c^2 = 1 |
//! | `given` equations | `prepared`, `known` | the same in the equations; the values of the unknowns, which the proof of the verdict has, follow from them and are put in |
//! | the same, without values | `prepared`, `unknown` | the equations are solved for the unknowns one after the other |
//! | induction | `symbolic` | reads a curve of symbolic degree as ((1 - x) + x E)^n of its seeds: end values, recursion, unity |
//! | inequality, enclosure | `ordered` | enclosures of closed numbers by rational arithmetic; linear and polynomial arithmetic |
//! | identity, coefficients of members | `formed` | a coefficient is the difference of two values of its form |
//! | witness | `refuting` | the statement at the witness, which computes to something false |
//! | a denial | `refuting` | the denied statement at values that are different enough |
//! | any of these, with splines | `apart` | integers with few values one after the other, then as above |
//!
//! If that finds no proof, there are [`OTHERS`]: a search tries which script proves a theorem, and the result is
//! stored.
//!
//! Every theorem with premises has a second one, `met`: values at which all premises are true.

use crate::manual_proofs;
use crate::point::{Choice, first_values, point, solved_point, value_at};
use crate::shared::literals;
use crate::solved::{Known, bound, solved_unknowns, value};
use crate::task::{Goal, Role};
use torse_certificate::Evidence;
use torse_core::Set;

/// A theorem with its script.
#[derive(Debug, Clone)]
pub struct Script {
    /// Its name in the module.
    pub name: &'static str,
    /// Its statement.
    pub says: &'static str,
    /// The tactics, without the point at the end.
    pub tactics: String,
}

/// Tactics that are tried if the one for the verdict finds no proof: the conclusion as a combination of the hypotheses,
/// as a consequence of the values that these determine, as a combination with derivatives at numbers in normal form,
/// and each part of the conclusion by a fitting tactic.
pub const OTHERS: [&str; 4] = ["combined", "determined", "at_points", "mixed"];

/// Returns the theorems of a goal with the given script: 0 is the one for the verdict, 1 the first of [`OTHERS`]. None
/// if there is no such script.
#[must_use]
pub fn scripts(goal: &Goal, which: usize) -> Option<Vec<Script>> {
    let Some(place) = which.checked_sub(1) else {
        let mut scripts = first_scripts(goal);
        for script in &mut scripts {
            if let Some(tactics) = manual_proofs::tactics(goal, script.name) {
                script.tactics = tactics;
            }
        }
        return Some(scripts);
    };
    let other = OTHERS.get(place)?;
    let mut scripts = first_scripts(goal);
    let proved = scripts
        .first_mut()
        .filter(|s| s.name == "proved" && !denies(goal))?;
    proved.tactics = match staged(goal, "statement") {
        Some(stages) => format!("{stages}{other}"),
        None => format!("{}; {other}", open(goal, "statement")),
    };
    Some(scripts)
}

/// Unfolds a proposition and all definitions in it.
fn open(goal: &Goal, what: &str) -> String {
    let definitions = goal.proposition.definitions.iter();
    let names: String = definitions.map(|(name, _)| format!(" {name}")).collect();
    format!("cbv beta zeta delta [{what}{names}]")
}

/// Returns the theorems of a goal with the scripts for the verdict.
fn first_scripts(goal: &Goal) -> Vec<Script> {
    let open = |what: &str| open(goal, what);
    let Some(tactic) = emitter(goal) else {
        let start = match staged(goal, "statement").filter(|_| inverts(goal)) {
            Some(stages) => format!("unfold not; {stages}unstaged; intro no"),
            None => format!("intro no; {} in no", open("statement")),
        };
        let tactics = format!("{start}; {}", refuting(goal));
        return vec![Script {
            name: "refuted",
            says: "~ statement",
            tactics,
        }];
    };
    let tactics = match goal.given {
        _ if denies(goal) => {
            let start = match staged(goal, "statement").filter(|_| inverts(goal) || goal.given > 0)
            {
                Some(stages) => format!("{stages}unstaged"),
                None => open("statement"),
            };
            format!("{start}; {}", denied(goal, tactic))
        }
        0 if counts(goal) => format!("{}; apart; {tactic}", open("statement")),
        0 => match staged(goal, "statement").filter(|_| tactic == "identity") {
            Some(stages) => format!("{stages}{tactic}"),
            None => format!("{}; {tactic}", open("statement")),
        },
        _ => {
            let start = match staged(goal, "statement") {
                Some(stages) => stages,
                None => format!("{}; ", open("statement")),
            };
            let (first, last) = given(goal);
            format!("{start}{first}; {last}")
        }
    };
    let mut scripts = vec![Script {
        name: "proved",
        says: "statement",
        tactics,
    }];
    if !goal.proposition.premises.is_empty() {
        let choices = [
            Choice::Generic,
            Choice::Zero,
            Choice::Varied,
            Choice::Same,
            Choice::Axes,
        ];
        let points: Vec<String> = points(goal, &choices)
            .iter()
            .map(|values| format!("({}met)", exists(values)))
            .collect();
        let start = match staged(goal, "instance").filter(|_| inverts(goal) || goal.given > 0) {
            Some(stages) => format!("{stages}unstaged; "),
            None => format!("{}; ", open("instance")),
        };
        let tactics = format!("{start}first [{}]", points.join(" | "));
        scripts.push(Script {
            name: "met",
            says: "instance",
            tactics,
        });
    }
    scripts
}

/// Definitions that are costly to compute at each occurrence.
const SLOW_TACTICS: [&str; 3] = ["Derive", "inverse ", "solve "];

/// Returns the tactics for a statement about unknowns of `given` equations. If the proof of the verdict has their
/// values, the tactics show that the equations have no other solution; otherwise they solve them. The last tactic
/// closes the remaining goals.
fn given(goal: &Goal) -> (String, &'static str) {
    let Some(known) = solved_unknowns(goal) else {
        let unknowns = goal.proposition.unknowns.iter();
        let unknowns = unknowns.map(|unknown| format!("unknown {unknown}; "));
        return (
            format!("prepared; {}put_in", unknowns.collect::<String>()),
            "finished",
        );
    };
    let assertion = |known: &Known| {
        let Known {
            unknown,
            above,
            below,
            ..
        } = known;
        format!("known ({unknown}) ({above}) ({below}); ")
    };
    let values: String = known.iter().map(assertion).collect();
    let functions = functions(goal).unwrap_or_default();
    (
        format!("unstaged; {functions}prepared; {values}put_known"),
        "Solved.concluded",
    )
}

/// Returns the tactics that find the unknowns as functions of a symbol.
fn functions(goal: &Goal) -> Option<String> {
    let sets = |name: &str| goal.symbols.get(name).cloned();
    let binders = &goal.proposition.binders;
    let named = |name: &str, indices: &[&str]| bound(binders, &sets, name, indices);
    let mut text = String::new();
    for along in &goal.proposition.alongs {
        let mut equations = vec![];
        let mut closed = String::new();
        if along.has_members {
            return None;
        }
        for function in &along.functions {
            let value = value(&goal.solved, &function.unknown, &named)?;
            equations.push(format!("{} {} = {value}", function.name, along.variable));
            closed.push_str(&format!("function {}; ", function.name));
        }
        text.push_str(&format!(
            "computed; intros; along (forall {} : R, {}); {closed}",
            along.variable,
            equations.join(" /\\ ")
        ));
    }
    (!text.is_empty()).then(|| format!("{text}conclusion; "))
}

/// Whether matrices are inverted, which is too costly at each use.
fn inverts(goal: &Goal) -> bool {
    let inverted = |text: &str| {
        ["inverse ", "solve "]
            .iter()
            .any(|word| text.contains(word))
    };
    let mut definitions = goal.proposition.definitions.iter();
    definitions.any(|(_, text)| inverted(text))
}

/// Computes the definitions one after the other, and the last one in place; none if nothing in them is costly.
fn staged(goal: &Goal, what: &str) -> Option<String> {
    let definitions = &goal.proposition.definitions;
    let costly = |(_, text): &(String, String)| SLOW_TACTICS.iter().any(|word| text.contains(word));
    let ((last, _), others) = definitions.split_last()?;
    if others.is_empty() || !definitions.iter().any(costly) {
        return None;
    }
    let stage = |(name, text): &(String, String)| {
        let at = literals(goal, name, text);
        let at: Vec<String> = at.iter().map(u64::to_string).collect();
        match at.is_empty() {
            true => format!("stage {name}; "),
            false => format!("stage_at {name} [{}]%Z; ", at.join("; ")),
        }
    };
    let stages = others.iter().map(stage);
    Some(format!(
        "cbv beta zeta delta [{what}]; {}staged_goal {last}; ",
        stages.collect::<String>()
    ))
}

/// Whether a basis has a step that depends on the index: everything computes once integers have values.
fn counts(goal: &Goal) -> bool {
    let mut definitions = goal.proposition.definitions.iter();
    definitions.any(|(_, text)| text.contains("\n  counted "))
}

/// Whether the statement is a denial, which is a claim of its own about the whole domain.
fn denies(goal: &Goal) -> bool {
    goal.proposition.conclusion.text().contains("~ (forall ")
}

/// Returns the script for denials, alone or joined with others: the inner statement fails at a point.
fn denied(goal: &Goal, tactic: &str) -> String {
    let points: Vec<String> = points(goal, &[Choice::Varied, Choice::Generic])
        .iter()
        .map(|values| format!("refuting (no {})", values.join(" ")))
        .collect();
    let (first, others) = match goal.given {
        0 => ("intros".to_owned(), tactic),
        _ => given(goal),
    };
    format!(
        "{first}; conjuncts; first [ intro no; first [ {} ] | {others} ]",
        points.join(" | ")
    )
}

/// Returns points to try, with the values of the unknowns if the proof of the verdict has them.
fn points(goal: &Goal, choices: &[Choice]) -> Vec<Vec<String>> {
    let solved = choices.iter().map(|choice| solved_point(goal, *choice));
    match solved.collect::<Option<Vec<_>>>() {
        Some(points) => points,
        None if goal.proposition.alongs.is_empty() => {
            choices.iter().map(|choice| point(goal, *choice)).collect()
        }
        None => vec![],
    }
}

/// Returns the tactic that proves a statement; none for a refutation.
fn emitter(goal: &Goal) -> Option<&'static str> {
    let integers = goal
        .symbols
        .values()
        .any(|set| matches!(set, Set::Integer { .. }));
    let text = |word: &str| {
        let texts = goal.proposition.definitions.iter().map(|(_, text)| text);
        let conclusion = goal.proposition.conclusion.text();
        conclusion.contains(word) || texts.into_iter().any(|text| text.contains(word))
    };
    match (goal.role, goal.evidence) {
        (Role::Refuted, _) => None,
        _ if text("update1 ") || text("update2 ") => Some("formed"),
        (_, Evidence::Inequality | Evidence::Enclosure) => Some("ordered"),
        (_, Evidence::Induction) => Some("symbolic"),
        _ if counts(goal) => Some("identity"),
        _ if integers => Some("symbolic"),
        _ => Some("identity"),
    }
}

/// Writes the module of proofs of a goal, with these scripts.
#[must_use]
pub fn module(folder: &str, section: &str, goal: &Goal, scripts: &[Script]) -> String {
    let module = &goal.module;
    let mut text = format!("\nModule {module}.\nImport {folder}.{section}.{module}.\n");
    for Script {
        name,
        says,
        tactics,
    } in scripts
    {
        text.push_str(&format!(
            "Theorem {name} : {says}.\nProof. {tactics}. Qed.\n"
        ));
    }
    text.push_str(&format!("End {module}.\n"));
    text
}

/// `exists a, b; `
fn exists(values: &[String]) -> String {
    match values.is_empty() {
        true => String::new(),
        false => format!("exists {}; ", values.join(", ")),
    }
}

/// Writes the script of a refutation: the statement at the witness.
fn refuting(goal: &Goal) -> String {
    let mut arguments = vec![];
    for (binder, fallback) in goal.proposition.binders.iter().zip(first_values(goal)) {
        for place in 0..binder.names.len() {
            arguments.push(value_at(goal, binder, place).unwrap_or_else(|| fallback.clone()));
        }
    }
    format!("refuting (no {})", arguments.join(" "))
}
