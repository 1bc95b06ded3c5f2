//! Where indices, places of lists and degrees are in their ranges.

use super::kinds::Kind;
use super::premises::{Premises, integers, plain};
use super::scope::Scope;
use super::writer::Writer;
use crate::code::{Code, Level};
use crate::gap::Untranslatable;
use crate::shape::Shape;
use torse_numbers::Affine;
use torse_syntax::derivation::declarations::{Basis, SymbolKind};
use torse_syntax::formula::{Expr, Node};

impl Writer<'_> {
    /// The premises of a member of a family or a list, of an indexed definition, or of a basis with its arguments left out.
    ///
    /// # Errors
    /// [`Untranslatable`], as for the value.
    pub fn index_defined(
        &mut self,
        head: &Expr,
        indices: &[Expr],
        scope: &Scope,
        premises: &mut Premises,
    ) -> Result<(), Untranslatable> {
        let bound = scope.bound();
        if let Node::Name(name) = &head.node {
            if self
                .names
                .definition(name, &bound)
                .is_some_and(|d| d.indexed)
            {
                return self.application_defined(head, indices, scope, premises);
            }
            if let Some(basis) = self.names.basis(name, &bound) {
                return self.member_defined(basis, name, indices, &[], scope, premises);
            }
            if self.names.is_symbol(name, &bound)
                && let Some(SymbolKind::Family { dimension, ranges }) =
                    self.names.declarations.symbol(name)
            {
                let has_place = indices.len() == ranges.len() + 1
                    && !ranges.is_empty()
                    && dimension.is_some_and(|n| n > 1);
                let (place, indices) = match indices.split_last() {
                    Some((place, indices)) if has_place => (Some(place), indices),
                    _ => (None, indices),
                };
                for index in indices {
                    self.defined(index, scope, premises)?;
                }
                self.in_range(ranges, indices, scope, premises)?;
                let Some(place) = place else {
                    return Ok(());
                };
                self.defined(place, scope, premises)?;
                let length = dimension.map_or(0, usize::from);
                return self.in_list(&[length], std::slice::from_ref(place), scope, premises);
            }
        }
        self.defined(head, scope, premises)?;
        for index in indices {
            self.defined(index, scope, premises)?;
        }
        if indices
            .iter()
            .all(|index| self.literal(index, scope).is_some())
        {
            return Ok(());
        }
        let lengths = match self.value(head, scope)?.shape {
            Shape::Number => vec![],
            Shape::Vector(length) => vec![length],
            Shape::Matrix(rows, columns) => vec![rows, columns],
        };
        self.in_list(&lengths, indices, scope, premises)
    }

    /// A place that is a symbol is one of those of its list.
    fn in_list(
        &mut self,
        lengths: &[usize],
        indices: &[Expr],
        scope: &Scope,
        premises: &mut Premises,
    ) -> Result<(), Untranslatable> {
        for (index, length) in indices.iter().zip(lengths) {
            if self.literal(index, scope).is_none() {
                let place = plain(&self.index(index, scope)?);
                premises.add(integers(format!("1 <= {place} <= {length}")));
            }
        }
        Ok(())
    }

    fn in_range(
        &mut self,
        ranges: &[(Affine, Affine)],
        indices: &[Expr],
        scope: &Scope,
        premises: &mut Premises,
    ) -> Result<(), Untranslatable> {
        for ((low, high), index) in ranges.iter().zip(indices) {
            if let (Some(low), Some(high), Some(index)) = (
                low.as_number(),
                high.as_number(),
                self.constant_value(index, scope),
            ) && (low..=high).contains(&index)
            {
                continue;
            }
            let code = self.integer(index, scope);
            let code = code.ok_or(Untranslatable::Construct(
                "an index that is not made of integers",
            ))?;
            let (low, high) = (self.affine(low)?, self.affine(high)?);
            let index = code.within(Level::Sum);
            premises.add(integers(format!("{low} <= {index} <= {high}")));
        }
        Ok(())
    }

    /// The premises of a function of a basis.
    ///
    /// # Errors
    /// [`Untranslatable`], as for the value.
    pub fn member_defined(
        &mut self,
        basis: &Basis,
        name: &str,
        indices: &[Expr],
        arguments: &[Expr],
        scope: &Scope,
        premises: &mut Premises,
    ) -> Result<(), Untranslatable> {
        let given = self.arguments(basis, arguments, scope)?;
        for part in indices {
            self.defined(part, scope, premises)?;
        }
        for (argument, scope) in &given {
            self.defined(argument, scope, premises)?;
        }
        let [_, degree] = indices else {
            return Err(Untranslatable::Unread(format!(
                "`{name}` without index and degree"
            )));
        };
        let lowest = i64::from(basis.degree);
        if self
            .literal(degree, scope)
            .is_none_or(|degree| degree < lowest)
        {
            let degree = self.integer(degree, scope);
            let degree = degree.ok_or(Untranslatable::Construct(
                "a degree that is not made of integers",
            ))?;
            let degree = degree.within(Level::Sum);
            premises.add(integers(format!("{lowest} <= {degree}")));
        }
        let mut inside = scope.outside();
        let names = std::iter::once(&basis.variable).chain(&basis.parameters);
        for ((variable, (argument, scope)), kind) in
            names.zip(&given).zip(self.names.kinds_of_basis(name))
        {
            let (code, kind) = self.argument(argument, kind, scope)?;
            inside = inside.with_local(variable, Code::atom(code.argument()), kind);
        }
        for seed in &basis.seeds {
            self.defined(&seed.expr, &inside, premises)?;
        }
        let step = [&basis.step.0.expr, &basis.step.1.expr];
        let Some((index, order)) = &basis.counters else {
            for factor in step {
                self.defined(factor, &inside, premises)?;
            }
            return Ok(());
        };
        // The factors that count up to the degree that is named.
        let highest = self
            .literal(degree, scope)
            .or_else(|| self.constant_value(degree, scope));
        let highest = highest.ok_or(Untranslatable::Construct(
            "a basis of symbolic degree whose step depends on the index",
        ))?;
        let number = |n: i64| Code::atom(format!("{n}%Z"));
        for k in lowest + 1..=highest {
            for i in 0..=k {
                let counted = inside
                    .with_local(order, number(k), Kind::Integer)
                    .with_local(index, number(i), Kind::Integer);
                let [a, b] = step;
                if i < k {
                    self.defined(a, &counted, premises)?;
                }
                if i > 0 {
                    self.defined(b, &counted, premises)?;
                }
            }
        }
        Ok(())
    }
}
