//! The Bernstein coefficients of all determinants at one value of the variable.

use super::operator::{Operator, Part, weight};
use super::tables::{differences, newton};
use super::{SHAPES, Unfit};
use num_traits::Zero;
use torse_numbers::rational::integer;
use torse_numbers::{Ball, Rational, Scalar as _};

/// The number of binary digits after the point of all enclosures.
pub(super) const BITS: usize = 256;

/// Values indexed by the coefficient of the first parameter, then of the second.
pub(super) type Grid = Vec<Vec<Ball>>;

/// The data that all values of the variable share.
pub(super) struct Places<'a> {
    operator: &'a Operator,
    degree: usize,
    /// The degree of the last determinant in the parameters, which take the values n/most.
    most: usize,
    /// The factor of `c_i` in column j, indexed by the order i (from 1) and by j.
    weights: Vec<Vec<Ball>>,
    /// The matrices from differences to Bernstein coefficients, indexed by the rank (from 1).
    tables: Vec<Vec<Vec<Ball>>>,
    /// The powers of n/most.
    shapes: Vec<Vec<Ball>>,
    pi: Ball,
}

fn ball(value: &Rational) -> Ball {
    Ball::from_rational(value, BITS)
}

impl<'a> Places<'a> {
    pub fn new(operator: &'a Operator, degree: usize) -> Self {
        let most = operator.total * degree;
        let number = |n: usize| integer(i64::try_from(n).unwrap_or(0));
        let share = |n: usize| match most {
            0 => Rational::zero(),
            _ => number(n) / number(most),
        };
        let powers = |n: usize| {
            let exponents = 0..=i32::try_from(operator.total).unwrap_or(0);
            exponents.map(|e| ball(&share(n).pow(e))).collect()
        };
        let weights = |i| (0..=degree).map(|j| ball(&weight(i, j, degree))).collect();
        let table = |rank| {
            newton(
                &number(most),
                &Rational::zero(),
                operator.total * rank,
                BITS,
            )
        };
        Self {
            operator,
            degree,
            most,
            weights: (1..=operator.order()).map(weights).collect(),
            tables: (1..=degree).map(table).collect(),
            shapes: (0..=most).map(powers).collect(),
            pi: Ball::pi(BITS),
        }
    }

    /// The Bernstein coefficients of `D_1, ..., D_k` at x.
    ///
    /// # Errors
    /// [`Unfit::Sign`] if the enclosure of a determinant contains zero.
    pub fn at(&self, x: &Rational) -> Result<Vec<Grid>, Unfit> {
        let parts = self.taylor(x);
        let width = |place: usize, most: usize| if self.operator.used[place] { most } else { 0 };
        // The values at the places (a, b)/most with a + b <= most.
        let mut values: Vec<Grid> = vec![vec![]; self.degree];
        for a in 0..=width(0, self.most) {
            let mut rows: Vec<Vec<Ball>> = vec![vec![]; self.degree];
            for b in 0..=width(1, self.most - a) {
                let found = self.determinants(&parts, a, b, x)?;
                for (row, determinant) in rows.iter_mut().zip(found) {
                    row.push(determinant);
                }
            }
            for (grid, row) in values.iter_mut().zip(rows) {
                grid.push(row);
            }
        }
        let ranks = (1..).zip(values).zip(&self.tables);
        let coefficients = ranks.map(|((rank, grid), table)| {
            let most = self.operator.total * rank;
            self.bernstein(grid, table, width(0, most), width(1, most), most)
        });
        Ok(coefficients.collect())
    }

    /// Converts values at a triangle of places to Bernstein coefficients. A polynomial of total degree `most` is the
    /// sum of its differences (a, b) with a + b <= most, times products of binomial coefficients.
    fn bernstein(
        &self,
        mut grid: Grid,
        table: &[Vec<Ball>],
        rows: usize,
        columns: usize,
        most: usize,
    ) -> Grid {
        grid.truncate(rows + 1);
        for (a, row) in grid.iter_mut().enumerate() {
            row.truncate(columns.min(most - a) + 1);
            differences(row);
        }
        let unit = vec![vec![ball(&integer(1))]];
        let table_of = |place: usize| {
            if self.operator.used[place] {
                table
            } else {
                &unit
            }
        };
        let mut half: Grid = vec![vec![]; rows + 1];
        for b in 0..=columns {
            let mut column: Vec<Ball> = grid.iter().filter_map(|row| row.get(b).cloned()).collect();
            differences(&mut column);
            for (row, weights) in half.iter_mut().zip(table_of(0)) {
                row.push(Ball::dot(weights.iter().zip(&column), BITS));
            }
        }
        let interpolated = |row: &Vec<Ball>| {
            let weights = table_of(1).iter();
            weights
                .map(|weights| Ball::dot(weights.iter().zip(row), BITS))
                .collect()
        };
        half.iter().map(interpolated).collect()
    }

    /// The Taylor coefficients at x of all parts of `c_1, c_2, ...`.
    fn taylor(&self, x: &Rational) -> Vec<Vec<Vec<Ball>>> {
        let length = self.degree + self.operator.order();
        let zero = ball(&Rational::zero());
        let half_pi = self.pi.scaled(&Rational::new(1.into(), 2.into()));
        let (s, c) = (&half_pi * &ball(x)).sin_cos();
        let (mut sine, mut cosine) = (vec![], vec![]);
        let mut power = ball(&integer(1));
        for n in 0..length {
            if n > 0 {
                let share = integer(i64::try_from(n).unwrap_or(1)).recip();
                power = &power * &half_pi.scaled(&share);
            }
            let (ds, dc) = match n % 4 {
                0 => (s.clone(), c.clone()),
                1 => (c.clone(), -&s),
                2 => (-&s, -&c),
                _ => (-&c, s.clone()),
            };
            sine.push(&ds * &power);
            cosine.push(&dc * &power);
        }
        let mut line = vec![zero.clone(); length];
        for (slot, value) in line.iter_mut().zip([x.clone(), integer(1)]) {
            *slot = ball(&value);
        }
        let all = self.operator.parts.iter().flatten().flat_map(|p| &p.terms);
        let most = all.fold([0; 3], |most, term| {
            [
                most[0].max(term.x),
                most[1].max(term.sine),
                most[2].max(term.cosine),
            ]
        });
        let powers: Vec<Vec<Vec<Ball>>> = [&line, &sine, &cosine]
            .into_iter()
            .zip(most)
            .map(|(base, most)| {
                let mut one = vec![zero.clone(); length];
                if let Some(slot) = one.first_mut() {
                    *slot = ball(&integer(1));
                }
                let mut all = vec![one];
                for n in 0..usize::try_from(most).unwrap_or(0) {
                    all.push(product(&all[n], base));
                }
                all
            })
            .collect();
        let part_series = |part: &Part| {
            let mut total = vec![zero.clone(); length];
            for term in &part.terms {
                let number = self.pi.powi(term.pi).scaled(&term.coefficient);
                let exponents = [term.x, term.sine, term.cosine];
                let mut series: Option<Vec<Ball>> = None;
                for (all, exponent) in powers.iter().zip(exponents) {
                    let place = usize::try_from(exponent).unwrap_or(0);
                    let Some(next) = all.get(place).filter(|_| place > 0) else {
                        continue;
                    };
                    series = Some(match series {
                        None => next.clone(),
                        Some(own) => product(&own, next),
                    });
                }
                let series = series.unwrap_or_else(|| powers[0][0].clone());
                for (slot, coefficient) in total.iter_mut().zip(&series) {
                    *slot = &*slot + &(coefficient * &number);
                }
            }
            total
        };
        let parts = self.operator.parts.iter();
        parts
            .map(|own| own.iter().map(part_series).collect())
            .collect()
    }

    /// `D_1, ..., D_k` at one place, by elimination without row exchanges: the pivots are quotients of consecutive
    /// determinants.
    fn determinants(
        &self,
        parts: &[Vec<Vec<Ball>>],
        a: usize,
        b: usize,
        x: &Rational,
    ) -> Result<Vec<Ball>, Unfit> {
        let (k, d) = (self.degree, self.operator.order());
        let zero = ball(&Rational::zero());
        let functions: Vec<Vec<Ball>> = self
            .operator
            .parts
            .iter()
            .zip(parts)
            .map(|(own, series)| self.combined(own, series, [a, b]))
            .collect();
        let mut matrix = vec![vec![zero.clone(); k]; k];
        for m in 1..=k {
            for j in 1..=k.min(m + d) {
                let entry = &mut matrix[m - 1][j - 1];
                if m == j {
                    *entry = ball(&integer(1));
                }
                for (i, function) in (1..).zip(&functions).filter(|(i, _)| *i <= j && m + i >= j) {
                    *entry = &*entry + &(&function[m + i - j] * &self.weights[i - 1][j]);
                }
            }
        }
        let mut determinant = ball(&integer(1));
        let mut all = vec![];
        for r in 0..k {
            let pivot = matrix[r][r].clone();
            determinant = &determinant * &pivot;
            all.push(determinant.clone());
            if r + 1 == k {
                break;
            }
            let inverse = ball(&integer(1)).divided_by(&pivot);
            let inverse = inverse.map_err(|_| Unfit::Sign {
                rank: r + 1,
                until: x.to_string(),
            })?;
            let (above, below) = matrix.split_at_mut(r + 1);
            for row in below {
                let factor = &row[r] * &inverse;
                // Row r has nonzero entries up to d places right of the diagonal.
                for j in r + 1..k.min(r + d + 1) {
                    row[j] = &row[j] - &(&factor * &above[r][j]);
                }
            }
        }
        Ok(all)
    }

    /// The Taylor series of one function at the parameters `n/most`.
    fn combined(&self, parts: &[Part], series: &[Vec<Ball>], at: [usize; SHAPES]) -> Vec<Ball> {
        let length = self.degree + self.operator.order();
        let mut total = vec![ball(&Rational::zero()); length];
        for (part, own) in parts.iter().zip(series) {
            let power = |place: usize| {
                let exponent = usize::try_from(part.shape[place]).unwrap_or(0);
                (exponent > 0).then(|| &self.shapes[at[place]][exponent])
            };
            let factors: Vec<&Ball> = (0..SHAPES).filter_map(power).collect();
            for (slot, coefficient) in total.iter_mut().zip(own) {
                let value = factors.iter().fold(coefficient.clone(), |v, f| &v * f);
                *slot = &*slot + &value;
            }
        }
        total
    }
}

/// The product of truncated series.
fn product(a: &[Ball], b: &[Ball]) -> Vec<Ball> {
    let mut result = vec![ball(&Rational::zero()); a.len()];
    for (i, x) in a
        .iter()
        .enumerate()
        .filter(|(_, x)| x.sign() != Some(std::cmp::Ordering::Equal))
    {
        for (slot, y) in result.iter_mut().skip(i).zip(b) {
            *slot = &*slot + &(x * y);
        }
    }
    result
}
