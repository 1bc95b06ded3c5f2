//! Sums of powers as polynomials in the upper end.
//!
//! `S_k(n)` with `S_k(n) - S_k(n - 1) = n^k` and `S_k(-1) = 0` is the sum of `i^k` for i from 0 to n. Adding up
//! `(i + 1)^(k+1) - i^(k+1)` gives `(n + 1)^(k+1) = sum of binom(k + 1, j) S_j(n)` for j from 0 to k, from which they follow in turn. The first
//! equation is one of polynomials, so it holds for all integers, and so does `S_k(b) - S_k(a - 1)` for the sum from a to b.

use super::series::polynomial_of;
use torse_algebra::rational::integer;
use torse_algebra::{Affine, Polynomial, Rational};

/// The sum of the powers with this exponent of 0, 1, ..., n.
pub(super) fn up_to(exponent: u16, n: &Affine) -> Polynomial {
    let next = polynomial_of(&(n.clone() + Affine::number(1)));
    let mut sums: Vec<Polynomial> = vec![];
    for k in 0..=exponent {
        let mut sum = next.power(u32::from(k) + 1);
        let mut binomial = integer(1);
        for (j, lower) in (0_u16..).zip(&sums) {
            sum = &sum - &lower.scaled(&binomial);
            binomial = binomial * integer(i64::from(k + 1 - j)) / integer(i64::from(j) + 1);
        }
        sums.push(sum.scaled(&Rational::new(1.into(), (i64::from(k) + 1).into())));
    }
    sums.pop().unwrap_or_else(|| Polynomial::integer(0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use torse_algebra::Fraction;

    #[test]
    fn sums_of_powers_have_the_differences_of_powers() {
        let n = Affine::symbol("n");
        for k in 0..6 {
            let difference = &up_to(k, &n) - &up_to(k, &(n.clone() - Affine::number(1)));
            assert_eq!(
                difference,
                Polynomial::named("n").power(u32::from(k)),
                "{k}"
            );
            let none = Fraction::from(up_to(k, &Affine::number(-1)));
            assert!(none.is_zero(), "{k}");
        }
    }
}
