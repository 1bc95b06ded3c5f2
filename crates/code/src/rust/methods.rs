//! Methods of Rust: functions of numbers, and what goes through lists.

use super::expression::{READ, Reader, parts_of};
use super::names::elementary;
use crate::grammar::{CodeNode, Read, binary, children};
use crate::program::operation;
use torse_numbers::rational::integer;
use torse_syntax::formula::{Expr, Operator};

/// Methods of what goes through a list: other things may have others of these names.
const OF_ITERATORS: [&str; 9] = [
    "sum",
    "product",
    "map",
    "enumerate",
    "rev",
    "zip",
    "copied",
    "cloned",
    "collect",
];

impl Reader<'_> {
    /// Fails for a method of what goes through a list, where something else is written before it.
    pub(super) fn is_of_iterators(self, object: CodeNode<'_>, member: CodeNode<'_>) -> Read<()> {
        let name = self.text.text(member);
        if !OF_ITERATORS.contains(&name) || self.is_iterator(object) {
            return Ok(());
        }
        let message = format!("`{name}` is a method of what goes through a list");
        let help = format!("write `.iter().{name}(...)`");
        Err(self.text.refused(member, message, help))
    }

    /// Whether something goes through a list, by the way it is written.
    fn is_iterator(self, node: CodeNode<'_>) -> bool {
        match node.kind() {
            "range_expression" => true,
            "parenthesized_expression" => children(node)
                .first()
                .is_some_and(|inner| self.is_iterator(*inner)),
            "call_expression" => {
                let function = node.child_by_field_name("function");
                let name = function.and_then(|function| function.child_by_field_name("field"));
                let name = name.map_or("", |name| self.text.text(name));
                let makes = matches!(name, "iter" | "into_iter");
                makes || (OF_ITERATORS.contains(&name) && name != "collect")
            }
            _ => false,
        }
    }

    /// A method of a value.
    pub(super) fn method(
        self,
        node: CodeNode<'_>,
        value: Expr,
        member: CodeNode<'_>,
        list: &[CodeNode<'_>],
    ) -> Read<Expr> {
        let name = self.text.text(member);
        if !self.names.is_method(name) {
            let message = format!("a trait of this file has a method `{name}`");
            let help = "give that method a name of its own";
            return Err(self.text.refused(member, message, help));
        }
        if let [closure] = list
            && closure.kind() == "closure_expression"
        {
            return match name {
                "map" => self.mapped(node, value, *closure),
                _ => Err(self
                    .text
                    .refused(member, format!("`{name}` is not read"), READ)),
            };
        }
        let arguments = self.all(list)?;
        if let (Some(function), []) = (elementary(name), arguments.as_slice()) {
            return Ok(self.call(node, function, vec![value]));
        }
        let operation = match (name, arguments.as_slice()) {
            ("powi" | "powf", [exponent]) => {
                return Ok(binary(node, Operator::Power, value, exponent.clone()));
            }
            // Numbers with a point have none of this name.
            ("pow", [exponent]) => {
                let whole = Expr {
                    place: value.place,
                    ..self.call(node, operation::INTEGER, vec![value])
                };
                return Ok(binary(node, Operator::Power, whole, exponent.clone()));
            }
            ("min" | "max", [other]) => {
                return Ok(self.call(node, name, vec![value, other.clone()]));
            }
            ("recip", []) => {
                let one = Expr::number(&integer(1));
                let one = self.call(node, operation::FLOAT, vec![one]);
                return Ok(binary(node, Operator::Divide, one, value));
            }
            ("mul_add", [factor, term]) => {
                let product = binary(node, Operator::Multiply, value, factor.clone());
                return Ok(binary(node, Operator::Add, product, term.clone()));
            }
            (
                "iter" | "into_iter" | "copied" | "cloned" | "collect" | "as_slice" | "to_owned"
                | "into" | "clone" | "to_vec",
                [],
            ) => operation::COPY,
            ("len", []) => operation::LENGTH,
            ("sum", []) => operation::SUM,
            ("product", []) => operation::PRODUCT,
            ("enumerate", []) => operation::ENUMERATE,
            ("rev", []) => operation::REVERSED,
            ("zip", [other]) => {
                return Ok(self.call(node, operation::ZIP, vec![value, other.clone()]));
            }
            _ => {
                let message = format!("the method `{name}` is not read");
                return Err(self.text.refused(member, message, READ));
            }
        };
        Ok(self.call(node, operation, vec![value]))
    }

    /// `values.map(|variable| body)`.
    fn mapped(self, node: CodeNode<'_>, values: Expr, closure: CodeNode<'_>) -> Read<Expr> {
        let parameters = parts_of(self.text.field(closure, "parameters")?);
        let [variable] = parameters.as_slice() else {
            return Err(self.unread(closure));
        };
        let variable = self.pattern(*variable)?;
        let body = self.expression(self.text.field(closure, "body")?)?;
        Ok(self.call(node, operation::FOR, vec![body, variable, values]))
    }
}
