//! The kernel as judge of the generator: proofs of true statements are accepted, and the same scripts for false ones are
//! not.

use crate::support::{LIMITS, accepts_all, coqc, with_library};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::sync::Arc;
use torse_certificate::Evidence;
use torse_rocq::coqc::Answer;
use torse_rocq::folder::{Folder, Layout};
use torse_rocq::script::OTHERS;
use torse_rocq::script_search;
use torse_rocq::task::ProofTask;
use torse_syntax::derivation::{Claim, LoadError, Source, paper};
use torse_syntax::taxonomy::Verdict;

/// A true statement, a false one that differs from it by one edit, and the evidence of the true one.
const PAIRS: [(&str, &str, Evidence); 22] = [
    (
        "(x + 1)^2 == x^2 + 2*x + 1",
        "(x + 1)^2 == x^2 - 2*x + 1",
        Evidence::Identity,
    ),
    ("x/(x*y) == 1/y", "x/(x*y) == 1/x", Evidence::Identity),
    (
        "D(x^3*y, x, 2) == 6*x*y",
        "D(x^3*y, x, 2) == 3*x*y",
        Evidence::Identity,
    ),
    (
        "sum(i, 0, 3, i^2) == 14",
        "sum(i, 0, 3, i^2) == 15",
        Evidence::Identity,
    ),
    (
        "det([[x, y], [1, 2]]) == 2*x - y",
        "det([[x, y], [1, 2]]) == 2*x + y",
        Evidence::Identity,
    ),
    (
        "cross([x, y, 1], [x, y, 1]) == 0",
        "cross([x, y, 1], [y, x, 1]) == 0",
        Evidence::Identity,
    ),
    (
        "sum(i, 0, m, B[i,m](x)) == 1",
        "sum(i, 0, m, B[i,m](x)) == 2",
        Evidence::Induction,
    ),
    (
        "B[i,m](x) == (1 - x)*B[i,m-1](x) + x*B[i-1,m-1](x)",
        "B[i,m](x) == (1 - x)*B[i,m-1](x) + x*B[i,m-1](x)",
        Evidence::Induction,
    ),
    (
        "B[m-i,m](1 - x) == B[i,m](x)",
        "B[m-i,m](1 - x) == B[i,m](1 - x)",
        Evidence::Induction,
    ),
    (
        "B[0,m](0) == 1 and B[m,m](1) == 1",
        "B[0,m](0) == 1 and B[0,m](1) == 1",
        Evidence::Induction,
    ),
    (
        "exp(x + y)*exp(-y) == exp(x)",
        "exp(x + y)*exp(-x) == exp(x)",
        Evidence::Identity,
    ),
    (
        "D(exp(x*y), x) == y*exp(x*y)",
        "D(exp(x*y), x) == x*exp(x*y)",
        Evidence::Identity,
    ),
    ("exp(x) >= 1 + x", "exp(x) >= 2 + x", Evidence::Inequality),
    ("exp(1) > 27/10", "exp(1) > 28/10", Evidence::Enclosure),
    ("fails(x*y == x)", "fails(x*y == y*x)", Evidence::Identity),
    (
        "U[1,2](x) == 1/2 + x*(1 - x)",
        "U[1,2](x) == 1/2 - x*(1 - x)",
        Evidence::Identity,
    ),
    (
        "sum(i, 0, 1, N[i,1](x, 2)) == 1",
        "sum(i, 0, 1, N[i,1](x, 2)) == 2",
        Evidence::Identity,
    ),
    (
        "sum(i, 0, 2, [x, y, 3][i+1]) == x + y + 3",
        "sum(i, 0, 2, [x, y, 3][i+1]) == x + y + 2",
        Evidence::Identity,
    ),
    (
        "D(f(x)^2, x) == 2*f(x)*f'(x)",
        "D(f(x)^2, x) == 2*f(x)*f(x)",
        Evidence::Identity,
    ),
    (
        "D(D(f(x*y), x), y) == f'(x*y) + x*y*D(f, x, 2)(x*y)",
        "D(D(f(x*y), x), y) == f'(x*y) + x*y*f'(x*y)",
        Evidence::Identity,
    ),
    ("not x*y != y*x", "not x*y != y*y", Evidence::Identity),
    ("not x^2 + 1 <= 0", "not x^2 - 1 <= 0", Evidence::Inequality),
];

/// The claims of a paper with these statements.
fn claims(statements: &[&str]) -> Vec<Claim> {
    let mut text =
        "[symbols]\nx = {}\ny = {}\nf = { function = 1 }\nt = { family = 1, indices = ['0..7'] }\nj = {}\nT = { family = 2, indices = ['0..m'] }\nm = { integer = '>= 1' }\ni = { integer = '0..m' }\n\
                    [basis.B]\nvariable = 'x'\ndegree = 0\nseeds = ['1']\nstep = ['1 - x', 'x']\n\
                    [basis.U]\nvariable = 'x'\ndegree = 0\nseeds = ['1']\nindex = 'q'\norder = 'r'\n\
                    step = ['(q + 1 - x)/r', '(x + r - q)/r']\n\
                    [basis.N]\nvariable = 'x'\nparameters = ['j']\ndegree = 0\nseeds = ['1']\nindex = 'q'\norder = 'r'\n\
                    step = ['(t[j+q+1] - x)/(t[j+q+1] - t[j+q+1-r])', '(x - t[j+q-r])/(t[j+q] - t[j+q-r])']\n"
            .to_owned();
    for (place, states) in statements.iter().enumerate() {
        write!(
            text,
            "[[claim]]\nid = 'p/c{place}'\nat = 'Sect. 1'\nkind = 'identity'\nprinted = 'as stated'\nstates = \"{states}\"\n"
        )
        .unwrap();
    }
    let read = |name: &str| -> Result<Arc<Source>, LoadError> {
        let head = "[paper]\nid = 'p'\ntitle = ''\nauthors = ''\nvenue = ''\nclaims = ['c.toml']\n";
        let text = if name == "paper.toml" {
            head.to_owned()
        } else {
            text.clone()
        };
        Ok(Arc::new(Source::new(name, text)))
    };
    paper(read).unwrap().claims
}

/// The folder in which all these claims are said to hold.
fn folder(claims: &[Claim], evidence: impl Fn(usize) -> Evidence) -> Folder {
    let task = |(place, claim)| ProofTask {
        id: format!("p/c{place}"),
        claim,
        verdict: Verdict::Holds,
        evidence: Some(evidence(place)),
        conditions: vec![],
        correction: None,
        witness: vec![],
        solved: vec![],
    };
    let tasks = claims.iter().enumerate().map(task).collect();
    Folder::new(&[("p".to_owned(), tasks)], &BTreeMap::new())
}

#[test]
fn true_statements_are_accepted_on_the_four_axioms() {
    let Some(coqc) = coqc() else { return };
    let statements: Vec<&str> = PAIRS.iter().map(|(good, _, _)| *good).collect();
    let claims = claims(&statements);
    let folder = folder(&claims, |place| PAIRS[place].2);
    let axioms = accepts_all(&coqc, &folder, PAIRS.len());
    assert!(!axioms.is_empty());
}

#[test]
fn false_statements_are_rejected_with_the_scripts_of_the_true_ones() {
    let Some(coqc) = coqc() else { return };
    let statements: Vec<&str> = PAIRS.iter().map(|(_, bad, _)| *bad).collect();
    let claims = claims(&statements);
    let folder = folder(&claims, |place| PAIRS[place].2);
    let scratch = with_library(&coqc);
    let failing =
        script_search::failing(&coqc, &folder, scratch.path(), 20, LIMITS, &|_, _| ()).unwrap();
    // What is printed may follow all the same from what is not proved.
    let core = folder.theorems.iter().filter(|t| t.rests_on.is_none());
    let wanted: BTreeSet<String> = core.map(|t| t.name()).collect();
    let failing: BTreeSet<String> = failing.into_keys().collect();
    let accepted: Vec<&String> = wanted.difference(&failing).collect();
    assert_eq!(accepted, Vec::<&String>::new());
}

#[test]
fn a_rejected_proof_is_told_with_the_words_of_the_kernel() {
    let Some(coqc) = coqc() else { return };
    let claims = claims(&["x + 1 == x"]);
    let folder = folder(&claims, |_| Evidence::Identity);
    let scratch = with_library(&coqc);
    let (answers, axioms) = coqc.check(&folder, scratch.path(), LIMITS, &|| ()).unwrap();
    let answer = answers.get("P/Section_1.c0").unwrap();
    assert!(
        matches!(answer, Answer::Rejected(words) if words.contains("Error")),
        "{answer:?}"
    );
    assert_eq!(axioms, [""; 0]);
}

#[test]
fn the_axioms_of_what_is_accepted_are_told_beside_a_rejected_proof() {
    let Some(coqc) = coqc() else { return };
    let claims = claims(&["x + 1 == 1 + x", "x + 1 == x"]);
    let folder = folder(&claims, |_| Evidence::Identity);
    let scratch = with_library(&coqc);
    let (answers, axioms) = coqc.check(&folder, scratch.path(), LIMITS, &|| ()).unwrap();
    assert_eq!(answers.get("P/Section_1.c0"), Some(&Answer::Accepted));
    let bad = answers.get("P/Section_1.c1");
    assert!(matches!(bad, Some(Answer::Rejected(_))), "{bad:?}");
    assert!(!axioms.is_empty());
}

#[test]
fn divisors_are_premises_and_can_be_met() {
    let claims = claims(&["x/(x*y) == 1/y"]);
    let folder = folder(&claims, |_| Evidence::Identity);
    let text = &folder.files["P/Section_1.v"];
    let statement = "forall (x : R) (y : R),\n  x * y <> 0 ->\n  y <> 0 ->\n  x / (x * y) = 1 / y.";
    assert!(text.contains(statement), "{text}");
    let instance = "exists (x : R) (y : R),\n  x * y <> 0 /\\\n  y <> 0.";
    assert!(text.contains(instance), "{text}");
    assert!(folder.files["P/Section_1_proofs.v"].contains("Theorem met : instance."));
}

#[test]
fn knots_that_have_to_differ_are_premises() {
    let claims = claims(&["N[0,2](x, 2) == 0"]);
    let folder = folder(&claims, |_| Evidence::Identity);
    let text = &folder.files["P/Section_1.v"];
    // Every factor of the recursion up to the degree that is named has a value, and no index is outside of its range.
    let statement = "forall (t : Z -> R) (x : R),\n  t 3%Z - t 2%Z <> 0 ->\n  t 3%Z - t 1%Z <> 0 ->\n  \
                     t 4%Z - t 2%Z <> 0 ->\n  N_ t x 2%Z 0%Z 2%Z = 0.";
    assert!(text.contains(statement), "{text}");
}

#[test]
fn a_factor_that_multiplies_nothing_needs_no_value() {
    // At degree 3 the factors reach from t[0] to t[5], at degree 4 one would be outside of the family.
    let claims = claims(&["N[3,3](x, 2) == 0", "N[3,4](x, 2) == 0"]);
    let folder = folder(&claims, |_| Evidence::Identity);
    let text = &folder.files["P/Section_1.v"];
    let (inside, outside) = text.split_once("Module c1.").unwrap();
    assert!(!inside.contains("<= 7"), "{inside}");
    assert!(outside.contains("(0 <= (-1) <= 7)%Z"), "{outside}");
}

#[test]
fn a_place_that_is_a_symbol_is_in_its_list() {
    let claims = claims(&["[x, y][m] == x"]);
    let folder = folder(&claims, |_| Evidence::Identity);
    let text = &folder.files["P/Section_1.v"];
    let premise = "(1 <= m <= 2)%Z ->\n  entry [x; y] (Z.to_nat m) = x";
    assert!(text.contains(premise), "{text}");
}

#[test]
fn a_coordinate_may_stand_behind_the_indices_of_its_point() {
    let claims = claims(&["T[0,1] == T[0][1]"]);
    let folder = folder(&claims, |_| Evidence::Identity);
    let text = &folder.files["P/Section_1.v"];
    assert!(text.contains("entry (T 0%Z) 1 = entry (T 0%Z) 1"), "{text}");
}

#[test]
fn other_scripts_prove_what_follows_from_equations_and_nothing_else() {
    let Some(coqc) = coqc() else { return };
    // The first follows, the second does not.
    let claims = claims(&[
        "x^2 + y^2 == 1 implies (x + y)^2 - 2*x*y == 1",
        "x^2 + y^2 == 1 implies (x + y)^2 - 2*x*y == 2",
    ]);
    let task = |(place, claim)| ProofTask {
        id: format!("p/c{place}"),
        claim,
        verdict: Verdict::Holds,
        evidence: Some(Evidence::Identity),
        conditions: vec![],
        correction: None,
        witness: vec![],
        solved: vec![],
    };
    let tasks: Vec<ProofTask<'_>> = claims.iter().enumerate().map(task).collect();
    let papers = [("p".to_owned(), tasks)];
    for which in 1..=OTHERS.len() {
        let chosen = ["P/Section_1.c0", "P/Section_1.c1"].map(|name| (name.to_owned(), which));
        let folder = Folder::with_scripts(
            &papers,
            &BTreeMap::new(),
            &BTreeMap::from(chosen),
            Layout::Together,
        );
        let scratch = with_library(&coqc);
        let failing =
            script_search::failing(&coqc, &folder, scratch.path(), 40, LIMITS, &|_, _| ()).unwrap();
        let failing: Vec<&String> = failing.keys().collect();
        assert_eq!(failing, ["P/Section_1.c1"], "{which}");
    }
    // There is no further script.
    let chosen = [("P/Section_1.c0".to_owned(), OTHERS.len() + 1)];
    let folder = Folder::with_scripts(
        &papers,
        &BTreeMap::new(),
        &BTreeMap::from(chosen),
        Layout::Together,
    );
    let names: Vec<String> = folder.theorems.iter().map(|t| t.name()).collect();
    assert_eq!(names, ["P/Section_1.c1", "P/Section_1_printed.c1"]);
}

#[test]
fn the_same_findings_make_the_same_files() {
    let statements: Vec<&str> = PAIRS.iter().map(|(good, _, _)| *good).collect();
    let [one, two] = [claims(&statements), claims(&statements)];
    let evidence = |place: usize| PAIRS[place].2;
    assert_eq!(folder(&one, evidence).files, folder(&two, evidence).files);
}
