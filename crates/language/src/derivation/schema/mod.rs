//! The shape of a derivation file, as TOML. See `derivations/README.md` for the language.

pub mod figure;

use crate::words::{Kind, Verdict};
use figure::FigureEntry;
use serde::Deserialize;
use std::collections::BTreeMap;
use toml::Spanned;

/// A text of the file and its place there.
pub type Text = Spanned<String>;

/// The bibliographic head of a paper.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PaperHead {
    /// The slug, the name of the folder.
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

/// A symbol: what it stands for and where it lives.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SymbolEntry {
    /// An interval: `"[-1, 1]"`, `"(0, inf)"`.
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
    /// The two factors of the step `g[i,k] = a*g[i,k-1] + b*g[i-1,k-1]`.
    pub step: Vec<Text>,
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
    /// How a garbled or unclear print was read.
    pub reading: Option<String>,
    /// Symbols of this claim alone.
    #[serde(default)]
    pub symbols: BTreeMap<String, SymbolEntry>,
    /// Definitions of this claim alone.
    #[serde(default, rename = "let")]
    pub local: BTreeMap<String, Text>,
    /// Linear equations that determine the unknowns.
    #[serde(default)]
    pub given: Vec<Text>,
    /// The unknowns of the given equations.
    #[serde(default)]
    pub solve_for: Vec<Text>,
    /// Assumptions of the statement.
    #[serde(default)]
    pub assume: Vec<Text>,
    /// The statement in the formula language.
    pub states: Option<Text>,
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
    /// Anything a reader should know.
    pub note: Option<String>,
}
