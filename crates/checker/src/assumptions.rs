//! The domain of a claim in the checker: expanded hypotheses, eliminated symbols replaced by their values, and the
//! divisors that occurred.

use super::apart::Apart;
use super::ends::interval_ends;
use super::expand::Expander;
use super::gap::{Unsupported, Work};
use super::quotient::Quotient;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;
use std::sync::Arc;
use torse_certificate::polynomial::Polynomial;
use torse_certificate::proof::assumptions::{Assumptions, Determining, Elimination};
use torse_certificate::symbol::Symbol;
use torse_core::{self as core, Hypothesis, Set, Source, Statement};
use torse_numbers::rational::integer;
use torse_syntax::formula::{Connective, Relation};

/// A comparison with zero that a hypothesis states.
#[derive(Debug, Clone)]
pub struct Compared {
    /// Left minus right.
    pub difference: Quotient,
    /// The relation.
    pub relation: Relation,
    /// The field of the hypothesis.
    pub source: Source,
    /// The eliminated symbols that were replaced in it.
    pub met: Met,
}

impl Compared {
    /// What an equation `p x + r = 0` implies where p is zero: `r = 0`.
    fn rests(&self, zero: &Self) -> Vec<Self> {
        let (own, zero_above) = (&self.difference.above, &zero.difference.above);
        if zero_above.is_number() {
            return vec![];
        }
        let rest = |symbol: &Symbol| match own.coefficients_in(symbol).as_slice() {
            [rest, slope] if slope.quotient(zero_above).is_some() => Some(rest.clone()),
            _ => None,
        };
        let rests = own.symbols().filter_map(rest);
        rests
            .map(|rest| Self {
                difference: rest.into(),
                met: self.met.union(&zero.met).cloned().collect(),
                ..self.clone()
            })
            .collect()
    }
}

/// The comparisons of all hypotheses that can be expanded.
#[derive(Debug, Default)]
pub struct Hypotheses {
    /// The comparisons, in order.
    pub all: Vec<Compared>,
    /// Why some hypothesis could not be expanded.
    pub gap: Option<Unsupported>,
    /// Why some given equation could not be expanded.
    pub gap_in_given: Option<Unsupported>,
}

/// Eliminated symbols that were replaced. A result that uses their values is valid only if they have these values.
pub type Met = BTreeSet<Symbol>;

/// A claim with the eliminations of a proof.
pub struct Domain<'a> {
    pub claim: &'a core::Claim,
    pub work: &'a Work,
    /// Polynomials that are assumed to be nonzero, and to be zero, in addition to the hypotheses of the claim.
    pub(super) conditions: &'a [Polynomial],
    zeros: &'a [Polynomial],
    /// The chosen integer values.
    fixed: BTreeMap<Symbol, Quotient>,
    pub(super) groups: &'a [Elimination<Polynomial>],
    /// Polynomials that never vanish on the declared sets; this is checked elsewhere.
    pub(super) nonzero: Vec<Polynomial>,
    /// Polynomials that do not vanish where all eliminated symbols have their values; their signs were checked.
    pub(super) apart: RefCell<Apart>,
    values: RefCell<BTreeMap<usize, Rc<BTreeMap<Symbol, Quotient>>>>,
    hypotheses: RefCell<BTreeMap<usize, Rc<Hypotheses>>>,
    /// The eliminated symbols that were used.
    pub(super) used: RefCell<BTreeSet<Symbol>>,
    /// The divisors in terms, by the number of groups that were replaced at that time. If further symbols are
    /// replaced, a divisor is known not to vanish only after these symbols are shown to have their values.
    pub(super) divisors: RefCell<BTreeMap<usize, BTreeMap<Polynomial, Met>>>,
}

impl<'a> Domain<'a> {
    pub fn new(
        claim: &'a core::Claim,
        (conditions, zeros): (&'a [Polynomial], &'a [Polynomial]),
        ground: Option<&'a Assumptions<Polynomial>>,
        integers: &BTreeMap<String, i64>,
        work: &'a Work,
    ) -> Self {
        let number = |n: &i64| Quotient::number(integer(*n));
        let fixed = integers.iter();
        Self {
            claim,
            work,
            conditions,
            zeros,
            fixed: fixed
                .map(|(name, n)| (Symbol::named(name), number(n)))
                .collect(),
            groups: ground.map_or(&[], |ground| &ground.eliminated),
            nonzero: vec![],
            apart: RefCell::default(),
            values: RefCell::default(),
            hypotheses: RefCell::default(),
            used: RefCell::default(),
            divisors: RefCell::default(),
        }
    }

    /// The domain in which these polynomials are known to be nonzero.
    pub fn with_nonzero(mut self, nonzero: Vec<Polynomial>) -> Self {
        self.nonzero = nonzero;
        self
    }

    /// Why some hypothesis could not be expanded. A proof that uses it may look wrong without being so.
    pub fn unread(&self) -> Option<Unsupported> {
        self.hypotheses(self.groups.len()).gap.clone()
    }

    /// The number of groups of eliminated symbols.
    pub fn groups(&self) -> usize {
        self.groups.len()
    }

    /// The values of the symbols that the first `groups` groups eliminate, in terms of the other symbols.
    fn values(&self, groups: usize) -> Result<Rc<BTreeMap<Symbol, Quotient>>, Unsupported> {
        if let Some(known) = self.values.borrow().get(&groups) {
            return Ok(Rc::clone(known));
        }
        let mut values = self.fixed.clone();
        let first = self.groups.get(..groups).unwrap_or_default();
        for group in first.iter().rev() {
            let mut own = vec![];
            for determined in &group.values {
                let value = Quotient::from_ratio(&determined.value, self.work)?;
                let value_of = |symbol: &Symbol| values.get(symbol).cloned();
                own.push((
                    determined.symbol.clone(),
                    value.replaced(&value_of, self.work)?,
                ));
            }
            values.extend(own);
        }
        let values = Rc::new(values);
        let mut kept = self.values.borrow_mut();
        kept.insert(groups, Rc::clone(&values));
        Ok(values)
    }

    /// Runs a job with an expander that replaces the symbols of the first `groups` groups; also returns the symbols
    /// that were replaced.
    pub(super) fn expanding<T>(
        &self,
        groups: usize,
        job: impl FnOnce(&Expander<'_>) -> Result<T, Unsupported>,
    ) -> Result<(T, Met), Unsupported> {
        let values = self.values(groups)?;
        let met = RefCell::new(Met::new());
        let value = |symbol: &Symbol| {
            let value = values.get(symbol)?;
            if !self.fixed.contains_key(symbol) {
                met.borrow_mut().insert(symbol.clone());
            }
            Some(value.clone())
        };
        let by_assumption = |group: &Elimination<Polynomial>| {
            let met = met.borrow();
            !matches!(group.by, Determining::Given { .. })
                && group.values.iter().any(|d| met.contains(&d.symbol))
        };
        let sees_rates = || {
            let all = groups == self.groups.len();
            let solved = self.claim.unknowns.is_empty() || all && self.solves_given();
            solved && !self.groups.iter().any(by_assumption)
        };
        let mut expander = Expander::new(self.work, &value);
        expander.sees_rates = &sees_rates;
        let result = job(&expander)?;
        let mut divisors = self.divisors.borrow_mut();
        let known = divisors.entry(groups).or_default();
        let found = expander.divisors.borrow();
        for divisor in found.iter() {
            let met = met.borrow();
            known.entry(divisor.clone()).or_insert_with(|| met.clone());
        }
        drop(found);
        Ok((result, met.into_inner()))
    }

    /// Records that eliminated symbols are used, and the symbols that occur in their values.
    pub fn note(&self, met: &Met) {
        let mut pending: Vec<Symbol> = met.iter().cloned().collect();
        while let Some(symbol) = pending.pop() {
            if !self.used.borrow_mut().insert(symbol.clone()) {
                continue;
            }
            let all = self.groups.iter().flat_map(|group| &group.values);
            for determined in all.filter(|d| d.symbol == symbol) {
                let value = &determined.value;
                let inner = value.above.symbols().chain(value.below.symbols());
                let inner = inner.filter_map(Symbol::variable).map(Symbol::named);
                pending.extend(inner.filter(|s| self.is_eliminated(s)));
            }
        }
    }

    /// Whether given equations determine unknowns in this proof.
    fn solves_given(&self) -> bool {
        let mut groups = self.groups.iter();
        groups.any(|group| matches!(group.by, Determining::Given { .. }))
    }

    fn is_eliminated(&self, symbol: &Symbol) -> bool {
        let mut all = self.groups.iter().flat_map(|group| &group.values);
        all.any(|determined| determined.symbol == *symbol)
    }

    /// The differences of the sides of a comparison, entry by entry.
    pub fn differences(
        &self,
        left: &core::Term,
        right: &core::Term,
    ) -> Result<Vec<Quotient>, Unsupported> {
        let (differences, met) = self.expanding(self.groups.len(), |expander| {
            let pairs = expander.value(left)?.pairs(&expander.value(right)?)?;
            let differences = pairs.iter().map(|(x, y)| x.minus(y, self.work));
            differences.collect()
        })?;
        self.note(&met);
        Ok(differences)
    }

    /// The value of a term, entry by entry.
    pub fn entries(&self, term: &core::Term) -> Result<Vec<Quotient>, Unsupported> {
        let (entries, met) = self.expanding(self.groups.len(), |expander| {
            let value = expander.value(term)?;
            Ok(value.numbers().into_iter().cloned().collect())
        })?;
        self.note(&met);
        Ok(entries)
    }

    /// The comparisons of the hypotheses, with the symbols of the first `groups` groups replaced.
    pub(super) fn hypotheses(&self, groups: usize) -> Rc<Hypotheses> {
        if let Some(known) = self.hypotheses.borrow().get(&groups) {
            return Rc::clone(known);
        }
        let mut found = Hypotheses::default();
        for hypothesis in &self.claim.hypotheses {
            if let Err(gap) = self.expand_hypothesis(groups, hypothesis, &mut found.all) {
                if hypothesis.source == Source::Given {
                    found.gap_in_given.get_or_insert(gap.clone());
                }
                found.gap = Some(gap);
            }
        }
        for zero in self.zeros {
            match self.replaced(groups, zero) {
                Ok(equation) => {
                    let rests: Vec<Compared> = found
                        .all
                        .iter()
                        .filter(|known| known.relation == Relation::Equal)
                        .flat_map(|known| known.rests(&equation))
                        .collect();
                    found.all.push(equation);
                    found.all.extend(rests);
                }
                Err(gap) => found.gap = Some(gap),
            }
        }
        let found = Rc::new(found);
        let mut kept = self.hypotheses.borrow_mut();
        kept.insert(groups, Rc::clone(&found));
        found
    }

    /// The equation that a polynomial is zero, with the symbols of the first `groups` groups replaced.
    pub(super) fn replaced(
        &self,
        groups: usize,
        zero: &Polynomial,
    ) -> Result<Compared, Unsupported> {
        let values = self.values(groups)?;
        let met = RefCell::new(Met::new());
        let value_of = |symbol: &Symbol| {
            let value = values.get(symbol)?;
            if !self.fixed.contains_key(symbol) {
                met.borrow_mut().insert(symbol.clone());
            }
            Some(value.clone())
        };
        let difference = Quotient::from(zero.clone()).replaced(&value_of, self.work)?;
        Ok(Compared {
            difference,
            relation: Relation::Equal,
            source: Source::Assume,
            met: met.into_inner(),
        })
    }

    fn expand_hypothesis(
        &self,
        groups: usize,
        hypothesis: &Hypothesis,
        found: &mut Vec<Compared>,
    ) -> Result<(), Unsupported> {
        let strange = || Unsupported::Construct("a hypothesis that is no comparison");
        let mut gap = None;
        // The entries of given equations are referred to by position, so these must be kept as written.
        let exponents = match hypothesis.source {
            Source::Given => None,
            _ => hypothesis.statement.compare_exponents(),
        };
        for statement in [&hypothesis.statement].into_iter().chain(&exponents) {
            for (relation, left, right) in compared(statement).ok_or_else(strange)? {
                match self.compare(groups, hypothesis, relation, left, right) {
                    Ok(all) => found.extend(all),
                    Err(own) => gap = Some(own),
                }
            }
        }
        gap.map_or(Ok(()), Err)
    }

    fn compare(
        &self,
        groups: usize,
        hypothesis: &Hypothesis,
        relation: Relation,
        left: &core::Term,
        right: &core::Term,
    ) -> Result<Vec<Compared>, Unsupported> {
        let (differences, met) = self.expanding(groups, |expander| {
            let pairs = expander.value(left)?.pairs(&expander.value(right)?)?;
            // A hypothesis holds only where no divisor in it is zero.
            let all = pairs
                .iter()
                .map(|(x, y)| x.minus(y, self.work)?.cancelled(self.work));
            all.collect::<Result<Vec<_>, _>>()
        })?;
        let source = hypothesis.source;
        let one = |difference| Compared {
            difference,
            relation,
            source,
            met: met.clone(),
        };
        if relation == Relation::Different && differences.len() > 1 {
            // Vectors differ if and only if the sum of the squared differences is positive.
            let mut sum = Quotient::default();
            for difference in &differences {
                sum = sum.plus(&difference.times(difference, self.work)?, self.work)?;
            }
            return Ok(vec![Compared {
                relation: Relation::Greater,
                ..one(sum)
            }]);
        }
        Ok(differences.into_iter().map(one).collect())
    }

    /// All constraints of the domain: the comparisons of the hypotheses and the declared sets, with the symbols of
    /// the first `groups` groups replaced.
    pub fn constraints(
        &self,
        groups: usize,
    ) -> Result<(Vec<Compared>, Option<Unsupported>), Unsupported> {
        let known = self.hypotheses(groups);
        let (mut found, mut gap) = (known.all.clone(), known.gap.clone());
        if gap.is_none() && self.claim.arcs().next().is_some() {
            gap = Some(Unsupported::Construct("the order of arcs"));
        }
        let values = self.values(groups)?;
        for (name, set) in &self.claim.symbols {
            let symbol = Symbol::Named(Arc::clone(name));
            let own = || Polynomial::symbol(symbol.clone()).into();
            let value: Quotient = values.get(&symbol).cloned().unwrap_or_else(own);
            let mut met = Met::new();
            if let Set::Integer { least, most } = set {
                let forms = least.iter().chain(most);
                met.extend(
                    forms
                        .flat_map(|form| form.multiples())
                        .map(|(n, _)| Symbol::named(n)),
                );
            }
            met.insert(symbol.clone());
            met.retain(|symbol| values.contains_key(symbol) && !self.fixed.contains_key(symbol));
            if self.is_positive_root(&symbol, groups)? {
                let zero = Met::new();
                found.push(Compared {
                    difference: value.clone(),
                    relation: Relation::Greater,
                    source: Source::Assume,
                    met: zero,
                });
            }
            for (bound, relation) in self.bounds(set, &values)? {
                found.push(Compared {
                    difference: value.minus(&bound, self.work)?,
                    relation,
                    source: Source::Assume,
                    met: met.clone(),
                });
            }
        }
        Ok((found, gap))
    }

    /// The bounds of a declared set.
    fn bounds(
        &self,
        set: &Set,
        values: &BTreeMap<Symbol, Quotient>,
    ) -> Result<Vec<(Quotient, Relation)>, Unsupported> {
        let mut all = vec![];
        match set {
            Set::Real(interval) => all.extend(interval_ends(interval)),
            Set::Integer { least, most } => {
                let ends = least.iter().map(|form| (form, Relation::AtLeast));
                let ends = ends.chain(most.iter().map(|form| (form, Relation::AtMost)));
                for (form, relation) in ends {
                    let mut bound = Quotient::number(integer(form.constant()));
                    for (name, multiple) in form.multiples() {
                        let symbol = Symbol::named(name);
                        let own = || Polynomial::symbol(symbol.clone()).into();
                        let value: Quotient = values.get(&symbol).cloned().unwrap_or_else(own);
                        let multiple = Quotient::number(integer(multiple));
                        bound = bound.plus(&value.times(&multiple, self.work)?, self.work)?;
                    }
                    all.push((bound, relation));
                }
            }
            Set::Vector(_) | Set::Family { .. } => {}
        }
        Ok(all)
    }
}

/// The comparisons of which a hypothesis is a conjunction; a negated comparison is the opposite one.
fn compared(statement: &Statement) -> Option<Vec<(Relation, &core::Term, &core::Term)>> {
    match statement {
        Statement::Compare {
            relation,
            left,
            right,
        } => Some(vec![(*relation, left, right)]),
        Statement::Join(Connective::And, a, b) => Some([compared(a)?, compared(b)?].concat()),
        Statement::Not(inner) => denied(inner),
        _ => None,
    }
}

/// The comparisons of which the negation of a statement is a conjunction.
fn denied(statement: &Statement) -> Option<Vec<(Relation, &core::Term, &core::Term)>> {
    match statement {
        Statement::Compare {
            relation,
            left,
            right,
        } => Some(vec![(relation.opposite(), left, right)]),
        Statement::Not(inner) => compared(inner),
        Statement::Join(Connective::Or, a, b) => Some([denied(a)?, denied(b)?].concat()),
        Statement::Join(Connective::Implies, a, b) => Some([compared(a)?, denied(b)?].concat()),
        _ => None,
    }
}
