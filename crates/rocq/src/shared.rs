//! Definitions shared by several statements of a section: they are written once, before the first statement.
//!
//! Two definitions are equal if their texts and those of all definitions that they use are. Of the definitions of one
//! name, the form that most modules use is shared; a module in which the name means something else keeps its own, which
//! hides the shared one.

use crate::task::Goal;
use std::collections::{BTreeMap, BTreeSet};

/// The module of the shared definitions.
pub const DEFINITIONS: &str = "Definitions";

/// A definition in several modules.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Definition {
    /// Its name.
    pub name: String,
    /// Its text.
    pub text: String,
    /// The shared definitions that occur in it.
    pub uses: Vec<String>,
    /// The literal integers that it is applied to, where its last argument is an integer.
    pub at: BTreeSet<u64>,
}

/// The shared definitions of a section.
#[derive(Debug, Clone, Default)]
pub struct Shared {
    definitions: Vec<Definition>,
    /// Returns the expanded text of the shared definition of a name.
    says: BTreeMap<String, String>,
}

/// A definition of one module: its name, its text, the others that it uses, and its expanded text.
struct Own<'g> {
    name: &'g str,
    text: &'g str,
    uses: Vec<&'g str>,
    says: String,
}

/// Returns the definitions of a goal with their expanded texts.
fn own(goal: &Goal) -> Vec<Own<'_>> {
    let mut all: Vec<Own<'_>> = vec![];
    for (name, text) in &goal.proposition.definitions {
        let used: Vec<&Own<'_>> = all
            .iter()
            .filter(|other| words(text).any(|word| word == other.name))
            .collect();
        let uses = used.iter().map(|other| other.name).collect();
        let parts = used.iter().map(|other| other.says.as_str());
        let says = parts.fold(text.clone(), |all, part| all + part);
        all.push(Own {
            name,
            text,
            uses,
            says,
        });
    }
    all
}

/// Returns the names and numbers of a text.
pub(crate) fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_' || c == '\''))
        .filter(|word| !word.is_empty())
}

impl Shared {
    /// Finds the definitions that these goals share.
    #[must_use]
    pub fn from_goals(goals: &[Goal]) -> Self {
        let modules: Vec<Vec<Own<'_>>> = goals.iter().map(own).collect();
        let mut count: BTreeMap<(&str, &str), usize> = BTreeMap::new();
        for own in modules.iter().flatten() {
            *count.entry((own.name, own.says.as_str())).or_default() += 1;
        }
        let mut shared = Self::default();
        // The name of a symbol is kept free: tactics would rename the symbol.
        let bound: BTreeSet<&str> = goals
            .iter()
            .flat_map(|goal| &goal.proposition.binders)
            .flat_map(|binder| &binder.names)
            .map(String::as_str)
            .collect();
        // A name is decided after all names that its definitions use.
        let mut decided: BTreeSet<&str> = BTreeSet::new();
        loop {
            let left = || {
                modules
                    .iter()
                    .flatten()
                    .filter(|own| !decided.contains(own.name))
            };
            let ready = |name: &str| {
                let mut uses = left()
                    .filter(|own| own.name == name)
                    .flat_map(|own| &own.uses);
                uses.all(|used| *used == name || decided.contains(used))
            };
            let Some(name) = left().map(|own| own.name).find(|name| ready(name)) else {
                break;
            };
            let best = left()
                .filter(|own| own.name == name && !bound.contains(name) && shared.knows(own))
                .filter_map(|own| {
                    let times = count.get(&(own.name, own.says.as_str())).copied()?;
                    (times > 1).then_some((times, own))
                })
                .reduce(|best, next| if next.0 > best.0 { next } else { best });
            if let Some((_, own)) = best {
                let uses = own.uses.iter().map(|used| (*used).to_owned()).collect();
                shared.says.insert(name.to_owned(), own.says.clone());
                shared.definitions.push(Definition {
                    name: name.to_owned(),
                    text: own.text.to_owned(),
                    uses,
                    at: BTreeSet::new(),
                });
            }
            decided.insert(name);
        }
        shared.applied(goals);
        shared
    }

    /// Whether every definition that a definition uses means in its module what the shared one means.
    fn knows(&self, own: &Own<'_>) -> bool {
        // An expanded text begins with the text and continues with the expanded texts of the definitions used.
        let parts = own.uses.iter().map(|used| self.says.get(*used));
        let parts: Option<Vec<&String>> = parts.collect();
        parts.is_some_and(|parts| {
            let all = parts
                .iter()
                .fold(own.text.to_owned(), |all, part| all + part.as_str());
            all == own.says
        })
    }

    /// Finds the literal integers that occur as last arguments.
    fn applied(&mut self, goals: &[Goal]) {
        for definition in &mut self.definitions {
            for goal in goals {
                let at = literals(goal, &definition.name, &definition.text);
                definition.at.extend(at);
            }
        }
    }

    /// Returns the definitions in an order of their dependencies.
    #[must_use]
    pub fn definitions(&self) -> &[Definition] {
        &self.definitions
    }

    /// Returns the definitions that only this goal has.
    #[must_use]
    pub fn others<'g>(&self, goal: &'g Goal) -> Vec<&'g str> {
        let not_shared = |own: &Own<'_>| self.says.get(own.name) != Some(&own.says);
        let own = own(goal).into_iter().filter(not_shared);
        own.map(|own| own.text).collect()
    }

    /// Returns the module before all statements, and the line by which they use it; none if nothing is shared.
    #[must_use]
    pub fn module(&self) -> String {
        if self.definitions.is_empty() {
            return String::new();
        }
        let texts = self.definitions.iter().map(|d| format!("{}\n", d.text));
        format!(
            "\nModule {DEFINITIONS}.\n{}End {DEFINITIONS}.\nImport {DEFINITIONS}.\n",
            texts.collect::<String>()
        )
    }
}

/// Returns the literal integers that a definition is applied to in a goal, if its last argument is an integer on which
/// a derivative may depend.
#[must_use]
pub fn literals(goal: &Goal, name: &str, text: &str) -> BTreeSet<u64> {
    let head = text.lines().next().unwrap_or("");
    if !head.contains(" : Z) : ") || !text.contains("Derive") {
        return BTreeSet::new();
    }
    let arguments = head.matches(" (").count();
    let own = goal.proposition.definitions.iter().map(|(_, text)| text);
    let statement = goal.proposition.universal();
    let texts = own.chain([&statement]);
    texts
        .flat_map(|text| last_arguments(text, name, arguments))
        .collect()
}

/// Returns the literal integers after a name and its other arguments.
fn last_arguments(text: &str, name: &str, arguments: usize) -> Vec<u64> {
    let mut found = vec![];
    for (place, _) in text.match_indices(name) {
        let (before, rest) = (text.get(..place), text.get(place + name.len()..));
        let letter = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '\'';
        if before.is_some_and(|before| before.ends_with(letter)) {
            continue;
        }
        let mut words = rest.unwrap_or("").split(' ');
        let first = words.next();
        let last = words.nth(arguments.saturating_sub(1)).and_then(|word| {
            let (digits, behind) = word.split_once("%Z")?;
            let ends = !behind.starts_with(letter);
            digits.parse().ok().filter(|_| ends)
        });
        if let (Some(""), Some(number)) = (first, last) {
            found.push(number);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn literal_last_arguments_are_found() {
        let text = "[part A k 5%Z; part A k 3%Z] = apart A k 2%Z + part A k n + part A 4%Z";
        assert_eq!(last_arguments(text, "part", 3), [5, 3]);
    }
}
