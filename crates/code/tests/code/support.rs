//! Papers, programs and comparisons.

use miette::Diagnostic;
use std::path::Path;
use torse_code::{CodeQuestion, Comparison, PrintedSide, compare};
use torse_syntax::derivation::{self, DerivationError, Paper};

/// The work of a comparison: enough for all of them, and little beside the standard.
const WORK: u64 = 200_000_000;

/// A paper of the repository.
pub fn paper(id: &str) -> Paper {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../derivations");
    derivation::open(&folder.join(id)).unwrap()
}

/// The text of a program of the tests.
pub fn program(file: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/programs");
    std::fs::read_to_string(folder.join(file)).unwrap()
}

/// How a function is compared.
#[derive(Clone, Copy)]
pub struct Row {
    pub function: &'static str,
    pub claim: &'static str,
    pub side: PrintedSide,
    pub part: Option<usize>,
    pub conditions: &'static [&'static str],
    pub map: &'static [(&'static str, &'static str)],
}

/// A function with the names of its claim, compared with the printed side.
pub const fn row(function: &'static str, claim: &'static str) -> Row {
    Row {
        function,
        claim,
        side: PrintedSide::Printed,
        part: None,
        conditions: &[],
        map: &[],
    }
}

impl Row {
    pub const fn left(self) -> Self {
        Self {
            side: PrintedSide::Left,
            ..self
        }
    }

    pub const fn part(self, part: usize) -> Self {
        Self {
            part: Some(part),
            ..self
        }
    }

    pub const fn fixing(self, conditions: &'static [&'static str]) -> Self {
        Self { conditions, ..self }
    }

    pub const fn mapping(self, map: &'static [(&'static str, &'static str)]) -> Self {
        Self { map, ..self }
    }

    /// Compares the function of a program with the claim.
    pub fn compare(self, file: &str, text: &str) -> Result<Comparison, Box<DerivationError>> {
        let owned = |(name, formula): &(&str, &str)| ((*name).to_owned(), (*formula).to_owned());
        let question = CodeQuestion {
            map: self.map.iter().map(owned).collect(),
            conditions: self.conditions.iter().map(|c| (*c).to_owned()).collect(),
            side: self.side,
            part: self.part,
            ..CodeQuestion::new(file, text, self.function)
        };
        let (id, _) = self.claim.split_once('/').unwrap();
        let paper = paper(id);
        let claim = paper
            .claims
            .iter()
            .find(|claim| claim.entry.id.get_ref() == self.claim);
        compare(WORK, id, claim.unwrap(), &question)
    }
}

/// The functions of `curves.py`.
pub const PYTHON: [Row; 14] = [
    row("curve", "bezier/bernstein.formula"),
    row("casteljau", "bezier/curve.casteljau").fixing(&["m == 3"]),
    row("hodograph", "bezier/curve.hodograph").fixing(&["m == 3"]),
    row("last_tangent", "bezier/curve.d1").part(2),
    row("second_derivative", "bezier/curve.d2").part(1),
    row("middle", "bezier/curve.midpoint"),
    row("first", "gbt-surfaces/eq-1.f0").left(),
    row("third", "gbt-surfaces/eq-1.f2").left(),
    row("basis", "gbt-surfaces/eq-2")
        .left()
        .fixing(&["m == 3", "k == 1"]),
    row("cubic", "hermite-developable/eq-2.1a"),
    row("quartic", "hermite-developable/eq-2.2"),
    row("uniform", "splines/uniform.cubic"),
    row("inner", "trigonometric/quadratic.middle"),
    row("tangent", "trigonometric/quadratic.d1").part(1),
];

/// The functions of `curves.rs`.
pub const RUST: [Row; 9] = [
    row("curve", "bezier/bernstein.formula")
        .fixing(&["m == 3"])
        .mapping(&[("p", "P")]),
    row("casteljau", "bezier/curve.casteljau")
        .fixing(&["m == 3"])
        .mapping(&[("p", "P")]),
    row("second_derivative", "bezier/curve.d2")
        .part(2)
        .mapping(&[("p", "P")]),
    row("middle", "bezier/curve.midpoint").mapping(&[("p", "P")]),
    row("first", "gbt-surfaces/eq-1.f0").left(),
    row("third", "gbt-surfaces/eq-1.f2").left(),
    row("basis", "gbt-surfaces/eq-2")
        .left()
        .fixing(&["m == 3", "k == 2"]),
    row("cubic", "hermite-developable/eq-2.1a"),
    row("uniform", "splines/uniform.cubic"),
];

/// An error on a line: its place in the program, what is wrong, and what would be right.
pub fn line(error: &DerivationError, text: &str) -> String {
    let label = error.labels().unwrap().next().unwrap();
    let before = text.get(..label.offset()).unwrap();
    let line = before.matches('\n').count() + 1;
    let column = before.rsplit('\n').next().unwrap().chars().count() + 1;
    let marked = text
        .get(label.offset()..label.offset() + label.len())
        .unwrap();
    let help = error.help().unwrap();
    format!("{line}:{column} `{marked}`: {error}\n    {help}")
}
