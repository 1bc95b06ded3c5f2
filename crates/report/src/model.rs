//! The document model: what a report says about one paper, ready to be laid out.
//!
//! Every output is laid out from this one model, so PDF and HTML cannot disagree. It holds strings, positions and
//! formulas in the languages of the outputs ([`Mathematics`](crate::Mathematics)). Strings are cleared of characters that act on the
//! text around them; they are never read as markup by any output.

mod build;

pub(crate) use build::figure_file;

use crate::applicability::Construction;
use crate::corrections::Corrected;
use crate::findings::Finding;
use crate::glossary::Term;
use crate::letter::Letter;
use crate::math::Prose;
use crate::source::Source;
use crate::summary_page::Short;
use crate::tally::Tally;
pub use crate::view::{CorrectionView, FormulaView};
use serde::Serialize;

/// What a report says about one paper.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Report {
    /// The paper's slug.
    pub slug: String,
    /// The title.
    pub title: String,
    /// The authors.
    pub authors: String,
    /// Where it appeared.
    pub venue: String,
    /// What the report was made from.
    pub source: Option<Source>,
    /// How many claims have which verdict and evidence.
    pub tally: Tally,
    /// What a reader must know, in a minute.
    pub short: Short,
    /// What the paper builds and states by name, and whether it can be used.
    pub constructions: Vec<Construction>,
    /// What its authors are told.
    pub letter: Letter,
    /// What is false as printed, and what is to be read instead; what most rests on first.
    pub corrections: Vec<Corrected>,
    /// What was found out, in plain words.
    pub findings: Vec<Finding>,
    /// How many verdicts differ from what the derivation files expect.
    pub unexpected: usize,
    /// The claims by section of the paper, in the order of the paper.
    pub sections: Vec<Section>,
    /// The pictures.
    pub figures: Vec<FigureView>,
    /// Positions of the pictures that illustrate no claim of this paper.
    pub further_figures: Vec<usize>,
    /// Definitions that statements share.
    pub notation: Vec<Prose>,
}

/// The claims of one section of the paper.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Section {
    /// The heading, for instance `Section 3`.
    pub title: String,
    /// An identifier for links, unique in the report.
    pub anchor: String,
    /// The claims, in file order.
    pub claims: Vec<ClaimView>,
}

/// One claim.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ClaimView {
    /// The id of the inventory.
    pub id: String,
    /// The id without the paper's slug.
    pub name: String,
    /// An identifier for links, unique in the report.
    pub anchor: String,
    /// Where the paper says it.
    pub at: String,
    /// The kind of statement.
    pub kind: Term,
    /// What is true of it.
    pub verdict: Term,
    /// What that rests on.
    pub evidence: Option<Term>,
    /// How the verdict was checked.
    pub level: Option<Term>,
    /// What the derivation file expects, where that is something else.
    pub expected: Option<Term>,
    /// The statement as printed.
    pub printed: Prose,
    /// How our copy of the text was read.
    pub reading: Option<Prose>,
    /// The statement as understood.
    pub parsed: Option<FormulaView>,
    /// The assumptions, as understood.
    pub assumed: Vec<FormulaView>,
    /// What was found, in words.
    pub finding: Option<Prose>,
    /// What in the finding may be a confusion of the copy at hand.
    pub garbled: Option<Prose>,
    /// What the statement rests on, in small print.
    pub rests: Vec<RestsView>,
    /// Of a sentence with more than one reading: each of them.
    pub readings: Vec<ReadingView>,
    /// Extra conditions.
    pub conditions: Vec<FormulaView>,
    /// A proved correction.
    pub correction: Option<CorrectionView>,
    /// A change of printed data that explains a wrong value, line by line.
    pub data: Vec<Prose>,
    /// The derived right side.
    pub derived: Option<FormulaView>,
    /// Left side minus right side.
    pub difference: Option<FormulaView>,
    /// A counterexample.
    pub witness: Option<WitnessView>,
    /// Of a claim that denies what is so: that it is so everywhere, as a sentence.
    pub denied: Option<Prose>,
    /// The steps of the decision; equal ones in a row are counted.
    pub steps: Vec<Prose>,
    /// Anything a reader should know.
    pub note: Option<Prose>,
    /// What it rests on.
    pub uses: Vec<Reference>,
    /// What rests on it directly, unless it is refuted.
    pub used_by: Vec<Reference>,
    /// Of a refuted claim, what rests on it, nearest first, and whether that survives.
    pub consequences: Vec<ConsequenceView>,
    /// How many claims rest on it through others only, and survive, in words: counted, not listed.
    pub distant_survivors: Option<String>,
    /// Positions of the pictures shown here.
    pub figures: Vec<usize>,
    /// Positions of the pictures that illustrate it and are shown elsewhere.
    pub see_figures: Vec<usize>,
    /// The command that reproduces the verdict.
    pub command: String,
}

/// One reading of a sentence.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ReadingView {
    /// A word for it.
    pub name: Prose,
    /// The sentence as it is read here, in words.
    pub says: Prose,
    /// What is true of it.
    pub verdict: Term,
    /// What that rests on.
    pub evidence: Option<Term>,
    /// The statement as understood.
    pub parsed: Option<FormulaView>,
    /// Its assumptions.
    pub assumed: Vec<FormulaView>,
    /// Extra conditions.
    pub conditions: Vec<FormulaView>,
    /// The point at which it fails, in words.
    pub fails_at: Option<Prose>,
    /// What it rests on, in small print.
    pub rests: Vec<RestsView>,
}

/// Lines under one label, of what a statement rests on.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct RestsView {
    /// What they are.
    pub label: &'static str,
    /// The lines.
    pub lines: Vec<Prose>,
}

/// A point, and both sides of the statement there.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct WitnessView {
    /// The values of the symbols, each as an equation.
    pub at: Vec<Prose>,
    /// Whether the values are short enough to stand side by side.
    pub short: bool,
    /// The sides; one where both are equal.
    pub sides: Vec<Side>,
}

/// A side of a statement at a point.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Side {
    /// Which it is.
    pub label: &'static str,
    /// Its exact value.
    pub exact: Prose,
    /// Its value in decimals, empty where the exact one is as easy to read.
    pub decimal: String,
}

/// A claim that rests on a refuted one.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ConsequenceView {
    /// The claim.
    pub claim: Reference,
    /// What becomes of it, in words.
    pub fate: Prose,
    /// The claim in between that it rests on, if it does not rest on the refuted one itself.
    pub through: Option<Reference>,
}

/// A mention of another claim.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Reference {
    /// The claim's id.
    pub id: String,
    /// What a reader sees: the name without the slug for a claim of the same paper.
    pub shown: String,
    /// Its identifier for links, if this report has it.
    pub anchor: Option<String>,
}

/// A picture as the report shows it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct FigureView {
    /// The name of its file in the typesetter's world.
    pub file: String,
    /// An identifier for links, unique in the report.
    pub anchor: String,
    /// The number that readers see: the paper's, such as `2(a)`, or `E1`, `E2`, ... for a picture of ours.
    pub number: String,
    /// The caption.
    pub caption: Prose,
    /// What it shows, in words.
    pub alt: String,
    /// Whether it was redrawn from printed data alone.
    pub verdict: Term,
    /// What was filled with a default.
    pub assumes: Vec<Prose>,
    /// What was replaced by data of our own.
    pub stand_in: Vec<Prose>,
}
