//! The words that the glossary rules out, for the tests of pages, reports and outputs.

/// The page; its last column has the words that are not used.
const GLOSSARY: &str = include_str!("../../docs/glossary.md");

/// The words that no page and no output uses.
pub fn ruled_out() -> Vec<&'static str> {
    let cells = GLOSSARY
        .lines()
        .filter_map(|line| line.strip_suffix('|')?.rsplit('|').next());
    let words: Vec<&str> = cells
        .flat_map(|cell| cell.split('`').skip(1).step_by(2))
        .collect();
    assert!(words.len() > 3, "{words:?}");
    words
}
