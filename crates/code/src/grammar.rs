//! The trees of tree-sitter: parsed, searched for mistakes, and bounded.

use crate::program::{CodeLanguage, refused};
use std::sync::Arc;
use torse_numbers::rational::integer;
use torse_numbers::{Integer, Rational};
use torse_syntax::derivation::{DerivationError, Source};
use torse_syntax::formula::{Expr, Node, Operator, Place};
use tree_sitter::{Parser, Tree};

/// The largest file that is read, in bytes.
pub const MAX_CODE_BYTES: usize = 1 << 20;
/// The deepest nesting of brackets, blocks and operators.
pub const MAX_CODE_NESTING: usize = 200;
/// The most digits of a number, and its largest exponent.
const MAX_DIGITS: usize = 400;

/// The result of reading a part of a file.
pub(crate) type Read<T> = Result<T, Box<DerivationError>>;

/// A node of the tree of a file.
pub(crate) type CodeNode<'t> = tree_sitter::Node<'t>;

/// Parses a file; a mistake of its grammar is an error only where it is asked for, see [`Text::check`].
pub(crate) fn tree(source: &Arc<Source>, language: CodeLanguage) -> Read<Tree> {
    let whole = Place { start: 0, end: 0 };
    if source.text.len() > MAX_CODE_BYTES {
        let message = format!("this file has more than {MAX_CODE_BYTES} bytes");
        let help = "put the function into a file of its own";
        return Err(refused(source, whole, message, help));
    }
    let grammar = match language {
        CodeLanguage::Python => tree_sitter_python::LANGUAGE.into(),
        CodeLanguage::Rust => tree_sitter_rust::LANGUAGE.into(),
    };
    let mut parser = Parser::new();
    let is_set = parser.set_language(&grammar).is_ok();
    let parsed = is_set.then(|| parser.parse(&source.text, None)).flatten();
    parsed.ok_or_else(|| {
        let help = "its grammar and the parser are of different versions";
        refused(source, whole, "this file cannot be parsed", help)
    })
}

/// The text of a file, with what can be said of its nodes.
#[derive(Clone, Copy)]
pub(crate) struct Text<'s> {
    pub(crate) source: &'s Arc<Source>,
}

impl<'s> Text<'s> {
    /// What stands at a node.
    pub(crate) fn text(self, node: CodeNode<'_>) -> &'s str {
        self.source.text.get(node.byte_range()).unwrap_or("")
    }

    /// The name that an identifier is.
    pub(crate) fn name(self, node: CodeNode<'_>) -> Read<&'s str> {
        let name = self.text(node);
        if is_plain(name) {
            return Ok(name);
        }
        let message = format!("the name `{name}` may be written in several ways");
        let help = "names of ASCII letters, digits and `_` are read, and plain Greek letters";
        Err(self.refused(node, message, help))
    }

    /// Refuses what stands at a node.
    pub(crate) fn refused(
        self,
        node: CodeNode<'_>,
        message: impl Into<String>,
        help: impl Into<String>,
    ) -> Box<DerivationError> {
        refused(self.source, place(node), message, help)
    }

    /// Fails if the text of a node is no text of the language, or is nested too deeply.
    pub(crate) fn check(self, node: CodeNode<'_>) -> Read<()> {
        let mut cursor = node.walk();
        let mut depth = 0_usize;
        loop {
            let here = cursor.node();
            if here.is_error() || here.is_missing() {
                let help = "torse reads files that their own interpreter or compiler accepts";
                let message = match here.is_missing() {
                    true => format!("`{}` is missing here", here.kind()),
                    false => "this is not understood: the syntax is wrong".to_owned(),
                };
                return Err(self.refused(here, message, help));
            }
            if depth > MAX_CODE_NESTING {
                let message = format!("this is nested more than {MAX_CODE_NESTING} levels deep");
                return Err(self.refused(here, message, "give names to parts of it"));
            }
            if cursor.goto_first_child() {
                depth += 1;
                continue;
            }
            while !cursor.goto_next_sibling() {
                if depth == 0 || !cursor.goto_parent() {
                    return Ok(());
                }
                depth -= 1;
            }
            if depth == 0 {
                return Ok(());
            }
        }
    }

    /// The child with a name of the grammar.
    pub(crate) fn field<'t>(self, node: CodeNode<'t>, name: &str) -> Read<CodeNode<'t>> {
        node.child_by_field_name(name)
            .ok_or_else(|| self.refused(node, format!("this has no {name}"), "complete it"))
    }

    /// The number that a literal without suffix and underscores is, exactly: `1e-3` is 1/1000.
    pub(crate) fn number(self, node: CodeNode<'_>, digits: &str) -> Read<Expr> {
        let help = "numbers are written in decimals: 3, 0.25 or 1e-3";
        let wrong = || self.refused(node, "this number is not read", help);
        let value = decimal(digits).ok_or_else(wrong)?;
        Ok(at(
            node,
            Node::Number {
                value,
                decimals: None,
            },
        ))
    }
}

/// The value of decimals with an optional exponent.
fn decimal(digits: &str) -> Option<Rational> {
    let (mantissa, exponent) = match digits.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i64>().ok()?),
        None => (digits, 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let all = format!("{whole}{fraction}");
    let is_plain = !all.is_empty() && all.bytes().all(|b| b.is_ascii_digit());
    let shift = exponent - i64::try_from(fraction.len()).ok()?;
    if !is_plain || all.len() > MAX_DIGITS || shift.unsigned_abs() > MAX_DIGITS as u64 {
        return None;
    }
    let figure = all.bytes().try_fold(integer(0), |value, digit| {
        Some(value * integer(10) + integer(i64::from(digit - b'0')))
    })?;
    let power = integer(10).pow(i32::try_from(shift.unsigned_abs()).ok()?);
    Some(if shift < 0 {
        figure / power
    } else {
        figure * power
    })
}

/// Whether an identifier is one name however it is looked at: languages take some letters for others, and `r#x` is `x`.
pub(crate) fn is_plain(name: &str) -> bool {
    let is_greek = |c: char| {
        let is_small = ('α'..='ω').contains(&c);
        is_small || ('Α'..='Ω').contains(&c)
    };
    name.chars()
        .all(|c| c.is_ascii_alphanumeric() || c == '_' || is_greek(c))
}

/// A number as a machine integer, if it is one.
pub(crate) fn small(value: &Rational) -> Option<i64> {
    let whole: &Integer = value.is_integer().then(|| value.numer())?;
    i64::try_from(whole.clone()).ok()
}

/// The place of a node.
pub(crate) fn place(node: CodeNode<'_>) -> Place {
    Place {
        start: node.start_byte(),
        end: node.end_byte(),
    }
}

/// A formula at the place of a node.
pub(crate) fn at(node: CodeNode<'_>, formula: Node) -> Expr {
    Expr {
        node: formula,
        place: place(node),
    }
}

/// A binary operation at the place of a node.
pub(crate) fn binary(node: CodeNode<'_>, operator: Operator, left: Expr, right: Expr) -> Expr {
    at(
        node,
        Node::Binary(operator, Arc::new(left), Arc::new(right)),
    )
}

/// A node and all nodes within it that are no comments, in the order of the text.
pub(crate) fn within<'t>(node: CodeNode<'t>) -> impl Iterator<Item = CodeNode<'t>> {
    let mut pending = vec![node];
    std::iter::from_fn(move || {
        let next = pending.pop()?;
        pending.extend(children(next).into_iter().rev());
        Some(next)
    })
}

/// The children of a node that are no comments.
pub(crate) fn children(node: CodeNode<'_>) -> Vec<CodeNode<'_>> {
    let mut cursor = node.walk();
    let all = node.named_children(&mut cursor);
    let is_comment = |child: &CodeNode<'_>| child.kind().ends_with("comment");
    all.filter(|child| !is_comment(child) && !child.kind().ends_with("_marker"))
        .collect()
}
