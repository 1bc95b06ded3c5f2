//! Flags a statement with fewer relations than its sentence.

use super::formulas::{Formulas, visit_parts};
use super::occurrences::is_property;
use super::{RaisedFlag, Subject, raised};
use torse_syntax::derivation::Claim;
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::formula::{Expr, Node, Relation};
use torse_syntax::taxonomy::Flag;

/// Counts the relations that a claim states or assumes; a definition that it uses, a property expressed by a word, and
/// an end of a range count as one each.
pub(super) fn relations_of(claim: &Claim) -> usize {
    let formulas = Formulas::new(claim);
    let mut count = 0;
    for expr in &formulas.own {
        visit_parts(expr, &mut |part| count += relations(part));
    }
    let defined = formulas.names.iter();
    let defined = defined.filter(|name| claim.declarations.definition(name).is_some());
    let symbols = formulas.names.iter();
    let symbols = symbols.filter_map(|name| claim.declarations.symbol(name));
    count + defined.count() + symbols.map(ends).sum::<usize>()
}

/// Returns the number of ends of the range of a symbol.
fn ends(kind: &SymbolKind) -> usize {
    let ends = match kind {
        SymbolKind::Real(range) => [range.lower.is_some(), range.upper.is_some()],
        SymbolKind::Integer { least, most } => [least.is_some(), most.is_some()],
        _ => [false, false],
    };
    ends.into_iter().filter(|has| *has).count()
}

/// Counts the relations of a formula; an equation of vectors counts once for each entry that is written out.
fn relations(expr: &Expr) -> usize {
    match &expr.node {
        Node::Compare(_, rest) => rest.iter().map(|(_, side)| entries(side)).sum(),
        Node::Call(head, _) => {
            let property = matches!(&head.node, Node::Name(name) if is_property(name));
            usize::from(property)
        }
        _ => 0,
    }
}

fn entries(expr: &Expr) -> usize {
    match &expr.node {
        Node::List(items) => items.iter().map(entries).sum(),
        _ => 1,
    }
}

/// Whether the formula states an equation.
pub(super) fn has_equation(expr: &Expr) -> bool {
    let mut found = false;
    visit_parts(expr, &mut |part| {
        if let Node::Compare(_, rest) = &part.node {
            found |= rest
                .iter()
                .any(|(relation, _)| *relation == Relation::Equal);
        }
    });
    found
}

/// Flags a sentence whose parts together state fewer relations than are printed.
pub(super) fn missing_relations(subject: &Subject<'_>) -> Vec<RaisedFlag> {
    let (stated, printed) = (subject.relations_of_all_parts, subject.print.relations);
    match stated < printed {
        true => {
            let evidence = format!("{printed} relations are printed, {stated} stated or defined");
            vec![raised(Flag::ShortConjunction, evidence)]
        }
        false => vec![],
    }
}
