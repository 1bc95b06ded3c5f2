//! Sentences with formulas in them, taken apart.
//!
//! Three kinds of mathematics stand in sentences: between dollar signs what files write for the purpose, between
//! backticks and between words the notation of the files (the steps of the engine, conditions, points), and in quotations
//! the typed mathematics of a print (`Q_{k,1}`, `sum_{i=0}^{k}`). A stretch between words is mathematics where it has a
//! sign, a script or a Greek letter that words do not have; a word of two letters and more is a word, unless the claim
//! has a symbol of that name.

use super::letters::{greek_letter, is_function};
use super::{Mathematics, Names, Span, markup, read};

/// The sentence in stretches; formulas are those of a claim with these names.
pub(crate) fn spans(text: &str, names: &Names) -> Vec<Span> {
    let span = |stretch: Stretch| match stretch {
        Stretch::Words(text) => Span::Words(text),
        Stretch::Strong(text) => Span::Strong(text),
        Stretch::Code(text) => Span::Code(text),
        Stretch::Math(node) => Span::Math(Mathematics::inline(&node)),
    };
    stretches(text, names).into_iter().map(span).collect()
}

/// A stretch of a sentence, its formula not yet written in any language.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Stretch {
    /// Words.
    Words(String),
    /// Words that a correction changes.
    Strong(String),
    /// A command or a name of a file, as it is typed.
    Code(String),
    /// A formula.
    Math(super::Node),
}

/// The sentence in stretches.
pub(super) fn stretches(text: &str, names: &Names) -> Vec<Stretch> {
    let mut list = List::default();
    match text.matches('$').count().is_multiple_of(2) {
        true => {
            for (number, part) in text.split('$').enumerate() {
                match number % 2 {
                    0 => between_backticks(part, names, &mut list),
                    _ => list.math(&markup::boxes(part)),
                }
            }
        }
        false => between_backticks(text, names, &mut list),
    }
    list.0
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

    fn math(&mut self, node: &super::Node) {
        self.0.push(Stretch::Math(node.clone()));
    }
}

fn between_backticks(text: &str, names: &Names, list: &mut List) {
    if text.matches('`').count() % 2 == 1 {
        return between_words(text, names, list);
    }
    for (number, part) in text.split('`').enumerate() {
        match number % 2 {
            0 => between_words(part, names, list),
            // A command has blanks between words, and no formula has.
            _ => match notation(part, names) {
                Some(node) => list.math(&node),
                None => list.0.push(Stretch::Code(part.to_owned())),
            },
        }
    }
}

/// A stretch of letters, of digits, of blanks, or one sign.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// A word of a language, which is no mathematics.
    Word,
    /// What may be mathematics and may be a word: a single letter.
    Letter,
    /// What is mathematics wherever it stands.
    Sure,
    Number,
    /// `+`, `=` and the like: mathematics between mathematics.
    Operator,
    Open,
    Close,
    Comma,
    Blank,
}

struct Token<'a> {
    kind: Kind,
    text: &'a str,
}

fn between_words(text: &str, names: &Names, list: &mut List) {
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
                list.math(&formula(&stretch, names));
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
fn formula(stretch: &str, names: &Names) -> super::Node {
    let raised = |(place, _): (usize, &str)| {
        let above = stretch.get(place + 1..).unwrap_or_default();
        above.starts_with(char::is_alphabetic)
    };
    if stretch.match_indices('^').any(raised) {
        return markup::boxes(stretch);
    }
    notation(stretch, names).unwrap_or_else(|| markup::boxes(stretch))
}

/// A stretch in the notation of the files, with the signs of prints allowed.
fn notation(stretch: &str, names: &Names) -> Option<super::Node> {
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
                operators += usize::from(operand || token.text != "-");
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

fn tokens<'a>(text: &'a str, names: &Names) -> Vec<Token<'a>> {
    let mut tokens: Vec<Token<'a>> = Vec::new();
    let mut rest = text;
    let (mut angle, mut bar) = (false, Kind::Open);
    while let Some(first) = rest.chars().next() {
        let (length, mut kind) = next(rest, first, bar, names);
        if first == '|' {
            bar = match bar {
                Kind::Open => Kind::Close,
                _ => Kind::Open,
            };
        }
        // Prints have vectors in angle brackets: `q = <1, 2, 3>`.
        let before = tokens.iter().rev().find(|token| token.kind != Kind::Blank);
        if length == 1
            && first == '<'
            && before.is_some_and(|token| token.text == "=")
            && rest.contains('>')
        {
            (kind, angle) = (Kind::Open, true);
        } else if length == 1 && first == '>' && angle {
            (kind, angle) = (Kind::Close, false);
        }
        let mut length = length;
        if first.is_ascii_digit() && is_of_a_figure(&tokens) {
            let end = rest.find(|c: char| !c.is_ascii_alphanumeric());
            (length, kind) = (end.unwrap_or(rest.len()), Kind::Word);
        } else if first == '.' && is_between_blanks(rest, &tokens) {
            kind = Kind::Operator;
        }
        let (taken, after) = rest.split_at_checked(length).unwrap_or((rest, ""));
        tokens.push(Token { kind, text: taken });
        rest = after;
    }
    tokens
}

/// Whether a number comes next that is one of a figure: `Fig. 5a`, `Figure (5b)`.
fn is_of_a_figure(tokens: &[Token<'_>]) -> bool {
    let words = tokens.iter().rev();
    let mut words = words.filter(|token| token.kind != Kind::Blank && token.kind != Kind::Open);
    let last = match words.next() {
        Some(token) if token.text == "." => words.next(),
        other => other,
    };
    last.is_some_and(|token| matches!(token.text, "Fig" | "Figs" | "Figure" | "Figures"))
}

/// Whether a dot between blanks stands behind an operand: prints write a scalar product so.
fn is_between_blanks(rest: &str, tokens: &[Token<'_>]) -> bool {
    let blank = |token: &Token<'_>| token.kind == Kind::Blank;
    let operand = |token: &Token<'_>| {
        matches!(
            token.kind,
            Kind::Letter | Kind::Sure | Kind::Number | Kind::Close
        )
    };
    match tokens {
        [.., before, last] => rest.starts_with(". ") && blank(last) && operand(before),
        _ => false,
    }
}

/// The length of the next token in bytes, and what it is; `bar` is what a bar is here, the first or the second of two.
fn next(rest: &str, first: char, bar: Kind, names: &Names) -> (usize, Kind) {
    let length = |keep: &dyn Fn(char) -> bool| rest.find(|c| !keep(c)).unwrap_or(rest.len());
    if first.is_whitespace() {
        return (length(&char::is_whitespace), Kind::Blank);
    }
    if first.is_ascii_digit() {
        let end = length(&|c| c.is_ascii_digit() || c == '.');
        let taken = rest.get(..end).unwrap_or_default();
        let dots = taken.len() - taken.trim_end_matches('.').len();
        let end = if dots == 3 { end } else { end - dots };
        return match rest.get(end..).and_then(|after| after.chars().next()) {
            // 3D, 2nd, but not 2Q_1
            Some(c) if c.is_alphabetic() && c.is_ascii() && !names.knows(&c.to_string()) => {
                let word = rest.get(end..).unwrap_or_default();
                let letters = word
                    .find(|c: char| !c.is_alphabetic())
                    .unwrap_or(word.len());
                match word.get(letters..).and_then(|after| after.chars().next()) {
                    Some('_' | '^' | '(' | '[') if letters == 1 => (end, Kind::Number),
                    _ => (end + letters, Kind::Word),
                }
            }
            Some('_' | '^') => scripted(rest, end, Kind::Number),
            _ => (end, Kind::Number),
        };
    }
    if first.is_alphabetic() {
        let end = length(&|c| {
            is_greek(c) == is_greek(first) && c.is_alphanumeric()
                || c.is_ascii_digit()
                || matches!(c, '\'' | '′' | '\u{302}' | '\u{303}')
        });
        let word = rest.get(..end).unwrap_or_default();
        let trimmed = word.trim_end_matches('\'');
        let after = rest.get(end..).and_then(|after| after.chars().next());
        let kind = match word {
            "sum" | "sqrt" | "binom" if matches!(after, Some('_' | '(')) => Kind::Sure,
            _ => kind_of(word, names),
        };
        return match after {
            Some('_' | '^' | '~') => scripted(rest, end, kind),
            _ if is_function(word) && !applied(rest.get(end..).unwrap_or_default()) => {
                (end, Kind::Word)
            }
            // A word of the sentence with an apostrophe or in quotation marks.
            _ if kind == Kind::Word => (trimmed.len().max(1), Kind::Word),
            // B-spline, G1-continuous
            Some('-') if hyphenated(rest.get(end..).unwrap_or_default()) && kind != Kind::Sure => {
                (end, Kind::Word)
            }
            _ => (end, kind),
        };
    }
    match first {
        '(' | '[' => (1, Kind::Open),
        '|' if bar == Kind::Close && rest.get(1..2) == Some("^") => {
            (scripted(rest, 1, Kind::Close).0, Kind::Close)
        }
        ')' | ']' => match rest.get(1..).and_then(|after| after.chars().next()) {
            Some('_' | '^') if balanced(rest.get(1..).unwrap_or_default()) => {
                let (end, _) = scripted(rest, 1, Kind::Close);
                (end, Kind::Close)
            }
            _ => (1, Kind::Close),
        },
        ',' | ';' => (1, Kind::Comma),
        '√' => (first.len_utf8(), Kind::Sure),
        '∞' | '∂' | '∑' => (first.len_utf8(), Kind::Sure),
        '=' | '<' | '>' | '!' if rest.starts_with([first]) && rest.get(1..2) == Some("=") => {
            (2, Kind::Operator)
        }
        '-' if rest.starts_with("->") => (2, Kind::Operator),
        '/' if rest.starts_with("//") || rest.starts_with("/\\") => (2, Kind::Operator),
        '|' => (1, bar),
        '+' | '-' | '−' | '*' | '/' | '^' | '=' | '<' | '>' | '≤' | '≥' | '≠' | '≈' | '·' | '×'
        | '∈' | '→' => (first.len_utf8(), Kind::Operator),
        '²' | '³' => (first.len_utf8(), Kind::Sure),
        _ => (first.len_utf8(), Kind::Word),
    }
}

fn is_greek(c: char) -> bool {
    ('Α'..='ω').contains(&c)
}

/// Whether an argument follows the name of a function: a bracket, a number or a single letter.
fn applied(rest: &str) -> bool {
    let mut letters = rest.trim_start_matches(' ').chars();
    match letters.next() {
        Some(c) if c.is_ascii_alphabetic() => !letters.next().is_some_and(char::is_alphabetic),
        Some(c) => c == '(' || c.is_ascii_digit() || is_greek(c),
        None => false,
    }
}

/// Whether a hyphen is followed by a word.
fn hyphenated(rest: &str) -> bool {
    let letters = rest.chars().skip(1).take_while(|c| c.is_alphabetic());
    letters.count() > 1
}

fn balanced(rest: &str) -> bool {
    !rest.starts_with(['_', '^'])
        || rest
            .chars()
            .nth(1)
            .is_some_and(|c| c.is_alphanumeric() || c == '{')
}

/// A token with scripts behind: `Q_{k,1}^2`.
fn scripted(rest: &str, end: usize, base: Kind) -> (usize, Kind) {
    let mut end = end;
    let mut any = false;
    // A tilde that is typed behind its letter.
    if rest
        .get(end..)
        .is_some_and(|after| after.starts_with("~^") || after.starts_with("~_"))
    {
        end += 1;
    }
    while let Some(after) = rest.get(end..) {
        let mut chars = after.chars();
        if !matches!(chars.next(), Some('_' | '^')) {
            break;
        }
        let inside = chars.as_str();
        let taken = match inside.chars().next() {
            Some('{') => match closing(inside) {
                Some(length) => length,
                None => break,
            },
            Some('(') if after.starts_with('^') => break,
            Some(c) if c.is_alphanumeric() => inside
                .find(|c: char| !c.is_alphanumeric())
                .unwrap_or(inside.len()),
            _ => break,
        };
        any = true;
        end += 1 + taken;
        // Primes may stand behind a script.
        let primes = rest.get(end..).unwrap_or_default();
        end += primes.len() - primes.trim_start_matches('\'').len();
    }
    match any {
        true => (end, Kind::Sure),
        false => (end, base),
    }
}

/// The length of a group in braces.
fn closing(group: &str) -> Option<usize> {
    let mut depth = 0_usize;
    for (position, c) in group.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => {
                depth -= 1;
                if depth == 0 {
                    return Some(position + 1);
                }
            }
            _ => {}
        }
    }
    None
}

fn kind_of(word: &str, names: &Names) -> Kind {
    let stem = word.trim_end_matches(['\'', '′']);
    let letters = stem.trim_end_matches(|c: char| c.is_ascii_digit());
    let numbered = letters.len() < stem.len();
    let primed = stem.len() < word.len();
    let one = letters
        .chars()
        .filter(|c| !matches!(c, '\u{302}' | '\u{303}'))
        .count()
        == 1;
    let letter = greek_letter(letters).is_some() || (one && letters.chars().all(is_greek));
    if letter || is_function(word) {
        return Kind::Sure;
    }
    match one {
        // G2 and C1 are classes of smoothness, unless the claim has symbols of these names.
        true if numbered && matches!(letters, "G" | "C" | "D") && !names.knows(stem) => Kind::Word,
        true if numbered || primed => Kind::Sure,
        true => Kind::Letter,
        false
            if names.knows(word)
                && (numbered || primed || letters.len() <= 3)
                && letters != "to" =>
        {
            Kind::Sure
        }
        false => Kind::Word,
    }
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
        spans(text, &Names::default()).iter().map(part).collect()
    }

    #[test]
    fn formulas_between_words_are_found() {
        for (sentence, expected) in [
            (
                "outside of the range of nu, by 1/2, it fails: at nu = 5/2, tan(pi/4*z) = 1/3, mu = -1",
                "outside of the range of ⟨ν⟩, by ⟨1/2⟩, it fails: at ⟨ν = 5/2⟩, ⟨tan(π/4z) = 1/3⟩, ⟨μ = −1⟩",
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
            let _ = spans(text, &Names::default());
        }
        assert_eq!(
            in_words(&spans("no formula here, none.", &Names::default())),
            "no formula here, none."
        );
    }
}
