//! Numbers as they are read at a bench.

/// A length with two decimals at most: nobody measures more.
pub(super) fn length(value: f64) -> String {
    trimmed(&format!("{value:.2}"))
}

/// An angle in degrees with one decimal at most.
pub(super) fn degrees(value: f64) -> String {
    format!("{}°", trimmed(&format!("{value:.1}")))
}

/// A number without zeros at the end of its decimals, and without the sign of a zero.
pub(super) fn trimmed(text: &str) -> String {
    let short = if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.')
    } else {
        text
    };
    if short == "-0" {
        "0".to_owned()
    } else {
        short.to_owned()
    }
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
