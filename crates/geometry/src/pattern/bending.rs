//! Thickness: where the neutral axis runs and what bending allows.
//!
//! A bent sheet is stretched outside and squeezed inside; in between, at the share `K` of the thickness from the
//! inside (the *K-factor*, 0.3 to 0.5 in practice), it keeps its length. With inside radius `r`, thickness `t` and
//! bend angle `beta`
//!
//! ```text
//! bend allowance  beta (r + K t)               length of the neutral axis in the bend
//! setback         (r + t) tan(beta/2)          from the tangent point to the outer corner
//! bend deduction  2 setback - allowance        what the flat length falls short of the two outer flanges
//! outer strain    (1 - K) t/(r + K t)
//! ```
//!
//! A designed surface is taken as the middle of the sheet: its radius is `r + t/2`, and a strip across the rulings is
//! `beta (K - 1/2) t` longer or shorter on the neutral axis than on the pattern.

use super::error::positive;
use super::error::{PatternError, PatternResult};
use super::flat::FlatPattern;

/// Angles that differ from a half turn by no more, as a share, are half turns.
const HALF_TURN: f64 = 1e-9;

/// A sheet to bend: thickness and K-factor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BendingSheet {
    thickness: f64,
    k_factor: f64,
}

impl BendingSheet {
    /// A sheet of this thickness (a length) and K-factor.
    ///
    /// # Errors
    /// [`PatternError::OutOfRange`] unless the thickness is positive and the K-factor between 0 and 1.
    ///
    /// ```
    /// use torse_geometry::pattern::BendingSheet;
    /// let sheet = BendingSheet::new(2.0, 0.4)?;
    /// let right = std::f64::consts::FRAC_PI_2;
    /// // A right angle over an inside radius of 3: the neutral axis has the radius 3.8.
    /// assert!((sheet.bend_allowance(right, 3.0) - right * 3.8).abs() < 1e-15);
    /// let deduction = sheet.bend_deduction(right, 3.0).ok_or("no corner")?;
    /// assert!((deduction - (10.0 - right * 3.8)).abs() < 1e-14);
    /// assert_eq!(sheet.bend_deduction(2.0 * right, 3.0), None);
    /// assert!(BendingSheet::new(-1.0, 0.4).is_err());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(thickness: f64, k_factor: f64) -> PatternResult<Self> {
        positive("thickness", thickness)?;
        if !(0.0..=1.0).contains(&k_factor) {
            return Err(PatternError::OutOfRange {
                name: "K-factor",
                value: k_factor,
                range: "[0, 1]",
            });
        }
        Ok(Self {
            thickness,
            k_factor,
        })
    }

    /// The thickness.
    #[must_use]
    pub fn thickness(&self) -> f64 {
        self.thickness
    }

    /// The K-factor.
    #[must_use]
    pub fn k_factor(&self) -> f64 {
        self.k_factor
    }

    /// The length of the neutral axis in a bend by `angle` (radians, of either sign) over this inside radius.
    #[must_use]
    pub fn bend_allowance(&self, angle: f64, inside_radius: f64) -> f64 {
        angle.abs() * (inside_radius + self.k_factor * self.thickness)
    }

    /// The distance from the tangent point of a bend to its outer corner; `None` from 180 degrees on, where the outer faces
    /// meet in no corner.
    #[must_use]
    pub fn setback(&self, angle: f64, inside_radius: f64) -> Option<f64> {
        // An angle that is a half turn but for rounding is one.
        let has_corner = angle.abs() < std::f64::consts::PI * (1.0 - HALF_TURN);
        has_corner.then(|| libm::tan(0.5 * angle.abs()) * (inside_radius + self.thickness))
    }

    /// What the flat length falls short of the sum of the two outer flanges; `None` as of [`BendingSheet::setback`].
    #[must_use]
    pub fn bend_deduction(&self, angle: f64, inside_radius: f64) -> Option<f64> {
        let setback = self.setback(angle, inside_radius)?;
        Some(2.0 * setback - self.bend_allowance(angle, inside_radius))
    }

    /// The inside radius of a sheet whose middle is bent to this radius; negative when it cannot be.
    #[must_use]
    pub fn inside_radius(&self, radius: f64) -> f64 {
        radius - 0.5 * self.thickness
    }

    /// By how much the neutral axis of a bend is longer than the middle of the sheet: negative for a K-factor below
    /// one half.
    #[must_use]
    pub fn growth(&self, angle: f64) -> f64 {
        angle.abs() * (self.k_factor - 0.5) * self.thickness
    }

    /// The strain of the outer face of a sheet whose middle is bent to this radius.
    #[must_use]
    pub fn outer_strain(&self, radius: f64) -> f64 {
        let neutral = self.inside_radius(radius) + self.k_factor * self.thickness;
        (1.0 - self.k_factor) * self.thickness / neutral
    }
}

/// What the press needs to know about one ruling.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bend {
    /// The index of the ruling in [`FlatPattern::rulings`].
    pub ruling: usize,
    /// The angle in radians, positive towards the viewer.
    pub angle: f64,
    /// The smallest radius of the middle of the sheet along the ruling.
    pub radius: f64,
    /// The radius of the inside face there.
    pub inside_radius: f64,
    /// The length of the neutral axis in the bend, at that radius.
    pub allowance: f64,
    /// What has to be added to the pattern across this ruling, because the neutral axis is not the middle.
    pub growth: f64,
    /// The strain of the outer face at that radius.
    pub outer_strain: f64,
}

/// The bends of a pattern, ruling by ruling; flat rulings are left out.
#[must_use]
pub fn bends(flat: &FlatPattern, sheet: &BendingSheet) -> Vec<Bend> {
    let rulings = flat.rulings().iter().enumerate();
    rulings
        .filter(|(_, r)| r.bend != 0.0)
        .map(|(ruling, r)| {
            let inside_radius = sheet.inside_radius(r.radius);
            Bend {
                ruling,
                angle: r.bend,
                radius: r.radius,
                inside_radius,
                allowance: sheet.bend_allowance(r.bend, inside_radius),
                growth: sheet.growth(r.bend),
                outer_strain: sheet.outer_strain(r.radius),
            }
        })
        .collect()
}

/// Whether a sheet can be bent to a pattern: the inside radius is nowhere smaller than `least` times the thickness
/// (a property of the material: 0 for soft copper, 1 for mild steel, 3 and more for hard aluminium). A chain with
/// an edge at a joint has a radius there that the press makes; it is not looked at.
///
/// ```
/// use torse_geometry::pattern::{BendingSheet, is_bendable, unroll};
/// use torse_geometry::{RuledSurface, curve::ellipse_arc};
/// let ring = |z: f64| ellipse_arc(&[0.0, 0.0, z], &[2.0, 0.0, z], &[0.0, 2.0, z]);
/// let flat = unroll(&RuledSurface::new(ring(0.0)?, ring(3.0)?), 17, 1e-6)?;
/// assert!(is_bendable(&flat, &BendingSheet::new(1.0, 0.4)?, 1.0));
/// assert!(!is_bendable(&flat, &BendingSheet::new(1.5, 0.4)?, 1.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn is_bendable(flat: &FlatPattern, sheet: &BendingSheet, least: f64) -> bool {
    sheet.inside_radius(flat.smallest_radius()) >= least * sheet.thickness()
}
