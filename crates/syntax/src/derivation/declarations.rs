//! What names mean: symbols with their domains, basis families, definitions.

pub use super::interval::{Bound, Constant, End, Interval};

use super::interval::interval;
use super::provenance::{Provenance, provenance};
use super::source::whole;
use super::table::Errors;
use crate::derivation::schema::{BasisEntry, Dimension, SymbolEntry};
use crate::derivation::{DerivationError, LoadError, Origin, Source, Written, written};
use crate::formula::{Expr, Node, Place, is_name, parse};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use toml::Spanned;
use torse_numbers::Affine;
use torse_numbers::fault_injection::{InjectedFault, injected};

/// What a declared symbol stands for.
#[derive(Debug, Clone)]
pub enum SymbolKind {
    /// A real number of an interval.
    Real(Box<Interval>),
    /// An integer with bounds, both included.
    Integer {
        /// The least value.
        least: Option<Affine>,
        /// The greatest value.
        most: Option<Affine>,
    },
    /// A vector; `None` is one generic coordinate.
    Vector(Option<u8>),
    /// A family of points; dimension 1 is a family of scalars, `None` one generic coordinate.
    Family {
        /// The dimension of a member.
        dimension: Option<u8>,
        /// The range of each index, both ends included, if declared.
        ranges: Vec<(Affine, Affine)>,
    },
}

/// A declaration of which the file says where it is from.
#[derive(Debug, Clone)]
pub struct Range {
    /// Where it is from.
    pub provenance: Provenance,
    /// What the name stands for outside, if it is declared there.
    pub outer: Option<SymbolKind>,
    /// Where it stands.
    pub origin: Origin,
}

/// A named formula or function.
#[derive(Debug, Clone)]
pub struct Definition {
    /// The parameters; none for a plain name.
    pub parameters: Vec<String>,
    /// Whether the parameters are indices, `Q[i]`: integers, which stand in square brackets.
    pub indexed: bool,
    /// What it is.
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
    /// The names that stand in the step for i and k, if it depends on them.
    pub counters: Option<(String, String)>,
    /// Whether there is no step: the functions have one degree, and those of others are refused.
    pub is_list: bool,
}

/// Everything that names can mean in a claim.
#[derive(Debug, Clone, Default)]
pub struct Declarations {
    symbols: BTreeMap<String, SymbolKind>,
    /// Arbitrary smooth functions of one variable, by the dimension of their values, and what one of their derivatives
    /// at a place is.
    functions: BTreeMap<String, (Option<u8>, SymbolKind)>,
    bases: BTreeMap<String, Arc<Basis>>,
    definitions: BTreeMap<String, Definition>,
    /// Where declarations are from, as far as the files say it.
    ranges: BTreeMap<String, Range>,
    /// How names are printed.
    displays: BTreeMap<String, String>,
    /// Names whose declaration is wrong.
    wrong: BTreeSet<String>,
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

    /// Declares a smooth function, or replaces what the name meant.
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

    /// The same with one symbol declared, or declared otherwise.
    #[must_use]
    pub fn with_symbol(&self, name: &str, kind: SymbolKind) -> Self {
        let mut more = self.clone();
        more.symbols.insert(name.to_owned(), kind);
        more
    }

    /// The declared symbols by name.
    pub fn symbols(&self) -> impl Iterator<Item = (&str, &SymbolKind)> {
        self.symbols
            .iter()
            .map(|(name, kind)| (name.as_str(), kind))
    }

    /// Where the declaration of a symbol is from, if the file says it.
    #[must_use]
    pub fn range(&self, name: &str) -> Option<&Range> {
        self.ranges.get(name)
    }

    /// The symbols of whose declaration the file says where it is from.
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
        self.wrong.remove(&name);
        self.definitions.insert(name, definition);
    }

    /// Declares a number or replaces what the name meant; it may have any real value.
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

    /// Adds or replaces symbols; they hide definitions of the same name. Those that are wrong are marked as such.
    /// `own` is the id of the claim whose symbols they are, if they are those of one.
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
                        self.wrong.remove(name);
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
            self.wrong.remove(name);
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
    }

    /// Adds or replaces how names are printed.
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
            let known = self.names().any(|known| known == name) || self.wrong.contains(name);
            if inside.is_none_or(|inside| inside.is_empty() || inside.contains('$')) {
                let message = format!("`{}` is no mathematics: write `$...$`", text.get_ref());
                errors.0.push(at(message));
            } else if !known {
                let message = format!("`{name}` is not declared, so it is not displayed");
                errors.0.push(at(message));
            } else {
                self.displays.insert(name.clone(), text.get_ref().clone());
            }
        }
    }

    /// Adds or replaces basis families. Those that are wrong are marked as such.
    pub(super) fn add_bases(
        &mut self,
        source: &Arc<Source>,
        table: &BTreeMap<String, BasisEntry>,
        errors: &mut Errors,
    ) {
        for (name, entry) in table {
            match errors.keep(basis(source, name, entry)) {
                Some(basis) => {
                    self.wrong.remove(name);
                    self.bases.insert(name.clone(), Arc::new(basis));
                }
                None => self.mark_invalid([name.clone()]),
            }
        }
    }

    /// Marks names whose declaration is wrong.
    pub(super) fn mark_invalid(&mut self, names: impl IntoIterator<Item = String>) {
        self.wrong.extend(names);
    }

    /// Whether a declaration is wrong.
    pub(super) fn any_wrong(&self) -> bool {
        !self.wrong.is_empty()
    }

    /// Whether formulas mention a declaration that is wrong, be it through others.
    pub(super) fn depends_on_invalid<'e>(
        &'e self,
        formulas: impl Iterator<Item = &'e Expr>,
    ) -> bool {
        if self.wrong.is_empty() {
            return false;
        }
        let mut seen = BTreeSet::new();
        let mut pending: Vec<&Expr> = formulas.collect();
        while let Some(expr) = pending.pop() {
            for written in expr.names() {
                for name in [written, written.trim_end_matches('\'')] {
                    if self.wrong.contains(name) {
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

    /// A lower bound of an index form, from the bounds of the integer symbols in it.
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

    /// An upper bound of an index form.
    #[must_use]
    pub fn greatest(&self, form: &Affine) -> Option<i64> {
        self.least(&(form.clone() * -1)).map(|least| -least)
    }

    fn extreme(
        &self,
        form: &Affine,
        bound: impl Fn(&SymbolKind, bool) -> Option<Affine>,
    ) -> Option<i64> {
        // Bounds may name other symbols (i runs to k): replace until only a number is left.
        let mut rest = form.clone();
        for _ in 0..16 {
            if let Some(value) = rest.as_number() {
                return Some(value);
            }
            // Dependent symbols first: those whose bound names another symbol.
            let candidates: Vec<(String, i64)> = rest
                .multiples()
                .map(|(name, m)| (name.to_owned(), m))
                .collect();
            let replacement = candidates.iter().filter_map(|(name, multiple)| {
                let value = bound(self.symbols.get(name)?, *multiple > 0)?;
                Some((name, value))
            });
            let (name, value) = replacement.max_by_key(|(_, value)| value.as_number().is_none())?;
            rest = rest.substituted(name, &value);
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

/// Fails unless a declared name can be written.
fn check_name(origin: &Origin, name: &str) -> Result<(), LoadError> {
    match is_name(name) {
        true => Ok(()),
        false => Err(complaint(
            origin,
            format!(
                "`{name}` cannot be a name: names are letters, digits and `_`, and not words of the language"
            ),
        )),
    }
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

/// The dimension of the values of a smooth function. Nothing else is said of it.
fn smooth(
    source: &Arc<Source>,
    name: &str,
    entry: &SymbolEntry,
    values: &Spanned<Dimension>,
) -> Result<Option<u8>, LoadError> {
    let origin = Origin::range(source, values.span().start, values.span().end);
    check_name(&origin, name)?;
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

/// What a symbol is; it may say one thing only.
fn symbol_kind(
    source: &Arc<Source>,
    name: &str,
    entry: &SymbolEntry,
) -> Result<(SymbolKind, std::ops::Range<usize>), LoadError> {
    let text = |text: &Option<Spanned<String>>| text.as_ref().map(Spanned::span);
    let dimensions = |d: &Option<Spanned<Dimension>>| d.as_ref().map(Spanned::span);
    let said: Vec<_> = [
        text(&entry.interval),
        text(&entry.integer),
        dimensions(&entry.vector),
        dimensions(&entry.family),
    ]
    .into_iter()
    .flatten()
    .collect();
    let place = said.last().cloned().unwrap_or(0..0);
    let found = |kind| Ok((kind, place.clone()));
    let origin = Origin::range(source, place.start, place.end);
    check_name(&origin, name)?;
    if said.len() > 1 {
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
                    "`{}` is no integer range: write `>= 2`, `<= 5` or `0..k`",
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
                        format!("`{}` is no index range: write `0..k`", text.get_ref()),
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
    let form = |text: &str| affine_of(&parse(text).ok()?);
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

/// An integer-affine form written as a formula.
fn affine_of(expr: &Expr) -> Option<Affine> {
    use crate::formula::Operator::{Add, Multiply, Subtract};
    match &expr.node {
        Node::Number { value, .. } if value.is_integer() => {
            i64::try_from(value.to_integer()).ok().map(Affine::number)
        }
        Node::Name(name) => Some(Affine::symbol(name)),
        Node::Negative(inner) => Some(affine_of(inner)? * -1),
        Node::Binary(Add, a, b) => Some(affine_of(a)? + affine_of(b)?),
        Node::Binary(Subtract, a, b) => Some(affine_of(a)? - affine_of(b)?),
        Node::Binary(Multiply, a, b) => {
            let (a, b) = (affine_of(a)?, affine_of(b)?);
            a.as_number()
                .map(|n| b.clone() * n)
                .or_else(|| b.as_number().map(|n| a * n))
        }
        _ => None,
    }
}
