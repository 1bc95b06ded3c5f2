//! Bezier patches, weighted or not, by their homogeneous control points: whether they are developable, decided exactly.
//!
//! With `h = (w x, w y, w z, w)` the numbers `L = det(h, h_u, h_v, h_uu)`, `M` with `h_uv` and `N` with `h_vv` are, but
//! for one power of the weight and a sign, those of the second fundamental form with the normal as it comes.
//! `L N - M^2` is a polynomial of degrees at most `(8 m - 4, 8 n - 4)` for a patch of degrees `(m, n)`,
//! `(6 m - 4, 6 n - 4)` without weights. So one value that is not zero refutes that the Gaussian curvature vanishes,
//! and zeros on a grid that is larger by one prove it.

use crate::basis::Bernstein;
use crate::coordinate::Coordinate;
use crate::curve::Curve;
use crate::error::{GeometryError, Result};
use crate::over::Over;
use crate::vector::{cross, det4, dot, sub};
use torse_algebra::{Integer, Rational};

/// A Bezier patch with control points `(w x, w y, w z, w)`: rows along `u`, entries along `v`.
///
/// Invariants: two rows and two columns at least, all rows of one length; weights are positive, and all one where there
/// are none.
#[derive(Debug, Clone, PartialEq)]
pub struct BezierNet<S = Rational> {
    rows: Vec<Curve<Bernstein, S, 4>>,
    weighted: bool,
}

/// Whether the Gaussian curvature of a patch vanishes: the patch is developable where it is regular.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum CurvatureProof {
    /// Proved: everywhere.
    Zero,
    /// Refuted: not at this place `(u, v)`.
    Nonzero {
        /// The parameters.
        at: [Rational; 2],
    },
    /// Not within the budget, or the patch has no normal anywhere that was looked at.
    Undecided,
}

/// A place of a patch with its Gaussian curvature.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvedPlace {
    /// The parameters.
    pub at: [f64; 2],
    /// The point.
    pub point: [f64; 3],
    /// The Gaussian curvature, for one over a square of the unit of length.
    pub gaussian: f64,
}

/// Value and derivatives at a place: `h, h_u, h_v, h_uu, h_uv, h_vv`.
struct Local<S>([[S; 4]; 6]);

impl<S: Coordinate> BezierNet<S> {
    /// The patch with these rows of control points, `weighted` or with weights that are all one.
    ///
    /// # Errors
    /// As [`Curve::new`] of the rows and columns; [`GeometryError::LengthMismatch`] for rows of different lengths.
    pub fn new(rows: Vec<Vec<[S; 4]>>, weighted: bool) -> Result<Self> {
        let width = rows.first().map_or(0, Vec::len);
        if let Some((index, row)) = rows.iter().enumerate().find(|(_, row)| row.len() != width) {
            return Err(GeometryError::LengthMismatch {
                what: "row of a net",
                index,
                expected: width,
                given: row.len(),
            });
        }
        if rows.len() < 2 {
            return Err(GeometryError::TooFew {
                what: "rows of a net",
                needed: 2,
                given: rows.len(),
            });
        }
        crate::basis::check_degree(rows.len() - 1)?;
        let rows = rows.into_iter().map(|row| Curve::new(Bernstein, row));
        Ok(Self {
            rows: rows.collect::<Result<_>>()?,
            weighted,
        })
    }

    /// The degrees along `u` and `v`.
    #[must_use]
    pub fn degrees(&self) -> [usize; 2] {
        [
            self.rows.len().saturating_sub(1),
            self.rows.first().map_or(0, Curve::degree),
        ]
    }

    /// The rows at `v`, with their first and second derivatives: three curves along `u`.
    fn across(&self, v: &S) -> Result<[Curve<Bernstein, S, 4>; 3]> {
        let mut columns: [Vec<[S; 4]>; 3] = Default::default();
        for row in &self.rows {
            for (column, derivative) in columns.iter_mut().zip(row.derivatives(v, 2)?) {
                column.push(derivative);
            }
        }
        let [value, first, second] = columns.map(|column| Curve::new(Bernstein, column));
        Ok([value?, first?, second?])
    }
}

impl<S: Coordinate> Local<S> {
    fn at(curves: &[Curve<Bernstein, S, 4>; 3], u: &S) -> Result<Self> {
        let [value, first, second] = curves;
        let missing = GeometryError::TooFew {
            what: "derivatives",
            needed: 6,
            given: 0,
        };
        let all = (
            value.derivatives(u, 2)?,
            first.derivatives(u, 1)?,
            second.derivatives(u, 0)?,
        );
        match (all.0.as_slice(), all.1.as_slice(), all.2.as_slice()) {
            ([h, hu, huu], [hv, huv], [hvv, ..]) => {
                Ok(Self([h, hu, hv, huu, huv, hvv].map(Clone::clone)))
            }
            _ => Err(missing),
        }
    }

    /// `L, M, N` up to one factor.
    fn second_form(&self) -> [S; 3] {
        let [h, hu, hv, huu, huv, hvv] = &self.0;
        [huu, huv, hvv].map(|last| det4(h, hu, hv, last))
    }

    /// The point, and its derivatives along both parameters.
    fn tangents(&self) -> Result<[[S; 3]; 3]> {
        let [h, hu, hv, ..] = &self.0;
        let w = &h[3];
        let over = |a: S, b: &S| a.divided_by(b);
        let point = |k: usize| over(h[k].clone(), w);
        let slope = |d: &[S; 4], k: usize| {
            let square = w.clone() * w.clone();
            over(
                d[k].clone() * w.clone() - h[k].clone() * d[3].clone(),
                &square,
            )
        };
        Ok([
            [point(0)?, point(1)?, point(2)?],
            [slope(hu, 0)?, slope(hu, 1)?, slope(hu, 2)?],
            [slope(hv, 0)?, slope(hv, 1)?, slope(hv, 2)?],
        ])
    }
}

impl BezierNet {
    /// Decides whether the Gaussian curvature vanishes everywhere, with at most `budget` exact evaluations.
    ///
    /// # Errors
    /// None beyond evaluation, which does not fail for polynomials.
    ///
    /// ```
    /// use torse_algebra::rational::integer;
    /// use torse_geometry::surface::{BezierNet, CurvatureProof};
    /// let net = |lift: i64| {
    ///     let row = |x: i64, y: i64| [0, 5, 10].map(|z| [x, y, z, 1].map(integer)).to_vec();
    ///     let mut rows = vec![row(0, 0), row(2, 3), row(4, 0)];
    ///     rows[1][1][1] = integer(3 + lift);
    ///     BezierNet::new(rows, false)
    /// };
    /// // A cylinder over a parabola, and the same with one control point lifted.
    /// assert_eq!(net(0)?.curvature_proof(1000)?, CurvatureProof::Zero);
    /// assert!(matches!(net(1)?.curvature_proof(1000)?, CurvatureProof::Nonzero { .. }));
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn curvature_proof(&self, budget: usize) -> Result<CurvatureProof> {
        let factor = if self.weighted { 8 } else { 6 };
        let counts = self
            .degrees()
            .map(|degree| (factor * degree).saturating_sub(4) + 1);
        let zero = Rational::from_integer(Integer::ZERO);
        let place = |k: usize, count: usize| {
            Rational::new(Integer::from(2 * k + 1), Integer::from(2 * count + 1))
        };
        let (mut work, mut regular) = (0, false);
        for j in 0..counts[1] {
            let v = place(j, counts[1]);
            let curves = self.across(&v)?;
            for i in 0..counts[0] {
                if work >= budget {
                    return Ok(CurvatureProof::Undecided);
                }
                work += 1;
                let u = place(i, counts[0]);
                let local = Local::at(&curves, &u)?;
                let [l, m, n] = local.second_form();
                if l * n - m.clone() * m != zero {
                    return Ok(CurvatureProof::Nonzero { at: [u, v] });
                }
                if !regular {
                    let [_, along, across] = local.tangents()?;
                    regular = cross(&along, &across).iter().any(|c| *c != zero);
                }
            }
        }
        Ok(if regular {
            CurvatureProof::Zero
        } else {
            CurvatureProof::Undecided
        })
    }
}

impl BezierNet<f64> {
    /// The place of the largest Gaussian curvature in size among `(steps + 1)^2` places at equal steps: measured.
    /// `None` where no place has a normal.
    ///
    /// # Errors
    /// None beyond evaluation.
    pub fn most_curved(&self, steps: u32) -> Result<Option<CurvedPlace>> {
        let mut worst: Option<CurvedPlace> = None;
        for j in 0..=steps {
            let v = f64::from(j) / f64::from(steps.max(1));
            let curves = self.across(&v)?;
            for i in 0..=steps {
                let u = f64::from(i) / f64::from(steps.max(1));
                let local = Local::at(&curves, &u)?;
                let [point, along, across] = local.tangents()?;
                let [l, m, n] = local.second_form();
                let normal = cross(&along, &across);
                let area = dot(&normal, &normal);
                // Of the second form the fourth power of the weight is too much.
                let w = local.0[0][3];
                let weight = w * w * w * w;
                let gaussian = (l * n - m * m) / (weight * weight * area * area);
                let larger = |known: &CurvedPlace| gaussian.abs() > known.gaussian.abs();
                if gaussian.is_finite() && worst.as_ref().is_none_or(larger) {
                    let at = [u, v];
                    worst = Some(CurvedPlace {
                        at,
                        point,
                        gaussian,
                    });
                }
            }
        }
        Ok(worst)
    }

    /// The largest distance of two corners.
    ///
    /// # Errors
    /// None beyond evaluation.
    pub fn size(&self) -> Result<f64> {
        let mut corners = Vec::with_capacity(4);
        for v in [0.0, 1.0] {
            let curves = self.across(&v)?;
            for u in [0.0, 1.0] {
                let [point, ..] = Local::at(&curves, &u)?.tangents()?;
                corners.push(point);
            }
        }
        let pairs = corners
            .iter()
            .flat_map(|a| corners.iter().map(move |b| sub(a, b)));
        Ok(pairs.map(|d| crate::vector::norm(&d)).fold(0.0, f64::max))
    }
}

impl<S: Coordinate, T: Coordinate> Over<S, T> for BezierNet<S> {
    type Object = BezierNet<T>;

    fn over(&self, convert: &impl Fn(&S) -> T) -> Result<BezierNet<T>> {
        let rows = self.rows.iter().map(|row| {
            let points = row.points().iter();
            points
                .map(|p| p.each_ref().map(convert))
                .collect::<Vec<_>>()
        });
        BezierNet::new(rows.collect(), self.weighted)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use torse_algebra::rational::{integer, ratio};

    /// A quarter of a circle with weights 1, 1, 2 of radius 1, by its homogeneous control points in a plane.
    const QUARTER: [[i64; 3]; 3] = [[1, 0, 1], [1, 1, 1], [0, 2, 2]];

    /// The quarter at the start of each row turned about the second axis: a surface of revolution.
    fn revolved(profile: &[[i64; 3]]) -> BezierNet {
        let row = |[x, z, w]: &[i64; 3]| {
            let turned = QUARTER
                .iter()
                .map(|[c, s, v]| [x * c, x * s, z * v, w * v].map(integer));
            turned.collect::<Vec<_>>()
        };
        BezierNet::new(profile.iter().map(row).collect(), true).unwrap()
    }

    #[test]
    fn a_cone_is_developable_and_a_sphere_is_not() {
        let cone = revolved(&[[3, 0, 1], [1, 5, 1]]);
        assert_eq!(cone.curvature_proof(2000).unwrap(), CurvatureProof::Zero);
        let sphere = revolved(&QUARTER);
        let found = sphere.curvature_proof(2000).unwrap();
        assert!(matches!(found, CurvatureProof::Nonzero { .. }));
        let near = sphere.over(&|q: &Rational| q.approximate()).unwrap();
        // At the pole the parametrisation has no normal; everywhere else the curvature is that of the unit sphere.
        let place = near.most_curved(8).unwrap().unwrap();
        assert!((place.gaussian - 1.0).abs() < 1e-9, "{place:?}");
        assert!((dot(&place.point, &place.point) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn a_twisted_plank_is_refuted_however_little_it_twists() {
        let plank = |twist: Rational| {
            let point = |x: i64, y: i64, z: Rational| [integer(x), integer(y), z, integer(1)];
            let zero = || integer(0);
            let rows = vec![
                vec![point(0, 0, zero()), point(0, 200, zero())],
                vec![point(5000, 0, zero()), point(5000, 200, twist)],
            ];
            BezierNet::new(rows, false).unwrap()
        };
        let flat = plank(integer(0)).curvature_proof(100).unwrap();
        assert_eq!(flat, CurvatureProof::Zero);
        let tiny = plank(ratio(1, 1_000_000_000).unwrap());
        let found = tiny.curvature_proof(100).unwrap();
        assert!(matches!(found, CurvatureProof::Nonzero { .. }));
        assert_eq!(tiny.curvature_proof(0).unwrap(), CurvatureProof::Undecided);
    }

    #[test]
    fn a_patch_without_a_normal_is_not_called_developable() {
        let point = [1, 2, 3, 1].map(integer);
        let rows = vec![
            vec![point.clone(), point.clone()],
            vec![point.clone(), point],
        ];
        let net = BezierNet::new(rows, false).unwrap();
        assert_eq!(net.curvature_proof(100).unwrap(), CurvatureProof::Undecided);
    }
}
