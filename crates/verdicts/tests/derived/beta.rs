/// G2-beta join of two plane families over the basis g, degrees m and n.
///
/// One coordinate of the points `Q[m]`, `Q[m-1]`, `Q[m-2]` in, one coordinate of `Q1[0]`, `Q1[1]`, `Q1[2]` out.
///
/// Where `m >= 2`, `n >= 2`, `a11 != 0`, `a22 != 0`.
#[allow(non_snake_case, unused_variables, clippy::all, clippy::pedantic)]
pub fn next_points(m: f64, n: f64, mu: f64, nu: f64, mu1: f64, nu1: f64, gamma: f64, lambda: f64, points: [f64; 3]) -> [f64; 3] {
    let [Q_m, Q_m_1, Q_m_2] = points;
    let a11 = n - 2.0 + 1.0 / 2.0 * std::f64::consts::PI * (1.0 + mu1);
    let a21 = -(n - 2.0) * (n - 3.0) - std::f64::consts::PI * (1.0 + mu1) * (n - 2.0) - 1.0 / 2.0 * std::f64::consts::PI.powi(2) * mu1;
    let a22 = (n - 2.0) * (n - 3.0) + std::f64::consts::PI * (1.0 + mu1) * (n - 2.0) + 1.0 / 4.0 * std::f64::consts::PI.powi(2) * (1.0 - nu1);
    let b11 = m - 2.0 + 1.0 / 2.0 * std::f64::consts::PI * (1.0 + nu);
    let b21 = (m - 2.0) * (m - 3.0) + std::f64::consts::PI * (m - 2.0) * (1.0 + nu) + 1.0 / 2.0 * std::f64::consts::PI.powi(2) * nu;
    let b22 = -(m - 2.0) * (m - 3.0) - std::f64::consts::PI * (m - 2.0) * (1.0 + nu) - 1.0 / 4.0 * std::f64::consts::PI.powi(2) * (1.0 - mu);
    let c11 = gamma * b11 / a11;
    let c21 = (lambda * b11 + gamma.powi(2) * b21 - a21 * c11) / a22;
    let c22 = gamma.powi(2) * b22 / a22;
    let Q1_0 = Q_m;
    let Q1_1 = Q1_0 + c11 * (Q_m - Q_m_1);
    let Q1_2 = Q1_1 + c21 * (Q_m - Q_m_1) + c22 * (Q_m_1 - Q_m_2);
    [Q1_0, Q1_1, Q1_2]
}
