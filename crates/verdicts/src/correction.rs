//! Corrections of refuted claims: plain data.

use serde::Serialize;
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

impl Correction {
    /// Describes the change and the conditions of the corrected statement, a line each.
    #[must_use]
    pub fn in_words(&self) -> Vec<String> {
        let conditions = self.conditions.iter();
        let conditions = conditions.map(|condition| format!("true if `{}`", condition.text));
        self.edits.iter().cloned().chain(conditions).collect()
    }
}

/// A change of printed data that explains a printed value: the value is wrong for the printed data and right for the
/// changed data.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct DataCorrection {
    /// The changed data.
    pub changes: Vec<DataChange>,
    /// How the printed value then agrees, in words.
    pub steps: Vec<String>,
    /// Whether no other change of as few numbers, as close to the print, explains as much.
    pub unique: bool,
    /// The ids of the refuted values of the same example that this change explains, including this one.
    pub explains: Vec<String>,
    /// The ids of the values of the same example that hold for the printed data and fail for the changed data.
    pub contradicts: Vec<String>,
    /// Whether all refuted values of the example are explained, and none contradicted.
    pub explains_example: bool,
}

impl DataCorrection {
    /// Describes what to change and what it explains, a line each.
    #[must_use]
    pub fn in_words(&self) -> Vec<String> {
        let change = |c: &DataChange| {
            format!(
                "`{}` reads `{}` instead of `{}`",
                c.name, c.new.text, c.old.text
            )
        };
        let mut lines: Vec<String> = self.changes.iter().map(change).collect();
        lines.extend(self.steps.iter().cloned());
        lines.push(match (self.explains_example, self.explains.as_slice()) {
            (true, [_, _, ..]) => {
                "this one change explains every wrong value of the example".to_owned()
            }
            (_, [_, _, ..]) => format!("it explains {}", self.explains.join(", ")),
            _ => "it explains this value alone".to_owned(),
        });
        if !self.contradicts.is_empty() {
            lines.push(format!("it contradicts {}", self.contradicts.join(", ")));
        }
        lines.push(match self.unique {
            true => {
                "no other change of as few numbers, as close to the print, was found".to_owned()
            }
            false => {
                "other changes of as few numbers, as close to the print, explain it too".to_owned()
            }
        });
        lines
    }
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
