//! How the names of formulas occur: which are integers, and with which indices families stand.

use crate::index::{AffineIndex, IndexRange};
use std::collections::{BTreeMap, BTreeSet};
use torse_syntax::formula::{Expr, Node, Operator};

/// An index of a family or a basis.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum UsedIndex {
    /// Every index of a range: a number, or the index of a sum with what is added to it.
    Range(IndexRange),
    /// A symbol that no sum binds, with what is added to it.
    Free(AffineIndex),
    /// Anything else.
    Other,
}

/// How the names of formulas occur.
#[derive(Debug, Default)]
pub struct Occurrences {
    /// All names that no sum binds.
    pub names: BTreeSet<String>,
    /// Those that can be nothing but integers: in an index, a bound, a binomial coefficient or a factorial.
    pub integers: BTreeSet<String>,
    /// Those that stand in exponents.
    pub exponents: BTreeSet<String>,
    /// Those that occur in the bounds of sums and products.
    pub bounds: BTreeSet<String>,
    /// The indices of families and bases.
    pub indices: BTreeMap<String, Vec<Vec<UsedIndex>>>,
    /// Names over which a binomial coefficient takes others: `n` and `i` of `binom(n, i)`.
    pub chosen: Vec<(Expr, String)>,
    /// Functions with their arguments.
    pub calls: Vec<(String, Vec<Expr>)>,
}

/// A bound name with its range, if it is the index of a sum of which both ends are simple.
pub type Bound = (String, Option<IndexRange>);

impl Occurrences {
    fn integers_of(&mut self, formula: &Expr, bound: &[Bound]) {
        for name in formula.names() {
            if !bound.iter().any(|(own, _)| own == name) && name != "pi" {
                self.integers.insert(name.to_owned());
            }
        }
    }

    /// Adds a formula, in which some names are bound.
    pub fn walk(&mut self, formula: &Expr, bound: &[Bound]) {
        match &formula.node {
            Node::Name(name) => {
                if !bound.iter().any(|(own, _)| own == name) {
                    self.names.insert(name.trim_end_matches('\'').to_owned());
                }
            }
            Node::Call(head, arguments) => self.call(head, arguments, bound),
            Node::Index(head, indices) => {
                self.walk(head, bound);
                if let Node::Name(name) = &head.node {
                    let used = indices.iter().map(|index| used_index(index, bound));
                    let used: Vec<UsedIndex> = used.collect();
                    self.indices.entry(name.clone()).or_default().push(used);
                }
                for index in indices {
                    self.walk(index, bound);
                    self.integers_of(index, bound);
                }
            }
            Node::Binary(Operator::Power, base, exponent) => {
                self.walk(base, bound);
                self.walk(exponent, bound);
                let names = exponent.names().into_iter();
                let free =
                    names.filter(|name| !bound.iter().any(|(own, _)| own == name) && *name != "pi");
                self.exponents.extend(free.map(str::to_owned));
            }
            _ => {
                for part in formula.parts() {
                    self.walk(part, bound);
                }
            }
        }
    }

    fn call(&mut self, head: &Expr, arguments: &[Expr], bound: &[Bound]) {
        let called = match &head.node {
            Node::Name(name) => name.as_str(),
            _ => "",
        };
        match (called, arguments) {
            (
                "sum" | "product",
                [
                    Expr {
                        node: Node::Name(index),
                        ..
                    },
                    low,
                    high,
                    body,
                ],
            ) => {
                for end in [low, high] {
                    self.walk(end, bound);
                    self.integers_of(end, bound);
                    self.bounds
                        .extend(end.names().into_iter().map(str::to_owned));
                }
                let range = AffineIndex::from_formula(low).zip(AffineIndex::from_formula(high));
                let mut inner = bound.to_vec();
                inner.push((index.clone(), range));
                self.walk(body, &inner);
                return;
            }
            ("binom", [n, k]) => {
                self.integers_of(n, bound);
                self.integers_of(k, bound);
                if let Node::Name(k) = &k.node {
                    self.chosen.push((n.clone(), k.clone()));
                }
            }
            ("factorial", [n]) => self.integers_of(n, bound),
            ("", _) => {}
            _ => self.calls.push((called.to_owned(), arguments.to_vec())),
        }
        self.walk(head, bound);
        for argument in arguments {
            self.walk(argument, bound);
        }
    }
}

fn used_index(index: &Expr, bound: &[Bound]) -> UsedIndex {
    let Some(index) = AffineIndex::from_formula(index) else {
        return UsedIndex::Other;
    };
    let Some(symbol) = &index.symbol else {
        return UsedIndex::Range((index.clone(), index));
    };
    match bound.iter().rev().find(|(own, _)| own == symbol) {
        None => UsedIndex::Free(index),
        Some((_, Some((low, high)))) => {
            UsedIndex::Range((low.plus(index.constant), high.plus(index.constant)))
        }
        Some((_, None)) => UsedIndex::Other,
    }
}
