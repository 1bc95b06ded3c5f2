//! The parts of a proposition.

use crate::binder::Binder;
use crate::code::{Code, Level};
use crate::unknowns::Along;

/// A claim in Rocq.
#[derive(Debug, Clone)]
pub struct Proposition {
    /// The definitions that it needs, in order: names and texts.
    pub definitions: Vec<(String, String)>,
    /// The bound symbols, `(x : R)`, each with the coordinates it is made of.
    pub binders: Vec<Binder>,
    /// The premises, in order.
    pub premises: Vec<Code>,
    /// The conclusion.
    pub conclusion: Code,
    /// The unknowns of the `given` equations.
    pub unknowns: Vec<String>,
    /// Whether coefficients occur of forms that are not seen to be linear.
    pub unclear_forms: bool,
    /// The unknowns as functions of the symbols whose coefficients are requested.
    pub alongs: Vec<Along>,
}

impl Proposition {
    /// `forall (x : R) ..., premises -> conclusion`.
    #[must_use]
    pub fn universal(&self) -> String {
        let mut text = self.bound("forall");
        for premise in &self.premises {
            text.push_str(&format!("  {} ->\n", premise.below(Level::Open)));
        }
        text.push_str(&format!("  {}", self.conclusion.within(Level::Open)));
        text
    }

    /// Writes `exists x ..., premises`: the premises can be satisfied. None if there are no premises.
    #[must_use]
    pub fn instance(&self) -> Option<String> {
        let (last, first) = self.premises.split_last()?;
        let mut text = self.bound("exists");
        for premise in first {
            text.push_str(&format!("  {} /\\\n", premise.below(Level::Both)));
        }
        text.push_str(&format!("  {}", last.below(Level::Both)));
        Some(text)
    }

    /// Writes the bound symbols under a quantifier.
    fn bound(&self, quantifier: &str) -> String {
        let group =
            |binder: &Binder| format!(" ({} : {})", binder.names.join(" "), binder.rocq_type);
        let groups: String = self.binders.iter().map(group).collect();
        let mut text = match groups.is_empty() {
            true => String::new(),
            false => format!("{quantifier}{groups},\n"),
        };
        for together in self
            .binders
            .iter()
            .filter_map(|binder| binder.together.as_ref())
        {
            text.push_str(&format!("  {together}\n"));
        }
        text
    }
}
