//! Declarations: symbols with their domains, basis families, definitions.

pub use super::interval::{Bound, Constant, End, Interval};

use super::interval::interval;
use super::provenance::{Provenance, provenance};
use super::source::whole;
use super::table::Errors;
use crate::derivation::schema::{BasisEntry, Dimension, SymbolEntry};
use crate::derivation::{DerivationError, LoadError, Origin, Source, Written, written};
use crate::formula::functions::is_function;
use crate::formula::{Expr, Place, is_name, parse};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use toml::Spanned;
use torse_numbers::Affine;
use torse_numbers::fault_injection::{InjectedFault, injected};

/// The kind of a declared symbol.
#[derive(Debug, Clone)]
pub enum SymbolKind {
    /// A real number of an interval.
    Real(Box<Interval>),
    /// An integer with optional bounds, both included.
    Integer {
        /// The smallest value.
        least: Option<Affine>,
        /// The largest value.
        most: Option<Affine>,
    },
    /// A vector of this dimension; `None` is one generic coordinate.
    Vector(Option<u8>),
    /// A family of points of this dimension; 1 is a family of numbers, `None` one generic coordinate.
    Family {
        /// The dimension of a member.
        dimension: Option<u8>,
        /// The range of each index, both ends included, if it is declared.
        ranges: Vec<(Affine, Affine)>,
    },
}

/// The declared range of a symbol, with its provenance.
#[derive(Debug, Clone)]
pub struct Range {
    /// Where the range comes from.
    pub provenance: Provenance,
    /// The outer declaration of the name that this one hides.
    pub outer: Option<SymbolKind>,
    /// The place of the declaration.
    pub origin: Origin,
}

/// A named formula or function.
#[derive(Debug, Clone)]
pub struct Definition {
    /// The parameters; empty for a plain name.
    pub parameters: Vec<String>,
    /// Whether the parameters are integer indices in square brackets, as in `Q[i]`.
    pub indexed: bool,
    /// The formula.
    pub body: Written,
}

/// A basis family: seeds of a lowest degree and a step that raises the degree,
/// `g[i,k] = a g[i,k-1] + b g[i-1,k-1]`. With the index shift E the functions of degree k are the
/// coefficients of `(a + b E)^(k - degree) (seed_0 + seed_1 E + ...)`.
#[derive(Debug, Clone)]
pub struct Basis {
    /// The variable.
    pub variable: String,
    /// The shape parameters.
    pub parameters: Vec<String>,
    /// The degree of the seeds.
    pub degree: u8,
    /// The seeds.
    pub seeds: Vec<Written>,
    /// The two factors a and b of the step.
    pub step: (Written, Written),
    /// The names for i and k in the step, if the step depends on them.
    pub counters: Option<(String, String)>,
    /// Whether there is no step: all functions have one degree, and other degrees are refused.
    pub is_list: bool,
}

/// All names that a claim may use, with their meanings.
#[derive(Debug, Clone, Default)]
pub struct Declarations {
    symbols: BTreeMap<String, SymbolKind>,
    /// The smooth functions of one variable: the dimension of their values, and the kind of symbol of a derivative at
    /// a place.
    functions: BTreeMap<String, (Option<u8>, SymbolKind)>,
    bases: BTreeMap<String, Arc<Basis>>,
    definitions: BTreeMap<String, Definition>,
    /// The provenance of declarations, where the files state it.
    ranges: BTreeMap<String, Range>,
    /// How names are displayed.
    displays: BTreeMap<String, String>,
    /// Names whose declaration is invalid.
    invalid: BTreeSet<String>,
}

impl Declarations {
    /// The kind of a symbol. The derivatives of a smooth function at a place, such as `c''(u)`, are symbols too.
    #[must_use]
    pub fn symbol(&self, name: &str) -> Option<&SymbolKind> {
        self.symbols.get(name).or_else(|| {
            let (head, _) = name.split_once('(')?;
            let (_, kind) = self.functions.get(head.trim_end_matches('\''))?;
            Some(kind)
        })
    }

    /// The dimension of the values of a smooth function: 1 for numbers, `None` for one generic coordinate.
    #[must_use]
    pub fn function(&self, name: &str) -> Option<Option<u8>> {
        self.functions.get(name).map(|(dimension, _)| *dimension)
    }

    /// Whether there are smooth functions.
    #[must_use]
    pub fn has_functions(&self) -> bool {
        !self.functions.is_empty()
    }

    /// Declares a smooth function; replaces any other meaning of the name.
    pub fn declare_function(&mut self, name: &str, dimension: Option<u8>) {
        let kind = match dimension {
            Some(1) => SymbolKind::Real(Box::default()),
            dimension => SymbolKind::Vector(dimension),
        };
        self.definitions.remove(name);
        self.symbols.remove(name);
        self.ranges.remove(name);
        self.functions.insert(name.to_owned(), (dimension, kind));
    }

    /// A copy in which one symbol is declared, or declared differently.
    #[must_use]
    pub fn with_symbol(&self, name: &str, kind: SymbolKind) -> Self {
        let mut extended = self.clone();
        extended.symbols.insert(name.to_owned(), kind);
        extended
    }

    /// The declared symbols by name.
    pub fn symbols(&self) -> impl Iterator<Item = (&str, &SymbolKind)> {
        self.symbols
            .iter()
            .map(|(name, kind)| (name.as_str(), kind))
    }

    /// The declared range of a symbol with its provenance, if the file states it.
    #[must_use]
    pub fn range(&self, name: &str) -> Option<&Range> {
        self.ranges.get(name)
    }

    /// The symbols whose declarations state their provenance.
    pub fn ranges(&self) -> impl Iterator<Item = (&str, &Range)> {
        self.ranges
            .iter()
            .map(|(name, range)| (name.as_str(), range))
    }

    /// The letters that stand for vectors in print: those that a display has in bold, but not a name that is declared and
    /// has no display, and so is printed as it is typed.
    #[must_use]
    pub fn bold_letters(&self) -> BTreeSet<char> {
        let displays = self.displays.values();
        let after = displays.flat_map(|display| display.split("\\mathbf").skip(1));
        let letters = after.filter_map(|rest| rest.trim_start_matches([' ', '{']).chars().next());
        let is_plain = |letter: &char| {
            let name = letter.to_string();
            let declared = self.symbol(&name).is_some()
                || self.definition(&name).is_some()
                || self.basis(&name).is_some();
            declared && self.display(&name).is_none()
        };
        letters
            .filter(char::is_ascii_alphabetic)
            .filter(|letter| !is_plain(letter))
            .collect()
    }

    /// How a name is printed: mathematics between dollar signs.
    #[must_use]
    pub fn display(&self, name: &str) -> Option<&str> {
        self.displays.get(name).map(String::as_str)
    }

    /// A basis family.
    #[must_use]
    pub fn basis(&self, name: &str) -> Option<&Arc<Basis>> {
        self.bases.get(name)
    }

    /// The basis families by name.
    pub fn bases(&self) -> impl Iterator<Item = (&str, &Arc<Basis>)> {
        self.bases
            .iter()
            .map(|(name, basis)| (name.as_str(), basis))
    }

    /// A definition.
    #[must_use]
    pub fn definition(&self, name: &str) -> Option<&Definition> {
        self.definitions.get(name)
    }

    /// The definitions by name.
    pub fn definitions(&self) -> impl Iterator<Item = (&str, &Definition)> {
        self.definitions
            .iter()
            .map(|(name, definition)| (name.as_str(), definition))
    }

    /// Adds or replaces a definition; it hides a symbol of the same name.
    pub fn define(&mut self, name: String, definition: Definition) {
        self.symbols.remove(&name);
        self.functions.remove(&name);
        self.ranges.remove(&name);
        self.invalid.remove(&name);
        self.definitions.insert(name, definition);
    }

    /// Declares a real number of any value; replaces any other meaning of the name.
    pub fn declare_number(&mut self, name: String) {
        self.definitions.remove(&name);
        self.functions.remove(&name);
        let anywhere = SymbolKind::Real(Box::default());
        self.symbols.insert(name, anywhere);
    }

    /// Adds or replaces a symbol; it hides a definition of the same name.
    pub fn declare(&mut self, name: &str, kind: SymbolKind) {
        self.definitions.remove(name);
        self.functions.remove(name);
        self.symbols.insert(name.to_owned(), kind);
    }

    /// All declared names.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.symbols
            .keys()
            .chain(self.functions.keys())
            .chain(self.bases.keys())
            .chain(self.definitions.keys())
            .map(String::as_str)
    }

    /// Adds or replaces symbols, which hide definitions of the same name. Invalid declarations are reported and
    /// marked. `own` is the id of the claim that declares the symbols, if a claim does.
    pub(super) fn add_symbols(
        &mut self,
        source: &Arc<Source>,
        table: &BTreeMap<String, SymbolEntry>,
        own: Option<&str>,
        errors: &mut Errors,
    ) {
        for (name, entry) in table {
            if injected(InjectedFault::OuterDeclarationKept) && self.symbols.contains_key(name) {
                continue;
            }
            if let Some(dimension) = &entry.function {
                match smooth(source, name, entry, dimension) {
                    Ok(dimension) => {
                        self.invalid.remove(name);
                        self.declare_function(name, dimension);
                    }
                    Err(error) => {
                        errors.0.push(error);
                        self.mark_invalid([name.clone()]);
                    }
                }
                continue;
            }
            let (kind, place) = match symbol_kind(source, name, entry) {
                Ok(found) => found,
                Err(error) => {
                    errors.0.push(error);
                    self.mark_invalid([name.clone()]);
                    continue;
                }
            };
            let outer = self.symbols.get(name).cloned();
            self.invalid.remove(name);
            self.declare(name, kind);
            self.ranges.remove(name);
            if let Some(from) = entry.from() {
                let origin = Origin::range(source, place.start, place.end);
                let range = Range {
                    provenance: provenance(source, &from, own, place, errors),
                    outer,
                    origin,
                };
                self.ranges.insert(name.clone(), range);
            }
        }
        for (name, entry) in table {
            let indices = entry.indices.iter().flatten();
            for text in entry.integer.iter().chain(indices) {
                if let Some(wrong) = self.strange_end(name, text.get_ref()) {
                    errors
                        .0
                        .push(complaint(&Origin::from_spanned(source, text), wrong));
                    self.mark_invalid([name.clone()]);
                }
            }
        }
    }

    /// What is wrong with the names in an integer range: its ends are made of numbers and of other integer symbols.
    fn strange_end(&self, own: &str, text: &str) -> Option<String> {
        let (least, most) = integer_range(text)?;
        let ends = least.iter().chain(&most);
        let mut names = ends.flat_map(|end| end.multiples().map(|(name, _)| name));
        let is_integer = |name: &&str| {
            let kind = self.symbols.get(*name);
            *name != own && matches!(kind, Some(SymbolKind::Integer { .. }))
                || self.invalid.contains(*name)
        };
        let name = names.find(|name| !is_integer(name))?;
        Some(match self.symbols.get(name) {
            _ if name == own => format!("the range of `{own}` cannot depend on `{own}`"),
            None => format!(
                "`{name}` is no declared integer: the ends of a range are numbers and integer symbols"
            ),
            Some(_) => format!(
                "`{name}` is no integer: the ends of a range are numbers and integer symbols"
            ),
        })
    }

    /// Adds or replaces the display forms of names.
    pub(super) fn add_displays(
        &mut self,
        source: &Arc<Source>,
        table: &BTreeMap<String, Spanned<String>>,
        errors: &mut Errors,
    ) {
        for (name, text) in table {
            let at = |message: String| {
                let error =
                    DerivationError::at(&Origin::from_spanned(source, text), whole(text), message);
                LoadError::Derivation(Box::new(error))
            };
            let inside = text.get_ref().strip_prefix('$');
            let inside = inside.and_then(|rest| rest.strip_suffix('$'));
            let known = self.names().any(|known| known == name) || self.invalid.contains(name);
            if inside.is_none_or(|inside| inside.is_empty() || inside.contains('$')) {
                let message = format!("`{}` is not mathematics: write `$...$`", text.get_ref());
                errors.0.push(at(message));
            } else if !known {
                let message = format!("`{name}` is not declared, so it is not displayed");
                errors.0.push(at(message));
            } else {
                self.displays.insert(name.clone(), text.get_ref().clone());
            }
        }
    }

    /// Adds or replaces basis families. Invalid ones are reported and marked.
    pub(super) fn add_bases(
        &mut self,
        source: &Arc<Source>,
        table: &BTreeMap<String, BasisEntry>,
        errors: &mut Errors,
    ) {
        for (name, entry) in table {
            match errors.keep(basis(source, name, entry)) {
                Some(basis) => {
                    self.invalid.remove(name);
                    self.bases.insert(name.clone(), Arc::new(basis));
                }
                None => self.mark_invalid([name.clone()]),
            }
        }
    }

    /// Marks names whose declaration is invalid.
    pub(super) fn mark_invalid(&mut self, names: impl IntoIterator<Item = String>) {
        self.invalid.extend(names);
    }

    /// Whether any declaration is invalid.
    pub(super) fn any_invalid(&self) -> bool {
        !self.invalid.is_empty()
    }

    /// Whether the formulas use an invalid declaration, directly or through definitions.
    pub(super) fn depends_on_invalid<'e>(
        &'e self,
        formulas: impl Iterator<Item = &'e Expr>,
    ) -> bool {
        !self.invalid.is_empty() && self.depends_on(formulas, |name| self.invalid.contains(name))
    }

    /// Whether the formulas use a wanted name, directly or through definitions, ranges and bases.
    pub(super) fn depends_on<'e>(
        &'e self,
        formulas: impl Iterator<Item = &'e Expr>,
        is_wanted: impl Fn(&str) -> bool,
    ) -> bool {
        let mut seen = BTreeSet::new();
        let mut pending: Vec<&Expr> = formulas.collect();
        while let Some(expr) = pending.pop() {
            for written in expr.names() {
                for name in [written, written.trim_end_matches('\'')] {
                    if is_wanted(name) {
                        return true;
                    }
                    if !seen.insert(name) {
                        continue;
                    }
                    pending.extend(self.definition(name).map(|d| &d.body.expr));
                    if let Some(SymbolKind::Real(interval)) = self.symbol(name) {
                        pending.extend(interval.formulas().map(|end| &end.formula.expr));
                    }
                    if let Some(basis) = self.basis(name) {
                        let steps = [&basis.step.0, &basis.step.1];
                        pending.extend(basis.seeds.iter().chain(steps).map(|w| &w.expr));
                    }
                }
            }
        }
        false
    }

    /// A lower bound of an index form, computed from the bounds of its integer symbols.
    #[must_use]
    pub fn least(&self, form: &Affine) -> Option<i64> {
        self.extreme(form, |kind, positive| match kind {
            SymbolKind::Integer { least, most } => {
                if positive {
                    least.clone()
                } else {
                    most.clone()
                }
            }
            _ => None,
        })
    }

    /// An upper bound of an index form, computed from the bounds of its integer symbols.
    #[must_use]
    pub fn greatest(&self, form: &Affine) -> Option<i64> {
        self.least(&(form.clone() * -1)).map(|least| -least)
    }

    fn extreme(
        &self,
        form: &Affine,
        bound: impl Fn(&SymbolKind, bool) -> Option<Affine>,
    ) -> Option<i64> {
        // A bound may contain other symbols (i runs to k), so substitute until only a number is left.
        let mut form = form.clone();
        for _ in 0..16 {
            if let Some(value) = form.as_number() {
                return Some(value);
            }
            // Symbols whose bound contains another symbol come first.
            let candidates: Vec<(String, i64)> = form
                .multiples()
                .map(|(name, m)| (name.to_owned(), m))
                .collect();
            let replacement = candidates.iter().filter_map(|(name, multiple)| {
                let value = bound(self.symbols.get(name)?, *multiple > 0)?;
                Some((name, value))
            });
            let (name, value) = replacement.max_by_key(|(_, value)| value.as_number().is_none())?;
            form = form.substituted(name, &value);
        }
        None
    }
}

fn complaint(origin: &Origin, message: String) -> LoadError {
    LoadError::Derivation(Box::new(DerivationError::at(
        origin,
        Place::default(),
        message,
    )))
}

/// Fails unless the name follows the syntax of names.
fn check_name(origin: &Origin, name: &str) -> Result<(), LoadError> {
    if is_name(name) {
        return Ok(());
    }
    Err(complaint(
        origin,
        format!(
            "`{name}` cannot be a name: names are letters, digits and `_`, and not words of the language"
        ),
    ))
}
fn basis(source: &Arc<Source>, name: &str, entry: &BasisEntry) -> Result<Basis, LoadError> {
    let at = |range: std::ops::Range<usize>| Origin::range(source, range.start, range.end);
    let variable = at(entry.variable.span());
    check_name(&variable, name)?;
    for name in std::iter::once(&entry.variable).chain(&entry.parameters) {
        check_name(&Origin::from_spanned(source, name), name.get_ref())?;
    }
    let is_list = entry.step.is_empty() && entry.index.is_none() && entry.order.is_none();
    let zero = || Written {
        expr: crate::formula::Expr::number(&torse_numbers::rational::integer(0)),
        origin: variable.clone(),
    };
    let step = match entry.step.as_slice() {
        [] if is_list => (zero(), zero()),
        [a, b] => (written(source, a)?, written(source, b)?),
        _ => {
            let message = format!(
                "`step` of the basis `{name}` needs two factors, [a, b]; without one it is a list of functions of one degree"
            );
            return Err(complaint(&variable, message));
        }
    };
    let (degree, found) = (usize::from(*entry.degree.get_ref()), entry.seeds.len());
    if found != degree + 1 {
        let message = format!("degree {degree} needs {} seeds, found {found}", degree + 1);
        return Err(complaint(&at(entry.degree.span()), message));
    }
    let counters = match (&entry.index, &entry.order) {
        (None, None) => None,
        (Some(index), Some(order)) => {
            for name in [index, order] {
                check_name(&Origin::from_spanned(source, name), name.get_ref())?;
            }
            if index.get_ref() == order.get_ref() {
                let message = "`index` and `order` are two names".to_owned();
                return Err(complaint(&Origin::from_spanned(source, order), message));
            }
            Some((index.get_ref().clone(), order.get_ref().clone()))
        }
        (Some(one), None) | (None, Some(one)) => {
            let message = "a step that depends on index and degree needs both `index` and `order`";
            return Err(complaint(
                &Origin::from_spanned(source, one),
                message.to_owned(),
            ));
        }
    };
    let seeds = entry.seeds.iter().map(|text| written(source, text));
    Ok(Basis {
        counters,
        variable: entry.variable.get_ref().clone(),
        parameters: entry
            .parameters
            .iter()
            .map(|p| p.get_ref().clone())
            .collect(),
        degree: *entry.degree.get_ref(),
        seeds: seeds.collect::<Result<_, _>>()?,
        step,
        is_list,
    })
}

/// The message about a definition or smooth function with the name of a function of the language.
pub(super) fn taken(name: &str) -> String {
    format!(
        "`{name}` is a function of the language and cannot be declared anew: choose another name"
    )
}

/// Reads the dimension of the values of a smooth function; no other field is allowed.
fn smooth(
    source: &Arc<Source>,
    name: &str,
    entry: &SymbolEntry,
    values: &Spanned<Dimension>,
) -> Result<Option<u8>, LoadError> {
    let origin = Origin::range(source, values.span().start, values.span().end);
    check_name(&origin, name)?;
    if is_function(name) {
        return Err(complaint(&origin, taken(name)));
    }
    if name.ends_with('\'') {
        let message = format!(
            "`{name}` is the derivative of another function: a name without primes is needed"
        );
        return Err(complaint(&origin, message));
    }
    let texts = [
        &entry.interval,
        &entry.integer,
        &entry.printed,
        &entry.printed_in,
        &entry.ours,
    ];
    let more = texts.iter().any(|text| text.is_some())
        || entry.vector.is_some()
        || entry.family.is_some()
        || entry.indices.is_some();
    if more {
        let message = format!(
            "`{name}` is any smooth function: what is known of it at a place is assumed, `assume = ['{name}(u) > 0']`"
        );
        return Err(complaint(&origin, message));
    }
    Ok(dimension(values))
}

fn dimension(written: &Spanned<Dimension>) -> Option<u8> {
    match written.get_ref() {
        Dimension::Number(n) => Some(*n),
        Dimension::Any(_) => None,
    }
}

/// Reads the kind of a symbol; exactly one kind may be given.
fn symbol_kind(
    source: &Arc<Source>,
    name: &str,
    entry: &SymbolEntry,
) -> Result<(SymbolKind, std::ops::Range<usize>), LoadError> {
    let text = |text: &Option<Spanned<String>>| text.as_ref().map(Spanned::span);
    let dimensions = |d: &Option<Spanned<Dimension>>| d.as_ref().map(Spanned::span);
    let given: Vec<_> = [
        text(&entry.interval),
        text(&entry.integer),
        dimensions(&entry.vector),
        dimensions(&entry.family),
    ]
    .into_iter()
    .flatten()
    .collect();
    let place = given.last().cloned().unwrap_or(0..0);
    let found = |kind| Ok((kind, place.clone()));
    let origin = Origin::range(source, place.start, place.end);
    check_name(&origin, name)?;
    if given.len() > 1 {
        let message = format!(
            "`{name}` can be one of `in`, `integer`, `vector`, `family` and `function` only"
        );
        return Err(complaint(&origin, message));
    }
    if let Some(text) = &entry.integer {
        let origin = Origin::from_spanned(source, text);
        let (least, most) = integer_range(text.get_ref()).ok_or_else(|| {
            complaint(
                &origin,
                format!(
                    "`{}` is not an integer range: write `>= 2`, `<= 5` or `0..k`",
                    text.get_ref()
                ),
            )
        })?;
        return found(SymbolKind::Integer { least, most });
    }
    if let Some(vector) = &entry.vector {
        return found(SymbolKind::Vector(dimension(vector)));
    }
    if let Some(family) = &entry.family {
        let mut ranges = vec![];
        for text in entry.indices.iter().flatten() {
            match integer_range(text.get_ref()) {
                Some((Some(least), Some(most))) => ranges.push((least, most)),
                _ => {
                    let origin = Origin::from_spanned(source, text);
                    return Err(complaint(
                        &origin,
                        format!("`{}` is not an index range: write `0..k`", text.get_ref()),
                    ));
                }
            }
        }
        return found(SymbolKind::Family {
            dimension: dimension(family),
            ranges,
        });
    }
    let Some(text) = &entry.interval else {
        return found(SymbolKind::Real(Box::default()));
    };
    found(SymbolKind::Real(Box::new(interval(source, name, text)?)))
}

/// `>= 2`, `<= 5`, `0..k`.
fn integer_range(text: &str) -> Option<(Option<Affine>, Option<Affine>)> {
    let form = |text: &str| parse(text).ok()?.affine();
    if let Some((low, high)) = text.split_once("..") {
        return Some((Some(form(low)?), Some(form(high)?)));
    }
    if let Some(low) = text.trim().strip_prefix(">=") {
        return Some((Some(form(low)?), None));
    }
    if let Some(high) = text.trim().strip_prefix("<=") {
        return Some((None, Some(form(high)?)));
    }
    text.trim().is_empty().then_some((None, None))
}
