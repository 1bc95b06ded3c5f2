//! Values of unknowns from `given` equations, as the proof of the verdict has them, written for Rocq.
//!
//! A script shows that the equations have no other solution, and substitutes the values; so it searches for nothing.

use crate::binder::Binder;
use crate::solutions::Solved;
use crate::task::Goal;
use torse_core::Set;

/// Writes a formula of polynomials in Rocq, with the text that `named` returns for each symbol; none if a symbol has no
/// name.
///
/// `named` gets the name, and the texts of the indices after it.
#[must_use]
pub fn formula(text: &str, named: &dyn Fn(&str, &[&str]) -> Option<String>) -> Option<String> {
    let mut written = String::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        if !first.is_ascii_alphabetic() {
            let end = rest
                .find(|c: char| c.is_ascii_alphabetic())
                .unwrap_or(rest.len());
            let (plain, behind) = rest.split_at(end);
            written.push_str(plain);
            rest = behind;
            continue;
        }
        let letter = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '\'';
        let end = rest.find(|c| !letter(c)).unwrap_or(rest.len());
        let (name, behind) = rest.split_at(end);
        rest = behind;
        if name == "pi" {
            written.push_str("PI");
            continue;
        }
        if behind.starts_with('(') {
            if !["sin", "cos", "sqrt"].contains(&name) {
                return None;
            }
            written.push_str(name);
            written.push(' ');
            continue;
        }
        let mut indices = vec![];
        if let Some(inner) = behind.strip_prefix('[') {
            let (inner, after) = inner.split_once(']')?;
            indices = inner.split(',').map(str::trim).collect();
            rest = after;
        }
        written.push_str(&named(name, &indices)?);
    }
    Some(written)
}

/// Returns the bound name of a symbol, a coordinate or a member with literal indices, as a number.
#[must_use]
pub fn bound(
    binders: &[Binder],
    sets: &dyn Fn(&str) -> Option<Set>,
    name: &str,
    indices: &[&str],
) -> Option<String> {
    let binder = binders.iter().find(|b| &*b.symbol == name)?;
    let place = |text: &str| {
        binder
            .names
            .get(text.parse::<usize>().ok()?.checked_sub(1)?)
    };
    let first = binder.names.first()?;
    match (sets(name)?, indices) {
        (Set::Integer { .. }, []) => Some(format!("IZR {first}")),
        (Set::Real(_) | Set::Vector(None), []) => Some(first.clone()),
        (Set::Vector(Some(_)), [coordinate]) => place(coordinate).cloned(),
        (Set::Family { dimension, ranges }, indices) => {
            let count = ranges.len().max(1);
            let (members, coordinates) = indices.split_at_checked(count)?;
            let function = match (dimension, coordinates) {
                (None | Some(1), []) => first,
                (Some(_), [coordinate]) => place(coordinate)?,
                _ => return None,
            };
            let literal = |index: &&str| index.parse::<i64>().ok();
            let members = members.iter().map(literal).collect::<Option<Vec<_>>>()?;
            let members: String = members.iter().map(|i| format!(" ({i})%Z")).collect();
            Some(format!("({function}{members})"))
        }
        _ => None,
    }
}

/// An unknown with its value in Rocq.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Known {
    /// The unknown as it is declared.
    pub name: String,
    /// The unknown, as a term.
    pub unknown: String,
    /// The numerator.
    pub above: String,
    /// The denominator.
    pub below: String,
}

/// Returns the unknowns of a goal with their values, in the names of its statement; none unless all have values.
#[must_use]
pub fn solved_unknowns(goal: &Goal) -> Option<Vec<Known>> {
    let sets = |name: &str| goal.symbols.get(name).cloned();
    let binders = &goal.proposition.binders;
    let named = |name: &str, indices: &[&str]| bound(binders, &sets, name, indices);
    let mut all = vec![];
    for Solved {
        unknown,
        above,
        below,
    } in &goal.solved
    {
        all.push(Known {
            name: unknown.clone(),
            unknown: formula(unknown, &named)?,
            above: formula(above, &named)?,
            below: formula(below, &named)?,
        });
    }
    (!all.is_empty() && all.len() == goal.proposition.unknowns.len()).then_some(all)
}

/// Returns the value of a solved unknown, with the values that `named` gives to the other symbols.
#[must_use]
pub fn value(
    solved: &[Solved],
    unknown: &str,
    named: &dyn Fn(&str, &[&str]) -> Option<String>,
) -> Option<String> {
    let (place, own) = solved
        .iter()
        .enumerate()
        .find(|(_, s)| s.unknown == unknown)?;
    // A value may contain symbols that were not solved for at that step.
    let later = solved.get(place + 1..).unwrap_or_default();
    let inner = |name: &str, indices: &[&str]| {
        let full = match indices {
            [] => name.to_owned(),
            _ => format!("{name}[{}]", indices.join(",")),
        };
        value(later, &full, named).or_else(|| named(name, indices))
    };
    let (above, below) = (formula(&own.above, &inner)?, formula(&own.below, &inner)?);
    Some(format!("(({above}) / ({below}))"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plain(name: &str, indices: &[&str]) -> Option<String> {
        match (name, indices) {
            ("k", []) => Some("k_".to_owned()),
            ("P", [i]) => Some(format!("(P {i}%Z)")),
            _ => None,
        }
    }

    #[test]
    fn formulas_of_polynomials_are_written_with_the_names_of_the_statement() {
        let text = "-3/2*k^2*P[0] + sin(pi/2*k) - 1";
        let wanted = "-3/2*k_^2*(P 0%Z) + sin (PI/2*k_) - 1";
        assert_eq!(formula(text, &plain).as_deref(), Some(wanted));
    }

    #[test]
    fn what_has_no_name_is_not_written() {
        assert_eq!(formula("k + m", &plain), None);
        assert_eq!(formula("tan(k)", &plain), None);
    }
}
