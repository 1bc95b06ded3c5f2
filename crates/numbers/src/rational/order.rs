//! Order, equality and hash.

use super::{Rational, machine};
use num_traits::Signed;
use std::cmp::Ordering;
use std::hash::{Hash, Hasher};

impl PartialEq for Rational {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        self.numer() == other.numer() && self.denom() == other.denom()
    }
}

impl Eq for Rational {}

impl Hash for Rational {
    #[inline]
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.numer().hash(state);
        self.denom().hash(state);
    }
}

impl Ord for Rational {
    fn cmp(&self, other: &Self) -> Ordering {
        if let Some(order) = machine::cmp(self, other) {
            return order;
        }
        // Denominators are positive, so the sign of a number is that of its numerator.
        if self.denom() == other.denom() || self.is_negative() != other.is_negative() {
            return self.numer().cmp(other.numer());
        }
        (self.numer() * other.denom()).cmp(&(other.numer() * self.denom()))
    }
}

impl PartialOrd for Rational {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Integer, Rational};
    use num_integer::Integer as _;
    use num_traits::Zero;
    use std::collections::HashSet;

    fn small() -> impl Iterator<Item = (i64, i64)> {
        (-6..=6).flat_map(|n| (1..=6).map(move |d| (n, d)))
    }

    fn number((n, d): (i64, i64)) -> Rational {
        Rational::new(n.into(), d.into())
    }

    #[test]
    fn small_fractions_are_in_order() {
        for (a, b) in small() {
            for (c, d) in small() {
                let (x, y) = (number((a, b)), number((c, d)));
                assert_eq!(x.cmp(&y), (a * d).cmp(&(c * b)));
                assert_eq!(x == y, a * d == c * b);
                assert_eq!(x < y, a * d < c * b);
                let (least, greatest) = (x.clone().min(y.clone()), x.clone().max(y.clone()));
                assert!(least <= greatest && (least == x || least == y));
                assert_eq!(least + greatest, x + y);
            }
        }
    }

    #[test]
    fn numbers_of_any_signs_are_sorted_and_clamped_along_the_line() {
        let mut all: Vec<(i64, i64)> = small().collect();
        let mut numbers: Vec<Rational> = all.iter().copied().map(number).collect();
        numbers.sort();
        all.sort_by(|(a, b), (c, d)| (a * d).cmp(&(c * b)));
        assert_eq!(numbers, all.into_iter().map(number).collect::<Vec<_>>());
        let minus_half = number((-1, 2));
        assert_eq!(
            Rational::zero().clamp(number((-3, 4)), minus_half.clone()),
            minus_half
        );
    }

    #[test]
    fn equal_numbers_have_equal_hashes() {
        let distinct: HashSet<Rational> = small().map(number).collect();
        let mut sorted: Vec<Rational> = small().map(number).collect();
        sorted.sort();
        sorted.dedup();
        assert_eq!(distinct.len(), sorted.len());
    }

    #[test]
    fn long_numbers_that_nearly_agree_are_compared_without_recursion() {
        // Neighbouring quotients of Fibonacci numbers take the most steps of Euclid's algorithm.
        let (mut a, mut b) = (Integer::ONE, Integer::ONE);
        for _ in 0..200_000 {
            (a, b) = (b.clone(), a + b);
        }
        let x = Rational::in_lowest_terms(b.clone(), a.clone());
        let y = Rational::in_lowest_terms(&a + &b, b);
        assert!(x != y && x.cmp(&y).is_ne());
        assert_eq!(HashSet::from([x, y]).len(), 2);
    }

    /// When this fails the dependency is mended, and order and rounding can be the inner type's.
    #[test]
    #[allow(clippy::disallowed_methods, reason = "shown to be wrong")]
    fn the_dependency_still_floors_small_negative_quotients_wrongly() {
        let floor = Integer::from(-1).div_floor(&Integer::from(2));
        assert_eq!(floor, Integer::ZERO);
    }
}
