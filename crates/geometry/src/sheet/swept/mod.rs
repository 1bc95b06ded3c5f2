//! Cylinders and cones over any curve: developable by the way they are made.
//!
//! Points of a cylinder are `c(x) + h d`, those of a cone `o + s (c(x) - o)`, and an edge says which `h(x)` or `s(x)`
//! it has: a constant, or where a plane cuts. A plane `n . X = e` gives `h = (e - n . c)/(n . d)`, which is affine in
//! `c`, and `1/s = n . (c - o)/(e - n . o)`: since the functions of a basis sum to one, both are curves in the basis of
//! `c`, with the weights of `c`, and their control values are those of its control points. They are computed on f64 and
//! are the definition from then on: what is kept exactly is that all rulings run along `d`, or through `o`. Of an arc
//! of an ellipse or a helix, which have no control points, `h(x)` is the same combination of sine, cosine and angle.

mod cone;
mod cylinder;
mod factor;

pub use cone::ConePatch;
pub use cylinder::CylinderPatch;
pub use factor::SweptEdge;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::EllipticHelix;
    use crate::model::ChebyshevModel;
    use crate::over::Over;
    use crate::prelude::Sheet;
    use crate::sheet::{Point, Rail};
    use crate::surface::Rails;
    use crate::vector::cross;
    use crate::vector::{scale, sub};

    fn helix() -> Rail {
        let (a, b, rise) = ([3.0, 0.0, 0.0], [0.0, 2.0, 0.5], [0.0, 0.0, 0.25]);
        Rail::from(EllipticHelix::new([1.0, 0.0, 0.0], a, b, rise, [0.0, 2.5]).unwrap())
    }

    #[test]
    fn a_cylinder_over_a_helix_ends_on_its_plane_and_runs_along_its_direction() {
        let (direction, plane) = ([0.0, 1.0, 2.0], [0.3, 0.0, 1.0, 40.0]);
        let edges = [SweptEdge::Share(0.0), SweptEdge::Cut(plane)];
        let patch = CylinderPatch::new(&helix(), direction, edges).unwrap();
        let [first, second] = patch.rails().unwrap();
        for k in 0..=8 {
            let x = f64::from(k) / 8.0;
            let [[p, dp], [q, dq]] = patch.ends_and_slopes(&x).unwrap();
            assert_eq!(p, helix().point(x).unwrap());
            assert!((0.3 * q[0] + q[2] - 40.0).abs() < 1e-13);
            assert!((0.3 * dq[0] + dq[2]).abs() < 1e-13);
            let off = cross(&sub(&q, &p), &direction);
            assert!(off.iter().all(|c| c.abs() < 1e-12), "{off:?}");
            let jets = patch.rail_jets(&x, 1).unwrap();
            for (jets, slope) in jets.iter().zip([dp, dq]) {
                for (jet, slope) in jets.iter().zip(slope) {
                    assert!((jet.derivative(1).unwrap() - slope).abs() < 1e-12);
                }
            }
            for (rail, point) in [(&first, p), (&second, q)] {
                let off = sub(&rail.point(x).unwrap(), &point);
                assert!(off.iter().all(|c| c.abs() < 1e-13), "{off:?}");
            }
        }
        let models = patch.over(&|x| ChebyshevModel::exact(*x)).unwrap();
        assert!(
            models
                .ends_and_slopes(&ChebyshevModel::identity(0.25, 0.5))
                .is_ok()
        );
        assert!(patch.is_developable_by_construction());
    }

    #[test]
    fn arcs_have_cones_but_no_oblique_cuts_of_them() {
        let apex = [0.0, 0.0, 30.0];
        let whole = [SweptEdge::Share(1.0), SweptEdge::Share(0.25)];
        let [near, far] = ConePatch::new(&helix(), apex, whole)
            .unwrap()
            .rails()
            .unwrap();
        for x in [0.0, 0.3, 1.0] {
            let (p, q) = (near.point(x).unwrap(), far.point(x).unwrap());
            let off = sub(&sub(&q, &apex), &scale(&0.25, &sub(&p, &apex)));
            assert!(off.iter().all(|c| c.abs() < 1e-13), "{off:?}");
        }
        let cut = [SweptEdge::Share(1.0), SweptEdge::Cut([0.0, 0.1, 1.0, 20.0])];
        assert!(ConePatch::new(&helix(), apex, cut).is_err());
        let along = [SweptEdge::Share(0.0), SweptEdge::Cut([0.0, 0.0, 1.0, 20.0])];
        assert!(CylinderPatch::new(&helix(), [1.0, 0.0, 0.0], along).is_err());
    }

    #[test]
    fn a_ruled_patch_between_arcs_is_exact_where_one_moves_as_a_multiple_of_the_other() {
        let arc = |centre: Point, size: f64, turns: f64| {
            let (a, b) = ([size, 0.0, 0.0], [0.0, 2.0 * size, 0.0]);
            Rail::from(EllipticHelix::new(centre, a, b, [0.0; 3], [0.0, turns]).unwrap())
        };
        let exact = |first: Rail, second: Rail| {
            Rails::<f64>::is_developable_by_construction(&Sheet::ruled(first, second))
        };
        let low = || arc([0.0; 3], 2.0, 3.0);
        assert!(exact(low(), arc([1.0, 0.0, 5.0], 1.0, 3.0)));
        assert!(!exact(low(), arc([1.0, 0.0, 5.0], 1.0, 2.0)));
        let other = EllipticHelix::new(
            [0.0, 0.0, 5.0],
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0; 3],
            [0.0, 3.0],
        );
        assert!(!exact(low(), Rail::from(other.unwrap())));
    }
}
