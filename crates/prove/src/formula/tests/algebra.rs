//! From algebra back to formulas: the same value, in a shape one would write by hand.

use super::evaluate::{evaluated, value};
use crate::formula::{expression, expression_of};
use proptest::prelude::*;
use torse_algebra::Fraction;
use torse_syntax::formula::{Expr, Operator, parse};
use torse_syntax::notation::text;

fn shown(formula: &str) -> String {
    text(&expression(&evaluated(formula)))
}

/// What is to be written as itself.
fn stands(formula: &str) {
    assert_eq!(shown(formula), formula);
}

#[test]
fn products_are_ordered_number_root_pi_names_functions_points() {
    assert_eq!(shown("mu*pi^2*2"), "2*pi^2*mu");
    assert_eq!(
        shown("R[k]*sin(pi/2*x)*x*sqrt(2)*pi/3"),
        "1/3*sqrt(2)*pi*x*sin(pi/2*x)*R[k]"
    );
    assert_eq!(shown("-mu/4"), "-1/4*mu");
    assert_eq!(shown("0*x"), "0");
    assert_eq!(shown("1 - 3/2"), "-1/2");
}

#[test]
fn parameters_are_written_one_minus_mu_and_degrees_k_minus_one() {
    assert_eq!(shown("mu + 1"), "1 + mu");
    assert_eq!(shown("-mu + 1"), "1 - mu");
    assert_eq!(shown("1 + k"), "k + 1");
    assert_eq!(shown("(k - 3)*(mu - 1)"), "-(k - 3)*(1 - mu)");
    assert_eq!(shown("-1/(mu - 1)"), "1/(1 - mu)");
}

#[test]
fn a_number_is_pulled_out_only_where_that_is_shorter() {
    stands("1/2*x + 3");
    stands("cos(x) - 1/2");
    assert_eq!(shown("4*mu + 4*nu"), "4*(mu + nu)");
}

#[test]
fn polynomials_are_factored_lightly() {
    // hermite-developable eq. (3.6): the determinant, printed in both forms.
    assert_eq!(
        shown("-2176*k^5 + 4336*k^4 - 2160*k^3"),
        "-16*k^3*(136*k - 135)*(k - 1)"
    );
    assert_eq!(shown("x*y + x + y + 1"), "(1 + x)*(1 + y)");
    assert_eq!(shown("x^2 + 2*x*y + y^2"), "(x + y)^2");
    assert_eq!(
        shown("k^2 - 5*k + 6 + pi*k*mu - 2*pi*mu"),
        "(k - 2)*(k - 3 + pi*mu)"
    );
    assert_eq!(shown("2*x/(4*y*(1 - z)^2)"), "x/(2*y*(1 - z)^2)");
}

#[test]
fn combinations_of_points_with_sum_zero_become_differences() {
    // gbt-developable eq. (3.11), second and third line, in the shape of the print.
    stands("1/2*(2*(k - 2) + pi*(1 + mu))*(Q[1] - Q[0])");
    stands(
        "1/4*(4*(k - 2)*(k - 3 + pi*(1 + mu))*(Q[0] - 2*Q[1] + Q[2]) \
         + 2*pi^2*mu*(Q[0] - Q[1]) + pi^2*(1 - nu)*(Q[2] - Q[1]))",
    );
    assert_eq!(shown("P[2] - 3*P[1] + 2*P[0]"), "2*P[0] - 3*P[1] + P[2]");
}

#[test]
fn affine_combinations_become_a_blend_or_a_point_and_a_vector() {
    stands("(1 - x)^2*P[0] + 2*x*(1 - x)*P[1] + x^2*P[2]");
    stands("Q[m] + c*(Q[m] - Q[m-1])");
    // gbt-surfaces eq. (5), third line.
    assert_eq!(
        shown(
            "Q[m] + 1/a1*(a2*(Q[m] - 2*Q[m-1] + Q[m-2]) \
             - pi^2*(1 - mu)*(Q[m-1] - Q[m-2]) + a3*(Q[m] - Q[m-1]))"
        ),
        "Q[m] + 1/a1*((a2 + pi^2*(1 - mu))*(Q[m-2] - Q[m-1]) + (a2 + a3)*(Q[m] - Q[m-1]))"
    );
}

#[test]
fn families_stay_apart_and_what_has_no_point_stays_behind() {
    assert_eq!(
        shown("(k - 2)*(P[0] - P[1]) + Q[1]*x - 7"),
        "(k - 2)*(P[0] - P[1]) + x*Q[1] - 7"
    );
    assert_eq!(
        shown("(nu*P[1] - mu*P[0])/(nu - 1)"),
        "1/(1 - nu)*(mu*P[0] - nu*P[1])"
    );
    assert_eq!(
        shown("k*(R[i]/(k - 2) - 2*Q[0])"),
        "k/(k - 2)*R[i] - 2*k*Q[0]"
    );
    assert_eq!(shown("a*P[0]*P[1] - b*P[0]"), "P[0]*(a*P[1] - b)");
    assert_eq!(
        shown("(1 + mu)*(P[0]*mu + P[1]*nu)/2/(1 - nu)"),
        "(1 + mu)/(2*(1 - nu))*(mu*P[0] + nu*P[1])"
    );
}

/// Polynomials and fractions, as formulas.
fn any_value() -> impl Strategy<Value = Expr> {
    use Operator::{Add, Divide, Multiply, Subtract};
    let atoms = [
        "k",
        "mu",
        "nu",
        "x",
        "pi",
        "sqrt(2)",
        "sin(pi/2*x)",
        "cos(pi/2*x)",
        "sin(y)",
        "Q[0]",
        "Q[1]",
        "Q[k-1]",
        "R[i,1]",
        "R[2*i+1,1]",
        "1",
        "2",
        "6",
        "1/3",
    ];
    let divisors = ["mu", "1 - mu", "k - 2", "3", "(1 + nu)*pi"];
    let parsed =
        |texts: &[&str]| -> Vec<Expr> { texts.iter().map(|text| parse(text).unwrap()).collect() };
    let divisor = prop::sample::select(parsed(&divisors));
    prop::sample::select(parsed(&atoms)).prop_recursive(4, 20, 2, move |inner| {
        let operator = prop::sample::select(vec![Add, Subtract, Multiply, Multiply]);
        prop_oneof![
            6 => (inner.clone(), operator, inner.clone()).prop_map(|(a, o, b)| a.with(o, b)),
            1 => (inner, divisor.clone()).prop_map(|(a, b)| a.with(Divide, b)),
        ]
    })
}

/// Vectors and affine combinations of control points over a common divisor.
fn any_combination() -> impl Strategy<Value = Expr> {
    use Operator::{Add, Divide, Multiply};
    let parsed = |text: &str| parse(text).unwrap();
    let differences = [
        "Q[0] - Q[1]",
        "Q[1] - Q[2]",
        "Q[2] - Q[0]",
        "R[k] - R[k-1]",
        "Q[3] - Q[1]",
    ];
    let coefficients = [
        "mu",
        "1 - nu",
        "k - 2",
        "pi*(1 + mu)",
        "-1/2",
        "3",
        "pi^2*nu/4",
    ];
    let difference = prop::sample::select(differences.map(parsed).to_vec());
    let coefficient = prop::sample::select(coefficients.map(parsed).to_vec());
    let term = (coefficient.clone(), coefficient.clone(), difference)
        .prop_map(|(a, b, d)| a.with(Add, b).with(Multiply, d));
    let divisor = prop::sample::select(["1", "mu - 1", "4*c", "k + pi"].map(parsed).to_vec());
    let origin = prop::sample::select(["0", "Q[1]", "2*Q[0]", "mu*Q[2]"].map(parsed).to_vec());
    (prop::collection::vec(term, 1..4), divisor, origin).prop_map(|(terms, divisor, origin)| {
        let vector = terms.into_iter().reduce(|a, b| a.with(Add, b)).unwrap();
        vector.with(Divide, divisor).with(Add, origin)
    })
}

proptest! {
    #[test]
    fn the_formula_of_a_combination_of_points_has_its_value(formula in any_combination()) {
        let exact = value(&formula);
        let made = expression(&exact);
        prop_assert_eq!(value(&made), exact, "{}", text(&made));
        prop_assert_eq!(parse(&text(&made)).map(|e| e.placeless()), Ok(made.placeless()));
    }

    #[test]
    fn the_formula_of_a_fraction_has_its_value(formula in any_value()) {
        let exact = value(&formula);
        prop_assert_eq!(value(&expression(&exact)), exact);
    }

    #[test]
    fn the_formula_of_a_polynomial_has_its_value(formula in any_value()) {
        let exact = value(&formula);
        let numerator = exact.numerator();
        prop_assert_eq!(value(&expression_of(numerator)), Fraction::from(numerator.clone()));
    }

    #[test]
    fn the_formula_of_a_fraction_is_the_tree_of_its_own_text(formula in any_value()) {
        let made = expression(&value(&formula));
        let read = parse(&text(&made)).map(|e| e.placeless());
        prop_assert_eq!(read, Ok(made.placeless()));
    }
}
