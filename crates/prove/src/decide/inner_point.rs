//! Points of what linear hypotheses leave, for statements about many symbols that hypotheses tie to each other.
//!
//! A first point comes from linear programming, off every strict hypothesis; where the statement is linear too, its failure is
//! one more constraint. Others come from the first by moving one symbol at a time within the interval that the others leave it,
//! in a fixed order: what is linear stays true, and the rest is tried.

use super::candidates::simplest_between;
use super::point_search::PointSearch;
use super::simplex::Tableau;
use super::witness::Point;
use num_traits::{Signed, Zero};
use torse_algebra::rational::{integer, ratio};
use torse_algebra::{Fraction, Rational, Symbol};
use torse_syntax::formula::Relation;

/// The most symbols, and the most terms of what fails, that are looked at.
const MAX_SYMBOLS: usize = 24;
const MAX_TERMS: usize = 60;
/// How often each symbol is moved.
const MAX_ROUNDS: usize = 30;
/// The parts of an interval in which a symbol is placed, and its distances from the end of one that has a single end.
const PARTS: [[(i64, i64); 2]; 5] = [
    [(1, 3), (2, 3)],
    [(0, 1), (1, 10)],
    [(9, 10), (1, 1)],
    [(1, 10), (1, 3)],
    [(2, 3), (9, 10)],
];
const DISTANCES: [[(i64, i64); 2]; 5] = [
    [(1, 2), (3, 2)],
    [(90, 1), (110, 1)],
    [(1, 110), (1, 90)],
    [(9, 1), (11, 1)],
    [(1, 11), (1, 9)],
];

/// A point at which the search succeeds, in the interior of what linear hypotheses leave.
pub(super) fn find(search: &PointSearch<'_>) -> Option<Point> {
    let polytope = Polytope::new(search)?;
    let (difference, wanted) = search.goal();
    if difference.numerator().len() > MAX_TERMS {
        return None;
    }
    let sides: &[Relation] = match wanted {
        Relation::Different => &[Relation::Less, Relation::Greater],
        _ => std::slice::from_ref(&wanted),
    };
    let mut is_linear = false;
    for side in sides {
        let Some(failure) = polytope.form(difference, *side) else {
            continue;
        };
        is_linear = true;
        let mut forms = polytope.forms.clone();
        forms.push(failure);
        if let Some(values) = inner(&forms, polytope.symbols.len()) {
            let point = polytope.point(&values);
            if search.accepts(&point) {
                return Some(point);
            }
        }
    }
    if is_linear {
        return None;
    }
    let mut values = inner(&polytope.forms, polytope.symbols.len())?;
    for round in 0..MAX_ROUNDS {
        for symbol in 0..values.len() {
            let moved = polytope.moved(&values, symbol, round * 3 + symbol * (round + 1));
            if let (Some(moved), Some(slot)) = (moved, values.get_mut(symbol)) {
                *slot = moved;
                let point = polytope.point(&values);
                if search.accepts(&point) {
                    return Some(point);
                }
            }
        }
    }
    None
}

/// A linear form that is zero, at least zero, or more than zero.
#[derive(Clone)]
struct Form {
    /// The multiples of the symbols, in their order.
    multiples: Vec<Rational>,
    constant: Rational,
    relation: Relation,
}

/// What the linear hypotheses leave.
struct Polytope<'s> {
    symbols: &'s [Symbol],
    /// [`Relation::Equal`], [`Relation::AtLeast`] and [`Relation::Greater`] alone.
    forms: Vec<Form>,
}

impl<'s> Polytope<'s> {
    /// The polytope of a search; none if some symbol takes other values than rational ones, or nothing ties two symbols.
    fn new(search: &'s PointSearch<'_>) -> Option<Self> {
        let domain = search.domain;
        let is_plain = |symbol: &Symbol| !domain.is_integer(symbol) && !domain.is_implicit(symbol);
        if search.symbols.len() > MAX_SYMBOLS || !search.symbols.iter().all(is_plain) {
            return None;
        }
        let mut polytope = Self {
            symbols: &search.symbols,
            forms: vec![],
        };
        for (value, relation) in &search.constraints {
            polytope.forms.extend(polytope.form(value, *relation));
        }
        let ties = |form: &Form| form.multiples.iter().filter(|own| !own.is_zero()).count() > 1;
        if !polytope.forms.iter().any(ties) {
            return None;
        }
        for symbol in &search.symbols {
            let interval = domain.interval(symbol);
            for (end, open, closed) in [
                (interval.lower, Relation::Greater, Relation::AtLeast),
                (interval.upper, Relation::Less, Relation::AtMost),
            ] {
                let Some(end) = end else { continue };
                let relation = if end.closed { closed } else { open };
                let difference = Fraction::symbol(symbol.clone()) - end.value;
                polytope.forms.extend(polytope.form(&difference, relation));
            }
        }
        Some(polytope)
    }

    /// What says that a value has this relation to zero, if that is linear.
    fn form(&self, value: &Fraction, relation: Relation) -> Option<Form> {
        let polynomial = value.as_polynomial()?;
        let mut form = Form {
            multiples: vec![integer(0); self.symbols.len()],
            constant: integer(0),
            relation,
        };
        for term in polynomial.terms() {
            match term.powers.as_slice() {
                [] => form.constant = term.coefficient,
                [(symbol, 1)] => {
                    let place = self.symbols.iter().position(|own| own == *symbol)?;
                    *form.multiples.get_mut(place)? = term.coefficient;
                }
                _ => return None,
            }
        }
        match relation {
            Relation::Equal | Relation::AtLeast | Relation::Greater => {}
            Relation::Less | Relation::AtMost => {
                form.multiples
                    .iter_mut()
                    .for_each(|own| *own = -own.clone());
                form.constant = -form.constant;
                form.relation = relation.mirrored();
            }
            Relation::Different => return None,
        }
        let has_symbol = form.multiples.iter().any(|own| !own.is_zero());
        has_symbol.then_some(form)
    }

    fn point(&self, values: &[Rational]) -> Point {
        let values = values.iter().map(|value| Fraction::from(value.clone()));
        self.symbols.iter().cloned().zip(values).collect()
    }

    /// Another value of a symbol in the interval that the others leave it; none if an equation fixes it.
    fn moved(&self, values: &[Rational], symbol: usize, choice: usize) -> Option<Rational> {
        let (mut lower, mut upper): (Option<Rational>, Option<Rational>) = (None, None);
        for form in &self.forms {
            let multiple = form.multiples.get(symbol)?;
            if multiple.is_zero() {
                continue;
            }
            if form.relation == Relation::Equal {
                return None;
            }
            let all = form.multiples.iter().zip(values);
            let sum: Rational = all.map(|(multiple, value)| multiple * value).sum();
            let end = values.get(symbol)? - (sum + &form.constant) / multiple;
            if multiple.is_positive() {
                lower = Some(lower.map_or(end.clone(), |own| own.max(end)));
            } else {
                upper = Some(upper.map_or(end.clone(), |own| own.min(end)));
            }
        }
        let part = |list: &[[(i64, i64); 2]; 5]| -> Option<[Rational; 2]> {
            let [from, to] = list.get(choice % list.len())?;
            Some([ratio(from.0, from.1)?, ratio(to.0, to.1)?])
        };
        match (lower, upper) {
            (Some(low), Some(high)) => {
                let ([from, to], width) = (part(&PARTS)?, &high - &low);
                simplest_between(&(&low + from * &width), &(&low + to * &width))
            }
            (Some(low), None) => {
                let [from, to] = part(&DISTANCES)?;
                simplest_between(&(&low + from), &(&low + to))
            }
            (None, Some(high)) => {
                let [from, to] = part(&DISTANCES)?;
                simplest_between(&(&high - to), &(&high - from))
            }
            (None, None) => {
                let [from, to] = part(&DISTANCES)?;
                let value = simplest_between(&from, &to)?;
                Some(if (choice / PARTS.len()).is_multiple_of(2) {
                    value
                } else {
                    -value
                })
            }
        }
    }
}

/// Values of the symbols at which all forms have their relations to zero, strict ones with a distance from it.
fn inner(forms: &[Form], symbols: usize) -> Option<Vec<Rational>> {
    // Each symbol is the difference of two unknowns. Then come what inequalities leave, the distance, and what is left of 1
    // beside it.
    let (left, distance) = (2 * symbols, 2 * symbols + forms.len());
    let unknowns = distance + 2;
    let mut equations = vec![];
    for (number, form) in forms.iter().enumerate() {
        let mut row = vec![integer(0); unknowns + 1];
        for (place, multiple) in form.multiples.iter().enumerate() {
            *row.get_mut(2 * place)? = multiple.clone();
            *row.get_mut(2 * place + 1)? = -multiple.clone();
        }
        if form.relation != Relation::Equal {
            *row.get_mut(left + number)? = integer(-1);
        }
        if form.relation == Relation::Greater {
            *row.get_mut(distance)? = integer(-1);
        }
        *row.last_mut()? = -form.constant.clone();
        equations.push(row);
    }
    let mut row = vec![integer(0); unknowns + 1];
    for place in [distance, distance + 1, unknowns] {
        *row.get_mut(place)? = integer(1);
    }
    equations.push(row);
    let counts: Vec<bool> = (0..unknowns).map(|place| place == distance).collect();
    let found = Tableau::new(equations, unknowns)?.solution(&counts)?;
    if !found.get(distance)?.is_positive() {
        return None;
    }
    let pairs = found.chunks(2).take(symbols);
    pairs
        .map(|pair| match pair {
            [above, below] => Some(above - below),
            _ => None,
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn form(multiples: &[i64], constant: i64, relation: Relation) -> Form {
        Form {
            multiples: multiples.iter().map(|n| integer(*n)).collect(),
            constant: integer(constant),
            relation,
        }
    }

    #[test]
    fn a_point_is_off_every_strict_form() {
        // x > 0, y > x, x + y == 1, 5 y <= 3.
        let forms = [
            form(&[1, 0], 0, Relation::Greater),
            form(&[-1, 1], 0, Relation::Greater),
            form(&[1, 1], -1, Relation::Equal),
            form(&[0, -5], 3, Relation::AtLeast),
        ];
        let found = inner(&forms, 2).expect("2/5 < y <= 3/5");
        let [x, y] = found.as_slice() else {
            panic!("{found:?}")
        };
        assert!(x.is_positive() && y > x && x + y == integer(1) && y * integer(5) <= integer(3));
    }

    #[test]
    fn there_is_no_point_where_the_forms_exclude_each_other() {
        // x > 0 and x <= 0.
        let forms = [
            form(&[1], 0, Relation::Greater),
            form(&[-1], 0, Relation::AtLeast),
        ];
        assert!(inner(&forms, 1).is_none());
    }
}
