//! Expressions of Python.

use super::meaning::{Meaning, meaning};
use super::names::{Names, Sure};
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
    /// The variables here, which hide names of the file.
    pub(super) locals: &'s BTreeSet<String>,
}

/// What is read, for messages.
pub(super) const READ: &str = "numbers, names, `+ - * / **`, calls of functions of this file and of math, numpy and sympy, lists, tuples, \
                    indices, comparisons, `a if c else b`, and comprehensions are read";

impl Reader<'_> {
    /// Reads an expression.
    pub(super) fn expression(self, node: CodeNode<'_>) -> Read<Expr> {
        let text = self.text.text(node);
        match node.kind() {
            "identifier" => self.name(node),
            "integer" => self.text.number(node, &text.replace('_', "")),
            "float" => {
                let number = self.text.number(node, &text.replace('_', ""))?;
                Ok(self.call(node, operation::FLOAT, vec![number]))
            }
            "true" => Ok(at(node, Node::Name(operation::TRUE.to_owned()))),
            "false" => Ok(at(node, Node::Name(operation::FALSE.to_owned()))),
            "parenthesized_expression" => self.only(node),
            "unary_operator" => self.unary(node),
            "binary_operator" => self.binary(node),
            "comparison_operator" => self.comparison(node),
            "boolean_operator" => {
                let connective = match self.operator(node)? {
                    "and" => Connective::And,
                    _ => Connective::Or,
                };
                let (left, right) = self.sides(node)?;
                Ok(at(
                    node,
                    Node::Join(connective, Arc::new(left), Arc::new(right)),
                ))
            }
            "not_operator" => {
                let inner = self.expression(self.text.field(node, "argument")?)?;
                Ok(at(node, Node::Not(Arc::new(inner))))
            }
            "conditional_expression" => {
                let parts = self.all(&children(node))?;
                let [value, condition, other] = parts.try_into().map_err(|_| self.unread(node))?;
                Ok(self.call(node, operation::IF, vec![condition, value, other]))
            }
            "list" | "tuple" | "expression_list" => {
                let items = self.all(&children(node))?;
                Ok(at(node, Node::List(items)))
            }
            "list_comprehension" => self.comprehension(node),
            "generator_expression" => {
                let message =
                    "the values of this are made later, when other things may have changed";
                let help =
                    "write a list, `[... for ...]`, or sum it up at once: `sum(... for ...)`";
                Err(self.refused(node, message, help))
            }
            "subscript" => self.subscript(node),
            "attribute" => self.attribute(node),
            "call" => self.application(node),
            "lambda" => {
                Err(self.refused(node, "a lambda is not read", "write a function with `def`"))
            }
            "string" | "concatenated_string" => Err(self.refused(
                node,
                "a text has no value in mathematics",
                "numbers, names and formulas are read",
            )),
            _ => Err(self.unread(node)),
        }
    }

    pub(super) fn refused(
        self,
        node: CodeNode<'_>,
        message: &str,
        help: &str,
    ) -> Box<DerivationError> {
        self.text.refused(node, message, help)
    }

    pub(super) fn unread(self, node: CodeNode<'_>) -> Box<DerivationError> {
        let kind = node.kind().replace('_', " ");
        self.refused(node, &format!("this is not read: {kind}"), READ)
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

    fn operator<'t>(self, node: CodeNode<'t>) -> Read<&'t str> {
        Ok(self.text.field(node, "operator")?.kind())
    }

    fn sides(self, node: CodeNode<'_>) -> Read<(Expr, Expr)> {
        let left = self.expression(self.text.field(node, "left")?)?;
        let right = self.expression(self.text.field(node, "right")?)?;
        Ok((left, right))
    }

    fn name(self, node: CodeNode<'_>) -> Read<Expr> {
        let name = self.text.name(node)?;
        let own = |name: &str| at(node, Node::Name(name.to_owned()));
        if self.locals.contains(name) {
            return Ok(own(name));
        }
        Ok(match self.sure(node, name)? {
            Sure::Known(Meaning::Pi) => own(operation::PI),
            Sure::Known(Meaning::E) => own(operation::E),
            _ => own(name),
        })
    }

    /// What a name is that no variable hides.
    pub(super) fn sure(self, node: CodeNode<'_>, name: &str) -> Read<Sure> {
        self.names
            .name(name)
            .map_err(|message| self.unsure(node, &message))
    }

    fn unsure(self, node: CodeNode<'_>, message: &str) -> Box<DerivationError> {
        let help = "give each thing of the file a name of its own, once, and outside of functions";
        self.refused(node, message, help)
    }

    /// The module that something is, which no variable hides.
    pub(super) fn module(self, node: CodeNode<'_>) -> Read<Option<String>> {
        let object = self.text.text(node);
        let first = object.split('.').next().unwrap_or(object);
        if self.locals.contains(first) {
            return Ok(None);
        }
        let module = self.names.module(object);
        module.map_err(|message| self.unsure(node, &message))
    }

    fn unary(self, node: CodeNode<'_>) -> Read<Expr> {
        let inner = self.expression(self.text.field(node, "argument")?)?;
        match self.operator(node)? {
            "-" => Ok(at(node, Node::Negative(Arc::new(inner)))),
            "+" => Ok(inner),
            _ => Err(self.refused(
                node,
                "`~` turns the bits of an integer over",
                "`-` is the sign of a number",
            )),
        }
    }

    fn binary(self, node: CodeNode<'_>) -> Read<Expr> {
        let operator = self.operator(node)?;
        let sign = self.text.field(node, "operator")?;
        let (left, right) = self.sides(node)?;
        self.combined(node, sign, operator, left, right)
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
        let operator = match operator {
            "+" => Operator::Add,
            "-" => Operator::Subtract,
            "*" => Operator::Multiply,
            "/" => Operator::Divide,
            "**" => Operator::Power,
            "//" => return Ok(self.call(node, operation::QUOTIENT, vec![left, right])),
            "%" => return Ok(self.call(node, operation::REMAINDER, vec![left, right])),
            "^" => {
                let message = "`^` exchanges bits in Python";
                return Err(self.refused(sign, message, "`**` is the power"));
            }
            "@" => {
                let message = "a product of matrices is not read";
                return Err(self.refused(
                    sign,
                    message,
                    "`dot(a, b)` is the product of two vectors",
                ));
            }
            _ => {
                let message = format!("`{operator}` is about the bits of integers");
                return Err(self.refused(sign, &message, READ));
            }
        };
        Ok(binary(node, operator, left, right))
    }

    fn comparison(self, node: CodeNode<'_>) -> Read<Expr> {
        let operands = self.all(&children(node))?;
        let mut relations = vec![];
        let mut cursor = node.walk();
        for sign in node.children(&mut cursor).filter(|child| !child.is_named()) {
            relations.push(match sign.kind() {
                "==" => Relation::Equal,
                "!=" => Relation::Different,
                "<" => Relation::Less,
                "<=" => Relation::AtMost,
                ">" => Relation::Greater,
                ">=" => Relation::AtLeast,
                other => {
                    let message = format!("the comparison `{other}` is not read");
                    return Err(self.refused(sign, &message, "`== != < <= > >=` are read"));
                }
            });
        }
        let mut operands = operands.into_iter();
        let first = operands.next().ok_or_else(|| self.unread(node))?;
        let rest = relations.into_iter().zip(operands).collect();
        Ok(at(node, Node::Compare(Arc::new(first), rest)))
    }

    pub(super) fn comprehension(self, node: CodeNode<'_>) -> Read<Expr> {
        let parts = children(node);
        let [body, clauses @ ..] = parts.as_slice() else {
            return Err(self.unread(node));
        };
        let operation = match node.kind() {
            "generator_expression" => operation::GENERATE,
            _ => operation::FOR,
        };
        let [clause, more @ ..] = clauses else {
            return Err(self.unread(node));
        };
        if let Some(more) = more.first() {
            let (message, help) = match more.kind() {
                "for_in_clause" => (
                    "a comprehension over two variables is not read",
                    "write one inside of the other",
                ),
                _ => (
                    "a condition in a comprehension is not read",
                    "write a loop with `if`",
                ),
            };
            return Err(self.refused(*more, message, help));
        }
        let variable = self.text.field(*clause, "left")?;
        let names = match variable.kind() {
            "identifier" => vec![variable],
            _ => children(variable),
        };
        let mut locals = self.locals.clone();
        let mut read = vec![];
        for name in names {
            if name.kind() != "identifier" {
                return Err(self.unread(variable));
            }
            let own = self.text.name(name)?;
            locals.insert(own.to_owned());
            read.push(at(name, Node::Name(own.to_owned())));
        }
        let name = match (variable.kind(), read.as_slice()) {
            ("identifier", [only]) => only.clone(),
            _ => at(variable, Node::List(read)),
        };
        let inner = Reader {
            locals: &locals,
            ..self
        };
        let value = inner.expression(*body)?;
        let values = self.expression(self.text.field(*clause, "right")?)?;
        Ok(self.call(node, operation, vec![value, name, values]))
    }

    fn subscript(self, node: CodeNode<'_>) -> Read<Expr> {
        let head = self.text.field(node, "value")?;
        let mut cursor = node.walk();
        let indices: Vec<_> = node
            .children_by_field_name("subscript", &mut cursor)
            .collect();
        if let [slice] = indices.as_slice()
            && slice.kind() == "slice"
        {
            return self.slice(node, self.expression(head)?, *slice);
        }
        if let [only] = indices.as_slice()
            && only.kind().starts_with("list")
        {
            let message = "an index that is a list takes several entries, and is not read";
            return Err(self.refused(*only, message, "write a comprehension"));
        }
        let mut indices = self.all(&indices)?;
        if let [
            Expr {
                node: Node::List(several),
                ..
            },
        ] = indices.as_slice()
        {
            indices = several.clone();
        }
        let head = self.expression(head)?;
        Ok(at(node, Node::Index(Arc::new(head), indices)))
    }

    /// `list[low:high]`.
    fn slice(self, node: CodeNode<'_>, list: Expr, slice: CodeNode<'_>) -> Read<Expr> {
        let mut cursor = slice.walk();
        let mut ends = [None, None];
        let mut colons = 0;
        for part in slice.children(&mut cursor) {
            match part.kind() {
                ":" => colons += 1,
                _ => match ends.get_mut(colons) {
                    Some(end) => *end = Some(self.expression(part)?),
                    None => {
                        let message = "a part of a list with a step is not read";
                        return Err(self.refused(part, message, "leave the step out"));
                    }
                },
            }
        }
        let [low, high] = ends;
        let low = low.unwrap_or_else(|| Expr::number(&integer(0)));
        let length = || self.call(node, operation::LENGTH, vec![list.clone()]);
        let high = high.unwrap_or_else(length);
        Ok(self.call(node, operation::SLICE, vec![list, low, high]))
    }

    fn attribute(self, node: CodeNode<'_>) -> Read<Expr> {
        let object = self.text.field(node, "object")?;
        let member = self.text.text(self.text.field(node, "attribute")?);
        let module = self.module(object)?;
        let found = module.and_then(|module| meaning(&module, member));
        match found {
            Some(Meaning::Pi) => Ok(at(node, Node::Name(operation::PI.to_owned()))),
            Some(Meaning::E) => Ok(at(node, Node::Name(operation::E.to_owned()))),
            Some(_) => Err(self.refused(node, "a function without arguments", "call it")),
            None => {
                let message = format!("`{member}` is not read");
                Err(self.refused(node, &message, READ))
            }
        }
    }
}
