//! Statements of Rust.

use super::expression::Reader;
use crate::grammar::{CodeNode, Read, Text, children, place, tree};
use crate::program::{Assignment, CodeLanguage, Step, Target, call, operation};
use std::sync::Arc;
use torse_syntax::derivation::Source;
use torse_syntax::formula::{Expr, Node};

/// What is read, for messages.
const READ: &str = "`let`, assignments, `return`, `for` over a range or a list, `if`, and the last value of the function are read";

impl Reader<'_> {
    /// Reads a block. With `is_value` its last expression is the value of the function.
    pub(super) fn steps(self, block: CodeNode<'_>, is_value: Ending) -> Read<Vec<Step>> {
        let nodes = children(block);
        let mut steps = vec![];
        for (position, node) in nodes.iter().enumerate() {
            let is_last = position + 1 == nodes.len();
            let ending = if is_last { is_value } else { Ending::Statement };
            steps.extend(self.step(*node, ending)?);
        }
        Ok(steps)
    }

    fn step(self, node: CodeNode<'_>, ending: Ending) -> Read<Vec<Step>> {
        match node.kind() {
            // Those that may leave something out are refused for the whole function.
            "empty_statement" | "attribute_item" | "inner_attribute_item" => Ok(vec![]),
            "use_declaration" => {
                let message = "names are imported outside of functions";
                let help = "move it to the top of the file";
                Err(self.text.refused(node, message, help))
            }
            "expression_statement" => {
                let inner = children(node);
                let [inner] = inner.as_slice() else {
                    return Err(self.unread(node));
                };
                let ends = self.text.text(node).ends_with(';');
                self.step(*inner, if ends { Ending::Statement } else { ending })
            }
            "let_declaration" => {
                if let Some(other) = node.child_by_field_name("alternative") {
                    return Err(self.text.refused(other, "`let ... else` is not read", READ));
                }
                let pattern = self.pattern(self.text.field(node, "pattern")?)?;
                let value = self.expression(self.text.field(node, "value")?)?;
                let declared = node.child_by_field_name("type");
                let declared = declared.and_then(|kind| self.aliases.number(self.text, kind));
                // What `into` makes has the declared type.
                let value = match declared.as_deref() {
                    Some("f64" | "f32") => {
                        let place = value.place;
                        call(operation::FLOAT, vec![value], place)
                    }
                    _ => value,
                };
                Ok(vec![Step::Assign {
                    target: target(pattern).ok_or_else(|| self.unread(node))?,
                    value,
                    how: Assignment::Declare,
                }])
            }
            "assignment_expression" => {
                let left = self.text.field(node, "left")?;
                Ok(vec![Step::Assign {
                    target: self.target(left)?,
                    value: self.expression(self.text.field(node, "right")?)?,
                    how: Assignment::Set,
                }])
            }
            "compound_assignment_expr" => {
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
            "return_expression" => match children(node).as_slice() {
                [value] => Ok(vec![Step::Return(self.expression(*value)?)]),
                _ => Err(self
                    .text
                    .refused(node, "this returns nothing", "return a value")),
            },
            "for_expression" => {
                let pattern = self.pattern(self.text.field(node, "pattern")?)?;
                Ok(vec![Step::Repeat {
                    variable: target(pattern).ok_or_else(|| self.unread(node))?,
                    values: self.expression(self.text.field(node, "value")?)?,
                    body: self.steps(self.text.field(node, "body")?, Ending::Statement)?,
                }])
            }
            "if_expression" => Ok(vec![self.branch(node, ending)?]),
            "while_expression" | "loop_expression" => {
                let message = "`while` and `loop` are not read: their end depends on values";
                let help = "loops over constants are read: `for i in 0..n`";
                Err(self.text.refused(node, message, help))
            }
            "macro_invocation" => {
                let name = self.text.text(self.text.field(node, "macro")?);
                if !self.names.is_macro(name) {
                    let message = format!("`{name}!` may have another meaning in this file");
                    let help = "give each thing of the file a name of its own";
                    return Err(self.text.refused(node, message, help));
                }
                match name {
                    "assert" | "assert_eq" | "assert_ne" => Ok(vec![Step::Assert {
                        condition: self.asserted(node, name),
                        place: place(node),
                    }]),
                    // It stands in some builds and not in others, so nothing rests on it.
                    "debug_assert" | "debug_assert_eq" | "debug_assert_ne" => {
                        Ok(vec![Step::Assert {
                            condition: None,
                            place: place(node),
                        }])
                    }
                    "panic" | "unreachable" | "todo" | "unimplemented" => {
                        Ok(vec![Step::Stop(place(node))])
                    }
                    _ => Ok(vec![Step::Return(self.expression(node)?)]),
                }
            }
            "call_expression" if matches!(ending, Ending::Statement) => self.push(node),
            _ if matches!(ending, Ending::Value) => Ok(vec![Step::Return(self.expression(node)?)]),
            _ => {
                let message = "this computes something that is not used";
                Err(self.text.refused(node, message, READ))
            }
        }
    }

    /// What a macro asserts; none where that is not read. The arguments of a macro are a text for the parser, which is read again
    /// as an expression.
    fn asserted(self, node: CodeNode<'_>, name: &str) -> Option<Expr> {
        let mut tokens = children(node).into_iter();
        let tokens = tokens.rfind(|part| part.kind() == "token_tree")?;
        let inside = self.text.text(tokens);
        let inside = inside.get(1..inside.len().checked_sub(1)?)?;
        let mut depth = 0_usize;
        let arguments = inside.split(|sign: char| {
            match sign {
                '(' | '[' | '{' => depth += 1,
                ')' | ']' | '}' => depth = depth.saturating_sub(1),
                _ => {}
            }
            sign == ',' && depth == 0
        });
        let arguments: Vec<&str> = arguments.take(2).collect();
        let condition = match (name, arguments.as_slice()) {
            ("assert", [condition, ..]) => format!("({condition})"),
            ("assert_eq", [left, right]) => format!("({left}) == ({right})"),
            ("assert_ne", [left, right]) => format!("({left}) != ({right})"),
            _ => return None,
        };
        let source = Arc::new(Source::new(
            &self.text.source.name,
            format!("fn asserted() -> bool {{ {condition} }}"),
        ));
        let tree = tree(&source, CodeLanguage::Rust).ok()?;
        let reader = Reader {
            text: Text { source: &source },
            ..self
        };
        let function = *children(tree.root_node()).first()?;
        reader.text.check(function).ok()?;
        let body = reader.text.field(function, "body").ok()?;
        let mut condition = *children(body).first()?;
        if condition.kind() == "expression_statement" {
            condition = *children(condition).first()?;
        }
        reader.expression(condition).ok()
    }

    fn branch(self, node: CodeNode<'_>, ending: Ending) -> Read<Step> {
        let otherwise = match node.child_by_field_name("alternative") {
            None => vec![],
            Some(other) => match children(other).as_slice() {
                [next] if next.kind() == "if_expression" => vec![self.branch(*next, ending)?],
                [block] => self.steps(*block, ending)?,
                _ => return Err(self.unread(other)),
            },
        };
        Ok(Step::Branch {
            condition: self.expression(self.text.field(node, "condition")?)?,
            then: self.steps(self.text.field(node, "consequence")?, ending)?,
            otherwise,
        })
    }

    /// `list.push(value)`.
    fn push(self, node: CodeNode<'_>) -> Read<Vec<Step>> {
        let function = self.text.field(node, "function")?;
        let is_push = function.kind() == "field_expression"
            && self.text.text(self.text.field(function, "field")?) == "push";
        let arguments = children(self.text.field(node, "arguments")?);
        let ([value], true) = (arguments.as_slice(), is_push) else {
            let message = "this call does something other than to compute a value";
            return Err(self.text.refused(node, message, READ));
        };
        let list = self.text.field(function, "value")?;
        let grown = vec![self.expression(list)?, self.expression(*value)?];
        let value = call(operation::APPEND, grown, place(node));
        Ok(vec![Step::Assign {
            target: self.target(list)?,
            value,
            how: Assignment::InPlace,
        }])
    }

    fn target(self, node: CodeNode<'_>) -> Read<Target> {
        let read = match node.kind() {
            "unary_expression" | "identifier" | "index_expression" | "tuple_expression" => {
                target(self.expression(node)?)
            }
            _ => None,
        };
        read.ok_or_else(|| {
            let help = "names and entries of lists are assigned to";
            self.text
                .refused(node, "this cannot be assigned to here", help)
        })
    }
}

/// What the last expression of a block is.
#[derive(Debug, Clone, Copy)]
pub(super) enum Ending {
    /// The value of the function.
    Value,
    /// Nothing: the function goes on.
    Statement,
}

/// What a formula names, as something to assign to.
fn target(expr: Expr) -> Option<Target> {
    match expr.node {
        Node::Name(name) => Some(Target::Name(name, expr.place)),
        Node::List(items) => {
            let all = items.into_iter().map(target).collect::<Option<_>>()?;
            Some(Target::Several(all, expr.place))
        }
        Node::Index(head, mut indices) => {
            let mut head = Arc::unwrap_or_clone(head);
            while let Node::Index(inner, own) = head.node {
                indices.splice(0..0, own);
                head = Arc::unwrap_or_clone(inner);
            }
            match head.node {
                Node::Name(name) => Some(Target::Entry(name, indices, expr.place)),
                _ => None,
            }
        }
        _ => None,
    }
}
