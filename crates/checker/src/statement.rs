//! Checks proofs of single statements under their assumptions: equations, order relations, printed decimals.

use super::assumptions::{Compared, Domain};
use super::gap::{CheckError, Unsupported, Wrong};
use super::printed;
use super::quotient::Quotient;
use super::sign::Signs;
use super::variation;
use torse_certificate::enclosure::Enclosure;
use torse_certificate::identity::{Combination, Equations, Identity, Vanishing};
use torse_certificate::order::{Excluded, Order};
use torse_certificate::polynomial::Polynomial;
use torse_certificate::proof::Proof;
use torse_certificate::proof::assumptions::Assumptions;
use torse_certificate::zero_by_sign::{Zero, ZeroBySign};
use torse_core::{FamilyProperty, Statement};
use torse_syntax::formula::Relation;

/// Checks the proof of a single statement.
pub fn check(domain: &Domain<'_>, ground: &Assumptions<Polynomial>) -> Result<(), CheckError> {
    domain.take_apart(&ground.apart, &ground.constraints)?;
    match (&domain.claim.statement, &ground.proof) {
        (
            Statement::Compare {
                relation,
                left,
                right,
            },
            proof,
        ) => {
            if let Proof::Identity(Identity {
                by: Vanishing::Series,
                ..
            }) = proof
            {
                return Err(Unsupported::Construct("series of symbolic degree").into());
            }
            let differences = domain.differences(left, right)?;
            match proof {
                Proof::Identity(_) => identity(domain, *relation, &differences)?,
                Proof::Combination(own) => combination(domain, *relation, &differences, own)?,
                Proof::ZeroBySign(own) => forced(domain, ground, *relation, &differences, own)?,
                Proof::Order(own) => order(domain, ground, *relation, &differences, own)?,
                Proof::Excluded(own) => excluded(domain, *relation, &differences, own)?,
                _ => return Err(Wrong::Kind.into()),
            }
        }
        (Statement::Agrees { value, printed, .. }, Proof::Enclosure(own)) => {
            let values = domain.entries(value)?;
            let numbers = own.entries.iter().map(|entry| &entry.printed);
            if !numbers.eq(printed) {
                return Err(Wrong::Kind.into());
            }
            enclosure(domain, &values, own)?;
        }
        (
            Statement::Family(FamilyProperty::VariationDiminishing(Some(degrees)), family),
            Proof::Wronskians(own),
        ) => variation::check(domain, family, *degrees, own)?,
        (Statement::Family(..), Proof::Nonnegative(_) | Proof::Powers(_)) => {
            return Err(Unsupported::Construct("a property of a basis").into());
        }
        (
            Statement::Join(..),
            Proof::Both(..) | Proof::Alternative { .. } | Proof::Conclusion(_) | Proof::Exists(_),
        ) => {
            return Err(Unsupported::Construct("a statement of several parts at once").into());
        }
        _ => return Err(Wrong::Kind.into()),
    }
    domain.justified()
}

/// Checks that every difference vanishes identically.
fn identity(
    domain: &Domain<'_>,
    relation: Relation,
    differences: &[Quotient],
) -> Result<(), CheckError> {
    if !matches!(
        relation,
        Relation::Equal | Relation::AtLeast | Relation::AtMost
    ) {
        return Err(Wrong::Kind.into());
    }
    for difference in differences {
        if !difference.is_zero(domain.work)? {
            return Err(Wrong::Differs(difference.above.len()).into());
        }
    }
    Ok(())
}

/// Checks that every difference is a combination of equations of the hypotheses.
fn combination(
    domain: &Domain<'_>,
    relation: Relation,
    differences: &[Quotient],
    own: &Combination<Polynomial>,
) -> Result<(), CheckError> {
    if relation != Relation::Equal || own.multipliers.len() != differences.len() {
        return Err(Wrong::Kind.into());
    }
    let (mut used, mut wrong) = (vec![false; own.equations.len()], None);
    for (difference, row) in differences.iter().zip(&own.multipliers) {
        let sum = sum_of_multiples(domain, &own.equations, row, &mut used)?;
        // The numerators are equal up to divisors of terms.
        if !proportional(domain, &difference.above, &sum)? {
            wrong = Some(Wrong::Differs(difference.above.minus(&sum).len()));
        }
    }
    match own.of {
        Equations::Assumed | Equations::Together | Equations::Given => {
            assumed(domain, &own.equations, &used, wrong)
        }
    }
}

/// The sum of the multiples of equations; records which equations are used.
fn sum_of_multiples(
    domain: &Domain<'_>,
    equations: &[Polynomial],
    multipliers: &[Polynomial],
    used: &mut [bool],
) -> Result<Polynomial, CheckError> {
    let mut sum = Polynomial::zero();
    for ((equation, multiplier), used) in equations.iter().zip(multipliers).zip(used) {
        if !multiplier.is_zero() {
            *used = true;
            sum = sum.plus(&domain.work.times(equation, multiplier)?);
        }
    }
    Ok(sum)
}

/// Checks that every equation that is used is one of the hypotheses. If there are several errors, the first is
/// returned.
fn assumed(
    domain: &Domain<'_>,
    equations: &[Polynomial],
    used: &[bool],
    mut wrong: Option<Wrong>,
) -> Result<(), CheckError> {
    let (known, gap) = domain.constraints(domain.groups())?;
    let known: Vec<&Compared> = known
        .iter()
        .filter(|c| c.relation == Relation::Equal)
        .collect();
    for (equation, _) in equations.iter().zip(used).filter(|(_, used)| **used) {
        let mut same = false;
        for known in &known {
            if proportional(domain, &known.difference.above, equation)? {
                domain.note(&known.met);
                same = true;
                break;
            }
        }
        if !same {
            wrong = wrong.or(Some(Wrong::NoEquation));
        }
    }
    match (wrong, gap) {
        (None, _) => Ok(()),
        (Some(Wrong::NoEquation), Some(gap)) => Err(gap.into()),
        (Some(wrong), _) => Err(wrong.into()),
    }
}

/// Checks that every difference is zero by signs.
fn forced(
    domain: &Domain<'_>,
    ground: &Assumptions<Polynomial>,
    relation: Relation,
    differences: &[Quotient],
    own: &ZeroBySign<Polynomial>,
) -> Result<(), CheckError> {
    if relation != Relation::Equal || own.entries.len() != differences.len() {
        return Err(Wrong::Kind.into());
    }
    let work = domain.work;
    let signs = Signs::new(domain, &ground.constraints, domain.groups())?;
    for (difference, zero) in differences.iter().zip(&own.entries) {
        let differs = || CheckError::from(Wrong::Differs(difference.above.len()));
        let fits = match zero {
            Zero::Identically => difference.is_zero(work)?,
            Zero::Between(pair) => {
                let [above, below] = &**pair;
                signs.check(above)?;
                signs.check(below)?;
                let turned = below.polynomial == above.polynomial.negated();
                turned && proportional(domain, &difference.above, &above.polynomial)?
            }
            Zero::Square { root, sign } => {
                signs.check(sign)?;
                let square = work.times(root, root)?;
                let turned = Quotient::from(sign.polynomial.plus(&square)).is_zero(work)?;
                turned && proportional(domain, &difference.above, root)?
            }
            Zero::Product {
                equations,
                multipliers,
            } => {
                if multipliers.len() != equations.len() {
                    return Err(Wrong::Kind.into());
                }
                let mut used = vec![false; equations.len()];
                let sum = sum_of_multiples(domain, equations, multipliers, &mut used)?;
                assumed(domain, equations, &used, None)?;
                proportional(domain, &difference.above, &sum)?
            }
        };
        if !fits {
            return Err(differs());
        }
    }
    Ok(())
}

/// Whether the second polynomial is the first, times or divided by factors that are known to be nonzero.
fn proportional(domain: &Domain<'_>, a: &Polynomial, b: &Polynomial) -> Result<bool, CheckError> {
    let work = domain.work;
    let refined = |p: &Polynomial| p.refined().ok_or(Unsupported::Large);
    let (a, b) = (refined(a)?, refined(b)?);
    if a.is_zero() || b.is_zero() {
        return Ok(a.is_zero() && b.is_zero());
    }
    work.spend(a.len().saturating_mul(b.len()))?;
    for (x, y) in [(&a, &b), (&b, &a)] {
        if let Some(quotient) = x.quotient(y) {
            return Ok(domain.nonzero_here(&quotient)?);
        }
    }
    Ok(false)
}

/// Checks an order relation by signs.
fn order(
    domain: &Domain<'_>,
    ground: &Assumptions<Polynomial>,
    relation: Relation,
    differences: &[Quotient],
    own: &Order<Polynomial>,
) -> Result<(), CheckError> {
    let work = domain.work;
    let (alone, difference) = (differences.len() == 1, differences.get(own.entry));
    let difference = difference.ok_or(Wrong::Kind)?;
    if own.relation != relation || !(alone || relation == Relation::Different) {
        return Err(Wrong::Kind.into());
    }
    // The quotient must be that of the statement.
    let mut below = Polynomial::one();
    for (factor, exponent) in &own.below {
        for _ in 0..*exponent {
            below = work.times(&below, factor)?;
        }
    }
    let left = work.times(&difference.above, &below)?;
    let right = work.times(&own.above, &difference.denominator(work)?)?;
    if !Quotient::from(left.minus(&right)).is_zero(work)? {
        return Err(Wrong::Sign.into());
    }
    let signs = Signs::new(domain, &ground.constraints, domain.groups())?;
    for sign in &own.signs {
        signs.check(sign)?;
    }
    // Each sign must be that of a polynomial or of its negative.
    let turned = |sign: &Polynomial, part: &Polynomial| {
        if sign == part {
            Ok(false)
        } else if *sign == part.negated() {
            Ok(true)
        } else {
            Err(CheckError::from(Wrong::Sign))
        }
    };
    let (mut negative, mut strict) = (false, true);
    if own.product {
        let [sign] = own.signs.as_slice() else {
            return Err(Wrong::Sign.into());
        };
        negative = turned(&sign.polynomial, &work.times(&own.above, &below)?)?;
        strict = sign.strict;
        if !strict && !domain.nonzero_here(&below)? {
            return Err(Unsupported::Divisor(below.to_string()).into());
        }
    } else {
        if own.signs.len() != own.below.len() + 1 {
            return Err(Wrong::Sign.into());
        }
        let once = [(&own.above, &1)];
        let all = once
            .into_iter()
            .chain(own.below.iter().map(|(p, e)| (p, e)));
        for (place, (sign, (of, exponent))) in own.signs.iter().zip(all).enumerate() {
            negative ^= turned(&sign.polynomial, of)? && exponent % 2 == 1;
            match place {
                0 => strict = sign.strict,
                _ if sign.strict || domain.nonzero_here(of)? => {}
                _ => return Err(Wrong::Zero.into()),
            }
        }
    }
    let shown = match relation {
        Relation::Equal => false,
        Relation::Different => strict,
        Relation::Less => negative && strict,
        Relation::AtMost => negative,
        Relation::Greater => !negative && strict,
        Relation::AtLeast => !negative,
    };
    if shown {
        Ok(())
    } else {
        Err(Wrong::Sign.into())
    }
}

/// Checks `!=` where hypotheses imply that the numerator is nonzero.
fn excluded(
    domain: &Domain<'_>,
    relation: Relation,
    differences: &[Quotient],
    own: &Excluded<Polynomial>,
) -> Result<(), CheckError> {
    let [difference] = differences else {
        return Err(Wrong::Kind.into());
    };
    if relation != Relation::Different {
        return Err(Wrong::Kind.into());
    }
    if !proportional(domain, &difference.above, &own.numerator)? {
        return Err(Wrong::Differs(difference.above.len()).into());
    }
    if domain.nonzero_here(&difference.above)? {
        Ok(())
    } else {
        Err(domain.may_vanish_here(&difference.above))
    }
}

/// Checks that printed numbers agree in the stated way.
fn enclosure(
    domain: &Domain<'_>,
    values: &[Quotient],
    own: &Enclosure<Polynomial>,
) -> Result<(), CheckError> {
    if let Some(symbol) = values
        .iter()
        .flat_map(|value| value.above.symbols())
        .find(|symbol| !symbol.is_number())
    {
        return Err(Unsupported::NoValue(symbol.to_string()).into());
    }
    if !printed::same_values(values, own, domain.work)? {
        return Err(Wrong::Sides.into());
    }
    let numbers: Vec<_> = own.entries.iter().map(|e| e.printed.clone()).collect();
    let found = printed::agreements(values, &numbers, domain.work)?;
    for (number, (found, entry)) in (1..).zip(found.iter().zip(&own.entries)) {
        if found.is_none() || *found != entry.how {
            return Err(Wrong::Printed(number).into());
        }
    }
    Ok(())
}
