//! The matrices of the ends, of the joins and of the Hermite systems: entries, inverses and determinants, by LU; the absolute
//! value of a determinant also as the product of the singular values.

use crate::ends::{SHAPE, gbt};
use crate::examples::{edge, family};
use crate::row::{Case, Row, rows as of};
use nalgebra::DMatrix;
use torse_geometry::developable::cone_system;
use torse_geometry::{Basis, Gbt};

type Matrix = DMatrix<f64>;

pub fn rows() -> Vec<Row> {
    [ends(), joins(), planes(), systems()].concat()
}

/// The derivatives of orders 0 to `count - 1` in the first control points: from the start, or from the end back.
fn end_matrix(basis: Gbt<f64>, degree: usize, end: f64, count: usize) -> Matrix {
    let rows = basis.derivative_rows(degree, &end, count - 1).unwrap();
    Matrix::from_fn(count, count, |order, place| match end > 0.5 {
        true => rows[order][degree - place],
        false => rows[order][place],
    })
}

fn list_of(matrix: &Matrix) -> Vec<f64> {
    matrix.transpose().iter().copied().collect()
}

fn labels(name: &str, matrix: &Matrix) -> Vec<String> {
    let places = (1..=matrix.nrows()).flat_map(|i| (1..=matrix.ncols()).map(move |j| (i, j)));
    places.map(|(i, j)| format!("{name}[{i},{j}]")).collect()
}

/// By how much a determinant changes with the entries, each by its own size: the condition number times the determinant.
fn reach(matrix: &Matrix) -> f64 {
    let values = matrix.clone().svd(false, false).singular_values;
    values.product() * values.max() / values.min()
}

fn singular_product(matrix: &Matrix) -> f64 {
    matrix.clone().svd(false, false).singular_values.product()
}

/// Entries, inverse and determinant of a matrix that a file calls by a name.
fn whole(claim: &str, name: &str, at: &[(&str, &str)], matrix: &Matrix, sign: &str) -> Vec<Row> {
    let inverse = matrix.clone().lu().try_inverse().expect("a regular matrix");
    let mut list = of(&Case {
        claim,
        formula: name,
        labels: labels(name, matrix),
        at,
        doubles: list_of(matrix),
        ..Case::default()
    });
    let inverted = format!("inverse({name})");
    list.extend(of(&Case {
        claim,
        formula: &inverted,
        labels: labels(&inverted, matrix),
        at,
        doubles: list_of(&inverse),
        ..Case::default()
    }));
    list.extend(determinant(claim, name, at, matrix, sign));
    list
}

/// The determinant by LU, and its absolute value by the singular values.
fn determinant(
    claim: &str,
    name: &str,
    at: &[(&str, &str)],
    matrix: &Matrix,
    sign: &str,
) -> Vec<Row> {
    let exact = format!("det({name})");
    let mut list = of(&Case {
        claim,
        formula: &exact,
        labels: vec![format!("{exact}, by LU")],
        at,
        doubles: vec![matrix.clone().lu().determinant()],
        scale: reach(matrix),
        ..Case::default()
    });
    list.extend(of(&Case {
        claim,
        formula: &format!("{sign}{exact}"),
        labels: vec![format!("{sign}{exact}, by singular values")],
        at,
        doubles: vec![singular_product(matrix)],
        scale: reach(matrix),
        ..Case::default()
    }));
    list
}

/// The matrices of (3.11) and (3.12).
fn ends() -> Vec<Row> {
    let mut list = vec![];
    for (degree, k) in [(2, "2"), (3, "3"), (4, "4")] {
        for (name, end) in [("start", 0.0), ("end", 1.0)] {
            let claim = match end > 0.5 {
                true => "gbt-developable/eq-3.12.c",
                false => "gbt-developable/eq-3.11.c",
            };
            let at = [("k", k), SHAPE[0], SHAPE[1]];
            let matrix = end_matrix(gbt(), degree, end, 3);
            // At the end the control points are counted backwards, so that the first derivative has the other sign.
            let sign = if end > 0.5 { "-" } else { "" };
            list.extend(whole(claim, name, &at, &matrix, sign));
        }
    }
    list
}

/// The control points of a second segment from those of the first: the matrices of C3, and of G2 with γ and λ.
fn joins() -> Vec<Row> {
    let first = gbt();
    let second = Gbt::new(0.75, 0.125).unwrap();
    let mut list = vec![];
    for (m, n, left, right) in [("3", "3", 3, 3), ("4", "5", 4, 5)] {
        let solved = end_matrix(second, right, 0.0, 4)
            .lu()
            .solve(&end_matrix(first, left, 1.0, 4))
            .unwrap();
        list.extend(of(&Case {
            claim: "gbt-surfaces/eq-6.Q13",
            formula: "coefficients([Q1[0], Q1[1], Q1[2], Q1[3]], [Q[m], Q[m-1], Q[m-2], Q[m-3]])",
            labels: labels("C3", &solved),
            at: &[
                ("m", m),
                ("n", n),
                SHAPE[0],
                SHAPE[1],
                ("mu1", "3/4"),
                ("nu1", "1/8"),
            ],
            doubles: list_of(&solved),
            ..Case::default()
        }));
    }
    let (gamma, lambda) = (2.0, 3.0);
    for (k, l, left, right) in [("3", "3", 3, 3), ("3", "4", 3, 4)] {
        let beta = Matrix::from_row_slice(
            3,
            3,
            &[1.0, 0.0, 0.0, 0.0, gamma, 0.0, 0.0, lambda, gamma * gamma],
        );
        let wanted = beta * end_matrix(first, left, 1.0, 3);
        let solved = end_matrix(second, right, 0.0, 3)
            .lu()
            .solve(&wanted)
            .unwrap();
        list.extend(of(&Case {
            claim: "gbt-developable/thm-4.c.true",
            formula: "coefficients([P2[0], P2[1], P2[2]], [P1[k], P1[k-1], P1[k-2]])",
            labels: labels("G2", &solved),
            at: &[
                ("k", k),
                ("l", l),
                ("mu1", "1/2"),
                ("nu1", "-1/4"),
                ("mu2", "3/4"),
                ("nu2", "1/8"),
                ("gamma", "2"),
                ("lambda", "3"),
            ],
            doubles: list_of(&solved),
            ..Case::default()
        }));
    }
    list
}

/// The determinants of the planes of Sect. 4.2: three of them at a parameter, and all four.
fn planes() -> Vec<Row> {
    let mut list = vec![];
    for (end, sign) in [(0, ""), (1, "")] {
        let jet = family(edge())
            .curve()
            .derivatives(&f64::from(end), 3)
            .unwrap();
        let normals = Matrix::from_fn(3, 3, |i, j| jet[i][j]);
        let all = Matrix::from_fn(4, 4, |i, j| jet[i][j]);
        let claim = "gbt-developable/sec-4.2.class.ends";
        for (matrix, text) in [
            (
                normals,
                format!("[normal(E3({end})), normal(E3'({end})), normal(E3''({end}))]"),
            ),
            (
                all,
                format!("[E3({end}), E3'({end}), E3''({end}), E3'''({end})]"),
            ),
        ] {
            list.extend(determinant(claim, &text, &SHAPE, &matrix, sign));
        }
    }
    list
}

/// The systems (3.5), (3.6) and (3.7); the determinant of the first is k^4.
fn systems() -> Vec<Row> {
    let mut list = vec![];
    for (k, value) in [("2", 2.0), ("3/2", 1.5)] {
        for (degree, claim, name, sign) in [
            (3, "hermite-developable/eq-3.5.det", "A35", ""),
            (4, "hermite-developable/eq-3.6.det", "A36", "-"),
            (5, "hermite-developable/eq-3.7.det", "A37", ""),
        ] {
            let system = cone_system(degree, &value);
            let size = system.len();
            let matrix = Matrix::from_fn(size, size, |i, j| system[i][j]);
            list.extend(whole(claim, name, &[("k", k)], &matrix, sign));
        }
    }
    list
}
