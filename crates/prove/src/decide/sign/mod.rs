//! Signs of polynomials on the declared domain.
//!
//! In [`coordinates`] that start at zero a polynomial is written in Bernstein form; pi stays and is
//! enclosed. **Theorem.** Bernstein polynomials and powers of t >= 0 are nonnegative and the Bernstein
//! polynomials sum to one, so if all coefficients are nonnegative the polynomial is, and if moreover every
//! face of the box has a positive coefficient it is positive. Assumed inequalities c >= 0 help in three
//! ways: parts of the box where one fails are left out, one that divides the polynomial is split off, and
//! multiples of one are subtracted; of equations multiples of either sign are. What has one variable alone is decided by
//! its real roots ([`line`]). Every proof is a [`certificate`], which is
//! replayed by other means.

mod bernstein;
pub mod certificate;
pub mod coordinates;
mod even;
mod failing_point;
mod farkas;
mod growth;
mod increasing;
mod line;
mod proof;
mod prove;
mod rooted;
mod samples;
mod simple_places;
mod squares;
mod taylor;

use super::domain::Domain;
use super::value::Proof as Whole;
use super::{Decision, Refutation, witness, witness_search};
use crate::evaluate::quantity::Quantity;
use crate::evaluate::value::{UNPLACED, Value};
use certificate::CertificateError;
use torse_algebra::{Fraction, Integer, Polynomial, Symbol, work};
use torse_certificate::identity::{Identity, Vanishing};
use torse_certificate::order::{Excluded, Order};
use torse_certificate::point::Comparison;
use torse_certificate::sign::Sign as Written;
use torse_syntax::fault::Fault;
use torse_syntax::formula::Relation;

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

/// What a search for a sign costs beyond its operations on polynomials, for each term and each constraint, in units of [`work`].
const TERM_WORK: u64 = 250;

/// A sign of the polynomial on the whole domain, if one can be proved this way.
#[must_use]
pub fn sign(polynomial: &Polynomial, domain: &Domain<'_>) -> Option<Sign> {
    proof(polynomial, domain).map(|(sign, _)| sign)
}

/// The same with its certificate.
#[must_use]
pub fn proof(polynomial: &Polynomial, domain: &Domain<'_>) -> Option<(Sign, Proof)> {
    let terms = (polynomial.len() + 1).saturating_mul(domain.constraints.len() + 1);
    work::spend(TERM_WORK.saturating_mul(u64::try_from(terms).unwrap_or(u64::MAX))).ok()?;
    let along = |polynomial: &Polynomial| Proof::of_equations(polynomial, domain);
    without_equations(polynomial, domain)
        .or_else(|| along(polynomial))
        .or_else(|| along(&-polynomial).map(|(sign, proof)| (sign.negated(), proof)))
        .or_else(|| rooted::proof(polynomial, domain))
        .or_else(|| {
            let (sign, proof) = rooted::proof(&-polynomial, domain)?;
            Some((sign.negated(), proof))
        })
        .or_else(|| line::proof(polynomial, domain, &[]))
        .or_else(|| taylor::proof(polynomial, domain))
        .or_else(|| even::proof(polynomial, domain))
        .or_else(|| increasing::proof(polynomial, domain))
}

/// That the polynomial is zero or more, if that can be proved: one that is zero everywhere is zero or less as well.
fn not_negative(polynomial: &Polynomial, domain: &Domain<'_>) -> Option<(Sign, Proof)> {
    match Proof::find(polynomial, domain) {
        Some(proof) if proof.strict() => Some((Sign::Positive, proof)),
        Some(proof) => Some((Sign::Nonnegative, proof)),
        None => Proof::of_equations(polynomial, domain),
    }
}

/// That it is zero or less.
fn not_positive(polynomial: &Polynomial, domain: &Domain<'_>) -> Option<(Sign, Proof)> {
    let (sign, proof) = not_negative(&-polynomial, domain)?;
    Some((sign.negated(), proof))
}

/// The same by inequalities alone.
fn without_equations(polynomial: &Polynomial, domain: &Domain<'_>) -> Option<(Sign, Proof)> {
    let shown = |polynomial: &Polynomial| {
        let proof = Proof::find(polynomial, domain)?;
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

/// What shows that the polynomial is nowhere negative on the domain, replayed.
#[must_use]
pub fn nonnegative(polynomial: &Polynomial, domain: &Domain<'_>) -> Option<Written<Polynomial>> {
    let wanted = |(sign, _): &(Sign, Proof)| matches!(sign, Sign::Positive | Sign::Nonnegative);
    let (_, proof) = proof(polynomial, domain)
        .filter(wanted)
        .or_else(|| not_negative(polynomial, domain))
        .or_else(|| line::not_negative(polynomial, domain, &[]))?;
    proof.check(domain).ok()?;
    proof.written(domain)
}

/// What shows that the polynomial or its negative is positive on the domain, replayed.
#[must_use]
pub fn positive(polynomial: &Polynomial, domain: &Domain<'_>) -> Option<Written<Polynomial>> {
    let (_, proof) = strict(polynomial, domain, &[])?;
    proof.check(domain).ok()?;
    proof.written(domain)
}

/// A sign that is not zero, where these divisors do not vanish.
fn strict(
    polynomial: &Polynomial,
    domain: &Domain<'_>,
    divisors: &[Polynomial],
) -> Option<(Sign, Proof)> {
    let wanted = |(sign, _): &(Sign, Proof)| matches!(sign, Sign::Positive | Sign::Negative);
    proof(polynomial, domain)
        .filter(wanted)
        .or_else(|| line::strict(polynomial, domain, divisors))
}

/// Whether the polynomial never vanishes on the domain, by a sign whose certificate is replayed, or because no integers
/// make it zero.
#[must_use]
pub fn never_zero(polynomial: &Polynomial, domain: &Domain<'_>) -> bool {
    no_integers_solve(polynomial, domain)
        || strict(polynomial, domain, &[]).is_some_and(|(_, proof)| proof.check(domain).is_ok())
        || positive_square(polynomial, domain).is_some()
}

/// The most terms of a polynomial whose square is examined.
const MAX_SQUARED: usize = 3;

/// What shows that the square of the polynomial is positive on the domain, replayed: it differs from zero on both sides of it.
#[must_use]
pub fn positive_square(
    polynomial: &Polynomial,
    domain: &Domain<'_>,
) -> Option<Written<Polynomial>> {
    if polynomial.len() > MAX_SQUARED || domain.constraints.is_empty() {
        return None;
    }
    let proof = Proof::find(&polynomial.power(2), domain).filter(Proof::strict)?;
    proof.check(domain).ok()?;
    proof.written(domain)
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
            UNPLACED,
            "an order relation of symbolic degree",
        ));
    };
    let difference = x.clone() - y.clone();
    let opposite = relation.opposite();
    let divisors = || witness::nonconstant(difference.conditions().to_vec());
    if relation == Relation::Different
        && domain.pivots().is_empty()
        && domain.assumes_nonzero(difference.numerator())
    {
        return Ok(Decision::Proven(Whole::Excluded(Excluded {
            numerator: difference.numerator().clone(),
            divisors: divisors(),
        })));
    }
    if difference.is_zero() && matches!(relation, Relation::AtMost | Relation::AtLeast) {
        return Ok(Decision::Proven(Whole::Identity(Identity {
            by: Vanishing::NormalForm,
            in_order: true,
            divisors: divisors(),
        })));
    }
    // What is nowhere negative may be nowhere positive either.
    let other = |turned: fn(&Polynomial, &Domain<'_>) -> Option<(Sign, Proof)>| {
        let above = turned(difference.numerator(), domain)?;
        with_denominator(above, &difference, domain)
    };
    let one = || sign_of_fraction(&difference, domain);
    let by_line = || {
        let (above, below) = (difference.numerator(), difference.denominator());
        let divisors = difference.conditions();
        line::proof(above, domain, divisors)
            .and_then(|above| with_denominator(above, &difference, domain))
            .or_else(|| {
                let (sign, proof) = line::proof(&(above * &below), domain, divisors)?;
                Some(Found {
                    sign,
                    product: true,
                    proofs: vec![proof],
                })
            })
    };
    let tried: [&dyn Fn() -> Option<Found>; 4] = [
        &one,
        &|| other(not_negative),
        &|| other(not_positive),
        &by_line,
    ];
    for found in tried.iter().filter_map(|try_one| try_one()) {
        let sign = found.sign;
        let proven = match relation {
            Relation::Different => matches!(sign, Sign::Positive | Sign::Negative),
            Relation::Less => sign == Sign::Negative,
            Relation::AtMost => matches!(sign, Sign::Negative | Sign::Nonpositive),
            Relation::Greater => sign == Sign::Positive,
            Relation::AtLeast => matches!(sign, Sign::Positive | Sign::Nonnegative),
            Relation::Equal => false,
        };
        if proven {
            return Ok(ordered(
                relation,
                (0, false),
                &difference,
                &found,
                divisors(),
                domain,
            ));
        }
    }
    if let Some(point) = witness_search::find(&difference, &[x, y], domain, opposite)
        .or_else(|| failing_point::find(&difference, &[x, y], domain, opposite))
        && let Some(point) = witness::described(
            &point,
            Comparison::Order,
            std::slice::from_ref(x),
            std::slice::from_ref(y),
        )
    {
        // No side of a relation of order is that of an equation.
        return Ok(Decision::Refuted(Box::new(Refutation::at(point))));
    }
    Ok(Decision::open(
        "the sign of the difference on the domain is not settled",
        &[
            "Bernstein coefficients on the whole domain",
            "simple points",
        ],
    ))
}

/// Vectors have no order; they are different wherever one coordinate is.
fn different(
    relation: Relation,
    left: &[&Quantity],
    right: &[&Quantity],
    domain: &Domain<'_>,
) -> Decision {
    let open = |reason: &str| Decision::open(reason, &[]);
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
    let found = differences.iter().enumerate().find_map(|(entry, d)| {
        let found = sign_of_fraction(d, domain)?;
        matches!(found.sign, Sign::Positive | Sign::Negative).then_some((entry, d, found))
    });
    if let Some((entry, difference, found)) = found {
        let divisors = witness::nonconstant(conditions);
        let entry = (entry, true);
        return ordered(relation, entry, difference, &found, divisors, domain);
    }
    open("no coordinate of the difference is known never to vanish")
}

/// A relation proved by signs, whose certificates are replayed; the entry of the sides, and whether there are more.
fn ordered(
    relation: Relation,
    (entry, of_many): (usize, bool),
    difference: &Fraction,
    found: &Found,
    divisors: Vec<Polynomial>,
    domain: &Domain<'_>,
) -> Decision {
    let signs = match replayed(&found.proofs, domain) {
        Ok(signs) => signs,
        Err(error) => {
            return Decision::open(
                format!("the certificate of sign does not hold: {error}"),
                &[],
            );
        }
    };
    let bounded = |symbol: &Symbol| {
        let mut constraints = domain.constraints.iter();
        constraints.any(|c| c.bound_of(symbol).is_some())
    };
    let mut symbols = found.proofs.iter().flat_map(|p| p.polynomial.symbols());
    let below = difference.denominator_factors();
    Decision::Proven(Whole::Order(Box::new(Order {
        relation,
        entry,
        of_many,
        above: difference.numerator().clone(),
        below: below.map(|(p, e)| (p.clone(), e)).collect(),
        product: found.product,
        signs,
        divisors,
        bounded_by_assumptions: symbols.any(bounded),
    })))
}

/// Replays the certificates, and writes them as parts of a proof.
fn replayed(
    proofs: &[Proof],
    domain: &Domain<'_>,
) -> Result<Vec<Written<Polynomial>>, CertificateError> {
    let written = |proof: &Proof| {
        proof.check(domain)?;
        proof.written(domain).ok_or(CertificateError::Domain)
    };
    proofs.iter().map(written).collect()
}

/// The sign of a fraction.
struct Found {
    sign: Sign,
    /// Whether it is that of the product of numerator and denominator.
    product: bool,
    proofs: Vec<Proof>,
}

/// The largest product of numerator and denominator that is examined, in products of terms.
const MAX_PRODUCT: usize = 200;

/// The sign of a fraction, with the proofs: from the signs of its parts, or else from that of the product of numerator
/// and denominator, which is the same wherever there is a fraction.
fn sign_of_fraction(value: &Fraction, domain: &Domain<'_>) -> Option<Found> {
    if let Some(found) = sign_of_parts(value, domain) {
        return Some(found);
    }
    let (above, below) = (value.numerator(), value.denominator());
    if below.as_constant().is_some() || above.len() * below.len() > MAX_PRODUCT {
        return None;
    }
    let (sign, proof) = proof(&(above * &below), domain)?;
    Some(Found {
        sign,
        product: true,
        proofs: vec![proof],
    })
}

fn sign_of_parts(value: &Fraction, domain: &Domain<'_>) -> Option<Found> {
    with_denominator(proof(value.numerator(), domain)?, value, domain)
}

/// The sign of a fraction from that of its numerator.
fn with_denominator(
    (above, first): (Sign, Proof),
    value: &Fraction,
    domain: &Domain<'_>,
) -> Option<Found> {
    let (mut negative, mut proofs) = (false, vec![first]);
    for (factor, exponent) in value.denominator_factors() {
        // Where there is a fraction its divisors are not zero.
        let divides = || value.conditions().contains(factor);
        let (sign, proof) = strict(factor, domain, value.conditions())
            .or_else(|| divides().then(|| proof(factor, domain)).flatten())?;
        negative ^= matches!(sign, Sign::Negative | Sign::Nonpositive) && exponent % 2 == 1;
        proofs.push(proof);
    }
    let sign = if negative { above.negated() } else { above };
    Some(Found {
        sign,
        product: false,
        proofs,
    })
}
