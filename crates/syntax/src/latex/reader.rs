//! The state of reading a list of items: the names, the choices where a formula can be read in two ways, and a cursor.

use super::error::LatexError;
use super::item::{Nucleus, TexItem};
use super::names::LatexNames;
use crate::formula::{Expr, Node, Operator, Place};
use std::collections::BTreeMap;
use std::sync::Arc;
use torse_numbers::{Integer, Rational};

/// How deep operators without brackets may be nested.
const MAX_READ_DEPTH: usize = 40;

/// A place that can be read in two ways.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LatexDoubt {
    /// Where.
    pub place: Place,
    /// The two readings in words.
    pub says: [String; 2],
    /// What the choice is about: one choice is made for all places with this key.
    pub(super) key: String,
}

/// The shape of a value, as far as it is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Shape {
    Number,
    Vector,
    Matrix,
}

/// A formula with the shape of its values.
#[derive(Debug, Clone)]
pub(super) struct Term {
    pub expr: Expr,
    pub shape: Shape,
}

impl Term {
    pub fn new(node: Node, place: Place, shape: Shape) -> Self {
        let expr = Expr { node, place };
        Self { expr, shape }
    }

    pub fn number(node: Node, place: Place) -> Self {
        Self::new(node, place, Shape::Number)
    }

    /// The application of a function of the language.
    pub fn call(name: &str, arguments: Vec<Expr>, place: Place, shape: Shape) -> Self {
        let head = Expr {
            node: Node::Name(name.to_owned()),
            place,
        };
        Self::new(Node::Call(Arc::new(head), arguments), place, shape)
    }

    /// The derivative of a formula by a variable.
    pub fn derivative(body: Expr, variable: &str, order: u64, place: Place, shape: Shape) -> Self {
        let by = Expr {
            node: Node::Name(variable.to_owned()),
            place,
        };
        let mut arguments = vec![body, by];
        if order > 1 {
            arguments.push(integer_at(order, place));
        }
        Self::call("D", arguments, place, shape)
    }

    pub fn binary(operator: Operator, a: Expr, b: Expr, shape: Shape) -> Self {
        let place = a.place.to(b.place);
        Self::new(
            Node::Binary(operator, Arc::new(a), Arc::new(b)),
            place,
            shape,
        )
    }
}

/// An integer that stands for something at a place.
pub(super) fn integer_at(value: u64, place: Place) -> Expr {
    Expr {
        place,
        ..Expr::number(&Rational::from_integer(Integer::from(value)))
    }
}

pub(super) type ReadTerm = Result<Term, LatexError>;

/// A list with the next item to read.
#[derive(Debug, Clone)]
pub(super) struct Line<'i> {
    pub items: &'i [TexItem],
    pub next: usize,
    /// The place of what contains the list.
    pub around: Place,
}

impl<'i> Line<'i> {
    pub fn new(items: &'i [TexItem], around: Place) -> Self {
        Self {
            items,
            next: 0,
            around,
        }
    }

    pub fn peek(&self) -> Option<&'i TexItem> {
        self.items.get(self.next)
    }

    pub fn rest(&self) -> &'i [TexItem] {
        self.items.get(self.next..).unwrap_or(&[])
    }

    /// Whether a round bracket is next: that of arguments, behind a function.
    pub fn is_before_bracket(&self) -> bool {
        self.peek()
            .is_some_and(|next| matches!(next.nucleus, Nucleus::Fenced('(', ..)))
    }

    /// The place of the next item, or of the end.
    pub fn place(&self) -> Place {
        match (self.peek(), self.items.last()) {
            (Some(item), _) => item.place,
            (None, Some(last)) => Place {
                start: last.place.end,
                end: last.place.end,
            },
            (None, None) => self.around,
        }
    }

    /// Takes the next item if it is this bare sign; one with scripts is left, and is an error where nothing takes it.
    pub fn sign(&mut self, sign: &str) -> bool {
        let next = self.peek();
        let found = next.is_some_and(|item| item.is_sign(sign) && item.is_bare());
        self.next += usize::from(found);
        found
    }
}

/// The reader.
pub(super) struct Reader<'n> {
    pub names: &'n LatexNames,
    /// The choices by key; a key without an entry has the first reading.
    pub chosen: BTreeMap<String, usize>,
    pub doubts: Vec<LatexDoubt>,
    /// The indices of sums and products around.
    pub bound: Vec<String>,
    depth: usize,
}

impl<'n> Reader<'n> {
    pub fn new(names: &'n LatexNames, chosen: BTreeMap<String, usize>) -> Self {
        Self {
            names,
            chosen,
            doubts: vec![],
            bound: vec![],
            depth: 0,
        }
    }

    /// Chooses between two readings, and notes that there are two.
    pub fn choose(&mut self, key: String, place: Place, says: [&str; 2]) -> usize {
        let choice = self.chosen.get(&key).copied().unwrap_or(0);
        if !self.doubts.iter().any(|doubt| doubt.key == key) {
            let says = says.map(str::to_owned);
            self.doubts.push(LatexDoubt { place, says, key });
        }
        choice
    }

    /// Reads one level deeper.
    pub fn deeper<T>(
        &mut self,
        place: Place,
        read: impl FnOnce(&mut Self) -> Result<T, LatexError>,
    ) -> Result<T, LatexError> {
        if self.depth >= MAX_READ_DEPTH {
            return Err(LatexError::new(
                place,
                format!("the formula is nested deeper than {MAX_READ_DEPTH} levels"),
            ));
        }
        self.depth += 1;
        let result = read(self);
        self.depth -= 1;
        result
    }

    /// Whether a letter is the index of a sum or a product around.
    pub fn is_bound(&self, item: &TexItem) -> Option<String> {
        let Nucleus::Letter(letters, _) = &item.nucleus else {
            return None;
        };
        self.bound
            .iter()
            .any(|name| name == letters)
            .then(|| letters.clone())
    }
}
