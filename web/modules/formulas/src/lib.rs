//! Statements for the page: what `torse decide` answers, and the same set as mathematics.

mod paper;

use serde::{Deserialize, Serialize};
use torse::report::{Mathematics, difference};
use torse::{Decided, decide_where, undeclared_names};
use torse_web_border::{Answer, answer};

/// What the page asks.
#[derive(Deserialize)]
#[serde(tag = "do", rename_all = "kebab-case")]
enum Question {
    /// The names that are not declared, and the statement set as mathematics as far as it can be read: nothing is decided.
    Read { statement: String, setting: String },
    /// The verdict; the body is the JSON of `torse decide --format json`, byte for byte.
    Decide { statement: String, setting: String },
    /// Reads the files of a paper, which are in the body, and holds it: the ids of its claims.
    Paper { files: Vec<(String, usize)> },
    /// Decides the claim of the paper with this number; the body is its line of JSON.
    Claim { number: usize },
    /// The JSON of `torse verify --format json` of these lines, which are in the body.
    Verdicts,
}

/// Answers the question that was reserved.
#[unsafe(no_mangle)]
pub extern "C" fn torse_answer() -> *const u8 {
    answer(|question: Question, body| match question {
        Question::Read { statement, setting } => Answer::value(&ReadStatement {
            undeclared: undeclared_names(&statement, &setting),
            mathematics: set(&statement),
        }),
        Question::Decide { statement, setting } => match decide_where(&statement, &setting) {
            Ok(decided) => described(&decided),
            Err(error) => Answer::error(&error),
        },
        Question::Paper { files } => paper::read(&files, body),
        Question::Claim { number } => paper::claim(number),
        Question::Verdicts => paper::verdicts(body),
    })
}

/// A statement that was read.
#[derive(Serialize)]
struct ReadStatement {
    undeclared: Vec<String>,
    mathematics: Option<SetFormula>,
}

/// A formula in the forms that a page shows and copies.
#[derive(Serialize)]
struct SetFormula {
    text: String,
    latex: String,
    /// MathML, in pieces between which a line may be broken.
    mathml: Vec<String>,
}

fn set(text: &str) -> Option<SetFormula> {
    let Mathematics { latex, mathml, .. } = Mathematics::read(text)?;
    Some(SetFormula {
        text: text.to_owned(),
        latex,
        mathml,
    })
}

/// A verdict with what it rests on.
#[derive(Serialize)]
struct Described {
    /// The verdict in a word, as in the JSON of the command.
    verdict: &'static str,
    /// The same for people, as an explanation begins.
    says: String,
    evidence: Option<&'static str>,
    /// Whether the checker accepts the proof; none where there is no proof.
    replayed: Option<bool>,
    statement: Option<SetFormula>,
    conditions: Vec<SetFormula>,
    correction: Option<Correction>,
    witness: Option<Counterexample>,
    steps: Vec<String>,
    /// Label and text of each line, in groups.
    explanation: Vec<Vec<[String; 2]>>,
}

/// What is right instead.
#[derive(Serialize)]
struct Correction {
    formula: SetFormula,
    /// The statement and the correction as texts in which what changes is marked.
    marked: [String; 2],
}

/// A point at which a statement is false.
#[derive(Serialize)]
struct Counterexample {
    at: Vec<(String, String)>,
    left: String,
    right: String,
}

fn described(decided: &Decided) -> Answer {
    let json = match decided.json() {
        Ok(json) => json,
        Err(error) => return Answer::error(&error),
    };
    let statement = decided.statement();
    let correction = decided.corrected().and_then(|corrected| {
        Some(Correction {
            formula: set(corrected)?,
            marked: difference(statement.unwrap_or_default(), corrected),
        })
    });
    let explanation = decided.explanation();
    let says = explanation.text("verdict").unwrap_or_default().to_owned();
    let groups = explanation.groups.into_iter().map(|group| {
        let lines = group.into_iter().map(|line| [line.label, line.text]);
        lines.collect()
    });
    let described = Described {
        verdict: decided.word(),
        says,
        evidence: decided.evidence(),
        replayed: decided.is_replayed(),
        statement: statement.and_then(set),
        conditions: decided.conditions().into_iter().filter_map(set).collect(),
        correction,
        witness: decided.witness().map(|witness| Counterexample {
            at: witness.at.clone(),
            left: witness.left.clone(),
            right: witness.right.clone(),
        }),
        steps: decided.steps(),
        explanation: groups.collect(),
    };
    Answer::with_body(&described, json.into_bytes())
}
