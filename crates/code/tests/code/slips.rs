//! The same functions with one slip each: compare finds the difference, and the change that takes the slip back.

use crate::support::{PYTHON, RUST, Row, program};
use torse_code::{CodeEdit, CodeVerdict};

/// A slip: the function, what stands there, and what is written by mistake.
type Slip = (&'static str, &'static str, &'static str);

const PYTHON_SLIPS: [Slip; 14] = [
    ("curve", "(1 - x)**(m - i)*P[i]", "(1 + x)**(m - i)*P[i]"),
    (
        "casteljau",
        "(1 - x)*q[i] + x*q[i + 1]",
        "(1 - x)*q[i] - x*q[i + 1]",
    ),
    ("hodograph", "2*x*(1 - x)*d[1]", "x*(1 - x)*d[1]"),
    ("last_tangent", "m*(P[m] - P[m - 1])", "m*(P[m] + P[m - 1])"),
    ("second_derivative", "- 2*P[1] + P[2]", "- P[1] + P[2]"),
    ("middle", "[1, 3, 3, 1]", "[1, 3, 2, 1]"),
    ("first", "(1 - mu*s)", "(1 + mu*s)"),
    ("third", "np.cos(0.5*np.pi*z)", "np.sin(0.5*np.pi*z)"),
    ("basis", "(1 - z)*basis(", "(1 + z)*basis("),
    ("cubic", "- 2*p0u - p1u", "- 2*p0u - p1"),
    ("quartic", "- 11*p0 +", "- 12*p0 +"),
    ("uniform", "- 6*s**2 + 4", "- 6*s**2 + 3"),
    ("inner", "- mu*cos(t)**2", "- mu*cos(t)"),
    ("tangent", "(1 - lamda*sin(t))", "(1 + lamda*sin(t))"),
];

const RUST_SLIPS: [Slip; 9] = [
    ("curve", "(1.0 - x).powi", "(1.0 + x).powi"),
    ("casteljau", "for k in 1..q.len()", "for k in 2..q.len()"),
    (
        "second_derivative",
        "p[m] - 2.0 * p[m - 1]",
        "p[m] - 3.0 * p[m - 1]",
    ),
    ("middle", "total += weight", "total -= weight"),
    ("first", "(1.0 - mu * s)", "(1.0 + mu * s)"),
    ("third", "f64::cos(0.5", "f64::cos(0.25"),
    (
        "basis",
        "basis(k, m - 1, z, mu, nu) +",
        "basis(k, m - 1, z, mu, nu) -",
    ),
    ("cubic", "+ 3.0 * p1 - 2.0 * p0u", "+ 3.0 * p1 + 2.0 * p0u"),
    ("uniform", "(1.0 - s).powi(3)", "(1.0 - s).powi(2)"),
];

/// The program with the change made.
fn mended(text: &str, edit: &CodeEdit) -> String {
    let mut lines: Vec<&str> = text.lines().collect();
    let then = edit.line_then.as_deref().unwrap();
    assert_eq!(lines[edit.line - 1], edit.line_now);
    lines[edit.line - 1] = then;
    lines.join("\n")
}

fn all_are_found(file: &str, rows: &[Row], slips: &[Slip]) -> usize {
    let text = program(file);
    let mut taken_back = 0;
    let mut wrong = vec![];
    for (row, (function, right, slip)) in rows.iter().zip(slips) {
        assert_eq!(row.function, *function);
        let start = text.find(&format!("{function}(")).unwrap();
        let at = start + text[start..].find(right).unwrap();
        let changed = format!("{}{slip}{}", &text[..at], &text[at + right.len()..]);
        let found = row.compare(file, &changed).unwrap();
        assert_eq!(found.verdict, CodeVerdict::Different, "{function}: {found}");
        assert!(found.witness.is_some(), "{function}: {found}");
        let Some(edit) = &found.code_edit else {
            wrong.push(format!("{function}: {found}"));
            continue;
        };
        let mended = mended(&changed, edit);
        let again = row.compare(file, &mended);
        match again {
            Ok(again) if again.verdict == CodeVerdict::Equal => taken_back += 1,
            Ok(again) => wrong.push(format!("{function}: {edit}\n{again}")),
            Err(error) => wrong.push(format!("{function}: {edit}\n{error}")),
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    taken_back
}

#[test]
fn a_slip_in_a_function_of_python_is_found_and_taken_back() {
    assert_eq!(all_are_found("curves.py", &PYTHON, &PYTHON_SLIPS), 14);
}

#[test]
fn a_slip_in_a_function_of_rust_is_found_and_taken_back() {
    assert_eq!(all_are_found("curves.rs", &RUST, &RUST_SLIPS), 9);
}
