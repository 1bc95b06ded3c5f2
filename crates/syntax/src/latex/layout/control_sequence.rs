//! Commands with their arguments, and environments.

use super::super::commands::{CommandKind, command_kind};
use super::super::error::LatexError;
use super::super::item::{Nucleus, TexFace, TexItem, nucleus_signature};
use super::super::token::{PlacedTex, TexToken};
use super::rows::joined;
use super::{Layout, Listed, MAX_LAYOUT_DEPTH, Stop, is_end_of_row};
use crate::formula::Place;

impl Layout<'_> {
    /// Takes the argument of a command: a group in braces, or one token.
    pub(super) fn argument(&mut self, of: Place) -> Listed {
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
    pub(super) fn option(&mut self) -> Result<Option<Vec<TexItem>>, LatexError> {
        self.blanks();
        let start = self.place();
        match self.take('[') {
            true => self.closed(Stop::Option, ']', start).map(Some),
            false => Ok(None),
        }
    }

    /// Takes the raw text of an argument in braces.
    pub(super) fn raw(&mut self, of: Place) -> Result<String, LatexError> {
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

    pub(super) fn command(
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
    pub(super) fn faced_argument(
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

    /// Lays out an environment: cells of a matrix, or the content of one that only arranges.
    pub(super) fn environment(
        &mut self,
        list: &mut Vec<TexItem>,
        place: Place,
    ) -> Result<(), LatexError> {
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
                Some(TexToken::Command(sign)) if is_end_of_row(&sign) => {
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
            list.extend(joined(rows.into_iter().map(|row| row.concat()).collect())?);
            return Ok(());
        }
        self.push(list, Nucleus::Grid(name, rows), place);
        Ok(())
    }
}

/// Sets letters in a face.
pub(super) fn faced(item: &mut TexItem, face: &TexFace) {
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
        item.nucleus = Nucleus::Words(nucleus_signature(&inner));
    }
}
