//! Whole panels: ways through the square of both parameters that never go back.
//!
//! A developable between two rails `a(s)` and `b(t)` runs through rulings `(s, t)` from `(0, 0)` to `(m, n)`, where `m`
//! and `n` count the pieces of the rails. It consists of
//!
//! - **arcs**: parts of [branches](super::Branch), on which one plane touches both rails,
//! - **fans**: segments on which one parameter stands still: cones from a point of the one rail over a part of the
//!   other.
//!
//!   Over a straight piece of a rail a fan in which `F` vanishes is a plane triangle: it is passed like an arc.
//!
//! Two of these meet smoothly where `F(s, t) = 0`, so a fan may leave an arc anywhere and end on another anywhere,
//! while the first and the last ruling are free. Fans are taken where one of the two arcs ends: at a turn, at a corner
//! and at an end of a rail. The ways in that graph are compared by their folds (corners of a rail inside of a fan), by
//! the share of the rails in fans, and by the number of pieces; the best of that graph is the first of the list, and no
//! more is claimed.
//!
//! Between closed rails the square is a torus: wanted are ways from a ruling to itself, once around both rails.

use super::survey::ParameterBox;

/// A ruling, by its parameters on both rails, in pieces of them.
pub(crate) type Node = [f64; 2];

/// Rulings that are nearer to one another count as one: what is proved of a node is that it is as near to a solution.
pub(crate) const SAME_NODE: f64 = 2e-9;

/// The most ways that are kept of each place.
const MAX_WAYS: usize = 8;

/// The most fans that are looked at between arcs.
const MAX_FANS: usize = 200_000;

/// The most looks at a fan when ways are put together.
const MAX_LOOKS: usize = 4_000_000_000;

/// The most pairs of boxes that are looked at before a way counts as possible.
const MAX_PAIRS: usize = 200_000_000;

/// A part of a way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Step {
    pub kind: StepKind,
    pub from: Node,
    pub to: Node,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum StepKind {
    /// The arc of this number.
    Arc(usize),
    /// This rail stands still: 0 or 1.
    Fan(usize),
}

/// A way, with what it is judged by.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Way {
    pub steps: Vec<Step>,
    /// Corners of a rail inside of a fan.
    pub folds: usize,
    /// The length of all fans, in pieces of the rails.
    pub fans: f64,
}

impl Way {
    const END: Self = Self {
        steps: Vec::new(),
        folds: 0,
        fans: 0.0,
    };

    /// The way with a step before it. The parts of one arc are one.
    fn after(&self, step: Step, folds: usize) -> Self {
        let mut steps = vec![step];
        let mut rest = self.steps.as_slice();
        if let Some((next, others)) = rest.split_first()
            && next.kind == step.kind
        {
            steps[0].to = next.to;
            rest = others;
        }
        steps.extend_from_slice(rest);
        let length = (0..2).map(|i| step.to[i] - step.from[i]).sum::<f64>();
        let fan = matches!(step.kind, StepKind::Fan(_));
        Self {
            steps,
            folds: self.folds + folds,
            fans: self.fans + if fan { length } else { 0.0 },
        }
    }

    /// What ways are compared by: folds, fans, pieces.
    pub(crate) fn cost(&self) -> (usize, i64, usize) {
        // To nine digits, so that rounding does not decide.
        #[allow(clippy::cast_possible_truncation)]
        let fans = (self.fans * 1e9).round() as i64;
        (self.folds, fans, self.steps.len())
    }
}

/// What the search is told of the rails and of the solutions.
pub(crate) trait Landscape {
    /// How many pieces the rails have.
    fn size(&self) -> [usize; 2];

    /// Whether both rails end where they start.
    fn is_closed(&self) -> bool;

    /// The regular arcs: nodes that rise.
    fn arcs(&self) -> &[Vec<Node>];

    /// The rail that stands still on an arc that is a plane triangle; `None` of all others.
    fn still(&self, arc: usize) -> Option<usize>;

    /// The place on an arc where the parameter of this rail has this value between those of its ends.
    fn on_arc(&self, arc: usize, rail: usize, value: f64) -> Option<Node>;

    /// The folds of a fan in which this rail stands still; `None` where it is singular.
    fn folds(&self, rail: usize, from: Node, to: Node) -> Option<usize>;
}

/// A place on an arc that is moved by whole turns of both rails.
#[derive(Debug, Clone, Copy)]
struct Stop {
    arc: usize,
    at: Node,
}

/// The graph: for each arc its stops, sorted, and where fans lead from them.
struct Graph<'a, L> {
    landscape: &'a L,
    /// The arcs of the square, or of four copies of it: number and shift.
    arcs: Vec<(usize, Node)>,
    stops: Vec<Vec<Stop>>,
    /// From a stop to a stop by a fan in which this rail stands still, with its folds.
    fans: Vec<Fan>,
}

struct Fan {
    from: (usize, usize),
    to: (usize, usize),
    rail: usize,
    folds: usize,
}

fn moved([s, t]: Node, by: Node) -> Node {
    [s + by[0], t + by[1]]
}

impl<'a, L: Landscape> Graph<'a, L> {
    fn new(landscape: &'a L) -> Self {
        #[allow(clippy::cast_precision_loss)]
        let [m, n] = landscape.size().map(|count| count as f64);
        let shifts = if landscape.is_closed() {
            vec![[0.0, 0.0], [m, 0.0], [0.0, n], [m, n]]
        } else {
            vec![[0.0, 0.0]]
        };
        let count = landscape.arcs().len();
        let arcs: Vec<(usize, Node)> = shifts
            .iter()
            .flat_map(|shift| (0..count).map(move |arc| (arc, *shift)))
            .collect();
        let mut graph = Self {
            landscape,
            stops: vec![Vec::new(); arcs.len()],
            arcs,
            fans: Vec::new(),
        };
        let mut jumps = Vec::new();
        let mut looked = 0;
        for one in 0..graph.arcs.len() {
            for other in (0..graph.arcs.len()).filter(|other| *other != one) {
                for rail in 0..2 {
                    // A fan that goes on over the corner of a triangle is folded there.
                    if [one, other]
                        .iter()
                        .any(|arc| graph.still(*arc) == Some(rail))
                    {
                        continue;
                    }
                    let values = [graph.ends(one)[1][rail], graph.ends(other)[0][rail]];
                    for value in values {
                        let (Some(from), Some(to)) =
                            (graph.at(one, rail, value), graph.at(other, rail, value))
                        else {
                            continue;
                        };
                        let length = to[1 - rail] - from[1 - rail];
                        if length < -SAME_NODE || looked >= MAX_FANS {
                            continue;
                        }
                        looked += 1;
                        if let Some(folds) = graph.folds(rail, from, to) {
                            jumps.push((one, from, other, to, rail, folds));
                        }
                    }
                }
            }
        }
        for arc in 0..graph.arcs.len() {
            let mut places: Vec<Node> = graph.ends(arc).to_vec();
            places.extend(jumps.iter().filter(|j| j.0 == arc).map(|j| j.1));
            places.extend(jumps.iter().filter(|j| j.2 == arc).map(|j| j.3));
            places.sort_by(|a, b| (a[0] + a[1]).total_cmp(&(b[0] + b[1])));
            places.dedup_by(|a, b| near(a, b));
            graph.stops[arc] = places.into_iter().map(|at| Stop { arc, at }).collect();
        }
        for (one, from, other, to, rail, folds) in jumps {
            let index = |arc: usize, at: &Node| {
                let stops = graph.stops.get(arc)?;
                Some((arc, stops.iter().position(|stop| near(&stop.at, at))?))
            };
            if let (Some(from), Some(to)) = (index(one, &from), index(other, &to)) {
                graph.fans.push(Fan {
                    from,
                    to,
                    rail,
                    folds,
                });
            }
        }
        graph
    }

    /// The rail that stands still on an arc that is a plane triangle.
    fn still(&self, arc: usize) -> Option<usize> {
        let (number, _) = self.arcs.get(arc)?;
        self.landscape.still(*number)
    }

    /// The ends of an arc.
    fn ends(&self, arc: usize) -> [Node; 2] {
        let (number, shift) = self.arcs.get(arc).copied().unwrap_or_default();
        let nodes = self.landscape.arcs().get(number);
        let at = |node: Option<&Node>| moved(node.copied().unwrap_or_default(), shift);
        [
            at(nodes.and_then(|nodes| nodes.first())),
            at(nodes.and_then(|nodes| nodes.last())),
        ]
    }

    /// The place on an arc where the parameter of a rail has this value.
    fn at(&self, arc: usize, rail: usize, value: f64) -> Option<Node> {
        let [from, to] = self.ends(arc);
        if (value - from[rail]).abs() <= SAME_NODE {
            return Some(from);
        }
        if (value - to[rail]).abs() <= SAME_NODE {
            return Some(to);
        }
        if value < from[rail] || value > to[rail] {
            return None;
        }
        let (number, shift) = self.arcs.get(arc).copied()?;
        let place = self.landscape.on_arc(number, rail, value - shift[rail])?;
        Some(moved(place, shift))
    }

    fn folds(&self, rail: usize, from: Node, to: Node) -> Option<usize> {
        if near(&from, &to) {
            return Some(0);
        }
        self.landscape.folds(rail, from, to)
    }

    /// The best ways from each stop to the goal, by what is `last` at a stop.
    fn ways(&self, goal: &dyn Fn(Stop) -> Option<Way>) -> Vec<Vec<Vec<Way>>> {
        let mut found: Vec<Vec<Option<Vec<Way>>>> = self
            .stops
            .iter()
            .map(|stops| vec![None; stops.len()])
            .collect();
        // From the last to the first: each step leads on, or from the end of an arc to the start of another.
        let mut order: Vec<(usize, usize)> = (0..self.stops.len())
            .flat_map(|arc| (0..self.stops[arc].len()).map(move |k| (arc, k)))
            .collect();
        let sum = |(arc, k): (usize, usize)| {
            let [s, t] = self.stops[arc][k].at;
            // Starts of arcs last among equals, so that they are looked at first.
            let last = k + 1 == self.stops[arc].len();
            s + t - if last { 4.0 * SAME_NODE } else { 0.0 }
        };
        order.sort_by(|a, b| sum(*b).total_cmp(&sum(*a)));
        for (arc, k) in order {
            let stop = self.stops[arc][k];
            let mut ways: Vec<Way> = goal(stop).into_iter().collect();
            if let (Some(next), Some(Some(rest))) =
                (self.stops[arc].get(k + 1), found[arc].get(k + 1))
            {
                let kind = match self.still(arc) {
                    Some(rail) => StepKind::Fan(rail),
                    None => StepKind::Arc(arc),
                };
                let step = Step {
                    kind,
                    from: stop.at,
                    to: next.at,
                };
                ways.extend(rest.iter().map(|way| way.after(step, 0)));
            }
            for fan in self.fans.iter().filter(|fan| fan.from == (arc, k)) {
                let (other, index) = fan.to;
                let Some(Some(rest)) = found[other].get(index) else {
                    continue;
                };
                let step = Step {
                    kind: StepKind::Fan(fan.rail),
                    from: stop.at,
                    to: self.stops[other][index].at,
                };
                let same = near(&step.from, &step.to);
                ways.extend(rest.iter().map(|way| {
                    if same {
                        way.clone()
                    } else {
                        way.after(step, fan.folds)
                    }
                }));
            }
            sorted(&mut ways);
            found[arc][k] = Some(ways);
        }
        found
            .into_iter()
            .map(|stops| stops.into_iter().map(Option::unwrap_or_default).collect())
            .collect()
    }
}

fn near(a: &Node, b: &Node) -> bool {
    (0..2).all(|i| (a[i] - b[i]).abs() <= SAME_NODE)
}

fn sorted(ways: &mut Vec<Way>) {
    ways.sort_by_key(Way::cost);
    ways.dedup();
    ways.truncate(MAX_WAYS);
}

/// The best whole ways, the best first; none of them may be left.
pub(crate) fn ways(landscape: &impl Landscape) -> Vec<Way> {
    let graph = Graph::new(landscape);
    let mut found = if landscape.is_closed() {
        loops(&graph)
    } else {
        across(&graph)
    };
    // The copies of an arc have its number.
    for step in found.iter_mut().flat_map(|way| &mut way.steps) {
        if let StepKind::Arc(arc) = &mut step.kind {
            *arc = graph.arcs[*arc].0;
        }
    }
    found
}

/// The ways from one corner of the square to the opposite one.
fn across<L: Landscape>(graph: &Graph<'_, L>) -> Vec<Way> {
    #[allow(clippy::cast_precision_loss)]
    let end = graph.landscape.size().map(|count| count as f64);
    let fan = |rail: usize, from: Node, to: Node, rest: &Way| -> Option<Way> {
        let kind = StepKind::Fan(rail);
        if near(&from, &to) {
            return Some(rest.clone());
        }
        let folds = graph.landscape.folds(rail, from, to)?;
        Some(rest.after(Step { kind, from, to }, folds))
    };
    let goal = |stop: Stop| -> Option<Way> {
        let on = |rail: usize| (stop.at[rail] - end[rail]).abs() <= SAME_NODE;
        let rail = (0..2).find(|rail| on(*rail))?;
        fan(rail, stop.at, end, &Way::END)
    };
    let found = graph.ways(&goal);
    let mut all = Vec::new();
    for (arc, ways) in found.iter().enumerate() {
        let (Some(stop), Some(ways)) = (graph.stops[arc].first(), ways.first()) else {
            continue;
        };
        let rail = (0..2).find(|rail| stop.at[*rail].abs() <= SAME_NODE);
        let Some(rail) = rail else { continue };
        all.extend(
            ways.iter()
                .filter_map(|way| fan(rail, [0.0; 2], stop.at, way)),
        );
    }
    sorted(&mut all);
    all
}

/// The ways once around both rails.
fn loops<L: Landscape>(graph: &Graph<'_, L>) -> Vec<Way> {
    #[allow(clippy::cast_precision_loss)]
    let turn = graph.landscape.size().map(|count| count as f64);
    let count = graph.landscape.arcs().len();
    let mut all: Vec<Way> = Vec::new();
    let stops: usize = graph.stops.iter().map(Vec::len).sum();
    let each = stops.saturating_mul(graph.fans.len()).max(1);
    let mut left = MAX_LOOKS;
    for arc in 0..count {
        for start in graph.stops[arc].clone() {
            if left < each {
                break;
            }
            left -= each;
            let wanted = moved(start.at, turn);
            let number = graph.arcs[arc].0;
            let goal = |stop: Stop| {
                let same = graph.arcs[stop.arc].0 == number && near(&stop.at, &wanted);
                same.then_some(Way::END)
            };
            let found = graph.ways(&goal);
            let index = graph.stops[arc]
                .iter()
                .position(|stop| near(&stop.at, &start.at));
            let ways = index.and_then(|index| found[arc].get(index));
            // The same loop from another of its rulings is no other loop.
            for way in ways
                .into_iter()
                .flatten()
                .filter(|way| !way.steps.is_empty())
            {
                let known = all.iter().any(|other| is_rotation(other, way, turn, count));
                if !known {
                    all.push(way.clone());
                }
            }
        }
    }
    sorted(&mut all);
    all
}

/// Whether two loops are made of the same fans and as many arcs.
fn is_rotation(one: &Way, other: &Way, turn: Node, count: usize) -> bool {
    let inside = |x: f64, turn: f64| {
        let share = (x / turn).fract();
        if share > 1.0 - 1e-9 { 0.0 } else { share }
    };
    let fans = |way: &Way| {
        let mut list: Vec<(usize, [i64; 2])> = way
            .steps
            .iter()
            .filter_map(|step| match step.kind {
                StepKind::Arc(_) => None,
                StepKind::Fan(rail) => {
                    #[allow(clippy::cast_possible_truncation)]
                    let place =
                        [0, 1].map(|i| (inside(step.from[i], turn[i]) * 1e7).round() as i64);
                    Some((rail, place))
                }
            })
            .collect();
        list.sort_unstable();
        list
    };
    let arcs = |way: &Way| {
        let mut list: Vec<usize> = way
            .steps
            .iter()
            .filter_map(|step| match step.kind {
                StepKind::Arc(arc) => Some(arc % count),
                StepKind::Fan(_) => None,
            })
            .collect();
        list.sort_unstable();
        list.dedup();
        list
    };
    fans(one) == fans(other) && arcs(one) == arcs(other)
}

/// Whether a way is possible at all, if everything that is not excluded is passable: `elements` are boxes that hold all
/// solutions, rising or falling. If not, there is no panel. Of too many boxes nothing is excluded.
pub(crate) fn may_exist(size: [usize; 2], elements: &[ParameterBox]) -> bool {
    const SLACK: f64 = 1e-8;
    #[allow(clippy::cast_precision_loss)]
    let end = size.map(|count| count as f64);
    let low = |k: usize| [elements[k].s[0], elements[k].t[0]];
    let high = |k: usize| [elements[k].s[1], elements[k].t[1]];
    // The least parameters with which each can be entered.
    let mut entries: Vec<Option<Node>> = (0..elements.len())
        .map(|k| {
            let at = low(k);
            (0..2).any(|i| at[i] <= SLACK).then_some(at)
        })
        .collect();
    let mut open: Vec<usize> = (0..elements.len())
        .filter(|k| entries[*k].is_some())
        .collect();
    let mut looked = 0_usize;
    while let Some(one) = open.pop() {
        looked = looked.saturating_add(elements.len());
        if looked > MAX_PAIRS {
            return true;
        }
        let Some(entry) = entries[one] else { continue };
        if (0..2).any(|i| high(one)[i] >= end[i] - SLACK) {
            return true;
        }
        for (other, known) in entries.iter_mut().enumerate() {
            let (from, to) = (low(other), high(other));
            // A fan has one parameter in common with both, and the other does not fall.
            let linked = (0..2).any(|i| {
                from[i] <= high(one)[i] + SLACK
                    && to[i] >= entry[i] - SLACK
                    && to[1 - i] >= entry[1 - i] - SLACK
            });
            if !linked {
                continue;
            }
            let at = [0, 1].map(|i| from[i].max(entry[i].min(to[i])));
            let least = match *known {
                None => at,
                Some(known) => [known[0].min(at[0]), known[1].min(at[1])],
            };
            if *known != Some(least) {
                *known = Some(least);
                open.push(other);
            }
        }
    }
    false
}
