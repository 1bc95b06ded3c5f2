//! Flat patterns: against closed forms, against integration by another method, and refused where there are none.

use proptest::prelude::*;
use std::f64::consts::PI;
use torse_algebra::{Jet, Scalar};
use torse_geometry::curve::ellipse_arc;
use torse_geometry::pattern::{
    FlatPattern, PatternError, Place, Placement, Segment, Unrolling, deviation, fold, unroll,
};
use torse_geometry::surface::Rails;
use torse_geometry::vector::{norm, sub};
use torse_geometry::{
    Bernstein, Bounds, Curve, EnvelopingPatch, Gbt, GeometryError, PlaneFamily, RuledSurface,
    TangentPatch,
};

/// A patch between two rails given by formulas of the parameter.
struct Formula<F>(F);

impl<F: Fn(Jet<f64>) -> [[Jet<f64>; 3]; 2] + Sync> Rails<f64> for Formula<F> {
    fn rail_jets(&self, x: &f64, order: usize) -> Result<[[Jet<f64>; 3]; 2], GeometryError> {
        Ok((self.0)(Jet::variable(*x, order)))
    }
}

/// Cosine and sine of an angle in radians.
fn turn(angle: &Jet<f64>) -> [Jet<f64>; 2] {
    let quarters = angle.clone() * angle.constant_like(2.0 / PI);
    let (s, c) = quarters.quarter_turn().unwrap();
    [c, s]
}

/// A cone frustum about the z axis: radii, height, swept angle.
fn cone(radii: [f64; 2], height: f64, angle: f64) -> impl Rails<f64> {
    Formula(move |x: Jet<f64>| {
        let [c, s] = turn(&(x.clone() * x.constant_like(angle)));
        let ring = |r: f64, z: f64| {
            [
                c.clone() * x.constant_like(r),
                s.clone() * x.constant_like(r),
                x.constant_like(z),
            ]
        };
        [ring(radii[0], 0.0), ring(radii[1], height)]
    })
}

/// The tangent surface of the helix of radius `a` and pitch `2 pi b`, from `from` to `to` along the unit tangents.
fn helix(a: f64, b: f64, turns: f64, [from, to]: [f64; 2]) -> impl Rails<f64> {
    let speed = a.hypot(b);
    Formula(move |x: Jet<f64>| {
        let number = |v: f64| x.constant_like(v);
        let angle = x.clone() * number(2.0 * PI * turns);
        let [c, s] = turn(&angle);
        let rail = |t: f64| {
            let t = t / speed;
            [
                c.clone() * number(a) - s.clone() * number(a * t),
                s.clone() * number(a) + c.clone() * number(a * t),
                angle.clone() * number(b) + number(b * t),
            ]
        };
        [rail(from), rail(to)]
    })
}

/// A general torse: the tangent surface of the twisted cubic.
fn cubic() -> TangentPatch<Bernstein, f64> {
    let planes = vec![
        [0., 0., 1., 0.],
        [0., -1., 1., 0.],
        [1., -2., 1., 0.],
        [3., -3., 1., 1.],
    ];
    let family = PlaneFamily::new(Bernstein, planes).unwrap();
    TangentPatch::new(family, [0.5, 1.0]).unwrap()
}

/// The largest distance of points of the exact outline from the cut one, and of points of the cut one from the
/// exact one, where `exact` gives the flat ruling of a parameter.
fn true_error(flat: &FlatPattern, exact: &dyn Fn(f64) -> [[f64; 2]; 2]) -> f64 {
    let n = 4000;
    let samples: Vec<_> = (0..=n)
        .map(|i| exact(f64::from(i) / f64::from(n)))
        .collect();
    let mut worst = 0.0_f64;
    for point in samples.iter().flatten() {
        worst = worst.max(flat.outline().distance(*point));
    }
    worst
}

/// The exact flat ruling as seen from the first one, by the apex: polar angles about the image of the apex.
fn flat_cone(radii: [f64; 2], height: f64, angle: f64) -> impl Fn(f64) -> [[f64; 2]; 2] {
    let slant = (radii[1] - radii[0]).hypot(height);
    let sine = (radii[1] - radii[0]) / slant;
    move |x| {
        let turned = x * angle * sine;
        // The apex is at -radii[0]/sine on the first ruling.
        radii.map(|r| {
            let away = r / sine;
            [away * turned.cos() - radii[0] / sine, away * turned.sin()]
        })
    }
}

#[test]
fn a_cone_is_cut_along_exact_arcs_and_its_errors_are_bounded() {
    let (radii, height, angle) = ([1.0, 3.0], 4.0, 1.5 * PI);
    for tolerance in [1e-2, 1e-6, 1e-10] {
        let flat = unroll(&cone(radii, height, angle), 17, tolerance).unwrap();
        let slant = 20_f64.sqrt();
        let sine = 2.0 / slant;
        let errors = flat.errors();
        assert!(errors.outline <= tolerance);
        let worst = true_error(&flat, &flat_cone(radii, height, angle));
        assert!(worst <= errors.outline, "{worst:e} {errors:?}");
        let area = 0.5 * angle * sine * ((3.0 / sine).powi(2) - (1.0 / sine).powi(2));
        assert!((flat.outline().area() - area).abs() <= errors.area);
        assert!((flat.area() - area).abs() < 1e-12);
        let length = angle * (radii[0] + radii[1]) + 2.0 * slant;
        assert!((flat.outline().length() - length).abs() <= errors.length);
        let [short, long] = flat.rail_lengths(0).unwrap();
        assert!((short - angle).abs() < 1e-13 && (long - 3.0 * angle).abs() < 1e-13);
        if tolerance < 1e-3 {
            // 108 degrees, in arcs of at most 92.
            assert_eq!(flat.outline().segments().len(), 6);
            let radius = |i: usize| flat.outline().segments()[i].radius();
            let radii: Vec<f64> = (0..6).map(radius).collect();
            assert!(
                radii.iter().any(|r| (r - 3.0 / sine).abs() < 1e-9),
                "{radii:?}"
            );
            assert!(errors.outline < 1e-11, "{errors:?}");
        }
    }
}

/// Of a helix the tangents develop into the tangents of a circle of radius (a^2 + b^2)/a.
fn flat_helix(a: f64, b: f64, turns: f64, range: [f64; 2]) -> impl Fn(f64) -> [[f64; 2]; 2] {
    let radius = (a * a + b * b) / a;
    let speed = a.hypot(b);
    move |x| {
        let turned = 2.0 * PI * turns * x * speed / radius;
        // At x = 0 the tangent runs along the first axis from (-range[0], 0).
        let (s, c) = turned.sin_cos();
        range.map(|t| [radius * s + t * c - range[0], radius * (1.0 - c) + t * s])
    }
}

#[test]
fn a_helix_tangent_surface_develops_into_tangents_of_a_circle() {
    let (a, b, turns, range) = (1.0, 0.5, 0.8, [0.5, 2.0]);
    for tolerance in [1e-1, 1e-3, 1e-6, 1e-9] {
        let flat = unroll(&helix(a, b, turns, range), 17, tolerance).unwrap();
        let errors = flat.errors();
        assert!(errors.outline <= tolerance);
        let exact = flat_helix(a, b, turns, range);
        let worst = true_error(&flat, &exact);
        assert!(worst <= errors.outline, "{worst:e} {errors:?}");
        // The bound is not idle: within a factor of fifty of the truth.
        assert!(
            errors.outline < 50.0 * worst.max(1e-12),
            "{worst:e} {errors:?}"
        );
        for ruling in flat.rulings() {
            for (end, point) in ruling.ends.iter().zip(exact(ruling.x)) {
                assert!(norm(&sub(end, &point)) <= errors.point);
            }
            // The edge of regression is that circle.
            let [x, y] = ruling.regression.unwrap();
            let radius = (a * a + b * b) / a;
            assert!(((x + range[0]).hypot(y - radius) - radius).abs() < 1e-6);
        }
    }
}

/// Gauss-Legendre with three nodes on many intervals, in plain steps: another method than the library's.
fn integrated(patch: &impl Rails<f64>, steps: usize) -> Vec<[[f64; 2]; 2]> {
    let frame = |x: f64| {
        let [p, q] = patch.rail_jets(&x, 1).unwrap();
        let value = |j: &[Jet<f64>; 3], n: usize| j.each_ref().map(|c| c.coefficients()[n]);
        let (dp, dq) = (value(&p, 1), value(&q, 1));
        let ruling = sub(&value(&q, 0), &value(&p, 0));
        let length = norm(&ruling);
        let r = ruling.map(|c| c / length);
        // Gram and Schmidt, not the normal.
        let dot = |a: &[f64; 3], b: &[f64; 3]| (0..3).map(|i| a[i] * b[i]).sum::<f64>();
        let along = dot(&dp, &r);
        let rest: [f64; 3] = std::array::from_fn(|i| dp[i] - along * r[i]);
        let across = norm(&rest);
        let t = rest.map(|c| c / across);
        (dot(&sub(&dq, &dp), &t) / length, along, across, length)
    };
    let nodes = [-0.6_f64.sqrt(), 0.0, 0.6_f64.sqrt()];
    let weights = [5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0];
    let (mut theta, mut p) = (0.0_f64, [0.0_f64; 2]);
    let h = 1.0 / steps as f64;
    let mut out = Vec::new();
    for step in 0..=steps {
        let x = step as f64 * h;
        let length = frame(x).3;
        out.push([
            p,
            [p[0] + length * theta.cos(), p[1] + length * theta.sin()],
        ]);
        if step == steps {
            break;
        }
        let at = nodes.map(|n| frame(x + 0.5 * h * (1.0 + n)));
        // theta at the nodes by the collocation matrix of the same rule.
        let root = 15.0_f64.sqrt();
        let matrix = [
            [
                5.0 / 36.0,
                2.0 / 9.0 - root / 15.0,
                5.0 / 36.0 - root / 30.0,
            ],
            [
                5.0 / 36.0 + root / 24.0,
                2.0 / 9.0,
                5.0 / 36.0 - root / 24.0,
            ],
            [
                5.0 / 36.0 + root / 30.0,
                2.0 / 9.0 + root / 15.0,
                5.0 / 36.0,
            ],
        ];
        for (i, row) in matrix.iter().enumerate() {
            let inner = theta + h * (0..3).map(|j| row[j] * at[j].0).sum::<f64>();
            let (s, c) = inner.sin_cos();
            p[0] += h * weights[i] * (at[i].1 * c - at[i].2 * s);
            p[1] += h * weights[i] * (at[i].1 * s + at[i].2 * c);
        }
        theta += h * (0..3).map(|j| weights[j] * at[j].0).sum::<f64>();
    }
    out
}

#[test]
fn a_general_torse_agrees_with_another_integration_within_its_stated_error() {
    let patch = cubic();
    let exact = integrated(&patch, 400);
    for tolerance in [1e-2, 1e-4, 1e-7] {
        let flat = unroll(&patch, 401, tolerance).unwrap();
        let errors = flat.errors();
        assert!(errors.outline <= tolerance && flat.strain() < 1e-15);
        let mut worst = [0.0_f64; 2];
        for (ruling, ends) in flat.rulings().iter().zip(&exact) {
            for (end, point) in ruling.ends.iter().zip(ends) {
                worst[0] = worst[0].max(norm(&sub(end, point)));
                worst[1] = worst[1].max(flat.outline().distance(*point));
            }
        }
        assert!(worst[0] <= errors.point + 1e-12, "{worst:?} {errors:?}");
        assert!(worst[1] <= errors.outline + 1e-12, "{worst:?} {errors:?}");
        assert!(worst[0] < 1e-9);
    }
}

#[test]
fn a_cone_of_planes_unrolls_about_the_image_of_its_apex() {
    // gbt-developable Example 4.2: all planes pass through (0, 0, 25).
    let h = 5.0 * 2_f64.sqrt();
    let planes = vec![
        [h, -h, 5.0, 125.0],
        [-h, -h, 5.0, 125.0],
        [-h, h, 5.0, 125.0],
        [h, h, 5.0, 125.0],
    ];
    let family = PlaneFamily::new(Gbt::new(0.5, 0.5).unwrap(), planes).unwrap();
    let cuts = Bounds::Planes([[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 1.0, 5.0]]);
    let patch = EnvelopingPatch::new(family, cuts).unwrap();
    let flat = unroll(&patch, 65, 1e-8).unwrap();
    let apex = [0.0, 0.0, 25.0];
    let first = flat.rulings()[0].regression.unwrap();
    for ruling in flat.rulings() {
        let image = ruling.regression.unwrap();
        assert!(norm(&sub(&image, &first)) < 1e-7);
        let ends = patch.ruling_ends(&ruling.x).unwrap();
        for (flat, space) in ruling.ends.iter().zip(&ends) {
            let distance = norm(&sub(flat, &first));
            assert!((distance - norm(&sub(&apex, space))).abs() < 1e-7);
        }
    }
}

#[test]
fn what_cannot_be_cut_from_a_sheet_is_refused_with_numbers() {
    // A helix patch that turns by more than a full turn overlaps itself.
    let round = unroll(&helix(1.0, 0.5, 1.5, [0.5, 1.0]), 17, 1e-4);
    assert!(
        matches!(round, Err(PatternError::CrossesItself { .. })),
        "{round:?}"
    );
    // Across its edge of regression, at t = 0 a quarter of the way.
    let across = unroll(&helix(1.0, 0.5, 0.3, [-1.0, 3.0]), 17, 1e-4);
    let Err(PatternError::Regression { v, depth, .. }) = across else {
        panic!("{across:?}");
    };
    assert!((v - 0.25).abs() < 1e-9 && (depth - 1.0).abs() < 1e-9);
    // A billionth inside is inside, a billionth outside is outside, and on the edge is a sheet.
    let edge = |from: f64| unroll(&helix(1.0, 0.5, 0.3, [from, 1.0]), 17, 1e-4);
    assert!(matches!(edge(-1e-9), Err(PatternError::Regression { .. })));
    assert!(edge(1e-9).is_ok() && edge(0.0).is_ok());
    // A saddle.
    let rail = |points: [[f64; 3]; 2]| Curve::new(Bernstein, points.to_vec()).unwrap();
    let saddle = RuledSurface::new(
        rail([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]),
        rail([[0.0, 1.0, 0.0], [1.0, 1.0, 1.0]]),
    );
    let Err(PatternError::NotDevelopable {
        strain,
        twist,
        limit,
        ..
    }) = unroll(&saddle, 17, 1e-6)
    else {
        panic!("a saddle");
    };
    assert!(limit == 1e-6 && strain > 1e-3 && twist > 0.1);
    let allowed = Unrolling::within(1e-6)
        .allow_strain(0.5)
        .of(&saddle)
        .unwrap();
    assert!(allowed.is_strained() && allowed.strain() > 0.05);
    // A cusp: the first rail and the second turn back together.
    let cusp = |z: f64| {
        let points = vec![
            [1., -1., z],
            [-1. / 3., 1., z],
            [-1. / 3., -1., z],
            [1., 1., z],
        ];
        Curve::new(Bernstein, points).unwrap()
    };
    let cusp = unroll(&RuledSurface::new(cusp(0.0), cusp(1.0)), 17, 1e-4);
    assert!(
        matches!(cusp, Err(PatternError::NoTangentPlane { x }) if (x - 0.5).abs() < 1e-6),
        "{cusp:?}"
    );
    // No width.
    let line = rail([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]);
    let none = unroll(&RuledSurface::new(line.clone(), line), 17, 1e-4);
    assert_eq!(none, Err(PatternError::NoRuling { x: 0.0 }));
}

/// The strain-free patches of these tests with a name.
fn patches() -> Vec<(&'static str, FlatPattern)> {
    vec![
        (
            "cone",
            unroll(&cone([1.0, 3.0], 4.0, 4.0), 33, 1e-6).unwrap(),
        ),
        (
            "inverted cone",
            unroll(&cone([3.0, 1.0], 1.0, 3.0), 33, 1e-6).unwrap(),
        ),
        (
            "helix",
            unroll(&helix(1.0, 0.5, 0.8, [0.5, 2.0]), 33, 1e-6).unwrap(),
        ),
        ("cubic", unroll(&cubic(), 33, 1e-6).unwrap()),
    ]
}

#[test]
fn points_go_to_the_sheet_and_back_and_distances_along_rulings_stay() {
    for (name, flat) in patches() {
        let placement = Placement::mirrored()
            .then(&Placement::turned(0.7))
            .then(&Placement::shifted([3.0, -8.0]));
        for flat in [flat.clone(), flat.placed(&placement)] {
            for (i, j) in [
                (0, 0),
                (0, 4),
                (3, 1),
                (5, 4),
                (8, 0),
                (8, 4),
                (2, 2),
                (7, 3),
            ] {
                let place = Place {
                    piece: 0,
                    x: f64::from(i) / 8.0,
                    v: f64::from(j) / 4.0,
                };
                let (sheet, space) = (flat.flatten(place).unwrap(), flat.space(place).unwrap());
                let lifted = flat.lift(sheet).unwrap();
                assert!(norm(&sub(&lifted, &space)) < 1e-9, "{name} {place:?}");
                let found = flat.locate_in_space(space, 1e-6).unwrap();
                assert!(
                    (found.x - place.x).abs() < 1e-7 && (found.v - place.v).abs() < 1e-7,
                    "{name} {found:?}"
                );
                let start = Place { v: 0.0, ..place };
                let (a, b) = (flat.flatten(start).unwrap(), flat.space(start).unwrap());
                let change = norm(&sub(&sheet, &a)) - norm(&sub(&space, &b));
                assert!(change.abs() < 1e-9, "{name}");
            }
            assert_eq!(flat.lift([100.0, 100.0]), None);
            assert_eq!(flat.locate_in_space([100.0; 3], 1.0), None);
            assert_eq!(
                flat.flatten(Place {
                    piece: 1,
                    x: 0.5,
                    v: 0.5
                }),
                None
            );
            assert_eq!(
                flat.space(Place {
                    piece: 0,
                    x: f64::NAN,
                    v: 0.5
                }),
                None
            );
        }
    }
}

#[test]
fn lengths_of_curves_on_the_patch_stay_on_the_sheet() {
    for (name, flat) in patches() {
        let curve = |t: f64| [0.1 + 0.8 * t, 0.5 + 0.4 * (5.0 * t).sin()];
        let n = 20_000;
        let (mut sheet, mut space) = (0.0, 0.0);
        let at = |i: i32| {
            let [x, v] = curve(f64::from(i) / f64::from(n));
            let place = Place { piece: 0, x, v };
            (flat.flatten(place).unwrap(), flat.space(place).unwrap())
        };
        for i in 0..n {
            let (a, b) = (at(i), at(i + 1));
            sheet += norm(&sub(&b.0, &a.0));
            space += norm(&sub(&b.1, &a.1));
        }
        assert!(
            (sheet - space).abs() < 1e-7 * space,
            "{name}: {sheet} {space}"
        );
        let carried = flat.carry(0, curve, 1e-3).unwrap();
        for i in (0..n).step_by(97) {
            let (point, _) = at(i);
            let near = carried
                .windows(2)
                .map(|w| Segment::line(w[0], w[1]).distance(point))
                .fold(f64::INFINITY, f64::min);
            assert!(near < 2e-3, "{name}: {near:e}");
        }
        assert!(flat.carry(0, |t| [2.0 * t, 0.5], 1e-3).is_err());
    }
}

#[test]
fn folding_the_drawing_alone_rebuilds_the_patch_with_an_error_that_falls_by_four() {
    let deviations = |patch: &dyn Rails<f64>| {
        [17, 33, 65, 129].map(|n| unroll(patch, n, 1e-7).unwrap().fold_deviation().unwrap())
    };
    for (name, list) in [
        ("cone", deviations(&cone([1.0, 3.0], 4.0, 4.0))),
        ("helix", deviations(&helix(1.0, 0.5, 0.8, [0.5, 2.0]))),
        ("cubic", deviations(&cubic())),
    ] {
        for pair in list.windows(2) {
            let ratio = pair[0] / pair[1];
            assert!((3.5..4.5).contains(&ratio), "{name}: {list:?}");
        }
        assert!(list[3] < 2e-3, "{name}: {list:?}");
    }
}

#[test]
fn a_pattern_turned_over_folds_to_the_same_body() {
    for (name, flat) in patches() {
        let over = flat.placed(&Placement::mirrored().then(&Placement::turned(1.0)));
        let (a, b) = (
            flat.fold_deviation().unwrap(),
            over.fold_deviation().unwrap(),
        );
        assert!((a - b).abs() < 1e-9, "{name}: {a} {b}");
        // With bends the wrong way it does not.
        let ends: Vec<_> = flat.rulings().iter().map(|r| r.ends).collect();
        let wrong: Vec<_> = flat.rulings().iter().map(|r| -r.bend).collect();
        let folded: Vec<_> = fold(&ends, &wrong).unwrap().into_iter().flatten().collect();
        let design: Vec<_> = flat.rulings_in_space().into_iter().flatten().collect();
        assert!(deviation(&folded, &design).unwrap() > 0.05, "{name}");
    }
}

/// The part of a patch between two parameters, perhaps with its rails exchanged or run backwards.
struct Part<'a> {
    whole: &'a dyn Rails<f64>,
    range: [f64; 2],
    exchanged: bool,
}

impl Rails<f64> for Part<'_> {
    fn rail_jets(&self, x: &f64, order: usize) -> Result<[[Jet<f64>; 3]; 2], GeometryError> {
        let [from, to] = self.range;
        let [p, q] = self.whole.rail_jets(&(from + x * (to - from)), order)?;
        let stretched = |jet: Jet<f64>| {
            let mut power = 1.0;
            let mut list = jet.coefficients().iter().map(|c| {
                let value = c * power;
                power *= to - from;
                value
            });
            let first = list.next().unwrap();
            Jet::from_coefficients(first, list.collect::<Vec<_>>())
        };
        let (p, q) = (p.map(stretched), q.map(stretched));
        Ok(if self.exchanged { [q, p] } else { [p, q] })
    }
}

#[test]
fn a_chain_of_parts_is_the_pattern_of_the_whole_however_the_parts_are_run() {
    let whole = helix(1.0, 0.5, 0.8, [0.5, 2.0]);
    let flat = unroll(&whole, 33, 1e-8).unwrap();
    let part = |range, exchanged| {
        unroll(
            &Part {
                whole: &whole,
                range,
                exchanged,
            },
            17,
            1e-8,
        )
        .unwrap()
    };
    for (first, second) in [
        (part([0.0, 0.5], false), part([0.5, 1.0], false)),
        (part([0.0, 0.5], false), part([0.5, 1.0], true)),
        (part([0.0, 0.5], true), part([1.0, 0.5], false)),
        (part([0.5, 0.0], false), part([1.0, 0.5], true)),
        (part([0.5, 1.0], true), part([0.0, 0.5], true)),
        (part([0.5, 1.0], false), part([0.5, 0.0], true)),
    ] {
        let chain = first.append(&second, 1e-9).unwrap();
        assert_eq!((chain.pieces(), chain.rulings().len()), (2, 33));
        assert!((chain.outline().area() - flat.outline().area()).abs() < 1e-7);
        assert!((chain.outline().length() - flat.outline().length()).abs() < 1e-6);
        assert!(chain.errors().outline < 1e-7);
        // Folded it is the whole again, and the joint is bent like its neighbours.
        let (a, b) = (
            chain.fold_deviation().unwrap(),
            flat.fold_deviation().unwrap(),
        );
        assert!((a - b).abs() < 1e-6, "{a} {b}");
        let bends: Vec<f64> = chain.rulings().iter().map(|r| r.bend).collect();
        assert!(
            (bends[16] - bends[15]).abs() < 1e-3 * bends[16].abs(),
            "{bends:?}"
        );
        // A point of the second part comes back from the sheet.
        let place = Place {
            piece: 1,
            x: 0.3,
            v: 0.4,
        };
        let lifted = chain.lift(chain.flatten(place).unwrap()).unwrap();
        assert!(norm(&sub(&lifted, &chain.space(place).unwrap())) < 1e-9);
    }
    let (near, far) = (part([0.0, 0.5], false), part([0.6, 1.0], false));
    assert!(matches!(
        near.append(&far, 1e-6),
        Err(PatternError::NoCommonRuling { distance, .. }) if distance > 0.1
    ));
    // Two three-quarter turns overlap.
    let long = |range| Part {
        whole: &whole,
        range,
        exchanged: false,
    };
    let twice = unroll(&long([0.0, 0.9]), 9, 1e-4)
        .unwrap()
        .append(&unroll(&long([0.9, 1.7]), 9, 1e-4).unwrap(), 1e-6);
    assert!(
        matches!(twice, Err(PatternError::CrossesItself { .. })),
        "{twice:?}"
    );
}

#[test]
fn a_cone_with_its_apex_has_a_sector_as_pattern() {
    let sector = unroll(&cone([0.0, 1.5], 2.0, 2.0), 9, 1e-6).unwrap();
    let segments = sector.outline().segments();
    assert!(segments.iter().all(|s| s.chord_length() > 0.0));
    assert!((sector.outline().area() - 0.5 * 2.0 * 1.5 * 2.5).abs() < 1e-12);
    assert!(sector.smallest_radius() < 1e-9);
}

#[test]
fn scaling_and_moving_a_design_scales_the_pattern() {
    let plain = unroll(&helix(1.0, 0.5, 0.8, [0.5, 2.0]), 9, 1e-6).unwrap();
    for scale in [1e-150, 1e-12, 1e12, 1e150] {
        let large = unroll(
            &helix(scale, 0.5 * scale, 0.8, [0.5 * scale, 2.0 * scale]),
            9,
            1e-6 * scale,
        )
        .unwrap();
        for (a, b) in plain.rulings().iter().zip(large.rulings()) {
            for (p, q) in a.ends.iter().zip(&b.ends) {
                assert!(norm(&sub(p, &q.map(|c| c / scale))) < 1e-12, "{scale:e}");
            }
        }
    }
}

fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        -10.0..10.0_f64,
        Just(0.0),
        Just(f64::NAN),
        Just(1e300),
        Just(-1e-300),
        prop::num::f64::ANY
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_patch_is_refused_or_has_a_finite_pattern(
        p in prop::collection::vec(prop::array::uniform3(coordinate()), 2..5),
        q in prop::collection::vec(prop::array::uniform3(coordinate()), 2..5),
    ) {
        let (Ok(p), Ok(q)) = (Curve::new(Bernstein, p), Curve::new(Bernstein, q)) else { return Ok(()) };
        let patch = RuledSurface::new(p, q);
        for demand in [Unrolling::within(1e-3), Unrolling::within(1e-3).allow_strain(0.999)] {
            if let Ok(flat) = demand.rulings(5).of(&patch) {
                let e = flat.errors();
                let numbers = [e.outline, e.point, e.angle, e.length, e.area, flat.strain(), flat.area()];
                prop_assert!(numbers.iter().all(|v| v.is_finite() && *v >= 0.0), "{numbers:?}");
                let vertices: Vec<_> = flat.outline().vertices().collect();
                prop_assert!(vertices.iter().all(|(p, b)| p.iter().all(|c| c.is_finite()) && b.is_finite()));
                prop_assert!(flat.outline().area() > 0.0);
                prop_assert!(e.outline <= 1e-3);
            }
        }
    }

    #[test]
    fn cones_of_any_shape_unroll_within_their_errors(
        small in 0.1..2.0_f64, more in 0.1..3.0_f64, height in -3.0..3.0_f64, angle in 0.2..3.0_f64, digits in 2..9_i32,
    ) {
        let (radii, tolerance) = ([small, small + more], 10.0_f64.powi(-digits));
        let flat = unroll(&cone(radii, height, angle), 9, tolerance).unwrap();
        let worst = true_error(&flat, &flat_cone(radii, height, angle));
        prop_assert!(worst <= flat.errors().outline, "{worst:e} {:?}", flat.errors());
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_narrow_ridge_is_seen_and_its_length_is_right(
        centre in 0.0..1.0_f64, digits in 1.0..2.5_f64, height in 0.05..0.5_f64,
    ) {
        // A cylinder over the graph of height/(1 + ((x - centre)/width)^2).
        let width = 10.0_f64.powf(-digits);
        let ridge = Formula(|x: Jet<f64>| {
            let number = |v: f64| x.constant_like(v);
            let t = (x.clone() - number(centre)) * number(1.0 / width);
            let z = number(height).divided_by(&(number(1.0) + t.clone() * t)).unwrap();
            [[x.clone(), number(0.0), z.clone()], [x.clone(), number(1.0), z]]
        });
        let flat = unroll(&ridge, 5, 1e-5).unwrap();
        let n = 400_000;
        let z = |i: i32| height / (1.0 + ((f64::from(i) / f64::from(n) - centre) / width).powi(2));
        let length: f64 = (0..n).map(|i| (1.0 / f64::from(n)).hypot(z(i + 1) - z(i))).sum();
        let [first, second] = flat.rail_lengths(0).unwrap();
        prop_assert!((first - length).abs() < 1e-6 && (second - length).abs() < 1e-6, "{first} {length}");
        let errors = flat.errors();
        prop_assert!((flat.outline().length() - 2.0 * (1.0 + length)).abs() < errors.length + 1e-6);
    }
}

#[test]
fn the_tangents_of_the_twisted_cubic_lie_where_integration_with_fifty_digits_puts_them() {
    // By the curvature of the spine, not by its surface: the flat spine has the curvature k of (t, t^2, t^3) in
    // space, so theta' = k |S'| = |S' x S''|/|S'|^2 and p = integral of |S'| e(theta) + c |S'| e(theta), less
    // its value at 0. Gauss-Legendre with 24 nodes on 8 and on 12 intervals, 50 digits, agreeing in 30.
    let table = [
        (
            0.5,
            [0.462_114_034_492_831_6, 0.938_305_263_342_41],
            [0.931_089_651_965_384_2, 1.586_909_048_573_608_1],
        ),
        (
            1.0,
            [0.588_210_316_667_887_1, 3.347_126_252_073_886_6],
            [0.811_958_542_402_306_3, 5.204_526_782_783_593],
        ),
    ];
    for tolerance in [1e-3, 1e-6, 1e-9] {
        let flat = unroll(&cubic(), 9, tolerance).unwrap();
        let errors = flat.errors();
        for (x, p, q) in table {
            for (v, exact) in [(0.0, p), (1.0, q)] {
                let point = flat.flatten(Place { piece: 0, x, v }).unwrap();
                let off = norm(&sub(&point, &exact));
                assert!(off <= errors.point, "x = {x}: {off:e} {errors:?}");
                assert!(flat.outline().distance(exact) <= errors.outline);
            }
        }
    }
}

#[test]
fn triangles_between_cones_are_one_outline() {
    // A quarter of a transition from a square to a circle: the corner of the triangle is a rail without length.
    let cone = RuledSurface::new(
        ellipse_arc(&[75.0, 75.0, 0.0], &[100.0, 75.0, 0.0], &[75.0, 100.0, 0.0]).unwrap(),
        ellipse_arc(&[0.0, 0.0, 130.0], &[60.0, 0.0, 130.0], &[0.0, 60.0, 130.0]).unwrap(),
    );
    let rail = |a: [f64; 3], b: [f64; 3]| Curve::new(Bernstein, vec![a, b]).unwrap();
    let top = [0.0, 60.0, 130.0];
    let triangle = RuledSurface::new(
        rail([75.0, 100.0, 0.0], [-75.0, 100.0, 0.0]),
        rail(top, top),
    );
    let next = RuledSurface::new(
        ellipse_arc(
            &[-75.0, 75.0, 0.0],
            &[-75.0, 100.0, 0.0],
            &[-100.0, 75.0, 0.0],
        )
        .unwrap(),
        ellipse_arc(
            &[0.0, 0.0, 130.0],
            &[0.0, 60.0, 130.0],
            &[-60.0, 0.0, 130.0],
        )
        .unwrap(),
    );
    let [first, second, third] = [
        unroll(&cone, 9, 1e-3).unwrap(),
        unroll(&triangle, 9, 1e-3).unwrap(),
        unroll(&next, 9, 1e-3).unwrap(),
    ];
    let chain = first
        .append(&second, 1e-6)
        .unwrap()
        .append(&third, 1e-6)
        .unwrap();
    let area = first.area() + second.area() + third.area();
    assert!((chain.outline().area() - area).abs() <= chain.errors().area);
    let segments = chain.outline().segments();
    assert!(segments.iter().all(|s| s.chord_length() > 1e-9));
    let ends = segments.iter().zip(segments.iter().cycle().skip(1));
    assert!(ends.into_iter().all(|(a, b)| a.to == b.from));
}
