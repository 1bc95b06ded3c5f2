//! Formulas of the shipped papers, as programs have them.

use std::f64::consts::FRAC_PI_2;

const DEGREE: usize = 3;

fn binomial(n: usize, k: usize) -> usize {
    let mut value = 1;
    for j in 0..k {
        value = value * (n - j) / (j + 1);
    }
    value
}

pub fn curve(x: f64, p: &[f64; DEGREE + 1]) -> f64 {
    (0..=DEGREE)
        .map(|i| binomial(DEGREE, i) as f64 * x.powi(i as i32) * (1.0 - x).powi((DEGREE - i) as i32) * p[i])
        .sum()
}

pub fn casteljau(x: f64, p: &[f64]) -> f64 {
    let mut q = p.to_vec();
    for k in 1..q.len() {
        for i in 0..q.len() - k {
            q[i] = (1.0 - x) * q[i] + x * q[i + 1];
        }
    }
    q[0]
}

pub fn second_derivative(m: usize, p: &[f64]) -> f64 {
    let factor = (m * (m - 1)) as f64;
    factor * (p[m] - 2.0 * p[m - 1] + p[m - 2])
}

pub fn middle(p: &[f64]) -> f64 {
    let weights = [1.0, 3.0, 3.0, 1.0];
    let mut total = 0.0;
    for (i, weight) in weights.iter().enumerate() {
        total += weight * p[i];
    }
    total / 8.0
}

pub fn first(z: f64, mu: f64) -> f64 {
    let s = (FRAC_PI_2 * z).sin();
    (1.0 - s) * (1.0 - mu * s)
}

pub fn third(z: f64, nu: f64) -> f64 {
    let c = f64::cos(0.5 * std::f64::consts::PI * z);
    (1.0 - c) * (1.0 - nu * c)
}

/// The functions of order m, by the recursion.
pub fn basis(k: i32, m: i32, z: f64, mu: f64, nu: f64) -> f64 {
    if k < 0 || k > m {
        return 0.0;
    }
    if m == 2 {
        let (f0, f2) = (first(z, mu), third(z, nu));
        [f0, 1.0 - f0 - f2, f2][k as usize]
    } else {
        (1.0 - z) * basis(k, m - 1, z, mu, nu) + z * basis(k - 1, m - 1, z, mu, nu)
    }
}

pub fn cubic(u: f64, p0: f64, p1: f64, p0u: f64, p1u: f64) -> f64 {
    let a = 2.0 * p0 - 2.0 * p1 + p0u + p1u;
    let b = -3.0 * p0 + 3.0 * p1 - 2.0 * p0u - p1u;
    a.mul_add(u, b).mul_add(u, p0u).mul_add(u, p0)
}

pub fn uniform(s: f64) -> [f64; 4] {
    let cubes = [s.powi(3), (1.0 - s).powi(3)];
    [
        cubes[1] / 6.0,
        (3.0 * cubes[0] - 6.0 * s * s + 4.0) / 6.0,
        (-3.0 * cubes[0] + 3.0 * s * s + 3.0 * s + 1.0) / 6.0,
        cubes[0] / 6.0,
    ]
}
