//! What the formulas of a manuscript say: definitions, ranges of symbols, and statements.
//!
//! The first formula `f(t) = ...`, `Q_i = ...` or `c = ...` whose left side is a name that no formula before it has, and that its right side
//! does not have, is taken for the definition of that name; in a chain, by the first two sides. A formula that only bounds a name by
//! numbers, or in prose by letters, gives its range; other declarations are those of `declared`. What a theorem says of a range is
//! its own, except that of an index of which the text says nothing else.

mod declares;

use crate::declared::{Declared, Space, declared};
use crate::document::{Manuscript, ManuscriptFormula};
use std::collections::{BTreeMap, BTreeSet};
use torse_syntax::formula::functions::is_function;
use torse_syntax::formula::{Connective, Expr, Node, Place, Relation};
use torse_syntax::latex::item::TexItem;
use torse_syntax::latex::{
    LatexCondition, LatexDoubt, LatexGuess, LatexKind, LatexNames, LatexStatement, read_items,
};
use torse_syntax::notation::text;

/// The largest number of formulas that are read.
pub const MAX_FORMULAS: usize = 5_000;

/// A formula or a part of the text that is not understood.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unread {
    /// Its line, from 1.
    pub line: usize,
    /// Its column, from 1.
    pub column: usize,
    /// Why it is not understood.
    pub why: String,
    /// The formula, or a part of the text.
    pub print: String,
}

/// What one formula says.
#[derive(Debug, Clone)]
pub enum Meaning {
    /// A definition, with what else the formula states.
    Defines {
        /// The names that it defines.
        names: Vec<String>,
        /// What else it states.
        states: Option<Expr>,
        /// Its conditions.
        conditions: Vec<LatexCondition>,
    },
    /// A statement with its conditions.
    States {
        /// The statement.
        formula: Expr,
        /// Its conditions.
        conditions: Vec<LatexCondition>,
    },
    /// Several readings.
    Ambiguous {
        /// The first one.
        first: LatexStatement,
        /// The others.
        others: Vec<(LatexDoubt, LatexStatement)>,
    },
    /// The range of a name, or a formula without a relation.
    Nothing,
    /// Not understood.
    Unread(String),
}

/// A family whose members the text lists.
#[derive(Debug, Clone)]
pub struct DeclaredFamily {
    /// The set of its members, if the text has one.
    pub space: Option<Space>,
    /// The first and the last index, if the text has them.
    pub ends: Option<(Expr, Expr)>,
    /// The line.
    pub line: usize,
}

/// What a manuscript says.
#[derive(Debug, Clone, Default)]
pub struct Meanings {
    /// The kinds of names, and how they are printed.
    pub names: LatexNames,
    /// Of each formula.
    pub formulas: Vec<Meaning>,
    /// Definitions by their heads, in their order, with the line of each.
    pub definitions: Vec<(String, Expr, usize)>,
    /// Functions of lists: the name, the variable and the functions.
    pub bases: BTreeMap<String, (String, BTreeMap<u64, Expr>)>,
    /// Ranges that formulas give, with the line of each.
    pub ranges: BTreeMap<String, (LatexCondition, usize)>,
    /// Ranges of integers that theorems give.
    theorem_ranges: BTreeMap<String, (LatexCondition, usize)>,
    /// Families by their names.
    pub families: BTreeMap<String, DeclaredFamily>,
    /// Names whose first formula begins as a definition and is not understood, with the line of each.
    pub undefined: BTreeMap<String, usize>,
    /// Vectors by their names, with the line of each.
    pub vectors: BTreeMap<String, (Space, usize)>,
    /// What is not understood.
    pub unread: Vec<Unread>,
}

impl Meanings {
    /// Reads all formulas.
    pub fn from_manuscript(manuscript: &Manuscript) -> Self {
        let mut guess = LatexGuess::default();
        for formula in manuscript.formulas.iter().take(MAX_FORMULAS) {
            if let Ok(items) = &formula.items {
                guess.add(items);
                for declaration in declared(items).unwrap_or_default() {
                    if let Declared::Points { member, .. } = declaration {
                        guess.add_family(member);
                    }
                }
            }
        }
        let mut meanings = Self {
            names: guess.names(),
            ..Self::default()
        };
        let mut seen = BTreeSet::new();
        for formula in &manuscript.formulas {
            let (line, column) = manuscript.line_and_column(formula.place.start);
            let meaning = match meanings.formulas.len() >= MAX_FORMULAS {
                true => Meaning::Unread(format!("more than {MAX_FORMULAS} formulas")),
                false => meanings.read(formula, line, &mut seen),
            };
            if let Meaning::Unread(why) = &meaning {
                if let Some(name) = meanings
                    .would_define(formula)
                    .filter(|name| !seen.contains(name))
                {
                    meanings.undefined.entry(name).or_insert(line);
                }
                let place = error_place(formula, &meanings.names).unwrap_or(formula.place);
                let (line, column) =
                    match place.start >= formula.place.start && place.start <= formula.place.end {
                        true => manuscript.line_and_column(place.start),
                        false => (line, column),
                    };
                meanings.unread.push(Unread {
                    line,
                    column,
                    why: why.clone(),
                    print: formula.latex.clone(),
                });
            }
            meanings.formulas.push(meaning);
        }
        for (name, range) in std::mem::take(&mut meanings.theorem_ranges) {
            meanings.ranges.entry(name).or_insert(range);
        }
        for (place, why) in &manuscript.unread {
            let (line, column) = manuscript.line_and_column(place.start);
            let print = manuscript
                .text
                .get(place.start..place.end)
                .unwrap_or("")
                .to_owned();
            meanings.unread.push(Unread {
                line,
                column,
                why: why.clone(),
                print,
            });
        }
        meanings
            .unread
            .sort_by_key(|unread| (unread.line, unread.column));
        meanings
    }

    fn read(
        &mut self,
        formula: &ManuscriptFormula,
        line: usize,
        seen: &mut BTreeSet<String>,
    ) -> Meaning {
        let items = match &formula.items {
            Ok(items) => items,
            Err(error) => return Meaning::Unread(error.message.clone()),
        };
        if items.is_empty() {
            return Meaning::Nothing;
        }
        if self.declares(formula, items, line) {
            return Meaning::Nothing;
        }
        let reading = match read_items(items, formula.place, &self.names) {
            Ok(reading) => reading,
            // A letter or a term within a sentence states nothing.
            Err(_) if !formula.is_display && !has_relation(items) => return Meaning::Nothing,
            Err(error) => return Meaning::Unread(error.message),
        };
        let statement = reading.statement;
        if !formula.is_display
            && !matches!(
                statement.formula.node,
                Node::Compare(..) | Node::Join(..) | Node::Not(_)
            )
        {
            return Meaning::Nothing;
        }
        if !reading.others.is_empty() {
            note_names(&statement.formula, seen);
            return Meaning::Ambiguous {
                first: statement,
                others: reading.others,
            };
        }
        if !formula.in_theorem {
            let is_number = |end: &Expr| end.names().into_iter().all(|name| name == "pi");
            let is_of_numbers = |end: &Expr| {
                let is_number = |name| matches!(self.names.kind(name), Some(LatexKind::Number));
                !formula.is_display
                    && end
                        .names()
                        .into_iter()
                        .all(|name| name == "pi" || is_number(name))
            };
            let is_end = |end: &Expr| is_number(end) || is_of_numbers(end);
            if let Some((name, range)) = only_a_range(&statement, is_end) {
                self.ranges.entry(name).or_insert((range, line));
                return Meaning::Nothing;
            }
            for condition in &statement.conditions {
                if let LatexCondition::Interval { names, .. } = condition {
                    for name in names {
                        self.ranges
                            .entry(name.clone())
                            .or_insert((condition.clone(), line));
                    }
                }
                if let LatexCondition::Integers { name, .. } = condition {
                    self.ranges
                        .entry(name.clone())
                        .or_insert((condition.clone(), line));
                }
            }
        } else {
            for condition in &statement.conditions {
                if let LatexCondition::Integers { name, .. } = condition {
                    self.theorem_ranges
                        .entry(name.clone())
                        .or_insert((condition.clone(), line));
                }
            }
        }
        let (mut defined, mut rest) = (vec![], vec![]);
        for part in conjuncts(&statement.formula) {
            match self.definition(part, line, seen) {
                Some((name, more)) => {
                    defined.push(name);
                    rest.extend(more);
                }
                None => rest.push(part.clone()),
            }
            note_names(part, seen);
        }
        let states = rest
            .into_iter()
            .reduce(|a, b| Expr::made(Node::Join(Connective::And, a.into(), b.into())));
        let conditions = statement.conditions;
        match (defined.is_empty(), states) {
            (false, states) => Meaning::Defines {
                names: defined,
                states,
                conditions,
            },
            (true, Some(formula)) if is_statement(&formula) => Meaning::States {
                formula,
                conditions,
            },
            (true, _) if formula.is_display => {
                Meaning::Unread("a formula without a relation states nothing".to_owned())
            }
            (true, _) => Meaning::Nothing,
        }
    }

    /// The name that stands on the left side of an equation as in a definition.
    fn would_define(&self, formula: &ManuscriptFormula) -> Option<String> {
        let items = formula.items.as_ref().ok()?;
        let equals = items
            .iter()
            .position(|item| item.is_sign("=") || item.is_sign(":="))?;
        let left = self.value(items.get(..equals)?, formula.place)?;
        head_of(&left).map(|(name, _)| name)
    }

    /// A formula with one reading, without conditions.
    fn value(&self, list: &[TexItem], place: Place) -> Option<Expr> {
        let reading = read_items(list, place, &self.names).ok()?;
        let is_clear = reading.others.is_empty() && reading.statement.conditions.is_empty();
        is_clear.then_some(reading.statement.formula)
    }

    /// Takes a part of a formula for a definition, if it is one; also returns what the rest of its chain states.
    fn definition(
        &mut self,
        part: &Expr,
        line: usize,
        seen: &BTreeSet<String>,
    ) -> Option<(String, Option<Expr>)> {
        let Node::Compare(left, rest) = &part.node else {
            return None;
        };
        let ((Relation::Equal, body), more) = rest
            .split_first()
            .map(|(first, more)| ((first.0, &first.1), more))?
        else {
            return None;
        };
        let states = || {
            (!more.is_empty()).then(|| Expr {
                node: Node::Compare(body.clone().into(), more.to_vec()),
                place: part.place,
            })
        };
        // A function of a list.
        if let Node::Call(head, arguments) = &left.node
            && let (
                Node::Index(base, indices),
                [
                    Expr {
                        node: Node::Name(argument),
                        ..
                    },
                ],
            ) = (&head.node, arguments.as_slice())
            && let (Node::Name(name), Some(Node::Number { value, .. })) =
                (&base.node, indices.first().map(|index| &index.node))
            && matches!(self.names.kind(name), Some(LatexKind::Basis { .. }))
        {
            let index = u64::try_from(value.to_integer()).ok()?;
            let (variable, functions) = self
                .bases
                .entry(name.clone())
                .or_insert_with(|| (argument.clone(), BTreeMap::new()));
            if variable != argument || functions.contains_key(&index) || uses(body, name) {
                return None;
            }
            functions.insert(index, body.clone());
            return Some((format!("{name}[{index}]"), states()));
        }
        let (name, head) = head_of(left)?;
        if seen.contains(&name) || uses(body, &name) {
            return None;
        }
        if matches!(self.names.kind(&name), Some(LatexKind::Open)) {
            return None;
        }
        self.definitions.push((head, body.clone(), line));
        Some((name, states()))
    }
}

/// The name and the head that a left side defines: a name, a function of letters, a member of a family at letters.
fn head_of(left: &Expr) -> Option<(String, String)> {
    let letters = |list: &[Expr]| -> Option<Vec<String>> {
        let letters: Option<Vec<String>> = list
            .iter()
            .map(|item| match &item.node {
                Node::Name(name) if name != "pi" => Some(name.clone()),
                _ => None,
            })
            .collect();
        letters.filter(|all| all.iter().collect::<BTreeSet<_>>().len() == all.len())
    };
    match &left.node {
        Node::Name(name) if name != "pi" && !name.contains('\'') => {
            Some((name.clone(), name.clone()))
        }
        Node::Call(head, arguments) => match &head.node {
            Node::Name(name) if !name.contains('\'') && !is_function(name) => Some((
                name.clone(),
                format!("{name}({})", letters(arguments)?.join(", ")),
            )),
            _ => None,
        },
        Node::Index(head, indices) => match &head.node {
            Node::Name(name) => Some((
                name.clone(),
                format!("{name}[{}]", letters(indices)?.join(", ")),
            )),
            _ => None,
        },
        _ => None,
    }
}

fn uses(formula: &Expr, name: &str) -> bool {
    formula
        .names()
        .into_iter()
        .any(|other| other.trim_end_matches('\'') == name)
}

fn note_names(formula: &Expr, seen: &mut BTreeSet<String>) {
    seen.extend(
        formula
            .names()
            .into_iter()
            .map(|name| name.trim_end_matches('\'').to_owned()),
    );
}

/// The parts of a conjunction.
pub fn conjuncts(formula: &Expr) -> Vec<&Expr> {
    match &formula.node {
        Node::Join(Connective::And, a, b) => {
            let mut parts = conjuncts(a);
            parts.extend(conjuncts(b));
            parts
        }
        _ => vec![formula],
    }
}

/// Whether a formula states something.
pub fn is_statement(formula: &Expr) -> bool {
    matches!(
        formula.node,
        Node::Compare(..) | Node::Join(..) | Node::Not(_)
    )
}

fn has_relation(items: &[TexItem]) -> bool {
    ["=", "<", ">", "le", "ge", "ne", "in", "equiv", "approx"]
        .iter()
        .any(|sign| items.iter().any(|item| item.is_sign(sign)))
}

/// The range of a name between these ends, if a statement says nothing else.
fn only_a_range(
    statement: &LatexStatement,
    is_end: impl Fn(&Expr) -> bool,
) -> Option<(String, LatexCondition)> {
    let Node::Compare(first, rest) = &statement.formula.node else {
        return None;
    };
    if !statement.conditions.is_empty() {
        return None;
    }
    let is_number = |formula: &Expr| formula.names().into_iter().all(|name| name == "pi");
    let name_of = |formula: &Expr| match &formula.node {
        Node::Name(name) if name != "pi" => Some(name.clone()),
        _ => None,
    };
    let closed = |relation: Relation| matches!(relation, Relation::AtMost | Relation::AtLeast);
    let interval = |name: String, low: (Option<&Expr>, bool), high: (Option<&Expr>, bool)| {
        let range = LatexCondition::Interval {
            names: vec![name.clone()],
            low: (low.0.cloned(), low.1),
            high: (high.0.cloned(), high.1),
            is_set: false,
        };
        Some((name, range))
    };
    let up = |relation: Relation| matches!(relation, Relation::Less | Relation::AtMost);
    let down = |relation: Relation| matches!(relation, Relation::Greater | Relation::AtLeast);
    match rest.as_slice() {
        [(a, middle), (b, high)] if up(*a) && up(*b) && is_end(first) && is_end(high) => interval(
            name_of(middle)?,
            (Some(&**first), closed(*a)),
            (Some(high), closed(*b)),
        ),
        [(a, low)] if down(*a) && is_number(low) => {
            interval(name_of(first)?, (Some(low), closed(*a)), (None, false))
        }
        [(a, high)] if up(*a) && is_number(high) => {
            interval(name_of(first)?, (None, false), (Some(high), closed(*a)))
        }
        _ => None,
    }
}

fn error_place(formula: &ManuscriptFormula, names: &LatexNames) -> Option<Place> {
    match &formula.items {
        Err(error) => Some(error.place),
        Ok(items) => read_items(items, formula.place, names)
            .err()
            .map(|error| error.place),
    }
}

/// A condition as text of the formula language, if it is a formula.
pub fn condition_text(condition: &LatexCondition) -> Option<String> {
    match condition {
        LatexCondition::Formula(formula) => Some(text(formula)),
        _ => None,
    }
}
