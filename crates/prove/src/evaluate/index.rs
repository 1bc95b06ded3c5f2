//! Indices: members of families and bases, entries of vectors and matrices, integer-affine forms.

use super::value::{Value, Vector};
use super::{Bindings, Evaluator, Outcome, generic, wrong_type};
use torse_algebra::{Affine, Fraction, Symbol};
use torse_language::derivation::declarations::SymbolKind;
use torse_language::fault::{Fault, Problem};
use torse_language::syntax::{Expr, Node, Place};

impl Evaluator<'_> {
    pub(super) fn indexed(
        &self,
        expr: &Expr,
        head: &Expr,
        indices: &[Expr],
        bound: &Bindings,
    ) -> Outcome<Value> {
        if let Node::Name(name) = &head.node
            && !bound.contains_key(name)
            && self.declarations.definition(name).is_none()
        {
            if let Some(basis) = self.declarations.basis(name) {
                return self.member(name, basis, indices, &[], expr.place, bound);
            }
            if let Some(SymbolKind::Family { dimension, ranges }) = self.declarations.symbol(name) {
                let index = indices
                    .iter()
                    .map(|i| self.index(i, bound))
                    .collect::<Outcome<Vec<_>>>()?;
                self.check_ranges(name, &index, ranges, indices)?;
                return Ok(match dimension {
                    Some(1) => self.leaf(Symbol::indexed(name, index)).into(),
                    None => generic(self.leaf(Symbol::indexed(name, index))),
                    Some(dimension) => {
                        let entry = |c: u8| {
                            let mut full = index.clone();
                            full.push(Affine::number(i64::from(c)));
                            self.leaf(Symbol::indexed(name, full)).into()
                        };
                        Value::Vector(Vector {
                            entries: (1..=*dimension).map(entry).collect(),
                            generic: false,
                        })
                    }
                });
            }
        }
        self.entry(expr, head, indices, bound)
    }

    pub(super) fn check_ranges(
        &self,
        name: &str,
        index: &[Affine],
        ranges: &[(Affine, Affine)],
        at: &[Expr],
    ) -> Outcome<()> {
        let place = at.first().map_or_else(Place::default, |e| e.place);
        if !ranges.is_empty() && ranges.len() != index.len() {
            return Err(Fault::at(
                place,
                Problem::Count {
                    name: name.to_owned(),
                    wanted: format!("{} indices", ranges.len()),
                    found: index.len(),
                },
            ));
        }
        for ((index, (least, most)), expr) in index.iter().zip(ranges).zip(at) {
            let fix = |form: &Affine| self.affine_fixed(form);
            let (least, most) = (fix(least), fix(most));
            let outside = |gap: Affine| self.declarations.least(&gap).is_some_and(|gap| gap > 0);
            if outside(least.clone() - index.clone()) || outside(index.clone() - most.clone()) {
                return Err(Fault::at(
                    expr.place,
                    Problem::IndexOutside {
                        name: name.to_owned(),
                        index: index.to_string(),
                        range: format!("{least}..{most}"),
                    },
                ));
            }
        }
        Ok(())
    }

    /// An index form with the fixed integers put in.
    pub(super) fn affine_fixed(&self, form: &Affine) -> Affine {
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
        expr: &Expr,
        head: &Expr,
        indices: &[Expr],
        bound: &Bindings,
    ) -> Outcome<Value> {
        let value = self.value(head, bound)?;
        let position = |expr: &Expr, length: usize, what: &str| -> Outcome<usize> {
            let index = self.index(expr, bound)?;
            let outside = || {
                Fault::at(
                    expr.place,
                    Problem::IndexOutside {
                        name: what.to_owned(),
                        index: index.to_string(),
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
        .ok_or_else(|| wrong_type(expr.place, "nothing", "an entry"))
    }

    /// An integer-affine index.
    pub(super) fn index(&self, expr: &Expr, bound: &Bindings) -> Outcome<Affine> {
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
                        [(Symbol::Named(name), 1)] => Some(form + Affine::symbol(name) * n),
                        _ => None,
                    }
                })
            });
        form.ok_or_else(|| wrong_type(expr.place, "a formula", "an integer such as k - 2"))
    }
}
