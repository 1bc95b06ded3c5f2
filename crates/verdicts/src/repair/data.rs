//! Corrects data: which data would make a printed value right?
//!
//! A wrong value of an example is often the right value for other data, such as those of an earlier version. The
//! numbers among the claim's definitions are treated as unknowns, one and then two at a time. The printed value, a
//! rational function of them, is compared with the print at every number that a slip may have turned into the printed
//! one ([`slips`]). A match is **proved** with the changed data. Matches are ranked by their effect on the other values
//! of the example: few numbers changed, no other value contradicted, many explained, in this order.

use super::rates::{Rate, rates};
use super::slips::{Cost, few_digits, slips};
use crate::certificate::DecisionCertificate;
use crate::correction::{DataChange, DataCorrection};
use crate::repair::edit::placed;
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use torse_algebra::rational::to_f64;
use torse_algebra::{Rational, Symbol};
use torse_prove::context::PreparedClaim;
use torse_prove::decide_statement;
use torse_syntax::derivation::declarations::{Declarations, Definition};
use torse_syntax::derivation::{Claim, Written};
use torse_syntax::formula::{Expr, Node, Operator};
use torse_syntax::notation;

/// Maximum number of unknown numbers of an example.
const MAX_DATA: usize = 24;
/// Maximum number of explanations that are proved.
const MAX_PROOFS: usize = 16;

/// A number among the definitions of a claim.
#[derive(Debug, Clone)]
struct Datum {
    name: String,
    path: Vec<usize>,
    value: Rational,
}

/// Data and their corrected values.
#[derive(Debug, Clone)]
struct Change<'d> {
    cost: Cost,
    data: Vec<(&'d Datum, Rational)>,
}

/// Searches for a change of the data that explains a refuted value.
#[must_use]
pub fn search(claim: &Claim, statement: &Written) -> Option<DataCorrection> {
    let mut data = data(claim, statement);
    data.truncate(MAX_DATA);
    let others: Vec<Rational> = data.iter().map(|d| d.value.clone()).collect();
    // Data that do not enter the value are not changed.
    data.retain(|datum| {
        let rates = functions(claim, statement, [datum, datum]);
        rates.is_some_and(|rates| rates.iter().any(Rate::varies))
    });
    let attempts = [one_changed, two_changed];
    let found = attempts.iter().map(|attempt| {
        let mut changes = attempt(claim, statement, &data, &others);
        changes.sort_by_key(Change::weight);
        explanation(claim, statement, &changes)
    });
    found.flatten().next()
}

impl Change<'_> {
    /// Returns the weight of a change; the least likely changes are heaviest: numbers of several data, then expensive slips.
    fn weight(&self) -> (usize, Cost) {
        let names: BTreeSet<&str> = self.data.iter().map(|(d, _)| d.name.as_str()).collect();
        (names.len(), self.cost)
    }
}

/// Returns the numbers in the definitions that the statement depends on, in the order in which it names them.
fn data(claim: &Claim, statement: &Written) -> Vec<Datum> {
    let mut seen = BTreeSet::new();
    let mut found = vec![];
    let mut level: Vec<&Expr> = std::iter::once(statement)
        .chain(claim.given.iter().map(|h| &h.formula))
        .map(|w| &w.expr)
        .collect();
    while !level.is_empty() {
        let mut deeper = vec![];
        for name in level.iter().flat_map(|e| e.names()) {
            let base = name.trim_end_matches('\'');
            if !seen.insert(base) {
                continue;
            }
            if let Some(definition) = claim.declarations.definition(base) {
                let body = &definition.body.expr;
                deeper.push(body);
                let mut numbers = vec![];
                if definition.parameters.is_empty() && collect(body, &[], &mut numbers) {
                    found.extend(numbers.into_iter().map(|(path, value)| Datum {
                        name: base.to_owned(),
                        path,
                        value,
                    }));
                }
            }
        }
        level = deeper;
    }
    found
}

/// Returns the numbers of a formula that consists of nothing else, with the paths to them.
fn collect(expr: &Expr, path: &[usize], into: &mut Vec<(Vec<usize>, Rational)>) -> bool {
    if let Some(value) = number(expr) {
        into.push((path.to_vec(), value));
        return true;
    }
    let Node::List(items) = &expr.node else {
        return false;
    };
    let mut parts = items.iter().enumerate();
    parts.all(|(position, item)| collect(item, &[path, &[position]].concat(), into))
}

/// Returns the value of a number that may have a sign or be a quotient.
fn number(expr: &Expr) -> Option<Rational> {
    match &expr.node {
        Node::Number { value, .. } => Some(value.clone()),
        Node::Negative(inner) => number(inner).map(|value| -value),
        Node::Binary(Operator::Divide, a, b) => {
            let (a, b) = (number(a)?, number(b)?);
            (b != Rational::default()).then(|| a / b)
        }
        _ => None,
    }
}

/// Writes a number as the print would.
fn printed(value: &Rational) -> Expr {
    use num_traits::Signed;
    if value.is_negative() {
        return Expr::made(Node::Negative(Arc::new(printed(&-value.clone()))));
    }
    let tenths = torse_algebra::rational::integer(10);
    if !value.is_integer() && (value * tenths).is_integer() {
        return Expr::made(Node::Number {
            value: value.clone(),
            decimals: Some(1),
        });
    }
    Expr::number(value)
}

fn one_changed<'d>(
    claim: &Claim,
    statement: &Written,
    data: &'d [Datum],
    others: &[Rational],
) -> Vec<Change<'d>> {
    let mut changes = vec![];
    for datum in data {
        let Some(rates) = functions(claim, statement, [datum, datum]) else {
            continue;
        };
        // Two equal symbols would cancel the first.
        let rates: Vec<_> = rates.iter().map(|r| r.at_first(0.0)).collect();
        for (value, cost) in few_digits(&datum.value, others) {
            let at = to_f64(&value);
            if rates.iter().all(|r| r.agrees(at)) {
                changes.push(Change {
                    cost,
                    data: vec![(datum, value)],
                });
            }
        }
    }
    changes
}

fn two_changed<'d>(
    claim: &Claim,
    statement: &Written,
    data: &'d [Datum],
    others: &[Rational],
) -> Vec<Change<'d>> {
    let slips: Vec<Vec<(Rational, Cost, f64)>> = data
        .iter()
        .map(|datum| {
            let slips = slips(&datum.value, others).into_iter();
            slips
                .map(|(v, cost)| (v.clone(), cost, to_f64(&v)))
                .collect()
        })
        .collect();
    let mut changes = vec![];
    for (position, (first, first_slips)) in data.iter().zip(&slips).enumerate() {
        for (second, second_slips) in data.iter().zip(&slips).skip(position + 1) {
            let Some(rates) = functions(claim, statement, [first, second]) else {
                continue;
            };
            for (x, x_cost, x_at) in first_slips {
                let rates: Vec<_> = rates.iter().map(|r| r.at_first(*x_at)).collect();
                for (y, y_cost, y_at) in second_slips {
                    if rates.iter().all(|r| r.agrees(*y_at)) {
                        changes.push(Change {
                            cost: x_cost + y_cost,
                            data: vec![(first, x.clone()), (second, y.clone())],
                        });
                    }
                }
            }
        }
    }
    changes
}

/// Returns the printed values as functions of two data; if both are the same one, of the second alone.
fn functions(claim: &Claim, statement: &Written, data: [&Datum; 2]) -> Option<Vec<Rate>> {
    // Names with a space cannot clash with those of a file.
    let names = ["first datum", "second datum"];
    let mut declarations = (*claim.declarations).clone();
    let mut bodies: BTreeMap<&str, Definition> = BTreeMap::new();
    for (datum, name) in data.iter().zip(names) {
        declarations.declare_number(name.to_owned());
        replace(&mut bodies, &claim.declarations, datum, Expr::name(name))?;
    }
    for (name, definition) in bodies {
        declarations.define(name.to_owned(), definition);
    }
    let changed = with(claim, declarations);
    let case = PreparedClaim::new(&changed, statement, BTreeMap::new()).ok()?;
    let [s, t] = names.map(Symbol::named);
    rates(&case.statement, [&s, &t])
}

fn replace<'n>(
    bodies: &mut BTreeMap<&'n str, Definition>,
    declarations: &Declarations,
    datum: &'n Datum,
    by: Expr,
) -> Option<()> {
    if !bodies.contains_key(datum.name.as_str()) {
        let printed = declarations.definition(&datum.name)?.clone();
        bodies.insert(&datum.name, printed);
    }
    let definition = bodies.get_mut(datum.name.as_str())?;
    definition.body.expr = placed(&definition.body.expr, &datum.path, by);
    Some(())
}

/// Returns the claim with other declarations.
pub(super) fn with(claim: &Claim, declarations: Declarations) -> Claim {
    Claim {
        declarations: Arc::new(declarations),
        ..claim.clone()
    }
}

/// A proved explanation.
struct Explanation {
    correction: DataCorrection,
    /// Values contradicted, values explained, weight of the change: the minimum is the best.
    rank: (usize, Reverse<usize>, (usize, Cost)),
}

/// Returns the best proved change.
fn explanation(
    claim: &Claim,
    statement: &Written,
    changes: &[Change<'_>],
) -> Option<DataCorrection> {
    let proved: Vec<Explanation> = changes
        .iter()
        .take(MAX_PROOFS)
        .filter_map(|change| explained(claim, statement, change))
        .collect();
    let best = proved.iter().map(|e| e.rank).min()?;
    let mut as_good = proved.into_iter().filter(|e| e.rank == best);
    let mut correction = as_good.next()?.correction;
    correction.unique = as_good.next().is_none();
    Some(correction)
}

fn explained(claim: &Claim, statement: &Written, change: &Change<'_>) -> Option<Explanation> {
    let mut bodies = BTreeMap::new();
    for (datum, value) in &change.data {
        replace(&mut bodies, &claim.declarations, datum, printed(value))?;
    }
    // A definition of the claim's own hides that of the example, and does not change with it.
    let changed = |claim: &Claim| {
        let mut declarations = (*claim.declarations).clone();
        for (name, definition) in &bodies {
            declarations.define((*name).to_owned(), definition.clone());
        }
        with(claim, declarations)
    };
    let decided = decide_statement(&changed(claim), statement).ok()?;
    if !decided.is_proven() {
        return None;
    }
    let certificate = Arc::new(DecisionCertificate::from_decision(&decided)?);
    let (mut explains, mut contradicts, mut refuted) = (vec![], vec![], 0);
    for value in claim.example.iter() {
        let Some(statement) = value.statement.as_ref().filter(|s| is_result(&s.expr)) else {
            continue;
        };
        let (Ok(before), Ok(after)) = (
            decide_statement(value, statement),
            decide_statement(&changed(value), statement),
        ) else {
            continue;
        };
        let id = value.entry.id.get_ref();
        refuted += usize::from(before.is_refuted());
        if before.is_refuted() && after.is_proven() {
            explains.push(id.clone());
        }
        if before.is_proven() && !after.is_proven() {
            contradicts.push(id.clone());
        }
    }
    let changes = bodies.iter().filter_map(|(name, definition)| {
        let old = &claim.declarations.definition(name)?.body.expr;
        Some(DataChange {
            name: (*name).to_owned(),
            old: notation::formula(old),
            new: notation::formula(&definition.body.expr),
        })
    });
    Some(Explanation {
        rank: (contradicts.len(), Reverse(explains.len()), change.weight()),
        correction: DataCorrection {
            changes: changes.collect(),
            certificate,
            unique: true,
            explains_example: explains.len() == refuted && contradicts.is_empty(),
            explains,
            contradicts,
        },
    })
}

/// Whether a statement compares with printed decimals, so that it is a result of the example rather than its data.
fn is_result(expr: &Expr) -> bool {
    expr.names().contains(&"agrees")
}
