//! A random claim: declarations, a statement, and whether it is true.

use super::Kind;
use super::corrected::Wanted;
use super::polynomial::Polynomial;
use std::fmt::Write;

/// What is true of a claim, by construction.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Truth {
    /// True, and every term is defined everywhere.
    Holds,
    /// True wherever every term is defined, which is not everywhere.
    Conditional,
    /// False, and where it fails.
    Fails(String),
    /// No point satisfies the hypotheses.
    Vacuous,
}

/// A statement.
#[derive(Debug, Clone)]
pub enum States {
    /// `left relation right`: the sides may be exchanged.
    Compare(String, &'static str, String),
    /// Any other.
    Other(String),
}

impl States {
    /// As text.
    #[must_use]
    pub fn text(&self) -> String {
        match self {
            Self::Compare(left, relation, right) => format!("{left} {relation} {right}"),
            Self::Other(text) => text.clone(),
        }
    }
}

/// A claim with all that it needs: a derivation file of its own.
#[derive(Debug, Clone)]
pub struct Claim {
    /// Of which kind.
    pub kind: Kind,
    /// The number that made it.
    pub number: u64,
    /// The word of the field `kind`.
    pub word: &'static str,
    /// Declared names and what stands after them.
    pub symbols: Vec<(String, String)>,
    /// Basis families: name, and the lines of the table.
    pub bases: Vec<(String, String)>,
    /// Definitions of the claim: head and body.
    pub lets: Vec<(String, String)>,
    /// Given equations.
    pub given: Vec<String>,
    /// Their unknowns.
    pub unknowns: Vec<String>,
    /// Numbers that it seeks, perhaps each with what it is.
    pub exists: Vec<String>,
    /// What they are, for the second judge: where there are none, what the claim is false for.
    pub witnesses: Vec<String>,
    /// Assumptions.
    pub assume: Vec<String>,
    /// The statement.
    pub states: States,
    /// Whether it is true.
    pub truth: Truth,
    /// What the right side should be, where the generator knows it as a polynomial.
    pub wanted: Option<Wanted>,
}

impl Claim {
    /// A claim with nothing declared.
    #[must_use]
    pub fn new(kind: Kind, states: States, truth: Truth) -> Self {
        Self {
            kind,
            number: 0,
            word: "property",
            symbols: vec![],
            bases: vec![],
            lets: vec![],
            given: vec![],
            unknowns: vec![],
            exists: vec![],
            witnesses: vec![],
            assume: vec![],
            states,
            truth,
            wanted: None,
        }
    }

    /// With a declared name.
    #[must_use]
    pub fn symbol(mut self, name: &str, declaration: impl Into<String>) -> Self {
        self.symbols.push((name.to_owned(), declaration.into()));
        self
    }

    /// With the polynomial that the right side should be.
    #[must_use]
    pub fn wanting(mut self, names: &[&str], value: &Polynomial) -> Self {
        self.wanted = Some(Wanted {
            names: names.iter().map(|name| (*name).to_owned()).collect(),
            value: value.clone(),
        });
        self
    }

    /// With an assumption.
    #[must_use]
    pub fn assuming(mut self, statement: impl Into<String>) -> Self {
        self.assume.push(statement.into());
        self
    }

    /// With a definition.
    #[must_use]
    pub fn letting(mut self, head: &str, body: impl Into<String>) -> Self {
        self.lets.push((head.to_owned(), body.into()));
        self
    }

    /// With a basis family.
    #[must_use]
    pub fn basis(mut self, name: &str, lines: impl Into<String>) -> Self {
        self.bases.push((name.to_owned(), lines.into()));
        self
    }

    /// The id of the claim in the paper `random`.
    #[must_use]
    pub fn id(&self) -> String {
        format!("random/{}-{}", self.kind.word(), self.number)
    }

    /// The text of a claim file of the paper `random`.
    #[must_use]
    pub fn file(&self) -> String {
        let mut text = String::new();
        if !self.symbols.is_empty() {
            text.push_str("[symbols]\n");
        }
        for (name, declaration) in &self.symbols {
            let _ = writeln!(text, "{name} = {declaration}");
        }
        for (name, lines) in &self.bases {
            let _ = writeln!(text, "[basis.{name}]\n{}", lines.trim());
        }
        let _ = writeln!(
            text,
            "[[claim]]\nid = \"{}\"\nat = \"-\"\nkind = \"{}\"\nprinted = \"-\"",
            self.id(),
            self.word
        );
        if !self.lets.is_empty() {
            let lets: Vec<String> = self
                .lets
                .iter()
                .map(|(head, body)| format!("\"{head}\" = \"{body}\""))
                .collect();
            let _ = writeln!(text, "let = {{ {} }}", lets.join(", "));
        }
        for (field, list) in [
            ("given", &self.given),
            ("solve_for", &self.unknowns),
            ("exists", &self.exists),
            ("assume", &self.assume),
        ] {
            if !list.is_empty() {
                let quoted: Vec<String> = list.iter().map(|s| format!("\"{s}\"")).collect();
                let _ = writeln!(text, "{field} = [{}]", quoted.join(", "));
            }
        }
        let _ = writeln!(text, "states = \"{}\"", self.states.text());
        text
    }
}
