//! The coefficients `c_1, ..., c_d` of the operator of a family.

use super::seeds::Seeds;
use super::{SHAPES, Unfit};
use crate::polynomial::Polynomial;
use crate::symbol::Symbol;
use torse_numbers::Rational;
use torse_numbers::rational::integer;

/// The largest order of an operator.
const MAX_ORDER: usize = 4;
/// The largest total degree of the seeds in their parameters.
const MAX_TOTAL: usize = 2;

/// A number times powers of x, sine, cosine and pi.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Term {
    pub coefficient: Rational,
    pub x: u32,
    pub sine: u32,
    pub cosine: u32,
    pub pi: u32,
}

/// The coefficient of one monomial in the shape parameters.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Part {
    pub shape: [u32; SHAPES],
    pub terms: Vec<Term>,
}

/// The operator `F + c_1 (k-1)!/k! F' + ... + c_d (k-d)!/k! F^(d)`.
#[derive(Debug, Clone)]
pub struct Operator {
    /// The coefficients as polynomials, from `c_1` on.
    pub(super) functions: Vec<Polynomial>,
    /// The same coefficients, separated by monomials in the parameters.
    pub(super) parts: Vec<Vec<Part>>,
    /// The largest total degree in the parameters.
    pub(super) total: usize,
    /// Which parameters occur.
    pub(super) used: [bool; SHAPES],
    pub(super) seeds: Seeds,
}

impl Operator {
    /// The operator of a family with these seeds and the step `1 - x`, `x`.
    ///
    /// # Errors
    /// [`Unfit::Make`] if the seeds do not sum to one, or do not have the required form.
    pub fn new(seeds: Seeds) -> Result<Self, Unfit> {
        let order = seeds.functions.len().saturating_sub(1);
        if order > MAX_ORDER {
            return Err(Unfit::Make("seeds of a higher degree than four"));
        }
        let zero = Polynomial::zero;
        let sum = seeds.functions.iter().fold(zero(), |sum, f| sum.plus(f));
        if sum != Polynomial::one() {
            return Err(Unfit::Make("the seeds do not sum to one"));
        }
        // E = P + (1-x) Q and 1 = P - x Q.
        let x = Polynomial::symbol(seeds.x());
        let (up, down) = (Polynomial::one().minus(&x), x.negated());
        let mut functions = vec![zero(); order];
        for (l, seed) in seeds.functions.iter().enumerate() {
            let mut row = vec![Polynomial::one()];
            for n in 0..order {
                let slope = if n < l { &up } else { &down };
                row.push(zero());
                for i in (1..row.len()).rev() {
                    row[i] = row[i].plus(&row[i - 1].times(slope));
                }
            }
            for (function, factor) in functions.iter_mut().zip(row.iter().skip(1)) {
                function.add(&factor.times(seed));
            }
        }
        let parts = functions.iter().map(|f| parts(f, &seeds));
        let parts: Vec<Vec<Part>> = parts.collect::<Result<_, _>>()?;
        let shapes = || parts.iter().flatten().map(|part| part.shape);
        let total = shapes().map(|shape| shape.iter().sum::<u32>()).max();
        let total = usize::try_from(total.unwrap_or(0)).unwrap_or(usize::MAX);
        if total > MAX_TOTAL {
            return Err(Unfit::Make("seeds of a high degree in their parameters"));
        }
        let used = [0, 1].map(|n| shapes().any(|shape| shape[n] > 0));
        Ok(Self {
            functions,
            parts,
            total,
            used,
            seeds,
        })
    }

    /// The order of the operator.
    pub(super) fn order(&self) -> usize {
        self.parts.len()
    }
}

/// `j (j-1) ... (j-i+1) / (k (k-1) ... (k-i+1))`, the factor of `c_i` in column j.
pub(super) fn weight(i: usize, j: usize, k: usize) -> Rational {
    let falling = |n: usize| {
        (0..i).fold(integer(1), |product, l| {
            product * integer(i64::try_from(n).unwrap_or(0) - i64::try_from(l).unwrap_or(0))
        })
    };
    if j < i || k < i {
        integer(0)
    } else {
        falling(j) / falling(k)
    }
}

/// Separates a function by monomials in the parameters, in an order that does not depend on names.
pub(super) fn parts(function: &Polynomial, seeds: &Seeds) -> Result<Vec<Part>, Unfit> {
    let other =
        || Unfit::Make("a function that is no polynomial in x, sin(pi/2*x) and cos(pi/2*x)");
    let x = seeds.x();
    let [sine, cosine] = seeds.turn();
    let mut parts: Vec<Part> = vec![];
    for (monomial, coefficient) in function.terms() {
        let mut term = Term {
            coefficient: coefficient.clone(),
            x: 0,
            sine: 0,
            cosine: 0,
            pi: 0,
        };
        let mut shape = [0; SHAPES];
        for (symbol, exponent) in monomial {
            let slot = match symbol {
                Symbol::Pi => &mut term.pi,
                symbol if *symbol == x => &mut term.x,
                symbol if *symbol == sine => &mut term.sine,
                symbol if *symbol == cosine => &mut term.cosine,
                Symbol::Named(name) => {
                    let place = seeds.shapes.iter().position(|own| own == name);
                    let slot = place.and_then(|place| shape.get_mut(place));
                    slot.ok_or_else(other)?
                }
                _ => return Err(other()),
            };
            *slot += *exponent;
        }
        match parts.iter_mut().find(|part| part.shape == shape) {
            Some(part) => part.terms.push(term),
            None => parts.push(Part {
                shape,
                terms: vec![term],
            }),
        }
    }
    parts.sort_by_key(|part| part.shape);
    for part in &mut parts {
        let exponents = |term: &Term| [term.x, term.sine, term.cosine, term.pi];
        part.terms.sort_by_key(exponents);
    }
    Ok(parts)
}
