//! Each flag of the audit is raised where it should be, and not where nothing is wrong.

use std::sync::Arc;
use torse_syntax::derivation::{Paper, Source, paper};
use torse_syntax::taxonomy::Flag;
use torse_verdicts::audit::{RaisedFlag, audit};
use torse_verdicts::engine::decide_claim;
use torse_verdicts::outcome::Outcome;

const HEAD: &str = r#"
[paper]
id = "p"
title = "T"
authors = "A"
venue = "V"
claims = ["c.toml"]
[symbols]
x = { in = "[0, 1]" }
y = {}
mu = { in = "[-1, 1]" }
k = { integer = ">= 2" }
v = { vector = 3 }
w = { vector = 3 }
R = { family = 3, indices = ["0..k"] }
[basis.g]
variable = "x"
parameters = ["mu"]
degree = 1
seeds = ['1 - mu*x', 'mu*x']
step = ['1 - x', 'x']
[define]
c = '3*y'
Q0 = '[0, 30, 0]'
"F(x)" = 'sum(i, 0, k, g[i,k](x)*R[i])'
"#;

fn loaded(claims: &str) -> Paper {
    paper(|name| {
        let text = if name == "paper.toml" { HEAD } else { claims };
        let (name, text) = (name.to_owned(), text.to_owned());
        Ok(Arc::new(Source::new(name, text)))
    })
    .expect("the claims make sense")
}

/// A claim with this print; the lines follow, and say the kind if it is no property.
fn claim(printed: &str, lines: &str) -> String {
    let kind = match lines.contains("kind = ") {
        true => "",
        false => "kind = 'property'\n",
    };
    format!("[[claim]]\nid = 'p/1'\nat = ''\nprinted = \"{printed}\"\n{kind}{lines}\n")
}

fn decided(paper: &Paper) -> Vec<Outcome> {
    let decide = |claim| decide_claim("p", claim).expect("every formula makes sense");
    paper.claims.iter().map(decide).collect()
}

/// The open signs of the first of these claims.
fn signs(claims: &str) -> Vec<RaisedFlag> {
    let paper = loaded(claims);
    let outcomes = decided(&paper);
    let pairs: Vec<_> = paper.claims.iter().zip(&outcomes).collect();
    audit(std::slice::from_ref(&paper), &pairs, || ())
        .remove(0)
        .open
}

/// What is seen under a flag.
fn seen(flag: Flag, printed: &str, lines: &str) -> Vec<String> {
    let signs = signs(&claim(printed, lines)).into_iter();
    let of_flag = signs.filter(|sign| sign.flag == flag);
    of_flag.map(|sign| sign.evidence).collect()
}

/// The flag is raised with these words for one statement, and not for the other, of the same print.
fn told(flag: Flag, printed: &str, wrong: &str, words: &str, right: &str) {
    assert_eq!(seen(flag, printed, wrong), [words], "{wrong}");
    let none: [&str; 0] = [];
    assert_eq!(seen(flag, printed, right), none, "{right}");
}

#[test]
fn a_side_compared_with_itself_is_flagged_unless_it_is_a_definition() {
    told(
        Flag::EqualSides,
        "Q_0 = (0, 30, 0)",
        "kind = 'value'\nstates = 'Q0 == [0, 30, 0]'",
        "`Q0` and `[0, 30, 0]` are the same formula",
        "kind = 'definition'\nstates = 'Q0 == [0, 30, 0]'",
    );
    told(
        Flag::EqualSides,
        "2y = y + y",
        "states = 'y + y == y + y'",
        "`y + y` and `y + y` are the same formula",
        "states = '2*y == y + y'",
    );
}

#[test]
fn a_statement_about_nothing_of_the_paper_is_flagged() {
    told(
        Flag::NothingOfThePaper,
        "four planes are too few for degree nine",
        "let = { planes = '4 - 1' }\nstates = 'planes < 10'",
        "no symbol, basis or definition of the paper occurs in the statement",
        "let = { planes = 'k - 1' }\nstates = 'planes >= 1'",
    );
}

#[test]
fn numbers_of_the_print_and_of_the_statement_are_compared() {
    let printed = "By (5.16) and Fig. 7, c/y = 3 for 4.5y, see [12]";
    told(
        Flag::LacksNumber,
        printed,
        "states = 'c == 3*y'",
        "printed and not stated: 9/2",
        "states = 'c*4.5 == 3*y*9/2'",
    );
    told(
        Flag::AddsNumber,
        "c is three times y",
        "states = '7*c == 21*y'",
        "stated and not printed: 7, 21",
        "states = 'c - y == 2*y'",
    );
}

#[test]
fn a_raised_digit_is_an_exponent_that_is_printed() {
    told(
        Flag::AddsNumber,
        "c is y³ y¹⁰",
        "states = 'c == y^11*y^2'",
        "stated and not printed: 11",
        "states = 'c == y^3*y^10'",
    );
}

#[test]
fn numbers_of_names_references_and_enumerations_are_no_numbers_of_the_print() {
    for printed in [
        "y_7 is y",
        "y in 7D is y",
        "y for k = 0, 7, ..., k is y",
        "y by (7) is y",
        "7. Take y",
        "y in Figs. 3 and 7 is y",
    ] {
        let none: [&str; 0] = [];
        let found = seen(Flag::LacksNumber, printed, "states = '2*y == y + y'");
        assert_eq!(found, none, "{printed}");
    }
}

#[test]
fn what_a_name_is_shown_as_counts_as_the_name() {
    told(
        Flag::LacksName,
        "for all μ, y = y",
        "states = 'c == 3*y'",
        "printed and not stated: `mu`",
        "states = 'c == 3*y'\ndisplay = { c = '$c(\\mu)$' }",
    );
}

#[test]
fn one_degree_refutes_a_sentence_about_all() {
    let none: [&str; 0] = [];
    let states = "kind = 'identity'\nstates = 'g[0,3](x) == 0'";
    assert_eq!(seen(Flag::OneDegree, "the functions vanish", states), none);
}

#[test]
fn names_of_the_print_and_of_the_statement_are_compared() {
    told(
        Flag::LacksName,
        "for all μ, y = y",
        "states = '2*y == y + y'",
        "printed and not stated: `mu`",
        "states = '2*mu*y == mu*(y + y)'",
    );
    told(
        Flag::AddsName,
        "y is half of 2y = y + y",
        "states = '2*mu*y == mu*(y + y)'",
        "stated and not printed: `mu`",
        "states = '2*y == y + y'",
    );
}

#[test]
fn relations_of_the_print_and_of_the_statement_are_compared() {
    told(
        Flag::LacksRelation,
        "y² ≠ -1",
        "states = 'y^2 == y*y'",
        "that something differs is printed and not stated",
        "states = 'y^2 != -1'",
    );
    told(
        Flag::AddsRelation,
        "y has a square",
        "states = 'y^2 >= 0'",
        "an inequality is stated and not printed",
        "states = 'y^2 == y*y'",
    );
    let positive = seen(
        Flag::AddsRelation,
        "the square is not negative",
        "states = 'y^2 >= 0'",
    );
    assert!(positive.is_empty(), "{positive:?}");
}

#[test]
fn a_conclusion_among_the_hypotheses_is_flagged_either_way_round() {
    told(
        Flag::AssumedConclusion,
        "y = μ gives 2y = 2μ",
        "assume = ['mu == y']\nstates = 'y == mu'",
        "`y == mu` is stated and assumed",
        "assume = ['mu == y']\nstates = '2*y == 2*mu'",
    );
}

#[test]
fn a_conjunction_shorter_than_the_sentence_is_flagged_and_parts_count_together() {
    let printed = "2y = y + y and y² ≥ 0 and y - y = 0";
    told(
        Flag::ShortConjunction,
        printed,
        "states = '2*y == y + y and y^2 >= 0'",
        "3 relations are printed, 2 stated or defined",
        "states = '2*y == y + y and y^2 >= 0 and y - y == 0'",
    );
    let part = |name: &str, states: &str| {
        let lines = format!("part_of = 'p/1'\nstates = '{states}'");
        claim(printed, &lines).replace("'p/1'\nat", &format!("'p/1.{name}'\nat"))
    };
    let parts = [
        part("a", "2*y == y + y and y^2 >= 0"),
        part("b", "y - y == 0"),
    ];
    let open = signs(&parts.concat());
    assert!(
        open.iter().all(|s| s.flag != Flag::ShortConjunction),
        "{open:?}"
    );
}

#[test]
fn one_degree_for_all_is_flagged_unless_the_print_names_it() {
    let lines = "states = 'g[0,3](x) + g[1,3](x) + g[2,3](x) + g[3,3](x) == 1'";
    let every = "states = 'sum(i, 0, k, g[i,k](x)) == 1'";
    let words = "a degree that is not printed: 3";
    told(
        Flag::OneDegree,
        "the functions have the sum one",
        lines,
        words,
        every,
    );
    assert!(
        seen(
            Flag::OneDegree,
            "the cubic functions have the sum one",
            lines
        )
        .is_empty()
    );
    let fixed = "assume = ['k == 3']\nstates = 'k > 2'";
    assert_eq!(seen(Flag::OneDegree, "k > 2", fixed), [words]);
}

#[test]
fn one_coordinate_for_a_vector_is_flagged() {
    told(
        Flag::OneCoordinate,
        "v + w = w + v",
        "states = '(v + w)[1] == (w + v)[1]'",
        "one entry of a vector alone: 1",
        "states = 'v + w == w + v'",
    );
    let members = seen(
        Flag::OneCoordinate,
        "R_0 + v = v + R_0",
        "states = 'R[0] + v == v + R[0]'",
    );
    assert!(members.is_empty(), "{members:?}");
}

#[test]
fn one_value_for_all_is_flagged_and_the_ends_are_not() {
    told(
        Flag::OneInstance,
        "the curve is in the plane",
        "states = 'cross(F(1/2), F(1/2)) == 0'",
        "a value that is not printed: 1/2",
        "states = 'cross(F(0), F(0)) == 0'",
    );
    let assumed = "assume = ['mu == 1/3']\nstates = 'y*mu == y/3'";
    assert_eq!(
        seen(Flag::OneInstance, "y is scaled by μ", assumed),
        ["a value that is not printed: 1/3"]
    );
}

#[test]
fn a_statement_in_which_no_slip_is_noticed_is_flagged() {
    told(
        Flag::NoMutant,
        "v × v = 0, and 2y = y + y",
        "states = 'cross(v, v) == 0'",
        "none of 21 changed statements is refuted",
        "states = '2*y == y + y'",
    );
}

#[test]
fn a_reading_of_what_is_not_stated_is_flagged() {
    told(
        Flag::UnstatedReading,
        "2y = y + y",
        "reading = 'the sum `c` of (3.2)'\nstates = '2*y == y + y'",
        "read, and not stated: `c`, (3.2)",
        "reading = 'the sum `y + y`'\nstates = '2*y == y + y'",
    );
}

#[test]
fn a_relation_of_which_nothing_is_stated_is_flagged() {
    let words = "the sentence has a relation, and nothing is stated";
    let lines = "out_of_scope = 'who knows'";
    assert_eq!(seen(Flag::UnstatedRelation, "y < 2", lines), [words]);
    assert!(seen(Flag::UnstatedRelation, "y is nice", lines).is_empty());
}

#[test]
fn a_hypothesis_of_ours_that_is_not_needed_is_flagged() {
    told(
        Flag::UnneededHypothesis,
        "y² ≥ 0",
        "assume = [{ states = 'y > 1', ours = 'why' }]\nstates = 'y^2 >= 0'",
        "proved without: `y > 1`",
        "assume = [{ states = 'y > 1', ours = 'why' }]\nstates = 'y > 0'",
    );
}

#[test]
fn an_answer_closes_its_flag_and_is_stale_where_there_is_none() {
    let lines = |states: &str| {
        let answer = "answers = [{ flag = 'adds-number', quote = 'three' }]";
        claim(
            "c is three times y",
            &format!("states = '{states}'\n{answer}"),
        )
    };
    for (states, counts) in [("c == 3*y", (1, 0)), ("c == y + y + y", (0, 1))] {
        let paper = loaded(&lines(states));
        let outcomes = decided(&paper);
        let pairs: Vec<_> = paper.claims.iter().zip(&outcomes).collect();
        let found = audit(std::slice::from_ref(&paper), &pairs, || ()).remove(0);
        assert!(found.open.iter().all(|s| s.flag != Flag::AddsNumber));
        assert_eq!(
            (found.answered.len(), found.stale.len()),
            counts,
            "{states}"
        );
    }
}

#[test]
fn the_signs_of_a_reading_name_it() {
    let lines = "readings = [{ name = 'a', says = 'x', states = 'y + y == y + y' }, { name = 'b', says = 'y', states = '2*y == y + y' }]";
    assert_eq!(
        seen(Flag::EqualSides, "2y = y + y", lines),
        ["read as `a`: `y + y` and `y + y` are the same formula"]
    );
}

/// A fault that changes words of the first claim.
fn fault(printed: &str, reads: &str, states: &str) -> String {
    format!(
        "[[corrigendum]]\nid = 'p/corrigendum.1'\nsays = 'A fault'\nshows = ['p/1']\n[[corrigendum.change]]\nclaim = 'p/1'\nprinted = \"{printed}\"\nreads = \"{reads}\"\nstates = '{states}'\n"
    )
}

#[test]
fn a_range_or_a_hypothesis_without_a_source_is_flagged_and_where_functions_begin_is_none() {
    told(
        Flag::UnsourcedRange,
        "y times y is positive for y > 0",
        "symbols = { y = { in = '(0, inf)' } }\nassume = ['c != 1']\nstates = 'y*c > 0'",
        "neither printed nor ours: the range of `y`, `c != 1`",
        "symbols = { y = { in = '(0, inf)', printed = 'y > 0' } }\nassume = [{ states = 'c != 1', ours = 'an example' }]\nstates = 'y*c > 0'",
    );
    // The lowest order of the basis is 1; an index of a sum and a parameter of a definition are no symbols.
    told(
        Flag::UnsourcedRange,
        "the functions have the sum 1",
        "symbols = { k = { integer = '>= 3' }, i = { integer = '0..k' } }\nstates = 'sum(i, 0, k, g[i,k](x, y)) == 1'",
        "neither printed nor ours: the range of `k`, the range of `x`",
        "symbols = { k = { integer = '>= 1' }, x = {} }\nstates = 'sum(i, 0, k, g[i,k](x, y)) == 1'",
    );
}

#[test]
fn a_claim_in_which_a_fault_shows_and_nothing_is_refuted_is_flagged() {
    let of = |states: &str, more: &str| {
        let first = claim("c = 2y", &format!("states = '{states}'\n{more}"));
        let signs = signs(&[first, fault("2y", "3y", "c == 3*y")].concat());
        let mut signs = signs.into_iter();
        signs.find(|sign| sign.flag == Flag::AccusedWithoutVerdict)
    };
    let raised = of("c == 3*y", "").expect("the flag is raised");
    assert!(raised.evidence.contains("p/corrigendum.1"), "{raised:?}");
    assert_eq!(of("c == 2*y", ""), None);
    assert_eq!(of("c == 3*y", "garbled = '2 for 3'"), None);
}

#[test]
fn a_reading_that_is_the_correction_by_another_number_is_flagged() {
    let readings = "readings = [{ name = 'a', says = 'a', states = 'c == 2*y' }, { name = 'b', says = 'b', states = 'c == 3*y' }]";
    let of = |printed: &str, old: &str, new: &str, states: &str| {
        let signs = signs(&[claim(printed, readings), fault(old, new, states)].concat());
        let mut signs = signs.into_iter();
        signs.find(|sign| sign.flag == Flag::CorrectedReading)
    };
    let raised = of("c = 2y", "2y", "3y", "c == 3*y").expect("the flag is raised");
    assert_eq!(
        raised.evidence,
        "`2y` is read as `3y`: a correction, and no reading"
    );
    // Words that are added, and a correction that is no reading.
    assert_eq!(
        of(
            "c is a multiple",
            "c is a multiple",
            "c is a threefold multiple",
            "c == 3*y"
        ),
        None
    );
    assert_eq!(of("c = 2y", "2y", "3y + 0", "c == 3*y + 0"), None);
}

#[test]
fn the_same_sentence_of_two_papers_has_one_verdict() {
    let of = |second: &str| {
        let print =
            "All of these curves have three times the length of their first control polygon";
        let first = loaded(&claim(print, "states = 'c == 3*y'"));
        let claims = claim(print, second).replace("p/1", "q/1");
        let second = paper(|name| {
            let head = HEAD.replace("id = \"p\"", "id = \"q\"");
            let text = if name == "paper.toml" { &head } else { &claims };
            Ok(Arc::new(Source::new(name.to_owned(), text.clone())))
        });
        let papers = [first, second.expect("the claims make sense")];
        let outcomes: Vec<Outcome> = papers.iter().flat_map(decided).collect();
        let claims = papers.iter().flat_map(|paper| &paper.claims);
        let pairs: Vec<_> = claims.zip(&outcomes).collect();
        let audited = audit(&papers, &pairs, || ());
        let flags = audited.iter().flat_map(|of| &of.open);
        flags.filter(|sign| sign.flag == Flag::SamePrint).count()
    };
    assert_eq!(of("states = 'c == 4*y'"), 2);
    assert_eq!(of("out_of_scope = 'nothing to decide'"), 2);
    assert_eq!(of("states = 'c + y == 4*y'"), 0);
}
