//! What an opening must keep from: the edge of the sheet and other openings.

use super::MarkedPatch;
use super::shape::{Opening, OpeningShape};
use crate::chords::{Chord, chords_within, clearance, mutual_crossing};
use crate::error::DesignError;
use crate::polygon::is_within;
use crate::position::position;

/// The part of the tolerance of an outline by which chords stand for arcs.
const CHORDS: f64 = 0.1;

impl MarkedPatch<'_> {
    /// Refuses an opening that leaves the sheet, or meets one of those before.
    pub fn check(&self, opening: &Opening, before: &[Opening]) -> Result<(), DesignError> {
        let chord = CHORDS * self.design.tolerances.outline;
        let own = opening.shape.chords(chord);
        // Round ones are compared with the outline by their radius, where marks are laid on the pattern.
        if matches!(opening.shape, OpeningShape::Contour(_)) {
            self.check_edge(opening, &own, chord)?;
        }
        for other in before {
            self.check_other(opening, &own, other, chord)?;
        }
        Ok(())
    }

    fn check_edge(&self, opening: &Opening, own: &[Chord], chord: f64) -> Result<(), DesignError> {
        let name = &opening.name;
        let outline = chords_within(self.flat.outline().segments(), chord);
        let crossed = mutual_crossing(own, &outline).or_else(|| {
            let polygon = starts(&outline);
            let mut corners = own.iter().map(|chord| chord[0]);
            corners.find(|corner| !is_within(&polygon, *corner))
        });
        if let Some(at) = crossed {
            let place = self.place(at);
            return Err(self.failed(format!("{name} leaves the sheet near {place}")));
        }
        let (room, at) = clearance(own, &outline);
        if room > 2.0 * chord + opening.error + self.flat.errors().outline {
            return Ok(());
        }
        let place = self.place(at);
        Err(self.failed(format!(
            "{name} comes within {room:.4} mm of the edge of the sheet near {place}"
        )))
    }

    fn check_other(
        &self,
        opening: &Opening,
        own: &[Chord],
        other: &Opening,
        chord: f64,
    ) -> Result<(), DesignError> {
        let (name, their_name) = (&opening.name, &other.name);
        if let (OpeningShape::Round(a, radius), OpeningShape::Round(b, their_radius)) =
            (&opening.shape, &other.shape)
        {
            let apart = libm::hypot(b[0] - a[0], b[1] - a[1]) - their_radius - radius;
            if apart <= 0.0 {
                let overlap = -apart;
                if overlap < 5e-5 {
                    return Err(self.failed(format!("{name} touches {their_name}")));
                }
                return Err(self.failed(format!("{name} overlaps {their_name} by {overlap:.4} mm")));
            }
            return Ok(());
        }
        let theirs = other.shape.chords(chord);
        if let Some(at) = mutual_crossing(own, &theirs) {
            let place = self.place(at);
            return Err(self.failed(format!("{name} meets {their_name} near {place}")));
        }
        let holds = |outer: &[Chord], inner: &[Chord]| {
            let corner = inner.first().map(|chord| chord[0]);
            corner.is_some_and(|corner| is_within(&starts(outer), corner))
        };
        if holds(&theirs, own) || holds(own, &theirs) {
            return Err(self.failed(format!("{name} and {their_name} lie one within the other")));
        }
        let (room, at) = clearance(own, &theirs);
        if room > 2.0 * chord + opening.error + other.error {
            return Ok(());
        }
        let place = self.place(at);
        Err(self.failed(format!(
            "{name} comes within {room:.4} mm of {their_name} near {place}"
        )))
    }

    /// Returns a point of the pattern in words: a place on a patch of the piece, or where it is on the pattern.
    pub fn place(&self, point: [f64; 2]) -> String {
        let [x, y] = point;
        let found = self.flat.locate(point).and_then(|at| {
            let mut patches = self.piece.patches.iter();
            let is_there = |index: &&usize| {
                let patch = self.design.patches.get(**index);
                patch.and_then(|patch| position(self.flat, patch)) == Some(at.piece)
            };
            let patch = self.design.patches.get(*patches.find(is_there)?)?;
            Some(format!("[{:.3}, {:.3}] of `{}`", at.x, at.v, patch.name))
        });
        found.unwrap_or_else(|| format!("({x:.3}, {y:.3}) of the pattern"))
    }
}

/// Returns where chords begin.
fn starts(chords: &[Chord]) -> Vec<[f64; 2]> {
    chords.iter().map(|chord| chord[0]).collect()
}
