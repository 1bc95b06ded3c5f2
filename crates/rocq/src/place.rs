//! What coefficients are of, and what equations determine: symbols, and members of families of numbers.

use crate::code::Code;
use crate::context::Context;
use crate::gap::Gap;
use std::sync::Arc;
use torse_core::{Node, Term};

/// A symbol, or a member of a family.
#[derive(Debug, Clone)]
pub(crate) struct Place {
    /// The declared name of the symbol, or of the family.
    pub declared: Arc<str>,
    /// Its name.
    pub name: String,
    /// The indices of a member.
    indices: Vec<Code>,
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

/// The declared name of a symbol or a member.
pub(crate) fn declared(symbol: &Term) -> Result<&Arc<str>, Gap> {
    match &*symbol.node {
        Node::Symbol(name) | Node::Vector(name, None) => Ok(name),
        Node::Member(points, _) => Ok(&points.name),
        Node::Opened { body, .. } => declared(body),
        _ => Err(Gap::Construct("`coefficients` of what is no symbol")),
    }
}

impl Context<'_> {
    /// The place that a term names.
    ///
    /// # Errors
    /// [`Gap`] for vectors and their coordinates, and for members that are vectors.
    pub(crate) fn place(&mut self, symbol: &Term) -> Result<Place, Gap> {
        if let Node::Opened { body, .. } = &*symbol.node {
            return self.place(body);
        }
        let name = declared(symbol)?;
        let indices = match &*symbol.node {
            Node::Member(points, indices) => {
                if points.dimension.is_some_and(|dimension| dimension > 1) {
                    return Err(Gap::Construct("`coefficients` of members that are vectors"));
                }
                let codes = indices.iter().map(|index| self.index(index));
                codes.collect::<Result<Vec<_>, _>>()?
            }
            _ => vec![],
        };
        Ok(Place {
            declared: Arc::clone(name),
            name: self.symbol(name)?.to_owned(),
            indices,
        })
    }
}
