//! Witnesses for what a claim says there is, where it gives none.
//!
//! The numbers that a claim seeks are taken for unknowns of the equations among what it states, and these are solved where they are
//! linear. What the equations leave free is zero, or the point of its interval that is easiest to name. Nothing is believed of a
//! witness: the claim is decided with it in its place ([`torse_core`]).

use crate::context::PreparedClaim;
use crate::evaluate::linear::{linear_form, solve_for};
use crate::evaluate::value::Statement;
use crate::formula;
use crate::unknown::Unknown;
use serde::Serialize;
use std::collections::BTreeMap;
use torse_algebra::Rational;
use torse_algebra::rational::integer;
use torse_algebra::{Fraction, Symbol};
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::derivation::{Claim, Existential, Written};
use torse_syntax::fault::Fault;
use torse_syntax::formula::{Connective, Place, Relation};
use torse_syntax::notation::{self, Formula};

/// A claim with a witness for every number that it says there is.
#[derive(Debug)]
pub struct Instantiated {
    /// The claim.
    pub claim: Claim,
    /// The witnesses that the claim did not give.
    pub witnesses: Vec<FoundWitness>,
}

/// A number for one that a claim says there is and for which it gives no witness.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct FoundWitness {
    /// The name of the number in the claim.
    pub name: String,
    /// Its value, a formula in the symbols of the claim.
    pub value: Formula,
}

/// The claim with the witnesses that it gives and those that are found; `None` if it seeks nothing without one.
///
/// # Errors
/// [`Fault`] when a formula makes no sense, and a limit where no witness is found.
pub fn find_witnesses(claim: &Claim, statement: &Written) -> Result<Option<Instantiated>, Fault> {
    let open: Vec<&Existential> = claim
        .existentials
        .iter()
        .filter(|s| s.witness.is_none())
        .collect();
    let Some(first) = open.first() else {
        return Ok(None);
    };
    let mut free = claim.clone();
    free.existentials
        .retain(|existential| existential.witness.is_some());
    let symbols = open.iter().map(|s| Symbol::named(&s.name));
    let symbols: Vec<Unknown> = symbols.filter_map(Unknown::new).collect();
    let case = PreparedClaim::new(&free, statement, BTreeMap::new())?;
    let mut forms = vec![];
    equations(&case.statement, &symbols, &mut forms);
    let mut values: BTreeMap<Symbol, Fraction> = BTreeMap::new();
    let mut unknowns = symbols.clone();
    while !unknowns.is_empty() {
        match solve_for(&forms, &unknowns, Place::default()) {
            Ok(solution) => {
                values.extend(solution.values);
                break;
            }
            Err(_) => {
                // What the equations do not determine is chosen, the last first.
                let Some(last) = unknowns.pop() else { break };
                let last = last.symbol().clone();
                let chosen = chosen(claim, &last);
                let put = |form: &Fraction| {
                    let put = form.substituted(|s| (*s == last).then(|| chosen.clone()));
                    put.unwrap_or_else(|_| form.clone())
                };
                forms = forms.iter().map(put).collect();
                values.insert(last, chosen);
            }
        }
    }
    let mut found = claim.clone();
    let mut witnesses = vec![];
    for existential in &mut found.existentials {
        if existential.witness.is_some() {
            continue;
        }
        let Some(value) = values.get(&Symbol::named(&existential.name)) else {
            let what = format!("no witness was found for `{}`", first.name);
            return Err(Fault::limit(Place::default(), what).within(&existential.origin));
        };
        let expr = formula::expression(value);
        witnesses.push(FoundWitness {
            name: existential.name.clone(),
            value: notation::formula(&expr),
        });
        existential.witness = Some(Written {
            expr,
            origin: existential.origin.clone(),
        });
    }
    Ok(Some(Instantiated {
        claim: found,
        witnesses,
    }))
}

/// The equations among what is stated that are linear in what is sought.
fn equations(statement: &Statement, unknowns: &[Unknown], forms: &mut Vec<Fraction>) {
    match statement {
        Statement::Compare {
            relation: Relation::Equal,
            left,
            right,
        } => {
            let pairs = left.entries().into_iter().zip(right.entries());
            let differences = pairs.filter_map(|(x, y)| x.minus(y).as_fraction().cloned());
            // Where the number itself is no fraction of one symbol its equation is one in the symbol all the same.
            forms.extend(differences.filter(|form| {
                let mentions = unknowns.iter().any(|unknown| unknown.occurs_in(form));
                mentions && linear_form(form, unknowns).is_some()
            }));
        }
        Statement::Join(Connective::And, a, b) => {
            equations(a, unknowns, forms);
            equations(b, unknowns, forms);
        }
        Statement::Join(Connective::Implies, _, conclusion) => {
            equations(conclusion, unknowns, forms);
        }
        _ => {}
    }
}

/// A number of the interval of a symbol: zero, an end, a middle.
fn chosen(claim: &Claim, symbol: &Symbol) -> Fraction {
    let zero = integer(0);
    let Symbol::Named(name) = symbol else {
        return Fraction::zero();
    };
    let Some(SymbolKind::Real(interval)) = claim.declarations.symbol(name) else {
        return Fraction::zero();
    };
    let end = |bound: &Option<torse_syntax::derivation::declarations::Bound>| {
        let bound = bound.as_ref()?;
        Some((bound.value.as_rational()?.clone(), bound.closed))
    };
    let number: Rational = match (end(&interval.lower), end(&interval.upper)) {
        (None, None) => zero,
        (Some((low, closed)), None) if low < zero || (low == zero && closed) => zero,
        (Some((low, closed)), None) => match closed {
            true => low,
            false => low + integer(1),
        },
        (None, Some((high, closed))) if high > zero || (high == zero && closed) => zero,
        (None, Some((high, closed))) => match closed {
            true => high,
            false => high - integer(1),
        },
        (Some((low, _)), Some((high, _))) if low < zero && zero < high => zero,
        (Some((low, _)), Some((high, _))) => (low + high) / integer(2),
    };
    Fraction::from(number)
}
