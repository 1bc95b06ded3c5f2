//! The built-in functions, and derivatives.

use super::binders::{Local, Scope, Use};
use super::denial;
use super::{Elaborator, Lambda, Meaning, Outcome, check_no_shared_variable, wrong};
use std::sync::Arc;
use torse_core::{
    BuiltIn, Degrees, Family, FamilyProperty, Node, Printed, Statement, Term, Variable,
};
use torse_numbers::fault_injection::{InjectedFault, injected};
use torse_numbers::{Rational, rational};
use torse_syntax::derivation::declarations::Basis;
use torse_syntax::fault::{Fault, Problem};
use torse_syntax::formula::{self, Expr, Operator, Place};

impl Elaborator<'_> {
    /// The family that a property is about. Terms that replace declared symbols in this scope are substituted in its
    /// seeds and its step, and a replaced shape parameter is no longer a parameter.
    fn named_family(&self, name: &Expr, scope: &Scope) -> Outcome<Arc<Family>> {
        let formula::Node::Name(basis) = &name.node else {
            return Err(wrong(name.place, "a formula", "the name of a basis"));
        };
        let Some(declared) = self.declarations.basis(basis) else {
            return self.family(basis, name.place);
        };
        quantified(declared, name.place, scope)?;
        if injected(InjectedFault::PropertyOutsideScope) {
            return self.family_of(basis, declared, &Scope::default());
        }
        let family = self.family_of(basis, declared, &scope.outside())?;
        self.has_own_names(&family, name.place)?;
        let fixed: Vec<(&Variable, &Variable)> = family
            .variables
            .iter()
            .filter_map(|own| Some((own, scope.globals.get(own.name())?)))
            .collect();
        if fixed.is_empty() {
            return Ok(family);
        }
        let substitute = |part: &Term| {
            fixed.iter().fold(part.clone(), |body, (own, outer)| {
                let place = body.place;
                let node = Node::Let {
                    variable: (*own).clone(),
                    value: self.made(Node::Variable((*outer).clone()), place),
                    body,
                };
                self.made(node, place)
            })
        };
        let mut other = family.with_formulas(substitute);
        other
            .variables
            .retain(|own| !scope.globals.contains_key(own.name()));
        Ok(Arc::new(other))
    }

    /// The basis of this name, if it is a list of functions without a step.
    fn list<'e>(&self, name: &'e Expr) -> Option<(&'e str, &Basis)> {
        let formula::Node::Name(name) = &name.node else {
            return None;
        };
        let basis = self
            .declarations
            .basis(name)
            .filter(|basis| basis.is_list)?;
        Some((name, basis))
    }

    pub(super) fn built_in(
        &self,
        name: &str,
        arguments: &[Expr],
        place: Place,
        scope: &Scope,
    ) -> Outcome<Meaning> {
        let count = |wanted: &str| {
            Fault::at(
                place,
                Problem::Count {
                    name: name.to_owned(),
                    wanted: wanted.to_owned(),
                    found: arguments.len(),
                },
            )
        };
        if let ("nonnegative" | "independent" | "variation_diminishing", [family, ..]) =
            (name, arguments)
            && let Some((list, basis)) = self.list(family)
        {
            if name != "nonnegative" {
                let wanted = "a basis with a step: of a list only `nonnegative` is decided";
                return Err(wrong(family.place, "a list of functions", wanted));
            }
            quantified(basis, family.place, scope)?;
            let own = self.family_of(list, basis, &scope.outside())?;
            self.has_own_names(&own, family.place)?;
            let property = Statement::Family(FamilyProperty::Nonnegative, own);
            return Ok(Meaning::Statement(property));
        }
        let name_of_fold = name;
        let function = match (name, arguments) {
            ("sum" | "product", [index, low, high, term]) => {
                let formula::Node::Name(name) = &index.node else {
                    return Err(wrong(index.place, "a formula", "the name of an index"));
                };
                let variable = self.fresh(name);
                let mut inside = scope.with_local(name, &variable, Local::Index);
                if injected(InjectedFault::IndexCaptured) {
                    inside = inside.with_global(name, &variable);
                }
                if injected(InjectedFault::IndexNotSeen) {
                    inside = scope.clone();
                }
                let (low, high) = (self.term_in(low, scope)?, self.term_in(high, scope)?);
                let (index, term) = (variable, self.term_in(term, &inside)?);
                let node = match name_of_fold {
                    _ if name_of_fold == "sum" || injected(InjectedFault::ProductAsSum) => {
                        Node::Sum {
                            index,
                            low,
                            high,
                            term,
                        }
                    }
                    _ => Node::Product {
                        index,
                        low,
                        high,
                        term,
                    },
                };
                return Ok(Meaning::Term(self.made(node, place)));
            }
            ("sum", _) => return Err(count("sum(index, low, high, term)")),
            ("product", _) => return Err(count("product(index, low, high, factor)")),
            ("integral", [body, variable, low, high]) => {
                let (low, high) = (self.term_in(low, scope)?, self.term_in(high, scope)?);
                let bound = self.bound(variable, scope, Use::Derivative)?;
                let (low, high) = if injected(InjectedFault::EndsExchanged) {
                    (high, low)
                } else {
                    (low, high)
                };
                let node = Node::Integral {
                    low,
                    high,
                    body: self.term_in(body, &bound.scope)?,
                    variable: bound.variable,
                };
                return Ok(Meaning::Term(self.made(node, place)));
            }
            ("integral", _) => return Err(count("integral(formula, variable, from, to)")),
            ("D", [inner, rest @ ..]) if rest.len() <= 2 => {
                return self.derivative(inner, rest, place, scope);
            }
            ("D", _) => return Err(count("D(F, variable, order)")),
            ("at", [inner, variable, point]) => {
                let value = self.term_in(point, scope)?;
                let bound = self.bound(variable, scope, Use::At)?;
                let bind = |body: Term| {
                    self.made(
                        Node::Let {
                            variable: bound.variable.clone(),
                            value: value.clone(),
                            body,
                        },
                        place,
                    )
                };
                let inside = if injected(InjectedFault::MovedNotSeen) {
                    scope
                } else {
                    &bound.scope
                };
                return Ok(match self.open(inner, inside)? {
                    Meaning::Term(body) => Meaning::Term(bind(body)),
                    Meaning::Function(function) => Meaning::Function(Lambda {
                        body: bind(function.body),
                        ..function
                    }),
                    Meaning::Statement(statement) => {
                        check_no_shared_variable(&statement, &value)?;
                        Meaning::Statement(statement.mapped_throughout(&|term| bind(term.clone())))
                    }
                });
            }
            ("at", _) => return Err(count("at(formula, variable, point)")),
            ("fails", [inner]) => {
                if !scope.is_outermost() {
                    return Err(denial::misplaced(place));
                }
                let denied = self.statement_in(inner, scope)?;
                let denied = Box::new(denial::about_points(denied, inner)?);
                return Ok(Meaning::Statement(Statement::Not(denied)));
            }
            ("agrees", [value, printed]) => {
                return Ok(Meaning::Statement(Statement::Agrees {
                    value: self.term_in(value, scope)?,
                    printed: printed_numbers(printed)?,
                    place: printed.place,
                }));
            }
            ("nonnegative" | "independent" | "variation_diminishing", [family]) => {
                let property = match name {
                    "nonnegative" => FamilyProperty::Nonnegative,
                    "independent" => FamilyProperty::Independent,
                    _ => FamilyProperty::VariationDiminishing(None),
                };
                let family = self.named_family(family, scope)?;
                return Ok(Meaning::Statement(Statement::Family(property, family)));
            }
            ("variation_diminishing", [family, least, most]) => {
                let family = self.named_family(family, scope)?;
                let own = family.degree;
                let least = degree(least, own, "a degree, a number not below that of the seeds")?;
                let most = degree(most, least, "a degree, a number not below the first")?;
                let degrees = Some(Degrees { least, most });
                let property = FamilyProperty::VariationDiminishing(degrees);
                return Ok(Meaning::Statement(Statement::Family(property, family)));
            }
            // The tangent is opened to its definition, so its poles are treated like all other zero divisors.
            ("tan", [angle]) => {
                let angle = self.term_in(angle, scope)?;
                let part = |function| self.made(Node::Apply(function, vec![angle.clone()]), place);
                let (sine, cosine) = (part(BuiltIn::Sine), part(BuiltIn::Cosine));
                let node = Node::Binary(Operator::Divide, sine, cosine);
                return Ok(Meaning::Term(self.made(node, place)));
            }
            ("cosh" | "sinh" | "tanh", [x]) => {
                let x = self.term_in(x, scope)?;
                return Ok(Meaning::Term(self.hyperbolic(name, &x, place)));
            }
            // Arc sine and arc cosine are a quarter turn together.
            ("acos", [x]) => {
                let arguments = vec![self.term_in(x, scope)?];
                let sine = self.made(Node::Apply(BuiltIn::ArcSine, arguments), place);
                let two = self.made(Node::Number(rational::integer(2)), place);
                let pi = self.made(Node::Pi, place);
                let quarter = self.made(Node::Binary(Operator::Divide, pi, two), place);
                let node = Node::Binary(Operator::Subtract, quarter, sine);
                return Ok(Meaning::Term(self.made(node, place)));
            }
            // The absolute value is the root of the square.
            ("abs", [x]) => {
                let x = self.term_in(x, scope)?;
                if injected(InjectedFault::SizeAsItself) {
                    return Ok(Meaning::Term(x));
                }
                let square = self.made(Node::Binary(Operator::Multiply, x.clone(), x), place);
                let node = Node::Apply(BuiltIn::SquareRoot, vec![square]);
                return Ok(Meaning::Term(self.made(node, place)));
            }
            ("min" | "max", [a, b]) => {
                let (a, b) = (self.term_in(a, scope)?, self.term_in(b, scope)?);
                return Ok(Meaning::Term(self.extremum(name, &a, &b, place)));
            }
            ("binom", [_, _]) => BuiltIn::Binomial,
            ("factorial", [_]) => BuiltIn::Factorial,
            ("sin", [_]) => BuiltIn::Sine,
            ("cos", [_]) => BuiltIn::Cosine,
            ("exp", [_]) => BuiltIn::Exponential,
            ("log", [_]) => BuiltIn::Logarithm,
            ("atan", [_]) => BuiltIn::ArcTangent,
            ("asin", [_]) => BuiltIn::ArcSine,
            ("sqrt", [_]) => BuiltIn::SquareRoot,
            ("dot", [_, _]) => BuiltIn::Dot,
            ("cross", [_, _]) => BuiltIn::Cross,
            ("norm", [_]) => BuiltIn::Norm,
            ("det", [_]) => BuiltIn::Determinant,
            ("transpose", [_]) => BuiltIn::Transpose,
            ("inverse", [_]) => BuiltIn::Inverse,
            ("solve", [_, _]) => BuiltIn::Solve,
            ("identity", [_]) => BuiltIn::Identity,
            ("coefficients", [_, _]) => BuiltIn::Coefficients,
            _ => {
                if let ("min" | "max", [_, _, _, ..]) = (name, arguments) {
                    let what = format!(
                        "`{name}` of more than two numbers is out of scope: write `{name}(a, {name}(b, c))`"
                    );
                    return Err(Fault::limit(place, what));
                }
                return Err(count(match name {
                    "binom" | "dot" | "cross" | "solve" | "agrees" | "coefficients" => {
                        "two arguments"
                    }
                    "min" | "max" => "two arguments: `max(a, max(b, c))` is the greatest of three",
                    _ => "one argument",
                }));
            }
        };
        let arguments = self.terms_in(arguments, scope)?;
        Ok(Meaning::Term(
            self.made(Node::Apply(function, arguments), place),
        ))
    }

    /// The derivative `D(F, x, n)`: a function if F is a function, else a formula.
    pub(super) fn derivative(
        &self,
        inner: &Expr,
        rest: &[Expr],
        place: Place,
        scope: &Scope,
    ) -> Outcome<Meaning> {
        let order = match rest.get(1) {
            Some(order) if !injected(InjectedFault::OrderForgotten) => {
                self.term_in(order, scope)?
            }
            _ => self.made(Node::Number(rational::integer(1)), place),
        };
        if let Meaning::Function(function) = self.open(inner, scope)? {
            let parameter = match rest.first().map(|e| (&e.node, e.place)) {
                None => function.parameters.first(),
                Some(_) if injected(InjectedFault::FirstParameter) => function.parameters.first(),
                Some((formula::Node::Name(name), _)) => {
                    function.parameters.iter().find(|p| p.name() == name)
                }
                Some((_, place)) => {
                    return Err(wrong(place, "a formula", "the name of a variable"));
                }
            };
            if let Some(parameter) = parameter.cloned() {
                return Ok(Meaning::Function(
                    self.differentiated(&function, &parameter, order, place),
                ));
            }
        }
        let Some(variable) = rest.first() else {
            return Err(wrong(place, "a formula", "a variable to differentiate by"));
        };
        let bound = self.bound(variable, scope, Use::Derivative)?;
        let derivative = |body: Term| {
            let node = Node::Derivative {
                variable: bound.variable.clone(),
                order: order.clone(),
                closed: body.is_closed_but_for(bound.variable.number()),
                body,
                at: bound.outside.clone(),
            };
            self.made(node, place)
        };
        match self.open(inner, &bound.scope)? {
            Meaning::Term(body) => Ok(Meaning::Term(derivative(body))),
            // The symbol is not a parameter; it may be a shape parameter, for example.
            Meaning::Function(function) => Ok(Meaning::Function(Lambda {
                body: derivative(function.body),
                ..function
            })),
            Meaning::Statement(_) => Err(wrong(inner.place, "a statement", "a formula")),
        }
    }

    /// Opens the hyperbolic functions to halves of the sum and the difference of two exponentials, and to the
    /// quotient of these.
    fn hyperbolic(&self, name: &str, x: &Term, place: Place) -> Term {
        let power = |x: Term| self.made(Node::Apply(BuiltIn::Exponential, vec![x]), place);
        let (up, down) = (
            power(x.clone()),
            power(self.made(Node::Negative(x.clone()), place)),
        );
        let joined = |operator| {
            let node = Node::Binary(operator, up.clone(), down.clone());
            self.made(node, place)
        };
        let above = joined(match name {
            "cosh" if !injected(InjectedFault::CoshAsDifference) => Operator::Add,
            _ => Operator::Subtract,
        });
        let below = match name {
            "tanh" => joined(Operator::Add),
            _ => self.made(Node::Number(rational::integer(2)), place),
        };
        self.made(Node::Binary(Operator::Divide, above, below), place)
    }

    /// Opens the greater and the smaller one of two numbers to half of their sum and the size of their difference, added or
    /// subtracted.
    fn extremum(&self, name: &str, a: &Term, b: &Term, place: Place) -> Term {
        let joined = |operator, a: &Term, b: &Term| {
            self.made(Node::Binary(operator, a.clone(), b.clone()), place)
        };
        let gap = joined(Operator::Subtract, a, b);
        let square = joined(Operator::Multiply, &gap, &gap);
        let size = self.made(Node::Apply(BuiltIn::SquareRoot, vec![square]), place);
        let operator = match name {
            "max" if !injected(InjectedFault::GreaterAsSmaller) => Operator::Add,
            _ => Operator::Subtract,
        };
        let twice = joined(operator, &joined(Operator::Add, a, b), &size);
        let two = self.made(Node::Number(rational::integer(2)), place);
        joined(Operator::Divide, &twice, &two)
    }

    /// The derivative of a function by one of its parameters, as a function.
    pub(super) fn differentiated(
        &self,
        function: &Lambda,
        parameter: &Variable,
        order: Term,
        place: Place,
    ) -> Lambda {
        let variable = self.fresh(parameter.name());
        let inner = self.made(Node::Variable(variable.clone()), place);
        let body = Node::Let {
            variable: parameter.clone(),
            value: inner,
            body: function.body.clone(),
        };
        let body = self.made(body, place);
        let derivative = Node::Derivative {
            order,
            closed: body.is_closed_but_for(variable.number()),
            variable,
            body,
            at: self.made(Node::Variable(parameter.clone()), place),
        };
        Lambda {
            name: Arc::clone(&function.name),
            parameters: function.parameters.clone(),
            body: self.made(derivative, place),
        }
    }
}

/// Fails if a term replaces the variable of the basis, because a property is about all values of that variable.
fn quantified(basis: &Basis, place: Place, scope: &Scope) -> Outcome<()> {
    if scope.globals.contains_key(&basis.variable) {
        return Err(wrong(
            place,
            "a property of a basis at one value of the variable of the basis",
            "a symbol that the property is not about",
        ));
    }
    Ok(())
}

/// Reads a degree that is at least `least`.
fn degree(number: &Expr, least: u8, wanted: &'static str) -> Outcome<u8> {
    let value = match &number.node {
        formula::Node::Number { value, .. } if value.is_integer() => {
            u8::try_from(&value.to_integer()).ok()
        }
        _ => None,
    };
    let value = value.filter(|value| *value >= least);
    value.ok_or_else(|| wrong(number.place, "something else", wanted))
}

/// The printed numbers of `agrees`, with their digits.
fn printed_numbers(printed: &Expr) -> Outcome<Vec<Printed>> {
    let number = |item: &Expr| -> Option<(Rational, Option<u32>)> {
        match &item.node {
            formula::Node::Number { value, decimals } => Some((value.clone(), *decimals)),
            _ => None,
        }
    };
    let one = |item: &Expr| -> Outcome<Printed> {
        let (found, negative) = match &item.node {
            formula::Node::Negative(inner) => (number(inner), true),
            _ => (number(item), false),
        };
        let (value, decimals) =
            found.ok_or_else(|| wrong(item.place, "a formula", "a printed number"))?;
        Ok(Printed {
            value: if negative && !injected(InjectedFault::PrintedSignLost) {
                -value
            } else {
                value
            },
            decimals,
            negative,
        })
    };
    match &printed.node {
        formula::Node::List(items) => items.iter().map(one).collect(),
        _ => Ok(vec![one(printed)?]),
    }
}
