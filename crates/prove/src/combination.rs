//! Equations that follow from given ones as they stand, without solving them.
//!
//! Where the given equations `f_i = 0` are linear in their unknowns u, their solution by Cramer's rule divides by a
//! determinant, and what is proved with it holds where that is not zero. But a difference d of the form
//! `sum l_i f_i` with polynomials l_i is zero wherever the equations hold, determinant or not. If d is linear in u as
//! well, there is one candidate for the l_i: with the matrices `F = df/du` and `D = dd/du` they are `D F^-1`. They count
//! only if they are polynomials and the sum, multiplied out, is d.

use crate::evaluate::linear::linear_form;
use crate::unknown::Unknown;
use torse_algebra::matrix::Matrix;
use torse_algebra::{Fraction, Polynomial};

/// Larger systems are not looked at: their determinants are the work that this is to save.
const MAX_UNKNOWNS: usize = 6;
/// The most terms of all equations together.
const MAX_TERMS: usize = 400;

/// The multipliers of the numerators of the forms, a row for each difference, that make its numerator: so every difference
/// is zero wherever all forms are zero, and all divisors of both are not. `None` if there are none that are polynomials.
///
/// ```
/// use torse_algebra::Fraction;
/// use torse_prove::combination::multipliers;
/// use torse_prove::unknown::Unknown;
/// let name = Fraction::named;
/// let (r, s) = (name("r"), name("s"));
/// // a r + b s = e and c r + d s = f
/// let forms = [
///     name("a") * r.clone() + name("b") * s.clone() - name("e"),
///     name("c") * r.clone() + name("d") * s.clone() - name("f"),
/// ];
/// let unknowns: Vec<Unknown> = [&r, &s].into_iter().filter_map(Unknown::from_fraction).collect();
/// let determinant = name("a") * name("d") - name("b") * name("c");
/// let rule = determinant * s.clone() - (name("a") * name("f") - name("c") * name("e"));
/// assert!(multipliers(&[rule], &forms, &unknowns).is_some());
/// // This one needs that a d - b c is not zero.
/// let vanishing = s.over(&name("e"))?;
/// assert!(multipliers(&[vanishing], &forms, &unknowns).is_none());
/// # Ok::<(), torse_algebra::ExactError>(())
/// ```
#[must_use]
pub fn multipliers(
    differences: &[Fraction],
    forms: &[Fraction],
    unknowns: &[Unknown],
) -> Option<Vec<Vec<Polynomial>>> {
    let forms: Vec<Polynomial> = forms.iter().map(|f| f.numerator().clone()).collect();
    let terms: usize = forms.iter().map(Polynomial::len).sum();
    if forms.len() != unknowns.len() || unknowns.len() > MAX_UNKNOWNS || terms > MAX_TERMS {
        return None;
    }
    let rates = |p: &Polynomial| Some(linear_form(&p.clone().into(), unknowns)?.0);
    let rows = forms.iter().map(rates).collect::<Option<Vec<_>>>()?;
    let matrix = Matrix::from_rows(rows).ok()?;
    let (determinant, adjugate) = (matrix.determinant().ok()?, matrix.adjugate().ok()?);
    let of = |difference: &Fraction| {
        let numerator = difference.numerator();
        let row = Matrix::from_rows(vec![rates(numerator)?]).ok()?;
        let row = row.times(&adjugate).ok()?;
        let factors = row.rows().next()?.iter();
        let factors = factors.map(|f| f.numerator().exact_quotient(determinant.numerator()));
        let factors = factors.collect::<Option<Vec<Polynomial>>>()?;
        let terms = factors.iter().zip(&forms);
        let sum = terms.fold(Polynomial::zero(), |sum, (l, f)| &sum + &(l * f));
        (sum == *numerator).then_some(factors)
    };
    differences.iter().map(of).collect()
}
