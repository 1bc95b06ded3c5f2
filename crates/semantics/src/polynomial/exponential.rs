//! Exponentials of sums of integer multiples of products of variables, by `exp(a + b) = exp(a) exp(b)`. Independent
//! of `algebra` on purpose: do not share.

use super::Quotient;
use super::sum::{Sum, Variable};
use crate::no_value::{NoValue, Unknown, Work};
use num_traits::Signed;
use std::collections::BTreeMap;
use torse_numbers::rational::integer;

/// The largest multiple that is expanded.
const MAX_MULTIPLE: i64 = 24;

/// The exponential of a quotient.
pub(super) fn exponential_quotient(exponent: &Quotient, work: &Work) -> Result<Quotient, NoValue> {
    let unknown = || {
        NoValue::from(Unknown::NotCovered {
            what: "the exponential of this formula",
        })
    };
    if exponent.below.as_constant().is_none() {
        return Err(unknown());
    }
    let mut total = Quotient::number(integer(1));
    for (monomial, coefficient) in exponent.above.terms() {
        let named = |(variable, power): (&Variable, &u32)| match variable {
            Variable::Named(name) => Some((name.clone(), *power)),
            _ => None,
        };
        let names: Option<BTreeMap<_, _>> = monomial.iter().map(named).collect();
        // Fractions of a variable and powers of the number e are not supported here.
        let names = names
            .filter(|names| !names.is_empty())
            .ok_or_else(unknown)?;
        let integer_multiple = coefficient
            .is_integer()
            .then(|| i64::try_from(&coefficient.to_integer()).ok())
            .flatten();
        let count = integer_multiple
            .filter(|n| n.abs() <= MAX_MULTIPLE)
            .ok_or_else(unknown)?;
        let power = Quotient::from(Sum::variable(Variable::Power(names)));
        for _ in 0..count.abs() {
            total = if count.is_negative() {
                total.over(&power, work)?
            } else {
                total.times(&power, work)?
            };
        }
    }
    Ok(total)
}
