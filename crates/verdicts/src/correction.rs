//! Corrections of refuted claims: plain data.

use crate::certificate::DecisionCertificate;
use serde::Serialize;
use std::sync::Arc;
use torse_syntax::notation::Formula;

/// A corrected and proved form of a refuted formula.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Correction {
    /// The corrected statement.
    pub statement: Formula,
    /// The conditions under which it is true, like those of a verdict.
    pub conditions: Vec<Formula>,
    /// What was changed, in words, one entry an edit ("the factor 4 added", "k replaced by l").
    pub edits: Vec<String>,
    /// Whether no other correction with as few edits was found.
    pub unique: bool,
}

/// A change of printed data that explains a printed value: the value is wrong for the printed data and right for the
/// changed data.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct DataCorrection {
    /// The changed data.
    pub changes: Vec<DataChange>,
    /// The proof that the printed value then agrees.
    #[serde(skip)]
    pub certificate: Arc<DecisionCertificate>,
    /// Whether no other change of as few numbers, as close to the print, explains as much.
    pub unique: bool,
    /// The ids of the refuted values of the same example that this change explains, including this one.
    pub explains: Vec<String>,
    /// The ids of the values of the same example that hold for the printed data and fail for the changed data.
    pub contradicts: Vec<String>,
    /// Whether all refuted values of the example are explained, and none contradicted.
    pub explains_example: bool,
}

/// A printed datum and its corrected value.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct DataChange {
    /// The name of the datum.
    pub name: String,
    /// As printed.
    pub old: Formula,
    /// As it should read.
    pub new: Formula,
}
