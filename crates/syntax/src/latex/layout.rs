//! From tokens to a list of items: brackets are matched, scripts go to what carries them, arguments of commands are taken.
//!
//! What is left out here has no meaning: blanks, sizes, styles, labels and the signs of alignment. Everything else becomes an
//! item, or is an error with its place.

use super::commands::{CommandKind, command_kind};
use super::error::LatexError;
use super::item::{Nucleus, TexFace, TexItem, look_alike};
use super::token::{MAX_TEX_TOKENS, PlacedTex, TexToken, tex_tokens};
use crate::formula::Place;
use crate::greek;

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
            Stop::Cell => token.is('&') || matches!(command, Some("\\" | "end" | "cr")),
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
        Ok(list)
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
                    '0'..='9' => self.number(list, sign, place),
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
            TexToken::Command(name) => {
                self.next += 1;
                self.command(list, face, &name, place)
            }
        }
    }

    /// Adds digits to a number, or begins one.
    fn number(&mut self, list: &mut Vec<TexItem>, sign: char, place: Place) {
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
        list.push(TexItem::new(Nucleus::Number(digits), place.to(end)));
    }

    /// Pushes an item that ends before the next token.
    fn push(&self, list: &mut Vec<TexItem>, nucleus: Nucleus, start: Place) {
        let last = self.next.checked_sub(1).and_then(|at| self.tokens.get(at));
        let place = start.to(last.map_or(start, |token| token.place));
        list.push(TexItem::new(nucleus, place));
    }

    /// Lays out a list and takes what closes it.
    fn closed(&mut self, stop: Stop, close: char, start: Place) -> Listed {
        let inner = self.list(stop)?;
        match self.take(close) {
            true => Ok(inner),
            false => Err(LatexError::new(start, "this bracket is never closed")),
        }
    }

    fn closing(&mut self, start: Place, open: char) -> Result<char, LatexError> {
        let found = self.peek().map(|token| token.token.clone());
        let close = match found {
            Some(TexToken::Character(sign @ (')' | ']'))) => sign,
            Some(TexToken::Command(name)) if name == "}" => '}',
            Some(TexToken::Command(name)) if name == "rangle" => '⟩',
            Some(TexToken::Command(name)) if name == "rvert" => '|',
            Some(TexToken::Command(name)) if name == "rVert" => '‖',
            _ => return Err(LatexError::new(start, "this bracket is never closed")),
        };
        let fits = match open {
            '(' | '[' => matches!(close, ')' | ']'),
            '{' => close == '}',
            '⟨' => close == '⟩',
            other => close == other,
        };
        if !fits {
            return Err(LatexError::new(
                start.to(self.place()),
                "the brackets do not fit together",
            ));
        }
        self.next += 1;
        Ok(close)
    }

    /// Adds the items of a group in braces: braces of one item, or without scripts, are invisible.
    fn group(&mut self, list: &mut Vec<TexItem>, mut inner: Vec<TexItem>, start: Place) {
        self.blanks();
        let scripted = self
            .peek()
            .is_some_and(|token| token.is('^') || token.is('_') || token.is('\''));
        match (inner.len(), scripted) {
            (0, true) => self.push(list, Nucleus::Group(vec![]), start),
            (1, true) if inner.first().is_some_and(TexItem::is_bare) => list.append(&mut inner),
            (_, true) => self.push(list, Nucleus::Group(inner), start),
            (_, false) => list.append(&mut inner),
        }
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

    /// Takes the argument of a command: a group in braces, or one token.
    fn argument(&mut self, of: Place) -> Listed {
        self.blanks();
        let start = self.place();
        if self.take('{') {
            return self.closed(Stop::Brace, '}', start);
        }
        let Some(token) = self.peek() else {
            return Err(LatexError::new(of, "an argument is missing"));
        };
        let mut list = vec![];
        match token.token {
            TexToken::Character(digit @ '0'..='9') => {
                self.next += 1;
                list.push(TexItem::new(Nucleus::Number(digit.to_string()), start));
            }
            TexToken::Character('^' | '_' | '}' | '&' | '\'') => {
                return Err(LatexError::new(of, "an argument is missing"));
            }
            _ => {
                if self.depth >= MAX_LAYOUT_DEPTH {
                    return Err(LatexError::new(
                        of,
                        format!("nested deeper than {MAX_LAYOUT_DEPTH} levels"),
                    ));
                }
                self.depth += 1;
                self.item(&mut list, &mut None)?;
                self.depth -= 1;
            }
        }
        Ok(list)
    }

    /// Takes an optional argument in square brackets.
    fn option(&mut self) -> Result<Option<Vec<TexItem>>, LatexError> {
        self.blanks();
        let start = self.place();
        match self.take('[') {
            true => self.closed(Stop::Option, ']', start).map(Some),
            false => Ok(None),
        }
    }

    /// Takes the raw text of an argument in braces.
    fn raw(&mut self, of: Place) -> Result<String, LatexError> {
        self.blanks();
        if !self.take('{') {
            return Err(LatexError::new(of, "an argument in braces is missing"));
        }
        let (mut text, mut open) = (String::new(), 1_usize);
        while let Some(token) = self.peek() {
            match &token.token {
                TexToken::Character('{') => open += 1,
                TexToken::Character('}') => open -= 1,
                TexToken::Character('~') => text.push(' '),
                TexToken::Character(sign) => text.push(*sign),
                TexToken::Command(name) if name == "par" || name == " " || name == "," => {
                    text.push(' ')
                }
                TexToken::Command(name) => text.extend(["\\", name, " "]),
            }
            self.next += 1;
            if open == 0 {
                return Ok(text);
            }
        }
        Err(LatexError::new(of, "this argument is never closed"))
    }

    fn command(
        &mut self,
        list: &mut Vec<TexItem>,
        face: &mut Option<TexFace>,
        name: &str,
        place: Place,
    ) -> Result<(), LatexError> {
        // The star of a formula is a sign, `\pi*2`.
        let bare = name
            .strip_suffix('*')
            .filter(|bare| !bare.is_empty() && *bare != "operatorname");
        if let Some(bare) = bare {
            self.command(list, face, bare, place)?;
            if !matches!(command_kind(bare), CommandKind::Ignored(_)) {
                list.push(TexItem::new(Nucleus::Sign("*".to_owned()), place));
            }
            return Ok(());
        }
        match command_kind(name) {
            CommandKind::Ignored(arguments) => {
                for _ in 0..arguments {
                    self.raw(place)?;
                }
            }
            CommandKind::Greek(letter) => {
                list.push(TexItem::new(
                    Nucleus::Letter(letter.to_owned(), TexFace::Plain),
                    place,
                ));
            }
            CommandKind::Sign(sign) => {
                list.push(TexItem::new(Nucleus::Sign(sign.to_owned()), place))
            }
            CommandKind::Operator => {
                list.push(TexItem::new(Nucleus::Operator(name.to_owned()), place))
            }
            CommandKind::Big(kind) => list.push(TexItem::new(Nucleus::Big(kind.to_owned()), place)),
            CommandKind::Dots => list.push(TexItem::new(Nucleus::Dots, place)),
            CommandKind::Switch(switched) => *face = Some(switched),
            CommandKind::Face(wanted) => self.faced_argument(list, name, &wanted, place)?,
            CommandKind::Letter(letters) => list.push(TexItem::new(
                Nucleus::Letter(letters.to_owned(), TexFace::Plain),
                place,
            )),
            CommandKind::Words => {
                let words = self.raw(place)?;
                self.push(
                    list,
                    Nucleus::Words(words.split_whitespace().collect::<Vec<_>>().join(" ")),
                    place,
                );
            }
            CommandKind::Named => {
                let words = self.raw(place)?;
                let words: String = words.chars().filter(|c| !c.is_whitespace()).collect();
                self.push(list, Nucleus::Operator(words), place);
            }
            CommandKind::Fraction => {
                let (over, under) = (self.argument(place)?, self.argument(place)?);
                self.push(list, Nucleus::Fraction(over, under), place);
            }
            CommandKind::Binomial => {
                let (over, under) = (self.argument(place)?, self.argument(place)?);
                self.push(list, Nucleus::Binomial(over, under), place);
            }
            CommandKind::Root => {
                let degree = self.option()?;
                let inner = self.argument(place)?;
                self.push(list, Nucleus::Root(degree, inner), place);
            }
            CommandKind::Dotted(count) => {
                let inner = self.argument(place)?;
                self.push(list, Nucleus::Dotted(count, inner), place);
            }
            CommandKind::Left => self.fence(list, place)?,
            CommandKind::Opening(open) => {
                let stop = match open {
                    '‖' if name != "lVert" => Stop::DoubleBar,
                    _ => Stop::Bracket,
                };
                let inner = self.list(stop)?;
                let close = match open {
                    '‖' if name != "lVert"
                        && matches!(
                            self.peek().and_then(PlacedTex::command),
                            Some("|" | "Vert")
                        ) =>
                    {
                        self.next += 1;
                        '‖'
                    }
                    _ => self.closing(place, open)?,
                };
                self.push(list, Nucleus::Fenced(open, inner, close), place);
            }
            CommandKind::Begin => self.environment(list, place)?,
            CommandKind::Unknown => {
                let error = LatexError::new(place, format!("`\\{name}` is not understood"));
                return Err(
                    error.with_help("define it in the preamble, or write the formula by hand")
                );
            }
        }
        Ok(())
    }

    /// Takes the argument of a face or an accent: a letter, or a word in a face that is no vector's.
    fn faced_argument(
        &mut self,
        list: &mut Vec<TexItem>,
        name: &str,
        wanted: &TexFace,
        place: Place,
    ) -> Result<(), LatexError> {
        let inner = self.argument(place)?;
        let is_over =
            matches!(wanted, TexFace::Accent(..)) || matches!(name, "vec" | "overrightarrow");
        if is_over && inner.len() != 1 {
            return Err(LatexError::new(
                place,
                format!("`\\{name}` over more than one letter is not understood"),
            ));
        }
        let letters = inner
            .iter()
            .filter(|item| item.is_bare())
            .map(|item| match &item.nucleus {
                Nucleus::Letter(letters, _) => Some(letters.as_str()),
                Nucleus::Number(digits) => Some(digits.as_str()),
                _ => None,
            });
        let letters: Option<Vec<&str>> = letters.collect();
        if let (TexFace::Other(_), Some(letters), true) = (wanted, &letters, inner.len() > 1) {
            self.push(
                list,
                Nucleus::Letter(letters.concat(), wanted.clone()),
                place,
            );
            return Ok(());
        }
        for mut item in inner {
            faced(&mut item, wanted);
            list.push(item);
        }
        Ok(())
    }

    /// Lays out `\left( ... \right)`.
    fn fence(&mut self, list: &mut Vec<TexItem>, place: Place) -> Result<(), LatexError> {
        let open = self.delimiter(place)?;
        let inner = self.list(Stop::Right)?;
        if self.peek().and_then(PlacedTex::command) != Some("right") {
            return Err(LatexError::new(place, "`\\left` has no `\\right`"));
        }
        self.next += 1;
        let close = self.delimiter(place)?;
        let inner_place = place;
        self.push(list, Nucleus::Fenced(open, inner, close), inner_place);
        Ok(())
    }

    fn delimiter(&mut self, place: Place) -> Result<char, LatexError> {
        self.blanks();
        let sign = match self.peek().map(|token| &token.token) {
            Some(TexToken::Character(sign @ ('(' | ')' | '[' | ']' | '|' | '.'))) => *sign,
            Some(TexToken::Command(name)) => match name.as_str() {
                "{" | "lbrace" => '{',
                "}" | "rbrace" => '}',
                "|" | "Vert" | "lVert" | "rVert" => '‖',
                "vert" | "lvert" | "rvert" => '|',
                "langle" => '⟨',
                "rangle" => '⟩',
                "lbrack" => '[',
                "rbrack" => ']',
                _ => return Err(LatexError::new(place, "this bracket is not understood")),
            },
            _ => return Err(LatexError::new(place, "this bracket is not understood")),
        };
        self.next += 1;
        Ok(sign)
    }

    /// Lays out an environment: cells of a matrix, or the content of one that only arranges.
    fn environment(&mut self, list: &mut Vec<TexItem>, place: Place) -> Result<(), LatexError> {
        let name = self.raw(place)?;
        let name = name.trim_end_matches('*').to_owned();
        let only_arranges = matches!(
            name.as_str(),
            "split" | "aligned" | "gathered" | "alignedat" | "multlined"
        );
        let is_grid = matches!(
            name.as_str(),
            "matrix"
                | "pmatrix"
                | "bmatrix"
                | "vmatrix"
                | "Bmatrix"
                | "Vmatrix"
                | "smallmatrix"
                | "array"
                | "cases"
                | "dcases"
        );
        if !only_arranges && !is_grid {
            return Err(LatexError::new(
                place,
                format!("the environment `{name}` is not understood"),
            ));
        }
        if matches!(name.as_str(), "array" | "alignedat") {
            self.raw(place)?;
        }
        let mut rows: Vec<Vec<Vec<TexItem>>> = vec![vec![]];
        loop {
            let cell = self.list(Stop::Cell)?;
            if let Some(row) = rows.last_mut() {
                row.push(cell);
            }
            match self.peek().map(|token| token.token.clone()) {
                Some(TexToken::Character('&')) => self.next += 1,
                Some(TexToken::Command(sign)) if sign == "\\" || sign == "cr" => {
                    self.next += 1;
                    self.option()?;
                    rows.push(vec![]);
                }
                Some(TexToken::Command(sign)) if sign == "end" => {
                    self.next += 1;
                    let closed = self.raw(place)?;
                    if closed.trim_end_matches('*') != name {
                        return Err(LatexError::new(
                            place,
                            format!("`{name}` is closed as `{closed}`"),
                        ));
                    }
                    break;
                }
                _ => return Err(LatexError::new(place, format!("`{name}` is never closed"))),
            }
        }
        // Nothing follows the last end of a row.
        if rows.len() > 1 && rows.last().is_some_and(|row| row.iter().all(Vec::is_empty)) {
            rows.pop();
        }
        if only_arranges {
            list.extend(rows.into_iter().flatten().flatten());
            return Ok(());
        }
        self.push(list, Nucleus::Grid(name, rows), place);
        Ok(())
    }
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

/// Sets letters in a face.
fn faced(item: &mut TexItem, face: &TexFace) {
    if let Nucleus::Letter(_, own) = &mut item.nucleus {
        *own = match (face, &*own) {
            (TexFace::Accent(name, _), before) => {
                TexFace::Accent(name.clone(), Box::new(before.clone()))
            }
            (face, TexFace::Accent(name, _)) => {
                TexFace::Accent(name.clone(), Box::new(face.clone()))
            }
            (face, _) => face.clone(),
        };
    } else if matches!(face, TexFace::Accent(..)) {
        // An accent over more than letters is a name of its own, which no rule reads.
        let inner = std::mem::replace(&mut item.nucleus, Nucleus::Dots);
        item.nucleus = Nucleus::Words(super::item::nucleus_signature(&inner));
    }
}

fn character(sign: char, place: Place) -> Result<Nucleus, LatexError> {
    let letter = |name: &str| Nucleus::Letter(name.to_owned(), TexFace::Plain);
    Ok(match sign {
        'a'..='z' | 'A'..='Z' => letter(&sign.to_string()),
        '+' | '-' | '*' | '/' | '=' | '<' | '>' | ',' | ';' | '.' | '!' | ':' => {
            Nucleus::Sign(sign.to_string())
        }
        '−' => Nucleus::Sign("-".to_owned()),
        '·' => Nucleus::Sign("cdot".to_owned()),
        '×' => Nucleus::Sign("times".to_owned()),
        '≤' => Nucleus::Sign("le".to_owned()),
        '≥' => Nucleus::Sign("ge".to_owned()),
        '≠' => Nucleus::Sign("ne".to_owned()),
        '…' => Nucleus::Dots,
        _ => match greek::by_sign(sign) {
            Some(found) => letter(found.name),
            None => {
                let message = format!("`{sign}` is not understood in a formula");
                return Err(LatexError::new(place, message));
            }
        },
    })
}

/// Refuses two forms of one Greek letter, `\phi` and `\varphi`, which have one name.
///
/// # Errors
/// [`LatexError`] at the second form.
pub fn one_form_of_each_letter(tokens: &[PlacedTex]) -> Result<(), LatexError> {
    let mut forms: Vec<(&str, &str)> = vec![];
    for token in tokens {
        let Some(form) = token.command() else {
            continue;
        };
        let CommandKind::Greek(letter) = command_kind(form) else {
            continue;
        };
        match forms.iter().find(|(other, _)| *other == letter) {
            Some((_, first)) if *first != form => {
                let message =
                    format!("`\\{first}` and `\\{form}` are two letters, and have one name here");
                return Err(LatexError::new(token.place, message));
            }
            Some(_) => {}
            None => forms.push((letter, form)),
        }
    }
    Ok(())
}

/// Refuses bars that could be paired in another way: `|a|b|c|`.
fn pairs_of_bars(list: &[TexItem]) -> Result<(), LatexError> {
    let bars = |item: &TexItem| matches!(item.nucleus, Nucleus::Fenced('|', _, '|'));
    let mut since: Option<usize> = None;
    for (at, item) in list.iter().enumerate() {
        if bars(item) {
            if let Some(before) = since {
                let between = list.get(before + 1..at).unwrap_or(&[]);
                // `|a| |b|` as well as `|a|b|c|`; signs between them settle it.
                if !between.iter().any(is_operator) && !between.is_empty() {
                    let error = LatexError::new(item.place, "the bars can be paired in two ways");
                    return Err(error.with_help("write `\\lvert` and `\\rvert`"));
                }
            }
            since = Some(at);
        }
    }
    Ok(())
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

/// Whether a list is only this letter.
#[must_use]
pub fn is_letter(list: &[TexItem], letter: &str) -> bool {
    let plain =
        |face: TexFace| TexItem::new(Nucleus::Letter(letter.to_owned(), face), Place::default());
    look_alike(list, &[plain(TexFace::Plain)])
        || look_alike(list, &[plain(TexFace::Other("mathrm".to_owned()))])
}
