//! What a refuted claim should have said: plain data.

use serde::Serialize;
use torse_syntax::notation::Formula;

/// A corrected form of a refuted formula, itself proved.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Correction {
    /// The corrected statement.
    pub statement: Formula,
    /// The conditions under which it is true, as those of a verdict.
    pub conditions: Vec<Formula>,
    /// What was changed, in words, one entry an edit ("the factor 4 added", "k replaced by l").
    pub edits: Vec<String>,
    /// Whether no other repair with as few edits was found.
    pub unique: bool,
}

impl Correction {
    /// What was changed and under which conditions the statement is true then, a line each.
    #[must_use]
    pub fn in_words(&self) -> Vec<String> {
        let conditions = self.conditions.iter();
        let conditions = conditions.map(|condition| format!("true if `{}`", condition.text));
        self.edits.iter().cloned().chain(conditions).collect()
    }
}

/// A change of printed data that explains a printed value: the value is wrong for the data as printed and
/// right for the changed ones.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct DataCorrection {
    /// The changed data.
    pub changes: Vec<DataChange>,
    /// How the printed value agrees then, in words.
    pub steps: Vec<String>,
    /// Whether no other change of as few numbers, as near to the print, was found that explains as much.
    pub unique: bool,
    /// The ids of the refuted values of the same example that this change explains, this one included.
    pub explains: Vec<String>,
    /// The ids of the values of the same example that hold for the data as printed and no longer do.
    pub contradicts: Vec<String>,
    /// Whether all refuted values of the example are explained, and none contradicted.
    pub explains_example: bool,
}

impl DataCorrection {
    /// What to change and what it explains, a line each.
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
            true => "no other change of as few numbers, as near to the print, was found".to_owned(),
            false => {
                "other changes of as few numbers, as near to the print, explain it too".to_owned()
            }
        });
        lines
    }
}

/// One datum as printed and as it should read.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct DataChange {
    /// The name of the datum.
    pub name: String,
    /// As printed.
    pub old: Formula,
    /// As it should read.
    pub new: Formula,
}
