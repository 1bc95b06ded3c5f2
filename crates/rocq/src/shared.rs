//! Definitions that several statements of a section have in common: they are written once, before the first statement.
//!
//! What a claim's definition says is its text together with the texts of all definitions that it uses. Of the
//! definitions of one name those that say the same in most modules are shared; a module in which the name means
//! something else keeps its own, which hides the shared one.

use crate::task::Goal;
use std::collections::{BTreeMap, BTreeSet};

/// The module of the shared definitions.
pub const DEFINITIONS: &str = "Definitions";

/// A definition that several modules have.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Definition {
    /// Its name.
    pub name: String,
    /// Its text.
    pub text: String,
    /// The shared definitions that stand in it.
    pub uses: Vec<String>,
    /// The literal integers that it is applied to, where its last argument is an integer.
    pub at: BTreeSet<u64>,
}

/// The shared definitions of a section.
#[derive(Debug, Clone, Default)]
pub struct Shared {
    definitions: Vec<Definition>,
    /// What the shared definition of a name says.
    says: BTreeMap<String, String>,
}

/// A definition of one module: its name, its text, the others that it uses, and what it says with them.
struct Own<'g> {
    name: &'g str,
    text: &'g str,
    uses: Vec<&'g str>,
    says: String,
}

/// The definitions of a goal with what they say.
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

/// The names and numbers of a text.
fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_' || c == '\''))
        .filter(|word| !word.is_empty())
}

impl Shared {
    /// What these goals have in common.
    #[must_use]
    pub fn from_goals(goals: &[Goal]) -> Self {
        let modules: Vec<Vec<Own<'_>>> = goals.iter().map(own).collect();
        let mut count: BTreeMap<(&str, &str), usize> = BTreeMap::new();
        for own in modules.iter().flatten() {
            *count.entry((own.name, own.says.as_str())).or_default() += 1;
        }
        let mut shared = Self::default();
        // A name of a symbol is kept free: tactics would give the symbol another one.
        let bound: BTreeSet<&str> = goals
            .iter()
            .flat_map(|goal| &goal.proposition.binders)
            .flat_map(|binder| &binder.names)
            .map(String::as_str)
            .collect();
        // A name is decided when all that any definition of it uses are.
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

    /// Whether all that a definition uses means in its module what the shared names mean.
    fn knows(&self, own: &Own<'_>) -> bool {
        // What it says begins with its text and goes on with what those say that it uses.
        let parts = own.uses.iter().map(|used| self.says.get(*used));
        let parts: Option<Vec<&String>> = parts.collect();
        parts.is_some_and(|parts| {
            let all = parts
                .iter()
                .fold(own.text.to_owned(), |all, part| all + part.as_str());
            all == own.says
        })
    }

    /// Finds the literal integers that stand as last arguments.
    fn applied(&mut self, goals: &[Goal]) {
        for definition in &mut self.definitions {
            for goal in goals {
                let at = literals(goal, &definition.name, &definition.text);
                definition.at.extend(at);
            }
        }
    }

    /// The definitions, in an order in which they need each other.
    #[must_use]
    pub fn definitions(&self) -> &[Definition] {
        &self.definitions
    }

    /// The definitions of a goal that are its own.
    #[must_use]
    pub fn others<'g>(&self, goal: &'g Goal) -> Vec<&'g str> {
        let not_shared = |own: &Own<'_>| self.says.get(own.name) != Some(&own.says);
        let own = own(goal).into_iter().filter(not_shared);
        own.map(|own| own.text).collect()
    }

    /// The module that stands before all statements, and the line by which they use it; nothing where nothing is shared.
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

/// The literal integers that a definition is applied to in a goal, where its last argument is an integer on which a
/// derivative may depend.
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

/// The literal integers that stand behind a name and its other arguments.
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
