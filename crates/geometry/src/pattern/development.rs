//! The development of a ruled patch: the flat rails as functions of the parameter, with error bounds.
//!
//! The parameter is cut into intervals, each of which is halved until its functions are resolved (module `interval`);
//! then they are put one behind the other. At an end where the rulings shrink to a point or both rails stand still no
//! interval is ever resolved that reaches it: so much of the parameter is left to a bound of how far the rails move
//! there that this takes a small share of the error that is allowed, or `2^-36` of it.

use super::error::{PatternError, PatternResult};
use super::flattening::{Flattening, lost};
use super::frame::Frame;
use super::interval::{Demand, Tried, tried};
use super::panel::{At, Integral, Panel, Reach, Share, State};
use super::source::{PatternEvidence, Source};
use crate::chebyshev::{Interpolant, nodes};
use crate::developable::Extent;
use crate::parallel::prelude::*;
use crate::surface::{Rails, RulingEnd};
use crate::vector::dot;

/// How many rulings are evaluated side by side.
const LANES: usize = 8;
/// The most intervals of a development.
const MAX_PANELS: usize = 1 << 10;
/// The shortest interval, as a number of halvings.
const MAX_DEPTH: u32 = 44;
/// The most halvings at a special end, before what is left of it is bounded.
const END_DEPTH: u32 = 36;
/// What is left to a bound at a special end may add this share of the error that is allowed.
const END_SHARE: f64 = 1.0 / 64.0;
/// The coarsest error that is allowed, as a share of the size of the patch.
const COARSEST: f64 = 0.0025;

/// A development with the first rail starting at the origin and the first ruling along the first axis; the patch
/// proceeds along the second axis, and its normal `R x (P' + Q')` points to the viewer.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Development {
    panels: Vec<Panel>,
    /// Which development it is.
    pub flattening: Flattening,
    pub evidence: PatternEvidence,
    /// Whether the patch is exactly developable.
    pub exact: bool,
    /// The largest strain.
    pub strain: f64,
    /// The error of any flat point.
    pub error: f64,
    /// The error of the angle of any flat ruling, in radians.
    pub angle_error: f64,
    /// Every development with no more strain than that of an edge that keeps its length lies within this, after a
    /// motion.
    pub ambiguity: f64,
    /// The exact lengths of the flat rails and the exact area, up to `quadrature`.
    pub lengths: [f64; 2],
    pub area: f64,
    pub quadrature: [f64; 2],
    /// By how much each flat rail may be shorter than the edge in space.
    pub shortened: [f64; 2],
    /// The largest coordinate of a flat point is not above this.
    pub size: f64,
}

/// What a development is made for.
#[derive(Debug, Clone, Copy)]
pub(super) struct Wanted {
    /// The least number of intervals.
    pub panels: usize,
    /// The error of any flat point, a length.
    pub allowed: f64,
    /// The strain that is allowed.
    pub strain: f64,
    pub flattening: Flattening,
}

impl Development {
    /// Develops the patch, with the functions of `source`.
    pub(super) fn new<R: Rails<f64> + ?Sized>(
        patch: &R,
        source: &dyn Source,
        wanted: Wanted,
    ) -> PatternResult<Self> {
        // Dyadic ends are exact.
        let count = wanted.panels.clamp(1, MAX_PANELS).next_power_of_two();
        #[allow(clippy::cast_precision_loss)]
        let cut = |i: usize| i as f64 / count as f64;
        let equal: Vec<_> = (0..count).map(|i| [cut(i), cut(i + 1)]).collect();
        let extent = Extent::measure(patch, |x| x);
        let Some(extent) = extent else {
            return Err(diagnosed(patch, [0.0, 1.0], wanted.allowed));
        };
        let reach = reach(patch)?;
        let allowed = wanted.allowed.min(COARSEST * reach);
        let demand = Demand {
            allowed,
            reach,
            extent,
            flattening: wanted.flattening,
        };
        let mut state = State::default();
        let mut panels = Vec::with_capacity(count);
        let mut shares = Vec::with_capacity(count);
        for (panel, share) in resolved(patch, source, equal, &demand)? {
            panels.push(panel.placed(&share, &mut state));
            shares.push(share);
        }
        let sine = shares.iter().map(|share| share.sine).fold(0.0, f64::max);
        let strain = wanted.flattening.strain(sine);
        if strain > wanted.strain {
            let worst = shares
                .iter()
                .zip(&panels)
                .find(|(share, _)| share.sine == sine);
            return Err(PatternError::NotDevelopable {
                strain,
                limit: wanted.strain,
                twist: libm::asin(sine.min(1.0)),
                x: worst.map_or(0.0, |(_, panel)| 0.5 * (panel.from + panel.to)),
            });
        }
        let total = |k: usize| {
            let parts = shares.iter().filter_map(|share| share.totals.get(k));
            parts.fold(Integral::default(), |sum, part| Integral {
                value: sum.value + part.value,
                error: sum.error + part.error + f64::EPSILON * (sum.value + part.value).abs(),
            })
        };
        let [first, second, area] = [total(0), total(1), total(2)];
        let [low, high] = [0, 1].map(|rail| shares.iter().map(|s| s.shortened[rail]).sum());
        let development = Self {
            flattening: wanted.flattening,
            evidence: source.evidence(),
            exact: source.is_exact(),
            strain,
            error: panels.iter().map(|p| p.error).fold(0.0, f64::max),
            angle_error: state.angle_error,
            ambiguity: if source.is_exact() {
                0.0
            } else {
                ambiguity(&shares, lost(sine))
            },
            panels,
            lengths: [first.value, second.value],
            area: area.value,
            quadrature: [first.error + second.error, area.error],
            shortened: [low, high],
            size: reach,
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

    /// The same development of a patch that lies elsewhere in space.
    pub(super) fn moved_in_space(self, by: [f64; 3]) -> Self {
        let panels = self
            .panels
            .into_iter()
            .map(|panel| panel.moved_in_space(by));
        Self {
            panels: panels.collect(),
            ..self
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

/// The longest ruling and the way along the faster rail, as nine rulings show them.
fn reach<R: Rails<f64> + ?Sized>(patch: &R) -> PatternResult<f64> {
    let (mut length, mut speed) = (0.0_f64, 0.0_f64);
    for x in (0..=8).map(|k| f64::from(k) / 8.0) {
        let [[p, dp], [q, dq]] = patch.ends_and_slopes(&x)?;
        let size = |v: &[f64; 3]| super::frame::norm(v);
        let ruling = crate::vector::sub(&q, &p);
        length = length.max(size(&ruling));
        speed = speed.max(size(&dp)).max(size(&dq));
        if !(length.is_finite() && speed.is_finite()) {
            return Err(PatternError::NotFinite { x });
        }
    }
    Ok(length + speed)
}

/// With a strain of `strain` each `s` may vary by that share of it, to either side of where it is written or, where it
/// is written at one end of that, by twice as much: the way from the middle ruling to both ends.
fn ambiguity(shares: &[Share], strain: f64) -> f64 {
    let half = shares.len() / 2;
    let (before, after) = shares.split_at(half);
    let reached = |way: &mut dyn Iterator<Item = &Share>| {
        let (mut angle, mut point, mut worst) = (0.0_f64, 0.0_f64, 0.0_f64);
        for share in way {
            let Reach {
                width,
                across,
                turn,
                speed,
                length,
            } = share.reach;
            let room = 2.0 * strain * width;
            point += room * across + width * speed * (angle + 0.5 * room * turn);
            angle += room * turn;
            worst = worst.max(point + length * angle);
        }
        worst
    };
    reached(&mut before.iter().rev()).max(reached(&mut after.iter()))
}

/// The intervals with their functions, halved where these are not resolved: level by level, so that the threads
/// share the work of a level and the outcome does not depend on them.
fn resolved<R: Rails<f64> + ?Sized>(
    patch: &R,
    source: &dyn Source,
    intervals: Vec<[f64; 2]>,
    demand: &Demand,
) -> PatternResult<Vec<(Panel, Share)>> {
    let ends = patch.end_kinds().rulings();
    let mut done: Vec<(Panel, Share)> = Vec::with_capacity(intervals.len());
    let mut left = Vec::new();
    let mut open = intervals;
    let mut depth = 0;
    while !open.is_empty() {
        let found: Vec<_> = open
            .par_iter()
            .map(|range| tried(source, *range, demand))
            .collect();
        let mut halves = Vec::new();
        for (range, found) in open.iter().zip(found) {
            let [from, to] = *range;
            let kind = if from == 0.0 {
                ends[0]
            } else if to == 1.0 {
                ends[1]
            } else {
                RulingEnd::Ordinary
            };
            match found {
                Tried::Resolved(found) => done.push(*found),
                Tried::Crossed { x, across, length } => return Err(crossed(x, across, length)),
                Tried::Halve
                    if kind != RulingEnd::Ordinary
                        && (depth >= END_DEPTH
                            || (to - from) * demand.reach <= END_SHARE * demand.allowed
                                && source.strip(from, to).is_some()) =>
                {
                    left.push((*range, kind))
                }
                Tried::Halve if depth >= MAX_DEPTH || done.len() + halves.len() >= MAX_PANELS => {
                    return Err(diagnosed(patch, *range, demand.allowed));
                }
                Tried::Halve => {
                    let middle = 0.5 * (from + to);
                    halves.extend([[from, middle], [middle, to]]);
                }
            }
        }
        depth += 1;
        open = halves;
    }
    done.sort_by(|(a, _), (b, _)| a.from.total_cmp(&b.from));
    for (range, kind) in left {
        let first = range[0] == 0.0;
        let neighbour = if first { done.first() } else { done.last() };
        let strip = source.strip(range[0], range[1]);
        let (Some(neighbour), Some(strip)) = (neighbour, strip) else {
            return Err(diagnosed(patch, range, demand.allowed));
        };
        let cell = end_cell(neighbour, &strip, range, kind);
        if first {
            done.insert(0, cell);
        } else {
            done.push(cell);
        }
    }
    Ok(done)
}

/// The end of a patch that no interval reaches: as its neighbour leaves it, and no farther off than the rails move.
fn end_cell(
    (neighbour, share): &(Panel, Share),
    strip: &super::source::Strip,
    [from, to]: [f64; 2],
    kind: RulingEnd,
) -> (Panel, Share) {
    let first = from == 0.0;
    let width = to - from;
    let row = neighbour.basis(if first { to } else { from });
    let constant = |f: &Interpolant| Interpolant::constant(f.at(&row));
    let longest: f64 = strip
        .iter()
        .map(|[_, slope]| {
            slope
                .iter()
                .map(crate::ChebyshevModel::largest)
                .sum::<f64>()
        })
        .fold(0.0, f64::max)
        * width;
    let long = neighbour.length.at(&row);
    // A tip is a point, in which both rails end.
    let (length, far) = match kind {
        RulingEnd::Tip if first => (
            Interpolant::linear(0.0, long),
            Interpolant::linear(0.0, long),
        ),
        RulingEnd::Tip => (
            Interpolant::linear(long, 0.0),
            Interpolant::linear(long, 0.0),
        ),
        _ => (Interpolant::constant(long), Interpolant::constant(long)),
    };
    let zero = Interpolant::constant(0.0);
    let panel = Panel {
        from,
        to,
        theta: zero,
        rails: [[zero; 2], [far, zero]],
        length,
        space: strip
            .each_ref()
            .map(|[end, _]| end.each_ref().map(crate::ChebyshevModel::interpolant)),
        normal: neighbour.normal.each_ref().map(constant),
        along: neighbour.along.each_ref().map(constant),
        across: neighbour.across.each_ref().map(constant),
        bending: constant(&neighbour.bending),
        error: 0.0,
        angle_error: 0.0,
    };
    // A tip closes within the length of its last ruling.
    let open = if kind == RulingEnd::Tip { long } else { 0.0 };
    let error = 2.0 * longest + open;
    let part = Integral { value: 0.0, error };
    let share = Share {
        theta: 0.0,
        rail: [0.0; 2],
        angle_error: 0.0,
        rail_error: error,
        far_error: error,
        way: longest,
        longest: long,
        sine: share.sine,
        totals: [
            part,
            part,
            Integral {
                value: 0.0,
                error: error * long,
            },
        ],
        shortened: [0.0; 2],
        reach: Reach::default(),
    };
    (panel, share)
}

fn crossed(x: f64, [a, b]: [f64; 2], length: f64) -> PatternError {
    let v = if (a < 0.0) == (b < 0.0) {
        0.5
    } else {
        a / (a - b)
    };
    let cut_off = if a < b { v } else { 1.0 - v };
    PatternError::Regression {
        x,
        v,
        depth: cut_off * length,
    }
}

/// Why an interval cannot be resolved.
fn diagnosed<R: Rails<f64> + ?Sized>(
    patch: &R,
    [from, to]: [f64; 2],
    demanded: f64,
) -> PatternError {
    // What keeps an interval from being resolved may lie beside it.
    let beside = 16.0 * (to - from);
    let wide = nodes((from - beside).max(0.0), (to + beside).min(1.0));
    let mut frames = Vec::with_capacity(2 * wide.len());
    for x in nodes(from, to).into_iter().chain(wide) {
        match Frame::at(patch, x).and_then(|frame| frame.check_regular().map(|()| frame)) {
            Ok(frame) => frames.push(frame),
            Err(error) => return error,
        }
    }
    frames.sort_by(|a, b| a.x.total_cmp(&b.x));
    let pairs = frames.iter().zip(frames.iter().skip(1));
    let over = pairs
        .filter(|(a, b)| dot(&a.normal, &b.normal) < 0.5)
        .map(|(a, b)| 0.5 * (a.x + b.x))
        .next();
    if let Some(x) = over {
        return PatternError::NoTangentPlane { x };
    }
    let twisted = frames.iter().find(|frame| frame.twist() > 1.5);
    if let Some(frame) = twisted {
        return PatternError::NotDevelopable {
            strain: frame.strain,
            limit: 0.0,
            twist: frame.twist(),
            x: frame.x,
        };
    }
    PatternError::NotReached {
        reached: demanded.next_up(),
        demanded,
        x: from,
    }
}
