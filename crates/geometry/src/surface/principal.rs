//! Principal curvatures and directions, on f64.
//!
//! The columns of
//!
//! ```text
//! B = | 1/sqrt(E)   -F/sqrt(E A) |        A = E G - F^2
//!     |     0        sqrt(E/A)   |
//! ```
//!
//! are an orthonormal frame of the tangent plane in the parameters (`B^T I B = 1`), so the shape operator
//! is the symmetric matrix `B^T II B`, whose eigenvalues are the principal curvatures. Solving for them
//! from mean and Gaussian curvature instead would lose half of the digits at umbilics.

use super::partials::{Forms, singular};
use crate::error::Result;
use crate::symmetric::eigen;

/// A principal curvature with its direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Principal {
    /// The normal curvature in this direction, signed by the normal `S_u x S_v`.
    pub curvature: f64,
    /// `[du, dv]`, for which `du S_u + dv S_v` is a unit vector. Its sign has no meaning, and at an
    /// umbilic neither has the direction.
    pub direction: [f64; 2],
}

impl Forms<f64> {
    /// The principal curvatures with their directions, the larger curvature first.
    ///
    /// # Errors
    /// [`GeometryError::Degenerate`](crate::GeometryError::Degenerate) where the surface is not regular.
    ///
    /// ```
    /// use torse_geometry::{Bernstein, Curve, Surface, TensorSurface};
    /// // The cylinder over the parabola (x, x^2/2), curved by 1 across its rulings at x = 0.
    /// let parabola = vec![[-1.0, 0.5, 0.0], [0.0, -0.5, 0.0], [1.0, 0.5, 0.0]];
    /// let directrix = Curve::new(Bernstein, parabola)?;
    /// let cylinder = TensorSurface::cylinder(&directrix, &[0.0, 0.0, 1.0], &4.0)?;
    /// let [across, along] = cylinder.forms(&0.5, &0.5)?.principal()?;
    /// let near = |a: f64, b: f64| (a - b).abs() < 1e-15;
    /// // The normal S_u x S_v points away from the centre of curvature.
    /// assert!(near(across.curvature, 0.0) && near(along.curvature, -1.0));
    /// // The ruling is the direction of curvature zero; S_v has length 4, S_u length 2.
    /// assert!(near(across.direction[0], 0.0) && near(across.direction[1].abs(), 0.25));
    /// assert!(near(along.direction[0].abs(), 0.5) && near(along.direction[1], 0.0));
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn principal(&self) -> Result<[Principal; 2]> {
        let ([e, f, _], [l, m, n], a) = (self.first, self.second, self.area_squared);
        // The columns of B.
        let frame = [
            [1.0 / e.sqrt(), 0.0],
            [-f / (e.sqrt() * a.sqrt()), (e / a).sqrt()],
        ];
        let second = |[x, y]: [f64; 2], [z, w]: [f64; 2]| {
            ((l * x + m * y) * z + (m * x + n * y) * w) / a.sqrt()
        };
        let shape = frame.map(|one| frame.map(|other| second(one, other)));
        // Not finite where A = 0 or anything else is not.
        if !shape.iter().flatten().all(|x| x.is_finite()) {
            return Err(singular());
        }
        let mut pairs = eigen(shape).map(|(curvature, [p, q])| Principal {
            curvature,
            direction: [0, 1].map(|k| p * frame[0][k] + q * frame[1][k]),
        });
        pairs.sort_by(|p, q| q.curvature.total_cmp(&p.curvature));
        Ok(pairs)
    }
}
