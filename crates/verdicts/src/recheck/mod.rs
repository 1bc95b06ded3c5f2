//! A second, naive evaluator that replays proofs at small instances.
//!
//! The engine decides with packed polynomials, factored denominators and series of symbolic degree.
//! Here nothing is clever: polynomials are maps from monomials to coefficients (`number`), quotients
//! are never cancelled, families are built by their recursion, sums term by term, derivatives by the
//! rules, linear systems by elimination. Nothing but the syntax tree, the declarations, the rational
//! numbers and the names of symbols is shared with the engine.
//!
//! A statement proved as an identity, or for every degree, must be zero at the smallest values of its
//! integer symbols; a refuted one must not be, and its correction must. That does not prove the
//! statement again, but an error of the engine would have to be repeated here to pass.

mod evaluate;
mod functions;
mod instances;
mod linear;
mod number;
mod turn;

use crate::outcome::Outcome;
use evaluate::{Evaluator, Value};
use number::{Quotient, Work};
use std::cell::Cell;
use std::collections::BTreeMap;
use torse_algebra::Symbol;
use torse_language::derivation::Claim;
use torse_language::syntax::{Connective, Expr, Node, Operator, Relation, parse};
use torse_language::words::Verdict;
use torse_prove::evidence::Evidence;

/// What replaying a claim gave.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Recheck {
    /// Every instance agrees with the outcome.
    Confirmed {
        /// The instances, such as `k = 2, l = 4`; one empty text for a statement without integers.
        instances: Vec<String>,
    },
    /// An instance does not agree with the outcome.
    Contradicted {
        /// The instance.
        instance: String,
        /// What was found there.
        found: String,
    },
    /// The outcome does not rest on identities, or they are not covered here.
    NotReplayable {
        /// Why.
        reason: String,
    },
}

/// Why an instance could not be evaluated.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
enum Obstacle {
    /// Something that this evaluator does not know.
    #[error("{what} is not covered")]
    NotCovered {
        /// What.
        what: String,
    },
    /// A divisor is zero at this instance.
    #[error("a divisor vanishes")]
    ZeroDivisor,
    /// An assumption is false at this instance.
    #[error("an assumption is false")]
    Outside,
    /// The bound of the work.
    #[error("it takes too much work")]
    TooMuchWork,
}

/// Replays the outcome of a claim.
#[must_use]
pub fn claim(claim: &Claim, outcome: &Outcome) -> Recheck {
    let proved = matches!(
        outcome.verdict,
        Verdict::Holds | Verdict::Conditional | Verdict::Definition
    ) && matches!(
        outcome.evidence,
        Some(Evidence::Identity | Evidence::Induction)
    );
    let refuted = matches!(outcome.verdict, Verdict::Misprint | Verdict::False);
    let statement = match &claim.statement {
        Some(statement) if proved || refuted => &statement.expr,
        _ => return not_replayable("the outcome does not rest on an identity"),
    };
    if proved {
        return vanishes(claim, statement);
    }
    let refutation = differs(claim, statement, outcome);
    let (Recheck::Confirmed { .. }, Some(correction)) = (&refutation, &outcome.correction) else {
        return refutation;
    };
    let Ok(corrected) = parse(&correction.statement.text) else {
        return not_replayable("the correction cannot be read back");
    };
    match vanishes(claim, &corrected) {
        Recheck::Confirmed { .. } => refutation,
        Recheck::NotReplayable { reason } => not_replayable(&format!("the correction: {reason}")),
        Recheck::Contradicted { instance, found } => Recheck::Contradicted {
            instance,
            found: format!("the correction leaves {found}"),
        },
    }
}

fn not_replayable(reason: &str) -> Recheck {
    Recheck::NotReplayable {
        reason: reason.to_owned(),
    }
}

/// Checks that both sides agree at every small instance.
fn vanishes(claim: &Claim, statement: &Expr) -> Recheck {
    let (work, mut confirmed) = (Work::default(), vec![]);
    for instance in instances::small(claim, statement) {
        let name = instances::name(&instance);
        match difference(claim, statement, instance, &work) {
            Ok(None) => confirmed.push(name),
            Ok(Some(found)) => {
                return Recheck::Contradicted {
                    instance: name,
                    found,
                };
            }
            Err(Obstacle::ZeroDivisor | Obstacle::Outside) => {}
            Err(Obstacle::TooMuchWork) if !confirmed.is_empty() => break,
            Err(obstacle) => return not_replayable(&obstacle.to_string()),
        }
    }
    if confirmed.is_empty() {
        return not_replayable("no small instance lies in the domain");
    }
    Recheck::Confirmed {
        instances: confirmed,
    }
}

/// Checks that the sides differ at some small instance, or at that of the witness.
fn differs(claim: &Claim, statement: &Expr, outcome: &Outcome) -> Recheck {
    let (work, mut agreeing) = (Work::default(), vec![]);
    let witness = instances::of_witness(claim, outcome);
    for instance in witness
        .into_iter()
        .chain(instances::small(claim, statement))
    {
        let name = instances::name(&instance);
        match difference(claim, statement, instance, &work) {
            Ok(Some(_)) => {
                return Recheck::Confirmed {
                    instances: vec![name],
                };
            }
            Ok(None) => agreeing.push(name),
            Err(Obstacle::ZeroDivisor | Obstacle::Outside) => {}
            Err(obstacle) => return not_replayable(&obstacle.to_string()),
        }
    }
    match agreeing.first() {
        None => not_replayable("no small instance lies in the domain"),
        Some(_) => Recheck::Contradicted {
            instance: agreeing.join("; "),
            found: "both sides are equal".to_owned(),
        },
    }
}

/// The first difference of two sides that is not zero, written out.
fn difference(
    claim: &Claim,
    statement: &Expr,
    instance: BTreeMap<String, i64>,
    work: &Work,
) -> Result<Option<String>, Obstacle> {
    let mut evaluator = Evaluator {
        declarations: &claim.declarations,
        integers: instance,
        known: BTreeMap::new(),
        solved: BTreeMap::new(),
        work,
        depth: Cell::new(0),
    };
    for assumption in &claim.assumptions {
        for (relation, x, y) in comparisons(&assumption.expr, &evaluator)? {
            assume(relation, &x, &y, &mut evaluator)?;
        }
    }
    let mut forms = vec![];
    for given in &claim.given {
        for (relation, x, y) in comparisons(&given.expr, &evaluator)? {
            if relation != Relation::Equal {
                return Err(Obstacle::NotCovered {
                    what: "a given inequality".to_owned(),
                });
            }
            forms.push(x.plus(&y.negated(), evaluator.work)?);
        }
    }
    let mut unknowns: Vec<Symbol> = vec![];
    for unknown in &claim.unknowns {
        let value = evaluator.value(&unknown.expr, &BTreeMap::new())?;
        unknowns.extend(value.numbers().into_iter().filter_map(Quotient::as_symbol));
    }
    evaluator.solved = linear::solve(&forms, &unknowns, evaluator.work)?;
    for (relation, x, y) in comparisons(statement, &evaluator)? {
        if relation != Relation::Equal {
            return Err(Obstacle::NotCovered {
                what: "an inequality".to_owned(),
            });
        }
        let gap = evaluator.resolved(&x.plus(&y.negated(), evaluator.work)?)?;
        if !gap.is_zero() {
            let terms = gap.above.terms().count();
            return Ok(Some(format!("a difference of {terms} terms")));
        }
    }
    Ok(None)
}

/// All comparisons of a conjunction, number by number.
fn comparisons(
    statement: &Expr,
    evaluator: &Evaluator<'_>,
) -> Result<Vec<(Relation, Quotient, Quotient)>, Obstacle> {
    match &statement.node {
        Node::Join(Connective::And, a, b) => {
            let mut all = comparisons(a, evaluator)?;
            all.extend(comparisons(b, evaluator)?);
            Ok(all)
        }
        Node::Compare(first, rest) => {
            let mut left = evaluator.value(first, &BTreeMap::new())?;
            let mut all = vec![];
            for (relation, right) in rest {
                let right = evaluator.value(right, &BTreeMap::new())?;
                // Zero fits every shape: adding zeros of the shape of the other side.
                let zero = Value::Number(Quotient::integer(0));
                let shape =
                    |v: &Value| evaluator.binary(Operator::Multiply, zero.clone(), v.clone());
                let x = evaluator.binary(Operator::Add, left, shape(&right)?)?;
                let y = evaluator.binary(Operator::Add, right.clone(), shape(&x)?)?;
                let pairs = x.numbers().into_iter().zip(y.numbers());
                all.extend(pairs.map(|(x, y)| (*relation, x.clone(), y.clone())));
                left = right;
            }
            Ok(all)
        }
        _ => Err(Obstacle::NotCovered {
            what: "a statement that is no equation".to_owned(),
        }),
    }
}

/// Takes an assumption: an equality fixes a symbol, a false comparison of numbers leaves the domain.
fn assume(
    relation: Relation,
    x: &Quotient,
    y: &Quotient,
    evaluator: &mut Evaluator<'_>,
) -> Result<(), Obstacle> {
    let gap = x.plus(&y.negated(), evaluator.work)?;
    if let Some(gap) = gap.as_constant() {
        let zero = torse_algebra::rational::integer(0);
        let holds = match relation {
            Relation::Equal => gap == zero,
            Relation::Different => gap != zero,
            Relation::Less => gap < zero,
            Relation::AtMost => gap <= zero,
            Relation::Greater => gap > zero,
            Relation::AtLeast => gap >= zero,
        };
        return if holds {
            Ok(())
        } else {
            Err(Obstacle::Outside)
        };
    }
    if relation != Relation::Equal {
        return Ok(());
    }
    if let Some((symbol, value)) = x
        .as_symbol()
        .map(|s| (s, y))
        .or_else(|| y.as_symbol().map(|s| (s, x)))
    {
        evaluator.known.insert(symbol, value.clone());
        return Ok(());
    }
    let symbols: Vec<Symbol> = gap
        .above
        .terms()
        .flat_map(|(m, _)| m.keys().cloned())
        .collect();
    let plain = symbols.iter().filter(|s| matches!(s, Symbol::Named(_)));
    for symbol in plain {
        if let Ok(solution) = linear::solve(
            std::slice::from_ref(&gap),
            std::slice::from_ref(symbol),
            evaluator.work,
        ) {
            evaluator.known.extend(solution);
            return Ok(());
        }
    }
    Err(Obstacle::NotCovered {
        what: "an assumption that fixes no symbol".to_owned(),
    })
}
