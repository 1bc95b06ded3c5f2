//! The derivatives of orders 0 to 3 at both ends: of the trigonometric bases, and of the Hermite curves in their data.

use crate::row::{Case, Row, rows as of};
use torse_geometry::{Basis, Bernstein, Curve, Gbt, hermite};

/// The shape parameters of all rows.
pub const SHAPE: [(&str, &str); 2] = [("mu", "1/2"), ("nu", "-1/4")];

pub fn gbt() -> Gbt<f64> {
    Gbt::new(0.5, -0.25).unwrap()
}

pub fn rows() -> Vec<Row> {
    let mut list = vec![];
    for (claim, basis, variable, degree) in [
        ("gbt-developable/sec-2.2.endpoints", "g", "x", 2),
        ("gbt-developable/sec-2.2.endpoints", "g", "x", 3),
        ("gbt-developable/sec-2.2.endpoints", "g", "x", 4),
        ("gbt-surfaces/thm-2.a3", "f", "z", 3),
        ("gbt-surfaces/thm-2.a3", "f", "z", 5),
    ] {
        for end in [0, 1] {
            let doubles = gbt().derivative_rows(degree, &f64::from(end), 3).unwrap();
            for (order, doubles) in doubles.into_iter().enumerate() {
                let functions: Vec<String> = (0..=degree)
                    .map(|i| {
                        let function = format!("{basis}[{i},{degree}]({variable}, mu, nu)");
                        at_end(&function, variable, order, end)
                    })
                    .collect();
                let primes = "'".repeat(order);
                list.extend(of(&Case {
                    claim,
                    formula: &format!("[{}]", functions.join(", ")),
                    labels: (0..=degree)
                        .map(|i| format!("{basis}[{i},{degree}]{primes}({end})"))
                        .collect(),
                    at: &SHAPE,
                    doubles,
                    ..Case::default()
                }));
            }
        }
    }
    for (claim, curve, basis, data) in [
        (
            "hermite-developable/sec-2.cubic.conditions",
            "p3",
            "cubic_basis(u)",
            "p0, p1, p0u, p1u",
        ),
        (
            "hermite-developable/sec-2.quartic.conditions",
            "p4",
            "quartic_basis(u)",
            "p0, pm, p1, p0u, p1u",
        ),
        (
            "hermite-developable/sec-2.quintic.conditions",
            "p5",
            "quintic_basis(u)",
            "p0, pm, p1, p0u, pu, p1u",
        ),
    ] {
        let count = data.split(',').count();
        for end in [0, 1] {
            for order in 0..=3 {
                let names = data.split(", ");
                let primes = "'".repeat(order);
                list.extend(of(&Case {
                    claim,
                    formula: &at_end(basis, "u", order, end),
                    labels: names
                        .map(|name| format!("{curve}{primes}({end}), factor of {name}"))
                        .collect(),
                    doubles: (0..count)
                        .map(|one| hermite_derivative(count, one, order, f64::from(end)))
                        .collect(),
                    ..Case::default()
                }));
            }
        }
    }
    list
}

fn at_end(function: &str, variable: &str, order: usize, end: i32) -> String {
    match order {
        0 => format!("at({function}, {variable}, {end})"),
        _ => format!("at(D({function}, {variable}, {order}), {variable}, {end})"),
    }
}

/// The derivative of the Hermite curve of so many data, of which one is 1 and the others are 0.
fn hermite_derivative(count: usize, one: usize, order: usize, x: f64) -> f64 {
    let mut data = vec![[0.0]; count];
    data[one] = [1.0];
    let curve: Curve<Bernstein, f64, 1> = hermite::curve(&data).unwrap();
    curve.derivatives(&x, order).unwrap()[order][0]
}
