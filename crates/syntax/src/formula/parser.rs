//! From tokens to a syntax tree: precedence climbing.
//!
//! Every traversal of a tree may recurse, because the parser bounds the height of trees. A chain of more than
//! [`MAX_UNGROUPED`] operands, which would be a left-leaning tree as high as the chain is long, becomes a chain of
//! groups, as if brackets were written; sums, products, conjunctions and disjunctions are associative. So a sum of
//! ten thousand terms is a tree of height 75, and its printed text is parsed to the same tree.

use super::SyntaxError;
use super::ast::{Connective, Expr, Node, Operator, Place, Relation};
use super::hints;
use super::token::{Placed, Token, tokens};
use std::sync::Arc;
use torse_numbers::fault_injection::{InjectedFault, injected};
use torse_numbers::{Integer, Rational};

/// The largest nesting depth of brackets and prefixes.
const MAX_DEPTH: usize = 100;
/// The largest height of a tree.
const MAX_HEIGHT: usize = 300;
/// The largest number of tokens of a formula: ten thousand terms such as `2*x^3*y` fit; formulas of papers have a few
/// hundred tokens.
const MAX_TOKENS: usize = 100_000;
/// The number of operands in a group of a long chain.
const GROUP: usize = 32;
/// A chain of at most this many operands is not grouped. The first group of a longer chain is written without
/// brackets, and so is the first group of that group. So the written chain has at most this many operands, and is not
/// grouped again when it is parsed.
const MAX_UNGROUPED: usize = 5 * GROUP;

/// Parses a formula or a statement.
///
/// # Errors
/// [`SyntaxError`] with the place in `text`.
///
/// ```
/// use torse_syntax::formula::parse;
/// assert!(parse("D(F1, z, 2)(0) == 2*(a + b)^2").is_ok());
/// let error = parse("2*(a + b").unwrap_err();
/// assert_eq!(error.to_string(), "this `(` is never closed");
/// ```
pub fn parse(text: &str) -> Result<Expr, SyntaxError> {
    let tokens = tokens(text)?;
    if let Some((_, place)) = tokens.get(MAX_TOKENS) {
        return Err(SyntaxError::TooLong {
            limit: MAX_TOKENS,
            found: tokens.len(),
            place: *place,
        });
    }
    let mut parser = Parser {
        tokens,
        next: 0,
        end: text.len(),
        depth: 0,
    };
    let tree = parser.statement()?;
    match parser.peek() {
        None => Ok(tree.expr),
        Some(_) => Err(parser.unexpected("an operator or the end of the formula")),
    }
}

/// A formula with the height of its tree.
struct Tree {
    expr: Expr,
    height: usize,
}

impl Tree {
    /// Makes a node over parts whose largest height is given.
    fn over(height: usize, node: Node, place: Place) -> Parsed {
        let height = height + 1;
        if height > MAX_HEIGHT {
            return Err(SyntaxError::TooHigh {
                limit: MAX_HEIGHT,
                place,
            });
        }
        let expr = Expr { node, place };
        Ok(Self { expr, height })
    }

    fn negative(start: Place, inner: Self) -> Parsed {
        let place = start.to(inner.expr.place);
        Self::over(inner.height, Node::Negative(Arc::new(inner.expr)), place)
    }

    fn binary(operator: Operator, a: Self, b: Self) -> Parsed {
        let place = a.expr.place.to(b.expr.place);
        let node = Node::Binary(operator, Arc::new(a.expr), Arc::new(b.expr));
        Self::over(a.height.max(b.height), node, place)
    }

    fn join(connective: Connective, a: Self, b: Self) -> Parsed {
        let place = a.expr.place.to(b.expr.place);
        let node = Node::Join(connective, Arc::new(a.expr), Arc::new(b.expr));
        Self::over(a.height.max(b.height), node, place)
    }
}

type Parsed = Result<Tree, SyntaxError>;

/// Joins a chain of operands, each with the operator before it, into one tree that groups to the left. The operator
/// of the first operand is `opening`. A long chain is divided into groups that begin after an `opening`, because only
/// there brackets do not change the value.
fn grouped<L: Copy + PartialEq>(
    mut links: Vec<(L, Tree)>,
    opening: L,
    join: impl Fn(L, Tree, Tree) -> Parsed,
) -> Result<Option<Tree>, SyntaxError> {
    let mut limit = MAX_UNGROUPED;
    loop {
        let short = links.len() <= limit;
        limit = 2 * GROUP;
        let mut groups: Vec<(L, Tree)> = vec![];
        let mut length = 0;
        for (link, tree) in links {
            match groups.pop() {
                Some((outer, group)) if short || length < GROUP || link != opening => {
                    groups.push((outer, join(link, group, tree)?));
                    length += 1;
                }
                last => {
                    groups.extend(last);
                    groups.push((link, tree));
                    length = 1;
                }
            }
        }
        if groups.len() <= 1 {
            return Ok(groups.pop().map(|(_, tree)| tree));
        }
        links = groups;
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
        let before = self.next.checked_sub(1).and_then(|i| self.tokens.get(i));
        SyntaxError::Unexpected {
            expected,
            found,
            help: hints::unexpected(
                before.map(|(token, _)| token),
                self.peek(),
                self.tokens.get(self.next + 1).map(|(token, _)| token),
            ),
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

    /// Parses `inner` one level deeper.
    fn deeper(&mut self, inner: impl FnOnce(&mut Self) -> Parsed) -> Parsed {
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

    /// Parses operands with operators between them; `link` parses the next operator if there is one.
    fn chain<L: Copy + PartialEq>(
        &mut self,
        opening: L,
        operand: impl Fn(&mut Self) -> Parsed,
        link: impl Fn(&mut Self) -> Option<L>,
        join: impl Fn(L, Tree, Tree) -> Parsed,
    ) -> Parsed {
        let mut links = vec![(opening, operand(self)?)];
        while let Some(link) = link(self) {
            links.push((link, operand(self)?));
        }
        grouped(links, opening, join)?.ok_or_else(|| self.unexpected("a formula"))
    }

    fn statement(&mut self) -> Parsed {
        let left = self.disjunction()?;
        if self.word("implies") {
            let right = self.deeper(Self::statement)?;
            return Tree::join(Connective::Implies, left, right);
        }
        Ok(left)
    }

    fn disjunction(&mut self) -> Parsed {
        let or = |parser: &mut Self| parser.word("or").then_some(Connective::Or);
        self.chain(Connective::Or, Self::conjunction, or, Tree::join)
    }

    fn conjunction(&mut self) -> Parsed {
        let and = |parser: &mut Self| parser.word("and").then_some(Connective::And);
        self.chain(Connective::And, Self::negation, and, Tree::join)
    }

    fn negation(&mut self) -> Parsed {
        let start = self.place();
        if self.word("not") {
            let inner = self.deeper(Self::negation)?;
            let place = start.to(inner.expr.place);
            return Tree::over(inner.height, Node::Not(Arc::new(inner.expr)), place);
        }
        self.comparison()
    }

    fn comparison(&mut self) -> Parsed {
        let first = self.sum()?;
        let mut height = first.height;
        let mut rest = vec![];
        while let Some(relation) = self.relation() {
            let side = self.sum()?;
            height = height.max(side.height);
            rest.push((relation, side.expr));
        }
        match rest.last() {
            None => Ok(first),
            Some((_, last)) => {
                let place = first.expr.place.to(last.place);
                Tree::over(height, Node::Compare(Arc::new(first.expr), rest), place)
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

    /// Parses one of these operators if it comes next.
    fn operator(&mut self, operators: [Operator; 2]) -> Option<Operator> {
        operators
            .into_iter()
            .find(|operator| self.sign(operator.sign()))
    }

    fn sum(&mut self) -> Parsed {
        let signs = |parser: &mut Self| parser.operator([Operator::Add, Operator::Subtract]);
        if injected(InjectedFault::DifferenceFromTheRight) {
            let left = self.product()?;
            return match signs(self) {
                Some(sign) => Tree::binary(sign, left, self.sum()?),
                None => Ok(left),
            };
        }
        self.chain(Operator::Add, Self::product, signs, Tree::binary)
    }

    fn product(&mut self) -> Parsed {
        let signs = |parser: &mut Self| parser.operator([Operator::Multiply, Operator::Divide]);
        self.chain(Operator::Multiply, Self::prefixed, signs, Tree::binary)
    }

    fn prefixed(&mut self) -> Parsed {
        let start = self.place();
        let base = match self.sign("-") {
            true if injected(InjectedFault::SignBeforePower) => {
                Tree::negative(start, self.postfixed()?)?
            }
            true => return Tree::negative(start, self.deeper(Self::prefixed)?),
            false => self.postfixed()?,
        };
        if self.sign("^") {
            self.no_power_of_a_function(&base.expr)?;
            let exponent = self.deeper(Self::prefixed)?;
            return Tree::binary(Operator::Power, base, exponent);
        }
        Ok(base)
    }

    /// Refuses a power of a function such as `sin^2(x)`.
    fn no_power_of_a_function(&self, base: &Expr) -> Result<(), SyntaxError> {
        let ahead = |offset| self.tokens.get(self.next + offset);
        match (&base.node, ahead(0), ahead(1)) {
            (Node::Name(name), Some((Token::Number(n), place)), Some((Token::Sign("("), _))) => {
                Err(SyntaxError::NoFunction {
                    what: format!("the number {n}"),
                    help: format!(
                        "the power of a function is written `{name}(x)^{n}`, a product `{name}^{n}*(x)`"
                    ),
                    place: *place,
                })
            }
            _ => Ok(()),
        }
    }

    fn postfixed(&mut self) -> Parsed {
        let mut head = self.atom()?;
        loop {
            let open = self.place();
            if self.sign("(") {
                if let Some(what) = hints::kind_if_not_function(&head.expr.node) {
                    return Err(SyntaxError::NoFunction {
                        what,
                        help: "a product is written with `*`".to_owned(),
                        place: open,
                    });
                }
                let (arguments, height) = self.listed("(", ")", open)?;
                let place = head.expr.place.to(self.previous());
                let node = Node::Call(Arc::new(head.expr), arguments);
                head = Tree::over(head.height.max(height), node, place)?;
            } else if self.sign("[") {
                let (indices, height) = self.listed("[", "]", open)?;
                let place = head.expr.place.to(self.previous());
                let node = Node::Index(Arc::new(head.expr), indices);
                head = Tree::over(head.height.max(height), node, place)?;
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

    /// Parses items up to the closing bracket, at least one; also returns the largest height of an item.
    fn listed(
        &mut self,
        bracket: &'static str,
        close: &'static str,
        open: Place,
    ) -> Result<(Vec<Expr>, usize), SyntaxError> {
        let (mut items, mut height) = (vec![], 0);
        loop {
            if self.peek().is_none() {
                return Err(SyntaxError::Unclosed {
                    bracket,
                    place: open,
                });
            }
            let item = self.deeper(Self::statement)?;
            height = height.max(item.height);
            items.push(item.expr);
            if self.sign(close) {
                return Ok((items, height));
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

    fn atom(&mut self) -> Parsed {
        let place = self.place();
        match self.peek().cloned() {
            Some(Token::Number(text)) => {
                self.next += 1;
                Tree::over(0, number(&text), place)
            }
            Some(Token::Name(name)) if !super::WORDS.contains(&name.as_str()) => {
                self.next += 1;
                Tree::over(0, Node::Name(name), place)
            }
            Some(Token::Sign("(")) => {
                self.next += 1;
                let inner = self.deeper(Self::statement)?;
                if self.sign(")") {
                    let place = place.to(self.previous());
                    let expr = Expr {
                        place,
                        ..inner.expr
                    };
                    return Ok(Tree { expr, ..inner });
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
                let (items, height) = self.listed("[", "]", place)?;
                Tree::over(height, Node::List(items), place.to(self.previous()))
            }
            _ => Err(self.unexpected("a number, a name or a bracket")),
        }
    }
}

/// The exact value of digits with an optional decimal point.
fn number(text: &str) -> Node {
    let (whole, fraction) = text.split_once('.').unwrap_or((text, ""));
    let digits = format!("{whole}{fraction}");
    let numerator = Integer::from_str_radix(&digits, 10).unwrap_or_default();
    let decimals = u32::try_from(fraction.len()).unwrap_or(u32::MAX);
    let value = Rational::new(numerator, Integer::from(10).pow(fraction.len()));
    Node::Number {
        value,
        decimals: (text.contains('.') && !injected(InjectedFault::DecimalsForgotten))
            .then_some(decimals),
    }
}
