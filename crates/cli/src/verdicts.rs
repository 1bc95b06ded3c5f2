//! The verdicts as text: a table for each paper, the findings in full, and a summary.

use crate::terminal::{self, counted};
use comfy_table::{CellAlignment, ColumnConstraint, Row};
use std::collections::BTreeMap;
use torse_report::{Tally, findings_in_words, glossary, is_worked_example};
use torse_syntax::taxonomy::{Kind, Verdict};
use torse_verdicts::outcome::{Outcome, PaperOutcome};
use torse_verdicts::words;

/// Writes the verdicts of `papers`, publications before worked examples, and a summary at the end.
pub fn text(papers: &[PaperOutcome]) -> String {
    let findings: BTreeMap<String, String> = papers.iter().flat_map(findings_in_words).collect();
    let (examples, publications): (Vec<&PaperOutcome>, Vec<&PaperOutcome>) =
        papers.iter().partition(|paper| is_worked_example(paper));
    let papers: Vec<&PaperOutcome> = publications.into_iter().chain(examples).collect();
    let outcomes = || papers.iter().flat_map(|paper| &paper.claims);
    let mut text = String::new();
    for paper in &papers {
        text.push_str(&verdicts(paper, &findings));
        text.push('\n');
    }
    text.push_str(&in_full(outcomes(), &findings));
    text.push_str(&by_paper(&papers));
    text.push_str(&counts(outcomes()));
    text.push_str(&unexpected(outcomes()));
    text.push_str(&unstated(outcomes()));
    text.push_str(&next(outcomes()));
    text
}

/// The verdicts that have a column of their own in the summary.
const COLUMNS: [(&str, Verdict); 6] = [
    ("hold", Verdict::Holds),
    ("conditional", Verdict::Conditional),
    ("misprints", Verdict::Misprint),
    ("false", Verdict::False),
    ("depend", Verdict::Depends),
    ("undecided", Verdict::Undecided),
];

/// Counts the claims of each paper by verdict, if there are several papers.
fn by_paper(papers: &[&PaperOutcome]) -> String {
    if papers.len() < 2 {
        return String::new();
    }
    let mut table = terminal::table();
    let names = COLUMNS.iter().map(|(name, _)| *name);
    table.set_header(
        ["paper", "claims"]
            .into_iter()
            .chain(names)
            .chain(["other"]),
    );
    for paper in papers {
        let claims = paper.claims.iter();
        let claims: Vec<&Outcome> = claims.filter(|c| c.claim.kind != Kind::Remark).collect();
        let counts = COLUMNS.map(|(_, of)| claims.iter().filter(|c| c.verdict() == of).count());
        let other = claims.len() - counts.iter().sum::<usize>();
        let numbers = counts.into_iter().chain([other]).map(number);
        let mut cells = vec![paper.slug.clone(), claims.len().to_string()];
        cells.extend(numbers);
        table.add_row(cells);
    }
    for column in table.column_iter_mut().skip(1) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    let title = terminal::heading("Summary");
    format!("{title}\n{}\n", terminal::lines(&table))
}

/// A number of a table; none for zero.
fn number(count: usize) -> String {
    match count {
        0 => String::new(),
        _ => count.to_string(),
    }
}

/// Counts the claims whose files state nothing yet.
fn unstated<'a>(outcomes: impl Iterator<Item = &'a Outcome>) -> String {
    let claims: Vec<&Outcome> = outcomes
        .filter(|outcome| match outcome.claim.kind {
            Kind::Remark => false,
            Kind::Definition => outcome.is_unstated(),
            _ => true,
        })
        .collect();
    let open = claims
        .iter()
        .filter(|outcome| outcome.is_unstated())
        .count();
    match open {
        0 => String::new(),
        _ => format!(
            "\n{open} of {} {} still to be stated: `torse explain ID` shows what is missing\n",
            counted(claims.len(), "statement"),
            if open == 1 { "is" } else { "are" },
        ),
    }
}

/// Suggests what to do next: explain the first claim that is false.
fn next<'a>(mut outcomes: impl Iterator<Item = &'a Outcome>) -> String {
    let wrong = outcomes.find(|o| matches!(o.verdict(), Verdict::Misprint | Verdict::False));
    wrong.map_or_else(String::new, |outcome| {
        format!("\nNext: torse explain {}\n", outcome.claim.id)
    })
}

fn verdicts(paper: &PaperOutcome, findings: &BTreeMap<String, String>) -> String {
    let mut table = terminal::table();
    table.set_header(["claim", "verdict", "evidence", "finding, or place"]);
    for outcome in &paper.claims {
        let name = outcome
            .claim
            .id
            .split_once('/')
            .map_or("", |(_, name)| name);
        let finding = findings.get(&outcome.claim.id).unwrap_or(&outcome.claim.at);
        let mut row = Row::from([
            name,
            &terminal::verdict(outcome.verdict()),
            evidence(outcome),
            finding,
        ]);
        row.max_height(1);
        table.add_row(row);
    }
    for column in table.column_iter_mut().take(3) {
        column.set_constraint(ColumnConstraint::ContentWidth);
    }
    let slug = terminal::heading(&format!("{}/", paper.slug));
    terminal::paragraph(0, &format!("{slug}  {}", paper.title)) + &terminal::lines(&table)
}

fn evidence(outcome: &Outcome) -> &'static str {
    outcome
        .evidence()
        .map_or("", |own| glossary::evidence(own).label)
}

fn counts<'a>(outcomes: impl Iterator<Item = &'a Outcome>) -> String {
    let tally = Tally::new(outcomes);
    let mut table = terminal::table();
    let mut header = vec!["verdict".to_owned(), "claims".to_owned()];
    header.extend(tally.evidence.iter().map(|own| own.label.to_owned()));
    header.push("no evidence".to_owned());
    table.set_header(header);
    for row in &tally.rows {
        let mut cells = vec![row.verdict.label.to_owned(), number(row.count)];
        cells.extend(row.by_evidence.iter().copied().map(number));
        cells.push(number(row.without));
        table.add_row(cells);
    }
    for column in table.column_iter_mut().skip(1) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    let title = terminal::heading(&counted(tally.total, "claim"));
    let remarks = match tally.remarks.total {
        0 => String::new(),
        many => format!(
            "not counted: {}; {}\n",
            counted(many, "remark of ours"),
            tally.remarks.in_words()
        ),
    };
    format!("{title}\n{}{remarks}", terminal::lines(&table))
}

fn in_full<'a>(
    outcomes: impl Iterator<Item = &'a Outcome>,
    findings: &BTreeMap<String, String>,
) -> String {
    let mut text = String::new();
    for outcome in outcomes {
        if let Some(finding) = findings.get(&outcome.claim.id) {
            let id = terminal::heading(&outcome.claim.id);
            text += &terminal::paragraph(0, &format!("{id}  {}", outcome.claim.at));
            text += &terminal::paragraph(4, finding);
            // The first step of an undecided claim is the reason.
            if let (Verdict::Undecided, Some(reason)) =
                (outcome.verdict(), words::steps(outcome).first())
            {
                text += &terminal::paragraph(4, &format!("Reason: {reason}."));
            }
        }
    }
    let title = terminal::heading("Findings");
    match text.is_empty() {
        true => text,
        false => format!("{title} (`torse explain ID` shows more)\n{text}\n"),
    }
}

/// Lists the claims whose verdicts differ from those that their files expect, if there are any.
pub fn unexpected<'a>(outcomes: impl Iterator<Item = &'a Outcome>) -> String {
    let differing: Vec<String> = outcomes
        .filter(|outcome| !outcome.as_expected())
        .filter_map(|outcome| {
            let expected = glossary::verdict(outcome.claim.expect?).label;
            let verdict = terminal::verdict(outcome.verdict());
            Some(format!(
                "  {}: {verdict}, expected {expected}\n",
                outcome.claim.id
            ))
        })
        .collect();
    match differing.len() {
        0 => String::new(),
        1 => format!(
            "\n1 verdict is not the expected one\n{}",
            differing.concat()
        ),
        many => format!(
            "\n{many} verdicts are not the expected ones\n{}",
            differing.concat()
        ),
    }
}
