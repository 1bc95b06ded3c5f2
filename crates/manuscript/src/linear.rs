//! Formulas on one line, as derivation files print them: `(a + b)/c`, `x^{n-1}`, Greek letters as signs.
//!
//! This changes only how a formula is laid out: every sign of the print is there, in its order, and none is read.

use torse_syntax::greek;
use torse_syntax::latex::item::{Nucleus, TexFace, TexItem};

/// Writes a list of items on one line.
pub fn linear(items: &[TexItem]) -> String {
    written(items, true)
}

/// Writes a list; signs stand between blanks, but not in scripts.
fn written(items: &[TexItem], is_wide: bool) -> String {
    let mut line = String::new();
    let mut before: Option<&TexItem> = None;
    for item in items {
        let piece = item_text(item);
        if between(before, item, &line, &piece, is_wide) {
            line.push(' ');
        }
        line.push_str(&piece);
        before = Some(item);
    }
    line
}

/// Whether a blank stands between an item and the one before it.
fn between(
    before: Option<&TexItem>,
    item: &TexItem,
    line: &str,
    piece: &str,
    is_wide: bool,
) -> bool {
    let Some(before) = before else {
        return false;
    };
    let sign = |item: &TexItem| match &item.nucleus {
        Nucleus::Sign(sign) => !matches!(
            sign.as_str(),
            "!" | "," | ";" | "." | ":" | "/" | "infty" | "partial" | "prime" | "top"
        ),
        _ => false,
    };
    let is_word = |item: &TexItem| matches!(item.nucleus, Nucleus::Words(_) | Nucleus::Operator(_));
    let is_big = |item: &TexItem| matches!(item.nucleus, Nucleus::Big(_) | Nucleus::Fraction(..));
    if before.is_sign(",")
        || before.is_sign(";")
        || is_word(item)
        || is_word(before) && !piece.starts_with('(')
    {
        return true;
    }
    if sign(before) || sign(item) {
        // A sign at the beginning belongs to what follows.
        let is_prefix = sign(before) && line.chars().count() == 1;
        return is_wide && !is_prefix;
    }
    let (last, next) = (
        line.chars().last().unwrap_or(' '),
        piece.chars().next().unwrap_or(' '),
    );
    // Nothing runs into what stands behind it: digits, words, scripts, denominators.
    is_big(before) && (next.is_alphanumeric() || next == '(')
        || last == '}' && next.is_alphanumeric()
        || last.is_ascii_digit() && next.is_ascii_digit()
}

fn item_text(item: &TexItem) -> String {
    let nucleus = nucleus_text(&item.nucleus);
    let script = |sign: char, list: &Option<Vec<TexItem>>| match list {
        None => String::new(),
        Some(list) => {
            let text = written(list, false);
            match text.chars().count() {
                1 => format!("{sign}{text}"),
                _ => format!("{sign}{{{text}}}"),
            }
        }
    };
    format!(
        "{nucleus}{}{}{}",
        script('_', &item.below),
        "'".repeat(item.primes),
        script('^', &item.above)
    )
}

/// A text in brackets, unless it is one letter or one number.
fn grouped(list: &[TexItem]) -> String {
    let text = linear(list);
    let simple =
        matches!(list, [one] if matches!(one.nucleus, Nucleus::Letter(..) | Nucleus::Number(_)));
    match simple {
        true => text,
        false => format!("({text})"),
    }
}

fn nucleus_text(nucleus: &Nucleus) -> String {
    match nucleus {
        Nucleus::Number(digits) => digits.clone(),
        Nucleus::Letter(letters, face) => {
            let letter = greek::by_name(letters)
                .map_or_else(|| letters.clone(), |letter| letter.sign.to_string());
            accented(letter, face)
        }
        Nucleus::Operator(name) => name.clone(),
        Nucleus::Sign(sign) => sign_text(sign).to_owned(),
        Nucleus::Words(words) => words.clone(),
        Nucleus::Fenced(open, list, close) => {
            let mark = |sign: &char| match sign {
                '.' => String::new(),
                other => other.to_string(),
            };
            format!("{}{}{}", mark(open), linear(list), mark(close))
        }
        Nucleus::Group(list) => format!("({})", linear(list)),
        Nucleus::Fraction(over, under) => format!("{}/{}", grouped(over), grouped(under)),
        Nucleus::Root(None, list) => format!("√({})", linear(list)),
        Nucleus::Root(Some(degree), list) => {
            format!("root_{{{}}}({})", linear(degree), linear(list))
        }
        Nucleus::Binomial(n, k) => format!("({} choose {})", linear(n), linear(k)),
        Nucleus::Grid(name, rows) => {
            let rows = rows.iter().map(|row| {
                row.iter()
                    .map(|cell| linear(cell))
                    .collect::<Vec<_>>()
                    .join(", ")
            });
            let rows = rows.collect::<Vec<_>>().join("; ");
            match name.as_str() {
                "vmatrix" => format!("|{rows}|"),
                "cases" | "dcases" => format!("{{ {rows}"),
                _ => format!("[{rows}]"),
            }
        }
        Nucleus::Dotted(count, list) => format!("{}{}", grouped(list), "\u{307}".repeat(*count)),
        Nucleus::Big(kind) => match kind.as_str() {
            "sum" => "∑".to_owned(),
            "prod" => "∏".to_owned(),
            _ => "∫".to_owned(),
        },
        Nucleus::Dots => "...".to_owned(),
    }
}

fn accented(letter: String, face: &TexFace) -> String {
    match face {
        TexFace::Accent(name, _) => {
            let sign = match name.as_str() {
                "hat" => '\u{302}',
                "tilde" => '\u{303}',
                _ => '\u{304}',
            };
            format!("{letter}{sign}")
        }
        _ => letter,
    }
}

fn sign_text(sign: &str) -> &str {
    match sign {
        "-" => "−",
        "cdot" => "·",
        "times" => "×",
        "le" => "≤",
        "ge" => "≥",
        "ne" => "≠",
        "in" => "∈",
        "pm" => "±",
        "mp" => "∓",
        "infty" => "∞",
        "partial" => "∂",
        "top" => "⊤",
        "to" => "→",
        "implies" => "⇒",
        "iff" => "⇔",
        "approx" => "≈",
        "equiv" => "≡",
        "quad" => " ",
        "forall" => "∀",
        "exists" => "∃",
        "parallel" => "∥",
        "perp" => "⊥",
        "circ" => "∘",
        "wedge" => "∧",
        "vee" => "∨",
        "nabla" => "∇",
        "sim" => "∼",
        other => other,
    }
}
