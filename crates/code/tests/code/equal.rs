//! Functions that compute what the papers print.

use crate::support::{PYTHON, RUST, Row, program};
use torse_code::CodeVerdict;

fn all_are_equal(file: &str, rows: &[Row]) {
    let text = program(file);
    let mut wrong = vec![];
    for row in rows {
        match row.compare(file, &text) {
            Ok(found) if found.verdict == CodeVerdict::Equal => {}
            Ok(found) => wrong.push(format!("{}: {found}", row.function)),
            Err(error) => wrong.push(format!(
                "{}: {}",
                row.function,
                crate::support::line(&error, &text)
            )),
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn functions_of_python_equal_the_formulas_that_they_implement() {
    all_are_equal("curves.py", &PYTHON);
}

#[test]
fn functions_of_rust_equal_the_formulas_that_they_implement() {
    all_are_equal("curves.rs", &RUST);
}
