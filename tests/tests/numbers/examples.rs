//! The values of the examples: control planes and points, distances, lengths, the planes and vectors that are computed.

use crate::ends::{SHAPE, gbt};
use crate::row::{Case, Row, rows as of};
use torse_geometry::developable::{
    QuarticData, QuinticData, oblique_image, oblique_image_as_printed,
};
use torse_geometry::vector::{cross, dot};
use torse_geometry::{
    Continuity, Curve, Gbt, HermiteCone, Plane, PlaneFamily, Surface, TensorSurface, hermite, join,
};

pub fn rows() -> Vec<Row> {
    [planes(), spine(), joined(), net(), cones(), projected()].concat()
}

/// The planes of Example 4.1.
const ARCH: [Plane<f64>; 4] = [
    [0.0, -20.0, 10.0, 400.0],
    [0.0, -10.0, 20.0, 400.0],
    [0.0, 10.0, 20.0, 400.0],
    [0.0, 20.0, 10.0, 400.0],
];

fn root_of_two() -> f64 {
    2.0_f64.sqrt()
}

/// The planes of Example 4.2.
fn pencil() -> [Plane<f64>; 4] {
    let side = 5.0 * root_of_two();
    [side, -side, -side, side].map(|x| [x, -side, 5.0, 125.0])
}

/// The planes of Sect. 4.2.
pub fn edge() -> [Plane<f64>; 4] {
    let root = root_of_two();
    [
        [6.5, 6.5, 6.5 * root, 169.0],
        [-5.5, 7.5, 7.5 * root, 225.0],
        [-10.0, -10.0, 10.0 * root, 400.0],
        [12.5, -12.5, 12.5 * root, 625.0],
    ]
}

pub fn family(planes: [Plane<f64>; 4]) -> PlaneFamily<Gbt<f64>, f64> {
    PlaneFamily::new(gbt(), planes.to_vec()).unwrap()
}

fn distance2(plane: &Plane<f64>) -> f64 {
    let [p, q, r, s] = plane;
    s * s / (p * p + q * q + r * r)
}

fn midpoint(plane: &Plane<f64>) -> Vec<f64> {
    let [p, q, r, s] = plane;
    let square = p * p + q * q + r * r;
    [p, q, r].map(|c| s / square * c).to_vec()
}

/// The control planes as printed, their distances, and the squared lengths of the end generators.
fn planes() -> Vec<Row> {
    let mut list = vec![];
    for (example, name, planes) in [("4.1", "E1", ARCH), ("4.2", "E2", pencil())] {
        // The planes of Example 4.2 have a line in common: they are no family, and a curve in the space of planes all the same.
        let curve = Curve::new(gbt(), planes.to_vec()).unwrap();
        for (number, plane) in planes.iter().enumerate() {
            list.extend(of(&Case {
                claim: &format!("gbt-developable/ex-{example}.Q{number}"),
                formula: &format!("{name}_{number}"),
                doubles: plane.to_vec(),
                ..Case::default()
            }));
        }
        for end in [0, 1] {
            list.extend(of(&Case {
                claim: &format!("gbt-developable/ex-{example}.Q{}", 3 * end),
                formula: &format!("{name}({end})"),
                at: &SHAPE,
                doubles: curve.point(&(end as f64)).unwrap().to_vec(),
                ..Case::default()
            }));
        }
        list.extend(of(&Case {
            claim: &format!("gbt-developable/ex-{example}.distance"),
            formula: &format!("[distance2({name}_0), distance2({name}_1), distance2({name}_2), distance2({name}_3)]"),
            labels: (0..4).map(|i| format!("distance2({name}_{i})")).collect(),
            doubles: planes.iter().map(distance2).collect(),
            ..Case::default()
        }));
        list.extend(of(&Case {
            claim: &format!("gbt-developable/ex-{example}.lengths"),
            formula: &format!("[length2({name}(0), {name}'(0)), length2({name}(1), {name}'(1))]"),
            labels: [0, 1]
                .map(|end| format!("length2({name}({end}), {name}'({end}))"))
                .to_vec(),
            at: &SHAPE,
            doubles: [0.0, 1.0]
                .map(|x| {
                    let jet = curve.derivatives(&x, 1).unwrap();
                    let [plane, slope] = [&jet[0], &jet[1]].map(|p| [p[0], p[1], p[2]]);
                    let direction = cross(&plane, &slope);
                    dot(&direction, &direction)
                })
                .to_vec(),
            ..Case::default()
        }));
    }
    list
}

/// The planes, midpoints and distances of Sect. 4.2, and a point of the spine curve.
fn spine() -> Vec<Row> {
    let mut list = vec![];
    for (number, plane) in edge().iter().enumerate() {
        list.extend(of(&Case {
            claim: &format!("gbt-developable/sec-4.2.Q{number}"),
            formula: &format!("E3_{number}"),
            doubles: plane.to_vec(),
            ..Case::default()
        }));
        list.extend(of(&Case {
            claim: "gbt-developable/sec-4.2.quadrants",
            formula: &format!("midpoint(E3_{number})"),
            doubles: midpoint(plane),
            ..Case::default()
        }));
    }
    for (number, plane) in edge().iter().enumerate() {
        list.extend(of(&Case {
            claim: "gbt-developable/sec-4.2.distances",
            formula: &format!("distance2(E3_{number})"),
            doubles: vec![distance2(plane)],
            ..Case::default()
        }));
    }
    list.extend(of(&Case {
        claim: "gbt-developable/sec-4.2.distances",
        formula: "meet(E3(1/2), E3'(1/2), E3''(1/2))",
        at: &SHAPE,
        doubles: family(edge()).characteristic_point(&0.5).unwrap().to_vec(),
        ..Case::default()
    }));
    list
}

/// The computed planes of Example 5.2.
fn joined() -> Vec<Row> {
    let first = PlaneFamily::new(Gbt::new(1.0, 1.0).unwrap(), ARCH.to_vec()).unwrap();
    let condition = Continuity::beta(vec![1.0, 0.0]).unwrap();
    let free = [[0.0, 40.0, -40.0, 400.0]];
    let second = join::next_family(&first, Gbt::new(1.0, 1.0).unwrap(), &condition, &free);
    let second = second.unwrap();
    let printed = [
        ["0", "20", "10", "400"],
        ["0", "30", "0", "400"],
        ["0", "45.708", "-35.708", "400"],
    ];
    let rows = printed.iter().enumerate().flat_map(|(i, printed)| {
        of(&Case {
            claim: &format!("gbt-developable/ex-5.2.Q{i}2"),
            formula: &format!("B[{i}]"),
            solved: &["A[0]", "A[1]", "A[2]", "A[3]"],
            printed,
            doubles: second.curve().points()[i].to_vec(),
            ..Case::default()
        })
    });
    rows.collect()
}

/// The net of Example 3.2 and a point of its surface.
fn net() -> Vec<Row> {
    let corners = [
        [[0.0, 0.0, 0.0], [0.0, 3.0, 0.0]],
        [[3.0, 0.0, 0.0], [3.0, 3.0, 0.0]],
    ];
    let interior = [
        [1.0, 1.0, 3.0],
        [1.0, 2.0, 3.0],
        [2.0, 1.0, 3.0],
        [2.0, 2.0, 3.0],
    ];
    let right = TensorSurface::bilinear(gbt(), gbt(), (3, 3), &corners, &interior).unwrap();
    let net: Vec<Vec<[f64; 3]>> = right.rows().map(<[[f64; 3]]>::to_vec).collect();
    let mut list = vec![];
    for (place, formula, printed) in [
        (1, "Q30 + 1/3*(Q33 - Q30)", ["3", "2", "0"]),
        (2, "Q30 + 2/3*(Q33 - Q30)", ["3", "2", "0"]),
    ] {
        list.extend(of(&Case {
            claim: "gbt-surfaces/ex-3.2.division.Q3l",
            formula,
            printed: &printed,
            doubles: net[3][place].to_vec(),
            ..Case::default()
        }));
    }
    // The surface of the printed net, with (3, 2, 0) twice.
    let mut net = net;
    net[3][1] = [3.0, 2.0, 0.0];
    let printed = TensorSurface::new(gbt(), gbt(), net).unwrap();
    for (z, z1, x, y) in [
        ("0", "0", 0.0, 0.0),
        ("1", "1", 1.0, 1.0),
        ("1/2", "1/3", 0.5, 1.0 / 3.0),
    ] {
        list.extend(of(&Case {
            claim: "gbt-surfaces/ex-3.2.corners",
            formula: &format!("at(at(sixteen, z, {z}), z1, {z1})"),
            at: &[
                ("mu", "1/2"),
                ("nu", "-1/4"),
                ("mu1", "1/2"),
                ("nu1", "-1/4"),
            ],
            doubles: printed.point(&x, &y).unwrap().to_vec(),
            ..Case::default()
        }));
    }
    list
}

fn quintic() -> HermiteCone<f64> {
    let quartic = QuarticData {
        p_start: [40.0, 40.0, 45.0],
        p_middle: [40.0, 12.5, 40.0],
        q_ends: [[-20.0, 60.0, 45.0], [-20.0, -50.0, 45.0]],
        q_tangents: [[0.0, -60.0, 90.0], [0.0, -50.0, -30.0]],
    };
    let p_middle_tangent = [0.0, -25.0, 35.0];
    HermiteCone::quintic(
        2.0,
        QuinticData {
            quartic,
            p_middle_tangent,
        },
    )
    .unwrap()
}

/// The solutions of the examples of Sect. 3.
fn cones() -> Vec<Row> {
    let ends = [[-20.0, 60.0, 45.0], [-20.0, -50.0, 45.0]];
    let tangents = [[0.0, -30.0, 60.0], [0.0, -50.0, -60.0]];
    let cubic = [ends[0], ends[1], tangents[0], tangents[1]];
    let cubic = HermiteCone::cubic([170.0, 0.0, 45.0], 2.0, cubic).unwrap();
    let data = QuarticData {
        p_start: [40.0, 40.0, 45.0],
        p_middle: [40.0, 12.5, 60.0],
        q_ends: ends,
        q_tangents: tangents,
    };
    let quartic = HermiteCone::quartic(2.0, data).unwrap();
    let quintic = quintic();
    let cases = [
        ("ex-3.1.p1", "p1", ["75", "-25", "45"], cubic.p[1]),
        ("ex-3.1.p0u", "p0u", ["0", "-15", "30"], cubic.p[2]),
        ("ex-3.1.p1u", "p1u", ["0", "-25", "-30"], cubic.p[3]),
        ("ex-3.1.p0", "p0", ["75", "30", "45"], cubic.p[0]),
        ("ex-3.2.q", "qm", ["-20", "5", "75"], quartic.q[1]),
        ("ex-3.2.p1", "p1", ["40", "-15", "45"], quartic.p[2]),
        ("ex-3.2.p0u", "p0u", ["0", "-15", "30"], quartic.p[3]),
        ("ex-3.2.p1u", "p1u", ["0", "-25", "-30"], quartic.p[4]),
        ("ex-3.2.o", "o", ["100", "20", "45"], quartic.summit),
        ("ex-3.3.p0u", "p0u", ["0", "-30", "45"], quintic.p[3]),
        ("ex-3.3.qu", "qu", ["0", "-50", "70"], quintic.q[4]),
        ("ex-3.3.p1u", "p1u", ["0", "-25", "-15"], quintic.p[5]),
        ("ex-3.3.q", "qm", ["-20", "5", "35"], quintic.q[1]),
        ("ex-3.3.p1", "p1", ["40", "-15", "45"], quintic.p[2]),
        ("ex-3.3.o", "o", ["100", "20", "45"], quintic.summit),
    ];
    let rows = cases.iter().flat_map(|(claim, formula, printed, doubles)| {
        of(&Case {
            claim: &format!("hermite-developable/{claim}"),
            formula,
            printed,
            doubles: doubles.to_vec(),
            ..Case::default()
        })
    });
    rows.collect()
}

/// The vectors of Sect. 4 by the printed formulas, the tangents of the image curve, and the angle by which the tangent planes
/// at the ends of a generatrix differ.
fn projected() -> Vec<Row> {
    let cone = quintic();
    // Through q(0), spanned by (-30, -200, 0) and (0, 0, 200).
    let normal = cross(&[-30.0, -200.0, 0.0], &[0.0, 0.0, 200.0]);
    let distance = dot(&normal, &cone.q[0]);
    let plane = [normal[0], normal[1], normal[2], distance];
    let data = oblique_image_as_printed(&cone, &plane).unwrap();
    let mut list = vec![];
    for (claim, formula, printed, doubles) in [
        ("ex-4.r0", "r0", ["-20", "60", "45"], data[0]),
        ("ex-4.r", "r", ["-28.4", "3.9", "34.3"], data[1]),
        ("ex-4.r1", "r1", ["-38", "-60.5", "45"], data[2]),
        ("ex-4.r0u", "r0u", ["-7.6", "-50.6", "63.8"], data[3]),
        ("ex-4.ru", "ru", ["-10.6", "-70.8", "91.8"], data[4]),
        ("ex-4.r1u", "r1u", ["-10.2", "-67.7", "-74.1"], data[5]),
    ] {
        list.extend(of(&Case {
            claim: &format!("hermite-developable/{claim}"),
            formula,
            printed: &printed,
            doubles: doubles.to_vec(),
            ..Case::default()
        }));
    }
    let image = oblique_image(&cone, &plane).unwrap();
    for (formula, x) in [
        ("at(D(image(first(x)), x), x, 0)", 0.0),
        ("at(D(image(middle(x)), x), x, 0)", 0.5),
        ("at(D(image(last(x)), x), x, 0)", 1.0),
    ] {
        list.extend(of(&Case {
            claim: "hermite-developable/ex-4.true-tangents",
            formula,
            doubles: image.derivatives(&x, 1).unwrap()[1].to_vec(),
            ..Case::default()
        }));
    }
    let p = hermite::curve(&cone.p)
        .unwrap()
        .derivatives(&0.4, 1)
        .unwrap();
    let r = hermite::curve(&data).unwrap().derivatives(&0.4, 1).unwrap();
    let across = [0, 1, 2].map(|i| r[0][i] - p[0][i]);
    let (near, far) = (cross(&p[1], &across), cross(&r[1], &across));
    let turn = cross(&near, &far);
    list.extend(of(&Case {
        claim: "hermite-developable/ex-4.a.twist",
        formula: "turn(2/5)/size(2/5)",
        // The square of the sine of a small angle between two vectors.
        scale: 1.0,
        doubles: vec![dot(&turn, &turn) / (dot(&near, &near) * dot(&far, &far))],
        ..Case::default()
    }));
    list
}
