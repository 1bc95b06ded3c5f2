//! Where terms have values: roots that are positive, divisors that do not vanish, statements that say nothing.

use super::adversary::found;
use torse_syntax::taxonomy::Verdict::{Conditional, False, Holds, Misprint, Undecided};
use torse_verdicts::Finding;

#[test]
fn a_root_is_positive_where_its_radicand_is_whatever_its_factors_are() {
    let numbers = "[symbols]\nx = {}\ny = {}\nz = {}\n";
    for (assumed, states) in [
        ("y^2 > 1", "abs(y) > 0"),
        ("x^2 < y^2", "abs(y) != 0"),
        ("x^2 < y^2", "x < abs(y)"),
        ("x^2 < y^2", "x < 1 + abs(y)"),
        ("x^2 < (y + z)^2", "x < abs(y + z)"),
        ("y^2 > x^2 + z^2", "abs(y) > 0"),
    ] {
        let lines = format!("assume = ['{assumed}']\nstates = '{states}'");
        found(numbers, &lines, &[Holds]);
    }
    let implied = "states = 'x^2 < y^2 implies -abs(y) < x < abs(y)'";
    found(numbers, implied, &[Holds]);
    // A root that divides a term is not zero, whatever its radicand.
    let divided = "states = 'x/abs(y) <= 1 implies x <= abs(y)'";
    found(numbers, divided, &[Holds, Undecided]);
    let least = "assume = ['y^2 >= 1']\nstates = 'abs(y) > 1'";
    found(numbers, least, &[False, Misprint]);
}

#[test]
fn a_statement_without_a_value_at_any_integer_of_its_range_is_open() {
    let integers = "[symbols]\nn = { integer = '1..6' }\n";
    for states in [
        "1/(n - n) == 5",
        "sum(i, 0, n, 1/i) < n",
        "product(i, -1, n, (i + 2)/(i + 1)) < n",
    ] {
        found(integers, &format!("states = '{states}'"), &[Undecided]);
    }
    let somewhere = "states = '(n - 1)/(n - 1) == 1'";
    found(integers, somewhere, &[Holds, Conditional]);
}

#[test]
fn what_a_derivative_divides_by_does_not_vanish() {
    let numbers = "[symbols]\nx = {}\ny = {}\nz = {}\nn = { integer = '-1..2' }\n";
    for rate in ["D(1/z, z)", "D(z^n, z)", "D(1/(z - 1), z, 2)"] {
        let states = format!("(z + x)*(x - y + {rate}) == (z + x)*{rate} implies x == y");
        let outcome = found(numbers, &format!("states = '{states}'"), &[Conditional]);
        let replay = outcome.replay().unwrap();
        assert!(replay.is_whole(), "{outcome:#?}");
    }
    // Where the place is another one, so is the divisor.
    let place = "at(D(1/z, z), z, x)*(y - 1) == 0 implies y == 1";
    found(numbers, &format!("states = '{place}'"), &[Holds]);
    let other = "z*at(D(1/z, z), z, x)*(y - 1) == 0 implies y == 1";
    found(
        numbers,
        &format!("states = '{other}'"),
        &[Conditional, False, Misprint],
    );
}

#[test]
fn parts_of_a_hypothesis_speak_of_no_symbol_that_an_earlier_part_eliminated() {
    let numbers = "[symbols]\nx = {}\ny = {}\n";
    for (assumed, states) in [
        ("x/y == 1 and x >= 0", "x > 0"),
        ("x/y == 1 and x >= 0", "1/x > 0"),
        ("x >= 0 and x/y == 1", "x > 0"),
        ("x == y + 1 and x > 3 and x < 5", "1 < y < 4"),
    ] {
        let lines = format!("assume = ['{assumed}']\nstates = '{states}'");
        found(numbers, &lines, &[Holds]);
    }
}

#[test]
fn a_binomial_that_is_zero_gives_no_value_to_a_power_beside_it() {
    let numbers = "[symbols]\nn = { integer = '>= 0' }\nm = { integer = '>= 1' }\nl = { integer = '0..3' }\nx = { in = '[0, 1]' }\ny = {}\n";
    for states in [
        "sum(i, 0, n + 1, binom(n, i)*y^(n - i)) == (1 + y)^n",
        "sum(i, 0, l + 1, binom(l, i)*y^(l - i)) == (1 + y)^l",
        "sum(i, 0, n + 1, binom(n, i)*x^i*(1 - x)^(n - i)) == 1",
        "sum(i, -1, n, binom(n, i)*x^i*(1 - x)^(n - i)) == 1",
        "sum(i, 0, m, binom(m - 1, i - 1)*x^(i - 1)*(1 - x)^(m - i)) == 1",
    ] {
        found(numbers, &format!("states = '{states}'"), &[Conditional]);
    }
    for states in [
        "sum(i, 0, n, binom(n, i)*y^(n - i)) == (1 + y)^n",
        "sum(i, 0, n + 1, binom(n, i)*x^i) == (1 + x)^n",
        "sum(i, 1, m, binom(m - 1, i - 1)*x^(i - 1)*(1 - x)^(m - i)) == 1",
    ] {
        found(numbers, &format!("states = '{states}'"), &[Holds]);
    }
    for states in [
        "at(sum(i, 0, n + 1, binom(n, i)*x^i*(1 - x)^(n - i)), x, 1) == 1",
        "sum(i, 0, n + 1, binom(n, i)*(y - y)^(n - i)) == 1",
        "x == 1 implies sum(i, 0, n + 1, binom(n, i)*x^i*(1 - x)^(n - i)) == 1",
    ] {
        found(
            numbers,
            &format!("states = '{states}'"),
            &[Undecided, Conditional],
        );
    }
}

#[test]
fn a_sum_that_hypotheses_keep_from_zero_divides() {
    let numbers = "[symbols]\na = {}\nb = {}\nc = {}\n";
    for (assumed, states) in [
        ("a*b > 0', 'c*(a + b) == 2*(a + b)", "c == 2"),
        ("a*b < 0', 'c*(b - a) == (b - a)^2", "c == b - a"),
        ("a*b >= 1', 'c*(a + b) == 2*(a + b)", "c == 2"),
    ] {
        let lines = format!("assume = ['{assumed}']\nstates = '{states}'");
        found(numbers, &lines, &[Holds]);
    }
    let zero = "assume = ['a*b >= 0', 'c*(a + b) == 2*(a + b)']\nstates = 'c == 2'";
    found(numbers, zero, &[False, Misprint, Conditional]);

    // A factor of a sum that is never zero is never zero, whatever is eliminated.
    let numbers = "[symbols]\nx = {}\ny = {}\na = {}\nb = { in = '[0, 1]' }\nw = { in = '[0, inf)' }\nm = { integer = '1..3' }\n";
    for (right, verdict) in [
        ("b + 3/2", Holds),
        ("-b - 3", Holds),
        ("b - 1/2", Conditional),
        ("b", Conditional),
        ("sin(b) + 1/2", Holds),
        ("sin(w) + 1/2", Conditional),
    ] {
        let lines = format!(
            "assume = ['(x - y)*a == {right}']\nstates = 'y^m + a == y^m + ({right})/(x - y)'"
        );
        found(numbers, &lines, &[verdict]);
    }
}

#[test]
fn no_counterexample_has_a_hypothesis_with_an_index_outside_of_its_range() {
    let members = "[symbols]\nm = { integer = '>= 0' }\nx = {}\nP = { family = 1, indices = ['0..m'] }\n\
                   b = { in = '[P[1], 3]' }\n";
    for lines in [
        "states = 'P[1] == 1 implies m >= 1'",
        "assume = ['P[1] <= 3']\nstates = 'm >= 1'",
        "given = ['x == P[1]']\nsolve_for = ['x']\nstates = 'm >= 1'",
        "states = 'b == b and m >= 1'",
    ] {
        let outcome = found(members, lines, &[Holds, Undecided]);
        let contradicted = matches!(outcome.finding, Finding::Contradicted(_));
        assert!(!contradicted, "{lines}: {outcome:#?}");
    }
    // With an index that is in its range everywhere there is one.
    let lines = "assume = ['P[0] <= 3']\nstates = 'm >= 1'";
    found(members, lines, &[False]);
}
