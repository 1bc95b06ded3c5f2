//! Dash patterns along projected space curves.

use crate::space::vector::{V3, lerp};

/// Cut a chain of segments into the strokes of `pattern`, whose lengths are measured on the page (first two
/// coordinates). An empty pattern leaves the chain whole.
pub(crate) fn dashes(chain: &[[V3; 2]], pattern: &[f64]) -> Vec<[V3; 2]> {
    let period: f64 = pattern.iter().sum();
    if !(period > 0.0 && period.is_finite()) {
        return chain.to_vec();
    }
    let mut strokes = Vec::new();
    let mut offset = 0.0;
    for &[a, b] in chain {
        let length = libm::hypot(b[0] - a[0], b[1] - a[1]);
        let mut from = 0.0;
        while from < length {
            let (on, left) = phase(pattern, offset);
            let to = (from + left).min(length);
            if on {
                strokes.push([lerp(a, b, from / length), lerp(a, b, to / length)]);
            }
            offset = (offset + (to - from)) % period;
            // A step too small for floating point would never end.
            from = if to > from { to } else { length };
        }
    }
    strokes
}

/// Whether the pen is down at `offset`, and how far it stays so.
fn phase(pattern: &[f64], offset: f64) -> (bool, f64) {
    let mut end = 0.0;
    for (k, part) in pattern.iter().enumerate() {
        end += part;
        // Rounding must not leave a sliver of the part before.
        if end - offset > 1e-9 * end {
            return (k % 2 == 0, end - offset);
        }
    }
    (true, pattern.first().copied().unwrap_or(f64::INFINITY))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strokes_and_gaps_continue_across_corners() {
        let chain = [
            [[0.0, 0.0, 0.0], [3.0, 0.0, 3.0]],
            [[3.0, 0.0, 3.0], [3.0, 3.0, 3.0]],
        ];
        let strokes = dashes(&chain, &[2.0, 2.0]);
        let expected = [
            [[0.0, 0.0, 0.0], [2.0, 0.0, 2.0]],
            [[3.0, 1.0, 3.0], [3.0, 3.0, 3.0]],
        ];
        assert_eq!(strokes.len(), 2);
        for (s, e) in strokes
            .iter()
            .flatten()
            .flatten()
            .zip(expected.iter().flatten().flatten())
        {
            assert!((s - e).abs() < 1e-9);
        }
    }

    #[test]
    fn a_solid_line_is_left_whole() {
        let chain = [[[0.0; 3], [1.0; 3]]];
        assert_eq!(dashes(&chain, &[]), chain);
    }
}
