//! The shape of a derivation file, as TOML. See `derivations/README.md` for the language.

pub mod corrigendum;
pub mod figure;
pub mod hypothesis;

use crate::taxonomy::{Flag, Kind, Verdict};
use figure::FigureEntry;
use hypothesis::{FromEntry, HypothesisEntry};
use serde::Deserialize;
use std::collections::BTreeMap;
use toml::Spanned;

/// The JSON schema of derivation files, for editors: `derivations/schema.json`, of which this is the text.
pub const DERIVATION_SCHEMA: &str = include_str!("schema.json");

/// A text with its place in the file.
pub type Text = Spanned<String>;

/// The bibliographic head of a paper.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PaperHead {
    /// The slug, which is also the name of the folder. Files are named after it, so it must be a plain name
    /// ([`is_plain`]).
    #[serde(deserialize_with = "plain")]
    pub id: String,
    /// The title.
    pub title: String,
    /// The authors, one line.
    pub authors: String,
    /// Journal, volume, year.
    pub venue: String,
    /// Digital object identifier.
    #[serde(default)]
    pub doi: Option<String>,
    /// The files with claims, in the order of the paper.
    pub claims: Vec<Text>,
}

impl PaperHead {
    /// Whether it is a worked folder of ours, and no paper.
    #[must_use]
    pub fn is_worked(&self) -> bool {
        is_worked(&self.authors)
    }
}

/// Whether these are the authors of a worked folder of ours, and of no paper.
#[must_use]
pub fn is_worked(authors: &str) -> bool {
    authors == "torse"
}

/// Whether files can be named after this name in any folder: it consists of letters, digits, `-`, `_` and `.`, does
/// not begin with a point, and has no two adjacent points.
///
/// ```
/// use torse_syntax::derivation::schema::is_plain;
/// assert!(is_plain("gbt-surfaces") && is_plain("volume_2.1"));
/// assert!(!is_plain("../elsewhere") && !is_plain("/tmp/x") && !is_plain(".hidden") && !is_plain(""));
/// ```
#[must_use]
pub fn is_plain(name: &str) -> bool {
    let letter = |c: char| c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | '.');
    !name.is_empty() && name.chars().all(letter) && !name.starts_with('.') && !name.contains("..")
}

fn plain<'d, D: serde::Deserializer<'d>>(deserializer: D) -> Result<String, D::Error> {
    let name = String::deserialize(deserializer)?;
    if is_plain(&name) {
        Ok(name)
    } else {
        Err(serde::de::Error::custom(format!(
            "`{name}` cannot be the id of a paper: files are called after it, so it is made of letters, digits, `-`, `_` \
             and single points, and does not begin with a point"
        )))
    }
}

/// A symbol, declared with its kind and its domain.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SymbolEntry {
    /// An interval: `"[-1, 1]"`, `"(0, inf)"`, `"[0, c]"`.
    #[serde(rename = "in")]
    pub interval: Option<Text>,
    /// An integer symbol with its bound: `">= 2"`, or a range `"0..k"` (both ends included).
    pub integer: Option<Text>,
    /// A vector: its dimension, or `"any"` for one generic coordinate.
    pub vector: Option<Spanned<Dimension>>,
    /// A family of points (of this dimension, or `"any"`) or, with dimension 1, of scalars.
    pub family: Option<Spanned<Dimension>>,
    /// The range of each index of a family: `["0..k"]`.
    pub indices: Option<Vec<Text>>,
    /// Any smooth function of one variable: the dimension of its values, 1 for numbers, or `"any"` for one generic
    /// coordinate.
    pub function: Option<Spanned<Dimension>>,
    /// The words of the paper that state the domain.
    pub printed: Option<Text>,
    /// The claim whose printed text contains them; by default the claim itself.
    pub printed_in: Option<Text>,
    /// Why the domain is assumed although the paper does not state it.
    pub ours: Option<Text>,
}

impl SymbolEntry {
    /// The fields that state the provenance of the declaration, if the file has any.
    #[must_use]
    pub fn from(&self) -> Option<FromEntry> {
        let fields = [&self.printed, &self.printed_in, &self.ours];
        fields.iter().any(|text| text.is_some()).then(|| FromEntry {
            printed: self.printed.clone(),
            within: self.printed_in.clone(),
            ours: self.ours.clone(),
        })
    }
}

/// The dimension of a vector.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(untagged)]
pub enum Dimension {
    /// This many coordinates.
    Number(u8),
    /// One generic coordinate, which represents all; for statements that are linear in the vectors.
    Any(AnyDimension),
}

/// The word `any`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
pub enum AnyDimension {
    /// `"any"`
    #[serde(rename = "any")]
    Any,
}

/// A basis family by its seeds and its step.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BasisEntry {
    /// The variable, for instance `x`.
    pub variable: Text,
    /// The shape parameters, in the order in which they may be given after the variable.
    #[serde(default)]
    pub parameters: Vec<Text>,
    /// The degree of the seeds.
    pub degree: Spanned<u8>,
    /// The functions of the lowest degree.
    pub seeds: Vec<Text>,
    /// The two factors of the step `g[i,k] = a*g[i,k-1] + b*g[i-1,k-1]`; left out for a list of functions of a single
    /// degree.
    #[serde(default)]
    pub step: Vec<Text>,
    /// The name that stands in the step for the index i of the new function.
    pub index: Option<Text>,
    /// The name that stands in the step for its degree k.
    pub order: Option<Text>,
}

/// One claim.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ClaimEntry {
    /// The id in the inventory: `paper/name`.
    pub id: Text,
    /// The place in the paper.
    pub at: String,
    /// What kind of statement it is.
    pub kind: Kind,
    /// The statement as printed, verbatim.
    pub printed: String,
    /// The id in the inventory of the sentence of which this is a part: `paper/name` for the parts `paper/name.a` and
    /// `paper/name.b`.
    pub part_of: Option<Text>,
    /// How a garbled or unclear print was read.
    pub reading: Option<String>,
    /// What in the finding may be an error of our copy of the paper.
    pub garbled: Option<Text>,
    /// Symbols that are declared for this claim only.
    #[serde(default)]
    pub symbols: BTreeMap<String, SymbolEntry>,
    /// Definitions for this claim only.
    #[serde(default, rename = "let")]
    pub local: BTreeMap<String, Text>,
    /// Linear equations that determine the unknowns.
    #[serde(default)]
    pub given: Vec<HypothesisEntry>,
    /// The unknowns of the given equations.
    #[serde(default)]
    pub solve_for: Vec<Text>,
    /// Numbers that the statement says to exist, each optionally with a witness.
    #[serde(default)]
    pub exists: Vec<Text>,
    /// Assumptions of the statement.
    #[serde(default)]
    pub assume: Vec<HypothesisEntry>,
    /// The statement in the formula language.
    pub states: Option<Text>,
    /// Instead of `states`: the statement in LaTeX, without dollar signs. After loading, `states` has what was read.
    pub latex: Option<Text>,
    /// Instead of `states`: two or more possible readings of the sentence.
    #[serde(default)]
    pub readings: Vec<ReadingEntry>,
    /// Why there is nothing to decide: the data that the paper does not print.
    pub underspecified: Option<String>,
    /// Why the statement is outside the scope of this program.
    pub out_of_scope: Option<String>,
    /// What is still to be done before the statement can be stated: the claim is undecided until then.
    pub unstated: Option<String>,
    /// The drawing of a figure.
    pub figure: Option<Box<FigureEntry>>,
    /// The function that computes the printed side: `torse compare` compares both.
    pub code: Option<CodeEntry>,
    /// Claims on which this one depends.
    #[serde(default)]
    pub uses: Vec<Text>,
    /// The verdict that this claim is known to get; a run with another verdict fails.
    pub expect: Option<Verdict>,
    /// The author's note about the finding, a sentence in which formulas are evaluated.
    pub finding: Option<Text>,
    /// How names of this claim are displayed.
    #[serde(default)]
    pub display: BTreeMap<String, Text>,
    /// Answers to signs that the statement is not what the paper prints.
    #[serde(default)]
    pub answers: Vec<AnswerEntry>,
    /// Any other information for the reader.
    pub note: Option<String>,
}

/// A function of a program, and how it is compared with the claim.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CodeEntry {
    /// The file, seen from the folder of the paper.
    pub file: Text,
    /// The name of the function.
    pub function: Text,
    /// What names of its parameters stand for: formulas of the claim.
    #[serde(default)]
    pub map: BTreeMap<String, Text>,
    /// Hypotheses of the comparison besides those of the claim, such as `n == 3`.
    #[serde(default, rename = "where")]
    pub conditions: Vec<Text>,
    /// The side of the equation that the function computes, where it is not the printed one.
    pub side: Option<SideEntry>,
    /// Which equation of a statement with several, counted from one.
    pub part: Option<usize>,
}

/// A side of an equation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SideEntry {
    /// The left one.
    Left,
    /// The right one.
    Right,
}

/// One possible reading of a sentence. Its fields are added to those of the claim.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ReadingEntry {
    /// A short name, such as `literal`.
    pub name: Text,
    /// The sentence in words, as this reading understands it.
    pub says: Text,
    /// The statement in the formula language.
    pub states: Text,
    /// Additional symbols.
    #[serde(default)]
    pub symbols: BTreeMap<String, SymbolEntry>,
    /// Additional definitions.
    #[serde(default, rename = "let")]
    pub local: BTreeMap<String, Text>,
    /// Additional equations for unknowns.
    #[serde(default)]
    pub given: Vec<HypothesisEntry>,
    /// Additional unknowns.
    #[serde(default)]
    pub solve_for: Vec<Text>,
    /// Additional assumptions.
    #[serde(default)]
    pub assume: Vec<HypothesisEntry>,
}

/// An answer to a sign (flag) that the statement is not what the paper prints: words of the paper.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AnswerEntry {
    /// The flag.
    pub flag: Spanned<Flag>,
    /// The words.
    pub quote: Text,
    /// The claim whose printed text contains them; by default the claim itself.
    #[serde(rename = "in")]
    pub within: Option<Text>,
    /// Why the words answer the flag, where that is not plain.
    pub says: Option<String>,
}
