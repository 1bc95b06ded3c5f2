//! Expressions of Rust.

use super::names::Names;
use super::types::Aliases;
use crate::grammar::{CodeNode, Read, Text, at, binary, children, place};
use crate::program::{call, operation};
use std::collections::BTreeSet;
use std::sync::Arc;
use torse_numbers::rational::integer;
use torse_syntax::derivation::DerivationError;
use torse_syntax::formula::{Connective, Expr, Node, Operator, Relation};

/// What reads the expressions of a file.
#[derive(Clone, Copy)]
pub(super) struct Reader<'s> {
    pub(super) text: Text<'s>,
    pub(super) names: &'s Names,
    /// The functions of the file.
    pub(super) functions: &'s BTreeSet<String>,
    /// The types that the file names.
    pub(super) aliases: &'s Aliases,
}

/// What is read, for messages.
pub(super) const READ: &str = "numbers, names, `+ - * /`, `powi`, the elementary functions of `f64`, calls of functions of this file, arrays, \
                    tuples, indices, comparisons, `if` and sums over ranges are read";

impl Reader<'_> {
    /// Reads an expression.
    pub(super) fn expression(self, node: CodeNode<'_>) -> Read<Expr> {
        match node.kind() {
            "identifier" => self.name(node),
            "integer_literal" | "float_literal" => self.literal(node),
            "boolean_literal" => {
                let is_true = self.text.text(node) == "true";
                let name = if is_true {
                    operation::TRUE
                } else {
                    operation::FALSE
                };
                Ok(at(node, Node::Name(name.to_owned())))
            }
            "parenthesized_expression" => self.only(node),
            "reference_expression" => {
                let value = self.text.field(node, "value")?;
                if children(node)
                    .iter()
                    .any(|part| part.kind() == "mutable_specifier")
                {
                    let message = "a reference through which something is changed is not read";
                    return Err(self.text.refused(node, message, "return the new value"));
                }
                self.expression(value)
            }
            "unary_expression" => self.unary(node),
            "binary_expression" => {
                let sign = self.text.field(node, "operator")?;
                let left = self.expression(self.text.field(node, "left")?)?;
                let right = self.expression(self.text.field(node, "right")?)?;
                self.combined(node, sign, sign.kind(), left, right)
            }
            "type_cast_expression" => self.cast(node),
            "array_expression" => self.array(node),
            "tuple_expression" => {
                let items = self.all(&children(node))?;
                Ok(at(node, Node::List(items)))
            }
            "index_expression" => {
                let parts = self.all(&children(node))?;
                let [head, index] = parts.try_into().map_err(|_| self.unread(node))?;
                Ok(at(node, Node::Index(Arc::new(head), vec![index])))
            }
            "field_expression" => self.field(node),
            "range_expression" => self.range(node),
            "if_expression" => self.choice(node),
            "block" => match children(node).as_slice() {
                [only] if only.kind() != "let_declaration" => self.expression(*only),
                _ => {
                    let message = "a block with statements is not read here";
                    Err(self.text.refused(node, message, "name its value before"))
                }
            },
            "expression_statement" => self.only(node),
            "scoped_identifier" => self.scoped(node),
            "call_expression" => self.application(node),
            "macro_invocation" => {
                let message = "a macro is not read";
                let help = "write an array, `[0.0; 4]`, or `p.to_vec()`";
                Err(self.text.refused(node, message, help))
            }
            "closure_expression" => {
                let help = "a closure is read in `map`";
                Err(self.text.refused(node, "a closure is not read here", help))
            }
            "match_expression" => Err(self.text.refused(node, "`match` is not read", "write `if`")),
            _ => Err(self.unread(node)),
        }
    }

    pub(super) fn unread(self, node: CodeNode<'_>) -> Box<DerivationError> {
        let kind = node.kind().replace('_', " ");
        self.text
            .refused(node, format!("this is not read: {kind}"), READ)
    }

    /// A call of what is no function of the file.
    pub(super) fn call(self, node: CodeNode<'_>, name: &str, arguments: Vec<Expr>) -> Expr {
        match self.functions.contains(name) {
            true => call(&format!("##{name}"), arguments, place(node)),
            false => call(name, arguments, place(node)),
        }
    }

    pub(super) fn all(self, nodes: &[CodeNode<'_>]) -> Read<Vec<Expr>> {
        nodes.iter().map(|node| self.expression(*node)).collect()
    }

    fn only(self, node: CodeNode<'_>) -> Read<Expr> {
        match children(node).as_slice() {
            [inner] => self.expression(*inner),
            _ => Err(self.unread(node)),
        }
    }

    fn name(self, node: CodeNode<'_>) -> Read<Expr> {
        let name = self.text.name(node)?;
        self.sure(node, name)?;
        let plain = || at(node, Node::Name(name.to_owned()));
        Ok(self.names.constant(name).map_or_else(plain, |value| Expr {
            place: place(node),
            ..value
        }))
    }

    /// Fails for a name that several things of the file may be. No variable hides a constant in Rust.
    fn sure(self, node: CodeNode<'_>, name: &str) -> Read<()> {
        self.names.check(name).map_err(|message| {
            let help = "give each thing of the file a name of its own";
            self.text.refused(node, message, help)
        })
    }

    fn literal(self, node: CodeNode<'_>) -> Read<Expr> {
        let text = self.text.text(node).replace('_', "");
        let suffix = ["f64", "f32"]
            .into_iter()
            .find(|suffix| text.ends_with(suffix));
        let is_float = node.kind() == "float_literal" || suffix.is_some();
        let digits = match suffix {
            Some(suffix) => text.trim_end_matches(suffix),
            None => text.trim_end_matches(|c: char| {
                c.is_ascii_alphanumeric() && !c.is_ascii_digit() && c != 'e' && c != 'E'
            }),
        };
        let digits = [
            "usize", "isize", "u8", "u16", "u32", "u64", "u128", "i8", "i16", "i32", "i64", "i128",
        ]
        .into_iter()
        .find_map(|kind| text.strip_suffix(kind))
        .unwrap_or(digits);
        let number = self.text.number(node, digits)?;
        Ok(match is_float {
            true => self.call(node, operation::FLOAT, vec![number]),
            false => number,
        })
    }

    fn unary(self, node: CodeNode<'_>) -> Read<Expr> {
        let inner = self.only(node)?;
        match self.text.text(node).chars().next() {
            Some('-') => Ok(at(node, Node::Negative(Arc::new(inner)))),
            Some('!') => Ok(at(node, Node::Not(Arc::new(inner)))),
            _ => Ok(inner),
        }
    }

    /// Two sides joined by an operator.
    pub(super) fn combined(
        self,
        node: CodeNode<'_>,
        sign: CodeNode<'_>,
        operator: &str,
        left: Expr,
        right: Expr,
    ) -> Read<Expr> {
        let compared = |relation| {
            let left = Arc::new(left.clone());
            Ok(at(
                node,
                Node::Compare(left, vec![(relation, right.clone())]),
            ))
        };
        let joined = |connective| {
            let (left, right) = (Arc::new(left.clone()), Arc::new(right.clone()));
            Ok(at(node, Node::Join(connective, left, right)))
        };
        let operator = match operator {
            "+" => Operator::Add,
            "-" => Operator::Subtract,
            "*" => Operator::Multiply,
            "/" => Operator::Divide,
            "%" => return Ok(self.call(node, operation::REMAINDER, vec![left, right])),
            "==" => return compared(Relation::Equal),
            "!=" => return compared(Relation::Different),
            "<" => return compared(Relation::Less),
            "<=" => return compared(Relation::AtMost),
            ">" => return compared(Relation::Greater),
            ">=" => return compared(Relation::AtLeast),
            "&&" => return joined(Connective::And),
            "||" => return joined(Connective::Or),
            _ => {
                let message = format!("`{operator}` is about the bits of integers");
                return Err(self.text.refused(sign, message, "`powi` is the power"));
            }
        };
        Ok(binary(node, operator, left, right))
    }

    fn cast(self, node: CodeNode<'_>) -> Read<Expr> {
        let value = self.expression(self.text.field(node, "value")?)?;
        let kind = self.text.field(node, "type")?;
        match self.aliases.number(self.text, kind).as_deref() {
            Some("f64" | "f32") => Ok(self.call(node, operation::FLOAT, vec![value])),
            Some(name) => {
                let operation = format!("{}:{name}", operation::WHOLE);
                Ok(self.call(node, &operation, vec![value]))
            }
            None => Err(self.text.refused(kind, "this type is not read", READ)),
        }
    }

    fn array(self, node: CodeNode<'_>) -> Read<Expr> {
        let Some(length) = node.child_by_field_name("length") else {
            return Ok(at(node, Node::List(self.all(&children(node))?)));
        };
        match children(node).as_slice() {
            [value, _] => {
                let repeated = vec![self.expression(*value)?, self.expression(length)?];
                Ok(self.call(node, operation::REPEAT, repeated))
            }
            _ => Err(self.unread(node)),
        }
    }

    fn field(self, node: CodeNode<'_>) -> Read<Expr> {
        let member = self.text.field(node, "field")?;
        let Ok(position) = self.text.text(member).parse::<i64>() else {
            let message = "a field of a structure is not read";
            return Err(self
                .text
                .refused(member, message, "pass its value as a parameter"));
        };
        let head = self.expression(self.text.field(node, "value")?)?;
        let index = Expr {
            place: place(member),
            ..Expr::number(&integer(position))
        };
        Ok(at(node, Node::Index(Arc::new(head), vec![index])))
    }

    fn range(self, node: CodeNode<'_>) -> Read<Expr> {
        let bounds = self.all(&children(node))?;
        let [low, high] = bounds.try_into().map_err(|_| {
            let message = "a range needs both ends";
            self.text.refused(node, message, "write `0..n`")
        })?;
        let one = Expr::number(&integer(1));
        let mut cursor = node.walk();
        let is_closed = node
            .children(&mut cursor)
            .any(|token| token.kind() == "..=");
        let high = if is_closed {
            high.with(Operator::Add, one.clone())
        } else {
            high
        };
        Ok(self.call(node, operation::RANGE, vec![low, high, one]))
    }

    fn choice(self, node: CodeNode<'_>) -> Read<Expr> {
        let condition = self.expression(self.text.field(node, "condition")?)?;
        let value = self.expression(self.text.field(node, "consequence")?)?;
        let other = self.text.field(node, "alternative")?;
        let other = self.only(other)?;
        Ok(self.call(node, operation::IF, vec![condition, value, other]))
    }

    fn scoped(self, node: CodeNode<'_>) -> Read<Expr> {
        let text = self.text.text(node);
        let found = self.names.constant(text);
        let value = found.ok_or_else(|| {
            let help = "the constants of `std::f64::consts` are read";
            self.text
                .refused(node, format!("`{text}` is not read"), help)
        })?;
        Ok(Expr {
            place: place(node),
            ..value
        })
    }

    fn application(self, node: CodeNode<'_>) -> Read<Expr> {
        let mut function = self.text.field(node, "function")?;
        if function.kind() == "generic_function" {
            function = self.text.field(function, "function")?;
        }
        let list = children(self.text.field(node, "arguments")?);
        match function.kind() {
            "identifier" => {
                let name = self.text.name(function)?;
                self.sure(function, name)?;
                if !self.functions.contains(name) {
                    let message = format!("the function `{name}` is not read");
                    return Err(self.text.refused(function, message, READ));
                }
                let head = at(function, Node::Name(name.to_owned()));
                Ok(at(node, Node::Call(Arc::new(head), self.all(&list)?)))
            }
            "field_expression" => {
                let object = self.text.field(function, "value")?;
                let member = self.text.field(function, "field")?;
                self.is_of_iterators(object, member)?;
                self.method(node, self.expression(object)?, member, &list)
            }
            "scoped_identifier" => {
                let path = self.text.text(self.text.field(function, "path")?);
                let member = self.text.field(function, "name")?;
                if !self.names.is_standard(path) {
                    let message = format!("`{path}` has another meaning in this file");
                    return Err(self.text.refused(function, message, READ));
                }
                match (path, self.text.text(member), list.as_slice()) {
                    ("Vec", "new", []) | ("Vec", "with_capacity", [_]) => {
                        Ok(at(node, Node::List(vec![])))
                    }
                    ("f64" | "f32", "from", [value]) => {
                        let value = self.expression(*value)?;
                        Ok(self.call(node, operation::FLOAT, vec![value]))
                    }
                    ("f64" | "f32", _, [first, rest @ ..]) => {
                        self.method(node, self.expression(*first)?, member, rest)
                    }
                    _ => {
                        let message = format!("`{}` is not read", self.text.text(function));
                        Err(self.text.refused(function, message, READ))
                    }
                }
            }
            _ => Err(self.unread(function)),
        }
    }

    /// A pattern of names, as a list where it is a tuple.
    pub(super) fn pattern(self, node: CodeNode<'_>) -> Read<Expr> {
        match node.kind() {
            "identifier" => Ok(at(node, Node::Name(self.text.name(node)?.to_owned()))),
            "_" => Ok(at(node, Node::Name("_".to_owned()))),
            "reference_pattern" | "mut_pattern" | "parameter" => {
                let mut parts = parts_of(node).into_iter();
                let inner = parts.find(|part| !matches!(part.kind(), "mutable_specifier" | "&"));
                self.pattern(inner.ok_or_else(|| self.unread(node))?)
            }
            "tuple_pattern" | "slice_pattern" => {
                let all = parts_of(node).into_iter().map(|one| self.pattern(one));
                Ok(at(node, Node::List(all.collect::<Read<_>>()?)))
            }
            _ => Err(self.text.refused(
                node,
                "this pattern is not read",
                "names and tuples of names are read",
            )),
        }
    }
}

/// The parts of a pattern: `_` is a sign of the grammar, and no name.
pub(super) fn parts_of(node: CodeNode<'_>) -> Vec<CodeNode<'_>> {
    let mut cursor = node.walk();
    let all = node.children(&mut cursor);
    let is_part = |part: &CodeNode<'_>| part.kind() == "_" || part.is_named();
    all.filter(|part| is_part(part) && !part.kind().ends_with("comment"))
        .collect()
}
