//! Conversion from values at equidistant places to Bernstein coefficients, through Newton's forward differences.
//!
//! A polynomial p of degree n is the sum of `(m-th difference of p at 0) binom(t, m)`, m = 0..n, with differences of
//! step one (Newton). So only subtractions and one table of the Bernstein coefficients of binomial coefficients are
//! needed.

use num_traits::Zero;
use torse_numbers::rational::integer;
use torse_numbers::{Ball, Rational};

/// The Bernstein coefficients of degree `degree` on [0, 1] of `binom(scale*t + shift, m)`, m = 0..degree, indexed by
/// coefficient, then by m.
pub(super) fn newton(
    scale: &Rational,
    shift: &Rational,
    degree: usize,
    bits: usize,
) -> Vec<Vec<Ball>> {
    let number = |n: usize| integer(i64::try_from(n).unwrap_or(0));
    let mut own = vec![integer(1)];
    let mut columns = vec![];
    for m in 0..=degree {
        columns.push(raised(&own, degree, bits));
        // Times (scale t + shift - m)/(m + 1), one degree more.
        let share = number(m + 1).recip();
        let low = (shift - number(m)) * &share;
        let high = (scale + shift - number(m)) * &share;
        let zero = Rational::zero();
        let next = (0..m + 2).map(|i| {
            let same = own.get(i).unwrap_or(&zero) * number(m + 1 - i) * &low;
            let before = i.checked_sub(1).and_then(|i| own.get(i)).unwrap_or(&zero);
            (same + before * number(i) * &high) * &share
        });
        own = next.collect();
    }
    let row = |i: usize| columns.iter().map(|column| column[i].clone()).collect();
    (0..=degree).map(row).collect()
}

/// Raises the degree of Bernstein coefficients; each step averages neighbours.
fn raised(coefficients: &[Rational], degree: usize, bits: usize) -> Vec<Ball> {
    let mut own: Vec<Ball> = coefficients
        .iter()
        .map(|c| Ball::from_rational(c, bits))
        .collect();
    for m in own.len()..=degree {
        let zero = Ball::from_rational(&Rational::zero(), bits);
        let share = |i: usize| {
            let share = Rational::new(i.into(), m.into());
            Ball::from_rational(&share, bits)
        };
        let next = (0..=m).map(|i| {
            let same = own.get(i).unwrap_or(&zero);
            let before = i.checked_sub(1).and_then(|i| own.get(i)).unwrap_or(&zero);
            &(same * &share(m - i)) + &(before * &share(i))
        });
        own = next.collect();
    }
    own
}

/// Replaces values by their forward differences at the first value.
pub(super) fn differences(values: &mut [Ball]) {
    for m in 1..values.len() {
        for i in (m..values.len()).rev() {
            values[i] = &values[i] - &values[i - 1];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use torse_numbers::rational::ratio;

    /// t^2 has the Bernstein coefficients 0, 0, 1/3, 1 of degree 3.
    #[test]
    fn values_become_bernstein_coefficients() {
        let bits = 64;
        let third = ratio(1, 3).unwrap();
        let square = |n: i64| {
            let t = integer(n) * &third;
            Ball::from_rational(&(&t * &t), bits)
        };
        let mut values: Vec<Ball> = (0..4).map(square).collect();
        differences(&mut values);
        let table = newton(&integer(3), &integer(0), 3, bits);
        let found: Vec<Ball> = table
            .iter()
            .map(|row| Ball::dot(row.iter().zip(&values), bits))
            .collect();
        for (ball, exact) in found
            .iter()
            .zip([integer(0), integer(0), third, integer(1)])
        {
            assert!(ball.contains(&exact), "{ball} {exact}");
            assert!(ball.width() < ratio(1, 1 << 40).unwrap());
        }
    }
}
