//! Sines, cosines and tangents as papers print them: in radians and in quarter turns, of parts and multiples of a
//! variable, on intervals with ends in multiples of pi. A statement in t on [0, pi/2] and the same one in pi/2*x on
//! [0, 1] have one verdict.

use crate::common;

use torse_syntax::taxonomy::Verdict::{self, Conditional, False, Holds, Misprint, Undecided};
use torse_verdicts::outcome::Outcome;

fn outcome(lines: &str) -> Outcome {
    let paper = common::loaded("angles", "", &[lines]).unwrap_or_else(|e| panic!("{lines}: {e}"));
    torse_verdicts::engine::decide_claim("angles", &paper.claims[0])
        .unwrap_or_else(|e| panic!("{lines}: {e}"))
}

#[track_caller]
fn verdict(lines: &str, wanted: Verdict) {
    let found = outcome(lines);
    assert_eq!(found.contradiction(), None, "{lines}");
    assert_eq!(found.verdict(), wanted, "{lines}: {found:#?}");
}

/// The statement with the angle `A`, in both ways of writing it, on both intervals.
#[track_caller]
fn both(states: &str, quarters: [&str; 2], brackets: [&str; 2], wanted: Verdict) {
    let [open, close] = brackets;
    let [low, high] = quarters;
    for (name, angle, factor) in [("t", "t", "pi/2*"), ("x", "pi/2*x", "")] {
        let ends = format!("{open}{factor}{low}, {factor}{high}{close}");
        let symbols = format!("symbols = {{ {name} = {{ in = '{ends}' }} }}");
        verdict(
            &format!("{symbols}\nstates = '{}'", states.replace('A', angle)),
            wanted,
        );
    }
}

#[test]
fn sine_and_cosine_have_signs_on_every_interval_of_known_ends() {
    let closed = ["[", "]"];
    both("sin(A) >= 0", ["0", "1"], closed, Holds);
    both("sin(A) + cos(A) >= 1", ["0", "1"], closed, Holds);
    both("sin(A) >= 0", ["0", "2"], closed, Holds);
    both("sin(A) > 0", ["0", "2"], ["(", ")"], Holds);
    both("sin(A) > 0", ["0", "2"], ["(", "]"], False);
    both("cos(A) >= 0", ["-1", "1"], closed, Holds);
    both("cos(A) > 0", ["-1", "1"], ["(", ")"], Holds);
    both("cos(A) <= 0", ["1", "2"], closed, Holds);
    both("cos(A) <= 0", ["1", "3"], closed, Holds);
    both("sin(A) <= 0", ["-2", "0"], closed, Holds);
    both("cos(A) >= sin(A)", ["0", "1/2"], closed, Holds);
    both("cos(A) >= sin(A)", ["0", "2/3"], closed, False);
    both("cos(A) >= 1/2", ["-2/3", "2/3"], closed, Holds);
    both("sin(A) >= sin(pi/6)", ["1/3", "5/3"], closed, Holds);
    both("sin(A - pi/4) >= 0", ["1/2", "5/2"], closed, Holds);
    both("2 + sin(A) + cos(A) > 0", ["0", "4"], closed, Holds);
    both("1 + sin(A) + cos(A) > 0", ["0", "4"], closed, False);
    both("3 + sin(A) + 2*cos(A) > 0", ["-9", "7"], closed, Holds);
}

#[test]
fn an_interval_that_is_a_little_too_long_is_refuted_or_open() {
    for (end, wanted) in [("2", Holds), ("13/6", False), ("21/10", Undecided)] {
        both("sin(A) >= 0", ["0", end], ["[", "]"], wanted);
    }
}

#[test]
fn angles_of_a_variable_without_bounds_run_through_whole_turns() {
    verdict(
        "symbols = { t = {} }\nstates = '3 + sin(t) + 2*cos(t) > 0'",
        Holds,
    );
    verdict(
        "symbols = { t = {} }\nstates = 'sin(t)*cos(t) <= 2/3'",
        Holds,
    );
    verdict(
        "symbols = { t = {} }\nstates = 'sin(t)*cos(t) <= 1/3'",
        False,
    );
    verdict(
        "symbols = { t = { in = '[0, inf)' } }\nstates = 't*(1 + cos(t)) >= 0'",
        Holds,
    );
}

#[test]
fn ends_that_are_no_multiples_of_pi_are_moved_outward() {
    verdict(
        "symbols = { t = { in = '[0, 3/2]' } }\nstates = 'cos(t) > 0'",
        Holds,
    );
    verdict(
        "symbols = { t = { in = '[-1, 1]' } }\nstates = 'cos(t) >= 1/2'",
        Holds,
    );
    verdict(
        "symbols = { t = { in = '[0, 8/5]' } }\nstates = 'cos(t) >= 0'",
        Undecided,
    );
}

#[test]
fn parts_of_an_angle_are_written_in_the_finest_of_them() {
    let free = "symbols = { y = {}, z = {} }\n";
    for states in [
        "sin(y/2)^2 == (1 - cos(y))/2",
        "cos(y) == 2*cos(y/2)^2 - 1",
        "sin(y) == 3*sin(y/3) - 4*sin(y/3)^3",
        "sin(y/2 + z/3)*cos(z/3) - cos(y/2 + z/3)*sin(z/3) == sin(y/2)",
        "D(sin(y/2), y) == cos(y/2)/2",
        "cos(pi/4*y)^2 == (1 + cos(pi/2*y))/2",
        "at(sin(z), z, y/2)*cos(y/2)*2 == sin(y)",
        "D(cos(z/4), z, 2) == -cos(z/4)/16",
        "sin(2*y/3)*sin(y/4) == (cos(5*y/12) - cos(11*y/12))/2",
        "sin(pi/12) == (sqrt(6) - sqrt(2))/4",
    ] {
        verdict(&format!("{free}states = '{states}'"), Holds);
    }
    verdict(
        &format!("{free}kind = 'identity'\nstates = '1 - cos(y) == sin(y/2)^2'"),
        Misprint,
    );
    verdict(&format!("{free}states = 'sin(y/2) == sin(y)/2'"), False);
    // The divisor of the alternative that is not needed is zero at pi.
    verdict(
        &format!(
            "{free}states = 'D(sin(y/2), y, 2) == -sin(y)/(8*cos(y/2)) or D(sin(y/2), y, 2) == -sin(y/2)/4'"
        ),
        Conditional,
    );
}

#[test]
fn a_divisor_that_is_the_zero_function_is_no_condition() {
    let lines = "symbols = { y = {} }\nstates = 'y/(1 - cos(y) - 2*sin(y/2)^2) == y/(1 - cos(y) - 2*sin(y/2)^2)'";
    let found = outcome(lines);
    assert!(
        !matches!(found.verdict(), Holds | Conditional),
        "{found:#?}"
    );
}

#[test]
fn tangents_are_quotients_whose_poles_are_conditions() {
    both("1 + tan(A)^2 == 1/cos(A)^2", ["-1", "1"], ["(", ")"], Holds);
    both(
        "1 + tan(A)^2 == 1/cos(A)^2",
        ["-1", "1"],
        ["[", "]"],
        Conditional,
    );
    both(
        "tan(A/2) == sin(A)/(1 + cos(A))",
        ["-2", "2"],
        ["(", ")"],
        Holds,
    );
    both("tan(A) >= 0", ["0", "1"], ["[", ")"], Holds);
    both("tan(A/2) <= 1", ["0", "1"], ["[", "]"], Holds);
    both("tan(pi/3) == sqrt(3)", ["0", "1"], ["[", "]"], Holds);
}

#[test]
fn divisors_with_sines_and_cosines_are_discharged_by_the_interval() {
    both(
        "sin(A)^2/(1 - cos(A)) == 1 + cos(A)",
        ["0", "2"],
        ["(", ")"],
        Holds,
    );
    both(
        "sin(A)^2/(1 - cos(A)) == 1 + cos(A)",
        ["0", "4"],
        ["(", ")"],
        Holds,
    );
    both(
        "sin(A)^2/(1 + cos(A)) == 1 - cos(A)",
        ["-2", "2"],
        ["(", ")"],
        Holds,
    );
    both(
        "sin(A)^2/(1 - cos(A)) == 1 + cos(A)",
        ["0", "2"],
        ["[", ")"],
        Conditional,
    );
}

#[test]
fn a_shape_parameter_beside_an_angle_in_radians_is_bounded_as_printed() {
    let basis = "symbols = { t = { in = '[0, pi/2]' }, mu = { in = '[-2, 1]' } }\n";
    verdict(
        &format!("{basis}states = '(1 - sin(t))^2*(1 - mu*sin(t)) >= 0'"),
        Holds,
    );
    let wide = basis.replace("1]' }", "2]' }");
    verdict(
        &format!("{wide}states = '(1 - sin(t))^2*(1 - mu*sin(t)) >= 0'"),
        False,
    );
}

#[test]
fn assumed_bounds_may_contain_pi_and_square_roots() {
    verdict(
        "symbols = { t = {} }\nassume = ['0 <= t', 't <= pi/2']\nstates = 'sin(t) >= 0'",
        Holds,
    );
    verdict(
        "symbols = { a = {} }\nassume = ['a <= sqrt(2)']\nstates = 'sqrt(2)*a <= 2'",
        Holds,
    );
    verdict(
        "symbols = { a = { in = '[0, inf)' } }\nassume = ['a <= sqrt(2)']\nstates = 'a^2 <= 2'",
        Holds,
    );
    verdict(
        "symbols = { a = {} }\nassume = ['a <= sqrt(2)']\nstates = 'a^2 <= 2'",
        False,
    );
}
