//! Covers: how many strips, and where their edges are.

use super::distance::StripDistance;
use super::folds;
use super::spacing::StripSpacing;
use super::strip::{StripDirection, StripError, SurfaceStrip, Tensor};
use crate::basis::Basis;
use crate::error::{self, GeometryError};
use crate::sheet::{Panel, Panels, Rail, Sheet};
use crate::surface::TensorSurface;
use crate::vector::blended;

/// The most strips of a cover.
pub const MAX_STRIPS: usize = 128;
/// The most strips made in one search, discarded ones included.
const MAX_MADE: usize = 768;
/// How often the curves are moved for one number of strips.
const ROUNDS: usize = 3;
/// Bounds count as equal if the largest is at most this multiple of their root mean square.
const EQUAL: f64 = 1.05;

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
    /// [`StripError::Asymptotic`] where the curves have no rulings across, the other [`StripError`]s where panels or
    /// their bounds are not found, [`GeometryError::OutOfRange`] for a distance that is not positive.
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
        let cover = StripSpacing::new(&turned).and_then(|spacing| {
            CoverSearch {
                surface: &turned,
                within,
                spacing,
                made: 0,
            }
            .fewest()
        });
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
        farthest(&self.strips)
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

/// Returns the curve of this `v`.
fn curve(surface: &Tensor, v: f64) -> Result<Rail, GeometryError> {
    let (shape, across) = surface.bases();
    let (_, n) = surface.degrees();
    let row = across.row(n, &v)?;
    let points = surface.rows().map(|points| blended(&row, points));
    Rail::new(*shape, &points.collect::<Result<Vec<_>, _>>()?)
}

/// Returns the strips between the curves at these places.
fn strips(surface: &Tensor, places: &[f64]) -> Result<Vec<SurfaceStrip>, StripError> {
    let curves = places.iter().map(|v| curve(surface, *v));
    let curves = curves.collect::<Result<Vec<_>, _>>()?;
    let bounded = StripDistance::new(surface)?;
    let pairs = curves.windows(2).zip(places.windows(2));
    let strip = |(rails, range): (&[Rail], &[f64])| {
        let range = [range[0], range[1]];
        let found = Sheet::panels(&rails[0].clone().into(), &rails[1].clone().into())?;
        let usable = |panel: &Panel| !panel.turned && !panel.closed && panel.folds == 0;
        let panel = match found {
            Panels::Found(panels) => panels.into_iter().find(usable),
            Panels::None { .. } => {
                return Err(StripError::NoPanel {
                    range,
                    proved: true,
                });
            }
            Panels::Undecided { .. } => None,
        };
        let missing = StripError::NoPanel {
            range,
            proved: false,
        };
        let panel = panel.ok_or(missing)?;
        let distance = bounded.bound(range, &panel)?;
        let distance = distance.ok_or(StripError::Unbounded { range })?;
        Ok(SurfaceStrip {
            range,
            panel,
            distance,
        })
    };
    pairs.map(strip).collect()
}

/// What is looked for, and how much was done for it.
struct CoverSearch<'a> {
    surface: &'a Tensor,
    within: f64,
    spacing: StripSpacing,
    /// How many strips were made.
    made: usize,
}

impl CoverSearch<'_> {
    /// Returns the best of some placements of so many strips, and how many strips of equal bounds would do.
    fn placed(&mut self, count: usize) -> Result<(Vec<SurfaceStrip>, f64), StripError> {
        let mut best: Option<(Vec<SurfaceStrip>, f64)> = None;
        for _ in 0..ROUNDS {
            self.made += count;
            let made = strips(self.surface, &self.spacing.places(count))?;
            // Bounds grow with the square of the width.
            let roots = made.iter().map(|s| (s.distance / self.within).sqrt());
            let wanted: f64 = roots.sum();
            let mean = wanted / error::count(count);
            let even = farthest(&made) <= EQUAL * mean * mean * self.within;
            self.spacing.correct(&made);
            let better = |(known, _): &(Vec<SurfaceStrip>, f64)| farthest(&made) < farthest(known);
            if best.as_ref().is_none_or(better) {
                best = Some((made, wanted));
            }
            // Beyond that no placement helps.
            if even || mean > 1.0 || self.made >= MAX_MADE {
                break;
            }
        }
        best.ok_or(StripError::TooFar {
            count,
            distance: f64::INFINITY,
            within: self.within,
        })
    }

    /// Returns the smallest number of strips that come within the distance, with one less that does not.
    fn fewest(&mut self) -> Result<StripCover, StripError> {
        let mut count = self.spacing.count(self.within).clamp(1, MAX_STRIPS);
        // The largest number that failed.
        let mut failing = 0;
        let mut found: Option<Vec<SurfaceStrip>> = None;
        let mut last = StripError::TooFar {
            count,
            distance: f64::INFINITY,
            within: self.within,
        };
        while self.made < MAX_MADE {
            let most = found.as_ref().map_or(MAX_STRIPS, |strips| strips.len() - 1);
            if failing >= most {
                break;
            }
            count = count.clamp(failing + 1, most);
            match self.placed(count) {
                Ok((made, _)) if farthest(&made) <= self.within => {
                    found = Some(made);
                    count -= 1;
                }
                Ok((made, wanted)) => {
                    failing = count;
                    last = StripError::TooFar {
                        count,
                        distance: farthest(&made),
                        within: self.within,
                    };
                    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
                    let next = wanted.min(1e6).ceil() as usize;
                    count = next.max(count + 1);
                }
                // Narrower strips may have panels.
                Err(error @ (StripError::NoPanel { .. } | StripError::Unbounded { .. })) => {
                    failing = count;
                    last = error;
                    count += count / 2 + 1;
                }
                Err(error) => return Err(error),
            }
        }
        let strips = found.ok_or(last)?;
        Ok(StripCover {
            fewest: failing + 1 == strips.len(),
            strips,
        })
    }
}

/// Returns the largest bound.
fn farthest(strips: &[SurfaceStrip]) -> f64 {
    let bounds = strips.iter().map(|strip| strip.distance);
    bounds.fold(0.0, f64::max)
}
