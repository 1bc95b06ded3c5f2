//! The small language of labels: text with mathematics between dollar signs.
//!
//! ```text
//! label  = { text | "$" math "$" }            "\$" is a dollar sign
//! math   = { atom [ "_" atom ] [ "^" atom ] }
//! atom   = character | "\name" | "{" math "}" | "\mathbf{" letters "}" | "\mathrm{" text "}"
//! ```
//!
//! Letters are italic in mathematics and figures upright, blanks mean nothing there, relations and binary
//! operations get their usual room. `\name` is a Greek letter, a sign or a function name, see [`named_sign`].

use crate::error::{FigureError, LabelProblem};
use crate::ink::font::Style;
use torse_typography::{FUNCTIONS, signs};

/// A parsed label.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Node {
    Char(char, Style),
    /// Horizontal room in em.
    Space(f64),
    Scripts {
        sub: Vec<Node>,
        sup: Vec<Node>,
    },
}

/// What a character of a formula does to its neighbours.
#[derive(Clone, Copy, PartialEq)]
enum Class {
    Ordinary,
    Operation,
    Relation,
    Open,
}

/// The sign of a root, which labels set without its bar.
const ROOT: (&str, char) = ("sqrt", '√');

/// The sign that `\\name` stands for: a root, one of [`signs::SIGNS`], or a Greek letter.
fn named_sign(name: &str) -> Option<char> {
    match signs::sign(name) {
        _ if name == ROOT.0 => Some(ROOT.1),
        // The fonts have the dot at the height of capitals alone.
        Some('⋅') => Some('·'),
        Some(sign) => Some(sign),
        None => signs::letter(name),
    }
}

/// Operators that labels set upright, beside [`FUNCTIONS`].
const OPERATORS: [&str; 3] = ["det", "lim", "arg"];

const MEDIUM: f64 = 0.20;
const THICK: f64 = 0.26;
const THIN: f64 = 0.16;
const MAX_DEPTH: usize = 2;

/// Parse a label; the error names the byte at fault.
pub(crate) fn parse(label: &str) -> Result<Vec<Node>, FigureError> {
    Parser {
        label,
        rest: label.char_indices().peekable(),
    }
    .text()
}

struct Parser<'a> {
    label: &'a str,
    rest: std::iter::Peekable<std::str::CharIndices<'a>>,
}

impl Parser<'_> {
    fn fault<T>(&self, at: usize, problem: LabelProblem) -> Result<T, FigureError> {
        Err(FigureError::Label {
            label: self.label.to_owned(),
            at,
            problem,
        })
    }

    fn text(&mut self) -> Result<Vec<Node>, FigureError> {
        let mut nodes = Vec::new();
        while let Some((at, ch)) = self.rest.next() {
            match ch {
                '$' => nodes.extend(self.math(at, Some('$'), 0)?),
                '\\' if self.rest.next_if(|&(_, c)| c == '$').is_some() => {
                    nodes.push(Node::Char('$', Style::Upright));
                }
                ' ' => nodes.push(Node::Space(0.25)),
                _ => nodes.push(Node::Char(ch, Style::Upright)),
            }
        }
        Ok(nodes)
    }

    /// Formula up to `close`; `start` is where it began, for the error.
    fn math(
        &mut self,
        start: usize,
        close: Option<char>,
        depth: usize,
    ) -> Result<Vec<Node>, FigureError> {
        let mut nodes = Vec::new();
        let mut before = Class::Open;
        while let Some((at, ch)) = self.rest.next() {
            if Some(ch) == close {
                return Ok(nodes);
            }
            match ch {
                ' ' => {}
                '}' => return self.fault(at, LabelProblem::Brace),
                '$' => return self.fault(start, LabelProblem::Brace),
                '_' | '^' => {
                    let scripts = self.scripts(at, ch, depth)?;
                    nodes.push(scripts);
                    before = Class::Ordinary;
                }
                _ => before = self.atom(at, ch, before, depth, &mut nodes)?,
            }
        }
        let problem = if close == Some('$') {
            LabelProblem::OpenMath
        } else {
            LabelProblem::Brace
        };
        self.fault(start, problem)
    }

    /// One atom, appended with its room; returns its class.
    fn atom(
        &mut self,
        at: usize,
        ch: char,
        before: Class,
        depth: usize,
        nodes: &mut Vec<Node>,
    ) -> Result<Class, FigureError> {
        match ch {
            '{' => {
                nodes.extend(self.math(at, Some('}'), depth)?);
                Ok(Class::Ordinary)
            }
            '\\' => self.command(at, before, depth, nodes),
            _ => Ok(sign(ch, before, depth, nodes)),
        }
    }

    fn command(
        &mut self,
        at: usize,
        before: Class,
        depth: usize,
        nodes: &mut Vec<Node>,
    ) -> Result<Class, FigureError> {
        let mut name = String::new();
        while let Some((_, c)) = self.rest.next_if(|(_, c)| c.is_ascii_alphabetic()) {
            name.push(c);
        }
        if name.is_empty() {
            match self.rest.next() {
                Some((_, ',')) => {
                    nodes.push(Node::Space(THIN));
                    return Ok(before);
                }
                Some((_, c)) => name.push(c),
                None => {}
            }
        }
        if let Some(ch) = named_sign(&name) {
            return Ok(sign(ch, before, depth, nodes));
        }
        if FUNCTIONS.contains(&name.as_str()) || OPERATORS.contains(&name.as_str()) {
            if before == Class::Ordinary {
                nodes.push(Node::Space(THIN));
            }
            nodes.extend(name.chars().map(|c| Node::Char(c, Style::Upright)));
            if !matches!(self.rest.peek(), Some((_, '(' | '_' | '^' | '}' | '$'))) {
                nodes.push(Node::Space(THIN));
            }
            return Ok(Class::Open);
        }
        let style = match name.as_str() {
            "quad" => {
                nodes.push(Node::Space(1.0));
                return Ok(Class::Open);
            }
            "mathbf" => Style::Bold,
            "mathrm" => Style::Upright,
            _ => return self.fault(at, LabelProblem::Command(name)),
        };
        if self.rest.next_if(|&(_, c)| c == '{').is_none() {
            return self.fault(at, LabelProblem::Brace);
        }
        loop {
            match self.rest.next() {
                Some((_, '}')) => return Ok(Class::Ordinary),
                Some((_, ' ')) => nodes.push(Node::Space(0.25)),
                Some((_, c)) if c != '$' => nodes.push(Node::Char(c, style)),
                _ => return self.fault(at, LabelProblem::Brace),
            }
        }
    }

    /// The scripts that follow a base, in either order.
    fn scripts(&mut self, at: usize, first: char, depth: usize) -> Result<Node, FigureError> {
        if depth == MAX_DEPTH {
            return self.fault(at, LabelProblem::TooDeep);
        }
        let mut found: [Option<Vec<Node>>; 2] = [None, None];
        let (mut at, mut kind) = (at, first);
        loop {
            let script = self.script(at, depth + 1)?;
            let [sub, sup] = &mut found;
            let slot = if kind == '_' { sub } else { sup };
            if slot.replace(script).is_some() {
                return self.fault(at, LabelProblem::DoubleScript);
            }
            match self.rest.next_if(|&(_, c)| c == '_' || c == '^') {
                Some(next) => (at, kind) = next,
                None => break,
            }
        }
        let [sub, sup] = found.map(Option::unwrap_or_default);
        Ok(Node::Scripts { sub, sup })
    }

    fn script(&mut self, at: usize, depth: usize) -> Result<Vec<Node>, FigureError> {
        let mut nodes = Vec::new();
        match self.rest.next() {
            Some((start, ch)) if !matches!(ch, ' ' | '}' | '$' | '_' | '^') => {
                self.atom(start, ch, Class::Open, depth, &mut nodes)?;
            }
            _ => {}
        }
        if nodes.is_empty() {
            return self.fault(at, LabelProblem::EmptyScript);
        }
        Ok(nodes)
    }
}

/// Append a sign of a formula with the room it takes. Scripts are set tight, as in TeX.
fn sign(ch: char, before: Class, depth: usize, nodes: &mut Vec<Node>) -> Class {
    let (class, shown) = match ch {
        '=' | '<' | '>' | '≤' | '≥' | '≠' | '≈' | '∈' | '→' => (Class::Relation, ch),
        '-' => (Class::Operation, '−'),
        '+' | '×' | '·' | '±' => (Class::Operation, ch),
        '(' | '[' | '{' | ',' | ';' | '∑' | '∫' | '/' => (Class::Open, ch),
        '\'' => (Class::Ordinary, '′'),
        _ => (Class::Ordinary, ch),
    };
    let italic = shown.is_alphabetic() && !('Α'..='Ω').contains(&shown);
    let style = if italic {
        Style::Italic
    } else {
        Style::Upright
    };
    let room = match class {
        _ if depth > 0 => 0.0,
        Class::Relation => THICK,
        Class::Operation if before == Class::Ordinary => MEDIUM,
        _ => 0.0,
    };
    let after = if matches!(ch, ',' | ';') && depth == 0 {
        THIN
    } else {
        room
    };
    nodes.extend((room > 0.0).then_some(Node::Space(room)));
    nodes.push(Node::Char(shown, style));
    nodes.extend((after > 0.0).then_some(Node::Space(after)));
    class
}

#[cfg(test)]
mod tests {
    use super::*;

    fn problem(label: &str) -> (usize, LabelProblem) {
        match parse(label) {
            Err(FigureError::Label { at, problem, .. }) => (at, problem),
            other => panic!("{label}: {other:?}"),
        }
    }

    #[test]
    fn letters_are_italic_and_figures_upright_in_mathematics_only() {
        assert_eq!(
            parse("t1").unwrap(),
            [
                Node::Char('t', Style::Upright),
                Node::Char('1', Style::Upright)
            ]
        );
        assert_eq!(
            parse("$t1$").unwrap(),
            [
                Node::Char('t', Style::Italic),
                Node::Char('1', Style::Upright)
            ]
        );
        assert_eq!(
            parse("$\\mathbf{r}$").unwrap(),
            [Node::Char('r', Style::Bold)]
        );
    }

    #[test]
    fn scripts_of_either_order_are_one_node() {
        assert_eq!(parse("$x_i^2$").unwrap(), parse("$x^2_i$").unwrap());
        assert_eq!(parse("$x_{i}$").unwrap(), parse("$x_i$").unwrap());
    }

    #[test]
    fn a_minus_is_spaced_between_operands_and_tight_as_a_sign() {
        let count = |s: &str| {
            parse(s)
                .unwrap()
                .iter()
                .filter(|n| matches!(n, Node::Space(_)))
                .count()
        };
        assert_eq!(
            (
                count("$a-b$"),
                count("$-b$"),
                count("$(-b$"),
                count("$a=-b$")
            ),
            (2, 0, 0, 2)
        );
    }

    #[test]
    fn every_fault_is_named_where_it_stands() {
        assert_eq!(problem("a $b"), (2, LabelProblem::OpenMath));
        assert_eq!(problem("$b}$"), (2, LabelProblem::Brace));
        assert_eq!(problem("$x_{a$"), (3, LabelProblem::Brace));
        assert_eq!(problem("$x_$"), (2, LabelProblem::EmptyScript));
        assert_eq!(problem("$x_a_b$"), (4, LabelProblem::DoubleScript));
        assert_eq!(problem("$x_{a_{b_c}}$"), (8, LabelProblem::TooDeep));
        assert_eq!(
            problem("$\\oops$"),
            (1, LabelProblem::Command("oops".into()))
        );
        assert_eq!(problem("$\\"), (1, LabelProblem::Command(String::new())));
    }
}
