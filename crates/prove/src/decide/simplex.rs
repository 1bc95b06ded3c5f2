//! Linear programming over the rationals: the simplex method with Bland's rule (1977), which cannot run in circles.

use num_traits::{Signed, Zero};
use torse_algebra::rational::integer;
use torse_algebra::{Rational, work};

/// The most exchanges of the simplex method.
const MAX_PIVOTS: usize = 400;

/// Equations between nonnegative unknowns in the form of the simplex method.
///
/// Invariants: every row has one entry for each unknown and the right side last; the right sides are not negative; the unknown
/// `basis[i]` has 1 in row i and 0 in all others.
pub(super) struct Tableau {
    rows: Vec<Vec<Rational>>,
    basis: Vec<usize>,
    /// The number of unknowns; artificial ones follow.
    unknowns: usize,
}

impl Tableau {
    /// Equations as rows of as many coefficients as there are unknowns, with the right side last; each gets an artificial
    /// unknown. `None` if an equation has no unknown.
    pub fn new(equations: Vec<Vec<Rational>>, unknowns: usize) -> Option<Self> {
        let count = equations.len();
        let mut rows = vec![];
        for (number, mut row) in equations.into_iter().enumerate() {
            let right = row.pop()?;
            if row.iter().all(Zero::is_zero) {
                return None;
            }
            row.resize(unknowns + count, Rational::zero());
            row.push(right);
            if row.last().is_some_and(Signed::is_negative) {
                for value in &mut row {
                    *value = -value.clone();
                }
            }
            *row.get_mut(unknowns + number)? = integer(1);
            rows.push(row);
        }
        let basis = (unknowns..unknowns + count).collect();
        Some(Self {
            rows,
            basis,
            unknowns,
        })
    }

    /// Values of the unknowns that satisfy the equations; among them, if there are such, ones for which an unknown that counts is
    /// positive.
    pub fn solution(mut self, counts: &[bool]) -> Option<Vec<Rational>> {
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
        let weight = |column: usize| counts.get(column).copied().unwrap_or(false);
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
