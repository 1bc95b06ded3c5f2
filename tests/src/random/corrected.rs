//! Whether a printed correction is true: its right side, read by a reader of our own, has the values of the polynomial
//! that the side should be.

use super::number::Q;
use super::polynomial::{Polynomial, SLOTS};

/// What the right side of an equation should be.
#[derive(Debug, Clone)]
pub struct Wanted {
    /// The names of the slots.
    pub names: Vec<String>,
    /// The polynomial.
    pub value: Polynomial,
}

impl Wanted {
    /// Whether the right side of `left == right` has the right values; `None` where it cannot be read.
    #[must_use]
    pub fn agrees(&self, statement: &str) -> Option<bool> {
        let (_, right) = statement.split_once("==")?;
        let mut read = 0;
        for k in 2..9 {
            let mut point = [Q::ZERO; SLOTS];
            for (slot, value) in (1_i128..).zip(point.iter_mut()) {
                *value = Q::new(k * slot + 1, slot + 2);
            }
            let mut reader = Reader {
                text: right.as_bytes(),
                names: &self.names,
                point: &point,
            };
            let value = reader.sum();
            if value.is_none() && read == 0 && k < 8 {
                continue;
            }
            reader.blanks();
            if !reader.text.is_empty() || value? != self.value.value(&point) {
                return reader.text.is_empty().then_some(false);
            }
            read += 1;
        }
        Some(read > 0)
    }
}

struct Reader<'a> {
    text: &'a [u8],
    names: &'a [String],
    point: &'a [Q; SLOTS],
}

impl Reader<'_> {
    fn blanks(&mut self) {
        self.text = self.text.trim_ascii_start();
    }

    fn take(&mut self, symbol: u8) -> bool {
        self.blanks();
        let found = self.text.first() == Some(&symbol);
        if found {
            self.text = &self.text[1..];
        }
        found
    }

    fn sum(&mut self) -> Option<Q> {
        let mut total = self.product()?;
        loop {
            if self.take(b'+') {
                total = total + self.product()?;
            } else if self.take(b'-') {
                total = total - self.product()?;
            } else {
                return Some(total);
            }
        }
    }

    fn product(&mut self) -> Option<Q> {
        let mut total = self.signed()?;
        loop {
            if self.take(b'*') {
                total = total * self.signed()?;
            } else if self.take(b'/') {
                let below = self.signed()?;
                if below == Q::ZERO {
                    return None;
                }
                total = total.over(below);
            } else {
                return Some(total);
            }
        }
    }

    fn signed(&mut self) -> Option<Q> {
        if self.take(b'-') {
            return self.signed().map(|q| -q);
        }
        let base = self.atom()?;
        if self.take(b'^') {
            let exponent = self.atom()?;
            let exponent = u32::try_from(exponent.above)
                .ok()
                .filter(|_| exponent.is_integer())?;
            return Some(base.power(exponent));
        }
        Some(base)
    }

    fn atom(&mut self) -> Option<Q> {
        if self.take(b'(') {
            let inner = self.sum()?;
            return self.take(b')').then_some(inner);
        }
        let end = self.text.iter().position(|c| !c.is_ascii_alphanumeric());
        let (word, rest) = self.text.split_at(end.unwrap_or(self.text.len()));
        let word = std::str::from_utf8(word).ok()?;
        self.text = rest;
        if let Some(slot) = self.names.iter().position(|name| name == word) {
            return self.point.get(slot).copied();
        }
        word.parse().ok().map(Q::int)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_right_side_is_read_like_a_formula() {
        let x = Polynomial::variable(0);
        let wanted = Wanted {
            names: vec!["x".to_owned()],
            value: &x.power(2).times(Q::new(-3, 2)) + &Polynomial::number(Q::int(4)),
        };
        assert_eq!(wanted.agrees("f == -3/2*x^2 + 4"), Some(true));
        assert_eq!(wanted.agrees("f == 4 - (3*x)*x/2"), Some(true));
        assert_eq!(wanted.agrees("f == 4 + 3/2*x^2"), Some(false));
        assert_eq!(wanted.agrees("f == sin(x)"), None);
    }
}
