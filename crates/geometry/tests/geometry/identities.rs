//! The code equals the papers' definitions, as identities in formal x, mu, nu for degrees 2 to 12.

use torse_algebra::rational::{integer, ratio};
use torse_algebra::{Fraction, Jet, Scalar, Symbol};
use torse_geometry::curve::ellipse_arc;
use torse_geometry::{Basis, Bernstein, Coordinate, Curve, Gbt, Over};

fn symbol(name: &str) -> Fraction {
    Fraction::named(name)
}

fn formal() -> (Gbt<Fraction>, Fraction) {
    (Gbt::new(symbol("mu"), symbol("nu")).unwrap(), symbol("x"))
}

/// Definition 1 and eq. (2.1) of gbt-developable word by word, degree by degree up to `last`.
fn defined(last: usize, x: &Fraction) -> Vec<Vec<Fraction>> {
    let one = x.one_like();
    let (s, c) = x.quarter_turn().unwrap();
    let (mu, nu) = (symbol("mu"), symbol("nu"));
    let g0 = (one.clone() - s.clone()) * (one.clone() - mu * s);
    let g2 = (one.clone() - c.clone()) * (one.clone() - nu * c);
    let g1 = one.clone() - g0.clone() - g2.clone();
    let mut degrees = vec![vec![g0, g1, g2]];
    for k in 3..=last {
        let below = degrees.last().unwrap();
        // g[i,k] = 0 for i < 0 and i > k.
        let g = |i: Option<usize>| {
            i.and_then(|i| below.get(i))
                .cloned()
                .unwrap_or_else(|| x.zero_like())
        };
        let next = (0..=k)
            .map(|i| (one.clone() - x.clone()) * g(Some(i)) + x.clone() * g(i.checked_sub(1)))
            .collect();
        degrees.push(next);
    }
    degrees
}

#[test]
fn basis_rows_are_the_functions_of_the_definition_for_degrees_two_to_twelve() {
    let (gbt, x) = formal();
    for (k, by_definition) in (2..).zip(defined(12, &x)) {
        let row = gbt.row(k, &x).unwrap();
        assert_eq!(row.len(), by_definition.len());
        for (i, (entry, g)) in row.into_iter().zip(by_definition).enumerate() {
            assert_eq!(entry - g, x.zero_like(), "g[{i},{k}]");
        }
    }
}

#[test]
fn the_basis_sums_to_one_for_degrees_two_to_twelve() {
    let (gbt, x) = formal();
    for k in 2..=12 {
        let sum = gbt
            .row(k, &x)
            .unwrap()
            .into_iter()
            .reduce(|a, b| a + b)
            .unwrap();
        assert_eq!(sum, x.one_like(), "degree {k}");
    }
}

#[test]
fn a_curve_is_a_bernstein_blend_of_local_quadratics_for_degrees_two_to_twelve() {
    // sum_j B[j,k-2] (g0 R[j] + g1 R[j+1] + g2 R[j+2]) with explicit binomials.
    let (gbt, x) = formal();
    let [g0, g1, g2] = gbt.seeds(&x).unwrap();
    let y = x.one_like() - x.clone();
    for k in 2..=12_usize {
        let points: Vec<Fraction> = (0..=k)
            .map(|i| x.constant(&integer(i64::try_from(i * i % 7).unwrap() - 2)))
            .collect();
        let curve = Curve::new(gbt.clone(), points.iter().map(|p| [p.clone()]).collect()).unwrap();
        let mut blend = x.zero_like();
        let mut binomial = 1_i64;
        for j in 0..=k - 2 {
            let local = g0.clone() * points[j].clone()
                + g1.clone() * points[j + 1].clone()
                + g2.clone() * points[j + 2].clone();
            let power = |base: &Fraction, n: usize| base.power(i32::try_from(n).unwrap()).unwrap();
            let weight = power(&y, k - 2 - j) * power(&x, j) * x.constant(&integer(binomial));
            blend = blend + weight * local;
            binomial = binomial * i64::try_from(k - 2 - j).unwrap() / i64::try_from(j + 1).unwrap();
        }
        let [point] = curve.point(&x).unwrap();
        assert_eq!(point - blend, x.zero_like(), "degree {k}");
    }
}

#[test]
fn derivative_rows_are_the_derivatives_of_the_rows() {
    let (gbt, x) = formal();
    for k in 1..=12 {
        let rows = gbt.derivative_rows(k, &x, 3).unwrap();
        for n in 1..=3 {
            for (lower, upper) in rows[n - 1].iter().zip(&rows[n]) {
                assert_eq!(
                    lower.derivative("x") - upper.clone(),
                    x.zero_like(),
                    "degree {k}, order {n}"
                );
            }
        }
    }
}

#[test]
fn shape_derivatives_are_the_derivatives_by_mu_and_nu() {
    let (gbt, x) = formal();
    for k in 2..=12_usize {
        let points = (0..=k)
            .map(|i| [x.constant(&integer([3, -1, 4, 1, -5, 9, 2][i % 7]))])
            .collect();
        let curve = Curve::new(gbt.clone(), points).unwrap();
        let [value] = curve.point(&x).unwrap();
        let [[by_mu], [by_nu]] = curve.shape_derivatives(&x).unwrap();
        assert_eq!(value.derivative("mu") - by_mu, x.zero_like(), "degree {k}");
        assert_eq!(value.derivative("nu") - by_nu, x.zero_like(), "degree {k}");
    }
}

#[test]
fn end_derivatives_are_those_of_gbt_developable_3_11_and_3_12() {
    let (gbt, x) = formal();
    let pi = Fraction::symbol(Symbol::Pi);
    let number = |n: i64| x.constant(&integer(n));
    let quarter = x.constant(&ratio(1, 4).unwrap());
    let one = x.one_like();
    let (mu, nu) = (symbol("mu"), symbol("nu"));
    for k in 2..=12_i64 {
        let degree = usize::try_from(k).unwrap();
        let q: Vec<Fraction> = (0..=k).map(|i| symbol(&format!("Q{i}"))).collect();
        let curve = Curve::new(gbt.clone(), q.iter().map(|p| [p.clone()]).collect()).unwrap();
        let start = curve.derivatives(&number(0), 2).unwrap();
        let half_slope = |shape: &Fraction| {
            number(k - 2) + pi.clone() * (one.clone() + shape.clone()).scaled(&ratio(1, 2).unwrap())
        };
        assert_eq!(
            start[1][0],
            half_slope(&mu) * (q[1].clone() - q[0].clone()),
            "H'(0), degree {k}"
        );
        let bend = |own: &Fraction, other: &Fraction, a: &Fraction, b: &Fraction, c: &Fraction| {
            let second = a.clone() - b.clone() - b.clone() + c.clone();
            let pp = pi.clone() * pi.clone();
            quarter.clone()
                * (number(4 * (k - 2))
                    * (number(k - 3) + pi.clone() * (one.clone() + own.clone()))
                    * second
                    + number(2) * pp.clone() * own.clone() * (a.clone() - b.clone())
                    - pp * (one.clone() - other.clone()) * (b.clone() - c.clone()))
        };
        assert_eq!(
            start[2][0].clone() - bend(&mu, &nu, &q[0], &q[1], &q[2]),
            number(0),
            "H''(0), degree {k}"
        );
        let end = curve.derivatives(&number(1), 2).unwrap();
        let (a, b, c) = (&q[degree], &q[degree - 1], &q[degree - 2]);
        assert_eq!(
            end[1][0],
            half_slope(&nu) * (a.clone() - b.clone()),
            "H'(1), degree {k}"
        );
        assert_eq!(
            end[2][0].clone() - bend(&nu, &mu, a, b, c),
            number(0),
            "H''(1), degree {k}"
        );
    }
}

#[test]
fn reversing_swaps_the_shape_parameters_at_every_scalar() {
    // 1 - x is no plain variable, so the reflection is checked where sine and cosine are exact, and on
    // f64 in between.
    let gbt = Gbt::new(0.3, -0.6).unwrap();
    for k in 2..9 {
        let mut mirrored = gbt.reversed().row(k, &0.75).unwrap();
        mirrored.reverse();
        for (a, b) in gbt.row(k, &0.25).unwrap().iter().zip(mirrored) {
            assert!((a - b).abs() < 1e-15);
        }
    }
    let (gbt, x) = formal();
    for end in [0, 1] {
        let mut mirrored = gbt
            .reversed()
            .derivative_rows(4, &x.constant(&integer(1 - end)), 2)
            .unwrap();
        let rows = gbt
            .derivative_rows(4, &x.constant(&integer(end)), 2)
            .unwrap();
        for (n, (row, other)) in rows.iter().zip(&mut mirrored).enumerate() {
            other.reverse();
            for (a, b) in row.iter().zip(other) {
                let b = if n % 2 == 1 { -b.clone() } else { b.clone() };
                assert_eq!(a.clone() - b, x.zero_like());
            }
        }
    }
}

#[test]
fn rows_with_slopes_agree_with_the_derivative_rows_exactly() {
    let x = ratio(2, 7).unwrap();
    for degree in 1..=9 {
        let rows = Bernstein.derivative_rows(degree, &x, 1).unwrap();
        let (mut row, mut slope) = (vec![integer(0); degree + 1], vec![integer(0); degree + 1]);
        Bernstein
            .row_and_slope_into(&x, &mut row, &mut slope)
            .unwrap();
        assert_eq!([row, slope].to_vec(), rows);
    }
    let (gbt, x) = formal();
    let rows = gbt.derivative_rows(4, &x, 1).unwrap();
    let (mut row, mut slope) = (vec![x.zero(); 5], vec![x.zero(); 5]);
    gbt.row_and_slope_into(&x, &mut row, &mut slope).unwrap();
    for (a, b) in slope.iter().zip(&rows[1]) {
        assert_eq!(a.clone() - b.clone(), x.zero());
    }
}

#[test]
fn the_quarter_ellipse_is_an_ellipse_as_an_identity() {
    let x = symbol("x");
    let point = |a: i64, b: i64| [x.constant(&integer(a)), x.constant(&integer(b))];
    let arc = ellipse_arc(&point(0, 0), &point(1, 0), &point(0, 1)).unwrap();
    let [cosine, sine] = arc.point(&x).unwrap();
    let (s, c) = x.quarter_turn().unwrap();
    assert_eq!(
        [cosine.clone() - c, sine.clone() - s],
        [x.zero_like(), x.zero_like()]
    );
    assert_eq!(cosine.clone() * cosine + sine.clone() * sine, x.one_like());
}

#[test]
fn a_curve_evaluated_on_a_jet_gives_its_own_derivatives() {
    let points = vec![[0.5, 1.0], [2.0, -1.0], [3.0, 4.0], [1.0, 0.0], [2.0, 2.0]];
    let curve = Curve::new(Gbt::new(0.4, -0.9).unwrap(), points).unwrap();
    let order = 4;
    let on_jets = curve.over(&|v| Jet::of_constant(*v, order)).unwrap();
    for x in [0.1, 0.5, 0.85] {
        let jet = on_jets.point(&Jet::variable(x, order)).unwrap();
        for (n, derivative) in curve.derivatives(&x, order).unwrap().iter().enumerate() {
            for (value, series) in derivative.iter().zip(&jet) {
                let other = series.derivative(n).unwrap();
                assert!(
                    (value - other).abs() < 1e-11 * (1.0 + value.abs()),
                    "order {n}: {value} {other}"
                );
            }
        }
    }
}
