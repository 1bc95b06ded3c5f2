//! Units of length in files, and what holds where a file has none.
//!
//! One policy for every format: a file that states its unit is read in it; lengths become millimetres exactly. A file that
//! states none is read in the unit that the caller gives, in millimetres where he gives none, and which of the three it
//! was is part of the result, to be told. A unit that is given for a file that states another one is refused: one of the
//! two is wrong.

use std::fmt;
use torse_algebra::Rational;
use torse_algebra::rational::ratio;

/// A unit of length: a name, and how many millimetres it is.
#[derive(Debug, Clone, PartialEq)]
pub struct LengthUnit {
    name: String,
    millimetres: Rational,
}

impl LengthUnit {
    /// A unit of so many millimetres; `None` unless the number is positive.
    #[must_use]
    pub fn new(name: &str, millimetres: Rational) -> Option<Self> {
        (millimetres > Rational::default()).then(|| Self {
            name: name.to_owned(),
            millimetres,
        })
    }

    /// The unit of this name, as people, tables and SVG write it: `mm`, `cm`, `m`, `in`, `ft`, `pt`, `pc`, `px`, `um`,
    /// `km`, `yd`, `mi`, `mil`.
    ///
    /// A pixel is the 96th of an inch, a point the 72nd, as in CSS.
    ///
    /// ```
    /// use torse_algebra::rational::ratio;
    /// use torse_exchange::LengthUnit;
    /// assert_eq!(LengthUnit::named("in").map(|u| u.millimetres().clone()), ratio(127, 5));
    /// assert_eq!(LengthUnit::named("ell"), None);
    /// ```
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        let (short, n, d) = match name.trim().to_ascii_lowercase().as_str() {
            "mm" | "millimetre" | "millimeter" | "millimetres" | "millimeters" => ("mm", 1, 1),
            "cm" | "centimetre" | "centimeter" | "centimetres" | "centimeters" => ("cm", 10, 1),
            "dm" => ("dm", 100, 1),
            "m" | "metre" | "meter" | "metres" | "meters" => ("m", 1000, 1),
            "km" => ("km", 1_000_000, 1),
            "um" | "\u{b5}m" | "\u{3bc}m" | "micron" => ("um", 1, 1000),
            "in" | "inch" | "inches" | "\"" => ("in", 127, 5),
            "ft" | "foot" | "feet" | "'" => ("ft", 1524, 5),
            "yd" | "yard" => ("yd", 4572, 5),
            "mi" | "mile" => ("mi", 1_609_344, 1),
            "mil" => ("mil", 127, 5000),
            "pt" => ("pt", 127, 360),
            "pc" => ("pc", 127, 30),
            "px" => ("px", 127, 480),
            "q" => ("q", 1, 4),
            _ => return None,
        };
        Self::new(short, ratio(n, d)?)
    }

    /// Millimetres.
    #[must_use]
    pub fn millimetre() -> Self {
        Self {
            name: "mm".to_owned(),
            millimetres: Rational::from(1),
        }
    }

    /// The name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// How many millimetres it is.
    #[must_use]
    pub fn millimetres(&self) -> &Rational {
        &self.millimetres
    }
}

/// The units whose names would read badly in a sentence, and their words there.
const WORDS: [(&str, &str); 4] = [
    ("in", "inches"),
    ("ft", "feet"),
    ("yd", "yards"),
    ("mi", "miles"),
];

/// Where the unit of a file comes from.
#[derive(Debug, Clone, PartialEq)]
pub enum UnitSource {
    /// The file states it.
    Stated(LengthUnit),
    /// The file states none; the caller gave it.
    Given(LengthUnit),
    /// The file states none and none was given: millimetres.
    Assumed,
}

impl UnitSource {
    /// The unit.
    #[must_use]
    pub fn unit(&self) -> LengthUnit {
        match self {
            Self::Stated(unit) | Self::Given(unit) => unit.clone(),
            Self::Assumed => LengthUnit::millimetre(),
        }
    }

    /// What stands above lengths that are given in millimetres, whatever the file has.
    ///
    /// ```
    /// use torse_exchange::{LengthUnit, UnitSource};
    /// let inches = LengthUnit::named("in").ok_or("no unit")?;
    /// assert_eq!(
    ///     UnitSource::Stated(inches).above_millimetres(),
    ///     "lengths of the file in inches, stated by the file; lengths below in mm"
    /// );
    /// assert_eq!(UnitSource::Assumed.above_millimetres(), "lengths in mm, assumed: the file states no unit");
    /// # Ok::<(), &str>(())
    /// ```
    #[must_use]
    pub fn above_millimetres(&self) -> String {
        if *self.unit().millimetres() == Rational::from(1) {
            format!("lengths in {self}")
        } else {
            format!(
                "lengths of the file in {}; lengths below in mm",
                self.words()
            )
        }
    }

    /// The unit as a word of a sentence, and who says so: `inches, stated by the file`.
    #[must_use]
    pub fn words(&self) -> String {
        let unit = self.unit();
        let known = WORDS.iter().find(|(name, _)| *name == unit.name);
        let source = self.to_string();
        match (known, source.strip_prefix(&unit.name)) {
            (Some((_, words)), Some(rest)) => format!("{words}{rest}"),
            _ => source,
        }
    }

    /// What holds for a file that states this unit, or none, for a caller that gives that one, or none; `None` where
    /// they contradict each other.
    #[must_use]
    pub fn agree(stated: Option<LengthUnit>, given: Option<&LengthUnit>) -> Option<Self> {
        match (stated, given) {
            (Some(stated), Some(given)) if stated.millimetres != given.millimetres => None,
            (Some(stated), _) => Some(Self::Stated(stated)),
            (None, Some(given)) => Some(Self::Given(given.clone())),
            (None, None) => Some(Self::Assumed),
        }
    }
}

impl fmt::Display for UnitSource {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Stated(unit) => write!(f, "{}, stated by the file", unit.name),
            Self::Given(unit) => write!(f, "{}, as given: the file states no unit", unit.name),
            Self::Assumed => f.write_str("mm, assumed: the file states no unit"),
        }
    }
}
