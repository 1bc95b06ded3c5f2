//! Where a statement is meant to hold: the declared ranges of its symbols and its assumptions.

pub mod branch;

use crate::decide::interval::{Bound, Interval, Part};
use crate::decide::logarithm::Logarithm;
use crate::decide::open_arc::OpenArc;
use crate::decide::order::order;
use crate::decide::root::Root;
use std::cmp::Ordering;
use torse_algebra::fault_injection::{InjectedFault, injected};
use torse_algebra::rational::integer;
use torse_algebra::{Affine, Fraction, Polynomial, Symbol};
use torse_certificate::number::holds;
use torse_syntax::derivation::declarations::{Declarations, SymbolKind};
use torse_syntax::formula::Relation;

/// The most terms of two polynomials whose common factors are looked for.
const MAX_COMMON_TERMS: usize = 8;

/// A condition `value relation 0` from the assumptions.
#[derive(Debug, Clone)]
pub struct Constraint {
    /// The quantity compared with zero.
    pub value: Fraction,
    /// How.
    pub relation: Relation,
}

impl Constraint {
    /// The constraint as `symbol relation number`, if it is linear in this symbol and says nothing of another. The number
    /// may contain pi and square roots.
    #[must_use]
    pub fn bound_of(&self, symbol: &Symbol) -> Option<(Relation, Fraction)> {
        let value = self.value.as_polynomial()?;
        let known = |s: &Symbol| s == symbol || s.is_number();
        if !value.symbols().contains(symbol) || !value.symbols().iter().all(known) {
            return None;
        }
        let (mut slope, mut constant) = (Polynomial::zero(), Polynomial::zero());
        for term in value.terms() {
            let mut own = false;
            let mut number = Polynomial::constant(&term.coefficient);
            for (factor, exponent) in &term.powers {
                match factor {
                    factor if factor.is_number() => {
                        let power =
                            Polynomial::symbol((*factor).clone()).power(u32::from(*exponent));
                        number = &number * &power;
                    }
                    factor if *factor == symbol && *exponent == 1 => own = true,
                    _ => return None,
                }
            }
            let part = if own { &mut slope } else { &mut constant };
            *part = &*part + &number;
        }
        let slope = Fraction::from(slope);
        let relation = match order(&slope)? {
            Ordering::Equal => return None,
            Ordering::Greater if injected(InjectedFault::BoundReversed) => self.relation.mirrored(),
            Ordering::Less => self.relation.mirrored(),
            Ordering::Greater => self.relation,
        };
        let number = Fraction::from(-constant).over(&slope).ok()?;
        Some((relation, number.without_conditions()))
    }
}

/// The domain of a statement.
#[derive(Debug, Clone)]
pub struct Domain<'a> {
    /// The ranges.
    pub declarations: &'a Declarations,
    /// The hypotheses that eliminated no symbol, and what eliminated symbols left behind.
    pub constraints: Vec<Constraint>,
    /// The symbols whose values were chosen before anything was evaluated: integers of an instance.
    pub chosen: Vec<(Symbol, Fraction)>,
    /// The eliminated symbols with their values.
    solved: Vec<(Symbol, Fraction)>,
    /// Factors by which an elimination divided and that may vanish, with all later values substituted. None is zero at the
    /// points of this domain ([`branch::Branch::splits`]).
    pivots: Vec<Polynomial>,
    /// Divisors of the statement: it says nothing where one vanishes, so no point there refutes it.
    pub divisors: Vec<Polynomial>,
    /// Conditions, besides nonzero divisors, under which the terms of the statement are defined: indices within their ranges.
    pub defined: Vec<Constraint>,
    /// The roots that have no value in other symbols, those first of which others are made.
    pub roots: Vec<Root>,
    /// The logarithms that have no value in other symbols, those first of which others are made.
    pub logarithms: Vec<Logarithm>,
    /// The arcs that have no value in other symbols, those first of which others are made.
    pub arcs: Vec<OpenArc>,
    /// The roots that were found to be positive, in this order, each with its radicand as it was then.
    pub positive_roots: Vec<(Symbol, Polynomial)>,
    /// The part of the domain that is looked at, see [`Domain::parts`].
    pub part: Vec<Part>,
}

impl<'a> Domain<'a> {
    /// The declared ranges alone.
    #[must_use]
    pub fn new(declarations: &'a Declarations) -> Self {
        Self {
            declarations,
            constraints: vec![],
            chosen: vec![],
            solved: vec![],
            pivots: vec![],
            divisors: vec![],
            defined: vec![],
            roots: vec![],
            logarithms: vec![],
            arcs: vec![],
            positive_roots: vec![],
            part: vec![],
        }
    }

    /// The same hypotheses on other ranges.
    #[must_use]
    pub fn on<'b>(&self, declarations: &'b Declarations) -> Domain<'b> {
        Domain {
            declarations,
            constraints: self.constraints.clone(),
            chosen: self.chosen.clone(),
            solved: self.solved.clone(),
            pivots: self.pivots.clone(),
            divisors: self.divisors.clone(),
            defined: self.defined.clone(),
            roots: self.roots.clone(),
            logarithms: self.logarithms.clone(),
            arcs: self.arcs.clone(),
            positive_roots: self.positive_roots.clone(),
            part: self.part.clone(),
        }
    }
}

/// The polynomial with the value of a symbol put in.
fn put(polynomial: Polynomial, (symbol, value): &(Symbol, Polynomial)) -> Polynomial {
    polynomial.substituted(|own| (own == symbol).then(|| value.clone()))
}

/// The value that a symbol has where a polynomial is zero: of one whose power it is, or in which it is linear with a number before it.
fn value_at_zero(polynomial: &Polynomial) -> Option<(Symbol, Polynomial)> {
    if let ([symbol], 1) = (polynomial.symbols(), polynomial.len()) {
        return Some((symbol.clone(), Polynomial::zero()));
    }
    let mut symbols = polynomial.symbols().iter();
    symbols.find_map(
        |symbol| match polynomial.coefficients_in(symbol).as_slice() {
            [rest, slope] => {
                let slope = slope.as_constant()?;
                Some((symbol.clone(), rest.scaled(&-slope.recip())))
            }
            _ => None,
        },
    )
}

/// A closed end at an integer.
fn closed(n: i64) -> Option<Bound> {
    Some(Bound {
        value: Fraction::integer(n),
        closed: true,
    })
}

impl Domain<'_> {
    /// The eliminated symbols with their values. [`branch::Branch::solve`] alone adds one.
    #[must_use]
    pub fn solved(&self) -> &[(Symbol, Fraction)] {
        &self.solved
    }

    /// The divisors of eliminations that may vanish; they do not at the points of this domain.
    #[must_use]
    pub fn pivots(&self) -> &[Polynomial] {
        &self.pivots
    }

    /// The same, where only the first of the roots that were found to be positive are known to be. Every other constraint keeps
    /// its place.
    pub(crate) fn with_positive_roots(&self, first: usize) -> Self {
        let mut weaker = self.clone();
        for (symbol, _) in self.positive_roots.iter().skip(first) {
            let own = Polynomial::symbol(symbol.clone());
            let constraints = weaker.constraints.iter_mut();
            for says_positive in constraints.filter(|c| {
                c.relation == Relation::Greater && c.value.as_polynomial() == Some(&own)
            }) {
                // 1 differs from 0 everywhere.
                says_positive.value = Fraction::integer(1);
                says_positive.relation = Relation::Different;
            }
        }
        weaker
    }

    /// The interval in which a symbol is declared to live, whatever is assumed; integers from their bounds.
    #[must_use]
    pub fn declared(&self, name: &str) -> Interval {
        match self.declarations.symbol(name) {
            Some(SymbolKind::Real(interval)) => Interval::from(&**interval),
            Some(SymbolKind::Integer { .. }) => {
                let form = Affine::symbol(name);
                Interval {
                    lower: self.declarations.least(&form).and_then(closed),
                    upper: self.declarations.greatest(&form).and_then(closed),
                }
            }
            _ => Interval::default(),
        }
    }

    /// The interval in which a symbol lives: the declared one, narrowed by what is assumed of the symbol alone
    /// (`2*a - 2 > 0` says that a > 1), or the part of it that is looked at.
    #[must_use]
    pub fn interval(&self, symbol: &Symbol) -> Interval {
        match symbol {
            Symbol::Named(name) => {
                let part = self.part.iter().rev().find(|(own, _)| own == symbol);
                if let Some((_, interval)) = part {
                    return interval.clone();
                }
                let mut interval = self.declared(name);
                for constraint in &self.constraints {
                    if let Some((relation, number)) = constraint.bound_of(symbol) {
                        interval.narrow(relation, &number);
                    }
                }
                interval
            }
            Symbol::Sin(name, angle) => self.range_of_turn(name, *angle, true),
            Symbol::Cos(name, angle) => self.range_of_turn(name, *angle, false),
            Symbol::Exp(exponent) => self.range_of_power(exponent),
            Symbol::Indexed(..)
            | Symbol::Root(_)
            | Symbol::Log(_)
            | Symbol::Arc(..)
            | Symbol::Pi => Interval::default(),
        }
    }

    /// Whether a symbol is an integer.
    #[must_use]
    pub fn is_integer(&self, symbol: &Symbol) -> bool {
        matches!(symbol, Symbol::Named(name)
            if matches!(self.declarations.symbol(name), Some(SymbolKind::Integer { .. })))
    }

    /// Whether the assumptions imply that this polynomial is not zero: it is, up to a constant, a product
    /// of factors of quantities that are assumed to be different from zero.
    #[must_use]
    pub fn assumes_nonzero(&self, polynomial: &Polynomial) -> bool {
        !polynomial.is_zero() && self.without_assumed(polynomial).as_constant().is_some()
    }

    /// Whether the assumptions imply that these polynomials are not all zero: one of them consists of factors of a quantity that is
    /// assumed to be different from zero, or an assumption fails with the values that symbols have where the polynomials are zero, as
    /// far as these are seen: `y + z >= 1` where y and z are.
    #[must_use]
    pub fn excludes_common_zero(&self, polynomials: &[&Polynomial]) -> bool {
        use Relation::{Different, Greater, Less};
        let mut values: Vec<(Symbol, Polynomial)> = vec![];
        for polynomial in polynomials {
            let left = values.iter().fold((*polynomial).clone(), put);
            if let Some(value) = value_at_zero(&left) {
                for (_, earlier) in &mut values {
                    *earlier = put(earlier.clone(), &value);
                }
                values.push(value);
            }
        }
        self.constraints.iter().any(|constraint| {
            let quantity = constraint.value.numerator();
            let there = values.iter().fold(quantity.clone(), put);
            let is_whole = constraint.value.as_polynomial().is_some();
            if let (true, Some(number)) = (is_whole, there.as_constant())
                && !holds(number.cmp(&integer(0)), constraint.relation)
            {
                return true;
            }
            if !matches!(constraint.relation, Different | Less | Greater) {
                return false;
            }
            let is_made_of = |p: &&Polynomial| {
                let mut rest = (*p).clone();
                while rest.as_constant().is_none() {
                    match rest.exact_quotient(&rest.gcd(quantity)) {
                        Some(quotient) if quotient != rest => rest = quotient,
                        _ => return false,
                    }
                }
                !rest.is_zero()
            };
            polynomials.iter().any(is_made_of) || there.is_zero()
        })
    }

    /// The polynomial without the factors that are assumed to be different from zero; 1 where it divides such a quantity.
    #[must_use]
    pub fn without_assumed(&self, polynomial: &Polynomial) -> Polynomial {
        if polynomial.is_zero() {
            return polynomial.clone();
        }
        let mut rest = polynomial.clone();
        for constraint in &self.constraints {
            if !matches!(
                constraint.relation,
                Relation::Different | Relation::Less | Relation::Greater
            ) {
                continue;
            }
            let assumed = constraint.value.numerator();
            if assumed.exact_quotient(&rest).is_some() {
                return Polynomial::integer(1);
            }
            if assumed.as_constant().is_some() {
                continue;
            }
            while !rest.is_zero()
                && let Some(quotient) = rest.exact_quotient(assumed)
            {
                rest = quotient;
            }
            // What both have in common is a factor of what is not zero: of `x^2 + x` and `x*y` it is x.
            if assumed.len().max(rest.len()) <= MAX_COMMON_TERMS {
                loop {
                    let common = rest.gcd(assumed);
                    let divided = match common.as_constant() {
                        Some(_) => None,
                        None => rest.exact_quotient(&common),
                    };
                    let Some(quotient) = divided else { break };
                    rest = quotient;
                }
            }
        }
        rest
    }
}
