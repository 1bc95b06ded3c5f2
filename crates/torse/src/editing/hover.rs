//! What stands under the cursor: what a name means, what was found of a claim, what a key is for.

use super::cursor::{Cursor, Spot, cursor};
use super::folder::{EditedFolder, KnownFindings};
use super::keys::{TextKind, description, text_kind};
use crate::explanation::{Explanation, short};
use std::fmt::Write;
use std::ops::Range;
use torse_report::{Mathematics, glossary};
use torse_syntax::derivation::Claim;
use torse_syntax::derivation::Provenance;
use torse_syntax::derivation::declarations::Declarations;
use torse_syntax::formula::functions::described;
use torse_syntax::notation::{domain, text as formula_text};

/// The most characters of a line of an explanation.
const MAX_LINE: usize = 400;

/// What is said of a place of a text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EditorHover {
    /// The bytes of the text that it is said of.
    pub range: Range<usize>,
    /// Markdown.
    pub markdown: String,
}

impl EditedFolder {
    /// Says what stands at the byte `place` of the text of a file: the declaration of a name in a formula, the description
    /// of a key, and elsewhere in a claim what was found of it. Nothing where there is nothing to say. The text may be newer
    /// than the folder.
    ///
    /// ```
    /// # let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../derivations");
    /// # let folder = std::path::Path::new(folder);
    /// # if folder.exists() {
    /// use torse::editing::{EditedFolder, KnownFindings};
    /// let edited = EditedFolder::read(folder, |_| None)?;
    /// let text = "[[claim]]\nid = 'torses/new'\nstates = 'integral(x, x, 0, 1) == 1/2'";
    /// let said = edited.hover("torses/planes.toml", text, 40, &KnownFindings::default());
    /// let said = said.ok_or("a function is described")?;
    /// assert!(said.markdown.contains("integral(f, x, a, b)"));
    /// assert_eq!(&text[said.range], "integral");
    /// # }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn hover(
        &self,
        file: &str,
        text: &str,
        place: usize,
        known: &KnownFindings,
    ) -> Option<EditorHover> {
        let at = cursor(text, place);
        let claim = claim_id(text, &at);
        let word = word(text, place);
        match &at.spot {
            Spot::Comment | Spot::Header => return None,
            Spot::Key => {
                // The key that the place is in may go on behind it.
                let range = word?;
                let key = text.get(range.clone())?;
                let path: Vec<String> = at.path.iter().cloned().chain([key.to_owned()]).collect();
                let markdown = format!("`{key}`: {}", description(&path)?);
                return Some(EditorHover { range, markdown });
            }
            Spot::Text { .. } if text_kind(&at.path) == TextKind::Formula => {
                let named = word.and_then(|range| {
                    let name = text.get(range.clone())?;
                    let declared = self.declarations(file, claim.as_deref());
                    let said = match (declared.and_then(|all| named(all, name)), described(name)) {
                        (Some(said), _) => said,
                        (None, of) => {
                            let of = of?;
                            format!("```text\n{}\n```\n{}", of.call, of.says)
                        }
                    };
                    Some(EditorHover {
                        range,
                        markdown: said,
                    })
                });
                if named.is_some() {
                    return named;
                }
            }
            Spot::Text { .. } | Spot::Value => {}
        }
        let claim = self.claim(file, &claim?)?;
        let start = text.get(..place)?.rfind('\n').map_or(0, |end| end + 1);
        let end = text
            .get(place..)?
            .find('\n')
            .map_or(text.len(), |end| place + end);
        Some(EditorHover {
            range: start..end,
            markdown: self.found(claim, known),
        })
    }

    /// What was found of a claim, as Markdown.
    fn found(&self, claim: &Claim, known: &KnownFindings) -> String {
        let id = claim.entry.id.get_ref();
        let set = claim
            .statement
            .as_ref()
            .and_then(|statement| Some(Mathematics::read(&formula_text(&statement.expr))?.text));
        let set = set
            .map(|set| format!("\n\n{}", cut(&set)))
            .unwrap_or_default();
        let Some(outcome) = self.outcome(claim, known) else {
            return format!("`{id}`, {}: not decided yet{set}", claim.entry.at);
        };
        let verdict = glossary::verdict_on(&outcome);
        let level = glossary::level(&outcome, false);
        let level = level
            .map(|level| format!(" ({})", level.label))
            .unwrap_or_default();
        let note = in_lines(&short(&outcome));
        format!(
            "**{}**{level}: {}\n\n`{id}`, {}{set}\n\n```text\n{note}```",
            verdict.label, verdict.meaning, claim.entry.at
        )
    }
}

/// An explanation as lines of plain text, labels on the left.
fn in_lines(explanation: &Explanation) -> String {
    let lines = explanation.groups.iter().flatten().skip(1);
    let mut text = String::new();
    for line in lines {
        // A string takes all that is written.
        let _ = writeln!(text, "{:<12} {}", line.label, cut(&line.text));
    }
    text
}

fn cut(line: &str) -> String {
    match line.char_indices().nth(MAX_LINE) {
        Some((end, _)) => format!("{} ...", line.get(..end).unwrap_or(line)),
        None => line.to_owned(),
    }
}

/// The name around a place: letters, digits, `_` and primes.
fn word(text: &str, place: usize) -> Option<Range<usize>> {
    let letter = |c: char| c.is_alphanumeric() || c == '_';
    let (before, after) = (text.get(..place)?, text.get(place..)?);
    let start = place - (before.len() - before.trim_end_matches(letter).len());
    let end = place + (after.len() - after.trim_start_matches(letter).len());
    (start < end).then_some(start..end)
}

/// What a declared name means, as Markdown.
fn named(declared: &Declarations, name: &str) -> Option<String> {
    let mut said = format!("```text\n{}\n```", meaning(declared, name)?);
    if let Some(range) = declared.range(name) {
        match &range.provenance {
            Provenance::Printed(quote) => said.push_str(&format!("\nprinted: {}", quote.words)),
            Provenance::Ours { reason } => said.push_str(&format!("\nours: {reason}")),
            Provenance::Stated => {}
        }
    }
    if let Some(display) = declared.display(name) {
        said.push_str(&format!("\n\nprinted as `{display}`"));
    }
    Some(said)
}

/// What a declared name means, in a line.
pub(super) fn meaning(declared: &Declarations, name: &str) -> Option<String> {
    if let Some(definition) = declared.definition(name) {
        let parameters = definition.parameters.join(", ");
        let head = match (definition.parameters.is_empty(), definition.indexed) {
            (true, _) => name.to_owned(),
            (false, true) => format!("{name}[{parameters}]"),
            (false, false) => format!("{name}({parameters})"),
        };
        return Some(cut(&format!(
            "{head} := {}",
            formula_text(&definition.body.expr)
        )));
    }
    if let Some(basis) = declared.basis(name) {
        let arguments: Vec<&str> = std::iter::once(&basis.variable)
            .chain(&basis.parameters)
            .map(String::as_str)
            .collect();
        return Some(format!(
            "{name}[i,k]({}), a basis: functions i = 0..k of degree k, seeds of degree {}",
            arguments.join(", "),
            basis.degree
        ));
    }
    if let Some(dimension) = declared.function(name) {
        let values = match dimension {
            Some(1) => "numbers".to_owned(),
            Some(many) => format!("vectors with {many} coordinates"),
            None => "vectors of any dimension".to_owned(),
        };
        return Some(format!(
            "{name}, any smooth function of one variable; its values are {values}"
        ));
    }
    Some(domain::words(name, declared.symbol(name)?))
}

/// The id of the claim that a place stands in, as the text has it.
pub(super) fn claim_id(text: &str, at: &Cursor) -> Option<String> {
    let head = at.path.first().map(String::as_str);
    let entry = at.entry.filter(|_| head == Some("claim"))?;
    let mut lines = text.get(entry..)?.lines();
    lines.next()?;
    let lines = lines.take_while(|line| !line.starts_with("[["));
    let mut ids = lines.filter_map(|line| {
        let value = line
            .trim()
            .strip_prefix("id")?
            .trim_start()
            .strip_prefix('=')?;
        let value = value.trim_start();
        let quote = value
            .chars()
            .next()
            .filter(|quote| matches!(quote, '"' | '\''))?;
        value.get(1..)?.split(quote).next().map(str::to_owned)
    });
    ids.next()
}
