//! Chooses what to edit: the printed side of the equation that fails, or the definition that it calls.
//!
//! Most statements have the printed formula on the right. If a formula is needed more than once, a derivation file
//! gives it a name that begins with `printed`. A side that is this name, or a call of it, stands for the body: the body
//! is edited, and every call of it in the statement with it.

use super::edit::placed;
use std::collections::{BTreeMap, BTreeSet};
use torse_prove::decide_statement;
use torse_syntax::derivation::{Claim, Written};
use torse_syntax::formula::{Connective, Expr, Node, Relation};

/// Prefix of the names of definitions that hold a printed formula.
const PRINTED: &str = "printed";
/// Maximum number of definitions in which a slip is searched for.
const MAX_DEFINITIONS: usize = 6;

/// A formula to edit, and its place in the statement.
#[derive(Debug, Clone)]
pub struct Subject {
    /// The path to the side of the comparison that fails.
    pub path: Vec<usize>,
    /// The formula to edit.
    pub formula: Expr,
    /// The call that stands for it, if it is the body of a definition with the printed formula.
    definition: Option<Unfolded>,
    /// The definitions that lead from the printed side to the formula, outermost first.
    within: Vec<Unfolded>,
}

#[derive(Debug, Clone)]
struct Unfolded {
    name: String,
    parameters: Vec<String>,
    /// The formula that calls it.
    call: Expr,
}

impl Subject {
    /// Returns the printed side of the first equality of the statement that does not hold.
    #[must_use]
    pub fn from_claim(claim: &Claim, statement: &Written) -> Option<Self> {
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
                    within: vec![],
                });
            }
        }
        path.push(1);
        Some(Self {
            path,
            formula: right.clone(),
            definition: None,
            within: vec![],
        })
    }

    /// A side of a statement as it stands there.
    #[must_use]
    pub fn plain(statement: &Expr, path: &[usize]) -> Option<Self> {
        let formula = path.iter().try_fold(statement, |e, position| {
            e.parts().into_iter().nth(*position)
        })?;
        Some(Self {
            formula: formula.clone(),
            path: path.to_vec(),
            definition: None,
            within: vec![],
        })
    }

    /// The other side of the comparison, where both stand in the statement as they are.
    #[must_use]
    pub fn across(&self, statement: &Expr) -> Option<Self> {
        if self.definition.is_some() || !self.within.is_empty() {
            return None;
        }
        let (last, parent) = self.path.split_last()?;
        Self::plain(statement, &[parent, &[1 - (*last).min(1)]].concat())
    }

    /// Returns the definitions that only this formula uses: one of them may contain the slip.
    #[must_use]
    pub fn definitions(&self, claim: &Claim, statement: &Written) -> Vec<Self> {
        let other = placed(&statement.expr, &self.path, Expr::name(""));
        let mut elsewhere = BTreeSet::new();
        let hypotheses = claim.given.iter().chain(&claim.assumptions);
        let all = std::iter::once(&other).chain(hypotheses.map(|h| &h.formula.expr));
        let folded = self.definition.as_ref().map(|d| d.name.as_str());
        for expr in all {
            reach(claim, expr, folded, &mut elsewhere);
        }
        let mut found: Vec<Self> = vec![];
        let mut pending = vec![self.clone()];
        while let Some(outer) = pending.pop() {
            let mut names = outer.formula.names();
            names.sort_unstable();
            names.dedup();
            for name in names {
                let known = found.iter().any(|s| s.defined_as() == Some(name));
                if known || elsewhere.contains(name) || found.len() >= MAX_DEFINITIONS {
                    continue;
                }
                if let Some(inner) = outer.inner(claim, name) {
                    found.push(inner.clone());
                    pending.push(inner);
                }
            }
        }
        found
    }

    /// The body of a definition that the formula calls.
    fn inner(&self, claim: &Claim, name: &str) -> Option<Self> {
        let definition = claim.declarations.definition(name)?;
        let body = &definition.body.expr;
        let calls = calls(&self.formula, name);
        let fits = |arguments: &[Expr]| {
            arguments.len() == definition.parameters.len()
                && free(&definition.parameters, arguments, body)
        };
        // A derivative of the definition would not change.
        let derived = self.formula.names().into_iter();
        let mut derived = derived.filter(|n| *n != name && n.trim_end_matches('\'') == name);
        if derived.next().is_some() || calls.is_empty() || !calls.into_iter().all(fits) {
            return None;
        }
        let mut inner = self.clone();
        inner.within.push(Unfolded {
            name: name.to_owned(),
            parameters: definition.parameters.clone(),
            call: self.formula.clone(),
        });
        inner.formula = body.clone();
        Some(inner)
    }

    /// Whether the printed formula stands on the left: every equality has a definition that holds one on the left, and
    /// none on the right.
    #[must_use]
    pub fn is_left(statement: &Expr) -> bool {
        let printed = |side: &Expr| called(side).is_some_and(|(name, _)| Self::is_printed(name));
        match &statement.node {
            Node::Join(Connective::And, a, b) => Self::is_left(a) && Self::is_left(b),
            Node::Compare(left, rest) => {
                printed(left) && !rest.iter().any(|(_, right)| printed(right))
            }
            _ => false,
        }
    }

    /// Whether a definition of this name holds a printed formula.
    #[must_use]
    pub fn is_printed(name: &str) -> bool {
        name.starts_with(PRINTED)
    }

    /// The side with the formula edited.
    #[must_use]
    pub fn side(&self, edited: &Expr) -> Expr {
        let edited = self.outermost(edited);
        match &self.definition {
            None => edited,
            Some(definition) => definition.folded_out(&definition.call, &edited),
        }
    }

    /// The printed formula with the definition edited.
    fn outermost(&self, edited: &Expr) -> Expr {
        let outwards = self.within.iter().rev();
        outwards.fold(edited.clone(), |body, definition| {
            definition.folded_out(&definition.call, &body)
        })
    }

    /// The statement with the formula edited.
    #[must_use]
    pub fn statement(&self, statement: &Expr, edited: &Expr) -> Expr {
        let edited = self.outermost(edited);
        match &self.definition {
            None => placed(statement, &self.path, edited),
            Some(definition) => definition.folded_out(statement, &edited),
        }
    }

    /// Returns the name of the definition that is edited, as it is called.
    #[must_use]
    pub fn defined_as(&self) -> Option<&str> {
        let innermost = self.within.last().or(self.definition.as_ref());
        innermost.map(|d| d.name.as_str())
    }
}

/// Returns the definition of a printed formula that a side calls, with its body.
fn unfolded(claim: &Claim, side: &Expr) -> Option<(Unfolded, Expr)> {
    let (name, arguments) = called(side)?;
    let definition = claim.declarations.definition(name)?;
    let body = &definition.body.expr;
    if !Subject::is_printed(name) || definition.parameters.len() != arguments.len() {
        return None;
    }
    let free = free(&definition.parameters, arguments, body);
    let unfolded = Unfolded {
        name: name.to_owned(),
        parameters: definition.parameters.clone(),
        call: side.clone(),
    };
    free.then(|| (unfolded, body.clone()))
}

/// Whether no argument is captured by an index that the body sums over.
fn free(parameters: &[String], arguments: &[Expr], body: &Expr) -> bool {
    parameters
        .iter()
        .zip(arguments)
        .all(|(parameter, argument)| {
            let own = matches!(&argument.node, Node::Name(name) if name == parameter);
            own || !argument.names().iter().any(|n| body.names().contains(n))
        })
}

/// The arguments of every call of a name in a formula.
fn calls<'e>(expr: &'e Expr, name: &str) -> Vec<&'e [Expr]> {
    if let Some((called, arguments)) = called(expr)
        && called == name
    {
        return vec![arguments];
    }
    let parts = expr.parts().into_iter();
    parts.flat_map(|part| calls(part, name)).collect()
}

/// Collects the definitions that a formula depends on, except one.
fn reach(claim: &Claim, expr: &Expr, without: Option<&str>, into: &mut BTreeSet<String>) {
    for name in expr.names() {
        let name = name.trim_end_matches('\'');
        if Some(name) == without || !into.insert(name.to_owned()) {
            continue;
        }
        if let Some(definition) = claim.declarations.definition(name) {
            reach(claim, &definition.body.expr, without, into);
        }
    }
}

/// Returns the name that a formula is, or that it calls with arguments.
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
    /// Replaces every call of the definition in the formula by a body.
    fn folded_out(&self, expr: &Expr, body: &Expr) -> Expr {
        if let Some((name, arguments)) = called(expr)
            && name == self.name
            && arguments.len() == self.parameters.len()
        {
            let names = self.parameters.iter().map(String::as_str);
            let values: BTreeMap<&str, &Expr> = names.zip(arguments).collect();
            let stay = |(name, value): (&&str, &&Expr)| matches!(&value.node, Node::Name(own) if own == name);
            return match values.iter().all(stay) {
                true => body.clone(),
                false => substituted(body, &values),
            };
        }
        expr.with_parts(|part| self.folded_out(part, body))
    }
}

fn substituted(expr: &Expr, values: &BTreeMap<&str, &Expr>) -> Expr {
    if let Node::Name(name) = &expr.node {
        return values
            .get(name.as_str())
            .map_or_else(|| expr.clone(), |e| (*e).clone());
    }
    expr.with_parts(|part| substituted(part, values))
}

#[cfg(test)]
mod tests {
    use super::*;
    use torse_syntax::formula::parse;

    #[test]
    fn the_print_is_on_the_left_where_its_definition_is() {
        let left = |text: &str| Subject::is_left(&parse(text).unwrap());
        assert!(left("printed(z, 1) == S(z)"));
        assert!(left("printed(z, 0) == F(z) and printed(z, 1) == G(z)"));
        assert!(!left("S(z) == printed(z)"));
        assert!(!left("T(z) == S(z)"));
    }
}
