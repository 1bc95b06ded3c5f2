//! `torse erratum`: the letters that it writes.

use crate::support::{claim, mini, on};
use std::fs;
use tempfile::TempDir;

#[test]
fn the_corrections_of_a_paper_are_written_in_three_forms_and_the_same_twice() {
    let slip = claim("slip", "(1 - x)^2 + 2*x == 1 - x^2", "");
    let garbled = claim("copy", "x == 2*x", "garbled = \"2 for 1\"");
    let folder = mini(&[claim("right", "x == x", ""), slip, garbled].concat());
    let letters = || {
        let out = TempDir::new().unwrap();
        let path = out.path().to_str().unwrap();
        let ran = on(folder.path(), &["erratum", "mini", "--out", path]);
        assert_eq!(ran.code, Some(0), "{}", ran.err);
        assert_eq!(ran.out.lines().count(), 3, "{}", ran.out);
        ["tex", "pdf", "md"]
            .map(|ending| fs::read(out.path().join(format!("mini-erratum.{ending}"))).unwrap())
    };
    let first = letters();
    assert!(first == letters(), "the bytes differ");
    let [tex, pdf, markdown] = first;
    assert!(pdf.starts_with(b"%PDF-"));
    let (tex, markdown) = (
        String::from_utf8(tex).unwrap(),
        String::from_utf8(markdown).unwrap(),
    );
    for text in [&tex, &markdown] {
        assert!(
            text.contains("eq. (slip)") && text.contains("One statement"),
            "{text}"
        );
        assert!(
            !text.contains("eq. (copy)") && !text.contains("eq. (right)"),
            "{text}"
        );
        assert!(text.contains("@misc{torse-mini"), "{text}");
    }
    assert!(tex.starts_with("\\documentclass") && tex.ends_with("\\end{document}\n"));
}

#[test]
fn a_paper_without_corrections_gets_a_letter_that_says_so() {
    let folder = mini(&claim("right", "x == x", ""));
    let out = TempDir::new().unwrap();
    let path = out.path().to_str().unwrap();
    let ran = on(folder.path(), &["erratum", "mini", "--out", path]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let letter = fs::read_to_string(out.path().join("mini-erratum.md")).unwrap();
    assert!(
        letter.contains("No statement of this paper was found to be false"),
        "{letter}"
    );
}

#[test]
fn an_unknown_paper_and_a_folder_that_cannot_be_written_to_are_named() {
    let folder = mini(&claim("a", "x == x", ""));
    let ran = on(folder.path(), &["erratum", "maxi"]);
    assert_eq!((ran.code, ran.out.as_str()), (Some(2), ""));
    assert!(
        ran.err.contains("maxi") && ran.err.contains("the papers are mini"),
        "{}",
        ran.err
    );
    let none = on(folder.path(), &["erratum"]);
    assert_eq!(none.code, Some(2), "{}", none.err);
    let occupied = folder.path().join("occupied");
    fs::write(&occupied, "a file").unwrap();
    let path = occupied.to_str().unwrap();
    let ran = on(folder.path(), &["erratum", "mini", "--out", path]);
    assert_eq!(ran.code, Some(5), "{}", ran.err);
    assert!(
        ran.err.contains("cannot write") && ran.err.contains("occupied"),
        "{}",
        ran.err
    );
}

#[test]
fn nothing_is_written_while_a_file_is_wrong() {
    let folder = mini(&claim("a", "x == ", ""));
    let out = TempDir::new().unwrap();
    let path = out.path().join("letters");
    let ran = on(
        folder.path(),
        &["erratum", "mini", "--out", path.to_str().unwrap()],
    );
    assert_eq!(ran.code, Some(4), "{}", ran.err);
    assert!(!path.exists());
}
