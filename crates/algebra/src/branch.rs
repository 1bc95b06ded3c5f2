//! Proofs of sign for everything that balls can evaluate.
//!
//! A function evaluated on one ball for each side of a box gives a ball that contains all its values
//! there (the inclusion property). If that ball is positive, so is the function on the whole box; if not,
//! the box is halved, and the excess of the balls falls in proportion to the width. At the midpoints a
//! ball that is negative refutes the claim.
//!
//! ```
//! use torse_algebra::positivity::{Decision, RationalBox};
//! use torse_algebra::{Scalar, branch, rational::{integer, ratio}};
//! // 1 + sin(pi x/2) - x > 0 on [0, 1].
//! let f = |x: &[torse_algebra::Ball]| {
//!     let x = &x[0];
//!     x.quarter_turn().map(|(sine, _)| x.one_like() + sine - x.clone())
//! };
//! let interval = RationalBox::new(vec![(integer(0), integer(1))])?;
//! let Decision::Proved(proof) = branch::prove_positive(f, &interval, 64, 1000) else { panic!() };
//! assert_eq!(branch::check_certificate(f, &interval, &proof), Ok(()));
//! # Ok::<(), torse_algebra::positivity::BoxError>(())
//! ```

use crate::ball::Ball;
use crate::positivity::{Attempt, CertificateError, Decision, Positivity, RationalBox};
use crate::rational::Rational;
use crate::scalar::ExactError;
use num_traits::Zero;
use std::collections::VecDeque;

/// A proof by balls: the boxes fill the domain, and on each the function has an enclosure, with this many
/// bits, that satisfies the claim.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BranchCertificate {
    /// The claim.
    pub positivity: Positivity,
    /// The precision of the balls.
    pub bits: usize,
    /// The boxes, each with the lower end of the enclosure there.
    pub leaves: Vec<(RationalBox, Rational)>,
}

/// Decides whether the function is positive on the box, examining at most `budget` boxes with balls of
/// `bits` bits.
///
/// The function is called with one ball for each side and must have the inclusion property, which
/// every composition of ball operations has. To compare with a bound `c`, hand over `f - c`. Where it fails
/// (a divisor that may be zero), the box is halved further.
pub fn prove_positive(
    f: impl Fn(&[Ball]) -> Result<Ball, ExactError>,
    region: &RationalBox,
    bits: usize,
    budget: usize,
) -> Decision<BranchCertificate, Ball> {
    prove(f, region, Positivity::Strict, bits, budget)
}

/// Decides whether the function is nowhere negative on the box; otherwise as [`prove_positive`].
pub fn prove_nonnegative(
    f: impl Fn(&[Ball]) -> Result<Ball, ExactError>,
    region: &RationalBox,
    bits: usize,
    budget: usize,
) -> Decision<BranchCertificate, Ball> {
    prove(f, region, Positivity::Weak, bits, budget)
}

/// Boxes of more sides have too many corners to try each.
const MAX_SIDES_FOR_CORNERS: usize = 10;

fn prove(
    f: impl Fn(&[Ball]) -> Result<Ball, ExactError>,
    region: &RationalBox,
    positivity: Positivity,
    bits: usize,
    budget: usize,
) -> Decision<BranchCertificate, Ball> {
    let refutes = |point: &[Rational]| {
        let balls: Vec<Ball> = point.iter().map(|x| Ball::from_rational(x, bits)).collect();
        f(&balls)
            .ok()
            .filter(|value| !positivity.admits_number(&value.upper()))
    };
    // Claims fail at the ends of their domain more often than anywhere else.
    if region.dimension() <= MAX_SIDES_FOR_CORNERS {
        for point in corners(region) {
            if let Some(value) = refutes(&point) {
                return Decision::Refuted { point, value };
            }
        }
    }
    let mut leaves = Vec::new();
    let mut open = Vec::new();
    let mut obstacle = None;
    let mut examined = 0;
    let mut waiting = VecDeque::from([region.clone()]);
    while examined < budget {
        let Some(piece) = waiting.pop_front() else {
            break;
        };
        examined += 1;
        match f(&piece.balls(bits)) {
            Ok(value) if positivity.admits_number(&value.lower()) => {
                leaves.push((piece, value.lower()));
                continue;
            }
            Ok(_) => {}
            Err(error) => obstacle = Some(error),
        }
        let point = piece.midpoint();
        if let Some(value) = refutes(&point) {
            return Decision::Refuted { point, value };
        }
        match relatively_widest(&piece, region).and_then(|axis| piece.halves(axis)) {
            Some((low, high)) => waiting.extend([low, high]),
            // A single point that these bits do not decide.
            None => open.push(piece),
        }
    }
    let unsettled = open.len() + waiting.len();
    match waiting.pop_front().or_else(|| open.pop()) {
        Some(example) => Decision::Unknown(Attempt {
            examined,
            open: unsettled,
            example,
            obstacle,
        }),
        None => Decision::Proved(BranchCertificate {
            positivity,
            bits,
            leaves,
        }),
    }
}

/// Checks that the certificate proves its claim about this function on this box: the pieces fill it, and
/// the function, evaluated again on each, satisfies the claim with the bound stated.
///
/// # Errors
/// [`CertificateError`] says what is wrong.
pub fn check_certificate(
    f: impl Fn(&[Ball]) -> Result<Ball, ExactError>,
    region: &RationalBox,
    certificate: &BranchCertificate,
) -> Result<(), CertificateError> {
    let pieces: Vec<&RationalBox> = certificate.leaves.iter().map(|(piece, _)| piece).collect();
    if !region.is_filled_by(&pieces) {
        return Err(CertificateError::NotFilled {
            pieces: pieces.len(),
        });
    }
    for (piece, (region, lower)) in certificate.leaves.iter().enumerate() {
        let holds = |value: Ball| *lower <= value.lower();
        let replayed = f(&region.balls(certificate.bits)).is_ok_and(holds);
        if !certificate.positivity.admits_number(lower) || !replayed {
            return Err(CertificateError::PieceFails { piece });
        }
    }
    Ok(())
}

/// The side that is the largest part of the corresponding side of the whole.
fn relatively_widest(piece: &RationalBox, whole: &RationalBox) -> Option<usize> {
    let width = |(lower, upper): &(Rational, Rational)| upper - lower;
    let parts = piece
        .sides()
        .iter()
        .zip(whole.sides())
        .enumerate()
        .filter_map(|(axis, (side, all))| {
            let all = width(all);
            (!all.is_zero()).then(|| (axis, width(side) / all))
        });
    // The first of equals.
    parts
        .reduce(|a, b| if b.1 > a.1 { b } else { a })
        .map(|(axis, _)| axis)
}

fn corners(region: &RationalBox) -> impl Iterator<Item = Vec<Rational>> {
    (0..1_usize << region.dimension()).map(|choice| {
        let ends = region.sides().iter().enumerate();
        ends.map(|(axis, (lower, upper))| {
            if choice >> axis & 1 == 0 {
                lower
            } else {
                upper
            }
        })
        .cloned()
        .collect()
    })
}
