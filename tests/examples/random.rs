//! The long run of random claims: `cargo run --release -p torse-tests --example random -- 100000 [SEED] [KIND]`.
//!
//! Prints the table kind, claims, wrong, open, and how many the semantics decides by itself; and every wrong answer as a
//! derivation file.

use std::process::ExitCode;
use torse_tests::random::Kind;
use torse_tests::random::judge;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |place: usize, otherwise: u64| {
        let argument = arguments.get(place).and_then(|text| text.parse().ok());
        argument.unwrap_or(otherwise)
    };
    let (total, seed) = (number(0, 1200), number(1, 1));
    let kinds: Vec<Kind> = Kind::ALL
        .into_iter()
        .filter(|kind| arguments.get(2).is_none_or(|word| word == kind.word()))
        .collect();
    let each = total.div_ceil(u64::try_from(kinds.len().max(1)).unwrap_or(1));
    let mut failed = false;
    let mut table = format!(
        "{:<12} {:>8} {:>6} {:>6} {:>10}\n",
        "kind", "claims", "wrong", "open", "seconded"
    );
    for kind in kinds {
        let tally = judge::run(kind, seed, 0, each);
        for wrong in &tally.wrong {
            println!("--- wrong\n{wrong}");
        }
        if arguments.get(3).is_some_and(|word| word == "open") {
            for open in &tally.undecided {
                println!("--- open\n{open}");
            }
        }
        failed |= !tally.wrong.is_empty();
        table.push_str(&format!(
            "{:<12} {:>8} {:>6} {:>6} {:>10}\n",
            kind.word(),
            tally.claims,
            tally.wrong.len(),
            tally.open,
            tally.seconded
        ));
    }
    print!("{table}");
    if failed {
        ExitCode::FAILURE
    } else {
        ExitCode::SUCCESS
    }
}
