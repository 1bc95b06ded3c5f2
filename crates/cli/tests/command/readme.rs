//! The commands of the README print what stands below them, word for word; its lines are broken for narrow columns.

use crate::support::torse_in;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// The most characters of a line that stand in half of the page.
const MAX_COLUMNS: usize = 43;

/// The words of a command line; quotation marks hold words together, and a backslash ends a line that goes on.
fn words(line: &str) -> Vec<String> {
    let line = line.replace("\\\n", " ");
    let mut words = vec![];
    for (position, part) in line.split('"').enumerate() {
        match position % 2 {
            0 => words.extend(part.split_whitespace().map(str::to_owned)),
            _ => words.push(part.to_owned()),
        }
    }
    words
}

#[test]
fn the_commands_of_the_readme_print_what_it_shows() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let readme = fs::read_to_string(root.join("README.md")).unwrap();
    let folder = TempDir::new().unwrap();
    let design = "designs/square-to-round.toml";
    fs::create_dir(folder.path().join("designs")).unwrap();
    fs::copy(root.join(design), folder.path().join(design)).unwrap();
    let blocks: Vec<(&str, &str)> = readme
        .split("```")
        .skip(1)
        .step_by(2)
        .map(|block| block.split_once('\n').unwrap())
        .collect();
    let mut shown = 0;
    for pair in blocks.windows(2) {
        let [("sh", command), ("text", output)] = pair else {
            continue;
        };
        let arguments = command.trim().strip_prefix("cargo run -- ").unwrap();
        let ran = torse_in(folder.path(), &words(arguments));
        let plain = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(plain(&ran.out), plain(output), "{command}{}", ran.err);
        for line in command.lines().chain(output.lines()) {
            assert!(line.chars().count() <= MAX_COLUMNS, "{line}");
        }
        shown += 1;
    }
    assert_eq!(shown, 2);
}
