//! A paper that is dropped on the page: held, and decided claim by claim, so that the page shows how far it is.

use serde::Serialize;
use std::cell::RefCell;
use torse::report::{VerdictsWriter, finding_json, glossary};
use torse::{Paper, Verifier};
use torse_web_border::{Answer, files};

thread_local! {
    static HELD: RefCell<Option<Paper>> = const { RefCell::new(None) };
}

/// A paper that was read.
#[derive(Serialize)]
struct ReadPaper {
    id: String,
    title: String,
    /// The ids of its claims.
    claims: Vec<String>,
}

/// Reads the files of a paper and holds it.
pub fn read(listed: &[(String, usize)], body: &[u8]) -> Answer {
    let files = match files(listed, body) {
        Ok(files) => files,
        Err(reason) => return Answer::refusal(&reason),
    };
    let text = |wanted: &str| {
        let (_, bytes) = files.iter().find(|(name, _)| *name == wanted)?;
        String::from_utf8(bytes.to_vec()).ok()
    };
    match Paper::read(text) {
        Ok(paper) => {
            let read = ReadPaper {
                id: paper.id().to_owned(),
                title: paper.title().to_owned(),
                claims: paper.ids().map(str::to_owned).collect(),
            };
            HELD.set(Some(paper));
            Answer::value(&read)
        }
        Err(error) => Answer::error(&error),
    }
}

/// A claim that was decided.
#[derive(Serialize)]
struct DecidedClaim<'c> {
    id: &'c str,
    /// Where it stands in the paper.
    at: &'c str,
    printed: &'c str,
    /// The verdict in a word.
    verdict: &'static str,
    /// The same for people.
    label: &'static str,
    /// The correction, if one was proved.
    corrected: Option<&'c str>,
}

/// Decides a claim of the paper that is held.
pub fn claim(number: usize) -> Answer {
    HELD.with_borrow(|held| {
        let Some(paper) = held else {
            return Answer::refusal("no paper was read");
        };
        let Some(claim) = paper.parts().claims.get(number) else {
            return Answer::refusal("the paper has no such claim");
        };
        let outcome = match Verifier::new().claim(paper.id(), claim) {
            Ok(outcome) => outcome,
            Err(error) => return Answer::error(&error),
        };
        let word = glossary::verdict(outcome.verdict());
        let correction = outcome.correction();
        let decided = DecidedClaim {
            id: &outcome.claim.id,
            at: &outcome.claim.at,
            printed: &outcome.claim.printed,
            verdict: word.key,
            label: word.label,
            corrected: correction.map(|correction| correction.statement.text.as_str()),
        };
        match finding_json(&outcome) {
            Ok(line) => Answer::with_body(&decided, line.into_bytes()),
            Err(error) => Answer::error(&error.into()),
        }
    })
}

/// Puts the lines of claims together.
pub fn verdicts(lines: &[u8]) -> Answer {
    let written = || {
        let mut json = VerdictsWriter::new(vec![])?;
        for line in String::from_utf8_lossy(lines).lines() {
            json.add(line)?;
        }
        json.finish()
    };
    match written() {
        Ok(json) => Answer::with_body(&(), json),
        Err(error) => Answer::error(&torse::Error::from(error)),
    }
}
