//! Laws that hold for all formulas.

use crate::support::{at as at_point, claim, holds, says};
use proptest::prelude::*;
use torse_semantics::Judgement;

/// Formulas in `a` and `b` that are defined everywhere.
fn formula() -> impl Strategy<Value = String> {
    let leaf = prop_oneof![
        Just("a".to_owned()),
        Just("b".to_owned()),
        (-5..6_i32).prop_map(|n| format!("({n})")),
    ];
    leaf.prop_recursive(4, 24, 2, |inner| {
        prop_oneof![
            (inner.clone(), inner.clone()).prop_map(|(x, y)| format!("({x} + {y})")),
            (inner.clone(), inner.clone()).prop_map(|(x, y)| format!("({x} - {y})")),
            (inner.clone(), inner.clone()).prop_map(|(x, y)| format!("({x}*{y})")),
            (inner.clone(), inner.clone()).prop_map(|(x, y)| format!("({x}/(1 + {y}^2))")),
            inner.clone().prop_map(|x| format!("sin({x})")),
            inner.clone().prop_map(|x| format!("cos(pi/2*{x})")),
            inner.prop_map(|x| format!("sqrt(1 + {x}^2)")),
        ]
    })
}

/// Formulas that are often linear in `a` and `b`, with `y` beside them and a function F that is linear.
fn form() -> impl Strategy<Value = String> {
    let leaf = prop_oneof![
        3 => Just("A".to_owned()),
        3 => Just("B".to_owned()),
        2 => Just("y".to_owned()),
        2 => (-3..4_i32).prop_map(|n| format!("({n})")),
    ];
    leaf.prop_recursive(4, 12, 2, |inner| {
        let of_y = inner.clone().prop_map(|y| y.replace(['A', 'B'], "y"));
        prop_oneof![
            3 => (inner.clone(), inner.clone()).prop_map(|(x, y)| format!("({x} + {y})")),
            1 => (inner.clone(), inner.clone()).prop_map(|(x, y)| format!("({x} - {y})")),
            1 => (inner.clone(), inner.clone()).prop_map(|(x, y)| format!("({x}*{y})")),
            3 => (inner.clone(), of_y.clone()).prop_map(|(x, y)| format!("({y}*{x})")),
            1 => (inner.clone(), of_y.clone()).prop_map(|(x, y)| format!("({x}/(1 + {y}^2))")),
            1 => (inner.clone(), inner.clone()).prop_map(|(x, y)| format!("({x}/(4 + {y}))")),
            1 => inner.clone().prop_map(|x| format!("({x}^2)")),
            1 => inner.clone().prop_map(|x| format!("D(y^3*{x}, y)")),
            1 => (inner.clone(), of_y).prop_map(|(x, y)| format!("at({x}, y, {y})")),
            1 => (inner.clone(), inner.clone()).prop_map(|(x, y)| format!("at({x}, y, {y})")),
            1 => (inner.clone(), inner.clone()).prop_map(|(x, y)| format!("dot([{x}, 2], [y, {y}])")),
            1 => (inner.clone(), inner.clone()).prop_map(|(x, y)| format!("[{x}, {y}][2]")),
            1 => inner.clone().prop_map(|x| format!("sum(j, 1, 3, y^j*{x})")),
            2 => inner.prop_map(|x| format!("F({x})")),
        ]
    })
    .prop_map(|form| form.replace('A', "a").replace('B', "b"))
}

fn point() -> impl Strategy<Value = (String, String)> {
    let number = || (-9..10_i32, 1..6_i32).prop_map(|(n, d)| format!("{n}/{d}"));
    (number(), number())
}

fn judged(states: &str, (a, b): &(String, String)) -> Judgement {
    says(states, &[("a", a), ("b", b)])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn a_derivative_lies_near_the_quotient_of_differences(f in formula(), at in point()) {
        // The central quotient of step h is off by h^2/6 times a third derivative.
        let shifted = |by: &str| format!("at({f}, a, a + {by})");
        let (plus, minus) = (shifted("1/10^12"), shifted("-1/10^12"));
        let near = format!(
            "(D({f}, a) - ({plus} - {minus})*10^12/2)^2 < 1/10^16 and 0*a == 0*b"
        );
        prop_assert_eq!(judged(&near, &at), Judgement::True);
        let far = format!(
            "(D({f}, a) + 1/1000 - ({plus} - {minus})*10^12/2)^2 < 1/10^16 and 0*a == 0*b"
        );
        prop_assert_eq!(judged(&far, &at), Judgement::False);
    }

    #[test]
    fn derivatives_of_products_follow_leibniz(f in formula(), g in formula(), at in point()) {
        let law = format!(
            "D({f}*{g}, a, 2) == D({f}, a, 2)*{g} + 2*D({f}, a)*D({g}, a) + {f}*D({g}, a, 2)"
        );
        prop_assert_eq!(judged(&law, &at), Judgement::True);
    }

    #[test]
    fn the_order_of_derivatives_does_not_matter(f in formula(), at in point()) {
        let law = format!("D(D({f}, a), b) == D(D({f}, b), a) and D(D({f}, a), a) == D({f}, a, 2)");
        prop_assert_eq!(judged(&law, &at), Judgement::True);
    }

    #[test]
    fn a_sum_is_its_terms(f in formula(), at in point()) {
        let law = format!("sum(j, 1, 3, j*{f}) == {f} + 2*{f} + 3*{f}");
        prop_assert_eq!(judged(&law, &at), Judgement::True);
    }

    #[test]
    fn at_is_substitution(f in formula(), g in formula(), at in point()) {
        let substituted = f.replace('a', &format!("({g})"));
        let law = format!("at({f}, a, {g}) == {substituted}");
        prop_assert_eq!(judged(&law, &at), Judgement::True);
        let off = format!("at({f}, a, {g}) == {substituted} + 1/10^9");
        prop_assert_eq!(judged(&off, &at), Judgement::False);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn coefficients_are_derivatives(f in form(), g in form(), at in point()) {
        let law = format!(
            "coefficients([{f}, {g}], [a, b]) == [[D({f}, a), D({f}, b)], [D({g}, a), D({g}, b)]]"
        );
        let states = format!("{law} and 0*a*b*y == 0");
        let (claim, y) = (claim("let = { 'F(t)' = 'y*t + 2' }", &states), "7/5");
        let point = [("a", at.0.as_str()), ("b", at.1.as_str()), ("y", y)];
        let judgement = at_point(&claim, &point);
        let allowed = matches!(judgement, Judgement::True | Judgement::Undefined(_));
        prop_assert!(allowed, "{law} is {judgement}");
    }
}

#[test]
fn solutions_of_systems_satisfy_them() {
    holds(
        "[[a, b, 1], [1, a, 2], [0, 1, sin(a)]]*solve([[a, b, 1], [1, a, 2], [0, 1, sin(a)]], [1, b, 3]) == [1, b, 3]",
        &[("a", "3/2"), ("b", "-2")],
    );
}
