//! How far a strip is from the surface, both ways: proved.
//!
//! A ruling of the strip joins the points of the edges at `(s, v0)` and `(t, v1)`. The surface over the segment `g(w)` between these two
//! places is compared with the ruling: `E(w) = S(g(w)) - P - (w + c w (1 - w)) (Q - P)`, with any `c` in [-1, 1] for each ruling. At the
//! ends `E` is what the edges miss the surface by, which is rounding, and `E'' = d^2 S(g)/dw^2 + 2 c (Q - P)`. So
//!
//! `|E| <= max |E(0)|, |E(1)| + 1/8 max |E''|`
//!
//! for all rulings and `w`. With `c = 0` this is an eighth of the second derivative; `c` takes out what only moves points along the
//! ruling. Each `w + c w (1 - w)` takes [0, 1] onto itself, so all points of the strip are met; the segments go from that
//! at `(0, 0)` to that at `(1, 1)` without a gap, so all places of the surface between the edges are met. Hence the bound
//! holds in both directions. Where pieces of a panel meet up to rounding only, the gap counts.
//!
//! `E''` is bounded on cells of rulings by [`ChebyshevModel`]s in the parameter of the ruling; over `w` by its values in the middle of
//! intervals and the third derivative on them.

use super::strip::Tensor;
use crate::basis::BasisShape;
use crate::coordinate::Coordinate;
use crate::error::Result;
use crate::model::ChebyshevModel;
use crate::over::Over;
use crate::sheet::{Construction, Panel, PanelKind, PanelPiece, Sheet};
use crate::surface::{Partials, Rails, Surface, TensorSurface};
use crate::vector::{add, dot, scale, sub};

type Model = ChebyshevModel;
type Vector = [Model; 3];

/// Intervals of `w`.
const INTERVALS: u32 = 4;
/// The most cells of a piece.
const MAX_CELLS: usize = 96;
/// Rulings of one cell span this share of a piece at least.
const LEAST_CELL: f64 = 1.0 / 4096.0;
/// A bound is close enough if it is at most this multiple of a value that is attained, or nearly.
const CLOSE: f64 = 1.1;
/// What f64 sums and roots of bounds may lose.
const ROUNDED: f64 = 1.0 + 1e-12;

/// A surface over models.
pub(super) struct StripDistance {
    surface: TensorSurface<BasisShape<Model>, BasisShape<Model>, Model>,
}

/// A part of the rulings of a piece.
struct Cell {
    range: [f64; 2],
    /// No ruling of it is farther from the surface.
    bound: f64,
    /// A value that the polynomials attain.
    attained: f64,
}

/// An upper bound of the length of a vector.
fn largest(vector: &Vector) -> f64 {
    let square = dot(vector, vector).sharply_largest();
    square.max(0.0).sqrt() * ROUNDED
}

/// The largest length at the nodes of the polynomials.
fn at_nodes(vector: &Vector) -> f64 {
    let [x, y, z] = vector.each_ref().map(ChebyshevModel::at_nodes);
    let squares = x.iter().zip(&y).zip(&z).map(|((x, y), z)| x * x + y * y + z * z);
    squares.fold(0.0_f64, f64::max).sqrt()
}

/// The derivative of this order along a direction: `sum C(order, i) S_(i, order - i) du^i dv^(order - i)`.
fn along(partials: &Partials<Model>, order: usize, [du, dv]: &[Model; 2]) -> Option<Vector> {
    let power = |x: &Model, n: usize| (0..n).fold(Model::exact(1.0), |p, _| p * *x);
    let mut sum = [Model::exact(0.0); 3];
    let mut binomial = 1.0;
    for i in 0..=order {
        let factor = Model::exact(binomial) * power(du, i) * power(dv, order - i);
        sum = add(&sum, &scale(&factor, partials.get(i, order - i)?));
        #[allow(clippy::cast_precision_loss)]
        let next = (order - i) as f64 / (i + 1) as f64;
        binomial *= next;
    }
    Some(sum)
}

/// The parameters on both edges of the rulings of a piece.
fn parameters(sheet: &Sheet<Model>, piece: &PanelPiece, x: &Model) -> Option<[Model; 2]> {
    match (piece.kind, sheet.construction()) {
        (PanelKind::Fan(_), _) => Some(piece.ranges.map(|[from, to]| {
            let [from, to] = [from, to].map(Model::exact);
            from + (to - from) * *x
        })),
        (PanelKind::Arc, Construction::Connecting(patch)) => patch.parameters(x),
        (PanelKind::Arc, Construction::Part(part)) => {
            let [from, to] = part.range();
            parameters(part.whole(), piece, &(*from + (*to - *from) * *x))
        }
        _ => None,
    }
}

impl StripDistance {
    pub fn new(surface: &Tensor) -> Result<Self> {
        let surface = surface.over(&|x: &f64| Model::exact(*x))?;
        Ok(Self { surface })
    }

    /// A bound of the distance between a panel and the part of the surface between its edges, both ways; `None` where none
    /// is found.
    pub fn bound(&self, range: [f64; 2], panel: &Panel) -> Result<Option<f64>> {
        let mut bound = 0.0_f64;
        // Where the pieces begin and end, with their uncertainty.
        let mut gap = 0.0_f64;
        let mut reached = [[0.0; 2]; 2];
        for piece in &panel.pieces {
            let sheet = piece.sheet.over(&|x: &f64| Model::exact(*x))?;
            let (Some(distance), Some([start, end])) =
                (self.piece(range, piece, &sheet), ends(piece, &sheet))
            else {
                return Ok(None);
            };
            bound = bound.max(distance);
            gap = gap.max(apart(&reached, &start));
            reached = end;
        }
        gap = gap.max(apart(&reached, &[[1.0; 2]; 2]));
        let Some(speed) = self.speed(range) else {
            return Ok(None);
        };
        let whole = (bound + gap * speed) * ROUNDED;
        Ok(whole.is_finite().then_some(whole))
    }

    /// The largest derivative along the edges between them.
    fn speed(&self, [from, to]: [f64; 2]) -> Option<f64> {
        let v = Model::exact(0.5 * (from + to)).widened(0.5 * (to - from) * ROUNDED + f64::EPSILON);
        let all = self.surface.partials(&Model::identity(0.0, 1.0), &v, 1).ok()?;
        Some(largest(all.get(1, 0)?))
    }

    /// A bound for one piece: the cell with the largest is halved until the bound is close.
    fn piece(&self, range: [f64; 2], piece: &PanelPiece, sheet: &Sheet<Model>) -> Option<f64> {
        let cell = |x: [f64; 2]| {
            let unknown = Cell {
                range: x,
                bound: f64::INFINITY,
                attained: 0.0,
            };
            self.cell(range, piece, sheet, x).unwrap_or(unknown)
        };
        let mut cells = vec![cell([0.0, 0.5]), cell([0.5, 1.0])];
        loop {
            let order = |a: &(usize, &Cell), b: &(usize, &Cell)| a.1.bound.total_cmp(&b.1.bound);
            let (index, worst) = cells.iter().enumerate().max_by(order)?;
            let [from, to] = worst.range;
            let attained = cells.iter().fold(0.0_f64, |m, c| m.max(c.attained));
            let done = worst.bound <= CLOSE * attained || cells.len() >= MAX_CELLS;
            if done || to - from <= LEAST_CELL {
                return worst.bound.is_finite().then_some(worst.bound);
            }
            let middle = 0.5 * (from + to);
            cells.swap_remove(index);
            cells.extend([cell([from, middle]), cell([middle, to])]);
        }
    }

    fn cell(
        &self,
        range: [f64; 2],
        piece: &PanelPiece,
        sheet: &Sheet<Model>,
        x: [f64; 2],
    ) -> Option<Cell> {
        let place = Model::identity(x[0], x[1]);
        let [s, t] = parameters(sheet, piece, &place)?;
        let [p, q] = sheet.ruling_ends(&place).ok()?;
        let [low, high] = range.map(Model::exact);
        let step = [t - s, high - low];
        let at = |w: f64| {
            let w = Model::exact(w);
            [s + w * step[0], low + w * step[1]]
        };
        let missed = [(s, low, p), (t, high, q)].map(|(u, v, end)| {
            let point = self.surface.point(&u, &v).ok()?;
            Some(largest(&sub(&end, &point)))
        });
        let [Some(first), Some(second)] = missed else {
            return None;
        };
        let bent = |[u, v]: &[Model; 2], order: usize| {
            along(&self.surface.partials(u, v, order).ok()?, order, &step)
        };
        let ruling = sub(&q, &p);
        let slide = shift(&bent(&at(0.5), 2)?, &ruling);
        let half = 0.5 / f64::from(INTERVALS);
        let (mut bound, mut attained) = (0.0_f64, 0.0_f64);
        for k in 0..INTERVALS {
            let middle = at(half * f64::from(2 * k + 1));
            let second = add(&bent(&middle, 2)?, &scale(&slide, &ruling));
            let reach = [0, 1].map(|i| half * step[i].largest() * ROUNDED);
            let about = [0, 1].map(|i| middle[i].widened(reach[i]));
            let third = bent(&about, 3)?;
            bound = bound.max(largest(&second) + half * largest(&third));
            attained = attained.max(at_nodes(&second));
        }
        let bound = (bound / 8.0 + first.max(second)) * ROUNDED;
        Some(Cell {
            range: x,
            bound,
            attained: attained / 8.0,
        })
    }
}

/// `2 c` for each ruling, one function of it: zero if `c` might leave [-1, 1].
fn shift(second: &Vector, ruling: &Vector) -> Model {
    let zero = Model::exact(0.0);
    let Some(share) = dot(second, ruling).quotient(&dot(ruling, ruling)) else {
        return zero;
    };
    let slide = -share.polynomial();
    if slide.largest() <= 2.0 { slide } else { zero }
}

/// Where a piece begins and ends: bounds of both parameters.
fn ends(piece: &PanelPiece, sheet: &Sheet<Model>) -> Option<[[[f64; 2]; 2]; 2]> {
    let end = |inner: [f64; 2], t: f64| {
        let found = parameters(sheet, piece, &Model::identity(inner[0], inner[1]))?;
        Some(found.map(|model| {
            let (value, off) = (model.at(t), model.radius() + 64.0 * f64::EPSILON);
            [value - off, value + off]
        }))
    };
    let mut width = 0.25;
    while width > LEAST_CELL {
        if let (Some(start), Some(last)) = (end([0.0, width], -1.0), end([1.0 - width, 1.0], 1.0)) {
            return Some([start, last]);
        }
        width *= 0.5;
    }
    None
}

/// The largest difference of two pairs of parameters within bounds.
fn apart(one: &[[f64; 2]; 2], other: &[[f64; 2]; 2]) -> f64 {
    let pairs = one.iter().zip(other);
    let far = pairs.map(|(a, b)| (a[1] - b[0]).max(b[1] - a[0]));
    far.fold(0.0, f64::max)
}
