//! A claim made ready: assumptions applied, given equations solved, the statement evaluated.

use crate::decide::domain::{Constraint, Domain};
use crate::evaluate::Evaluator;
use crate::evaluate::linear::{single_symbol, solve_for};
use crate::evaluate::quantity::Quantity;
use crate::evaluate::value::{NOWHERE, Statement, Value};
use std::collections::BTreeMap;
use torse_algebra::{Fraction, Symbol};
use torse_language::derivation::{Claim, Written};
use torse_language::fault::Fault;
use torse_language::syntax::{Connective, Relation};

/// What a claim states, ready to be decided.
pub struct Case<'a> {
    /// The evaluator with assumptions and solutions in force.
    pub evaluator: Evaluator<'a>,
    /// The domain.
    pub domain: Domain<'a>,
    /// The statement.
    pub statement: Statement,
}

impl<'a> Case<'a> {
    /// Prepares a claim with some symbols fixed.
    ///
    /// # Errors
    /// [`Fault`], pointing into the text that caused it.
    pub fn new(
        claim: &'a Claim,
        statement: &Written,
        fixed: BTreeMap<String, Fraction>,
    ) -> Result<Self, Fault> {
        let declarations = &*claim.declarations;
        let mut evaluator = Evaluator::new(declarations).fixing(&fixed);
        let mut domain = Domain {
            declarations,
            constraints: vec![],
        };
        for assumption in &claim.assumptions {
            let statement = evaluator
                .statement(&assumption.expr)
                .map_err(|f| f.within(&assumption.origin))?;
            assume(statement, &mut evaluator, &mut domain)
                .map_err(|f| f.within(&assumption.origin))?;
        }
        let solution = solve_given(&claim.given, &claim.unknowns, &evaluator)?;
        evaluator.determine(solution);
        let value = evaluator
            .statement(&statement.expr)
            .map_err(|f| f.within(&statement.origin))?;
        Ok(Self {
            evaluator,
            domain,
            statement: value,
        })
    }
}

/// Takes an assumption: equalities fix a symbol, everything else bounds the domain.
fn assume(
    statement: Statement,
    evaluator: &mut Evaluator<'_>,
    domain: &mut Domain<'_>,
) -> Result<(), Fault> {
    match statement {
        Statement::Join(Connective::And, a, b) => {
            assume(*a, evaluator, domain)?;
            assume(*b, evaluator, domain)
        }
        Statement::Compare {
            relation,
            left,
            right,
            ..
        } => {
            for (x, y) in left.entries().into_iter().zip(right.entries()) {
                assume_entry(relation, x, y, evaluator, domain)?;
            }
            Ok(())
        }
        _ => Err(Fault::limit(NOWHERE, "an assumption that is no comparison")),
    }
}

fn assume_entry(
    relation: Relation,
    x: &Quantity,
    y: &Quantity,
    evaluator: &mut Evaluator<'_>,
    domain: &mut Domain<'_>,
) -> Result<(), Fault> {
    let (Some(x), Some(y)) = (x.as_fraction(), y.as_fraction()) else {
        return Err(Fault::limit(NOWHERE, "an assumption of symbolic degree"));
    };
    if relation != Relation::Equal {
        let value = x.clone() - y.clone();
        domain.constraints.push(Constraint { value, relation });
        return Ok(());
    }
    let mut fix = |symbol: Symbol, value: &Fraction| match symbol {
        Symbol::Named(name) => {
            evaluator.fix(name.to_string(), value.clone());
        }
        other => {
            evaluator.determine([(other, value.clone())]);
        }
    };
    if let Some(symbol) = single_symbol(x) {
        fix(symbol, y);
        return Ok(());
    }
    if let Some(symbol) = single_symbol(y) {
        fix(symbol, x);
        return Ok(());
    }
    // Any symbol in which the equation is linear will do; the first in order is taken.
    let difference = x.clone() - y.clone();
    for symbol in difference.symbols() {
        if difference.numerator().degree_in(&symbol) == 1
            && let Ok(solution) = solve_for(
                std::slice::from_ref(&difference),
                std::slice::from_ref(&symbol),
                NOWHERE,
            )
            && let Some(value) = solution.get(&symbol)
        {
            fix(symbol, value);
            return Ok(());
        }
    }
    Err(Fault::limit(
        NOWHERE,
        "an assumed equality that determines no symbol",
    ))
}

/// The solution of the given equations for their unknowns.
///
/// # Errors
/// [`Fault`], pointing into the text that caused it.
pub fn solve_given(
    given: &[Written],
    unknowns: &[Written],
    evaluator: &Evaluator<'_>,
) -> Result<BTreeMap<Symbol, Fraction>, Fault> {
    let Some(first) = given.first() else {
        return Ok(BTreeMap::new());
    };
    let mut symbols = vec![];
    for unknown in unknowns {
        let value = evaluator
            .evaluate(&unknown.expr)
            .map_err(|f| f.within(&unknown.origin))?;
        for entry in value.entries() {
            let symbol = entry.as_fraction().and_then(single_symbol);
            let wrong = || {
                crate::evaluate::wrong_type(
                    unknown.expr.place,
                    "a formula",
                    "an unknown such as Q[1]",
                )
            };
            symbols.push(symbol.ok_or_else(|| wrong().within(&unknown.origin))?);
        }
    }
    let mut forms = vec![];
    for equation in given {
        let statement = evaluator
            .statement(&equation.expr)
            .map_err(|f| f.within(&equation.origin))?;
        equations(&statement, &mut forms).map_err(|f| f.within(&equation.origin))?;
    }
    solve_for(&forms, &symbols, NOWHERE).map_err(|f| f.within(&first.origin))
}

fn equations(statement: &Statement, forms: &mut Vec<Fraction>) -> Result<(), Fault> {
    match statement {
        Statement::Compare {
            relation: Relation::Equal,
            left,
            right,
            ..
        } => {
            for (x, y) in left.entries().into_iter().zip(right.entries()) {
                let difference = x.minus(y);
                let form = difference.as_fraction().cloned();
                forms.push(
                    form.ok_or_else(|| {
                        Fault::limit(NOWHERE, "a given equation of symbolic degree")
                    })?,
                );
            }
            Ok(())
        }
        Statement::Join(Connective::And, a, b) => {
            equations(a, forms)?;
            equations(b, forms)
        }
        _ => Err(Fault::limit(
            NOWHERE,
            "a given condition that is no equation",
        )),
    }
}

/// The value of the left side of the first refuted comparison, for the derived form.
#[must_use]
pub fn first_comparison(statement: &Statement) -> Option<(&Value, &Value)> {
    match statement {
        Statement::Compare { left, right, .. } => Some((left, right)),
        Statement::Join(_, a, b) => first_comparison(a).or_else(|| first_comparison(b)),
        Statement::Agrees { .. } | Statement::Family { .. } | Statement::Not(_) => None,
    }
}
