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
            text.contains("eq. (slip)") && text.contains("We propose one correction"),
            "{text}"
        );
        let (corrections, questions) = text.split_once("Please compare").unwrap();
        assert!(!corrections.contains("eq. (copy)"), "{text}");
        assert!(questions.contains("eq. (copy)"), "{text}");
        assert!(!text.contains("eq. (right)"), "{text}");
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
    assert!(letter.contains("None was found to be false"), "{letter}");
}

const FAULT: &str = r#"
[[corrigendum]]
id = "mini/corrigendum.coefficient"
says = "the coefficient is {a}, and not {b}"
shows = ["mini/slip", "mini/product"]
define = { b = '2' }
[[corrigendum.change]]
claim = "mini/slip"
reads = "y = 2 x"
states = 'x + x == 2*x'
"#;

#[test]
fn all_corrections_of_a_letter_are_in_force_together_when_it_is_verified() {
    let slip = claim("slip", "x + x == 3*x", "let = { a = '2', b = '3' }");
    let product = claim("product", "(x + x)*x == b*x^2", "let = { b = '3' }");
    let folder = mini(&[slip, product, FAULT.to_owned()].concat());
    let out = TempDir::new().unwrap();
    let path = out.path().to_str().unwrap();
    let letter = |more: &[&str]| {
        let words = [&["erratum", "mini", "--out", path], more].concat();
        let ran = on(folder.path(), &words);
        assert_eq!(ran.code, Some(0), "{}", ran.err);
        (
            ran.out,
            fs::read_to_string(out.path().join("mini-erratum.md")).unwrap(),
        )
    };
    let (_, plain) = letter(&[]);
    assert!(
        plain.contains("The coefficient is 2, and not 3."),
        "{plain}"
    );
    assert_eq!(plain.matches("\n### ").count(), 1, "{plain}");
    assert!(!plain.contains("checked again"), "{plain}");
    let (said, verified) = letter(&["--verify"]);
    assert!(said.contains("mini/product  holds"), "{said}");
    assert!(
        verified.contains("the 2 statements that they concern were checked again: 2 are true."),
        "{verified}"
    );
}

#[test]
fn words_that_say_something_else_than_what_is_decided_are_refused() {
    let fault = r#"
[[corrigendum]]
id = "mini/corrigendum.square"
says = "A term is missing"
shows = ["mini/square"]
[[corrigendum.change]]
claim = "mini/square"
reads = "(x + y)^2 = x^2 + 2xy + y^2"
states = "(x + y)^2 == x^2 + 2*x*y + y^2"
"#;
    let square = claim("square", "(x + y)^2 == x^2 + y^2", "symbols = { y = {} }");
    let out = TempDir::new().unwrap();
    let path = out.path().join("letters");
    let verified = |fault: &str| {
        let folder = mini(&[square.clone(), fault.to_owned()].concat());
        let words = ["erratum", "mini", "--verify", "--out"];
        on(
            folder.path(),
            &[&words[..], &[path.to_str().unwrap()]].concat(),
        )
    };
    let slip = verified(&fault.replace("+ 2xy", "- 2xy"));
    assert_eq!(slip.code, Some(4), "{}", slip.err);
    for told in ["mini/square", "x^2 - 2xy + y^2", "x^2 + 2*x*y + y^2"] {
        let plain = slip.err.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(plain.contains(told), "{told}: {}", slip.err);
    }
    assert!(!path.exists());
    let right = verified(fault);
    assert_eq!(right.code, Some(0), "{}", right.err);
}

#[test]
fn a_fault_names_claims_of_its_paper_and_quotes_their_prints() {
    let wrong = FAULT
        .replace("\"mini/product\"", "\"mini/nothing\"")
        .replace("reads", "printed = \"z\"\nreads");
    let slip = claim("slip", "x + x == 3*x", "let = { a = '2', b = '3' }");
    let folder = mini(&[slip, wrong].concat());
    let ran = on(folder.path(), &["erratum", "mini"]);
    assert_eq!(ran.code, Some(4), "{}", ran.err);
    for told in [
        "no claim has the id `mini/nothing`",
        "these words are not in the print of `mini/slip`",
    ] {
        assert!(ran.err.contains(told), "{told}: {}", ran.err);
    }
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

#[test]
fn what_rests_on_a_correction_is_decided_with_it_and_words_alone_are_named() {
    let slip = claim("slip", "x + x == 3*x", "let = { a = '2', b = '3' }");
    let product = claim("product", "(x + x)*x == b*x^2", "");
    // True as printed, and broken by the correction of b; true before and after; about nothing that is corrected.
    let broken = claim("broken", "b*x == 3*x", "uses = [\"mini/product\"]");
    let kept = claim("kept", "x*b == b*x", "");
    let other = claim("other", "x == x", "");
    let title = claim("title", "", "out_of_scope = 'a title'").replace("states = ''\n", "");
    let define = "[define]\nb = '3'\n".to_owned();
    let change = "[[corrigendum.change]]\nclaim = \"mini/title\"\nreads = \"Twice\"\n".to_owned();
    let folder = mini(
        &[
            define,
            slip,
            product,
            broken,
            kept,
            other,
            title,
            FAULT.to_owned(),
            change,
        ]
        .concat(),
    );
    let out = TempDir::new().unwrap();
    let path = out.path().to_str().unwrap();
    let ran = on(
        folder.path(),
        &["erratum", "mini", "--verify", "--out", path],
    );
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    for line in [
        "mini/product  holds\n",
        "mini/broken  misprint, rests on a corrected statement\n",
        "mini/kept  holds, rests on a corrected statement\n",
        "mini/title  words alone\n",
    ] {
        assert!(ran.out.contains(line), "{line}: {}", ran.out);
    }
    assert!(!ran.out.contains("mini/other"), "{}", ran.out);
    let letter = fs::read_to_string(out.path().join("mini-erratum.md")).unwrap();
    for says in [
        "The 2 other statements that rest on these or on a corrected definition were checked with them: 1 is true and 1 is not true (Sect. 1, eq. (broken)).",
        "1 change is of words alone; nothing is computed about it (Sect. 1, eq. (title)).",
    ] {
        assert!(letter.contains(says), "{says}: {letter}");
    }
}
