//! The quantities of a certificate as functions of one ruling, for numbers and for ranges of numbers alike.
//!
//! In the six numbers of a ruling (module `forms`):
//!
//! ```text
//! normalised determinant   |D| / (|P'| |Q'| |R|)
//! twist                    tan = |N0 x N1| / |h| = sqrt(r) |D| / |h|
//! least |N(v)|^2           max(min(a, h, b), r D^2 / c),   N(v) = (1 - v) N0 + v N1
//! Gaussian curvature       |K| = D^2 / |N|^4, largest where |N| is least
//! clearance                sqrt(r) (h - min(a, b)) / c
//! side                     h / max(a, b)
//! ```
//!
//! `|N(v)|^2` is the quadratic with the Bernstein coefficients `a, h, b`, which lies above the least of them;
//! its free minimum is `(a b - h^2)/c`, and `a b - h^2 = r D^2`. One of the two is attained. With
//! `m = min(sqrt a, sqrt b)`, `e = |a - b|/(sqrt a + sqrt b)` and `d = r D^2/(sqrt(a b) + h)` the clearance is
//! `sqrt(r) (m e - d)/(e^2 + 2d)`: no cancellation, rising in `m`, falling in `d` and with one summit in `e`,
//! so its bounds are at the ends.

use super::forms::Squares;
use crate::coordinate::{Coordinate, is_zero};
use std::cmp::Ordering;
use torse_algebra::{Ball, Rational, Scalar, rational::integer};

/// A closed range of numbers: a ball, or the single number that an f64 is.
pub(super) trait Range: Coordinate {
    /// The ends, as ranges of one number each.
    fn ends(&self) -> [Self; 2];
    /// The ends rounded outward to f64.
    fn interval(&self) -> [f64; 2];
    /// From the smaller lower to the smaller upper end.
    fn minimum(&self, other: &Self) -> Self;
    /// From the larger lower to the larger upper end.
    fn maximum(&self, other: &Self) -> Self;
    /// The smallest range with both inside.
    fn spanned(&self, other: &Self) -> Self;
    /// The absolute values.
    fn absolute(&self) -> Self;
    /// The square roots of what is not negative in the range.
    fn root(&self) -> Option<Self>;
}

impl Range for f64 {
    fn ends(&self) -> [Self; 2] {
        [*self; 2]
    }

    fn interval(&self) -> [f64; 2] {
        [*self; 2]
    }

    fn minimum(&self, other: &Self) -> Self {
        self.min(*other)
    }

    fn maximum(&self, other: &Self) -> Self {
        self.max(*other)
    }

    fn spanned(&self, other: &Self) -> Self {
        self.min(*other)
    }

    fn absolute(&self) -> Self {
        self.abs()
    }

    fn root(&self) -> Option<Self> {
        Some(self.max(0.0).sqrt())
    }
}

impl Range for Ball {
    fn ends(&self) -> [Self; 2] {
        let point = |value: &Rational| Self::from_rational(value, self.bits());
        [point(&self.lower()), point(&self.upper())]
    }

    /// Without negative zeros, which `atan2` would read as the other side.
    fn interval(&self) -> [f64; 2] {
        let (low, high) = self.to_f64_bounds();
        [low + 0.0, high + 0.0]
    }

    fn minimum(&self, other: &Self) -> Self {
        let (low, high) = (
            self.lower().min(other.lower()),
            self.upper().min(other.upper()),
        );
        Self::from_bounds(&low, &high, self.bits())
    }

    fn maximum(&self, other: &Self) -> Self {
        let (low, high) = (
            self.lower().max(other.lower()),
            self.upper().max(other.upper()),
        );
        Self::from_bounds(&low, &high, self.bits())
    }

    fn spanned(&self, other: &Self) -> Self {
        self.hull(other)
    }

    fn absolute(&self) -> Self {
        self.abs()
    }

    fn root(&self) -> Option<Self> {
        self.maximum(&self.constant(&integer(0))).sqrt().ok()
    }
}

/// Number of quantities; each is turned so that the worst value is the largest.
pub(super) const QUANTITIES: usize = 6;
/// The normalised determinant.
pub(super) const DETERMINANT: usize = 0;
/// The twist in radians.
pub(super) const TWIST: usize = 1;
/// The absolute Gaussian curvature.
pub(super) const GAUSSIAN: usize = 2;
/// Minus the clearance.
pub(super) const CLEARANCE: usize = 3;
/// Minus the least length of the normal.
pub(super) const NORMAL: usize = 4;
/// Minus `h / max(a, b)`: not negative where the patch is not regular.
pub(super) const SIDE: usize = 5;

/// Bounds `[low, high]` of each quantity.
pub(super) type Intervals = [[f64; 2]; QUANTITIES];

/// What holds of any patch, and of any developable.
pub(super) fn trivial(developable: bool) -> Intervals {
    let most = if developable { 0.0 } else { 1.0 };
    [
        [0.0, most],
        [0.0, most * std::f64::consts::FRAC_PI_2],
        [0.0, f64::INFINITY],
        [f64::NEG_INFINITY, f64::INFINITY],
        [f64::NEG_INFINITY, 0.0],
        [-1.0, 1.0],
    ]
}

impl<T: Range> Squares<T> {
    /// Bounds of the quantities; `None` where a range is too wide to say anything.
    pub(super) fn intervals(&self) -> Option<Intervals> {
        let zero = self.ruling.zero();
        let [a, b, r, bend] = [&self.first, &self.second, &self.ruling, &self.bend]
            .map(|square| square.maximum(&zero));
        let d = self.determinant.absolute();
        let turned = r.root()? * d.clone();
        let normal = self.least_normal([&a, &b, &bend], &turned);
        let bounds = [
            self.determinant_interval(&d, &r),
            angle(&turned, &self.mixed.absolute()),
            curvature(&d, &normal),
            negated(self.clearance([&a, &b, &bend], &r, &turned)?),
            negated(normal.root()?.interval().map(|end| end.max(0.0))),
            negated(self.side(&a.maximum(&b))),
        ];
        // A number that left the range of f64 says nothing.
        bounds
            .iter()
            .all(|[low, high]| low <= high)
            .then_some(bounds)
    }

    fn determinant_interval(&self, d: &T, r: &T) -> [f64; 2] {
        if is_zero(d) {
            return [0.0, 0.0];
        }
        let [p, q] = self
            .slopes
            .each_ref()
            .map(|square| square.maximum(&d.zero()));
        // |D| / (|P'| |R|) / |Q'|: no product of three squares, which might vanish.
        let ratio = || {
            let first = d.divided_by(&(p.root()? * r.root()?)).ok()?;
            first.divided_by(&q.root()?).ok()
        };
        match ratio() {
            Some(ratio) => ratio.interval().map(|end| end.clamp(0.0, 1.0)),
            None => [0.0, 1.0],
        }
    }

    /// The least `|N(v)|^2` on the ruling: `max(min(a, h, b), r D^2 / c)`.
    fn least_normal(&self, [a, b, bend]: [&T; 3], turned: &T) -> T {
        let coefficient = a.minimum(&self.mixed).minimum(b);
        match (turned.clone() * turned.clone()).divided_by(bend) {
            Ok(free) => coefficient.maximum(&free),
            // The true value is not below the coefficient, nor above the ends.
            Err(_) => coefficient.spanned(&a.minimum(b)),
        }
        .maximum(&a.zero())
    }

    /// `sqrt(r) (m e - d)/(e^2 + 2 d)`, see the module.
    fn clearance(&self, [a, b, bend]: [&T; 3], r: &T, turned: &T) -> Option<[f64; 2]> {
        let h = &self.mixed;
        let (root_a, root_b, length) = (a.root()?, b.root()?, r.root()?);
        // Inside, the place is at most half a ruling from both ends.
        let deepest = -0.5 * length.interval()[1];
        let unknown = [deepest, f64::INFINITY];
        if self.parallel {
            return Some([f64::INFINITY; 2]);
        }
        match h.sign() {
            Some(Ordering::Greater) => {}
            Some(Ordering::Less | Ordering::Equal) => {
                let Ok(ratio) = (h.clone() - a.minimum(b)).divided_by(bend) else {
                    return Some(unknown);
                };
                let [low, high] = (ratio * length).interval();
                return Some([low.max(deepest).min(high), high]);
            }
            None => return Some(unknown),
        }
        let m = root_a.minimum(&root_b);
        let e = self
            .change
            .absolute()
            .divided_by(&(root_a.clone() + root_b.clone()))
            .ok()?;
        let defect = (turned.clone() * turned.clone())
            .divided_by(&(root_a * root_b + h.clone()))
            .ok()?
            .maximum(&h.zero());
        let ratio = |m: &T, e: &T, d: &T| {
            let below = e.clone() * e.clone() + d.clone() + d.clone();
            (m.clone() * e.clone() - d.clone()).divided_by(&below).ok()
        };
        let mut low = f64::INFINITY;
        let ([least, _], [_, worst]) = (m.ends(), defect.ends());
        for end in e.ends() {
            // Where e and d are zero the rulings are parallel: they meet nowhere.
            if let Some(value) = ratio(&least, &end, &worst) {
                low = low.min((value * length.clone()).interval()[0]);
            } else if !is_zero(&end) || !is_zero(&worst) {
                return Some(unknown);
            }
        }
        let high = match ratio(&m, &e, &defect) {
            Some(value) => (value * length).interval()[1],
            None => f64::INFINITY,
        };
        Some([low, high])
    }

    /// `h / max(a, b)`, positive where `h` is.
    fn side(&self, larger: &T) -> [f64; 2] {
        let known = match self.mixed.sign() {
            Some(Ordering::Greater) => [f64::MIN_POSITIVE, 1.0],
            Some(Ordering::Equal) => [0.0, 0.0],
            Some(Ordering::Less) => [-1.0, 0.0],
            None => [-1.0, 1.0],
        };
        match self.mixed.divided_by(larger) {
            Ok(ratio) => ratio.interval().map(|end| end.clamp(known[0], known[1])),
            Err(_) => known,
        }
    }
}

/// The angle with this sine and cosine, both up to a common factor and not negative.
fn angle<T: Range>(sine: &T, cosine: &T) -> [f64; 2] {
    let ([s_low, s_high], [c_low, c_high]) = (sine.interval(), cosine.interval());
    // Plus zero: the arc tangent of a negative zero would be pi.
    let turn = |s: f64, c: f64| libm::atan2(s.max(0.0) + 0.0, c.max(0.0) + 0.0);
    // The arc tangent of the library is good to one unit in the last place; two are allowed for.
    let low = turn(s_low, c_high).next_down().next_down();
    let high = turn(s_high, c_low);
    let high = if high > 0.0 {
        high.next_up().next_up()
    } else {
        0.0
    };
    [low.max(0.0), high]
}

fn curvature<T: Range>(d: &T, normal_squared: &T) -> [f64; 2] {
    if is_zero(d) && normal_squared.sign() == Some(Ordering::Greater) {
        return [0.0, 0.0];
    }
    let quotient = d
        .divided_by(normal_squared)
        .map(|ratio| ratio.clone() * ratio);
    match (normal_squared.sign(), quotient) {
        (Some(Ordering::Greater), Ok(curvature)) => {
            let [low, high] = curvature.interval();
            [low.max(0.0), high.max(0.0)]
        }
        (Some(Ordering::Equal | Ordering::Less), _) => [f64::INFINITY, f64::INFINITY],
        _ => [0.0, f64::INFINITY],
    }
}

fn negated([low, high]: [f64; 2]) -> [f64; 2] {
    // Plus zero: no negative zero.
    [0.0 - high, 0.0 - low]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact_ball;
    use proptest::prelude::*;

    #[test]
    fn an_angle_of_nothing_is_zero_and_not_a_half_turn() {
        let zero = exact_ball(0.0, 128);
        assert_eq!(angle(&zero.abs(), &zero.abs()), [0.0, 0.0]);
        assert_eq!(angle(&0.0, &-0.0), [0.0, 0.0]);
    }

    /// Squares of a ruling with exact numbers, as numbers and as balls of some width.
    fn squares(n: [[f64; 3]; 2], r: f64, wide: f64) -> (Squares<f64>, Squares<Ball>) {
        use crate::vector::{add, cross, dot, sub};
        let [n0, n1] = n;
        let determinant = dot(&cross(&n0, &n1), &[1.0, 0.0, 0.0]);
        let turn = sub(&n1, &n0);
        let numbers = Squares {
            determinant,
            first: dot(&n0, &n0),
            mixed: dot(&n0, &n1),
            second: dot(&n1, &n1),
            change: dot(&sub(&n0, &n1), &add(&n0, &n1)),
            bend: dot(&turn, &turn),
            approach: dot(&n0, &sub(&n0, &n1)),
            ruling: r * r,
            slopes: [1.0, 4.0],
            parallel: false,
        };
        let width = crate::exact(wide);
        let widened = |x: &f64| {
            let x = crate::exact(*x);
            Ball::from_bounds(&(&x - &width), &(&x + &width), 96)
        };
        let balls = numbers.zip(&numbers, |x, _| widened(x));
        (numbers, balls)
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn no_interval_is_empty(
            n in prop::array::uniform2(prop::array::uniform3(prop_oneof![Just(0.0), Just(1.0), -2.0..2.0_f64])),
            r in prop_oneof![Just(0.0), 0.0..3.0_f64],
            wide in prop_oneof![Just(0.0), 0.0..1.0_f64, 0.0..1e-20_f64],
        ) {
            let (numbers, balls) = squares(n, r, wide);
            for intervals in [numbers.intervals(), balls.intervals()].into_iter().flatten() {
                for [low, high] in intervals {
                    prop_assert!(low <= high, "{intervals:?}");
                }
            }
            prop_assert!(numbers.intervals().is_some());
        }
    }
}
