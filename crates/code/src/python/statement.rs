//! Statements of Python.

use super::expression::Reader;
use crate::grammar::{CodeNode, Read, children, place};
use crate::program::{Assignment, Step, Target, call, operation};
use std::sync::Arc;
use torse_syntax::formula::{Expr, Node};

/// What is read, for messages.
const READ: &str = "assignments, `return`, `for` over a range or a list, and `if` are read";

impl Reader<'_> {
    /// Reads the statements of a block.
    pub(super) fn steps(self, block: CodeNode<'_>) -> Read<Vec<Step>> {
        let mut steps = vec![];
        for node in children(block) {
            steps.extend(self.step(node)?);
        }
        Ok(steps)
    }

    /// Reads one statement: none for what computes nothing.
    pub(super) fn step(self, node: CodeNode<'_>) -> Read<Vec<Step>> {
        match node.kind() {
            "pass_statement" => Ok(vec![]),
            "assert_statement" => {
                let condition = children(node).first().copied();
                Ok(vec![Step::Assert {
                    condition: condition.and_then(|node| self.expression(node).ok()),
                    place: place(node),
                }])
            }
            "import_statement" | "import_from_statement" => {
                let message = "names are imported outside of functions";
                Err(self
                    .text
                    .refused(node, message, "move it to the top of the file"))
            }
            "raise_statement" => Ok(vec![Step::Stop(place(node))]),
            "return_statement" => match children(node).as_slice() {
                [value] => Ok(vec![Step::Return(self.expression(*value)?)]),
                _ => Err(self
                    .text
                    .refused(node, "this returns nothing", "return a value")),
            },
            "expression_statement" => match children(node).as_slice() {
                [inner] => self.effect(*inner),
                _ => Err(self.no_statement(node)),
            },
            "for_statement" => {
                if let Some(other) = node.child_by_field_name("alternative") {
                    let message = "`else` after a loop is not read";
                    return Err(self.text.refused(other, message, "write it after the loop"));
                }
                Ok(vec![Step::Repeat {
                    variable: self.target(self.text.field(node, "left")?)?,
                    values: self.expression(self.text.field(node, "right")?)?,
                    body: self.steps(self.text.field(node, "body")?)?,
                }])
            }
            "if_statement" => {
                let mut cursor = node.walk();
                let others: Vec<_> = node
                    .children_by_field_name("alternative", &mut cursor)
                    .collect();
                Ok(vec![self.branch(node, &others)?])
            }
            "while_statement" => {
                let message = "`while` is not read: its end depends on values";
                let help = "loops over constants are read: `for i in range(n)`";
                Err(self.text.refused(node, message, help))
            }
            _ => Err(self.no_statement(node)),
        }
    }

    fn no_statement(self, node: CodeNode<'_>) -> Box<torse_syntax::derivation::DerivationError> {
        let kind = node.kind().replace('_', " ");
        self.text
            .refused(node, format!("this is not read: {kind}"), READ)
    }

    /// A branch with what follows it.
    fn branch(self, node: CodeNode<'_>, others: &[CodeNode<'_>]) -> Read<Step> {
        let otherwise = match others {
            [] => vec![],
            [last, ..] if last.kind() == "else_clause" => {
                self.steps(self.text.field(*last, "body")?)?
            }
            [first, rest @ ..] => vec![self.branch(*first, rest)?],
        };
        Ok(Step::Branch {
            condition: self.expression(self.text.field(node, "condition")?)?,
            then: self.steps(self.text.field(node, "consequence")?)?,
            otherwise,
        })
    }

    /// A statement that is an expression: an assignment, a note, or a list that grows.
    fn effect(self, node: CodeNode<'_>) -> Read<Vec<Step>> {
        match node.kind() {
            "string" | "concatenated_string" | "ellipsis" => Ok(vec![]),
            "assignment" => {
                let Some(right) = node.child_by_field_name("right") else {
                    return Ok(vec![]);
                };
                if right.kind() == "assignment" {
                    let message = "two assignments in one are not read";
                    return Err(self.text.refused(right, message, "write one a line"));
                }
                Ok(vec![Step::Assign {
                    target: self.target(self.text.field(node, "left")?)?,
                    value: self.expression(right)?,
                    how: Assignment::Set,
                }])
            }
            "augmented_assignment" => {
                let left = self.text.field(node, "left")?;
                let sign = self.text.field(node, "operator")?;
                let operator = self.text.text(sign).trim_end_matches('=');
                let right = self.expression(self.text.field(node, "right")?)?;
                let old = self.expression(left)?;
                Ok(vec![Step::Assign {
                    target: self.target(left)?,
                    value: self.combined(node, sign, operator, old, right)?,
                    how: Assignment::InPlace,
                }])
            }
            "call" => self.append(node),
            _ => {
                let message = "this computes something that is not used";
                Err(self.text.refused(node, message, READ))
            }
        }
    }

    /// `list.append(value)`.
    fn append(self, node: CodeNode<'_>) -> Read<Vec<Step>> {
        let function = self.text.field(node, "function")?;
        let is_append = function.kind() == "attribute"
            && self.text.text(self.text.field(function, "attribute")?) == "append";
        let arguments = children(self.text.field(node, "arguments")?);
        let ([value], true) = (arguments.as_slice(), is_append) else {
            let message = "this call does something other than to compute a value";
            return Err(self.text.refused(node, message, READ));
        };
        let list = self.text.field(function, "object")?;
        let old = self.expression(list)?;
        let grown = vec![old, self.expression(*value)?];
        let value = call(operation::APPEND, grown, place(node));
        Ok(vec![Step::Assign {
            target: self.target(list)?,
            value,
            how: Assignment::InPlace,
        }])
    }

    fn target(self, node: CodeNode<'_>) -> Read<Target> {
        match node.kind() {
            "identifier" => Ok(Target::Name(self.text.name(node)?.to_owned(), place(node))),
            "pattern_list" | "tuple_pattern" | "list_pattern" | "tuple" => {
                let all = children(node).into_iter().map(|one| self.target(one));
                Ok(Target::Several(all.collect::<Read<_>>()?, place(node)))
            }
            "subscript" => {
                let mut entry = self.expression(node)?;
                let mut indices = vec![];
                while let Node::Index(head, own) = entry.node {
                    // Several in one pair of brackets are one index.
                    let place = entry.place;
                    let one = match <[Expr; 1]>::try_from(own) {
                        Ok([one]) => one,
                        Err(several) => Expr {
                            node: Node::List(several),
                            place,
                        },
                    };
                    indices.insert(0, one);
                    entry = Arc::unwrap_or_clone(head);
                }
                match entry.node {
                    Node::Name(name) => Ok(Target::Entry(name, indices, place(node))),
                    _ => Err(self.no_statement(node)),
                }
            }
            _ => {
                let message = "this cannot be assigned to here";
                let help = "names and entries of lists are assigned to";
                Err(self.text.refused(node, message, help))
            }
        }
    }
}

/// The names that an assignment outside of functions gives a value, with their values.
pub(super) fn constants(steps: &[Step]) -> Vec<(String, Expr)> {
    let mut found = vec![];
    for step in steps {
        let Step::Assign {
            target,
            value,
            how: Assignment::Set,
        } = step
        else {
            continue;
        };
        match (target, &value.node) {
            (Target::Name(name, _), _) => found.push((name.clone(), value.clone())),
            (Target::Several(targets, _), Node::List(values)) if targets.len() == values.len() => {
                for (target, value) in targets.iter().zip(values) {
                    if let Target::Name(name, _) = target {
                        found.push((name.clone(), value.clone()));
                    }
                }
            }
            _ => {}
        }
    }
    found
}
