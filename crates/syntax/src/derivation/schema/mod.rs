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

/// A text of the file and its place there.
pub type Text = Spanned<String>;

/// The bibliographic head of a paper.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PaperHead {
    /// The slug, the name of the folder. Files are called after it: it is a plain name ([`is_plain`]).
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

/// Whether a file may be called after this name, in whatever folder: letters, digits, `-`, `_` and `.`, no point at the
/// beginning and none beside another.
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
    match is_plain(&name) {
        true => Ok(name),
        false => Err(serde::de::Error::custom(format!(
            "`{name}` cannot be the id of a paper: files are called after it, so it is made of letters, digits, `-`, `_` \
             and single points, and does not begin with a point"
        ))),
    }
}

/// A symbol: what it stands for and where it lives.
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
    /// The words of the paper that say so.
    pub printed: Option<Text>,
    /// The claim in whose print they stand; the claim itself if left out.
    pub printed_in: Option<Text>,
    /// Why it is assumed though the paper does not say it.
    pub ours: Option<Text>,
}

impl SymbolEntry {
    /// Where the declaration is from, if the file says it.
    #[must_use]
    pub fn from(&self) -> Option<FromEntry> {
        let said = [&self.printed, &self.printed_in, &self.ours];
        said.iter().any(|text| text.is_some()).then(|| FromEntry {
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
    /// So many coordinates.
    Number(u8),
    /// One generic coordinate stands for all: for statements that are linear in the vectors.
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
    /// The two factors of the step `g[i,k] = a*g[i,k-1] + b*g[i-1,k-1]`; left out for a list of functions of one degree.
    #[serde(default)]
    pub step: Vec<Text>,
    /// The name that stands in the step for the index i of the function that is made.
    pub index: Option<Text>,
    /// The name that stands in the step for its degree k.
    pub order: Option<Text>,
}

/// One claim.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ClaimEntry {
    /// The id of the inventory: `paper/name`.
    pub id: Text,
    /// Where the paper says it.
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
    /// What in the finding may be a confusion of the copy at hand.
    pub garbled: Option<Text>,
    /// Symbols of this claim alone.
    #[serde(default)]
    pub symbols: BTreeMap<String, SymbolEntry>,
    /// Definitions of this claim alone.
    #[serde(default, rename = "let")]
    pub local: BTreeMap<String, Text>,
    /// Linear equations that determine the unknowns.
    #[serde(default)]
    pub given: Vec<HypothesisEntry>,
    /// The unknowns of the given equations.
    #[serde(default)]
    pub solve_for: Vec<Text>,
    /// Numbers of which the statement says that there are such, each perhaps with what it is.
    #[serde(default)]
    pub exists: Vec<Text>,
    /// Assumptions of the statement.
    #[serde(default)]
    pub assume: Vec<HypothesisEntry>,
    /// The statement in the formula language.
    pub states: Option<Text>,
    /// In place of `states`: what the sentence may mean, two readings or more.
    #[serde(default)]
    pub readings: Vec<ReadingEntry>,
    /// Why there is nothing to decide: what the paper does not print.
    pub underspecified: Option<String>,
    /// Why this is not a statement for this engine.
    pub out_of_scope: Option<String>,
    /// The drawing of a figure.
    pub figure: Option<Box<FigureEntry>>,
    /// Claims this one rests on.
    #[serde(default)]
    pub uses: Vec<Text>,
    /// The verdict that this claim is known to get; a run that differs fails.
    pub expect: Option<Verdict>,
    /// What was found, in a sentence with holes for numbers.
    pub finding: Option<Text>,
    /// How names of this claim are printed.
    #[serde(default)]
    pub display: BTreeMap<String, Text>,
    /// Why signs that the statement is not the print are none.
    #[serde(default)]
    pub answers: Vec<AnswerEntry>,
    /// Anything a reader should know.
    pub note: Option<String>,
}

/// One of the things that a sentence may mean. What it says is added to what the claim says.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ReadingEntry {
    /// A word for it, such as `literal`.
    pub name: Text,
    /// The sentence as it is read here, in words.
    pub says: Text,
    /// The statement in the formula language.
    pub states: Text,
    /// More symbols.
    #[serde(default)]
    pub symbols: BTreeMap<String, SymbolEntry>,
    /// More definitions.
    #[serde(default, rename = "let")]
    pub local: BTreeMap<String, Text>,
    /// More equations for unknowns.
    #[serde(default)]
    pub given: Vec<HypothesisEntry>,
    /// More unknowns.
    #[serde(default)]
    pub solve_for: Vec<Text>,
    /// More assumptions.
    #[serde(default)]
    pub assume: Vec<HypothesisEntry>,
}

/// Why a sign that the statement is not the print is none: words of the paper.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AnswerEntry {
    /// The sign.
    pub flag: Spanned<Flag>,
    /// The words.
    pub quote: Text,
    /// The claim in whose print they stand; the claim itself if left out.
    #[serde(rename = "in")]
    pub within: Option<Text>,
    /// How they answer it, where that is not plain.
    pub says: Option<String>,
}
