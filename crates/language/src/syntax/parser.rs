//! From tokens to a syntax tree: precedence climbing.

use super::SyntaxError;
use super::ast::{Connective, Expr, Node, Operator, Place, Relation};
use super::token::{Placed, Token, tokens};
use std::sync::Arc;
use torse_numbers::{Integer, Rational};

/// How deep brackets and prefixes may nest.
const MAX_DEPTH: usize = 100;

/// Parses a formula or a statement.
///
/// # Errors
/// [`SyntaxError`] with the place in `text`.
///
/// ```
/// use torse_language::syntax::parse;
/// assert!(parse("D(F1, z, 2)(0) == 2*(a + b)^2").is_ok());
/// let error = parse("2*(a + b").unwrap_err();
/// assert_eq!(error.to_string(), "this `(` is never closed");
/// ```
pub fn parse(text: &str) -> Result<Expr, SyntaxError> {
    let tokens = tokens(text)?;
    let mut parser = Parser {
        tokens,
        next: 0,
        end: text.len(),
        depth: 0,
    };
    let expr = parser.statement()?;
    match parser.peek() {
        None => Ok(expr),
        Some(_) => Err(parser.unexpected("an operator or the end of the formula")),
    }
}

struct Parser {
    tokens: Vec<Placed>,
    next: usize,
    end: usize,
    depth: usize,
}

impl Parser {
    fn peek(&self) -> Option<&Token> {
        self.tokens.get(self.next).map(|(token, _)| token)
    }

    fn place(&self) -> Place {
        self.tokens.get(self.next).map_or(
            Place {
                start: self.end,
                end: self.end,
            },
            |(_, place)| *place,
        )
    }

    fn unexpected(&self, expected: &'static str) -> SyntaxError {
        let found = match self.peek() {
            None => "the end of the formula".to_owned(),
            Some(Token::Number(text) | Token::Name(text)) => format!("`{text}`"),
            Some(Token::Sign(sign)) => format!("`{sign}`"),
        };
        SyntaxError::Unexpected {
            expected,
            found,
            place: self.place(),
        }
    }

    fn sign(&mut self, sign: &str) -> bool {
        let found = matches!(self.peek(), Some(Token::Sign(s)) if *s == sign);
        if found {
            self.next += 1;
        }
        found
    }

    fn word(&mut self, word: &str) -> bool {
        let found = matches!(self.peek(), Some(Token::Name(name)) if name == word);
        if found {
            self.next += 1;
        }
        found
    }

    /// Runs `inner` one level deeper.
    fn deeper(
        &mut self,
        inner: impl FnOnce(&mut Self) -> Result<Expr, SyntaxError>,
    ) -> Result<Expr, SyntaxError> {
        if self.depth >= MAX_DEPTH {
            return Err(SyntaxError::TooDeep {
                limit: MAX_DEPTH,
                place: self.place(),
            });
        }
        self.depth += 1;
        let result = inner(self);
        self.depth -= 1;
        result
    }

    fn statement(&mut self) -> Result<Expr, SyntaxError> {
        let left = self.disjunction()?;
        if self.word("implies") {
            let right = self.deeper(Self::statement)?;
            return Ok(join(Connective::Implies, left, right));
        }
        Ok(left)
    }

    fn disjunction(&mut self) -> Result<Expr, SyntaxError> {
        let mut left = self.conjunction()?;
        while self.word("or") {
            left = join(Connective::Or, left, self.conjunction()?);
        }
        Ok(left)
    }

    fn conjunction(&mut self) -> Result<Expr, SyntaxError> {
        let mut left = self.negation()?;
        while self.word("and") {
            left = join(Connective::And, left, self.negation()?);
        }
        Ok(left)
    }

    fn negation(&mut self) -> Result<Expr, SyntaxError> {
        let start = self.place();
        if self.word("not") {
            let inner = self.deeper(Self::negation)?;
            let place = start.to(inner.place);
            return Ok(Expr {
                node: Node::Not(Arc::new(inner)),
                place,
            });
        }
        self.comparison()
    }

    fn comparison(&mut self) -> Result<Expr, SyntaxError> {
        let first = self.sum()?;
        let mut rest = vec![];
        while let Some(relation) = self.relation() {
            rest.push((relation, self.sum()?));
        }
        match rest.last() {
            None => Ok(first),
            Some((_, last)) => {
                let place = first.place.to(last.place);
                Ok(Expr {
                    node: Node::Compare(Arc::new(first), rest),
                    place,
                })
            }
        }
    }

    fn relation(&mut self) -> Option<Relation> {
        const RELATIONS: [Relation; 6] = [
            Relation::Equal,
            Relation::Different,
            Relation::Less,
            Relation::AtMost,
            Relation::Greater,
            Relation::AtLeast,
        ];
        RELATIONS
            .into_iter()
            .find(|relation| self.sign(relation.sign()))
    }

    fn sum(&mut self) -> Result<Expr, SyntaxError> {
        let mut left = self.product()?;
        loop {
            let operator = if self.sign("+") {
                Operator::Add
            } else if self.sign("-") {
                Operator::Subtract
            } else {
                return Ok(left);
            };
            left = binary(operator, left, self.product()?);
        }
    }

    fn product(&mut self) -> Result<Expr, SyntaxError> {
        let mut left = self.prefixed()?;
        loop {
            let operator = if self.sign("*") {
                Operator::Multiply
            } else if self.sign("/") {
                Operator::Divide
            } else {
                return Ok(left);
            };
            left = binary(operator, left, self.prefixed()?);
        }
    }

    fn prefixed(&mut self) -> Result<Expr, SyntaxError> {
        let start = self.place();
        if self.sign("-") {
            let inner = self.deeper(Self::prefixed)?;
            let place = start.to(inner.place);
            return Ok(Expr {
                node: Node::Negative(Arc::new(inner)),
                place,
            });
        }
        let base = self.postfixed()?;
        if self.sign("^") {
            let exponent = self.deeper(Self::prefixed)?;
            return Ok(binary(Operator::Power, base, exponent));
        }
        Ok(base)
    }

    fn postfixed(&mut self) -> Result<Expr, SyntaxError> {
        let mut head = self.atom()?;
        loop {
            let open = self.place();
            if self.sign("(") {
                let arguments = self.listed("(", ")", open)?;
                let place = head.place.to(self.previous());
                head = Expr {
                    node: Node::Call(Arc::new(head), arguments),
                    place,
                };
            } else if self.sign("[") {
                let indices = self.listed("[", "]", open)?;
                let place = head.place.to(self.previous());
                head = Expr {
                    node: Node::Index(Arc::new(head), indices),
                    place,
                };
            } else {
                return Ok(head);
            }
        }
    }

    fn previous(&self) -> Place {
        self.next
            .checked_sub(1)
            .and_then(|i| self.tokens.get(i))
            .map_or_else(Place::default, |(_, place)| *place)
    }

    /// Items up to the closing bracket; at least one.
    fn listed(
        &mut self,
        bracket: &'static str,
        close: &'static str,
        open: Place,
    ) -> Result<Vec<Expr>, SyntaxError> {
        let mut items = vec![];
        loop {
            if self.peek().is_none() {
                return Err(SyntaxError::Unclosed {
                    bracket,
                    place: open,
                });
            }
            items.push(self.deeper(Self::statement)?);
            if self.sign(close) {
                return Ok(items);
            }
            if self.peek().is_none() {
                return Err(SyntaxError::Unclosed {
                    bracket,
                    place: open,
                });
            }
            if !self.sign(",") {
                return Err(self.unexpected(if close == ")" {
                    "`,` or `)`"
                } else {
                    "`,` or `]`"
                }));
            }
        }
    }

    fn atom(&mut self) -> Result<Expr, SyntaxError> {
        let place = self.place();
        match self.peek().cloned() {
            Some(Token::Number(text)) => {
                self.next += 1;
                Ok(Expr {
                    node: number(&text),
                    place,
                })
            }
            Some(Token::Name(name))
                if !["and", "or", "not", "implies"].contains(&name.as_str()) =>
            {
                self.next += 1;
                Ok(Expr {
                    node: Node::Name(name),
                    place,
                })
            }
            Some(Token::Sign("(")) => {
                self.next += 1;
                let inner = self.deeper(Self::statement)?;
                if self.sign(")") {
                    return Ok(Expr {
                        place: place.to(self.previous()),
                        ..inner
                    });
                }
                if self.peek().is_none() {
                    return Err(SyntaxError::Unclosed {
                        bracket: "(",
                        place,
                    });
                }
                Err(self.unexpected("`)` or an operator"))
            }
            Some(Token::Sign("[")) => {
                self.next += 1;
                let items = self.listed("[", "]", place)?;
                Ok(Expr {
                    node: Node::List(items),
                    place: place.to(self.previous()),
                })
            }
            _ => Err(self.unexpected("a number, a name or a bracket")),
        }
    }
}

fn join(connective: Connective, a: Expr, b: Expr) -> Expr {
    let place = a.place.to(b.place);
    Expr {
        node: Node::Join(connective, Arc::new(a), Arc::new(b)),
        place,
    }
}

fn binary(operator: Operator, a: Expr, b: Expr) -> Expr {
    let place = a.place.to(b.place);
    Expr {
        node: Node::Binary(operator, Arc::new(a), Arc::new(b)),
        place,
    }
}

/// Digits with an optional decimal point, exactly.
fn number(text: &str) -> Node {
    let (whole, fraction) = text.split_once('.').unwrap_or((text, ""));
    let digits = format!("{whole}{fraction}");
    let numerator = Integer::from_str_radix(&digits, 10).unwrap_or_default();
    let decimals = u32::try_from(fraction.len()).unwrap_or(u32::MAX);
    let value = Rational::new(numerator, Integer::from(10).pow(fraction.len()));
    Node::Number {
        value,
        decimals: text.contains('.').then_some(decimals),
    }
}
