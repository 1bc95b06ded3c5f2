//! The sheet between pattern and patch: every state is isometric to the pattern.

use crate::support::{cone, cubic, helix, unroll};
use torse_geometry::pattern::{FlatPattern, PatternError, deviation};
use torse_geometry::vector::{dot, norm, sub};

fn patches() -> Vec<(&'static str, FlatPattern)> {
    vec![
        (
            "cone",
            unroll(&cone([1.0, 3.0], 4.0, 4.0), 33, 1e-6).unwrap(),
        ),
        (
            "helix",
            unroll(&helix(1.0, 0.5, 0.8, [0.5, 2.0]), 33, 1e-6).unwrap(),
        ),
        ("cubic", unroll(&cubic(), 33, 1e-6).unwrap()),
    ]
}

fn distance<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
    squares.sum::<f64>().sqrt()
}

#[test]
fn every_length_of_every_state_is_that_of_the_pattern() {
    for (name, flat) in patches() {
        let pattern: Vec<[[f64; 2]; 2]> = flat.rulings().iter().map(|r| r.ends).collect();
        for share in [0.0, 0.1, 0.5, 0.9, 1.0, 1.3] {
            let bent = flat.bent(share).unwrap().rulings();
            assert_eq!(bent.len(), pattern.len());
            for (there, here) in bent.windows(2).zip(pattern.windows(2)) {
                // Rulings, edges and diagonals of a facet: it moves as one.
                for (i, k) in [(0, 1), (0, 2), (1, 3), (0, 3), (1, 2), (2, 3)] {
                    let (there, here) = (there.as_flattened(), here.as_flattened());
                    let (long, flat) =
                        (distance(&there[i], &there[k]), distance(&here[i], &here[k]));
                    assert!((long - flat).abs() < 1e-11, "{name} {share}: {long} {flat}");
                }
            }
        }
    }
}

#[test]
fn without_a_bend_it_is_the_pattern_and_with_all_of_it_the_patch() {
    for (name, flat) in patches() {
        let ends = |share: f64| -> Vec<[f64; 3]> {
            let bent = flat.bent(share).unwrap();
            bent.rulings().into_iter().flatten().collect()
        };
        let pattern: Vec<[f64; 3]> = flat
            .rulings()
            .iter()
            .flat_map(|r| r.ends.map(|[x, y]| [x, y, 0.0]))
            .collect();
        assert!(deviation(&ends(0.0), &pattern).unwrap() < 1e-11, "{name}");
        let patch: Vec<[f64; 3]> = flat.rulings_in_space().into_iter().flatten().collect();
        let bent = ends(1.0);
        let off = bent.iter().zip(&patch).map(|(a, b)| distance(a, b));
        let off = off.fold(0.0, f64::max);
        let expected = flat.fold_deviation().unwrap();
        assert!((off - expected).abs() < 1e-9, "{name}: {off} {expected}");
        // A blend of points between them would be shorter or longer than the sheet.
        assert!(deviation(&ends(0.5), &patch).unwrap() > 0.05, "{name}");
    }
}

#[test]
fn the_facet_in_the_middle_stays_where_it_is() {
    for (name, flat) in patches() {
        let middle = flat.rulings().len() / 2;
        let [there, here] = [1.0, 0.3].map(|share| flat.bent(share).unwrap());
        for ruling in [middle - 1, middle] {
            for end in 0..2 {
                let (a, b) = (there.rulings()[ruling][end], here.rulings()[ruling][end]);
                assert!(norm(&sub(&a, &b)) < 1e-11, "{name}");
            }
        }
        let normals = [there.normals(), here.normals()];
        assert_eq!(normals[0].len(), flat.rulings().len() - 1);
        assert!(dot(&normals[0][middle - 1], &normals[1][middle - 1]) > 1.0 - 1e-12);
    }
}

#[test]
fn points_of_the_pattern_go_with_their_facet() {
    for (name, flat) in patches() {
        let bent = flat.bent(0.6).unwrap();
        let rulings = bent.rulings();
        let pairs = flat.rulings().windows(2).zip(rulings.windows(2));
        for (number, (flat, there)) in pairs.enumerate() {
            let mid = |a: f64, b: f64, c: f64, d: f64| 0.25 * (a + b + c + d);
            let [[a, b], [c, d]] = [flat[0].ends, flat[1].ends];
            let centre = [0, 1].map(|k| mid(a[k], b[k], c[k], d[k]));
            let point = bent.point(centre).unwrap();
            for (corner, bent) in [a, b, c, d].iter().zip(there.as_flattened()) {
                let off = distance(&point, bent) - distance(&centre, corner);
                assert!(off.abs() < 1e-11, "{name} {number}: {off:e}");
            }
        }
        assert_eq!(bent.point([1e3, 1e3]), None);
        let [first, second] = rulings[5];
        let beyond = bent.on_ruling(5, 2.0).unwrap();
        let wanted = [0, 1, 2].map(|k| 2.0 * second[k] - first[k]);
        assert!(distance(&beyond, &wanted) < 1e-11, "{name}");
        assert_eq!(bent.on_ruling(rulings.len(), 0.0), None);
    }
}

#[test]
fn a_share_that_is_no_number_is_refused() {
    let (_, flat) = patches().remove(0);
    for share in [f64::NAN, f64::INFINITY] {
        let refused = flat.bent(share);
        assert!(matches!(refused, Err(PatternError::OutOfRange { .. })));
    }
}
