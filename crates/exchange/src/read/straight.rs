//! What is straight though its degree does not say so: curves whose control points lie on a segment, and surfaces whose
//! control points divide the lines across them in the same ratios.
//!
//! Where `P[i][j] = (1 - g[j]) P[i][0] + g[j] P[i][n]` for all rows, in homogeneous coordinates, the surface is
//! `(1 - g(v)) A(u) + g(v) B(u)` with the curves `A`, `B` of the first and the last column and the spline `g` of the
//! shares: the ruled surface between its borders, passed with another speed. The shares are those of least squares, so
//! they are exact where the ratios are. What is left, `D[i][j]`, are the control points of the difference of both
//! surfaces: nowhere are they farther apart than the largest of them, which holds from each to the other, as the shares
//! rise from 0 to 1.

use super::{CurveShape, SplineSurface};
use torse_algebra::Rational;
use torse_geometry::vector::{cross, dot, sub};
use torse_geometry::{Coordinate, GeometryError};

/// A surface that is nearer to a ruled one than this share of its size is the rounding of one.
const ROUNDED: f64 = 1e-6;

/// A ruled surface and how far another one is from it.
#[derive(Debug, Clone, PartialEq)]
pub struct Straightened {
    /// The surface, of degree one in one direction.
    pub surface: SplineSurface,
    /// No point of the one is farther than this from the other; zero where both are one.
    pub distance: f64,
}

impl CurveShape {
    /// The ends of a spline whose control points lie exactly on the segment between them.
    #[must_use]
    pub fn segment(&self) -> Option<[&[Rational; 3]; 2]> {
        let Self::Spline(spline) = self else {
            return None;
        };
        let (from, to) = (spline.points().first()?, spline.points().last()?);
        let way = sub(to, from);
        let (zero, length) = (Rational::default(), dot(&way, &way));
        let on = |p: &[Rational; 3]| {
            let arm = sub(p, from);
            let along = dot(&arm, &way);
            cross(&arm, &way).iter().all(|c| *c == zero) && along >= zero && along <= length
        };
        (length > zero && spline.points().iter().all(on)).then_some([from, to])
    }

    /// Whether no point of a spline is farther than this from the segment between its ends.
    #[must_use]
    pub fn is_straight_within(&self, tolerance: f64) -> bool {
        let Self::Spline(spline) = self else {
            return false;
        };
        let near = |p: &[Rational; 3]| p.each_ref().map(Coordinate::approximate);
        let (Some(from), Some(to)) = (spline.points().first(), spline.points().last()) else {
            return false;
        };
        let (from, to) = (near(from), near(to));
        let way = sub(&to, &from);
        let length = torse_geometry::vector::norm(&way);
        length > tolerance
            && spline.points().iter().all(|p| {
                let arm = sub(&near(p), &from);
                let along = dot(&arm, &way) / length;
                let off = torse_geometry::vector::norm(&cross(&arm, &way)) / length;
                off <= tolerance && along >= -tolerance && along <= length + tolerance
            })
    }
}

/// A homogeneous control point.
type Lifted = [Rational; 4];

fn product(a: &Lifted, b: &Lifted) -> Rational {
    let terms = a.iter().zip(b).map(|(x, y)| x.clone() * y.clone());
    terms.fold(Rational::default(), |sum, term| sum + term)
}

impl SplineSurface {
    /// The ruled surface that this one is, or is the rounding of: of both directions the one in which it is nearer.
    ///
    /// # Errors
    /// As [`SplineSurface::new`].
    pub fn straightened(&self) -> Result<Option<Straightened>, GeometryError> {
        let mut best: Option<Straightened> = None;
        for along in [1, 0] {
            let Some(distance) = self.distance_along(along) else {
                continue;
            };
            let limit = ROUNDED * self.size();
            let nearer = best.as_ref().is_none_or(|known| distance < known.distance);
            if distance <= limit && nearer {
                let surface = self.between_borders(along)?;
                best = Some(Straightened { surface, distance });
            }
        }
        Ok(best)
    }

    /// The largest difference of a coordinate of two control points.
    fn size(&self) -> f64 {
        let mut size = 0.0_f64;
        for axis in 0..3 {
            let mut range = [f64::INFINITY, f64::NEG_INFINITY];
            for point in self.net.iter().flatten() {
                let c = point[axis].approximate();
                range = [range[0].min(c), range[1].max(c)];
            }
            size = size.max(range[1] - range[0]);
        }
        size
    }

    /// The lines of homogeneous control points in a direction.
    fn lines(&self, along: usize) -> Vec<Vec<Lifted>> {
        let one = Rational::from_integer(1.into());
        let lifted = |i: usize, j: usize| -> Option<Lifted> {
            let point = self.net.get(i)?.get(j)?;
            let weights = self.weights.as_ref();
            let w = match weights {
                Some(all) => all.get(i)?.get(j)?,
                None => &one,
            };
            let [x, y, z] = point.each_ref().map(|c| c.clone() * w.clone());
            Some([x, y, z, w.clone()])
        };
        let (rows, columns) = (self.net.len(), self.net.first().map_or(0, Vec::len));
        if along == 1 {
            let row = |i| (0..columns).filter_map(|j| lifted(i, j)).collect();
            (0..rows).map(row).collect()
        } else {
            let column = |j| (0..rows).filter_map(|i| lifted(i, j)).collect();
            (0..columns).map(column).collect()
        }
    }

    /// How far this surface is at most from the one between the first and the last points of its lines; `None` where
    /// the shares do not rise, the weights are no such shares, or the lines do not begin and end in these points.
    fn distance_along(&self, along: usize) -> Option<f64> {
        let (degree, knots) = (self.degrees[along], &self.knots[along]);
        let (head, tail) = (
            knots.get(..=degree)?,
            knots.get(knots.len().checked_sub(degree + 1)?..)?,
        );
        let is_one = |part: &[Rational]| part.windows(2).all(|pair| pair[0] == pair[1]);
        if !is_one(head) || !is_one(tail) {
            return None;
        }
        let lines = self.lines(along);
        let ends: Vec<(&Lifted, &Lifted)> = lines
            .iter()
            .filter_map(|line| Some((line.first()?, line.last()?)))
            .collect();
        let zero = Rational::default();
        let whole = ends.iter().fold(zero.clone(), |sum, (from, to)| {
            let way = sub(to, from);
            sum + product(&way, &way)
        });
        if whole == zero || ends.len() != lines.len() {
            return None;
        }
        let count = lines.first().map_or(0, Vec::len);
        let (mut before, mut farthest) = (zero.clone(), zero.clone());
        for j in 0..count {
            let part =
                lines
                    .iter()
                    .zip(&ends)
                    .try_fold(zero.clone(), |sum, (line, (from, to))| {
                        Some(sum + product(&sub(line.get(j)?, from), &sub(to, from)))
                    })?;
            let share = part / whole.clone();
            if share < before {
                return None;
            }
            before = share.clone();
            for (line, (from, to)) in lines.iter().zip(&ends) {
                let arm = sub(line.get(j)?, from);
                let way = sub(to, from);
                let [x, y, z, w]: Lifted =
                    std::array::from_fn(|k| arm[k].clone() - share.clone() * way[k].clone());
                if w != zero {
                    return None;
                }
                let off = [x, y, z];
                farthest = farthest.max(dot(&off, &off));
            }
        }
        if farthest == zero {
            return Some(0.0);
        }
        let least = self.weights.iter().flatten().flatten().min();
        let least = least.map_or(1.0, Coordinate::approximate);
        // The root, the quotient and both conversions are rounded once each.
        let distance = farthest.approximate().sqrt() / least * (1.0 + 8.0 * f64::EPSILON);
        (distance.is_finite() && distance > 0.0).then_some(distance)
    }

    /// The ruled surface between the first and the last points of the lines in a direction.
    fn between_borders(&self, along: usize) -> Result<Self, GeometryError> {
        fn ends<T: Clone>(net: &[Vec<T>], along: usize) -> Vec<Vec<T>> {
            let both = |first: Option<&T>, last: Option<&T>| {
                first.into_iter().chain(last).cloned().collect()
            };
            if along == 1 {
                net.iter()
                    .map(|row| both(row.first(), row.last()))
                    .collect()
            } else {
                net.first().into_iter().chain(net.last()).cloned().collect()
            }
        }
        let (zero, one) = (Rational::default(), Rational::from_integer(1.into()));
        let (mut degrees, mut knots) = (self.degrees, self.knots.clone());
        degrees[along] = 1;
        knots[along] = vec![zero.clone(), zero, one.clone(), one];
        let weights = self.weights.as_ref().map(|all| ends(all, along));
        Self::new(degrees, knots, ends(&self.net, along), weights)
    }
}
