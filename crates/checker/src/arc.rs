//! Arcs: symbols of the set from `-pi/2` to `pi/2` whose tangents or sines are their arguments.
//!
//! In the claim that is checked every arc is a symbol w with the hypothesis `sin(w) == r*cos(w)` or `sin(w) == r`
//! ([`torse_core::Claim::rooted`]); the checker makes that claim itself. An angle A may replace w if it satisfies the hypothesis and
//! lies in the set. It does by the signs of `A + pi/2` and `pi/2 - A`, or by those of `A + 3 pi/2`, `3 pi/2 - A` and the cosine of A:
//! between `-3 pi/2` and `3 pi/2` the cosine is positive between `-pi/2` and `pi/2` alone.

use super::assumptions::Domain;
use super::gap::{CheckError, Unsupported, Wrong};
use super::quotient::Quotient;
use super::sign::Signs;
use torse_certificate::polynomial::Polynomial;
use torse_certificate::proof::assumptions::Signed;
use torse_certificate::symbol::Symbol;
use torse_core::ArcFunction;
use torse_numbers::Rational;
use torse_numbers::rational::integer;

impl Domain<'_> {
    /// A symbol that is an arc, by an angle with its tangent or sine that lies where arcs do.
    pub(super) fn by_arc(
        &self,
        place: usize,
        signs: &[Signed<Polynomial>],
    ) -> Result<(), CheckError> {
        let work = self.work;
        let group = self.groups.get(place).ok_or(Wrong::Kind)?;
        let [determined] = group.values.as_slice() else {
            return Err(Wrong::Kind.into());
        };
        let wrong = || CheckError::from(Wrong::Eliminated(determined.symbol.to_string()));
        let mut arcs = self.claim.arcs();
        let arc = arcs.find(|arc| Symbol::named(arc.name) == determined.symbol);
        let arc = arc.ok_or_else(wrong)?;
        let (argument, met) = self.expanding(place, |expander| {
            let value = expander.value(arc.argument)?;
            let numbers = value.numbers();
            numbers
                .into_iter()
                .next()
                .cloned()
                .ok_or(Unsupported::Large)
        })?;
        self.note(&met);
        let value = Quotient::from_ratio(&determined.value, work)?;
        let (sine, cosine) = value.sine_cosine(work)?;
        let equation = match arc.function {
            ArcFunction::Tangent => sine.minus(&argument.times(&cosine, work)?, work)?,
            ArcFunction::Sine => sine.minus(&argument, work)?,
        };
        if !equation.is_zero(work)? {
            // The equations of other arcs may make it zero.
            return Err(Unsupported::Construct("an arc whose value rests on equations").into());
        }
        let below = determined
            .value
            .below
            .as_constant()
            .filter(|n| *n != integer(0));
        let below = below.ok_or(Unsupported::Construct("the value of an arc with a divisor"))?;
        let angle = determined.value.above.scaled(&(integer(1) / below));
        let is_strict = arc.function == ArcFunction::Tangent;
        let shown = |wanted: &Polynomial, is_strict: bool| -> Result<bool, CheckError> {
            for own in signs {
                if own.sign.polynomial != *wanted || is_strict && !own.sign.strict {
                    continue;
                }
                Signs::new(self, &own.constraints, place)?.check(&own.sign)?;
                return Ok(true);
            }
            Ok(false)
        };
        let within = |halves: i64, is_strict: bool| -> Result<bool, CheckError> {
            let end =
                Polynomial::symbol(Symbol::Pi).scaled(&Rational::new(halves.into(), 2.into()));
            Ok(shown(&angle.plus(&end), is_strict)? && shown(&end.minus(&angle), is_strict)?)
        };
        if within(1, is_strict)? {
            return Ok(());
        }
        // The cosine of a sum of angles has no divisor.
        if within(3, true)? && cosine.below.is_empty() && shown(&cosine.above, is_strict)? {
            return Ok(());
        }
        match signs.is_empty() {
            true => Err(Unsupported::Construct("an arc whose branch is seen by its range").into()),
            false => Err(wrong()),
        }
    }
}
