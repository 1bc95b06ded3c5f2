//! Flags numbers, names and relations that stand in the print or in the statement alone.

use super::formulas::{counts, value, visit_parts};
use super::print::{Print, explained, stem};
use super::{RaisedFlag, Subject, instance, one_flag_for, raised};
use std::collections::BTreeSet;
use torse_algebra::Rational;
use torse_algebra::rational::integer;
use torse_syntax::derivation::declarations::{Declarations, SymbolKind};
use torse_syntax::formula::{Expr, Node, Relation};
use torse_syntax::taxonomy::Flag;

/// Numbers too frequent to be a sign.
fn everywhere(number: &Rational) -> bool {
    [0, 1, 2].map(integer).contains(number)
}

/// What one of print and statement has and the other has not, in words.
pub(super) struct Differing {
    /// Printed, and not stated.
    pub lacks: Vec<String>,
    /// Stated, and not printed.
    pub adds: Vec<String>,
}

impl Differing {
    /// Leaves out what differs there too.
    pub fn beside(mut self, other: &Self) -> Self {
        self.lacks.retain(|thing| !other.lacks.contains(thing));
        self.adds.retain(|thing| !other.adds.contains(thing));
        self
    }
}

/// Flags the numbers of the print that no formula has, and the numbers of the claim that the print lacks.
pub(super) fn numbers(subject: &Subject<'_>) -> Vec<RaisedFlag> {
    let Differing { lacks, adds } = differing_numbers(subject);
    let mut flags = one_flag_for(Flag::LacksNumber, "printed and not stated", lacks);
    flags.extend(one_flag_for(
        Flag::AddsNumber,
        "stated and not printed",
        adds,
    ));
    flags
}

/// Returns the numbers of the print that no formula has, and the numbers of the claim that the print lacks.
pub(super) fn differing_numbers(subject: &Subject<'_>) -> Differing {
    let mut reached = BTreeSet::new();
    for expr in &subject.formulas.reached {
        visit_parts(expr, &mut |part| reached.extend(value(part)));
    }
    let names = subject.formulas.names.iter();
    reached.extend(names.flat_map(|name| digits(name)));
    reached.extend(bounds(subject));
    let own: BTreeSet<Rational> = subject
        .formulas
        .own
        .iter()
        .flat_map(|e| free(e, &subject.claim.declarations))
        .collect();
    // Degrees are checked separately.
    let degrees = instance::degrees(subject);
    let printed = &subject.context.mentioned;
    let shown = |numbers: Vec<&Rational>| -> Vec<String> {
        let telling = numbers.into_iter().filter(|n| !everywhere(n));
        telling.map(ToString::to_string).collect()
    };
    // A quotient counts with its parts: 1/2 may be printed as 0.5.
    let parts = |n: &Rational| {
        let parts = [n.numer(), n.denom()].map(|i| Rational::from_integer(i.clone()));
        printed.contains(n) || parts.iter().all(|p| printed.contains(p) || everywhere(p))
    };
    let lacks = subject
        .print
        .numbers
        .iter()
        .filter(|n| !reached.contains(*n))
        .collect();
    let adds = own
        .iter()
        .filter(|n| !parts(n) && !degrees.contains(*n))
        .collect();
    Differing {
        lacks: shown(lacks),
        adds: shown(adds),
    }
}

/// Returns the numbers of a formula that are neither indices nor orders of derivatives.
fn free(expr: &Expr, declarations: &Declarations) -> Vec<Rational> {
    let free = |part| free(part, declarations);
    match &expr.node {
        Node::Index(head, _) => free(head),
        Node::Call(head, arguments) => {
            let name = match &head.node {
                Node::Name(name) => name.as_str(),
                _ => "",
            };
            let definition = declarations.definition(name);
            let numbered = arguments.iter().enumerate();
            let values = numbered.filter(|(place, _)| match definition {
                Some(definition) => !counts(definition, *place),
                None => name != "D" || *place < 2,
            });
            values.flat_map(|(_, argument)| free(argument)).collect()
        }
        _ => match value(expr) {
            Some(value) => vec![value],
            None => expr.parts().into_iter().flat_map(free).collect(),
        },
    }
}

/// The numbers in a name: 3 in `E1_3`.
fn digits(name: &str) -> Vec<Rational> {
    let numbers = name.split(|c: char| !c.is_ascii_digit());
    let numbers = numbers.filter_map(|digits| digits.parse::<i64>().ok());
    numbers.map(integer).collect()
}

/// Returns the bounds of the symbols that occur.
fn bounds(subject: &Subject<'_>) -> Vec<Rational> {
    let names = subject.formulas.names.iter();
    let kinds = names.filter_map(|name| subject.claim.declarations.symbol(name));
    let mut bounds = vec![];
    for kind in kinds {
        match kind {
            SymbolKind::Real(interval) => {
                let ends = [&interval.lower, &interval.upper].into_iter().flatten();
                bounds.extend(ends.filter_map(|end| end.value.as_rational().cloned()));
            }
            SymbolKind::Integer { least, most } => {
                bounds.extend(
                    [least, most]
                        .into_iter()
                        .flatten()
                        .map(|end| integer(end.constant())),
                );
            }
            _ => {}
        }
    }
    bounds
}

/// Flags printed names that are declared and do not occur, and free numbers of the statement that the print does not name.
pub(super) fn names(subject: &Subject<'_>) -> Vec<RaisedFlag> {
    let Differing { lacks, adds } = differing_names(subject);
    let mut flags = one_flag_for(Flag::LacksName, "printed and not stated", lacks);
    flags.extend(one_flag_for(Flag::AddsName, "stated and not printed", adds));
    flags
}

/// Returns printed names that are declared and do not occur, and free numbers of the statement that the print does not
/// name.
pub(super) fn differing_names(subject: &Subject<'_>) -> Differing {
    let declarations = &subject.claim.declarations;
    // Names bound by sums and derivatives count too, and so do printed forms of names.
    let written = subject.formulas.reached.iter().flat_map(|e| e.names());
    let written: BTreeSet<&str> = written
        .chain(subject.formulas.names.iter().copied())
        .collect();
    let shown = written.iter().filter_map(|name| declarations.display(name));
    let shown = shown.flat_map(|text| text.split(|c: char| !c.is_ascii_alphabetic()));
    let shown: BTreeSet<&str> = shown.collect();
    let reached: BTreeSet<&str> = written.iter().map(|name| stem(name)).collect();
    let declared: BTreeSet<&str> = declarations.names().map(stem).collect();
    let printed = Print::from_text(explained(&subject.claim.entry.printed));
    let printed = printed.names.iter().map(String::as_str);
    let lacks = printed.filter(|name| {
        declared.contains(name) && !reached.contains(name) && !shown.contains(*name)
    });
    let mut stated = BTreeSet::new();
    if let Some(formula) = &subject.claim.statement {
        free_names(&formula.expr, declarations, &mut stated);
    }
    let adds = stated.into_iter().filter(|name| {
        let free = matches!(declarations.symbol(name), Some(SymbolKind::Real(_)));
        let shown = declarations.display(name).unwrap_or_default();
        let mut shown = shown.split(|c: char| !c.is_ascii_alphabetic());
        let printed = |letters: &str| subject.context.letters.contains(letters);
        free && !printed(stem(name)) && !shown.any(|letters| letters.len() == 1 && printed(letters))
    });
    let shown = |name: &str| format!("`{name}`");
    Differing {
        lacks: lacks.map(shown).collect(),
        adds: adds.map(shown).collect(),
    }
}

/// Returns the names of a formula, except places where functions are evaluated and variables of derivatives and sums.
fn free_names<'e>(expr: &'e Expr, declarations: &Declarations, found: &mut BTreeSet<&'e str>) {
    match &expr.node {
        Node::Name(name) => {
            found.insert(name);
        }
        Node::Call(head, arguments) => {
            let name = match &head.node {
                Node::Name(name) => name.as_str(),
                // A derivative evaluated at a place: `D(G, mu)(x)`.
                Node::Call(..) => "at",
                Node::Index(head, _) => match &head.node {
                    Node::Name(name) => name.as_str(),
                    _ => "",
                },
                _ => "",
            };
            let name = name.trim_end_matches('\'');
            let function = declarations
                .definition(name)
                .is_some_and(|d| !d.parameters.is_empty());
            let skipped = |(i, argument): &(usize, &Expr)| {
                let bound = match name {
                    "D" | "integral" => *i == 1,
                    "at" => *i == usize::from(arguments.len() > 1),
                    "sum" | "product" => *i == 0,
                    _ => {
                        function
                            || declarations.basis(name).is_some()
                            || declarations.function(name).is_some()
                    }
                };
                bound && matches!(argument.node, Node::Name(_))
            };
            for (_, argument) in arguments.iter().enumerate().filter(|each| !skipped(each)) {
                free_names(argument, declarations, found);
            }
        }
        _ => {
            for part in expr.parts() {
                free_names(part, declarations, found);
            }
        }
    }
}

/// Words of order.
const ORDER: [&str; 40] = [
    "less", "great", "larg", "small", "most", "least", "positiv", "negativ", "non", "increas",
    "decreas", "max", "min", "between", "above", "below", "bound", "inside", "within", "outside",
    "quadrant", "admissib", "longer", "shorter", "more", "exceed", "higher", "lower", "close",
    "near", "far", "toward", "convex", "monoton", "lie", "lies", "range", "interval", "rise",
    "fall",
];
/// Words of negation.
const DENIAL: [&str; 27] = [
    "not", "no", "non", "never", "cannot", "differ", "distinct", "without", "neither", "nor",
    "unlike", "fail", "except", "other", "un", "depend", "vary", "chang", "modif", "alter",
    "fluctuat", "adjust", "amend", "disturb", "control", "variou", "benefit",
];

/// Flags relations of the print that are not stated, and stated relations that are not printed.
pub(super) fn relations(subject: &Subject<'_>) -> Vec<RaisedFlag> {
    let Differing { lacks, adds } = differing_relations(subject);
    let lacks = lacks.into_iter().map(|what| {
        raised(
            Flag::LacksRelation,
            format!("{what} is printed and not stated"),
        )
    });
    let adds = adds.into_iter().map(|what| {
        raised(
            Flag::AddsRelation,
            format!("{what} is stated and not printed"),
        )
    });
    lacks.chain(adds).collect()
}

/// Returns relations of the print that are not stated, and stated relations that are not printed.
pub(super) fn differing_relations(subject: &Subject<'_>) -> Differing {
    let statement = subject.claim.statement.iter().map(|w| &w.expr);
    let stated = Kinds::of_formulas(statement);
    let mut reached = Kinds::of_formulas(subject.formulas.reached.iter().copied());
    let ranges = subject
        .formulas
        .names
        .iter()
        .filter_map(|n| subject.claim.declarations.symbol(n));
    reached.order |= ranges.into_iter().any(|kind| match kind {
        SymbolKind::Real(interval) => interval.lower.is_some() || interval.upper.is_some(),
        SymbolKind::Integer { .. } => true,
        _ => false,
    });
    let defined = subject.formulas.names.iter();
    let mut defined = defined.filter(|n| subject.claim.declarations.definition(n).is_some());
    reached.equal |= defined.next().is_some() || !subject.claim.given.is_empty();
    let print = &subject.print;
    let denied = print.different || print.has_word_beginning_with(&DENIAL) || print.order;
    let seen = |list: &[(bool, &str)]| -> Vec<String> {
        let seen = list.iter().filter(|(is, _)| *is);
        seen.map(|(_, what)| (*what).to_owned()).collect()
    };
    Differing {
        lacks: seen(&[
            (
                print.equal && !reached.equal && !reached.property,
                "an equation",
            ),
            (
                print.order && !reached.order && !reached.property,
                "an inequality",
            ),
            (
                print.different && !reached.different,
                "that something differs",
            ),
        ]),
        adds: seen(&[
            (
                stated.order
                    && !print.order
                    && !print.range
                    && !print.has_word_beginning_with(&ORDER),
                "an inequality",
            ),
            (stated.different && !denied, "that something differs"),
        ]),
    }
}

/// Whether a function states a property that the print expresses by a word.
pub(super) fn is_property(name: &str) -> bool {
    const PROPERTIES: [&str; 4] = [
        "agrees",
        "nonnegative",
        "independent",
        "variation_diminishing",
    ];
    PROPERTIES.contains(&name)
}

/// Returns the kinds of relations that occur.
#[derive(Default)]
struct Kinds {
    equal: bool,
    order: bool,
    different: bool,
    /// A property expressed by a word, such as `nonnegative(g)` or `agrees(a, b)`.
    property: bool,
}

impl Kinds {
    fn of_formulas<'e>(formulas: impl Iterator<Item = &'e Expr>) -> Self {
        let mut kinds = Self::default();
        for expr in formulas {
            visit_parts(expr, &mut |part| kinds.see(part));
        }
        kinds
    }

    fn see(&mut self, part: &Expr) {
        match &part.node {
            Node::Compare(_, rest) => {
                for (relation, _) in rest {
                    match relation {
                        Relation::Equal => self.equal = true,
                        Relation::Different => self.different = true,
                        _ => self.order = true,
                    }
                }
            }
            Node::Not(_) => self.different = true,
            Node::Call(head, _) => {
                self.property |= matches!(&head.node, Node::Name(name) if is_property(name));
                self.different |= matches!(&head.node, Node::Name(name) if name == "fails");
            }
            _ => {}
        }
    }
}
