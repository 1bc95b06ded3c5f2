//! The arcs of a claim in its domain: those with values in other symbols are eliminated, the equations of the others are taken like
//! all equations, and what is known of arguments is known of arcs, since these increase.

use super::{ProofContext, plain};
use crate::arcs::{self, ArcValue};
use crate::decide::domain::branch::{Equation, written};
use crate::decide::domain::{Constraint, Domain};
use crate::decide::open_arc::OpenArc;
use crate::decide::order::truth;
use crate::decide::sign::{self, Sign};
use crate::roots::reduced;
use crate::unknown::{Unknown, mentions};
use torse_algebra::fault_injection::{InjectedFault, injected};
use torse_algebra::rational::ratio;
use torse_algebra::{Fraction, Polynomial, Scalar as _, Symbol};
use torse_certificate::proof::assumptions::Signed;
use torse_core::{self as core, ArcFunction, Hypothesis, Term};
use torse_syntax::fault::Fault;
use torse_syntax::formula::Relation;

/// The most terms of an argument, or of a difference of two, whose sign is examined.
const MAX_EXAMINED: usize = 30;

impl ProofContext<'_> {
    /// Takes the hypotheses that define arcs.
    pub(super) fn take_arcs(&mut self, claim: &core::Claim) -> Result<(), Fault> {
        let mut all = vec![];
        for arc in claim.arcs() {
            let argument = self.arc_argument(arc.argument)?;
            self.branch.differ_from_zero(argument.conditions());
            all.push((arc, Symbol::named(arc.name)));
        }
        if all.is_empty() {
            return Ok(());
        }
        self.branch.domain.arcs.clear();
        self.order_arcs(claim)?;
        let roots = claim.hypotheses.iter().filter(|own| own.root().is_some());
        let roots: Vec<&Hypothesis> = roots.collect();
        for (arc, symbol) in &all {
            // What roots are the roots of may have values by the arcs before.
            if !roots.is_empty() && self.branch.domain.pivots().is_empty() {
                self.resolve(roots.clone())?;
            }
            let argument = self.arc_argument(arc.argument)?;
            let argument = reduced(&argument, &self.branch.domain.roots).unwrap_or(argument);
            if !self.branch.is_solved(symbol) {
                let value = arcs::resolved(arc.function, &argument, &self.branch.domain);
                match value.filter(|value| !mentions(&value.angle, symbol)) {
                    Some(value) => self.take_arc(symbol, value)?,
                    None => self.branch.domain.arcs.push(OpenArc {
                        function: arc.function,
                        symbol: symbol.clone(),
                        argument: argument.clone(),
                    }),
                }
            }
            let own = self.branch.resolved(&Fraction::symbol(symbol.clone()))?;
            let turned = own.sine_cosine();
            let (sine, cosine) = turned.map_err(|error| Fault::exact(arc.argument.place, error))?;
            let equation = match arc.function {
                ArcFunction::Tangent => sine - argument * cosine,
                ArcFunction::Sine => sine - argument,
            };
            self.vanishes_or_stays(&equation)?;
        }
        Ok(())
    }

    /// Gives an arc its value.
    fn take_arc(&mut self, symbol: &Symbol, value: ArcValue) -> Result<(), Fault> {
        let Some(unknown) = Unknown::new(symbol.clone()) else {
            return Ok(());
        };
        let constraints = written(&self.branch.domain.constraints);
        let signed = |sign| Signed {
            sign,
            constraints: constraints.clone(),
        };
        let signs = value.signs.into_iter().map(signed).collect();
        let solution = [(unknown, value.angle)];
        let _ = self.branch.solve(&solution, Equation::Arc(signs))?;
        Ok(())
    }

    fn arc_argument(&self, term: &Term) -> Result<Fraction, Fault> {
        let value = self.branch.evaluator.term(term)?;
        let value = plain(&value)
            .ok_or_else(|| Fault::limit(term.place, "the arc of a formula of symbolic degree"))?;
        self.branch.resolved(&value)
    }

    /// Arguments that are ordered on the domain order arcs, those of simple numbers among them.
    fn order_arcs(&mut self, claim: &core::Claim) -> Result<(), Fault> {
        let mut values = vec![];
        for arc in claim.arcs() {
            let value = self.branch.resolved(&Fraction::named(arc.name))?;
            values.push((arc.function, value, self.arc_argument(arc.argument)?));
        }
        let arcs = values.len();
        for function in [ArcFunction::Tangent, ArcFunction::Sine] {
            let known = match function {
                ArcFunction::Tangent => [(0, 1, 0), (1, 1, 3), (-1, 1, -3)],
                ArcFunction::Sine => [(0, 1, 0), (1, 2, 2), (-1, 2, -2)],
            };
            for (above, below, twelfths) in known {
                let number = |n, d| ratio(n, d).map(Fraction::from);
                let turns = ratio(twelfths, 12);
                if let (Some(argument), Some(turns)) = (number(above, below), turns) {
                    let value = Fraction::symbol(Symbol::Pi).scaled(&turns);
                    values.push((function, value, argument));
                }
            }
        }
        let mut found = vec![];
        for (place, (function, first, above)) in values.iter().enumerate().take(arcs) {
            let others = values.iter().skip(place + 1);
            for (_, second, below) in others.filter(|(own, ..)| own == function) {
                let gap = above.clone() - below.clone();
                let product = gap.numerator() * &gap.denominator();
                if product.len() > MAX_EXAMINED {
                    continue;
                }
                let value = first.clone() - second.clone();
                let domain = &self.branch.domain;
                let relation = match relation_to_zero(&product, domain) {
                    Some(relation) => relation,
                    None => {
                        // Arcs that are ordered order arguments.
                        if let Some(relation) = stated_relation(&value, domain)
                            && truth(&gap, relation).is_none()
                        {
                            let value = gap;
                            found.push(Constraint { value, relation });
                        }
                        continue;
                    }
                };
                let relation = match injected(InjectedFault::ArcsReversed) {
                    true => relation.mirrored(),
                    false => relation,
                };
                if truth(&value, relation).is_none() {
                    found.push(Constraint { value, relation });
                }
            }
        }
        self.branch.domain.constraints.extend(found);
        Ok(())
    }
}

/// How a polynomial compares with zero on the domain.
fn relation_to_zero(polynomial: &Polynomial, domain: &Domain<'_>) -> Option<Relation> {
    Some(match sign::sign(polynomial, domain) {
        Some(Sign::Positive) => Relation::Greater,
        Some(Sign::Nonnegative) => Relation::AtLeast,
        Some(Sign::Negative) => Relation::Less,
        Some(Sign::Nonpositive) => Relation::AtMost,
        None if domain.assumes_nonzero(polynomial) => Relation::Different,
        None => return None,
    })
}

/// How the difference of two arcs compares with zero, if a constraint says it, but for a number.
fn stated_relation(difference: &Fraction, domain: &Domain<'_>) -> Option<Relation> {
    let difference = difference.as_polynomial()?;
    domain.constraints.iter().find_map(|constraint| {
        let stated = constraint.value.as_polynomial()?;
        let factor = stated.exact_quotient(difference)?.as_constant()?;
        match num_traits::Signed::is_positive(&factor) {
            true => Some(constraint.relation),
            false => Some(constraint.relation.mirrored()),
        }
    })
}
