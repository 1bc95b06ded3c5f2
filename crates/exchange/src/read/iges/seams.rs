//! The seams of faces: IGES writes the curve at which a closed surface is cut open twice, once each way.

use crate::read::CurveShape;
use torse_geometry::GeometryError;
use torse_geometry::vector::{norm, sub};

/// Points of two curves are one where they differ by less than this share of the distances of their own ones.
const SAME: f64 = 1e-6;
/// Places of a curve at which it is compared with another.
const SAMPLES: u32 = 8;
/// In faces of more edges seams are not looked for.
const MAX_EDGES: usize = 4096;

/// A curve as points at equal steps of its parameter.
struct Traced {
    points: Vec<[f64; 3]>,
    size: f64,
}

impl Traced {
    fn new(shape: &CurveShape) -> Result<Self, GeometryError> {
        let rail = shape.rail()?;
        let places = (0..=SAMPLES).map(|k| rail.point(f64::from(k) / f64::from(SAMPLES)));
        let points: Vec<[f64; 3]> = places.collect::<Result<_, _>>()?;
        let from = points.first().copied().unwrap_or_default();
        let size = points.iter().map(|p| norm(&sub(p, &from)));
        let size = size.fold(0.0, f64::max);
        Ok(Self { points, size })
    }

    fn is_reverse_of(&self, other: &Self, uncertainty: f64) -> bool {
        let within = (SAME * self.size).max(uncertainty);
        let mut pairs = self.points.iter().zip(other.points.iter().rev());
        // Not a closed curve, which could be its own reverse.
        let open = match (self.points.first(), self.points.last()) {
            (Some(first), Some(last)) => norm(&sub(first, last)) > within,
            _ => false,
        };
        open && pairs.all(|(a, b)| norm(&sub(a, b)) <= within)
    }
}

/// Returns of each edge of a face the earlier one that it passes backwards, if there is one: both are one seam.
///
/// # Errors
/// As [`CurveShape::rail`].
pub(super) fn seams(
    edges: &[&CurveShape],
    uncertainty: f64,
) -> Result<Vec<Option<usize>>, GeometryError> {
    let mut partners = vec![None; edges.len()];
    if edges.len() > MAX_EDGES {
        return Ok(partners);
    }
    let traced: Vec<Traced> = edges
        .iter()
        .map(|shape| Traced::new(shape))
        .collect::<Result<_, _>>()?;
    let mut taken = vec![false; edges.len()];
    for (index, own) in traced.iter().enumerate() {
        let mut before = traced.iter().zip(&taken).take(index);
        let earlier =
            before.position(|(other, taken)| !taken && own.is_reverse_of(other, uncertainty));
        if let Some(earlier) = earlier {
            for known in [earlier, index] {
                if let Some(slot) = taken.get_mut(known) {
                    *slot = true;
                }
            }
            if let Some(slot) = partners.get_mut(index) {
                *slot = Some(earlier);
            }
        }
    }
    Ok(partners)
}
