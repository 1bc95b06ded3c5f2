//! What people write who know the formulas of papers, and what they are told.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

#[path = "../../../tests/support/claims.rs"]
mod claims;

use claims::paper_of;

const SHARED: &str = r#"
[symbols]
x = { in = "[0, 1]" }
lambda = {}
m = { integer = ">= 1" }
v = { vector = 3 }
P = { family = "any", indices = ["0..m"] }
[basis.B]
variable = "x"
degree = 0
seeds = ['1']
step = ['1 - x', 'x']
[define]
"Q[i]" = 'P[i]'
"#;

/// The complaint about a statement, with its help.
fn complaint(states: &str) -> String {
    let lines = format!("states = '''{states}'''");
    match paper_of("h", SHARED, &[&lines]) {
        Err(error) => format!("{error:?}"),
        Ok(paper) => {
            let claim = paper.claims.first().unwrap();
            let statement = claim.statement.as_ref().unwrap();
            match torse_elaborate::elaborate(claim, statement) {
                Err(fault) => format!("{:?}", fault.into_error(&statement.origin)),
                Ok(_) => panic!("{states} is a statement"),
            }
        }
    }
}

#[test]
fn what_papers_print_is_answered_with_what_to_write() {
    for (typed, hint) in [
        ("sin^2(x) == 1", "sin(x)^2"),
        ("x = 1", "`==`"),
        ("|x| == 1", "norm(v)"),
        ("\u{3bb} == 1", "`lambda`"),
        ("\u{3c0} == 3", "`pi`"),
        ("x^(1/2) == 1", "sqrt(x)"),
        ("x^0.5 == 1", "sqrt(x)"),
        ("x^(-2/3) == 1", "of another root `r` state `r^3 == x`"),
        ("2^x > 0", "`exp(b*log(a))`"),
        ("x^(lambda - m) > 0", "`exp(b*log(a))`"),
        ("integral(1/x, x, 1, inf) == 1", "for every finite end"),
        ("asinh(x) == 0", "`log(x + sqrt(x^2 + 1))`"),
        ("max(x, 0, lambda) >= x", "`max(a, max(b, c))`"),
        ("B(0,2)(x) == 1", "`B[0,2](x)`"),
        ("sin == 1", "`sin(x)`"),
        ("2x == 1", "`2*x`"),
        ("x lambda == 1", "`x*lambda`"),
        ("x(1 - x) == 0", "`*`"),
        ("P[1,2] == 0", "`P[i][2]`"),
        ("ln(x) == 0", "`log(x)`"),
        ("log10(x) == 0", "`log(x)/log(10)`"),
        ("arctan(x) == 0", "`atan(x)`"),
        ("atan2(x, x) == 0", "out of scope"),
        ("limit(sin(x)/x, x, 0) == 1", "limits are out of scope"),
        ("floor(x) <= x", "rounding to integers is out of scope"),
        ("gamma(x) == 0", "this function is not in the language"),
        ("max(x) == 0", "the greatest of three"),
        ("cot(x) == 0", "cos(x)/sin(x)"),
        ("\u{222b} x == 0", "integral(f, x, a, b)"),
        ("\u{220f} x == 0", "product(i, 1, k, ...)"),
        ("int(x, x, 0, 1) == 0", "integral(f, x, a, b)"),
        ("prod(i, 1, 2, x) == 0", "product(i, 1, k, ...)"),
        ("\u{2211} x == 0", "sum(i, 0, k, ...)"),
        ("v[1] \u{2265} 0", "`>=`"),
        ("Q(1) == 0", "`Q[i]`"),
        ("B[0,m,1](x) == 1", "two indices"),
    ] {
        let told = complaint(typed);
        assert!(told.contains(hint), "{typed}: {told}");
    }
}

#[test]
fn binders_say_what_they_take() {
    for (typed, wanted) in [
        (
            "integral(x, x, 1) == 1",
            "integral(formula, variable, from, to)",
        ),
        ("integral(m, m, 0, 1) == 1", "an integer"),
        ("integral(x, 2, 0, 1) == 1", "the name of a variable"),
        ("product(i, 1, 2) == 1", "product(index, low, high, factor)"),
        ("product(2, 1, 2, x) == 1", "the name of an index"),
    ] {
        let told = complaint(typed);
        assert!(told.contains(wanted), "{typed}: {told}");
    }
}
