//! Rocq text with the precedence of its outermost operator, so that only needed parentheses are written.

use torse_numbers::Rational;

/// Precedence of the outermost operator of a text; the numbers are Rocq's own levels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// A name, a numeral, or a text in parentheses or brackets.
    Atom = 0,
    /// A function applied to arguments.
    Application = 10,
    /// `a ^ n`
    Power = 30,
    /// `- a`
    Negative = 35,
    /// `a * b`, `a / b`
    Product = 40,
    /// `a + b`, `a - b`
    Sum = 50,
    /// `a = b`, `a < b`
    Relation = 70,
    /// `A /\ B`
    Both = 80,
    /// `A \/ B`
    Either = 85,
    /// `A -> B`, `forall x, A`, `let x := a in b`, `fun x => a`
    Open = 200,
}

/// A piece of Rocq text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Code {
    text: String,
    level: Level,
}

impl Code {
    /// Makes a text whose outermost operator has this level.
    pub fn new(text: impl Into<String>, level: Level) -> Self {
        let text = text.into();
        Self { text, level }
    }

    /// Makes a name or a bracketed text.
    pub fn atom(text: impl Into<String>) -> Self {
        Self::new(text, Level::Atom)
    }

    /// Returns the text for a place that accepts operators up to this level, in parentheses if needed.
    #[must_use]
    pub fn within(&self, level: Level) -> String {
        if self.level <= level {
            self.text.clone()
        } else {
            format!("({})", self.text)
        }
    }

    /// Returns the text for a place that accepts only operators that bind more strongly than this level.
    #[must_use]
    pub fn below(&self, level: Level) -> String {
        if self.level < level {
            self.text.clone()
        } else {
            format!("({})", self.text)
        }
    }

    /// Returns the text as an argument.
    #[must_use]
    pub fn argument(&self) -> String {
        self.within(Level::Atom)
    }

    /// Returns the plain text.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// `head a b c`
    #[must_use]
    pub fn apply(head: &str, arguments: &[Code]) -> Self {
        if arguments.is_empty() {
            return Self::atom(head);
        }
        let arguments: Vec<String> = arguments.iter().map(Code::argument).collect();
        Self::new(
            format!("{head} {}", arguments.join(" ")),
            Level::Application,
        )
    }

    /// Writes an operator that associates to the left.
    #[must_use]
    pub fn infix(left: &Code, sign: &str, right: &Code, level: Level) -> Self {
        let text = format!("{} {sign} {}", left.within(level), right.below(level));
        Self::new(text, level)
    }

    /// Writes an operator that associates to the right.
    #[must_use]
    pub fn infix_right(left: &Code, sign: &str, right: &Code, level: Level) -> Self {
        let text = format!("{} {sign} {}", left.below(level), right.within(level));
        Self::new(text, level)
    }

    /// `[a; b; c]`
    #[must_use]
    pub fn list(items: &[Code]) -> Self {
        let items: Vec<&str> = items.iter().map(Code::text).collect();
        Self::atom(format!("[{}]", items.join("; ")))
    }

    /// Writes a rational number.
    #[must_use]
    pub fn rational(value: &Rational) -> Self {
        let numerator = value.numer().to_string();
        let numerator = match numerator.starts_with('-') {
            true => Self::atom(format!("({numerator})")),
            false => Self::atom(numerator),
        };
        if value.is_integer() {
            return numerator;
        }
        let denominator = Self::atom(value.denom().to_string());
        Self::infix(&numerator, "/", &denominator, Level::Product)
    }
}

/// Puts a text into the scope of integers.
#[must_use]
pub fn integer_scope(code: &Code) -> String {
    match code.level {
        Level::Atom if code.text.starts_with(|c: char| c.is_alphabetic()) => code.text.clone(),
        Level::Atom if code.text.ends_with("%Z") => code.text.clone(),
        Level::Atom if code.text.chars().all(|c| c.is_ascii_digit()) => format!("{}%Z", code.text),
        _ => format!("({})%Z", code.text),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parentheses_stand_where_they_change_the_meaning() {
        let [a, b, c] = ["a", "b", "c"].map(Code::atom);
        let difference = Code::infix(&b, "-", &c, Level::Sum);
        let left = Code::infix(&difference, "-", &a, Level::Sum);
        assert_eq!(left.text(), "b - c - a");
        let right = Code::infix(&a, "-", &difference, Level::Sum);
        assert_eq!(right.text(), "a - (b - c)");
        let both = Code::infix_right(&a, "/\\", &b, Level::Both);
        assert_eq!(
            Code::infix_right(&both, "/\\", &c, Level::Both).text(),
            "(a /\\ b) /\\ c"
        );
        assert_eq!(Code::apply("f", &[difference, c]).text(), "f (b - c) c");
    }

    #[test]
    fn negative_numerators_are_in_parentheses() {
        let half = torse_numbers::rational::ratio(-1, 2).unwrap_or_default();
        assert_eq!(Code::rational(&half).text(), "(-1) / 2");
    }
}
