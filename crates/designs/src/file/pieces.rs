//! Patches over curves of several pieces: one for each piece of the common refinement, and the marks of each.

use crate::design::{Mark, MarkedOpening, ParameterSide};
use torse_geometry::Coordinate;
use torse_geometry::prelude::{GeometryError, Panel, PiecewiseRail, Rail};
use torse_geometry::vector::{norm, sub};

type Result<T> = std::result::Result<T, GeometryError>;

/// The intervals of the parameter of an entry that are patches of their own.
pub struct PatchIntervals {
    /// Where they meet, first and last included.
    breaks: Vec<f64>,
    /// Whether the last ends where the first begins.
    pub closed: bool,
    /// Whether the part of the entry is taken already.
    pub trimmed: bool,
}

/// Two points that count as one, as a share of their size.
const SAME: f64 = 1e-12;

impl PatchIntervals {
    /// The only one.
    pub const ONE: Self = Self {
        breaks: Vec::new(),
        closed: false,
        trimmed: false,
    };

    /// Returns the pieces of a panel: the parameter of the whole goes with the sum of those of both curves.
    pub fn of_panel(panel: &Panel) -> Self {
        let length = |piece: &torse_geometry::prelude::PanelPiece| -> f64 {
            piece
                .ranges
                .iter()
                .map(|[from, to]| (to - from).abs())
                .sum()
        };
        let whole: f64 = panel.pieces.iter().map(length).sum();
        let mut at = 0.0;
        let mut breaks = vec![0.0];
        for piece in &panel.pieces {
            at += length(piece);
            breaks.push(at / whole);
        }
        if let Some(last) = breaks.last_mut() {
            *last = 1.0;
        }
        Self {
            breaks,
            closed: panel.closed,
            trimmed: true,
        }
    }

    /// Returns the pieces of a curve, cut to a part where there are several.
    pub fn cut(curve: &PiecewiseRail, part: [f64; 2]) -> Result<(Self, Vec<Rail>)> {
        let trimmed = curve.count() > 1;
        let curve = within(curve, part)?;
        let cells = Self {
            trimmed,
            breaks: curve.breaks().iter().map(Coordinate::approximate).collect(),
            closed: is_closed(&curve)?,
        };
        Ok((cells, curve.rails()?))
    }

    /// Returns the pieces of two curves where both are cut at the breaks of either.
    pub fn between(
        [first, second]: &[PiecewiseRail; 2],
        part: [f64; 2],
    ) -> Result<(Self, Vec<[Rail; 2]>)> {
        if first.count() == 1 && second.count() == 1 {
            let pairs = first.rails()?.into_iter().zip(second.rails()?);
            return Ok((Self::ONE, pairs.map(|(a, b)| [a, b]).collect()));
        }
        let [first, second] = first.common_refinement(second)?;
        let (first, second) = (within(&first, part)?, within(&second, part)?);
        let cells = Self {
            trimmed: true,
            breaks: first.breaks().iter().map(Coordinate::approximate).collect(),
            closed: is_closed(&first)? && is_closed(&second)?,
        };
        let pairs = first.rails()?.into_iter().zip(second.rails()?);
        Ok((cells, pairs.map(|(a, b)| [a, b]).collect()))
    }
}

/// Returns the part of a curve of several pieces.
fn within(curve: &PiecewiseRail, [from, to]: [f64; 2]) -> Result<PiecewiseRail> {
    if curve.count() == 1 || [from, to] == [0.0, 1.0] {
        return Ok(curve.clone());
    }
    curve.part(&torse_geometry::exact(from), &torse_geometry::exact(to))
}

pub fn is_closed(curve: &PiecewiseRail) -> Result<bool> {
    let (start, end) = (curve.point(0.0)?, curve.point(1.0)?);
    let size = start.iter().fold(0.0_f64, |m, c| m.max(c.abs()));
    Ok(norm(&sub(&end, &start)) <= SAME * size)
}

/// Returns the marks of each patch, on its own parameters; a line that runs over several is cut where they meet.
pub fn distributed(marks: Vec<Mark>, cells: &PatchIntervals) -> Vec<Vec<Mark>> {
    if cells.breaks.len() <= 2 {
        return vec![marks];
    }
    let intervals = || cells.breaks.windows(2).map(|ends| [ends[0], ends[1]]);
    let mut all = vec![Vec::new(); cells.breaks.len() - 1];
    for mark in marks {
        match mark {
            Mark::Line(places) => {
                for (list, interval) in all.iter_mut().zip(intervals()) {
                    list.extend(runs(&places, interval).into_iter().map(Mark::Line));
                }
            }
            Mark::Opening(MarkedOpening::OnParameters(sides)) => {
                let cut = sides.iter().flat_map(|side| {
                    let places = side.ends;
                    let parts = intervals().enumerate().flat_map(move |(index, interval)| {
                        let parts = runs(&places, interval).into_iter();
                        parts.filter_map(move |run| match run.as_slice() {
                            [from, to] => Some((index, [*from, *to])),
                            _ => None,
                        })
                    });
                    let mut parts: Vec<(usize, [[f64; 2]; 2])> = parts.collect();
                    if places[1][0] < places[0][0] {
                        parts.reverse();
                    }
                    parts
                });
                let cut: Vec<(usize, [[f64; 2]; 2])> = cut.collect();
                let owner = cut.first().map_or(0, |(index, _)| *index);
                let sides = cut.iter().map(|(index, ends)| ParameterSide {
                    after: index.cast_signed() - owner.cast_signed(),
                    ends: *ends,
                });
                let opening = MarkedOpening::OnParameters(sides.collect());
                if let Some(list) = all.get_mut(owner) {
                    list.push(Mark::Opening(opening));
                }
            }
            // They go over all patches of their piece.
            Mark::Opening(MarkedOpening::InSpace { .. } | MarkedOpening::Passed { .. }) => {
                if let Some(list) = all.first_mut() {
                    list.push(mark);
                }
            }
            Mark::Hole(at, _)
            | Mark::Circle(at, _)
            | Mark::Text(at, ..)
            | Mark::Opening(MarkedOpening::OnSheet { at, .. }) => {
                let later = intervals()
                    .skip(1)
                    .take_while(|[from, _]| *from <= at[0])
                    .count();
                let [from, to] = intervals().nth(later).unwrap_or([0.0, 1.0]);
                let mut moved = mark;
                if let Mark::Hole(at, _)
                | Mark::Circle(at, _)
                | Mark::Text(at, ..)
                | Mark::Opening(MarkedOpening::OnSheet { at, .. }) = &mut moved
                {
                    at[0] = ((at[0] - from) / (to - from)).clamp(0.0, 1.0);
                }
                if let Some(list) = all.get_mut(later) {
                    list.push(moved);
                }
            }
        }
    }
    all
}

/// Returns the runs of a polygon within an interval of the first parameter, with a parameter of their own.
fn runs(places: &[[f64; 2]], [from, to]: [f64; 2]) -> Vec<Vec<[f64; 2]>> {
    let local = |[u, v]: [f64; 2]| [((u - from) / (to - from)).clamp(0.0, 1.0), v];
    let mut runs: Vec<Vec<[f64; 2]>> = Vec::new();
    let mut open = false;
    for pair in places.windows(2) {
        let (p, q) = (pair[0], pair[1]);
        // The shares of the side where it crosses the ends of the interval.
        let width = q[0] - p[0];
        let (mut low, mut high) = (0.0_f64, 1.0_f64);
        if width == 0.0 {
            if p[0] < from || p[0] > to || (p[0] == to && to < 1.0) {
                open = false;
                continue;
            }
        } else {
            let (a, b) = ((from - p[0]) / width, (to - p[0]) / width);
            low = low.max(a.min(b));
            high = high.min(a.max(b));
        }
        if low >= high {
            open = false;
            continue;
        }
        let at = |x: f64| match x {
            0.0 => p,
            1.0 => q,
            x => [p[0] + x * width, p[1] + x * (q[1] - p[1])],
        };
        if !open || low > 0.0 {
            runs.push(vec![local(at(low))]);
        }
        if let Some(run) = runs.last_mut() {
            run.push(local(at(high)));
        }
        open = high == 1.0;
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::*;

    fn thirds() -> PatchIntervals {
        PatchIntervals {
            breaks: vec![0.0, 0.25, 0.5, 1.0],
            closed: false,
            trimmed: false,
        }
    }

    #[test]
    fn a_line_over_three_patches_is_cut_into_three() {
        let line = Mark::Line(vec![[0.125, 0.0], [0.75, 1.0]]);
        let all = distributed(vec![line], &thirds());
        let lines: Vec<&Mark> = all.iter().flatten().collect();
        assert_eq!(lines.len(), 3);
        assert_eq!(lines[0], &Mark::Line(vec![[0.5, 0.0], [1.0, 0.2]]));
        assert_eq!(lines[1], &Mark::Line(vec![[0.0, 0.2], [1.0, 0.6]]));
        let Mark::Line(last) = lines[2] else { panic!() };
        assert_eq!(last[1], [0.5, 1.0]);
    }

    #[test]
    fn a_hole_goes_to_the_patch_it_is_on() {
        let all = distributed(
            vec![Mark::Hole([0.375, 0.5], 2.0), Mark::Hole([1.0, 0.5], 3.0)],
            &thirds(),
        );
        assert_eq!(all[1], [Mark::Hole([0.5, 0.5], 2.0)]);
        assert_eq!(all[2], [Mark::Hole([1.0, 0.5], 3.0)]);
        assert!(all[0].is_empty());
    }
}
