//! The domain of a claim as the checker sees it: hypotheses expanded, eliminated symbols replaced by their values, and
//! what is known to differ from zero.
//!
//! That a symbol has a value is shown for those alone that matter, in the reverse order of their elimination: an equation
//! of the hypotheses, in which the symbols that were eliminated before have their values, is linear in the symbol; so it
//! determines it where its coefficient is not zero. Several `given` equations determine as many symbols where their
//! determinant is not zero.

use super::expand::Expander;
use super::gap::{Beyond, Unchecked, Work, Wrong};
use super::quotient::Quotient;
use super::value::determinant;
use crate::number::order;
use crate::polynomial::Polynomial;
use crate::proof::ground::{Determining, Elimination, Ground};
use crate::symbol::Symbol;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use torse_language::core::{self, Hypothesis, Set, Source, Statement};
use torse_language::syntax::{Connective, Relation};
use torse_numbers::rational::integer;

/// A comparison of a hypothesis with zero.
#[derive(Debug, Clone)]
pub struct Compared {
    /// Left minus right.
    pub difference: Quotient,
    /// The relation.
    pub relation: Relation,
    /// The field of the hypothesis.
    pub source: Source,
}

/// A claim with the eliminations of a proof.
pub struct Domain<'a> {
    pub claim: &'a core::Claim,
    pub work: &'a Work,
    /// What the verdict says must not vanish.
    conditions: &'a [Polynomial],
    /// The chosen integers.
    fixed: BTreeMap<Symbol, Quotient>,
    groups: &'a [Elimination<Polynomial>],
    /// What never vanishes on the declared sets; shown apart from here.
    nonzero: Vec<Polynomial>,
    /// The eliminated symbols that were met.
    used: RefCell<BTreeSet<Symbol>>,
    /// What was divided by in terms, by how many groups had their values then: where more symbols are replaced, it is known
    /// not to vanish only after these have been shown to have their values.
    divisors: RefCell<BTreeMap<usize, BTreeSet<Polynomial>>>,
}

impl<'a> Domain<'a> {
    pub fn new(
        claim: &'a core::Claim,
        conditions: &'a [Polynomial],
        ground: Option<&'a Ground<Polynomial>>,
        integers: &BTreeMap<String, i64>,
        work: &'a Work,
    ) -> Self {
        let number = |n: &i64| Quotient::number(integer(*n));
        let fixed = integers.iter();
        Self {
            claim,
            work,
            conditions,
            fixed: fixed.map(|(name, n)| (Symbol::named(name), number(n))).collect(),
            groups: ground.map_or(&[], |ground| &ground.eliminated),
            nonzero: vec![],
            used: RefCell::default(),
            divisors: RefCell::default(),
        }
    }

    /// The same, where these polynomials are known not to vanish.
    pub fn with_nonzero(mut self, nonzero: Vec<Polynomial>) -> Self {
        self.nonzero = nonzero;
        self
    }

    /// How many groups of symbols are eliminated.
    pub fn groups(&self) -> usize {
        self.groups.len()
    }

    /// The values of the symbols that the first groups eliminate, in terms of the others.
    fn values(&self, groups: usize) -> Result<BTreeMap<Symbol, Quotient>, Beyond> {
        let mut values = self.fixed.clone();
        let first = self.groups.get(..groups).unwrap_or_default();
        for group in first.iter().rev() {
            let mut own = vec![];
            for determined in &group.values {
                let value = Quotient::of(&determined.value, self.work)?;
                let put = |symbol: &Symbol| values.get(symbol).cloned();
                own.push((determined.symbol.clone(), value.replaced(&put, self.work)?));
            }
            values.extend(own);
        }
        Ok(values)
    }

    /// Runs with an expander in which the symbols of the first groups have their values; those that were met are noted.
    fn expanding<T>(
        &self,
        groups: usize,
        job: impl FnOnce(&Expander<'_>) -> Result<T, Beyond>,
    ) -> Result<T, Beyond> {
        let values = self.values(groups)?;
        let met = RefCell::new(BTreeSet::new());
        let value = |symbol: &Symbol| {
            let value = values.get(symbol)?;
            if !self.fixed.contains_key(symbol) {
                met.borrow_mut().insert(symbol.clone());
            }
            Some(value.clone())
        };
        let by_assumption = |group: &Elimination<Polynomial>| {
            let met = met.borrow();
            !matches!(group.by, Determining::Given(_))
                && group.values.iter().any(|d| met.contains(&d.symbol))
        };
        let sees_rates = || {
            let all = groups == self.groups.len();
            let solved = self.claim.unknowns.is_empty() || all && self.solves_given();
            solved && !self.groups.iter().any(by_assumption)
        };
        let mut expander = Expander::new(self.work, &value);
        expander.sees_rates = &sees_rates;
        let result = job(&expander);
        let mut divisors = self.divisors.borrow_mut();
        let known = divisors.entry(groups).or_default();
        known.extend(expander.divisors.borrow().iter().cloned());
        drop(divisors);
        self.note(met.into_inner());
        result
    }

    /// Notes eliminated symbols, and those in whose terms they have their values.
    fn note(&self, met: BTreeSet<Symbol>) {
        let mut pending: Vec<Symbol> = met.into_iter().collect();
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

    /// Whether given equations determine unknowns here.
    fn solves_given(&self) -> bool {
        let mut groups = self.groups.iter();
        groups.any(|group| matches!(group.by, Determining::Given(_)))
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
    ) -> Result<Vec<Quotient>, Beyond> {
        self.expanding(self.groups.len(), |expander| {
            let pairs = expander.value(left)?.pairs(&expander.value(right)?)?;
            let differences = pairs.iter().map(|(x, y)| x.minus(y, self.work));
            differences.collect()
        })
    }

    /// The value of a term, entry by entry.
    pub fn entries(&self, term: &core::Term) -> Result<Vec<Quotient>, Beyond> {
        self.expanding(self.groups.len(), |expander| {
            let value = expander.value(term)?;
            Ok(value.numbers().into_iter().cloned().collect())
        })
    }

    /// The comparisons of all hypotheses that can be expanded, with the symbols of the first groups replaced; and whether
    /// some cannot.
    fn hypotheses(&self, groups: usize) -> (Vec<Compared>, Option<Beyond>) {
        let (mut found, mut gap) = (vec![], None);
        for hypothesis in &self.claim.hypotheses {
            let parts = match compared(&hypothesis.statement) {
                Some(parts) => parts,
                None => {
                    gap = Some(Beyond::Construct("a hypothesis that is no comparison"));
                    continue;
                }
            };
            for (relation, left, right) in parts {
                match self.compare(groups, hypothesis, relation, left, right) {
                    Ok(more) => found.extend(more),
                    Err(beyond) => gap = Some(beyond),
                }
            }
        }
        (found, gap)
    }

    fn compare(
        &self,
        groups: usize,
        hypothesis: &Hypothesis,
        relation: Relation,
        left: &core::Term,
        right: &core::Term,
    ) -> Result<Vec<Compared>, Beyond> {
        let differences = self.expanding(groups, |expander| {
            let pairs = expander.value(left)?.pairs(&expander.value(right)?)?;
            let all = pairs.iter().map(|(x, y)| x.minus(y, self.work));
            all.collect::<Result<Vec<_>, _>>()
        })?;
        let source = hypothesis.source;
        let one = |difference| Compared {
            difference,
            relation,
            source,
        };
        if relation == Relation::Different && differences.len() > 1 {
            // Vectors differ where the sum of the squares of the differences is positive.
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

    /// How many entries the given equations have; nothing if one of them cannot be expanded.
    fn given_entries(&self, groups: usize) -> Option<usize> {
        let mut count = 0;
        let given = self.claim.hypotheses.iter();
        for hypothesis in given.filter(|h| h.source == Source::Given) {
            for (relation, left, right) in compared(&hypothesis.statement)? {
                let entries = self.compare(groups, hypothesis, relation, left, right);
                count += entries.ok()?.len();
            }
        }
        Some(count)
    }

    /// Everything that bounds the domain: the comparisons of the hypotheses, and the declared sets, where the symbols of the
    /// first groups have their values.
    pub fn constraints(&self, groups: usize) -> Result<(Vec<Compared>, Option<Beyond>), Beyond> {
        let (mut found, gap) = self.hypotheses(groups);
        let values = self.values(groups)?;
        for (name, set) in &self.claim.symbols {
            let symbol = Symbol::Named(Arc::clone(name));
            let own = || Polynomial::symbol(symbol.clone()).into();
            let value: Quotient = values.get(&symbol).cloned().unwrap_or_else(own);
            for (bound, relation) in self.bounds(set, &values)? {
                found.push(Compared {
                    difference: value.minus(&bound, self.work)?,
                    relation,
                    source: Source::Assume,
                });
            }
        }
        Ok((found, gap))
    }

    /// The ends of a declared set.
    fn bounds(
        &self,
        set: &Set,
        values: &BTreeMap<Symbol, Quotient>,
    ) -> Result<Vec<(Quotient, Relation)>, Beyond> {
        let mut all = vec![];
        match set {
            Set::Real(interval) => {
                let constant = |c: &torse_language::derivation::declarations::Constant| {
                    let turns = Polynomial::symbol(Symbol::Pi).scaled(&c.turns);
                    Quotient::from(turns.plus(&Polynomial::constant(c.rational.clone())))
                };
                let end = |closed: bool, with: Relation, without: Relation| match closed {
                    true => with,
                    false => without,
                };
                let lower = interval.lower.iter().map(|b| {
                    let relation = end(b.closed, Relation::AtLeast, Relation::Greater);
                    (constant(&b.value), relation)
                });
                let upper = interval.upper.iter().map(|b| {
                    let relation = end(b.closed, Relation::AtMost, Relation::Less);
                    (constant(&b.value), relation)
                });
                all.extend(lower.chain(upper));
            }
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

    /// Shows that the eliminated symbols that were met have their values wherever the conditions do not vanish.
    pub fn justified(&self) -> Result<(), Unchecked> {
        for place in (0..self.groups.len()).rev() {
            let Some(group) = self.groups.get(place) else {
                continue;
            };
            let used = |symbol: &Symbol| self.used.borrow().contains(symbol);
            if !group.values.iter().any(|d| used(&d.symbol)) {
                continue;
            }
            let (known, gap) = self.hypotheses(place);
            let determined = match &group.by {
                Determining::Given(places) => {
                    let given = known.iter().filter(|c| c.source == Source::Given).count();
                    let all = self.given_entries(place);
                    self.by_given(place, places, &known, all == Some(given))
                }
                Determining::Assumed { plainly } => self.by_one(place, *plainly, &known),
                Determining::Instance => Ok(()),
            };
            match (determined, gap) {
                // The equation may be one that was not expanded.
                (Err(Unchecked::Wrong(Wrong::Eliminated(_))), Some(gap)) => return Err(gap.into()),
                (determined, _) => determined?,
            }
        }
        Ok(())
    }

    /// A symbol by one equation.
    fn by_one(
        &self,
        place: usize,
        plainly: bool,
        known: &[Compared],
    ) -> Result<(), Unchecked> {
        let group = self.groups.get(place).ok_or(Wrong::Kind)?;
        let [determined] = group.values.as_slice() else {
            return Err(Wrong::Kind.into());
        };
        let (symbol, value) = (&determined.symbol, &determined.value);
        let wrong = || Wrong::Eliminated(symbol.to_string());
        let mut may_vanish = None;
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
            if implied || self.is_nonzero(&slope, known, place)? {
                return Ok(());
            }
            may_vanish = Some(slope);
        }
        let Some(slope) = may_vanish else {
            return Err(wrong().into());
        };
        Err(match plainly {
            true => Wrong::Divisor(slope.to_string()).into(),
            false => Beyond::Divisor(slope.to_string()).into(),
        })
    }

    /// Symbols by as many `given` equations: the values satisfy them, and the determinant is not zero.
    fn by_given(
        &self,
        level: usize,
        places: &[usize],
        known: &[Compared],
        complete: bool,
    ) -> Result<(), Unchecked> {
        let group = self.groups.get(level).ok_or(Wrong::Kind)?;
        let names: Vec<String> = group.values.iter().map(|d| d.symbol.to_string()).collect();
        let wrong = || Unchecked::from(Wrong::Eliminated(names.join(", ")));
        if !complete {
            return Err(Beyond::Construct("a given equation that cannot be expanded").into());
        }
        let given: Vec<&Compared> = known.iter().filter(|c| c.source == Source::Given).collect();
        let mut values = BTreeMap::new();
        for determined in &group.values {
            let value = Quotient::of(&determined.value, self.work)?;
            values.insert(determined.symbol.clone(), value);
        }
        let distinct: BTreeSet<&usize> = places.iter().collect();
        if distinct.len() != group.values.len() || places.len() != group.values.len() {
            return Err(wrong());
        }
        let mut rows = vec![];
        for place in places {
            let equation = given.get(*place).ok_or_else(wrong)?;
            let numerator = &equation.difference.above;
            let put = |symbol: &Symbol| values.get(symbol).cloned();
            let there = Quotient::from(numerator.clone()).replaced(&put, self.work)?;
            if equation.relation != Relation::Equal || !there.is_zero(self.work)? {
                return Err(wrong());
            }
            let mut row = vec![];
            for determined in &group.values {
                let (_, slope) = match numerator.degree_in(&determined.symbol) {
                    0 => (Polynomial::zero(), Polynomial::zero()),
                    _ => linear(numerator, &determined.symbol).ok_or_else(wrong)?,
                };
                // A slope with another of the symbols in it would be a product of two.
                let mut others = group.values.iter();
                if others.any(|other| slope.degree_in(&other.symbol) > 0) {
                    return Err(wrong());
                }
                row.push(Quotient::from(slope));
            }
            rows.push(row);
        }
        let determinant = determinant(&rows, self.work)?.above;
        match self.is_nonzero(&determinant, known, level)? {
            true => Ok(()),
            false => Err(Wrong::Divisor(determinant.to_string()).into()),
        }
    }

    /// Whether a polynomial is a product of what is known to differ from zero where the first groups have their values:
    /// numbers, conditions, divisors of terms, what hypotheses say is not zero, and symbols whose declared range does not
    /// contain zero.
    fn is_nonzero(
        &self,
        polynomial: &Polynomial,
        known: &[Compared],
        groups: usize,
    ) -> Result<bool, Beyond> {
        if self.divides(polynomial, known, groups)? {
            return Ok(true);
        }
        // The statement says nothing where a term of its own has no value.
        for term in self.claim.statement.terms() {
            let expanded = self.expanding(groups, |expander| expander.value(term));
            if expanded == Err(Beyond::Large) {
                return Err(Beyond::Large);
            }
        }
        self.divides(polynomial, known, groups)
    }

    fn divides(
        &self,
        polynomial: &Polynomial,
        known: &[Compared],
        groups: usize,
    ) -> Result<bool, Beyond> {
        use Relation::{Different, Greater, Less};
        let differs = known
            .iter()
            .filter(|c| matches!(c.relation, Different | Less | Greater));
        let mut factors: Vec<Polynomial> = self.conditions.to_vec();
        factors.extend(self.nonzero.iter().cloned());
        let divisors = self.divisors.borrow();
        factors.extend(divisors.get(&groups).into_iter().flatten().cloned());
        factors.extend(differs.map(|c| c.difference.above.clone()));
        for (name, set) in &self.claim.symbols {
            if !contains_zero(set) {
                factors.push(Polynomial::symbol(Symbol::Named(Arc::clone(name))));
            }
        }
        if polynomial.is_zero() {
            return Ok(false);
        }
        let mut rest = polynomial.clone();
        for factor in factors.iter().filter(|f| !f.is_number()) {
            self.work.spend(factor.len().saturating_mul(rest.len()))?;
            if factor.quotient(&rest).is_some() {
                return Ok(true);
            }
            while let Some(quotient) = rest.quotient(factor) {
                self.work.spend(factor.len().saturating_mul(rest.len()))?;
                rest = quotient;
            }
        }
        // A nonzero polynomial in pi and roots is a number that is not zero.
        Ok(rest.is_number())
    }

    /// Whether the denominator of a quotient of the proof is known to differ from zero.
    pub fn nonzero_here(&self, polynomial: &Polynomial) -> Result<bool, Beyond> {
        let (known, _) = self.hypotheses(self.groups.len());
        self.is_nonzero(polynomial, &known, self.groups.len())
    }
}

/// Whether zero is in a declared set, as far as its ends tell.
fn contains_zero(set: &Set) -> bool {
    match set {
        Set::Real(interval) => {
            let sign = |c: &torse_language::derivation::declarations::Constant| {
                let turns = Polynomial::symbol(Symbol::Pi).scaled(&c.turns);
                order(&turns.plus(&Polynomial::constant(c.rational.clone())))
            };
            let above = interval.lower.as_ref().is_some_and(|b| {
                sign(&b.value).is_some_and(|s| s.is_gt() || (s.is_eq() && !b.closed))
            });
            let below = interval.upper.as_ref().is_some_and(|b| {
                sign(&b.value).is_some_and(|s| s.is_lt() || (s.is_eq() && !b.closed))
            });
            !above && !below
        }
        Set::Integer { least, most } => {
            let least = least.as_ref().and_then(torse_numbers::Affine::as_number);
            let most = most.as_ref().and_then(torse_numbers::Affine::as_number);
            !(least.is_some_and(|n| n > 0) || most.is_some_and(|n| n < 0))
        }
        Set::Vector(_) | Set::Family { .. } => true,
    }
}

/// `(rest, slope)` of a polynomial that is `slope*symbol + rest`, the symbol in neither, nor under a sine.
fn linear(polynomial: &Polynomial, symbol: &Symbol) -> Option<(Polynomial, Polynomial)> {
    let inside = |own: &Symbol| own != symbol && own.variable().map(Symbol::named).as_ref() == Some(symbol);
    if polynomial.symbols().any(inside) {
        return None;
    }
    match polynomial.coefficients_in(symbol).as_slice() {
        [rest, slope] => Some((rest.clone(), slope.clone())),
        _ => None,
    }
}

/// The comparisons that a hypothesis consists of; a denied one is the opposite one.
fn compared(statement: &Statement) -> Option<Vec<(Relation, &core::Term, &core::Term)>> {
    match statement {
        Statement::Compare {
            relation,
            left,
            right,
        } => Some(vec![(*relation, left, right)]),
        Statement::Join(Connective::And, a, b) => Some([compared(a)?, compared(b)?].concat()),
        Statement::Not(inner) => match &**inner {
            Statement::Compare {
                relation,
                left,
                right,
            } => Some(vec![(relation.opposite(), left, right)]),
            _ => None,
        },
        _ => None,
    }
}
