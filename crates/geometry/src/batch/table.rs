//! Basis rows at many parameters.

use crate::basis::Basis;
use crate::error::Result;
use crate::vector::combine;

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

    /// `out[j] = sum_i row_j[i] points[i]` for all rows.
    pub(super) fn combine_into<const D: usize>(&self, points: &[[f64; D]], out: &mut [[f64; D]]) {
        match points.len() {
            2 => combine_rows::<2, D>(&self.values, points, out),
            3 => combine_rows::<3, D>(&self.values, points, out),
            4 => combine_rows::<4, D>(&self.values, points, out),
            5 => combine_rows::<5, D>(&self.values, points, out),
            6 => combine_rows::<6, D>(&self.values, points, out),
            7 => combine_rows::<7, D>(&self.values, points, out),
            8 => combine_rows::<8, D>(&self.values, points, out),
            _ => {
                for (row, slot) in self.values.chunks_exact(self.width.max(1)).zip(out) {
                    *slot = combine(row, points).unwrap_or([0.0; D]);
                }
            }
        }
    }
}

/// The inner loop with `N` control points known at compile time.
fn combine_rows<const N: usize, const D: usize>(
    rows: &[f64],
    points: &[[f64; D]],
    out: &mut [[f64; D]],
) {
    let Some((points, _)) = points.split_first_chunk::<N>() else {
        return;
    };
    let (rows, _) = rows.as_chunks::<N>();
    for (slot, row) in out.iter_mut().zip(rows) {
        let mut sum = [0.0; D];
        for (weight, point) in row.iter().zip(points) {
            for (s, p) in sum.iter_mut().zip(point) {
                *s += weight * p;
            }
        }
        *slot = sum;
    }
}
