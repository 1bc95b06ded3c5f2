//! Sums, products, quotients and powers.
//!
//! A product is implied between two operands side by side. A slash divides by the operand behind it; if another operand
//! follows without a sign, `1/2x`, there are two readings. `\cdot` between vectors is the scalar product, `\times` the vector
//! product; two vectors side by side have no reading.

use super::error::LatexError;
use super::item::{Nucleus, TexItem, place_of};
use super::names::parts;
use super::reader::{Line, ReadTerm, Reader, Shape, Term};
use crate::formula::{Expr, Node, Operator, Place};
use std::sync::Arc;
use torse_numbers::{Integer, Rational};

/// The largest number of terms or factors side by side.
const MAX_OPERANDS: usize = 150;

impl Reader<'_> {
    /// Reads a whole list as a formula with a value.
    pub fn whole(&mut self, items: &[TexItem], around: Place) -> ReadTerm {
        let mut line = Line::new(items, around);
        let term = self.deeper(around, |reader| reader.sum(&mut line))?;
        match line.peek() {
            None => Ok(term),
            Some(item) => Err(unexpected(item)),
        }
    }

    /// Reads a sum.
    pub fn sum(&mut self, line: &mut Line<'_>) -> ReadTerm {
        let start = line.place();
        let before = self.ended_indices(line);
        let negative = line.sign("-");
        if !negative {
            line.sign("+");
        }
        let mut total = self.product(line)?;
        if negative {
            total = negated(total, start);
        }
        for _ in 0..MAX_OPERANDS {
            let operator = match line.peek() {
                Some(item) if item.is_sign("+") => Operator::Add,
                Some(item) if item.is_sign("-") => Operator::Subtract,
                Some(item) if item.is_sign("pm") || item.is_sign("mp") => {
                    let error = LatexError::new(item.place, "two signs at once are two statements");
                    return Err(error.with_help("write one of them"));
                }
                _ => {
                    self.no_index_outside(&total.expr, &before)?;
                    return Ok(total);
                }
            };
            line.next += 1;
            let term = self.product(line)?;
            if total.shape != term.shape && !is_zero(&total.expr) && !is_zero(&term.expr) {
                let place = total.expr.place.to(term.expr.place);
                return Err(LatexError::new(
                    place,
                    "these terms have different shapes: a number and a vector or a matrix",
                ));
            }
            let shape = if is_zero(&total.expr) {
                term.shape
            } else {
                total.shape
            };
            total = Term::binary(operator, total.expr, term.expr, shape);
        }
        Err(LatexError::new(
            line.place(),
            format!("more than {MAX_OPERANDS} terms"),
        ))
    }

    /// Reads a product up to a sign that binds more loosely.
    pub fn product(&mut self, line: &mut Line<'_>) -> ReadTerm {
        let mut left = self.factor(line)?;
        for _ in 0..MAX_OPERANDS {
            let Some(item) = line.peek() else {
                return Ok(left);
            };
            let sign = ["cdot", "times", "*", "/"]
                .into_iter()
                .find(|sign| item.is_sign(sign));
            left = match sign {
                Some("/") => {
                    line.next += 1;
                    self.quotient(left, line)?
                }
                Some(sign) => {
                    line.next += 1;
                    let right = self.factor(line)?;
                    multiplied(left, sign, right)?
                }
                None if begins_operand(item) => {
                    if matches!(item.nucleus, Nucleus::Number(_)) {
                        let error =
                            LatexError::new(item.place, "a number stands right behind an operand");
                        return Err(error.with_help("write `\\cdot`"));
                    }
                    let right = self.factor(line)?;
                    multiplied(left, "", right)?
                }
                None => return Ok(left),
            };
        }
        Err(LatexError::new(
            line.place(),
            format!("more than {MAX_OPERANDS} factors"),
        ))
    }

    /// Reads what is behind a slash.
    fn quotient(&mut self, left: Term, line: &mut Line<'_>) -> ReadTerm {
        let start = line.place();
        let mut below = self.factor(line)?;
        let follows = line.peek().is_some_and(begins_operand);
        if follows {
            let says = [
                "only what is right behind the slash divides",
                "all that follows the slash divides",
            ];
            let all = self.choose(format!("slash {}", start.start), start, says) == 1;
            if all {
                while line.peek().is_some_and(begins_operand) {
                    let right = self.factor(line)?;
                    below = multiplied(below, "", right)?;
                }
            }
        }
        divided(left, below)
    }

    /// The exponent or another meaning of a superscript.
    pub fn raised(&mut self, base: Term, above: &[TexItem]) -> ReadTerm {
        let place = base.expr.place.to(place_of(above, base.expr.place));
        if let [only] = above
            && only.is_bare()
        {
            let transposed = only.is_sign("top")
                || matches!(&only.nucleus, Nucleus::Letter(letter, _) if letter == "T" && base.shape != Shape::Number && self.names.kind("T").is_none());
            if transposed {
                return match base.shape {
                    Shape::Matrix => Ok(Term::call(
                        "transpose",
                        vec![base.expr],
                        place,
                        Shape::Matrix,
                    )),
                    Shape::Vector => Ok(base),
                    Shape::Number => Err(LatexError::new(place, "a number is transposed")),
                };
            }
            if matches!(&only.nucleus, Nucleus::Sign(_))
                || matches!(&only.nucleus, Nucleus::Fenced(..)) && base.shape != Shape::Number
            {
                return Err(LatexError::new(
                    only.place,
                    "this superscript is not understood",
                ));
            }
            if let Nucleus::Fenced('(', inner, ')') = &only.nucleus
                && matches!(inner.as_slice(), [one] if matches!(one.nucleus, Nucleus::Number(_) | Nucleus::Letter(..)))
            {
                let error = LatexError::new(
                    only.place,
                    "this superscript in brackets may be a power, a derivative or a number of a step",
                );
                return Err(error);
            }
        }
        let exponent = self.whole(above, place)?;
        if exponent.shape != Shape::Number {
            return Err(LatexError::new(place, "the exponent is no number"));
        }
        match base.shape {
            Shape::Number => {}
            Shape::Matrix if is_minus_one(&exponent.expr) => {
                return Ok(Term::call("inverse", vec![base.expr], place, Shape::Matrix));
            }
            Shape::Vector | Shape::Matrix => {
                let error =
                    LatexError::new(place, "a power of a vector or a matrix is not understood");
                return Err(error.with_help("write `\\lVert a \\rVert^2`, or `a \\cdot a`"));
            }
        }
        if let Some(halves) = halves(&exponent.expr) {
            return Ok(power_of_root(base.expr, &halves, place));
        }
        let node = Node::Binary(
            Operator::Power,
            Arc::new(base.expr),
            Arc::new(exponent.expr),
        );
        Ok(Term::number(node, place))
    }

    /// A list in round brackets: a value, or a vector by its coordinates.
    pub fn bracketed(&mut self, inner: &[TexItem], place: Place) -> ReadTerm {
        let entries = parts(inner);
        if entries.len() == 1 {
            let mut term = self.whole(inner, place)?;
            term.expr.place = place;
            return Ok(term);
        }
        let mut list = vec![];
        for entry in entries {
            let term = self.whole(entry, place)?;
            if term.shape != Shape::Number {
                let error = LatexError::new(
                    place,
                    "a list of vectors in brackets may be a determinant, a product or a matrix",
                );
                return Err(error.with_help("write `\\det(a, b, c)`, or a matrix"));
            }
            list.push(term.expr);
        }
        Ok(Term::new(Node::List(list), place, Shape::Vector))
    }

    /// The indices that sums at the top of a formula bind, and that nothing else declares.
    fn ended_indices(&self, line: &Line<'_>) -> Vec<String> {
        let mut found = vec![];
        for item in line.rest() {
            if let (Nucleus::Big(_), Some(below)) = (&item.nucleus, &item.below)
                && let Some(TexItem {
                    nucleus: Nucleus::Letter(index, _),
                    ..
                }) = below.first()
            {
                found.push(index.clone());
            }
        }
        found
    }

    /// Refuses a formula in which the index of a sum occurs behind the end of the sum: `\sum_i a_i + b_i`.
    fn no_index_outside(&self, formula: &Expr, indices: &[String]) -> Result<(), LatexError> {
        for index in indices {
            let is_around = self.bound.contains(index);
            if !is_around && occurs_free(formula, index) {
                let message = format!(
                    "the index `{index}` of a sum also occurs outside of it: where does the sum end?"
                );
                return Err(LatexError::new(formula.place, message)
                    .with_help("put what is summed in brackets"));
            }
        }
        Ok(())
    }
}

/// Whether a name occurs that no sum, product or integral inside binds.
fn occurs_free(formula: &Expr, name: &str) -> bool {
    if let Node::Call(head, arguments) = &formula.node
        && let Node::Name(called) = &head.node
        && matches!(called.as_str(), "sum" | "product")
        && let [index, low, high, body] = arguments.as_slice()
        && matches!(&index.node, Node::Name(own) if own == name)
    {
        let _ = body;
        return occurs_free(low, name) || occurs_free(high, name);
    }
    match &formula.node {
        Node::Name(own) => own == name,
        _ => formula
            .parts()
            .into_iter()
            .any(|part| occurs_free(part, name)),
    }
}

/// Whether an item begins an operand, so that a product is implied before it.
pub(super) fn begins_operand(item: &TexItem) -> bool {
    match &item.nucleus {
        Nucleus::Sign(_) | Nucleus::Words(_) | Nucleus::Dots => false,
        Nucleus::Number(_)
        | Nucleus::Letter(..)
        | Nucleus::Operator(_)
        | Nucleus::Fenced(..)
        | Nucleus::Group(_)
        | Nucleus::Fraction(..)
        | Nucleus::Root(..)
        | Nucleus::Binomial(..)
        | Nucleus::Grid(..)
        | Nucleus::Dotted(..)
        | Nucleus::Big(_) => true,
    }
}

/// The error for an item that cannot stand where it stands.
pub(super) fn unexpected(item: &TexItem) -> LatexError {
    let message = match &item.nucleus {
        Nucleus::Dots => "an ellipsis leaves out what is meant".to_owned(),
        Nucleus::Words(words) => format!("the words \"{words}\" are not understood in a formula"),
        Nucleus::Sign(sign) => format!("`{sign}` is not understood here"),
        _ => "this is not understood here".to_owned(),
    };
    let error = LatexError::new(item.place, message);
    match &item.nucleus {
        Nucleus::Dots => error.with_help("write a sum, a product or a range with its bounds"),
        _ => error,
    }
}

pub(super) fn negated(term: Term, start: Place) -> Term {
    let place = start.to(term.expr.place);
    Term::new(Node::Negative(Arc::new(term.expr)), place, term.shape)
}

/// Multiplies by the sign between the factors; none is an implied product.
pub(super) fn multiplied(a: Term, sign: &str, b: Term) -> ReadTerm {
    use Shape::{Matrix, Number, Vector};
    let place = a.expr.place.to(b.expr.place);
    let wrong = |message: &str| Err(LatexError::new(place, message));
    let shape = match (a.shape, sign, b.shape) {
        (Vector, "cdot", Vector) => {
            return Ok(Term::call("dot", vec![a.expr, b.expr], place, Number));
        }
        (Vector, "times", Vector) => {
            return Ok(Term::call("cross", vec![a.expr, b.expr], place, Vector));
        }
        (Vector, _, Vector) => {
            return wrong("between two vectors stands neither `\\cdot` nor `\\times`");
        }
        (Vector, "times", Number) | (Number, "times", Vector)
            if !is_digits(&a.expr) && !is_digits(&b.expr) =>
        {
            return wrong("`\\times` stands between a number and a vector");
        }
        (Number, _, shape) | (shape, _, Number) => shape,
        (Matrix, "times", _) | (_, "times", Matrix) => {
            return wrong("`\\times` stands beside a matrix");
        }
        (Matrix, _, shape) => shape,
        (Vector, _, Matrix) => return wrong("a vector stands before a matrix"),
    };
    Ok(Term::binary(Operator::Multiply, a.expr, b.expr, shape))
}

/// Divides.
pub(super) fn divided(a: Term, b: Term) -> ReadTerm {
    if b.shape != Shape::Number {
        return Err(LatexError::new(
            b.expr.place,
            "this divides, and is no number",
        ));
    }
    Ok(Term::binary(Operator::Divide, a.expr, b.expr, a.shape))
}

fn is_digits(expr: &Expr) -> bool {
    matches!(expr.node, Node::Number { .. })
}

pub(super) fn is_zero(expr: &Expr) -> bool {
    matches!(&expr.node, Node::Number { value, .. } if *value == Rational::from_integer(Integer::from(0)))
}

fn is_minus_one(expr: &Expr) -> bool {
    let one = Rational::from_integer(Integer::from(1));
    matches!(&expr.node, Node::Negative(inner) if matches!(&inner.node, Node::Number { value, .. } if *value == one))
}

/// The odd number of halves that an exponent is, with its sign.
fn halves(exponent: &Expr) -> Option<(bool, Expr)> {
    let (negative, inner) = match &exponent.node {
        Node::Negative(inner) => (true, &**inner),
        _ => (false, exponent),
    };
    let Node::Binary(Operator::Divide, over, two) = &inner.node else {
        return None;
    };
    let (over, negative) = match &over.node {
        Node::Negative(over) => (over, !negative),
        _ => (over, negative),
    };
    let is_two = matches!(&two.node, Node::Number { value, .. } if *value == Rational::from_integer(Integer::from(2)));
    (is_two && is_digits(over)).then(|| (negative, (**over).clone()))
}

/// `x^{n/2}` is the n-th power of the root of x.
fn power_of_root(base: Expr, (negative, over): &(bool, Expr), place: Place) -> Term {
    let one = Expr::number(&Rational::from_integer(Integer::from(1)));
    let root = Term::call("sqrt", vec![base], place, Shape::Number).expr;
    let power = match over.placeless() == one {
        true => root,
        false => Expr {
            node: Node::Binary(Operator::Power, Arc::new(root), Arc::new(over.clone())),
            place,
        },
    };
    match negative {
        false => Term {
            expr: power,
            shape: Shape::Number,
        },
        true => Term::number(
            Node::Binary(
                Operator::Divide,
                Arc::new(Expr { place, ..one }),
                Arc::new(power),
            ),
            place,
        ),
    }
}
