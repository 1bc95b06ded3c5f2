//! The document model: the contents of a report about one paper, ready to be laid out.
//!
//! Every output is laid out from this one model, so PDF and HTML cannot disagree. It holds strings, positions and
//! formulas in the languages of the outputs ([`Mathematics`](crate::Mathematics)). Characters that act on the text
//! around them are removed from strings; no output reads strings as markup.

mod build;
mod recurring;

#[cfg(feature = "pdf")]
pub(crate) use build::figure_file;

use crate::applicability::NamedResult;
use crate::corrections::Corrected;
use crate::findings::Finding;
use crate::glossary::Term;
use crate::letter::Letter;
use crate::source::Source;
use crate::summary_page::SummaryPage;
use crate::tally::Tally;
pub use crate::view::{CorrectionView, FormulaView};
pub use recurring::ProofStep;
use serde::Serialize;
use torse_typography::Prose;

/// The report about one paper.
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
    /// The sources of the report.
    pub source: Option<Source>,
    /// How many claims have which verdict and evidence.
    pub tally: Tally,
    /// The summary, to be read in a minute.
    pub short: SummaryPage,
    /// What the paper builds and names, and whether it can be used.
    pub constructions: Vec<NamedResult>,
    /// The letter to its authors.
    pub letter: Letter,
    /// Errors and corrections: the faults of the letter, in its order.
    pub corrections: Vec<Corrected>,
    /// What may be right in print, and a slip of the copy at hand.
    pub questions: Vec<Corrected>,
    /// The findings, in plain words.
    pub findings: Vec<Finding>,
    /// How many verdicts differ from those that the derivation files expect.
    pub unexpected: usize,
    /// The claims by section of the paper, in the order of the paper.
    pub sections: Vec<Section>,
    /// The pictures.
    pub figures: Vec<FigureView>,
    /// Whether the documents about all papers lie beside this one: the first page, the gallery, the verdicts.
    pub has_neighbours: bool,
    /// The figure that stands for the paper where there is room for one.
    pub picture: Option<Picture>,
    /// Positions of the pictures that illustrate no claim of this paper.
    pub further_figures: Vec<usize>,
    /// Definitions that statements share.
    pub notation: Vec<Prose>,
    /// The sources of hypotheses, to which claims refer by number.
    pub sources: Vec<Prose>,
    /// Steps of proofs that many claims share, to which they refer by number.
    pub recurring_steps: Vec<Prose>,
}

/// A figure in a file beside the report.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Picture {
    /// The path of the file.
    pub file: String,
    /// A description in words.
    pub alt: String,
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
    /// The place in the paper.
    pub at: String,
    /// The kind of statement.
    pub kind: Term,
    /// The verdict.
    pub verdict: Term,
    /// Its evidence.
    pub evidence: Option<Term>,
    /// How the verdict was checked.
    pub level: Option<Term>,
    /// The expected verdict of the derivation file, if it differs.
    pub expected: Option<Term>,
    /// Whose words they are: `printed`, or `ours`.
    pub words_of: &'static str,
    /// The words of the statement.
    pub printed: Prose,
    /// How our copy of the text was read.
    pub reading: Option<Prose>,
    /// The statement as understood.
    pub parsed: Option<FormulaView>,
    /// The assumptions, as understood.
    pub assumed: Vec<FormulaView>,
    /// The finding, in words.
    pub finding: Option<Prose>,
    /// What in the finding may be an artefact of our copy of the paper.
    pub garbled: Option<Prose>,
    /// The dependencies of the statement, in small print.
    pub rests: Vec<RestsView>,
    /// The numbers of the sources of its hypotheses.
    pub sources: Vec<usize>,
    /// The readings of a sentence that has more than one.
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
    /// For a refuted denial: that the denied statement holds everywhere, as a sentence.
    pub denied: Option<Prose>,
    /// The steps of the decision; equal ones in a row are counted.
    pub steps: Vec<Prose>,
    /// The same steps, each once: those that recur in the report by number.
    pub proof: Vec<ProofStep>,
    /// Anything a reader should know.
    pub note: Option<Prose>,
    /// The claims that it uses.
    pub uses: Vec<Reference>,
    /// The claims that use it directly, unless it is refuted.
    pub used_by: Vec<Reference>,
    /// For a refuted claim, the claims that depend on it, nearest first, and whether each survives.
    pub consequences: Vec<ConsequenceView>,
    /// How many claims depend on it through others only, and survive, in words: counted, not listed.
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
    /// Its name.
    pub name: Prose,
    /// The sentence in this reading, in words.
    pub says: Prose,
    /// Its verdict.
    pub verdict: Term,
    /// Its evidence.
    pub evidence: Option<Term>,
    /// The statement as understood.
    pub parsed: Option<FormulaView>,
    /// Its assumptions.
    pub assumed: Vec<FormulaView>,
    /// Extra conditions.
    pub conditions: Vec<FormulaView>,
    /// The point at which it fails, in words.
    pub fails_at: Option<Prose>,
    /// The dependencies, in small print.
    pub rests: Vec<RestsView>,
    /// The numbers of the sources of its hypotheses.
    pub sources: Vec<usize>,
}

/// Lines under one label, about the dependencies of a statement.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct RestsView {
    /// The label.
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
    /// Its name.
    pub label: &'static str,
    /// Its exact value.
    pub exact: Prose,
    /// Its value in decimals, empty if the exact one is as easy to read.
    pub decimal: String,
}

/// A claim that depends on a refuted one.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ConsequenceView {
    /// The claim.
    pub claim: Reference,
    /// Its fate, in words.
    pub fate: Prose,
    /// The claim in between, if it does not use the refuted one itself.
    pub through: Option<Reference>,
}

/// A mention of another claim.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Reference {
    /// The claim's id.
    pub id: String,
    /// The text of the link: for a claim of the same paper, the name without the slug.
    pub shown: String,
    /// Its identifier for links, if it is in this report.
    pub anchor: Option<String>,
}

/// A picture as the report shows it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct FigureView {
    /// The name of its file for the typesetter.
    pub file: String,
    /// An identifier for links, unique in the report.
    pub anchor: String,
    /// Its number: the paper's, such as `2(a)`, or `E1`, `E2`, ... for our own pictures.
    pub number: String,
    /// The caption.
    pub caption: Prose,
    /// A description in words.
    pub alt: String,
    /// Whether it was redrawn from printed data alone.
    pub verdict: Term,
    /// Data with a default.
    pub assumes: Vec<Prose>,
    /// Data replaced by our own.
    pub stand_in: Vec<Prose>,
}
