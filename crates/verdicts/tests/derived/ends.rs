/// Derivatives up to order 3 at the ends of a curve of the family g, degree k.
///
/// One coordinate of the points `R[0]`, `R[1]`, `R[2]`, `R[3]`, `R[k]`, `R[k-1]`, `R[k-2]`, `R[k-3]` in, one coordinate of `G(0)`, `G'(0)`, `G''(0)`, `G'''(0)`, `G(1)`, `G'(1)`, `G''(1)`, `G'''(1)` out.
///
/// Where `k >= 3`.
#[allow(non_snake_case, unused_variables, clippy::all, clippy::pedantic)]
pub fn end_derivatives(k: f64, mu: f64, nu: f64, points: [f64; 8]) -> [f64; 8] {
    let [R_0, R_1, R_2, R_3, R_k, R_k_1, R_k_2, R_k_3] = points;
    let G_0 = R_0;
    let G_d1_0 = 1.0 / 2.0 * (2.0 * (k - 2.0) + std::f64::consts::PI * (1.0 + mu)) * (R_1 - R_0);
    let G_d2_0 = 1.0 / 4.0 * (4.0 * (k - 2.0) * (k - 3.0 + std::f64::consts::PI * (1.0 + mu)) * (R_0 - 2.0 * R_1 + R_2) + 2.0 * std::f64::consts::PI.powi(2) * mu * (R_0 - R_1) + std::f64::consts::PI.powi(2) * (1.0 - nu) * (R_2 - R_1));
    let a31 = 1.0 / 8.0 * (8.0 * (k - 2.0) * (k - 3.0) * (k - 4.0) + 12.0 * std::f64::consts::PI * (k - 2.0) * (k - 3.0) * (1.0 + mu) + 12.0 * std::f64::consts::PI.powi(2) * mu * (k - 2.0) - std::f64::consts::PI.powi(3) * (1.0 + mu));
    let a32 = -1.0 / 4.0 * (k - 2.0) * (8.0 * (k - 3.0) * (k - 4.0) + 12.0 * std::f64::consts::PI * (k - 3.0) * (1.0 + mu) + 3.0 * std::f64::consts::PI.powi(2) * (2.0 * mu - nu + 1.0));
    let a33 = 1.0 / 4.0 * (k - 2.0) * (4.0 * (k - 3.0) * (k - 4.0) + 6.0 * std::f64::consts::PI * (k - 3.0) * (1.0 + mu) + 3.0 * std::f64::consts::PI.powi(2) * (1.0 - nu));
    let G_d3_0 = a31 * (R_1 - R_0) + a32 * (R_2 - R_1) + a33 * (R_3 - R_2);
    let G_1 = R_k;
    let G_d1_1 = 1.0 / 2.0 * (2.0 * (k - 2.0) + std::f64::consts::PI * (1.0 + nu)) * (R_k - R_k_1);
    let G_d2_1 = 1.0 / 4.0 * (4.0 * (k - 2.0) * (k - 3.0 + std::f64::consts::PI * (1.0 + nu)) * (R_k_2 - 2.0 * R_k_1 + R_k) + std::f64::consts::PI.powi(2) * (1.0 - mu) * (R_k_2 - R_k_1) + 2.0 * std::f64::consts::PI.powi(2) * nu * (R_k - R_k_1));
    let b31 = 1.0 / 8.0 * (8.0 * (k - 2.0) * (k - 3.0) * (k - 4.0) + 12.0 * std::f64::consts::PI * (k - 2.0) * (k - 3.0) * (1.0 + nu) + 12.0 * std::f64::consts::PI.powi(2) * nu * (k - 2.0) - std::f64::consts::PI.powi(3) * (1.0 + nu));
    let b32 = -1.0 / 4.0 * (k - 2.0) * (8.0 * (k - 3.0) * (k - 4.0) + 12.0 * std::f64::consts::PI * (k - 3.0) * (1.0 + nu) - 3.0 * std::f64::consts::PI.powi(2) * (mu - 2.0 * nu - 1.0));
    let b33 = 1.0 / 4.0 * (k - 2.0) * (4.0 * (k - 3.0) * (k - 4.0) + 6.0 * std::f64::consts::PI * (k - 3.0) * (1.0 + nu) + 3.0 * std::f64::consts::PI.powi(2) * (1.0 - mu));
    let G_d3_1 = b31 * (R_k - R_k_1) + b32 * (R_k_1 - R_k_2) + b33 * (R_k_2 - R_k_3);
    [G_0, G_d1_0, G_d2_0, G_d3_0, G_1, G_d1_1, G_d2_1, G_d3_1]
}
