//! Places: the symbols, and members of families of numbers, that coefficients and given equations are about.

use crate::code::Code;
use crate::gap::Untranslatable;
use std::sync::Arc;

/// A symbol, or a member of a family.
#[derive(Debug, Clone)]
pub(crate) struct Place {
    /// The declared name of the symbol, or of the family.
    pub declared: Arc<str>,
    /// Its Rocq term.
    pub name: String,
    /// The indices of a member.
    pub indices: Vec<Code>,
}

impl Place {
    /// Whether this is a member of a family.
    pub fn is_member(&self) -> bool {
        !self.indices.is_empty()
    }

    /// Returns its number: `p0`, or `P 2`.
    pub fn own(&self) -> Code {
        Code::apply(&self.name, &self.indices)
    }

    /// Returns the indices as part of a name, if they are numbers.
    pub fn label(&self) -> Option<String> {
        let texts = self
            .indices
            .iter()
            .map(|index| index.text().strip_suffix("%Z"));
        let digits = |text: &&str| text.bytes().all(|byte| byte.is_ascii_digit());
        let labels: Option<Vec<&str>> = texts.map(|text| text.filter(digits)).collect();
        labels
            .filter(|labels| !labels.is_empty())
            .map(|labels| labels.join("_"))
    }

    /// Returns what the declared name stands for if the number is replaced: the new number itself for a symbol; for a
    /// member, the family with the new number in its place.
    ///
    /// # Errors
    /// [`Untranslatable`] for members with more than two indices.
    pub fn with(&self, family: &str, value: &Code) -> Result<Code, Untranslatable> {
        let update = match self.indices.len() {
            0 => return Ok(value.clone()),
            1 => "update1",
            2 => "update2",
            _ => {
                return Err(Untranslatable::Construct(
                    "`coefficients` of members with many indices",
                ));
            }
        };
        let mut arguments = vec![Code::atom(family)];
        arguments.extend(self.indices.iter().cloned());
        arguments.push(value.clone());
        Ok(Code::apply(update, &arguments))
    }
}
