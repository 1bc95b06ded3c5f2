//! Numbers in tables and messages.

/// Writes a number briefly: with at most three decimals, from 1000 on as an integer, below 0.001 and from a million on
/// with an exponent; sizes below 1e-12 as 0.
pub fn number(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 || size < 1e-12 {
        // Rounding of lengths and angles.
        return "0".to_owned();
    }
    if !(1e-3..1e6).contains(&size) {
        return format!("{value:.2e}");
    }
    let decimals = if size >= 1000.0 {
        0
    } else if size >= 100.0 {
        1
    } else if size >= 10.0 {
        2
    } else {
        3
    };
    without_trailing_zeros(&format!("{value:.decimals$}"))
}

/// Returns a number with three digits that is not below the value.
pub fn at_most(value: f64) -> String {
    if value <= 0.0 || !value.is_finite() {
        return number(value);
    }
    let nearest = format!("{value:.2e}");
    let text = match nearest.parse::<f64>() {
        Ok(shown) if shown < value => next_above(&nearest).unwrap_or(nearest),
        _ => nearest,
    };
    match text.parse::<f64>() {
        // The shortest form of the nearest double to a decimal is the decimal.
        Ok(shown) if (1e-3..1e6).contains(&shown) => shown.to_string(),
        _ => text,
    }
}

/// Returns the decimal with three digits after one such as `5.64e-9`.
fn next_above(text: &str) -> Option<String> {
    let (digits, exponent) = text.split_once('e')?;
    let exponent: i32 = exponent.parse().ok()?;
    let count: u32 = digits.replace('.', "").parse().ok()?;
    let (count, exponent) = match count + 1 {
        1000 => (100, exponent + 1),
        count => (count, exponent),
    };
    Some(format!("{}.{:02}e{exponent}", count / 100, count % 100))
}

/// Returns a number without zeros at the end of its decimals, and without the sign of a zero.
pub(crate) fn without_trailing_zeros(text: &str) -> String {
    let short = match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.'),
        false => text,
    };
    let zero = short == "-0";
    if zero { "0" } else { short }.to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let shown = [
            0.0, 1e-15, 12.0, 0.123_456, 123.456, -7.5, 123_456.7, 1e9, 2.5e-7,
        ]
        .map(number);
        let wanted = [
            "0", "0", "12", "0.123", "123.5", "-7.5", "123457", "1.00e9", "2.50e-7",
        ];
        assert_eq!(shown, wanted);
    }

    #[test]
    fn bounds_are_rounded_upwards() {
        let shown = [0.0, 0.088_252_2, 0.0883, 2.501, 123_456.7, 1.234_4e-7].map(at_most);
        assert_eq!(
            shown,
            ["0", "0.0883", "0.0883", "2.51", "124000", "1.24e-7"]
        );
        // To the last bit, and across a power of ten.
        let shown = [0.0883_f64.next_up(), 5.642_051e-9, 9.991e-5, 0.999_1].map(at_most);
        assert_eq!(shown, ["0.0884", "5.65e-9", "1.00e-4", "1"]);
    }
}
