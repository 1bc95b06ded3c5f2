//! Where a formula has a value: the premises that a statement of Rocq, whose operations are total, needs beside it.
//!
//! The table of `derivations/SEMANTICS.md`, line by line, in the order of the text. Definitions are looked into, with
//! the texts of their arguments in the places of their parameters. A premise that is true whatever the values are is
//! left out: divisors that are literal numbers, indices and degrees that are literal numbers in their range, and the
//! differentiability of what is made of sums, products, quotients, sines, cosines and exponentials.

use super::applied::near;
use super::kinds::Kind;
use super::premises::{Premises, integers, nonzero, plain, relation, squared_difference};
use super::scope::Scope;
use super::writer::Writer;
use crate::code::{Code, Level};
use crate::gap::Untranslatable;
use torse_numbers::rational;
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::formula::{Connective, Expr, Node, Operator};

impl Writer<'_> {
    /// The premises under which all terms of a statement have values; what stands under `fails` has its own.
    ///
    /// # Errors
    /// [`Untranslatable`], as for the values.
    pub fn statement_defined(
        &mut self,
        expr: &Expr,
        scope: &Scope,
        premises: &mut Premises,
    ) -> Result<(), Untranslatable> {
        match &expr.node {
            Node::Not(inner) => self.statement_defined(inner, scope, premises),
            Node::Join(Connective::And | Connective::Or | Connective::Implies, a, b) => {
                self.statement_defined(a, scope, premises)?;
                self.statement_defined(b, scope, premises)
            }
            Node::Name(name) if !scope.locals.contains_key(name) => {
                match self.names.declarations.definition(name) {
                    Some(definition) => {
                        self.statement_defined(&definition.body.expr, &scope.outside(), premises)
                    }
                    None => Err(Untranslatable::Unread(format!("`{name}` is no statement"))),
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
                    (Some("nonnegative" | "independent"), [basis]) => {
                        self.property_defined(basis, scope, premises)
                    }
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
    /// [`Untranslatable`], as for the value.
    pub fn defined(
        &mut self,
        expr: &Expr,
        scope: &Scope,
        premises: &mut Premises,
    ) -> Result<(), Untranslatable> {
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
    ///
    /// # Errors
    /// [`Untranslatable`], as for the value.
    pub fn gathered(&mut self, expr: &Expr, scope: &Scope) -> Result<Vec<Code>, Untranslatable> {
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
    ) -> Result<(), Untranslatable> {
        match operator {
            Operator::Divide
                if !self.is_nonzero(b, scope)
                    && self.constant_value(b, scope).is_none_or(|n| n == 0) =>
            {
                let divisor = self.number(b, scope)?;
                premises.add(nonzero(&divisor));
            }
            Operator::Power => match self.literal(b, scope) {
                Some(0..) => {}
                Some(_) if self.is_nonzero(a, scope) => {}
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

    fn built_in_defined(
        &mut self,
        name: &str,
        arguments: &[Expr],
        scope: &Scope,
        premises: &mut Premises,
    ) -> Result<(), Untranslatable> {
        match (name, arguments) {
            ("sum" | "product", [index, low, high, term]) => {
                self.sum_defined(index, low, high, term, scope, premises)
            }
            ("D", [inner, rest @ ..]) => {
                if let Some(order) = rest.get(1) {
                    self.defined(order, scope, premises)?;
                }
                let variable = rest.first();
                let variable =
                    variable.ok_or(Untranslatable::Construct("a derivative by nothing"))?;
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
    ) -> Result<(), Untranslatable> {
        let Some(first) = arguments.first() else {
            return Ok(());
        };
        match name {
            "sqrt" if !self.is_positive(first, scope) => {
                let radicand = self.number(first, scope)?;
                premises.add(relation(&Code::atom("0"), "<=", &radicand));
            }
            "log" => return Err(Untranslatable::Theory("logarithms")),
            "atan" | "asin" | "acos" => return Err(Untranslatable::Theory("arcs")),
            "abs" => {
                let x = self.number(first, scope)?;
                let square = Code::infix(&x, "*", &x, Level::Product);
                premises.add(relation(&Code::atom("0"), "<=", &square));
            }
            "min" | "max" => {
                if let [a, b] = arguments {
                    let (a, b) = (self.number(a, scope)?, self.number(b, scope)?);
                    let square = squared_difference(&a, &b);
                    premises.add(relation(&Code::atom("0"), "<=", &square));
                }
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
    ) -> Result<(), Untranslatable> {
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
    ///
    /// # Errors
    /// [`Untranslatable`], as for the point.
    pub fn put_in_place(
        &mut self,
        variable: &Expr,
        point: &Expr,
        scope: &Scope,
        premises: &mut Premises,
    ) -> Result<Scope, Untranslatable> {
        self.defined(point, scope, premises)?;
        let Node::Name(name) = &variable.node else {
            return Err(Untranslatable::Unread("a binder without a name".to_owned()));
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

    /// Whether a formula is not zero whatever the values are: literal numbers and pi, their products, powers and roots.
    fn is_nonzero(&self, expr: &Expr, scope: &Scope) -> bool {
        match &expr.node {
            Node::Name(name) => name == "pi" && self.is_pi(scope),
            Node::Number { value, .. } => *value != rational::integer(0),
            Node::Negative(inner) => self.is_nonzero(inner, scope),
            Node::Binary(Operator::Multiply | Operator::Divide, a, b) => {
                self.is_nonzero(a, scope) && self.is_nonzero(b, scope)
            }
            Node::Binary(Operator::Power, a, n) => is_integer(n) && self.is_nonzero(a, scope),
            Node::Call(head, arguments) => {
                self.names.built_in(head, &scope.bound()) == Some("sqrt")
                    && arguments.iter().all(|a| self.is_nonzero(a, scope))
            }
            _ => false,
        }
    }

    /// Whether a formula is a literal number that is not negative.
    pub fn is_positive(&self, expr: &Expr, scope: &Scope) -> bool {
        match &expr.node {
            Node::Name(name) => name == "pi" && self.is_pi(scope),
            Node::Number { value, .. } => *value >= rational::integer(0),
            _ => false,
        }
    }

    /// Whether nothing else has the name of the number pi.
    fn is_pi(&self, scope: &Scope) -> bool {
        let bound = scope.bound();
        let declarations = self.names.declarations;
        !bound.contains("pi")
            && declarations.definition("pi").is_none()
            && declarations.symbol("pi").is_none()
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
