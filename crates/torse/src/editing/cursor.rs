//! Where a place stands in a derivation file: the table, the key, the text. Files that are being written are rarely valid, so
//! this goes through the text up to the place, and takes the end of a line for the end of what was left open.

/// What a place stands in.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Spot {
    /// The head of a table, `[symbols]`.
    Header,
    /// A key, written in part.
    Key,
    /// A value without quotes, or where one is missing.
    Value,
    /// A text in quotes, whose first letter is at this byte.
    Text {
        /// Its first byte.
        start: usize,
    },
    /// A comment.
    Comment,
}

/// A place of a derivation file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Cursor {
    /// The heads and keys that lead to the place, `claim`, `symbols`, `x`, `in`.
    pub path: Vec<String>,
    /// The byte at which the entry of a list, such as `[[claim]]`, begins; none outside of lists.
    pub entry: Option<usize>,
    /// What the place stands in.
    pub spot: Spot,
}

/// What is open around a value.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Frame {
    List,
    Table,
}

struct Scanner<'t> {
    text: &'t str,
    /// The place that is asked for.
    end: usize,
    at: usize,
    head: Vec<String>,
    entry: Option<usize>,
    keys: Vec<String>,
    frames: Vec<Frame>,
}

/// Returns where the byte `place` of a text stands. A place beyond the text, or within a letter, stands at the end of what is
/// before it.
pub fn cursor(text: &str, place: usize) -> Cursor {
    let mut scanner = Scanner {
        text,
        end: text.floor_char_boundary(place),
        at: 0,
        head: vec![],
        entry: None,
        keys: vec![],
        frames: vec![],
    };
    let spot = scanner.scan();
    let path = scanner.head.into_iter().chain(scanner.keys);
    Cursor {
        path: path.collect(),
        entry: scanner.entry,
        spot,
    }
}

impl Scanner<'_> {
    /// Goes on to the place, and says what it stands in.
    fn scan(&mut self) -> Spot {
        loop {
            let is_key = self.frames.last() != Some(&Frame::List);
            let spot = match is_key {
                true => self.key(),
                false => self.value(),
            };
            if let Some(spot) = spot {
                return spot;
            }
        }
    }

    fn rest(&self) -> &str {
        self.text.get(self.at..self.end).unwrap_or("")
    }

    /// Goes on behind blanks, commas and comments; a comment that reaches the place is one.
    fn blanks(&mut self) -> Option<Spot> {
        loop {
            let rest = self.rest();
            let blanks = rest.len() - rest.trim_start_matches([' ', '\t', '\r', '\n', ',']).len();
            self.at += blanks;
            if !self.rest().starts_with('#') {
                return None;
            }
            match self.rest().find('\n') {
                Some(length) => self.at += length,
                None => return Some(Spot::Comment),
            }
        }
    }

    /// Reads what stands where a key is due: a head, the end of a table, or a key with its value.
    fn key(&mut self) -> Option<Spot> {
        if let Some(comment) = self.blanks() {
            return Some(comment);
        }
        let rest = self.rest();
        let is_top = self.frames.is_empty();
        match rest.chars().next() {
            None => Some(Spot::Key),
            Some('[') if is_top => self.header(),
            Some('}') if !is_top => {
                self.at += 1;
                self.frames.pop();
                self.value_ends();
                None
            }
            Some(first) => {
                let quoted = matches!(first, '"' | '\'');
                let inside = rest.get(1..).filter(|_| quoted);
                let close = inside.and_then(|inside| inside.find([first, '\n']));
                let after = close.map_or(0, |close| close + 2).min(rest.len());
                let after = if rest.is_char_boundary(after) {
                    after
                } else {
                    0
                };
                let sign = rest.get(after..).unwrap_or("").find(['=', '\n', '}']);
                let Some(sign) = sign.map(|sign| sign + after) else {
                    return Some(Spot::Key);
                };
                let key = rest.get(..sign).unwrap_or("").trim();
                let key = key.trim_matches(['"', '\'']).to_owned();
                let found = rest.get(sign..).and_then(|rest| rest.chars().next());
                match found {
                    Some('=') => {
                        self.at += sign + 1;
                        self.keys.push(key);
                        self.value()
                    }
                    // Half a key at the end of a table.
                    Some('}') if !is_top => {
                        self.at += sign;
                        None
                    }
                    _ => {
                        self.at += sign + 1;
                        None
                    }
                }
            }
        }
    }

    /// Reads the head of a table.
    fn header(&mut self) -> Option<Spot> {
        let begin = self.at;
        let rest = self.rest();
        let (line, ends) = match rest.split_once('\n') {
            Some((line, _)) => (line.to_owned(), true),
            None => (rest.to_owned(), false),
        };
        let closed = line.trim_end().ends_with(']');
        let names = line.split('#').next().unwrap_or("");
        let names = names.trim().trim_matches(['[', ']']).split('.');
        let names: Vec<String> = names
            .map(|name| name.trim().trim_matches(['"', '\'']).to_owned())
            .collect();
        if line.starts_with("[[") {
            self.entry = Some(begin);
        } else if names.first() != self.head.first() {
            // `[claim.symbols]` belongs to the claim above it.
            self.entry = None;
        }
        self.head = names;
        self.keys.clear();
        self.at += line.len() + usize::from(ends);
        (!ends && !closed).then_some(Spot::Header)
    }

    /// Reads a value, or an item of a list.
    fn value(&mut self) -> Option<Spot> {
        let in_list = self.frames.last() == Some(&Frame::List);
        if in_list {
            if let Some(comment) = self.blanks() {
                return Some(comment);
            }
        } else {
            let rest = self.rest();
            self.at += rest.len() - rest.trim_start_matches([' ', '\t']).len();
        }
        let rest = self.rest();
        match rest.chars().next() {
            None => return Some(Spot::Value),
            Some('\n') => {}
            Some('[') => {
                self.at += 1;
                self.frames.push(Frame::List);
                return None;
            }
            Some('{') => {
                self.at += 1;
                self.frames.push(Frame::Table);
                return None;
            }
            Some(']') if in_list => {
                self.at += 1;
                self.frames.pop();
            }
            Some('"' | '\'') => {
                if let Some(text) = self.text() {
                    return Some(text);
                }
            }
            Some(_) => {
                let length = rest.find([',', ']', '}', '\n', '#']);
                let Some(length) = length else {
                    return Some(Spot::Value);
                };
                let closes_nothing = length == 0 && (in_list || rest.starts_with(']'));
                self.at += if closes_nothing { 1 } else { length };
            }
        }
        self.value_ends();
        None
    }

    /// Reads a text in quotes.
    fn text(&mut self) -> Option<Spot> {
        let rest = self.rest();
        let long = ["\"\"\"", "'''"]
            .into_iter()
            .find(|quotes| rest.starts_with(quotes));
        let quotes = long.or_else(|| rest.get(..1)).unwrap_or("'");
        let escapes = quotes.starts_with('"');
        let start = self.at + quotes.len();
        let mut from = quotes.len();
        loop {
            let tail = rest.get(from..).unwrap_or("");
            let close = tail.find(quotes);
            let line = tail.find('\n').filter(|_| long.is_none());
            let escape = tail.find('\\').filter(|_| escapes);
            match (close, line, escape) {
                (close, line, Some(escape))
                    if close.is_none_or(|close| escape < close)
                        && line.is_none_or(|line| escape < line) =>
                {
                    let escaped = tail.get(escape + 1..).and_then(|tail| tail.chars().next());
                    from += escape + 1 + escaped.map_or(0, char::len_utf8);
                }
                (Some(close), line, _) if line.is_none_or(|line| close < line) => {
                    self.at += from + close + quotes.len();
                    return None;
                }
                // A text that was left open ends with its line.
                (_, Some(line), _) => {
                    self.at += from + line;
                    return None;
                }
                _ => return Some(Spot::Text { start }),
            }
        }
    }

    /// The key whose value ended is left, unless the value is an item of a list.
    fn value_ends(&mut self) {
        if self.frames.last() != Some(&Frame::List) {
            self.keys.pop();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The place of the bar in a text, which is left out.
    fn at(text: &str) -> (Vec<String>, Spot) {
        let place = text.find('|').unwrap_or(text.len());
        let found = cursor(&text.replacen('|', "", 1), place);
        (found.path, found.spot)
    }

    fn path(text: &str) -> String {
        let (path, spot) = at(text);
        let spot = match spot {
            Spot::Header => "header",
            Spot::Key => "key",
            Spot::Value => "value",
            Spot::Text { .. } => "text",
            Spot::Comment => "comment",
        };
        format!("{} {spot}", path.join("/"))
    }

    #[test]
    fn a_place_has_the_heads_and_keys_that_lead_to_it() {
        for (text, wanted) in [
            ("|", " key"),
            ("[sym|", "sym header"),
            ("[symbols]\nx = { in = '[0,| 1]' }", "symbols/x/in text"),
            ("[symbols]\nx = { in = '[0, 1]', | }", "symbols/x key"),
            ("[symbols]\nx = { in = '[0, 1]' }\n|", "symbols key"),
            ("[[claim]]\nid = 'p/1'\nsta|", "claim key"),
            ("[[claim]]\nstates = 'x ==| 1'", "claim/states text"),
            ("[[claim]]\nstates = |", "claim/states value"),
            (
                "[[claim]]\nassume = ['a > 0', 'b| > 0']",
                "claim/assume text",
            ),
            (
                "[[claim]]\nassume = [\n  'a > 0', # why\n  { states = 'b|' }]",
                "claim/assume/states text",
            ),
            ("[[claim]]\nassume = ['a']\nkind = 'id|'", "claim/kind text"),
            (
                "[[claim]]\nprinted = '''two\nlines '' |'''",
                "claim/printed text",
            ),
            ("[[claim]]\nstates = \"F'(0) == \\\"|", "claim/states text"),
            ("[[claim]]\n[claim.symbols]\nx = {|", "claim/symbols/x key"),
            ("[define]\n\"F(z)\" = 'z|'", "define/F(z) text"),
            ("[define]\na = '2' # some|", "define comment"),
            ("[[claim]]\nuses = [\n|", "claim/uses value"),
        ] {
            assert_eq!(path(text), wanted, "{text}");
        }
    }

    #[test]
    fn what_was_left_open_ends_with_its_line() {
        for (text, wanted) in [
            (
                "[[claim]]\nstates = 'x == 1\nkind = 'a|'",
                "claim/kind text",
            ),
            ("[[claim]]\nstates =\nkind = 'a|'", "claim/kind text"),
            ("[[claim]]\nsta\nkind = 'a|'", "claim/kind text"),
            ("[[claim]\nkind = 'a|'", "claim/kind text"),
        ] {
            assert_eq!(path(text), wanted, "{text}");
        }
    }

    proptest! {
        #[test]
        fn every_place_of_every_text_has_an_answer(
            text in "([\\[\\]{}='\"#,\\\\\n.a ]|'''|\\[\\[claim\\]\\]\n|é|𝜇){0,40}",
            place in 0usize..200,
        ) {
            let found = cursor(&text, place);
            if let Spot::Text { start } = found.spot {
                prop_assert!(start <= text.len() && text.is_char_boundary(start));
            }
        }
    }
}
