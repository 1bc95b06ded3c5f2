//! Parses the subset of LaTeX that files write between dollar signs, and that quotations contain: letters, scripts,
//! Greek, signs.
//!
//! Any text is accepted: an unknown command loses its backslash, a bracket without a partner is a sign.

use crate::letters::{by_rule, greek_letter, is_function};
use crate::math_box::{Fence, LetterFace, MathBox};
use crate::signs;

/// Returns the boxes of a text between dollar signs; none if there is anything outside.
pub(crate) fn dollars(text: &str) -> Option<MathBox> {
    let inner = text.trim().strip_prefix('$')?.strip_suffix('$')?;
    (!inner.contains('$')).then(|| boxes(inner))
}

/// Mathematics as boxes.
pub(crate) fn boxes(text: &str) -> MathBox {
    // Prints write a scalar product as a dot between blanks.
    let text = text.replace(" . ", " ⋅ ");
    let mut reader = Reader {
        rest: &text,
        depth: 0,
    };
    reader.row(None)
}

/// Brackets nested more deeply stay signs.
const MAX_DEPTH: usize = 40;

struct Reader<'a> {
    rest: &'a str,
    depth: usize,
}

impl<'a> Reader<'a> {
    fn next(&mut self) -> Option<char> {
        let next = self.rest.chars().next()?;
        self.rest = self.rest.get(next.len_utf8()..).unwrap_or_default();
        Some(next)
    }

    fn peek(&self) -> Option<char> {
        self.rest.chars().next()
    }

    fn take(&mut self, keep: impl Fn(char) -> bool) -> &'a str {
        let end = self.rest.find(|c| !keep(c)).unwrap_or(self.rest.len());
        let (taken, rest) = self.rest.split_at(end);
        self.rest = rest;
        taken
    }

    /// Reads boxes up to the closing bracket, which is consumed, or the end.
    fn row(&mut self, closing: Option<char>) -> MathBox {
        let mut nodes: Vec<MathBox> = Vec::new();
        while let Some(next) = self.peek() {
            if Some(next) == closing {
                self.next();
                break;
            }
            match next {
                '_' | '^' => {
                    self.next();
                    let script = self.script();
                    let base = nodes.pop().unwrap_or(MathBox::Row(vec![]));
                    nodes.push(match next {
                        '_' => base.scripted(0, Some(script), None),
                        _ => base.scripted(0, None, Some(script)),
                    });
                }
                '~' if nodes
                    .last()
                    .is_some_and(|node| matches!(node, MathBox::Letter(..))) =>
                {
                    self.next();
                    let base = nodes.pop().unwrap_or(MathBox::Row(vec![]));
                    nodes.push(MathBox::Accent('~', Box::new(base)));
                }
                '\'' | '′' => {
                    let primes = self.take(|c| matches!(c, '\'' | '′')).chars().count();
                    let base = nodes.pop().unwrap_or(MathBox::Row(vec![]));
                    nodes.push(base.scripted(primes, None, None));
                }
                '²' | '³' => {
                    self.next();
                    let power = MathBox::Number(if next == '²' { "2" } else { "3" }.to_owned());
                    let base = nodes.pop().unwrap_or(MathBox::Row(vec![]));
                    nodes.push(base.scripted(0, None, Some(power)));
                }
                // A sign above a letter that is typed after it.
                '\u{302}' | '\u{303}' if !nodes.is_empty() => {
                    self.next();
                    let sign = if next == '\u{302}' { '^' } else { '~' };
                    let base = nodes.pop().unwrap_or(MathBox::Row(vec![]));
                    nodes.push(MathBox::Accent(sign, Box::new(base)));
                }
                _ => nodes.extend(self.one()),
            }
        }
        MathBox::row(nodes)
    }

    /// Reads a script: a group, a command, a number or a letter.
    fn script(&mut self) -> MathBox {
        match self.peek() {
            Some('{') => {
                self.next();
                self.group('}')
            }
            Some('(') if self.rest.contains(')') => {
                self.next();
                self.group(')')
            }
            Some(c) if c.is_ascii_digit() => {
                MathBox::Number(self.take(|c| c.is_ascii_digit()).to_owned())
            }
            Some(_) => self.one().unwrap_or(MathBox::Row(vec![])),
            None => MathBox::Row(vec![]),
        }
    }

    fn group(&mut self, closing: char) -> MathBox {
        if self.depth >= MAX_DEPTH {
            return MathBox::Row(vec![]);
        }
        self.depth += 1;
        let row = self.row(Some(closing));
        self.depth -= 1;
        row
    }

    fn argument(&mut self) -> MathBox {
        self.take(|c| c == ' ');
        self.script()
    }

    /// Reads one box; none for a blank.
    fn one(&mut self) -> Option<MathBox> {
        let next = self.next()?;
        let fence = |fence, inner: MathBox| MathBox::Fenced(fence, Box::new(inner));
        Some(match next {
            c if c.is_whitespace() => return None,
            '\\' => return self.command(),
            '{' => self.group('}'),
            '(' if self.closes('(', ')') => fence(Fence::Round, self.group(')')),
            '[' if self.closes('[', ']') => fence(Fence::Square, self.group(']')),
            '|' if self.rest.contains('|') => fence(Fence::Bars, self.group('|')),
            '√' => MathBox::Root(Box::new(self.argument())),
            c if c.is_ascii_digit() => {
                let more = self.take(|c| c.is_ascii_digit() || c == '.');
                let digits = format!("{c}{more}");
                // A full stop after the number does not belong to it.
                match digits.trim_end_matches('.') {
                    whole if whole.len() < digits.len() && !digits.ends_with("..") => {
                        MathBox::row([MathBox::Number(whole.to_owned()), MathBox::Sign('.')])
                    }
                    whole if whole.len() < digits.len() => MathBox::Number(format!("{whole}…")),
                    whole => MathBox::Number(whole.to_owned()),
                }
            }
            c if c.is_ascii_alphabetic() => {
                let more = self.take(|c| c.is_ascii_alphabetic());
                return Some(self.letters(&format!("{c}{more}")));
            }
            'Ĝ' => MathBox::Accent('^', Box::new(MathBox::italic("G"))),
            'Ĥ' => MathBox::Accent('^', Box::new(MathBox::italic("H"))),
            c if c.is_alphanumeric() => MathBox::Letter(c.to_string(), LetterFace::Italic),
            '/' if matches!(self.peek(), Some('/' | '\\')) => match self.next() {
                Some('/') => MathBox::Sign('∥'),
                _ => MathBox::Sign('∧'),
            },
            '-' if self.peek() == Some('>') => {
                self.next();
                MathBox::Sign('→')
            }
            '<' | '>' | '!' | '=' if self.peek() == Some('=') => {
                self.next();
                MathBox::Sign(match next {
                    '<' => '≤',
                    '>' => '≥',
                    '!' => '≠',
                    _ => '=',
                })
            }
            '-' => MathBox::Sign('−'),
            '*' => MathBox::Sign('·'),
            '~' => MathBox::Gap,
            c => MathBox::Sign(c),
        })
    }

    /// Whether the bracket that was just opened is closed.
    fn closes(&self, open: char, close: char) -> bool {
        let mut depth = 1_usize;
        for c in self.rest.chars() {
            if c == open {
                depth += 1;
            } else if c == close {
                depth -= 1;
                if depth == 0 {
                    return true;
                }
            }
        }
        false
    }

    /// Reads letters without a backslash: a known word, or letters side by side.
    fn letters(&mut self, letters: &str) -> MathBox {
        let root = letters == "sqrt" && self.peek() == Some('(');
        if root {
            self.next();
            return MathBox::Root(Box::new(self.group(')')));
        }
        if letters == "binom" && self.peek() == Some('(') {
            self.next();
            let MathBox::Row(inner) = self.group(')') else {
                return MathBox::word(letters);
            };
            let comma = inner.iter().position(|node| *node == MathBox::Sign(','));
            let comma = comma.unwrap_or(inner.len());
            let part = |list: &[MathBox]| Box::new(MathBox::row(list.iter().cloned()));
            let (above, below) = (inner.get(..comma), inner.get(comma + 1..));
            return MathBox::Binomial(
                part(above.unwrap_or_default()),
                part(below.unwrap_or_default()),
            );
        }
        match letters {
            "sum" => MathBox::Sign('∑'),
            "infinity" => MathBox::Sign('∞'),
            "and" | "or" | "not" | "for" | "with" | "in" | "span" => {
                MathBox::row([MathBox::Gap, MathBox::word(letters), MathBox::Gap])
            }
            // x1 is typed for x_1.
            _ if (letters.len() == 1 || greek_letter(letters).is_some())
                && self.peek().is_some_and(|c| c.is_ascii_digit()) =>
            {
                let digits = self.take(|c| c.is_ascii_digit());
                by_rule(&format!("{letters}{digits}"))
            }
            _ if greek_letter(letters).is_some() || is_function(letters) || letters == "det" => {
                by_rule(letters)
            }
            _ if letters.len() <= 2 => {
                MathBox::row(letters.chars().map(|c| MathBox::italic(&c.to_string())))
            }
            _ => MathBox::word(letters),
        }
    }

    fn command(&mut self) -> Option<MathBox> {
        let name = self.take(|c| c.is_ascii_alphabetic());
        if name.is_empty() {
            return match self.next()? {
                ',' | ';' | ':' | ' ' | '!' => None,
                c => Some(MathBox::Sign(c)),
            };
        }
        if let Some(sign) = signs::sign(name) {
            return Some(MathBox::Sign(sign));
        }
        match name {
            "mathbf" | "mathrm" | "text" | "operatorname" => {
                let face = match name {
                    "mathbf" => LetterFace::Bold,
                    _ => LetterFace::Upright,
                };
                Some(in_face(self.argument(), face))
            }
            "hat" | "widehat" => Some(MathBox::Accent('^', Box::new(self.argument()))),
            "tilde" | "widetilde" => Some(MathBox::Accent('~', Box::new(self.argument()))),
            "bar" | "overline" => Some(MathBox::Accent('¯', Box::new(self.argument()))),
            "frac" | "tfrac" => {
                let (above, below) = (self.argument(), self.argument());
                Some(MathBox::Fraction(Box::new(above), Box::new(below)))
            }
            "sqrt" => Some(MathBox::Root(Box::new(self.argument()))),
            "quad" | "qquad" => Some(MathBox::Gap),
            "left" | "right" => None,
            _ => Some(by_rule(name)),
        }
    }
}

/// Sets the letters of the box in a face.
fn in_face(node: MathBox, face: LetterFace) -> MathBox {
    match node {
        MathBox::Letter(letter, _) => MathBox::Letter(letter, face),
        // A word is one box.
        MathBox::Row(nodes) => {
            let letters = nodes.iter().map(|node| match node {
                MathBox::Letter(letter, _) => Some(letter.as_str()),
                _ => None,
            });
            match letters.collect::<Option<String>>() {
                Some(word) => MathBox::Letter(word, face),
                None => MathBox::Row(nodes.into_iter().map(|node| in_face(node, face)).collect()),
            }
        }
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::write::{latex, text, typst};

    #[test]
    fn what_files_write_between_dollar_signs_is_read() {
        for (given, shown) in [
            (r"$\mathbf{p}_0^u$", "p₀ᵘ"),
            (r"$Q_{k-2,1}$", "Qₖ₋₂,₁"),
            (r"$\tilde T^Z_{rotation}$", "T̃ᵣₒₜₐₜᵢₒₙᶻ"),
            (r"$a'(x) \ne 0$", "a′(x) ≠ 0"),
            (r"$-16 k^3 (k - 1)$", "−16k³(k − 1)"),
            (r"$\frac{1}{2} \pi$", "1/2π"),
        ] {
            assert_eq!(text(&dollars(given).unwrap()), shown, "{given}");
        }
        assert!(dollars("x").is_none() && dollars("$x$ and $y$").is_none());
    }

    #[test]
    fn what_is_read_can_be_written_in_every_language() {
        let node = boxes(r"\mathbf{p}_0^u + \hat G(1)");
        assert_eq!(typst(&node), "upright(bold(p))_0^u + hat(G) (1)");
        assert_eq!(latex(&node), r"\mathbf{p}_0^u + \hat{G} (1)");
    }

    #[test]
    fn anything_is_read() {
        for text in [
            "(",
            ")(",
            "\\",
            "{{{",
            "_^",
            "x_{",
            "√",
            "'",
            "[(])",
            &"(".repeat(500),
        ] {
            let _ = typst(&boxes(text));
        }
    }
}
