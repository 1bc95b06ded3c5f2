//! Strips that cover surfaces, with bounds that hold and are not far from what is measured.

use torse_geometry::basis::BasisShape;
use torse_geometry::prelude::*;
use torse_geometry::vector::{dot, norm, sub};
use torse_geometry::{Surface, TensorSurface};

type Free = TensorSurface<BasisShape<f64>, BasisShape<f64>, f64>;

fn net(rows: &[&[Point]]) -> Free {
    let rows = rows.iter().map(|row| row.to_vec()).collect();
    TensorSurface::new(BasisShape::Bernstein, BasisShape::Bernstein, rows).unwrap()
}

/// The surface over a grid of cubic heights.
fn heights(size: f64, heights: [[f64; 4]; 4]) -> Free {
    let row = |k: usize| -> Vec<Point> {
        let at = |k: usize| size / 3.0 * [0.0, 1.0, 2.0, 3.0][k];
        (0..4).map(|l| [at(k), at(l), heights[k][l]]).collect()
    };
    let rows: Vec<Vec<Point>> = (0..4).map(row).collect();
    let rows: Vec<&[Point]> = rows.iter().map(Vec::as_slice).collect();
    net(&rows)
}

fn dome() -> Free {
    heights(
        2000.0,
        [
            [0.0, 190.0, 200.0, 0.0],
            [210.0, 420.0, 430.0, 220.0],
            [200.0, 410.0, 400.0, 210.0],
            [0.0, 180.0, 210.0, 0.0],
        ],
    )
}

/// Half of a hull: stations along x, from the keel up to the sheer, fuller amidships.
fn hull() -> Free {
    net(&[
        &[[0., 0., 60.], [0., 220., 120.], [-40., 420., 420.], [-80., 520., 760.]],
        &[[1300., 0., -40.], [1300., 560., -20.], [1300., 820., 340.], [1300., 900., 700.]],
        &[[2700., 0., -60.], [2700., 540., -30.], [2700., 860., 330.], [2700., 940., 690.]],
        &[[4000., 0., 80.], [4000., 160., 170.], [4060., 330., 450.], [4120., 400., 780.]],
    ])
}

/// The distance of a point from a surface: Newton's method for the foot from the nearest place of a grid, kept in the square.
fn distance(surface: &Free, point: &Point, grid: &[([f64; 2], Point)]) -> f64 {
    let far = |p: &Point| norm(&sub(p, point));
    let mut best = grid.iter().min_by(|a, b| far(&a.1).total_cmp(&far(&b.1))).unwrap().0;
    let mut least = far(&surface.point(&best[0], &best[1]).unwrap());
    for _ in 0..12 {
        let p = surface.partials(&best[0], &best[1], 1).unwrap();
        let (u, v) = (*p.get(1, 0).unwrap(), *p.get(0, 1).unwrap());
        let away = sub(point, p.point());
        let (e, f, g) = (dot(&u, &u), dot(&u, &v), dot(&v, &v));
        let (a, b) = (dot(&away, &u), dot(&away, &v));
        let area = e * g - f * f;
        let step = [(a * g - b * f) / area, (b * e - a * f) / area];
        best = [0, 1].map(|k| (best[k] + step[k]).clamp(0.0, 1.0));
        least = least.min(far(&surface.point(&best[0], &best[1]).unwrap()));
    }
    least
}

fn grid(surface: &Free, range: [f64; 2]) -> Vec<([f64; 2], Point)> {
    let mut list = Vec::new();
    for i in 0..=40 {
        for j in 0..=8 {
            let u = f64::from(i) / 40.0;
            let v = range[0] + (range[1] - range[0]) * f64::from(j) / 8.0;
            list.push(([u, v], surface.point(&u, &v).unwrap()));
        }
    }
    list
}

/// The largest distance of samples of a strip from the surface.
fn sampled(surface: &Free, strip: &SurfaceStrip) -> f64 {
    let grid = grid(surface, strip.range);
    let mut worst = 0.0_f64;
    for piece in &strip.panel.pieces {
        for i in 0..=20 {
            for j in 1..8 {
                let (x, w) = (f64::from(i) / 20.0, f64::from(j) / 8.0);
                let point = piece.sheet.point(x, w).unwrap();
                worst = worst.max(distance(surface, &point, &grid));
            }
        }
    }
    worst
}

#[test]
fn the_bounds_of_strips_hold_and_are_near_what_samples_show() {
    for (name, surface, within) in [("dome", dome(), 10.0), ("hull", hull(), 5.0)] {
        let start = std::time::Instant::now();
        let cover = StripCover::new(&surface, StripDirection::U, within).unwrap();
        eprintln!("{name}: {} strips, {:?}", cover.strips.len(), start.elapsed());
        for strip in &cover.strips {
            let kinds: Vec<_> = strip.panel.pieces.iter().map(|p| p.kind).collect();
            let measured = sampled(&surface, strip);
            eprintln!("{:?} {} {measured} {kinds:?}", strip.range, strip.distance);
        }
        eprintln!("{:?}", cover.fold_angles().unwrap());
    }
    panic!();
}
