//! `--help` uses the words of the glossary.

use crate::support::torse;
use std::fs;

/// The words that the glossary rules out.
fn ruled_out(glossary: &str) -> Vec<&str> {
    let cells = glossary
        .lines()
        .filter_map(|line| line.strip_suffix('|')?.rsplit('|').next());
    cells
        .flat_map(|cell| cell.split('`').skip(1).step_by(2))
        .collect()
}

#[test]
fn the_help_of_every_command_uses_the_words_of_the_glossary() {
    let glossary = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/glossary.md");
    let glossary = fs::read_to_string(glossary).unwrap();
    let words = ruled_out(&glossary);
    assert!(words.len() > 3, "{words:?}");
    let help = torse(&["--help"]).out;
    let commands = help.split_once("Commands:\n").unwrap().1;
    let commands = commands.lines().take_while(|line| !line.is_empty());
    // Further lines of a description are indented more.
    let commands = commands.filter(|line| !line.starts_with("     "));
    let commands: Vec<&str> = commands
        .filter_map(|line| line.split_whitespace().next())
        .filter(|name| *name != "help")
        .collect();
    assert!(commands.len() > 15, "{commands:?}");
    let pages = commands
        .iter()
        .map(|name| torse(&["help", name]).out)
        .chain([help.clone()]);
    for page in pages {
        let page = page.split_whitespace().collect::<Vec<_>>().join(" ");
        for word in &words {
            assert!(!page.contains(word), "`{word}` in: {page}");
        }
    }
}
