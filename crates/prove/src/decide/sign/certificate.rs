//! What a proof of sign leaves behind, and a checker that replays it.
//!
//! A [`Certificate`] that p >= 0 (or p > 0) on a domain says
//!
//! `p = d_1 q_1^2 + ... + m_1 c_1 + m_2 c_2 + ... + f_1 f_2 ... r`
//!
//! with numbers d_i >= 0, assumed c_i >= 0, numbers m_i >= 0 and factors f_i >= 0 (symbols that are not negative,
//! assumptions again, and squares), and pieces that fill the box of the domain; on each piece the Bernstein
//! coefficients show r to be nonnegative, or an assumption to fail.
//!
//! [`check`] shares the coordinates with the prover and nothing else: it multiplies the equation out,
//! verifies that the pieces fill the box, and takes every coefficient from the polar form (Ramshaw 1987):
//! the Bernstein coefficient of index j and degree d of `t^e` on `[a, b]` is the elementary symmetric
//! polynomial of degree e in d - j arguments a and j arguments b, divided by `C(d, e)`.

use super::bernstein::spend_on_rationals;
use super::coordinates::{Coordinates, Region};
use crate::decide::domain::{Constraint, Domain};
use crate::decide::order::truth;
use crate::decide::value::plain_symbol;
use std::collections::BTreeMap;
use torse_algebra::fault_injection::{InjectedFault, injected};
use torse_algebra::rational::integer;
use torse_algebra::rational_box::RationalBox;
use torse_algebra::{Fraction, Polynomial, Rational, Symbol};
use torse_certificate::sign as written;
use torse_syntax::formula::Relation;

/// A quantity that is not negative on the domain.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Factor {
    /// A symbol whose range begins at zero or later.
    Symbol(Symbol),
    /// The assumption of this number, see [`assumed`].
    Assumed(usize),
    /// The square of this polynomial.
    Square(Polynomial),
}

/// Why nothing more is to be shown on a piece.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reason {
    /// The coefficients of the rest are nonnegative.
    Coefficients,
    /// The assumption of this number fails.
    Outside(usize),
}

/// A part of the box.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Piece {
    /// Where.
    pub region: Region,
    /// Why.
    pub reason: Reason,
}

/// A proof of sign.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Certificate {
    /// Whether more than zero is claimed, rather than zero or more.
    pub strict: bool,
    /// Polynomials, and what their squares are multiplied with.
    pub squares: Vec<(Rational, Polynomial)>,
    /// Assumptions by number, and what they are multiplied with.
    pub multipliers: Vec<(usize, Rational)>,
    /// Factors that are split off.
    pub factors: Vec<Factor>,
    /// What remains.
    pub rest: Polynomial,
    /// Parts that fill the box.
    pub pieces: Vec<Piece>,
}

/// Why a certificate proves nothing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum CertificateError {
    /// The equation between the polynomial and its parts is wrong.
    #[error("the parts do not make up the polynomial")]
    Equation,
    /// A factor or multiplier may be negative.
    #[error("part {part} may be negative")]
    Part {
        /// Its number, factors after multipliers, those of squares first.
        part: usize,
    },
    /// The domain has no such coordinates.
    #[error("the domain is not bounded as the pieces need it")]
    Domain,
    /// The pieces do not fill the box.
    #[error("the {pieces} pieces do not fill the box")]
    NotFilled {
        /// How many there are.
        pieces: usize,
    },
    /// A coefficient has the wrong sign.
    #[error("a coefficient on piece {piece} has the wrong sign")]
    Coefficient {
        /// The number of the piece.
        piece: usize,
    },
    /// Nothing shows the polynomial to differ from zero.
    #[error("zero is not excluded")]
    Zero,
}

/// The assumptions as polynomials that are not negative, with `true` for those that are positive.
#[must_use]
pub fn assumed(domain: &Domain<'_>) -> Vec<(Polynomial, bool)> {
    let oriented = domain.constraints.iter().filter_map(|c| {
        // The product with the denominator has the sign of the quotient.
        let mut product = c.value.numerator() * &c.value.denominator();
        if injected(InjectedFault::AssumptionReversed) {
            product = -product;
        }
        match c.relation {
            Relation::Greater => Some((product, true)),
            Relation::AtLeast => Some((product, false)),
            Relation::Less => Some((-product, true)),
            Relation::AtMost => Some((-product, false)),
            Relation::Equal | Relation::Different => None,
        }
    });
    oriented.collect()
}

/// The places, among all constraints, of those that [`assumed`] lists.
fn places(domain: &Domain<'_>) -> Vec<usize> {
    let numbered = domain.constraints.iter().enumerate();
    let oriented = |(_, c): &(usize, &Constraint)| {
        !matches!(c.relation, Relation::Equal | Relation::Different)
    };
    numbered.filter(oriented).map(|(place, _)| place).collect()
}

/// A certificate as part of a proof, with its coordinates.
pub(super) fn written(
    domain: &Domain<'_>,
    certificate: &Certificate,
) -> Option<written::Certificate<Polynomial>> {
    let (assumed, places) = (assumed(domain), places(domain));
    let place = |number: usize| places.get(number).copied();
    let mut all = vec![&certificate.rest];
    for piece in &certificate.pieces {
        if let Reason::Outside(number) = piece.reason {
            all.push(&assumed.get(number)?.0);
        }
    }
    let (_, coordinates) = Coordinates::new(&all, domain)?;
    let square = |(multiple, root): &(Rational, Polynomial)| written::Square {
        multiple: multiple.clone(),
        root: root.clone(),
    };
    let multiple = |(number, multiple): &(usize, Rational)| {
        Some(written::Multiple {
            constraint: place(*number)?,
            multiple: multiple.clone(),
        })
    };
    let factor = |factor: &Factor| {
        Some(match factor {
            Factor::Symbol(symbol) => written::Factor::Symbol(plain_symbol(symbol)),
            Factor::Assumed(number) => written::Factor::Constraint(place(*number)?),
            Factor::Square(root) => written::Factor::Square(root.clone()),
        })
    };
    let piece = |piece: &Piece| {
        let outside = match piece.reason {
            Reason::Coefficients => None,
            Reason::Outside(number) => Some(place(number)?),
        };
        Some(written::Piece {
            region: piece.region.clone(),
            outside,
        })
    };
    Some(written::Certificate {
        strict: certificate.strict,
        squares: certificate.squares.iter().map(square).collect(),
        multiples: certificate
            .multipliers
            .iter()
            .map(multiple)
            .collect::<Option<_>>()?,
        factors: certificate
            .factors
            .iter()
            .map(factor)
            .collect::<Option<_>>()?,
        rest: certificate.rest.clone(),
        coordinates: coordinates.written,
        pieces: certificate
            .pieces
            .iter()
            .map(piece)
            .collect::<Option<_>>()?,
    })
}

/// Replays a certificate about a polynomial.
///
/// # Errors
/// [`CertificateError`] says where it fails.
pub fn check(
    polynomial: &Polynomial,
    domain: &Domain<'_>,
    certificate: &Certificate,
) -> Result<(), CertificateError> {
    let assumed = assumed(domain);
    let (mut total, mut product) = (Polynomial::zero(), certificate.rest.clone());
    let (mut sum_positive, mut factors_positive) = (false, true);
    for (part, (multiplier, root)) in certificate.squares.iter().enumerate() {
        if *multiplier < integer(0) {
            return Err(CertificateError::Part { part });
        }
        total = &total + &root.power(2).scaled(multiplier);
    }
    let squared = certificate.squares.iter();
    let squared = squared.filter(|(multiplier, _)| *multiplier > integer(0));
    let roots: Vec<&Polynomial> = squared.map(|(_, root)| root).collect();
    sum_positive |= certificate.strict && domain.excludes_common_zero(&roots);
    let squares = certificate.squares.len();
    for (place, (number, multiplier)) in certificate.multipliers.iter().enumerate() {
        let part = squares + place;
        let wrong = CertificateError::Part { part };
        let (value, strict) = assumed.get(*number).ok_or(wrong)?;
        if *multiplier < integer(0) {
            return Err(wrong);
        }
        sum_positive |= *strict && *multiplier > integer(0);
        total = &total + &value.scaled(multiplier);
    }
    for (place, factor) in certificate.factors.iter().enumerate() {
        let part = squares + certificate.multipliers.len() + place;
        let wrong = CertificateError::Part { part };
        let (value, strict) = match factor {
            Factor::Symbol(symbol) => {
                let lower = domain.interval(symbol).lower.ok_or(wrong)?;
                if truth(&lower.value, Relation::AtLeast) != Some(true) {
                    return Err(wrong);
                }
                let positive = truth(&lower.value, Relation::Greater) == Some(true);
                (
                    Polynomial::symbol(symbol.clone()),
                    positive || !lower.closed,
                )
            }
            Factor::Assumed(number) => assumed.get(*number).cloned().ok_or(wrong)?,
            Factor::Square(root) => (root.power(2), false),
        };
        factors_positive &= strict;
        product = &product * &value;
    }
    if &total + &product != *polynomial {
        return Err(CertificateError::Equation);
    }
    let rest_positive = check_pieces(certificate, domain, &assumed)?;
    if certificate.strict && !sum_positive && !(factors_positive && rest_positive) {
        return Err(CertificateError::Zero);
    }
    Ok(())
}

/// Checks the pieces; whether they show the rest to be positive.
fn check_pieces(
    certificate: &Certificate,
    domain: &Domain<'_>,
    assumed: &[(Polynomial, bool)],
) -> Result<bool, CertificateError> {
    let mut all = vec![&certificate.rest];
    let mut numbers = vec![];
    for piece in &certificate.pieces {
        if let Reason::Outside(number) = piece.reason
            && !numbers.contains(&number)
        {
            all.push(&assumed.get(number).ok_or(CertificateError::Domain)?.0);
            numbers.push(number);
        }
    }
    let (moved, coordinates) = Coordinates::new(&all, domain).ok_or(CertificateError::Domain)?;
    let pieces = certificate.pieces.len();
    if !fills(&certificate.pieces, coordinates.sides.len()) {
        return Err(CertificateError::NotFilled { pieces });
    }
    let mut positive = true;
    for (number, piece) in certificate.pieces.iter().enumerate() {
        let wrong = CertificateError::Coefficient { piece: number };
        let (polynomial, strict) = match piece.reason {
            Reason::Coefficients => (moved.first().cloned().ok_or(wrong)?, None),
            Reason::Outside(which) => {
                let place = numbers.iter().position(|n| *n == which).ok_or(wrong)?;
                let value = moved.get(place + 1).ok_or(wrong)?;
                (-value, assumed.get(which).map(|(_, strict)| *strict))
            }
        };
        let shown = coefficients(&polynomial, &coordinates, &piece.region).ok_or(wrong)?;
        let excludes_zero = excludes_zero(&shown, &coordinates, &piece.region);
        match strict {
            None => positive &= excludes_zero,
            // c > 0 fails where -c >= 0, c >= 0 only where -c > 0.
            Some(strict) if !strict && !excludes_zero => return Err(wrong),
            Some(_) => {}
        }
    }
    Ok(positive)
}

fn fills(pieces: &[Piece], dimension: usize) -> bool {
    if dimension == 0 {
        return pieces.len() == 1;
    }
    let boxes: Option<Vec<RationalBox>> = pieces
        .iter()
        .map(|piece| RationalBox::new(piece.region.clone()).ok())
        .collect();
    let whole = RationalBox::unit(dimension).ok();
    match (whole, boxes) {
        (Some(whole), Some(boxes)) => whole.is_filled_by(&boxes.iter().collect::<Vec<_>>()),
        _ => false,
    }
}

/// The multi-indices of coefficients that are positive, with the degrees; `None` if one is negative.
type Shown = (Vec<usize>, Vec<Vec<usize>>);

fn coefficients(
    polynomial: &Polynomial,
    coordinates: &Coordinates,
    region: &Region,
) -> Option<Shown> {
    let sides = || coordinates.sides.iter();
    let degrees: Vec<usize> = sides()
        .map(|side| usize::from(polynomial.degree_in(&side.symbol)))
        .collect();
    // The square of a degree for each index, and each term for all of them.
    for d in &degrees {
        spend_on_rationals(&[*d, *d, *d, 1 + d / 16]).ok()?;
    }
    let count = degrees.iter().fold(1_usize, |n, d| n.saturating_mul(d + 1));
    spend_on_rationals(&[count, polynomial.len(), degrees.len() + 1]).ok()?;
    // polar[side][index][exponent]
    let polar: Vec<Vec<Vec<Rational>>> = degrees
        .iter()
        .zip(region)
        .map(|(&d, ends)| (0..=d).map(|j| polar_forms(ends, d, j)).collect())
        .collect();
    let mut positive = vec![];
    let mut index = vec![0; degrees.len()];
    loop {
        // By powers of the unbounded coordinates, which are not negative.
        let mut groups: BTreeMap<Polynomial, Polynomial> = BTreeMap::new();
        for term in polynomial.terms() {
            let mut weight = term.coefficient.clone();
            let mut exponents = vec![0; degrees.len()];
            let (mut number, mut ray) = (Polynomial::integer(1), Polynomial::integer(1));
            for (symbol, exponent) in term.powers {
                let power = || Polynomial::symbol(symbol.clone()).power(u32::from(exponent));
                if let Some(side) = sides().position(|s| s.symbol == *symbol) {
                    *exponents.get_mut(side)? = usize::from(exponent);
                } else if symbol.is_number() {
                    number = &number * &power();
                } else {
                    ray = &ray * &power();
                }
            }
            for ((forms, j), e) in polar.iter().zip(&index).zip(exponents) {
                weight *= forms.get(*j)?.get(e)?;
            }
            let slot = groups.entry(ray).or_insert_with(Polynomial::zero);
            *slot = &*slot + &number.scaled(&weight);
        }
        let mut excludes_zero = false;
        for (ray, number) in groups {
            let number = Fraction::from(number);
            if truth(&number, Relation::AtLeast) != Some(true) {
                return None;
            }
            excludes_zero |= !number.is_zero() && coordinates.excludes_zero(&ray);
        }
        if excludes_zero {
            positive.push(index.clone());
        }
        let Some(place) = index.iter().zip(&degrees).rposition(|(j, d)| j < d) else {
            return Some((degrees, positive));
        };
        *index.get_mut(place)? += 1;
        index.iter_mut().skip(place + 1).for_each(|j| *j = 0);
    }
}

/// Whether each face of the region that belongs to the domain has a positive coefficient.
fn excludes_zero((degrees, positive): &Shown, coordinates: &Coordinates, region: &Region) -> bool {
    // A face: for each side anywhere, at its lower end, or at its upper end.
    let mut faces: Vec<Vec<Option<usize>>> = vec![vec![]];
    for ((lower, upper), degree) in coordinates.closed_ends(region).into_iter().zip(degrees) {
        let choices = [
            Some(None),
            lower.then_some(Some(0)),
            upper.then_some(Some(*degree)),
        ];
        faces = faces
            .into_iter()
            .flat_map(|face| {
                let longer = choices.into_iter().flatten().map(move |choice| {
                    let own = face.iter().copied().chain([choice]);
                    own.collect()
                });
                longer.collect::<Vec<_>>()
            })
            .collect();
    }
    faces.iter().all(|face| {
        positive.iter().any(|index| {
            let mut pairs = index.iter().zip(face);
            pairs.all(|(j, place)| place.is_none_or(|place| *j == place))
        })
    })
}

/// The polar forms of `1, t, ..., t^d` at d - j arguments a and j arguments b.
fn polar_forms((a, b): &(Rational, Rational), d: usize, j: usize) -> Vec<Rational> {
    let symmetric = |arguments: Vec<&Rational>| {
        arguments.into_iter().fold(vec![integer(1)], |row, x| {
            let shifted = std::iter::once(integer(0)).chain(row.iter().map(|e| e * x));
            let own = row.iter().cloned().chain([integer(0)]);
            own.zip(shifted).map(|(e, f)| e + f).collect()
        })
    };
    let one = integer(1);
    let forms: Vec<Rational> = symmetric([vec![a; d - j], vec![b; j]].concat());
    let counts = symmetric(vec![&one; d]);
    forms.into_iter().zip(counts).map(|(e, n)| e / n).collect()
}
