//! The verdicts as text: a table a paper, counts, and the findings in full.

use crate::terminal;
use comfy_table::{CellAlignment, ColumnConstraint, Row};
use std::collections::BTreeMap;
use torse_report::{Tally, findings_in_words, glossary};
use torse_syntax::taxonomy::Verdict;
use torse_verdicts::outcome::{Outcome, PaperOutcome};

/// The verdicts of `papers`.
pub fn text(papers: &[PaperOutcome]) -> String {
    let findings: BTreeMap<String, String> = papers
        .iter()
        .flat_map(|paper| findings_in_words(&paper.claims))
        .collect();
    let mut text = String::new();
    for paper in papers {
        text.push_str(&verdicts(paper, &findings));
        text.push('\n');
    }
    text.push_str(&counts(papers));
    let outcomes = || papers.iter().flat_map(|paper| &paper.claims);
    text.push_str(&in_full(outcomes(), &findings));
    text.push_str(&unexpected(outcomes()));
    text
}

fn verdicts(paper: &PaperOutcome, findings: &BTreeMap<String, String>) -> String {
    let mut table = terminal::table();
    table.set_header([
        "claim",
        "verdict",
        "evidence",
        "finding, or where it stands",
    ]);
    for outcome in &paper.claims {
        let name = outcome
            .claim
            .id
            .split_once('/')
            .map_or("", |(_, name)| name);
        let told = findings.get(&outcome.claim.id).unwrap_or(&outcome.claim.at);
        let mut row = Row::from([
            name,
            &terminal::verdict(outcome.verdict()),
            evidence(outcome),
            told,
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
        .map_or("", |of| glossary::evidence(of).label)
}

fn counts(papers: &[PaperOutcome]) -> String {
    let tally = Tally::new(papers.iter().flat_map(|paper| &paper.claims));
    let mut table = terminal::table();
    let mut header = vec!["verdict".to_owned(), "claims".to_owned()];
    header.extend(tally.evidence.iter().map(|of| of.label.to_owned()));
    header.push("no evidence".to_owned());
    table.set_header(header);
    let number = |count: usize| match count {
        0 => String::new(),
        _ => count.to_string(),
    };
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
        many => {
            let proved = tally.remarks.proved;
            format!(
                "Besides, {}, of which {proved} hold, if need be under the conditions that are told.\n",
                counted(many, "remark of ours")
            )
        }
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
            // What an undecided claim failed at is the first of its steps.
            if let (Verdict::Undecided, Some(reason)) = (outcome.verdict(), outcome.steps().first())
            {
                text += &terminal::paragraph(4, &format!("Reason: {reason}."));
            }
        }
    }
    let title = terminal::heading("Findings");
    match text.is_empty() {
        true => text,
        false => format!("\n{title} (`torse explain ID` says more)\n{text}"),
    }
}

/// The claims whose verdicts are not what their files expect, if there are any.
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

fn counted(count: usize, what: &str) -> String {
    match count {
        1 => format!("1 {what}"),
        // The word that is counted comes first: "remarks of ours".
        _ => match what.split_once(' ') {
            Some((word, rest)) => format!("{count} {word}s {rest}"),
            None => format!("{count} {what}s"),
        },
    }
}
