//! The text of a STEP file (ISO 10303-21): instances by number, each of one entity or of several (complex instances).

use crate::read::error::{FilePlace, ReadError, ReadResult, at, at_line};
use std::collections::HashMap;

/// The most instances of a file.
const MAX_INSTANCES: usize = 4_000_000;
/// How deep lists are nested: a net of points has two levels, a typed value one more.
const MAX_DEPTH: usize = 32;

/// A value as it is written.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Value<'t> {
    Number(&'t str),
    Text(&'t str),
    /// Between points: `.T.`, `.MILLI.`.
    Word(&'t str),
    Reference(u64),
    List(Vec<Value<'t>>),
    /// `LENGTH_MEASURE(1.)`.
    Typed(&'t str, Vec<Value<'t>>),
    /// `$`, `*`, and binary values, which nothing here asks for.
    None,
}

/// An instance: its entities with their values.
#[derive(Debug, Clone)]
pub(super) struct Instance<'t> {
    pub id: u64,
    pub line: usize,
    pub parts: Vec<(&'t str, Vec<Value<'t>>)>,
}

impl<'t> Instance<'t> {
    /// The values of one of its entities.
    pub(super) fn part(&self, keyword: &str) -> Option<&[Value<'t>]> {
        let found = self.parts.iter().find(|(name, _)| *name == keyword);
        found.map(|(_, values)| values.as_slice())
    }

    /// The only entity, or the first of several.
    pub(super) fn keyword(&self) -> &'t str {
        self.parts.first().map_or("", |(name, _)| name)
    }

    pub(super) fn place(&self) -> FilePlace {
        let keyword: String = self.keyword().chars().take(50).collect();
        FilePlace::entity(self.line, format!("#{} {keyword}", self.id))
    }
}

/// The data of a file.
pub(super) struct Data<'t> {
    instances: Vec<Instance<'t>>,
    index: HashMap<u64, usize>,
}

impl<'t> Data<'t> {
    pub(super) fn all(&self) -> &[Instance<'t>] {
        &self.instances
    }

    pub(super) fn get(&self, id: u64) -> Option<&Instance<'t>> {
        self.index.get(&id).and_then(|k| self.instances.get(*k))
    }

    /// The instances of an entity, in the order of the file.
    pub(super) fn instances(&self, keyword: &'static str) -> impl Iterator<Item = &Instance<'t>> {
        self.instances
            .iter()
            .filter(move |instance| instance.part(keyword).is_some())
    }
}

/// Reads all data sections.
pub(super) fn parse(text: &str) -> ReadResult<Data<'_>> {
    let mut lexer = Lexer {
        text,
        at: 0,
        line: 1,
    };
    let mut data = Data {
        instances: Vec::new(),
        index: HashMap::new(),
    };
    let mut inside = false;
    let mut ended = false;
    while lexer.peek()?.is_some() {
        if !inside {
            // Header and ends: up to the next semicolon.
            let word = lexer.statement()?;
            inside = word.starts_with("DATA");
            ended |= word == "END-ISO-10303-21";
            continue;
        }
        if lexer.peek()? != Some(b'#') {
            let word = lexer.statement()?;
            if word != "ENDSEC" {
                let shown: String = word.chars().take(40).collect();
                return Err(lexer.wrong(format!(
                    "`{shown}` where an instance `#1 = ..` or ENDSEC is wanted"
                )));
            }
            inside = false;
            continue;
        }
        let line = lexer.line;
        let id = lexer.reference()?;
        lexer.expect(b'=')?;
        let parts = lexer.instance()?;
        lexer.expect(b';')?;
        let instance = Instance { id, line, parts };
        if data.instances.len() >= MAX_INSTANCES {
            return Err(ReadError::TooMuch {
                place: instance.place(),
                what: "instances",
                most: MAX_INSTANCES,
            });
        }
        if data.index.insert(id, data.instances.len()).is_some() {
            return Err(at(
                &instance.place(),
                "an instance with the number of another one",
            ));
        }
        data.instances.push(instance);
    }
    if inside || !ended {
        return Err(lexer.wrong("the file ends in the middle: END-ISO-10303-21 is missing"));
    }
    Ok(data)
}

struct Lexer<'t> {
    text: &'t str,
    at: usize,
    line: usize,
}

impl<'t> Lexer<'t> {
    fn wrong(&self, reason: impl Into<String>) -> ReadError {
        at_line(self.line, reason)
    }

    fn byte(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    fn step(&mut self) {
        if self.byte() == Some(b'\n') {
            self.line += 1;
        }
        self.at += 1;
    }

    /// The next byte after blanks and comments.
    fn peek(&mut self) -> ReadResult<Option<u8>> {
        loop {
            match self.byte() {
                Some(b) if b.is_ascii_whitespace() => self.step(),
                Some(b'/') if self.text.as_bytes().get(self.at + 1) == Some(&b'*') => {
                    let start = self.line;
                    let rest = self.text.get(self.at..).unwrap_or_default();
                    let Some(length) = rest.find("*/") else {
                        return Err(at_line(start, "a comment that does not end"));
                    };
                    self.line += rest.get(..length).unwrap_or_default().matches('\n').count();
                    self.at += length + 2;
                }
                other => return Ok(other),
            }
        }
    }

    fn expect(&mut self, wanted: u8) -> ReadResult<()> {
        let found = self.peek()?;
        if found == Some(wanted) {
            self.step();
            return Ok(());
        }
        let shown = found.map_or("the end of the file".to_owned(), |b| {
            format!("`{}`", char::from(b))
        });
        Err(self.wrong(format!("{shown} where `{}` is wanted", char::from(wanted))))
    }

    fn while_fits(&mut self, fits: impl Fn(u8) -> bool) -> &'t str {
        let start = self.at;
        while self.byte().is_some_and(&fits) {
            self.at += 1;
        }
        self.text.get(start..self.at).unwrap_or_default()
    }

    /// Everything up to the next semicolon outside of a string; the first word of it is the answer.
    fn statement(&mut self) -> ReadResult<&'t str> {
        self.peek()?;
        let start = self.at;
        let mut quoted = false;
        while let Some(b) = self.byte() {
            if b == b'\'' {
                quoted = !quoted;
            }
            if b == b';' && !quoted {
                let word = self.text.get(start..self.at).unwrap_or_default();
                self.step();
                return Ok(word.trim());
            }
            self.step();
        }
        Err(self.wrong("the file ends in the middle of a statement"))
    }

    fn reference(&mut self) -> ReadResult<u64> {
        self.expect(b'#')?;
        let digits = self.while_fits(|b| b.is_ascii_digit());
        digits
            .parse()
            .map_err(|_| self.wrong("`#` without a number"))
    }

    fn keyword(&mut self) -> ReadResult<&'t str> {
        self.peek()?;
        let word =
            self.while_fits(|b| b.is_ascii_alphanumeric() || matches!(b, b'_' | b'!' | b'-'));
        if word.is_empty() {
            return Err(self.wrong("the name of an entity is missing"));
        }
        Ok(word)
    }

    fn instance(&mut self) -> ReadResult<Vec<(&'t str, Vec<Value<'t>>)>> {
        if self.peek()? != Some(b'(') {
            return Ok(vec![(self.keyword()?, self.list(0)?)]);
        }
        self.step();
        let mut parts = Vec::new();
        while self.peek()? != Some(b')') {
            parts.push((self.keyword()?, self.list(0)?));
            if parts.len() > 64 {
                return Err(self.wrong("an instance of more than 64 entities"));
            }
        }
        self.step();
        Ok(parts)
    }

    /// Values in brackets.
    fn list(&mut self, depth: usize) -> ReadResult<Vec<Value<'t>>> {
        if depth > MAX_DEPTH {
            return Err(self.wrong(format!("lists nested deeper than {MAX_DEPTH}")));
        }
        self.expect(b'(')?;
        let mut values = Vec::new();
        if self.peek()? == Some(b')') {
            self.step();
            return Ok(values);
        }
        loop {
            values.push(self.value(depth)?);
            match self.peek()? {
                Some(b',') => self.step(),
                _ => {
                    self.expect(b')')?;
                    return Ok(values);
                }
            }
        }
    }

    fn value(&mut self, depth: usize) -> ReadResult<Value<'t>> {
        match self.peek()? {
            Some(b'#') => self.reference().map(Value::Reference),
            Some(b'(') => self.list(depth + 1).map(Value::List),
            Some(b'$' | b'*') => {
                self.step();
                Ok(Value::None)
            }
            Some(b'\'') => self.quoted(b'\'').map(Value::Text),
            Some(b'"') => {
                self.quoted(b'"')?;
                Ok(Value::None)
            }
            Some(b'.') => {
                self.step();
                let word = self.while_fits(|b| b.is_ascii_alphanumeric() || b == b'_');
                self.expect(b'.')?;
                Ok(Value::Word(word))
            }
            Some(b'0'..=b'9' | b'+' | b'-') => {
                let number = self
                    .while_fits(|b| b.is_ascii_alphanumeric() || matches!(b, b'+' | b'-' | b'.'));
                Ok(Value::Number(number))
            }
            Some(b) if b.is_ascii_alphabetic() => {
                let word = self.keyword()?;
                Ok(Value::Typed(word, self.list(depth + 1)?))
            }
            Some(b) => Err(self.wrong(format!("`{}` begins no value", char::from(b)))),
            None => Err(self.wrong("the file ends in the middle of a list")),
        }
    }

    /// A text in quotes; a doubled quote is one inside.
    fn quoted(&mut self, quote: u8) -> ReadResult<&'t str> {
        self.step();
        let (start, line) = (self.at, self.line);
        loop {
            match self.byte() {
                None => return Err(at_line(line, "a text that does not end")),
                Some(b) if b == quote => {
                    if self.text.as_bytes().get(self.at + 1) == Some(&quote) {
                        self.at += 2;
                        continue;
                    }
                    let text = self.text.get(start..self.at).unwrap_or_default();
                    self.step();
                    return Ok(text);
                }
                Some(_) => self.step(),
            }
        }
    }
}
