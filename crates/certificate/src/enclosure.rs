//! Proofs that printed decimals agree with exact values.

use crate::number::decimal;
use crate::polynomial::Polynomial;
use crate::ratio::Ratio;
use serde::{Serialize, Serializer};
use torse_core::Printed;

/// How a printed number agrees.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Agreement {
    /// The printed number is the value.
    Exact,
    /// It is the rounded value.
    Rounded,
    /// It is the truncated value.
    CutOff,
}

/// An exact value, and the number that is printed for it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Agreeing<P> {
    /// The exact value, which is a constant.
    pub value: Ratio<P>,
    /// The printed number.
    #[serde(serialize_with = "as_printed")]
    pub printed: Printed,
    /// How they agree; `None` if they do not.
    pub how: Option<Agreement>,
}

/// A proof that printed numbers agree with their values.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Enclosure<P> {
    /// The entries in order.
    pub entries: Vec<Agreeing<P>>,
}

fn as_printed<S: Serializer>(printed: &Printed, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(&text(printed))
}

/// A printed number with its digits.
#[must_use]
pub fn text(printed: &Printed) -> String {
    let decimals = usize::try_from(printed.decimals.unwrap_or(0)).unwrap_or(0);
    let scale = torse_numbers::Integer::from(10).pow(decimals);
    let scaled = &printed.value * torse_numbers::Rational::from_integer(scale);
    let digits = num_traits::Signed::abs(&scaled.to_integer()).to_string();
    let sign = if printed.negative { "-" } else { "" };
    if decimals == 0 {
        return format!("{sign}{digits}");
    }
    let padded = format!("{digits:0>width$}", width = decimals + 1);
    let (whole, fraction) = padded.split_at(padded.len() - decimals);
    format!("{sign}{whole}.{fraction}")
}

/// One text, or several in square brackets.
pub(crate) fn listed(parts: Vec<String>) -> String {
    match parts.as_slice() {
        [one] => one.clone(),
        _ => format!("[{}]", parts.join(", ")),
    }
}

impl<P> Enclosure<P> {
    /// Converts every polynomial.
    pub fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Enclosure<Q> {
        let entry = |entry: &Agreeing<P>| Agreeing {
            value: entry.value.map(change),
            printed: entry.printed.clone(),
            how: entry.how,
        };
        Enclosure {
            entries: self.entries.iter().map(entry).collect(),
        }
    }

    /// Whether every printed number is exact.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        let exact = |entry: &Agreeing<P>| entry.how == Some(Agreement::Exact);
        self.entries.iter().all(exact)
    }

    /// The largest number of digits after a decimal point.
    #[must_use]
    pub fn digits(&self) -> u32 {
        let digits = self.entries.iter().filter_map(|e| e.printed.decimals);
        digits.max().unwrap_or(0)
    }

    /// The numbers, from 1, of the entries that do not agree.
    #[must_use]
    pub fn differing(&self) -> Vec<usize> {
        let numbered = (1..).zip(&self.entries);
        let differing = numbered.filter(|(_, entry)| entry.how.is_none());
        differing.map(|(number, _)| number).collect()
    }
}

impl Enclosure<Polynomial> {
    /// The values as decimals with a few more digits than are printed.
    #[must_use]
    pub fn decimals(&self) -> String {
        let digits = usize::try_from(self.digits()).unwrap_or(0) + 8;
        let shown = |e: &Agreeing<Polynomial>| decimal(&e.value, digits).unwrap_or_default();
        listed(self.entries.iter().map(shown).collect())
    }
}
