//! What trees say of a point at which core terms have been judged: both were read from one text, so they have to agree.
//!
//! A disagreement is a fault of the elaborator or of one of the two evaluators. What is not decided by one of them is none.

use super::environment::Environment;
use super::evaluate::Evaluator;
use super::judge::{Properties, Reading, Values};
use super::statement::joined;
use crate::arithmetic::Arithmetic;
use crate::domain::point::Point;
use crate::gap::Work;
use crate::judgement::Judgement;
use crate::name::Name;
use crate::real::{Real, Reals};
use crate::residue::{self, Residue, Residues};
use torse_syntax::formula::{Connective, Expr};

/// The precisions that are tried, in bits.
const PRECISIONS: [usize; 2] = [320, 1280];
/// The work that the trees may take at one point: what is beyond it is not decided.
const POINT_WORK: u64 = 1_000_000;

/// What the trees say of a point at which core terms have been judged otherwise.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Second {
    /// The two readings contradict each other.
    Objection(String),
    /// A property of a basis fails, of which the first reading met no failure among its own samples.
    Fails,
    /// A property of a basis fails for one reading alone, and it is a premise: nothing is decided.
    Open,
}

/// What the trees make of a point.
struct Found {
    /// A hypothesis that is false or undefined there, counted from 1.
    outside: Option<(usize, Judgement)>,
    statement: Judgement,
    /// Whether something is not decided.
    is_open: bool,
}

/// An arithmetic and the numbers of a point in it.
type Ground<'e, A> = (&'e A, Values<'e, <A as Arithmetic>::Number>);

/// What the trees say otherwise of a point of the domain at which the statement is this.
pub(crate) fn objection(
    reading: &Reading<'_>,
    judgement: &Judgement,
    number: &dyn Fn(&Name) -> Option<Real>,
    near: bool,
    work: &Work,
) -> Option<Second> {
    let number = |name: &Name| number(name).or_else(|| reading.free(name));
    let values = Values {
        number: &number,
        near,
        fails: &|_| true,
    };
    for bits in PRECISIONS {
        let work = work.apart(POINT_WORK);
        let reals = Reals { bits, work: &work };
        let found = judged::<Reals<'_>, Reals<'_>>(reading, (&reals, values), None);
        let objection = found.against(judgement, reading.properties());
        if objection.is_some() || !found.is_open {
            return objection;
        }
    }
    None
}

/// The same of a point modulo the prime; what residues do not decide is asked of the numbers themselves, part by part.
pub(crate) fn objection_modulo_prime(
    reading: &Reading<'_>,
    judgement: &Judgement,
    point: &residue::Point<'_, '_>,
    work: &Work,
) -> Option<Second> {
    let work = work.apart(POINT_WORK);
    let [bits, _] = PRECISIONS;
    let (residues, reals) = (Residues { work: &work }, Reals { bits, work: &work });
    let residue = |name: &Name| {
        let free = || reading.free(name).map(|number| Residue::from(&number));
        point.residue(name).or_else(free)
    };
    let number = |name: &Name| point.number(name).or_else(|| reading.free(name));
    let modulo = Values {
        number: &residue,
        near: false,
        fails: &|_| true,
    };
    let exact = Values {
        number: &number,
        near: false,
        fails: &|_| true,
    };
    let found = judged(reading, (&residues, modulo), Some((&reals, exact)));
    found.against(judgement, reading.properties())
}

/// What the trees make of a point, in one arithmetic, and where that does not decide a part in another one.
fn judged<A: Arithmetic, B: Arithmetic>(
    reading: &Reading<'_>,
    first: Ground<'_, A>,
    second: Option<Ground<'_, B>>,
) -> Found {
    let at = reading.at(first.0, first.1);
    let other = second.map(|(arithmetic, values)| reading.at(arithmetic, values));
    let mut is_open = false;
    let mut outside = None;
    for (number, tree) in reading.assumptions().enumerate() {
        match truth(tree, &at, other.as_ref()) {
            Judgement::True => {}
            judgement @ (Judgement::False | Judgement::Undefined(_)) => {
                outside.get_or_insert((number + 1, judgement));
            }
            Judgement::Undecided | Judgement::Unknown(_) => is_open = true,
        }
    }
    // In hypotheses the given equations are not put in.
    let given = reading.given();
    let (at, other) = match given {
        None => (at, other),
        Some(_) => {
            let other = second.map(|(arithmetic, values)| reading.at(arithmetic, values));
            let other = other.map(|other| other.along(given.clone()));
            (reading.at(first.0, first.1).along(given), other)
        }
    };
    let statement = match reading.seeks() {
        true => match (reading.judged(&at), &other) {
            (Judgement::Undecided | Judgement::Unknown(_), Some(other)) => reading.judged(other),
            (judgement, _) => judgement,
        },
        false => {
            let parts = reading.conjuncts().into_iter();
            let parts = parts.map(|part| truth(part, &at, other.as_ref()));
            parts.fold(Judgement::True, |all, part| {
                joined(Connective::And, all, part)
            })
        }
    };
    match &statement {
        Judgement::True => reading.look(&at),
        Judgement::Undecided | Judgement::Unknown(_) => {
            reading.note_open(&statement);
            is_open = true;
        }
        Judgement::False | Judgement::Undefined(_) => {}
    }
    Found {
        outside,
        statement,
        is_open,
    }
}

/// What a statement is at a point, in the first arithmetic that decides it.
fn truth<'s, A: Arithmetic, B: Arithmetic>(
    tree: &'s Expr,
    at: &Evaluator<'s, '_, A>,
    other: Option<&Evaluator<'s, '_, B>>,
) -> Judgement {
    match (at.truth(tree, &Environment::outermost()), other) {
        (Judgement::Undecided | Judgement::Unknown(_), Some(other)) => {
            other.truth(tree, &Environment::outermost())
        }
        (judgement, _) => judgement,
    }
}

impl Found {
    /// What is said otherwise of a point of the domain at which the statement is this.
    fn against(&self, judgement: &Judgement, properties: Properties) -> Option<Second> {
        if let Some((number, outside)) = &self.outside {
            let objection = format!("hypothesis {number} is {outside}, read anew");
            return Some(Second::Objection(objection));
        }
        let is_open = |one: &Judgement| matches!(one, Judgement::Undecided | Judgement::Unknown(_));
        let differ = !is_open(&self.statement)
            && !is_open(judgement)
            && std::mem::discriminant(&self.statement) != std::mem::discriminant(judgement);
        let found = &self.statement;
        let sampled = |one: &Judgement| matches!(one, Judgement::True | Judgement::False);
        if differ && sampled(found) && sampled(judgement) {
            // That a property fails is seen at a sample, that it holds is not: each reading has samples of its own.
            match properties {
                Properties::None => {}
                Properties::Concluded => {
                    return (*found == Judgement::False).then_some(Second::Fails);
                }
                Properties::Premised => return Some(Second::Open),
            }
        }
        differ.then(|| {
            let objection = format!("the statement is {found}, read anew, and not {judgement}");
            Second::Objection(objection)
        })
    }
}

/// What the trees say otherwise of a point that refutes a statement by its core terms: that it is outside of the domain, or that
/// the statement is not false there.
#[must_use]
pub fn objection_at(reading: &Reading<'_>, point: &Point) -> Option<String> {
    let work = Work::new(0);
    let number = |name: &Name| point.values.get(name).cloned();
    match objection(reading, &Judgement::False, &number, point.near, &work)? {
        Second::Objection(objection) => Some(objection),
        Second::Fails | Second::Open => None,
    }
}
