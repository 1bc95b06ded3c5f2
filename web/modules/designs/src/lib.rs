//! Designs for the page: read, shown in space and flat, bent, measured, written to files.
//!
//! Every question brings the whole design, so that nothing is lost when a module is ended and started again; the design of
//! the last question is kept while it stays the same ([`source`]).

mod contents;
mod pattern;
mod points;
mod scene;
mod source;

use serde::{Deserialize, Serialize};
use source::Source;
use torse::designs::draw::bending;
use torse::designs::export::ENDINGS;
use torse::designs::unroll::{Demand, Purpose};
use torse::{Error, report_text};
use torse_web_border::{Answer, answer};

/// What the page asks. The files of a design are in the body, one after the other.
#[derive(Deserialize)]
#[serde(tag = "do", rename_all = "kebab-case")]
enum Question {
    /// The design in space, its sheet bent by this share of all bends, and, where `pattern` is wanted, flat.
    Show {
        source: Source,
        share: f64,
        pattern: bool,
    },
    /// What `torse inspect` says of it: as a value, as a text, and, in the body, as the JSON of the command.
    Measure { source: Source, quick: bool },
    /// The bytes of a file, those of `torse export`.
    Export { source: Source, ending: String },
    /// The files of its parts, those of `torse unroll`.
    Parts {
        source: Source,
        ending: String,
        purpose: String,
    },
    /// The moving picture of the bending sheet, the bytes of `torse draw --to FILE.gif`.
    Bending { source: Source },
    /// What a file of another program holds, and a design that begins with its curves.
    Contents { files: Vec<(String, usize)> },
}

/// Answers the question that was reserved.
#[unsafe(no_mangle)]
pub extern "C" fn torse_answer() -> *const u8 {
    answer(|question: Question, body| {
        answered(question, body).unwrap_or_else(|failure| match failure {
            Failure::Refused(error) => Answer::error(&error),
            Failure::Asked(reason) => Answer::refusal(&reason),
        })
    })
}

/// Why there is no answer.
enum Failure {
    /// The library refuses the design.
    Refused(Error),
    /// The page asks for what is not there.
    Asked(String),
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        Self::Refused(error)
    }
}

impl From<torse::designs::DesignError> for Failure {
    fn from(error: torse::designs::DesignError) -> Self {
        Self::Refused(error.into())
    }
}

fn answered(question: Question, body: &[u8]) -> Result<Answer, Failure> {
    match question {
        Question::Show {
            source,
            share,
            pattern,
        } => source.held(body, |held| Ok(scene::show(held, share, pattern))),
        Question::Measure { source, quick } => source.held(body, |held| {
            let report = match quick {
                true => held.design.inspect_quickly()?,
                false => held.design.inspect()?,
            };
            let json = serde_json::to_string_pretty(&report);
            let json = json.map_err(|error| Failure::Asked(error.to_string()))? + "\n";
            let measured = Measured {
                missed: &report.missed,
                notes: &report.notes,
                text: report_text(&report),
            };
            Ok(Answer::with_body(&measured, json.into_bytes()))
        }),
        Question::Export { source, ending } => {
            let known = ENDINGS.iter().find(|known| **known == ending);
            let ending = known.ok_or_else(|| Failure::Asked(format!("`{ending}` is no ending")))?;
            source.held(body, |held| {
                let bytes = held.design.export(ending, &Demand::default())?;
                Ok(Answer::with_body(&held.design.name(), bytes))
            })
        }
        Question::Bending { source } => source.held(body, |held| {
            let bytes = bending(held.design.parts(), &Demand::default())?;
            Ok(Answer::with_body(&held.design.name(), bytes))
        }),
        Question::Parts {
            source,
            ending,
            purpose,
        } => {
            let known = Purpose::ALL.iter().find(|(name, _)| *name == purpose);
            let (_, purpose) =
                known.ok_or_else(|| Failure::Asked(format!("`{purpose}` is no purpose")))?;
            source.held(body, |held| {
                let parts = held
                    .design
                    .parts_as(&ending, *purpose, &Demand::default())?;
                let listed: Vec<(&str, usize)> = parts
                    .iter()
                    .map(|(name, text)| (name.as_str(), text.len()))
                    .collect();
                let texts = parts.iter().map(|(_, text)| text.as_str());
                Ok(Answer::with_body(
                    &listed,
                    texts.collect::<String>().into_bytes(),
                ))
            })
        }
        Question::Contents { files } => {
            let files = torse_web_border::files(&files, body).map_err(Failure::Asked)?;
            let found = contents::contents(&files)?;
            Ok(Answer::value(&found))
        }
    }
}

/// What was measured of a design.
#[derive(Serialize)]
struct Measured<'r> {
    missed: &'r [String],
    notes: &'r [String],
    text: String,
}
