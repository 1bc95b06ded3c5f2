//! A point of a Bézier curve, by de Casteljau's algorithm.

/// The point at `t` of the curve with these control points.
pub fn point(t: f64, points: &[f64]) -> f64 {
    let mut q = points.to_vec();
    for k in 1..q.len() {
        for i in 0..q.len() - k {
            q[i] = (1.0 - t) * q[i] + t * q[i + 1];
        }
    }
    q[0]
}
