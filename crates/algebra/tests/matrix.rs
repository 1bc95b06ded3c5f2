//! Matrices: determinants against a closed formula and the definition, inverses and solvers against
//! their definitions.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use num_traits::Zero;
use proptest::prelude::*;
use torse_algebra::rational::integer;
use torse_algebra::{Ball, Integer, Jet, Matrix, MatrixError, Rational, Scalar};

fn hilbert(n: usize) -> Matrix<Rational> {
    Matrix::from_fn(n, n, |i, j| {
        Rational::new(Integer::ONE, Integer::from(i + j + 1))
    })
    .unwrap()
}

fn square(n: usize) -> impl Strategy<Value = Matrix<Integer>> {
    prop::collection::vec(-9_i64..=9, n * n)
        .prop_map(move |e| Matrix::from_fn(n, n, |i, j| Integer::from(e[i * n + j])).unwrap())
}

fn rational(matrix: &Matrix<Integer>) -> Matrix<Rational> {
    matrix.map(|entry| Rational::from_integer(entry.clone()))
}

fn diagonal(n: usize, value: &Rational) -> Matrix<Rational> {
    Matrix::from_fn(n, n, |i, j| {
        if i == j {
            value.clone()
        } else {
            Rational::zero()
        }
    })
    .unwrap()
}

/// The sum over all permutations.
fn leibniz(matrix: &Matrix<Integer>, row: usize, free: &[usize]) -> Integer {
    if free.is_empty() {
        return Integer::ONE;
    }
    (0..free.len())
        .map(|k| {
            let rest: Vec<usize> = free.iter().copied().filter(|&c| c != free[k]).collect();
            let term = matrix.get(row, free[k]).unwrap() * leibniz(matrix, row + 1, &rest);
            if k % 2 == 0 { term } else { -term }
        })
        .sum()
}

#[test]
fn determinants_of_hilbert_matrices_are_those_of_the_closed_formula() {
    // det H_n = c_n^4 / c_2n with c_n = 1! 2! ... (n-1)!.
    let factorial = |n: usize| (1..=n).fold(Integer::ONE, |p, k| p * k);
    let c = |n: usize| (1..n).fold(Integer::ONE, |p, k| p * factorial(k));
    for n in 1..=12 {
        let expected = Rational::new(c(n).pow(4), c(2 * n));
        assert_eq!(hilbert(n).determinant(), Ok(expected));
    }
}

#[test]
fn the_inverse_of_a_hilbert_matrix_is_integral() {
    let inverse = hilbert(8).inverse().unwrap();
    assert!(inverse.rows().flatten().all(Rational::is_integer));
    assert_eq!(hilbert(8).times(&inverse), Ok(diagonal(8, &integer(1))));
}

#[test]
fn shapes_that_do_not_fit_are_refused_with_the_shapes() {
    let of = |rows, columns| Matrix::from_fn(rows, columns, |_, _| integer(1)).unwrap();
    assert_eq!(
        Matrix::<Integer>::from_rows(vec![]),
        Err(MatrixError::Empty)
    );
    assert_eq!(
        Matrix::<Integer>::from_rows(vec![vec![], vec![]]),
        Err(MatrixError::Empty)
    );
    assert_eq!(Matrix::<Integer>::column(vec![]), Err(MatrixError::Empty));
    let ragged = Matrix::from_rows(vec![vec![1], vec![1, 2]]);
    assert_eq!(
        ragged,
        Err(MatrixError::Ragged {
            row: 1,
            found: 2,
            expected: 1
        })
    );
    let not_square = MatrixError::NotSquare {
        rows: 2,
        columns: 3,
    };
    assert_eq!(of(2, 3).determinant(), Err(not_square.clone()));
    assert_eq!(of(2, 3).adjugate(), Err(not_square.clone()));
    assert_eq!(of(2, 3).inverse(), Err(not_square));
    let mismatch = |left: (usize, usize), right: (usize, usize)| MatrixError::ShapeMismatch {
        left_rows: left.0,
        left_columns: left.1,
        right_rows: right.0,
        right_columns: right.1,
    };
    assert_eq!(of(2, 3).times(&of(2, 3)), Err(mismatch((2, 3), (2, 3))));
    assert_eq!(of(2, 2).solve(&of(3, 1)), Err(mismatch((2, 2), (3, 1))));
    assert_eq!(
        of(2, 2).submatrix(&[0, 2], &[0]),
        Err(MatrixError::OutOfRange { index: 2, count: 2 })
    );
    assert_eq!(
        of(17, 17).determinant(),
        Err(MatrixError::TooLarge {
            size: 17,
            limit: 16
        })
    );
}

#[test]
fn a_singular_matrix_is_told_from_one_whose_pivot_is_undecided() {
    let rows =
        |entries: [[i64; 2]; 2]| Matrix::from_fn(2, 2, |i, j| integer(entries[i][j])).unwrap();
    let singular = rows([[1, 2], [2, 4]]);
    assert_eq!(singular.inverse(), Err(MatrixError::Singular { column: 1 }));
    // With a third instead of an integer the ball of the second pivot straddles zero.
    let third = Rational::new(Integer::ONE, Integer::from(3));
    let enclosed = singular.map(|entry| Ball::from_rational(&(entry * &third), 40));
    assert_eq!(
        enclosed.inverse(),
        Err(MatrixError::PivotUndecided { column: 1 })
    );
    // A zero in the corner only asks for another row.
    let exchanged = rows([[0, 2], [3, 0]]);
    assert_eq!(
        exchanged.times(&exchanged.inverse().unwrap()),
        Ok(diagonal(2, &integer(1)))
    );
}

#[test]
fn the_determinant_of_jets_is_the_jet_of_the_determinant() {
    // det [[t, 1], [2, t]] = t^2 - 2: at t = 3 the series 7 + 6 t + t^2.
    let t = Jet::variable(integer(3), 2);
    let two = t.constant(&integer(2));
    let matrix = Matrix::from_rows(vec![vec![t.clone(), t.one_like()], vec![two, t]]).unwrap();
    let expected = Jet::from_coefficients(integer(7), [integer(6), integer(1)]);
    assert_eq!(matrix.determinant(), Ok(expected));
}

proptest! {
    #[test]
    fn all_determinants_agree(a in square(5)) {
        let expected = leibniz(&a, 0, &[0, 1, 2, 3, 4]);
        prop_assert_eq!(a.determinant(), Ok(expected.clone()));
        prop_assert_eq!(a.transposed().determinant(), Ok(expected));
    }

    #[test]
    fn the_determinant_of_a_product_is_the_product_of_determinants(a in square(4), b in square(4)) {
        let product = a.times(&b).unwrap().determinant().unwrap();
        prop_assert_eq!(product, a.determinant().unwrap() * b.determinant().unwrap());
    }

    #[test]
    fn a_matrix_times_its_adjugate_is_its_determinant(a in square(4)) {
        let a = rational(&a);
        let expected = diagonal(4, &a.determinant().unwrap());
        let adjugate = a.adjugate().unwrap();
        prop_assert_eq!(a.times(&adjugate), Ok(expected.clone()));
        prop_assert_eq!(adjugate.times(&a), Ok(expected));
    }

    #[test]
    fn a_matrix_satisfies_its_characteristic_equation(a in square(2)) {
        // Cayley and Hamilton: A^2 - tr(A) A + det(A) 1 = 0.
        let a = rational(&a);
        let trace = a.get(0, 0).unwrap() + a.get(1, 1).unwrap();
        let determinant = a.determinant().unwrap();
        let square = a.times(&a).unwrap();
        for i in 0..2 {
            for j in 0..2 {
                let diagonal = if i == j { determinant.clone() } else { Rational::zero() };
                let residue = square.get(i, j).unwrap() - &trace * a.get(i, j).unwrap() + diagonal;
                prop_assert!(residue.is_zero());
            }
        }
    }

    #[test]
    fn a_matrix_times_its_inverse_is_one(a in square(4)) {
        let a = rational(&a);
        match a.inverse() {
            Ok(inverse) => {
                prop_assert_eq!(a.times(&inverse), Ok(diagonal(4, &integer(1))));
                prop_assert_eq!(inverse.times(&a), Ok(diagonal(4, &integer(1))));
            }
            Err(error) => {
                prop_assert!(matches!(error, MatrixError::Singular { .. }), "{error}");
                prop_assert_eq!(a.determinant(), Ok(Rational::zero()));
            }
        }
    }

    #[test]
    fn a_matrix_times_its_solution_is_the_right_side(a in square(4), b in prop::collection::vec(-9_i64..=9, 4)) {
        let a = rational(&a);
        prop_assume!(!a.determinant().unwrap().is_zero());
        let right = Matrix::column(b.into_iter().map(integer).collect()).unwrap();
        prop_assert_eq!(a.times(&a.solve(&right).unwrap()), Ok(right));
    }

    #[test]
    fn solutions_in_balls_contain_the_exact_solution(a in square(3), b in prop::collection::vec(-9_i64..=9, 3)) {
        let a = rational(&a);
        prop_assume!(!a.determinant().unwrap().is_zero());
        let right = Matrix::column(b.into_iter().map(integer).collect()).unwrap();
        let enclosed = |m: &Matrix<Rational>| m.map(|entry| Ball::from_rational(entry, 120));
        let exact = a.solve(&right).unwrap();
        let balls = enclosed(&a).solve(&enclosed(&right)).unwrap();
        for (exact, ball) in exact.rows().flatten().zip(balls.rows().flatten()) {
            prop_assert!(ball.contains(exact));
        }
    }
}
