//! Collects mistakes in derivation files: each is shown once, up to a maximum number, while the run goes on.

use crate::exit::{Exit, Failure};
use crate::terminal;
use std::collections::BTreeSet;
use torse::annotations::{Annotation, AnnotationLevel};

/// Maximum number of mistakes that are shown. Each is shown with the lines around it, which takes time in long files.
const MAX_SHOWN: usize = 100;

/// Diagnostics of derivation files, in the order in which they were found.
#[derive(Default)]
pub struct Diagnostics {
    shown: BTreeSet<String>,
    texts: Vec<String>,
    annotations: Vec<Annotation>,
    /// How many came after the last one that is shown.
    further: usize,
}

impl Diagnostics {
    /// Adds a mistake, unless it was added before: every claim that uses a wrong definition reports it.
    pub fn add(&mut self, mistake: impl Into<Failure>) {
        if self.texts.len() >= MAX_SHOWN {
            self.further += 1;
            return;
        }
        let mistake = mistake.into();
        let text = terminal::shown(&mistake);
        if self.shown.insert(text.clone()) {
            self.texts.push(text);
            self.annotations.push(Annotation {
                level: AnnotationLevel::Error,
                rule: "mistake",
                claim: None,
                message: mistake.to_string(),
                place: torse::diagnostic_place(&mistake),
            });
        }
    }

    /// Those that are shown, with their places.
    pub fn annotations(&self) -> &[Annotation] {
        &self.annotations
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.texts.is_empty()
    }

    /// Shows all of them, and returns the exit code of the run.
    pub fn tell(&self, exit: Exit) -> Exit {
        self.texts.iter().for_each(|text| terminal::remark(text));
        if self.further > 0 {
            let further = self.further;
            terminal::remark(&format!("  × {further} further mistakes are not shown\n"));
        }
        match self.is_empty() {
            true => exit,
            false => exit.max(Exit::BadData),
        }
    }
}
