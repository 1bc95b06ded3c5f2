//! From tokens to a list of items: brackets are matched, scripts go to what carries them, arguments of commands are taken.
//!
//! What is left out here has no meaning: blanks, sizes, styles, labels and the signs of alignment. Everything else becomes an
//! item, or is an error with its place.

mod brackets;
mod control_sequence;
mod letters;
mod rows;

pub use letters::{is_letter, one_form_of_each_letter};

use super::error::LatexError;
use super::item::{Nucleus, TexFace, TexItem};
use super::token::{MAX_TEX_TOKENS, PlacedTex, TexToken, tex_tokens};
use crate::formula::Place;
use brackets::pairs_of_bars;
use control_sequence::faced;
use letters::character;
use rows::{END_OF_ROW, without_ends_of_rows};

/// The largest depth of brackets, scripts and arguments.
const MAX_LAYOUT_DEPTH: usize = 60;

/// Lays out a formula, without dollar signs.
///
/// # Errors
/// [`LatexError`] at the first thing that is no mathematics of the subset, or at a bracket without a partner.
pub fn layout(text: &str) -> Result<Vec<TexItem>, LatexError> {
    let (tokens, all) = tex_tokens(text);
    let end = Place {
        start: text.len(),
        end: text.len(),
    };
    if !all {
        return Err(LatexError::new(
            end,
            format!("the text has more than {MAX_TEX_TOKENS} tokens"),
        ));
    }
    layout_tokens(&tokens, end)
}

/// Lays out the tokens of a formula; `end` is the place behind it.
///
/// # Errors
/// As [`layout`].
pub fn layout_tokens(tokens: &[PlacedTex], end: Place) -> Result<Vec<TexItem>, LatexError> {
    one_form_of_each_letter(tokens)?;
    let mut layout = Layout {
        tokens,
        next: 0,
        end,
        depth: 0,
    };
    let list = layout.list(Stop::End)?;
    match layout.peek() {
        None => Ok(list),
        Some(token) => Err(LatexError::new(
            token.place,
            format!("`{}` has no partner", shown(token)),
        )),
    }
}

fn shown(token: &PlacedTex) -> String {
    match &token.token {
        TexToken::Command(name) => format!("\\{name}"),
        TexToken::Character(sign) => sign.to_string(),
    }
}

/// What ends a list.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Stop {
    /// The end of the text.
    End,
    /// A closing brace.
    Brace,
    /// A closing round or square bracket, or that of `\left`.
    Bracket,
    Right,
    /// A bar that closes.
    Bar,
    DoubleBar,
    /// The end of a cell of an environment.
    Cell,
    /// A closing square bracket of an optional argument.
    Option,
}

struct Layout<'t> {
    tokens: &'t [PlacedTex],
    next: usize,
    end: Place,
    depth: usize,
}

type Listed = Result<Vec<TexItem>, LatexError>;

impl Layout<'_> {
    fn peek(&self) -> Option<&PlacedTex> {
        self.tokens.get(self.next)
    }

    fn place(&self) -> Place {
        self.peek().map_or(self.end, |token| token.place)
    }

    fn blanks(&mut self) {
        while self.peek().is_some_and(|token| token.is(' ')) {
            self.next += 1;
        }
    }

    fn take(&mut self, sign: char) -> bool {
        let found = self.peek().is_some_and(|token| token.is(sign));
        self.next += usize::from(found);
        found
    }

    /// Whether the list ends at this token.
    fn ends(&self, stop: Stop, token: &PlacedTex, list: &[TexItem]) -> bool {
        let command = token.command();
        // A bar behind an operand closes.
        let operand = list.last().is_some_and(|item| !is_operator(item));
        match stop {
            Stop::End => false,
            Stop::Brace => token.is('}'),
            Stop::Bracket => {
                [')', ']'].iter().any(|sign| token.is(*sign))
                    || matches!(command, Some("}" | "rangle" | "rvert" | "rVert"))
            }
            Stop::Right => command == Some("right"),
            Stop::Bar => operand && (token.is('|') || matches!(command, Some("vert" | "mid"))),
            Stop::DoubleBar => operand && matches!(command, Some("|" | "Vert")),
            Stop::Cell => {
                token.is('&') || command.is_some_and(|name| name == "end" || is_end_of_row(name))
            }
            Stop::Option => token.is(']'),
        }
    }

    /// Lays out items up to what ends the list, which is left.
    fn list(&mut self, stop: Stop) -> Listed {
        if self.depth >= MAX_LAYOUT_DEPTH {
            let message = format!(
                "brackets, scripts and arguments are nested deeper than {MAX_LAYOUT_DEPTH} levels"
            );
            return Err(LatexError::new(self.place(), message));
        }
        self.depth += 1;
        let mut list: Vec<TexItem> = vec![];
        let mut face: Option<TexFace> = None;
        while let Some(token) = self.peek() {
            if self.ends(stop, token, &list) {
                break;
            }
            // A closing bracket of a list that began otherwise has no partner.
            if token.is('}')
                || token.is(')')
                || (token.is(']') && stop != Stop::Bracket)
                || token.command() == Some("right")
                || token.command() == Some("end")
            {
                break;
            }
            let before = list.len();
            self.item(&mut list, &mut face)?;
            if let Some(face) = &face {
                for item in list.iter_mut().skip(before) {
                    faced(item, face);
                }
            }
        }
        self.depth -= 1;
        pairs_of_bars(&list)?;
        without_ends_of_rows(list)
    }

    /// Lays out the next item, or scripts of the last one.
    fn item(
        &mut self,
        list: &mut Vec<TexItem>,
        face: &mut Option<TexFace>,
    ) -> Result<(), LatexError> {
        let Some(token) = self.peek() else {
            return Ok(());
        };
        let place = token.place;
        let token = token.token.clone();
        match token {
            TexToken::Character(sign) => {
                self.next += 1;
                match sign {
                    ' ' | '~' | '&' => {}
                    '{' => {
                        let inner = self.closed(Stop::Brace, '}', place)?;
                        self.group(list, inner, place);
                    }
                    '^' | '_' => self.script(list, sign, place)?,
                    '\'' | '\u{2019}' | '\u{2032}' => {
                        let last = self.carrier(list, place)?;
                        if last.above.is_some() {
                            return Err(LatexError::new(
                                place,
                                "a prime stands behind a superscript",
                            ));
                        }
                        last.primes += 1;
                        last.place = last.place.to(place);
                    }
                    '0'..='9' => self.number(list, sign, place)?,
                    '(' | '[' => {
                        let inner = self.list(Stop::Bracket)?;
                        let close = self.closing(place, sign)?;
                        self.push(list, Nucleus::Fenced(sign, inner, close), place);
                    }
                    '|' => {
                        let inner = self.list(Stop::Bar)?;
                        if !self.take('|') {
                            return Err(LatexError::new(place, "this bar has no partner"));
                        }
                        self.push(list, Nucleus::Fenced('|', inner, '|'), place);
                    }
                    _ => list.push(TexItem::new(character(sign, place)?, place)),
                }
                Ok(())
            }
            TexToken::Command(name) if is_end_of_row(&name) => {
                self.next += 1;
                self.option()?;
                list.push(TexItem::new(Nucleus::Sign(END_OF_ROW.to_owned()), place));
                Ok(())
            }
            TexToken::Command(name) => {
                self.next += 1;
                self.command(list, face, &name, place)
            }
        }
    }

    /// Adds digits to a number, or begins one.
    fn number(
        &mut self,
        list: &mut Vec<TexItem>,
        sign: char,
        place: Place,
    ) -> Result<(), LatexError> {
        let mut digits = sign.to_string();
        let mut end = place;
        while let Some(token) = self.peek() {
            let TexToken::Character(next) = token.token else {
                break;
            };
            let point = next == '.'
                && !digits.contains('.')
                && matches!(
                    self.tokens.get(self.next + 1),
                    Some(PlacedTex {
                        token: TexToken::Character('0'..='9'),
                        ..
                    })
                );
            if !next.is_ascii_digit() && !point {
                break;
            }
            digits.push(next);
            end = token.place;
            self.next += 1;
        }
        let rest = self.tokens.get(self.next..).unwrap_or(&[]);
        if let [open, comma, close, digit, ..] = rest
            && open.is('{')
            && comma.is(',')
            && close.is('}')
            && ('0'..='9').any(|sign| digit.is(sign))
        {
            let error = LatexError::new(
                place.to(digit.place),
                "this comma may mark decimals, or thousands",
            );
            return Err(error.with_help("write a decimal point, or no comma"));
        }
        list.push(TexItem::new(Nucleus::Number(digits), place.to(end)));
        Ok(())
    }

    /// Pushes an item that ends before the next token.
    fn push(&self, list: &mut Vec<TexItem>, nucleus: Nucleus, start: Place) {
        let last = self.next.checked_sub(1).and_then(|at| self.tokens.get(at));
        let place = start.to(last.map_or(start, |token| token.place));
        list.push(TexItem::new(nucleus, place));
    }

    /// The item that carries a script.
    fn carrier<'l>(
        &self,
        list: &'l mut [TexItem],
        place: Place,
    ) -> Result<&'l mut TexItem, LatexError> {
        let carries = |item: &TexItem| match &item.nucleus {
            Nucleus::Words(_) => false,
            Nucleus::Sign(_) => !is_operator(item),
            _ => true,
        };
        match list.last_mut().filter(|item| carries(item)) {
            Some(last) => Ok(last),
            None => Err(LatexError::new(place, "nothing carries this script")),
        }
    }

    fn script(&mut self, list: &mut [TexItem], sign: char, place: Place) -> Result<(), LatexError> {
        let mut inner = self.argument(place)?;
        let end = self
            .next
            .checked_sub(1)
            .and_then(|at| self.tokens.get(at))
            .map_or(place, |token| token.place);
        let last = self.carrier(list, place)?;
        last.place = last.place.to(end);
        if sign == '^' {
            let primes = inner
                .iter()
                .take_while(|item| item.is_sign("prime"))
                .count();
            if primes > 0 {
                last.primes += primes;
                inner.drain(..primes);
                if inner.is_empty() {
                    return Ok(());
                }
            }
        }
        let slot = match sign {
            '^' => &mut last.above,
            _ => &mut last.below,
        };
        if slot.is_some() {
            return Err(LatexError::new(place, "two scripts stand at one place"));
        }
        *slot = Some(inner);
        Ok(())
    }
}

/// Whether a control sequence ends a row.
fn is_end_of_row(name: &str) -> bool {
    matches!(name, "\\" | "\\*" | "cr" | "newline")
}

/// Whether an item asks for an operand behind it.
fn is_operator(item: &TexItem) -> bool {
    match &item.nucleus {
        Nucleus::Sign(sign) => !matches!(
            sign.as_str(),
            "!" | "infty" | "prime" | "partial" | "top" | "ell"
        ),
        Nucleus::Operator(_) | Nucleus::Big(_) => item.is_bare(),
        Nucleus::Words(_) => true,
        _ => false,
    }
}

/// Removes punctuation at the end of a displayed formula.
pub fn without_final_punctuation(mut list: Vec<TexItem>) -> Vec<TexItem> {
    while list
        .last()
        .is_some_and(|last| [".", ",", ";"].iter().any(|sign| last.is_sign(sign)))
    {
        list.pop();
    }
    list
}
