//! Calls of Python: functions of the file, of modules, and methods.

use super::expression::{READ, Reader};
use super::meaning::{Meaning, meaning};
use super::names::Sure;
use crate::grammar::{CodeNode, Read, at, binary, children};
use crate::program::operation;
use std::sync::Arc;
use torse_numbers::rational::integer;
use torse_syntax::derivation::DerivationError;
use torse_syntax::formula::{Expr, Node, Operator};

impl Reader<'_> {
    /// A call.
    pub(super) fn application(self, node: CodeNode<'_>) -> Read<Expr> {
        let function = self.text.field(node, "function")?;
        let arguments = self.text.field(node, "arguments")?;
        let meaning = match function.kind() {
            "identifier" => {
                let name = self.text.name(function)?;
                let sure = match self.locals.contains(name) {
                    true => Sure::Value,
                    false => self.sure(function, name)?,
                };
                match sure {
                    Sure::Value => {
                        let message = format!("`{name}` is a variable here, and is called");
                        let help = "functions that are defined by `def` are called";
                        return Err(self.refused(function, &message, help));
                    }
                    Sure::Function => {
                        let arguments = self.arguments(arguments)?;
                        let head = at(function, Node::Name(name.to_owned()));
                        return Ok(at(node, Node::Call(Arc::new(head), arguments)));
                    }
                    Sure::Known(meaning) => Some(meaning),
                    Sure::Unread | Sure::Unknown => None,
                }
            }
            "attribute" => {
                let object = self.text.field(function, "object")?;
                let member = self.text.text(self.text.field(function, "attribute")?);
                let Some(module) = self.module(object)? else {
                    return self.method(node, object, member, arguments);
                };
                meaning(&module, member)
            }
            _ => None,
        };
        let Some(meaning) = meaning else {
            let name = self.text.text(function);
            let message = format!("the function `{name}` is not read");
            let help = "functions of this file are read, and of math, numpy and sympy those that formulas have: sin, cos, tan, exp, \
                        sinh, cosh, tanh, sqrt, abs, comb, factorial, sum, prod, dot, cross, diff, integrate";
            return Err(self.refused(function, &message, help));
        };
        self.with_meaning(node, meaning, arguments)
    }

    /// The arguments of a call. Fails for one that is given by its name.
    fn arguments(self, node: CodeNode<'_>) -> Read<Vec<Expr>> {
        let nodes = argument_nodes(node);
        for argument in &nodes {
            if argument.kind() == "keyword_argument" {
                let message = "an argument with a name is not read";
                return Err(self.refused(*argument, message, "give it by its place"));
            }
        }
        self.all(&nodes)
    }

    /// A call of what has a meaning of its own.
    fn with_meaning(self, node: CodeNode<'_>, meaning: Meaning, list: CodeNode<'_>) -> Read<Expr> {
        if matches!(meaning, Meaning::Symbols | Meaning::Symbol) {
            return self.symbols(node, list, meaning == Meaning::Symbol);
        }
        let goes_through_it = matches!(
            meaning,
            Meaning::Function(
                operation::SUM
                    | operation::PRODUCT
                    | operation::TOTAL
                    | operation::TOTAL_PRODUCT
                    | operation::LIST
                    | "min"
                    | "max"
            )
        );
        let is_array = matches!(
            meaning,
            Meaning::Function(
                operation::VECTOR | operation::AS_VECTOR | operation::MATRIX | operation::COPY
            )
        );
        if is_array && list.kind() == "argument_list" && children(list).len() != 1 {
            let message = "the type of an array is not read";
            return Err(self.refused(list, message, "give the entries alone"));
        }
        let arguments = match only_generator(list).filter(|_| goes_through_it) {
            Some(generator) => vec![self.comprehension(generator)?],
            None => self.arguments(list)?,
        };
        let count = arguments.len();
        let wrong = || {
            let message = format!("this call with {count} arguments is not read");
            self.refused(list, &message, READ)
        };
        let one = || match arguments.as_slice() {
            [only] => Ok(only.clone()),
            _ => Err(wrong()),
        };
        let two = || match arguments.as_slice() {
            [first, second] => Ok((first.clone(), second.clone())),
            _ => Err(wrong()),
        };
        match meaning {
            Meaning::Pi | Meaning::E | Meaning::Symbols | Meaning::Symbol => {
                Err(self.refused(node, "a number is no function", READ))
            }
            Meaning::Function(name) => Ok(self.call(node, name, arguments)),
            Meaning::Extremum(_) if count < 2 => Err(wrong()),
            Meaning::Extremum(name) => Ok(self.call(node, name, arguments)),
            Meaning::ExtremumOfTwo(name) => {
                let (one, other) = two()?;
                Ok(self.call(node, name, vec![one, other]))
            }
            Meaning::Whole => Ok(self.call(node, operation::WHOLE, vec![one()?])),
            Meaning::Same(most) => match arguments.first() {
                Some(first) if count <= most => Ok(first.clone()),
                _ => Err(wrong()),
            },
            Meaning::Complex(name) => {
                let name = format!("{}{name}", operation::REAL);
                Ok(self.call(node, &name, vec![one()?]))
            }
            Meaning::Natural(name) => {
                let name = format!("{}{name}", operation::NATURAL);
                Ok(self.call(node, &name, arguments))
            }
            Meaning::Quotient if count == 1 => one(),
            Meaning::Quotient => {
                let (above, below) = two()?;
                Ok(binary(node, Operator::Divide, above, below))
            }
            Meaning::Power => {
                let (base, exponent) = two()?;
                Ok(binary(node, Operator::Power, base, exponent))
            }
            Meaning::Square => {
                let exponent = Expr::number(&integer(2));
                Ok(binary(node, Operator::Power, one()?, exponent))
            }
            Meaning::Derivative => Ok(self.call(node, "D", arguments)),
            Meaning::Integral => self.binder(node, "integral", arguments, wrong),
            Meaning::Series(name) => self.binder(node, name, arguments, wrong),
            Meaning::Range => {
                let number = |n| Expr::number(&integer(n));
                let all = match arguments.as_slice() {
                    [high] => vec![number(0), high.clone(), number(1)],
                    [low, high] => vec![low.clone(), high.clone(), number(1)],
                    [_, _, _] => arguments,
                    _ => return Err(wrong()),
                };
                Ok(self.call(node, operation::RANGE, all))
            }
            Meaning::Filled(value) => {
                let entry = Expr::number(&integer(value));
                let entry = self.call(node, operation::FLOAT, vec![entry]);
                let list = self.call(node, operation::REPEAT, vec![entry, one()?]);
                Ok(self.call(node, operation::VECTOR, vec![list]))
            }
        }
    }

    /// A sum, a product or an integral, with its variable and bounds in a tuple.
    fn binder(
        self,
        node: CodeNode<'_>,
        name: &str,
        arguments: Vec<Expr>,
        wrong: impl Fn() -> Box<DerivationError>,
    ) -> Read<Expr> {
        let [body, bounds] = <[Expr; 2]>::try_from(arguments).map_err(|_| wrong())?;
        let Node::List(bounds) = bounds.node else {
            return Err(wrong());
        };
        let [variable, low, high] = <[Expr; 3]>::try_from(bounds).map_err(|_| wrong())?;
        let all = match name {
            "integral" => vec![body, variable, low, high],
            _ => vec![variable, low, high, body],
        };
        Ok(self.call(node, name, all))
    }

    /// New symbols of SymPy: their names in one text.
    fn symbols(self, node: CodeNode<'_>, list: CodeNode<'_>, is_one: bool) -> Read<Expr> {
        let arguments = children(list);
        let [string, assumptions @ ..] = arguments.as_slice() else {
            return Err(self.refused(list, "a symbol has a name", "write `symbols('t u')`"));
        };
        // All values of a comparison are real numbers.
        let is_real = |node: &CodeNode<'_>| {
            let words: String = self.text.text(*node).split_whitespace().collect();
            node.kind() == "keyword_argument" && words == "real=True"
        };
        if let Some(other) = assumptions.iter().find(|node| !is_real(node)) {
            let message = "what is assumed of a symbol is not read";
            let help = "leave it out: SymPy may use it for a value that does not satisfy it";
            return Err(self.refused(*other, message, help));
        }
        let content = match (string.kind(), children(*string).as_slice()) {
            ("string", [_, content, _]) if content.kind() == "string_content" => Some(*content),
            _ => None,
        };
        let is_plain_text = self.text.text(*string).starts_with(['\'', '"']);
        let content = content.filter(|node| is_plain_text && children(*node).is_empty());
        let Some(content) = content else {
            let message = "symbols have their names in one text";
            return Err(self.refused(list, message, "write `symbols('t u')`"));
        };
        let written = self.text.text(content);
        let is_between = |c: char| !is_one && (c == ',' || c.is_whitespace());
        let names: Vec<&str> = written
            .split(is_between)
            .filter(|name| !name.is_empty())
            .collect();
        let is_name = |name: &&str| {
            let starts = name.starts_with(|c: char| !c.is_ascii_digit());
            starts && crate::grammar::is_plain(name)
        };
        // A sign `,` behind one name makes a tuple of it.
        let is_tuple = !is_one && written.trim_end().ends_with(',');
        if names.is_empty() || !names.iter().all(is_name) || is_tuple {
            let message = "these names of symbols are not read";
            return Err(self.refused(content, message, "write `symbols('t u')`"));
        }
        // The name is one of the operation: no part of a formula that a change of the code could replace.
        let symbol = |name: &str| {
            let operation = format!("{}{name}", operation::SYMBOL);
            self.call(node, &operation, vec![])
        };
        let all: Vec<Expr> = names.into_iter().map(symbol).collect();
        match all.as_slice() {
            [only] => Ok(only.clone()),
            _ => Ok(at(node, Node::List(all))),
        }
    }

    /// A method of a value.
    fn method(
        self,
        node: CodeNode<'_>,
        object: CodeNode<'_>,
        member: &str,
        list: CodeNode<'_>,
    ) -> Read<Expr> {
        let arguments = self.arguments(list)?;
        let value = self.expression(object)?;
        let with = |more: Vec<Expr>| std::iter::once(value.clone()).chain(more).collect();
        match (member, arguments.len()) {
            ("copy", 0) => Ok(self.call(node, operation::COPY, vec![value])),
            ("sum", 0) => Ok(self.call(node, operation::TOTAL, vec![value])),
            ("doit" | "simplify" | "expand" | "factor" | "together" | "cancel", 0) => Ok(value),
            ("dot", 1) => Ok(self.call(node, "dot", with(arguments))),
            ("cross", 1) => Ok(self.call(node, "cross", with(arguments))),
            ("diff", 1 | 2) => Ok(self.call(node, "D", with(arguments))),
            ("subs", 2) => Ok(self.call(node, "at", with(arguments))),
            ("evalf" | "n", _) => Err(self.refused(
                node,
                "this rounds, and code is read as exact mathematics",
                "leave it out",
            )),
            _ => {
                let message = format!("the method `{member}` is not read");
                Err(self.refused(node, &message, READ))
            }
        }
    }
}

/// The arguments of a call. A generator may stand alone, without a list: `sum(x for x in v)`.
fn argument_nodes(list: CodeNode<'_>) -> Vec<CodeNode<'_>> {
    match list.kind() {
        "generator_expression" => vec![list],
        _ => children(list),
    }
}

/// The generator that is the one argument of a call.
fn only_generator(list: CodeNode<'_>) -> Option<CodeNode<'_>> {
    match argument_nodes(list).as_slice() {
        [only] if only.kind() == "generator_expression" => Some(*only),
        _ => None,
    }
}
