//! Refining samples of a patch until each follows from its neighbour.
//!
//! Two neighbouring rulings agree when at both rails the normals point the same way (within 60 degrees) and are
//! of like length (within a factor of four), the normals at the two ends of one ruling relate alike, and the
//! rails go from the one to the other as their derivatives say (within half of the way). A smooth regular patch
//! satisfies this as soon as the samples are close; across a cusp, a point at infinity or a zero of a normal of
//! any order it never does.

use super::forms::RulingForms;
use crate::error::Result;
use crate::parallel::prelude::*;
use crate::vector::{add, dot, norm, scale, sub};

/// How often one interval is halved at most.
const MAX_DEPTH: u32 = 40;
/// Rulings added at most: this many and four for every one there was.
const MORE: usize = 4096;
/// Pairs that a thread takes at a time.
const SHARE: usize = 128;

/// A ruling with its parameter.
type Sample = (f64, RulingForms<f64>);

/// The samples with more between them where neighbours do not agree, and the first pair that never will.
pub(super) fn resolved(
    samples: Vec<Sample>,
    at: impl Fn(f64) -> Result<Sample>,
) -> Result<(Vec<Sample>, Option<[f64; 2]>)> {
    // As most patches have it, and their samples need not be moved.
    let pairs = samples.par_windows(2).with_min_len(SHARE);
    if pairs.all(|pair| matches!(pair, [one, two] if agree(one, two))) {
        return Ok((samples, None));
    }
    let mut budget = MORE + 4 * samples.len();
    let mut done: Vec<Sample> = Vec::with_capacity(samples.len());
    let mut gap = None;
    // Those to come, the next one last, with the number of halvings that made them.
    let mut open: Vec<(Sample, u32)> = samples.into_iter().rev().map(|s| (s, 0)).collect();
    while let Some((next, depth)) = open.pop() {
        let Some(last) = done.last() else {
            done.push(next);
            continue;
        };
        if gap.is_some() || agree(last, &next) {
            done.push(next);
            continue;
        }
        let middle = 0.5 * (last.0 + next.0);
        if depth >= MAX_DEPTH || budget == 0 {
            gap = Some([last.0, next.0]);
            done.push(next);
            continue;
        }
        budget -= 1;
        let between = at(middle)?;
        open.push((next, depth + 1));
        open.push((between, depth + 1));
    }
    Ok((done, gap))
}

fn agree((x, one): &Sample, (y, two): &Sample) -> bool {
    let step = y - x;
    let ends = one.normals().iter().zip(two.normals());
    let continued = ends.clone().all(|(n, m)| {
        let (long, short) = (norm(n).max(norm(m)), norm(n).min(norm(m)));
        dot(n, m) >= 0.5 * long * short && 4.0 * short >= long
    });
    let side = |forms: &RulingForms<f64>| {
        let [n, m] = forms.normals();
        dot(n, m) / dot(n, n).max(dot(m, m))
    };
    let (first, second) = (side(one), side(two));
    let alike = first.signum() == second.signum()
        && 4.0 * first.abs().min(second.abs()) >= first.abs().max(second.abs());
    let rails = one.ends().iter().zip(two.ends());
    let slopes = one.slopes().iter().zip(two.slopes());
    let followed = rails.zip(slopes).all(|((p, q), (dp, dq))| {
        let foreseen = scale(&(0.5 * step), &add(dp, dq));
        let room = 0.5 * step * norm(dp).max(norm(dq));
        // Rounding of the points themselves, which a rail that hardly moves cannot be held against.
        let rounding = 64.0 * f64::EPSILON * (norm(p) + norm(q));
        norm(&sub(&sub(q, p), &foreseen)) <= room + rounding
    });
    continued && alike && followed
}
