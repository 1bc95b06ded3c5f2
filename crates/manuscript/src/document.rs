//! A manuscript taken apart: its sections, theorems, numbered equations and formulas, in their order.

use crate::linear::linear;
use crate::macros::{ManuscriptError, Unread, expanded};
use crate::numbering::Numbering;
use crate::words::{command_text, plain, tidy, typed};
use std::collections::BTreeMap;
use torse_syntax::formula::Place;
use torse_syntax::latex::item::TexItem;
use torse_syntax::latex::token::{PlacedTex, TexToken, tex_tokens};
use torse_syntax::latex::{LatexError, layout_tokens, without_final_punctuation};

/// A formula of the text.
#[derive(Debug, Clone)]
pub struct ManuscriptFormula {
    /// The formula in LaTeX, with its macros expanded.
    pub latex: String,
    /// Its items, or why it has none.
    pub items: Result<Vec<TexItem>, LatexError>,
    /// Its place in the text.
    pub place: Place,
    /// Whether it stands on lines of its own.
    pub is_display: bool,
    /// Whether it stands in a theorem.
    pub in_theorem: bool,
}

/// A numbered equation, or something like a theorem.
#[derive(Debug, Clone)]
pub struct ManuscriptItem {
    /// `equation`, or the title of the environment, such as `Theorem`.
    pub kind: String,
    /// Its number, if it has one.
    pub number: Option<String>,
    /// The number of its section; empty before the first one.
    pub section: String,
    /// Its label, if it has one.
    pub label: Option<String>,
    /// What the text says, formulas on one line.
    pub printed: String,
    /// Its place in the text.
    pub place: Place,
    /// The positions of its formulas in [`Manuscript::formulas`].
    pub formulas: Vec<usize>,
}

/// A manuscript.
#[derive(Debug, Clone, Default)]
pub struct Manuscript {
    /// The whole text.
    pub text: String,
    /// The title; empty if there is none.
    pub title: String,
    /// The authors; empty if there are none.
    pub authors: String,
    /// All formulas, in their order.
    pub formulas: Vec<ManuscriptFormula>,
    /// Numbered equations and theorems, in their order.
    pub items: Vec<ManuscriptItem>,
    /// What of the text is not followed: files that it includes, definitions that are not understood.
    pub unread: Vec<Unread>,
}

impl Manuscript {
    /// The line and the column of a byte of the text, both from 1.
    #[must_use]
    pub fn line_and_column(&self, byte: usize) -> (usize, usize) {
        let before = self
            .text
            .get(..byte.min(self.text.len()))
            .unwrap_or(&self.text);
        let line = before.matches('\n').count() + 1;
        let column = before.rsplit('\n').next().unwrap_or("").chars().count() + 1;
        (line, column)
    }
}

/// Environments of displayed mathematics; those in which each row has a number are marked.
const DISPLAYS: [(&str, bool); 9] = [
    ("equation", false),
    ("multline", false),
    ("displaymath", false),
    ("math", false),
    ("align", true),
    ("gather", true),
    ("eqnarray", true),
    ("flalign", true),
    ("alignat", true),
];

/// The largest depth of environments.
const MAX_ENVIRONMENTS: usize = 40;

/// The largest number of tokens of an optional argument.
const MAX_OPTION: usize = 1_000;

/// Environments and formulas without an end, of which each costs a search, are followed up to so many.
const MAX_UNCLOSED: usize = 100;

/// A reference in a text, between two of these signs, until all numbers are known.
const MARK: char = '\u{1}';

/// Reads a manuscript.
///
/// # Errors
/// [`ManuscriptError`] if macros do not come to an end, or the text is too long. What is not understood is no error:
/// it is listed.
pub fn manuscript(text: &str) -> Result<Manuscript, ManuscriptError> {
    let (tokens, all) = tex_tokens(text);
    if !all {
        return Err(ManuscriptError::TooLong);
    }
    let (tokens, unread) = expanded(tokens)?;
    let (tokens, mut unbalanced) = balanced(tokens);
    unbalanced.extend(unread);
    let mut scan = Scan {
        manuscript: Manuscript {
            text: text.to_owned(),
            unread: unbalanced,
            ..Manuscript::default()
        },
        unclosed: 0,
        numbering: Numbering::default(),
        section: String::new(),
        labels: BTreeMap::new(),
        theorem: None,
        depth: 0,
    };
    scan.text(&tokens);
    Ok(scan.finished())
}

struct Scan {
    manuscript: Manuscript,
    numbering: Numbering,
    section: String,
    /// What references to labels print.
    labels: BTreeMap<String, String>,
    /// The theorem around.
    theorem: Option<usize>,
    depth: usize,
    /// How many environments and formulas had no end.
    unclosed: usize,
}

/// Leaves out braces without a partner, and lists the first one.
fn balanced(tokens: Vec<PlacedTex>) -> (Vec<PlacedTex>, Vec<Unread>) {
    let mut open: Vec<usize> = vec![];
    let mut alone: Vec<usize> = vec![];
    for (at, token) in tokens.iter().enumerate() {
        if token.is('{') {
            open.push(at);
        } else if token.is('}') && open.pop().is_none() {
            alone.push(at);
        }
    }
    alone.append(&mut open);
    alone.sort_unstable();
    let first = alone
        .first()
        .and_then(|at| tokens.get(*at))
        .map(|token| (token.place, "this brace has no partner".to_owned()));
    let mut next = alone.into_iter().peekable();
    let kept = tokens
        .into_iter()
        .enumerate()
        .filter(|(at, _)| next.next_if_eq(at).is_none());
    (
        kept.map(|(_, token)| token).collect(),
        first.into_iter().collect(),
    )
}

/// The argument in braces behind a position, and where it ends.
fn argument(tokens: &[PlacedTex], mut at: usize) -> Option<(&[PlacedTex], usize)> {
    while tokens.get(at)?.is(' ') {
        at += 1;
    }
    if !tokens.get(at)?.is('{') {
        return None;
    }
    let (start, mut open) = (at + 1, 0_usize);
    for (end, token) in tokens.iter().enumerate().skip(at) {
        if token.is('{') {
            open += 1;
        } else if token.is('}') {
            open = open.saturating_sub(1);
            if open == 0 {
                return Some((tokens.get(start..end)?, end + 1));
            }
        }
    }
    None
}

/// The optional argument behind a position, and where it ends.
fn option(tokens: &[PlacedTex], mut at: usize) -> Option<(&[PlacedTex], usize)> {
    while tokens.get(at)?.is(' ') {
        at += 1;
    }
    if !tokens.get(at)?.is('[') {
        return None;
    }
    let length = tokens
        .get(at..)?
        .iter()
        .take(MAX_OPTION)
        .position(|token| token.is(']'))?;
    Some((tokens.get(at + 1..at + length)?, at + length + 1))
}

impl Scan {
    fn not_followed(&mut self, place: Place, why: &str) {
        self.manuscript.unread.push((place, why.to_owned()));
    }

    /// Reads tokens; returns their words and formulas on one line.
    fn text(&mut self, tokens: &[PlacedTex]) -> String {
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
                "alignat" => argument(inner, 0)
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
        after
    }

    /// Reads displayed mathematics; rows that begin with a relation go on with the row before.
    fn display(&mut self, inner: &[PlacedTex], place: Place, rows: bool, numbered: bool) -> String {
        let mut lines: Vec<Vec<PlacedTex>> = vec![vec![]];
        let mut depth = 0_usize;
        for token in inner {
            match token.command() {
                Some("begin") => depth += 1,
                Some("end") => depth = depth.saturating_sub(1),
                Some("\\") if depth == 0 && rows => {
                    lines.push(vec![]);
                    continue;
                }
                Some("\\" | "\\*") if depth == 0 => continue,
                _ => {}
            }
            if let Some(line) = lines.last_mut() {
                line.push(token.clone());
            }
        }
        let continues = |line: &Vec<PlacedTex>| {
            let first = line.iter().find(|token| !token.is(' ') && !token.is('&'));
            first.is_some_and(|token| {
                ["=", "+", "-", "<", ">"]
                    .iter()
                    .any(|sign| token.is(sign.chars().next().unwrap_or('=')))
                    || matches!(
                        token.command(),
                        Some(
                            "le" | "leq"
                                | "ge"
                                | "geq"
                                | "ne"
                                | "neq"
                                | "cdot"
                                | "times"
                                | "equiv"
                                | "quad"
                                | "qquad"
                        )
                    )
            })
        };
        let mut groups: Vec<Vec<PlacedTex>> = vec![];
        for line in lines {
            match groups.last_mut() {
                Some(before) if continues(&line) => before.extend(line),
                _ => groups.push(line),
            }
        }
        let mut words = String::new();
        for group in groups {
            if group.iter().all(|token| token.is(' ')) {
                continue;
            }
            let has = |name: &str| group.iter().any(|token| token.command() == Some(name));
            let tag = group
                .iter()
                .position(|token| matches!(token.command(), Some("tag" | "tag*")))
                .and_then(|at| argument(&group, at + 1))
                .map(|(tag, _)| plain(tag));
            let silent = has("nonumber") || has("notag");
            let number = match tag {
                Some(tag) => Some(tag),
                None if numbered && !silent => Some(self.numbering.count("equation")),
                None => None,
            };
            let label = group
                .iter()
                .position(|token| token.command() == Some("label"))
                .and_then(|at| argument(&group, at + 1))
                .map(|(label, _)| plain(label));
            if let (Some(label), Some(number)) = (&label, &number) {
                self.labels.insert(label.clone(), number.clone());
            }
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
            items,
            place,
            is_display,
            in_theorem: self.theorem.is_some(),
        });
        match is_display {
            true => format!(" {line} "),
            false => line,
        }
    }

    /// Puts numbers in the place of references.
    fn finished(self) -> Manuscript {
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

/// A formula without labels, tags and their arguments, and without blanks at its ends.
fn without_labels(tokens: &[PlacedTex]) -> Vec<PlacedTex> {
    let mut shown = vec![];
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        at += 1;
        match token.command() {
            Some("label" | "tag" | "tag*") => at = argument(tokens, at).map_or(at, |(_, end)| end),
            Some("nonumber" | "notag") => {}
            _ => shown.push(token.clone()),
        }
    }
    let blank = |token: &PlacedTex| token.is(' ') || token.command() == Some("par");
    while shown.last().is_some_and(blank) {
        shown.pop();
    }
    let start = shown
        .iter()
        .position(|token| !blank(token))
        .unwrap_or(shown.len());
    shown.split_off(start)
}

/// The position of the `\end` of an environment that began before `start`, and that behind it.
fn end_of(tokens: &[PlacedTex], start: usize, name: &str) -> Option<(usize, usize)> {
    let mut open = 1_usize;
    for (at, token) in tokens.iter().enumerate().skip(start) {
        let (begins, ends) = (
            token.command() == Some("begin"),
            token.command() == Some("end"),
        );
        if !begins && !ends {
            continue;
        }
        let Some((other, after)) = argument(tokens, at + 1) else {
            continue;
        };
        if plain(other) != name {
            continue;
        }
        open = if begins { open + 1 } else { open - 1 };
        if open == 0 {
            return Some((at, after));
        }
    }
    None
}
