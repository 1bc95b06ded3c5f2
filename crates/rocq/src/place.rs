//! What coefficients are of, and what equations determine: symbols, and members of families of numbers.

use crate::code::Code;
use crate::gap::Untranslatable;
use std::sync::Arc;

/// A symbol, or a member of a family.
#[derive(Debug, Clone)]
pub(crate) struct Place {
    /// The declared name of the symbol, or of the family.
    pub declared: Arc<str>,
    /// What stands for it.
    pub name: String,
    /// The indices of a member.
    pub indices: Vec<Code>,
}

impl Place {
    /// Whether this is a member of a family.
    pub fn is_member(&self) -> bool {
        !self.indices.is_empty()
    }

    /// The number that stands there: `p0`, or `P 2`.
    pub fn own(&self) -> Code {
        Code::apply(&self.name, &self.indices)
    }

    /// The indices as part of a name, if they are numbers.
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

    /// What stands for the declared name if the number is another one: the number itself for a symbol, and for a member this
    /// family with the number in its place.
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
