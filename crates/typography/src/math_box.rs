//! Boxes of mathematics: the layout, independent of any output.

use std::collections::BTreeSet;

/// What a correction did to a box.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MathChange {
    /// It is deleted: only the printed formula has it.
    Removed,
    /// It is inserted: only the corrected formula has it.
    Added,
}

/// The delimiters of a box.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fence {
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
pub enum LetterFace {
    /// A variable.
    Italic,
    /// A vector.
    Bold,
    /// A word.
    Upright,
}

/// A box.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum MathBox {
    /// A letter, or a word, in a face.
    Letter(String, LetterFace),
    /// The name of a function with a LaTeX command, such as `sin`.
    Function(String),
    /// Digits, perhaps with a point.
    Number(String),
    /// An operator, a relation or a punctuation mark.
    Sign(char),
    /// Boxes side by side.
    Row(Vec<MathBox>),
    /// A box with primes and scripts.
    Scripts {
        /// What carries them.
        base: Box<MathBox>,
        /// How many primes.
        primes: usize,
        /// The subscript.
        below: Option<Box<MathBox>>,
        /// The superscript.
        above: Option<Box<MathBox>>,
    },
    /// A letter under a sign: `\hat G`.
    Accent(char, Box<MathBox>),
    /// A numerator over a denominator.
    Fraction(Box<MathBox>, Box<MathBox>),
    /// A square root.
    Root(Box<MathBox>),
    /// A binomial coefficient.
    Binomial(Box<MathBox>, Box<MathBox>),
    /// A box between delimiters.
    Fenced(Fence, Box<MathBox>),
    /// Rows of entries between delimiters.
    Matrix(Fence, Vec<Vec<MathBox>>),
    /// The sign of a sum with its bounds.
    Sum {
        /// The lower bound, with the variable.
        below: Box<MathBox>,
        /// The upper bound.
        above: Option<Box<MathBox>>,
    },
    /// A box that a correction changed.
    Marked(MathChange, Box<MathBox>),
    /// A blank as wide as a letter, around words.
    Gap,
}

impl MathBox {
    pub(crate) fn italic(letter: &str) -> Self {
        MathBox::Letter(letter.to_owned(), LetterFace::Italic)
    }

    /// A word, upright.
    #[must_use]
    pub fn word(word: &str) -> Self {
        MathBox::Letter(word.to_owned(), LetterFace::Upright)
    }

    pub(crate) fn round(self) -> Self {
        MathBox::Fenced(Fence::Round, Box::new(self))
    }

    /// Puts boxes side by side; rows within are dissolved.
    pub(crate) fn row(nodes: impl IntoIterator<Item = MathBox>) -> Self {
        let mut all = Vec::new();
        for node in nodes {
            match node {
                MathBox::Row(inner) => all.extend(inner),
                other => all.push(other),
            }
        }
        match (all.pop(), all.is_empty()) {
            (Some(one), true) => one,
            (Some(last), false) => {
                all.push(last);
                MathBox::Row(all)
            }
            (None, _) => MathBox::Row(all),
        }
    }

    /// Puts boxes side by side with a sign between each two.
    pub(crate) fn joined(nodes: impl IntoIterator<Item = MathBox>, sign: char) -> Self {
        let mut all = Vec::new();
        for node in nodes {
            if !all.is_empty() {
                all.push(MathBox::Sign(sign));
            }
            all.push(node);
        }
        MathBox::row(all)
    }

    /// Adds scripts to a box; without any it stays as it is.
    pub(crate) fn scripted(
        self,
        primes: usize,
        below: Option<MathBox>,
        above: Option<MathBox>,
    ) -> Self {
        if primes == 0 && below.is_none() && above.is_none() {
            return self;
        }
        match self {
            // An empty place takes the script.
            MathBox::Scripts {
                base,
                primes: had,
                below: under,
                above: over,
            } if (under.is_none() || below.is_none()) && (over.is_none() || above.is_none()) => {
                MathBox::Scripts {
                    base,
                    primes: had + primes,
                    below: under.or(below.map(Box::new)),
                    above: over.or(above.map(Box::new)),
                }
            }
            base => MathBox::Scripts {
                base: Box::new(base),
                primes,
                below: below.map(Box::new),
                above: above.map(Box::new),
            },
        }
    }

    /// Returns the letter of which the box is made, with scripts or arguments, if it is italic.
    pub(crate) fn light_letter(&self) -> Option<char> {
        match self {
            MathBox::Letter(letter, LetterFace::Italic) => letter.chars().next(),
            MathBox::Scripts { base, .. } => base.light_letter(),
            MathBox::Row(nodes) => match nodes.as_slice() {
                [head, MathBox::Fenced(..)] => head.light_letter(),
                _ => None,
            },
            _ => None,
        }
    }

    /// Makes these letters bold wherever they are italic.
    pub(crate) fn with_bold(self, letters: &BTreeSet<char>) -> Self {
        let bold = |node: Box<MathBox>| Box::new(node.with_bold(letters));
        let all = |nodes: Vec<MathBox>| -> Vec<MathBox> {
            nodes.into_iter().map(|n| n.with_bold(letters)).collect()
        };
        match self {
            MathBox::Letter(letter, LetterFace::Italic) => {
                let mut signs = letter.chars();
                let is_one = matches!((signs.next(), signs.next()), (Some(sign), None) if letters.contains(&sign));
                let face = if is_one {
                    LetterFace::Bold
                } else {
                    LetterFace::Italic
                };
                MathBox::Letter(letter, face)
            }
            MathBox::Letter(..)
            | MathBox::Function(_)
            | MathBox::Number(_)
            | MathBox::Sign(_)
            | MathBox::Gap => self,
            MathBox::Row(nodes) => MathBox::Row(all(nodes)),
            MathBox::Scripts {
                base,
                primes,
                below,
                above,
            } => MathBox::Scripts {
                base: bold(base),
                primes,
                below: below.map(bold),
                above: above.map(bold),
            },
            MathBox::Accent(sign, inner) => MathBox::Accent(sign, bold(inner)),
            MathBox::Fraction(over, under) => MathBox::Fraction(bold(over), bold(under)),
            MathBox::Root(inner) => MathBox::Root(bold(inner)),
            MathBox::Binomial(over, under) => MathBox::Binomial(bold(over), bold(under)),
            MathBox::Fenced(fence, inner) => MathBox::Fenced(fence, bold(inner)),
            MathBox::Matrix(fence, rows) => {
                MathBox::Matrix(fence, rows.into_iter().map(all).collect())
            }
            MathBox::Sum { below, above } => MathBox::Sum {
                below: bold(below),
                above: above.map(bold),
            },
            MathBox::Marked(mark, inner) => MathBox::Marked(mark, bold(inner)),
        }
    }

    /// Whether the first visible sign is a digit.
    pub(crate) fn begins_with_digit(&self) -> bool {
        match self {
            MathBox::Number(_) => true,
            MathBox::Row(nodes) => nodes.first().is_some_and(MathBox::begins_with_digit),
            MathBox::Scripts { base, .. } => base.begins_with_digit(),
            MathBox::Marked(_, inner) => inner.begins_with_digit(),
            _ => false,
        }
    }

    /// Whether the last visible thing is a number on the line.
    pub(crate) fn ends_with_number(&self) -> bool {
        match self {
            MathBox::Number(_) | MathBox::Fraction(..) => true,
            MathBox::Row(nodes) => nodes.last().is_some_and(MathBox::ends_with_number),
            MathBox::Marked(_, inner) => inner.ends_with_number(),
            _ => false,
        }
    }

    /// Whether only a fraction is visible.
    pub(crate) fn is_fraction(&self) -> bool {
        match self {
            MathBox::Fraction(..) => true,
            MathBox::Marked(_, inner) => inner.is_fraction(),
            _ => false,
        }
    }
}
