//! B-spline patches.

use crate::error::{ExchangeError, Result};
use torse_geometry::vector::{norm, sub};

/// The distinct knots of one direction with their multiplicities.
#[derive(Debug, Clone, PartialEq)]
pub struct Knots {
    values: Vec<f64>,
    multiplicities: Vec<usize>,
}

impl Knots {
    /// Knots of a clamped B-spline of this degree: the breaks, `inner` times each, the ends `degree + 1`
    /// times. The breaks must rise.
    pub(crate) fn clamped(degree: usize, breaks: Vec<f64>, inner: usize) -> Self {
        let last = breaks.len().saturating_sub(1);
        let times = |i: usize| {
            if i == 0 || i == last {
                degree + 1
            } else {
                inner
            }
        };
        Self {
            multiplicities: (0..breaks.len()).map(times).collect(),
            values: breaks,
        }
    }

    /// The knots of one polynomial piece on [0, 1].
    pub(crate) fn bezier(degree: usize) -> Self {
        Self::clamped(degree, vec![0.0, 1.0], 1)
    }

    /// The distinct values, rising.
    #[must_use]
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// How often each value counts.
    #[must_use]
    pub fn multiplicities(&self) -> &[usize] {
        &self.multiplicities
    }

    /// All knots, each as often as it counts.
    pub fn repeated(&self) -> impl Iterator<Item = f64> {
        let pairs = self.values.iter().zip(&self.multiplicities);
        pairs.flat_map(|(value, times)| std::iter::repeat_n(*value, *times))
    }

    /// The knots of the same curve run backwards.
    fn reversed(&self) -> Self {
        let ends = self.values.first().zip(self.values.last());
        let sum = ends.map_or(0.0, |(a, b)| a + b);
        Self {
            values: self.values.iter().rev().map(|t| sum - t).collect(),
            multiplicities: self.multiplicities.iter().rev().copied().collect(),
        }
    }
}

/// A B-spline surface on the unit square, rational if it has weights: the control net row by row, a row for
/// each step of `u`.
#[derive(Debug, Clone, PartialEq)]
pub struct BsplinePatch {
    degrees: [usize; 2],
    knots: [Knots; 2],
    net: Vec<Vec<[f64; 3]>>,
    weights: Option<Vec<Vec<f64>>>,
    developable: bool,
}

impl BsplinePatch {
    /// The patch with this net; the constructions of this module see to it that the numbers of knots and
    /// points fit and weights are positive.
    ///
    /// # Errors
    /// [`ExchangeError::NotFinite`].
    pub(crate) fn new(
        degrees: [usize; 2],
        knots: [Knots; 2],
        net: Vec<Vec<[f64; 3]>>,
        weights: Option<Vec<Vec<f64>>>,
    ) -> Result<Self> {
        for (index, point) in net.iter().flatten().enumerate() {
            if let Some(&value) = point.iter().find(|x| !x.is_finite()) {
                let what = "control point";
                return Err(ExchangeError::NotFinite { what, index, value });
            }
        }
        for (index, &value) in weights.iter().flatten().flatten().enumerate() {
            if !value.is_finite() {
                let what = "weight";
                return Err(ExchangeError::NotFinite { what, index, value });
            }
        }
        // Equal weights are none.
        let first = weights.iter().flatten().flatten().next().copied();
        let weights = weights.filter(|w| w.iter().flatten().any(|x| Some(*x) != first));
        Ok(Self {
            degrees,
            knots,
            net,
            weights,
            developable: false,
        })
    }

    /// The same patch, declared developable in formats that have a word for it. Of an approximation this says
    /// that its original is.
    #[must_use]
    pub fn declared_developable(self) -> Self {
        Self {
            developable: true,
            ..self
        }
    }

    /// Whether the patch is declared developable.
    #[must_use]
    pub fn is_declared_developable(&self) -> bool {
        self.developable
    }

    /// The degrees in `u` and `v`.
    #[must_use]
    pub fn degrees(&self) -> [usize; 2] {
        self.degrees
    }

    /// The knots in `u` and `v`.
    #[must_use]
    pub fn knots(&self) -> &[Knots; 2] {
        &self.knots
    }

    /// The control points.
    #[must_use]
    pub fn net(&self) -> &[Vec<[f64; 3]>] {
        &self.net
    }

    /// The weights, positive; `None` when all are equal.
    #[must_use]
    pub fn weights(&self) -> Option<&[Vec<f64>]> {
        self.weights.as_deref()
    }

    /// The four boundary curves, once around against the clock seen from the normal `S_u x S_v`: `v = 0`
    /// forwards, `u = 1` forwards, `v = 1` backwards, `u = 0` backwards.
    pub(crate) fn sides(&self) -> [BsplineCurve; 4] {
        let columns = self.net.first().map_or(0, Vec::len);
        let (last_row, last_column) = (self.net.len().saturating_sub(1), columns.saturating_sub(1));
        let side = |axis: usize, places: &dyn Fn(usize) -> (usize, usize), count: usize| {
            let at = |k: usize| places(k);
            let points = (0..count).filter_map(|k| self.net.get(at(k).0)?.get(at(k).1).copied());
            let weights = self.weights.as_ref().map(|list| {
                let weights = (0..count).filter_map(|k| list.get(at(k).0)?.get(at(k).1).copied());
                weights.collect()
            });
            BsplineCurve::new(
                self.degrees[axis],
                self.knots[axis].clone(),
                points.collect(),
                weights,
            )
        };
        [
            side(0, &|i| (i, 0), self.net.len()),
            side(1, &|j| (last_row, j), columns),
            side(0, &|i| (i, last_column), self.net.len()).reversed(),
            side(1, &|j| (0, j), columns).reversed(),
        ]
    }
}

/// A B-spline curve, rational if it has weights.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct BsplineCurve {
    pub(crate) degree: usize,
    pub(crate) knots: Knots,
    pub(crate) points: Vec<[f64; 3]>,
    pub(crate) weights: Option<Vec<f64>>,
}

impl BsplineCurve {
    /// The curve; a straight segment needs no weights, which would only move its parameter.
    pub(super) fn new(
        degree: usize,
        knots: Knots,
        points: Vec<[f64; 3]>,
        weights: Option<Vec<f64>>,
    ) -> Self {
        let first = weights.iter().flatten().next().copied();
        let moving = |w: &Vec<f64>| degree > 1 && w.iter().any(|x| Some(*x) != first);
        Self {
            degree,
            knots,
            points,
            weights: weights.filter(moving),
        }
    }

    pub(crate) fn reversed(&self) -> Self {
        Self {
            degree: self.degree,
            knots: self.knots.reversed(),
            points: self.points.iter().rev().copied().collect(),
            weights: self
                .weights
                .as_ref()
                .map(|w| w.iter().rev().copied().collect()),
        }
    }

    /// Whether all control points lie within `distance` of the first: the curve is a point.
    pub(crate) fn is_point(&self, distance: f64) -> bool {
        let near = |p: &[f64; 3]| {
            self.points
                .first()
                .is_some_and(|q| norm(&sub(p, q)) <= distance)
        };
        self.points.iter().all(near)
    }

    /// Whether the other curve has the same form and its control points lie within `distance` of those of
    /// this one, so that no point is farther.
    pub(crate) fn is_near(&self, other: &Self, distance: f64) -> bool {
        let near = |(p, q): (&[f64; 3], &[f64; 3])| norm(&sub(p, q)) <= distance;
        self.degree == other.degree
            && self.knots == other.knots
            && self.weights == other.weights
            && self.points.len() == other.points.len()
            && self.points.iter().zip(&other.points).all(near)
    }
}
