//! A rail as a polygon, within a proved distance.

use super::{Point, Rail};
use crate::curve::SpaceCurve;
use crate::error::{GeometryError, Result};
use crate::model::ChebyshevModel;
use crate::over::Over;

/// The most corners of a polygon.
const MAX_CORNERS: usize = 1 << 16;
/// The shortest part of the parameter of which a bound is looked for.
const LEAST_PART: f64 = 1.0 / 4096.0;

impl Rail {
    /// Returns the corners of a polygon on the rail, its ends included: no point of either is farther than `within` (a
    /// length) from the other, which is proved from bounds of the second derivative.
    ///
    /// # Errors
    /// [`GeometryError::OutOfRange`] unless the distance is positive, [`GeometryError::NotConverged`] for a rail that
    /// needs more than 65536 corners, or has no bounds.
    ///
    /// ```
    /// use torse_geometry::prelude::*;
    /// let arc = Rail::ellipse_arc([0.0; 3], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0])?;
    /// let corners = arc.polygon(1e-3)?;
    /// let sagitta = |a: &Point, b: &Point| 2.0 - (0.5 * (a[0] + b[0])).hypot(0.5 * (a[1] + b[1]));
    /// assert!(corners.windows(2).all(|side| sagitta(&side[0], &side[1]) <= 1e-3));
    /// assert!(corners.len() < 30);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn polygon(&self, within: f64) -> Result<Vec<Point>> {
        if within.is_nan() || within <= 0.0 {
            return Err(GeometryError::OutOfRange {
                name: "distance of a polygon",
                value: within,
                range: "(0, infinity)",
            });
        }
        let models = self.over(&|x| ChebyshevModel::exact(*x))?;
        let mut corners = vec![self.point(0.0)?];
        let mut open: Vec<[f64; 2]> = vec![[0.5, 1.0], [0.0, 0.5]];
        let refused = |reached: f64| GeometryError::NotConverged {
            what: "corners of a polygon",
            reached,
            demanded: within,
        };
        while let Some([from, to]) = open.pop() {
            let width = to - from;
            let bend = second_derivative(&models, [from, to]);
            let Some(bend) = bend else {
                if width < LEAST_PART {
                    return Err(refused(f64::INFINITY));
                }
                let middle = 0.5 * (from + to);
                open.extend([[middle, to], [from, middle]]);
                continue;
            };
            let count = (width * (bend / (8.0 * within)).sqrt()).ceil().max(1.0);
            #[allow(clippy::cast_precision_loss)]
            let room = (MAX_CORNERS - corners.len()) as f64;
            if count.is_nan() || count > room {
                return Err(refused(bend * width * width / 8.0));
            }
            let mut k = 1.0;
            while k <= count {
                let x = if k < count {
                    from + width * k / count
                } else {
                    to
                };
                corners.push(self.point(x)?);
                k += 1.0;
            }
        }
        crate::coordinate::check_finite("corner of a polygon", corners.as_flattened())?;
        Ok(corners)
    }
}

/// Returns a bound for the second derivative on a range; `None` where there is none.
fn second_derivative(rail: &Rail<ChebyshevModel>, [from, to]: [f64; 2]) -> Option<f64> {
    let jets = rail
        .space_jet(&ChebyshevModel::identity(from, to), 2)
        .ok()?;
    let mut second = [ChebyshevModel::exact(0.0); 3];
    for (slot, jet) in second.iter_mut().zip(&jets) {
        *slot = ChebyshevModel::exact(2.0) * *jet.coefficients().get(2)?;
    }
    let bend = ChebyshevModel::largest_length(&second);
    bend.is_finite().then_some(bend)
}
