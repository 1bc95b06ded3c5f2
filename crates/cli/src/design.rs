//! `inspect`, `fold`, `export`, `eval`, `draw`: design files in, answers and files out.

use crate::exit::{Exit, Failure};
use crate::format::{Format, json_line, pretty_json};
use crate::input;
use crate::standard::{self, is_standard};
use crate::terminal::{complain, print, print_bytes, remark};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};
use std::io::Read;
use std::path::{Path, PathBuf};
use torse_designs::eval::{EvalPlaces, csv, eval};
use torse_designs::export::{ENDINGS, PATTERNS, bytes, ending};
use torse_designs::fold::{fold_back, fold_text};
use torse_designs::inspect::{DesignReport, inspect, inspect_quickly, overview, table};
use torse_designs::lines::wrapped;
use torse_designs::listing::{FileListing, list};
use torse_designs::unroll::{Demand, Flattening, development_note};
use torse_designs::{Design, DesignError, draw, load_with_settings};
use torse_exchange::{FileKind, LengthUnit, MAX_FILE_BYTES, write_file};

/// Measure a design: can it be made? Or list the contents of a file of another program.
///
/// For each patch, torse shows whether it is developable and regular, the distance of the edge of regression, the
/// lengths of its rulings, its twist and its smallest radius; for each joint, its continuity and beta values. The exit
/// code is 1 if a tolerance of the file is missed. For a STEP, IGES, DXF, SVG, CSV, OBJ or STL file, torse lists
/// curves, faces and meshes.
#[derive(Args)]
pub struct Inspect {
    /// The design files, or a file of another program; - for standard input. Of several each has a line: of a table, or,
    /// with --format json, of JSON
    #[arg(required = true)]
    designs: Vec<PathBuf>,
    /// Set a number of [let] to another value; repeatable
    #[arg(long, value_name = "NAME=NUMBER", value_parser = setting)]
    set: Vec<(String, f64)>,
    /// Set the unit of a file of another program that has none: mm, cm, m, in, ft, ...
    #[arg(long, value_name = "UNIT", value_parser = unit)]
    unit: Option<LengthUnit>,
    /// Measure only, without bounds and proofs
    #[arg(long)]
    quick: bool,
    /// Set the format of the answer
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

/// A design file, with numbers of its own set anew.
#[derive(Args)]
pub(crate) struct DesignFile {
    /// The design file; - for standard input
    design: PathBuf,
    /// Set a number of [let] to another value; repeatable
    #[arg(long, value_name = "NAME=NUMBER", value_parser = setting)]
    set: Vec<(String, f64)>,
}

impl DesignFile {
    pub(crate) fn open(&self) -> Result<Design, Failure> {
        design(&self.design, &self.set)
    }
}

/// Options of a pattern.
#[derive(Args)]
pub(crate) struct Pattern {
    /// Unroll even a surface that is not developable, if no line changes its length by more than this share; the file
    /// says so
    #[arg(long, value_name = "STRAIN", default_value_t = 0.0)]
    allow_strain: f64,
    /// Choose how to unroll a surface that is not exactly developable: both edges keep their lengths, one of them keeps
    /// its length and curvature, or neither does
    #[arg(long, value_name = "NAME", value_parser = named(Flattening::ALL), default_value = "edges")]
    development: Flattening,
    /// Draw this many rulings of each patch
    #[arg(long, value_name = "NUMBER")]
    rulings: Option<usize>,
    /// Use only this chain or patch
    #[arg(long, value_name = "NAME")]
    only: Option<String>,
}

impl Pattern {
    /// Whether the number of rulings is set.
    pub(crate) fn sets_rulings(&self) -> bool {
        self.rulings.is_some()
    }

    pub(crate) fn demand(&self) -> Demand {
        Demand {
            allow_strain: self.allow_strain,
            rulings: self.rulings,
            only: self.only.clone(),
            development: self.development,
        }
    }
}

/// Takes the names of values and nothing else; help and completions list them.
pub(crate) fn named<T: Copy + Send + Sync + 'static>(
    all: impl IntoIterator<Item = (&'static str, T)>,
) -> impl TypedValueParser<Value = T> {
    let all: Vec<(&'static str, T)> = all.into_iter().collect();
    let names = PossibleValuesParser::new(all.iter().map(|(name, _)| *name));
    names.try_map(move |name| {
        let found = all.iter().find(|(own, _)| *own == name);
        found
            .map(|(_, value)| *value)
            .ok_or("there is no such value")
    })
}

/// Takes one of the endings of files.
pub(crate) fn ending_among(
    all: impl IntoIterator<Item = &'static str>,
) -> impl TypedValueParser<Value = String> {
    PossibleValuesParser::new(all)
}

/// Fold a pattern file back into space and compare it with its design.
///
/// torse reads outline, rulings and bend angles from the DXF or SVG file alone. The exit code is 1 if the folded points
/// miss the design.
#[derive(Args)]
pub struct Fold {
    #[command(flatten)]
    file: DesignFile,
    /// Read this pattern, a DXF or SVG file written by `unroll --for fold`; - for standard input
    #[arg(long, value_name = "FILE")]
    pattern: PathBuf,
    /// Set the format of the answer
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

/// Write a design as a pattern, a mesh or a CAD model; the file extension chooses.
///
/// Extensions: .dxf .svg (flat pattern); .stl .obj .ply .3mf .glb (mesh, a solid if the design has a thickness); .step
/// .stp .iges .igs (surfaces, exact if they are rational, otherwise within the tolerance `surface`).
#[derive(Args)]
pub struct Export {
    #[command(flatten)]
    file: DesignFile,
    /// Write this file, or to standard output if it is - (with --as)
    #[arg(long, value_name = "FILE")]
    to: PathBuf,
    /// Set the format if the file name has no known extension
    #[arg(long, value_name = "ENDING", value_parser = ending_among(ENDINGS.iter().copied()), ignore_case = true)]
    r#as: Option<String>,
    #[command(flatten)]
    pattern: Pattern,
}

/// Evaluate patches: points, normals, curvatures, and places on the pattern.
#[derive(Args)]
#[command(group = clap::ArgGroup::new("where").required(true))]
pub struct Eval {
    #[command(flatten)]
    file: DesignFile,
    /// Evaluate at this place: ruling and share of the ruling, both from 0 to 1; repeatable
    #[arg(long, value_name = "U,V", value_parser = place, group = "where")]
    at: Vec<[f64; 2]>,
    /// Evaluate on a grid with this many equal steps across and along the rulings
    #[arg(long, value_name = "MxN", value_parser = grid, group = "where")]
    grid: Option<(usize, usize)>,
    /// Use only this patch
    #[arg(long, value_name = "NAME")]
    patch: Option<String>,
    /// Set the format of the answer
    #[arg(long, value_enum, default_value_t = Table::Csv)]
    format: Table,
}

/// How numbers are shown.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Table {
    /// Comma-separated values with a header
    Csv,
    /// A list of objects
    Json,
}

/// Draw a design and its pattern: PNG, SVG, an interactive page, or a GIF; the file extension chooses.
///
/// The GIF shows how the sheet bends from its flat pattern to its shape and back.
#[derive(Args)]
pub struct Draw {
    #[command(flatten)]
    file: DesignFile,
    /// Write the picture to this .png, .svg, .html or .gif file, or to standard output if it is - (with --as)
    #[arg(long, value_name = "FILE")]
    to: PathBuf,
    /// Set the format if the file name has no known extension
    #[arg(long, value_name = "ENDING", value_parser = ending_among(draw::ENDINGS.iter().copied()), ignore_case = true)]
    r#as: Option<String>,
    #[command(flatten)]
    pattern: Pattern,
}

fn place(text: &str) -> Result<[f64; 2], String> {
    let wanted = || "expected two numbers, such as 0.5,0.25".to_owned();
    let (u, v) = text.split_once(',').ok_or_else(wanted)?;
    let number = |part: &str| part.trim().parse::<f64>().map_err(|_| wanted());
    Ok([number(u)?, number(v)?])
}

fn grid(text: &str) -> Result<(usize, usize), String> {
    let wanted = || "expected two numbers of steps, such as 32x4".to_owned();
    let (m, n) = text.split_once('x').ok_or_else(wanted)?;
    let number = |part: &str| part.trim().parse::<usize>().map_err(|_| wanted());
    Ok((number(m)?, number(n)?))
}

pub(crate) fn unit(text: &str) -> Result<LengthUnit, String> {
    let wanted = || format!("unknown unit of length `{text}`: use mm, cm, m, in, ft, ...");
    LengthUnit::named(text).ok_or_else(wanted)
}

/// Reads the design of a file.
pub(crate) fn design(path: &Path, settings: &[(String, f64)]) -> Result<Design, Failure> {
    of_stream(path, input::open(path)?, settings)
}

/// Reads a design from a stream that was opened by this path.
fn of_stream(path: &Path, from: impl Read, settings: &[(String, f64)]) -> Result<Design, Failure> {
    let shown = if is_standard(path) {
        Path::new("stdin")
    } else {
        path
    };
    Ok(load_with_settings(shown, from, settings)?)
}

/// Says on standard error which faces of a file of another program have no patch.
pub(crate) fn tell_left_out(design: &Design) {
    let left_out = &design.left_out;
    if left_out.is_empty() {
        return;
    }
    let count = match left_out.len() {
        1 => "1 face is".to_owned(),
        count => format!("{count} faces are"),
    };
    remark(&format!("{count} left out of {}:\n", design.name));
    for face in left_out {
        remark(&wrapped(&format!("{}: ", face.name), &face.reason));
    }
}

/// A name and a number: R=90.
pub(crate) fn setting(text: &str) -> Result<(String, f64), String> {
    let wanted = || "a name and a number are wanted: R=90".to_owned();
    let (name, value) = text.split_once('=').ok_or_else(wanted)?;
    let value = value.trim().parse::<f64>().ok();
    let value = value.filter(|value| value.is_finite() && value.abs() < 1e15);
    Ok((name.trim().to_owned(), value.ok_or_else(wanted)?))
}

/// Writes a file whole or not at all; - means standard output.
pub(crate) fn write(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    if is_standard(path) {
        return print_bytes(bytes);
    }
    write_file(path, bytes).map_err(DesignError::from)?;
    Ok(())
}

/// Shows an answer; on standard error if the file went to standard output.
pub(crate) fn answer(file: &Path, text: &str) -> Result<(), Failure> {
    if is_standard(file) {
        remark(text);
        return Ok(());
    }
    print(text)
}

/// Returns the format of a written file: its extension, or the value of `--as`.
pub(crate) fn format_of(
    path: &Path,
    named: Option<&str>,
    known: &'static [&'static str],
) -> Result<&'static str, Failure> {
    let name = named.map(|name| PathBuf::from(format!("file.{name}")));
    Ok(ending(name.as_deref().unwrap_or(path), known)?)
}

/// Returns 0 if every tolerance is met, else 1.
pub(crate) fn met(missed: &[String]) -> Exit {
    if missed.is_empty() {
        Exit::AsExpected
    } else {
        Exit::Differs
    }
}

impl Inspect {
    /// Measures the design, or each of several.
    pub fn run(&self) -> Result<Exit, Failure> {
        if let [path] = self.designs.as_slice() {
            let bytes = input::bytes(path, MAX_FILE_BYTES)?;
            if let Some(listing) = self.listing(path, &bytes)? {
                print(&match self.format {
                    Format::Text => listing.text(),
                    Format::Json => pretty_json(&listing)?,
                })?;
                return Ok(Exit::AsExpected);
            }
            let report = self.report(path, bytes.as_slice())?;
            print(&match self.format {
                Format::Text => table(&report),
                Format::Json => pretty_json(&report)?,
            })?;
            return Ok(met(&report.missed));
        }
        // What is wrong with one is told where it is found, and the others are measured all the same.
        let (mut reports, mut gravest) = (Vec::new(), Exit::AsExpected);
        for path in &self.designs {
            match input::open(path).and_then(|from| self.report(path, from)) {
                Ok(report) => {
                    gravest = gravest.max(met(&report.missed));
                    reports.push(report);
                }
                Err(failure) => {
                    gravest = gravest.max(failure.exit());
                    complain(&failure);
                }
            }
        }
        if reports.is_empty() {
            return Ok(gravest);
        }
        print(&match self.format {
            Format::Text => overview(&reports),
            Format::Json => {
                let lines: Result<String, _> = reports.iter().map(json_line).collect();
                lines?
            }
        })?;
        Ok(gravest)
    }

    fn report(&self, path: &Path, from: impl Read) -> Result<DesignReport, Failure> {
        let design = of_stream(path, from, &self.set)?;
        Ok(if self.quick {
            inspect_quickly(&design)?
        } else {
            inspect(&design)?
        })
    }

    /// What is in a file of another program; nothing for a design.
    fn listing(&self, path: &Path, bytes: &[u8]) -> Result<Option<FileListing>, Failure> {
        let name = standard::name(path);
        if !FileKind::of_file(&name, bytes).is_read() {
            return Ok(None);
        }
        let listing = list(&name, bytes, self.unit.as_ref());
        let failed = |reason| DesignError::Listing {
            path: name.clone(),
            reason,
        };
        Ok(Some(listing.map_err(failed)?))
    }
}

impl Fold {
    /// Folds the pattern and compares.
    pub fn run(&self) -> Result<Exit, Failure> {
        let report = match is_standard(&self.pattern) {
            true => {
                let text = input::text(&self.pattern)?;
                let name = match FileKind::detect(text.as_bytes()) {
                    FileKind::Svg => "stdin.svg",
                    _ => "stdin",
                };
                fold_text(&self.file.open()?, name, &text)?
            }
            false => {
                ending(&self.pattern, PATTERNS)?;
                // It is looked for before the design is read.
                drop(input::open(&self.pattern)?);
                fold_back(&self.file.open()?, &self.pattern)?
            }
        };
        print(&match self.format {
            Format::Text => report.text(),
            Format::Json => pretty_json(&report)?,
        })?;
        Ok(met(&report.missed))
    }
}

impl Export {
    /// Writes the file.
    pub fn run(&self) -> Result<Exit, Failure> {
        let ending = format_of(&self.to, self.r#as.as_deref(), ENDINGS)?;
        let design = self.file.open()?;
        write(&self.to, &bytes(&design, ending, &self.pattern.demand())?)?;
        if let Some(note) = development_note(&design).filter(|_| PATTERNS.contains(&ending)) {
            remark(&format!("note: {note}\n"));
        }
        tell_left_out(&design);
        Ok(Exit::AsExpected)
    }
}

impl Eval {
    /// Prints the values.
    pub fn run(&self) -> Result<Exit, Failure> {
        let at = match self.grid {
            Some((m, n)) => EvalPlaces::Grid(m, n),
            None => EvalPlaces::Places(self.at.clone()),
        };
        let rows = eval(&self.file.open()?, self.patch.as_deref(), &at)?;
        print(&match self.format {
            Table::Csv => csv(&rows),
            Table::Json => pretty_json(&rows)?,
        })?;
        Ok(Exit::AsExpected)
    }
}

impl Draw {
    /// Writes the picture.
    pub fn run(&self) -> Result<Exit, Failure> {
        let ending = format_of(&self.to, self.r#as.as_deref(), draw::ENDINGS)?;
        let (design, demand) = (self.file.open()?, self.pattern.demand());
        let bytes = match ending {
            "html" => draw::page(&design, &demand)?.into_bytes(),
            "svg" => draw::picture(&design, &demand)?.svg.into_bytes(),
            "gif" => draw::bending(&design, &demand)?,
            _ => {
                let picture = draw::picture(&design, &demand)?;
                picture.png().map_err(DesignError::from)?
            }
        };
        write(&self.to, &bytes)?;
        tell_left_out(&design);
        Ok(Exit::AsExpected)
    }
}
