//! One interval of a development: its functions as models, and what they prove.
//!
//! With `e = (cos theta, sin theta)` and `e_perp = (-sin theta, cos theta)` the flat image of a ruling and of the rails
//! obeys
//!
//! ```text
//! theta' = turn = (a1 - a0)/L,     p' = along e + a0 e_perp,     q = p + L e,
//! ```
//!
//! with `along = P' . r`, the speed of the rail along the ruling, and `a0, a1` the speeds across it that the
//! development has (module `flattening`). All of them are models, so each radius is a proved bound over the whole
//! interval. The system is triangular and a rotation keeps lengths: errors add up and are not amplified,
//!
//! ```text
//! |error of theta| <= E = integral of radius(turn),     |error of p| <= radius of the integral + integral of |p'| E,
//! ```
//!
//! and that of a point on the ruling `L E` more.

use super::flattening::{Across, Flattening, Sides};
use super::panel::{Integral, Panel, Reach, Share};
use super::source::{Source, Strip};
use crate::chebyshev::{Interpolant, NODES, node_rows, nodes};
use crate::coordinate::Coordinate;
use crate::developable::Extent;
use crate::model::ChebyshevModel;
use crate::vector::{add, cross, det, dot, sub};

/// What is asked of the functions of an interval.
pub(super) struct Demand {
    /// The error that flat points may have.
    pub allowed: f64,
    /// How far an error of the angle acts: the width of the patch and the way along its rails.
    pub reach: f64,
    /// The sizes of rulings and speeds, as powers of two.
    pub extent: Extent,
    pub flattening: Flattening,
}

/// Normals as precise as bends are asked for, in radians.
const NORMAL_ERROR: f64 = 1e-7;
/// Bounds that rounding does not let fall below this share of the size of the patch are good enough.
const NOISE: f64 = 1e-12;

/// An interval of the parameter that is short.
const SHORT: f64 = 1.0 / 1024.0;

/// Speeds across the ruling that are negative by no more than this share are those of an edge of regression on the
/// border.
const TOUCHING: f64 = 1e-10;

/// What became of an interval.
pub(super) enum Tried {
    /// Its functions, as if the development began with it.
    Resolved(Box<(Panel, Share)>),
    /// It is too long.
    Halve,
    /// At this parameter the edge of regression runs between the rails: the speeds across, and the length of the
    /// ruling.
    Crossed {
        x: f64,
        across: [f64; 2],
        length: f64,
    },
}

type Vector = [ChebyshevModel; 3];

/// The functions of an interval, in units of the extent.
struct Functions {
    normal: Vector,
    length: ChebyshevModel,
    along: [ChebyshevModel; 2],
    across: Across,
    turn: ChebyshevModel,
    sine: f64,
    /// Bounds of `s0` and `s1`.
    speeds: [f64; 2],
}

impl Functions {
    fn enclose(strip: &Strip, source: &dyn Source, demand: &Demand) -> Option<Self> {
        let Extent { length, speed } = demand.extent;
        let [[p, dp], [q, dq]] = strip;
        let by = |v: &Vector, power: i32| v.map(|c| c.times_two_to(-power));
        let ruling = by(&sub(q, p), length);
        let slopes = [by(dp, speed), by(dq, speed)];
        let square = dot(&ruling, &ruling);
        let long = square.root()?;
        let normals = slopes.map(|slope| cross(&ruling, &slope));
        let [n0, n1] = &normals;
        let change = cross(&ruling, &sub(&slopes[1], &slopes[0]));
        let middle = |v: &Vector| {
            let [x, y, z] = v.map(|c| c.at(0.0));
            (x * x + y * y + z * z).sqrt()
        };
        // Where the rails run against each other either of them gives the plane.
        let mean = add(n0, n1);
        let candidates = [&mean, n0, n1];
        let sizes = candidates.map(middle);
        let chosen = if sizes[0] > 1e-3 * (sizes[1] + sizes[2]) {
            candidates[0]
        } else if sizes[1] >= sizes[2] {
            candidates[1]
        } else {
            candidates[2]
        };
        let size = dot(chosen, chosen).root()?;
        let [Some(x), Some(y), Some(z)] = chosen.map(|c| c.quotient(&size)) else {
            return None;
        };
        let normal = [x, y, z];
        let exact = source.is_exact();
        let across = demand.flattening.across(&Sides {
            normals: [n0, n1],
            between: &normal,
            change: &change,
            length: &long,
            exact,
        })?;
        let turn = across.change.quotient(&long)?;
        let along = slopes.map(|slope| dot(&slope, &ruling).quotient(&long));
        let [Some(first), Some(second)] = along else {
            return None;
        };
        let sizes = [dot(n0, n0), dot(n1, n1)].map(|s| s.range());
        let still = |i: usize| sizes[i][1] <= 1e-20 * sizes[1 - i][1];
        let sine = if exact || still(0) || still(1) {
            0.0
        } else {
            // sin(tau) = L |D|/(|N0| |N1|).
            let twist = det(&slopes[0], &slopes[1], &ruling);
            let squares = dot(n0, n0) * dot(n1, n1);
            let ratio = (twist * twist * square).quotient(&squares)?;
            let sine = ratio.sharply_largest().sqrt() * (1.0 + 4.0 * f64::EPSILON);
            // A right angle or more is no sheet.
            if !(sine < 1.0 && dot(n0, n1).range()[0] > 0.0) {
                return None;
            }
            sine
        };
        let speeds = [0, 1].map(|i| sizes[i][1].max(0.0).sqrt() / long.least());
        Some(Self {
            normal,
            length: long,
            along: [first, second],
            across,
            turn,
            sine,
            speeds,
        })
    }
}

/// The functions of an interval; `None` of the strip makes it too long.
pub(super) fn tried(source: &dyn Source, [from, to]: [f64; 2], demand: &Demand) -> Tried {
    let Some(strip) = source.strip(from, to) else {
        return Tried::Halve;
    };
    let Some(functions) = Functions::enclose(&strip, source, demand) else {
        return Tried::Halve;
    };
    let signed = &functions.across.signed;
    let fastest = functions.speeds[0].max(functions.speeds[1]);
    let slack = TOUCHING * fastest;
    let values = signed.each_ref().map(ChebyshevModel::at_nodes);
    let room = [0, 1].map(|i| signed[i].radius() + slack);
    for (k, x) in nodes(from, to).into_iter().enumerate() {
        let across = [values[0][k], values[1][k]];
        if across[0] < -room[0] || across[1] < -room[1] {
            let length = functions.length.at_nodes()[k].times_two_to(demand.extent.length);
            return Tried::Crossed { x, across, length };
        }
    }
    if signed.iter().any(|a| a.range()[0] < -slack) {
        return Tried::Halve;
    }
    match assembled(&strip, &functions, [from, to], demand) {
        Some(found) => Tried::Resolved(Box::new(found)),
        None => Tried::Halve,
    }
}

fn assembled(
    strip: &Strip,
    functions: &Functions,
    [from, to]: [f64; 2],
    demand: &Demand,
) -> Option<(Panel, Share)> {
    let half = 0.5 * (to - from);
    let width = to - from;
    let Extent { length, speed } = demand.extent;
    let turn = functions.turn.times_two_to(speed - length);
    let along = functions.along.map(|a| a.times_two_to(speed));
    let across = functions.across.speeds.map(|a| a.times_two_to(speed));
    let long = functions.length.times_two_to(length);
    let [cosine, sine] = ChebyshevModel::direction(&turn, half)?;
    let velocity = [
        along[0] * cosine - across[0] * sine,
        along[0] * sine + across[0] * cosine,
    ];
    let rail = velocity.map(|v| v.integral(half));
    let far = [rail[0] + long * cosine, rail[1] + long * sine];
    let theta = turn.polynomial().integral(half);
    let radius = |pair: &[ChebyshevModel; 2]| pair[0].radius() + pair[1].radius();
    let angle_error = width * turn.radius() + theta.radius();
    let rail_error = radius(&rail);
    let far_error = radius(&far);
    let normal_error = functions
        .normal
        .iter()
        .map(ChebyshevModel::radius)
        .fold(0.0, f64::max);
    // Short intervals may be as bad as their share of 1/1024, and at the end of the patch their angle turns little more
    // than themselves: towards a tip directions lose digits as the rulings shrink.
    let part = width.max(SHORT);
    let turned = if width < SHORT {
        demand
            .reach
            .min((1.0 - from) * demand.reach + long.largest())
    } else {
        demand.reach
    };
    let noise = NOISE * demand.reach;
    let worst = ((angle_error * turned + rail_error) / part).max(far_error);
    if worst.is_nan()
        || worst > (0.25 * demand.allowed).max(noise)
        || normal_error * long.largest() > NORMAL_ERROR * demand.reach
    {
        return None;
    }
    let speeds = functions.speeds.map(|s| s.times_two_to(speed));
    let fast = (0..2)
        .map(|i| along[i].largest() + speeds[i])
        .fold(0.0, f64::max);
    let total = |f: &ChebyshevModel| {
        let [value, error] = f.total(half);
        Integral { value, error }
    };
    let flat_speed = |i: usize| -> ChebyshevModel {
        let square = along[i] * along[i] + across[i] * across[i];
        // A rail that stands still somewhere: the values, within what is left of the bound.
        square.root().unwrap_or_else(|| {
            let values = square.at_nodes().map(|s| s.max(0.0).sqrt());
            let poly = ChebyshevModel::through(&values);
            // |y - sqrt g|^2 <= |y^2 - g| where y is not negative.
            let below = (-poly.range()[0]).max(0.0);
            poly.widened((poly * poly - square).largest().sqrt() + 2.0 * below)
        })
    };
    let half_length = long.times_two_to(-1);
    let share = Share {
        theta: theta.at(1.0),
        rail: rail.each_ref().map(|f| f.at(1.0)),
        angle_error,
        rail_error,
        far_error,
        way: width * fast,
        longest: long.largest(),
        sine: functions.sine,
        totals: [
            total(&flat_speed(0)),
            total(&flat_speed(1)),
            total(&(half_length * (across[0] + across[1]))),
        ],
        shortened: demand
            .flattening
            .shortened(functions.sine, speeds)
            .map(|lost| lost * width),
        reach: Reach {
            width,
            across: speeds[0],
            turn: (speeds[0] + speeds[1]) / long.least(),
            speed: fast,
            length: long.largest(),
        },
    };
    let space =
        [&strip[0][0], &strip[1][0]].map(|end| end.each_ref().map(ChebyshevModel::interpolant));
    let normal = functions.normal.each_ref().map(ChebyshevModel::interpolant);
    let panel = Panel {
        from,
        to,
        theta: theta.interpolant(),
        rails: [rail, far].map(|pair| pair.each_ref().map(ChebyshevModel::interpolant)),
        length: long.interpolant(),
        bending: bending(&normal, &space, half),
        space,
        normal,
        along: along.each_ref().map(ChebyshevModel::interpolant),
        across: across.each_ref().map(ChebyshevModel::interpolant),
        error: 0.0,
        angle_error: 0.0,
    };
    Some((panel, share))
}

fn bending(normal: &[Interpolant; 3], space: &[[Interpolant; 3]; 2], half: f64) -> Interpolant {
    let slopes = normal.each_ref().map(|f| f.derivative(half));
    let mut values = [0.0; NODES];
    for (value, row) in values.iter_mut().zip(node_rows()) {
        let at = |f: &[Interpolant; 3]| f.each_ref().map(|f| f.at(row));
        let ruling = sub(&at(&space[1]), &at(&space[0]));
        let length = super::frame::norm(&ruling);
        let across = cross(&at(normal), &ruling.map(|c| c / length));
        *value = -dot(&at(&slopes), &across);
    }
    Interpolant::through(&values)
}
