//! Boxes written as MathML Core, which every browser shows without a script.

use crate::math_box::{Fence, LetterFace, MathBox, MathChange};

/// Writes the formula as elements between which a line may be broken: before relations, plus and minus, within brackets
/// and between factors where a piece would be long.
pub(crate) fn pieces(node: &MathBox) -> Vec<String> {
    let cuts = finest(node, MAX_LINE_WIDTH);
    let last = cuts.len().saturating_sub(1);
    let piece = |(number, piece): (usize, &Vec<MathBox>)| {
        let mut out = String::from("<math>");
        for (position, node) in piece.iter().enumerate() {
            // The operand of a sign at the beginning of a line is on the line before.
            match node {
                MathBox::Sign(sign) if position == 0 && number > 0 => {
                    out.push_str(&format!("<mo form=\"infix\">{}</mo>", escaped(*sign)));
                }
                _ => write(node, &mut out),
            }
        }
        out.push_str("</math>");
        if number < last {
            out.push_str("<wbr>");
        }
        out
    };
    cuts.iter().enumerate().map(piece).collect()
}

/// Returns the pieces of [`cuts`]; those that are still too wide are cut before factors.
pub(crate) fn finest(node: &MathBox, longest: usize) -> Vec<Vec<MathBox>> {
    let pieces = cuts(node, longest).into_iter();
    pieces.flat_map(|piece| factors(piece, longest)).collect()
}

/// Cuts a piece that is wider than `longest` letters before factors, never between a function and its argument; commas
/// stay after the part that they end.
fn factors(piece: Vec<MathBox>, longest: usize) -> Vec<Vec<MathBox>> {
    let mut list: Vec<Vec<MathBox>> = vec![vec![]];
    let mut used = 0;
    for node in piece {
        let wide = width(std::slice::from_ref(&node));
        let factor = !matches!(node, MathBox::Fenced(..) | MathBox::Sign(_) | MathBox::Gap);
        let before = list.last().and_then(|piece| piece.last());
        let bound = matches!(
            before,
            None | Some(MathBox::Function(_) | MathBox::Sum { .. })
        ) || matches!(before, Some(MathBox::Sign(sign)) if *sign != ',');
        match list.last_mut() {
            Some(piece) if !(factor && !bound && used + wide > longest) => {
                piece.push(node);
                used += wide;
            }
            _ => {
                list.push(vec![node]);
                used = wide;
            }
        }
    }
    list
}

/// Pieces wider than about this many letters are cut within their brackets.
const MAX_LINE_WIDTH: usize = 26;

/// Maximum depth of brackets that are opened.
const MAX_DEPTH: usize = 4;

/// Returns the boxes of a formula in pieces: cut before relations, plus and minus, and within brackets where a piece is
/// wider than `longest` letters.
pub(crate) fn cuts(node: &MathBox, longest: usize) -> Vec<Vec<MathBox>> {
    let nodes = match node {
        MathBox::Row(nodes) => nodes.clone(),
        other => vec![other.clone()],
    };
    let mut list = vec![nodes];
    for _ in 0..MAX_DEPTH {
        let mut cut = Vec::new();
        for piece in list {
            let parts = split(piece);
            for part in parts {
                match width(&part) > longest {
                    true => cut.push(opened(part)),
                    false => cut.push(part),
                }
            }
        }
        list = cut.into_iter().flat_map(split).collect();
    }
    list
}

fn width(nodes: &[MathBox]) -> usize {
    let letters = |node: &MathBox| crate::write::text(node).chars().count();
    nodes.iter().map(letters).sum()
}

/// Cuts before each relation, plus and minus that has a left operand.
fn split(nodes: Vec<MathBox>) -> Vec<Vec<MathBox>> {
    let mut list: Vec<Vec<MathBox>> = vec![vec![]];
    for node in nodes {
        let cuts = matches!(
            leading(&node),
            Some('+' | '−' | '=' | '<' | '>' | '≤' | '≥' | '≠' | '≈' | '⇒')
        );
        let before = list.last().and_then(|piece| piece.last());
        let operand = before.is_some_and(|before| {
            !matches!(
                unframed(before),
                MathBox::Sign(
                    '(' | '[' | ',' | '+' | '−' | '=' | '<' | '>' | '≤' | '≥' | '≠' | '≈'
                )
            )
        });
        match list.last_mut() {
            Some(piece) if !(cuts && operand) => piece.push(node),
            _ => list.push(vec![node]),
        }
    }
    list
}

/// What is in a frame, or the box itself.
fn unframed(node: &MathBox) -> &MathBox {
    match node {
        MathBox::Marked(_, inner) => inner,
        node => node,
    }
}

/// The sign with which a box begins, framed or not.
fn leading(node: &MathBox) -> Option<char> {
    match (node, unframed(node)) {
        (_, MathBox::Sign(sign)) => Some(*sign),
        (MathBox::Marked(..), MathBox::Row(nodes)) => nodes.first().and_then(leading),
        _ => None,
    }
}

/// Turns brackets around a sum into signs of their own.
fn opened(nodes: Vec<MathBox>) -> Vec<MathBox> {
    let mut list = Vec::new();
    for node in nodes {
        match node {
            MathBox::Fenced(fence @ (Fence::Round | Fence::Square), inner)
                if matches!(*inner, MathBox::Row(_)) =>
            {
                let (open, close) = match fence {
                    Fence::Square => ('[', ']'),
                    _ => ('(', ')'),
                };
                list.push(MathBox::Sign(open));
                match *inner {
                    MathBox::Row(nodes) => list.extend(nodes),
                    other => list.push(other),
                }
                list.push(MathBox::Sign(close));
            }
            other => list.push(other),
        }
    }
    list
}

fn write(node: &MathBox, out: &mut String) {
    match node {
        MathBox::Letter(letter, face) => letter_of(letter, *face, out),
        MathBox::Function(name) => out.push_str(&format!("<mi>{name}</mi><mo>\u{2061}</mo>")),
        MathBox::Number(digits) => out.push_str(&format!("<mn>{digits}</mn>")),
        MathBox::Sign(sign @ ('(' | ')' | '[' | ']' | '|')) => {
            out.push_str(&format!("<mo stretchy=\"false\">{sign}</mo>"));
        }
        MathBox::Sign(sign) => out.push_str(&format!("<mo>{}</mo>", escaped(*sign))),
        MathBox::Row(nodes) => {
            out.push_str("<mrow>");
            nodes.iter().for_each(|node| write(node, out));
            out.push_str("</mrow>");
        }
        MathBox::Scripts {
            base,
            primes,
            below,
            above,
        } => scripts(base, *primes, below.as_deref(), above.as_deref(), out),
        MathBox::Accent(sign, inner) => {
            let sign = match sign {
                '^' => 'ˆ',
                '~' => '˜',
                _ => '‾',
            };
            out.push_str("<mover accent=\"true\">");
            write(inner, out);
            out.push_str(&format!("<mo stretchy=\"false\">{sign}</mo></mover>"));
        }
        MathBox::Fraction(above, below) => {
            element("mfrac", &[above, below], out);
        }
        MathBox::Root(inner) => element("msqrt", &[inner], out),
        MathBox::Binomial(n, k) => {
            out.push_str("<mrow><mo>(</mo><mfrac linethickness=\"0\">");
            write(n, out);
            write(k, out);
            out.push_str("</mfrac><mo>)</mo></mrow>");
        }
        MathBox::Fenced(fence, inner) => {
            let (open, close) = match fence {
                Fence::Round => ("(", ")"),
                Fence::Square => ("[", "]"),
                Fence::Bars => ("|", "|"),
                Fence::Length => ("‖", "‖"),
                Fence::Behind => ("", "|"),
            };
            // Brackets of normal height stay close to their contents.
            let fixed = match is_tall(inner) {
                true => "",
                false => " stretchy=\"false\"",
            };
            out.push_str("<mrow>");
            if !open.is_empty() {
                out.push_str(&format!("<mo{fixed}>{open}</mo>"));
            }
            write(inner, out);
            out.push_str(&format!("<mo{fixed}>{close}</mo></mrow>"));
        }
        MathBox::Matrix(fence, rows) => {
            let (open, close) = match fence {
                Fence::Bars => ("|", "|"),
                _ => ("(", ")"),
            };
            out.push_str(&format!("<mrow><mo>{open}</mo><mtable>"));
            for row in rows {
                out.push_str("<mtr>");
                for cell in row {
                    element("mtd", &[cell], out);
                }
                out.push_str("</mtr>");
            }
            out.push_str(&format!("</mtable><mo>{close}</mo></mrow>"));
        }
        MathBox::Sum { below, above } => {
            let name = match above {
                Some(_) => "munderover",
                None => "munder",
            };
            out.push_str(&format!("<{name}><mo>∑</mo>"));
            write(below, out);
            if let Some(above) = above {
                write(above, out);
            }
            out.push_str(&format!("</{name}>"));
        }
        MathBox::Marked(mark, inner) => {
            let class = match mark {
                MathChange::Added => "added",
                MathChange::Removed => "removed",
            };
            out.push_str(&format!("<mrow class=\"{class}\">"));
            write(inner, out);
            out.push_str("</mrow>");
        }
        MathBox::Gap => out.push_str("<mspace width=\"0.4em\"/>"),
    }
}

/// Whether a box is higher than a line.
fn is_tall(node: &MathBox) -> bool {
    match node {
        MathBox::Fraction(..)
        | MathBox::Binomial(..)
        | MathBox::Matrix(..)
        | MathBox::Sum { .. } => true,
        MathBox::Row(nodes) => nodes.iter().any(is_tall),
        MathBox::Scripts { base, .. } => is_tall(base),
        MathBox::Fenced(_, inner)
        | MathBox::Marked(_, inner)
        | MathBox::Root(inner)
        | MathBox::Accent(_, inner) => is_tall(inner),
        _ => false,
    }
}

fn element(name: &str, parts: &[&MathBox], out: &mut String) {
    out.push_str(&format!("<{name}>"));
    parts.iter().for_each(|part| write(part, out));
    out.push_str(&format!("</{name}>"));
}

fn scripts(
    base: &MathBox,
    primes: usize,
    below: Option<&MathBox>,
    above: Option<&MathBox>,
    out: &mut String,
) {
    let raised = primes > 0 || above.is_some();
    let name = match (below.is_some(), raised) {
        (true, true) => "msubsup",
        (true, false) => "msub",
        _ => "msup",
    };
    out.push_str(&format!("<{name}>"));
    // The function with its exponent is what is applied: the sign of the application follows both.
    match base {
        MathBox::Function(function) => out.push_str(&format!("<mi>{function}</mi>")),
        _ => write(base, out),
    }
    if let Some(below) = below {
        write(below, out);
    }
    if raised {
        let signs = match primes {
            0 => "",
            1 => "<mo>′</mo>",
            2 => "<mo>″</mo>",
            3 => "<mo>‴</mo>",
            _ => "<mo>⁗</mo>",
        };
        match above {
            Some(above) if primes > 0 => {
                out.push_str(&format!("<mrow>{signs}"));
                write(above, out);
                out.push_str("</mrow>");
            }
            Some(above) => write(above, out),
            None => out.push_str(signs),
        }
    }
    out.push_str(&format!("</{name}>"));
    if matches!(base, MathBox::Function(_)) {
        out.push_str("<mo>\u{2061}</mo>");
    }
}

fn letter_of(letter: &str, face: LetterFace, out: &mut String) {
    let text: String = letter.chars().map(escaped).collect();
    let single = letter.chars().count() == 1;
    match face {
        LetterFace::Bold => out.push_str(&format!(
            "<mi mathvariant=\"normal\" class=\"bold\">{text}</mi>"
        )),
        LetterFace::Upright if single => {
            out.push_str(&format!("<mi mathvariant=\"normal\">{text}</mi>"))
        }
        _ if single => out.push_str(&format!("<mi>{text}</mi>")),
        _ => out.push_str(&format!("<mtext>{text}</mtext>")),
    }
}

fn escaped(c: char) -> String {
    match c {
        '&' => "&amp;".to_owned(),
        '<' => "&lt;".to_owned(),
        '>' => "&gt;".to_owned(),
        '"' => "&quot;".to_owned(),
        _ => c.to_string(),
    }
}
