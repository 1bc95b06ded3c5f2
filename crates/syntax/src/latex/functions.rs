//! Functions that are written without brackets, and how far their argument reaches.
//!
//! The argument of `\sin` is the bracket right behind it, or else the operands that follow up to a sign, a vector or another
//! function. It is one of these without doubt if it is a bracket, one operand, or numbers, `\pi` and fractions of them before one
//! operand. Everything else has two readings: `\sin x y`, `\sin(n + 1)x`, `\sin x/2`.

use super::arithmetic::{begins_operand, divided, multiplied, negated};
use super::error::LatexError;
use super::item::{Nucleus, TexFace, TexItem};
use super::names::parts;
use super::reader::{Line, ReadTerm, Reader, Shape, Term, integer_at};
use crate::formula::{Expr, Node, Operator, Place};
use std::sync::Arc;

/// The functions of the language that papers write so.
const FUNCTIONS: [&str; 15] = [
    "sin", "cos", "tan", "cot", "sec", "csc", "sinh", "cosh", "tanh", "exp", "log", "ln", "arctan",
    "arcsin", "arccos",
];

impl Reader<'_> {
    /// Reads a named operator with its argument.
    pub fn function(&mut self, line: &mut Line<'_>, name: &str) -> ReadTerm {
        let Some(item) = line.peek() else {
            return Err(LatexError::new(line.place(), "an operand is missing"));
        };
        let place = item.place;
        if name == "det" {
            line.next += 1;
            return self.determinant(line, item);
        }
        if matches!(name, "min" | "max") {
            line.next += 1;
            return self.extremum(line, name, item);
        }
        if !FUNCTIONS.contains(&name) {
            // `\operatorname{x}` may be a declared name.
            if self.names.kind(name).is_some() {
                return self.name(line);
            }
            let error = LatexError::new(place, format!("`{name}` is not in the language"));
            return Err(error.with_help(
                "its functions are sin, cos, tan, cot, sec, csc, sinh, cosh, tanh, exp, log, ln, arctan, arcsin, arccos, min, max and det",
            ));
        }
        line.next += 1;
        if item.below.is_some() || item.primes > 0 {
            return Err(LatexError::new(
                place,
                format!("a script of `{name}` is not understood"),
            ));
        }
        let exponent = match item.above.as_deref() {
            None => None,
            Some(above) => {
                if above.first().is_some_and(|first| first.is_sign("-")) {
                    let error = LatexError::new(
                        place,
                        format!(
                            "`{name}` with a negative exponent may be an inverse function or a quotient"
                        ),
                    );
                    return Err(error.with_help("write an inverse function as `\\arctan`, `\\arcsin` or `\\arccos`, and a quotient as `\\frac{1}{...}`"));
                }
                Some(self.value(above, place, "the exponent")?)
            }
        };
        let (argument, above) = self.argument(line, place)?;
        let place = place.to(argument.place);
        let mut value = applied(name, argument, place);
        if let Some(exponent) = exponent {
            value = Term::number(
                Node::Binary(Operator::Power, Arc::new(value.expr), Arc::new(exponent)),
                place,
            );
        }
        match above {
            None => Ok(value),
            Some(above) => self.raised(value, above),
        }
    }

    /// Reads the argument of a function, and an exponent behind its brackets that is one of the value.
    fn argument<'i>(
        &mut self,
        line: &mut Line<'i>,
        place: Place,
    ) -> Result<(Expr, Option<&'i [TexItem]>), LatexError> {
        let start = line.place();
        let Some(item) = line.peek() else {
            return Err(LatexError::new(place, "the function has no argument"));
        };
        if let Nucleus::Fenced('(' | '[' | '{', inner, _) = &item.nucleus {
            let is_sum = inner
                .iter()
                .any(|item| item.is_sign("+") || item.is_sign("-"));
            let follows = line.items.get(line.next + 1);
            let goes_on = follows.is_some_and(|next| {
                matches!(
                    next.nucleus,
                    Nucleus::Letter(_, TexFace::Plain) | Nucleus::Number(_)
                )
            });
            if is_sum && goes_on {
                let says = [
                    "the argument is what is in the brackets",
                    "the argument goes on behind the brackets",
                ];
                if self.choose(format!("argument {}", start.start), start, says) == 1 {
                    return Ok((number(self.operands(line)?)?, None));
                }
            }
            line.next += 1;
            let inner = number(self.whole(inner, item.place)?)?;
            let inner = Expr {
                place: item.place,
                ..inner
            };
            if item.below.is_some() || item.primes > 0 {
                return Err(LatexError::new(item.place, "this script is not understood"));
            }
            let Some(above) = item.above.as_deref() else {
                return Ok((inner, None));
            };
            let says = [
                "the exponent is of the value of the function",
                "the exponent is of the argument",
            ];
            return match self.choose(format!("exponent {}", start.start), start, says) {
                1 => Ok((
                    self.raised(
                        Term {
                            expr: inner,
                            shape: Shape::Number,
                        },
                        above,
                    )?
                    .expr,
                    None,
                )),
                _ => Ok((inner, Some(above))),
            };
        }
        if item.is_sign("-") {
            line.next += 1;
            let rest = self.simple_argument(line)?;
            return Ok((number(negated(rest, item.place))?, None));
        }
        Ok((number(self.simple_argument(line)?)?, None))
    }

    /// Reads operands that follow one another without a sign.
    fn operands(&mut self, line: &mut Line<'_>) -> ReadTerm {
        let mut product = self.factor(line)?;
        while line.peek().is_some_and(continues) {
            let next = self.factor(line)?;
            product = multiplied(product, "", next)?;
        }
        Ok(product)
    }

    /// Reads an argument without brackets.
    fn simple_argument(&mut self, line: &mut Line<'_>) -> ReadTerm {
        let start = line.place();
        if !line
            .peek()
            .is_some_and(|item| begins_operand(item) && !matches!(item.nucleus, Nucleus::Big(_)))
        {
            return Err(LatexError::new(start, "the function has no argument"));
        }
        let mut argument = self.factor(line)?;
        // Numbers before one operand belong to it.
        while is_coefficient(&argument.expr) && line.peek().is_some_and(continues) {
            let next = self.factor(line)?;
            argument = multiplied(argument, "", next)?;
        }
        if line.peek().is_some_and(continues) {
            let says = [
                "the argument is what is right behind the function",
                "the argument is all that follows",
            ];
            if self.choose(format!("argument {}", start.start), start, says) == 1 {
                while line.peek().is_some_and(continues) {
                    let next = self.factor(line)?;
                    argument = multiplied(argument, "", next)?;
                }
            }
        }
        if line.peek().is_some_and(|item| item.is_sign("/")) {
            let says = [
                "the slash divides the value of the function",
                "the slash divides its argument",
            ];
            if self.choose(format!("slash of argument {}", start.start), start, says) == 1 {
                line.next += 1;
                let below = self.factor(line)?;
                argument = divided(argument, below)?;
            }
        }
        Ok(argument)
    }

    /// `\det(a, b, c)`, `\det M`, `\det` before a matrix.
    fn determinant(&mut self, line: &mut Line<'_>, item: &TexItem) -> ReadTerm {
        if !item.is_bare() {
            return Err(LatexError::new(
                item.place,
                "scripts of `det` are not understood",
            ));
        }
        let Some(next) = line.peek() else {
            return Err(LatexError::new(item.place, "the determinant of nothing"));
        };
        let place = item.place.to(next.place);
        if let Nucleus::Fenced('(' | '[', inner, _) = &next.nucleus {
            let entries = parts(inner);
            if entries.len() > 1 {
                line.next += 1;
                let mut rows = vec![];
                for entry in entries {
                    let term = self.whole(entry, place)?;
                    if term.shape != Shape::Vector {
                        return Err(LatexError::new(
                            term.expr.place,
                            "the entries of a determinant are vectors",
                        ));
                    }
                    rows.push(term.expr);
                }
                let list = Expr {
                    node: Node::List(rows),
                    place,
                };
                let value = Term::call("det", vec![list], place, Shape::Number);
                return match &next.above {
                    None => Ok(value),
                    Some(above) => self.raised(value, above),
                };
            }
        }
        let matrix = self.factor(line)?;
        match matrix.shape {
            Shape::Matrix => Ok(Term::call("det", vec![matrix.expr], place, Shape::Number)),
            _ => Err(LatexError::new(place, "the determinant is not of a matrix")),
        }
    }
}

impl Reader<'_> {
    /// `\max(a, b)`, `\min\{a, b, c\}`: of more than two the greatest is that of the first and of the greatest of the rest.
    fn extremum(&mut self, line: &mut Line<'_>, name: &str, item: &TexItem) -> ReadTerm {
        if !item.is_bare() {
            let message = format!("scripts of `{name}` are not understood");
            return Err(LatexError::new(item.place, message).with_help(
                "the language has the greatest of numbers that are written one by one",
            ));
        }
        let message = format!("`{name}` has no list of numbers in brackets behind it");
        let missing = || LatexError::new(item.place, message.clone());
        let next = line.peek().ok_or_else(missing)?;
        let place = item.place.to(next.place);
        let Nucleus::Fenced('(' | '[' | '{', inner, _) = &next.nucleus else {
            return Err(missing());
        };
        let entries = parts(inner);
        if entries.len() < 2 || next.below.is_some() || next.primes > 0 {
            return Err(missing());
        }
        line.next += 1;
        let mut numbers = vec![];
        for entry in entries {
            numbers.push(number(self.whole(entry, place)?)?);
        }
        let several = numbers.into_iter().rev();
        let joined = several
            .reduce(|rest, first| Term::call(name, vec![first, rest], place, Shape::Number).expr);
        let expr = joined.ok_or_else(missing)?;
        let value = Term {
            expr,
            shape: Shape::Number,
        };
        match &next.above {
            None => Ok(value),
            Some(above) => self.raised(value, above),
        }
    }
}

/// The formula of a term that has to be a number.
fn number(term: Term) -> Result<Expr, LatexError> {
    match term.shape {
        Shape::Number => Ok(term.expr),
        Shape::Vector | Shape::Matrix => Err(LatexError::new(
            term.expr.place,
            "the argument is no number",
        )),
    }
}

/// Whether an operand may belong to an argument without brackets: another function, a vector or a sum does not.
fn continues(item: &TexItem) -> bool {
    match &item.nucleus {
        Nucleus::Operator(_) | Nucleus::Big(_) => false,
        Nucleus::Letter(_, face) => *face != TexFace::Bold,
        _ => begins_operand(item),
    }
}

/// Whether a factor is a number, a multiple of pi or a fraction of these.
fn is_coefficient(expr: &Expr) -> bool {
    match &expr.node {
        Node::Number { .. } => true,
        Node::Name(name) => name == "pi",
        Node::Binary(Operator::Multiply | Operator::Divide, a, b) => {
            is_coefficient(a) && is_coefficient(b)
        }
        _ => false,
    }
}

/// The value of a function; cotangent, secant and cosecant are quotients, `\ln` is `log`, and `\arctan` is `atan`.
fn applied(name: &str, argument: Expr, place: Place) -> Term {
    let call =
        |name: &str, argument: Expr| Term::call(name, vec![argument], place, Shape::Number).expr;
    let over = |above: Expr, below: Expr| {
        Term::number(
            Node::Binary(Operator::Divide, Arc::new(above), Arc::new(below)),
            place,
        )
    };
    let one = || integer_at(1, place);
    match name {
        "cot" => over(call("cos", argument.clone()), call("sin", argument)),
        "sec" => over(one(), call("cos", argument)),
        "csc" => over(one(), call("sin", argument)),
        _ => {
            let name = match name {
                "ln" => "log",
                "arctan" => "atan",
                "arcsin" => "asin",
                "arccos" => "acos",
                own => own,
            };
            Term {
                expr: call(name, argument),
                shape: Shape::Number,
            }
        }
    }
}
