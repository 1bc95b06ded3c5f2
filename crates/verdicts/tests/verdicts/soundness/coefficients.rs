//! Coefficients of forms: members of a family that may be the same, symbols that hypotheses determine, and what hides a
//! symbol. Beside each false statement stands a true neighbour.

use super::adversary::found;
use torse_syntax::taxonomy::Verdict::{False, Holds, Misprint, Undecided};

/// A family without a range, whose members are told apart by their indices alone.
const FAMILY: &str =
    "[symbols]\nx = {}\ny = {}\nc = { integer = \"0..1000\" }\nV = { family = 1 }\n";

#[test]
fn members_that_may_be_the_same_are_not_told_apart() {
    let open = [Undecided, False, Misprint];
    for states in [
        "coefficients([V[c]], [V[500]]) == [[0]]",
        "coefficients([V[c] + V[7]], [V[7]]) == [[1]]",
        "coefficients([sum(i, 0, 3, V[i+c])], [V[700]]) == [[0]]",
        "det(coefficients([V[c], V[500]], [V[c], V[500]])) == 1",
        "fails(coefficients([V[c]], [V[500]]) == [[0]])",
    ] {
        let accepted = match states.starts_with("fails") {
            true => &[Holds, Undecided][..],
            false => &open[..],
        };
        found(FAMILY, &format!("states = \"{states}\""), accepted);
    }
    for states in [
        "coefficients([V[c] + 2*V[c+1]], [V[c], V[c+1]]) == [[1, 2]]",
        "coefficients([3*V[c]], [V[c]]) == [[3]]",
    ] {
        found(FAMILY, &format!("states = \"{states}\""), &[Holds]);
    }
}

#[test]
fn members_that_given_equations_determine_may_be_the_ones_of_the_form() {
    let given = "given = [\"V[500] == x\"]\nsolve_for = [\"V[500]\"]\n";
    found(
        FAMILY,
        &format!("{given}states = \"coefficients([V[c]], [x]) == [[0]]\""),
        &[Undecided, False, Misprint],
    );
    found(
        FAMILY,
        &format!("{given}states = \"coefficients([2*V[500]], [x]) == [[2]]\""),
        &[Holds],
    );
}

#[test]
fn equations_among_the_hypotheses_move_no_symbol() {
    // The premises about a and b are hard to reach, so that no drawn point helps.
    let premise = "x == 2*y and a > 1000000 and b > a^3";
    let symbols = "[symbols]\nx = {}\ny = {}\na = {}\nb = {}\n";
    for (entry, accepted) in [
        ("3", &[Undecided, False, Misprint][..]),
        ("1", &[Holds, Undecided][..]),
    ] {
        found(
            symbols,
            &format!("states = \"{premise} implies coefficients([x + y], [y]) == [[{entry}]]\""),
            accepted,
        );
    }
    let assumed = "assume = [\"x == 2*y\"]\n";
    let states = |entry| format!("{assumed}states = \"coefficients([x + y], [y]) == [[{entry}]]\"");
    found(symbols, &states("1"), &[Holds]);
    found(symbols, &states("3"), &[Undecided, False, Misprint]);
    // The values are put in afterwards.
    found(
        symbols,
        &format!("{assumed}states = \"coefficients([x*a], [a]) == [[2*y]]\""),
        &[Holds],
    );
}

#[test]
fn roots_and_functions_hide_their_argument() {
    let symbols = "[symbols]\nx = {}\ny = { in = \"(0, 9]\" }\nf = { function = 1 }\n";
    for form in ["abs(y)", "sqrt(y)*x + y", "f(y)"] {
        found(
            symbols,
            &format!("states = \"coefficients([{form}], [y]) == [[0]]\""),
            &[Undecided, False, Misprint],
        );
    }
}
