//! Basis families by their seeds.
//!
//! A family is three *seeds* `g0, g1, g2` of degree two with sum one. The basis of degree `k` is the
//! Bernstein blend of the seeds,
//!
//! ```text
//! g[i,k](x) = (1 - x) g[i,k-1](x) + x g[i-1,k-1](x)            (k >= 3)
//! sum_i g[i,k](x) R[i] = ((1-x) + x E)^(k-2) (g0 + g1 E + g2 E^2) R[0],   E the index shift
//! ```
//!
//! (gbt-developable eq. (2.1), gbt-surfaces eq. (2)), so a curve of degree `k` is a Bernstein curve of
//! degree `k-2` of local quadratics. Degree one is the linear Bernstein basis for every family
//! (gbt-surfaces eq. (10)).
//!
//! Derivatives come from the same recursion on truncated Taylor series: with `c[n]` the n-th Taylor
//! coefficient at `x`,
//!
//! ```text
//! c[n][i,k] = (1-x) c[n][i,k-1] + x c[n][i-1,k-1] + c[n-1][i-1,k-1] - c[n-1][i,k-1].
//! ```

mod bernstein;
mod gbt;
pub mod hermite;
mod shape;

pub use bernstein::Bernstein;
pub use gbt::Gbt;
pub use shape::BasisShape;

use crate::coordinate::{Coordinate, check_finite};
use crate::error::{GeometryError, Result, count};
use torse_algebra::{ExactError, Jet};

/// A basis family: three seeds of degree two, and by the blend every degree.
///
/// Implement [`seeds`](Basis::seeds), [`seed_jets`](Basis::seed_jets) and
/// [`reversed`](Basis::reversed) for a new family; curves, surfaces, plane families and joins then
/// work on it.
///
/// ```
/// use torse_geometry::{Basis, Gbt};
/// let gbt = Gbt::new(0.5, -0.25)?;
/// let row = gbt.row(4, &0.3)?;
/// assert_eq!(row.len(), 5);
/// assert!((row.iter().sum::<f64>() - 1.0).abs() < 1e-15);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
///
/// A family of one's own, of every degree and with all derivatives from its seeds:
///
/// ```
/// use torse_algebra::{ExactError, Jet, rational::{integer, ratio}};
/// use torse_geometry::{Basis, Coordinate, Curve};
/// /// Seeds `(1-x)^3, 3x(1-x), x^3`, steeper at the ends than Bernstein's.
/// #[derive(Debug, Clone)]
/// struct Steep;
/// fn steep<S: torse_algebra::Scalar>(x: &S) -> [S; 3] {
///     let y = x.one_like() - x.clone();
///     let cube = |t: &S| t.clone() * t.clone() * t.clone();
///     let mixed = x.clone() * y.clone();
///     [cube(&y), mixed.clone() + mixed.clone() + mixed, cube(x)]
/// }
/// impl<S: Coordinate> Basis<S> for Steep {
///     fn seeds(&self, x: &S) -> Result<[S; 3], ExactError> {
///         Ok(steep(x))
///     }
///     fn seed_jets(&self, x: &S, order: usize) -> Result<[Jet<S>; 3], ExactError> {
///         Ok(steep(&Jet::variable(x.clone(), order)))
///     }
///     fn reversed(&self) -> Self {
///         Steep
///     }
/// }
/// let curve = Curve::new(Steep, [0, 1, 1, 0].map(|n| [integer(n)]).to_vec())?;
/// // In the middle the first and the last of the four functions are 1/2 times 1/8 each.
/// assert_eq!(curve.point(&ratio(1, 2).unwrap())?, [ratio(7, 8).unwrap()]);
/// assert_eq!(curve.derivatives(&ratio(1, 2).unwrap(), 1)?[1], [integer(0)]);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub trait Basis<S: Coordinate>: Clone + std::fmt::Debug + Send + Sync {
    /// The seeds `[g0, g1, g2]` at `x` in [0, 1].
    ///
    /// # Errors
    /// [`ExactError`] where the seeds are not numbers of this kind at `x`.
    fn seeds(&self, x: &S) -> Result<[S; 3], ExactError>;

    /// The seeds at all `xs`, one column for each seed, as far as the columns reach.
    ///
    /// # Errors
    /// As [`Basis::seeds`].
    #[inline(always)]
    fn seed_columns(&self, xs: &[S], columns: [&mut [S]; 3]) -> Result<(), ExactError> {
        let [first, second, third] = columns;
        for (((x, g0), g1), g2) in xs.iter().zip(first).zip(second).zip(third) {
            [*g0, *g1, *g2] = self.seeds(x)?;
        }
        Ok(())
    }

    /// The seeds and their first derivatives at all `xs`, one column for each, as far as the columns reach.
    ///
    /// # Errors
    /// As [`Basis::seed_slopes`].
    #[inline(always)]
    fn seed_and_slope_columns(
        &self,
        xs: &[S],
        columns: [&mut [S]; 3],
        slopes: [&mut [S]; 3],
    ) -> Result<()> {
        let [first, second, third] = slopes;
        for (((x, d0), d1), d2) in xs.iter().zip(first).zip(second).zip(third) {
            [*d0, *d1, *d2] = self.seed_slopes(x)?;
        }
        Ok(self.seed_columns(xs, columns)?)
    }

    /// The Taylor series of the seeds at `x` to this order.
    ///
    /// # Errors
    /// As [`Basis::seeds`].
    fn seed_jets(&self, x: &S, order: usize) -> Result<[Jet<S>; 3], ExactError>;

    /// Whether these are the Bernstein polynomials of every degree, so that derivatives of curves are curves of the
    /// differences of their control points.
    #[must_use]
    fn is_bernstein(&self) -> bool {
        false
    }

    /// The family whose basis functions at `x` are these at `1 - x` in reversed order.
    #[must_use]
    fn reversed(&self) -> Self;

    /// The `degree + 1` basis functions at `x`.
    ///
    /// # Errors
    /// [`GeometryError::OutOfRange`] for degree zero and beyond [`MAX_DEGREE`],
    /// [`GeometryError::NotFinite`] at NaN and infinity, [`GeometryError::Exact`] from the seeds.
    ///
    /// ```
    /// use torse_geometry::{Basis, Bernstein};
    /// assert_eq!(Bernstein.row(0, &0.5).unwrap_err().to_string(), "degree = 0 is outside {1, 2, .., 4096}");
    /// let error = Bernstein.row(2, &f64::NAN).unwrap_err();
    /// assert_eq!(error.to_string(), "curve parameter, entry 0: NaN is not a finite number");
    /// ```
    fn row(&self, degree: usize, x: &S) -> Result<Vec<S>> {
        check_degree(degree)?;
        let mut row = vec![x.zero(); degree + 1];
        self.row_into(x, &mut row)?;
        Ok(row)
    }

    /// The basis functions at `x` into the caller's buffer, whose length is the degree plus one.
    ///
    /// # Errors
    /// As [`Basis::row`].
    fn row_into(&self, x: &S, row: &mut [S]) -> Result<()> {
        check_parameter(x)?;
        blend(row, x, || Ok(self.seeds(x)?))
    }

    /// The first derivatives of the seeds at `x`.
    ///
    /// # Errors
    /// [`GeometryError::Exact`] from the seeds, [`GeometryError::LengthMismatch`] where their series are shorter than
    /// asked for.
    fn seed_slopes(&self, x: &S) -> Result<[S; 3]> {
        let [first, second, third] = seed_series(self, x, 1)?;
        let slope = |g: Jet<S>| {
            g.coefficients()
                .get(1)
                .cloned()
                .ok_or_else(|| short(0, 2, 1))
        };
        Ok([slope(first)?, slope(second)?, slope(third)?])
    }

    /// The basis functions and their first derivatives at `x` into the caller's buffers of equal length:
    /// with `T = (1-x) + x E`,
    /// `d/dx T^(k-2) g = (k-2) (E - 1) T^(k-3) g + T^(k-2) g'`.
    ///
    /// # Errors
    /// As [`Basis::row`], and [`GeometryError::LengthMismatch`] when the lengths differ.
    ///
    /// ```
    /// use torse_geometry::{Basis, Gbt};
    /// let gbt = Gbt::new(0.5, -0.25)?;
    /// let (mut row, mut slope) = ([0.0; 6], [0.0; 6]);
    /// gbt.row_and_slope_into(&0.3, &mut row, &mut slope)?;
    /// let rows = gbt.derivative_rows(5, &0.3, 1)?;
    /// assert!((0..6).all(|i| (row[i] - rows[0][i]).abs() + (slope[i] - rows[1][i]).abs() < 1e-14));
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    fn row_and_slope_into(&self, x: &S, row: &mut [S], slope: &mut [S]) -> Result<()> {
        if row.len() != slope.len() {
            let (expected, given) = (row.len(), slope.len());
            let what = "buffer for derivatives";
            return Err(GeometryError::LengthMismatch {
                what,
                index: 0,
                expected,
                given,
            });
        }
        check_parameter(x)?;
        blend_with_slopes([row, slope], x, || {
            Ok([self.seeds(x)?, self.seed_slopes(x)?])
        })
    }

    /// The derivative rows at `x`: entry `[n][i]` is the n-th derivative of basis function `i`.
    ///
    /// # Errors
    /// As [`Basis::row`].
    ///
    /// ```
    /// use torse_geometry::{Basis, Gbt};
    /// // gbt-developable eq. (3.11): H'(0) = (k - 2 + pi/2 (1 + mu)) (Q1 - Q0).
    /// let rows = Gbt::new(0.5, 0.0)?.derivative_rows(5, &0.0, 1)?;
    /// let slope = 3.0 + std::f64::consts::FRAC_PI_2 * 1.5;
    /// assert!((rows[1][1] - slope).abs() < 1e-14 && (rows[1][0] + slope).abs() < 1e-14);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    fn derivative_rows(&self, degree: usize, x: &S, order: usize) -> Result<Vec<Vec<S>>> {
        let mut rows = self.series_rows(degree, x, order)?;
        let mut factorial = x.one();
        for (n, row) in rows.iter_mut().enumerate().skip(2) {
            factorial = factorial * x.natural(n);
            for entry in row {
                *entry = entry.clone() * factorial.clone();
            }
        }
        Ok(rows)
    }

    /// The Taylor rows at `x`: entry `[n][i]` is the n-th derivative of basis function `i` over `n!`.
    ///
    /// # Errors
    /// As [`Basis::row`].
    fn series_rows(&self, degree: usize, x: &S, order: usize) -> Result<Vec<Vec<S>>> {
        check_degree(degree)?;
        check_order(order)?;
        check_parameter(x)?;
        let one_minus_x = x.one() - x.clone();
        let seeds: Vec<Vec<S>> = match degree {
            1 => {
                let linear = |value: S, slope: S| {
                    let mut series = vec![value, slope];
                    series.resize(order + 1, x.zero());
                    series
                };
                vec![
                    linear(one_minus_x.clone(), -x.one()),
                    linear(x.clone(), x.one()),
                ]
            }
            _ => seed_series(self, x, order)?
                .iter()
                .map(|g| g.coefficients().to_vec())
                .collect(),
        };
        // None is shorter than the order.
        let coefficients = |n: usize| seeds.iter().filter_map(|g| g.get(n).cloned()).collect();
        let mut rows: Vec<Vec<S>> = (0..=order).map(coefficients).collect();
        for _ in 3..=degree {
            // Row n needs the old row n-1: keep it while walking up.
            let mut below: Option<Vec<S>> = None;
            for row in &mut rows {
                let old = std::mem::take(row);
                *row = one_degree_more(&old, below.as_deref(), x);
                below = Some(old);
            }
        }
        Ok(rows)
    }
}

/// The series of the seeds; refuses those that end before `order`, as a family of somebody else may give them: what is
/// not known would count as zero.
fn seed_series<S: Coordinate>(basis: &impl Basis<S>, x: &S, order: usize) -> Result<[Jet<S>; 3]> {
    let jets = basis.seed_jets(x, order)?;
    for (index, jet) in jets.iter().enumerate() {
        if jet.order() < order {
            return Err(short(index, order + 1, jet.order() + 1));
        }
    }
    Ok(jets)
}

fn short(index: usize, expected: usize, given: usize) -> GeometryError {
    GeometryError::LengthMismatch {
        what: "Taylor coefficients of a seed",
        index,
        expected,
        given,
    }
}

/// The n-th Taylor coefficients of the basis of one degree more, `c[n]` from `c[n]` and `c[n-1]` of this degree (the
/// recursion of the module's page); beyond the ends of a row there is no function.
fn one_degree_more<S: Coordinate>(row: &[S], below: Option<&[S]>, x: &S) -> Vec<S> {
    let (one_minus_x, zero) = (x.one() - x.clone(), x.zero());
    let blend = neighbours(row, &zero)
        .map(|(before, here)| one_minus_x.clone() * here.clone() + x.clone() * before.clone());
    match below {
        Some(below) => blend
            .zip(neighbours(below, &zero))
            .map(|(sum, (before, here))| sum + before.clone() - here.clone())
            .collect(),
        None => blend.collect(),
    }
}

/// The pairs of neighbours of a list that has a zero at either end.
fn neighbours<'a, S>(list: &'a [S], zero: &'a S) -> impl Iterator<Item = (&'a S, &'a S)> {
    let end = || std::iter::once(zero);
    end().chain(list).zip(list.iter().chain(end()))
}

/// The basis functions at `x` of the degree of the row, from the seeds: linear ones in degree one, where every
/// family is the same.
#[inline(always)]
pub(crate) fn blend<S: Coordinate>(
    row: &mut [S],
    x: &S,
    seeds: impl FnOnce() -> Result<[S; 3]>,
) -> Result<()> {
    match row {
        [] | [_] => return check_degree(0),
        [first, second] => (*first, *second) = (x.one() - x.clone(), x.clone()),
        [first, second, third, ..] => {
            [*first, *second, *third] = seeds()?;
            raise(row, x);
        }
    }
    Ok(())
}

/// The basis functions at `x` and their first derivatives, from the seeds and those of the seeds; for the
/// formula see [`Basis::row_and_slope_into`]. The rows are of equal length.
#[inline(always)]
pub(crate) fn blend_with_slopes<S: Coordinate>(
    [row, slope]: [&mut [S]; 2],
    x: &S,
    seeds: impl FnOnce() -> Result<[[S; 3]; 2]>,
) -> Result<()> {
    let degree = row.len().saturating_sub(1);
    let ([first, second, third, ..], [first_slope, second_slope, third_slope, ..]) =
        (&mut *row, &mut *slope)
    else {
        if let [first, second] = slope {
            (*first, *second) = (-x.one(), x.one());
        }
        return blend(row, x, || Ok(seeds()?[0].clone()));
    };
    [
        [*first, *second, *third],
        [*first_slope, *second_slope, *third_slope],
    ] = seeds()?;
    // T^(k-2) g' first, by the recursion of the values.
    raise(slope, x);
    if let Some(lower) = row.get_mut(..degree)
        && degree > 2
    {
        raise(lower, x);
        let factor = x.natural(degree - 2);
        let mut below = x.zero();
        for (slot, entry) in slope.iter_mut().zip(lower.iter()) {
            *slot = slot.clone() + factor.clone() * (below - entry.clone());
            below = entry.clone();
        }
        if let Some(last) = slope.last_mut() {
            *last = last.clone() + factor * below;
        }
        raise_once(row, x);
    }
    Ok(())
}

/// From the three seeds in front to the basis of the whole row, degree by degree in place.
#[inline(always)]
fn raise<S: Coordinate>(row: &mut [S], x: &S) {
    for width in 4..=row.len() {
        if let Some(active) = row.get_mut(..width) {
            raise_once(active, x);
        }
    }
}

/// From the basis of one degree less, in all but the last place, to the basis of the row.
#[inline(always)]
fn raise_once<S: Coordinate>(row: &mut [S], x: &S) {
    let [first, rest @ .., last] = row else {
        return;
    };
    let one_minus_x = x.one() - x.clone();
    let mut lower = first.clone();
    *first = one_minus_x.clone() * lower.clone();
    for entry in rest {
        let old = entry.clone();
        *entry = one_minus_x.clone() * old.clone() + x.clone() * lower;
        lower = old;
    }
    *last = x.clone() * lower;
}

/// The largest degree of a curve: the cost of a row grows with the square of the degree.
pub const MAX_DEGREE: usize = 4096;

/// The highest order of derivatives.
pub const MAX_ORDER: usize = 4096;

pub(crate) fn check_degree(degree: usize) -> Result<()> {
    if (1..=MAX_DEGREE).contains(&degree) {
        return Ok(());
    }
    let (name, value, range) = ("degree", count(degree), "{1, 2, .., 4096}");
    Err(GeometryError::OutOfRange { name, value, range })
}

fn check_order(order: usize) -> Result<()> {
    if order <= MAX_ORDER {
        return Ok(());
    }
    let (name, value, range) = ("derivative order", count(order), "{0, 1, .., 4096}");
    Err(GeometryError::OutOfRange { name, value, range })
}

fn check_parameter<S: Coordinate>(x: &S) -> Result<()> {
    check_finite("curve parameter", [x])
}

/// The Bernstein polynomials of any degree, zero included, at `x`.
pub(crate) fn blend_row<S: Coordinate>(degree: usize, x: &S) -> Vec<S> {
    let one_minus_x = x.one() - x.clone();
    let mut row = vec![x.one()];
    for _ in 0..degree {
        let mut lower = x.zero();
        for entry in &mut row {
            let old = entry.clone();
            *entry = one_minus_x.clone() * old.clone() + x.clone() * lower;
            lower = old;
        }
        row.push(x.clone() * lower);
    }
    row
}
