//! Mathematical notation: one tree of boxes for every output.
//!
//! A formula in the notation of the derivation files is parsed, simplified, laid out once as a tree of boxes
//! ([`MathBox`]) with the names that a paper prints ([`PrintedNames`]), and written as Typst, MathML, LaTeX and plain
//! text ([`Mathematics`]). [`spans`] takes sentences with formulas apart, [`changed`] and [`compared`] mark what a
//! correction changes. So no output shows the notation of the files, and all of them show the same.

mod change;
mod difference;
mod layout;
mod letters;
mod marked;
mod markup;
mod math_box;
mod mathml;
mod names;
mod prose;
pub mod signs;
mod tidy;
mod tokens;
mod write;

pub use change::changed;
pub use difference::difference;
pub use letters::FUNCTIONS;
pub use marked::compared;
pub use math_box::{Fence, LetterFace, MathBox, MathChange};
pub use names::PrintedNames;
pub use prose::{in_words, quotation, quoted_formula, spans};
pub use write::latex_words;

use serde::Serialize;
use torse_syntax::formula::{Expr, parse};

/// A formula in the languages of the outputs.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Mathematics {
    /// Typst mathematics, without dollar signs.
    pub typst: String,
    /// Ways to break a long formula into pieces of Typst mathematics, coarsest first; none for a short one, one for a
    /// formula within a sentence.
    pub breaks: Vec<Vec<MathPiece>>,
    /// MathML, one element for each piece between which a line may be broken.
    #[serde(skip)]
    pub mathml: Vec<String>,
    /// LaTeX mathematics, without dollar signs.
    #[serde(skip)]
    pub latex: String,
    /// The same in pieces between which a line may be broken, each with its approximate width in letters.
    #[serde(skip)]
    pub latex_pieces: Vec<(String, usize)>,
    /// Plain text on one line: the alternative text of the formula.
    #[serde(rename = "alt")]
    pub text: String,
}

/// A piece of a formula that is broken over lines.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct MathPiece {
    /// Typst mathematics.
    pub typst: String,
    /// Letters and signs.
    pub alt: String,
}

/// A stretch of a sentence.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "kind", content = "value")]
pub enum Span {
    /// Words.
    Words(String),
    /// Words that a correction changes.
    Strong(String),
    /// A command or the name of a file, as it is typed.
    Code(String),
    /// A formula.
    Math(Mathematics),
}

/// A sentence with its formulas.
pub type Prose = Vec<Span>;

/// Brackets are opened if a piece has more letters; the numbers are tried in turn.
const WIDTHS: [usize; 4] = [usize::MAX, 90, 45, 20];

impl Mathematics {
    /// A formula in the notation of the derivation files, on lines of its own; none for a text that is no formula.
    ///
    /// ```
    /// let half = torse_typography::Mathematics::read("x/2").ok_or("a formula")?;
    /// assert_eq!(half.latex, r"\frac{x}{2}");
    /// # Ok::<(), &str>(())
    /// ```
    #[must_use]
    pub fn read(formula: &str) -> Option<Self> {
        Some(Self::display(&read(formula, &PrintedNames::default())?))
    }

    /// A formula within a sentence.
    #[must_use]
    pub fn inline(node: &MathBox) -> Self {
        /// A longer formula may be wider than the rest of a line, or than the line.
        const LONG: usize = 50;
        let text = write::text(node);
        let breaks = match text.chars().count() > LONG {
            true => vec![
                (mathml::finest(node, WIDTHS[WIDTHS.len() - 1]).into_iter())
                    .map(piece)
                    .collect(),
            ],
            false => Vec::new(),
        };
        Mathematics {
            typst: write::typst(node),
            breaks,
            mathml: mathml::pieces(node),
            latex: write::latex(node),
            latex_pieces: Vec::new(),
            text,
        }
    }

    /// A formula on lines of its own.
    #[must_use]
    pub fn display(node: &MathBox) -> Self {
        /// A formula of at most so many letters fits into the column.
        const SHORT: usize = 30;
        let text = write::text(node);
        let mut breaks: Vec<Vec<MathPiece>> = Vec::new();
        if text.chars().count() > SHORT {
            let cut = |width| mathml::cuts(node, width).into_iter().map(piece).collect();
            breaks.extend(WIDTHS.into_iter().map(cut));
            // A product is cut only if nothing else helps.
            let finest = mathml::finest(node, WIDTHS[WIDTHS.len() - 1]);
            breaks.push(finest.into_iter().map(piece).collect());
            breaks.dedup();
        }
        Mathematics {
            typst: write::typst(node),
            breaks,
            mathml: mathml::pieces(node),
            latex: write::latex(node),
            latex_pieces: (mathml::cuts(node, WIDTHS[2]).into_iter())
                .map(|piece| {
                    let row = MathBox::Row(piece);
                    (write::latex(&row), write::text(&row).chars().count())
                })
                .collect(),
            text,
        }
    }
}

fn piece(nodes: Vec<MathBox>) -> MathPiece {
    let row = MathBox::Row(nodes);
    MathPiece {
        typst: write::typst(&row),
        alt: write::text(&row),
    }
}

/// Writes a sentence with its formulas as plain text on one line: `q₀ ≠ 0`.
#[must_use]
pub fn plain(text: &str) -> String {
    in_words(&spans(text, &PrintedNames::default()))
}

/// Writes a formula as LaTeX mathematics, without dollar signs.
#[must_use]
pub fn latex(formula: &Expr) -> String {
    write::latex(&laid_out(formula, &PrintedNames::default()))
}

/// Writes a formula as Typst mathematics, without dollar signs.
#[must_use]
pub fn typst(formula: &Expr) -> String {
    write::typst(&laid_out(formula, &PrintedNames::default()))
}

fn laid_out(formula: &Expr, names: &PrintedNames) -> MathBox {
    layout::layout(&tidy::tidy(formula), names)
}

/// Lays out a formula in the notation of the files; none if it does not parse.
#[must_use]
pub fn read(formula: &str, names: &PrintedNames) -> Option<MathBox> {
    Some(laid_out(&expression(formula)?, names))
}

/// Removes places from the formula, so that equal formulas compare equal.
#[must_use]
pub fn expression(formula: &str) -> Option<Expr> {
    // A member of a family without indices is written with empty brackets.
    let formula = formula.replace("[]", "");
    parse(&formula).ok().map(|e| e.placeless())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Writes the pieces of a formula as texts.
    fn texts(pieces: &[MathPiece]) -> Vec<&str> {
        pieces.iter().map(|piece| piece.alt.as_str()).collect()
    }

    #[test]
    fn a_long_formula_within_a_sentence_may_break_behind_commas_and_before_factors() {
        let short = read("a + b", &PrintedNames::default()).unwrap();
        assert!(Mathematics::inline(&short).breaks.is_empty());
        let long = "h(u, [-20, 60, 45], [-28, 39, 34], [-38, -60, 45], [-10, -67, -74])";
        let long = Mathematics::inline(&read(long, &PrintedNames::default()).unwrap());
        let [pieces] = long.breaks.as_slice() else {
            unreachable!("one way to break it")
        };
        let pieces = texts(pieces);
        assert_eq!(pieces.concat().replace(' ', ""), long.text.replace(' ', ""));
        assert!(pieces.len() > 2, "{pieces:?}");
        assert!(
            pieces.iter().all(|piece| piece.chars().count() < 34),
            "{pieces:?}"
        );
        let (last, before) = pieces.split_last().unwrap();
        assert!(
            before.iter().all(|piece| piece.ends_with([',', ' '])),
            "{pieces:?}"
        );
        assert!(last.ends_with(')'));
    }

    #[test]
    fn the_last_way_to_break_a_product_leaves_no_piece_too_wide() {
        let product = "[l*F(z)*sum(k, 0, n, g[k](z)*X[k]), l*F(z)*sum(k, 0, n, g[k](z)*Y[k])] == 0";
        let product = Mathematics::display(&read(product, &PrintedNames::default()).unwrap());
        let finest = texts(product.breaks.last().unwrap());
        assert!(
            finest.iter().all(|piece| piece.chars().count() <= 34),
            "{finest:?}"
        );
    }
}
