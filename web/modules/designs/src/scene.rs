//! The design in space as a page draws it: facets and lines, of the sheet as it is bent.

use crate::pattern::{CHORD, DrawnPattern, drawn};
use crate::points::{DraggablePoint, draggable};
use crate::source::Held;
use serde::Serialize;
use torse::designs::unroll::FlatPiece;
use torse::exchange::{Drawing, Layer, Mesh};
use torse::geometry::Coordinate;
use torse::geometry::pattern::{BentSheet, FlatRuling, PatternError};
use torse::geometry::vector::{cross, norm, sub};
use torse::{Design, Error, Pattern};
use torse_web_border::{Answer, Refused};

type Point = [f64; 3];

/// What is shown. The body has the vertices of the triangles, each of seven 32-bit floats (place, normal, curvature), then
/// the ends of the lines, each of three.
#[derive(Serialize)]
struct Scene {
    title: String,
    /// The names of its patches and surfaces.
    names: Vec<String>,
    /// The view that the file asks for: azimuth and elevation in degrees.
    view: Option<[f64; 2]>,
    /// Where the sheet is bent, the smallest radius; none where it is flat, or where there is no pattern.
    radius: Option<f64>,
    triangles: Vec<Group>,
    lines: Vec<Group>,
    /// Millimetres of the unit of the text.
    unit: f64,
    /// The thickness of the sheet in millimetres, if it has one.
    thickness: Option<f64>,
    /// What can be dragged.
    points: Vec<DraggablePoint>,
    /// The pattern, if it was asked for and there is one.
    pattern: Option<DrawnPattern>,
    /// Why there is no pattern.
    refused: Option<Refused>,
}

/// So many vertices that belong together.
#[derive(Serialize)]
struct Group {
    /// Of triangles the piece that they belong to, of lines `outline`, `ruling`, `joint`, `regression` or `mark`.
    name: String,
    count: usize,
}

/// The vertices of a scene in the making.
#[derive(Default)]
struct Vertices {
    triangles: Vec<f32>,
    lines: Vec<f32>,
    triangle_groups: Vec<Group>,
    line_groups: Vec<Group>,
}

/// Facets that meet at a larger angle than this one show an edge, in radians.
const CREASE: f64 = 0.3;
/// Steps of a patch that is not unrolled, and of a surface, each way.
const STEPS: usize = 48;
/// The same of a surface of several parts.
const FEW_STEPS: usize = 16;
/// How far from the sheet the edge of regression is shown, as a share of the length of the ruling.
const REACH: f64 = 1.0;

/// Shows the design: the sheet bent by a share of all bends where it has a pattern, as it is designed otherwise.
pub fn show(held: &mut Held, share: f64, with_pattern: bool) -> Answer {
    let every = held.every();
    let mut vertices = Vertices::default();
    let (mut drawn_pattern, mut refused, mut radius) = (None, None, None);
    match held.pattern() {
        Ok(pattern) => {
            match bent_pieces(&mut vertices, pattern, every, share) {
                Ok(smallest) => radius = Some(smallest).filter(|radius| radius.is_finite()),
                Err(error) => return Answer::error(&Error::from(error)),
            }
            if with_pattern {
                drawn_pattern = Some(drawn(pattern, every));
            }
        }
        Err(error) => {
            refused = Some(Refused::new(error));
            designed_patches(&mut vertices, &held.design);
        }
    }
    surfaces(&mut vertices, &held.design);
    let design = &held.design;
    let parts = design.parts();
    let scene = Scene {
        title: design.title().to_owned(),
        names: design.names(),
        view: design.parts().view.angles,
        radius,
        triangles: vertices.triangle_groups,
        lines: vertices.line_groups,
        unit: parts.unit.millimetres().approximate(),
        thickness: parts.metal.map(|metal| metal.sheet.thickness()),
        points: draggable(design, held.text()),
        pattern: drawn_pattern,
        refused,
    };
    let numbers = vertices.triangles.iter().chain(&vertices.lines);
    Answer::with_body(&scene, numbers.flat_map(|n| n.to_le_bytes()).collect())
}

/// The pieces of a pattern, bent; returns the smallest radius of the state.
fn bent_pieces(
    vertices: &mut Vertices,
    pattern: &Pattern,
    every: usize,
    share: f64,
) -> Result<f64, PatternError> {
    let mut smallest = f64::INFINITY;
    for FlatPiece { piece, flat } in pattern.pieces() {
        let bent = flat.bent(share)?;
        let curvatures: Vec<[f64; 2]> = flat
            .rulings()
            .iter()
            .map(|ruling| curvatures(ruling).map(|k| k * share.abs()))
            .collect();
        smallest = smallest.min(flat.smallest_radius() / share.abs());
        let strip = Strip {
            rulings: bent.rulings(),
            normals: bent.normals(),
            curvatures,
        };
        vertices.strip(&piece.name, &strip);
        let shown = |k: usize, _: &FlatRuling| k % every == 0;
        let rulings: Vec<[Point; 2]> = choose(flat.rulings(), &strip.rulings, shown);
        vertices.segments("ruling", &rulings);
        let last_of_patch = |k: usize, ruling: &FlatRuling| {
            let next = flat.rulings().get(k + 1);
            next.is_some_and(|next| next.piece != ruling.piece)
        };
        let joints = choose(flat.rulings(), &strip.rulings, last_of_patch);
        vertices.segments("joint", &joints);
        vertices.chains("regression", &regression(flat.rulings(), &bent));
        vertices.chains("mark", &marks(pattern.drawing(), &bent));
    }
    Ok(smallest)
}

fn choose(
    rulings: &[FlatRuling],
    ends: &[[Point; 2]],
    shown: impl Fn(usize, &FlatRuling) -> bool,
) -> Vec<[Point; 2]> {
    let each = rulings.iter().enumerate().zip(ends);
    let chosen = each.filter(|((k, ruling), _)| shown(*k, ruling));
    chosen.map(|(_, ends)| *ends).collect()
}

/// The share of a ruling's line at which it meets the edge of regression.
fn regression_share(ruling: &FlatRuling) -> Option<f64> {
    let [p, q] = ruling.ends;
    let point = ruling.regression?;
    let [along, away] = [
        [q[0] - p[0], q[1] - p[1]],
        [point[0] - p[0], point[1] - p[1]],
    ];
    let square = along[0] * along[0] + along[1] * along[1];
    Some((along[0] * away[0] + along[1] * away[1]) / square).filter(|share| share.is_finite())
}

/// The normal curvature across the ruling at its ends: it falls with the distance from the edge of regression, and the
/// radius of the ruling is that of the nearer end.
fn curvatures(ruling: &FlatRuling) -> [f64; 2] {
    let most = 1.0 / ruling.radius;
    let Some(share) = regression_share(ruling) else {
        return [most; 2];
    };
    let apart = [share.abs(), (1.0 - share).abs()];
    let nearest = apart[0].min(apart[1]);
    apart.map(|apart| most * nearest / apart.max(f64::MIN_POSITIVE))
}

/// The edge of regression near the sheet.
fn regression(rulings: &[FlatRuling], bent: &BentSheet) -> Vec<Vec<Point>> {
    let mut chains = vec![vec![]];
    let mut piece = 0;
    for (number, ruling) in rulings.iter().enumerate() {
        let share = regression_share(ruling).filter(|share| (-REACH..=1.0 + REACH).contains(share));
        if share.is_none() || ruling.piece != piece {
            chains.push(vec![]);
        }
        piece = ruling.piece;
        let point = share.and_then(|share| bent.on_ruling(number, share));
        if let (Some(point), Some(chain)) = (point, chains.last_mut()) {
            chain.push(point);
        }
    }
    chains
}

/// Lines and holes of the drawing that lie on this sheet.
fn marks(drawing: &Drawing, bent: &BentSheet) -> Vec<Vec<Point>> {
    let holes = drawing.paths().iter().filter(|path| {
        // The outline of a piece runs along the edges of facets; holes lie within.
        path.layer() == Layer::Marks || path.layer() == Layer::Outline && path.vertices().len() == 2
    });
    holes
        .map(|path| {
            let mut points = path.polygon(CHORD);
            if path.is_closed() {
                points.extend(points.first().copied());
            }
            points
                .iter()
                .filter_map(|point| bent.point(*point))
                .collect()
        })
        .collect()
}

/// The patches of a design that has no pattern, as they are designed.
fn designed_patches(vertices: &mut Vertices, design: &Design) {
    for patch in &design.parts().patches {
        #[expect(clippy::cast_precision_loss, reason = "a few steps")]
        let share = |k: usize| k as f64 / STEPS as f64;
        let rulings: Vec<[Point; 2]> = (0..=STEPS)
            .filter_map(|k| patch.sheet.ruling(share(k)).ok())
            .collect();
        let normals = rulings.windows(2).map(|pair| match pair {
            [[a, b], [c, d]] => unit(&cross(&sub(d, a), &sub(b, c))),
            _ => [0.0; 3],
        });
        let strip = Strip {
            normals: normals.collect(),
            curvatures: vec![[0.0; 2]; rulings.len()],
            rulings,
        };
        vertices.strip(&patch.name, &strip);
        let shown: Vec<[Point; 2]> = strip.rulings.iter().step_by(4).copied().collect();
        vertices.segments("ruling", &shown);
    }
}

/// The surfaces that are not unrolled.
fn surfaces(vertices: &mut Vertices, design: &Design) {
    for surface in &design.parts().surfaces {
        let start = vertices.triangles.len();
        let steps = match surface.parts.len() {
            0..4 => STEPS,
            _ => FEW_STEPS,
        };
        for part in &surface.parts {
            let Ok(mesh) = Mesh::sample(part, steps, steps) else {
                continue;
            };
            for index in mesh.triangles().as_flattened() {
                let at = usize::try_from(*index).unwrap_or(usize::MAX);
                if let (Some(point), Some(normal)) =
                    (mesh.vertices().get(at), mesh.normals().get(at))
                {
                    vertices.vertex(point, normal, 0.0);
                }
            }
        }
        vertices.close_triangles(&surface.name, start);
    }
}

/// A strip of facets between rulings.
struct Strip {
    rulings: Vec<[Point; 2]>,
    /// One for each facet.
    normals: Vec<Point>,
    /// At both ends of each ruling.
    curvatures: Vec<[f64; 2]>,
}

impl Strip {
    /// The normal of a facet at its ruling before or after it: between its own and that of the neighbour there, unless
    /// there is an edge.
    fn normal(&self, facet: usize, ruling: usize) -> Point {
        let own = self.normals.get(facet).copied().unwrap_or_default();
        let other = if ruling > facet {
            facet.checked_add(1)
        } else {
            facet.checked_sub(1)
        };
        let other = other.and_then(|other| self.normals.get(other));
        match other {
            Some(other) if norm(&cross(&own, other)) < CREASE => {
                unit(&[0, 1, 2].map(|k| own[k] + other[k]))
            }
            _ => own,
        }
    }
}

impl Vertices {
    fn strip(&mut self, name: &str, strip: &Strip) {
        let start = self.triangles.len();
        let pairs = strip.rulings.windows(2).zip(strip.curvatures.windows(2));
        for (facet, (rulings, curvatures)) in pairs.enumerate() {
            // Two triangles on the four ends.
            for (ruling, end) in [(0, 0), (0, 1), (1, 1), (0, 0), (1, 1), (1, 0)] {
                let normal = strip.normal(facet, facet + ruling);
                self.vertex(&rulings[ruling][end], &normal, curvatures[ruling][end]);
            }
        }
        self.close_triangles(name, start);
        let edge = |end: usize| strip.rulings.iter().map(|ruling| ruling[end]).collect();
        let across = |ruling: Option<&[Point; 2]>| ruling.map(|r| r.to_vec()).unwrap_or_default();
        let around = [
            edge(0),
            edge(1),
            across(strip.rulings.first()),
            across(strip.rulings.last()),
        ];
        self.chains("outline", &around);
    }

    fn vertex(&mut self, point: &Point, normal: &Point, curvature: f64) {
        let numbers = point.iter().chain(normal).chain([&curvature]);
        self.triangles.extend(numbers.map(|n| single(*n)));
    }

    fn close_triangles(&mut self, name: &str, start: usize) {
        self.triangle_groups.push(Group {
            name: name.to_owned(),
            count: (self.triangles.len() - start) / 7,
        });
    }

    fn segments(&mut self, name: &str, segments: &[[Point; 2]]) {
        let numbers = segments.as_flattened().as_flattened();
        self.lines.extend(numbers.iter().map(|n| single(*n)));
        self.line_groups.push(Group {
            name: name.to_owned(),
            count: 2 * segments.len(),
        });
    }

    fn chains(&mut self, name: &str, chains: &[Vec<Point>]) {
        let segments: Vec<[Point; 2]> = chains
            .iter()
            .flat_map(|chain| chain.windows(2))
            .filter_map(|pair| pair.try_into().ok())
            .collect();
        self.segments(name, &segments);
    }
}

fn unit(vector: &Point) -> Point {
    let length = norm(vector);
    if length > 0.0 {
        vector.map(|c| c / length)
    } else {
        [0.0; 3]
    }
}

/// What a screen shows.
#[expect(clippy::cast_possible_truncation, reason = "pixels need no more")]
fn single(number: f64) -> f32 {
    number as f32
}
