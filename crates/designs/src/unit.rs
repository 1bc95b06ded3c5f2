//! Units of length.

use torse_numbers::rational::{Rational, ratio};

/// The unit of the lengths of a design file. Everything that leaves a design is in millimetres.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DesignUnit {
    /// Millimetres.
    Millimetre,
    /// Centimetres.
    Centimetre,
    /// Metres.
    Metre,
    /// Inches of 25.4 mm.
    Inch,
    /// Feet of 304.8 mm.
    Foot,
}

impl DesignUnit {
    /// All units with their names in files.
    pub const ALL: [(&'static str, Self); 5] = [
        ("mm", Self::Millimetre),
        ("cm", Self::Centimetre),
        ("m", Self::Metre),
        ("in", Self::Inch),
        ("ft", Self::Foot),
    ];

    /// Returns the unit of this name.
    ///
    /// ```
    /// use torse_designs::DesignUnit;
    /// assert_eq!(DesignUnit::named("in"), Some(DesignUnit::Inch));
    /// assert_eq!(DesignUnit::named("inch"), None);
    /// ```
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        let found = Self::ALL.iter().find(|(known, _)| *known == name);
        found.map(|(_, unit)| *unit)
    }

    /// Returns the name.
    #[must_use]
    pub fn name(self) -> &'static str {
        let found = Self::ALL.iter().find(|(_, unit)| *unit == self);
        found.map_or("mm", |(name, _)| name)
    }

    /// Returns how many millimetres it is, exactly.
    #[must_use]
    pub fn millimetres(self) -> Rational {
        let (n, d) = match self {
            Self::Millimetre => (1, 1),
            Self::Centimetre => (10, 1),
            Self::Metre => (1000, 1),
            Self::Inch => (127, 5),
            Self::Foot => (1524, 5),
        };
        ratio(n, d).unwrap_or_default()
    }
}
