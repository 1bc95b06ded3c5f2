//! What is wrong with the derivation files: all of it is told, each mistake once, and the rest goes on.

use crate::exit::{Exit, Failure};
use crate::terminal;
use std::collections::BTreeSet;

/// Mistakes of derivation files, in the order in which they were found.
#[derive(Default)]
pub struct Mistakes {
    shown: BTreeSet<String>,
    texts: Vec<String>,
}

impl Mistakes {
    /// Adds a mistake, unless it is known: a wrong definition is met by every claim that uses it.
    pub fn add(&mut self, mistake: impl Into<Failure>) {
        let text = terminal::shown(&mistake.into());
        if self.shown.insert(text.clone()) {
            self.texts.push(text);
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.texts.is_empty()
    }

    /// Tells all of them, and says how the run ends.
    pub fn tell(&self, exit: Exit) -> Exit {
        self.texts.iter().for_each(|text| terminal::remark(text));
        match self.is_empty() {
            true => exit,
            false => exit.max(Exit::BadData),
        }
    }
}
