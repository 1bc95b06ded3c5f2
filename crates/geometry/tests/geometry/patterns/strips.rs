//! Random twisted strips against developments that were integrated elsewhere with 40 digits: `tests/strips/strips.py`.

use torse_geometry::pattern::{Flattening, PatternPlace, Unrolling};
use torse_geometry::sheet::{Rail, Sheet};
use torse_geometry::vector::{norm, sub};

const WRITTEN: &str = include_str!("../../strips/strips.csv");

/// The ends of the rulings at the quarters, and the lengths of both edges.
type Developed = ([[[f64; 2]; 2]; 4], [f64; 2]);

/// A strip with its developments.
struct Strip {
    rails: [Vec<[f64; 3]>; 2],
    /// The largest twist in degrees.
    twist: f64,
    /// For each name the ends of the rulings at the quarters, and the lengths of both edges.
    developments: Vec<Developed>,
}

fn strips() -> Vec<Strip> {
    let strip = |line: &str| {
        let numbers: Vec<f64> = line.split(',').map(|n| n.parse().unwrap()).collect();
        let rail = |k: usize| {
            numbers[12 * k..12 * (k + 1)]
                .chunks(3)
                .map(|c| c.try_into().unwrap())
        };
        let developments = numbers[25..].chunks(18).map(|list| {
            let ruling = |k: usize| {
                [
                    [list[4 * k], list[4 * k + 1]],
                    [list[4 * k + 2], list[4 * k + 3]],
                ]
            };
            ([0, 1, 2, 3].map(ruling), [list[16], list[17]])
        });
        Strip {
            rails: [rail(0).collect(), rail(1).collect()],
            twist: numbers[24],
            developments: developments.collect(),
        }
    };
    WRITTEN.lines().map(strip).collect()
}

/// The largest distance of the rulings of one development from those of another that is moved so that both have the ruling
/// in the middle (1/2) in common.
fn apart(one: &[[[f64; 2]; 2]; 4], other: &[[[f64; 2]; 2]; 4]) -> f64 {
    let angle = |r: &[[f64; 2]; 2]| libm::atan2(r[1][1] - r[0][1], r[1][0] - r[0][0]);
    let (s, c) = libm::sincos(angle(&one[1]) - angle(&other[1]));
    let moved = |p: &[f64; 2]| {
        let [x, y] = sub(p, &other[1][0]);
        [one[1][0][0] + c * x - s * y, one[1][0][1] + s * x + c * y]
    };
    let pairs = one.iter().flatten().zip(other.iter().flatten());
    pairs
        .map(|(p, q)| norm(&sub(p, &moved(q))))
        .fold(0.0, f64::max)
}

#[test]
fn no_bound_is_below_the_error_of_the_named_development_nor_the_ambiguity_below_the_others() {
    let strips = strips();
    assert!(strips.len() >= 200);
    let (mut unrolled, mut decades) = (0, [0; 12]);
    for (number, strip) in strips.iter().enumerate() {
        let [p, q] = strip
            .rails
            .each_ref()
            .map(|points| Rail::bezier(points).unwrap());
        let sheet = Sheet::ruled(p, q);
        let size: f64 = strip
            .rails
            .iter()
            .flatten()
            .flatten()
            .fold(0.0, |m, c| m.max(c.abs()));
        for (k, (name, flattening)) in Flattening::ALL.iter().enumerate() {
            let asked = Unrolling::within(1e-5 * size)
                .allow_strain(0.9)
                .flattening(*flattening);
            let Ok(flat) = sheet.unroll_with(&asked) else {
                continue;
            };
            unrolled += 1;
            let (errors, (exact, lengths)) = (flat.errors(), &strip.developments[k]);
            for (ruling, x) in exact.iter().zip([0.25, 0.5, 0.75, 1.0]) {
                for (point, v) in ruling.iter().zip([0.0, 1.0]) {
                    let found = flat.flatten(PatternPlace { piece: 0, x, v }).unwrap();
                    let off = norm(&sub(&found, point));
                    assert!(
                        off <= errors.point,
                        "strip {number}, {name}, x = {x}: {off:e} {errors:?}"
                    );
                    assert!(errors.point < 1e-6 * size, "strip {number}: {errors:?}");
                }
            }
            // The other developments.
            for (other, _) in &strip.developments {
                let off = apart(exact, other);
                assert!(
                    off <= errors.ambiguity + 1e-13 * size,
                    "strip {number}, {name}: {off:e} {errors:?}"
                );
            }
            // The strain: that of the angle, rounded upwards.
            let sine = libm::sin(strip.twist.to_radians());
            let least = match flattening {
                Flattening::Edges => 1.0 / libm::cos(0.5 * strip.twist.to_radians()) - 1.0,
                Flattening::Between => 0.0,
                _ => 1.0 - libm::cos(strip.twist.to_radians()),
            };
            let strain = flat.strain();
            assert!(
                strain >= 0.999 * least - 1e-15,
                "strip {number}, {name}: {strain:e} {least:e}"
            );
            assert!(
                strain <= 1e-15 + 1.2 * sine * sine,
                "strip {number}, {name}: {strain:e} {sine:e}"
            );
            // The edges: as long as they are in space, or shorter by what is stated.
            let space = strip.developments[0].1;
            for side in [0, 1] {
                let lost = space[side] - lengths[side];
                let stated = flat.shortened(0).unwrap()[side];
                assert!(
                    lost <= stated + 1e-12 * size && lost >= -1e-12 * size,
                    "strip {number}: {lost:e}"
                );
                let own = flat.rail_lengths(0).unwrap()[side];
                assert!((own - lengths[side]).abs() <= 1e-11 * size);
            }
            let decade = (libm::log10(strip.twist) + 10.0).floor();
            decades[decade as usize] += 1;
        }
    }
    // Of some the edge of regression runs inside, or the outline crosses itself.
    assert!(unrolled > 400, "{unrolled}");
    assert!(
        decades[1..12].iter().filter(|count| **count > 0).count() >= 10,
        "{decades:?}"
    );
}

#[test]
fn a_long_plank_is_cut_with_edges_of_the_right_length_and_says_how_far_it_is_from_developable() {
    let plank = || {
        let rail = |a, b| Rail::bezier(&[a, b]).unwrap();
        Sheet::ruled(
            rail([0.0, 0.0, 0.0], [5000.0, 0.0, 0.0]),
            rail([0.0, 200.0, 0.0], [5000.0, 199.85, 7.7]),
        )
    };
    let flat = plank().unroll_with(&Unrolling::within(0.01)).unwrap();
    let errors = flat.errors();
    // The straight edge is a geodesic: what is cut is an arc, and the stated distance covers that.
    assert!(
        errors.outline + errors.ambiguity >= 9.26e-3 && errors.ambiguity < 0.1,
        "{errors:?}"
    );
    let sides = [5000.0, 5_000.005_931_247, 200.0, 199.998_281_2];
    let cut = flat.outline().length();
    assert!(
        (cut - sides.iter().sum::<f64>()).abs() < 2e-6 + errors.length,
        "{cut} {errors:?}"
    );
    assert_eq!(
        (flat.flattening(), flat.shortened(0)),
        (Some(Flattening::Edges), Some([0.0; 2]))
    );
    assert!(
        flat.strain() > 2.9e-7 && flat.strain() < 3.1e-7,
        "{:e}",
        flat.strain()
    );
    // The development that keeps the straight edge has it straight.
    let straight = plank()
        .unroll_with(
            &Unrolling::within(0.01)
                .allow_strain(1e-5)
                .flattening(Flattening::FirstEdge),
        )
        .unwrap();
    let [a, m, b] = [0.0, 0.5, 1.0].map(|x| {
        straight
            .flatten(PatternPlace {
                piece: 0,
                x,
                v: 0.0,
            })
            .unwrap()
    });
    let (along, arm) = (sub(&b, &a), sub(&m, &a));
    let height = (along[0] * arm[1] - along[1] * arm[0]) / norm(&along);
    assert!(height.abs() < 1e-9, "{height:e}");
}
