//! Sheets of every construction as CAD patches.

use torse_exchange::{ExactForm, ExchangeError, approximate, approximate_tensor, convert};
use torse_geometry::TensorSurface;
use torse_geometry::prelude::*;
use torse_geometry::vector::{norm, sub};

const PLANES: [[f64; 4]; 4] = [
    [0., 0., 1., 0.],
    [0., -1., 1., 0.],
    [1., -2., 1., 0.],
    [3., -3., 1., 1.],
];

#[test]
fn sheets_that_are_polynomial_or_rational_have_exact_forms() {
    let planes = Planes::bernstein(&PLANES).unwrap();
    let cut = Cut::between([1., 0., 0., 2.], [1., 0., 0., 4.]);
    let low = Rail::bezier(&[[0., 0., 0.], [1., 2., 0.], [3., 0., 0.]]).unwrap();
    let high = Rail::weighted(
        BasisShape::Bernstein,
        &[[0., 0., 2.], [1., 2., 2.], [3., 0., 2.]],
        &[1.0, 2.0, 1.0],
    )
    .unwrap();
    for (sheet, developable) in [
        (Sheet::envelope(&planes, cut).unwrap(), true),
        (Sheet::tangent(&planes, 0.5, 1.0).unwrap(), true),
        (Sheet::ruled(low, high), false),
    ] {
        let converted = convert(&sheet, 1e-6).unwrap();
        assert!(converted.error < 1e-12, "{}", converted.error);
        let patch = &converted.patches[0];
        assert_eq!(patch.is_declared_developable(), developable);
        // The first corner of the net is the first point of the sheet.
        let corner = sub(&patch.net()[0][0], &sheet.point(0.0, 0.0).unwrap());
        assert!(norm(&corner) < 1e-12, "{corner:?}");
    }
}

#[test]
fn sheets_without_exact_form_are_approximated() {
    let cut = Cut::between([1., 0., 0., 2.], [1., 0., 0., 4.]);
    let planes = Planes::gbt(0.5, 0.5, &PLANES).unwrap();
    // Two curves on the cone x^2 + y^2 = z^2 / 4 about the axis.
    let arc = |r: f64, z: f64| Rail::ellipse_arc([0., 0., z], [r, 0., z], [0., r, z]).unwrap();
    let found = Sheet::between(&arc(1.0, 2.0), &arc(2.0, 4.0)).unwrap();
    for sheet in [Sheet::envelope(&planes, cut).unwrap(), found.sheet.unwrap()] {
        let refused = sheet.exact_form();
        assert!(matches!(refused, Err(ExchangeError::NotRational { .. })));
        let converted = convert(&sheet, 1e-3).unwrap();
        assert!(converted.error > 0.0 && converted.error <= 1e-3);
        assert_eq!(converted, approximate(&sheet, 1e-3).unwrap());
        assert!(converted.patches[0].is_declared_developable());
    }
}

#[test]
fn shapes_chosen_at_run_time_make_tensor_surfaces_that_are_converted() {
    let net: Vec<Vec<[f64; 3]>> = (0..4)
        .map(|i| {
            (0..3)
                .map(|j| [f64::from(i), f64::from(j), f64::from(i * j)])
                .collect()
        })
        .collect();
    let with = |shape: BasisShape<f64>| TensorSurface::new(shape, shape, net.clone()).unwrap();
    assert_eq!(with(BasisShape::Bernstein).exact_form().unwrap().error, 0.0);
    let trigonometric = with(BasisShape::gbt(0.5, 0.25).unwrap());
    let refused = trigonometric.exact_form();
    assert!(matches!(refused, Err(ExchangeError::NotRational { .. })));
    assert!(approximate_tensor(&trigonometric, 1e-4).unwrap().error <= 1e-4);
}
