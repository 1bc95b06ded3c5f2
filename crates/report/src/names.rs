//! The names of a claim as its paper prints them.

use torse_typography::PrintedNames;
use torse_verdicts::dependencies::Dependencies;
use torse_verdicts::outcome::Outcome;

/// Collects the names of a claim and of its readings.
pub(crate) fn printed_names(outcome: &Outcome) -> PrintedNames {
    let mut names = PrintedNames::default();
    declare_all(&mut names, &outcome.claim.table);
    for reading in outcome.readings() {
        declare_all(&mut names, &reading.outcome.claim.table);
    }
    names
}

fn declare_all(names: &mut PrintedNames, table: &Dependencies) {
    names.print_bold(table.bold.iter().copied());
    for symbol in &table.symbols {
        names.declare(&symbol.name, symbol.display.as_deref());
    }
    for definition in &table.definitions {
        names.declare(&definition.head.text, definition.display.as_deref());
    }
    for basis in &table.bases {
        names.declare(&basis.head.text, basis.display.as_deref());
    }
}
