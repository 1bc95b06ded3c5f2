//! Boxes written as Typst, as LaTeX and on one line of text.

use crate::math_box::{Fence, LetterFace, MathBox, MathChange};
use torse_syntax::greek;

/// The most letters that LaTeX frames: about a line of a letter.
const MAX_FRAMED: usize = 110;

/// Writes Typst mathematics, without dollar signs.
///
/// It calls only functions of the math scope and those of marks, which the templates define; everything else is single
/// letters, signs and quoted text, so no string of a file can act.
pub(crate) fn typst(node: &MathBox) -> String {
    typst_sized(node, false)
}

/// Writes a part of a formula; within scripts, fractions and matrices (`small`), what would become smaller than a script is
/// set in the size of one, so that it can be read.
fn typst_sized(node: &MathBox, small: bool) -> String {
    let typst = |node: &MathBox| typst_sized(node, small);
    let part = |node: &MathBox| {
        let text = typst_sized(node, true);
        if small {
            format!("script({text})")
        } else {
            text
        }
    };
    match node {
        MathBox::Letter(letter, face) => typst_letter(letter, *face),
        MathBox::Function(name) => name.clone(),
        MathBox::Number(digits) => digits.clone(),
        MathBox::Sign(sign) => typst_sign(*sign),
        MathBox::Row(nodes) if nodes.is_empty() => "\"\"".to_owned(),
        MathBox::Row(nodes) => nodes.iter().map(typst).collect::<Vec<_>>().join(" "),
        MathBox::Scripts {
            base,
            primes,
            below,
            above,
        } => {
            let base = match **base {
                MathBox::Row(_) | MathBox::Scripts { .. } => format!("attach({})", typst(base)),
                _ => typst(base),
            };
            let mut text = format!("{base}{}", "'".repeat(*primes));
            for (sign, script) in [('_', below), ('^', above)] {
                if let Some(script) = script {
                    let script = part(script);
                    let single =
                        script.chars().count() == 1 || script.chars().all(|c| c.is_ascii_digit());
                    match single {
                        true => text.push_str(&format!("{sign}{script}")),
                        false => text.push_str(&format!("{sign}({script})")),
                    }
                }
            }
            text
        }
        MathBox::Accent(sign, inner) => {
            let name = match sign {
                '^' => "hat",
                '~' => "tilde",
                _ => "overline",
            };
            format!("{name}({})", typst(inner))
        }
        MathBox::Fraction(above, below) => format!("frac({}, {})", part(above), part(below)),
        MathBox::Root(inner) => format!("sqrt({})", typst(inner)),
        MathBox::Binomial(n, k) => format!("binom({}, {})", part(n), part(k)),
        MathBox::Fenced(fence, inner) => {
            let inner = typst(inner);
            match fence {
                Fence::Round => format!("({inner})"),
                Fence::Square => format!("[{inner}]"),
                Fence::Bars => format!("abs({inner})"),
                Fence::Length => format!("norm({inner})"),
                Fence::Behind => format!("lr({inner} |)"),
            }
        }
        MathBox::Matrix(fence, rows) => {
            let delimiter = match fence {
                Fence::Bars => "|",
                _ => "(",
            };
            let cells = |row: &Vec<MathBox>| row.iter().map(part).collect::<Vec<_>>().join(", ");
            let rows: Vec<String> = rows.iter().map(cells).collect();
            format!("mat(delim: \"{delimiter}\", {})", rows.join("; "))
        }
        MathBox::Sum { below, above } => {
            let above = above.as_ref().map(|above| format!("^({})", part(above)));
            format!("sum_({}){}", part(below), above.unwrap_or_default())
        }
        MathBox::Marked(mark, inner) => {
            let name = match mark {
                MathChange::Added => "added",
                MathChange::Removed => "removed",
            };
            match &**inner {
                // A sign keeps its distance from the term before it.
                MathBox::Row(nodes) => match nodes.split_first() {
                    Some((MathBox::Sign(sign @ ('+' | '−')), rest)) => {
                        let term = typst(&MathBox::row(rest.iter().cloned()));
                        format!("{name}sign({sign}) {name}({term})")
                    }
                    _ => format!("{name}({})", typst(inner)),
                },
                MathBox::Sign(sign) => format!("{name}sign({})", typst_sign(*sign)),
                _ => format!("{name}({})", typst(inner)),
            }
        }
        MathBox::Gap => "thick".to_owned(),
    }
}

fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

fn typst_letter(letter: &str, face: LetterFace) -> String {
    let mut letters = letter.chars();
    let single = match (letters.next(), letters.next()) {
        (Some(c), None) if c.is_ascii_alphabetic() || ('Α'..='ω').contains(&c) => Some(c),
        _ => None,
    };
    match (single, face) {
        (Some(letter), LetterFace::Italic) => letter.to_string(),
        (Some(letter), LetterFace::Bold) => format!("upright(bold({letter}))"),
        (Some(letter), LetterFace::Upright) => format!("upright({letter})"),
        (None, LetterFace::Bold) => format!("bold({})", quoted(letter)),
        (None, _) => quoted(letter),
    }
}

fn typst_sign(sign: char) -> String {
    match sign {
        '(' | '[' => format!("class(\"opening\", \"{sign}\")"),
        ')' | ']' => format!("class(\"closing\", \"{sign}\")"),
        ',' => "comma".to_owned(),
        ';' => "semi".to_owned(),
        ':' => "colon".to_owned(),
        '·' => "dot.op".to_owned(),
        '/' => "class(\"normal\", slash)".to_owned(),
        '=' | '+' | '−' | '<' | '>' | '≤' | '≥' | '≠' | '≈' | '⋅' | '×' | '→' | '⇒' | '∈' | '∞'
        | '∑' | '∂' | '…' | '±' | '!' | '∥' | '∧' | '⊤' => sign.to_string(),
        other => quoted(&other.to_string()),
    }
}

/// Boxes side by side, with a blank between each two but before a comma or a semicolon.
fn latex_row(nodes: &[MathBox]) -> String {
    let mut row = String::new();
    for node in nodes {
        let is_mark = matches!(node, MathBox::Sign(',' | ';'));
        if !row.is_empty() && !is_mark {
            row.push(' ');
        }
        row.push_str(&latex(node));
    }
    row
}

/// Writes LaTeX mathematics, with the macros of amsmath, without dollar signs.
pub(crate) fn latex(node: &MathBox) -> String {
    match node {
        MathBox::Letter(letter, face) => latex_letter(letter, *face),
        MathBox::Function(name) => format!("\\{name}"),
        MathBox::Number(digits) => digits.replace('…', "\\ldots"),
        MathBox::Sign(sign) => latex_sign(*sign),
        MathBox::Row(nodes) => latex_row(nodes),
        MathBox::Scripts {
            base,
            primes,
            below,
            above,
        } => {
            let base = match **base {
                MathBox::Row(_) | MathBox::Scripts { .. } => format!("{{{}}}", latex(base)),
                _ => latex(base),
            };
            let mut text = format!("{base}{}", "'".repeat(*primes));
            for (sign, script) in [('_', below), ('^', above)] {
                if let Some(script) = script {
                    let script = latex(script).replace("\\boxed{", "\\boxed{\\scriptstyle ");
                    match script.chars().count() {
                        1 => text.push_str(&format!("{sign}{script}")),
                        _ => text.push_str(&format!("{sign}{{{script}}}")),
                    }
                }
            }
            text
        }
        MathBox::Accent(sign, inner) => {
            let name = match sign {
                '^' => "hat",
                '~' => "tilde",
                _ => "overline",
            };
            format!("\\{name}{{{}}}", latex(inner))
        }
        MathBox::Fraction(above, below) => {
            format!("\\frac{{{}}}{{{}}}", latex(above), latex(below))
        }
        MathBox::Root(inner) => format!("\\sqrt{{{}}}", latex(inner)),
        MathBox::Binomial(n, k) => format!("\\binom{{{}}}{{{}}}", latex(n), latex(k)),
        MathBox::Fenced(fence, inner) => {
            let inner = latex(inner);
            let (open, close) = match fence {
                Fence::Round => ("(", ")"),
                Fence::Square => ("[", "]"),
                Fence::Bars => ("\\lvert ", " \\rvert"),
                Fence::Length => ("\\lVert ", " \\rVert"),
                Fence::Behind => return format!("\\left. {inner} \\right|"),
            };
            let tall = ["\\frac", "\\sum", "\\binom", "matrix}"];
            match tall.iter().any(|part| inner.contains(part)) {
                true => format!("\\left{open} {inner} \\right{close}"),
                false => format!("{open}{inner}{close}"),
            }
        }
        MathBox::Matrix(fence, rows) => {
            let name = match fence {
                Fence::Bars => "vmatrix",
                _ => "pmatrix",
            };
            let cells = |row: &Vec<MathBox>| row.iter().map(latex).collect::<Vec<_>>().join(" & ");
            let rows: Vec<String> = rows.iter().map(cells).collect();
            format!("\\begin{{{name}}} {} \\end{{{name}}}", rows.join(" \\\\ "))
        }
        MathBox::Sum { below, above } => {
            let above = above.as_ref().map(|above| format!("^{{{}}}", latex(above)));
            format!("\\sum_{{{}}}{}", latex(below), above.unwrap_or_default())
        }
        // A frame does not break over lines: a long piece stands without one, beside what is framed before it.
        MathBox::Marked(_, inner) if text(inner).chars().count() > MAX_FRAMED => latex(inner),
        // A combining line at a sign would turn it into another sign.
        MathBox::Marked(_, inner) => match &**inner {
            MathBox::Sign(_) => format!("\\mathbin{{\\boxed{{{}}}}}", latex(inner)),
            MathBox::Row(nodes) => match nodes.split_first() {
                Some((MathBox::Sign(sign @ ('+' | '−')), rest)) if !rest.is_empty() => {
                    let term = latex(&MathBox::row(rest.iter().cloned()));
                    let sign = latex_sign(*sign);
                    format!("\\mathbin{{\\boxed{{{sign}}}}} \\boxed{{{term}}}")
                }
                _ => format!("\\boxed{{{}}}", latex(inner)),
            },
            _ => format!("\\boxed{{{}}}", latex(inner)),
        },
        MathBox::Gap => "\\ ".to_owned(),
    }
}

/// Escapes every sign of LaTeX in a text, and sets every letter that its fonts lack as mathematics.
pub fn latex_words(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        let letter = c.to_string();
        match c {
            '\\' => escaped.push_str("\\textbackslash{}"),
            '{' | '}' | '$' | '&' | '#' | '_' | '%' => {
                escaped.push('\\');
                escaped.push(c);
            }
            '^' => escaped.push_str("\\textasciicircum{}"),
            '~' => escaped.push_str("\\textasciitilde{}"),
            '²' | '³' | '⁰'..='⁹' => {
                escaped.push_str(&format!("\\textsuperscript{{{}}}", digit(c)))
            }
            '₀'..='₉' => escaped.push_str(&format!("\\textsubscript{{{}}}", digit(c))),
            '√' => escaped.push_str("\\ensuremath{\\surd}"),
            '’' => escaped.push('\''),
            '“' => escaped.push_str("``"),
            '”' => escaped.push_str("\'\'"),
            _ if greek::by_sign(c).is_some() => {
                escaped.push_str(&format!(
                    "\\ensuremath{{{}}}",
                    latex_letter(&letter, LetterFace::Italic)
                ));
            }
            '−' | '≤' | '≥' | '≠' | '≈' | '·' | '⋅' | '×' | '→' | '∈' | '∞' | '∑' | '∂' | '…'
            | '±' | '∥' | '∏' | '∫' | '∀' | '⇒' | '∧' | '⟨' | '⟩' => {
                escaped.push_str(&format!("\\ensuremath{{{}}}", latex_sign(c)));
            }
            // Signs above the letter before.
            '\u{302}' | '\u{303}' => {
                let base = escaped.pop().map(String::from).unwrap_or_default();
                let sign = if c == '\u{302}' { '^' } else { '~' };
                escaped.push_str(&format!("\\{sign}{{{base}}}"));
            }
            // Signs that the fonts of LaTeX have as commands.
            '\n' | '\u{20}'..='\u{7e}' | '\u{a1}'..='\u{17f}' | '–' | '—' | '‘' | '„' | '‚' =>
            {
                escaped.push(c);
            }
            '\u{a0}' => escaped.push('~'),
            _ => escaped.push_str(&format!("[U+{:04X}]", u32::from(c))),
        }
    }
    escaped
}

/// Returns the digit of a superscript or subscript.
fn digit(c: char) -> char {
    const RAISED: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹₀₁₂₃₄₅₆₇₈₉";
    let position = RAISED.chars().position(|raised| raised == c).unwrap_or(0);
    char::from_digit(u32::try_from(position % 10).unwrap_or(0), 10).unwrap_or('0')
}

fn latex_letter(letter: &str, face: LetterFace) -> String {
    let single = letter.chars().count() == 1;
    let sign = letter.chars().next().filter(|_| single);
    let greek = sign.and_then(greek::by_sign);
    match (greek, face) {
        (Some(greek), LetterFace::Bold) => format!("\\boldsymbol{{\\{}}}", greek.latex),
        (Some(greek), _) => format!("\\{}", greek.latex),
        (None, LetterFace::Bold) => format!("\\mathbf{{{}}}", latex_words(letter)),
        (None, LetterFace::Italic) if single => latex_words(letter),
        (None, _) => format!("\\mathrm{{{}}}", latex_words(letter)),
    }
}

fn latex_sign(sign: char) -> String {
    let command = match sign {
        '−' => "-",
        '≤' => "\\le",
        '≥' => "\\ge",
        '≠' => "\\ne",
        '≈' => "\\approx",
        '·' | '⋅' => "\\cdot",
        '×' => "\\times",
        '→' => "\\to",
        '⇒' => "\\implies",
        '∈' => "\\in",
        '∞' => "\\infty",
        '∑' => "\\sum",
        '∏' => "\\prod",
        '∫' => "\\int",
        '∀' => "\\forall",
        '∂' => "\\partial",
        '…' => "\\ldots",
        '±' => "\\pm",
        '∥' => "\\parallel",
        '∧' => "\\wedge",
        '⊤' => "\\top",
        '⟨' => "\\langle",
        '⟩' => "\\rangle",
        other => return latex_words(&other.to_string()),
    };
    command.to_owned()
}

/// Writes plain text on one line.
pub(crate) fn text(node: &MathBox) -> String {
    let mut line = String::new();
    write_text(node, &mut line, false);
    line
}

fn write_text(node: &MathBox, line: &mut String, tight: bool) {
    match node {
        MathBox::Letter(letter, _) => {
            let wide = letter.chars().count() > 1;
            if wide && line.ends_with(char::is_alphanumeric) && !tight {
                line.push(' ');
            }
            line.push_str(letter);
        }
        MathBox::Function(name) => {
            if line.ends_with(char::is_alphanumeric) && !tight {
                line.push(' ');
            }
            line.push_str(name);
        }
        MathBox::Number(digits) => {
            if line.ends_with(|c: char| c.is_ascii_digit()) {
                line.push(' ');
            }
            line.push_str(digits);
        }
        MathBox::Sign(sign) => text_sign(*sign, line, tight),
        MathBox::Row(nodes) => {
            for (number, node) in nodes.iter().enumerate() {
                let after_function = number > 0
                    && matches!(nodes.get(number - 1), Some(MathBox::Function(_)))
                    && !matches!(node, MathBox::Fenced(..));
                if after_function {
                    line.push(' ');
                }
                write_text(node, line, tight);
            }
        }
        MathBox::Scripts {
            base,
            primes,
            below,
            above,
        } => {
            write_text(base, line, tight);
            line.extend(std::iter::repeat_n('′', *primes));
            if let Some(below) = below {
                script(below, '_', line);
            }
            if let Some(above) = above {
                script(above, 'ˆ', line);
            }
        }
        MathBox::Accent(sign, inner) => {
            write_text(inner, line, tight);
            line.push(match sign {
                '^' => '\u{302}',
                '~' => '\u{303}',
                _ => '\u{304}',
            });
        }
        MathBox::Fraction(above, below) => {
            operand(above, line);
            line.push('/');
            operand(below, line);
        }
        MathBox::Root(inner) => {
            line.push('√');
            operand(inner, line);
        }
        MathBox::Binomial(n, k) => {
            line.push('(');
            write_text(n, line, tight);
            line.push_str(" over ");
            write_text(k, line, tight);
            line.push(')');
        }
        MathBox::Fenced(fence, inner) => {
            let (open, close) = match fence {
                Fence::Round => ("(", ")"),
                Fence::Square => ("[", "]"),
                Fence::Bars => ("|", "|"),
                Fence::Length => ("‖", "‖"),
                Fence::Behind => ("", "|"),
            };
            line.push_str(open);
            write_text(inner, line, tight);
            line.push_str(close);
        }
        MathBox::Matrix(_, rows) => {
            line.push('(');
            for (number, row) in rows.iter().enumerate() {
                if number > 0 {
                    line.push_str("; ");
                }
                for (number, cell) in row.iter().enumerate() {
                    if number > 0 {
                        line.push_str(", ");
                    }
                    write_text(cell, line, tight);
                }
            }
            line.push(')');
        }
        MathBox::Sum { below, above } => {
            line.push('∑');
            script(below, '_', line);
            if let Some(above) = above {
                script(above, 'ˆ', line);
            }
            line.push(' ');
        }
        MathBox::Marked(_, inner) => write_text(inner, line, tight),
        MathBox::Gap => {
            if !line.ends_with(' ') {
                line.push(' ');
            }
        }
    }
}

/// Adds brackets, unless it is a letter or a number.
fn operand(node: &MathBox, line: &mut String) {
    match node {
        MathBox::Row(_) | MathBox::Fraction(..) => {
            line.push('(');
            write_text(node, line, false);
            line.push(')');
        }
        _ => write_text(node, line, false),
    }
}

fn text_sign(sign: char, line: &mut String, tight: bool) {
    let infix = match sign {
        '=' | '<' | '>' | '≤' | '≥' | '≠' | '≈' | '→' | '⇒' | '∈' | '×' => true,
        // A sign has no left operand.
        '+' | '−' | '±' | '·' | '⋅' => line
            .trim_end()
            .ends_with(|c: char| !matches!(c, '(' | '[' | ',' | '=' | '<' | '>' | '≤' | '≥' | '≠')),
        _ => false,
    };
    match sign {
        _ if tight => line.push(sign),
        _ if infix => {
            if !line.is_empty() && !line.ends_with(' ') {
                line.push(' ');
            }
            line.push(sign);
            line.push(' ');
        }
        ',' | ';' => {
            line.push(sign);
            line.push(' ');
        }
        _ => line.push(sign),
    }
}

/// Uses superscript or subscript letters if all signs of the script have one.
fn script(node: &MathBox, sign: char, line: &mut String) {
    let mut inner = String::new();
    write_text(node, &mut inner, true);
    let small = |c: char| match sign {
        '_' => lowered(c),
        _ => raised(c),
    };
    match inner.chars().map(small).collect::<Option<String>>() {
        Some(small) => line.push_str(&small),
        None if inner.chars().count() == 1 => {
            line.push(sign);
            line.push_str(&inner);
        }
        None => line.push_str(&format!("{sign}({inner})")),
    }
}

fn lowered(c: char) -> Option<char> {
    const FROM: &str = "0123456789+−=()aehijklmnoprstuvxβγρφχ,";
    const TO: &str = "₀₁₂₃₄₅₆₇₈₉₊₋₌₍₎ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓᵦᵧᵨᵩᵪ,";
    FROM.chars()
        .zip(TO.chars())
        .find(|(from, _)| *from == c)
        .map(|(_, to)| to)
}

fn raised(c: char) -> Option<char> {
    const FROM: &str = "0123456789+−=()abcdefghijklmnoprstuvwxyzABDEGHIJKLMNOPRTUVWβγδθφχ,⊤XYZ";
    const TO: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁼⁽⁾ᵃᵇᶜᵈᵉᶠᵍʰⁱʲᵏˡᵐⁿᵒᵖʳˢᵗᵘᵛʷˣʸᶻᴬᴮᴰᴱᴳᴴᴵᴶᴷᴸᴹᴺᴼᴾᴿᵀᵁⱽᵂᵝᵞᵟᶿᵠᵡ,ᵀˣʸᶻ";
    FROM.chars()
        .zip(TO.chars())
        .find(|(from, _)| *from == c)
        .map(|(_, to)| to)
}
