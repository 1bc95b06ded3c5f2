//! Indices: members of families and bases, entries of vectors and matrices, integer-affine forms.

use super::own_names::in_words;
use super::value::{Value, Vector};
use super::{Environment, Evaluator, Outcome, generic, wrong_type};
use torse_algebra::{Affine, Fraction, Symbol};
use torse_core::{Points, Term};
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::fault::{Fault, Problem};
use torse_syntax::formula::Place;

/// An end of a range.
#[derive(Debug, Clone, Copy)]
enum End {
    First,
    Last,
}

impl Evaluator<'_> {
    /// The member of a declared family.
    pub(super) fn point(
        &self,
        points: &Points,
        indices: &[Term],
        bound: &Environment,
    ) -> Outcome<Value> {
        let name = &*points.name;
        let index = indices
            .iter()
            .map(|i| self.index(i, bound))
            .collect::<Outcome<Vec<_>>>()?;
        self.check_ranges(points, &index, indices)?;
        Ok(match points.dimension {
            Some(1) => self.leaf(Symbol::indexed(name, index)).into(),
            None => generic(self.leaf(Symbol::indexed(name, index))),
            Some(dimension) => {
                let entry = |c: u8| {
                    let mut full = index.clone();
                    full.push(Affine::number(i64::from(c)));
                    self.leaf(Symbol::indexed(name, full)).into()
                };
                Value::Vector(Vector {
                    entries: (1..=dimension).map(entry).collect(),
                    generic: false,
                })
            }
        })
    }

    /// Refuses an index that leaves its declared range, for all values of the integers.
    fn check_ranges(&self, points: &Points, index: &[Affine], at: &[Term]) -> Outcome<()> {
        for ((index, (least, most)), term) in index.iter().zip(&points.ranges).zip(at) {
            let (least, most) = (self.affine_fixed(least), self.affine_fixed(most));
            // Where the index of a sum of symbolic length stands in it, both of its ends count.
            let outside = [
                self.end_of(index, End::Last),
                self.end_of(index, End::First),
            ]
            .into_iter()
            .any(|end| {
                let outside =
                    |gap: Affine| self.declarations.least(&gap).is_some_and(|gap| gap > 0);
                outside(least.clone() - end.clone()) || outside(end - most.clone())
            });
            if outside {
                return Err(Fault::at(
                    term.place,
                    Problem::IndexOutside {
                        name: points.name.to_string(),
                        index: in_words(&index.to_string()),
                        range: format!("{least}..{most}"),
                    },
                ));
            }
        }
        Ok(())
    }

    /// The index form with the indices of enclosing sums at their first or last value.
    fn end_of(&self, form: &Affine, end: End) -> Affine {
        let sums = self.sums.borrow();
        sums.iter()
            .rev()
            .fold(form.clone(), |form, (name, low, high)| {
                form.substituted(
                    name,
                    match end {
                        End::First => low,
                        End::Last => high,
                    },
                )
            })
    }

    /// An index form with the fixed integers put in.
    pub(crate) fn affine_fixed(&self, form: &Affine) -> Affine {
        self.fixed.iter().fold(form.clone(), |form, (name, value)| {
            match value
                .as_rational()
                .filter(torse_algebra::Rational::is_integer)
            {
                Some(n) => i64::try_from(n.to_integer())
                    .map_or(form.clone(), |n| form.substituted(name, &Affine::number(n))),
                None => form,
            }
        })
    }

    /// The entry of a vector or matrix, counted from 1.
    pub(super) fn entry(
        &self,
        place: Place,
        head: &Term,
        indices: &[Term],
        bound: &Environment,
    ) -> Outcome<Value> {
        let value = self.value(head, bound)?;
        let position = |expr: &Term, length: usize, what: &str| -> Outcome<usize> {
            let index = self.index(expr, bound)?;
            if index.as_number().is_none() {
                let what = format!(
                    "an entry at the place {index}, which is no number: state it for each place"
                );
                return Err(Fault::limit(expr.place, what));
            }
            let outside = || {
                Fault::at(
                    expr.place,
                    Problem::IndexOutside {
                        name: what.to_owned(),
                        index: in_words(&index.to_string()),
                        range: format!("1..{length}"),
                    },
                )
            };
            index
                .as_number()
                .and_then(|n| usize::try_from(n).ok())
                .filter(|n| (1..=length).contains(n))
                .map(|n| n - 1)
                .ok_or_else(outside)
        };
        match (value, indices) {
            (Value::Vector(v), [i]) if !v.generic => {
                let i = position(i, v.entries.len(), "the vector")?;
                v.entries.into_iter().nth(i).map(Value::Scalar)
            }
            (Value::Matrix(rows), [i]) => {
                let i = position(i, rows.len(), "the rows")?;
                rows.into_iter().nth(i).map(|entries| {
                    Value::Vector(Vector {
                        entries,
                        generic: false,
                    })
                })
            }
            (Value::Matrix(rows), [i, j]) => {
                let i = position(i, rows.len(), "the rows")?;
                let j = position(j, rows.first().map_or(0, Vec::len), "the columns")?;
                rows.into_iter()
                    .nth(i)
                    .and_then(|row| row.into_iter().nth(j))
                    .map(Value::Scalar)
            }
            (value, _) => {
                return Err(wrong_type(
                    head.place,
                    value.kind(),
                    "something with so many indices",
                ));
            }
        }
        .ok_or_else(|| wrong_type(place, "nothing", "an entry"))
    }

    /// Whether a name may stand in an index: a declared integer, or the index of a sum.
    fn may_be_index(&self, name: &str) -> bool {
        match self.declarations.symbol(name) {
            Some(kind) => matches!(kind, SymbolKind::Integer { .. }),
            None => true,
        }
    }

    /// The integer form that a closed term is, if it is one.
    pub(crate) fn integer_form(&self, term: &Term) -> Option<Affine> {
        self.index(term, &Environment::new()).ok()
    }

    /// An integer-affine index.
    pub(super) fn index(&self, expr: &Term, bound: &Environment) -> Outcome<Affine> {
        let value = self.value(expr, bound)?;
        let Value::Scalar(quantity) = &value else {
            return Err(wrong_type(expr.place, value.kind(), "an integer"));
        };
        let form = quantity
            .as_fraction()
            .and_then(Fraction::as_polynomial)
            .and_then(|p| {
                p.terms().try_fold(Affine::default(), |form, term| {
                    let n = term
                        .coefficient
                        .is_integer()
                        .then(|| i64::try_from(term.coefficient.to_integer()).ok())??;
                    match term.powers.as_slice() {
                        [] => Some(form + Affine::number(n)),
                        [(Symbol::Named(name), 1)] if self.may_be_index(name) => {
                            Some(form + Affine::symbol(name) * n)
                        }
                        _ => None,
                    }
                })
            });
        form.ok_or_else(|| wrong_type(expr.place, "a formula", "an integer such as k - 2"))
    }
}
