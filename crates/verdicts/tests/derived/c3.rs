/// C3 join of two curves of the family g, degrees m and n.
///
/// One coordinate of the points `Q[m]`, `Q[m-1]`, `Q[m-2]`, `Q[m-3]` in, one coordinate of `Q1[0]`, `Q1[1]`, `Q1[2]`, `Q1[3]` out.
///
/// Where `m >= 3`, `n >= 3`, `a11 != 0`, `a22 != 0`, `a33 != 0`.
#[allow(non_snake_case, unused_variables, clippy::all, clippy::pedantic)]
pub fn next_points(m: f64, n: f64, mu: f64, nu: f64, mu1: f64, nu1: f64, points: [f64; 4]) -> [f64; 4] {
    let [Q_m, Q_m_1, Q_m_2, Q_m_3] = points;
    let a11 = n - 2.0 + 1.0 / 2.0 * std::f64::consts::PI * (1.0 + mu1);
    let a21 = -(n - 2.0) * (n - 3.0) - std::f64::consts::PI * (1.0 + mu1) * (n - 2.0) - 1.0 / 2.0 * std::f64::consts::PI.powi(2) * mu1;
    let a22 = (n - 2.0) * (n - 3.0) + std::f64::consts::PI * (1.0 + mu1) * (n - 2.0) + 1.0 / 4.0 * std::f64::consts::PI.powi(2) * (1.0 - nu1);
    let a31 = 1.0 / 8.0 * (8.0 * (n - 2.0) * (n - 3.0) * (n - 4.0) + 12.0 * std::f64::consts::PI * (1.0 + mu1) * (n - 2.0) * (n - 3.0) + 12.0 * std::f64::consts::PI.powi(2) * mu1 * (n - 2.0) - std::f64::consts::PI.powi(3) * (1.0 + mu1));
    let a32 = -1.0 / 4.0 * (n - 2.0) * (8.0 * (n - 3.0) * (n - 4.0) + 12.0 * std::f64::consts::PI * (1.0 + mu1) * (n - 3.0) + 3.0 * std::f64::consts::PI.powi(2) * (2.0 * mu1 - nu1 + 1.0));
    let a33 = 1.0 / 4.0 * (n - 2.0) * (4.0 * (n - 3.0) * (n - 4.0) + 6.0 * std::f64::consts::PI * (1.0 + mu1) * (n - 3.0) + 3.0 * std::f64::consts::PI.powi(2) * (1.0 - nu1));
    let b11 = m - 2.0 + 1.0 / 2.0 * std::f64::consts::PI * (1.0 + nu);
    let b21 = (m - 2.0) * (m - 3.0) + std::f64::consts::PI * (m - 2.0) * (1.0 + nu) + 1.0 / 2.0 * std::f64::consts::PI.powi(2) * nu;
    let b22 = -(m - 2.0) * (m - 3.0) - std::f64::consts::PI * (m - 2.0) * (1.0 + nu) - 1.0 / 4.0 * std::f64::consts::PI.powi(2) * (1.0 - mu);
    let b31 = 1.0 / 8.0 * (8.0 * (m - 2.0) * (m - 3.0) * (m - 4.0) + 12.0 * std::f64::consts::PI * (m - 2.0) * (m - 3.0) * (1.0 + nu) + 12.0 * std::f64::consts::PI.powi(2) * nu * (m - 2.0) - std::f64::consts::PI.powi(3) * (1.0 + nu));
    let b32 = -1.0 / 4.0 * (m - 2.0) * (8.0 * (m - 3.0) * (m - 4.0) + 12.0 * std::f64::consts::PI * (m - 3.0) * (1.0 + nu) - 3.0 * std::f64::consts::PI.powi(2) * (mu - 2.0 * nu - 1.0));
    let b33 = 1.0 / 4.0 * (m - 2.0) * (4.0 * (m - 3.0) * (m - 4.0) + 6.0 * std::f64::consts::PI * (m - 3.0) * (1.0 + nu) + 3.0 * std::f64::consts::PI.powi(2) * (1.0 - mu));
    let c11 = b11 / a11;
    let c21 = (b21 - a21 * c11) / a22;
    let c22 = b22 / a22;
    let c31 = (b31 - a31 * c11 - a32 * c21) / a33;
    let c32 = (b32 - a32 * c22) / a33;
    let c33 = b33 / a33;
    let Q1_0 = Q_m;
    let Q1_1 = Q1_0 + c11 * (Q_m - Q_m_1);
    let Q1_2 = Q1_1 + c21 * (Q_m - Q_m_1) + c22 * (Q_m_1 - Q_m_2);
    let Q1_3 = Q1_2 + c31 * (Q_m - Q_m_1) + c32 * (Q_m_1 - Q_m_2) + c33 * (Q_m_2 - Q_m_3);
    [Q1_0, Q1_1, Q1_2, Q1_3]
}
