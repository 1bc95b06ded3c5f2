//! The parts of a domain at which a divisor of the statement is zero: a verdict without a condition is wrong there.
//!
//! Divisors are read from the text: the right sides of quotients, bases of powers whose exponents may be negative, the
//! cosine of `tan`, determinants of matrices that are inverted; those of witnesses too, which stand in the places of existential
//! numbers. Definitions, and seeds and steps of bases, are opened, their parameters and bound names
//! replaced: the index of a sum by the numbers of a short range, the variable of `at` by its point, that of an integral by
//! both ends. Such a formula is only a place to look: the statement itself is judged at the points that are found, so a
//! formula that means something else costs an attempt and says nothing.
//!
//! **Not visited:** terms of a sum beyond the first [`MAX_TERMS`], and of one whose lower bound is no number; places between the
//! ends of an integral; steps of a basis that count; divisors beyond the first [`MAX_DIVISORS`], and those of definitions nested more
//! than [`MAX_OPENED`] deep; zeros that are no rational numbers and no roots of them, since points that satisfy an equation only
//! nearly prove no division by zero.

use crate::branches::{Branch, equal};
use crate::tree::Reading;
use std::cell::Cell;
use std::sync::Arc;
use torse_numbers::Rational;
use torse_numbers::rational::integer;
use torse_syntax::derivation::declarations::{Declarations, Definition};
use torse_syntax::formula::{Expr, Node, Operator};

/// The largest number of divisors that are visited.
const MAX_DIVISORS: usize = 16;
/// The largest number of terms of a sum that are visited.
const MAX_TERMS: i64 = 4;
/// The largest depth to which definitions are opened, and the most formulas that are looked at.
const MAX_OPENED: u32 = 8;
const MAX_LOOKS: u32 = 20_000;

/// For each divisor that the statement has: the part of the domain on which it is zero.
pub(crate) fn divisors(reading: &Reading<'_>) -> Vec<Branch> {
    let declarations = reading.declarations();
    let mut found = Divisors::default();
    let search = Search {
        declarations,
        looks: Cell::new(MAX_LOOKS),
    };
    search.visit(reading.tree(), MAX_OPENED, &mut found);
    let witnesses: Vec<(&str, &Expr)> = reading.witnesses().collect();
    let mut found = found.mapped(|divisor| replaced(divisor, &witnesses));
    for (_, witness) in &witnesses {
        search.visit(witness, MAX_OPENED, &mut found);
    }
    let zero = |divisor: Expr| Branch::new(equal(divisor, Expr::number(&integer(0))));
    let all = found.quotients.into_iter().chain(found.powers);
    let all = all.filter(|divisor| !divisor.names().is_empty());
    all.take(MAX_DIVISORS).map(zero).collect()
}

/// Divisors, each once. What is divided by comes before bases of powers, whose exponents need not be negative.
#[derive(Default)]
struct Divisors {
    quotients: Vec<Expr>,
    powers: Vec<Expr>,
}

impl Divisors {
    fn add_quotient(&mut self, divisor: Expr) {
        if !self.quotients.contains(&divisor) {
            self.quotients.push(divisor);
        }
    }

    fn add_power(&mut self, base: Expr) {
        if !self.powers.contains(&base) {
            self.powers.push(base);
        }
    }

    fn extend(&mut self, others: Self) {
        others
            .quotients
            .into_iter()
            .for_each(|own| self.add_quotient(own));
        others
            .powers
            .into_iter()
            .for_each(|own| self.add_power(own));
    }

    fn mapped(&self, map: impl Fn(&Expr) -> Expr) -> Self {
        let mut all = Self::default();
        self.quotients
            .iter()
            .for_each(|own| all.add_quotient(map(own)));
        self.powers.iter().for_each(|own| all.add_power(map(own)));
        all
    }
}

struct Search<'a> {
    declarations: &'a Declarations,
    /// How many formulas may still be looked at.
    looks: Cell<u32>,
}

impl Search<'_> {
    /// Adds the divisors of a formula, each in the names that mean something where the formula stands.
    fn visit(&self, tree: &Expr, depth: u32, found: &mut Divisors) {
        let Some(left) = self.looks.get().checked_sub(1) else {
            return;
        };
        self.looks.set(left);
        match &tree.node {
            Node::Binary(operator, a, b) => {
                match (operator, &b.node) {
                    (Operator::Divide, _) => found.add_quotient(b.placeless()),
                    (Operator::Power, Node::Number { .. }) => {}
                    (Operator::Power, Node::Negative(_)) => found.add_quotient(a.placeless()),
                    (Operator::Power, _) => found.add_power(a.placeless()),
                    _ => {}
                }
                self.visit(a, depth, found);
                self.visit(b, depth, found);
            }
            Node::Name(name) => self.open(name, &[], depth, found),
            Node::Call(head, arguments) | Node::Index(head, arguments) => match &head.node {
                Node::Name(name) => self.apply(name, arguments, depth, found),
                Node::Index(family, _) => {
                    self.visit(head, depth, found);
                    arguments
                        .iter()
                        .for_each(|own| self.visit(own, depth, found));
                    if let Node::Name(name) = &family.node {
                        self.open_basis(name, arguments, depth, found);
                    }
                }
                _ => self.visit(head, depth, found),
            },
            _ => tree
                .parts()
                .into_iter()
                .for_each(|part| self.visit(part, depth, found)),
        }
    }

    /// Adds the divisors of a function at its arguments.
    fn apply(&self, name: &str, arguments: &[Expr], depth: u32, found: &mut Divisors) {
        let call = |function: &str, argument: &Expr| {
            let (head, argument) = (Arc::new(Expr::name(function)), argument.placeless());
            Expr::made(Node::Call(head, vec![argument]))
        };
        match (name, arguments) {
            ("sum" | "product", [index, low, high, term]) => {
                self.visit(low, depth, found);
                self.visit(high, depth, found);
                let (Node::Name(index), Some(low)) = (&index.node, whole(low)) else {
                    return;
                };
                let last = low.saturating_add(MAX_TERMS - 1);
                let last = whole(high).map_or(last, |high| last.min(high));
                for number in low..=last {
                    let own = replaced(term, &[(index.as_str(), &Expr::number(&integer(number)))]);
                    self.visit(&own, depth, found);
                }
            }
            ("at", [body, variable, point]) => self.bound(body, variable, &[point], depth, found),
            ("integral", [body, variable, low, high]) => {
                self.bound(body, variable, &[low, high], depth, found);
            }
            ("tan", [angle]) => {
                found.add_quotient(call("cos", angle));
                self.visit(angle, depth, found);
            }
            ("inverse" | "solve", [matrix, ..]) => {
                found.add_quotient(call("det", matrix));
                arguments
                    .iter()
                    .for_each(|own| self.visit(own, depth, found));
            }
            _ => {
                arguments
                    .iter()
                    .for_each(|own| self.visit(own, depth, found));
                self.open(name.trim_end_matches('\''), arguments, depth, found);
            }
        }
    }

    /// Adds the divisors of a body where its variable has these values.
    fn bound(
        &self,
        body: &Expr,
        variable: &Expr,
        values: &[&Expr],
        depth: u32,
        found: &mut Divisors,
    ) {
        values
            .iter()
            .for_each(|value| self.visit(value, depth, found));
        let Node::Name(name) = &variable.node else {
            return;
        };
        let mut inside = Divisors::default();
        self.visit(body, depth, &mut inside);
        for value in values {
            found.extend(inside.mapped(|divisor| replaced(divisor, &[(name.as_str(), value)])));
            if self.declarations.symbol(name).is_some() {
                // Definitions in it see the value as well.
                found.extend(inside.mapped(|divisor| {
                    let arguments = vec![divisor.clone(), variable.placeless(), value.placeless()];
                    Expr::made(Node::Call(Arc::new(Expr::name("at")), arguments))
                }));
            }
        }
    }

    /// Adds the divisors of seeds and steps of a basis at these arguments; those that are left out have their own names.
    fn open_basis(&self, name: &str, arguments: &[Expr], depth: u32, found: &mut Divisors) {
        let (Some(basis), Some(depth)) = (self.declarations.basis(name), depth.checked_sub(1))
        else {
            return;
        };
        if basis.counters.is_some() {
            return;
        }
        let mut inside = Divisors::default();
        for part in basis.seeds.iter().chain([&basis.step.0, &basis.step.1]) {
            self.visit(&part.expr, depth, &mut inside);
        }
        let names = std::iter::once(&basis.variable).chain(&basis.parameters);
        let values: Vec<(&str, &Expr)> = names.map(String::as_str).zip(arguments).collect();
        found.extend(inside.mapped(|divisor| replaced(divisor, &values)));
    }

    /// Adds the divisors of a definition with these arguments, or of a basis without arguments.
    fn open(&self, name: &str, arguments: &[Expr], depth: u32, found: &mut Divisors) {
        self.open_basis(name, &[], depth, found);
        let (Some(definition), Some(depth)) =
            (self.declarations.definition(name), depth.checked_sub(1))
        else {
            return;
        };
        let Definition {
            parameters, body, ..
        } = definition;
        let mut inside = Divisors::default();
        self.visit(&body.expr, depth, &mut inside);
        let values = parameters.iter().map(String::as_str).zip(arguments);
        let values: Vec<(&str, &Expr)> = values.collect();
        found.extend(inside.mapped(|divisor| replaced(divisor, &values)));
    }
}

/// The formula with others for names.
fn replaced(tree: &Expr, values: &[(&str, &Expr)]) -> Expr {
    let value = |name: &String| values.iter().find(|(own, _)| own == name);
    match &tree.node {
        Node::Name(name) => {
            value(name).map_or_else(|| tree.clone(), |(_, value)| value.placeless())
        }
        _ => tree.with_parts(|part| replaced(part, values)),
    }
}

/// The integer that a formula is written as.
fn whole(tree: &Expr) -> Option<i64> {
    match &tree.node {
        Node::Number { value, .. } if value.is_integer() => {
            i64::try_from(&Rational::to_integer(value)).ok()
        }
        Node::Negative(inner) => whole(inner)?.checked_neg(),
        _ => None,
    }
}
