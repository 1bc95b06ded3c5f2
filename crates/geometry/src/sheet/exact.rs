//! Whether a ruled patch is exactly developable, decided on the exact numbers of its control points.

use super::rail::Homogeneous;
use super::{Rail, RailCurve};
use crate::basis::BasisShape;
use crate::curve::{Curve, EllipticHelix};
use crate::scalars::exact;
use crate::vector::{cross, det, det4, sub};
use torse_algebra::{Integer, Rational};

/// Returns whether `det(P', Q', Q - P)` is the zero function: the differences of the control points are parallel with
/// one ratio (cylinders and cones), all control points lie in one plane, or (of polynomials, weighted or not) the
/// determinant vanishes at one parameter more than its degree.
pub(super) fn is_exactly_developable(first: &Rail, second: &Rail) -> bool {
    if are_similar(first, second) {
        return true;
    }
    let (Some(p), Some(q)) = (first.homogeneous(), second.homogeneous()) else {
        return false;
    };
    are_coplanar(&p, &q) || vanishes(first, second, &p, &q)
}

/// Returns whether `Q' = k P'` with a constant `k`: in one basis, with the same weights but for a factor, or of arcs with
/// the same angles.
fn are_similar(first: &Rail, second: &Rail) -> bool {
    match (first.curve(), second.curve()) {
        (RailCurve::Plain(p), RailCurve::Plain(q)) => {
            p.basis() == q.basis()
                && p.degree() == q.degree()
                && have_similar_control(first, second)
        }
        (RailCurve::Weighted(p), RailCurve::Weighted(q)) => {
            p.basis() == q.basis()
                && p.degree() == q.degree()
                && have_similar_control(first, second)
        }
        // Sine, cosine and one are independent, and what they go with is all that moves.
        (RailCurve::Elliptic(p), RailCurve::Elliptic(q)) => {
            let moving = |arc: &EllipticHelix| -> Vec<Rational> {
                let [cosine, sine] = arc.axes();
                let vectors = [cosine, sine, arc.rise()];
                vectors.into_iter().flatten().map(|c| exact(*c)).collect()
            };
            // Whole turns, four quarters, make no difference.
            let turns = [0, 1].map(|end| {
                let apart = exact(p.range()[end]) - exact(q.range()[end]);
                apart / Rational::from_integer(Integer::from(4))
            });
            turns[0] == turns[1]
                && *turns[0].denom() == Integer::ONE
                && are_proportional(&moving(p), &moving(q))
        }
        _ => false,
    }
}

/// Returns whether the weights are proportional, and the differences of neighbouring control points.
fn have_similar_control(first: &Rail, second: &Rail) -> bool {
    let (Some(p), Some(q)) = (first.homogeneous(), second.homogeneous()) else {
        return false;
    };
    let weights = |all: &Homogeneous| all.iter().map(|[.., w]| w.clone()).collect::<Vec<_>>();
    are_proportional(&weights(&p), &weights(&q)) && are_proportional(&steps(&p), &steps(&q))
}

/// Returns the control points themselves; weights are positive.
fn points(control: &Homogeneous) -> Vec<[Rational; 3]> {
    let point = |[x, y, z, w]: &[Rational; 4]| [x, y, z].map(|c| c.clone() / w.clone());
    control.iter().map(point).collect()
}

/// Returns the differences of neighbouring control points.
fn steps(control: &Homogeneous) -> Vec<Rational> {
    let points = points(control);
    let pairs = points.iter().zip(points.iter().skip(1));
    pairs.flat_map(|(a, b)| sub(b, a)).collect()
}

/// Returns whether the second list is a multiple of the first, which is not zero.
fn are_proportional(p: &[Rational], q: &[Rational]) -> bool {
    let zero = Rational::from_integer(Integer::ZERO);
    let Some(index) = p.iter().position(|c| *c != zero) else {
        return false;
    };
    let (Some(a), Some(b)) = (p.get(index), q.get(index)) else {
        return false;
    };
    p.iter()
        .zip(q)
        .all(|(x, y)| x.clone() * b.clone() == y.clone() * a.clone())
}

fn are_coplanar(p: &Homogeneous, q: &Homogeneous) -> bool {
    let zero = Rational::from_integer(Integer::ZERO);
    let points: Vec<[Rational; 3]> = points(p).into_iter().chain(points(q)).collect();
    let Some(origin) = points.first() else {
        return false;
    };
    let arms: Vec<[Rational; 3]> = points.iter().map(|point| sub(point, origin)).collect();
    let nonzero = |v: &[Rational; 3]| v.iter().any(|c| *c != zero);
    let Some(first) = arms.iter().find(|arm| nonzero(arm)) else {
        return true;
    };
    let Some(second) = arms.iter().find(|arm| nonzero(&cross(first, arm))) else {
        return true;
    };
    arms.iter().all(|arm| det(first, second, arm) == zero)
}

/// Returns whether `det(A, A', B, B')` vanishes, with the homogeneous polynomials `A, B` of the rails: a polynomial of
/// a degree of at most `2 m + 2 n - 4`.
fn vanishes(first: &Rail, second: &Rail, p: &Homogeneous, q: &Homogeneous) -> bool {
    let shape = |rail: &Rail| match rail.curve() {
        RailCurve::Plain(curve) => Some(*curve.basis()),
        RailCurve::Weighted(curve) => Some(*curve.basis()),
        RailCurve::Elliptic(_) => None,
    };
    let polynomial = Some(BasisShape::Bernstein);
    if [shape(first), shape(second)] != [polynomial; 2] || p.len() < 2 || q.len() < 2 {
        return false;
    }
    let curve = |points: &Homogeneous| Curve::new(BasisShape::Bernstein, points.clone());
    let (Ok(a), Ok(b)) = (curve(p), curve(q)) else {
        return false;
    };
    let count = (2 * (a.degree() + b.degree())).saturating_sub(4);
    (0..=count).all(|k| {
        let x = Rational::new(Integer::from(2 * k + 1), Integer::from(2 * count + 3));
        let jets = (a.derivatives(&x, 1), b.derivatives(&x, 1));
        let (Ok(a), Ok(b)) = jets else { return false };
        match (a.as_slice(), b.as_slice()) {
            ([a0, a1], [b0, b1]) => det4(a0, a1, b0, b1) == Rational::from_integer(Integer::ZERO),
            _ => false,
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sheet::Point;

    #[test]
    fn what_is_exactly_developable_is_told_from_what_is_nearly() {
        let arch = |z: f64, k: f64| {
            Rail::bezier(&[[0.0, 0.0, z], [k, 2.0 * k, z], [4.0 * k, 0.0, z]]).unwrap()
        };
        assert!(is_exactly_developable(&arch(0.0, 1.0), &arch(3.0, 1.0)));
        assert!(is_exactly_developable(&arch(0.0, 1.0), &arch(3.0, 0.5)));
        // 0.3 is rounded, and its double and fourfold are exactly that of the rounded number.
        assert!(is_exactly_developable(&arch(0.0, 1.0), &arch(3.0, 0.3)));
        let beside = [
            [0.0, 0.0, 3.0],
            [0.3, 0.6, 3.0],
            [1.2 + f64::EPSILON, 0.0, 3.0],
        ];
        let beside = Rail::bezier(&beside).unwrap();
        assert!(!is_exactly_developable(&arch(0.0, 1.0), &beside));
        let line = |a: Point, b: Point| Rail::bezier(&[a, b]).unwrap();
        let plank = |z: f64| line([0.0, 200.0, 0.0], [5000.0, 200.0, z]);
        let edge = line([0.0; 3], [5000.0, 0.0, 0.0]);
        assert!(is_exactly_developable(&edge, &plank(0.0)));
        assert!(!is_exactly_developable(&edge, &plank(1e-9)));
    }

    #[test]
    fn tangents_of_a_cubic_are_developable_with_weights_and_without() {
        // Two curves on the tangent surface of (t, t^2, t^3): c + c'/3 and c - c'/3 are polynomials of degree three.
        let at = |k: f64| {
            Rail::bezier(&[
                [k, 0.0, 0.0],
                [1.0 / 3.0 + k, 2.0 * k / 3.0, 0.0],
                [2.0 / 3.0 + k, (1.0 + 4.0 * k) / 3.0, k],
                [1.0 + k, 1.0 + 2.0 * k, 1.0 + 3.0 * k],
            ])
        };
        // Of thirds that are rounded it is not exact: scaled by 3 all numbers are integers.
        let scaled = |k: f64| {
            let rail = at(k).unwrap();
            let RailCurve::Plain(curve) = rail.curve() else {
                panic!()
            };
            let points: Vec<Point> = curve
                .points()
                .iter()
                .map(|p| p.map(|c| (3.0 * c).round()))
                .collect();
            (points.clone(), Rail::bezier(&points).unwrap())
        };
        let ((low, first), (_, second)) = (scaled(1.0), scaled(2.0));
        assert!(is_exactly_developable(&first, &second));
        let weighted = Rail::weighted(BasisShape::Bernstein, &low, &[1.0, 2.0, 1.0, 1.0]).unwrap();
        assert!(!is_exactly_developable(&weighted, &second));
    }

    #[test]
    fn moved_turned_cut_and_passed_backwards_a_weighted_cone_stays_one() {
        let cone = |share: f64, top: f64| {
            let points = [[60.0, 0.0, 0.0], [60.0, 60.0, 0.0], [0.0, 60.0, 0.0]];
            let points = points.map(|[x, y, _]| [share * x, share * y, top]);
            Rail::weighted(BasisShape::Bernstein, &points, &[1.0, 0.7, 1.0]).unwrap()
        };
        let pair = [cone(1.0, 0.0), cone(0.5, 60.0)];
        assert!(is_exactly_developable(&pair[0], &pair[1]));
        let map = crate::AffineMap {
            linear: [[0.6, -0.8, 0.0], [0.8, 0.6, 0.0], [0.0, 0.0, 1.0]],
            shift: [0.1, 0.2, 0.3],
        };
        let turned = pair.each_ref().map(|rail| rail.mapped(&map));
        assert!(is_exactly_developable(&turned[0], &turned[1]));
        let back = turned.each_ref().map(Rail::reversed);
        assert!(is_exactly_developable(&back[0], &back[1]));
        let [first, second] = back.each_ref().map(|rail| rail.split(0.3).unwrap());
        assert!(is_exactly_developable(&first[0], &second[0]));
        assert!(is_exactly_developable(&first[1], &second[1]));
        // What is exact of the numbers as they are given is not of those that f64 holds.
        let rounded = |rail: &Rail| Rail {
            given: None,
            ..rail.clone()
        };
        assert!(!is_exactly_developable(
            &rounded(&turned[0]),
            &rounded(&turned[1])
        ));
    }
}
