//! Derivations of all kinds, from the derivation files: what a reader may ask `torse derive` for.

use std::path::Path;
use torse_syntax::derivation::declarations::Declarations;
use torse_syntax::derivation::{Paper, load};
use torse_verdicts::derive::{
    Derivation, Geometric, Shape, continuity, end_derivatives, geometric,
};

fn declarations<'p>(papers: &'p [Paper], paper: &str, basis: &str) -> &'p Declarations {
    let paper = papers.iter().find(|p| p.head.id == paper).unwrap();
    let claims = paper.claims.iter().map(|claim| &*claim.declarations);
    let mut all = std::iter::once(&*paper.declarations).chain(claims);
    all.find(|declarations| declarations.basis(basis).is_some())
        .unwrap()
}

/// Each with a name.
pub fn derived() -> Vec<(String, Derivation)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../derivations");
    let papers = load(&folder).unwrap();
    let symbolic = Shape::default();
    let at = |degree| Shape {
        degree: Some(degree),
        rational: false,
    };
    let rational = Shape {
        degree: None,
        rational: true,
    };
    let cases = [
        ("bezier", "B", symbolic),
        ("gbt-developable", "g", symbolic),
        ("bezier", "B", at(3)),
        ("bezier", "B", rational),
        ("splines", "U", at(3)),
        ("bezier", "T", at(2)),
    ];
    let mut all = vec![];
    for (paper, basis, shape) in cases {
        // Two bases of the worked example have the name T: that of one degree is meant.
        let declarations = match shape == at(2) {
            true => {
                let paper = papers.iter().find(|p| p.head.id == paper).unwrap();
                let claims = paper.claims.iter().map(|claim| &*claim.declarations);
                let mut lists = claims.filter(|d| d.basis(basis).is_some_and(|b| b.is_list));
                lists.next().unwrap()
            }
            false => declarations(&papers, paper, basis),
        };
        let name = |what: &str| format!("{paper} {basis} {shape:?} {what}");
        let order = if shape.rational { 2 } else { 3 };
        let ends = end_derivatives(declarations, basis, order, shape).unwrap();
        all.push((name("ends"), ends));
        for order in 1..=2 {
            if let Ok(join) = continuity(declarations, basis, order, shape) {
                all.push((name(&format!("C{order}")), join));
            }
        }
        for condition in [Geometric::G1, Geometric::Beta] {
            if let Ok(join) = geometric(declarations, basis, condition, shape) {
                all.push((name(&format!("{condition:?}")), join));
            }
        }
    }
    assert!(all.len() > 24, "{}", all.len());
    all
}
