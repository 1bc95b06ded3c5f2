//! Checks that eliminated symbols have their values.
//!
//! Only symbols that are used are checked, in the reverse order of their elimination. An equation of the hypotheses,
//! in which the symbols that were eliminated earlier are replaced, is linear in the symbol; so it determines the
//! symbol where its coefficient is nonzero, which the module `nonzero` says. Several `given` equations determine as many
//! symbols where their determinant is nonzero.

use super::apart::Apart;
use super::assumptions::{Compared, Domain};
use super::gap::{CheckError, Unsupported, Wrong};
use super::quotient::Quotient;
use super::sign::Signs;
use super::value::determinant;
use std::collections::{BTreeMap, BTreeSet};
use torse_certificate::polynomial::Polynomial;
use torse_certificate::proof::assumptions::{Determining, Signed};
use torse_certificate::ratio::Constraint;
use torse_certificate::sign::Sign;
use torse_certificate::symbol::Symbol;
use torse_core::Source;
use torse_syntax::formula::Relation;

impl Domain<'_> {
    /// Checks that the eliminated symbols that were used have their values wherever the conditions do not vanish.
    pub fn justified(&self) -> Result<(), CheckError> {
        for place in (0..self.groups.len()).rev() {
            let Some(group) = self.groups.get(place) else {
                continue;
            };
            let used = |symbol: &Symbol| self.used.borrow().contains(symbol);
            if !group.values.iter().any(|d| used(&d.symbol)) {
                continue;
            }
            let hypotheses = self.hypotheses(place);
            let known = &hypotheses.all;
            let determined = match &group.by {
                Determining::Given { places, nonzero } => {
                    // The equations are referred to by position among all entries.
                    if let Some(gap) = &hypotheses.gap_in_given {
                        return Err(gap.clone().into());
                    }
                    self.by_given(place, (places, nonzero), known)
                }
                Determining::Assumed { nonzero } => self.by_one(place, nonzero, known),
                Determining::Root(own) => self.by_root(place, own, &[]),
                Determining::RootAlong(own) => self.by_root(place, &own.root, &own.multiples),
                Determining::Arc(signs) => self.by_arc(place, signs),
            };
            match (determined, hypotheses.gap.clone()) {
                // The equation may be one that could not be expanded.
                (Err(CheckError::Wrong(Wrong::Eliminated(_))), Some(gap)) => return Err(gap.into()),
                (determined, _) => determined?,
            }
        }
        Ok(())
    }

    /// Checks a symbol that one equation determines.
    fn by_one(
        &self,
        place: usize,
        nonzero: &[Signed<Polynomial>],
        known: &[Compared],
    ) -> Result<(), CheckError> {
        let group = self.groups.get(place).ok_or(Wrong::Kind)?;
        let [determined] = group.values.as_slice() else {
            return Err(Wrong::Kind.into());
        };
        let (symbol, value) = (&determined.symbol, &determined.value);
        let wrong = || Wrong::Eliminated(symbol.to_string());
        let mut may_vanish = None;
        let signed = self.signed(place, nonzero)?;
        for equation in known.iter().filter(|c| c.relation == Relation::Equal) {
            let Some((rest, slope)) = linear(&equation.difference.above, symbol) else {
                continue;
            };
            // slope*symbol + rest = 0
            let sum = self
                .work
                .times(&slope, &value.above)?
                .plus(&self.work.times(&rest, &value.below)?);
            if !Quotient::from(sum).is_zero(self.work)? {
                continue;
            }
            let implied = rest.is_number() && !rest.is_zero();
            if implied || self.is_nonzero(&slope, known, place, &signed.factors)? {
                self.note(&equation.met);
                return Ok(());
            }
            may_vanish = Some(slope);
        }
        let Some(slope) = may_vanish else {
            // Nothing is brought to lowest terms here: `(x - 1)*(x/x) == 0` determines x, and is not linear in it.
            let cancels = |c: &&Compared| {
                let difference = &c.difference;
                c.relation == Relation::Equal
                    && linear(&difference.above, symbol).is_none()
                    && difference
                        .below
                        .iter()
                        .any(|(factor, _)| inside(factor, symbol) || factor.degree_in(symbol) > 0)
            };
            return Err(match known.iter().find(cancels) {
                Some(_) => Unsupported::Construct("an equation of which a factor cancels").into(),
                None => wrong().into(),
            });
        };
        Err(signed.may_vanish(&slope))
    }

    /// The polynomials that are nonzero by these signs, with the symbols of the first `groups` groups replaced.
    fn signed(&self, groups: usize, all: &[Signed<Polynomial>]) -> Result<Apart, CheckError> {
        let mut apart = Apart::default();
        for own in all {
            let signs = Signs::new(self, &own.constraints, groups)?;
            apart.take(signs.check(&own.sign), &own.sign)?;
        }
        Ok(apart)
    }

    /// Checks polynomials that are nonzero by their signs where all eliminated symbols have their values; from then
    /// on they are known to be nonzero.
    pub fn take_apart(
        &self,
        signs: &[Sign<Polynomial>],
        constraints: &[Constraint<Polynomial>],
    ) -> Result<(), CheckError> {
        for sign in signs {
            // That a root is positive may depend on the previous sign.
            let checked = Signs::new(self, constraints, self.groups.len())?.check(sign);
            self.apart.borrow_mut().take(checked, sign)?;
        }
        Ok(())
    }

    /// Checks symbols that as many `given` equations determine: the values satisfy the equations, and the determinant
    /// is nonzero.
    fn by_given(
        &self,
        level: usize,
        (places, nonzero): (&[usize], &[Signed<Polynomial>]),
        known: &[Compared],
    ) -> Result<(), CheckError> {
        let group = self.groups.get(level).ok_or(Wrong::Kind)?;
        let names: Vec<String> = group.values.iter().map(|d| d.symbol.to_string()).collect();
        let wrong = || CheckError::from(Wrong::Eliminated(names.join(", ")));
        let given: Vec<&Compared> = known.iter().filter(|c| c.source == Source::Given).collect();
        let mut values = BTreeMap::new();
        for determined in &group.values {
            let value = Quotient::from_ratio(&determined.value, self.work)?;
            values.insert(determined.symbol.clone(), value);
        }
        let distinct: BTreeSet<&usize> = places.iter().collect();
        if distinct.len() != group.values.len() || places.len() != group.values.len() {
            return Err(wrong());
        }
        let mut rows = vec![];
        for place in places {
            let equation = given.get(*place).ok_or_else(wrong)?;
            self.note(&equation.met);
            let numerator = &equation.difference.above;
            let value_of = |symbol: &Symbol| values.get(symbol).cloned();
            let substituted = Quotient::from(numerator.clone()).replaced(&value_of, self.work)?;
            if equation.relation != Relation::Equal || !substituted.is_zero(self.work)? {
                return Err(wrong());
            }
            let mut row = vec![];
            for determined in &group.values {
                let (_, slope) = match numerator.degree_in(&determined.symbol) {
                    0 if inside(numerator, &determined.symbol) => return Err(wrong()),
                    0 => (Polynomial::zero(), Polynomial::zero()),
                    _ => linear(numerator, &determined.symbol).ok_or_else(wrong)?,
                };
                // A coefficient that contains another of the symbols would make the equation nonlinear.
                let mut others = group.values.iter();
                if others.any(|other| slope.degree_in(&other.symbol) > 0) {
                    return Err(wrong());
                }
                row.push(Quotient::from(slope));
            }
            rows.push(row);
        }
        let determinant = determinant(&rows, self.work)?.above;
        let signed = self.signed(level, nonzero)?;
        if self.is_nonzero(&determinant, known, level, &signed.factors)? {
            Ok(())
        } else {
            Err(signed.may_vanish(&determinant))
        }
    }
}

/// Returns `(rest, slope)` of a polynomial `slope*symbol + rest` in which the symbol occurs neither in the two parts
/// nor under a sine.
pub(super) fn linear(polynomial: &Polynomial, symbol: &Symbol) -> Option<(Polynomial, Polynomial)> {
    if inside(polynomial, symbol) {
        return None;
    }
    match polynomial.coefficients_in(symbol).as_slice() {
        [rest, slope] => Some((rest.clone(), slope.clone())),
        _ => None,
    }
}

/// Whether a symbol occurs under a sine or cosine.
fn inside(polynomial: &Polynomial, symbol: &Symbol) -> bool {
    let depends = |own: &Symbol| own.variable().map(Symbol::named).as_ref() == Some(symbol);
    polynomial
        .symbols()
        .any(|own| own != symbol && depends(own))
}
