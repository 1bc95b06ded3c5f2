//! As much of XML as a drawing needs: elements with attributes, characters, the five named entities and numbered ones.
//! Comments, declarations and instructions are passed over; there are no entities of a file's own.

use crate::error::{Result, unreadable};

/// An element as it begins.
pub(super) struct Tag {
    pub name: String,
    attributes: Vec<(String, String)>,
    /// Whether it ends at once.
    pub empty: bool,
    pub line: usize,
}

impl Tag {
    /// An attribute.
    pub fn get(&self, name: &str) -> Option<&str> {
        let found = self.attributes.iter().find(|(known, _)| known == name);
        found.map(|(_, value)| value.as_str())
    }

    /// An attribute that is a number.
    pub fn number(&self, name: &str) -> Result<Option<f64>> {
        let wrong = |_| unreadable(self.line, "an attribute that is no number");
        let value = self
            .get(name)
            .map(|value| value.trim().trim_end_matches("px"));
        value.map(|value| value.parse().map_err(wrong)).transpose()
    }
}

pub(super) enum Event {
    Start(Tag),
    /// The name, and the line.
    End(String, usize),
    Text(String),
}

/// Reads one event after the other.
pub(super) struct Reader<'t> {
    rest: &'t str,
    line: usize,
}

impl<'t> Reader<'t> {
    pub fn new(text: &'t str) -> Self {
        Self {
            rest: text,
            line: 1,
        }
    }

    /// The text up to `end`, which is passed as well.
    fn until(&mut self, end: &str) -> Result<&'t str> {
        let wrong = unreadable(self.line, "an element that does not end");
        let (before, after) = self.rest.split_once(end).ok_or(wrong)?;
        self.line += before.matches('\n').count();
        self.rest = after;
        Ok(before)
    }

    pub fn next(&mut self) -> Result<Option<Event>> {
        loop {
            if self.rest.is_empty() {
                return Ok(None);
            }
            let Some(inside) = self.rest.strip_prefix('<') else {
                let end = self.rest.find('<').unwrap_or(self.rest.len());
                let (text, rest) = self.rest.split_at(end);
                let line = self.line;
                self.line += text.matches('\n').count();
                self.rest = rest;
                return Ok(Some(Event::Text(characters(text, line)?)));
            };
            self.rest = inside;
            if let Some(comment) = inside.strip_prefix("!--") {
                self.rest = comment;
                self.until("-->")?;
            } else if inside.starts_with('?') {
                self.until("?>")?;
            } else if inside.starts_with('!') {
                self.until(">")?;
            } else if let Some(end) = inside.strip_prefix('/') {
                self.rest = end;
                let line = self.line;
                return Ok(Some(Event::End(self.until(">")?.trim().to_owned(), line)));
            } else {
                return self.tag().map(|tag| Some(Event::Start(tag)));
            }
        }
    }

    fn tag(&mut self) -> Result<Tag> {
        let line = self.line;
        let named = |c: char| !(c.is_whitespace() || matches!(c, '=' | '/' | '>'));
        let mut tag = Tag {
            name: self.take_while(named).to_owned(),
            attributes: Vec::new(),
            empty: false,
            line,
        };
        loop {
            self.take_while(char::is_whitespace);
            if let Some(rest) = self.rest.strip_prefix("/>") {
                (self.rest, tag.empty) = (rest, true);
                return Ok(tag);
            }
            if let Some(rest) = self.rest.strip_prefix('>') {
                self.rest = rest;
                return Ok(tag);
            }
            let name = self.take_while(named).to_owned();
            self.take_while(|c| c.is_whitespace() || c == '=');
            let quote = self.rest.chars().next().filter(|c| matches!(c, '"' | '\''));
            let quote = quote.filter(|_| !name.is_empty());
            let quote = quote.ok_or(unreadable(self.line, "an attribute without its value"))?;
            self.rest = self.rest.get(1..).unwrap_or_default();
            let at = self.line;
            let value = self.until(quote.encode_utf8(&mut [0; 4]))?;
            tag.attributes.push((name, characters(value, at)?));
        }
    }

    fn take_while(&mut self, fits: impl Fn(char) -> bool) -> &'t str {
        let end = self.rest.find(|c| !fits(c)).unwrap_or(self.rest.len());
        let (taken, rest) = self.rest.split_at(end);
        self.line += taken.matches('\n').count();
        self.rest = rest;
        taken
    }
}

/// Text with its entities made characters again.
fn characters(text: &str, line: usize) -> Result<String> {
    let mut parts = text.split('&');
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let wrong = || unreadable(line, "an unknown entity");
        let (name, rest) = part.split_once(';').ok_or_else(wrong)?;
        let numbered = || {
            let digits = name.strip_prefix('#')?;
            let code = match digits.strip_prefix('x') {
                Some(hex) => u32::from_str_radix(hex, 16).ok()?,
                None => digits.parse().ok()?,
            };
            char::from_u32(code)
        };
        out.push(match name {
            "amp" => '&',
            "lt" => '<',
            "gt" => '>',
            "quot" => '"',
            "apos" => '\'',
            _ => numbered().ok_or_else(wrong)?,
        });
        out.push_str(rest);
    }
    Ok(out)
}
