//! Flags a sentence about all cases that is stated for one: one degree, one coordinate, one value.

use super::formulas::{counts, value, visit_parts};
use super::print::Print;
use super::{RaisedFlag, Subject, one_flag_for};
use std::collections::BTreeSet;
use torse_algebra::Rational;
use torse_syntax::derivation::declarations::{Declarations, SymbolKind};
use torse_syntax::formula::{Expr, Node, Relation};
use torse_syntax::taxonomy::{Flag, Verdict};

/// The words for a degree.
const DEGREES: [(&str, &[&str]); 6] = [
    ("1", &["linear", "one", "bilinear"]),
    (
        "2",
        &[
            "quadratic",
            "second",
            "two",
            "biquadratic",
            "parabol",
            "conic",
        ],
    ),
    ("3", &["cubic", "third", "three", "bicubic"]),
    ("4", &["quartic", "fourth", "four", "biquartic"]),
    ("5", &["quintic", "fifth", "five", "biquintic"]),
    ("6", &["sextic", "sixth", "six"]),
];

/// Returns a degree that the claim fixes by a number and the print does not name. To refute a sentence, one degree is
/// enough.
pub(super) fn fixed_degrees(subject: &Subject<'_>) -> Vec<RaisedFlag> {
    if refuted(subject) {
        return vec![];
    }
    let named = |degree: &Rational| {
        let text = degree.to_string();
        let words = DEGREES.iter().find(|(digit, _)| *digit == text);
        subject.context.mentioned.contains(degree)
            || words.is_some_and(|(_, words)| subject.context.has_word_beginning_with(words))
    };
    let degrees = degrees(subject);
    let unnamed = degrees.iter().filter(|degree| !named(degree));
    let unnamed = unnamed.map(ToString::to_string).collect();
    one_flag_for(Flag::OneDegree, "a degree that is not printed", unnamed)
}

/// Whether the statement is refuted; for that, one instance is enough.
fn refuted(subject: &Subject<'_>) -> bool {
    matches!(
        subject.outcome.verdict(),
        Verdict::False | Verdict::Misprint
    )
}

/// Whether this name stands for an integer.
fn is_degree(name: &Expr, declarations: &Declarations) -> bool {
    let symbol = match &name.node {
        Node::Name(name) => declarations.symbol(name),
        _ => None,
    };
    matches!(symbol, Some(SymbolKind::Integer { .. }))
}

/// Returns the degrees that a claim fixes by a number.
pub(super) fn degrees(subject: &Subject<'_>) -> BTreeSet<Rational> {
    let declarations = &subject.claim.declarations;
    let mut degrees: BTreeSet<Rational> = BTreeSet::new();
    for expr in &subject.formulas.own {
        visit_parts(expr, &mut |part| match &part.node {
            Node::Index(head, indices) => {
                let basis =
                    matches!(&head.node, Node::Name(name) if declarations.basis(name).is_some());
                if let (true, [_, degree]) = (basis, indices.as_slice()) {
                    degrees.extend(value(degree));
                }
            }
            Node::Call(head, arguments) => {
                let at = matches!(&head.node, Node::Name(name) if name == "at");
                if let (true, [_, of, degree]) = (at, arguments.as_slice())
                    && is_degree(of, declarations)
                {
                    degrees.extend(value(degree));
                }
            }
            _ => degrees.extend(fixed(part).and_then(|(name, value)| {
                let integer = matches!(declarations.symbol(name), Some(SymbolKind::Integer { .. }));
                integer.then_some(value)
            })),
        });
    }
    degrees
}

/// Returns a single coordinate of a vector, if the print does not speak of coordinates.
pub(super) fn single_coordinates(subject: &Subject<'_>) -> Vec<RaisedFlag> {
    // One coordinate determines a plane x = h.
    const WORDS: [&str; 13] = [
        "plane",
        "coordinate",
        "component",
        "abscissa",
        "ordinate",
        "height",
        "entry",
        "entries",
        "element",
        "column",
        "row",
        "weight",
        "x",
    ];
    let declarations = &subject.claim.declarations;
    let mut entries: BTreeSet<Rational> = BTreeSet::new();
    let statement = subject.claim.statement.iter();
    statement.for_each(|w| {
        visit_parts(&w.expr, &mut |part| {
            if let Node::Index(head, indices) = &part.node
                && let [index] = indices.as_slice()
            {
                let of_many = matches!(
                    &head.node,
                    Node::Name(name) if declarations.basis(name).is_some()
                        || matches!(declarations.symbol(name), Some(SymbolKind::Family { .. }))
                );
                if !of_many {
                    entries.extend(value(index));
                }
            }
        });
    });
    match entries.len() {
        1 if !subject.print.has_word_beginning_with(&WORDS)
            && !Print::from_text(&subject.claim.entry.at).has_word_beginning_with(&WORDS) =>
        {
            let entries = entries.iter().map(ToString::to_string).collect();
            one_flag_for(Flag::OneCoordinate, "one entry of a vector alone", entries)
        }
        _ => vec![],
    }
}

/// Returns the values that symbols are fixed to, or that functions are taken at, by formulas that are not printed.
fn values(subject: &Subject<'_>) -> BTreeSet<Rational> {
    let declarations = &subject.claim.declarations;
    let mut values = BTreeSet::new();
    let hypotheses = subject.claim.assumptions.iter();
    for hypothesis in hypotheses.filter(|h| h.provenance.quote().is_none()) {
        visit_parts(&hypothesis.formula.expr, &mut |part| {
            values.extend(fixed(part).and_then(|(name, value)| {
                let real = matches!(declarations.symbol(name), Some(SymbolKind::Real(_)));
                real.then_some(value)
            }));
        });
    }
    for expr in &subject.formulas.own {
        visit_parts(expr, &mut |part| {
            if let Node::Call(head, arguments) = &part.node {
                let name = match &head.node {
                    Node::Name(name) => name.trim_end_matches('\''),
                    _ => "",
                };
                let definition = declarations.definition(name);
                let taken = match (name, arguments.as_slice(), definition) {
                    ("at", [_, of, at], _) if !is_degree(of, declarations) => vec![at],
                    (_, arguments, Some(definition)) => {
                        let numbered = arguments.iter().enumerate();
                        let values = numbered.filter(|(place, _)| !counts(definition, *place));
                        values.map(|(_, argument)| argument).collect()
                    }
                    _ => vec![],
                };
                values.extend(taken.into_iter().filter_map(value));
            }
        });
    }
    values
}

/// Returns a value for all symbols that the print does not have; the ends 0 and 1 of an interval do not count.
pub(super) fn fixed_values(subject: &Subject<'_>) -> Vec<RaisedFlag> {
    if refuted(subject) {
        return vec![];
    }
    let ends = |value: &Rational| value.is_integer() && ["0", "1"].contains(&&*value.to_string());
    let values = values(subject);
    let unprinted = values.iter().filter(|value| {
        let parts = [value.numer(), value.denom()].map(|i| Rational::from_integer(i.clone()));
        let printed = &subject.context.mentioned;
        let quotient = parts.iter().all(|part| printed.contains(part));
        !ends(value) && !printed.contains(*value) && !quotient
    });
    let unprinted = unprinted.map(ToString::to_string).collect();
    one_flag_for(Flag::OneInstance, "a value that is not printed", unprinted)
}

/// `name == number`.
fn fixed(expr: &Expr) -> Option<(&str, Rational)> {
    let Node::Compare(left, rest) = &expr.node else {
        return None;
    };
    let [(Relation::Equal, right)] = rest.as_slice() else {
        return None;
    };
    match (&left.node, &right.node) {
        (Node::Name(name), _) => Some((name, value(right)?)),
        (_, Node::Name(name)) => Some((name, value(left)?)),
        _ => None,
    }
}
