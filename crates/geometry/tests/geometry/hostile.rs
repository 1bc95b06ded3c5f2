//! Nothing that comes in makes the library panic or hang.

use proptest::prelude::*;
use torse_algebra::{ExactError, Jet};
use torse_geometry::developable::certify;
use torse_geometry::pattern::{PatternError, unroll};
use torse_geometry::{
    Basis, Bernstein, Continuity, Curve, EnvelopingPatch, Forms, Gbt, GeometryError, HermiteCone,
    PatchBounds, PlaneFamily, RationalCurve, RotationSurface, Surface, TensorSurface, curve, join,
};

fn any() -> impl Strategy<Value = f64> {
    prop_oneof![
        prop::num::f64::ANY,
        -2.0..2.0_f64,
        Just(0.0),
        Just(f64::NAN),
        Just(f64::INFINITY),
        Just(f64::MAX),
        Just(f64::MIN_POSITIVE),
    ]
}

fn points<const D: usize>() -> impl Strategy<Value = Vec<[f64; D]>> {
    prop::collection::vec(prop::array::uniform(any()), 0..6)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 256, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn curves_and_families_never_panic(
        planes in points::<4>(), spots in points::<3>(), mu in any(), nu in any(), x in any(), y in any(),
        weights in prop::collection::vec(any(), 0..6),
    ) {
        let Ok(basis) = Gbt::new(mu, nu) else { return Ok(()) };
        let _ = RationalCurve::new(basis, &spots, weights).map(|c| c.derivatives(&x, 2));
        if let Ok(curve) = Curve::new(basis, spots.clone()) {
            let _ = (curve.point(&x), curve.derivatives(&x, 3), curve.shape_derivatives(&x));
            let _ = (curve::curvature(&curve, x), curve::torsion(&curve, x));
            let _ = TensorSurface::cylinder(&curve, &[x, y, 1.0], &y);
            if let Ok(joint) = Continuity::beta(vec![x, y]) {
                let _ = join::next_curve(&curve, Bernstein, &joint, &spots);
            }
        }
        if let Ok(family) = PlaneFamily::new(basis, planes) {
            let _ = (family.ruling(&x), family.characteristic_point(&x));
            if let Ok(patch) = EnvelopingPatch::new(family, PatchBounds::Range([x, y])) {
                let _ = certify(&patch, 0);
            }
        }
    }

    #[test]
    fn cones_and_profiles_never_panic(
        summit in prop::array::uniform3(any()), k in any(),
        q in prop::array::uniform4(prop::array::uniform3(any())), angle in any(), profile in points::<2>(),
    ) {
        if let Ok(cone) = HermiteCone::cubic(summit, k, q) {
            let _ = cone.patch().map(|patch| certify(&patch, 0));
        }
        if let Ok(profile) = Curve::new(Bernstein, profile) {
            let _ = RotationSurface::turned(&profile, angle);
        }
    }

    #[test]
    fn principal_curvatures_of_any_numbers_end(
        first in prop::array::uniform3(any()), second in prop::array::uniform3(any()), area_squared in any(),
    ) {
        let normal = [0.0; 3];
        let principal = Forms { first, second, area_squared, normal }.principal();
        let known = first[0] > 0.0 && area_squared > 0.0 && second.iter().all(|x| x.is_finite());
        prop_assert!(known || principal.is_err());
    }
}

#[test]
fn nan_and_infinite_accuracies_and_impossible_ones_end_with_an_error() {
    let line = Curve::new(Bernstein, vec![[0.0], [1.0]]).unwrap();
    for accuracy in [f64::NAN, 0.0, -1.0] {
        assert!(curve::arc_length(&line, [0.0, 1.0], accuracy).is_err());
    }
    assert!(curve::arc_length(&line, [0.0, f64::INFINITY], 1e-3).is_err());
    let rail = |z: f64| {
        Curve::new(
            Gbt::new(0.5, 0.5).unwrap(),
            vec![[0.0, z, 0.0], [1.0, 1.0, z], [5.0, z, z]],
        )
    };
    let patch = torse_geometry::RuledSurface::new(rail(1.0).unwrap(), rail(2.0).unwrap());
    assert!(matches!(
        unroll(&patch, 4, f64::NAN),
        Err(PatternError::OutOfRange { .. })
    ));
    assert!(matches!(
        unroll(&patch, 4, f64::MIN_POSITIVE),
        Err(PatternError::NotDevelopable { .. })
    ));
}

#[test]
fn impossible_degrees_and_orders_are_refused_before_memory_is_asked_for() {
    let refused =
        |result: Result<_, GeometryError>| matches!(result, Err(GeometryError::OutOfRange { .. }));
    let line = Curve::new(Bernstein, vec![[0.0], [1.0]]).unwrap();
    for huge in [4097, usize::MAX] {
        assert!(refused(Bernstein.row(huge, &0.5).map(drop)));
        assert!(refused(line.derivatives(&0.5, huge).map(drop)));
    }
    assert!(refused(Bernstein.row(0, &0.5).map(drop)));
    let planes = vec![[1., 0., 0.2, 3.], [0.5, 1., 0.1, 2.], [0., 1., 0.5, 4.]];
    let family = PlaneFamily::new(Bernstein, planes).unwrap();
    assert!(refused(
        family.characteristic_jet(&0.5, usize::MAX).map(drop)
    ));
    let patch = EnvelopingPatch::new(family, PatchBounds::Range([0.0, 1.0])).unwrap();
    assert!(refused(patch.partials(&0.5, &0.5, usize::MAX).map(drop)));
}

/// A family whose series end before the first derivative.
#[derive(Debug, Clone)]
struct ShortSeries;

impl Basis<f64> for ShortSeries {
    fn seeds(&self, x: &f64) -> Result<[f64; 3], ExactError> {
        Bernstein.seeds(x)
    }

    fn seed_jets(&self, x: &f64, _order: usize) -> Result<[Jet<f64>; 3], ExactError> {
        Bernstein.seed_jets(x, 0)
    }

    fn reversed(&self) -> Self {
        Self
    }
}

/// A family that loses the last of its functions, and the last of their derivatives.
#[derive(Debug, Clone)]
struct ShortRows;

impl Basis<f64> for ShortRows {
    fn seeds(&self, x: &f64) -> Result<[f64; 3], ExactError> {
        Bernstein.seeds(x)
    }

    fn seed_jets(&self, x: &f64, order: usize) -> Result<[Jet<f64>; 3], ExactError> {
        Bernstein.seed_jets(x, order)
    }

    fn reversed(&self) -> Self {
        Self
    }

    fn row(&self, degree: usize, x: &f64) -> Result<Vec<f64>, GeometryError> {
        Bernstein.row(degree - 1, x)
    }

    fn series_rows(
        &self,
        degree: usize,
        x: &f64,
        order: usize,
    ) -> Result<Vec<Vec<f64>>, GeometryError> {
        Bernstein.series_rows(degree, x, order.saturating_sub(1))
    }
}

#[test]
fn what_a_family_of_somebody_else_does_not_know_is_refused_and_not_zero() {
    let control = || {
        vec![
            [0.0, 1.0, 2.0],
            [1.0, 3.0, 0.0],
            [2.0, 5.0, 1.0],
            [4.0, 0.0, 1.0],
        ]
    };
    let mismatch = |result: Result<(), GeometryError>| {
        let error = result.unwrap_err();
        assert!(
            matches!(
                error,
                GeometryError::LengthMismatch { .. } | GeometryError::TooFew { .. }
            ),
            "{error}"
        );
    };
    let series = Curve::new(ShortSeries, control()).unwrap();
    assert!(series.point(&0.3).is_ok());
    mismatch(series.derivatives(&0.3, 1).map(drop));
    mismatch(series.jet(&0.3, 1).map(drop));
    mismatch(ShortSeries.seed_slopes(&0.3).map(drop));
    let rows = Curve::new(ShortRows, control()).unwrap();
    mismatch(rows.point(&0.3).map(drop));
    mismatch(rows.derivatives(&0.3, 2).map(drop));
    let net = || vec![control(), control(), control()];
    let surface = TensorSurface::new(ShortRows, Bernstein, net()).unwrap();
    mismatch(surface.point(&0.3, &0.3).map(drop));
    mismatch(surface.partials(&0.3, &0.3, 2).map(drop));
    let surface = TensorSurface::new(Bernstein, ShortSeries, net()).unwrap();
    mismatch(surface.partials(&0.3, &0.3, 1).map(drop));
    let plane = |k: f64| [k, 1.0 - k * k, 0.5, 3.0];
    let planes = [0.0, 0.5, 1.0, 2.0].map(plane).to_vec();
    let family = PlaneFamily::new(ShortSeries, planes).unwrap();
    mismatch(family.ruling(&0.3).map(drop));
}
