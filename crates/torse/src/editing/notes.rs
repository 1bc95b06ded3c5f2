//! What is shown beside a text: mistakes, and the verdicts of claims.

use std::ops::Range;
use std::sync::Arc;
use torse_report::{finding_in_words, glossary};
use torse_syntax::derivation::{Claim, DerivationError, LoadError, LookAlike, Source};
use torse_syntax::formula::Place;
use torse_syntax::taxonomy::Verdict;
use torse_verdicts::outcome::Outcome;
use torse_verdicts::words;

/// How a note is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum EditorNoteLevel {
    /// A file is wrong, a verdict is not the expected one, or levels of assurance contradict each other.
    Error,
    /// A refuted, undecided or ambiguous claim, or a name that looks like another.
    Warning,
    /// A condition; and a verdict that deserves a look and is expected.
    Information,
    /// A claim that holds.
    Hint,
}

/// A change of a text that an editor offers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TextRewrite {
    /// The bytes that are replaced.
    pub range: Range<usize>,
    /// What stands there afterwards.
    pub text: String,
}

/// A note at a place of a text.
#[derive(Debug, Clone)]
pub struct EditorNote {
    /// The file, as it was read.
    pub source: Arc<Source>,
    /// The bytes of its text that the note is about.
    pub range: Range<usize>,
    /// How it is shown.
    pub level: EditorNoteLevel,
    /// What kind of finding it is: `mistake`, `look-alike`, `contradiction`, `unexpected`, or the verdict.
    pub rule: &'static str,
    /// What is found, in sentences; lines of their own say what would be right.
    pub text: String,
    /// The corrected statement, where the statement itself is what a proved correction changes.
    pub correction: Option<TextRewrite>,
}

impl PartialEq for EditorNote {
    /// Two notes are equal if they say the same of the same place.
    fn eq(&self, other: &Self) -> bool {
        self.source.name == other.source.name
            && self.range == other.range
            && self.rule == other.rule
            && self.text == other.text
    }
}

impl EditorNote {
    /// A note about no verdict.
    fn about_text(
        (source, range): (&Arc<Source>, Range<usize>),
        level: EditorNoteLevel,
        rule: &'static str,
        text: String,
    ) -> Self {
        Self {
            source: Arc::clone(source),
            range,
            level,
            rule,
            text,
            correction: None,
        }
    }
}

/// The note of a mistake.
pub(super) fn mistake_note(mistake: &DerivationError) -> EditorNote {
    let help = miette::Diagnostic::help(mistake).map(|help| format!("\nhelp: {help}"));
    let text = format!("{mistake}{}", help.unwrap_or_default());
    EditorNote::about_text(
        mistake.source_range(),
        EditorNoteLevel::Error,
        "mistake",
        text,
    )
}

/// The note of a file that cannot be read, where another names it.
pub(super) fn unreadable_note(
    source: &Arc<Source>,
    range: Range<usize>,
    error: &LoadError,
) -> EditorNote {
    let text = error.to_string();
    EditorNote::about_text((source, range), EditorNoteLevel::Error, "mistake", text)
}

/// The note of a name that is taken for another.
pub(super) fn name_note(name: &LookAlike) -> EditorNote {
    let text = name.to_string();
    EditorNote::about_text(
        name.source_range(),
        EditorNoteLevel::Warning,
        "look-alike",
        text,
    )
}

/// The note of a decided claim, at its statement; none where there is nothing to decide.
pub(super) fn claim_note(claim: &Claim, outcome: &Outcome) -> Option<EditorNote> {
    let (level, rule) = level(outcome)?;
    let source = &claim.origin.source;
    let stated = claim.entry.states.as_ref().map(toml::Spanned::span);
    let range = stated.unwrap_or_else(|| {
        let id = claim.origin.span(Place {
            start: 0,
            end: claim.entry.id.get_ref().len(),
        });
        id.offset()..id.offset() + id.len()
    });
    let mut text = in_words(outcome);
    if let Some(correction) = outcome.correction() {
        text.push_str(&format!(
            "\ncorrected: {}",
            correction.statement.text.replace("[]", "")
        ));
        for line in words::correction(correction) {
            text.push_str(&format!("\nby: {line}"));
        }
    }
    Some(EditorNote {
        source: Arc::clone(source),
        level,
        rule,
        text,
        correction: rewrite(claim, outcome, &range),
        range,
    })
}

/// How the finding is shown; nothing is to be shown of definitions and of what is not decided on purpose.
fn level(outcome: &Outcome) -> Option<(EditorNoteLevel, &'static str)> {
    if outcome.contradiction().is_some() {
        return Some((EditorNoteLevel::Error, "contradiction"));
    }
    let expected = outcome.claim.expect;
    if expected.is_some_and(|expected| expected != outcome.verdict()) {
        return Some((EditorNoteLevel::Error, "unexpected"));
    }
    let grave = match expected {
        Some(_) => EditorNoteLevel::Information,
        None => EditorNoteLevel::Warning,
    };
    let level = match outcome.verdict() {
        Verdict::False | Verdict::Misprint => EditorNoteLevel::Warning,
        Verdict::Undecided | Verdict::Vacuous | Verdict::Depends => grave,
        Verdict::Conditional => EditorNoteLevel::Information,
        Verdict::Holds => EditorNoteLevel::Hint,
        _ => return None,
    };
    Some((level, glossary::verdict(outcome.verdict()).key))
}

/// The verdict and the finding, as `torse verify` words them.
fn in_words(outcome: &Outcome) -> String {
    let verdict = glossary::verdict(outcome.verdict());
    // Faults of which the authors are told are sentences about several claims: here is one.
    let mut text = match finding_in_words(outcome, &[]) {
        Some(finding) => format!("{}: {finding}", verdict.label),
        None => format!(
            "{}. {}",
            verdict.label,
            glossary::verdict_on(outcome).meaning
        ),
    };
    if let Some(expected) = outcome
        .claim
        .expect
        .filter(|expected| *expected != outcome.verdict())
    {
        let expected = glossary::verdict(expected).label;
        text.push_str(&format!("\nexpected: {expected}"));
    }
    if let Some(contradiction) = outcome.contradiction() {
        text.push_str(&format!("\ninternal contradiction: {contradiction}"));
    } else if let (Verdict::Undecided, Some(reason)) =
        (outcome.verdict(), words::steps(outcome).first())
    {
        text.push_str(&format!("\nreason: {reason}"));
    }
    text
}

/// What writes the corrected statement in place of the stated one, where the statement is what the correction changes.
fn rewrite(claim: &Claim, outcome: &Outcome, range: &Range<usize>) -> Option<TextRewrite> {
    let corrected = outcome.correction()?.statement.text.replace("[]", "");
    let stated = outcome.parsed()?.text.replace("[]", "");
    // A correction in a definition or a hypothesis leaves the statement as it is.
    let is_written = claim.entry.latex.is_none() && claim.entry.states.is_some();
    if !is_written || corrected == stated || corrected.contains('\n') {
        return None;
    }
    let text = match corrected.contains('\'') {
        true => format!("\"{corrected}\""),
        false => format!("'{corrected}'"),
    };
    Some(TextRewrite {
        range: range.clone(),
        text,
    })
}
