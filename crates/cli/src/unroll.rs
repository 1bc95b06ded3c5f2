//! `unroll`: from a design to what is cut and bent.

use crate::design::{
    DesignFile, Format, Pattern, answer, format_of, is_standard, json, met, named, write,
};
use crate::exit::{Exit, Failure};
use crate::terminal::remark;
use clap::Args;
use serde::Serialize;
use std::path::{Path, PathBuf};
use torse_designs::export::PATTERNS;
use torse_designs::inspect::{inspect_for, inspect_unrolled, missed_line};
use torse_designs::unroll::{PartsList, Purpose, Summary, drawing, parts, unroll};
use torse_designs::{Design, DesignError};
use torse_exchange::{Drawing, dxf, svg};

/// Unroll a design to what is cut of it, DXF or SVG.
///
/// Each part is turned to its smallest box and has a file of its own: of several, the name of each is added to that of the
/// file. Refuses, with exit code 1 and without a file, what is not developable within tolerance, has its edge of regression
/// inside, an outline that crosses itself, or a bend that has no blank. A design that misses another tolerance of its file
/// is written, what it misses is said on standard error, and the exit code is 1.
#[derive(Args)]
pub struct Unroll {
    #[command(flatten)]
    file: DesignFile,
    /// Where the part goes: a file ending in .dxf or .svg; - for standard output, with --as
    #[arg(long, value_name = "FILE")]
    to: PathBuf,
    /// The format, where the name of the file does not end in it: dxf or svg
    #[arg(long, value_name = "ENDING")]
    r#as: Option<String>,
    /// What the file is for: cut (closed contours alone), bend (the bend lines of tools too), sew (the
    /// notches of seams too), fold (one file of all pieces
    /// with every ruling and its angle, as `torse fold` reads it)
    #[arg(long = "for", value_name = "PURPOSE", value_parser = purpose, default_value = "cut")]
    purpose: Purpose,
    /// A table of the parts, as comma-separated values
    #[arg(long, value_name = "FILE")]
    parts: Option<PathBuf>,
    #[command(flatten)]
    pattern: Pattern,
    /// How the answer is shown
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

/// A purpose by its name.
fn purpose(name: &str) -> Result<Purpose, String> {
    named(&Purpose::ALL, name, "the purposes are")
}

/// The answer for programs: the patterns, and the parts that were made of them.
#[derive(Serialize)]
struct Answer<'a> {
    #[serde(flatten)]
    summary: &'a Summary,
    parts: &'a PartsList,
}

/// The text of a drawing in a format.
fn text_of(drawing: &Drawing, ending: &str) -> Result<String, DesignError> {
    let text = match ending {
        "dxf" => dxf(drawing),
        _ => svg(drawing),
    };
    Ok(text?)
}

/// The file of one of several parts: the name of the part goes before the ending. What no file name may hold becomes `_`.
fn file_of(to: &Path, part: &str, several: bool) -> PathBuf {
    if !several {
        return to.to_owned();
    }
    let safe: String = part
        .chars()
        .map(|c| {
            if c.is_alphanumeric() || "-_.".contains(c) {
                c
            } else {
                '_'
            }
        })
        .collect();
    let mut name = to.file_stem().unwrap_or_default().to_owned();
    name.push("-");
    name.push(safe);
    if let Some(ending) = to.extension() {
        name.push(".");
        name.push(ending);
    }
    to.with_file_name(name)
}

impl Unroll {
    /// Writes what the purpose asks for and says what it promises.
    pub fn run(&self) -> Result<Exit, Failure> {
        let ending = format_of(&self.to, self.r#as.as_deref(), PATTERNS)?;
        let design = self.file.open()?;
        let pieces = unroll(&design, &self.pattern.demand())?;
        let made = parts(&design, &pieces);
        let summary = Summary::new(&design, &pieces);
        if self.purpose == Purpose::Fold {
            // The pattern is the design's, and needs no blank.
            let list = made.map(|parts| PartsList::new(&design, &parts)).ok();
            let text = text_of(&drawing(&design, &pieces)?, ending)?;
            write(&self.to, text.as_bytes())?;
            return self.end(
                &design,
                &summary,
                list.as_ref().unwrap_or(&PartsList::new(&design, &[])),
            );
        }
        let made = made?;
        let mut list = PartsList::new(&design, &made);
        self.check_names(&design, &list)?;
        let mut files = Vec::new();
        for (part, row) in made.iter().zip(&mut list.parts) {
            let file = file_of(&self.to, &part.name, made.len() > 1);
            files.push((file.clone(), text_of(&part.drawing(self.purpose)?, ending)?));
            row.file = file
                .file_name()
                .map(|name| name.to_string_lossy().into_owned());
        }
        for (file, text) in &files {
            write(file, text.as_bytes())?;
        }
        if let Some(file) = &self.parts {
            write(file, list.csv().as_bytes())?;
        }
        self.end(&design, &summary, &list)
    }

    /// Several parts have several files: no standard output, and no two of one name.
    fn check_names(&self, design: &Design, list: &PartsList) -> Result<(), Failure> {
        let names: Vec<&str> = list.parts.iter().map(|part| part.name.as_str()).collect();
        let reason = if names.len() > 1 && is_standard(&self.to) {
            "several parts have several files, and standard output is one: ask for one with --only"
                .to_owned()
        } else {
            let files: Vec<PathBuf> = names
                .iter()
                .map(|name| file_of(&self.to, name, names.len() > 1))
                .collect();
            let twice = (1..files.len())
                .find(|k| files.get(..*k).is_some_and(|all| all.contains(&files[*k])));
            match twice {
                Some(k) => format!(
                    "two parts would be written to {}: ask for each with --only",
                    files[k].display()
                ),
                None => return Ok(()),
            }
        };
        Err(DesignError::Parts {
            design: design.name.clone(),
            reason,
        }
        .into())
    }

    /// Says what was written, and what the design misses all the same.
    fn end(&self, design: &Design, summary: &Summary, list: &PartsList) -> Result<Exit, Failure> {
        let text = match self.format {
            Format::Text if self.purpose == Purpose::Fold => summary.text(),
            Format::Text => list.text() + &summary.text(),
            Format::Json => json(&Answer {
                summary,
                parts: list,
            })?,
        };
        answer(&self.to, &text)?;
        let demand = self.pattern.demand();
        // A pattern to fold is written where a blank is refused; all other parts were made.
        let report = match self.purpose {
            Purpose::Fold => inspect_for(design, &demand)?,
            Purpose::Cut | Purpose::Bend | Purpose::Sew => inspect_unrolled(design, &demand)?,
        };
        let missed = report.missed;
        for reason in &missed {
            remark(&missed_line(reason));
        }
        Ok(met(&missed))
    }
}
