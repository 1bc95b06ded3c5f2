//! Tensor-product surfaces.

use super::{Partials, Surface};
use crate::basis::Basis;
use crate::coordinate::{Coordinate, check_finite};
use crate::curve::Curve;
use crate::error::{GeometryError, Result};
use crate::vector::{blended, lerp};

/// The surface `T(u, v) = sum_k sum_l Q[k][l] f[k,m](u) f[l,n](v)` (gbt-surfaces eq. (7)), with its own
/// basis family in each direction.
///
/// ```
/// use torse_geometry::{Gbt, Surface, TensorSurface};
/// let net = (0..4).map(|k| (0..3).map(|l| [f64::from(k), f64::from(l), f64::from(k * l)]).collect()).collect();
/// let surface = TensorSurface::new(Gbt::new(0.5, -0.5)?, Gbt::new(1.0, 0.0)?, net)?;
/// assert_eq!(surface.degrees(), (3, 2));
/// assert_eq!(surface.point(&1.0, &1.0)?, [3.0, 2.0, 6.0]);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct TensorSurface<U, V, S> {
    u: U,
    v: V,
    /// Control points, `v` running fastest.
    net: Vec<[S; 3]>,
    columns: usize,
}

impl<S: Coordinate, U: Basis<S>, V: Basis<S>> TensorSurface<U, V, S> {
    /// The surface with the control net `net[k][l]`, `k` in the direction of `u`.
    ///
    /// # Errors
    /// [`GeometryError::TooFew`] for fewer than two rows or columns, [`GeometryError::LengthMismatch`]
    /// for a ragged net, [`GeometryError::NotFinite`].
    ///
    /// ```
    /// use torse_geometry::{Bernstein, TensorSurface};
    /// let ragged = vec![vec![[0.0; 3], [1.0; 3]], vec![[0.0; 3]]];
    /// let error = TensorSurface::new(Bernstein, Bernstein, ragged).unwrap_err();
    /// assert_eq!(error.to_string(), "control net row: entry 1 has 1 elements, expected 2");
    /// ```
    pub fn new(u: U, v: V, net: Vec<Vec<[S; 3]>>) -> Result<Self> {
        let columns = net.first().map_or(0, Vec::len);
        if net.len() < 2 || columns < 2 {
            let given = net.len().min(columns);
            return Err(GeometryError::TooFew {
                what: "rows and columns of the control net",
                needed: 2,
                given,
            });
        }
        if let Some((index, row)) = net.iter().enumerate().find(|(_, row)| row.len() != columns) {
            return Err(GeometryError::LengthMismatch {
                what: "control net row",
                index,
                expected: columns,
                given: row.len(),
            });
        }
        crate::basis::check_degree(net.len() - 1)?;
        crate::basis::check_degree(columns - 1)?;
        let net: Vec<[S; 3]> = net.into_iter().flatten().collect();
        check_finite("control point", net.iter().flatten())?;
        Ok(Self { u, v, net, columns })
    }

    /// The degrees `(m, n)` in `u` and `v`.
    #[must_use]
    pub fn degrees(&self) -> (usize, usize) {
        (
            self.rows().count().saturating_sub(1),
            self.columns.saturating_sub(1),
        )
    }

    /// The basis families in `u` and `v`.
    #[must_use]
    pub fn bases(&self) -> (&U, &V) {
        (&self.u, &self.v)
    }

    /// The rows of the control net; row `k` holds `Q[k][0], .., Q[k][n]`.
    pub fn rows(&self) -> impl ExactSizeIterator<Item = &[[S; 3]]> {
        self.net.chunks(self.columns.max(1))
    }

    /// The boundary curve `v = 0` (or `v = 1` with `index = n`): the curve of control column `index`.
    ///
    /// # Errors
    /// [`GeometryError::TooFew`] when there is no such column.
    pub fn column_curve(&self, index: usize) -> Result<Curve<U, S, 3>> {
        let points = self
            .rows()
            .filter_map(|row| row.get(index).cloned())
            .collect();
        Curve::new(self.u.clone(), points)
    }

    /// The control points of the curve `T(u, .)`.
    pub(crate) fn combined(&self, row: &[S]) -> Result<Vec<[S; 3]>> {
        (0..self.columns)
            .map(|l| {
                let column: Vec<[S; 3]> = self.rows().filter_map(|r| r.get(l).cloned()).collect();
                blended(row, &column)
            })
            .collect()
    }

    /// The surface whose control points are the images of these: for an affine map the image surface.
    #[must_use]
    pub fn mapped(&self, map: impl Fn(&[S; 3]) -> [S; 3]) -> Self {
        Self {
            net: self.net.iter().map(map).collect(),
            ..self.clone()
        }
    }

    /// The bi-linear net over four corners, `corners = [[Q00, Q0n], [Qm0, Qmn]]`, whose boundary
    /// points divide the edges equally (gbt-surfaces Algorithm 2), with the given interior points
    /// (row by row, `(m - 1)(n - 1)` of them).
    ///
    /// # Errors
    /// [`GeometryError::LengthMismatch`] when the interior has another size,
    /// [`GeometryError::OutOfRange`] for degree zero, and as [`TensorSurface::new`].
    ///
    /// ```
    /// use torse_geometry::{Gbt, Surface, TensorSurface};
    /// // gbt-surfaces Example 3.2. Printed Q[3][1] = (3, 2, 0) is not the third of its edge, which is
    /// // (3, 1, 0): the equal division of Algorithm 2 gives the corrected point.
    /// let corners = [[[0.0, 0.0, 0.0], [0.0, 3.0, 0.0]], [[3.0, 0.0, 0.0], [3.0, 3.0, 0.0]]];
    /// let interior = [[1.0, 1.0, 3.0], [1.0, 2.0, 3.0], [2.0, 1.0, 3.0], [2.0, 2.0, 3.0]];
    /// let gbt = Gbt::new(0.5, 0.5)?;
    /// let surface = TensorSurface::bilinear(gbt, gbt, (3, 3), &corners, &interior)?;
    /// let row: Vec<_> = surface.rows().nth(3).unwrap().to_vec();
    /// assert!((row[1][1] - 1.0).abs() < 1e-15 && (row[2][1] - 2.0).abs() < 1e-15);
    /// // The boundary is straight: with equal thirds it is even the segment itself.
    /// assert_eq!(surface.point(&0.3, &0.0)?[1..], [0.0, 0.0]);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn bilinear(
        u: U,
        v: V,
        (m, n): (usize, usize),
        corners: &[[[S; 3]; 2]; 2],
        interior: &[[S; 3]],
    ) -> Result<Self> {
        crate::basis::check_degree(m)?;
        crate::basis::check_degree(n)?;
        let expected = (m - 1) * (n - 1);
        if interior.len() != expected {
            let (what, given) = ("interior control points", interior.len());
            return Err(GeometryError::LengthMismatch {
                what,
                index: 0,
                expected,
                given,
            });
        }
        let [[q00, q0n], [qm0, qmn]] = corners;
        let like = &q00[0];
        let part = |k: usize, of: usize| like.natural(k).divided_by(&like.natural(of));
        let mut free = interior.iter().cloned();
        let mut net = Vec::with_capacity(m + 1);
        for k in 0..=m {
            let t = part(k, m)?;
            let (left, right) = (lerp(q00, qm0, &t), lerp(q0n, qmn, &t));
            let mut row = Vec::with_capacity(n + 1);
            for l in 0..=n {
                if k == 0 || k == m || l == 0 || l == n {
                    row.push(lerp(&left, &right, &part(l, n)?));
                } else {
                    row.extend(free.next());
                }
            }
            net.push(row);
        }
        Self::new(u, v, net)
    }
}

impl<S: Coordinate, U: Basis<S>, V: Basis<S>> Surface<S> for TensorSurface<U, V, S> {
    fn partials(&self, u: &S, v: &S, order: usize) -> Result<Partials<S>> {
        let (m, n) = self.degrees();
        let by_u = self.u.derivative_rows(m, u, order)?;
        let by_v = self.v.derivative_rows(n, v, order)?;
        let curves = by_u.iter().map(|row| self.combined(row));
        let curves: Vec<Vec<[S; 3]>> = curves.collect::<Result<_>>()?;
        Partials::try_from_fn(order, |i, j| match curves.get(i).zip(by_v.get(j)) {
            Some((points, row)) => blended(row, points),
            None => Err(GeometryError::TooFew {
                what: "rows of basis functions",
                needed: i.max(j) + 1,
                given: curves.len().min(by_v.len()),
            }),
        })
    }

    fn point(&self, u: &S, v: &S) -> Result<[S; 3]> {
        let (m, n) = self.degrees();
        let curve = self.combined(&self.u.row(m, u)?)?;
        blended(&self.v.row(n, v)?, &curve)
    }
}
