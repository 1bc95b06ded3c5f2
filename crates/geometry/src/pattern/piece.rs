//! A patch of a chain: its development, its fitted rails, where it lies and which way the chain passes it.

use super::development::Development;
use super::panel::At;
use super::placement::Placement;
use super::segment::Segment;

/// A patch of the chain.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Piece {
    pub development: Development,
    /// The fitted rails, with growing parameter, as developed.
    rails: [Vec<Segment>; 2],
    /// The largest distance of a fitted rail.
    pub fitted: f64,
    stations: Vec<f64>,
    pub placement: Placement,
    /// Whether the chain passes it from `x = 1` to `x = 0`.
    pub backward: bool,
    /// What errors of the pieces before and of the joints add to its points and angles.
    pub inherited: [f64; 2],
    /// By how much other developments of the pieces before move it.
    pub moved_by_choice: f64,
}

impl Piece {
    pub(super) fn new(
        development: Development,
        rails: [Vec<Segment>; 2],
        fitted: f64,
        stations: Vec<f64>,
    ) -> Self {
        Self {
            development,
            rails,
            fitted,
            stations,
            placement: Placement::default(),
            backward: false,
            inherited: [0.0; 2],
            moved_by_choice: 0.0,
        }
    }

    /// The parameters of the rulings in the order of the chain.
    pub(super) fn stations(&self) -> Vec<f64> {
        let list = self.stations.iter().copied();
        if self.backward {
            list.rev().collect()
        } else {
            list.collect()
        }
    }

    /// The parameter of the first (0) or last (1) ruling that the chain passes.
    pub(super) fn end(&self, last: bool) -> f64 {
        if last == self.backward { 0.0 } else { 1.0 }
    }

    /// The rail to the left of one who follows the chain.
    pub(super) fn left(&self) -> usize {
        usize::from(self.backward != self.placement.is_mirrored())
    }

    /// The segments of a rail in the order of the chain.
    pub(super) fn rail(&self, side: usize) -> Vec<Segment> {
        let mut list: Vec<Segment> = self.rails[side]
            .iter()
            .map(|s| self.placement.segment(s))
            .collect();
        if self.backward {
            list.reverse();
            list = list.iter().map(Segment::reversed).collect();
        }
        list
    }

    /// The normals towards the viewer.
    pub(super) fn seen(&self, xs: &[f64]) -> Vec<[f64; 3]> {
        let mut normals = self.development.normals(xs);
        if self.placement.is_mirrored() {
            normals = normals.into_iter().map(|n| n.map(|c| -c)).collect();
        }
        normals
    }

    /// The direction of a ruling from the left to the right rail, not normalised.
    pub(super) fn axis(&self, at: &At) -> [f64; 3] {
        let [from, to] = [self.left(), 1 - self.left()].map(|side| at.space[side]);
        std::array::from_fn(|i| to[i] - from[i])
    }

    /// Halfway between each two rulings in the order of the chain.
    pub(super) fn halfway(&self) -> Vec<f64> {
        let stations = self.stations();
        let pairs = stations.iter().zip(stations.iter().skip(1));
        pairs.map(|(a, b)| 0.5 * (a + b)).collect()
    }

    /// The piece moved, with more error of its points and angles.
    pub(super) fn moved(self, placement: &Placement, [point, angle]: [f64; 2]) -> Self {
        Self {
            placement: self.placement.then(placement),
            inherited: [self.inherited[0] + point, self.inherited[1] + angle],
            ..self
        }
    }

    /// The same piece of a patch that lies elsewhere in space.
    pub(super) fn moved_in_space(self, by: [f64; 3]) -> Self {
        Self {
            development: self.development.moved_in_space(by),
            ..self
        }
    }

    /// The piece passed the other way.
    pub(super) fn turned(&self) -> Self {
        Self {
            backward: !self.backward,
            ..self.clone()
        }
    }
}
