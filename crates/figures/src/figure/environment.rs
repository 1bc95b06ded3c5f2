//! The meaning of names inside a figure: the declarations of its file, and the values that the figure gives to symbols.
//!
//! A value of a real number or an integer is fixed in the evaluator; a value of a vector or of a family of
//! points stands for its members. So `G(x)` of a paper, a sum over generic points `R[i]` of symbolic degree k,
//! becomes one curve once `k` and `R` are set: the figure draws the paper's own definition.

use super::{Faulty, in_file_order};
use std::collections::BTreeMap;
use std::sync::Arc;
use torse_algebra::{Affine, Fraction, Symbol};
use torse_prove::context::solve_given;
use torse_prove::evaluate::Evaluator;
use torse_prove::evaluate::quantity::Quantity;
use torse_prove::evaluate::value::Value;
use torse_syntax::derivation::declarations::{Declarations, SymbolKind};
use torse_syntax::derivation::schema::Text;
use torse_syntax::derivation::{DerivationError, Origin, Source, Written, parsed};
use torse_syntax::formula::Place;

/// The most points of a list.
pub(super) const MAX_POINTS: i64 = 10_000;

/// Declarations with values for some of the symbols.
#[derive(Clone)]
pub(super) struct Environment<'a> {
    pub source: &'a Arc<Source>,
    declarations: Arc<Declarations>,
    fixed: BTreeMap<String, Fraction>,
    solved: BTreeMap<Symbol, Fraction>,
}

impl<'a> Environment<'a> {
    pub fn new(source: &'a Arc<Source>, declarations: &Arc<Declarations>) -> Self {
        Self {
            source,
            declarations: Arc::clone(declarations),
            fixed: BTreeMap::new(),
            solved: BTreeMap::new(),
        }
    }

    /// The declared kind of a symbol.
    pub fn kind(&self, name: &str) -> Option<&SymbolKind> {
        self.declarations.symbol(name)
    }

    /// Evaluates a formula of the file.
    fn value(&self, text: &Text) -> Faulty<Value> {
        evaluated(&self.evaluator(), &parsed(self.source, text)?)
    }

    /// The evaluator.
    pub fn evaluator(&self) -> Evaluator<'_> {
        let mut evaluator = Evaluator::new(&self.declarations).fixing(&self.fixed);
        evaluator.determine(self.solved.clone());
        evaluator
    }

    /// Solves linear equations for unknowns, which then have values.
    pub fn solve(&mut self, given: &[Text], unknowns: &[Text]) -> Faulty<()> {
        let Some(text) = given.first() else {
            return Ok(());
        };
        let all = |texts: &[Text]| -> Faulty<Vec<Written>> {
            texts.iter().map(|text| parsed(self.source, text)).collect()
        };
        let solution =
            solve_given(&all(given)?, &all(unknowns)?, &self.evaluator()).map_err(|fault| {
                Box::new(fault.into_error(&Origin::from_spanned(self.source, text)))
            })?;
        self.solved.extend(solution);
        Ok(())
    }

    /// Returns the numbers and integers with a value.
    pub fn fixed(&self) -> &BTreeMap<String, Fraction> {
        &self.fixed
    }

    /// Fixes a number or an integer.
    pub fn fix(&mut self, name: &str, value: Fraction) {
        self.fixed.insert(name.to_owned(), value);
    }

    /// Fixes those symbols that are integers.
    pub fn set_integers(&mut self, table: &BTreeMap<String, Text>) -> Faulty<()> {
        for (name, text) in in_file_order(table) {
            if let Some(SymbolKind::Integer { .. }) = self.kind(name) {
                self.set(name, text)?;
            }
        }
        Ok(())
    }

    /// Fixes a symbol by a formula: a number, a vector, or a family of points as a matrix.
    pub fn set(&mut self, name: &str, text: &Text) -> Faulty<()> {
        let value = self.value(text)?;
        let entries = |quantities: &[Quantity]| -> Faulty<Vec<Fraction>> {
            quantities
                .iter()
                .map(|q| fraction(self.source, text, q))
                .collect()
        };
        let kind = self.declared(name, text)?.clone();
        match (kind, value) {
            (SymbolKind::Real(_) | SymbolKind::Integer { .. }, Value::Scalar(q)) => {
                let value = fraction(self.source, text, &q)?;
                self.fix(name, value);
            }
            (SymbolKind::Vector(_), Value::Vector(v)) => {
                let dimension = u8::try_from(v.entries.len()).ok();
                self.members(name, &[], &entries(&v.entries)?);
                self.declare(name, SymbolKind::Vector(dimension));
            }
            (SymbolKind::Family { ranges, .. }, Value::Vector(v)) => {
                for (i, value) in (first(&ranges)..).zip(entries(&v.entries)?) {
                    let symbol = Symbol::indexed(name, vec![Affine::number(i)]);
                    self.solved.insert(symbol, value);
                }
                let dimension = Some(1);
                self.declare(name, SymbolKind::Family { dimension, ranges });
            }
            (SymbolKind::Family { ranges, .. }, Value::Matrix(rows)) => {
                let rows = rows
                    .iter()
                    .map(|row| entries(row))
                    .collect::<Faulty<Vec<_>>>()?;
                for (i, row) in (first(&ranges)..).zip(&rows) {
                    self.members(name, &[i], row);
                }
                let dimension = rows.first().and_then(|row| u8::try_from(row.len()).ok());
                self.declare(name, SymbolKind::Family { dimension, ranges });
            }
            (SymbolKind::Real(_) | SymbolKind::Integer { .. }, other) => {
                return Err(wrong(self.source, text, other.kind(), "a number"));
            }
            (SymbolKind::Vector(_), other) => {
                return Err(wrong(self.source, text, other.kind(), "a vector"));
            }
            (SymbolKind::Family { .. }, other) => {
                return Err(wrong(
                    self.source,
                    text,
                    other.kind(),
                    "a matrix, one row a point,",
                ));
            }
        }
        Ok(())
    }

    /// Fixes a family with two indices, with a matrix for each first index.
    pub fn set_net(&mut self, name: &str, rows: &[Text]) -> Faulty<()> {
        for (offset, text) in (0..).zip(rows) {
            let kind = self.declared(name, text)?.clone();
            let (SymbolKind::Family { ranges, .. }, Value::Matrix(points)) =
                (kind, self.value(text)?)
            else {
                return Err(wrong(
                    self.source,
                    text,
                    "something else",
                    "a row of points of a family with two indices",
                ));
            };
            let second = ranges
                .get(1)
                .and_then(|(low, _)| low.as_number())
                .unwrap_or(0);
            for (j, point) in (second..).zip(&points) {
                let point = point
                    .iter()
                    .map(|q| fraction(self.source, text, q))
                    .collect::<Faulty<Vec<_>>>()?;
                self.members(name, &[first(&ranges) + offset, j], &point);
            }
            let dimension = points
                .first()
                .and_then(|point| u8::try_from(point.len()).ok());
            self.declare(name, SymbolKind::Family { dimension, ranges });
        }
        Ok(())
    }

    fn declare(&mut self, name: &str, kind: SymbolKind) {
        Arc::make_mut(&mut self.declarations).declare(name, kind);
    }

    /// Fixes the coordinates of a vector or of a member of a family.
    fn members(&mut self, name: &str, index: &[i64], coordinates: &[Fraction]) {
        for (c, value) in (1..).zip(coordinates) {
            let full = index
                .iter()
                .copied()
                .chain([c])
                .map(Affine::number)
                .collect();
            self.solved
                .insert(Symbol::indexed(name, full), value.clone());
        }
    }

    /// Returns the kind of a symbol that a text fixes.
    pub fn declared(&self, name: &str, text: &Text) -> Faulty<&SymbolKind> {
        self.kind(name).ok_or_else(|| {
            let error = complaint(self.source, text, format!("`{name}` is no declared symbol"));
            Box::new(error.with_help("declare it under [symbols] or in the figure's `symbols`"))
        })
    }
}

/// Evaluates a parsed formula.
pub(super) fn evaluated(evaluator: &Evaluator<'_>, formula: &Written) -> Faulty<Value> {
    evaluator
        .evaluate(&formula.expr)
        .map_err(|fault| Box::new(fault.into_error(&formula.origin)))
}

/// Returns the first index of a family.
fn first(ranges: &[(Affine, Affine)]) -> i64 {
    ranges
        .first()
        .and_then(|(low, _)| low.as_number())
        .unwrap_or(0)
}

/// Returns the exact value of a quantity, which must not be a sum of symbolic degree.
pub(super) fn fraction(source: &Arc<Source>, text: &Text, quantity: &Quantity) -> Faulty<Fraction> {
    quantity.as_fraction().cloned().ok_or_else(|| {
        let error = complaint(source, text, "the degree is still symbolic");
        Box::new(error.with_help("give it a value with `set`, for instance `set = { k = '3' }`"))
    })
}

/// Makes an error about the whole text of a formula.
pub(super) fn complaint(
    source: &Arc<Source>,
    text: &Text,
    message: impl Into<String>,
) -> DerivationError {
    let origin = Origin::from_spanned(source, text);
    let place = Place {
        start: 0,
        end: text.get_ref().len(),
    };
    DerivationError::at(&origin, place, message)
}

/// Makes an error about a value of the wrong type.
pub(super) fn wrong(
    source: &Arc<Source>,
    text: &Text,
    what: &str,
    wanted: &str,
) -> Box<DerivationError> {
    Box::new(complaint(
        source,
        text,
        format!("{what} where {wanted} is needed"),
    ))
}
