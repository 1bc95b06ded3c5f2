//! A claim made ready: its one domain, and the statement evaluated on it.
//!
//! Every hypothesis, whether it stands in `assume` or in `given`, is a constraint of the same domain. An equation that
//! determines a symbol eliminates it: the symbol is replaced **everywhere**, in the statement, in all other constraints
//! and in what was eliminated before, and it leaves behind what bound it: its declared range, its integrality, and the
//! divisor of its value. Since derivatives are taken by variables of their own, putting values in for symbols changes
//! the meaning of nothing.

mod arcs;
mod given;
mod logarithms;
mod roots;

pub use given::solve_given;

use crate::decide::domain::Domain;
use crate::decide::domain::branch::{Branch, Cases, Divisors, Equation};
use crate::decide::{conditions, exponential};
use crate::evaluate::Evaluator;
use crate::evaluate::value::{Statement, UNPLACED, Value};
use crate::term_divisors::{divides_in_empty_sum, term_divisors};
use crate::unknown::Unknown;
use std::collections::BTreeMap;
use std::rc::Rc;
use torse_algebra::{Fraction, Polynomial, Symbol};
use torse_core::{self as core, Hypothesis, Source};
use torse_elaborate::Elaborator;
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::derivation::{Claim, Written};
use torse_syntax::fault::Fault;
use torse_syntax::formula::{Connective, Relation};

/// The domain of a claim, with all hypotheses in force. A copy knows what was evaluated so far.
#[derive(Clone)]
pub struct ProofContext<'a> {
    /// What the hypotheses made of the domain.
    pub branch: Branch<'a>,
    solving: SolvePolicy,
    roots_solved: RootMode,
}

/// What becomes of the equations `w^2 == r` of roots.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RootMode {
    /// They stay, and w is a symbol.
    Symbols,
    /// A symbol of r in which they are linear is eliminated: for relations of order.
    Solved,
}

/// What is assumed besides the hypotheses.
#[derive(Debug, Clone, Copy, Default)]
pub struct Besides<'p> {
    /// Polynomials that are zero.
    pub zero: &'p [Polynomial],
    /// Polynomials that are not.
    pub nonzero: &'p [Polynomial],
}

/// When an assumed equation is solved for a symbol.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SolvePolicy {
    /// Whenever it is linear in one.
    Always,
    /// Only where the solution divides by nothing that may vanish: what the equation says there would be lost with it. Else
    /// it stays a constraint.
    Safely,
}

/// What a claim states, ready to be decided.
pub struct PreparedClaim<'a> {
    /// The evaluator with all hypotheses in force.
    pub evaluator: Evaluator<'a>,
    /// The domain.
    pub domain: Domain<'a>,
    /// The statement.
    pub statement: Statement,
}

impl<'a> PreparedClaim<'a> {
    /// Prepares a claim with some symbols fixed.
    ///
    /// # Errors
    /// [`Fault`], pointing into the text that caused it.
    pub fn new(
        claim: &'a Claim,
        statement: &Written,
        fixed: BTreeMap<String, Fraction>,
    ) -> Result<Self, Fault> {
        let elaborator = Rc::new(Elaborator::new(&claim.declarations));
        let core = elaborator.claim(claim, statement)?;
        let ground = ProofContext::new(&core, elaborator, &fixed)?;
        let value = ground
            .branch
            .evaluator
            .truth(&core.statement)
            .map_err(|f| f.within(&statement.origin))?;
        let mut domain = ground.branch.domain;
        domain.order_exponentials(&exponential::symbols_of(&value));
        Ok(Self {
            evaluator: ground.branch.evaluator,
            domain,
            statement: value,
        })
    }
}

impl<'a> ProofContext<'a> {
    /// The domain of a claim with some symbols fixed.
    ///
    /// # Errors
    /// [`Fault`], pointing into the hypothesis that caused it.
    pub fn new(
        claim: &core::Claim,
        elaborator: Rc<Elaborator<'a>>,
        fixed: &BTreeMap<String, Fraction>,
    ) -> Result<Self, Fault> {
        Self::with_roots(claim, elaborator, fixed, RootMode::Symbols)
    }

    /// The same with the equations of roots taken one way or the other.
    ///
    /// # Errors
    /// As [`ProofContext::new`].
    pub fn with_roots(
        claim: &core::Claim,
        elaborator: Rc<Elaborator<'a>>,
        fixed: &BTreeMap<String, Fraction>,
        roots: RootMode,
    ) -> Result<Self, Fault> {
        Self::on_side(claim, elaborator, fixed, roots, Besides::default())
    }

    /// The same at those points of the domain at which more is known.
    ///
    /// # Errors
    /// As [`ProofContext::new`].
    pub fn on_side(
        claim: &core::Claim,
        elaborator: Rc<Elaborator<'a>>,
        fixed: &BTreeMap<String, Fraction>,
        roots: RootMode,
        besides: Besides<'_>,
    ) -> Result<Self, Fault> {
        let how = (SolvePolicy::Always, roots);
        let mut ground = Self::made(claim, elaborator, fixed, how, besides)?;
        let given = ground.given(claim)?;
        match besides.zero {
            [] => ground.solve(&given, claim)?,
            // Where the determinant is zero they do not determine the unknowns.
            _ => given.iter().try_for_each(|form| ground.vanishes(form))?,
        }
        ground.bound_integers(claim, fixed);
        Ok(ground)
    }

    /// The same without the given equations.
    ///
    /// # Errors
    /// As [`ProofContext::new`].
    pub fn assumed(
        claim: &core::Claim,
        elaborator: Rc<Elaborator<'a>>,
        fixed: &BTreeMap<String, Fraction>,
        solving: SolvePolicy,
        nonzero: &[Polynomial],
    ) -> Result<Self, Fault> {
        let besides = Besides { zero: &[], nonzero };
        Self::made(
            claim,
            elaborator,
            fixed,
            (solving, RootMode::Symbols),
            besides,
        )
    }

    fn made(
        claim: &core::Claim,
        elaborator: Rc<Elaborator<'a>>,
        fixed: &BTreeMap<String, Fraction>,
        (solving, roots_solved): (SolvePolicy, RootMode),
        besides: Besides<'_>,
    ) -> Result<Self, Fault> {
        let evaluator = Evaluator::with(elaborator);
        let mut ground = Self {
            branch: Branch::new(evaluator.fixing(fixed)),
            solving,
            roots_solved,
        };
        for (name, value) in fixed {
            let chosen = Symbol::named(name);
            ground.branch.keep_range(&chosen, value);
            ground.branch.domain.chosen.push((chosen, value.clone()));
        }
        ground.has_values(besides.nonzero)?;
        let hypotheses = claim.hypotheses.iter();
        let assumed = hypotheses.filter(|h| h.source == Source::Assume);
        // Inequalities first: they may say that the divisor of an elimination does not vanish.
        let (equations, others) = assumed
            .flat_map(conjuncts)
            .partition(|own| has_equation(own.statement));
        ground.assume_all(claim, others)?;
        let rooted = claim.hypotheses.iter().filter(|h| h.root().is_some());
        let mut roots = ground.resolve(rooted.collect())?;
        let mut zeros = besides.zero.iter();
        zeros.try_for_each(|zero| ground.vanishes(&zero.clone().into()))?;
        ground.assume_all(claim, equations)?;
        ground.take_arcs(claim)?;
        if ground.branch.domain.pivots().is_empty() {
            roots = ground.resolve(roots)?;
        }
        ground.constrain_roots(&roots)?;
        ground.take_logarithms(claim)?;
        Ok(ground)
    }

    /// The ranges of integers whose ends name other integers are constraints.
    fn bound_integers(&mut self, claim: &core::Claim, fixed: &BTreeMap<String, Fraction>) {
        for (name, set) in &claim.symbols {
            let eliminated = self.branch.is_solved(&Symbol::named(name));
            let SymbolKind::Integer { least, most } = set else {
                continue;
            };
            let dependent = least
                .iter()
                .chain(most)
                .any(|form| form.as_number().is_none());
            if dependent && !eliminated && !fixed.contains_key(&**name) {
                self.branch
                    .keep_range(&Symbol::named(name), &Fraction::named(name));
            }
        }
    }

    /// Takes the assumptions, each as soon as it can be evaluated: one may fix the degree that another one needs. Each is evaluated
    /// after those before it were taken, so that it speaks of no symbol that one of these eliminated.
    fn assume_all(
        &mut self,
        claim: &core::Claim,
        mut pending: Vec<Conjunct<'_>>,
    ) -> Result<(), Fault> {
        loop {
            let before = pending.len();
            let (mut rest, mut obstacle) = (vec![], None);
            for conjunct in pending {
                let hypothesis = conjunct.hypothesis;
                let of_exponents = conjunct.statement.compare_exponents();
                let said = of_exponents.as_ref().unwrap_or(conjunct.statement);
                let asked = self.is_asked(conjunct.statement);
                let value = asked.and_then(|()| self.branch.evaluator.truth(said));
                let taken = value.and_then(|statement| {
                    let evaluator = &self.branch.evaluator;
                    let written = term_divisors(conjunct.statement, claim, evaluator);
                    self.assume(&statement)?;
                    self.has_values(&written)
                });
                match taken {
                    Ok(()) => {}
                    Err(fault) if fault.is_limit() => {
                        rest.push(conjunct);
                        obstacle.get_or_insert(fault.within(&hypothesis.origin));
                    }
                    Err(fault) => return Err(fault.within(&hypothesis.origin)),
                }
            }
            match obstacle {
                None => return Ok(()),
                Some(fault) if rest.len() == before => return Err(fault),
                Some(_) => pending = rest,
            }
        }
    }

    /// Fails for a hypothesis of which it is not known where it has a value.
    fn is_asked(&self, hypothesis: &core::Statement) -> Result<(), Fault> {
        match divides_in_empty_sum(hypothesis, &self.branch.evaluator) {
            true => Err(Fault::limit(
                UNPLACED,
                "a hypothesis with a sum that may be empty, of terms that may have no value",
            )),
            false => Ok(()),
        }
    }

    /// Takes that a hypothesis has a value: what it divides by is not zero, whether or not its value depends on it.
    fn has_values(&mut self, divisors: &[Polynomial]) -> Result<(), Fault> {
        for divisor in conditions::separated(divisors) {
            let divisor = self.branch.resolved(&divisor.into())?;
            if !self.branch.domain.assumes_nonzero(divisor.numerator()) {
                self.branch
                    .differ_from_zero(std::slice::from_ref(divisor.numerator()));
            }
        }
        Ok(())
    }

    fn assume(&mut self, statement: &Statement) -> Result<(), Fault> {
        match statement {
            Statement::Compare {
                relation,
                left,
                right,
            } => self.compare(*relation, left, right),
            // At a point, "not equal" is "different", "not less" is "at least".
            Statement::Not(inner) => match &**inner {
                Statement::Compare {
                    relation,
                    left,
                    right,
                } => self.compare(relation.opposite(), left, right),
                _ => Err(Fault::limit(
                    UNPLACED,
                    "an assumption that is no comparison",
                )),
            },
            _ => Err(Fault::limit(
                UNPLACED,
                "an assumption that is no comparison",
            )),
        }
    }

    fn compare(&mut self, relation: Relation, left: &Value, right: &Value) -> Result<(), Fault> {
        let differences = left
            .entries()
            .into_iter()
            .zip(right.entries())
            .map(|(x, y)| {
                x.minus(y)
                    .as_fraction()
                    .cloned()
                    .ok_or_else(|| Fault::limit(UNPLACED, "an assumption of symbolic degree"))
            })
            .collect::<Result<Vec<_>, _>>()?;
        if let (Relation::Equal, [_]) = (relation, differences.as_slice())
            && let (Some(x), Some(y)) = (plain(left), plain(right))
        {
            self.branch.differ_from_zero(x.conditions());
            self.branch.differ_from_zero(y.conditions());
            // `x == formula` eliminates x rather than a symbol of the formula.
            for (unknown, value) in [
                (Unknown::from_fraction(&x), &y),
                (Unknown::from_fraction(&y), &x),
            ] {
                if let Some(unknown) = unknown
                    && !unknown.occurs_in(value)
                    && self.fits(unknown.symbol(), value)
                {
                    let solution = [(unknown, value.clone())];
                    let _ = self
                        .branch
                        .solve(&solution, Equation::Assumed(Divisors::default()))?;
                    return Ok(());
                }
            }
        }
        match (relation, differences.as_slice()) {
            (Relation::Equal, _) => differences.iter().try_for_each(|d| self.vanishes(d)),
            (_, [value]) => {
                self.branch.constrain(value.clone(), relation);
                Ok(())
            }
            // Vectors differ where the sum of the squares of the differences is positive.
            (Relation::Different, _) => {
                let sum = differences
                    .iter()
                    .fold(Fraction::zero(), |sum, d| sum + d.clone() * d.clone());
                self.branch.constrain(sum, Relation::Greater);
                Ok(())
            }
            _ => Err(Fault::limit(UNPLACED, "vectors have no order")),
        }
    }

    /// Takes an equation `value == 0`: eliminates a symbol in which it is linear.
    fn vanishes(&mut self, value: &Fraction) -> Result<(), Fault> {
        let value = self.branch.resolved(value)?;
        self.branch.differ_from_zero(value.conditions());
        if value.is_zero() {
            return Ok(());
        }
        if value.numerator().as_constant().is_some()
            || value.symbols().iter().all(Symbol::is_number)
        {
            self.branch.constrain(value, Relation::Equal);
            return Ok(());
        }
        let candidates: Vec<(Unknown, Polynomial, Fraction)> = value
            .symbols()
            .into_iter()
            .filter_map(Unknown::new)
            .filter_map(|unknown| {
                let (coefficient, solution) = linear_in(&value, &unknown)?;
                self.fits(unknown.symbol(), &solution)
                    .then_some((unknown, coefficient, solution))
            })
            .collect();
        // Where the coefficient is zero, the equation says that the rest is.
        let zero = |coefficient: &Polynomial| {
            let equations = self.branch.domain.constraints.iter();
            let mut equations = equations.filter(|c| c.relation == Relation::Equal);
            equations.any(|c| coefficient.exact_quotient(c.value.numerator()).is_some())
        };
        if let Some((unknown, coefficient, _)) = candidates.iter().find(|(_, c, _)| zero(c)) {
            let own = Polynomial::symbol(unknown.symbol().clone());
            let rest = value.numerator() - &(coefficient * &own);
            return self.vanishes(&rest.into());
        }
        // A coefficient that vanishes nowhere first: then the equation and its solution say the same.
        let constant = |(_, coefficient, _): &(Unknown, Polynomial, Fraction)| {
            coefficient.symbols().iter().all(Symbol::is_number)
        };
        let by_number = candidates.iter().position(constant);
        let by_sign = || {
            let mut coefficients = candidates.iter().map(|(_, coefficient, _)| coefficient);
            coefficients.position(|coefficient| self.branch.never_zero(coefficient))
        };
        let settled = by_number.or_else(by_sign);
        let chosen = candidates
            .into_iter()
            .nth(settled.unwrap_or(0))
            .filter(|_| self.solving == SolvePolicy::Always || settled.is_some());
        let Some((unknown, coefficient, solution)) = chosen else {
            // It determines no symbol rationally; points have to satisfy it all the same.
            self.branch.constrain(value, Relation::Equal);
            return Ok(());
        };
        let own = Polynomial::symbol(unknown.symbol().clone());
        let rest = value.numerator() - &(&coefficient * &own);
        let plainly = rest
            .as_constant()
            .is_some_and(|c| c != Polynomial::zero().leading_coefficient())
            || coefficient.symbols().iter().all(Symbol::is_number)
            || self.branch.domain.assumes_nonzero(&coefficient);
        let implied = plainly || settled.is_some();
        // Found before the solution is put in: what that makes of the hypotheses says nothing of its divisor.
        let divisors = match (plainly, settled) {
            (true, _) => Divisors::default(),
            (false, Some(_)) => self.branch.nonzero_divisor(&coefficient),
            (false, None) => self.branch.divisors(std::slice::from_ref(&coefficient)),
        };
        let solution = [(unknown, solution)];
        let cases = self.branch.solve(&solution, Equation::Assumed(divisors))?;
        if implied && cases != Cases::Nowhere && coefficient.as_constant().is_none() {
            self.branch.differ_from_zero(&[coefficient]);
        }
        Ok(())
    }

    /// Whether a symbol may be replaced by the value: an integer only by an integer form.
    fn fits(&self, symbol: &Symbol, value: &Fraction) -> bool {
        !self.is_integer(symbol)
            || value.as_polynomial().is_some_and(|p| {
                p.terms().all(|t| {
                    t.coefficient.is_integer() && t.powers.iter().all(|(s, _)| self.is_integer(s))
                })
            })
    }

    fn is_integer(&self, symbol: &Symbol) -> bool {
        self.branch.domain.is_integer(symbol)
    }
}

/// A part of a hypothesis that holds where the hypothesis does.
struct Conjunct<'h> {
    hypothesis: &'h Hypothesis,
    statement: &'h core::Statement,
}

/// The statements of which a hypothesis is the conjunction.
fn conjuncts(hypothesis: &Hypothesis) -> Vec<Conjunct<'_>> {
    let (mut found, mut pending) = (vec![], vec![&hypothesis.statement]);
    while let Some(statement) = pending.pop() {
        match statement {
            core::Statement::Join(Connective::And, a, b) => pending.extend([&**b, &**a]),
            statement => found.push(Conjunct {
                hypothesis,
                statement,
            }),
        }
    }
    found
}

/// Whether an equation is part of a hypothesis.
fn has_equation(statement: &core::Statement) -> bool {
    match statement {
        core::Statement::Compare { relation, .. } => *relation == Relation::Equal,
        core::Statement::Join(_, a, b) => has_equation(a) || has_equation(b),
        _ => false,
    }
}

/// The number, if the value is one and free of symbolic degrees.
fn plain(value: &Value) -> Option<Fraction> {
    match value {
        Value::Scalar(q) => q.as_fraction().cloned(),
        _ => None,
    }
}

/// Coefficient and solution of `value == 0` for a symbol in which it is linear, and which stands nowhere else.
fn linear_in(value: &Fraction, unknown: &Unknown) -> Option<(Polynomial, Fraction)> {
    let (numerator, symbol) = (value.numerator(), unknown.symbol());
    if numerator.degree_in(symbol) != 1 {
        return None;
    }
    let by_power = numerator.coefficients_in(symbol);
    let [rest, coefficient] = by_power.as_slice() else {
        return None;
    };
    let solution = Fraction::from(-rest.clone())
        .over(&coefficient.clone().into())
        .ok()?;
    (!unknown.occurs_in(&solution)).then(|| (coefficient.clone(), solution))
}
