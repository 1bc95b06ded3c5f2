//! The search for the fewest strips that come within a distance.
//!
//! Its work is counted, not timed, so that it ends after as much of it on every machine: cells on which distances are
//! bounded, and as much for each panel as it takes about. What was found until then is returned. It ends earlier where narrower strips do not help: of a strip
//! that fails the halves are made, of one that fails again its halves, three times.

use super::distance::StripDistance;
use super::spacing::StripSpacing;
use super::strip::{StripError, SurfaceStrip, Tensor};
use crate::basis::{Basis, BasisShape};
use crate::error::{self, GeometryError};
use crate::sheet::{Panel, PanelKind, PanelPiece, Panels, PiecewiseRail, Rail, Sheet};
use crate::surface::{RailKind, Surface};
use crate::vector::blended;
use torse_algebra::Rational;

/// The most strips of a cover.
pub const MAX_STRIPS: usize = 128;
/// The most work of a search, in cells on which distances are bounded.
const MAX_WORK: usize = 4000;
/// What a panel counts as.
const PANEL_WORK: usize = 8;
/// How often the curves are moved for one number of strips.
const ROUNDS: usize = 3;
/// Bounds count as equal if the largest is at most this multiple of their root mean square.
const EQUAL: f64 = 1.05;
/// How often a strip that fails is halved, to see whether narrower ones do not.
const HALVINGS: usize = 3;
/// Halving helps if the bound falls to this share of it at least: of narrow strips it falls to a quarter.
const FALLEN: f64 = 0.75;
/// Numbers of strips that fail though their bounds are even enough on the average, before strips are halved.
const UNEVEN: usize = 2;

/// Returns the curve of this `v`: of a polynomial surface the exact one, so that it is known where two of them are edges
/// of a cylinder, as of a dome whose meridians have one profile.
fn curve(surface: &Tensor, v: f64) -> Result<Rail, GeometryError> {
    let (shape, across) = surface.bases();
    let (_, n) = surface.degrees();
    if *across == BasisShape::Bernstein {
        let row = BasisShape::<Rational>::Bernstein.row(n, &crate::exact(v))?;
        let points = surface.rows().map(|points| {
            let exact = points.iter().map(|point| point.map(crate::exact));
            blended(&row, &exact.collect::<Vec<_>>())
        });
        return Rail::exact(*shape, &points.collect::<Result<Vec<_>, _>>()?, None);
    }
    let row = across.row(n, &v)?;
    let points = surface.rows().map(|points| blended(&row, points));
    Rail::new(*shape, &points.collect::<Result<Vec<_>, _>>()?)
}

/// Returns the largest bound.
pub(super) fn farthest(strips: &[SurfaceStrip]) -> f64 {
    let bounds = strips.iter().map(|strip| strip.distance);
    bounds.fold(0.0, f64::max)
}

/// Returns the next number of strips to try between one that fails and one that is near enough: as many as strips of
/// equal bounds would do with, and at most the middle of both, so that few are tried however far the first guess was off.
fn fewer(failing: usize, enough: usize, wanted: f64) -> usize {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let wanted = wanted.clamp(0.0, 1e6).ceil() as usize;
    let last = enough.saturating_sub(1);
    let middle = failing.midpoint(enough);
    // Where all are about as near as allowed, one less is what is asked.
    let next = if wanted >= last {
        last
    } else {
        wanted.min(middle)
    };
    next.max(failing.saturating_add(1).min(last))
}

/// Returns the cone between a curve and one that is a point, as around a pole: any parameter of the point is one of its own.
fn cone(curves: &[Rail; 2]) -> Result<Option<Panel>, GeometryError> {
    let points = curves
        .each_ref()
        .map(|curve| curve.end_kinds() == RailKind::Point);
    let kind = match points {
        [true, false] => PanelKind::Fan(1),
        [false, true] => PanelKind::Fan(2),
        _ => return Ok(None),
    };
    let [first, second] = curves.clone();
    Ok(Some(Panel {
        pieces: vec![PanelPiece {
            kind,
            ranges: [[0.0, 1.0]; 2],
            sheet: Sheet::ruled(first, second),
        }],
        turned: false,
        closed: false,
        folds: 0,
        fans: 0.5,
    }))
}

/// Returns whether narrower strips may have what this one lacks.
fn may_be_too_wide(error: &StripError) -> bool {
    matches!(
        error,
        StripError::NoPanel { .. } | StripError::Unbounded { .. }
    )
}

/// What is looked for, and how much was done for it.
pub(super) struct CoverSearch<'a> {
    surface: &'a Tensor,
    bounded: StripDistance<'a>,
    within: f64,
    spacing: StripSpacing,
    /// The work that was done.
    work: usize,
    /// The most work.
    most: usize,
}

impl<'a> CoverSearch<'a> {
    /// Prepares a search for strips along curves of constant `v`.
    pub(super) fn new(surface: &'a Tensor, within: f64) -> Result<Self, StripError> {
        Ok(Self {
            surface,
            bounded: StripDistance::new(surface)?,
            within,
            spacing: StripSpacing::new(surface)?,
            work: 0,
            most: MAX_WORK,
        })
    }

    /// Returns the panel between the curves at two places.
    fn panel(&self, range: [f64; 2]) -> Result<Panel, StripError> {
        let [first, second] = range.map(|v| curve(self.surface, v));
        let curves = [first?, second?];
        if let Some(panel) = cone(&curves)? {
            return Ok(panel);
        }
        let [first, second] = curves.map(PiecewiseRail::from);
        let usable = |panel: &Panel| !panel.turned && !panel.closed && panel.folds == 0;
        let missing = |proved: bool| StripError::NoPanel { range, proved };
        let found = match Sheet::panels(&first, &second)? {
            Panels::Found(panels) => panels.into_iter().find(usable),
            Panels::None { .. } => return Err(missing(true)),
            Panels::Undecided { .. } => None,
        };
        match found {
            Some(panel) => Ok(panel),
            None => Err(self.tip()?.unwrap_or(missing(false))),
        }
    }

    /// Returns the strip between the curves at two places.
    fn strip(&mut self, range: [f64; 2]) -> Result<SurfaceStrip, StripError> {
        self.work += PANEL_WORK;
        let panel = self.panel(range)?;
        let (distance, cells) = self.bounded.bound(range, &panel)?;
        self.work += cells;
        Ok(SurfaceStrip {
            range,
            panel,
            distance: distance.ok_or(StripError::Unbounded { range })?,
        })
    }

    /// Returns the point in which all curves start, or all end.
    fn tip(&self) -> Result<Option<StripError>, StripError> {
        let rows: Vec<_> = self.surface.rows().collect();
        for (end, row) in [(0.0, rows.first()), (1.0, rows.last())] {
            let is_point = row.is_some_and(|row| row.windows(2).all(|pair| pair[0] == pair[1]));
            if is_point {
                let point = self.surface.point(&end, &0.0)?;
                return Ok(Some(StripError::Tip { at: end, point }));
            }
        }
        Ok(None)
    }

    /// Returns the strips between the curves at these places.
    fn strips(&mut self, places: &[f64]) -> Result<Vec<SurfaceStrip>, StripError> {
        let mut made = Vec::with_capacity(places.len());
        for pair in places.windows(2) {
            if self.work >= self.most {
                return Err(StripError::Spent {
                    count: places.len() - 1,
                    within: self.within,
                    last: None,
                });
            }
            made.push(self.strip([pair[0], pair[1]])?);
        }
        Ok(made)
    }

    /// Returns the best of some placements of so many strips, and how many strips of equal bounds would do.
    fn placed(&mut self, count: usize) -> Result<(Vec<SurfaceStrip>, f64), StripError> {
        let mut best: Option<(Vec<SurfaceStrip>, f64)> = None;
        for _ in 0..ROUNDS {
            let made = match (self.strips(&self.spacing.places(count)), &best) {
                (Err(StripError::Spent { .. }), Some(_)) => break,
                (made, _) => made?,
            };
            // Bounds grow with the square of the width.
            let roots = made.iter().map(|s| (s.distance / self.within).sqrt());
            let wanted: f64 = roots.sum();
            let mean = wanted / error::count(count);
            let even = farthest(&made) <= EQUAL * mean * mean * self.within;
            self.spacing.correct(&made);
            let better = |(known, _): &(Vec<SurfaceStrip>, f64)| farthest(&made) < farthest(known);
            if best.as_ref().is_none_or(better) {
                best = Some((made, wanted));
            }
            // Beyond that no placement helps.
            if even || mean > 1.0 {
                break;
            }
        }
        best.ok_or(StripError::TooFar {
            count,
            distance: f64::INFINITY,
            within: self.within,
        })
    }

    /// Returns where strips fail however narrow they are, looked for in a strip that fails: of each half that fails the
    /// halves, three times. `None` where narrower strips do not fail, or come nearer fast enough.
    fn narrow(
        &mut self,
        range: [f64; 2],
        distance: Option<f64>,
    ) -> Result<Option<StripError>, StripError> {
        let (mut part, mut last, mut failure) = (range, distance, None);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (part[0] + part[1]);
            let mut worst: Option<([f64; 2], f64)> = None;
            failure = None;
            for half in [[part[0], middle], [middle, part[1]]] {
                match self.strip(half) {
                    Ok(made) if worst.is_none_or(|(_, known)| known < made.distance) => {
                        worst = Some((half, made.distance));
                    }
                    Ok(_) => {}
                    Err(error) if may_be_too_wide(&error) => {
                        failure = Some((half, error));
                        break;
                    }
                    Err(error) => return Err(error),
                }
            }
            match (&failure, worst, last) {
                (Some((half, _)), ..) => (part, last) = (*half, None),
                (None, Some((half, found)), Some(before))
                    if found > self.within && found > FALLEN * before =>
                {
                    (part, last) = (half, Some(found));
                }
                _ => return Ok(None),
            }
        }
        let reason = match (failure, last) {
            (Some((_, error)), _) => error,
            (None, found) => StripError::TooFar {
                count: 1,
                distance: found.unwrap_or(f64::INFINITY),
                within: self.within,
            },
        };
        Ok(Some(StripError::Narrow {
            range: part,
            reason: Box::new(reason),
        }))
    }

    /// Returns the smallest number of strips that come within the distance, and whether one less was tried, and does not.
    pub(super) fn fewest(mut self) -> Result<(Vec<SurfaceStrip>, bool), StripError> {
        let mut count = self.spacing.count(self.within).clamp(1, MAX_STRIPS);
        // The largest number that failed.
        let mut failing = 0;
        let mut uneven = 0;
        let mut found: Option<Vec<SurfaceStrip>> = None;
        let mut last = StripError::TooFar {
            count,
            distance: f64::INFINITY,
            within: self.within,
        };
        loop {
            let most = found.as_ref().map_or(MAX_STRIPS, |strips| strips.len() - 1);
            if failing >= most {
                break;
            }
            count = count.clamp(failing + 1, most);
            match self.placed(count) {
                Ok((made, wanted)) if farthest(&made) <= self.within => {
                    count = fewer(failing, count, wanted);
                    found = Some(made);
                }
                Ok((made, wanted)) => {
                    failing = count;
                    let worst = made.iter().max_by(|a, b| a.distance.total_cmp(&b.distance));
                    uneven += usize::from(wanted <= error::count(count));
                    let halved = worst.filter(|_| found.is_none() && uneven > UNEVEN);
                    if let Some(worst) = halved
                        && let Some(stuck) = self.narrow(worst.range, Some(worst.distance))?
                    {
                        return Err(stuck);
                    }
                    last = StripError::TooFar {
                        count,
                        distance: farthest(&made),
                        within: self.within,
                    };
                    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
                    let next = wanted.min(1e6).ceil() as usize;
                    count = next.max(count + 1 + count / 8 * usize::from(uneven > UNEVEN));
                }
                // Narrower strips may have panels.
                Err(error) if may_be_too_wide(&error) => {
                    failing = count;
                    if let (true, Some(range)) = (found.is_none(), error.range())
                        && let Some(stuck) = self.narrow(range, None)?
                    {
                        return Err(stuck);
                    }
                    last = error;
                    count += count / 2 + 1;
                }
                Err(StripError::Spent { count, within, .. }) => {
                    // The first number has no one before it.
                    let before = (failing > 0).then(|| Box::new(last));
                    last = StripError::Spent {
                        count,
                        within,
                        last: before,
                    };
                    break;
                }
                Err(error) => return Err(error),
            }
        }
        let strips = found.ok_or(last)?;
        let fewest = failing + 1 == strips.len();
        Ok((strips, fewest))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn dome() -> Tensor {
        let height = |k: usize| [0.0, 400.0, 0.0][k];
        let at = |k: usize| [0.0, 1000.0, 2000.0][k];
        let row = |k: usize| [0, 1, 2].map(|l| [at(k), at(l), height(k) + height(l)]);
        let net = (0..3).map(|k| row(k).to_vec()).collect();
        Tensor::new(BasisShape::Bernstein, BasisShape::Bernstein, net).unwrap()
    }

    #[test]
    fn a_search_with_little_work_says_that_it_was_not_to_its_end() {
        let dome = dome();
        let with = |most: usize| {
            let search = CoverSearch::new(&dome, 15.0).unwrap();
            CoverSearch { most, ..search }.fewest()
        };
        let (strips, fewest) = with(MAX_WORK).unwrap();
        assert!(fewest && strips.len() == 4);
        // As much as four strips take: that fewer would not do is no longer tried.
        let (strips, fewest) = with(60).unwrap();
        assert!(!fewest && strips.len() == 4);
        let spent = with(20).unwrap_err();
        assert!(
            matches!(
                spent,
                StripError::Spent {
                    count: 4,
                    last: None,
                    ..
                }
            ),
            "{spent:?}"
        );
        assert!(spent.to_string().contains("not to its end"), "{spent}");
    }

    #[test]
    fn numbers_between_one_that_fails_and_one_that_is_enough_are_halved() {
        assert_eq!(fewer(0, 128, 10.2), 11);
        assert_eq!(fewer(0, 128, 100.0), 64);
        assert_eq!(fewer(9, 10, 9.5), 9);
        assert_eq!(fewer(5, 20, 19.5), 19);
        assert_eq!(fewer(5, 20, 2.0), 6);
    }
}
