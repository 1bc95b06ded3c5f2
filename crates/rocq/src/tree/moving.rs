//! Symbols whose coefficients are asked for, and the unknowns that move with them.

use super::scope::Scope;
use crate::code::Code;
use crate::gap::Gap;

/// A symbol, or a member of a family.
#[derive(Debug, Clone)]
pub(super) struct Place {
    /// The declared name of the symbol, or of the family.
    pub declared: String,
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

    /// What stands for the declared name if the number is another one.
    ///
    /// # Errors
    /// [`Gap`] for members with more than two indices.
    pub fn with(&self, family: &str, value: &Code) -> Result<Code, Gap> {
        let update = match self.indices.len() {
            0 => return Ok(value.clone()),
            1 => "update1",
            2 => "update2",
            _ => {
                return Err(Gap::Construct(
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

/// The unknowns as functions of one symbol.
#[derive(Debug, Clone)]
pub(super) struct Along {
    /// The symbol.
    pub place: Place,
    /// The variable that it is where it moves.
    pub variable: String,
    /// The functions: their names, and the unknowns.
    pub functions: Vec<(String, Place)>,
    /// What stands for declared names where the symbol moves.
    pub moved: Vec<(String, Code)>,
}

impl Along {
    /// A scope in which the symbol moves.
    pub fn scope(&self, scope: &Scope) -> Scope {
        let moved = self.moved.iter();
        moved.fold(scope.clone(), |scope, (name, code)| {
            scope.with_moved(name, code.clone())
        })
    }
}
