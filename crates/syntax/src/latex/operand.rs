//! One operand: a number, a name, a bracket, a fraction, a root, a matrix, a function with its argument.

use super::arithmetic::unexpected;
use super::error::LatexError;
use super::item::{Nucleus, TexItem, place_of};
use super::names::parts;
use super::reader::{Line, ReadTerm, Reader, Shape, Term};
use crate::formula::{Expr, Node, Place, parse};

impl Reader<'_> {
    /// Reads the next operand with its scripts.
    pub fn factor(&mut self, line: &mut Line<'_>) -> ReadTerm {
        let place = line.place();
        self.deeper(place, |reader| reader.operand(line))
    }

    fn operand(&mut self, line: &mut Line<'_>) -> ReadTerm {
        let Some(item) = line.peek() else {
            return Err(LatexError::new(line.place(), "an operand is missing"));
        };
        let place = item.place;
        let term = match &item.nucleus {
            Nucleus::Letter(..) => self.name(line)?,
            Nucleus::Operator(name) => self.function(line, name)?,
            Nucleus::Dotted(count, inner) => self.dotted(line, item, *count, inner)?,
            Nucleus::Big(kind) => self.big(line, kind)?,
            Nucleus::Fraction(over, under) => {
                if let Some(term) = self.derivative(line, over, under)? {
                    // Of what is written behind the quotient nobody knows whether it is the derivative's or its operand's.
                    if !item.is_bare() {
                        return Err(LatexError::new(
                            place,
                            "a quotient of differentials has a script: is it that of the derivative?",
                        )
                        .with_help("put the derivative in brackets"));
                    }
                    term
                } else {
                    line.next += 1;
                    let (above, below) = (self.whole(over, place)?, self.whole(under, place)?);
                    let mut term = super::arithmetic::divided(above, below)?;
                    term.expr.place = place;
                    self.scripted(item, term)?
                }
            }
            Nucleus::Sign(_) | Nucleus::Words(_) | Nucleus::Dots => return Err(unexpected(item)),
            _ => {
                line.next += 1;
                let term = self.closed(item)?;
                self.scripted(item, term)?
            }
        };
        self.factorials(line, term)
    }

    /// A letter under dots: a dot is a derivative by the function's own variable.
    fn dotted(
        &mut self,
        line: &mut Line<'_>,
        item: &TexItem,
        count: usize,
        inner: &[TexItem],
    ) -> ReadTerm {
        let [
            TexItem {
                nucleus: Nucleus::Letter(..),
                ..
            },
        ] = inner
        else {
            return Err(LatexError::new(
                item.place,
                "dots stand over more than a letter",
            ));
        };
        let mut letter = inner.first().cloned().unwrap_or_else(|| item.clone());
        letter.primes += count + item.primes;
        letter.place = item.place;
        letter.below = item.below.clone().or(letter.below);
        letter.above = item.above.clone().or(letter.above);
        let mut list = vec![letter];
        list.extend(line.items.get(line.next + 1).cloned());
        let mut own = Line::new(&list, item.place);
        let term = self.name(&mut own)?;
        line.next += own.next;
        Ok(term)
    }

    /// Takes a factorial sign, with the exponent that may stand behind it.
    fn factorials(&mut self, line: &mut Line<'_>, term: Term) -> ReadTerm {
        let Some(sign) = line.peek().filter(|item| item.is_sign("!")) else {
            return Ok(term);
        };
        line.next += 1;
        let place = term.expr.place.to(sign.place);
        let term = Term::call("factorial", vec![term.expr], place, Shape::Number);
        if line.peek().is_some_and(|next| next.is_sign("!")) {
            let error = LatexError::new(
                place,
                "two signs `!` may be a double factorial, or the factorial of one",
            );
            return Err(error.with_help("write `(n!)!`, or the product"));
        }
        self.scripted(sign, term)
    }

    /// Reads an item that is complete in itself, without its scripts.
    fn closed(&mut self, item: &TexItem) -> ReadTerm {
        let place = item.place;
        match &item.nucleus {
            Nucleus::Number(digits) => match parse(digits) {
                Ok(number) => Ok(Term::number(number.node, place)),
                Err(_) => Err(LatexError::new(place, "this number is too long")),
            },
            Nucleus::Fenced(open, inner, close) => self.fenced(item, *open, inner, *close),
            Nucleus::Group(_) => Err(LatexError::new(
                place,
                "several operands in braces have scripts in common",
            )
            .with_help("write brackets")),
            Nucleus::Root(None, inner) => {
                let inner = self.value(inner, place, "the root")?;
                Ok(Term::call("sqrt", vec![inner], place, Shape::Number))
            }
            Nucleus::Root(Some(degree), inner) => match degree.as_slice() {
                [
                    TexItem {
                        nucleus: Nucleus::Number(two),
                        ..
                    },
                ] if two == "2" => {
                    let inner = self.value(inner, place, "the root")?;
                    Ok(Term::call("sqrt", vec![inner], place, Shape::Number))
                }
                _ => Err(LatexError::new(
                    place,
                    "of roots the language has square roots alone",
                )),
            },
            Nucleus::Binomial(n, k) => {
                let (n, k) = (
                    self.value(n, place, "the binomial")?,
                    self.value(k, place, "the binomial")?,
                );
                Ok(Term::call("binom", vec![n, k], place, Shape::Number))
            }
            Nucleus::Grid(name, rows) => self.grid(name, rows, place),
            _ => Err(unexpected(item)),
        }
    }

    /// Adds the scripts and primes of an item to its value.
    fn scripted(&mut self, item: &TexItem, term: Term) -> ReadTerm {
        if matches!(item.nucleus, Nucleus::Fenced('.', ..)) {
            return match &item.above {
                None => Ok(term),
                Some(above) => Err(LatexError::new(
                    place_of(above, item.place),
                    "this superscript is not understood",
                )),
            };
        }
        if item.primes > 0 {
            let error = LatexError::new(
                item.place,
                "a prime behind this does not say by what is differentiated",
            );
            return Err(error.with_help("write `\\frac{d}{dt}`"));
        }
        if let Some(below) = &item.below {
            return self.component(term, below, item.place);
        }
        match &item.above {
            None => Ok(term),
            Some(above) => self.raised(term, above),
        }
    }

    /// A coordinate of a bracket, or an entry of a matrix.
    fn component(&mut self, term: Term, below: &[TexItem], place: Place) -> ReadTerm {
        let indices = parts(below);
        let wanted = match term.shape {
            Shape::Vector => 1,
            Shape::Matrix => 2,
            Shape::Number => 0,
        };
        if wanted == 0 || indices.len() != wanted {
            return Err(LatexError::new(
                place_of(below, place),
                "this subscript is not understood",
            ));
        }
        let mut found = vec![];
        for index in indices {
            found.push(self.value(index, place, "the index")?);
        }
        Ok(Term::number(
            Node::Index(std::sync::Arc::new(term.expr), found),
            place,
        ))
    }

    /// Reads a list whose value has to be a number.
    pub fn value(
        &mut self,
        list: &[TexItem],
        around: Place,
        what: &str,
    ) -> Result<Expr, LatexError> {
        let term = self.whole(list, around)?;
        match term.shape {
            Shape::Number => Ok(term.expr),
            Shape::Vector | Shape::Matrix => Err(LatexError::new(
                term.expr.place,
                format!("{what} is of a vector or a matrix"),
            )),
        }
    }

    fn fenced(&mut self, item: &TexItem, open: char, inner: &[TexItem], close: char) -> ReadTerm {
        let place = item.place;
        match (open, close) {
            ('(', ')') => {
                // A grid in brackets is a matrix.
                if let [
                    TexItem {
                        nucleus: Nucleus::Grid(name, rows),
                        ..
                    },
                ] = inner
                    && matches!(name.as_str(), "array" | "matrix" | "smallmatrix")
                {
                    return self.grid("pmatrix", rows, place);
                }
                self.bracketed(inner, place)
            }
            ('[', ']') => {
                if let [
                    TexItem {
                        nucleus: Nucleus::Grid(name, rows),
                        ..
                    },
                ] = inner
                    && matches!(name.as_str(), "array" | "matrix" | "smallmatrix")
                {
                    return self.grid("bmatrix", rows, place);
                }
                if parts(inner).len() == 2 {
                    return Err(LatexError::new(
                        place,
                        "this may be an interval or a vector",
                    ));
                }
                self.bracketed(inner, place)
            }
            ('{', '}') if parts(inner).len() == 1 => self.bracketed(inner, place),
            ('|', '|') => {
                if let [
                    TexItem {
                        nucleus: Nucleus::Grid(name, rows),
                        ..
                    },
                ] = inner
                    && matches!(name.as_str(), "array" | "matrix" | "smallmatrix")
                {
                    return self.grid("vmatrix", rows, place);
                }
                let term = self.whole(inner, place)?;
                let name = match term.shape {
                    Shape::Number => "abs",
                    Shape::Vector => "norm",
                    Shape::Matrix => "det",
                };
                Ok(Term::call(name, vec![term.expr], place, Shape::Number))
            }
            ('‖', '‖') => {
                let term = self.whole(inner, place)?;
                if term.shape != Shape::Vector {
                    let error = LatexError::new(place, "the norm is not of a vector");
                    return Err(error.with_help("declare what is a vector"));
                }
                Ok(Term::call("norm", vec![term.expr], place, Shape::Number))
            }
            ('⟨', '⟩') => {
                let entries = parts(inner);
                let [a, b] = entries.as_slice() else {
                    return Err(LatexError::new(place, "angle brackets hold two vectors"));
                };
                let (a, b) = (self.whole(a, place)?, self.whole(b, place)?);
                if a.shape != Shape::Vector || b.shape != Shape::Vector {
                    return Err(LatexError::new(place, "angle brackets hold two vectors"));
                }
                Ok(Term::call(
                    "dot",
                    vec![a.expr, b.expr],
                    place,
                    Shape::Number,
                ))
            }
            ('.', '|') => self.at_a_point(item, inner),
            _ => Err(LatexError::new(
                place,
                "these brackets are not understood here",
            )),
        }
    }

    /// `\left. f \right|_{x = a}`.
    fn at_a_point(&mut self, item: &TexItem, inner: &[TexItem]) -> ReadTerm {
        let place = item.place;
        let below = item.below.as_deref().unwrap_or(&[]);
        let equals = below.iter().position(|sign| sign.is_sign("="));
        let Some((variable, value)) =
            equals.and_then(|at| Some((below.get(..at)?, below.get(at + 1..)?)))
        else {
            return Err(LatexError::new(
                place,
                "the bar does not say at which value: `|_{t = 0}`",
            ));
        };
        let body = self.whole(inner, place)?;
        let variable = self.whole(variable, place)?.expr;
        if !matches!(variable.node, Node::Name(_)) {
            return Err(LatexError::new(place, "the bar does not name a variable"));
        }
        let value = self.value(value, place, "the place")?;
        Ok(Term::call(
            "at",
            vec![body.expr, variable, value],
            place,
            body.shape,
        ))
    }

    /// A matrix by its rows; a column is a vector, bars are the determinant.
    fn grid(&mut self, name: &str, rows: &[Vec<Vec<TexItem>>], place: Place) -> ReadTerm {
        if matches!(name, "cases" | "dcases") {
            return Err(
                LatexError::new(place, "formulas by cases are not in the language")
                    .with_help("state each case as a claim with its assumption"),
            );
        }
        if !matches!(name, "pmatrix" | "bmatrix" | "vmatrix") {
            return Err(LatexError::new(
                place,
                format!(
                    "a `{name}` without round brackets, square brackets or bars is not understood"
                ),
            ));
        }
        let width = rows.first().map_or(0, Vec::len);
        if width == 0 || rows.iter().any(|row| row.len() != width) {
            return Err(LatexError::new(place, "the rows have different lengths"));
        }
        let mut entries = vec![];
        for row in rows {
            let mut line = vec![];
            for cell in row {
                line.push(self.value(cell, place, "an entry")?);
            }
            entries.push(line);
        }
        if width == 1 && name != "vmatrix" {
            return Ok(Term::new(
                Node::List(entries.into_iter().flatten().collect()),
                place,
                Shape::Vector,
            ));
        }
        let rows = entries.into_iter().map(|row| Expr {
            node: Node::List(row),
            place,
        });
        let matrix = Expr {
            node: Node::List(rows.collect()),
            place,
        };
        match name {
            "vmatrix" => Ok(Term::call("det", vec![matrix], place, Shape::Number)),
            _ => Ok(Term {
                expr: matrix,
                shape: Shape::Matrix,
            }),
        }
    }
}
