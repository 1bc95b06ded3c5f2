//! Places of one patch or of two that are one point: found by Newton's method, proved by the test of Krawczyk.

use super::strip::constant;
use crate::coordinate::Coordinate;
use crate::model::ChebyshevModel;
use crate::surface::Rails;
use crate::vector::{add, cross, dot, norm, scale, sub};

/// Two places `[u, v]`: one on each patch.
pub type Places = [[f64; 2]; 2];

/// Places on a ruling at which a search for meetings starts, its ends included.
pub const WHOLE_RULING: [f64; 7] = [0.5, 0.25, 0.75, 0.125, 0.875, 0.0, 1.0];

/// Points no farther apart than this share of their size are one, as far as rounding tells.
const SAME_POINT: f64 = 8.0 * f64::EPSILON;

/// Two places that are the same point, near the middles of two ranges: Newton's method for the parameters of both rulings and
/// the place on the second, with the place on the first held fast at each of `starts`. Those that are not `distinct` places of
/// the sheet are passed over. Sheets that lie on each other meet along curves, towards which the method goes as well; there it
/// ends where the points agree, for steps have no meaning any more.
pub fn meeting<P: Rails<f64> + ?Sized>(
    [first, second]: [&P; 2],
    [from, to]: [[f64; 2]; 2],
    starts: &[f64],
    distinct: impl Fn(&Places, &[f64; 3]) -> bool,
) -> Option<(Places, [f64; 3])> {
    let room = 4.0 * (from[1] - from[0]).max(to[1] - to[0]);
    for &v in starts {
        let [mut x, mut y] = [from, to].map(|range| 0.5 * (range[0] + range[1]));
        let start = [x, y];
        let mut w: Option<f64> = None;
        for _ in 0..16 {
            let (Ok(one), Ok(two)) = (first.ends_and_slopes(&x), second.ends_and_slopes(&y)) else {
                break;
            };
            let ruling = sub(&two[1][0], &two[0][0]);
            let point = crate::vector::lerp(&one[0][0], &one[1][0], &v);
            let place =
                w.unwrap_or_else(|| dot(&sub(&point, &two[0][0]), &ruling) / dot(&ruling, &ruling));
            let there = crate::vector::lerp(&two[0][0], &two[1][0], &place);
            let off = sub(&point, &there);
            let size = norm(&point) + norm(&ruling);
            if w.is_some() && norm(&off) <= SAME_POINT * size {
                let places = [[x, v], [y, place]];
                if (0.0..=1.0).contains(&place) && distinct(&places, &point) {
                    return Some((places, point));
                }
                break;
            }
            let columns = [
                crate::vector::lerp(&one[0][1], &one[1][1], &v),
                crate::vector::lerp(&two[0][1], &two[1][1], &place).map(|c| -c),
                ruling.map(|c| -c),
            ];
            let Some(step) = solved(&columns, &off) else {
                break;
            };
            (x, y) = (x - step[0], y - step[1]);
            let next = place - step[2];
            w = Some(next);
            let inside = (0.0..=1.0).contains(&x) && (0.0..=1.0).contains(&y);
            let near = (x - start[0]).abs() <= room && (y - start[1]).abs() <= room;
            if !(inside && near) {
                break;
            }
            if step[0].abs() + step[1].abs() + step[2].abs() < 1e-12 {
                let places = [[x, v], [y, next]];
                if (0.0..=1.0).contains(&next) && distinct(&places, &point) {
                    return Some((places, point));
                }
                break;
            }
        }
    }
    None
}

/// The solution of `columns . x = right`.
fn solved(columns: &[[f64; 3]; 3], right: &[f64; 3]) -> Option<[f64; 3]> {
    let [a, b, c] = columns;
    let whole = dot(a, &cross(b, c));
    let solution = [
        dot(right, &cross(b, c)) / whole,
        dot(right, &cross(c, a)) / whole,
        dot(right, &cross(a, b)) / whole,
    ];
    solution.iter().all(|x| x.is_finite()).then_some(solution)
}

/// Half the width of the box in which a meeting is proved.
const MEETING_ROOM: f64 = 1e-6;

/// Whether a meeting is proved near two places, by the test of Krawczyk: `c - Y f(c) + (1 - Y f'(X))(X - c)` lies in the box `X`
/// about `c`.
pub fn is_proved<M: Rails<ChebyshevModel>>(
    [first, second]: [&M; 2],
    [[x, v], [y, w]]: Places,
) -> bool {
    let r = MEETING_ROOM;
    let inside = |x: f64| r <= x && x <= 1.0 - r;
    if !(inside(x) && inside(y) && (0.0..=1.0).contains(&w)) {
        return false;
    }
    let exact = |x: f64| ChebyshevModel::exact(x);
    let around = |x: f64| ChebyshevModel::exact(x).widened(r);
    let at = |x: &ChebyshevModel,
              y: &ChebyshevModel,
              w: &ChebyshevModel|
     -> Option<([ChebyshevModel; 3], [[ChebyshevModel; 3]; 3])> {
        let one = first.ends_and_slopes(x).ok()?;
        let two = second.ends_and_slopes(y).ok()?;
        let between = |p: &[ChebyshevModel; 3], q: &[ChebyshevModel; 3], v: &ChebyshevModel| {
            add(p, &scale(v, &sub(q, p))).each_ref().map(constant)
        };
        let v = ChebyshevModel::exact(v);
        let off = sub(
            &between(&one[0][0], &one[1][0], &v),
            &between(&two[0][0], &two[1][0], w),
        );
        let minus = |vector: [ChebyshevModel; 3]| vector.map(|c| -c);
        let columns = [
            between(&one[0][1], &one[1][1], &v),
            minus(between(&two[0][1], &two[1][1], w)),
            minus(sub(&two[1][0], &two[0][0]).each_ref().map(constant)),
        ];
        Some((off, columns))
    };
    let Some((off, middle)) = at(&exact(x), &exact(y), &exact(w)) else {
        return false;
    };
    // Over the box: each model runs over its own interval, so only its range counts.
    let (over_x, over_y) = (
        ChebyshevModel::identity(x - r, x + r),
        ChebyshevModel::identity(y - r, y + r),
    );
    let Some((_, over)) = at(&over_x, &over_y, &around(w)) else {
        return false;
    };
    let columns = middle.map(|column| column.map(|c| c.approximate()));
    let mut inverse = [[0.0; 3]; 3];
    for k in 0..3 {
        let mut unit = [0.0; 3];
        unit[k] = 1.0;
        let Some(column) = solved(&columns, &unit) else {
            return false;
        };
        for (row, value) in inverse.iter_mut().zip(column) {
            row[k] = value;
        }
    }
    inverse.iter().enumerate().all(|(i, row)| {
        let row = row.map(ChebyshevModel::exact);
        let mut reach = dot(&row, &off).largest();
        for (j, column) in over.iter().enumerate() {
            let unit = ChebyshevModel::exact(if i == j { 1.0 } else { 0.0 });
            reach += (unit - dot(&row, column)).largest() * r;
        }
        reach * (1.0 + 1e-12) < r
    })
}
