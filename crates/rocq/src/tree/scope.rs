//! What stands for a name where a formula is written.
//!
//! A name is bound in one of two ways. *Local* are the index of a sum and the parameters of functions and bases: the
//! bodies of definitions do not see them. *Moved* is a declared symbol under `D`, `at` or `integral`: the bodies of
//! definitions take what stands for it as an argument.

use super::kinds::Kind;
use super::reach::Bound;
use crate::code::Code;
use std::collections::{BTreeMap, BTreeSet};

/// What stands for a local name.
#[derive(Debug, Clone)]
pub(super) struct Local {
    /// The text, in the scope of integers if it is one.
    pub code: Code,
    /// What it is.
    pub kind: Kind,
}

/// What stands for names.
#[derive(Debug, Clone, Default)]
pub(super) struct Scope {
    pub locals: BTreeMap<String, Local>,
    pub moved: BTreeMap<String, Code>,
}

impl Scope {
    /// The names that are locally bound.
    pub fn bound(&self) -> Bound {
        self.locals.keys().cloned().collect()
    }

    /// What the body of a definition sees.
    pub fn outside(&self) -> Self {
        Self {
            locals: BTreeMap::new(),
            moved: self.moved.clone(),
        }
    }

    /// The same with one more local name.
    pub fn with_local(&self, name: &str, code: Code, kind: Kind) -> Self {
        let mut more = self.clone();
        more.locals.insert(name.to_owned(), Local { code, kind });
        more
    }

    /// The same where a text stands for a declared symbol.
    pub fn with_moved(&self, name: &str, code: Code) -> Self {
        let mut more = self.clone();
        more.moved.insert(name.to_owned(), code);
        more
    }

    /// The names that occur in what stands for other names than this one.
    pub fn words(&self, but: &str) -> BTreeSet<String> {
        let locals = self.locals.iter().map(|(name, local)| (name, &local.code));
        let texts = locals.chain(&self.moved).filter(|(name, _)| *name != but);
        texts.flat_map(|(_, code)| words(code.text())).collect()
    }
}

/// The names in a text of Rocq.
pub(super) fn words(text: &str) -> impl Iterator<Item = String> + '_ {
    let letter = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '\'';
    let words = text.split(move |c: char| !letter(c));
    words.filter(|word| !word.is_empty()).map(str::to_owned)
}
