//! Findings with file and line, for tools of code review.

use crate::error::{ErrorMessage, ErrorPlace, diagnostic_place, message};
use miette::{Diagnostic, SourceCode};
use serde::Serialize;
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use torse_report::{failure_in_full, glossary};
use torse_syntax::derivation::Paper;
use torse_syntax::taxonomy::Verdict;
use torse_verdicts::outcome::Outcome;
use torse_verdicts::words;

/// How grave an annotation is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[non_exhaustive]
pub enum AnnotationLevel {
    /// A run with it fails.
    Error,
    /// It deserves a look.
    Warning,
}

/// A finding with its place.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[non_exhaustive]
pub struct Annotation {
    /// How grave it is.
    pub level: AnnotationLevel,
    /// What kind of finding it is: `contradiction`, `unexpected`, `mistake`, or the verdict.
    pub rule: &'static str,
    /// The claim; none where a file is wrong.
    pub claim: Option<String>,
    /// What is found, in a sentence.
    pub message: String,
    /// What would help, if known.
    pub hint: Option<String>,
    /// Where; the file relative to the folder of derivations.
    pub place: Option<ErrorPlace>,
    /// How many characters of the line from there on are meant; none where that is not known.
    pub length: usize,
}

impl Annotation {
    /// A mistake of a file, with its place and what would help.
    #[must_use]
    pub fn mistake(mistake: &dyn Diagnostic) -> Self {
        let ErrorMessage {
            place,
            length,
            text,
            hint,
        } = message(mistake);
        Self {
            level: AnnotationLevel::Error,
            rule: "mistake",
            claim: None,
            message: text,
            hint,
            place: place.or_else(|| diagnostic_place(mistake)),
            length,
        }
    }

    /// The column after its last character, if that is known.
    fn end_column(&self) -> Option<usize> {
        let place = self.place.as_ref().filter(|_| self.length > 0)?;
        Some(place.column + self.length)
    }

    /// What is found, and what would help.
    fn in_words(&self) -> String {
        let hint = self.hint.as_ref().map(|hint| format!("\nhelp: {hint}"));
        format!("{}{}", self.message, hint.unwrap_or_default())
    }
}

/// The findings of a run that are worth a look: contradictions and verdicts that are not as their files expect are errors;
/// refuted, undecided, vacuous and ambiguous claims of which nothing is expected are warnings.
///
/// ```
/// use torse::annotations;
/// let claim = "[[claim]]\nid = 'p/1'\nat = ''\nkind = 'identity'\nprinted = ''\nstates = '1 + 1 == 3'\nexpect = 'holds'";
/// let paper = torse::Paper::read(|name| match name {
///     "paper.toml" => Some("[paper]\nid = 'p'\ntitle = ''\nauthors = ''\nvenue = ''\nclaims = ['c.toml']".to_owned()),
///     "c.toml" => Some(claim.to_owned()),
///     _ => None,
/// })?;
/// let verified = paper.verify()?;
/// let found = annotations::annotations(std::slice::from_ref(paper.parts()), verified.outcomes());
/// let place = found[0].place.clone().ok_or("a claim has a place")?;
/// assert_eq!((found[0].rule, place.line), ("unexpected", 2));
/// let told = annotations::github(&found, "derivations");
/// assert!(told.starts_with("::error file=derivations/c.toml,line=2,col=7,title=p/1%3A unexpected::"), "{told}");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn annotations<'o>(
    papers: &[Paper],
    outcomes: impl IntoIterator<Item = &'o Outcome>,
) -> Vec<Annotation> {
    let claims = papers.iter().flat_map(|paper| &paper.claims);
    let origins: BTreeMap<&str, _> = claims
        .map(|claim| (claim.entry.id.get_ref().as_str(), &claim.origin))
        .collect();
    let mut found = vec![];
    for outcome in outcomes {
        let Some((level, rule, message)) = noteworthy(outcome) else {
            continue;
        };
        let id = &outcome.claim.id;
        let place = origins.get(id.as_str()).and_then(|origin| {
            let span = origin.span(torse_syntax::formula::Place { start: 0, end: 1 });
            let read = origin.source.read_span(&span, 0, 0).ok()?;
            Some(ErrorPlace {
                file: origin.source.name.clone(),
                line: read.line() + 1,
                column: read.column() + 1,
            })
        });
        found.push(Annotation {
            level,
            rule,
            claim: Some(id.clone()),
            message,
            hint: None,
            place,
            length: 0,
        });
    }
    found
}

/// What is to be said of an outcome, if anything is.
fn noteworthy(outcome: &Outcome) -> Option<(AnnotationLevel, &'static str, String)> {
    let verdict = glossary::verdict(outcome.verdict());
    if let Some(contradiction) = outcome.contradiction() {
        let message = format!("internal contradiction: {contradiction}");
        return Some((AnnotationLevel::Error, "contradiction", message));
    }
    let why = failure_in_full(outcome).or_else(|| words::steps(outcome).first().cloned());
    let why = why.map(|why| format!(": {why}")).unwrap_or_default();
    match outcome.claim.expect {
        Some(expected) if expected != outcome.verdict() => {
            let expected = glossary::verdict(expected).label;
            let message = format!("{}, expected {expected}{why}", verdict.label);
            Some((AnnotationLevel::Error, "unexpected", message))
        }
        Some(_) => None,
        None => match outcome.verdict() {
            Verdict::False | Verdict::Misprint => {
                let correction = outcome.correction();
                let correction = correction.map(|own| format!("; true is {}", own.statement.text));
                let message = format!("{}{why}{}", verdict.label, correction.unwrap_or_default());
                Some((AnnotationLevel::Warning, verdict.key, message))
            }
            Verdict::Undecided | Verdict::Vacuous | Verdict::Depends => Some((
                AnnotationLevel::Warning,
                verdict.key,
                format!("{}{why}", verdict.label),
            )),
            _ => None,
        },
    }
}

/// The annotations as commands of a workflow of GitHub, one a line; `folder` is that of the derivations, as the
/// repository names it.
#[must_use]
pub fn github(annotations: &[Annotation], folder: &str) -> String {
    let escaped = |text: &str| {
        let text = text.replace('%', "%25").replace('\r', "%0D");
        text.replace('\n', "%0A")
    };
    let property = |text: &str| escaped(text).replace(':', "%3A").replace(',', "%2C");
    let mut told = String::new();
    for annotation in annotations {
        let level = match annotation.level {
            AnnotationLevel::Error => "error",
            AnnotationLevel::Warning => "warning",
        };
        let mut properties = vec![];
        if let Some(place) = &annotation.place {
            let file = property(&path(folder, &place.file));
            properties.push(format!(
                "file={file},line={},col={}",
                place.line, place.column
            ));
            if let Some(end) = annotation.end_column() {
                properties.push(format!("endColumn={end}"));
            }
        }
        let title = match &annotation.claim {
            Some(claim) => format!("{claim}: {}", annotation.rule),
            None => annotation.rule.to_owned(),
        };
        properties.push(format!("title={}", property(&title)));
        let message = escaped(&annotation.in_words());
        // A string takes all that is written.
        let _ = writeln!(told, "::{level} {}::{message}", properties.join(","));
    }
    told
}

/// A file of the folder of derivations, with `/`.
fn path(folder: &str, file: &str) -> String {
    match folder {
        "" | "." => file.to_owned(),
        _ => format!("{}/{file}", folder.trim_end_matches('/')),
    }
}

/// The annotations as a log of SARIF 2.1.0, which code hosts and editors show; `folder` as for [`github`], `version` that of
/// the program that found them.
#[must_use]
pub fn sarif(annotations: &[Annotation], folder: &str, version: &str) -> String {
    let rules: BTreeSet<&str> = annotations
        .iter()
        .map(|annotation| annotation.rule)
        .collect();
    let rules: Vec<Value> = rules.into_iter().map(rule).collect();
    let results: Vec<Value> = annotations
        .iter()
        .map(|found| result(found, folder))
        .collect();
    let log = json!({
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
        "version": "2.1.0",
        "runs": [{
            "tool": { "driver": { "name": "torse", "version": version, "rules": rules } },
            "columnKind": "unicodeCodePoints",
            "results": results,
        }],
    });
    format!("{log:#}\n")
}

/// A rule of SARIF with what it means.
fn rule(id: &str) -> Value {
    let meaning = match id {
        "contradiction" => "Two checks of a verdict contradict each other.",
        "unexpected" => "The verdict is not the one that its derivation file expects.",
        "mistake" => "What a derivation file says makes no sense.",
        key => {
            let mut verdicts = glossary::VERDICTS.into_iter().map(glossary::verdict);
            verdicts
                .find(|verdict| verdict.key == key)
                .map_or(key, |verdict| verdict.meaning)
        }
    };
    json!({ "id": id, "shortDescription": { "text": meaning } })
}

/// An annotation as a result of SARIF.
fn result(annotation: &Annotation, folder: &str) -> Value {
    let level = match annotation.level {
        AnnotationLevel::Error => "error",
        AnnotationLevel::Warning => "warning",
    };
    let claim = annotation.claim.as_deref();
    let message = match claim {
        Some(claim) => format!("{claim}: {}", annotation.in_words()),
        None => annotation.in_words(),
    };
    let places = annotation.place.iter().map(|place| {
        let mut region = json!({ "startLine": place.line, "startColumn": place.column });
        if let Some(end) = annotation.end_column() {
            region["endColumn"] = end.into();
        }
        json!({ "physicalLocation": {
            "artifactLocation": { "uri": path(folder, &place.file).replace(' ', "%20") },
            "region": region,
        } })
    });
    // Lines may move: a mistake is known by its file and its words.
    let file = annotation.place.as_ref().map(|place| place.file.as_str());
    let fingerprints = match claim {
        Some(claim) => json!({ "claim/v1": claim }),
        None => {
            json!({ "mistake/v1": format!("{}: {}", file.unwrap_or_default(), annotation.message) })
        }
    };
    json!({
        "ruleId": annotation.rule,
        "level": level,
        "message": { "text": message },
        "locations": places.collect::<Vec<Value>>(),
        "partialFingerprints": fingerprints,
    })
}
