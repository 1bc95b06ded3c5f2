//! Whole panels between rails: their pieces meet smoothly, and they cover both rails.

use torse_geometry::AffineMap;
use torse_geometry::curve::{EndCondition, Spacing, interpolate};
use torse_geometry::prelude::*;
use torse_geometry::vector::{cross, dot, norm, sub};

fn bezier(points: &[Point]) -> PiecewiseRail {
    Rail::bezier(points).unwrap().into()
}

fn found(first: &PiecewiseRail, second: &PiecewiseRail) -> Vec<Panel> {
    let answer = Sheet::panels(first, second).unwrap();
    let Panels::Found(panels) = answer else {
        unreachable!("{answer:?}")
    };
    panels
}

/// The largest distance of rulings where pieces meet, and the largest angle of tangent planes in radians.
fn joints(panel: &Panel) -> [f64; 2] {
    let near = |piece: &PanelPiece, x: f64| {
        let [p, q] = piece.sheet.ruling(x).unwrap();
        // Both normals of a ruling of a developable agree; an apex has the one of the other end.
        let at = |x: f64| piece.sheet.ruling(x).unwrap();
        let h = 1e-5;
        let (a, b) = if x == 0.0 {
            (at(0.0), at(h))
        } else {
            (at(1.0 - h), at(1.0))
        };
        let speeds = [sub(&b[0], &a[0]), sub(&b[1], &a[1])];
        let fast = if norm(&speeds[0]) > norm(&speeds[1]) {
            speeds[0]
        } else {
            speeds[1]
        };
        let normal = cross(&fast, &sub(&q, &p));
        ([p, q], normal.map(|c| c / norm(&normal)))
    };
    let mut worst = [0.0_f64; 2];
    let pieces = &panel.pieces;
    let mut pairs: Vec<(&PanelPiece, &PanelPiece)> =
        pieces.iter().zip(pieces.iter().skip(1)).collect();
    if panel.closed && pieces.len() > 1 {
        pairs.push((pieces.last().unwrap(), &pieces[0]));
    }
    for (one, next) in pairs {
        let ((a, n), (b, m)) = (near(one, 1.0), near(next, 0.0));
        for k in 0..2 {
            worst[0] = worst[0].max(norm(&sub(&a[k], &b[k])));
        }
        worst[1] = worst[1].max(libm::atan2(norm(&cross(&n, &m)), dot(&n, &m)));
    }
    worst
}

fn area(panel: &Panel) -> f64 {
    let each = panel.pieces.iter();
    each.map(|piece| piece.sheet.inspect(64).unwrap().area)
        .sum()
}

#[test]
fn a_hull_plate_has_fans_over_what_no_ruling_touches() {
    let lower = bezier(&[
        [0.0, 0.0, 0.0],
        [800.0, -250.0, 60.0],
        [1900.0, -320.0, 90.0],
        [3000.0, -150.0, 40.0],
    ]);
    let upper = bezier(&[
        [0.0, 120.0, 620.0],
        [900.0, -280.0, 560.0],
        [2000.0, -420.0, 590.0],
        [3000.0, -260.0, 700.0],
    ]);
    let panels = found(&lower, &upper);
    let best = &panels[0];
    let kinds: Vec<PanelKind> = best.pieces.iter().map(|piece| piece.kind).collect();
    assert_eq!(
        kinds,
        [PanelKind::Fan(1), PanelKind::Arc, PanelKind::Fan(1)]
    );
    assert!((best.pieces[0].ranges[1][1] - 0.161_535_915_089_321).abs() < 1e-12);
    assert!((best.pieces[2].ranges[1][0] - 0.951_094_859_976_797).abs() < 1e-12);
    // 1547474 + 150755 + 49936.
    assert!((area(best) - 1_748_165.0).abs() < 1.0, "{}", area(best));
    let [gap, kink] = joints(best);
    assert!(gap < 1e-9 && kink < 1e-4, "{gap:e} {kink:e}");
    assert_eq!((best.folds, best.closed, best.turned), (0, false, false));
}

/// Loops of one curve in planes that lean.
fn reducer() -> [PiecewiseRail; 2] {
    let weights = [1.0, 0.35, 0.7975, 1.08575, 0.7975, 0.35, 1.0];
    let rail = |points: &[Point]| -> PiecewiseRail {
        Rail::weighted(
            torse_geometry::basis::BasisShape::Bernstein,
            points,
            &weights,
        )
        .unwrap()
        .into()
    };
    let a = 93.341_692_789_968_62;
    let b = 98.708_463_949_843_25;
    [
        rail(&[
            [80.0, 0.0, 0.0],
            [80.0, 274.285_714_285_714_3, 0.0],
            [-a, b, 0.0],
            [-110.983_191_342_390_07, 0.0, 0.0],
            [-a, -b, 0.0],
            [80.0, -274.285_714_285_714_3, 0.0],
            [80.0, 0.0, 0.0],
        ]),
        rail(&[
            [70.0, 12.0, 105.0],
            [70.0, 183.428_571_428_571_42, 139.285_714_285_714_28],
            [
                -38.338_557_993_730_39,
                73.692_789_968_652_02,
                84.836_990_595_611_28,
            ],
            [-49.364_494_588_993_79, 12.0, 69.190_651_623_301_86],
            [
                -38.338_557_993_730_39,
                -49.692_789_968_652_03,
                60.159_874_608_150_474,
            ],
            [70.0, -159.428_571_428_571_42, 70.714_285_714_285_72],
            [70.0, 12.0, 105.0],
        ]),
    ]
}

#[test]
fn a_tube_between_closed_rails_closes() {
    let [first, second] = reducer();
    let panels = found(&first, &second);
    let best = &panels[0];
    assert!(best.closed && best.folds == 0, "{best:?}");
    // By an independent solution of 1500 rulings.
    assert!((area(best) - 39_018.3).abs() < 0.1, "{}", area(best));
    let [gap, kink] = joints(best);
    assert!(gap < 1e-6 && kink < 1e-3, "{gap:e} {kink:e}");
    // The other rail drawn the other way: the same tube.
    let turned = &found(&first, &second.reversed().unwrap())[0];
    assert!(turned.turned && (area(turned) - area(best)).abs() < 1e-6 * area(best));
}

#[test]
fn rulings_pass_from_piece_to_piece_of_splines() {
    let through = |points: &[Point]| {
        let ends = [EndCondition::Natural; 2];
        let spline = interpolate(points, Spacing::Chord, ends).unwrap().spline;
        PiecewiseRail::spline(&spline).unwrap()
    };
    let chine = through(&[
        [0.0, 0.0, 0.0],
        [400.0, 180.0, -40.0],
        [900.0, 260.0, -30.0],
        [1500.0, 200.0, 20.0],
    ]);
    let sheer = through(&[
        [0.0, 40.0, 300.0],
        [400.0, 260.0, 260.0],
        [900.0, 330.0, 250.0],
        [1500.0, 260.0, 280.0],
    ]);
    let panels = found(&chine, &sheer);
    let best = &panels[0];
    let [gap, kink] = joints(best);
    assert!(gap < 1e-6 && kink < 1e-3, "{gap:e} {kink:e} {best:?}");
    // The first rail is met by rulings everywhere; of the second the ends are in fans.
    let arcs: Vec<&PanelPiece> = best
        .pieces
        .iter()
        .filter(|piece| piece.kind == PanelKind::Arc)
        .collect();
    let (first, last) = (arcs[0], arcs[arcs.len() - 1]);
    assert!(first.ranges[0][0].abs() < 1e-9 && (last.ranges[0][1] - 1.0).abs() < 1e-9);
    let breaks: Vec<f64> = sheer
        .breaks()
        .iter()
        .map(torse_geometry::Coordinate::approximate)
        .collect();
    let at = |pieces: f64| {
        let k = pieces.floor() as usize;
        breaks[k] + pieces.fract() * (breaks[k + 1] - breaks[k])
    };
    assert!((first.ranges[1][0] - at(0.6569)).abs() < 1e-4, "{first:?}");
    assert!((last.ranges[1][1] - at(2.8536)).abs() < 1e-4, "{last:?}");
}

#[test]
fn a_turn_of_the_solutions_is_passed_by_a_fan() {
    // The flare of a bow: two developables, each of which turns back inside.
    let a = bezier(&[
        [0.0, 0.0, 0.0],
        [150.0, 120.0, 0.0],
        [300.0, -120.0, 0.0],
        [450.0, 0.0, 0.0],
    ]);
    let b = bezier(&[
        [0.0, 20.0, 80.0],
        [160.0, 150.0, 90.0],
        [310.0, -70.0, 85.0],
        [450.0, 60.0, 80.0],
    ]);
    let panels = found(&a, &b);
    for panel in &panels {
        let [gap, kink] = joints(panel);
        assert!(gap < 1e-6 && kink < 1e-3, "{gap:e} {kink:e}");
    }
    let mut inner = panels[0].pieces.iter().skip(1).rev().skip(1);
    assert!(inner.any(|piece| piece.kind != PanelKind::Arc));
}

#[test]
fn two_fans_meet_smoothly_where_one_plane_touches_both_rails() {
    // The tangents at the start of the one and at the end of the other are parallel.
    let a = bezier(&[[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [2.0, 0.0, 0.0]]);
    let b = bezier(&[[0.0, 0.0, 1.0], [1.0, -1.0, 1.0], [2.0, 0.0, 1.0]]);
    for panel in found(&a, &b) {
        assert!(
            panel
                .pieces
                .iter()
                .all(|piece| piece.kind != PanelKind::Arc)
        );
        let [gap, kink] = joints(&panel);
        assert!(gap < 1e-12 && kink < 1e-4, "{gap:e} {kink:e}");
    }
}

#[test]
fn that_there_is_no_panel_is_proved() {
    // Skew lines: every ruling twists.
    let a = bezier(&[[0.0, 0.0, 0.0], [2.0, 0.0, 0.0]]);
    let b = bezier(&[[0.0, 0.0, 1.0], [2.0, 1.0, 1.0]]);
    assert_eq!(
        Sheet::panels(&a, &b).unwrap(),
        Panels::None { ways: vec![] }
    );
}

/// Numbers in [-1, 1] of the generator of Lehmer with the multiplier 48271.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0 * 48_271 % 2_147_483_647;
        2.0 * self.0 as f64 / 2_147_483_647.0 - 1.0
    }

    fn near(&mut self, point: Point, by: Point) -> Point {
        [0, 1, 2].map(|k| point[k] + by[k] * self.next())
    }
}

/// Whether there is a whole panel, found on a grid: `tests/panels/brute.py`.
const BRUTE: &str = include_str!("../panels/brute.csv");

#[test]
fn random_hull_pairs_have_the_panels_that_brute_force_finds() {
    let mut random = Random(1_234_567);
    let (mut whole, mut none, mut undecided) = (0, 0, 0);
    let mut missed = 0;
    for (k, line) in BRUTE.lines().enumerate().take(30) {
        let by = [60.0 * [1.0, 2.0, 4.0][k % 3]; 3];
        let mut rail = |y: f64, z: f64| {
            let points = [
                [0.0, 0.3 * y, z],
                [1000.0, y - 100.0, z + 20.0],
                [2000.0, y - 150.0, z + 30.0],
                [3000.0, y, z],
            ];
            bezier(&points.map(|point| random.near(point, by)))
        };
        let (first, second) = (rail(-100.0, 0.0), rail(-200.0, 550.0));
        match Sheet::panels(&first, &second).unwrap() {
            Panels::Found(panels) => {
                // A panel that the grid is too coarse for is one all the same: what makes it one is looked at here.
                whole += 1;
                for panel in &panels {
                    for piece in &panel.pieces {
                        let sheet = piece.sheet.away_from_apex();
                        let sheet = sheet.unwrap_or_else(|| piece.sheet.clone());
                        assert!(
                            sheet.certify(17).unwrap().is_regular(),
                            "pair {k}: {piece:?}"
                        );
                    }
                    let [gap, kink] = joints(panel);
                    assert!(gap < 1e-5 && kink < 1e-3, "{k}: {gap:e} {kink:e} {panel:?}");
                    let (first, last) = (&panel.pieces[0], &panel.pieces[panel.pieces.len() - 1]);
                    let ends = [first.ranges.map(|r| r[0]), last.ranges.map(|r| r[1])];
                    let end = if panel.turned {
                        [[0.0, 1.0], [1.0, 0.0]]
                    } else {
                        [[0.0; 2], [1.0; 2]]
                    };
                    for (found, wanted) in ends.iter().flatten().zip(end.iter().flatten()) {
                        assert!((found - wanted).abs() < 1e-9, "{k}: {ends:?}");
                    }
                }
            }
            Panels::None { .. } => {
                none += 1;
                assert_eq!(line, "0", "pair {k}");
            }
            Panels::Undecided { .. } => {
                undecided += 1;
                missed += usize::from(line == "1");
            }
        }
    }
    println!("{whole} whole, {none} without, {undecided} undecided");
    assert!(undecided <= 4, "{whole} {none} {undecided}");
    // What brute force finds is found.
    assert_eq!(missed, 0, "{whole} {none} {undecided}");
}

#[test]
fn tubes_between_random_loops_close() {
    let mut random = Random(7_654_321);
    let (mut closed, mut undecided) = (0, 0);
    for k in 0..20 {
        let by = [0.1, 0.25][k % 2];
        let mut image = |rail: &PiecewiseRail| {
            let mut row = |axis: usize| {
                [0, 1, 2].map(|other| f64::from(u8::from(axis == other)) + by * random.next())
            };
            let linear = [row(0), row(1), row(2)];
            let shift = [0, 1, 2].map(|_| 10.0 * random.next());
            rail.mapped(&AffineMap { linear, shift }).unwrap()
        };
        let [first, second] = reducer().each_ref().map(&mut image);
        let Panels::Found(panels) = Sheet::panels(&first, &second).unwrap() else {
            undecided += 1;
            continue;
        };
        closed += 1;
        let best = &panels[0];
        assert!(best.closed && best.folds == 0, "{k}: {best:?}");
        let [gap, kink] = joints(best);
        assert!(gap < 1e-5 && kink < 1e-3, "{k}: {gap:e} {kink:e}");
        for piece in &best.pieces {
            let sheet = piece.sheet.away_from_apex();
            let sheet = sheet.unwrap_or_else(|| piece.sheet.clone());
            assert!(
                sheet.certify(17).unwrap().is_regular(),
                "tube {k}: {piece:?}"
            );
        }
    }
    println!("{closed} closed, {undecided} undecided");
    assert!(undecided <= 1, "{closed} closed, {undecided} undecided");
}

#[test]
fn rails_that_meet_in_a_point_have_the_panel_of_equal_parameters_where_it_is_developable() {
    // Edges of a cylinder with slanting rulings, a gore at both ends; and a fan of it, a tip at one.
    let pairs = [
        [
            bezier(&[
                [0., 0., 0.],
                [30., 40., 10.],
                [70., 40., 10.],
                [100., 0., 0.],
            ]),
            bezier(&[
                [0., 0., 0.],
                [30., -10., 50.],
                [70., -10., 50.],
                [100., 0., 0.],
            ]),
        ],
        [
            bezier(&[[0., 0., 0.], [50., 0., 0.], [100., 0., -40.]]),
            bezier(&[[0., 0., 0.], [50., 50., 0.], [100., 100., -40.]]),
        ],
    ];
    for [first, second] in pairs {
        let panels = found(&first, &second);
        let [panel] = panels.as_slice() else {
            panic!("{panels:?}")
        };
        let [piece] = panel.pieces.as_slice() else {
            panic!("{panel:?}")
        };
        assert_eq!(piece.ranges, [[0.0, 1.0]; 2]);
        // A tip has no normal of its own.
        let inside = piece.sheet.part(0.001, 0.999).unwrap();
        let checked = inside.inspect(64).unwrap();
        assert!(
            checked.certificate.is_regular() && checked.certificate.is_developable_within(1e-12)
        );
    }
    // One control point aside: no developable between equal parameters.
    let first = bezier(&[
        [0., 0., 300.],
        [500., 0., -100.],
        [2500., 0., -100.],
        [3000., 0., 300.],
    ]);
    let second = bezier(&[
        [0., 0., 300.],
        [700., 500., 150.],
        [2300., 500., 150.],
        [3000., 0., 300.],
    ]);
    let answer = Sheet::panels(&first, &second).unwrap();
    assert!(matches!(answer, Panels::Undecided { .. }), "{answer:?}");
    // Rails that cross: the sheet would be on both sides.
    let up = bezier(&[
        [0., 0., 0.],
        [50., 30., 0.],
        [100., -30., 0.],
        [150., 10., 0.],
    ]);
    let down = bezier(&[
        [0., 0., 0.],
        [50., -30., 0.],
        [100., 30., 0.],
        [150., -10., 0.],
    ]);
    assert!(Sheet::panels(&up, &down).is_err());
}
