//! Ends of patches at which the normal vanishes by its kind: proofs with reduced data.
//!
//! At a tip the ruling `R` has no length, where rails stand still their speeds `P', Q'` are zero, so the normals
//! `R x P'`, `R x Q'` vanish there although the tangent plane has a limit. A function with a zero of order `k` at the
//! end is `(x - end)^k` times a value of its `k`-th derivative over `k!` somewhere between (Taylor's formula),
//! coordinate by coordinate. So the *reduced* data, without that factor, lie in the box of the ranges of that
//! derivative, and the normals of the patch are those of the reduced data but for a positive factor and a sign that
//! both have in common.

use crate::coordinate::Coordinate;
use crate::model::ChebyshevModel;
use crate::surface::{EndKinds, RailEnd, RailKind, Rails, RulingEnd};
use crate::vector::{cross, dot, sub};
use torse_algebra::Jet;

type Vector = [ChebyshevModel; 3];

/// Proves that a patch is regular between an end that is special by its kind, the first or the last, and the ruling at
/// the distance `width` from it (`kinds` are those of its exact control data), but for the end itself: the normals at
/// both ends of each ruling point to the same side. Returns a bound of the angle between them in radians; `None` where
/// that is not proved, and of an ordinary end.
pub(crate) fn regular_end<R: Rails<ChebyshevModel> + ?Sized>(
    patch: &R,
    kinds: EndKinds,
    last: bool,
    width: f64,
) -> Option<f64> {
    let end = usize::from(last);
    let order = |rail: RailKind| match rail {
        RailKind::Point => None,
        RailKind::Curve { ends, .. } => Some(match ends[end] {
            RailEnd::Ordinary => 0,
            RailEnd::Still { order } => order,
        }),
    };
    let [Some(p), Some(q)] = kinds.rails().map(order) else {
        return None;
    };
    let tip = match kinds.rulings()[end] {
        RulingEnd::Tip if p == 0 && q == 0 => true,
        RulingEnd::Still => false,
        RulingEnd::Tip | RulingEnd::Ordinary => return None,
    };
    let x = if last {
        ChebyshevModel::identity(1.0 - width, 1.0)
    } else {
        ChebyshevModel::identity(0.0, width)
    };
    let [first, second] = patch.rail_jets(&x, 1 + p.max(q)).ok()?;
    let ruling: Vector = if tip {
        boxed(&sub(&slopes(&second, 0)?, &slopes(&first, 0)?))?
    } else {
        sub(&points(&second), &points(&first))
    };
    let speed = |jets: &[Jet<ChebyshevModel>; 3], order: usize| -> Option<Vector> {
        let reduced = slopes(jets, order)?;
        match (order, last && order % 2 == 1) {
            (0, _) => Some(reduced),
            (_, false) => boxed(&reduced),
            (_, true) => boxed(&reduced.map(|c| -c)),
        }
    };
    let normals = [speed(&first, p)?, speed(&second, q)?].map(|speed| cross(&ruling, &speed));
    let [n0, n1] = &normals;
    let inner = dot(n0, n1).range()[0];
    if inner.is_nan() || inner <= 0.0 {
        return None;
    }
    if patch.is_developable_by_construction() {
        return Some(0.0);
    }
    let between = cross(n0, n1);
    let least = dot(n0, n0).range()[0] * dot(n1, n1).range()[0];
    let sine = (dot(&between, &between).range()[1] / least).sqrt();
    let sine = sine * (1.0 + 8.0 * f64::EPSILON);
    (sine < 1.0).then(|| libm::asin(sine) * (1.0 + 8.0 * f64::EPSILON))
}

fn points(jets: &[Jet<ChebyshevModel>; 3]) -> Vector {
    jets.each_ref().map(|jet| *jet.value())
}

/// The derivative of order `order` of the speed, over the factorial of `order`.
fn slopes(jets: &[Jet<ChebyshevModel>; 3], order: usize) -> Option<Vector> {
    let slope = |jet: &Jet<ChebyshevModel>| {
        let coefficient = jet.coefficients().get(order + 1)?;
        Some(coefficient.natural(order + 1) * *coefficient)
    };
    match jets.each_ref().map(slope) {
        [Some(x), Some(y), Some(z)] => Some([x, y, z]),
        _ => None,
    }
}

/// Any values within the ranges of these functions, each coordinate at a place of its own.
fn boxed(vector: &Vector) -> Option<Vector> {
    let constant = |model: &ChebyshevModel| {
        let [low, high] = model.range();
        let middle = 0.5 * (low + high);
        let reach = (high - middle).max(middle - low).next_up();
        reach
            .is_finite()
            .then(|| ChebyshevModel::exact(middle).widened(reach))
    };
    match vector.each_ref().map(constant) {
        [Some(x), Some(y), Some(z)] => Some([x, y, z]),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::over::Over;
    use crate::prelude::*;

    fn proved(sheet: &Sheet, last: bool) -> Option<f64> {
        let models = sheet.over(&|x| ChebyshevModel::exact(*x)).unwrap();
        let kinds = Rails::<f64>::end_kinds(sheet);
        regular_end(&models, kinds, last, 1.0 / 4096.0)
    }

    #[test]
    fn a_tip_is_regular_where_the_edges_leave_it_at_an_angle() {
        let rail = |points: &[Point]| Rail::bezier(points).unwrap();
        let edge = rail(&[[0.0; 3], [0.0, 40.0, 900.0], [20.0, 10.0, 1700.0]]);
        let other = rail(&[[0.0; 3], [300.0, 40.0, 900.0], [620.0, 10.0, 1700.0]]);
        let sheet = Sheet::ruled(edge.clone(), other.clone());
        assert!(proved(&sheet, false).is_some());
        // An ordinary end has nothing to be proved of this kind.
        assert_eq!(proved(&sheet, true), None);
        let turned = Sheet::ruled(edge.reversed(), other.reversed());
        assert!(proved(&turned, true).is_some());
        // Both edges leave it in the same direction: the reduced normal vanishes too.
        let tangent = rail(&[[0.0; 3], [0.0, 20.0, 450.0], [300.0, 10.0, 900.0]]);
        assert_eq!(proved(&Sheet::ruled(edge, tangent), false), None);
    }

    #[test]
    fn edges_that_stand_still_together_have_the_tangent_plane_of_what_is_left() {
        let wall = |order: usize, z: f64| {
            let mut points = vec![[0.0, 0.0, z]; order + 1];
            points.extend([[60.0, 40.0, z], [90.0, 0.0, z]]);
            Rail::bezier(&points).unwrap()
        };
        for order in 1..4 {
            let sheet = Sheet::ruled(wall(order, 0.0), wall(order, 70.0));
            assert_eq!(proved(&sheet, false), Some(0.0), "{order}");
            let turned = Sheet::ruled(wall(order, 0.0).reversed(), wall(order, 70.0).reversed());
            assert_eq!(proved(&turned, true), Some(0.0), "{order}");
        }
        // One of them turned about: the normals oppose.
        let back = Rail::bezier(&[[0.0, 0.0, 70.0], [0.0, 0.0, 70.0], [-60.0, -40.0, 70.0]]);
        let crossed = Sheet::ruled(wall(1, 0.0), back.unwrap());
        assert_eq!(proved(&crossed, false), None);
    }
}
