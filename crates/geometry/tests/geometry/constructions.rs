//! Each construction equals its definition, as an identity in formal parameters, for degrees 2 to 12.

use torse_algebra::rational::integer;
use torse_algebra::{Fraction, Scalar};
use torse_geometry::vector::{add, cross, det, dot, scale, sub};
use torse_geometry::{
    Bernstein, Continuity, Curve, EnvelopingPatch, Gbt, HalfTurn, PatchBounds, PlaneFamily,
    RotationSurface, RuledSurface, Surface, TensorSurface, join,
};

fn symbol(name: &str) -> Fraction {
    Fraction::named(name)
}

fn number(n: usize) -> Fraction {
    symbol("x").constant(&integer(i64::try_from(n).unwrap()))
}

/// A curve of this degree with formal shape parameters and integer control points.
fn curve<const D: usize>(degree: usize, mu: &str, nu: &str) -> Curve<Gbt<Fraction>, Fraction, D> {
    let points = (0..=degree)
        .map(|i| std::array::from_fn(|axis| number((i * i + 3 * axis * i + axis) % 7 + 1)))
        .collect();
    Curve::new(Gbt::new(symbol(mu), symbol(nu)).unwrap(), points).unwrap()
}

fn assert_same<const D: usize>(a: &[Fraction; D], b: &[Fraction; D], what: &str, degree: usize) {
    for difference in sub(a, b) {
        assert_eq!(difference, number(0), "{what}, degree {degree}");
    }
}

#[test]
fn cylinders_are_the_directrix_moved_along_the_direction() {
    let (u, v) = (symbol("u"), symbol("v"));
    let (direction, distance) = ([1, 2, 3].map(number), number(5));
    for degree in 2..=12 {
        let directrix = curve::<3>(degree, "mu", "nu");
        let surface = TensorSurface::cylinder(&directrix, &direction, &distance).unwrap();
        let moved = scale(&(v.clone() * distance.clone()), &direction);
        let expected = add(&directrix.point(&u).unwrap(), &moved);
        assert_same(
            &surface.point(&u, &v).unwrap(),
            &expected,
            "cylinder",
            degree,
        );
    }
}

#[test]
fn swung_and_swept_surfaces_are_the_products_and_sums_of_their_curves() {
    let (u, v) = (symbol("u"), symbol("v"));
    for degree in 2..=12 {
        // Both degrees run through 2 to 12, one up and one down.
        let (profile, trajectory) = (
            curve::<2>(degree, "mu", "nu"),
            curve::<2>(14 - degree, "mu1", "nu1"),
        );
        let surface = TensorSurface::swung(&profile, &trajectory, &number(3)).unwrap();
        let ([px, pz], [tx, ty]) = (profile.point(&u).unwrap(), trajectory.point(&v).unwrap());
        let radius = number(3) * px;
        let expected = [radius.clone() * tx, radius * ty, pz];
        assert_same(&surface.point(&u, &v).unwrap(), &expected, "swung", degree);

        let (section, path) = (
            curve::<3>(degree, "mu", "nu"),
            curve::<3>(14 - degree, "mu1", "nu1"),
        );
        let surface = TensorSurface::swept(&section, &path).unwrap();
        let expected = add(&section.point(&u).unwrap(), &path.point(&v).unwrap());
        assert_same(&surface.point(&u, &v).unwrap(), &expected, "swept", degree);
    }
}

#[test]
fn ruled_surfaces_interpolate_linearly_and_their_tensor_form_is_the_same() {
    let (u, v) = (symbol("u"), symbol("v"));
    for degree in 2..=12 {
        let first = curve::<3>(degree, "mu", "nu");
        let second = first.mapped(|[x, y, z]| [y.clone(), z.clone() * z.clone(), x.clone()]);
        let ruled = RuledSurface::new(first.clone(), second.clone());
        let (p, q) = (first.point(&u).unwrap(), second.point(&u).unwrap());
        let expected = add(&p, &scale(&v, &sub(&q, &p)));
        assert_same(&ruled.point(&u, &v).unwrap(), &expected, "ruled", degree);
        let tensor = ruled.tensor().unwrap();
        assert_same(&tensor.point(&u, &v).unwrap(), &expected, "tensor", degree);
    }
}

#[test]
fn rotation_surfaces_keep_height_and_distance_from_the_axis() {
    let (u, v) = (symbol("u"), symbol("v"));
    for degree in 2..=12 {
        let profile = curve::<2>(degree, "mu", "nu");
        let [radius, height] = profile.point(&u).unwrap();
        for half in [HalfTurn::Upper, HalfTurn::Lower] {
            let surface = RotationSurface::half_turn(profile.clone(), half);
            let [x, y, z] = surface.point(&u, &v).unwrap();
            let square = x.clone() * x + y.clone() * y;
            let expected = [radius.clone() * radius.clone(), height.clone()];
            assert_same(&[square, z], &expected, "rotation", degree);
        }
        let quarters = TensorSurface::quarter_turns(&profile).unwrap();
        for (quarter, next) in quarters.iter().zip(quarters.iter().cycle().skip(1)) {
            let [x, y, z] = quarter.point(&u, &v).unwrap();
            let square = x.clone() * x.clone() + y.clone() * y.clone();
            let expected = [radius.clone() * radius.clone(), height.clone()];
            assert_same(&[square, z.clone()], &expected, "quarter", degree);
            // The next quarter is this one turned by a right angle.
            assert_same(
                &next.point(&u, &v).unwrap(),
                &[-y, x, z],
                "next quarter",
                degree,
            );
        }
    }
}

#[test]
fn a_bilinear_net_of_bernstein_polynomials_is_the_bilinear_surface() {
    // With equally divided edges and interior the Bernstein surface of any degree is the bi-linear one.
    let (u, v) = (symbol("u"), symbol("v"));
    let corner = |a: usize, b: usize| [number(3 * a), number(2 * b), number(1 + a * b)];
    let corners = [[corner(0, 0), corner(0, 1)], [corner(1, 0), corner(1, 1)]];
    for m in 2..=12 {
        let n = 14 - m;
        let part = |k: usize, of: usize| number(k).divided_by(&number(of)).unwrap();
        let inside = |k: usize, l: usize| {
            let (s, t) = (part(k, m), part(l, n));
            [
                number(3) * s.clone(),
                number(2) * t.clone(),
                number(1) + s * t,
            ]
        };
        let interior: Vec<_> = (1..m)
            .flat_map(|k| (1..n).map(move |l| (k, l)))
            .map(|(k, l)| inside(k, l))
            .collect();
        let surface =
            TensorSurface::bilinear(Bernstein, Bernstein, (m, n), &corners, &interior).unwrap();
        let expected = [
            number(3) * u.clone(),
            number(2) * v.clone(),
            number(1) + u.clone() * v.clone(),
        ];
        assert_same(&surface.point(&u, &v).unwrap(), &expected, "bi-linear", m);
    }
}

#[test]
fn every_plane_of_a_family_touches_the_enveloped_surface_along_its_ruling() {
    let x = symbol("x");
    for degree in 2..=12 {
        let planes = (0..=degree)
            .map(|i| [number(1), number(i), number(i * i % 5), number(i % 3 + 1)])
            .collect();
        let family = PlaneFamily::new(Bernstein, planes).unwrap();
        let ruling = family.ruling(&x).unwrap();
        for [p, q, r, s] in family.curve().derivatives(&x, 1).unwrap() {
            let normal = [p, q, r];
            assert_eq!(
                dot(&normal, &ruling.direction),
                number(0),
                "degree {degree}"
            );
            assert_eq!(dot(&normal, &ruling.foot) - s, number(0), "degree {degree}");
        }
        let nearest = cross(&ruling.foot, &ruling.direction);
        assert_same(&nearest, &ruling.moment, "moment", degree);
    }
}

#[test]
fn enveloping_patches_have_a_vanishing_determinant_at_every_degree() {
    // The interior is settled for degree two in `developables`; the ends for all parameters mu and nu.
    for degree in 2..=12 {
        let planes = (0..=degree)
            .map(|i| [number(1), number(i), number(i * i % 5), number(i % 3 + 1)])
            .collect();
        let basis = Gbt::new(symbol("mu"), symbol("nu")).unwrap();
        let family = PlaneFamily::new(basis, planes).unwrap();
        let patch =
            EnvelopingPatch::new(family, PatchBounds::Range([number(1), number(4)])).unwrap();
        for end in [number(0), number(1)] {
            let [p, q] = torse_geometry::Rails::rail_jets(&patch, &end, 1).unwrap();
            let part = |jets: &[torse_algebra::Jet<Fraction>; 3], n: usize| {
                jets.each_ref().map(|jet| jet.coefficients()[n].clone())
            };
            let ruling = sub(&part(&q, 0), &part(&p, 0));
            assert_eq!(
                det(&part(&p, 1), &part(&q, 1), &ruling),
                number(0),
                "degree {degree}"
            );
        }
    }
}

#[test]
fn third_order_joints_have_equal_jets_between_all_degrees() {
    for degree in 3..=12 {
        let left = curve::<1>(degree, "mu1", "nu1");
        let basis = Gbt::new(symbol("mu2"), symbol("nu2")).unwrap();
        let c3 = Continuity::parametric(3, &number(0));
        let free: Vec<[Fraction; 1]> = (0..12 - degree).map(|i| [number(i)]).collect();
        let right = join::next_curve(&left, basis, &c3, &free).unwrap();
        let (end, start) = (left.end_jet(3).unwrap(), right.start_jet(3).unwrap());
        for (a, b) in end.iter().zip(&start) {
            assert_same(a, b, "joint", degree);
        }
        assert!(
            right.points()[3][0].as_rational().is_none(),
            "pi and the parameters enter"
        );
    }
}
