//! `torse compare`: code beside the print.

use crate::support::{torse, torse_in};
use std::fs;
use tempfile::TempDir;

/// A folder with a paper of two claims that name functions, and a file of code.
fn folder() -> TempDir {
    let folder = TempDir::new().unwrap();
    let paper = folder.path().join("derivations/mine");
    fs::create_dir_all(&paper).unwrap();
    let head = "[paper]\nid = 'mine'\ntitle = ''\nauthors = ''\nvenue = ''\nclaims = ['c.toml']\n[symbols]\nx = {}\nn = { integer = '>= 1' }\n";
    fs::write(paper.join("paper.toml"), head).unwrap();
    let claims = "\
        [[claim]]\nid = 'mine/cube'\nat = 'eq. (1)'\nkind = 'identity'\nprinted = ''\nstates = '(x - 1)^3 == x^3 - 3*x^2 + 3*x - 1'\n\
        code = { file = 'cube.py', function = 'cube', map = { t = 'x' } }\n\
        [[claim]]\nid = 'mine/power'\nat = 'eq. (2)'\nkind = 'identity'\nprinted = ''\nstates = 'x*x^n == x^(n + 1)'\n\
        code = { file = 'cube.py', function = 'power', where = ['n == 4'], part = 1, side = 'left' }\n\
        [[claim]]\nid = 'mine/none'\nat = 'eq. (3)'\nkind = 'identity'\nprinted = ''\nstates = 'x + x == 2*x'\n";
    fs::write(paper.join("c.toml"), claims).unwrap();
    let code = "def cube(t):\n    return t**3 - 3*t**2 + 3*t - 1\n\n\ndef power(x, n):\n    p = x\n    for _ in range(n):\n        p = p*x\n    return p\n";
    fs::write(paper.join("cube.py"), code).unwrap();
    folder
}

#[test]
fn the_functions_that_claims_name_are_compared() {
    let folder = folder();
    let ran = torse_in(folder.path(), &["compare", "mine"]);
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""), "{}", ran.out);
    assert_eq!(ran.out.matches(": equal\n").count(), 2, "{}", ran.out);

    let code = folder.path().join("derivations/mine/cube.py");
    let text = fs::read_to_string(&code).unwrap().replace("3*t**2", "3*t");
    fs::write(&code, text).unwrap();
    let ran = torse_in(folder.path(), &["compare", "mine", "--format", "json"]);
    assert_eq!(ran.code, Some(1), "{}", ran.err);
    let lines: Vec<serde_json::Value> = ran
        .out
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    assert_eq!(lines[0]["verdict"], "different");
    assert_eq!(lines[0]["code_edit"]["line"], 2);
    assert_eq!(lines[1]["verdict"], "equal");

    let ran = torse_in(folder.path(), &["compare", "mine/none"]);
    assert_eq!(ran.code, Some(2));
    assert!(
        ran.err.contains("no claim of `mine/none` names a function"),
        "{}",
        ran.err
    );
}

#[test]
fn code_that_is_not_read_is_an_error_of_its_file() {
    let folder = folder();
    let code = folder.path().join("f.py");
    fs::write(&code, "def f(x):\n    return x^2\n").unwrap();
    let named = format!("{}:f", code.display());
    let ran = torse_in(folder.path(), &["compare", "mine/none", "--code", &named]);
    assert_eq!(ran.code, Some(4), "{}", ran.out);
    for part in ["f.py:2:13", "`^` exchanges bits", "`**` is the power"] {
        assert!(ran.err.contains(part), "{part}: {}", ran.err);
    }
    let ran = torse_in(
        folder.path(),
        &["compare", "mine/none", "--code", "missing.py:f"],
    );
    assert_eq!(ran.code, Some(2));
    assert!(ran.err.contains("missing.py cannot be read"), "{}", ran.err);
    let ran = torse(&["compare", "mine/none", "--code", "f.py"]);
    assert_eq!(ran.code, Some(2));
}
