//! A changed formula of a program, written in the language of the program.

use crate::program::{CodeLanguage, Part, Program, operation};
use num_traits::Signed;
use torse_numbers::Rational;
use torse_numbers::rational::integer;
use torse_syntax::formula::{Expr, Node, Operator, Place};

/// A place of a file and what would stand there.
pub(super) struct Rewritten {
    pub(super) place: Place,
    pub(super) text: String,
}

/// The smallest part of a formula that changed, with its new text; none if it stands nowhere in the file.
pub(super) fn rewritten(program: &Program, part: Part<'_>, new: &Expr) -> Option<Rewritten> {
    let writer = Writer {
        text: &program.source.text,
        language: program.language,
        original: part.expr,
        old: part.expr.place,
        is_integer: false,
    };
    let (old, new, is_whole) = smallest(part.expr, new, true);
    let digits = writer.slice(old.place).bytes();
    let writer = Writer {
        old: old.place,
        is_integer: is_index(part.expr, old) || digits.clone().all(|b| b.is_ascii_digit()),
        ..writer
    };
    if old.place.end <= old.place.start {
        return None;
    }
    let text = writer.write(new, 0, is_float_text(writer.slice(old.place)));
    let prefix = part
        .changed
        .filter(|_| is_whole)
        .map(|target| writer.slice(target));
    let text = match prefix {
        Some(target) => format!("{target} = {text}"),
        None => text,
    };
    Some(Rewritten {
        place: old.place,
        text,
    })
}

/// The smallest pair of parts that differ, and whether it is the whole.
fn smallest<'e>(old: &'e Expr, new: &'e Expr, is_whole: bool) -> (&'e Expr, &'e Expr, bool) {
    let (olds, news) = (old.parts(), new.parts());
    if olds.len() != news.len() || !same_kind(old, new) {
        return (old, new, is_whole);
    }
    // The name of a call or a family says little alone, and what stands nowhere nothing.
    let is_shown = |part: &Expr| match &old.node {
        Node::Call(head, _) | Node::Index(head, _) if **head == *part => false,
        _ => part.place.end > part.place.start,
    };
    let mut differing = olds.iter().zip(&news).filter(|(old, new)| old != new);
    match (differing.next(), differing.next()) {
        (Some((part, new)), None) if is_shown(part) => smallest(part, new, false),
        _ => (old, new, is_whole),
    }
}

/// Whether a part is an index of a list or within one, or an exponent.
fn is_index(whole: &Expr, part: &Expr) -> bool {
    let contains = |expr: &Expr| {
        let place = expr.place;
        place.start <= part.place.start && part.place.end <= place.end
    };
    match &whole.node {
        Node::Index(_, indices) if indices.iter().any(contains) => true,
        Node::Binary(Operator::Power, _, exponent) if contains(exponent) => true,
        _ => whole.parts().into_iter().any(|inner| is_index(inner, part)),
    }
}

/// Whether two formulas differ in their parts alone.
fn same_kind(old: &Expr, new: &Expr) -> bool {
    match (&old.node, &new.node) {
        (Node::Call(..), Node::Call(..))
        | (Node::Index(..), Node::Index(..))
        | (Node::Negative(_), Node::Negative(_))
        | (Node::List(_), Node::List(_))
        | (Node::Not(_), Node::Not(_)) => true,
        (Node::Binary(one, ..), Node::Binary(other, ..)) => one == other,
        (Node::Join(one, ..), Node::Join(other, ..)) => one == other,
        (Node::Compare(_, one), Node::Compare(_, other)) => {
            one.iter().map(|(r, _)| r).eq(other.iter().map(|(r, _)| r))
        }
        _ => false,
    }
}

struct Writer<'t> {
    text: &'t str,
    language: CodeLanguage,
    /// The formula as it stands in the file.
    original: &'t Expr,
    /// The part that is replaced.
    old: Place,
    /// Whether that is an integer, whose type has no point.
    is_integer: bool,
}

/// The most digits after a point.
const MAX_PLACES: i32 = 9;

/// How tightly operators bind: sums, products and quotients, signs, powers, and what needs no brackets.
const SUM: u8 = 1;
const PRODUCT: u8 = 2;
const SIGN: u8 = 3;
const POWER: u8 = 4;
const ATOM: u8 = 5;

impl Writer<'_> {
    fn slice(&self, place: Place) -> &str {
        self.text.get(place.start..place.end).unwrap_or("")
    }

    /// Whether a formula stands in the file as it is.
    fn is_written(&self, expr: &Expr) -> bool {
        fn contains(whole: &Expr, part: &Expr) -> bool {
            whole == part || whole.parts().into_iter().any(|inner| contains(inner, part))
        }
        expr.place.end > expr.place.start && contains(self.original, expr)
    }

    /// The text of a formula within something that binds as tightly as `outer`; `is_float` numbers have a point.
    fn write(&self, expr: &Expr, outer: u8, is_float: bool) -> String {
        let (text, tightness) = self.bare(expr, is_float);
        if tightness < outer {
            return format!("({text})");
        }
        text
    }

    fn bare(&self, expr: &Expr, is_float: bool) -> (String, u8) {
        if self.is_written(expr) {
            return (self.slice(expr.place).to_owned(), self.tightness(expr));
        }
        let is_rust = self.language == CodeLanguage::Rust;
        let float = is_float || (is_rust && !self.is_integer);
        match &expr.node {
            Node::Number { value, .. } => (self.number(value, is_float), ATOM),
            Node::Name(name) if name == operation::PI => ("pi".to_owned(), ATOM),
            Node::Name(name) => (name.clone(), ATOM),
            Node::Negative(inner) => (format!("-{}", self.write(inner, SIGN, is_float)), SIGN),
            Node::Binary(Operator::Power, base, exponent) if is_rust => {
                let base = self.write(base, ATOM, true);
                (
                    format!("{base}.powi({})", self.write(exponent, 0, false)),
                    ATOM,
                )
            }
            Node::Binary(operator, left, right) => {
                let (sign, own) = match operator {
                    Operator::Add => (" + ", SUM),
                    Operator::Subtract => (" - ", SUM),
                    Operator::Multiply => ("*", PRODUCT),
                    Operator::Divide => ("/", PRODUCT),
                    Operator::Power => ("**", POWER),
                };
                let sign = if is_rust && own == PRODUCT {
                    format!(" {} ", sign)
                } else {
                    sign.to_owned()
                };
                let (left_at, right_at) = match operator {
                    Operator::Add | Operator::Multiply => (own, own),
                    Operator::Power => (ATOM, SIGN),
                    _ => (own, own + 1),
                };
                let text = format!(
                    "{}{sign}{}",
                    self.write(left, left_at, float),
                    self.write(right, right_at, float && *operator != Operator::Power)
                );
                (text, own)
            }
            Node::Index(head, indices) => {
                let indices = indices.iter().map(|index| self.write(index, 0, false));
                let indices = indices.collect::<Vec<_>>().join("][");
                (
                    format!("{}[{indices}]", self.write(head, ATOM, false)),
                    ATOM,
                )
            }
            Node::Call(head, arguments) => self.call(expr, head, arguments, is_float),
            _ => (torse_syntax::notation::text(expr), 0),
        }
    }

    fn call(&self, whole: &Expr, head: &Expr, arguments: &[Expr], is_float: bool) -> (String, u8) {
        let name = match &head.node {
            Node::Name(name) => name.trim_start_matches('#'),
            _ => "",
        };
        let is_rust = self.language == CodeLanguage::Rust;
        let written: Vec<String> = arguments
            .iter()
            .map(|argument| self.write(argument, 0, is_float))
            .collect();
        match (head_operation(head), arguments) {
            (Some(operation::FLOAT), [number]) if matches!(number.node, Node::Number { .. }) => {
                (self.write(number, ATOM, true), ATOM)
            }
            (Some(operation::FLOAT), [value]) => {
                (format!("{} as f64", self.write(value, ATOM, false)), SIGN)
            }
            (Some(operation::RANGE), [low, high, _]) if is_rust => {
                let (low, high) = (self.write(low, SUM, false), self.write(high, SUM, false));
                (format!("{low}..{high}"), 0)
            }
            (Some(operation::RANGE), [low, high, _]) => {
                let (low, high) = (self.write(low, 0, false), self.write(high, 0, false));
                (format!("range({low}, {high})"), ATOM)
            }
            (None, [argument])
                if is_rust && torse_syntax::formula::functions::is_function(name) =>
            {
                let method = if name == "log" { "ln" } else { name };
                (
                    format!("{}.{method}()", self.write(argument, ATOM, true)),
                    ATOM,
                )
            }
            (None, [one, other]) if is_rust && matches!(name, "min" | "max") => {
                let one = self.write(one, ATOM, true);
                let other = self.write(other, 0, is_float);
                (format!("{one}.{name}({other})"), ATOM)
            }
            _ => {
                // What stands nowhere is called as what it replaces.
                let place = match whole.place.end > whole.place.start {
                    true => whole.place,
                    false => self.old,
                };
                let module = self.module(place);
                (format!("{module}{name}({})", written.join(", ")), ATOM)
            }
        }
    }

    /// The module by which the function is called that stands at a place, with its point: `np.`.
    fn module(&self, place: Place) -> &str {
        let (called, _) = self.slice(place).split_once('(').unwrap_or_default();
        let end = called.rfind('.').map_or(0, |point| point + 1);
        let module = called.get(..end).unwrap_or("");
        let is_path = module
            .chars()
            .all(|c| c.is_alphanumeric() || c == '_' || c == '.');
        if is_path { module } else { "" }
    }

    /// How tightly what is written binds.
    fn tightness(&self, expr: &Expr) -> u8 {
        let text = self.slice(expr.place);
        match &expr.node {
            Node::Binary(Operator::Power, ..) if text.ends_with(')') && !text.contains("**") => {
                ATOM
            }
            Node::Binary(operator, ..) => match operator {
                Operator::Add | Operator::Subtract => SUM,
                Operator::Multiply | Operator::Divide => PRODUCT,
                Operator::Power => POWER,
            },
            Node::Negative(_) => SIGN,
            Node::Compare(..) | Node::Join(..) | Node::Not(_) => 0,
            Node::Call(..) if text.contains(" as ") || text.contains(" if ") => 0,
            _ => ATOM,
        }
    }

    fn number(&self, value: &Rational, is_float: bool) -> String {
        if value.is_integer() {
            return format!("{value}{}", if is_float { ".0" } else { "" });
        }
        decimals(value).unwrap_or_else(|| format!("({}.0/{}.0)", value.numer(), value.denom()))
    }
}

/// A number as a decimal, if it has few digits.
fn decimals(value: &Rational) -> Option<String> {
    let places = (1..=MAX_PLACES).find(|places| (value * integer(10).pow(*places)).is_integer())?;
    let figure = (value * integer(10).pow(places)).to_integer();
    let is_negative = value.is_negative();
    let digits = figure.to_string();
    let width = usize::try_from(places).ok()? + 1;
    let digits = format!("{:0>width$}", digits.trim_start_matches('-'));
    let (whole, fraction) = digits.split_at_checked(digits.len() - (width - 1))?;
    Some(format!(
        "{}{whole}.{fraction}",
        if is_negative { "-" } else { "" }
    ))
}

/// The operation that a call is.
fn head_operation(head: &Expr) -> Option<&str> {
    match &head.node {
        Node::Name(name) if name.starts_with('#') => Some(name),
        _ => None,
    }
}

/// Whether a text is a number with a point.
fn is_float_text(text: &str) -> bool {
    text.contains('.')
        && text
            .trim_start_matches('-')
            .starts_with(|c: char| c.is_ascii_digit())
}
