//! Flags words about something that is not stated: a reading that names something else, or a relation in a sentence
//! without any statement.

use super::{RaisedFlag, Subject, one_flag_for, raised};
use std::collections::BTreeSet;
use torse_syntax::taxonomy::Flag;

/// Returns what a reading names, in backticks or by an equation number, and the statement does not contain.
pub(super) fn unstated_names_of_reading(subject: &Subject<'_>) -> Vec<RaisedFlag> {
    let entry = &subject.claim.entry;
    let Some(reading) = &entry.reading else {
        return vec![];
    };
    let occurs = |name: &str| {
        let base = name.trim_end_matches('\'');
        let formulas = subject.formulas.reached.iter();
        let mut names = formulas.flat_map(|expr| expr.names());
        names.any(|found| found == name || found.trim_end_matches('\'') == base)
    };
    let quoted = reading.split('`').skip(1).step_by(2);
    let words = quoted.flat_map(|code| code.split(|c: char| !c.is_alphanumeric() && c != '_'));
    let names = words.filter(|word| word.starts_with(char::is_alphabetic) && !occurs(word));
    let names: BTreeSet<String> = names.map(|name| format!("`{name}`")).collect();
    let known = |number: &&str| {
        let mut rests_on = subject.rests_on.iter().map(|claim| &claim.entry);
        rests_on.any(|entry| {
            let places = [entry.id.get_ref(), &entry.at, &entry.printed];
            places.into_iter().any(|text| text.contains(*number))
        })
    };
    let numbers: BTreeSet<&str> = equation_numbers(reading).into_iter().collect();
    let numbers = numbers.into_iter().filter(|number| !known(number));
    let numbers = numbers.map(|number| format!("({number})"));
    let missing = names.into_iter().chain(numbers).collect();
    one_flag_for(Flag::UnstatedReading, "read, and not stated", missing)
}

/// `5.12` of `(5.12)`.
fn equation_numbers(text: &str) -> Vec<&str> {
    let inside = text.split('(').skip(1);
    let inside = inside
        .filter_map(|rest| rest.split_once(')'))
        .map(|(inside, _)| inside);
    let number = |text: &&str| {
        let digits = |part: &str| !part.is_empty() && part.chars().all(|c| c.is_ascii_digit());
        text.split_once('.')
            .is_some_and(|(a, b)| digits(a) && digits(b))
    };
    inside.filter(number).collect()
}

/// Returns a sentence with a relation and no statement.
pub(super) fn unstated_relations(subject: &Subject<'_>) -> Vec<RaisedFlag> {
    let entry = &subject.claim.entry;
    let reason = entry.out_of_scope.is_some() || entry.underspecified.is_some();
    match reason && subject.print.relations > 0 {
        true => {
            let evidence = "the sentence has a relation, and nothing is stated";
            vec![raised(Flag::UnstatedRelation, evidence)]
        }
        false => vec![],
    }
}
