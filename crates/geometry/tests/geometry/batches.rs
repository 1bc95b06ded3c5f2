//! Many parameters at once: the same bits as one by one, and the same refusals.

use crate::ulps::{points, shape, unit};
use proptest::prelude::*;
use torse_geometry::basis::BasisShape;
use torse_geometry::{Basis, Bernstein, Curve, Gbt, GeometryError, PlaneFamily};

/// A basis of either family.
fn basis() -> impl Strategy<Value = BasisShape<f64>> {
    prop_oneof![
        Just(BasisShape::Bernstein),
        (shape(), shape()).prop_map(|(mu, nu)| Gbt::new(mu, nu).unwrap().into()),
    ]
}

fn parameters() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(prop_oneof![4 => unit(), 1 => -0.5..1.5_f64], 1..100)
}

fn same_points<B: Basis<f64>>(
    basis: &B,
    points: Vec<[f64; 3]>,
    xs: &[f64],
) -> Result<(), TestCaseError> {
    let curve = Curve::new(basis.clone(), points).unwrap();
    let mut out = vec![[f64::NAN; 3]; xs.len()];
    curve.points_into(xs, &mut out).unwrap();
    for (x, many) in xs.iter().zip(&out) {
        prop_assert_eq!(
            many.map(f64::to_bits),
            curve.point(x).unwrap().map(f64::to_bits)
        );
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 128, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn points_in_batches_have_the_bits_of_single_points(
        basis in basis(), points in points::<3>(2..=9_usize), xs in parameters(),
    ) {
        same_points(&basis, points.clone(), &xs)?;
        same_points(&Bernstein, points, &xs)?;
    }

    #[test]
    fn rulings_in_batches_have_the_bits_of_single_rulings(
        basis in basis(), planes in points::<4>(3..=7_usize), scale in -300..300_i32, xs in parameters(),
    ) {
        let planes = planes.iter().map(|p| p.map(|c| c * 2_f64.powi(scale))).collect();
        let family = PlaneFamily::new(basis, planes).unwrap();
        let like = PlaneFamily::new(Bernstein, vec![[1., 0., 0., 1.], [0., 1., 0., 1.], [0., 0., 1., 1.]]);
        let mut out = vec![like.unwrap().ruling(&0.5).unwrap(); xs.len()];
        let single: Result<Vec<_>, _> = xs.iter().map(|x| family.ruling(x)).collect();
        match (family.rulings_into(&xs, &mut out), single) {
            (Ok(()), Ok(single)) => prop_assert_eq!(out, single),
            (many, single) => prop_assert_eq!(many, single.map(|_| ())),
        }
    }
}

#[test]
fn the_first_parameter_without_a_ruling_is_named() {
    // The family stands still at its start.
    let q = [0.0, 1.0, 0.0, 1.0];
    let planes = vec![q, q, [1.0, 0.0, 0.0, 1.0], [0.0, 0.0, 1.0, 1.0]];
    let family = PlaneFamily::new(Bernstein, planes).unwrap();
    let mut xs: Vec<f64> = (1..=200).map(|i| f64::from(i) / 200.0).collect();
    let mut out = vec![family.ruling(&0.5).unwrap(); xs.len()];
    assert_eq!(family.rulings_into(&xs, &mut out), Ok(()));
    xs[150] = 0.0;
    let refused = Err(GeometryError::NoRuling { parameter: 0.0 });
    assert_eq!(family.rulings_into(&xs, &mut out), refused);
    assert_eq!(family.par_rulings_into(&xs, &mut out), refused);
    xs[170] = f64::NAN;
    xs[150] = 0.5;
    let error = family.rulings_into(&xs, &mut out).unwrap_err();
    assert_eq!(
        error.to_string(),
        "curve parameter, entry 170: NaN is not a finite number"
    );
    let mut points = vec![[0.0; 4]; xs.len()];
    let same = family.curve().points_into(&xs, &mut points).unwrap_err();
    assert_eq!(same.to_string(), error.to_string());
}
