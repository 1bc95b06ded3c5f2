//! Which way two free curves are passed: a curve may be drawn from either of its ends.

use crate::file::reader::{Reader, accepted};
use std::cmp::Ordering;
use std::ops::Range;
use torse_geometry::prelude::{ConnectedSheets, Rail, Sheet};

/// Rulings on which the developables of both directions are measured.
const RULINGS: u32 = 32;

/// The developables between two curves, in the direction that is taken and in the other.
pub(super) struct DirectedSheets {
    /// Those of the direction that is taken, the second curve as it is drawn or from its end to its start.
    pub taken: ConnectedSheets,
    /// Those of the other direction.
    pub other: Option<ConnectedSheets>,
    /// Whether the best of the other direction is regular too.
    pub other_is_regular: bool,
    /// Why the second curve is turned round, in words; nothing where it is passed as it is drawn.
    pub turned: Option<String>,
}

/// How good a direction is, by the developable that is chosen of it.
struct DirectionRank {
    regular: bool,
    /// How much of both curves it uses.
    coverage: f64,
    longest: f64,
}

impl DirectionRank {
    fn of(found: &ConnectedSheets) -> Option<Self> {
        let sheet = found.sheet.as_ref()?;
        let gaps = found.gaps.iter().map(|gap| gap.range[1] - gap.range[0]);
        let lengths = (0..=RULINGS).map(|k| {
            let ends = sheet.ruling(f64::from(k) / f64::from(RULINGS));
            ends.map_or(f64::INFINITY, |[p, q]| {
                torse_geometry::vector::norm(&torse_geometry::vector::sub(&q, &p))
            })
        });
        let certificate = sheet.certify(usize::try_from(RULINGS).unwrap_or(usize::MAX));
        Some(Self {
            regular: certificate.is_ok_and(|found| found.is_regular()),
            coverage: 1.0 - 0.5 * gaps.sum::<f64>(),
            longest: lengths.fold(0.0, f64::max),
        })
    }

    /// Compares as one of several developables is chosen: regular before singular, then what uses most of the curves (to a
    /// thousandth), then what has the shorter rulings; with the reason why this one is better.
    fn against(&self, other: &Self) -> (Ordering, String) {
        let share = |rank: &Self| (rank.coverage * 1e3).round();
        if self.regular != other.regular {
            let reason = "the developable the other way is not regular".to_owned();
            return (self.regular.cmp(&other.regular), reason);
        }
        let order = share(self).total_cmp(&share(other));
        if order.is_ne() {
            let reason = format!(
                "that way {:.1} % of the curves are used, the other way {:.1} %",
                100.0 * self.coverage,
                100.0 * other.coverage
            );
            return (order, reason);
        }
        let reason = format!(
            "that way the longest ruling is {:.4} mm, the other way {:.4} mm",
            self.longest, other.longest
        );
        (other.longest.total_cmp(&self.longest), reason)
    }
}

/// Returns the developables between two curves for both directions of the second, those of the better direction first.
pub(super) fn directed(
    reader: &mut Reader,
    place: &Range<usize>,
    [first, second]: [&Rail; 2],
) -> Option<DirectedSheets> {
    let drawn = Sheet::between(first, second);
    let back = Sheet::between(first, &second.reversed());
    // What is refused in one direction only is none there.
    let (drawn, back) = match (drawn, back) {
        (Ok(drawn), back) => (Some(drawn), back.ok()),
        (Err(_), Ok(back)) => (None, Some(back)),
        (Err(error), Err(_)) => (accepted(reader, place, Err(error)), None),
    };
    let rank = |found: &Option<ConnectedSheets>| found.as_ref().and_then(DirectionRank::of);
    let ranks = (rank(&drawn), rank(&back));
    let turned = match &ranks {
        (None, Some(_)) => Some("the other way there is none".to_owned()),
        (Some(drawn), Some(back)) => {
            let (order, reason) = back.against(drawn);
            order.is_gt().then_some(reason)
        }
        _ => None,
    };
    let is_regular = |rank: &Option<DirectionRank>| rank.as_ref().is_some_and(|rank| rank.regular);
    let (taken, other, other_is_regular) = match turned {
        Some(_) => (back?, drawn, is_regular(&ranks.0)),
        None => match drawn {
            Some(drawn) => (drawn, back, is_regular(&ranks.1)),
            None => (back?, None, false),
        },
    };
    Some(DirectedSheets {
        taken,
        other: other.filter(|found| found.sheet.is_some()),
        other_is_regular,
        turned: turned.map(|reason| {
            format!(
                "curve 2 runs against curve 1: it is passed from its end to its start; {reason}"
            )
        }),
    })
}
