//! Order relations: assumptions, ranges, conditions and counterexamples.

use crate::common;

use torse_prove::evidence::Evidence;
use torse_syntax::taxonomy::Verdict;
use torse_verdicts::outcome::Outcome;
use torse_verdicts::words;

const SYMBOLS: &str = r#"
[symbols]
a = { in = "[0, 1]" }
b = { in = "[0, 1]" }
mu = { in = "[-1, 1]" }
x = { in = "[0, 1]" }
y = {}
z = {}
[basis.B]
variable = "x"
degree = 0
seeds = ['1']
step = ['1 - x', 'x']
[basis.f]
variable = "x"
parameters = ["mu"]
degree = 1
seeds = ['(1 - sin(pi/2*x))*(1 - mu*sin(pi/2*x))', '1 - (1 - sin(pi/2*x))*(1 - mu*sin(pi/2*x))']
step = ['1 - x', 'x']
[basis.outside]
variable = "x"
degree = 1
seeds = ['1 + x', '2 - x']
step = ['1 - x', 'x']
[basis.backwards]
variable = "x"
degree = 1
seeds = ['x', '1 - x']
step = ['x', '1 - x']
[basis.q]
variable = "x"
parameters = ["mu"]
degree = 2
seeds = ['(1 - sin(pi/2*x))*(1 - mu*sin(pi/2*x))', 'sin(pi/2*x) + mu*sin(pi/2*x)*(1 - sin(pi/2*x)) - 1 + cos(pi/2*x)', '1 - cos(pi/2*x)']
step = ['1 - x', 'x']
[basis.sharp]
variable = "x"
degree = 1
seeds = ['1 - x^2', 'x^2']
step = ['1 - x^3', 'x^3']
[basis.hump]
variable = "x"
degree = 1
seeds = ['1 - 2*x*(1 - x)', '2*x*(1 - x)']
step = ['1 - x', 'x']
"#;

fn outcome(name: &str, lines: &str) -> Outcome {
    common::outcomes(name, SYMBOLS, &[lines]).remove(0)
}

#[test]
fn assumed_inequalities_bound_the_domain_of_a_proof() {
    let claims = [
        ("a > b", "a - b > 0"),
        ("a >= b", "a^3 >= b^3"),
        ("a + b >= 1", "a^2 + b^2 > 1/4"),
        ("a + b >= 1", "a + 2*b >= 1"),
        ("a < 1/3", "10*a^2 - 19*a + 6 > 0"),
        ("y > 5", "y > 4"),
        ("y > 5", "y != 0"),
    ];
    for (number, (assume, states)) in claims.into_iter().enumerate() {
        let with = format!("assume = ['{assume}']\nstates = '{states}'");
        let with = outcome(&format!("assumed-{number}"), &with);
        assert_eq!(
            (with.verdict(), with.evidence()),
            (Verdict::Holds, Some(Evidence::Inequality)),
            "{assume}: {states}: {with:?}"
        );
        assert!(
            words::steps(&with)
                .iter()
                .any(|s| s.contains("assumptions")),
            "{with:?}"
        );
        let without = outcome(
            &format!("unassumed-{number}"),
            &format!("states = '{states}'"),
        );
        assert_eq!(without.verdict(), Verdict::False, "{states}: {without:?}");
    }
}

#[test]
fn an_assumption_proves_nothing_beyond_it() {
    for (number, (assume, states)) in [("a > b", "b - a > 0"), ("a + b >= 1", "a >= 1/2")]
        .into_iter()
        .enumerate()
    {
        let lines = format!("assume = ['{assume}']\nstates = '{states}'");
        let found = outcome(&format!("beyond-{number}"), &lines);
        assert_eq!(found.verdict(), Verdict::False, "{found:?}");
    }
}

#[test]
fn assumptions_that_exclude_each_other_leave_nothing() {
    for (number, assume) in ["'a > 3/4', 'a < 1/2'", "'a > b', 'b > a'"]
        .into_iter()
        .enumerate()
    {
        let lines = format!("assume = [{assume}]\nstates = 'a == 0'");
        let found = outcome(&format!("empty-{number}"), &lines);
        assert_eq!(found.verdict(), Verdict::Vacuous, "{found:?}");
    }
}

#[test]
fn a_zero_at_a_corner_is_seen_where_coefficients_have_different_degrees() {
    let form = "(1 - a)^2 + 2*a*(1 - a)*(1 + b) + a^2*(2*b - b^2)";
    let strict = outcome("corner", &format!("states = '{form} > 0'"));
    assert_eq!(strict.verdict(), Verdict::False, "{strict:?}");
    assert_eq!(strict.witness().unwrap().left, "0");
    let weak = outcome("corner-weak", &format!("states = '{form} >= 0'"));
    assert_eq!(weak.verdict(), Verdict::Holds, "{weak:?}");
}

#[test]
fn squares_are_nonnegative_wherever_they_vanish() {
    let squares = [
        "(1 - 3*a)^2 >= 0",
        "(1 - 3*a)^2*(7*b - 5)^4*(1 + a) >= 0",
        "(1 - sin(pi/2*x))^2*(1 - 3*a)^2 >= 0",
    ];
    for (number, states) in squares.into_iter().enumerate() {
        let found = outcome(&format!("square-{number}"), &format!("states = '{states}'"));
        assert_eq!(found.verdict(), Verdict::Holds, "{states}: {found:?}");
    }
    let strict = outcome("square-strict", "states = '(1 - 3*a)^2 > 0'");
    assert_eq!(
        strict.witness().unwrap().at,
        [("a".to_owned(), "1/3".to_owned())]
    );
    let cube = outcome("cube", "states = '(1 - 3*a)^3 >= 0'");
    assert_eq!(cube.verdict(), Verdict::False);
}

#[test]
fn a_proved_relation_says_whether_its_ranges_are_sharp() {
    let steps = |name: &str, states: &str| {
        let found = outcome(name, &format!("states = '{states}'"));
        assert_eq!(found.verdict(), Verdict::Holds, "{found:?}");
        words::steps(&found)
    };
    let sharp = steps("sharp", "(1 - sin(pi/2*x))*(1 - mu*sin(pi/2*x)) >= 0");
    assert!(
        sharp.contains(
            &"the range of mu cannot be larger: at mu = 1025/1024, tan(pi/4*x) = 31/32 it fails"
                .to_owned()
        ),
        "{sharp:?}"
    );
    // The lower end is no end of the truth.
    assert!(
        sharp.contains(
            &"the range of mu may be widened to -17/16: it is proved there too".to_owned()
        ),
        "{sharp:?}"
    );
    let family = steps("sharp-family", "nonnegative(f)");
    assert!(
        family
            .iter()
            .any(|s| s.starts_with("the range of mu cannot be larger: at mu = 1025/1024, ")),
        "{family:?}"
    );
}

#[test]
fn a_range_may_be_widened_only_where_all_that_the_statement_rests_on_is_proved_beyond_it() {
    let widened = |name: &str, states: &str| {
        let lines = format!("states = '{states}'\nsymbols = {{ q = {{ in = \"(0, 1]\" }} }}");
        let found = outcome(name, &lines);
        assert_eq!(found.verdict(), Verdict::Holds, "{found:?}");
        let steps = words::steps(&found);
        steps.iter().any(|step| step.contains("may be widened"))
    };
    assert!(widened("wider", "q + a + 2 >= 0"));
    let narrow = [
        // False at a = -1/16, where abs(a) is no longer a.
        "2 + 35*a - 34*abs(a) >= 0",
        // The seeds are positive beyond the range, the step factors are not: the function (2, 2) is negative.
        "nonnegative(outside)",
        // Without a value at q = 0.
        "q^2/q + 2 >= 0",
        "a + 2 >= 0 and a == abs(a)",
    ];
    for (number, states) in narrow.into_iter().enumerate() {
        assert!(
            !widened(&format!("narrow-end-{number}"), states),
            "{states}"
        );
    }
}

#[test]
fn conditions_are_the_factors_of_the_divisors() {
    let found = outcome(
        "factors",
        "states = '(y^2 - z^2)*(1/((y^2 - z^2)*y) + 1/(y + z)) == 1/y + y - z'",
    );
    assert_eq!(found.verdict(), Verdict::Conditional, "{found:?}");
    let conditions: Vec<&str> = found.conditions().iter().map(|c| c.text.as_str()).collect();
    assert_eq!(conditions, ["y != 0", "y - z != 0", "y + z != 0"]);
}

#[test]
fn counterexamples_are_found_in_narrow_and_negative_ranges() {
    let claims = [
        (r#"q = { in = "(5, 6)" }"#, "q != 11/2", "11/2"),
        (r#"q = { in = "[7/3, 12/5]" }"#, "q > 7/3", "7/3"),
        (r#"q = { in = "(157/50, 63/20)" }"#, "q != 22/7", "22/7"),
        (r#"q = { in = "[-1, 0)" }"#, "sin(pi/2*q) >= 0", "-1/2"),
        (r#"q = { in = "(17, inf)" }"#, "q < 18", "18"),
        (r#"q = { integer = ">= 40" }"#, "q > 40", "40"),
    ];
    for (number, (symbol, states, at)) in claims.into_iter().enumerate() {
        let lines = format!("states = '{states}'\nsymbols = {{ {symbol} }}");
        let found = outcome(&format!("narrow-{number}"), &lines);
        assert_eq!(found.verdict(), Verdict::False, "{states}: {found:?}");
        let witness = found.witness().unwrap();
        assert_eq!(witness.at, [("q".to_owned(), at.to_owned())], "{states}");
    }
}

#[test]
fn variation_diminution_is_proved_for_powers_and_refuted_by_a_curve() {
    for basis in ["B", "backwards"] {
        let proved = outcome(basis, &format!("states = 'variation_diminishing({basis})'"));
        assert_eq!(
            (proved.verdict(), proved.evidence()),
            (Verdict::Holds, Some(Evidence::Induction)),
            "{proved:?}"
        );
    }
    let refuted = outcome("hump", "states = 'variation_diminishing(hump)'");
    assert_eq!(refuted.verdict(), Verdict::False, "{refuted:?}");
    // One change of sign in the control values, two in the curve: below, above and below zero.
    let witness = refuted.witness().unwrap();
    assert_eq!(
        witness.at.first(),
        Some(&("degree".to_owned(), "1".to_owned()))
    );
    assert!(
        witness
            .at
            .contains(&("control value 1".to_owned(), "1".to_owned()))
    );
    let signs: Vec<bool> = witness
        .left_decimal
        .split(", ")
        .map(|value| value.contains('-'))
        .collect();
    assert_eq!(signs, [true, false, true], "{witness:?}");
    let open = outcome("turned", "states = 'variation_diminishing(f)'");
    assert_eq!(open.verdict(), Verdict::Undecided, "{open:?}");
    let first = "degree 1: totally positive for all shape parameters, by certificates of sign for all 3 minors";
    assert!(words::steps(&open).contains(&first.to_owned()), "{open:?}");
}

#[test]
fn variation_diminution_is_proved_degree_by_degree_for_one_function_of_a_parameter() {
    let proved = outcome("some", "states = 'variation_diminishing(q, 2, 5)'");
    assert_eq!(
        (proved.verdict(), proved.evidence()),
        (Verdict::Holds, Some(Evidence::Inequality)),
        "{proved:?}"
    );
    assert!(proved.replay().unwrap().replayed);
    assert!(proved.net().unwrap().decided >= 8);
    // A line that the curve crosses twice and its polygon once; no degree that is not spoken of refutes.
    let refuted = outcome("hump", "states = 'variation_diminishing(hump, 1, 2)'");
    assert_eq!(refuted.verdict(), Verdict::False, "{refuted:?}");
    let high = outcome("high", "states = 'variation_diminishing(q, 2, 11)'");
    assert_eq!(high.verdict(), Verdict::Undecided, "{high:?}");
    let other = outcome("other", "states = 'variation_diminishing(sharp, 1, 2)'");
    assert_eq!(other.verdict(), Verdict::Undecided, "{other:?}");
    assert!(
        words::steps(&other)[0].contains("is not 1 - x and x"),
        "{other:?}"
    );
}

/// Each of these rests on the sign of a fraction between -1 and 0.
#[test]
fn negative_fractions_below_one_in_size_prove_no_falsehood() {
    let claims = [
        ("2*y < 1", "y > 0", false),
        ("2*y^2 > -1", "y^2 < 0", false),
        ("2*y > -1", "y < 0", false),
        ("3*y > -2", "y > -1/2", false),
        ("2*y > -1", "y > -1", true),
        ("2*y < -1", "y < 0", true),
        ("2*y < -1", "y < -1/3", true),
    ];
    for (number, (assume, states, expected)) in claims.into_iter().enumerate() {
        let found = outcome(
            &format!("below-one-{number}"),
            &format!("assume = ['{assume}']\nstates = '{states}'"),
        );
        assert_eq!(
            found.verdict() == Verdict::Holds,
            expected,
            "{assume}: {states}"
        );
    }
}
