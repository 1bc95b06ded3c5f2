//! What the letters of a formula stand for: names with their kinds, and how they are printed.
//!
//! A name with a printed form (a display) is only what looks like that form: its letter with its scripts; the sign `\cdot` in
//! a script of a display is the place of an index. Other names are read by one rule: the letter, or the word, with
//! its subscript behind it: `\beta_1` is `beta1` or `beta_1`, `\hat x` is `x_hat`.

use super::error::LatexError;
use super::item::{Nucleus, TexFace, TexItem, look_alike, nucleus_signature};
use super::layout::layout;
use std::collections::BTreeMap;

/// What a name is, as far as reading depends on it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum LatexKind {
    /// A number.
    Number,
    /// A vector.
    Vector,
    /// A matrix.
    Matrix,
    /// A family with so many indices.
    Family {
        /// The number of indices.
        indices: usize,
        /// Whether its members are vectors.
        is_vector: bool,
    },
    /// A function.
    Function {
        /// The names of its parameters; a smooth function has one without a name.
        parameters: Vec<String>,
        /// Whether its values are vectors.
        is_vector: bool,
    },
    /// A basis; its functions have an index and a degree.
    Basis {
        /// The degree, of a basis that has only one.
        degree: Option<u8>,
        /// Its variable.
        variable: String,
    },
    /// A number or a function: nothing says which.
    Open,
    /// The letter e as a number, or as the base of the exponential function: nothing says which.
    NumberOrBase,
}

/// The names of a formula.
#[derive(Debug, Clone, Default)]
pub struct LatexNames {
    kinds: BTreeMap<String, LatexKind>,
    displays: Vec<(TexItem, String)>,
    printed: BTreeMap<String, String>,
}

/// A name as it was found in a formula.
#[derive(Debug, Clone)]
pub(super) struct FoundName<'i> {
    pub name: String,
    pub kind: LatexKind,
    /// The parts of the scripts that are not of the name.
    pub below: Vec<&'i [TexItem]>,
    pub above: Option<&'i [TexItem]>,
    pub primes: usize,
}

/// The parts of a list between commas.
#[must_use]
pub fn parts(list: &[TexItem]) -> Vec<&[TexItem]> {
    list.split(|item| item.is_sign(",")).collect()
}

impl LatexNames {
    /// Adds or replaces a name.
    pub fn declare(&mut self, name: &str, kind: LatexKind) {
        self.kinds.insert(name.to_owned(), kind);
    }

    /// Says how a name is printed, in LaTeX without dollar signs. A form of several letters side by side is no name's.
    pub fn display(&mut self, name: &str, printed: &str) {
        if let Ok(list) = layout(printed)
            && let [item] = list.as_slice()
        {
            self.displays.retain(|(_, other)| other != name);
            self.displays.push((item.clone(), name.to_owned()));
            self.printed.insert(name.to_owned(), printed.to_owned());
        }
    }

    /// The kind of a name.
    #[must_use]
    pub fn kind(&self, name: &str) -> Option<&LatexKind> {
        self.kinds.get(name)
    }

    /// All names with their kinds.
    pub fn kinds(&self) -> impl Iterator<Item = (&str, &LatexKind)> {
        self.kinds.iter().map(|(name, kind)| (name.as_str(), kind))
    }

    /// How a name is printed, in LaTeX, if [`Self::display`] says so.
    #[must_use]
    pub fn printed(&self, name: &str) -> Option<&str> {
        self.printed.get(name).map(String::as_str)
    }

    /// The name that an item shows.
    pub(super) fn find<'i>(&self, item: &'i TexItem) -> Result<FoundName<'i>, LatexError> {
        let mut best: Option<(usize, FoundName<'i>)> = None;
        for (shape, name) in &self.displays {
            let Some((score, found)) = self.shown(shape, name, item) else {
                continue;
            };
            match &best {
                Some((other, before)) if *other == score && before.name != found.name => {
                    let message = format!(
                        "this is printed for `{}` and for `{}`",
                        before.name, found.name
                    );
                    return Err(LatexError::new(item.place, message));
                }
                Some((other, _)) if *other >= score => {}
                _ => best = Some((score, found)),
            }
        }
        if let Some((score, found)) = best {
            // A longer name by rule, `r_0` beside a display for `r`, is as good.
            if score > 0
                || found.below.is_empty()
                || self
                    .by_rule(item)?
                    .is_none_or(|other| other.below.len() >= found.below.len())
            {
                return Ok(found);
            }
        }
        match self.by_rule(item)? {
            Some(found) => Ok(found),
            None => {
                let (letters, _) = spelled(item)?;
                let message = format!("`{letters}` is not declared");
                Err(LatexError::new(item.place, message)
                    .with_help("declare it, or say with [display] which name is printed like this"))
            }
        }
    }

    /// The name with a display that this item shows, with the number of parts of scripts that belong to it.
    fn shown<'i>(
        &self,
        shape: &TexItem,
        name: &str,
        item: &'i TexItem,
    ) -> Option<(usize, FoundName<'i>)> {
        let kind = self.kinds.get(name)?.clone();
        if nucleus_signature(&shape.nucleus) != nucleus_signature(&item.nucleus) {
            return None;
        }
        let primes = item.primes.checked_sub(shape.primes)?;
        let (mut score, mut below) = (shape.primes, vec![]);
        let mut own = item
            .below
            .as_deref()
            .map(parts)
            .unwrap_or_default()
            .into_iter();
        for wanted in shape.below.as_deref().map(parts).unwrap_or_default() {
            let part = own.next()?;
            score += 1;
            match is_place(wanted) {
                true => below.push(part),
                false if look_alike(wanted, part) => {}
                false => return None,
            }
        }
        below.extend(own);
        let above = match (shape.above.as_deref(), item.above.as_deref()) {
            (None, above) => above,
            (Some(wanted), Some(own)) if look_alike(wanted, own) => {
                score += 1;
                None
            }
            (Some(wanted), Some(own)) if is_place(wanted) => {
                score += 1;
                below.push(own);
                None
            }
            _ => return None,
        };
        let name = name.to_owned();
        Some((
            score,
            FoundName {
                name,
                kind,
                below,
                above,
                primes,
            },
        ))
    }

    /// The declared name without a display that this item is by the rule.
    fn by_rule<'i>(&self, item: &'i TexItem) -> Result<Option<FoundName<'i>>, LatexError> {
        let (letters, is_bold) = spelled(item)?;
        let below = item.below.as_deref().map(parts).unwrap_or_default();
        // A name with its subscript in it, and a name that takes the subscript for an index.
        let mut spellings = vec![(letters.clone(), below.clone())];
        if let Some(words) = script_words(&below) {
            spellings.push((format!("{letters}_{}", words.join("_")), vec![]));
            if let [word] = words.as_slice() {
                spellings.push((format!("{letters}{word}"), vec![]));
            }
        }
        let mut found: Vec<FoundName<'i>> = vec![];
        for (name, below) in spellings {
            let primed = format!("{name}{}", "'".repeat(item.primes));
            let (name, primes) = match item.primes > 0 && self.kinds.contains_key(&primed) {
                true => (primed, 0),
                false => (name, item.primes),
            };
            if self.displays.iter().any(|(_, other)| *other == name) {
                continue;
            }
            if let Some(kind) = self.kinds.get(&name) {
                let (kind, above) = (kind.clone(), item.above.as_deref());
                found.push(FoundName {
                    name,
                    kind,
                    below,
                    above,
                    primes,
                });
            }
        }
        // A letter that takes no index is no other reading of a letter with one.
        if found.len() > 1 {
            found.retain(|found| found.below.is_empty() || takes(&found.kind, &found.below));
        }
        if let [first, second, ..] = found.as_slice() {
            let message = format!("this may be `{}` or `{}`", first.name, second.name);
            return Err(LatexError::new(item.place, message)
                .with_help("say with [display] how each is printed"));
        }
        let found = found.pop();
        if let Some(found) = &found
            && is_bold
            && matches!(
                found.kind,
                LatexKind::Number
                    | LatexKind::Basis { .. }
                    | LatexKind::Open
                    | LatexKind::NumberOrBase
            )
        {
            let message = format!(
                "this is printed as a vector, and `{}` is a number",
                found.name
            );
            return Err(LatexError::new(item.place, message));
        }
        Ok(found)
    }
}

/// Whether a name of this kind can take these subscripts.
fn takes(kind: &LatexKind, below: &[&[TexItem]]) -> bool {
    let letters = |part: &[TexItem], parameters: &[String]| {
        part.iter().all(|item| matches!(&item.nucleus, Nucleus::Letter(letters, _) if parameters.contains(letters)))
    };
    match kind {
        LatexKind::Number | LatexKind::Open | LatexKind::NumberOrBase => false,
        LatexKind::Function { parameters, .. } => {
            below.iter().all(|part| letters(part, parameters))
        }
        _ => true,
    }
}

/// Whether a part of a script is the place of an index.
fn is_place(part: &[TexItem]) -> bool {
    matches!(part, [only] if only.is_sign("cdot"))
}

/// The letters of an item as they are spelled in a name, and whether they are bold.
pub(super) fn spelled(item: &TexItem) -> Result<(String, bool), LatexError> {
    let unread = |what: &str| {
        let message = format!("a letter {what} has no name by rule");
        LatexError::new(item.place, message)
            .with_help("say with [display] which name is printed like this")
    };
    let Nucleus::Letter(letters, face) = &item.nucleus else {
        return Err(LatexError::new(item.place, "this is no name"));
    };
    match face {
        TexFace::Plain => Ok((letters.clone(), false)),
        TexFace::Bold => Ok((letters.clone(), true)),
        TexFace::Other(name) if name == "mathrm" => Ok((letters.clone(), false)),
        TexFace::Accent(sign, inner) if matches!(**inner, TexFace::Plain | TexFace::Bold) => {
            Ok((format!("{letters}_{sign}"), **inner == TexFace::Bold))
        }
        TexFace::Other(_) | TexFace::Accent(..) => Err(unread("in this face")),
    }
}

/// The parts of a subscript as words of a name, if all are.
pub(super) fn script_words(below: &[&[TexItem]]) -> Option<Vec<String>> {
    let word = |part: &&[TexItem]| -> Option<String> {
        let letters = part.iter().map(|item| match &item.nucleus {
            _ if !item.is_bare() => None,
            Nucleus::Number(digits) if !digits.contains('.') => Some(digits.clone()),
            Nucleus::Letter(letters, TexFace::Plain | TexFace::Bold) => Some(letters.clone()),
            Nucleus::Letter(letters, TexFace::Other(face)) if face == "mathrm" => {
                Some(letters.clone())
            }
            Nucleus::Words(words) | Nucleus::Operator(words)
                if words.chars().all(|c| c.is_ascii_alphanumeric()) =>
            {
                Some(words.clone())
            }
            _ => None,
        });
        letters
            .collect::<Option<Vec<String>>>()
            .map(|words| words.concat())
            .filter(|word| !word.is_empty())
    };
    if below.is_empty() {
        return None;
    }
    below.iter().map(word).collect()
}
