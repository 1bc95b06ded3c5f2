//! Proofs of order relations and of `!=`, by the sign of a difference.

use crate::ratio::sign;
use crate::sign::Sign;
use serde::Serialize;
use torse_syntax::formula::Relation;

/// A proof of `left relation right` by the sign of left minus right.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Order<P> {
    /// The relation.
    #[serde(serialize_with = "sign")]
    pub relation: Relation,
    /// The compared entry, from 0. Numbers have one entry; two vectors differ if one entry does.
    pub entry: usize,
    /// Whether the sides have several entries.
    pub of_many: bool,
    /// The numerator of the difference.
    pub above: P,
    /// The factors of its denominator with their exponents.
    pub below: Vec<(P, u32)>,
    /// Whether `signs` contains the sign of the product of numerator and denominator, instead of their signs one by
    /// one.
    pub product: bool,
    /// The sign of the numerator or its negative, then of each factor of the denominator or its negative; or the sign
    /// of the product.
    pub signs: Vec<Sign<P>>,
    /// The divisors of the computation.
    pub divisors: Vec<P>,
    /// Whether the hypotheses bound a symbol of one of these polynomials.
    pub bounded_by_assumptions: bool,
}

/// A proof of `left != right`: the hypotheses imply that the numerator of the difference is nonzero, because it
/// divides a product of quantities that are assumed to be nonzero, or is a product of such quantities.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Excluded<P> {
    /// The numerator.
    pub numerator: P,
    /// The divisors of the computation.
    pub divisors: Vec<P>,
}

impl<P> Order<P> {
    /// Converts every polynomial.
    pub fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Order<Q> {
        let below = self.below.iter();
        Order {
            relation: self.relation,
            entry: self.entry,
            of_many: self.of_many,
            above: change(&self.above),
            below: below.map(|(p, e)| (change(p), *e)).collect(),
            product: self.product,
            signs: self.signs.iter().map(|sign| sign.map(change)).collect(),
            divisors: self.divisors.iter().map(change).collect(),
            bounded_by_assumptions: self.bounded_by_assumptions,
        }
    }
}

impl<P> Excluded<P> {
    /// Converts every polynomial.
    pub fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Excluded<Q> {
        Excluded {
            numerator: change(&self.numerator),
            divisors: self.divisors.iter().map(change).collect(),
        }
    }
}
