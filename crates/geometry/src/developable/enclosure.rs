//! Certificates that enclose: between which bounds the numbers of [`certify`](super::certify) lie.
//!
//! With rails `P, Q`, ruling `R = Q - P` and normals `N0 = P' x R`, `N1 = Q' x R` at its ends, five functions
//! of `x` say everything:
//!
//! ```text
//! D = det(P', Q', R),   a = |N0|^2,   b = |N1|^2,   h = N0 . N1,   r = |R|^2
//!
//! normalised determinant   |D| / (|P'| |Q'| |R|)
//! twist                    tan = |N0 x N1| / |h| = sqrt(r) |D| / |h|
//! least |N(v)|^2           max(min(a, h, b), r D^2/(a + b - 2h)),   N(v) = (1 - v) N0 + v N1
//! Gaussian curvature       |K| = D^2 / |N|^4, largest where |N| is least
//! clearance                sqrt(r) (h - min(a, b)) / (a + b - 2h)
//! ```
//!
//! `|N(v)|^2` is the quadratic with the Bernstein coefficients `a, h, b`, which lies above the least of them;
//! its free minimum is `(a b - h^2)/(a + b - 2h)`, and `a b - h^2 = r D^2`. One of the two is attained. With
//! `m = min(sqrt a, sqrt b)`, `e = |sqrt a - sqrt b|` and `d = sqrt(a b) - h = r D^2/(sqrt(a b) + h)` the clearance is
//! `sqrt(r) (m e - d)/(e^2 + 2d)`: no cancellation, rising in `m`, falling in `d` and with one summit in `e`,
//! so its bounds are at the ends.
//!
//! On an interval of half width `w` each function is its Taylor polynomial at the middle with the last
//! coefficient taken over the interval (Lagrange), all on balls: the excess falls with `w^6`. Intervals are
//! halved where the bound is worst. Of a patch that is developable by construction `D` is zero, not
//! evaluated.

use crate::coordinate::{Coordinate, is_zero};
use crate::surface::Rails;
use crate::vector::{cross, det, dot, sub};
use std::cmp::Ordering;
use torse_algebra::order::{greatest, least};
use torse_algebra::{Ball, Jet, Rational, Scalar, rational::to_f64};

/// An extreme value between two bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Enclosed {
    /// The extreme value is at least this.
    pub low: f64,
    /// The extreme value is at most this.
    pub high: f64,
    /// A ruling on which the value is on the attained side: at least `low` of a maximum, at most `high` of a
    /// minimum. Zero before any was found.
    pub x: f64,
}

/// What [`enclose`] proved about a patch; for the quantities see [`Certificate`](super::Certificate).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EnclosedCertificate {
    /// The largest normalised determinant.
    pub determinant: Enclosed,
    /// The largest angle between the tangent planes at the ends of a ruling, in radians.
    pub twist: Enclosed,
    /// The largest absolute Gaussian curvature, over the whole patch and not on a grid.
    pub gaussian: Enclosed,
    /// The smallest distance from the patch to the point where the ruling meets its neighbours.
    pub clearance: Enclosed,
}

impl EnclosedCertificate {
    /// Whether the patch is regular, if that is proved: no ruling meets its neighbours inside.
    #[must_use]
    pub fn is_regular(&self) -> Option<bool> {
        match (self.clearance.low > 0.0, self.clearance.high < 0.0) {
            (true, _) => Some(true),
            (_, true) => Some(false),
            _ => None,
        }
    }
}

/// The order of the Taylor form.
const ORDER: usize = 6;

/// Encloses the certificate of a patch: with balls of `bits` bits, to the relative `accuracy` where at most
/// `cells` intervals suffice (one at least). A value that is zero without being zero by construction keeps a
/// gap, which falls with the budget.
///
/// The patch over balls comes from [`Over`](crate::Over): f64 data are exact numbers.
///
/// ```
/// use torse_geometry::developable::{certify, enclose};
/// use torse_geometry::{Bounds, EnvelopingPatch, Gbt, Over, PlaneFamily, exact_ball};
/// let planes = vec![[7., -7., 5., 125.], [-7., -7., 5., 120.], [-7., 7., 5., 130.], [7., 7., 5., 125.]];
/// let family = PlaneFamily::new(Gbt::new(0.5, 0.25)?, planes)?;
/// let sheet = EnvelopingPatch::new(family, Bounds::Planes([[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 1.0, 3.0]]))?;
/// let proved = enclose(&sheet.over(&|x| exact_ball(*x, 128))?, 128, 1e-3, 64);
/// assert_eq!(proved.is_regular(), Some(true));
/// assert_eq!((proved.twist.high, proved.gaussian.high), (0.0, 0.0));
/// // The sampled clearance lies between the bounds.
/// let sampled = certify(&sheet, 64)?.clearance.value;
/// let clearance = proved.clearance;
/// assert!(clearance.low <= sampled && sampled <= clearance.high * (1.0 + 1e-9));
/// assert!(clearance.high - clearance.low < 2e-3 * clearance.high);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[must_use]
pub fn enclose(
    patch: &impl Rails<Ball>,
    bits: usize,
    accuracy: f64,
    cells: usize,
) -> EnclosedCertificate {
    let mut open = vec![Cell::new(patch, rational(0), rational(1), bits)];
    let mut settled = [false; QUANTITIES];
    for turn in 0.. {
        if open.len() >= cells.max(1) || settled.iter().all(|s| *s) {
            break;
        }
        let quantity = turn % QUANTITIES;
        let bound = best(&open, quantity);
        let close = bound.high.is_finite() && bound.high - bound.low <= accuracy * bound.high.abs();
        settled[quantity] = close || bound.high == bound.low;
        if settled[quantity] {
            continue;
        }
        let Some(index) = worst(&open, quantity) else {
            break;
        };
        let Cell { from, to, .. } = open.swap_remove(index);
        let middle = (from.clone() + to.clone()) * Rational::new(1.into(), 2.into());
        open.push(Cell::new(patch, from, middle.clone(), bits));
        open.push(Cell::new(patch, middle, to, bits));
    }
    let clearance = best(&open, CLEARANCE);
    EnclosedCertificate {
        determinant: best(&open, 0),
        twist: best(&open, 1),
        gaussian: best(&open, 2),
        clearance: Enclosed {
            low: -clearance.high,
            high: -clearance.low,
            x: clearance.x,
        },
    }
}

/// Determinant, twist, Gaussian curvature, and the clearance with its sign changed: all to be maximised.
const QUANTITIES: usize = 4;
const CLEARANCE: usize = 3;

/// Bounds `[low, high]` of each quantity.
type Bounds = [[f64; 2]; QUANTITIES];

/// What holds of any patch, and of any developable.
fn trivial(developable: bool) -> Bounds {
    let most = if developable { 0.0 } else { 1.0 };
    [
        [0.0, most],
        [0.0, most * std::f64::consts::FRAC_PI_2],
        [0.0, f64::INFINITY],
        [f64::NEG_INFINITY, f64::INFINITY],
    ]
}

/// An interval of parameters with bounds over it and at its middle.
struct Cell {
    from: Rational,
    to: Rational,
    over: Bounds,
    middle: Bounds,
}

impl Cell {
    fn new(patch: &impl Rails<Ball>, from: Rational, to: Rational, bits: usize) -> Self {
        let half = Rational::new(1.into(), 2.into());
        let middle = (from.clone() + to.clone()) * half.clone();
        let width = (to.clone() - from.clone()) * half;
        let at = Ball::from_rational(&middle, bits);
        let reach = Ball::from_bounds(&-width.clone(), &width, bits);
        let there = Functions::of(patch, &at);
        let over = Functions::of(patch, &Ball::from_bounds(&from, &to, bits));
        let unknown = trivial(patch.is_developable_by_construction());
        let bounds = |f: Option<Functions<Ball>>| f.and_then(|f| f.bounds()).unwrap_or(unknown);
        Self {
            middle: bounds(there.as_ref().map(|f| f.map(|jet| jet.value().clone()))),
            over: bounds(
                there
                    .zip(over)
                    .map(|(there, over)| there.taylor(&over, &reach)),
            ),
            from,
            to,
        }
    }

    fn middle(&self) -> f64 {
        0.5 * (to_f64(&self.from) + to_f64(&self.to))
    }
}

/// The cell with the largest upper bound, the first of equals.
fn worst(cells: &[Cell], quantity: usize) -> Option<usize> {
    let above = |a: &Cell, b: &Cell| a.over[quantity][1] > b.over[quantity][1];
    let indices = 0..cells.len();
    indices.reduce(|a, b| match (cells.get(a), cells.get(b)) {
        (Some(x), Some(y)) if above(y, x) => b,
        _ => a,
    })
}

fn best(cells: &[Cell], quantity: usize) -> Enclosed {
    let mut enclosed = Enclosed {
        low: f64::NEG_INFINITY,
        high: f64::NEG_INFINITY,
        x: 0.0,
    };
    for cell in cells {
        enclosed.high = enclosed.high.max(cell.over[quantity][1]);
        if cell.middle[quantity][0] > enclosed.low {
            (enclosed.low, enclosed.x) = (cell.middle[quantity][0], cell.middle());
        }
    }
    enclosed
}

/// The functions of the module's head, with `|P'|^2` and `|Q'|^2`.
struct Functions<T> {
    determinant: T,
    h: T,
    a: T,
    b: T,
    ruling: T,
    slopes: [T; 2],
}

impl Functions<Jet<Ball>> {
    /// The Taylor series at (or, of a wide ball, over) `x`.
    fn of(patch: &impl Rails<Ball>, x: &Ball) -> Option<Self> {
        let [p, q] = patch.rail_jets(x, ORDER + 1).ok()?;
        let (dp, dq) = (slope(&p)?, slope(&q)?);
        let r = sub(&q, &p);
        let (n0, n1) = (cross(&dp, &r), cross(&dq, &r));
        let determinant = if patch.is_developable_by_construction() {
            dp[0].constant_like(x.zero())
        } else {
            det(&dp, &dq, &r)
        };
        Some(Self {
            determinant,
            h: dot(&n0, &n1),
            a: dot(&n0, &n0),
            b: dot(&n1, &n1),
            ruling: dot(&r, &r),
            slopes: [dot(&dp, &dp), dot(&dq, &dq)],
        })
    }

    /// The ranges over the interval of half width `reach` about the point of `self`.
    fn taylor(&self, over: &Self, reach: &Ball) -> Functions<Ball> {
        let form = |at: &Jet<Ball>, over: &Jet<Ball>| {
            let coefficients = at.coefficients().iter().take(ORDER);
            let last = over.coefficients().get(ORDER);
            coefficients
                .chain(last)
                .zip(0..)
                .map(|(c, n)| c.clone() * reach.powi(n))
                .reduce(|sum, term| sum + term)
                .unwrap_or_else(|| over.value().clone())
        };
        Functions {
            determinant: form(&self.determinant, &over.determinant),
            h: form(&self.h, &over.h),
            a: form(&self.a, &over.a),
            b: form(&self.b, &over.b),
            ruling: form(&self.ruling, &over.ruling),
            slopes: [0, 1].map(|i| form(&self.slopes[i], &over.slopes[i])),
        }
    }

    fn map(&self, f: impl Fn(&Jet<Ball>) -> Ball) -> Functions<Ball> {
        Functions {
            determinant: f(&self.determinant),
            h: f(&self.h),
            a: f(&self.a),
            b: f(&self.b),
            ruling: f(&self.ruling),
            slopes: self.slopes.each_ref().map(f),
        }
    }
}

fn slope(curve: &[Jet<Ball>; 3]) -> Option<[Jet<Ball>; 3]> {
    let [x, y, z] = curve.each_ref().map(Jet::differentiated);
    Some([x?, y?, z?])
}

impl Functions<Ball> {
    /// Bounds of the four quantities; `None` where squares come out negative, which does not happen.
    fn bounds(&self) -> Option<Bounds> {
        let [a, b, r] = [&self.a, &self.b, &self.ruling].map(nonnegative);
        let d = self.determinant.abs();
        let turned = r.sqrt().ok()? * d.clone();
        Some([
            self.determinant_bounds(&d, &r),
            angle_bounds(&turned, &self.h.abs()),
            curvature_bounds(&d, &least_normal([&a, &self.h, &b], &turned)),
            negated(clearance_bounds([&a, &self.h, &b], &r, &turned)?),
        ])
    }

    fn determinant_bounds(&self, d: &Ball, r: &Ball) -> [f64; 2] {
        let [p, q] = self.slopes.each_ref().map(nonnegative);
        if is_zero(d) {
            return [0.0, 0.0];
        }
        let square = (d.clone() * d.clone()).divided_by(&(p * q * r.clone()));
        match square.and_then(|s| nonnegative(&s).sqrt()) {
            Ok(ratio) => {
                let (low, high) = ratio.to_f64_bounds();
                [low.min(1.0), high.min(1.0)]
            }
            Err(_) => [0.0, 1.0],
        }
    }
}

/// The angle with this sine and cosine, both up to a common factor and not negative.
fn angle_bounds(sine: &Ball, cosine: &Ball) -> [f64; 2] {
    let ((s_low, s_high), (c_low, c_high)) = (sine.to_f64_bounds(), cosine.to_f64_bounds());
    // The arc tangent of the library is good to one unit in the last place; two are allowed for.
    let low = s_low.max(0.0).atan2(c_high).next_down().next_down();
    let high = s_high.max(0.0).atan2(c_low.max(0.0));
    let high = if high > 0.0 {
        high.next_up().next_up()
    } else {
        0.0
    };
    [low.max(0.0), high]
}

/// The least `|N(v)|^2` on the ruling: `max(min(a, h, b), |N0 x N1|^2/(a + b - 2h))`.
fn least_normal([a, h, b]: [&Ball; 3], turned: &Ball) -> Ball {
    let least_coefficient = minimum(&minimum(a, h), b);
    let bend = a.clone() + b.clone() - (h.clone() + h.clone());
    match (turned.clone() * turned.clone()).divided_by(&bend) {
        Ok(free) => maximum(&least_coefficient, &nonnegative(&free)),
        // The true value is not below the coefficient, nor above the ends.
        Err(_) => least_coefficient.hull(&minimum(a, b)),
    }
}

fn curvature_bounds(d: &Ball, normal_squared: &Ball) -> [f64; 2] {
    let quotient =
        (d.clone() * d.clone()).divided_by(&(normal_squared.clone() * normal_squared.clone()));
    match (normal_squared.sign(), quotient) {
        (Some(Ordering::Greater), Ok(curvature)) => {
            let (low, high) = curvature.to_f64_bounds();
            // Plus zero: no negative zero.
            [low.max(0.0), high + 0.0]
        }
        (Some(Ordering::Equal | Ordering::Less), _) => [f64::INFINITY, f64::INFINITY],
        _ => [0.0, f64::INFINITY],
    }
}

/// `sqrt(r) (m e - d)/(e^2 + 2 d)`, see the module.
fn clearance_bounds([a, h, b]: [&Ball; 3], r: &Ball, turned: &Ball) -> Option<[f64; 2]> {
    let (root_a, root_b, length) = (a.sqrt().ok()?, b.sqrt().ok()?, r.sqrt().ok()?);
    // Inside, the place is at most half a ruling from both ends.
    let deepest = -0.5 * length.to_f64_bounds().1;
    match h.sign() {
        Some(Ordering::Greater) => {}
        Some(Ordering::Less) => {
            let below = a.clone() + b.clone() - (h.clone() + h.clone());
            let ratio = (h.clone() - minimum(a, b)).divided_by(&below).ok()?;
            let (low, high) = (ratio * length).to_f64_bounds();
            return Some([low.max(deepest), high]);
        }
        _ => return Some([deepest, f64::INFINITY]),
    }
    let m = minimum(&root_a, &root_b);
    let e = (root_a.clone() - root_b.clone()).abs();
    let defect = (turned.clone() * turned.clone())
        .divided_by(&(root_a * root_b + h.clone()))
        .map(|d| nonnegative(&d))
        .ok()?;
    let bits = m.bits();
    let point = |value: &Rational| Ball::from_rational(value, bits);
    let ratio = |m: Ball, e: Ball, d: Ball| {
        let below = e.clone() * e.clone() + d.clone() + d.clone();
        (m * e - d).divided_by(&below)
    };
    let mut low = f64::INFINITY;
    for end in [e.lower(), e.upper()] {
        // Where e and d are zero the rulings are parallel: they meet nowhere.
        if let Ok(value) = ratio(point(&m.lower()), point(&end), point(&defect.upper())) {
            low = low.min((value * length.clone()).to_f64_bounds().0);
        } else if !is_zero(&point(&end)) || !is_zero(&point(&defect.upper())) {
            return Some([deepest, f64::INFINITY]);
        }
    }
    let high = match ratio(m, e, defect) {
        Ok(value) => (value * length).to_f64_bounds().1,
        Err(_) => f64::INFINITY,
    };
    Some([low, high])
}

fn negated([low, high]: [f64; 2]) -> [f64; 2] {
    [-high, -low]
}

/// The part of a ball that is not negative, for squares that rounding pushed below zero.
fn nonnegative(ball: &Ball) -> Ball {
    let zero = rational(0);
    let (low, high) = (ball.lower(), ball.upper());
    Ball::from_bounds(greatest(&low, &zero), greatest(&high, &zero), ball.bits())
}

fn minimum(a: &Ball, b: &Ball) -> Ball {
    let (low, high) = ([a.lower(), b.lower()], [a.upper(), b.upper()]);
    Ball::from_bounds(least(&low[0], &low[1]), least(&high[0], &high[1]), a.bits())
}

fn maximum(a: &Ball, b: &Ball) -> Ball {
    let (low, high) = ([a.lower(), b.lower()], [a.upper(), b.upper()]);
    Ball::from_bounds(
        greatest(&low[0], &low[1]),
        greatest(&high[0], &high[1]),
        a.bits(),
    )
}

fn rational(n: i64) -> Rational {
    torse_algebra::rational::integer(n)
}
