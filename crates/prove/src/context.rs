//! A claim made ready: its one domain, and the statement evaluated on it.
//!
//! Every hypothesis, whether it stands in `assume` or in `given`, is a constraint of the same domain. An equation that
//! determines a symbol eliminates it: the symbol is replaced **everywhere**, in the statement, in all other constraints
//! and in what was eliminated before, and it leaves behind what bound it: its declared range, its integrality, and the
//! divisor of its value. Since derivatives are taken by variables of their own, putting values in for symbols changes
//! the meaning of nothing.

use crate::decide::conditions;
use crate::decide::domain::{Constraint, Domain};
use crate::decide::exponential;
use crate::decide::interval::Interval;
use crate::decide::root::Root;
use crate::decide::sign;
use crate::decide::value::{plain_symbol, quotient};
use crate::evaluate::Evaluator;
use crate::evaluate::linear::solve_for;
use crate::evaluate::series::polynomial_of;
use crate::evaluate::value::{Statement, UNPLACED, Value};
use crate::roots::{self, Resolved};
use crate::unknown::Unknown;
use std::collections::BTreeMap;
use std::rc::Rc;
use torse_algebra::fault_injection::{InjectedFault, injected};
use torse_algebra::{Fraction, Polynomial, Symbol};
use torse_certificate::proof::assumptions::{Determined, Determining, Elimination, Signed};
use torse_core::{self as core, Hypothesis, Source};
use torse_elaborate::Elaborator;
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::derivation::{Claim, Written};
use torse_syntax::fault::Fault;
use torse_syntax::formula::{Connective, Relation};

/// Divisors of more terms than this are not examined for their sign.
const MAX_EXAMINED: usize = 40;

/// The domain of a claim, with all hypotheses in force. A copy knows what was evaluated so far.
#[derive(Clone)]
pub struct ProofContext<'a> {
    /// The evaluator: eliminated symbols have their values.
    pub evaluator: Evaluator<'a>,
    /// The domain.
    pub domain: Domain<'a>,
    /// How symbols were eliminated, in this order.
    pub eliminated: Vec<Elimination<Polynomial>>,
    /// The factors of the divisors of eliminations that may vanish, each as it was when it was divided by: what the claim
    /// became says nothing where one of them is zero.
    pub splits: Vec<Polynomial>,
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
            .evaluator
            .truth(&core.statement)
            .map_err(|f| f.within(&statement.origin))?;
        let mut domain = ground.domain;
        domain.order_exponentials(&exponential::symbols_of(&value));
        Ok(Self {
            evaluator: ground.evaluator,
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
        Self::where_zero(claim, elaborator, fixed, roots, &[])
    }

    /// The same at those points of the domain at which these polynomials are zero.
    ///
    /// # Errors
    /// As [`ProofContext::new`].
    pub fn where_zero(
        claim: &core::Claim,
        elaborator: Rc<Elaborator<'a>>,
        fixed: &BTreeMap<String, Fraction>,
        roots: RootMode,
        zeros: &[Polynomial],
    ) -> Result<Self, Fault> {
        let how = (SolvePolicy::Always, roots);
        let mut ground = Self::made(claim, elaborator, fixed, how, zeros)?;
        let given = ground.given(claim)?;
        match zeros {
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
    ) -> Result<Self, Fault> {
        Self::made(claim, elaborator, fixed, (solving, RootMode::Symbols), &[])
    }

    fn made(
        claim: &core::Claim,
        elaborator: Rc<Elaborator<'a>>,
        fixed: &BTreeMap<String, Fraction>,
        (solving, roots_solved): (SolvePolicy, RootMode),
        zeros: &[Polynomial],
    ) -> Result<Self, Fault> {
        let evaluator = Evaluator::with(elaborator);
        let mut ground = Self {
            domain: Domain::new(evaluator.declarations),
            evaluator: evaluator.fixing(fixed),
            eliminated: vec![],
            splits: vec![],
            solving,
            roots_solved,
        };
        for (name, value) in fixed {
            ground.keep_range(&Symbol::named(name), value);
        }
        let hypotheses = claim.hypotheses.iter();
        let assumed = hypotheses.filter(|h| h.source == Source::Assume);
        // Inequalities first: they may say that the divisor of an elimination does not vanish.
        let (equations, others) = assumed.partition(|h| has_equation(&h.statement));
        ground.assume_all(others)?;
        let rooted = claim.hypotheses.iter().filter(|h| h.root().is_some());
        let mut roots = ground.resolve(rooted.collect())?;
        zeros
            .iter()
            .try_for_each(|zero| ground.vanishes(&zero.clone().into()))?;
        ground.assume_all(equations)?;
        if ground.domain.pivots.is_empty() {
            roots = ground.resolve(roots)?;
        }
        ground.constrain_roots(&roots)?;
        Ok(ground)
    }

    /// Takes the roots of which a value is found; those that are left.
    fn resolve<'h>(
        &mut self,
        hypotheses: Vec<&'h Hypothesis>,
    ) -> Result<Vec<&'h Hypothesis>, Fault> {
        self.domain.roots.clear();
        for hypothesis in &hypotheses {
            let Some((name, radicand)) = hypothesis.root() else {
                continue;
            };
            let symbol = Symbol::named(name);
            let value = self.evaluator.term(radicand);
            let (false, Some(radicand)) =
                (self.is_solved(&symbol), value.ok().as_ref().and_then(plain))
            else {
                continue;
            };
            match roots::resolved(&radicand, &self.domain) {
                Some(found) => self.take_root(&symbol, &radicand, found)?,
                None => self.domain.roots.push(Root { symbol, radicand }),
            }
        }
        while let Some((root, found)) = roots::resolved_by_others(&self.domain) {
            self.take_root(&root.symbol, &root.radicand, found)?;
        }
        self.see_positive_roots();
        // Of one that an equation eliminated the radicand is still to be known.
        let open = |h: &&Hypothesis| {
            let root = h.root().map(|(name, _)| Symbol::named(name));
            root.is_some_and(|root| !self.has_root_value(&root))
        };
        Ok(hypotheses.into_iter().filter(open).collect())
    }

    fn is_solved(&self, symbol: &Symbol) -> bool {
        self.domain.solved.iter().any(|(known, _)| known == symbol)
    }

    /// Whether a root was given a value as such.
    fn has_root_value(&self, root: &Symbol) -> bool {
        let root = plain_symbol(root);
        self.eliminated.iter().any(|elimination| {
            let mut values = elimination.values.iter();
            matches!(elimination.by, Determining::Root(_)) && values.any(|v| v.symbol == root)
        })
    }

    /// A root has this value, where its radicand has one.
    fn take_root(
        &mut self,
        symbol: &Symbol,
        radicand: &Fraction,
        found: Resolved,
    ) -> Result<(), Fault> {
        let rooted = Signed {
            sign: found.sign,
            constraints: written(&self.domain.constraints),
        };
        let value = found.value.under(radicand.conditions());
        let unknown = Unknown::new(symbol.clone()).ok_or_else(no_unknown)?;
        let value = self.eliminate(&unknown, &value)?;
        let by = Determining::Root(Box::new(rooted));
        self.eliminated_by(vec![(symbol.clone(), value)], by);
        Ok(())
    }

    /// Roots are positive where their radicands do not vanish.
    fn see_positive_roots(&mut self) {
        for root in self.domain.roots.clone() {
            let own = Polynomial::symbol(root.symbol.clone());
            if !self.domain.assumes_nonzero(&own) && self.never_zero(root.radicand.numerator()) {
                let radicand = root.radicand.numerator().clone();
                self.domain.positive_radicands.push(radicand);
                self.domain.constraints.push(Constraint {
                    value: own.into(),
                    relation: Relation::Greater,
                });
            }
        }
    }

    /// The equations of the roots that are left. A root has a value where its radicand has one.
    fn constrain_roots(&mut self, roots: &[&Hypothesis]) -> Result<(), Fault> {
        for hypothesis in roots {
            let within = |f: Fault| f.within(&hypothesis.origin);
            let Some((name, _)) = hypothesis.root() else {
                continue;
            };
            let statement = self.evaluator.truth(&hypothesis.statement);
            let mut forms = vec![];
            statement
                .and_then(|statement| equations(&statement, &mut forms))
                .map_err(within)?;
            for form in forms {
                let value = self.resolved(&form)?;
                let symbol = Symbol::named(name);
                if !self.is_solved(&symbol) {
                    let own = Fraction::symbol(symbol).under(value.conditions());
                    self.evaluator.fix(name.to_string(), own);
                }
                let relation = Relation::Equal;
                match self.roots_solved {
                    RootMode::Symbols => {
                        self.domain.constraints.push(Constraint { value, relation })
                    }
                    RootMode::Solved => self.vanishes(&value)?,
                }
            }
        }
        if self.roots_solved == RootMode::Solved {
            // What they are the roots of is written by them now: they are symbols like all others.
            self.domain.roots.clear();
        }
        Ok(())
    }

    /// The differences of the sides of the given equations.
    ///
    /// # Errors
    /// [`Fault`], pointing into the equation that caused it.
    pub fn given(&self, claim: &core::Claim) -> Result<Vec<Fraction>, Fault> {
        let hypotheses = claim.hypotheses.iter();
        let mut forms = vec![];
        for hypothesis in hypotheses.filter(|h| h.source == Source::Given) {
            let statement = self.evaluator.truth(&hypothesis.statement);
            let taken = statement.and_then(|statement| equations(&statement, &mut forms));
            taken.map_err(|f| f.within(&hypothesis.origin))?;
        }
        Ok(forms)
    }

    /// The symbols that the unknowns of the given equations consist of.
    ///
    /// # Errors
    /// [`Fault`] for what is no symbol.
    pub fn unknowns(&self, claim: &core::Claim) -> Result<Vec<Unknown>, Fault> {
        unknowns(&self.evaluator, &claim.unknowns)
    }

    /// The ranges of integers whose ends name other integers are constraints.
    fn bound_integers(&mut self, claim: &core::Claim, fixed: &BTreeMap<String, Fraction>) {
        for (name, set) in &claim.symbols {
            let eliminated = self
                .domain
                .solved
                .iter()
                .any(|(s, _)| *s == Symbol::named(name));
            let SymbolKind::Integer { least, most } = set else {
                continue;
            };
            let dependent = least
                .iter()
                .chain(most)
                .any(|form| form.as_number().is_none());
            if dependent && !eliminated && !fixed.contains_key(&**name) {
                self.keep_range(&Symbol::named(name), &Fraction::named(name));
            }
        }
    }

    /// Takes the assumptions, each as soon as it can be evaluated: one may fix the degree that another one needs.
    fn assume_all(&mut self, mut pending: Vec<&Hypothesis>) -> Result<(), Fault> {
        loop {
            let before = pending.len();
            let (mut rest, mut obstacle) = (vec![], None);
            for hypothesis in pending {
                let of_exponents = hypothesis.statement.of_exponents();
                let said = of_exponents.as_ref().unwrap_or(&hypothesis.statement);
                let taken = self
                    .evaluator
                    .truth(said)
                    .and_then(|statement| self.assume(&statement));
                match taken {
                    Ok(()) => {}
                    Err(fault) if fault.is_limit() => {
                        rest.push(hypothesis);
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

    fn assume(&mut self, statement: &Statement) -> Result<(), Fault> {
        match statement {
            Statement::Join(Connective::And, a, b) => {
                self.assume(a)?;
                self.assume(b)
            }
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
            // `x == formula` eliminates x rather than a symbol of the formula.
            for (unknown, value) in [
                (Unknown::from_fraction(&x), &y),
                (Unknown::from_fraction(&y), &x),
            ] {
                if let Some(unknown) = unknown
                    && !unknown.occurs_in(value)
                    && self.fits(unknown.symbol(), value)
                {
                    if self.ends_the_branch(&unknown, value) {
                        return Ok(());
                    }
                    let value = self.eliminate(&unknown, value)?;
                    self.eliminated_by(
                        vec![(unknown.symbol().clone(), value)],
                        Determining::Assumed { nonzero: vec![] },
                    );
                    return Ok(());
                }
            }
        }
        match (relation, differences.as_slice()) {
            (Relation::Equal, _) => differences.iter().try_for_each(|d| self.vanishes(d)),
            (_, [value]) => {
                self.constrain(value.clone(), relation);
                Ok(())
            }
            // Vectors differ where the sum of the squares of the differences is positive.
            (Relation::Different, _) => {
                let sum = differences
                    .iter()
                    .fold(Fraction::zero(), |sum, d| sum + d.clone() * d.clone());
                self.constrain(sum, Relation::Greater);
                Ok(())
            }
            _ => Err(Fault::limit(UNPLACED, "vectors have no order")),
        }
    }

    /// Adds a constraint, and that it is defined.
    fn constrain(&mut self, value: Fraction, relation: Relation) {
        self.differ_from_zero(value.conditions());
        self.domain.constraints.push(Constraint { value, relation });
    }

    /// A hypothesis holds only where it is defined.
    fn differ_from_zero(&mut self, divisors: &[Polynomial]) {
        for divisor in divisors {
            let value = Fraction::from(divisor.clone());
            let relation = Relation::Different;
            let constraint = Constraint { value, relation };
            let known = |c: &Constraint| c.relation == relation && c.value.numerator() == divisor;
            if !self.domain.constraints.iter().any(known) {
                self.domain.constraints.push(constraint);
            }
        }
    }

    /// Takes an equation `value == 0`: eliminates a symbol in which it is linear.
    fn vanishes(&mut self, value: &Fraction) -> Result<(), Fault> {
        let value = self.resolved(value)?;
        self.differ_from_zero(value.conditions());
        if value.is_zero() {
            return Ok(());
        }
        if value.numerator().as_constant().is_some()
            || value.symbols().iter().all(Symbol::is_number)
        {
            self.constrain(value, Relation::Equal);
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
            let equations = self.domain.constraints.iter();
            let mut equations = equations.filter(|c| c.relation == Relation::Equal);
            equations.any(|c| coefficient.exact_quotient(c.value.numerator()).is_some())
        };
        if let Some((unknown, coefficient, _)) = candidates.iter().find(|(_, c, _)| zero(c)) {
            let own = Polynomial::symbol(unknown.symbol().clone());
            let rest = value.numerator() - &(coefficient * &own);
            return self.vanishes(&rest.into());
        }
        // A coefficient that vanishes nowhere first: then the equation and its solution say the same.
        let constant = |(_, coefficient, _): &&(Unknown, Polynomial, Fraction)| {
            coefficient.symbols().iter().all(Symbol::is_number)
        };
        let chosen = candidates
            .iter()
            .find(constant)
            .or_else(|| candidates.iter().find(|(_, c, _)| self.never_zero(c)))
            .or_else(|| candidates.first())
            .cloned();
        let settled = |(_, coefficient, _): &(Unknown, Polynomial, Fraction)| {
            coefficient.symbols().iter().all(Symbol::is_number) || self.never_zero(coefficient)
        };
        let chosen = chosen.filter(|found| self.solving == SolvePolicy::Always || settled(found));
        let Some((unknown, coefficient, solution)) = chosen else {
            // It determines no symbol rationally; points have to satisfy it all the same.
            self.constrain(value, Relation::Equal);
            return Ok(());
        };
        let own = Polynomial::symbol(unknown.symbol().clone());
        let rest = value.numerator() - &(&coefficient * &own);
        let plainly = rest
            .as_constant()
            .is_some_and(|c| c != Polynomial::zero().leading_coefficient())
            || coefficient.symbols().iter().all(Symbol::is_number)
            || self.domain.assumes_nonzero(&coefficient);
        let implied = plainly || self.never_zero(&coefficient);
        // What the elimination rewrites says nothing of its divisor afterwards.
        let (open, nonzero) = match implied {
            true if plainly => (vec![], vec![]),
            true => (vec![], self.signed(std::slice::from_ref(&coefficient))),
            false => self.unsettled(std::slice::from_ref(&coefficient)),
        };
        if self.ends_the_branch(&unknown, &solution) {
            return Ok(());
        }
        let value = self.eliminate(&unknown, &solution)?;
        let by = Determining::Assumed { nonzero };
        self.eliminated_by(vec![(unknown.symbol().clone(), value)], by);
        if coefficient.as_constant().is_none() {
            match implied {
                true => self.differ_from_zero(&[coefficient]),
                false => self.split(open),
            }
        }
        Ok(())
    }

    /// Whether an elimination makes a divisor of an earlier one zero: then there is no point at which the divisor is not, and
    /// a constraint that holds nowhere says so.
    fn ends_the_branch(&mut self, unknown: &Unknown, value: &Fraction) -> bool {
        let Ok(value) = self.resolved(value) else {
            return false;
        };
        let vanishes = |pivot: &Polynomial| {
            let there = replaced(&pivot.clone().into(), unknown.symbol(), &value);
            there.is_ok_and(|pivot| pivot.is_zero())
        };
        let ends = self.domain.pivots.iter().any(vanishes);
        if ends {
            self.constrain(Fraction::zero(), Relation::Different);
        }
        ends
    }

    /// The domain falls into the points at which these are not zero, on which the elimination goes on, and all others.
    fn split(&mut self, open: Vec<Polynomial>) {
        if injected(InjectedFault::CaseForgotten) {
            return;
        }
        self.domain.pivots.extend(open.iter().cloned());
        self.splits.extend(open);
    }

    /// The factors of divisors of an elimination that may vanish as far as is known now, and the signs of the others.
    fn unsettled(&self, divisors: &[Polynomial]) -> (Vec<Polynomial>, Vec<Signed<Polynomial>>) {
        let vanishes = |divisor: &Polynomial| {
            let ordered = self.domain.with_ordered_exponentials(divisor.symbols());
            divisor.len() > MAX_EXAMINED
                || !ordered.assumes_nonzero(divisor) && !sign::never_zero(divisor, &ordered)
        };
        let factors = conditions::separated(divisors).into_iter();
        let (open, settled): (Vec<_>, Vec<_>) = factors.partition(vanishes);
        let nonzero = self.signed(&settled);
        (open, nonzero)
    }

    /// The signs of divisors that do not vanish, where no hypothesis says so.
    fn signed(&self, divisors: &[Polynomial]) -> Vec<Signed<Polynomial>> {
        let signed = |divisor: &Polynomial| {
            let ordered = self.domain.with_ordered_exponentials(divisor.symbols());
            if ordered.assumes_nonzero(divisor) {
                return None;
            }
            Some(Signed {
                sign: sign::positive(divisor, &ordered)?,
                constraints: written(&ordered.constraints),
            })
        };
        divisors.iter().filter_map(signed).collect()
    }

    /// Whether a divisor is known to vanish nowhere on the domain; long ones are not examined.
    fn never_zero(&self, divisor: &Polynomial) -> bool {
        divisor.len() <= MAX_EXAMINED
            && (self.domain.assumes_nonzero(divisor) || sign::never_zero(divisor, &self.domain))
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
        self.domain.is_integer(symbol)
    }

    /// Keeps how symbols were eliminated.
    fn eliminated_by(&mut self, values: Vec<(Symbol, Fraction)>, by: Determining<Polynomial>) {
        let values = values.iter().map(|(symbol, value)| Determined {
            symbol: plain_symbol(symbol),
            value: quotient(value),
        });
        let values = values.collect();
        self.eliminated.push(Elimination { values, by });
    }

    /// Replaces a symbol everywhere, and leaves behind what bound it. The value, with those of symbols that were
    /// eliminated before put in.
    fn eliminate(&mut self, unknown: &Unknown, value: &Fraction) -> Result<Fraction, Fault> {
        let symbol = unknown.symbol();
        let value = self.resolved(value)?;
        let put = |f: &Fraction| replaced(f, symbol, &value);
        for constraint in &mut self.domain.constraints {
            constraint.value = put(&constraint.value)?;
        }
        for (_, solved) in &mut self.domain.solved {
            *solved = put(solved)?;
        }
        for root in &mut self.domain.roots {
            root.radicand = put(&root.radicand)?;
        }
        self.domain
            .roots
            .retain(|root| root.symbol != *symbol && !mentions(&root.radicand, &root.symbol));
        for pivot in &mut self.domain.pivots {
            *pivot = put(&pivot.clone().into())?.numerator().clone();
        }
        self.keep_range(symbol, &value);
        self.domain.solved.push((symbol.clone(), value.clone()));
        for (symbol, value) in self.domain.solved.clone() {
            match &symbol {
                Symbol::Named(name) => self.evaluator.fix(name.to_string(), value),
                _ => self.evaluator.determine([(symbol, value)]),
            }
        }
        Ok(value)
    }

    /// The declared range of a symbol as constraints on the value that replaces it.
    fn keep_range(&mut self, symbol: &Symbol, value: &Fraction) {
        let Symbol::Named(name) = symbol else {
            return;
        };
        if injected(InjectedFault::RangeForgotten) {
            return;
        }
        let mut bounds: Vec<(Fraction, Relation)> = vec![];
        match self.domain.declarations.symbol(name) {
            Some(SymbolKind::Real(interval)) => {
                let interval = Interval::from(&**interval);
                bounds.extend(interval.lower.map(|b| match b.closed {
                    true => (value.clone() - b.value, Relation::AtLeast),
                    false => (value.clone() - b.value, Relation::Greater),
                }));
                bounds.extend(interval.upper.map(|b| match b.closed {
                    true => (value.clone() - b.value, Relation::AtMost),
                    false => (value.clone() - b.value, Relation::Less),
                }));
            }
            Some(SymbolKind::Integer { least, most }) => {
                let form = |form| Fraction::from(polynomial_of(form));
                bounds.extend(
                    least
                        .iter()
                        .map(|l| (value.clone() - form(l), Relation::AtLeast)),
                );
                bounds.extend(
                    most.iter()
                        .map(|m| (value.clone() - form(m), Relation::AtMost)),
                );
            }
            _ => {}
        }
        // A bound may itself be in terms of symbols that have values.
        for (bound, relation) in bounds {
            let bound = self.resolved(&bound).unwrap_or(bound);
            self.domain.constraints.push(Constraint {
                value: bound,
                relation,
            });
        }
    }

    /// The value with all eliminated and fixed symbols put in.
    fn resolved(&self, value: &Fraction) -> Result<Fraction, Fault> {
        let mut solved = self.domain.solved.iter();
        let value = solved.try_fold(value.clone(), |value, (symbol, by)| {
            replaced(&value, symbol, by)
        })?;
        let mut fixed = self.evaluator.fixed().iter();
        fixed.try_fold(value, |value, (name, by)| {
            replaced(&value, &Symbol::named(name), by)
        })
    }

    /// Solves the given equations for their unknowns; what is left of them is assumed.
    fn solve(&mut self, forms: &[Fraction], claim: &core::Claim) -> Result<(), Fault> {
        let mut given = claim.hypotheses.iter();
        let Some(first) = given.find(|h| h.source == Source::Given) else {
            return Ok(());
        };
        let symbols = self.unknowns(claim)?;
        let within = |f: Fault| f.within(&first.origin);
        let solution = solve_for(forms, &symbols, UNPLACED).map_err(within)?;
        // Where a divisor vanishes, an unknown may be what its value does not say.
        let divisors = solution.values.values().flat_map(Fraction::conditions);
        let (open, nonzero) = self.unsettled(&divisors.cloned().collect::<Vec<_>>());
        self.split(open);
        let mut values = vec![];
        for (symbol, value) in &solution.values {
            let unknown = Unknown::new(symbol.clone()).ok_or_else(no_unknown)?;
            let value = self.eliminate(&unknown, value).map_err(within)?;
            values.push((symbol.clone(), value));
        }
        let places = solution.used.clone();
        self.eliminated_by(values, Determining::Given { places, nonzero });
        solution
            .rest
            .iter()
            .try_for_each(|form| self.vanishes(form).map_err(within))
    }
}

/// The constraints as parts of a proof.
pub(crate) fn written(
    constraints: &[Constraint],
) -> Vec<torse_certificate::Constraint<Polynomial>> {
    let constraint = |c: &Constraint| torse_certificate::Constraint {
        value: quotient(&c.value),
        relation: c.relation,
    };
    constraints.iter().map(constraint).collect()
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

/// Whether a symbol occurs in a value: as itself, under a sine or cosine, in an index or in a divisor.
fn mentions(value: &Fraction, symbol: &Symbol) -> bool {
    let inside =
        |s: &Symbol| s == symbol || matches!(symbol, Symbol::Named(name) if s.depends_on(name));
    let recorded = value.conditions().iter().flat_map(|p| p.symbols());
    value.symbols().iter().chain(recorded).any(inside)
}

/// The value with a symbol replaced, wherever it stands.
fn replaced(value: &Fraction, symbol: &Symbol, by: &Fraction) -> Result<Fraction, Fault> {
    if !mentions(value, symbol) {
        return Ok(value.clone());
    }
    match symbol {
        Symbol::Named(name) => value.at(name, by),
        _ => value.substituted(|s| (s == symbol).then(|| by.clone())),
    }
    .map_err(|e| Fault::exact(UNPLACED, e))
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

fn no_unknown() -> Fault {
    Fault::limit(UNPLACED, "a function of unknowns in the place of one")
}

/// The unknowns that terms stand for.
fn unknowns(evaluator: &Evaluator<'_>, written: &[core::Term]) -> Result<Vec<Unknown>, Fault> {
    let mut symbols = vec![];
    for unknown in written {
        for entry in evaluator.term(unknown)?.entries() {
            let symbol = entry.as_fraction().and_then(Unknown::from_fraction);
            symbols.push(symbol.ok_or_else(|| {
                crate::evaluate::wrong_type(unknown.place, "a formula", "an unknown such as Q[1]")
            })?);
        }
    }
    Ok(symbols)
}

/// The solution of given equations for their unknowns, for an evaluator without a domain.
///
/// # Errors
/// [`Fault`], pointing into the text that caused it; equations that contradict each other.
pub fn solve_given(
    given: &[Written],
    sought: &[Written],
    evaluator: &Evaluator<'_>,
) -> Result<BTreeMap<Symbol, Fraction>, Fault> {
    let Some(first) = given.first() else {
        return Ok(BTreeMap::new());
    };
    let mut symbols = vec![];
    for unknown in sought {
        let within = |f: Fault| f.within(&unknown.origin);
        let term = evaluator.elaborator().term(&unknown.expr).map_err(within)?;
        symbols.extend(unknowns(evaluator, &[term]).map_err(within)?);
    }
    let mut forms = vec![];
    for equation in given {
        let statement = evaluator
            .statement(&equation.expr)
            .map_err(|f| f.within(&equation.origin))?;
        equations(&statement, &mut forms).map_err(|f| f.within(&equation.origin))?;
    }
    let solution = solve_for(&forms, &symbols, UNPLACED).map_err(|f| f.within(&first.origin))?;
    if !solution.rest.is_empty() {
        let what = "the given equations contradict each other for some values";
        return Err(Fault::limit(UNPLACED, what).within(&first.origin));
    }
    Ok(solution.values)
}

fn equations(statement: &Statement, forms: &mut Vec<Fraction>) -> Result<(), Fault> {
    match statement {
        Statement::Compare {
            relation: Relation::Equal,
            left,
            right,
            ..
        } => {
            for (x, y) in left.entries().into_iter().zip(right.entries()) {
                let difference = x.minus(y);
                let form = difference.as_fraction().cloned();
                forms.push(form.ok_or_else(|| {
                    Fault::limit(UNPLACED, "a given equation of symbolic degree")
                })?);
            }
            Ok(())
        }
        Statement::Join(Connective::And, a, b) => {
            equations(a, forms)?;
            equations(b, forms)
        }
        _ => Err(Fault::limit(
            UNPLACED,
            "a given condition that is no equation",
        )),
    }
}

/// The value of the left side of the first refuted comparison, for the derived form.
#[must_use]
pub fn first_comparison(statement: &Statement) -> Option<(&Value, &Value)> {
    match statement {
        Statement::Compare { left, right, .. } => Some((left, right)),
        Statement::Join(_, a, b) => first_comparison(a).or_else(|| first_comparison(b)),
        Statement::Agrees { .. } | Statement::Family { .. } | Statement::Not(_) => None,
    }
}
