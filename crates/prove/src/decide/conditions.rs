//! Divisors by their parts: a product differs from zero exactly where its factors do.

use crate::formula::factors;
use torse_algebra::{Polynomial, Symbol};

/// The most terms of two polynomials together, multiplied, of which a quotient is sought beyond long division.
const MAX_TERMS: usize = 400;

/// The same conditions without products: every divisor is factored, and divided by the others where they
/// divide it. Neither the order of the list nor a repetition in it matters.
///
/// ```
/// use torse_algebra::Polynomial;
/// use torse_prove::decide::conditions::separated;
/// let (a, b) = (Polynomial::named("a"), Polynomial::named("b"));
/// let (sum, gap) = (&a + &b, &a - &b);
/// assert_eq!(separated(&[&a * &b, b.clone()]), [a, b]);
/// assert_eq!(separated(&[&sum * &gap, gap.clone()]), [gap, sum]);
/// ```
#[must_use]
pub fn separated(divisors: &[Polynomial]) -> Vec<Polynomial> {
    let parts = |p: &Polynomial| {
        let nonconstant = |f: &Polynomial| f.as_constant().is_none();
        let found = factors(p).into_iter().map(|f| f.primitive().1);
        found.filter(nonconstant).collect::<Vec<_>>()
    };
    let mut found: Vec<Polynomial> = divisors.iter().flat_map(parts).collect();
    loop {
        found.sort();
        found.dedup();
        let divided = found.iter().enumerate().find_map(|(place, p)| {
            let others = found.iter().filter(|q| *q != p);
            let mut quotients = others.filter_map(|q| quotient(p, q));
            quotients.next().map(|quotient| (place, quotient))
        });
        // Each division lowers a degree.
        let Some((place, quotient)) = divided else {
            return found;
        };
        found.remove(place);
        found.extend(parts(&quotient));
    }
}

/// The quotient, if there is one: where sines are in the divisor long division may miss it, so that both are multiplied by what
/// makes the divisor free of them.
fn quotient(dividend: &Polynomial, divisor: &Polynomial) -> Option<Polynomial> {
    let found = dividend.exact_quotient(divisor);
    let is_sine = |symbol: &&Symbol| matches!(symbol, Symbol::Sin(..));
    let sines: Vec<&Symbol> = divisor.symbols().iter().filter(is_sine).collect();
    if found.is_some() || sines.is_empty() {
        return found;
    }
    let (mut above, mut below) = (dividend.clone(), divisor.clone());
    for sine in sines {
        if above.len().saturating_mul(below.len()) > MAX_TERMS {
            return None;
        }
        let by_power = below.coefficients_in(sine);
        let [even, odd] = by_power.as_slice() else {
            continue;
        };
        let conjugate = even - &(odd * &Polynomial::symbol(sine.clone()));
        above = &above * &conjugate;
        below = &below * &conjugate;
    }
    let found = above.exact_quotient(&below)?;
    (&found * divisor == *dividend).then_some(found)
}
