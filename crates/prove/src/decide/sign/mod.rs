//! Signs of polynomials on the declared domain.
//!
//! In [`coordinates`] that start at zero a polynomial is written in Bernstein form; pi stays and is
//! enclosed. **Theorem.** Bernstein polynomials and powers of t >= 0 are nonnegative and the Bernstein
//! polynomials sum to one, so if all coefficients are nonnegative the polynomial is, and if moreover every
//! face of the box has a positive coefficient it is positive. Assumed inequalities c >= 0 help in three
//! ways: parts of the box where one fails are left out, one that divides the polynomial is split off, and
//! multiples of one are subtracted. Every proof is a [`certificate`], which is replayed by other means.

mod bernstein;
pub mod certificate;
pub mod coordinates;
mod proof;
mod prove;
mod samples;
mod squares;

use super::domain::Domain;
use super::{Decision, Refutation, witness};
use crate::evaluate::quantity::Quantity;
use crate::evaluate::value::{NOWHERE, Value};
use crate::evidence::Evidence;
use certificate::{Certificate, CertificateError};
use torse_algebra::{Fraction, Integer, Polynomial, Symbol};
use torse_language::fault::Fault;
use torse_language::syntax::Relation;

pub use proof::{Proof, Shown};
pub use prove::prove;

/// A proved sign.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sign {
    /// Greater than zero everywhere.
    Positive,
    /// Zero or more.
    Nonnegative,
    /// Less than zero everywhere.
    Negative,
    /// Zero or less.
    Nonpositive,
}

impl Sign {
    /// The sign of the negative.
    #[must_use]
    pub fn negated(self) -> Self {
        match self {
            Self::Positive => Self::Negative,
            Self::Negative => Self::Positive,
            Self::Nonnegative => Self::Nonpositive,
            Self::Nonpositive => Self::Nonnegative,
        }
    }
}

/// A sign of the polynomial on the whole domain, if one can be proved this way.
#[must_use]
pub fn of(polynomial: &Polynomial, domain: &Domain<'_>) -> Option<Sign> {
    proof(polynomial, domain).map(|(sign, _)| sign)
}

/// The same with its certificate.
#[must_use]
pub fn proof(polynomial: &Polynomial, domain: &Domain<'_>) -> Option<(Sign, Proof)> {
    let shown = |polynomial: &Polynomial| {
        let proof = Proof::of(polynomial, domain)?;
        Some((proof.strict(), proof))
    };
    let (strict, weak) = match shown(polynomial) {
        Some((true, proof)) => return Some((Sign::Positive, proof)),
        other => (shown(&-polynomial), other),
    };
    match (strict, weak) {
        (Some((true, proof)), _) => Some((Sign::Negative, proof)),
        (_, Some((_, proof))) => Some((Sign::Nonnegative, proof)),
        (Some((false, proof)), None) => Some((Sign::Nonpositive, proof)),
        (None, None) => Proof::of_factors(polynomial, domain)
            .or_else(|| Proof::of_rays(polynomial, domain))
            .or_else(|| {
                let (sign, proof) = Proof::of_rays(&-polynomial, domain)?;
                Some((sign.negated(), proof))
            }),
    }
}

/// Whether the polynomial never vanishes on the domain, by a sign whose certificate is replayed, or because no integers
/// make it zero.
#[must_use]
pub fn never_zero(polynomial: &Polynomial, domain: &Domain<'_>) -> bool {
    if no_integers_solve(polynomial, domain) {
        return true;
    }
    match proof(polynomial, domain) {
        Some((Sign::Positive | Sign::Negative, proof)) => proof.check(domain).is_ok(),
        _ => false,
    }
}

/// Whether a linear form in integers with integer coefficients has a constant that their greatest common divisor does
/// not divide: then it is zero at no integers.
fn no_integers_solve(polynomial: &Polynomial, domain: &Domain<'_>) -> bool {
    let primitive = polynomial.primitive().1;
    let (mut divisor, mut constant) = (Integer::ZERO, Integer::ZERO);
    for term in primitive.terms() {
        if !term.coefficient.is_integer() {
            return false;
        }
        let coefficient = term.coefficient.to_integer();
        match term.powers.as_slice() {
            [] => constant = coefficient,
            [(symbol, 1)] if domain.is_integer(symbol) => {
                divisor = num_integer::Integer::gcd(&divisor, &coefficient);
            }
            _ => return false,
        }
    }
    divisor != Integer::ZERO
        && torse_algebra::rational::remainder(&constant, &divisor) != Integer::ZERO
}

/// Decides `left relation right` for an order relation or `!=`, on the domain.
///
/// # Errors
/// None at present; the signature is that of the other procedures.
pub fn compare(
    relation: Relation,
    left: &Value,
    right: &Value,
    domain: &Domain<'_>,
) -> Result<Decision, Fault> {
    let (lefts, rights) = (left.entries(), right.entries());
    let ([x], [y]) = (lefts.as_slice(), rights.as_slice()) else {
        return Ok(different(relation, &lefts, &rights, domain));
    };
    let (Some(x), Some(y)) = (x.as_fraction(), y.as_fraction()) else {
        return Err(Fault::limit(
            NOWHERE,
            "an order relation of symbolic degree",
        ));
    };
    let difference = x.clone() - y.clone();
    let opposite = relation.opposite();
    if relation == Relation::Different
        && domain.pivots.is_empty()
        && domain.assumes_nonzero(difference.numerator())
    {
        return Ok(Decision::Proven {
            evidence: Evidence::Inequality,
            conditions: witness::nonconstant(difference.conditions().to_vec()),
            steps: vec!["the hypotheses exclude that the difference vanishes".to_owned()],
        });
    }
    if difference.is_zero() && matches!(relation, Relation::AtMost | Relation::AtLeast) {
        return Ok(Decision::identity(
            witness::nonconstant(difference.conditions().to_vec()),
            "both sides are equal identically".to_owned(),
        ));
    }
    if let Some((sign, proofs)) = sign_of_fraction(&difference, domain) {
        let proven = match relation {
            Relation::Different => matches!(sign, Sign::Positive | Sign::Negative),
            Relation::Less => sign == Sign::Negative,
            Relation::AtMost => matches!(sign, Sign::Negative | Sign::Nonpositive),
            Relation::Greater => sign == Sign::Positive,
            Relation::AtLeast => matches!(sign, Sign::Positive | Sign::Nonnegative),
            Relation::Equal => false,
        };
        if proven {
            return Ok(match replayed(&proofs, domain) {
                Ok(steps) => Decision::Proven {
                    evidence: Evidence::Inequality,
                    conditions: witness::nonconstant(difference.conditions().to_vec()),
                    steps,
                },
                Err(error) => Decision::Open {
                    reason: format!("the certificate of sign does not hold: {error}"),
                    tried: vec![],
                },
            });
        }
    }
    if let Some(point) = witness::find(&difference, &[x, y], domain, opposite)
        && let Some(witness) =
            witness::described(&point, std::slice::from_ref(x), std::slice::from_ref(y))
    {
        return Ok(Decision::Refuted(Box::new(Refutation {
            witness,
            // No side of a relation of order is that of an equation.
            sides: None,
            steps: vec!["a point of the domain at which the relation fails".to_owned()],
            evidence: Evidence::Witness,
        })));
    }
    Ok(Decision::Open {
        reason: "the sign of the difference on the domain is not settled".to_owned(),
        tried: vec![
            "Bernstein coefficients on the whole domain".to_owned(),
            "simple points".to_owned(),
        ],
    })
}

/// Vectors have no order; they are different wherever one coordinate is.
fn different(
    relation: Relation,
    left: &[&Quantity],
    right: &[&Quantity],
    domain: &Domain<'_>,
) -> Decision {
    let open = |reason: &str| Decision::Open {
        reason: reason.to_owned(),
        tried: vec![],
    };
    if relation != Relation::Different {
        return open("vectors and matrices have no order");
    }
    let differences: Option<Vec<Fraction>> = left
        .iter()
        .zip(right)
        .map(|(x, y)| x.minus(y).as_fraction().cloned())
        .collect();
    let Some(differences) = differences else {
        return open("a difference of symbolic degree");
    };
    let conditions: Vec<Polynomial> = differences
        .iter()
        .flat_map(|d| d.conditions().to_vec())
        .collect();
    let proofs = differences
        .iter()
        .find_map(|d| match sign_of_fraction(d, domain)? {
            (Sign::Positive | Sign::Negative, proofs) => Some(proofs),
            _ => None,
        });
    if let Some(proofs) = proofs {
        return match replayed(&proofs, domain) {
            Ok(_) => Decision::Proven {
                evidence: Evidence::Inequality,
                conditions: witness::nonconstant(conditions),
                steps: vec![
                    "one coordinate of the difference never vanishes on the domain".to_owned(),
                ],
            },
            Err(error) => open(&format!("the certificate of sign does not hold: {error}")),
        };
    }
    open("no coordinate of the difference is known never to vanish")
}

/// Replays the certificates, and says what they rest on.
fn replayed(proofs: &[Proof], domain: &Domain<'_>) -> Result<Vec<String>, CertificateError> {
    for proof in proofs {
        proof.check(domain)?;
    }
    let certificates = || proofs.iter().flat_map(Proof::certificates);
    let mut steps = vec![];
    if certificates().any(|certificate| certificate.squares.is_empty()) {
        let how = "all Bernstein coefficients of the difference on the domain have the right sign";
        steps.push(how.to_owned());
    }
    if certificates().any(|certificate| !certificate.squares.is_empty()) {
        steps.push("sums of squares are not negative".to_owned());
    }
    let bounded = |symbol: &Symbol| {
        let mut constraints = domain.constraints.iter();
        constraints.any(|c| c.bound_of(symbol).is_some())
    };
    let assumes = proofs.iter().any(|proof| {
        let symbols = proof.polynomial.symbols();
        let mut certificates = proof.certificates().into_iter();
        certificates.any(Certificate::rests_on_assumptions) || symbols.iter().any(bounded)
    });
    if assumes {
        steps.push("the assumptions bound the domain".to_owned());
    }
    let pieces = |p: &Proof| p.certificates().iter().map(|c| c.pieces.len()).sum();
    let pieces = proofs.iter().map(pieces).max();
    if let Some(pieces) = pieces.filter(|n: &usize| *n > 1) {
        steps.push(format!("on each of the {pieces} parts of the domain"));
    }
    Ok(steps)
}

/// A sign of the fraction wherever it is defined on the domain, if one can be proved.
#[must_use]
pub fn of_fraction(value: &Fraction, domain: &Domain<'_>) -> Option<Sign> {
    sign_of_fraction(value, domain).map(|(sign, _)| sign)
}

/// The largest product of numerator and denominator that is examined, in products of terms.
const MAX_PRODUCT: usize = 200;

/// The sign of a fraction, with the proofs: from the signs of its parts, or else from that of the product of numerator
/// and denominator, which is the same wherever there is a fraction.
fn sign_of_fraction(value: &Fraction, domain: &Domain<'_>) -> Option<(Sign, Vec<Proof>)> {
    if let Some(found) = sign_of_parts(value, domain) {
        return Some(found);
    }
    let (above, below) = (value.numerator(), value.denominator());
    if below.as_constant().is_some() || above.len() * below.len() > MAX_PRODUCT {
        return None;
    }
    let (sign, proof) = proof(&(above * &below), domain)?;
    Some((sign, vec![proof]))
}

fn sign_of_parts(value: &Fraction, domain: &Domain<'_>) -> Option<(Sign, Vec<Proof>)> {
    let (above, first) = proof(value.numerator(), domain)?;
    let (mut negative, mut proofs) = (false, vec![first]);
    for (factor, exponent) in value.denominator_factors() {
        let (sign, proof) = proof(factor, domain)?;
        match sign {
            Sign::Positive => {}
            Sign::Negative => negative ^= exponent % 2 == 1,
            _ => return None,
        }
        proofs.push(proof);
    }
    let sign = if negative { above.negated() } else { above };
    Some((sign, proofs))
}
