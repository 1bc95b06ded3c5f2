//! Macros: `\newcommand`, `\renewcommand`, `\providecommand`, `\def` with parameters without delimiters, and
//! `\DeclareMathOperator`; they last to the end of the group in which they are defined. What `\iffalse` and the switches of
//! `\newif` leave out is left out.
//!
//! Expansion is bounded by its number and by the size of the text; a macro that calls itself meets a bound, which is an error. What
//! a macro stands for has the place of its call.

use crate::switches::Switches;
use std::collections::BTreeMap;
use torse_syntax::formula::Place;
use torse_syntax::latex::token::{MAX_TEX_TOKENS, PlacedTex, TexToken};

/// The largest number of expansions of a manuscript.
const MAX_EXPANSIONS: usize = 50_000;

/// Why a manuscript is not read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ManuscriptError {
    /// Macros were expanded too often, or to too long a text; most likely one calls itself.
    Expansion {
        /// The macro at which a limit was exceeded.
        name: String,
        /// The place of its call.
        place: Place,
    },
    /// The text is too long.
    TooLong,
}

impl std::fmt::Display for ManuscriptError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Expansion { name, .. } => {
                write!(
                    f,
                    "the macro `\\{name}` does not come to an end: {MAX_EXPANSIONS} expansions or {MAX_TEX_TOKENS} tokens are exceeded"
                )
            }
            Self::TooLong => write!(f, "the manuscript has more than {MAX_TEX_TOKENS} tokens"),
        }
    }
}

impl std::error::Error for ManuscriptError {}

/// What is not understood, and its place.
pub type Unread = (Place, String);

struct Macro {
    parameters: usize,
    default: Option<Vec<PlacedTex>>,
    body: Vec<PlacedTex>,
}

/// The macros in force, and what they were outside of the groups around.
#[derive(Default)]
struct Macros {
    known: BTreeMap<String, Macro>,
    /// For each open group what its definitions replaced.
    outside: Vec<Vec<(String, Option<Macro>)>>,
}

impl Macros {
    fn define(&mut self, (name, found): (String, Macro)) {
        let before = self.known.insert(name.clone(), found);
        if let Some(group) = self.outside.last_mut() {
            group.push((name, before));
        }
    }

    /// Follows the beginnings and ends of groups.
    fn group(&mut self, token: &PlacedTex) {
        let begins =
            token.is('{') || matches!(token.command(), Some("begin" | "begingroup" | "bgroup"));
        let ends = token.is('}') || matches!(token.command(), Some("end" | "endgroup" | "egroup"));
        if begins {
            self.outside.push(vec![]);
        } else if ends {
            let defined = self.outside.pop().unwrap_or_default();
            for (name, before) in defined.into_iter().rev() {
                match before {
                    Some(before) => self.known.insert(name, before),
                    None => self.known.remove(&name),
                };
            }
        }
    }
}

/// Takes definitions out of the text and expands their calls; also returns the places of definitions that are not understood.
pub fn expanded(tokens: Vec<PlacedTex>) -> Result<(Vec<PlacedTex>, Vec<Unread>), ManuscriptError> {
    let mut macros = Macros::default();
    let mut switches = Switches::default();
    let mut unread = vec![];
    let mut output: Vec<PlacedTex> = vec![];
    let mut expansions = 0_usize;
    // The tokens that are still to come, the next one last.
    let mut input: Vec<PlacedTex> = tokens;
    input.reverse();
    while let Some(token) = input.pop() {
        macros.group(&token);
        let Some(name) = token.command().map(str::to_owned) else {
            output.push(token);
            continue;
        };
        if let Some(why) = switches.take(&name, &mut input) {
            unread.extend(why.map(|why| (token.place, why)));
            continue;
        }
        let defined = match name.trim_end_matches('*') {
            "newcommand" | "renewcommand" | "providecommand" => {
                new_command(&mut input).ok_or_else(|| format!("this `\\{name}` is not understood"))
            }
            "DeclareMathOperator" => operator(&mut input, token.place)
                .ok_or_else(|| "this operator is not understood".to_owned()),
            "def" => definition(&mut input).ok_or_else(|| {
                "this `\\def` is not understood: its parameters have delimiters".to_owned()
            }),
            _ => {
                let Some(found) = macros.known.get(&name) else {
                    output.push(token);
                    continue;
                };
                expansions += 1;
                let arguments = arguments(found, &mut input);
                let text = substituted(&found.body, &arguments, token.place);
                if expansions > MAX_EXPANSIONS
                    || input.len() + text.len() + output.len() > MAX_TEX_TOKENS
                {
                    return Err(ManuscriptError::Expansion {
                        name,
                        place: token.place,
                    });
                }
                input.extend(text.into_iter().rev());
                continue;
            }
        };
        match defined {
            Ok(defined) => macros.define(defined),
            Err(why) => unread.push((token.place, why)),
        }
    }
    Ok((output, unread))
}

fn blanks(input: &mut Vec<PlacedTex>) {
    while input.last().is_some_and(|token| token.is(' ')) {
        input.pop();
    }
}

/// Takes a group without its braces, or one token.
pub fn group(input: &mut Vec<PlacedTex>) -> Option<Vec<PlacedTex>> {
    blanks(input);
    let first = input.pop()?;
    if !first.is('{') {
        return Some(vec![first]);
    }
    let (mut inner, mut open) = (vec![], 1_usize);
    while let Some(token) = input.pop() {
        if token.is('{') {
            open += 1;
        } else if token.is('}') {
            open -= 1;
            if open == 0 {
                return Some(inner);
            }
        }
        inner.push(token);
    }
    None
}

/// Takes an optional argument without its brackets.
fn option(input: &mut Vec<PlacedTex>) -> Option<Vec<PlacedTex>> {
    blanks(input);
    if !input.last().is_some_and(|token| token.is('[')) {
        return None;
    }
    input.pop();
    let (mut inner, mut open) = (vec![], 0_usize);
    while let Some(token) = input.pop() {
        if token.is('{') {
            open += 1;
        } else if token.is('}') {
            open = open.saturating_sub(1);
        } else if token.is(']') && open == 0 {
            return Some(inner);
        }
        inner.push(token);
    }
    Some(inner)
}

fn digits(tokens: &[PlacedTex]) -> Option<usize> {
    let text: Option<String> = tokens
        .iter()
        .map(|token| match token.token {
            TexToken::Character(sign) => Some(sign),
            TexToken::Command(_) => None,
        })
        .collect();
    text?.trim().parse().ok().filter(|count| *count <= 9)
}

fn new_command(input: &mut Vec<PlacedTex>) -> Option<(String, Macro)> {
    let name = group(input)?
        .iter()
        .find_map(|token| token.command().map(str::to_owned))?;
    let parameters = match option(input) {
        None => 0,
        Some(count) => digits(&count)?,
    };
    let default = option(input);
    let body = group(input)?;
    Some((
        name,
        Macro {
            parameters,
            default,
            body,
        },
    ))
}

fn operator(input: &mut Vec<PlacedTex>, place: Place) -> Option<(String, Macro)> {
    let name = group(input)?
        .iter()
        .find_map(|token| token.command().map(str::to_owned))?;
    let words = group(input)?;
    let token = |token: TexToken| PlacedTex { token, place };
    let mut body = vec![
        token(TexToken::Command("operatorname".to_owned())),
        token(TexToken::Character('{')),
    ];
    body.extend(words);
    body.push(token(TexToken::Character('}')));
    Some((
        name,
        Macro {
            parameters: 0,
            default: None,
            body,
        },
    ))
}

fn definition(input: &mut Vec<PlacedTex>) -> Option<(String, Macro)> {
    let name = input.pop()?.command()?.to_owned();
    let mut parameters = 0;
    let mut plain = true;
    while let Some(token) = input.last() {
        if token.is('{') {
            break;
        }
        let is_mark = token.is('#');
        input.pop();
        if is_mark {
            parameters += 1;
            let digit = input.pop()?;
            plain &= matches!(digit.token, TexToken::Character(digit) if digit.to_digit(10) == Some(parameters));
        } else {
            plain = false;
        }
    }
    let body = group(input)?;
    plain.then_some((
        name,
        Macro {
            parameters: usize::try_from(parameters).ok()?,
            default: None,
            body,
        },
    ))
}

fn arguments(found: &Macro, input: &mut Vec<PlacedTex>) -> Vec<Vec<PlacedTex>> {
    let mut arguments = vec![];
    if let Some(default) = &found.default {
        arguments.push(option(input).unwrap_or_else(|| default.clone()));
    }
    while arguments.len() < found.parameters {
        arguments.push(group(input).unwrap_or_default());
    }
    arguments
}

fn substituted(body: &[PlacedTex], arguments: &[Vec<PlacedTex>], place: Place) -> Vec<PlacedTex> {
    let mut text = vec![];
    let mut tokens = body.iter().peekable();
    while let Some(token) = tokens.next() {
        if token.is('#')
            && let Some(TexToken::Character(digit)) = tokens.peek().map(|next| &next.token)
            && let Some(number) = digit
                .to_digit(10)
                .and_then(|number| usize::try_from(number).ok())
            && let Some(argument) = number.checked_sub(1).and_then(|at| arguments.get(at))
        {
            tokens.next();
            text.extend(argument.iter().cloned());
            continue;
        }
        text.push(PlacedTex {
            token: token.token.clone(),
            place,
        });
    }
    text
}
