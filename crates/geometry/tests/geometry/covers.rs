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
        &[
            [0., 0., 60.],
            [0., 220., 120.],
            [-40., 420., 420.],
            [-80., 520., 760.],
        ],
        &[
            [1300., 0., -40.],
            [1300., 560., -20.],
            [1300., 820., 340.],
            [1300., 900., 700.],
        ],
        &[
            [2700., 0., -60.],
            [2700., 540., -30.],
            [2700., 860., 330.],
            [2700., 940., 690.],
        ],
        &[
            [4000., 0., 80.],
            [4000., 160., 170.],
            [4060., 330., 450.],
            [4120., 400., 780.],
        ],
    ])
}

/// The distance of a point from a surface: Newton's method for the foot from the nearest place of a grid, kept in the square.
fn distance(surface: &Free, point: &Point, grid: &[([f64; 2], Point)]) -> f64 {
    let far = |p: &Point| norm(&sub(p, point));
    let mut best = grid
        .iter()
        .min_by(|a, b| far(&a.1).total_cmp(&far(&b.1)))
        .unwrap()
        .0;
    let mut least = far(&surface.point(&best[0], &best[1]).unwrap());
    for _ in 0..12 {
        let p = surface.partials(&best[0], &best[1], 1).unwrap();
        let (u, v) = (*p.get(1, 0).unwrap(), *p.get(0, 1).unwrap());
        let away = sub(point, p.point());
        let (e, f, g) = (dot(&u, &u), dot(&u, &v), dot(&v, &v));
        let (a, b) = (dot(&away, &u), dot(&away, &v));
        let area = e * g - f * f;
        // In a pole the grid is as near as can be.
        if area <= 0.0 {
            break;
        }
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

/// The distance of a point from a strip: from the nearest ruling, which is searched for along each piece.
fn from_strip(strip: &SurfaceStrip, point: &Point) -> f64 {
    let mut least = f64::INFINITY;
    for piece in &strip.panel.pieces {
        let far = |x: f64| {
            let [p, q] = piece.sheet.ruling(x.clamp(0.0, 1.0)).unwrap();
            let (ruling, away) = (sub(&q, &p), sub(point, &p));
            // A tip is a ruling of no length.
            let square = dot(&ruling, &ruling).max(f64::MIN_POSITIVE);
            let share = (dot(&away, &ruling) / square).clamp(0.0, 1.0);
            let foot: Point = std::array::from_fn(|k| p[k] + share * ruling[k]);
            norm(&sub(point, &foot))
        };
        let start = (0..=24).map(|k| f64::from(k) / 24.0);
        let mut best = start.min_by(|a, b| far(*a).total_cmp(&far(*b))).unwrap();
        let mut step = 1.0 / 24.0;
        while step > 1e-6 {
            let beside = [best - step, best, best + step].map(|x| x.clamp(0.0, 1.0));
            let next = beside
                .into_iter()
                .min_by(|a, b| far(*a).total_cmp(&far(*b)));
            let next = next.unwrap();
            if next == best {
                step *= 0.5;
            }
            best = next;
        }
        least = least.min(far(best));
    }
    least
}

#[test]
fn the_bounds_of_strips_hold_both_ways_and_are_near_what_samples_show() {
    let cases = [("dome", dome(), 10.0), ("hull", hull(), 6.0)];
    for (name, surface, within) in cases {
        let cover = StripCover::new(&surface, StripDirection::U, within).unwrap();
        let (mut largest, mut sharp) = (0.0_f64, 0);
        for strip in &cover.strips {
            let measured = sampled(&surface, strip);
            let back = grid(&surface, strip.range);
            let back = back
                .iter()
                .step_by(11)
                .map(|(_, point)| from_strip(strip, point));
            let back = back.fold(0.0, f64::max);
            assert!(measured <= strip.distance && back <= strip.distance * (1.0 + 1e-9));
            // Where the first rulings are oblique, beside a keel, they are less sharp.
            assert!(strip.distance <= 6.0 * measured, "{name}");
            sharp += usize::from(strip.distance <= 1.2 * measured);
            largest = largest.max(strip.distance);
        }
        assert!(2 * sharp > cover.strips.len(), "{name}");
        assert!(cover.fewest && largest <= within && largest == cover.distance());
        let least = cover
            .strips
            .iter()
            .map(|s| s.distance)
            .fold(f64::INFINITY, f64::min);
        assert!(least > 0.7 * largest, "bounds are about equal");
        // One strip less would be too far: distances grow with the square of the width.
        let count = f64::from(u32::try_from(cover.strips.len()).unwrap());
        assert!(
            largest * (count / (count - 1.0)).powi(2) > 0.9 * within,
            "{name}"
        );
    }
}

#[test]
fn there_are_no_strips_along_asymptotic_curves_and_the_place_is_told() {
    // z = x y/1000: both families of parameter lines are straight.
    let at = |k: usize| [0.0, 500.0, 1000.0][k];
    let row = |k: usize| {
        [0, 1, 2]
            .map(|l| [at(k), at(l), at(k) * at(l) / 1000.0])
            .to_vec()
    };
    let rows: Vec<Vec<Point>> = (0..3).map(row).collect();
    let saddle = net(&rows.iter().map(Vec::as_slice).collect::<Vec<_>>());
    for along in [StripDirection::U, StripDirection::V] {
        let refused = StripCover::new(&saddle, along, 5.0).unwrap_err();
        assert!(
            matches!(refused, StripError::Asymptotic { .. }),
            "{refused}"
        );
    }
    // A cubic wave: its curves along u bend the other way beyond the middle.
    let wave = heights(
        900.0,
        [
            [0.0; 4],
            [200.0, 260.0, 260.0, 200.0],
            [-200.0, -140.0, -140.0, -200.0],
            [0.0; 4],
        ],
    );
    let refused = StripCover::new(&wave, StripDirection::U, 5.0).unwrap_err();
    let StripError::Asymptotic { at: [u, v], point } = refused else {
        panic!("{refused}");
    };
    let forms = wave.forms(&u, &v).unwrap();
    let scale = norm(&forms.normal);
    assert!(forms.second[0].abs() < 1e-6 * scale && (0.2..0.8).contains(&u));
    assert_eq!(point, wave.point(&u, &v).unwrap());
}

#[test]
fn a_saddle_is_covered_along_its_lines_of_curvature() {
    // z = (x^2 - y^2)/4000 over a square of 2 m.
    let bow = |k: usize| [250.0, -250.0, 250.0][k];
    let at = |k: usize| [-1000.0, 0.0, 1000.0][k];
    let row = |k: usize| [0, 1, 2].map(|l| [at(k), at(l), bow(k) - bow(l)]).to_vec();
    let rows: Vec<Vec<Point>> = (0..3).map(row).collect();
    let saddle = net(&rows.iter().map(Vec::as_slice).collect::<Vec<_>>());
    let cover = StripCover::new(&saddle, StripDirection::U, 20.0).unwrap();
    // All curves are the same parabola, moved: each strip is a cylinder between them, and the distance that of a parabola from its
    // chord, upright (2000/N)^2/2000/8 and less across.
    assert_eq!(cover.strips.len(), 4);
    for strip in &cover.strips {
        let exact = (500.0_f64).powi(2) / 2000.0 / 8.0;
        assert!(strip.distance >= 0.9 * exact && strip.distance <= 1.01 * exact);
        assert!(sampled(&saddle, strip) <= strip.distance * (1.0 + 1e-9));
    }
    for [least, greatest] in cover.fold_angles().unwrap() {
        // Steepest where the curves are level: chords turn by 500/2000.
        assert!(
            least > 0.1 && greatest < 0.25 && greatest > 0.2,
            "{least} {greatest}"
        );
    }
}

/// Compares the bounds of a cover with samples, both ways.
fn assert_bounds_hold(surface: &Free, cover: &StripCover) {
    for strip in &cover.strips {
        let far = sampled(surface, strip);
        assert!(far <= strip.distance * (1.0 + 1e-9), "{far} {strip:?}");
        let points = grid(surface, strip.range);
        let back = points
            .iter()
            .step_by(11)
            .map(|(_, point)| from_strip(strip, point));
        let back = back.fold(0.0, f64::max);
        assert!(back <= strip.distance * (1.0 + 1e-9), "{back} {strip:?}");
    }
}

/// The dome of the manual, with a corner in which its first curve is asymptotic.
fn pinched() -> Free {
    net(&[
        &[[0., 0., 0.], [0., 1000., 400.], [0., 2000., 0.]],
        &[
            [1000., 0., 400.],
            [1000., 1000., 800.],
            [1000., 2000., 400.],
        ],
        &[[2000., 0., 0.], [2000., 1e-12, 400.], [2000., 2000., 0.]],
    ])
}

#[test]
fn beside_an_asymptotic_corner_few_strips_are_found_soon_and_their_bounds_hold() {
    let cover = StripCover::new(&pinched(), StripDirection::U, 200.0).unwrap();
    assert!(cover.fewest && cover.strips.len() == 2, "{cover:?}");
    assert!(cover.distance() <= 200.0);
    assert_bounds_hold(&pinched(), &cover);
}

#[test]
fn a_place_that_fails_at_every_width_ends_the_search_and_is_told() {
    // The first curve stands still at its start.
    let still = net(&[
        &[[0., 0., 0.], [0., 1000., 400.], [0., 2000., 0.]],
        &[[0., 0., 0.], [1000., 1000., 800.], [1000., 2000., 400.]],
        &[[2000., 0., 0.], [2000., 1000., 400.], [2000., 2000., 0.]],
    ]);
    match StripCover::new(&still, StripDirection::U, 20.0) {
        Err(error @ StripError::Narrow { .. }) => {
            let [from, to] = error.range().unwrap();
            assert!(from == 0.0 && to < 0.1, "{error}");
            let text = error.to_string();
            assert!(text.contains("no whole panel") && text.contains("not searched to the end"));
        }
        other => panic!("{other:?}"),
    }
}

/// A cap over a part of a disc: all curves along `u` start in its top, with one profile or with different ones.
fn cap(similar: bool) -> Free {
    let middle = if similar { 1050. } else { 1040. };
    net(&[
        &[[0., 0., 600.], [0., 0., 600.], [0., 0., 600.]],
        &[
            [1000., -300., 600.],
            [middle, 0., 600.],
            [1000., 300., 600.],
        ],
        &[[2000., -600., 0.], [2100., 0., 0.], [2000., 600., 0.]],
    ])
}

#[test]
fn around_a_pole_strips_begin_with_a_cone_and_along_its_meridians_the_tip_is_told() {
    let cover = StripCover::new(&cap(false), StripDirection::V, 5.0).unwrap();
    assert!(cover.fewest && cover.distance() <= 5.0);
    let kinds: Vec<PanelKind> = cover.strips[0]
        .panel
        .pieces
        .iter()
        .map(|p| p.kind)
        .collect();
    assert_eq!(kinds, [PanelKind::Fan(1)]);
    assert!(
        cover
            .fold_angles()
            .unwrap()
            .iter()
            .all(|[a, b]| 0.0 < *a && a <= b && *b < 0.5)
    );
    // The surface with its parameters exchanged, as the strips take it.
    let rows: Vec<Vec<Point>> = (0..3)
        .map(|l| cap(false).rows().map(|row| row[l]).collect())
        .collect();
    let rings = net(&rows.iter().map(Vec::as_slice).collect::<Vec<_>>());
    assert_bounds_hold(&rings, &cover);
    let refused = StripCover::new(&cap(false), StripDirection::U, 5.0).unwrap_err();
    assert_eq!(
        refused,
        StripError::Tip {
            at: 0.0,
            point: [0.0, 0.0, 600.0]
        }
    );
}

#[test]
fn a_cap_whose_meridians_have_one_profile_is_covered_by_gores_of_cylinders() {
    let cover = StripCover::new(&cap(true), StripDirection::U, 0.5).unwrap();
    assert!(
        cover.fewest && cover.strips.len() > 2,
        "{}",
        cover.strips.len()
    );
    for strip in &cover.strips {
        let [piece] = strip.panel.pieces.as_slice() else {
            panic!("{strip:?}")
        };
        // A tip has no normal of its own.
        let checked = piece.sheet.part(0.001, 1.0).unwrap().inspect(32).unwrap();
        assert!(checked.certificate.is_regular());
    }
    assert_bounds_hold(&cap(true), &cover);
}

#[test]
fn a_gore_of_a_cylinder_is_one_strip_from_its_tip() {
    let gore = net(&[
        &[[0., 0., 0.], [0., 0., 0.]],
        &[[1000., -300., 200.], [1000., 300., 200.]],
        &[[2000., -600., 0.], [2000., 600., 0.]],
    ]);
    let cover = StripCover::new(&gore, StripDirection::U, 5.0).unwrap();
    assert_eq!(cover.strips.len(), 1);
    assert!(cover.distance() < 1e-9 && cover.fewest);
}
