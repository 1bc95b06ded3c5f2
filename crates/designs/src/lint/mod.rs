//! Checks any drawing against the rules that cutting services publish for the files they take.
//!
//! A file fails a rule with the place and the reason. What is curved is looked at through points on it, and a bound is
//! missed only where it is missed by more than these can be off: a reported failure is certain, a narrow pass is not.

mod contours;
mod judge;
mod necks;
mod pairs;
mod rules;
mod trace;

pub use rules::{Check, LintRule, LintRules};

use crate::error::DesignError;
use crate::lines::{columns, wrapped};
use crate::numbers::number;
use judge::Judge;
use serde::Serialize;
use torse_exchange::LengthUnit;
use trace::check_flat;

/// What is asked about a drawing.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct LintDemand {
    /// The thickness of the sheet in millimetres, where it is known.
    pub thickness: Option<f64>,
    /// The unit of a file that states none.
    pub unit: Option<LengthUnit>,
}

/// A place where a file breaks a rule.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct RuleFault {
    /// The check.
    pub check: Check,
    /// The point in millimetres, where there is one; y goes down in SVG, as the file has it.
    pub at: Option<[f64; 2]>,
    /// The line and entity of the file, where there is one.
    pub place: Option<String>,
    /// What is wrong, in words.
    pub reason: String,
    /// What was measured, where something was.
    pub measured: Option<f64>,
    /// The bound that it misses.
    pub bound: Option<f64>,
    /// Who publishes the rule.
    pub source: String,
}

/// How a rule came out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum RuleOutcome {
    /// The file keeps it.
    Kept,
    /// The file breaks it.
    Broken,
    /// It depends on a thickness that is not known, or there was too much to look at.
    NotJudged,
}

/// A rule and how it came out.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct RuleRow {
    /// The check.
    pub check: Check,
    /// How it came out.
    pub outcome: RuleOutcome,
    /// At how many places the file breaks it.
    pub faults: usize,
    /// What the rule is about too, and the check does not look at.
    pub not_looked_at: Option<&'static str>,
    /// Who publishes the rule, and where.
    pub source: String,
    /// Where it is published.
    pub url: Option<String>,
}

/// What is in a drawing, and what is wrong with it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct LintReport {
    /// The name of the file.
    pub file: String,
    /// The unit, and who says so.
    pub unit: String,
    /// The same for people, above lengths in millimetres.
    #[serde(skip)]
    lengths: String,
    /// How many closed contours are cut.
    pub contours: usize,
    /// Width and height of the box around them.
    pub size: Option<[f64; 2]>,
    /// The rules in the order of their file.
    pub rules: Vec<RuleRow>,
    /// What is wrong, rule by rule.
    pub faults: Vec<RuleFault>,
}

/// The most faults of one rule that are shown in words.
const MAX_SHOWN: usize = 10;

impl LintReport {
    /// Returns whether no rule is broken.
    #[must_use]
    pub fn passes(&self) -> bool {
        self.rules
            .iter()
            .all(|rule| rule.outcome != RuleOutcome::Broken)
    }

    /// Returns the report for people, in lines of at most 100 columns.
    #[must_use]
    pub fn text(&self) -> String {
        let size = match self.size {
            Some([width, height]) => format!(", {} x {} mm", number(width), number(height)),
            None => String::new(),
        };
        let plural = if self.contours == 1 { "" } else { "s" };
        let mut text = wrapped(
            &format!("{}: ", self.file),
            &format!(
                "{} closed contour{plural}{size}; {}",
                self.contours, self.lengths
            ),
        );
        let rows: Vec<Vec<String>> = self
            .rules
            .iter()
            .map(|rule| {
                let outcome = match rule.outcome {
                    RuleOutcome::Kept => match rule.not_looked_at {
                        Some(rest) => format!("kept; {rest} not looked at"),
                        None => "kept".to_owned(),
                    },
                    RuleOutcome::Broken => format!("BROKEN {}", rule.faults),
                    RuleOutcome::NotJudged => "not judged".to_owned(),
                };
                vec![rule.check.name().to_owned(), outcome, rule.source.clone()]
            })
            .collect();
        text += &columns(&["rule", "outcome", "source"], &rows);
        let mut shown = 0;
        for (index, fault) in self.faults.iter().enumerate() {
            let before = index.checked_sub(1).and_then(|last| self.faults.get(last));
            let same = before.is_some_and(|b| b.check == fault.check && b.source == fault.source);
            shown = if same { shown + 1 } else { 1 };
            if shown > MAX_SHOWN {
                continue;
            }
            let mut words = String::new();
            if let Some([x, y]) = fault.at {
                words += &format!("at ({}, {}): ", number(x), number(y));
            }
            words += &fault.reason;
            if let Some(place) = &fault.place {
                words += &format!(" ({place})");
            }
            text += &wrapped(&format!("{}: ", fault.check.name()), &words);
        }
        for rule in self.rules.iter().filter(|rule| rule.faults > MAX_SHOWN) {
            let more = rule.faults - MAX_SHOWN;
            text += &wrapped(
                &format!("{}: ", rule.check.name()),
                &format!("and {more} more"),
            );
        }
        text
    }
}

/// Checks a DXF or SVG file against rules; `name` is that of the file.
///
/// # Errors
/// [`DesignError::Listing`] for a file that cannot be read, and for curves that leave the plane of the drawing.
///
/// ```
/// use torse_designs::lint::{LintDemand, LintRules, lint};
/// use torse_exchange::{Drawing, Layer, dxf};
/// let rules = LintRules::published()?;
/// let mut part = Drawing::default();
/// part.polygon(Layer::Outline, &[[0.0, 0.0], [80.0, 0.0], [80.0, 40.0], [0.0, 40.0]])?;
/// part.circle(Layer::Outline, [20.0, 20.0], 1.5)?;
/// let text = dxf(&part)?;
/// let thin = LintDemand { thickness: Some(2.0), unit: None };
/// assert!(lint("part.dxf", text.as_bytes(), &rules, &thin)?.passes());
/// // A hole of 3 mm is too narrow for a sheet of 4 mm.
/// let thick = LintDemand { thickness: Some(4.0), unit: None };
/// let report = lint("part.dxf", text.as_bytes(), &rules, &thick)?;
/// assert_eq!(report.faults.len(), 1);
/// assert!(report.faults[0].at.is_some_and(|[x, y]| (x - 20.0).abs() < 1e-9 && (y - 20.0).abs() < 1e-9));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn lint(
    name: &str,
    bytes: &[u8],
    rules: &LintRules,
    demand: &LintDemand,
) -> Result<LintReport, DesignError> {
    let failed = |reason| DesignError::Listing {
        path: name.to_owned(),
        reason,
    };
    let found = torse_exchange::read(name, bytes, demand.unit.as_ref()).map_err(failed)?;
    check_flat(&found, rules.joined_within).map_err(failed)?;
    let judge =
        Judge::new(&found, rules, demand.thickness).map_err(|reason| DesignError::Patch {
            patch: name.to_owned(),
            reason,
        })?;
    let (rows, faults) = judge.rules();
    Ok(LintReport {
        file: name.to_owned(),
        unit: found.unit.to_string(),
        lengths: found.unit.above_millimetres(),
        contours: judge.contours.len(),
        size: judge.size(),
        rules: rows,
        faults,
    })
}
