//! The functions of one interval of a development, evaluated.

use crate::batch::widest;
use crate::chebyshev::{Interpolant, NODES, Row, Rows, bases, basis, nodes};

/// The functions of one interval.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Panel {
    pub from: f64,
    pub to: f64,
    pub theta: Interpolant,
    /// The flat rails.
    pub rails: [[Interpolant; 2]; 2],
    pub length: Interpolant,
    pub space: [[Interpolant; 3]; 2],
    pub normal: [Interpolant; 3],
    pub along: [Interpolant; 2],
    pub across: [Interpolant; 2],
    /// `-n' . t`: how fast the tangent plane turns about the ruling, positive towards `n`; an estimate.
    pub bending: Interpolant,
    /// Bounds for the error of any flat point of this interval and of the angle of a flat ruling.
    pub error: f64,
    pub angle_error: f64,
}

/// Everything about one ruling of a development.
#[derive(Debug, Clone, Copy)]
pub(super) struct At {
    pub rails: [[f64; 2]; 2],
    pub length: f64,
    pub space: [[f64; 3]; 2],
    pub across: [f64; 2],
    pub bending: f64,
}

/// What is carried from interval to interval.
#[derive(Debug, Default)]
pub(super) struct State {
    theta: f64,
    rail: [f64; 2],
    error: f64,
    pub angle_error: f64,
}

/// What an interval adds to the state.
#[derive(Debug, Clone)]
pub(super) struct Share {
    /// The turn, and the way of the first rail, as if the development began with this interval.
    pub theta: f64,
    pub rail: [f64; 2],
    /// Their errors, and those of the second rail against the first.
    pub angle_error: f64,
    pub rail_error: f64,
    pub far_error: f64,
    /// A bound of the ways along the rails, and of the rulings.
    pub way: f64,
    pub longest: f64,
    /// The sine of the largest twist.
    pub sine: f64,
    /// The integrals that belong to the whole: both flat rails and the area.
    pub totals: [Integral; 3],
    /// By how much each flat rail may be shorter than the edge of the patch.
    pub shortened: [f64; 2],
    /// Bounds on the interval for what a strain does to it: see [`Reach`].
    pub reach: Reach,
}

/// A number and a bound of its error.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Integral {
    pub value: f64,
    pub error: f64,
}

/// The largest `s0`, `(s0 + s1)/L`, `|P'|` and `L` of an interval, and its width: a strain of `e` lets each `s` vary by
/// `e s`.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Reach {
    pub width: f64,
    pub across: f64,
    pub turn: f64,
    pub speed: f64,
    pub length: f64,
}

impl Panel {
    /// The interval in its place behind those before, which `state` counts together: turned about the end of the first
    /// rail and moved there.
    pub(super) fn placed(mut self, share: &Share, state: &mut State) -> Self {
        let (sine, cosine) = libm::sincos(state.theta);
        for rail in &mut self.rails {
            let [x, y] = *rail;
            *rail = [
                Interpolant::sum([cosine, -sine], [&x, &y], state.rail[0]),
                Interpolant::sum([sine, cosine], [&x, &y], state.rail[1]),
            ];
        }
        self.theta = Interpolant::sum([1.0, 0.0], [&self.theta; 2], state.theta);
        // Turning and moving is rounded, and so are the sums.
        let far = state.rail[0].abs() + state.rail[1].abs() + share.way + share.longest;
        let rounding = 16.0 * f64::EPSILON * far;
        state.angle_error += share.angle_error + 4.0 * f64::EPSILON * (1.0 + state.theta.abs());
        state.error += share.rail_error + share.way * state.angle_error + rounding;
        self.angle_error = state.angle_error;
        self.error = state.error + share.longest * state.angle_error + share.far_error;
        let [x, y] = share.rail;
        state.rail[0] += cosine * x - sine * y;
        state.rail[1] += sine * x + cosine * y;
        state.theta += share.theta;
        self
    }

    /// The same interval of a patch that lies elsewhere in space.
    pub(super) fn moved_in_space(mut self, by: [f64; 3]) -> Self {
        for rail in &mut self.space {
            for (axis, by) in rail.iter_mut().zip(by) {
                *axis = Interpolant::sum([1.0, 0.0], [&axis.clone(); 2], by);
            }
        }
        self
    }

    pub(super) fn range(&self) -> [f64; 2] {
        [self.from, self.to]
    }

    pub(super) fn basis(&self, x: f64) -> Row {
        let t = (x - self.from) / (self.to - self.from);
        basis((2.0 * t - 1.0).clamp(-1.0, 1.0))
    }

    /// [`basis`] at the first parameters, and at the last of them again.
    #[inline(always)]
    fn bases<const L: usize>(&self, xs: &[f64]) -> Rows<L> {
        let last = xs.last().copied().unwrap_or(self.from);
        bases(std::array::from_fn(|k| {
            let x = xs.get(k).copied().unwrap_or(last);
            let t = (x - self.from) / (self.to - self.from);
            (2.0 * t - 1.0).clamp(-1.0, 1.0)
        }))
    }

    /// The rulings at up to `L` parameters of this interval.
    pub(super) fn each<const L: usize>(&self, xs: &[f64]) -> [At; L] {
        widest(
            #[inline(always)]
            || {
                let rows: Rows<L> = self.bases(xs);
                let rails = self.rails.each_ref().map(
                    #[inline(always)]
                    |rail| values(rail, &rows),
                );
                let space = self.space.each_ref().map(
                    #[inline(always)]
                    |rail| values(rail, &rows),
                );
                let across = values(&self.across, &rows);
                let (length, bending) = (self.length.at_each(&rows), self.bending.at_each(&rows));
                std::array::from_fn(
                    #[inline(always)]
                    |k| At {
                        rails: rails.map(|rail| rail[k]),
                        length: length[k],
                        space: space.map(|rail| rail[k]),
                        across: across[k],
                        bending: bending[k],
                    },
                )
            },
        )
    }

    /// The normals at up to `L` parameters of this interval.
    pub(super) fn normals<const L: usize>(&self, xs: &[f64]) -> [[f64; 3]; L] {
        widest(
            #[inline(always)]
            || values(&self.normal, &self.bases(xs)),
        )
    }

    /// The part of a flat rail on `[from, to]`, inside this interval, as polynomials of its own.
    pub(super) fn rail_between(&self, side: usize, from: f64, to: f64) -> [Interpolant; 2] {
        if from <= self.from && to >= self.to {
            return self.rails[side];
        }
        let mut values = [[0.0; NODES]; 2];
        for (k, x) in nodes(from.max(self.from), to.min(self.to))
            .into_iter()
            .enumerate()
        {
            let row = self.basis(x);
            for (values, f) in values.iter_mut().zip(&self.rails[side]) {
                values[k] = f.at(&row);
            }
        }
        values.each_ref().map(Interpolant::through)
    }
}

/// The values of some functions at several parameters.
#[inline(always)]
fn values<const K: usize, const L: usize>(
    functions: &[Interpolant; K],
    rows: &Rows<L>,
) -> [[f64; K]; L] {
    let mut values = [[0.0; K]; L];
    for (i, function) in functions.iter().enumerate() {
        for (value, slot) in function.at_each(rows).into_iter().zip(&mut values) {
            slot[i] = value;
        }
    }
    values
}
