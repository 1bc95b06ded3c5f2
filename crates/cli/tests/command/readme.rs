//! The commands of the README print what stands below them.

use crate::support::torse_in;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// The words of a command line; quotation marks hold words together.
fn words(line: &str) -> Vec<String> {
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
        assert_eq!(ran.out, *output, "{command}{}", ran.err);
        shown += 1;
    }
    assert_eq!(shown, 2);
}
