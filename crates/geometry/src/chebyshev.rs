//! Polynomials of degree 16 on an interval, by their Chebyshev coefficients.
//!
//! A smooth function is sampled at the 17 Chebyshev points of the second kind and replaced by the polynomial
//! through the samples. Integrals are then exact, and because `|T_j| <= 1` the sum of the absolute values
//! of the coefficients bounds the polynomial on the whole interval, not only at samples
//! (Trefethen, *Approximation Theory and Approximation Practice*, chapters 3, 4 and 8).

use crate::batch::widest;
use std::f64::consts::PI;
use std::sync::LazyLock;

/// The degree of the interpolants.
pub(crate) const DEGREE: usize = 16;
/// The number of samples.
pub(crate) const NODES: usize = DEGREE + 1;

/// The values or the coefficients of an interpolant.
pub(crate) type Row = [f64; NODES];

/// The tables that all intervals share.
struct Tables {
    /// The points on [-1, 1], ascending.
    nodes: Row,
    /// Row `k` says what the sum of the values at nodes `k` and `16 - k` adds to the coefficients of even order.
    even: [[f64; NODES / 2 + 1]; NODES / 2 + 1],
    /// The same of the difference of the two values, for odd orders.
    odd: [[f64; NODES / 2]; NODES / 2],
    /// [`basis`] at the nodes.
    rows: [Row; NODES],
}

static TABLES: LazyLock<Tables> = LazyLock::new(|| {
    #[allow(clippy::cast_precision_loss)]
    let angle = |k: usize| PI * k as f64 / DEGREE as f64;
    let end = |k: usize| if k == 0 || k == DEGREE { 0.5 } else { 1.0 };
    #[allow(clippy::cast_precision_loss)]
    let scale = 2.0 / DEGREE as f64;
    // By the sine of the distance from the middle, which makes the nodes symmetric.
    let nodes: Row = std::array::from_fn(|k| libm::sin(angle(k) - 0.5 * PI));
    // What the value at node k adds to the coefficient of T_j.
    let weight = |j: usize, k: usize| {
        let sign = if j.is_multiple_of(2) { 1.0 } else { -1.0 };
        // The angle modulo a full turn, as an integer: no rounding of large angles.
        scale * end(j) * end(k) * sign * libm::cos(angle((j * k) % (2 * DEGREE)))
    };
    Tables {
        nodes,
        rows: nodes.map(basis),
        even: std::array::from_fn(|k| std::array::from_fn(|i| weight(2 * i, k))),
        odd: std::array::from_fn(|k| std::array::from_fn(|i| weight(2 * i + 1, k))),
    }
});

/// The parameters of the samples on `[from, to]`; the first and the last are the ends themselves.
pub(crate) fn nodes(from: f64, to: f64) -> Row {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    let mut row = TABLES.nodes.map(|t| middle + half * t);
    (row[0], row[DEGREE]) = (from, to);
    row
}

/// [`basis`] at the samples.
pub(crate) fn node_rows() -> &'static [Row; NODES] {
    &TABLES.rows
}

/// Parameters between the samples, where the error of interpolation is near its summits.
pub(crate) fn between(from: f64, to: f64) -> [f64; 4] {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    [2.5, 6.5, 9.5, 13.5].map(|k| {
        #[allow(clippy::cast_precision_loss)]
        let angle = PI * k / DEGREE as f64;
        middle - half * libm::cos(angle)
    })
}

/// `T_0(t), ..., T_16(t)` for `t` in [-1, 1]: evaluates any number of interpolants.
pub(crate) fn basis(t: f64) -> Row {
    let mut row = [1.0; NODES];
    row[1] = t;
    // T_(i+k) = 2 T_i T_k - T_(i-k) with halves: four steps one after the other, not fifteen.
    for j in 2..NODES {
        let (half, rest) = (j / 2, j - j / 2);
        row[j] = 2.0 * row[half] * row[rest] - row[rest - half];
    }
    row
}

/// [`basis`] at several parameters: row `j` has the values of `T_j`.
pub(crate) type Rows<const L: usize> = [[f64; L]; NODES];

/// [`basis`] at several parameters, with the same bits.
#[inline(always)]
pub(crate) fn bases<const L: usize>(t: [f64; L]) -> Rows<L> {
    let mut rows = [[1.0; L]; NODES];
    rows[1] = t;
    for j in 2..NODES {
        let (half, rest) = (j / 2, j - j / 2);
        rows[j] = std::array::from_fn(
            #[inline(always)]
            |k| 2.0 * rows[half][k] * rows[rest][k] - rows[rest - half][k],
        );
    }
    rows
}

/// An interpolant by its coefficients.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Interpolant(Row);

impl Interpolant {
    /// With these coefficients.
    pub(crate) fn from_coefficients(coefficients: Row) -> Self {
        Self(coefficients)
    }

    /// The same value everywhere.
    pub(crate) fn constant(value: f64) -> Self {
        Self::linear(value, value)
    }

    /// From one value at the left end to another at the right one.
    pub(crate) fn linear(from: f64, to: f64) -> Self {
        let mut row = [0.0; NODES];
        (row[0], row[1]) = (0.5 * (from + to), 0.5 * (to - from));
        Self(row)
    }

    /// Through these values at the nodes.
    pub(crate) fn through(values: &Row) -> Self {
        // What is transformed are differences, so that rounding is relative to the change.
        let base = values[DEGREE / 2];
        let (tables, mut row) = (&*TABLES, [0.0; NODES]);
        widest(
            #[inline(always)]
            || {
                let (mut even, mut odd) = ([0.0; NODES / 2 + 1], [0.0; NODES / 2]);
                // The node in the middle changes by nothing.
                for k in 0..NODES / 2 {
                    let (low, high) = (values[k] - base, values[DEGREE - k] - base);
                    for (sum, weight) in even.iter_mut().zip(&tables.even[k]) {
                        *sum += weight * (low + high);
                    }
                    for (sum, weight) in odd.iter_mut().zip(&tables.odd[k]) {
                        *sum += weight * (low - high);
                    }
                }
                for (slot, sum) in row.iter_mut().step_by(2).zip(even) {
                    *slot = sum;
                }
                for (slot, sum) in row.iter_mut().skip(1).step_by(2).zip(odd) {
                    *slot = sum;
                }
            },
        );
        row[0] += base;
        Self(row)
    }

    /// The value for a row of [`basis`].
    #[inline(always)]
    pub(crate) fn at(&self, basis: &Row) -> f64 {
        product(&self.0, basis)
    }

    /// The values for several parameters, with the bits of [`Interpolant::at`].
    #[inline(always)]
    pub(crate) fn at_each<const L: usize>(&self, rows: &Rows<L>) -> [f64; L] {
        let mut sums = [[0.0; L]; 4];
        for (c, rows) in self.0.chunks_exact(4).zip(rows.chunks_exact(4)) {
            for (sum, (c, row)) in sums.iter_mut().zip(c.iter().zip(rows)) {
                for (sum, value) in sum.iter_mut().zip(row) {
                    *sum += c * value;
                }
            }
        }
        let (last, row) = (self.0[DEGREE], &rows[DEGREE]);
        std::array::from_fn(|k| {
            (sums[0][k] + sums[1][k]) + (sums[2][k] + sums[3][k]) + last * row[k]
        })
    }

    /// `factors[0] f + factors[1] g + constant`.
    pub(crate) fn sum(factors: [f64; 2], [f, g]: [&Self; 2], constant: f64) -> Self {
        let mut row: Row = std::array::from_fn(|j| factors[0] * f.0[j] + factors[1] * g.0[j]);
        row[0] += constant;
        Self(row)
    }

    /// The integral from the left end of an interval of this half width, plus a constant. The part of degree
    /// 17 is dropped: [`Interpolant::tail`] times the half width bounds it.
    pub(crate) fn integral(&self, half: f64, start: f64) -> Self {
        let c = |j: usize| self.0.get(j).copied().unwrap_or(0.0);
        let mut row = [0.0; NODES];
        for (j, slot) in row.iter_mut().enumerate().skip(1) {
            let before = if j == 1 { 2.0 * c(0) } else { c(j - 1) };
            #[allow(clippy::cast_precision_loss)]
            let over = 2.0 * j as f64;
            *slot = half * (before - c(j + 1)) / over;
        }
        let at_left: f64 = row
            .iter()
            .enumerate()
            .map(|(j, a)| if j % 2 == 0 { *a } else { -*a })
            .sum();
        row[0] = start - at_left;
        Self(row)
    }

    /// The derivative on an interval of this half width.
    pub(crate) fn derivative(&self, half: f64) -> Self {
        let mut row = [0.0; NODES];
        for j in (0..DEGREE).rev() {
            let beyond = row.get(j + 2).copied().unwrap_or(0.0);
            #[allow(clippy::cast_precision_loss)]
            let slope = 2.0 * (j + 1) as f64 * self.0[j + 1] / half;
            row[j] = beyond + slope;
        }
        row[0] *= 0.5;
        Self(row)
    }

    /// The integral over the whole of an interval of this half width (Clenshaw and Curtis).
    pub(crate) fn total(&self, half: f64) -> f64 {
        let term = |(j, c): (usize, &f64)| {
            #[allow(clippy::cast_precision_loss)]
            let below = 1.0 - (j * j) as f64;
            2.0 * c / below
        };
        half * self.0.iter().enumerate().step_by(2).map(term).sum::<f64>()
    }

    /// The size of the last two coefficients: what the next ones are not expected to exceed together.
    pub(crate) fn tail(&self) -> f64 {
        self.0[DEGREE - 1].abs() + self.0[DEGREE].abs()
    }

    /// Of `T_0`, ..., `T_16`.
    pub(crate) fn coefficients(&self) -> &Row {
        &self.0
    }
}

/// In four sums, which the processor adds side by side.
#[inline(always)]
fn product(a: &Row, b: &Row) -> f64 {
    let mut sums = [0.0; 4];
    for (x, y) in a.chunks_exact(4).zip(b.chunks_exact(4)) {
        for (sum, (x, y)) in sums.iter_mut().zip(x.iter().zip(y)) {
            *sum += x * y;
        }
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + a[DEGREE] * b[DEGREE]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sampled(f: impl Fn(f64) -> f64, from: f64, to: f64) -> Interpolant {
        Interpolant::through(&nodes(from, to).map(f))
    }

    #[test]
    fn smooth_functions_are_met_between_the_samples() {
        let f = sampled(libm::exp, 0.25, 0.75);
        for k in 0..=50 {
            let t = f64::from(k) / 25.0 - 1.0;
            let exact = libm::exp(0.5 + 0.25 * t);
            let off = (f.at(&basis(t)) - exact).abs();
            assert!(off < 1e-15 * exact, "t = {t}: {off:e}");
        }
        assert!(f.tail() < 1e-15);
        // A function with a corner leaves a tail.
        assert!(sampled(|x| (x - 0.4).abs(), 0.0, 1.0).tail() > 1e-4);
    }

    #[test]
    fn values_side_by_side_have_the_bits_of_single_ones() {
        let f = sampled(|x| libm::sin(3.0 * x) / (1.0 + x), 0.0, 1.0);
        let t: [f64; 8] = std::array::from_fn(|k| libm::sin(k as f64 * 0.7));
        let all = f.at_each(&bases(t));
        assert!(
            t.iter()
                .zip(all)
                .all(|(t, value)| f.at(&basis(*t)) == value)
        );
        assert_ne!(all[0], all[1]);
    }

    #[test]
    fn integrals_and_derivatives_are_those_of_the_function() {
        let (from, to, half) = (0.25, 1.25, 0.5);
        let f = sampled(libm::sin, from, to);
        let integral = f.integral(half, -libm::cos(from));
        let slope = f.derivative(half);
        for k in 0..=20 {
            let t = f64::from(k) / 10.0 - 1.0;
            let x = 0.75 + half * t;
            assert!((integral.at(&basis(t)) + libm::cos(x)).abs() < 1e-15);
            assert!((slope.at(&basis(t)) - libm::cos(x)).abs() < 1e-12);
        }
        assert!((f.total(half) - (libm::cos(from) - libm::cos(to))).abs() < 1e-15);
    }
}
