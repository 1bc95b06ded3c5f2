//! Members of declared families and of basis families.

use super::binders::{Local, Scope};
use super::{Elaborator, Meaning, Outcome, counted, wrong};
use std::sync::Arc;
use torse_core::{Family, Node, Points, Statement, Variable};
use torse_numbers::fault_injection::{InjectedFault, injected};
use torse_numbers::rational;
use torse_syntax::derivation::declarations::{Basis, SymbolKind};
use torse_syntax::fault::{Fault, Problem};
use torse_syntax::formula::{self, Connective, Expr, Place, Relation};

impl Elaborator<'_> {
    pub(super) fn indexed(
        &self,
        head: &Expr,
        indices: &[Expr],
        place: Place,
        scope: &Scope,
    ) -> Outcome<Meaning> {
        if let formula::Node::Name(name) = &head.node
            && let Some(definition) = self.indexed_definition(name, scope)
        {
            let meaning = self.definition(name, definition, place, &scope.outside())?;
            let Meaning::Function(function) = meaning else {
                return Err(wrong(place, meaning.kind(), "a member of a family"));
            };
            let values = self.terms_in(indices, scope)?;
            return self.applied(&function, values, place).map(Meaning::Term);
        }
        if let formula::Node::Name(name) = &head.node
            && !scope.locals.contains_key(name)
            && self.declarations.definition(name).is_none()
        {
            if let Some(basis) = self.declarations.basis(name) {
                return self.member(name, basis, indices, &[], place, scope);
            }
            if let Some(SymbolKind::Family { dimension, ranges }) = self.declarations.symbol(name) {
                // Findings write the coordinate of a point as one more index.
                if let Some((coordinate, indices)) = indices.split_last()
                    && indices.len() == ranges.len()
                    && !ranges.is_empty()
                    && dimension.is_some_and(|n| n > 1)
                {
                    let point = self.indexed(head, indices, place, scope)?;
                    let Meaning::Term(point) = point else {
                        return Ok(point);
                    };
                    let coordinate = self.terms_in(std::slice::from_ref(coordinate), scope)?;
                    let entry = Node::Entry(point, coordinate);
                    return Ok(Meaning::Term(self.made(entry, place)));
                }
                if !ranges.is_empty() && ranges.len() != indices.len() {
                    return Err(Fault::at(
                        place,
                        Problem::Count {
                            name: name.clone(),
                            wanted: match ranges.len() {
                                1 => "1 index".to_owned(),
                                n => format!("{n} indices"),
                            },
                            found: indices.len(),
                        },
                    ));
                }
                let points = Arc::clone(
                    self.points
                        .borrow_mut()
                        .entry(name.clone())
                        .or_insert_with(|| {
                            Arc::new(Points {
                                name: Arc::from(name.as_str()),
                                dimension: *dimension,
                                ranges: ranges.clone(),
                            })
                        }),
                );
                let indices = self.terms_in(indices, scope)?;
                return Ok(Meaning::Term(
                    self.made(Node::Member(points, indices), place),
                ));
            }
        }
        let head = self.term_in(head, scope)?;
        let indices = self.terms_in(indices, scope)?;
        Ok(Meaning::Term(self.made(Node::Entry(head, indices), place)))
    }

    pub(super) fn member(
        &self,
        name: &str,
        basis: &Basis,
        indices: &[Expr],
        arguments: &[Expr],
        place: Place,
        scope: &Scope,
    ) -> Outcome<Meaning> {
        let [index, degree] = indices else {
            return Err(Fault::at(
                place,
                Problem::Count {
                    name: name.to_owned(),
                    wanted: "two indices: which function, and the degree".to_owned(),
                    found: indices.len(),
                },
            ));
        };
        if basis.is_list && !is_number(degree, basis.degree) {
            return Err(wrong(
                degree.place,
                "another degree",
                "the degree of the functions that are listed: the basis has no `step`",
            ));
        }
        if arguments.len() > basis.parameters.len() + 1 {
            let parameters = counted(basis.parameters.len(), "shape parameter");
            return Err(Fault::at(
                place,
                Problem::Count {
                    name: name.to_owned(),
                    wanted: format!("a variable and {parameters}"),
                    found: arguments.len(),
                },
            ));
        }
        let mut all = self.terms_in(arguments, scope)?;
        let names = std::iter::once(&basis.variable).chain(&basis.parameters);
        for left_out in names.skip(arguments.len()) {
            if scope.locals.contains_key(left_out) {
                return Err(Fault::at(
                    place,
                    Problem::LeftOut {
                        family: name.to_owned(),
                        argument: left_out.clone(),
                    },
                ));
            }
            let outside = if injected(InjectedFault::LeftOutNotMoved) {
                Scope::default()
            } else {
                scope.outside()
            };
            match self.named(left_out, place, &outside)? {
                Meaning::Term(term) => all.push(term),
                other => return Err(wrong(place, other.kind(), "a number")),
            }
        }
        let node = Node::Basis {
            family: self.family_of(name, basis, &scope.outside())?,
            index: self.term_in(index, scope)?,
            degree: self.term_in(degree, scope)?,
            arguments: all,
        };
        Ok(Meaning::Term(self.made(node, place)))
    }

    /// The statement that all functions of the list are nonnegative.
    pub(super) fn all_nonnegative(
        &self,
        name: &str,
        basis: &Basis,
        place: Place,
        scope: &Scope,
    ) -> Outcome<Statement> {
        let number = |n: i64| Expr {
            place,
            ..Expr::number(&rational::integer(n))
        };
        let degree = number(i64::from(basis.degree));
        let mut all: Option<Statement> = None;
        for i in 0..=i64::from(basis.degree) {
            let indices = [number(i), degree.clone()];
            let Meaning::Term(left) = self.member(name, basis, &indices, &[], place, scope)? else {
                continue;
            };
            let one = Statement::Compare {
                relation: Relation::AtLeast,
                left,
                right: self.made(Node::Number(rational::integer(0)), place),
            };
            all = Some(match all {
                None => one,
                Some(before) => Statement::Join(Connective::And, Box::new(before), Box::new(one)),
            });
        }
        all.ok_or_else(|| wrong(place, "a list without functions", "a list of functions"))
    }

    /// The family, in a scope of replaced symbols. If there are none, the family is opened once and cached.
    pub(super) fn family_of(
        &self,
        name: &str,
        basis: &Basis,
        outside: &Scope,
    ) -> Outcome<Arc<Family>> {
        let closed = outside.globals.is_empty();
        if closed && let Some(family) = self.families.borrow().get(name) {
            return Ok(Arc::clone(family));
        }
        let names: Vec<&String> = std::iter::once(&basis.variable)
            .chain(&basis.parameters)
            .collect();
        let variables: Vec<Variable> = names.iter().map(|n| self.fresh(n)).collect();
        let scope = names
            .iter()
            .zip(&variables)
            .fold(outside.clone(), |scope, (name, variable)| {
                scope.with_local(name, variable, Local::Continuous)
            });
        let counters = basis
            .counters
            .as_ref()
            .map(|(index, order)| (self.fresh(index), self.fresh(order)));
        let counted = counters
            .iter()
            .flat_map(|(index, order)| [index, order])
            .fold(scope.clone(), |scope, counter| {
                scope.with_local(counter.name(), counter, Local::Index)
            });
        let part = |written: &torse_syntax::derivation::Written, scope: &Scope| {
            let body = self
                .term_in(&written.expr, scope)
                .map_err(|f| f.within(&written.origin))?;
            let node = Node::Opened {
                name: Arc::from(name),
                origin: Arc::new(written.origin.clone()),
                closed: false,
                body,
            };
            Ok(self.made(node, written.expr.place))
        };
        let (a, b) = if injected(InjectedFault::StepFactorsExchanged) {
            (&basis.step.1, &basis.step.0)
        } else {
            (&basis.step.0, &basis.step.1)
        };
        let family = Arc::new(Family {
            name: Arc::from(name),
            variables,
            degree: basis.degree,
            seeds: basis
                .seeds
                .iter()
                .map(|seed| part(seed, &scope))
                .collect::<Outcome<_>>()?,
            step: (part(a, &counted)?, part(b, &counted)?),
            counters,
            closed,
        });
        if closed {
            self.families
                .borrow_mut()
                .insert(name.to_owned(), Arc::clone(&family));
        }
        Ok(family)
    }
}

/// Whether a formula is this literal number.
fn is_number(expr: &Expr, number: u8) -> bool {
    let wanted = rational::integer(i64::from(number));
    matches!(&expr.node, formula::Node::Number { value, .. } if *value == wanted)
}
