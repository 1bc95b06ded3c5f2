//! Evaluates both readings of a text at one assignment, and finds the smallest part in which they differ.

use super::outline::CoreOutline;
use super::terms::Terms;
use torse_core::{Node, Term};
use torse_semantics::tree::{Compared, Piece, TreeOutline};
use torse_semantics::{Class, NoValue, Unknown, Value};
use torse_syntax::derivation::Claim;
use torse_syntax::formula::{self, Expr};
use torse_syntax::notation;

/// A part without a value in one of the readings.
#[derive(Debug, Clone)]
pub(super) struct Missing {
    /// The reading, and the reason.
    pub why: String,
    /// Whether the other reading has a value and no limit of this comparison is the reason.
    pub is_one_sided: bool,
}

impl Missing {
    fn new(reading: &str, gap: &NoValue, other_has_value: bool) -> Self {
        let is_fact = matches!(
            gap,
            NoValue::Undefined(_) | NoValue::Unknown(Unknown::NoValue { .. })
        );
        Self {
            why: format!("{reading} {gap}"),
            is_one_sided: other_has_value && is_fact,
        }
    }
}

/// Both readings at one assignment.
#[derive(Clone, Copy)]
pub(super) struct Both<'a, 's, 'e> {
    pub trees: &'a Compared<'s, 'e>,
    pub evaluator: &'a Terms<'a>,
    pub claim: &'s Claim,
}

impl<'s> Both<'_, 's, '_> {
    /// Compares two outlines: returns a part without a value in one of them, if any; fails where they differ.
    pub fn compared(
        &self,
        text: &TreeOutline<'s>,
        own: &CoreOutline<'_>,
    ) -> Result<Option<Missing>, String> {
        let mut open = None;
        let mut relation = String::new();
        if text.len() != own.len() {
            return Err("core terms state something else than the text".to_owned());
        }
        for pair in text.iter().zip(own) {
            match pair {
                (Piece::Word(word), Piece::Word(other)) if word == other => {
                    relation.clone_from(word);
                }
                (Piece::Value(tree, text), Piece::Value(term, own)) => match self.same(text, own) {
                    Ok(found) => open = open.or(found),
                    Err(()) => {
                        let least = match (tree, term) {
                            (Some(tree), Some(term)) => Some(self.smallest(tree, term)),
                            _ => None,
                        };
                        let what = least.unwrap_or_else(|| format!("a side of `{relation}`"));
                        return Err(format!(
                            "{what} has another value as a core term than in the text"
                        ));
                    }
                },
                _ => return Err("core terms state something else than the text".to_owned()),
            }
        }
        Ok(open)
    }

    /// Compares two values: returns why they cannot be compared, or an error if they differ.
    pub fn same(
        &self,
        text: &Result<Value<Class>, NoValue>,
        own: &Result<Value<Class>, NoValue>,
    ) -> Result<Option<Missing>, ()> {
        match (text, own) {
            (Ok(text), Ok(own)) if are_same(text, own) => Ok(None),
            (Ok(_), Ok(_)) => Err(()),
            (Err(gap), own) => Ok(Some(Missing::new("in the text", gap, own.is_ok()))),
            (_, Err(gap)) => Ok(Some(Missing::new("as a core term", gap, true))),
        }
    }

    /// Returns the smallest part with two values that depends on no variable of a binder.
    fn smallest(&self, tree: &'s Expr, term: &Term) -> String {
        let mut within = None;
        let (mut tree, mut term) = (tree, term.clone());
        loop {
            let parts: Vec<Term> = term.parts().into_iter().cloned().collect();
            let opened = match (&*term.node, &tree.node) {
                (
                    Node::Opened {
                        closed: true, name, ..
                    },
                    formula::Node::Name(own),
                ) if **name == **own => self.claim.declarations.definition(name),
                _ => None,
            };
            if let (Some(definition), [body]) = (opened, parts.as_slice()) {
                within = Some(tree_name(tree));
                (tree, term) = (&definition.body.expr, body.clone());
                continue;
            }
            let next = parts.into_iter().find_map(|part| {
                let tree = tree
                    .parts()
                    .into_iter()
                    .find(|tree| tree.place == part.place)?;
                let differ = part.is_closed()
                    && self
                        .same(&self.trees.value(tree), &self.evaluator.value(&part))
                        .is_err();
                differ.then_some((tree, part))
            });
            match next {
                Some(next) => (tree, term) = next,
                None => break,
            }
        }
        let text = notation::text(tree);
        match within {
            None => format!("`{text}`"),
            Some(name) => format!("`{text}` in `{name}`"),
        }
    }
}

fn tree_name(tree: &Expr) -> &str {
    match &tree.node {
        formula::Node::Name(name) => name,
        _ => "",
    }
}

/// Whether all entries are equal; 0 equals an empty sum of any shape.
pub(crate) fn are_same(text: &Value<Class>, own: &Value<Class>) -> bool {
    let shapes = |value: &Value<Class>| value.numbers().len();
    let zero = |value: &Value<Class>| value.numbers().iter().all(|x| x.all(&|x| x.is_zero()));
    (text == own) || (zero(text) && zero(own) && (shapes(text) == 1 || shapes(own) == 1))
}
