//! Pages name and link what is there.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

#[path = "../support/glossary.rs"]
mod glossary;

use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The code spans of a page outside of indented blocks.
fn code_spans(page: &str) -> Vec<&str> {
    let lines = page.lines().filter(|line| !line.starts_with("    "));
    let spans = lines.flat_map(|line| line.split('`').skip(1).step_by(2));
    spans.collect()
}

/// The paths of the repository among code spans that do not exist.
fn missing<'a>(spans: &[&'a str]) -> Vec<&'a str> {
    let tops = ["crates/", "tests/", "derivations/", "designs/", ".ci/"];
    let is_path = |span: &&str| tops.iter().any(|top| span.starts_with(top));
    let is_pattern =
        |span: &&str| span.contains(['*', ' ']) || span.contains("PAPER") || span.contains("NAME");
    let paths = spans
        .iter()
        .copied()
        .filter(|span| is_path(span) && !is_pattern(span));
    paths.filter(|path| !root().join(path).exists()).collect()
}

#[test]
fn every_path_that_the_maps_name_exists() {
    assert_eq!(
        missing(&["crates/numbers/src/lib.rs", "crates/none/src"]),
        ["crates/none/src"]
    );
    for name in ["ARCHITECTURE.md", "CONTRIBUTING.md"] {
        let page = fs::read_to_string(root().join(name)).unwrap();
        let spans = code_spans(&page);
        assert!(spans.len() > 20, "{name}: {}", spans.len());
        assert_eq!(missing(&spans), [""; 0], "{name}");
    }
}

#[test]
fn every_room_has_a_row_in_the_architecture() {
    let page = fs::read_to_string(root().join("ARCHITECTURE.md")).unwrap();
    for entry in fs::read_dir(root().join("crates")).unwrap() {
        let folder = entry.unwrap().path();
        if folder.join("Cargo.toml").is_file() {
            let room = folder.file_name().unwrap().to_string_lossy().into_owned();
            assert!(page.contains(&format!("| `{room}` |")), "{room}");
        }
    }
}

/// The targets of the relative links and pictures of a page, without fragments.
fn links(page: &str) -> Vec<&str> {
    let targets = page.split("](").skip(1);
    let targets = targets.filter_map(|rest| rest.split_once(')').map(|(target, _)| target));
    let relative = targets.filter(|target| !target.contains("://") && !target.starts_with('#'));
    relative
        .map(|target| target.split('#').next().unwrap())
        .collect()
}

/// The pages in Markdown: those of the root, of the folders of pages, and of each package.
fn pages() -> Vec<PathBuf> {
    let folders = [
        "",
        "docs",
        "derivations",
        "designs",
        "proofs",
        "python",
        "reports",
    ];
    let packages = fs::read_dir(root().join("crates")).unwrap();
    let packages = packages.map(|entry| entry.unwrap().path());
    let folders = folders.iter().map(|folder| root().join(folder));
    let files = folders
        .chain(packages)
        .filter_map(|folder| fs::read_dir(folder).ok());
    let files = files.flatten().map(|entry| entry.unwrap().path());
    let is_page = |file: &PathBuf| file.extension().is_some_and(|extension| extension == "md");
    let mut pages: Vec<PathBuf> = files.filter(is_page).collect();
    pages.sort();
    pages
}

/// The page without its blocks of code.
fn without_code(page: &str) -> String {
    page.split("```").step_by(2).collect()
}

/// The fragments that lead to the headings of a page, as code hosts make them.
fn fragments(page: &str) -> Vec<String> {
    let page = without_code(page);
    let headings = page.lines().filter(|line| line.starts_with('#'));
    let fragment = |heading: &str| -> String {
        let text = heading.trim_start_matches('#').trim().to_lowercase();
        let kept = text
            .chars()
            .filter(|c| c.is_alphanumeric() || " -_".contains(*c));
        kept.map(|c| if c == ' ' { '-' } else { c }).collect()
    };
    headings.map(fragment).collect()
}

/// The relative links of a page that lead to no file, or to no heading of it.
fn dead(page: &Path) -> Vec<String> {
    let text = fs::read_to_string(page).unwrap();
    let text: String = without_code(&text).split('`').step_by(2).collect();
    let targets = text.split("](").skip(1);
    let targets = targets.filter_map(|rest| rest.split_once(')').map(|(target, _)| target));
    let relative = targets.filter(|target| !target.contains("://") && !target.contains(' '));
    let leads = |target: &&str| {
        let (file, fragment) = target.split_once('#').unwrap_or((target, ""));
        let file = match file {
            "" => page.to_owned(),
            _ => page.parent().unwrap().join(file),
        };
        match (file.extension(), fragment) {
            (_, "") => file.exists(),
            (Some(extension), _) if extension == "md" => fs::read_to_string(&file)
                .is_ok_and(|text| fragments(&text).iter().any(|known| known == fragment)),
            _ => file.exists(),
        }
    };
    let dead = relative.filter(|target| !leads(target));
    dead.map(str::to_owned).collect()
}

#[test]
fn every_link_of_every_page_leads_to_a_file_and_to_a_heading_of_it() {
    assert_eq!(
        fragments("# A b\n```\n# no\n```\n## C-d: `e`, f!"),
        ["a-b", "c-d-e-f"]
    );
    let folder = tempfile::TempDir::new().unwrap();
    let page = folder.path().join("page.md");
    let text = "# A\n[a](#a) [b](#b) [c](page.md#a) [d](none.md) [e](https://e.org/x)";
    fs::write(&page, text).unwrap();
    assert_eq!(dead(&page), ["#b", "none.md"]);
    let pages = pages();
    assert!(pages.len() > 30, "{pages:?}");
    for page in pages {
        assert_eq!(dead(&page), [""; 0], "{}", page.display());
    }
}

#[test]
fn every_page_uses_the_words_of_the_glossary() {
    let words = glossary::ruled_out();
    let own = ["CHANGELOG.md", "CHANGES.md", "glossary.md"];
    let is_own = |page: &PathBuf| own.iter().any(|name| page.ends_with(name));
    for page in pages().into_iter().filter(|page| !is_own(page)) {
        let text = fs::read_to_string(&page).unwrap();
        // Paths and names in code have words of their own.
        let text: String = without_code(&text).split('`').step_by(2).collect();
        for word in &words {
            assert!(!text.contains(word), "{}: {word}", page.display());
        }
    }
}

/// The texts of a source: what stands between quotation marks, outside of comments, with words in it.
fn texts(source: &str) -> Vec<String> {
    let lines = source
        .lines()
        .filter(|line| !line.trim_start().starts_with("//"));
    let code: String = lines.collect::<Vec<_>>().join("\n");
    let code = code.replace("'\"'", "").replace("\\\"", "");
    let texts = code.split('"').skip(1).step_by(2);
    // What stands in braces is a name of the source.
    let text = |text: &str| -> String {
        let parts = text.split('{').enumerate();
        let words = parts.map(|(number, part)| match number {
            0 => part,
            _ => part.split_once('}').map_or("", |(_, rest)| rest),
        });
        words.collect()
    };
    texts.map(text).filter(|text| text.contains(' ')).collect()
}

/// The sources below a folder.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path());
    let files = entries.flat_map(|path| match path.is_dir() {
        true => sources(&path),
        false => vec![path],
    });
    files
        .filter(|file| file.extension().is_some_and(|extension| extension == "rs"))
        .collect()
}

#[test]
fn every_text_that_reports_and_the_command_print_uses_the_words_of_the_glossary() {
    assert_eq!(
        texts("// \"no comment\"\nsay(\"a {repair} of\\\"b\", '\"', \"key\", \"c d\")"),
        ["a  ofb", "c d"]
    );
    let mut read = 0;
    for room in ["report", "torse", "cli"] {
        for file in sources(&root().join("crates").join(room).join("src")) {
            for text in texts(&fs::read_to_string(&file).unwrap()) {
                for word in glossary::ruled_out() {
                    assert!(!text.contains(word), "{}: {word}: {text}", file.display());
                }
                read += 1;
            }
        }
    }
    assert!(read > 1000, "{read}");
}

#[test]
fn every_page_of_docs_is_linked_from_its_index() {
    let index = fs::read_to_string(root().join("docs/README.md")).unwrap();
    let entries = fs::read_dir(root().join("docs")).unwrap();
    let pages = entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned());
    for name in pages.filter(|name| name.ends_with(".md")) {
        let is_linked = links(&index).contains(&name.as_str());
        assert!(is_linked || name == "README.md", "{name}");
    }
}
