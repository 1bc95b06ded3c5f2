//! Numbers as they are read at a bench.

use crate::numbers::without_trailing_zeros;

/// Returns a length with two decimals at most: nobody measures more.
pub(super) fn length(value: f64) -> String {
    without_trailing_zeros(&format!("{value:.2}"))
}

/// Returns an angle in degrees with one decimal at most.
pub(super) fn degrees(value: f64) -> String {
    format!("{}°", without_trailing_zeros(&format!("{value:.1}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_have_two_decimals_at_most_and_no_negative_zero() {
        let shown = [0.0, -0.001, 120.0, 62.131_26, 10.5].map(length);
        assert_eq!(shown, ["0", "0", "120", "62.13", "10.5"]);
        assert_eq!([90.0, 22.5, -0.01].map(degrees), ["90°", "22.5°", "0°"]);
    }
}
