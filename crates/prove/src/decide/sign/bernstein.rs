//! Bernstein coefficients on a part of the box, and what they tell.
//!
//! The coefficients at the corners of the index range are the values at the corners of the box, so that a search can end
//! at once where the polynomial is negative at one.

use super::coordinates::{Coordinates, Region, Side};
use crate::decide::order::order;
use std::cmp::Ordering;
use std::collections::BTreeMap;
use torse_algebra::bernstein::{BernsteinForm, Term};
use torse_algebra::fault_injection::{InjectedFault, injected};
use torse_algebra::rational::integer;
use torse_algebra::rational_box::RationalBox;
use torse_algebra::work::{self, Spent};
use torse_algebra::{Fraction, Integer, Polynomial};

/// The most Bernstein coefficients computed.
const MAX_PIECES: usize = 20_000;

/// What a step with rational numbers of a word costs at least, in units of [`work`].
const RATIONAL_WORK: usize = 1;

/// Spends what as many steps as these multiply to cost.
///
/// # Errors
/// The limit that the job met.
pub fn spend_on_rationals(steps: &[usize]) -> Result<(), Spent> {
    let all = steps
        .iter()
        .fold(RATIONAL_WORK, |all, n| all.saturating_mul(*n));
    work::spend(u64::try_from(all).unwrap_or(u64::MAX))
}

/// A polynomial on a part of the box: for each product of numbers (pi, roots) and of unbounded coordinates a Bernstein
/// form with rational coefficients, all of the same degrees. Halving costs additions of integers.
#[derive(Debug, Clone)]
pub struct Spread {
    parts: Vec<Part>,
    /// The degree in each side of the box.
    degrees: Vec<usize>,
}

#[derive(Debug, Clone)]
struct Part {
    /// Powers of unbounded coordinates, which are not negative.
    ray: Polynomial,
    /// Powers of pi and of roots.
    number: Polynomial,
    form: BernsteinForm,
}

/// What the coefficients show.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shown {
    /// Greater than zero on the part of the domain.
    Positive,
    /// Zero or more.
    Nonnegative,
    /// A corner of the part, at the ends of the unbounded coordinates, where it is less than zero.
    NegativeCorner,
    /// Nothing.
    Nothing,
}

impl Spread {
    /// The polynomial on the whole box; `None` if there are too many coefficients.
    pub fn new(polynomial: &Polynomial, coordinates: &Coordinates) -> Option<Self> {
        let sides = &coordinates.sides;
        let degree = |side: &Side| usize::from(polynomial.degree_in(&side.symbol));
        let degrees: Vec<usize> = sides.iter().map(degree).collect();
        let count = degrees
            .iter()
            .try_fold(1_usize, |n, d| n.checked_mul(d + 1));
        if count.is_none_or(|count| count > MAX_PIECES) {
            return None;
        }
        // Each line of coefficients is turned by as many steps as it is long, times half of it.
        let highest: usize = degrees.iter().sum();
        spend_on_rationals(&[count?, highest, 1 + polynomial.bits().max(highest) / 64]).ok()?;
        // A box has at least one side.
        let region = RationalBox::unit(sides.len().max(1)).ok()?;
        let highest = degrees.iter().map(|d| u32::try_from(*d).ok());
        let mut highest: Vec<u32> = highest.collect::<Option<_>>()?;
        highest.resize(region.dimension(), 0);
        let mut sorted: BTreeMap<(Polynomial, Polynomial), Vec<Term>> = BTreeMap::new();
        for term in polynomial.terms() {
            let (mut ray, mut number) = (Polynomial::integer(1), Polynomial::integer(1));
            let mut exponents = vec![0; region.dimension()];
            for (symbol, exponent) in term.powers {
                let power = || Polynomial::symbol(symbol.clone()).power(u32::from(exponent));
                if let Some(side) = sides.iter().position(|side| side.symbol == *symbol) {
                    *exponents.get_mut(side)? = u32::from(exponent);
                } else if symbol.is_number() {
                    number = &number * &power();
                } else {
                    ray = &ray * &power();
                }
            }
            // The term of the highest degrees gives all forms the same number of coefficients.
            let padding = || vec![(highest.clone(), integer(0))];
            let own = sorted.entry((ray, number)).or_insert_with(padding);
            own.push((exponents, term.coefficient.clone()));
        }
        let part = |((ray, number), terms): ((Polynomial, Polynomial), Vec<Term>)| {
            let form = BernsteinForm::new(&terms, &region).ok()?;
            Some(Part { ray, number, form })
        };
        let parts = sorted.into_iter().map(part).collect::<Option<_>>()?;
        Some(Self { parts, degrees })
    }

    /// The degree in a side of the box.
    pub fn degree(&self, side: usize) -> usize {
        self.degrees.get(side).copied().unwrap_or(0)
    }

    /// The polynomial on the two halves across a side.
    pub fn halves(&self, side: usize) -> Option<[Self; 2]> {
        let count: usize = self.degrees.iter().map(|d| d + 1).product();
        let steps: usize = [count, self.parts.len(), self.degree(side)]
            .iter()
            .product();
        work::spend(u64::try_from(steps).unwrap_or(u64::MAX)).ok()?;
        let mut halves = [vec![], vec![]];
        for Part { ray, number, form } in &self.parts {
            let (low, high) = form.halves(side)?;
            for (half, form) in halves.iter_mut().zip([low, high]) {
                let (ray, number) = (ray.clone(), number.clone());
                half.push(Part { ray, number, form });
            }
        }
        Some(halves.map(|parts| Self {
            parts,
            degrees: self.degrees.clone(),
        }))
    }

    /// What the coefficients on this region show.
    ///
    /// A polynomial with nonnegative coefficients is positive if on every face of the region that belongs to
    /// the domain some coefficient is positive: the Bernstein polynomials of a face are positive inside it.
    pub fn shown(&self, coordinates: &Coordinates, region: &Region) -> Shown {
        let count = self.degrees.iter().map(|d| d + 1).product();
        let (mut positive, mut nothing) = (Vec::with_capacity(count), false);
        for place in 0..count {
            match self.sign_at(place, coordinates) {
                Some(sign) if sign.constant_negative && self.is_corner(place) => {
                    return Shown::NegativeCorner;
                }
                Some(sign) if sign.nonnegative => positive.push(sign.positive),
                _ => nothing = true,
            }
        }
        if nothing {
            return Shown::Nothing;
        }
        let ends = coordinates.closed_ends(region);
        let faces = self
            .degrees
            .iter()
            .zip(ends)
            .map(|(degree, (lower, upper))| {
                let face = |first, last| Face { first, last };
                let low = lower.then(|| face(0, 1));
                let high = upper.then(|| face(*degree, degree + 1));
                let all = [Some(face(0, degree + 1)), low, high];
                all.into_iter().flatten().collect()
            });
        let faces: Vec<Vec<Face>> = faces.collect();
        if every_face_positive(&positive, &faces) || injected(InjectedFault::ZeroTakenForPositive) {
            Shown::Positive
        } else {
            Shown::Nonnegative
        }
    }

    /// How the value at a corner of the region compares with zero, where the unbounded coordinates that may be zero are;
    /// `None` if that depends on the others. The corner is at the upper ends of the sides for which `upper` is true.
    pub fn order_at_corner(&self, upper: &[bool], coordinates: &Coordinates) -> Option<Ordering> {
        let sides = self.degrees.iter().zip(upper);
        let place = sides.fold(0, |place, (degree, upper)| {
            place * (degree + 1) + if *upper { *degree } else { 0 }
        });
        let mut order = Ordering::Equal;
        for parts in self.parts.chunk_by(|a, b| a.ray == b.ray) {
            let own = match parts.first() {
                Some(part) if coordinates.excludes_zero(&part.ray) => number_sign(parts, place)?,
                _ => continue,
            };
            if order == own.reverse() && own != Ordering::Equal {
                return None;
            }
            order = order.then(own);
        }
        Some(order)
    }

    /// Whether the coefficient at this place is the value at a corner.
    fn is_corner(&self, mut place: usize) -> bool {
        self.degrees.iter().rev().all(|degree| {
            let index = place % (degree + 1);
            place /= degree + 1;
            index == 0 || index == *degree
        })
    }

    /// The sign of the coefficient at this place, a polynomial in the unbounded coordinates.
    fn sign_at(&self, place: usize, coordinates: &Coordinates) -> Option<RaySign> {
        let mut sign = RaySign {
            nonnegative: true,
            positive: false,
            constant_negative: false,
        };
        // The parts of one ray stand together.
        for parts in self.parts.chunk_by(|a, b| a.ray == b.ray) {
            let order = number_sign(parts, place)?;
            let Some(Part { ray, .. }) = parts.first() else {
                continue;
            };
            sign.nonnegative &= order.is_ge();
            sign.positive |= order.is_gt() && coordinates.excludes_zero(ray);
            sign.constant_negative |= order.is_lt() && ray.is_one();
        }
        Some(sign)
    }
}

/// How the number that these parts make up at a place compares with zero. Products of powers of pi and roots are
/// linearly independent over the rationals, so that a sum of them is zero only if each coefficient is.
fn number_sign(parts: &[Part], place: usize) -> Option<Ordering> {
    let numerators = parts.iter().map(|part| part.form.numerators().get(place));
    let numerators: Vec<&Integer> = numerators.collect::<Option<_>>()?;
    let some = |order: Ordering| numerators.iter().any(|n| n.cmp(&&Integer::ZERO) == order);
    // Each product of powers is a positive number.
    match (some(Ordering::Greater), some(Ordering::Less)) {
        (false, false) => Some(Ordering::Equal),
        (true, false) => Some(Ordering::Greater),
        (false, true) => Some(Ordering::Less),
        (true, true) => {
            let terms = parts.iter().zip(&numerators);
            let total = terms.fold(Polynomial::zero(), |sum, (part, numerator)| {
                &sum + &part.number.scaled(&(part.form.scale() * *numerator))
            });
            order(&Fraction::from(total))
        }
    }
}

/// A range of Bernstein indices of one coordinate.
#[derive(Clone, Copy)]
struct Face {
    first: usize,
    last: usize,
}

/// Whether every choice of one face a coordinate contains a positive entry. The entries are in row-major
/// order: the last coordinate varies fastest.
fn every_face_positive(positive: &[bool], faces: &[Vec<Face>]) -> bool {
    let Some((own, rest)) = faces.split_first() else {
        return positive.first().copied().unwrap_or(false);
    };
    let count = own.first().map_or(1, |face| face.last).max(1);
    let stride = positive.len() / count;
    own.iter().all(|face| {
        let merged: Vec<bool> = (0..stride)
            .map(|offset| {
                (face.first..face.last).any(|i| positive.get(i * stride + offset) == Some(&true))
            })
            .collect();
        every_face_positive(&merged, rest)
    })
}

/// What the coefficients of a polynomial in nonnegative symbols, pi and roots tell.
struct RaySign {
    /// Every coefficient is nonnegative.
    nonnegative: bool,
    /// One of a product that is never zero is positive: then, if none is negative, the polynomial is positive.
    positive: bool,
    /// The constant one is negative.
    constant_negative: bool,
}
