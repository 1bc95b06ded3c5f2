//! Fractions as text.

use super::Fraction;
use crate::polynomial::Polynomial;
use std::fmt;

impl fmt::Display for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let grouped = |p: &Polynomial| {
            if p.len() > 1 {
                format!("({p})")
            } else {
                p.to_string()
            }
        };
        if self.denominator.is_empty() {
            return write!(f, "{}", self.numerator);
        }
        let factors: Vec<String> = self
            .denominator
            .iter()
            .map(|(factor, exponent)| match exponent {
                1 => grouped(factor),
                _ => format!("{}^{exponent}", grouped(factor)),
            })
            .collect();
        let one_plain = self.denominator.len() == 1
            && self
                .denominator
                .iter()
                .all(|(p, _)| p.len() > 1 || p.total_degree() == 1);
        let below = factors.join("*");
        write!(
            f,
            "{}/{}",
            grouped(&self.numerator),
            if one_plain {
                below
            } else {
                format!("({below})")
            }
        )
    }
}
