//! Basis rows at many parameters.

use super::wide::widest;
use crate::basis::Basis;
use crate::error::Result;

/// The basis functions of one degree at many parameters, row by row.
///
/// ```
/// use torse_geometry::{Gbt, batch::BasisTable};
/// let table = BasisTable::new(&Gbt::new(0.5, 0.5)?, 3, &[0.0, 0.5, 1.0])?;
/// assert_eq!((table.width(), table.len()), (4, 3));
/// assert_eq!(table.row(0), Some(&[1.0, 0.0, 0.0, 0.0][..]));
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct BasisTable {
    pub(super) width: usize,
    pub(super) values: Vec<f64>,
}

impl BasisTable {
    /// The table of `basis` of this degree at the parameters `xs`.
    ///
    /// # Errors
    /// [`GeometryError::OutOfRange`](crate::GeometryError::OutOfRange) for degree zero; the errors of the basis.
    pub fn new<B: Basis<f64>>(basis: &B, degree: usize, xs: &[f64]) -> Result<Self> {
        let width = degree + 1;
        let mut values = vec![0.0; width * xs.len()];
        for (x, row) in xs.iter().zip(values.chunks_exact_mut(width)) {
            basis.row_into(x, row)?;
        }
        Ok(Self { width, values })
    }

    /// The number of basis functions, the degree plus one.
    #[must_use]
    pub fn width(&self) -> usize {
        self.width
    }

    /// The number of parameters.
    #[must_use]
    pub fn len(&self) -> usize {
        self.values.len() / self.width.max(1)
    }

    /// Whether there are no parameters.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// The basis functions at parameter `index`.
    #[must_use]
    pub fn row(&self, index: usize) -> Option<&[f64]> {
        self.values.chunks_exact(self.width.max(1)).nth(index)
    }

    /// The points `out[j] = sum_i row_j[i] points[i]`.
    pub(super) fn combine_into(&self, points: &[[f64; 3]], out: &mut [[f64; 3]]) {
        for (row, slot) in self.values.chunks_exact(self.width.max(1)).zip(out) {
            *slot = crate::vector::combine(row, points).unwrap_or([0.0; 3]);
        }
    }

    /// [`BasisTable::combine_into`] for four lists of points, into the four equal parts of `out`, with the
    /// same values: each weight is fetched once, and the twelve coordinates of the four sums fill whole
    /// vector registers.
    pub(super) fn combine_four_into(&self, lists: [&[[f64; 3]]; 4], out: &mut [[f64; 3]]) {
        match self.width {
            2 => combine_four::<2>(&self.values, lists, out),
            3 => combine_four::<3>(&self.values, lists, out),
            4 => combine_four::<4>(&self.values, lists, out),
            5 => combine_four::<5>(&self.values, lists, out),
            6 => combine_four::<6>(&self.values, lists, out),
            7 => combine_four::<7>(&self.values, lists, out),
            8 => combine_four::<8>(&self.values, lists, out),
            _ => {
                for (points, part) in lists.iter().zip(out.chunks_mut(self.len().max(1))) {
                    self.combine_into(points, part);
                }
            }
        }
    }
}

/// The inner loop with `N` control points known at compile time.
fn combine_four<const N: usize>(rows: &[f64], lists: [&[[f64; 3]]; 4], out: &mut [[f64; 3]]) {
    let [Some((a, _)), Some((b, _)), Some((c, _)), Some((d, _))] =
        lists.map(<[[f64; 3]]>::split_first_chunk::<N>)
    else {
        return;
    };
    // Odd points turned by one coordinate: then pairs that are stored together lie together.
    let points: [[f64; 12]; N] = std::array::from_fn(|j| {
        let ([ax, ay, az], [bx, by, bz], [cx, cy, cz], [dx, dy, dz]) = (a[j], b[j], c[j], d[j]);
        [ax, ay, az, bz, bx, by, cx, cy, cz, dz, dx, dy]
    });
    let (rows, _) = rows.as_chunks::<N>();
    let (a, rest) = out.split_at_mut(rows.len().min(out.len()));
    let (b, rest) = rest.split_at_mut(rows.len().min(rest.len()));
    let (c, d) = rest.split_at_mut(rows.len().min(rest.len()));
    widest(
        #[inline(always)]
        || {
            for ((((a, b), c), d), row) in a.iter_mut().zip(b).zip(c).zip(d).zip(rows) {
                let [ax, ay, az, bz, bx, by, cx, cy, cz, dz, dx, dy] = weighted(row, &points);
                (*a, *b, *c, *d) = ([ax, ay, az], [bx, by, bz], [cx, cy, cz], [dx, dy, dz]);
            }
        },
    );
}

/// `sum_j weights[j] points[j]`, added up in the order of the points like [`crate::vector::combine`].
#[inline(always)]
fn weighted<const N: usize, const D: usize>(
    weights: &[f64; N],
    points: &[[f64; D]; N],
) -> [f64; D] {
    let mut sum = [0.0; D];
    for j in 0..N {
        for axis in 0..D {
            let term = weights[j] * points[j][axis];
            sum[axis] = if j == 0 { term } else { sum[axis] + term };
        }
    }
    sum
}
