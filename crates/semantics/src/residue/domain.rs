//! Drawing points of a domain modulo the prime.

use super::Residues;
use super::point::Point;
use crate::domain::Domain;
use crate::domain::constraints::is_equations;
use crate::domain::draft::Draft;
use crate::domain::point::check_sets;
use crate::domain::sort::sorted;
use crate::judge::Judge;
use crate::judgement::Judgement;
use crate::no_value::{Unknown, Work};

/// The result of drawing a point.
pub(crate) enum Drawn<'d, 'a> {
    /// A point of the domain.
    Inside(Point<'d, 'a>),
    /// The draft is not a point of the domain.
    Outside,
    /// Residues cannot decide whether it is.
    Unknown(Unknown),
}

/// Completes a draft to a point of the domain.
pub(crate) fn drawn<'d, 'a>(
    domain: &Domain<'a>,
    draft: &'d Draft<'a>,
    work: &Work,
) -> Drawn<'d, 'a> {
    let not_covered = || {
        let what = "equations that residues do not solve";
        Drawn::Unknown(match work.left() {
            0 => Unknown::Work,
            _ => Unknown::NotCovered { what },
        })
    };
    sorted(domain, draft, work);
    let point = Point::new(draft);
    if point.solve(domain, work).is_none() || !point.is_free(domain) {
        return not_covered();
    }
    // Check the sets first, because that is cheap.
    let declarations = domain.reading.declarations();
    let outside = || {
        draft
            .look(|values| check_sets(declarations, values, false))
            .is_err()
    };
    if outside() {
        return Drawn::Outside;
    }
    let judge = Judge {
        reading: domain.reading,
        values: &|name| point.number(name),
        near: false,
        fails: &|_| false,
        work,
    };
    let (residues, residue) = (Residues { work }, |name: &_| point.residue(name));
    let grounds = judge.evaluators();
    let at = grounds.along(&judge, None, Some((&residues, &residue)));
    let found = domain.hypotheses.iter();
    for tree in found.filter(|tree| !is_equations(declarations, tree)) {
        match at.truth(tree) {
            Judgement::True => {}
            Judgement::False | Judgement::Undefined(_) => return Drawn::Outside,
            Judgement::Undecided => return not_covered(),
            Judgement::Unknown(why) => return Drawn::Unknown(why),
        }
    }
    drop(at);
    if outside() || draft.empty.get() {
        return Drawn::Outside;
    }
    Drawn::Inside(point)
}
