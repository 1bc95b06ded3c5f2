//! Compares a function with the printed side of a claim.

mod comparison;
mod edits;
mod question;
mod render;

pub use comparison::{CodeEdit, CodeVerdict, Comparison, PrintEdit};
pub use question::{CodeQuestion, PrintedSide};

use crate::grammar::Read;
use crate::program::{CodeLanguage, Function, Program, refused};
use crate::run::{self, Obligation, setting::Setting};
use crate::{python, rust};
use question::Asked;
use std::sync::Arc;
use torse_numbers::{stack, work};
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::derivation::{Claim, DerivationError, Hypothesis, Provenance, Source, Written};
use torse_syntax::formula::{Expr, Node, Place, Relation};
use torse_syntax::notation;
use torse_syntax::taxonomy::{Kind, Verdict};
use torse_verdicts::engine::decide_claim_within;
use torse_verdicts::outcome::Outcome;
use torse_verdicts::repair::one_side::edit_right_side;

/// Compares a function with the printed side of a claim of the paper with this id, with a budget of work in the units of
/// [`work`].
///
/// # Errors
/// A [`DerivationError`] for code that cannot be read, a name that stands for nothing of the claim, or a claim that states no equation.
pub fn compare(
    budget: u64,
    paper: &str,
    claim: &Claim,
    question: &CodeQuestion,
) -> Result<Comparison, Box<DerivationError>> {
    stack::deep(|| compared(budget, paper, claim, question))
}

fn compared(budget: u64, paper: &str, claim: &Claim, question: &CodeQuestion) -> Read<Comparison> {
    let source = Arc::new(Source::new(&question.file, &question.text));
    let program = program(&source)?;
    let function = function(&program, &question.function)?;
    let mut asked = Asked::new(claim, question)?;
    let setting = Setting {
        declarations: &claim.declarations,
        fixed: &asked.fixed,
        given: &asked.given,
    };
    let computed = run::formula(&program, function, setting)?;
    let code = computed.formula;
    let demanded = computed.demands.iter().map(|demand| Hypothesis {
        formula: Written {
            expr: demand.clone(),
            origin: asked.origin.clone(),
        },
        provenance: Provenance::Stated,
    });
    let demanded: Vec<Hypothesis> = demanded.collect();
    asked.hypotheses.extend(demanded);
    for dummy in &computed.dummies {
        let kind = SymbolKind::Real(Box::default());
        asked.declarations = Arc::new(asked.declarations.with_symbol(dummy, kind));
    }
    real(budget, paper, &asked, &source, &computed.obligations)?;
    // What is wrong about the formula of the code is shown where the code is.
    let outcome = decided(budget, paper, &asked, &code, &asked.printed).map_err(|error| {
        // Indices of sums are numbered behind this sign.
        let mut said = String::new();
        for (position, part) in error.to_string().split('°').enumerate() {
            let digits = |c: char| position > 0 && c.is_ascii_digit();
            said.push_str(part.trim_start_matches(digits));
        }
        let message = format!("the formula of `{}` has no meaning: {said}", function.name);
        let help = format!("it was read as {}", notation::text(&code));
        refused(&source, function.place, message, help)
    })?;
    let mut verdict = CodeVerdict::new(&outcome);
    let mut reason = comparison::reason(&outcome);
    let mut witness = outcome.witness().cloned();
    let mut difference = outcome.difference().map(|formula| formula.text.clone());
    if let (CodeVerdict::Different, Some(place)) = (verdict, computed.unread_demand) {
        // There the function may have no value.
        let line = comparison::line(&source.text, place.start).0;
        reason = Some(format!(
            "they differ at a point that the assertion in line {line} may exclude, and it is not read"
        ));
        (verdict, witness, difference) = (CodeVerdict::Undecided, None, None);
    }
    let mut comparison = Comparison {
        claim: claim.entry.id.get_ref().clone(),
        at: claim.entry.at.clone(),
        file: question.file.clone(),
        function: question.function.clone(),
        language: program.language,
        line: comparison::line(&source.text, function.place.start).0,
        code: notation::text(&code),
        print: notation::text(&asked.printed),
        verdict,
        conditions: outcome
            .conditions()
            .iter()
            .map(|c| c.text.clone())
            .collect(),
        asserted: computed.demands.iter().map(notation::text).collect(),
        reason,
        witness,
        difference,
        equals_other_side: false,
        code_edit: None,
        print_edit: None,
        ended_early: false,
        outcome,
    };
    if verdict == CodeVerdict::Different {
        let other = decided(budget, paper, &asked, &code, &asked.other)?;
        comparison.equals_other_side = other.verdict() == Verdict::Holds;
        let equation = asked.claim(&code, &asked.printed);
        let statement = &equation.statement;
        if let Some(statement) = statement {
            correct(
                &mut comparison,
                budget,
                (&equation, statement),
                (&program, function),
                setting,
                &computed.obligations,
            );
        }
    }
    Ok(comparison)
}

/// Fails unless it is shown that roots and logarithms of the program are real wherever it has a value: elsewhere the program has complex
/// values, and formulas none.
fn real(
    budget: u64,
    paper: &str,
    asked: &Asked<'_>,
    source: &Arc<Source>,
    obligations: &[Obligation],
) -> Read<()> {
    for Obligation { condition, place } in obligations {
        let claim = asked.stating(condition.clone());
        let is_shown = decide_claim_within(budget / 5, paper, &claim)
            .is_ok_and(|outcome| outcome.verdict() == Verdict::Holds);
        if !is_shown {
            let condition = notation::text(condition);
            let message = format!("this is a complex number in Python unless {condition}");
            let help = format!(
                "say where it is real, `--where '{condition}'`, or use a function that has real values alone: `math.sqrt`"
            );
            return Err(refused(source, *place, message, help));
        }
    }
    Ok(())
}

/// Searches the one change of the code, and that of the print.
fn correct(
    comparison: &mut Comparison,
    budget: u64,
    (claim, statement): (&Claim, &Written),
    (program, function): (&Program, &Function),
    setting: Setting<'_>,
    shown_before: &[Obligation],
) {
    let of_code = work::within(budget / 5, || {
        edits::search(claim, statement, program, function, setting, shown_before)
    });
    let of_print = work::within(budget / 5, || edit_right_side(claim, statement));
    match of_code {
        Ok((found, ended_early)) => {
            comparison.ended_early |= ended_early;
            comparison.code_edit = found;
        }
        Err(_) => comparison.ended_early = true,
    }
    match of_print {
        Ok(search) => {
            comparison.ended_early |= search.ended_early;
            comparison.print_edit = search.found.map(|found| PrintEdit {
                change: found.change,
                print: notation::text(&found.side),
                is_unique: found.is_unique,
            });
        }
        Err(_) => comparison.ended_early = true,
    }
}

/// Decides whether the code is equal to a side of the claim.
fn decided(budget: u64, paper: &str, asked: &Asked<'_>, code: &Expr, side: &Expr) -> Read<Outcome> {
    decide_claim_within(budget, paper, &asked.claim(code, side))
}

impl Asked<'_> {
    /// The claim that the code equals a side, under the hypotheses of the claim and of the question.
    fn claim(&self, code: &Expr, side: &Expr) -> Claim {
        let rest = vec![(Relation::Equal, side.clone())];
        self.stating(Expr {
            node: Node::Compare(Arc::new(code.clone()), rest),
            place: side.place,
        })
    }

    /// The claim that a formula holds, under the same hypotheses.
    fn stating(&self, expr: Expr) -> Claim {
        let mut claim = self.claim.clone();
        claim.declarations = Arc::clone(&self.declarations);
        claim.statement = Some(Written {
            expr,
            origin: self.origin.clone(),
        });
        claim.assumptions.extend(self.hypotheses.iter().cloned());
        // A kind of which no correction is searched: here there are two sides to correct.
        claim.entry.kind = Kind::Property;
        claim.entry.expect = None;
        claim.author_note = None;
        claim.figure = None;
        claim
    }
}

fn program(source: &Arc<Source>) -> Read<Program> {
    match CodeLanguage::from_name(&source.name) {
        Some(CodeLanguage::Python) => python::program(source),
        Some(CodeLanguage::Rust) => rust::program(source),
        None => {
            let message = "the language of this file is not read";
            let help = "files of Python (`.py`) and of Rust (`.rs`) are read";
            Err(refused(source, Place::default(), message, help))
        }
    }
}

fn function<'p>(program: &'p Program, name: &str) -> Read<&'p Function> {
    program.function(name).ok_or_else(|| {
        let message = format!("this file has no function `{name}`");
        let names: Vec<&str> = program.functions.iter().map(|f| f.name.as_str()).collect();
        let help = match names.as_slice() {
            [] => "functions at the top level of a file are compared".to_owned(),
            some => format!("it has {}", some.join(", ")),
        };
        refused(&program.source, Place::default(), message, help)
    })
}
