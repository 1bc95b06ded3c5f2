//! The numbers that LaTeX prints: of sections, equations and theorems.
//!
//! A theorem of an environment that the text does not declare, since its class does, is counted by itself, through the whole text.

use std::collections::BTreeMap;

/// The titles of environments that classes declare.
const USUAL: [(&str, &str); 9] = [
    ("theorem", "Theorem"),
    ("lemma", "Lemma"),
    ("proposition", "Proposition"),
    ("corollary", "Corollary"),
    ("definition", "Definition"),
    ("example", "Example"),
    ("remark", "Remark"),
    ("conjecture", "Conjecture"),
    ("property", "Property"),
];

/// An environment that is printed with a title and a number.
#[derive(Debug, Clone)]
pub struct TheoremKind {
    /// The printed title.
    pub title: String,
    /// The counter; none if it has no number.
    pub counter: Option<String>,
}

/// Counters.
#[derive(Debug, Clone, Default)]
pub struct Numbering {
    sections: [u32; 3],
    /// Counts by name, and whether each begins anew in a section.
    counts: BTreeMap<String, u32>,
    within: BTreeMap<String, bool>,
    kinds: BTreeMap<String, TheoremKind>,
    is_appendix: bool,
}

impl Numbering {
    /// Declares `\newtheorem`: the counter is that of another environment, or its own.
    pub fn declare(
        &mut self,
        environment: &str,
        title: &str,
        shared: Option<&str>,
        within_section: bool,
        numbered: bool,
    ) {
        let counter = match shared.and_then(|other| self.kinds.get(other)) {
            Some(other) => other.counter.clone(),
            None => Some(environment.to_owned()),
        };
        if shared.is_none() {
            self.within.insert(environment.to_owned(), within_section);
        }
        let counter = counter.filter(|_| numbered);
        self.kinds.insert(
            environment.to_owned(),
            TheoremKind {
                title: title.to_owned(),
                counter,
            },
        );
    }

    /// `\numberwithin{counter}{section}`.
    pub fn count_within_section(&mut self, counter: &str) {
        self.within.insert(counter.to_owned(), true);
    }

    /// `\appendix`.
    pub fn appendix(&mut self) {
        self.is_appendix = true;
        self.sections = [0; 3];
    }

    /// The kind of an environment, if it is one like a theorem.
    pub fn theorem(&self, environment: &str) -> Option<TheoremKind> {
        let starred = environment.strip_suffix('*');
        if let Some(kind) = self.kinds.get(environment) {
            return Some(kind.clone());
        }
        let bare = starred.unwrap_or(environment);
        let (name, title) = USUAL.into_iter().find(|(name, _)| *name == bare)?;
        let counter = starred.is_none().then(|| name.to_owned());
        Some(TheoremKind {
            title: title.to_owned(),
            counter,
        })
    }

    /// Counts a section of a level from 0 and returns its number.
    pub fn section(&mut self, level: usize) -> String {
        for (at, count) in self.sections.iter_mut().enumerate() {
            if at == level {
                *count += 1;
            } else if at > level {
                *count = 0;
            }
        }
        if level == 0 {
            for (counter, within) in &self.within {
                if *within {
                    self.counts.remove(counter);
                }
            }
        }
        let numbers = self.sections.iter().take(level + 1).enumerate();
        let numbers = numbers.map(|(at, count)| {
            if at == 0 {
                self.first(*count)
            } else {
                count.to_string()
            }
        });
        numbers.collect::<Vec<_>>().join(".")
    }

    fn first(&self, count: u32) -> String {
        match self.is_appendix {
            true => char::from_u32(u32::from('A') + count.saturating_sub(1))
                .unwrap_or('A')
                .to_string(),
            false => count.to_string(),
        }
    }

    /// Counts and returns the printed number of a counter.
    pub fn count(&mut self, counter: &str) -> String {
        let count = self.counts.entry(counter.to_owned()).or_insert(0);
        *count += 1;
        let count = *count;
        match self.within.get(counter) {
            Some(true) => format!(
                "{}.{count}",
                self.first(self.sections.first().copied().unwrap_or(0))
            ),
            _ => count.to_string(),
        }
    }
}
