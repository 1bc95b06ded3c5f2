//! Cutting chains of lines and arcs at straight lines.

use torse_geometry::pattern::Segment;

/// Heights that count as none, as a share of the size of what is cut.
const SAME: f64 = 1e-12;

/// What is said of a chain that is wholly behind a line.
const SHORT: &str = "a flange is shorter than the setback of its bend";

/// A bend at an end of a patch: its edge, and how far from it the patch is cut.
#[derive(Debug, Clone)]
pub(super) struct Taken {
    /// The two patches that meet there.
    pub edge: String,
    /// The line at which the patch is cut, and the side of it that the bend takes.
    pub side: Side,
    pub setback: f64,
}

impl Taken {
    /// Refuses a patch whose chain along a rail is no longer than what its bends take, in numbers.
    pub(super) fn check(&self, patch: &str, chain: &[Segment], other: f64) -> Result<(), String> {
        let ends = chain.iter().flat_map(|segment| [segment.from, segment.to]);
        let wide = ends
            .map(|point| self.setback - self.side.height(point))
            .fold(0.0_f64, f64::max);
        if wide > self.setback + other {
            return Ok(());
        }
        let (edge, setback) = (&self.edge, self.setback);
        if wide <= SAME * setback {
            return Err(format!(
                "`{patch}` comes to a point at an end of the edge {edge}, where bends meet: a radius is impossible there; \
                 without `radius` the edges stay scored"
            ));
        }
        let more = if other > 0.0 {
            format!(" beside the {other:.4} mm of its other bend")
        } else {
            String::new()
        };
        Err(format!(
            "{SHORT}: `{patch}` is {wide:.4} mm wide at an end of the edge {edge}, and the setback is {setback:.4} mm{more}"
        ))
    }
}

/// A side of a straight line: where its normal points to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Side {
    pub point: [f64; 2],
    /// Of length one.
    pub normal: [f64; 2],
}

impl Side {
    /// Returns the side ahead of one who comes to a line with its first end on his left.
    pub(super) fn ahead([left, right]: [[f64; 2]; 2]) -> Option<Self> {
        let [x, y] = [right[0] - left[0], right[1] - left[1]];
        let length = libm::hypot(x, y);
        (length > 0.0).then(|| Self {
            point: left,
            normal: [-y / length, x / length],
        })
    }

    /// Returns how far a point is on this side.
    pub(super) fn height(&self, point: [f64; 2]) -> f64 {
        (point[0] - self.point[0]) * self.normal[0] + (point[1] - self.point[1]) * self.normal[1]
    }

    /// Returns the point, moved along the normal.
    pub(super) fn along(&self, point: [f64; 2], by: f64) -> [f64; 2] {
        [0, 1].map(|i| point[i] + by * self.normal[i])
    }

    /// Returns the line moved along the normal.
    pub(super) fn moved(&self, by: f64) -> Self {
        Self {
            point: self.along(self.point, by),
            ..*self
        }
    }

    /// Returns the other side.
    pub(super) fn turned(&self) -> Self {
        Self {
            normal: self.normal.map(|c| -c),
            ..*self
        }
    }
}

/// Returns the share of a segment at which it comes to a line, its start being before it and its end not.
fn share(segment: &Segment, side: &Side) -> f64 {
    let (mut low, mut high) = (0.0_f64, 1.0_f64);
    if segment.is_line() {
        let (from, to) = (side.height(segment.from), side.height(segment.to));
        return (from / (from - to)).clamp(0.0, 1.0);
    }
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if side.height(segment.point(middle)) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}

/// Returns the chain up to where it comes to a line for the last time.
///
/// # Errors
/// For a chain that is wholly behind the line, or comes to it more than once.
pub(super) fn before(chain: &[Segment], side: &Side) -> Result<Vec<Segment>, String> {
    let size = chain.iter().map(Segment::length).sum::<f64>();
    let small = SAME * size;
    let is_before = |segment: &Segment| side.height(segment.from) < -small;
    let Some(last) = chain.iter().rposition(is_before) else {
        return Err(SHORT.to_owned());
    };
    let mut kept = chain.get(..last).unwrap_or_default().to_vec();
    let inside = |segment: &Segment| {
        (0..=8).all(|k| side.height(segment.point(f64::from(k) / 8.0)) <= small)
    };
    if !kept.iter().all(inside) {
        return Err("an edge runs into its bend and out again".to_owned());
    }
    if let Some(segment) = chain.get(last) {
        let end = if side.height(segment.to) > small {
            share(segment, side)
        } else {
            1.0
        };
        kept.push(segment.part(0.0, end));
    }
    Ok(kept)
}

/// Returns the chain from where it leaves a line for the first time.
///
/// # Errors
/// As [`before`].
pub(super) fn behind(chain: &[Segment], side: &Side) -> Result<Vec<Segment>, String> {
    let back = before(&reversed(chain), &side.turned())?;
    Ok(reversed(&back))
}

fn reversed(chain: &[Segment]) -> Vec<Segment> {
    chain.iter().rev().map(Segment::reversed).collect()
}

/// Returns where a chain crosses a line.
pub(super) fn crossing(chain: &[Segment], side: &Side) -> Result<[f64; 2], String> {
    let back = before(chain, side)?;
    back.last()
        .map(|last| last.to)
        .ok_or_else(|| "a rail of a bend is a point".to_owned())
}

/// Returns the outline between both sides of a chain, counterclockwise.
pub(super) fn closed([left, right]: &[Vec<Segment>; 2]) -> Result<Vec<Segment>, String> {
    let mut outline = right.clone();
    let back = reversed(left);
    let ends = |chain: &[Segment]| Some((chain.first()?.from, chain.last()?.to));
    let (Some((start, end)), Some((from, to))) = (ends(right), ends(&back)) else {
        return Err("a rail of a patch that is bent is a point".to_owned());
    };
    outline.push(Segment::line(end, from));
    outline.extend(back);
    outline.push(Segment::line(to, start));
    outline.retain(|segment| segment.from != segment.to);
    // Neighbours share their ends: what differs by rounding is one point.
    let count = outline.len();
    for index in 0..count {
        let next = outline.get((index + 1) % count).map(|segment| segment.from);
        if let (Some(segment), Some(next)) = (outline.get_mut(index), next) {
            segment.to = next;
        }
    }
    Ok(outline)
}
