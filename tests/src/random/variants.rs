//! Claims that say the same in other words: other names, sides exchanged, hypotheses in another order.

use super::claim::{Claim, States};

/// What may be changed without changing the verdict.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Variant {
    /// Every declared name is another one, in the opposite order of the alphabet.
    Renamed,
    /// `right` before `left`.
    Exchanged,
    /// Hypotheses, equations and declarations from the last to the first.
    Reordered,
}

impl Variant {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Renamed, Self::Exchanged, Self::Reordered];

    /// The claim in these other words.
    #[must_use]
    pub fn of(self, claim: &Claim) -> Claim {
        let mut other = claim.clone();
        match self {
            Self::Renamed => rename(&mut other),
            Self::Exchanged => {
                if let States::Compare(left, relation, right) = &claim.states {
                    let relation = match *relation {
                        "<" => ">",
                        "<=" => ">=",
                        ">" => "<",
                        ">=" => "<=",
                        same => same,
                    };
                    other.states = States::Compare(right.clone(), relation, left.clone());
                }
            }
            Self::Reordered => {
                other.assume.reverse();
                other.given.reverse();
                other.unknowns.reverse();
                other.symbols.reverse();
                other.lets.reverse();
            }
        }
        other
    }
}

fn rename(claim: &mut Claim) {
    let mut names: Vec<String> = claim.symbols.iter().map(|(name, _)| name.clone()).collect();
    names.extend(claim.bases.iter().map(|(name, _)| name.clone()));
    names.sort();
    let count = names.len();
    let table: Vec<(String, String)> = names
        .into_iter()
        .enumerate()
        .map(|(place, name)| (name, format!("n{:02}", count - place)))
        .collect();
    let renamed = |text: &str| renamed(text, &table);
    for (name, declaration) in &mut claim.symbols {
        *name = renamed(name);
        // The key words of a declaration are no names.
        *declaration = declaration
            .split_inclusive('\'')
            .enumerate()
            .map(|(place, part)| {
                if place % 2 == 1 {
                    renamed(part)
                } else {
                    part.to_owned()
                }
            })
            .collect();
    }
    for (name, lines) in &mut claim.bases {
        *name = renamed(name);
        *lines = lines
            .split_inclusive('\'')
            .enumerate()
            .map(|(place, part)| {
                if place % 2 == 1 {
                    renamed(part)
                } else {
                    part.to_owned()
                }
            })
            .collect();
    }
    for (head, body) in &mut claim.lets {
        *head = renamed(head);
        *body = renamed(body);
    }
    let lists = [
        &mut claim.given,
        &mut claim.unknowns,
        &mut claim.exists,
        &mut claim.witnesses,
        &mut claim.assume,
    ];
    for list in lists {
        for text in list {
            *text = renamed(text);
        }
    }
    claim.states = match &claim.states {
        States::Compare(left, relation, right) => {
            States::Compare(renamed(left), relation, renamed(right))
        }
        States::Other(text) => States::Other(renamed(text)),
    };
}

/// The text with whole names replaced.
fn renamed(text: &str, table: &[(String, String)]) -> String {
    let mut made = String::new();
    let mut word = String::new();
    for c in text.chars().chain([' ']) {
        let inside = c.is_alphanumeric() || c == '_';
        if inside {
            word.push(c);
            continue;
        }
        let other = table.iter().find(|(name, _)| *name == word);
        made.push_str(other.map_or(word.as_str(), |(_, other)| other.as_str()));
        word.clear();
        made.push(c);
    }
    made.pop();
    made
}
