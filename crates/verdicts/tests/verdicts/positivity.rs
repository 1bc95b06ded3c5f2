//! Signs without a box: sums of squares, ordered knots, the simplex, and divisors that they discharge.

use crate::common;

use torse_syntax::taxonomy::Verdict::{self, Conditional, False, Holds};

#[track_caller]
fn verdict(lines: &str, wanted: Verdict) {
    let paper = common::loaded("positive", "", &[lines]).unwrap_or_else(|e| panic!("{lines}: {e}"));
    let found = torse_verdicts::engine::decide_claim("positive", &paper.claims[0]).unwrap();
    assert_eq!(found.contradiction(), None, "{lines}");
    assert_eq!(found.verdict(), wanted, "{lines}: {found:#?}");
}

/// A statement about any numbers y, z and any vectors p, q of space.
#[track_caller]
fn anywhere(states: &str, wanted: Verdict) {
    let symbols = "symbols = { y = {}, z = {}, p = { vector = 3 }, q = { vector = 3 } }";
    verdict(&format!("{symbols}\nstates = '{states}'"), wanted);
}

#[test]
fn definite_polynomials_are_sums_of_squares() {
    anywhere("y^2 + z^2 >= 0", Holds);
    anywhere("y^2 + y*z + z^2 >= 0", Holds);
    anywhere("y^2 + 2*y*z + z^2 >= 0", Holds);
    anywhere("y^2 - 2*y + 2 > 0", Holds);
    anywhere("y^4 - y^3 + y^2 - y + 1 > 0", Holds);
    anywhere("y^2 + y*z + z^2 + y + z + 1/3 >= 0", Holds);
    anywhere("-(y - 1)^2 - z^2 < 1/1000", Holds);
    anywhere("dot(p, q)^2 <= dot(p, p)*dot(q, q)", Holds);
    anywhere("2*dot(p, q) <= dot(p, p) + dot(q, q)", Holds);
}

#[test]
fn indefinite_polynomials_are_not() {
    anywhere("y^2 + 3*y*z + z^2 >= 0", False);
    anywhere("y^2 - 2*y + 1 > 0", False);
    anywhere("y^2 + y*z >= 0", False);
    anywhere("y^2 + y*z + z^2 > 0", False);
    anywhere("3*dot(p, q)^2 <= 2*dot(p, p)*dot(q, q)", False);
    // Negative on a sliver: (y - 1)(y - 1 - 1/1000).
    anywhere("(y - 1)*(y - 1 - 1/1000) >= 0", False);
}

#[test]
fn divisors_that_are_sums_of_squares_and_a_positive_number_are_no_conditions() {
    anywhere("(y^2 + 2*y + 2)/(y^2 + 2*y + 2) == 1", Holds);
    anywhere("(y^2 + y*z + z^2 + 1)/(y^2 + y*z + z^2 + 1) == 1", Holds);
    anywhere("(y^2 + y*z + z^2)/(y^2 + y*z + z^2) == 1", Conditional);
}

#[test]
fn products_of_distances_of_ordered_knots_have_a_sign() {
    let knots =
        "symbols = { a = {}, b = {}, c = {}, y = {} }\nassume = ['a < b', 'b <= y', 'y <= c']\n";
    verdict(&format!("{knots}states = '(c - y)*(y - a) >= 0'"), Holds);
    verdict(&format!("{knots}states = '(y - c)*(y - a) <= 0'"), Holds);
    verdict(
        &format!("{knots}states = '(c - y)^2*(y - a)^3 >= 0'"),
        Holds,
    );
    verdict(&format!("{knots}states = '(y - a)*(c - a) > 0'"), Holds);
    verdict(&format!("{knots}states = '(c - y)*(y - a) > 0'"), False);
    verdict(&format!("{knots}states = '(c - y)*(a - y) >= 0'"), False);
}

#[test]
fn a_term_of_positive_symbols_makes_a_sum_positive_wherever_the_others_vanish() {
    let signs = |free: &str, zero: &str, states: &str, wanted: Verdict| {
        let positive = "a = { in = '(0, inf)' }, b = { in = '(0, inf)' }, t = { in = '[0, 1]' }";
        verdict(
            &format!(
                "symbols = {{ {positive}, y = {{}}, c = {free}, d = {zero} }}\nstates = '{states}'"
            ),
            wanted,
        );
    };
    let (any, above) = ("{}", "{ in = '[0, inf)' }");
    signs(any, above, "a*b + b*y^2 > 0", Holds);
    signs(any, above, "a*d + b*y^2 > 0", False);
    signs(any, above, "a*(1 - t) + b*t + d*t*(1 - t) > 0", Holds);
    signs(any, above, "a*(1 - t) + d*t > 0", False);
    // The denominator of a rational curve of degree two.
    signs(any, above, "a*(1 - t)^2 + 2*d*t*(1 - t) + b*t^2 > 0", Holds);
    signs(any, above, "d*(1 - t)^2 + 2*b*t*(1 - t) + a*t^2 > 0", False);
}

#[test]
fn a_point_is_found_though_symbols_without_meaning_there_come_first() {
    let weights = "symbols = { t = { in = '[0, 1]' }, w0 = { in = '(0, inf)' }, w1 = {}, w2 = { in = '(0, inf)' } }";
    verdict(
        &format!("{weights}\nstates = 'w0*(1 - t)^2 + 2*w1*t*(1 - t) + w2*t^2 > 0'"),
        False,
    );
}

#[test]
fn combinations_on_the_simplex_are_decided_coefficient_by_coefficient() {
    let simplex = "symbols = { E = { in = '[0, inf)' }, F = { in = '[0, inf)' }, G = { in = '[0, inf)' }, \
                   u = { in = '[0, 1]' }, v = { in = '[0, 1]' } }\nassume = ['u + v <= 1']\n";
    verdict(
        &format!("{simplex}states = 'u*E + v*F + (1 - u - v)*G >= 0'"),
        Holds,
    );
    verdict(
        &format!("{simplex}states = 'u*E + v*F + (1 - u - v)*G > -1'"),
        Holds,
    );
    verdict(
        &format!("{simplex}states = '-u*E - v*F <= (1 - u - v)*G^2'"),
        Holds,
    );
    verdict(
        &format!("{simplex}states = 'u*E + v*F + (1 - u - 2*v)*G >= 0'"),
        False,
    );
}

#[test]
fn equations_with_squares_alone_have_irrational_counterexamples() {
    let w = "symbols = { w = {}, a = {} }\nassume = ['w^2 == 1/2']\n";
    verdict(&format!("{w}states = 'w^4 == 1/4'"), Holds);
    verdict(&format!("{w}states = 'a*w^3 == a*w/2'"), Holds);
    verdict(&format!("{w}states = 'w^4 == 1/2'"), False);
    verdict(&format!("{w}states = 'w >= 0'"), False);
    verdict(&format!("{w}states = 'w <= 3/4'"), Holds);
    verdict(&format!("{w}states = 'w <= 7/10'"), False);
    let h =
        "symbols = { a = {}, b = {}, h = { in = '(0, inf)' } }\nassume = ['h^2 == a^2 + b^2']\n";
    verdict(&format!("{h}states = '(a/h)^2 + (b/h)^2 == 1'"), Holds);
    verdict(&format!("{h}states = '(a/h)^2 - (b/h)^2 == 1'"), False);
}
