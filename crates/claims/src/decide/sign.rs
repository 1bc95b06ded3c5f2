//! Signs of polynomials on the declared domain.
//!
//! A bounded symbol is written v = a + (b - a) t with t in `[0, 1]` and the polynomial in Bernstein form in
//! t; a symbol with one bound is written v = a + t with t >= 0; pi stays and is enclosed. **Theorem.**
//! Bernstein polynomials and powers of t are nonnegative and the Bernstein polynomials sum to one, so if
//! all coefficients are nonnegative the polynomial is, and if moreover every Bernstein coefficient has a
//! positive constant term it is positive. Sine and cosine of a quarter turn become rational functions of
//! the tangent of the half angle.

use super::domain::{Domain, truth};
use super::{Decision, Refutation, witness};
use crate::evaluate::fault::Fault;
use crate::evaluate::quantity::Quantity;
use crate::evaluate::scope::{Bound, Interval};
use crate::evaluate::value::{NOWHERE, Value};
use crate::outcome::Evidence;
use crate::syntax::Relation;
use torse_algebra::rational::integer;
use torse_algebra::{Fraction, Polynomial, Rational, Scalar as _, Symbol};

/// The most Bernstein coefficients computed.
const MAX_PIECES: usize = 20_000;
/// How often a nonnegative box is halved to prove it positive.
const STRICT_DEPTH: u32 = 3;
/// The most boxes examined.
const MAX_BOXES: usize = 200;

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

/// A sign of the polynomial on the whole domain, if one can be proved this way.
#[must_use]
pub fn of(polynomial: &Polynomial, domain: &Domain<'_>) -> Option<Sign> {
    match (
        one_sided(polynomial, domain),
        one_sided(&-polynomial, domain),
    ) {
        (Some(true), _) => Some(Sign::Positive),
        (_, Some(true)) => Some(Sign::Negative),
        (Some(false), _) => Some(Sign::Nonnegative),
        (_, Some(false)) => Some(Sign::Nonpositive),
        (None, None) => None,
    }
}

/// Whether the polynomial never vanishes on the domain, by its sign.
#[must_use]
pub fn never_zero(polynomial: &Polynomial, domain: &Domain<'_>) -> bool {
    matches!(
        of(polynomial, domain),
        Some(Sign::Positive | Sign::Negative)
    )
}

/// `Some(true)` for positive, `Some(false)` for nonnegative, `None` for not proved.
fn one_sided(polynomial: &Polynomial, domain: &Domain<'_>) -> Option<bool> {
    // Single symbols that are positive themselves are split off first.
    let mut rest = polynomial.clone();
    let mut strict = true;
    for symbol in polynomial.symbols() {
        let interval = domain.interval(symbol);
        let Some(lower) = &interval.lower else {
            continue;
        };
        if truth(&lower.value, Relation::AtLeast) != Some(true) {
            continue;
        }
        let factor = Polynomial::symbol(symbol.clone());
        while let Some(quotient) = rest.exact_quotient(&factor) {
            strict &= truth(&lower.value, Relation::Greater) == Some(true) || !lower.closed;
            rest = quotient;
        }
    }
    let (rest, mut boxes) = half_angles(&rest, domain)?;
    let known: Vec<Symbol> = boxes.iter().map(|(s, _)| s.clone()).collect();
    boxes.extend(
        rest.symbols()
            .iter()
            .filter(|s| !matches!(s, Symbol::Pi | Symbol::Root(_)) && !known.contains(s))
            .map(|s| (s.clone(), domain.interval(s))),
    );
    let mut budget = MAX_BOXES;
    subdivided(&rest, &boxes, 0, &mut budget).map(|positive| strict && positive)
}

/// Writes sine and cosine of a quarter turn as rational functions of the tangent t of half the angle,
/// s = 2t/(1 + t^2), c = (1 - t^2)/(1 + t^2), and multiplies by the positive denominator: the same sign,
/// with t in `[0, 1]` for a variable of `[0, 1]`. A variable that also stands outside keeps its own range.
fn half_angles(
    polynomial: &Polynomial,
    domain: &Domain<'_>,
) -> Option<(Polynomial, Vec<(Symbol, Interval)>)> {
    let mut value = Fraction::from(polynomial.clone());
    let mut boxes = vec![];
    for symbol in polynomial.symbols() {
        let (Symbol::Cos(name, angle) | Symbol::Sin(name, angle)) = symbol else {
            continue;
        };
        let half = Symbol::named(&format!("{name}\u{bd}"));
        if boxes
            .iter()
            .any(|(known, _): &(Symbol, Interval)| *known == half)
        {
            continue;
        }
        let unit = domain.interval(&Symbol::Cos(name.clone(), *angle));
        let quarter = unit.lower.as_ref().is_some_and(|b| b.value.is_zero());
        if !quarter {
            continue;
        }
        let t = Fraction::symbol(half.clone());
        let one = Fraction::integer(1);
        let below = one.clone() + t.clone() * t.clone();
        let sine = t.scaled(&integer(2)).over(&below).ok()?;
        let cosine = (one - t.clone() * t).over(&below).ok()?;
        value = value
            .substituted(|s| match s {
                Symbol::Sin(n, a) if n == name && a == angle => Some(sine.clone()),
                Symbol::Cos(n, a) if n == name && a == angle => Some(cosine.clone()),
                _ => None,
            })
            .ok()?;
        boxes.push((half, unit));
    }
    Some((value.numerator().clone(), boxes))
}

/// The sign on a box, by halving bounded symbols where the coefficients of the whole box do not tell.
fn subdivided(
    polynomial: &Polynomial,
    boxes: &[(Symbol, Interval)],
    depth: u32,
    budget: &mut usize,
) -> Option<bool> {
    *budget = budget.checked_sub(1)?;
    let whole = on_box(polynomial, boxes);
    // A box that is known to be nonnegative is halved a few times only in search of strictness: a zero
    // of the polynomial would use up all boxes.
    if whole == Some(true) || (whole == Some(false) && depth >= STRICT_DEPTH) {
        return whole;
    }
    // The symbol of the highest degree that can be halved.
    let widest = boxes
        .iter()
        .enumerate()
        .filter(|(_, (_, interval))| interval.lower.is_some() && interval.upper.is_some())
        .max_by_key(|(position, (symbol, _))| {
            (polynomial.degree_in(symbol), std::cmp::Reverse(*position))
        });
    let halves = widest
        .filter(|(_, (symbol, _))| polynomial.degree_in(symbol) > 1)
        .and_then(|(position, (symbol, interval))| {
            let (lower, upper) = (interval.lower.clone()?, interval.upper.clone()?);
            let middle = (lower.value.clone() + upper.value.clone())
                .scaled(&Rational::new(1.into(), 2.into()));
            let middle = Bound {
                value: middle,
                closed: true,
            };
            let with = |lower, upper| {
                let mut boxes = boxes.to_vec();
                if let Some(slot) = boxes.get_mut(position) {
                    *slot = (
                        symbol.clone(),
                        Interval {
                            lower: Some(lower),
                            upper: Some(upper),
                        },
                    );
                }
                boxes
            };
            Some([with(lower, middle.clone()), with(middle, upper)])
        });
    let Some([left, right]) = halves else {
        return whole;
    };
    match (
        subdivided(polynomial, &left, depth + 1, budget),
        subdivided(polynomial, &right, depth + 1, budget),
    ) {
        (Some(a), Some(b)) => Some(a && b),
        _ => whole,
    }
}

/// The sign from the coefficients on one box. A polynomial with nonnegative coefficients is positive if on
/// every face of the box that belongs to it some coefficient is positive: the Bernstein polynomials of a
/// face are positive inside it.
fn on_box(polynomial: &Polynomial, boxes: &[(Symbol, Interval)]) -> Option<bool> {
    let mut pieces = vec![Fraction::from(polynomial.clone())];
    let mut faces: Vec<Vec<Face>> = vec![];
    let mut rays_open = true;
    for (symbol, interval) in boxes {
        let before = pieces.len();
        pieces = split(pieces, symbol, interval)?;
        if pieces.len() > MAX_PIECES {
            return None;
        }
        if interval.lower.is_some() && interval.upper.is_some() {
            let count = pieces.len() / before.max(1);
            let closed = |bound: &Option<Bound>| bound.as_ref().is_some_and(|b| b.closed);
            let mut own = vec![Face {
                first: 0,
                last: count,
            }];
            if closed(&interval.lower) {
                own.push(Face { first: 0, last: 1 });
            }
            if closed(&interval.upper) {
                own.push(Face {
                    first: count.saturating_sub(1),
                    last: count,
                });
            }
            faces.push(own);
        } else {
            rays_open &= [&interval.lower, &interval.upper]
                .into_iter()
                .flatten()
                .all(|b| !b.closed);
        }
    }
    let mut positive = vec![];
    for piece in &pieces {
        let sign = ray_sign(piece.as_polynomial()?)?;
        if !sign.nonnegative {
            return None;
        }
        positive.push(if rays_open {
            sign.somewhere
        } else {
            sign.constant
        });
    }
    Some(every_face_positive(&positive, &faces))
}

/// A range of Bernstein indices of one symbol.
#[derive(Clone, Copy)]
struct Face {
    first: usize,
    last: usize,
}

/// Whether every choice of one face a symbol contains a positive entry. The entries are in row-major
/// order: the last symbol varies fastest.
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

/// Writes every piece in the Bernstein form of a bounded symbol, or shifts a symbol with one bound.
fn split(pieces: Vec<Fraction>, symbol: &Symbol, interval: &Interval) -> Option<Vec<Fraction>> {
    let variable = Fraction::symbol(symbol.clone());
    let (value, bounded) = match (interval.lower.clone(), interval.upper.clone()) {
        (Some(a), Some(b)) => (a.value.clone() + variable * (b.value - a.value), true),
        (Some(a), None) => (a.value + variable, false),
        (None, Some(b)) => (b.value - variable, false),
        (None, None) => return None,
    };
    let mut result = vec![];
    for piece in pieces {
        let moved = piece
            .substituted(|s| (s == symbol).then(|| value.clone()))
            .ok()?;
        let polynomial = moved.as_polynomial()?;
        if !bounded {
            result.push(moved);
            continue;
        }
        let coefficients = polynomial.coefficients_in(symbol);
        let degree = coefficients.len().saturating_sub(1);
        for j in 0..=degree {
            // b_j = sum over i <= j of binom(j, i) / binom(degree, i) c_i
            let entry = coefficients
                .iter()
                .take(j + 1)
                .enumerate()
                .fold(Polynomial::zero(), |sum, (i, c)| {
                    &sum + &c.scaled(&(binomial(j, i) / binomial(degree, i)))
                });
            result.push(entry.into());
        }
    }
    Some(result)
}

fn binomial(n: usize, k: usize) -> Rational {
    (0..k).fold(integer(1), |product, i| {
        let (top, below) = (
            i64::try_from(n - i).unwrap_or(i64::MAX),
            i64::try_from(i + 1).unwrap_or(i64::MAX),
        );
        product * integer(top) / integer(below)
    })
}

/// What the coefficients of a polynomial in nonnegative symbols, pi and roots tell.
struct RaySign {
    /// Every coefficient is nonnegative.
    nonnegative: bool,
    /// The constant one is positive.
    constant: bool,
    /// Some coefficient is positive.
    somewhere: bool,
}

fn ray_sign(polynomial: &Polynomial) -> Option<RaySign> {
    use std::collections::BTreeMap;
    // Group by the powers of the nonnegative symbols; the coefficients are numbers.
    let mut groups: BTreeMap<Polynomial, Polynomial> = BTreeMap::new();
    for term in polynomial.terms() {
        let (mut powers, mut number) = (
            Polynomial::integer(1),
            Polynomial::constant(&term.coefficient),
        );
        for (symbol, exponent) in term.powers {
            let power = Polynomial::symbol(symbol.clone()).power(u32::from(exponent));
            if matches!(symbol, Symbol::Pi | Symbol::Root(_)) {
                number = &number * &power;
            } else {
                powers = &powers * &power;
            }
        }
        let entry = groups.entry(powers).or_insert_with(Polynomial::zero);
        *entry = &*entry + &number;
    }
    let mut sign = RaySign {
        nonnegative: true,
        constant: false,
        somewhere: false,
    };
    for (powers, number) in groups {
        let number = Fraction::from(number);
        sign.nonnegative &= truth(&number, Relation::AtLeast)?;
        let positive = truth(&number, Relation::Greater)?;
        sign.somewhere |= positive;
        sign.constant |= positive && powers.is_one();
    }
    Some(sign)
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
    let opposite = match relation {
        Relation::Equal => Relation::Different,
        Relation::Different => Relation::Equal,
        Relation::Less => Relation::AtLeast,
        Relation::AtMost => Relation::Greater,
        Relation::Greater => Relation::AtMost,
        Relation::AtLeast => Relation::Less,
    };
    if difference.is_zero() && matches!(relation, Relation::AtMost | Relation::AtLeast) {
        return Ok(Decision::identity(
            witness::nonconstant(difference.conditions().to_vec()),
            "both sides are equal identically".to_owned(),
        ));
    }
    if let Some(sign) = sign_of_fraction(&difference, domain) {
        let proven = match relation {
            Relation::Different => matches!(sign, Sign::Positive | Sign::Negative),
            Relation::Less => sign == Sign::Negative,
            Relation::AtMost => matches!(sign, Sign::Negative | Sign::Nonpositive),
            Relation::Greater => sign == Sign::Positive,
            Relation::AtLeast => matches!(sign, Sign::Positive | Sign::Nonnegative),
            Relation::Equal => false,
        };
        if proven {
            return Ok(Decision::Proven {
                evidence: Evidence::Inequality,
                conditions: witness::nonconstant(difference.conditions().to_vec()),
                steps: vec!["all Bernstein coefficients of the difference on the domain have the right sign".to_owned()],
            });
        }
    }
    if let Some(point) = witness::find(&difference, domain, opposite)
        && let Some(witness) =
            witness::described(&point, std::slice::from_ref(x), std::slice::from_ref(y))
    {
        return Ok(Decision::Refuted(Box::new(Refutation {
            witness,
            sides: Some((vec![x.clone()], vec![y.clone()])),
            steps: vec!["a point of the domain at which the relation fails".to_owned()],
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
    let never_equal = left.iter().zip(right).any(|(x, y)| {
        let difference = x.minus(y);
        let sign = difference
            .as_fraction()
            .and_then(|d| sign_of_fraction(d, domain));
        matches!(sign, Some(Sign::Positive | Sign::Negative))
    });
    if never_equal {
        return Decision::Proven {
            evidence: Evidence::Inequality,
            conditions: vec![],
            steps: vec!["one coordinate of the difference never vanishes on the domain".to_owned()],
        };
    }
    open("no coordinate of the difference is known never to vanish")
}

/// The sign of a fraction from the signs of its parts.
fn sign_of_fraction(value: &Fraction, domain: &Domain<'_>) -> Option<Sign> {
    let above = of(value.numerator(), domain)?;
    let mut negative = false;
    for (factor, exponent) in value.denominator_factors() {
        match of(factor, domain)? {
            Sign::Positive => {}
            Sign::Negative => negative ^= exponent % 2 == 1,
            _ => return None,
        }
    }
    Some(match (above, negative) {
        (sign, false) => sign,
        (Sign::Positive, true) => Sign::Negative,
        (Sign::Negative, true) => Sign::Positive,
        (Sign::Nonnegative, true) => Sign::Nonpositive,
        (Sign::Nonpositive, true) => Sign::Nonnegative,
    })
}
