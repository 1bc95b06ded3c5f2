//! What a formula declares without stating anything: points, ranges of indices, sets of numbers.
//!
//! | print | declares |
//! |---|---|
//! | `P_0, \dots, P_n`; `P_0, P_1, \dots, P_n \in \mathbb{R}^3`; `\{P_i\}_{i=0}^n` | members 0 to n of a family |
//! | `P_i \in \mathbb{R}^3`, also with `i = 0, \dots, n` behind it | members of a family, with three coordinates |
//! | `P_0, P_1 \in \mathbb{R}^3` | members of a family, with three coordinates, or vectors, where each has a name of its own |
//! | `a, b \in \mathbb{R}^3` | vectors |
//! | `i = 0, \dots, n`; `i = 1, 2, 3`; `i \in \{0, \dots, n\}`; `n \in \mathbb{N}` | integers |
//! | `a, b \in [0, 1]` | numbers of an interval |

use torse_syntax::latex::item::{Nucleus, TexFace, TexItem, nucleus_signature};

/// A list of items.
type List<'i> = &'i [TexItem];

/// A declaration.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Declared<'i> {
    /// Members of a family.
    Points {
        /// A member.
        member: &'i TexItem,
        /// The set, if there is one.
        space: Option<Space>,
        /// The first and the last index, if they are given.
        ends: Option<(List<'i>, List<'i>)>,
    },
    /// Vectors, or members of a family.
    Vectors {
        /// Their letters.
        letters: Vec<&'i TexItem>,
        /// Their set.
        space: Space,
    },
    /// Integers.
    Integers {
        /// Their letters.
        letters: Vec<&'i TexItem>,
        /// The least one.
        low: Least<'i>,
        /// The greatest one, if there is one.
        high: Option<List<'i>>,
    },
    /// Numbers of an interval.
    Reals {
        /// Their letters.
        letters: Vec<&'i TexItem>,
        /// The interval in its brackets; none for all numbers.
        interval: Option<&'i TexItem>,
    },
}

/// The least of some integers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Least<'i> {
    /// As the text says.
    Written(List<'i>),
    /// A number that the name of the set stands for.
    Number(u8),
}

/// A set of vectors, or of numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Space {
    /// With so many coordinates.
    Coordinates(u8),
    /// With a number of coordinates that is a symbol.
    Any,
}

impl Space {
    /// The dimension as derivation files write it.
    pub fn dimension(self) -> String {
        match self {
            Self::Coordinates(count) => count.to_string(),
            Self::Any => "\"any\"".to_owned(),
        }
    }
}

/// The declarations of a formula; none if it says anything else.
pub fn declared(items: List<'_>) -> Option<Vec<Declared<'_>>> {
    let segments = segments(items);
    let mut found = vec![];
    let mut rest = segments.as_slice();
    while !rest.is_empty() {
        let (declaration, taken) = enumeration(rest)
            .or_else(|| members(rest))
            .or_else(|| braced(rest))
            .or_else(|| in_a_set(rest))?;
        found.push(declaration);
        rest = rest.get(taken..)?;
    }
    (!found.is_empty()).then_some(found)
}

/// The parts between commas, wide blanks and words that join; a range in round brackets is one more.
fn segments(items: List<'_>) -> Vec<List<'_>> {
    let separates = |item: &TexItem| match &item.nucleus {
        Nucleus::Sign(sign) => matches!(sign.as_str(), "," | ";" | "quad" | "." | "forall"),
        Nucleus::Words(words) => matches!(
            words.trim().trim_matches(','),
            "" | "for" | "with" | "and" | "where" | "for all"
        ),
        _ => false,
    };
    let mut found = vec![];
    for part in items.split(separates).filter(|part| !part.is_empty()) {
        match part {
            [
                TexItem {
                    nucleus: Nucleus::Fenced('(', inner, ')'),
                    below: None,
                    above: None,
                    ..
                },
            ] if inner.get(1).is_some_and(|next| next.is_sign("=")) => {
                found.extend(segments(inner));
            }
            _ => found.push(part),
        }
    }
    found
}

fn is_dots(list: List<'_>) -> bool {
    matches!(list, [only] if matches!(only.nucleus, Nucleus::Dots))
}

fn relates(list: List<'_>) -> bool {
    list.iter().any(|item| {
        ["=", "in", "le", "ge", "<", ">", "ne"]
            .iter()
            .any(|sign| item.is_sign(sign))
    })
}

fn letter(item: &TexItem) -> Option<&TexItem> {
    let is_letter = matches!(&item.nucleus, Nucleus::Letter(_, TexFace::Plain)) && item.is_bare();
    is_letter.then_some(item)
}

fn number(list: List<'_>) -> Option<u64> {
    match list {
        [only] if only.is_bare() => match &only.nucleus {
            Nucleus::Number(digits) => digits.parse().ok(),
            _ => None,
        },
        _ => None,
    }
}

/// Whether numbers follow one another.
fn is_consecutive(values: &[List<'_>]) -> bool {
    let numbers: Option<Vec<u64>> = values.iter().map(|value| number(value)).collect();
    numbers.is_some_and(|all| {
        all.windows(2)
            .all(|pair| matches!(pair, [a, b] if a + 1 == *b))
    })
}

/// `0, 1, \dots, n` or `0, 1, 2`: the first and the last value, and how many parts these are.
fn values<'i>(first: List<'i>, rest: &[List<'i>]) -> Option<(List<'i>, Option<List<'i>>, usize)> {
    let length = rest
        .iter()
        .position(|part| relates(part))
        .unwrap_or(rest.len());
    let rest = rest.get(..length)?;
    if let Some(at) = rest.iter().take(3).position(|part| is_dots(part)) {
        let before: Vec<List<'_>> = std::iter::once(first)
            .chain(rest.get(..at)?.iter().copied())
            .collect();
        if before.len() > 1 && !is_consecutive(&before) {
            return None;
        }
        let last = rest.get(at + 1).copied();
        return Some((first, last, at + 1 + usize::from(last.is_some())));
    }
    let all: Vec<List<'_>> = std::iter::once(first).chain(rest.iter().copied()).collect();
    (all.len() > 1 && is_consecutive(&all)).then(|| (first, rest.last().copied(), rest.len()))
}

/// `i = 0, \dots, n`.
fn enumeration<'i>(parts: &[List<'i>]) -> Option<(Declared<'i>, usize)> {
    let (first, rest) = parts.split_first()?;
    let (name, equals, low) = match first {
        [name, equals, low @ ..] if !low.is_empty() => (letter(name)?, equals, low),
        _ => return None,
    };
    if !equals.is_sign("=") || relates(low) {
        return None;
    }
    let (low, high, taken) = values(low, rest)?;
    // `t = 0, 1` are places of t.
    let has_dots = rest.iter().take(taken).any(|part| is_dots(part));
    let is_index = matches!(&name.nucleus, Nucleus::Letter(letters, _) if matches!(letters.as_str(), "i" | "j" | "k" | "l"));
    if !has_dots && !is_index {
        return None;
    }
    let integers = Declared::Integers {
        letters: vec![name],
        low: Least::Written(low),
        high,
    };
    Some((integers, taken + 1))
}

/// A letter with a subscript and nothing else.
fn member(item: &TexItem) -> Option<&TexItem> {
    let is_member = matches!(item.nucleus, Nucleus::Letter(..))
        && item.below.is_some()
        && item.above.is_none()
        && item.primes == 0;
    is_member.then_some(item)
}

/// `P_0, \dots, P_n`, perhaps in a set.
fn members<'i>(parts: &[List<'i>]) -> Option<(Declared<'i>, usize)> {
    let (first, rest) = parts.split_first()?;
    let [only] = first else {
        return None;
    };
    let first = member(only)?;
    let at = rest.iter().take(3).position(|part| is_dots(part))?;
    let (last, set) = rest.get(at + 1)?.split_first()?;
    let last = member(last)?;
    let signature = nucleus_signature(&first.nucleus);
    let between = rest.get(..at)?.iter().all(|part| {
        matches!(part, [only] if member(only).is_some_and(|own| nucleus_signature(&own.nucleus) == signature))
    });
    if !between || nucleus_signature(&last.nucleus) != signature {
        return None;
    }
    let space = match set {
        [] => None,
        [sign, set @ ..] if sign.is_sign("in") => Some(space(set)?),
        _ => return None,
    };
    let points = Declared::Points {
        member: first,
        space,
        ends: Some((first.below.as_deref()?, last.below.as_deref()?)),
    };
    Some((points, at + 2))
}

/// `\{P_i\}_{i=0}^n`, perhaps in a set.
fn braced<'i>(parts: &[List<'i>]) -> Option<(Declared<'i>, usize)> {
    let (braces, set) = parts.first()?.split_first()?;
    let Nucleus::Fenced('{', inner, '}') = &braces.nucleus else {
        return None;
    };
    let [only] = inner.as_slice() else {
        return None;
    };
    let (_, low) = match braces.below.as_deref()? {
        [index, equals, low @ ..] if equals.is_sign("=") => (letter(index)?, low),
        _ => return None,
    };
    let space = match set {
        [] => None,
        [sign, set @ ..] if sign.is_sign("in") => Some(space(set)?),
        _ => return None,
    };
    let points = Declared::Points {
        member: member(only)?,
        space,
        ends: Some((low, braces.above.as_deref()?)),
    };
    Some((points, 1))
}

/// `a, b \in [0, 1]`, `P_i \in \mathbb{R}^3`.
fn in_a_set<'i>(parts: &[List<'i>]) -> Option<(Declared<'i>, usize)> {
    let mut letters = vec![];
    for (at, part) in parts.iter().enumerate() {
        let (item, set) = part.split_first()?;
        let is_name =
            matches!(item.nucleus, Nucleus::Letter(..)) && item.above.is_none() && item.primes == 0;
        if !is_name {
            return None;
        }
        letters.push(item);
        match set {
            [] => {}
            [sign, set @ ..] if sign.is_sign("in") => {
                return Some((of_set(letters, set)?, at + 1));
            }
            _ => return None,
        }
    }
    None
}

fn of_set<'i>(letters: Vec<&'i TexItem>, set: List<'i>) -> Option<Declared<'i>> {
    if let Some(space) = space(set) {
        let is_member = |item: &TexItem| {
            let index = item.below.as_deref();
            index.is_some_and(|index| matches!(index, [only] if letter(only).is_some()))
        };
        return match letters.as_slice() {
            [member] if is_member(member) => Some(Declared::Points {
                member,
                space: Some(space),
                ends: None,
            }),
            _ if space == Space::Coordinates(1) => Some(Declared::Reals {
                letters,
                interval: None,
            }),
            _ => Some(Declared::Vectors { letters, space }),
        };
    }
    let [only] = set else {
        return None;
    };
    match &only.nucleus {
        Nucleus::Fenced('[' | '(', _, ']' | ')') if only.is_bare() => Some(Declared::Reals {
            letters,
            interval: Some(only),
        }),
        Nucleus::Fenced('{', inner, '}') if only.is_bare() => {
            let inner = segments(inner);
            let (first, rest) = inner.split_first()?;
            let (low, high, taken) = values(first, rest)?;
            (taken == rest.len()).then_some(Declared::Integers {
                letters,
                low: Least::Written(low),
                high,
            })
        }
        Nucleus::Letter(letter, TexFace::Other(face)) if face == "mathbb" && letter == "N" => {
            let least = match (only.below.as_deref().map(number), only.above.is_none()) {
                (None, true) => 1,
                (Some(Some(0)), true) => 0,
                _ => return None,
            };
            Some(Declared::Integers {
                letters,
                low: Least::Number(least),
                high: None,
            })
        }
        _ => None,
    }
}

/// `\mathbb{R}^3`.
fn space(set: List<'_>) -> Option<Space> {
    let [only] = set else {
        return None;
    };
    let is_reals = matches!(&only.nucleus, Nucleus::Letter(letter, TexFace::Other(face)) if face == "mathbb" && matches!(letter.as_str(), "R" | "E"));
    if !is_reals || only.below.is_some() || only.primes > 0 {
        return None;
    }
    match only.above.as_deref() {
        None => Some(Space::Coordinates(1)),
        Some(above) => match number(above) {
            Some(count) => Some(Space::Coordinates(u8::try_from(count).ok()?)),
            None => Some(Space::Any),
        },
    }
}
