//! Following a curve around, arc by arc, from sheet to sheet.

use super::super::Sheet;
use super::search::{Hit, nearest};
use super::source::TracedSource;
use super::{LEAST_STEP, SheetArc, SheetTracer, TraceError, Traced};
use crate::chebyshev::{NODES, nodes};
use crate::model::ChebyshevModel;
use crate::vector::{norm, sub};

/// The longest arcs, as shares of a sheet or rail.
const LONGEST: f64 = 0.25;
/// What a place may be beyond an edge by rounding.
const BEYOND: f64 = 1e-9;
/// Halvings that find where a sheet ends.
const HALVINGS: u32 = 60;

/// What became of a range.
enum Followed {
    /// An arc, and the solution at its end.
    Arc(Box<SheetArc>, [f64; 3]),
    /// The solution leaves the rulings of the sheet between these parameters, the first of which has this solution.
    Beyond([f64; 2], [f64; 3]),
    /// Nothing is proved.
    Nothing,
}

impl SheetTracer<'_> {
    /// Returns the arcs of a closed curve, from a start on.
    pub(super) fn around<T: TracedSource>(
        &self,
        sources: &[T],
        start: Hit,
        joined: f64,
    ) -> Traced<Vec<SheetArc>> {
        let mut arcs = Vec::new();
        let mut hit = start;
        for source in sources {
            // What the source before ended with is near what this one begins with.
            let sheet = self.sheet(hit)?;
            let anchor = source.anchor(0.0)?;
            let began = source.solved(sheet, 0.0, hit.at);
            let at = began.ok_or(TraceError::Undecided { at: anchor })?;
            let gap = norm(&sub(&sheet.point(at[0], at[1])?, &self.point(hit)?));
            if gap > joined {
                return Err(TraceError::NotClosed { gap });
            }
            hit.at = at;
            hit = self.followed(source, hit, joined, &mut arcs)?;
        }
        let gap = norm(&sub(&self.point(hit)?, &self.point(start)?));
        if gap > joined {
            return Err(TraceError::NotClosed { gap });
        }
        Ok(arcs)
    }

    fn sheet(&self, hit: Hit) -> Traced<&Sheet> {
        let from = [0.0; 3];
        let found = self.sheets.get(hit.sheet).copied();
        found.ok_or(TraceError::Misses { from })
    }

    fn point(&self, hit: Hit) -> Traced<[f64; 3]> {
        Ok(self.sheet(hit)?.point(hit.at[0], hit.at[1])?)
    }

    /// Adds the arcs for all parameters of a source, and returns where they end.
    fn followed(
        &self,
        source: &impl TracedSource,
        mut hit: Hit,
        joined: f64,
        arcs: &mut Vec<SheetArc>,
    ) -> Traced<Hit> {
        let (mut y, mut width) = (0.0, LONGEST);
        let mut changes = 0;
        while y < 1.0 {
            let to = if y + width > 1.0 - 1e-12 {
                1.0
            } else {
                y + width
            };
            match self.arc(source, hit, [y, to])? {
                Followed::Arc(arc, at) => {
                    arcs.push(*arc);
                    (y, hit.at) = (to, at);
                    width = (2.0 * width).min(LONGEST);
                }
                Followed::Beyond([before, after], at) => {
                    let (border, at) = self.border(source, hit, [before, after], at)?;
                    if border - y > 1e-12 {
                        match self.arc(source, hit, [y, border])? {
                            Followed::Arc(arc, _) => arcs.push(*arc),
                            _ => {
                                width = self.halved(source, y, width)?;
                                continue;
                            }
                        }
                    }
                    changes += 1;
                    (y, hit) = (border, self.across(Hit { at, ..hit }, joined)?);
                    if changes > 2 * self.sheets.len() {
                        return Err(TraceError::Undecided {
                            at: source.anchor(y)?,
                        });
                    }
                }
                Followed::Nothing => width = self.halved(source, y, width)?,
            }
        }
        Ok(hit)
    }

    fn halved(&self, source: &impl TracedSource, y: f64, width: f64) -> Traced<f64> {
        if width < LEAST_STEP {
            let at = source.anchor(y)?;
            return Err(TraceError::Undecided { at });
        }
        Ok(0.5 * width)
    }

    /// Returns the arc for a range of parameters.
    fn arc(&self, source: &impl TracedSource, hit: Hit, range: [f64; 2]) -> Traced<Followed> {
        let sheet = self.sheet(hit)?;
        let mut rows = [[0.0; NODES]; 3];
        let (mut at, mut before) = (hit.at, range[0]);
        for (k, y) in nodes(range[0], range[1]).into_iter().enumerate() {
            let Some(next) = source.solved(sheet, y, at) else {
                return Ok(Followed::Nothing);
            };
            source.check(sheet, y, next)?;
            if !(-BEYOND..=1.0 + BEYOND).contains(&next[0]) {
                return Ok(Followed::Beyond([before, y], at));
            }
            if !(-BEYOND..=1.0 + BEYOND).contains(&next[1]) {
                let [u, v, _] = next;
                let at = sheet.point(u, v.clamp(0.0, 1.0))?;
                return Err(TraceError::Leaves { at });
            }
            for (row, value) in rows.iter_mut().zip(next) {
                row[k] = value;
            }
            (at, before) = (next, y);
        }
        let Some(model) = self.models.get(hit.sheet) else {
            return Ok(Followed::Nothing);
        };
        let place = [&rows[0], &rows[1]].map(ChebyshevModel::through);
        let arc = source
            .proved(model, range, &rows)
            .and_then(|off| SheetArc::new(model, hit.sheet, place, off));
        let Some(arc) = arc else {
            return Ok(Followed::Nothing);
        };
        for (k, y) in nodes(range[0], range[1]).into_iter().enumerate() {
            // The ends may lie on a border.
            if k % 2 == 1 {
                let at = rows.map(|row| row[k]);
                source.confirmed(self, y, Hit { at, ..hit })?;
            }
        }
        Ok(Followed::Arc(Box::new(arc), at))
    }

    /// Returns the parameter at which the first or the last ruling of the sheet is reached, and the solution there.
    fn border(
        &self,
        source: &impl TracedSource,
        hit: Hit,
        [mut low, mut high]: [f64; 2],
        mut at: [f64; 3],
    ) -> Traced<(f64, [f64; 3])> {
        let sheet = self.sheet(hit)?;
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            match source.solved(sheet, middle, at) {
                Some(next) if (0.0..=1.0).contains(&next[0]) => (low, at) = (middle, next),
                _ => high = middle,
            }
        }
        Ok((low, at))
    }

    /// Returns the same point on the sheet that is joined there.
    fn across(&self, hit: Hit, joined: f64) -> Traced<Hit> {
        let at = self.point(hit)?;
        let others = self.sheets.iter().enumerate();
        let others = others.filter(|(index, _)| *index != hit.sheet);
        let places = others.filter_map(|(sheet, patch)| Some((sheet, nearest(patch, &at)?)));
        let best = places.min_by(|a, b| a.1.1.total_cmp(&b.1.1));
        match best {
            Some((sheet, ([u, v], off))) if off <= joined => Ok(Hit {
                sheet,
                // On a ruling that is joined, but for rounding.
                at: [if u < 0.5 { 0.0 } else { 1.0 }, v, hit.at[2]],
            }),
            _ => Err(TraceError::Leaves { at }),
        }
    }
}
