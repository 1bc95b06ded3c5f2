//! A single statement with a one-line setting, read as a paper of one claim, for users without a folder of
//! derivations.
//!
//! The setting is a list with semicolons or commas between its entries; a comma inside brackets or behind bare names
//! (`x, y in [0, 1]`) is part of an entry:
//!
//! | entry | meaning |
//! |---|---|
//! | `x in [0, 1]`, `a, b in (0, inf)` | symbols with their interval |
//! | `n in 0..`, `i in 0..n`, `k in ..5` | integers |
//! | `p: vector 3`, `f: function 1` | vectors, smooth functions |
//! | `H(t) := t^2 + 1` | a definition |
//! | `x >= 0`, `a^2 + b^2 == 1` | a hypothesis |
//!
//! An undeclared name is a real number.

use super::definitions::name_of;
use super::error::LoadError;
use super::load::paper;
use super::paper::Paper;
use super::source::{Copied, SETTING, STATEMENT, Source};
use crate::formula::functions::infinite;
use crate::formula::{Expr, Node, Place, parse};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::sync::Arc;

/// Makes a paper whose only claim, `question/1`, states `states` in this setting.
///
/// # Errors
/// The first mistake, at its place in the statement or the setting.
///
/// ```
/// let paper = torse_syntax::derivation::question("x + y >= x", "x, y in [0, 1]")?;
/// assert_eq!(paper.claims[0].entry.id.get_ref(), "question/1");
/// # Ok::<(), torse_syntax::derivation::LoadError>(())
/// ```
pub fn question(states: &str, setting: &str) -> Result<Paper, LoadError> {
    let statement = Arc::new(Source::new(STATEMENT, states));
    let setting = Arc::new(Source::new(SETTING, setting));
    let (states, setting) = (Typed::all(&statement), Setting::read(Typed::all(&setting)));

    let mut head = Composed::default();
    head.add("[paper]\nid = 'question'\ntitle = ''\nauthors = ''\nvenue = ''\nclaims = ['claim.toml']\n[symbols]\n");
    for (name, set) in &setting.symbols {
        head.quote(name);
        head.add(" = ");
        head.set(set);
    }
    for (name, first) in setting.undeclared(&states) {
        head.copy(&first, &quoted(&name));
        head.add(" = {}\n");
    }
    head.add("[define]\n");
    for (defined, body) in &setting.definitions {
        head.quote(defined);
        head.add(" = ");
        head.quote(body);
        head.add("\n");
    }
    let mut claim = Composed::default();
    claim.add("[[claim]]\nid = 'question/1'\nat = ''\nkind = 'identity'\nprinted = ");
    claim.quote(&states);
    claim.add("\nstates = ");
    claim.quote(&states);
    claim.add("\nassume = [");
    for hypothesis in &setting.hypotheses {
        claim.quote(hypothesis);
        claim.add(", ");
    }
    claim.add("]\n");

    let (head, claim) = (head.source(&states), claim.source(&states));
    paper(|name| match name {
        "paper.toml" => Ok(Arc::clone(&head)),
        _ => Ok(Arc::clone(&claim)),
    })
}

/// Returns the names that a statement and its setting use as numbers and that the setting does not declare, in alphabetical
/// order: [`question`] takes each for a real number. What cannot be read has none.
///
/// ```
/// use torse_syntax::derivation::undeclared_names;
/// assert_eq!(undeclared_names("a*x^2 + b >= 0", "x in [0, 1]; b > c"), ["a", "b", "c"]);
/// ```
#[must_use]
pub fn undeclared_names(states: &str, setting: &str) -> Vec<String> {
    let [states, setting] = [states, setting].map(|text| Arc::new(Source::new("", text)));
    let used = Setting::read(Typed::all(&setting)).undeclared(&Typed::all(&states));
    used.into_keys().collect()
}

/// A part of the statement or of the setting, as it was typed.
#[derive(Clone, Copy)]
struct Typed<'t> {
    source: &'t Arc<Source>,
    start: usize,
    text: &'t str,
}

impl<'t> Typed<'t> {
    fn all(source: &'t Arc<Source>) -> Self {
        Self {
            source,
            start: 0,
            text: &source.text,
        }
    }

    /// The bytes from `start` to `end`; nothing if these are no characters.
    fn part(self, start: usize, end: usize) -> Self {
        Self {
            source: self.source,
            start: self.start + start,
            text: self.text.get(start..end).unwrap_or(""),
        }
    }

    fn trim(self) -> Self {
        let end = self.text.trim_end().len();
        let start = end - self.text.trim().len();
        self.part(start, end)
    }

    fn split(self, separator: char) -> impl Iterator<Item = Self> {
        let mut start = 0;
        self.text.split(separator).map(move |text| {
            let part = self.part(start, start + text.len());
            start += text.len() + separator.len_utf8();
            part.trim()
        })
    }

    /// The entries of a setting: what stands between semicolons, and between commas outside of brackets that do not
    /// follow bare names.
    fn entries(self) -> Vec<Self> {
        let mut entries = vec![];
        let (mut start, mut depth) = (0, 0_usize);
        for (at, letter) in self.text.char_indices() {
            let before = self.part(start, at);
            match letter {
                '(' | '[' => depth += 1,
                ')' | ']' => depth = depth.saturating_sub(1),
                ',' if depth > 0 || before.split(',').all(Self::is_name) => {}
                ';' | ',' => {
                    entries.push(before.trim());
                    (start, depth) = (at + 1, 0);
                }
                _ => {}
            }
        }
        entries.push(self.part(start, self.text.len()).trim());
        entries.retain(|entry| !entry.text.is_empty());
        entries
    }

    fn is_name(self) -> bool {
        let mut letters = self.text.chars();
        letters.next().is_some_and(char::is_alphabetic)
            && letters.all(|c| c.is_alphanumeric() || c == '_')
    }

    fn split_once(self, sign: &str) -> Option<(Self, Self)> {
        let at = self.text.find(sign)?;
        let before = self.part(0, at);
        let after = self.part(at + sign.len(), self.text.len());
        Some((before.trim(), after.trim()))
    }

    fn place(self) -> Place {
        Place {
            start: self.start,
            end: self.start + self.text.len(),
        }
    }
}

/// The text of a file that is composed of what was typed.
#[derive(Default)]
struct Composed {
    text: String,
    copies: Vec<Copied>,
}

impl Composed {
    fn add(&mut self, text: &str) {
        self.text.push_str(text);
    }

    /// Adds a text of which errors are shown at `typed`.
    fn copy(&mut self, typed: &Typed<'_>, text: &str) {
        let start = self.text.len();
        self.add(text);
        self.copies.push(Copied {
            range: start..self.text.len(),
            source: Arc::clone(typed.source),
            place: typed.place(),
            is_verbatim: false,
        });
    }

    /// Adds what was typed as a string of TOML.
    fn quote(&mut self, typed: &Typed<'_>) {
        self.copy(typed, &quoted(typed.text));
        if let Some(copied) = self.copies.last_mut() {
            copied.is_verbatim = true;
        }
    }

    /// Adds the declaration of a symbol with this set.
    fn set(&mut self, set: &Typed<'_>) {
        let dimension = |count: &str| {
            let number = count.trim().parse::<i64>();
            number.map_or_else(|_| quoted(count.trim()), |number| number.to_string())
        };
        let (key, value) = if let Some(count) = set.text.strip_prefix("vector ") {
            ("vector", dimension(count))
        } else if let Some(count) = set.text.strip_prefix("function ") {
            ("function", dimension(count))
        } else if let (false, Some((low, high))) =
            (set.text.starts_with(['[', '(']), set.text.split_once(".."))
        {
            let range = match (low.trim(), high.trim()) {
                (low, "") if !low.is_empty() => format!(">= {low}"),
                ("", high) if !high.is_empty() => format!("<= {high}"),
                (low, high) => format!("{low}..{high}"),
            };
            ("integer", quoted(&range))
        } else {
            self.add("{ in = ");
            self.quote(set);
            self.add(" }\n");
            return;
        };
        self.add(&format!("{{ {key} = "));
        self.copy(set, &value);
        self.add(" }\n");
    }

    /// The file; errors about nothing that was typed are shown at the whole statement.
    fn source(mut self, statement: &Typed<'_>) -> Arc<Source> {
        self.copies.push(Copied {
            range: 0..self.text.len(),
            source: Arc::clone(statement.source),
            place: statement.place(),
            is_verbatim: false,
        });
        Arc::new(Source::composed("the question", self.text, self.copies))
    }
}

/// A text as a basic string of TOML.
fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for letter in text.chars() {
        match letter {
            '"' | '\\' => quoted.extend(['\\', letter]),
            // A string takes all that is written.
            _ if letter.is_control() => drop(write!(quoted, "\\u{:04X}", u32::from(letter))),
            _ => quoted.push(letter),
        }
    }
    quoted.push('"');
    quoted
}

/// The declarations and hypotheses of a setting.
#[derive(Default)]
struct Setting<'t> {
    symbols: Vec<(Typed<'t>, Typed<'t>)>,
    definitions: Vec<(Typed<'t>, Typed<'t>)>,
    hypotheses: Vec<Typed<'t>>,
}

impl<'t> Setting<'t> {
    /// Reads the entries. An entry that is not a declaration is taken for a hypothesis, whose syntax is checked
    /// later.
    fn read(setting: Typed<'t>) -> Self {
        let mut read = Self::default();
        for entry in setting.entries() {
            if let Some(definition) = entry.split_once(":=") {
                read.definitions.push(definition);
            } else if let Some((names, set)) = declared(entry, " in ").or(declared(entry, ":")) {
                read.symbols.extend(names.map(|name| (name, set)));
            } else {
                read.hypotheses.push(entry);
            }
        }
        read
    }

    /// The undeclared names that the statement and the setting use as numbers, in alphabetical order, each where it is used
    /// first.
    fn undeclared(&self, states: &Typed<'t>) -> BTreeMap<String, Typed<'t>> {
        let bodies = self.definitions.iter();
        let bodies = bodies.map(|(head, body)| (parameters(head.text), *body));
        let hypotheses = self.hypotheses.iter().map(|formula| (vec![], *formula));
        // The bounds of declared sets may contain symbols too.
        let ends = self.symbols.iter().flat_map(|(_, set)| ends(*set));
        let ends = ends.map(|end| (vec![], end));
        let formulas = std::iter::once((vec![], *states));
        let mut used = BTreeMap::new();
        for (bound, typed) in formulas.chain(bodies).chain(hypotheses).chain(ends) {
            if let Ok(formula) = parse(typed.text) {
                free_numbers(&formula, &bound, &mut |name, place| {
                    let first = typed.part(place.start, place.end);
                    used.entry(name.to_owned()).or_insert(first);
                });
            }
        }
        let heads = self.definitions.iter().map(|(head, _)| name_of(head.text));
        let names = self.symbols.iter().map(|(name, _)| name.text.to_owned());
        let declared: BTreeSet<String> = heads.chain(names).collect();
        used.retain(|name, _| !declared.contains(name) && infinite(name).is_none());
        used
    }
}

/// The parts of a set between its brackets, dots, commas and signs.
fn ends(set: Typed<'_>) -> impl Iterator<Item = Typed<'_>> {
    let mut start = 0;
    let signs = ['[', ']', '(', ')', ',', '.', '<', '>', '='];
    set.text.split(signs).map(move |text| {
        let end = set.part(start, start + text.len());
        // Each sign is one byte.
        start += text.len() + 1;
        end
    })
}

/// The names before the sign and the set after it, if all of them are names.
fn declared<'t>(
    entry: Typed<'t>,
    sign: &str,
) -> Option<(impl Iterator<Item = Typed<'t>>, Typed<'t>)> {
    let (names, set) = entry.split_once(sign)?;
    let is_declaration = names.split(',').all(Typed::is_name);
    is_declaration.then(|| (names.split(','), set))
}

/// The parameters of a head `H(t)`.
fn parameters(head: &str) -> Vec<String> {
    let Some((_, rest)) = head.split_once(['(', '[']) else {
        return vec![];
    };
    let names = rest.trim_end_matches([')', ']']).split(',');
    names.map(|name| name.trim().to_owned()).collect()
}

/// Collects the names that stand for numbers, except the bound variables of sums and products, and functions that are
/// applied. The variable of an integral is a declared symbol, like that of a derivative.
fn free_numbers(formula: &Expr, bound: &[String], found: &mut dyn FnMut(&str, Place)) {
    match &formula.node {
        Node::Name(name) => {
            let name = name.trim_end_matches('\'');
            if name != "pi" && !bound.iter().any(|other| other == name) {
                found(name, formula.place);
            }
        }
        Node::Call(head, arguments) => {
            let called = match &head.node {
                Node::Name(name) => name.as_str(),
                _ => {
                    free_numbers(head, bound, found);
                    ""
                }
            };
            let binder = match called {
                "sum" | "product" => arguments.first(),
                _ => None,
            };
            let mut inner = bound.to_vec();
            if let Some(Node::Name(index)) = binder.map(|index| &index.node) {
                inner.push(index.clone());
            }
            for argument in arguments {
                free_numbers(argument, &inner, found);
            }
        }
        Node::Index(indexed, indices) => {
            // The name of a family or a vector is declared.
            if !matches!(indexed.node, Node::Name(_)) {
                free_numbers(indexed, bound, found);
            }
            for index in indices {
                free_numbers(index, bound, found);
            }
        }
        _ => {
            for part in formula.parts() {
                free_numbers(part, bound, found);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use miette::Diagnostic;

    fn names(states: &str, setting: &str) -> Vec<String> {
        undeclared_names(states, setting)
    }

    #[test]
    fn what_is_used_as_a_number_and_not_declared_is_a_number() {
        assert_eq!(names("sin(x)^2 + cos(x)^2 == 1", ""), ["x"]);
        assert_eq!(names("sum(i, 0, n, q^i) == 1", "n in 0.."), ["q"]);
        assert_eq!(names("transpose([[a, b]])[2, 1] == p[1]", ""), ["a", "b"]);
        assert_eq!(names("H(1) == a", "H(t) := t*b"), ["a", "b"]);
        // What is used first in brackets is declared without them.
        assert!(question("(x)/(3) == ((y))", "").is_ok());
        assert_eq!(
            names("integral(t^2, t, 0, c) == pi", "x in [a, 1]; y > 0"),
            ["a", "c", "t", "y"]
        );
    }

    #[test]
    fn a_setting_declares_sets_functions_and_hypotheses() {
        let paper = question(
            "D(f(x), x) == D(f(x), x) and n >= 0",
            "x in [0, 1]; n in 0..; f: function 1; p, q: vector 3; x > 1/2",
        );
        let claim = &paper.unwrap().claims[0];
        assert_eq!(claim.assumptions.len(), 1);
        for name in ["x", "n", "p", "q"] {
            assert!(claim.declarations.symbol(name).is_some(), "{name}");
        }
    }

    #[test]
    fn commas_outside_of_brackets_separate_entries_but_for_those_behind_names() {
        let paper = question(
            "x + y + f(z) + n == m",
            "x, y in (0, inf), n, m in 0.., f: function 1, H(s, t) := s*t, z > 0, x*(y + 1) == 2; a >= 0,",
        );
        let claim = &paper.unwrap().claims[0];
        assert_eq!(claim.assumptions.len(), 3);
        for name in ["x", "y", "n", "m"] {
            assert!(claim.declarations.symbol(name).is_some(), "{name}");
        }
    }

    #[test]
    fn what_is_wrong_is_an_error_with_its_place_in_what_was_typed() {
        for (states, setting, wrong, line, column) in [
            ("x ==", "", "the statement", 1, 5),
            ("", "", "the statement", 1, 1),
            ("x == 1 +\n\"", "", "the statement", 2, 1),
            ("x == 1", "x in somewhere", "the setting", 1, 6),
            ("x == 1", "n in 0..; y >", "the setting", 1, 14),
            ("x == 1", "n in 0..1/2; a > 0", "the setting", 1, 6),
            ("x == 1", "x: vector 3000", "the setting", 1, 4),
            ("x == 1", "x in [0, 1], y >", "the setting", 1, 17),
            ("x == 1", "ä in [0, 1];\nx := x + *", "the setting", 2, 10),
            ("x == 1", "x in [0, 1]; x in [2, 3]", "the setting", 1, 14),
            ("x == 1", "H(t) := t; H(t) := 2*t", "the setting", 1, 12),
            ("\"", "x := ;", "the setting", 1, 5),
        ] {
            let error = question(states, setting).expect_err(states);
            let (source, labels) = (error.source_code(), error.labels());
            let label = labels.and_then(|mut labels| labels.next()).unwrap();
            let read = source.unwrap().read_span(label.inner(), 0, 0).unwrap();
            let place = (read.name(), read.line() + 1, read.column() + 1);
            assert_eq!(
                place,
                (Some(wrong), line, column),
                "{states} | {setting}: {error}"
            );
        }
    }
}
