//! Tokens of formulas, parsed with `winnow`.

use super::SyntaxError;
use super::ast::Place;
use super::character::{character, unknown_sign};
use winnow::ascii::{digit1, multispace0};
use winnow::combinator::{alt, opt, preceded, repeat};
use winnow::prelude::*;
use winnow::stream::LocatingSlice;
use winnow::token::{one_of, take_while};

/// A token of the language.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Token {
    /// Digits, perhaps with a decimal point: `45.708`.
    Number(String),
    /// A name with its primes: `mu`, `H''`.
    Name(String),
    /// An operator, comparison or bracket.
    Sign(&'static str),
}

/// A token with its place.
pub type Placed = (Token, Place);

type Input<'a> = LocatingSlice<&'a str>;

fn number(input: &mut Input<'_>) -> ModalResult<Token> {
    (digit1, opt(('.', digit1)))
        .take()
        .map(|text: &str| Token::Number(text.to_owned()))
        .parse_next(input)
}

fn begins_a_name(c: char) -> bool {
    c.is_alphabetic() || c == '_'
}

/// Whether a text may name a symbol, a basis family or a definition: letters of any script, digits 0 to 9 and `_`,
/// not beginning with a digit, optionally followed by primes; not a word of the language, nor `pi`.
///
/// No other characters occur in names that a user can write. A stage that needs a name of its own includes one of
/// them, so it cannot collide with a user's name.
#[must_use]
pub fn is_name(text: &str) -> bool {
    let stem = text.trim_end_matches('\'');
    let reserved = super::WORDS.contains(&text) || text == "pi";
    stem.starts_with(begins_a_name)
        && stem.chars().all(|c| begins_a_name(c) || c.is_ascii_digit())
        && !reserved
}

fn name(input: &mut Input<'_>) -> ModalResult<Token> {
    (
        one_of(begins_a_name),
        take_while(0.., |c: char| begins_a_name(c) || c.is_ascii_digit()),
        take_while(0.., '\''),
    )
        .take()
        .map(|text: &str| Token::Name(text.to_owned()))
        .parse_next(input)
}

fn sign(input: &mut Input<'_>) -> ModalResult<Token> {
    alt(SIGNS.map(|sign| sign.value(Token::Sign(sign)))).parse_next(input)
}

/// The signs; longer signs precede their prefixes.
const SIGNS: [&str; 16] = [
    "==", "!=", "<=", ">=", "<", ">", "+", "-", "*", "/", "^", "(", ")", "[", "]", ",",
];

/// The largest number of digits of a number. Printed numbers have a dozen, and an operation on n digits costs up to
/// n^2.
const MAX_DIGITS: usize = 1_000;

/// The tokens of `text`.
///
/// # Errors
/// [`SyntaxError::UnknownCharacter`] at the first character that starts no token, and
/// [`SyntaxError::TooManyDigits`].
pub fn tokens(text: &str) -> Result<Vec<Placed>, SyntaxError> {
    let mut input = LocatingSlice::new(text);
    let one = alt((number, name, sign)).with_span().map(|(token, range)| {
        (
            token,
            Place {
                start: range.start,
                end: range.end,
            },
        )
    });
    let parsed: ModalResult<Vec<Placed>> =
        repeat(0.., preceded(multispace0, one)).parse_next(&mut input);
    let rest = parsed.ok().and_then(|tokens| {
        let _: ModalResult<&str> = multispace0.parse_next(&mut input);
        input.is_empty().then_some(tokens)
    });
    let long = |(token, place): &Placed| match token {
        Token::Number(digits) if digits.len() > MAX_DIGITS => Some(SyntaxError::TooManyDigits {
            limit: MAX_DIGITS,
            found: digits.len(),
            place: *place,
        }),
        _ => None,
    };
    if let Some(error) = rest.iter().flatten().find_map(long) {
        return Err(error);
    }
    rest.ok_or_else(|| {
        let start = text.len() - input.trim_start().len();
        let found = input.trim_start().chars().next().unwrap_or(' ');
        SyntaxError::UnknownCharacter {
            found,
            help: unknown_sign(input.trim_start()).or_else(|| character(found)),
            place: Place {
                start,
                end: start + found.len_utf8(),
            },
        }
    })
}
