//! What the pages of reports must show of developables: rulings, edges of regression and flat patterns of a hundred states
//! of the sliders of each figure, evaluated by the geometry room without any derivation file.
//!
//!     cargo run -p torse-tests --example torses > target/torses.json
//!     python3 tests/browser/torses.py target/torses.json reports/*.html

use serde_json::{Value, json};
use std::error::Error;
use torse_geometry::developable::{QuarticData, QuinticData, oblique_image};
use torse_geometry::pattern::Unrolling;
use torse_geometry::{
    Continuity, EnvelopingPatch, Gbt, HermiteCone, PatchBounds, Plane, PlaneFamily, Rails,
    RuledSurface, TangentPatch, hermite, join,
};

type Fallible<T> = Result<T, Box<dyn Error>>;

/// States of each figure, rulings of each state.
const STATES: u32 = 100;
const RULINGS: usize = 5;

fn main() -> Fallible<()> {
    let mut all = serde_json::Map::new();
    for figure in figures() {
        let states = (1..=STATES).map(|number| {
            let values: Vec<f64> = figure
                .sliders
                .iter()
                .zip([2, 3, 5, 7])
                .map(|([low, high], base)| low + (high - low) * radical_inverse(number, base))
                .collect();
            let pieces = (figure.pieces)(&values)?;
            Ok(json!({ "values": values, "pieces": pieces }))
        });
        let states = states.collect::<Fallible<Vec<Value>>>()?;
        all.insert(figure.name.to_owned(), Value::Array(states));
    }
    println!("{}", Value::Object(all));
    Ok(())
}

/// The digits of a number behind the point, in reverse: numbers that fill an interval evenly (Halton 1960).
fn radical_inverse(mut number: u32, base: u32) -> f64 {
    let (mut share, mut inverse) = (1.0, 0.0);
    while number > 0 {
        share /= f64::from(base);
        inverse += share * f64::from(number % base);
        number /= base;
    }
    inverse
}

/// A figure with sliders, and its pieces at their values.
struct Figure {
    name: &'static str,
    sliders: Vec<[f64; 2]>,
    pieces: fn(&[f64]) -> Fallible<Vec<Value>>,
}

fn figures() -> Vec<Figure> {
    let whole = [-1.0, 1.0];
    let figure = |name, sliders: &[[f64; 2]], pieces| Figure {
        name,
        sliders: sliders.to_vec(),
        pieces,
    };
    vec![
        figure("gbt-developable-fig-6", &[whole; 2], |v| {
            envelopes(&[arch(v[0], v[1])?])
        }),
        figure("gbt-developable-fig-8", &[whole], |v| {
            envelopes(&[arch(v[0], v[0])?])
        }),
        figure("gbt-developable-fig-13", &[[-0.5, 0.5]; 2], |v| {
            spine(v[0], v[1])
        }),
        figure("gbt-developable-fig-15", &[[-0.5, 1.0]; 2], |v| {
            joined(arch(v[0], 0.0)?, Gbt::new(v[1], 0.0)?, [1.0, 0.0])
        }),
        figure("gbt-developable-fig-16", &[[-0.5, 1.0], whole], |v| {
            joined(arch(0.0, v[0])?, Gbt::new(0.0, v[1])?, [1.0, 0.0])
        }),
        figure(
            "gbt-developable-fig-17",
            &[[-0.5, 1.0], [-0.5, 1.0], [-0.5, 1.0], whole],
            |v| joined(arch(v[0], v[1])?, Gbt::new(v[2], v[3])?, [1.0, 0.0]),
        ),
        figure("gbt-developable-fig-18", &[[0.5, 1.5], [-2.0, 2.0]], |v| {
            joined(arch(1.0, 1.0)?, Gbt::new(1.0, 1.0)?, [v[0], v[1]])
        }),
        figure(
            "hermite-developable-fig-2d",
            &[[1.25, 3.0], [0.25, 2.0], [0.25, 2.0]],
            |v| {
                let q = [
                    [-20.0, 60.0, 45.0],
                    [-20.0, -65.0, 40.0],
                    scaled(v[1], [0.0, -30.0, -80.0]),
                    scaled(v[2], [0.0, -50.0, -60.0]),
                ];
                cone(&HermiteCone::cubic([125.0, 30.0, 45.0], v[0], q)?)
            },
        ),
        figure(
            "hermite-developable-fig-3a",
            &[[1.25, 3.0], [0.25, 2.0], [0.25, 2.0]],
            |v| {
                let data = QuarticData {
                    p_start: [40.0, 40.0, 45.0],
                    p_middle: [40.0, 12.5, 60.0],
                    q_ends: [[-20.0, 60.0, 45.0], [-20.0, -50.0, 45.0]],
                    q_tangents: [
                        scaled(v[1], [0.0, -30.0, 60.0]),
                        scaled(v[2], [0.0, -50.0, -60.0]),
                    ],
                };
                cone(&HermiteCone::quartic(v[0], data)?)
            },
        ),
        figure(
            "hermite-developable-fig-4a",
            &[[1.25, 3.0], [0.25, 2.0], [0.25, 2.0]],
            |v| cone(&quintic(v[0], v[1], v[2])?),
        ),
        figure("hermite-developable-fig-5a", &[[1.25, 3.0]], |v| {
            let cone = quintic(v[0], 1.0, 1.0)?;
            // Through q(0), spanned by (-30, -200, 0) and (0, 0, 200).
            let normal = [-40_000.0, 6_000.0, 0.0];
            let distance = normal[0] * -20.0 + normal[1] * 60.0;
            let image = oblique_image(&cone, &[normal[0], normal[1], normal[2], distance])?;
            let patch = RuledSurface::new(hermite::curve(&cone.p)?, image);
            let summit = cone.summit;
            Ok(vec![piece(&patch, &patch, [0.0, 1.0], |_| Some(summit))?])
        }),
    ]
}

/// The planes of Example 4.1.
fn arch(mu: f64, nu: f64) -> Fallible<PlaneFamily<Gbt<f64>, f64>> {
    let planes = [[-20.0, 10.0], [-10.0, 20.0], [10.0, 20.0], [20.0, 10.0]];
    let planes = planes.map(|[q, r]| [0.0, q, r, 400.0]);
    Ok(PlaneFamily::new(Gbt::new(mu, nu)?, planes.to_vec())?)
}

/// The families within the range of the rulings of the figures. They are cylinders: without an edge of regression.
fn envelopes(families: &[PlaneFamily<Gbt<f64>, f64>]) -> Fallible<Vec<Value>> {
    let patch = |family: &PlaneFamily<Gbt<f64>, f64>| {
        let bounds = PatchBounds::Range([-1.0 / 60.0, 1.0 / 60.0]);
        let patch = EnvelopingPatch::new(family.clone(), bounds)?;
        piece(&patch, &patch, [0.0, 1.0], |_| None)
    };
    families.iter().map(patch).collect()
}

fn joined(
    first: PlaneFamily<Gbt<f64>, f64>,
    basis: Gbt<f64>,
    betas: [f64; 2],
) -> Fallible<Vec<Value>> {
    let last: Plane<f64> = [0.0, 10.0, -60.0, 400.0];
    let condition = Continuity::beta(betas.to_vec())?;
    let second = join::next_family(&first, basis, &condition, &[last])?;
    envelopes(&[first, second])
}

/// The tangents of the spine curve of Sect. 4.2. The sheet on both sides of its edge cannot be cut from one; a part on
/// one side can.
fn spine(mu: f64, nu: f64) -> Fallible<Vec<Value>> {
    let root = 2_f64.sqrt();
    let planes = vec![
        [6.5, 6.5, 6.5 * root, 169.0],
        [-5.5, 7.5, 7.5 * root, 225.0],
        [-10.0, -10.0, 10.0 * root, 400.0],
        [12.5, -12.5, 12.5 * root, 625.0],
    ];
    let family = PlaneFamily::new(Gbt::new(mu, nu)?, planes)?;
    let whole = TangentPatch::new(family.clone(), [-0.25, 0.25])?;
    let part = TangentPatch::new(family.clone(), [0.05, 0.25])?;
    let edge = |x| family.characteristic_point(&x).ok();
    Ok(vec![piece(&whole, &part, [0.6, 1.0], edge)?])
}

fn quintic(k: f64, first: f64, last: f64) -> Fallible<HermiteCone<f64>> {
    let quartic = QuarticData {
        p_start: [40.0, 40.0, 45.0],
        p_middle: [40.0, 12.5, 40.0],
        q_ends: [[-20.0, 60.0, 45.0], [-20.0, -50.0, 45.0]],
        q_tangents: [
            scaled(first, [0.0, -60.0, 90.0]),
            scaled(last, [0.0, -50.0, -30.0]),
        ],
    };
    let p_middle_tangent = [0.0, -25.0, 35.0];
    let data = QuinticData {
        quartic,
        p_middle_tangent,
    };
    Ok(HermiteCone::quintic(k, data)?)
}

fn cone(cone: &HermiteCone<f64>) -> Fallible<Vec<Value>> {
    let patch = cone.patch()?;
    Ok(vec![piece(&patch, &patch, [0.0, 1.0], |_| {
        Some(cone.summit)
    })?])
}

fn scaled(factor: f64, vector: [f64; 3]) -> [f64; 3] {
    vector.map(|c| factor * c)
}

/// Rulings of a patch, and the flat pattern of a part of it: which part of each ruling, and the ends there; without a
/// pattern where the library refuses to make one.
fn piece(
    patch: &dyn Rails<f64>,
    part: &dyn Rails<f64>,
    share: [f64; 2],
    edge: impl Fn(f64) -> Option<[f64; 3]>,
) -> Fallible<Value> {
    let flat = Unrolling::within(1e-7).rulings(RULINGS).measured(part).ok();
    let mut rulings = vec![];
    for number in 0..RULINGS {
        #[allow(clippy::cast_precision_loss)]
        let x = number as f64 / (RULINGS - 1) as f64;
        let ends = patch.ruling_ends(&x)?;
        let flat = flat.as_ref().and_then(|flat| flat.rulings().get(number));
        rulings.push(json!({
            "x": x,
            "ends": ends,
            "edge": edge(x),
            "flat": flat.map(|ruling| ruling.ends),
        }));
    }
    Ok(json!({ "share": share, "rulings": rulings }))
}
