//! From exact algebra back to a formula as one would write it by hand.
//!
//! Several shapes are built (factored, expanded, collected by powers of pi) and the one with the fewest
//! nodes is kept, the earlier on ties. Nothing here decides anything: a shape is only ever another way
//! to write the same polynomial.

use super::build::sum;
use super::factor::Factored;
use super::points;
use super::shape::{ratio, shape};
use torse_algebra::{Fraction, Polynomial};
use torse_syntax::formula::Expr;

/// The value of the fraction as a formula; its conditions are not part of it.
///
/// ```
/// use torse_algebra::{Affine, Fraction, Symbol};
/// use torse_syntax::notation;
/// use torse_prove::formula;
/// let point = |i| Fraction::symbol(Symbol::indexed("R", vec![Affine::symbol("k") - Affine::number(i)]));
/// let mu = Fraction::named("mu");
/// let tangent = (Fraction::integer(1) - mu) * (point(0) - point(1));
/// let tangent = tangent.over(&Fraction::integer(2)).unwrap();
/// assert_eq!(notation::text(&formula::expression(&tangent)), "1/2*(1 - mu)*(R[k] - R[k-1])");
/// ```
#[must_use]
pub fn expression(value: &Fraction) -> Expr {
    let below = Factored::product(value.denominator_factors());
    if let Some(terms) = points::combination(value.numerator(), &below) {
        return sum(terms);
    }
    if value.as_polynomial().is_some() {
        return expression_of(value.numerator());
    }
    sum(vec![ratio(&Factored::new(value.numerator()), &below, None)])
}

/// The polynomial as a formula.
///
/// ```
/// use torse_algebra::Polynomial;
/// use torse_syntax::notation;
/// use torse_prove::formula;
/// let k = Polynomial::named("k");
/// let cubic = &(&k.power(3) - &k.power(2)) * &Polynomial::integer(-16);
/// assert_eq!(notation::text(&formula::expression_of(&cubic)), "-16*k^2*(k - 1)");
/// ```
#[must_use]
pub fn expression_of(p: &Polynomial) -> Expr {
    let one = Factored::product(std::iter::empty());
    if let Some(terms) = points::combination(p, &one) {
        return sum(terms);
    }
    let factored = Factored::new(p);
    let plain = shape(p);
    let short = sum(vec![ratio(&factored, &one, None)]);
    // Pulling out a mere number must pay.
    let gain = usize::from(factored.factors.len() > 1);
    if short.size() < plain.size() + gain {
        short
    } else {
        plain
    }
}
