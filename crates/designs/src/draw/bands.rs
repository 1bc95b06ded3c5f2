//! Patches with openings in pictures: grids of points that leave them out.

use crate::design::Patch;
use crate::error::DesignError;
use crate::space_openings::{OpenSide, SpaceOpening};
use torse_geometry::prelude::Point;
use torse_geometry::vector::lerp;
use torse_plot::{Border, Colour, Grid, Line, Paint, Solid, Surface};

/// Places on rulings that are nearer to one another are one.
const SAME: f64 = 1e-12;
/// The line around a patch and its openings.
const EDGE: Line = Line::solid(Colour::INK, 0.9);

/// How finely a patch is drawn, and in what colours.
#[derive(Debug, Clone)]
pub(crate) struct PatchStyle {
    /// Steps from ruling to ruling, and along rulings.
    pub steps: [usize; 2],
    /// How many parts the shown rulings make.
    pub lines: usize,
    pub paint: Paint,
}

/// Returns what is drawn of a patch, without its openings and what is beyond its border.
///
/// # Errors
/// [`DesignError::Patch`] for a ruling that is not found.
pub(crate) fn solids(
    patch: &Patch,
    openings: &[&SpaceOpening],
    style: &PatchStyle,
) -> Result<Vec<Solid>, DesignError> {
    let [along, across] = style.steps;
    let failed = |reason| DesignError::Patch {
        patch: patch.name.clone(),
        reason,
    };
    if openings.is_empty() {
        let grid = Grid::new(along + 1, across + 1, super::samples(patch, along, across)?)?;
        let surface = Surface::new(grid).paint(style.paint.clone());
        return Ok(vec![Solid::Surface(surface.lines(style.lines, 0))]);
    }
    let mut solids = Vec::new();
    for PatchGrid {
        rows,
        columns,
        points,
        width,
    } in grids(patch, openings, style.steps)?
    {
        #[allow(
            clippy::cast_precision_loss,
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss
        )]
        let parts = (width * style.lines as f64).round().max(0.0) as usize;
        let surface = Surface::new(Grid::new(rows, columns, points)?).paint(style.paint.clone());
        let surface = surface.border(Border::Hidden).lines(parts, 0);
        solids.push(Solid::Surface(surface));
    }
    let mut curves: Vec<Vec<[f64; 2]>> = openings
        .iter()
        .flat_map(|own| own.borders.clone())
        .collect();
    if openings.iter().all(|own| own.open == OpenSide::Inside) {
        let row = |v: f64| {
            (0..=along)
                .map(|k| [share(k, along), v])
                .collect::<Vec<_>>()
        };
        curves.extend([row(0.0), row(1.0)]);
        curves.extend([0.0, 1.0].map(|u| vec![[u, 0.0], [u, 1.0]]));
    }
    for curve in curves {
        let mut points = Vec::with_capacity(curve.len());
        for [u, v] in curve {
            points.push(patch.sheet.point(u, v).map_err(failed)?);
        }
        solids.push(Solid::Curve {
            points,
            line: EDGE,
            label: String::new(),
        });
    }
    Ok(solids)
}

/// Points on a part of a patch, ruling by ruling.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PatchGrid {
    pub rows: usize,
    pub columns: usize,
    pub points: Vec<Point>,
    /// How much of the parameter its rulings take.
    pub width: f64,
}

/// Returns grids that cover a patch without its openings and what is beyond its border: at so many steps of the parameter, and
/// wherever a border has a corner; across each part so many steps.
///
/// # Errors
/// [`DesignError::Patch`] for a ruling that is not found.
pub(crate) fn grids(
    patch: &Patch,
    openings: &[&SpaceOpening],
    [along, across]: [usize; 2],
) -> Result<Vec<PatchGrid>, DesignError> {
    let lines: Vec<Vec<[f64; 2]>> = openings.iter().flat_map(|own| own.bounds()).collect();
    let mut places: Vec<f64> = (0..=along).map(|k| share(k, along)).collect();
    places.extend(lines.iter().flatten().map(|place| place[0]));
    places.sort_by(f64::total_cmp);
    places.dedup_by(|a, b| (*a - *b).abs() <= SAME);
    let at = |k: usize| places.get(k).copied().unwrap_or(1.0);
    let mut grids = Vec::new();
    for band in bands(&places, &lines) {
        let mut points: Vec<Point> = Vec::with_capacity(band.rows.len() * (across + 1));
        for (k, [low, high]) in band.rows.iter().enumerate() {
            let ruling = patch.sheet.ruling(at(band.first + k));
            let [p, q] = ruling.map_err(|reason| DesignError::Patch {
                patch: patch.name.clone(),
                reason,
            })?;
            for j in 0..=across {
                let v = low + share(j, across) * (high - low);
                points.push(lerp(&p, &q, &v));
            }
        }
        grids.push(PatchGrid {
            rows: band.rows.len(),
            columns: across + 1,
            points,
            width: at(band.first + band.rows.len() - 1) - at(band.first),
        });
    }
    Ok(grids)
}

#[allow(clippy::cast_precision_loss)]
fn share(k: usize, of: usize) -> f64 {
    k as f64 / of as f64
}

/// A part of a patch between two lines that run from ruling to ruling.
struct Band {
    /// The ruling at which it begins.
    first: usize,
    /// The shares of its lower and its upper end, ruling by ruling.
    rows: Vec<[f64; 2]>,
}

/// Returns what closed polygons, or lines from the first ruling to the last, leave of a patch: from the first rail on, what
/// an even number of them lies before.
fn bands(places: &[f64], lines: &[Vec<[f64; 2]>]) -> Vec<Band> {
    let mut sides: Vec<Vec<[f64; 2]>> = vec![Vec::new(); places.len().saturating_sub(1)];
    let station = |x: f64| places.partition_point(|place| *place < x - SAME);
    for side in lines.iter().flat_map(|line| line.windows(2)) {
        let (mut a, mut b) = (side[0], side[1]);
        if a[0] > b[0] {
            (a, b) = (b, a);
        }
        let (from, to) = (station(a[0]), station(b[0]));
        let at = |k: usize| match k {
            k if k == from => a[1],
            k if k == to => b[1],
            k => {
                let x = places.get(k).copied().unwrap_or(1.0);
                a[1] + (x - a[0]) / (b[0] - a[0]) * (b[1] - a[1])
            }
        };
        for (k, list) in sides.iter_mut().enumerate().take(to).skip(from) {
            list.push([at(k), at(k + 1)]);
        }
    }
    let mut done: Vec<Band> = Vec::new();
    let mut open: Vec<Band> = Vec::new();
    for (k, mut met) in sides.into_iter().enumerate() {
        met.sort_by(|a, b| (a[0] + a[1]).total_cmp(&(b[0] + b[1])));
        let ends = std::iter::once([0.0; 2]).chain(met).chain([[1.0; 2]]);
        let ends: Vec<[f64; 2]> = ends.collect();
        let mut next: Vec<Band> = Vec::new();
        for pair in ends.chunks_exact(2) {
            let [before, after] = [0, 1].map(|i| [pair[0][i], pair[1][i]]);
            let is_point = |row: [f64; 2]| row[1] - row[0] <= SAME;
            if is_point(before) && is_point(after) {
                continue;
            }
            let same = |row: &[f64; 2]| (0..2).all(|i| (row[i] - before[i]).abs() <= SAME);
            let known = open
                .iter()
                .position(|band| band.rows.last().is_some_and(same) && !is_point(before));
            let mut band = match known {
                Some(index) => open.remove(index),
                None => Band {
                    first: k,
                    rows: vec![before],
                },
            };
            band.rows.push(after);
            next.push(band);
        }
        done.append(&mut open);
        open = next;
    }
    done.append(&mut open);
    done
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The area of bands in the square of both parameters.
    fn area(places: &[f64], bands: &[Band]) -> f64 {
        let strip = |band: &Band| -> f64 {
            let widths: Vec<f64> = band.rows.iter().map(|row| row[1] - row[0]).collect();
            let steps = widths.windows(2).enumerate();
            steps
                .map(|(k, pair)| {
                    let step = places[band.first + k + 1] - places[band.first + k];
                    0.5 * step * (pair[0] + pair[1])
                })
                .sum()
        };
        bands.iter().map(strip).sum()
    }

    #[test]
    fn a_patch_is_drawn_without_its_round_hole() {
        let design = crate::read(
            "plate.toml",
            r#"
            [curves]
            front = { polyline = [[0, 0, 0], [80, 0, 0]] }
            back = { polyline = [[0, 50, 0], [80, 50, 0]] }
            [patches.plate]
            ruled = ["front", "back"]
            marks = [{ at = [0.25, 0.5], radius = 12 }]
            "#,
        )
        .unwrap();
        let openings = crate::space_openings::openings_in_space(&design).unwrap();
        let own: Vec<_> = openings.iter().collect();
        let style = PatchStyle {
            steps: [16, 3],
            lines: 8,
            paint: Paint::default(),
        };
        let drawn = solids(&design.patches[0], &own, &style).unwrap();
        let mut area = 0.0;
        for solid in &drawn {
            let Solid::Surface(Surface { grid, .. }) = solid else {
                continue;
            };
            let at = |i: usize, j: usize| grid.points()[i * grid.columns() + j];
            for i in 1..grid.rows() {
                for j in 1..grid.columns() {
                    let [a, b, c, d] = [at(i - 1, j - 1), at(i, j - 1), at(i, j), at(i - 1, j)];
                    let diagonals = [[c[0] - a[0], c[1] - a[1]], [d[0] - b[0], d[1] - b[1]]];
                    let [m, n] = diagonals;
                    area += 0.5 * (m[0] * n[1] - m[1] * n[0]).abs();
                }
            }
        }
        let exact = 4000.0 - 144.0 * std::f64::consts::PI;
        assert!((area - exact).abs() < 1.0, "{area} {exact}");
        // Four bands, the hole, and the four sides.
        assert_eq!(drawn.len(), 9);
    }

    #[test]
    fn bands_leave_out_a_rhombus_or_all_but_it() {
        let rhombus = vec![
            [0.25, 0.5],
            [0.5, 0.25],
            [0.75, 0.5],
            [0.5, 0.75],
            [0.25, 0.5],
        ];
        let places = [0.0, 0.125, 0.25, 0.375, 0.5, 0.75, 1.0];
        let around = bands(&places, std::slice::from_ref(&rhombus));
        assert!((area(&places, &around) - 0.875).abs() < 1e-15);
        // Before it, below, above and behind it.
        assert_eq!(around.len(), 4);
        let rails = [0.0, 1.0].map(|v| vec![[0.0, v], [1.0, v]]);
        let lines: Vec<_> = [rhombus].into_iter().chain(rails).collect();
        let within = bands(&places, &lines);
        assert_eq!(within.len(), 1);
        assert!((area(&places, &within) - 0.125).abs() < 1e-15);
    }
}
