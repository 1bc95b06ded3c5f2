//! How far a strip is from the surface, both ways: proved.
//!
//! A ruling of the strip joins the points `P`, `Q` of the edges at `(s, v0)` and `(t, v1)`. The surface over a path
//! `g(w)` between these two places (file `slide`) is compared with the ruling:
//! `E(w) = S(g(w)) - P - (w + c w (1 - w)) (Q - P)`, with any `c` in [-1, 1] for each ruling. At the ends `E` is what
//! the edges miss the surface by, which is rounding, and `E'' = d^2 S(g)/dw^2 + 2 c (Q - P)`. So
//!
//! `|E| <= max(|E(0)|, |E(1)|) + 1/8 max |E''|`
//!
//! for all rulings and `w`. With `c = 0` and straight paths this is an eighth of the second derivative of the surface;
//! `c` and the paths take out what only moves points along the surface. Each `w + c w (1 - w)` takes [0, 1] onto
//! itself, so all points of the strip are met; the paths cover all places of the surface between the edges. Hence the
//! bound holds in both directions. Where pieces of a panel meet up to rounding only, the gap counts.
//!
//! `E''` is bounded on cells of rulings by [`ChebyshevModel`]s in the parameter of the ruling; over `w` by its values
//! in the middle of intervals and its derivative on them.

use super::rulings::modelled;
use super::slide::{STEPS, slides};
use super::strip::Tensor;
use crate::basis::BasisShape;
use crate::coordinate::Coordinate;
use crate::error::{Result, count};
use crate::model::ChebyshevModel;
use crate::over::Over;
use crate::sheet::{Panel, PanelPiece, Sheet};
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

/// A surface on f64 and over models.
pub(super) struct StripDistance<'a> {
    near: &'a Tensor,
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

/// Returns an upper bound of the length of a vector; infinite where it has none.
fn largest(vector: &Vector) -> f64 {
    let square = dot(vector, vector);
    if !square.is_finite() {
        return f64::INFINITY;
    }
    square.sharply_largest().max(0.0).sqrt() * ROUNDED
}

/// Returns the largest length at the nodes of the polynomials.
fn at_nodes(vector: &Vector) -> f64 {
    let [x, y, z] = vector.each_ref().map(ChebyshevModel::at_nodes);
    let squares = x
        .iter()
        .zip(&y)
        .zip(&z)
        .map(|((x, y), z)| x * x + y * y + z * z);
    squares.fold(0.0_f64, f64::max).sqrt()
}

/// Returns the derivative of this order along a direction: `sum C(order, i) S_(i, order - i) du^i dv^(order - i)`.
fn along(partials: &Partials<Model>, order: usize, [du, dv]: &[Model; 2]) -> Option<Vector> {
    let power = |x: &Model, n: usize| (0..n).fold(Model::exact(1.0), |p, _| p * *x);
    let mut sum = [Model::exact(0.0); 3];
    let mut binomial = 1.0;
    for i in 0..=order {
        let factor = Model::exact(binomial) * power(du, i) * power(dv, order - i);
        sum = add(&sum, &scale(&factor, partials.get(i, order - i)?));
        binomial *= count(order - i) / count(i + 1);
    }
    Some(sum)
}

impl<'a> StripDistance<'a> {
    pub fn new(near: &'a Tensor) -> Result<Self> {
        let surface = near.over(&|x: &f64| Model::exact(*x))?;
        Ok(Self { near, surface })
    }

    /// Returns a bound of the distance between a panel and the part of the surface between its edges, both ways, `None`
    /// where none is found; and on how many cells it was looked for.
    pub fn bound(&self, range: [f64; 2], panel: &Panel) -> Result<(Option<f64>, usize)> {
        let mut bound = 0.0_f64;
        let mut all = 0;
        // Where the pieces begin and end, with their uncertainty.
        let mut gap = 0.0_f64;
        let mut reached = [[0.0; 2]; 2];
        let slides = slides(self.near, range, panel);
        for (piece, slide) in panel.pieces.iter().zip(&slides) {
            let sheet = piece.sheet.over(&|x: &f64| Model::exact(*x))?;
            let own = Sliding {
                range,
                piece,
                sheet: &sheet,
                slide,
            };
            let (distance, cells) = self.piece(&own);
            all += cells;
            let (Some(distance), Some([start, end])) = (distance, ends(piece, &sheet)) else {
                return Ok((None, all));
            };
            bound = bound.max(distance);
            gap = gap.max(apart(&reached, &start));
            reached = end;
        }
        gap = gap.max(apart(&reached, &[[1.0; 2]; 2]));
        let Some(speed) = self.speed(range) else {
            return Ok((None, all));
        };
        let whole = (bound + gap * speed) * ROUNDED;
        Ok((whole.is_finite().then_some(whole), all))
    }

    /// Returns the largest derivative along the edges between them.
    fn speed(&self, [from, to]: [f64; 2]) -> Option<f64> {
        let v = Model::exact(0.5 * (from + to)).widened(0.5 * (to - from) * ROUNDED + f64::EPSILON);
        let all = self
            .surface
            .partials(&Model::identity(0.0, 1.0), &v, 1)
            .ok()?;
        Some(largest(all.get(1, 0)?))
    }

    /// Returns a bound for one piece, and on how many cells it was looked for: the cell with the largest is halved until
    /// the bound is close.
    fn piece(&self, own: &Sliding<'_>) -> (Option<f64>, usize) {
        let cell = |x: [f64; 2]| {
            let unknown = Cell {
                range: x,
                bound: f64::INFINITY,
                attained: 0.0,
            };
            self.cell(own, x).unwrap_or(unknown)
        };
        // On each of them the paths change linearly.
        let first = (0..STEPS).map(|k| [k, k + 1].map(|k| count(k) / count(STEPS)));
        let mut cells: Vec<Cell> = first.map(cell).collect();
        loop {
            let order = |a: &(usize, &Cell), b: &(usize, &Cell)| a.1.bound.total_cmp(&b.1.bound);
            let Some((index, worst)) = cells.iter().enumerate().max_by(order) else {
                return (None, 0);
            };
            let [from, to] = worst.range;
            let attained = cells.iter().fold(0.0_f64, |m, c| m.max(c.attained));
            let done = worst.bound <= CLOSE * attained || cells.len() >= MAX_CELLS;
            if done || to - from <= LEAST_CELL {
                let found = worst.bound.is_finite().then_some(worst.bound);
                // Each but the first few is half of another.
                return (found, 2 * cells.len() - STEPS);
            }
            let middle = 0.5 * (from + to);
            cells.swap_remove(index);
            cells.extend([cell([from, middle]), cell([middle, to])]);
        }
    }

    fn cell(&self, own: &Sliding<'_>, x: [f64; 2]) -> Option<Cell> {
        let place = Model::identity(x[0], x[1]);
        let [s, t] = modelled(own.sheet, own.piece, &place)?;
        let [p, q] = own.sheet.ruling_ends(&place).ok()?;
        let [low, high] = own.range.map(Model::exact);
        let missed = [(s, low, p), (t, high, q)].map(|(u, v, end)| {
            let point = self.surface.point(&u, &v).ok()?;
            Some(largest(&sub(&end, &point)))
        });
        let [Some(first), Some(second)] = missed else {
            return None;
        };
        let ruling = sub(&q, &p);
        let paths = Paths {
            start: [s, low],
            step: [t - s, high - low],
            slide: own.slide_on(x, &place)?,
        };
        let bent = |w: f64| self.second(&paths.at(w), &paths.speed(w), &paths.slide);
        let shift = shift(&bent(0.5)?, &ruling);
        let half = 0.5 / f64::from(INTERVALS);
        let (mut bound, mut attained) = (0.0_f64, 0.0_f64);
        for k in 0..INTERVALS {
            let w = half * f64::from(2 * k + 1);
            let second = add(&bent(w)?, &scale(&shift, &ruling));
            let third = self.third(&paths, w, half)?;
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

    /// `d^2 S(g)/dw^2` at places with the speed of their paths.
    fn second(&self, [u, v]: &[Model; 2], speed: &[Model; 2], slide: &Model) -> Option<Vector> {
        let partials = self.surface.partials(u, v, 2).ok()?;
        // The second derivative of the path.
        let turn = Model::exact(-2.0) * *slide;
        let turned = scale(&turn, partials.get(1, 0)?);
        Some(add(&along(&partials, 2, speed)?, &turned))
    }

    /// Returns the third derivative on all of an interval about `w`.
    fn third(&self, paths: &Paths, w: f64, half: f64) -> Option<Vector> {
        let speed = paths.speed(w);
        // The paths turn evenly.
        let turned = 2.0 * half * paths.slide.largest() * ROUNDED;
        let speed = [speed[0].widened(turned), speed[1]];
        let at = paths.at(w);
        let [u, v] = [0, 1].map(|i| at[i].widened(half * speed[i].largest() * ROUNDED));
        let partials = self.surface.partials(&u, &v, 3).ok()?;
        let mixed = add(
            &scale(&speed[0], partials.get(2, 0)?),
            &scale(&speed[1], partials.get(1, 1)?),
        );
        let turn = Model::exact(-6.0) * paths.slide;
        Some(add(&along(&partials, 3, &speed)?, &scale(&turn, &mixed)))
    }
}

/// A piece of a panel with its paths.
struct Sliding<'a> {
    range: [f64; 2],
    piece: &'a PanelPiece,
    sheet: &'a Sheet<Model>,
    slide: &'a [f64; STEPS + 1],
}

impl Sliding<'_> {
    /// `e` on a cell within one of its steps.
    fn slide_on(&self, [from, to]: [f64; 2], place: &Model) -> Option<Model> {
        let steps = count(STEPS);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let step = (0.5 * (from + to) * steps).floor() as usize;
        let [before, after] = [step, step + 1].map(|k| self.slide.get(k));
        let [before, after] = [Model::exact(*before?), Model::exact(*after?)];
        let share = Model::exact(steps) * *place - Model::exact(count(step));
        Some(before + (after - before) * share)
    }
}

/// Paths on the surface from edge to edge, one for each ruling of a cell.
struct Paths {
    start: [Model; 2],
    step: [Model; 2],
    /// `e`.
    slide: Model,
}

impl Paths {
    fn at(&self, w: f64) -> [Model; 2] {
        let share = Model::exact(w);
        // Exact for the places that are asked for.
        let bow = self.slide * Model::exact(w * (1.0 - w));
        [
            self.start[0] + share * self.step[0] + bow,
            self.start[1] + share * self.step[1],
        ]
    }

    fn speed(&self, w: f64) -> [Model; 2] {
        let turned = self.slide * Model::exact(1.0 - 2.0 * w);
        [self.step[0] + turned, self.step[1]]
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

/// Returns where a piece begins and ends: bounds of both parameters.
fn ends(piece: &PanelPiece, sheet: &Sheet<Model>) -> Option<[[[f64; 2]; 2]; 2]> {
    let end = |inner: [f64; 2], t: f64| {
        let found = modelled(sheet, piece, &Model::identity(inner[0], inner[1]))?;
        if !found.iter().all(Coordinate::is_finite) {
            return None;
        }
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

/// Returns the largest difference of two pairs of parameters within bounds.
fn apart(one: &[[f64; 2]; 2], other: &[[f64; 2]; 2]) -> f64 {
    let pairs = one.iter().zip(other);
    let far = pairs.map(|(a, b)| (a[1] - b[0]).max(b[1] - a[0]));
    far.fold(0.0, f64::max)
}
