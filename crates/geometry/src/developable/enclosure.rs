//! Certificates that enclose: between which bounds the numbers of [`certify`](super::certify) lie.
//!
//! A few functions of `x` say everything (modules `forms` and `measures`). On an interval each is had in one of two
//! ways: as a Chebyshev model ([`ChebyshevModel`]), fast and good to the rounding of f64; or as its Taylor polynomial
//! at the middle with the last coefficient taken over the interval (Lagrange), on balls of any number of bits: of half
//! width `w` the excess falls with `w^6`. Intervals are halved where the bound is worst. Of a patch that is developable
//! by construction `D` is zero, not evaluated.

use super::extent::Extent;
use super::forms::{RulingForms, Squares};
use super::measures::{
    CLEARANCE, DETERMINANT, GAUSSIAN, Intervals, NORMAL, QUANTITIES, SIDE, TWIST, trivial,
};
use crate::dyadic::middle_of;
use crate::model::ChebyshevModel;
use crate::surface::Rails;
use crate::{exact, exact_ball};
use torse_algebra::rational::{Rational, integer, to_f64};
use torse_algebra::{Ball, Jet};

/// The order of the Taylor form.
const ORDER: usize = 6;

/// An extreme value between two bounds: `low <= high`, and an infinite bound where none is known (or where
/// the value is infinite).
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

/// What [`enclose`] proved about a patch; for the quantities see [`PatchCertificate`](super::PatchCertificate).
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
    /// The length of the shortest normal, relative as in [`PatchCertificate`](super::PatchCertificate).
    pub normal: Enclosed,
    /// The least `N0 . N1 / max(|N0|^2, |N1|^2)`: positive when the patch is regular. Of a developable it is
    /// the ratio of the distances of the two ends of a ruling from the edge of regression.
    pub side: Enclosed,
}

impl EnclosedCertificate {
    /// Whether the patch is regular, if that is proved: on every ruling the normals at both ends are there and
    /// point to the same side. So the normal vanishes nowhere, and no ruling meets its neighbours inside.
    #[must_use]
    pub fn is_regular(&self) -> Option<bool> {
        match (self.side.low > 0.0, self.side.high <= 0.0) {
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
/// use torse_geometry::{PatchBounds, EnvelopingPatch, Gbt, Over, PlaneFamily, exact_ball};
/// let planes = vec![[7., -7., 5., 125.], [-7., -7., 5., 120.], [-7., 7., 5., 130.], [7., 7., 5., 125.]];
/// let family = PlaneFamily::new(Gbt::new(0.5, 0.25)?, planes)?;
/// let sheet = EnvelopingPatch::new(family, PatchBounds::Planes([[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 1.0, 3.0]]))?;
/// let proved = enclose(&sheet.over(&|x| exact_ball(*x, 128))?, 128, 0.1, 64);
/// assert_eq!(proved.is_regular(), Some(true));
/// assert_eq!((proved.twist.high, proved.gaussian.high), (0.0, 0.0));
/// // The sampled clearance lies between the bounds.
/// let sampled = certify(&sheet, 64)?.clearance.expect("the rulings meet").value;
/// let clearance = proved.clearance;
/// assert!(clearance.low <= sampled && sampled <= clearance.high * (1.0 + 1e-9));
/// assert!(clearance.low > 0.5 * clearance.high);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[must_use]
pub fn enclose<R: Rails<Ball> + ?Sized>(
    patch: &R,
    bits: usize,
    accuracy: f64,
    cells: usize,
) -> EnclosedCertificate {
    let extent = Extent::measure(patch, |x| exact_ball(x, bits));
    let series = Series {
        patch,
        extent: extent.unwrap_or(Extent::ONE),
        bits,
    };
    divided(&series, accuracy, cells)
}

/// Encloses the certificate of a patch by Chebyshev models: as [`enclose`], and many times faster, but what f64 cannot
/// tell from zero stays open.
///
/// ```
/// use torse_geometry::developable::{enclose, enclose_by_models};
/// use torse_geometry::{Bernstein, Curve, ChebyshevModel, Over, RuledSurface, exact_ball};
/// let rail = |points: [[f64; 3]; 2]| Curve::new(Bernstein, points.to_vec());
/// let strip = RuledSurface::new(
///     rail([[0.0, 0.0, 0.0], [100.0, 0.0, 0.0]])?,
///     rail([[0.0, 10.0, 0.0], [100.0, 10.0, 0.5]])?,
/// );
/// let fast = enclose_by_models(&strip.over(&|x| ChebyshevModel::exact(*x))?, 0.01, 64);
/// let slow = enclose(&strip.over(&|x| exact_ball(*x, 128))?, 128, 0.01, 64);
/// assert_eq!((fast.is_regular(), slow.is_regular()), (Some(true), Some(true)));
/// assert!(fast.twist.low <= slow.twist.high && slow.twist.low <= fast.twist.high);
/// assert!(fast.twist.high - fast.twist.low <= 0.01 * fast.twist.high);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[must_use]
pub fn enclose_by_models<R: Rails<ChebyshevModel> + ?Sized>(
    patch: &R,
    accuracy: f64,
    cells: usize,
) -> EnclosedCertificate {
    let extent = Extent::measure(patch, ChebyshevModel::exact);
    let modelled = Modelled {
        patch,
        extent: extent.unwrap_or(Extent::ONE),
    };
    divided(&modelled, accuracy, cells)
}

/// A patch in its own units, of which the quantities can be bounded over intervals.
trait Bounded {
    fn extent(&self) -> Extent;

    /// The quantities at a parameter.
    fn at(&self, x: &Rational) -> Intervals;

    /// The quantities over an interval.
    fn over(&self, from: &Rational, to: &Rational) -> Intervals;

    fn witness(&self, x: &Rational) -> Witness {
        Witness {
            x: to_f64(x),
            bounds: self.at(x),
        }
    }

    fn cell(&self, from: Rational, to: Rational) -> Cell {
        Cell {
            bounds: self.over(&from, &to),
            from,
            to,
        }
    }
}

fn divided(patch: &dyn Bounded, accuracy: f64, cells: usize) -> EnclosedCertificate {
    let at = |x: Rational| patch.witness(&x);
    let mut witnesses = vec![at(integer(0)), at(integer(1))];
    let mut open = vec![patch.cell(integer(0), integer(1))];
    let mut settled = [false; QUANTITIES];
    // How short the normal gets is told, not worked for: what matters of it is the side.
    settled[NORMAL] = true;
    for turn in 0.. {
        if open.len() >= cells.max(1) || settled.iter().all(|s| *s) {
            break;
        }
        let quantity = turn % QUANTITIES;
        let bound = best(&open, &witnesses, quantity);
        let close = bound.high.is_finite() && bound.high - bound.low <= accuracy * bound.high.abs();
        // Of the side the sign is what counts.
        let known = quantity == SIDE && (bound.high < 0.0 || bound.low >= 0.0);
        settled[quantity] = close || known || bound.high == bound.low;
        if settled[quantity] {
            continue;
        }
        let Some(index) = worst(&open, quantity) else {
            break;
        };
        let Cell { from, to, .. } = open.swap_remove(index);
        let middle = middle_of(&from, &to);
        witnesses.push(at(middle.clone()));
        open.push(patch.cell(from, middle.clone()));
        open.push(patch.cell(middle, to));
    }
    let most = |quantity| best(&open, &witnesses, quantity);
    let least = |quantity| {
        let Enclosed { low, high, x } = best(&open, &witnesses, quantity);
        // Plus zero: no negative zero.
        let (low, high) = (0.0 - high, 0.0 - low);
        Enclosed { low, high, x }
    };
    EnclosedCertificate {
        determinant: most(DETERMINANT),
        twist: most(TWIST),
        gaussian: most(GAUSSIAN).scaled(|value| patch.extent().curvature(value)),
        clearance: least(CLEARANCE).scaled(|value| patch.extent().length(value)),
        normal: least(NORMAL),
        side: least(SIDE),
    }
}

impl Enclosed {
    /// In other units, by a power of two: exact, unless an end leaves the range of f64 or its normal numbers,
    /// where one step outward makes up for the rounding.
    fn scaled(self, by: impl Fn(f64) -> f64) -> Self {
        let moved = |end: f64, outward: f64, step: fn(f64) -> f64| {
            let value = by(end);
            if end == 0.0 || end.is_infinite() || value.is_normal() {
                value
            } else if value.is_infinite() {
                // Beyond the range, on either side of it.
                if value > 0.0 && outward < 0.0 {
                    f64::MAX
                } else if value < 0.0 && outward > 0.0 {
                    f64::MIN
                } else {
                    value
                }
            } else {
                step(value)
            }
        };
        Self {
            low: moved(self.low, -1.0, f64::next_down),
            high: moved(self.high, 1.0, f64::next_up),
            ..self
        }
    }
}

fn bounds<R: Rails<S> + ?Sized, S: crate::Coordinate>(
    patch: &R,
    squares: Option<Squares<Ball>>,
) -> Intervals {
    squares
        .and_then(|squares| squares.intervals())
        .unwrap_or_else(|| trivial(patch.is_developable_by_construction()))
}

/// By Taylor series on balls.
struct Series<'a, R: ?Sized> {
    patch: &'a R,
    extent: Extent,
    bits: usize,
}

impl<R: Rails<Ball> + ?Sized> Series<'_, R> {
    /// The products of a ruling as Taylor series at, or over, `x`.
    fn squares(&self, x: &Ball, order: usize) -> Option<Squares<Jet<Ball>>> {
        let forms = RulingForms::reduced_series(self.patch, x, order, self.extent).ok()?;
        Some(forms.squares())
    }
}

impl<R: Rails<Ball> + ?Sized> Bounded for Series<'_, R> {
    fn extent(&self) -> Extent {
        self.extent
    }

    fn at(&self, x: &Rational) -> Intervals {
        let x = Ball::from_rational(x, self.bits);
        let forms = RulingForms::reduced(self.patch, &x, self.extent).ok();
        bounds(self.patch, forms.map(|forms| forms.squares()))
    }

    fn over(&self, from: &Rational, to: &Rational) -> Intervals {
        let middle = middle_of(from, to);
        let width = to.clone() - middle.clone();
        let reach = Ball::from_bounds(&-width.clone(), &width, self.bits);
        let at_middle = self.squares(&Ball::from_rational(&middle, self.bits), ORDER);
        let over = self.squares(&Ball::from_bounds(from, to, self.bits), ORDER);
        let taylor = |(at_middle, over): (Squares<_>, Squares<_>)| {
            at_middle.zip(&over, |at_middle, over| taylor(at_middle, over, &reach))
        };
        bounds(self.patch, at_middle.zip(over).map(taylor))
    }
}

/// Bits of the balls that stand for the ranges of models.
const RANGE_BITS: usize = 96;

/// By Chebyshev models.
struct Modelled<'a, R: ?Sized> {
    patch: &'a R,
    extent: Extent,
}

impl<R: Rails<ChebyshevModel> + ?Sized> Modelled<'_, R> {
    fn bounded(&self, x: &ChebyshevModel) -> Intervals {
        let forms = RulingForms::reduced(self.patch, x, self.extent).ok();
        // What left the range of f64 says nothing.
        let finite = std::cell::Cell::new(true);
        let range = |model: &ChebyshevModel| {
            let [low, high] = model.range();
            finite.set(finite.get() && low.is_finite() && high.is_finite());
            Ball::from_bounds(&exact(low), &exact(high), RANGE_BITS)
        };
        let ranges = forms.map(|forms| {
            let squares = forms.squares();
            squares.zip(&squares, |model, _| range(model))
        });
        bounds(self.patch, ranges.filter(|_| finite.get()))
    }
}

impl<R: Rails<ChebyshevModel> + ?Sized> Bounded for Modelled<'_, R> {
    fn extent(&self) -> Extent {
        self.extent
    }

    fn at(&self, x: &Rational) -> Intervals {
        self.bounded(&ChebyshevModel::exact(to_f64(x)))
    }

    fn over(&self, from: &Rational, to: &Rational) -> Intervals {
        self.bounded(&ChebyshevModel::identity(to_f64(from), to_f64(to)))
    }
}

/// The range over the interval of half width `reach` about the point of `at_middle`: the Taylor polynomial with
/// the last coefficient over the interval.
fn taylor(at_middle: &Jet<Ball>, over: &Jet<Ball>, reach: &Ball) -> Ball {
    let coefficients = at_middle.coefficients().iter().take(ORDER);
    let last = over.coefficients().get(ORDER);
    let mut terms = coefficients.chain(last).zip(0..);
    let first = terms.next().map_or(over.value(), |(c, _)| c).clone();
    terms.fold(first, |sum, (c, n)| sum + c.clone() * reach.powi(n))
}

/// Bounds at one parameter.
struct Witness {
    x: f64,
    bounds: Intervals,
}

/// An interval of parameters with bounds over it.
struct Cell {
    from: Rational,
    to: Rational,
    bounds: Intervals,
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
