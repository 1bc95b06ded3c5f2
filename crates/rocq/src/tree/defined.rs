//! Where a formula has a value: the premises that a statement of Rocq, whose operations are total, needs beside it.
//!
//! The table of `derivations/SEMANTICS.md`, line by line, in the order of the text. Definitions are looked into, with the texts of
//! their arguments in the places of their parameters. A premise that is true whatever the values are is left out: divisors that are
//! literal numbers, indices and degrees that are literal numbers in their range, and the differentiability of what is made of
//! sums, products, quotients, sines, cosines and exponentials.

use super::function::{Binding, derivative, is_name};
use super::kinds::Kind;
use super::scope::{Local, Scope, words};
use super::writer::{Value, Writer};
use crate::code::{Code, Level, integer_scope};
use crate::gap::Gap;
use crate::shape::Shape;
use std::collections::BTreeSet;
use torse_numbers::{Affine, rational};
use torse_syntax::derivation::declarations::{Basis, SymbolKind};
use torse_syntax::formula::{Connective, Expr, Node, Operator};

/// Premises, in the order of the text, none of them twice.
#[derive(Debug, Default)]
pub(super) struct Premises {
    found: Vec<Code>,
    /// The definitions that were looked into, with the texts that stood for what they depend on.
    opened: BTreeSet<(String, Vec<String>)>,
}

impl Premises {
    fn add(&mut self, premise: Code) {
        if !self.found.contains(&premise) {
            self.found.push(premise);
        }
    }

    /// The premises.
    pub fn into_vec(self) -> Vec<Code> {
        self.found
    }
}

fn relation(left: &Code, sign: &str, right: &Code) -> Code {
    let (left, right) = (left.within(Level::Sum), right.within(Level::Sum));
    Code::new(format!("{left} {sign} {right}"), Level::Relation)
}

fn nonzero(code: &Code) -> Code {
    relation(code, "<>", &Code::atom("0"))
}

/// An integer without the mark of its scope, for a place in that scope.
fn plain(code: &Code) -> String {
    let text = code.text();
    match text.strip_suffix("%Z") {
        Some(inner) => match inner.trim_start_matches('(').trim_end_matches(')') {
            number if number.chars().all(|c| c.is_ascii_digit()) => number.to_owned(),
            _ => inner.to_owned(),
        },
        None => text.to_owned(),
    }
}

fn integers(text: String) -> Code {
    Code::atom(format!("({text})%Z"))
}

/// Whether a name occurs in a text.
fn mentions(text: &str, name: &str) -> bool {
    words(text).any(|word| word == name)
}

impl Writer<'_> {
    /// The premises under which all terms of a statement have values; what stands in a denial about the domain has its own.
    ///
    /// # Errors
    /// [`Gap`], as for the values.
    pub fn statement_defined(
        &mut self,
        expr: &Expr,
        scope: &Scope,
        premises: &mut Premises,
    ) -> Result<(), Gap> {
        match &expr.node {
            Node::Not(_) => Ok(()),
            Node::Join(Connective::And | Connective::Or | Connective::Implies, a, b) => {
                self.statement_defined(a, scope, premises)?;
                self.statement_defined(b, scope, premises)
            }
            Node::Name(name) if !scope.locals.contains_key(name) => {
                match self.names.declarations.definition(name) {
                    Some(definition) => {
                        self.statement_defined(&definition.body.expr, &scope.outside(), premises)
                    }
                    None => Err(Gap::Unread(format!("`{name}` is no statement"))),
                }
            }
            Node::Call(head, arguments) => {
                let name = self.names.built_in(head, &scope.bound());
                match (name, arguments.as_slice()) {
                    (Some("agrees"), [value, _]) => self.defined(value, scope, premises),
                    (Some("at"), [inner, variable, point]) => {
                        let inside = self.put_in_place(variable, point, scope, premises)?;
                        self.statement_defined(inner, &inside, premises)
                    }
                    (Some("nonnegative"), [basis]) => match self.listed(basis) {
                        Some(members) => {
                            for member in members {
                                self.defined(&member, &Scope::default(), premises)?;
                            }
                            Ok(())
                        }
                        None => Ok(()),
                    },
                    _ => Ok(()),
                }
            }
            _ => {
                for part in expr.parts() {
                    self.defined(part, scope, premises)?;
                }
                Ok(())
            }
        }
    }

    /// Adds the premises under which a formula has a value.
    ///
    /// # Errors
    /// [`Gap`], as for the value.
    pub fn defined(
        &mut self,
        expr: &Expr,
        scope: &Scope,
        premises: &mut Premises,
    ) -> Result<(), Gap> {
        self.visit()?;
        let bound = scope.bound();
        match &expr.node {
            Node::Number { .. } => Ok(()),
            Node::Name(name) => match self.names.definition(name, &bound) {
                Some(definition)
                    if definition.parameters.is_empty()
                        && premises
                            .opened
                            .insert((name.clone(), self.texts(name, &[], scope)?)) =>
                {
                    self.defined(&definition.body.expr, &scope.outside(), premises)
                }
                _ => Ok(()),
            },
            Node::Call(head, arguments) => {
                if let Node::Index(family, indices) = &head.node
                    && let Node::Name(name) = &family.node
                    && let Some(basis) = self.names.basis(name, &bound)
                {
                    return self.member_defined(basis, name, indices, arguments, scope, premises);
                }
                match self.names.built_in(head, &bound) {
                    Some(name) => self.built_in_defined(name, arguments, scope, premises),
                    None => self.application_defined(head, arguments, scope, premises),
                }
            }
            Node::Index(head, indices) => self.index_defined(head, indices, scope, premises),
            Node::Binary(operator, a, b) => {
                self.defined(a, scope, premises)?;
                self.defined(b, scope, premises)?;
                self.operation_defined(*operator, a, b, scope, premises)
            }
            _ => {
                for part in expr.parts() {
                    self.defined(part, scope, premises)?;
                }
                Ok(())
            }
        }
    }

    /// The premises of a formula alone.
    pub fn gathered(&mut self, expr: &Expr, scope: &Scope) -> Result<Vec<Code>, Gap> {
        let mut inner = Premises::default();
        self.defined(expr, scope, &mut inner)?;
        Ok(inner.into_vec())
    }

    fn operation_defined(
        &mut self,
        operator: Operator,
        a: &Expr,
        b: &Expr,
        scope: &Scope,
        premises: &mut Premises,
    ) -> Result<(), Gap> {
        match operator {
            Operator::Divide
                if !is_nonzero(b, scope) && self.known(b, scope).is_none_or(|n| n == 0) =>
            {
                let divisor = self.number(b, scope)?;
                premises.add(nonzero(&divisor));
            }
            Operator::Power => match self.literal(b, scope) {
                Some(0..) => {}
                Some(_) if is_nonzero(a, scope) => {}
                Some(_) => {
                    let base = self.number(a, scope)?;
                    premises.add(nonzero(&base));
                }
                None => {
                    let (base, exponent) = (self.number(a, scope)?, self.index(b, scope)?);
                    let natural = integers(format!("0 <= {}", exponent.argument()));
                    let either = Code::infix(&natural, "\\/", &nonzero(&base), Level::Either);
                    premises.add(either);
                }
            },
            _ => {}
        }
        Ok(())
    }

    fn index_defined(
        &mut self,
        head: &Expr,
        indices: &[Expr],
        scope: &Scope,
        premises: &mut Premises,
    ) -> Result<(), Gap> {
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
    ) -> Result<(), Gap> {
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
    ) -> Result<(), Gap> {
        for ((low, high), index) in ranges.iter().zip(indices) {
            if let (Some(low), Some(high), Some(index)) =
                (low.as_number(), high.as_number(), self.known(index, scope))
                && (low..=high).contains(&index)
            {
                continue;
            }
            let code = self.integer(index, scope);
            let code = code.ok_or(Gap::Construct("an index that is not made of integers"))?;
            let (low, high) = (self.affine(low)?, self.affine(high)?);
            let index = code.within(Level::Sum);
            premises.add(integers(format!("{low} <= {index} <= {high}")));
        }
        Ok(())
    }

    fn member_defined(
        &mut self,
        basis: &Basis,
        name: &str,
        indices: &[Expr],
        arguments: &[Expr],
        scope: &Scope,
        premises: &mut Premises,
    ) -> Result<(), Gap> {
        let given = self.arguments(basis, arguments, scope)?;
        for part in indices {
            self.defined(part, scope, premises)?;
        }
        for (argument, scope) in &given {
            self.defined(argument, scope, premises)?;
        }
        let [_, degree] = indices else {
            return Err(Gap::Unread(format!("`{name}` without index and degree")));
        };
        let lowest = i64::from(basis.degree);
        if self
            .literal(degree, scope)
            .is_none_or(|degree| degree < lowest)
        {
            let degree = self.integer(degree, scope);
            let degree = degree.ok_or(Gap::Construct("a degree that is not made of integers"))?;
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
            .or_else(|| self.known(degree, scope));
        let highest = highest.ok_or(Gap::Construct(
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

    fn built_in_defined(
        &mut self,
        name: &str,
        arguments: &[Expr],
        scope: &Scope,
        premises: &mut Premises,
    ) -> Result<(), Gap> {
        match (name, arguments) {
            ("sum" | "product", [index, low, high, term]) => {
                self.sum_defined(index, low, high, term, scope, premises)
            }
            ("D", [inner, rest @ ..]) => {
                if let Some(order) = rest.get(1) {
                    self.defined(order, scope, premises)?;
                }
                let variable = rest.first();
                let variable = variable.ok_or(Gap::Construct("a derivative by nothing"))?;
                let reach = self.reach(inner, scope);
                let binding = self.binding(variable, &reach, scope)?;
                let found = self.gathered(inner, &binding.scope)?;
                let value = self.value(inner, &binding.scope)?;
                let rough = self.rough(inner, &binding.scope, &binding.name)?;
                let order = self.order(rest.get(1), scope)?;
                near(&binding, found, rough.then_some(value), &order, premises)
            }
            ("at", [inner, variable, point]) => {
                let inside = self.put_in_place(variable, point, scope, premises)?;
                self.defined(inner, &inside, premises)
            }
            ("coefficients", [forms, symbols]) => {
                self.defined(forms, scope, premises)?;
                self.defined(symbols, scope, premises)?;
                self.coefficients_defined(forms, symbols, scope)
            }
            _ => {
                for argument in arguments {
                    self.defined(argument, scope, premises)?;
                }
                self.plain_defined(name, arguments, scope, premises)
            }
        }
    }

    /// The premises of a built-in function whose arguments have values.
    fn plain_defined(
        &mut self,
        name: &str,
        arguments: &[Expr],
        scope: &Scope,
        premises: &mut Premises,
    ) -> Result<(), Gap> {
        let Some(first) = arguments.first() else {
            return Ok(());
        };
        match name {
            "sqrt" if !is_positive(first, scope) => {
                let radicand = self.number(first, scope)?;
                premises.add(relation(&Code::atom("0"), "<=", &radicand));
            }
            "abs" => {
                let x = self.number(first, scope)?;
                let square = Code::infix(&x, "*", &x, Level::Product);
                premises.add(relation(&Code::atom("0"), "<=", &square));
            }
            "tan" => {
                let angle = self.number(first, scope)?;
                premises.add(nonzero(&Code::apply("cos", &[angle])));
            }
            "tanh" => {
                let x = self.number(first, scope)?;
                let opposite = format!("- {}", x.within(Level::Negative));
                let up = Code::apply("exp", &[x]);
                let down = Code::apply("exp", &[Code::new(opposite, Level::Negative)]);
                premises.add(nonzero(&Code::infix(&up, "+", &down, Level::Sum)));
            }
            "factorial" if self.literal(first, scope).is_none_or(|n| n < 0) => {
                let n = self.index(first, scope)?;
                premises.add(integers(format!("0 <= {}", n.argument())));
            }
            "inverse" | "solve" => {
                let matrix = self.value(first, scope)?;
                premises.add(nonzero(&Code::apply("det", &[matrix.code])));
            }
            _ => {}
        }
        Ok(())
    }

    fn sum_defined(
        &mut self,
        index: &Expr,
        low: &Expr,
        high: &Expr,
        term: &Expr,
        scope: &Scope,
        premises: &mut Premises,
    ) -> Result<(), Gap> {
        self.defined(low, scope, premises)?;
        self.defined(high, scope, premises)?;
        let (low, high) = (self.index(low, scope)?, self.index(high, scope)?);
        let (name, inside) = self.counted(index, term, scope)?;
        let range = format!("{} <= {name} <= {}", plain(&low), plain(&high));
        for premise in self.gathered(term, &inside)? {
            // An index is in the range of its own sum.
            if premise.text() == format!("({range})%Z") {
                continue;
            }
            let premise = premise.within(Level::Open);
            let text = format!("forall {name} : Z, ({range})%Z -> {premise}");
            premises.add(Code::new(text, Level::Open));
        }
        Ok(())
    }

    /// The scope in which a point stands for what `at` binds.
    fn put_in_place(
        &mut self,
        variable: &Expr,
        point: &Expr,
        scope: &Scope,
        premises: &mut Premises,
    ) -> Result<Scope, Gap> {
        self.defined(point, scope, premises)?;
        let Node::Name(name) = &variable.node else {
            return Err(Gap::Unread("a binder without a name".to_owned()));
        };
        if let Some(local) = scope.locals.get(name) {
            let (code, kind) = self.argument(point, local.kind, scope)?;
            return Ok(scope.with_local(name, Code::atom(code.argument()), kind));
        }
        let kind = match self.names.declarations.symbol(name) {
            Some(SymbolKind::Integer { .. }) => Kind::Integer,
            _ => Kind::NUMBER,
        };
        let (code, _) = self.argument(point, kind, scope)?;
        Ok(scope.with_moved(name, Code::atom(code.argument())))
    }

    fn application_defined(
        &mut self,
        head: &Expr,
        arguments: &[Expr],
        scope: &Scope,
        premises: &mut Premises,
    ) -> Result<(), Gap> {
        let mut given = vec![];
        for argument in arguments {
            self.defined(argument, scope, premises)?;
            given.push(self.standing_for(argument, scope)?);
        }
        self.applied_defined(head, &given, scope, premises)
    }

    /// The texts that stand for what a definition depends on: its arguments, and the symbols that it reaches.
    fn texts(&self, name: &str, arguments: &[Local], scope: &Scope) -> Result<Vec<String>, Gap> {
        let mut texts: Vec<String> = arguments.iter().map(|a| a.code.text().to_owned()).collect();
        for symbol in &self.names.of_definition(name).symbols {
            texts.push(self.standing(symbol, scope)?.text().to_owned());
        }
        Ok(texts)
    }

    /// What stands for a parameter of this value: an integer where it can.
    fn standing_for(&mut self, expr: &Expr, scope: &Scope) -> Result<Local, Gap> {
        if let Some(code) = self.integer(expr, scope) {
            return Ok(Local {
                code: Code::atom(integer_scope(&code)),
                kind: Kind::Integer,
            });
        }
        let Value { code, shape } = self.value(expr, scope)?;
        Ok(Local {
            code: Code::atom(code.argument()),
            kind: Kind::Value(shape),
        })
    }

    /// The premises of a function at arguments that have values.
    fn applied_defined(
        &mut self,
        head: &Expr,
        arguments: &[Local],
        scope: &Scope,
        premises: &mut Premises,
    ) -> Result<(), Gap> {
        let bound = scope.bound();
        match &head.node {
            Node::Name(name) => {
                if let Some(definition) = self.names.definition(name, &bound) {
                    let body = &definition.body.expr;
                    let mut inside = scope.outside();
                    if definition.parameters.is_empty() {
                        return self.applied_defined(body, arguments, &inside, premises);
                    }
                    let texts = self.texts(name, arguments, scope)?;
                    if !premises.opened.insert((name.clone(), texts)) {
                        return Ok(());
                    }
                    for (parameter, local) in definition.parameters.iter().zip(arguments) {
                        inside = inside.with_local(parameter, local.code.clone(), local.kind);
                    }
                    return self.defined(body, &inside, premises);
                }
                let base = name.trim_end_matches('\'');
                if self.names.declarations.function(name).is_some() || base.len() == name.len() {
                    return Ok(());
                }
                let order = Code::atom((name.len() - base.len()).to_string());
                self.rate_defined(&Expr::name(base), 0, &order, arguments, scope, premises)
            }
            Node::Call(own, inner) => match (self.names.built_in(own, &bound), inner.as_slice()) {
                (Some("D"), [inner, rest @ ..]) => {
                    if let Some(order) = rest.get(1) {
                        self.defined(order, scope, premises)?;
                    }
                    let order = self.order(rest.get(1), scope)?;
                    let own = self.names.parameters(inner, &bound).unwrap_or_default();
                    let by = match rest.first() {
                        None => Some(0),
                        Some(variable) => own.iter().position(|name| is_name(variable, name)),
                    };
                    if let Some(by) = by {
                        return self.rate_defined(inner, by, &order, arguments, scope, premises);
                    }
                    let variable = rest.first();
                    let variable = variable.ok_or(Gap::Construct("a derivative by nothing"))?;
                    let reach = self.reach(inner, scope);
                    let binding = self.binding_beside(variable, &reach, scope, arguments)?;
                    self.near_applied(inner, &binding, &order, arguments, premises)
                }
                (Some("at"), [inner, variable, point]) => {
                    let inside = self.put_in_place(variable, point, scope, premises)?;
                    self.applied_defined(inner, arguments, &inside, premises)
                }
                _ => Ok(()),
            },
            _ => Ok(()),
        }
    }

    /// The premises of a derivative by a parameter.
    fn rate_defined(
        &mut self,
        inner: &Expr,
        by: usize,
        order: &Code,
        arguments: &[Local],
        scope: &Scope,
        premises: &mut Premises,
    ) -> Result<(), Gap> {
        let names = self.names.parameters(inner, &scope.bound());
        let names = names.unwrap_or_default();
        let like = names.get(by).map_or("x", String::as_str);
        let at = arguments.get(by);
        let at = at.ok_or(Gap::Construct("a derivative by no parameter"))?;
        let outside = match at.kind {
            Kind::Integer => super::function::real(&at.code),
            Kind::Value(_) => at.code.clone(),
        };
        let mut taken = scope.words("");
        taken.extend(arguments.iter().flat_map(|local| words(local.code.text())));
        let name = self.fresh_beside(like, &self.reach(inner, scope), taken);
        let mut inside = arguments.to_vec();
        if let Some(place) = inside.get_mut(by) {
            *place = Local {
                code: Code::atom(&name),
                kind: Kind::NUMBER,
            };
        }
        let binding = Binding {
            name,
            kind: Kind::NUMBER,
            outside,
            scope: scope.clone(),
        };
        self.near_applied(inner, &binding, order, &inside, premises)
    }

    /// The premises of the derivative of a function at arguments, one of which may be what the derivative binds.
    fn near_applied(
        &mut self,
        inner: &Expr,
        binding: &Binding,
        order: &Code,
        arguments: &[Local],
        premises: &mut Premises,
    ) -> Result<(), Gap> {
        let mut found = Premises::default();
        self.applied_defined(inner, arguments, &binding.scope, &mut found)?;
        let function = self.function(inner, &binding.scope)?;
        let function = function.ok_or(Gap::Construct("a derivative of what is no function"))?;
        let mut given = vec![];
        for (local, (_, kind)) in arguments.iter().zip(&function.parameters) {
            given.push(match (local.kind, kind) {
                (Kind::Integer, Kind::Value(_)) => {
                    (super::function::real(&local.code), Kind::NUMBER)
                }
                (own, _) => (local.code.clone(), own),
            });
        }
        let value = function.applied(self, &given)?;
        let rough = self.rough_applied(inner, arguments, &binding.scope, &binding.name)?;
        near(
            binding,
            found.into_vec(),
            rough.then_some(value),
            order,
            premises,
        )
    }

    /// Whether something occurs that is not smooth wherever it has a value: roots, and powers with symbols in the exponent, of
    /// what depends on this name.
    fn rough(&mut self, expr: &Expr, scope: &Scope, name: &str) -> Result<bool, Gap> {
        self.visit()?;
        let bound = scope.bound();
        match &expr.node {
            Node::Name(own) => match self.names.definition(own, &bound) {
                Some(definition) if definition.parameters.is_empty() => {
                    self.rough(&definition.body.expr, &scope.outside(), name)
                }
                _ => Ok(false),
            },
            Node::Binary(Operator::Power, base, exponent) => {
                if self.literal(exponent, scope).is_none()
                    && mentions(self.number(base, scope)?.text(), name)
                {
                    return Ok(true);
                }
                Ok(self.rough(base, scope, name)?)
            }
            Node::Call(head, arguments) => {
                if let Some(own) = self.names.built_in(head, &bound) {
                    return match (own, arguments.as_slice()) {
                        ("sqrt" | "norm" | "abs", [inner]) => Ok(!is_positive(inner, scope)),
                        ("sum" | "product", [index, _, _, term]) => {
                            let (_, inside) = self.counted(index, term, scope)?;
                            self.rough(term, &inside, name)
                        }
                        ("at", [inner, variable, point]) => {
                            let none = &mut Premises::default();
                            let inside = self.put_in_place(variable, point, scope, none)?;
                            Ok(self.rough(point, scope, name)?
                                || self.rough(inner, &inside, name)?)
                        }
                        ("D", [inner, variable, ..]) => {
                            let reach = self.reach(inner, scope);
                            let binding = self.binding(variable, &reach, scope)?;
                            self.rough(inner, &binding.scope, name)
                        }
                        _ => self.any_rough(arguments, scope, name),
                    };
                }
                if self.any_rough(arguments, scope, name)? {
                    return Ok(true);
                }
                if matches!(&head.node, Node::Index(..)) {
                    return Ok(false);
                }
                let mut given = vec![];
                for argument in arguments {
                    given.push(self.standing_for(argument, scope)?);
                }
                self.rough_applied(head, &given, scope, name)
            }
            _ => {
                for part in expr.parts() {
                    if self.rough(part, scope, name)? {
                        return Ok(true);
                    }
                }
                Ok(false)
            }
        }
    }

    fn any_rough(&mut self, exprs: &[Expr], scope: &Scope, name: &str) -> Result<bool, Gap> {
        for expr in exprs {
            if self.rough(expr, scope, name)? {
                return Ok(true);
            }
        }
        Ok(false)
    }

    fn rough_applied(
        &mut self,
        head: &Expr,
        arguments: &[Local],
        scope: &Scope,
        name: &str,
    ) -> Result<bool, Gap> {
        let bound = scope.bound();
        match &head.node {
            Node::Name(own) => {
                if let Some(definition) = self.names.definition(own, &bound) {
                    let body = &definition.body.expr;
                    let mut inside = scope.outside();
                    if definition.parameters.is_empty() {
                        return self.rough_applied(body, arguments, &inside, name);
                    }
                    for (parameter, local) in definition.parameters.iter().zip(arguments) {
                        inside = inside.with_local(parameter, local.code.clone(), local.kind);
                    }
                    return self.rough(body, &inside, name);
                }
                let base = own.trim_end_matches('\'');
                match base.len() < own.len() && self.names.declarations.function(own).is_none() {
                    true => self.rough_applied(&Expr::name(base), arguments, scope, name),
                    false => Ok(false),
                }
            }
            Node::Call(own, inner) => match (self.names.built_in(own, &bound), inner.as_slice()) {
                (Some("D"), [inner, ..]) => self.rough_applied(inner, arguments, scope, name),
                (Some("at"), [inner, variable, point]) => {
                    let none = &mut Premises::default();
                    let inside = self.put_in_place(variable, point, scope, none)?;
                    self.rough_applied(inner, arguments, &inside, name)
                }
                _ => Ok(false),
            },
            _ => Ok(false),
        }
    }
}

/// Adds what a derivative needs: its formula has a value near the point, and has derivatives where that is not plain.
fn near(
    binding: &Binding,
    found: Vec<Code>,
    rough: Option<Value>,
    order: &Code,
    premises: &mut Premises,
) -> Result<(), Gap> {
    let (name, at) = (&binding.name, binding.outside.argument());
    for premise in found {
        // What does not depend on the variable has no neighbourhood.
        if !mentions(premise.text(), name) {
            premises.add(premise);
            continue;
        }
        let near = format!("locally {at} (fun {name} => {})", premise.text());
        premises.add(Code::new(near, Level::Application));
    }
    let Some(value) = rough else {
        return Ok(());
    };
    if order.text().contains(' ') {
        return Err(Gap::Construct("a derivative of symbolic order"));
    }
    let derived = derivative(name, value, order, &binding.outside)?;
    let text = derived.code.text();
    let text = match text.strip_prefix("Derive_n ") {
        Some(rest) => format!("ex_derive_n {rest}"),
        None => return Err(Gap::Construct("a derivative of a vector with roots")),
    };
    premises.add(Code::new(text, Level::Application));
    Ok(())
}

/// Whether a formula is not zero whatever the values are: literal numbers and pi, their products and powers.
fn is_nonzero(expr: &Expr, scope: &Scope) -> bool {
    match &expr.node {
        Node::Name(name) => name == "pi" && !scope.locals.contains_key("pi"),
        Node::Number { value, .. } => *value != rational::integer(0),
        Node::Negative(inner) => is_nonzero(inner, scope),
        Node::Binary(Operator::Multiply | Operator::Divide, a, b) => {
            is_nonzero(a, scope) && is_nonzero(b, scope)
        }
        Node::Binary(Operator::Power, a, n) => is_integer(n) && is_nonzero(a, scope),
        Node::Call(head, arguments) => {
            is_name(head, "sqrt") && arguments.iter().all(|a| is_nonzero(a, scope))
        }
        _ => false,
    }
}

/// Whether a formula is a literal integer.
fn is_integer(expr: &Expr) -> bool {
    match &expr.node {
        Node::Number { value, .. } => value.is_integer(),
        Node::Negative(inner) => is_integer(inner),
        _ => false,
    }
}

/// Whether a formula is a literal number that is not negative.
fn is_positive(expr: &Expr, scope: &Scope) -> bool {
    match &expr.node {
        Node::Name(name) => name == "pi" && !scope.locals.contains_key("pi"),
        Node::Number { value, .. } => *value >= rational::integer(0),
        _ => false,
    }
}
