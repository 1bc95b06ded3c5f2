//! Coefficients of forms: what the statements say, that the kernel accepts the true ones, and rejects the same scripts for
//! false ones.

use crate::support::{LIMITS, accepts_all, coqc, with_library};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use torse_certificate::Evidence;
use torse_rocq::folder::Folder;
use torse_rocq::script_search;
use torse_rocq::solutions::Solved;
use torse_rocq::task::ProofTask;
use torse_rocq::theorem::Theorem;
use torse_syntax::derivation::{Claim, LoadError, Source, paper};
use torse_syntax::taxonomy::Verdict;

/// Equations for members of a family, whose right sides are members of another.
const MEMBERS: &str =
    "given = ['P[0] == Q[m-1]', 'P[1] - P[0] == Q[0]']\nsolve_for = ['P[0]', 'P[1]']\n";
/// Two equations for a and b, whose solution is a = (x + y)/2, b = (x - y)/2.
const EQUATIONS: &str = "given = ['a + b == x', 'a - b == y']\nsolve_for = ['a', 'b']\n";

/// A true statement under the equations, or without any, and a false one that differs from it by one edit.
const PAIRS: [(&str, &str, &str); 8] = [
    ("a == (x + y)/2", "a == (x - y)/2", EQUATIONS),
    (
        "coefficients([a + 3*b], [x]) == [[2]]",
        "coefficients([a + 3*b], [x]) == [[3]]",
        EQUATIONS,
    ),
    (
        "coefficients([a, b], [x, y]) == [[1/2, 1/2], [1/2, -1/2]]",
        "coefficients([a, b], [x, y]) == [[1/2, 1/2], [1/2, 1/2]]",
        EQUATIONS,
    ),
    // A symbol that stands beside the unknowns moves too.
    (
        "coefficients([a*k + x*k], [x])[1, 1] == 3/2*k",
        "coefficients([a*k + x*k], [x])[1, 1] == 1/2*k",
        EQUATIONS,
    ),
    // No unknown occurs: the derivative as it stands.
    (
        "coefficients([3*x - y*k], [y])[1, 1] == -k",
        "coefficients([3*x - y*k], [y])[1, 1] == k",
        EQUATIONS,
    ),
    (
        "coefficients([3*P[0] - k*P[2]], [P[2], P[1]]) == [[-k, 0]]",
        "coefficients([3*P[0] - k*P[2]], [P[2], P[1]]) == [[-k, 3]]",
        "",
    ),
    (
        "coefficients([at(sum(i, 0, m, B[i,m](x)*Q[i]), x, 0)], [Q[0]])[1, 1] == 1",
        "coefficients([at(sum(i, 0, m, B[i,m](x)*Q[i]), x, 0)], [Q[1]])[1, 1] == 1",
        "",
    ),
    (
        "coefficients([T[1,0] - T[0,1]], [T[1,0]]) == [[1]]",
        "coefficients([T[1,0] - T[0,1]], [T[0,1]]) == [[1]]",
        "",
    ),
];

/// The claims with these statements.
fn claims(statements: &[(&str, &str)]) -> Vec<Claim> {
    let mut text = "[symbols]\nx = {}\ny = {}\nk = {}\na = {}\nb = {}\nm = { integer = '>= 2' }\n\
                    P = { family = 'any', indices = ['0..2'] }\nQ = { family = 'any', indices = ['0..m'] }\nT = { family = 'any', indices = ['0..1', '0..1'] }\n\
                    [basis.B]\nvariable = 'x'\ndegree = 0\nseeds = ['1']\nstep = ['1 - x', 'x']\n"
        .to_owned();
    for (place, (states, given)) in statements.iter().enumerate() {
        text.push_str(&format!(
            "[[claim]]\nid = 'p/c{place}'\nat = 'Sect. 1'\nkind = 'identity'\nprinted = 'as stated'\n{given}states = '{states}'\n"
        ));
    }
    let read = |name: &str| -> Result<Arc<Source>, LoadError> {
        let head = "[paper]\nid = 'p'\ntitle = ''\nauthors = ''\nvenue = ''\nclaims = ['c.toml']\n";
        let text = if name == "paper.toml" { head } else { &text };
        Ok(Arc::new(Source::new(name, text)))
    };
    paper(read).unwrap().claims
}

fn solved() -> Vec<Solved> {
    let value = |unknown: &str, above: &str| Solved {
        unknown: unknown.to_owned(),
        above: above.to_owned(),
        below: "2".to_owned(),
    };
    vec![value("a", "x + y"), value("b", "x - y")]
}

/// The folder in which all these claims have this verdict.
fn folder(claims: &[Claim], verdict: Verdict) -> Folder {
    let task = |(place, claim): (usize, _)| ProofTask {
        id: format!("p/c{place}"),
        claim,
        verdict,
        evidence: Some(Evidence::Identity),
        conditions: vec![],
        correction: None,
        witness: vec![],
        solved: solved(),
    };
    let tasks = claims.iter().enumerate().map(task).collect();
    Folder::new(&[("p".to_owned(), tasks)], &BTreeMap::new())
}

#[test]
fn an_unknown_is_a_function_of_the_symbol_whose_coefficient_is_asked_for() {
    let folder = folder(
        &claims(&[("coefficients([a + 3*b], [x]) == [[2]]", EQUATIONS)]),
        Verdict::Holds,
    );
    let text = &folder.files["P/Section_1.v"];
    let statement = "forall (a : R) (b : R) (x : R) (y : R) (a_of_x : R -> R) (b_of_x : R -> R),\n  \
                     a + b = x ->\n  a - b = y ->\n  a_of_x x = a ->\n  b_of_x x = b ->\n  \
                     (forall x : R, (a_of_x x) + (b_of_x x) = x) ->\n  \
                     (forall x : R, (a_of_x x) - (b_of_x x) = y) ->\n  \
                     [[Derive_n (fun x => (a_of_x x) + 3 * (b_of_x x)) 1 x]] = [[2]].";
    assert!(text.contains(statement), "{text}");
}

#[test]
fn a_form_without_unknowns_is_differentiated_as_it_stands() {
    let folder = folder(
        &claims(&[("coefficients([3*x - y*k], [y])[1, 1] == -k", EQUATIONS)]),
        Verdict::Holds,
    );
    let text = &folder.files["P/Section_1.v"];
    let conclusion = "entry (row [[Derive_n (fun y => 3 * x - y * k) 1 y]] 1) 1 = - k.";
    assert!(text.contains(conclusion), "{text}");
    assert!(!text.contains("_of_"), "{text}");
}

#[test]
fn a_member_is_replaced_in_its_family() {
    let folder = folder(
        &claims(&[("coefficients([3*P[0] - P[2]], [P[2]])[1, 1] == -1", "")]),
        Verdict::Holds,
    );
    let text = &folder.files["P/Section_1.v"];
    let form = "Derive_n (fun t => 3 * (update1 P 2%Z t) 0%Z - (update1 P 2%Z t) 2%Z) 1 (P 2%Z)";
    assert!(text.contains(form), "{text}");
}

#[test]
fn members_move_along_equations_for_members_of_another_family() {
    let states = "coefficients([P[1] - Q[0]], [Q[m-1]]) == [[1]]";
    let folder = folder(&claims(&[(states, MEMBERS)]), Verdict::Holds);
    let text = &folder.files["P/Section_1.v"];
    let moved = "(update1 (update1 P 0%Z (P_0_of_t t)) 1%Z (P_1_of_t t))";
    let parts = [
        "(P_0_of_t : R -> R) (P_1_of_t : R -> R)".to_owned(),
        "P_0_of_t (Q (m - 1)%Z) = P 0%Z ->\n  P_1_of_t (Q (m - 1)%Z) = P 1%Z ->".to_owned(),
        format!("(forall t : R, {moved} 0%Z = (update1 Q (m - 1)%Z t) (m - 1)%Z)"),
        format!("(forall t : R, {moved} 1%Z - {moved} 0%Z = (update1 Q (m - 1)%Z t) 0%Z)"),
        format!(
            "[[Derive_n (fun t => {moved} 1%Z - (update1 Q (m - 1)%Z t) 0%Z) 1 (Q (m - 1)%Z)]] = [[1]]"
        ),
    ];
    for part in parts {
        assert!(text.contains(&part), "{part}\n{text}");
    }
    // Whether two members of one family are the same is not known where an index is a symbol.
    let other = MEMBERS.replace("P[0]", "Q[0]");
    let folder = self::folder(&claims(&[(states, &other)]), Verdict::Holds);
    assert_eq!(folder.theorems.len(), 0);
    let reason = &folder.missing[0].reason;
    assert!(reason.contains("coefficients of unknowns"), "{reason}");
}

#[test]
fn what_is_not_plainly_linear_is_not_refuted_or_denied() {
    let refused = [
        ("coefficients([x*x*y], [x]) == [[y]]", Verdict::False),
        ("fails(coefficients([x*x*y], [x]) == 0)", Verdict::Holds),
        ("fails(coefficients([y*sin(x)], [x]) == 0)", Verdict::Holds),
    ];
    for (states, verdict) in refused {
        let folder = folder(&claims(&[(states, "")]), verdict);
        assert_eq!(folder.theorems.len(), 0, "{states}");
        assert!(
            folder.missing[0].reason.contains("not plainly linear"),
            "{states}: {}",
            folder.missing[0].reason
        );
    }
    let plain = "coefficients([(x*k - 3)/y + 2*x], [x]) == [[k]]";
    let folder = folder(&claims(&[(plain, "")]), Verdict::False);
    assert_eq!(proved(&folder).count(), 1, "{:?}", folder.missing);
}

#[test]
fn what_moves_along_equations_has_to_be_said_for_every_value() {
    let along_unknown = folder(
        &claims(&[("coefficients([x + b], [a]) == [[0]]", EQUATIONS)]),
        Verdict::Holds,
    );
    assert!(
        along_unknown.missing[0]
            .reason
            .contains("coefficients of unknowns"),
        "{:?}",
        along_unknown.missing
    );
}

/// The theorems as they are proved.
fn proved(folder: &Folder) -> impl Iterator<Item = &Theorem> {
    folder.theorems.iter().filter(|t| t.rests_on.is_none())
}

#[test]
fn true_coefficients_are_accepted() {
    let Some(coqc) = coqc() else { return };
    let statements: Vec<(&str, &str)> = PAIRS
        .iter()
        .map(|(good, _, given)| (*good, *given))
        .collect();
    let folder = folder(&claims(&statements), Verdict::Holds);
    assert_eq!(proved(&folder).count(), PAIRS.len(), "{:?}", folder.missing);
    accepts_all(&coqc, &folder, PAIRS.len());
}

#[test]
fn false_coefficients_are_rejected_with_the_scripts_of_the_true_ones() {
    let Some(coqc) = coqc() else { return };
    let statements: Vec<(&str, &str)> =
        PAIRS.iter().map(|(_, bad, given)| (*bad, *given)).collect();
    let folder = folder(&claims(&statements), Verdict::Holds);
    assert_eq!(proved(&folder).count(), PAIRS.len(), "{:?}", folder.missing);
    let scratch = with_library(&coqc);
    let failing =
        script_search::failing(&coqc, &folder, scratch.path(), 60, LIMITS, &|_, _| ()).unwrap();
    let wanted: BTreeSet<String> = proved(&folder).map(|t| t.name()).collect();
    // What is printed follows all the same.
    let found: BTreeSet<String> = failing.keys().cloned().collect();
    assert_eq!(found, wanted);
    assert!(
        failing
            .values()
            .all(|why| why == "the tactics find no proof"),
        "{failing:?}"
    );
}

#[test]
fn wrong_values_of_unknowns_prove_nothing() {
    let Some(coqc) = coqc() else { return };
    let claims = claims(&[("coefficients([a + 3*b], [x]) == [[4]]", EQUATIONS)]);
    let wrong = Solved {
        unknown: "b".to_owned(),
        above: "3*x - y".to_owned(),
        below: "2".to_owned(),
    };
    let task = ProofTask {
        id: "p/c0".to_owned(),
        claim: &claims[0],
        verdict: Verdict::Holds,
        evidence: Some(Evidence::Identity),
        conditions: vec![],
        correction: None,
        witness: vec![],
        solved: vec![solved()[0].clone(), wrong],
    };
    let folder = Folder::new(&[("p".to_owned(), vec![task])], &BTreeMap::new());
    let scratch = with_library(&coqc);
    let failing =
        script_search::failing(&coqc, &folder, scratch.path(), 60, LIMITS, &|_, _| ()).unwrap();
    assert_eq!(failing.len(), 1);
}
