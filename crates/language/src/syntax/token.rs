//! From text to tokens, with winnow.

use super::SyntaxError;
use super::ast::Place;
use winnow::ascii::{digit1, multispace0};
use winnow::combinator::{alt, opt, preceded, repeat};
use winnow::prelude::*;
use winnow::stream::LocatingSlice;
use winnow::token::{one_of, take_while};

/// A word of the language.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Token {
    /// Digits, perhaps with a decimal point: `45.708`.
    Number(String),
    /// A name with its primes: `mu`, `H''`.
    Name(String),
    /// An operator, comparison or bracket.
    Sign(&'static str),
}

/// A token and where it stands.
pub type Placed = (Token, Place);

type Input<'a> = LocatingSlice<&'a str>;

fn number(input: &mut Input<'_>) -> ModalResult<Token> {
    (digit1, opt(('.', digit1)))
        .take()
        .map(|text: &str| Token::Number(text.to_owned()))
        .parse_next(input)
}

fn name(input: &mut Input<'_>) -> ModalResult<Token> {
    (
        one_of(|c: char| c.is_alphabetic() || c == '_'),
        take_while(0.., |c: char| c.is_alphanumeric() || c == '_'),
        take_while(0.., '\''),
    )
        .take()
        .map(|text: &str| Token::Name(text.to_owned()))
        .parse_next(input)
}

fn sign(input: &mut Input<'_>) -> ModalResult<Token> {
    alt(SIGNS.map(|sign| sign.value(Token::Sign(sign)))).parse_next(input)
}

/// Longer signs first.
const SIGNS: [&str; 16] = [
    "==", "!=", "<=", ">=", "<", ">", "+", "-", "*", "/", "^", "(", ")", "[", "]", ",",
];

/// The tokens of `text`.
///
/// # Errors
/// [`SyntaxError::UnknownCharacter`] at the first character that starts no token.
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
    rest.ok_or_else(|| {
        let start = text.len() - input.trim_start().len();
        let found = input.trim_start().chars().next().unwrap_or(' ');
        SyntaxError::UnknownCharacter {
            found,
            place: Place {
                start,
                end: start + found.len_utf8(),
            },
        }
    })
}
