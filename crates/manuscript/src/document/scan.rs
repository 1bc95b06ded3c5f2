//! One pass over a manuscript: its text, theorems and formulas in order.

use super::arguments::{argument, end_of, option, without_labels};
use super::cases::by_members;
use super::rows::{Rows, goes_on, joined};
use super::{Manuscript, ManuscriptFormula, ManuscriptItem};
use crate::linear::linear;
use crate::numbering::Numbering;
use crate::words::{command_text, plain, tidy, typed};
use std::collections::BTreeMap;
use torse_syntax::formula::Place;
use torse_syntax::latex::item::TexItem;
use torse_syntax::latex::token::{PlacedTex, TexToken};
use torse_syntax::latex::{layout_tokens, without_final_punctuation};

/// Environments of displayed mathematics.
const DISPLAYS: [(&str, Rows); 10] = [
    ("equation", Rows::Lines),
    ("multline", Rows::Lines),
    ("displaymath", Rows::Lines),
    ("math", Rows::Lines),
    ("align", Rows::Aligned),
    ("gather", Rows::EachAlone),
    ("eqnarray", Rows::Aligned),
    ("flalign", Rows::Aligned),
    ("alignat", Rows::Aligned),
    ("IEEEeqnarray", Rows::Aligned),
];

/// The largest depth of environments.
const MAX_ENVIRONMENTS: usize = 40;

/// Environments and formulas without an end, of which each costs a search, are followed up to so many.
const MAX_UNCLOSED: usize = 100;

/// A reference in a text, between two of these signs, until all numbers are known.
const MARK: char = '\u{1}';

pub(super) struct Scan {
    pub manuscript: Manuscript,
    pub numbering: Numbering,
    pub section: String,
    /// What references to labels print.
    pub labels: BTreeMap<String, String>,
    /// The theorem around.
    pub theorem: Option<usize>,
    pub depth: usize,
    /// How many environments and formulas had no end.
    pub unclosed: usize,
}

impl Scan {
    fn not_followed(&mut self, place: Place, why: &str) {
        self.manuscript.unread.push((place, why.to_owned()));
    }

    /// Reads tokens; returns their words and formulas on one line.
    pub(super) fn text(&mut self, tokens: &[PlacedTex]) -> String {
        if self.depth >= MAX_ENVIRONMENTS {
            let place = tokens.first().map_or(Place::default(), |token| token.place);
            self.not_followed(place, "environments are nested too deeply");
            return String::new();
        }
        self.depth += 1;
        let mut words = String::new();
        let mut at = 0;
        while let Some(token) = tokens.get(at) {
            let place = token.place;
            at += 1;
            match &token.token {
                TexToken::Character('$') => {
                    let double = tokens.get(at).is_some_and(|next| next.is('$'));
                    at += usize::from(double);
                    let rest = tokens.get(at..).unwrap_or(&[]);
                    let Some(length) = rest.iter().position(|token| token.is('$')) else {
                        self.not_followed(place, "this dollar sign has no partner");
                        continue;
                    };
                    let inner = rest.get(..length).unwrap_or(&[]);
                    at += length + 1 + usize::from(double);
                    words.push_str(&self.formula(inner, place, double));
                }
                TexToken::Character('{' | '}') => {}
                TexToken::Character('~') => words.push(' '),
                TexToken::Character(sign) => words.push(*sign),
                TexToken::Command(name) => at = self.command(tokens, at, name, place, &mut words),
            }
        }
        self.depth -= 1;
        words
    }

    /// Reads a command of the text and returns where the text goes on.
    fn command(
        &mut self,
        tokens: &[PlacedTex],
        at: usize,
        name: &str,
        place: Place,
        words: &mut String,
    ) -> usize {
        let bare = name.trim_end_matches('*');
        let after_option = || option(tokens, at).map_or(at, |(_, end)| end);
        let argument_here = || argument(tokens, at);
        match bare {
            "(" | "[" => {
                let close = if bare == "(" { ")" } else { "]" };
                let rest = tokens.get(at..).unwrap_or(&[]);
                let end = || rest.iter().position(|token| token.command() == Some(close));
                let Some(length) = (self.unclosed < MAX_UNCLOSED).then(end).flatten() else {
                    self.unclosed += 1;
                    self.not_followed(place, "this formula is never closed");
                    return at;
                };
                words.push_str(&self.formula(
                    rest.get(..length).unwrap_or(&[]),
                    place,
                    bare == "[",
                ));
                return at + length + 1;
            }
            "begin" => return self.environment(tokens, at, place, words),
            "title" | "author" | "section" | "subsection" | "subsubsection" => {
                let Some((inner, end)) = argument(tokens, after_option()) else {
                    return at;
                };
                match bare {
                    "title" => self.manuscript.title = plain(inner),
                    "author" => {
                        let names = plain(inner);
                        let authors = &mut self.manuscript.authors;
                        *authors = if authors.is_empty() {
                            names
                        } else {
                            format!("{authors}, {names}")
                        };
                    }
                    _ if name.ends_with('*') => {}
                    _ => {
                        let level = ["section", "subsection", "subsubsection"]
                            .iter()
                            .position(|own| *own == bare)
                            .unwrap_or(0);
                        self.section = self.numbering.section(level);
                    }
                }
                return end;
            }
            "appendix" => self.numbering.appendix(),
            "newtheorem" => return self.new_theorem(tokens, at, !name.ends_with('*')),
            "numberwithin" | "counterwithin" => {
                if let Some((counter, end)) = argument_here() {
                    self.numbering.count_within_section(&plain(counter));
                    return argument(tokens, end).map_or(end, |(_, end)| end);
                }
            }
            "label" => {
                if let Some((label, end)) = argument_here() {
                    let label = plain(label);
                    let current = match self
                        .theorem
                        .and_then(|theorem| self.manuscript.items.get_mut(theorem))
                    {
                        Some(item) => {
                            item.label.get_or_insert_with(|| label.clone());
                            item.number.clone().unwrap_or_default()
                        }
                        None => self.section.clone(),
                    };
                    self.labels.insert(label, current);
                    return end;
                }
            }
            "ref" | "eqref" | "cref" | "Cref" | "autoref" => {
                if let Some((label, end)) = argument_here() {
                    let label = plain(label);
                    match bare {
                        "eqref" => words.push_str(&format!("({MARK}{label}{MARK})")),
                        _ => words.push_str(&format!("{MARK}{label}{MARK}")),
                    }
                    return end;
                }
            }
            "cite" | "citep" | "citet" => {
                if let Some((key, end)) = argument(tokens, after_option()) {
                    words.push_str(&format!("[{}]", plain(key)));
                    return end;
                }
            }
            "input" | "include" | "subfile" => {
                self.not_followed(
                    place,
                    "files that the text includes are not read: put them into it",
                );
                return argument_here().map_or(at, |(_, end)| end);
            }
            "documentclass" | "usepackage" | "bibliographystyle" | "bibliography" | "pagestyle"
            | "thispagestyle" | "email" | "affil" | "address" | "thanks" | "footnote" | "date"
            | "includegraphics" | "vspace" | "hspace" | "setlength" | "theoremstyle" | "index" => {
                return argument(tokens, after_option()).map_or(at, |(_, end)| end);
            }
            _ => words.push_str(command_text(name)),
        }
        at
    }

    fn new_theorem(&mut self, tokens: &[PlacedTex], at: usize, numbered: bool) -> usize {
        let Some((environment, end)) = argument(tokens, at) else {
            return at;
        };
        let (shared, end) = match option(tokens, end) {
            Some((shared, end)) => (Some(plain(shared)), end),
            None => (None, end),
        };
        let Some((title, end)) = argument(tokens, end) else {
            return end;
        };
        let (within, end) = match option(tokens, end) {
            Some((_, end)) => (true, end),
            None => (false, end),
        };
        self.numbering.declare(
            &plain(environment),
            &plain(title),
            shared.as_deref(),
            within,
            numbered,
        );
        end
    }

    /// Reads an environment and returns where the text goes on.
    fn environment(
        &mut self,
        tokens: &[PlacedTex],
        at: usize,
        place: Place,
        words: &mut String,
    ) -> usize {
        let Some((name, start)) = argument(tokens, at) else {
            return at;
        };
        let name = plain(name);
        let end = || end_of(tokens, start, &name);
        let Some((end, after)) = (self.unclosed < MAX_UNCLOSED).then(end).flatten() else {
            self.unclosed += 1;
            if name != "document" {
                self.not_followed(place, &format!("the environment `{name}` is never closed"));
            }
            return start;
        };
        let inner = tokens.get(start..end).unwrap_or(&[]);
        let bare = name.trim_end_matches('*');
        if let Some((_, rows)) = DISPLAYS.into_iter().find(|(display, _)| *display == bare) {
            let inner = match bare {
                "alignat" | "IEEEeqnarray" => argument(inner, 0)
                    .and_then(|(_, start)| inner.get(start..))
                    .unwrap_or(inner),
                _ => inner,
            };
            let numbered = !name.ends_with('*') && !matches!(bare, "displaymath" | "math");
            words.push_str(&self.display(inner, place, rows, numbered));
        } else if let Some(kind) = self.numbering.theorem(&name) {
            let number = kind
                .counter
                .as_deref()
                .map(|counter| self.numbering.count(counter));
            let (note, start) = match option(inner, 0) {
                Some((note, start)) => (plain(note), start),
                None => (String::new(), 0),
            };
            let item = self.manuscript.items.len();
            self.manuscript.items.push(ManuscriptItem {
                kind: kind.title,
                number,
                section: self.section.clone(),
                label: None,
                printed: String::new(),
                place: place.to(tokens.get(end).map_or(place, |token| token.place)),
                formulas: vec![],
            });
            let outer = self.theorem.replace(item);
            let text = self.text(inner.get(start..).unwrap_or(&[]));
            self.theorem = outer;
            let printed = if note.is_empty() {
                text
            } else {
                format!("({note}) {text}")
            };
            words.push_str(&printed);
            if let Some(item) = self.manuscript.items.get_mut(item) {
                item.printed = printed;
            }
        } else if matches!(
            bare,
            "verbatim" | "lstlisting" | "thebibliography" | "tikzpicture" | "comment"
        ) {
            // No statements stand here.
        } else {
            words.push_str(&self.text(inner));
        }
        match bare {
            // What stands behind is not typeset.
            "document" => tokens.len(),
            _ => after,
        }
    }

    /// Reads displayed mathematics, in which a formula may have several rows.
    fn display(&mut self, inner: &[PlacedTex], place: Place, rows: Rows, numbered: bool) -> String {
        let mut lines: Vec<Vec<PlacedTex>> = vec![vec![]];
        let mut depth = 0_usize;
        for token in inner {
            match token.command() {
                Some("begin") => depth += 1,
                Some("end") => depth = depth.saturating_sub(1),
                Some("\\" | "\\*") if depth == 0 && rows != Rows::Lines => {
                    lines.push(vec![]);
                    continue;
                }
                _ => {}
            }
            if let Some(line) = lines.last_mut() {
                line.push(token.clone());
            }
        }
        let mut groups: Vec<Vec<Vec<PlacedTex>>> = vec![];
        for line in lines {
            match groups.last_mut() {
                Some(before) if goes_on(before, &line, rows) => before.push(line),
                _ => groups.push(vec![line]),
            }
        }
        let mut words = String::new();
        for rows in groups {
            if rows.iter().flatten().all(|token| token.is(' ')) {
                continue;
            }
            let (number, label) = self.numbered(&rows, numbered);
            let group = joined(&rows);
            let place = match (group.first(), group.last()) {
                (Some(first), Some(last)) => first.place.to(last.place),
                _ => place,
            };
            let position = self.manuscript.formulas.len();
            let printed = self.formula(&group, place, true);
            if number.is_some() {
                self.manuscript.items.push(ManuscriptItem {
                    kind: "equation".to_owned(),
                    number,
                    section: self.section.clone(),
                    label,
                    printed: printed.trim().to_owned(),
                    place,
                    formulas: vec![position],
                });
            }
            words.push_str(&printed);
        }
        words
    }

    /// Counts the rows of a formula as LaTeX does, each without `\nonumber`; returns the first number and the first label.
    fn numbered(
        &mut self,
        rows: &[Vec<PlacedTex>],
        numbered: bool,
    ) -> (Option<String>, Option<String>) {
        let (mut first, mut first_label) = (None, None);
        for row in rows {
            let behind = |names: &[&str]| {
                row.iter()
                    .position(|token| token.command().is_some_and(|name| names.contains(&name)))
                    .and_then(|at| argument(row, at + 1))
                    .map(|(text, _)| plain(text))
            };
            let silent = row
                .iter()
                .any(|token| matches!(token.command(), Some("nonumber" | "notag")));
            let number = match behind(&["tag", "tag*"]) {
                Some(tag) => Some(tag),
                None if numbered && !silent => Some(self.numbering.count("equation")),
                None => None,
            };
            let label = behind(&["label"]);
            if let (Some(label), Some(number)) = (&label, &number) {
                self.labels.insert(label.clone(), number.clone());
            }
            first = first.or(number);
            first_label = first_label.or(label);
        }
        (first, first_label)
    }

    /// Adds a formula and returns it on one line.
    fn formula(&mut self, tokens: &[PlacedTex], place: Place, is_display: bool) -> String {
        let shown = without_labels(tokens);
        let end = shown.last().map_or(place, |token| Place {
            start: token.place.end,
            end: token.place.end,
        });
        let place = match (shown.first(), shown.last()) {
            (Some(first), Some(last)) => first.place.to(last.place),
            _ => place,
        };
        let items = layout_tokens(&shown, end);
        let latex = typed(&shown);
        let bare = items.map(without_final_punctuation);
        let shown = |items: &Vec<TexItem>| linear(items);
        let (line, items) = (bare.as_ref().map_or_else(|_| latex.clone(), shown), bare);
        if let Some(item) = self
            .theorem
            .and_then(|theorem| self.manuscript.items.get_mut(theorem))
        {
            item.formulas.push(self.manuscript.formulas.len());
        }
        self.manuscript.formulas.push(ManuscriptFormula {
            latex,
            items: items.map(by_members),
            place,
            is_display,
            in_theorem: self
                .theorem
                .and_then(|theorem| self.manuscript.items.get(theorem))
                .is_some_and(|item| item.kind != "Definition"),
        });
        match is_display {
            true => format!(" {line} "),
            false => line,
        }
    }

    /// Puts numbers in the place of references.
    pub(super) fn finished(self) -> Manuscript {
        let Self {
            mut manuscript,
            labels,
            ..
        } = self;
        for item in &mut manuscript.items {
            let mut text = String::new();
            for (at, piece) in item.printed.split(MARK).enumerate() {
                match labels.get(piece).filter(|_| at % 2 == 1) {
                    Some(number) => text.push_str(number),
                    None if at % 2 == 1 => text.push_str("??"),
                    None => text.push_str(piece),
                }
            }
            item.printed = tidy(&text);
        }
        manuscript
    }
}
