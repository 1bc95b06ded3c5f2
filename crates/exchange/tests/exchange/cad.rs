//! B-spline forms: the stated distance is never smaller than the true one, and exact forms are exact.

use proptest::prelude::*;
use torse_exchange::{
    BsplinePatch, CadModel, Converted, ExactForm, ExchangeError, Knots, approximate,
    approximate_tensor, iges, step,
};
use torse_geometry::curve::ellipse_arc;
use torse_geometry::vector::{cross, norm, sub};
use torse_geometry::{
    Bernstein, Curve, EnvelopingPatch, Gbt, PatchBounds, PlaneFamily, Rails, RationalCurve,
    RuledSurface, Surface, TangentPatch, TensorSurface,
};

/// The B-spline functions by the recursion of Cox and de Boor, written as it is defined.
fn basis(knots: &[f64], i: usize, degree: usize, t: f64) -> f64 {
    if degree == 0 {
        let last = knots[knots.len() - 1];
        let inside = knots[i] <= t && t < knots[i + 1];
        return f64::from(inside || (t == last && knots[i] < t && knots[i + 1] == last));
    }
    let part = |from: f64, to: f64, value: f64| if to > from { value / (to - from) } else { 0.0 };
    let (a, b) = (knots[i], knots[i + degree]);
    let (c, d) = (knots[i + 1], knots[i + degree + 1]);
    part(a, b, t - a) * basis(knots, i, degree - 1, t)
        + part(c, d, d - t) * basis(knots, i + 1, degree - 1, t)
}

fn point(patch: &BsplinePatch, u: f64, v: f64) -> [f64; 3] {
    let [k, l]: [Vec<f64>; 2] = patch
        .knots()
        .each_ref()
        .map(|k: &Knots| k.repeated().collect());
    let [m, n] = patch.degrees();
    let (mut sum, mut total) = ([0.0; 3], 0.0);
    for (i, row) in patch.net().iter().enumerate() {
        let first = basis(&k, i, m, u);
        for (j, p) in row.iter().enumerate() {
            let weight = patch.weights().map_or(1.0, |w| w[i][j]) * first * basis(&l, j, n, v);
            (0..3).for_each(|axis| sum[axis] += weight * p[axis]);
            total += weight;
        }
    }
    sum.map(|x| x / total)
}

/// The largest distance at equal parameters on a grid.
fn distance(patch: &BsplinePatch, surface: &impl Surface<f64>, cells: usize) -> f64 {
    let at = |i: usize| i as f64 / cells as f64;
    let mut worst = 0.0_f64;
    for (u, v) in (0..=cells).flat_map(|i| (0..=4).map(move |j| (at(i), 0.25 * f64::from(j)))) {
        worst = worst.max(norm(&sub(
            &point(patch, u, v),
            &surface.point(&u, &v).unwrap(),
        )));
    }
    worst
}

fn sheet<B: torse_geometry::Basis<f64>>(basis: B) -> EnvelopingPatch<B, f64> {
    let planes = vec![
        [7., -7., 5., 125.],
        [-7., -7., 5., 120.],
        [-7., 7., 5., 130.],
        [7., 7., 5., 125.],
    ];
    let family = PlaneFamily::new(basis, planes).unwrap();
    let cuts = PatchBounds::Planes([[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 1.0, 3.0]]);
    EnvelopingPatch::new(family, cuts).unwrap()
}

#[test]
fn the_proved_distance_is_above_the_true_one_and_not_far_above() {
    let sheet = sheet(Gbt::new(0.5, 0.25).unwrap());
    for tolerance in [1e-1, 1e-3, 1e-6] {
        let Converted { patches, error } = approximate(&sheet, tolerance).unwrap();
        let pieces = patches[0].knots()[0].values().len() - 1;
        let truth = distance(&patches[0], &sheet, 8 * pieces);
        // Sampling misses a little of the maximum, the evaluation itself rounds.
        assert!(
            truth <= error + 1e-11 && error <= tolerance,
            "{truth} {error}"
        );
        // The bound of the sixth derivative is spent on the number of pieces: never more than four times
        // as many as the true distance would need.
        assert!(truth * 4_f64.powi(6) > error, "{truth} {error}");
    }
}

#[test]
fn a_quarter_circle_needs_as_many_pieces_as_its_sixth_derivative_says() {
    let arc = |z: f64| ellipse_arc(&[0.0, 0.0, z], &[2.0, 0.0, z], &[0.0, 2.0, z]).unwrap();
    let tube = RuledSurface::new(arc(0.0), arc(1.0));
    let Converted { patches, error } = approximate(&tube, 1e-6).unwrap();
    let pieces = patches[0].knots()[0].values().len() - 1;
    // |f^(6)/6!| = 2 (pi/2)^6/720 for the angle pi x/2; the ball of an interval is a little wider.
    let half = 0.5 / pieces as f64;
    let bound = 2.0 * (std::f64::consts::FRAC_PI_2 * half).powi(6) / 720.0;
    assert_eq!(pieces, 4);
    assert!(bound <= error && error < 2.0 * bound, "{bound} {error}");
    assert!(distance(&patches[0], &tube, 256) <= error);
}

#[test]
fn the_spline_is_twice_differentiable() {
    let patch = approximate(&sheet(Gbt::new(-0.5, 1.0).unwrap()), 1e-4).unwrap();
    let patch = &patch.patches[0];
    let inner = &patch.knots()[0].multiplicities()[1..];
    assert!(inner[..inner.len() - 1].iter().all(|m| *m == 3) && inner.len() > 1);
}

#[test]
fn singular_rails_are_not_approximated() {
    // A cutting plane that becomes parallel to the ruling inside the patch.
    let planes = vec![
        [0.0, -20.0, 10.0, 400.0],
        [1.0, 0.0, 20.0, 300.0],
        [0.0, 20.0, 10.0, 400.0],
    ];
    let family = PlaneFamily::new(Gbt::new(0.3, 0.3).unwrap(), planes).unwrap();
    let middle = family.ruling(&0.37).unwrap().direction;
    let across = cross(&middle, &[1.0, 2.0, 3.0]);
    let plane = |s: f64| [across[0], across[1], across[2], s];
    let patch =
        EnvelopingPatch::new(family, PatchBounds::Planes([plane(0.0), plane(1.0)])).unwrap();
    let error = approximate(&patch, 1e-3).unwrap_err();
    let ExchangeError::NotReached { from, to, .. } = error else {
        panic!("{error}")
    };
    assert!(
        (from - 0.37).abs() < 1e-4 && to - from < 1e-5,
        "{from} {to}"
    );
}

#[test]
fn exact_forms_are_the_patches_ruling_by_ruling() {
    let cubic = vec![
        [0., 0., 1., 0.],
        [0., -1., 1., 0.],
        [1., -2., 1., 0.],
        [3., -3., 1., 1.],
    ];
    let family = || PlaneFamily::new(Bernstein, cubic.clone()).unwrap();
    let cut = PatchBounds::Planes([[1., 0., 0., 2.], [1., 0., 0.1, 5.]]);
    let rail = |z: f64| vec![[0.0, z, 0.0], [1.0, 1.0, z], [5.0, z, z]];
    let weighted = RationalCurve::new(Bernstein, &rail(2.0), vec![1.0, 0.5, 3.0]).unwrap();
    let lifted = Curve::new(Bernstein, vec![[0.0, 9.0, 1.0], [4.0, 9.0, 2.0]]).unwrap();
    check_rulings(&EnvelopingPatch::new(family(), cut).unwrap());
    check_rulings(&EnvelopingPatch::new(family(), PatchBounds::Range([-1.0, 2.0])).unwrap());
    check_rulings(&TangentPatch::new(family(), [0.5, 2.0]).unwrap());
    check_rulings(&RuledSurface::new(lifted, weighted));
    check_rulings(&sheet(Bernstein));
}

fn check_rulings(patch: &(impl Rails<f64> + ExactForm)) {
    let Converted { patches, error } = patch.exact_form().unwrap();
    assert!(error < 1e-12, "{error}");
    let count = patches.len();
    for u in (0..=32).map(|i| f64::from(i) / 32.0) {
        // Halves of halves, so of equal length here.
        let place = ((u * count as f64) as usize).min(count - 1);
        let local = u * count as f64 - place as f64;
        let [p, q] = patch.ruling_ends(&u).unwrap();
        let ends = [0.0, 1.0].map(|v| point(&patches[place], local, v));
        for (found, exact) in ends.iter().zip([p, q]) {
            let gap = norm(&sub(found, &exact));
            assert!(
                gap < 1e-9 * (1.0 + norm(&exact)),
                "{count} pieces, u = {u}: {gap}"
            );
        }
    }
}

#[test]
fn what_is_not_rational_says_why() {
    let degree = 9;
    let planes = (0..=degree)
        .map(f64::from)
        .map(|t| [libm::sin(t), libm::cos(t), 2.0 + libm::sin(2.0 * t), 3.0]);
    let family = PlaneFamily::new(Bernstein, planes.collect()).unwrap();
    let high = EnvelopingPatch::new(family, PatchBounds::Range([1.0, 2.0]))
        .unwrap()
        .exact_form();
    assert_eq!(
        high.unwrap_err().to_string(),
        "no exact rational form: the degree is above 25"
    );
    let cylinder = vec![[0., -2., 1., 4.], [0., -1., 2., 4.], [0., 1., 2., 4.]];
    let family = PlaneFamily::new(Bernstein, cylinder).unwrap();
    let spineless = TangentPatch::new(family, [1.0, 2.0]).unwrap().exact_form();
    assert!(matches!(spineless, Err(ExchangeError::NotRational { .. })));
}

#[test]
fn tensor_products_of_both_bases_stay_within_their_distance() {
    let net = |m: usize, n: usize| -> Vec<Vec<[f64; 3]>> {
        let at = |i: usize, j: usize| {
            [
                i as f64,
                j as f64 + 0.1 * i as f64,
                libm::sin((i * j) as f64),
            ]
        };
        (0..m).map(|i| (0..n).map(|j| at(i, j)).collect()).collect()
    };
    let gbt = |mu: f64, nu: f64| Gbt::new(mu, nu).unwrap();
    let curved = TensorSurface::new(gbt(0.5, -1.0), gbt(1.0, 0.25), net(4, 5)).unwrap();
    let Converted { patches, error } = approximate_tensor(&curved, 1e-4).unwrap();
    assert!(distance(&patches[0], &curved, 64) <= error && error <= 1e-4);
    // Polynomials up to degree five are reproduced in one piece.
    let mixed = TensorSurface::new(Bernstein, gbt(1.0, 0.25), net(4, 3)).unwrap();
    let Converted { patches, error } = approximate_tensor(&mixed, 1e-4).unwrap();
    assert_eq!(patches[0].knots()[0].values(), [0.0, 1.0]);
    assert!(distance(&patches[0], &mixed, 32) <= error);
    let plain = TensorSurface::new(Bernstein, Bernstein, net(4, 3)).unwrap();
    let Converted { patches, error } = plain.exact_form().unwrap();
    assert!(error == 0.0 && distance(&patches[0], &plain, 8) < 1e-14);
}

#[test]
fn neighbours_of_a_ring_share_their_rulings() {
    let way =
        |n: usize, z: f64| [[2.0, 0.0, z], [0.0, 2.0, z], [-2.0, 0.0, z], [0.0, -2.0, z]][n % 4];
    let arc = |n: usize, z: f64| ellipse_arc(&[0.0, 0.0, z], &way(n, z), &way(n + 1, z)).unwrap();
    let mut ring = CadModel::new("ring", 1e-7).unwrap();
    for n in 0..4 {
        let quarter = RuledSurface::new(arc(n, 0.0), arc(n, 1.0));
        ring.add("quarter", approximate(&quarter, 1e-4).unwrap())
            .unwrap();
    }
    let text = step(&ring).unwrap();
    assert_eq!(text.matches("=EDGE_CURVE(").count(), 12);
    assert_eq!(text.matches("=VERTEX_POINT(").count(), 8);
    assert_eq!(text.matches("=ORIENTED_EDGE('',*,*").count(), 16);
    assert_eq!(
        ring.error(),
        approximate(&RuledSurface::new(arc(0, 0.0), arc(0, 1.0)), 1e-4)
            .unwrap()
            .error
    );
}

#[test]
fn every_step_reference_is_defined_before_it_is_used() {
    let points = |z: f64| vec![[0.0, z, 1e30], [1.0, 1.0, z], [5.0, z, z]];
    let polynomial = Curve::new(Bernstein, points(0.0)).unwrap();
    let rational = RationalCurve::new(Bernstein, &points(2.0), vec![1.0, 0.5, 1.0]).unwrap();
    let mut model = CadModel::new("it's \\ ä", 1e-6).unwrap();
    let mixed = RuledSurface::new(polynomial, rational);
    model.add("mixed", mixed.exact_form().unwrap()).unwrap();
    let text = step(&model).unwrap();
    assert!(
        text.contains("1.E30")
            && text.contains("RATIONAL_B_SPLINE_SURFACE(((1.0,1.0),(1.0,0.5),(1.0,1.0)))")
    );
    assert!(text.contains("'it''s \\\\ \\X2\\00E4\\X0\\'") && text.is_ascii());
    let mut known = 0;
    for line in text.lines().filter(|line| line.starts_with('#')) {
        let (id, body) = line[1..].split_once('=').unwrap();
        let id: usize = id.parse().unwrap();
        assert_eq!(id, known + 1);
        for reference in body.split('#').skip(1) {
            let digits: String = reference.chars().take_while(char::is_ascii_digit).collect();
            assert!(digits.parse::<usize>().unwrap() <= known, "{line}");
        }
        known = id;
    }
}

#[test]
fn iges_marks_what_is_developable() {
    let rail = |a: [f64; 3], b: [f64; 3]| Curve::new(Bernstein, vec![a, b]).unwrap();
    let twisted = RuledSurface::new(
        rail([0.; 3], [1., 0., 0.]),
        rail([0., 1., 0.], [1., 1., 1.]),
    );
    let flags = |surface: Converted| -> Vec<String> {
        let mut model = CadModel::new(
            "a name, with separators; and more than eighty characters in it, so that it is broken",
            1e-6,
        )
        .unwrap();
        model.add("part", surface).unwrap();
        let text = iges(&model).unwrap();
        assert!(text.lines().all(|line| line.len() == 80));
        let ruled = text.lines().filter(|line| line.starts_with("118,"));
        ruled
            .map(|line| line.split(',').nth(4).unwrap().to_owned())
            .collect()
    };
    assert_eq!(flags(twisted.exact_form().unwrap()), ["0"]);
    assert_eq!(flags(sheet(Bernstein).exact_form().unwrap()), ["1", "1"]);
    assert_eq!(
        flags(approximate(&sheet(Gbt::new(0.5, 0.5).unwrap()), 1e-2).unwrap()),
        ["1"]
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn no_sample_of_a_random_patch_is_farther_than_proved(
        rails in prop::array::uniform2(prop::collection::vec(prop::array::uniform3(-9.0..9.0_f64), 2..6)),
        shape in prop::array::uniform4(-1.0..1.0_f64), digits in 1..7_i32,
    ) {
        let [p, q] = rails;
        let curve = |points, mu, nu| Curve::new(Gbt::new(mu, nu).unwrap(), points).unwrap();
        let patch = RuledSurface::new(curve(p, shape[0], shape[1]), curve(q, shape[2], shape[3]));
        let tolerance = 10_f64.powi(-digits);
        let Converted { patches, error } = approximate(&patch, tolerance).unwrap();
        prop_assert!(error <= tolerance);
        prop_assert!(distance(&patches[0], &patch, 37) <= error + 1e-13);
    }
}
