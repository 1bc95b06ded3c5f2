//! Numbers of a derivation file, exactly.

use std::path::Path;
use std::sync::LazyLock;
use torse_geometry::{Ball, Fraction};
use torse_prove::context::solve_given;
use torse_prove::decide::order::enclosure;
use torse_prove::evaluate::Evaluator;
use torse_prove::evaluate::quantity::Quantity;
use torse_prove::evaluate::value::Value;
use torse_syntax::derivation::{Claim, Paper, Written, load};
use torse_syntax::formula::{Expr, parse};
use torse_syntax::notation::text;

/// How precisely numbers are enclosed.
const BITS: usize = 128;

static PAPERS: LazyLock<Vec<Paper>> = LazyLock::new(|| {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../derivations");
    load(&folder).expect("the derivations load")
});

/// A number: as it is written, and enclosed.
pub struct Exact {
    pub text: String,
    pub ball: Ball,
}

/// The claims of the three papers.
pub fn claims() -> impl Iterator<Item = &'static Claim> {
    let papers = PAPERS.iter().filter(|paper| paper.head.authors != "torse");
    papers.flat_map(|paper| &paper.claims)
}

pub fn claim(id: &str) -> &'static Claim {
    let mut claims = PAPERS.iter().flat_map(|paper| &paper.claims);
    claims
        .find(|claim| claim.entry.id.get_ref() == id)
        .unwrap_or_else(|| panic!("no claim {id}"))
}

/// The entries of a formula in the names of a claim, row by row; symbols have the values of `at`, the given equations and the
/// assumed ones are solved for the claim's unknowns and for `solved`.
pub fn entries(id: &str, formula: &str, at: &[(&str, &str)], solved: &[&str]) -> Vec<Exact> {
    let claim = claim(id);
    let mut evaluator = Evaluator::new(&claim.declarations);
    for (name, value) in at {
        let value = Evaluator::new(&claim.declarations).evaluate(&expr(value));
        let Ok(Value::Scalar(quantity)) = value else {
            panic!("{id}: no number for {name}")
        };
        let value = quantity.as_fraction().expect("a number").clone();
        evaluator.fix((*name).to_owned(), value);
    }
    let origin = &claim.statement.as_ref().expect("a statement").origin;
    let mut unknowns = claim.unknowns.clone();
    unknowns.extend(solved.iter().map(|name| Written {
        expr: expr(name),
        origin: origin.clone(),
    }));
    let mut equations: Vec<Written> = claim.given.iter().map(|h| h.formula.clone()).collect();
    if !solved.is_empty() {
        equations.extend(claim.assumptions.iter().map(|h| h.formula.clone()));
    }
    let solution = solve_given(&equations, &unknowns, &evaluator)
        .unwrap_or_else(|fault| panic!("{id}: {}", fault.problem));
    evaluator.determine(solution);
    let value = evaluator
        .evaluate(&expr(formula))
        .unwrap_or_else(|fault| panic!("{id}: {formula}: {}", fault.problem));
    let of = |quantity: &&Quantity| {
        let number = quantity.as_fraction();
        exact(number.unwrap_or_else(|| panic!("{id}: {formula} is no number")))
    };
    value.entries().iter().map(of).collect()
}

fn expr(formula: &str) -> Expr {
    parse(formula).unwrap_or_else(|fault| panic!("{formula}: {fault:?}"))
}

fn exact(number: &Fraction) -> Exact {
    Exact {
        text: text(&torse_prove::formula::expression(number)),
        ball: enclosure(number, BITS).expect("a number can be enclosed"),
    }
}
