//! Points of domains.

use crate::support::{claim, is_empty, netted, stands};

#[test]
fn points_are_the_same_on_every_run_and_not_for_every_claim() {
    let claim = claim("assume = ['a + b == 1']", "a == 2");
    let (one, two) = (netted(&claim), netted(&claim));
    assert_eq!(one, two);
    let other = torse_semantics::judge_samples(&claim.reading(), &[], "t/d", 20, 4_000_000);
    assert_ne!(one.failing, other.failing);
}

#[test]
fn declared_sets_are_kept() {
    stands("", "0 <= x <= 1 and w >= 0 and 0 < phi < pi");
    stands("", "0 <= i <= m and m >= 1 and 0 <= o <= 1");
}

#[test]
fn equations_are_solved_whatever_symbol_they_bound() {
    stands("assume = ['a*b == 1', 'b == c + 1']", "a*(c + 1) == 1");
    stands("assume = ['x == y^2']", "0 <= y^2 <= 1");
    stands("assume = ['p == 2*q + [1, 2, 3]']", "p[2] == 2*q[2] + 2");
    stands("assume = ['m == 3']", "m^2 == 9");
    stands("assume = ['a^2 + b^2 == 1', 'a > 0']", "-1 <= b <= 1");
    stands("assume = ['P[m] == a*P[0]']", "P[m]*2 == 2*a*P[0]");
}

#[test]
fn given_equations_hold_for_the_unknowns() {
    stands(
        "given = ['a*r + b*s == e', 'c*r + d*s == f']\nsolve_for = ['r', 's']",
        "s*(a*d - b*c) == a*f - c*e",
    );
}

#[test]
fn inequalities_are_respected() {
    stands("assume = ['a > b', 'b > c']", "a > c");
    stands("assume = ['m >= 2']", "m != 1");
    stands(
        "assume = ['k == 0']\nsymbols = { k = { integer = \"0..5\" } }",
        "k == 0",
    );
}

#[test]
fn numbers_are_drawn_from_the_ranges_that_hypotheses_narrow() {
    let narrow = "assume = ['a > 1000', '-5 >= b', 'x < 1/100 and 1/200 <= x']";
    let tally = netted(&claim(narrow, "a + b*x > 0 and x >= 1/200"));
    assert!(tally.attempts < 30, "{tally:?}");
    stands(narrow, "a > 1000 and b <= -5 and 1/200 <= x < 1/100");
}

#[test]
fn a_symbol_that_equals_a_number_is_drawn_as_that_number() {
    let pinned = "assume = ['a == 7/3', '4 == m']\nsymbols = { k = { integer = \"0..m\" } }";
    let tally = netted(&claim(pinned, "3*a == 7 and m == 4 and k <= 4"));
    assert_eq!((tally.holding, tally.found), (20, 20), "{tally:?}");
    assert!(tally.attempts <= 20, "{tally:?}");
    let bounded = netted(&claim(
        "assume = ['m > 5/2', 'm < 9/2']",
        "(m - 3)*(m - 4) == 0",
    ));
    assert_eq!(bounded.attempts, bounded.holding, "{bounded:?}");
    let open = netted(&claim("assume = ['m > 3', 'm <= 4']", "m == 4"));
    assert_eq!(open.attempts, open.holding, "{open:?}");
    is_empty("assume = ['m == 3', 'm == 4']", "a == a");
    is_empty("assume = ['x == 3/2']", "x == x");
}

#[test]
fn what_is_pinned_altogether_is_the_only_point() {
    let only = netted(&claim("assume = ['a == 1/2', 'm == 3']", "a*m == 3/2"));
    assert_eq!((only.attempts, only.holding, only.single), (1, 1, true));
    let free = netted(&claim("assume = ['a == 1/2']", "a*m + b == m/2 + b"));
    assert_eq!((free.holding, free.single), (20, false));
}

#[test]
fn domains_without_points_are_seen_to_be_empty() {
    is_empty("assume = ['1 == 2']", "a == a");
    is_empty("assume = ['a > 0', 'a < 0']", "a == a");
    is_empty("symbols = { k = { in = \"[1, 0]\" } }", "k == k");
    is_empty("assume = ['m == 1/2']", "m == m");
    is_empty("assume = ['w == -1 - x']", "w == w");
}
