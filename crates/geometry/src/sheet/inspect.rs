//! Everything a drawing office asks about a sheet.

use super::Sheet;
use crate::curve::integrate;
use crate::developable::{PatchCertificate, RulingForms, Worst};
use crate::error::{Result, count};
use crate::vector::{cross, dot, lerp, norm, sub, unit};

/// What [`Sheet::inspect`] measured: estimates; bounds of the certificate's numbers come from
/// [`Sheet::enclose`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Inspection {
    /// How developable and how regular.
    pub certificate: PatchCertificate,
    /// The longest ruling.
    pub longest_ruling: Worst,
    /// The shortest ruling.
    pub shortest_ruling: Worst,
    /// The smallest radius of curvature, on one of the rails or (of a patch that is not developable) in the
    /// middle of a ruling; `None` for a flat sheet, and where the sheet is singular (then it is zero).
    pub least_radius: Option<Worst>,
    /// The area.
    pub area: f64,
}

impl Inspection {
    /// Returns the largest angle between the tangent planes at the ends of a ruling, in degrees.
    #[must_use]
    pub fn twist_in_degrees(&self) -> f64 {
        self.certificate.twist.value.to_degrees()
    }
}

/// How the end of a sheet meets the start of the next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SheetJoint {
    /// The largest distance of corresponding ends of the two rulings.
    pub gap: f64,
    /// The largest angle by which the sheet is folded there, in radians: 0 where it goes on smoothly, pi where the next
    /// sheet folds back on this one, though both have their tangent planes in common.
    pub kink: f64,
}

/// A flat place has no radius of curvature: curvatures below this share of that of a circle as wide as the
/// ruling is long are rounding.
const MAX_FLAT_CURVATURE: f64 = 1e-12;
/// The relative error of areas.
const AREA_ACCURACY: f64 = 1e-10;

impl Sheet {
    /// Measures the sheet on `rulings` rulings or more.
    ///
    /// # Errors
    /// As [`Sheet::certify`], and [`NotConverged`](crate::GeometryError::NotConverged) for an area that cannot
    /// be integrated.
    ///
    /// ```
    /// use torse_geometry::prelude::*;
    /// let arc = |z: f64| Rail::ellipse_arc([0.0, 0.0, z], [2.0, 0.0, z], [0.0, 2.0, z]);
    /// let checked = Sheet::ruled(arc(0.0)?, arc(3.0)?).inspect(32)?;
    /// let radius = checked.least_radius.expect("it is curved").value;
    /// assert!((radius - 2.0).abs() < 1e-9 && (checked.area - 3.0 * std::f64::consts::PI).abs() < 1e-9);
    /// assert!((checked.longest_ruling.value - 3.0).abs() < 1e-12 && checked.certificate.clearance.is_none());
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn inspect(&self, rulings: usize) -> Result<Inspection> {
        let certificate = self.certify(rulings)?;
        let samples = rulings.clamp(8, 4096);
        let length = |x: f64| {
            let [p, q] = self.ruling(x)?;
            Ok((norm(&sub(&q, &p)), 0.0))
        };
        let longest_ruling = sampled_maximum(samples, length)?;
        let shortest = sampled_maximum(samples, |x| length(x).map(|(value, v)| (-value, v)))?;
        let shortest_ruling = Worst {
            value: -shortest.value,
            ..shortest
        };
        let least_radius = if certificate.is_regular() {
            let bend = sampled_maximum(samples, |x| self.largest_curvature(x))?;
            let flat = bend.value * longest_ruling.value <= MAX_FLAT_CURVATURE;
            (!flat).then_some(Worst {
                value: 1.0 / bend.value,
                ..bend
            })
        } else {
            None
        };
        let area = |accuracy| integrate(|x| self.area_density(x), [0.0, 1.0], accuracy, "area");
        let rough = self.area_density(0.5)? + self.area_density(0.0)? + self.area_density(1.0)?;
        Ok(Inspection {
            certificate,
            longest_ruling,
            shortest_ruling,
            least_radius,
            area: area((AREA_ACCURACY * rough).max(f64::MIN_POSITIVE))?,
        })
    }

    /// Compares the last ruling of this sheet with the first of the next.
    ///
    /// # Errors
    /// What the sheets refuse at their ends.
    ///
    /// ```
    /// use torse_geometry::prelude::*;
    /// let planes = [[7., -7., 5., 125.], [-7., -7., 5., 120.], [-7., 7., 5., 130.], [7., 7., 5., 125.]];
    /// let first = Planes::gbt(0.5, 0.25, &planes)?;
    /// let second = first.next(BasisShape::gbt(0.0, 1.0)?, &Joint::parametric(2), &[[7., -7., 5., 125.]])?;
    /// let cut = Cut::between([0., 0., 1., 0.], [0., 0., 1., 3.]);
    /// let joint = Sheet::envelope(&first, cut)?.joint_with(&Sheet::envelope(&second, cut)?)?;
    /// assert!(joint.gap < 1e-9 && joint.kink < 1e-7);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn joint_with(&self, next: &Self) -> Result<SheetJoint> {
        let (end, start) = (RulingForms::at(self, &1.0)?, RulingForms::at(next, &0.0)?);
        let pairs = end.ends().iter().zip(start.ends());
        let gap = pairs.map(|(p, q)| norm(&sub(p, q))).fold(0.0, f64::max);
        // Both are the cross product of the direction of travel with the same ruling: their sign counts.
        let angle = |(n, m): (&[f64; 3], &[f64; 3])| libm::atan2(norm(&cross(n, m)), dot(n, m));
        let normals = end.normals().iter().zip(start.normals());
        let kink = normals.map(angle).fold(0.0, f64::max);
        Ok(SheetJoint { gap, kink })
    }

    /// Returns the largest principal curvature in size on the ruling of `x`, with its place: of a developable the
    /// radius of curvature is linear along a ruling, so it is least at an end.
    fn largest_curvature(&self, x: f64) -> Result<(f64, f64)> {
        let mut worst = (0.0, 0.0);
        for v in [0.0, 1.0, 0.5] {
            for principal in self.principal(x, v)? {
                if principal.curvature.abs() > worst.0 {
                    worst = (principal.curvature.abs(), v);
                }
            }
        }
        Ok(worst)
    }

    /// Returns the area of the sheet at `x` over `dx`: the integral of `|N(v)|` along the ruling, by Simpson's rule on
    /// eight parts (exact for a regular developable, where `|N|` is linear).
    fn area_density(&self, x: f64) -> Result<f64> {
        let forms = RulingForms::at(self, &x)?;
        let [n0, n1] = forms.normals();
        let parallel = unit(n0)
            .zip(unit(n1))
            .is_some_and(|(a, b)| norm(&sub(&a, &b)) < 1e-7);
        if parallel {
            return Ok(0.5 * (norm(n0) + norm(n1)));
        }
        let at = |k: u32| norm(&lerp(n0, n1, &(f64::from(k) / 16.0)));
        let simpson = (0..8).map(|k| at(2 * k) + 4.0 * at(2 * k + 1) + at(2 * k + 2));
        Ok(simpson.sum::<f64>() / 48.0)
    }
}

/// Returns the largest value over samples, refined by golden section about the best.
fn sampled_maximum(samples: usize, f: impl Fn(f64) -> Result<(f64, f64)>) -> Result<Worst> {
    let at = |k: usize| count(k.min(samples)) / count(samples.max(1));
    let measure = |x: f64| f(x).map(|(value, v)| Worst { value, x, v });
    let mut best = measure(0.0)?;
    let mut index = 0;
    for k in 1..=samples {
        let next = measure(at(k))?;
        if next.value > best.value {
            (best, index) = (next, k);
        }
    }
    let (mut a, mut b) = (at(index.saturating_sub(1)), at(index + 1));
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    for _ in 0..40 {
        let (left, right) = (
            measure(b - golden * (b - a))?,
            measure(a + golden * (b - a))?,
        );
        for found in [left, right] {
            if found.value > best.value {
                best = found;
            }
        }
        if left.value >= right.value {
            b = right.x;
        } else {
            a = left.x;
        }
    }
    Ok(best)
}
