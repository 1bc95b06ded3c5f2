//! Flags ranges and hypotheses without a source: neither words of the paper nor ours.

use super::{RaisedFlag, Subject, one_flag_for};
use std::collections::BTreeSet;
use torse_syntax::derivation::declarations::{Declarations, SymbolKind};
use torse_syntax::derivation::{Claim, Provenance};
use torse_syntax::formula::{Expr, Node};
use torse_syntax::notation::text;
use torse_syntax::taxonomy::Flag;

/// Returns the ranges of symbols in the formulas of a paper's claim and its hypotheses that have no source. A worked
/// folder has no print but its file; and where the formulas themselves begin and end is no hypothesis.
pub(super) fn missing_sources(subject: &Subject<'_>) -> Vec<RaisedFlag> {
    if subject.is_worked {
        return vec![];
    }
    let claim = subject.claim;
    let declarations = &claim.declarations;
    let ranges = free_symbols(claim).into_iter().filter(|name| {
        is_bounded(declarations.symbol(name))
            && declarations.range(name).is_none()
            && !is_where_formulas_are(declarations, name)
    });
    let ranges = ranges.map(|name| format!("the range of `{name}`"));
    let hypotheses = claim.assumptions.iter().chain(&claim.given);
    let hypotheses = hypotheses.filter(|own| matches!(own.provenance, Provenance::Stated));
    let hypotheses = hypotheses.map(|own| format!("`{}`", text(&own.formula.expr)));
    one_flag_for(
        Flag::UnsourcedRange,
        "neither printed nor ours",
        ranges.chain(hypotheses).collect(),
    )
}

fn is_bounded(kind: Option<&SymbolKind>) -> bool {
    match kind {
        Some(SymbolKind::Real(interval)) => {
            interval.lower.is_some()
                || interval.upper.is_some()
                || interval.formulas().next().is_some()
        }
        Some(SymbolKind::Integer { least, most }) => least.is_some() || most.is_some(),
        _ => false,
    }
}

/// The symbols of which the statement and the hypotheses speak, directly or through definitions: no index of a sum and no
/// parameter of a definition.
fn free_symbols(claim: &Claim) -> BTreeSet<&str> {
    let hypotheses = claim.assumptions.iter().chain(&claim.given);
    let written = claim.statement.iter().map(|written| &written.expr);
    let written = written.chain(hypotheses.map(|own| &own.formula.expr));
    let mut free = Free {
        declarations: &claim.declarations,
        seen: BTreeSet::new(),
        symbols: BTreeSet::new(),
    };
    for expr in written {
        free.collect(expr, &BTreeSet::new());
    }
    free.symbols
}

struct Free<'a> {
    declarations: &'a Declarations,
    /// The definitions that were entered.
    seen: BTreeSet<&'a str>,
    symbols: BTreeSet<&'a str>,
}

impl<'a> Free<'a> {
    fn collect(&mut self, expr: &'a Expr, bound: &BTreeSet<&'a str>) {
        match &expr.node {
            Node::Name(name) => self.name(name, bound),
            Node::Call(head, arguments) => match (&head.node, arguments.as_slice()) {
                (Node::Name(name), [index, low, high, term])
                    if matches!(name.as_str(), "sum" | "product") =>
                {
                    let mut inner = bound.clone();
                    if let Node::Name(index) = &index.node {
                        inner.insert(index);
                    }
                    self.collect(low, bound);
                    self.collect(high, bound);
                    self.collect(term, &inner);
                }
                _ => {
                    self.left_out_parameters(head, arguments.len(), bound);
                    self.collect(head, bound);
                    for argument in arguments {
                        self.collect(argument, bound);
                    }
                }
            },
            _ => {
                for part in expr.parts() {
                    self.collect(part, bound);
                }
            }
        }
    }

    /// Arguments of a basis that are left out are the symbols of the names of its parameters.
    fn left_out_parameters(&mut self, head: &'a Expr, given: usize, bound: &BTreeSet<&'a str>) {
        if let Node::Index(name, _) = &head.node
            && let Node::Name(name) = &name.node
            && let Some(basis) = self.declarations.basis(name.trim_end_matches('\''))
        {
            for parameter in basis.parameters.iter().skip(given.saturating_sub(1)) {
                self.name(parameter, bound);
            }
        }
    }

    fn name(&mut self, written: &'a str, bound: &BTreeSet<&'a str>) {
        let name = written.trim_end_matches('\'');
        if bound.contains(name) {
            return;
        }
        if self.declarations.symbol(name).is_some() {
            self.symbols.insert(name);
        } else if let Some(definition) = self.declarations.definition(name)
            && self.seen.insert(name)
        {
            let parameters = definition.parameters.iter().map(String::as_str);
            self.collect(&definition.body.expr, &parameters.collect());
        }
    }
}

/// Whether a range is that of an order from the lowest one of a basis on, or that of the indices of a family: outside of
/// it there are no such functions and members, so that it excludes nothing.
fn is_where_formulas_are(declarations: &Declarations, name: &str) -> bool {
    let Some(SymbolKind::Integer {
        least: Some(least),
        most,
    }) = declarations.symbol(name)
    else {
        return false;
    };
    match most {
        None => declarations
            .bases()
            .any(|(_, basis)| least.as_number() == Some(i64::from(basis.degree))),
        Some(most) => {
            let kinds = declarations
                .names()
                .filter_map(|name| declarations.symbol(name));
            let mut families = kinds.filter_map(|kind| match kind {
                SymbolKind::Family { ranges, .. } => Some(ranges),
                _ => None,
            });
            families.any(|ranges| {
                ranges
                    .iter()
                    .any(|(low, high)| low == least && high == most)
            })
        }
    }
}
