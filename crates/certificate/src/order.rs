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

    /// The steps of the proof in words.
    #[must_use]
    pub fn steps(&self) -> Vec<String> {
        if self.of_many {
            return vec![
                "one coordinate of the difference never vanishes on the domain".to_owned(),
            ];
        }
        let certificates = || self.signs.iter().flat_map(Sign::certificates);
        let mut steps = vec![];
        if certificates().any(|certificate| certificate.squares.is_empty()) {
            steps.push(
                "all Bernstein coefficients of the difference on the domain have the right sign",
            );
        }
        if certificates().any(|certificate| !certificate.squares.is_empty()) {
            steps.push("sums of squares are not negative");
        }
        let uses = self.signs.iter().any(|sign| !sign.constraints().is_empty());
        if uses || self.bounded_by_assumptions {
            steps.push("the assumptions bound the domain");
        }
        let mut steps: Vec<String> = steps.into_iter().map(str::to_owned).collect();
        let pieces = |sign: &Sign<P>| sign.certificates().iter().map(|c| c.pieces.len()).sum();
        let pieces = self.signs.iter().map(pieces).max();
        if let Some(pieces) = pieces.filter(|n: &usize| *n > 1) {
            steps.push(format!("on each of the {pieces} parts of the domain"));
        }
        steps
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

    /// The steps of the proof in words.
    #[must_use]
    pub fn steps(&self) -> Vec<String> {
        vec!["the hypotheses exclude that the difference vanishes".to_owned()]
    }
}
