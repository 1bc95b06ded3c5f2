//! Where the development takes its functions from: the rails of a patch and their derivatives on an interval, as
//! models.

use crate::chebyshev::{NODES, Row, basis, between, nodes};
use crate::model::ChebyshevModel;
use crate::over::Over;
use crate::surface::Rails;

/// Points and derivatives of both rails on an interval.
pub(super) type Strip = [[[ChebyshevModel; 3]; 2]; 2];

/// How sure the numbers of a flat pattern are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum PatternEvidence {
    /// Estimates: the rails were looked at in finitely many parameters.
    Measured,
    /// Proved over whole intervals, for the exact numbers of the control data.
    Proved,
}

/// A patch whose rails can be had on whole intervals.
pub(super) trait Source: Sync {
    /// The rails on an interval; `None` where the interval is too long for them.
    fn strip(&self, from: f64, to: f64) -> Option<Strip>;

    /// Whether one plane touches along each ruling, exactly.
    fn is_exact(&self) -> bool;

    /// Whether the bounds are proved.
    fn evidence(&self) -> PatternEvidence;
}

/// The patch over models: bounds are proved.
pub(super) struct Enclosed<R> {
    over_models: R,
    exact: bool,
}

impl<R: Rails<ChebyshevModel>> Enclosed<R> {
    pub(super) fn new<P: Rails<f64> + Over<f64, ChebyshevModel, Object = R>>(
        patch: &P,
    ) -> crate::Result<Self> {
        Ok(Self {
            over_models: patch.over(&|x| ChebyshevModel::exact(*x))?,
            exact: patch.is_developable_by_construction(),
        })
    }
}

impl<R: Rails<ChebyshevModel>> Source for Enclosed<R> {
    fn strip(&self, from: f64, to: f64) -> Option<Strip> {
        let x = ChebyshevModel::identity(from, to);
        self.over_models.ends_and_slopes(&x).ok()
    }

    fn is_exact(&self) -> bool {
        self.exact
    }

    fn evidence(&self) -> PatternEvidence {
        PatternEvidence::Proved
    }
}

/// The patch at parameters alone: what it does between them is an estimate.
pub(super) struct Sampled<'a, R: ?Sized>(pub &'a R);

/// The checks see how far an interpolant is off at four parameters of an interval: it may be farther elsewhere.
const SAFETY: f64 = 2.0;
/// Roundings of the evaluation of a rail, as a multiple of the unit.
const ROUNDINGS: f64 = 8.0;
/// A rail that moves slower than this share of the other one stands still.
const STILL: f64 = 1e-13;

impl<R: Rails<f64> + ?Sized> Source for Sampled<'_, R> {
    fn strip(&self, from: f64, to: f64) -> Option<Strip> {
        let mut values = [[[[0.0; NODES]; 3]; 2]; 2];
        for (k, x) in nodes(from, to).into_iter().enumerate() {
            let ends = self.0.ends_and_slopes(&x).ok()?;
            for (rows, vectors) in values.iter_mut().flatten().zip(ends.as_flattened()) {
                for (row, c) in rows.iter_mut().zip(vectors) {
                    row[k] = *c;
                }
            }
        }
        let mut off = [[[0.0_f64; 3]; 2]; 2];
        let half = 0.5 * (to - from);
        for x in between(from, to) {
            let ends = self.0.ends_and_slopes(&x).ok()?;
            let row = basis(((x - from) / half - 1.0).clamp(-1.0, 1.0));
            let lists = off.iter_mut().flatten().zip(values.iter().flatten());
            for ((offs, rows), vector) in lists.zip(ends.as_flattened()) {
                for ((off, values), c) in offs.iter_mut().zip(rows).zip(vector) {
                    let poly = ChebyshevModel::through(values).interpolant();
                    *off = off.max((poly.at(&row) - c).abs()).max(0.5 * poly.tail());
                }
            }
        }
        let largest = |row: &Row| row.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let speeds = values
            .each_ref()
            .map(|[_, slope]| slope.iter().map(largest).fold(0.0, f64::max));
        let fastest = speeds[0].max(speeds[1]);
        let strip = [0, 1].map(|rail| {
            [0, 1].map(|which| {
                [0, 1, 2].map(|axis| {
                    if which == 1 && speeds[rail] <= STILL * fastest {
                        return ChebyshevModel::exact(0.0);
                    }
                    let row = &values[rail][which][axis];
                    let rounding = ROUNDINGS * f64::EPSILON * largest(row);
                    ChebyshevModel::through(row).widened(SAFETY * off[rail][which][axis] + rounding)
                })
            })
        });
        let finite = strip.as_flattened().as_flattened();
        finite
            .iter()
            .all(crate::Coordinate::is_finite)
            .then_some(strip)
    }

    fn is_exact(&self) -> bool {
        self.0.is_developable_by_construction()
    }

    fn evidence(&self) -> PatternEvidence {
        PatternEvidence::Measured
    }
}
