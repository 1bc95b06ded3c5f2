//! Named patches with shared vertices and edges.

use super::Converted;
use super::patch::{BsplineCurve, BsplinePatch, Knots};
use crate::drawing::check_text;
use crate::error::{ExchangeError, Result};
use torse_geometry::vector::{norm, sub};

/// The most faces of a model: matching edges takes time with their square.
const MAX_FACES: usize = 4096;

/// A part made of patches. Where boundary curves of two patches agree they are one edge, so that a CAD system
/// reads a connected sheet.
///
/// ```
/// use torse_exchange::{ExactForm, CadModel, iges, step};
/// use torse_geometry::{Bernstein, Curve, RuledSurface};
/// let rail = |a: [f64; 3], b: [f64; 3]| Curve::new(Bernstein, vec![a, b]);
/// let floor = RuledSurface::new(rail([0., 0., 0.], [1., 0., 0.])?, rail([0., 1., 0.], [1., 1., 0.])?);
/// let wall = RuledSurface::new(rail([0., 1., 0.], [1., 1., 0.])?, rail([0., 1., 1.], [1., 1., 1.])?);
/// let mut corner = CadModel::new("corner", 1e-9)?;
/// corner.add("floor", floor.exact_form()?)?;
/// corner.add("wall", wall.exact_form()?)?;
/// let text = step(&corner)?;
/// // Two squares with one common side.
/// assert_eq!(text.matches("=EDGE_CURVE(").count(), 7);
/// assert_eq!(text.matches("=VERTEX_POINT(").count(), 6);
/// assert!(iges(&corner)?.lines().all(|line| line.len() == 80));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct CadModel {
    name: String,
    sewing: f64,
    faces: Vec<Face>,
    vertices: Vec<[f64; 3]>,
    edges: Vec<Edge>,
    error: f64,
}

/// A patch with its name and its boundary.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Face {
    pub(crate) name: String,
    pub(crate) patch: BsplinePatch,
    /// The edges around, each with whether it is run forwards.
    pub(crate) boundary: Vec<(usize, bool)>,
    /// The edges around openings, run so that the face is on their left.
    pub(crate) openings: Vec<Vec<(usize, bool)>>,
}

/// A boundary curve between two vertices.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Edge {
    pub(crate) curve: BsplineCurve,
    pub(crate) ends: [usize; 2],
}

impl CadModel {
    /// A model without patches, in which vertices and edges at most `sewing` millimetres apart are one.
    ///
    /// # Errors
    /// [`ExchangeError::OutOfRange`] unless `sewing` is positive, [`ExchangeError::BadText`].
    pub fn new(name: &str, sewing: f64) -> Result<Self> {
        check_text(name)?;
        if !(sewing.is_finite() && sewing > 0.0) {
            return Err(ExchangeError::OutOfRange {
                name: "sewing distance",
                value: sewing,
                range: "(0, inf)",
            });
        }
        Ok(Self {
            name: name.to_owned(),
            sewing,
            faces: Vec::new(),
            vertices: Vec::new(),
            edges: Vec::new(),
            error: 0.0,
        })
    }

    /// Adds the patches of a surface under a name; several are numbered `name.1`, `name.2`, ...
    ///
    /// # Errors
    /// [`ExchangeError::BadText`], [`ExchangeError::TooMany`].
    pub fn add(&mut self, name: &str, surface: Converted) -> Result<()> {
        check_text(name)?;
        let given = self.faces.len().saturating_add(surface.patches.len());
        if given > MAX_FACES {
            return Err(ExchangeError::TooMany {
                what: "faces",
                given,
                most: MAX_FACES,
            });
        }
        let single = surface.patches.len() == 1;
        for (patch, number) in surface.patches.into_iter().zip(1..) {
            let sides = patch.sides();
            let mut boundary = Vec::with_capacity(4);
            for side in sides {
                // An apex has no side.
                if !side.is_point(self.sewing) {
                    boundary.push(self.edge(side));
                }
            }
            let name = if single {
                name.to_owned()
            } else {
                format!("{name}.{number}")
            };
            self.faces.push(Face {
                name,
                patch,
                boundary,
                openings: Vec::new(),
            });
        }
        self.error = self.error.max(surface.error);
        Ok(())
    }

    /// Adds a patch under a name whose face ends along a closed curve on it: smooth parts as of [`CadModel::open`].
    ///
    /// # Errors
    /// As [`CadModel::add`] and [`CadModel::open`]; [`ExchangeError::TooMany`] for a surface of several patches.
    ///
    /// ```
    /// use torse_exchange::{CadModel, ExactForm, step};
    /// use torse_geometry::{Bernstein, Curve, RuledSurface};
    /// let rail = |y: f64| Curve::new(Bernstein, vec![[-2., y, 0.], [2., y, 0.]]);
    /// let square = RuledSurface::new(rail(-2.)?, rail(2.)?);
    /// let around = (0..=32).map(|k| (std::f64::consts::TAU * f64::from(k) / 32.0).sin_cos());
    /// let disc: Vec<[f64; 3]> = around.map(|(s, c)| [c, s, 0.0]).collect();
    /// let mut model = CadModel::new("disc", 1e-9)?;
    /// model.add_within("disc", square.exact_form()?, &[disc])?;
    /// assert_eq!(step(&model)?.matches("=EDGE_CURVE(").count(), 2);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn add_within(
        &mut self,
        name: &str,
        surface: Converted,
        border: &[Vec<[f64; 3]>],
    ) -> Result<()> {
        check_text(name)?;
        let given = surface.patches.len();
        let [patch] =
            <[BsplinePatch; 1]>::try_from(surface.patches).map_err(|_| ExchangeError::TooMany {
                what: "patches within one border",
                given,
                most: 1,
            })?;
        let given = self.faces.len().saturating_add(1);
        if given > MAX_FACES {
            return Err(ExchangeError::TooMany {
                what: "faces",
                given,
                most: MAX_FACES,
            });
        }
        let boundary = self.around(border)?;
        self.faces.push(Face {
            name: name.to_owned(),
            patch,
            boundary,
            openings: Vec::new(),
        });
        self.error = self.error.max(surface.error);
        Ok(())
    }

    /// Cuts an opening into the face that was added last: smooth parts that meet in corners, each through points at equal steps of
    /// its parameter, eight steps at least, run so that the face is on its left; each part ends where the next begins, and one
    /// part alone is smooth all around. Each is as smooth as cubics with the tangents of five points are.
    ///
    /// # Errors
    /// [`ExchangeError::Empty`] without a face or with too few points.
    pub fn open(&mut self, parts: &[Vec<[f64; 3]>]) -> Result<()> {
        if self.faces.is_empty() {
            return Err(ExchangeError::Empty { what: "opening" });
        }
        let edges = self.around(parts)?;
        if let Some(face) = self.faces.last_mut() {
            face.openings.push(edges);
        }
        Ok(())
    }

    /// Returns the edges along a closed curve.
    fn around(&mut self, parts: &[Vec<[f64; 3]>]) -> Result<Vec<(usize, bool)>> {
        if parts.is_empty() || parts.iter().any(|part| part.len() < 9) {
            return Err(ExchangeError::Empty { what: "opening" });
        }
        let is_round = parts.len() == 1;
        let mut edges = Vec::new();
        for part in parts {
            let tangents = tangents(part, is_round);
            let last = part.len() - 1;
            // A closed curve is two edges.
            let middle = if is_round { last / 2 } else { last };
            for (from, to) in [(0, middle), (middle, last)] {
                if from < to {
                    let (points, tangents) = (part.get(from..=to), tangents.get(from..=to));
                    let curve = cubics(points.unwrap_or_default(), tangents.unwrap_or_default());
                    edges.push(self.edge(curve));
                }
            }
        }
        Ok(edges)
    }

    /// The name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The proved distance of all surfaces that were added from their originals: the largest
    /// [`Converted::error`].
    #[must_use]
    pub fn error(&self) -> f64 {
        self.error
    }

    /// The distance at which vertices and edges are one.
    #[must_use]
    pub fn sewing(&self) -> f64 {
        self.sewing
    }

    pub(crate) fn faces(&self) -> &[Face] {
        &self.faces
    }

    pub(crate) fn vertices(&self) -> &[[f64; 3]] {
        &self.vertices
    }

    pub(crate) fn edges(&self) -> &[Edge] {
        &self.edges
    }

    /// The edge of a boundary curve, an old one if it agrees, and whether it is run forwards.
    fn edge(&mut self, curve: BsplineCurve) -> (usize, bool) {
        let ends = [curve.points.first(), curve.points.last()]
            .map(|p| self.vertex(p.copied().unwrap_or_default()));
        let backwards = curve.reversed();
        for (index, edge) in self.edges.iter().enumerate() {
            if edge.ends == ends && edge.curve.is_near(&curve, self.sewing) {
                return (index, true);
            }
            if edge.ends == [ends[1], ends[0]] && edge.curve.is_near(&backwards, self.sewing) {
                return (index, false);
            }
        }
        self.edges.push(Edge { curve, ends });
        (self.edges.len() - 1, true)
    }

    fn vertex(&mut self, point: [f64; 3]) -> usize {
        let near = |q: &[f64; 3]| norm(&sub(&point, q)) <= self.sewing;
        self.vertices.iter().position(near).unwrap_or_else(|| {
            self.vertices.push(point);
            self.vertices.len() - 1
        })
    }
}

/// The derivatives at points of equal steps of one, by five points; `around` if the last point is the first.
fn tangents(points: &[[f64; 3]], around: bool) -> Vec<[f64; 3]> {
    let last = points.len() - 1;
    let at = |k: usize| points.get(k).copied().unwrap_or_default();
    let sum = |start: usize, weights: [f64; 5]| -> [f64; 3] {
        std::array::from_fn(|i| {
            let terms = weights.iter().zip(start..);
            terms.map(|(w, k)| w * at(k % points.len())[i]).sum::<f64>() / 12.0
        })
    };
    let inner = [1.0, -8.0, 0.0, 8.0, -1.0];
    let [first, second] = [
        [-25.0, 48.0, -36.0, 16.0, -3.0],
        [-3.0, -10.0, 18.0, -6.0, 1.0],
    ];
    let backwards = |weights: [f64; 5]| {
        let [a, b, c, d, e] = weights;
        [-e, -d, -c, -b, -a]
    };
    (0..=last)
        .map(|k| match k {
            _ if around => {
                let near = |by: usize| at((k + by) % last);
                let (next, before) = (near(1), near(last - 1));
                let (far, behind) = (near(2), near(last - 2));
                std::array::from_fn(|i| (8.0 * (next[i] - before[i]) - (far[i] - behind[i])) / 12.0)
            }
            0 => sum(0, first),
            1 => sum(0, second),
            k if k == last => sum(last - 4, backwards(first)),
            k if k + 1 == last => sum(last - 4, backwards(second)),
            k => sum(k - 2, inner),
        })
        .collect()
}

/// The curve of cubics with these points and tangents, for steps of one.
fn cubics(points: &[[f64; 3]], tangents: &[[f64; 3]]) -> BsplineCurve {
    let mut control: Vec<[f64; 3]> = points.first().copied().into_iter().collect();
    let pairs = points.windows(2).zip(tangents.windows(2));
    for (point, slope) in pairs {
        let third = |k: usize, sign: f64| -> [f64; 3] {
            std::array::from_fn(|i| point[k][i] + sign * slope[k][i] / 3.0)
        };
        control.extend([third(0, 1.0), third(1, -1.0), point[1]]);
    }
    let steps = points.len().saturating_sub(1);
    #[allow(clippy::cast_precision_loss)]
    let breaks = (0..=steps).map(|k| k as f64 / steps as f64);
    let knots = Knots::clamped(3, breaks.collect(), 3);
    BsplineCurve::new(3, knots, control, None)
}
