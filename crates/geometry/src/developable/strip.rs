//! Strips: what is known of the rulings of an interval of the parameter, and proofs that two strips are apart.
//!
//! A strip lies within the hull of four points, widened by what the rails differ from their chords.

use crate::model::ChebyshevModel;
use crate::surface::Rails;
use crate::vector::{add, dot, norm, scale, sub};

/// Steps of the search for the distance of two hulls.
const HULL_STEPS: usize = 24;

/// An interval `[index, index + 1]/2^depth`.
pub type Key = (u32, u32);

/// What is known of the rulings of an interval.
#[derive(Clone, Copy)]
pub struct Strip {
    /// The ends of the chords of both rails.
    pub corners: [[f64; 3]; 4],
    /// How far the rails are from their chords, at most.
    pub room: f64,
    /// Intervals of the speeds of the rails.
    pub slopes: [[ChebyshevModel; 3]; 2],
    /// Intervals of the ruling.
    pub ruling: [ChebyshevModel; 3],
}

/// A constant that stands for all values of a model.
pub fn constant(model: &ChebyshevModel) -> ChebyshevModel {
    let [low, high] = model.range();
    let middle = 0.5 * (low + high);
    ChebyshevModel::exact(middle)
        .widened((high - middle).max(middle - low) * (1.0 + 4.0 * f64::EPSILON))
}

/// The ends of an interval.
pub fn width((depth, index): Key) -> [f64; 2] {
    let count = f64::from(1_u32 << depth);
    [f64::from(index) / count, f64::from(index + 1) / count]
}

/// Both halves of an interval.
pub fn halves((depth, index): Key) -> [Key; 2] {
    [(depth + 1, 2 * index), (depth + 1, 2 * index + 1)]
}

impl Strip {
    /// That of an interval. With an apex, the rail that is a point, the directions of the rulings seen from there take the
    /// place of the points: at the distances one and two.
    pub fn new(models: &impl Rails<ChebyshevModel>, key: Key, apex: Option<usize>) -> Option<Self> {
        let [from, to] = width(key);
        let [[p, dp], [q, dq]] = models
            .ends_and_slopes(&ChebyshevModel::identity(from, to))
            .ok()?;
        let ruling = sub(&q, &p);
        let ends = match apex {
            None => [p, q],
            Some(rail) => {
                let length = dot(&ruling, &ruling).root()?;
                let length = if rail == 0 { length } else { -length };
                let unit = [
                    ruling[0].quotient(&length)?,
                    ruling[1].quotient(&length)?,
                    ruling[2].quotient(&length)?,
                ];
                [unit, add(&unit, &unit)]
            }
        };
        let mut corners = [[0.0; 3]; 4];
        let mut room = 0.0_f64;
        for (rail, models) in ends.iter().enumerate() {
            let mut off = [0.0; 3];
            for (axis, model) in models.iter().enumerate() {
                let (chord, rest) = model.chord();
                corners[2 * rail][axis] = chord[0];
                corners[2 * rail + 1][axis] = chord[1];
                off[axis] = rest;
            }
            room = room.max(norm(&off) * (1.0 + 4.0 * f64::EPSILON));
        }
        Some(Self {
            corners,
            room,
            slopes: [dp, dq].map(|slope| slope.each_ref().map(constant)),
            ruling: ruling.each_ref().map(constant),
        })
    }

    /// Whether the hulls of two strips are proved to be apart.
    pub fn is_apart_from(&self, other: &Self) -> bool {
        let (a, b) = (&self.corners, &other.corners);
        let all = a.iter().chain(b).flatten();
        let size = all.fold(0.0_f64, |m, c| m.max(c.abs()));
        let needed = self.room + other.room + 64.0 * f64::EPSILON * size;
        // Boxes first: most are apart by these.
        let boxed = (0..3).any(|axis| {
            let ends = |corners: &[[f64; 3]; 4]| {
                corners
                    .iter()
                    .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], c| {
                        [low.min(c[axis]), high.max(c[axis])]
                    })
            };
            let ([low, high], [from, to]) = (ends(a), ends(b));
            from - high > needed || low - to > needed
        });
        if boxed {
            return true;
        }
        let differences: Vec<[f64; 3]> = a
            .iter()
            .flat_map(|p| b.iter().map(move |q| sub(p, q)))
            .collect();
        let across = separating(&differences, needed);
        let length = norm(&across);
        differences
            .iter()
            .all(|d| dot(d, &across) > needed * length)
    }
}

/// A direction in which these vectors all go, by Gilbert's iteration for the point of their hull that is nearest to the
/// origin: it ends as soon as all go farther than `needed`. Whether they do is for the caller to look at.
pub fn separating(vectors: &[[f64; 3]], needed: f64) -> [f64; 3] {
    #[allow(clippy::cast_precision_loss)]
    let share = 1.0 / vectors.len().max(1) as f64;
    let mut nearest = vectors
        .iter()
        .fold([0.0; 3], |sum, d| add(&sum, &scale(&share, d)));
    for _ in 0..HULL_STEPS {
        let length = norm(&nearest);
        let support = vectors
            .iter()
            .min_by(|x, y| dot(x, &nearest).total_cmp(&dot(y, &nearest)));
        let Some(support) = support else { break };
        if length <= needed || dot(support, &nearest) > needed * length {
            break;
        }
        let step = sub(support, &nearest);
        let square = dot(&step, &step);
        if square == 0.0 {
            break;
        }
        let way = (-dot(&nearest, &step) / square).clamp(0.0, 1.0);
        nearest = add(&nearest, &scale(&way, &step));
    }
    nearest
}
