//! What a comparison found.

use crate::program::CodeLanguage;
use serde::Serialize;
use std::fmt;
use torse_prove::evidence::Witness;
use torse_syntax::taxonomy::Verdict;
use torse_verdicts::Finding;
use torse_verdicts::outcome::Outcome;

/// Whether a function equals what is printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum CodeVerdict {
    /// For all values for which both have a meaning.
    Equal,
    /// Where some formulas are not zero, [`Comparison::conditions`].
    EqualWhere,
    /// They differ at a point.
    Different,
    /// Undecided, for [`Comparison::reason`].
    Undecided,
}

/// A comparison of a function with the printed side of a claim.
#[derive(Debug, Clone, Serialize)]
pub struct Comparison {
    /// The id of the claim.
    pub claim: String,
    /// The place in the paper.
    pub at: String,
    /// The file of the function.
    pub file: String,
    /// The function.
    pub function: String,
    /// Its language.
    pub language: CodeLanguage,
    /// The line on which the function begins.
    pub line: usize,
    /// What the function computes, as a formula of the claim's symbols.
    pub code: String,
    /// The printed side.
    pub print: String,
    /// Whether they are equal.
    pub verdict: CodeVerdict,
    /// The conditions under which they are.
    pub conditions: Vec<String>,
    /// What the function asserts of the symbols: without it there is no value, and nothing is compared.
    pub asserted: Vec<String>,
    /// Why nothing is decided.
    pub reason: Option<String>,
    /// A point at which they differ: the left value is that of the code.
    pub witness: Option<Witness>,
    /// Code minus print, in normal form.
    pub difference: Option<String>,
    /// Whether code that differs from the print equals the other side of the claim: then it is the print that is wrong.
    pub equals_other_side: bool,
    /// The one change of the code after which both are equal.
    pub code_edit: Option<CodeEdit>,
    /// The one change of the print after which both are equal.
    pub print_edit: Option<PrintEdit>,
    /// Whether a search for a change ended before all were tried.
    pub ended_early: bool,
    /// The whole finding about the equation of code and print.
    #[serde(skip)]
    pub outcome: Outcome,
}

/// A change of a function after which it equals the print.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct CodeEdit {
    /// The line, counted from one.
    pub line: usize,
    /// The column, in characters, counted from one.
    pub column: usize,
    /// How many characters are replaced.
    pub length: usize,
    /// What stands there.
    pub written: String,
    /// What would be right.
    pub replacement: String,
    /// The line as it is.
    pub line_now: String,
    /// The line as it would be right; none where the change goes over several lines.
    pub line_then: Option<String>,
    /// The conditions under which both are equal then.
    pub conditions: Vec<String>,
    /// Whether no other one change was proved.
    pub is_unique: bool,
}

/// A change of the print after which it equals the function.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct PrintEdit {
    /// The change, in words.
    pub change: String,
    /// The side as it would be.
    pub print: String,
    /// Whether no other one change was proved.
    pub is_unique: bool,
}

impl CodeVerdict {
    /// The verdict on the equation of code and print.
    pub(super) fn new(outcome: &Outcome) -> Self {
        match outcome.verdict() {
            Verdict::Holds => Self::Equal,
            Verdict::Conditional => Self::EqualWhere,
            Verdict::False | Verdict::Misprint => Self::Different,
            _ => Self::Undecided,
        }
    }
}

/// Why an equation is not decided.
pub(super) fn reason(outcome: &Outcome) -> Option<String> {
    match &outcome.finding {
        Finding::Undecided(open) => Some(open.reasons.join("; ")),
        Finding::Vacuous(_) => Some("no point satisfies the hypotheses".to_owned()),
        Finding::Contradicted(_) => outcome
            .contradiction()
            .map(|reason| format!("internal contradiction: {reason}")),
        _ => None,
    }
}

/// The line and the column of a byte, counted from one, and the text of the line.
pub(super) fn line(text: &str, byte: usize) -> (usize, usize, &str) {
    let before = text.get(..byte).unwrap_or(text);
    let start = before.rfind('\n').map_or(0, |position| position + 1);
    let number = before.matches('\n').count() + 1;
    let column = before.get(start..).map_or(0, |part| part.chars().count()) + 1;
    let rest = text.get(start..).unwrap_or("");
    (number, column, rest.lines().next().unwrap_or(""))
}

/// The longest formula that is shown, in characters.
const MAX_SHOWN: usize = 600;

fn shown(formula: &str) -> String {
    let count = formula.chars().count();
    if count <= MAX_SHOWN {
        return formula.to_owned();
    }
    let start: String = formula.chars().take(MAX_SHOWN).collect();
    format!("{start} ... ({} more characters)", count - MAX_SHOWN)
}

/// The comparison in words, for a terminal.
impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let verdict = match self.verdict {
            CodeVerdict::Equal => "equal".to_owned(),
            CodeVerdict::EqualWhere => {
                let conditions = self.conditions.join(" and ");
                format!("equal where {conditions}")
            }
            CodeVerdict::Different => "different".to_owned(),
            CodeVerdict::Undecided => {
                let reason = self.reason.as_deref().unwrap_or("");
                format!("undecided: {}", shown(reason))
            }
        };
        let (file, name, line) = (&self.file, &self.function, self.line);
        writeln!(f, "{verdict}")?;
        writeln!(
            f,
            "  paper  {}, {}: {}",
            self.claim,
            self.at,
            shown(&self.print)
        )?;
        writeln!(f, "  code   {file}:{line}, {name}: {}", shown(&self.code))?;
        if !self.asserted.is_empty() {
            let asserted = self.asserted.join(" and ");
            writeln!(f, "  where  {}, as the code asserts", shown(&asserted))?;
        }
        if let Some(witness) = &self.witness {
            let at = witness
                .at
                .iter()
                .map(|(name, value)| format!("{name} = {value}"));
            writeln!(f, "  at     {}", at.collect::<Vec<_>>().join(", "))?;
            writeln!(
                f,
                "         the print is {}, the code is {}",
                witness.right, witness.left
            )?;
        }
        if let Some(difference) = &self.difference {
            writeln!(f, "  code minus print  {}", shown(difference))?;
        }
        if self.equals_other_side {
            writeln!(
                f,
                "the code equals the other side of the claim: it is the print that differs"
            )?;
        }
        if let Some(edit) = &self.code_edit {
            write!(f, "{edit}")?;
        }
        if let Some(edit) = &self.print_edit {
            writeln!(
                f,
                "or in the print: {}{}",
                edit.change,
                alone(edit.is_unique)
            )?;
            writeln!(f, "  then   {}", shown(&edit.print))?;
        }
        if self.verdict == CodeVerdict::Different && self.ended_early {
            writeln!(f, "not all changes were tried: the work was used up before")?;
        } else if self.verdict == CodeVerdict::Different {
            let missing = match (&self.code_edit, &self.print_edit) {
                (None, None) => {
                    Some("no single change of the code or of the print makes them equal")
                }
                (None, Some(_)) => Some("no single change of the code makes them equal"),
                (Some(_), None) => Some("no single change of the print makes them equal"),
                _ => None,
            };
            if let Some(missing) = missing {
                writeln!(f, "{missing}, of those that are tried")?;
            }
        }
        writeln!(
            f,
            "the code was read as exact mathematics: rounding and overflow are out of scope"
        )
    }
}

fn alone(is_unique: bool) -> &'static str {
    match is_unique {
        true => "",
        false => " (there are other changes as small)",
    }
}

/// The change at its line, with carets.
impl fmt::Display for CodeEdit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let width = self.line.to_string().len();
        writeln!(
            f,
            "in the code: `{}` for `{}`{}",
            self.replacement,
            self.written,
            alone(self.is_unique)
        )?;
        writeln!(f, "  {} | {}", self.line, self.line_now)?;
        let indent: String = self
            .line_now
            .chars()
            .take(self.column - 1)
            .map(|c| if c == '\t' { '\t' } else { ' ' })
            .collect();
        let rest = self
            .line_now
            .chars()
            .count()
            .saturating_sub(self.column - 1);
        let carets = "^".repeat(self.length.min(rest).max(1));
        writeln!(f, "  {:width$} | {indent}{carets}", "")?;
        if let Some(then) = &self.line_then {
            writeln!(f, "  {:width$} | {then}", "")?;
        }
        if !self.conditions.is_empty() {
            writeln!(f, "  then equal where {}", self.conditions.join(" and "))?;
        }
        Ok(())
    }
}
