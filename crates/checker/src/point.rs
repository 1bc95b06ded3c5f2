//! Checks counterexamples: substitutes them in every declared set, every hypothesis, and the statement.

use super::ends::interval_ends;
use super::expand::Expander;
use super::gap::{CheckError, Unsupported, Work, Wrong};
use super::quotient::Quotient;
use super::value::Value;
use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::sync::Arc;
use torse_certificate::number::{holds, order};
use torse_certificate::point::{Comparison, Counterexample, Failure};
use torse_certificate::polynomial::Polynomial;
use torse_certificate::ratio::Ratio;
use torse_certificate::symbol::Symbol;
use torse_core::{self as core, BuiltIn, Set, Statement};
use torse_numbers::rational::integer;
use torse_syntax::formula::{Connective, Relation};

/// A claim at a point.
pub struct At<'a> {
    claim: &'a core::Claim,
    work: &'a Work,
    values: BTreeMap<Symbol, Quotient>,
}

impl<'a> At<'a> {
    /// The point of a counterexample, with the chosen integers.
    pub fn new(
        claim: &'a core::Claim,
        integers: &BTreeMap<String, i64>,
        point: &Counterexample<Polynomial>,
        work: &'a Work,
    ) -> Result<Self, CheckError> {
        let chosen = integers.iter();
        let mut values: BTreeMap<Symbol, Quotient> = chosen
            .map(|(name, n)| (Symbol::named(name), Quotient::number(integer(*n))))
            .collect();
        for value in point.at.iter().chain(&point.others) {
            let number = Quotient::from_ratio(&value.value, work)?;
            let twice = values.insert(value.symbol.clone(), number.clone());
            if twice.is_some_and(|before| before != number) {
                return Err(Wrong::Outside.into());
            }
        }
        Ok(Self {
            claim,
            work,
            values,
        })
    }

    /// The values of terms.
    fn values(&self, terms: &[&core::Term]) -> Result<Vec<Value>, Unsupported> {
        // Coefficients of forms are derivatives, which the values at a point do not determine; so for them the point
        // is substituted after expanding.
        let rates = |term: &&core::Term| term.applies(BuiltIn::Coefficients);
        let later = self.claim.unknowns.is_empty() && terms.iter().any(rates);
        let integer = |symbol: &Symbol| match symbol {
            Symbol::Named(name) => {
                matches!(self.claim.symbols.get(name), Some(Set::Integer { .. }))
            }
            _ => false,
        };
        let value = |symbol: &Symbol| {
            let value = self.values.get(symbol).cloned();
            value.filter(|_| !later || integer(symbol))
        };
        let mut expander = Expander::new(self.work, &value);
        let sees_rates = || later;
        expander.sees_rates = &sees_rates;
        let values = terms.iter().map(|term| expander.value(term));
        let values: Vec<Value> = values.collect::<Result<_, _>>()?;
        if !later {
            return Ok(values);
        }
        let value_of = |symbol: &Symbol| self.values.get(symbol).cloned();
        let substituted = |value: &Value| value.each(&|x| x.replaced(&value_of, self.work));
        values.iter().map(substituted).collect()
    }

    /// The integer value of an index form at the point.
    fn form(&self, form: &torse_numbers::Affine) -> Result<i64, Unsupported> {
        let value = |symbol: &Symbol| self.values.get(symbol).cloned();
        Expander::new(self.work, &value).form(form)
    }

    /// The sign of a number.
    fn order(&self, number: &Quotient) -> Result<Ordering, Unsupported> {
        let below = number.denominator(self.work)?;
        for part in [&number.above, &below] {
            if let Some(symbol) = part.symbols().find(|symbol| !symbol.is_number()) {
                return Err(Unsupported::NoValue(symbol.to_string()));
            }
        }
        let above = order(&number.above).ok_or(Unsupported::Near)?;
        match order(&below).ok_or(Unsupported::Near)? {
            Ordering::Equal => Err(Unsupported::Undefined("a quotient with divisor zero")),
            Ordering::Greater => Ok(above),
            Ordering::Less => Ok(above.reverse()),
        }
    }

    fn difference(&self, a: &Quotient, b: &Quotient) -> Result<Ordering, Unsupported> {
        self.order(&a.minus(b, self.work)?)
    }

    /// The sides of a comparison, entry by entry.
    fn sides(
        &self,
        left: &core::Term,
        right: &core::Term,
    ) -> Result<Vec<(Quotient, Quotient)>, Unsupported> {
        match self.values(&[left, right])?.as_slice() {
            [left, right] => left.pairs(right),
            _ => Err(Unsupported::Construct("a comparison of one side")),
        }
    }

    /// Whether a statement without `fails` is true here. Every part is evaluated, because an undefined part makes the
    /// whole undefined.
    pub fn truth(&self, statement: &Statement) -> Result<bool, Unsupported> {
        match statement {
            Statement::Compare {
                relation,
                left,
                right,
            } => {
                let sides = self.sides(left, right)?;
                let order = |(a, b): &(Quotient, Quotient)| self.difference(a, b);
                let orders: Vec<Ordering> = sides.iter().map(order).collect::<Result<_, _>>()?;
                match relation {
                    Relation::Equal => Ok(orders.iter().all(|order| order.is_eq())),
                    Relation::Different => Ok(orders.iter().any(|order| order.is_ne())),
                    _ => match orders.as_slice() {
                        [order] => Ok(holds(*order, *relation)),
                        _ => Err(Unsupported::Construct("an order of vectors")),
                    },
                }
            }
            Statement::Join(connective, a, b) => {
                let (a, b) = (self.truth(a)?, self.truth(b)?);
                Ok(match connective {
                    Connective::And => a && b,
                    Connective::Or => a || b,
                    Connective::Implies => !a || b,
                })
            }
            Statement::Agrees { value, printed, .. } => {
                let values = self.entries(value)?;
                let all = super::printed::agreements(&values, printed, self.work)?;
                Ok(all.iter().all(Option::is_some))
            }
            Statement::Not(_) => Err(Unsupported::Construct("a denial inside of a statement")),
            Statement::Family(..) => Err(Unsupported::Construct("a property of a basis")),
        }
    }

    fn entries(&self, term: &core::Term) -> Result<Vec<Quotient>, Unsupported> {
        let values = self.values(&[term])?;
        let numbers = values.iter().flat_map(Value::numbers);
        Ok(numbers.cloned().collect())
    }

    /// Checks that the point satisfies every hypothesis, and that its numbers are in their declared sets.
    pub fn in_domain(&self) -> Result<(), CheckError> {
        for (name, set) in &self.claim.symbols {
            let symbol = Symbol::Named(Arc::clone(name));
            let Some(value) = self.values.get(&symbol) else {
                if matches!(set, Set::Real(_) | Set::Integer { .. }) {
                    return Err(Unsupported::NoValue(name.to_string()).into());
                }
                continue;
            };
            for (bound, relation) in self.ends(set)? {
                if !holds(self.difference(value, &bound)?, relation) {
                    return Err(Wrong::Outside.into());
                }
            }
            let is_integer = value.as_rational().is_some_and(|q| q.is_integer());
            if matches!(set, Set::Integer { .. }) && !is_integer {
                return Err(Wrong::Outside.into());
            }
        }
        for hypothesis in &self.claim.hypotheses {
            let holds = match &hypothesis.statement {
                // At a point, a negated comparison is the opposite comparison.
                Statement::Not(inner) if matches!(**inner, Statement::Compare { .. }) => {
                    !self.truth(inner)?
                }
                other => self.truth(other)?,
            };
            if !holds {
                return Err(Wrong::Outside.into());
            }
        }
        Ok(())
    }

    fn ends(&self, set: &Set) -> Result<Vec<(Quotient, Relation)>, Unsupported> {
        let mut all = vec![];
        match set {
            Set::Real(interval) => all.extend(interval_ends(interval)),
            Set::Integer { least, most } => {
                let ends = least.iter().map(|form| (form, Relation::AtLeast));
                for (form, relation) in ends.chain(most.iter().map(|f| (f, Relation::AtMost))) {
                    let bound = self.form(form)?;
                    all.push((Quotient::number(integer(bound)), relation));
                }
            }
            Set::Vector(_) | Set::Family { .. } => {}
        }
        Ok(all)
    }

    /// Checks that the statement is false here, in the way that the counterexample states.
    pub fn refutes(&self, point: &Counterexample<Polynomial>) -> Result<(), CheckError> {
        let statement = &self.claim.statement;
        match &point.failure {
            Failure::Sides { kind, left, right } => {
                if matches!(kind, Comparison::Seed | Comparison::Domain) {
                    return Err(Unsupported::Construct("a property of a basis").into());
                }
                if self.truth(statement)? {
                    return Err(Wrong::Stands.into());
                }
                if self.has_sides(statement, left, right)? {
                    Ok(())
                } else {
                    Err(Wrong::Sides.into())
                }
            }
            Failure::Printed(enclosure) => {
                if self.truth(statement)? {
                    return Err(Wrong::Stands.into());
                }
                let found = statement.terms().into_iter().map(|term| self.entries(term));
                for values in found {
                    if super::printed::same_values(&values?, enclosure, self.work)? {
                        return Ok(());
                    }
                }
                Err(Wrong::Sides.into())
            }
            Failure::Dependent { .. } => Err(Unsupported::Construct("dependent functions").into()),
            Failure::Turning { .. } | Failure::Beyond { .. } => {
                Err(Unsupported::Construct("curves that change sign").into())
            }
        }
    }

    /// Whether some comparison of the statement that is false here has these sides.
    fn has_sides(
        &self,
        statement: &Statement,
        left: &[Ratio<Polynomial>],
        right: &[Ratio<Polynomial>],
    ) -> Result<bool, Unsupported> {
        match statement {
            Statement::Compare {
                left: x, right: y, ..
            } => {
                if self.truth(statement)? {
                    return Ok(false);
                }
                let sides = self.sides(x, y)?;
                if sides.len() != left.len() || sides.len() != right.len() {
                    return Err(Unsupported::Construct("sides of different shapes"));
                }
                let mut same = true;
                for ((a, b), (c, d)) in sides.iter().zip(left.iter().zip(right)) {
                    same = same
                        && a.equals(&Quotient::from_ratio(c, self.work)?, self.work)?
                        && b.equals(&Quotient::from_ratio(d, self.work)?, self.work)?;
                }
                Ok(same)
            }
            Statement::Join(_, a, b) => {
                match (
                    self.has_sides(a, left, right),
                    self.has_sides(b, left, right),
                ) {
                    (Ok(true), _) | (_, Ok(true)) => Ok(true),
                    (Err(gap), _) | (_, Err(gap)) => Err(gap),
                    (Ok(false), Ok(false)) => Ok(false),
                }
            }
            _ => Ok(false),
        }
    }

    /// Checks that every term of a statement has a value here.
    pub fn defined(&self, statement: &Statement) -> Result<(), Unsupported> {
        for term in statement.terms() {
            for entry in self.entries(term)? {
                self.order(&entry)?;
            }
        }
        Ok(())
    }
}
