//! Points of a domain modulo the prime.

use super::judge::Judge;
use super::point::Point;
use crate::domain::constraints::is_equations;
use crate::domain::draft::Draft;
use crate::domain::point::check_sets;
use crate::domain::sort::sorted;
use crate::gap::{Unknown, Work};
use crate::judgement::Judgement;
use std::collections::BTreeMap;
use torse_core::Claim;

/// What came of drawing a point.
pub(crate) enum Drawn<'d, 'a> {
    /// A point of the domain.
    Inside(Point<'d, 'a>),
    /// No point of the domain.
    Outside,
    /// Whether it is one cannot be told by residues.
    Unknown(Unknown),
}

/// Completes a draft to a point of the domain.
pub(crate) fn drawn<'d, 'a>(claim: &Claim, draft: &'d Draft<'a>, work: &Work) -> Drawn<'d, 'a> {
    let not_covered = || {
        let what = "equations that residues do not solve";
        Drawn::Unknown(match work.left() {
            0 => Unknown::Work,
            _ => Unknown::NotCovered { what },
        })
    };
    sorted(claim, draft, work);
    let point = Point::new(draft);
    if point.solve(claim, work).is_none() || !point.is_free(claim) {
        return not_covered();
    }
    // The sets first: they cost nothing.
    let outside = || draft.look(|values| check_sets(claim, values)).is_err();
    if outside() {
        return Drawn::Outside;
    }
    let judge = Judge {
        claim,
        point: &point,
        denied: &BTreeMap::new(),
        work,
    };
    let hypotheses = claim.hypotheses.iter().map(|h| &h.statement);
    for hypothesis in hypotheses.filter(|h| !is_equations(h)) {
        match judge.hypothesis(hypothesis) {
            Judgement::True => {}
            Judgement::False | Judgement::Undefined(_) => return Drawn::Outside,
            Judgement::Undecided => return not_covered(),
            Judgement::Unknown(why) => return Drawn::Unknown(why),
        }
    }
    if outside() || draft.empty.get() {
        return Drawn::Outside;
    }
    Drawn::Inside(point)
}
