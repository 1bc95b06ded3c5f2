//! Claims as propositions: all symbols are bound; then come as premises their declared sets, the hypotheses, the
//! definedness of all terms and the conditions of the verdict; then the conclusion.

use crate::binder::Binder;
use crate::code::Code;
use crate::context::Context;
use crate::domain::{binders, domain};
use crate::gap::Untranslatable;
use crate::implicit_derivative::functions;
use crate::proposition::Proposition;
use crate::translation::{defined, translate_statement};
use torse_core::{Claim, Node, Statement, Term};

/// Writes the proposition of a claim under conditions.
///
/// # Errors
/// [`Untranslatable`] for what has no translation.
pub fn proposition(claim: &Claim, conditions: &[Statement]) -> Result<Proposition, Untranslatable> {
    let mut context = Context::new(&claim.symbols).with_unknowns(&claim.unknowns);
    let mut binders = binders(&mut context)?;
    let mut premises = domain(&context)?;
    for hypothesis in &claim.hypotheses {
        premises.extend(defined(&mut context, [&hypothesis.statement])?);
        premises.push(translate_statement(
            &mut context,
            &hypothesis.statement,
            claim,
        )?);
    }
    premises.extend(defined(&mut context, [&claim.statement])?);
    for condition in conditions {
        premises.extend(defined(&mut context, [condition])?);
        premises.push(translate_statement(&mut context, condition, claim)?);
    }
    let mut kept: Vec<Code> = vec![];
    for premise in premises {
        // Drops `forall .., P` if `P` is already a premise.
        let follows = |known: &Code| premise.text().ends_with(&format!(" -> {}", known.text()));
        if !kept.contains(&premise) && !kept.iter().any(follows) {
            kept.push(premise);
        }
    }
    let conclusion = translate_statement(&mut context, &claim.statement, claim)?;
    let functions = functions(&mut context, claim)?;
    binders.extend(functions.binders);
    kept.extend(functions.premises);
    for premise in kept.iter().chain([&conclusion]) {
        context.spend(premise.text().len())?;
    }
    let mut unknowns = vec![];
    for unknown in &claim.unknowns {
        unknowns.extend(numbers_of(&mut context, unknown, &binders)?);
    }
    let definitions = context.definitions().to_vec();
    Ok(Proposition {
        unclear_forms: context.unclear_forms(false),
        alongs: context.alongs().to_vec(),
        definitions,
        binders,
        premises: kept,
        conclusion,
        unknowns,
    })
}

/// Returns the numbers that an unknown consists of, coordinate by coordinate.
fn numbers_of(
    context: &mut Context<'_>,
    unknown: &Term,
    binders: &[Binder],
) -> Result<Vec<String>, Untranslatable> {
    let (name, indices) = match &*unknown.node {
        Node::Vector(name, Some(_)) => (name, vec![]),
        Node::Member(points, indices) if points.dimension.is_some_and(|n| n > 1) => {
            let indices = indices.iter().map(|index| context.index(index));
            (&points.name, indices.collect::<Result<Vec<_>, _>>()?)
        }
        _ => return Ok(vec![context.value(unknown)?.code.argument()]),
    };
    let binder = binders.iter().find(|binder| binder.symbol == *name);
    let names = binder.map_or(&[][..], |binder| binder.names.as_slice());
    Ok(names
        .iter()
        .map(|name| Code::apply(name, &indices).argument())
        .collect())
}
