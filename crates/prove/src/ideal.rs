//! Equations that follow from several others: membership in an ideal, with the multipliers.
//!
//! A difference d is zero wherever the equations `f_i = 0` hold if it is `sum l_i f_i` with polynomials l_i. These are found
//! by dividing d by the leading terms of the f_i, and by combinations of two of them whose leading terms cancel (Buchberger's
//! algorithm, Cox, Little and O'Shea, *Ideals, Varieties, and Algorithms*, chapter 2). What is made of the f_i keeps its
//! multipliers, so the search may stop early, and relations between the symbols that it does not know cost it proofs
//! and nothing else: in the end the sum is multiplied out in the algebra and has to be d.

use num_traits::Zero;
use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};
use torse_algebra::{Polynomial, Rational, Symbol, rational};

/// The most products of terms.
const MAX_WORK: usize = 60_000;
/// The most equations, given and made.
const MAX_EQUATIONS: usize = 20;
/// More symbols than this are not looked at.
const MAX_SYMBOLS: usize = 40;

/// The exponents of the symbols, ordered by total degree, then lexicographically.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Monomial(Vec<u16>);

impl Monomial {
    fn degree(&self) -> u32 {
        self.0.iter().map(|e| u32::from(*e)).sum()
    }

    /// What the other one has to be multiplied by to make this one.
    fn over(&self, other: &Self) -> Option<Self> {
        let pairs = self.0.iter().zip(&other.0);
        pairs
            .map(|(a, b)| a.checked_sub(*b))
            .collect::<Option<_>>()
            .map(Self)
    }

    fn times(&self, other: &Self) -> Option<Self> {
        let pairs = self.0.iter().zip(&other.0);
        pairs
            .map(|(a, b)| a.checked_add(*b))
            .collect::<Option<_>>()
            .map(Self)
    }

    fn least_common_multiple(&self, other: &Self) -> Self {
        Self(
            self.0
                .iter()
                .zip(&other.0)
                .map(|(a, b)| *a.max(b))
                .collect(),
        )
    }

    fn has_nothing_of(&self, other: &Self) -> bool {
        self.0.iter().zip(&other.0).all(|(a, b)| *a == 0 || *b == 0)
    }
}

impl Ord for Monomial {
    fn cmp(&self, other: &Self) -> Ordering {
        let degree = self.degree().cmp(&other.degree());
        degree.then_with(|| self.0.cmp(&other.0))
    }
}

impl PartialOrd for Monomial {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// A polynomial by its terms, the leading one last.
type Terms = BTreeMap<Monomial, Rational>;

/// A combination of the equations.
#[derive(Clone)]
struct Element {
    terms: Terms,
    /// The multipliers of the equations that make it.
    row: Vec<Terms>,
}

/// The multipliers of the equations whose sum of products is the polynomial, if they are found.
///
/// ```
/// use torse_algebra::Polynomial;
/// use torse_prove::ideal::multipliers;
/// let name = Polynomial::named;
/// let (x, y, z) = (name("x"), name("y"), name("z"));
/// // x y = 1 and x z = 1 make x (y - z) = 0, and y - z = 0 with that.
/// let equations = [&(&x * &y) - &Polynomial::integer(1), &(&x * &z) - &Polynomial::integer(1)];
/// let difference = &y - &z;
/// let found = multipliers(&difference, &equations).expect("y is z");
/// let sum = &(&found[0] * &equations[0]) + &(&found[1] * &equations[1]);
/// assert_eq!(sum, difference);
/// assert!(multipliers(&(&y + &z), &equations).is_none());
/// ```
#[must_use]
pub fn multipliers(difference: &Polynomial, equations: &[Polynomial]) -> Option<Vec<Polynomial>> {
    let all = std::iter::once(difference).chain(equations);
    let symbols: BTreeSet<&Symbol> = all.flat_map(|p| p.symbols()).collect();
    let symbols: Vec<&Symbol> = symbols.into_iter().collect();
    if symbols.len() > MAX_SYMBOLS || equations.len() > MAX_EQUATIONS {
        return None;
    }
    let search = Search {
        symbols: &symbols,
        count: equations.len(),
    };
    let row = search.row(difference, equations)?;
    let row: Vec<Polynomial> = row.iter().map(|terms| search.polynomial(terms)).collect();
    let products = row.iter().zip(equations).map(|(l, f)| l * f);
    let sum = products.fold(Polynomial::zero(), |sum, product| &sum + &product);
    (sum == *difference).then_some(row)
}

struct Search<'s> {
    symbols: &'s [&'s Symbol],
    count: usize,
}

impl Search<'_> {
    fn terms(&self, polynomial: &Polynomial) -> Terms {
        let exponents = |powers: &[(&Symbol, u16)]| {
            let of = |symbol: &&Symbol| {
                let found = powers.iter().find(|(s, _)| s == symbol);
                found.map_or(0, |(_, exponent)| *exponent)
            };
            Monomial(self.symbols.iter().map(of).collect())
        };
        let terms = polynomial.terms();
        terms
            .map(|t| (exponents(&t.powers), t.coefficient))
            .collect()
    }

    fn polynomial(&self, terms: &Terms) -> Polynomial {
        let term = |(monomial, coefficient): (&Monomial, &Rational)| {
            let factors = self.symbols.iter().zip(&monomial.0);
            factors.fold(Polynomial::constant(coefficient), |product, (s, e)| {
                let symbol = Polynomial::symbol((*s).clone());
                (0..*e).fold(product, |product, _| &product * &symbol)
            })
        };
        let terms = terms.iter().map(term);
        terms.fold(Polynomial::zero(), |sum, term| &sum + &term)
    }

    fn row(&self, difference: &Polynomial, equations: &[Polynomial]) -> Option<Vec<Terms>> {
        let mut work = MAX_WORK;
        let unit = |place: usize| {
            let one = (Monomial(vec![0; self.symbols.len()]), rational::integer(1));
            let mut row = vec![Terms::new(); self.count];
            if let Some(slot) = row.get_mut(place) {
                slot.extend([one]);
            }
            row
        };
        let mut basis: Vec<Element> = vec![];
        for (place, equation) in equations.iter().enumerate() {
            let (terms, row) = (self.terms(equation), unit(place));
            if !terms.is_empty() {
                basis.push(Element { terms, row });
            }
        }
        let mut target = Element {
            terms: self.terms(difference),
            row: vec![Terms::new(); self.count],
        };
        let mut pairs: BTreeSet<(u32, usize, usize)> = BTreeSet::new();
        for later in 0..basis.len() {
            pairs.extend(new_pairs(&basis, later));
        }
        loop {
            reduce(&mut target, &basis, &mut work)?;
            if target.terms.is_empty() {
                // The target is what was subtracted.
                let negative = |terms: Terms| terms.into_iter().map(|(m, c)| (m, -c)).collect();
                return Some(target.row.into_iter().map(negative).collect());
            }
            loop {
                let (_, first, second) = pairs.pop_first()?;
                let mut made = cancelled(basis.get(first)?, basis.get(second)?, &mut work)?;
                reduce(&mut made, &basis, &mut work)?;
                if made.terms.is_empty() {
                    continue;
                }
                if basis.len() >= MAX_EQUATIONS {
                    return None;
                }
                basis.push(made);
                pairs.extend(new_pairs(&basis, basis.len() - 1));
                break;
            }
        }
    }
}

/// The pairs of an element with those before it whose leading terms have something in common, those of low degree first.
fn new_pairs(basis: &[Element], later: usize) -> Vec<(u32, usize, usize)> {
    let lead = |place: usize| basis.get(place)?.terms.keys().next_back();
    let pair = |earlier: usize| {
        let (a, b) = (lead(earlier)?, lead(later)?);
        let degree = a.least_common_multiple(b).degree();
        (!a.has_nothing_of(b)).then_some((degree, earlier, later))
    };
    (0..later).filter_map(pair).collect()
}

/// Subtracts multiples of the basis until the leading term is divisible by none of theirs. `None` without work left.
fn reduce(element: &mut Element, basis: &[Element], work: &mut usize) -> Option<()> {
    while let Some((lead, coefficient)) = element.terms.last_key_value() {
        let by = basis.iter().find_map(|by| {
            let (own, divisor) = by.terms.last_key_value()?;
            Some((by, lead.over(own)?, coefficient / divisor))
        });
        let Some((by, monomial, factor)) = by else {
            return Some(());
        };
        subtract(element, by, &monomial, &factor, work)?;
    }
    Some(())
}

/// The combination of two elements in which their leading terms cancel.
fn cancelled(a: &Element, b: &Element, work: &mut usize) -> Option<Element> {
    let (lead_a, of_a) = a.terms.last_key_value()?;
    let (lead_b, of_b) = b.terms.last_key_value()?;
    let common = lead_a.least_common_multiple(lead_b);
    let mut made = Element {
        terms: Terms::new(),
        row: vec![Terms::new(); a.row.len()],
    };
    subtract(&mut made, a, &common.over(lead_a)?, &-of_a.recip(), work)?;
    subtract(&mut made, b, &common.over(lead_b)?, &of_b.recip(), work)?;
    Some(made)
}

/// Subtracts a multiple of another element, in the terms and in the multipliers.
fn subtract(
    from: &mut Element,
    other: &Element,
    monomial: &Monomial,
    factor: &Rational,
    work: &mut usize,
) -> Option<()> {
    let rows = from.row.iter_mut().zip(&other.row);
    for (terms, others) in std::iter::once((&mut from.terms, &other.terms)).chain(rows) {
        *work = work.checked_sub(others.len())?;
        for (m, c) in others {
            let product = m.times(monomial)?;
            let share = c * factor;
            let sum = match terms.remove(&product) {
                Some(before) => before - share,
                None => -share,
            };
            if !sum.is_zero() {
                terms.insert(product, sum);
            }
        }
    }
    Some(())
}
