//! Covers of surfaces by strips.

use super::folds;
use super::search::CoverSearch;
use super::strip::{StripDirection, StripError, SurfaceStrip, Tensor};
use crate::error::GeometryError;
use crate::surface::TensorSurface;

/// Strips in a row that cover a surface.
#[derive(Debug, Clone, PartialEq)]
pub struct StripCover {
    /// The strips, by rising parameters. Neighbours share an edge.
    pub strips: Vec<SurfaceStrip>,
    /// Whether one strip less was tried, and did not come as near as demanded.
    pub fewest: bool,
}

impl StripCover {
    /// Covers a surface by strips between curves of constant parameter, each within the distance `within` of it, and
    /// places the curves so that the bounds are about equal. Returns the fewest strips that were found; other curves or
    /// panels might do with fewer.
    ///
    /// # Errors
    /// [`StripError::Asymptotic`] where the curves have no rulings across, [`StripError::Tip`] where they all meet in a
    /// point, [`StripError::Narrow`] where a place fails however narrow strips are, [`StripError::Spent`] where the work of
    /// a search is done, the other [`StripError`]s where panels or their bounds are not found,
    /// [`GeometryError::OutOfRange`] for a distance that is not positive.
    ///
    /// ```
    /// use torse_geometry::prelude::*;
    /// use torse_geometry::{TensorSurface, basis::BasisShape};
    /// // A dome over a square of 2 m.
    /// let height = |k: usize| [0.0, 400.0, 0.0][k];
    /// let net = (0..3).map(|k| (0..3).map(|l| {
    ///     [1000.0 * k as f64, 1000.0 * l as f64, height(k) + height(l)]
    /// }).collect()).collect();
    /// let dome = TensorSurface::new(BasisShape::Bernstein, BasisShape::Bernstein, net)?;
    /// let cover = StripCover::new(&dome, StripDirection::U, 15.0)?;
    /// assert!(cover.fewest && cover.distance() <= 15.0);
    /// assert!(cover.strips.iter().all(|strip| strip.distance <= 15.0 && !strip.panel.pieces.is_empty()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(surface: &Tensor, along: StripDirection, within: f64) -> Result<Self, StripError> {
        if !(within > 0.0 && within.is_finite()) {
            return Err(GeometryError::OutOfRange {
                name: "distance of strips",
                value: within,
                range: "(0, infinity)",
            }
            .into());
        }
        let turned = match along {
            StripDirection::U => surface.clone(),
            StripDirection::V => transposed(surface)?,
        };
        let found = CoverSearch::new(&turned, within).and_then(CoverSearch::fewest);
        let cover = found.map(|(strips, fewest)| Self { strips, fewest });
        cover.map_err(|error| match (along, error) {
            (StripDirection::V, StripError::Asymptotic { at: [u, v], point }) => {
                StripError::Asymptotic { at: [v, u], point }
            }
            (_, error) => error,
        })
    }

    /// Returns the largest bound.
    #[must_use]
    pub fn distance(&self) -> f64 {
        super::search::farthest(&self.strips)
    }

    /// Returns the least and the greatest angle, in radians, between the tangent planes of neighbours along the edge
    /// that they share: of each pair in order, as samples show.
    ///
    /// # Errors
    /// What the pieces refuse.
    pub fn fold_angles(&self) -> Result<Vec<[f64; 2]>, GeometryError> {
        let pairs = self.strips.windows(2);
        let angles = pairs.map(|pair| folds::between(&pair[0], &pair[1]));
        angles.collect()
    }
}

/// Returns the surface with its parameters exchanged.
fn transposed(surface: &Tensor) -> Result<Tensor, GeometryError> {
    let (u, v) = surface.bases();
    let (_, n) = surface.degrees();
    let column = |l: usize| {
        surface
            .rows()
            .filter_map(|row| row.get(l).copied())
            .collect()
    };
    TensorSurface::new(*v, *u, (0..=n).map(column).collect())
}
