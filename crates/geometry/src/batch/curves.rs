//! Curves, plane families and rulings at many parameters.
//!
//! The parameters go in blocks: first the seeds of the basis, column by column; then whole vector registers of
//! parameters through the same functions as a single one (see `lanes`): the blend to the degree of the curve and the
//! sum over the control points, which stay in registers for the usual degrees.

use super::check_length;
use super::lanes::Lanes;
use super::registers::{Arch, Simd, WithSimd};
use crate::basis::{Basis, blend, blend_with_slopes};
use crate::coordinate::check_finite;
use crate::curve::Curve;
use crate::error::Result;
use crate::parallel::prelude::*;
use crate::planes::{Plane, PlaneFamily, Ruling, ruling_of};
use crate::vector::blended;

/// Parameters of a block: one column of values is a quarter of a kilobyte.
const BLOCK: usize = 32;

/// Parameters that one thread takes at a time; below this starting threads costs more than it gains.
const SHARE: usize = 256 * BLOCK;

/// One number for each parameter of a block.
type Column = [f64; BLOCK];

/// Whole blocks of parameters, and what is left as a block with zeros behind.
fn blocks(xs: &[f64]) -> (&[Column], Option<Column>) {
    let (whole, rest) = xs.as_chunks();
    let filled = || std::array::from_fn(|p| rest.get(p).copied().unwrap_or(0.0));
    (whole, (!rest.is_empty()).then(filled))
}

#[inline(always)]
fn all_finite(column: &Column) -> bool {
    column.iter().fold(true, |all, x| all & x.is_finite())
}

/// Three columns at register `index`.
#[inline(always)]
fn three<V: Simd>(simd: V, columns: &[Column; 3], index: usize) -> [Lanes<V>; 3] {
    columns.each_ref().map(
        #[inline(always)]
        |c| Lanes::load(simd, c, index),
    )
}

/// The points of a curve, or the rulings of a family, and the parameters that they are asked for.
struct Job<'a, C, T> {
    of: &'a C,
    xs: &'a [f64],
    out: &'a mut [T],
}

/// The points in all lanes.
#[inline(always)]
fn spread<V: Simd, const N: usize, const D: usize>(
    simd: V,
    points: &[[f64; D]; N],
) -> [[Lanes<V>; D]; N] {
    points.map(
        #[inline(always)]
        |p| {
            p.map(
                #[inline(always)]
                |c| Lanes::all(simd, c),
            )
        },
    )
}

impl<B: Basis<f64>, const D: usize> WithSimd for Job<'_, Curve<B, f64, D>, [f64; D]> {
    type Output = Result<()>;

    /// With rows of a length that the compiler knows for the usual degrees.
    #[inline(always)]
    fn with_simd<V: Simd>(self, simd: V) -> Result<()> {
        let points = self.of.points();
        let zero = Lanes::all(simd, 0.0);
        if let [a, b, c, d] = points {
            self.run(simd, &spread(simd, &[*a, *b, *c, *d]), &mut [zero; 4])
        } else {
            let points: Vec<_> = points
                .iter()
                .map(|p| p.map(|c| Lanes::all(simd, c)))
                .collect();
            let mut row = vec![zero; points.len()];
            self.run(simd, &points, &mut row)
        }
    }
}

impl<B: Basis<f64>, const D: usize> Job<'_, Curve<B, f64, D>, [f64; D]> {
    #[inline(always)]
    fn run<V: Simd>(self, simd: V, points: &[[Lanes<V>; D]], row: &mut [Lanes<V>]) -> Result<()> {
        let (mut seeds, mut sums) = ([[0.0; BLOCK]; 3], [[0.0; BLOCK]; D]);
        let (whole, last) = blocks(self.xs);
        for (block, out) in whole.iter().chain(&last).zip(self.out.chunks_mut(BLOCK)) {
            if !all_finite(block) {
                return check_finite("curve parameter", self.xs);
            }
            self.of
                .basis()
                .seed_columns(block, seeds.each_mut().map(|g| g.as_mut_slice()))?;
            for i in 0..BLOCK / V::F64_LANES {
                let x = Lanes::load(simd, block, i);
                blend(
                    row,
                    &x,
                    #[inline(always)]
                    || Ok(three(simd, &seeds, i)),
                )?;
                let point = blended(row, points)?;
                for (sum, coordinate) in sums.iter_mut().zip(point) {
                    coordinate.store(sum, i);
                }
            }
            for (p, slot) in out.iter_mut().enumerate() {
                *slot = std::array::from_fn(|axis| sums[axis][p]);
            }
        }
        Ok(())
    }
}

impl<B: Basis<f64>> WithSimd for Job<'_, PlaneFamily<B, f64>, Ruling<f64>> {
    type Output = Result<()>;

    /// With rows of a length that the compiler knows for the usual degrees.
    #[inline(always)]
    fn with_simd<V: Simd>(self, simd: V) -> Result<()> {
        let points = self.of.unit_curve().0.points();
        let zero = Lanes::all(simd, 0.0);
        if let [a, b, c, d] = points {
            let points = spread(simd, &[*a, *b, *c, *d]);
            self.run(simd, &points, [&mut [zero; 4], &mut [zero; 4]])
        } else {
            let points: Vec<_> = points
                .iter()
                .map(|p| p.map(|c| Lanes::all(simd, c)))
                .collect();
            let mut rows = [vec![zero; points.len()], vec![zero; points.len()]];
            self.run(simd, &points, rows.each_mut().map(Vec::as_mut_slice))
        }
    }
}

impl<B: Basis<f64>> Job<'_, PlaneFamily<B, f64>, Ruling<f64>> {
    #[inline(always)]
    fn run<V: Simd>(
        self,
        simd: V,
        points: &[Plane<Lanes<V>>],
        [row, slope]: [&mut [Lanes<V>]; 2],
    ) -> Result<()> {
        let (curve, exponent) = self.of.unit_curve();
        let (mut seeds, mut slopes) = ([[0.0; BLOCK]; 3], [[0.0; BLOCK]; 3]);
        let mut columns = [[0.0; BLOCK]; 9];
        let (whole, last) = blocks(self.xs);
        for (block, out) in whole.iter().chain(&last).zip(self.out.chunks_mut(BLOCK)) {
            if !all_finite(block) {
                return check_finite("curve parameter", self.xs);
            }
            curve.basis().seed_and_slope_columns(
                block,
                seeds.each_mut().map(|g| g.as_mut_slice()),
                slopes.each_mut().map(|d| d.as_mut_slice()),
            )?;
            for i in 0..BLOCK / V::F64_LANES {
                let x = Lanes::load(simd, block, i);
                blend_with_slopes(
                    [row, slope],
                    &x,
                    #[inline(always)]
                    || Ok([three(simd, &seeds, i), three(simd, &slopes, i)]),
                )?;
                let plane = blended(row, points)?;
                let change = blended(slope, points)?;
                let ruling = ruling_of(&plane, &change)?.of_planes_times_two_to(exponent);
                for (column, coordinate) in columns.iter_mut().zip(ruling.coordinates()) {
                    coordinate.store(column, i);
                }
            }
            if columns.iter().fold(true, |all, c| all & all_finite(c)) {
                for (p, slot) in out.iter_mut().enumerate() {
                    let at = |first: usize| std::array::from_fn(|axis| columns[first + axis][p]);
                    *slot = Ruling {
                        direction: at(0),
                        moment: at(3),
                        foot: at(6),
                    };
                }
            } else {
                // Somewhere there is no ruling, or it leaves the range of f64: one by one.
                for (x, slot) in block.iter().zip(out) {
                    *slot = self.of.ruling(x)?;
                }
            }
        }
        Ok(())
    }
}

impl<B: Basis<f64>, const D: usize> Curve<B, f64, D> {
    /// The points at all parameters `xs`, into `out` of the same length.
    ///
    /// # Errors
    /// [`GeometryError::LengthMismatch`](crate::GeometryError::LengthMismatch) when the lengths differ,
    /// [`GeometryError::NotFinite`](crate::GeometryError::NotFinite) for a parameter that is NaN or infinite; what was
    /// computed before it stands in `out`.
    ///
    /// ```
    /// use torse_geometry::{Curve, Gbt};
    /// let curve = Curve::new(Gbt::new(0.3, 0.9)?, vec![[0.0, 1.0], [2.0, 3.0], [5.0, 1.0], [6.0, 0.0]])?;
    /// let xs: Vec<f64> = (0..1000).map(|i| f64::from(i) / 999.0).collect();
    /// let mut out = vec![[0.0; 2]; xs.len()];
    /// curve.points_into(&xs, &mut out)?;
    /// assert_eq!(out[321], curve.point(&xs[321])?);
    /// let error = curve.points_into(&xs[..7], &mut out).unwrap_err();
    /// assert_eq!(error.to_string(), "output buffer: entry 0 has 1000 elements, expected 7");
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn points_into(&self, xs: &[f64], out: &mut [[f64; D]]) -> Result<()> {
        check_length("output buffer", xs.len(), out.len())?;
        Arch::new().dispatch(Job { of: self, xs, out })
    }

    /// [`Curve::points_into`] with the parameters shared among threads; the same values.
    ///
    /// # Errors
    /// As [`Curve::points_into`].
    ///
    /// ```
    /// use torse_geometry::{Curve, Gbt};
    /// let curve = Curve::new(Gbt::new(0.3, 0.9)?, vec![[0.0, 1.0], [2.0, 3.0], [5.0, 1.0], [6.0, 0.0]])?;
    /// let xs: Vec<f64> = (0..20_000).map(|i| f64::from(i) / 19_999.0).collect();
    /// let (mut one, mut many) = (vec![[0.0; 2]; xs.len()], vec![[1.0; 2]; xs.len()]);
    /// curve.points_into(&xs, &mut one)?;
    /// curve.par_points_into(&xs, &mut many)?;
    /// assert_eq!(one, many);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn par_points_into(&self, xs: &[f64], out: &mut [[f64; D]]) -> Result<()>
    where
        B: Sync,
    {
        shared(xs, out, |xs, out| self.points_into(xs, out))
    }
}

impl<B: Basis<f64>> PlaneFamily<B, f64> {
    /// The rulings at all parameters `xs`, into `out` of the same length.
    ///
    /// # Errors
    /// As [`Curve::points_into`]; [`GeometryError::NoRuling`](crate::GeometryError::NoRuling) where there is none.
    ///
    /// ```
    /// use torse_geometry::{Gbt, PlaneFamily};
    /// let planes = vec![[1., 0., 0.2, 3.], [0.5, 1., 0.1, 2.], [0., 1., 0.5, 4.], [-1., 0.3, 0.1, 5.]];
    /// let family = PlaneFamily::new(Gbt::new(0.5, 0.5)?, planes)?;
    /// let xs = [0.1, 0.2, 0.7];
    /// let mut out = vec![family.ruling(&0.0)?; 3];
    /// family.rulings_into(&xs, &mut out)?;
    /// for (x, ruling) in xs.iter().zip(&out) {
    ///     assert_eq!(family.ruling(x)?, *ruling);
    /// }
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn rulings_into(&self, xs: &[f64], out: &mut [Ruling<f64>]) -> Result<()> {
        check_length("output buffer", xs.len(), out.len())?;
        Arch::new().dispatch(Job { of: self, xs, out })
    }

    /// [`PlaneFamily::rulings_into`] with the parameters shared among threads; the same values.
    ///
    /// # Errors
    /// As [`PlaneFamily::rulings_into`], and the same error on every run.
    pub fn par_rulings_into(&self, xs: &[f64], out: &mut [Ruling<f64>]) -> Result<()>
    where
        B: Sync,
    {
        shared(xs, out, |xs, out| self.rulings_into(xs, out))
    }
}

/// Runs `fill` on shares of the parameters, on all threads.
fn shared<T: Send>(
    xs: &[f64],
    out: &mut [T],
    fill: impl Fn(&[f64], &mut [T]) -> Result<()> + Sync,
) -> Result<()> {
    check_length("output buffer", xs.len(), out.len())?;
    let shares = xs.par_chunks(SHARE).zip(out.par_chunks_mut(SHARE));
    match shares.try_for_each(|(xs, out)| fill(xs, out)) {
        Ok(()) => Ok(()),
        // Whichever thread failed first: the serial run names the first place.
        Err(_) => fill(xs, out),
    }
}
