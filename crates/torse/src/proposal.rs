//! Derivation files proposed from a manuscript, which `verify` reads to the end.

use crate::paper::Paper;
use crate::verifier::{Verifier, WorkBudget};
use std::collections::BTreeMap;
use torse_manuscript::{Manuscript, Proposal, propose_without};

/// The work on a claim that shows whether its formulas make sense: it need not be decided.
const READING_WORK: WorkBudget = WorkBudget::new(20_000);

/// Proposes derivation files for a manuscript; `slug` is the name of the folder. A claim whose formulas make no sense with the proposed
/// symbols, such as one with an index that its family does not have, is left without a statement, and listed with the reason.
///
/// ```
/// let text = r"\begin{document} Points $P_0, P_1, \dots, P_n \in \mathbb{R}^3$.
///     \begin{equation} Q = P_1 - P_0 \end{equation} \begin{equation} Q + P_0 = P_1 \end{equation} \end{document}";
/// let manuscript = torse::manuscript::manuscript(text)?;
/// let proposal = torse::propose(&manuscript, "points");
/// assert!(proposal.paper.contains("Q = 'P[1] - P[0]'"));
/// assert!(proposal.claims.contains("Q + P[0] == P[1]"), "{}", proposal.claims);
/// # Ok::<(), torse::manuscript::ManuscriptError>(())
/// ```
#[must_use]
pub fn propose(manuscript: &Manuscript, slug: &str) -> Proposal {
    let mut refused = BTreeMap::new();
    loop {
        let proposal = propose_without(manuscript, slug, &refused);
        let found = mistakes(&proposal, slug);
        let before = refused.len();
        refused.extend(found);
        if refused.len() == before {
            return proposal;
        }
    }
}

/// The claims whose formulas make no sense, each with the reason.
fn mistakes(proposal: &Proposal, slug: &str) -> Vec<(String, String)> {
    let read = Paper::read(|name| match name {
        "paper.toml" => Some(proposal.paper.clone()),
        "claims.toml" => Some(proposal.claims.clone()),
        _ => None,
    });
    let Ok(paper) = read else { return vec![] };
    let verifier = Verifier::new().with_budget(READING_WORK);
    let claims = paper.parts().claims.iter();
    claims
        .filter_map(|claim| {
            let error = verifier.claim(slug, claim).err()?;
            Some((claim.entry.id.get_ref().clone(), error.to_string()))
        })
        .collect()
}
