//! Boxes of mathematics: the layout, independent of any output.

use std::collections::BTreeSet;

/// What a correction did to a box.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Mark {
    /// It is deleted: only the printed formula has it.
    Removed,
    /// It is inserted: only the corrected formula has it.
    Added,
}

/// The delimiters of a box.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Fence {
    /// Round brackets.
    Round,
    /// Square brackets.
    Square,
    /// Bars: a determinant or an absolute value.
    Bars,
    /// Double bars: a length.
    Length,
    /// No left delimiter, and a bar on the right: a value at a point.
    Behind,
}

/// The face of a letter or word.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Face {
    /// A variable.
    Italic,
    /// A vector.
    Bold,
    /// A word.
    Upright,
}

/// A box.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Node {
    /// A letter, or a word, in a face.
    Letter(String, Face),
    /// The name of a function with a LaTeX command, such as `sin`.
    Function(String),
    /// Digits, perhaps with a point.
    Number(String),
    /// An operator, a relation or a punctuation mark.
    Sign(char),
    /// Boxes side by side.
    Row(Vec<Node>),
    /// A box with primes and scripts.
    Scripts {
        base: Box<Node>,
        primes: usize,
        below: Option<Box<Node>>,
        above: Option<Box<Node>>,
    },
    /// A letter under a sign: `\hat G`.
    Accent(char, Box<Node>),
    Fraction(Box<Node>, Box<Node>),
    Root(Box<Node>),
    Binomial(Box<Node>, Box<Node>),
    Fenced(Fence, Box<Node>),
    Matrix(Fence, Vec<Vec<Node>>),
    /// The sign of a sum with its bounds.
    Sum {
        below: Box<Node>,
        above: Option<Box<Node>>,
    },
    /// A box that a correction changed.
    Marked(Mark, Box<Node>),
    /// A blank as wide as a letter, around words.
    Gap,
}

impl Node {
    pub(crate) fn italic(letter: &str) -> Self {
        Node::Letter(letter.to_owned(), Face::Italic)
    }

    pub(crate) fn word(word: &str) -> Self {
        Node::Letter(word.to_owned(), Face::Upright)
    }

    pub(crate) fn round(self) -> Self {
        Node::Fenced(Fence::Round, Box::new(self))
    }

    /// Puts boxes side by side; rows within are dissolved.
    pub(crate) fn row(nodes: impl IntoIterator<Item = Node>) -> Self {
        let mut all = Vec::new();
        for node in nodes {
            match node {
                Node::Row(inner) => all.extend(inner),
                other => all.push(other),
            }
        }
        match (all.pop(), all.is_empty()) {
            (Some(one), true) => one,
            (Some(last), false) => {
                all.push(last);
                Node::Row(all)
            }
            (None, _) => Node::Row(all),
        }
    }

    /// Puts boxes side by side with a sign between each two.
    pub(crate) fn joined(nodes: impl IntoIterator<Item = Node>, sign: char) -> Self {
        let mut all = Vec::new();
        for node in nodes {
            if !all.is_empty() {
                all.push(Node::Sign(sign));
            }
            all.push(node);
        }
        Node::row(all)
    }

    /// Adds scripts to a box; without any it stays as it is.
    pub(crate) fn scripted(self, primes: usize, below: Option<Node>, above: Option<Node>) -> Self {
        if primes == 0 && below.is_none() && above.is_none() {
            return self;
        }
        match self {
            // An empty place takes the script.
            Node::Scripts {
                base,
                primes: had,
                below: under,
                above: over,
            } if (under.is_none() || below.is_none()) && (over.is_none() || above.is_none()) => {
                Node::Scripts {
                    base,
                    primes: had + primes,
                    below: under.or(below.map(Box::new)),
                    above: over.or(above.map(Box::new)),
                }
            }
            base => Node::Scripts {
                base: Box::new(base),
                primes,
                below: below.map(Box::new),
                above: above.map(Box::new),
            },
        }
    }

    /// Makes these letters bold wherever they are italic.
    pub(crate) fn with_bold(self, letters: &BTreeSet<char>) -> Self {
        let bold = |node: Box<Node>| Box::new(node.with_bold(letters));
        let all = |nodes: Vec<Node>| -> Vec<Node> {
            nodes.into_iter().map(|n| n.with_bold(letters)).collect()
        };
        match self {
            Node::Letter(letter, Face::Italic) => {
                let mut signs = letter.chars();
                let is_one = matches!((signs.next(), signs.next()), (Some(sign), None) if letters.contains(&sign));
                let face = if is_one { Face::Bold } else { Face::Italic };
                Node::Letter(letter, face)
            }
            Node::Letter(..) | Node::Function(_) | Node::Number(_) | Node::Sign(_) | Node::Gap => {
                self
            }
            Node::Row(nodes) => Node::Row(all(nodes)),
            Node::Scripts {
                base,
                primes,
                below,
                above,
            } => Node::Scripts {
                base: bold(base),
                primes,
                below: below.map(bold),
                above: above.map(bold),
            },
            Node::Accent(sign, inner) => Node::Accent(sign, bold(inner)),
            Node::Fraction(over, under) => Node::Fraction(bold(over), bold(under)),
            Node::Root(inner) => Node::Root(bold(inner)),
            Node::Binomial(over, under) => Node::Binomial(bold(over), bold(under)),
            Node::Fenced(fence, inner) => Node::Fenced(fence, bold(inner)),
            Node::Matrix(fence, rows) => Node::Matrix(fence, rows.into_iter().map(all).collect()),
            Node::Sum { below, above } => Node::Sum {
                below: bold(below),
                above: above.map(bold),
            },
            Node::Marked(mark, inner) => Node::Marked(mark, bold(inner)),
        }
    }

    /// Whether the first visible sign is a digit.
    pub(crate) fn begins_with_digit(&self) -> bool {
        match self {
            Node::Number(_) => true,
            Node::Row(nodes) => nodes.first().is_some_and(Node::begins_with_digit),
            Node::Scripts { base, .. } => base.begins_with_digit(),
            Node::Marked(_, inner) => inner.begins_with_digit(),
            _ => false,
        }
    }

    /// Whether the last visible thing is a number on the line.
    pub(crate) fn ends_with_number(&self) -> bool {
        match self {
            Node::Number(_) | Node::Fraction(..) => true,
            Node::Row(nodes) => nodes.last().is_some_and(Node::ends_with_number),
            Node::Marked(_, inner) => inner.ends_with_number(),
            _ => false,
        }
    }

    /// Whether only a fraction is visible.
    pub(crate) fn is_fraction(&self) -> bool {
        match self {
            Node::Fraction(..) => true,
            Node::Marked(_, inner) => inner.is_fraction(),
            _ => false,
        }
    }
}
