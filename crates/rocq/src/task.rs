//! Derives from the verdict of a claim what is to be proved.

use crate::gap::Untranslatable;
use crate::name::identifier;
use crate::proposition::Proposition;
use crate::solutions::Solved;
use crate::statement::proposition;
use crate::tree;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use torse_certificate::Evidence;
use torse_core::{BuiltIn, Node, Set, Statement, Term};
use torse_elaborate::Elaborator;
use torse_syntax::derivation::{self, Origin, Source, Written};
use torse_syntax::fault::Fault;
use torse_syntax::formula::{Expr, parse};
use torse_syntax::taxonomy::Verdict;

/// A claim with its verdict, of which a theorem is to be proved: plain data of an outcome.
#[derive(Debug, Clone)]
pub struct ProofTask<'a> {
    /// The id; for a reading, with its name after a point.
    pub id: String,
    /// The claim.
    pub claim: &'a derivation::Claim,
    /// The verdict.
    pub verdict: Verdict,
    /// Its evidence.
    pub evidence: Option<Evidence>,
    /// The conditions of the verdict, as formulas.
    pub conditions: Vec<String>,
    /// The corrected statement and its conditions.
    pub correction: Option<(String, Vec<String>)>,
    /// A point at which the statement fails: names and exact values.
    pub witness: Vec<(String, String)>,
    /// The values that `given` equations determine.
    pub solved: Vec<Solved>,
}

/// What a theorem says about a statement.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Role {
    /// The statement is true.
    Holds,
    /// The statement is false.
    Refuted,
    /// The corrected statement is true.
    Corrected,
}

/// A theorem to be proved.
#[derive(Debug, Clone)]
pub struct Goal {
    /// The name of its module.
    pub module: String,
    /// The id of the claim.
    pub id: String,
    /// Its place in the paper.
    pub at: String,
    /// The print, and our reading of it.
    pub printed: String,
    /// The statement in the notation of the derivation files.
    pub states: String,
    /// What the theorem says about it.
    pub role: Role,
    /// The evidence of the verdict.
    pub evidence: Evidence,
    /// The statement from core terms, as it is proved.
    pub proposition: Proposition,
    /// The printed statement, from the tree, or why there is none.
    pub printed_proposition: Result<Proposition, Untranslatable>,
    /// The declared symbols of the claim.
    pub symbols: BTreeMap<Arc<str>, Set>,
    /// A point at which a refuted statement fails.
    pub witness: Vec<(String, String)>,
    /// How many equations determine unknowns.
    pub given: usize,
    /// Their values, as the proof of the verdict has them.
    pub solved: Vec<Solved>,
}

impl Goal {
    /// Returns the same goal with the printed statement.
    ///
    /// # Errors
    /// The reason if there is none.
    pub fn as_printed(&self) -> Result<Self, Untranslatable> {
        Ok(Self {
            proposition: self.printed_proposition.clone()?,
            ..self.clone()
        })
    }

    /// Returns the texts of its definitions, in order.
    #[must_use]
    pub fn definitions(&self) -> Vec<&str> {
        let definitions = self.proposition.definitions.iter();
        definitions.map(|(_, text)| text.as_str()).collect()
    }
}

/// Returns the theorems of a claim, or why there are none.
///
/// # Errors
/// [`Untranslatable`], the first that is met.
pub fn goals(task: &ProofTask<'_>) -> Result<Vec<Goal>, Untranslatable> {
    let verdict = task.verdict;
    let nothing = |word| Err(Untranslatable::NothingToProve(word));
    let (role, conditions) = match verdict {
        Verdict::Holds | Verdict::Conditional => (Role::Holds, task.conditions.as_slice()),
        Verdict::Definition if task.evidence.is_some() => (Role::Holds, task.conditions.as_slice()),
        Verdict::False | Verdict::Misprint => (Role::Refuted, &[][..]),
        Verdict::Definition => return nothing("definition"),
        Verdict::Depends => return nothing("depends"),
        Verdict::Undecided => return nothing("undecided"),
        Verdict::Vacuous => return Err(Untranslatable::Theory("contradictions of hypotheses")),
        Verdict::Underspecified => return nothing("underspecified"),
        Verdict::OutOfScope => return nothing("out-of-scope"),
        Verdict::Reproduced | Verdict::Partial => return nothing("a figure"),
    };
    let Some(statement) = &task.claim.statement else {
        return nothing("no statement");
    };
    let evidence = task.evidence.unwrap_or(Evidence::CheckedRange);
    let mut goals = vec![goal(task, statement, role, evidence, conditions)?];
    if let Some((corrected, conditions)) = &task.correction {
        let statement = written(corrected, &task.id)?;
        goals.push(goal(
            task,
            &statement,
            Role::Corrected,
            Evidence::Identity,
            conditions,
        )?);
    }
    Ok(goals)
}

fn goal(
    task: &ProofTask<'_>,
    statement: &Written,
    role: Role,
    evidence: Evidence,
    conditions: &[String],
) -> Result<Goal, Untranslatable> {
    let claim = task.claim;
    let elaborator = Elaborator::new(&claim.declarations);
    let unread = |fault: &Fault| Untranslatable::Unread(fault.problem.to_string());
    let core = elaborator.claim(claim, statement).map_err(|f| unread(&f))?;
    let rooted = core.rooted(&statement.origin).map_err(|f| unread(&f))?;
    let hypotheses = core.hypotheses.iter().map(|h| &h.statement);
    let mut terms = hypotheses
        .chain([&core.statement])
        .flat_map(Statement::terms);
    // By SEMANTICS.md a root has no derivative where its radicand is zero; in Rocq it may have one.
    if rooted.roots().next().is_some() && terms.any(differentiates_roots) {
        return Err(Untranslatable::Theory(
            "derivatives of roots of formulas with symbols",
        ));
    }
    let mut added = vec![];
    for text in conditions {
        let written = written(text, &task.id)?;
        added.push(
            elaborator
                .statement(&written.expr)
                .map_err(|f| unread(&f))?,
        );
    }
    let proposition = proposition(&core, &added)?;
    // That a form is linear follows from its coefficients being equal to something without the symbol; a refutation
    // would have to show it separately if it is not plain.
    if proposition.unclear_forms && role == Role::Refuted {
        return Err(Untranslatable::Theory(
            "refutations of coefficients of forms that are not plainly linear",
        ));
    }
    let conditions = conditions.iter().map(|text| written(text, &task.id));
    let conditions: Vec<Expr> = conditions
        .map(|condition| Ok(condition?.expr))
        .collect::<Result<_, Untranslatable>>()?;
    let printed_proposition = tree::sentence(claim, &statement.expr, &conditions);
    let short = task
        .id
        .split_once('/')
        .map_or(task.id.as_str(), |(_, short)| short);
    let suffix = if role == Role::Corrected {
        "_corrected"
    } else {
        ""
    };
    let reading = claim.entry.reading.as_ref();
    Ok(Goal {
        module: identifier(&format!("{}{suffix}", short.replace(['.', '-'], "_"))),
        id: task.id.clone(),
        at: claim.entry.at.clone(),
        printed: match reading {
            Some(reading) => format!("{}\n   read as: {reading}", claim.entry.printed),
            None => claim.entry.printed.clone(),
        },
        states: torse_syntax::notation::text(&statement.expr),
        role,
        evidence,
        proposition,
        printed_proposition,
        symbols: core.symbols.clone(),
        witness: task.witness.clone(),
        given: core.unknowns.len(),
        solved: task.solved.clone(),
    })
}

/// Whether a root occurs below a derivative.
fn differentiates_roots(term: &Term) -> bool {
    let mut seen = BTreeSet::new();
    let mut pending = vec![term];
    while let Some(term) = pending.pop() {
        if !seen.insert(Arc::as_ptr(&term.node).addr()) {
            continue;
        }
        let roots = || term.applies(BuiltIn::SquareRoot) || term.applies(BuiltIn::Norm);
        if matches!(&*term.node, Node::Derivative { .. }) && roots() {
            return true;
        }
        pending.extend(term.parts());
    }
    false
}

/// Reads back a formula of an outcome.
fn written(text: &str, name: &str) -> Result<Written, Untranslatable> {
    let expr = parse(text).map_err(|_| Untranslatable::Unread(text.to_owned()))?;
    let source = Source::new(name, text);
    let origin = Origin::range(&Arc::new(source), 0, text.len());
    Ok(Written { expr, origin })
}
