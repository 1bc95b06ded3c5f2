//! Path data: parts of lines, Bezier curves and arcs, in the coordinates of the element.

use svgtypes::{PathParser, PathSegment};

/// A part of a path: it starts with a move.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Subpath {
    pub start: [f64; 2],
    pub segments: Vec<Segment>,
    pub closed: bool,
}

/// A segment to its end, the last point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Segment {
    Line([f64; 2]),
    Quadratic([[f64; 2]; 2]),
    Cubic([[f64; 2]; 3]),
    Arc {
        radii: [f64; 2],
        /// Degrees from the x axis to the first radius, towards y.
        turn: f64,
        large: bool,
        sweep: bool,
        to: [f64; 2],
    },
}

impl Segment {
    pub(crate) fn end(&self) -> [f64; 2] {
        match *self {
            Self::Line(to)
            | Self::Quadratic([_, to])
            | Self::Cubic([_, _, to])
            | Self::Arc { to, .. } => to,
        }
    }
}

/// The control point that the next smooth segment reflects.
#[derive(Clone, Copy)]
enum Handle {
    None,
    Quadratic([f64; 2]),
    Cubic([f64; 2]),
}

/// The parts of a path.
pub(crate) fn subpaths(data: &str) -> Result<Vec<Subpath>, String> {
    let mut parts: Vec<Subpath> = Vec::new();
    let (mut at, mut handle) = ([0.0; 2], Handle::None);
    for segment in PathParser::from(data) {
        let segment = segment.map_err(|error| format!("path data: {error}"))?;
        let from = if segment.is_abs() { [0.0; 2] } else { at };
        let point = |x: f64, y: f64| [from[0] + x, from[1] + y];
        let reflected = |by: [f64; 2]| [2.0 * at[0] - by[0], 2.0 * at[1] - by[1]];
        let mut next = Handle::None;
        let made = match segment {
            PathSegment::MoveTo { x, y, .. } => {
                at = point(x, y);
                parts.push(Subpath {
                    start: at,
                    segments: Vec::new(),
                    closed: false,
                });
                handle = Handle::None;
                continue;
            }
            PathSegment::ClosePath { .. } => {
                if let Some(part) = parts.last_mut() {
                    part.closed = true;
                    at = part.start;
                }
                handle = Handle::None;
                continue;
            }
            PathSegment::LineTo { x, y, .. } => Segment::Line(point(x, y)),
            PathSegment::HorizontalLineTo { x, .. } => Segment::Line([from[0] + x, at[1]]),
            PathSegment::VerticalLineTo { y, .. } => Segment::Line([at[0], from[1] + y]),
            PathSegment::CurveTo {
                x1,
                y1,
                x2,
                y2,
                x,
                y,
                ..
            } => {
                next = Handle::Cubic(point(x2, y2));
                Segment::Cubic([point(x1, y1), point(x2, y2), point(x, y)])
            }
            PathSegment::SmoothCurveTo { x2, y2, x, y, .. } => {
                let first = match handle {
                    Handle::Cubic(by) => reflected(by),
                    _ => at,
                };
                next = Handle::Cubic(point(x2, y2));
                Segment::Cubic([first, point(x2, y2), point(x, y)])
            }
            PathSegment::Quadratic { x1, y1, x, y, .. } => {
                next = Handle::Quadratic(point(x1, y1));
                Segment::Quadratic([point(x1, y1), point(x, y)])
            }
            PathSegment::SmoothQuadratic { x, y, .. } => {
                let middle = match handle {
                    Handle::Quadratic(by) => reflected(by),
                    _ => at,
                };
                next = Handle::Quadratic(middle);
                Segment::Quadratic([middle, point(x, y)])
            }
            PathSegment::EllipticalArc {
                rx,
                ry,
                x_axis_rotation,
                large_arc,
                sweep,
                x,
                y,
                ..
            } => Segment::Arc {
                radii: [rx.abs(), ry.abs()],
                turn: x_axis_rotation,
                large: large_arc,
                sweep,
                to: point(x, y),
            },
        };
        // After a closing comes, without a move, another part from the same start.
        if parts.last().is_none_or(|part| part.closed) {
            parts.push(Subpath {
                start: at,
                segments: Vec::new(),
                closed: false,
            });
        }
        at = made.end();
        if at.iter().any(|c| !c.is_finite()) {
            return Err("path data: a number that is not finite".to_owned());
        }
        if let Some(part) = parts.last_mut() {
            part.segments.push(made);
        }
        handle = next;
    }
    Ok(parts)
}

/// An elliptic arc about its centre: `centre + cos(q) first + sin(q) second` for q in quarter turns from `from` to `to`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CentredArc {
    pub centre: [f64; 2],
    pub axes: [[f64; 2]; 2],
    pub range: [f64; 2],
}

/// The arc between two points that SVG describes by radii, turn and two flags (its appendix on elliptic arcs); nothing
/// where that is a straight line, or no line at all.
pub(crate) fn centred(
    from: [f64; 2],
    to: [f64; 2],
    radii: [f64; 2],
    turn: f64,
    large: bool,
    sweep: bool,
) -> Option<CentredArc> {
    let [mut a, mut b] = radii;
    if a == 0.0 || b == 0.0 || from == to {
        return None;
    }
    let angle = turn.rem_euclid(360.0).to_radians();
    let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
    let half = [0.5 * (from[0] - to[0]), 0.5 * (from[1] - to[1])];
    // In the axes of the ellipse.
    let (x, y) = (
        cosine * half[0] + sine * half[1],
        cosine * half[1] - sine * half[0],
    );
    let size = (x / a) * (x / a) + (y / b) * (y / b);
    if size > 1.0 {
        // Radii that are too small for the chord grow until they fit.
        let grow = size.sqrt();
        (a, b) = (a * grow, b * grow);
    }
    let size = size.min(1.0);
    let away = ((1.0 - size) / size).sqrt() * if large == sweep { -1.0 } else { 1.0 };
    let (cx, cy) = (away * a * y / b, -away * b * x / a);
    let middle = [0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])];
    let centre = [
        middle[0] + cosine * cx - sine * cy,
        middle[1] + sine * cx + cosine * cy,
    ];
    let quarter = |x: f64, y: f64| libm::atan2(y / b, x / a) * std::f64::consts::FRAC_2_PI;
    let (start, mut end) = (quarter(x - cx, y - cy), quarter(-x - cx, -y - cy));
    if sweep && end < start {
        end += 4.0;
    } else if !sweep && end > start {
        end -= 4.0;
    }
    let arc = CentredArc {
        centre,
        axes: [[a * cosine, a * sine], [-b * sine, b * cosine]],
        range: [start, end],
    };
    let mut numbers = arc
        .centre
        .iter()
        .chain(arc.axes.iter().flatten())
        .chain(&arc.range);
    numbers.all(|c| c.is_finite()).then_some(arc)
}
