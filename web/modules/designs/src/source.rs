//! The design of a question, and the one that is held from the question before.

use crate::Failure;
use serde::Deserialize;
use std::cell::RefCell;
use torse::Design;
use torse::designs::unroll::Demand;
use torse::{Error, Pattern};

/// A design as the page has it.
#[derive(Deserialize, Clone, PartialEq, Eq)]
pub struct Source {
    /// The name of the file. If it is among the files, its faces are the design, and there is no text.
    name: String,
    /// The text.
    text: String,
    /// The files that it names, and how long they are.
    files: Vec<(String, usize)>,
}

/// A design that was read, with its pattern as far as it was asked for.
pub struct Held {
    source: Source,
    bytes: Vec<u8>,
    /// The design.
    pub design: Design,
    pattern: Option<Result<Pattern, Error>>,
}

thread_local! {
    static HELD: RefCell<Option<Held>> = const { RefCell::new(None) };
}

/// Rulings of each patch in space, at least.
const MIN_RULINGS: usize = 64;

impl Held {
    /// The text.
    pub fn text(&self) -> &str {
        &self.source.text
    }

    /// How many steps between rulings of the pattern are taken from one that is shown to the next: all are bent, and few are drawn.
    pub fn every(&self) -> usize {
        let shown = self.design.parts().view.rulings.saturating_sub(1).max(1);
        MIN_RULINGS.div_ceil(shown)
    }

    /// Its pattern, with more rulings than are shown.
    pub fn pattern(&mut self) -> &Result<Pattern, Error> {
        let shown = self.design.parts().view.rulings.saturating_sub(1).max(1);
        let demand = Demand {
            rulings: Some(shown * self.every() + 1),
            ..Demand::default()
        };
        let design = &self.design;
        self.pattern
            .get_or_insert_with(|| design.unroll_as(&demand))
    }
}

impl Source {
    /// Reads the design, unless it is the one of the question before, and answers of it.
    pub fn held<T>(
        self,
        bytes: &[u8],
        job: impl FnOnce(&mut Held) -> Result<T, Failure>,
    ) -> Result<T, Failure> {
        HELD.with_borrow_mut(|held| {
            let same = held
                .as_ref()
                .is_some_and(|held| held.source == self && held.bytes == bytes);
            if !same {
                *held = None;
                let design = self.read(bytes)?;
                *held = Some(Held {
                    bytes: bytes.to_vec(),
                    source: self,
                    design,
                    pattern: None,
                });
            }
            match held {
                Some(held) => job(held),
                None => Err(Failure::Asked("there is no design".to_owned())),
            }
        })
    }

    fn read(&self, bytes: &[u8]) -> Result<Design, Failure> {
        let files = torse_web_border::files(&self.files, bytes).map_err(Failure::Asked)?;
        let found = |wanted: &str| files.iter().find(|(name, _)| *name == wanted);
        if let Some((name, bytes)) = found(&self.name) {
            return Ok(Design::read_bytes(name, bytes)?);
        }
        let mut file = |wanted: &str| match found(wanted) {
            Some((_, bytes)) => Ok(bytes.to_vec()),
            None => Err(format!("drop the file `{wanted}` on the page")),
        };
        Ok(Design::read_with(&self.name, &self.text, &mut file)?)
    }
}
