//! Patterns of cones, cylinders, helices and a general torse: against closed forms, another integration and fifty digits.

use crate::support::{Formula, cone, cubic, helix, unroll};
use std::f64::consts::PI;
use torse_algebra::Jet;
use torse_geometry::curve::ellipse_arc;
use torse_geometry::pattern::{FlatPattern, PatternPlace};
use torse_geometry::surface::Rails;
use torse_geometry::vector::{norm, sub};
use torse_geometry::{EnvelopingPatch, Gbt, PatchBounds, PlaneFamily, RuledSurface};

/// The largest distance of points of the exact outline from the cut one, and of points of the cut one from the
/// exact one, where `exact` gives the flat ruling of a parameter.
pub fn true_error(flat: &FlatPattern, exact: &Exact) -> f64 {
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
pub fn flat_cone(radii: [f64; 2], height: f64, angle: f64) -> impl Fn(f64) -> [[f64; 2]; 2] {
    let slant = libm::hypot(radii[1] - radii[0], height);
    let sine = (radii[1] - radii[0]) / slant;
    move |x| {
        let turned = x * angle * sine;
        // The apex is at -radii[0]/sine on the first ruling.
        radii.map(|r| {
            let away = r / sine;
            [
                away * libm::cos(turned) - radii[0] / sine,
                away * libm::sin(turned),
            ]
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
            // What is proved counts each rounding of f64 at its worst, and they never all agree: the true error is a hundredth.
            assert!(errors.outline < 1e-10, "{errors:?}");
        }
    }
}

/// Of a helix the tangents develop into the tangents of a circle of radius (a^2 + b^2)/a.
fn flat_helix(a: f64, b: f64, turns: f64, range: [f64; 2]) -> impl Fn(f64) -> [[f64; 2]; 2] {
    let radius = (a * a + b * b) / a;
    let speed = libm::hypot(a, b);
    move |x| {
        let turned = 2.0 * PI * turns * x * speed / radius;
        // At x = 0 the tangent runs along the first axis from (-range[0], 0).
        let (s, c) = libm::sincos(turned);
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
        // The bound is not idle: within a factor of fifty of the truth, down to what roundings that all agree would make.
        assert!(
            errors.outline < 50.0 * worst.max(1e-11),
            "{worst:e} {errors:?}"
        );
        for ruling in flat.rulings() {
            for (end, point) in ruling.ends.iter().zip(exact(ruling.x)) {
                assert!(norm(&sub(end, &point)) <= errors.point);
            }
            // The edge of regression is that circle.
            let [x, y] = ruling.regression.unwrap();
            let radius = (a * a + b * b) / a;
            assert!((libm::hypot(x + range[0], y - radius) - radius).abs() < 1e-6);
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
            [
                p[0] + length * libm::cos(theta),
                p[1] + length * libm::sin(theta),
            ],
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
            let (s, c) = libm::sincos(inner);
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
    let cuts = PatchBounds::Planes([[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 1.0, 5.0]]);
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
fn a_cone_with_its_apex_has_a_sector_as_pattern() {
    let sector = unroll(&cone([0.0, 1.5], 2.0, 2.0), 9, 1e-6).unwrap();
    let segments = sector.outline().segments();
    assert!(segments.iter().all(|s| s.chord_length() > 0.0));
    assert!((sector.outline().area() - 0.5 * 2.0 * 1.5 * 2.5).abs() < 1e-12);
    assert!(sector.smallest_radius() < 1e-9);
}

/// Flat rulings `(x, P, Q)` of the tangents of the twisted cubic, by the curvature of the spine, not by its surface: the
/// flat spine has the curvature k of (t, t^2, t^3) in space, so theta' = k |S'| = |S' x S''|/|S'|^2 and p = integral of
/// |S'| e(theta) + c |S'| e(theta), less its value at 0. Gauss-Legendre with 24 nodes on 8 and on 12 intervals, 50 digits,
/// agreeing in 30.
const CUBIC: [(f64, [f64; 2], [f64; 2]); 2] = [
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

#[test]
fn the_tangents_of_the_twisted_cubic_lie_where_integration_with_fifty_digits_puts_them() {
    for tolerance in [1e-3, 1e-6, 1e-9] {
        let flat = unroll(&cubic(), 9, tolerance).unwrap();
        let errors = flat.errors();
        for (x, p, q) in CUBIC {
            for (v, exact) in [(0.0, p), (1.0, q)] {
                let point = flat.flatten(PatternPlace { piece: 0, x, v }).unwrap();
                let off = norm(&sub(&point, &exact));
                assert!(off <= errors.point, "x = {x}: {off:e} {errors:?}");
                assert!(flat.outline().distance(exact) <= errors.outline);
            }
        }
    }
}

/// The exact pattern of the quarter of a circular cylinder.
fn flat_cylinder(radius: f64, height: f64) -> impl Fn(f64) -> [[f64; 2]; 2] {
    move |x| [0.0, height].map(|along| [along, 0.5 * PI * radius * x])
}

/// The exact flat ruling of a parameter.
type Exact = dyn Fn(f64) -> [[f64; 2]; 2];

/// `cargo test -p torse-geometry --test geometry -- stated_error --nocapture` shows the table.
#[test]
fn the_stated_error_is_never_smaller_than_the_true_one() {
    let ring = |z: f64| ellipse_arc(&[0.0, 0.0, z], &[2.0, 0.0, z], &[0.0, 2.0, z]).unwrap();
    let cylinder = RuledSurface::new(ring(0.0), ring(3.0));
    let (radii, height, angle) = ([1.0, 3.0], 4.0, 4.0);
    let (a, b, turns, range) = (1.0, 0.5, 0.8, [0.5, 2.0]);
    println!("patch     asked   segments  stated   true     bound of lengths  of area");
    for tolerance in [1e-2, 1e-4, 1e-6, 1e-8, 1e-10] {
        let known: [(_, _, &Exact); 3] = [
            (
                "cylinder",
                unroll(&cylinder, 9, tolerance),
                &flat_cylinder(2.0, 3.0),
            ),
            (
                "cone",
                unroll(&cone(radii, height, angle), 9, tolerance),
                &flat_cone(radii, height, angle),
            ),
            (
                "helix",
                unroll(&helix(a, b, turns, range), 9, tolerance),
                &flat_helix(a, b, turns, range),
            ),
        ];
        let mut rows: Vec<_> = known
            .into_iter()
            .map(|(name, flat, exact)| {
                let flat = flat.unwrap();
                let true_one = true_error(&flat, exact);
                (name, flat, true_one)
            })
            .collect();
        let flat = unroll(&cubic(), 9, tolerance).unwrap();
        let off = |point: [f64; 2]| flat.outline().distance(point);
        let true_one = CUBIC.iter().flat_map(|(_, p, q)| [off(*p), off(*q)]);
        let true_one = true_one.fold(0.0, f64::max);
        rows.push(("torse", flat, true_one));
        for (name, flat, true_one) in rows {
            let (errors, count) = (flat.errors(), flat.outline().segments().len());
            println!(
                "{name:<9} {tolerance:<7.0e} {count:<9} {:<8.1e} {true_one:<8.1e} {:<17.1e} {:.1e}",
                errors.outline, errors.length, errors.area
            );
            assert!(
                true_one <= errors.outline && errors.outline <= tolerance,
                "{name}"
            );
        }
    }
}

#[test]
fn spikes_as_narrow_as_polynomials_have_them_are_seen() {
    // The cylinder over y = h b(x)/b(k/n), with b the Bernstein polynomial k of the largest degree there is: a spike with
    // a standard deviation of 1/128 at most.
    let n = 4096_u32;
    let power = |base: &Jet<f64>, exponent: u32| {
        let (mut result, mut square) = (base.constant_like(1.0), base.clone());
        let mut rest = exponent;
        while rest > 0 {
            if rest % 2 == 1 {
                result = result * square.clone();
            }
            square = square.clone() * square;
            rest /= 2;
        }
        result
    };
    // In 64 factors, none of which leaves the range of numbers.
    let spike = |x: &Jet<f64>, k: u32| {
        let top = f64::from(k) / f64::from(n);
        let rise = x.clone() * x.constant_like(1.0 / top);
        let fall = (x.constant_like(1.0) - x.clone()) * x.constant_like(1.0 / (1.0 - top));
        let part = power(&rise, k / 64) * power(&fall, (n - k) / 64);
        power(&part, 64)
    };
    let mut made = 0;
    for k in [256_u32, 1088, 1152, 1408, 2048, 3776] {
        // Of the graph by a polygon within 12 standard deviations; outside it is flat.
        let top = f64::from(k) / f64::from(n);
        let wide = 12.0 * (top * (1.0 - top) / f64::from(n)).sqrt();
        let (from, to) = ((top - wide).max(0.0), (top + wide).min(1.0));
        let steps = 1 << 16;
        let step = (to - from) / f64::from(steps);
        let graph: Vec<f64> = (0..=steps)
            .map(|i| *spike(&Jet::variable(from + step * f64::from(i), 0), k).value())
            .collect();
        for height in [1e-3, 0.1, 1.0, 30.0] {
            let patch = Formula(|x: Jet<f64>| {
                let y = spike(&x, k) * x.constant_like(height);
                [0.0, 1.0].map(|z| [x.clone(), y.clone(), x.constant_like(z)])
            });
            let sides = graph
                .windows(2)
                .map(|w| libm::hypot(step, height * (w[1] - w[0])));
            let length = 1.0 - (to - from) + sides.sum::<f64>();
            for (tolerance, rulings) in [(0.1, 2), (1e-2, 9), (1e-5, 33)] {
                let flat = unroll(&patch, rulings, tolerance).unwrap();
                let [x, y] = flat.rulings().last().unwrap().ends[0];
                let off = libm::hypot(x, y - length);
                // The polygon cuts off the tops.
                let bound = flat.errors().point + 1e-6 * height.max(1.0);
                assert!(off <= bound, "{k} {height} {tolerance}: {off:e} {bound:e}");
                made += 1;
            }
        }
    }
    assert_eq!(made, 72);
}
