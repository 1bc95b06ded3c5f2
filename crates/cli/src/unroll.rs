//! `unroll`: from a design to what is cut and bent.

use crate::design::{
    DesignFile, Pattern, answer, ending_among, format_of, met, named, tell_left_out, write,
};
use crate::exit::{Exit, Failure};
use crate::format::{Format, pretty_json};
use crate::standard::is_standard;
use crate::terminal::remark;
use clap::Args;
use serde::Serialize;
use std::path::{Path, PathBuf};
#[cfg(feature = "pdf")]
use torse_designs::bench::{PaperSize, bench_sheets, tiled_parts};
use torse_designs::export::PATTERNS;
use torse_designs::inspect::{inspect_for, inspect_unrolled, missed_line};
use torse_designs::lines::wrapped;
#[cfg(feature = "pdf")]
use torse_designs::unroll::FlatPiece;
use torse_designs::unroll::{
    CutOptions, Grain, Part, PartsList, PatternSummary, Purpose, drawing, parts_with, unroll,
};
use torse_designs::{Design, DesignError, LeftOut};
use torse_exchange::{Drawing, dxf, svg};
#[cfg(feature = "pdf")]
use torse_report::Manuscript;

/// Unroll a design into cut files, DXF or SVG.
///
/// Each part is turned to its smallest box and gets its own file; if there are several, the name of the part is added to
/// the name of the file. torse writes nothing, and ends with exit code 1, if a patch is not developable within its
/// tolerance, if the edge of regression lies in a patch, if an outline crosses itself, or if a bend has no blank. If the
/// design misses another tolerance of its file, torse writes the parts, says on standard error what is missed, and ends
/// with exit code 1.
#[derive(Args)]
pub struct Unroll {
    #[command(flatten)]
    file: DesignFile,
    /// Write to this file: .dxf or .svg, for sheets of paper .pdf; - for standard output (with --as)
    #[arg(long, value_name = "FILE")]
    to: PathBuf,
    /// Set the format if the file name has no known extension
    #[arg(long, value_name = "EXTENSION", value_parser = ending_among(ALL), ignore_case = true)]
    r#as: Option<String>,
    /// Set what the file is for: cut (closed contours alone), bend (the bend lines of tools too), sew (the notches of seams
    /// too), fold (one file of all pieces with every ruling and its angle, as `torse fold` reads it), bench (a sheet for the
    /// fitter with dimensions, tables and a view, PDF or SVG), paper (true size on pages, PDF)
    #[arg(long = "for", value_name = "PURPOSE", value_parser = named(outputs()), default_value = "cut")]
    output: Output,
    /// Set the paper of `--for bench` and `--for paper` [default: a4]
    #[cfg(feature = "pdf")]
    #[arg(long, value_name = "SIZE", value_parser = named(PaperSize::ALL))]
    page: Option<PaperSize>,
    /// Write a table of the parts to this file, as comma-separated values; - for standard output
    #[arg(long, value_name = "FILE")]
    parts: Option<PathBuf>,
    /// Set the width of the cut in millimetres [default: 0]: outlines are moved outwards by half of it, openings inwards
    #[arg(long, value_name = "MM")]
    kerf: Option<f64>,
    /// Lay parts along (first ruling to last along the drawing) or across; without this, each is turned to its smallest box
    #[arg(long, value_name = "WAY", value_parser = named(Grain::ALL))]
    grain: Option<Grain>,
    #[command(flatten)]
    pattern: Pattern,
    /// Set the format of the answer
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

/// What is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Output {
    /// Drawings for a purpose.
    Drawings(Purpose),
    /// A sheet for the fitter.
    #[cfg(feature = "pdf")]
    Bench,
    /// True size on pages.
    #[cfg(feature = "pdf")]
    Paper,
}

impl Output {
    /// What its drawings are for; nothing for sheets and pages, which show everything.
    fn purpose(self) -> Option<Purpose> {
        match self {
            Self::Drawings(purpose) => Some(purpose),
            #[cfg(feature = "pdf")]
            Self::Bench | Self::Paper => None,
        }
    }

    /// The endings of its files.
    fn endings(self) -> &'static [&'static str] {
        match self {
            Self::Drawings(_) => PATTERNS,
            #[cfg(feature = "pdf")]
            Self::Bench => &["pdf", "svg"],
            #[cfg(feature = "pdf")]
            Self::Paper => &["pdf"],
        }
    }
}

/// The purposes that cut along the outline.
const CUT: &[&str] = &["cut", "bend", "sew"];
/// The purposes that have parts; a pattern to fold is the design's.
const PARTED: &[&str] = &["cut", "bend", "sew", "bench", "paper"];
/// The purposes that draw rulings.
const RULED: &[&str] = &["fold", "bench", "paper"];
/// The purposes that have pages.
#[cfg(feature = "pdf")]
const PAGED: &[&str] = &["bench", "paper"];

/// The endings of all purposes.
const ALL: [&str; 3] = ["dxf", "svg", "pdf"];

/// Files with their bytes.
type Files = Vec<(PathBuf, Vec<u8>)>;

/// What can be written, by its names.
fn outputs() -> impl Iterator<Item = (&'static str, Output)> {
    let drawings = Purpose::ALL.map(|(name, purpose)| (name, Output::Drawings(purpose)));
    #[cfg(feature = "pdf")]
    let sheets = [("bench", Output::Bench), ("paper", Output::Paper)];
    #[cfg(not(feature = "pdf"))]
    let sheets: [(&str, Output); 0] = [];
    drawings.into_iter().chain(sheets)
}

/// The answer for programs: the patterns, and the parts that were made of them.
#[derive(Serialize)]
struct Answer<'a> {
    #[serde(flatten)]
    summary: &'a PatternSummary,
    parts: &'a PartsList,
    /// The faces of a file of another program that have no pattern; not there where there are none.
    #[serde(skip_serializing_if = "<[LeftOut]>::is_empty")]
    left_out: &'a [LeftOut],
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
        self.check_options()?;
        let ending = self.ending()?;
        let listed_there = self.parts.as_deref().is_some_and(is_standard);
        if listed_there && is_standard(&self.to) {
            return Err(Failure::BothStandard);
        }
        let design = self.file.open()?;
        let pieces = unroll(&design, &self.pattern.demand())?;
        let making = CutOptions {
            kerf: self.kerf.unwrap_or_default(),
            grain: self.grain,
        };
        let made = parts_with(&design, &pieces, making);
        let summary = PatternSummary::new(&design, &pieces);
        if self.output == Output::Drawings(Purpose::Fold) {
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
        if ending != "pdf" {
            self.check_names(&design, &list)?;
        }
        let files = match self.output {
            Output::Drawings(purpose) => self.drawings(purpose, &made, ending)?,
            #[cfg(feature = "pdf")]
            Output::Bench => self.bench(&design, &pieces, &made, ending)?,
            #[cfg(feature = "pdf")]
            Output::Paper => self.tiles(&design, &pieces, &made)?,
        };
        for (file, bytes) in &files {
            write(file, bytes)?;
        }
        for row in &mut list.parts {
            let file = file_of(&self.to, &row.name, made.len() > 1 && ending != "pdf");
            row.file = file
                .file_name()
                .map(|name| name.to_string_lossy().into_owned());
        }
        if let Some(file) = &self.parts {
            write(file, list.csv().as_bytes())?;
        }
        if let Some(purpose) = self.output.purpose() {
            for part in &made {
                let where_else = match (part.marks_left_out(purpose), purpose) {
                    (0, _) => continue,
                    (_, Purpose::Cut) => {
                        "`--for bend` and `--for sew` draw lines and circles, `--for bench` and `--for paper` all"
                    }
                    _ => "`--for bench` and `--for paper` have letters",
                };
                let count = match part.marks_left_out(purpose) {
                    1 => "1 mark is".to_owned(),
                    count => format!("{count} marks are"),
                };
                remark(&format!(
                    "{}: {count} not in this file; {where_else}\n",
                    part.name
                ));
            }
        }
        self.end(&design, &summary, &list)
    }

    #[cfg(feature = "pdf")]
    fn page(&self) -> PaperSize {
        self.page.unwrap_or(PaperSize::A4)
    }

    /// Refuses an option that has no effect for the purpose.
    fn check_options(&self) -> Result<(), Failure> {
        let own = outputs().find(|(_, output)| *output == self.output);
        let purpose = own.map_or("", |(name, _)| name);
        let limited = [
            ("--parts", self.parts.is_some(), PARTED),
            ("--kerf", self.kerf.is_some(), CUT),
            ("--grain", self.grain.is_some(), PARTED),
            ("--rulings", self.pattern.sets_rulings(), RULED),
            #[cfg(feature = "pdf")]
            ("--page", self.page.is_some(), PAGED),
        ];
        let idle =
            |(_, given, purposes): &&(&str, bool, &[&str])| *given && !purposes.contains(&purpose);
        match limited.iter().find(idle) {
            None => Ok(()),
            Some((option, _, purposes)) => Err(Failure::NoEffect {
                option,
                purpose,
                purposes,
            }),
        }
    }

    /// The format of the file, which the purpose has to have.
    fn ending(&self) -> Result<&'static str, Failure> {
        let known = self.output.endings();
        let found = format_of(&self.to, self.r#as.as_deref(), known);
        let anything = format_of(&self.to, self.r#as.as_deref(), &ALL);
        let purposes = |ending: &&str| -> Vec<&'static str> {
            let has = outputs().filter(|(_, output)| output.endings().contains(ending));
            has.map(|(name, _)| name).collect()
        };
        match (found, anything) {
            (Err(_), Ok(ending)) => Err(Failure::OtherPurpose {
                ending,
                known,
                purposes: purposes(&ending),
            }),
            (Err(_), Err(_)) => Err(Failure::UnknownFormat {
                path: self.to.clone(),
                known,
                elsewhere: (ALL.iter())
                    .filter(|ending| !known.contains(ending))
                    .map(|ending| (*ending, purposes(ending)))
                    .filter(|(_, purposes)| !purposes.is_empty())
                    .collect(),
            }),
            (found, _) => found,
        }
    }

    /// The files of drawings with their bytes.
    fn drawings(&self, purpose: Purpose, made: &[Part], ending: &str) -> Result<Files, Failure> {
        let mut files = Files::new();
        for part in made {
            let text = text_of(&part.drawing(purpose)?, ending)?;
            let file = file_of(&self.to, &part.name, made.len() > 1);
            files.push((file, text.into_bytes()));
        }
        Ok(files)
    }

    /// The files of sheets for the fitter with their bytes.
    #[cfg(feature = "pdf")]
    fn bench(
        &self,
        design: &Design,
        pieces: &[FlatPiece],
        made: &[Part],
        ending: &str,
    ) -> Result<Files, Failure> {
        let sheets = bench_sheets(design, pieces, made, self.page())?;
        if ending == "pdf" {
            let set = Manuscript::bench(&design.name, &sheets)?.typeset()?;
            return Ok(vec![(self.to.clone(), set.pdf()?)]);
        }
        let mut files = Files::new();
        for sheet in &sheets {
            let set = Manuscript::bench(&design.name, std::slice::from_ref(sheet))?;
            let set = set.typeset()?;
            let file = file_of(&self.to, &sheet.part, made.len() > 1);
            // What does not fit on the first page of a part goes on in further files.
            for page in 0..set.page_count() {
                let file = file_of(&file, &format!("{}", page + 1), page > 0);
                files.push((file, set.page_svg(page)?.into_bytes()));
            }
        }
        Ok(files)
    }

    /// The file of pages in true size with its bytes.
    #[cfg(feature = "pdf")]
    fn tiles(
        &self,
        design: &Design,
        pieces: &[FlatPiece],
        made: &[Part],
    ) -> Result<Files, Failure> {
        let tiled = tiled_parts(design, pieces, made, self.page())?;
        let set = Manuscript::tiles(&design.name, &tiled)?.typeset()?;
        Ok(vec![(self.to.clone(), set.pdf()?)])
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
    fn end(
        &self,
        design: &Design,
        summary: &PatternSummary,
        list: &PartsList,
    ) -> Result<Exit, Failure> {
        let text = match self.format {
            Format::Text if self.output == Output::Drawings(Purpose::Fold) => summary.text(),
            Format::Text => list.text(summary),
            Format::Json => pretty_json(&Answer {
                summary,
                parts: list,
                left_out: &design.left_out,
            })?,
        };
        // Beside a file that goes to standard output, the answer goes to standard error.
        let beside = self.parts.as_deref().filter(|file| is_standard(file));
        answer(beside.unwrap_or(&self.to), &text)?;
        let demand = self.pattern.demand();
        // A pattern to fold is written where a blank is refused; all other parts were made.
        let report = match self.output {
            Output::Drawings(Purpose::Fold) => inspect_for(design, &demand)?,
            _ => inspect_unrolled(design, &demand)?,
        };
        for note in report.notes_on_space() {
            remark(&wrapped("note: ", &note));
        }
        let missed = report.missed;
        for reason in &missed {
            remark(&missed_line(reason));
        }
        tell_left_out(design);
        Ok(match design.left_out.is_empty() {
            true => met(&missed),
            false => Exit::Differs,
        })
    }
}
