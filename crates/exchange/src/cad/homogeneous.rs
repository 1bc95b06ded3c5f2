//! Rails as polynomials in homogeneous coordinates, exactly.

use torse_algebra::rational::{Rational, integer};
use torse_geometry::{Coordinate, exact};

/// A polynomial in the power basis, lowest power first.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Polynomial(Vec<Rational>);

impl Polynomial {
    pub(super) fn constant(value: f64) -> Self {
        Self(vec![exact(value)]).trimmed()
    }

    /// From Bernstein coefficients: `p_j = C(n, j) sum_i (-1)^(j-i) C(j, i) b_i`.
    pub(super) fn of_bernstein(coefficients: impl Iterator<Item = f64>) -> Self {
        let mut row: Vec<Rational> = coefficients.map(exact).collect();
        let degree = row.len().saturating_sub(1);
        let mut powers = Vec::with_capacity(row.len());
        let mut choose = integer(1);
        for j in 0..=degree {
            // The j-th forward difference at zero.
            let Some(first) = row.first() else { break };
            powers.push(choose.clone() * first.clone());
            row = row
                .windows(2)
                .filter_map(|pair| Some(pair.get(1)?.clone() - pair.first()?.clone()))
                .collect();
            choose *= fraction(degree - j, j + 1);
        }
        Self(powers).trimmed()
    }

    /// The Bernstein coefficients of this degree, which must not be below that of the polynomial.
    pub(super) fn bernstein(&self, degree: usize) -> Vec<Rational> {
        // b_i = sum_j C(i, j)/C(n, j) p_j
        let value = |i: usize| {
            let mut sum = integer(0);
            let mut ratio = integer(1);
            for (j, p) in self.0.iter().enumerate() {
                sum += ratio.clone() * p.clone();
                if j >= i {
                    break;
                }
                ratio *= fraction(i - j, degree - j);
            }
            sum
        };
        (0..=degree).map(value).collect()
    }

    pub(super) fn degree(&self) -> usize {
        self.0.len().saturating_sub(1)
    }

    pub(super) fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    pub(super) fn derivative(&self) -> Self {
        let terms = self.0.iter().enumerate().skip(1);
        Self(terms.map(|(j, p)| fraction(j, 1) * p.clone()).collect()).trimmed()
    }

    pub(super) fn plus(&self, other: &Self) -> Self {
        let length = self.0.len().max(other.0.len());
        let at = |list: &[Rational], j: usize| list.get(j).cloned().unwrap_or_else(|| integer(0));
        let sum = |j: usize| at(&self.0, j) + at(&other.0, j);
        Self((0..length).map(sum).collect()).trimmed()
    }

    pub(super) fn minus(&self, other: &Self) -> Self {
        self.plus(&other.times(&Self::constant(-1.0)))
    }

    pub(super) fn times(&self, other: &Self) -> Self {
        let length = (self.0.len() + other.0.len()).saturating_sub(1);
        let mut product = vec![integer(0); length];
        for (i, a) in self.0.iter().enumerate() {
            for (slot, b) in product.iter_mut().skip(i).zip(&other.0) {
                *slot += a.clone() * b.clone();
            }
        }
        Self(product).trimmed()
    }

    /// Without leading zeros: the zero polynomial has no coefficients.
    fn trimmed(mut self) -> Self {
        let zero = |q: &Rational| q.sign() == Some(std::cmp::Ordering::Equal);
        while self.0.last().is_some_and(zero) {
            self.0.pop();
        }
        self
    }
}

/// `n / d` of small numbers, `d` not zero.
fn fraction(n: usize, d: usize) -> Rational {
    Rational::new(n.into(), d.max(1).into())
}

/// A vector of polynomials.
pub(super) type Vector = [Polynomial; 3];

pub(super) fn cross(a: &Vector, b: &Vector) -> Vector {
    let minor = |i: usize, j: usize| a[i].times(&b[j]).minus(&a[j].times(&b[i]));
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

pub(super) fn dot(a: &Vector, b: &Vector) -> Polynomial {
    a[0].times(&b[0])
        .plus(&a[1].times(&b[1]))
        .plus(&a[2].times(&b[2]))
}

pub(super) fn scaled(a: &Vector, factor: &Polynomial) -> Vector {
    a.each_ref().map(|x| x.times(factor))
}

pub(super) fn sum(a: &Vector, b: &Vector) -> Vector {
    [a[0].plus(&b[0]), a[1].plus(&b[1]), a[2].plus(&b[2])]
}

/// A rational curve `(x, y, z) = numerator / weight`.
#[derive(Debug, Clone)]
pub(super) struct Rail {
    pub(super) numerator: Vector,
    pub(super) weight: Polynomial,
}

impl Rail {
    pub(super) fn degree(&self) -> usize {
        let axes = self.numerator.iter().map(Polynomial::degree);
        axes.fold(self.weight.degree(), usize::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bernstein_and_power_form_are_inverse_and_elevation_keeps_the_end_values() {
        let coefficients = [3.0, -1.0, 4.0, 1.5];
        let polynomial = Polynomial::of_bernstein(coefficients.into_iter());
        assert_eq!(polynomial.bernstein(3), coefficients.map(exact).to_vec());
        let elevated = polynomial.bernstein(7);
        assert_eq!((&elevated[0], &elevated[7]), (&exact(3.0), &exact(1.5)));
        // (3 b0 + b1 (7 - 3)...)/7: the first step of elevation from 3 to 4 is (b0 + 3 b1)/4.
        assert_eq!(polynomial.bernstein(4)[1], exact(0.0));
    }

    #[test]
    fn the_product_rule_holds() {
        let p = Polynomial::of_bernstein([1.0, 2.0, -3.0].into_iter());
        let q = Polynomial::of_bernstein([0.5, 0.0, 7.0, 2.0].into_iter());
        let rule = p.derivative().times(&q).plus(&p.times(&q.derivative()));
        assert_eq!(p.times(&q).derivative(), rule);
        assert!(p.minus(&p).is_zero());
    }
}
