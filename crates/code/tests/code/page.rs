//! The comparisons of the page about code are what torse finds.

use std::path::Path;
use torse_code::{CodeQuestion, CodeVerdict, compare};

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
fn the_comparisons_of_the_page_are_what_it_shows() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let path = root.join("docs/code.md");
    let page = std::fs::read_to_string(&path).unwrap();
    let mut written = page.clone();
    let mut verdicts = vec![];
    for part in page.split("<!-- run -->\n```sh\n").skip(1) {
        let (command, rest) = part.split_once("\n```").unwrap();
        let output = rest.split_once("```text\n").unwrap().1;
        let output = output.split_once("```").unwrap().0;
        let words = words(command);
        let [_, _, claim, _, code, options @ ..] = words.as_slice() else {
            panic!("{command}");
        };
        let (file, function) = code.split_once(':').unwrap();
        let text = std::fs::read_to_string(root.join(file)).unwrap();
        let mut question = CodeQuestion::new(file, text, function);
        for option in options.chunks(2) {
            match option {
                [name, value] if name == "--where" => question.conditions.push(value.clone()),
                [name, value] if name == "--map" => {
                    let (name, formula) = value.split_once('=').unwrap();
                    question.map.push((name.to_owned(), formula.to_owned()));
                }
                other => panic!("{other:?}"),
            }
        }
        let (id, _) = claim.split_once('/').unwrap();
        let paper = crate::support::paper(id);
        let found = paper
            .claims
            .iter()
            .find(|own| own.entry.id.get_ref() == claim);
        let found = compare(200_000_000, id, found.unwrap(), &question).unwrap();
        verdicts.push(found.verdict);
        let shown = format!("{claim}: {found}");
        written = written.replace(
            &format!("{command}\n```\n\n```text\n{output}```"),
            &format!("{command}\n```\n\n```text\n{shown}```"),
        );
    }
    if std::env::var_os("UPDATE_PAGE").is_some() {
        std::fs::write(&path, &written).unwrap();
    }
    assert_eq!(page, written);
    let expected = [
        CodeVerdict::Equal,
        CodeVerdict::Equal,
        CodeVerdict::Different,
    ];
    assert_eq!(verdicts, expected);
}
