//! Numerals with an exponent, `1.5e-3`, which the language of formulas does not know, and lengths with a unit, `2 in`.

use crate::unit::DesignUnit;
use torse_numbers::rational::Rational;

/// A formula in which each numeral with an exponent is a name of the same length, so that places in it stay where they are.
pub struct Numerals {
    /// The formula.
    pub text: String,
    /// The names, and the numbers they stand for.
    pub values: Vec<(String, Rational)>,
}

impl Numerals {
    /// Replaces the numerals of a formula by names that are not `taken`.
    pub fn new(text: &str, taken: impl Fn(&str) -> bool) -> Self {
        let bytes = text.as_bytes();
        let digits = |from: usize| {
            let rest = bytes.get(from..).unwrap_or_default();
            rest.iter().take_while(|b| b.is_ascii_digit()).count()
        };
        let at = |k: usize| bytes.get(k).copied().unwrap_or(b' ');
        let mut found = Self {
            text: text.to_owned(),
            values: Vec::new(),
        };
        let mut k = 0;
        while k < bytes.len() {
            // What goes on from a letter or a digit is part of a name.
            let word = at(k).is_ascii_alphanumeric() || matches!(at(k), b'_' | b'.');
            if !word {
                k += 1;
                continue;
            }
            let start = k;
            k += digits(k);
            if at(k) == b'.' {
                k += 1 + digits(k + 1);
            }
            if k > start && matches!(at(k), b'e' | b'E') {
                let sign = usize::from(matches!(at(k + 1), b'+' | b'-'));
                let exponent = digits(k + 1 + sign);
                if exponent > 0 {
                    k += 1 + sign + exponent;
                    found.replace(start, k, &taken);
                    continue;
                }
            }
            while at(k).is_ascii_alphanumeric() || matches!(at(k), b'_' | b'.') {
                k += 1;
            }
        }
        found
    }

    fn replace(&mut self, start: usize, end: usize, taken: impl Fn(&str) -> bool) {
        let Some(value) = self.text.get(start..end).and_then(decimal) else {
            return;
        };
        let width = end - start - 1;
        let names = (self.values.len()..1000).map(|k| format!("e{k:0width$}"));
        let mut fitting = names.filter(|name| name.len() == end - start);
        if let Some(name) = fitting.find(|name| !taken(name)) {
            self.text.replace_range(start..end, &name);
            self.values.push((name, value));
        }
    }
}

/// Returns the number that a numeral says: digits, point, exponent.
pub fn decimal(text: &str) -> Option<Rational> {
    let (negative, text) = match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    };
    let (digits, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let exponent: i32 = exponent.parse().ok().filter(|e: &i32| e.abs() <= 400)?;
    let ten = Rational::from_integer(10.into())
        .checked_pow(exponent)
        .ok()?;
    let number = Rational::from_decimal(digits).ok()? * ten;
    Some(if negative { -number } else { number })
}

/// Returns a formula without the unit of length that stands behind it, and the unit: behind a digit, a bracket or a space. A
/// name that is `taken` is no unit.
pub fn with_unit(text: &str, taken: impl Fn(&str) -> bool) -> Option<(&str, DesignUnit)> {
    let text = text.trim_end();
    let value = text.trim_end_matches(|c: char| c.is_ascii_alphabetic());
    let word = text.get(value.len()..)?;
    let unit = DesignUnit::named(word).filter(|_| !taken(word))?;
    let ends_a_value = |c: char| c.is_ascii_alphanumeric() || matches!(c, ')' | '.' | '_');
    value
        .trim_end()
        .ends_with(ends_a_value)
        .then_some((value, unit))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numerals_with_exponents_become_names_of_the_same_length() {
        let found = Numerals::new("2*1.5e-3 + x1e3 - 4E2", |name| name == "e01");
        assert_eq!(found.text, "2*e00000 + x1e3 - e02");
        let values: Vec<String> = found.values.iter().map(|(_, q)| q.to_string()).collect();
        assert_eq!(values, ["3/2000", "400"]);
        for plain in ["2*e", "1e", "1.5", "e1 + 2", "r2e5", "1e999999999999"] {
            let found = Numerals::new(plain, |_| false);
            assert_eq!((found.text.as_str(), found.values.len()), (plain, 0));
        }
    }

    #[test]
    fn units_stand_behind_values() {
        let unit = |text: &'static str| with_unit(text, |name| name == "m").map(|(value, _)| value);
        assert_eq!(unit("2 in"), Some("2 "));
        assert_eq!(unit("2.5mm "), Some("2.5"));
        assert_eq!(unit("(a + 1) cm"), Some("(a + 1) "));
        assert_eq!(
            [
                unit("2*m"),
                unit("2 m"),
                unit("a*in"),
                unit("in"),
                unit("2 parsec")
            ],
            [None; 5]
        );
    }
}
