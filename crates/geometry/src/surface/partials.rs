//! Partial derivatives at a point, and the fundamental forms made of them.

use crate::coordinate::Coordinate;
use crate::error::{GeometryError, Place, Result};
use crate::vector::{cross, dot};

/// The partial derivatives of a surface at one point: `d^(i+j) / du^i dv^j` for `i + j <= order`.
#[derive(Debug, Clone, PartialEq)]
pub struct Partials<S> {
    point: [S; 3],
    order: usize,
    /// Row `i` holds `j = 0 ..= order - i`.
    table: Vec<Vec<[S; 3]>>,
}

impl<S: Coordinate> Partials<S> {
    /// Fills the table from `entry(i, j)`.
    pub(crate) fn from_fn(order: usize, mut entry: impl FnMut(usize, usize) -> [S; 3]) -> Self {
        let table: Vec<Vec<[S; 3]>> = (0..=order)
            .map(|i| (0..=order - i).map(|j| entry(i, j)).collect())
            .collect();
        Self {
            point: entry(0, 0),
            order,
            table,
        }
    }

    /// Fills the table from `entry(i, j)`, or gives its first error.
    pub(crate) fn try_from_fn(
        order: usize,
        entry: impl Fn(usize, usize) -> Result<[S; 3]>,
    ) -> Result<Self> {
        let row = |i: usize| (0..=order - i).map(|j| entry(i, j)).collect();
        Ok(Self {
            point: entry(0, 0)?,
            order,
            table: (0..=order).map(row).collect::<Result<_>>()?,
        })
    }

    /// The highest total order.
    #[must_use]
    pub fn order(&self) -> usize {
        self.order
    }

    /// The point itself.
    #[must_use]
    pub fn point(&self) -> &[S; 3] {
        &self.point
    }

    /// The derivative `i` times by `u`, `j` times by `v`; `None` beyond the order.
    #[must_use]
    pub fn get(&self, i: usize, j: usize) -> Option<&[S; 3]> {
        self.table.get(i)?.get(j)
    }

    /// The normal `S_u x S_v`, not normalised; zero where the order is less than one.
    #[must_use]
    pub fn normal(&self) -> [S; 3] {
        cross(&self.or_zero(1, 0), &self.or_zero(0, 1))
    }

    fn or_zero(&self, i: usize, j: usize) -> [S; 3] {
        self.get(i, j)
            .cloned()
            .unwrap_or_else(|| std::array::from_fn(|a| self.point[a].zero()))
    }
}

/// The fundamental forms at a point.
///
/// `first = [E, F, G]`; `second` holds `L, M, N` times `|S_u x S_v|`, so that everything up to the
/// Gaussian curvature is free of square roots: with `A = EG - F^2`, `L = second[0] / sqrt(A)` and
/// `K = (L N - M^2)/A = (second[0] second[2] - second[1]^2) / A^2`.
#[derive(Debug, Clone, PartialEq)]
pub struct Forms<S> {
    /// `E = S_u . S_u`, `F = S_u . S_v`, `G = S_v . S_v`.
    pub first: [S; 3],
    /// `S_uu . n`, `S_uv . n`, `S_vv . n` with the unnormalised normal `n = S_u x S_v`.
    pub second: [S; 3],
    /// The squared area element `E G - F^2 = |n|^2`.
    pub area_squared: S,
    /// The unnormalised normal `n`.
    pub normal: [S; 3],
}

impl<S: Coordinate> Forms<S> {
    pub(crate) fn from_partials(p: &Partials<S>) -> Self {
        let (su, sv) = (p.or_zero(1, 0), p.or_zero(0, 1));
        let normal = cross(&su, &sv);
        Self {
            first: [dot(&su, &su), dot(&su, &sv), dot(&sv, &sv)],
            second: [(2, 0), (1, 1), (0, 2)].map(|(i, j)| dot(&p.or_zero(i, j), &normal)),
            area_squared: dot(&normal, &normal),
            normal,
        }
    }

    /// The Gaussian curvature.
    ///
    /// # Errors
    /// [`GeometryError::Degenerate`] where the area element vanishes.
    pub fn gaussian(&self) -> Result<S> {
        let [l, m, n] = self.second.clone();
        let numerator = l * n - m.clone() * m;
        let a = self.area_squared.clone();
        numerator
            .divided_by(&(a.clone() * a))
            .map_err(|_| singular())
    }
}

impl Forms<f64> {
    /// The mean curvature `(E N - 2 F M + G L) / (2 A)`, signed by the normal `S_u x S_v`.
    ///
    /// # Errors
    /// [`GeometryError::Degenerate`] where the area element vanishes.
    pub fn mean(&self) -> Result<f64> {
        let ([e, f, g], [l, m, n]) = (self.first, self.second);
        let a = self.area_squared;
        if a > 0.0 {
            Ok((e * n - 2.0 * f * m + g * l) / (2.0 * a * a.sqrt()))
        } else {
            Err(singular())
        }
    }
}

pub(super) fn singular() -> GeometryError {
    GeometryError::Degenerate {
        what: "surface normal",
        at: Place::Whole,
    }
}
