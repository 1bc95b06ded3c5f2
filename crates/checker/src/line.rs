//! Signs on a part of the line: what bounds the part has to follow from the claim, and on each of its cells the sign has to be
//! the one that is said.

use super::gap::{CheckError, Unsupported, Wrong};
use super::sign::Signs;
use std::cmp::Ordering;
use torse_certificate::line::{Line, Product, Uncut, Within};
use torse_certificate::number::{holds, order};
use torse_certificate::polynomial::Polynomial;
use torse_certificate::ratio::Constraint;
use torse_certificate::sign::End;
use torse_syntax::formula::Relation;

impl Signs<'_> {
    /// A product of the factors, multiplied out.
    pub(super) fn product(
        &self,
        product: &Product<Polynomial>,
        line: &Line<Polynomial>,
    ) -> Result<Polynomial, CheckError> {
        let degree =
            |p: &Polynomial| usize::try_from(p.degree_in(&line.variable)).unwrap_or(usize::MAX);
        let degrees = line.factors.iter().zip(&product.exponents);
        let whole = degrees.fold(1_usize, |sum, (factor, exponent)| {
            let times = usize::try_from(*exponent).unwrap_or(usize::MAX);
            sum.saturating_add(degree(factor).saturating_add(1).saturating_mul(times))
        });
        self.domain.work.spend(whole.saturating_mul(whole))?;
        let product = product.polynomial(&line.factors);
        Ok(product.ok_or(Wrong::Equation)?)
    }

    /// Checks that the target is not negative on the part of the line; whether it is not zero either.
    pub(super) fn line(&self, line: &Line<Polynomial>) -> Result<bool, CheckError> {
        for factor in &line.factors {
            let degree = usize::try_from(factor.degree_in(&line.variable)).unwrap_or(usize::MAX);
            let once = degree.saturating_mul(degree);
            let pieces = line.cuts.len().saturating_add(1);
            self.domain.work.spend(once.saturating_mul(pieces))?;
        }
        let relations = line.within.iter().map(|within| self.within(within, line));
        let relations: Vec<Relation> = relations.collect::<Result<_, _>>()?;
        let cells = line.cells().map_err(|uncut| match uncut {
            Uncut::Near => CheckError::from(Unsupported::Near),
            Uncut::Variable | Uncut::Cuts | Uncut::Roots => Wrong::Line(uncut).into(),
        })?;
        let mut strict = true;
        for cell in &cells {
            let mut inside = true;
            for (within, relation) in line.within.iter().zip(&relations) {
                inside &= is_met(within, *relation, cell)?;
            }
            if !inside {
                continue;
            }
            match line.target.sign_on(cell).ok_or(Unsupported::Near)? {
                Ordering::Less => return Err(Wrong::Negative.into()),
                Ordering::Equal => strict = false,
                Ordering::Greater => {}
            }
        }
        Ok(strict)
    }

    /// Checks that something is true at all points of the domain, and written by the factors as it is: how it compares with zero.
    fn within(
        &self,
        within: &Within<Polynomial>,
        line: &Line<Polynomial>,
    ) -> Result<Relation, CheckError> {
        let written =
            |product: &Product<Polynomial>, own: &Polynomial| match self.product(product, line) {
                Ok(made) if made == *own => Ok(()),
                Ok(_) => Err(Wrong::Equation.into()),
                Err(error) => Err(error),
            };
        match within {
            Within::Constraint {
                constraint,
                above,
                below,
            } => {
                let Constraint { value, relation } = self.constraint_of_hypothesis(*constraint)?;
                written(above, &value.above)?;
                written(below, &value.below)?;
                // Where the denominator is zero the constraint might say nothing.
                match value.below.is_number()
                    || self.domain.nonzero_at(&value.below, self.groups)?
                {
                    true => Ok(*relation),
                    false => Err(Unsupported::Divisor(value.below.to_string()).into()),
                }
            }
            Within::End {
                value,
                closed,
                is_lower,
                offset,
            } => {
                let end = End {
                    value: value.clone(),
                    closed: *closed,
                };
                let side = match is_lower {
                    true => self.ranges.side(&line.variable, Some(&end), None),
                    false => self.ranges.side(&line.variable, None, Some(&end)),
                };
                if !side || !value.below.is_number() {
                    return Err(self.left(&line.variable));
                }
                let own = Polynomial::symbol(line.variable.clone()).times(&value.below);
                written(offset, &own.minus(&value.above))?;
                Ok(match (is_lower, closed) {
                    (true, true) => Relation::AtLeast,
                    (true, false) => Relation::Greater,
                    (false, true) => Relation::AtMost,
                    (false, false) => Relation::Less,
                })
            }
            Within::Nonzero { divisor, product } => {
                written(product, divisor)?;
                match self.domain.nonzero_at(divisor, self.groups)? {
                    true => Ok(Relation::Different),
                    false => Err(Wrong::Divisor(divisor.to_string()).into()),
                }
            }
        }
    }
}

/// Whether something compares with zero on a cell as it should.
fn is_met(
    within: &Within<Polynomial>,
    relation: Relation,
    cell: &[Ordering],
) -> Result<bool, CheckError> {
    let sign = |product: &Product<Polynomial>| product.sign_on(cell).ok_or(Unsupported::Near);
    let (above, below) = match within {
        Within::Constraint { above, below, .. } => (sign(above)?, sign(below)?),
        Within::End { value, offset, .. } => {
            let below = order(&value.below).ok_or(Unsupported::Near)?;
            (sign(offset)?, below)
        }
        Within::Nonzero { product, .. } => (sign(product)?, Ordering::Greater),
    };
    Ok(match below {
        Ordering::Equal => false,
        Ordering::Greater => holds(above, relation),
        Ordering::Less => holds(above.reverse(), relation),
    })
}
