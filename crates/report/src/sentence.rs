//! The finding about a claim as a sentence: the one in its file, or one that names the relation that fails and the
//! values at which it does.
//!
//! Formulas stand between backticks, in the notation of the files; [`crate::math`] sets them.

use crate::glossary;
use crate::text::decimal;
use torse_prove::evidence::Witness;
use torse_syntax::formula::{Connective, Expr, Node, Relation};
use torse_syntax::notation::{Formula, text};
use torse_syntax::taxonomy::Verdict;
use torse_typography::expression;
use torse_verdicts::correction::Correction;
use torse_verdicts::judged::ConditionCheck;
use torse_verdicts::outcome::{Outcome, PaperFault};
use torse_verdicts::statement::RefutedStatement;
use torse_verdicts::words;

/// Longer exact values are written as decimals.
const MAX_EXACT_VALUE_LENGTH: usize = 24;

/// Longer sides are called left and right side.
const MAX_SIDE_LENGTH: usize = 48;

/// Longer points and conditions are left to the claim's own section.
const MAX_LIST_LENGTH: usize = 110;

/// Returns the sentence about a claim, with a full stop: that of its file, or that of the only fault that shows in no other claim.
pub(crate) fn short_sentence(outcome: &Outcome, faults: &[PaperFault]) -> String {
    let own = outcome.claim.author_note.as_deref().map(sentence);
    let found = own.or_else(|| {
        let shown = |fault: &&PaperFault| fault.shows == [outcome.claim.id.as_str()];
        let fault = faults.iter().find(shown)?;
        Some(fault_in_short(&fault.says))
    });
    match outcome.verdict() {
        Verdict::Misprint | Verdict::False => found
            .or_else(|| outcome.correction().map(corrected))
            .or_else(|| failure(outcome).map(|text| sentence(&text)))
            .unwrap_or_else(|| "False as printed.".to_owned()),
        Verdict::Conditional => {
            let found = found.map_or_else(String::new, |found| format!(" In words: {found}"));
            let beyond = beyond(outcome);
            match conjunction(outcome.conditions()) {
                Some(conditions) => format!("True if {conditions}{beyond}.{found}"),
                None => {
                    format!("True under a condition, which the claim shows{beyond}.{found}")
                }
            }
        }
        Verdict::Depends => {
            let found = found.map_or_else(String::new, |found| format!(" In words: {found}"));
            let each = outcome.readings().iter().map(|reading| {
                let verdict = glossary::verdict(reading.outcome.verdict()).label;
                let says = reading.says.trim_end_matches('.');
                format!("{verdict} in this reading: {says}")
            });
            let each: Vec<String> = each.collect();
            format!("{}.{found}", capital(&each.join("; ")))
        }
        Verdict::Vacuous => "No point satisfies the hypotheses.".to_owned(),
        _ => match &outcome.claim.note {
            Some(note) => format!("Not decided. {note}"),
            None => "Not decided.".to_owned(),
        },
    }
}

/// The longest sentence that is read at a glance, in characters.
const LONGEST_SENTENCE: usize = 350;

/// Returns the first sentence of a text, with a full stop. Of a sentence that is too long to be read at a glance the part
/// before its last semicolon or colon within that length.
#[must_use]
pub fn sentence_in_short(text: &str) -> String {
    let first = first_sentence(text);
    if first.chars().count() <= LONGEST_SENTENCE {
        return sentence(first);
    }
    let end = first.floor_char_boundary(LONGEST_SENTENCE);
    let head = first.get(..end).unwrap_or(first);
    match head.rfind("; ").or_else(|| head.rfind(": ")) {
        Some(at) => sentence(head.get(..at).unwrap_or(head)),
        None => sentence(first),
    }
}

/// Returns the first sentence of what is said of a fault.
pub(crate) fn fault_in_short(says: &str) -> String {
    sentence(first_sentence(says))
}

/// What is said of the points at which a condition fails: that the statement can fail there, or be undefined, if for each
/// condition a point is known at which it fails and the statement does so. That the
/// statement is true *only* if the condition holds is never said: other points without it may satisfy the statement. Of a
/// claim that asks for a number no such point is known, since another number may do.
fn beyond(outcome: &Outcome) -> &'static str {
    let conditions = outcome.net().map_or(&[][..], |net| &net.conditions);
    if conditions.is_empty() || !conditions.iter().all(ConditionCheck::seen_needed) {
        return "";
    }
    let fails = |check: &ConditionCheck| check.failing > 0;
    match (conditions.iter().all(fails), conditions.iter().any(fails)) {
        (true, _) => "; elsewhere it can fail",
        (false, true) => "; elsewhere it can fail or be undefined",
        (false, false) => "; elsewhere it can be undefined",
    }
}

/// The text up to its first full stop that ends a sentence: a blank and a capital letter follow, and no abbreviation goes before.
fn first_sentence(text: &str) -> &str {
    const ABBREVIATIONS: [&str; 7] = ["Sect", "Sects", "Fig", "Figs", "eq", "eqs", "Eq"];
    let mut ends = text.match_indices(". ").map(|(at, _)| at);
    let end = ends.find(|at| {
        let (before, after) = text.split_at(*at);
        let word = before.rsplit(|c: char| !c.is_alphanumeric()).next();
        after.chars().nth(2).is_some_and(char::is_uppercase)
            && !word.is_some_and(|word| ABBREVIATIONS.contains(&word))
    });
    end.and_then(|end| text.get(..end)).unwrap_or(text)
}

/// Adds a capital letter and a full stop.
pub(crate) fn finished(text: &str) -> String {
    sentence(text)
}

/// Returns the exact point at which a formula fails, with both sides and their difference.
pub(crate) fn counterexample(outcome: &Outcome) -> Option<String> {
    outcome.witness()?;
    match denied(outcome) {
        Some(_) => None,
        None => failure_in_full(outcome),
    }
}

/// Adds a capital letter and a full stop.
fn sentence(text: &str) -> String {
    let text = capital(text.trim());
    match text.ends_with(['.', '!', '?']) {
        true => text,
        false => format!("{text}."),
    }
}

/// Adds a capital letter, unless the first word is mathematics.
pub(crate) fn capital(text: &str) -> String {
    let mut letters = text.chars();
    match letters.next() {
        Some(first)
            if first.is_ascii_lowercase() && letters.next().is_some_and(char::is_alphabetic) =>
        {
            let rest = text.get(1..).unwrap_or_default();
            format!("{}{rest}", first.to_ascii_uppercase())
        }
        // The article.
        Some('a') if text.starts_with("a ") => format!("A{}", text.get(1..).unwrap_or_default()),
        _ => text.to_owned(),
    }
}

/// The edits of a proved correction.
fn corrected(correction: &Correction) -> String {
    let edits = correction.edits.join("; ");
    let others = match correction.unique {
        true => "",
        false => " (other corrections as small exist)",
    };
    format!("Correction, proved: {edits}{others}.")
}

/// Describes the steps of a decision; none for a sentence with readings, of which each has its own.
#[must_use]
pub fn own_steps(outcome: &Outcome) -> Vec<String> {
    if outcome.readings().is_empty() {
        words::steps(outcome)
    } else {
        vec![]
    }
}

/// Says where a refuted statement fails and by how much; none if nothing is known about it. A point of many symbols is
/// left to the claim's own section.
pub(crate) fn failure(outcome: &Outcome) -> Option<String> {
    failure_with(outcome, MAX_LIST_LENGTH)
}

/// The same with the whole point, for any number of symbols.
#[must_use]
pub fn failure_in_full(outcome: &Outcome) -> Option<String> {
    failure_with(outcome, usize::MAX)
}

fn failure_with(outcome: &Outcome, longest_point: usize) -> Option<String> {
    if let Some(denied) = denied(outcome) {
        return Some(denied);
    }
    let witness = outcome.witness()?;
    let statement = failing(outcome).and_then(|formula| expression(&formula.text));
    let relation = statement
        .as_ref()
        .and_then(|statement| match &statement.node {
            Node::Compare(left, rest) => match rest.as_slice() {
                [(relation, right)] => Some((&**left, *relation, right)),
                _ => None,
            },
            _ => None,
        });
    // What a side is at the point is what fails, and no part of the point.
    let sides = relation.map(|(left, _, right)| [text(left), text(right)]);
    let place = place(witness, longest_point, sides.iter().flatten());
    Some(match relation {
        Some((left, relation, right)) => compared(left, relation, right, witness, &place),
        None => fails_at(witness, &place),
    })
}

/// Returns the statement that fails: of a conjunction, its part.
fn failing(outcome: &Outcome) -> Option<&Formula> {
    let part = outcome.refuted().and_then(RefutedStatement::failing_part);
    part.or_else(|| outcome.parsed())
}

/// Describes the relation that fails, with the values of both sides.
fn compared(
    left: &Expr,
    relation: Relation,
    right: &Expr,
    witness: &Witness,
    place: &str,
) -> String {
    let name = |side: &Expr, otherwise: &str| {
        let text = text(side);
        match text.chars().count() <= MAX_SIDE_LENGTH {
            true => format!("`{text}`"),
            false => otherwise.to_owned(),
        }
    };
    let (shown_left, shown_right) = (name(left, "the left side"), name(right, "the right side"));
    // A number is written as printed, and a side that is its own value in decimals.
    let value = |side: &Expr, exact: &str, decimals: &str| match side.node {
        Node::Number { .. } => format!("`{}`", text(side)),
        _ if text(side) == exact && exact.contains(char::is_alphabetic) => decimal(decimals),
        _ => shown_value(exact, decimals),
    };
    let value_left = value(left, &witness.left, &witness.left_decimal);
    let value_right = value(right, &witness.right, &witness.right_decimal);
    // A side that is printed as its value is not repeated.
    let number_left = text(left) == witness.left || matches!(left.node, Node::Number { .. });
    let number = text(right) == witness.right || matches!(right.node, Node::Number { .. });
    let equal = witness.left == witness.right;
    let wanted = match relation {
        Relation::Equal => "equal to",
        Relation::Different => "different from",
        Relation::Less => "less than",
        Relation::AtMost => "at most",
        Relation::Greater => "greater than",
        Relation::AtLeast => "at least",
    };
    match (relation, equal, number) {
        (Relation::Equal, true, _) => format!("it fails{}", end(place)),
        (Relation::Equal, false, true) => format!(
            "{shown_left} is {value_left}{}, and not {value_right}{}",
            end(place),
            off(witness)
        ),
        (Relation::Equal, false, false) if number_left => {
            format!(
                "{shown_right} is {value_right}{}, and not {value_left}{}",
                end(place),
                off(witness)
            )
        }
        (Relation::Equal, false, false) => format!(
            "{shown_left} is {value_left}{}, and {shown_right} is {value_right}{}",
            end(place),
            off(witness)
        ),
        (Relation::Different, ..) => {
            format!(
                "{shown_left} is {value_left}{}, and so is {shown_right}",
                end(place)
            )
        }
        // A relation with the bound on the left is written with the value first.
        (_, _, false) if number_left => format!(
            "{shown_right} is {value_right}{}, and {value_left} is not {wanted} that",
            end(place)
        ),
        (_, _, true) => format!(
            "{shown_left} is {value_left}{}, which is not {wanted} {value_right}",
            end(place)
        ),
        (_, true, false) => format!(
            "{shown_left} and {shown_right} are equal{}, so that neither is greater",
            end(place)
        ),
        (_, false, false) => format!(
            "{shown_left} is {value_left}{}, which is not {wanted} {shown_right}, that is {value_right}",
            end(place)
        ),
    }
}

/// Writes ` at k = 3` after a value.
fn end(place: &str) -> String {
    match place.is_empty() {
        true => String::new(),
        false => format!(" {}", place.trim_end()),
    }
}

/// Says by how much two numbers differ, if the exact values do not show it.
fn off(witness: &Witness) -> String {
    let number = |decimals: &str| decimals.trim_end_matches('.').parse::<f64>().ok();
    let plain = |exact: &str| exact.parse::<i64>().is_ok();
    if plain(&witness.left) && plain(&witness.right) {
        return String::new();
    }
    match (
        number(&witness.left_decimal),
        number(&witness.right_decimal),
    ) {
        (Some(left), Some(right)) => {
            let off = (left - right).abs();
            // Twelve digits of both are known.
            match off > 1e-6 * left.abs().max(right.abs()) && off.is_finite() {
                true => format!("; the difference is {}", significant(off)),
                false => String::new(),
            }
        }
        _ => String::new(),
    }
}

/// Writes a number with four significant digits.
fn significant(number: f64) -> String {
    let places = 3.0 - libm::log10(number).floor();
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "clamped"
    )]
    let places = places.clamp(0.0, 12.0) as usize;
    let text = format!("{number:.places$}");
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

/// For a refuted denial: says that the denied statement holds everywhere.
pub(crate) fn denied(outcome: &Outcome) -> Option<String> {
    if !glossary::denied(outcome) {
        return None;
    }
    let place = match outcome.refuted().and_then(RefutedStatement::instance) {
        Some(integers) => format!("at {} ", words::certificate::values(integers)),
        None => String::new(),
    };
    let statement = outcome.parsed().and_then(|own| expression(&own.text))?;
    let so = opposite(&statement).map(|so| text(&so));
    Some(match so {
        Some(so) if so.chars().count() <= MAX_LIST_LENGTH => format!("{place}`{so}` everywhere"),
        _ => format!("{place}the opposite is true everywhere"),
    })
}

/// Returns the statement that is denied.
fn opposite(statement: &Expr) -> Option<Expr> {
    match &statement.node {
        Node::Not(inner) => Some((**inner).clone()),
        Node::Call(head, arguments) => match (&head.node, arguments.as_slice()) {
            (Node::Name(name), [inner]) if name == "fails" => Some(inner.clone()),
            _ => None,
        },
        Node::Compare(left, rest) => match rest.as_slice() {
            [(relation, right)] => {
                let node = Node::Compare(left.clone(), vec![(relation.opposite(), right.clone())]);
                Some(Expr::made(node))
            }
            _ => None,
        },
        Node::Join(Connective::Or, a, b) => {
            let (a, b) = (opposite(a)?, opposite(b)?);
            Some(Expr::made(Node::Join(Connective::And, a.into(), b.into())))
        }
        _ => None,
    }
}

/// Returns the values of a point that readers need; the engine's symbols for roots follow from the others.
pub fn point(witness: &Witness) -> impl Iterator<Item = &(String, String)> {
    let is_root = |name: &str| {
        let heads = [
            "sqrt(", "norm(", "abs(", "√", "log(", "log#", "atan(", "asin(", "arc#",
        ];
        heads.iter().any(|head| name.starts_with(head))
    };
    let alone = witness.at.iter().all(|(name, _)| is_root(name));
    // If nothing else is known, a root that is written as a formula is shown; one with a number as its name never is.
    let is_shown = move |name: &str| match alone {
        true => ["√", "log#", "arc#"]
            .iter()
            .all(|head| !name.starts_with(head)),
        false => !is_root(name),
    };
    witness.at.iter().filter(move |(name, _)| is_shown(name))
}

/// Writes ` at k = 3, mu = 1 ` in words, unless it is longer than that, without the values of these names.
fn place<'s>(
    witness: &Witness,
    longest: usize,
    without: impl Iterator<Item = &'s String> + Clone,
) -> String {
    let values = point(witness).filter(|(name, _)| without.clone().all(|other| other != name));
    let values = values.map(|(name, value)| format!("`{name} = {value}`"));
    let values = values.collect::<Vec<String>>().join(", ");
    let short = (values.chars().count() <= longest).then_some(values);
    match short {
        Some(values) if values.is_empty() => String::new(),
        Some(values) => format!("at {values} "),
        None => "at the counterexample ".to_owned(),
    }
}

/// Describes the values of both sides of a statement that is no single relation.
fn fails_at(witness: &Witness, place: &str) -> String {
    match witness.left == witness.right {
        true => format!("it fails{}", end(place)),
        false => {
            let left = shown_value(&witness.left, &witness.left_decimal);
            let right = shown_value(&witness.right, &witness.right_decimal);
            format!("{place}the left side is {left}, and the right side is {right}")
        }
    }
}

fn shown_value(exact: &str, decimals: &str) -> String {
    match exact.chars().count() <= MAX_EXACT_VALUE_LENGTH || decimals.is_empty() {
        true => {
            let fraction = as_one_fraction(exact);
            format!("`{}`", fraction.as_deref().unwrap_or(exact))
        }
        false => decimal(decimals),
    }
}

/// A rational multiple of a sum as papers write it, `(2 - sqrt(2))/8` for `-1/8*(sqrt(2) - 2)`; none of any other value.
fn as_one_fraction(value: &str) -> Option<String> {
    let (factor, sum) = value.split_once("*(")?;
    let sum = sum.strip_suffix(')')?;
    let positive = factor.strip_prefix('-').unwrap_or(factor);
    let (above, below) = positive.split_once('/')?;
    let is_number = |text: &str| !text.is_empty() && text.bytes().all(|c| c.is_ascii_digit());
    let is_balanced = |text: &str| {
        let mut depths = text.chars().scan(0_i32, |depth, c| {
            *depth += i32::from(c == '(') - i32::from(c == ')');
            Some(*depth)
        });
        depths.all(|depth| depth >= 0) && text.matches('(').count() == text.matches(')').count()
    };
    if !is_number(above) || !is_number(below) || !is_balanced(sum) {
        return None;
    }
    let sum = match positive == factor {
        true => sum.to_owned(),
        false => {
            let (left, right) = sum.split_once(" - ")?;
            let is_one_term = |text: &str| {
                let parts = text.contains(" + ") || text.contains(" - ");
                !parts && !text.starts_with('-') && is_balanced(text)
            };
            if !is_one_term(left) || !is_one_term(right) {
                return None;
            }
            format!("{right} - {left}")
        }
    };
    Some(match above {
        "1" => format!("({sum})/{below}"),
        above => format!("{above}*({sum})/{below}"),
    })
}

/// Joins the conditions, unless there are none or they are long.
fn conjunction(formulas: &[Formula]) -> Option<String> {
    let texts: Vec<String> = formulas
        .iter()
        .map(|formula| glossary::quoted(&formula.text))
        .collect();
    short(texts.join(" and ")).filter(|text| !text.is_empty())
}

fn short(list: String) -> Option<String> {
    (list.chars().count() <= MAX_LIST_LENGTH).then_some(list)
}

#[cfg(test)]
mod tests {
    use super::as_one_fraction;

    #[test]
    fn a_multiple_of_a_sum_is_one_fraction_and_a_minus_before_it_turns_the_difference() {
        let cases = [
            ("-1/8*(sqrt(2) - 2)", Some("(2 - sqrt(2))/8")),
            ("4/3*(sqrt(2) - 1)", Some("4*(sqrt(2) - 1)/3")),
            ("-1/8*(sqrt(2) - 2 + pi)", None),
            ("1/2*(pi)*(sqrt(2))", None),
            ("3/8 - 1/4*sqrt(2)", None),
        ];
        for (value, written) in cases {
            assert_eq!(as_one_fraction(value).as_deref(), written, "{value}");
        }
    }
}
