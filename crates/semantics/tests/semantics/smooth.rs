//! A smooth function is worth what any function with its derivatives at the place is worth: here of a polynomial.

use crate::support::{at, claim};
use torse_semantics::{Judgement, Witness};

/// A polynomial and its derivatives at 2, at 5 and at 29, by hand.
const BODY: &str = "x^4 - 2*x^3 + 3*x - 1";
const AT_2: [i64; 5] = [5, 11, 24, 36, 24];
const AT_5: [i64; 5] = [389, 353, 240, 108, 24];

/// The judgement of a statement about h and the polynomial k, at y = 2, where the derivatives of h are these at this place.
fn judged(states: &str, place: &str, derivatives: &[i64]) -> Judgement {
    let fields = format!(
        "symbols = {{ h = {{ function = 1 }} }}\nlet = {{ \"k(x)\" = '{BODY}', \"H(x)\" = 'x*h(x)^2', \"K(x)\" = 'x*k(x)^2' }}"
    );
    let claim = claim(&fields, states);
    let names: Vec<(String, String)> = derivatives
        .iter()
        .enumerate()
        .map(|(n, value)| (format!("h{}({place})", "'".repeat(n)), value.to_string()))
        .chain([("y".to_owned(), "2".to_owned())])
        .collect();
    let numbers = names.iter().map(|(n, v)| (n.as_str(), v.as_str()));
    at(&claim, &numbers.collect::<Vec<_>>())
}

/// The formulas in a function F, and the place at which they look at it where y = 2, with its derivatives there.
const FORMULAS: [(&str, &str, [i64; 5]); 14] = [
    ("F(y)", "y", AT_2),
    ("D(F''(y), y)", "y", AT_2),
    ("D(F, x, 2)(y)", "y", AT_2),
    ("D(F(y), y)", "y", AT_2),
    ("D(y^2*F(y)^3, y, 2)", "y", AT_2),
    ("D(D(y*F(y), y)*F(y), y)", "y", AT_2),
    ("D(1/F(y), y, 3)", "y", AT_2),
    ("D(F''(y)*F'(y), y, 2)", "y", AT_2),
    ("at(D(F(y)^2, y, 2), y, 2)", "2", AT_2),
    ("at(D(F(y) + y^3, y), y, 5)", "5", AT_5),
    ("F(2*y + 1)", "2*y + 1", AT_5),
    ("D(F(2*y + 1)^2, y, 2)", "2*y + 1", AT_5),
    ("D(F'(y^2 + 1)*y, y, 2)", "y^2 + 1", AT_5),
    ("sum(i, 1, 3, i*D(F(y)^2, y))", "y", AT_2),
];

#[test]
fn a_formula_in_a_function_is_worth_what_it_is_for_a_polynomial_with_its_derivatives() {
    for (formula, place, derivatives) in FORMULAS {
        let states = format!(
            "{} == {}",
            formula.replace('F', "h"),
            formula.replace('F', "k")
        );
        let right = judged(&states, place, &derivatives);
        assert_eq!(right, Judgement::True, "{states}");
        // Every derivative that the formula looks at counts.
        let wrong = derivatives.map(|d| d + 1);
        let wrong = judged(&states, place, &wrong);
        assert_eq!(wrong, Judgement::False, "{states}");
    }
}

#[test]
fn a_function_that_is_defined_by_another_one_has_its_derivatives() {
    for states in [
        "H'(y) == K'(y)",
        "D(H(y)/y, y, 2) == D(K(y)/y, y, 2)",
        "H''(2) == K''(2)",
    ] {
        let place = if states.contains("(2)") { "2" } else { "y" };
        assert_eq!(judged(states, place, &AT_2), Judgement::True, "{states}");
    }
}

#[test]
fn counterexamples_name_values_and_derivatives() {
    let c = claim(
        "symbols = { h = { function = 3 }, k = { function = 1 } }",
        "D(k(y)*h(y), y)[1] == k(y)*h'(y)[1]",
    );
    let check = |slope| {
        let point = [
            ("y", "2"),
            ("h(y)[1]", "2"),
            ("h(y)[2]", "0"),
            ("h(y)[3]", "0"),
            ("h'(y)[1]", "1"),
            ("h'(y)[2]", "0"),
            ("h'(y)[3]", "0"),
            ("k(y)", "1"),
            ("k'(y)", slope),
        ];
        c.check(&point)
    };
    assert_eq!(check("1"), Witness::Refutes);
    assert_eq!(check("0"), Witness::Stands(Judgement::True));
}
