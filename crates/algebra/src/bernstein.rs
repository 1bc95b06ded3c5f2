//! Polynomials on boxes in Bernstein form.
//!
//! A polynomial of degree at most `d_k` in `x_k` is, on a box, `sum_j b_j B_j(t)` with the products `B_j` of
//! Bernstein polynomials in the coordinates `0 <= t_k <= 1` of the box. They are nonnegative and sum to one,
//! so every value lies between the least and the greatest coefficient, and the coefficients at the
//! corners of the index range are the values at the corners of the box (Cargo and Shisha 1966). Halving the
//! box (de Casteljau) brings the bounds closer, with an error that falls with the square of the width.
//!
//! Coefficients are integers with one common positive scale: halving costs additions and shifts.

use crate::rational::{Integer, Rational, integer};
use crate::rational_box::RationalBox;
use num_integer::Integer as _;
use num_traits::Zero;

/// Why a polynomial has no Bernstein form on a box.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum BernsteinError {
    /// A term has more or fewer exponents than the box has sides.
    #[error("term {term} has {found} exponents, the box has {expected} sides")]
    WrongDimension {
        /// The number of the term, from zero.
        term: usize,
        /// The number of its exponents.
        found: usize,
        /// The number of sides.
        expected: usize,
    },
    /// There are more coefficients than [`MAX_COEFFICIENTS`](BernsteinForm::MAX_COEFFICIENTS).
    #[error("the Bernstein form has more than {limit} coefficients")]
    TooLarge {
        /// The largest number of coefficients.
        limit: usize,
    },
}

/// A term: the exponent of each variable, and the coefficient. Terms with the same exponents add up.
pub type Term = (Vec<u32>, Rational);

/// The Bernstein coefficients of a polynomial on a box.
///
/// ```
/// use torse_algebra::bernstein::BernsteinForm;
/// use torse_algebra::rational_box::RationalBox;
/// use torse_algebra::rational::{integer, ratio};
/// // 1 - 2 x y on the unit square.
/// let terms = [(vec![0, 0], integer(1)), (vec![1, 1], integer(-2))];
/// let form = BernsteinForm::new(&terms, &RationalBox::unit(2)?)?;
/// assert_eq!(form.bounds(), (integer(-1), integer(1)));
/// assert_eq!(form.coefficients().collect::<Vec<_>>(), [1, 1, 1, -1].map(integer));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct BernsteinForm {
    region: RationalBox,
    degrees: Vec<usize>,
    /// In the order of the multi-indices, the last index running fastest.
    numerators: Vec<Integer>,
    /// Positive; each coefficient is a numerator times this.
    scale: Rational,
}

impl BernsteinForm {
    /// The most coefficients a form may have.
    pub const MAX_COEFFICIENTS: usize = 1 << 16;

    /// The form of a polynomial on a box.
    ///
    /// # Errors
    /// [`BernsteinError::WrongDimension`] and [`BernsteinError::TooLarge`].
    pub fn new(terms: &[Term], region: &RationalBox) -> Result<Self, BernsteinError> {
        let degrees = degrees_of(terms, region)?;
        let size = degrees.iter().map(|d| d + 1).product();
        let mut tensor = vec![Rational::zero(); size];
        for (exponents, coefficient) in terms {
            let place = exponents
                .iter()
                .zip(&degrees)
                .fold(0, |place, (&e, d)| place * (d + 1) + e as usize);
            tensor[place] += coefficient;
        }
        for (axis, (lower, upper)) in region.sides().iter().enumerate() {
            let binomials = binomials(degrees[axis]);
            on_each_line(&mut tensor, &degrees, axis, |line| {
                move_origin(line, lower, &(upper - lower));
                to_bernstein(line, &binomials);
            });
        }
        let common = tensor
            .iter()
            .fold(Integer::ONE, |lcm, c| lcm.lcm(c.denom()));
        let numerators = tensor
            .iter()
            .map(|c| c.numer() * (&common / c.denom()))
            .collect();
        let scale = Rational::new(Integer::ONE, common);
        Ok(Self {
            region: region.clone(),
            degrees,
            numerators,
            scale,
        })
    }

    /// The box.
    #[must_use]
    pub fn region(&self) -> &RationalBox {
        &self.region
    }

    /// The degree in each variable.
    #[must_use]
    pub fn degrees(&self) -> &[usize] {
        &self.degrees
    }

    /// The coefficients in the order of their multi-indices, the last index running fastest.
    pub fn coefficients(&self) -> impl Iterator<Item = Rational> {
        self.numerators.iter().map(|n| &self.scale * n)
    }

    /// The coefficients divided by their common positive factor [`Self::scale`]; they have the signs of the
    /// coefficients.
    #[must_use]
    pub fn numerators(&self) -> &[Integer] {
        &self.numerators
    }

    /// The positive common factor of the coefficients: each coefficient is a numerator times this.
    #[must_use]
    pub fn scale(&self) -> &Rational {
        &self.scale
    }

    /// The smallest and the largest coefficient; they bound all values of the polynomial on the box.
    #[must_use]
    pub fn bounds(&self) -> (Rational, Rational) {
        let (least, greatest) = (self.numerators.iter().min(), self.numerators.iter().max());
        let exact = |n: Option<&Integer>| n.map_or_else(Rational::zero, |n| &self.scale * n);
        (exact(least), exact(greatest))
    }

    /// The corners of the box, each with the value of the polynomial there.
    pub fn corners(&self) -> impl Iterator<Item = (Vec<Rational>, Rational)> {
        self.numerators
            .iter()
            .enumerate()
            .filter_map(|(place, numerator)| {
                let mut rest = place;
                let mut point = Vec::with_capacity(self.degrees.len());
                for (degree, (lower, upper)) in self.degrees.iter().zip(self.region.sides()).rev() {
                    let index = rest % (degree + 1);
                    rest /= degree + 1;
                    match index {
                        0 => point.push(lower.clone()),
                        index if index == *degree => point.push(upper.clone()),
                        _ => return None,
                    }
                }
                point.reverse();
                Some((point, &self.scale * numerator))
            })
    }

    /// The forms on the two halves of the box, split across side `axis`; `None` if there is no such side or its
    /// length is zero.
    #[must_use]
    pub fn halves(&self, axis: usize) -> Option<(Self, Self)> {
        let (low, high) = self.region.halves(axis)?;
        let half = |region, toward_low: fn(&mut [Integer])| {
            let mut numerators = self.numerators.clone();
            on_each_line(&mut numerators, &self.degrees, axis, toward_low);
            // Cancel common factors of two.
            let zeros = numerators
                .iter()
                .filter_map(Integer::trailing_zeros)
                .min()
                .unwrap_or(0);
            for numerator in &mut numerators {
                *numerator = &*numerator >> zeros;
            }
            let power = |exponent: usize| Integer::ONE << exponent;
            let scale = &self.scale * Rational::new(power(zeros), power(self.degrees[axis]));
            Self {
                region,
                degrees: self.degrees.clone(),
                numerators,
                scale,
            }
        };
        Some((half(low, lower_half), half(high, upper_half)))
    }
}

/// The degree in each variable; refuses forms of more than [`BernsteinForm::MAX_COEFFICIENTS`] coefficients.
fn degrees_of(terms: &[Term], region: &RationalBox) -> Result<Vec<usize>, BernsteinError> {
    let expected = region.dimension();
    let mut degrees = vec![0; expected];
    for (term, (exponents, _)) in terms.iter().enumerate() {
        if exponents.len() != expected {
            return Err(BernsteinError::WrongDimension {
                term,
                found: exponents.len(),
                expected,
            });
        }
        for (degree, &exponent) in degrees.iter_mut().zip(exponents) {
            *degree = (*degree).max(exponent as usize);
        }
    }
    let size = degrees
        .iter()
        .try_fold(1_usize, |size, d| size.checked_mul(d.checked_add(1)?));
    match size {
        Some(size) if size <= BernsteinForm::MAX_COEFFICIENTS => Ok(degrees),
        _ => Err(BernsteinError::TooLarge {
            limit: BernsteinForm::MAX_COEFFICIENTS,
        }),
    }
}

/// Applies an operation to each line of a tensor along one axis.
fn on_each_line<T: Clone>(
    tensor: &mut [T],
    degrees: &[usize],
    axis: usize,
    operation: impl Fn(&mut [T]),
) {
    let length = degrees[axis] + 1;
    let stride: usize = degrees[axis + 1..].iter().map(|d| d + 1).product();
    for block in tensor.chunks_exact_mut(length * stride) {
        for start in 0..stride {
            let mut line: Vec<T> = block[start..].iter().step_by(stride).cloned().collect();
            operation(&mut line);
            for (place, value) in block[start..].iter_mut().step_by(stride).zip(line) {
                *place = value;
            }
        }
    }
}

/// Replaces `p(x)` by `p(origin + width t)`, by repeated Horner steps.
fn move_origin(line: &mut [Rational], origin: &Rational, width: &Rational) {
    let length = line.len();
    if !origin.is_zero() {
        for start in 0..length {
            for i in (start..length - 1).rev() {
                line[i] = &line[i] + origin * &line[i + 1];
            }
        }
    }
    if *width != integer(1) {
        let mut power = integer(1);
        for c in line {
            *c = &*c * &power;
            power *= width;
        }
    }
}

/// Converts power coefficients on `[0, 1]` to Bernstein coefficients: `b_j = sum_(i <= j) C(j,i)/C(d,i) a_i`.
///
/// After each `a_i` is divided by `C(d,i)`, the sums of Pascal's triangle compute these.
fn to_bernstein(line: &mut [Rational], binomials: &[Integer]) {
    for (c, binomial) in line.iter_mut().zip(binomials) {
        *c = &*c / binomial;
    }
    for start in 1..line.len() {
        for i in (start..line.len()).rev() {
            line[i] = &line[i] + &line[i - 1];
        }
    }
}

/// `C(n, 0), ..., C(n, n)`.
fn binomials(n: usize) -> Vec<Integer> {
    let mut row = vec![Integer::ONE];
    for k in 1..=n {
        let next = &row[k - 1] * (n + 1 - k) / k;
        row.push(next);
    }
    row
}

/// De Casteljau at 1/2 without its divisions: `2^d` times the coefficients on the lower half.
fn lower_half(line: &mut [Integer]) {
    let degree = line.len() - 1;
    for start in 1..=degree {
        for i in (start..=degree).rev() {
            line[i] = &line[i] + &line[i - 1];
        }
    }
    // Entry i was summed i times, so it lacks d - i doublings of the common factor 2^d.
    for (i, c) in line.iter_mut().enumerate() {
        *c = &*c << (degree - i);
    }
}

/// `2^d` times the coefficients on the upper half: the mirror image of the lower one.
fn upper_half(line: &mut [Integer]) {
    line.reverse();
    lower_half(line);
    line.reverse();
}
