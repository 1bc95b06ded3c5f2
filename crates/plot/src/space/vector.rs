//! The few operations on triples that drawing needs.

/// A point or vector of space.
pub(crate) type V3 = [f64; 3];

pub(crate) fn sub(a: V3, b: V3) -> V3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(crate) fn add(a: V3, b: V3) -> V3 {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(crate) fn times(a: V3, s: f64) -> V3 {
    a.map(|c| c * s)
}

pub(crate) fn dot(a: V3, b: V3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: V3, b: V3) -> V3 {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// The unit vector along `a`; `None` if `a` has no direction.
pub(crate) fn unit(a: V3) -> Option<V3> {
    // Scaling first keeps squares of very large and very small components finite and nonzero.
    let largest = a.iter().fold(0.0f64, |m, c| m.max(c.abs()));
    if !(largest > 0.0 && largest.is_finite()) {
        return None;
    }
    let a = a.map(|c| c / largest);
    let length = dot(a, a).sqrt();
    Some(a.map(|c| c / length))
}

pub(crate) fn lerp(a: V3, b: V3, t: f64) -> V3 {
    [0, 1, 2].map(|k| a[k] + t * (b[k] - a[k]))
}
