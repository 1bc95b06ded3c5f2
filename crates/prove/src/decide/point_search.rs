//! What is looked for at a point, and the search among simple points.
//!
//! Symbols get values one after the other, simplest candidates first; a value is kept only if the difference of the two sides
//! stays a nonzero polynomial in the symbols that are left and no divisor vanishes. A nonzero polynomial has a nonzero value on
//! every grid that is fine enough, so the search goes back only where assumptions bind.

use super::candidates::{Turns, is_whole};
use super::domain::Domain;
use super::nondegenerate::make_nondegenerate;
use super::order::truth;
use super::real_symbol::RealSymbol;
use super::witness::{Point, at_point, free_symbols, placed, turns};
use torse_algebra::fault_injection::{InjectedFault, injected};
use torse_algebra::{Fraction, Symbol};
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::formula::Relation;

/// The most values tried in one search.
const MAX_TRIES: usize = 6_000;
/// The values of each symbol that are tried once more where that was not enough: of a real number without bounds one of each sign.
const FEW: usize = 5;

/// A symbol with the values that are tried for it, in this order.
type Candidates = (Symbol, Vec<Fraction>);

/// What is looked for, and where.
pub(super) struct PointSearch<'a> {
    difference: &'a Fraction,
    also: &'a [&'a Fraction],
    pub domain: &'a Domain<'a>,
    /// How the difference compares with zero at the point.
    wanted: Relation,
    /// What holds there besides.
    pub constraints: Vec<(Fraction, Relation)>,
    /// The symbols that get values; roots and logarithms, which the others determine, last.
    pub symbols: Vec<Symbol>,
    turns: Vec<Turns>,
}

impl<'a> PointSearch<'a> {
    pub fn new(
        difference: &'a Fraction,
        also: &'a [&'a Fraction],
        domain: &'a Domain<'a>,
        wanted: Relation,
    ) -> Option<Self> {
        let mut constraints: Vec<(Fraction, Relation)> = domain
            .constraints
            .iter()
            .chain(&domain.defined)
            .filter(|_| !injected(InjectedFault::WitnessAnywhere))
            .map(|c| (c.value.clone(), c.relation))
            .collect();
        let recorded = also.iter().flat_map(|f| f.conditions());
        let divisors = domain
            .pivots()
            .iter()
            .chain(&domain.divisors)
            .chain(recorded);
        constraints.extend(divisors.map(|p| (p.clone().into(), Relation::Different)));
        let mut everything = vec![difference];
        everything.extend(also);
        everything.extend(constraints.iter().map(|(value, _)| value));
        everything.extend(domain.solved().iter().map(|(_, value)| value));
        let mut symbols = free_symbols(&everything);
        let symbolic = |s: &Symbol| matches!(s, Symbol::Indexed(_, index) if index.iter().any(|i| i.as_number().is_none()));
        if symbols.iter().any(symbolic) {
            return None;
        }
        bounding_integers(&mut symbols, domain);
        symbols.sort_by_key(|symbol| domain.is_implicit(symbol));
        let turns = symbols.iter().map(|s| turns(&everything, s)).collect();
        Some(Self {
            difference,
            also,
            domain,
            wanted,
            turns,
            symbols,
            constraints,
        })
    }

    /// A point of simple values, without those of eliminated symbols.
    pub fn simple(&self, first: Option<(&RealSymbol, &Fraction)>) -> Option<Point> {
        let own = |(symbol, turns): (&Symbol, &Turns)| -> Candidates {
            let mut values = self.domain.candidates(symbol, *turns);
            if *turns != Turns::None {
                // Where sines and cosines are exact first, also those that the difference does not have any more.
                values.sort_by_key(|at| self.also.iter().any(|f| placed(f, symbol, at).is_none()));
            }
            if let Some((own, value)) = first
                && own.symbol() == symbol
                && self.domain.admits(own, value)
            {
                values.insert(0, value.clone());
            }
            (symbol.clone(), values)
        };
        let candidates: Vec<Candidates> = self.symbols.iter().zip(&self.turns).map(own).collect();
        self.walked(&candidates).or_else(|| {
            // Where the first symbols have many values, the last ones get no turn.
            let few = candidates.iter().map(|(symbol, values)| {
                let few = values.iter().take(FEW).cloned();
                (symbol.clone(), few.collect())
            });
            self.walked(&few.collect::<Vec<_>>())
        })
    }

    fn walked(&self, candidates: &[Candidates]) -> Option<Point> {
        let mut walk = Walk {
            search: self,
            tries: 0,
            point: Point::new(),
        };
        let found = walk.run(self.difference.clone(), &self.constraints, candidates);
        found.then_some(walk.point)
    }

    /// The point made non-degenerate, with the values of eliminated symbols.
    pub fn finished(&self, point: Point) -> Option<Point> {
        let fails = |point: &Point| self.accepts(point);
        let mut point = make_nondegenerate(point, self.domain.declarations, &fails);
        for (symbol, value) in self.domain.solved() {
            let value = at_point(value, &point)?;
            point.insert(symbol.clone(), value);
        }
        Some(point)
    }

    /// Whether a point with values for all symbols is one of those that are looked for.
    pub fn accepts(&self, point: &Point) -> bool {
        let settled = |(value, relation): (&Fraction, Relation)| {
            at_point(value, point).is_some_and(|value| truth(&value, relation) == Some(true))
        };
        let met = |(value, relation): &(Fraction, Relation)| settled((value, *relation));
        settled((self.difference, self.wanted))
            && self.constraints.iter().all(met)
            && self.integers_in_range(point)
    }

    /// The difference with the relation to zero that is wanted.
    pub const fn goal(&self) -> (&'a Fraction, Relation) {
        (self.difference, self.wanted)
    }

    /// Whether every integer of the point, also one that is eliminated, is an integer and respects its bounds, which may name
    /// others.
    fn integers_in_range(&self, point: &Point) -> bool {
        let mut all = point.clone();
        all.extend(self.domain.chosen.iter().cloned());
        for (symbol, value) in self.domain.solved() {
            let Some(value) = at_point(value, point) else {
                return false;
            };
            all.insert(symbol.clone(), value);
        }
        all.iter().all(|(symbol, at)| {
            let Symbol::Named(name) = symbol else {
                return true;
            };
            let Some(SymbolKind::Integer { least, most }) = self.domain.declarations.symbol(name)
            else {
                return true;
            };
            let bound = |form: &Option<torse_algebra::Affine>, relation: Relation| {
                form.as_ref().is_none_or(|form| {
                    let value: Fraction = crate::evaluate::series::polynomial_of(form).into();
                    at_point(&value, &all)
                        .is_some_and(|value| truth(&(at.clone() - value), relation) == Some(true))
                })
            };
            is_whole(at) && bound(least, Relation::AtLeast) && bound(most, Relation::AtMost)
        })
    }
}

/// Adds the integers in whose terms the ranges of others are declared.
fn bounding_integers(symbols: &mut Vec<Symbol>, domain: &Domain<'_>) {
    let mut place = 0;
    while let Some(symbol) = symbols.get(place).cloned() {
        place += 1;
        let Symbol::Named(name) = symbol else {
            continue;
        };
        let Some(SymbolKind::Integer { least, most }) = domain.declarations.symbol(&name) else {
            continue;
        };
        for form in least.iter().chain(most) {
            for (other, _) in form.multiples() {
                let other = Symbol::named(other);
                let mut values = domain.solved().iter().chain(&domain.chosen);
                if !values.any(|(s, _)| *s == other) && !symbols.contains(&other) {
                    // Parameters come before points.
                    symbols.insert(0, other);
                    place += 1;
                }
            }
        }
    }
}

/// The values that were tried so far, and the point that they make.
struct Walk<'s, 'a> {
    search: &'s PointSearch<'a>,
    tries: usize,
    point: Point,
}

impl Walk<'_, '_> {
    fn run(
        &mut self,
        value: Fraction,
        constraints: &[(Fraction, Relation)],
        left: &[Candidates],
    ) -> bool {
        let wanted = self.search.wanted;
        if value.is_zero()
            && matches!(
                wanted,
                Relation::Different | Relation::Less | Relation::Greater
            )
        {
            return false;
        }
        let Some(((symbol, values), rest)) = left.split_first() else {
            // An unsettled sign is no point of the domain.
            let settled = |(c, relation): &(Fraction, Relation)| truth(c, *relation) == Some(true);
            return truth(&value, wanted) == Some(true)
                && constraints.iter().all(settled)
                && self.search.integers_in_range(&self.point);
        };
        // A constraint that has become a number must hold.
        let fails = |(c, relation): &(Fraction, Relation)| truth(c, *relation) == Some(false);
        if constraints.iter().any(fails) {
            return false;
        }
        let domain = self.search.domain;
        let own = match domain.is_implicit(symbol) {
            true => domain.implicit_values(symbol, constraints),
            false => values.clone(),
        };
        for at in &own {
            self.tries += 1;
            if self.tries > MAX_TRIES {
                return false;
            }
            let Some(next) = placed(&value, symbol, at) else {
                continue;
            };
            let moved: Option<Vec<(Fraction, Relation)>> = constraints
                .iter()
                .map(|(c, r)| Some((placed(c, symbol, at)?, *r)))
                .collect();
            let Some(moved) = moved else {
                continue;
            };
            let admitted = !moved.iter().any(fails);
            self.point.insert(symbol.clone(), at.clone());
            if self.run(next, &moved, rest) {
                return true;
            }
            self.point.remove(symbol);
            // Another value would change nothing.
            if admitted && !self.matters(symbol, &value, constraints) {
                return false;
            }
        }
        false
    }

    /// Whether more than its own range hangs on the value of a symbol.
    fn matters(
        &self,
        symbol: &Symbol,
        value: &Fraction,
        constraints: &[(Fraction, Relation)],
    ) -> bool {
        let ties = |(c, _): &(Fraction, Relation)| {
            let own = free_symbols(&[c]);
            own.len() > 1 && own.contains(symbol)
        };
        self.search.domain.is_integer(symbol)
            || self.search.domain.is_implicit(symbol)
            || free_symbols(&[value]).contains(symbol)
            || constraints.iter().any(ties)
    }
}
