//! The names that edits of a claim may insert: those that occur in it, directly or through definitions.

use std::collections::BTreeSet;
use torse_syntax::derivation::Claim;
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::formula::{Expr, Node};

/// Maximum number of names of a kind.
const MAX_NAMES: usize = 16;
/// Maximum number of functions, and of the places where they are evaluated.
const MAX_CALLS: usize = 6;

/// The names that an edit may insert.
#[derive(Debug, Clone, Default)]
pub struct Alphabet {
    /// Numbers and vectors that occur in the claim.
    pub names: Vec<String>,
    /// Families of points or scalars that occur in the claim.
    pub families: Vec<String>,
    /// Members of these families with indices as they occur in the formula, for a zero.
    pub members: Vec<Expr>,
    /// Neighbouring names in the arguments of some call of the claim, such as two shape parameters.
    pub pairs: Vec<[String; 2]>,
    /// Functions of one variable that the claim calls, without primes.
    pub functions: Vec<String>,
    /// The places where it evaluates them.
    pub places: Vec<Expr>,
    /// Basis families: name, lowest degree, number of arguments.
    pub bases: Vec<(String, u8, usize)>,
}

impl Alphabet {
    /// Drops numbers and vectors: returns what a second edit may insert.
    #[must_use]
    pub fn without_names(&self) -> Self {
        Self {
            names: vec![],
            ..self.clone()
        }
    }
}

/// Numbers, vectors and families that occur in the claim, through definitions; those of the formula
/// itself first.
#[must_use]
pub fn alphabet(claim: &Claim, statement: &Expr, edited: &Expr) -> Alphabet {
    let mut seen: BTreeSet<String> = BTreeSet::new();
    let mut alphabet = Alphabet::default();
    let mut level: Vec<&Expr> = [edited, statement]
        .into_iter()
        .chain(claim.given.iter().map(|h| &h.formula.expr))
        .collect();
    for expr in &level {
        collect_calls(expr, claim, &mut alphabet);
    }
    let mut first = true;
    while !level.is_empty() {
        let mut deeper = vec![];
        for expr in &level {
            collect_pairs(expr, &mut alphabet.pairs);
        }
        for name in level.iter().flat_map(|e| e.names()) {
            if !seen.insert(name.to_owned()) {
                continue;
            }
            match claim.declarations.symbol(name) {
                Some(SymbolKind::Real(_) | SymbolKind::Integer { .. } | SymbolKind::Vector(_)) => {
                    alphabet.names.push(name.to_owned());
                }
                Some(SymbolKind::Family { .. }) => alphabet.families.push(name.to_owned()),
                None => {}
            }
            if let Some(definition) = claim.declarations.definition(name) {
                if definition.parameters.is_empty() && first {
                    alphabet.names.push(name.to_owned());
                }
                deeper.push(&definition.body.expr);
            }
        }
        level = deeper;
        first = false;
    }
    // A name is usually one of a pair.
    for (one, other) in [
        ("mu", "nu"),
        ("mu1", "nu1"),
        ("mu2", "nu2"),
        ("k", "l"),
        ("m", "n"),
    ] {
        for (present, absent) in [(one, other), (other, one)] {
            if seen.contains(present)
                && claim.declarations.symbol(absent).is_some()
                && seen.insert(absent.to_owned())
            {
                alphabet.names.push(absent.to_owned());
            }
        }
    }
    alphabet.names.truncate(MAX_NAMES);
    alphabet.families.truncate(MAX_NAMES);
    alphabet.pairs.truncate(MAX_NAMES);
    alphabet.members = members(edited, &alphabet.families);
    let bases = claim.declarations.bases().map(|(name, basis)| {
        let arguments = basis.parameters.len() + 1;
        (name.to_owned(), basis.degree, arguments)
    });
    alphabet.bases = bases.collect();
    alphabet
}

/// Neighbouring names among the arguments of calls, in the order of the text.
fn collect_pairs(expr: &Expr, into: &mut Vec<[String; 2]>) {
    if let Node::Call(_, arguments) = &expr.node {
        for pair in arguments.windows(2) {
            let [a, b] = pair else { continue };
            if let (Node::Name(a), Node::Name(b)) = (&a.node, &b.node) {
                let pair = [a.clone(), b.clone()];
                if !into.contains(&pair) {
                    into.push(pair);
                }
            }
        }
    }
    for part in expr.parts() {
        collect_pairs(part, into);
    }
}

/// Functions of one variable that are called, and their arguments.
fn collect_calls(expr: &Expr, claim: &Claim, into: &mut Alphabet) {
    if let Node::Call(head, arguments) = &expr.node
        && let (Node::Name(name), [place]) = (&head.node, arguments.as_slice())
    {
        let base = name.trim_end_matches('\'');
        let known = claim.declarations.definition(base).is_some();
        if known && into.functions.len() < MAX_CALLS && !into.functions.iter().any(|f| f == base) {
            into.functions.push(base.to_owned());
        }
        let place = place.placeless();
        if known && into.places.len() < MAX_CALLS && !into.places.contains(&place) {
            into.places.push(place);
        }
    }
    for part in expr.parts() {
        collect_calls(part, claim, into);
    }
}

/// The families at every list of indices that occurs in the formula.
fn members(expr: &Expr, families: &[String]) -> Vec<Expr> {
    let mut found: Vec<Expr> = vec![];
    let mut pending = vec![expr];
    while let Some(part) = pending.pop() {
        pending.extend(part.parts());
        let Node::Index(head, indices) = &part.node else {
            continue;
        };
        if !matches!(&head.node, Node::Name(name) if families.contains(name)) {
            continue;
        }
        for family in families {
            let member = Expr::made(Node::Index(Expr::name(family).into(), indices.clone()));
            if !found.iter().any(|e| e.node == member.node) {
                found.push(member);
            }
        }
    }
    found.truncate(MAX_NAMES);
    found
}
