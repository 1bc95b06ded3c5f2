//! Branch and bound with Bernstein coefficients.

use super::{BernsteinError, BernsteinForm, Term};
use crate::positivity::{Attempt, Decision, Positivity, RationalBox};
use crate::rational::Rational;
use std::collections::VecDeque;

/// One piece of a proof: a box and the least Bernstein coefficient of the polynomial on it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Leaf {
    /// The box.
    pub region: RationalBox,
    /// The least coefficient, a lower bound of the polynomial on the box.
    pub least: Rational,
}

/// A proof that a polynomial is positive (or not negative) on a box: the leaves fill the box, and on each
/// the least Bernstein coefficient is positive (or not negative).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BernsteinCertificate {
    /// The claim.
    pub positivity: Positivity,
    /// The pieces.
    pub leaves: Vec<Leaf>,
}

/// Decides whether the polynomial is positive on the box, examining at most `budget` boxes.
///
/// ```
/// use torse_algebra::bernstein::{check_certificate, prove_positive};
/// use torse_algebra::positivity::{Decision, RationalBox};
/// use torse_algebra::rational::{integer, ratio};
/// // x^2 - x y + y^2 + 1/100 on the unit square.
/// let terms = [
///     (vec![2, 0], integer(1)),
///     (vec![1, 1], integer(-1)),
///     (vec![0, 2], integer(1)),
///     (vec![0, 0], ratio(1, 100).unwrap()),
/// ];
/// let square = RationalBox::unit(2)?;
/// let Decision::Proved(certificate) = prove_positive(&terms, &square, 1000)? else { panic!() };
/// assert_eq!(check_certificate(&terms, &square, &certificate), Ok(()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Those of [`BernsteinForm::new`].
pub fn prove_positive(
    terms: &[Term],
    region: &RationalBox,
    budget: usize,
) -> Result<Decision<BernsteinCertificate, Rational>, BernsteinError> {
    prove(terms, region, Positivity::Strict, budget)
}

/// Decides whether the polynomial is nowhere negative on the box, examining at most `budget` boxes.
///
/// A zero inside the box that no halving meets (at 1/3, say) stays unknown at any budget.
///
/// # Errors
/// Those of [`BernsteinForm::new`].
pub fn prove_nonnegative(
    terms: &[Term],
    region: &RationalBox,
    budget: usize,
) -> Result<Decision<BernsteinCertificate, Rational>, BernsteinError> {
    prove(terms, region, Positivity::Weak, budget)
}

fn prove(
    terms: &[Term],
    region: &RationalBox,
    positivity: Positivity,
    budget: usize,
) -> Result<Decision<BernsteinCertificate, Rational>, BernsteinError> {
    let mut leaves = Vec::new();
    let mut examined = 0;
    // First in, first out: all boxes of one size before the smaller ones, so that a counterexample is
    // found among the simplest points.
    let mut waiting = VecDeque::from([BernsteinForm::new(terms, region)?]);
    while let Some(form) = waiting.pop_front() {
        if examined == budget {
            let open = waiting.len() + 1;
            let example = form.region().clone();
            return Ok(Decision::Unknown(Attempt {
                examined,
                open,
                example,
                obstacle: None,
            }));
        }
        examined += 1;
        let (least, _) = form.bounds();
        if positivity.admits_number(&least) {
            leaves.push(Leaf {
                region: form.region().clone(),
                least,
            });
            continue;
        }
        if let Some((point, value)) = form
            .corners()
            .find(|(_, value)| !positivity.admits_number(value))
        {
            return Ok(Decision::Refuted { point, value });
        }
        // Without a steepest axis all coefficients are one number, which one of the tests has decided.
        let halves = form.steepest_axis().and_then(|axis| form.halves(axis));
        waiting.extend(halves.into_iter().flat_map(|(low, high)| [low, high]));
    }
    Ok(Decision::Proved(BernsteinCertificate {
        positivity,
        leaves,
    }))
}
