//! Whether a statement is true at a point.
//!
//! Every part is evaluated, so that a statement with an undefined part is undefined. Falsity is proved: two balls that
//! do not meet hold different numbers. Truth of an order relation is proved likewise, and so is equality of exact
//! numbers. Enclosed numbers are called equal if their difference is enclosed within `2^-128` times the larger of 1
//! and the sides: for two formulas that are no identity an agreement that no chance explains, but no proof.

use crate::arithmetic::Arithmetic;
use crate::evaluate::Evaluator;
use crate::family;
use crate::gap::{Gap, Unknown, Work};
use crate::judgement::Judgement;
use crate::name::Name;
use crate::real::{Real, Reals};
use std::cmp::Ordering;
use std::collections::BTreeMap;
use torse_core::{Claim, Printed, Statement, Term};
use torse_numbers::{Ball, Integer, Rational};
use torse_syntax::formula::{Connective, Relation};

/// The precisions that are tried, in bits.
const PRECISIONS: [usize; 2] = [320, 1280];
/// Equal enclosures differ by at most two to the minus this, relative to the larger of 1 and the sides.
const AGREEMENT_BITS: usize = 128;
/// At a point that satisfies its hypotheses only nearly, different numbers differ by at least two to the minus this.
const SLACK_BITS: usize = 64;

/// A point at which statements of a claim are judged.
pub(crate) struct Judge<'a> {
    pub claim: &'a Claim,
    /// The numbers of the point.
    pub values: &'a dyn Fn(&Name) -> Option<Real>,
    /// Whether the numbers satisfy the equations of the domain only nearly.
    pub near: bool,
    /// The denials `not p` that are known to be true, because p fails somewhere: by the address of p.
    pub denied: &'a BTreeMap<usize, ()>,
    pub work: &'a Work,
}

/// The key of a denied statement.
pub(crate) fn address(statement: &Statement) -> usize {
    std::ptr::from_ref(statement).addr()
}

impl Judge<'_> {
    /// Judges a statement about the domain, with more precision where that is needed.
    pub fn judge(&self, statement: &Statement) -> Judgement {
        self.judged(statement, Some(self.claim))
    }

    /// Judges a hypothesis: what it says of coefficients is not read with the solutions of the hypotheses put in.
    pub fn hypothesis(&self, statement: &Statement) -> Judgement {
        self.judged(statement, None)
    }

    fn judged(&self, statement: &Statement, solved: Option<&Claim>) -> Judgement {
        let mut last = Judgement::Undecided;
        for bits in PRECISIONS {
            let reals = Reals {
                bits,
                work: self.work,
            };
            let at = Evaluator::new(&reals, self.values).of(solved);
            last = self.statement(statement, &at);
            if !matches!(
                last,
                Judgement::Undecided | Judgement::Unknown(Unknown::Precision)
            ) {
                break;
            }
        }
        last
    }

    fn statement(&self, statement: &Statement, at: &Evaluator<'_, Reals<'_>>) -> Judgement {
        match statement {
            Statement::Compare {
                relation,
                left,
                right,
            } => {
                let found = self.compare(*relation, left, right, at);
                match found.unwrap_or_else(Judgement::from) {
                    // Enclosures do not tell equal exponentials apart; exponents are told apart.
                    Judgement::Undecided => {
                        let of_exponents = statement.of_exponents();
                        let judged = of_exponents.map(|said| self.statement(&said, at));
                        judged.unwrap_or(Judgement::Undecided)
                    }
                    found => found,
                }
            }
            Statement::Agrees { value, printed, .. } => {
                agrees(value, printed, at).unwrap_or_else(Judgement::from)
            }
            Statement::Family(property, family) => {
                family::judge(*property, family, self.claim, at).unwrap_or_else(Judgement::from)
            }
            Statement::Join(..) => joined(statement, &|part| self.statement(part, at)),
            Statement::Not(inner) => {
                if self.denied.contains_key(&address(inner)) {
                    return Judgement::True;
                }
                match self.statement(inner, at) {
                    // One point where p fails makes `not p` true at every point.
                    Judgement::False => Judgement::True,
                    _ => Judgement::Unknown(Unknown::NotCovered {
                        what: "a denial without a point where the denied statement fails",
                    }),
                }
            }
        }
    }

    fn compare(
        &self,
        relation: Relation,
        left: &Term,
        right: &Term,
        at: &Evaluator<'_, Reals<'_>>,
    ) -> Result<Judgement, Gap> {
        let (left, right) = (at.value(left)?, at.value(right)?);
        let reals = at.arithmetic;
        let mut signs = vec![];
        for (x, y) in left.pairs(&right, reals)? {
            let (Some(x), Some(y)) = (x.as_number(), y.as_number()) else {
                return Err(Gap::shape("an infinitesimal to a comparison"));
            };
            signs.push(self.sign(x, y, reals)?);
        }
        let equal = || {
            let each = signs.iter().map(|sign| match sign {
                Sign::Known(order) => Some(order.is_eq()),
                Sign::Near => Some(true),
                Sign::Open => None,
            });
            each.fold(Some(true), both)
        };
        let ordered = |wanted: fn(Ordering) -> bool| match signs.as_slice() {
            [Sign::Known(order)] => Ok(Some(wanted(*order))),
            [_] => Ok(None),
            _ => Err(Gap::shape("an order of vectors")),
        };
        Ok(Judgement::of(match relation {
            Relation::Equal => equal(),
            Relation::Different => equal().map(|e| !e),
            Relation::Less => ordered(Ordering::is_lt)?,
            Relation::AtMost => ordered(Ordering::is_le)?,
            Relation::Greater => ordered(Ordering::is_gt)?,
            Relation::AtLeast => ordered(Ordering::is_ge)?,
        }))
    }

    /// How x compares with y.
    fn sign(&self, x: &Real, y: &Real, reals: &Reals<'_>) -> Result<Sign, Gap> {
        let gap = reals.minus(x, y)?;
        let size = || {
            let one = Ball::from_rational(&torse_numbers::rational::integer(1), 8);
            let (x, y) = (x.ball(reals.bits).abs(), y.ball(reals.bits).abs());
            one.hull(&x).hull(&y).upper()
        };
        let within = |bits: usize| {
            let bound = size() / Rational::from_integer(Integer::ONE << bits);
            gap.ball(reals.bits).abs().upper() <= bound
        };
        match gap.sign() {
            Some(Ordering::Equal) => Ok(Sign::Known(Ordering::Equal)),
            Some(order) if !self.near => Ok(Sign::Known(order)),
            Some(order) => Ok(if within(AGREEMENT_BITS) {
                Sign::Near
            } else if within(SLACK_BITS) {
                Sign::Open
            } else {
                Sign::Known(order)
            }),
            None if within(AGREEMENT_BITS) => Ok(Sign::Near),
            None => Ok(Sign::Open),
        }
    }
}

/// Judges a statement by its parts that are no conjunctions, alternatives or implications. Long chains are walked without
/// recursion.
pub(crate) fn joined(statement: &Statement, judge: &dyn Fn(&Statement) -> Judgement) -> Judgement {
    let mut rights = vec![];
    let mut left = statement;
    while let Statement::Join(connective, a, b) = left {
        rights.push((*connective, b));
        left = a;
    }
    let mut all = judge(left);
    while let Some((connective, right)) = rights.pop() {
        let right = joined(right, judge);
        all = all.joined(right, |a, b| match connective {
            Connective::And => both(a, b),
            Connective::Or => both(a.map(|t| !t), b.map(|t| !t)).map(|t| !t),
            Connective::Implies => both(a, b.map(|t| !t)).map(|t| !t),
        });
    }
    all
}

/// How two numbers compare.
enum Sign {
    /// Known.
    Known(Ordering),
    /// Equal as far as one can see.
    Near,
    /// Not known.
    Open,
}

/// Both are true; false as soon as one is false.
fn both(a: Option<bool>, b: Option<bool>) -> Option<bool> {
    match (a, b) {
        (Some(false), _) | (_, Some(false)) => Some(false),
        (Some(true), Some(true)) => Some(true),
        _ => None,
    }
}

/// `agrees`: every entry is its printed number, rounded to as many digits as are printed, or cut off there.
fn agrees(
    value: &Term,
    printed: &[Printed],
    at: &Evaluator<'_, Reals<'_>>,
) -> Result<Judgement, Gap> {
    // An integer among decimals is read with as many digits as the decimal that has the fewest.
    let decimals = printed.iter().filter_map(|p| p.decimals);
    let fewest = decimals.filter(|d| *d > 0).min().unwrap_or(0);
    let mut all = Some(true);
    for (number, printed) in with_printed(value, printed, at)? {
        all = both(all, agrees_with(&number, printed, fewest, at.arithmetic)?);
    }
    Ok(Judgement::of(all))
}

/// The entries of a value, each with the number that is printed for it.
pub(crate) fn with_printed<'p, A: Arithmetic>(
    value: &Term,
    printed: &'p [Printed],
    at: &Evaluator<'_, A>,
) -> Result<Vec<(A::Number, &'p Printed)>, Gap> {
    let value = at.value(value)?;
    let numbers = value.numbers();
    if numbers.len() != printed.len() {
        return Err(Gap::shape("the printed numbers to the value"));
    }
    let pairs = numbers.into_iter().zip(printed);
    pairs
        .map(|(number, printed)| {
            let number = number.as_number().cloned();
            let number = number.ok_or_else(|| Gap::shape("an infinitesimal"))?;
            Ok((number, printed))
        })
        .collect()
}

/// Whether no printed number has decimals: each says exactly what it is.
pub(crate) fn are_integers(printed: &[Printed]) -> bool {
    printed
        .iter()
        .all(|printed| printed.decimals.unwrap_or(0) == 0)
}

fn agrees_with(
    value: &Real,
    printed: &Printed,
    fewest: u32,
    reals: &Reals<'_>,
) -> Result<Option<bool>, Gap> {
    let gap = reals.minus(value, &printed.value.clone().into())?;
    let decimals = printed.decimals.filter(|d| *d > 0).unwrap_or(fewest);
    if decimals == 0 {
        // Integers alone are exact.
        return Ok(gap.sign().map(Ordering::is_eq));
    }
    if usize::try_from(decimals).is_ok_and(|d| d > 4 * reals.bits) {
        return Err(Unknown::Large {
            what: "a number of printed digits",
        }
        .into());
    }
    let unit = Rational::new(
        1.into(),
        Integer::from(10).pow(usize::try_from(decimals).unwrap_or(usize::MAX)),
    );
    let half: Real = (&unit / torse_numbers::rational::integer(2)).into();
    let at_most = |x: &Real, y: &Real| -> Result<Option<bool>, Gap> {
        Ok(reals.minus(x, y)?.sign().map(Ordering::is_le))
    };
    let rounded = both(at_most(&gap, &half)?, at_most(&reals.negated(&half), &gap)?);
    // Cut off: the value lies between the printed number and the next one away from zero.
    let outward = if printed.negative {
        reals.negated(&gap)
    } else {
        gap
    };
    let beyond = outward.sign().map(Ordering::is_ge);
    let below = reals
        .minus(&outward, &unit.into())?
        .sign()
        .map(Ordering::is_lt);
    let cut = both(beyond, below);
    Ok(both(rounded.map(|t| !t), cut.map(|t| !t)).map(|t| !t))
}
