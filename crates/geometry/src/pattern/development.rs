//! The development of a ruled patch: the flat rails as functions of the parameter, with error bounds.
//!
//! With `e = (cos theta, sin theta)` and `e_perp = (-sin theta, cos theta)` the flat image of a ruling and of
//! the rails obey (see `frame` for the functions on the right)
//!
//! ```text
//! theta' = turn,     p' = along e + across e_perp,     q = p + |R| e.
//! ```
//!
//! The system is triangular: two quadratures, one after the other. Both are done on intervals by
//! interpolation of degree 16 and exact integration of the interpolants. Every interval is checked at four
//! parameters between the samples, where the interpolants meet the functions afresh; with the size of the last
//! coefficients that bounds the *defect* `d` of each right side, as far as a finite number of samples can.
//! Intervals whose defect is too large are halved. Then, by integration,
//!
//! ```text
//! |error of theta| <= E = integral of d_theta,    |error of p| <= integral of d_p + |p'| E,
//! ```
//!
//! and of a point on the ruling by `|R| E` more. Roundings of the samples are counted in `d`.

use super::error::{PatternError, PatternResult};
use super::frame::{Frame, check_across};
use crate::batch::widest;
use crate::chebyshev::{
    DEGREE, Interpolant, NODES, Row, Rows, bases, basis, between, node_rows, nodes,
};
use crate::surface::Rails;
use crate::vector::dot;
use rayon::prelude::*;

/// How many rulings are evaluated side by side.
const LANES: usize = 8;
/// The most intervals of a development.
const MOST_PANELS: usize = 1 << 12;
/// The shortest interval, as a number of halvings.
const DEEPEST: u32 = 36;
/// The coarsest error that is allowed, as a share of the size of the patch.
const COARSEST: f64 = 0.0025;
/// The checks see the defect at four parameters of an interval: the largest may be larger.
const SAFETY: f64 = 2.0;
/// Normals as precise as bends are asked for, in radians.
const NORMAL_DEFECT: f64 = 1e-7;

/// The functions of one interval.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Panel {
    from: f64,
    to: f64,
    theta: Interpolant,
    /// The flat rails.
    rails: [[Interpolant; 2]; 2],
    length: Interpolant,
    space: [[Interpolant; 3]; 2],
    normal: [Interpolant; 3],
    along: [Interpolant; 2],
    across: [Interpolant; 2],
    /// `-n' . t`: how fast the tangent plane turns about the ruling, positive towards `n`.
    bending: Interpolant,
    /// Bounds for the error of any flat point of this interval and of the angle of a flat ruling.
    error: f64,
    angle_error: f64,
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

/// A development with the first rail starting at the origin and the first ruling along the first axis; the patch
/// proceeds along the second axis, and its normal `R x (P' + Q')` points to the viewer.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Development {
    panels: Vec<Panel>,
    /// The largest strain.
    pub strain: f64,
    /// The error of any flat point.
    pub error: f64,
    /// The error of the angle of any flat ruling, in radians.
    pub angle_error: f64,
    /// The exact lengths of the flat rails and the exact area, up to `quadrature`.
    pub lengths: [f64; 2],
    pub area: f64,
    pub quadrature: [f64; 2],
    /// The largest coordinate of a flat point is not above this.
    pub size: f64,
}

impl Development {
    /// Develops with a vertex error of at most `allowed` (a length) on at least `panels` intervals.
    pub(super) fn of(
        patch: &(impl Rails<f64> + ?Sized),
        panels: usize,
        allowed: f64,
        strain: f64,
    ) -> PatternResult<Self> {
        let count = panels.clamp(1, MOST_PANELS);
        #[allow(clippy::cast_precision_loss)]
        let cut = |i: usize| i as f64 / count as f64;
        let equal: Vec<_> = (0..count).map(|i| [cut(i), cut(i + 1)]).collect();
        let samples = sampled(patch, &equal)?;
        // How far an error of the angle acts: the width of the patch and the way along its rails.
        let reach = samples
            .iter()
            .flat_map(|s| &s.nodes)
            .map(|f| [f.length, f.speed()])
            .fold([0.0_f64; 2], |m, f| [m[0].max(f[0]), m[1].max(f[1])]);
        let allowed = allowed.min(COARSEST * (reach[0] + reach[1]));
        let demand = Demand {
            allowed,
            reach: reach[0] + reach[1],
            strain,
        };
        let mut state = State::default();
        let mut done = Vec::with_capacity(count);
        for (panel, part) in resolved(patch, samples, &demand)? {
            done.push(panel.placed(&part, &mut state));
        }
        let development = Self {
            error: done.iter().map(|p| p.error).fold(0.0, f64::max),
            angle_error: state.angle_error,
            panels: done,
            strain: state.strain,
            lengths: state.lengths,
            area: state.area,
            quadrature: state.quadrature,
            size: reach[0] + reach[1],
        };
        if development.error <= allowed {
            Ok(development)
        } else {
            Err(PatternError::NotReached {
                reached: development.error,
                demanded: allowed,
                x: 1.0,
            })
        }
    }

    pub(super) fn panels(&self) -> &[Panel] {
        &self.panels
    }

    fn panel_at(&self, x: f64) -> &Panel {
        let index = self.panels.partition_point(|p| p.to < x);
        &self.panels[index.min(self.panels.len() - 1)]
    }

    /// The ruling at `x` in [0, 1].
    pub(super) fn at(&self, x: f64) -> At {
        let [at] = self.panel_at(x).each(&[x]);
        at
    }

    /// The rulings at these parameters.
    pub(super) fn at_each(&self, xs: &[f64]) -> Vec<At> {
        let runs = self.runs(xs);
        runs.flat_map(|(panel, xs)| panel.each::<LANES>(xs).into_iter().take(xs.len()))
            .collect()
    }

    /// The normals of the patch at these parameters.
    pub(super) fn normals(&self, xs: &[f64]) -> Vec<[f64; 3]> {
        let runs = self.runs(xs);
        runs.flat_map(|(panel, xs)| panel.normals::<LANES>(xs).into_iter().take(xs.len()))
            .collect()
    }

    /// The parameters in runs that are evaluated side by side: of one interval each, and not too many.
    fn runs<'a>(&'a self, xs: &'a [f64]) -> impl Iterator<Item = (&'a Panel, &'a [f64])> {
        let mut rest = xs;
        std::iter::from_fn(move || {
            let (first, more) = rest.split_first()?;
            let panel = self.panel_at(*first);
            let inside = |x: &&f64| panel.from < **x && **x <= panel.to;
            let count = 1 + more.iter().take(LANES - 1).take_while(inside).count();
            let (run, after) = rest.split_at(count);
            rest = after;
            Some((panel, run))
        })
    }

    /// A point of a flat rail and the direction in which it proceeds, not normalised.
    pub(super) fn rail(&self, side: usize, x: f64) -> [[f64; 2]; 2] {
        let panel = self.panel_at(x);
        let row = panel.basis(x);
        let (s, c) = libm::sincos(panel.theta.at(&row));
        let (along, across) = (panel.along[side].at(&row), panel.across[side].at(&row));
        let tangent = [along * c - across * s, along * s + across * c];
        [panel.rails[side].each_ref().map(|f| f.at(&row)), tangent]
    }
}

impl Panel {
    /// The interval in its place behind those before, which `state` counts together: turned about the end of the first
    /// rail and moved there.
    fn placed(mut self, share: &Share, state: &mut State) -> Self {
        let (sine, cosine) = libm::sincos(state.theta);
        for rail in &mut self.rails {
            let [x, y] = *rail;
            *rail = [
                Interpolant::sum([cosine, -sine], [&x, &y], state.rail[0]),
                Interpolant::sum([sine, cosine], [&x, &y], state.rail[1]),
            ];
        }
        self.theta = Interpolant::sum([1.0, 0.0], [&self.theta; 2], state.theta);
        state.angle_error += share.defects[0];
        state.error += share.defects[1] + share.way * state.angle_error;
        self.angle_error = state.angle_error;
        self.error = state.error + share.longest * state.angle_error + share.far_defect;
        let [x, y] = share.rail;
        state.rail[0] += cosine * x - sine * y;
        state.rail[1] += sine * x + cosine * y;
        state.theta += share.theta;
        state.strain = state.strain.max(share.strain);
        for (sum, part) in state.lengths.iter_mut().zip(share.lengths) {
            *sum += part;
        }
        state.area += share.area;
        for (sum, part) in state.quadrature.iter_mut().zip(share.quadrature) {
            *sum += part;
        }
        self
    }

    pub(super) fn range(&self) -> [f64; 2] {
        [self.from, self.to]
    }

    fn basis(&self, x: f64) -> Row {
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
    fn each<const L: usize>(&self, xs: &[f64]) -> [At; L] {
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
    fn normals<const L: usize>(&self, xs: &[f64]) -> [[f64; 3]; L] {
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

struct Demand {
    allowed: f64,
    reach: f64,
    strain: f64,
}

/// What is carried from interval to interval.
#[derive(Default)]
struct State {
    theta: f64,
    rail: [f64; 2],
    error: f64,
    angle_error: f64,
    strain: f64,
    lengths: [f64; 2],
    area: f64,
    quadrature: [f64; 2],
}

/// What an interval adds to the state.
struct Share {
    theta: f64,
    rail: [f64; 2],
    strain: f64,
    lengths: [f64; 2],
    area: f64,
    quadrature: [f64; 2],
    /// Defects times the width: of the angle, and of the rail.
    defects: [f64; 2],
    /// The way along the rails at the greatest speed, and the longest ruling.
    way: f64,
    longest: f64,
    far_defect: f64,
}

/// The samples of these intervals, on all threads; the first error is that of the first interval.
fn sampled(
    patch: &(impl Rails<f64> + ?Sized),
    intervals: &[[f64; 2]],
) -> PatternResult<Vec<Samples>> {
    let one = |[from, to]: &[f64; 2]| Samples::of(patch, *from, *to);
    let all: Vec<_> = intervals.par_iter().map(one).collect();
    all.into_iter().collect()
}

/// The intervals with their functions, halved where these are not resolved: level by level, so that the threads
/// share the work of a level and the outcome does not depend on them.
fn resolved(
    patch: &(impl Rails<f64> + ?Sized),
    samples: Vec<Samples>,
    demand: &Demand,
) -> PatternResult<Vec<(Panel, Share)>> {
    let mut done: Vec<(Panel, Share)> = Vec::with_capacity(samples.len());
    let mut open = samples;
    let mut depth = 0;
    while !open.is_empty() {
        let tried: Vec<_> = open.par_iter().map(|s| s.panel(demand)).collect();
        let mut halves = Vec::new();
        for (samples, found) in open.iter().zip(tried) {
            match found? {
                Some(resolved) => done.push(resolved),
                None if depth >= DEEPEST || done.len() + halves.len() >= MOST_PANELS => {
                    return Err(samples.hopeless(demand.allowed));
                }
                None => {
                    let middle = 0.5 * (samples.from + samples.to);
                    halves.extend([[samples.from, middle], [middle, samples.to]]);
                }
            }
        }
        depth += 1;
        open = sampled(patch, &halves)?;
    }
    done.sort_by(|(a, _), (b, _)| a.from.total_cmp(&b.from));
    Ok(done)
}

impl Frame {
    fn speed(&self) -> f64 {
        let speed = |i: usize| libm::hypot(self.along[i], self.across[i]);
        speed(0).max(speed(1))
    }
}

/// The samples of one interval.
struct Samples {
    from: f64,
    to: f64,
    nodes: [Frame; NODES],
    checks: [Frame; 4],
}

impl Samples {
    fn of(patch: &(impl Rails<f64> + ?Sized), from: f64, to: f64) -> PatternResult<Self> {
        let mut frames = [Frame::at(patch, from)?; NODES];
        for (slot, x) in frames.iter_mut().zip(nodes(from, to)).skip(1) {
            *slot = Frame::at(patch, x)?;
        }
        let mut checks = [frames[0]; 4];
        for (slot, x) in checks.iter_mut().zip(between(from, to)) {
            *slot = Frame::at(patch, x)?;
        }
        Ok(Self {
            from,
            to,
            nodes: frames,
            checks,
        })
    }

    /// Why the interval cannot be resolved.
    fn hopeless(&self, demanded: f64) -> PatternError {
        let pairs = self.nodes.iter().zip(self.nodes.iter().skip(1));
        let over = pairs
            .filter(|(a, b)| dot(&a.normal, &b.normal) < 0.5)
            .map(|(a, b)| 0.5 * (a.x + b.x))
            .next();
        match over {
            Some(x) => PatternError::NoTangentPlane { x },
            None => PatternError::NotReached {
                reached: demanded.next_up(),
                demanded,
                x: self.from,
            },
        }
    }

    fn all(&self) -> impl Iterator<Item = &Frame> {
        self.nodes.iter().chain(&self.checks)
    }

    fn interpolant(&self, f: impl Fn(&Frame) -> f64) -> Interpolant {
        Interpolant::through(&self.nodes.each_ref().map(f))
    }

    /// An interpolant and how far it is from the function, as far as the checks tell.
    fn checked(&self, rows: &[Row; 4], f: impl Fn(&Frame) -> f64) -> (Interpolant, f64) {
        let poly = self.interpolant(&f);
        let off = |(frame, row): (&Frame, &Row)| (poly.at(row) - f(frame)).abs();
        let largest = self.checks.iter().zip(rows).map(off).fold(0.0, f64::max);
        (poly, SAFETY * (largest + poly.tail()))
    }

    /// The functions of the interval, as if the development began with it; `None` where they are not resolved.
    fn panel(&self, demand: &Demand) -> PatternResult<Option<(Panel, Share)>> {
        let strain = self.all().fold(
            self.nodes[0],
            |m, f| if f.strain > m.strain { *f } else { m },
        );
        if strain.strain > demand.strain {
            return Err(PatternError::NotDevelopable {
                strain: strain.strain,
                limit: demand.strain,
                twist: strain.twist(),
                x: strain.x,
            });
        }
        for frame in self.all() {
            frame.check_regular()?;
        }
        let (width, half) = (self.to - self.from, 0.5 * (self.to - self.from));
        let rows = between(self.from, self.to)
            .map(|x| basis(((x - self.from) / half - 1.0).clamp(-1.0, 1.0)));
        let largest = |f: &dyn Fn(&Frame) -> f64| self.all().map(f).fold(0.0, f64::max);
        let rounding = [0, 1].map(|i| largest(&|f| f.rounding[i]));
        let (long, speed) = (largest(&|f| f.length), largest(&Frame::speed));

        let (turn, turn_defect) = self.checked(&rows, |f| f.turn);
        let theta = turn.integral(half, 0.0);
        let node_rows = node_rows();
        let velocity = |frame: &Frame, theta: f64| {
            let (s, c) = libm::sincos(theta);
            let (a, b) = (frame.along[0], frame.across[0]);
            [a * c - b * s, a * s + b * c]
        };
        let mut velocities = [[0.0; NODES]; 2];
        for ((k, frame), row) in self.nodes.iter().enumerate().zip(node_rows) {
            let v = velocity(frame, theta.at(row));
            (velocities[0][k], velocities[1][k]) = (v[0], v[1]);
        }
        let speeds = velocities.each_ref().map(Interpolant::through);
        let mut rail_defect = SAFETY * (speeds[0].tail() + speeds[1].tail());
        for (frame, row) in self.checks.iter().zip(&rows) {
            let v = velocity(frame, theta.at(row));
            let off = [0, 1].map(|i| v[i] - speeds[i].at(row));
            rail_defect = rail_defect.max(SAFETY * libm::hypot(off[0], off[1]));
        }
        let rail = [0, 1].map(|i| speeds[i].integral(half, 0.0));
        // The other rail from the first and the ruling, so that both ends are on the flat ruling.
        let (length, length_defect) = self.checked(&rows, |f| f.length);
        let opposite = |row: &Row, length: f64| {
            let (s, c) = libm::sincos(theta.at(row));
            [rail[0].at(row) + length * c, rail[1].at(row) + length * s]
        };
        let mut far = [[0.0; NODES]; 2];
        for ((k, frame), row) in self.nodes.iter().enumerate().zip(node_rows) {
            let q = opposite(row, frame.length);
            (far[0][k], far[1][k]) = (q[0], q[1]);
        }
        let far = far.each_ref().map(Interpolant::through);
        let mut far_defect = length_defect + SAFETY * (far[0].tail() + far[1].tail());
        for (frame, row) in self.checks.iter().zip(&rows) {
            let q = opposite(row, frame.length);
            let off = [0, 1].map(|i| q[i] - far[i].at(row));
            far_defect = far_defect.max(length_defect + SAFETY * libm::hypot(off[0], off[1]));
        }
        let mut space_defect = 0.0_f64;
        let space = [0, 1].map(|side| {
            [0, 1, 2].map(|axis| {
                let (poly, defect) = self.checked(&rows, |f| f.ends[side][axis]);
                space_defect = space_defect.max(defect);
                poly
            })
        });
        let mut normal_defect = 0.0_f64;
        let normal = [0, 1, 2].map(|axis| {
            let (poly, defect) = self.checked(&rows, |f| f.normal[axis]);
            normal_defect = normal_defect.max(defect);
            poly
        });

        // Is it resolved? Not below what rounding leaves, and short intervals may be as bad as their share.
        let part = width.max(1.0 / 1024.0);
        let quadrature = width * (turn_defect * demand.reach + rail_defect);
        let noise = 8.0 * (rounding[0] * demand.reach + rounding[1]);
        let worst = [quadrature / part, far_defect, space_defect]
            .into_iter()
            .fold(0.0, f64::max);
        if worst > (0.25 * demand.allowed).max(noise) || normal_defect > NORMAL_DEFECT.max(noise) {
            return Ok(None);
        }
        let across = [0, 1].map(|i| self.interpolant(|f| f.across[i]));
        self.check_between(&across, rounding[1])?;
        let along = [0, 1].map(|i| self.interpolant(|f| f.along[i]));

        let end = basis(1.0);
        let mut share = Share {
            theta: theta.at(&end),
            rail: rail.each_ref().map(|f| f.at(&end)),
            strain: strain.strain,
            lengths: [0.0; 2],
            area: 0.0,
            quadrature: [0.0; 2],
            defects: [turn_defect + rounding[0], rail_defect + rounding[1]].map(|d| width * d),
            way: width * speed,
            longest: long,
            far_defect,
        };
        self.measure(half, &mut share);
        let bending = self.bending(half, &normal);
        let panel = Panel {
            from: self.from,
            to: self.to,
            theta,
            rails: [rail, far],
            length,
            space,
            normal,
            along,
            across,
            bending,
            error: 0.0,
            angle_error: 0.0,
        };
        Ok(Some((panel, share)))
    }

    /// The sign of the speeds across the ruling between the samples.
    fn check_between(&self, across: &[Interpolant; 2], rounding: f64) -> PatternResult<()> {
        let near = |f: &Frame| f.across[0].min(f.across[1]) < 0.25 * f.across[0].max(f.across[1]);
        if !self.all().any(near) {
            return Ok(());
        }
        let fine = u32::try_from(4 * DEGREE).unwrap_or(64);
        for k in 1..fine {
            let share = f64::from(k) / f64::from(fine);
            let row = basis(2.0 * share - 1.0);
            let x = self.from + share * (self.to - self.from);
            let speeds = across.each_ref().map(|f| f.at(&row));
            let slack = rounding + across[0].tail() + across[1].tail();
            check_across(x, speeds, self.nodes[0].length, slack)?;
        }
        Ok(())
    }

    /// Adds the lengths of the rails and the area of the interval: `|R| (a + b)/2` for each `dx`.
    fn measure(&self, half: f64, share: &mut Share) {
        let mut add = |sum: &mut f64, slot: usize, f: &dyn Fn(&Frame) -> f64| {
            let poly = self.interpolant(f);
            let total = poly.total(half);
            *sum += total;
            share.quadrature[slot] +=
                2.0 * half * SAFETY * poly.tail() + 4.0 * f64::EPSILON * total.abs();
        };
        let [mut first, mut second] = share.lengths;
        let mut area = share.area;
        add(&mut first, 0, &|f| libm::hypot(f.along[0], f.across[0]));
        add(&mut second, 0, &|f| libm::hypot(f.along[1], f.across[1]));
        add(&mut area, 1, &|f| {
            0.5 * f.length * (f.across[0] + f.across[1])
        });
        (share.lengths, share.area) = ([first, second], area);
    }

    fn bending(&self, half: f64, normal: &[Interpolant; 3]) -> Interpolant {
        let slopes = normal.each_ref().map(|f| f.derivative(half));
        let mut values = [0.0; NODES];
        for (k, row) in node_rows().iter().enumerate() {
            let frame = &self.nodes[k];
            let ruling = [0, 1, 2].map(|i| (frame.ends[1][i] - frame.ends[0][i]) / frame.length);
            let across = crate::vector::cross(&frame.normal, &ruling);
            let slope = slopes.each_ref().map(|f| f.at(row));
            values[k] = -dot(&slope, &across);
        }
        Interpolant::through(&values)
    }
}
