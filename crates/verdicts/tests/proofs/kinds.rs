//! One proof of each kind: written, in words, and replayed.

use crate::found;
use torse_checker::CheckError;
use torse_verdicts::certificate::DecisionCertificate;
use torse_verdicts::words;

/// The steps and the JSON of what is found of a claim.
fn shown(lines: &str) -> String {
    let found = found(lines);
    let steps = match &found.certificate {
        DecisionCertificate::Proof { of, .. } => words::certificate::proof(of),
        DecisionCertificate::Refutation(of) => words::certificate::refutation(of),
    };
    let replayed = match found.checked() {
        Ok(()) => "replayed".to_owned(),
        Err(CheckError::Unsupported(why)) => format!("not replayed: {why}"),
        Err(wrong @ CheckError::Wrong(_)) => panic!("{lines}: {wrong}"),
    };
    let json = serde_json::to_string_pretty(&found.certificate).unwrap();
    format!(
        "{lines}\n\n- {}\n\n{replayed}\n\n{json}\n",
        steps.join("\n- ")
    )
}

macro_rules! kinds {
    ($($name:ident: $lines:literal;)*) => {$(
        #[test]
        fn $name() {
            insta::assert_snapshot!(stringify!($name), shown($lines));
        }
    )*};
}

kinds! {
    an_identity: "states = '(a - b)*(a + b) == a^2 - b^2'";
    an_identity_under_equations: "given = ['a*r + b*s == 1', 'b*r - a*s == 0']\nsolve_for = ['r', 's']\nstates = '(a^2 + b^2)*r^2 == a*r'";
    a_combination_of_given_equations: "given = ['a*r + b*s == 1', 'b*r + a*s == 0']\nsolve_for = ['r', 's']\nstates = '(a + b)*(r + s) == 1'";
    a_series: "states = 'sum(j, 0, n, B[j,n](x)) == 1'";
    a_sign_by_boxes: "states = 'x^3 - x + z/8 + 1/2 > 0'";
    a_sign_by_squares: "states = 'a^2 + a*b + b^2 >= 0'";
    a_sign_by_a_hypothesis: "assume = ['x + z >= 1']\nstates = '2*x + 2*z + x*z > 1'";
    a_sign_by_an_angle: "states = 'sin(pi/2*x) + cos(pi/2*x) >= 1'";
    a_sign_by_rays: "states = 'u*v*(1 + a + a^2) + a^2 - a + 1 > 0'";
    a_sign_by_factors: "states = '(x + 1)*(a^2 + a + 1) > 0'";
    a_sign_by_a_multiple_of_a_hypothesis: "assume = ['a + b >= 1']\nstates = '2*a + 2*b > 1'";
    a_sign_along_an_equation: "assume = ['a^2 + b^2 == 1']\nstates = 'a^2 <= 1'";
    no_choice_but_zero_by_two_signs: "assume = ['u + v == 0']\nstates = 'u == 0'";
    no_choice_but_zero_by_a_square: "assume = ['a^2 + b^2 == 0']\nstates = 'a == 0'";
    no_choice_but_zero_beside_a_factor: "assume = ['a^2 == 4', 'a != 2']\nstates = 'a == -2'";
    printed_decimals: "states = 'agrees([pi, sqrt(2)], [3.142, 1.4142])'";
    an_existing_point: "states = 'fails(x^2 == x)'";
    all_instances: "states = 'i*(i - 1)*(i - 2) == 0'";
    an_alternative: "states = 'x >= 1/2 or x <= 1/2'";
    a_conclusion: "states = 'a == 2*b implies a^2 == 4*b^2'";
    a_conjunction: "states = 'x >= 0 and x^2 <= x'";
    a_nonnegative_basis: "states = 'nonnegative(B)'";
    a_counterexample: "assume = ['r == 2*a']\nstates = 'r*x <= a'";
    wrong_decimals: "states = 'agrees(pi, 3.15)'";
    a_denial_that_is_false: "states = 'fails(x*(1 - x) >= 0)'";
}

#[test]
fn the_constraints_that_a_proof_uses_can_be_read_from_it() {
    let used = |lines: &str| -> Vec<String> {
        match found(lines).certificate {
            DecisionCertificate::Proof { of, .. } => {
                of.hypotheses().iter().map(ToString::to_string).collect()
            }
            DecisionCertificate::Refutation(of) => panic!("{of:?}"),
        }
    };
    let lines = "assume = ['a*b >= 3', 'x + z >= 1']\nstates = '2*x + 2*z + x*z > 1'";
    assert_eq!(used(lines), ["x + z - 1 >= 0"]);
    assert_eq!(used("assume = ['a*b >= 3']\nstates = 'x >= 0'"), [""; 0]);
}
