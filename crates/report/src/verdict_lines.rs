//! The verdicts as a table, one line for each claim, so that two runs can be compared by eye.
//!
//! [`crate::verdicts_json`] has the full findings; this table has the words in which a change would show.

use crate::{ReportError, glossary};
use std::collections::BTreeSet;
use torse_verdicts::outcome::Outcome;

/// The columns of the table.
const COLUMNS: [&str; 6] = ["id", "verdict", "evidence", "replayed", "netted", "kernel"];

/// Writes the verdicts as comma-separated values with a header: `id`, `verdict` and `evidence` as in
/// [`crate::verdicts_json`], then whether the checker of proofs followed the whole proof, whether enough points confirm
/// the verdict, and whether the kernel of the proof assistant accepted a proof of the claim, which holds for the ids in
/// `accepted`. Fields that do not apply are empty.
///
/// # Errors
///
/// [`ReportError::Table`] if the writer fails, which does not happen in memory.
///
/// ```
/// use std::collections::BTreeSet;
///
/// let none: [torse_verdicts::outcome::Outcome; 0] = [];
/// let table = torse_report::verdict_lines(&none, &BTreeSet::new())?;
/// assert_eq!(table, "id,verdict,evidence,replayed,netted,kernel\n");
/// # Ok::<(), torse_report::ReportError>(())
/// ```
pub fn verdict_lines<'a>(
    outcomes: impl IntoIterator<Item = &'a Outcome>,
    accepted: &BTreeSet<String>,
) -> Result<String, ReportError> {
    let mut table = csv::Writer::from_writer(Vec::new());
    table.write_record(COLUMNS)?;
    let answer = |answer: Option<bool>| match answer {
        Some(true) => "yes",
        Some(false) => "no",
        None => "",
    };
    for outcome in outcomes {
        let id = &outcome.claim.id;
        table.write_record([
            id.as_str(),
            glossary::verdict(outcome.verdict()).key,
            outcome
                .evidence()
                .map_or("", |own| glossary::evidence(own).key),
            answer(outcome.replay().map(|replay| replay.is_whole())),
            answer(outcome.net().map(|net| net.netted)),
            if accepted.contains(id) { "yes" } else { "" },
        ])?;
    }
    let bytes = table
        .into_inner()
        .map_err(|error| csv::Error::from(error.into_error()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
