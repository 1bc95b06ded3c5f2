//! What is edited: the printed side of the equation that fails, or the definition that it calls.
//!
//! Most statements have the printed formula on the right. Where a formula is needed more than once, a
//! derivation file gives it a name that begins with `printed`, and a side that is this name, or a call
//! of it, stands for the body: the body is edited, and every call of it in the statement with it.

use super::edit::placed;
use std::collections::BTreeMap;
use torse_language::derivation::{Claim, Written};
use torse_language::syntax::{Connective, Expr, Node, Relation};
use torse_prove::decide_statement;

/// How names of definitions that hold a printed formula begin.
const PRINTED: &str = "printed";

/// A formula to edit, and its place in the statement.
#[derive(Debug, Clone)]
pub struct Subject {
    /// The way to the side of the comparison that fails.
    pub path: Vec<usize>,
    /// The formula to edit.
    pub formula: Expr,
    /// The call that stands for it, if it is the body of a definition.
    definition: Option<Unfolded>,
}

#[derive(Debug, Clone)]
struct Unfolded {
    name: String,
    parameters: Vec<String>,
    /// The side as it stands.
    call: Expr,
}

impl Subject {
    /// The printed side of the first equality of the statement that does not hold.
    #[must_use]
    pub fn of(claim: &Claim, statement: &Written) -> Option<Self> {
        let mut path = vec![];
        let mut expr = &statement.expr;
        while let Node::Join(Connective::And, a, b) = &expr.node {
            let part = Written {
                expr: (**a).clone(),
                origin: statement.origin.clone(),
            };
            let first_fails = decide_statement(claim, &part).is_ok_and(|d| d.is_refuted());
            path.push(usize::from(!first_fails));
            expr = if first_fails { a } else { b };
        }
        let Node::Compare(left, rest) = &expr.node else {
            return None;
        };
        let [(Relation::Equal, right)] = rest.as_slice() else {
            return None;
        };
        for (position, side) in [(1, right), (0, &**left)] {
            if let Some((definition, body)) = unfolded(claim, side) {
                path.push(position);
                return Some(Self {
                    path,
                    formula: body,
                    definition: Some(definition),
                });
            }
        }
        path.push(1);
        Some(Self {
            path,
            formula: right.clone(),
            definition: None,
        })
    }

    /// Whether a definition of this name holds a printed formula.
    #[must_use]
    pub fn is_printed(name: &str) -> bool {
        name.starts_with(PRINTED)
    }

    /// The side with the formula edited.
    #[must_use]
    pub fn side(&self, edited: &Expr) -> Expr {
        match &self.definition {
            None => edited.clone(),
            Some(definition) => definition.folded_out(&definition.call, edited),
        }
    }

    /// The statement with the formula edited.
    #[must_use]
    pub fn statement(&self, statement: &Expr, edited: &Expr) -> Expr {
        match &self.definition {
            None => placed(statement, &self.path, edited.clone()),
            Some(definition) => definition.folded_out(statement, edited),
        }
    }

    /// The name of the definition that is edited, as the statement calls it.
    #[must_use]
    pub fn defined_as(&self) -> Option<&str> {
        self.definition.as_ref().map(|d| d.name.as_str())
    }
}

/// The definition of a printed formula that a side calls, with its body.
fn unfolded(claim: &Claim, side: &Expr) -> Option<(Unfolded, Expr)> {
    let (name, arguments) = called(side)?;
    let definition = claim.declarations.definition(name)?;
    let body = &definition.body.expr;
    if !Subject::is_printed(name) || definition.parameters.len() != arguments.len() {
        return None;
    }
    // An argument must not be caught by an index that the body sums over.
    let mut pairs = definition.parameters.iter().zip(arguments);
    let free = pairs.all(|(parameter, argument)| {
        let own = matches!(&argument.node, Node::Name(name) if name == parameter);
        own || !argument.names().iter().any(|n| body.names().contains(n))
    });
    let unfolded = Unfolded {
        name: name.to_owned(),
        parameters: definition.parameters.clone(),
        call: side.clone(),
    };
    free.then(|| (unfolded, body.clone()))
}

/// The name that a formula is, or that it calls with arguments.
fn called(expr: &Expr) -> Option<(&str, &[Expr])> {
    match &expr.node {
        Node::Name(name) => Some((name, &[])),
        Node::Call(head, arguments) => match &head.node {
            Node::Name(name) => Some((name, arguments)),
            _ => None,
        },
        _ => None,
    }
}

impl Unfolded {
    /// The formula with every call of the definition replaced by a body.
    fn folded_out(&self, expr: &Expr, body: &Expr) -> Expr {
        if let Some((name, arguments)) = called(expr)
            && name == self.name
            && arguments.len() == self.parameters.len()
        {
            let names = self.parameters.iter().map(String::as_str);
            return substituted(body, &names.zip(arguments).collect());
        }
        let mut result = expr.clone();
        for part in result.parts_mut() {
            *part = self.folded_out(part, body);
        }
        result
    }
}

fn substituted(expr: &Expr, values: &BTreeMap<&str, &Expr>) -> Expr {
    if let Node::Name(name) = &expr.node {
        return values
            .get(name.as_str())
            .map_or_else(|| expr.clone(), |e| (*e).clone());
    }
    let mut result = expr.clone();
    for part in result.parts_mut() {
        *part = substituted(part, values);
    }
    result
}
