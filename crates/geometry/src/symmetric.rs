//! Eigenvalues of small symmetric matrices, on f64.

/// Rounds of rotations; convergence is quadratic, and six are enough for matrices of four rows.
const MAX_SWEEPS: usize = 32;

/// The eigenvalues of a symmetric matrix, each with its unit eigenvector, in no order: Jacobi's rotations (Golub, Van
/// Loan: *Matrix Computations*, 8.5). What is below the diagonal is not read.
pub(crate) fn eigen<const N: usize>(mut matrix: [[f64; N]; N]) -> [(f64, [f64; N]); N] {
    // The rows are the eigenvectors.
    let mut vectors: [[f64; N]; N] =
        std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j))));
    for _ in 0..MAX_SWEEPS {
        let mut is_diagonal = true;
        for p in 0..N {
            for q in p + 1..N {
                let off = matrix[p][q];
                if off == 0.0 {
                    continue;
                }
                is_diagonal = false;
                let (first, second) = (matrix[p][p], matrix[q][q]);
                let half = 0.5 * (second - first) / off;
                // The smaller angle of the two, of at most an eighth turn; none where `half` is infinite.
                let tangent = 1.0_f64.copysign(half) / (half.abs() + (half * half + 1.0).sqrt());
                let cosine = 1.0 / (tangent * tangent + 1.0).sqrt();
                let sine = tangent * cosine;
                matrix[p][p] = first - tangent * off;
                matrix[q][q] = second + tangent * off;
                matrix[p][q] = 0.0;
                let turned = |x: f64, y: f64| (cosine * x - sine * y, sine * x + cosine * y);
                for k in (0..N).filter(|k| *k != p && *k != q) {
                    let (above, below) = ((p.min(k), p.max(k)), (q.min(k), q.max(k)));
                    let (x, y) = turned(matrix[above.0][above.1], matrix[below.0][below.1]);
                    matrix[above.0][above.1] = x;
                    matrix[below.0][below.1] = y;
                }
                let (one, two) = (vectors[p], vectors[q]);
                vectors[p] = std::array::from_fn(|k| turned(one[k], two[k]).0);
                vectors[q] = std::array::from_fn(|k| turned(one[k], two[k]).1);
            }
        }
        if is_diagonal {
            break;
        }
    }
    std::array::from_fn(|i| (matrix[i][i], vectors[i]))
}

#[cfg(test)]
mod tests {
    use super::eigen;
    use proptest::prelude::*;

    /// The largest entry of `A v - lambda v` for all pairs, and of `V V^T - 1`.
    fn residual<const N: usize>(upper: [[f64; N]; N]) -> f64 {
        let entry = |i: usize, j: usize| upper[i.min(j)][i.max(j)];
        let pairs = eigen(upper);
        let mut largest = 0.0_f64;
        for (i, (value, vector)) in pairs.iter().enumerate() {
            for k in 0..N {
                let image: f64 = (0..N).map(|j| entry(k, j) * vector[j]).sum();
                largest = largest.max((image - value * vector[k]).abs());
            }
            for (j, (_, other)) in pairs.iter().enumerate() {
                let product: f64 = vector.iter().zip(other).map(|(a, b)| a * b).sum();
                largest = largest.max((product - f64::from(u8::from(i == j))).abs());
            }
        }
        largest
    }

    #[test]
    fn eigenvalues_of_known_matrices_are_found() {
        let mut pairs = eigen([[2.0, 1.0], [0.0, 2.0]]);
        pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
        assert!((pairs[0].0 - 1.0).abs() < 1e-15 && (pairs[1].0 - 3.0).abs() < 1e-15);
        assert!((pairs[1].1[0] - pairs[1].1[1]).abs() < 1e-15);
        // The second difference of four numbers: 2 - 2 cos(k pi / 5).
        let laplacian = [
            [2.0, -1.0, 0.0, 0.0],
            [0.0, 2.0, -1.0, 0.0],
            [0.0, 0.0, 2.0, -1.0],
            [0.0, 0.0, 0.0, 2.0],
        ];
        let mut values = eigen(laplacian).map(|pair| pair.0);
        values.sort_by(f64::total_cmp);
        for (k, value) in (1..=4).zip(values) {
            let exact = 2.0 - 2.0 * libm::cos(f64::from(k) * std::f64::consts::PI / 5.0);
            assert!((value - exact).abs() < 1e-15, "{value} {exact}");
        }
        assert_eq!(
            eigen([[1.0, 1e-320], [0.0, 1.0]]).map(|pair| pair.0),
            [1.0, 1.0]
        );
    }

    proptest! {
        #[test]
        fn vectors_are_orthonormal_and_solve_the_equation(
            upper in prop::array::uniform4(prop::array::uniform4(-1.0..1.0_f64)),
        ) {
            prop_assert!(residual(upper) < 1e-14, "{}", residual(upper));
        }
    }
}
