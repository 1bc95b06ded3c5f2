//! `torse audit`: signs that a statement is not what the paper prints.

use crate::derivations::{Derivations, LoadedDerivations};
use crate::exit::{Exit, Failure};
use crate::format::{Format, pretty_json};
use crate::run::{Budget, Run};
use crate::terminal::Progress;
use crate::{terminal, watchdog};
use clap::Args;
use serde::Serialize;
use std::collections::BTreeMap;
use torse::selection;
use torse_report::glossary;
use torse_syntax::derivation::{Answer, Claim, DerivationError, Paper};
use torse_syntax::formula::Place;
use torse_syntax::taxonomy::Flag;
use torse_verdicts::audit::{Audited, audit};
use torse_verdicts::outcome::Outcome;

/// Flag signs that statements are not what the papers print.
///
/// Flags are signs such as a side that is compared with itself, a printed number that the statement lacks, or one
/// degree for all. Correct the statement, or answer the flag in the file of the claim with words of the paper
/// (`answers`). The exit code is 1 if a flag is open, and 4 if an answer belongs to no flag.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct Audit {
    /// Papers, claims, or prefixes of ids
    #[arg(value_name = "PAPER|ID")]
    names: Vec<String>,
    /// Print a table, or JSON for programs
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    #[command(flatten)]
    budget: Budget,
    #[command(flatten)]
    derivations: Derivations,
}

const EXAMPLES: &str = "\
Examples:
  torse audit
  torse audit gbt-developable/thm-4 --format json";

impl Audit {
    /// Decides, audits, and prints the open flags and the answers.
    pub fn run(&self) -> Result<Exit, Failure> {
        let LoadedDerivations {
            papers,
            left_out,
            mut mistakes,
        } = self.derivations.load()?;
        selection::select(papers.clone(), &self.names, &left_out)?;
        // A part is audited together with its sentence.
        let wanted = |claim: &Claim| {
            let id = claim.sentence_id().unwrap_or(claim.entry.id.get_ref());
            let named = |claim: &Claim| {
                let id = claim.entry.id.get_ref();
                self.names.is_empty() || self.names.iter().any(|name| selection::means(name, id))
            };
            let all = papers.iter().flat_map(|paper| &paper.claims);
            named(claim) || all.filter(|c| c.sentence_id() == Some(id)).any(named)
        };
        let ids = papers.iter().flat_map(|paper| &paper.claims);
        let ids = ids.filter(|claim| wanted(claim));
        let ids: Vec<&str> = ids.map(|claim| claim.entry.id.get_ref().as_str()).collect();
        let looked_at = selection::only(&papers, &ids);
        let run = Run::new(&looked_at, self.budget, &mut mistakes);
        let pairs = pairs(&looked_at, &run);
        let progress = Progress::new("auditing", pairs.len());
        let found = audit(&papers, &pairs, || progress.step());
        progress.finish();
        watchdog::finished();
        for audited in &found {
            for answer in &audited.stale {
                mistakes.add(stale(answer));
            }
        }
        terminal::print(&match self.format {
            Format::Text => text(&found),
            Format::Json => json(&found)?,
        })?;
        let open = found.iter().any(|audited| !audited.open.is_empty());
        Ok(mistakes.tell(match open {
            true => Exit::Differs,
            false => Exit::AsExpected,
        }))
    }
}

/// The claims that have outcomes, with them.
fn pairs<'a>(papers: &'a [Paper], run: &'a Run) -> Vec<(&'a Claim, &'a Outcome)> {
    let outcomes: BTreeMap<&str, &Outcome> = run
        .outcomes()
        .map(|outcome| (outcome.claim.id.as_str(), outcome))
        .collect();
    let claims = papers.iter().flat_map(|paper| &paper.claims);
    claims
        .filter_map(|claim| {
            let outcome = outcomes.get(claim.entry.id.get_ref().as_str())?;
            Some((claim, *outcome))
        })
        .collect()
}

fn stale(answer: &Answer) -> Box<DerivationError> {
    let flag = glossary::flag(answer.flag);
    let message = format!("nothing is flagged as `{flag}` here, so there is nothing to answer");
    let error = DerivationError::at(&answer.origin, Place::default(), message);
    Box::new(error.with_help("take the answer out"))
}

/// Answers that are the same, and the claims that give them.
type Classes<'a> = BTreeMap<(Flag, &'a str, &'a str), Vec<&'a str>>;

fn classes<'a>(found: &'a [Audited<'a>]) -> Classes<'a> {
    let mut classes = Classes::new();
    for audited in found {
        for (raised, answer) in &audited.answered {
            let says = answer.says.as_deref().unwrap_or_default();
            let class = classes
                .entry((raised.flag, answer.quote.words.as_str(), says))
                .or_default();
            let id = audited.claim.entry.id.get_ref().as_str();
            if !class.contains(&id) {
                class.push(id);
            }
        }
    }
    classes
}

fn text(found: &[Audited<'_>]) -> String {
    let mut text = String::new();
    let mut table = terminal::table();
    table.set_header(["claim", "flag", "sign"]);
    let mut open = 0;
    for audited in found {
        for raised in &audited.open {
            let id = audited.claim.entry.id.get_ref().as_str();
            table.add_row([id, glossary::flag(raised.flag), raised.evidence.as_str()]);
            open += 1;
        }
    }
    if open > 0 {
        text.push_str(&terminal::lines(&table));
        text.push('\n');
    }
    let classes = classes(found);
    if !classes.is_empty() {
        let mut table = terminal::table();
        table.set_header(["claims", "flag", "answered by"]);
        for ((flag, quote, says), ids) in &classes {
            let says = match says.is_empty() {
                true => String::new(),
                false => format!(": {says}"),
            };
            let answer = format!("“{quote}”{says}");
            let ids = match ids.as_slice() {
                [one] => (*one).to_owned(),
                [first, rest @ ..] => format!("{first} and {} more", rest.len()),
                [] => String::new(),
            };
            table.add_row([ids.as_str(), glossary::flag(*flag), answer.as_str()]);
        }
        text.push_str(&terminal::lines(&table));
        text.push('\n');
    }
    let answered: usize = classes.values().map(Vec::len).sum();
    let stale: usize = found.iter().map(|audited| audited.stale.len()).sum();
    text.push_str(&format!(
        "claims: {}; flags: {open} open, {answered} answered in {} classes; answers to no flag: {stale}\n",
        found.len(),
        classes.len()
    ));
    text
}

#[derive(Serialize)]
struct Listing<'a> {
    open: Vec<Open<'a>>,
    answered: Vec<Class<'a>>,
    stale: Vec<Stale<'a>>,
}

#[derive(Serialize)]
struct Open<'a> {
    id: &'a str,
    flag: &'static str,
    seen: &'a str,
}

#[derive(Serialize)]
struct Class<'a> {
    flag: &'static str,
    quote: &'a str,
    says: &'a str,
    claims: Vec<&'a str>,
}

#[derive(Serialize)]
struct Stale<'a> {
    id: &'a str,
    flag: &'static str,
}

fn json(found: &[Audited<'_>]) -> Result<String, Failure> {
    let mut listing = Listing {
        open: vec![],
        answered: vec![],
        stale: vec![],
    };
    for audited in found {
        let id = audited.claim.entry.id.get_ref().as_str();
        listing.open.extend(audited.open.iter().map(|raised| Open {
            id,
            flag: glossary::flag(raised.flag),
            seen: &raised.evidence,
        }));
        listing
            .stale
            .extend(audited.stale.iter().map(|answer| Stale {
                id,
                flag: glossary::flag(answer.flag),
            }));
    }
    let answered = classes(found).into_iter();
    listing.answered = answered
        .map(|((flag, quote, says), claims)| Class {
            flag: glossary::flag(flag),
            quote,
            says,
            claims,
        })
        .collect();
    Ok(pretty_json(&listing)?)
}
