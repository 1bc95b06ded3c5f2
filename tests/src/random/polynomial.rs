//! Polynomials in a few slots, and formulas that are printed in one form and known in another.

use super::number::Q;
use super::seed::Stream;
use std::collections::BTreeMap;
use std::ops::{Add, Mul, Neg, Sub};

/// How many slots a polynomial has.
pub const SLOTS: usize = 4;

/// A polynomial in [`SLOTS`] slots.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Polynomial {
    terms: BTreeMap<[u32; SLOTS], Q>,
}

impl Polynomial {
    /// A number.
    #[must_use]
    pub fn number(q: Q) -> Self {
        let mut made = Self::default();
        made.put([0; SLOTS], q);
        made
    }

    /// The variable of a slot.
    #[must_use]
    pub fn variable(slot: usize) -> Self {
        let mut exponents = [0; SLOTS];
        exponents[slot] = 1;
        let mut made = Self::default();
        made.put(exponents, Q::ONE);
        made
    }

    fn put(&mut self, exponents: [u32; SLOTS], q: Q) {
        let sum = self.terms.get(&exponents).copied().unwrap_or(Q::ZERO) + q;
        if sum == Q::ZERO {
            self.terms.remove(&exponents);
        } else {
            self.terms.insert(exponents, sum);
        }
    }

    /// Some polynomial in the first `slots` slots with at most `terms` terms of at most this degree in each.
    pub fn some(stream: &mut Stream, slots: usize, terms: usize, degree: usize) -> Self {
        let mut made = Self::default();
        for _ in 0..terms {
            let mut exponents = [0; SLOTS];
            for exponent in exponents.iter_mut().take(slots) {
                *exponent = u32::try_from(stream.below(degree + 1)).unwrap_or(0);
            }
            let q = stream.fraction();
            made.put(exponents, q);
        }
        if made.terms.is_empty() {
            return Self::number(Q::ONE);
        }
        made
    }

    /// Whether it is zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// Times a number.
    #[must_use]
    pub fn times(&self, q: Q) -> Self {
        self * &Self::number(q)
    }

    /// A power.
    #[must_use]
    pub fn power(&self, exponent: u32) -> Self {
        (0..exponent).fold(Self::number(Q::ONE), |product, _| &product * self)
    }

    /// The value at a point.
    #[must_use]
    pub fn value(&self, point: &[Q; SLOTS]) -> Q {
        let term = |(exponents, q): (&[u32; SLOTS], &Q)| {
            exponents
                .iter()
                .zip(point)
                .fold(*q, |product, (e, x)| product * x.power(*e))
        };
        self.terms.iter().map(term).fold(Q::ZERO, Add::add)
    }

    /// With another polynomial in a slot.
    #[must_use]
    pub fn with(&self, slot: usize, other: &Self) -> Self {
        let mut made = Self::default();
        for (exponents, q) in &self.terms {
            let mut rest = *exponents;
            rest[slot] = 0;
            let mut term = Self::default();
            term.put(rest, *q);
            made = &made + &(&term * &other.power(exponents[slot]));
        }
        made
    }

    /// The derivative by a slot.
    #[must_use]
    pub fn derivative(&self, slot: usize) -> Self {
        let mut made = Self::default();
        for (exponents, q) in &self.terms {
            if exponents[slot] > 0 {
                let mut rest = *exponents;
                rest[slot] -= 1;
                made.put(rest, *q * Q::int(i128::from(exponents[slot])));
            }
        }
        made
    }

    /// One coefficient, sign or exponent changed, or one term dropped: never the same polynomial.
    pub fn slipped(&self, stream: &mut Stream) -> Self {
        let terms: Vec<_> = self.terms.iter().collect();
        if terms.is_empty() {
            return Self::number(Q::ONE);
        }
        let (exponents, q) = terms[stream.below(terms.len())];
        let mut made = self.clone();
        match stream.below(4) {
            0 => made.put(*exponents, *q * Q::int(-2)),
            1 => made.put(*exponents, -*q),
            2 => made.put(*exponents, Q::int(stream.nonzero(2))),
            _ => {
                let mut other = *exponents;
                other[0] += 1;
                made.put(*exponents, -*q);
                made.put(other, *q);
            }
        }
        made
    }

    /// Printed as a sum of terms in an order of the stream's; `names` are names or formulas that bind tightly.
    pub fn text(&self, stream: &mut Stream, names: &[&str]) -> String {
        let mut terms: Vec<_> = self.terms.iter().collect();
        stream.shuffle(&mut terms);
        let mut text = String::new();
        for (exponents, q) in terms {
            let size = if *q < Q::ZERO { -*q } else { *q };
            let mut factors = vec![];
            for (name, exponent) in names.iter().zip(exponents) {
                match exponent {
                    0 => (),
                    1 => factors.push((*name).to_owned()),
                    e => factors.push(format!("{name}^{e}")),
                }
            }
            if size != Q::ONE || factors.is_empty() {
                factors.insert(0, size.to_string());
            }
            let product = factors.join("*");
            text = match (text.is_empty(), *q < Q::ZERO) {
                (true, false) => product,
                (true, true) => format!("-{product}"),
                (false, false) => format!("{text} + {product}"),
                (false, true) => format!("{text} - {product}"),
            };
        }
        if text.is_empty() {
            "0".to_owned()
        } else {
            text
        }
    }
}

impl Add for &Polynomial {
    type Output = Polynomial;
    fn add(self, other: Self) -> Polynomial {
        let mut sum = self.clone();
        for (exponents, q) in &other.terms {
            sum.put(*exponents, *q);
        }
        sum
    }
}

impl Sub for &Polynomial {
    type Output = Polynomial;
    fn sub(self, other: Self) -> Polynomial {
        self + &(-other)
    }
}

impl Neg for &Polynomial {
    type Output = Polynomial;
    fn neg(self) -> Polynomial {
        self.times(Q::int(-1))
    }
}

impl Mul for &Polynomial {
    type Output = Polynomial;
    fn mul(self, other: Self) -> Polynomial {
        let mut product = Polynomial::default();
        for (left, p) in &self.terms {
            for (right, q) in &other.terms {
                let mut exponents = *left;
                for (sum, more) in exponents.iter_mut().zip(right) {
                    *sum += more;
                }
                product.put(exponents, *p * *q);
            }
        }
        product
    }
}

/// A formula as printed, and the polynomial that it is.
#[derive(Debug, Clone)]
pub struct Formula {
    /// As printed.
    pub text: String,
    /// What it is.
    pub value: Polynomial,
}

impl Formula {
    /// Some nested formula: sums, products and powers of small polynomials.
    pub fn some(stream: &mut Stream, names: &[&str], depth: usize) -> Self {
        if depth == 0 {
            let value = Polynomial::some(stream, names.len(), 2, 1);
            return Self {
                text: value.text(stream, names),
                value,
            };
        }
        let left = Self::some(stream, names, depth - 1);
        let right = Self::some(stream, names, depth - 1);
        match stream.below(4) {
            0 => Self {
                text: format!("{} + ({})", left.text, right.text),
                value: &left.value + &right.value,
            },
            1 => Self {
                text: format!("({}) - ({})", left.text, right.text),
                value: &left.value - &right.value,
            },
            2 => Self {
                text: format!("({})^2", left.text),
                value: left.value.power(2),
            },
            _ => Self {
                text: format!("({})*({})", left.text, right.text),
                value: &left.value * &right.value,
            },
        }
    }
}
