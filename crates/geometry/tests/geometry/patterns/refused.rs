//! What cannot be cut from a sheet is refused, with numbers.

use crate::support::{helix, unroll};
use torse_geometry::pattern::{PatternError, Unrolling};
use torse_geometry::{Bernstein, Curve, RuledSurface};

#[test]
fn what_cannot_be_cut_from_a_sheet_is_refused_with_numbers() {
    // A helix patch that turns by more than a full turn overlaps itself.
    let round = unroll(&helix(1.0, 0.5, 1.5, [0.5, 1.0]), 17, 1e-4);
    assert!(
        matches!(round, Err(PatternError::CrossesItself { .. })),
        "{round:?}"
    );
    // Across its edge of regression, at t = 0 a quarter of the way.
    let across = unroll(&helix(1.0, 0.5, 0.3, [-1.0, 3.0]), 17, 1e-4);
    let Err(PatternError::Regression { v, depth, .. }) = across else {
        panic!("{across:?}");
    };
    assert!((v - 0.25).abs() < 1e-9 && (depth - 1.0).abs() < 1e-9);
    // A billionth inside is inside, a billionth outside is outside, and on the edge is a sheet.
    let edge = |from: f64| unroll(&helix(1.0, 0.5, 0.3, [from, 1.0]), 17, 1e-4);
    assert!(matches!(edge(-1e-9), Err(PatternError::Regression { .. })));
    assert!(edge(1e-9).is_ok() && edge(0.0).is_ok());
    // A saddle.
    let rail = |points: [[f64; 3]; 2]| Curve::new(Bernstein, points.to_vec()).unwrap();
    let saddle = RuledSurface::new(
        rail([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]),
        rail([[0.0, 1.0, 0.0], [1.0, 1.0, 1.0]]),
    );
    let Err(PatternError::NotDevelopable {
        strain,
        twist,
        limit,
        ..
    }) = unroll(&saddle, 17, 1e-6)
    else {
        panic!("a saddle");
    };
    assert!(limit == 1e-6 && strain > 1e-3 && twist > 0.1);
    let allowed = Unrolling::within(1e-6)
        .allow_strain(0.5)
        .unroll(&saddle)
        .unwrap();
    assert!(allowed.is_strained() && allowed.strain() > 0.05);
    // A cusp: the first rail and the second turn back together.
    let cusp = |z: f64| {
        let points = vec![
            [1., -1., z],
            [-1. / 3., 1., z],
            [-1. / 3., -1., z],
            [1., 1., z],
        ];
        Curve::new(Bernstein, points).unwrap()
    };
    let cusp = unroll(&RuledSurface::new(cusp(0.0), cusp(1.0)), 17, 1e-4);
    assert!(
        matches!(
            cusp,
            Err(PatternError::NoTangentPlane { x } | PatternError::NotReached { x, .. }) if (x - 0.5).abs() < 1e-6
        ),
        "{cusp:?}"
    );
    // No width.
    let line = rail([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]);
    let none = unroll(&RuledSurface::new(line.clone(), line), 17, 1e-4);
    assert_eq!(none, Err(PatternError::NoRuling { x: 0.0 }));
}
