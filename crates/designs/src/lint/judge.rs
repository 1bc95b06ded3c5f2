//! Rule by rule: what is found, and where.

use super::contours::{Contour, LooseEnd, contours, least_width};
use super::necks::necks;
use super::pairs::{Chord, chords, for_pairs, meetings, shared};
use super::rules::{Check, LintRule, LintRules};
use super::trace::{Traced, traced};
use super::{RuleFault, RuleOutcome, RuleRow};
use crate::numbers::number;
use crate::polygon::distance;
use torse_exchange::{FileKind, Imported, UnitSource};
use torse_geometry::GeometryError;
use torse_geometry::pattern::Segment;

/// Kinds of entities that are writing.
const TEXTS: [&str; 9] = [
    "TEXT",
    "MTEXT",
    "ATTDEF",
    "ATTRIB",
    "RTEXT",
    "text",
    "tspan",
    "flowRoot",
    "foreignObject",
];

/// The most points in which contours meet that are told.
const MAX_MEETINGS: usize = 1000;

/// A drawing that is judged.
pub(super) struct Judge<'d> {
    found: &'d Imported,
    rules: &'d LintRules,
    thickness: Option<f64>,
    curves: Vec<Traced>,
    pub contours: Vec<Contour>,
    loose: Vec<LooseEnd>,
    chords: Vec<Chord>,
}

/// What a check found: a place, the curve there, a reason, what was measured.
struct Finding {
    at: Option<[f64; 2]>,
    place: Option<String>,
    reason: String,
    measured: Option<f64>,
}

impl Finding {
    fn at(at: [f64; 2], place: Option<String>, reason: String) -> Self {
        Self {
            at: Some(at),
            place,
            reason,
            measured: None,
        }
    }
}

impl<'d> Judge<'d> {
    pub(super) fn new(
        found: &'d Imported,
        rules: &'d LintRules,
        thickness: Option<f64>,
    ) -> Result<Self, GeometryError> {
        let curves = traced(found, rules)?;
        let (contours, loose) = contours(&curves, rules.joined_within);
        let mut all = Vec::new();
        for (index, contour) in contours.iter().enumerate() {
            chords(index, &contour.segments, &mut all);
        }
        Ok(Self {
            found,
            rules,
            thickness,
            curves,
            contours,
            loose,
            chords: all,
        })
    }

    /// Width and height of the box around all contours.
    pub(super) fn size(&self) -> Option<[f64; 2]> {
        let boxes = self
            .contours
            .iter()
            .flat_map(|c| &c.segments)
            .map(Segment::bounds);
        let whole = boxes.reduce(|[a, b], [c, d]| {
            [
                [a[0].min(c[0]), a[1].min(c[1])],
                [b[0].max(d[0]), b[1].max(d[1])],
            ]
        })?;
        let [low, high] = whole;
        Some([high[0] - low[0], high[1] - low[1]])
    }

    /// Returns the rules with their outcomes, and all faults.
    pub(super) fn rules(&self) -> (Vec<RuleRow>, Vec<RuleFault>) {
        let (mut rows, mut faults) = (Vec::new(), Vec::new());
        for rule in &self.rules.rules {
            let findings = self.findings(rule);
            let count = findings.as_ref().map_or(0, Vec::len);
            rows.push(RuleRow {
                check: rule.check,
                outcome: match &findings {
                    None => RuleOutcome::NotJudged,
                    Some(list) if list.is_empty() => RuleOutcome::Kept,
                    Some(_) => RuleOutcome::Broken,
                },
                faults: count,
                not_looked_at: rule.check.not_looked_at(),
                source: rule.source.clone(),
                url: rule.url.clone(),
            });
            faults.extend(
                findings
                    .unwrap_or_default()
                    .into_iter()
                    .map(|finding| RuleFault {
                        check: rule.check,
                        at: finding.at.map(|at| self.in_file(at)),
                        place: finding.place,
                        reason: finding.reason,
                        measured: finding.measured,
                        bound: rule.least(self.thickness).or(rule.at_most),
                        source: rule.source.clone(),
                    }),
            );
        }
        (rows, faults)
    }

    /// Returns a point as the file counts: y goes down in SVG, and up in the drawing that is made of it.
    fn in_file(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        match self.found.kind {
            FileKind::Svg => [x, 0.0 - y],
            _ => [x, y],
        }
    }

    /// Returns what breaks a rule; nothing where it cannot be judged.
    fn findings(&self, rule: &LintRule) -> Option<Vec<Finding>> {
        let least = rule.least(self.thickness);
        if rule.per_thickness.is_some() && least.is_none() {
            return None;
        }
        let least = least.unwrap_or(0.0);
        match rule.check {
            Check::Units => Some(self.units()),
            Check::Text => Some(self.passed_over(true)),
            Check::OnlyLines => Some(self.passed_over(false)),
            Check::Closed => Some(self.open_ends()),
            Check::Doubled => self.doubled(),
            Check::Crossing => self.crossings(),
            Check::OnePart => Some(self.parts()),
            Check::Hole => Some(self.holes(least)),
            Check::Web => self.webs(least),
            Check::Radius => Some(self.radii(least)),
            Check::Nodes => Some(self.nodes(rule)),
            Check::ShortLines => Some(self.short(least)),
            Check::Size => Some(self.sizes(rule)),
        }
    }

    fn units(&self) -> Vec<Finding> {
        if matches!(self.found.unit, UnitSource::Stated(_)) {
            return Vec::new();
        }
        vec![Finding {
            at: None,
            place: None,
            reason: "the file states no unit of length: a cutter has to guess".to_owned(),
            measured: None,
        }]
    }

    /// Entities that are no lines: those that are writing, or the others.
    fn passed_over(&self, texts: bool) -> Vec<Finding> {
        let places = self.found.passed_places.iter();
        let kinds = self.found.passed_over.iter().zip(places);
        kinds
            .filter(|((kind, _), _)| {
                let hidden = kind.starts_with("hidden ") || kind.contains("paper space");
                !hidden && TEXTS.contains(&kind.as_str()) == texts
            })
            .map(|((kind, count), place)| {
                let place = place.to_string();
                Finding {
                    at: None,
                    place: (!place.is_empty()).then(|| place.trim_end_matches(": ").to_owned()),
                    reason: if texts {
                        format!("{count} text entities (`{kind}`): write letters as outlines, or leave them out")
                    } else {
                        format!("{count} of `{kind}`, which no cutter follows")
                    },
                    measured: None,
                }
            })
            .collect()
    }

    fn place(&self, curve: usize) -> Option<String> {
        self.curves
            .get(curve)
            .map(|curve| match curve.layer.as_str() {
                "" => curve.place.clone(),
                layer => format!("{}, layer {layer}", curve.place),
            })
    }

    fn place_of(&self, contour: usize) -> Option<String> {
        let contour = self.contours.get(contour)?;
        self.place(*contour.curves.first()?)
    }

    fn open_ends(&self) -> Vec<Finding> {
        let mut found: Vec<Finding> = self
            .loose
            .iter()
            .map(|end| {
                let reason = match (end.ends, end.gap) {
                    (1, Some(gap)) => {
                        format!(
                            "an open end: the nearest other one is {} mm away",
                            number(gap)
                        )
                    }
                    (1, None) => "an open end".to_owned(),
                    (count, _) => format!("{count} lines end in one point, and a contour has two"),
                };
                Finding {
                    measured: end.gap.filter(|_| end.ends == 1),
                    ..Finding::at(end.at, self.place(end.curve), reason)
                }
            })
            .collect();
        if self.contours.is_empty() && found.is_empty() {
            found.push(Finding {
                at: None,
                place: None,
                reason: "there is no closed contour that is cut".to_owned(),
                measured: None,
            });
        }
        found
    }

    /// Returns lines that lie on lines that are cut, whatever their layer.
    fn doubled(&self) -> Option<Vec<Finding>> {
        let within = self.rules.joined_within;
        let curves = self.curves.iter().map(|curve| curve.segments.as_slice());
        let mut found: Vec<(usize, usize, f64, [f64; 2])> = Vec::new();
        let all = segment_pairs(curves, within, |(one, _, s), (two, _, t)| {
            let is_cut = |index: usize| self.curves.get(index).is_some_and(|curve| curve.cut);
            if !(is_cut(one) || is_cut(two)) {
                return;
            }
            if let Some((length, at)) = shared(s, t, within) {
                found.push((one.min(two), one.max(two), length, at));
            }
        });
        // One fault for each two curves: the longest piece tells where.
        found.sort_by(|a, b| (a.0, a.1).cmp(&(b.0, b.1)).then(b.2.total_cmp(&a.2)));
        let mut faults: Vec<(usize, usize, f64, [f64; 2])> = Vec::new();
        for (one, two, length, at) in found {
            match faults.last_mut() {
                Some(last) if last.0 == one && last.1 == two => last.2 += length,
                _ => faults.push((one, two, length, at)),
            }
        }
        all.then(|| {
            let faults = faults.into_iter().map(|(one, two, length, at)| {
                let other = self.place(two).unwrap_or_default();
                let words = if one == two {
                    "itself".to_owned()
                } else {
                    other
                };
                Finding {
                    measured: Some(length),
                    ..Finding::at(
                        at,
                        self.place(one),
                        format!(
                            "{} mm lie on {words}: they would be cut twice",
                            number(length)
                        ),
                    )
                }
            });
            faults.collect()
        })
    }

    fn crossings(&self) -> Option<Vec<Finding>> {
        let within = self.rules.joined_within;
        let contours = self.contours.iter();
        let contours = contours.map(|contour| contour.segments.as_slice());
        let mut found: Vec<(usize, usize, [f64; 2])> = Vec::new();
        let all = segment_pairs(contours, 0.0, |(one, i, s), (two, k, t)| {
            let contour = self.contours.get(one);
            let count = contour.map_or(0, |contour| contour.segments.len());
            let apart = i.abs_diff(k);
            let beside = one == two && (apart <= 1 || apart + 1 >= count);
            for at in meetings(s, t) {
                // Neighbours meet in their common end.
                let mut ends = [s.from, s.to].into_iter();
                let joint = ends.any(|end| distance(end, at) <= 2.0 * within);
                if !(beside && joint) {
                    found.push((one.min(two), one.max(two), at));
                }
            }
        });
        let count = found.len();
        let faults = found.into_iter().take(MAX_MEETINGS).map(|(one, two, at)| {
            let words = if one == two {
                "a contour meets itself".to_owned()
            } else {
                format!("it meets {}", self.place_of(two).unwrap_or_default())
            };
            Finding::at(at, self.place_of(one), words)
        });
        (all || count > 0).then(|| faults.collect())
    }

    fn parts(&self) -> Vec<Finding> {
        let mut found = Vec::new();
        let start = |contour: &Contour| contour.segments.first().map(|segment| segment.from);
        let each = || self.contours.iter().enumerate();
        let outer = each().filter(|(_, contour)| contour.depth == 0);
        for (index, contour) in outer.skip(1) {
            if let Some(at) = start(contour) {
                let reason = "a second part: a file has one".to_owned();
                found.push(Finding::at(at, self.place_of(index), reason));
            }
        }
        for (index, contour) in each().filter(|(_, contour)| contour.depth > 1) {
            if let Some(at) = start(contour) {
                let reason = "a part inside of an opening falls out with it".to_owned();
                found.push(Finding::at(at, self.place_of(index), reason));
            }
        }
        found
    }

    fn holes(&self, least: f64) -> Vec<Finding> {
        let openings = self
            .contours
            .iter()
            .enumerate()
            .filter(|(_, c)| c.depth % 2 == 1);
        openings
            .filter_map(|(index, contour)| {
                let polygon = contour.polygon();
                let width = contour.diameter().unwrap_or_else(|| {
                    // The polygon is inside of what is round, by a share of its size.
                    let round = contour.segments.iter().any(|segment| !segment.is_line());
                    least_width(&polygon) * if round { 1.0 + 5e-3 } else { 1.0 }
                });
                (width < least * (1.0 - 1e-9)).then(|| Finding {
                    measured: Some(width),
                    ..Finding::at(
                        centre(&polygon),
                        self.place_of(index),
                        format!(
                            "an opening {} mm wide: {} mm at least",
                            number(width),
                            number(least)
                        ),
                    )
                })
            })
            .collect()
    }

    fn webs(&self, least: f64) -> Option<Vec<Finding>> {
        let mut closest: std::collections::BTreeMap<(usize, usize), (f64, [f64; 2])> =
            std::collections::BTreeMap::new();
        let all = for_pairs(&self.chords, least, |a, b| {
            if a.contour == b.contour {
                return;
            }
            let (gap, at) = a.gap(b);
            // No farther than this in truth.
            let gap = gap + a.off + b.off;
            let key = (a.contour.min(b.contour), a.contour.max(b.contour));
            if gap < least && closest.get(&key).is_none_or(|(known, _)| gap < *known) {
                closest.insert(key, (gap, at));
            }
        });
        let faults = closest.into_iter().map(|((one, two), (gap, at))| Finding {
            measured: Some(gap),
            ..Finding::at(
                at,
                self.place_of(one),
                format!(
                    "only {} mm to {}: {} mm at least",
                    number(gap),
                    self.place_of(two).unwrap_or_default(),
                    number(least)
                ),
            )
        });
        let necks = necks(&self.chords, least, self.rules.joined_within);
        let all = all && necks.is_some();
        let narrow = necks.into_iter().flatten().map(|(contour, neck)| Finding {
            measured: Some(neck.width),
            ..Finding::at(
                neck.at,
                self.place_of(contour),
                format!(
                    "a neck of {} mm between two sides of one contour: {} mm at least",
                    number(neck.width),
                    number(least)
                ),
            )
        });
        let faults: Vec<Finding> = faults.chain(narrow).collect();
        (all || !faults.is_empty()).then_some(faults)
    }

    fn radii(&self, least: f64) -> Vec<Finding> {
        let mut found = Vec::new();
        for (index, contour) in self.contours.iter().enumerate() {
            let arcs = contour.segments.iter().filter(|segment| !segment.is_line());
            for arc in arcs.filter(|arc| arc.radius() < least * (1.0 - 1e-9)) {
                let radius = arc.radius();
                found.push(Finding {
                    measured: Some(radius),
                    ..Finding::at(
                        arc.point(0.5),
                        self.place_of(index),
                        format!(
                            "an arc of radius {} mm: {} mm at least",
                            number(radius),
                            number(least)
                        ),
                    )
                });
            }
        }
        found
    }

    fn nodes(&self, rule: &LintRule) -> Vec<Finding> {
        let most = rule.at_most.unwrap_or(f64::INFINITY);
        let mut found = Vec::new();
        for (index, contour) in self.contours.iter().enumerate() {
            #[allow(clippy::cast_precision_loss)]
            let nodes = contour.nodes as f64;
            if nodes > most
                && let Some(first) = contour.segments.first()
            {
                found.push(Finding {
                    measured: Some(nodes),
                    ..Finding::at(
                        first.from,
                        self.place_of(index),
                        format!("a contour of {nodes} lines and arcs: {most} at most"),
                    )
                });
            }
        }
        found
    }

    fn short(&self, least: f64) -> Vec<Finding> {
        let mut found = Vec::new();
        for (index, curve) in self.curves.iter().enumerate() {
            if !curve.cut || curve.sampled {
                continue;
            }
            for segment in curve
                .segments
                .iter()
                .filter(|segment| segment.length() < least)
            {
                let length = segment.length();
                found.push(Finding {
                    measured: Some(length),
                    ..Finding::at(
                        segment.from,
                        self.place(index),
                        format!(
                            "a line of {} mm: {} mm at least",
                            number(length),
                            number(least)
                        ),
                    )
                });
            }
        }
        found
    }

    fn sizes(&self, rule: &LintRule) -> Vec<Finding> {
        let Some(size) = self.size() else {
            return Vec::new();
        };
        let (short, long) = (size[0].min(size[1]), size[0].max(size[1]));
        let mut found = Vec::new();
        let mut miss = |measured: f64, reason: String| {
            found.push(Finding {
                at: None,
                place: None,
                reason,
                measured: Some(measured),
            });
        };
        if let Some(most) = rule.at_most.filter(|most| long > *most) {
            miss(
                long,
                format!("{} mm long: {} mm at most", number(long), number(most)),
            );
        }
        if let Some(least) = rule.least(self.thickness).filter(|least| short < *least) {
            miss(
                short,
                format!("{} mm wide: {} mm at least", number(short), number(least)),
            );
        }
        found
    }
}

/// A line or an arc of a curve: the number of the curve, its own there, and itself.
type Numbered<'s> = (usize, usize, &'s Segment);

/// Calls for each pair of lines and arcs whose boxes are no farther apart than `reach`; false where there were too many
/// to look at all of them.
fn segment_pairs<'s>(
    curves: impl Iterator<Item = &'s [Segment]>,
    reach: f64,
    mut look: impl FnMut(Numbered<'s>, Numbered<'s>),
) -> bool {
    let mut segments: Vec<Numbered<'s>> = Vec::new();
    for (index, curve) in curves.enumerate() {
        let each = curve.iter().enumerate();
        segments.extend(each.map(|(number, segment)| (index, number, segment)));
    }
    let boxes = boxes(segments.iter().map(|(_, _, segment)| *segment));
    for_pairs(&boxes, reach, |a, b| {
        if let (Some(one), Some(two)) = (segments.get(a.number), segments.get(b.number)) {
            look(*one, *two);
        }
    })
}

/// Returns the boxes around lines and arcs, as the diagonals that stand for them in the search of pairs.
fn boxes<'s>(segments: impl Iterator<Item = &'s Segment>) -> Vec<Chord> {
    let each = segments.enumerate().map(|(number, segment)| {
        let [from, to] = segment.bounds();
        Chord {
            from,
            to,
            off: 0.0,
            contour: 0,
            number,
        }
    });
    each.collect()
}

/// Returns the middle of the box around a polygon.
fn centre(polygon: &[[f64; 2]]) -> [f64; 2] {
    [0, 1].map(|i| {
        let each = || polygon.iter().map(|point| point[i]);
        let (low, high) = (
            each().fold(f64::INFINITY, f64::min),
            each().fold(f64::NEG_INFINITY, f64::max),
        );
        0.5 * (low + high)
    })
}
