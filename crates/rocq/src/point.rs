//! Values for the bound names of a statement at which its premises are true, or at which it is false.
//!
//! They come from the witness of the verdict. Without one, integers are the least that are in their sets together,
//! numbers are in their intervals, and others differ enough that determinants of them do not vanish.

use crate::binder::Binder;
use crate::code::Code;
use crate::solved::{bound, solved_unknowns, value};
use crate::task::Goal;
use crate::unknowns::FUNCTION;
use std::collections::BTreeMap;
use std::sync::Arc;
use torse_core::Set;
use torse_numbers::{Affine, Rational, rational};
use torse_syntax::derivation::declarations::{Bound, Constant, Interval};

/// Which values are tried without a witness.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Choice {
    /// Increasing values, which orders may require.
    Generic,
    /// Zero, which satisfies homogeneous equations.
    Zero,
    /// Irregular values, and members of families that depend on their index too.
    Varied,
    /// Equal values for coordinates of vectors whose names differ by a number only, and one for all else.
    Same,
    /// Unit vectors along the axes, one after the other; of other numbers the first is one and the rest are zero.
    Axes,
}

/// Returns values for the bound names, in order.
#[must_use]
pub fn point(goal: &Goal, choice: Choice) -> Vec<String> {
    let integers = integers(goal);
    let mut values = vec![];
    let mut count = 1;
    let mut vectors = 0;
    let mut ones = 0;
    for binder in &goal.proposition.binders {
        let axis = vectors % binder.names.len().max(1) + 1;
        vectors += usize::from(binder.names.len() > 1);
        let set = goal.symbols.get(&binder.symbol);
        for (coordinate, name) in (1..).zip(&binder.names) {
            count += 1;
            let number = match choice {
                Choice::Same if binder.names.len() > 1 => {
                    format!("{}", scattered(letters(&binder.symbol) + coordinate))
                }
                Choice::Same => "1".to_owned(),
                Choice::Generic => count.to_string(),
                Choice::Varied => scattered(count).to_string(),
                Choice::Zero => "0".to_owned(),
                Choice::Axes if binder.names.len() > 1 => {
                    i64::from(usize::try_from(coordinate) == Ok(axis)).to_string()
                }
                Choice::Axes => {
                    ones += i64::from(
                        matches!(set, Some(Set::Real(i)) if i.lower.is_none() && i.upper.is_none()),
                    );
                    i64::from(ones == 1).to_string()
                }
            };
            if binder.rocq_type == FUNCTION {
                values.push(String::new());
                continue;
            }
            values.push(match set {
                Some(Set::Integer { .. }) => {
                    let value = integers.get(&binder.symbol).copied().unwrap_or(3);
                    format!("({value})%Z")
                }
                Some(Set::Real(interval)) => {
                    let first = rational::integer(i64::from(ones == 1));
                    fixed(goal, name).unwrap_or_else(|| within(interval, choice, count, first))
                }
                Some(Set::Family { ranges, .. }) => {
                    member(choice, ranges.len().max(1), &number, count)
                }
                _ => fixed(goal, name).unwrap_or(number),
            });
        }
    }
    values
}

/// Returns the same with the values of unknowns that equations determine there, and the unknowns as functions; none if
/// a value has no text.
#[must_use]
pub fn solved_point(goal: &Goal, choice: Choice) -> Option<Vec<String>> {
    let mut values = point(goal, choice);
    let sets = |name: &str| goal.symbols.get(name).cloned();
    let binders = &goal.proposition.binders;
    let names: Vec<String> = binders.iter().flat_map(|b| b.names.clone()).collect();
    let numbers = values.clone();
    let number_of = |own: Option<(&str, &str)>, name: &str, indices: &[&str]| {
        if let Some((symbol, text)) = own
            && symbol == name
        {
            return Some(text.to_owned());
        }
        let bound = bound(binders, &sets, name, indices)?;
        let place = names.iter().position(|name| *name == bound)?;
        numbers.get(place).map(|number| format!("({number})"))
    };
    for known in solved_unknowns(goal)? {
        let named = |name: &str, indices: &[&str]| number_of(None, name, indices);
        let value_there = value(&goal.solved, &known.name, &named)?;
        // A member is not a bound name itself.
        let place = names.iter().position(|name| *name == known.unknown)?;
        *values.get_mut(place)? = value_there;
    }
    for along in &goal.proposition.alongs {
        if along.has_members {
            return None;
        }
        for function in &along.functions {
            let own = Some((&*along.symbol, along.variable.as_str()));
            let named = |name: &str, indices: &[&str]| number_of(own, name, indices);
            let body = value(&goal.solved, &function.unknown, &named)?;
            let place = names.iter().position(|name| *name == function.name)?;
            *values.get_mut(place)? = format!("(fun {} => {body})", along.variable);
        }
    }
    Some(values)
}

/// Returns irregular numbers, so that determinants of them do not vanish.
fn scattered(count: i64) -> i64 {
    (count * count * count + 2 * count).rem_euclid(13) + 1
}

/// Returns a number for the letters that a name begins with.
fn letters(name: &str) -> i64 {
    let letters = name.bytes().take_while(u8::is_ascii_alphabetic);
    letters.map(i64::from).sum()
}

/// Returns a family of numbers: constant, or with members that differ.
fn member(choice: Choice, indices: usize, number: &str, count: i64) -> String {
    if choice != Choice::Varied {
        return format!("(fun{} => {number})", " _".repeat(indices));
    }
    let names: Vec<String> = (0..indices).map(|i| format!("i{i}")).collect();
    let mut terms = vec![];
    for (place, name) in (1..).zip(&names) {
        terms.push(format!("{place} * {name} * {name} * {name}"));
        terms.push(format!("{} * {name}", scattered(count + place)));
    }
    // No member is the product of factors that depend on single indices.
    if let [first, second, ..] = names.as_slice() {
        terms.push(format!("5 * {first} * {second}"));
    }
    format!(
        "(fun {} => IZR ({} + {number})%Z)",
        names.join(" "),
        terms.join(" + ")
    )
}

/// How many values are tried for each integer.
const TRIED: i64 = 7;

/// Values of integers by name.
type Integers = BTreeMap<Arc<str>, i64>;

/// Returns the first values of the integers that are in their sets together; integers for which the few tried values
/// fail get none.
fn integers(goal: &Goal) -> Integers {
    let mut values = Integers::new();
    for binder in &goal.proposition.binders {
        let number = binder.names.first().and_then(|name| fixed(goal, name));
        let number = number.and_then(|text| text.trim_matches(['(', ')']).parse().ok());
        if let (Some(Set::Integer { .. }), Some(number)) =
            (goal.symbols.get(&binder.symbol), number)
        {
            values.insert(Arc::clone(&binder.symbol), number);
        }
    }
    fill(&integer_sets(&goal.symbols), &mut values);
    values
}

/// An integer with the ends of its set.
struct IntegerSet<'a> {
    name: &'a Arc<str>,
    least: Option<&'a Affine>,
    most: Option<&'a Affine>,
}

fn integer_sets(symbols: &BTreeMap<Arc<str>, Set>) -> Vec<IntegerSet<'_>> {
    let sets = symbols.iter().filter_map(|(name, set)| match set {
        Set::Integer { least, most } => Some(IntegerSet {
            name,
            least: least.as_ref(),
            most: most.as_ref(),
        }),
        _ => None,
    });
    sets.collect()
}

impl IntegerSet<'_> {
    /// Whether its value is in its set. A form of symbols without values does not bound it yet.
    fn fits(&self, values: &Integers) -> bool {
        let Some(value) = values.get(self.name) else {
            return true;
        };
        let end = |form: Option<&Affine>| {
            let form = form?;
            let rest = form
                .multiples()
                .map(|(name, multiple)| Some(multiple * values.get(name)?));
            Some(rest.sum::<Option<i64>>()? + form.constant())
        };
        end(self.least).is_none_or(|least| least <= *value)
            && end(self.most).is_none_or(|most| *value <= most)
    }
}

/// Assigns values to the remaining integers one after the other, and backtracks if none fits; returns whether all have
/// one.
fn fill(sets: &[IntegerSet<'_>], values: &mut Integers) -> bool {
    let Some(next) = sets.iter().find(|set| !values.contains_key(set.name)) else {
        return true;
    };
    for value in 0..TRIED {
        values.insert(Arc::clone(next.name), value);
        if sets.iter().all(|set| set.fits(values)) && fill(sets, values) {
            return true;
        }
    }
    values.remove(next.name);
    false
}

/// Returns the closed number that a premise `name = number` assigns to a symbol.
fn fixed(goal: &Goal, name: &str) -> Option<String> {
    let premises = goal.proposition.premises.iter();
    let mut values = premises.filter_map(|premise| {
        let (left, right) = premise.text().split_once(" = ")?;
        let words = right.split(|c: char| !c.is_ascii_alphanumeric() && c != '_' && c != '\'');
        let mut names = words.filter(|word| word.starts_with(|c: char| c.is_ascii_alphabetic()));
        let left = left.strip_prefix("IZR ").unwrap_or(left);
        (left == name && names.all(|word| word == "PI" || word == "sqrt"))
            .then(|| format!("({right})"))
    });
    values.next()
}

/// Returns a number of an interval: the middle, which is often zero, or another one. Between multiples of pi it is one
/// whose sine is known.
fn within(interval: &Interval, choice: Choice, count: i64, first: Rational) -> String {
    let (lower, upper) = (interval.lower.as_ref(), interval.upper.as_ref());
    let rational_end = |bound: &Bound| bound.value.as_rational().cloned();
    let one = rational::integer(1);
    let parts = if choice == Choice::Zero { 2 } else { 3 };
    let part = rational::ratio(1, parts).unwrap_or_default();
    let between = |low: &Rational, high: &Rational| low.clone() + (high.clone() - low) * &part;
    let turned = |bound: &Constant| bound.turns != rational::integer(0);
    if let (Some(low), Some(high)) = (lower, upper)
        && (turned(&low.value) || turned(&high.value))
    {
        let turns = Code::rational(&between(&low.value.turns, &high.value.turns));
        return format!("({} * PI)", turns.argument());
    }
    let value: Rational = match (lower.and_then(rational_end), upper.and_then(rational_end)) {
        (Some(low), Some(high)) => between(&low, &high),
        (Some(low), None) if choice == Choice::Zero && lower.is_some_and(|b| b.closed) => low,
        (Some(low), None) if choice == Choice::Varied => low + rational::integer(scattered(count)),
        (None, Some(high)) if choice == Choice::Varied => {
            high - rational::integer(scattered(count))
        }
        (Some(low), None) => low + &one,
        (None, Some(high)) => high - &one,
        (None, None) if choice == Choice::Zero => rational::integer(0),
        (None, None) if choice == Choice::Same => one,
        (None, None) if choice == Choice::Axes => first,
        (None, None) if choice == Choice::Generic => rational::integer(count),
        (None, None) => rational::integer(scattered(count)),
    };
    format!("({})", Code::rational(&value).text())
}

/// Returns one fallback value for each binder.
#[must_use]
pub fn first_values(goal: &Goal) -> Vec<String> {
    let mut values = point(goal, Choice::Zero).into_iter();
    let mut first = vec![];
    for binder in &goal.proposition.binders {
        first.push(values.next().unwrap_or_default());
        for _ in binder.names.iter().skip(1) {
            values.next();
        }
    }
    first
}

/// Returns the value of a bound name at the witness: that of a symbol, or those of the members of a family.
#[must_use]
pub fn value_at(goal: &Goal, binder: &Binder, place: usize) -> Option<String> {
    let symbol = &*binder.symbol;
    let set = goal.symbols.get(&binder.symbol)?;
    let at = |wanted: &str| {
        let found = goal.witness.iter().find(|(name, _)| name == wanted);
        found.map(|(_, value)| rocq_number(value))
    };
    match set {
        Set::Integer { .. } => at(symbol).map(|value| format!("({value})%Z")),
        Set::Real(_) => at(symbol),
        Set::Vector(None) => at(&format!("{symbol}[]")).or_else(|| at(symbol)),
        Set::Vector(Some(_)) => at(&format!("{symbol}[{}]", place + 1)),
        Set::Family { ranges, dimension } => {
            // Members by their indices: `P[0]` and `P[0,1]`, with the coordinate last if there are several.
            let indices = ranges.len().max(1);
            let prefix = format!("{symbol}[");
            let mut cases = vec![];
            for (name, value) in &goal.witness {
                let Some(inner) = name
                    .strip_prefix(&prefix)
                    .and_then(|rest| rest.strip_suffix(']'))
                else {
                    continue;
                };
                let numbers: Vec<&str> = inner
                    .split([',', ']'])
                    .map(|n| n.trim_start_matches('['))
                    .collect();
                let own = dimension.is_none_or(|n| n == 1)
                    || numbers
                        .get(indices)
                        .is_some_and(|n| n.parse() == Ok(place + 1));
                let Some(indices) = numbers.get(..indices).filter(|_| own) else {
                    continue;
                };
                let tests: Vec<String> = indices
                    .iter()
                    .enumerate()
                    .map(|(i, n)| format!("Z.eqb i{i} ({n})"))
                    .collect();
                let test = tests.join(" && ");
                cases.push(format!(
                    "if ({test})%bool then {} else ",
                    rocq_number(value)
                ));
            }
            let bound: String = (0..indices).map(|i| format!(" i{i}")).collect();
            Some(format!("(fun{bound} => {}0)", cases.concat()))
        }
    }
}

/// Writes a value of a witness in Rocq: the notation is the same, except for the name of pi.
fn rocq_number(value: &str) -> String {
    let words = value.split_inclusive(|c: char| !c.is_ascii_alphanumeric());
    let text: String = words
        .map(|word| match word.strip_prefix("pi") {
            Some(rest) if !rest.starts_with(|c: char| c.is_ascii_alphanumeric()) => {
                format!("PI{rest}")
            }
            _ => word.to_owned(),
        })
        .collect();
    format!("({text})")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn integers_are_in_their_sets_together() {
        // k has no value below that of m, whose set has smaller ones.
        let integer = |least: Option<Affine>, most: Option<Affine>| Set::Integer { least, most };
        let symbols = BTreeMap::from([
            (
                Arc::from("k"),
                integer(Some(Affine::number(3)), Some(Affine::symbol("m"))),
            ),
            (Arc::from("m"), integer(Some(Affine::number(2)), None)),
        ]);
        let mut values = Integers::new();
        assert!(fill(&integer_sets(&symbols), &mut values));
        assert_eq!(values.get("k"), Some(&3));
        assert_eq!(values.get("m"), Some(&3));
    }

    #[test]
    fn members_differ_by_their_index_where_they_have_to() {
        assert_eq!(member(Choice::Zero, 2, "0", 5), "(fun _ _ => 0)");
        let varied = member(Choice::Varied, 1, "7", 5);
        assert!(varied.contains("i0 * i0 * i0"), "{varied}");
    }
}
