//! From the flat pattern back into space, by its rulings and bends alone.
//!
//! The sheet is taken as flat between neighbouring rulings and folded at each of them by its angle: a polyhedron
//! that follows the smooth sheet with an error that falls with the square of the distance of the
//! rulings. Nothing of the design enters but what is on the drawing, so comparing the result with the
//! design checks the drawing.

use super::error::{PatternError, PatternResult};
use super::flat::FlatPattern;
use super::lift::PatternPlace;
use crate::symmetric::eigen;
use crate::vector::{add, cross, dot, norm, scale, sub, unit};

/// Folds a sheet: the ends in space of all rulings, from their ends on the sheet and the angles in radians by which
/// the sheet is folded there, positive where both sides rise towards the viewer
/// ([`FlatRuling::bend`](super::FlatRuling::bend)). The facet before the second ruling stays in the plane
/// `z = 0`; the angles of the first and the last ruling do not matter.
///
/// # Errors
/// [`PatternError::Count`] for fewer than two rulings or another number of angles,
/// [`PatternError::OutOfRange`] for NaN and infinities, [`PatternError::NoRuling`] (with the share of
/// rulings passed) for a ruling whose ends coincide.
///
/// ```
/// use torse_geometry::pattern::fold;
/// let rulings = [0.0, 1.0, 2.0].map(|y| [[0.0, y], [3.0, y]]);
/// let angles = [0.0, std::f64::consts::FRAC_PI_2, 0.0];
/// let folded = fold(&rulings, &angles)?;
/// // The second square stands upright.
/// let [x, y, z] = folded[2][1];
/// assert!((x - 3.0).abs() < 1e-15 && (y - 1.0).abs() < 1e-15 && (z - 1.0).abs() < 1e-15);
/// # Ok::<(), torse_geometry::pattern::PatternError>(())
/// ```
pub fn fold(rulings: &[[[f64; 2]; 2]], angles: &[f64]) -> PatternResult<Vec<[[f64; 3]; 2]>> {
    let motions = facet_motions(rulings, angles)?;
    let placed = |(ruling, motion): (&[[f64; 2]; 2], &RigidMotion)| {
        ruling.map(|end| motion.point(&on_sheet(end)))
    };
    Ok(rulings.iter().zip(&motions).map(placed).collect())
}

/// The motions of the facets of a sheet that is folded as [`fold`] describes: for each ruling that of the facet before
/// it, for the first one that of the facet after it.
///
/// # Errors
/// As [`fold`].
pub(super) fn facet_motions(
    rulings: &[[[f64; 2]; 2]],
    angles: &[f64],
) -> PatternResult<Vec<RigidMotion>> {
    for (what, given, needed) in [
        ("rulings to fold", rulings.len(), rulings.len().max(2)),
        ("fold angles", angles.len(), rulings.len()),
    ] {
        if given != needed {
            return Err(PatternError::Count {
                what,
                given,
                needed,
            });
        }
    }
    let numbers = rulings.iter().flatten().flatten().chain(angles);
    if let Some(&value) = numbers.into_iter().find(|v| !v.is_finite()) {
        let (name, range) = ("number of the drawing", "(-infinity, infinity)");
        return Err(PatternError::OutOfRange { name, value, range });
    }
    let RigidMotion {
        mut rotation,
        mut shift,
    } = RigidMotion::IDENTITY;
    let mut motions = Vec::with_capacity(rulings.len());
    for (k, (ruling, angle)) in rulings.iter().zip(angles).enumerate() {
        let flat = ruling.map(on_sheet);
        motions.push(RigidMotion { rotation, shift });
        let Some(next) = rulings.get(k + 1).filter(|_| k > 0) else {
            continue;
        };
        let axis = sub(&flat[1], &flat[0]);
        let length = norm(&axis);
        if length == 0.0 {
            #[allow(clippy::cast_precision_loss)]
            let x = k as f64 / rulings.len() as f64;
            return Err(PatternError::NoRuling { x });
        }
        // The sheet goes on to the left of the axis, so that a positive angle lifts it.
        let middle =
            |r: &[[f64; 2]; 2]| [0.5 * (r[0][0] + r[1][0]), 0.5 * (r[0][1] + r[1][1]), 0.0];
        let [_, _, ahead] = cross(&axis, &sub(&middle(next), &middle(ruling)));
        let axis = scale(&(ahead.signum() / length), &axis);
        let turn = |p: &[f64; 3]| turned_about(&axis, *angle, p);
        let stays = sub(&flat[0], &turn(&flat[0]));
        shift = add(&shift, &image(&rotation, &stays));
        rotation = rotation.map(|row| turned_about(&axis, -angle, &row));
    }
    Ok(motions)
}

/// A motion of space without reflection: p -> rotation p + shift. The rotation is given by its rows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct RigidMotion {
    rotation: [[f64; 3]; 3],
    shift: [f64; 3],
}

impl RigidMotion {
    pub(super) const IDENTITY: Self = Self {
        rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        shift: [0.0; 3],
    };

    /// The image of a point.
    pub(super) fn point(&self, p: &[f64; 3]) -> [f64; 3] {
        add(&image(&self.rotation, p), &self.shift)
    }

    /// First the other motion, then this one.
    pub(super) fn after(&self, first: &Self) -> Self {
        let columns = transposed(&first.rotation).map(|column| image(&self.rotation, &column));
        Self {
            rotation: transposed(&columns),
            shift: self.point(&first.shift),
        }
    }

    /// The motion back.
    pub(super) fn inverse(&self) -> Self {
        let rotation = transposed(&self.rotation);
        Self {
            rotation,
            shift: image(&rotation, &self.shift).map(|c| -c),
        }
    }

    /// Where the normal of the sheet goes.
    pub(super) fn normal(&self) -> [f64; 3] {
        self.rotation.map(|[_, _, z]| z)
    }
}

/// The matrix with rows and columns exchanged.
fn transposed(rows: &[[f64; 3]; 3]) -> [[f64; 3]; 3] {
    [0, 1, 2].map(|k| rows.map(|row| row[k]))
}

/// A point of the sheet in the plane `z = 0`.
pub(super) fn on_sheet([x, y]: [f64; 2]) -> [f64; 3] {
    [x, y, 0.0]
}

/// The image of a point under the linear map with these rows.
fn image(rows: &[[f64; 3]; 3], p: &[f64; 3]) -> [f64; 3] {
    rows.each_ref().map(|row| dot(row, p))
}

/// A vector turned about a unit vector: Rodrigues' formula.
fn turned_about(axis: &[f64; 3], angle: f64, p: &[f64; 3]) -> [f64; 3] {
    let (s, c) = libm::sincos(angle);
    let across = cross(axis, p);
    let more = add(
        &scale(&s, &across),
        &scale(&(1.0 - c), &cross(axis, &across)),
    );
    add(p, &more)
}

/// The largest distance between corresponding points after the rigid motion (no reflection) that makes the
/// sum of the squares least (Horn 1987: its unit quaternion is an eigenvector).
///
/// # Errors
/// [`PatternError::Count`] when the lists differ in length or are empty, [`PatternError::OutOfRange`] for
/// NaN and infinities.
///
/// ```
/// use torse_geometry::pattern::deviation;
/// let corner = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 3.0]];
/// let turned = corner.map(|[x, y, z]| [5.0 - y, x, z + 1.0]);
/// assert!(deviation(&corner, &turned)? < 1e-14);
/// // The mirror image is another body.
/// assert!(deviation(&corner, &corner.map(|[x, y, z]| [x, y, -z]))? > 0.5);
/// # Ok::<(), torse_geometry::pattern::PatternError>(())
/// ```
pub fn deviation(points: &[[f64; 3]], others: &[[f64; 3]]) -> PatternResult<f64> {
    if points.len() != others.len() || points.is_empty() {
        return Err(PatternError::Count {
            what: "points to compare",
            given: others.len(),
            needed: points.len().max(1),
        });
    }
    let numbers = points.iter().chain(others).flatten();
    if let Some(&value) = numbers.into_iter().find(|v| !v.is_finite()) {
        let (name, range) = ("coordinate", "(-infinity, infinity)");
        return Err(PatternError::OutOfRange { name, value, range });
    }
    let Some(fit) = rigid_fit(points, others) else {
        return Ok(f64::INFINITY);
    };
    let mut largest = 0.0_f64;
    for (p, q) in points.iter().zip(others) {
        let moved = image(&fit.rotation, &sub(p, &fit.from));
        largest = largest.max(norm(&sub(&moved, &sub(q, &fit.to))));
    }
    Ok(largest)
}

/// A rotation about one point, which is carried to another.
struct RigidFit {
    rotation: [[f64; 3]; 3],
    from: [f64; 3],
    to: [f64; 3],
}

/// The motion of points onto as many others that [`deviation`] takes.
pub(super) fn best_motion(points: &[[f64; 3]], others: &[[f64; 3]]) -> Option<RigidMotion> {
    let RigidFit { rotation, from, to } = rigid_fit(points, others)?;
    let shift = sub(&to, &image(&rotation, &from));
    Some(RigidMotion { rotation, shift })
}

/// The rigid motion of points onto as many others that makes the sum of the squares of the distances least; `None`
/// where there is no number.
fn rigid_fit(points: &[[f64; 3]], others: &[[f64; 3]]) -> Option<RigidFit> {
    #[allow(clippy::cast_precision_loss)]
    let count = points.len() as f64;
    let centre = |list: &[[f64; 3]]| {
        list.iter()
            .fold([0.0; 3], |sum, p| add(&sum, p))
            .map(|c| c / count)
    };
    let (here, there) = (centre(points), centre(others));
    // The sums of the products of coordinates.
    let mut sums = [[0.0_f64; 3]; 3];
    for (p, q) in points.iter().zip(others) {
        let (p, q) = (sub(p, &here), sub(q, &there));
        for (row, a) in sums.iter_mut().zip(p) {
            *row = add(row, &scale(&a, &q));
        }
    }
    let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = sums;
    let pairs = eigen([
        [xx + yy + zz, yz - zy, zx - xz, xy - yx],
        [0.0, xx - yy - zz, xy + yx, zx + xz],
        [0.0, 0.0, yy - xx - zz, yz + zy],
        [0.0, 0.0, 0.0, zz - xx - yy],
    ]);
    let largest = pairs.iter().max_by(|a, b| a.0.total_cmp(&b.0));
    let [w, x, y, z] = largest.and_then(|(_, quaternion)| unit(quaternion))?;
    let rotation = [
        [
            1.0 - 2.0 * (y * y + z * z),
            2.0 * (x * y - w * z),
            2.0 * (x * z + w * y),
        ],
        [
            2.0 * (x * y + w * z),
            1.0 - 2.0 * (x * x + z * z),
            2.0 * (y * z - w * x),
        ],
        [
            2.0 * (x * z - w * y),
            2.0 * (y * z + w * x),
            1.0 - 2.0 * (x * x + y * y),
        ],
    ];
    Some(RigidFit {
        rotation,
        from: here,
        to: there,
    })
}

impl FlatPattern {
    /// The ends of the rulings in space, on the patch: what [`fold`] should come to.
    #[must_use]
    pub fn rulings_in_space(&self) -> Vec<[[f64; 3]; 2]> {
        let end = |piece, x, v| self.space(PatternPlace { piece, x, v });
        self.rulings()
            .iter()
            .filter_map(|r| Some([end(r.piece, r.x, 0.0)?, end(r.piece, r.x, 1.0)?]))
            .collect()
    }

    /// How far the folded pattern is from the design: the largest distance of the ends of rulings, after the best
    /// rigid motion. It falls with the square of the number of rulings.
    ///
    /// # Errors
    /// As [`fold`] and [`deviation`].
    ///
    /// ```
    /// use torse_geometry::pattern::unroll;
    /// use torse_geometry::{RuledSurface, curve::ellipse_arc};
    /// let ring = |z: f64| ellipse_arc(&[0.0, 0.0, z], &[2.0, 0.0, z], &[0.0, 2.0, z]);
    /// let quarter = RuledSurface::new(ring(0.0)?, ring(3.0)?);
    /// let [coarse, fine] = [9, 33].map(|n| unroll(&quarter, n, 1e-6)?.fold_deviation());
    /// let (coarse, fine) = (coarse?, fine?);
    /// assert!(coarse < 0.01 && fine < coarse / 12.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn fold_deviation(&self) -> PatternResult<f64> {
        let flat: Vec<_> = self.rulings().iter().map(|r| r.ends).collect();
        let bends: Vec<_> = self.rulings().iter().map(|r| r.bend).collect();
        let folded: Vec<_> = fold(&flat, &bends)?.into_iter().flatten().collect();
        let design: Vec<_> = self.rulings_in_space().into_iter().flatten().collect();
        deviation(&folded, &design)
    }
}
