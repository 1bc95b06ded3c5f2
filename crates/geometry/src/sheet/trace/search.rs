//! Where a line meets a sheet: all places on f64, by sign changes along its rulings.
//!
//! The line `B + w D` meets the line of the ruling `P + v R` where `g(x) = det(P - B, R, D)` vanishes.

use super::super::{Point, Sheet};
use crate::surface::Rails;
use crate::vector::{cross, det, dot, norm, scale, sub};

/// Rulings of a sheet at which `g` is looked at.
const SAMPLES: u32 = 96;
/// Halvings that find a root.
const HALVINGS: u32 = 60;
/// What counts as nothing beside the size of a sheet.
const NOTHING: f64 = 1e-9;

/// A place of a sheet that a line meets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// The index of the sheet.
    pub sheet: usize,
    /// The place `u`, `v`, and `w` on the line.
    pub at: [f64; 3],
}

/// Returns `v` and `w` for the ruling at `x`, and how far both lines are apart.
fn apart(sheet: &Sheet, x: f64, from: &Point, way: &Point) -> Option<([f64; 2], f64)> {
    let [p, q] = sheet.ruling_ends(&x).ok()?;
    let (ruling, arm) = (sub(&q, &p), sub(from, &p));
    let normal = cross(&ruling, way);
    let square = dot(&normal, &normal);
    let v = dot(&cross(&arm, way), &normal) / square;
    let w = dot(&cross(&arm, &ruling), &normal) / square;
    let on_ruling = crate::vector::add(&p, &scale(&v, &ruling));
    let on_line = crate::vector::add(from, &scale(&w, way));
    let off = norm(&sub(&on_ruling, &on_line));
    (v.is_finite() && w.is_finite()).then_some(([v, w], off))
}

/// Returns all places `u, v, w` at which a line meets the lines of rulings of a sheet, whatever `v` and `w`.
pub fn meetings(sheet: &Sheet, from: &Point, way: &Point) -> Vec<[f64; 3]> {
    let side = |x: f64| -> Option<f64> {
        let [p, q] = sheet.ruling_ends(&x).ok()?;
        Some(det(&sub(&p, from), &sub(&q, &p), way))
    };
    let mut found: Vec<[f64; 3]> = Vec::new();
    let mut add = |x: f64| {
        if let Some(([v, w], off)) = apart(sheet, x, from, way) {
            let size = norm(way) * w.abs().max(1.0);
            if off <= NOTHING * size && found.iter().all(|[known, ..]| (known - x).abs() > NOTHING)
            {
                found.push([x, v, w]);
            }
        }
    };
    let mut before: Option<(f64, f64)> = None;
    for k in 0..=SAMPLES {
        let x = f64::from(k) / f64::from(SAMPLES);
        let Some(value) = side(x) else {
            before = None;
            continue;
        };
        if let Some((mut low, at_low)) = before
            && (at_low > 0.0) != (value > 0.0)
        {
            let mut high = x;
            for _ in 0..HALVINGS {
                let middle = 0.5 * (low + high);
                match side(middle) {
                    Some(here) if (here > 0.0) == (at_low > 0.0) => low = middle,
                    _ => high = middle,
                }
            }
            add(0.5 * (low + high));
        }
        before = Some((x, value));
    }
    // Where it is exactly, or nearly, at the first or the last ruling.
    add(0.0);
    add(1.0);
    found
}

/// Returns the place of a sheet nearest to a point, as samples and their neighbourhood show, and its distance.
pub fn nearest(sheet: &Sheet, point: &Point) -> Option<([f64; 2], f64)> {
    let at = |x: f64| -> Option<(f64, f64)> {
        let [p, q] = sheet.ruling_ends(&x).ok()?;
        let ruling = sub(&q, &p);
        let square = dot(&ruling, &ruling);
        let share = if square > 0.0 {
            (dot(&sub(point, &p), &ruling) / square).clamp(0.0, 1.0)
        } else {
            0.0
        };
        let foot = crate::vector::lerp(&p, &q, &share);
        Some((norm(&sub(point, &foot)), share))
    };
    let samples = (0..=SAMPLES).filter_map(|k| {
        let x = f64::from(k) / f64::from(SAMPLES);
        Some((x, at(x)?.0))
    });
    let (start, _) = samples.min_by(|a, b| a.1.total_cmp(&b.1))?;
    let step = 1.0 / f64::from(SAMPLES);
    let (mut low, mut high) = ((start - step).max(0.0), (start + step).min(1.0));
    // A third of the bracket falls away with each step.
    for _ in 0..2 * HALVINGS {
        let third = (high - low) / 3.0;
        let (a, b) = (low + third, high - third);
        if at(a)?.0 <= at(b)?.0 {
            high = b;
        } else {
            low = a;
        }
    }
    let ends = [0.5 * (low + high), low, high].into_iter();
    let best = ends.filter_map(|x| Some((x, at(x)?)));
    let (x, (off, v)) = best.min_by(|a, b| a.1.0.total_cmp(&b.1.0))?;
    Some(([x, v], off))
}
