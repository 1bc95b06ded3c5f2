//! Corrections of the papers' refuted claims, one claim at a time.

use std::path::Path;
use std::sync::LazyLock;
use torse_syntax::derivation::{Claim, Paper, load};
use torse_syntax::taxonomy::Verdict;
use torse_verdicts::engine::decide_claim;
use torse_verdicts::outcome::Outcome;
use torse_verdicts::words;

/// The papers, and one with slips on purpose.
static PAPERS: LazyLock<Vec<Paper>> = LazyLock::new(|| {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut papers = load(&here.join("../../derivations")).unwrap();
    papers.extend(load(&here.join("tests/repairs")).unwrap());
    papers
});

fn claim(id: &str) -> &'static Claim {
    let claims = PAPERS.iter().flat_map(|p| &p.claims);
    claims
        .into_iter()
        .find(|c| c.entry.id.get_ref() == id)
        .unwrap()
}

fn decided(id: &str) -> Outcome {
    decide_claim(id.split_once('/').unwrap().0, claim(id)).unwrap()
}

/// The changes of the data that explain a value, as text.
fn data_changes(id: &str) -> Vec<String> {
    let outcome = decided(id);
    let data = outcome.data().unwrap();
    assert!(data.unique, "{id}");
    let changes = data.changes.iter();
    changes
        .map(|c| format!("{}: {} -> {}", c.name, c.old.text, c.new.text))
        .collect()
}

#[test]
fn the_tangent_vectors_of_the_oblique_example_belong_to_other_data() {
    for (id, change) in [
        ("ex-4.r0u", "q0u: [0, -60, 90] -> [0, -50, 60]"),
        ("ex-4.ru", "qu: [0, -50, 70] -> [0, -60, 80]"),
        ("ex-4.r1u", "q1u: [0, -50, -30] -> [0, -50, -60]"),
    ] {
        let id = format!("hermite-developable/{id}");
        assert_eq!(data_changes(&id), [change], "{id}");
    }
}

#[test]
fn each_changed_tangent_vector_explains_one_value_and_contradicts_none() {
    let outcome = decided("hermite-developable/ex-4.r1u");
    let data = outcome.data().unwrap();
    assert_eq!(data.explains, ["hermite-developable/ex-4.r1u"]);
    assert_eq!(data.contradicts, Vec::<String>::new());
    assert!(!data.explains_example);
}

#[test]
fn a_value_with_changed_data_is_still_refuted_as_printed() {
    assert_eq!(
        decided("hermite-developable/ex-4.ru").verdict(),
        Verdict::False
    );
}

#[test]
fn one_exchange_of_digits_explains_all_wrong_values_of_an_example() {
    for id in ["slips/one.area", "slips/one.slope"] {
        assert_eq!(data_changes(id), ["q: [3, 12] -> [3, 21]"], "{id}");
        let outcome = decided(id);
        let data = outcome.data().unwrap();
        assert_eq!(data.explains, ["slips/one.area", "slips/one.slope"], "{id}");
        assert!(data.explains_example && data.contradicts.is_empty(), "{id}");
        let words = words::data_correction(data);
        assert!(words.contains(&"`q` reads `[3, 21]` instead of `[3, 12]`".to_owned()));
        assert!(
            words.contains(&"this one change explains every wrong value of the example".to_owned())
        );
    }
}

#[test]
fn a_value_far_from_every_slip_stays_unexplained() {
    assert_eq!(decided("slips/far").data(), None);
}

/// The corrected statement of a misprint and the edits that lead to it.
fn corrected(id: &str) -> (String, Vec<String>) {
    let outcome = decided(id);
    assert_eq!(outcome.verdict(), Verdict::Misprint, "{id}");
    let correction = outcome.correction().unwrap();
    assert!(correction.unique, "{id}");
    (correction.statement.text.clone(), correction.edits.clone())
}

#[test]
fn a_printed_definition_is_corrected_where_it_is_defined() {
    let corrected_body = "b[0,1](z1)*sum(k, 0, m, f[k,m](z, mu, nu)*A[k]) + b[1,1](z1)*sum(k, 0, m, f[k,m](z, mu1, nu1)*B[k])";
    let (_, edits) = corrected("gbt-surfaces/eq-18");
    assert_eq!(
        edits,
        [
            "`f[k,m](z, mu, nu)` replaced by `f[k,m](z, mu1, nu1)`".to_owned(),
            format!("`printed` then is `{corrected_body}`"),
        ]
    );
}

#[test]
fn the_cylinder_is_a_tensor_product_with_functions_of_order_one() {
    let (statement, edits) = corrected("gbt-surfaces/eq-11");
    assert_eq!(
        statement,
        "T(z, z1) == sum(k, 0, m, f[k,m](z, mu, nu)*(b[0,1](z1)*net(k, 0) + b[1,1](z1)*net(k, 1)))"
    );
    let edit = "the functions `f[i,n](z1, mu1, nu1)` replaced by `b[i,1](z1)`";
    assert_eq!(edits.first().unwrap(), edit);
}

#[test]
fn the_wrong_curve_is_one_edit_in_each_coordinate() {
    for (id, edit) in [
        ("gbt-surfaces/eq-25.4.a", "`X` replaced by `U`"),
        ("gbt-surfaces/eq-25.4.b", "`Y` replaced by `V`"),
    ] {
        assert_eq!(corrected(id).1, [edit], "{id}");
    }
}

#[test]
fn exchanged_indices_turned_quotients_and_squares_for_pairs_are_one_edit() {
    for (id, edit) in [
        (
            "gbt-surfaces/eq-20.trajectory",
            "`P[1,l]` replaced by `P[l,1]`",
        ),
        ("bezier/join.C1.slip", "the quotient `n/m` turned over"),
        ("bezier/curve.d2.slip", "`m^2` replaced by `m*(m - 1)`"),
    ] {
        assert_eq!(corrected(id).1, [edit], "{id}");
    }
}

#[test]
fn one_factor_of_each_power_stays_a_sine_in_the_derivative_by_mu() {
    let (statement, edits) = corrected("gbt-developable/eq-2.3");
    assert_eq!(
        edits,
        ["`sin(pi/2*x)` replaced by `x` in the powers, one factor of each kept"]
    );
    assert!(
        statement.contains("(1 - sin(pi/2*x))*(1 - x)^(k - 2 - i)"),
        "{statement}"
    );
    assert!(statement.contains("sin(pi/2*x)*x^i"), "{statement}");
}

/// The right side derived anew for a false claim, and the words for it.
fn anew(id: &str) -> (String, Vec<String>) {
    let outcome = decided(id);
    assert_eq!(outcome.verdict(), Verdict::False, "{id}");
    let correction = outcome.correction().unwrap();
    let (_, right) = correction.statement.text.split_once(" == ").unwrap();
    (right.to_owned(), correction.edits.clone())
}

#[test]
fn a_coefficient_of_the_join_is_derived_anew_in_its_printed_terms() {
    let (right, edits) = anew("gbt-surfaces/thm-2.a3");
    assert_eq!(right, "a*(2*a1 - pi^2*(1 - 2*mu1 - nu1)) + 2*pi^2*nu");
    assert_eq!(
        edits,
        ["the right side derived anew from the printed terms"]
    );
    for id in ["gbt-surfaces/eq-5.Q12", "gbt-surfaces/eq-6.Q12"] {
        let edit = "`a3` derived anew from its printed terms: `a*(2*a1 - pi^2*(1 - 2*mu1 - nu1)) + 2*pi^2*nu`";
        assert_eq!(anew(id).1, [edit], "{id}");
    }
}

#[test]
fn the_determinant_of_the_quartic_system_keeps_two_of_its_three_powers() {
    assert_eq!(anew("hermite-developable/eq-3.6.det").0, "16*k^3*(1 - k)");
}

#[test]
fn a_wrong_determinant_is_that_of_a_matrix_with_two_other_entries() {
    assert_eq!(
        data_changes("hermite-developable/eq-3.6.det"),
        ["A36[2,1]: 32 -> 32*k", "A36[3,1]: -80 -> -80*k"]
    );
}

#[test]
fn one_slip_in_several_places_is_one_correction() {
    for (id, edit) in [
        ("slips/exponent", "`c` replaced by `c^2` in both places"),
        ("slips/factor", "`3` replaced by `5` in both places"),
        ("slips/names", "`mu1` and `mu2` exchanged"),
        ("slips/inner", "`i` replaced by `j` in `a^i*P[i]`"),
    ] {
        assert_eq!(corrected(id).1, [edit], "{id}");
    }
}

#[test]
fn a_slip_in_a_definition_of_the_printed_side_is_corrected_there() {
    for (id, edits) in [
        (
            "slips/weight",
            [
                "`w` replaced by `w^2` in both places",
                "`S` then is `(A + w^2*B)/(1 + w^2)`",
            ],
        ),
        (
            "slips/constant",
            [
                "`m` replaced by `n` in both places",
                "`e` then is `(n - 2)*(n - 3)`",
            ],
        ),
    ] {
        assert_eq!(corrected(id).1, edits, "{id}");
    }
}

#[test]
fn a_factor_on_the_wrong_side_of_a_relation_is_moved() {
    for (id, statement) in [
        ("slips/side", "r*F'(1) == G'(0)"),
        ("slips/side.left", "F'(1) == r*G'(0)"),
    ] {
        let edit = "the factor `r` moved to the other side";
        assert_eq!(corrected(id), (statement.to_owned(), vec![edit.to_owned()]));
    }
}

#[test]
fn the_other_curve_of_a_join_is_one_edit() {
    let edit = "`G'(0)` replaced by `F'(1)`";
    assert_eq!(corrected("slips/curve").1, [edit]);
}

#[test]
fn one_argument_is_taken_for_another_while_the_others_stay() {
    let outcome = decided("slips/blossom");
    let correction = outcome.correction().unwrap();
    assert_eq!(correction.edits, ["`f(0, 0, s)` replaced by `f(0, s, s)`"]);
    // The polar form is symmetric.
    assert!(!correction.unique);
}

#[test]
fn a_square_is_split_into_two_factors() {
    let edit = "`(v - c)^2` replaced by `(v - c)*(v - d)`";
    assert_eq!(corrected("slips/square").1, [edit]);
}

#[test]
fn a_step_that_does_not_follow_is_no_misprint_of_a_letter() {
    let outcome = decided("slips/step");
    assert_eq!(outcome.verdict(), Verdict::False);
    assert_eq!(outcome.correction(), None);
}
