//! Nonnegative multiples of assumptions that add up to a polynomial, by linear programming.
//!
//! **Theorem** (Farkas 1902, Motzkin 1936). Let p and c_1, ..., c_n be linear. If p >= 0 wherever all c_i >= 0, and there is
//! such a point, then `p = m_1 c_1 + ... + m_n c_n + r` with numbers m_i >= 0 and r >= 0. p > 0 there, if r > 0 or m_i > 0 for
//! an assumption that is strict.
//!
//! So for linear polynomials the search is complete, whatever their number. Others are read as linear forms in their
//! monomials, which is a search like any other. The numbers are found by the simplex method over the rationals, with
//! Bland's rule (1977), which cannot run in circles.

use super::certificate::{Certificate, Piece, Reason};
use num_traits::{Signed, Zero};
use std::collections::BTreeMap;
use torse_algebra::rational::integer;
use torse_algebra::{Polynomial, Rational, Symbol, work};

/// The most assumptions that are combined; of more, the first so many are.
const MAX_ASSUMPTIONS: usize = 80;
/// The most terms of a polynomial that takes part.
const MAX_TERMS: usize = 12;
/// The most exchanges of the simplex method.
const MAX_PIVOTS: usize = 400;

/// A certificate that the polynomial is a sum of nonnegative multiples of the assumptions and a nonnegative number; a strict one if
/// there is one.
pub(super) fn combination(
    polynomial: &Polynomial,
    assumed: &[(Polynomial, bool)],
) -> Option<Certificate> {
    if polynomial.len() > MAX_TERMS {
        return None;
    }
    let useful: Vec<(usize, &Polynomial, bool)> = assumed
        .iter()
        .enumerate()
        .filter(|(_, (p, _))| p.as_constant().is_none() && p.len() <= MAX_TERMS)
        .map(|(number, (p, strict))| (number, p, *strict))
        .take(MAX_ASSUMPTIONS)
        .collect();
    let parts: Vec<&Polynomial> = useful.iter().map(|(_, part, _)| *part).collect();
    let counts: Vec<bool> = useful.iter().map(|(_, _, strict)| *strict).collect();
    let found = Tableau::new(polynomial, &parts)?.solution(&counts)?;
    let (rest, multiples) = found.split_last()?;
    let multipliers: Vec<(usize, Rational)> = useful
        .iter()
        .zip(multiples)
        .filter(|(_, multiple)| !multiple.is_zero())
        .map(|((number, _, _), multiple)| (*number, multiple.clone()))
        .collect();
    let strict = rest.is_positive()
        || multiples
            .iter()
            .zip(&counts)
            .any(|(multiple, strict)| *strict && multiple.is_positive());
    Some(Certificate {
        strict,
        squares: vec![],
        multipliers,
        factors: vec![],
        rest: Polynomial::constant(rest),
        pieces: vec![Piece {
            region: vec![],
            reason: Reason::Coefficients,
        }],
    })
}

/// Equations between nonnegative unknowns in the form of the simplex method.
///
/// Invariants: every row has one entry for each unknown and the right side last; the right sides are not negative; the unknown
/// `basis[i]` has 1 in row i and 0 in all others.
struct Tableau {
    rows: Vec<Vec<Rational>>,
    basis: Vec<usize>,
    /// How many unknowns are sought: the multiples, and the constant that is left. Artificial ones follow.
    unknowns: usize,
}

/// A monomial, as a key.
type Powers = Vec<(Symbol, u16)>;

fn coefficients(polynomial: &Polynomial) -> BTreeMap<Powers, Rational> {
    let powers = |list: &[(&Symbol, u16)]| list.iter().map(|(s, e)| ((*s).clone(), *e)).collect();
    let terms = polynomial.terms();
    terms
        .map(|term| (powers(&term.powers), term.coefficient))
        .collect()
}

impl Tableau {
    /// `parts[0] m_0 + ... + r = polynomial`, an equation for each monomial, with an artificial unknown each; `None` if some monomial
    /// of the polynomial occurs in no part.
    fn new(polynomial: &Polynomial, parts: &[&Polynomial]) -> Option<Self> {
        let goal = coefficients(polynomial);
        let parts: Vec<_> = parts.iter().map(|part| coefficients(part)).collect();
        let constant: Powers = vec![];
        let mut monomials: Vec<&Powers> = goal
            .keys()
            .chain(parts.iter().flat_map(|p| p.keys()))
            .collect();
        monomials.push(&constant);
        monomials.sort();
        monomials.dedup();
        let unknowns = parts.len() + 1;
        let width = unknowns + monomials.len() + 1;
        let zero = Rational::zero;
        let mut rows = vec![];
        for (number, monomial) in monomials.iter().enumerate() {
            let entry = |part: &BTreeMap<Powers, Rational>| part.get(*monomial).cloned();
            let mut row: Vec<Rational> = parts
                .iter()
                .map(|p| entry(p).unwrap_or_else(zero))
                .collect();
            row.push(integer(i64::from(monomial.is_empty())));
            if row.iter().all(Zero::is_zero) {
                return None;
            }
            let right = entry(&goal).unwrap_or_else(zero);
            row.resize(width, zero());
            if let Some(last) = row.last_mut() {
                *last = right;
            }
            if row.last().is_some_and(Signed::is_negative) {
                for value in &mut row {
                    *value = -value.clone();
                }
            }
            *row.get_mut(unknowns + number)? = integer(1);
            rows.push(row);
        }
        let basis = (unknowns..unknowns + rows.len()).collect();
        Some(Self {
            rows,
            basis,
            unknowns,
        })
    }

    /// Values that satisfy the equations: multiples, then the constant. Among them, if there are such, ones for which the
    /// constant, or a multiple that counts, is positive.
    fn solution(mut self, counts: &[bool]) -> Option<Vec<Rational>> {
        let mut pivots = MAX_PIVOTS;
        // The artificial unknowns are made zero first.
        let sums = |column: usize| {
            self.rows
                .iter()
                .filter_map(|row| row.get(column))
                .sum::<Rational>()
        };
        let width = self.rows.first()?.len();
        let mut cost: Vec<Rational> = (0..width).map(sums).collect();
        for artificial in cost.iter_mut().take(width - 1).skip(self.unknowns) {
            *artificial = Rational::zero();
        }
        self.maximise(&mut cost, &mut pivots, |left| left.is_zero())?;
        if !cost.last()?.is_zero() {
            return None;
        }
        self.drop_artificial()?;
        // Then what makes the sum positive is made as large as it has to be.
        let weight = |column: usize| counts.get(column).copied().unwrap_or(true);
        let mut cost: Vec<Rational> = (0..=self.unknowns)
            .map(|column| integer(i64::from(column < self.unknowns && weight(column))))
            .collect();
        for (row, basic) in self.rows.iter().zip(&self.basis) {
            if weight(*basic) {
                subtract(&mut cost, row, &integer(1));
            }
        }
        let ray = self.maximise(&mut cost, &mut pivots, |value| value.is_negative())?;
        let mut found = vec![Rational::zero(); self.unknowns];
        for (row, basic) in self.rows.iter().zip(&self.basis) {
            *found.get_mut(*basic)? = row.last()?.clone();
        }
        // Along a ray on which the sum grows without end one step is enough.
        if let Some(column) = ray {
            *found.get_mut(column)? += integer(1);
            for (row, basic) in self.rows.iter().zip(&self.basis) {
                *found.get_mut(*basic)? -= row.get(column)?.clone();
            }
        }
        Some(found)
    }

    /// Exchanges unknowns until the objective is maximal, or `enough` accepts its negative, the last entry of `cost`. Returns the unknown along which the objective is unbounded, if there is one; `None` for the whole when the
    /// exchanges are used up.
    fn maximise(
        &mut self,
        cost: &mut Vec<Rational>,
        pivots: &mut usize,
        enough: impl Fn(&Rational) -> bool,
    ) -> Option<Option<usize>> {
        loop {
            let (value, costs) = cost.split_last()?;
            if enough(value) {
                return Some(None);
            }
            // Bland: the first unknown that helps enters, and of those that may leave the first does.
            let Some(entering) = costs.iter().position(Signed::is_positive) else {
                return Some(None);
            };
            let mut leaving: Option<(Rational, usize, usize)> = None;
            for (number, (row, basic)) in self.rows.iter().zip(&self.basis).enumerate() {
                let entry = row.get(entering)?;
                if entry.is_positive() {
                    let candidate = (row.last()? / entry, *basic, number);
                    let first = leaving.as_ref();
                    if first
                        .is_none_or(|(ratio, own, _)| (&candidate.0, &candidate.1) < (ratio, own))
                    {
                        leaving = Some(candidate);
                    }
                }
            }
            let Some((_, _, row)) = leaving else {
                return Some(Some(entering));
            };
            *pivots = pivots.checked_sub(1)?;
            self.exchange(row, entering, Some(cost))?;
        }
    }

    /// Makes an unknown basic in a row.
    fn exchange(
        &mut self,
        row: usize,
        column: usize,
        cost: Option<&mut Vec<Rational>>,
    ) -> Option<()> {
        work::spend(self.rows.len() as u64).ok()?;
        let pivot = self.rows.get(row)?.get(column)?.clone();
        for value in self.rows.get_mut(row)? {
            *value = &*value / &pivot;
        }
        let chosen = self.rows.get(row)?.clone();
        for (number, other) in self.rows.iter_mut().enumerate() {
            if number != row {
                let factor = other.get(column)?.clone();
                subtract(other, &chosen, &factor);
            }
        }
        if let Some(cost) = cost {
            let factor = cost.get(column)?.clone();
            subtract(cost, &chosen, &factor);
        }
        *self.basis.get_mut(row)? = column;
        Some(())
    }

    /// Takes the artificial unknowns, which are all zero, out of basis and columns; rows that say nothing go.
    fn drop_artificial(&mut self) -> Option<()> {
        let mut row = 0;
        while row < self.rows.len() {
            if *self.basis.get(row)? < self.unknowns {
                row += 1;
                continue;
            }
            let entries = self.rows.get(row)?.iter().take(self.unknowns);
            match entries.enumerate().find(|(_, entry)| !entry.is_zero()) {
                Some((column, _)) => self.exchange(row, column, None)?,
                None => {
                    self.rows.remove(row);
                    self.basis.remove(row);
                }
            }
        }
        for row in &mut self.rows {
            let right = row.pop()?;
            row.truncate(self.unknowns);
            row.push(right);
        }
        Some(())
    }
}

/// Subtracts a multiple of a row.
fn subtract(from: &mut [Rational], row: &[Rational], factor: &Rational) {
    if factor.is_zero() {
        return;
    }
    for (value, own) in from.iter_mut().zip(row) {
        if !own.is_zero() {
            *value = &*value - own * factor;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn linear(terms: &[(&str, i64)], constant: i64) -> Polynomial {
        let start = Polynomial::constant(&integer(constant));
        terms.iter().fold(start, |sum, (name, coefficient)| {
            &sum + &Polynomial::symbol(Symbol::named(name)).scaled(&integer(*coefficient))
        })
    }

    /// The sum that a certificate names.
    fn sum(certificate: &Certificate, assumed: &[(Polynomial, bool)]) -> Polynomial {
        let multipliers = certificate.multipliers.iter();
        multipliers.fold(certificate.rest.clone(), |sum, (number, multiple)| {
            assert!(multiple.is_positive());
            &sum + &assumed
                .get(*number)
                .map_or(Polynomial::zero(), |(p, _)| p.scaled(multiple))
        })
    }

    #[test]
    fn a_chain_of_any_length_gives_the_distance_of_its_ends() {
        let names: Vec<String> = (0..30).map(|n| format!("u{n}")).collect();
        let step = |n: usize| linear(&[(names[n + 1].as_str(), 1), (names[n].as_str(), -1)], 0);
        let assumed: Vec<(Polynomial, bool)> = (0..29).map(|n| (step(n), n == 17)).collect();
        let ends = linear(&[("u29", 1), ("u0", -1)], 0);
        let found = combination(&ends, &assumed).expect("it is their sum");
        assert!(found.strict);
        assert_eq!(found.multipliers.len(), 29);
        assert_eq!(sum(&found, &assumed), ends);
        let reversed = combination(&-&ends, &assumed);
        assert!(reversed.is_none());
    }

    #[test]
    fn a_vertex_of_a_polygon_bounds_what_it_maximises() {
        // x + 2 y <= 4, 3 x + y <= 6, x >= 0, y >= 0: the largest x + y is 14/5.
        let assumed = vec![
            (linear(&[("x", -1), ("y", -2)], 4), false),
            (linear(&[("x", -3), ("y", -1)], 6), false),
            (linear(&[("x", 1)], 0), false),
            (linear(&[("y", 1)], 0), false),
        ];
        let bound = |fifths: i64| linear(&[("x", -5), ("y", -5)], fifths);
        let weak = combination(&bound(14), &assumed).expect("it holds");
        assert!(!weak.strict);
        assert_eq!(sum(&weak, &assumed), bound(14));
        let strict = combination(&bound(15), &assumed).expect("it holds");
        assert!(strict.strict);
        assert_eq!(sum(&strict, &assumed), bound(15));
        assert!(combination(&bound(13), &assumed).is_none());
    }

    #[test]
    fn a_contradiction_makes_everything_positive() {
        // x > 1 and x < 0.
        let assumed = vec![
            (linear(&[("x", 1)], -1), true),
            (linear(&[("x", -1)], 0), true),
        ];
        let goal = linear(&[], -7);
        let found = combination(&goal, &assumed).expect("there is no point");
        assert!(found.strict);
        assert_eq!(sum(&found, &assumed), goal);
    }
}
