//! What is judged of a patch whose first or last ruling, or apex, is special by its kind.

use torse_geometry::Rails;
use torse_geometry::prelude::{Construction, GeometryError, Sheet};
use torse_geometry::surface::RulingEnd;
use torse_geometry::vector::norm;

/// Of a patch that begins or ends in a special ruling, this share of the parameter is left out of what is judged.
const END: f64 = 1.0 / 4096.0;

/// An edge whose speed is this share of that of the other one stands still.
pub(super) const STILL: f64 = 1e-9;

/// What is judged of a patch: all of it but its apex and special rulings at its ends.
pub(super) struct Judged {
    pub sheet: Sheet,
    /// What is special about the ends, in words.
    pub notes: Vec<String>,
    /// Whether something was left out at an end, and what is proved of it all the same.
    pub ends: EndsJudged,
}

/// What is known of the ends that were left out.
pub(super) enum EndsJudged {
    /// None was.
    All,
    /// They are regular but for the special rulings, and tangent planes turn along a ruling by this angle at most, in
    /// radians.
    Proved(f64),
    /// Nothing.
    Open,
}

/// Returns the sheet whose regularity is that of a patch without its apex and without the rulings at its ends that have
/// no normal by their kind; these ends are proved apart, where there is a budget for proofs.
pub(super) fn judged(sheet: &Sheet, proofs: bool) -> Result<Judged, GeometryError> {
    let mut notes = Vec::new();
    let whole = sheet.away_from_apex().unwrap_or_else(|| sheet.clone());
    let rulings = Rails::<f64>::end_kinds(sheet).rulings();
    let mut ends = EndsJudged::All;
    let mut cut = [false; 2];
    for (end, ruling) in rulings.into_iter().enumerate() {
        match ruling {
            RulingEnd::Ordinary => {}
            RulingEnd::Tip => notes.push(format!("its edges meet in a point at u = {end}")),
            RulingEnd::Still => notes.push(format!(
                "both edges stand still at u = {end}, where control points coincide: the radius may fall to nothing there"
            )),
        }
        let special = ruling != RulingEnd::Ordinary;
        let pivot = pivot(sheet, [0.0, 1.0][end])?;
        if let Some(edge) = pivot {
            notes.push(format!(
                "edge {edge} stands still at u = {end}: the edge of regression touches it there, and the radius falls to nothing"
            ));
        }
        cut[end] = special || pivot.is_some();
        if !cut[end] {
            continue;
        }
        let proved = if proofs && pivot.is_none() {
            whole.regular_end(end == 1, END)?
        } else {
            None
        };
        ends = match (ends, proved) {
            (EndsJudged::Open, _) | (_, None) => EndsJudged::Open,
            (EndsJudged::All, Some(twist)) => EndsJudged::Proved(twist),
            (EndsJudged::Proved(known), Some(twist)) => EndsJudged::Proved(known.max(twist)),
        };
    }
    let share = |cut: bool| if cut { END } else { 0.0 };
    let [from, to] = [share(cut[0]), 1.0 - share(cut[1])];
    let sheet = if [from, to] == [0.0, 1.0] {
        whole
    } else {
        whole.part(from, to)?
    };
    Ok(Judged { sheet, notes, ends })
}

/// Of a developable between two curves the edge, 1 or 2, that has no speed at its first or last ruling: that of a curve
/// that begins without curvature.
fn pivot(sheet: &Sheet, u: f64) -> Result<Option<usize>, GeometryError> {
    let whole = match sheet.construction() {
        Construction::Part(part) => part.whole(),
        _ => sheet,
    };
    if !matches!(whole.construction(), Construction::Connecting(_)) {
        return Ok(None);
    }
    let [first, second] = sheet.ends_and_slopes(&u)?.map(|[_, slope]| norm(&slope));
    Ok(if first <= STILL * second {
        Some(1)
    } else if second <= STILL * first {
        Some(2)
    } else {
        None
    })
}
