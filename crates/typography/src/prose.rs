//! Sentences with formulas in them, taken apart.
//!
//! Three kinds of mathematics stand in sentences: between dollar signs what files write for the purpose, between
//! backticks and between words the notation of the files (the steps of the engine, conditions, points), and in quotations
//! the typed mathematics of a print (`Q_{k,1}`, `sum_{i=0}^{k}`). A stretch between words is mathematics where it has a
//! sign, a script or a Greek letter that words do not have; a word of two letters and more is a word, unless the claim
//! has a symbol of that name.

use crate::letters::is_function;
use crate::tokens::{Kind, Token, tokens};
use crate::write::latex;
use crate::{MathBox, Mathematics, PrintedNames, Span, markup, read};

/// The sentence in stretches; formulas are those of a claim with these names.
pub fn spans(text: &str, names: &PrintedNames) -> Vec<Span> {
    stretches(text, names).into_iter().map(span).collect()
}

/// A quotation in spans, as the print has it.
pub fn quotation(text: &str, names: &PrintedNames) -> Vec<Span> {
    quoted(text, names).into_iter().map(span).collect()
}

/// A formula of a quotation that has no words: as LaTeX, by the same rules as in a sentence.
pub fn quoted_formula(text: &str) -> String {
    latex(&markup::boxes(&text.replace('⋅', ".")))
}

fn span(stretch: Stretch) -> Span {
    match stretch {
        Stretch::Words(text) => Span::Words(text),
        Stretch::Strong(text) => Span::Strong(text),
        Stretch::Code(text) => Span::Code(text),
        Stretch::Math(node) => Span::Math(Mathematics::inline(&node)),
    }
}

/// A stretch of a sentence, its formula not yet written in any language.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Stretch {
    /// Words.
    Words(String),
    /// Words that a correction changes.
    Strong(String),
    /// A command or a name of a file, as it is typed.
    Code(String),
    /// A formula.
    Math(MathBox),
}

/// How a stretch of a sentence is read; none if it is a word after all.
type ReadAs = fn(&str, &PrintedNames) -> Option<MathBox>;

/// The sentence in stretches.
pub(crate) fn stretches(text: &str, names: &PrintedNames) -> Vec<Stretch> {
    read_as(text, names, |stretch, names| Some(formula(stretch, names)))
}

/// A quotation in stretches: every bracket, dot and spelled letter is that of the print.
pub(crate) fn quoted(text: &str, names: &PrintedNames) -> Vec<Stretch> {
    read_as(text, names, |stretch, _| {
        let spelled = stretch.len() > 1 && stretch.chars().all(|c| c.is_ascii_alphabetic());
        (!spelled).then(|| markup::boxes(&stretch.replace('⋅', ".")))
    })
}

fn read_as(text: &str, names: &PrintedNames, reading: ReadAs) -> Vec<Stretch> {
    let mut list = List::default();
    match text.matches('$').count().is_multiple_of(2) {
        true => {
            for (number, part) in text.split('$').enumerate() {
                match number % 2 {
                    0 => between_backticks(part, names, reading, &mut list),
                    _ => list.math(&markup::boxes(part)),
                }
            }
        }
        false => between_backticks(text, names, reading, &mut list),
    }
    let bold = |stretch: Stretch| match stretch {
        Stretch::Math(node) => Stretch::Math(names.with_vectors(node)),
        other => other,
    };
    list.0.into_iter().map(bold).collect()
}

/// The sentence in letters and signs, for outputs without formulas.
#[must_use]
pub fn in_words(spans: &[Span]) -> String {
    let part = |span: &Span| match span {
        Span::Words(text) | Span::Strong(text) | Span::Code(text) => text.clone(),
        Span::Math(math) => math.text.clone(),
    };
    spans.iter().map(part).collect()
}

#[derive(Default)]
struct List(Vec<Stretch>);

impl List {
    fn words(&mut self, text: &str) {
        match self.0.last_mut() {
            _ if text.is_empty() => {}
            Some(Stretch::Words(words)) => words.push_str(text),
            _ => self.0.push(Stretch::Words(text.to_owned())),
        }
    }

    fn math(&mut self, node: &MathBox) {
        self.0.push(Stretch::Math(node.clone()));
    }
}

fn between_backticks(text: &str, names: &PrintedNames, reading: ReadAs, list: &mut List) {
    if text.matches('`').count() % 2 == 1 {
        return between_words(text, names, reading, list);
    }
    for (number, part) in text.split('`').enumerate() {
        match number % 2 {
            0 => between_words(part, names, reading, list),
            // A command has blanks between words, and no formula has.
            _ => match notation(part, names) {
                Some(node) => list.math(&node),
                None => list.0.push(Stretch::Code(part.to_owned())),
            },
        }
    }
}

fn between_words(text: &str, names: &PrintedNames, reading: ReadAs, list: &mut List) {
    let text = with_powers(text);
    let tokens = tokens(&text, names);
    let mut position = 0;
    while let Some(token) = tokens.get(position) {
        match run(&tokens, position) {
            Some(end) => {
                let stretch: String = tokens
                    .get(position..end)
                    .unwrap_or_default()
                    .iter()
                    .map(|token| match token.kind {
                        Kind::Open if token.text == "<" => "⟨",
                        Kind::Close if token.text == ">" => "⟩",
                        // A scalar product, which the files write in another way.
                        Kind::Operator if token.text == "." => "⋅",
                        _ => token.text,
                    })
                    .collect();
                match reading(&stretch, names) {
                    Some(node) => list.math(&node),
                    None => list.words(&stretch),
                }
                position = end;
            }
            None if is_item(tokens.get(position..position + 3).unwrap_or_default()) => {
                for token in tokens.iter().skip(position).take(3) {
                    list.words(token.text);
                }
                position += 3;
            }
            None => {
                // A number alone is no formula, its sign is a minus all the same.
                let number = tokens
                    .get(position + 1)
                    .is_some_and(|t| t.kind == Kind::Number);
                match number && sign_before_operand(&tokens, position) {
                    true => list.words("−"),
                    false => list.words(token.text),
                }
                position += 1;
            }
        }
    }
}

/// With `^2` for a raised two behind a letter, a function or a bracket; units such as mm² stay as they are.
fn with_powers(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        let digit = match c {
            '²' => Some('2'),
            '³' => Some('3'),
            _ => None,
        };
        let start = out.trim_end_matches(char::is_alphabetic).len();
        let word = out.get(start..).unwrap_or_default();
        let raised = word.chars().count() == 1
            || is_function(word)
            || (word.is_empty() && out.ends_with([')', ']', '|', '\'']));
        match digit {
            Some(digit) if raised => out.extend(['^', digit]),
            _ => out.push(c),
        }
    }
    out
}

/// The letter of a list, `(a)`, which is no formula.
fn is_item(tokens: &[Token<'_>]) -> bool {
    match tokens {
        [open, letter, close] => {
            (open.text, close.text) == ("(", ")")
                && letter.kind == Kind::Letter
                && letter.text.chars().all(|c| c.is_ascii_lowercase())
        }
        _ => false,
    }
}

/// In the notation of the files if it can be read so, or as it is typed. In prints a letter may stand above another, with
/// its argument behind, `p^u(0)`, which would be a power.
fn formula(stretch: &str, names: &PrintedNames) -> MathBox {
    let raised = |(place, _): (usize, &str)| {
        let above = stretch.get(place + 1..).unwrap_or_default();
        above.starts_with(char::is_alphabetic)
    };
    if let Some(inside) = in_brackets(stretch) {
        // A reader of formulas would leave these brackets out.
        return formula(inside, names).round();
    }
    if stretch.match_indices('^').any(raised) || has_plain_brackets(stretch) {
        return markup::boxes(stretch);
    }
    notation(stretch, names).unwrap_or_else(|| markup::boxes(stretch))
}

/// What one pair of brackets around a whole stretch holds.
fn in_brackets(stretch: &str) -> Option<&str> {
    let inside = stretch.strip_prefix('(')?.strip_suffix(')')?;
    let mut depth = 0_i32;
    let is_one_pair = inside.chars().all(|c| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        depth >= 0
    });
    // A list is set as it is typed.
    (is_one_pair && !inside.contains(',')).then_some(inside)
}

/// Whether square brackets stand around a sum, as prints have them, and neither around a list nor behind a name.
fn has_plain_brackets(stretch: &str) -> bool {
    stretch.match_indices('[').any(|(place, _)| {
        let (before, after) = stretch.split_at(place);
        let inner = after.get(1..).and_then(|rest| rest.split_once(']'));
        let is_plain = inner.is_some_and(|(inner, _)| !inner.contains([',', '[']));
        let head = before.trim_end().chars().next_back();
        is_plain && !head.is_some_and(|c| c.is_alphanumeric() || matches!(c, '\'' | ']' | ')'))
    })
}

/// A stretch in the notation of the files, with the signs of prints allowed.
fn notation(stretch: &str, names: &PrintedNames) -> Option<MathBox> {
    if stretch.contains(['{', '\\', '…', '√']) {
        return None;
    }
    let plain = stretch
        .replace("==", "=")
        .replace("<=", "≤")
        .replace(">=", "≥")
        .replace("!=", "≠");
    let plain = plain
        .replace('=', "==")
        .replace('≤', "<=")
        .replace('≥', ">=")
        .replace('≠', "!=");
    let plain = plain.replace('−', "-").replace('·', "*");
    read(&plain, names)
}

/// Where the mathematics ends that begins at a token; none if there is none.
fn run(tokens: &[Token<'_>], start: usize) -> Option<usize> {
    let mut depth = 0_usize;
    let mut sure = false;
    let mut operators = 0;
    let mut operands = 0;
    // The longest stretch so far that is whole: no bracket open, no operator without its right side.
    let mut best = None;
    let mut last = Kind::Blank;
    let mut position = start;
    // Only an operand or a bracket begins a formula, or a sign right before one.
    match tokens.get(start)?.kind {
        Kind::Sure | Kind::Letter | Kind::Number | Kind::Open => {}
        Kind::Operator if sign_before_operand(tokens, start) => {}
        _ => return None,
    }
    while let Some(token) = tokens.get(position) {
        let operand = matches!(last, Kind::Sure | Kind::Letter | Kind::Number | Kind::Close);
        match token.kind {
            Kind::Word => break,
            Kind::Comma if depth == 0 => break,
            Kind::Comma => last = Kind::Comma,
            Kind::Blank => {
                position += 1;
                continue;
            }
            Kind::Close if depth == 0 => break,
            Kind::Close => {
                depth -= 1;
                last = Kind::Close;
            }
            Kind::Open => {
                // A bracket after a blank belongs to the sentence, unless an operator stands before it.
                let blank = position > start
                    && tokens
                        .get(position - 1)
                        .is_some_and(|t| t.kind == Kind::Blank);
                if depth == 0 && operand && blank && !sure {
                    break;
                }
                depth += 1;
                last = Kind::Open;
            }
            Kind::Operator => {
                operators += usize::from(operand || !matches!(token.text, "-" | "−"));
                last = Kind::Operator;
            }
            kind @ (Kind::Sure | Kind::Letter | Kind::Number) => {
                let blank = position > start
                    && tokens
                        .get(position - 1)
                        .is_some_and(|t| t.kind == Kind::Blank);
                // Two operands with a blank between are two formulas, unless scripts say that the print is one.
                if depth == 0 && operand && blank && !(sure && kind != Kind::Letter) {
                    break;
                }
                sure |= kind == Kind::Sure;
                operands += 1;
                last = kind;
            }
        }
        position += 1;
        if depth == 0 && matches!(last, Kind::Sure | Kind::Letter | Kind::Number | Kind::Close) {
            let letters = tokens
                .get(start..position)
                .unwrap_or_default()
                .iter()
                .any(|t| matches!(t.kind, Kind::Letter | Kind::Sure));
            let lone = tokens.get(start..position).unwrap_or_default();
            let article = lone.len() == 1 && lone.iter().all(|t| matches!(t.text, "a" | "A" | "I"));
            if is_item(lone) {
                continue;
            }
            let mathematics =
                sure || (letters && operands > 0 && !article) || (operators > 0 && operands > 1);
            if mathematics {
                best = Some(position);
            }
        }
    }
    best
}

fn sign_before_operand(tokens: &[Token<'_>], position: usize) -> bool {
    let sign = tokens
        .get(position)
        .is_some_and(|t| matches!(t.text, "-" | "−"));
    let begins = position == 0
        || tokens
            .get(position - 1)
            .is_some_and(|t| matches!(t.kind, Kind::Blank | Kind::Comma | Kind::Open));
    let operand = tokens.get(position + 1).is_some_and(|t| {
        matches!(
            t.kind,
            Kind::Sure | Kind::Letter | Kind::Number | Kind::Open
        )
    });
    sign && begins && operand
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sentence with its formulas in angle brackets.
    fn shown(text: &str) -> String {
        let part = |span: &Span| match span {
            Span::Words(text) | Span::Strong(text) => text.clone(),
            Span::Code(text) => format!("`{text}`"),
            Span::Math(math) => format!("⟨{}⟩", math.text),
        };
        spans(text, &PrintedNames::default())
            .iter()
            .map(part)
            .collect()
    }

    #[test]
    fn formulas_between_words_are_found() {
        for (sentence, expected) in [
            (
                "the range of nu cannot be larger by 1/2: at nu = 5/2, tan(pi/4*z) = 1/3, mu = -1 it fails",
                "the range of ⟨ν⟩ cannot be larger by ⟨1/2⟩: at ⟨ν = 5/2⟩, ⟨tan(π/4z) = 1/3⟩, ⟨μ = −1⟩ it fails",
            ),
            (
                "a factor 4 before λ is missing, as (5.16) has it: Q_{k,1} = 0 for a point",
                "a factor 4 before ⟨λ⟩ is missing, as (5.16) has it: ⟨Qₖ,₁ = 0⟩ for a point",
            ),
            (
                "the degree k, of G2 type, in 3D",
                "the degree ⟨k⟩, of G2 type, in 3D",
            ),
            (
                "Farin-Boehm and B-spline curves (1, 2)",
                "Farin-Boehm and B-spline curves (1, 2)",
            ),
            ("the values -1, 0, 1 of mu", "the values −1, 0, 1 of ⟨μ⟩"),
            (
                "A name, not a formula; I think.",
                "A name, not a formula; I think.",
            ),
            (
                "true if `mu != 0` (`torse explain x/y` has it)",
                "true if ⟨μ ≠ 0⟩ (`torse explain x/y` has it)",
            ),
            (r"with $\mathbf{g} = \mathbf{q}_0^{u}$.", "with ⟨g = q₀ᵘ⟩."),
            (
                "the planes Gamma_1 // Gamma_2 with |x1| <= 1/2",
                "the planes ⟨Γ₁∥Γ₂⟩ with ⟨|x₁| ≤ 1/2⟩",
            ),
            (
                "4(a + b) − 2Q_{1,2} of sec-3.1 and T~^Z_rot",
                "⟨4(a + b) − 2Q₁,₂⟩ of sec-3.1 and ⟨T̃ᵣₒₜᶻ⟩",
            ),
            (
                "Proposition 3.8 (b) and Fig. 5a, Figure (5b), Figs. 9–10",
                "Proposition 3.8 (b) and Fig. 5a, Figure (5b), Figs. 9–10",
            ),
            (
                "the product φ . φ is sin²(x) + y² of 4 mm²",
                "the product ⟨φ ⋅ φ⟩ is ⟨sin²(x) + y²⟩ of 4 mm²",
            ),
            (
                "for all integers k (k ≥ 3), i.e. 'a value of ν', G2 beta smooth",
                "for all integers ⟨k⟩ ⟨(k ≥ 3)⟩, i.e. 'a value of ⟨ν⟩', G2 beta smooth",
            ),
            (
                "we don't say 'one' or \"two\"",
                "we don't say 'one' or \"two\"",
            ),
        ] {
            assert_eq!(shown(sentence), expected);
        }
    }

    #[test]
    fn quotations_of_a_print_are_mathematics() {
        assert_eq!(
            shown("F_m(z) = sum_{k=0}^{m} f_{k,m}(z) Q_{k,m}, 0 ≤ z ≤ 1"),
            "⟨Fₘ(z) = ∑ₖ₌₀ᵐfₖ,ₘ(z)Qₖ,ₘ⟩, ⟨0 ≤ z ≤ 1⟩"
        );
    }

    #[test]
    fn any_sentence_is_taken_apart_without_losing_words() {
        for text in [
            "",
            "$",
            "`",
            "((((",
            "a_{",
            "^^^",
            "x^",
            "= = =",
            "√",
            "-",
            "1...",
            "ä_ö ∑_",
        ] {
            let _ = spans(text, &PrintedNames::default());
        }
        assert_eq!(
            in_words(&spans("no formula here, none.", &PrintedNames::default())),
            "no formula here, none."
        );
    }
}
