//! `lint`: a drawing against the rules of services that cut sheet.

use crate::design::unit;
use crate::exit::{Exit, Failure};
use crate::format::{Format, pretty_json};
use crate::input;
use crate::standard;
use crate::terminal::print;
use clap::Args;
use std::path::{Path, PathBuf};
use torse_designs::DesignError;
use torse_designs::lint::{LintDemand, LintRules, lint};
use torse_exchange::{LengthUnit, MAX_FILE_BYTES};

/// Check a drawing against the rules that cutting services publish.
///
/// torse checks that contours are closed, that no line lies twice, that there is no text, that the file states its unit
/// and has one part, and that holes and webs suit the thickness. The exit code is 1 if a rule is broken; the answer says
/// where and why.
#[derive(Args)]
pub struct Lint {
    /// Check this DXF or SVG file; - for standard input
    file: PathBuf,
    /// Set the thickness of the sheet in millimetres, on which some rules depend
    #[arg(long, value_name = "MM", value_parser = positive)]
    thickness: Option<f64>,
    /// Check against the rules of this TOML file (- for standard input) instead of those that torse has
    #[arg(long, value_name = "FILE")]
    rules: Option<PathBuf>,
    /// Set the unit of a file that states none: mm, cm, m, in, ft, ...
    #[arg(long, value_name = "UNIT", value_parser = unit)]
    unit: Option<LengthUnit>,
    /// Set the format of the answer
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

fn positive(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok();
    let number = number.filter(|number| number.is_finite() && *number > 0.0);
    number.ok_or_else(|| "a positive number of millimetres is wanted".to_owned())
}

impl Lint {
    /// Prints the table of rules and the faults.
    pub fn run(&self) -> Result<Exit, Failure> {
        let wrong = |path: &Path, reason: String| DesignError::Pattern {
            path: path.display().to_string(),
            reason,
        };
        let rules = match &self.rules {
            None => LintRules::published().map_err(|reason| wrong(Path::new("rules"), reason))?,
            Some(path) => {
                let text = String::from_utf8(input::bytes(path, MAX_FILE_BYTES)?)
                    .map_err(|e| wrong(path, e.to_string()))?;
                LintRules::parse(&text).map_err(|reason| wrong(path, reason))?
            }
        };
        let demand = LintDemand {
            thickness: self.thickness,
            unit: self.unit.clone(),
        };
        let name = standard::name(&self.file);
        let report = lint(
            &name,
            &input::bytes(&self.file, MAX_FILE_BYTES)?,
            &rules,
            &demand,
        )?;
        print(&match self.format {
            Format::Text => report.text(),
            Format::Json => pretty_json(&report)?,
        })?;
        Ok(if report.passes() {
            Exit::AsExpected
        } else {
            Exit::Differs
        })
    }
}
