//! The long run of composed claims: `cargo run --release -p torse-tests --example composed -- 20000 [SEED]`.
//!
//! Prints every wrong answer as a derivation file, and the table of answers by form and feature. With `open` as third argument
//! it prints what is not decided too; with `semantics` it asks the semantics alone; with `write` it prints the claims as JSON
//! lines with their truth and the engine's answer, for `tests/judges/third.py`.

use serde_json::json;
use std::process::ExitCode;
use torse_syntax::notation::Formula;
use torse_tests::composed::claim;
use torse_tests::composed::tally::{answer, run_by, semantics_alone};
use torse_tests::random::judge::outcome;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |place: usize, otherwise: u64| {
        let argument = arguments.get(place).and_then(|text| text.parse().ok());
        argument.unwrap_or(otherwise)
    };
    let (total, seed) = (number(0, 1_000), number(1, 1));
    let word = arguments.get(2).map_or("", String::as_str);
    if word == "write" {
        for number in 0..total {
            let made = claim(seed, number);
            let (answer, said) = answer(&made);
            let found = outcome(&made.claim).ok();
            let found = found.as_ref();
            let texts = |all: &[Formula]| all.iter().map(|f| f.text.clone()).collect::<Vec<_>>();
            let line = json!({
                "number": number,
                "form": made.form.word(),
                "file": made.claim.file(),
                "truth": format!("{:?}", made.claim.truth),
                "answer": answer.word(),
                "said": said,
                "verdict": found.map(|o| o.verdict()),
                "conditions": found.map_or(vec![], |o| texts(o.conditions())),
                "correction": found.and_then(|o| o.correction()).map(|c| c.statement.text.clone()),
                "contradiction": found.and_then(|o| o.contradiction()),
            });
            println!("{line}");
        }
        return ExitCode::SUCCESS;
    }
    let threads = std::thread::available_parallelism().map_or(1, |n| n.get() as u64);
    if word == "semantics" {
        let (seconded, wrong) = semantics_alone(seed, total);
        for wrong in &wrong {
            println!("--- semantics\n{wrong}");
        }
        println!(
            "{total} claims, {seconded} as they were made, {} against",
            wrong.len()
        );
        return match wrong.is_empty() {
            true => ExitCode::SUCCESS,
            false => ExitCode::FAILURE,
        };
    }
    let counts = run_by(threads, seed, total);
    for wrong in &counts.wrong {
        println!("--- {wrong}");
    }
    for how in &counts.contradicted {
        println!("--- semantics\n{how}");
    }
    if word == "open" {
        for open in &counts.undecided {
            println!("--- open\n{open}");
        }
    }
    println!("{counts}");
    println!(
        "the semantics alone: {} as they were made, {} against",
        counts.seconded,
        counts.contradicted.len()
    );
    match counts.wrong.is_empty() {
        true => ExitCode::SUCCESS,
        false => ExitCode::FAILURE,
    }
}
