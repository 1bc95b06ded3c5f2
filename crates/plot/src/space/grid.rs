//! Grids of vertices.

use crate::error::{FigureError, at_least, finite};
use crate::space::vector::{V3, cross, sub, unit};

/// A rectangular grid of points in space, row by row: the samples of a patch, or a control net.
///
/// Row `i` of a patch is the parameter line `u = i / (rows - 1)`, column `j` the line `v = j / (columns - 1)`. The
/// side from which the directions of growing row and growing column make a left turn is the front:
/// the normal is `r_u x r_v`.
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    rows: usize,
    columns: usize,
    points: Vec<V3>,
}

/// Most vertices of one grid.
const LARGEST: f64 = 2e6;

impl Grid {
    /// A grid from its points, row by row.
    ///
    /// # Errors
    /// Fewer than two rows or columns, `points.len() != rows * columns`, non-finite points, more than two million
    /// points.
    pub fn new(rows: usize, columns: usize, points: Vec<[f64; 3]>) -> Result<Grid, FigureError> {
        at_least("rows of a grid", 2, rows)?;
        at_least("columns of a grid", 2, columns)?;
        check_size(rows, columns)?;
        if points.len() != rows * columns {
            let (what, expected, got) = ("points of a grid", rows * columns, points.len());
            return Err(FigureError::Length {
                what,
                expected,
                got,
            });
        }
        finite("points of a grid", &points)?;
        Ok(Grid {
            rows,
            columns,
            points,
        })
    }

    /// Samples of `patch(u, v)` on the unit square, `u` along the rows' index and `v` along the columns'.
    ///
    /// ```
    /// use torse_plot::Grid;
    /// let cone = Grid::sample(40, 2, |u, v| [v * (6.0 * u).cos(), v * (6.0 * u).sin(), v])?;
    /// assert_eq!((cone.rows(), cone.columns()), (40, 2));
    /// # Ok::<(), torse_plot::FigureError>(())
    /// ```
    ///
    /// # Errors
    /// As [`Grid::new`].
    pub fn sample(
        rows: usize,
        columns: usize,
        patch: impl Fn(f64, f64) -> [f64; 3],
    ) -> Result<Grid, FigureError> {
        at_least("rows of a grid", 2, rows)?;
        at_least("columns of a grid", 2, columns)?;
        check_size(rows, columns)?;
        let at = |k: usize, n: usize| k as f64 / (n - 1) as f64;
        let points = (0..rows)
            .flat_map(|i| (0..columns).map(move |j| (i, j)))
            .map(|(i, j)| patch(at(i, rows), at(j, columns)))
            .collect();
        Grid::new(rows, columns, points)
    }

    /// Number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Number of columns.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// The points, row by row.
    #[must_use]
    pub fn points(&self) -> &[[f64; 3]] {
        &self.points
    }

    /// Point in row `i` and column `j`, both clamped to the grid.
    pub(crate) fn at(&self, i: usize, j: usize) -> V3 {
        let index = i.min(self.rows - 1) * self.columns + j.min(self.columns - 1);
        self.points.get(index).copied().unwrap_or_default()
    }

    /// Unit normals by central differences. Where the differences are parallel or vanish, as at the apex of a
    /// cone, those of the cells nearby decide; a grid without any normal there gets the zero vector.
    pub(crate) fn normals(&self) -> Vec<V3> {
        let places = (0..self.rows).flat_map(|i| (0..self.columns).map(move |j| (i, j)));
        let near = |(i, j)| DETOURS.iter().find_map(|&d| self.normal(i, j, d));
        places
            .map(|place| near(place).unwrap_or_default())
            .collect()
    }

    /// Normal from differences along the row and the column that pass `detour` steps inside of the point.
    fn normal(&self, i: usize, j: usize, detour: [usize; 2]) -> Option<V3> {
        let inward = |k: usize, n: usize, steps: usize| {
            if 2 * k < n {
                (k + steps).min(n - 1)
            } else {
                k.saturating_sub(steps)
            }
        };
        let (i, j) = (
            inward(i, self.rows, detour[0]),
            inward(j, self.columns, detour[1]),
        );
        let du = unit(sub(self.at(i + 1, j), self.at(i.saturating_sub(1), j)))?;
        let dv = unit(sub(self.at(i, j + 1), self.at(i, j.saturating_sub(1))))?;
        let n = cross(du, dv);
        let steep = n.iter().map(|c| c.abs()).fold(0.0, f64::max);
        if steep < 1e-9 { None } else { unit(n) }
    }
}

/// Steps along rows and columns, tried in turn. Detours along one direction come first: a ruling of a cone keeps its
/// normal up to the apex.
const DETOURS: [[usize; 2]; 7] = [[0, 0], [0, 1], [1, 0], [1, 1], [0, 2], [2, 0], [2, 2]];

fn check_size(rows: usize, columns: usize) -> Result<(), FigureError> {
    let size = rows as f64 * columns as f64;
    crate::error::within("vertices of a grid", size, 4.0, LARGEST)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::space::vector::dot;

    #[test]
    fn normals_of_a_sphere_point_outwards() {
        let sphere = Grid::sample(33, 33, |u, v| {
            let (a, b) = (std::f64::consts::TAU * u, 0.2 + 2.7 * v);
            // Longitude then polar angle: the product of the derivatives points inwards, so turn one round.
            [
                libm::sin(b) * libm::cos(-a),
                libm::sin(b) * libm::sin(-a),
                libm::cos(b),
            ]
        })
        .unwrap();
        for (p, n) in sphere.points().iter().zip(sphere.normals()) {
            assert!(dot(*p, n) > 0.99, "{p:?} {n:?}");
        }
    }

    #[test]
    fn the_apex_of_a_cone_takes_the_normal_of_its_ruling() {
        let cone = Grid::sample(9, 5, |u, v| [v * libm::cos(u), v * libm::sin(u), v]).unwrap();
        let normals = cone.normals();
        for row in normals.chunks(5) {
            assert!(dot(row[0], row[1]) > 1.0 - 1e-9);
            assert!((dot(row[0], row[0]) - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn a_wrong_number_of_points_and_a_nan_are_refused() {
        let zeros = vec![[0.0; 3]; 5];
        assert_eq!(
            Grid::new(2, 3, zeros),
            Err(FigureError::Length {
                what: "points of a grid",
                expected: 6,
                got: 5
            })
        );
        let bad = Grid::sample(2, 2, |u, v| [u, v, if u > v { f64::INFINITY } else { 0.0 }]);
        assert!(matches!(bad, Err(FigureError::NonFinite { index: 2, .. })));
    }
}
