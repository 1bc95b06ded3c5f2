//! The blank of a piece: its pattern, with each bend of a tool as long as its neutral line.
//!
//! The pattern is the development of the designed surface. What is rolled to a large radius keeps its middle, and the
//! pattern is the blank. A bend over a tool, of inside radius `r` and angle `beta` in a sheet of thickness `t`, is
//! `beta (r + K t)` long on the blank instead: where the bend is a patch of the design, its strip gets that width;
//! where it is an edge between two flat patches, a strip is put between them and each loses its setback,
//! `(r + s t) tan(beta/2)`, with `s` the share of the thickness at which the designed surface lies.

mod bends;
mod strip;

use super::FlatPiece;
use crate::bending::DesignedSurface;
use crate::design::{Design, Patch};
use crate::error::DesignError;
use crate::position::position;
use bends::{FoldBend, RulingJoint, joint_bend, patch_bend, radii, rolled};
use strip::{Side, closed};
use torse_geometry::pattern::{FlatPattern, Segment};

/// A bend that a tool makes.
#[derive(Debug, Clone, PartialEq)]
pub struct ToolBend {
    /// The patch that is bent, or the two patches that meet at the edge.
    pub name: String,
    /// The bend line on the blank: the middle of the bent strip.
    pub line: [[f64; 2]; 2],
    /// The angle in radians, positive towards the viewer.
    pub angle: f64,
    /// The inside radius in millimetres.
    pub inside_radius: f64,
    /// Where the neutral line runs, as a share of the thickness from the inside.
    pub k_factor: f64,
    /// The length of the neutral line in the bend.
    pub allowance: f64,
    /// What the blank falls short of the two outer flanges; `None` from 180 degrees on, where their outer faces do not meet.
    pub deduction: Option<f64>,
    /// By how much the blank is longer than the pattern; negative where it is shorter.
    pub growth: f64,
}

/// An edge between two patches that no radius is given for.
#[derive(Debug, Clone, PartialEq)]
pub struct SharpFold {
    /// The two patches.
    pub name: String,
    /// The line of the edge on the blank.
    pub line: [[f64; 2]; 2],
    /// The angle in radians, positive towards the viewer.
    pub angle: f64,
}

/// A patch that is rolled.
#[derive(Debug, Clone, PartialEq)]
pub struct Rolled {
    /// The patch.
    pub name: String,
    /// The smallest and the largest of the radii of its rulings, of each where it is tightest; the largest is infinite
    /// where it is flat somewhere. Towards an apex all of them fall to 0: then those of the other end.
    pub radii: [f64; 2],
    /// Whether it reaches its apex.
    pub apex: bool,
}

/// What is cut for a piece, and how it is formed.
#[derive(Debug, Clone, PartialEq)]
pub struct Blank {
    /// The closed outline, counterclockwise.
    pub outline: Vec<Segment>,
    /// The bends over tools, in the order of the chain.
    pub bends: Vec<ToolBend>,
    /// The edges without a radius: scored, or bent as sharply as the material allows.
    pub sharp: Vec<SharpFold>,
    /// The patches that are rolled.
    pub rolled: Vec<Rolled>,
    /// No point of the outline is farther from that of the exact blank.
    pub error: f64,
    zones: Vec<PatchMotion>,
}

/// Where the points of a patch of the chain go: a shift, and before it a stretch across the rulings of a bend.
#[derive(Debug, Clone, PartialEq)]
struct PatchMotion {
    shift: [f64; 2],
    stretch: Option<Stretch>,
    /// The strips at both ends that a bend takes.
    taken: Vec<TakenStrip>,
}

/// The strip of a patch that a bend takes: where it is, and by which factor its half of the bend is wider on the blank.
#[derive(Debug, Clone, Copy, PartialEq)]
struct TakenStrip {
    side: Side,
    factor: f64,
}

impl TakenStrip {
    fn new(side: Side, bend: &FoldBend) -> Self {
        Self {
            side,
            factor: 0.5 * bend.tool.allowance / bend.setback,
        }
    }
}

/// Lengths across a line, on the side that its normal points to, times a factor.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Stretch {
    from: Side,
    factor: f64,
}

impl PatchMotion {
    fn point(&self, point: [f64; 2]) -> [f64; 2] {
        let [mut x, mut y] = point;
        if let Some(stretch) = self.stretch {
            let more = (stretch.factor - 1.0) * stretch.from.height(point);
            x += more * stretch.from.normal[0];
            y += more * stretch.from.normal[1];
        }
        [x + self.shift[0], y + self.shift[1]]
    }

    /// Adds the image of a segment, an arc that is stretched by chords no farther from it than `chord`; gives how far
    /// they are at most.
    fn add(&self, segment: &Segment, chord: f64, to: &mut Vec<Segment>) -> f64 {
        let parts = match self.stretch {
            Some(_) if !segment.is_line() => {
                (segment.sagitta() / chord).sqrt().ceil().clamp(1.0, 4096.0)
            }
            _ => 1.0,
        };
        let image = |part: Segment| Segment {
            from: self.point(part.from),
            to: self.point(part.to),
            bulge: if self.stretch.is_some() {
                0.0
            } else {
                part.bulge
            },
        };
        let (mut k, mut off) = (0.0, 0.0_f64);
        while k < parts {
            let part = segment.part(k / parts, (k + 1.0) / parts);
            if let Some(stretch) = self.stretch {
                off = off.max(part.sagitta() * stretch.factor.max(1.0));
            }
            to.push(image(part));
            k += 1.0;
        }
        off
    }
}

impl Blank {
    /// Returns where a point of the pattern, on a patch of the chain, lies on the blank, with room for a circle about
    /// it: `None` where a bend takes it.
    #[must_use]
    pub fn place(&self, patch: usize, point: [f64; 2], room: f64) -> Option<[f64; 2]> {
        let zone = self.zones.get(patch)?;
        let bent = zone.stretch.is_some() && room > 0.0;
        let taken = zone
            .taken
            .iter()
            .any(|strip| strip.side.height(point) > -room);
        (!bent && !taken).then(|| zone.point(point))
    }

    /// Returns where a point of the pattern, on a patch of the chain, lies on the blank; of one that a bend takes, where
    /// its patch would have it.
    pub(crate) fn moved(&self, patch: usize, point: [f64; 2]) -> Option<[f64; 2]> {
        self.zones.get(patch).map(|zone| zone.point(point))
    }

    /// Returns where a point of the pattern that a bend takes lies on the strip of the bend, its distances across the bend
    /// line in proportion; `None` of any other.
    pub(crate) fn in_bend(&self, patch: usize, point: [f64; 2]) -> Option<[f64; 2]> {
        let zone = self.zones.get(patch)?;
        let mut strips = zone.taken.iter();
        let strip = strips.find(|strip| strip.side.height(point) > 0.0)?;
        let height = strip.side.height(point);
        let start = zone.point(strip.side.along(point, -height));
        Some(strip.side.along(start, strip.factor * height))
    }

    /// Returns what bends leave of a chain along a rail of a patch, on the pattern; nothing where they take all of it.
    pub(crate) fn kept(&self, patch: usize, chain: &[Segment]) -> Vec<Segment> {
        let taken = self
            .zones
            .get(patch)
            .map_or(&[] as &[_], |zone| &zone.taken);
        let mut kept = chain.to_vec();
        for TakenStrip { side, .. } in taken {
            let (Some(first), Some(last)) = (kept.first(), kept.last()) else {
                break;
            };
            let rest = if side.height(first.from) > side.height(last.to) {
                strip::behind(&kept, &side.turned())
            } else {
                strip::before(&kept, side)
            };
            kept = rest.unwrap_or_default();
        }
        kept
    }
}

/// Returns the blank of a piece.
///
/// # Errors
/// [`DesignError::Blank`] for a bend that cannot be made from what the file says: no thickness, a patch that is no arc
/// of a circular cylinder, a table of K-factors that ends before its radius, a flange shorter than its setback.
pub fn blank(design: &Design, piece: &FlatPiece) -> Result<Blank, DesignError> {
    let made = Builder::new(design, piece).and_then(Builder::build);
    made.map_err(|reason| DesignError::Blank {
        piece: piece.piece.name.clone(),
        reason,
    })
}

/// A blank while it is put together, patch by patch in the order of the pattern.
struct Builder<'d> {
    design: &'d Design,
    flat: &'d FlatPattern,
    /// The patches in the order of the pattern, which may be that of the file backwards, and their numbers there.
    patches: Vec<(usize, &'d Patch)>,
    /// The inside radii of the joints in the order of the file.
    radii: &'d [Option<f64>],
    blank: Blank,
    /// What is drawn to the left and to the right of one who follows the chain.
    sides: [Vec<Segment>; 2],
    shift: [f64; 2],
    /// The bend at the joint before, and where its strip starts on both sides.
    open: Option<(FoldBend, [[f64; 2]; 2])>,
}

impl<'d> Builder<'d> {
    fn new(design: &'d Design, FlatPiece { piece, flat }: &'d FlatPiece) -> Result<Self, String> {
        let patches = piece.patches.iter().enumerate();
        let mut patches: Vec<(usize, usize, &Patch)> = patches
            .filter_map(|(number, index)| {
                let patch = design.patches.get(*index)?;
                Some((position(flat, patch)?, number, patch))
            })
            .collect();
        patches.sort_by_key(|(place, _, _)| *place);
        if patches
            .iter()
            .map(|(place, _, _)| *place)
            .ne(0..flat.pieces())
        {
            return Err("its patches are not told apart on the pattern".to_owned());
        }
        let chain = design.chains.iter().find(|chain| chain.name == piece.name);
        Ok(Self {
            design,
            flat,
            patches: patches
                .into_iter()
                .map(|(_, number, patch)| (number, patch))
                .collect(),
            radii: chain.map_or(&[], |chain| &chain.radii),
            blank: Blank {
                outline: Vec::new(),
                bends: Vec::new(),
                sharp: Vec::new(),
                rolled: Vec::new(),
                error: flat.errors().outline,
                zones: Vec::new(),
            },
            sides: [Vec::new(), Vec::new()],
            shift: [0.0; 2],
            open: None,
        })
    }

    fn build(mut self) -> Result<Blank, String> {
        for place in 0..self.patches.len() {
            self.patch(place)?;
        }
        self.check_surface()?;
        self.blank.outline = if self.blank.bends.is_empty() {
            self.flat.outline().segments().to_vec()
        } else {
            closed(&self.sides)?
        };
        Ok(self.blank)
    }

    /// Adds a patch of the pattern, and begins the bend at the joint behind it.
    fn patch(&mut self, place: usize) -> Result<(), String> {
        let (Some((number, patch)), Some(mut sides)) =
            (self.patches.get(place).copied(), self.flat.sides(place))
        else {
            return Err("a patch is not on its pattern".to_owned());
        };
        let mut zone = PatchMotion {
            shift: self.shift,
            stretch: None,
            taken: Vec::new(),
        };
        let opened = self.open.take();
        let whole = sides.clone();
        let before = opened.as_ref().map(|(bend, _)| bend.taken_behind());
        if let Some(before) = &before {
            for side in &mut sides {
                before.check(&patch.name, side, 0.0)?;
                *side = strip::behind(side, &before.side.turned())?;
            }
            let strip = opened.as_ref();
            zone.taken
                .extend(strip.map(|(bend, _)| TakenStrip::new(before.side, bend)));
        }
        let radii = radii(patch, self.flat, place);
        let mut bent = None;
        if patch.bend {
            let bend = patch_bend(self.design, patch, self.flat, place)?;
            zone.stretch = Some(Stretch {
                from: bend.start,
                factor: bend.factor,
            });
            self.shift = bend
                .start
                .along(self.shift, (bend.factor - 1.0) * bend.width);
            bent = Some((bend.tool, bend.start.moved(0.5 * bend.width)));
        } else if radii[0].is_finite() {
            self.blank.rolled.push(rolled(patch, radii)?);
        }
        let fold = self.fold(place, number, patch, &zone)?;
        if let Some(fold) = &fold {
            let other = before.map_or(0.0, |before| before.setback);
            let taken = fold.taken_before();
            for (side, whole) in sides.iter_mut().zip(&whole) {
                taken.check(&patch.name, whole, other)?;
                *side = strip::before(side, &fold.start)?;
            }
            zone.taken.push(TakenStrip::new(fold.start, fold));
        }
        if let Some((mut tool, middle)) = bent {
            let [left, right] = [
                strip::crossing(&sides[0], &middle)?,
                strip::crossing(&sides[1], &middle)?,
            ];
            tool.line = [zone.point(left), zone.point(right)];
            self.blank.bends.push(tool);
        }
        let chord = 0.05 * self.design.tolerances.outline;
        let [first, _] = self.flat.end_rulings(place).unwrap_or_default();
        let mut starts = first.map(|end| zone.point(end));
        for ((chain, side), start) in self.sides.iter_mut().zip(&sides).zip(&mut starts) {
            if let Some(first) = side.first() {
                *start = zone.point(first.from);
            }
            let gap = chain.last().map(|last| Segment::line(last.to, *start));
            chain.extend(gap.filter(|_| opened.is_some()));
            for segment in side {
                self.blank.error = self
                    .blank
                    .error
                    .max(zone.add(segment, chord, chain) + self.flat.errors().outline);
            }
        }
        if let Some((FoldBend { mut tool, .. }, ends)) = opened {
            tool.line = [0, 1].map(|i| middle(ends[i], starts[i]));
            self.blank.bends.push(tool);
        }
        if let Some(fold) = fold {
            self.shift = fold.start.along(self.shift, fold.tool.growth);
            let ends = [0, 1].map(|i| self.sides[i].last().map_or([0.0; 2], |last| last.to));
            self.open = Some((fold, ends));
        }
        self.blank.zones.push(zone);
        Ok(())
    }

    /// Returns the bend at the joint behind a patch, if there is an edge with a radius; an edge without one is noted.
    fn fold(
        &mut self,
        place: usize,
        number: usize,
        patch: &Patch,
        zone: &PatchMotion,
    ) -> Result<Option<FoldBend>, String> {
        let Some((next_number, next)) = self.patches.get(place + 1).copied() else {
            return Ok(None);
        };
        let Some(joint) = RulingJoint::at(self.flat, place) else {
            return Ok(None);
        };
        if joint.angle.abs() <= self.design.tolerances.kink.to_radians() {
            return Ok(None);
        }
        let name = format!("{}-{}", patch.name, next.name);
        let beside = number.abs_diff(next_number) == 1;
        let radius = self.radii.get(number.min(next_number)).filter(|_| beside);
        let Some(radius) = radius.copied().flatten() else {
            self.blank.sharp.push(SharpFold {
                name,
                line: joint.ends.map(|end| zone.point(end)),
                angle: joint.angle,
            });
            return Ok(None);
        };
        let pair = [(patch, place), (next, place + 1)];
        let is_curved =
            |(patch, place): (&Patch, usize)| radii(patch, self.flat, place)[0].is_finite();
        if pair.into_iter().any(is_curved) {
            return Err(format!(
                "{name} is no edge between two flat patches, as a `radius` wants"
            ));
        }
        joint_bend(self.design, name, &joint, radius).map(Some)
    }

    /// Refuses bends that do not all have the designed face on the same side, and rolled patches whose designed surface
    /// is not the middle.
    fn check_surface(&self) -> Result<(), String> {
        let surface = self.design.bending.surface;
        if surface == DesignedSurface::Middle || self.design.metal.is_none() {
            return Ok(());
        }
        if let Some(rolled) = self.blank.rolled.first() {
            return Err(format!(
                "`{}` is rolled, and the blank of what is rolled is the development of the middle of the sheet: design \
                 that, or say `bend = true` of an arc of a circular cylinder",
                rolled.name
            ));
        }
        let up = |bend: &ToolBend| bend.angle > 0.0;
        let first = self.blank.bends.first().is_some_and(up);
        match self.blank.bends.iter().find(|bend| up(bend) != first) {
            None => Ok(()),
            Some(other) => Err(format!(
                "`{}` bends the other way, and one face of the sheet cannot be inside of both: design the middle",
                other.name
            )),
        }
    }
}

fn middle(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])]
}
