//! The one change of a program after which it equals the print.
//!
//! A change is made where the program is written, not in the formula that it computes: in the body of a loop it shows in each
//! turn. Each changed program is run again on symbols.

use super::comparison::{CodeEdit, line};
use super::render::{Rewritten, rewritten};
use crate::program::{Function, Part, Program, Replaced, Step, Target, formulas};
use crate::run::{self, Obligation, setting::Setting};
use std::collections::BTreeSet;
use torse_syntax::derivation::{Claim, Written};
use torse_syntax::formula::{Expr, Node};
use torse_verdicts::repair::one_side::{edits_of_code, replace_side};

/// The most changed programs that are run, and the most steps of all runs.
const MAX_EDITS: usize = 8_000;
const MAX_ALL_STEPS: usize = 30_000_000;

/// Searches the change; returns it, and whether the work was used up before all changes were tried.
pub(super) fn search(
    claim: &Claim,
    statement: &Written,
    program: &Program,
    function: &Function,
    setting: Setting<'_>,
    shown_before: &[Obligation],
) -> (Option<CodeEdit>, bool) {
    let mut all = vec![];
    for name in called(program, function) {
        let Some(steps) = program
            .function(&name)
            .and_then(|own| own.body.as_ref().ok())
        else {
            continue;
        };
        let (names, lists) = variables(program, &name, steps);
        for (position, part) in formulas(steps).into_iter().enumerate() {
            let edits = edits_of_code(part.expr, &names, &lists);
            all.extend(
                edits
                    .into_iter()
                    .map(|edit| (name.clone(), position, part, edit)),
            );
        }
    }
    all.sort_by_key(|(_, _, _, edit)| edit.change.is_factor_inserted());
    let mut ended_early = all.len() > MAX_EDITS;
    let mut steps = 0;
    let candidates = all
        .into_iter()
        .take(MAX_EDITS)
        .filter_map(|(name, position, part, edit)| {
            if steps > MAX_ALL_STEPS {
                ended_early = true;
                return None;
            }
            let changed = with(program, &name, position, &edit.expr);
            let own = changed.function(&function.name)?;
            let (value, taken) = run::counted(&changed, own, setting);
            steps += taken;
            let change: (Part<'_>, Expr) = (part, edit.expr);
            let computed = value.ok()?;
            // A change is proposed only if it asks for nothing that is not shown already.
            let is_shown = |own: &Obligation| {
                let mut before = shown_before.iter();
                before.any(|other| other.condition == own.condition)
            };
            let is_real = computed.obligations.iter().all(is_shown);
            is_real.then_some((computed.formula, change))
        });
    let search = replace_side(claim, statement, 0, candidates);
    let found = search.found.and_then(|found| {
        let (part, expr) = found.change;
        let rewritten = rewritten(program, part, &expr)?;
        let conditions = found.conditions.iter().map(|c| c.text.clone()).collect();
        Some(shown(program, rewritten, conditions, found.is_unique))
    });
    (found, ended_early || search.ended_early)
}

/// A change with the line on which it stands.
fn shown(
    program: &Program,
    change: Rewritten,
    conditions: Vec<String>,
    is_unique: bool,
) -> CodeEdit {
    let text = &program.source.text;
    let (number, column, now) = line(text, change.place.start);
    let start = change.place.start
        - now
            .char_indices()
            .nth(column - 1)
            .map_or(0, |(byte, _)| byte);
    let inside = |byte: usize| now.get(..byte.checked_sub(start)?);
    let before = inside(change.place.start);
    let after = change
        .place
        .end
        .checked_sub(start)
        .and_then(|end| now.get(end..));
    let line_then = before
        .zip(after)
        .map(|(before, after)| format!("{before}{}{after}", change.text));
    let written = text.get(change.place.start..change.place.end).unwrap_or("");
    CodeEdit {
        line: number,
        column,
        length: written.chars().count(),
        written: written.to_owned(),
        replacement: change.text,
        line_now: now.to_owned(),
        line_then,
        conditions,
        is_unique,
    }
}

/// A program with one formula of a function replaced.
fn with(program: &Program, name: &str, position: usize, by: &Expr) -> Program {
    let mut changed = program.clone();
    let mut functions = changed.functions.iter_mut().rev();
    if let Some(function) = functions.find(|function| function.name == name)
        && let Ok(body) = &mut function.body
    {
        *body = Replaced::new(position, by).steps(body);
    }
    changed
}

/// The functions that a function calls, itself first.
fn called(program: &Program, function: &Function) -> Vec<String> {
    let mut found = vec![function.name.clone()];
    let mut next = 0;
    while let Some(name) = found.get(next).cloned() {
        next += 1;
        let body = program
            .function(&name)
            .and_then(|own| own.body.as_ref().ok());
        for part in formulas(body.map_or(&[], Vec::as_slice)) {
            for name in part.expr.names() {
                let is_own = program.function(name).is_some();
                if is_own && !found.iter().any(|other| other == name) {
                    found.push(name.to_owned());
                }
            }
        }
    }
    found
}

/// The names of a function's numbers, and those of its lists.
fn variables(program: &Program, name: &str, steps: &[Step]) -> (Vec<String>, Vec<String>) {
    let mut names = BTreeSet::new();
    let mut lists = BTreeSet::new();
    if let Some(function) = program.function(name) {
        names.extend(
            function
                .parameters
                .iter()
                .map(|parameter| parameter.name.clone()),
        );
    }
    targets(steps, &mut names);
    for part in formulas(steps) {
        indexed(part.expr, &mut lists);
    }
    let names = names.into_iter().filter(|name| !lists.contains(name));
    (names.collect(), lists.iter().cloned().collect())
}

fn targets(steps: &[Step], into: &mut BTreeSet<String>) {
    fn names(target: &Target, into: &mut BTreeSet<String>) {
        match target {
            Target::Name(name, _) => drop(into.insert(name.clone())),
            Target::Entry(..) => {}
            Target::Several(all, _) => all.iter().for_each(|one| names(one, into)),
        }
    }
    for step in steps {
        match step {
            Step::Assign { target, .. } => names(target, into),
            Step::Repeat { variable, body, .. } => {
                names(variable, into);
                targets(body, into);
            }
            Step::Branch {
                then, otherwise, ..
            } => {
                targets(then, into);
                targets(otherwise, into);
            }
            Step::Return(_) | Step::Stop(_) | Step::Assert { .. } => {}
        }
    }
}

/// The names that have entries.
fn indexed(expr: &Expr, into: &mut BTreeSet<String>) {
    if let Node::Index(head, _) = &expr.node
        && let Node::Name(name) = &head.node
    {
        into.insert(name.clone());
    }
    expr.parts()
        .into_iter()
        .for_each(|part| indexed(part, into));
}
