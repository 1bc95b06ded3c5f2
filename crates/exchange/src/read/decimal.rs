//! Numbers of files, exactly as they are written.

use torse_algebra::Rational;

/// The longest number that is read: no program writes more digits, and exact arithmetic would carry them on.
const MAX_LENGTH: usize = 64;
/// The largest exponent of ten.
const MAX_EXPONENT: i32 = 320;

/// The number that a text says: digits, a point, an exponent after `e`, `E`, `d` or `D` (Fortran writes these, IGES has
/// them). Nothing for NaN, infinities, what does not fit f64, and other text.
pub(super) fn decimal(text: &str) -> Option<Rational> {
    let text = text.trim();
    if text.len() > MAX_LENGTH {
        return None;
    }
    let (negative, digits) = match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    };
    let (mantissa, exponent) = digits
        .split_once(['e', 'E', 'd', 'D'])
        .unwrap_or((digits, "0"));
    let exponent: i32 = exponent
        .parse()
        .ok()
        .filter(|e: &i32| e.abs() <= MAX_EXPONENT)?;
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    if whole.is_empty() && fraction.is_empty() {
        return None;
    }
    if !whole
        .bytes()
        .chain(fraction.bytes())
        .all(|b| b.is_ascii_digit())
    {
        return None;
    }
    let places = i32::try_from(fraction.len()).ok()?;
    let all = format!("{whole}{fraction}");
    let integer = torse_algebra::Integer::from_str_radix(&all, 10).ok()?;
    let number = Rational::from_integer(integer) * Rational::from(10).pow(exponent - places);
    let size = torse_algebra::rational::to_f64(&number);
    size.is_finite()
        .then_some(if negative { -number } else { number })
}

/// The same rounded to f64.
pub(super) fn double(text: &str) -> Option<f64> {
    text.trim()
        .parse()
        .ok()
        .filter(|value: &f64| value.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;
    use torse_algebra::rational::{integer, ratio};

    #[test]
    fn numbers_are_what_is_written() {
        assert_eq!(decimal("1.E-07"), ratio(1, 10_000_000));
        assert_eq!(decimal(" -0.1 "), ratio(-1, 10));
        assert_eq!(
            decimal("1.551974581691E+03"),
            ratio(1_551_974_581_691, 1_000_000_000)
        );
        assert_eq!(decimal("1.5D+03"), Some(integer(1500)));
        assert_eq!(decimal(".5"), ratio(1, 2));
    }

    #[test]
    fn what_is_no_number_is_none() {
        for text in [
            "",
            ".",
            "-",
            "NaN",
            "inf",
            "1e999",
            "1e",
            "0x10",
            "1_000",
            "1e-9999999999",
            "1..2",
        ] {
            assert_eq!(decimal(text), None, "{text}");
        }
        assert_eq!(decimal(&"9".repeat(65)), None);
    }
}
