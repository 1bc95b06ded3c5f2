//! Flat patterns as drawings.

use torse_exchange::{Drawing, Layer, dxf};
use torse_geometry::RuledSurface;
use torse_geometry::curve::ellipse_arc;
use torse_geometry::pattern::unroll;

#[test]
fn the_bends_of_a_quarter_tube_turn_it_by_a_right_angle() {
    let ring = |z: f64| ellipse_arc(&[0.0, 0.0, z], &[2.0, 0.0, z], &[0.0, 2.0, z]).unwrap();
    let flat = unroll(&RuledSurface::new(ring(0.0), ring(3.0)), 16, 1e-6).unwrap();
    let drawing = Drawing::of_pattern(&flat, 0.0).unwrap();
    let read = Drawing::from_dxf(&dxf(&drawing).unwrap()).unwrap();
    assert_eq!(read, drawing);
    let bends: Vec<f64> = read.paths().iter().filter_map(|path| path.bend()).collect();
    // The first and the last ruling carry no bend, half a step of turning is lost at each end.
    let steps = (bends.len() - 1) as f64;
    let turned: f64 = bends.iter().sum::<f64>().abs();
    let exact = std::f64::consts::FRAC_PI_2 * (1.0 - 1.0 / steps);
    assert!((turned - exact).abs() < 1e-9, "{turned} {exact}");
    let bent = [Layer::BendUp, Layer::BendDown].map(|layer| {
        read.paths()
            .iter()
            .filter(|path| path.layer() == layer)
            .count()
    });
    assert_eq!(
        (bent[0].max(bent[1]), bent[0].min(bent[1])),
        (bends.len() - 2, 0)
    );
    assert!(read.notes()[0].starts_with("outline within "));
}
