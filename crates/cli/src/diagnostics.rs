//! Collects mistakes in derivation files: each is shown once, up to a maximum number, while the run goes on.

use crate::exit::{Exit, Failure};
use crate::terminal;
use miette::Diagnostic;
use std::collections::BTreeSet;
use torse::annotations::Annotation;

/// Maximum number of mistakes that are shown. Each is shown with the lines around it, which takes time in long files.
const MAX_SHOWN: usize = 100;

/// Diagnostics of derivation files, in the order in which they were found.
#[derive(Default)]
pub struct Diagnostics {
    /// The identities of all mistakes.
    found: BTreeSet<Identity>,
    texts: Vec<String>,
    annotations: Vec<Annotation>,
    /// How many came after the last one that is shown.
    further: usize,
}

impl Diagnostics {
    /// Adds a mistake, unless it was added before: every claim that uses a wrong definition reports it.
    pub fn add(&mut self, mistake: impl Into<Failure>) {
        let mistake = mistake.into();
        if !self.found.insert(identity(&mistake)) {
            return;
        }
        if self.texts.len() >= MAX_SHOWN {
            self.further += 1;
            return;
        }
        self.texts.push(terminal::shown(&mistake));
        self.annotations.push(Annotation::mistake(&mistake));
    }

    /// Returns those that are shown, with their places.
    pub fn annotations(&self) -> &[Annotation] {
        &self.annotations
    }

    /// Returns whether there are none.
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

/// Message, file and byte offset of a mistake.
type Identity = (String, Option<String>, Option<usize>);

/// Tells mistakes apart without the lines around them, which take time to find.
fn identity(mistake: &dyn Diagnostic) -> Identity {
    let source = mistake.source_code();
    let start = source.and_then(|source| source.read_span(&(0, 0).into(), 0, 0).ok());
    let file = start.and_then(|start| start.name().map(str::to_owned));
    let label = mistake.labels().and_then(|mut labels| labels.next());
    (mistake.to_string(), file, label.map(|label| label.offset()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_repeated_mistake_is_not_a_further_one() {
        let mut diagnostics = Diagnostics::default();
        for _ in 0..2 {
            for n in 0..MAX_SHOWN + 3 {
                let slug = n.to_string();
                diagnostics.add(Failure::Slug { slug });
            }
        }
        assert_eq!(
            (diagnostics.texts.len(), diagnostics.further),
            (MAX_SHOWN, 3)
        );
    }
}
