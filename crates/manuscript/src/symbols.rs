//! The symbols of a proposal: every name that occurs and that no formula defines, with its set.
//!
//! A range is one that a formula of the text gives. A name in the bounds of a sum, in an index, a factorial or a binomial is an integer: if
//! the text writes a set of real numbers for it, it is not declared, and the text says why. A name in an exponent is an integer where the
//! text says so, or, with a question, where it is one of the letters i to n and the text gives no set of reals. The indices of a family are those of the text's list, or the smallest range with all that occur; an index without a range
//! takes all values for which its families have members. Vectors and curves have as many coordinates as the points that the text
//! declares, or else three; a function that no formula defines is any smooth function of one variable. Where the text says nothing, a
//! comment says what is guessed, or asks.

use crate::declared::Space;
use crate::index::{AffineIndex, IndexRange, hull};
use crate::meaning::{Meaning, Meanings};
use crate::occurrences::{Occurrences, UsedIndex};
use std::collections::{BTreeMap, BTreeSet};
use torse_syntax::formula::functions::is_function;
use torse_syntax::formula::{Expr, Node};
use torse_syntax::latex::{LatexCondition, LatexKind};
use torse_syntax::notation::text;

/// A declaration.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ProposedSymbol {
    /// The name.
    pub name: String,
    /// Its set, as an inline table.
    pub set: String,
    /// Where the set is from, or what to ask.
    pub comment: String,
}

/// The symbols of a manuscript, and the names of which none can be declared, each with the reason.
pub fn symbols(meanings: &Meanings) -> (Vec<ProposedSymbol>, BTreeMap<String, String>) {
    let reader = SymbolReader::new(meanings);
    let defined: BTreeSet<&str> = meanings
        .definitions
        .iter()
        .map(|(head, _, _)| name_of(head))
        .collect();
    let mut symbols = vec![];
    let mut unknown = BTreeMap::new();
    for name in meanings.bases.keys() {
        if let Err(why) = reader.basis(name) {
            unknown.insert(name.clone(), why);
        }
    }
    let mut pending: Vec<String> = reader.found.names.iter().cloned().collect();
    let mut done = BTreeSet::new();
    while let Some(name) = pending.pop() {
        let is_known = defined.contains(name.as_str())
            || meanings.bases.contains_key(&name)
            || name == "pi"
            || is_function(&name);
        if is_known || !done.insert(name.clone()) {
            continue;
        }
        match reader.declared(&name) {
            Ok((symbol, more)) => {
                symbols.push(symbol);
                pending.extend(more);
            }
            Err(why) => {
                unknown.insert(name, why);
            }
        }
    }
    unknown_by_definition(meanings, &mut unknown);
    symbols.sort_by(|a, b| a.name.cmp(&b.name));
    (symbols, unknown)
}

/// Adds the names whose definitions use names that cannot be declared.
fn unknown_by_definition(meanings: &Meanings, unknown: &mut BTreeMap<String, String>) {
    let definitions = meanings
        .definitions
        .iter()
        .map(|(head, body, _)| (name_of(head), body));
    let functions = meanings.bases.iter().flat_map(|(name, (_, functions))| {
        functions.values().map(move |body| (name.as_str(), body))
    });
    let all: Vec<(&str, &Expr)> = definitions.chain(functions).collect();
    loop {
        let found = all.iter().find_map(|(name, body)| {
            let used = body.names().into_iter();
            let mut used = used.map(|used| used.trim_end_matches('\''));
            let used = used.find(|used| unknown.contains_key(*used))?;
            let why = format!("its definition uses `{used}`: {}", unknown.get(used)?);
            (!unknown.contains_key(*name)).then(|| ((*name).to_owned(), why))
        });
        let Some((name, why)) = found else { return };
        unknown.insert(name, why);
    }
}

/// The name of a head.
pub fn name_of(head: &str) -> &str {
    head.split(['(', '[']).next().unwrap_or(head)
}

/// The formulas that a meaning states, or may state.
pub fn stated(meaning: &Meaning) -> Vec<&Expr> {
    match meaning {
        Meaning::Defines {
            states, conditions, ..
        } => states
            .iter()
            .chain(conditions.iter().filter_map(formula_of))
            .collect(),
        Meaning::States {
            formula,
            conditions,
        } => std::iter::once(formula)
            .chain(conditions.iter().filter_map(formula_of))
            .collect(),
        Meaning::Ambiguous { first, others } => std::iter::once(&first.formula)
            .chain(others.iter().map(|(_, other)| &other.formula))
            .collect(),
        Meaning::Nothing | Meaning::Unread(_) => vec![],
    }
}

fn formula_of(condition: &LatexCondition) -> Option<&Expr> {
    match condition {
        LatexCondition::Formula(formula) => Some(formula),
        _ => None,
    }
}

fn parameters(head: &str) -> Vec<String> {
    let Some((_, inner)) = head.split_once(['(', '[']) else {
        return vec![];
    };
    inner
        .trim_end_matches([')', ']'])
        .split(", ")
        .map(str::to_owned)
        .collect()
}

/// What is found of the names of a manuscript.
struct SymbolReader<'m> {
    meanings: &'m Meanings,
    found: Occurrences,
    /// The coordinates of vectors of which the text says nothing.
    dimension: String,
}

type Declaration = Result<(ProposedSymbol, Vec<String>), String>;

impl<'m> SymbolReader<'m> {
    fn new(meanings: &'m Meanings) -> Self {
        let mut found = Occurrences::default();
        for (head, body, _) in &meanings.definitions {
            let parameters = parameters(head);
            let bound: Vec<_> = parameters.iter().map(|name| (name.clone(), None)).collect();
            found.walk(body, &bound);
        }
        for (variable, functions) in meanings.bases.values() {
            found.names.insert(variable.clone());
            for body in functions.values() {
                found.walk(body, &[]);
            }
        }
        for meaning in &meanings.formulas {
            for formula in stated(meaning) {
                found.walk(formula, &[]);
            }
        }
        // What a definition takes for an integer is one where the function is applied.
        for (head, body, _) in &meanings.definitions {
            let mut own = Occurrences::default();
            own.walk(body, &[]);
            let parameters = parameters(head);
            for (name, arguments) in found.calls.clone() {
                if name != name_of(head) {
                    continue;
                }
                for (parameter, argument) in parameters.iter().zip(&arguments) {
                    let names = || argument.names().into_iter().map(str::to_owned);
                    if own.integers.contains(parameter) {
                        found.integers.extend(names());
                    }
                    if own.exponents.contains(parameter) {
                        found.exponents.extend(names());
                    }
                }
                for (over, chosen) in &own.chosen {
                    let at = |wanted: &str| parameters.iter().position(|own| own == wanted);
                    let over = match &over.node {
                        Node::Name(over) => at(over).and_then(|at| arguments.get(at)),
                        _ => None,
                    };
                    let chosen = at(chosen).and_then(|at| arguments.get(at));
                    if let (Some(over), Some(Node::Name(chosen))) =
                        (over, chosen.map(|chosen| &chosen.node))
                    {
                        found.chosen.push((over.clone(), chosen.clone()));
                    }
                }
            }
        }
        let listed = meanings.families.values();
        let listed = listed.filter_map(|family| family.ends.as_ref());
        let mut ends: Vec<&Expr> = listed.flat_map(|(low, high)| [low, high]).collect();
        for (name, (range, _)) in &meanings.ranges {
            match range {
                LatexCondition::Integers { low, high, .. } => {
                    ends.extend(std::iter::once(low).chain(high));
                }
                LatexCondition::Interval {
                    low,
                    high,
                    is_set: false,
                    ..
                } if found.integers.contains(name) || is_index_by_custom(name, &found) => {
                    ends.extend(low.0.iter().chain(&high.0));
                }
                _ => {}
            }
        }
        for name in ends.into_iter().flat_map(Expr::names) {
            found.integers.insert(name.to_owned());
            found.bounds.insert(name.to_owned());
        }
        let spaces = meanings.families.values().filter_map(|family| family.space);
        let spaces = spaces.chain(meanings.vectors.values().map(|(space, _)| *space));
        let dimension = spaces
            .filter(|space| *space != Space::Coordinates(1))
            .map(Space::dimension)
            .next()
            .unwrap_or_else(|| "3".to_owned());
        Self {
            meanings,
            found,
            dimension,
        }
    }

    /// Whether all functions of a basis are defined.
    fn basis(&self, name: &str) -> Result<(), String> {
        let incomplete = || Err("not all of its functions are defined".to_owned());
        let (Some((_, functions)), Some(LatexKind::Basis { degree, .. })) = (
            self.meanings.bases.get(name),
            self.meanings.names.kind(name),
        ) else {
            return incomplete();
        };
        let first = functions.keys().next().copied().unwrap_or(0);
        let last = degree.map_or(0, u64::from);
        if first > 1 || !(first..=last).eq(functions.keys().copied()) {
            return incomplete();
        }
        let begins_at_zero = |indices: &Vec<UsedIndex>| match indices.first() {
            Some(UsedIndex::Range((low, _))) => low.symbol.is_none() && low.constant < 1,
            _ => false,
        };
        let uses_zero = self
            .found
            .indices
            .get(name)
            .is_some_and(|all| all.iter().any(begins_at_zero));
        match first == 1 && uses_zero {
            true => incomplete(),
            false => Ok(()),
        }
    }

    /// The declaration of a name, and the names that it mentions.
    fn declared(&self, name: &str) -> Declaration {
        let symbol = |set: String, comment: &str| ProposedSymbol {
            name: name.to_owned(),
            set,
            comment: comment.to_owned(),
        };
        let plain = |set: String, comment: &str| Ok((symbol(set, comment), vec![]));
        if let Some((space, line)) = self.meanings.vectors.get(name) {
            return plain(
                format!("{{ vector = {} }}", space.dimension()),
                &format!("line {line}"),
            );
        }
        if let Some(line) = self.meanings.undefined.get(name) {
            return Err(format!("its definition in line {line} is not understood"));
        }
        let dimension = &self.dimension;
        match self.meanings.names.kind(name) {
            Some(LatexKind::Vector) => plain(
                format!("{{ vector = {dimension} }}"),
                "a vector of space, or `vector = 2`?",
            ),
            Some(LatexKind::Matrix) => Err("it is a matrix that no formula defines".to_owned()),
            Some(LatexKind::Basis { .. }) => Err("not all of its functions are defined".to_owned()),
            Some(LatexKind::Open) => Err("it is a number or a function".to_owned()),
            Some(LatexKind::Function {
                parameters,
                is_vector,
            }) => match parameters.len() {
                1 => plain(
                    format!(
                        "{{ function = {} }}",
                        if *is_vector { dimension.as_str() } else { "1" }
                    ),
                    "any smooth function; if the text defines it, define it under [define]",
                ),
                count => Err(format!(
                    "it is a function of {count} variables that no formula defines"
                )),
            },
            Some(LatexKind::Family { indices, is_vector }) => {
                self.family(name, *indices, *is_vector)
            }
            Some(LatexKind::NumberOrBase) => Err(
                "it is a number of the text, or the base of the exponential function: the first is declared, the second is written exp(1)"
                    .to_owned(),
            ),
            Some(LatexKind::Number) | None => self.number(name),
        }
    }

    fn family(&self, name: &str, indices: usize, is_vector: bool) -> Declaration {
        let declared = self.meanings.families.get(name);
        let dimension = match declared.and_then(|family| family.space) {
            Some(space) => space.dimension(),
            None if is_vector => self.dimension.clone(),
            None => "1".to_owned(),
        };
        let listed = declared.and_then(|family| Some((family.ends.as_ref()?, family.line)));
        let (ranges, comment, ends) = match listed.filter(|_| indices == 1) {
            Some(((low, high), line)) => (
                vec![format!("{}..{}", text(low), text(high))],
                format!("line {line}"),
                low.names()
                    .into_iter()
                    .chain(high.names())
                    .map(str::to_owned)
                    .collect(),
            ),
            None => {
                let ranges: Option<Vec<IndexRange>> =
                    (0..indices).map(|at| self.range(name, at)).collect();
                let Some(ranges) = ranges else {
                    return Err(format!(
                        "the text does not say for which indices: declare it, {name} = {{ family = {dimension}, indices = [\"0..n\"] }}"
                    ));
                };
                let names = ranges
                    .iter()
                    .flat_map(|(low, high)| [&low.symbol, &high.symbol])
                    .flatten()
                    .cloned()
                    .collect();
                let ranges = ranges.iter().map(|(low, high)| format!("{low}..{high}"));
                (ranges.collect(), "all indices that occur".to_owned(), names)
            }
        };
        let quoted: Vec<String> = ranges.iter().map(|range| format!("\"{range}\"")).collect();
        let set = format!(
            "{{ family = {dimension}, indices = [{}] }}",
            quoted.join(", ")
        );
        let symbol = ProposedSymbol {
            name: name.to_owned(),
            set,
            comment,
        };
        Ok((symbol, ends))
    }

    /// The smallest range with all indices of a family at a position.
    fn range(&self, name: &str, at: usize) -> Option<IndexRange> {
        let used = self.found.indices.get(name)?;
        let ranges: Vec<IndexRange> = used
            .iter()
            .filter_map(|indices| match indices.get(at)? {
                UsedIndex::Range(range) => Some(range.clone()),
                UsedIndex::Free(index) => {
                    let symbol = index.symbol.as_deref()?;
                    match self.written_range(symbol) {
                        Some((low, high)) => {
                            Some((low.plus(index.constant), high.plus(index.constant)))
                        }
                        None if self.found.bounds.contains(symbol) => {
                            Some((index.clone(), index.clone()))
                        }
                        None => None,
                    }
                }
                UsedIndex::Other => None,
            })
            .collect();
        hull(&ranges)
    }

    /// The range of integers that the text gives a name, if both ends are simple.
    fn written_range(&self, name: &str) -> Option<IndexRange> {
        match &self.meanings.ranges.get(name)?.0 {
            LatexCondition::Integers { low, high, .. } => Some((
                AffineIndex::from_formula(low)?,
                AffineIndex::from_formula(high.as_ref()?)?,
            )),
            LatexCondition::Interval { low, high, .. } => Some((
                AffineIndex::from_formula(low.0.as_ref()?)?,
                AffineIndex::from_formula(high.0.as_ref()?)?,
            )),
            LatexCondition::Formula(_) => None,
        }
    }

    fn number(&self, name: &str) -> Declaration {
        let symbol = |set: String, comment: String| ProposedSymbol {
            name: name.to_owned(),
            set,
            comment,
        };
        let must_be_integer = self.found.integers.contains(name);
        let is_integer = must_be_integer || is_index_by_custom(name, &self.found);
        let mentioned = |ends: &mut dyn Iterator<Item = &Expr>| -> Vec<String> {
            ends.flat_map(Expr::names).map(str::to_owned).collect()
        };
        match self.meanings.ranges.get(name) {
            Some((LatexCondition::Integers { low, high, .. }, line)) => Ok((
                symbol(integers(low, high.as_ref()), format!("line {line}")),
                mentioned(&mut std::iter::once(low).chain(high)),
            )),
            Some((range @ LatexCondition::Interval { is_set: true, .. }, line))
                if must_be_integer =>
            {
                let range = interval(range).unwrap_or_default();
                Err(format!(
                    "line {line} says that it is a real number of {range}, and it stands where an integer belongs: declare which, {name} = {{ integer = \">= 0\" }}"
                ))
            }
            Some((
                LatexCondition::Interval {
                    low,
                    high,
                    is_set: false,
                    ..
                },
                line,
            )) if is_integer => match (&low.0, &high.0) {
                (Some(least), most) => Ok((
                    symbol(integers(least, most.as_ref()), format!("line {line}")),
                    mentioned(&mut std::iter::once(least).chain(most)),
                )),
                _ => Ok(self.guessed(name)),
            },
            Some((range @ LatexCondition::Interval { low, high, .. }, line)) => Ok((
                symbol(
                    format!("{{ in = \"{}\" }}", interval(range).unwrap_or_default()),
                    format!("line {line}"),
                ),
                mentioned(&mut low.0.iter().chain(&high.0)),
            )),
            _ if is_integer => Ok(self.guessed(name)),
            _ => {
                let comment = match name {
                    "e" => {
                        "which numbers? the text gives no range; the base of the exponential function is exp(1)"
                    }
                    _ if self.found.exponents.contains(name) => {
                        "which numbers? the text gives no range; in an exponent an integer belongs"
                    }
                    _ => "which numbers? the text gives no range",
                };
                Ok((symbol("{}".to_owned(), comment.to_owned()), vec![]))
            }
        }
    }

    /// An integer of which the text gives no range.
    fn guessed(&self, name: &str) -> (ProposedSymbol, Vec<String>) {
        let symbol = |set: String, comment: String| ProposedSymbol {
            name: name.to_owned(),
            set,
            comment,
        };
        if let Some(((low, high), of)) = self.as_an_index(name) {
            let ends = [&low.symbol, &high.symbol];
            return (
                symbol(
                    format!("{{ integer = \"{low}..{high}\" }}"),
                    format!("a guess, by {of}: the text gives no range"),
                ),
                ends.into_iter().flatten().cloned().collect(),
            );
        }
        let least = self.least(name);
        (
            symbol(
                format!("{{ integer = \">= {least}\" }}"),
                "which integers? the text gives no range".to_owned(),
            ),
            vec![],
        )
    }

    /// The range of an index for which its families have members, or the numbers that a binomial chooses.
    fn as_an_index(&self, name: &str) -> Option<(IndexRange, String)> {
        if self.found.bounds.contains(name) {
            return None;
        }
        let mut found: Option<(IndexRange, String)> = None;
        for (family, all) in &self.found.indices {
            let offsets = all.iter().flat_map(|indices| indices.iter().enumerate());
            let offsets = offsets.filter_map(|(at, index)| match index {
                UsedIndex::Free(index) if index.symbol.as_deref() == Some(name) => {
                    Some((at, index.constant))
                }
                _ => None,
            });
            for (at, offset) in offsets {
                let range = match self.meanings.names.kind(family) {
                    Some(LatexKind::Basis {
                        degree: Some(degree),
                        ..
                    }) if at == 0 => {
                        // Outside its indices a basis is zero.
                        let number = |constant| AffineIndex {
                            symbol: None,
                            constant,
                        };
                        let first = self.meanings.bases.get(family)?.1.keys().next().copied();
                        let first = i64::try_from(first.unwrap_or(0)).unwrap_or(0);
                        (number(first), number(i64::from(*degree)))
                    }
                    Some(LatexKind::Family { .. }) => {
                        let Some((low, high)) = self.family_range(family, at) else {
                            continue;
                        };
                        (low.plus(-offset), high.plus(-offset))
                    }
                    _ => continue,
                };
                found = Some(match found {
                    None => (range, format!("the indices of `{family}`")),
                    Some(((low, high), of)) => ((later(low, range.0), earlier(high, range.1)), of),
                });
            }
        }
        if found.is_some() {
            return found;
        }
        let (over, _) = self
            .found
            .chosen
            .iter()
            .find(|(_, chosen)| chosen == name)?;
        let high = AffineIndex::from_formula(over)?;
        let low = AffineIndex {
            symbol: None,
            constant: 0,
        };
        Some(((low, high), "a binomial coefficient".to_owned()))
    }

    fn family_range(&self, name: &str, at: usize) -> Option<IndexRange> {
        match self
            .meanings
            .families
            .get(name)
            .and_then(|family| family.ends.as_ref())
        {
            Some((low, high)) if at == 0 => Some((
                AffineIndex::from_formula(low)?,
                AffineIndex::from_formula(high)?,
            )),
            _ => self.range(name, at),
        }
    }

    /// The least value of the last index of families with which all members that occur exist.
    fn least(&self, name: &str) -> i64 {
        let mut least = 0;
        for (family, all) in &self.found.indices {
            for (at, index) in all.iter().flat_map(|indices| indices.iter().enumerate()) {
                let ends = self.family_range(family, at);
                let Some((low, high)) =
                    ends.filter(|(_, high)| high.symbol.as_deref() == Some(name))
                else {
                    continue;
                };
                let ends = match index {
                    UsedIndex::Range((first, last)) => vec![first.clone(), last.clone()],
                    UsedIndex::Free(index) => vec![index.clone()],
                    UsedIndex::Other => vec![],
                };
                for end in ends {
                    match &end.symbol {
                        // A number is at most the last index.
                        None => least = least.max(end.constant - high.constant),
                        // The last index less some is at least the first one.
                        Some(symbol) if symbol == name && low.symbol.is_none() => {
                            least = least.max(low.constant - end.constant);
                        }
                        Some(_) => {}
                    }
                }
            }
        }
        least
    }
}

/// Whether a name stands in exponents, and is one of the letters by which indices are written.
fn is_index_by_custom(name: &str, found: &Occurrences) -> bool {
    found.exponents.contains(name)
        && name
            .chars()
            .next()
            .is_some_and(|first| matches!(first, 'i'..='n'))
        && name
            .chars()
            .skip(1)
            .all(|rest| rest.is_ascii_digit() || rest == '_')
}

/// The later of two indices, where they can be compared.
fn later(a: AffineIndex, b: AffineIndex) -> AffineIndex {
    if a.symbol == b.symbol && b.constant > a.constant {
        b
    } else {
        a
    }
}

fn earlier(a: AffineIndex, b: AffineIndex) -> AffineIndex {
    if a.symbol == b.symbol && b.constant < a.constant {
        b
    } else {
        a
    }
}

/// A range of integers as an inline table.
pub fn integers(low: &Expr, high: Option<&Expr>) -> String {
    match high {
        Some(high) => format!("{{ integer = \"{}..{}\" }}", text(low), text(high)),
        None => format!("{{ integer = \">= {}\" }}", text(low)),
    }
}

/// An interval as text.
pub fn interval(condition: &LatexCondition) -> Option<String> {
    let LatexCondition::Interval { low, high, .. } = condition else {
        return None;
    };
    let (open, below) = match low {
        (Some(low), closed) => (if *closed { "[" } else { "(" }, text(low)),
        (None, _) => ("(", "-inf".to_owned()),
    };
    let (above, close) = match high {
        (Some(high), closed) => (text(high), if *closed { "]" } else { ")" }),
        (None, _) => ("inf".to_owned(), ")"),
    };
    Some(format!("{open}{below}, {above}{close}"))
}
