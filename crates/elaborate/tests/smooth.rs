//! Smooth functions: what they become in core terms, and where they are refused.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use torse_core::Set;

#[path = "../../../tests/support/claims.rs"]
mod claims;

const SHARED: &str = r#"
[symbols]
u = {}
v = {}
w = { in = "[0, 1)" }
z = { in = "[1, 2]" }
m = { integer = ">= 0" }
p = { vector = 3 }
c = { function = 3 }
g = { function = "any" }
f = { function = 1 }

[define]
"F(x)" = 'x^2*f(x)'
"K(x)" = '3'
"T(x, y)" = 'f(y)'

[basis.B]
variable = "u"
degree = 0
seeds = ['f(u)']
step = ['1 - u', 'u']
"#;

/// The symbols of a statement, or why it is refused.
fn symbols(states: &str) -> Result<Vec<String>, String> {
    let lines = format!("states = \"{states}\"");
    let paper = claims::paper_of("t", SHARED, &[&lines]).map_err(|e| format!("{e:?}"))?;
    let claim = paper.claims.first().unwrap();
    let core = torse_elaborate::elaborate(claim, claim.statement.as_ref().unwrap())
        .map_err(|f| f.problem.to_string())?;
    let named = |(name, set): (&std::sync::Arc<str>, &Set)| match set {
        Set::Vector(Some(n)) => format!("{name}: {n}"),
        Set::Vector(None) => format!("{name}: any"),
        _ => name.to_string(),
    };
    Ok(core.symbols.iter().map(named).collect())
}

#[track_caller]
fn has(states: &str, wanted: &[&str]) {
    assert_eq!(symbols(states).unwrap(), wanted, "{states}");
}

#[track_caller]
fn refused(states: &str, why: &str) {
    let found = symbols(states).unwrap_err();
    assert!(found.contains(why), "{states}: {found}");
}

#[test]
fn a_function_becomes_the_derivatives_that_are_looked_at() {
    has("f(u) == 0", &["f(u)"]);
    has("c''(u) == 0", &["c''(u): 3"]);
    has("g'(u) == g(u)", &["g'(u): any", "g(u): any"]);
    // Two variables move the place: the function is differentiated by both.
    has(
        "D(D(f(u + v), u), v) == 0",
        &["f''(u + v)", "f'(u + v)", "f(u + v)", "u", "v"],
    );
    has("D(D(f(u), u), u) == f'''(u)", &["f'''(u)", "f''(u)"]);
    has("D(f(u)^2, u, 2) == 0", &["f''(u)", "f'(u)", "f(u)", "u"]);
    has("F'(1/2) == 0", &["f'(1/2)", "f(1/2)"]);
    has("at(D(f(u), u), u, v) == 0", &["f'(v)"]);
}

#[test]
fn a_function_may_be_taken_at_a_formula_or_another_function() {
    has("f(2*u + v) == 0", &["f(2*u + v)"]);
    has("c(f(u)) == 0", &["c(f(u)): 3"]);
    has(
        "D(c(f(u)), u) == 0",
        &["c'(f(u)): 3", "c(f(u)): 3", "f'(u)", "f(u)", "u"],
    );
}

#[test]
fn places_that_are_certainly_different_may_be_mixed() {
    has("f(0) == f(1)", &["f(0)", "f(1)"]);
    has("f(1/2 + 1/2 - 1/2) == 0", &["f(1/2 + 1/2 - 1/2)"]);
    has("f(w) == f(z)", &["f(w)", "f(z)"]);
    has("f(w) == f(1)", &["f(1)", "f(w)"]);
    // What is called with 1/u has no value at u = 0.
    has("T(1/u, u) == 0", &["f(u)", "u"]);
    // Each function for itself.
    has("f(u)*c(v) == 0", &["c(v): 3", "f(u)"]);
}

#[test]
fn places_that_may_be_the_same_are_refused() {
    let same = "which may be the same place";
    refused("f(u) == f(0)", same);
    refused("f(u) == f(v)", same);
    refused("f(w) == f(0)", same);
    refused("f(z) == f(1)", same);
    refused("f(u) == f(2*u)", same);
    refused("f(u + v) == f(v + u)", same);
    refused("f(m) == f(1)", same);
    refused("f(f(u)) == 0", same);
}

#[test]
fn what_is_no_place_is_refused() {
    let no_place = "a smooth function at what is no symbol";
    refused("f(sin(u)) == 0", no_place);
    refused("f(p[1]) == 0", no_place);
    // These have no value at u = 0, where the derivative's symbol would have one.
    refused("f(1/u) == 0", no_place);
    refused("f(u^(-1)) == 0", no_place);
    refused("f(K(1/u)) == 0", no_place);
    refused("sum(i, 0, 2, f(i)) == 0", no_place);
    refused("D(f(u), u, m) == 0", no_place);
    refused("D(f(u), u, 13) == 0", "differentiated more than 12 times");
    refused("B[0,1](u) == 0", "in the seeds or the step of a basis");
    refused("f == 0", "a function where");
    refused("f(u, v) == 0", "takes 1 argument");
}
