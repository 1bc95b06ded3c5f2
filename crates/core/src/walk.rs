//! Traversal of core terms and statements.

use super::visited::Visited;
use super::{BuiltIn, Family, Node, Statement, Term, Variable};
use std::sync::Arc;
use torse_numbers::rational::integer;
use torse_syntax::formula::Connective;

impl Term {
    /// The direct parts, in the order of the text.
    #[must_use]
    pub fn parts(&self) -> Vec<&Term> {
        let mut parts = vec![];
        self.each_part(&mut |part| parts.push(part));
        parts
    }

    /// Calls `visit` with each direct part, in the order of the text.
    fn each_part<'t>(&'t self, visit: &mut impl FnMut(&'t Term)) {
        match &*self.node {
            Node::Number(_) | Node::Pi | Node::Symbol(_) | Node::Variable(_) | Node::Vector(..) => {
            }
            Node::Member(_, items) | Node::List(items) | Node::Apply(_, items) => {
                items.iter().for_each(visit);
            }
            Node::Basis {
                index,
                degree,
                arguments,
                ..
            } => [index, degree].into_iter().chain(arguments).for_each(visit),
            Node::Negative(inner) | Node::Opened { body: inner, .. } => visit(inner),
            Node::Binary(_, a, b) => [a, b].into_iter().for_each(visit),
            Node::Entry(of, indices) => std::iter::once(of).chain(indices).for_each(visit),
            Node::Sum {
                low, high, term, ..
            }
            | Node::Product {
                low, high, term, ..
            } => [low, high, term].into_iter().for_each(visit),
            Node::Integral {
                low, high, body, ..
            } => [low, high, body].into_iter().for_each(visit),
            Node::Let { value, body, .. } => [value, body].into_iter().for_each(visit),
            Node::Derivative {
                order, body, at, ..
            } => [order, body, at].into_iter().for_each(visit),
        }
    }

    /// Rebuilds the term with each direct part changed.
    ///
    /// # Errors
    /// The errors of `change`.
    pub fn with_parts<E>(
        &self,
        change: &mut dyn FnMut(&Term) -> Result<Term, E>,
    ) -> Result<Self, E> {
        let mut all = |items: &[Term]| items.iter().map(&mut *change).collect::<Result<_, E>>();
        let node = match &*self.node {
            Node::Number(_) | Node::Pi | Node::Symbol(_) | Node::Variable(_) | Node::Vector(..) => {
                return Ok(self.clone());
            }
            Node::Member(points, indices) => Node::Member(Arc::clone(points), all(indices)?),
            Node::List(items) => Node::List(all(items)?),
            Node::Apply(function, arguments) => Node::Apply(*function, all(arguments)?),
            Node::Basis {
                family,
                index,
                degree,
                arguments,
            } => Node::Basis {
                family: Arc::clone(family),
                arguments: all(arguments)?,
                index: change(index)?,
                degree: change(degree)?,
            },
            Node::Negative(inner) => Node::Negative(change(inner)?),
            Node::Opened {
                name,
                origin,
                closed,
                body,
            } => Node::Opened {
                name: Arc::clone(name),
                origin: Arc::clone(origin),
                closed: *closed,
                body: change(body)?,
            },
            Node::Binary(operator, a, b) => Node::Binary(*operator, change(a)?, change(b)?),
            Node::Entry(of, indices) => Node::Entry(change(of)?, {
                indices.iter().map(change).collect::<Result<_, E>>()?
            }),
            Node::Sum {
                index,
                low,
                high,
                term,
            } => Node::Sum {
                index: index.clone(),
                low: change(low)?,
                high: change(high)?,
                term: change(term)?,
            },
            Node::Product {
                index,
                low,
                high,
                term,
            } => Node::Product {
                index: index.clone(),
                low: change(low)?,
                high: change(high)?,
                term: change(term)?,
            },
            Node::Integral {
                variable,
                low,
                high,
                body,
            } => Node::Integral {
                variable: variable.clone(),
                low: change(low)?,
                high: change(high)?,
                body: change(body)?,
            },
            Node::Let {
                variable,
                value,
                body,
            } => Node::Let {
                variable: variable.clone(),
                value: change(value)?,
                body: change(body)?,
            },
            Node::Derivative {
                variable,
                order,
                body,
                closed,
                at,
            } => Node::Derivative {
                variable: variable.clone(),
                order: change(order)?,
                body: change(body)?,
                closed: *closed,
                at: change(at)?,
            },
        };
        Ok(Self {
            node: Arc::new(node),
            place: self.place,
        })
    }

    /// Returns a if the term is `exp(a)`, and 0 if it is the number 1.
    fn exponent(&self) -> Option<Self> {
        match &*self.node {
            Node::Apply(BuiltIn::Exponential, items) => match items.as_slice() {
                [exponent] => Some(exponent.clone()),
                _ => None,
            },
            Node::Opened { body, .. } => body.exponent(),
            _ if self.is_one() => Some(Self {
                node: Arc::new(Node::Number(integer(0))),
                place: self.place,
            }),
            _ => None,
        }
    }

    fn is_one(&self) -> bool {
        matches!(&*self.node, Node::Number(value) if *value == integer(1))
    }

    /// Whether a built-in function is applied anywhere in the term. Shared parts are visited once.
    #[must_use]
    pub fn applies(&self, function: BuiltIn) -> bool {
        let mut seen = Visited::default();
        let mut pending = vec![self];
        while let Some(term) = pending.pop() {
            if matches!(&*term.node, Node::Apply(applied, _) if *applied == function) {
                return true;
            }
            if seen.is_new(term) {
                term.each_part(&mut |part| pending.push(part));
            }
        }
        false
    }

    /// The integer that the term is written as, a numeral with any number of minus signs, if it fits.
    #[must_use]
    pub fn as_integer(&self) -> Option<i64> {
        match &*self.node {
            Node::Number(number) if number.is_integer() => number.to_integer().try_into().ok(),
            Node::Negative(inner) => inner.as_integer()?.checked_neg(),
            _ => None,
        }
    }

    /// Whether no variable of an enclosing binder occurs. Shared parts are visited once.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.is_bound(std::collections::BTreeSet::new())
    }

    /// Whether no variable of an enclosing binder occurs, except possibly the variable of this number.
    pub fn is_closed_but_for(&self, variable: u32) -> bool {
        self.is_bound([variable].into())
    }

    fn is_bound(&self, mut bound: std::collections::BTreeSet<u32>) -> bool {
        let mut seen = Visited::default();
        let mut used = vec![];
        let mut pending = vec![self];
        while let Some(term) = pending.pop() {
            if !seen.is_new(term) {
                continue;
            }
            match &*term.node {
                Node::Variable(variable) => used.push(variable.number()),
                Node::Sum { index, .. } | Node::Product { index, .. } => {
                    bound.insert(index.number());
                }
                Node::Let { variable, .. }
                | Node::Derivative { variable, .. }
                | Node::Integral { variable, .. } => {
                    bound.insert(variable.number());
                }
                Node::Basis { family, .. } if !family.closed => return false,
                _ => {}
            }
            term.each_part(&mut |part| pending.push(part));
        }
        // Each binder has a variable of its own, so no scopes need be tracked.
        used.iter().all(|variable| bound.contains(variable))
    }

    /// Calls `found` with the name of every declared symbol that occurs, including those in the seeds and steps of
    /// basis families. Shared parts are visited once.
    pub fn declared_names(&self, found: &mut impl FnMut(&Arc<str>)) {
        self.further_names(&mut Visited::default(), found);
    }

    /// As [`Term::declared_names`], but skips the parts in `seen`, and adds the others to it.
    pub fn further_names(&self, seen: &mut Visited, found: &mut impl FnMut(&Arc<str>)) {
        let mut pending = vec![self];
        while let Some(term) = pending.pop() {
            if !seen.is_new(term) {
                continue;
            }
            match &*term.node {
                Node::Symbol(name) | Node::Vector(name, _) => found(name),
                Node::Member(points, _) => found(&points.name),
                Node::Basis { family, .. } => {
                    pending.extend(family.seeds.iter().chain([&family.step.0, &family.step.1]));
                }
                _ => {}
            }
            term.each_part(&mut |part| pending.push(part));
        }
    }
}

impl Family {
    /// The name of the variable.
    #[must_use]
    pub fn variable(&self) -> &str {
        self.variables.first().map_or("", Variable::name)
    }

    /// The seeds, then the two factors of the step.
    pub fn formulas(&self) -> impl Iterator<Item = &Term> {
        self.seeds.iter().chain([&self.step.0, &self.step.1])
    }

    /// The family with changed seeds and step. It is a different family of the same name, so nothing that was cached
    /// under the name applies to it.
    #[must_use]
    pub fn with_formulas(&self, mut change: impl FnMut(&Term) -> Term) -> Self {
        Self {
            name: Arc::clone(&self.name),
            variables: self.variables.clone(),
            degree: self.degree,
            seeds: self.seeds.iter().map(&mut change).collect(),
            step: (change(&self.step.0), change(&self.step.1)),
            counters: self.counters.clone(),
            closed: false,
        }
    }

    /// All variables that the family binds: the variable, the shape parameters, and those for index and degree in the
    /// step.
    pub fn bound(&self) -> impl Iterator<Item = &Variable> {
        let counters = self.counters.iter();
        let counters = counters.flat_map(|(index, order)| [index, order]);
        self.variables.iter().chain(counters)
    }

    /// The names of the shape parameters.
    pub fn parameters(&self) -> impl Iterator<Item = &str> {
        self.variables.iter().skip(1).map(Variable::name)
    }
}

impl Statement {
    /// The number of statements in it: itself, and those that it joins or negates.
    #[must_use]
    pub fn size(&self) -> u64 {
        match self {
            Self::Compare { .. } | Self::Agrees { .. } | Self::Family(..) => 1,
            Self::Join(_, a, b) => 1 + a.size() + b.size(),
            Self::Not(inner) => 1 + inner.size(),
        }
    }

    /// Changes every term of the statement.
    #[must_use]
    pub fn mapped(&self, change: &dyn Fn(&Term) -> Term) -> Self {
        let never = |term: &Term| Ok::<_, std::convert::Infallible>(change(term));
        match self.try_mapped(&never) {
            Ok(statement) => statement,
        }
    }

    /// Changes every term of the statement, and the seeds and steps of those basis families in which variables of
    /// enclosing binders may occur.
    #[must_use]
    pub fn mapped_throughout(&self, change: &dyn Fn(&Term) -> Term) -> Self {
        match self {
            Self::Family(property, family) if !family.closed => {
                Self::Family(*property, Arc::new(family.with_formulas(change)))
            }
            Self::Join(connective, a, b) => Self::Join(
                *connective,
                Box::new(a.mapped_throughout(change)),
                Box::new(b.mapped_throughout(change)),
            ),
            Self::Not(inner) => Self::Not(Box::new(inner.mapped_throughout(change))),
            other => other.mapped(change),
        }
    }

    /// The comparison of exponents that is equivalent to a comparison of exponentials: the exponential is strictly
    /// increasing, so `exp(a) == exp(b)` means `a == b`, `exp(a) < exp(b)` means `a < b`, and the number 1 is the
    /// exponential of 0. Returns `None` if no comparison is one of two exponentials.
    #[must_use]
    pub fn compare_exponents(&self) -> Option<Self> {
        match self {
            Self::Compare {
                relation,
                left,
                right,
            } => {
                let (a, b) = (left.exponent()?, right.exponent()?);
                let both_numbers = left.is_one() && right.is_one();
                (!both_numbers).then_some(Self::Compare {
                    relation: *relation,
                    left: a,
                    right: b,
                })
            }
            Self::Join(Connective::And, a, b) => {
                match (a.compare_exponents(), b.compare_exponents()) {
                    (None, None) => None,
                    (first, second) => Some(Self::Join(
                        Connective::And,
                        Box::new(first.unwrap_or_else(|| (**a).clone())),
                        Box::new(second.unwrap_or_else(|| (**b).clone())),
                    )),
                }
            }
            Self::Not(inner) => Some(Self::Not(Box::new(inner.compare_exponents()?))),
            _ => None,
        }
    }

    /// The families whose properties the statement is about.
    #[must_use]
    pub fn families(&self) -> Vec<&Arc<Family>> {
        match self {
            Self::Family(_, family) => vec![family],
            Self::Join(_, a, b) => [a.families(), b.families()].concat(),
            Self::Not(inner) => inner.families(),
            Self::Compare { .. } | Self::Agrees { .. } => vec![],
        }
    }

    /// As [`Statement::mapped`], for a change that may fail.
    ///
    /// # Errors
    /// The errors of `change`.
    pub fn try_mapped<E>(&self, change: &dyn Fn(&Term) -> Result<Term, E>) -> Result<Self, E> {
        Ok(match self {
            Self::Compare {
                relation,
                left,
                right,
            } => Self::Compare {
                relation: *relation,
                left: change(left)?,
                right: change(right)?,
            },
            Self::Agrees {
                value,
                printed,
                place,
            } => Self::Agrees {
                value: change(value)?,
                printed: printed.clone(),
                place: *place,
            },
            Self::Family(property, family) => Self::Family(*property, Arc::clone(family)),
            Self::Join(connective, a, b) => Self::Join(
                *connective,
                Box::new(a.try_mapped(change)?),
                Box::new(b.try_mapped(change)?),
            ),
            Self::Not(inner) => Self::Not(Box::new(inner.try_mapped(change)?)),
        })
    }

    /// All terms, in the order of the text.
    #[must_use]
    pub fn terms(&self) -> Vec<&Term> {
        match self {
            Self::Compare { left, right, .. } => vec![left, right],
            Self::Agrees { value, .. } => vec![value],
            Self::Family(..) => vec![],
            Self::Join(_, a, b) => [a.terms(), b.terms()].concat(),
            Self::Not(inner) => inner.terms(),
        }
    }

    /// Calls `found` with the name of every declared symbol that occurs. For a property of a basis these include the
    /// names of its variables, because the property is about their declared sets.
    pub fn declared_names(&self, found: &mut impl FnMut(&Arc<str>)) {
        self.further_names(&mut Visited::default(), found);
    }

    /// As [`Statement::declared_names`], but skips the terms in `seen`, and adds the others to it.
    pub fn further_names(&self, seen: &mut Visited, found: &mut impl FnMut(&Arc<str>)) {
        match self {
            Self::Family(_, family) => {
                for variable in &family.variables {
                    found(&variable.name);
                }
                let parts = family.seeds.iter().chain([&family.step.0, &family.step.1]);
                parts.for_each(|part| part.further_names(seen, found));
            }
            Self::Join(_, a, b) => {
                a.further_names(seen, found);
                b.further_names(seen, found);
            }
            Self::Not(inner) => inner.further_names(seen, found),
            Self::Compare { left, right, .. } => {
                left.further_names(seen, found);
                right.further_names(seen, found);
            }
            Self::Agrees { value, .. } => value.further_names(seen, found),
        }
    }
}
