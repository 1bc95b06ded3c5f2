//! Smooth arcs of curves on sheets.

use super::super::Sheet;
use crate::model::ChebyshevModel;
use crate::surface::Rails;
use crate::vector::{add, scale, sub};
use torse_algebra::Jet;

/// A smooth arc of a curve on a sheet: a place `[u, v]` for each share of the arc, by polynomials.
///
/// Invariants: the polynomials are of degree 16 at most and finite; both bounds are proved and finite.
#[derive(Debug, Clone, PartialEq)]
pub struct SheetArc {
    sheet: usize,
    place: [ChebyshevModel; 2],
    off: f64,
    bend: f64,
}

/// By Markov's inequality the derivative of a polynomial of degree 16 on an interval of half width one half is at most
/// this times the polynomial.
const STEEPEST: f64 = 512.0;
/// The most chords of an arc.
const MAX_CHORDS: f64 = 65536.0;
/// Shares of an arc at which it is looked whether a place leaves the sheet.
const LOOKS: u32 = 512;
/// A place that leaves the sheet by more, as a share of it, is on the next one.
const BEYOND: f64 = 1e-6;

impl SheetArc {
    /// Returns the arc of these polynomials; `None` where the sheet has no models there.
    pub(super) fn new(
        sheet: &Sheet<ChebyshevModel>,
        index: usize,
        place: [ChebyshevModel; 2],
        off: f64,
    ) -> Option<Self> {
        let bounds = bounds(sheet, &place)?;
        // Places are moved back to the edge of the sheet; what that moves counts.
        let moved = [0, 1].map(|i| Some(beyond(&place[i], bounds.seconds[i])? * bounds.speeds[i]));
        let off = off + moved[0]? + moved[1]?;
        (bounds.bend.is_finite() && off.is_finite()).then_some(Self {
            sheet: index,
            place,
            off,
            bend: bounds.bend,
        })
    }

    /// Returns the index of the sheet.
    #[must_use]
    pub fn sheet(&self) -> usize {
        self.sheet
    }

    /// Returns the place at a share of the arc, from 0 to 1.
    #[must_use]
    pub fn place(&self, share: f64) -> [f64; 2] {
        let t = (2.0 * share - 1.0).clamp(-1.0, 1.0);
        self.place.each_ref().map(|c| c.at(t).clamp(0.0, 1.0))
    }

    /// Returns a bound: no point of the curve that the arc stands for is farther in space from the point of the arc with the
    /// same parameter.
    #[must_use]
    pub fn off(&self) -> f64 {
        self.off
    }

    /// Returns how many chords of equal parameters stay within a distance of the arc, on the sheet or on its development:
    /// a proof, since a chord over a step `h` is no farther than `h^2/8` times the largest second derivative, and that of
    /// a development is the part of the second derivative in space that lies in the tangent plane. `None` for more than
    /// 65536.
    #[must_use]
    pub fn chords(&self, within: f64) -> Option<u32> {
        let count = (self.bend / (8.0 * within)).sqrt().ceil().max(1.0);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let whole = count as u32;
        (count <= MAX_CHORDS).then_some(whole)
    }

    /// Returns a bound for the distance of so many chords of equal parameters from the arc.
    #[must_use]
    pub fn chord_distance(&self, chords: u32) -> f64 {
        let count = f64::from(chords.max(1));
        self.bend / (8.0 * count * count) * (1.0 + 1e-12)
    }
}

/// Bounds for an arc on a sheet.
struct ArcBounds {
    /// Of the second derivative of `S(u, v)` by the share of the arc.
    bend: f64,
    /// Of the second derivatives of `u` and `v` by the share.
    seconds: [f64; 2],
    /// Of the derivatives of `S` by `u` and by `v`.
    speeds: [f64; 2],
}

/// Returns how far a polynomial leaves [0, 1]: between two looks it exceeds the larger of both by no more than `h^2/8` times
/// its second derivative. `None` if it is far outside.
fn beyond(model: &ChebyshevModel, second: f64) -> Option<f64> {
    let between = second / (8.0 * f64::from(LOOKS) * f64::from(LOOKS));
    let looks = (0..=LOOKS).map(|k| model.at(2.0 * f64::from(k) / f64::from(LOOKS) - 1.0));
    let (low, high) = looks.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    });
    let rounded = 64.0 * f64::EPSILON;
    let room = between + rounded;
    let far = (high + room - 1.0).max(room - low).max(0.0);
    (far - room <= BEYOND).then_some(far)
}

/// Returns bounds for an arc; `None` where the sheet has no models.
fn bounds(sheet: &Sheet<ChebyshevModel>, [u, v]: &[ChebyshevModel; 2]) -> Option<ArcBounds> {
    let slopes = |model: &ChebyshevModel| {
        let first = model.slope_of_polynomial(0.5);
        let second = first.slope_of_polynomial(0.5);
        let rounded = STEEPEST * first.radius();
        [first, second.widened(rounded)]
    };
    let ([u1, u2], [v1, v2]) = (slopes(u), slopes(v));
    let [p, q] = sheet.rail_jets(u, 2).ok()?;
    let derivative =
        |jets: &[Jet<ChebyshevModel>; 3], order: usize| -> Option<[ChebyshevModel; 3]> {
            let factor = ChebyshevModel::exact(if order == 2 { 2.0 } else { 1.0 });
            let mut all = [factor; 3];
            for (slot, jet) in all.iter_mut().zip(jets) {
                *slot = factor * *jet.coefficients().get(order)?;
            }
            Some(all)
        };
    let on = |order: usize| -> Option<[[ChebyshevModel; 3]; 2]> {
        let (a, b) = (derivative(&p, order)?, derivative(&q, order)?);
        let ruling = sub(&b, &a);
        Some([add(&a, &scale(v, &ruling)), ruling])
    };
    let ([_, ruling], [along, turning], [curving, _]) = (on(0)?, on(1)?, on(2)?);
    let two = ChebyshevModel::exact(2.0);
    let terms = [
        scale(&(u1 * u1), &curving),
        scale(&u2, &along),
        scale(&(two * u1 * v1), &turning),
        scale(&v2, &ruling),
    ];
    let sum = terms
        .iter()
        .skip(1)
        .fold(terms[0], |sum, term| add(&sum, term));
    Some(ArcBounds {
        bend: ChebyshevModel::largest_length(&sum),
        seconds: [u2.sharply_largest(), v2.sharply_largest()],
        speeds: [
            ChebyshevModel::largest_length(&along),
            ChebyshevModel::largest_length(&ruling),
        ],
    })
}
