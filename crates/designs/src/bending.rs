//! Where the neutral line of a bent sheet runs, and which of its surfaces a design describes.

use crate::rounding::settled;
use std::f64::consts::LOG10_2;

/// Where the neutral line of a bend runs: its distance from the inside as a share of the thickness, the K-factor.
#[derive(Debug, Clone, PartialEq)]
pub enum NeutralLine {
    /// One K-factor for all bends.
    Constant(f64),
    /// Pairs of inside radius over thickness, growing, and K-factor, with straight lines in between.
    Table(Vec<[f64; 2]>),
    /// The correction factor of DIN 6935: `k = 0.65 + lg(r/t)/2`, at most 1, of half the thickness.
    Din6935,
}

impl NeutralLine {
    /// Returns the K-factor of a bend with this inside radius over the thickness; `None` where a table or the standard
    /// says nothing: beside the table, and for radii so small that the neutral line of the standard would leave the
    /// sheet.
    ///
    /// ```
    /// use torse_designs::NeutralLine;
    /// // DIN 6935: k = 0.65 for r = t, 1 from r = 5 t, both of half the thickness.
    /// assert_eq!(NeutralLine::Din6935.k_factor(1.0), Some(0.325));
    /// assert_eq!(NeutralLine::Din6935.k_factor(8.0), Some(0.5));
    /// let table = NeutralLine::Table(vec![[1.0, 0.35], [3.0, 0.45]]);
    /// assert_eq!(table.k_factor(2.0), Some(0.4));
    /// assert_eq!(table.k_factor(0.5), None);
    /// // 0.6 mm over 0.2 mm is 3, and 2.9999999999999996 in f64: the first row is met.
    /// assert!(0.6 / 0.2 < 3.0 && NeutralLine::Table(vec![[3.0, 0.35], [4.0, 0.45]]).k_factor(0.6 / 0.2) == Some(0.35));
    /// ```
    #[must_use]
    pub fn k_factor(&self, ratio: f64) -> Option<f64> {
        match self {
            Self::Constant(k) => Some(*k),
            Self::Table(rows) => rows.windows(2).find_map(|pair| {
                let [[r, k], [s, l]] = [pair[0], pair[1]];
                let ratio = settled(settled(ratio, r, 1.0), s, 1.0);
                let inside = (r..=s).contains(&ratio);
                inside.then(|| k + (l - k) * (ratio - r) / (s - r))
            }),
            Self::Din6935 => {
                let lg = libm::log2(ratio) * LOG10_2;
                let k = (0.65 + 0.5 * lg).min(1.0);
                (ratio > 0.0 && k >= 0.0).then_some(0.5 * k)
            }
        }
    }
}

/// The surface of the sheet that a design describes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DesignedSurface {
    /// The face at the inside of every bend.
    Inside,
    /// The middle of the sheet.
    Middle,
    /// The face at the outside of every bend.
    Outside,
}

impl DesignedSurface {
    /// All with their names in files.
    pub const ALL: [(&'static str, Self); 3] = [
        (Self::Inside.name(), Self::Inside),
        (Self::Middle.name(), Self::Middle),
        (Self::Outside.name(), Self::Outside),
    ];

    /// Its name in files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Inside => "inside",
            Self::Middle => "middle",
            Self::Outside => "outside",
        }
    }

    /// Returns how far the surface is from the inside face of a bend, as a share of the thickness.
    #[must_use]
    pub fn share(self) -> f64 {
        match self {
            Self::Inside => 0.0,
            Self::Middle => 0.5,
            Self::Outside => 1.0,
        }
    }
}

/// How the blanks of a design are found.
#[derive(Debug, Clone, PartialEq)]
pub struct Bending {
    /// Where the neutral line of a bend runs.
    pub neutral: NeutralLine,
    /// Which surface of the sheet the design describes.
    pub surface: DesignedSurface,
}

impl Bending {
    /// What holds where a file says nothing.
    pub const USUAL: Self = Self {
        neutral: NeutralLine::Constant(0.5),
        surface: DesignedSurface::Middle,
    };
}
