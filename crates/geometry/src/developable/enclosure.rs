//! Certificates that enclose: between which bounds the numbers of [`certify`](super::certify) lie.
//!
//! Five functions of `x` say everything (module `bounds`). On an interval of half width `w` each is its
//! Taylor polynomial at the middle with the last coefficient taken over the interval (Lagrange), all on
//! balls: the excess falls with `w^6`. Intervals are halved where the bound is worst. Of a patch
//! that is developable by construction `D` is zero, not evaluated.

use super::bounds::{Bounds, CLEARANCE, Functions, ORDER, QUANTITIES, trivial};
use crate::surface::Rails;
use torse_algebra::Ball;
use torse_algebra::rational::{Rational, integer, to_f64};

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
/// let proved = enclose(&sheet.over(&|x| exact_ball(*x, 128))?, 128, 0.1, 64);
/// assert_eq!(proved.is_regular(), Some(true));
/// assert_eq!((proved.twist.high, proved.gaussian.high), (0.0, 0.0));
/// // The sampled clearance lies between the bounds.
/// let sampled = certify(&sheet, 64)?.clearance.value;
/// let clearance = proved.clearance;
/// assert!(clearance.low <= sampled && sampled <= clearance.high * (1.0 + 1e-9));
/// assert!(clearance.low > 0.7 * clearance.high);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[must_use]
pub fn enclose(
    patch: &impl Rails<Ball>,
    bits: usize,
    accuracy: f64,
    cells: usize,
) -> EnclosedCertificate {
    let at = |x: Rational| Witness::new(patch, &x, bits);
    let mut witnesses = vec![at(integer(0)), at(integer(1))];
    let mut open = vec![Cell::new(patch, integer(0), integer(1), bits)];
    let mut settled = [false; QUANTITIES];
    for turn in 0.. {
        if open.len() >= cells.max(1) || settled.iter().all(|s| *s) {
            break;
        }
        let quantity = turn % QUANTITIES;
        let bound = best(&open, &witnesses, quantity);
        let close = bound.high.is_finite() && bound.high - bound.low <= accuracy * bound.high.abs();
        settled[quantity] = close || bound.high == bound.low;
        if settled[quantity] {
            continue;
        }
        let Some(index) = worst(&open, quantity) else {
            break;
        };
        let Cell { from, to, .. } = open.swap_remove(index);
        let middle = middle_of(&from, &to);
        witnesses.push(at(middle.clone()));
        open.push(Cell::new(patch, from, middle.clone(), bits));
        open.push(Cell::new(patch, middle, to, bits));
    }
    let clearance = best(&open, &witnesses, CLEARANCE);
    EnclosedCertificate {
        determinant: best(&open, &witnesses, 0),
        twist: best(&open, &witnesses, 1),
        gaussian: best(&open, &witnesses, 2),
        clearance: Enclosed {
            low: -clearance.high,
            high: -clearance.low,
            x: clearance.x,
        },
    }
}

/// Bounds at one parameter.
struct Witness {
    x: f64,
    bounds: Bounds,
}

impl Witness {
    fn new(patch: &impl Rails<Ball>, x: &Rational, bits: usize) -> Self {
        let functions = Functions::of(patch, &Ball::from_rational(x, bits), 0);
        let bounds = functions.and_then(|f| f.map(|jet| jet.value().clone()).bounds());
        Self {
            x: to_f64(x),
            bounds: bounds.unwrap_or(trivial(patch.is_developable_by_construction())),
        }
    }
}

/// An interval of parameters with bounds over it.
struct Cell {
    from: Rational,
    to: Rational,
    bounds: Bounds,
}

impl Cell {
    fn new(patch: &impl Rails<Ball>, from: Rational, to: Rational, bits: usize) -> Self {
        let middle = middle_of(&from, &to);
        let width = to.clone() - middle.clone();
        let reach = Ball::from_bounds(&-width.clone(), &width, bits);
        let there = Functions::of(patch, &Ball::from_rational(&middle, bits), ORDER);
        let over = Functions::of(patch, &Ball::from_bounds(&from, &to, bits), ORDER);
        let bounds = there
            .zip(over)
            .and_then(|(there, over)| there.taylor(&over, &reach).bounds());
        Self {
            from,
            to,
            bounds: bounds.unwrap_or(trivial(patch.is_developable_by_construction())),
        }
    }
}

fn middle_of(from: &Rational, to: &Rational) -> Rational {
    (from.clone() + to.clone()) * Rational::new(1.into(), 2.into())
}

/// The cell with the largest upper bound, the first of equals.
fn worst(cells: &[Cell], quantity: usize) -> Option<usize> {
    let above = |a: &Cell, b: &Cell| a.bounds[quantity][1] > b.bounds[quantity][1];
    let indices = 0..cells.len();
    indices.reduce(|a, b| match (cells.get(a), cells.get(b)) {
        (Some(x), Some(y)) if above(y, x) => b,
        _ => a,
    })
}

/// The largest value: below the bounds of all cells, above those of the best witness.
fn best(cells: &[Cell], witnesses: &[Witness], quantity: usize) -> Enclosed {
    let mut enclosed = Enclosed {
        low: f64::NEG_INFINITY,
        high: f64::NEG_INFINITY,
        x: 0.0,
    };
    for cell in cells {
        enclosed.high = enclosed.high.max(cell.bounds[quantity][1]);
    }
    for witness in witnesses {
        if witness.bounds[quantity][0] > enclosed.low {
            (enclosed.low, enclosed.x) = (witness.bounds[quantity][0], witness.x);
        }
    }
    enclosed
}
