//! One table of exit codes: that of `docs/commands.md` is that of `torse --help`.

use crate::support::torse;
use std::fs;

/// A text with single spaces.
fn plain(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The codes of `torse --help` with their meanings, in its order.
fn by_help() -> Vec<(u8, String)> {
    let help = torse(&["--help"]).out;
    let table = help.split_once("Exit codes").unwrap().1;
    let table = table.split_once("Colours and progress").unwrap().0;
    let mut rows: Vec<(u8, String)> = vec![];
    for line in table.lines().skip(1).filter(|line| !line.trim().is_empty()) {
        let (number, meaning) = line.trim().split_once("  ").unwrap_or(("", line));
        match (number.parse(), rows.last_mut()) {
            (Ok(number), _) => rows.push((number, plain(meaning))),
            (Err(_), Some((_, above))) => *above = plain(&format!("{above} {line}")),
            (Err(_), None) => unreachable!("a meaning without a number: {line}"),
        }
    }
    rows
}

/// Those of the table of `docs/commands.md`.
fn by_page() -> Vec<(u8, String)> {
    let page = fs::read_to_string(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../docs/commands.md"
    ));
    let page = page.unwrap();
    let table = page.split_once("| exit code |").unwrap().1;
    let rows = table
        .lines()
        .skip(2)
        .take_while(|line| line.starts_with('|'));
    let cells = rows.map(|row| row.trim_matches('|').split_once('|').unwrap());
    let cells = cells.map(|(number, meaning)| (number.trim().parse().unwrap(), plain(meaning)));
    cells.collect()
}

#[test]
fn the_page_of_commands_has_the_exit_codes_of_the_help_in_its_order_and_words() {
    let table = by_help();
    let codes: Vec<u8> = table.iter().map(|(code, _)| *code).collect();
    assert_eq!(codes, [101, 6, 2, 4, 5, 8, 7, 1, 3, 0]);
    assert_eq!(by_page(), table);
}
