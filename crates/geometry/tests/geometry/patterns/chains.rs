//! Several patches in one pattern.

use crate::support::{helix, unroll};
use torse_algebra::Jet;
use torse_geometry::curve::ellipse_arc;
use torse_geometry::pattern::{PatternError, PatternPlace};
use torse_geometry::surface::Rails;
use torse_geometry::vector::{norm, sub};
use torse_geometry::{Bernstein, Curve, GeometryError, RuledSurface};

/// The part of a patch between two parameters, perhaps with its rails exchanged or run backwards.
struct Part<'a> {
    whole: &'a dyn Rails<f64>,
    range: [f64; 2],
    exchanged: bool,
}

impl Rails<f64> for Part<'_> {
    fn rail_jets(&self, x: &f64, order: usize) -> Result<[[Jet<f64>; 3]; 2], GeometryError> {
        let [from, to] = self.range;
        let [p, q] = self.whole.rail_jets(&(from + x * (to - from)), order)?;
        let stretched = |jet: Jet<f64>| {
            let mut power = 1.0;
            let mut list = jet.coefficients().iter().map(|c| {
                let value = c * power;
                power *= to - from;
                value
            });
            let first = list.next().unwrap();
            Jet::from_coefficients(first, list.collect::<Vec<_>>())
        };
        let (p, q) = (p.map(stretched), q.map(stretched));
        Ok(if self.exchanged { [q, p] } else { [p, q] })
    }
}

#[test]
fn a_chain_of_parts_is_the_pattern_of_the_whole_however_the_parts_are_run() {
    let whole = helix(1.0, 0.5, 0.8, [0.5, 2.0]);
    let flat = unroll(&whole, 33, 1e-8).unwrap();
    let part = |range, exchanged| {
        unroll(
            &Part {
                whole: &whole,
                range,
                exchanged,
            },
            17,
            1e-8,
        )
        .unwrap()
    };
    for (first, second) in [
        (part([0.0, 0.5], false), part([0.5, 1.0], false)),
        (part([0.0, 0.5], false), part([0.5, 1.0], true)),
        (part([0.0, 0.5], true), part([1.0, 0.5], false)),
        (part([0.5, 0.0], false), part([1.0, 0.5], true)),
        (part([0.5, 1.0], true), part([0.0, 0.5], true)),
        (part([0.5, 1.0], false), part([0.5, 0.0], true)),
    ] {
        let chain = first.append(&second, 1e-9).unwrap();
        assert_eq!((chain.pieces(), chain.rulings().len()), (2, 33));
        assert!((chain.outline().area() - flat.outline().area()).abs() < 1e-7);
        assert!((chain.outline().length() - flat.outline().length()).abs() < 1e-6);
        assert!(chain.errors().outline < 1e-7);
        // Folded it is the whole again, and the joint is bent like its neighbours.
        let (a, b) = (
            chain.fold_deviation().unwrap(),
            flat.fold_deviation().unwrap(),
        );
        assert!((a - b).abs() < 1e-6, "{a} {b}");
        let bends: Vec<f64> = chain.rulings().iter().map(|r| r.bend).collect();
        assert!(
            (bends[16] - bends[15]).abs() < 1e-3 * bends[16].abs(),
            "{bends:?}"
        );
        // A point of the second part comes back from the sheet.
        let place = PatternPlace {
            piece: 1,
            x: 0.3,
            v: 0.4,
        };
        let lifted = chain.lift(chain.flatten(place).unwrap()).unwrap();
        assert!(norm(&sub(&lifted, &chain.space(place).unwrap())) < 1e-9);
    }
    let (near, far) = (part([0.0, 0.5], false), part([0.6, 1.0], false));
    assert!(matches!(
        near.append(&far, 1e-6),
        Err(PatternError::NoCommonRuling { distance, .. }) if distance > 0.1
    ));
    // Two three-quarter turns overlap.
    let long = |range| Part {
        whole: &whole,
        range,
        exchanged: false,
    };
    let twice = unroll(&long([0.0, 0.9]), 9, 1e-4)
        .unwrap()
        .append(&unroll(&long([0.9, 1.7]), 9, 1e-4).unwrap(), 1e-6);
    assert!(
        matches!(twice, Err(PatternError::CrossesItself { .. })),
        "{twice:?}"
    );
}

#[test]
fn triangles_between_cones_are_one_outline() {
    // A quarter of a transition from a square to a circle: the corner of the triangle is a rail without length.
    let cone = RuledSurface::new(
        ellipse_arc(&[75.0, 75.0, 0.0], &[100.0, 75.0, 0.0], &[75.0, 100.0, 0.0]).unwrap(),
        ellipse_arc(&[0.0, 0.0, 130.0], &[60.0, 0.0, 130.0], &[0.0, 60.0, 130.0]).unwrap(),
    );
    let rail = |a: [f64; 3], b: [f64; 3]| Curve::new(Bernstein, vec![a, b]).unwrap();
    let top = [0.0, 60.0, 130.0];
    let triangle = RuledSurface::new(
        rail([75.0, 100.0, 0.0], [-75.0, 100.0, 0.0]),
        rail(top, top),
    );
    let next = RuledSurface::new(
        ellipse_arc(
            &[-75.0, 75.0, 0.0],
            &[-75.0, 100.0, 0.0],
            &[-100.0, 75.0, 0.0],
        )
        .unwrap(),
        ellipse_arc(
            &[0.0, 0.0, 130.0],
            &[0.0, 60.0, 130.0],
            &[-60.0, 0.0, 130.0],
        )
        .unwrap(),
    );
    let [first, second, third] = [
        unroll(&cone, 9, 1e-3).unwrap(),
        unroll(&triangle, 9, 1e-3).unwrap(),
        unroll(&next, 9, 1e-3).unwrap(),
    ];
    let chain = first
        .append(&second, 1e-6)
        .unwrap()
        .append(&third, 1e-6)
        .unwrap();
    let area = first.area() + second.area() + third.area();
    assert!((chain.outline().area() - area).abs() <= chain.errors().area);
    let segments = chain.outline().segments();
    assert!(segments.iter().all(|s| s.chord_length() > 1e-9));
    let ends = segments.iter().zip(segments.iter().cycle().skip(1));
    assert!(ends.into_iter().all(|(a, b)| a.to == b.from));
}
