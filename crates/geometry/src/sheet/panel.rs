//! Whole panels between two rails: developable pieces from the start of both to the end of both.

use super::pieces::{Pieces, corner};
use super::plane_triangles::plane_triangles;
use super::tipped::tipped_sheet;
use super::{PiecewiseRail, Point, Rail, Sheet, SweptEdge};
use crate::developable::{
    Connections, Landscape, NODE_RADIUS, Node, ParameterBox, Step, StepKind, Way, all_branches,
    may_exist, ways,
};
use crate::error::{GeometryError, Place, Result, count};
use crate::vector::{cross, dot, norm, sub};

/// The most squares, pairs of pieces of both rails, that are surveyed.
pub const MAX_PANEL_SQUARES: usize = 1024;

/// What [`Sheet::panels`] found.
#[derive(Debug, Clone, PartialEq)]
pub enum Panels {
    /// Whole panels, the best first: fewest folds, then least share of the rails in fans, then fewest pieces.
    Found(Vec<Panel>),
    /// There is none, proved: no path reaches the ends of the rails, even through all undecided cells.
    None {
        /// The parameter ranges of all developables between the rails, as `[[s0, s1], [t0, t1]]`.
        ways: Vec<[[f64; 2]; 2]>,
    },
    /// None was found, but these cells of both parameters were not decided.
    Undecided {
        /// The cells, on the parameters of the rails.
        cells: Vec<ParameterBox>,
    },
}

/// A row of developable pieces from the start of both rails to the end of both.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// The pieces in order, each smoothly joined to the next where there are no folds.
    pub pieces: Vec<PanelPiece>,
    /// Whether the second rail is passed from its end to its start. Parameters of the pieces are those of the rail as
    /// it was given, so that they fall then.
    pub turned: bool,
    /// Whether the last piece ends where the first begins.
    pub closed: bool,
    /// The corners of a rail inside of fans.
    pub folds: usize,
    /// The share of both rails that is met by fans.
    pub fans: f64,
}

/// A piece of a panel.
#[derive(Debug, Clone, PartialEq)]
pub struct PanelPiece {
    /// What it is.
    pub kind: PanelKind,
    /// The parameters of the first and the second rail where it begins and where it ends.
    pub ranges: [[f64; 2]; 2],
    /// The surface.
    pub sheet: Sheet,
}

/// What a piece of a panel is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PanelKind {
    /// A developable that touches both rails.
    Arc,
    /// A cone from a point of this rail, 1 or 2, over a part of the other.
    Fan(usize),
}

/// If fans meet more than this share of the rails, panels with the second rail reversed are tried too.
const MAX_FANS: f64 = 0.3;
/// Rounds of the search for single rulings: each starts from the rulings of the round before.
const SINGLE_ROUNDS: usize = 2;
/// The most single rulings.
const MAX_SINGLES: usize = 128;
/// Rulings of a fan at which its normal is looked at.
const FAN_SAMPLES: u32 = 32;

/// The rails and all developables between their pieces.
struct PanelRails {
    rails: [Pieces; 2],
    /// For each square, row by row: the square and what was found in it.
    squares: Vec<([usize; 2], Connections<Rail, Rail>)>,
    /// The regular branches: square and number.
    regular: Vec<(usize, usize)>,
    /// Their nodes, behind them single rulings in which two fans meet, and behind these the ends of plane triangles.
    arcs: Vec<Vec<Node>>,
    /// The rails that stand still in the plane triangles.
    triangles: Vec<usize>,
}

/// Rulings of their own in which two fans meet smoothly: solutions on the borders of the squares, where the rail has no
/// corner, and those across from the ends of arcs and from one another.
fn single_rulings(
    rails: &[Pieces; 2],
    squares: &[([usize; 2], Connections<Rail, Rail>)],
    arcs: &[Vec<Node>],
) -> Vec<Node> {
    let near = |a: &Node, b: &Node| (0..2).all(|k| (a[k] - b[k]).abs() <= 1e-8);
    // On arcs, fans meet the arc.
    let ends = || arcs.iter().flat_map(|nodes| [nodes.first(), nodes.last()]);
    let on_arc = |found: &Connections<Rail, Rail>, curve: usize, node: &Node| {
        (0..found.branches().len())
            .filter(|number| found.is_regular(*number))
            .filter_map(|number| found.on_branch(number, curve, node[curve]))
            .any(|place| near(&place, node))
    };
    let mut singles: Vec<Node> = Vec::new();
    for (square, found) in squares {
        let [i, j] = corner(*square);
        // At a corner of a rail its tangent has two directions: two fans meet smoothly where it has one.
        for (curve, border) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            if !rails[curve].is_corner(square[curve] + border) {
                let places = found.on_line(curve, [0.0, 1.0][border]);
                singles.extend(places.into_iter().map(|[s, t]| [s + i, t + j]));
            }
        }
    }
    let order = |a: &Node, b: &Node| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal);
    singles.retain(|place| !ends().flatten().any(|node| near(node, place)));
    singles.sort_by(order);
    singles.dedup_by(|a, b| near(a, b));
    let mut sources: Vec<Node> = ends().flatten().copied().chain(singles.clone()).collect();
    for _ in 0..SINGLE_ROUNDS {
        let mut next: Vec<Node> = Vec::new();
        for source in &sources {
            for curve in 0..2 {
                for (square, found) in squares {
                    let offset = corner(*square);
                    let value = source[curve] - offset[curve];
                    if !(1e-8..=1.0 - 1e-8).contains(&value) {
                        continue;
                    }
                    let mut places = found.on_line(curve, value);
                    places.retain(|place| !on_arc(found, curve, place));
                    next.extend(places.iter().map(|[s, t]| [s + offset[0], t + offset[1]]));
                }
            }
        }
        let all = singles.iter().chain(&sources).copied();
        let known: Vec<Node> = ends().flatten().copied().chain(all).collect();
        next.retain(|place| !known.iter().any(|node| near(node, place)));
        next.sort_by(order);
        next.dedup_by(|a, b| near(a, b));
        next.truncate(MAX_SINGLES.saturating_sub(singles.len()));
        singles.extend_from_slice(&next);
        sources = next;
    }
    singles
}

impl PanelRails {
    fn new(first: &PiecewiseRail, second: &PiecewiseRail) -> Result<Self> {
        let rails = [Pieces::new(first)?, Pieces::new(second)?];
        let pairs = rails[0].count().saturating_mul(rails[1].count());
        if pairs > MAX_PANEL_SQUARES {
            return Err(GeometryError::OutOfRange {
                name: "pairs of a piece of one curve and one of the other (curves through fewer points, or parts of them, have fewer)",
                value: count(pairs),
                range: "1, 2, .. 1024",
            });
        }
        let mut squares = Vec::with_capacity(pairs);
        for (i, one) in rails[0].rails.iter().enumerate() {
            for (j, two) in rails[1].rails.iter().enumerate() {
                squares.push(([i, j], all_branches(one, two)?));
            }
        }
        let mut regular = Vec::new();
        let mut arcs: Vec<Vec<Node>> = Vec::new();
        for (index, (square, found)) in squares.iter().enumerate() {
            let [i, j] = corner(*square);
            for (number, branch) in found.branches().iter().enumerate() {
                if found.is_regular(number) {
                    regular.push((index, number));
                    arcs.push(branch.nodes().iter().map(|[s, t]| [s + i, t + j]).collect());
                }
            }
        }
        let singles = single_rulings(&rails, &squares, &arcs);
        arcs.extend(singles.into_iter().map(|place| vec![place]));
        let triangles = plane_triangles(&rails, &squares);
        arcs.extend(triangles.iter().map(|(_, ends)| ends.to_vec()));
        let triangles = triangles.into_iter().map(|(still, _)| still).collect();
        Ok(Self {
            rails,
            squares,
            regular,
            arcs,
            triangles,
        })
    }

    /// Returns the boxes that hold all solutions through which a panel may pass.
    fn elements(&self) -> Result<Vec<ParameterBox>> {
        let mut all = Vec::new();
        for (square, found) in &self.squares {
            let mut cells: Vec<ParameterBox> = found.undecided().to_vec();
            cells.extend_from_slice(found.falling());
            // Link by link: the box of a whole branch would promise too much.
            for link in found.branches().iter().flat_map(|b| b.nodes().windows(2)) {
                if let [from, to] = link {
                    let reach = |k: usize| [from[k] - NODE_RADIUS, to[k] + NODE_RADIUS];
                    let (s, t) = (reach(0), reach(1));
                    cells.push(ParameterBox { s, t });
                }
            }
            let [i, j] = corner(*square);
            let cells = found.passable(cells)?.into_iter();
            all.extend(cells.map(|cell| ParameterBox {
                s: cell.s.map(|s| s + i),
                t: cell.t.map(|t| t + j),
            }));
        }
        Ok(all)
    }

    fn piece(&self, step: &Step) -> Result<Vec<PanelPiece>> {
        let none = || GeometryError::NoValue {
            what: "piece of a panel",
            at: Place::Whole,
        };
        let ranges = |from: Node, to: Node| {
            [0, 1].map(|i| [from, to].map(|node| self.rails[i].whole(node[i])))
        };
        match step.kind {
            StepKind::Arc(arc) => {
                let (square, branch) = *self.regular.get(arc).ok_or_else(none)?;
                let (at, found) = self.squares.get(square).ok_or_else(none)?;
                let patch = found.patch(branch).ok_or_else(none)?;
                let nodes = patch.branch().nodes();
                let sum = |node: Option<&Node>| node.map(|[s, t]| s + t).ok_or_else(none);
                let (first, last) = (sum(nodes.first())?, sum(nodes.last())?);
                // Of a closed rail the step may be turns away from the square.
                let start = self.arcs.get(arc).and_then(|nodes| nodes.first());
                let start = *start.ok_or_else(none)?;
                let [i, j] = corner(*at);
                let turns = [0, 1].map(|k| {
                    let turn = count(self.rails[k].count());
                    ((step.from[k] - start[k]) / turn + 1e-6).floor() * turn
                });
                let shift = i + j + turns[0] + turns[1];
                let share = |node: Node| {
                    let x = (node[0] + node[1] - shift - first) / (last - first);
                    let x = x.clamp(0.0, 1.0);
                    // An end is an end.
                    if x < 1e-9 {
                        0.0
                    } else if x > 1.0 - 1e-9 {
                        1.0
                    } else {
                        x
                    }
                };
                let (from, to) = (share(step.from), share(step.to));
                if to - from <= 1e-9 {
                    return Ok(Vec::new());
                }
                let whole = Sheet::from(super::Construction::Connecting(Box::new(patch)));
                let sheet = if [from, to] == [0.0, 1.0] {
                    whole
                } else {
                    whole.part(from, to)?
                };
                Ok(vec![PanelPiece {
                    kind: PanelKind::Arc,
                    ranges: ranges(step.from, step.to),
                    sheet,
                }])
            }
            StepKind::Fan(still) => {
                let apex = self.apex(still, step.from).ok_or_else(none)??;
                let moving = 1 - still;
                let mut pieces = Vec::new();
                for [from, to] in intervals(step.from[moving], step.to[moving]) {
                    let (rail, range) = self.rails[moving].on([from, to]).ok_or_else(none)?;
                    let (whole, nothing) = (SweptEdge::Share(1.0), SweptEdge::Share(0.0));
                    let edges = if still == 0 {
                        [nothing, whole]
                    } else {
                        [whole, nothing]
                    };
                    let cone = Sheet::cone(rail, apex, edges)?;
                    let sheet = if range == [0.0, 1.0] {
                        cone
                    } else {
                        cone.part(range[0], range[1])?
                    };
                    let place = |at: f64| {
                        let mut node = step.from;
                        node[moving] = at;
                        node
                    };
                    pieces.push(PanelPiece {
                        kind: PanelKind::Fan(still + 1),
                        ranges: ranges(place(from), place(to)),
                        sheet,
                    });
                }
                Ok(pieces)
            }
        }
    }

    /// Returns the point of a rail in which a fan meets.
    fn apex(&self, rail: usize, at: Node) -> Option<Result<Point>> {
        // At a break both pieces have it.
        let (piece, [x, _]) = self.rails[rail].on([at[rail]; 2])?;
        Some(piece.point(x))
    }

    fn panel(&self, way: &Way, turned: bool) -> Result<Panel> {
        let mut pieces = Vec::new();
        for step in &way.steps {
            pieces.extend(self.piece(step)?);
        }
        if turned {
            for piece in &mut pieces {
                piece.ranges[1] = piece.ranges[1].map(|t| 1.0 - t);
            }
        }
        let all = count(self.rails[0].count() + self.rails[1].count());
        Ok(Panel {
            pieces,
            turned,
            closed: self.is_closed(),
            folds: way.folds,
            fans: way.fans / all,
        })
    }
}

/// Returns the parts of an interval between whole numbers.
fn intervals(from: f64, to: f64) -> Vec<[f64; 2]> {
    const SLIVER: f64 = 1e-9;
    let mut list = Vec::new();
    let mut start = from;
    let mut next = from.floor() + 1.0;
    while next < to - SLIVER {
        if next - start > SLIVER {
            list.push([start, next]);
        }
        start = next;
        next += 1.0;
    }
    if to - start > SLIVER {
        list.push([start, to]);
    }
    list
}

impl Landscape for PanelRails {
    fn size(&self) -> [usize; 2] {
        self.rails.each_ref().map(Pieces::count)
    }

    fn is_closed(&self) -> bool {
        self.rails.iter().all(|rail| rail.closed)
    }

    fn arcs(&self) -> &[Vec<Node>] {
        &self.arcs
    }

    fn still(&self, arc: usize) -> Option<usize> {
        let first = self.arcs.len() - self.triangles.len();
        self.triangles.get(arc.checked_sub(first)?).copied()
    }

    fn on_arc(&self, arc: usize, rail: usize, value: f64) -> Option<Node> {
        if let Some(still) = self.still(arc) {
            let mut place = *self.arcs.get(arc)?.first()?;
            place[rail] = value;
            return (rail != still).then_some(place);
        }
        let (square, branch) = *self.regular.get(arc)?;
        let (at, found) = self.squares.get(square)?;
        let offset = corner(*at);
        let place = found.on_branch(branch, rail, value - offset[rail])?;
        Some([place[0] + offset[0], place[1] + offset[1]])
    }

    fn folds(&self, still: usize, from: Node, to: Node) -> Option<usize> {
        let moving = 1 - still;
        let apex = self.apex(still, from)?.ok()?;
        let mut last: Option<Point> = None;
        let mut folds = 0;
        let (low, high) = (from[moving], to[moving]);
        for [start, end] in intervals(low, high) {
            let (rail, [x0, x1]) = self.rails[moving].on([start, end])?;
            for k in 0..=FAN_SAMPLES {
                let x = x0 + (x1 - x0) * f64::from(k) / f64::from(FAN_SAMPLES);
                let ruling = sub(&rail.point(x).ok()?, &apex);
                let slope = rail.derivative(x).ok()?;
                let normal = cross(&slope, &ruling);
                let size = norm(&slope) * norm(&ruling);
                // A rail that stands still at its end, and the tip of a fan on its own rail.
                if size == 0.0 && (k == 0 || k == FAN_SAMPLES) {
                    continue;
                }
                if norm(&normal) <= 1e-9 * size {
                    return None;
                }
                // Through an edge of regression the normal turns over.
                if k > 0 && last.is_some_and(|last| dot(&last, &normal) <= 0.0) {
                    return None;
                }
                last = Some(normal);
            }
        }
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let range = (low - 1e-9).ceil() as usize..=(high + 1e-9).floor() as usize;
        let count = self.rails[moving].count();
        let inner = |at: &usize| self.is_closed() || (0 < *at && *at < count);
        folds += range
            .filter(inner)
            .filter(|at| self.rails[moving].is_corner(*at))
            .count();
        Some(folds)
    }
}

impl Sheet {
    /// Returns the whole panels between two rails: rows of developable pieces from the start of both to the end of
    /// both, with fans where no developable touches both. If there is none, or a better one, the second rail is passed
    /// the other way. Between closed rails the panels are closed. Rails that start or end in one point have the panel of
    /// rulings between equal parameters, where that is exactly a developable.
    ///
    /// What is not found is not always proved to be missing: [`Panels::None`] is, [`Panels::Undecided`] is not.
    ///
    /// # Errors
    /// [`GeometryError::OutOfRange`] beyond [`MAX_PANEL_SQUARES`] pairs of pieces, and as
    /// [`connect`](crate::developable::connect).
    ///
    /// ```
    /// use torse_geometry::prelude::*;
    /// let chine = Rail::bezier(&[[0.0, 0.0, 0.0], [2.0, 3.0, 0.0], [6.0, 0.0, 0.0]])?;
    /// let deck = Rail::bezier(&[[0.5, 0.0, 2.0], [3.0, 2.0, 3.0], [6.0, -1.0, 2.0]])?;
    /// let Panels::Found(panels) = Sheet::panels(&chine.into(), &deck.into())? else { return Ok(()) };
    /// let pieces = &panels[0].pieces;
    /// assert_eq!(pieces.last().map(|piece| [piece.ranges[0][1], piece.ranges[1][1]]), Some([1.0, 1.0]));
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn panels(first: &PiecewiseRail, second: &PiecewiseRail) -> Result<Panels> {
        if let Some(sheet) = tipped_sheet(first, second)? {
            let piece = PanelPiece {
                kind: PanelKind::Arc,
                ranges: [[0.0, 1.0]; 2],
                sheet,
            };
            return Ok(Panels::Found(vec![Panel {
                pieces: vec![piece],
                turned: false,
                closed: false,
                folds: 0,
                fans: 0.0,
            }]));
        }
        let along = PanelRails::new(first, second)?;
        let own = ways(&along);
        // The other direction is asked where this one has none, or one that is fans for the most part.
        let good = |way: &Way| {
            let all = count(along.size().iter().sum());
            way.folds == 0 && way.fans < MAX_FANS * all
        };
        let all = |landscape: &PanelRails, ways: &[Way], turned: bool| {
            let panels = ways.iter().map(|way| landscape.panel(way, turned));
            panels.collect::<Result<_>>().map(Panels::Found)
        };
        if own.first().is_some_and(good) {
            return all(&along, &own, false);
        }
        let against = PanelRails::new(first, &second.reversed()?)?;
        let other = ways(&against);
        match (own.first(), other.first()) {
            (Some(way), Some(turned)) if turned.cost() < way.cost() => {
                return all(&against, &other, true);
            }
            (None, Some(_)) => return all(&against, &other, true),
            (Some(_), _) => return all(&along, &own, false),
            (None, None) => {}
        }
        let possible = |landscape: &PanelRails| -> Result<bool> {
            Ok(landscape.is_closed() || may_exist(landscape.size(), &landscape.elements()?))
        };
        if !possible(&along)? && !possible(&against)? {
            let ranges = |nodes: &Vec<Node>| {
                let (first, last) = (nodes.first()?, nodes.last()?);
                (nodes.len() > 1).then_some(())?;
                Some([0, 1].map(|i| [first, last].map(|node| along.rails[i].whole(node[i]))))
            };
            return Ok(Panels::None {
                ways: along.arcs.iter().filter_map(ranges).collect(),
            });
        }
        let cells = along.squares.iter().flat_map(|(square, found)| {
            let [i, j] = corner(*square);
            let rails = &along.rails;
            found.undecided().iter().map(move |cell| ParameterBox {
                s: cell.s.map(|s| rails[0].whole(s + i)),
                t: cell.t.map(|t| rails[1].whole(t + j)),
            })
        });
        Ok(Panels::Undecided {
            cells: cells.collect(),
        })
    }
}
