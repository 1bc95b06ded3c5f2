//! The parts of a document, before it is set.
//!
//! Setting pages is most of the work of a report. A [`Manuscript`] contains everything that determines them: the
//! templates, the data and the pictures. Its fingerprint shows whether setting it again would give the same document.

use crate::applicability::Usability;
use crate::glossary::{self, EVIDENCE, RULES, Rule, Term, VERDICTS};
use crate::letter::Envelope;
use crate::model::{Report, figure_file};
use crate::world::{MemoryWorld, has_glyph};
use crate::{FigureImage, ReportError, Typeset, digest, erratum, text};
use serde::Serialize;
use serde_json::Value;
use torse_designs::bench::{BenchSheet, TiledPart};

/// Increase it whenever the same manuscript is set or written in another way, so that every fingerprint changes.
const VERSION: u32 = 3;

const TEMPLATES: [(&str, &str); 5] = [
    (
        "paper-figure.typ",
        include_str!("../assets/paper-figure.typ"),
    ),
    ("theme.typ", include_str!("../assets/theme.typ")),
    ("formula.typ", include_str!("../assets/formula.typ")),
    ("claim.typ", include_str!("../assets/claim.typ")),
    ("overview.typ", include_str!("../assets/overview.typ")),
];
const PAPER: &str = include_str!("../assets/paper.typ");
const ERRATUM: &str = include_str!("../assets/erratum.typ");
const SUMMARY: &str = include_str!("../assets/summary.typ");
const BENCH: &str = include_str!("../assets/bench.typ");
const TILES: &str = include_str!("../assets/tiles.typ");

/// A document that can be set: its contents, its form, its pictures.
///
/// ```
/// # fn run(paper: &torse_verdicts::outcome::PaperOutcome) -> Result<(), torse_report::ReportError> {
/// let report = torse_report::model::Report::new(paper, &[]);
/// let manuscript = torse_report::Manuscript::paper(&report, &[])?;
/// let same = torse_report::Manuscript::paper(&report, &[])?;
/// assert_eq!(manuscript.fingerprint(), same.fingerprint());
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct Manuscript {
    /// The name of the document in errors.
    name: &'static str,
    /// The main template.
    main: &'static str,
    /// The data and the pictures, by the names in the templates.
    files: Vec<(String, Vec<u8>)>,
    identifier: String,
}

impl Manuscript {
    /// Makes the report of one paper, with the pictures that it was made with.
    ///
    /// A formula that cannot be parsed is shown as code; a character that no font has is spelled out.
    ///
    /// # Errors
    ///
    /// [`ReportError::Json`] when the report cannot be written as data.
    pub fn paper(report: &Report, figures: &[FigureImage]) -> Result<Self, ReportError> {
        let data = Data {
            glossary: Glossary::new(),
            content: report,
        };
        let pictures = figures.iter().enumerate().map(|(position, figure)| {
            (figure_file(position, figure), figure.image.bytes().to_vec())
        });
        Self::new(
            "the report of a paper",
            PAPER,
            &data,
            pictures,
            &report.slug,
        )
    }

    /// Makes the summary of several papers: counts, and for each what a reader must know in a minute. Our worked
    /// examples are left out.
    ///
    /// # Errors
    ///
    /// [`ReportError::Json`] when the reports cannot be written as data.
    pub fn summary(reports: &[Report]) -> Result<Self, ReportError> {
        let papers: Vec<&Report> = reports.iter().filter(|own| !own.is_example()).collect();
        let data = Data {
            glossary: Glossary::new(),
            content: papers,
        };
        Self::new("the summary", SUMMARY, &data, [], "summary")
    }

    /// Makes the corrections of a paper, ready to be sent.
    ///
    /// # Errors
    ///
    /// [`ReportError::Json`] when the reports cannot be written as data.
    pub fn erratum(report: &Report, envelope: &Envelope) -> Result<Self, ReportError> {
        let data = Sheet {
            content: report,
            envelope: envelope.cleared(),
            draft: erratum::DRAFT,
            parts: erratum::PARTS,
        };
        let identifier = format!("{}-erratum", report.slug);
        Self::new(
            "the corrections of a paper",
            ERRATUM,
            &data,
            [],
            &identifier,
        )
    }

    /// Makes the sheets of parts for the fitter, a page each.
    ///
    /// # Errors
    ///
    /// [`ReportError::Json`] when the sheets cannot be written as data.
    pub fn bench(design: &str, sheets: &[BenchSheet]) -> Result<Self, ReportError> {
        let views = sheets.iter().enumerate().map(|(position, sheet)| {
            (
                format!("view-{position}.svg"),
                sheet.view.clone().into_bytes(),
            )
        });
        let identifier = format!("{design}-bench");
        Self::new(
            "the sheets for the bench",
            BENCH,
            &sheets,
            views,
            &identifier,
        )
    }

    /// Makes parts in true size on pages, after a page of each that shows how these lie.
    ///
    /// # Errors
    ///
    /// [`ReportError::Json`] when the pages cannot be written as data.
    pub fn tiles(design: &str, parts: &[TiledPart]) -> Result<Self, ReportError> {
        let identifier = format!("{design}-paper");
        Self::new("the pages in true size", TILES, &parts, [], &identifier)
    }

    fn new(
        name: &'static str,
        main: &'static str,
        data: &impl Serialize,
        pictures: impl IntoIterator<Item = (String, Vec<u8>)>,
        identifier: &str,
    ) -> Result<Self, ReportError> {
        let mut data = serde_json::to_value(data)?;
        spell_out_missing_glyphs(&mut data);
        let files = pictures
            .into_iter()
            .chain([("data.json".to_owned(), serde_json::to_vec(&data)?)]);
        Ok(Manuscript {
            name,
            main,
            files: files.collect(),
            identifier: format!("torse-{identifier}"),
        })
    }

    /// Returns a number that changes with everything that determines the document, the typesetter's version included:
    /// SHA-256, in hexadecimal digits. Equal fingerprints mean equal documents.
    #[must_use]
    pub fn fingerprint(&self) -> String {
        let version = VERSION.to_be_bytes();
        let typesetter = typst_utils::version().raw();
        let fixed: [&[u8]; 4] = [
            &version,
            typesetter.as_bytes(),
            self.identifier.as_bytes(),
            self.main.as_bytes(),
        ];
        let templates = TEMPLATES.map(|(name, text)| [name.as_bytes(), text.as_bytes()]);
        let files = (self.files.iter()).map(|(name, bytes)| [name.as_bytes(), bytes.as_slice()]);
        digest::digest(
            fixed
                .into_iter()
                .chain(templates.into_iter().chain(files).flatten()),
        )
    }

    /// Lays out the pages of the document.
    ///
    /// # Errors
    ///
    /// [`ReportError::Typeset`] if it cannot be set, for instance because the format of a picture is wrong.
    pub fn typeset(self) -> Result<Typeset, ReportError> {
        let world = MemoryWorld::new(self.main, &TEMPLATES, self.files)?;
        Ok(Typeset {
            document: world.compile(self.name)?,
            identifier: self.identifier,
        })
    }
}

#[derive(Serialize)]
struct Data<C> {
    content: C,
    glossary: Glossary,
}

#[derive(Serialize)]
struct Sheet<'a> {
    content: &'a Report,
    envelope: Envelope,
    draft: &'static str,
    parts: [&'static str; 3],
}

#[derive(Serialize)]
struct Glossary {
    verdicts: Vec<Term>,
    evidence: Vec<Term>,
    levels: [Term; 3],
    rules: [Rule; 7],
    answers: [AnswerView; 6],
}

/// An answer to whether a construction can be used, and its words.
#[derive(Serialize)]
struct AnswerView {
    key: Usability,
    label: &'static str,
}

impl Glossary {
    fn new() -> Self {
        Glossary {
            verdicts: VERDICTS.into_iter().map(glossary::verdict).collect(),
            evidence: EVIDENCE.into_iter().map(glossary::evidence).collect(),
            levels: [glossary::KERNEL, glossary::NETTED, glossary::DECIDED],
            rules: RULES,
            answers: Usability::ALL.map(|key| AnswerView {
                key,
                label: key.label(),
            }),
        }
    }
}

/// PDF/A does not allow the glyph for a missing glyph.
fn spell_out_missing_glyphs(data: &mut Value) {
    match data {
        Value::String(string) => {
            if !string.chars().all(has_glyph) {
                *string = text::replace(string, has_glyph);
            }
        }
        Value::Array(values) => values.iter_mut().for_each(spell_out_missing_glyphs),
        Value::Object(members) => members.values_mut().for_each(spell_out_missing_glyphs),
        Value::Null | Value::Bool(_) | Value::Number(_) => {}
    }
}
