//! The long run of composed claims: `cargo run --release -p torse-tests --example composed -- 20000 [SEED]`.
//!
//! Prints every wrong answer as a derivation file, and the table of answers by form and feature. With `open` as third argument
//! it prints what is not decided too; with `write` it decides nothing and prints the claims as JSON lines with their truth and
//! the engine's answer, for `tests/judges/third.py`.

use serde_json::json;
use std::process::ExitCode;
use torse_syntax::notation::Formula;
use torse_tests::composed::claim;
use torse_tests::composed::tally::{Counts, answer, run};
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
                "contradiction": found.and_then(|o| o.contradiction().clone()),
            });
            println!("{line}");
        }
        return ExitCode::SUCCESS;
    }
    let threads = std::thread::available_parallelism().map_or(1, |n| n.get() as u64);
    let each = total.div_ceil(threads);
    let counts = std::thread::scope(|scope| {
        let parts: Vec<_> = (0..threads)
            .map(|n| {
                let builder = std::thread::Builder::new().stack_size(64 << 20);
                builder.spawn_scoped(scope, move || {
                    run(seed, n * each, each.min(total.saturating_sub(n * each)))
                })
            })
            .collect();
        let mut counts = Counts::default();
        for part in parts.into_iter().flatten() {
            if let Ok(part) = part.join() {
                counts.join(part);
            }
        }
        counts
    });
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
    println!("against the semantics: {}", counts.contradicted.len());
    match counts.wrong.is_empty() {
        true => ExitCode::SUCCESS,
        false => ExitCode::FAILURE,
    }
}
