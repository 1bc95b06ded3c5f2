//! The formulas of a claim: those that it writes itself, and all that these use.

use std::collections::BTreeSet;
use torse_algebra::Rational;
use torse_algebra::rational::integer;
use torse_syntax::derivation::Claim;
use torse_syntax::derivation::declarations::{Declarations, Definition};
use torse_syntax::formula::{Expr, Node, Operator};

/// The formulas of a claim.
pub struct Formulas<'a> {
    /// What the claim itself writes: statement, hypotheses, and its own definitions that they use.
    pub own: Vec<&'a Expr>,
    /// The same, with all definitions and bases that they use.
    pub reached: Vec<&'a Expr>,
    /// The declared names that occur in these, without primes.
    pub names: BTreeSet<&'a str>,
    /// The names that the claim itself declares.
    pub local: BTreeSet<&'a str>,
}

impl<'a> Formulas<'a> {
    /// Collects the formulas of this claim.
    pub fn new(claim: &'a Claim) -> Self {
        let heads = claim.entry.local.keys();
        let heads = heads.map(|head| head.split_once('(').map_or(head.as_str(), |(name, _)| name));
        let narrows = |name: &str| {
            let range = claim.declarations.range(name);
            range.is_some_and(|range| range.outer.is_some())
        };
        let symbols = claim.entry.symbols.keys().map(String::as_str);
        let local = heads.map(str::trim).chain(symbols.filter(|s| !narrows(s)));
        let local: BTreeSet<&str> = local.collect();
        let hypotheses = claim.assumptions.iter().chain(&claim.given);
        let written = claim.statement.iter().map(|w| &w.expr);
        let written: Vec<&Expr> = written
            .chain(hypotheses.map(|h| &h.formula.expr))
            .chain(claim.unknowns.iter().map(|w| &w.expr))
            .collect();
        let mut found = Self {
            own: vec![],
            reached: vec![],
            names: BTreeSet::new(),
            local,
        };
        for expr in written {
            found.own.push(expr);
            found.reach(expr, &claim.declarations);
        }
        found
    }

    fn reach(&mut self, expr: &'a Expr, declarations: &'a Declarations) {
        let mut pending = vec![expr];
        while let Some(expr) = pending.pop() {
            self.reached.push(expr);
            for written in expr.names() {
                for name in [written, written.trim_end_matches('\'')] {
                    let definition = declarations.definition(name);
                    let basis = declarations.basis(name);
                    let symbol = declarations.symbol(name);
                    if definition.is_none() && basis.is_none() && symbol.is_none() {
                        continue;
                    }
                    if !self.names.insert(name) {
                        break;
                    }
                    if let Some(definition) = definition {
                        if self.local.contains(name) {
                            self.own.push(&definition.body.expr);
                        }
                        pending.push(&definition.body.expr);
                    }
                    if let Some(basis) = basis {
                        let steps = [&basis.step.0, &basis.step.1];
                        pending.extend(basis.seeds.iter().chain(steps).map(|w| &w.expr));
                    }
                    break;
                }
            }
        }
    }
}

/// Whether a definition takes the order of a derivative, or a number for a factorial, at this place: such a number
/// selects one of many, as an index does.
pub fn counts(definition: &Definition, place: usize) -> bool {
    let Some(parameter) = definition.parameters.get(place) else {
        return false;
    };
    let mut found = false;
    visit_parts(&definition.body.expr, &mut |part| {
        if let Node::Call(head, arguments) = &part.node {
            let order = match (&head.node, arguments.as_slice()) {
                (Node::Name(name), [_, _, order]) if name == "D" => order,
                (Node::Name(name), [number]) if name == "factorial" => number,
                _ => return,
            };
            found |= matches!(&order.node, Node::Name(name) if name == parameter);
        }
    });
    found
}

/// Every part of a formula, itself first.
pub fn visit_parts<'e>(expr: &'e Expr, visit: &mut dyn FnMut(&'e Expr)) {
    visit(expr);
    for part in expr.parts() {
        visit_parts(part, visit);
    }
}

/// Returns the value of a number or of a quotient of numbers.
pub fn value(expr: &Expr) -> Option<Rational> {
    match &expr.node {
        Node::Number { value, .. } => Some(value.clone()),
        Node::Binary(Operator::Divide, a, b) => match (&a.node, &b.node) {
            (Node::Number { value: a, .. }, Node::Number { value: b, .. }) if *b != integer(0) => {
                Some(a.clone() / b)
            }
            _ => None,
        },
        _ => None,
    }
}
