//! Divisors by their parts: a product differs from zero exactly where its factors do.

use crate::formula::factors;
use torse_algebra::Polynomial;

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
            let mut quotients = others.filter_map(|q| p.exact_quotient(q));
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
